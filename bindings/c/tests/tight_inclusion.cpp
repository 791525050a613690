// The adapter of Tight Inclusion.

#include <exact_ccd/tight_inclusion.hpp>

#include "check.h"

int main()
{
    using namespace exact_ccd::ticcd;
    const Vector3 v0(0.25, 0.25, 1), v1(0.25, 0.25, -1);
    const Vector3 f0(0, 0, 0), f1(1, 0, 0), f2(0, 1, 0);
    const Array3 err(-1, -1, -1);
    double toi = 0, output_tolerance = 1;
    CHECK(vertexFaceCCD(v0, f0, f1, f2, v1, f0, f1, f2, err, 0, toi, 1e-6, 1, 1000000, output_tolerance));
    CHECK(toi == 0.5 && output_tolerance == 0);
    CHECK(vertexFaceCCD(v0, f0, f1, f2, v1, f0, f1, f2, err, 0.5, toi, 1e-6, 1, -1, output_tolerance, true));
    CHECK(toi == 0.25);
    CHECK(!vertexFaceCCD(v0, f0, f1, f2, v1, f0, f1, f2, err, 0, toi, 1e-6, 0.49, -1, output_tolerance));
    CHECK(std::isinf(toi));

    // At 1/3, which is above the number 1.0 / 3: no contact until there.
    const Vector3 deep(0.25, 0.25, -2);
    CHECK(!vertexFaceCCD(v0, f0, f1, f2, deep, f0, f1, f2, err, 0, toi, 1e-6, 1.0 / 3, -1, output_tolerance));
    CHECK(std::isinf(toi));
    const double next = std::nextafter(1.0 / 3, 1);
    CHECK(vertexFaceCCD(v0, f0, f1, f2, deep, f0, f1, f2, err, 0, toi, 1e-6, next, -1, output_tolerance));
    CHECK(toi == 1.0 / 3);

    // Edge a falls on edge b across it. With the ends crosswise, the edges are others, which never meet.
    const Vector3 a0(-1, 0, 1), a1(1, 0, 1), b0(0, -1, 0), b1(0, 1, 0), down(0, 0, 2);
    CHECK(edgeEdgeCCD(
        a0, a1, b0, b1, a0 - down, a1 - down, b0, b1, err, 0, toi, 1e-6, 1, -1, output_tolerance));
    CHECK(toi == 0.5);
    CHECK(!edgeEdgeCCD(
        a0, b0, a1, b1, a0 - down, b0, a1 - down, b1, err, 0, toi, 1e-6, 1, -1, output_tolerance));
    return 0;
}
