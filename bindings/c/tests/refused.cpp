// An argument of a type that is a view of another: MATRIX is that type, and VIEW the view. See refused.cmake.

#include <Eigen/Core>

#include <exact_ccd.hpp>

using Given = MATRIX;

std::size_t rows(exact_ccd::VIEW view) { return view.size(); }

std::size_t answer(const Given& given) { return rows(given); }
