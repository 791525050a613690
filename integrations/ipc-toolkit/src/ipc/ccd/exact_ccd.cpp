#include "exact_ccd.hpp"

#include <exact_ccd/ipc_toolkit.hpp>

namespace ipc {

namespace {

    /// The adapter of exact-ccd, which has the same signatures, with the rescaling of a narrow phase.
    ::exact_ccd::ExactCCD adapter(const NarrowPhaseCCD& ccd)
    {
        return ::exact_ccd::ExactCCD(ccd.conservative_rescaling);
    }

} // namespace

ExactCCD::ExactCCD(double rescaling) { conservative_rescaling = rescaling; }

bool ExactCCD::point_point_ccd(
    Eigen::ConstRef<VectorMax3d> p0_t0,
    Eigen::ConstRef<VectorMax3d> p1_t0,
    Eigen::ConstRef<VectorMax3d> p0_t1,
    Eigen::ConstRef<VectorMax3d> p1_t1,
    double& toi,
    const double min_distance,
    const double tmax) const
{
    return adapter(*this).point_point_ccd(
        p0_t0, p1_t0, p0_t1, p1_t1, toi, min_distance, tmax);
}

bool ExactCCD::point_edge_ccd(
    Eigen::ConstRef<VectorMax3d> p_t0,
    Eigen::ConstRef<VectorMax3d> e0_t0,
    Eigen::ConstRef<VectorMax3d> e1_t0,
    Eigen::ConstRef<VectorMax3d> p_t1,
    Eigen::ConstRef<VectorMax3d> e0_t1,
    Eigen::ConstRef<VectorMax3d> e1_t1,
    double& toi,
    const double min_distance,
    const double tmax) const
{
    return adapter(*this).point_edge_ccd(
        p_t0, e0_t0, e1_t0, p_t1, e0_t1, e1_t1, toi, min_distance, tmax);
}

bool ExactCCD::point_triangle_ccd(
    Eigen::ConstRef<Eigen::Vector3d> p_t0,
    Eigen::ConstRef<Eigen::Vector3d> t0_t0,
    Eigen::ConstRef<Eigen::Vector3d> t1_t0,
    Eigen::ConstRef<Eigen::Vector3d> t2_t0,
    Eigen::ConstRef<Eigen::Vector3d> p_t1,
    Eigen::ConstRef<Eigen::Vector3d> t0_t1,
    Eigen::ConstRef<Eigen::Vector3d> t1_t1,
    Eigen::ConstRef<Eigen::Vector3d> t2_t1,
    double& toi,
    const double min_distance,
    const double tmax) const
{
    return adapter(*this).point_triangle_ccd(
        p_t0, t0_t0, t1_t0, t2_t0, p_t1, t0_t1, t1_t1, t2_t1, toi,
        min_distance, tmax);
}

bool ExactCCD::edge_edge_ccd(
    Eigen::ConstRef<Eigen::Vector3d> ea0_t0,
    Eigen::ConstRef<Eigen::Vector3d> ea1_t0,
    Eigen::ConstRef<Eigen::Vector3d> eb0_t0,
    Eigen::ConstRef<Eigen::Vector3d> eb1_t0,
    Eigen::ConstRef<Eigen::Vector3d> ea0_t1,
    Eigen::ConstRef<Eigen::Vector3d> ea1_t1,
    Eigen::ConstRef<Eigen::Vector3d> eb0_t1,
    Eigen::ConstRef<Eigen::Vector3d> eb1_t1,
    double& toi,
    const double min_distance,
    const double tmax) const
{
    return adapter(*this).edge_edge_ccd(
        ea0_t0, ea1_t0, eb0_t0, eb1_t0, ea0_t1, ea1_t1, eb0_t1, eb1_t1, toi,
        min_distance, tmax);
}

} // namespace ipc
