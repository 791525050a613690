# Installs the library and compiles the first example against it: by pkg-config, shared and static, and
# as a CMake package.

set(prefix "${BUILD}/installed")
set(work "${BUILD}/installed-test")
file(REMOVE_RECURSE "${prefix}" "${work}")
file(MAKE_DIRECTORY "${work}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}"
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

file(GLOB_RECURSE pkg_config_file "${prefix}/*/exact_ccd.pc")
get_filename_component(pkg_config_path "${pkg_config_file}" DIRECTORY)
get_filename_component(libraries "${pkg_config_path}" DIRECTORY)
set(ENV{PKG_CONFIG_PATH} "${pkg_config_path}")
set(ENV{LD_LIBRARY_PATH} "${libraries}")

find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
    foreach(kind IN ITEMS shared static)
        set(flags --cflags --libs)
        if(kind STREQUAL static)
            list(APPEND flags --static)
        endif()
        execute_process(COMMAND "${PKG_CONFIG}" ${flags} "--define-variable=prefix=${prefix}" exact_ccd
                        OUTPUT_VARIABLE options OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
        if(kind STREQUAL static)
            string(REPLACE "-lexact_ccd" "-l:libexact_ccd.a" options "${options}")
        endif()
        separate_arguments(options UNIX_COMMAND "${options}")
        execute_process(COMMAND "${CC}" "${SOURCE}/examples/falling_vertex.c" -o "${work}/${kind}" ${options}
                        COMMAND_ERROR_IS_FATAL ANY)
        execute_process(COMMAND "${work}/${kind}" COMMAND_ERROR_IS_FATAL ANY)
    endforeach()
else()
    message(STATUS "pkg-config is missing: not tested")
endif()

file(WRITE "${work}/CMakeLists.txt" "
cmake_minimum_required(VERSION 3.21)
project(user LANGUAGES C)
find_package(exact_ccd REQUIRED)
add_executable(user ${SOURCE}/examples/falling_vertex.c)
target_link_libraries(user PRIVATE exact_ccd::exact_ccd)
")
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${work}" -B "${work}/build" "-DCMAKE_PREFIX_PATH=${prefix}"
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${work}/build" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${work}/build/user" COMMAND_ERROR_IS_FATAL ANY)
