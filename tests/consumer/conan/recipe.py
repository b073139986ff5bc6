"""Runs Conan's recipe without Conan: its methods in Conan's order, on stand-ins that do what they say.

    recipe.py SOURCE FOLDER VERSION GENERATOR COMPILER

FOLDER gets export/, build/ and package/, and package_info.cmake: what package_info says, for the project beside.
"""

import importlib.util
import re
import shutil
import subprocess
import sys
import types
from pathlib import Path

sys.dont_write_bytecode = True
source, folder = Path(sys.argv[1]), Path(sys.argv[2])
version, generator, compiler = sys.argv[3:]


def check(holds, what):
    if not holds:
        sys.exit(f"error: {what}")


class Setting(str):
    """A setting is a word with settings of its own: compiler, compiler.version."""


def settings(os="Linux", compiler="gcc", version="12", cppstd="20"):
    of_compiler = Setting(compiler)
    of_compiler.version, of_compiler.cppstd = version, cppstd
    return types.SimpleNamespace(os=os, arch="x86_64", compiler=of_compiler, build_type="Release")


class Info:
    cleared = False

    def clear(self):
        self.cleared = True


class CppInfo:
    def __init__(self):
        self.properties = {}
        self.includedirs, self.libdirs, self.bindirs = ["include"], ["lib"], ["bin"]
        self.requires, self.system_libs, self.defines, self.libs = [], [], [], []

    def set_property(self, name, value):
        self.properties[name] = value


class ConanFile:
    def __init__(self, recipe):
        self.recipe_folder = str(recipe.parent)
        self.export_sources_folder = self.source_folder = str(folder / "export")
        self.build_folder, self.package_folder = str(folder / "build"), str(folder / "package")
        self.settings, self.info, self.cpp_info = settings(), Info(), CppInfo()
        self.required, self.has_dependencies = {}, False

    def requires(self, reference):
        name, _, wanted = reference.partition("/")
        self.required[name] = wanted


class ConanInvalidConfiguration(Exception):
    pass


class Version:
    def __init__(self, text):
        self.numbers = [int(n) for n in str(text).split(".")]

    def __lt__(self, other):
        return self.numbers < Version(other).numbers


def check_min_cppstd(conanfile, oldest):
    if int(conanfile.settings.compiler.cppstd) < oldest:
        raise ConanInvalidConfiguration(f"C++{oldest}")


def copy(conanfile, pattern, src, dst):
    for file in Path(src).rglob("*"):
        name = file.relative_to(src)
        # as fnmatch has it, '*' goes through folders
        if file.is_file() and re.fullmatch(re.escape(pattern).replace(r"\*", ".*"), str(name)):
            (Path(dst) / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(file, Path(dst) / name)


class CMakeToolchain:
    def __init__(self, conanfile):
        self.conanfile, self.cache_variables = conanfile, {}

    def generate(self):
        self.conanfile.cache_variables = self.cache_variables


class CMakeDeps:
    def __init__(self, conanfile):
        conanfile.has_dependencies = True

    def generate(self):
        pass


class CMake:
    def __init__(self, conanfile):
        self.conanfile = conanfile

    def configure(self):
        c = self.conanfile
        definitions = [f"-D{name}={value}" for name, value in c.cache_variables.items()]
        subprocess.run(
            ["cmake", "-G", generator, "-S", c.source_folder, "-B", c.build_folder, f"-DCMAKE_CXX_COMPILER={compiler}"]
            + definitions,
            check=True,
        )

    def install(self, component):
        c = self.conanfile
        command = ["cmake", "--install", c.build_folder, "--prefix", c.package_folder, "--component", component]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def stand_in(name, **members):
    module = types.ModuleType(name)
    vars(module).update(members)
    sys.modules[name] = module


stand_in("conan", ConanFile=ConanFile)
stand_in("conan.errors", ConanInvalidConfiguration=ConanInvalidConfiguration)
stand_in("conan.tools")
stand_in("conan.tools.build", check_min_cppstd=check_min_cppstd)
stand_in(
    "conan.tools.cmake",
    CMake=CMake, CMakeDeps=CMakeDeps, CMakeToolchain=CMakeToolchain, cmake_layout=lambda conanfile: None,
)
stand_in(
    "conan.tools.files",
    copy=copy,
    load=lambda conanfile, path: Path(path).read_text(),
    rmdir=lambda conanfile, path: shutil.rmtree(path, ignore_errors=True),
)
stand_in("conan.tools.scm", Version=Version)

path = source / "scripts/packaging/conan/conanfile.py"
spec = importlib.util.spec_from_file_location("conanfile", path)
module = importlib.util.module_from_spec(spec)
spec.loader.exec_module(module)
recipes = [c for c in vars(module).values() if isinstance(c, type) and issubclass(c, ConanFile) and c is not ConanFile]
check(len(recipes) == 1, f"{path} has {len(recipes)} recipes")
recipe = recipes[0](path)
for attribute in ("name", "license", "description", "settings"):
    check(getattr(recipe, attribute, None), f"the recipe has no {attribute}")
check(recipe.package_type == "header-library", f"package_type is {recipe.package_type}")

recipe.set_version()
check(recipe.version == version, f"the recipe's version is {recipe.version}, that of version.hpp {version}")

recipe.export_sources()
headers = {str(h.relative_to(source)) for h in (source / "include").rglob("*.hpp")}
exported = {str(f.relative_to(folder / "export")) for f in (folder / "export").rglob("*") if f.is_file()}
check(exported == headers | {"CMakeLists.txt", "LICENSE"}, f"exported: {sorted(exported ^ headers)}")

recipe.requirements()
lists = (source / "CMakeLists.txt").read_text()
oldest = {
    "eigen": re.search(r"Eigen3_VERSION VERSION_LESS ([0-9.]+)", lists)[1],
    "boost": re.search(r"find_package\(Boost ([0-9.]+)", lists)[1],
}
check(recipe.required.keys() == oldest.keys(), f"required: {recipe.required}")
for name, wanted in recipe.required.items():
    check(re.match(rf"\[>={re.escape(oldest[name])}(\.0)? ", wanted), f"{name} {wanted}: CMake asks for {oldest[name]}")

for good in ({}, {"compiler": "clang", "version": "14"}, {"os": "Macos", "compiler": "apple-clang", "version": "15"}):
    recipe.settings = settings(**good)
    recipe.validate()
for bad in ({"version": "11"}, {"compiler": "clang", "version": "13"}, {"cppstd": "17"}, {"compiler": "msvc", "version": "193"}):
    recipe.settings = settings(**bad)
    try:
        recipe.validate()
    except ConanInvalidConfiguration:
        continue
    check(False, f"{bad} must be refused")
recipe.settings = settings()

recipe.layout()
recipe.generate()
check(recipe.has_dependencies, "without CMakeDeps CMake does not find what Conan has")
recipe.build()
recipe.package()
package = folder / "package"
packaged = {str(f.relative_to(package)) for f in package.rglob("*") if f.is_file()}
check(packaged == headers | {"licenses/LICENSE"}, f"packaged: {sorted(packaged ^ headers)}")
recipe.package_id()
check(recipe.info.cleared, "headers are the same package for all settings")

recipe.package_info()
info = recipe.cpp_info
names = {"cmake_file_name": "equilibria", "cmake_target_name": "equilibria::equilibria", "pkg_config_name": "equilibria"}
check(info.properties == names, f"names: {info.properties}")
for folders in (info.includedirs, info.libdirs, info.bindirs):
    for name in folders:
        check((package / name).is_dir(), f"package_info names the folder {name}, which the package has not")
check({r.split("::")[0] for r in info.requires} == recipe.required.keys(), f"package_info requires {info.requires}")
check(not info.libs and not info.defines, f"libraries {info.libs}, definitions {info.defines} of headers alone")
(folder / "package_info.cmake").write_text(
    f"set(includes {' '.join(str(package / name) for name in info.includedirs)})\n"
    f"set(requires {' '.join(info.requires)})\nset(system_libraries {' '.join(info.system_libs)})\n"
)
