// The queries of DART on random points, beside their exact answers:
//
// - A contact is never a miss of DART: it is a hit, or DART ends without an answer.
// - Where both find contact, DART's time is not later.
// - Without contact, DART may still hit: the primitives come within its tolerance.

#include <random>

#include <dart/collision/native/narrow_phase/primitive_ccd.hpp>
#include <exact_ccd/dart.hpp>

#include "check.h"

namespace {

namespace native = dart::collision::native;
using Eigen::Vector3d;
using native::CcdPrimitiveStatus;

struct Counts {
    int contact = 0, hit = 0, no_answer = 0, false_hit = 0;
};

template <typename Theirs, typename Exact>
Counts compare(Theirs theirs, Exact exact, double min_separation)
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    native::CcdOption option;
    option.minSeparation = min_separation;
    Counts counts;
    for (int i = 0; i < 200'000; ++i) {
        std::array<Vector3d, 8> points;
        for (auto& point : points) {
            point = Vector3d(unit(random), unit(random), unit(random));
        }
        const auto call = [&](auto query, native::CcdPrimitiveResult& result) {
            return std::apply([&](const auto&... point) { return query(point..., option, result); }, points);
        };
        native::CcdPrimitiveResult dart, truth;
        const bool hit = call(theirs, dart), contact = call(exact, truth);
        CHECK(hit == dart.isHit() && contact == truth.isHit());
        CHECK(truth.status == (contact ? CcdPrimitiveStatus::Hit : CcdPrimitiveStatus::Miss));
        if (contact) {
            CHECK(dart.status != CcdPrimitiveStatus::Miss);
            CHECK(!hit || dart.timeOfImpact <= truth.timeOfImpact);
        }
        counts.contact += contact;
        counts.hit += contact && hit;
        counts.no_answer += dart.status == CcdPrimitiveStatus::Indeterminate;
        counts.false_hit += !contact && hit;
    }
    return counts;
}

void print(const char* name, const Counts& counts)
{
    std::printf("%s: %d contacts, DART hits %d of them; %d queries without an answer of DART; %d hits without contact\n",
                name, counts.contact, counts.hit, counts.no_answer, counts.false_hit);
    CHECK(counts.contact > 0 && counts.hit > 0);
}

}  // namespace

// A function of this name as an argument, which may be overloaded.
#define QUERY(function) [](auto&&... a) { return function(std::forward<decltype(a)>(a)...); }

int main()
{
    for (double min_separation : {0.0, 0.01}) {
        std::printf("minSeparation = %g\n", min_separation);
        print("point and triangle",
              compare(QUERY(native::pointTriangleCcd), exact_ccd::dart::pointTriangleCcd, min_separation));
        print("two edges", compare(QUERY(native::edgeEdgeCcd), exact_ccd::dart::edgeEdgeCcd, min_separation));
    }
    return 0;
}
