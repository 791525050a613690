// The adapter of DART, with structures that have the members of DART's option and result.

#include <exact_ccd/dart.hpp>

#include "check.h"

namespace {

using Eigen::Vector3d;

struct Option {
    double tolerance = 1e-4;
    int maxIterations = 32;
    double minSeparation = 0.0;
};

enum class Status { Unknown, Hit, Miss, Indeterminate };

struct OldResult {
    bool hit = false;
    double timeOfImpact = 1.0;

    void clear() { *this = OldResult(); }
};

struct Result : OldResult {
    Status status = Status::Unknown;

    void clear() { *this = Result(); }
};

const Vector3d a(-1, -1, 0), b(1, -1, 0), c(0, 1, 0);

void point_and_triangle()
{
    Option option;
    Result result;
    const Vector3d above(0, 0, 1), below(0, 0, -1), beside(5, 0, 0);
    CHECK(exact_ccd::dart::pointTriangleCcd(above, below, a, a, b, b, c, c, option, result));
    CHECK(result.hit && result.status == Status::Hit && result.timeOfImpact == 0.5);
    option.minSeparation = 0.5;
    CHECK(exact_ccd::dart::pointTriangleCcd(above, below, a, a, b, b, c, c, option, result));
    CHECK(result.timeOfImpact == 0.25);
    option.minSeparation = -1;
    CHECK(exact_ccd::dart::pointTriangleCcd(above, below, a, a, b, b, c, c, option, result));
    CHECK(result.timeOfImpact == 0.5);
    CHECK(!exact_ccd::dart::pointTriangleCcd(
        above + beside, below + beside, a, a, b, b, c, c, option, result));
    CHECK(!result.hit && result.status == Status::Miss && result.timeOfImpact == 1.0);

    OldResult old;
    CHECK(exact_ccd::dart::pointTriangleCcd(above, below, a, a, b, b, c, c, option, old));
    CHECK(old.hit && old.timeOfImpact == 0.5);
}

void edges()
{
    const Option option;
    Result result;
    const Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    // One edge falls on another across it; as long as it stays above, there is no contact.
    CHECK(exact_ccd::dart::edgeEdgeCcd(z - x, -z - x, z + x, -z + x, -y, -y, y, y, option, result));
    CHECK(result.status == Status::Hit && result.timeOfImpact == 0.5);
    CHECK(!exact_ccd::dart::edgeEdgeCcd(z - x, z - x, z + x, z + x, -y, -y, y, y, option, result));
    CHECK(result.status == Status::Miss);
    // A nearly tangential approach: fast along the plane, slow towards it.
    const Vector3d low(0, 0, 1e-9);
    CHECK(exact_ccd::dart::edgeEdgeCcd(
        low - x, -low - x, low + x, -low + x, -y, 1.5 * x - y, y, 1.5 * x + y, option, result));
    CHECK(result.timeOfImpact == 0.5);
}

}  // namespace

int main()
{
    point_and_triangle();
    edges();
    return 0;
}
