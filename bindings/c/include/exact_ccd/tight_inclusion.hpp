// The functions of Tight Inclusion (Wang et al. 2021), answered by exact-ccd: the same arguments in
// the same order, in the namespace exact_ccd::ticcd. Needs Eigen.
//
// Order of arguments: all points at the start, then the same points at the end. For two edges, that
// is both ends of edge a, then both ends of edge b. A host that passes (a0, b0, a1, b1) computes the
// contact of two other edges, and no check of types can notice. CCDTightInclusionIntersection of SOFA does,
// in testIntersection and computeIntersection of two lines (commit 0490a69).
//
// Differences, all of them because the answer is exact:
//
// - `toi` is the first time at which the distance is at most `ms`, rounded down. Tight Inclusion
//   returns an earlier time, which depends on `tolerance`. A step of exactly `toi` may end in contact:
//   multiply by 0.9, say.
// - `err`, `tolerance`, `max_itr` and the method have no influence. `output_tolerance` is 0.
// - `no_zero_toi` has no influence: `toi` is 0 for primitives within `ms` at the start, or within the
//   smallest double of it.
// - Coordinates that are not finite, a negative `ms` and a `t_max` that is not a number throw exact_ccd::Error.

#ifndef EXACT_CCD_TIGHT_INCLUSION_HPP
#define EXACT_CCD_TIGHT_INCLUSION_HPP

#include <limits>

#include <Eigen/Core>

#include "../exact_ccd.hpp"

namespace exact_ccd::ticcd {

using Scalar = double;
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
using Array3 = Eigen::Array<Scalar, 3, 1>;

enum class CCDRootFindingMethod { DEPTH_FIRST_SEARCH, BREADTH_FIRST_SEARCH };

namespace detail {

inline bool first_time(Kind kind,
                       const std::array<const Vector3*, 8>& points,
                       Scalar ms,
                       Scalar t_max,
                       Scalar& toi,
                       Scalar& output_tolerance)
{
    std::array<Point, 8> copies;
    for (std::size_t i = 0; i < points.size(); ++i) {
        copies[i] = {points[i]->x(), points[i]->y(), points[i]->z()};
    }
    const auto time =
        time_of_impact(kind, Points(copies[0].data(), 4), Points(copies[4].data(), 4), ms, t_max);
    output_tolerance = 0;
    toi = time.value_or(std::numeric_limits<Scalar>::infinity());
    return time.has_value();
}

}  // namespace detail

/// Two edges, a and b. Returns true if their distance is at most `ms` at a time until `t_max`, exactly. `toi`
/// is the first such time, rounded down, or infinite.
inline bool edgeEdgeCCD(const Vector3& ea0_t0,
                        const Vector3& ea1_t0,
                        const Vector3& eb0_t0,
                        const Vector3& eb1_t0,
                        const Vector3& ea0_t1,
                        const Vector3& ea1_t1,
                        const Vector3& eb0_t1,
                        const Vector3& eb1_t1,
                        const Array3& /* err */,
                        const Scalar ms,
                        Scalar& toi,
                        const Scalar /* tolerance */,
                        const Scalar t_max,
                        const long /* max_itr */,
                        Scalar& output_tolerance,
                        bool /* no_zero_toi */ = false,
                        const CCDRootFindingMethod = CCDRootFindingMethod::BREADTH_FIRST_SEARCH)
{
    return detail::first_time(
        Kind::edge_edge,
        {&ea0_t0, &ea1_t0, &eb0_t0, &eb1_t0, &ea0_t1, &ea1_t1, &eb0_t1, &eb1_t1},
        ms,
        t_max,
        toi,
        output_tolerance);
}

/// A vertex and a face. Returns and `toi` as in `edgeEdgeCCD`.
inline bool vertexFaceCCD(const Vector3& v_t0,
                          const Vector3& f0_t0,
                          const Vector3& f1_t0,
                          const Vector3& f2_t0,
                          const Vector3& v_t1,
                          const Vector3& f0_t1,
                          const Vector3& f1_t1,
                          const Vector3& f2_t1,
                          const Array3& /* err */,
                          const Scalar ms,
                          Scalar& toi,
                          const Scalar /* tolerance */,
                          const Scalar t_max,
                          const long /* max_itr */,
                          Scalar& output_tolerance,
                          bool /* no_zero_toi */ = false,
                          const CCDRootFindingMethod = CCDRootFindingMethod::BREADTH_FIRST_SEARCH)
{
    return detail::first_time(
        Kind::vertex_face,
        {&v_t0, &f0_t0, &f1_t0, &f2_t0, &v_t1, &f0_t1, &f1_t1, &f2_t1},
        ms,
        t_max,
        toi,
        output_tolerance);
}

}  // namespace exact_ccd::ticcd

#endif
