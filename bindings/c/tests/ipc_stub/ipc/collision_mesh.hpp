// The members of ipc::CollisionMesh and ipc::CollisionFilter that exact_ccd/ipc_collision_mesh.hpp uses,
// with their types, without the toolkit: version 1.6, or with IPC_BEFORE_1_6 versions 1.4 and 1.5.

#pragma once

#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace ipc {

#ifndef IPC_BEFORE_1_6
// As in the toolkit, a class that converts to std::function, and is callable itself.
class CollisionFilter {
public:
    CollisionFilter() : function_([](std::size_t, std::size_t) { return true; }) {}

    template <typename Function,
              typename = std::enable_if_t<std::is_invocable_r_v<bool, Function, std::size_t, std::size_t>
                                          && !std::is_same_v<std::decay_t<Function>, CollisionFilter>>>
    CollisionFilter(Function&& function) : function_(std::forward<Function>(function))
    {
    }

    bool operator()(std::size_t a, std::size_t b) const { return function_(a, b); }

    operator std::function<bool(std::size_t, std::size_t)>() const { return function_; }

private:
    std::function<bool(std::size_t, std::size_t)> function_;
};
#endif

class CollisionMesh {
public:
    CollisionMesh() = default;

    explicit CollisionMesh(Eigen::MatrixXd rest_positions,
                           Eigen::MatrixXi edges = Eigen::MatrixXi(),
                           Eigen::MatrixXi faces = Eigen::MatrixXi())
        : rest_positions_(std::move(rest_positions)), edges_(std::move(edges)), faces_(std::move(faces))
    {
    }

    std::size_t num_vertices() const { return rest_positions_.rows(); }
    std::size_t dim() const { return rest_positions_.cols(); }
    const Eigen::MatrixXi& edges() const { return edges_; }
    const Eigen::MatrixXi& faces() const { return faces_; }

#ifdef IPC_BEFORE_1_6
    std::function<bool(std::size_t, std::size_t)> can_collide = default_can_collide;

private:
    // Of type bool from version 1.5 on.
    static int default_can_collide(std::size_t, std::size_t) { return true; }

#else
    CollisionFilter can_collide;
    std::vector<Eigen::Hyperplane<double, 3>> planes;

private:
#endif
    Eigen::MatrixXd rest_positions_;
    Eigen::MatrixXi edges_, faces_;
};

}  // namespace ipc
