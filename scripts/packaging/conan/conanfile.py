"""Conan's recipe of the headers, as `cmake --install` gives them, from the tree in which it stands:

    conan create scripts/packaging/conan --build=missing -s compiler.cppstd=20 -o "boost/*:header_only=True"

Of Boost it needs headers alone: without the option Conan may build the whole of it.
"""

import re
from pathlib import Path

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load, rmdir
from conan.tools.scm import Version

required_conan_version = ">=2.0"


class EquilibriaRecipe(ConanFile):
    name = "equilibria"
    description = "Every equilibrium of a mechanical system, proved, classified and traced"
    license = "MIT"
    topics = ("mechanics", "homotopy-continuation", "bifurcation", "header-only")
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"

    def _tree(self):
        return Path(self.recipe_folder).resolve().parents[2]

    def set_version(self):
        header = load(self, str(self._tree() / "include/equilibria/version.hpp"))
        self.version = ".".join(re.findall(r"#define EQUILIBRIA_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", header))

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "include/*.hpp"):
            copy(self, pattern, src=str(self._tree()), dst=self.export_sources_folder)

    def requirements(self):
        self.requires("eigen/[>=3.4.0 <6]")
        self.requires("boost/[>=1.74.0 <2]")

    def validate(self):
        check_min_cppstd(self, 20)
        oldest = {"gcc": "12", "clang": "14", "apple-clang": "14"}.get(str(self.settings.compiler))
        if oldest is None:
            raise ConanInvalidConfiguration("equilibria needs the vectors of g++ or clang++")
        if Version(self.settings.compiler.version) < oldest:
            raise ConanInvalidConfiguration(f"equilibria needs {self.settings.compiler} {oldest} or newer")

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        for part in ("BUILD_TESTS", "BUILD_EXAMPLES", "BUILD_COMPILED"):
            toolchain.cache_variables[f"EQUILIBRIA_{part}"] = "OFF"
        toolchain.generate()

    def build(self):
        CMake(self).configure()

    def package(self):
        CMake(self).install(component="development")
        copy(self, "LICENSE", src=self.source_folder, dst=str(Path(self.package_folder) / "licenses"))
        # what others read of a package Conan writes itself: these would find Eigen and Boost in the system
        for folder in ("lib", "share"):
            rmdir(self, str(Path(self.package_folder) / folder))

    def package_id(self):
        self.info.clear()

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "equilibria")
        self.cpp_info.set_property("cmake_target_name", "equilibria::equilibria")
        self.cpp_info.set_property("pkg_config_name", "equilibria")
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
        self.cpp_info.requires = ["eigen::eigen", "boost::headers"]
        if self.settings.os in ("Linux", "FreeBSD"):
            self.cpp_info.system_libs = ["pthread"]
