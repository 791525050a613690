// A square of cloth falls on a larger one: the largest certified step, and its contacts.

#include <cstdint>
#include <cstdio>
#include <exception>
#include <vector>

#include <exact_ccd.hpp>

namespace {

// A square of n by n vertices around the z axis.
void add_square(std::size_t n, double size, double z, double turn, std::vector<exact_ccd::Point>& x)
{
    for (std::size_t i = 0; i < n * n; ++i) {
        const double u = size * (double(i % n) / double(n - 1) - 0.5);
        const double v = size * (double(i / n) / double(n - 1) - 0.5);
        x.push_back({u - turn * v, v + turn * u, z});
    }
}

void add_faces(std::uint32_t n, std::uint32_t first, std::vector<std::array<std::uint32_t, 3>>& faces)
{
    for (std::uint32_t j = 0; j + 1 < n; ++j) {
        for (std::uint32_t i = 0; i + 1 < n; ++i) {
            const std::uint32_t a = first + j * n + i, b = a + 1, c = a + n, d = c + 1;
            faces.push_back({a, b, d});
            faces.push_back({a, d, c});
        }
    }
}

}  // namespace

int main()
{
    const std::uint32_t n = 20;
    std::vector<exact_ccd::Point> x0;
    std::vector<std::array<std::uint32_t, 3>> faces;
    add_square(n, 2.0, 0.0, 0.0, x0);
    add_square(n, 1.0, 1.0, 0.3, x0);
    add_faces(n, 0, faces);
    add_faces(n, n * n, faces);

    auto x1 = x0;
    for (std::size_t i = n * n; i < x1.size(); ++i) {
        x1[i][2] = -1.0;
    }

    try {
        const exact_ccd::Mesh mesh(x0.size(), faces);
        exact_ccd::Detector detector(mesh);
        detector.set_min_distance(0.01);
        const auto step = detector.free_step(x0, x1);
        std::printf("certified step: %.17g\n", step.size);
        std::printf("contacts in the full step: %zu\n", detector.collisions(x0, x1).size());
        return detector.collides(x0, step.positions) ? 1 : 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
