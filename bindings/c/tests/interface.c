// All functions of the C interface, on cases whose answers are known, and their errors.

#include <float.h>
#include <math.h>
#include <string.h>

#include <exact_ccd.h>

#include "check.h"

#define OK(call) CHECK((call) == EXACT_CCD_STATUS_OK)

static void fails(exact_ccd_status_t status, exact_ccd_status_t expected, const char* word)
{
    CHECK(status == expected);
    if (strstr(exact_ccd_last_error(), word) == NULL) {
        fprintf(stderr, "the message \"%s\" does not contain \"%s\"\n", exact_ccd_last_error(), word);
        exit(1);
    }
}

static const double FACE_START[12] = {0.25, 0.25, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
static const double FACE_END[12] = {0.25, 0.25, -1, 0, 0, 0, 1, 0, 0, 0, 1, 0};

static void versions(void)
{
    // The sources, and the header, by which CMake and cargo name the shared library.
    CHECK(exact_ccd_abi_version() == EXACT_CCD_ABI_VERSION);
    CHECK(strlen(exact_ccd_version()) >= 5);
}

static void queries(void)
{
    bool collides = false;
    OK(exact_ccd_collides(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0, 1, &collides));
    CHECK(collides);

    double time = -1;
    OK(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0, 1, &time));
    CHECK(time == 0.5);
    OK(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0.5, 1, &time));
    CHECK(time == 0.25);
    OK(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_START, 0.5, 1, &time));
    CHECK(isnan(time));

    // A time that is exactly 0.5, and one at 1/3 between two numbers.
    OK(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0, 0.5, &time));
    CHECK(time == 0.5);
    double third[12];
    memcpy(third, FACE_END, sizeof third);
    third[2] = -2;
    const double below = 1.0 / 3;
    OK(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, third, 0, 1, &time));
    CHECK(time == below);
    OK(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, third, 0, below, &time));
    CHECK(isnan(time));
    OK(exact_ccd_time_of_impact(
        EXACT_CCD_KIND_VERTEX_FACE, FACE_START, third, 0, 0x1.5555555555556p-2, &time));
    CHECK(time == below);
    OK(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, third, 0, INFINITY, &time));
    CHECK(time == below);
    OK(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 1, -1, &time));
    CHECK(isnan(time));

    exact_ccd_impact_t impact;
    OK(exact_ccd_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0, 1, &collides, &impact));
    CHECK(collides && impact.time == 0.5 && impact.time_is_exact && impact.has_normal);
    CHECK(fabs(impact.normal[2] - 1) < 1e-9 && fabs(impact.parameters[0] - 0.25) < 1e-9);
    const double meeting[3] = {0.25, 0.25, 0};
    for (int axis = 0; axis < 3; ++axis) {
        CHECK(fabs(impact.points[0][axis] - meeting[axis]) < 1e-9);
        CHECK(fabs(impact.points[1][axis] - meeting[axis]) < 1e-9);
    }
    OK(exact_ccd_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0.5, 1, &collides, &impact));
    CHECK(impact.points[0][2] == 0.5 && impact.points[1][2] == 0);

    exact_ccd_interval_t intervals[32];
    size_t count = 99;
    OK(exact_ccd_intervals(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0.5, 1, intervals, 32, &count));
    CHECK(count == 1 && intervals[0].start == 0.25 && intervals[0].end == 0.75);
    OK(exact_ccd_intervals(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0.5, 1, NULL, 0, &count));
    CHECK(count == 1);

    double lower = 0, upper = 0;
    OK(exact_ccd_distance_at(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0.25, &lower, &upper));
    CHECK(lower == 0.5 && upper == 0.5);

    // Points that pass each other at the distance 3 come within 5 at t = 1/4.
    const double point_start[6] = {0, 3, -8, 0, 0, 0}, point_end[6] = {0, 3, 8, 0, 0, 0};
    OK(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_VERTEX, point_start, point_end, 5, 1, &time));
    CHECK(time == 0.25);
    const double edge_start[9] = {0, 3, -8, -9, 0, 0, 9, 0, 0}, edge_end[9] = {0, 3, 8, -9, 0, 0, 9, 0, 0};
    OK(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_EDGE, edge_start, edge_end, 5, 1, &time));
    CHECK(time == 0.25);
    // The point of the edge is the middle.
    OK(exact_ccd_impact(EXACT_CCD_KIND_VERTEX_EDGE, edge_start, edge_end, 5, 1, &collides, &impact));
    CHECK(collides && fabs(impact.parameters[1] - 0.5) < 1e-9);
    CHECK(impact.points[0][1] == 3 && impact.points[0][2] == -4 && fabs(impact.points[1][0]) < 1e-9);
    OK(exact_ccd_impact(EXACT_CCD_KIND_VERTEX_VERTEX, point_start, point_end, 5, 1, &collides, &impact));
    CHECK(collides && impact.points[0][2] == -4 && impact.points[1][2] == 0);
    // Edges that cross in the middle.
    const double cross_start[12] = {-1, 0, 1, 1, 0, 1, 0, -1, 0, 0, 3, 0};
    const double cross_end[12] = {-1, 0, -1, 1, 0, -1, 0, -1, 0, 0, 3, 0};
    OK(exact_ccd_impact(EXACT_CCD_KIND_EDGE_EDGE, cross_start, cross_end, 0.5, 1, &collides, &impact));
    CHECK(collides && impact.time == 0.25 && fabs(impact.parameters[1] - 0.25) < 1e-9);
    CHECK(impact.points[0][2] == 0.5 && impact.points[1][2] == 0 && fabs(impact.points[1][1]) < 1e-9);
}

static void errors(void)
{
    bool collides;
    double time;
    const exact_ccd_status_t argument = EXACT_CCD_STATUS_INVALID_ARGUMENT;
    fails(exact_ccd_collides(EXACT_CCD_KIND_VERTEX_FACE, NULL, FACE_END, 0, 1, &collides), argument, "x0");
    fails(exact_ccd_collides(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0, 1, NULL), argument, "collides");
    fails(exact_ccd_collides(7, FACE_START, FACE_END, 0, 1, &collides), argument, "kind is 7");
    fails(exact_ccd_collides(EXACT_CCD_KIND_EDGE_FACE, FACE_START, FACE_END, 0, 1, &collides), argument, "kind is 4");
    CHECK(!exact_ccd_last_error_fields().has_query && exact_ccd_last_error_fields().edge == EXACT_CCD_NONE);
    fails(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0, NAN, &time),
          argument,
          "until");
    fails(exact_ccd_collides(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, -1, 1, &collides), argument, "-1");
    fails(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, NAN, 1, &time), argument, "NaN");

    double not_finite[12];
    memcpy(not_finite, FACE_END, sizeof not_finite);
    not_finite[4] = INFINITY;
    fails(exact_ccd_collides(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, not_finite, 0, 1, &collides),
          EXACT_CCD_STATUS_INVALID_POSITIONS,
          "inf");

    const uint32_t out_of_range[4] = {0, 1, 2, 4};
    fails(exact_ccd_batch_time_of_impact(
              EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 4, out_of_range, 1, 0, 1, 0, &time),
          EXACT_CCD_STATUS_INVALID_MESH,
          "vertex 4");

    exact_ccd_mesh_t* mesh = NULL;
    const uint32_t face[3] = {0, 1, 9};
    fails(exact_ccd_mesh_new(4, face, 1, NULL, 0, &mesh), EXACT_CCD_STATUS_INVALID_MESH, "vertex 9");
    CHECK(mesh == NULL);
    if (sizeof(size_t) > 4) {
        // More vertices than indices can name.
        fails(exact_ccd_mesh_new((size_t)UINT32_MAX + 1, NULL, 0, NULL, 0, &mesh),
              EXACT_CCD_STATUS_INVALID_MESH,
              "4294967296 vertices");
        CHECK(mesh == NULL);
    }
    exact_ccd_mesh_free(NULL);
    exact_ccd_detector_free(NULL);
    exact_ccd_contacts_free(NULL);
    exact_ccd_audit_free(NULL);
    exact_ccd_certificate_free(NULL);
}

static void batches(void)
{
    // Vertices 0 and 1 fall, vertex 0 through the face.
    const double x0[15] = {0.25, 0.25, 1, 3, 3, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    double x1[15];
    memcpy(x1, x0, sizeof x1);
    x1[2] = x1[5] = -1;
    const uint32_t queries[8] = {0, 2, 3, 4, 1, 2, 3, 4};
    double times[2] = {-1, -1};
    OK(exact_ccd_batch_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, x0, x1, 5, queries, 2, 0, 1, 0, times));
    CHECK(times[0] == 0.5 && isnan(times[1]));
    OK(exact_ccd_batch_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, x0, x1, 5, queries, 2, 0.5, 1, 0, times));
    CHECK(times[0] == 0.25 && isnan(times[1]));
    const double thickness[5] = {0.25, 0, 0.25, 0, 0};
    OK(exact_ccd_batch_time_of_impact_thick(EXACT_CCD_KIND_VERTEX_FACE, x0, x1, 5, queries, 2, thickness, 1, 0, times));
    CHECK(times[0] == 0.25 && isnan(times[1]));
    OK(exact_ccd_batch_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, NULL, NULL, 0, NULL, 0, 0, 1, 0, NULL));
}

// A batch that fails writes no time, and names the first wrong query, on any number of threads.
static void wrong_batches(void)
{
    enum { COUNT = 20000 };
    static uint32_t queries[4 * COUNT];
    static double times[COUNT];
    for (int i = 0; i < COUNT; ++i) {
        for (uint32_t j = 0; j < 4; ++j) {
            queries[4 * i + j] = j;
        }
        times[i] = -7;
    }
    queries[4 * 9001 + 2] = 4;
    queries[4 * 15001 + 1] = 5;
    const double thickness[4] = {0, 0, 0, 0};
    fails(exact_ccd_batch_time_of_impact(
              EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 4, queries, COUNT, 0, 1, 0, times),
          EXACT_CCD_STATUS_INVALID_MESH,
          "query 9001");
    fails(exact_ccd_batch_time_of_impact_thick(
              EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 4, queries, COUNT, thickness, 1, 0, times),
          EXACT_CCD_STATUS_INVALID_MESH,
          "query 9001");
    const exact_ccd_error_t error = exact_ccd_last_error_fields();
    CHECK(error.status == EXACT_CCD_STATUS_INVALID_MESH && error.has_query && error.query == 9001);
    CHECK(strcmp(error.message, exact_ccd_last_error()) == 0);
    fails(exact_ccd_batch_time_of_impact(
              EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 4, queries, COUNT, 0, 1, 3, times),
          EXACT_CCD_STATUS_INVALID_MESH,
          "query 9001");
    for (int i = 0; i < COUNT; ++i) {
        CHECK(times[i] == -7);
    }
}

static bool never(uint32_t a, uint32_t b, void* calls)
{
    (void)a;
    (void)b;
    *(bool*)calls = true;
    return false;
}

static bool are_edge_and_face(const uint32_t* a, size_t a_count, const uint32_t* b, size_t b_count, void* face)
{
    (void)a;
    return a_count == 2 && b_count == 3 && b[0] == *(const uint32_t*)face;
}

static void count_destruction(void* count) { ++*(int*)count; }

static bool always(uint32_t a, uint32_t b, void* data)
{
    (void)a;
    (void)b;
    (void)data;
    return true;
}

// The data of a callback that the detector owns is destroyed once: by the next rule, by the end of the
// detector, at once without a callback; and not by a call that fails.
static void owned_data(const exact_ccd_mesh_t* mesh)
{
    int first = 0, second = 0, third = 0, fourth = 0;
    exact_ccd_detector_t* detector = NULL;
    OK(exact_ccd_detector_new(mesh, &detector));
    OK(exact_ccd_detector_set_can_collide_owned(detector, always, &first, count_destruction));
    CHECK(first == 0);
    uint32_t corner = 0;
    OK(exact_ccd_detector_set_pair_can_collide(detector, are_edge_and_face, &corner));
    CHECK(first == 1);
    OK(exact_ccd_detector_set_can_collide_owned(detector, NULL, &second, count_destruction));
    CHECK(second == 1);
    OK(exact_ccd_detector_set_pair_can_collide_owned(detector, are_edge_and_face, &third, count_destruction));
    fails(exact_ccd_detector_set_can_collide_owned(NULL, always, &fourth, count_destruction),
          EXACT_CCD_STATUS_INVALID_ARGUMENT,
          "detector");
    CHECK(third == 0);
    exact_ccd_detector_free(detector);
    CHECK(first == 1 && second == 1 && third == 1 && fourth == 0);
}

static void intersections(const exact_ccd_mesh_t* mesh, const double* apart, const double* crossing)
{
    exact_ccd_detector_t* detector = NULL;
    OK(exact_ccd_detector_new(mesh, &detector));
    bool intersects = true;
    OK(exact_ccd_detector_has_intersections(detector, apart, 6, &intersects, NULL, NULL));
    CHECK(!intersects);
    uint32_t edge = 99, face = 99;
    OK(exact_ccd_detector_has_intersections(detector, crossing, 6, &intersects, &edge, &face));
    CHECK(intersects && face == 0 && edge < 6);
    fails(exact_ccd_detector_has_intersections(
              detector, crossing, 6, &intersects, (uint32_t*)((char*)&edge + 1), &face),
          EXACT_CCD_STATUS_INVALID_ARGUMENT,
          "edge is not aligned");

    // Among the pairs that can collide.
    uint32_t first_corner = 3;
    OK(exact_ccd_detector_set_pair_can_collide(detector, are_edge_and_face, &first_corner));
    OK(exact_ccd_detector_has_intersections(detector, crossing, 6, &intersects, NULL, NULL));
    CHECK(!intersects);
    first_corner = 0;
    OK(exact_ccd_detector_has_intersections(detector, crossing, 6, &intersects, NULL, NULL));
    CHECK(intersects);
    bool collides = true;
    OK(exact_ccd_detector_collides(detector, apart, crossing, 6, 1, &collides));
    CHECK(!collides);
    OK(exact_ccd_detector_set_pair_can_collide(detector, NULL, NULL));
    OK(exact_ccd_detector_collides(detector, apart, crossing, 6, 1, &collides));
    CHECK(collides);
    exact_ccd_detector_free(detector);
}

// The vertex is within the smallest time of the face, and not in contact at the start.
static void smallest_times(void)
{
    const uint32_t face[3] = {1, 2, 3};
    double x0[12], x1[12], positions[12], size = -1;
    memcpy(x0, FACE_START, sizeof x0);
    memcpy(x1, FACE_START, sizeof x1);
    x0[2] = 1.5e-323;
    x1[2] = -1e300;
    exact_ccd_mesh_t* mesh = NULL;
    exact_ccd_detector_t* detector = NULL;
    exact_ccd_contacts_t* contacts = NULL;
    OK(exact_ccd_mesh_new(4, face, 1, NULL, 0, &mesh));
    OK(exact_ccd_detector_new(mesh, &detector));
    OK(exact_ccd_detector_free_step(detector, x0, x1, 4, 0.9, &size, positions, NULL, NULL));
    CHECK(size == 0);
    bool collides = true;
    OK(exact_ccd_detector_collides(detector, x0, x0, 4, 1, &collides));
    CHECK(!collides);
    // Times that are not in the step.
    const double wrong[] = {NAN, -1, -5e-324, 1.5, INFINITY};
    for (int i = 0; i < 5; ++i) {
        fails(exact_ccd_detector_collides(detector, x0, x1, 4, wrong[i], &collides),
              EXACT_CCD_STATUS_INVALID_ARGUMENT,
              "from 0 to 1");
        fails(exact_ccd_detector_collisions(detector, x0, x1, 4, wrong[i], &contacts),
              EXACT_CCD_STATUS_INVALID_ARGUMENT,
              "from 0 to 1");
        CHECK(contacts == NULL);
    }
    exact_ccd_detector_free(detector);
    exact_ccd_mesh_free(mesh);
}

// Vertex 0 falls on the face, vertex 4 passes by, and vertex 5 rests.
static void free_steps(void)
{
    const uint32_t face[3] = {1, 2, 3};
    const double x0[18] = {0.25, 0.25, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 1, 0.25, 0.5, 1};
    double x1[18], sizes[6], positions[18];
    memcpy(x1, x0, sizeof x1);
    x1[2] = x1[14] = -1;
    exact_ccd_mesh_t* mesh = NULL;
    exact_ccd_detector_t* detector = NULL;
    exact_ccd_pairs_t* blocked = NULL;
    const exact_ccd_pair_t* data = NULL;
    size_t rounds = 0, count = 99;
    bool collides = true;
    OK(exact_ccd_mesh_new(6, face, 1, NULL, 0, &mesh));
    OK(exact_ccd_detector_new(mesh, &detector));
    OK(exact_ccd_detector_free_steps(detector, x0, x1, 6, NULL, 0, 0.5, sizes, positions, &rounds, &blocked));
    CHECK(sizes[0] == 0.25 && sizes[1] == 1 && sizes[4] == 1 && sizes[5] == 1 && rounds == 2);
    CHECK(positions[2] == 0.5 && positions[14] == -1);
    OK(exact_ccd_pairs_data(blocked, &data, &count));
    CHECK(count == 0);
    exact_ccd_pairs_free(blocked);
    OK(exact_ccd_detector_collides(detector, x0, positions, 6, 1, &collides));
    CHECK(!collides);

    // A pinned vertex runs into the face; the other pair begins in contact. The result is in the place of x1.
    double y0[18];
    memcpy(y0, x0, sizeof y0);
    y0[17] = 0;
    x1[17] = -1;
    const uint32_t pinned[1] = {0};
    OK(exact_ccd_detector_free_steps(detector, y0, x1, 6, pinned, 1, 0.5, sizes, x1, &rounds, &blocked));
    OK(exact_ccd_pairs_data(blocked, &data, &count));
    CHECK(count == 2 && sizes[0] == 1 && x1[2] == -1 && sizes[5] == 0);
    for (uint32_t i = 0; i < 2; ++i) {
        CHECK(data[i].kind == EXACT_CCD_KIND_VERTEX_FACE && data[i].first == 5 * i && data[i].second == 0);
        CHECK(data[i].vertices[0] == 5 * i && data[i].vertices[1] == 1 && data[i].vertices[3] == 3);
    }
    exact_ccd_pairs_free(blocked);
    blocked = NULL;

    const exact_ccd_status_t argument = EXACT_CCD_STATUS_INVALID_ARGUMENT;
    const uint32_t unknown[2] = {0, 6};
    sizes[0] = -7;
    rounds = 99;
    fails(exact_ccd_detector_free_steps(detector, x0, x1, 6, unknown, 2, 0.5, sizes, positions, &rounds, &blocked),
          argument,
          "vertex 6 is pinned");
    fails(exact_ccd_detector_free_steps(detector, x0, x1, 6, NULL, 1, 0.5, sizes, positions, &rounds, &blocked),
          argument,
          "pinned is null");
    fails(exact_ccd_detector_free_steps(detector, x0, x1, 6, NULL, 0, 0, sizes, positions, &rounds, &blocked),
          argument,
          "to keep is 0");
    fails(exact_ccd_detector_free_steps(detector, x0, x1, 6, NULL, 0, 1, sizes, NULL, &rounds, &blocked),
          argument,
          "positions");
    fails(exact_ccd_detector_free_steps(detector, x0, x1, 5, NULL, 0, 1, sizes, positions, &rounds, &blocked),
          EXACT_CCD_STATUS_INVALID_POSITIONS,
          "5");
    CHECK(sizes[0] == -7 && rounds == 99 && blocked == NULL);
    exact_ccd_pairs_free(NULL);
    exact_ccd_detector_free(detector);
    exact_ccd_mesh_free(mesh);
}

// A vertex falls onto a face, another one passes by: first contacts and clearances.
static void answers_for_vertices(void)
{
    const uint32_t face[3] = {1, 2, 3};
    const double x0[15] = {0.25, 0.25, 0.5, 0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 1};
    double x1[15], times[5], clearances[5];
    memcpy(x1, x0, sizeof x1);
    x1[2] = -0.5;
    x1[14] = -1;
    exact_ccd_mesh_t* mesh = NULL;
    exact_ccd_detector_t* detector = NULL;
    exact_ccd_contacts_t* contacts = NULL;
    const exact_ccd_contact_t* data = NULL;
    size_t first[5], count = 99;
    OK(exact_ccd_mesh_new(5, face, 1, NULL, 0, &mesh));
    OK(exact_ccd_detector_new(mesh, &detector));
    OK(exact_ccd_detector_first_contacts(detector, x0, x1, 5, 1, first, times, &contacts));
    OK(exact_ccd_contacts_data(contacts, &data, &count));
    CHECK(count == 1 && first[0] == 0 && first[3] == 0 && first[4] == 1);
    CHECK(times[0] == 0.5 && times[2] == 0.5 && times[4] > 2);
    exact_ccd_contacts_free(contacts);
    contacts = NULL;
    OK(exact_ccd_detector_clearances(detector, x0, 5, 2, clearances));
    CHECK(clearances[0] == 0.5 && clearances[3] == 0.5 && clearances[4] == 2);

    const exact_ccd_status_t argument = EXACT_CCD_STATUS_INVALID_ARGUMENT;
    const exact_ccd_status_t wrong_positions = EXACT_CCD_STATUS_INVALID_POSITIONS;
    times[0] = clearances[0] = -7;
    fails(exact_ccd_detector_first_contacts(detector, x0, x1, 4, 1, first, times, &contacts), wrong_positions, "4");
    fails(exact_ccd_detector_first_contacts(detector, x0, x1, 5, 2, first, times, &contacts), argument, "time 2");
    fails(exact_ccd_detector_first_contacts(detector, x0, x1, 5, 1, NULL, times, &contacts), argument, "first");
    fails(exact_ccd_detector_clearances(detector, x0, 4, 2, clearances), wrong_positions, "4");
    fails(exact_ccd_detector_clearances(detector, x0, 5, -1, clearances), argument, "cut_off");
    fails(exact_ccd_detector_clearances(detector, x0, 5, 2, NULL), argument, "clearances");
    CHECK(times[0] == -7 && clearances[0] == -7 && contacts == NULL);
    exact_ccd_detector_free(detector);
    exact_ccd_mesh_free(mesh);
}

// A mesh that is pierced at the start is free of contact, unless the start is checked.
static void start_check(const exact_ccd_mesh_t* mesh, const double* apart, const double* crossing)
{
    exact_ccd_detector_t* detector = NULL;
    exact_ccd_contacts_t* contacts = NULL;
    exact_ccd_contact_t contact;
    bool collides = true;
    double size = -1, positions[18];
    const exact_ccd_status_t status = EXACT_CCD_STATUS_CROSSING;
    OK(exact_ccd_detector_new(mesh, &detector));
    OK(exact_ccd_detector_collides(detector, crossing, crossing, 6, 1, &collides));
    CHECK(!collides);
    OK(exact_ccd_detector_free_step(detector, crossing, crossing, 6, 0.9, &size, positions, NULL, NULL));
    CHECK(size == 1);

    uint32_t edge = 99, face = 99;
    OK(exact_ccd_detector_has_intersections(detector, crossing, 6, &collides, &edge, &face));
    OK(exact_ccd_detector_set_start_check(detector, true));
    size = -1;
    fails(exact_ccd_detector_collides(detector, crossing, crossing, 6, 1, &collides), status, "passes through face");
    fails(exact_ccd_detector_free_step(detector, crossing, crossing, 6, 0.9, &size, positions, NULL, NULL),
          status,
          "face");
    fails(exact_ccd_detector_collision(detector, crossing, apart, 6, 1, &collides, &contact), status, "edge");
    fails(exact_ccd_detector_collisions(detector, crossing, apart, 6, 1, &contacts), status, "edge");
    CHECK(size == -1 && contacts == NULL);
    const exact_ccd_error_t error = exact_ccd_last_error_fields();
    CHECK(error.status == status && error.edge == edge && error.face == face && !error.has_query);
    OK(exact_ccd_detector_collides(detector, apart, apart, 6, 1, &collides));
    CHECK(!collides);
    OK(exact_ccd_detector_set_start_check(detector, false));
    OK(exact_ccd_detector_collides(detector, crossing, crossing, 6, 1, &collides));
    CHECK(!collides);
    exact_ccd_detector_free(detector);
}

static void meshes(void)
{
    const uint32_t faces[6] = {0, 1, 2, 3, 4, 5};
    const double x0[18] = {0, 0, 0, 8, 0, 0, 0, 8, 0, 1, 1, 1, 1, 2, 5, 2, 1, 5};
    double x1[18];
    memcpy(x1, x0, sizeof x1);
    for (int vertex = 3; vertex < 6; ++vertex) {
        x1[3 * vertex + 2] -= 2;
    }

    exact_ccd_mesh_t* mesh = NULL;
    OK(exact_ccd_mesh_new(6, faces, 2, NULL, 0, &mesh));
    size_t face_count, edge_count, loose;
    OK(exact_ccd_mesh_counts(mesh, &face_count, &edge_count, &loose));
    CHECK(face_count == 2 && edge_count == 6 && loose == 0);
    uint32_t edges[12];
    OK(exact_ccd_mesh_edges(mesh, edges, 6));
    CHECK(edges[0] == 0 && edges[1] == 1);
    fails(exact_ccd_mesh_edges(mesh, edges, 5), EXACT_CCD_STATUS_INVALID_ARGUMENT, "6 edges");

    intersections(mesh, x0, x1);
    owned_data(mesh);
    start_check(mesh, x0, x1);
    // Results may have the same place.
    size_t same = 99;
    OK(exact_ccd_mesh_counts(mesh, &same, &same, &same));
    CHECK(same == 0);

    exact_ccd_detector_t* detector = NULL;
    OK(exact_ccd_detector_new(mesh, &detector));
    bool collides = false;
    OK(exact_ccd_detector_collides(detector, x0, x1, 6, 1, &collides));
    CHECK(collides);
    exact_ccd_contact_t contact;
    OK(exact_ccd_detector_collision(detector, x0, x1, 6, 1, &collides, &contact));
    CHECK(collides && contact.impact.time == 0.5 && contact.kind == EXACT_CCD_KIND_VERTEX_FACE);
    CHECK(contact.first == 3 && contact.second == 0 && contact.vertices[0] == 3 && contact.vertices[3] == 2);
    const double meeting[3] = {1, 1, 0};
    for (int axis = 0; axis < 3; ++axis) {
        CHECK(fabs(contact.impact.points[0][axis] - meeting[axis]) < 1e-9);
        CHECK(fabs(contact.impact.points[1][axis] - meeting[axis]) < 1e-9);
    }

    // The contact is at 0.5, which is the last time that counts, or after it.
    const double until[2] = {0.5, 0.25};
    for (int i = 0; i < 2; ++i) {
        OK(exact_ccd_detector_collides(detector, x0, x1, 6, until[i], &collides));
        CHECK(collides == (i == 0));
        OK(exact_ccd_detector_collision(detector, x0, x1, 6, until[i], &collides, &contact));
        CHECK(collides == (i == 0));
    }

    exact_ccd_contacts_t* contacts = NULL;
    OK(exact_ccd_detector_collisions(detector, x0, x1, 6, 1, &contacts));
    const exact_ccd_contact_t* data = NULL;
    size_t count = 0;
    OK(exact_ccd_contacts_data(contacts, &data, &count));
    CHECK(count == 1 && data[0].impact.time == 0.5 && data[0].impact.points[0][0] == 1);
    exact_ccd_contacts_free(contacts);

    double size = -1, positions[18];
    OK(exact_ccd_detector_free_step(detector, x0, x1, 6, 0.5, &size, positions, NULL, NULL));
    CHECK(size == 0.25 && positions[3 * 3 + 2] == 0.5);
    exact_ccd_contact_t stop;
    OK(exact_ccd_detector_free_step(detector, x0, x1, 6, 0.5, &size, positions, &collides, &stop));
    CHECK(collides && size == 0.25 && stop.first == contact.first && stop.impact.time == 0.5);
    stop.impact.time = 7;
    OK(exact_ccd_detector_free_step(detector, x0, x0, 6, 0.5, &size, positions, &collides, &stop));
    CHECK(!collides && size == 1 && stop.impact.time == 7);
    // The result may be in the place of an argument, which the contact has been computed from.
    double end[18];
    memcpy(end, x1, sizeof end);
    OK(exact_ccd_detector_free_step(detector, x0, end, 6, 0.5, &size, end, NULL, &stop));
    CHECK(end[3 * 3 + 2] == 0.5 && stop.impact.points[0][2] == 0);
    OK(exact_ccd_detector_free_step(detector, x0, x1, 6, 0.5, &size, positions, &collides, NULL));
    CHECK(collides);
    OK(exact_ccd_detector_collides(detector, x0, positions, 6, 1, &collides));
    CHECK(!collides);
    fails(exact_ccd_detector_free_step(detector, x0, x1, 6, 2, &size, positions, NULL, NULL),
          EXACT_CCD_STATUS_INVALID_ARGUMENT,
          "2");
    fails(exact_ccd_detector_collides(detector, x0, x1, 5, 1, &collides), EXACT_CCD_STATUS_INVALID_POSITIONS, "5");

    OK(exact_ccd_detector_set_min_distance(detector, 0.5));
    OK(exact_ccd_detector_collision(detector, x0, x1, 6, 1, &collides, &contact));
    CHECK(collides && contact.impact.time == 0.25);
    const double thickness[6] = {0.25, 0.25, 0.25, 0.5, 0.5, 0.5};
    OK(exact_ccd_detector_set_thickness(detector, thickness, 6));
    OK(exact_ccd_detector_collision(detector, x0, x1, 6, 1, &collides, &contact));
    CHECK(collides && contact.impact.time == 0.125);
    OK(exact_ccd_detector_set_min_distance(detector, 0));

    const uint32_t one_group[6] = {7, 7, 7, 7, 7, 7};
    fails(exact_ccd_detector_set_groups(detector, one_group, 5), EXACT_CCD_STATUS_INVALID_ARGUMENT, "5 groups");
    fails(exact_ccd_detector_set_thickness(detector, thickness, 5), EXACT_CCD_STATUS_INVALID_ARGUMENT, "5");
    OK(exact_ccd_detector_collides(detector, x0, x1, 6, 1, &collides));
    CHECK(collides);
    OK(exact_ccd_detector_set_groups(detector, one_group, 6));
    OK(exact_ccd_detector_collides(detector, x0, x1, 6, 1, &collides));
    CHECK(!collides);
    bool was_called = false;
    OK(exact_ccd_detector_set_can_collide(detector, never, &was_called));
    OK(exact_ccd_detector_collides(detector, x0, x1, 6, 1, &collides));
    CHECK(!collides && was_called);
    OK(exact_ccd_detector_set_can_collide(detector, NULL, NULL));
    OK(exact_ccd_detector_collides(detector, x0, x1, 6, 1, &collides));
    CHECK(collides);
    exact_ccd_detector_free(detector);

    exact_ccd_audit_t* audit = NULL;
    OK(exact_ccd_audit_new(mesh, 0, &audit));
    OK(exact_ccd_audit_certify(audit));
    exact_ccd_certificate_t* certificate = NULL;
    exact_ccd_audit_result_t result;
    OK(exact_ccd_audit_examine(audit, x0, 6, &result, &contact));
    CHECK(result == EXACT_CCD_AUDIT_RESULT_FREE);
    fails(exact_ccd_audit_certificate(audit, &certificate), EXACT_CCD_STATUS_UNCERTIFIED, "single frame");
    fails(exact_ccd_audit_certify(audit), EXACT_CCD_STATUS_INVALID_ARGUMENT, "first frame");
    OK(exact_ccd_audit_examine(audit, x1, 6, &result, &contact));
    CHECK(result == EXACT_CCD_AUDIT_RESULT_CONTACT && contact.impact.time == 0.5);
    CHECK(fabs(contact.impact.points[0][2]) < 1e-9 && fabs(contact.impact.points[0][1] - 1) < 1e-9);
    OK(exact_ccd_audit_certificate(audit, &certificate));
    const uint8_t* bytes = NULL;
    size_t byte_count = 0;
    OK(exact_ccd_certificate_data(certificate, &bytes, &byte_count));
    CHECK(byte_count > 50 && bytes[0] == 'e');
    exact_ccd_certificate_free(certificate);
    exact_ccd_audit_free(audit);
    OK(exact_ccd_audit_new(mesh, 0, &audit));
    OK(exact_ccd_audit_examine(audit, x1, 6, &result, &contact));
    CHECK(result == EXACT_CCD_AUDIT_RESULT_INTERSECTION && contact.second == 0);
    CHECK(contact.kind == EXACT_CCD_KIND_EDGE_FACE && contact.vertices[0] == EXACT_CCD_NONE);
    exact_ccd_audit_free(audit);
    exact_ccd_mesh_free(mesh);
}

// Three worlds with one triangle and a vertex that falls at different speeds.
static void worlds(void)
{
    enum { COUNT = 3 };
    const uint32_t face[3] = {1, 2, 3};
    const double heights[COUNT] = {0.5, -1, -3};
    double x0[12 * COUNT], x1[12 * COUNT];
    for (int i = 0; i < COUNT; ++i) {
        memcpy(x0 + 12 * i, FACE_START, sizeof FACE_START);
        memcpy(x1 + 12 * i, FACE_START, sizeof FACE_START);
        x1[12 * i + 2] = heights[i];
    }
    exact_ccd_mesh_t* mesh = NULL;
    exact_ccd_detector_t* detector = NULL;
    OK(exact_ccd_mesh_new(4, face, 1, NULL, 0, &mesh));
    OK(exact_ccd_detector_new(mesh, &detector));

    bool collides[COUNT];
    OK(exact_ccd_worlds_collides(detector, x0, x1, 4, COUNT, 1, collides));
    CHECK(!collides[0] && collides[1] && collides[2]);
    exact_ccd_contact_t contacts[COUNT];
    contacts[0].impact.time = 7;
    OK(exact_ccd_worlds_collision(detector, x0, x1, 4, COUNT, 1, collides, contacts));
    CHECK(!collides[0] && collides[1] && collides[2] && contacts[0].impact.time == 7);
    CHECK(contacts[1].impact.time == 0.5 && contacts[2].impact.time == 0.25);
    CHECK(contacts[2].kind == EXACT_CCD_KIND_VERTEX_FACE && contacts[2].first == 0);

    // Until a time, which the contact of the second world is after.
    OK(exact_ccd_worlds_collision(detector, x0, x1, 4, COUNT, 0.25, collides, contacts));
    CHECK(!collides[0] && !collides[1] && collides[2]);
    OK(exact_ccd_worlds_collides(detector, x0, x1, 4, COUNT, 0.25, collides));
    CHECK(!collides[0] && !collides[1] && collides[2]);
    size_t counts[COUNT], count = 0;
    exact_ccd_contacts_t* list = NULL;
    const exact_ccd_contact_t* data = NULL;
    OK(exact_ccd_worlds_collisions(detector, x0, x1, 4, COUNT, 1, counts, &list));
    CHECK(counts[0] == 0 && counts[1] == 1 && counts[2] == 1);
    OK(exact_ccd_contacts_data(list, &data, &count));
    CHECK(count == 2 && data[0].impact.time == 0.5 && data[1].impact.time == 0.25);
    exact_ccd_contacts_free(list);

    double sizes[COUNT], ends[12 * COUNT];
    OK(exact_ccd_worlds_free_step(detector, x0, x1, 4, COUNT, 0.5, sizes, ends, NULL, NULL));
    CHECK(sizes[0] == 1 && sizes[1] == 0.25 && sizes[2] == 0.125);
    CHECK(ends[2] == 0.5 && ends[14] == 0.5 && ends[26] == 0.5);
    OK(exact_ccd_worlds_collides(detector, x0, ends, 4, COUNT, 1, collides));
    CHECK(!collides[0] && !collides[1] && !collides[2]);
    OK(exact_ccd_detector_set_min_distance(detector, 0.5));
    OK(exact_ccd_worlds_collides(detector, x0, ends, 4, COUNT, 1, collides));
    CHECK(collides[0] && collides[1] && collides[2]);
    OK(exact_ccd_detector_set_min_distance(detector, 0));
    // The results may be in the place of the arguments.
    contacts[0].impact.time = 7;
    contacts[1].impact.time = 7;
    OK(exact_ccd_worlds_free_step(detector, x0, x1, 4, COUNT, 0.5, sizes, x1, collides, contacts));
    CHECK(memcmp(x1, ends, sizeof ends) == 0 && !collides[0] && collides[1] && collides[2]);
    CHECK(contacts[0].impact.time == 7 && contacts[1].impact.time == 0.5 && contacts[2].impact.time == 0.25);

    OK(exact_ccd_worlds_collides(detector, NULL, NULL, 4, 0, 1, NULL));
    x1[12 + 2] = NAN;
    fails(exact_ccd_worlds_collides(detector, x0, x1, 4, COUNT, 1, collides),
          EXACT_CCD_STATUS_INVALID_POSITIONS,
          "world 1: at the end, vertex 0");
    fails(exact_ccd_worlds_collides(
              detector, x0, x1, 3, COUNT, 1, collides),
          EXACT_CCD_STATUS_INVALID_POSITIONS,
          "world 0");
    fails(exact_ccd_worlds_collides(
              detector, x0, x1, 4, SIZE_MAX, 1, collides),
          EXACT_CCD_STATUS_INVALID_ARGUMENT,
          "memory");
    fails(exact_ccd_worlds_collision(detector, x0, x1, 4, COUNT, 1, NULL, contacts),
          EXACT_CCD_STATUS_INVALID_ARGUMENT,
          "collides");
    exact_ccd_detector_free(detector);
    exact_ccd_mesh_free(mesh);
}

// The number of threads may change between any two calls, and belong to a call.
static void numbers_of_threads(void)
{
    const uint32_t counts[] = {3, 1, 0, 2};
    for (int i = 0; i < 4; ++i) {
        OK(exact_ccd_set_threads(counts[i]));
        batches();
        const uint32_t query[4] = {0, 1, 2, 3};
        double time = -1;
        OK(exact_ccd_batch_time_of_impact(
            EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 4, query, 1, 0, 1, counts[3 - i], &time));
        CHECK(time == 0.5);
    }
    fails(exact_ccd_set_threads(1025), EXACT_CCD_STATUS_INVALID_ARGUMENT, "1025 threads");
    fails(exact_ccd_batch_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, NULL, NULL, 0, NULL, 0, 0, 1, UINT32_MAX, NULL),
          EXACT_CCD_STATUS_INVALID_ARGUMENT,
          "4294967295 threads");
}

int main(void)
{
    OK(exact_ccd_set_threads(2));
    versions();
    worlds();
    queries();
    errors();
    batches();
    wrong_batches();
    smallest_times();
    free_steps();
    answers_for_vertices();
    meshes();
    numbers_of_threads();
    return 0;
}
