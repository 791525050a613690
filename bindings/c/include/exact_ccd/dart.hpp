// The queries of DART between moving points, triangles and edges (pointTriangleCcd and edgeEdgeCcd of
// dart/collision/native/narrow_phase/primitive_ccd.hpp), answered by exact-ccd: the same arguments in the
// same order. A validation oracle: the answer is exact, where DART's is conservative and may end without
// one, and where its cubic solver rounds. Needs Eigen; the option and the result are DART's own, or any
// structures with the members that are named below.
//
//   dart::collision::native::CcdPrimitiveResult result, exact;
//   pointTriangleCcd(p0, p1, a0, a1, b0, b1, c0, c1, option, result);
//   exact_ccd::dart::pointTriangleCcd(p0, p1, a0, a1, b0, b1, c0, c1, option, exact);
//   assert(!exact.hit || result.status != dart::collision::native::CcdPrimitiveStatus::Miss);
//   assert(!exact.hit || !result.hit || result.timeOfImpact <= exact.timeOfImpact);
//
// DART may hit without contact, where the primitives come within option.tolerance of each other.
//
// Order of arguments: the start and the end of each point, one point after the other. The edges are a b
// and c d.
//
// - `option.minSeparation` is the distance that counts as contact; a negative one is 0, as in DART. No
//   other member is read: tolerance and iterations have no influence.
// - `result.hit` is the answer, `result.timeOfImpact` the first time within that distance, rounded down,
//   or 1 if there is none. `result.status`, where it exists, is Hit or Miss.
// - Coordinates that are not finite throw exact_ccd::Error.

#ifndef EXACT_CCD_DART_HPP
#define EXACT_CCD_DART_HPP

#include <Eigen/Core>

#include "../exact_ccd.hpp"

namespace exact_ccd::dart {

namespace detail {

// Versions of DART before 7 have no status.
template <typename Result>
auto set_status(Result& result, bool hit) -> decltype(result.status, void())
{
    using Status = decltype(result.status);
    result.status = hit ? Status::Hit : Status::Miss;
}

inline void set_status(...) {}

}  // namespace detail

/// The contact of two moving primitives of a kind: `pointTriangleCcd` of a point, then the corners of a triangle;
/// `edgeEdgeCcd` of edge a b, then edge c d.
template <Kind kind>
struct Function {
    template <typename Option, typename Result>
    bool operator()(const Eigen::Vector3d& aStart,
                    const Eigen::Vector3d& aEnd,
                    const Eigen::Vector3d& bStart,
                    const Eigen::Vector3d& bEnd,
                    const Eigen::Vector3d& cStart,
                    const Eigen::Vector3d& cEnd,
                    const Eigen::Vector3d& dStart,
                    const Eigen::Vector3d& dEnd,
                    const Option& option,
                    Result& result) const
    {
        const auto point = [](const Eigen::Vector3d& x) { return Point{x.x(), x.y(), x.z()}; };
        const std::array<Point, 4> start{point(aStart), point(bStart), point(cStart), point(dStart)};
        const std::array<Point, 4> end{point(aEnd), point(bEnd), point(cEnd), point(dEnd)};
        const double min_separation = option.minSeparation < 0 ? 0.0 : option.minSeparation;
        const auto time = time_of_impact(kind, start, end, min_separation);
        result.clear();
        result.hit = time.has_value();
        result.timeOfImpact = time.value_or(1.0);
        detail::set_status(result, result.hit);
        return result.hit;
    }
};

inline constexpr Function<Kind::vertex_face> pointTriangleCcd{};
inline constexpr Function<Kind::edge_edge> edgeEdgeCcd{};

}  // namespace exact_ccd::dart

#endif
