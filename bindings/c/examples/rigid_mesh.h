// The vertices of a rigid mesh in the world, from the arrays that MuJoCo and similar hosts keep: local
// vertices in float, a position and a rotation matrix, row by row.

#ifndef EXACT_CCD_EXAMPLES_RIGID_MESH_H
#define EXACT_CCD_EXAMPLES_RIGID_MESH_H

static void place_vertices(
    const float* local, int vertex_count, const double position[3], const double rotation[9], double* world)
{
    for (int vertex = 0; vertex < vertex_count; ++vertex) {
        const float* v = local + 3 * vertex;
        for (int axis = 0; axis < 3; ++axis) {
            const double* row = rotation + 3 * axis;
            world[3 * vertex + axis] = position[axis] + row[0] * v[0] + row[1] * v[1] + row[2] * v[2];
        }
    }
}

#endif
