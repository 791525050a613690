// The floating-point environment of the host changes no answer, and survives each call; several
// threads use the library at the same time.

#include <cfenv>
#include <random>
#include <thread>

#include <exact_ccd.hpp>

#include "check.h"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace {

using exact_ccd::Kind;
using exact_ccd::Point;

struct Answers {
    std::vector<double> times;
    std::vector<exact_ccd::Contact> contacts;
};

struct Scene {
    double unit;
    std::vector<Point> x0, x1;
    std::vector<std::array<std::uint32_t, 3>> faces;
    std::vector<std::uint32_t> queries;
};

// Random triangles in units of `unit`, down to subnormal numbers; made in the standard environment.
Scene scene(double unit)
{
    std::mt19937_64 random(1);
    Scene scene{unit, std::vector<Point>(300), std::vector<Point>(300), {}, {}};
    for (auto* points : {&scene.x0, &scene.x1}) {
        for (auto& point : *points) {
            for (double& x : point) {
                x = static_cast<double>(static_cast<int>(random() % 17) - 8) * unit;
            }
        }
    }
    for (std::uint32_t first = 0; first < 300; first += 3) {
        scene.faces.push_back({first, first + 1, first + 2});
    }
    for (int i = 0; i < 4000; ++i) {
        scene.queries.push_back(static_cast<std::uint32_t>(random() % 300));
    }
    return scene;
}

Answers answers(const Scene& scene)
{
    const auto& [unit, x0, x1, faces, queries] = scene;
    Answers answers;
    answers.times = exact_ccd::times_of_impact(Kind::vertex_face, x0, x1, queries);
    const auto edges = exact_ccd::times_of_impact(Kind::edge_edge, x0, x1, queries, unit);
    answers.times.insert(answers.times.end(), edges.begin(), edges.end());
    const exact_ccd::Mesh mesh(x0.size(), faces);
    answers.contacts = exact_ccd::Detector(mesh).contacts(x0, x1);
    return answers;
}

bool same(const Answers& a, const Answers& b)
{
    if (a.times.size() != b.times.size() || a.contacts.size() != b.contacts.size()) {
        return false;
    }
    for (std::size_t i = 0; i < a.times.size(); ++i) {
        if (a.times[i] != b.times[i] && !(std::isnan(a.times[i]) && std::isnan(b.times[i]))) {
            return false;
        }
    }
    for (std::size_t i = 0; i < a.contacts.size(); ++i) {
        if (a.contacts[i].impact.time != b.contacts[i].impact.time
            || a.contacts[i].first != b.contacts[i].first || a.contacts[i].second != b.contacts[i].second) {
            return false;
        }
    }
    return true;
}

}  // namespace

int main()
{
    const double smallest = 4.9406564584124654e-324;
    const Scene units = scene(1), tiny = scene(smallest);
    const Answers normal = answers(units), subnormal = answers(tiny);
    CHECK(!normal.contacts.empty() && normal.contacts.size() == subnormal.contacts.size());

#if defined(__SSE2__)
    const unsigned standard = _mm_getcsr();
    _mm_setcsr(standard | 0x8040);  // flush to zero, denormals are zero
    const Answers flushed = answers(tiny);
    CHECK(_mm_getcsr() >> 6 == (standard | 0x8040) >> 6);
    _mm_setcsr(standard);
    CHECK(same(subnormal, flushed));
#endif

    for (int rounding : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        CHECK(std::fesetround(rounding) == 0);
        const Answers rounded = answers(units);
        CHECK(std::fegetround() == rounding);
        std::fesetround(FE_TONEAREST);
        CHECK(same(normal, rounded));
    }

    std::vector<std::thread> threads;
    std::vector<Answers> of_threads(4);
    for (auto& mine : of_threads) {
        threads.emplace_back([&mine, &units] { mine = answers(units); });
    }
    for (auto& thread : threads) {
        thread.join();
    }
    for (const auto& mine : of_threads) {
        CHECK(same(normal, mine));
    }
    return 0;
}
