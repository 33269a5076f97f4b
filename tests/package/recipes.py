#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests the vcpkg port and the Conan recipe without these programs: they parse, have the version of the project and all its
dependencies, and configure with their options and sources.
Usage: recipes.py ROOT PREFIX LIBRARY_FOLDER"""

import fnmatch
import importlib.util
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import types

root, prefix, libraries = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
version = re.search(r"project\(osgTreeWind VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text()).group(1)
# Package names for the arguments of find_package() and pkg_check_modules().
vcpkg_names = {"OpenSceneGraph": "osg", "Eigen3": "eigen3", "LibCsv": "libcsv", "GDAL": "gdal", "Matio": "matio", "ZLIB": "zlib",
               "SQLite3": "sqlite3", "CLI11": "cli11", "nlohmann_json": "nlohmann-json", "netcdf": "netcdf-c"}
conan_names = {"OpenSceneGraph": "openscenegraph", "udunits": "libudunits2-dev", "Eigen3": "eigen", "LibCsv": "libcsv-dev", "GDAL": "gdal", "Matio": "matio",
               "ZLIB": "zlib", "SQLite3": "sqlite3", "CLI11": "cli11", "nlohmann_json": "nlohmann_json", "netcdf": "netcdf"}
system_packages = {"OpenGL", "PkgConfig", "OSMesa", "osgViewer"}  # optional, from the driver, or part of OpenSceneGraph


def find_dependencies():
    names = set()
    for folder in ("", "osgTreeWind", "osgTreeWind/offscreen", "plugins/treewind", "plugins/weather", "plugins/matlab", "examples/osgtreewind"):
        text = (root / folder / "CMakeLists.txt").read_text()
        names |= set(re.findall(r"^ *find_package\((\w+)", text, re.M)) | set(re.findall(r"pkg_check_modules\((\w+)", text))
    return names - system_packages


def expect(condition, message):
    if not condition:
        sys.exit(f"recipes: {message}")


def configure(source, folder, definitions):
    done = subprocess.run(["cmake", "-G", "Ninja", "-S", source, "-B", folder, *definitions], capture_output=True, text=True)
    expect(done.returncode == 0 and not done.stderr, done.stderr)


def check_vcpkg(work):
    port = root / "packaging/vcpkg/osgtreewind"
    manifest = json.loads((port / "vcpkg.json").read_text())
    expect(manifest["version"] == version, f"vcpkg.json: expected version {version}, found {manifest['version']}")
    listed = list(manifest["dependencies"])
    for feature in manifest["features"].values():
        listed += feature["dependencies"]
    listed = {one["name"] if isinstance(one, dict) else one for one in listed}
    for name in find_dependencies():
        expect(vcpkg_names.get(name, name) in listed, f"vcpkg.json: the dependency {name} is missing")
    for features in ("", "tool;matlab"):
        subprocess.run(["cmake", f"-DPORT={port}", f"-DFEATURES={features}", f"-DPREFIX={prefix}", f"-DLIBRARIES={libraries}",
                        f"-DWORK={work}/vcpkg{len(features)}", "-P", root / "tests/package/vcpkg.cmake"], check=True)


class MockConanFile:
    """The parts of Conan that the recipe uses."""

    def __init__(self, work):
        self.options = types.SimpleNamespace(tool=True, matlab=True)
        self.settings = types.SimpleNamespace(os="Linux")
        self.recipe_folder = str(root / "packaging/conan")
        self.export_sources_folder = work + "/sources"
        self.required = set()

    def requires(self, reference, **_):
        self.required.add(reference.split("/")[0])


def mock_conan_modules(packages):
    def copy(_, pattern, src, dst):
        found = 0
        for file in pathlib.Path(src).rglob("*"):
            path = file.relative_to(src)
            if file.is_file() and fnmatch.fnmatch(str(path), pattern):
                found += 1
                target = pathlib.Path(dst) / path
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(file, target)
        expect(found, f"no file matches {pattern}")

    class Toolchain:
        def __init__(self, conanfile):
            self.cache_variables = conanfile.definitions = {}

        def generate(self):
            pass

    generator = type("Generator", (), {"__init__": lambda self, _: None, "generate": lambda self: None})
    apt = type("Apt", (), {"__init__": lambda self, _: None, "install": lambda self, names: packages.update(names)})
    contents = {"conan": {"ConanFile": MockConanFile}, "conan.errors": {"ConanInvalidConfiguration": ValueError},
                "conan.tools": {}, "conan.tools.gnu": {"PkgConfigDeps": generator},
                "conan.tools.cmake": {"CMake": generator, "CMakeDeps": generator, "CMakeToolchain": Toolchain, "cmake_layout": None},
                "conan.tools.files": {"copy": copy, "load": lambda _, path: pathlib.Path(path).read_text()},
                "conan.tools.system": {}, "conan.tools.system.package_manager": {"Apt": apt}}
    for name, members in contents.items():
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(members)


def check_conan(work):
    packages = set()
    mock_conan_modules(packages)
    spec = importlib.util.spec_from_file_location("conanfile", root / "packaging/conan/conanfile.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    recipe = module.OsgTreeWind(work)
    recipe.set_version()
    expect(recipe.version == version, f"conanfile.py: expected version {version}, found {recipe.version}")
    recipe.validate()
    recipe.requirements()
    recipe.system_requirements()
    for name in find_dependencies():
        expect(conan_names.get(name, name) in recipe.required | packages, f"conanfile.py: the dependency {name} is missing")
    recipe.export_sources()
    recipe.generate()
    cmake_values = {True: "ON", False: "OFF"}
    configure(recipe.export_sources_folder, work + "/conan",
              ["-DCMAKE_BUILD_TYPE=Release"] + [f"-D{name}={cmake_values.get(value, value)}" for name, value in recipe.definitions.items()])


sys.dont_write_bytecode = True
with tempfile.TemporaryDirectory() as folder:
    check_vcpkg(folder)
    check_conan(folder)
