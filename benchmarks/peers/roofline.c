/* Measurements of the machine: memory bandwidth (the triad of STREAM), double-precision arithmetic, and the divider.
 * Compiled with and without contraction, `multiply_add` gives the peak with and without fused multiply-add. */
#include <math.h>
#include <stdint.h>

#ifdef __AVX512F__
enum { WIDTH = 8, CHAINS = 16 };
#elif defined(__AVX__)
enum { WIDTH = 4, CHAINS = 10 };
#else
enum { WIDTH = 2, CHAINS = 10 };
#endif
typedef double Vector __attribute__((vector_size(8 * WIDTH)));

void triad(double *restrict a, const double *restrict b, const double *restrict c, int64_t count)
{
    for (int64_t i = 0; i < count; ++i) a[i] = b[i] + 0.7 * c[i];
}

/* Returns the operations done: one multiplication and one addition a lane, chain and turn. */
double multiply_add(int64_t turns, double *result)
{
    Vector chain[CHAINS], factor, term;
    for (int lane = 0; lane < WIDTH; ++lane) {
        factor[lane] = 0.999;
        term[lane] = 1e-3;
        for (int k = 0; k < CHAINS; ++k) chain[k][lane] = 1.0 + k;
    }
    for (int64_t turn = 0; turn < turns; ++turn) {
#pragma GCC unroll 16
        for (int k = 0; k < CHAINS; ++k) chain[k] = chain[k] * factor + term;
    }
    Vector sum = chain[0];
    for (int k = 1; k < CHAINS; ++k) sum += chain[k];
    *result = 0.0;
    for (int lane = 0; lane < WIDTH; ++lane) *result += sum[lane];
    return 2.0 * WIDTH * CHAINS * (double)turns;
}

/* The same of divisions. */
double divide(int64_t turns, double *result)
{
    Vector chain[CHAINS], over;
    for (int lane = 0; lane < WIDTH; ++lane) {
        over[lane] = 1.5;
        for (int k = 0; k < CHAINS; ++k) chain[k][lane] = 1.0 + k;
    }
    for (int64_t turn = 0; turn < turns; ++turn) {
#pragma GCC unroll 16
        for (int k = 0; k < CHAINS; ++k) chain[k] = over / chain[k];
    }
    Vector sum = chain[0];
    for (int k = 1; k < CHAINS; ++k) sum += chain[k];
    *result = 0.0;
    for (int lane = 0; lane < WIDTH; ++lane) *result += sum[lane];
    return 1.0 * WIDTH * CHAINS * (double)turns;
}

/* And of square roots. */
double root(int64_t turns, double *result)
{
    double chain[CHAINS * WIDTH];
    for (int k = 0; k < CHAINS * WIDTH; ++k) chain[k] = 1.0 + k;
    for (int64_t turn = 0; turn < turns; ++turn)
        for (int k = 0; k < CHAINS * WIDTH; ++k) chain[k] = sqrt(chain[k]);
    *result = 0.0;
    for (int k = 0; k < CHAINS * WIDTH; ++k) *result += chain[k];
    return 1.0 * WIDTH * CHAINS * (double)turns;
}
