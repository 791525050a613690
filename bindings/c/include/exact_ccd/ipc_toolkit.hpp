// exact-ccd in place of the continuous collision detection of the IPC Toolkit, version 1.4 or later. Needs the
// headers of the IPC Toolkit and Eigen.
//
//   exact_ccd::ExactCCD narrow_phase;           // wherever an ipc::NarrowPhaseCCD is expected
//   ipc::compute_collision_free_stepsize(mesh, x0, x1, min_distance, broad_phase, narrow_phase);
//
// For both phases at once, see ipc_collision_mesh.hpp.
//
// The time of impact is exact: the first time at which the distance is at most `min_distance`,
// rounded down. A step of exactly that size may end in contact. Hence `toi` is that time multiplied by
// `conservative_rescaling`, 0.9 unless it is set.
//
// `tmax` is compared with the exact time, before it is rounded and multiplied: a contact after `tmax` is
// none. The step size of the toolkit passes the least `toi` so far, which is multiplied, as `tmax` of the
// next pair. So it depends on the order of the pairs, which the threads of the toolkit change from run to run.
// Let t be the first contact of all pairs. If its pair comes first, the step is 0.9 t. If another pair comes
// first, with contact at t' > t, the step is 0.9 t' unless t <= 0.9 t'. It is at least 0.9 t and less than t
// in any order. With a rescaling of 1 it is t, and by CollisionDetector (ipc_collision_mesh.hpp) 0.9 t, or
// less by some units in its last place, with which the rounded positions are certified.

#ifndef EXACT_CCD_IPC_TOOLKIT_HPP
#define EXACT_CCD_IPC_TOOLKIT_HPP

#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <ipc/ccd/narrow_phase_ccd.hpp>

#include "../exact_ccd.hpp"

namespace exact_ccd {

namespace detail {

// ipc::NarrowPhaseCCD with `conservative_rescaling`, which it has from version 1.6 on.
template <typename Base, typename = void>
struct Rescaled : Base {
    double conservative_rescaling = 1;
};

template <typename Base>
struct Rescaled<Base, std::void_t<decltype(Base::conservative_rescaling)>> : Base {};

}  // namespace detail

/// The narrow phase, pair by pair. In two dimensions, z is 0.
///
/// `toi` is at most `tmax`, 0 if the primitives are within `min_distance` at the start, and infinite if
/// there is no contact until `tmax`. Coordinates that are not finite, a negative `min_distance` and a
/// `tmax` that is not a number throw exact_ccd::Error; then `toi` keeps its value. It has no state but the
/// rescaling: one object serves all threads.
class ExactCCD : public detail::Rescaled<ipc::NarrowPhaseCCD> {
public:
    static constexpr double DEFAULT_CONSERVATIVE_RESCALING = 0.9;

    /// A rescaling that is not above 0 and at most 1 throws std::invalid_argument.
    explicit ExactCCD(double rescaling = DEFAULT_CONSERVATIVE_RESCALING)
    {
        if (!(rescaling > 0 && rescaling <= 1)) {
            throw std::invalid_argument("exact_ccd: a conservative rescaling of " + std::to_string(rescaling)
                                        + ", expected a number above 0 and at most 1");
        }
        conservative_rescaling = rescaling;
    }

    bool point_point_ccd(Eigen::ConstRef<ipc::VectorMax3d> p0_t0,
                         Eigen::ConstRef<ipc::VectorMax3d> p1_t0,
                         Eigen::ConstRef<ipc::VectorMax3d> p0_t1,
                         Eigen::ConstRef<ipc::VectorMax3d> p1_t1,
                         double& toi,
                         const double min_distance = 0.0,
                         const double tmax = 1.0) const override
    {
        return ccd(Kind::vertex_vertex, toi, min_distance, tmax, p0_t0, p1_t0, p0_t1, p1_t1);
    }

    bool point_edge_ccd(Eigen::ConstRef<ipc::VectorMax3d> p_t0,
                        Eigen::ConstRef<ipc::VectorMax3d> e0_t0,
                        Eigen::ConstRef<ipc::VectorMax3d> e1_t0,
                        Eigen::ConstRef<ipc::VectorMax3d> p_t1,
                        Eigen::ConstRef<ipc::VectorMax3d> e0_t1,
                        Eigen::ConstRef<ipc::VectorMax3d> e1_t1,
                        double& toi,
                        const double min_distance = 0.0,
                        const double tmax = 1.0) const override
    {
        return ccd(Kind::vertex_edge, toi, min_distance, tmax, p_t0, e0_t0, e1_t0, p_t1, e0_t1, e1_t1);
    }

    bool point_triangle_ccd(Eigen::ConstRef<Eigen::Vector3d> p_t0,
                            Eigen::ConstRef<Eigen::Vector3d> t0_t0,
                            Eigen::ConstRef<Eigen::Vector3d> t1_t0,
                            Eigen::ConstRef<Eigen::Vector3d> t2_t0,
                            Eigen::ConstRef<Eigen::Vector3d> p_t1,
                            Eigen::ConstRef<Eigen::Vector3d> t0_t1,
                            Eigen::ConstRef<Eigen::Vector3d> t1_t1,
                            Eigen::ConstRef<Eigen::Vector3d> t2_t1,
                            double& toi,
                            const double min_distance = 0.0,
                            const double tmax = 1.0) const override
    {
        return ccd(
            Kind::vertex_face, toi, min_distance, tmax, p_t0, t0_t0, t1_t0, t2_t0, p_t1, t0_t1, t1_t1, t2_t1);
    }

    bool edge_edge_ccd(Eigen::ConstRef<Eigen::Vector3d> ea0_t0,
                       Eigen::ConstRef<Eigen::Vector3d> ea1_t0,
                       Eigen::ConstRef<Eigen::Vector3d> eb0_t0,
                       Eigen::ConstRef<Eigen::Vector3d> eb1_t0,
                       Eigen::ConstRef<Eigen::Vector3d> ea0_t1,
                       Eigen::ConstRef<Eigen::Vector3d> ea1_t1,
                       Eigen::ConstRef<Eigen::Vector3d> eb0_t1,
                       Eigen::ConstRef<Eigen::Vector3d> eb1_t1,
                       double& toi,
                       const double min_distance = 0.0,
                       const double tmax = 1.0) const override
    {
        return ccd(
            Kind::edge_edge, toi, min_distance, tmax, ea0_t0, ea1_t0, eb0_t0, eb1_t0, ea0_t1, ea1_t1, eb0_t1, eb1_t1);
    }

private:
    // The points at t = 0, then at t = 1.
    template <typename... Vectors>
    bool ccd(Kind kind, double& toi, double min_distance, double tmax, const Vectors&... x) const
    {
        constexpr std::size_t n = sizeof...(x) / 2;
        const std::array<Point, 2 * n> points{Point{x[0], x[1], x.size() > 2 ? x[2] : 0.0}...};
        const auto time =
            time_of_impact(kind, Points(points[0].data(), n), Points(points[n].data(), n), min_distance, tmax);
        toi = time ? conservative_rescaling * *time : std::numeric_limits<double>::infinity();
        return time.has_value();
    }
};

}  // namespace exact_ccd

#endif
