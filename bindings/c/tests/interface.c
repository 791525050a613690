// All functions of the C interface, on cases whose answers are known, and their errors.

#include <float.h>
#include <math.h>
#include <string.h>

#include <exact_ccd.h>

#include "check.h"

#define OK(call) CHECK((call) == EXACT_CCD_STATUS_OK)

static void fails(exact_ccd_status status, exact_ccd_status expected, const char* word)
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
    CHECK(exact_ccd_abi_version() == EXACT_CCD_ABI_VERSION);
    CHECK(strlen(exact_ccd_version()) >= 5);
}

static void queries(void)
{
    bool collides = false;
    OK(exact_ccd_collides(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0, &collides));
    CHECK(collides);

    double time = -1;
    OK(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0, &time));
    CHECK(time == 0.5);
    OK(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0.5, &time));
    CHECK(time == 0.25);
    OK(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_START, 0.5, &time));
    CHECK(isnan(time));

    exact_ccd_impact_t impact;
    OK(exact_ccd_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0, &collides, &impact));
    CHECK(collides && impact.time == 0.5 && impact.time_is_exact && impact.has_normal);
    CHECK(fabs(impact.normal[2] - 1) < 1e-9 && fabs(impact.parameters[0] - 0.25) < 1e-9);

    exact_ccd_interval_t intervals[32];
    size_t count = 99;
    OK(exact_ccd_intervals(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0.5, intervals, 32, &count));
    CHECK(count == 1 && intervals[0].start == 0.25 && intervals[0].end == 0.75);
    OK(exact_ccd_intervals(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0.5, NULL, 0, &count));
    CHECK(count == 1);

    double lower = 0, upper = 0;
    OK(exact_ccd_distance_at(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0.25, &lower, &upper));
    CHECK(lower == 0.5 && upper == 0.5);

    // Points that pass each other at the distance 3 come within 5 at t = 1/4.
    const double point_start[6] = {0, 3, -8, 0, 0, 0}, point_end[6] = {0, 3, 8, 0, 0, 0};
    OK(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_VERTEX, point_start, point_end, 5, &time));
    CHECK(time == 0.25);
    const double edge_start[9] = {0, 3, -8, -9, 0, 0, 9, 0, 0}, edge_end[9] = {0, 3, 8, -9, 0, 0, 9, 0, 0};
    OK(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_EDGE, edge_start, edge_end, 5, &time));
    CHECK(time == 0.25);
}

static void errors(void)
{
    bool collides;
    double time;
    const exact_ccd_status argument = EXACT_CCD_STATUS_INVALID_ARGUMENT;
    fails(exact_ccd_collides(EXACT_CCD_KIND_VERTEX_FACE, NULL, FACE_END, 0, &collides), argument, "points_t0");
    fails(exact_ccd_collides(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 0, NULL), argument, "collides");
    fails(exact_ccd_collides(7, FACE_START, FACE_END, 0, &collides), argument, "kind is 7");
    fails(exact_ccd_collides(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, -1, &collides), argument, "-1");
    fails(exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, NAN, &time), argument, "NaN");

    double not_finite[12];
    memcpy(not_finite, FACE_END, sizeof not_finite);
    not_finite[4] = INFINITY;
    fails(exact_ccd_collides(EXACT_CCD_KIND_VERTEX_FACE, FACE_START, not_finite, 0, &collides),
          EXACT_CCD_STATUS_INVALID_POSITIONS,
          "inf");

    const uint32_t out_of_range[4] = {0, 1, 2, 4};
    fails(exact_ccd_batch_times(
              EXACT_CCD_KIND_VERTEX_FACE, FACE_START, FACE_END, 4, out_of_range, 1, 0, &time),
          EXACT_CCD_STATUS_INVALID_MESH,
          "vertex 4");

    exact_ccd_mesh* mesh = NULL;
    const uint32_t face[3] = {0, 1, 9};
    fails(exact_ccd_mesh_new(4, face, 1, NULL, 0, &mesh), EXACT_CCD_STATUS_INVALID_MESH, "vertex 9");
    CHECK(mesh == NULL);
    exact_ccd_mesh_free(NULL);
    exact_ccd_detector_free(NULL);
    exact_ccd_contacts_free(NULL);
    exact_ccd_audit_free(NULL);
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
    OK(exact_ccd_batch_times(EXACT_CCD_KIND_VERTEX_FACE, x0, x1, 5, queries, 2, 0, times));
    CHECK(times[0] == 0.5 && isnan(times[1]));
    OK(exact_ccd_batch_times(EXACT_CCD_KIND_VERTEX_FACE, x0, x1, 5, queries, 2, 0.5, times));
    CHECK(times[0] == 0.25 && isnan(times[1]));
    const double thickness[5] = {0.25, 0, 0.25, 0, 0};
    OK(exact_ccd_batch_times_thick(EXACT_CCD_KIND_VERTEX_FACE, x0, x1, 5, queries, 2, thickness, times));
    CHECK(times[0] == 0.25 && isnan(times[1]));
    OK(exact_ccd_batch_times(EXACT_CCD_KIND_VERTEX_FACE, NULL, NULL, 0, NULL, 0, 0, NULL));
}

static bool never(uint32_t a, uint32_t b, void* calls)
{
    (void)a;
    (void)b;
    *(bool*)calls = true;
    return false;
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

    exact_ccd_mesh* mesh = NULL;
    OK(exact_ccd_mesh_new(6, faces, 2, NULL, 0, &mesh));
    size_t face_count, edge_count, loose;
    OK(exact_ccd_mesh_counts(mesh, &face_count, &edge_count, &loose));
    CHECK(face_count == 2 && edge_count == 6 && loose == 0);
    uint32_t edges[12];
    OK(exact_ccd_mesh_edges(mesh, edges, 6));
    CHECK(edges[0] == 0 && edges[1] == 1);
    fails(exact_ccd_mesh_edges(mesh, edges, 5), EXACT_CCD_STATUS_INVALID_ARGUMENT, "6 edges");

    bool intersects = true;
    OK(exact_ccd_has_intersections(mesh, x0, 6, &intersects, NULL, NULL));
    CHECK(!intersects);
    uint32_t edge = 99, face = 99;
    double crossing[18];
    memcpy(crossing, x1, sizeof crossing);
    OK(exact_ccd_has_intersections(mesh, crossing, 6, &intersects, &edge, &face));
    CHECK(intersects && face == 0 && edge < 6);

    exact_ccd_detector* detector = NULL;
    OK(exact_ccd_detector_new(mesh, &detector));
    bool is_free = true, is_found = false;
    OK(exact_ccd_detector_is_free(detector, x0, x1, 6, &is_free));
    CHECK(!is_free);
    exact_ccd_contact_t contact;
    OK(exact_ccd_detector_earliest_contact(detector, x0, x1, 6, &is_found, &contact));
    CHECK(is_found && contact.impact.time == 0.5 && contact.kind == EXACT_CCD_KIND_VERTEX_FACE);
    CHECK(contact.first == 3 && contact.second == 0 && contact.vertices[0] == 3 && contact.vertices[3] == 2);

    exact_ccd_contacts* contacts = NULL;
    OK(exact_ccd_detector_contacts(detector, x0, x1, 6, 1, &contacts));
    const exact_ccd_contact_t* data = NULL;
    size_t count = 0;
    OK(exact_ccd_contacts_data(contacts, &data, &count));
    CHECK(count == 1 && data[0].impact.time == 0.5);
    exact_ccd_contacts_free(contacts);

    double size = -1, positions[18];
    OK(exact_ccd_detector_free_step(detector, x0, x1, 6, 0.5, &size, positions));
    CHECK(size == 0.25 && positions[3 * 3 + 2] == 0.5);
    OK(exact_ccd_detector_is_free(detector, x0, positions, 6, &is_free));
    CHECK(is_free);
    fails(exact_ccd_detector_free_step(detector, x0, x1, 6, 2, &size, positions),
          EXACT_CCD_STATUS_INVALID_ARGUMENT,
          "2");
    fails(exact_ccd_detector_is_free(detector, x0, x1, 5, &is_free), EXACT_CCD_STATUS_INVALID_POSITIONS, "5");

    OK(exact_ccd_detector_set_min_distance(detector, 0.5));
    OK(exact_ccd_detector_earliest_contact(detector, x0, x1, 6, &is_found, &contact));
    CHECK(is_found && contact.impact.time == 0.25);
    const double thickness[6] = {0.25, 0.25, 0.25, 0.5, 0.5, 0.5};
    OK(exact_ccd_detector_set_thickness(detector, thickness, 6));
    OK(exact_ccd_detector_earliest_contact(detector, x0, x1, 6, &is_found, &contact));
    CHECK(is_found && contact.impact.time == 0.125);
    OK(exact_ccd_detector_set_min_distance(detector, 0));

    const uint32_t one_group[6] = {7, 7, 7, 7, 7, 7};
    OK(exact_ccd_detector_set_groups(detector, one_group, 6));
    OK(exact_ccd_detector_is_free(detector, x0, x1, 6, &is_free));
    CHECK(is_free);
    bool was_called = false;
    OK(exact_ccd_detector_set_can_collide(detector, never, &was_called));
    OK(exact_ccd_detector_is_free(detector, x0, x1, 6, &is_free));
    CHECK(is_free && was_called);
    OK(exact_ccd_detector_set_can_collide(detector, NULL, NULL));
    OK(exact_ccd_detector_is_free(detector, x0, x1, 6, &is_free));
    CHECK(!is_free);
    exact_ccd_detector_free(detector);

    exact_ccd_audit* audit = NULL;
    OK(exact_ccd_audit_new(mesh, 0, &audit));
    exact_ccd_audit_result result;
    OK(exact_ccd_audit_examine(audit, x0, 6, &result, &contact));
    CHECK(result == EXACT_CCD_AUDIT_RESULT_FREE);
    OK(exact_ccd_audit_examine(audit, x1, 6, &result, &contact));
    CHECK(result == EXACT_CCD_AUDIT_RESULT_CONTACT && contact.impact.time == 0.5);
    exact_ccd_audit_free(audit);
    OK(exact_ccd_audit_new(mesh, 0, &audit));
    OK(exact_ccd_audit_examine(audit, x1, 6, &result, &contact));
    CHECK(result == EXACT_CCD_AUDIT_RESULT_INTERSECTION && contact.second == 0);
    exact_ccd_audit_free(audit);
    exact_ccd_mesh_free(mesh);
}

int main(void)
{
    OK(exact_ccd_set_threads(2));
    versions();
    queries();
    errors();
    batches();
    meshes();
    return 0;
}
