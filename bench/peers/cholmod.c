// The time of CHOLMOD for the linear systems that the simulator writes: see docs/simulation/cost.md.
//
// For each file, a symmetric matrix of Matrix Market by its lower triangle: the least of three processor times, in
// ms, of the analysis, factorisation and solution together, and without the analysis.

#include <stdio.h>
#include <time.h>

#include <suitesparse/cholmod.h>

static double processor_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
}

int main(int count, char** files)
{
    cholmod_common common;
    cholmod_start(&common);
    for (int i = 1; i < count; ++i) {
        FILE* file = fopen(files[i], "r");
        cholmod_sparse* matrix = file ? cholmod_read_sparse(file, &common) : NULL;
        if (!matrix) {
            fprintf(stderr, "%s: no matrix in Matrix Market's format\n", files[i]);
            return 2;
        }
        fclose(file);
        cholmod_dense* right = cholmod_ones(matrix->nrow, 1, CHOLMOD_REAL, &common);
        double whole = 1e300, numeric = 1e300;
        for (int attempt = 0; attempt < 3; ++attempt) {
            const double start = processor_ms();
            cholmod_factor* factor = cholmod_analyze(matrix, &common);
            cholmod_factorize(matrix, factor, &common);
            cholmod_dense* solution = cholmod_solve(CHOLMOD_A, factor, right, &common);
            const double solved = processor_ms();
            cholmod_free_dense(&solution, &common);
            // Again, with the analysis and the memory of the first time.
            cholmod_factorize(matrix, factor, &common);
            solution = cholmod_solve(CHOLMOD_A, factor, right, &common);
            const double end = processor_ms();
            if (common.status != CHOLMOD_OK || factor->minor < matrix->nrow) {
                fprintf(stderr, "%s: the matrix is not positive definite\n", files[i]);
                return 2;
            }
            if (solved - start < whole)
                whole = solved - start;
            if (end - solved < numeric)
                numeric = end - solved;
            cholmod_free_dense(&solution, &common);
            cholmod_free_factor(&factor, &common);
        }
        printf("%s: %zu unknowns, %.1f ms, %.1f ms without the analysis\n", files[i], matrix->nrow, whole, numeric);
        cholmod_free_dense(&right, &common);
        cholmod_free_sparse(&matrix, &common);
    }
    cholmod_finish(&common);
    return 0;
}
