/* Elementary functions of arrays, at the widths that the processor has.

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

#define WIDTH 2
#include "elementary_functions.h"
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
#undef WIDTH
#ifdef __clang__
#pragma clang attribute pop
#pragma clang attribute push(__attribute__((target("avx512f,avx512dq,avx512vl"))), apply_to = function)
#else
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")
#endif
#define WIDTH 8
#include "elementary_functions.h"
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

/* Compute a function, by its place in the list, of `count` numbers for each argument, in the default environment.
   `width` is the number of doubles in a vector, 0 for the widest. Return the width, or -1 if there is no such
   function or width. */
int elementary_compute(int function, size_t count, const double *const *arguments, double *const *results, int width)
{
    const int most = widest();
    uint64_t before[ENVIRONMENT_WORDS];
    if (width == 0)
        width = most;
    if (function < 0 || function >= 5 || width > most)
        return -1;
    environment_enter(before);
    switch (width) {
    case 2:
        compute_w2(function, count, arguments, results);
        break;
#if defined(__GNUC__) && defined(__x86_64__)
    case 4:
        compute_w4(function, count, arguments, results);
        break;
    case 8:
        compute_w8(function, count, arguments, results);
        break;
#endif
    default:
        width = -1;
    }
    environment_leave(before);
    return width;
}
