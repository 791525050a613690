# Compiles refused.cpp with matrices that are no views: the error names the reason and the remedy.

function(compile view matrix result messages)
    execute_process(
        COMMAND "${CXX}" -std=c++17 -fsyntax-only "-DVIEW=${view}" "-DMATRIX=${matrix}" "-I${SOURCE}/include"
                -isystem "${EIGEN}" "${SOURCE}/tests/refused.cpp"
        RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE errors)
    set(${result} "${status}" PARENT_SCOPE)
    set(${messages} "${output}${errors}" PARENT_SCOPE)
endfunction()

function(check_accepted view matrix)
    compile("${view}" "${matrix}" status messages)
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "${matrix} is no exact_ccd::${view}: ${messages}")
    endif()
endfunction()

function(check_refused view matrix words)
    compile("${view}" "${matrix}" status messages)
    if(status EQUAL 0)
        message(FATAL_ERROR "${matrix} is an exact_ccd::${view}, expected an error")
    endif()
    if(NOT messages MATCHES "exact_ccd: [^\n]*${words}")
        message(FATAL_ERROR "the error of ${matrix} as an exact_ccd::${view} does not name ${words}: ${messages}")
    endif()
endfunction()

check_accepted("Points" "Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>")
check_accepted("Faces" "Eigen::Matrix<std::uint32_t, Eigen::Dynamic, 3, Eigen::RowMajor>")
check_refused("Points" "Eigen::MatrixXd" "row-major")
check_refused("Points" "Eigen::Matrix<double, Eigen::Dynamic, 3>" "row-major")
check_refused("Points" "Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>" "matrices of double")
check_refused("Points" "Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>" "3 columns")
check_refused("Faces" "Eigen::MatrixXi" "std::uint32_t")
check_refused("Faces" "Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>" "std::uint32_t")
check_refused("Edges" "Eigen::Matrix<std::uint32_t, Eigen::Dynamic, 3, Eigen::RowMajor>" "edges 2")
