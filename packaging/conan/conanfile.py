# SPDX-License-Identifier: LGPL-3.0-or-later
"""The headers, for Conan 2. From a clone: conan create packaging/conan"""

import re
from pathlib import Path

from conan import ConanFile
from conan.tools.files import copy, load


class CGALSphericalParameterization(ConanFile):
    name = "cgal-spherical-parameterization"
    description = "Certified spherical parameterizations of closed genus-0 triangle meshes"
    license = "LGPL-3.0-or-later"
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"with_tbb": [True, False]}
    default_options = {"with_tbb": True}
    no_copy_source = True

    def set_version(self):
        header = Path(self.recipe_folder, "../../include/CGAL/Spherical_parameterization/version.h")
        self.version = re.search(r'VERSION "(.*)"', load(self, str(header))).group(1)

    def export_sources(self):
        root = Path(self.recipe_folder, "../..").resolve()
        for pattern in ("include/*", "LICENSE*"):
            copy(self, pattern, root, self.export_sources_folder)

    def requirements(self):
        self.requires("cgal/5.6.1", transitive_headers=True)
        self.requires("eigen/3.4.0", transitive_headers=True)
        if self.options.with_tbb:
            self.requires("onetbb/2021.12.0", transitive_headers=True)

    def package(self):
        copy(self, "include/CGAL/*", self.source_folder, self.package_folder, excludes="*/preparation/*")
        copy(self, "LICENSE*", self.source_folder, Path(self.package_folder, "licenses"))

    def package_id(self):
        self.info.clear()

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "CGAL_Spherical_parameterization")
        self.cpp_info.set_property("cmake_target_name", "CGAL_Spherical_parameterization::CGAL_Spherical_parameterization")
        self.cpp_info.bindirs = self.cpp_info.libdirs = []
        if self.settings.get_safe("compiler") != "msvc":
            self.cpp_info.cxxflags = ["-ffp-contract=off"]
        if self.options.with_tbb:
            self.cpp_info.defines = ["CGAL_LINKED_WITH_TBB"]
