// The step size of each scene, by the IPC Toolkit and by exact-ccd, in turns:
//
//   step_size DATA/scenes [ROUNDS]
//
// Prints the median time of each contestant and its quotient by that of the batch adapter. All use all
// cores. Making the mesh and the detector is not counted, for none of them.

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include <exact_ccd/ipc_collision_mesh.hpp>
#include <ipc/ccd/additive_ccd.hpp>
#include <ipc/ipc.hpp>

#include "scene.hpp"

namespace {

struct Contestant {
    const char* name;
    std::function<double()> step_size;
    double size = 0;
    std::vector<double> milliseconds = {};

    void run()
    {
        const auto start = std::chrono::steady_clock::now();
        size = step_size();
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
        milliseconds.push_back(time.count());
    }

    double median()
    {
        const auto middle = milliseconds.begin() + milliseconds.size() / 2;
        std::nth_element(milliseconds.begin(), middle, milliseconds.end());
        return *middle;
    }
};

void compare(const std::filesystem::path& folder, int rounds)
{
    const Scene scene = read_scene(folder);
    const ipc::CollisionMesh mesh(scene.x0, scene.edges, scene.faces);
    ipc::CollisionMesh filtered_mesh = mesh;
    filtered_mesh.can_collide = [](std::size_t, std::size_t) { return true; };
    exact_ccd::CollisionDetector detector(mesh), filtered(filtered_mesh);
    const auto with = [&](const ipc::NarrowPhaseCCD& narrow_phase) {
        return ipc::compute_collision_free_stepsize(mesh, scene.x0, scene.x1, 0, nullptr, narrow_phase);
    };
    std::vector<Contestant> contestants{
        {"CollisionDetector", [&] { return detector.compute_collision_free_stepsize(scene.x0, scene.x1); }},
        {"CollisionDetector with can_collide",
         [&] { return filtered.compute_collision_free_stepsize(scene.x0, scene.x1); }},
        {"toolkit, Tight Inclusion", [&] { return with(ipc::TightInclusionCCD()); }},
        {"toolkit, Additive", [&] { return with(ipc::AdditiveCCD()); }},
        {"toolkit, ExactCCD", [&] { return with(exact_ccd::ExactCCD()); }},
    };
    for (int round = 0; round < rounds; ++round) {
        for (auto& contestant : contestants) {
            contestant.run();
        }
    }
    std::printf("%s\n", folder.filename().c_str());
    const double ours = contestants[0].median();
    for (auto& contestant : contestants) {
        const double time = contestant.median();
        std::printf("  %-36s %9.1f ms %7.2f  size %.17g\n", contestant.name, time, time / ours, contestant.size);
    }
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc < 2) {
        std::fprintf(stderr, "step_size DATA/scenes [ROUNDS]\n");
        return 2;
    }
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 5;
    for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
        compare(entry.path(), rounds);
    }
    return 0;
}
