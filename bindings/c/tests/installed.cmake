# Installs the library, moves the installed tree, and compiles the program of docs/c.md against it: by
# pkg-config, shared and static, by the commands of that page, and as a CMake package. The prefix is not the
# configured one, and no option names it. And adds its folder to the project of another.

set(first "${BUILD}/installed first")
set(prefix "${BUILD}/installed and moved")
set(work "${BUILD}/installed-test")
file(REMOVE_RECURSE "${first}" "${prefix}" "${work}")
file(MAKE_DIRECTORY "${work}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${first}"
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME "${first}" "${prefix}")

# The first block of C is the program, the second one the contact of a mesh.
file(READ "${SOURCE}/../../docs/c.md" page)
if(NOT page MATCHES "```c\n([^`]*)```")
    message(FATAL_ERROR "docs/c.md has no program in C")
endif()
set(program "${CMAKE_MATCH_1}")
file(WRITE "${work}/program.c" "${program}")
string(FIND "${page}" "${program}" start)
string(SUBSTRING "${page}" ${start} -1 after)
if(NOT after MATCHES "```c\n([^`]*)```")
    message(FATAL_ERROR "docs/c.md has no second program in C")
endif()
file(WRITE "${work}/contact.c" "${CMAKE_MATCH_1}")
function(check_output output)
    if(NOT output STREQUAL "within 0 from t = 0.5 on\nwithin 0.25 from t = 0.375 on\n")
        message(FATAL_ERROR "the program of docs/c.md prints ${output}")
    endif()
endfunction()

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
        execute_process(COMMAND "${PKG_CONFIG}" ${flags} exact_ccd
                        OUTPUT_VARIABLE options OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
        if(kind STREQUAL static)
            string(REPLACE "-lexact_ccd" "-l:libexact_ccd.a" options "${options}")
        endif()
        separate_arguments(options UNIX_COMMAND "${options}")
        execute_process(COMMAND "${CC}" -Wall -Werror "${work}/program.c" -o "${work}/${kind}" ${options}
                        COMMAND_ERROR_IS_FATAL ANY)
        execute_process(COMMAND "${work}/${kind}" OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
        check_output("${output}")
        execute_process(COMMAND "${CC}" -Wall -Werror "${work}/contact.c" -o "${work}/contact" ${options}
                        COMMAND_ERROR_IS_FATAL ANY)
        execute_process(COMMAND "${work}/contact" OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
        if(NOT output STREQUAL "vertex 3 and face 0 at t = 0.5\n")
            message(FATAL_ERROR "the second program of docs/c.md prints ${output}")
        endif()
    endforeach()

    # The first commands after the program, which find the library by themselves. Unlike the folder, the link to it
    # has no space in its name: the shell would split it.
    file(RELATIVE_PATH subfolder "${prefix}" "${libraries}")
    if(CMAKE_HOST_UNIX AND subfolder STREQUAL "lib")
        if(NOT after MATCHES "```sh\n([^`]*)```")
            message(FATAL_ERROR "docs/c.md does not say how its program is compiled")
        endif()
        set(commands "${CMAKE_MATCH_1}")
        file(CREATE_LINK "${prefix}" "${work}/prefix" SYMBOLIC)
        execute_process(
            COMMAND "${CMAKE_COMMAND}" -E env --unset=PKG_CONFIG_PATH --unset=LD_LIBRARY_PATH PREFIX=prefix
                    sh -ec "${commands}"
            WORKING_DIRECTORY "${work}" OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
        check_output("${output}")
    endif()
else()
    message(STATUS "pkg-config is missing: not tested")
endif()

file(WRITE "${work}/CMakeLists.txt" "
cmake_minimum_required(VERSION 3.21)
project(user LANGUAGES C)
find_package(exact_ccd REQUIRED)
add_executable(user program.c)
target_link_libraries(user PRIVATE exact_ccd::exact_ccd)
")
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${work}" -B "${work}/build" "-DCMAKE_PREFIX_PATH=${prefix}"
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${work}/build" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${work}/build/user" OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
check_output("${output}")

# The project of another, which has no option of tests that it has not asked for.
file(WRITE "${work}/host/CMakeLists.txt" "
cmake_minimum_required(VERSION 3.21)
project(host LANGUAGES C CXX)
add_subdirectory([[${SOURCE}]] exact_ccd)
find_package(exact_ccd REQUIRED)
if(DEFINED CACHE{BUILD_TESTING})
    message(FATAL_ERROR \"exact_ccd sets BUILD_TESTING in the project of another\")
endif()
")
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${work}/host" -B "${work}/host/build" "-DCMAKE_PREFIX_PATH=${prefix}"
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
