"""The libraries of exact-ccd for C and C++, as a package of Conan 2. Cargo has to be on the path."""

import os

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, get, rm, rmdir


class ExactCcd(ConanFile):
    name = "exact-ccd"
    version = "0.1.0"
    description = "Exact continuous collision detection of moving triangle meshes"
    license = "MIT OR Apache-2.0"
    homepage = "https://example.org/exact-ccd"
    url = "https://example.org/exact-ccd"
    topics = ("ccd", "collision", "exact", "geometry", "simulation")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False]}
    default_options = {"shared": False}

    def layout(self):
        cmake_layout(self, src_folder="src")

    def source(self):
        get(self, **self.conan_data["sources"][self.version], strip_root=True)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["BUILD_TESTING"] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure(build_script_folder="bindings/c")
        cmake.build()

    def package(self):
        copy(self, "LICENSE-*", self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()
        # Both libraries are built: the one that was not asked for goes.
        libraries = os.path.join(self.package_folder, "lib")
        if self.options.shared:
            rm(self, "libexact_ccd.a", libraries)
            rm(self, "exact_ccd.lib", libraries)
        else:
            for pattern in ["*.so*", "*.dylib", "*.dll.lib"]:
                rm(self, pattern, libraries)
            rmdir(self, os.path.join(self.package_folder, "bin"))
        rmdir(self, os.path.join(libraries, "cmake"))
        rmdir(self, os.path.join(libraries, "pkgconfig"))

    def package_info(self):
        is_dll = self.options.shared and self.settings.os == "Windows"
        self.cpp_info.libs = ["exact_ccd.dll" if is_dll else "exact_ccd"]
        self.cpp_info.set_property("cmake_file_name", "exact_ccd")
        self.cpp_info.set_property("cmake_target_name", "exact_ccd::exact_ccd")
        if self.options.shared:
            return
        if self.settings.os in ("Linux", "FreeBSD"):
            self.cpp_info.system_libs = ["pthread", "dl", "m"]
        elif self.settings.os == "Windows":
            self.cpp_info.system_libs = ["ws2_32", "userenv", "ntdll", "bcrypt"]
