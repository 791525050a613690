// The C++ interface: views, exceptions, optional results.

#include <mutex>
#include <set>
#include <thread>

#include <exact_ccd.hpp>

#include "check.h"

using exact_ccd::Kind;
using exact_ccd::Point;

namespace {

struct Vector {
    double x, y, z;
};

}  // namespace

template <>
struct exact_ccd::is_element<Vector, double, 3> : std::true_type {};

namespace {

// Numbers of another type or another count are no elements, even of the right size.
template <typename View, typename Container>
constexpr bool views = std::is_constructible_v<View, Container>;
using Indices = exact_ccd::View<std::uint32_t, 1>;
using Numbers = exact_ccd::View<double, 1>;

static_assert(views<exact_ccd::Points, std::vector<Vector>> && views<exact_ccd::Points, std::array<double[3], 4>>);
static_assert(views<Numbers, std::vector<double>> && views<Numbers, std::array<double, 2>>);
static_assert(views<exact_ccd::Edges, std::vector<std::array<std::uint32_t, 2>>>);
static_assert(!views<Numbers, std::vector<std::int64_t>> && !views<Numbers, std::vector<Vector>>);
static_assert(!views<Indices, std::vector<float>> && !views<Indices, std::vector<std::int32_t>>);
static_assert(!views<exact_ccd::Edges, std::vector<double>> && !views<exact_ccd::Points, std::vector<double>>);
struct Other {
    double x, y, z;
};
static_assert(!views<exact_ccd::Points, std::vector<Other>>);

void queries()
{
    const std::array<Point, 4> start{{{0.25, 0.25, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    auto end = start;
    end[0][2] = -1;
    CHECK(exact_ccd::collides(Kind::vertex_face, start, end));
    CHECK(exact_ccd::time_of_impact(Kind::vertex_face, start, end) == 0.5);
    CHECK(exact_ccd::time_of_impact(Kind::vertex_face, start, end, 0.5) == 0.25);
    CHECK(!exact_ccd::time_of_impact(Kind::vertex_face, start, start));
    CHECK(exact_ccd::impact(Kind::vertex_face, start, end)->has_normal);
    CHECK(!exact_ccd::impact(Kind::vertex_face, start, start));
    CHECK(exact_ccd::intervals(Kind::vertex_face, start, end, 0.5).size() == 1);
    CHECK(exact_ccd::intervals(Kind::vertex_face, start, start, 0.5).empty());
    CHECK(exact_ccd::distance_at(Kind::vertex_face, start, end, 0.25).first == 0.5);

    // Points of any layout of three doubles.
    const std::vector<Vector> points_start{{0, 3, -8}, {0, 0, 0}}, points_end{{0, 3, 8}, {0, 0, 0}};
    CHECK(exact_ccd::time_of_impact(Kind::vertex_vertex, points_start, points_end, 5) == 0.25);

    const std::vector<std::uint32_t> indices{0, 1, 2, 3, 0, 1, 2, 3};
    const auto times = exact_ccd::times_of_impact(Kind::vertex_face, start, end, indices);
    CHECK(times.size() == 2 && times[0] == 0.5 && times[1] == 0.5);
    const std::vector<double> thickness{0.25, 0, 0.25, 0};
    const auto thick = exact_ccd::times_of_impact_thick(Kind::vertex_face, start, end, indices, thickness);
    CHECK(thick.size() == 2 && thick[0] == 0.25 && thick[1] == 0.25);
}

template <typename Exception, typename Call>
void throws(Call call)
{
    try {
        call();
    } catch (const Exception& error) {
        CHECK(error.what()[0] != '\0');
        return;
    }
    CHECK(!"an exception is thrown");
}

void errors()
{
    const std::array<Point, 4> start{{{0.25, 0.25, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    throws<std::invalid_argument>([&] { exact_ccd::collides(Kind::vertex_edge, start, start); });
    throws<exact_ccd::Error>([&] { exact_ccd::collides(Kind::vertex_face, start, start, -1); });
    const std::vector<std::uint32_t> three{0, 1, 2};
    throws<std::invalid_argument>([&] { exact_ccd::times_of_impact(Kind::vertex_face, start, start, three); });
    const std::vector<std::uint32_t> four{0, 1, 2, 3};
    const std::vector<double> few{0, 0, 0};
    throws<std::invalid_argument>(
        [&] { exact_ccd::times_of_impact_thick(Kind::vertex_face, start, start, four, few); });
    const std::vector<std::uint32_t> second_is_wrong{0, 1, 2, 3, 0, 1, 2, 4};
    try {
        exact_ccd::times_of_impact(Kind::vertex_face, start, start, second_is_wrong);
        CHECK(!"vertex 4 does not exist");
    } catch (const exact_ccd::Error& error) {
        CHECK(error.query() == 1 && error.status() == EXACT_CCD_STATUS_INVALID_MESH);
    }
    const std::vector<std::array<std::uint32_t, 3>> faces{{0, 1, 4}};
    throws<exact_ccd::Error>([&] { exact_ccd::Mesh(4, faces); });
}

void meshes()
{
    const std::vector<std::array<std::uint32_t, 3>> faces{{0, 1, 2}, {3, 4, 5}};
    const std::vector<Point> x0{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {1, 1, 1}, {1, 2, 5}, {2, 1, 5}};
    auto x1 = x0;
    for (std::size_t vertex = 3; vertex < 6; ++vertex) {
        x1[vertex][2] -= 2;
    }
    const exact_ccd::Mesh mesh(x0.size(), faces);
    CHECK(mesh.edges().size() == 6);

    exact_ccd::Detector detector(mesh);
    CHECK(!detector.has_intersections(x0) && detector.has_intersections(x1));
    CHECK(!detector.intersection(x0));
    const auto intersection = detector.intersection(x1);
    CHECK(intersection && intersection->face == 0 && intersection->edge < 6);
    CHECK(!detector.collides(x1, x1));
    detector.set_start_check(true);
    try {
        detector.collides(x1, x1);
        CHECK(!"the mesh is pierced at the start");
    } catch (const exact_ccd::Error& error) {
        CHECK(error.status() == EXACT_CCD_STATUS_CROSSING && !error.query());
        CHECK(error.edge() == intersection->edge && error.face() == intersection->face);
    }
    CHECK(detector.collides(x0, x1) && !detector.collides(x0, x1, 0.25));
    CHECK(detector.collision(x0, x1)->impact.time == 0.5);
    CHECK(detector.collisions(x0, x1).size() == 1 && detector.collisions(x0, x1, 0.25).empty());
    const auto step = detector.free_step(x0, x1);
    CHECK(step.size == 0.45 && !detector.collides(x0, step.positions));
    CHECK(step.contact && step.contact->impact.time == 0.5 && !detector.free_step(x0, x0).contact);
    const auto steps = detector.free_steps(x0, x1);
    CHECK(steps.sizes[3] < 0.5 && steps.blocked.empty() && steps.rounds > 1);
    CHECK(!detector.collides(x0, steps.positions));
    const std::vector<std::uint32_t> falling{3, 4, 5};
    const auto first = detector.first_contacts(x0, x1);
    CHECK(first.contacts.size() == 1 && first.first[3] == 0 && first.first[4] == 1);
    CHECK(first.times[3] == 0.5 && std::isinf(first.times[4]));
    CHECK(detector.clearances(x0, 0.125) == std::vector<double>(6, 0.125));
    throws<exact_ccd::Error>([&] { detector.clearances(x0, -1); });
    const auto with_pinned = detector.free_steps(x0, x1, falling);
    CHECK(with_pinned.sizes[3] == 1 && with_pinned.positions[3] == x1[3]);
    CHECK(with_pinned.blocked.size() == 1 && with_pinned.blocked[0].first == 3);
    // The magic line, the distance and the flags: at rest, free, contact.
    const auto certificate = detector.certificate(x0, x1);
    CHECK(certificate.size() > 50 && certificate[0] == 'e' && certificate[32] == 7);
    CHECK(detector.certificate(x0, x1, false)[32] == 6);
    throws<exact_ccd::Error>([&] { detector.certificate(x1, x0); });
    detector.set_min_distance(0.5);
    CHECK(detector.collision(x0, x1)->impact.time == 0.25);
    throws<std::invalid_argument>([&] { detector.collides(x0, exact_ccd::Points(x1.data()->data(), 5)); });

    exact_ccd::Audit audit(mesh);
    audit.certify();
    CHECK(!audit.examine(x0));
    CHECK(audit.examine(x1)->contact.impact.time == 0.5);
    CHECK(audit.certificate() == certificate);
}

// The threads on which a detector of some triangles calls its rule.
std::set<std::thread::id> threads_of(exact_ccd::Detector& detector)
{
    std::mutex mutex;
    std::set<std::thread::id> threads;
    detector.set_can_collide([&](std::uint32_t, std::uint32_t) {
        const std::lock_guard<std::mutex> lock(mutex);
        threads.insert(std::this_thread::get_id());
        return true;
    });
    std::vector<Point> x;
    for (int i = 0; i < 6 * 40; ++i) {
        x.push_back({double(i % 2), double(i % 3), 0.25 * double(i % 5)});
    }
    CHECK(detector.collisions(x, x).size() > 100);
    detector.set_can_collide(nullptr, nullptr);
    return threads;
}

// A detector runs on its own number of threads, or on the number of the process, which may be replaced.
void threads()
{
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (std::uint32_t i = 0; i < 2 * 40; ++i) {
        faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const exact_ccd::Mesh mesh(6 * 40, faces);
    exact_ccd::Detector own(mesh), of_process(mesh);
    own.set_threads(1);
    exact_ccd::set_threads(4);
    const auto one = threads_of(own);
    CHECK(one.size() == 1 && one.count(std::this_thread::get_id()) == 0);
    CHECK(threads_of(own) == one);
    CHECK(threads_of(of_process).count(*one.begin()) == 0);
    exact_ccd::set_threads(1);
    CHECK(threads_of(of_process) == one);
    own.set_threads(0);
    CHECK(threads_of(own) == one);
    throws<exact_ccd::Error>([&] { own.set_threads(1025); });
    exact_ccd::set_threads(2);
}

// The detector owns its rule.
void rules()
{
    const std::vector<std::array<std::uint32_t, 3>> faces{{0, 1, 2}, {3, 4, 5}};
    const exact_ccd::Mesh mesh(6, faces);
    const auto data = std::make_shared<int>(0);
    {
        exact_ccd::Detector detector(mesh);
        detector.set_can_collide([data](std::uint32_t, std::uint32_t) { return false; });
        CHECK(data.use_count() == 2);
        detector.set_can_collide([data](std::uint32_t, std::uint32_t) { return true; });
        CHECK(data.use_count() == 2);
    }
    CHECK(data.use_count() == 1);
}

}  // namespace

int main()
{
    exact_ccd::check_version();
    exact_ccd::set_threads(2);
    threads();
    rules();
    queries();
    errors();
    meshes();
    return 0;
}
