// CollisionDetector, with the members of the toolkit that it uses: its filter, two dimensions, planes.

#include <random>

#include <exact_ccd/ipc_collision_mesh.hpp>

#include "check.h"

namespace {

using Eigen::MatrixXd;
using Eigen::MatrixXi;
using exact_ccd::CollisionDetector;
using exact_ccd::Kind;
using exact_ccd::Point;

MatrixXi two_columns(std::initializer_list<std::array<int, 2>> rows)
{
    MatrixXi matrix(rows.size(), 2);
    Eigen::Index row = 0;
    for (const auto& [a, b] : rows) {
        matrix.row(row++) << a, b;
    }
    return matrix;
}

// A mesh that ends before the detector.
static_assert(!std::is_constructible_v<CollisionDetector, ipc::CollisionMesh>);
static_assert(std::is_constructible_v<CollisionDetector, const ipc::CollisionMesh&>);

// A triangle that falls on another.
struct Triangles {
    MatrixXd x0{6, 3}, x1;
    MatrixXi edges = two_columns({{0, 1}, {1, 2}, {0, 2}, {3, 4}, {4, 5}, {3, 5}}), faces{2, 3};

    Triangles()
    {
        x0 << 0, 0, 0, 8, 0, 0, 0, 8, 0, 1, 1, 1, 1, 2, 5, 2, 1, 5;
        faces << 0, 1, 2, 3, 4, 5;
        x1 = x0;
        x1.bottomRows(3).col(2).array() -= 2;
    }
};

bool nothing(std::size_t, std::size_t) { return false; }
int no_pair(std::size_t, std::size_t) { return 0; }

void filters()
{
    const Triangles scene;
    ipc::CollisionMesh mesh(scene.x0, scene.edges, scene.faces);
    CollisionDetector detector(mesh);
    const auto is_free = [&] { return detector.is_step_collision_free(scene.x0, scene.x1); };
    CHECK(!is_free() && detector.has_intersections(scene.x1) && !detector.has_intersections(scene.x0));
    // The filter of the mesh may change between two calls.
    mesh.can_collide = [](std::size_t, std::size_t) { return false; };
    CHECK(is_free() && !detector.has_intersections(scene.x1));
    const std::vector<int> patch{0, 0, 0, 1, 1, 1};
    mesh.can_collide = [patch](std::size_t a, std::size_t b) { return patch[a] != patch[b]; };
    CHECK(!is_free() && detector.has_intersections(scene.x1));
    // One pair of vertices is enough, in this order or in the other.
    mesh.can_collide = [](std::size_t a, std::size_t b) { return a + b == 5 && a * b == 0; };
    CHECK(is_free());
    mesh.can_collide = [](std::size_t a, std::size_t b) { return a + b == 3 && a * b == 0; };
    CHECK(!is_free());
    // Plain functions that are not the default one.
    mesh.can_collide = nothing;
    CHECK(is_free());
    mesh.can_collide = no_pair;
    CHECK(is_free());
    mesh.can_collide = ipc::CollisionMesh().can_collide;
    CHECK(!is_free());
}

void step_sizes()
{
    const Triangles scene;
    const ipc::CollisionMesh mesh(scene.x0, scene.edges, scene.faces);
    CollisionDetector detector(mesh);
    CHECK(detector.compute_collision_free_stepsize(scene.x0, scene.x1) == 0.45);
    CHECK(detector.compute_collision_free_stepsize(scene.x0, scene.x1, 0.5) == 0.225);
    CHECK(detector.compute_collision_free_stepsize(scene.x0, scene.x0) == 1);
    // With the whole time of impact, the rounded positions are still free of contact.
    const double size = detector.compute_collision_free_stepsize(scene.x0, scene.x1, 0.0, 1.0);
    CHECK(size < 0.5 && size > 0.5 - 1e-15);
    const MatrixXd x = scene.x0 + size * (scene.x1 - scene.x0);
    CHECK(detector.is_step_collision_free(scene.x0, x));
    const auto [same_size, positions] = detector.free_step(scene.x0, scene.x1, 0.0, 1.0);
    CHECK(same_size == size && positions == x);
    CHECK(detector.free_step(scene.x0, scene.x0).second == scene.x0);
}

MatrixXd plane(std::initializer_list<std::array<double, 2>> rows)
{
    MatrixXd matrix(rows.size(), 2);
    Eigen::Index row = 0;
    for (const auto& [x, y] : rows) {
        matrix.row(row++) << x, y;
    }
    return matrix;
}

void two_dimensions()
{
    // Two edges with a common vertex: the free end of one passes through the other.
    const MatrixXd x0 = plane({{1, 1}, {0, 0}, {2, 0}}), x1 = plane({{1, -1}, {0, 0}, {2, 0}});
    ipc::CollisionMesh fold(x0, two_columns({{0, 1}, {1, 2}}));
    CollisionDetector detector(fold);
    CHECK(!detector.is_step_collision_free(x0, x1));
    CHECK(detector.compute_collision_free_stepsize(x0, x1) == 0.45);
    CHECK(detector.compute_collision_free_stepsize(x0, x1, 0.5) == 0.225);
    const auto [size, x] = detector.free_step(x0, x1);
    CHECK(size == 0.45 && x == x0 + size * (x1 - x0));
    CHECK(!detector.has_intersections(x0) && !detector.has_intersections(x1));
    // The vertex and one end of the edge are enough; both ends of the edge are not.
    fold.can_collide = [](std::size_t a, std::size_t b) { return a + b == 2 && a != b; };
    CHECK(!detector.is_step_collision_free(x0, x1));
    fold.can_collide = [](std::size_t a, std::size_t b) { return a == b || a + b == 3; };
    CHECK(detector.is_step_collision_free(x0, x1));

    // Two edges that cross at rest are no contact of a vertex.
    const MatrixXd crossing = plane({{-1, 0}, {1, 0}, {0, -1}, {0, 1}});
    ipc::CollisionMesh cross(crossing, two_columns({{0, 1}, {2, 3}}));
    CollisionDetector of_cross(cross);
    CHECK(of_cross.has_intersections(crossing));
    CHECK(of_cross.compute_collision_free_stepsize(crossing, crossing) == 1);
    cross.can_collide = [](std::size_t, std::size_t) { return false; };
    CHECK(!of_cross.has_intersections(crossing));

    // Vertices without edges that meet.
    const MatrixXd points = plane({{0, 0}, {4, 0}}), swapped = plane({{4, 0}, {0, 0}});
    const ipc::CollisionMesh loose(points);
    CHECK(CollisionDetector(loose).compute_collision_free_stepsize(points, swapped) == 0.45);
    CHECK(CollisionDetector(loose).compute_collision_free_stepsize(points, swapped, 2) == 0.225);
}

Point of_row(const MatrixXd& x, Eigen::Index row) { return {x(row, 0), x(row, 1), 0.0}; }

// The first time of all vertices and edges of a polyline, one pair after the other.
double first_time(const MatrixXd& x0, const MatrixXd& x1, const MatrixXi& edges, double distance)
{
    double first = 2;
    for (Eigen::Index edge = 0; edge < edges.rows(); ++edge) {
        for (Eigen::Index vertex = 0; vertex < x0.rows(); ++vertex) {
            const int a = edges(edge, 0), b = edges(edge, 1);
            if (vertex != a && vertex != b) {
                const std::array<Point, 3> start{of_row(x0, vertex), of_row(x0, a), of_row(x0, b)};
                const std::array<Point, 3> end{of_row(x1, vertex), of_row(x1, a), of_row(x1, b)};
                const auto time = exact_ccd::time_of_impact(Kind::vertex_edge, start, end, distance);
                first = std::min(first, time.value_or(2));
            }
        }
    }
    return first;
}

void random_polylines()
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    const MatrixXi edges = two_columns({{0, 1}, {1, 2}, {2, 3}, {3, 4}, {5, 6}, {6, 7}, {7, 5}});
    int free = 0, not_free = 0;
    for (int i = 0; i < 300; ++i) {
        const MatrixXd x0 = MatrixXd::NullaryExpr(8, 2, [&] { return unit(random); });
        const MatrixXd x1 = x0 + MatrixXd::NullaryExpr(8, 2, [&] { return 0.1 * unit(random); });
        const ipc::CollisionMesh mesh(x0, edges);
        CollisionDetector detector(mesh);
        for (const double distance : {0.0, 0.01}) {
            const double first = first_time(x0, x1, edges, distance);
            const double size = detector.compute_collision_free_stepsize(x0, x1, distance);
            CHECK(detector.is_step_collision_free(x0, x1, distance) == (first > 1));
            CHECK(first > 1 ? size == 1 : size <= 0.9 * first && size >= 0.9 * first - 1e-12);
            ++(first > 1 ? free : not_free);
        }
    }
    CHECK(free > 50 && not_free > 50);
}

template <typename Call>
bool throws(Call call)
{
    try {
        call();
    } catch (const std::invalid_argument&) {
        return true;
    }
    return false;
}

void arguments()
{
    const Triangles scene;
    ipc::CollisionMesh mesh(scene.x0, scene.edges, scene.faces);
    CollisionDetector detector(mesh);
    const MatrixXd fewer = scene.x0.topRows(5), flat = scene.x0.leftCols(2);
    CHECK(throws([&] { detector.is_step_collision_free(scene.x0, fewer); }));
    CHECK(throws([&] { detector.has_intersections(flat); }));
#ifndef IPC_BEFORE_1_6
    mesh.planes.emplace_back(Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 0, 0));
    CHECK(throws([&] { detector.is_step_collision_free(scene.x0, scene.x1); }));
    CHECK(throws([&] { detector.compute_collision_free_stepsize(scene.x0, scene.x1); }));
    CHECK(throws([&] { detector.has_intersections(scene.x0); }));
#endif
}

}  // namespace

int main()
{
    filters();
    step_sizes();
    two_dimensions();
    random_polylines();
    arguments();
    return 0;
}
