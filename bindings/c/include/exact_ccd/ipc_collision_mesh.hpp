// Both phases of continuous collision detection for an ipc::CollisionMesh, by exact-ccd. Needs the
// IPC Toolkit (1.4 or later) and Eigen.
//
//   exact_ccd::CollisionDetector detector(mesh);
//   const double step = detector.compute_collision_free_stepsize(x0, x1, min_distance);

#ifndef EXACT_CCD_IPC_COLLISION_MESH_HPP
#define EXACT_CCD_IPC_COLLISION_MESH_HPP

#include <cstdint>
#include <functional>
#include <type_traits>
#include <vector>

#include <ipc/collision_mesh.hpp>

#include "ipc_toolkit.hpp"

namespace exact_ccd {

/// Both phases for the steps of an ipc::CollisionMesh, in three or two dimensions, with its edges,
/// faces, codimensional vertices and edges and its `can_collide`; its planes are not examined.
///
/// It keeps memory from step to step: make it once, not in each step. `can_collide` is called from
/// several threads, and ends the program if it throws. Not for several threads at the same time.
class CollisionDetector {
public:
    explicit CollisionDetector(const ipc::CollisionMesh& mesh)
        : mesh_(mesh.num_vertices(), faces(mesh), edges(mesh)),
          detector_(mesh_),
          can_collide_(function(mesh.can_collide))
    {
        // The filter of a mesh without one allows all pairs; it need not be called.
        const Filter all = function(decltype(mesh.can_collide)());
        if (can_collide_.target_type() != all.target_type()) {
            detector_.set_can_collide(
                [](std::uint32_t a, std::uint32_t b, void* filter) noexcept {
                    return (*static_cast<const Filter*>(filter))(a, b);
                },
                &can_collide_);
        }
    }

    CollisionDetector(const CollisionDetector&) = delete;
    CollisionDetector& operator=(const CollisionDetector&) = delete;

    /// As ipc::is_step_collision_free, exactly.
    bool is_step_collision_free(Eigen::ConstRef<Eigen::MatrixXd> vertices_t0,
                                Eigen::ConstRef<Eigen::MatrixXd> vertices_t1,
                                double min_distance = 0.0)
    {
        begin(vertices_t0, vertices_t1, min_distance);
        return detector_.is_free(x0_, x1_);
    }

    /// As ipc::compute_collision_free_stepsize: the exact time of impact multiplied by
    /// `conservative_rescaling`; 1 if the step is free.
    double compute_collision_free_stepsize(
        Eigen::ConstRef<Eigen::MatrixXd> vertices_t0,
        Eigen::ConstRef<Eigen::MatrixXd> vertices_t1,
        double min_distance = 0.0,
        double conservative_rescaling = ExactCCD::DEFAULT_CONSERVATIVE_RESCALING)
    {
        begin(vertices_t0, vertices_t1, min_distance);
        const auto contact = detector_.earliest_contact(x0_, x1_);
        return contact ? conservative_rescaling * contact->impact.time : 1.0;
    }

    /// As ipc::has_intersections in three dimensions: an edge and a face with a common point.
    bool has_intersections(Eigen::ConstRef<Eigen::MatrixXd> vertices)
    {
        copy(vertices, x0_);
        return mesh_.has_intersections(x0_);
    }

private:
    using Filter = std::function<bool(std::size_t, std::size_t)>;

    // The function in an ipc::CollisionFilter, not a function that holds the filter: their types tell a
    // filter that allows all pairs from others. Before 1.6, `can_collide` is the function itself.
    template <typename CanCollide>
    static Filter function(const CanCollide& can_collide)
    {
        if constexpr (std::is_same_v<CanCollide, Filter>) {
            return can_collide;
        } else {
            return can_collide.operator Filter();
        }
    }

    static std::vector<std::array<std::uint32_t, 3>> faces(const ipc::CollisionMesh& mesh)
    {
        std::vector<std::array<std::uint32_t, 3>> faces(mesh.num_faces());
        for (std::size_t i = 0; i < faces.size(); ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                faces[i][j] = static_cast<std::uint32_t>(mesh.faces()(i, j));
            }
        }
        return faces;
    }

    static std::vector<std::array<std::uint32_t, 2>> edges(const ipc::CollisionMesh& mesh)
    {
        std::vector<std::array<std::uint32_t, 2>> edges(mesh.num_edges());
        for (std::size_t i = 0; i < edges.size(); ++i) {
            for (std::size_t j = 0; j < 2; ++j) {
                edges[i][j] = static_cast<std::uint32_t>(mesh.edges()(i, j));
            }
        }
        return edges;
    }

    static void copy(Eigen::ConstRef<Eigen::MatrixXd> vertices, std::vector<Point>& points)
    {
        points.resize(vertices.rows());
        for (std::size_t i = 0; i < points.size(); ++i) {
            points[i] = {vertices(i, 0), vertices(i, 1), vertices.cols() > 2 ? vertices(i, 2) : 0.0};
        }
    }

    void begin(Eigen::ConstRef<Eigen::MatrixXd> vertices_t0,
               Eigen::ConstRef<Eigen::MatrixXd> vertices_t1,
               double min_distance)
    {
        copy(vertices_t0, x0_);
        copy(vertices_t1, x1_);
        if (min_distance != min_distance_) {
            detector_.set_min_distance(min_distance);
            min_distance_ = min_distance;
        }
    }

    Mesh mesh_;
    Detector detector_;
    Filter can_collide_;
    double min_distance_ = 0.0;
    std::vector<Point> x0_, x1_;
};

}  // namespace exact_ccd

#endif
