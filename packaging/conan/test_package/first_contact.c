#include <exact_ccd.h>
#include <stdio.h>

/* A vertex falls through a face from height 1 to -1, and meets it at t = 0.5. */
int main(void)
{
    const double start[12] = {0.25, 0.25, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    const double end[12] = {0.25, 0.25, -1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    double time;
    if (exact_ccd_time_of_impact(EXACT_CCD_KIND_VERTEX_FACE, start, end, 0, 1, &time) != EXACT_CCD_STATUS_OK) {
        fprintf(stderr, "%s\n", exact_ccd_last_error());
        return 1;
    }
    printf("contact at t = %g\n", time);
    return time == 0.5 ? 0 : 1;
}
