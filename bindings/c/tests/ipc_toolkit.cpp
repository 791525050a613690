// The narrow phase of the IPC Toolkit, compiled against its header or the members that it uses.

#include <exact_ccd/ipc_toolkit.hpp>

#include "check.h"

int main()
{
    exact_ccd::ExactCCD exact;
    const ipc::NarrowPhaseCCD* const ccd = &exact;
    CHECK(exact.conservative_rescaling == 0.9);
    CHECK(exact_ccd::ExactCCD(1).conservative_rescaling == 1);
    for (const double wrong : {0.0, -0.5, std::nextafter(1.0, 2.0), std::nan("")}) {
        bool is_refused = false;
        try {
            exact_ccd::ExactCCD narrow_phase(wrong);
        } catch (const std::invalid_argument&) {
            is_refused = true;
        }
        CHECK(is_refused);
    }
    exact.conservative_rescaling = 0.5;

    using Eigen::Vector3d;
    const Vector3d p0(0.25, 0.25, 1), p1(0.25, 0.25, -1), a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    double toi = 7;
    CHECK(ccd->point_triangle_ccd(p0, a, b, c, p1, a, b, c, toi));
    CHECK(toi == 0.25);
    CHECK(ccd->point_triangle_ccd(p0, a, b, c, p1, a, b, c, toi, 0.5));
    CHECK(toi == 0.125);
    toi = 7;
    CHECK(!ccd->point_triangle_ccd(p0, a, b, c, p1, a, b, c, toi, 0.0, 0.25));
    CHECK(std::isinf(toi));
    // At 1/3, which is above the number 1.0 / 3: no contact until there.
    const Vector3d deep(0.25, 0.25, -2);
    CHECK(!ccd->point_triangle_ccd(p0, a, b, c, deep, a, b, c, toi, 0.0, 1.0 / 3));
    CHECK(std::isinf(toi));
    CHECK(ccd->point_triangle_ccd(p0, a, b, c, deep, a, b, c, toi, 0.0, std::nextafter(1.0 / 3, 1)));
    CHECK(toi == 0.5 * (1.0 / 3));
    // Exactly at 1/2.
    CHECK(ccd->point_triangle_ccd(p0, a, b, c, p1, a, b, c, toi, 0.0, 0.5));
    // Within the distance at the start: time 0.
    CHECK(ccd->point_triangle_ccd(p0, a, b, c, p1, a, b, c, toi, 1.0));
    CHECK(toi == 0);

    const Vector3d e0(-1, 0, 1), e1(1, 0, 1), f0(0, -1, 0), f1(0, 1, 0), down(0, 0, 2);
    CHECK(ccd->edge_edge_ccd(e0, e1, f0, f1, e0 - down, e1 - down, f0, f1, toi));
    CHECK(toi == 0.25);

    // In two dimensions.
    ipc::VectorMax3d q0(2), q1(2), g0(2), g1(2);
    q0 << 0.5, 1;
    q1 << 0.5, -1;
    g0 << 0, 0;
    g1 << 1, 0;
    CHECK(ccd->point_edge_ccd(q0, g0, g1, q1, g0, g1, toi));
    CHECK(toi == 0.25);
    CHECK(ccd->point_point_ccd(q0, q1, q1, q0, toi, 0.5));
    CHECK(toi == 0.5 * 0.375);
    return 0;
}
