// The threads of the library do not inherit the floating-point environment of the host that makes the first
// call: the times of a batch are the same as for single queries.

#include <cfenv>

#include "answers.hpp"
#include "check.h"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

int main()
{
    const Scene tiny = scene(4.9406564584124654e-324);
#if defined(__SSE2__)
    const unsigned standard = _mm_getcsr();
    _mm_setcsr(standard | 0x8040);  // flush to zero, denormals are zero
#endif
    CHECK(std::fesetround(FE_UPWARD) == 0);
    const Answers first = answers(tiny);
    CHECK(std::fegetround() == FE_UPWARD);
    std::fesetround(FE_TONEAREST);
#if defined(__SSE2__)
    _mm_setcsr(standard);
#endif

    std::size_t found = 0;
    for (std::size_t query = 0; query < tiny.queries.size() / 4; ++query) {
        std::array<Point, 4> t0, t1;
        for (std::size_t i = 0; i < 4; ++i) {
            t0[i] = tiny.x0[tiny.queries[4 * query + i]];
            t1[i] = tiny.x1[tiny.queries[4 * query + i]];
        }
        const auto single = exact_ccd::time_of_impact(Kind::vertex_face, t0, t1);
        const double time = first.times[query];
        CHECK(single ? *single == time : std::isnan(time));
        found += single.has_value();
    }
    CHECK(found > 20);
    CHECK(same(first, answers(tiny)));
    return 0;
}
