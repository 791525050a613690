#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#include <ipc/ccd/exact_ccd.hpp>

using namespace ipc;
using Eigen::Vector3d;

TEST_CASE("Exact CCD of a point and a triangle", "[ccd][exact]")
{
    const Vector3d a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    const Vector3d above(0.25, 0.25, 1), below(0.25, 0.25, -1);
    ExactCCD ccd;
    double toi = -1;
    REQUIRE(ccd.point_triangle_ccd(above, a, b, c, below, a, b, c, toi));
    CHECK(toi == 0.9 * 0.5);
    ccd.conservative_rescaling = 1.0;
    REQUIRE(ccd.point_triangle_ccd(above, a, b, c, below, a, b, c, toi));
    CHECK(toi == 0.5);
    // Contact after tmax is none, contact at tmax counts.
    CHECK(!ccd.point_triangle_ccd(above, a, b, c, below, a, b, c, toi, 0.0, 0.25));
    CHECK(ccd.point_triangle_ccd(above, a, b, c, below, a, b, c, toi, 0.0, 0.5));
    // Within the distance at the start.
    REQUIRE(ccd.point_triangle_ccd(above, a, b, c, below, a, b, c, toi, 1.0));
    CHECK(toi == 0.0);
}

TEST_CASE("Exact CCD at the boundary of primitives", "[ccd][exact]")
{
    const ExactCCD ccd(1.0);
    const Vector3d down(0, 0, 2);
    const Vector3d e0(-1, 0, 1), e1(1, 0, 1), f0(0, -1, 0), f1(0, 1, 0);
    double toi = -1;
    REQUIRE(ccd.edge_edge_ccd(e0, e1, f0, f1, e0 - down, e1 - down, f0, f1, toi));
    CHECK(toi == 0.5);
    // The ends of the edges meet, and the next number beside them does not.
    const Vector3d side(1, 0, 0);
    REQUIRE(ccd.edge_edge_ccd(
        e0, e1, f0 + side, f1 + side, e0 - down, e1 - down, f0 + side, f1 + side, toi));
    const Vector3d beside(std::nextafter(1.0, 2.0), 0, 0);
    CHECK(!ccd.edge_edge_ccd(
        e0, e1, f0 + beside, f1 + beside, e0 - down, e1 - down, f0 + beside, f1 + beside, toi));
}

TEST_CASE("Exact CCD in two dimensions", "[ccd][exact]")
{
    VectorMax3d p0(2), p1(2), e0(2), e1(2);
    p0 << 0.5, 1;
    p1 << 0.5, -1;
    e0 << 0, 0;
    e1 << 1, 0;
    const ExactCCD ccd(1.0);
    double toi = -1;
    REQUIRE(ccd.point_edge_ccd(p0, e0, e1, p1, e0, e1, toi));
    CHECK(toi == 0.5);
    REQUIRE(ccd.point_point_ccd(p0, p1, p1, p0, toi));
    CHECK(toi == 0.5);
}

TEST_CASE("Exact CCD refuses what is not finite", "[ccd][exact]")
{
    const Vector3d a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    const Vector3d p(0, 0, std::numeric_limits<double>::quiet_NaN());
    double toi = -1;
    CHECK_THROWS(ExactCCD().point_triangle_ccd(p, a, b, c, a, a, b, c, toi));
    CHECK(toi == -1);
}
