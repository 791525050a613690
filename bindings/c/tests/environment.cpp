// The floating-point environment of the host changes no answer, and survives each call; several
// threads use the library at the same time.

#include <cfenv>
#include <thread>

#include "answers.hpp"
#include "check.h"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

int main()
{
    const double smallest = 4.9406564584124654e-324;
    const Scene units = scene(1), tiny = scene(smallest);
    const Answers normal = answers(units), subnormal = answers(tiny);
    CHECK(!normal.contacts.empty() && normal.contacts.size() == subnormal.contacts.size());

#if defined(__SSE2__)
    // All of the register survives, with the flags of exceptions.
    const unsigned standard = _mm_getcsr() & ~0x3fu;
    _mm_setcsr(standard);
    const Answers again = answers(units);
    CHECK(_mm_getcsr() == standard);
    CHECK(same(normal, again));
    _mm_setcsr(standard);
    _mm_setcsr(standard | 0x8040);  // flush to zero, denormals are zero
    const Answers flushed = answers(tiny);
    CHECK(_mm_getcsr() == (standard | 0x8040));
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
