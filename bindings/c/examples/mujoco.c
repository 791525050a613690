// Validates the steps of a MuJoCo simulation: `mujoco MODEL.xml`. All mesh geoms are one mesh, whose groups
// are the bodies; between two steps, each vertex moves in a straight line. In examples/mujoco.xml a bullet
// passes through a plate, and no contact of MuJoCo shows it.

#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <exact_ccd.h>

#include "rigid_mesh.h"

static void check(exact_ccd_status_t status)
{
    if (status != EXACT_CCD_STATUS_OK) {
        fprintf(stderr, "%s\n", exact_ccd_last_error());
        exit(2);
    }
}

// The index of the mesh of a geom, -1 if it is no mesh.
static int mesh_of(const mjModel* model, int geom)
{
    return model->geom_type[geom] == mjGEOM_MESH ? model->geom_dataid[geom] : -1;
}

static void place_geoms(const mjModel* model, const mjData* data, double* x)
{
    for (int geom = 0; geom < model->ngeom; ++geom) {
        const int mesh = mesh_of(model, geom);
        if (mesh >= 0) {
            const float* local = model->mesh_vert + 3 * model->mesh_vertadr[mesh];
            const int count = model->mesh_vertnum[mesh];
            place_vertices(local, count, data->geom_xpos + 3 * geom, data->geom_xmat + 9 * geom, x);
            x += 3 * count;
        }
    }
}

int main(int argc, char** argv)
{
    char message[1000] = "mujoco MODEL.xml";
    mjModel* model = argc == 2 ? mj_loadXML(argv[1], NULL, message, sizeof message) : NULL;
    if (model == NULL) {
        fprintf(stderr, "%s\n", message);
        return 2;
    }
    mjData* data = mj_makeData(model);

    // The faces and bodies of all mesh geoms, one after the other.
    size_t vertex_count = 0, face_count = 0;
    for (int geom = 0; geom < model->ngeom; ++geom) {
        const int mesh = mesh_of(model, geom);
        vertex_count += mesh < 0 ? 0 : (size_t)model->mesh_vertnum[mesh];
        face_count += mesh < 0 ? 0 : (size_t)model->mesh_facenum[mesh];
    }
    uint32_t* faces = malloc(3 * face_count * sizeof *faces);
    uint32_t* bodies = malloc(vertex_count * sizeof *bodies);
    double* x0 = malloc(3 * vertex_count * sizeof *x0);
    double* x1 = malloc(3 * vertex_count * sizeof *x1);
    size_t vertex = 0, corner = 0;
    for (int geom = 0; geom < model->ngeom; ++geom) {
        const int mesh = mesh_of(model, geom);
        if (mesh >= 0) {
            for (int i = 0; i < 3 * model->mesh_facenum[mesh]; ++i) {
                const int local = model->mesh_face[3 * model->mesh_faceadr[mesh] + i];
                faces[corner++] = (uint32_t)(vertex + (size_t)local);
            }
            for (int i = 0; i < model->mesh_vertnum[mesh]; ++i) {
                bodies[vertex++] = (uint32_t)model->geom_bodyid[geom];
            }
        }
    }

    exact_ccd_mesh_t* mesh = NULL;
    exact_ccd_detector_t* detector = NULL;
    check(exact_ccd_mesh_new(vertex_count, faces, face_count, NULL, 0, &mesh));
    check(exact_ccd_detector_new(mesh, &detector));
    check(exact_ccd_detector_set_groups(detector, bodies, vertex_count));

    if (model->nv > 2) {
        data->qvel[2] = -50;
    }
    mj_forward(model, data);
    place_geoms(model, data, x0);
    int missed = 0;
    for (int step = 1; step <= 5; ++step) {
        mj_step(model, data);
        mj_forward(model, data);
        place_geoms(model, data, x1);
        bool collides = false;
        exact_ccd_contact_t contact;
        check(exact_ccd_detector_collision(detector, x0, x1, vertex_count, 1, &collides, &contact));
        printf("step %d: %d contacts of MuJoCo", step, (int)data->ncon);
        if (collides) {
            printf(", first contact at %.17g of the step", contact.impact.time);
            missed += data->ncon == 0;
        }
        printf("\n");
        memcpy(x0, x1, 3 * vertex_count * sizeof *x0);
    }
    printf("%d steps with contact between their ends only\n", missed);

    exact_ccd_detector_free(detector);
    exact_ccd_mesh_free(mesh);
    free(x1);
    free(x0);
    free(bodies);
    free(faces);
    mj_deleteData(data);
    mj_deleteModel(model);
    return missed == 0;
}
