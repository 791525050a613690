# The library is written in Rust: cargo has to be on the path.
vcpkg_download_distfile(
    ARCHIVE
    URLS "https://example.org/exact-ccd/archive/refs/tags/v${VERSION}.tar.gz"
    FILENAME "exact-ccd-${VERSION}.tar.gz"
    SHA512 0)
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${ARCHIVE}")

vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}/bindings/c" OPTIONS -DBUILD_TESTING=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME exact_ccd CONFIG_PATH lib/cmake/exact_ccd)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE-MIT" "${SOURCE_PATH}/LICENSE-APACHE")
