/* The event loop of the scene hoop, LANES_WIDTH shots abreast.

   Generated from templates/c/engine.h.j2, scene hoop, derivation d045c64f80c6d78c,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Included by hoop.c once for every width. The shots in flight fill the first rows of the lists;
   when one ends, the last takes its row. Stages go over all rows, and over those of a list of their
   own where only some shots need them. No shot's result depends on its neighbours. */

#include "lanes.h"

/* A column, with room for a whole row of lanes behind its end. */
typedef double LANES(column)[LANES_ROWS + LANES_WIDTH];
typedef float LANES(singles_column)[LANES_ROWS + LANES_WIDTH];

/* The parameters of shots, a column for each, by name and by number. */
typedef union {
    struct {
        LANES(column) p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_restitution, p_gravity, p_end_depth;
    };
    LANES(column) columns[HOOP_PARAMETERS];
} LANES(hoop_parameters);

#include "hoop_kernels.h"

/* Have the states of the shots from one on fetched while others are worked on, and the places of
   their results, those apart that go past the caches: else each store waits for its line. */
LANES_INLINE void LANES(hoop_ahead)(const hoop_job *job, size_t shot, int streams)
{
#ifdef __GNUC__
    const double *state = job->states + HOOP_STATE * shot;
    for (int line = 0; line < HOOP_STATE * LANES_WIDTH; line += 8)
        __builtin_prefetch(state + line, 0, 2);
    const hoop_results *out = job->results;
    if (out->outcome)
        for (size_t byte = 0; byte < sizeof *out->outcome * LANES_WIDTH; byte += 64)
            __builtin_prefetch((const char *)out->outcome + sizeof *out->outcome * shot + byte, 1, 3);
    if (out->contacts)
        for (size_t byte = 0; byte < sizeof *out->contacts * LANES_WIDTH; byte += 64)
            __builtin_prefetch((const char *)out->contacts + sizeof *out->contacts * shot + byte, 1, 3);
    if (out->counts)
        for (size_t byte = 0; byte < 3 * sizeof *out->counts * LANES_WIDTH; byte += 64)
            __builtin_prefetch((const char *)out->counts + 3 * sizeof *out->counts * shot + byte, 1, 3);
    if (out->first)
        for (size_t byte = 0; byte < sizeof *out->first * LANES_WIDTH; byte += 64)
            __builtin_prefetch((const char *)out->first + sizeof *out->first * shot + byte, 1, 3);
    if (out->time)
        for (size_t byte = 0; byte < sizeof *out->time * LANES_WIDTH; byte += 64)
            __builtin_prefetch((const char *)out->time + sizeof *out->time * shot + byte, 1, 3);
    if (out->state && !streams)
        for (size_t byte = 0; byte < 9 * sizeof *out->state * LANES_WIDTH; byte += 64)
            __builtin_prefetch((const char *)out->state + 9 * sizeof *out->state * shot + byte, 1, 3);
    if (out->time_error)
        for (size_t byte = 0; byte < sizeof *out->time_error * LANES_WIDTH; byte += 64)
            __builtin_prefetch((const char *)out->time_error + sizeof *out->time_error * shot + byte, 1, 3);
    if (out->state_error)
        for (size_t byte = 0; byte < 3 * sizeof *out->state_error * LANES_WIDTH; byte += 64)
            __builtin_prefetch((const char *)out->state_error + 3 * sizeof *out->state_error * shot + byte, 1, 3);
    if (out->uncertain)
        for (size_t byte = 0; byte < sizeof *out->uncertain * LANES_WIDTH; byte += 64)
            __builtin_prefetch((const char *)out->uncertain + sizeof *out->uncertain * shot + byte, 1, 3);
#else
    (void)job, (void)shot, (void)streams;
#endif
}

/* Where the parameters are finite and allowed. */
static M LANES(hoop_validate)(const LANES(column) *p, size_t row)
{
    CALL(hoop_allowed, _allowed_1)(p, row);
    EACH(GET, _allowed_1, allowed)
    CALL(hoop_parameters_in_range, _parameters_in_range_1)(p, row, allowed);
    EACH(GET_MASK, _parameters_in_range_1, permitted)
    return permitted;
}

#if HOOP_PLAIN
#define BOUNDED 0
#define BOUNDS(...)
#define OR_ZERO(name) K(0.0)
#define OR_INFINITE(name) K(INFINITY)
#define TIGHTENING 0
/* Whether no shots are begun until those in flight have ended. */
#define HELD 0
#define LOOP(name) LANES(hoop_plain_##name)
#include "hoop_loop.h"
#undef LOOP
#undef TIGHTENING
#undef HELD
#undef BOUNDED
#undef BOUNDS
#undef OR_ZERO
#undef OR_INFINITE
#endif

#if HOOP_BOUNDED
#define BOUNDED 1
#define BOUNDS(...) __VA_ARGS__
#define OR_ZERO(name) name
#define OR_INFINITE(name) name
#define TIGHTENING worklist->tightening
/* Whether no shots are begun until those in flight have ended. */
#define HELD (TIGHTENING || worklist->loose_shots + LANES_SHOTS > LANES_LOOSE)
#define LOOP(name) LANES(hoop_bounded_##name)
#if !HOOP_ORDERED_BOUNDS && defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC optimize("no-schedule-insns")
#endif
#include "hoop_loop.h"
#if !HOOP_ORDERED_BOUNDS && defined(__GNUC__) && !defined(__clang__)
#pragma GCC pop_options
#endif
#undef LOOP
#undef TIGHTENING
#undef HELD
#undef BOUNDED
#undef BOUNDS
#undef OR_ZERO
#undef OR_INFINITE
#endif

/* Run the job; return 0 if there is no memory for it. */
static int LANES(hoop_run)(const hoop_job *job)
{
#if HOOP_PLAIN && HOOP_BOUNDED
    return bounded(job) ? LANES(hoop_bounded_run_allocated)(job) : LANES(hoop_plain_run_allocated)(job);
#elif HOOP_BOUNDED
    return LANES(hoop_bounded_run_allocated)(job);
#else
    return LANES(hoop_plain_run_allocated)(job);
#endif
}
