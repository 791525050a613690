# Compares the symbols that a shared library exports with the functions of the header.

execute_process(COMMAND "${NM}" --dynamic --defined-only --format=posix "${LIBRARY}"
                OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+" lines "${symbols}")
set(exported "")
foreach(line IN LISTS lines)
    string(REGEX REPLACE " .*" "" symbol "${line}")
    list(APPEND exported "${symbol}")
endforeach()
list(SORT exported)

file(READ "${HEADER}" header)
string(REGEX REPLACE "//[^\n]*" "" header "${header}")
string(REGEX MATCHALL "exact_ccd_[a-z_0-9]+\\(" calls "${header}")
list(TRANSFORM calls REPLACE "\\($" "")
list(REMOVE_DUPLICATES calls)
list(SORT calls)

if(NOT exported STREQUAL calls)
    message(FATAL_ERROR "the library exports ${exported}, the header declares ${calls}")
endif()
list(LENGTH calls count)
message(STATUS "${count} symbols, all of the header")
