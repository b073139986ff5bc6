"""Builds the Python package's compiled part with CMake; everything else is said in pyproject.toml.

It is built for this machine's processor, whose lanes the tracker uses. EQUILIBRIA_NATIVE=0 in the environment
builds it for any processor of the architecture; loci take 1.6 times as long then.
"""

import os
import re
import runpy
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

root = Path(__file__).resolve().parent


class Build(build_ext):
    def build_extension(self, extension):
        native = os.environ.get("EQUILIBRIA_NATIVE", "1") not in ("", "0", "OFF")
        build = root / "build" / f"wheel-{sys.implementation.cache_tag}{'-native' if native else ''}"
        made = Path(self.get_ext_fullpath(extension.name)).resolve()
        subprocess.run(
            [
                "cmake",
                "-S",
                root,
                "-B",
                build,
                "-DCMAKE_BUILD_TYPE=Release",
                "-DEQUILIBRIA_PYTHON=ON",
                f"-DPython_EXECUTABLE={sys.executable}",
                f"-DEQUILIBRIA_NATIVE={'ON' if native else 'OFF'}",
                *(f"-DEQUILIBRIA_{part}=OFF" for part in ("BUILD_TESTS", "BUILD_EXAMPLES", "BUILD_BENCH", "INSTALL")),
            ],
            check=True,
        )
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count() or 1)
        subprocess.run(["cmake", "--build", build, "--target", "equilibria_python", "--parallel", jobs], check=True)
        made.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(next((build / "python" / "equilibria").glob("_core*.so")), made)
        if native:
            present = runpy.run_path(str(root / "python/equilibria/processor.py"))["present"]()
            (made.parent / "_built_for.py").write_text(f"instructions = {tuple(sorted(present or ()))}\n")


header = (root / "include/equilibria/version.hpp").read_text()
setup(
    version=".".join(re.findall(r"#define EQUILIBRIA_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", header)),
    ext_modules=[Extension("equilibria._core", sources=[])],
    cmdclass={"build_ext": Build},
)
