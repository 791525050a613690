// Random scenes, and all that the library answers about them.

#ifndef EXACT_CCD_TESTS_ANSWERS_HPP
#define EXACT_CCD_TESTS_ANSWERS_HPP

#include <random>

#include <exact_ccd.hpp>

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
inline Scene scene(double unit)
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

inline Answers answers(const Scene& scene)
{
    const auto& [unit, x0, x1, faces, queries] = scene;
    Answers answers;
    answers.times = exact_ccd::times_of_impact(Kind::vertex_face, x0, x1, queries);
    const auto edges = exact_ccd::times_of_impact(Kind::edge_edge, x0, x1, queries, unit);
    answers.times.insert(answers.times.end(), edges.begin(), edges.end());
    const exact_ccd::Mesh mesh(x0.size(), faces);
    answers.contacts = exact_ccd::Detector(mesh).collisions(x0, x1);
    return answers;
}

inline bool same(const Answers& a, const Answers& b)
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

#endif
