/* court: the widths, and the choice among them.

   Generated from templates/c/scene.c.j2, scene court, derivation 6850e5812fbcfc63,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`. */

#include "court.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#if defined(__GNUC__) && defined(__x86_64__)
#include <immintrin.h>
#endif
#if defined(_MSC_VER) && !defined(__clang__)
#include <intrin.h>
#elif defined(__STDC_NO_ATOMICS__)
#error "threads share a batch by atomics, an optional part of C11 that this compiler has not"
#else
#include <stdatomic.h>
#endif

#include "environment.h"
#include "arithmetic.h"

_Static_assert(sizeof(court_environment) == ENVIRONMENT_WORDS * sizeof(uint64_t), "words of an environment");

/* Native vectors of a value above one lane: two are faster unless kernels are long; one takes less time
   to compile, by GCC or Clang for an x86-64 processor with AVX2 or AVX-512. */
#ifndef COURT_VECTORS
#define COURT_VECTORS 2
#endif
#define LANES_VECTORS COURT_VECTORS

/* Whether GCC allocates the registers of a function as one region, which takes a tenth to a sixth less
   time for long kernels and makes no slower code of them. */
#ifndef COURT_ONE_REGION
#define COURT_ONE_REGION (LANES_VECTORS == 1)
#endif
#if COURT_ONE_REGION && defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("ira-region=one")
#endif

/* Whether GCC orders the instructions of the loop with bounds before it assigns registers, where that of
   loops is of use: it loses if kernels need many more registers than there are. */
#ifndef COURT_ORDERED_BOUNDS
#define COURT_ORDERED_BOUNDS 1
#endif

/* Lanes of a value in registers of so many bits. */
#if LANES_VECTORS == 1
#define LANES_IN_256 4
#define LANES_IN_512 8
#else
#define LANES_IN_256 8
#define LANES_IN_512 16
#endif

/* The widest vectors that are compiled. A build may ask for fewer, which take less time. */
#ifndef COURT_WIDEST
#if defined(__GNUC__) && defined(__x86_64__)
#define COURT_WIDEST LANES_IN_512
#elif defined(__GNUC__)
#define COURT_WIDEST 4
#else
#define COURT_WIDEST 1
#endif
#endif

/* Which widths are compiled; a build may ask for one alone, which takes least time, or for that of
   its own processor and one lane, with which the library runs on any other. */
#if defined(COURT_ONLY)
#define BUILT(width) (COURT_ONLY == (width))
#elif defined(COURT_NATIVE)
#define BUILT(width) (COURT_WIDEST >= (width) && ((width) == 1 || COURT_NATIVE == (width)))
#else
#define BUILT(width) (COURT_WIDEST >= (width))
#endif

/* Which loops are compiled; a build may ask for one alone, which takes less time. The loop with bounds
   on errors serves calls without as well, slower. */
#ifndef COURT_PLAIN
#define COURT_PLAIN 1
#endif
#ifndef COURT_BOUNDED
#define COURT_BOUNDED 1
#endif

/* What the build says of the sources: a word. */
#ifndef COURT_SOURCES
#define COURT_SOURCES unknown
#endif
#define TEXT_(word) #word
#define TEXT(word) TEXT_(word)

/* What the widths share: where shots come from and where their results go. */
typedef struct {
    size_t shots;
    const double *states;
    const double *const *parameters;
    const int64_t *strides;
    const int8_t *leaving;
    int varying; /* whether any parameter has one value per shot */
    int32_t max_contacts;
    double time_limit;
    const volatile int32_t *stop;
    size_t *next;
    size_t parts;
    const court_results *results;
} court_job;

#define LANES_PASTE_(name, width) name##_w##width
#define LANES_PASTE(name, width) LANES_PASTE_(name, width)
#define LANES(name) LANES_PASTE(name, LANES_WIDTH)

#if defined(__GNUC__)
#define LANES_INLINE static inline __attribute__((always_inline))
#else
#define LANES_INLINE static inline
#endif

/* Shots in flight at once: what the stages read and write of them stays in the nearer caches, and
   what few shots need at a time fills lanes. */
#define LANES_SHOTS (LANES_WIDTH > 1 ? 512 : 256)
/* Shots that are launched at most before anybody may stop the run. */
#define LANES_LAUNCHED (8 * LANES_SHOTS)
/* Behind them are the rows of those that stay in contact. */
#define LANES_ROWS (2 * LANES_SHOTS)

/* Whether any result needs bounds on errors. */
static int bounded(const court_job *job)
{
    const court_results *out = job->results;
    return out->event_errors || out->grip_lost || out->time_error || out->state_error || out->uncertain || out->estimated;
}

/* Whether the caller wants no more; another thread may say so at any time. */
static int stopped(const court_job *job)
{
#if defined(_MSC_VER) && !defined(__clang__)
    return job->stop != NULL && *job->stop != 0;
#else
    return job->stop != NULL &&
           atomic_load_explicit((const volatile _Atomic int32_t *)job->stop, memory_order_relaxed) != 0;
#endif
}

/* Whether a number that threads have in common was still *seen, and is `then` now; else *seen is
   what it is. */
static int exchanged(size_t *common, size_t *seen, size_t then)
{
#if defined(_MSC_VER) && !defined(__clang__)
    void *const was = _InterlockedCompareExchangePointer((void *volatile *)common, (void *)then, (void *)*seen);
    const int same = was == (void *)*seen;
    *seen = (size_t)was;
    return same;
#else
    return atomic_compare_exchange_strong((_Atomic size_t *)common, seen, then);
#endif
}

/* Take shots that no thread has begun, *end behind the last of them, and return the first: fewer and
   fewer, so that there are few seams, where threads write to the same pages, and all end together. */
static size_t court_take(const court_job *job, size_t *end)
{
    const size_t least = 64;
    size_t start = 0, some;
    do {
        const size_t left = start < job->shots ? job->shots - start : 0, rows = left / job->parts / least * least;
        some = rows ? rows : left < least ? left : least;
    } while (!exchanged(job->next, &start, start + some));
    *end = start + some;
    return start;
}

/* Write numbers that nobody here reads again past the caches, where the processor can. */
static void stream(double *to, const double *numbers, size_t count)
{
#if defined(__GNUC__) && defined(__x86_64__)
    if ((uintptr_t)to % 16 == 0) {
        for (; count > 1; to += 2, numbers += 2, count -= 2)
            _mm_stream_pd(to, _mm_loadu_pd(numbers));
    }
#endif
    memcpy(to, numbers, count * sizeof *numbers);
}

/* Have all threads see what went past the caches. */
static void streamed(void)
{
#if defined(__GNUC__) && defined(__x86_64__)
    _mm_sfence();
#endif
}

/* Idle lanes for which the next shots are fetched. */
#define LANES_SPARE (LANES_WIDTH < 4 ? 1 : LANES_WIDTH / 4)

#if BUILT(4) && LANES_VECTORS == 2
#define LANES_WIDTH 4
#include "exact.h"
#include "court_engine.h"
#undef LANES_WIDTH
#endif

#if BUILT(LANES_IN_256)
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
#define LANES_WIDTH LANES_IN_256
#include "exact.h"
#include "court_engine.h"
#undef LANES_WIDTH
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif

#if BUILT(LANES_IN_512)
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx512f,avx512dq,avx512vl"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")
/* Divisions and roots take long: what does not need them is moved in between. It takes registers,
   of which other vectors have half as many. */
#pragma GCC optimize("schedule-insns", "sched-pressure", "rename-registers")
#endif
#define LANES_WIDTH LANES_IN_512
#include "exact.h"
#include "court_engine.h"
#undef LANES_WIDTH
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif

#if BUILT(1)
#define LANES_WIDTH 1
#include "exact.h"
#include "court_engine.h"
#undef LANES_WIDTH
#endif

static int widest(void)
{
#ifdef COURT_ONLY
    return COURT_ONLY; /* who asks for one alone knows the processor */
#else
#if BUILT(LANES_IN_512)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
        return LANES_IN_512;
#endif
#if BUILT(LANES_IN_256)
    if (__builtin_cpu_supports("avx2"))
        return LANES_IN_256;
#endif
    return BUILT(4) && LANES_VECTORS == 2 ? 4 : 1;
#endif
}

/* Return what is wrong with the arguments, 0 if nothing is: nothing is read yet that they point to
   but what is looked at here. */
static int court_error(const court_job *job)
{
    const court_results *out = job->results;
    const int surfaces = COURT_SURFACES;
    if (job->shots > PTRDIFF_MAX / (COURT_STATE * sizeof(double)))
        return COURT_ERROR_SHOTS;
    if (job->shots != 0 && job->states == NULL)
        return COURT_ERROR_STATES;
    for (int k = 0; k < COURT_PARAMETERS; k++) {
        if (job->parameters == NULL || job->parameters[k] == NULL)
            return COURT_ERROR_PARAMETERS;
        if (job->strides == NULL || (job->strides[k] != 0 && job->strides[k] != 1))
            return COURT_ERROR_STRIDES;
    }
    if (job->leaving) {
        int wrong = 0;
        for (size_t shot = 0; shot < job->shots; shot++) {
            const int surface = job->leaving[shot];
            wrong |= (surface < -1) | (surface >= surfaces);
        }
        if (wrong)
            return COURT_ERROR_LEAVING;
    }
    if (job->max_contacts < 1)
        return COURT_ERROR_MAX_CONTACTS;
    if (!(job->time_limit > 0.0))
        return COURT_ERROR_TIME_LIMIT;
    if (out == NULL)
        return COURT_ERROR_RESULTS;
    if (!COURT_BOUNDED && bounded(job))
        return COURT_ERROR_RESULTS;
    if ((out->events == NULL) != (out->event_counts == NULL) || (out->event_errors && out->events == NULL))
        return COURT_ERROR_EVENTS;
    if (out->events) {
        if (job->max_contacts > (INT32_MAX - 1) / COURT_LOG_ROWS)
            return COURT_ERROR_EVENTS;
        const size_t rows = COURT_LOG_ROWS * (size_t)job->max_contacts + 1;
        if (job->shots > PTRDIFF_MAX / sizeof *out->events / rows)
            return COURT_ERROR_EVENTS;
    }
    if (job->next == NULL)
        return COURT_ERROR_NEXT;
    if (job->parts < 1)
        return COURT_ERROR_PARTS;
    return 0;
}

void court_enter(court_environment *before) { environment_enter(before->words); }
void court_leave(const court_environment *before) { environment_leave(before->words); }

const char *court_sources(void) { return TEXT(COURT_SOURCES); }

int court_missing_width(void)
{
    const int built = BUILT(LANES_IN_512) ? LANES_IN_512 : BUILT(LANES_IN_256) ? LANES_IN_256 : BUILT(4) ? 4 : 1;
    return widest() == 1 && built > 1 ? built : 0;
}

int court_simulate(size_t shots, const double *states, const double *const *parameters,
                  const int64_t *strides, const int8_t *leaving, int32_t max_contacts,
                  double time_limit, int width,
                  const volatile int32_t *stop, const court_results *results)
{
    size_t next = 0;
    return court_share(shots, states, parameters, strides, leaving, max_contacts, time_limit, width,
                      stop, results, &next, 1);
}

/* Run a job in the default environment. No compiler knows of environments: were it inlined, operations
   could move out of this one. */
#if defined(_MSC_VER) && !defined(__clang__)
__declspec(noinline)
#elif defined(__GNUC__)
__attribute__((noinline))
#endif
static int court_run(court_job *job, int width)
{
    const int most = widest(), error = court_error(job);
    if (error)
        return error;
    for (int k = 0; k < COURT_PARAMETERS; k++)
        job->varying |= job->strides[k] != 0;
    if (width == 0)
        width = job->shots == 1 && BUILT(1) ? 1 : most;
    if (width > most)
        return COURT_ERROR_WIDTH;
#define RUN(width) \
    case width: \
        if (!exact_w##width()) \
            return COURT_ERROR_ARITHMETIC; \
        if (!court_run_w##width(job)) \
            return COURT_ERROR_MEMORY; \
        streamed(); \
        return width;
    switch (width) {
#if BUILT(1)
        RUN(1)
#endif
#if BUILT(4)
        RUN(4)
#endif
#if BUILT(8)
        RUN(8)
#endif
#if BUILT(16)
        RUN(16)
#endif
    default:
        return COURT_ERROR_WIDTH;
    }
}

int court_share(size_t shots, const double *states, const double *const *parameters,
               const int64_t *strides, const int8_t *leaving, int32_t max_contacts,
               double time_limit, int width, const volatile int32_t *stop,
               const court_results *results, size_t *next, size_t parts)
{
    court_job job = {shots, states, parameters, strides, leaving, 0, max_contacts, time_limit,
                              stop, next, parts, results};
    court_environment before;
    court_enter(&before);
    const int used = court_run(&job, width);
    court_leave(&before);
    return used;
}
