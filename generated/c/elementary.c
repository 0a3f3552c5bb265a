/* Elementary functions of arrays, and the drawing of releases, at the widths that the processor has.

   Generated from templates/c/elementary.c.j2, the same for every scene, with
   Jinja2 3.1.6. Do not edit: change templates/ and run `make generate`.
   They have IEEE operations alone, so they give the same bits on every processor, in NumPy too. The compiler
   makes vectors of the loops. */

#include <math.h>
#include <stddef.h>
#include <stdint.h>

#include "environment.h"
#include "arithmetic.h"

/* What the build says of the sources: a word. */
#ifndef ELEMENTARY_SOURCES
#define ELEMENTARY_SOURCES unknown
#endif
#define TEXT_(word) #word
#define TEXT(word) TEXT_(word)

#define WIDE_PASTE_(name, width) name##_w##width
#define WIDE_PASTE(name, width) WIDE_PASTE_(name, width)
#define WIDE(name) WIDE_PASTE(name, WIDTH)

#if defined(__GNUC__)
#define APART __attribute__((noinline))
#else
#define APART
#endif

/* Numbers that are computed at a time: what lies between two functions stays in the nearest cache. */
#define TILE 128
_Static_assert(TILE % 8 == 0, "a tile is whole vectors");

#include "philox.h"

#define WIDTH 2
#include "elementary_functions.h"
#include "drawing.h"
#undef WIDTH

#if defined(__GNUC__) && defined(__x86_64__)
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
#define WIDTH 4
#include "elementary_functions.h"
#include "drawing.h"
#undef WIDTH
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx512f,avx512dq,avx512vl"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")
#endif
#define WIDTH 8
#include "elementary_functions.h"
#include "drawing.h"
#undef WIDTH
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif

/* Set the default floating-point environment for a thread's own computations, and put back what was there. */
void elementary_enter(uint64_t *before) { environment_enter(before); }
void elementary_leave(const uint64_t *before) { environment_leave(before); }

const char *elementary_sources(void) { return TEXT(ELEMENTARY_SOURCES); }

/* Doubles that the widest vectors of this processor hold. */
static int widest(void)
{
#if defined(__GNUC__) && defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
        return 8;
    if (__builtin_cpu_supports("avx2"))
        return 4;
#endif
    return 2;
}

#if defined(__GNUC__) && defined(__x86_64__)
#define EACH_WIDTH(function, ...) \
    case 2: function##_w2(__VA_ARGS__); break; \
    case 4: function##_w4(__VA_ARGS__); break; \
    case 8: function##_w8(__VA_ARGS__); break;
#else
#define EACH_WIDTH(function, ...) \
    case 2: function##_w2(__VA_ARGS__); break;
#endif

/* Call a function for vectors of `width` doubles, of the widest for 0, in the default environment; return the
   width, or -1 if there is no such one. */
#define CALL(function, ...) \
    uint64_t before[ENVIRONMENT_WORDS]; \
    const int most = widest(); \
    if (width == 0) \
        width = most; \
    if (width > most) \
        return -1; \
    environment_enter(before); \
    switch (width) { \
    EACH_WIDTH(function, __VA_ARGS__) \
    default: width = -1; \
    } \
    environment_leave(before); \
    return width;

/* Compute a function, by its place in the list, of `count` numbers for each argument. Return the number of doubles
   in a vector, or -1 if there is no such function or width. */
int elementary_compute(int function, size_t count, const double *const *arguments, double *const *results, int width)
{
    if (function < 0 || function >= 5)
        return -1;
    CALL(compute, function, count, arguments, results)
}

/* Write the noise of shots; return as `elementary_compute` does. */
int elementary_noise(size_t variables, const uint64_t *streams, const double *weights, const double *deviations, uint64_t seed, uint64_t start, size_t count, double *const *noise, int width)
{
    CALL(noise, variables, streams, weights, deviations, seed, start, count, noise)
}

/* Write the states of releases, given their arguments
   speed, elevation, azimuth, backspin, sidespin, height, distance, angle;
   return as `elementary_compute` does. */
int elementary_release_states(size_t count, const double *const *arguments, const int64_t *strides, double ring_height, double *states, int width)
{
    CALL(release_states, count, arguments, strides, ring_height, states)
}
