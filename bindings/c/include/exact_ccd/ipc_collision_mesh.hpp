// Both phases of continuous collision detection for an ipc::CollisionMesh, by exact-ccd. Needs the IPC
// Toolkit, version 1.4 or later, and Eigen.
//
//   exact_ccd::CollisionDetector detector(mesh);
//   const double step = detector.compute_collision_free_stepsize(x0, x1, min_distance);

#ifndef EXACT_CCD_IPC_COLLISION_MESH_HPP
#define EXACT_CCD_IPC_COLLISION_MESH_HPP

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <ipc/collision_mesh.hpp>

#include "ipc_toolkit.hpp"

namespace exact_ccd {

/// Both phases for the steps of an ipc::CollisionMesh, with its codimensional vertices and edges and its
/// `can_collide`. A mesh with planes, and positions that do not fit the mesh, throw std::invalid_argument.
///
/// In two dimensions, it finds the toolkit's pairs: each edge and each vertex that is no end of it, and two
/// vertices without edges. In three dimensions, it finds the pairs of exact_ccd::Detector, which contain the
/// toolkit's.
///
/// It keeps memory from step to step: make it once, not in each step. The mesh stays where it is as long as
/// the detector exists; its `can_collide` may be replaced between two calls. It is called from several threads,
/// and ends the program if it throws. Not for several threads at the same time.
class CollisionDetector {
public:
    explicit CollisionDetector(const ipc::CollisionMesh& mesh) : mesh_(mesh), steps_(connectivity(mesh))
    {
        if (is_flat()) {
            steps_.set_pair_can_collide(is_vertex_against, this);
            edges_.emplace(connectivity(mesh));
            edges_->set_pair_can_collide(is_edge_against_edge, this);
        }
    }

    /// The mesh has to exist as long as the detector.
    explicit CollisionDetector(const ipc::CollisionMesh&&) = delete;
    CollisionDetector(const CollisionDetector&) = delete;
    CollisionDetector& operator=(const CollisionDetector&) = delete;

    /// As ipc::is_step_collision_free, exactly. A mesh that is pierced at the start may be free, as there:
    /// `has_intersections` finds it.
    bool is_step_collision_free(Eigen::ConstRef<Eigen::MatrixXd> vertices_t0,
                                Eigen::ConstRef<Eigen::MatrixXd> vertices_t1,
                                double min_distance = 0.0)
    {
        begin(vertices_t0, vertices_t1, min_distance);
        return !steps_.collides(x0_, x1_);
    }

    /// As ipc::compute_collision_free_stepsize: 1 if the step is free, else a size of at most the exact time
    /// of impact multiplied by `conservative_rescaling`, which is above 0 and at most 1. For a size below 1,
    /// the motion to x0 + size * (x1 - x0), each operation rounded, is certified to be free of contact, if no
    /// difference overflows; with 1, that to x1: take x1, not the sum. The size is 0 if none of the sizes that
    /// are tried is certified.
    ///
    /// Compilers may fuse the product and the sum, GCC on ARM by default, on x86 with `-march=native`: compile
    /// that line with `-ffp-contract=off`, or take the positions of `free_step`.
    double compute_collision_free_stepsize(
        Eigen::ConstRef<Eigen::MatrixXd> vertices_t0,
        Eigen::ConstRef<Eigen::MatrixXd> vertices_t1,
        double min_distance = 0.0,
        double conservative_rescaling = ExactCCD::DEFAULT_CONSERVATIVE_RESCALING)
    {
        begin(vertices_t0, vertices_t1, min_distance);
        return steps_.free_step(x0_, x1_, conservative_rescaling).size;
    }

    /// The same size, and the positions there, to which the motion is certified to be free of contact.
    std::pair<double, Eigen::MatrixXd> free_step(
        Eigen::ConstRef<Eigen::MatrixXd> vertices_t0,
        Eigen::ConstRef<Eigen::MatrixXd> vertices_t1,
        double min_distance = 0.0,
        double conservative_rescaling = ExactCCD::DEFAULT_CONSERVATIVE_RESCALING)
    {
        begin(vertices_t0, vertices_t1, min_distance);
        const auto step = steps_.free_step(x0_, x1_, conservative_rescaling);
        Eigen::MatrixXd x(vertices_t0.rows(), vertices_t0.cols());
        for (Eigen::Index i = 0; i < x.rows(); ++i) {
            for (Eigen::Index j = 0; j < x.cols(); ++j) {
                x(i, j) = step.positions[i][j];
            }
        }
        return {step.size, std::move(x)};
    }

    /// As ipc::has_intersections, exactly: a common point of an edge and a face, in two dimensions of two
    /// edges, that can collide and have no common vertex.
    bool has_intersections(Eigen::ConstRef<Eigen::MatrixXd> vertices)
    {
        obey_mesh();
        copy(vertices, x0_);
        return is_flat() ? edges_->collides(x0_, x0_) : steps_.has_intersections(x0_);
    }

private:
    using Filter = std::function<bool(std::size_t, std::size_t)>;
    using Index = std::uint32_t;

    bool is_flat() const { return mesh_.dim() == 2; }

    // In two dimensions, vertex v has a copy, n + v, without an edge: a Detector compares vertices without
    // edges with edges of no face.
    static Mesh connectivity(const ipc::CollisionMesh& mesh)
    {
        const bool is_flat = mesh.dim() == 2;
        const auto faces = is_flat ? std::vector<std::array<Index, 3>>() : rows<3>(mesh.faces());
        return Mesh((is_flat ? 2 : 1) * mesh.num_vertices(), faces, rows<2>(mesh.edges()));
    }

    template <std::size_t N>
    static std::vector<std::array<Index, N>> rows(const Eigen::MatrixXi& matrix)
    {
        std::vector<std::array<Index, N>> rows(matrix.rows());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            for (std::size_t j = 0; j < N; ++j) {
                rows[i][j] = static_cast<Index>(matrix(i, j));
            }
        }
        return rows;
    }

    bool allows(const Index* a, std::size_t a_count, const Index* b, std::size_t b_count) const
    {
        for (std::size_t i = 0; i < a_count * b_count; ++i) {
            if (mesh_.can_collide(a[i / b_count], b[i % b_count])) {
                return true;
            }
        }
        return false;
    }

    static bool are_allowed(Index a, Index b, void* detector) noexcept
    {
        return static_cast<const CollisionDetector*>(detector)->mesh_.can_collide(a, b);
    }

    // The copy of a vertex against an edge without the vertex; two vertices that have no edge themselves.
    static bool is_vertex_against(
        const Index* a, std::size_t a_count, const Index* b, std::size_t b_count, void* detector) noexcept
    {
        const auto& self = *static_cast<const CollisionDetector*>(detector);
        const std::size_t n = self.mesh_.num_vertices();
        if (a_count != 1) {
            return false;
        }
        if (b_count == 1) {
            return a[0] < n && b[0] < n && self.allows(a, 1, b, 1);
        }
        const Index vertex = static_cast<Index>(a[0] - n);
        return a[0] >= n && vertex != b[0] && vertex != b[1] && self.allows(&vertex, 1, b, 2);
    }

    static bool is_edge_against_edge(
        const Index* a, std::size_t a_count, const Index* b, std::size_t b_count, void* detector) noexcept
    {
        return a_count == 2 && b_count == 2
               && static_cast<const CollisionDetector*>(detector)->allows(a, 2, b, 2);
    }

    // The filter is a function up to version 1.5, and then a class that converts to one.
    static Filter function_of(const Filter& filter) { return filter; }

    template <typename Class>
    static Filter function_of(const Class& filter)
    {
        return filter.operator Filter();
    }

    // The filter of a mesh without one allows all pairs; it need not be called. It has a type of its own from
    // version 1.6 on. Before, it is a function, with a result of type int in version 1.4.
    static bool is_default(const Filter& filter)
    {
        static const Filter all = function_of(ipc::CollisionMesh().can_collide);
        return filter.target_type() == all.target_type() && is_same<int>(filter, all) && is_same<bool>(filter, all);
    }

    // False for two different functions with this type of result. Both filters have targets of one type.
    template <typename Result>
    static bool is_same(const Filter& filter, const Filter& other)
    {
        using Function = Result (*)(std::size_t, std::size_t);
        const Function *given = filter.target<Function>(), *expected = other.target<Function>();
        return !given || *given == *expected;
    }

    // There are planes from version 1.6 on.
    template <typename CollisionMesh>
    static auto has_planes(const CollisionMesh& mesh, int) -> decltype(!mesh.planes.empty())
    {
        return !mesh.planes.empty();
    }

    template <typename CollisionMesh>
    static bool has_planes(const CollisionMesh&, long)
    {
        return false;
    }

    void obey_mesh()
    {
        if (has_planes(mesh_, 0)) {
            throw std::invalid_argument("exact_ccd: planes are not supported: add triangles in their place");
        }
        if (!is_flat() && has_filter_ == is_default(function_of(mesh_.can_collide))) {
            has_filter_ = !has_filter_;
            steps_.set_can_collide(has_filter_ ? are_allowed : nullptr, this);
        }
    }

    void copy(Eigen::ConstRef<Eigen::MatrixXd> vertices, std::vector<Point>& points)
    {
        const std::size_t n = mesh_.num_vertices(), dim = mesh_.dim();
        if (static_cast<std::size_t>(vertices.rows()) != n || static_cast<std::size_t>(vertices.cols()) != dim) {
            throw std::invalid_argument("exact_ccd: positions of " + std::to_string(vertices.rows()) + " by "
                                        + std::to_string(vertices.cols()) + " coordinates, expected "
                                        + std::to_string(n) + " by " + std::to_string(dim));
        }
        points.resize(is_flat() ? 2 * n : n);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::size_t vertex = i < n ? i : i - n;
            points[i] = {vertices(vertex, 0), vertices(vertex, 1), is_flat() ? 0.0 : vertices(vertex, 2)};
        }
    }

    void begin(Eigen::ConstRef<Eigen::MatrixXd> vertices_t0,
               Eigen::ConstRef<Eigen::MatrixXd> vertices_t1,
               double min_distance)
    {
        obey_mesh();
        copy(vertices_t0, x0_);
        copy(vertices_t1, x1_);
        if (min_distance != min_distance_) {
            steps_.set_min_distance(min_distance);
            min_distance_ = min_distance;
        }
    }

    const ipc::CollisionMesh& mesh_;
    Detector steps_;
    // For edges at rest, in two dimensions.
    std::optional<Detector> edges_;
    bool has_filter_ = false;
    double min_distance_ = 0.0;
    std::vector<Point> x0_, x1_;
};

}  // namespace exact_ccd

#endif
