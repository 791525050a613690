// Both phases by CollisionDetector against the phases of the IPC Toolkit with ExactCCD: the same steps on
// random meshes, in three and two dimensions, with codimensional vertices and edges, with a minimum
// distance, and with can_collide.

#include <random>

#include <exact_ccd/ipc_collision_mesh.hpp>
#include <ipc/ipc.hpp>

#include "check.h"

namespace {

using Eigen::MatrixXd;
using Eigen::MatrixXi;

class Random {
public:
    explicit Random(std::uint64_t seed) : random_(seed) {}

    MatrixXd positions(Eigen::Index rows, Eigen::Index columns)
    {
        std::uniform_real_distribution<double> unit(-1, 1);
        return MatrixXd::NullaryExpr(rows, columns, [&] { return unit(random_); });
    }

private:
    std::mt19937_64 random_;
};

// Triangles 3 i, 3 i + 1, 3 i + 2 with their edges.
std::pair<MatrixXi, MatrixXi> triangles(int count)
{
    MatrixXi edges(3 * count, 2), faces(count, 3);
    for (int i = 0; i < count; ++i) {
        const int a = 3 * i, b = a + 1, c = a + 2;
        faces.row(i) << a, b, c;
        edges.middleRows(a, 3) << a, b, b, c, a, c;
    }
    return {edges, faces};
}

struct Counts {
    int free = 0, not_free = 0;
};

void compare(
    const ipc::CollisionMesh& mesh, const MatrixXd& x0, const MatrixXd& x1, double distance, Counts& counts)
{
    // Without rescaling, the minimum over all pairs does not depend on their order.
    const exact_ccd::ExactCCD narrow_phase(1.0);
    exact_ccd::CollisionDetector detector(mesh);
    const bool is_free = detector.is_step_collision_free(x0, x1, distance);
    CHECK(is_free == ipc::is_step_collision_free(mesh, x0, x1, distance, nullptr, narrow_phase));
    const double time = ipc::compute_collision_free_stepsize(mesh, x0, x1, distance, nullptr, narrow_phase);
    for (const double rescaling : {0.9, 1.0}) {
        const double size = detector.compute_collision_free_stepsize(x0, x1, distance, rescaling);
        // Certified for the rounded positions: less by some units in its last place.
        const double most = rescaling * time;
        CHECK(is_free ? size == 1.0 : size <= most && size >= most - 1e-12);
    }
    ++(is_free ? counts.free : counts.not_free);
}

void surfaces(Random& random, Counts& counts)
{
    const int count = 12;
    const auto [edges, faces] = triangles(count);
    // Small triangles at random places, in small motion.
    MatrixXd x0 = 0.2 * random.positions(3 * count, 3);
    const MatrixXd centres = random.positions(count, 3);
    for (int i = 0; i < 3 * count; ++i) {
        x0.row(i) += centres.row(i / 3);
    }
    const MatrixXd x1 = x0 + 0.1 * random.positions(3 * count, 3);
    ipc::CollisionMesh mesh(x0, edges, faces);
    compare(mesh, x0, x1, 0.0, counts);
    compare(mesh, x0, x1, 1e-3, counts);
    exact_ccd::CollisionDetector detector(mesh);
    CHECK(detector.has_intersections(x0) == ipc::has_intersections(mesh, x0));
    mesh.can_collide = [](std::size_t a, std::size_t b) { return (a + b) % 3 == 0; };
    compare(mesh, x0, x1, 0.0, counts);
    mesh.can_collide = [](std::size_t, std::size_t) { return false; };
    CHECK(exact_ccd::CollisionDetector(mesh).is_step_collision_free(x0, x1));
}

// A triangle, two edges of no face and two vertices of no edge.
void codimensional(Random& random, Counts& counts)
{
    MatrixXi edges(5, 2), faces(1, 3);
    edges << 0, 1, 1, 2, 0, 2, 3, 4, 5, 6;
    faces << 0, 1, 2;
    const MatrixXd x0 = random.positions(9, 3), x1 = x0 + 0.3 * random.positions(9, 3);
    compare(ipc::CollisionMesh(x0, edges, faces), x0, x1, 0.05, counts);
}

void plane(Random& random, Counts& counts)
{
    // Each edge starts in its own square.
    const int count = 9;
    MatrixXi edges(count, 2);
    MatrixXd x0 = 0.4 * random.positions(2 * count, 2);
    for (int i = 0; i < count; ++i) {
        edges.row(i) << 2 * i, 2 * i + 1;
        for (int end : {2 * i, 2 * i + 1}) {
            x0.row(end) += Eigen::RowVector2d(i % 3, i / 3);
        }
    }
    const MatrixXd x1 = x0 + 0.3 * random.positions(2 * count, 2);
    compare(ipc::CollisionMesh(x0, edges, MatrixXi(0, 3)), x0, x1, 0.0, counts);
    compare(ipc::CollisionMesh(x0, edges, MatrixXi(0, 3)), x0, x1, 1e-3, counts);
}

}  // namespace

int main()
{
    Random random(1);
    for (const auto& [name, steps] : {std::pair("surfaces", surfaces),
                                      std::pair("codimensional", codimensional),
                                      std::pair("plane", plane)}) {
        Counts counts;
        for (int i = 0; i < 200; ++i) {
            steps(random, counts);
        }
        std::printf("%s: %d steps free, %d not\n", name, counts.free, counts.not_free);
        CHECK(counts.free > 0 && counts.not_free > 0);
    }
    return 0;
}
