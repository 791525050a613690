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

/// The contact of two primitives of a kind, given by their points p to s at t = 0 and at t = 1.
/// `edgeEdgeCCD` takes the two ends of edge a, then of edge b; `vertexFaceCCD` takes the vertex, then the
/// corners of the face. Returns true if their distance is at most `ms` at a time until `t_max`, exactly.
/// `toi` is the first such time, rounded down, or infinite.
template <Kind kind>
struct Function {
    bool operator()(const Vector3& p_t0,
                    const Vector3& q_t0,
                    const Vector3& r_t0,
                    const Vector3& s_t0,
                    const Vector3& p_t1,
                    const Vector3& q_t1,
                    const Vector3& r_t1,
                    const Vector3& s_t1,
                    const Array3& /* err */,
                    const Scalar ms,
                    Scalar& toi,
                    const Scalar /* tolerance */,
                    const Scalar t_max,
                    const long /* max_itr */,
                    Scalar& output_tolerance,
                    bool /* no_zero_toi */ = false,
                    const CCDRootFindingMethod = CCDRootFindingMethod::BREADTH_FIRST_SEARCH) const
    {
        const auto point = [](const Vector3& x) { return Point{x.x(), x.y(), x.z()}; };
        const std::array<Point, 4> x0{point(p_t0), point(q_t0), point(r_t0), point(s_t0)};
        const std::array<Point, 4> x1{point(p_t1), point(q_t1), point(r_t1), point(s_t1)};
        const auto time = time_of_impact(kind, x0, x1, ms, t_max);
        output_tolerance = 0;
        toi = time.value_or(std::numeric_limits<Scalar>::infinity());
        return time.has_value();
    }
};

inline constexpr Function<Kind::edge_edge> edgeEdgeCCD{};
inline constexpr Function<Kind::vertex_face> vertexFaceCCD{};

}  // namespace exact_ccd::ticcd

#endif
