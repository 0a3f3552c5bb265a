/* Two measurements of the machine: memory bandwidth (the triad of STREAM) and double-precision arithmetic. Compiled with
 * and without contraction, `multiply_add` gives the peak with and without fused multiply-add. */
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
