# The targets that the recipes of the IPC Toolkit would fetch, from Debian's packages libeigen3-dev,
# libspdlog-dev, libtbb-dev, libabsl-dev, nlohmann-json3-dev, and from source trees in the folder
# DEPENDENCIES, by the names of their repositories, at the versions that the recipes name. That matters for
# libigl, 2.6.0: later ones have other headers.

find_package(Eigen3 REQUIRED)
find_package(spdlog REQUIRED)
find_package(TBB REQUIRED)
find_package(absl REQUIRED)
find_package(nlohmann_json REQUIRED)
foreach(target IN ITEMS Eigen3::Eigen spdlog::spdlog TBB::tbb absl::hash nlohmann_json::nlohmann_json)
    set_target_properties(${target} PROPERTIES IMPORTED_GLOBAL TRUE)
endforeach()

# The toolkit includes a header of the fmt that is bundled with spdlog; Debian's fmt is in another place.
file(WRITE "${CMAKE_BINARY_DIR}/bundled/spdlog/fmt/bundled/ranges.h" "#include <fmt/ranges.h>\n")
include_directories(SYSTEM "${CMAKE_BINARY_DIR}/bundled")

# Libraries of headers only.
function(header_library name folder)
    add_library(${name} INTERFACE)
    target_include_directories(${name} SYSTEM INTERFACE "${DEPENDENCIES}/${folder}/include")
    target_link_libraries(${name} INTERFACE Eigen3::Eigen)
endfunction()
header_library(igl_core libigl)
header_library(xsimd xsimd)
header_library(TinyAD TinyAD)
header_library(robin_map robin-map)
add_library(igl::core ALIAS igl_core)
add_library(xsimd::xsimd ALIAS xsimd)
add_library(TinyAD::TinyAD ALIAS TinyAD)
add_library(tsl::robin_map ALIAS robin_map)

include(GenerateExportHeader)
add_library(predicates STATIC "${DEPENDENCIES}/libigl-predicates/predicates.c")
generate_export_header(predicates EXPORT_FILE_NAME "${CMAKE_BINARY_DIR}/predicates/predicates_export.h")
target_compile_definitions(predicates PUBLIC PREDICATES_STATIC_DEFINE)
target_include_directories(
    predicates PUBLIC "${DEPENDENCIES}/libigl-predicates" "${CMAKE_BINARY_DIR}/predicates")
add_library(igl_predicates INTERFACE)
target_link_libraries(igl_predicates INTERFACE igl_core predicates)
add_library(igl::predicates ALIAS igl_predicates)

set(FILIB_BUILD_SHARED_LIB OFF CACHE BOOL "Build shared library")
foreach(folder IN ITEMS filib Tight-Inclusion Scalable-CCD)
    add_subdirectory("${DEPENDENCIES}/${folder}" ${folder} EXCLUDE_FROM_ALL)
endforeach()

# Catch2 3, in one source.
add_library(Catch2 STATIC "${DEPENDENCIES}/Catch2/extras/catch_amalgamated.cpp")
file(WRITE "${CMAKE_BINARY_DIR}/catch2/catch2/catch_user_config.hpp" "")
target_compile_definitions(Catch2 PRIVATE CATCH_AMALGAMATED_CUSTOM_MAIN)
target_include_directories(
    Catch2 SYSTEM PUBLIC "${CMAKE_BINARY_DIR}/catch2" "${DEPENDENCIES}/Catch2/src" "${DEPENDENCIES}/Catch2/extras")
add_library(Catch2::Catch2 ALIAS Catch2)
