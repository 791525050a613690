// Eigen matrices as views: rows of row-major matrices, and vectors, without copies. refused.cpp has others.

#include <Eigen/Core>

#include <exact_ccd.hpp>

#include "check.h"

template <>
struct exact_ccd::is_element<Eigen::Vector3d, double, 3> : std::true_type {};

namespace {

using Eigen::Dynamic;
using exact_ccd::Faces;
using exact_ccd::Points;
using Positions = Eigen::Matrix<double, Dynamic, 3, Eigen::RowMajor>;
using Numbers = exact_ccd::View<double, 1>;
template <typename T, int N>
using Rows = Eigen::Matrix<T, Dynamic, N, Eigen::RowMajor>;

static_assert(std::is_constructible_v<Points, Positions>);
static_assert(std::is_constructible_v<Points, Eigen::Map<const Positions>>);
static_assert(std::is_constructible_v<Faces, Rows<std::uint32_t, 3>>);
static_assert(std::is_constructible_v<Numbers, Eigen::VectorXd>);
static_assert(std::is_constructible_v<Points, std::vector<Eigen::Vector3d>>);
static_assert(!std::is_constructible_v<Points, std::vector<Eigen::Vector4d>>);

template <typename View, typename Matrix>
bool is_refused(const Matrix& matrix)
{
    try {
        const View view(matrix);
    } catch (const std::invalid_argument&) {
        return true;
    }
    return false;
}

}  // namespace

int main()
{
    Positions x0(6, 3);
    x0 << 0, 0, 0, 8, 0, 0, 0, 8, 0, 1, 1, 1, 1, 2, 5, 2, 1, 5;
    Positions x1 = x0;
    x1.bottomRows(3).col(2).array() -= 2;
    CHECK(Points(x0).data() == x0.data() && Points(x0).size() == 6);

    Rows<std::uint32_t, 3> faces(2, 3);
    faces << 0, 1, 2, 3, 4, 5;
    exact_ccd::Detector detector(exact_ccd::Mesh(6, faces));
    CHECK(detector.free_step(x0, Eigen::Map<const Positions>(x1.data(), 6, 3)).size == 0.45);
    const Eigen::MatrixXd of_columns = x0;
    const std::vector<Eigen::Vector3d> vectors(x1.rowwise().begin(), x1.rowwise().end());
    CHECK(detector.free_step(Positions(of_columns), vectors).size == 0.45);
    detector.set_thickness(Eigen::VectorXd::Constant(6, 0.25).eval());
    CHECK(detector.free_step(x0, x1).size == 0.225);

    // Parts of a matrix: whole rows have no gaps between them.
    CHECK(Points(x0.topRows(3)).size() == 3);
    const Rows<double, 4> wide = Rows<double, 4>::Zero(6, 4);
    CHECK(is_refused<Points>(wide.leftCols<3>()));
    CHECK(is_refused<Numbers>(x0.col(0)));
    return 0;
}
