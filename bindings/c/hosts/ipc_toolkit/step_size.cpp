// The step size of each scene, by the IPC Toolkit and by exact-ccd, in turns:
//
//   step_size DATA/scenes [ROUNDS]
//
// Prints, for each contestant, the median time, the median processor time of all its threads, which other
// programs disturb less, and the quotients of both by the times of the batch adapter. All use all cores.
// Making the mesh and the detector is not counted, for none of them.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include <exact_ccd/ipc_collision_mesh.hpp>
#include <ipc/ccd/additive_ccd.hpp>
#include <ipc/ipc.hpp>

#include "scene.hpp"

namespace {

struct Contestant {
    const char* name;
    std::function<double()> step_size;
    double size = 0;
    std::vector<double> milliseconds = {}, of_processor = {};

    void run()
    {
        const std::clock_t before = std::clock();
        const auto start = std::chrono::steady_clock::now();
        size = step_size();
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
        milliseconds.push_back(time.count());
        of_processor.push_back(1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
    }
};

double median(std::vector<double> times)
{
    const auto middle = times.begin() + times.size() / 2;
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
}

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
    const double ours = median(contestants[0].milliseconds), ours_of_processor = median(contestants[0].of_processor);
    for (const auto& contestant : contestants) {
        const double time = median(contestant.milliseconds), of_processor = median(contestant.of_processor);
        std::printf("  %-36s %9.1f ms %7.2f  processor %9.1f ms %7.2f  size %.17g\n",
                    contestant.name, time, time / ours, of_processor, of_processor / ours_of_processor, contestant.size);
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
