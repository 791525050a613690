// Two rigid meshes in a host that keeps arrays of poses: a tetrahedron passes through a plate in one
// time step, and neither of its ends shows it. Between the poses, each vertex moves in a straight line.

#include <stdio.h>

#include <exact_ccd.h>

#include "rigid_mesh.h"

enum { PLATE = 4, BULLET = 4, VERTICES = PLATE + BULLET };

static const float plate[3 * PLATE] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
static const float bullet[3 * BULLET] = {0, 0, 0.1f, 0.1f, 0, 0, -0.1f, 0.1f, 0, -0.1f, -0.1f, 0};
static const uint32_t faces[] = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7, 4, 7, 5, 5, 7, 6};
// Only vertices of different bodies collide.
static const uint32_t bodies[VERTICES] = {0, 0, 0, 0, 1, 1, 1, 1};
static const double identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
static const double quarter_turn[9] = {0, -1, 0, 1, 0, 0, 0, 0, 1};

static int failed(exact_ccd_status_t status)
{
    if (status != EXACT_CCD_STATUS_OK) {
        fprintf(stderr, "%s\n", exact_ccd_last_error());
    }
    return status != EXACT_CCD_STATUS_OK;
}

int main(void)
{
    const double origin[3] = {0, 0, 0}, above[3] = {0, 0, 0.5}, below[3] = {0.2, 0, -0.5};
    double x0[3 * VERTICES], x1[3 * VERTICES];
    place_vertices(plate, PLATE, origin, identity, x0);
    place_vertices(plate, PLATE, origin, identity, x1);
    place_vertices(bullet, BULLET, above, identity, x0 + 3 * PLATE);
    place_vertices(bullet, BULLET, below, quarter_turn, x1 + 3 * PLATE);

    exact_ccd_mesh_t* mesh = NULL;
    exact_ccd_detector_t* detector = NULL;
    bool collides = false;
    exact_ccd_contact_t contact;
    const int error = failed(exact_ccd_mesh_new(VERTICES, faces, 6, NULL, 0, &mesh))
                      || failed(exact_ccd_detector_new(mesh, &detector))
                      || failed(exact_ccd_detector_set_groups(detector, bodies, VERTICES))
                      || failed(exact_ccd_detector_collision(
                          detector, x0, x1, VERTICES, 1, &collides, &contact));
    if (!error && collides) {
        printf("contact at %.17g of the step, vertices %u %u %u %u\n",
               contact.impact.time,
               contact.vertices[0],
               contact.vertices[1],
               contact.vertices[2],
               contact.vertices[3]);
    }
    exact_ccd_detector_free(detector);
    exact_ccd_mesh_free(mesh);
    return error || !collides;
}
