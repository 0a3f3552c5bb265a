/* hoop: the widths, and the choice among them.

   Generated from templates/c/scene.c.j2, scene hoop, derivation 6070df632d9c93b8,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`. */

#include "hoop.h"

#include <float.h>
#include <math.h>
#include <string.h>

#if FLT_EVAL_METHOD != 0
#error "doubles must be evaluated in double precision (on 32-bit x86: -msse2 -mfpmath=sse)"
#endif
#ifdef __FAST_MATH__
#error "fast-math changes results: compile without it"
#endif

/* What the widths share: where shots come from and where their results go. */
typedef struct {
    size_t shots;
    const double *states;
    const double *const *parameters;
    const int64_t *strides;
    const int8_t *leaving;
    int varying; /* whether any parameter has one value per shot */
    int32_t max_contacts;
    const volatile int32_t *stop;
    const hoop_results *results;
} hoop_job;

#define LANES_PASTE_(name, width) name##_w##width
#define LANES_PASTE(name, width) LANES_PASTE_(name, width)
#define LANES(name) LANES_PASTE(name, LANES_WIDTH)

#if defined(__GNUC__)
#define LANES_INLINE static inline __attribute__((always_inline))

#define LANES_WIDTH 2
#include "hoop_engine.h"
#undef LANES_WIDTH

#if defined(__x86_64__)

#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
#define LANES_WIDTH 4
#include "hoop_engine.h"
#undef LANES_WIDTH
#ifdef __clang__
#pragma clang attribute pop
#pragma clang attribute push(__attribute__((target("avx512f,avx512dq,avx512vl"))), apply_to = function)
#else
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")
#endif
#define LANES_WIDTH 8
#include "hoop_engine.h"
#undef LANES_WIDTH
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

#endif
#else
#define LANES_INLINE static inline
#endif

#define LANES_WIDTH 1
#include "hoop_engine.h"
#undef LANES_WIDTH

static int widest(void)
{
#if defined(__GNUC__) && defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
        return 8;
    if (__builtin_cpu_supports("avx2"))
        return 4;
#endif
#if defined(__GNUC__)
    return 2;
#else
    return 1;
#endif
}

int hoop_simulate(size_t shots, const double *states, const double *const *parameters,
                  const int64_t *strides, const int8_t *leaving, int32_t max_contacts, int width,
                  const volatile int32_t *stop, const hoop_results *results)
{
    hoop_job job = {shots, states, parameters, strides, leaving, 0, max_contacts, stop, results};
    const int most = widest();
    for (int k = 0; k < HOOP_PARAMETERS; k++)
        job.varying |= strides[k] != 0;
    if (width == 0)
        width = most;
    if (width > most || max_contacts < 1)
        return -1;
    switch (width) {
    case 1:
        hoop_run_w1(&job);
        return width;
#if defined(__GNUC__)
    case 2:
        hoop_run_w2(&job);
        return width;
#if defined(__x86_64__)
    case 4:
        hoop_run_w4(&job);
        return width;
    case 8:
        hoop_run_w8(&job);
        return width;
#endif
#endif
    default:
        return -1;
    }
}
