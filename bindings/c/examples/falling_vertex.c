// A vertex falls through a face: the time of impact, and the time at which they are 0.25 apart.

#include <math.h>
#include <stdio.h>

#include <exact_ccd.h>

int main(void)
{
    // The vertex, then the three corners of the face, x y z each.
    const double start[12] = {0.25, 0.25, 1.0, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    const double end[12] = {0.25, 0.25, -1.0, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    const double distances[2] = {0.0, 0.25};

    for (int i = 0; i < 2; ++i) {
        double time;
        const exact_ccd_status status =
            exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, start, end, distances[i], &time);
        if (status != EXACT_CCD_STATUS_OK) {
            fprintf(stderr, "%s\n", exact_ccd_last_error());
            return 2;
        }
        if (isnan(time)) {
            printf("never within %g\n", distances[i]);
        } else {
            printf("within %g from t = %.17g on\n", distances[i], time);
        }
    }
    return 0;
}
