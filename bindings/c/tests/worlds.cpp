// Many worlds in C++: each world has the answers of a detector.

#include <cstring>

#include <exact_ccd.hpp>

#include "check.h"

using exact_ccd::Contact;
using exact_ccd::Point;

namespace {

constexpr std::size_t VERTEX_COUNT = 6;

bool same(const Contact& a, const Contact& b)
{
    return a.kind == b.kind && a.first == b.first && a.second == b.second
           && std::memcmp(a.impact.points, b.impact.points, sizeof a.impact.points) == 0
           && a.impact.time == b.impact.time;
}

bool same(const std::optional<Contact>& a, const std::optional<Contact>& b)
{
    return a.has_value() == b.has_value() && (!a || same(*a, *b));
}

// The detector and the worlds have the same settings.
void compare(exact_ccd::Detector& detector,
             const exact_ccd::Worlds& worlds,
             const std::vector<Point>& x0,
             const std::vector<Point>& x1,
             std::size_t expected)
{
    const auto collides = worlds.collides(x0, x1), early = worlds.collides(x0, x1, 0.25);
    const auto earliest = worlds.collision(x0, x1);
    const auto all = worlds.collisions(x0, x1);
    const auto steps = worlds.free_step(x0, x1, 0.5);
    const std::size_t count = x0.size() / VERTEX_COUNT;
    CHECK(collides.size() == count && earliest.size() == count && all.size() == count);
    CHECK(steps.sizes.size() == count && steps.contacts.size() == count && steps.positions.size() == x0.size());
    std::size_t found = 0;
    for (std::size_t world = 0; world < count; ++world) {
        const exact_ccd::Points start(x0[world * VERTEX_COUNT].data(), VERTEX_COUNT);
        const exact_ccd::Points end(x1[world * VERTEX_COUNT].data(), VERTEX_COUNT);
        CHECK(collides[world] == detector.collides(start, end));
        CHECK(early[world] == detector.collides(start, end, 0.25));
        CHECK(same(earliest[world], detector.collision(start, end)));
        const auto contacts = detector.collisions(start, end);
        CHECK(all[world].size() == contacts.size());
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            CHECK(same(all[world][i], contacts[i]));
        }
        const auto step = detector.free_step(start, end, 0.5);
        CHECK(steps.sizes[world] == step.size && same(steps.contacts[world], step.contact));
        for (std::size_t i = 0; i < VERTEX_COUNT; ++i) {
            CHECK(steps.positions[world * VERTEX_COUNT + i] == step.positions[i]);
        }
        found += collides[world];
    }
    CHECK(found == expected);
}

template <typename Exception, typename Call>
void throws(Call call, const char* words)
{
    try {
        call();
    } catch (const Exception& error) {
        CHECK(std::strstr(error.what(), words));
        return;
    }
    CHECK(!"an exception is thrown");
}

}  // namespace

int main()
{
    // In each world, a triangle falls onto another one, at a speed of its own.
    const std::vector<std::array<std::uint32_t, 3>> faces{{0, 1, 2}, {3, 4, 5}};
    const std::vector<double> falls{0, 0.5, 1, 2, 8};
    std::vector<Point> x0, x1;
    for (const double fall : falls) {
        for (const Point& x : {Point{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}) {
            x0.push_back(x);
            x1.push_back(x);
        }
        for (const Point& x : {Point{1, 1, 1}, {1, 2, 5}, {2, 1, 5}}) {
            x0.push_back(x);
            x1.push_back({x[0], x[1], x[2] - fall});
        }
    }
    const exact_ccd::Mesh mesh(VERTEX_COUNT, faces);
    exact_ccd::Detector detector(mesh);
    exact_ccd::Worlds worlds(mesh);
    compare(detector, worlds, x0, x1, 3);
    detector.set_min_distance(0.5);
    worlds.set_min_distance(0.5);
    compare(detector, worlds, x0, x1, 4);
    const auto rule = [](std::uint32_t a, std::uint32_t b) { return a == b; };
    detector.set_can_collide(rule);
    worlds.set_can_collide(rule);
    compare(detector, worlds, x0, x1, 0);

    CHECK(worlds.collides({}, {}).empty() && worlds.free_step({}, {}).sizes.empty());
    const exact_ccd::Worlds empty(exact_ccd::Mesh(0, {}));
    CHECK(empty.collision({}, {}).empty());
    throws<std::invalid_argument>([&] { empty.collides(x0, x1); }, "expected a multiple");
    const exact_ccd::Points fewer(x0[0].data(), 7);
    throws<std::invalid_argument>([&] { worlds.collides(fewer, fewer); }, "7 positions, expected a multiple");
    throws<std::invalid_argument>([&] { worlds.collides(x0, fewer); }, "7 positions at t = 1");
    x0[2 * VERTEX_COUNT + 1][0] = std::nan("");
    throws<exact_ccd::Error>([&] { worlds.collisions(x0, x1); }, "world 2: at the start, vertex 1");
    return 0;
}
