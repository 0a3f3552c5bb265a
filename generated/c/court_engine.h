/* The event loop of the scene court, LANES_WIDTH shots abreast.

   Generated from templates/c/engine.h.j2, scene court, derivation 6850e5812fbcfc63,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Included by court.c once for every width. The shots in flight fill the first rows of the lists;
   when one ends, the last takes its row. Stages go over all rows, and over those of a list of their
   own where only some shots need them. No shot's result depends on its neighbours. */

#include "lanes.h"

/* A column, with room for a whole row of lanes behind its end. */
typedef double LANES(column)[LANES_ROWS + LANES_WIDTH];
typedef float LANES(singles_column)[LANES_ROWS + LANES_WIDTH];

/* The parameters of shots, a column for each, by name and by number. */
typedef union {
    struct {
        LANES(column) p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_gravity, p_end_depth, p_ring_restitution, p_backboard_restitution, p_bridge_restitution, p_ring_friction, p_backboard_friction, p_bridge_friction, p_inertia, p_tangential_restitution, p_restitution_speed;
    };
    LANES(column) columns[COURT_PARAMETERS];
} LANES(court_parameters);

#include "court_kernels.h"

/* Have the states of the shots from one on fetched while others are worked on, and the places of
   their results, those apart that go past the caches: else each store waits for its line. */
LANES_INLINE void LANES(court_ahead)(const court_job *job, size_t shot, int streams)
{
#ifdef __GNUC__
    const double *state = job->states + COURT_STATE * shot;
    for (int line = 0; line < COURT_STATE * LANES_WIDTH; line += 8)
        __builtin_prefetch(state + line, 0, 2);
    const court_results *out = job->results;
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
    if (out->rolls)
        for (size_t byte = 0; byte < sizeof *out->rolls * LANES_WIDTH; byte += 64)
            __builtin_prefetch((const char *)out->rolls + sizeof *out->rolls * shot + byte, 1, 3);
    if (out->slip_left)
        for (size_t byte = 0; byte < sizeof *out->slip_left * LANES_WIDTH; byte += 64)
            __builtin_prefetch((const char *)out->slip_left + sizeof *out->slip_left * shot + byte, 1, 3);
    if (out->grip_lost)
        for (size_t byte = 0; byte < sizeof *out->grip_lost * LANES_WIDTH; byte += 64)
            __builtin_prefetch((const char *)out->grip_lost + sizeof *out->grip_lost * shot + byte, 1, 3);
    if (out->time_error)
        for (size_t byte = 0; byte < sizeof *out->time_error * LANES_WIDTH; byte += 64)
            __builtin_prefetch((const char *)out->time_error + sizeof *out->time_error * shot + byte, 1, 3);
    if (out->state_error)
        for (size_t byte = 0; byte < 3 * sizeof *out->state_error * LANES_WIDTH; byte += 64)
            __builtin_prefetch((const char *)out->state_error + 3 * sizeof *out->state_error * shot + byte, 1, 3);
    if (out->uncertain)
        for (size_t byte = 0; byte < sizeof *out->uncertain * LANES_WIDTH; byte += 64)
            __builtin_prefetch((const char *)out->uncertain + sizeof *out->uncertain * shot + byte, 1, 3);
    if (out->estimated)
        for (size_t byte = 0; byte < sizeof *out->estimated * LANES_WIDTH; byte += 64)
            __builtin_prefetch((const char *)out->estimated + sizeof *out->estimated * shot + byte, 1, 3);
#else
    (void)job, (void)shot, (void)streams;
#endif
}

/* Where the parameters are finite and allowed. */
static M LANES(court_validate)(const LANES(column) *p, size_t row)
{
    CALL(court_allowed, _allowed_1)(p, row);
    EACH(GET, _allowed_1, allowed)
    CALL(court_parameters_in_range, _parameters_in_range_1)(p, row, allowed);
    EACH(GET_MASK, _parameters_in_range_1, permitted)
    return permitted;
}

#if COURT_PLAIN
#define BOUNDED 0
#define BOUNDS(...)
#define OR_ZERO(name) K(0.0)
#define OR_INFINITE(name) K(INFINITY)
#define LOOP(name) LANES(court_plain_##name)
#include "court_loop.h"
#undef LOOP
#undef BOUNDED
#undef BOUNDS
#undef OR_ZERO
#undef OR_INFINITE
#endif

#if COURT_BOUNDED
#define BOUNDED 1
#define BOUNDS(...) __VA_ARGS__
#define OR_ZERO(name) name
#define OR_INFINITE(name) name
#define LOOP(name) LANES(court_bounded_##name)
#if !COURT_ORDERED_BOUNDS && defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC optimize("no-schedule-insns")
#endif
#include "court_loop.h"
#if !COURT_ORDERED_BOUNDS && defined(__GNUC__) && !defined(__clang__)
#pragma GCC pop_options
#endif
#undef LOOP
#undef BOUNDED
#undef BOUNDS
#undef OR_ZERO
#undef OR_INFINITE
#endif

/* Run the job; return 0 if there is no memory for it. */
static int LANES(court_run)(const court_job *job)
{
#if COURT_PLAIN && COURT_BOUNDED
    return bounded(job) ? LANES(court_bounded_run_allocated)(job) : LANES(court_plain_run_allocated)(job);
#elif COURT_BOUNDED
    return LANES(court_bounded_run_allocated)(job);
#else
    return LANES(court_plain_run_allocated)(job);
#endif
}
