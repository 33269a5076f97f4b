# SPDX-License-Identifier: MIT
"""Builds the checkout that contains it: conan create packaging/conan --build=missing"""

import os
import re

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load
from conan.tools.gnu import PkgConfigDeps
from conan.tools.system.package_manager import Apt

required_conan_version = ">=2.0"


class OsgTreeWind(ConanFile):
    name = "osgtreewind"
    description = "Forests in a given wind field, for OpenSceneGraph"
    license = "MIT"
    topics = ("openscenegraph", "trees", "wind", "simulation")
    package_type = "shared-library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"matlab": [True, False], "tool": [True, False]}
    default_options = {"matlab": False, "tool": False, "openscenegraph/*:shared": True}

    @property
    def _root(self):
        return os.path.join(self.recipe_folder, "..", "..")

    def set_version(self):
        text = load(self, os.path.join(self._root, "CMakeLists.txt"))
        self.version = re.search(r"project\(osgTreeWind VERSION ([0-9.]+)", text).group(1)

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "README.md", "CHANGELOG.md", "cmake/*", "docs/*", "examples/*",
                        "osgTreeWind/*", "plugins/*", "script/*", "shaders/*"):
            copy(self, pattern, src=self._root, dst=self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def validate(self):
        if self.settings.os != "Linux":
            raise ConanInvalidConfiguration("osgTreeWind supports only Linux")

    def requirements(self):
        self.requires("openscenegraph/3.6.5", transitive_headers=True, transitive_libs=True)
        self.requires("glm/0.9.9.8", transitive_headers=True)
        self.requires("date/[>=3.0 <4]", options={"header_only": True})
        self.requires("eccodes/[>=2.28 <3]")
        self.requires("eigen/3.4.0")
        self.requires("gdal/[>=3.4 <4]")
        self.requires("pugixml/[>=1.12 <2]")
        self.requires("sqlite3/[>=3.38 <4]")
        self.requires("tomlplusplus/[>=3.3 <4]")
        self.requires("utf8proc/[>=2.8 <3]")
        self.requires("zlib/[>=1.2.11 <2]")
        if self.options.matlab:
            self.requires("matio/[>=1.5.23 <2]")
        if self.options.tool:
            self.requires("cairo/[>=1.16 <2]")
            self.requires("cli11/[>=2.3 <3]")
            self.requires("netcdf/4.8.1")
            self.requires("nlohmann_json/[>=3.7 <4]")

    def system_requirements(self):
        Apt(self).install(["libcsv-dev", "libudunits2-dev"])  # Conan has no packages for them

    def generate(self):
        CMakeDeps(self).generate()
        PkgConfigDeps(self).generate()
        toolchain = CMakeToolchain(self)
        for option in ("BENCHMARKS", "EXAMPLES", "TESTS"):
            toolchain.cache_variables[f"OSGTREEWIND_BUILD_{option}"] = False
        toolchain.cache_variables["OSGTREEWIND_BUILD_TOOL"] = bool(self.options.tool)
        toolchain.cache_variables["OSGTREEWIND_MATIO"] = "ON" if self.options.matlab else "OFF"
        toolchain.cache_variables["CMAKE_INSTALL_LIBDIR"] = "lib"
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", src=self.source_folder, dst=os.path.join(self.package_folder, "licenses"))

    def package_info(self):
        self.cpp_info.libs = ["osgTreeWind"]
        self.cpp_info.set_property("cmake_find_mode", "none")  # the package has its own osgTreeWindConfig.cmake
        self.cpp_info.builddirs.append(os.path.join("lib", "cmake", "osgTreeWind"))
        self.runenv_info.append_path("OSG_LIBRARY_PATH", os.path.join(self.package_folder, "lib"))
