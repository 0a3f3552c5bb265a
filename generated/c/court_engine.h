/* The event loop of the scene court, LANES_WIDTH shots abreast.

   Generated from templates/c/engine.h.j2, scene court, derivation 8eaab50db1d45604,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Included by court.c once for every width. The shots in flight fill the first rows of the lists;
   when one ends, the last takes its row. Stages go over all rows, and over those of a list of their
   own where only some shots need them. No shot's result depends on its neighbours. */

#include "court_lanes.h"
#include "court_kernels.h"

/* A column, with room for a whole row of lanes behind its end. */
typedef double LANES(court_column)[2 * LANES_SHOTS + LANES_WIDTH];
typedef float LANES(court_singles)[2 * LANES_SHOTS + LANES_WIDTH];

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
#else
    (void)job, (void)shot, (void)streams;
#endif
}

/* Where the parameters are finite and allowed. */
LANES_INLINE M LANES(court_permit)(V p_ball_radius, V p_ring_radius, V p_wire_radius, V p_board_distance, V p_board_half_width, V p_board_bottom, V p_board_top, V p_board_thickness, V p_bridge_half_width, V p_bridge_depth, V p_gravity, V p_end_depth, V p_ring_restitution, V p_backboard_restitution, V p_bridge_restitution, V p_ring_friction, V p_backboard_friction, V p_bridge_friction, V p_tangential_restitution, V p_restitution_speed)
{
    const LANES(court_allowed_out) _o1 =
        LANES(court_allowed)(p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_gravity, p_end_depth, p_ring_restitution, p_backboard_restitution, p_bridge_restitution, p_ring_friction, p_backboard_friction, p_bridge_friction, p_tangential_restitution, p_restitution_speed);
    V allowed = _o1.allowed;
    const LANES(court_finite_parameters_out) _o2 =
        LANES(court_finite_parameters)(p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_gravity, p_end_depth, p_ring_restitution, p_backboard_restitution, p_bridge_restitution, p_ring_friction, p_backboard_friction, p_bridge_friction, p_tangential_restitution, p_restitution_speed, allowed);
    M permitted = _o2.permitted;
    return permitted;
}

/* Shots in flight, a column for each quantity, and the lists of those that need a longer look. */
typedef struct {
    _Alignas(64) size_t shot[2 * LANES_SHOTS];
    LANES(court_column) x; /* of the state */
    LANES(court_column) y; /* of the state */
    LANES(court_column) z; /* of the state */
    LANES(court_column) vx; /* of the state */
    LANES(court_column) vy; /* of the state */
    LANES(court_column) vz; /* of the state */
    LANES(court_column) wx; /* of the state */
    LANES(court_column) wy; /* of the state */
    LANES(court_column) wz; /* of the state */
    LANES(court_column) clock; /* time of the last event, s since the release */
    LANES(court_column) last; /* surface that was touched last, -1: none */
    LANES(court_column) first; /* body that was touched first, -1: none */
    LANES(court_column) contacts; /* how many contacts there were */
    LANES(court_column) count_0; /* contacts with ring */
    LANES(court_column) count_1; /* contacts with backboard */
    LANES(court_column) count_2; /* contacts with bridge */
    LANES(court_column) held; /* surface that it stays in contact with, -1: none */
    LANES(court_column) mode; /* 0: in flight; 1, 2, 3: contact begins, goes on, ends */
    LANES(court_column) circled; /* 1: it rolls on a ring, and does not leave since a turning point */
    LANES(court_column) rolls; /* how many times it began to roll */
    LANES(court_column) slip_left; /* 1: its bounces ended with slip left, which friction cannot stop */
    LANES(court_column) through; /* 1: it has fallen through the ring, -1: it came up through it */
    LANES(court_column) outcome; /* how it ended, -1: in flight */
    LANES(court_column) p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_gravity, p_end_depth, p_ring_restitution, p_backboard_restitution, p_bridge_restitution, p_ring_friction, p_backboard_friction, p_bridge_friction, p_tangential_restitution, p_restitution_speed;
    /* Shots whose balls stay in contact: they wait for one another, and then have rows of their
       own behind those of the others, so that all lanes work. */
    size_t waiting;
    size_t waiting_shot[LANES_SHOTS];
    LANES(court_column) waiting_x;
    LANES(court_column) waiting_y;
    LANES(court_column) waiting_z;
    LANES(court_column) waiting_vx;
    LANES(court_column) waiting_vy;
    LANES(court_column) waiting_vz;
    LANES(court_column) waiting_wx;
    LANES(court_column) waiting_wy;
    LANES(court_column) waiting_wz;
    LANES(court_column) waiting_clock;
    LANES(court_column) waiting_last;
    LANES(court_column) waiting_first;
    LANES(court_column) waiting_contacts;
    LANES(court_column) waiting_count_0;
    LANES(court_column) waiting_count_1;
    LANES(court_column) waiting_count_2;
    LANES(court_column) waiting_held;
    LANES(court_column) waiting_mode;
    LANES(court_column) waiting_circled;
    LANES(court_column) waiting_rolls;
    LANES(court_column) waiting_slip_left;
    LANES(court_column) waiting_through;
    LANES(court_column) waiting_p_ball_radius, waiting_p_ring_radius, waiting_p_wire_radius, waiting_p_board_distance, waiting_p_board_half_width, waiting_p_board_bottom, waiting_p_board_top, waiting_p_board_thickness, waiting_p_bridge_half_width, waiting_p_bridge_depth, waiting_p_gravity, waiting_p_end_depth, waiting_p_ring_restitution, waiting_p_backboard_restitution, waiting_p_bridge_restitution, waiting_p_ring_friction, waiting_p_backboard_friction, waiting_p_bridge_friction, waiting_p_tangential_restitution, waiting_p_restitution_speed;
    LANES(court_column) x_before, y_before, z_before, vx_before, vy_before, vz_before, wx_before, wy_before, wz_before;
    LANES(court_column) body;
    LANES(court_column) began;
    LANES(court_column) extent;
    LANES(court_column) kept;
    LANES(court_column) limited;
    LANES(court_column) rests;
    LANES(court_column) rolling;
    LANES(court_column) speed;
    LANES(court_column) time_error;
    LANES(court_column) when;
    LANES(court_column) which;
    LANES(court_column) open_row;
    LANES(court_column) open_extent;
    LANES(court_column) open_last;
    LANES(court_column) open_p_ball_radius;
    LANES(court_column) open_p_gravity;
    LANES(court_column) open_p_ring_radius;
    LANES(court_column) open_p_wire_radius;
    LANES(court_column) open_speed;
    LANES(court_column) open_until;
    LANES(court_column) open_vx;
    LANES(court_column) open_vy;
    LANES(court_column) open_vz;
    LANES(court_column) open_when;
    LANES(court_column) open_which;
    LANES(court_column) open_x;
    LANES(court_column) open_y;
    LANES(court_column) open_z;
    LANES(court_column) open_arrival;
    LANES(court_column) open_ceiling;
    LANES(court_column) open_certain;
    LANES(court_column) open_flat;
    LANES(court_column) open_rho_start;
    LANES(court_column) open_searching;
    LANES(court_column) open_served;
    LANES(court_column) open_share;
    LANES(court_singles) open_short_t;
    LANES(court_column) open_since;
    LANES(court_column) open_tilt;
    LANES(court_column) open_leaping_row;
    LANES(court_column) open_leaping_leaping;
    LANES(court_column) open_leaping_p_ball_radius;
    LANES(court_column) open_leaping_p_gravity;
    LANES(court_column) open_leaping_p_ring_radius;
    LANES(court_column) open_leaping_p_wire_radius;
    LANES(court_singles) open_leaping_short_ceiling;
    LANES(court_singles) open_leaping_short_drift;
    LANES(court_singles) open_leaping_short_end;
    LANES(court_singles) open_leaping_short_flat;
    LANES(court_singles) open_leaping_short_grit;
    LANES(court_singles) open_leaping_short_high1;
    LANES(court_singles) open_leaping_short_high2;
    LANES(court_singles) open_leaping_short_jerk;
    LANES(court_singles) open_leaping_short_low1;
    LANES(court_singles) open_leaping_short_low2;
    LANES(court_singles) open_leaping_short_parting;
    LANES(court_singles) open_leaping_short_rate_margin;
    LANES(court_singles) open_leaping_short_rho_start;
    LANES(court_singles) open_leaping_short_steady;
    LANES(court_singles) open_leaping_short_swing;
    LANES(court_singles) open_leaping_short_t;
    LANES(court_singles) open_leaping_short_tilt;
    LANES(court_singles) open_leaping_short_vx;
    LANES(court_singles) open_leaping_short_vy;
    LANES(court_singles) open_leaping_short_vz;
    LANES(court_singles) open_leaping_short_x;
    LANES(court_singles) open_leaping_short_y;
    LANES(court_singles) open_leaping_short_z;
    LANES(court_column) open_searching_row;
    LANES(court_column) open_searching_arrival;
    LANES(court_column) open_searching_certain;
    LANES(court_column) open_searching_extent;
    LANES(court_column) open_searching_last;
    LANES(court_column) open_searching_p_ball_radius;
    LANES(court_column) open_searching_p_gravity;
    LANES(court_column) open_searching_p_ring_radius;
    LANES(court_column) open_searching_p_wire_radius;
    LANES(court_column) open_searching_share;
    LANES(court_column) open_searching_speed;
    LANES(court_column) open_searching_t;
    LANES(court_column) open_searching_until;
    LANES(court_column) open_searching_vx;
    LANES(court_column) open_searching_vy;
    LANES(court_column) open_searching_vz;
    LANES(court_column) open_searching_x;
    LANES(court_column) open_searching_y;
    LANES(court_column) open_searching_z;
    LANES(court_column) open_searching_ceiling;
    LANES(court_column) open_searching_flat;
    LANES(court_column) open_searching_rho_start;
    LANES(court_column) open_searching_tilt;
    LANES(court_column) open_searching_searching_row;
    LANES(court_column) open_searching_searching_arrival;
    LANES(court_column) open_searching_searching_ceiling;
    LANES(court_column) open_searching_searching_certain;
    LANES(court_column) open_searching_searching_end;
    LANES(court_column) open_searching_searching_extent;
    LANES(court_column) open_searching_searching_flat;
    LANES(court_column) open_searching_searching_high0;
    LANES(court_column) open_searching_searching_high1;
    LANES(court_column) open_searching_searching_high2;
    LANES(court_column) open_searching_searching_last;
    LANES(court_column) open_searching_searching_latest;
    LANES(court_column) open_searching_searching_low0;
    LANES(court_column) open_searching_searching_low1;
    LANES(court_column) open_searching_searching_low2;
    LANES(court_column) open_searching_searching_p_ball_radius;
    LANES(court_column) open_searching_searching_p_gravity;
    LANES(court_column) open_searching_searching_p_ring_radius;
    LANES(court_column) open_searching_searching_p_wire_radius;
    LANES(court_column) open_searching_searching_rate_slack;
    LANES(court_column) open_searching_searching_rho_start;
    LANES(court_column) open_searching_searching_searching;
    LANES(court_column) open_searching_searching_share;
    LANES(court_column) open_searching_searching_speed;
    LANES(court_column) open_searching_searching_steady;
    LANES(court_column) open_searching_searching_swing;
    LANES(court_column) open_searching_searching_t;
    LANES(court_column) open_searching_searching_tilt;
    LANES(court_column) open_searching_searching_vx;
    LANES(court_column) open_searching_searching_vy;
    LANES(court_column) open_searching_searching_vz;
    LANES(court_column) open_searching_searching_x;
    LANES(court_column) open_searching_searching_y;
    LANES(court_column) open_searching_searching_z;
    LANES(court_column) open_arrives;
    LANES(court_column) open_refining_row;
    LANES(court_column) open_refining_arrival;
    LANES(court_column) open_refining_ceiling;
    LANES(court_column) open_refining_certain;
    LANES(court_column) open_refining_leaving;
    LANES(court_column) open_refining_p_ball_radius;
    LANES(court_column) open_refining_p_gravity;
    LANES(court_column) open_refining_p_ring_radius;
    LANES(court_column) open_refining_p_wire_radius;
    LANES(court_column) open_refining_refining;
    LANES(court_column) open_refining_rho_start;
    LANES(court_column) open_refining_vx;
    LANES(court_column) open_refining_vy;
    LANES(court_column) open_refining_vz;
    LANES(court_column) open_refining_x;
    LANES(court_column) open_refining_y;
    LANES(court_column) open_refining_z;
    LANES(court_column) reachable_row;
    LANES(court_column) reachable_extent;
    LANES(court_column) reachable_last;
    LANES(court_column) reachable_p_ball_radius;
    LANES(court_column) reachable_p_board_bottom;
    LANES(court_column) reachable_p_board_distance;
    LANES(court_column) reachable_p_board_half_width;
    LANES(court_column) reachable_p_board_thickness;
    LANES(court_column) reachable_p_board_top;
    LANES(court_column) reachable_p_gravity;
    LANES(court_column) reachable_speed;
    LANES(court_column) reachable_vx;
    LANES(court_column) reachable_vy;
    LANES(court_column) reachable_vz;
    LANES(court_column) reachable_when;
    LANES(court_column) reachable_which;
    LANES(court_column) reachable_x;
    LANES(court_column) reachable_y;
    LANES(court_column) reachable_z;
    LANES(court_column) reachable_arrival;
    LANES(court_column) reachable_ceiling;
    LANES(court_column) reachable_certain;
    LANES(court_column) reachable_flat;
    LANES(court_column) reachable_tilt;
    LANES(court_column) reachable_searching_row;
    LANES(court_column) reachable_searching_arrival;
    LANES(court_column) reachable_searching_ceiling;
    LANES(court_column) reachable_searching_certain;
    LANES(court_column) reachable_searching_end;
    LANES(court_column) reachable_searching_extent;
    LANES(court_column) reachable_searching_flat;
    LANES(court_column) reachable_searching_high0;
    LANES(court_column) reachable_searching_high1;
    LANES(court_column) reachable_searching_last;
    LANES(court_column) reachable_searching_latest;
    LANES(court_column) reachable_searching_low0;
    LANES(court_column) reachable_searching_low1;
    LANES(court_column) reachable_searching_p_ball_radius;
    LANES(court_column) reachable_searching_p_board_bottom;
    LANES(court_column) reachable_searching_p_board_distance;
    LANES(court_column) reachable_searching_p_board_half_width;
    LANES(court_column) reachable_searching_p_board_thickness;
    LANES(court_column) reachable_searching_p_board_top;
    LANES(court_column) reachable_searching_p_gravity;
    LANES(court_column) reachable_searching_rate_slack;
    LANES(court_column) reachable_searching_searching;
    LANES(court_column) reachable_searching_share;
    LANES(court_column) reachable_searching_speed;
    LANES(court_column) reachable_searching_t;
    LANES(court_column) reachable_searching_tilt;
    LANES(court_column) reachable_searching_vx;
    LANES(court_column) reachable_searching_vy;
    LANES(court_column) reachable_searching_vz;
    LANES(court_column) reachable_searching_x;
    LANES(court_column) reachable_searching_y;
    LANES(court_column) reachable_searching_z;
    LANES(court_column) reachable_arrives;
    LANES(court_column) reachable_refining_row;
    LANES(court_column) reachable_refining_arrival;
    LANES(court_column) reachable_refining_ceiling;
    LANES(court_column) reachable_refining_certain;
    LANES(court_column) reachable_refining_leaving;
    LANES(court_column) reachable_refining_p_ball_radius;
    LANES(court_column) reachable_refining_p_board_bottom;
    LANES(court_column) reachable_refining_p_board_distance;
    LANES(court_column) reachable_refining_p_board_half_width;
    LANES(court_column) reachable_refining_p_board_thickness;
    LANES(court_column) reachable_refining_p_board_top;
    LANES(court_column) reachable_refining_p_gravity;
    LANES(court_column) reachable_refining_refining;
    LANES(court_column) reachable_refining_vx;
    LANES(court_column) reachable_refining_vy;
    LANES(court_column) reachable_refining_vz;
    LANES(court_column) reachable_refining_x;
    LANES(court_column) reachable_refining_y;
    LANES(court_column) reachable_refining_z;
    LANES(court_column) reachable_p_bridge_depth;
    LANES(court_column) reachable_p_bridge_half_width;
    LANES(court_column) reachable_p_ring_radius;
    LANES(court_column) reachable_p_wire_radius;
    LANES(court_column) reachable_searching_p_bridge_depth;
    LANES(court_column) reachable_searching_p_bridge_half_width;
    LANES(court_column) reachable_searching_p_ring_radius;
    LANES(court_column) reachable_searching_p_wire_radius;
    LANES(court_column) reachable_refining_p_bridge_depth;
    LANES(court_column) reachable_refining_p_bridge_half_width;
    LANES(court_column) reachable_refining_p_ring_radius;
    LANES(court_column) reachable_refining_p_wire_radius;
    LANES(court_column) kept_row;
    LANES(court_column) kept_circled;
    LANES(court_column) kept_clock;
    LANES(court_column) kept_held;
    LANES(court_column) kept_mode;
    LANES(court_column) kept_p_ball_radius;
    LANES(court_column) kept_p_board_bottom;
    LANES(court_column) kept_p_board_distance;
    LANES(court_column) kept_p_board_half_width;
    LANES(court_column) kept_p_board_thickness;
    LANES(court_column) kept_p_board_top;
    LANES(court_column) kept_p_bridge_depth;
    LANES(court_column) kept_p_bridge_half_width;
    LANES(court_column) kept_p_end_depth;
    LANES(court_column) kept_p_gravity;
    LANES(court_column) kept_p_ring_radius;
    LANES(court_column) kept_p_wire_radius;
    LANES(court_column) kept_rests;
    LANES(court_column) kept_through;
    LANES(court_column) kept_vx;
    LANES(court_column) kept_vy;
    LANES(court_column) kept_vz;
    LANES(court_column) kept_when;
    LANES(court_column) kept_wx;
    LANES(court_column) kept_wy;
    LANES(court_column) kept_wz;
    LANES(court_column) kept_x;
    LANES(court_column) kept_y;
    LANES(court_column) kept_z;
    LANES(court_column) kept_began;
    LANES(court_column) kept_circling;
    LANES(court_column) kept_leaves;
    LANES(court_column) kept_lift;
    LANES(court_column) kept_per_reach;
    LANES(court_column) kept_rolling;
    LANES(court_column) kept_snap;
    LANES(court_column) kept_surge;
    LANES(court_column) kept_which;
    LANES(court_column) kept_rolling_row;
    LANES(court_column) kept_rolling_bent_x;
    LANES(court_column) kept_rolling_bent_y;
    LANES(court_column) kept_rolling_bent_z;
    LANES(court_column) kept_rolling_clock;
    LANES(court_column) kept_rolling_held;
    LANES(court_column) kept_rolling_nx;
    LANES(court_column) kept_rolling_ny;
    LANES(court_column) kept_rolling_nz;
    LANES(court_column) kept_rolling_p_ball_radius;
    LANES(court_column) kept_rolling_p_board_bottom;
    LANES(court_column) kept_rolling_p_board_distance;
    LANES(court_column) kept_rolling_p_board_half_width;
    LANES(court_column) kept_rolling_p_board_thickness;
    LANES(court_column) kept_rolling_p_board_top;
    LANES(court_column) kept_rolling_p_bridge_depth;
    LANES(court_column) kept_rolling_p_bridge_half_width;
    LANES(court_column) kept_rolling_p_end_depth;
    LANES(court_column) kept_rolling_p_gravity;
    LANES(court_column) kept_rolling_p_ring_radius;
    LANES(court_column) kept_rolling_p_wire_radius;
    LANES(court_column) kept_rolling_per_reach;
    LANES(court_column) kept_rolling_rolling;
    LANES(court_column) kept_rolling_through;
    LANES(court_column) kept_rolling_vx;
    LANES(court_column) kept_rolling_vy;
    LANES(court_column) kept_rolling_vz;
    LANES(court_column) kept_rolling_which;
    LANES(court_column) kept_rolling_wx;
    LANES(court_column) kept_rolling_wy;
    LANES(court_column) kept_rolling_wz;
    LANES(court_column) kept_rolling_x;
    LANES(court_column) kept_rolling_y;
    LANES(court_column) kept_rolling_z;
    LANES(court_column) kept_circling_row;
    LANES(court_column) kept_circling_circled;
    LANES(court_column) kept_circling_circling;
    LANES(court_column) kept_circling_clock;
    LANES(court_column) kept_circling_p_ball_radius;
    LANES(court_column) kept_circling_p_board_bottom;
    LANES(court_column) kept_circling_p_board_distance;
    LANES(court_column) kept_circling_p_board_half_width;
    LANES(court_column) kept_circling_p_board_thickness;
    LANES(court_column) kept_circling_p_board_top;
    LANES(court_column) kept_circling_p_bridge_depth;
    LANES(court_column) kept_circling_p_bridge_half_width;
    LANES(court_column) kept_circling_p_end_depth;
    LANES(court_column) kept_circling_p_gravity;
    LANES(court_column) kept_circling_p_ring_radius;
    LANES(court_column) kept_circling_p_wire_radius;
    LANES(court_column) kept_circling_through;
    LANES(court_column) kept_circling_vx;
    LANES(court_column) kept_circling_vy;
    LANES(court_column) kept_circling_vz;
    LANES(court_column) kept_circling_which;
    LANES(court_column) kept_circling_wx;
    LANES(court_column) kept_circling_wy;
    LANES(court_column) kept_circling_wz;
    LANES(court_column) kept_circling_x;
    LANES(court_column) kept_circling_y;
    LANES(court_column) kept_circling_z;
    LANES(court_column) kept_leaves_row;
    LANES(court_column) kept_leaves_held;
    LANES(court_column) kept_leaves_lift;
    LANES(court_column) kept_leaves_p_ball_radius;
    LANES(court_column) kept_leaves_p_board_bottom;
    LANES(court_column) kept_leaves_p_board_distance;
    LANES(court_column) kept_leaves_p_board_half_width;
    LANES(court_column) kept_leaves_p_board_thickness;
    LANES(court_column) kept_leaves_p_board_top;
    LANES(court_column) kept_leaves_p_bridge_depth;
    LANES(court_column) kept_leaves_p_bridge_half_width;
    LANES(court_column) kept_leaves_p_end_depth;
    LANES(court_column) kept_leaves_p_gravity;
    LANES(court_column) kept_leaves_p_ring_radius;
    LANES(court_column) kept_leaves_p_wire_radius;
    LANES(court_column) kept_leaves_per_reach;
    LANES(court_column) kept_leaves_snap;
    LANES(court_column) kept_leaves_surge;
    LANES(court_column) kept_leaves_vx;
    LANES(court_column) kept_leaves_vy;
    LANES(court_column) kept_leaves_vz;
    LANES(court_column) kept_leaves_x;
    LANES(court_column) kept_leaves_y;
    LANES(court_column) kept_leaves_z;
    LANES(court_column) kept_leaves_when;
    LANES(court_column) kept_leaves_which;
    LANES(court_column) slow_row;
    LANES(court_column) slow_held;
    LANES(court_column) slow_mode;
    LANES(court_column) slow_outcome;
    LANES(court_column) slow_p_backboard_friction;
    LANES(court_column) slow_p_backboard_restitution;
    LANES(court_column) slow_p_ball_radius;
    LANES(court_column) slow_p_board_bottom;
    LANES(court_column) slow_p_board_distance;
    LANES(court_column) slow_p_board_half_width;
    LANES(court_column) slow_p_board_thickness;
    LANES(court_column) slow_p_board_top;
    LANES(court_column) slow_p_bridge_depth;
    LANES(court_column) slow_p_bridge_friction;
    LANES(court_column) slow_p_bridge_half_width;
    LANES(court_column) slow_p_bridge_restitution;
    LANES(court_column) slow_p_end_depth;
    LANES(court_column) slow_p_gravity;
    LANES(court_column) slow_p_ring_friction;
    LANES(court_column) slow_p_ring_radius;
    LANES(court_column) slow_p_ring_restitution;
    LANES(court_column) slow_p_wire_radius;
    LANES(court_column) slow_slip_left;
    LANES(court_column) slow_vx;
    LANES(court_column) slow_vy;
    LANES(court_column) slow_vz;
    LANES(court_column) slow_which;
    LANES(court_column) slow_wx;
    LANES(court_column) slow_wy;
    LANES(court_column) slow_wz;
    LANES(court_column) slow_x;
    LANES(court_column) slow_y;
    LANES(court_column) slow_z;
} LANES(court_plain_lists);

/* Put the next shots into rows, from one on. */
LANES_INLINE void LANES(court_plain_begin)(LANES(court_plain_lists) *lists, size_t row, size_t shots, const court_job *job, size_t start)
{
    const double *state = job->states + COURT_STATE * start;
    size_t k = 0;
    for (; k + LANES_WIDTH <= shots; k += LANES_WIDTH) {
        double *const columns[] = {
            lists->x + row + k,
            lists->y + row + k,
            lists->z + row + k,
            lists->vx + row + k,
            lists->vy + row + k,
            lists->vz + row + k,
            lists->wx + row + k,
            lists->wy + row + k,
            lists->wz + row + k,
        };
        lanes_columns(columns, state + COURT_STATE * k, COURT_STATE);
    }
    for (; k < shots; k++) {
        lists->x[row + k] = state[COURT_STATE * k + 0];
        lists->y[row + k] = state[COURT_STATE * k + 1];
        lists->z[row + k] = state[COURT_STATE * k + 2];
        lists->vx[row + k] = state[COURT_STATE * k + 3];
        lists->vy[row + k] = state[COURT_STATE * k + 4];
        lists->vz[row + k] = state[COURT_STATE * k + 5];
        lists->wx[row + k] = state[COURT_STATE * k + 6];
        lists->wy[row + k] = state[COURT_STATE * k + 7];
        lists->wz[row + k] = state[COURT_STATE * k + 8];
    }
    if (job->varying)
        for (k = 0; k < shots; k++) {
            lists->p_ball_radius[row + k] = job->parameters[0][job->strides[0] * (int64_t)(start + k)];
            lists->p_ring_radius[row + k] = job->parameters[1][job->strides[1] * (int64_t)(start + k)];
            lists->p_wire_radius[row + k] = job->parameters[2][job->strides[2] * (int64_t)(start + k)];
            lists->p_board_distance[row + k] = job->parameters[3][job->strides[3] * (int64_t)(start + k)];
            lists->p_board_half_width[row + k] = job->parameters[4][job->strides[4] * (int64_t)(start + k)];
            lists->p_board_bottom[row + k] = job->parameters[5][job->strides[5] * (int64_t)(start + k)];
            lists->p_board_top[row + k] = job->parameters[6][job->strides[6] * (int64_t)(start + k)];
            lists->p_board_thickness[row + k] = job->parameters[7][job->strides[7] * (int64_t)(start + k)];
            lists->p_bridge_half_width[row + k] = job->parameters[8][job->strides[8] * (int64_t)(start + k)];
            lists->p_bridge_depth[row + k] = job->parameters[9][job->strides[9] * (int64_t)(start + k)];
            lists->p_gravity[row + k] = job->parameters[10][job->strides[10] * (int64_t)(start + k)];
            lists->p_end_depth[row + k] = job->parameters[11][job->strides[11] * (int64_t)(start + k)];
            lists->p_ring_restitution[row + k] = job->parameters[12][job->strides[12] * (int64_t)(start + k)];
            lists->p_backboard_restitution[row + k] = job->parameters[13][job->strides[13] * (int64_t)(start + k)];
            lists->p_bridge_restitution[row + k] = job->parameters[14][job->strides[14] * (int64_t)(start + k)];
            lists->p_ring_friction[row + k] = job->parameters[15][job->strides[15] * (int64_t)(start + k)];
            lists->p_backboard_friction[row + k] = job->parameters[16][job->strides[16] * (int64_t)(start + k)];
            lists->p_bridge_friction[row + k] = job->parameters[17][job->strides[17] * (int64_t)(start + k)];
            lists->p_tangential_restitution[row + k] = job->parameters[18][job->strides[18] * (int64_t)(start + k)];
            lists->p_restitution_speed[row + k] = job->parameters[19][job->strides[19] * (int64_t)(start + k)];
        }
    for (k = 0; k < shots; k++)
        lists->shot[row + k] = start + k;
    for (k = 0; k < shots; k += LANES_WIDTH) {
        lanes_store(lists->clock + row + k, K(0.0));
        lanes_store(lists->first + row + k, K(-1.0));
        lanes_store(lists->contacts + row + k, K(0.0));
        lanes_store(lists->count_0 + row + k, K(0.0));
        lanes_store(lists->count_1 + row + k, K(0.0));
        lanes_store(lists->count_2 + row + k, K(0.0));
        lanes_store(lists->held + row + k, K(-1.0));
        lanes_store(lists->mode + row + k, K(0.0));
        lanes_store(lists->circled + row + k, K(0.0));
        lanes_store(lists->rolls + row + k, K(0.0));
        lanes_store(lists->slip_left + row + k, K(0.0));
        lanes_store(lists->through + row + k, K(0.0));
        lanes_store(lists->outcome + row + k, K(-1.0));
        lanes_store(lists->last + row + k, K(-1.0));
    }
    if (job->leaving)
        for (k = 0; k < shots; k++)
            lists->last[row + k] = (double)job->leaving[start + k];
    if (job->results->events)
        memset(job->results->event_counts + start, 0, shots * sizeof(int32_t));
}

/* Write the results of the shots in rows that follow one another, none of them invalid. */
LANES_INLINE void LANES(court_plain_finish_all)(const LANES(court_plain_lists) *lists, size_t shots, const court_job *job)
{
    const court_results *out = job->results;
    const size_t start = lists->shot[0];
    if (out->outcome)
        for (size_t k = 0; k < shots; k++) {
            out->outcome[start + k] = (uint8_t)(int32_t)lists->outcome[k];
        }
    if (out->contacts)
        for (size_t k = 0; k < shots; k++) {
            out->contacts[start + k] = (int32_t)(int32_t)lists->contacts[k];
        }
    if (out->counts)
        for (size_t k = 0; k < shots; k++) {
            out->counts[3 * (start + k) + 0] = (int32_t)(int32_t)lists->count_0[k];
            out->counts[3 * (start + k) + 1] = (int32_t)(int32_t)lists->count_1[k];
            out->counts[3 * (start + k) + 2] = (int32_t)(int32_t)lists->count_2[k];
        }
    if (out->first)
        for (size_t k = 0; k < shots; k++) {
            out->first[start + k] = (int8_t)(int32_t)lists->first[k];
        }
    if (out->time)
        for (size_t k = 0; k < shots; k++) {
            out->time[start + k] = (double)lists->clock[k];
        }
    if (out->state) {
        /* As many rows as there are lanes fill whole lines: they go past the caches. */
        double rows[COURT_STATE * LANES_WIDTH];
        for (size_t k = 0; k < shots; k += LANES_WIDTH) {
            const double *const columns[] = {
                lists->x + k,
                lists->y + k,
                lists->z + k,
                lists->vx + k,
                lists->vy + k,
                lists->vz + k,
                lists->wx + k,
                lists->wy + k,
                lists->wz + k,
            };
            const size_t some = shots - k < LANES_WIDTH ? shots - k : LANES_WIDTH;
            lanes_rows(rows, columns, COURT_STATE);
            stream(out->state + COURT_STATE * (start + k), rows, COURT_STATE * some);
        }
    }
    if (out->rolls)
        for (size_t k = 0; k < shots; k++) {
            out->rolls[start + k] = (int32_t)(int32_t)lists->rolls[k];
        }
    if (out->slip_left)
        for (size_t k = 0; k < shots; k++) {
            out->slip_left[start + k] = (uint8_t)(int32_t)lists->slip_left[k];
        }
}

/* Write the results of the shot in a row. */
LANES_INLINE void LANES(court_plain_finish)(const LANES(court_plain_lists) *lists, size_t row, const court_job *job)
{
    const court_results *out = job->results;
    const size_t shot = lists->shot[row];
    const int invalid = (int)lists->outcome[row] == COURT_OUTCOME_INVALID;
    if (out->outcome) {
        out->outcome[shot] = (uint8_t)lists->outcome[row];
    }
    if (out->contacts) {
        out->contacts[shot] = (int32_t)lists->contacts[row];
    }
    if (out->counts) {
        out->counts[3 * shot + 0] = (int32_t)lists->count_0[row];
        out->counts[3 * shot + 1] = (int32_t)lists->count_1[row];
        out->counts[3 * shot + 2] = (int32_t)lists->count_2[row];
    }
    if (out->first) {
        out->first[shot] = (int8_t)lists->first[row];
    }
    if (out->time) {
        out->time[shot] = invalid ? NAN : lists->clock[row];
    }
    if (out->state) {
        out->state[9 * shot + 0] = invalid ? NAN : lists->x[row];
        out->state[9 * shot + 1] = invalid ? NAN : lists->y[row];
        out->state[9 * shot + 2] = invalid ? NAN : lists->z[row];
        out->state[9 * shot + 3] = invalid ? NAN : lists->vx[row];
        out->state[9 * shot + 4] = invalid ? NAN : lists->vy[row];
        out->state[9 * shot + 5] = invalid ? NAN : lists->vz[row];
        out->state[9 * shot + 6] = invalid ? NAN : lists->wx[row];
        out->state[9 * shot + 7] = invalid ? NAN : lists->wy[row];
        out->state[9 * shot + 8] = invalid ? NAN : lists->wz[row];
    }
    if (out->rolls) {
        out->rolls[shot] = (int32_t)lists->rolls[row];
    }
    if (out->slip_left) {
        out->slip_left[shot] = (uint8_t)lists->slip_left[row];
    }
}

/* Have the shots of some lanes wait: their rows are free. */
LANES_INLINE void LANES(court_plain_wait)(LANES(court_plain_lists) *lists, size_t row, M who, const court_job *job)
{
    size_t to = lists->waiting;
    for (unsigned bits = lanes_bits(who); bits; bits &= bits - 1)
        lists->waiting_shot[to++] = lists->shot[row + (size_t)LANES_LOWEST(bits)];
    lanes_pack(lists->waiting_x + lists->waiting, who, lanes_load(lists->x + row));
    lanes_pack(lists->waiting_y + lists->waiting, who, lanes_load(lists->y + row));
    lanes_pack(lists->waiting_z + lists->waiting, who, lanes_load(lists->z + row));
    lanes_pack(lists->waiting_vx + lists->waiting, who, lanes_load(lists->vx + row));
    lanes_pack(lists->waiting_vy + lists->waiting, who, lanes_load(lists->vy + row));
    lanes_pack(lists->waiting_vz + lists->waiting, who, lanes_load(lists->vz + row));
    lanes_pack(lists->waiting_wx + lists->waiting, who, lanes_load(lists->wx + row));
    lanes_pack(lists->waiting_wy + lists->waiting, who, lanes_load(lists->wy + row));
    lanes_pack(lists->waiting_wz + lists->waiting, who, lanes_load(lists->wz + row));
    lanes_pack(lists->waiting_clock + lists->waiting, who, lanes_load(lists->clock + row));
    lanes_pack(lists->waiting_last + lists->waiting, who, lanes_load(lists->last + row));
    lanes_pack(lists->waiting_first + lists->waiting, who, lanes_load(lists->first + row));
    lanes_pack(lists->waiting_contacts + lists->waiting, who, lanes_load(lists->contacts + row));
    lanes_pack(lists->waiting_count_0 + lists->waiting, who, lanes_load(lists->count_0 + row));
    lanes_pack(lists->waiting_count_1 + lists->waiting, who, lanes_load(lists->count_1 + row));
    lanes_pack(lists->waiting_count_2 + lists->waiting, who, lanes_load(lists->count_2 + row));
    lanes_pack(lists->waiting_held + lists->waiting, who, lanes_load(lists->held + row));
    lanes_pack(lists->waiting_mode + lists->waiting, who, lanes_load(lists->mode + row));
    lanes_pack(lists->waiting_circled + lists->waiting, who, lanes_load(lists->circled + row));
    lanes_pack(lists->waiting_rolls + lists->waiting, who, lanes_load(lists->rolls + row));
    lanes_pack(lists->waiting_slip_left + lists->waiting, who, lanes_load(lists->slip_left + row));
    lanes_pack(lists->waiting_through + lists->waiting, who, lanes_load(lists->through + row));
    if (job->varying) {
        lanes_pack(lists->waiting_p_ball_radius + lists->waiting, who, lanes_load(lists->p_ball_radius + row));
        lanes_pack(lists->waiting_p_ring_radius + lists->waiting, who, lanes_load(lists->p_ring_radius + row));
        lanes_pack(lists->waiting_p_wire_radius + lists->waiting, who, lanes_load(lists->p_wire_radius + row));
        lanes_pack(lists->waiting_p_board_distance + lists->waiting, who, lanes_load(lists->p_board_distance + row));
        lanes_pack(lists->waiting_p_board_half_width + lists->waiting, who, lanes_load(lists->p_board_half_width + row));
        lanes_pack(lists->waiting_p_board_bottom + lists->waiting, who, lanes_load(lists->p_board_bottom + row));
        lanes_pack(lists->waiting_p_board_top + lists->waiting, who, lanes_load(lists->p_board_top + row));
        lanes_pack(lists->waiting_p_board_thickness + lists->waiting, who, lanes_load(lists->p_board_thickness + row));
        lanes_pack(lists->waiting_p_bridge_half_width + lists->waiting, who, lanes_load(lists->p_bridge_half_width + row));
        lanes_pack(lists->waiting_p_bridge_depth + lists->waiting, who, lanes_load(lists->p_bridge_depth + row));
        lanes_pack(lists->waiting_p_gravity + lists->waiting, who, lanes_load(lists->p_gravity + row));
        lanes_pack(lists->waiting_p_end_depth + lists->waiting, who, lanes_load(lists->p_end_depth + row));
        lanes_pack(lists->waiting_p_ring_restitution + lists->waiting, who, lanes_load(lists->p_ring_restitution + row));
        lanes_pack(lists->waiting_p_backboard_restitution + lists->waiting, who, lanes_load(lists->p_backboard_restitution + row));
        lanes_pack(lists->waiting_p_bridge_restitution + lists->waiting, who, lanes_load(lists->p_bridge_restitution + row));
        lanes_pack(lists->waiting_p_ring_friction + lists->waiting, who, lanes_load(lists->p_ring_friction + row));
        lanes_pack(lists->waiting_p_backboard_friction + lists->waiting, who, lanes_load(lists->p_backboard_friction + row));
        lanes_pack(lists->waiting_p_bridge_friction + lists->waiting, who, lanes_load(lists->p_bridge_friction + row));
        lanes_pack(lists->waiting_p_tangential_restitution + lists->waiting, who, lanes_load(lists->p_tangential_restitution + row));
        lanes_pack(lists->waiting_p_restitution_speed + lists->waiting, who, lanes_load(lists->p_restitution_speed + row));
    }
    lists->waiting = to;
}

/* Put shots that have waited into rows from one on; return how many. */
LANES_INLINE size_t LANES(court_plain_resume)(LANES(court_plain_lists) *lists, size_t row, const court_job *job)
{
    const size_t room = 2 * LANES_SHOTS - row, shots = lists->waiting < room ? lists->waiting : room;
    const size_t from = lists->waiting - shots;
    memcpy(lists->shot + row, lists->waiting_shot + from, shots * sizeof *lists->shot);
    memcpy(lists->x + row, lists->waiting_x + from, shots * sizeof *lists->x);
    memcpy(lists->y + row, lists->waiting_y + from, shots * sizeof *lists->y);
    memcpy(lists->z + row, lists->waiting_z + from, shots * sizeof *lists->z);
    memcpy(lists->vx + row, lists->waiting_vx + from, shots * sizeof *lists->vx);
    memcpy(lists->vy + row, lists->waiting_vy + from, shots * sizeof *lists->vy);
    memcpy(lists->vz + row, lists->waiting_vz + from, shots * sizeof *lists->vz);
    memcpy(lists->wx + row, lists->waiting_wx + from, shots * sizeof *lists->wx);
    memcpy(lists->wy + row, lists->waiting_wy + from, shots * sizeof *lists->wy);
    memcpy(lists->wz + row, lists->waiting_wz + from, shots * sizeof *lists->wz);
    memcpy(lists->clock + row, lists->waiting_clock + from, shots * sizeof *lists->clock);
    memcpy(lists->last + row, lists->waiting_last + from, shots * sizeof *lists->last);
    memcpy(lists->first + row, lists->waiting_first + from, shots * sizeof *lists->first);
    memcpy(lists->contacts + row, lists->waiting_contacts + from, shots * sizeof *lists->contacts);
    memcpy(lists->count_0 + row, lists->waiting_count_0 + from, shots * sizeof *lists->count_0);
    memcpy(lists->count_1 + row, lists->waiting_count_1 + from, shots * sizeof *lists->count_1);
    memcpy(lists->count_2 + row, lists->waiting_count_2 + from, shots * sizeof *lists->count_2);
    memcpy(lists->held + row, lists->waiting_held + from, shots * sizeof *lists->held);
    memcpy(lists->mode + row, lists->waiting_mode + from, shots * sizeof *lists->mode);
    memcpy(lists->circled + row, lists->waiting_circled + from, shots * sizeof *lists->circled);
    memcpy(lists->rolls + row, lists->waiting_rolls + from, shots * sizeof *lists->rolls);
    memcpy(lists->slip_left + row, lists->waiting_slip_left + from, shots * sizeof *lists->slip_left);
    memcpy(lists->through + row, lists->waiting_through + from, shots * sizeof *lists->through);
    if (job->varying) {
        memcpy(lists->p_ball_radius + row, lists->waiting_p_ball_radius + from, shots * sizeof(double));
        memcpy(lists->p_ring_radius + row, lists->waiting_p_ring_radius + from, shots * sizeof(double));
        memcpy(lists->p_wire_radius + row, lists->waiting_p_wire_radius + from, shots * sizeof(double));
        memcpy(lists->p_board_distance + row, lists->waiting_p_board_distance + from, shots * sizeof(double));
        memcpy(lists->p_board_half_width + row, lists->waiting_p_board_half_width + from, shots * sizeof(double));
        memcpy(lists->p_board_bottom + row, lists->waiting_p_board_bottom + from, shots * sizeof(double));
        memcpy(lists->p_board_top + row, lists->waiting_p_board_top + from, shots * sizeof(double));
        memcpy(lists->p_board_thickness + row, lists->waiting_p_board_thickness + from, shots * sizeof(double));
        memcpy(lists->p_bridge_half_width + row, lists->waiting_p_bridge_half_width + from, shots * sizeof(double));
        memcpy(lists->p_bridge_depth + row, lists->waiting_p_bridge_depth + from, shots * sizeof(double));
        memcpy(lists->p_gravity + row, lists->waiting_p_gravity + from, shots * sizeof(double));
        memcpy(lists->p_end_depth + row, lists->waiting_p_end_depth + from, shots * sizeof(double));
        memcpy(lists->p_ring_restitution + row, lists->waiting_p_ring_restitution + from, shots * sizeof(double));
        memcpy(lists->p_backboard_restitution + row, lists->waiting_p_backboard_restitution + from, shots * sizeof(double));
        memcpy(lists->p_bridge_restitution + row, lists->waiting_p_bridge_restitution + from, shots * sizeof(double));
        memcpy(lists->p_ring_friction + row, lists->waiting_p_ring_friction + from, shots * sizeof(double));
        memcpy(lists->p_backboard_friction + row, lists->waiting_p_backboard_friction + from, shots * sizeof(double));
        memcpy(lists->p_bridge_friction + row, lists->waiting_p_bridge_friction + from, shots * sizeof(double));
        memcpy(lists->p_tangential_restitution + row, lists->waiting_p_tangential_restitution + from, shots * sizeof(double));
        memcpy(lists->p_restitution_speed + row, lists->waiting_p_restitution_speed + from, shots * sizeof(double));
    }
    lists->waiting = from;
    return shots;
}

/* Write the results of the shots that have ended, from a row on; the others close up. */
LANES_INLINE size_t LANES(court_plain_leave)(LANES(court_plain_lists) *lists, size_t start, size_t shots, const court_job *job)
{
    size_t kept = start;
    for (size_t i = start; i < shots; i += LANES_WIDTH) {
        const M rows = lanes_first(shots - i);
        M going = lanes_both(rows, lanes_less(lanes_load(lists->outcome + i), K(0.0)));
        for (unsigned bits = lanes_bits(rows) & ~lanes_bits(going); bits; bits &= bits - 1)
            LANES(court_plain_finish)(lists, i + (size_t)LANES_LOWEST(bits), job);
        const M staying = lanes_both(going, lanes_less(K(0.0), lanes_load(lists->mode + i)));
        if (lanes_any(staying) && lists->waiting + LANES_WIDTH <= LANES_SHOTS) {
            LANES(court_plain_wait)(lists, i, staying, job);
            going = lanes_both(going, lanes_not(staying));
        }
        if (kept < i || lanes_bits(going) != lanes_bits(rows)) {
            size_t to = kept;
            for (unsigned bits = lanes_bits(going); bits; bits &= bits - 1)
                lists->shot[to++] = lists->shot[i + (size_t)LANES_LOWEST(bits)];
            lanes_pack(lists->x + kept, going, lanes_load(lists->x + i));
            lanes_pack(lists->y + kept, going, lanes_load(lists->y + i));
            lanes_pack(lists->z + kept, going, lanes_load(lists->z + i));
            lanes_pack(lists->vx + kept, going, lanes_load(lists->vx + i));
            lanes_pack(lists->vy + kept, going, lanes_load(lists->vy + i));
            lanes_pack(lists->vz + kept, going, lanes_load(lists->vz + i));
            lanes_pack(lists->wx + kept, going, lanes_load(lists->wx + i));
            lanes_pack(lists->wy + kept, going, lanes_load(lists->wy + i));
            lanes_pack(lists->wz + kept, going, lanes_load(lists->wz + i));
            lanes_pack(lists->clock + kept, going, lanes_load(lists->clock + i));
            lanes_pack(lists->last + kept, going, lanes_load(lists->last + i));
            lanes_pack(lists->first + kept, going, lanes_load(lists->first + i));
            lanes_pack(lists->contacts + kept, going, lanes_load(lists->contacts + i));
            lanes_pack(lists->count_0 + kept, going, lanes_load(lists->count_0 + i));
            lanes_pack(lists->count_1 + kept, going, lanes_load(lists->count_1 + i));
            lanes_pack(lists->count_2 + kept, going, lanes_load(lists->count_2 + i));
            lanes_pack(lists->held + kept, going, lanes_load(lists->held + i));
            lanes_pack(lists->mode + kept, going, lanes_load(lists->mode + i));
            lanes_pack(lists->circled + kept, going, lanes_load(lists->circled + i));
            lanes_pack(lists->rolls + kept, going, lanes_load(lists->rolls + i));
            lanes_pack(lists->slip_left + kept, going, lanes_load(lists->slip_left + i));
            lanes_pack(lists->through + kept, going, lanes_load(lists->through + i));
            if (job->varying) {
                lanes_pack(lists->p_ball_radius + kept, going, lanes_load(lists->p_ball_radius + i));
                lanes_pack(lists->p_ring_radius + kept, going, lanes_load(lists->p_ring_radius + i));
                lanes_pack(lists->p_wire_radius + kept, going, lanes_load(lists->p_wire_radius + i));
                lanes_pack(lists->p_board_distance + kept, going, lanes_load(lists->p_board_distance + i));
                lanes_pack(lists->p_board_half_width + kept, going, lanes_load(lists->p_board_half_width + i));
                lanes_pack(lists->p_board_bottom + kept, going, lanes_load(lists->p_board_bottom + i));
                lanes_pack(lists->p_board_top + kept, going, lanes_load(lists->p_board_top + i));
                lanes_pack(lists->p_board_thickness + kept, going, lanes_load(lists->p_board_thickness + i));
                lanes_pack(lists->p_bridge_half_width + kept, going, lanes_load(lists->p_bridge_half_width + i));
                lanes_pack(lists->p_bridge_depth + kept, going, lanes_load(lists->p_bridge_depth + i));
                lanes_pack(lists->p_gravity + kept, going, lanes_load(lists->p_gravity + i));
                lanes_pack(lists->p_end_depth + kept, going, lanes_load(lists->p_end_depth + i));
                lanes_pack(lists->p_ring_restitution + kept, going, lanes_load(lists->p_ring_restitution + i));
                lanes_pack(lists->p_backboard_restitution + kept, going, lanes_load(lists->p_backboard_restitution + i));
                lanes_pack(lists->p_bridge_restitution + kept, going, lanes_load(lists->p_bridge_restitution + i));
                lanes_pack(lists->p_ring_friction + kept, going, lanes_load(lists->p_ring_friction + i));
                lanes_pack(lists->p_backboard_friction + kept, going, lanes_load(lists->p_backboard_friction + i));
                lanes_pack(lists->p_bridge_friction + kept, going, lanes_load(lists->p_bridge_friction + i));
                lanes_pack(lists->p_tangential_restitution + kept, going, lanes_load(lists->p_tangential_restitution + i));
                lanes_pack(lists->p_restitution_speed + kept, going, lanes_load(lists->p_restitution_speed + i));
            }
        }
        kept += lanes_many(going);
    }
    return kept;
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_leaves)(LANES(court_plain_lists) *lists, size_t kept_leaves_shots, size_t varying)
{
    for (size_t i = 0; i < kept_leaves_shots; i += LANES_WIDTH) {
        const M rows = lanes_first(kept_leaves_shots - i);
        V held = lanes_load(lists->kept_leaves_held + i);
        V lift = lanes_load(lists->kept_leaves_lift + i);
        const V p_ball_radius = lanes_load(varying ? lists->kept_leaves_p_ball_radius + i : lists->p_ball_radius);
        const V p_board_bottom = lanes_load(varying ? lists->kept_leaves_p_board_bottom + i : lists->p_board_bottom);
        const V p_board_distance = lanes_load(varying ? lists->kept_leaves_p_board_distance + i : lists->p_board_distance);
        const V p_board_half_width = lanes_load(varying ? lists->kept_leaves_p_board_half_width + i : lists->p_board_half_width);
        const V p_board_thickness = lanes_load(varying ? lists->kept_leaves_p_board_thickness + i : lists->p_board_thickness);
        const V p_board_top = lanes_load(varying ? lists->kept_leaves_p_board_top + i : lists->p_board_top);
        const V p_bridge_depth = lanes_load(varying ? lists->kept_leaves_p_bridge_depth + i : lists->p_bridge_depth);
        const V p_bridge_half_width = lanes_load(varying ? lists->kept_leaves_p_bridge_half_width + i : lists->p_bridge_half_width);
        const V p_end_depth = lanes_load(varying ? lists->kept_leaves_p_end_depth + i : lists->p_end_depth);
        const V p_gravity = lanes_load(varying ? lists->kept_leaves_p_gravity + i : lists->p_gravity);
        const V p_ring_radius = lanes_load(varying ? lists->kept_leaves_p_ring_radius + i : lists->p_ring_radius);
        const V p_wire_radius = lanes_load(varying ? lists->kept_leaves_p_wire_radius + i : lists->p_wire_radius);
        V per_reach = lanes_load(lists->kept_leaves_per_reach + i);
        V snap = lanes_load(lists->kept_leaves_snap + i);
        V surge = lanes_load(lists->kept_leaves_surge + i);
        V vx = lanes_load(lists->kept_leaves_vx + i);
        V vy = lanes_load(lists->kept_leaves_vy + i);
        V vz = lanes_load(lists->kept_leaves_vz + i);
        V x = lanes_load(lists->kept_leaves_x + i);
        V y = lanes_load(lists->kept_leaves_y + i);
        V z = lanes_load(lists->kept_leaves_z + i);
        const LANES(court_holding_out) _o290 =
            LANES(court_holding)(held, K(0.0));
        M here = _o290.here;
        const M _m291 = lanes_both(rows, here);
        if (lanes_any(_m291)) {
            const LANES(court_ring_tube_out) _o292 =
                LANES(court_ring_tube)(p_ball_radius, p_wire_radius);
            per_reach = lanes_select(_m291, _o292.per_reach, per_reach);
            const LANES(court_ring_parting_out) _o293 =
                LANES(court_ring_parting)(p_gravity, p_ring_radius, vx, vy, vz, x, y, z);
            lift = lanes_select(_m291, _o293.lift, lift);
            surge = lanes_select(_m291, _o293.surge, surge);
            snap = lanes_select(_m291, _o293.snap, snap);
        }
        const LANES(court_holding_out) _o294 =
            LANES(court_holding)(held, K(1.0));
        here = _o294.here;
        const M _m295 = lanes_both(rows, here);
        if (lanes_any(_m295)) {
            const LANES(court_backboard_tube_out) _o296 =
                LANES(court_backboard_tube)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            per_reach = lanes_select(_m295, _o296.per_reach, per_reach);
            const LANES(court_backboard_parting_out) _o297 =
                LANES(court_backboard_parting)(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, vx, vy, vz, x, y, z);
            lift = lanes_select(_m295, _o297.lift, lift);
            surge = lanes_select(_m295, _o297.surge, surge);
            snap = lanes_select(_m295, _o297.snap, snap);
        }
        const LANES(court_holding_out) _o298 =
            LANES(court_holding)(held, K(2.0));
        here = _o298.here;
        const M _m299 = lanes_both(rows, here);
        if (lanes_any(_m299)) {
            const LANES(court_bridge_tube_out) _o300 =
                LANES(court_bridge_tube)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            per_reach = lanes_select(_m299, _o300.per_reach, per_reach);
            const LANES(court_bridge_parting_out) _o301 =
                LANES(court_bridge_parting)(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            lift = lanes_select(_m299, _o301.lift, lift);
            surge = lanes_select(_m299, _o301.surge, surge);
            snap = lanes_select(_m299, _o301.snap, snap);
        }
        const LANES(court_unmet_out) _o302 =
            LANES(court_unmet)();
        V spare = _o302.spare;
        const LANES(court_beside_out) _o303 =
            LANES(court_beside)(held, K(0.0));
        M beside = _o303.beside;
        const M _m304 = lanes_both(rows, beside);
        if (lanes_any(_m304)) {
            const LANES(court_ring_beside_out) _o305 =
                LANES(court_ring_beside)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            V gap = _o305.gap;
            V nearing = _o305.nearing;
            V dent = _o305.dent;
            const LANES(court_spared_out) _o306 =
                LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
            spare = lanes_select(_m304, _o306.spare, spare);
        }
        const LANES(court_beside_out) _o307 =
            LANES(court_beside)(held, K(1.0));
        beside = _o307.beside;
        const M _m308 = lanes_both(rows, beside);
        if (lanes_any(_m308)) {
            const LANES(court_backboard_beside_out) _o309 =
                LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            V gap = _o309.gap;
            V nearing = _o309.nearing;
            V dent = _o309.dent;
            const LANES(court_spared_out) _o310 =
                LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
            spare = lanes_select(_m308, _o310.spare, spare);
        }
        const LANES(court_beside_out) _o311 =
            LANES(court_beside)(held, K(2.0));
        beside = _o311.beside;
        const M _m312 = lanes_both(rows, beside);
        if (lanes_any(_m312)) {
            const LANES(court_bridge_beside_out) _o313 =
                LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            V gap = _o313.gap;
            V nearing = _o313.nearing;
            V dent = _o313.dent;
            const LANES(court_spared_out) _o314 =
                LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
            spare = lanes_select(_m312, _o314.spare, spare);
        }
        const LANES(court_beside_out) _o315 =
            LANES(court_beside)(held, K(3.0));
        beside = _o315.beside;
        const M _m316 = lanes_both(rows, beside);
        if (lanes_any(_m316)) {
            const LANES(court_end_beside_out) _o317 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            V gap = _o317.gap;
            V nearing = _o317.nearing;
            V dent = _o317.dent;
            const LANES(court_spared_out) _o318 =
                LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
            spare = lanes_select(_m316, _o318.spare, spare);
        }
        const LANES(court_holding_out) _o319 =
            LANES(court_holding)(held, K(1.0));
        here = _o319.here;
        const M _m320 = lanes_both(rows, here);
        if (lanes_any(_m320)) {
            const LANES(court_backboard_seam0_out) _o321 =
                LANES(court_backboard_seam0)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
            V gap = _o321.gap;
            V nearing = _o321.nearing;
            V near = _o321.near;
            const LANES(court_spared_seam_out) _o322 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m320, _o322.spare, spare);
            const LANES(court_backboard_seam1_out) _o323 =
                LANES(court_backboard_seam1)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
            gap = _o323.gap;
            nearing = _o323.nearing;
            near = _o323.near;
            const LANES(court_spared_seam_out) _o324 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m320, _o324.spare, spare);
            const LANES(court_backboard_seam2_out) _o325 =
                LANES(court_backboard_seam2)(p_ball_radius, p_board_half_width, vy, y);
            gap = _o325.gap;
            nearing = _o325.nearing;
            near = _o325.near;
            const LANES(court_spared_seam_out) _o326 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m320, _o326.spare, spare);
            const LANES(court_backboard_seam3_out) _o327 =
                LANES(court_backboard_seam3)(p_ball_radius, p_board_half_width, vy, y);
            gap = _o327.gap;
            nearing = _o327.nearing;
            near = _o327.near;
            const LANES(court_spared_seam_out) _o328 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m320, _o328.spare, spare);
            const LANES(court_backboard_seam4_out) _o329 =
                LANES(court_backboard_seam4)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
            gap = _o329.gap;
            nearing = _o329.nearing;
            near = _o329.near;
            const LANES(court_spared_seam_out) _o330 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m320, _o330.spare, spare);
            const LANES(court_backboard_seam5_out) _o331 =
                LANES(court_backboard_seam5)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
            gap = _o331.gap;
            nearing = _o331.nearing;
            near = _o331.near;
            const LANES(court_spared_seam_out) _o332 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m320, _o332.spare, spare);
        }
        const LANES(court_holding_out) _o333 =
            LANES(court_holding)(held, K(2.0));
        here = _o333.here;
        const M _m334 = lanes_both(rows, here);
        if (lanes_any(_m334)) {
            const LANES(court_bridge_seam0_out) _o335 =
                LANES(court_bridge_seam0)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
            V gap = _o335.gap;
            V nearing = _o335.nearing;
            V near = _o335.near;
            const LANES(court_spared_seam_out) _o336 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m334, _o336.spare, spare);
            const LANES(court_bridge_seam1_out) _o337 =
                LANES(court_bridge_seam1)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
            gap = _o337.gap;
            nearing = _o337.nearing;
            near = _o337.near;
            const LANES(court_spared_seam_out) _o338 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m334, _o338.spare, spare);
            const LANES(court_bridge_seam2_out) _o339 =
                LANES(court_bridge_seam2)(p_ball_radius, p_bridge_half_width, vy, y);
            gap = _o339.gap;
            nearing = _o339.nearing;
            near = _o339.near;
            const LANES(court_spared_seam_out) _o340 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m334, _o340.spare, spare);
            const LANES(court_bridge_seam3_out) _o341 =
                LANES(court_bridge_seam3)(p_ball_radius, p_bridge_half_width, vy, y);
            gap = _o341.gap;
            nearing = _o341.nearing;
            near = _o341.near;
            const LANES(court_spared_seam_out) _o342 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m334, _o342.spare, spare);
            const LANES(court_bridge_seam4_out) _o343 =
                LANES(court_bridge_seam4)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
            gap = _o343.gap;
            nearing = _o343.nearing;
            near = _o343.near;
            const LANES(court_spared_seam_out) _o344 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m334, _o344.spare, spare);
            const LANES(court_bridge_seam5_out) _o345 =
                LANES(court_bridge_seam5)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
            gap = _o345.gap;
            nearing = _o345.nearing;
            near = _o345.near;
            const LANES(court_spared_seam_out) _o346 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m334, _o346.spare, spare);
        }
        const LANES(court_parted_out) _o347 =
            LANES(court_parted)(K(INFINITY), p_gravity, lift, per_reach, K(0.0), snap, spare, surge, K(0.0), vx, vy, vz);
        V when = _o347.when;
        const LANES(court_hopping_out) _o348 =
            LANES(court_hopping)();
        V which = _o348.which;
        lanes_store(lists->kept_leaves_when + i, when);
        lanes_store(lists->kept_leaves_which + i, which);
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_kept)(LANES(court_plain_lists) *lists, size_t kept_shots, size_t varying, V time_limit)
{
    {
    size_t kept_rolling_shots = 0;
    for (size_t i = 0; i < kept_shots; i += LANES_WIDTH) {
        const M rows = lanes_first(kept_shots - i);
        V circled = lanes_load(lists->kept_circled + i);
        V clock = lanes_load(lists->kept_clock + i);
        V held = lanes_load(lists->kept_held + i);
        V mode = lanes_load(lists->kept_mode + i);
        const V p_ball_radius = lanes_load(varying ? lists->kept_p_ball_radius + i : lists->p_ball_radius);
        const V p_board_bottom = lanes_load(varying ? lists->kept_p_board_bottom + i : lists->p_board_bottom);
        const V p_board_distance = lanes_load(varying ? lists->kept_p_board_distance + i : lists->p_board_distance);
        const V p_board_half_width = lanes_load(varying ? lists->kept_p_board_half_width + i : lists->p_board_half_width);
        const V p_board_thickness = lanes_load(varying ? lists->kept_p_board_thickness + i : lists->p_board_thickness);
        const V p_board_top = lanes_load(varying ? lists->kept_p_board_top + i : lists->p_board_top);
        const V p_bridge_depth = lanes_load(varying ? lists->kept_p_bridge_depth + i : lists->p_bridge_depth);
        const V p_bridge_half_width = lanes_load(varying ? lists->kept_p_bridge_half_width + i : lists->p_bridge_half_width);
        const V p_end_depth = lanes_load(varying ? lists->kept_p_end_depth + i : lists->p_end_depth);
        const V p_gravity = lanes_load(varying ? lists->kept_p_gravity + i : lists->p_gravity);
        const V p_ring_radius = lanes_load(varying ? lists->kept_p_ring_radius + i : lists->p_ring_radius);
        const V p_wire_radius = lanes_load(varying ? lists->kept_p_wire_radius + i : lists->p_wire_radius);
        V through = lanes_load(lists->kept_through + i);
        V vx = lanes_load(lists->kept_vx + i);
        V vy = lanes_load(lists->kept_vy + i);
        V vz = lanes_load(lists->kept_vz + i);
        V wx = lanes_load(lists->kept_wx + i);
        V wy = lanes_load(lists->kept_wy + i);
        V wz = lanes_load(lists->kept_wz + i);
        V x = lanes_load(lists->kept_x + i);
        V y = lanes_load(lists->kept_y + i);
        V z = lanes_load(lists->kept_z + i);
        const LANES(court_resumed_out) _o146 =
            LANES(court_resumed)(clock, mode, K(0.0), K(0.0));
        V which = _o146.which;
        V began = _o146.began;
        M begins = _o146.begins;
        M rolling = _o146.rolling;
        M leaves = _o146.leaves;
        V nx = _o146.nx;
        V ny = _o146.ny;
        V nz = _o146.nz;
        V gap = _o146.gap;
        V bent_x = _o146.bent_x;
        V bent_y = _o146.bent_y;
        V bent_z = _o146.bent_z;
        V lift = _o146.lift;
        V surge = _o146.surge;
        V snap = _o146.snap;
        V per_reach = _o146.per_reach;
        const M _m147 = lanes_both(rows, begins);
        if (lanes_any(_m147)) {
            const LANES(court_holding_out) _o148 =
                LANES(court_holding)(held, K(0.0));
            M here = _o148.here;
            const M _m149 = lanes_both(_m147, here);
            {
                const LANES(court_ring_normal_out) _o150 =
                    LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                nx = lanes_select(_m149, _o150.nx, nx);
                ny = lanes_select(_m149, _o150.ny, ny);
                nz = lanes_select(_m149, _o150.nz, nz);
            }
            const LANES(court_holding_out) _o151 =
                LANES(court_holding)(held, K(1.0));
            here = _o151.here;
            const M _m152 = lanes_both(_m147, here);
            {
                const LANES(court_backboard_normal_out) _o153 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m152, _o153.nx, nx);
                ny = lanes_select(_m152, _o153.ny, ny);
                nz = lanes_select(_m152, _o153.nz, nz);
            }
            const LANES(court_holding_out) _o154 =
                LANES(court_holding)(held, K(2.0));
            here = _o154.here;
            const M _m155 = lanes_both(_m147, here);
            {
                const LANES(court_bridge_normal_out) _o156 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m155, _o156.nx, nx);
                ny = lanes_select(_m155, _o156.ny, ny);
                nz = lanes_select(_m155, _o156.nz, nz);
            }
            const LANES(court_roll_turn_rate_out) _o157 =
                LANES(court_roll_turn_rate)(p_ball_radius, nx, ny, nz, wx, wy, wz);
            V turn_rate = _o157.turn_rate;
            const LANES(court_gripped_out) _o158 =
                LANES(court_gripped)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
            V rolled_x = _o158.rolled_x;
            V rolled_y = _o158.rolled_y;
            V rolled_z = _o158.rolled_z;
            const LANES(court_holding_out) _o159 =
                LANES(court_holding)(held, K(0.0));
            here = _o159.here;
            const M _m160 = lanes_both(_m147, here);
            {
                const LANES(court_ring_off_out) _o161 =
                    LANES(court_ring_off)(p_ball_radius, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m160, _o161.gap, gap);
            }
            const LANES(court_holding_out) _o162 =
                LANES(court_holding)(held, K(1.0));
            here = _o162.here;
            const M _m163 = lanes_both(_m147, here);
            {
                const LANES(court_backboard_off_out) _o164 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z);
                gap = lanes_select(_m163, _o164.gap, gap);
            }
            const LANES(court_holding_out) _o165 =
                LANES(court_holding)(held, K(2.0));
            here = _o165.here;
            const M _m166 = lanes_both(_m147, here);
            {
                const LANES(court_bridge_off_out) _o167 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m166, _o167.gap, gap);
            }
            const LANES(court_roll_placed_out) _o168 =
                LANES(court_roll_placed)(p_ball_radius, gap, nx, ny, nz, turn_rate, rolled_x, rolled_y, rolled_z, x, y, z);
            x = lanes_select(_m147, _o168.x, x);
            y = lanes_select(_m147, _o168.y, y);
            z = lanes_select(_m147, _o168.z, z);
            vx = lanes_select(_m147, _o168.vx, vx);
            vy = lanes_select(_m147, _o168.vy, vy);
            vz = lanes_select(_m147, _o168.vz, vz);
            wx = lanes_select(_m147, _o168.wx, wx);
            wy = lanes_select(_m147, _o168.wy, wy);
            wz = lanes_select(_m147, _o168.wz, wz);
            const LANES(court_beginning_contact_out) _o169 =
                LANES(court_beginning_contact)();
            which = lanes_select(_m147, _o169.which, which);
            circled = lanes_select(_m147, _o169.circled, circled);
        }
        const LANES(court_circles_out) _o170 =
            LANES(court_circles)(held, K(0.0), rolling);
        M circling = _o170.circling;
        rolling = _o170.rolling;
        lanes_store(lists->kept_began + i, began);
        lanes_store(lists->kept_circled + i, circled);
        lanes_store(lists->kept_circling + i, lanes_select(circling, K(1.0), K(0.0)));
        lanes_store(lists->kept_leaves + i, lanes_select(leaves, K(1.0), K(0.0)));
        lanes_store(lists->kept_lift + i, lift);
        lanes_store(lists->kept_per_reach + i, per_reach);
        lanes_store(lists->kept_rolling + i, lanes_select(rolling, K(1.0), K(0.0)));
        lanes_store(lists->kept_snap + i, snap);
        lanes_store(lists->kept_surge + i, surge);
        lanes_store(lists->kept_vx + i, vx);
        lanes_store(lists->kept_vy + i, vy);
        lanes_store(lists->kept_vz + i, vz);
        lanes_store(lists->kept_which + i, which);
        lanes_store(lists->kept_wx + i, wx);
        lanes_store(lists->kept_wy + i, wy);
        lanes_store(lists->kept_wz + i, wz);
        lanes_store(lists->kept_x + i, x);
        lanes_store(lists->kept_y + i, y);
        lanes_store(lists->kept_z + i, z);
        const M packed = lanes_both(rows, rolling);
        if (lanes_any(packed)) {
            lanes_pack(lists->kept_rolling_row + kept_rolling_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
            lanes_pack(lists->kept_rolling_bent_x + kept_rolling_shots, packed, bent_x);
            lanes_pack(lists->kept_rolling_bent_y + kept_rolling_shots, packed, bent_y);
            lanes_pack(lists->kept_rolling_bent_z + kept_rolling_shots, packed, bent_z);
            lanes_pack(lists->kept_rolling_clock + kept_rolling_shots, packed, clock);
            lanes_pack(lists->kept_rolling_held + kept_rolling_shots, packed, held);
            lanes_pack(lists->kept_rolling_nx + kept_rolling_shots, packed, nx);
            lanes_pack(lists->kept_rolling_ny + kept_rolling_shots, packed, ny);
            lanes_pack(lists->kept_rolling_nz + kept_rolling_shots, packed, nz);
            if (varying)
                lanes_pack(lists->kept_rolling_p_ball_radius + kept_rolling_shots, packed, p_ball_radius);
            if (varying)
                lanes_pack(lists->kept_rolling_p_board_bottom + kept_rolling_shots, packed, p_board_bottom);
            if (varying)
                lanes_pack(lists->kept_rolling_p_board_distance + kept_rolling_shots, packed, p_board_distance);
            if (varying)
                lanes_pack(lists->kept_rolling_p_board_half_width + kept_rolling_shots, packed, p_board_half_width);
            if (varying)
                lanes_pack(lists->kept_rolling_p_board_thickness + kept_rolling_shots, packed, p_board_thickness);
            if (varying)
                lanes_pack(lists->kept_rolling_p_board_top + kept_rolling_shots, packed, p_board_top);
            if (varying)
                lanes_pack(lists->kept_rolling_p_bridge_depth + kept_rolling_shots, packed, p_bridge_depth);
            if (varying)
                lanes_pack(lists->kept_rolling_p_bridge_half_width + kept_rolling_shots, packed, p_bridge_half_width);
            if (varying)
                lanes_pack(lists->kept_rolling_p_end_depth + kept_rolling_shots, packed, p_end_depth);
            if (varying)
                lanes_pack(lists->kept_rolling_p_gravity + kept_rolling_shots, packed, p_gravity);
            if (varying)
                lanes_pack(lists->kept_rolling_p_ring_radius + kept_rolling_shots, packed, p_ring_radius);
            if (varying)
                lanes_pack(lists->kept_rolling_p_wire_radius + kept_rolling_shots, packed, p_wire_radius);
            lanes_pack(lists->kept_rolling_per_reach + kept_rolling_shots, packed, per_reach);
            lanes_pack(lists->kept_rolling_through + kept_rolling_shots, packed, through);
            lanes_pack(lists->kept_rolling_vx + kept_rolling_shots, packed, vx);
            lanes_pack(lists->kept_rolling_vy + kept_rolling_shots, packed, vy);
            lanes_pack(lists->kept_rolling_vz + kept_rolling_shots, packed, vz);
            lanes_pack(lists->kept_rolling_which + kept_rolling_shots, packed, which);
            lanes_pack(lists->kept_rolling_wx + kept_rolling_shots, packed, wx);
            lanes_pack(lists->kept_rolling_wy + kept_rolling_shots, packed, wy);
            lanes_pack(lists->kept_rolling_wz + kept_rolling_shots, packed, wz);
            lanes_pack(lists->kept_rolling_x + kept_rolling_shots, packed, x);
            lanes_pack(lists->kept_rolling_y + kept_rolling_shots, packed, y);
            lanes_pack(lists->kept_rolling_z + kept_rolling_shots, packed, z);
            kept_rolling_shots += lanes_many(packed);
        }
    }
    {
        size_t taken = 0, busy = 0;
        M active = lanes_nowhere();
        V row = K(0.0), turns = K(0.0);
        V p_ball_radius = lanes_load(lists->p_ball_radius);
        V p_board_bottom = lanes_load(lists->p_board_bottom);
        V p_board_distance = lanes_load(lists->p_board_distance);
        V p_board_half_width = lanes_load(lists->p_board_half_width);
        V p_board_thickness = lanes_load(lists->p_board_thickness);
        V p_board_top = lanes_load(lists->p_board_top);
        V p_bridge_depth = lanes_load(lists->p_bridge_depth);
        V p_bridge_half_width = lanes_load(lists->p_bridge_half_width);
        V p_end_depth = lanes_load(lists->p_end_depth);
        V p_gravity = lanes_load(lists->p_gravity);
        V p_ring_radius = lanes_load(lists->p_ring_radius);
        V p_wire_radius = lanes_load(lists->p_wire_radius);
        V bent_x = K(0.0);
        V bent_y = K(0.0);
        V bent_z = K(0.0);
        V clock = K(0.0);
        V held = K(0.0);
        V nx = K(0.0);
        V ny = K(0.0);
        V nz = K(0.0);
        V per_reach = K(0.0);
        V through = K(0.0);
        V vx = K(0.0);
        V vy = K(0.0);
        V vz = K(0.0);
        V which = K(0.0);
        V wx = K(0.0);
        V wy = K(0.0);
        V wz = K(0.0);
        V x = K(0.0);
        V y = K(0.0);
        V z = K(0.0);
        for (;;) {
            if (taken < kept_rolling_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                const M idle = lanes_not(active);
                row = lanes_expand(lists->kept_rolling_row + taken, idle, row);
                turns = lanes_select(idle, K(0.0), turns);
                bent_x = lanes_expand(lists->kept_rolling_bent_x + taken, idle, bent_x);
                bent_y = lanes_expand(lists->kept_rolling_bent_y + taken, idle, bent_y);
                bent_z = lanes_expand(lists->kept_rolling_bent_z + taken, idle, bent_z);
                clock = lanes_expand(lists->kept_rolling_clock + taken, idle, clock);
                held = lanes_expand(lists->kept_rolling_held + taken, idle, held);
                nx = lanes_expand(lists->kept_rolling_nx + taken, idle, nx);
                ny = lanes_expand(lists->kept_rolling_ny + taken, idle, ny);
                nz = lanes_expand(lists->kept_rolling_nz + taken, idle, nz);
                per_reach = lanes_expand(lists->kept_rolling_per_reach + taken, idle, per_reach);
                through = lanes_expand(lists->kept_rolling_through + taken, idle, through);
                vx = lanes_expand(lists->kept_rolling_vx + taken, idle, vx);
                vy = lanes_expand(lists->kept_rolling_vy + taken, idle, vy);
                vz = lanes_expand(lists->kept_rolling_vz + taken, idle, vz);
                which = lanes_expand(lists->kept_rolling_which + taken, idle, which);
                wx = lanes_expand(lists->kept_rolling_wx + taken, idle, wx);
                wy = lanes_expand(lists->kept_rolling_wy + taken, idle, wy);
                wz = lanes_expand(lists->kept_rolling_wz + taken, idle, wz);
                x = lanes_expand(lists->kept_rolling_x + taken, idle, x);
                y = lanes_expand(lists->kept_rolling_y + taken, idle, y);
                z = lanes_expand(lists->kept_rolling_z + taken, idle, z);
                if (varying) {
                    p_ball_radius = lanes_expand(lists->kept_rolling_p_ball_radius + taken, idle, p_ball_radius);
                    p_board_bottom = lanes_expand(lists->kept_rolling_p_board_bottom + taken, idle, p_board_bottom);
                    p_board_distance = lanes_expand(lists->kept_rolling_p_board_distance + taken, idle, p_board_distance);
                    p_board_half_width = lanes_expand(lists->kept_rolling_p_board_half_width + taken, idle, p_board_half_width);
                    p_board_thickness = lanes_expand(lists->kept_rolling_p_board_thickness + taken, idle, p_board_thickness);
                    p_board_top = lanes_expand(lists->kept_rolling_p_board_top + taken, idle, p_board_top);
                    p_bridge_depth = lanes_expand(lists->kept_rolling_p_bridge_depth + taken, idle, p_bridge_depth);
                    p_bridge_half_width = lanes_expand(lists->kept_rolling_p_bridge_half_width + taken, idle, p_bridge_half_width);
                    p_end_depth = lanes_expand(lists->kept_rolling_p_end_depth + taken, idle, p_end_depth);
                    p_gravity = lanes_expand(lists->kept_rolling_p_gravity + taken, idle, p_gravity);
                    p_ring_radius = lanes_expand(lists->kept_rolling_p_ring_radius + taken, idle, p_ring_radius);
                    p_wire_radius = lanes_expand(lists->kept_rolling_p_wire_radius + taken, idle, p_wire_radius);
                }
                const size_t room = LANES_WIDTH - busy, left = kept_rolling_shots - taken;
                active = lanes_leading(idle, left, active);
                taken += left < room ? left : room;
                busy += left < room ? left : room;
            }
            if (busy == 0)
                break;
            M rolling = active;
            const LANES(court_holding_out) _o171 =
                LANES(court_holding)(held, K(1.0));
            M here = _o171.here;
            const M _m172 = lanes_both(active, here);
            if (lanes_any(_m172)) {
                const LANES(court_backboard_normal_out) _o173 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m172, _o173.nx, nx);
                ny = lanes_select(_m172, _o173.ny, ny);
                nz = lanes_select(_m172, _o173.nz, nz);
                const LANES(court_backboard_tube_out) _o174 =
                    LANES(court_backboard_tube)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                bent_x = lanes_select(_m172, _o174.bent_x, bent_x);
                bent_y = lanes_select(_m172, _o174.bent_y, bent_y);
                bent_z = lanes_select(_m172, _o174.bent_z, bent_z);
                per_reach = lanes_select(_m172, _o174.per_reach, per_reach);
            }
            const LANES(court_holding_out) _o175 =
                LANES(court_holding)(held, K(2.0));
            here = _o175.here;
            const M _m176 = lanes_both(active, here);
            if (lanes_any(_m176)) {
                const LANES(court_bridge_normal_out) _o177 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m176, _o177.nx, nx);
                ny = lanes_select(_m176, _o177.ny, ny);
                nz = lanes_select(_m176, _o177.nz, nz);
                const LANES(court_bridge_tube_out) _o178 =
                    LANES(court_bridge_tube)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                bent_x = lanes_select(_m176, _o178.bent_x, bent_x);
                bent_y = lanes_select(_m176, _o178.bent_y, bent_y);
                bent_z = lanes_select(_m176, _o178.bent_z, bent_z);
                per_reach = lanes_select(_m176, _o178.per_reach, per_reach);
            }
            const LANES(court_roll_start_out) _o179 =
                LANES(court_roll_start)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
            V vx_0 = _o179.vx_0;
            V vy_0 = _o179.vy_0;
            V vz_0 = _o179.vz_0;
            V nx_0 = _o179.nx_0;
            V ny_0 = _o179.ny_0;
            V nz_0 = _o179.nz_0;
            V turn_rate_0 = _o179.turn_rate_0;
            const LANES(court_roll_0_out) _o180 =
                LANES(court_roll_0)(bent_x, bent_y, bent_z, p_gravity, nx_0, ny_0, nz_0, per_reach, turn_rate_0, vx_0, vy_0, vz_0);
            V lift_0 = _o180.lift_0;
            V tx_0 = _o180.tx_0;
            V ty_0 = _o180.ty_0;
            V tz_0 = _o180.tz_0;
            V vx_1 = _o180.vx_1;
            V vy_1 = _o180.vy_1;
            V vz_1 = _o180.vz_1;
            V nx_1 = _o180.nx_1;
            V ny_1 = _o180.ny_1;
            V nz_1 = _o180.nz_1;
            V turn_rate_1 = _o180.turn_rate_1;
            const LANES(court_roll_1_out) _o181 =
                LANES(court_roll_1)(bent_x, bent_y, bent_z, p_gravity, lift_0, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1);
            V lift_1 = _o181.lift_1;
            V tx_1 = _o181.tx_1;
            V ty_1 = _o181.ty_1;
            V tz_1 = _o181.tz_1;
            V vx_2 = _o181.vx_2;
            V vy_2 = _o181.vy_2;
            V vz_2 = _o181.vz_2;
            V nx_2 = _o181.nx_2;
            V ny_2 = _o181.ny_2;
            V nz_2 = _o181.nz_2;
            V turn_rate_2 = _o181.turn_rate_2;
            const LANES(court_roll_2_out) _o182 =
                LANES(court_roll_2)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2);
            V lift_2 = _o182.lift_2;
            V tx_2 = _o182.tx_2;
            V ty_2 = _o182.ty_2;
            V tz_2 = _o182.tz_2;
            V vx_3 = _o182.vx_3;
            V vy_3 = _o182.vy_3;
            V vz_3 = _o182.vz_3;
            V nx_3 = _o182.nx_3;
            V ny_3 = _o182.ny_3;
            V nz_3 = _o182.nz_3;
            V turn_rate_3 = _o182.turn_rate_3;
            const LANES(court_roll_3_out) _o183 =
                LANES(court_roll_3)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3);
            V lift_3 = _o183.lift_3;
            V tx_3 = _o183.tx_3;
            V ty_3 = _o183.ty_3;
            V tz_3 = _o183.tz_3;
            V vx_4 = _o183.vx_4;
            V vy_4 = _o183.vy_4;
            V vz_4 = _o183.vz_4;
            V nx_4 = _o183.nx_4;
            V ny_4 = _o183.ny_4;
            V nz_4 = _o183.nz_4;
            V turn_rate_4 = _o183.turn_rate_4;
            const LANES(court_roll_4_out) _o184 =
                LANES(court_roll_4)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4);
            V lift_4 = _o184.lift_4;
            V tx_4 = _o184.tx_4;
            V ty_4 = _o184.ty_4;
            V tz_4 = _o184.tz_4;
            V vx_5 = _o184.vx_5;
            V vy_5 = _o184.vy_5;
            V vz_5 = _o184.vz_5;
            V nx_5 = _o184.nx_5;
            V ny_5 = _o184.ny_5;
            V nz_5 = _o184.nz_5;
            V turn_rate_5 = _o184.turn_rate_5;
            const LANES(court_roll_5_out) _o185 =
                LANES(court_roll_5)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5);
            V lift_5 = _o185.lift_5;
            V tx_5 = _o185.tx_5;
            V ty_5 = _o185.ty_5;
            V tz_5 = _o185.tz_5;
            V vx_6 = _o185.vx_6;
            V vy_6 = _o185.vy_6;
            V vz_6 = _o185.vz_6;
            V nx_6 = _o185.nx_6;
            V ny_6 = _o185.ny_6;
            V nz_6 = _o185.nz_6;
            V turn_rate_6 = _o185.turn_rate_6;
            const LANES(court_roll_6_out) _o186 =
                LANES(court_roll_6)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6);
            V lift_6 = _o186.lift_6;
            V tx_6 = _o186.tx_6;
            V ty_6 = _o186.ty_6;
            V tz_6 = _o186.tz_6;
            V vx_7 = _o186.vx_7;
            V vy_7 = _o186.vy_7;
            V vz_7 = _o186.vz_7;
            V nx_7 = _o186.nx_7;
            V ny_7 = _o186.ny_7;
            V nz_7 = _o186.nz_7;
            V turn_rate_7 = _o186.turn_rate_7;
            const LANES(court_roll_7_out) _o187 =
                LANES(court_roll_7)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7);
            V lift_7 = _o187.lift_7;
            V vx_8 = _o187.vx_8;
            V vy_8 = _o187.vy_8;
            V vz_8 = _o187.vz_8;
            V nx_8 = _o187.nx_8;
            V ny_8 = _o187.ny_8;
            V nz_8 = _o187.nz_8;
            V turn_rate_8 = _o187.turn_rate_8;
            const LANES(court_roll_pace_out) _o188 =
                LANES(court_roll_pace)(p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, lift_7, nx_8, ny_8, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, nz_8, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8);
            V stride = _o188.stride;
            V strongest = _o188.strongest;
            V fastest = _o188.fastest;
            V force = _o188.force;
            V force_rate = _o188.force_rate;
            V force_bend = _o188.force_bend;
            V brace = _o188.brace;
            const LANES(court_leaving_force_out) _o189 =
                LANES(court_leaving_force)(p_ball_radius, brace, K(INFINITY), fastest, force, force_bend, force_rate, p_gravity, per_reach, K(0.0), stride, K(0.0), vx, vx_1, vy, vy_1, vz, vz_1, which);
            stride = _o189.stride;
            which = _o189.which;
            M rests = _o189.rests;
            const LANES(court_beside_out) _o190 =
                LANES(court_beside)(held, K(0.0));
            M beside = _o190.beside;
            const M _m191 = lanes_both(active, beside);
            if (lanes_any(_m191)) {
                const LANES(court_ring_beside_out) _o192 =
                    LANES(court_ring_beside)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                V gap = _o192.gap;
                V nearing = _o192.nearing;
                V dent = _o192.dent;
                const LANES(court_beside_body_out) _o193 =
                    LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(0.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
                stride = lanes_select(_m191, _o193.stride, stride);
                which = lanes_select(_m191, _o193.which, which);
            }
            const LANES(court_beside_out) _o194 =
                LANES(court_beside)(held, K(1.0));
            beside = _o194.beside;
            const M _m195 = lanes_both(active, beside);
            if (lanes_any(_m195)) {
                const LANES(court_backboard_beside_out) _o196 =
                    LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                V gap = _o196.gap;
                V nearing = _o196.nearing;
                V dent = _o196.dent;
                const LANES(court_beside_body_out) _o197 =
                    LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(1.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
                stride = lanes_select(_m195, _o197.stride, stride);
                which = lanes_select(_m195, _o197.which, which);
            }
            const LANES(court_beside_out) _o198 =
                LANES(court_beside)(held, K(2.0));
            beside = _o198.beside;
            const M _m199 = lanes_both(active, beside);
            if (lanes_any(_m199)) {
                const LANES(court_bridge_beside_out) _o200 =
                    LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                V gap = _o200.gap;
                V nearing = _o200.nearing;
                V dent = _o200.dent;
                const LANES(court_beside_body_out) _o201 =
                    LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(2.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
                stride = lanes_select(_m199, _o201.stride, stride);
                which = lanes_select(_m199, _o201.which, which);
            }
            const LANES(court_end_beside_out) _o202 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            V gap = _o202.gap;
            V nearing = _o202.nearing;
            V dent = _o202.dent;
            const LANES(court_beside_gate_out) _o203 =
                LANES(court_beside_gate)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(3.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
            stride = _o203.stride;
            which = _o203.which;
            const LANES(court_holding_out) _o204 =
                LANES(court_holding)(held, K(1.0));
            here = _o204.here;
            const M _m205 = lanes_both(active, here);
            if (lanes_any(_m205)) {
                const LANES(court_backboard_seam0_out) _o206 =
                    LANES(court_backboard_seam0)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                gap = lanes_select(_m205, _o206.gap, gap);
                V nearing = _o206.nearing;
                V near = _o206.near;
                const LANES(court_beside_seam_out) _o207 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m205, _o207.stride, stride);
                const LANES(court_backboard_seam1_out) _o208 =
                    LANES(court_backboard_seam1)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                gap = lanes_select(_m205, _o208.gap, gap);
                nearing = _o208.nearing;
                near = _o208.near;
                const LANES(court_beside_seam_out) _o209 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m205, _o209.stride, stride);
                const LANES(court_backboard_seam2_out) _o210 =
                    LANES(court_backboard_seam2)(p_ball_radius, p_board_half_width, vy, y);
                gap = lanes_select(_m205, _o210.gap, gap);
                nearing = _o210.nearing;
                near = _o210.near;
                const LANES(court_beside_seam_out) _o211 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m205, _o211.stride, stride);
                const LANES(court_backboard_seam3_out) _o212 =
                    LANES(court_backboard_seam3)(p_ball_radius, p_board_half_width, vy, y);
                gap = lanes_select(_m205, _o212.gap, gap);
                nearing = _o212.nearing;
                near = _o212.near;
                const LANES(court_beside_seam_out) _o213 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m205, _o213.stride, stride);
                const LANES(court_backboard_seam4_out) _o214 =
                    LANES(court_backboard_seam4)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                gap = lanes_select(_m205, _o214.gap, gap);
                nearing = _o214.nearing;
                near = _o214.near;
                const LANES(court_beside_seam_out) _o215 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m205, _o215.stride, stride);
                const LANES(court_backboard_seam5_out) _o216 =
                    LANES(court_backboard_seam5)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                gap = lanes_select(_m205, _o216.gap, gap);
                nearing = _o216.nearing;
                near = _o216.near;
                const LANES(court_beside_seam_out) _o217 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m205, _o217.stride, stride);
            }
            const LANES(court_holding_out) _o218 =
                LANES(court_holding)(held, K(2.0));
            here = _o218.here;
            const M _m219 = lanes_both(active, here);
            if (lanes_any(_m219)) {
                const LANES(court_bridge_seam0_out) _o220 =
                    LANES(court_bridge_seam0)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                gap = lanes_select(_m219, _o220.gap, gap);
                V nearing = _o220.nearing;
                V near = _o220.near;
                const LANES(court_beside_seam_out) _o221 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m219, _o221.stride, stride);
                const LANES(court_bridge_seam1_out) _o222 =
                    LANES(court_bridge_seam1)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                gap = lanes_select(_m219, _o222.gap, gap);
                nearing = _o222.nearing;
                near = _o222.near;
                const LANES(court_beside_seam_out) _o223 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m219, _o223.stride, stride);
                const LANES(court_bridge_seam2_out) _o224 =
                    LANES(court_bridge_seam2)(p_ball_radius, p_bridge_half_width, vy, y);
                gap = lanes_select(_m219, _o224.gap, gap);
                nearing = _o224.nearing;
                near = _o224.near;
                const LANES(court_beside_seam_out) _o225 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m219, _o225.stride, stride);
                const LANES(court_bridge_seam3_out) _o226 =
                    LANES(court_bridge_seam3)(p_ball_radius, p_bridge_half_width, vy, y);
                gap = lanes_select(_m219, _o226.gap, gap);
                nearing = _o226.nearing;
                near = _o226.near;
                const LANES(court_beside_seam_out) _o227 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m219, _o227.stride, stride);
                const LANES(court_bridge_seam4_out) _o228 =
                    LANES(court_bridge_seam4)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                gap = lanes_select(_m219, _o228.gap, gap);
                nearing = _o228.nearing;
                near = _o228.near;
                const LANES(court_beside_seam_out) _o229 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m219, _o229.stride, stride);
                const LANES(court_bridge_seam5_out) _o230 =
                    LANES(court_bridge_seam5)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                gap = lanes_select(_m219, _o230.gap, gap);
                nearing = _o230.nearing;
                near = _o230.near;
                const LANES(court_beside_seam_out) _o231 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m219, _o231.stride, stride);
            }
            const LANES(court_beside_time_out) _o232 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o232.stride;
            which = _o232.which;
            const LANES(court_passing_from_out) _o233 =
                LANES(court_passing_from)(z);
            M over = _o233.over;
            const LANES(court_roll_moved_out) _o234 =
                LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, x, y, z);
            x = _o234.x;
            vx = _o234.vx;
            y = _o234.y;
            vy = _o234.vy;
            z = _o234.z;
            vz = _o234.vz;
            V turn_rate = _o234.turn_rate;
            const LANES(court_holding_out) _o235 =
                LANES(court_holding)(held, K(1.0));
            here = _o235.here;
            const M _m236 = lanes_both(active, here);
            if (lanes_any(_m236)) {
                const LANES(court_backboard_normal_out) _o237 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m236, _o237.nx, nx);
                ny = lanes_select(_m236, _o237.ny, ny);
                nz = lanes_select(_m236, _o237.nz, nz);
                const LANES(court_backboard_off_out) _o238 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z);
                gap = lanes_select(_m236, _o238.gap, gap);
            }
            const LANES(court_holding_out) _o239 =
                LANES(court_holding)(held, K(2.0));
            here = _o239.here;
            const M _m240 = lanes_both(active, here);
            if (lanes_any(_m240)) {
                const LANES(court_bridge_normal_out) _o241 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m240, _o241.nx, nx);
                ny = lanes_select(_m240, _o241.ny, ny);
                nz = lanes_select(_m240, _o241.nz, nz);
                const LANES(court_bridge_off_out) _o242 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m240, _o242.gap, gap);
            }
            const LANES(court_roll_placed_out) _o243 =
                LANES(court_roll_placed)(p_ball_radius, gap, nx, ny, nz, turn_rate, vx, vy, vz, x, y, z);
            x = _o243.x;
            y = _o243.y;
            z = _o243.z;
            vx = _o243.vx;
            vy = _o243.vy;
            vz = _o243.vz;
            wx = _o243.wx;
            wy = _o243.wy;
            wz = _o243.wz;
            const LANES(court_passing_in_contact_out) _o244 =
                LANES(court_passing_in_contact)(over, p_ring_radius, through, x, y, z);
            through = _o244.through;
            const LANES(court_rolled_on_out) _o245 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o245.clock;
            rolling = _o245.rolling;
            turns = lanes_add(turns, K(1.0));
            const M ended = lanes_both(active, lanes_not(lanes_both(rolling, lanes_less(turns, K(16.0)))));
            if (lanes_any(ended)) {
                double ended_row[LANES_WIDTH];
                lanes_store(ended_row, row);
                double ended_clock[LANES_WIDTH];
                lanes_store(ended_clock, clock);
                double ended_per_reach[LANES_WIDTH];
                lanes_store(ended_per_reach, per_reach);
                double ended_rests[LANES_WIDTH];
                lanes_store(ended_rests, lanes_select(rests, K(1.0), K(0.0)));
                double ended_rolling[LANES_WIDTH];
                lanes_store(ended_rolling, lanes_select(rolling, K(1.0), K(0.0)));
                double ended_through[LANES_WIDTH];
                lanes_store(ended_through, through);
                double ended_vx[LANES_WIDTH];
                lanes_store(ended_vx, vx);
                double ended_vy[LANES_WIDTH];
                lanes_store(ended_vy, vy);
                double ended_vz[LANES_WIDTH];
                lanes_store(ended_vz, vz);
                double ended_which[LANES_WIDTH];
                lanes_store(ended_which, which);
                double ended_wx[LANES_WIDTH];
                lanes_store(ended_wx, wx);
                double ended_wy[LANES_WIDTH];
                lanes_store(ended_wy, wy);
                double ended_wz[LANES_WIDTH];
                lanes_store(ended_wz, wz);
                double ended_x[LANES_WIDTH];
                lanes_store(ended_x, x);
                double ended_y[LANES_WIDTH];
                lanes_store(ended_y, y);
                double ended_z[LANES_WIDTH];
                lanes_store(ended_z, z);
                for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                    const int lane = LANES_LOWEST(bits);
                    const size_t k = (size_t)ended_row[lane];
                    lists->kept_clock[k] = ended_clock[lane];
                    lists->kept_per_reach[k] = ended_per_reach[lane];
                    lists->kept_rests[k] = ended_rests[lane];
                    lists->kept_rolling[k] = ended_rolling[lane];
                    lists->kept_through[k] = ended_through[lane];
                    lists->kept_vx[k] = ended_vx[lane];
                    lists->kept_vy[k] = ended_vy[lane];
                    lists->kept_vz[k] = ended_vz[lane];
                    lists->kept_which[k] = ended_which[lane];
                    lists->kept_wx[k] = ended_wx[lane];
                    lists->kept_wy[k] = ended_wy[lane];
                    lists->kept_wz[k] = ended_wz[lane];
                    lists->kept_x[k] = ended_x[lane];
                    lists->kept_y[k] = ended_y[lane];
                    lists->kept_z[k] = ended_z[lane];
                }
                busy -= lanes_many(ended);
                active = lanes_both(active, lanes_not(ended));
            }
        }
    }
    }
    {
    size_t kept_circling_shots = 0;
    for (size_t i = 0; i < kept_shots; i += LANES_WIDTH) {
        const M rows = lanes_first(kept_shots - i);
        V circled = lanes_load(lists->kept_circled + i);
        M circling = lanes_less(K(0.0), lanes_load(lists->kept_circling + i));
        V clock = lanes_load(lists->kept_clock + i);
        const V p_ball_radius = lanes_load(varying ? lists->kept_p_ball_radius + i : lists->p_ball_radius);
        const V p_board_bottom = lanes_load(varying ? lists->kept_p_board_bottom + i : lists->p_board_bottom);
        const V p_board_distance = lanes_load(varying ? lists->kept_p_board_distance + i : lists->p_board_distance);
        const V p_board_half_width = lanes_load(varying ? lists->kept_p_board_half_width + i : lists->p_board_half_width);
        const V p_board_thickness = lanes_load(varying ? lists->kept_p_board_thickness + i : lists->p_board_thickness);
        const V p_board_top = lanes_load(varying ? lists->kept_p_board_top + i : lists->p_board_top);
        const V p_bridge_depth = lanes_load(varying ? lists->kept_p_bridge_depth + i : lists->p_bridge_depth);
        const V p_bridge_half_width = lanes_load(varying ? lists->kept_p_bridge_half_width + i : lists->p_bridge_half_width);
        const V p_end_depth = lanes_load(varying ? lists->kept_p_end_depth + i : lists->p_end_depth);
        const V p_gravity = lanes_load(varying ? lists->kept_p_gravity + i : lists->p_gravity);
        const V p_ring_radius = lanes_load(varying ? lists->kept_p_ring_radius + i : lists->p_ring_radius);
        const V p_wire_radius = lanes_load(varying ? lists->kept_p_wire_radius + i : lists->p_wire_radius);
        V through = lanes_load(lists->kept_through + i);
        V vx = lanes_load(lists->kept_vx + i);
        V vy = lanes_load(lists->kept_vy + i);
        V vz = lanes_load(lists->kept_vz + i);
        V which = lanes_load(lists->kept_which + i);
        V wx = lanes_load(lists->kept_wx + i);
        V wy = lanes_load(lists->kept_wy + i);
        V wz = lanes_load(lists->kept_wz + i);
        V x = lanes_load(lists->kept_x + i);
        V y = lanes_load(lists->kept_y + i);
        V z = lanes_load(lists->kept_z + i);
        const M packed = lanes_both(rows, circling);
        if (lanes_any(packed)) {
            lanes_pack(lists->kept_circling_row + kept_circling_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
            lanes_pack(lists->kept_circling_circled + kept_circling_shots, packed, circled);
            lanes_pack(lists->kept_circling_clock + kept_circling_shots, packed, clock);
            if (varying)
                lanes_pack(lists->kept_circling_p_ball_radius + kept_circling_shots, packed, p_ball_radius);
            if (varying)
                lanes_pack(lists->kept_circling_p_board_bottom + kept_circling_shots, packed, p_board_bottom);
            if (varying)
                lanes_pack(lists->kept_circling_p_board_distance + kept_circling_shots, packed, p_board_distance);
            if (varying)
                lanes_pack(lists->kept_circling_p_board_half_width + kept_circling_shots, packed, p_board_half_width);
            if (varying)
                lanes_pack(lists->kept_circling_p_board_thickness + kept_circling_shots, packed, p_board_thickness);
            if (varying)
                lanes_pack(lists->kept_circling_p_board_top + kept_circling_shots, packed, p_board_top);
            if (varying)
                lanes_pack(lists->kept_circling_p_bridge_depth + kept_circling_shots, packed, p_bridge_depth);
            if (varying)
                lanes_pack(lists->kept_circling_p_bridge_half_width + kept_circling_shots, packed, p_bridge_half_width);
            if (varying)
                lanes_pack(lists->kept_circling_p_end_depth + kept_circling_shots, packed, p_end_depth);
            if (varying)
                lanes_pack(lists->kept_circling_p_gravity + kept_circling_shots, packed, p_gravity);
            if (varying)
                lanes_pack(lists->kept_circling_p_ring_radius + kept_circling_shots, packed, p_ring_radius);
            if (varying)
                lanes_pack(lists->kept_circling_p_wire_radius + kept_circling_shots, packed, p_wire_radius);
            lanes_pack(lists->kept_circling_through + kept_circling_shots, packed, through);
            lanes_pack(lists->kept_circling_vx + kept_circling_shots, packed, vx);
            lanes_pack(lists->kept_circling_vy + kept_circling_shots, packed, vy);
            lanes_pack(lists->kept_circling_vz + kept_circling_shots, packed, vz);
            lanes_pack(lists->kept_circling_which + kept_circling_shots, packed, which);
            lanes_pack(lists->kept_circling_wx + kept_circling_shots, packed, wx);
            lanes_pack(lists->kept_circling_wy + kept_circling_shots, packed, wy);
            lanes_pack(lists->kept_circling_wz + kept_circling_shots, packed, wz);
            lanes_pack(lists->kept_circling_x + kept_circling_shots, packed, x);
            lanes_pack(lists->kept_circling_y + kept_circling_shots, packed, y);
            lanes_pack(lists->kept_circling_z + kept_circling_shots, packed, z);
            kept_circling_shots += lanes_many(packed);
        }
    }
    {
        size_t taken = 0, busy = 0;
        M active = lanes_nowhere();
        V row = K(0.0), turns = K(0.0);
        V p_ball_radius = lanes_load(lists->p_ball_radius);
        V p_board_bottom = lanes_load(lists->p_board_bottom);
        V p_board_distance = lanes_load(lists->p_board_distance);
        V p_board_half_width = lanes_load(lists->p_board_half_width);
        V p_board_thickness = lanes_load(lists->p_board_thickness);
        V p_board_top = lanes_load(lists->p_board_top);
        V p_bridge_depth = lanes_load(lists->p_bridge_depth);
        V p_bridge_half_width = lanes_load(lists->p_bridge_half_width);
        V p_end_depth = lanes_load(lists->p_end_depth);
        V p_gravity = lanes_load(lists->p_gravity);
        V p_ring_radius = lanes_load(lists->p_ring_radius);
        V p_wire_radius = lanes_load(lists->p_wire_radius);
        V circled = K(0.0);
        V clock = K(0.0);
        V through = K(0.0);
        V vx = K(0.0);
        V vy = K(0.0);
        V vz = K(0.0);
        V which = K(0.0);
        V wx = K(0.0);
        V wy = K(0.0);
        V wz = K(0.0);
        V x = K(0.0);
        V y = K(0.0);
        V z = K(0.0);
        for (;;) {
            if (taken < kept_circling_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                const M idle = lanes_not(active);
                row = lanes_expand(lists->kept_circling_row + taken, idle, row);
                turns = lanes_select(idle, K(0.0), turns);
                circled = lanes_expand(lists->kept_circling_circled + taken, idle, circled);
                clock = lanes_expand(lists->kept_circling_clock + taken, idle, clock);
                through = lanes_expand(lists->kept_circling_through + taken, idle, through);
                vx = lanes_expand(lists->kept_circling_vx + taken, idle, vx);
                vy = lanes_expand(lists->kept_circling_vy + taken, idle, vy);
                vz = lanes_expand(lists->kept_circling_vz + taken, idle, vz);
                which = lanes_expand(lists->kept_circling_which + taken, idle, which);
                wx = lanes_expand(lists->kept_circling_wx + taken, idle, wx);
                wy = lanes_expand(lists->kept_circling_wy + taken, idle, wy);
                wz = lanes_expand(lists->kept_circling_wz + taken, idle, wz);
                x = lanes_expand(lists->kept_circling_x + taken, idle, x);
                y = lanes_expand(lists->kept_circling_y + taken, idle, y);
                z = lanes_expand(lists->kept_circling_z + taken, idle, z);
                if (varying) {
                    p_ball_radius = lanes_expand(lists->kept_circling_p_ball_radius + taken, idle, p_ball_radius);
                    p_board_bottom = lanes_expand(lists->kept_circling_p_board_bottom + taken, idle, p_board_bottom);
                    p_board_distance = lanes_expand(lists->kept_circling_p_board_distance + taken, idle, p_board_distance);
                    p_board_half_width = lanes_expand(lists->kept_circling_p_board_half_width + taken, idle, p_board_half_width);
                    p_board_thickness = lanes_expand(lists->kept_circling_p_board_thickness + taken, idle, p_board_thickness);
                    p_board_top = lanes_expand(lists->kept_circling_p_board_top + taken, idle, p_board_top);
                    p_bridge_depth = lanes_expand(lists->kept_circling_p_bridge_depth + taken, idle, p_bridge_depth);
                    p_bridge_half_width = lanes_expand(lists->kept_circling_p_bridge_half_width + taken, idle, p_bridge_half_width);
                    p_end_depth = lanes_expand(lists->kept_circling_p_end_depth + taken, idle, p_end_depth);
                    p_gravity = lanes_expand(lists->kept_circling_p_gravity + taken, idle, p_gravity);
                    p_ring_radius = lanes_expand(lists->kept_circling_p_ring_radius + taken, idle, p_ring_radius);
                    p_wire_radius = lanes_expand(lists->kept_circling_p_wire_radius + taken, idle, p_wire_radius);
                }
                const size_t room = LANES_WIDTH - busy, left = kept_circling_shots - taken;
                active = lanes_leading(idle, left, active);
                taken += left < room ? left : room;
                busy += left < room ? left : room;
            }
            if (busy == 0)
                break;
            M circling = active;
            const LANES(court_ring_tube_out) _o246 =
                LANES(court_ring_tube)(p_ball_radius, p_wire_radius);
            V per_reach = _o246.per_reach;
            const LANES(court_ring_round_start_out) _o247 =
                LANES(court_ring_round_start)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, wx, wy, wz, x, y, z);
            V cosine_0 = _o247.cosine_0;
            V sine_0 = _o247.sine_0;
            V climb_0 = _o247.climb_0;
            V along_0 = _o247.along_0;
            V turn_rate_0 = _o247.turn_rate_0;
            V cos_0 = _o247.cos_0;
            V sin_0 = _o247.sin_0;
            V near_0 = _o247.near_0;
            const LANES(court_ring_round_0_out) _o248 =
                LANES(court_ring_round_0)(along_0, p_ball_radius, climb_0, cos_0, cosine_0, p_gravity, near_0, p_ring_radius, sin_0, sine_0, turn_rate_0, p_wire_radius);
            V omega_0 = _o248.omega_0;
            V around_0 = _o248.around_0;
            V tilted_0 = _o248.tilted_0;
            V pressed_0 = _o248.pressed_0;
            V force_0 = _o248.force_0;
            V cosine_1 = _o248.cosine_1;
            V sine_1 = _o248.sine_1;
            V climb_1 = _o248.climb_1;
            V along_1 = _o248.along_1;
            V turn_rate_1 = _o248.turn_rate_1;
            V cos_1 = _o248.cos_1;
            V sin_1 = _o248.sin_1;
            const LANES(court_ring_round_1_out) _o249 =
                LANES(court_ring_round_1)(along_0, along_1, around_0, p_ball_radius, climb_0, climb_1, cos_0, cos_1, cosine_0, cosine_1, p_gravity, near_0, omega_0, pressed_0, p_ring_radius, sin_0, sin_1, sine_0, sine_1, tilted_0, turn_rate_0, turn_rate_1, p_wire_radius);
            V near_1 = _o249.near_1;
            V omega_1 = _o249.omega_1;
            V around_1 = _o249.around_1;
            V tilted_1 = _o249.tilted_1;
            V pressed_1 = _o249.pressed_1;
            V force_1 = _o249.force_1;
            V cosine_2 = _o249.cosine_2;
            V sine_2 = _o249.sine_2;
            V climb_2 = _o249.climb_2;
            V along_2 = _o249.along_2;
            V turn_rate_2 = _o249.turn_rate_2;
            V cos_2 = _o249.cos_2;
            V sin_2 = _o249.sin_2;
            const LANES(court_ring_round_2_out) _o250 =
                LANES(court_ring_round_2)(along_0, along_1, along_2, around_0, around_1, p_ball_radius, climb_0, climb_1, climb_2, cos_0, cos_1, cos_2, cosine_0, cosine_1, cosine_2, p_gravity, near_0, near_1, omega_0, omega_1, pressed_0, pressed_1, p_ring_radius, sin_0, sin_1, sin_2, sine_0, sine_1, sine_2, tilted_0, tilted_1, turn_rate_0, turn_rate_1, turn_rate_2, p_wire_radius);
            V near_2 = _o250.near_2;
            V omega_2 = _o250.omega_2;
            V around_2 = _o250.around_2;
            V tilted_2 = _o250.tilted_2;
            V pressed_2 = _o250.pressed_2;
            V force_2 = _o250.force_2;
            V cosine_3 = _o250.cosine_3;
            V sine_3 = _o250.sine_3;
            V climb_3 = _o250.climb_3;
            V along_3 = _o250.along_3;
            V turn_rate_3 = _o250.turn_rate_3;
            V cos_3 = _o250.cos_3;
            V sin_3 = _o250.sin_3;
            const LANES(court_ring_round_3_out) _o251 =
                LANES(court_ring_round_3)(along_0, along_1, along_2, along_3, around_0, around_1, around_2, p_ball_radius, climb_0, climb_1, climb_2, climb_3, cos_0, cos_1, cos_2, cos_3, cosine_0, cosine_1, cosine_2, cosine_3, p_gravity, near_0, near_1, near_2, omega_0, omega_1, omega_2, pressed_0, pressed_1, pressed_2, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sine_0, sine_1, sine_2, sine_3, tilted_0, tilted_1, tilted_2, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, p_wire_radius);
            V near_3 = _o251.near_3;
            V omega_3 = _o251.omega_3;
            V around_3 = _o251.around_3;
            V tilted_3 = _o251.tilted_3;
            V pressed_3 = _o251.pressed_3;
            V force_3 = _o251.force_3;
            V cosine_4 = _o251.cosine_4;
            V sine_4 = _o251.sine_4;
            V climb_4 = _o251.climb_4;
            V along_4 = _o251.along_4;
            V turn_rate_4 = _o251.turn_rate_4;
            V cos_4 = _o251.cos_4;
            V sin_4 = _o251.sin_4;
            const LANES(court_ring_round_4_out) _o252 =
                LANES(court_ring_round_4)(along_0, along_1, along_2, along_3, along_4, around_0, around_1, around_2, around_3, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, cos_0, cos_1, cos_2, cos_3, cos_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, p_gravity, near_0, near_1, near_2, near_3, omega_0, omega_1, omega_2, omega_3, pressed_0, pressed_1, pressed_2, pressed_3, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sine_0, sine_1, sine_2, sine_3, sine_4, tilted_0, tilted_1, tilted_2, tilted_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, p_wire_radius);
            V near_4 = _o252.near_4;
            V omega_4 = _o252.omega_4;
            V around_4 = _o252.around_4;
            V tilted_4 = _o252.tilted_4;
            V pressed_4 = _o252.pressed_4;
            V force_4 = _o252.force_4;
            V cosine_5 = _o252.cosine_5;
            V sine_5 = _o252.sine_5;
            V climb_5 = _o252.climb_5;
            V along_5 = _o252.along_5;
            V turn_rate_5 = _o252.turn_rate_5;
            V cos_5 = _o252.cos_5;
            V sin_5 = _o252.sin_5;
            const LANES(court_ring_round_5_out) _o253 =
                LANES(court_ring_round_5)(along_0, along_1, along_2, along_3, along_4, along_5, around_0, around_1, around_2, around_3, around_4, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, p_gravity, near_0, near_1, near_2, near_3, near_4, omega_0, omega_1, omega_2, omega_3, omega_4, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, p_wire_radius);
            V near_5 = _o253.near_5;
            V omega_5 = _o253.omega_5;
            V around_5 = _o253.around_5;
            V tilted_5 = _o253.tilted_5;
            V pressed_5 = _o253.pressed_5;
            V force_5 = _o253.force_5;
            V cosine_6 = _o253.cosine_6;
            V sine_6 = _o253.sine_6;
            V climb_6 = _o253.climb_6;
            V along_6 = _o253.along_6;
            V turn_rate_6 = _o253.turn_rate_6;
            V cos_6 = _o253.cos_6;
            V sin_6 = _o253.sin_6;
            const LANES(court_ring_round_6_out) _o254 =
                LANES(court_ring_round_6)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, around_0, around_1, around_2, around_3, around_4, around_5, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, p_wire_radius);
            V near_6 = _o254.near_6;
            V omega_6 = _o254.omega_6;
            V around_6 = _o254.around_6;
            V tilted_6 = _o254.tilted_6;
            V pressed_6 = _o254.pressed_6;
            V force_6 = _o254.force_6;
            V cosine_7 = _o254.cosine_7;
            V sine_7 = _o254.sine_7;
            V climb_7 = _o254.climb_7;
            V along_7 = _o254.along_7;
            V turn_rate_7 = _o254.turn_rate_7;
            V cos_7 = _o254.cos_7;
            V sin_7 = _o254.sin_7;
            const LANES(court_ring_round_7_out) _o255 =
                LANES(court_ring_round_7)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, p_wire_radius);
            V near_7 = _o255.near_7;
            V omega_7 = _o255.omega_7;
            V around_7 = _o255.around_7;
            V tilted_7 = _o255.tilted_7;
            V pressed_7 = _o255.pressed_7;
            V force_7 = _o255.force_7;
            V cosine_8 = _o255.cosine_8;
            V sine_8 = _o255.sine_8;
            V climb_8 = _o255.climb_8;
            V along_8 = _o255.along_8;
            V turn_rate_8 = _o255.turn_rate_8;
            V cos_8 = _o255.cos_8;
            V sin_8 = _o255.sin_8;
            const LANES(court_ring_round_8_out) _o256 =
                LANES(court_ring_round_8)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, p_wire_radius);
            V near_8 = _o256.near_8;
            V omega_8 = _o256.omega_8;
            V around_8 = _o256.around_8;
            V tilted_8 = _o256.tilted_8;
            V pressed_8 = _o256.pressed_8;
            V force_8 = _o256.force_8;
            V cosine_9 = _o256.cosine_9;
            V sine_9 = _o256.sine_9;
            V climb_9 = _o256.climb_9;
            V along_9 = _o256.along_9;
            V turn_rate_9 = _o256.turn_rate_9;
            V cos_9 = _o256.cos_9;
            V sin_9 = _o256.sin_9;
            const LANES(court_ring_round_9_out) _o257 =
                LANES(court_ring_round_9)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V near_9 = _o257.near_9;
            V omega_9 = _o257.omega_9;
            V around_9 = _o257.around_9;
            V tilted_9 = _o257.tilted_9;
            V pressed_9 = _o257.pressed_9;
            V force_9 = _o257.force_9;
            V cosine_10 = _o257.cosine_10;
            V sine_10 = _o257.sine_10;
            V climb_10 = _o257.climb_10;
            V along_10 = _o257.along_10;
            V turn_rate_10 = _o257.turn_rate_10;
            V cos_10 = _o257.cos_10;
            V sin_10 = _o257.sin_10;
            const LANES(court_ring_round_10_out) _o258 =
                LANES(court_ring_round_10)(along_0, along_1, along_10, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V near_10 = _o258.near_10;
            V omega_10 = _o258.omega_10;
            V around_10 = _o258.around_10;
            V tilted_10 = _o258.tilted_10;
            V pressed_10 = _o258.pressed_10;
            V force_10 = _o258.force_10;
            V cosine_11 = _o258.cosine_11;
            V sine_11 = _o258.sine_11;
            V climb_11 = _o258.climb_11;
            V along_11 = _o258.along_11;
            V turn_rate_11 = _o258.turn_rate_11;
            V cos_11 = _o258.cos_11;
            V sin_11 = _o258.sin_11;
            const LANES(court_ring_round_11_out) _o259 =
                LANES(court_ring_round_11)(along_0, along_1, along_10, along_11, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_10, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_10, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_10, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_10, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V force_11 = _o259.force_11;
            V cosine_12 = _o259.cosine_12;
            V sine_12 = _o259.sine_12;
            V climb_12 = _o259.climb_12;
            V along_12 = _o259.along_12;
            V turn_rate_12 = _o259.turn_rate_12;
            V cos_12 = _o259.cos_12;
            V sin_12 = _o259.sin_12;
            const LANES(court_ring_round_pace_out) _o260 =
                LANES(court_ring_round_pace)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_12, cosine_0, cosine_12, force_0, force_1, force_10, force_11, force_2, force_3, force_4, force_5, force_6, force_7, force_8, force_9, p_gravity, omega_0, p_ring_radius, sin_0, sin_12, sine_0, sine_12, turn_rate_0, turn_rate_11, turn_rate_12, p_wire_radius);
            V stride = _o260.stride;
            V strongest = _o260.strongest;
            V fastest = _o260.fastest;
            V sway = _o260.sway;
            V force = _o260.force;
            V force_rate = _o260.force_rate;
            V force_bend = _o260.force_bend;
            V brace = _o260.brace;
            V vx_1 = _o260.vx_1;
            V vy_1 = _o260.vy_1;
            V vz_1 = _o260.vz_1;
            const LANES(court_leaving_force_out) _o261 =
                LANES(court_leaving_force)(p_ball_radius, brace, K(INFINITY), fastest, force, force_bend, force_rate, p_gravity, per_reach, K(0.0), stride, K(0.0), vx, vx_1, vy, vy_1, vz, vz_1, which);
            stride = _o261.stride;
            which = _o261.which;
            M rests = _o261.rests;
            const LANES(court_backboard_beside_out) _o262 =
                LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            V gap = _o262.gap;
            V nearing = _o262.nearing;
            V dent = _o262.dent;
            const LANES(court_beside_body_out) _o263 =
                LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(1.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
            stride = _o263.stride;
            which = _o263.which;
            const LANES(court_bridge_beside_out) _o264 =
                LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o264.gap;
            nearing = _o264.nearing;
            dent = _o264.dent;
            const LANES(court_beside_body_out) _o265 =
                LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(2.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
            stride = _o265.stride;
            which = _o265.which;
            const LANES(court_end_beside_out) _o266 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o266.gap;
            nearing = _o266.nearing;
            dent = _o266.dent;
            const LANES(court_beside_gate_out) _o267 =
                LANES(court_beside_gate)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(3.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
            stride = _o267.stride;
            which = _o267.which;
            const LANES(court_beside_time_out) _o268 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o268.stride;
            which = _o268.which;
            const LANES(court_passing_from_out) _o269 =
                LANES(court_passing_from)(z);
            M over = _o269.over;
            const LANES(court_alone_out) _o270 =
                LANES(court_alone)();
            V berth = _o270.nearest;
            const LANES(court_leaps_out) _o271 =
                LANES(court_leaps)(stride);
            V forth = _o271.forth;
            V back = _o271.back;
            const LANES(court_backboard_around_out) _o272 =
                LANES(court_backboard_around)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            gap = _o272.gap;
            nearing = _o272.nearing;
            const LANES(court_cleared_out) _o273 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o273.berth;
            const LANES(court_bridge_around_out) _o274 =
                LANES(court_bridge_around)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o274.gap;
            nearing = _o274.nearing;
            const LANES(court_cleared_out) _o275 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o275.berth;
            const LANES(court_end_around_out) _o276 =
                LANES(court_end_around)(p_end_depth, vz, z);
            gap = _o276.gap;
            nearing = _o276.nearing;
            const LANES(court_cleared_out) _o277 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o277.berth;
            const LANES(court_ring_round_moved_out) _o278 =
                LANES(court_ring_round_moved)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_12, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_12, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_12, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_12, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, stride, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_12, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            x = _o278.x;
            y = _o278.y;
            z = _o278.z;
            vx = _o278.vx;
            vy = _o278.vy;
            vz = _o278.vz;
            wx = _o278.wx;
            wy = _o278.wy;
            wz = _o278.wz;
            V climb = _o278.climb;
            const LANES(court_passing_in_contact_out) _o279 =
                LANES(court_passing_in_contact)(over, p_ring_radius, through, x, y, z);
            through = _o279.through;
            const LANES(court_backboard_around_out) _o280 =
                LANES(court_backboard_around)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            gap = _o280.gap;
            nearing = _o280.nearing;
            const LANES(court_cleared_out) _o281 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o281.berth;
            const LANES(court_bridge_around_out) _o282 =
                LANES(court_bridge_around)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o282.gap;
            nearing = _o282.nearing;
            const LANES(court_cleared_out) _o283 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o283.berth;
            const LANES(court_end_around_out) _o284 =
                LANES(court_end_around)(p_end_depth, vz, z);
            gap = _o284.gap;
            nearing = _o284.nearing;
            const LANES(court_cleared_out) _o285 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o285.berth;
            const LANES(court_ring_swung_out) _o286 =
                LANES(court_ring_swung)(p_ball_radius, berth, circled, climb, climb_0, K(INFINITY), fastest, force, force_bend, force_rate, p_gravity, K(0.0), stride, sway, K(0.0), which, p_wire_radius);
            circled = _o286.circled;
            M endless = _o286.endless;
            const LANES(court_for_ever_out) _o287 =
                LANES(court_for_ever)(endless, which);
            which = _o287.which;
            const LANES(court_rolled_on_out) _o288 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o288.clock;
            circling = _o288.rolling;
            turns = lanes_add(turns, K(1.0));
            const M ended = lanes_both(active, lanes_not(lanes_both(circling, lanes_less(turns, K(16.0)))));
            if (lanes_any(ended)) {
                double ended_row[LANES_WIDTH];
                lanes_store(ended_row, row);
                double ended_circled[LANES_WIDTH];
                lanes_store(ended_circled, circled);
                double ended_circling[LANES_WIDTH];
                lanes_store(ended_circling, lanes_select(circling, K(1.0), K(0.0)));
                double ended_clock[LANES_WIDTH];
                lanes_store(ended_clock, clock);
                double ended_per_reach[LANES_WIDTH];
                lanes_store(ended_per_reach, per_reach);
                double ended_rests[LANES_WIDTH];
                lanes_store(ended_rests, lanes_select(rests, K(1.0), K(0.0)));
                double ended_through[LANES_WIDTH];
                lanes_store(ended_through, through);
                double ended_vx[LANES_WIDTH];
                lanes_store(ended_vx, vx);
                double ended_vy[LANES_WIDTH];
                lanes_store(ended_vy, vy);
                double ended_vz[LANES_WIDTH];
                lanes_store(ended_vz, vz);
                double ended_which[LANES_WIDTH];
                lanes_store(ended_which, which);
                double ended_wx[LANES_WIDTH];
                lanes_store(ended_wx, wx);
                double ended_wy[LANES_WIDTH];
                lanes_store(ended_wy, wy);
                double ended_wz[LANES_WIDTH];
                lanes_store(ended_wz, wz);
                double ended_x[LANES_WIDTH];
                lanes_store(ended_x, x);
                double ended_y[LANES_WIDTH];
                lanes_store(ended_y, y);
                double ended_z[LANES_WIDTH];
                lanes_store(ended_z, z);
                for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                    const int lane = LANES_LOWEST(bits);
                    const size_t k = (size_t)ended_row[lane];
                    lists->kept_circled[k] = ended_circled[lane];
                    lists->kept_circling[k] = ended_circling[lane];
                    lists->kept_clock[k] = ended_clock[lane];
                    lists->kept_per_reach[k] = ended_per_reach[lane];
                    lists->kept_rests[k] = ended_rests[lane];
                    lists->kept_through[k] = ended_through[lane];
                    lists->kept_vx[k] = ended_vx[lane];
                    lists->kept_vy[k] = ended_vy[lane];
                    lists->kept_vz[k] = ended_vz[lane];
                    lists->kept_which[k] = ended_which[lane];
                    lists->kept_wx[k] = ended_wx[lane];
                    lists->kept_wy[k] = ended_wy[lane];
                    lists->kept_wz[k] = ended_wz[lane];
                    lists->kept_x[k] = ended_x[lane];
                    lists->kept_y[k] = ended_y[lane];
                    lists->kept_z[k] = ended_z[lane];
                }
                busy -= lanes_many(ended);
                active = lanes_both(active, lanes_not(ended));
            }
        }
    }
    }
    {
    size_t kept_leaves_shots = 0;
    for (size_t i = 0; i < kept_shots; i += LANES_WIDTH) {
        const M rows = lanes_first(kept_shots - i);
        M circling = lanes_less(K(0.0), lanes_load(lists->kept_circling + i));
        V held = lanes_load(lists->kept_held + i);
        M leaves = lanes_less(K(0.0), lanes_load(lists->kept_leaves + i));
        V lift = lanes_load(lists->kept_lift + i);
        const V p_ball_radius = lanes_load(varying ? lists->kept_p_ball_radius + i : lists->p_ball_radius);
        const V p_board_bottom = lanes_load(varying ? lists->kept_p_board_bottom + i : lists->p_board_bottom);
        const V p_board_distance = lanes_load(varying ? lists->kept_p_board_distance + i : lists->p_board_distance);
        const V p_board_half_width = lanes_load(varying ? lists->kept_p_board_half_width + i : lists->p_board_half_width);
        const V p_board_thickness = lanes_load(varying ? lists->kept_p_board_thickness + i : lists->p_board_thickness);
        const V p_board_top = lanes_load(varying ? lists->kept_p_board_top + i : lists->p_board_top);
        const V p_bridge_depth = lanes_load(varying ? lists->kept_p_bridge_depth + i : lists->p_bridge_depth);
        const V p_bridge_half_width = lanes_load(varying ? lists->kept_p_bridge_half_width + i : lists->p_bridge_half_width);
        const V p_end_depth = lanes_load(varying ? lists->kept_p_end_depth + i : lists->p_end_depth);
        const V p_gravity = lanes_load(varying ? lists->kept_p_gravity + i : lists->p_gravity);
        const V p_ring_radius = lanes_load(varying ? lists->kept_p_ring_radius + i : lists->p_ring_radius);
        const V p_wire_radius = lanes_load(varying ? lists->kept_p_wire_radius + i : lists->p_wire_radius);
        V per_reach = lanes_load(lists->kept_per_reach + i);
        M rolling = lanes_less(K(0.0), lanes_load(lists->kept_rolling + i));
        V snap = lanes_load(lists->kept_snap + i);
        V surge = lanes_load(lists->kept_surge + i);
        V vx = lanes_load(lists->kept_vx + i);
        V vy = lanes_load(lists->kept_vy + i);
        V vz = lanes_load(lists->kept_vz + i);
        V x = lanes_load(lists->kept_x + i);
        V y = lanes_load(lists->kept_y + i);
        V z = lanes_load(lists->kept_z + i);
        const LANES(court_rejoined_out) _o289 =
            LANES(court_rejoined)(circling, rolling);
        rolling = _o289.rolling;
        lanes_store(lists->kept_rolling + i, lanes_select(rolling, K(1.0), K(0.0)));
        const M packed = lanes_both(rows, leaves);
        if (lanes_any(packed)) {
            lanes_pack(lists->kept_leaves_row + kept_leaves_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
            lanes_pack(lists->kept_leaves_held + kept_leaves_shots, packed, held);
            lanes_pack(lists->kept_leaves_lift + kept_leaves_shots, packed, lift);
            if (varying)
                lanes_pack(lists->kept_leaves_p_ball_radius + kept_leaves_shots, packed, p_ball_radius);
            if (varying)
                lanes_pack(lists->kept_leaves_p_board_bottom + kept_leaves_shots, packed, p_board_bottom);
            if (varying)
                lanes_pack(lists->kept_leaves_p_board_distance + kept_leaves_shots, packed, p_board_distance);
            if (varying)
                lanes_pack(lists->kept_leaves_p_board_half_width + kept_leaves_shots, packed, p_board_half_width);
            if (varying)
                lanes_pack(lists->kept_leaves_p_board_thickness + kept_leaves_shots, packed, p_board_thickness);
            if (varying)
                lanes_pack(lists->kept_leaves_p_board_top + kept_leaves_shots, packed, p_board_top);
            if (varying)
                lanes_pack(lists->kept_leaves_p_bridge_depth + kept_leaves_shots, packed, p_bridge_depth);
            if (varying)
                lanes_pack(lists->kept_leaves_p_bridge_half_width + kept_leaves_shots, packed, p_bridge_half_width);
            if (varying)
                lanes_pack(lists->kept_leaves_p_end_depth + kept_leaves_shots, packed, p_end_depth);
            if (varying)
                lanes_pack(lists->kept_leaves_p_gravity + kept_leaves_shots, packed, p_gravity);
            if (varying)
                lanes_pack(lists->kept_leaves_p_ring_radius + kept_leaves_shots, packed, p_ring_radius);
            if (varying)
                lanes_pack(lists->kept_leaves_p_wire_radius + kept_leaves_shots, packed, p_wire_radius);
            lanes_pack(lists->kept_leaves_per_reach + kept_leaves_shots, packed, per_reach);
            lanes_pack(lists->kept_leaves_snap + kept_leaves_shots, packed, snap);
            lanes_pack(lists->kept_leaves_surge + kept_leaves_shots, packed, surge);
            lanes_pack(lists->kept_leaves_vx + kept_leaves_shots, packed, vx);
            lanes_pack(lists->kept_leaves_vy + kept_leaves_shots, packed, vy);
            lanes_pack(lists->kept_leaves_vz + kept_leaves_shots, packed, vz);
            lanes_pack(lists->kept_leaves_x + kept_leaves_shots, packed, x);
            lanes_pack(lists->kept_leaves_y + kept_leaves_shots, packed, y);
            lanes_pack(lists->kept_leaves_z + kept_leaves_shots, packed, z);
            kept_leaves_shots += lanes_many(packed);
        }
    }
    if (kept_leaves_shots)
        LANES(court_plain_leaves)(lists, kept_leaves_shots, varying);
    for (size_t k = 0; k < kept_leaves_shots; k++) {
        const size_t row = (size_t)lists->kept_leaves_row[k];
        lists->kept_when[row] = lists->kept_leaves_when[k];
        lists->kept_which[row] = lists->kept_leaves_which[k];
    }
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_slow)(LANES(court_plain_lists) *lists, size_t slow_shots, size_t varying)
{
    for (size_t i = 0; i < slow_shots; i += LANES_WIDTH) {
        const M rows = lanes_first(slow_shots - i);
        V held = lanes_load(lists->slow_held + i);
        V mode = lanes_load(lists->slow_mode + i);
        V outcome = lanes_load(lists->slow_outcome + i);
        const V p_backboard_friction = lanes_load(varying ? lists->slow_p_backboard_friction + i : lists->p_backboard_friction);
        const V p_backboard_restitution = lanes_load(varying ? lists->slow_p_backboard_restitution + i : lists->p_backboard_restitution);
        const V p_ball_radius = lanes_load(varying ? lists->slow_p_ball_radius + i : lists->p_ball_radius);
        const V p_board_bottom = lanes_load(varying ? lists->slow_p_board_bottom + i : lists->p_board_bottom);
        const V p_board_distance = lanes_load(varying ? lists->slow_p_board_distance + i : lists->p_board_distance);
        const V p_board_half_width = lanes_load(varying ? lists->slow_p_board_half_width + i : lists->p_board_half_width);
        const V p_board_thickness = lanes_load(varying ? lists->slow_p_board_thickness + i : lists->p_board_thickness);
        const V p_board_top = lanes_load(varying ? lists->slow_p_board_top + i : lists->p_board_top);
        const V p_bridge_depth = lanes_load(varying ? lists->slow_p_bridge_depth + i : lists->p_bridge_depth);
        const V p_bridge_friction = lanes_load(varying ? lists->slow_p_bridge_friction + i : lists->p_bridge_friction);
        const V p_bridge_half_width = lanes_load(varying ? lists->slow_p_bridge_half_width + i : lists->p_bridge_half_width);
        const V p_bridge_restitution = lanes_load(varying ? lists->slow_p_bridge_restitution + i : lists->p_bridge_restitution);
        const V p_end_depth = lanes_load(varying ? lists->slow_p_end_depth + i : lists->p_end_depth);
        const V p_gravity = lanes_load(varying ? lists->slow_p_gravity + i : lists->p_gravity);
        const V p_ring_friction = lanes_load(varying ? lists->slow_p_ring_friction + i : lists->p_ring_friction);
        const V p_ring_radius = lanes_load(varying ? lists->slow_p_ring_radius + i : lists->p_ring_radius);
        const V p_ring_restitution = lanes_load(varying ? lists->slow_p_ring_restitution + i : lists->p_ring_restitution);
        const V p_wire_radius = lanes_load(varying ? lists->slow_p_wire_radius + i : lists->p_wire_radius);
        V slip_left = lanes_load(lists->slow_slip_left + i);
        V vx = lanes_load(lists->slow_vx + i);
        V vy = lanes_load(lists->slow_vy + i);
        V vz = lanes_load(lists->slow_vz + i);
        V which = lanes_load(lists->slow_which + i);
        V wx = lanes_load(lists->slow_wx + i);
        V wy = lanes_load(lists->slow_wy + i);
        V wz = lanes_load(lists->slow_wz + i);
        V x = lanes_load(lists->slow_x + i);
        V y = lanes_load(lists->slow_y + i);
        V z = lanes_load(lists->slow_z + i);
        const LANES(court_ring_normal_out) _o393 =
            LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
        V nx = _o393.nx;
        V ny = _o393.ny;
        V nz = _o393.nz;
        const LANES(court_here_out) _o394 =
            LANES(court_here)(K(1.0), which);
        M here = _o394.here;
        const M _m395 = lanes_both(rows, here);
        {
            const LANES(court_backboard_normal_out) _o396 =
                LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
            nx = lanes_select(_m395, _o396.nx, nx);
            ny = lanes_select(_m395, _o396.ny, ny);
            nz = lanes_select(_m395, _o396.nz, nz);
        }
        const LANES(court_here_out) _o397 =
            LANES(court_here)(K(2.0), which);
        here = _o397.here;
        const M _m398 = lanes_both(rows, here);
        {
            const LANES(court_bridge_normal_out) _o399 =
                LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
            nx = lanes_select(_m398, _o399.nx, nx);
            ny = lanes_select(_m398, _o399.ny, ny);
            nz = lanes_select(_m398, _o399.nz, nz);
        }
        const LANES(court_nearly_out) _o400 =
            LANES(court_nearly)(p_ball_radius, p_gravity, nx, ny, nz, vx, vy, vz);
        M nearly = _o400.nearly;
        const LANES(court_gripped_out) _o401 =
            LANES(court_gripped)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
        V rolled_x = _o401.rolled_x;
        V rolled_y = _o401.rolled_y;
        V rolled_z = _o401.rolled_z;
        V slip = _o401.slip;
        V bounce = _o401.bounce;
        const LANES(court_here_out) _o402 =
            LANES(court_here)(K(0.0), which);
        here = _o402.here;
        const M _m403 = lanes_both(rows, here);
        if (lanes_any(_m403)) {
            const LANES(court_ring_turning_out) _o404 =
                LANES(court_ring_turning)(p_ball_radius, p_ring_radius, rolled_x, rolled_y, rolled_z, p_wire_radius, x, y);
            V turning_x = _o404.turning_x;
            V turning_y = _o404.turning_y;
            V turning_z = _o404.turning_z;
            const LANES(court_pressed_on_out) _o405 =
                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
            V press = _o405.press;
            V weight = _o405.weight;
            V drag = _o405.drag;
            V thrust_x = _o405.thrust_x;
            V thrust_y = _o405.thrust_y;
            V thrust_z = _o405.thrust_z;
            const LANES(court_alone_out) _o406 =
                LANES(court_alone)();
            V nearest = _o406.nearest;
            V wedge = _o406.wedge;
            const LANES(court_backboard_closing_out) _o407 =
                LANES(court_backboard_closing)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z);
            V gap = _o407.gap;
            V nearing = _o407.nearing;
            V swerve = _o407.swerve;
            V facing = _o407.facing;
            const LANES(court_neared_body_out) _o408 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o408.nearest;
            wedge = _o408.wedge;
            const LANES(court_bridge_closing_out) _o409 =
                LANES(court_bridge_closing)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
            gap = _o409.gap;
            nearing = _o409.nearing;
            swerve = _o409.swerve;
            facing = _o409.facing;
            const LANES(court_neared_body_out) _o410 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o410.nearest;
            wedge = _o410.wedge;
            const LANES(court_end_beside_out) _o411 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o411.gap;
            const LANES(court_neared_out) _o412 =
                LANES(court_neared)(gap, nearest);
            nearest = _o412.nearest;
            const LANES(court_ring_parting_out) _o413 =
                LANES(court_ring_parting)(p_gravity, p_ring_radius, vx, vy, vz, x, y, z);
            V lift = _o413.lift;
            const LANES(court_ring_impact_settling_out) _o414 =
                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_ring_friction, p_ring_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz);
            M settles = _o414.settles;
            M lodges = _o414.lodges;
            M slides = _o414.slides;
            M parts = _o414.parts;
            M unsure = _o414.unsure;
            const LANES(court_settled_out) _o415 =
                LANES(court_settled)(K(0.0), lodges, nearly, outcome, parts, settles, slides, K(0.0), unsure);
            mode = lanes_select(_m403, _o415.mode, mode);
            held = lanes_select(_m403, _o415.held, held);
            outcome = lanes_select(_m403, _o415.outcome, outcome);
            slip_left = lanes_select(_m403, _o415.slip_left, slip_left);
        }
        const LANES(court_here_out) _o416 =
            LANES(court_here)(K(1.0), which);
        here = _o416.here;
        const M _m417 = lanes_both(rows, here);
        if (lanes_any(_m417)) {
            const LANES(court_backboard_turning_out) _o418 =
                LANES(court_backboard_turning)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, rolled_x, rolled_y, rolled_z, x, y, z);
            V turning_x = _o418.turning_x;
            V turning_y = _o418.turning_y;
            V turning_z = _o418.turning_z;
            const LANES(court_pressed_on_out) _o419 =
                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
            V press = _o419.press;
            V weight = _o419.weight;
            V drag = _o419.drag;
            V thrust_x = _o419.thrust_x;
            V thrust_y = _o419.thrust_y;
            V thrust_z = _o419.thrust_z;
            const LANES(court_alone_out) _o420 =
                LANES(court_alone)();
            V nearest = _o420.nearest;
            V wedge = _o420.wedge;
            const LANES(court_ring_closing_out) _o421 =
                LANES(court_ring_closing)(p_ball_radius, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
            V gap = _o421.gap;
            V nearing = _o421.nearing;
            V swerve = _o421.swerve;
            V facing = _o421.facing;
            const LANES(court_neared_body_out) _o422 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o422.nearest;
            wedge = _o422.wedge;
            const LANES(court_bridge_closing_out) _o423 =
                LANES(court_bridge_closing)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
            gap = _o423.gap;
            nearing = _o423.nearing;
            swerve = _o423.swerve;
            facing = _o423.facing;
            const LANES(court_neared_body_out) _o424 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o424.nearest;
            wedge = _o424.wedge;
            const LANES(court_end_beside_out) _o425 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o425.gap;
            const LANES(court_neared_out) _o426 =
                LANES(court_neared)(gap, nearest);
            nearest = _o426.nearest;
            const LANES(court_backboard_parting_out) _o427 =
                LANES(court_backboard_parting)(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, vx, vy, vz, x, y, z);
            V lift = _o427.lift;
            const LANES(court_ring_impact_settling_out) _o428 =
                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_backboard_friction, p_backboard_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz);
            M settles = _o428.settles;
            M lodges = _o428.lodges;
            M slides = _o428.slides;
            M parts = _o428.parts;
            M unsure = _o428.unsure;
            const LANES(court_settled_out) _o429 =
                LANES(court_settled)(K(1.0), lodges, nearly, outcome, parts, settles, slides, K(0.0), unsure);
            mode = lanes_select(_m417, _o429.mode, mode);
            held = lanes_select(_m417, _o429.held, held);
            outcome = lanes_select(_m417, _o429.outcome, outcome);
            slip_left = lanes_select(_m417, _o429.slip_left, slip_left);
        }
        const LANES(court_here_out) _o430 =
            LANES(court_here)(K(2.0), which);
        here = _o430.here;
        const M _m431 = lanes_both(rows, here);
        if (lanes_any(_m431)) {
            const LANES(court_bridge_turning_out) _o432 =
                LANES(court_bridge_turning)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, rolled_x, rolled_y, rolled_z, p_wire_radius, x, y, z);
            V turning_x = _o432.turning_x;
            V turning_y = _o432.turning_y;
            V turning_z = _o432.turning_z;
            const LANES(court_pressed_on_out) _o433 =
                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
            V press = _o433.press;
            V weight = _o433.weight;
            V drag = _o433.drag;
            V thrust_x = _o433.thrust_x;
            V thrust_y = _o433.thrust_y;
            V thrust_z = _o433.thrust_z;
            const LANES(court_alone_out) _o434 =
                LANES(court_alone)();
            V nearest = _o434.nearest;
            V wedge = _o434.wedge;
            const LANES(court_ring_closing_out) _o435 =
                LANES(court_ring_closing)(p_ball_radius, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
            V gap = _o435.gap;
            V nearing = _o435.nearing;
            V swerve = _o435.swerve;
            V facing = _o435.facing;
            const LANES(court_neared_body_out) _o436 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o436.nearest;
            wedge = _o436.wedge;
            const LANES(court_backboard_closing_out) _o437 =
                LANES(court_backboard_closing)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z);
            gap = _o437.gap;
            nearing = _o437.nearing;
            swerve = _o437.swerve;
            facing = _o437.facing;
            const LANES(court_neared_body_out) _o438 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o438.nearest;
            wedge = _o438.wedge;
            const LANES(court_end_beside_out) _o439 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o439.gap;
            const LANES(court_neared_out) _o440 =
                LANES(court_neared)(gap, nearest);
            nearest = _o440.nearest;
            const LANES(court_bridge_parting_out) _o441 =
                LANES(court_bridge_parting)(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            V lift = _o441.lift;
            const LANES(court_ring_impact_settling_out) _o442 =
                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_bridge_friction, p_bridge_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz);
            M settles = _o442.settles;
            M lodges = _o442.lodges;
            M slides = _o442.slides;
            M parts = _o442.parts;
            M unsure = _o442.unsure;
            const LANES(court_settled_out) _o443 =
                LANES(court_settled)(K(2.0), lodges, nearly, outcome, parts, settles, slides, K(0.0), unsure);
            mode = lanes_select(_m431, _o443.mode, mode);
            held = lanes_select(_m431, _o443.held, held);
            outcome = lanes_select(_m431, _o443.outcome, outcome);
            slip_left = lanes_select(_m431, _o443.slip_left, slip_left);
        }
        lanes_store(lists->slow_held + i, held);
        lanes_store(lists->slow_mode + i, mode);
        lanes_store(lists->slow_outcome + i, outcome);
        lanes_store(lists->slow_slip_left + i, slip_left);
    }
}

/* Run the job: fill the rows, take every shot to its next event, make room of those that ended.
   No errors are bounded: the same path, with less work. */
static void LANES(court_plain)(const court_job *job)
{
    LANES(court_plain_lists) all, *const lists = &all;
    const V most_contacts = K((double)job->max_contacts);
    const V time_limit = K(job->time_limit);
    const size_t varying = job->varying ? ~(size_t)0 : 0;
    const int recording = job->results->events != NULL;
    size_t begun = 0, end = 0, shots = 0;
    int streams = 0; /* whether the shots before ended all at once: then those to come will, too */

    lists->waiting = 0;
    if (job->shots == 0)
        return;
    lanes_store(lists->p_ball_radius, K(*job->parameters[0]));
    lanes_store(lists->p_ring_radius, K(*job->parameters[1]));
    lanes_store(lists->p_wire_radius, K(*job->parameters[2]));
    lanes_store(lists->p_board_distance, K(*job->parameters[3]));
    lanes_store(lists->p_board_half_width, K(*job->parameters[4]));
    lanes_store(lists->p_board_bottom, K(*job->parameters[5]));
    lanes_store(lists->p_board_top, K(*job->parameters[6]));
    lanes_store(lists->p_board_thickness, K(*job->parameters[7]));
    lanes_store(lists->p_bridge_half_width, K(*job->parameters[8]));
    lanes_store(lists->p_bridge_depth, K(*job->parameters[9]));
    lanes_store(lists->p_gravity, K(*job->parameters[10]));
    lanes_store(lists->p_end_depth, K(*job->parameters[11]));
    lanes_store(lists->p_ring_restitution, K(*job->parameters[12]));
    lanes_store(lists->p_backboard_restitution, K(*job->parameters[13]));
    lanes_store(lists->p_bridge_restitution, K(*job->parameters[14]));
    lanes_store(lists->p_ring_friction, K(*job->parameters[15]));
    lanes_store(lists->p_backboard_friction, K(*job->parameters[16]));
    lanes_store(lists->p_bridge_friction, K(*job->parameters[17]));
    lanes_store(lists->p_tangential_restitution, K(*job->parameters[18]));
    lanes_store(lists->p_restitution_speed, K(*job->parameters[19]));
    const M all_permitted = LANES(court_permit)(lanes_load(lists->p_ball_radius), lanes_load(lists->p_ring_radius), lanes_load(lists->p_wire_radius), lanes_load(lists->p_board_distance), lanes_load(lists->p_board_half_width), lanes_load(lists->p_board_bottom), lanes_load(lists->p_board_top), lanes_load(lists->p_board_thickness), lanes_load(lists->p_bridge_half_width), lanes_load(lists->p_bridge_depth), lanes_load(lists->p_gravity), lanes_load(lists->p_end_depth), lanes_load(lists->p_ring_restitution), lanes_load(lists->p_backboard_restitution), lanes_load(lists->p_bridge_restitution), lanes_load(lists->p_ring_friction), lanes_load(lists->p_backboard_friction), lanes_load(lists->p_bridge_friction), lanes_load(lists->p_tangential_restitution), lanes_load(lists->p_restitution_speed));
    for (;;) {
        if (job->stop && *job->stop)
            return;
        if (begun == end && end < job->shots)
            begun = court_take(job, &end);
        int following = shots == 0;
        if (lists->waiting + LANES_WIDTH > LANES_SHOTS || (shots == 0 && begun == end)) {
            shots += LANES(court_plain_resume)(lists, shots, job);
            following = 0;
        }
        const size_t fresh = shots;
        if (begun < end && shots < LANES_SHOTS) {
            const size_t room = LANES_SHOTS - shots, left = end - begun;
            shots += left < room ? left : room;
            LANES(court_plain_begin)(lists, fresh, shots - fresh, job, begun);
            begun += shots - fresh;
        }
        if (shots == 0)
            return;

        /* A new shot is looked at once. */
        for (size_t i = fresh; i < shots; i += LANES_WIDTH) {
            V last = lanes_load(lists->last + i);
            const V p_backboard_friction = lanes_load(lists->p_backboard_friction + (i & varying));
            const V p_backboard_restitution = lanes_load(lists->p_backboard_restitution + (i & varying));
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_bottom = lanes_load(lists->p_board_bottom + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_board_half_width = lanes_load(lists->p_board_half_width + (i & varying));
            const V p_board_thickness = lanes_load(lists->p_board_thickness + (i & varying));
            const V p_board_top = lanes_load(lists->p_board_top + (i & varying));
            const V p_bridge_depth = lanes_load(lists->p_bridge_depth + (i & varying));
            const V p_bridge_friction = lanes_load(lists->p_bridge_friction + (i & varying));
            const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + (i & varying));
            const V p_bridge_restitution = lanes_load(lists->p_bridge_restitution + (i & varying));
            const V p_end_depth = lanes_load(lists->p_end_depth + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_restitution_speed = lanes_load(lists->p_restitution_speed + (i & varying));
            const V p_ring_friction = lanes_load(lists->p_ring_friction + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
            const V p_ring_restitution = lanes_load(lists->p_ring_restitution + (i & varying));
            const V p_tangential_restitution = lanes_load(lists->p_tangential_restitution + (i & varying));
            const V p_wire_radius = lanes_load(lists->p_wire_radius + (i & varying));
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V wx = lanes_load(lists->wx + i);
            V wy = lanes_load(lists->wy + i);
            V wz = lanes_load(lists->wz + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            M permitted = all_permitted;
            if (varying)
                permitted = LANES(court_permit)(p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_gravity, p_end_depth, p_ring_restitution, p_backboard_restitution, p_bridge_restitution, p_ring_friction, p_backboard_friction, p_bridge_friction, p_tangential_restitution, p_restitution_speed);
            const LANES(court_finite_state_out) _o1 =
                LANES(court_finite_state)(vx, vy, vz, wx, wy, wz, x, y, z);
            M finite = _o1.finite;
            const LANES(court_valid_out) _o2 =
                LANES(court_valid)(last, x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_end_depth);
            V valid = _o2.valid;
            const LANES(court_admitted_out) _o3 =
                LANES(court_admitted)(K(INFINITY), finite, permitted, valid);
            V outcome = _o3.outcome;
            const LANES(court_passing_start_out) _o4 =
                LANES(court_passing_start)(last, outcome, K(0.0), x, y, z, p_ring_radius, p_end_depth);
            V through = _o4.through;
            lanes_store(lists->outcome + i, outcome);
            lanes_store(lists->through + i, through);
        }

        M refused = lanes_nowhere();
        for (size_t i = fresh; i < shots; i += LANES_WIDTH)
            refused = lanes_either(refused, lanes_both(lanes_first(shots - i), lanes_at_most(K(0.0), lanes_load(lists->outcome + i))));
        if (lanes_any(refused)) {
            shots = LANES(court_plain_leave)(lists, fresh, shots, job);
            following = 0;
        }

        /* To the next event, and what it does to the ball. */
        {
        size_t open_shots = 0;
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            LANES(court_ahead)(job, begun + i, streams);
            V last = lanes_load(lists->last + i);
            V mode = lanes_load(lists->mode + i);
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_end_depth = lanes_load(lists->p_end_depth + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
            const V p_wire_radius = lanes_load(lists->p_wire_radius + (i & varying));
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const LANES(court_error_bounds_out) _o5 =
                LANES(court_error_bounds)(K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0));
            V time_error = _o5.time_error;
            const LANES(court_scale_out) _o6 =
                LANES(court_scale)(x, y, z, vx, vy, vz, p_gravity);
            V extent = _o6.extent;
            V speed = _o6.speed;
            V excess = _o6.excess;
            const LANES(court_opening_out) _o7 =
                LANES(court_opening)(excess, K(0.0), K(0.0));
            V when = _o7.when;
            V which = _o7.which;
            const LANES(court_limited_out) _o8 =
                LANES(court_limited)(time_limit);
            M limited = _o8.limited;
            const LANES(court_kept_out) _o9 =
                LANES(court_kept)(mode, when);
            M kept = _o9.kept;
            when = _o9.when;
            M rests = _o9.rests;
            M rolling = _o9.rolling;
            V began = _o9.began;
            const LANES(court_left_out) _o10 =
                LANES(court_left)(K(3.0), last);
            V leaving = _o10.leaving;
            const LANES(court_end_arrival_out) _o11 =
                LANES(court_end_arrival)(leaving, z, vz, p_gravity, p_end_depth);
            V time = _o11.time;
            V rate = _o11.rate;
            V bend = _o11.bend;
            V apex = _o11.apex;
            const LANES(court_meeting_plane_out) _o12 =
                LANES(court_meeting_plane)(apex, bend, rate, time);
            M arrives = _o12.arrives;
            const LANES(court_timely_out) _o13 =
                LANES(court_timely)(arrives, K(0.0), K(0.0), time, when);
            M possible = _o13.possible;
            const M _m14 = lanes_both(rows, possible);
            {
                const LANES(court_sooner_out) _o15 =
                    LANES(court_sooner)(arrives, K(3.0), time, when, which);
                when = lanes_select(_m14, _o15.when, when);
                which = lanes_select(_m14, _o15.which, which);
            }
            const LANES(court_horizon_out) _o16 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o16.horizon;
            const LANES(court_ring_clear_out) _o17 =
                LANES(court_ring_clear)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V clear = _o17.clear;
            const LANES(court_opens_in_flight_out) _o18 =
                LANES(court_opens_in_flight)(clear, kept);
            M open = _o18.open;
            lanes_store(lists->began + i, began);
            lanes_store(lists->extent + i, extent);
            lanes_store(lists->kept + i, lanes_select(kept, K(1.0), K(0.0)));
            lanes_store(lists->limited + i, lanes_select(limited, K(1.0), K(0.0)));
            lanes_store(lists->rests + i, lanes_select(rests, K(1.0), K(0.0)));
            lanes_store(lists->rolling + i, lanes_select(rolling, K(1.0), K(0.0)));
            lanes_store(lists->speed + i, speed);
            lanes_store(lists->time_error + i, time_error);
            lanes_store(lists->when + i, when);
            lanes_store(lists->which + i, which);
            const M packed = lanes_both(rows, open);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_row + open_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_extent + open_shots, packed, extent);
                lanes_pack(lists->open_last + open_shots, packed, last);
                if (varying)
                    lanes_pack(lists->open_p_ball_radius + open_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_p_gravity + open_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->open_p_ring_radius + open_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->open_p_wire_radius + open_shots, packed, p_wire_radius);
                lanes_pack(lists->open_speed + open_shots, packed, speed);
                lanes_pack(lists->open_until + open_shots, packed, until);
                lanes_pack(lists->open_vx + open_shots, packed, vx);
                lanes_pack(lists->open_vy + open_shots, packed, vy);
                lanes_pack(lists->open_vz + open_shots, packed, vz);
                lanes_pack(lists->open_when + open_shots, packed, when);
                lanes_pack(lists->open_which + open_shots, packed, which);
                lanes_pack(lists->open_x + open_shots, packed, x);
                lanes_pack(lists->open_y + open_shots, packed, y);
                lanes_pack(lists->open_z + open_shots, packed, z);
                open_shots += lanes_many(packed);
            }
        }
        {
        size_t open_leaping_shots = 0;
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_shots - i);
            V extent = lanes_load(lists->open_extent + i);
            V last = lanes_load(lists->open_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius);
            const V p_gravity = lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->open_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->open_p_wire_radius + i : lists->p_wire_radius);
            V speed = lanes_load(lists->open_speed + i);
            V until = lanes_load(lists->open_until + i);
            V vx = lanes_load(lists->open_vx + i);
            V vy = lanes_load(lists->open_vy + i);
            V vz = lanes_load(lists->open_vz + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(court_beginning_out) _o19 =
                LANES(court_beginning)();
            V share = _o19.share;
            V arrival = _o19.arrival;
            M certain = _o19.certain;
            const LANES(court_left_out) _o20 =
                LANES(court_left)(K(0.0), last);
            V leaving = _o20.leaving;
            const LANES(court_ring_opened_out) _o21 =
                LANES(court_ring_opened)(lanes_narrow(until), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
            S onset = _o21.t;
            S wide_end = _o21.end;
            M searching = _o21.searching;
            S wide_low1 = _o21.low1;
            S wide_high1 = _o21.high1;
            S wide_low2 = _o21.low2;
            S wide_high2 = _o21.high2;
            S lapsed = _o21.latest;
            M sound = _o21.sound;
            const LANES(court_opened_out) _o22 =
                LANES(court_opened)(lanes_wide(lapsed), lanes_wide(onset));
            V since = _o22.time;
            const LANES(court_ring_started_out) _o23 =
                LANES(court_ring_started)(x, y, z, vx, vy, vz, p_ring_radius);
            V rho_start = _o23.rho_start;
            V parting = _o23.parting;
            V drift = _o23.drift;
            const LANES(court_flight_out) _o24 =
                LANES(court_flight)(since, x, y, z, vx, vy, vz, p_gravity);
            V near_x = _o24.x;
            V near_y = _o24.y;
            V near_z = _o24.z;
            V near_vz = _o24.vz;
            const LANES(court_ring_grain_out) _o25 =
                LANES(court_ring_grain)(onset, wide_end, lanes_narrow(leaving), lapsed, lanes_narrow(near_x), lanes_narrow(near_y), lanes_narrow(near_z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(near_vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(parting), lanes_narrow(drift), wide_low1, wide_high1, wide_low2, wide_high2, lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
            S short_share = _o25.share;
            S short_t = _o25.t;
            S short_end = _o25.end;
            S short_x = _o25.x;
            S short_y = _o25.y;
            S short_z = _o25.z;
            S short_vx = _o25.vx;
            S short_vy = _o25.vy;
            S short_vz = _o25.vz;
            S short_steady = _o25.steady;
            S short_swing = _o25.swing;
            S short_rho_start = _o25.rho_start;
            S short_ceiling = _o25.ceiling;
            S short_flat = _o25.flat;
            S short_tilt = _o25.tilt;
            S short_jerk = _o25.jerk;
            S short_grit = _o25.grit;
            S short_parting = _o25.parting;
            S short_drift = _o25.drift;
            S short_rate_margin = _o25.rate_margin;
            S short_low1 = _o25.low1;
            S short_high1 = _o25.high1;
            S short_low2 = _o25.low2;
            S short_high2 = _o25.high2;
            M fits = _o25.fits;
            const LANES(court_coarse_out) _o26 =
                LANES(court_coarse)(lanes_wide(short_ceiling), fits, lanes_wide(short_flat), lanes_wide(short_rate_margin), searching, lanes_wide(short_share), sound);
            M leaping = _o26.leaping;
            searching = _o26.searching;
            M served = _o26.served;
            V ceiling = _o26.ceiling;
            V flat = _o26.flat;
            V tilt = _o26.tilt;
            const M _m27 = lanes_both(rows, leaping);
            if (lanes_any(_m27)) {
                const LANES(court_ring_leap_out) _o28 =
                    LANES(court_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
                short_t = singles_select(singles_of(_m27), _o28.t, short_t);
                short_end = singles_select(singles_of(_m27), _o28.end, short_end);
                certain = lanes_choose(_m27, _o28.certain, certain);
                leaping = lanes_choose(_m27, _o28.leaping, leaping);
            }
            lanes_store(lists->open_arrival + i, arrival);
            lanes_store(lists->open_ceiling + i, ceiling);
            lanes_store(lists->open_certain + i, lanes_select(certain, K(1.0), K(0.0)));
            lanes_store(lists->open_flat + i, flat);
            lanes_store(lists->open_rho_start + i, rho_start);
            lanes_store(lists->open_searching + i, lanes_select(searching, K(1.0), K(0.0)));
            lanes_store(lists->open_served + i, lanes_select(served, K(1.0), K(0.0)));
            lanes_store(lists->open_share + i, share);
            singles_store(lists->open_short_t + i, short_t);
            lanes_store(lists->open_since + i, since);
            lanes_store(lists->open_tilt + i, tilt);
            const M packed = lanes_both(rows, leaping);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_leaping_row + open_leaping_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                if (varying)
                    lanes_pack(lists->open_leaping_p_ball_radius + open_leaping_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_leaping_p_gravity + open_leaping_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->open_leaping_p_ring_radius + open_leaping_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->open_leaping_p_wire_radius + open_leaping_shots, packed, p_wire_radius);
                singles_pack(lists->open_leaping_short_ceiling + open_leaping_shots, packed, short_ceiling);
                singles_pack(lists->open_leaping_short_drift + open_leaping_shots, packed, short_drift);
                singles_pack(lists->open_leaping_short_end + open_leaping_shots, packed, short_end);
                singles_pack(lists->open_leaping_short_flat + open_leaping_shots, packed, short_flat);
                singles_pack(lists->open_leaping_short_grit + open_leaping_shots, packed, short_grit);
                singles_pack(lists->open_leaping_short_high1 + open_leaping_shots, packed, short_high1);
                singles_pack(lists->open_leaping_short_high2 + open_leaping_shots, packed, short_high2);
                singles_pack(lists->open_leaping_short_jerk + open_leaping_shots, packed, short_jerk);
                singles_pack(lists->open_leaping_short_low1 + open_leaping_shots, packed, short_low1);
                singles_pack(lists->open_leaping_short_low2 + open_leaping_shots, packed, short_low2);
                singles_pack(lists->open_leaping_short_parting + open_leaping_shots, packed, short_parting);
                singles_pack(lists->open_leaping_short_rate_margin + open_leaping_shots, packed, short_rate_margin);
                singles_pack(lists->open_leaping_short_rho_start + open_leaping_shots, packed, short_rho_start);
                singles_pack(lists->open_leaping_short_steady + open_leaping_shots, packed, short_steady);
                singles_pack(lists->open_leaping_short_swing + open_leaping_shots, packed, short_swing);
                singles_pack(lists->open_leaping_short_t + open_leaping_shots, packed, short_t);
                singles_pack(lists->open_leaping_short_tilt + open_leaping_shots, packed, short_tilt);
                singles_pack(lists->open_leaping_short_vx + open_leaping_shots, packed, short_vx);
                singles_pack(lists->open_leaping_short_vy + open_leaping_shots, packed, short_vy);
                singles_pack(lists->open_leaping_short_vz + open_leaping_shots, packed, short_vz);
                singles_pack(lists->open_leaping_short_x + open_leaping_shots, packed, short_x);
                singles_pack(lists->open_leaping_short_y + open_leaping_shots, packed, short_y);
                singles_pack(lists->open_leaping_short_z + open_leaping_shots, packed, short_z);
                open_leaping_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
            V p_ball_radius = lanes_load(lists->p_ball_radius);
            V p_gravity = lanes_load(lists->p_gravity);
            V p_ring_radius = lanes_load(lists->p_ring_radius);
            V p_wire_radius = lanes_load(lists->p_wire_radius);
            S short_ceiling = KS(0.0);
            S short_drift = KS(0.0);
            S short_end = KS(0.0);
            S short_flat = KS(0.0);
            S short_grit = KS(0.0);
            S short_high1 = KS(0.0);
            S short_high2 = KS(0.0);
            S short_jerk = KS(0.0);
            S short_low1 = KS(0.0);
            S short_low2 = KS(0.0);
            S short_parting = KS(0.0);
            S short_rate_margin = KS(0.0);
            S short_rho_start = KS(0.0);
            S short_steady = KS(0.0);
            S short_swing = KS(0.0);
            S short_t = KS(0.0);
            S short_tilt = KS(0.0);
            S short_vx = KS(0.0);
            S short_vy = KS(0.0);
            S short_vz = KS(0.0);
            S short_x = KS(0.0);
            S short_y = KS(0.0);
            S short_z = KS(0.0);
            for (;;) {
                if (taken < open_leaping_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->open_leaping_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    short_ceiling = singles_expand(lists->open_leaping_short_ceiling + taken, idle, short_ceiling);
                    short_drift = singles_expand(lists->open_leaping_short_drift + taken, idle, short_drift);
                    short_end = singles_expand(lists->open_leaping_short_end + taken, idle, short_end);
                    short_flat = singles_expand(lists->open_leaping_short_flat + taken, idle, short_flat);
                    short_grit = singles_expand(lists->open_leaping_short_grit + taken, idle, short_grit);
                    short_high1 = singles_expand(lists->open_leaping_short_high1 + taken, idle, short_high1);
                    short_high2 = singles_expand(lists->open_leaping_short_high2 + taken, idle, short_high2);
                    short_jerk = singles_expand(lists->open_leaping_short_jerk + taken, idle, short_jerk);
                    short_low1 = singles_expand(lists->open_leaping_short_low1 + taken, idle, short_low1);
                    short_low2 = singles_expand(lists->open_leaping_short_low2 + taken, idle, short_low2);
                    short_parting = singles_expand(lists->open_leaping_short_parting + taken, idle, short_parting);
                    short_rate_margin = singles_expand(lists->open_leaping_short_rate_margin + taken, idle, short_rate_margin);
                    short_rho_start = singles_expand(lists->open_leaping_short_rho_start + taken, idle, short_rho_start);
                    short_steady = singles_expand(lists->open_leaping_short_steady + taken, idle, short_steady);
                    short_swing = singles_expand(lists->open_leaping_short_swing + taken, idle, short_swing);
                    short_t = singles_expand(lists->open_leaping_short_t + taken, idle, short_t);
                    short_tilt = singles_expand(lists->open_leaping_short_tilt + taken, idle, short_tilt);
                    short_vx = singles_expand(lists->open_leaping_short_vx + taken, idle, short_vx);
                    short_vy = singles_expand(lists->open_leaping_short_vy + taken, idle, short_vy);
                    short_vz = singles_expand(lists->open_leaping_short_vz + taken, idle, short_vz);
                    short_x = singles_expand(lists->open_leaping_short_x + taken, idle, short_x);
                    short_y = singles_expand(lists->open_leaping_short_y + taken, idle, short_y);
                    short_z = singles_expand(lists->open_leaping_short_z + taken, idle, short_z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->open_leaping_p_ball_radius + taken, idle, p_ball_radius);
                        p_gravity = lanes_expand(lists->open_leaping_p_gravity + taken, idle, p_gravity);
                        p_ring_radius = lanes_expand(lists->open_leaping_p_ring_radius + taken, idle, p_ring_radius);
                        p_wire_radius = lanes_expand(lists->open_leaping_p_wire_radius + taken, idle, p_wire_radius);
                    }
                    const size_t room = LANES_WIDTH - busy, left = open_leaping_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M leaping = active;
                const LANES(court_ring_leap_out) _o29 =
                    LANES(court_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
                short_t = _o29.t;
                short_end = _o29.end;
                M certain = _o29.certain;
                leaping = _o29.leaping;
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(leaping, lanes_less(turns, K(24.0)))));
                if (lanes_any(ended)) {
                    double ended_row[LANES_WIDTH];
                    lanes_store(ended_row, row);
                    double ended_certain[LANES_WIDTH];
                    lanes_store(ended_certain, lanes_select(certain, K(1.0), K(0.0)));
                    float ended_short_t[LANES_WIDTH];
                    singles_store(ended_short_t, short_t);
                    for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                        const int lane = LANES_LOWEST(bits);
                        const size_t k = (size_t)ended_row[lane];
                        lists->open_certain[k] = ended_certain[lane];
                        lists->open_short_t[k] = ended_short_t[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        {
        size_t open_searching_shots = 0;
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_shots - i);
            V arrival = lanes_load(lists->open_arrival + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_certain + i));
            V extent = lanes_load(lists->open_extent + i);
            V last = lanes_load(lists->open_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius);
            const V p_gravity = lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->open_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->open_p_wire_radius + i : lists->p_wire_radius);
            M searching = lanes_less(K(0.0), lanes_load(lists->open_searching + i));
            M served = lanes_less(K(0.0), lanes_load(lists->open_served + i));
            V share = lanes_load(lists->open_share + i);
            S short_t = singles_load(lists->open_short_t + i);
            V since = lanes_load(lists->open_since + i);
            V speed = lanes_load(lists->open_speed + i);
            V until = lanes_load(lists->open_until + i);
            V vx = lanes_load(lists->open_vx + i);
            V vy = lanes_load(lists->open_vy + i);
            V vz = lanes_load(lists->open_vz + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(court_leapt_out) _o30 =
                LANES(court_leapt)(arrival, certain, lanes_wide(short_t), searching, served, since);
            arrival = _o30.arrival;
            V t = _o30.t;
            searching = _o30.searching;
            lanes_store(lists->open_arrival + i, arrival);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_searching_row + open_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_searching_arrival + open_searching_shots, packed, arrival);
                lanes_pack(lists->open_searching_certain + open_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->open_searching_extent + open_searching_shots, packed, extent);
                lanes_pack(lists->open_searching_last + open_searching_shots, packed, last);
                if (varying)
                    lanes_pack(lists->open_searching_p_ball_radius + open_searching_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_searching_p_gravity + open_searching_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->open_searching_p_ring_radius + open_searching_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->open_searching_p_wire_radius + open_searching_shots, packed, p_wire_radius);
                lanes_pack(lists->open_searching_share + open_searching_shots, packed, share);
                lanes_pack(lists->open_searching_speed + open_searching_shots, packed, speed);
                lanes_pack(lists->open_searching_t + open_searching_shots, packed, t);
                lanes_pack(lists->open_searching_until + open_searching_shots, packed, until);
                lanes_pack(lists->open_searching_vx + open_searching_shots, packed, vx);
                lanes_pack(lists->open_searching_vy + open_searching_shots, packed, vy);
                lanes_pack(lists->open_searching_vz + open_searching_shots, packed, vz);
                lanes_pack(lists->open_searching_x + open_searching_shots, packed, x);
                lanes_pack(lists->open_searching_y + open_searching_shots, packed, y);
                lanes_pack(lists->open_searching_z + open_searching_shots, packed, z);
                open_searching_shots += lanes_many(packed);
            }
        }
        {
        size_t open_searching_searching_shots = 0;
        for (size_t i = 0; i < open_searching_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_searching_shots - i);
            V arrival = lanes_load(lists->open_searching_arrival + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_searching_certain + i));
            V extent = lanes_load(lists->open_searching_extent + i);
            V last = lanes_load(lists->open_searching_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_searching_p_ball_radius + i : lists->p_ball_radius);
            const V p_gravity = lanes_load(varying ? lists->open_searching_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->open_searching_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->open_searching_p_wire_radius + i : lists->p_wire_radius);
            V share = lanes_load(lists->open_searching_share + i);
            V speed = lanes_load(lists->open_searching_speed + i);
            V t = lanes_load(lists->open_searching_t + i);
            V until = lanes_load(lists->open_searching_until + i);
            V vx = lanes_load(lists->open_searching_vx + i);
            V vy = lanes_load(lists->open_searching_vy + i);
            V vz = lanes_load(lists->open_searching_vz + i);
            V x = lanes_load(lists->open_searching_x + i);
            V y = lanes_load(lists->open_searching_y + i);
            V z = lanes_load(lists->open_searching_z + i);
            const LANES(court_ring_prepare_out) _o31 =
                LANES(court_ring_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V steady = _o31.steady;
            V swing = _o31.swing;
            V rho_start = _o31.rho_start;
            V low0 = _o31.low0;
            V high0 = _o31.high0;
            V low1 = _o31.low1;
            V high1 = _o31.high1;
            V low2 = _o31.low2;
            V high2 = _o31.high2;
            V ceiling = _o31.ceiling;
            V latest = _o31.latest;
            const LANES(court_allowance_out) _o32 =
                LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
            V position_level = _o32.position_level;
            V velocity_level = _o32.velocity_level;
            const LANES(court_ring_margins_out) _o33 =
                LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V flat = _o33.margin;
            V tilt = _o33.leaving_margin;
            V rate_slack = _o33.rate_margin;
            const LANES(court_ring_enter_out) _o34 =
                LANES(court_ring_enter)(t, K(0.0), high0, high1, high2, low0, low1, low2, t);
            t = _o34.t;
            V end = _o34.end;
            M searching = _o34.searching;
            lanes_store(lists->open_searching_ceiling + i, ceiling);
            lanes_store(lists->open_searching_flat + i, flat);
            lanes_store(lists->open_searching_rho_start + i, rho_start);
            lanes_store(lists->open_searching_tilt + i, tilt);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_searching_searching_row + open_searching_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_searching_searching_arrival + open_searching_searching_shots, packed, arrival);
                lanes_pack(lists->open_searching_searching_ceiling + open_searching_searching_shots, packed, ceiling);
                lanes_pack(lists->open_searching_searching_certain + open_searching_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->open_searching_searching_end + open_searching_searching_shots, packed, end);
                lanes_pack(lists->open_searching_searching_extent + open_searching_searching_shots, packed, extent);
                lanes_pack(lists->open_searching_searching_flat + open_searching_searching_shots, packed, flat);
                lanes_pack(lists->open_searching_searching_high0 + open_searching_searching_shots, packed, high0);
                lanes_pack(lists->open_searching_searching_high1 + open_searching_searching_shots, packed, high1);
                lanes_pack(lists->open_searching_searching_high2 + open_searching_searching_shots, packed, high2);
                lanes_pack(lists->open_searching_searching_last + open_searching_searching_shots, packed, last);
                lanes_pack(lists->open_searching_searching_latest + open_searching_searching_shots, packed, latest);
                lanes_pack(lists->open_searching_searching_low0 + open_searching_searching_shots, packed, low0);
                lanes_pack(lists->open_searching_searching_low1 + open_searching_searching_shots, packed, low1);
                lanes_pack(lists->open_searching_searching_low2 + open_searching_searching_shots, packed, low2);
                if (varying)
                    lanes_pack(lists->open_searching_searching_p_ball_radius + open_searching_searching_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_searching_searching_p_gravity + open_searching_searching_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->open_searching_searching_p_ring_radius + open_searching_searching_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->open_searching_searching_p_wire_radius + open_searching_searching_shots, packed, p_wire_radius);
                lanes_pack(lists->open_searching_searching_rate_slack + open_searching_searching_shots, packed, rate_slack);
                lanes_pack(lists->open_searching_searching_rho_start + open_searching_searching_shots, packed, rho_start);
                lanes_pack(lists->open_searching_searching_share + open_searching_searching_shots, packed, share);
                lanes_pack(lists->open_searching_searching_speed + open_searching_searching_shots, packed, speed);
                lanes_pack(lists->open_searching_searching_steady + open_searching_searching_shots, packed, steady);
                lanes_pack(lists->open_searching_searching_swing + open_searching_searching_shots, packed, swing);
                lanes_pack(lists->open_searching_searching_t + open_searching_searching_shots, packed, t);
                lanes_pack(lists->open_searching_searching_tilt + open_searching_searching_shots, packed, tilt);
                lanes_pack(lists->open_searching_searching_vx + open_searching_searching_shots, packed, vx);
                lanes_pack(lists->open_searching_searching_vy + open_searching_searching_shots, packed, vy);
                lanes_pack(lists->open_searching_searching_vz + open_searching_searching_shots, packed, vz);
                lanes_pack(lists->open_searching_searching_x + open_searching_searching_shots, packed, x);
                lanes_pack(lists->open_searching_searching_y + open_searching_searching_shots, packed, y);
                lanes_pack(lists->open_searching_searching_z + open_searching_searching_shots, packed, z);
                open_searching_searching_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
            V p_ball_radius = lanes_load(lists->p_ball_radius);
            V p_gravity = lanes_load(lists->p_gravity);
            V p_ring_radius = lanes_load(lists->p_ring_radius);
            V p_wire_radius = lanes_load(lists->p_wire_radius);
            V arrival = K(0.0);
            V ceiling = K(0.0);
            M certain = lanes_nowhere();
            V end = K(0.0);
            V extent = K(0.0);
            V flat = K(0.0);
            V high0 = K(0.0);
            V high1 = K(0.0);
            V high2 = K(0.0);
            V last = K(0.0);
            V latest = K(0.0);
            V low0 = K(0.0);
            V low1 = K(0.0);
            V low2 = K(0.0);
            V rate_slack = K(0.0);
            V rho_start = K(0.0);
            V share = K(0.0);
            V speed = K(0.0);
            V steady = K(0.0);
            V swing = K(0.0);
            V t = K(0.0);
            V tilt = K(0.0);
            V vx = K(0.0);
            V vy = K(0.0);
            V vz = K(0.0);
            V x = K(0.0);
            V y = K(0.0);
            V z = K(0.0);
            for (;;) {
                if (taken < open_searching_searching_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->open_searching_searching_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->open_searching_searching_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->open_searching_searching_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->open_searching_searching_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    end = lanes_expand(lists->open_searching_searching_end + taken, idle, end);
                    extent = lanes_expand(lists->open_searching_searching_extent + taken, idle, extent);
                    flat = lanes_expand(lists->open_searching_searching_flat + taken, idle, flat);
                    high0 = lanes_expand(lists->open_searching_searching_high0 + taken, idle, high0);
                    high1 = lanes_expand(lists->open_searching_searching_high1 + taken, idle, high1);
                    high2 = lanes_expand(lists->open_searching_searching_high2 + taken, idle, high2);
                    last = lanes_expand(lists->open_searching_searching_last + taken, idle, last);
                    latest = lanes_expand(lists->open_searching_searching_latest + taken, idle, latest);
                    low0 = lanes_expand(lists->open_searching_searching_low0 + taken, idle, low0);
                    low1 = lanes_expand(lists->open_searching_searching_low1 + taken, idle, low1);
                    low2 = lanes_expand(lists->open_searching_searching_low2 + taken, idle, low2);
                    rate_slack = lanes_expand(lists->open_searching_searching_rate_slack + taken, idle, rate_slack);
                    rho_start = lanes_expand(lists->open_searching_searching_rho_start + taken, idle, rho_start);
                    share = lanes_expand(lists->open_searching_searching_share + taken, idle, share);
                    speed = lanes_expand(lists->open_searching_searching_speed + taken, idle, speed);
                    steady = lanes_expand(lists->open_searching_searching_steady + taken, idle, steady);
                    swing = lanes_expand(lists->open_searching_searching_swing + taken, idle, swing);
                    t = lanes_expand(lists->open_searching_searching_t + taken, idle, t);
                    tilt = lanes_expand(lists->open_searching_searching_tilt + taken, idle, tilt);
                    vx = lanes_expand(lists->open_searching_searching_vx + taken, idle, vx);
                    vy = lanes_expand(lists->open_searching_searching_vy + taken, idle, vy);
                    vz = lanes_expand(lists->open_searching_searching_vz + taken, idle, vz);
                    x = lanes_expand(lists->open_searching_searching_x + taken, idle, x);
                    y = lanes_expand(lists->open_searching_searching_y + taken, idle, y);
                    z = lanes_expand(lists->open_searching_searching_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->open_searching_searching_p_ball_radius + taken, idle, p_ball_radius);
                        p_gravity = lanes_expand(lists->open_searching_searching_p_gravity + taken, idle, p_gravity);
                        p_ring_radius = lanes_expand(lists->open_searching_searching_p_ring_radius + taken, idle, p_ring_radius);
                        p_wire_radius = lanes_expand(lists->open_searching_searching_p_wire_radius + taken, idle, p_wire_radius);
                    }
                    const size_t room = LANES_WIDTH - busy, left = open_searching_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o35 =
                    LANES(court_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = _o35.leaving;
                V margin = _o35.margin;
                const LANES(court_ring_advance_out) _o36 =
                    LANES(court_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V gap = _o36.gap;
                V rate = _o36.rate;
                V bend = _o36.bend;
                V step = _o36.step;
                V next = _o36.next;
                V clearance = _o36.clearance;
                const LANES(court_struck_out) _o37 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o37.hit;
                M sure = _o37.sure;
                M vague = _o37.vague;
                const M _m38 = lanes_both(active, vague);
                if (lanes_any(_m38)) {
                    const LANES(court_finer_out) _o39 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m38, _o39.share, share);
                    const LANES(court_allowance_out) _o40 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
                    V position_level = _o40.position_level;
                    V velocity_level = _o40.velocity_level;
                    const LANES(court_ring_margins_out) _o41 =
                        LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    flat = lanes_select(_m38, _o41.margin, flat);
                    tilt = lanes_select(_m38, _o41.leaving_margin, tilt);
                    rate_slack = lanes_select(_m38, _o41.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o42 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o42.arrival;
                certain = _o42.certain;
                M exhausted = _o42.exhausted;
                searching = _o42.searching;
                t = _o42.t;
                const M _m43 = lanes_both(active, exhausted);
                {
                    const LANES(court_ring_enter_out) _o44 =
                        LANES(court_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m43, _o44.t, t);
                    end = lanes_select(_m43, _o44.end, end);
                    searching = lanes_choose(_m43, _o44.searching, searching);
                }
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(searching, lanes_less(turns, K(201.0)))));
                if (lanes_any(ended)) {
                    double ended_row[LANES_WIDTH];
                    lanes_store(ended_row, row);
                    double ended_arrival[LANES_WIDTH];
                    lanes_store(ended_arrival, arrival);
                    double ended_certain[LANES_WIDTH];
                    lanes_store(ended_certain, lanes_select(certain, K(1.0), K(0.0)));
                    double ended_flat[LANES_WIDTH];
                    lanes_store(ended_flat, flat);
                    double ended_tilt[LANES_WIDTH];
                    lanes_store(ended_tilt, tilt);
                    for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                        const int lane = LANES_LOWEST(bits);
                        const size_t k = (size_t)ended_row[lane];
                        lists->open_searching_arrival[k] = ended_arrival[lane];
                        lists->open_searching_certain[k] = ended_certain[lane];
                        lists->open_searching_flat[k] = ended_flat[lane];
                        lists->open_searching_tilt[k] = ended_tilt[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        for (size_t k = 0; k < open_searching_shots; k++) {
            const size_t row = (size_t)lists->open_searching_row[k];
            lists->open_arrival[row] = lists->open_searching_arrival[k];
            lists->open_ceiling[row] = lists->open_searching_ceiling[k];
            lists->open_certain[row] = lists->open_searching_certain[k];
            lists->open_flat[row] = lists->open_searching_flat[k];
            lists->open_rho_start[row] = lists->open_searching_rho_start[k];
            lists->open_tilt[row] = lists->open_searching_tilt[k];
        }
        }
        {
        size_t open_refining_shots = 0;
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_shots - i);
            V arrival = lanes_load(lists->open_arrival + i);
            V ceiling = lanes_load(lists->open_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_certain + i));
            V flat = lanes_load(lists->open_flat + i);
            V last = lanes_load(lists->open_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius);
            const V p_gravity = lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->open_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->open_p_wire_radius + i : lists->p_wire_radius);
            V rho_start = lanes_load(lists->open_rho_start + i);
            V tilt = lanes_load(lists->open_tilt + i);
            V vx = lanes_load(lists->open_vx + i);
            V vy = lanes_load(lists->open_vy + i);
            V vz = lanes_load(lists->open_vz + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(court_found_out) _o45 =
                LANES(court_found)(arrival);
            M arrives = _o45.arrives;
            M refining = _o45.refining;
            const LANES(court_nearby_out) _o46 =
                LANES(court_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o46.leaving;
            const M _m47 = lanes_both(rows, refining);
            if (lanes_any(_m47)) {
                const LANES(court_ring_refine_out) _o48 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V refined = _o48.time;
                V gap = _o48.gap;
                V rate = _o48.rate;
                const LANES(court_polished_out) _o49 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m47, _o49.arrival, arrival);
                refining = lanes_choose(_m47, _o49.refining, refining);
            }
            const M _m50 = lanes_both(rows, refining);
            if (lanes_any(_m50)) {
                const LANES(court_ring_refine_out) _o51 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V refined = _o51.time;
                V gap = _o51.gap;
                V rate = _o51.rate;
                const LANES(court_polished_out) _o52 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m50, _o52.arrival, arrival);
                refining = lanes_choose(_m50, _o52.refining, refining);
            }
            lanes_store(lists->open_arrival + i, arrival);
            lanes_store(lists->open_arrives + i, lanes_select(arrives, K(1.0), K(0.0)));
            const M packed = lanes_both(rows, refining);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_refining_row + open_refining_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_refining_arrival + open_refining_shots, packed, arrival);
                lanes_pack(lists->open_refining_ceiling + open_refining_shots, packed, ceiling);
                lanes_pack(lists->open_refining_certain + open_refining_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->open_refining_leaving + open_refining_shots, packed, leaving);
                if (varying)
                    lanes_pack(lists->open_refining_p_ball_radius + open_refining_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_refining_p_gravity + open_refining_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->open_refining_p_ring_radius + open_refining_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->open_refining_p_wire_radius + open_refining_shots, packed, p_wire_radius);
                lanes_pack(lists->open_refining_rho_start + open_refining_shots, packed, rho_start);
                lanes_pack(lists->open_refining_vx + open_refining_shots, packed, vx);
                lanes_pack(lists->open_refining_vy + open_refining_shots, packed, vy);
                lanes_pack(lists->open_refining_vz + open_refining_shots, packed, vz);
                lanes_pack(lists->open_refining_x + open_refining_shots, packed, x);
                lanes_pack(lists->open_refining_y + open_refining_shots, packed, y);
                lanes_pack(lists->open_refining_z + open_refining_shots, packed, z);
                open_refining_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
            V p_ball_radius = lanes_load(lists->p_ball_radius);
            V p_gravity = lanes_load(lists->p_gravity);
            V p_ring_radius = lanes_load(lists->p_ring_radius);
            V p_wire_radius = lanes_load(lists->p_wire_radius);
            V arrival = K(0.0);
            V ceiling = K(0.0);
            M certain = lanes_nowhere();
            V leaving = K(0.0);
            V rho_start = K(0.0);
            V vx = K(0.0);
            V vy = K(0.0);
            V vz = K(0.0);
            V x = K(0.0);
            V y = K(0.0);
            V z = K(0.0);
            for (;;) {
                if (taken < open_refining_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->open_refining_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->open_refining_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->open_refining_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->open_refining_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    leaving = lanes_expand(lists->open_refining_leaving + taken, idle, leaving);
                    rho_start = lanes_expand(lists->open_refining_rho_start + taken, idle, rho_start);
                    vx = lanes_expand(lists->open_refining_vx + taken, idle, vx);
                    vy = lanes_expand(lists->open_refining_vy + taken, idle, vy);
                    vz = lanes_expand(lists->open_refining_vz + taken, idle, vz);
                    x = lanes_expand(lists->open_refining_x + taken, idle, x);
                    y = lanes_expand(lists->open_refining_y + taken, idle, y);
                    z = lanes_expand(lists->open_refining_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->open_refining_p_ball_radius + taken, idle, p_ball_radius);
                        p_gravity = lanes_expand(lists->open_refining_p_gravity + taken, idle, p_gravity);
                        p_ring_radius = lanes_expand(lists->open_refining_p_ring_radius + taken, idle, p_ring_radius);
                        p_wire_radius = lanes_expand(lists->open_refining_p_wire_radius + taken, idle, p_wire_radius);
                    }
                    const size_t room = LANES_WIDTH - busy, left = open_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_ring_refine_out) _o53 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V refined = _o53.time;
                V gap = _o53.gap;
                V rate = _o53.rate;
                const LANES(court_polished_out) _o54 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o54.arrival;
                refining = _o54.refining;
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(refining, lanes_less(turns, K(8.0)))));
                if (lanes_any(ended)) {
                    double ended_row[LANES_WIDTH];
                    lanes_store(ended_row, row);
                    double ended_arrival[LANES_WIDTH];
                    lanes_store(ended_arrival, arrival);
                    for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                        const int lane = LANES_LOWEST(bits);
                        const size_t k = (size_t)ended_row[lane];
                        lists->open_arrival[k] = ended_arrival[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            V arrival = lanes_load(lists->open_arrival + i);
            M arrives = lanes_less(K(0.0), lanes_load(lists->open_arrives + i));
            V when = lanes_load(lists->open_when + i);
            V which = lanes_load(lists->open_which + i);
            const LANES(court_landed_out) _o55 =
                LANES(court_landed)(arrival);
            V time = _o55.time;
            const LANES(court_sooner_out) _o56 =
                LANES(court_sooner)(arrives, K(0.0), time, when, which);
            when = _o56.when;
            which = _o56.which;
            lanes_store(lists->open_when + i, when);
            lanes_store(lists->open_which + i, which);
        }
        for (size_t k = 0; k < open_shots; k++) {
            const size_t row = (size_t)lists->open_row[k];
            lists->when[row] = lists->open_when[k];
            lists->which[row] = lists->open_which[k];
        }
        }
        {
        size_t reachable_shots = 0;
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            V extent = lanes_load(lists->extent + i);
            M kept = lanes_less(K(0.0), lanes_load(lists->kept + i));
            V last = lanes_load(lists->last + i);
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_bottom = lanes_load(lists->p_board_bottom + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_board_half_width = lanes_load(lists->p_board_half_width + (i & varying));
            const V p_board_thickness = lanes_load(lists->p_board_thickness + (i & varying));
            const V p_board_top = lanes_load(lists->p_board_top + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            V speed = lanes_load(lists->speed + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V when = lanes_load(lists->when + i);
            V which = lanes_load(lists->which + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const LANES(court_horizon_out) _o57 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o57.horizon;
            V pad = _o57.pad;
            const LANES(court_halved_out) _o58 =
                LANES(court_halved)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), K(0.0), pad, p_gravity);
            V middle_x = _o58.middle_x;
            V reach_x = _o58.reach_x;
            V later_middle_x = _o58.later_middle_x;
            V later_reach_x = _o58.later_reach_x;
            V middle_y = _o58.middle_y;
            V reach_y = _o58.reach_y;
            V later_middle_y = _o58.later_middle_y;
            V later_reach_y = _o58.later_reach_y;
            V middle_z = _o58.middle_z;
            V reach_z = _o58.reach_z;
            V later_middle_z = _o58.later_middle_z;
            V later_reach_z = _o58.later_reach_z;
            const LANES(court_backboard_near_out) _o59 =
                LANES(court_backboard_near)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, later_middle_x, later_middle_y, later_middle_z, later_reach_x, later_reach_y, later_reach_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
            M reachable = _o59.near;
            const LANES(court_reachable_in_flight_out) _o60 =
                LANES(court_reachable_in_flight)(kept, reachable);
            reachable = _o60.reachable;
            const M packed = lanes_both(rows, reachable);
            if (lanes_any(packed)) {
                lanes_pack(lists->reachable_row + reachable_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->reachable_extent + reachable_shots, packed, extent);
                lanes_pack(lists->reachable_last + reachable_shots, packed, last);
                if (varying)
                    lanes_pack(lists->reachable_p_ball_radius + reachable_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->reachable_p_board_bottom + reachable_shots, packed, p_board_bottom);
                if (varying)
                    lanes_pack(lists->reachable_p_board_distance + reachable_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->reachable_p_board_half_width + reachable_shots, packed, p_board_half_width);
                if (varying)
                    lanes_pack(lists->reachable_p_board_thickness + reachable_shots, packed, p_board_thickness);
                if (varying)
                    lanes_pack(lists->reachable_p_board_top + reachable_shots, packed, p_board_top);
                if (varying)
                    lanes_pack(lists->reachable_p_gravity + reachable_shots, packed, p_gravity);
                lanes_pack(lists->reachable_speed + reachable_shots, packed, speed);
                lanes_pack(lists->reachable_vx + reachable_shots, packed, vx);
                lanes_pack(lists->reachable_vy + reachable_shots, packed, vy);
                lanes_pack(lists->reachable_vz + reachable_shots, packed, vz);
                lanes_pack(lists->reachable_when + reachable_shots, packed, when);
                lanes_pack(lists->reachable_which + reachable_shots, packed, which);
                lanes_pack(lists->reachable_x + reachable_shots, packed, x);
                lanes_pack(lists->reachable_y + reachable_shots, packed, y);
                lanes_pack(lists->reachable_z + reachable_shots, packed, z);
                reachable_shots += lanes_many(packed);
            }
        }
        {
        size_t reachable_searching_shots = 0;
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(reachable_shots - i);
            V extent = lanes_load(lists->reachable_extent + i);
            V last = lanes_load(lists->reachable_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_bottom = lanes_load(varying ? lists->reachable_p_board_bottom + i : lists->p_board_bottom);
            const V p_board_distance = lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance);
            const V p_board_half_width = lanes_load(varying ? lists->reachable_p_board_half_width + i : lists->p_board_half_width);
            const V p_board_thickness = lanes_load(varying ? lists->reachable_p_board_thickness + i : lists->p_board_thickness);
            const V p_board_top = lanes_load(varying ? lists->reachable_p_board_top + i : lists->p_board_top);
            const V p_gravity = lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity);
            V speed = lanes_load(lists->reachable_speed + i);
            V vx = lanes_load(lists->reachable_vx + i);
            V vy = lanes_load(lists->reachable_vy + i);
            V vz = lanes_load(lists->reachable_vz + i);
            V when = lanes_load(lists->reachable_when + i);
            V x = lanes_load(lists->reachable_x + i);
            V y = lanes_load(lists->reachable_y + i);
            V z = lanes_load(lists->reachable_z + i);
            const LANES(court_horizon_out) _o61 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o61.horizon;
            const LANES(court_backboard_prepare_out) _o62 =
                LANES(court_backboard_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V low0 = _o62.low0;
            V high0 = _o62.high0;
            V low1 = _o62.low1;
            V high1 = _o62.high1;
            V ceiling = _o62.ceiling;
            V latest = _o62.latest;
            const LANES(court_beginning_out) _o63 =
                LANES(court_beginning)();
            V share = _o63.share;
            V arrival = _o63.arrival;
            M certain = _o63.certain;
            const LANES(court_allowance_out) _o64 =
                LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
            V position_level = _o64.position_level;
            V velocity_level = _o64.velocity_level;
            const LANES(court_backboard_margins_out) _o65 =
                LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V flat = _o65.margin;
            V tilt = _o65.leaving_margin;
            V rate_slack = _o65.rate_margin;
            const LANES(court_backboard_enter_out) _o66 =
                LANES(court_backboard_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o66.t;
            V end = _o66.end;
            M searching = _o66.searching;
            const M _m67 = lanes_both(rows, searching);
            if (lanes_any(_m67)) {
                const LANES(court_nearby_out) _o68 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o68.leaving;
                V margin = _o68.margin;
                const LANES(court_backboard_advance_out) _o69 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V gap = _o69.gap;
                V rate = _o69.rate;
                V bend = _o69.bend;
                V step = _o69.step;
                V next = _o69.next;
                V clearance = _o69.clearance;
                const LANES(court_struck_or_still_out) _o70 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o70.hit;
                M sure = _o70.sure;
                M vague = _o70.vague;
                const M _m71 = lanes_both(_m67, vague);
                if (lanes_any(_m71)) {
                    const LANES(court_finer_out) _o72 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m71, _o72.share, share);
                    const LANES(court_allowance_out) _o73 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
                    V position_level = _o73.position_level;
                    V velocity_level = _o73.velocity_level;
                    const LANES(court_backboard_margins_out) _o74 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                    flat = lanes_select(_m71, _o74.margin, flat);
                    tilt = lanes_select(_m71, _o74.leaving_margin, tilt);
                    rate_slack = lanes_select(_m71, _o74.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o75 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = lanes_select(_m67, _o75.arrival, arrival);
                certain = lanes_choose(_m67, _o75.certain, certain);
                M exhausted = _o75.exhausted;
                searching = lanes_choose(_m67, _o75.searching, searching);
                t = lanes_select(_m67, _o75.t, t);
                const M _m76 = lanes_both(_m67, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o77 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m76, _o77.t, t);
                    end = lanes_select(_m76, _o77.end, end);
                    searching = lanes_choose(_m76, _o77.searching, searching);
                }
            }
            lanes_store(lists->reachable_arrival + i, arrival);
            lanes_store(lists->reachable_ceiling + i, ceiling);
            lanes_store(lists->reachable_certain + i, lanes_select(certain, K(1.0), K(0.0)));
            lanes_store(lists->reachable_flat + i, flat);
            lanes_store(lists->reachable_tilt + i, tilt);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->reachable_searching_row + reachable_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->reachable_searching_arrival + reachable_searching_shots, packed, arrival);
                lanes_pack(lists->reachable_searching_ceiling + reachable_searching_shots, packed, ceiling);
                lanes_pack(lists->reachable_searching_certain + reachable_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->reachable_searching_end + reachable_searching_shots, packed, end);
                lanes_pack(lists->reachable_searching_extent + reachable_searching_shots, packed, extent);
                lanes_pack(lists->reachable_searching_flat + reachable_searching_shots, packed, flat);
                lanes_pack(lists->reachable_searching_high0 + reachable_searching_shots, packed, high0);
                lanes_pack(lists->reachable_searching_high1 + reachable_searching_shots, packed, high1);
                lanes_pack(lists->reachable_searching_last + reachable_searching_shots, packed, last);
                lanes_pack(lists->reachable_searching_latest + reachable_searching_shots, packed, latest);
                lanes_pack(lists->reachable_searching_low0 + reachable_searching_shots, packed, low0);
                lanes_pack(lists->reachable_searching_low1 + reachable_searching_shots, packed, low1);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_ball_radius + reachable_searching_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_board_bottom + reachable_searching_shots, packed, p_board_bottom);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_board_distance + reachable_searching_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_board_half_width + reachable_searching_shots, packed, p_board_half_width);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_board_thickness + reachable_searching_shots, packed, p_board_thickness);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_board_top + reachable_searching_shots, packed, p_board_top);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_gravity + reachable_searching_shots, packed, p_gravity);
                lanes_pack(lists->reachable_searching_rate_slack + reachable_searching_shots, packed, rate_slack);
                lanes_pack(lists->reachable_searching_share + reachable_searching_shots, packed, share);
                lanes_pack(lists->reachable_searching_speed + reachable_searching_shots, packed, speed);
                lanes_pack(lists->reachable_searching_t + reachable_searching_shots, packed, t);
                lanes_pack(lists->reachable_searching_tilt + reachable_searching_shots, packed, tilt);
                lanes_pack(lists->reachable_searching_vx + reachable_searching_shots, packed, vx);
                lanes_pack(lists->reachable_searching_vy + reachable_searching_shots, packed, vy);
                lanes_pack(lists->reachable_searching_vz + reachable_searching_shots, packed, vz);
                lanes_pack(lists->reachable_searching_x + reachable_searching_shots, packed, x);
                lanes_pack(lists->reachable_searching_y + reachable_searching_shots, packed, y);
                lanes_pack(lists->reachable_searching_z + reachable_searching_shots, packed, z);
                reachable_searching_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
            V p_ball_radius = lanes_load(lists->p_ball_radius);
            V p_board_bottom = lanes_load(lists->p_board_bottom);
            V p_board_distance = lanes_load(lists->p_board_distance);
            V p_board_half_width = lanes_load(lists->p_board_half_width);
            V p_board_thickness = lanes_load(lists->p_board_thickness);
            V p_board_top = lanes_load(lists->p_board_top);
            V p_gravity = lanes_load(lists->p_gravity);
            V arrival = K(0.0);
            V ceiling = K(0.0);
            M certain = lanes_nowhere();
            V end = K(0.0);
            V extent = K(0.0);
            V flat = K(0.0);
            V high0 = K(0.0);
            V high1 = K(0.0);
            V last = K(0.0);
            V latest = K(0.0);
            V low0 = K(0.0);
            V low1 = K(0.0);
            V rate_slack = K(0.0);
            V share = K(0.0);
            V speed = K(0.0);
            V t = K(0.0);
            V tilt = K(0.0);
            V vx = K(0.0);
            V vy = K(0.0);
            V vz = K(0.0);
            V x = K(0.0);
            V y = K(0.0);
            V z = K(0.0);
            for (;;) {
                if (taken < reachable_searching_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->reachable_searching_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->reachable_searching_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->reachable_searching_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->reachable_searching_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    end = lanes_expand(lists->reachable_searching_end + taken, idle, end);
                    extent = lanes_expand(lists->reachable_searching_extent + taken, idle, extent);
                    flat = lanes_expand(lists->reachable_searching_flat + taken, idle, flat);
                    high0 = lanes_expand(lists->reachable_searching_high0 + taken, idle, high0);
                    high1 = lanes_expand(lists->reachable_searching_high1 + taken, idle, high1);
                    last = lanes_expand(lists->reachable_searching_last + taken, idle, last);
                    latest = lanes_expand(lists->reachable_searching_latest + taken, idle, latest);
                    low0 = lanes_expand(lists->reachable_searching_low0 + taken, idle, low0);
                    low1 = lanes_expand(lists->reachable_searching_low1 + taken, idle, low1);
                    rate_slack = lanes_expand(lists->reachable_searching_rate_slack + taken, idle, rate_slack);
                    share = lanes_expand(lists->reachable_searching_share + taken, idle, share);
                    speed = lanes_expand(lists->reachable_searching_speed + taken, idle, speed);
                    t = lanes_expand(lists->reachable_searching_t + taken, idle, t);
                    tilt = lanes_expand(lists->reachable_searching_tilt + taken, idle, tilt);
                    vx = lanes_expand(lists->reachable_searching_vx + taken, idle, vx);
                    vy = lanes_expand(lists->reachable_searching_vy + taken, idle, vy);
                    vz = lanes_expand(lists->reachable_searching_vz + taken, idle, vz);
                    x = lanes_expand(lists->reachable_searching_x + taken, idle, x);
                    y = lanes_expand(lists->reachable_searching_y + taken, idle, y);
                    z = lanes_expand(lists->reachable_searching_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->reachable_searching_p_ball_radius + taken, idle, p_ball_radius);
                        p_board_bottom = lanes_expand(lists->reachable_searching_p_board_bottom + taken, idle, p_board_bottom);
                        p_board_distance = lanes_expand(lists->reachable_searching_p_board_distance + taken, idle, p_board_distance);
                        p_board_half_width = lanes_expand(lists->reachable_searching_p_board_half_width + taken, idle, p_board_half_width);
                        p_board_thickness = lanes_expand(lists->reachable_searching_p_board_thickness + taken, idle, p_board_thickness);
                        p_board_top = lanes_expand(lists->reachable_searching_p_board_top + taken, idle, p_board_top);
                        p_gravity = lanes_expand(lists->reachable_searching_p_gravity + taken, idle, p_gravity);
                    }
                    const size_t room = LANES_WIDTH - busy, left = reachable_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o78 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o78.leaving;
                V margin = _o78.margin;
                const LANES(court_backboard_advance_out) _o79 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V gap = _o79.gap;
                V rate = _o79.rate;
                V bend = _o79.bend;
                V step = _o79.step;
                V next = _o79.next;
                V clearance = _o79.clearance;
                const LANES(court_struck_or_still_out) _o80 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o80.hit;
                M sure = _o80.sure;
                M vague = _o80.vague;
                const M _m81 = lanes_both(active, vague);
                if (lanes_any(_m81)) {
                    const LANES(court_finer_out) _o82 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m81, _o82.share, share);
                    const LANES(court_allowance_out) _o83 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
                    V position_level = _o83.position_level;
                    V velocity_level = _o83.velocity_level;
                    const LANES(court_backboard_margins_out) _o84 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                    flat = lanes_select(_m81, _o84.margin, flat);
                    tilt = lanes_select(_m81, _o84.leaving_margin, tilt);
                    rate_slack = lanes_select(_m81, _o84.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o85 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o85.arrival;
                certain = _o85.certain;
                M exhausted = _o85.exhausted;
                searching = _o85.searching;
                t = _o85.t;
                const M _m86 = lanes_both(active, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o87 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m86, _o87.t, t);
                    end = lanes_select(_m86, _o87.end, end);
                    searching = lanes_choose(_m86, _o87.searching, searching);
                }
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(searching, lanes_less(turns, K(201.0)))));
                if (lanes_any(ended)) {
                    double ended_row[LANES_WIDTH];
                    lanes_store(ended_row, row);
                    double ended_arrival[LANES_WIDTH];
                    lanes_store(ended_arrival, arrival);
                    double ended_certain[LANES_WIDTH];
                    lanes_store(ended_certain, lanes_select(certain, K(1.0), K(0.0)));
                    double ended_flat[LANES_WIDTH];
                    lanes_store(ended_flat, flat);
                    double ended_tilt[LANES_WIDTH];
                    lanes_store(ended_tilt, tilt);
                    for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                        const int lane = LANES_LOWEST(bits);
                        const size_t k = (size_t)ended_row[lane];
                        lists->reachable_arrival[k] = ended_arrival[lane];
                        lists->reachable_certain[k] = ended_certain[lane];
                        lists->reachable_flat[k] = ended_flat[lane];
                        lists->reachable_tilt[k] = ended_tilt[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        {
        size_t reachable_refining_shots = 0;
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(reachable_shots - i);
            V arrival = lanes_load(lists->reachable_arrival + i);
            V ceiling = lanes_load(lists->reachable_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->reachable_certain + i));
            V flat = lanes_load(lists->reachable_flat + i);
            V last = lanes_load(lists->reachable_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_bottom = lanes_load(varying ? lists->reachable_p_board_bottom + i : lists->p_board_bottom);
            const V p_board_distance = lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance);
            const V p_board_half_width = lanes_load(varying ? lists->reachable_p_board_half_width + i : lists->p_board_half_width);
            const V p_board_thickness = lanes_load(varying ? lists->reachable_p_board_thickness + i : lists->p_board_thickness);
            const V p_board_top = lanes_load(varying ? lists->reachable_p_board_top + i : lists->p_board_top);
            const V p_gravity = lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity);
            V tilt = lanes_load(lists->reachable_tilt + i);
            V vx = lanes_load(lists->reachable_vx + i);
            V vy = lanes_load(lists->reachable_vy + i);
            V vz = lanes_load(lists->reachable_vz + i);
            V x = lanes_load(lists->reachable_x + i);
            V y = lanes_load(lists->reachable_y + i);
            V z = lanes_load(lists->reachable_z + i);
            const LANES(court_found_out) _o88 =
                LANES(court_found)(arrival);
            M arrives = _o88.arrives;
            M refining = _o88.refining;
            const LANES(court_nearby_out) _o89 =
                LANES(court_nearby)(flat, K(1.0), last, arrival, tilt);
            V leaving = _o89.leaving;
            const M _m90 = lanes_both(rows, refining);
            if (lanes_any(_m90)) {
                const LANES(court_backboard_refine_out) _o91 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V refined = _o91.time;
                V gap = _o91.gap;
                V rate = _o91.rate;
                const LANES(court_polished_out) _o92 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m90, _o92.arrival, arrival);
                refining = lanes_choose(_m90, _o92.refining, refining);
            }
            const M _m93 = lanes_both(rows, refining);
            if (lanes_any(_m93)) {
                const LANES(court_backboard_refine_out) _o94 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V refined = _o94.time;
                V gap = _o94.gap;
                V rate = _o94.rate;
                const LANES(court_polished_out) _o95 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m93, _o95.arrival, arrival);
                refining = lanes_choose(_m93, _o95.refining, refining);
            }
            lanes_store(lists->reachable_arrival + i, arrival);
            lanes_store(lists->reachable_arrives + i, lanes_select(arrives, K(1.0), K(0.0)));
            const M packed = lanes_both(rows, refining);
            if (lanes_any(packed)) {
                lanes_pack(lists->reachable_refining_row + reachable_refining_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->reachable_refining_arrival + reachable_refining_shots, packed, arrival);
                lanes_pack(lists->reachable_refining_ceiling + reachable_refining_shots, packed, ceiling);
                lanes_pack(lists->reachable_refining_certain + reachable_refining_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->reachable_refining_leaving + reachable_refining_shots, packed, leaving);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_ball_radius + reachable_refining_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_board_bottom + reachable_refining_shots, packed, p_board_bottom);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_board_distance + reachable_refining_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_board_half_width + reachable_refining_shots, packed, p_board_half_width);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_board_thickness + reachable_refining_shots, packed, p_board_thickness);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_board_top + reachable_refining_shots, packed, p_board_top);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_gravity + reachable_refining_shots, packed, p_gravity);
                lanes_pack(lists->reachable_refining_vx + reachable_refining_shots, packed, vx);
                lanes_pack(lists->reachable_refining_vy + reachable_refining_shots, packed, vy);
                lanes_pack(lists->reachable_refining_vz + reachable_refining_shots, packed, vz);
                lanes_pack(lists->reachable_refining_x + reachable_refining_shots, packed, x);
                lanes_pack(lists->reachable_refining_y + reachable_refining_shots, packed, y);
                lanes_pack(lists->reachable_refining_z + reachable_refining_shots, packed, z);
                reachable_refining_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
            V p_ball_radius = lanes_load(lists->p_ball_radius);
            V p_board_bottom = lanes_load(lists->p_board_bottom);
            V p_board_distance = lanes_load(lists->p_board_distance);
            V p_board_half_width = lanes_load(lists->p_board_half_width);
            V p_board_thickness = lanes_load(lists->p_board_thickness);
            V p_board_top = lanes_load(lists->p_board_top);
            V p_gravity = lanes_load(lists->p_gravity);
            V arrival = K(0.0);
            V ceiling = K(0.0);
            M certain = lanes_nowhere();
            V leaving = K(0.0);
            V vx = K(0.0);
            V vy = K(0.0);
            V vz = K(0.0);
            V x = K(0.0);
            V y = K(0.0);
            V z = K(0.0);
            for (;;) {
                if (taken < reachable_refining_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->reachable_refining_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->reachable_refining_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->reachable_refining_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->reachable_refining_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    leaving = lanes_expand(lists->reachable_refining_leaving + taken, idle, leaving);
                    vx = lanes_expand(lists->reachable_refining_vx + taken, idle, vx);
                    vy = lanes_expand(lists->reachable_refining_vy + taken, idle, vy);
                    vz = lanes_expand(lists->reachable_refining_vz + taken, idle, vz);
                    x = lanes_expand(lists->reachable_refining_x + taken, idle, x);
                    y = lanes_expand(lists->reachable_refining_y + taken, idle, y);
                    z = lanes_expand(lists->reachable_refining_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->reachable_refining_p_ball_radius + taken, idle, p_ball_radius);
                        p_board_bottom = lanes_expand(lists->reachable_refining_p_board_bottom + taken, idle, p_board_bottom);
                        p_board_distance = lanes_expand(lists->reachable_refining_p_board_distance + taken, idle, p_board_distance);
                        p_board_half_width = lanes_expand(lists->reachable_refining_p_board_half_width + taken, idle, p_board_half_width);
                        p_board_thickness = lanes_expand(lists->reachable_refining_p_board_thickness + taken, idle, p_board_thickness);
                        p_board_top = lanes_expand(lists->reachable_refining_p_board_top + taken, idle, p_board_top);
                        p_gravity = lanes_expand(lists->reachable_refining_p_gravity + taken, idle, p_gravity);
                    }
                    const size_t room = LANES_WIDTH - busy, left = reachable_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_backboard_refine_out) _o96 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V refined = _o96.time;
                V gap = _o96.gap;
                V rate = _o96.rate;
                const LANES(court_polished_out) _o97 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o97.arrival;
                refining = _o97.refining;
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(refining, lanes_less(turns, K(8.0)))));
                if (lanes_any(ended)) {
                    double ended_row[LANES_WIDTH];
                    lanes_store(ended_row, row);
                    double ended_arrival[LANES_WIDTH];
                    lanes_store(ended_arrival, arrival);
                    for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                        const int lane = LANES_LOWEST(bits);
                        const size_t k = (size_t)ended_row[lane];
                        lists->reachable_arrival[k] = ended_arrival[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            V arrival = lanes_load(lists->reachable_arrival + i);
            M arrives = lanes_less(K(0.0), lanes_load(lists->reachable_arrives + i));
            V when = lanes_load(lists->reachable_when + i);
            V which = lanes_load(lists->reachable_which + i);
            const LANES(court_landed_out) _o98 =
                LANES(court_landed)(arrival);
            V time = _o98.time;
            const LANES(court_sooner_out) _o99 =
                LANES(court_sooner)(arrives, K(1.0), time, when, which);
            when = _o99.when;
            which = _o99.which;
            lanes_store(lists->reachable_when + i, when);
            lanes_store(lists->reachable_which + i, which);
        }
        for (size_t k = 0; k < reachable_shots; k++) {
            const size_t row = (size_t)lists->reachable_row[k];
            lists->when[row] = lists->reachable_when[k];
            lists->which[row] = lists->reachable_which[k];
        }
        }
        {
        size_t reachable_shots = 0;
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            V extent = lanes_load(lists->extent + i);
            M kept = lanes_less(K(0.0), lanes_load(lists->kept + i));
            V last = lanes_load(lists->last + i);
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_bridge_depth = lanes_load(lists->p_bridge_depth + (i & varying));
            const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
            const V p_wire_radius = lanes_load(lists->p_wire_radius + (i & varying));
            V speed = lanes_load(lists->speed + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V when = lanes_load(lists->when + i);
            V which = lanes_load(lists->which + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const LANES(court_horizon_out) _o100 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o100.horizon;
            V pad = _o100.pad;
            const LANES(court_halved_out) _o101 =
                LANES(court_halved)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), K(0.0), pad, p_gravity);
            V middle_x = _o101.middle_x;
            V reach_x = _o101.reach_x;
            V later_middle_x = _o101.later_middle_x;
            V later_reach_x = _o101.later_reach_x;
            V middle_y = _o101.middle_y;
            V reach_y = _o101.reach_y;
            V later_middle_y = _o101.later_middle_y;
            V later_reach_y = _o101.later_reach_y;
            V middle_z = _o101.middle_z;
            V reach_z = _o101.reach_z;
            V later_middle_z = _o101.later_middle_z;
            V later_reach_z = _o101.later_reach_z;
            const LANES(court_bridge_near_out) _o102 =
                LANES(court_bridge_near)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, later_middle_x, later_middle_y, later_middle_z, later_reach_x, later_reach_y, later_reach_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
            M reachable = _o102.near;
            const LANES(court_reachable_in_flight_out) _o103 =
                LANES(court_reachable_in_flight)(kept, reachable);
            reachable = _o103.reachable;
            const M packed = lanes_both(rows, reachable);
            if (lanes_any(packed)) {
                lanes_pack(lists->reachable_row + reachable_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->reachable_extent + reachable_shots, packed, extent);
                lanes_pack(lists->reachable_last + reachable_shots, packed, last);
                if (varying)
                    lanes_pack(lists->reachable_p_ball_radius + reachable_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->reachable_p_board_distance + reachable_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->reachable_p_bridge_depth + reachable_shots, packed, p_bridge_depth);
                if (varying)
                    lanes_pack(lists->reachable_p_bridge_half_width + reachable_shots, packed, p_bridge_half_width);
                if (varying)
                    lanes_pack(lists->reachable_p_gravity + reachable_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->reachable_p_ring_radius + reachable_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->reachable_p_wire_radius + reachable_shots, packed, p_wire_radius);
                lanes_pack(lists->reachable_speed + reachable_shots, packed, speed);
                lanes_pack(lists->reachable_vx + reachable_shots, packed, vx);
                lanes_pack(lists->reachable_vy + reachable_shots, packed, vy);
                lanes_pack(lists->reachable_vz + reachable_shots, packed, vz);
                lanes_pack(lists->reachable_when + reachable_shots, packed, when);
                lanes_pack(lists->reachable_which + reachable_shots, packed, which);
                lanes_pack(lists->reachable_x + reachable_shots, packed, x);
                lanes_pack(lists->reachable_y + reachable_shots, packed, y);
                lanes_pack(lists->reachable_z + reachable_shots, packed, z);
                reachable_shots += lanes_many(packed);
            }
        }
        {
        size_t reachable_searching_shots = 0;
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(reachable_shots - i);
            V extent = lanes_load(lists->reachable_extent + i);
            V last = lanes_load(lists->reachable_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_distance = lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance);
            const V p_bridge_depth = lanes_load(varying ? lists->reachable_p_bridge_depth + i : lists->p_bridge_depth);
            const V p_bridge_half_width = lanes_load(varying ? lists->reachable_p_bridge_half_width + i : lists->p_bridge_half_width);
            const V p_gravity = lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->reachable_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->reachable_p_wire_radius + i : lists->p_wire_radius);
            V speed = lanes_load(lists->reachable_speed + i);
            V vx = lanes_load(lists->reachable_vx + i);
            V vy = lanes_load(lists->reachable_vy + i);
            V vz = lanes_load(lists->reachable_vz + i);
            V when = lanes_load(lists->reachable_when + i);
            V x = lanes_load(lists->reachable_x + i);
            V y = lanes_load(lists->reachable_y + i);
            V z = lanes_load(lists->reachable_z + i);
            const LANES(court_horizon_out) _o104 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o104.horizon;
            const LANES(court_bridge_prepare_out) _o105 =
                LANES(court_bridge_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V low0 = _o105.low0;
            V high0 = _o105.high0;
            V low1 = _o105.low1;
            V high1 = _o105.high1;
            V ceiling = _o105.ceiling;
            V latest = _o105.latest;
            const LANES(court_beginning_out) _o106 =
                LANES(court_beginning)();
            V share = _o106.share;
            V arrival = _o106.arrival;
            M certain = _o106.certain;
            const LANES(court_allowance_out) _o107 =
                LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
            V position_level = _o107.position_level;
            V velocity_level = _o107.velocity_level;
            const LANES(court_bridge_margins_out) _o108 =
                LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V flat = _o108.margin;
            V tilt = _o108.leaving_margin;
            V rate_slack = _o108.rate_margin;
            const LANES(court_bridge_enter_out) _o109 =
                LANES(court_bridge_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o109.t;
            V end = _o109.end;
            M searching = _o109.searching;
            const M _m110 = lanes_both(rows, searching);
            if (lanes_any(_m110)) {
                const LANES(court_nearby_out) _o111 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o111.leaving;
                V margin = _o111.margin;
                const LANES(court_bridge_advance_out) _o112 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V gap = _o112.gap;
                V rate = _o112.rate;
                V bend = _o112.bend;
                V step = _o112.step;
                V next = _o112.next;
                V clearance = _o112.clearance;
                const LANES(court_struck_or_still_out) _o113 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o113.hit;
                M sure = _o113.sure;
                M vague = _o113.vague;
                const M _m114 = lanes_both(_m110, vague);
                if (lanes_any(_m114)) {
                    const LANES(court_finer_out) _o115 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m114, _o115.share, share);
                    const LANES(court_allowance_out) _o116 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
                    V position_level = _o116.position_level;
                    V velocity_level = _o116.velocity_level;
                    const LANES(court_bridge_margins_out) _o117 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                    flat = lanes_select(_m114, _o117.margin, flat);
                    tilt = lanes_select(_m114, _o117.leaving_margin, tilt);
                    rate_slack = lanes_select(_m114, _o117.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o118 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = lanes_select(_m110, _o118.arrival, arrival);
                certain = lanes_choose(_m110, _o118.certain, certain);
                M exhausted = _o118.exhausted;
                searching = lanes_choose(_m110, _o118.searching, searching);
                t = lanes_select(_m110, _o118.t, t);
                const M _m119 = lanes_both(_m110, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o120 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m119, _o120.t, t);
                    end = lanes_select(_m119, _o120.end, end);
                    searching = lanes_choose(_m119, _o120.searching, searching);
                }
            }
            lanes_store(lists->reachable_arrival + i, arrival);
            lanes_store(lists->reachable_ceiling + i, ceiling);
            lanes_store(lists->reachable_certain + i, lanes_select(certain, K(1.0), K(0.0)));
            lanes_store(lists->reachable_flat + i, flat);
            lanes_store(lists->reachable_tilt + i, tilt);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->reachable_searching_row + reachable_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->reachable_searching_arrival + reachable_searching_shots, packed, arrival);
                lanes_pack(lists->reachable_searching_ceiling + reachable_searching_shots, packed, ceiling);
                lanes_pack(lists->reachable_searching_certain + reachable_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->reachable_searching_end + reachable_searching_shots, packed, end);
                lanes_pack(lists->reachable_searching_extent + reachable_searching_shots, packed, extent);
                lanes_pack(lists->reachable_searching_flat + reachable_searching_shots, packed, flat);
                lanes_pack(lists->reachable_searching_high0 + reachable_searching_shots, packed, high0);
                lanes_pack(lists->reachable_searching_high1 + reachable_searching_shots, packed, high1);
                lanes_pack(lists->reachable_searching_last + reachable_searching_shots, packed, last);
                lanes_pack(lists->reachable_searching_latest + reachable_searching_shots, packed, latest);
                lanes_pack(lists->reachable_searching_low0 + reachable_searching_shots, packed, low0);
                lanes_pack(lists->reachable_searching_low1 + reachable_searching_shots, packed, low1);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_ball_radius + reachable_searching_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_board_distance + reachable_searching_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_bridge_depth + reachable_searching_shots, packed, p_bridge_depth);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_bridge_half_width + reachable_searching_shots, packed, p_bridge_half_width);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_gravity + reachable_searching_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_ring_radius + reachable_searching_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_wire_radius + reachable_searching_shots, packed, p_wire_radius);
                lanes_pack(lists->reachable_searching_rate_slack + reachable_searching_shots, packed, rate_slack);
                lanes_pack(lists->reachable_searching_share + reachable_searching_shots, packed, share);
                lanes_pack(lists->reachable_searching_speed + reachable_searching_shots, packed, speed);
                lanes_pack(lists->reachable_searching_t + reachable_searching_shots, packed, t);
                lanes_pack(lists->reachable_searching_tilt + reachable_searching_shots, packed, tilt);
                lanes_pack(lists->reachable_searching_vx + reachable_searching_shots, packed, vx);
                lanes_pack(lists->reachable_searching_vy + reachable_searching_shots, packed, vy);
                lanes_pack(lists->reachable_searching_vz + reachable_searching_shots, packed, vz);
                lanes_pack(lists->reachable_searching_x + reachable_searching_shots, packed, x);
                lanes_pack(lists->reachable_searching_y + reachable_searching_shots, packed, y);
                lanes_pack(lists->reachable_searching_z + reachable_searching_shots, packed, z);
                reachable_searching_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
            V p_ball_radius = lanes_load(lists->p_ball_radius);
            V p_board_distance = lanes_load(lists->p_board_distance);
            V p_bridge_depth = lanes_load(lists->p_bridge_depth);
            V p_bridge_half_width = lanes_load(lists->p_bridge_half_width);
            V p_gravity = lanes_load(lists->p_gravity);
            V p_ring_radius = lanes_load(lists->p_ring_radius);
            V p_wire_radius = lanes_load(lists->p_wire_radius);
            V arrival = K(0.0);
            V ceiling = K(0.0);
            M certain = lanes_nowhere();
            V end = K(0.0);
            V extent = K(0.0);
            V flat = K(0.0);
            V high0 = K(0.0);
            V high1 = K(0.0);
            V last = K(0.0);
            V latest = K(0.0);
            V low0 = K(0.0);
            V low1 = K(0.0);
            V rate_slack = K(0.0);
            V share = K(0.0);
            V speed = K(0.0);
            V t = K(0.0);
            V tilt = K(0.0);
            V vx = K(0.0);
            V vy = K(0.0);
            V vz = K(0.0);
            V x = K(0.0);
            V y = K(0.0);
            V z = K(0.0);
            for (;;) {
                if (taken < reachable_searching_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->reachable_searching_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->reachable_searching_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->reachable_searching_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->reachable_searching_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    end = lanes_expand(lists->reachable_searching_end + taken, idle, end);
                    extent = lanes_expand(lists->reachable_searching_extent + taken, idle, extent);
                    flat = lanes_expand(lists->reachable_searching_flat + taken, idle, flat);
                    high0 = lanes_expand(lists->reachable_searching_high0 + taken, idle, high0);
                    high1 = lanes_expand(lists->reachable_searching_high1 + taken, idle, high1);
                    last = lanes_expand(lists->reachable_searching_last + taken, idle, last);
                    latest = lanes_expand(lists->reachable_searching_latest + taken, idle, latest);
                    low0 = lanes_expand(lists->reachable_searching_low0 + taken, idle, low0);
                    low1 = lanes_expand(lists->reachable_searching_low1 + taken, idle, low1);
                    rate_slack = lanes_expand(lists->reachable_searching_rate_slack + taken, idle, rate_slack);
                    share = lanes_expand(lists->reachable_searching_share + taken, idle, share);
                    speed = lanes_expand(lists->reachable_searching_speed + taken, idle, speed);
                    t = lanes_expand(lists->reachable_searching_t + taken, idle, t);
                    tilt = lanes_expand(lists->reachable_searching_tilt + taken, idle, tilt);
                    vx = lanes_expand(lists->reachable_searching_vx + taken, idle, vx);
                    vy = lanes_expand(lists->reachable_searching_vy + taken, idle, vy);
                    vz = lanes_expand(lists->reachable_searching_vz + taken, idle, vz);
                    x = lanes_expand(lists->reachable_searching_x + taken, idle, x);
                    y = lanes_expand(lists->reachable_searching_y + taken, idle, y);
                    z = lanes_expand(lists->reachable_searching_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->reachable_searching_p_ball_radius + taken, idle, p_ball_radius);
                        p_board_distance = lanes_expand(lists->reachable_searching_p_board_distance + taken, idle, p_board_distance);
                        p_bridge_depth = lanes_expand(lists->reachable_searching_p_bridge_depth + taken, idle, p_bridge_depth);
                        p_bridge_half_width = lanes_expand(lists->reachable_searching_p_bridge_half_width + taken, idle, p_bridge_half_width);
                        p_gravity = lanes_expand(lists->reachable_searching_p_gravity + taken, idle, p_gravity);
                        p_ring_radius = lanes_expand(lists->reachable_searching_p_ring_radius + taken, idle, p_ring_radius);
                        p_wire_radius = lanes_expand(lists->reachable_searching_p_wire_radius + taken, idle, p_wire_radius);
                    }
                    const size_t room = LANES_WIDTH - busy, left = reachable_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o121 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o121.leaving;
                V margin = _o121.margin;
                const LANES(court_bridge_advance_out) _o122 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V gap = _o122.gap;
                V rate = _o122.rate;
                V bend = _o122.bend;
                V step = _o122.step;
                V next = _o122.next;
                V clearance = _o122.clearance;
                const LANES(court_struck_or_still_out) _o123 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o123.hit;
                M sure = _o123.sure;
                M vague = _o123.vague;
                const M _m124 = lanes_both(active, vague);
                if (lanes_any(_m124)) {
                    const LANES(court_finer_out) _o125 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m124, _o125.share, share);
                    const LANES(court_allowance_out) _o126 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
                    V position_level = _o126.position_level;
                    V velocity_level = _o126.velocity_level;
                    const LANES(court_bridge_margins_out) _o127 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                    flat = lanes_select(_m124, _o127.margin, flat);
                    tilt = lanes_select(_m124, _o127.leaving_margin, tilt);
                    rate_slack = lanes_select(_m124, _o127.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o128 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o128.arrival;
                certain = _o128.certain;
                M exhausted = _o128.exhausted;
                searching = _o128.searching;
                t = _o128.t;
                const M _m129 = lanes_both(active, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o130 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m129, _o130.t, t);
                    end = lanes_select(_m129, _o130.end, end);
                    searching = lanes_choose(_m129, _o130.searching, searching);
                }
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(searching, lanes_less(turns, K(201.0)))));
                if (lanes_any(ended)) {
                    double ended_row[LANES_WIDTH];
                    lanes_store(ended_row, row);
                    double ended_arrival[LANES_WIDTH];
                    lanes_store(ended_arrival, arrival);
                    double ended_certain[LANES_WIDTH];
                    lanes_store(ended_certain, lanes_select(certain, K(1.0), K(0.0)));
                    double ended_flat[LANES_WIDTH];
                    lanes_store(ended_flat, flat);
                    double ended_tilt[LANES_WIDTH];
                    lanes_store(ended_tilt, tilt);
                    for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                        const int lane = LANES_LOWEST(bits);
                        const size_t k = (size_t)ended_row[lane];
                        lists->reachable_arrival[k] = ended_arrival[lane];
                        lists->reachable_certain[k] = ended_certain[lane];
                        lists->reachable_flat[k] = ended_flat[lane];
                        lists->reachable_tilt[k] = ended_tilt[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        {
        size_t reachable_refining_shots = 0;
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(reachable_shots - i);
            V arrival = lanes_load(lists->reachable_arrival + i);
            V ceiling = lanes_load(lists->reachable_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->reachable_certain + i));
            V flat = lanes_load(lists->reachable_flat + i);
            V last = lanes_load(lists->reachable_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_distance = lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance);
            const V p_bridge_depth = lanes_load(varying ? lists->reachable_p_bridge_depth + i : lists->p_bridge_depth);
            const V p_bridge_half_width = lanes_load(varying ? lists->reachable_p_bridge_half_width + i : lists->p_bridge_half_width);
            const V p_gravity = lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->reachable_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->reachable_p_wire_radius + i : lists->p_wire_radius);
            V tilt = lanes_load(lists->reachable_tilt + i);
            V vx = lanes_load(lists->reachable_vx + i);
            V vy = lanes_load(lists->reachable_vy + i);
            V vz = lanes_load(lists->reachable_vz + i);
            V x = lanes_load(lists->reachable_x + i);
            V y = lanes_load(lists->reachable_y + i);
            V z = lanes_load(lists->reachable_z + i);
            const LANES(court_found_out) _o131 =
                LANES(court_found)(arrival);
            M arrives = _o131.arrives;
            M refining = _o131.refining;
            const LANES(court_nearby_out) _o132 =
                LANES(court_nearby)(flat, K(2.0), last, arrival, tilt);
            V leaving = _o132.leaving;
            const M _m133 = lanes_both(rows, refining);
            if (lanes_any(_m133)) {
                const LANES(court_bridge_refine_out) _o134 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V refined = _o134.time;
                V gap = _o134.gap;
                V rate = _o134.rate;
                const LANES(court_polished_out) _o135 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m133, _o135.arrival, arrival);
                refining = lanes_choose(_m133, _o135.refining, refining);
            }
            const M _m136 = lanes_both(rows, refining);
            if (lanes_any(_m136)) {
                const LANES(court_bridge_refine_out) _o137 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V refined = _o137.time;
                V gap = _o137.gap;
                V rate = _o137.rate;
                const LANES(court_polished_out) _o138 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m136, _o138.arrival, arrival);
                refining = lanes_choose(_m136, _o138.refining, refining);
            }
            lanes_store(lists->reachable_arrival + i, arrival);
            lanes_store(lists->reachable_arrives + i, lanes_select(arrives, K(1.0), K(0.0)));
            const M packed = lanes_both(rows, refining);
            if (lanes_any(packed)) {
                lanes_pack(lists->reachable_refining_row + reachable_refining_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->reachable_refining_arrival + reachable_refining_shots, packed, arrival);
                lanes_pack(lists->reachable_refining_ceiling + reachable_refining_shots, packed, ceiling);
                lanes_pack(lists->reachable_refining_certain + reachable_refining_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->reachable_refining_leaving + reachable_refining_shots, packed, leaving);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_ball_radius + reachable_refining_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_board_distance + reachable_refining_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_bridge_depth + reachable_refining_shots, packed, p_bridge_depth);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_bridge_half_width + reachable_refining_shots, packed, p_bridge_half_width);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_gravity + reachable_refining_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_ring_radius + reachable_refining_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_wire_radius + reachable_refining_shots, packed, p_wire_radius);
                lanes_pack(lists->reachable_refining_vx + reachable_refining_shots, packed, vx);
                lanes_pack(lists->reachable_refining_vy + reachable_refining_shots, packed, vy);
                lanes_pack(lists->reachable_refining_vz + reachable_refining_shots, packed, vz);
                lanes_pack(lists->reachable_refining_x + reachable_refining_shots, packed, x);
                lanes_pack(lists->reachable_refining_y + reachable_refining_shots, packed, y);
                lanes_pack(lists->reachable_refining_z + reachable_refining_shots, packed, z);
                reachable_refining_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
            V p_ball_radius = lanes_load(lists->p_ball_radius);
            V p_board_distance = lanes_load(lists->p_board_distance);
            V p_bridge_depth = lanes_load(lists->p_bridge_depth);
            V p_bridge_half_width = lanes_load(lists->p_bridge_half_width);
            V p_gravity = lanes_load(lists->p_gravity);
            V p_ring_radius = lanes_load(lists->p_ring_radius);
            V p_wire_radius = lanes_load(lists->p_wire_radius);
            V arrival = K(0.0);
            V ceiling = K(0.0);
            M certain = lanes_nowhere();
            V leaving = K(0.0);
            V vx = K(0.0);
            V vy = K(0.0);
            V vz = K(0.0);
            V x = K(0.0);
            V y = K(0.0);
            V z = K(0.0);
            for (;;) {
                if (taken < reachable_refining_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->reachable_refining_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->reachable_refining_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->reachable_refining_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->reachable_refining_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    leaving = lanes_expand(lists->reachable_refining_leaving + taken, idle, leaving);
                    vx = lanes_expand(lists->reachable_refining_vx + taken, idle, vx);
                    vy = lanes_expand(lists->reachable_refining_vy + taken, idle, vy);
                    vz = lanes_expand(lists->reachable_refining_vz + taken, idle, vz);
                    x = lanes_expand(lists->reachable_refining_x + taken, idle, x);
                    y = lanes_expand(lists->reachable_refining_y + taken, idle, y);
                    z = lanes_expand(lists->reachable_refining_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->reachable_refining_p_ball_radius + taken, idle, p_ball_radius);
                        p_board_distance = lanes_expand(lists->reachable_refining_p_board_distance + taken, idle, p_board_distance);
                        p_bridge_depth = lanes_expand(lists->reachable_refining_p_bridge_depth + taken, idle, p_bridge_depth);
                        p_bridge_half_width = lanes_expand(lists->reachable_refining_p_bridge_half_width + taken, idle, p_bridge_half_width);
                        p_gravity = lanes_expand(lists->reachable_refining_p_gravity + taken, idle, p_gravity);
                        p_ring_radius = lanes_expand(lists->reachable_refining_p_ring_radius + taken, idle, p_ring_radius);
                        p_wire_radius = lanes_expand(lists->reachable_refining_p_wire_radius + taken, idle, p_wire_radius);
                    }
                    const size_t room = LANES_WIDTH - busy, left = reachable_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_bridge_refine_out) _o139 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V refined = _o139.time;
                V gap = _o139.gap;
                V rate = _o139.rate;
                const LANES(court_polished_out) _o140 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o140.arrival;
                refining = _o140.refining;
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(refining, lanes_less(turns, K(8.0)))));
                if (lanes_any(ended)) {
                    double ended_row[LANES_WIDTH];
                    lanes_store(ended_row, row);
                    double ended_arrival[LANES_WIDTH];
                    lanes_store(ended_arrival, arrival);
                    for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                        const int lane = LANES_LOWEST(bits);
                        const size_t k = (size_t)ended_row[lane];
                        lists->reachable_arrival[k] = ended_arrival[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            V arrival = lanes_load(lists->reachable_arrival + i);
            M arrives = lanes_less(K(0.0), lanes_load(lists->reachable_arrives + i));
            V when = lanes_load(lists->reachable_when + i);
            V which = lanes_load(lists->reachable_which + i);
            const LANES(court_landed_out) _o141 =
                LANES(court_landed)(arrival);
            V time = _o141.time;
            const LANES(court_sooner_out) _o142 =
                LANES(court_sooner)(arrives, K(2.0), time, when, which);
            when = _o142.when;
            which = _o142.which;
            lanes_store(lists->reachable_when + i, when);
            lanes_store(lists->reachable_which + i, which);
        }
        for (size_t k = 0; k < reachable_shots; k++) {
            const size_t row = (size_t)lists->reachable_row[k];
            lists->when[row] = lists->reachable_when[k];
            lists->which[row] = lists->reachable_which[k];
        }
        }
        {
        size_t kept_shots = 0;
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            V circled = lanes_load(lists->circled + i);
            V clock = lanes_load(lists->clock + i);
            V held = lanes_load(lists->held + i);
            M kept = lanes_less(K(0.0), lanes_load(lists->kept + i));
            M limited = lanes_less(K(0.0), lanes_load(lists->limited + i));
            V mode = lanes_load(lists->mode + i);
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_bottom = lanes_load(lists->p_board_bottom + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_board_half_width = lanes_load(lists->p_board_half_width + (i & varying));
            const V p_board_thickness = lanes_load(lists->p_board_thickness + (i & varying));
            const V p_board_top = lanes_load(lists->p_board_top + (i & varying));
            const V p_bridge_depth = lanes_load(lists->p_bridge_depth + (i & varying));
            const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + (i & varying));
            const V p_end_depth = lanes_load(lists->p_end_depth + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
            const V p_wire_radius = lanes_load(lists->p_wire_radius + (i & varying));
            M rests = lanes_less(K(0.0), lanes_load(lists->rests + i));
            V through = lanes_load(lists->through + i);
            V time_error = lanes_load(lists->time_error + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V when = lanes_load(lists->when + i);
            V which = lanes_load(lists->which + i);
            V wx = lanes_load(lists->wx + i);
            V wy = lanes_load(lists->wy + i);
            V wz = lanes_load(lists->wz + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const M _m143 = lanes_both(rows, limited);
            if (lanes_any(_m143)) {
                const LANES(court_expiry_out) _o144 =
                    LANES(court_expiry)(clock, K(INFINITY), K(0.0), time_error, time_limit, when, which);
                V time = _o144.time;
                M arrives = _o144.arrives;
                const LANES(court_sooner_out) _o145 =
                    LANES(court_sooner)(arrives, K(4.0), time, when, which);
                when = lanes_select(_m143, _o145.when, when);
                which = lanes_select(_m143, _o145.which, which);
            }
            lanes_store(lists->when + i, when);
            lanes_store(lists->which + i, which);
            const M packed = lanes_both(rows, kept);
            if (lanes_any(packed)) {
                lanes_pack(lists->kept_row + kept_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->kept_circled + kept_shots, packed, circled);
                lanes_pack(lists->kept_clock + kept_shots, packed, clock);
                lanes_pack(lists->kept_held + kept_shots, packed, held);
                lanes_pack(lists->kept_mode + kept_shots, packed, mode);
                if (varying)
                    lanes_pack(lists->kept_p_ball_radius + kept_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->kept_p_board_bottom + kept_shots, packed, p_board_bottom);
                if (varying)
                    lanes_pack(lists->kept_p_board_distance + kept_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->kept_p_board_half_width + kept_shots, packed, p_board_half_width);
                if (varying)
                    lanes_pack(lists->kept_p_board_thickness + kept_shots, packed, p_board_thickness);
                if (varying)
                    lanes_pack(lists->kept_p_board_top + kept_shots, packed, p_board_top);
                if (varying)
                    lanes_pack(lists->kept_p_bridge_depth + kept_shots, packed, p_bridge_depth);
                if (varying)
                    lanes_pack(lists->kept_p_bridge_half_width + kept_shots, packed, p_bridge_half_width);
                if (varying)
                    lanes_pack(lists->kept_p_end_depth + kept_shots, packed, p_end_depth);
                if (varying)
                    lanes_pack(lists->kept_p_gravity + kept_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->kept_p_ring_radius + kept_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->kept_p_wire_radius + kept_shots, packed, p_wire_radius);
                lanes_pack(lists->kept_rests + kept_shots, packed, lanes_select(rests, K(1.0), K(0.0)));
                lanes_pack(lists->kept_through + kept_shots, packed, through);
                lanes_pack(lists->kept_vx + kept_shots, packed, vx);
                lanes_pack(lists->kept_vy + kept_shots, packed, vy);
                lanes_pack(lists->kept_vz + kept_shots, packed, vz);
                lanes_pack(lists->kept_when + kept_shots, packed, when);
                lanes_pack(lists->kept_wx + kept_shots, packed, wx);
                lanes_pack(lists->kept_wy + kept_shots, packed, wy);
                lanes_pack(lists->kept_wz + kept_shots, packed, wz);
                lanes_pack(lists->kept_x + kept_shots, packed, x);
                lanes_pack(lists->kept_y + kept_shots, packed, y);
                lanes_pack(lists->kept_z + kept_shots, packed, z);
                kept_shots += lanes_many(packed);
            }
        }
        if (kept_shots)
            LANES(court_plain_kept)(lists, kept_shots, varying, time_limit);
        for (size_t k = 0; k < kept_shots; k++) {
            const size_t row = (size_t)lists->kept_row[k];
            lists->began[row] = lists->kept_began[k];
            lists->circled[row] = lists->kept_circled[k];
            lists->clock[row] = lists->kept_clock[k];
            lists->rests[row] = lists->kept_rests[k];
            lists->rolling[row] = lists->kept_rolling[k];
            lists->through[row] = lists->kept_through[k];
            lists->vx[row] = lists->kept_vx[k];
            lists->vy[row] = lists->kept_vy[k];
            lists->vz[row] = lists->kept_vz[k];
            lists->when[row] = lists->kept_when[k];
            lists->which[row] = lists->kept_which[k];
            lists->wx[row] = lists->kept_wx[k];
            lists->wy[row] = lists->kept_wy[k];
            lists->wz[row] = lists->kept_wz[k];
            lists->x[row] = lists->kept_x[k];
            lists->y[row] = lists->kept_y[k];
            lists->z[row] = lists->kept_z[k];
        }
        }
        {
        size_t slow_shots = 0;
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            V began = lanes_load(lists->began + i);
            V clock = lanes_load(lists->clock + i);
            V contacts = lanes_load(lists->contacts + i);
            V count_0 = lanes_load(lists->count_0 + i);
            V count_1 = lanes_load(lists->count_1 + i);
            V count_2 = lanes_load(lists->count_2 + i);
            V first = lanes_load(lists->first + i);
            V held = lanes_load(lists->held + i);
            M kept = lanes_less(K(0.0), lanes_load(lists->kept + i));
            V last = lanes_load(lists->last + i);
            M limited = lanes_less(K(0.0), lanes_load(lists->limited + i));
            V mode = lanes_load(lists->mode + i);
            const V p_backboard_friction = lanes_load(lists->p_backboard_friction + (i & varying));
            const V p_backboard_restitution = lanes_load(lists->p_backboard_restitution + (i & varying));
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_bottom = lanes_load(lists->p_board_bottom + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_board_half_width = lanes_load(lists->p_board_half_width + (i & varying));
            const V p_board_thickness = lanes_load(lists->p_board_thickness + (i & varying));
            const V p_board_top = lanes_load(lists->p_board_top + (i & varying));
            const V p_bridge_depth = lanes_load(lists->p_bridge_depth + (i & varying));
            const V p_bridge_friction = lanes_load(lists->p_bridge_friction + (i & varying));
            const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + (i & varying));
            const V p_bridge_restitution = lanes_load(lists->p_bridge_restitution + (i & varying));
            const V p_end_depth = lanes_load(lists->p_end_depth + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_restitution_speed = lanes_load(lists->p_restitution_speed + (i & varying));
            const V p_ring_friction = lanes_load(lists->p_ring_friction + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
            const V p_ring_restitution = lanes_load(lists->p_ring_restitution + (i & varying));
            const V p_tangential_restitution = lanes_load(lists->p_tangential_restitution + (i & varying));
            const V p_wire_radius = lanes_load(lists->p_wire_radius + (i & varying));
            M rests = lanes_less(K(0.0), lanes_load(lists->rests + i));
            M rolling = lanes_less(K(0.0), lanes_load(lists->rolling + i));
            V rolls = lanes_load(lists->rolls + i);
            V slip_left = lanes_load(lists->slip_left + i);
            V through = lanes_load(lists->through + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V when = lanes_load(lists->when + i);
            V which = lanes_load(lists->which + i);
            V wx = lanes_load(lists->wx + i);
            V wy = lanes_load(lists->wy + i);
            V wz = lanes_load(lists->wz + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const LANES(court_departed_out) _o349 =
                LANES(court_departed)(K(3.0), which);
            M moves = _o349.moves;
            M ends = _o349.ends;
            M touches = _o349.touches;
            V reached = _o349.reached;
            const LANES(court_body_of_out) _o350 =
                LANES(court_body_of)(which);
            V body = _o350.body;
            const M _m351 = lanes_both(rows, moves);
            if (lanes_any(_m351)) {
                const LANES(court_passing_out) _o352 =
                    LANES(court_passing)(through, when, x, y, z, vx, vy, vz, p_ring_radius, p_gravity);
                through = lanes_select(_m351, _o352.through, through);
                const LANES(court_flight_out) _o353 =
                    LANES(court_flight)(when, x, y, z, vx, vy, vz, p_gravity);
                x = lanes_select(_m351, _o353.x, x);
                y = lanes_select(_m351, _o353.y, y);
                z = lanes_select(_m351, _o353.z, z);
                vx = lanes_select(_m351, _o353.vx, vx);
                vy = lanes_select(_m351, _o353.vy, vy);
                vz = lanes_select(_m351, _o353.vz, vz);
                const LANES(court_ticked_out) _o354 =
                    LANES(court_ticked)(clock, when);
                clock = lanes_select(_m351, _o354.clock, clock);
            }
            const M _m355 = lanes_both(rows, limited);
            if (lanes_any(_m355)) {
                const LANES(court_expired_out) _o356 =
                    LANES(court_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m355, _o356.clock, clock);
                body = lanes_select(_m355, _o356.body, body);
                reached = lanes_select(_m355, _o356.reached, reached);
                ends = lanes_choose(_m355, _o356.ends, ends);
            }
            const M _m357 = lanes_both(rows, kept);
            if (lanes_any(_m357)) {
                const LANES(court_kept_on_out) _o358 =
                    LANES(court_kept_on)(began, body, clock, K(INFINITY), ends, held, last, reached, rests, rolling, rolls, which);
                body = lanes_select(_m357, _o358.body, body);
                reached = lanes_select(_m357, _o358.reached, reached);
                ends = lanes_choose(_m357, _o358.ends, ends);
                last = lanes_select(_m357, _o358.last, last);
                mode = lanes_select(_m357, _o358.mode, mode);
                held = lanes_select(_m357, _o358.held, held);
                rolls = lanes_select(_m357, _o358.rolls, rolls);
            }
            const LANES(court_here_out) _o359 =
                LANES(court_here)(K(3.0), which);
            M here = _o359.here;
            const M _m360 = lanes_both(rows, here);
            {
                const LANES(court_end_bounds_out) _o361 =
                    LANES(court_end_bounds)(x, y, p_ring_radius);
                V g0 = _o361.g0;
                const LANES(court_end_reached_out) _o362 =
                    LANES(court_end_reached)(g0, through);
                reached = lanes_select(_m360, _o362.reached, reached);
            }
            const LANES(court_accounted_out) _o363 =
                LANES(court_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o363.contacts;
            V outcome = _o363.outcome;
            if (recording) {
                lanes_store(lists->body + i, body);
                lanes_store(lists->x_before + i, x);
                lanes_store(lists->y_before + i, y);
                lanes_store(lists->z_before + i, z);
                lanes_store(lists->vx_before + i, vx);
                lanes_store(lists->vy_before + i, vy);
                lanes_store(lists->vz_before + i, vz);
                lanes_store(lists->wx_before + i, wx);
                lanes_store(lists->wy_before + i, wy);
                lanes_store(lists->wz_before + i, wz);
            }
            const LANES(court_meeting_out) _o364 =
                LANES(court_meeting)(K(0.0), ends, touches);
            M meeting = _o364.meeting;
            const LANES(court_unslowed_out) _o365 =
                LANES(court_unslowed)();
            M slow = _o365.slow;
            const M _m366 = lanes_both(rows, meeting);
            if (lanes_any(_m366)) {
                const LANES(court_end_normal_out) _o367 =
                    LANES(court_end_normal)();
                V nx = _o367.nx;
                V ny = _o367.ny;
                V nz = _o367.nz;
                const LANES(court_here_out) _o368 =
                    LANES(court_here)(K(0.0), which);
                M here = _o368.here;
                const M _m369 = lanes_both(_m366, here);
                {
                    const LANES(court_ring_normal_out) _o370 =
                        LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m369, _o370.nx, nx);
                    ny = lanes_select(_m369, _o370.ny, ny);
                    nz = lanes_select(_m369, _o370.nz, nz);
                    const LANES(court_counted_out) _o371 =
                        LANES(court_counted)(count_0);
                    count_0 = lanes_select(_m369, _o371.count, count_0);
                }
                const LANES(court_here_out) _o372 =
                    LANES(court_here)(K(1.0), which);
                here = _o372.here;
                const M _m373 = lanes_both(_m366, here);
                {
                    const LANES(court_backboard_normal_out) _o374 =
                        LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m373, _o374.nx, nx);
                    ny = lanes_select(_m373, _o374.ny, ny);
                    nz = lanes_select(_m373, _o374.nz, nz);
                    const LANES(court_counted_out) _o375 =
                        LANES(court_counted)(count_1);
                    count_1 = lanes_select(_m373, _o375.count, count_1);
                }
                const LANES(court_here_out) _o376 =
                    LANES(court_here)(K(2.0), which);
                here = _o376.here;
                const M _m377 = lanes_both(_m366, here);
                {
                    const LANES(court_bridge_normal_out) _o378 =
                        LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m377, _o378.nx, nx);
                    ny = lanes_select(_m377, _o378.ny, ny);
                    nz = lanes_select(_m377, _o378.nz, nz);
                    const LANES(court_counted_out) _o379 =
                        LANES(court_counted)(count_2);
                    count_2 = lanes_select(_m377, _o379.count, count_2);
                }
                const LANES(court_untaken_out) _o380 =
                    LANES(court_untaken)();
                M struck_0 = _o380.mine;
                const LANES(court_ring_impact_taken_out) _o381 =
                    LANES(court_ring_impact_taken)(p_ring_restitution, p_ring_friction);
                V its_0_ring_impact = _o381.its_0;
                V its_1_ring_impact = _o381.its_1;
                {
                    const double *const _t383[][2] = {
                        {lists->p_ring_friction, lists->p_ring_restitution},
                        {lists->p_backboard_friction, lists->p_backboard_restitution},
                        {lists->p_bridge_friction, lists->p_bridge_restitution},
                    };
                    static const double _t384[][1] = {
                        {0.0},
                        {1.0},
                        {2.0},
                    };
                    for (size_t _k382 = 0; _k382 < 3; _k382++) {
                        const V own_1 = lanes_load(_t383[_k382][0] + (i & varying));
                        const V own_2 = lanes_load(_t383[_k382][1] + (i & varying));
                        const V own_index = K(_t384[_k382][0]);
                        const LANES(court_here_out) _o385 =
                            LANES(court_here)(own_index, which);
                        M here = _o385.here;
                        const M _m386 = lanes_both(_m366, here);
                        if (lanes_any(_m386)) {
                            const LANES(court_ring_impact_taken_out) _o387 =
                                LANES(court_ring_impact_taken)(own_2, own_1);
                            struck_0 = lanes_choose(_m386, _o387.mine, struck_0);
                            its_0_ring_impact = lanes_select(_m386, _o387.its_0, its_0_ring_impact);
                            its_1_ring_impact = lanes_select(_m386, _o387.its_1, its_1_ring_impact);
                        }
                    }
                }
                const M _m388 = lanes_both(_m366, struck_0);
                if (lanes_any(_m388)) {
                    const LANES(court_ring_impact_out) _o389 =
                        LANES(court_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, its_0_ring_impact, its_1_ring_impact, p_tangential_restitution, p_restitution_speed);
                    vx = lanes_select(_m388, _o389.vx, vx);
                    vy = lanes_select(_m388, _o389.vy, vy);
                    vz = lanes_select(_m388, _o389.vz, vz);
                    wx = lanes_select(_m388, _o389.wx, wx);
                    wy = lanes_select(_m388, _o389.wy, wy);
                    wz = lanes_select(_m388, _o389.wz, wz);
                }
                const M _m390 = lanes_both(_m366, touches);
                {
                    const LANES(court_touched_out) _o391 =
                        LANES(court_touched)(body, first, which);
                    first = lanes_select(_m390, _o391.first, first);
                    last = lanes_select(_m390, _o391.last, last);
                    const LANES(court_slowed_out) _o392 =
                        LANES(court_slowed)(p_ball_radius, p_gravity, nx, ny, nz, K(0.0), vx, vy, vz);
                    slow = lanes_choose(_m390, _o392.slow, slow);
                }
            }
            lanes_store(lists->clock + i, clock);
            lanes_store(lists->contacts + i, contacts);
            lanes_store(lists->count_0 + i, count_0);
            lanes_store(lists->count_1 + i, count_1);
            lanes_store(lists->count_2 + i, count_2);
            lanes_store(lists->first + i, first);
            lanes_store(lists->held + i, held);
            lanes_store(lists->last + i, last);
            lanes_store(lists->mode + i, mode);
            lanes_store(lists->outcome + i, outcome);
            lanes_store(lists->rolls + i, rolls);
            lanes_store(lists->through + i, through);
            lanes_store(lists->vx + i, vx);
            lanes_store(lists->vy + i, vy);
            lanes_store(lists->vz + i, vz);
            lanes_store(lists->wx + i, wx);
            lanes_store(lists->wy + i, wy);
            lanes_store(lists->wz + i, wz);
            lanes_store(lists->x + i, x);
            lanes_store(lists->y + i, y);
            lanes_store(lists->z + i, z);
            const M packed = lanes_both(rows, slow);
            if (lanes_any(packed)) {
                lanes_pack(lists->slow_row + slow_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->slow_held + slow_shots, packed, held);
                lanes_pack(lists->slow_mode + slow_shots, packed, mode);
                lanes_pack(lists->slow_outcome + slow_shots, packed, outcome);
                if (varying)
                    lanes_pack(lists->slow_p_backboard_friction + slow_shots, packed, p_backboard_friction);
                if (varying)
                    lanes_pack(lists->slow_p_backboard_restitution + slow_shots, packed, p_backboard_restitution);
                if (varying)
                    lanes_pack(lists->slow_p_ball_radius + slow_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->slow_p_board_bottom + slow_shots, packed, p_board_bottom);
                if (varying)
                    lanes_pack(lists->slow_p_board_distance + slow_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->slow_p_board_half_width + slow_shots, packed, p_board_half_width);
                if (varying)
                    lanes_pack(lists->slow_p_board_thickness + slow_shots, packed, p_board_thickness);
                if (varying)
                    lanes_pack(lists->slow_p_board_top + slow_shots, packed, p_board_top);
                if (varying)
                    lanes_pack(lists->slow_p_bridge_depth + slow_shots, packed, p_bridge_depth);
                if (varying)
                    lanes_pack(lists->slow_p_bridge_friction + slow_shots, packed, p_bridge_friction);
                if (varying)
                    lanes_pack(lists->slow_p_bridge_half_width + slow_shots, packed, p_bridge_half_width);
                if (varying)
                    lanes_pack(lists->slow_p_bridge_restitution + slow_shots, packed, p_bridge_restitution);
                if (varying)
                    lanes_pack(lists->slow_p_end_depth + slow_shots, packed, p_end_depth);
                if (varying)
                    lanes_pack(lists->slow_p_gravity + slow_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->slow_p_ring_friction + slow_shots, packed, p_ring_friction);
                if (varying)
                    lanes_pack(lists->slow_p_ring_radius + slow_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->slow_p_ring_restitution + slow_shots, packed, p_ring_restitution);
                if (varying)
                    lanes_pack(lists->slow_p_wire_radius + slow_shots, packed, p_wire_radius);
                lanes_pack(lists->slow_slip_left + slow_shots, packed, slip_left);
                lanes_pack(lists->slow_vx + slow_shots, packed, vx);
                lanes_pack(lists->slow_vy + slow_shots, packed, vy);
                lanes_pack(lists->slow_vz + slow_shots, packed, vz);
                lanes_pack(lists->slow_which + slow_shots, packed, which);
                lanes_pack(lists->slow_wx + slow_shots, packed, wx);
                lanes_pack(lists->slow_wy + slow_shots, packed, wy);
                lanes_pack(lists->slow_wz + slow_shots, packed, wz);
                lanes_pack(lists->slow_x + slow_shots, packed, x);
                lanes_pack(lists->slow_y + slow_shots, packed, y);
                lanes_pack(lists->slow_z + slow_shots, packed, z);
                slow_shots += lanes_many(packed);
            }
        }
        if (slow_shots)
            LANES(court_plain_slow)(lists, slow_shots, varying);
        for (size_t k = 0; k < slow_shots; k++) {
            const size_t row = (size_t)lists->slow_row[k];
            lists->held[row] = lists->slow_held[k];
            lists->mode[row] = lists->slow_mode[k];
            lists->outcome[row] = lists->slow_outcome[k];
            lists->slip_left[row] = lists->slow_slip_left[k];
        }
        }
        if (recording)
            for (size_t k = 0; k < shots; k++) {
                if (lists->body[k] < 0.0)
                    continue;
                const size_t shot = lists->shot[k], rows = COURT_LOG_ROWS * (size_t)job->max_contacts + 1;
                int32_t *used = job->results->event_counts + shot;
                court_event *event = job->results->events + shot * rows + (size_t)(*used)++;
                const int64_t body = (int64_t)lists->body[k], staying = body - COURT_SURFACES - 1;
                event->shot = (int64_t)shot;
                event->surface = staying < 0 ? body : staying / 2;
                event->kind = staying < -1 ? COURT_EVENT_IMPACT : staying < 0 ? COURT_EVENT_END : staying % 2 ? COURT_EVENT_LEAVE : COURT_EVENT_ROLL;
                event->time = lists->clock[k];
                event->before[0] = lists->x_before[k];
                event->after[0] = lists->x[k];
                event->before[1] = lists->y_before[k];
                event->after[1] = lists->y[k];
                event->before[2] = lists->z_before[k];
                event->after[2] = lists->z[k];
                event->before[3] = lists->vx_before[k];
                event->after[3] = lists->vx[k];
                event->before[4] = lists->vy_before[k];
                event->after[4] = lists->vy[k];
                event->before[5] = lists->vz_before[k];
                event->after[5] = lists->vz[k];
                event->before[6] = lists->wx_before[k];
                event->after[6] = lists->wx[k];
                event->before[7] = lists->wy_before[k];
                event->after[7] = lists->wy[k];
                event->before[8] = lists->wz_before[k];
                event->after[8] = lists->wz[k];
            }

        M going = lanes_nowhere();
        for (size_t i = 0; i < shots; i += LANES_WIDTH)
            going = lanes_either(going, lanes_both(lanes_first(shots - i), lanes_less(lanes_load(lists->outcome + i), K(0.0))));
        if (following && !lanes_any(going)) {
            LANES(court_plain_finish_all)(lists, shots, job);
            shots = 0;
            streams = 1;
            continue;
        }
        streams = 0;
        shots = LANES(court_plain_leave)(lists, 0, shots, job);
    }
}

/* Shots in flight, a column for each quantity, and the lists of those that need a longer look. */
typedef struct {
    _Alignas(64) size_t shot[2 * LANES_SHOTS];
    LANES(court_column) x; /* of the state */
    LANES(court_column) y; /* of the state */
    LANES(court_column) z; /* of the state */
    LANES(court_column) vx; /* of the state */
    LANES(court_column) vy; /* of the state */
    LANES(court_column) vz; /* of the state */
    LANES(court_column) wx; /* of the state */
    LANES(court_column) wy; /* of the state */
    LANES(court_column) wz; /* of the state */
    LANES(court_column) dx; /* carried error of x */
    LANES(court_column) dy; /* carried error of y */
    LANES(court_column) dz; /* carried error of z */
    LANES(court_column) dvx; /* carried error of vx */
    LANES(court_column) dvy; /* carried error of vy */
    LANES(court_column) dvz; /* carried error of vz */
    LANES(court_column) dwx; /* carried error of wx */
    LANES(court_column) dwy; /* carried error of wy */
    LANES(court_column) dwz; /* carried error of wz */
    LANES(court_column) clock; /* time of the last event, s since the release */
    LANES(court_column) clock_error; /* what the contacts' times were off by, summed */
    LANES(court_column) last; /* surface that was touched last, -1: none */
    LANES(court_column) first; /* body that was touched first, -1: none */
    LANES(court_column) contacts; /* how many contacts there were */
    LANES(court_column) count_0; /* contacts with ring */
    LANES(court_column) count_1; /* contacts with backboard */
    LANES(court_column) count_2; /* contacts with bridge */
    LANES(court_column) held; /* surface that it stays in contact with, -1: none */
    LANES(court_column) mode; /* 0: in flight; 1, 2, 3: contact begins, goes on, ends */
    LANES(court_column) circled; /* 1: it rolls on a ring, and does not leave since a turning point */
    LANES(court_column) assured; /* 1: its bounces on the surface it touched last end there */
    LANES(court_column) rolls; /* how many times it began to roll */
    LANES(court_column) slip_left; /* 1: its bounces ended with slip left, which friction cannot stop */
    LANES(court_column) grip_lost; /* when friction first was too little for it to roll */
    LANES(court_column) taut; /* by how much friction is too little, F² - mu² N², a step ago; inf: not known */
    LANES(court_column) taut_rate; /* its rate then */
    LANES(court_column) taut_clock; /* when that was */
    LANES(court_column) through; /* 1: it has fallen through the ring, -1: it came up through it */
    LANES(court_column) uncertain; /* 1: a decision lies within its rounding-error bound */
    LANES(court_column) position_claim; /* bound on the error at the end */
    LANES(court_column) velocity_claim; /* bound on the error at the end */
    LANES(court_column) spin_claim; /* bound on the error at the end */
    LANES(court_column) time_claim; /* bound on the error at the end */
    LANES(court_column) outcome; /* how it ended, -1: in flight */
    LANES(court_column) p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_gravity, p_end_depth, p_ring_restitution, p_backboard_restitution, p_bridge_restitution, p_ring_friction, p_backboard_friction, p_bridge_friction, p_tangential_restitution, p_restitution_speed;
    /* Shots whose balls stay in contact: they wait for one another, and then have rows of their
       own behind those of the others, so that all lanes work. */
    size_t waiting;
    size_t waiting_shot[LANES_SHOTS];
    LANES(court_column) waiting_x;
    LANES(court_column) waiting_y;
    LANES(court_column) waiting_z;
    LANES(court_column) waiting_vx;
    LANES(court_column) waiting_vy;
    LANES(court_column) waiting_vz;
    LANES(court_column) waiting_wx;
    LANES(court_column) waiting_wy;
    LANES(court_column) waiting_wz;
    LANES(court_column) waiting_dx;
    LANES(court_column) waiting_dy;
    LANES(court_column) waiting_dz;
    LANES(court_column) waiting_dvx;
    LANES(court_column) waiting_dvy;
    LANES(court_column) waiting_dvz;
    LANES(court_column) waiting_dwx;
    LANES(court_column) waiting_dwy;
    LANES(court_column) waiting_dwz;
    LANES(court_column) waiting_clock;
    LANES(court_column) waiting_clock_error;
    LANES(court_column) waiting_last;
    LANES(court_column) waiting_first;
    LANES(court_column) waiting_contacts;
    LANES(court_column) waiting_count_0;
    LANES(court_column) waiting_count_1;
    LANES(court_column) waiting_count_2;
    LANES(court_column) waiting_held;
    LANES(court_column) waiting_mode;
    LANES(court_column) waiting_circled;
    LANES(court_column) waiting_assured;
    LANES(court_column) waiting_rolls;
    LANES(court_column) waiting_slip_left;
    LANES(court_column) waiting_grip_lost;
    LANES(court_column) waiting_taut;
    LANES(court_column) waiting_taut_rate;
    LANES(court_column) waiting_taut_clock;
    LANES(court_column) waiting_through;
    LANES(court_column) waiting_uncertain;
    LANES(court_column) waiting_p_ball_radius, waiting_p_ring_radius, waiting_p_wire_radius, waiting_p_board_distance, waiting_p_board_half_width, waiting_p_board_bottom, waiting_p_board_top, waiting_p_board_thickness, waiting_p_bridge_half_width, waiting_p_bridge_depth, waiting_p_gravity, waiting_p_end_depth, waiting_p_ring_restitution, waiting_p_backboard_restitution, waiting_p_bridge_restitution, waiting_p_ring_friction, waiting_p_backboard_friction, waiting_p_bridge_friction, waiting_p_tangential_restitution, waiting_p_restitution_speed;
    LANES(court_column) x_before, y_before, z_before, vx_before, vy_before, vz_before, wx_before, wy_before, wz_before;
    LANES(court_column) body;
    LANES(court_column) began;
    LANES(court_column) doubt;
    LANES(court_column) extent;
    LANES(court_column) kept;
    LANES(court_column) late;
    LANES(court_column) limited;
    LANES(court_column) position_error;
    LANES(court_column) rests;
    LANES(court_column) rolling;
    LANES(court_column) speed;
    LANES(court_column) time_error;
    LANES(court_column) velocity_error;
    LANES(court_column) when;
    LANES(court_column) which;
    LANES(court_column) open_row;
    LANES(court_column) open_doubt;
    LANES(court_column) open_extent;
    LANES(court_column) open_last;
    LANES(court_column) open_late;
    LANES(court_column) open_p_ball_radius;
    LANES(court_column) open_p_gravity;
    LANES(court_column) open_p_ring_radius;
    LANES(court_column) open_p_wire_radius;
    LANES(court_column) open_pad;
    LANES(court_column) open_position_error;
    LANES(court_column) open_speed;
    LANES(court_column) open_until;
    LANES(court_column) open_velocity_error;
    LANES(court_column) open_vx;
    LANES(court_column) open_vy;
    LANES(court_column) open_vz;
    LANES(court_column) open_when;
    LANES(court_column) open_which;
    LANES(court_column) open_x;
    LANES(court_column) open_y;
    LANES(court_column) open_z;
    LANES(court_column) open_arrival;
    LANES(court_column) open_ceiling;
    LANES(court_column) open_certain;
    LANES(court_column) open_flat;
    LANES(court_column) open_latest;
    LANES(court_column) open_rho_start;
    LANES(court_column) open_searching;
    LANES(court_column) open_served;
    LANES(court_column) open_share;
    LANES(court_singles) open_short_t;
    LANES(court_column) open_since;
    LANES(court_column) open_tilt;
    LANES(court_column) open_leaping_row;
    LANES(court_column) open_leaping_leaping;
    LANES(court_column) open_leaping_p_ball_radius;
    LANES(court_column) open_leaping_p_gravity;
    LANES(court_column) open_leaping_p_ring_radius;
    LANES(court_column) open_leaping_p_wire_radius;
    LANES(court_singles) open_leaping_short_ceiling;
    LANES(court_singles) open_leaping_short_drift;
    LANES(court_singles) open_leaping_short_end;
    LANES(court_singles) open_leaping_short_flat;
    LANES(court_singles) open_leaping_short_grit;
    LANES(court_singles) open_leaping_short_high1;
    LANES(court_singles) open_leaping_short_high2;
    LANES(court_singles) open_leaping_short_jerk;
    LANES(court_singles) open_leaping_short_low1;
    LANES(court_singles) open_leaping_short_low2;
    LANES(court_singles) open_leaping_short_parting;
    LANES(court_singles) open_leaping_short_rate_margin;
    LANES(court_singles) open_leaping_short_rho_start;
    LANES(court_singles) open_leaping_short_steady;
    LANES(court_singles) open_leaping_short_swing;
    LANES(court_singles) open_leaping_short_t;
    LANES(court_singles) open_leaping_short_tilt;
    LANES(court_singles) open_leaping_short_vx;
    LANES(court_singles) open_leaping_short_vy;
    LANES(court_singles) open_leaping_short_vz;
    LANES(court_singles) open_leaping_short_x;
    LANES(court_singles) open_leaping_short_y;
    LANES(court_singles) open_leaping_short_z;
    LANES(court_column) open_searching_row;
    LANES(court_column) open_searching_arrival;
    LANES(court_column) open_searching_certain;
    LANES(court_column) open_searching_doubt;
    LANES(court_column) open_searching_extent;
    LANES(court_column) open_searching_last;
    LANES(court_column) open_searching_p_ball_radius;
    LANES(court_column) open_searching_p_gravity;
    LANES(court_column) open_searching_p_ring_radius;
    LANES(court_column) open_searching_p_wire_radius;
    LANES(court_column) open_searching_position_error;
    LANES(court_column) open_searching_share;
    LANES(court_column) open_searching_speed;
    LANES(court_column) open_searching_t;
    LANES(court_column) open_searching_until;
    LANES(court_column) open_searching_velocity_error;
    LANES(court_column) open_searching_vx;
    LANES(court_column) open_searching_vy;
    LANES(court_column) open_searching_vz;
    LANES(court_column) open_searching_x;
    LANES(court_column) open_searching_y;
    LANES(court_column) open_searching_z;
    LANES(court_column) open_searching_ceiling;
    LANES(court_column) open_searching_flat;
    LANES(court_column) open_searching_latest;
    LANES(court_column) open_searching_rho_start;
    LANES(court_column) open_searching_searching;
    LANES(court_column) open_searching_tilt;
    LANES(court_column) open_searching_searching_row;
    LANES(court_column) open_searching_searching_arrival;
    LANES(court_column) open_searching_searching_ceiling;
    LANES(court_column) open_searching_searching_certain;
    LANES(court_column) open_searching_searching_doubt;
    LANES(court_column) open_searching_searching_end;
    LANES(court_column) open_searching_searching_extent;
    LANES(court_column) open_searching_searching_flat;
    LANES(court_column) open_searching_searching_high0;
    LANES(court_column) open_searching_searching_high1;
    LANES(court_column) open_searching_searching_high2;
    LANES(court_column) open_searching_searching_last;
    LANES(court_column) open_searching_searching_latest;
    LANES(court_column) open_searching_searching_low0;
    LANES(court_column) open_searching_searching_low1;
    LANES(court_column) open_searching_searching_low2;
    LANES(court_column) open_searching_searching_p_ball_radius;
    LANES(court_column) open_searching_searching_p_gravity;
    LANES(court_column) open_searching_searching_p_ring_radius;
    LANES(court_column) open_searching_searching_p_wire_radius;
    LANES(court_column) open_searching_searching_position_error;
    LANES(court_column) open_searching_searching_rate_slack;
    LANES(court_column) open_searching_searching_rho_start;
    LANES(court_column) open_searching_searching_searching;
    LANES(court_column) open_searching_searching_share;
    LANES(court_column) open_searching_searching_speed;
    LANES(court_column) open_searching_searching_steady;
    LANES(court_column) open_searching_searching_swing;
    LANES(court_column) open_searching_searching_t;
    LANES(court_column) open_searching_searching_tilt;
    LANES(court_column) open_searching_searching_velocity_error;
    LANES(court_column) open_searching_searching_vx;
    LANES(court_column) open_searching_searching_vy;
    LANES(court_column) open_searching_searching_vz;
    LANES(court_column) open_searching_searching_x;
    LANES(court_column) open_searching_searching_y;
    LANES(court_column) open_searching_searching_z;
    LANES(court_column) open_arrives;
    LANES(court_column) open_leaving;
    LANES(court_column) open_rate;
    LANES(court_column) open_refining_row;
    LANES(court_column) open_refining_arrival;
    LANES(court_column) open_refining_ceiling;
    LANES(court_column) open_refining_certain;
    LANES(court_column) open_refining_leaving;
    LANES(court_column) open_refining_p_ball_radius;
    LANES(court_column) open_refining_p_gravity;
    LANES(court_column) open_refining_p_ring_radius;
    LANES(court_column) open_refining_p_wire_radius;
    LANES(court_column) open_refining_refining;
    LANES(court_column) open_refining_rho_start;
    LANES(court_column) open_refining_vx;
    LANES(court_column) open_refining_vy;
    LANES(court_column) open_refining_vz;
    LANES(court_column) open_refining_x;
    LANES(court_column) open_refining_y;
    LANES(court_column) open_refining_z;
    LANES(court_column) reachable_row;
    LANES(court_column) reachable_doubt;
    LANES(court_column) reachable_extent;
    LANES(court_column) reachable_last;
    LANES(court_column) reachable_late;
    LANES(court_column) reachable_p_ball_radius;
    LANES(court_column) reachable_p_board_bottom;
    LANES(court_column) reachable_p_board_distance;
    LANES(court_column) reachable_p_board_half_width;
    LANES(court_column) reachable_p_board_thickness;
    LANES(court_column) reachable_p_board_top;
    LANES(court_column) reachable_p_gravity;
    LANES(court_column) reachable_position_error;
    LANES(court_column) reachable_speed;
    LANES(court_column) reachable_velocity_error;
    LANES(court_column) reachable_vx;
    LANES(court_column) reachable_vy;
    LANES(court_column) reachable_vz;
    LANES(court_column) reachable_when;
    LANES(court_column) reachable_which;
    LANES(court_column) reachable_x;
    LANES(court_column) reachable_y;
    LANES(court_column) reachable_z;
    LANES(court_column) reachable_arrival;
    LANES(court_column) reachable_ceiling;
    LANES(court_column) reachable_certain;
    LANES(court_column) reachable_flat;
    LANES(court_column) reachable_latest;
    LANES(court_column) reachable_searching;
    LANES(court_column) reachable_t;
    LANES(court_column) reachable_tilt;
    LANES(court_column) reachable_searching_row;
    LANES(court_column) reachable_searching_arrival;
    LANES(court_column) reachable_searching_ceiling;
    LANES(court_column) reachable_searching_certain;
    LANES(court_column) reachable_searching_doubt;
    LANES(court_column) reachable_searching_end;
    LANES(court_column) reachable_searching_extent;
    LANES(court_column) reachable_searching_flat;
    LANES(court_column) reachable_searching_high0;
    LANES(court_column) reachable_searching_high1;
    LANES(court_column) reachable_searching_last;
    LANES(court_column) reachable_searching_latest;
    LANES(court_column) reachable_searching_low0;
    LANES(court_column) reachable_searching_low1;
    LANES(court_column) reachable_searching_p_ball_radius;
    LANES(court_column) reachable_searching_p_board_bottom;
    LANES(court_column) reachable_searching_p_board_distance;
    LANES(court_column) reachable_searching_p_board_half_width;
    LANES(court_column) reachable_searching_p_board_thickness;
    LANES(court_column) reachable_searching_p_board_top;
    LANES(court_column) reachable_searching_p_gravity;
    LANES(court_column) reachable_searching_position_error;
    LANES(court_column) reachable_searching_rate_slack;
    LANES(court_column) reachable_searching_searching;
    LANES(court_column) reachable_searching_share;
    LANES(court_column) reachable_searching_speed;
    LANES(court_column) reachable_searching_t;
    LANES(court_column) reachable_searching_tilt;
    LANES(court_column) reachable_searching_velocity_error;
    LANES(court_column) reachable_searching_vx;
    LANES(court_column) reachable_searching_vy;
    LANES(court_column) reachable_searching_vz;
    LANES(court_column) reachable_searching_x;
    LANES(court_column) reachable_searching_y;
    LANES(court_column) reachable_searching_z;
    LANES(court_column) reachable_arrives;
    LANES(court_column) reachable_leaving;
    LANES(court_column) reachable_rate;
    LANES(court_column) reachable_refining_row;
    LANES(court_column) reachable_refining_arrival;
    LANES(court_column) reachable_refining_ceiling;
    LANES(court_column) reachable_refining_certain;
    LANES(court_column) reachable_refining_leaving;
    LANES(court_column) reachable_refining_p_ball_radius;
    LANES(court_column) reachable_refining_p_board_bottom;
    LANES(court_column) reachable_refining_p_board_distance;
    LANES(court_column) reachable_refining_p_board_half_width;
    LANES(court_column) reachable_refining_p_board_thickness;
    LANES(court_column) reachable_refining_p_board_top;
    LANES(court_column) reachable_refining_p_gravity;
    LANES(court_column) reachable_refining_refining;
    LANES(court_column) reachable_refining_vx;
    LANES(court_column) reachable_refining_vy;
    LANES(court_column) reachable_refining_vz;
    LANES(court_column) reachable_refining_x;
    LANES(court_column) reachable_refining_y;
    LANES(court_column) reachable_refining_z;
    LANES(court_column) reachable_p_bridge_depth;
    LANES(court_column) reachable_p_bridge_half_width;
    LANES(court_column) reachable_p_ring_radius;
    LANES(court_column) reachable_p_wire_radius;
    LANES(court_column) reachable_searching_p_bridge_depth;
    LANES(court_column) reachable_searching_p_bridge_half_width;
    LANES(court_column) reachable_searching_p_ring_radius;
    LANES(court_column) reachable_searching_p_wire_radius;
    LANES(court_column) reachable_refining_p_bridge_depth;
    LANES(court_column) reachable_refining_p_bridge_half_width;
    LANES(court_column) reachable_refining_p_ring_radius;
    LANES(court_column) reachable_refining_p_wire_radius;
    LANES(court_column) kept_row;
    LANES(court_column) kept_circled;
    LANES(court_column) kept_clock;
    LANES(court_column) kept_clock_error;
    LANES(court_column) kept_dvx;
    LANES(court_column) kept_dvy;
    LANES(court_column) kept_dvz;
    LANES(court_column) kept_dwx;
    LANES(court_column) kept_dwy;
    LANES(court_column) kept_dwz;
    LANES(court_column) kept_dx;
    LANES(court_column) kept_dy;
    LANES(court_column) kept_dz;
    LANES(court_column) kept_grip_lost;
    LANES(court_column) kept_held;
    LANES(court_column) kept_mode;
    LANES(court_column) kept_p_backboard_friction;
    LANES(court_column) kept_p_ball_radius;
    LANES(court_column) kept_p_board_bottom;
    LANES(court_column) kept_p_board_distance;
    LANES(court_column) kept_p_board_half_width;
    LANES(court_column) kept_p_board_thickness;
    LANES(court_column) kept_p_board_top;
    LANES(court_column) kept_p_bridge_depth;
    LANES(court_column) kept_p_bridge_friction;
    LANES(court_column) kept_p_bridge_half_width;
    LANES(court_column) kept_p_end_depth;
    LANES(court_column) kept_p_gravity;
    LANES(court_column) kept_p_ring_friction;
    LANES(court_column) kept_p_ring_radius;
    LANES(court_column) kept_p_wire_radius;
    LANES(court_column) kept_position_error;
    LANES(court_column) kept_rests;
    LANES(court_column) kept_taut;
    LANES(court_column) kept_taut_clock;
    LANES(court_column) kept_taut_rate;
    LANES(court_column) kept_through;
    LANES(court_column) kept_velocity_error;
    LANES(court_column) kept_vx;
    LANES(court_column) kept_vy;
    LANES(court_column) kept_vz;
    LANES(court_column) kept_when;
    LANES(court_column) kept_wx;
    LANES(court_column) kept_wy;
    LANES(court_column) kept_wz;
    LANES(court_column) kept_x;
    LANES(court_column) kept_y;
    LANES(court_column) kept_z;
    LANES(court_column) kept_began;
    LANES(court_column) kept_circling;
    LANES(court_column) kept_doubt;
    LANES(court_column) kept_late;
    LANES(court_column) kept_leaves;
    LANES(court_column) kept_lift;
    LANES(court_column) kept_per_reach;
    LANES(court_column) kept_rolling;
    LANES(court_column) kept_snap;
    LANES(court_column) kept_surge;
    LANES(court_column) kept_which;
    LANES(court_column) kept_rolling_row;
    LANES(court_column) kept_rolling_bent_x;
    LANES(court_column) kept_rolling_bent_y;
    LANES(court_column) kept_rolling_bent_z;
    LANES(court_column) kept_rolling_clock;
    LANES(court_column) kept_rolling_clock_error;
    LANES(court_column) kept_rolling_doubt;
    LANES(court_column) kept_rolling_dvx;
    LANES(court_column) kept_rolling_dvy;
    LANES(court_column) kept_rolling_dvz;
    LANES(court_column) kept_rolling_dwx;
    LANES(court_column) kept_rolling_dwy;
    LANES(court_column) kept_rolling_dwz;
    LANES(court_column) kept_rolling_dx;
    LANES(court_column) kept_rolling_dy;
    LANES(court_column) kept_rolling_dz;
    LANES(court_column) kept_rolling_grip_lost;
    LANES(court_column) kept_rolling_held;
    LANES(court_column) kept_rolling_late;
    LANES(court_column) kept_rolling_nx;
    LANES(court_column) kept_rolling_ny;
    LANES(court_column) kept_rolling_nz;
    LANES(court_column) kept_rolling_p_backboard_friction;
    LANES(court_column) kept_rolling_p_ball_radius;
    LANES(court_column) kept_rolling_p_board_bottom;
    LANES(court_column) kept_rolling_p_board_distance;
    LANES(court_column) kept_rolling_p_board_half_width;
    LANES(court_column) kept_rolling_p_board_thickness;
    LANES(court_column) kept_rolling_p_board_top;
    LANES(court_column) kept_rolling_p_bridge_depth;
    LANES(court_column) kept_rolling_p_bridge_friction;
    LANES(court_column) kept_rolling_p_bridge_half_width;
    LANES(court_column) kept_rolling_p_end_depth;
    LANES(court_column) kept_rolling_p_gravity;
    LANES(court_column) kept_rolling_p_ring_radius;
    LANES(court_column) kept_rolling_p_wire_radius;
    LANES(court_column) kept_rolling_per_reach;
    LANES(court_column) kept_rolling_rolling;
    LANES(court_column) kept_rolling_taut;
    LANES(court_column) kept_rolling_taut_clock;
    LANES(court_column) kept_rolling_taut_rate;
    LANES(court_column) kept_rolling_through;
    LANES(court_column) kept_rolling_vx;
    LANES(court_column) kept_rolling_vy;
    LANES(court_column) kept_rolling_vz;
    LANES(court_column) kept_rolling_which;
    LANES(court_column) kept_rolling_wx;
    LANES(court_column) kept_rolling_wy;
    LANES(court_column) kept_rolling_wz;
    LANES(court_column) kept_rolling_x;
    LANES(court_column) kept_rolling_y;
    LANES(court_column) kept_rolling_z;
    LANES(court_column) kept_circling_row;
    LANES(court_column) kept_circling_circled;
    LANES(court_column) kept_circling_circling;
    LANES(court_column) kept_circling_clock;
    LANES(court_column) kept_circling_clock_error;
    LANES(court_column) kept_circling_doubt;
    LANES(court_column) kept_circling_dvx;
    LANES(court_column) kept_circling_dvy;
    LANES(court_column) kept_circling_dvz;
    LANES(court_column) kept_circling_dwx;
    LANES(court_column) kept_circling_dwy;
    LANES(court_column) kept_circling_dwz;
    LANES(court_column) kept_circling_dx;
    LANES(court_column) kept_circling_dy;
    LANES(court_column) kept_circling_dz;
    LANES(court_column) kept_circling_grip_lost;
    LANES(court_column) kept_circling_late;
    LANES(court_column) kept_circling_p_ball_radius;
    LANES(court_column) kept_circling_p_board_bottom;
    LANES(court_column) kept_circling_p_board_distance;
    LANES(court_column) kept_circling_p_board_half_width;
    LANES(court_column) kept_circling_p_board_thickness;
    LANES(court_column) kept_circling_p_board_top;
    LANES(court_column) kept_circling_p_bridge_depth;
    LANES(court_column) kept_circling_p_bridge_half_width;
    LANES(court_column) kept_circling_p_end_depth;
    LANES(court_column) kept_circling_p_gravity;
    LANES(court_column) kept_circling_p_ring_friction;
    LANES(court_column) kept_circling_p_ring_radius;
    LANES(court_column) kept_circling_p_wire_radius;
    LANES(court_column) kept_circling_taut;
    LANES(court_column) kept_circling_taut_clock;
    LANES(court_column) kept_circling_taut_rate;
    LANES(court_column) kept_circling_through;
    LANES(court_column) kept_circling_vx;
    LANES(court_column) kept_circling_vy;
    LANES(court_column) kept_circling_vz;
    LANES(court_column) kept_circling_which;
    LANES(court_column) kept_circling_wx;
    LANES(court_column) kept_circling_wy;
    LANES(court_column) kept_circling_wz;
    LANES(court_column) kept_circling_x;
    LANES(court_column) kept_circling_y;
    LANES(court_column) kept_circling_z;
    LANES(court_column) kept_leaves_row;
    LANES(court_column) kept_leaves_clock_error;
    LANES(court_column) kept_leaves_doubt;
    LANES(court_column) kept_leaves_dvx;
    LANES(court_column) kept_leaves_dvy;
    LANES(court_column) kept_leaves_dvz;
    LANES(court_column) kept_leaves_dwx;
    LANES(court_column) kept_leaves_dwy;
    LANES(court_column) kept_leaves_dwz;
    LANES(court_column) kept_leaves_dx;
    LANES(court_column) kept_leaves_dy;
    LANES(court_column) kept_leaves_dz;
    LANES(court_column) kept_leaves_held;
    LANES(court_column) kept_leaves_lift;
    LANES(court_column) kept_leaves_p_ball_radius;
    LANES(court_column) kept_leaves_p_board_bottom;
    LANES(court_column) kept_leaves_p_board_distance;
    LANES(court_column) kept_leaves_p_board_half_width;
    LANES(court_column) kept_leaves_p_board_thickness;
    LANES(court_column) kept_leaves_p_board_top;
    LANES(court_column) kept_leaves_p_bridge_depth;
    LANES(court_column) kept_leaves_p_bridge_half_width;
    LANES(court_column) kept_leaves_p_end_depth;
    LANES(court_column) kept_leaves_p_gravity;
    LANES(court_column) kept_leaves_p_ring_radius;
    LANES(court_column) kept_leaves_p_wire_radius;
    LANES(court_column) kept_leaves_per_reach;
    LANES(court_column) kept_leaves_snap;
    LANES(court_column) kept_leaves_surge;
    LANES(court_column) kept_leaves_vx;
    LANES(court_column) kept_leaves_vy;
    LANES(court_column) kept_leaves_vz;
    LANES(court_column) kept_leaves_x;
    LANES(court_column) kept_leaves_y;
    LANES(court_column) kept_leaves_z;
    LANES(court_column) kept_leaves_position_error;
    LANES(court_column) kept_leaves_velocity_error;
    LANES(court_column) kept_leaves_when;
    LANES(court_column) kept_leaves_which;
    LANES(court_column) hopped;
    LANES(court_column) slow_row;
    LANES(court_column) slow_assured;
    LANES(court_column) slow_held;
    LANES(court_column) slow_mode;
    LANES(court_column) slow_outcome;
    LANES(court_column) slow_p_backboard_friction;
    LANES(court_column) slow_p_backboard_restitution;
    LANES(court_column) slow_p_ball_radius;
    LANES(court_column) slow_p_board_bottom;
    LANES(court_column) slow_p_board_distance;
    LANES(court_column) slow_p_board_half_width;
    LANES(court_column) slow_p_board_thickness;
    LANES(court_column) slow_p_board_top;
    LANES(court_column) slow_p_bridge_depth;
    LANES(court_column) slow_p_bridge_friction;
    LANES(court_column) slow_p_bridge_half_width;
    LANES(court_column) slow_p_bridge_restitution;
    LANES(court_column) slow_p_end_depth;
    LANES(court_column) slow_p_gravity;
    LANES(court_column) slow_p_ring_friction;
    LANES(court_column) slow_p_ring_radius;
    LANES(court_column) slow_p_ring_restitution;
    LANES(court_column) slow_p_wire_radius;
    LANES(court_column) slow_slip_left;
    LANES(court_column) slow_uncertain;
    LANES(court_column) slow_velocity_error;
    LANES(court_column) slow_vx;
    LANES(court_column) slow_vy;
    LANES(court_column) slow_vz;
    LANES(court_column) slow_which;
    LANES(court_column) slow_wx;
    LANES(court_column) slow_wy;
    LANES(court_column) slow_wz;
    LANES(court_column) slow_x;
    LANES(court_column) slow_y;
    LANES(court_column) slow_z;
} LANES(court_bounded_lists);

/* Put the next shots into rows, from one on. */
LANES_INLINE void LANES(court_bounded_begin)(LANES(court_bounded_lists) *lists, size_t row, size_t shots, const court_job *job, size_t start)
{
    const double *state = job->states + COURT_STATE * start;
    size_t k = 0;
    for (; k + LANES_WIDTH <= shots; k += LANES_WIDTH) {
        double *const columns[] = {
            lists->x + row + k,
            lists->y + row + k,
            lists->z + row + k,
            lists->vx + row + k,
            lists->vy + row + k,
            lists->vz + row + k,
            lists->wx + row + k,
            lists->wy + row + k,
            lists->wz + row + k,
        };
        lanes_columns(columns, state + COURT_STATE * k, COURT_STATE);
    }
    for (; k < shots; k++) {
        lists->x[row + k] = state[COURT_STATE * k + 0];
        lists->y[row + k] = state[COURT_STATE * k + 1];
        lists->z[row + k] = state[COURT_STATE * k + 2];
        lists->vx[row + k] = state[COURT_STATE * k + 3];
        lists->vy[row + k] = state[COURT_STATE * k + 4];
        lists->vz[row + k] = state[COURT_STATE * k + 5];
        lists->wx[row + k] = state[COURT_STATE * k + 6];
        lists->wy[row + k] = state[COURT_STATE * k + 7];
        lists->wz[row + k] = state[COURT_STATE * k + 8];
    }
    if (job->varying)
        for (k = 0; k < shots; k++) {
            lists->p_ball_radius[row + k] = job->parameters[0][job->strides[0] * (int64_t)(start + k)];
            lists->p_ring_radius[row + k] = job->parameters[1][job->strides[1] * (int64_t)(start + k)];
            lists->p_wire_radius[row + k] = job->parameters[2][job->strides[2] * (int64_t)(start + k)];
            lists->p_board_distance[row + k] = job->parameters[3][job->strides[3] * (int64_t)(start + k)];
            lists->p_board_half_width[row + k] = job->parameters[4][job->strides[4] * (int64_t)(start + k)];
            lists->p_board_bottom[row + k] = job->parameters[5][job->strides[5] * (int64_t)(start + k)];
            lists->p_board_top[row + k] = job->parameters[6][job->strides[6] * (int64_t)(start + k)];
            lists->p_board_thickness[row + k] = job->parameters[7][job->strides[7] * (int64_t)(start + k)];
            lists->p_bridge_half_width[row + k] = job->parameters[8][job->strides[8] * (int64_t)(start + k)];
            lists->p_bridge_depth[row + k] = job->parameters[9][job->strides[9] * (int64_t)(start + k)];
            lists->p_gravity[row + k] = job->parameters[10][job->strides[10] * (int64_t)(start + k)];
            lists->p_end_depth[row + k] = job->parameters[11][job->strides[11] * (int64_t)(start + k)];
            lists->p_ring_restitution[row + k] = job->parameters[12][job->strides[12] * (int64_t)(start + k)];
            lists->p_backboard_restitution[row + k] = job->parameters[13][job->strides[13] * (int64_t)(start + k)];
            lists->p_bridge_restitution[row + k] = job->parameters[14][job->strides[14] * (int64_t)(start + k)];
            lists->p_ring_friction[row + k] = job->parameters[15][job->strides[15] * (int64_t)(start + k)];
            lists->p_backboard_friction[row + k] = job->parameters[16][job->strides[16] * (int64_t)(start + k)];
            lists->p_bridge_friction[row + k] = job->parameters[17][job->strides[17] * (int64_t)(start + k)];
            lists->p_tangential_restitution[row + k] = job->parameters[18][job->strides[18] * (int64_t)(start + k)];
            lists->p_restitution_speed[row + k] = job->parameters[19][job->strides[19] * (int64_t)(start + k)];
        }
    for (k = 0; k < shots; k++)
        lists->shot[row + k] = start + k;
    for (k = 0; k < shots; k += LANES_WIDTH) {
        lanes_store(lists->dx + row + k, K(0.0));
        lanes_store(lists->dy + row + k, K(0.0));
        lanes_store(lists->dz + row + k, K(0.0));
        lanes_store(lists->dvx + row + k, K(0.0));
        lanes_store(lists->dvy + row + k, K(0.0));
        lanes_store(lists->dvz + row + k, K(0.0));
        lanes_store(lists->dwx + row + k, K(0.0));
        lanes_store(lists->dwy + row + k, K(0.0));
        lanes_store(lists->dwz + row + k, K(0.0));
        lanes_store(lists->clock + row + k, K(0.0));
        lanes_store(lists->clock_error + row + k, K(0.0));
        lanes_store(lists->first + row + k, K(-1.0));
        lanes_store(lists->contacts + row + k, K(0.0));
        lanes_store(lists->count_0 + row + k, K(0.0));
        lanes_store(lists->count_1 + row + k, K(0.0));
        lanes_store(lists->count_2 + row + k, K(0.0));
        lanes_store(lists->held + row + k, K(-1.0));
        lanes_store(lists->mode + row + k, K(0.0));
        lanes_store(lists->circled + row + k, K(0.0));
        lanes_store(lists->assured + row + k, K(0.0));
        lanes_store(lists->rolls + row + k, K(0.0));
        lanes_store(lists->slip_left + row + k, K(0.0));
        lanes_store(lists->grip_lost + row + k, K(INFINITY));
        lanes_store(lists->taut + row + k, K(INFINITY));
        lanes_store(lists->taut_rate + row + k, K(0.0));
        lanes_store(lists->taut_clock + row + k, K(0.0));
        lanes_store(lists->through + row + k, K(0.0));
        lanes_store(lists->uncertain + row + k, K(0.0));
        lanes_store(lists->position_claim + row + k, K(0.0));
        lanes_store(lists->velocity_claim + row + k, K(0.0));
        lanes_store(lists->spin_claim + row + k, K(0.0));
        lanes_store(lists->time_claim + row + k, K(0.0));
        lanes_store(lists->outcome + row + k, K(-1.0));
        lanes_store(lists->last + row + k, K(-1.0));
    }
    if (job->leaving)
        for (k = 0; k < shots; k++)
            lists->last[row + k] = (double)job->leaving[start + k];
    if (job->results->events)
        memset(job->results->event_counts + start, 0, shots * sizeof(int32_t));
}

/* Write the results of the shots in rows that follow one another, none of them invalid. */
LANES_INLINE void LANES(court_bounded_finish_all)(const LANES(court_bounded_lists) *lists, size_t shots, const court_job *job)
{
    const court_results *out = job->results;
    const size_t start = lists->shot[0];
    if (out->outcome)
        for (size_t k = 0; k < shots; k++) {
            out->outcome[start + k] = (uint8_t)(int32_t)lists->outcome[k];
        }
    if (out->contacts)
        for (size_t k = 0; k < shots; k++) {
            out->contacts[start + k] = (int32_t)(int32_t)lists->contacts[k];
        }
    if (out->counts)
        for (size_t k = 0; k < shots; k++) {
            out->counts[3 * (start + k) + 0] = (int32_t)(int32_t)lists->count_0[k];
            out->counts[3 * (start + k) + 1] = (int32_t)(int32_t)lists->count_1[k];
            out->counts[3 * (start + k) + 2] = (int32_t)(int32_t)lists->count_2[k];
        }
    if (out->first)
        for (size_t k = 0; k < shots; k++) {
            out->first[start + k] = (int8_t)(int32_t)lists->first[k];
        }
    if (out->time)
        for (size_t k = 0; k < shots; k++) {
            out->time[start + k] = (double)lists->clock[k];
        }
    if (out->state) {
        /* As many rows as there are lanes fill whole lines: they go past the caches. */
        double rows[COURT_STATE * LANES_WIDTH];
        for (size_t k = 0; k < shots; k += LANES_WIDTH) {
            const double *const columns[] = {
                lists->x + k,
                lists->y + k,
                lists->z + k,
                lists->vx + k,
                lists->vy + k,
                lists->vz + k,
                lists->wx + k,
                lists->wy + k,
                lists->wz + k,
            };
            const size_t some = shots - k < LANES_WIDTH ? shots - k : LANES_WIDTH;
            lanes_rows(rows, columns, COURT_STATE);
            stream(out->state + COURT_STATE * (start + k), rows, COURT_STATE * some);
        }
    }
    if (out->rolls)
        for (size_t k = 0; k < shots; k++) {
            out->rolls[start + k] = (int32_t)(int32_t)lists->rolls[k];
        }
    if (out->slip_left)
        for (size_t k = 0; k < shots; k++) {
            out->slip_left[start + k] = (uint8_t)(int32_t)lists->slip_left[k];
        }
    if (out->grip_lost)
        for (size_t k = 0; k < shots; k++) {
            out->grip_lost[start + k] = (double)lists->grip_lost[k];
        }
    if (out->time_error)
        for (size_t k = 0; k < shots; k++) {
            out->time_error[start + k] = (double)lists->time_claim[k];
        }
    if (out->state_error)
        for (size_t k = 0; k < shots; k++) {
            out->state_error[3 * (start + k) + 0] = (double)lists->position_claim[k];
            out->state_error[3 * (start + k) + 1] = (double)lists->velocity_claim[k];
            out->state_error[3 * (start + k) + 2] = (double)lists->spin_claim[k];
        }
    if (out->uncertain)
        for (size_t k = 0; k < shots; k++) {
            out->uncertain[start + k] = (uint8_t)(int32_t)lists->uncertain[k];
        }
}

/* Write the results of the shot in a row. */
LANES_INLINE void LANES(court_bounded_finish)(const LANES(court_bounded_lists) *lists, size_t row, const court_job *job)
{
    const court_results *out = job->results;
    const size_t shot = lists->shot[row];
    const int invalid = (int)lists->outcome[row] == COURT_OUTCOME_INVALID;
    if (out->outcome) {
        out->outcome[shot] = (uint8_t)lists->outcome[row];
    }
    if (out->contacts) {
        out->contacts[shot] = (int32_t)lists->contacts[row];
    }
    if (out->counts) {
        out->counts[3 * shot + 0] = (int32_t)lists->count_0[row];
        out->counts[3 * shot + 1] = (int32_t)lists->count_1[row];
        out->counts[3 * shot + 2] = (int32_t)lists->count_2[row];
    }
    if (out->first) {
        out->first[shot] = (int8_t)lists->first[row];
    }
    if (out->time) {
        out->time[shot] = invalid ? NAN : lists->clock[row];
    }
    if (out->state) {
        out->state[9 * shot + 0] = invalid ? NAN : lists->x[row];
        out->state[9 * shot + 1] = invalid ? NAN : lists->y[row];
        out->state[9 * shot + 2] = invalid ? NAN : lists->z[row];
        out->state[9 * shot + 3] = invalid ? NAN : lists->vx[row];
        out->state[9 * shot + 4] = invalid ? NAN : lists->vy[row];
        out->state[9 * shot + 5] = invalid ? NAN : lists->vz[row];
        out->state[9 * shot + 6] = invalid ? NAN : lists->wx[row];
        out->state[9 * shot + 7] = invalid ? NAN : lists->wy[row];
        out->state[9 * shot + 8] = invalid ? NAN : lists->wz[row];
    }
    if (out->rolls) {
        out->rolls[shot] = (int32_t)lists->rolls[row];
    }
    if (out->slip_left) {
        out->slip_left[shot] = (uint8_t)lists->slip_left[row];
    }
    if (out->grip_lost) {
        out->grip_lost[shot] = invalid ? NAN : lists->grip_lost[row];
    }
    if (out->time_error) {
        out->time_error[shot] = invalid ? NAN : lists->time_claim[row];
    }
    if (out->state_error) {
        out->state_error[3 * shot + 0] = invalid ? NAN : lists->position_claim[row];
        out->state_error[3 * shot + 1] = invalid ? NAN : lists->velocity_claim[row];
        out->state_error[3 * shot + 2] = invalid ? NAN : lists->spin_claim[row];
    }
    if (out->uncertain) {
        out->uncertain[shot] = (uint8_t)lists->uncertain[row];
    }
}

/* Have the shots of some lanes wait: their rows are free. */
LANES_INLINE void LANES(court_bounded_wait)(LANES(court_bounded_lists) *lists, size_t row, M who, const court_job *job)
{
    size_t to = lists->waiting;
    for (unsigned bits = lanes_bits(who); bits; bits &= bits - 1)
        lists->waiting_shot[to++] = lists->shot[row + (size_t)LANES_LOWEST(bits)];
    lanes_pack(lists->waiting_x + lists->waiting, who, lanes_load(lists->x + row));
    lanes_pack(lists->waiting_y + lists->waiting, who, lanes_load(lists->y + row));
    lanes_pack(lists->waiting_z + lists->waiting, who, lanes_load(lists->z + row));
    lanes_pack(lists->waiting_vx + lists->waiting, who, lanes_load(lists->vx + row));
    lanes_pack(lists->waiting_vy + lists->waiting, who, lanes_load(lists->vy + row));
    lanes_pack(lists->waiting_vz + lists->waiting, who, lanes_load(lists->vz + row));
    lanes_pack(lists->waiting_wx + lists->waiting, who, lanes_load(lists->wx + row));
    lanes_pack(lists->waiting_wy + lists->waiting, who, lanes_load(lists->wy + row));
    lanes_pack(lists->waiting_wz + lists->waiting, who, lanes_load(lists->wz + row));
    lanes_pack(lists->waiting_dx + lists->waiting, who, lanes_load(lists->dx + row));
    lanes_pack(lists->waiting_dy + lists->waiting, who, lanes_load(lists->dy + row));
    lanes_pack(lists->waiting_dz + lists->waiting, who, lanes_load(lists->dz + row));
    lanes_pack(lists->waiting_dvx + lists->waiting, who, lanes_load(lists->dvx + row));
    lanes_pack(lists->waiting_dvy + lists->waiting, who, lanes_load(lists->dvy + row));
    lanes_pack(lists->waiting_dvz + lists->waiting, who, lanes_load(lists->dvz + row));
    lanes_pack(lists->waiting_dwx + lists->waiting, who, lanes_load(lists->dwx + row));
    lanes_pack(lists->waiting_dwy + lists->waiting, who, lanes_load(lists->dwy + row));
    lanes_pack(lists->waiting_dwz + lists->waiting, who, lanes_load(lists->dwz + row));
    lanes_pack(lists->waiting_clock + lists->waiting, who, lanes_load(lists->clock + row));
    lanes_pack(lists->waiting_clock_error + lists->waiting, who, lanes_load(lists->clock_error + row));
    lanes_pack(lists->waiting_last + lists->waiting, who, lanes_load(lists->last + row));
    lanes_pack(lists->waiting_first + lists->waiting, who, lanes_load(lists->first + row));
    lanes_pack(lists->waiting_contacts + lists->waiting, who, lanes_load(lists->contacts + row));
    lanes_pack(lists->waiting_count_0 + lists->waiting, who, lanes_load(lists->count_0 + row));
    lanes_pack(lists->waiting_count_1 + lists->waiting, who, lanes_load(lists->count_1 + row));
    lanes_pack(lists->waiting_count_2 + lists->waiting, who, lanes_load(lists->count_2 + row));
    lanes_pack(lists->waiting_held + lists->waiting, who, lanes_load(lists->held + row));
    lanes_pack(lists->waiting_mode + lists->waiting, who, lanes_load(lists->mode + row));
    lanes_pack(lists->waiting_circled + lists->waiting, who, lanes_load(lists->circled + row));
    lanes_pack(lists->waiting_assured + lists->waiting, who, lanes_load(lists->assured + row));
    lanes_pack(lists->waiting_rolls + lists->waiting, who, lanes_load(lists->rolls + row));
    lanes_pack(lists->waiting_slip_left + lists->waiting, who, lanes_load(lists->slip_left + row));
    lanes_pack(lists->waiting_grip_lost + lists->waiting, who, lanes_load(lists->grip_lost + row));
    lanes_pack(lists->waiting_taut + lists->waiting, who, lanes_load(lists->taut + row));
    lanes_pack(lists->waiting_taut_rate + lists->waiting, who, lanes_load(lists->taut_rate + row));
    lanes_pack(lists->waiting_taut_clock + lists->waiting, who, lanes_load(lists->taut_clock + row));
    lanes_pack(lists->waiting_through + lists->waiting, who, lanes_load(lists->through + row));
    lanes_pack(lists->waiting_uncertain + lists->waiting, who, lanes_load(lists->uncertain + row));
    if (job->varying) {
        lanes_pack(lists->waiting_p_ball_radius + lists->waiting, who, lanes_load(lists->p_ball_radius + row));
        lanes_pack(lists->waiting_p_ring_radius + lists->waiting, who, lanes_load(lists->p_ring_radius + row));
        lanes_pack(lists->waiting_p_wire_radius + lists->waiting, who, lanes_load(lists->p_wire_radius + row));
        lanes_pack(lists->waiting_p_board_distance + lists->waiting, who, lanes_load(lists->p_board_distance + row));
        lanes_pack(lists->waiting_p_board_half_width + lists->waiting, who, lanes_load(lists->p_board_half_width + row));
        lanes_pack(lists->waiting_p_board_bottom + lists->waiting, who, lanes_load(lists->p_board_bottom + row));
        lanes_pack(lists->waiting_p_board_top + lists->waiting, who, lanes_load(lists->p_board_top + row));
        lanes_pack(lists->waiting_p_board_thickness + lists->waiting, who, lanes_load(lists->p_board_thickness + row));
        lanes_pack(lists->waiting_p_bridge_half_width + lists->waiting, who, lanes_load(lists->p_bridge_half_width + row));
        lanes_pack(lists->waiting_p_bridge_depth + lists->waiting, who, lanes_load(lists->p_bridge_depth + row));
        lanes_pack(lists->waiting_p_gravity + lists->waiting, who, lanes_load(lists->p_gravity + row));
        lanes_pack(lists->waiting_p_end_depth + lists->waiting, who, lanes_load(lists->p_end_depth + row));
        lanes_pack(lists->waiting_p_ring_restitution + lists->waiting, who, lanes_load(lists->p_ring_restitution + row));
        lanes_pack(lists->waiting_p_backboard_restitution + lists->waiting, who, lanes_load(lists->p_backboard_restitution + row));
        lanes_pack(lists->waiting_p_bridge_restitution + lists->waiting, who, lanes_load(lists->p_bridge_restitution + row));
        lanes_pack(lists->waiting_p_ring_friction + lists->waiting, who, lanes_load(lists->p_ring_friction + row));
        lanes_pack(lists->waiting_p_backboard_friction + lists->waiting, who, lanes_load(lists->p_backboard_friction + row));
        lanes_pack(lists->waiting_p_bridge_friction + lists->waiting, who, lanes_load(lists->p_bridge_friction + row));
        lanes_pack(lists->waiting_p_tangential_restitution + lists->waiting, who, lanes_load(lists->p_tangential_restitution + row));
        lanes_pack(lists->waiting_p_restitution_speed + lists->waiting, who, lanes_load(lists->p_restitution_speed + row));
    }
    lists->waiting = to;
}

/* Put shots that have waited into rows from one on; return how many. */
LANES_INLINE size_t LANES(court_bounded_resume)(LANES(court_bounded_lists) *lists, size_t row, const court_job *job)
{
    const size_t room = 2 * LANES_SHOTS - row, shots = lists->waiting < room ? lists->waiting : room;
    const size_t from = lists->waiting - shots;
    memcpy(lists->shot + row, lists->waiting_shot + from, shots * sizeof *lists->shot);
    memcpy(lists->x + row, lists->waiting_x + from, shots * sizeof *lists->x);
    memcpy(lists->y + row, lists->waiting_y + from, shots * sizeof *lists->y);
    memcpy(lists->z + row, lists->waiting_z + from, shots * sizeof *lists->z);
    memcpy(lists->vx + row, lists->waiting_vx + from, shots * sizeof *lists->vx);
    memcpy(lists->vy + row, lists->waiting_vy + from, shots * sizeof *lists->vy);
    memcpy(lists->vz + row, lists->waiting_vz + from, shots * sizeof *lists->vz);
    memcpy(lists->wx + row, lists->waiting_wx + from, shots * sizeof *lists->wx);
    memcpy(lists->wy + row, lists->waiting_wy + from, shots * sizeof *lists->wy);
    memcpy(lists->wz + row, lists->waiting_wz + from, shots * sizeof *lists->wz);
    memcpy(lists->dx + row, lists->waiting_dx + from, shots * sizeof *lists->dx);
    memcpy(lists->dy + row, lists->waiting_dy + from, shots * sizeof *lists->dy);
    memcpy(lists->dz + row, lists->waiting_dz + from, shots * sizeof *lists->dz);
    memcpy(lists->dvx + row, lists->waiting_dvx + from, shots * sizeof *lists->dvx);
    memcpy(lists->dvy + row, lists->waiting_dvy + from, shots * sizeof *lists->dvy);
    memcpy(lists->dvz + row, lists->waiting_dvz + from, shots * sizeof *lists->dvz);
    memcpy(lists->dwx + row, lists->waiting_dwx + from, shots * sizeof *lists->dwx);
    memcpy(lists->dwy + row, lists->waiting_dwy + from, shots * sizeof *lists->dwy);
    memcpy(lists->dwz + row, lists->waiting_dwz + from, shots * sizeof *lists->dwz);
    memcpy(lists->clock + row, lists->waiting_clock + from, shots * sizeof *lists->clock);
    memcpy(lists->clock_error + row, lists->waiting_clock_error + from, shots * sizeof *lists->clock_error);
    memcpy(lists->last + row, lists->waiting_last + from, shots * sizeof *lists->last);
    memcpy(lists->first + row, lists->waiting_first + from, shots * sizeof *lists->first);
    memcpy(lists->contacts + row, lists->waiting_contacts + from, shots * sizeof *lists->contacts);
    memcpy(lists->count_0 + row, lists->waiting_count_0 + from, shots * sizeof *lists->count_0);
    memcpy(lists->count_1 + row, lists->waiting_count_1 + from, shots * sizeof *lists->count_1);
    memcpy(lists->count_2 + row, lists->waiting_count_2 + from, shots * sizeof *lists->count_2);
    memcpy(lists->held + row, lists->waiting_held + from, shots * sizeof *lists->held);
    memcpy(lists->mode + row, lists->waiting_mode + from, shots * sizeof *lists->mode);
    memcpy(lists->circled + row, lists->waiting_circled + from, shots * sizeof *lists->circled);
    memcpy(lists->assured + row, lists->waiting_assured + from, shots * sizeof *lists->assured);
    memcpy(lists->rolls + row, lists->waiting_rolls + from, shots * sizeof *lists->rolls);
    memcpy(lists->slip_left + row, lists->waiting_slip_left + from, shots * sizeof *lists->slip_left);
    memcpy(lists->grip_lost + row, lists->waiting_grip_lost + from, shots * sizeof *lists->grip_lost);
    memcpy(lists->taut + row, lists->waiting_taut + from, shots * sizeof *lists->taut);
    memcpy(lists->taut_rate + row, lists->waiting_taut_rate + from, shots * sizeof *lists->taut_rate);
    memcpy(lists->taut_clock + row, lists->waiting_taut_clock + from, shots * sizeof *lists->taut_clock);
    memcpy(lists->through + row, lists->waiting_through + from, shots * sizeof *lists->through);
    memcpy(lists->uncertain + row, lists->waiting_uncertain + from, shots * sizeof *lists->uncertain);
    if (job->varying) {
        memcpy(lists->p_ball_radius + row, lists->waiting_p_ball_radius + from, shots * sizeof(double));
        memcpy(lists->p_ring_radius + row, lists->waiting_p_ring_radius + from, shots * sizeof(double));
        memcpy(lists->p_wire_radius + row, lists->waiting_p_wire_radius + from, shots * sizeof(double));
        memcpy(lists->p_board_distance + row, lists->waiting_p_board_distance + from, shots * sizeof(double));
        memcpy(lists->p_board_half_width + row, lists->waiting_p_board_half_width + from, shots * sizeof(double));
        memcpy(lists->p_board_bottom + row, lists->waiting_p_board_bottom + from, shots * sizeof(double));
        memcpy(lists->p_board_top + row, lists->waiting_p_board_top + from, shots * sizeof(double));
        memcpy(lists->p_board_thickness + row, lists->waiting_p_board_thickness + from, shots * sizeof(double));
        memcpy(lists->p_bridge_half_width + row, lists->waiting_p_bridge_half_width + from, shots * sizeof(double));
        memcpy(lists->p_bridge_depth + row, lists->waiting_p_bridge_depth + from, shots * sizeof(double));
        memcpy(lists->p_gravity + row, lists->waiting_p_gravity + from, shots * sizeof(double));
        memcpy(lists->p_end_depth + row, lists->waiting_p_end_depth + from, shots * sizeof(double));
        memcpy(lists->p_ring_restitution + row, lists->waiting_p_ring_restitution + from, shots * sizeof(double));
        memcpy(lists->p_backboard_restitution + row, lists->waiting_p_backboard_restitution + from, shots * sizeof(double));
        memcpy(lists->p_bridge_restitution + row, lists->waiting_p_bridge_restitution + from, shots * sizeof(double));
        memcpy(lists->p_ring_friction + row, lists->waiting_p_ring_friction + from, shots * sizeof(double));
        memcpy(lists->p_backboard_friction + row, lists->waiting_p_backboard_friction + from, shots * sizeof(double));
        memcpy(lists->p_bridge_friction + row, lists->waiting_p_bridge_friction + from, shots * sizeof(double));
        memcpy(lists->p_tangential_restitution + row, lists->waiting_p_tangential_restitution + from, shots * sizeof(double));
        memcpy(lists->p_restitution_speed + row, lists->waiting_p_restitution_speed + from, shots * sizeof(double));
    }
    lists->waiting = from;
    return shots;
}

/* Write the results of the shots that have ended, from a row on; the others close up. */
LANES_INLINE size_t LANES(court_bounded_leave)(LANES(court_bounded_lists) *lists, size_t start, size_t shots, const court_job *job)
{
    size_t kept = start;
    for (size_t i = start; i < shots; i += LANES_WIDTH) {
        const M rows = lanes_first(shots - i);
        M going = lanes_both(rows, lanes_less(lanes_load(lists->outcome + i), K(0.0)));
        for (unsigned bits = lanes_bits(rows) & ~lanes_bits(going); bits; bits &= bits - 1)
            LANES(court_bounded_finish)(lists, i + (size_t)LANES_LOWEST(bits), job);
        const M staying = lanes_both(going, lanes_less(K(0.0), lanes_load(lists->mode + i)));
        if (lanes_any(staying) && lists->waiting + LANES_WIDTH <= LANES_SHOTS) {
            LANES(court_bounded_wait)(lists, i, staying, job);
            going = lanes_both(going, lanes_not(staying));
        }
        if (kept < i || lanes_bits(going) != lanes_bits(rows)) {
            size_t to = kept;
            for (unsigned bits = lanes_bits(going); bits; bits &= bits - 1)
                lists->shot[to++] = lists->shot[i + (size_t)LANES_LOWEST(bits)];
            lanes_pack(lists->x + kept, going, lanes_load(lists->x + i));
            lanes_pack(lists->y + kept, going, lanes_load(lists->y + i));
            lanes_pack(lists->z + kept, going, lanes_load(lists->z + i));
            lanes_pack(lists->vx + kept, going, lanes_load(lists->vx + i));
            lanes_pack(lists->vy + kept, going, lanes_load(lists->vy + i));
            lanes_pack(lists->vz + kept, going, lanes_load(lists->vz + i));
            lanes_pack(lists->wx + kept, going, lanes_load(lists->wx + i));
            lanes_pack(lists->wy + kept, going, lanes_load(lists->wy + i));
            lanes_pack(lists->wz + kept, going, lanes_load(lists->wz + i));
            lanes_pack(lists->dx + kept, going, lanes_load(lists->dx + i));
            lanes_pack(lists->dy + kept, going, lanes_load(lists->dy + i));
            lanes_pack(lists->dz + kept, going, lanes_load(lists->dz + i));
            lanes_pack(lists->dvx + kept, going, lanes_load(lists->dvx + i));
            lanes_pack(lists->dvy + kept, going, lanes_load(lists->dvy + i));
            lanes_pack(lists->dvz + kept, going, lanes_load(lists->dvz + i));
            lanes_pack(lists->dwx + kept, going, lanes_load(lists->dwx + i));
            lanes_pack(lists->dwy + kept, going, lanes_load(lists->dwy + i));
            lanes_pack(lists->dwz + kept, going, lanes_load(lists->dwz + i));
            lanes_pack(lists->clock + kept, going, lanes_load(lists->clock + i));
            lanes_pack(lists->clock_error + kept, going, lanes_load(lists->clock_error + i));
            lanes_pack(lists->last + kept, going, lanes_load(lists->last + i));
            lanes_pack(lists->first + kept, going, lanes_load(lists->first + i));
            lanes_pack(lists->contacts + kept, going, lanes_load(lists->contacts + i));
            lanes_pack(lists->count_0 + kept, going, lanes_load(lists->count_0 + i));
            lanes_pack(lists->count_1 + kept, going, lanes_load(lists->count_1 + i));
            lanes_pack(lists->count_2 + kept, going, lanes_load(lists->count_2 + i));
            lanes_pack(lists->held + kept, going, lanes_load(lists->held + i));
            lanes_pack(lists->mode + kept, going, lanes_load(lists->mode + i));
            lanes_pack(lists->circled + kept, going, lanes_load(lists->circled + i));
            lanes_pack(lists->assured + kept, going, lanes_load(lists->assured + i));
            lanes_pack(lists->rolls + kept, going, lanes_load(lists->rolls + i));
            lanes_pack(lists->slip_left + kept, going, lanes_load(lists->slip_left + i));
            lanes_pack(lists->grip_lost + kept, going, lanes_load(lists->grip_lost + i));
            lanes_pack(lists->taut + kept, going, lanes_load(lists->taut + i));
            lanes_pack(lists->taut_rate + kept, going, lanes_load(lists->taut_rate + i));
            lanes_pack(lists->taut_clock + kept, going, lanes_load(lists->taut_clock + i));
            lanes_pack(lists->through + kept, going, lanes_load(lists->through + i));
            lanes_pack(lists->uncertain + kept, going, lanes_load(lists->uncertain + i));
            if (job->varying) {
                lanes_pack(lists->p_ball_radius + kept, going, lanes_load(lists->p_ball_radius + i));
                lanes_pack(lists->p_ring_radius + kept, going, lanes_load(lists->p_ring_radius + i));
                lanes_pack(lists->p_wire_radius + kept, going, lanes_load(lists->p_wire_radius + i));
                lanes_pack(lists->p_board_distance + kept, going, lanes_load(lists->p_board_distance + i));
                lanes_pack(lists->p_board_half_width + kept, going, lanes_load(lists->p_board_half_width + i));
                lanes_pack(lists->p_board_bottom + kept, going, lanes_load(lists->p_board_bottom + i));
                lanes_pack(lists->p_board_top + kept, going, lanes_load(lists->p_board_top + i));
                lanes_pack(lists->p_board_thickness + kept, going, lanes_load(lists->p_board_thickness + i));
                lanes_pack(lists->p_bridge_half_width + kept, going, lanes_load(lists->p_bridge_half_width + i));
                lanes_pack(lists->p_bridge_depth + kept, going, lanes_load(lists->p_bridge_depth + i));
                lanes_pack(lists->p_gravity + kept, going, lanes_load(lists->p_gravity + i));
                lanes_pack(lists->p_end_depth + kept, going, lanes_load(lists->p_end_depth + i));
                lanes_pack(lists->p_ring_restitution + kept, going, lanes_load(lists->p_ring_restitution + i));
                lanes_pack(lists->p_backboard_restitution + kept, going, lanes_load(lists->p_backboard_restitution + i));
                lanes_pack(lists->p_bridge_restitution + kept, going, lanes_load(lists->p_bridge_restitution + i));
                lanes_pack(lists->p_ring_friction + kept, going, lanes_load(lists->p_ring_friction + i));
                lanes_pack(lists->p_backboard_friction + kept, going, lanes_load(lists->p_backboard_friction + i));
                lanes_pack(lists->p_bridge_friction + kept, going, lanes_load(lists->p_bridge_friction + i));
                lanes_pack(lists->p_tangential_restitution + kept, going, lanes_load(lists->p_tangential_restitution + i));
                lanes_pack(lists->p_restitution_speed + kept, going, lanes_load(lists->p_restitution_speed + i));
            }
        }
        kept += lanes_many(going);
    }
    return kept;
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_leaves)(LANES(court_bounded_lists) *lists, size_t kept_leaves_shots, size_t varying)
{
    for (size_t i = 0; i < kept_leaves_shots; i += LANES_WIDTH) {
        const M rows = lanes_first(kept_leaves_shots - i);
        V clock_error = lanes_load(lists->kept_leaves_clock_error + i);
        V doubt = lanes_load(lists->kept_leaves_doubt + i);
        V dvx = lanes_load(lists->kept_leaves_dvx + i);
        V dvy = lanes_load(lists->kept_leaves_dvy + i);
        V dvz = lanes_load(lists->kept_leaves_dvz + i);
        V dwx = lanes_load(lists->kept_leaves_dwx + i);
        V dwy = lanes_load(lists->kept_leaves_dwy + i);
        V dwz = lanes_load(lists->kept_leaves_dwz + i);
        V dx = lanes_load(lists->kept_leaves_dx + i);
        V dy = lanes_load(lists->kept_leaves_dy + i);
        V dz = lanes_load(lists->kept_leaves_dz + i);
        V held = lanes_load(lists->kept_leaves_held + i);
        V lift = lanes_load(lists->kept_leaves_lift + i);
        const V p_ball_radius = lanes_load(varying ? lists->kept_leaves_p_ball_radius + i : lists->p_ball_radius);
        const V p_board_bottom = lanes_load(varying ? lists->kept_leaves_p_board_bottom + i : lists->p_board_bottom);
        const V p_board_distance = lanes_load(varying ? lists->kept_leaves_p_board_distance + i : lists->p_board_distance);
        const V p_board_half_width = lanes_load(varying ? lists->kept_leaves_p_board_half_width + i : lists->p_board_half_width);
        const V p_board_thickness = lanes_load(varying ? lists->kept_leaves_p_board_thickness + i : lists->p_board_thickness);
        const V p_board_top = lanes_load(varying ? lists->kept_leaves_p_board_top + i : lists->p_board_top);
        const V p_bridge_depth = lanes_load(varying ? lists->kept_leaves_p_bridge_depth + i : lists->p_bridge_depth);
        const V p_bridge_half_width = lanes_load(varying ? lists->kept_leaves_p_bridge_half_width + i : lists->p_bridge_half_width);
        const V p_end_depth = lanes_load(varying ? lists->kept_leaves_p_end_depth + i : lists->p_end_depth);
        const V p_gravity = lanes_load(varying ? lists->kept_leaves_p_gravity + i : lists->p_gravity);
        const V p_ring_radius = lanes_load(varying ? lists->kept_leaves_p_ring_radius + i : lists->p_ring_radius);
        const V p_wire_radius = lanes_load(varying ? lists->kept_leaves_p_wire_radius + i : lists->p_wire_radius);
        V per_reach = lanes_load(lists->kept_leaves_per_reach + i);
        V snap = lanes_load(lists->kept_leaves_snap + i);
        V surge = lanes_load(lists->kept_leaves_surge + i);
        V vx = lanes_load(lists->kept_leaves_vx + i);
        V vy = lanes_load(lists->kept_leaves_vy + i);
        V vz = lanes_load(lists->kept_leaves_vz + i);
        V x = lanes_load(lists->kept_leaves_x + i);
        V y = lanes_load(lists->kept_leaves_y + i);
        V z = lanes_load(lists->kept_leaves_z + i);
        const LANES(court_error_bounds_out) _o400 =
            LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
        V position_error = _o400.position_error;
        V velocity_error = _o400.velocity_error;
        const LANES(court_holding_out) _o401 =
            LANES(court_holding)(held, K(0.0));
        M here = _o401.here;
        const M _m402 = lanes_both(rows, here);
        if (lanes_any(_m402)) {
            const LANES(court_ring_tube_out) _o403 =
                LANES(court_ring_tube)(p_ball_radius, p_wire_radius);
            per_reach = lanes_select(_m402, _o403.per_reach, per_reach);
            const LANES(court_ring_parting_out) _o404 =
                LANES(court_ring_parting)(p_gravity, p_ring_radius, vx, vy, vz, x, y, z);
            lift = lanes_select(_m402, _o404.lift, lift);
            surge = lanes_select(_m402, _o404.surge, surge);
            snap = lanes_select(_m402, _o404.snap, snap);
        }
        const LANES(court_holding_out) _o405 =
            LANES(court_holding)(held, K(1.0));
        here = _o405.here;
        const M _m406 = lanes_both(rows, here);
        if (lanes_any(_m406)) {
            const LANES(court_backboard_tube_out) _o407 =
                LANES(court_backboard_tube)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            per_reach = lanes_select(_m406, _o407.per_reach, per_reach);
            const LANES(court_backboard_parting_out) _o408 =
                LANES(court_backboard_parting)(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, vx, vy, vz, x, y, z);
            lift = lanes_select(_m406, _o408.lift, lift);
            surge = lanes_select(_m406, _o408.surge, surge);
            snap = lanes_select(_m406, _o408.snap, snap);
        }
        const LANES(court_holding_out) _o409 =
            LANES(court_holding)(held, K(2.0));
        here = _o409.here;
        const M _m410 = lanes_both(rows, here);
        if (lanes_any(_m410)) {
            const LANES(court_bridge_tube_out) _o411 =
                LANES(court_bridge_tube)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            per_reach = lanes_select(_m410, _o411.per_reach, per_reach);
            const LANES(court_bridge_parting_out) _o412 =
                LANES(court_bridge_parting)(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            lift = lanes_select(_m410, _o412.lift, lift);
            surge = lanes_select(_m410, _o412.surge, surge);
            snap = lanes_select(_m410, _o412.snap, snap);
        }
        const LANES(court_unmet_out) _o413 =
            LANES(court_unmet)();
        V spare = _o413.spare;
        const LANES(court_beside_out) _o414 =
            LANES(court_beside)(held, K(0.0));
        M beside = _o414.beside;
        const M _m415 = lanes_both(rows, beside);
        if (lanes_any(_m415)) {
            const LANES(court_ring_beside_out) _o416 =
                LANES(court_ring_beside)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            V gap = _o416.gap;
            V nearing = _o416.nearing;
            V dent = _o416.dent;
            const LANES(court_spared_out) _o417 =
                LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
            spare = lanes_select(_m415, _o417.spare, spare);
        }
        const LANES(court_beside_out) _o418 =
            LANES(court_beside)(held, K(1.0));
        beside = _o418.beside;
        const M _m419 = lanes_both(rows, beside);
        if (lanes_any(_m419)) {
            const LANES(court_backboard_beside_out) _o420 =
                LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            V gap = _o420.gap;
            V nearing = _o420.nearing;
            V dent = _o420.dent;
            const LANES(court_spared_out) _o421 =
                LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
            spare = lanes_select(_m419, _o421.spare, spare);
        }
        const LANES(court_beside_out) _o422 =
            LANES(court_beside)(held, K(2.0));
        beside = _o422.beside;
        const M _m423 = lanes_both(rows, beside);
        if (lanes_any(_m423)) {
            const LANES(court_bridge_beside_out) _o424 =
                LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            V gap = _o424.gap;
            V nearing = _o424.nearing;
            V dent = _o424.dent;
            const LANES(court_spared_out) _o425 =
                LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
            spare = lanes_select(_m423, _o425.spare, spare);
        }
        const LANES(court_beside_out) _o426 =
            LANES(court_beside)(held, K(3.0));
        beside = _o426.beside;
        const M _m427 = lanes_both(rows, beside);
        if (lanes_any(_m427)) {
            const LANES(court_end_beside_out) _o428 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            V gap = _o428.gap;
            V nearing = _o428.nearing;
            V dent = _o428.dent;
            const LANES(court_spared_out) _o429 =
                LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
            spare = lanes_select(_m427, _o429.spare, spare);
        }
        const LANES(court_holding_out) _o430 =
            LANES(court_holding)(held, K(1.0));
        here = _o430.here;
        const M _m431 = lanes_both(rows, here);
        if (lanes_any(_m431)) {
            const LANES(court_backboard_seam0_out) _o432 =
                LANES(court_backboard_seam0)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
            V gap = _o432.gap;
            V nearing = _o432.nearing;
            V near = _o432.near;
            const LANES(court_spared_seam_out) _o433 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m431, _o433.spare, spare);
            const LANES(court_backboard_seam1_out) _o434 =
                LANES(court_backboard_seam1)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
            gap = _o434.gap;
            nearing = _o434.nearing;
            near = _o434.near;
            const LANES(court_spared_seam_out) _o435 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m431, _o435.spare, spare);
            const LANES(court_backboard_seam2_out) _o436 =
                LANES(court_backboard_seam2)(p_ball_radius, p_board_half_width, vy, y);
            gap = _o436.gap;
            nearing = _o436.nearing;
            near = _o436.near;
            const LANES(court_spared_seam_out) _o437 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m431, _o437.spare, spare);
            const LANES(court_backboard_seam3_out) _o438 =
                LANES(court_backboard_seam3)(p_ball_radius, p_board_half_width, vy, y);
            gap = _o438.gap;
            nearing = _o438.nearing;
            near = _o438.near;
            const LANES(court_spared_seam_out) _o439 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m431, _o439.spare, spare);
            const LANES(court_backboard_seam4_out) _o440 =
                LANES(court_backboard_seam4)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
            gap = _o440.gap;
            nearing = _o440.nearing;
            near = _o440.near;
            const LANES(court_spared_seam_out) _o441 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m431, _o441.spare, spare);
            const LANES(court_backboard_seam5_out) _o442 =
                LANES(court_backboard_seam5)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
            gap = _o442.gap;
            nearing = _o442.nearing;
            near = _o442.near;
            const LANES(court_spared_seam_out) _o443 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m431, _o443.spare, spare);
        }
        const LANES(court_holding_out) _o444 =
            LANES(court_holding)(held, K(2.0));
        here = _o444.here;
        const M _m445 = lanes_both(rows, here);
        if (lanes_any(_m445)) {
            const LANES(court_bridge_seam0_out) _o446 =
                LANES(court_bridge_seam0)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
            V gap = _o446.gap;
            V nearing = _o446.nearing;
            V near = _o446.near;
            const LANES(court_spared_seam_out) _o447 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m445, _o447.spare, spare);
            const LANES(court_bridge_seam1_out) _o448 =
                LANES(court_bridge_seam1)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
            gap = _o448.gap;
            nearing = _o448.nearing;
            near = _o448.near;
            const LANES(court_spared_seam_out) _o449 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m445, _o449.spare, spare);
            const LANES(court_bridge_seam2_out) _o450 =
                LANES(court_bridge_seam2)(p_ball_radius, p_bridge_half_width, vy, y);
            gap = _o450.gap;
            nearing = _o450.nearing;
            near = _o450.near;
            const LANES(court_spared_seam_out) _o451 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m445, _o451.spare, spare);
            const LANES(court_bridge_seam3_out) _o452 =
                LANES(court_bridge_seam3)(p_ball_radius, p_bridge_half_width, vy, y);
            gap = _o452.gap;
            nearing = _o452.nearing;
            near = _o452.near;
            const LANES(court_spared_seam_out) _o453 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m445, _o453.spare, spare);
            const LANES(court_bridge_seam4_out) _o454 =
                LANES(court_bridge_seam4)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
            gap = _o454.gap;
            nearing = _o454.nearing;
            near = _o454.near;
            const LANES(court_spared_seam_out) _o455 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m445, _o455.spare, spare);
            const LANES(court_bridge_seam5_out) _o456 =
                LANES(court_bridge_seam5)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
            gap = _o456.gap;
            nearing = _o456.nearing;
            near = _o456.near;
            const LANES(court_spared_seam_out) _o457 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m445, _o457.spare, spare);
        }
        const LANES(court_parted_out) _o458 =
            LANES(court_parted)(doubt, p_gravity, lift, per_reach, position_error, snap, spare, surge, velocity_error, vx, vy, vz);
        V when = _o458.when;
        doubt = _o458.doubt;
        const LANES(court_hopping_out) _o459 =
            LANES(court_hopping)();
        V which = _o459.which;
        lanes_store(lists->kept_leaves_doubt + i, doubt);
        lanes_store(lists->kept_leaves_position_error + i, position_error);
        lanes_store(lists->kept_leaves_velocity_error + i, velocity_error);
        lanes_store(lists->kept_leaves_when + i, when);
        lanes_store(lists->kept_leaves_which + i, which);
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_kept)(LANES(court_bounded_lists) *lists, size_t kept_shots, size_t varying, V time_limit)
{
    {
    size_t kept_rolling_shots = 0;
    for (size_t i = 0; i < kept_shots; i += LANES_WIDTH) {
        const M rows = lanes_first(kept_shots - i);
        V circled = lanes_load(lists->kept_circled + i);
        V clock = lanes_load(lists->kept_clock + i);
        V clock_error = lanes_load(lists->kept_clock_error + i);
        V dvx = lanes_load(lists->kept_dvx + i);
        V dvy = lanes_load(lists->kept_dvy + i);
        V dvz = lanes_load(lists->kept_dvz + i);
        V dwx = lanes_load(lists->kept_dwx + i);
        V dwy = lanes_load(lists->kept_dwy + i);
        V dwz = lanes_load(lists->kept_dwz + i);
        V dx = lanes_load(lists->kept_dx + i);
        V dy = lanes_load(lists->kept_dy + i);
        V dz = lanes_load(lists->kept_dz + i);
        V grip_lost = lanes_load(lists->kept_grip_lost + i);
        V held = lanes_load(lists->kept_held + i);
        V mode = lanes_load(lists->kept_mode + i);
        const V p_backboard_friction = lanes_load(varying ? lists->kept_p_backboard_friction + i : lists->p_backboard_friction);
        const V p_ball_radius = lanes_load(varying ? lists->kept_p_ball_radius + i : lists->p_ball_radius);
        const V p_board_bottom = lanes_load(varying ? lists->kept_p_board_bottom + i : lists->p_board_bottom);
        const V p_board_distance = lanes_load(varying ? lists->kept_p_board_distance + i : lists->p_board_distance);
        const V p_board_half_width = lanes_load(varying ? lists->kept_p_board_half_width + i : lists->p_board_half_width);
        const V p_board_thickness = lanes_load(varying ? lists->kept_p_board_thickness + i : lists->p_board_thickness);
        const V p_board_top = lanes_load(varying ? lists->kept_p_board_top + i : lists->p_board_top);
        const V p_bridge_depth = lanes_load(varying ? lists->kept_p_bridge_depth + i : lists->p_bridge_depth);
        const V p_bridge_friction = lanes_load(varying ? lists->kept_p_bridge_friction + i : lists->p_bridge_friction);
        const V p_bridge_half_width = lanes_load(varying ? lists->kept_p_bridge_half_width + i : lists->p_bridge_half_width);
        const V p_end_depth = lanes_load(varying ? lists->kept_p_end_depth + i : lists->p_end_depth);
        const V p_gravity = lanes_load(varying ? lists->kept_p_gravity + i : lists->p_gravity);
        const V p_ring_radius = lanes_load(varying ? lists->kept_p_ring_radius + i : lists->p_ring_radius);
        const V p_wire_radius = lanes_load(varying ? lists->kept_p_wire_radius + i : lists->p_wire_radius);
        V position_error = lanes_load(lists->kept_position_error + i);
        V taut = lanes_load(lists->kept_taut + i);
        V taut_clock = lanes_load(lists->kept_taut_clock + i);
        V taut_rate = lanes_load(lists->kept_taut_rate + i);
        V through = lanes_load(lists->kept_through + i);
        V velocity_error = lanes_load(lists->kept_velocity_error + i);
        V vx = lanes_load(lists->kept_vx + i);
        V vy = lanes_load(lists->kept_vy + i);
        V vz = lanes_load(lists->kept_vz + i);
        V wx = lanes_load(lists->kept_wx + i);
        V wy = lanes_load(lists->kept_wy + i);
        V wz = lanes_load(lists->kept_wz + i);
        V x = lanes_load(lists->kept_x + i);
        V y = lanes_load(lists->kept_y + i);
        V z = lanes_load(lists->kept_z + i);
        const LANES(court_resumed_out) _o180 =
            LANES(court_resumed)(clock, mode, position_error, velocity_error);
        V which = _o180.which;
        V late = _o180.late;
        V began = _o180.began;
        V doubt = _o180.doubt;
        M begins = _o180.begins;
        M rolling = _o180.rolling;
        M leaves = _o180.leaves;
        V nx = _o180.nx;
        V ny = _o180.ny;
        V nz = _o180.nz;
        V gap = _o180.gap;
        V bent_x = _o180.bent_x;
        V bent_y = _o180.bent_y;
        V bent_z = _o180.bent_z;
        V lift = _o180.lift;
        V surge = _o180.surge;
        V snap = _o180.snap;
        V per_reach = _o180.per_reach;
        const M _m181 = lanes_both(rows, begins);
        if (lanes_any(_m181)) {
            const LANES(court_holding_out) _o182 =
                LANES(court_holding)(held, K(0.0));
            M here = _o182.here;
            const M _m183 = lanes_both(_m181, here);
            {
                const LANES(court_ring_normal_out) _o184 =
                    LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                nx = lanes_select(_m183, _o184.nx, nx);
                ny = lanes_select(_m183, _o184.ny, ny);
                nz = lanes_select(_m183, _o184.nz, nz);
            }
            const LANES(court_holding_out) _o185 =
                LANES(court_holding)(held, K(1.0));
            here = _o185.here;
            const M _m186 = lanes_both(_m181, here);
            {
                const LANES(court_backboard_normal_out) _o187 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m186, _o187.nx, nx);
                ny = lanes_select(_m186, _o187.ny, ny);
                nz = lanes_select(_m186, _o187.nz, nz);
            }
            const LANES(court_holding_out) _o188 =
                LANES(court_holding)(held, K(2.0));
            here = _o188.here;
            const M _m189 = lanes_both(_m181, here);
            {
                const LANES(court_bridge_normal_out) _o190 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m189, _o190.nx, nx);
                ny = lanes_select(_m189, _o190.ny, ny);
                nz = lanes_select(_m189, _o190.nz, nz);
            }
            const LANES(court_roll_turn_rate_out) _o191 =
                LANES(court_roll_turn_rate)(p_ball_radius, nx, ny, nz, wx, wy, wz);
            V turn_rate = _o191.turn_rate;
            const LANES(court_gripped_out) _o192 =
                LANES(court_gripped)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
            V rolled_x = _o192.rolled_x;
            V rolled_y = _o192.rolled_y;
            V rolled_z = _o192.rolled_z;
            const LANES(court_holding_out) _o193 =
                LANES(court_holding)(held, K(0.0));
            here = _o193.here;
            const M _m194 = lanes_both(_m181, here);
            {
                const LANES(court_ring_off_out) _o195 =
                    LANES(court_ring_off)(p_ball_radius, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m194, _o195.gap, gap);
            }
            const LANES(court_holding_out) _o196 =
                LANES(court_holding)(held, K(1.0));
            here = _o196.here;
            const M _m197 = lanes_both(_m181, here);
            {
                const LANES(court_backboard_off_out) _o198 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z);
                gap = lanes_select(_m197, _o198.gap, gap);
            }
            const LANES(court_holding_out) _o199 =
                LANES(court_holding)(held, K(2.0));
            here = _o199.here;
            const M _m200 = lanes_both(_m181, here);
            {
                const LANES(court_bridge_off_out) _o201 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m200, _o201.gap, gap);
            }
            const LANES(court_roll_placed_out) _o202 =
                LANES(court_roll_placed)(p_ball_radius, gap, nx, ny, nz, turn_rate, rolled_x, rolled_y, rolled_z, x, y, z);
            x = lanes_select(_m181, _o202.x, x);
            y = lanes_select(_m181, _o202.y, y);
            z = lanes_select(_m181, _o202.z, z);
            vx = lanes_select(_m181, _o202.vx, vx);
            vy = lanes_select(_m181, _o202.vy, vy);
            vz = lanes_select(_m181, _o202.vz, vz);
            wx = lanes_select(_m181, _o202.wx, wx);
            wy = lanes_select(_m181, _o202.wy, wy);
            wz = lanes_select(_m181, _o202.wz, wz);
            const LANES(court_begun_errors_out) _o203 =
                LANES(court_begun_errors)(p_ball_radius, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, vx, vy, vz);
            dx = lanes_select(_m181, _o203.dx, dx);
            dy = lanes_select(_m181, _o203.dy, dy);
            dz = lanes_select(_m181, _o203.dz, dz);
            dvx = lanes_select(_m181, _o203.dvx, dvx);
            dvy = lanes_select(_m181, _o203.dvy, dvy);
            dvz = lanes_select(_m181, _o203.dvz, dvz);
            dwx = lanes_select(_m181, _o203.dwx, dwx);
            dwy = lanes_select(_m181, _o203.dwy, dwy);
            dwz = lanes_select(_m181, _o203.dwz, dwz);
            const LANES(court_untaut_out) _o204 =
                LANES(court_untaut)();
            taut = lanes_select(_m181, _o204.taut, taut);
            const LANES(court_beginning_contact_out) _o205 =
                LANES(court_beginning_contact)();
            which = lanes_select(_m181, _o205.which, which);
            circled = lanes_select(_m181, _o205.circled, circled);
        }
        const LANES(court_circles_out) _o206 =
            LANES(court_circles)(held, K(0.0), rolling);
        M circling = _o206.circling;
        rolling = _o206.rolling;
        lanes_store(lists->kept_began + i, began);
        lanes_store(lists->kept_circled + i, circled);
        lanes_store(lists->kept_circling + i, lanes_select(circling, K(1.0), K(0.0)));
        lanes_store(lists->kept_doubt + i, doubt);
        lanes_store(lists->kept_dvx + i, dvx);
        lanes_store(lists->kept_dvy + i, dvy);
        lanes_store(lists->kept_dvz + i, dvz);
        lanes_store(lists->kept_dwx + i, dwx);
        lanes_store(lists->kept_dwy + i, dwy);
        lanes_store(lists->kept_dwz + i, dwz);
        lanes_store(lists->kept_dx + i, dx);
        lanes_store(lists->kept_dy + i, dy);
        lanes_store(lists->kept_dz + i, dz);
        lanes_store(lists->kept_late + i, late);
        lanes_store(lists->kept_leaves + i, lanes_select(leaves, K(1.0), K(0.0)));
        lanes_store(lists->kept_lift + i, lift);
        lanes_store(lists->kept_per_reach + i, per_reach);
        lanes_store(lists->kept_rolling + i, lanes_select(rolling, K(1.0), K(0.0)));
        lanes_store(lists->kept_snap + i, snap);
        lanes_store(lists->kept_surge + i, surge);
        lanes_store(lists->kept_taut + i, taut);
        lanes_store(lists->kept_vx + i, vx);
        lanes_store(lists->kept_vy + i, vy);
        lanes_store(lists->kept_vz + i, vz);
        lanes_store(lists->kept_which + i, which);
        lanes_store(lists->kept_wx + i, wx);
        lanes_store(lists->kept_wy + i, wy);
        lanes_store(lists->kept_wz + i, wz);
        lanes_store(lists->kept_x + i, x);
        lanes_store(lists->kept_y + i, y);
        lanes_store(lists->kept_z + i, z);
        const M packed = lanes_both(rows, rolling);
        if (lanes_any(packed)) {
            lanes_pack(lists->kept_rolling_row + kept_rolling_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
            lanes_pack(lists->kept_rolling_bent_x + kept_rolling_shots, packed, bent_x);
            lanes_pack(lists->kept_rolling_bent_y + kept_rolling_shots, packed, bent_y);
            lanes_pack(lists->kept_rolling_bent_z + kept_rolling_shots, packed, bent_z);
            lanes_pack(lists->kept_rolling_clock + kept_rolling_shots, packed, clock);
            lanes_pack(lists->kept_rolling_clock_error + kept_rolling_shots, packed, clock_error);
            lanes_pack(lists->kept_rolling_doubt + kept_rolling_shots, packed, doubt);
            lanes_pack(lists->kept_rolling_dvx + kept_rolling_shots, packed, dvx);
            lanes_pack(lists->kept_rolling_dvy + kept_rolling_shots, packed, dvy);
            lanes_pack(lists->kept_rolling_dvz + kept_rolling_shots, packed, dvz);
            lanes_pack(lists->kept_rolling_dwx + kept_rolling_shots, packed, dwx);
            lanes_pack(lists->kept_rolling_dwy + kept_rolling_shots, packed, dwy);
            lanes_pack(lists->kept_rolling_dwz + kept_rolling_shots, packed, dwz);
            lanes_pack(lists->kept_rolling_dx + kept_rolling_shots, packed, dx);
            lanes_pack(lists->kept_rolling_dy + kept_rolling_shots, packed, dy);
            lanes_pack(lists->kept_rolling_dz + kept_rolling_shots, packed, dz);
            lanes_pack(lists->kept_rolling_grip_lost + kept_rolling_shots, packed, grip_lost);
            lanes_pack(lists->kept_rolling_held + kept_rolling_shots, packed, held);
            lanes_pack(lists->kept_rolling_late + kept_rolling_shots, packed, late);
            lanes_pack(lists->kept_rolling_nx + kept_rolling_shots, packed, nx);
            lanes_pack(lists->kept_rolling_ny + kept_rolling_shots, packed, ny);
            lanes_pack(lists->kept_rolling_nz + kept_rolling_shots, packed, nz);
            if (varying)
                lanes_pack(lists->kept_rolling_p_backboard_friction + kept_rolling_shots, packed, p_backboard_friction);
            if (varying)
                lanes_pack(lists->kept_rolling_p_ball_radius + kept_rolling_shots, packed, p_ball_radius);
            if (varying)
                lanes_pack(lists->kept_rolling_p_board_bottom + kept_rolling_shots, packed, p_board_bottom);
            if (varying)
                lanes_pack(lists->kept_rolling_p_board_distance + kept_rolling_shots, packed, p_board_distance);
            if (varying)
                lanes_pack(lists->kept_rolling_p_board_half_width + kept_rolling_shots, packed, p_board_half_width);
            if (varying)
                lanes_pack(lists->kept_rolling_p_board_thickness + kept_rolling_shots, packed, p_board_thickness);
            if (varying)
                lanes_pack(lists->kept_rolling_p_board_top + kept_rolling_shots, packed, p_board_top);
            if (varying)
                lanes_pack(lists->kept_rolling_p_bridge_depth + kept_rolling_shots, packed, p_bridge_depth);
            if (varying)
                lanes_pack(lists->kept_rolling_p_bridge_friction + kept_rolling_shots, packed, p_bridge_friction);
            if (varying)
                lanes_pack(lists->kept_rolling_p_bridge_half_width + kept_rolling_shots, packed, p_bridge_half_width);
            if (varying)
                lanes_pack(lists->kept_rolling_p_end_depth + kept_rolling_shots, packed, p_end_depth);
            if (varying)
                lanes_pack(lists->kept_rolling_p_gravity + kept_rolling_shots, packed, p_gravity);
            if (varying)
                lanes_pack(lists->kept_rolling_p_ring_radius + kept_rolling_shots, packed, p_ring_radius);
            if (varying)
                lanes_pack(lists->kept_rolling_p_wire_radius + kept_rolling_shots, packed, p_wire_radius);
            lanes_pack(lists->kept_rolling_per_reach + kept_rolling_shots, packed, per_reach);
            lanes_pack(lists->kept_rolling_taut + kept_rolling_shots, packed, taut);
            lanes_pack(lists->kept_rolling_taut_clock + kept_rolling_shots, packed, taut_clock);
            lanes_pack(lists->kept_rolling_taut_rate + kept_rolling_shots, packed, taut_rate);
            lanes_pack(lists->kept_rolling_through + kept_rolling_shots, packed, through);
            lanes_pack(lists->kept_rolling_vx + kept_rolling_shots, packed, vx);
            lanes_pack(lists->kept_rolling_vy + kept_rolling_shots, packed, vy);
            lanes_pack(lists->kept_rolling_vz + kept_rolling_shots, packed, vz);
            lanes_pack(lists->kept_rolling_which + kept_rolling_shots, packed, which);
            lanes_pack(lists->kept_rolling_wx + kept_rolling_shots, packed, wx);
            lanes_pack(lists->kept_rolling_wy + kept_rolling_shots, packed, wy);
            lanes_pack(lists->kept_rolling_wz + kept_rolling_shots, packed, wz);
            lanes_pack(lists->kept_rolling_x + kept_rolling_shots, packed, x);
            lanes_pack(lists->kept_rolling_y + kept_rolling_shots, packed, y);
            lanes_pack(lists->kept_rolling_z + kept_rolling_shots, packed, z);
            kept_rolling_shots += lanes_many(packed);
        }
    }
    {
        size_t taken = 0, busy = 0;
        M active = lanes_nowhere();
        V row = K(0.0), turns = K(0.0);
        V p_backboard_friction = lanes_load(lists->p_backboard_friction);
        V p_ball_radius = lanes_load(lists->p_ball_radius);
        V p_board_bottom = lanes_load(lists->p_board_bottom);
        V p_board_distance = lanes_load(lists->p_board_distance);
        V p_board_half_width = lanes_load(lists->p_board_half_width);
        V p_board_thickness = lanes_load(lists->p_board_thickness);
        V p_board_top = lanes_load(lists->p_board_top);
        V p_bridge_depth = lanes_load(lists->p_bridge_depth);
        V p_bridge_friction = lanes_load(lists->p_bridge_friction);
        V p_bridge_half_width = lanes_load(lists->p_bridge_half_width);
        V p_end_depth = lanes_load(lists->p_end_depth);
        V p_gravity = lanes_load(lists->p_gravity);
        V p_ring_radius = lanes_load(lists->p_ring_radius);
        V p_wire_radius = lanes_load(lists->p_wire_radius);
        V bent_x = K(0.0);
        V bent_y = K(0.0);
        V bent_z = K(0.0);
        V clock = K(0.0);
        V clock_error = K(0.0);
        V doubt = K(0.0);
        V dvx = K(0.0);
        V dvy = K(0.0);
        V dvz = K(0.0);
        V dwx = K(0.0);
        V dwy = K(0.0);
        V dwz = K(0.0);
        V dx = K(0.0);
        V dy = K(0.0);
        V dz = K(0.0);
        V grip_lost = K(0.0);
        V held = K(0.0);
        V late = K(0.0);
        V nx = K(0.0);
        V ny = K(0.0);
        V nz = K(0.0);
        V per_reach = K(0.0);
        V taut = K(0.0);
        V taut_clock = K(0.0);
        V taut_rate = K(0.0);
        V through = K(0.0);
        V vx = K(0.0);
        V vy = K(0.0);
        V vz = K(0.0);
        V which = K(0.0);
        V wx = K(0.0);
        V wy = K(0.0);
        V wz = K(0.0);
        V x = K(0.0);
        V y = K(0.0);
        V z = K(0.0);
        for (;;) {
            if (taken < kept_rolling_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                const M idle = lanes_not(active);
                row = lanes_expand(lists->kept_rolling_row + taken, idle, row);
                turns = lanes_select(idle, K(0.0), turns);
                bent_x = lanes_expand(lists->kept_rolling_bent_x + taken, idle, bent_x);
                bent_y = lanes_expand(lists->kept_rolling_bent_y + taken, idle, bent_y);
                bent_z = lanes_expand(lists->kept_rolling_bent_z + taken, idle, bent_z);
                clock = lanes_expand(lists->kept_rolling_clock + taken, idle, clock);
                clock_error = lanes_expand(lists->kept_rolling_clock_error + taken, idle, clock_error);
                doubt = lanes_expand(lists->kept_rolling_doubt + taken, idle, doubt);
                dvx = lanes_expand(lists->kept_rolling_dvx + taken, idle, dvx);
                dvy = lanes_expand(lists->kept_rolling_dvy + taken, idle, dvy);
                dvz = lanes_expand(lists->kept_rolling_dvz + taken, idle, dvz);
                dwx = lanes_expand(lists->kept_rolling_dwx + taken, idle, dwx);
                dwy = lanes_expand(lists->kept_rolling_dwy + taken, idle, dwy);
                dwz = lanes_expand(lists->kept_rolling_dwz + taken, idle, dwz);
                dx = lanes_expand(lists->kept_rolling_dx + taken, idle, dx);
                dy = lanes_expand(lists->kept_rolling_dy + taken, idle, dy);
                dz = lanes_expand(lists->kept_rolling_dz + taken, idle, dz);
                grip_lost = lanes_expand(lists->kept_rolling_grip_lost + taken, idle, grip_lost);
                held = lanes_expand(lists->kept_rolling_held + taken, idle, held);
                late = lanes_expand(lists->kept_rolling_late + taken, idle, late);
                nx = lanes_expand(lists->kept_rolling_nx + taken, idle, nx);
                ny = lanes_expand(lists->kept_rolling_ny + taken, idle, ny);
                nz = lanes_expand(lists->kept_rolling_nz + taken, idle, nz);
                per_reach = lanes_expand(lists->kept_rolling_per_reach + taken, idle, per_reach);
                taut = lanes_expand(lists->kept_rolling_taut + taken, idle, taut);
                taut_clock = lanes_expand(lists->kept_rolling_taut_clock + taken, idle, taut_clock);
                taut_rate = lanes_expand(lists->kept_rolling_taut_rate + taken, idle, taut_rate);
                through = lanes_expand(lists->kept_rolling_through + taken, idle, through);
                vx = lanes_expand(lists->kept_rolling_vx + taken, idle, vx);
                vy = lanes_expand(lists->kept_rolling_vy + taken, idle, vy);
                vz = lanes_expand(lists->kept_rolling_vz + taken, idle, vz);
                which = lanes_expand(lists->kept_rolling_which + taken, idle, which);
                wx = lanes_expand(lists->kept_rolling_wx + taken, idle, wx);
                wy = lanes_expand(lists->kept_rolling_wy + taken, idle, wy);
                wz = lanes_expand(lists->kept_rolling_wz + taken, idle, wz);
                x = lanes_expand(lists->kept_rolling_x + taken, idle, x);
                y = lanes_expand(lists->kept_rolling_y + taken, idle, y);
                z = lanes_expand(lists->kept_rolling_z + taken, idle, z);
                if (varying) {
                    p_backboard_friction = lanes_expand(lists->kept_rolling_p_backboard_friction + taken, idle, p_backboard_friction);
                    p_ball_radius = lanes_expand(lists->kept_rolling_p_ball_radius + taken, idle, p_ball_radius);
                    p_board_bottom = lanes_expand(lists->kept_rolling_p_board_bottom + taken, idle, p_board_bottom);
                    p_board_distance = lanes_expand(lists->kept_rolling_p_board_distance + taken, idle, p_board_distance);
                    p_board_half_width = lanes_expand(lists->kept_rolling_p_board_half_width + taken, idle, p_board_half_width);
                    p_board_thickness = lanes_expand(lists->kept_rolling_p_board_thickness + taken, idle, p_board_thickness);
                    p_board_top = lanes_expand(lists->kept_rolling_p_board_top + taken, idle, p_board_top);
                    p_bridge_depth = lanes_expand(lists->kept_rolling_p_bridge_depth + taken, idle, p_bridge_depth);
                    p_bridge_friction = lanes_expand(lists->kept_rolling_p_bridge_friction + taken, idle, p_bridge_friction);
                    p_bridge_half_width = lanes_expand(lists->kept_rolling_p_bridge_half_width + taken, idle, p_bridge_half_width);
                    p_end_depth = lanes_expand(lists->kept_rolling_p_end_depth + taken, idle, p_end_depth);
                    p_gravity = lanes_expand(lists->kept_rolling_p_gravity + taken, idle, p_gravity);
                    p_ring_radius = lanes_expand(lists->kept_rolling_p_ring_radius + taken, idle, p_ring_radius);
                    p_wire_radius = lanes_expand(lists->kept_rolling_p_wire_radius + taken, idle, p_wire_radius);
                }
                const size_t room = LANES_WIDTH - busy, left = kept_rolling_shots - taken;
                active = lanes_leading(idle, left, active);
                taken += left < room ? left : room;
                busy += left < room ? left : room;
            }
            if (busy == 0)
                break;
            M rolling = active;
            const LANES(court_error_bounds_out) _o207 =
                LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            V position_error = _o207.position_error;
            V velocity_error = _o207.velocity_error;
            const LANES(court_holding_out) _o208 =
                LANES(court_holding)(held, K(1.0));
            M here = _o208.here;
            const M _m209 = lanes_both(active, here);
            if (lanes_any(_m209)) {
                const LANES(court_backboard_normal_out) _o210 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m209, _o210.nx, nx);
                ny = lanes_select(_m209, _o210.ny, ny);
                nz = lanes_select(_m209, _o210.nz, nz);
                const LANES(court_backboard_tube_out) _o211 =
                    LANES(court_backboard_tube)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                bent_x = lanes_select(_m209, _o211.bent_x, bent_x);
                bent_y = lanes_select(_m209, _o211.bent_y, bent_y);
                bent_z = lanes_select(_m209, _o211.bent_z, bent_z);
                per_reach = lanes_select(_m209, _o211.per_reach, per_reach);
            }
            const LANES(court_holding_out) _o212 =
                LANES(court_holding)(held, K(2.0));
            here = _o212.here;
            const M _m213 = lanes_both(active, here);
            if (lanes_any(_m213)) {
                const LANES(court_bridge_normal_out) _o214 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m213, _o214.nx, nx);
                ny = lanes_select(_m213, _o214.ny, ny);
                nz = lanes_select(_m213, _o214.nz, nz);
                const LANES(court_bridge_tube_out) _o215 =
                    LANES(court_bridge_tube)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                bent_x = lanes_select(_m213, _o215.bent_x, bent_x);
                bent_y = lanes_select(_m213, _o215.bent_y, bent_y);
                bent_z = lanes_select(_m213, _o215.bent_z, bent_z);
                per_reach = lanes_select(_m213, _o215.per_reach, per_reach);
            }
            const LANES(court_roll_start_out) _o216 =
                LANES(court_roll_start)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
            V vx_0 = _o216.vx_0;
            V vy_0 = _o216.vy_0;
            V vz_0 = _o216.vz_0;
            V nx_0 = _o216.nx_0;
            V ny_0 = _o216.ny_0;
            V nz_0 = _o216.nz_0;
            V turn_rate_0 = _o216.turn_rate_0;
            const LANES(court_roll_0_out) _o217 =
                LANES(court_roll_0)(bent_x, bent_y, bent_z, p_gravity, nx_0, ny_0, nz_0, per_reach, turn_rate_0, vx_0, vy_0, vz_0);
            V lift_0 = _o217.lift_0;
            V tx_0 = _o217.tx_0;
            V ty_0 = _o217.ty_0;
            V tz_0 = _o217.tz_0;
            V vx_1 = _o217.vx_1;
            V vy_1 = _o217.vy_1;
            V vz_1 = _o217.vz_1;
            V nx_1 = _o217.nx_1;
            V ny_1 = _o217.ny_1;
            V nz_1 = _o217.nz_1;
            V turn_rate_1 = _o217.turn_rate_1;
            const LANES(court_roll_1_out) _o218 =
                LANES(court_roll_1)(bent_x, bent_y, bent_z, p_gravity, lift_0, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1);
            V lift_1 = _o218.lift_1;
            V tx_1 = _o218.tx_1;
            V ty_1 = _o218.ty_1;
            V tz_1 = _o218.tz_1;
            V vx_2 = _o218.vx_2;
            V vy_2 = _o218.vy_2;
            V vz_2 = _o218.vz_2;
            V nx_2 = _o218.nx_2;
            V ny_2 = _o218.ny_2;
            V nz_2 = _o218.nz_2;
            V turn_rate_2 = _o218.turn_rate_2;
            const LANES(court_roll_2_out) _o219 =
                LANES(court_roll_2)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2);
            V lift_2 = _o219.lift_2;
            V tx_2 = _o219.tx_2;
            V ty_2 = _o219.ty_2;
            V tz_2 = _o219.tz_2;
            V vx_3 = _o219.vx_3;
            V vy_3 = _o219.vy_3;
            V vz_3 = _o219.vz_3;
            V nx_3 = _o219.nx_3;
            V ny_3 = _o219.ny_3;
            V nz_3 = _o219.nz_3;
            V turn_rate_3 = _o219.turn_rate_3;
            const LANES(court_roll_3_out) _o220 =
                LANES(court_roll_3)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3);
            V lift_3 = _o220.lift_3;
            V tx_3 = _o220.tx_3;
            V ty_3 = _o220.ty_3;
            V tz_3 = _o220.tz_3;
            V vx_4 = _o220.vx_4;
            V vy_4 = _o220.vy_4;
            V vz_4 = _o220.vz_4;
            V nx_4 = _o220.nx_4;
            V ny_4 = _o220.ny_4;
            V nz_4 = _o220.nz_4;
            V turn_rate_4 = _o220.turn_rate_4;
            const LANES(court_roll_4_out) _o221 =
                LANES(court_roll_4)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4);
            V lift_4 = _o221.lift_4;
            V tx_4 = _o221.tx_4;
            V ty_4 = _o221.ty_4;
            V tz_4 = _o221.tz_4;
            V vx_5 = _o221.vx_5;
            V vy_5 = _o221.vy_5;
            V vz_5 = _o221.vz_5;
            V nx_5 = _o221.nx_5;
            V ny_5 = _o221.ny_5;
            V nz_5 = _o221.nz_5;
            V turn_rate_5 = _o221.turn_rate_5;
            const LANES(court_roll_5_out) _o222 =
                LANES(court_roll_5)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5);
            V lift_5 = _o222.lift_5;
            V tx_5 = _o222.tx_5;
            V ty_5 = _o222.ty_5;
            V tz_5 = _o222.tz_5;
            V vx_6 = _o222.vx_6;
            V vy_6 = _o222.vy_6;
            V vz_6 = _o222.vz_6;
            V nx_6 = _o222.nx_6;
            V ny_6 = _o222.ny_6;
            V nz_6 = _o222.nz_6;
            V turn_rate_6 = _o222.turn_rate_6;
            const LANES(court_roll_6_out) _o223 =
                LANES(court_roll_6)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6);
            V lift_6 = _o223.lift_6;
            V tx_6 = _o223.tx_6;
            V ty_6 = _o223.ty_6;
            V tz_6 = _o223.tz_6;
            V vx_7 = _o223.vx_7;
            V vy_7 = _o223.vy_7;
            V vz_7 = _o223.vz_7;
            V nx_7 = _o223.nx_7;
            V ny_7 = _o223.ny_7;
            V nz_7 = _o223.nz_7;
            V turn_rate_7 = _o223.turn_rate_7;
            const LANES(court_roll_7_out) _o224 =
                LANES(court_roll_7)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7);
            V lift_7 = _o224.lift_7;
            V vx_8 = _o224.vx_8;
            V vy_8 = _o224.vy_8;
            V vz_8 = _o224.vz_8;
            V nx_8 = _o224.nx_8;
            V ny_8 = _o224.ny_8;
            V nz_8 = _o224.nz_8;
            V turn_rate_8 = _o224.turn_rate_8;
            const LANES(court_roll_pace_out) _o225 =
                LANES(court_roll_pace)(p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, lift_7, nx_8, ny_8, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, nz_8, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8);
            V stride = _o225.stride;
            V strongest = _o225.strongest;
            V fastest = _o225.fastest;
            V force = _o225.force;
            V force_rate = _o225.force_rate;
            V force_bend = _o225.force_bend;
            V brace = _o225.brace;
            const LANES(court_pulled_out) _o226 =
                LANES(court_pulled)(p_gravity, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, turn_rate_0, turn_rate_1, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1);
            V drag = _o226.drag;
            V drag_rate = _o226.drag_rate;
            V strain = _o226.strain;
            V strain_rate = _o226.strain_rate;
            const LANES(court_holding_out) _o227 =
                LANES(court_holding)(held, K(1.0));
            here = _o227.here;
            const M _m228 = lanes_both(active, here);
            {
                const LANES(court_ring_impact_strained_out) _o229 =
                    LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, p_backboard_friction);
                strain = lanes_select(_m228, _o229.strain, strain);
                strain_rate = lanes_select(_m228, _o229.strain_rate, strain_rate);
            }
            const LANES(court_holding_out) _o230 =
                LANES(court_holding)(held, K(2.0));
            here = _o230.here;
            const M _m231 = lanes_both(active, here);
            {
                const LANES(court_ring_impact_strained_out) _o232 =
                    LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, p_bridge_friction);
                strain = lanes_select(_m231, _o232.strain, strain);
                strain_rate = lanes_select(_m231, _o232.strain_rate, strain_rate);
            }
            const LANES(court_losing_out) _o233 =
                LANES(court_losing)(grip_lost, strain);
            M loses = _o233.loses;
            const M _m234 = lanes_both(active, loses);
            if (lanes_any(_m234)) {
                const LANES(court_lost_grip_out) _o235 =
                    LANES(court_lost_grip)(clock, strain, strain_rate, taut, taut_clock, taut_rate);
                grip_lost = lanes_select(_m234, _o235.grip_lost, grip_lost);
            }
            const LANES(court_tightened_out) _o236 =
                LANES(court_tightened)(clock, strain, strain_rate);
            taut = _o236.taut;
            taut_rate = _o236.taut_rate;
            taut_clock = _o236.taut_clock;
            const LANES(court_leaving_force_out) _o237 =
                LANES(court_leaving_force)(p_ball_radius, brace, doubt, fastest, force, force_bend, force_rate, p_gravity, per_reach, position_error, stride, velocity_error, vx, vx_1, vy, vy_1, vz, vz_1, which);
            stride = _o237.stride;
            which = _o237.which;
            M rests = _o237.rests;
            doubt = _o237.doubt;
            const LANES(court_beside_out) _o238 =
                LANES(court_beside)(held, K(0.0));
            M beside = _o238.beside;
            const M _m239 = lanes_both(active, beside);
            if (lanes_any(_m239)) {
                const LANES(court_ring_beside_out) _o240 =
                    LANES(court_ring_beside)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                V gap = _o240.gap;
                V nearing = _o240.nearing;
                V dent = _o240.dent;
                const LANES(court_beside_body_out) _o241 =
                    LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(0.0), late, nearing, position_error, stride, strongest, which, x, y, z);
                stride = lanes_select(_m239, _o241.stride, stride);
                which = lanes_select(_m239, _o241.which, which);
                doubt = lanes_select(_m239, _o241.doubt, doubt);
                late = lanes_select(_m239, _o241.late, late);
            }
            const LANES(court_beside_out) _o242 =
                LANES(court_beside)(held, K(1.0));
            beside = _o242.beside;
            const M _m243 = lanes_both(active, beside);
            if (lanes_any(_m243)) {
                const LANES(court_backboard_beside_out) _o244 =
                    LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                V gap = _o244.gap;
                V nearing = _o244.nearing;
                V dent = _o244.dent;
                const LANES(court_beside_body_out) _o245 =
                    LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(1.0), late, nearing, position_error, stride, strongest, which, x, y, z);
                stride = lanes_select(_m243, _o245.stride, stride);
                which = lanes_select(_m243, _o245.which, which);
                doubt = lanes_select(_m243, _o245.doubt, doubt);
                late = lanes_select(_m243, _o245.late, late);
            }
            const LANES(court_beside_out) _o246 =
                LANES(court_beside)(held, K(2.0));
            beside = _o246.beside;
            const M _m247 = lanes_both(active, beside);
            if (lanes_any(_m247)) {
                const LANES(court_bridge_beside_out) _o248 =
                    LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                V gap = _o248.gap;
                V nearing = _o248.nearing;
                V dent = _o248.dent;
                const LANES(court_beside_body_out) _o249 =
                    LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(2.0), late, nearing, position_error, stride, strongest, which, x, y, z);
                stride = lanes_select(_m247, _o249.stride, stride);
                which = lanes_select(_m247, _o249.which, which);
                doubt = lanes_select(_m247, _o249.doubt, doubt);
                late = lanes_select(_m247, _o249.late, late);
            }
            const LANES(court_end_beside_out) _o250 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            V gap = _o250.gap;
            V nearing = _o250.nearing;
            V dent = _o250.dent;
            const LANES(court_beside_gate_out) _o251 =
                LANES(court_beside_gate)(p_ball_radius, dent, doubt, fastest, gap, K(3.0), late, nearing, position_error, stride, strongest, which, x, y, z);
            stride = _o251.stride;
            which = _o251.which;
            doubt = _o251.doubt;
            late = _o251.late;
            const LANES(court_holding_out) _o252 =
                LANES(court_holding)(held, K(1.0));
            here = _o252.here;
            const M _m253 = lanes_both(active, here);
            if (lanes_any(_m253)) {
                const LANES(court_backboard_seam0_out) _o254 =
                    LANES(court_backboard_seam0)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                gap = lanes_select(_m253, _o254.gap, gap);
                V nearing = _o254.nearing;
                V near = _o254.near;
                const LANES(court_beside_seam_out) _o255 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m253, _o255.stride, stride);
                const LANES(court_backboard_seam1_out) _o256 =
                    LANES(court_backboard_seam1)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                gap = lanes_select(_m253, _o256.gap, gap);
                nearing = _o256.nearing;
                near = _o256.near;
                const LANES(court_beside_seam_out) _o257 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m253, _o257.stride, stride);
                const LANES(court_backboard_seam2_out) _o258 =
                    LANES(court_backboard_seam2)(p_ball_radius, p_board_half_width, vy, y);
                gap = lanes_select(_m253, _o258.gap, gap);
                nearing = _o258.nearing;
                near = _o258.near;
                const LANES(court_beside_seam_out) _o259 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m253, _o259.stride, stride);
                const LANES(court_backboard_seam3_out) _o260 =
                    LANES(court_backboard_seam3)(p_ball_radius, p_board_half_width, vy, y);
                gap = lanes_select(_m253, _o260.gap, gap);
                nearing = _o260.nearing;
                near = _o260.near;
                const LANES(court_beside_seam_out) _o261 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m253, _o261.stride, stride);
                const LANES(court_backboard_seam4_out) _o262 =
                    LANES(court_backboard_seam4)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                gap = lanes_select(_m253, _o262.gap, gap);
                nearing = _o262.nearing;
                near = _o262.near;
                const LANES(court_beside_seam_out) _o263 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m253, _o263.stride, stride);
                const LANES(court_backboard_seam5_out) _o264 =
                    LANES(court_backboard_seam5)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                gap = lanes_select(_m253, _o264.gap, gap);
                nearing = _o264.nearing;
                near = _o264.near;
                const LANES(court_beside_seam_out) _o265 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m253, _o265.stride, stride);
            }
            const LANES(court_holding_out) _o266 =
                LANES(court_holding)(held, K(2.0));
            here = _o266.here;
            const M _m267 = lanes_both(active, here);
            if (lanes_any(_m267)) {
                const LANES(court_bridge_seam0_out) _o268 =
                    LANES(court_bridge_seam0)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                gap = lanes_select(_m267, _o268.gap, gap);
                V nearing = _o268.nearing;
                V near = _o268.near;
                const LANES(court_beside_seam_out) _o269 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m267, _o269.stride, stride);
                const LANES(court_bridge_seam1_out) _o270 =
                    LANES(court_bridge_seam1)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                gap = lanes_select(_m267, _o270.gap, gap);
                nearing = _o270.nearing;
                near = _o270.near;
                const LANES(court_beside_seam_out) _o271 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m267, _o271.stride, stride);
                const LANES(court_bridge_seam2_out) _o272 =
                    LANES(court_bridge_seam2)(p_ball_radius, p_bridge_half_width, vy, y);
                gap = lanes_select(_m267, _o272.gap, gap);
                nearing = _o272.nearing;
                near = _o272.near;
                const LANES(court_beside_seam_out) _o273 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m267, _o273.stride, stride);
                const LANES(court_bridge_seam3_out) _o274 =
                    LANES(court_bridge_seam3)(p_ball_radius, p_bridge_half_width, vy, y);
                gap = lanes_select(_m267, _o274.gap, gap);
                nearing = _o274.nearing;
                near = _o274.near;
                const LANES(court_beside_seam_out) _o275 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m267, _o275.stride, stride);
                const LANES(court_bridge_seam4_out) _o276 =
                    LANES(court_bridge_seam4)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                gap = lanes_select(_m267, _o276.gap, gap);
                nearing = _o276.nearing;
                near = _o276.near;
                const LANES(court_beside_seam_out) _o277 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m267, _o277.stride, stride);
                const LANES(court_bridge_seam5_out) _o278 =
                    LANES(court_bridge_seam5)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                gap = lanes_select(_m267, _o278.gap, gap);
                nearing = _o278.nearing;
                near = _o278.near;
                const LANES(court_beside_seam_out) _o279 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m267, _o279.stride, stride);
            }
            const LANES(court_beside_time_out) _o280 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o280.stride;
            which = _o280.which;
            const LANES(court_apart_out) _o281 =
                LANES(court_apart)(p_ball_radius, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz);
            V apart = _o281.apart;
            const LANES(court_neighbour_out) _o282 =
                LANES(court_neighbour)(apart, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, vx, vy, vz, wx, wy, wz, x, y, z);
            V far_x = _o282.far_x;
            V far_y = _o282.far_y;
            V far_z = _o282.far_z;
            V far_vx = _o282.far_vx;
            V far_vy = _o282.far_vy;
            V far_vz = _o282.far_vz;
            V far_wx = _o282.far_wx;
            V far_wy = _o282.far_wy;
            V far_wz = _o282.far_wz;
            V far_nx = _o282.far_nx;
            V far_ny = _o282.far_ny;
            V far_nz = _o282.far_nz;
            V far_gap = _o282.far_gap;
            const LANES(court_passing_from_out) _o283 =
                LANES(court_passing_from)(z);
            M over = _o283.over;
            const LANES(court_roll_moved_out) _o284 =
                LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, x, y, z);
            x = _o284.x;
            vx = _o284.vx;
            y = _o284.y;
            vy = _o284.vy;
            z = _o284.z;
            vz = _o284.vz;
            V turn_rate = _o284.turn_rate;
            const LANES(court_holding_out) _o285 =
                LANES(court_holding)(held, K(1.0));
            here = _o285.here;
            const M _m286 = lanes_both(active, here);
            if (lanes_any(_m286)) {
                const LANES(court_backboard_normal_out) _o287 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m286, _o287.nx, nx);
                ny = lanes_select(_m286, _o287.ny, ny);
                nz = lanes_select(_m286, _o287.nz, nz);
                const LANES(court_backboard_off_out) _o288 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z);
                gap = lanes_select(_m286, _o288.gap, gap);
            }
            const LANES(court_holding_out) _o289 =
                LANES(court_holding)(held, K(2.0));
            here = _o289.here;
            const M _m290 = lanes_both(active, here);
            if (lanes_any(_m290)) {
                const LANES(court_bridge_normal_out) _o291 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m290, _o291.nx, nx);
                ny = lanes_select(_m290, _o291.ny, ny);
                nz = lanes_select(_m290, _o291.nz, nz);
                const LANES(court_bridge_off_out) _o292 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m290, _o292.gap, gap);
            }
            const LANES(court_roll_placed_out) _o293 =
                LANES(court_roll_placed)(p_ball_radius, gap, nx, ny, nz, turn_rate, vx, vy, vz, x, y, z);
            x = _o293.x;
            y = _o293.y;
            z = _o293.z;
            vx = _o293.vx;
            vy = _o293.vy;
            vz = _o293.vz;
            wx = _o293.wx;
            wy = _o293.wy;
            wz = _o293.wz;
            const LANES(court_passing_in_contact_out) _o294 =
                LANES(court_passing_in_contact)(over, p_ring_radius, through, x, y, z);
            through = _o294.through;
            const LANES(court_holding_out) _o295 =
                LANES(court_holding)(held, K(1.0));
            here = _o295.here;
            const M _m296 = lanes_both(active, here);
            {
                const LANES(court_backboard_normal_out) _o297 =
                    LANES(court_backboard_normal)(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                far_nx = lanes_select(_m296, _o297.nx, far_nx);
                far_ny = lanes_select(_m296, _o297.ny, far_ny);
                far_nz = lanes_select(_m296, _o297.nz, far_nz);
            }
            const LANES(court_holding_out) _o298 =
                LANES(court_holding)(held, K(2.0));
            here = _o298.here;
            const M _m299 = lanes_both(active, here);
            {
                const LANES(court_bridge_normal_out) _o300 =
                    LANES(court_bridge_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                far_nx = lanes_select(_m299, _o300.nx, far_nx);
                far_ny = lanes_select(_m299, _o300.ny, far_ny);
                far_nz = lanes_select(_m299, _o300.nz, far_nz);
            }
            const LANES(court_roll_turn_rate_out) _o301 =
                LANES(court_roll_turn_rate)(p_ball_radius, far_nx, far_ny, far_nz, far_wx, far_wy, far_wz);
            turn_rate = _o301.turn_rate;
            const LANES(court_holding_out) _o302 =
                LANES(court_holding)(held, K(1.0));
            here = _o302.here;
            const M _m303 = lanes_both(active, here);
            if (lanes_any(_m303)) {
                const LANES(court_backboard_normal_out) _o304 =
                    LANES(court_backboard_normal)(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                far_nx = lanes_select(_m303, _o304.nx, far_nx);
                far_ny = lanes_select(_m303, _o304.ny, far_ny);
                far_nz = lanes_select(_m303, _o304.nz, far_nz);
                const LANES(court_backboard_off_out) _o305 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, far_x, far_y, far_z);
                far_gap = lanes_select(_m303, _o305.gap, far_gap);
            }
            const LANES(court_holding_out) _o306 =
                LANES(court_holding)(held, K(2.0));
            here = _o306.here;
            const M _m307 = lanes_both(active, here);
            if (lanes_any(_m307)) {
                const LANES(court_bridge_normal_out) _o308 =
                    LANES(court_bridge_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                far_nx = lanes_select(_m307, _o308.nx, far_nx);
                far_ny = lanes_select(_m307, _o308.ny, far_ny);
                far_nz = lanes_select(_m307, _o308.nz, far_nz);
                const LANES(court_bridge_off_out) _o309 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, far_x, far_y, far_z);
                far_gap = lanes_select(_m307, _o309.gap, far_gap);
            }
            const LANES(court_roll_placed_out) _o310 =
                LANES(court_roll_placed)(p_ball_radius, far_gap, far_nx, far_ny, far_nz, turn_rate, far_vx, far_vy, far_vz, far_x, far_y, far_z);
            far_x = _o310.x;
            far_y = _o310.y;
            far_z = _o310.z;
            far_vx = _o310.vx;
            far_vy = _o310.vy;
            far_vz = _o310.vz;
            far_wx = _o310.wx;
            far_wy = _o310.wy;
            far_wz = _o310.wz;
            const LANES(court_roll_start_out) _o311 =
                LANES(court_roll_start)(p_ball_radius, far_nx, far_ny, far_nz, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz);
            vx_0 = _o311.vx_0;
            vy_0 = _o311.vy_0;
            vz_0 = _o311.vz_0;
            nx_0 = _o311.nx_0;
            ny_0 = _o311.ny_0;
            nz_0 = _o311.nz_0;
            turn_rate_0 = _o311.turn_rate_0;
            const LANES(court_roll_0_out) _o312 =
                LANES(court_roll_0)(bent_x, bent_y, bent_z, p_gravity, nx_0, ny_0, nz_0, per_reach, turn_rate_0, vx_0, vy_0, vz_0);
            lift_0 = _o312.lift_0;
            tx_0 = _o312.tx_0;
            ty_0 = _o312.ty_0;
            tz_0 = _o312.tz_0;
            vx_1 = _o312.vx_1;
            vy_1 = _o312.vy_1;
            vz_1 = _o312.vz_1;
            nx_1 = _o312.nx_1;
            ny_1 = _o312.ny_1;
            nz_1 = _o312.nz_1;
            turn_rate_1 = _o312.turn_rate_1;
            const LANES(court_roll_1_out) _o313 =
                LANES(court_roll_1)(bent_x, bent_y, bent_z, p_gravity, lift_0, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1);
            lift_1 = _o313.lift_1;
            tx_1 = _o313.tx_1;
            ty_1 = _o313.ty_1;
            tz_1 = _o313.tz_1;
            vx_2 = _o313.vx_2;
            vy_2 = _o313.vy_2;
            vz_2 = _o313.vz_2;
            nx_2 = _o313.nx_2;
            ny_2 = _o313.ny_2;
            nz_2 = _o313.nz_2;
            turn_rate_2 = _o313.turn_rate_2;
            const LANES(court_roll_2_out) _o314 =
                LANES(court_roll_2)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2);
            lift_2 = _o314.lift_2;
            tx_2 = _o314.tx_2;
            ty_2 = _o314.ty_2;
            tz_2 = _o314.tz_2;
            vx_3 = _o314.vx_3;
            vy_3 = _o314.vy_3;
            vz_3 = _o314.vz_3;
            nx_3 = _o314.nx_3;
            ny_3 = _o314.ny_3;
            nz_3 = _o314.nz_3;
            turn_rate_3 = _o314.turn_rate_3;
            const LANES(court_roll_3_out) _o315 =
                LANES(court_roll_3)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3);
            lift_3 = _o315.lift_3;
            tx_3 = _o315.tx_3;
            ty_3 = _o315.ty_3;
            tz_3 = _o315.tz_3;
            vx_4 = _o315.vx_4;
            vy_4 = _o315.vy_4;
            vz_4 = _o315.vz_4;
            nx_4 = _o315.nx_4;
            ny_4 = _o315.ny_4;
            nz_4 = _o315.nz_4;
            turn_rate_4 = _o315.turn_rate_4;
            const LANES(court_roll_4_out) _o316 =
                LANES(court_roll_4)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4);
            lift_4 = _o316.lift_4;
            tx_4 = _o316.tx_4;
            ty_4 = _o316.ty_4;
            tz_4 = _o316.tz_4;
            vx_5 = _o316.vx_5;
            vy_5 = _o316.vy_5;
            vz_5 = _o316.vz_5;
            nx_5 = _o316.nx_5;
            ny_5 = _o316.ny_5;
            nz_5 = _o316.nz_5;
            turn_rate_5 = _o316.turn_rate_5;
            const LANES(court_roll_5_out) _o317 =
                LANES(court_roll_5)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5);
            lift_5 = _o317.lift_5;
            tx_5 = _o317.tx_5;
            ty_5 = _o317.ty_5;
            tz_5 = _o317.tz_5;
            vx_6 = _o317.vx_6;
            vy_6 = _o317.vy_6;
            vz_6 = _o317.vz_6;
            nx_6 = _o317.nx_6;
            ny_6 = _o317.ny_6;
            nz_6 = _o317.nz_6;
            turn_rate_6 = _o317.turn_rate_6;
            const LANES(court_roll_6_out) _o318 =
                LANES(court_roll_6)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6);
            lift_6 = _o318.lift_6;
            tx_6 = _o318.tx_6;
            ty_6 = _o318.ty_6;
            tz_6 = _o318.tz_6;
            vx_7 = _o318.vx_7;
            vy_7 = _o318.vy_7;
            vz_7 = _o318.vz_7;
            nx_7 = _o318.nx_7;
            ny_7 = _o318.ny_7;
            nz_7 = _o318.nz_7;
            turn_rate_7 = _o318.turn_rate_7;
            const LANES(court_roll_7_out) _o319 =
                LANES(court_roll_7)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7);
            vx_8 = _o319.vx_8;
            vy_8 = _o319.vy_8;
            vz_8 = _o319.vz_8;
            turn_rate_8 = _o319.turn_rate_8;
            const LANES(court_roll_moved_out) _o320 =
                LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, far_x, far_y, far_z);
            far_x = _o320.x;
            far_vx = _o320.vx;
            far_y = _o320.y;
            far_vy = _o320.vy;
            far_z = _o320.z;
            far_vz = _o320.vz;
            turn_rate = _o320.turn_rate;
            const LANES(court_holding_out) _o321 =
                LANES(court_holding)(held, K(1.0));
            here = _o321.here;
            const M _m322 = lanes_both(active, here);
            if (lanes_any(_m322)) {
                const LANES(court_backboard_normal_out) _o323 =
                    LANES(court_backboard_normal)(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                far_nx = lanes_select(_m322, _o323.nx, far_nx);
                far_ny = lanes_select(_m322, _o323.ny, far_ny);
                far_nz = lanes_select(_m322, _o323.nz, far_nz);
                const LANES(court_backboard_off_out) _o324 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, far_x, far_y, far_z);
                far_gap = lanes_select(_m322, _o324.gap, far_gap);
            }
            const LANES(court_holding_out) _o325 =
                LANES(court_holding)(held, K(2.0));
            here = _o325.here;
            const M _m326 = lanes_both(active, here);
            if (lanes_any(_m326)) {
                const LANES(court_bridge_normal_out) _o327 =
                    LANES(court_bridge_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                far_nx = lanes_select(_m326, _o327.nx, far_nx);
                far_ny = lanes_select(_m326, _o327.ny, far_ny);
                far_nz = lanes_select(_m326, _o327.nz, far_nz);
                const LANES(court_bridge_off_out) _o328 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, far_x, far_y, far_z);
                far_gap = lanes_select(_m326, _o328.gap, far_gap);
            }
            const LANES(court_roll_placed_out) _o329 =
                LANES(court_roll_placed)(p_ball_radius, far_gap, far_nx, far_ny, far_nz, turn_rate, far_vx, far_vy, far_vz, far_x, far_y, far_z);
            far_x = _o329.x;
            far_y = _o329.y;
            far_z = _o329.z;
            far_vx = _o329.vx;
            far_vy = _o329.vy;
            far_vz = _o329.vz;
            far_wx = _o329.wx;
            far_wy = _o329.wy;
            far_wz = _o329.wz;
            const LANES(court_compared_out) _o330 =
                LANES(court_compared)(apart, p_ball_radius, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_x, far_y, far_z, vx, vy, vz, wx, wy, wz, x, y, z);
            dx = _o330.dx;
            dy = _o330.dy;
            dz = _o330.dz;
            dvx = _o330.dvx;
            dvy = _o330.dvy;
            dvz = _o330.dvz;
            dwx = _o330.dwx;
            dwy = _o330.dwy;
            dwz = _o330.dwz;
            const LANES(court_rolled_on_out) _o331 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o331.clock;
            rolling = _o331.rolling;
            turns = lanes_add(turns, K(1.0));
            const M ended = lanes_both(active, lanes_not(lanes_both(rolling, lanes_less(turns, K(16.0)))));
            if (lanes_any(ended)) {
                double ended_row[LANES_WIDTH];
                lanes_store(ended_row, row);
                double ended_clock[LANES_WIDTH];
                lanes_store(ended_clock, clock);
                double ended_doubt[LANES_WIDTH];
                lanes_store(ended_doubt, doubt);
                double ended_dvx[LANES_WIDTH];
                lanes_store(ended_dvx, dvx);
                double ended_dvy[LANES_WIDTH];
                lanes_store(ended_dvy, dvy);
                double ended_dvz[LANES_WIDTH];
                lanes_store(ended_dvz, dvz);
                double ended_dwx[LANES_WIDTH];
                lanes_store(ended_dwx, dwx);
                double ended_dwy[LANES_WIDTH];
                lanes_store(ended_dwy, dwy);
                double ended_dwz[LANES_WIDTH];
                lanes_store(ended_dwz, dwz);
                double ended_dx[LANES_WIDTH];
                lanes_store(ended_dx, dx);
                double ended_dy[LANES_WIDTH];
                lanes_store(ended_dy, dy);
                double ended_dz[LANES_WIDTH];
                lanes_store(ended_dz, dz);
                double ended_grip_lost[LANES_WIDTH];
                lanes_store(ended_grip_lost, grip_lost);
                double ended_late[LANES_WIDTH];
                lanes_store(ended_late, late);
                double ended_per_reach[LANES_WIDTH];
                lanes_store(ended_per_reach, per_reach);
                double ended_position_error[LANES_WIDTH];
                lanes_store(ended_position_error, position_error);
                double ended_rests[LANES_WIDTH];
                lanes_store(ended_rests, lanes_select(rests, K(1.0), K(0.0)));
                double ended_rolling[LANES_WIDTH];
                lanes_store(ended_rolling, lanes_select(rolling, K(1.0), K(0.0)));
                double ended_taut[LANES_WIDTH];
                lanes_store(ended_taut, taut);
                double ended_taut_clock[LANES_WIDTH];
                lanes_store(ended_taut_clock, taut_clock);
                double ended_taut_rate[LANES_WIDTH];
                lanes_store(ended_taut_rate, taut_rate);
                double ended_through[LANES_WIDTH];
                lanes_store(ended_through, through);
                double ended_velocity_error[LANES_WIDTH];
                lanes_store(ended_velocity_error, velocity_error);
                double ended_vx[LANES_WIDTH];
                lanes_store(ended_vx, vx);
                double ended_vy[LANES_WIDTH];
                lanes_store(ended_vy, vy);
                double ended_vz[LANES_WIDTH];
                lanes_store(ended_vz, vz);
                double ended_which[LANES_WIDTH];
                lanes_store(ended_which, which);
                double ended_wx[LANES_WIDTH];
                lanes_store(ended_wx, wx);
                double ended_wy[LANES_WIDTH];
                lanes_store(ended_wy, wy);
                double ended_wz[LANES_WIDTH];
                lanes_store(ended_wz, wz);
                double ended_x[LANES_WIDTH];
                lanes_store(ended_x, x);
                double ended_y[LANES_WIDTH];
                lanes_store(ended_y, y);
                double ended_z[LANES_WIDTH];
                lanes_store(ended_z, z);
                for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                    const int lane = LANES_LOWEST(bits);
                    const size_t k = (size_t)ended_row[lane];
                    lists->kept_clock[k] = ended_clock[lane];
                    lists->kept_doubt[k] = ended_doubt[lane];
                    lists->kept_dvx[k] = ended_dvx[lane];
                    lists->kept_dvy[k] = ended_dvy[lane];
                    lists->kept_dvz[k] = ended_dvz[lane];
                    lists->kept_dwx[k] = ended_dwx[lane];
                    lists->kept_dwy[k] = ended_dwy[lane];
                    lists->kept_dwz[k] = ended_dwz[lane];
                    lists->kept_dx[k] = ended_dx[lane];
                    lists->kept_dy[k] = ended_dy[lane];
                    lists->kept_dz[k] = ended_dz[lane];
                    lists->kept_grip_lost[k] = ended_grip_lost[lane];
                    lists->kept_late[k] = ended_late[lane];
                    lists->kept_per_reach[k] = ended_per_reach[lane];
                    lists->kept_position_error[k] = ended_position_error[lane];
                    lists->kept_rests[k] = ended_rests[lane];
                    lists->kept_rolling[k] = ended_rolling[lane];
                    lists->kept_taut[k] = ended_taut[lane];
                    lists->kept_taut_clock[k] = ended_taut_clock[lane];
                    lists->kept_taut_rate[k] = ended_taut_rate[lane];
                    lists->kept_through[k] = ended_through[lane];
                    lists->kept_velocity_error[k] = ended_velocity_error[lane];
                    lists->kept_vx[k] = ended_vx[lane];
                    lists->kept_vy[k] = ended_vy[lane];
                    lists->kept_vz[k] = ended_vz[lane];
                    lists->kept_which[k] = ended_which[lane];
                    lists->kept_wx[k] = ended_wx[lane];
                    lists->kept_wy[k] = ended_wy[lane];
                    lists->kept_wz[k] = ended_wz[lane];
                    lists->kept_x[k] = ended_x[lane];
                    lists->kept_y[k] = ended_y[lane];
                    lists->kept_z[k] = ended_z[lane];
                }
                busy -= lanes_many(ended);
                active = lanes_both(active, lanes_not(ended));
            }
        }
    }
    }
    {
    size_t kept_circling_shots = 0;
    for (size_t i = 0; i < kept_shots; i += LANES_WIDTH) {
        const M rows = lanes_first(kept_shots - i);
        V circled = lanes_load(lists->kept_circled + i);
        M circling = lanes_less(K(0.0), lanes_load(lists->kept_circling + i));
        V clock = lanes_load(lists->kept_clock + i);
        V clock_error = lanes_load(lists->kept_clock_error + i);
        V doubt = lanes_load(lists->kept_doubt + i);
        V dvx = lanes_load(lists->kept_dvx + i);
        V dvy = lanes_load(lists->kept_dvy + i);
        V dvz = lanes_load(lists->kept_dvz + i);
        V dwx = lanes_load(lists->kept_dwx + i);
        V dwy = lanes_load(lists->kept_dwy + i);
        V dwz = lanes_load(lists->kept_dwz + i);
        V dx = lanes_load(lists->kept_dx + i);
        V dy = lanes_load(lists->kept_dy + i);
        V dz = lanes_load(lists->kept_dz + i);
        V grip_lost = lanes_load(lists->kept_grip_lost + i);
        V late = lanes_load(lists->kept_late + i);
        const V p_ball_radius = lanes_load(varying ? lists->kept_p_ball_radius + i : lists->p_ball_radius);
        const V p_board_bottom = lanes_load(varying ? lists->kept_p_board_bottom + i : lists->p_board_bottom);
        const V p_board_distance = lanes_load(varying ? lists->kept_p_board_distance + i : lists->p_board_distance);
        const V p_board_half_width = lanes_load(varying ? lists->kept_p_board_half_width + i : lists->p_board_half_width);
        const V p_board_thickness = lanes_load(varying ? lists->kept_p_board_thickness + i : lists->p_board_thickness);
        const V p_board_top = lanes_load(varying ? lists->kept_p_board_top + i : lists->p_board_top);
        const V p_bridge_depth = lanes_load(varying ? lists->kept_p_bridge_depth + i : lists->p_bridge_depth);
        const V p_bridge_half_width = lanes_load(varying ? lists->kept_p_bridge_half_width + i : lists->p_bridge_half_width);
        const V p_end_depth = lanes_load(varying ? lists->kept_p_end_depth + i : lists->p_end_depth);
        const V p_gravity = lanes_load(varying ? lists->kept_p_gravity + i : lists->p_gravity);
        const V p_ring_friction = lanes_load(varying ? lists->kept_p_ring_friction + i : lists->p_ring_friction);
        const V p_ring_radius = lanes_load(varying ? lists->kept_p_ring_radius + i : lists->p_ring_radius);
        const V p_wire_radius = lanes_load(varying ? lists->kept_p_wire_radius + i : lists->p_wire_radius);
        V taut = lanes_load(lists->kept_taut + i);
        V taut_clock = lanes_load(lists->kept_taut_clock + i);
        V taut_rate = lanes_load(lists->kept_taut_rate + i);
        V through = lanes_load(lists->kept_through + i);
        V vx = lanes_load(lists->kept_vx + i);
        V vy = lanes_load(lists->kept_vy + i);
        V vz = lanes_load(lists->kept_vz + i);
        V which = lanes_load(lists->kept_which + i);
        V wx = lanes_load(lists->kept_wx + i);
        V wy = lanes_load(lists->kept_wy + i);
        V wz = lanes_load(lists->kept_wz + i);
        V x = lanes_load(lists->kept_x + i);
        V y = lanes_load(lists->kept_y + i);
        V z = lanes_load(lists->kept_z + i);
        const M packed = lanes_both(rows, circling);
        if (lanes_any(packed)) {
            lanes_pack(lists->kept_circling_row + kept_circling_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
            lanes_pack(lists->kept_circling_circled + kept_circling_shots, packed, circled);
            lanes_pack(lists->kept_circling_clock + kept_circling_shots, packed, clock);
            lanes_pack(lists->kept_circling_clock_error + kept_circling_shots, packed, clock_error);
            lanes_pack(lists->kept_circling_doubt + kept_circling_shots, packed, doubt);
            lanes_pack(lists->kept_circling_dvx + kept_circling_shots, packed, dvx);
            lanes_pack(lists->kept_circling_dvy + kept_circling_shots, packed, dvy);
            lanes_pack(lists->kept_circling_dvz + kept_circling_shots, packed, dvz);
            lanes_pack(lists->kept_circling_dwx + kept_circling_shots, packed, dwx);
            lanes_pack(lists->kept_circling_dwy + kept_circling_shots, packed, dwy);
            lanes_pack(lists->kept_circling_dwz + kept_circling_shots, packed, dwz);
            lanes_pack(lists->kept_circling_dx + kept_circling_shots, packed, dx);
            lanes_pack(lists->kept_circling_dy + kept_circling_shots, packed, dy);
            lanes_pack(lists->kept_circling_dz + kept_circling_shots, packed, dz);
            lanes_pack(lists->kept_circling_grip_lost + kept_circling_shots, packed, grip_lost);
            lanes_pack(lists->kept_circling_late + kept_circling_shots, packed, late);
            if (varying)
                lanes_pack(lists->kept_circling_p_ball_radius + kept_circling_shots, packed, p_ball_radius);
            if (varying)
                lanes_pack(lists->kept_circling_p_board_bottom + kept_circling_shots, packed, p_board_bottom);
            if (varying)
                lanes_pack(lists->kept_circling_p_board_distance + kept_circling_shots, packed, p_board_distance);
            if (varying)
                lanes_pack(lists->kept_circling_p_board_half_width + kept_circling_shots, packed, p_board_half_width);
            if (varying)
                lanes_pack(lists->kept_circling_p_board_thickness + kept_circling_shots, packed, p_board_thickness);
            if (varying)
                lanes_pack(lists->kept_circling_p_board_top + kept_circling_shots, packed, p_board_top);
            if (varying)
                lanes_pack(lists->kept_circling_p_bridge_depth + kept_circling_shots, packed, p_bridge_depth);
            if (varying)
                lanes_pack(lists->kept_circling_p_bridge_half_width + kept_circling_shots, packed, p_bridge_half_width);
            if (varying)
                lanes_pack(lists->kept_circling_p_end_depth + kept_circling_shots, packed, p_end_depth);
            if (varying)
                lanes_pack(lists->kept_circling_p_gravity + kept_circling_shots, packed, p_gravity);
            if (varying)
                lanes_pack(lists->kept_circling_p_ring_friction + kept_circling_shots, packed, p_ring_friction);
            if (varying)
                lanes_pack(lists->kept_circling_p_ring_radius + kept_circling_shots, packed, p_ring_radius);
            if (varying)
                lanes_pack(lists->kept_circling_p_wire_radius + kept_circling_shots, packed, p_wire_radius);
            lanes_pack(lists->kept_circling_taut + kept_circling_shots, packed, taut);
            lanes_pack(lists->kept_circling_taut_clock + kept_circling_shots, packed, taut_clock);
            lanes_pack(lists->kept_circling_taut_rate + kept_circling_shots, packed, taut_rate);
            lanes_pack(lists->kept_circling_through + kept_circling_shots, packed, through);
            lanes_pack(lists->kept_circling_vx + kept_circling_shots, packed, vx);
            lanes_pack(lists->kept_circling_vy + kept_circling_shots, packed, vy);
            lanes_pack(lists->kept_circling_vz + kept_circling_shots, packed, vz);
            lanes_pack(lists->kept_circling_which + kept_circling_shots, packed, which);
            lanes_pack(lists->kept_circling_wx + kept_circling_shots, packed, wx);
            lanes_pack(lists->kept_circling_wy + kept_circling_shots, packed, wy);
            lanes_pack(lists->kept_circling_wz + kept_circling_shots, packed, wz);
            lanes_pack(lists->kept_circling_x + kept_circling_shots, packed, x);
            lanes_pack(lists->kept_circling_y + kept_circling_shots, packed, y);
            lanes_pack(lists->kept_circling_z + kept_circling_shots, packed, z);
            kept_circling_shots += lanes_many(packed);
        }
    }
    {
        size_t taken = 0, busy = 0;
        M active = lanes_nowhere();
        V row = K(0.0), turns = K(0.0);
        V p_ball_radius = lanes_load(lists->p_ball_radius);
        V p_board_bottom = lanes_load(lists->p_board_bottom);
        V p_board_distance = lanes_load(lists->p_board_distance);
        V p_board_half_width = lanes_load(lists->p_board_half_width);
        V p_board_thickness = lanes_load(lists->p_board_thickness);
        V p_board_top = lanes_load(lists->p_board_top);
        V p_bridge_depth = lanes_load(lists->p_bridge_depth);
        V p_bridge_half_width = lanes_load(lists->p_bridge_half_width);
        V p_end_depth = lanes_load(lists->p_end_depth);
        V p_gravity = lanes_load(lists->p_gravity);
        V p_ring_friction = lanes_load(lists->p_ring_friction);
        V p_ring_radius = lanes_load(lists->p_ring_radius);
        V p_wire_radius = lanes_load(lists->p_wire_radius);
        V circled = K(0.0);
        V clock = K(0.0);
        V clock_error = K(0.0);
        V doubt = K(0.0);
        V dvx = K(0.0);
        V dvy = K(0.0);
        V dvz = K(0.0);
        V dwx = K(0.0);
        V dwy = K(0.0);
        V dwz = K(0.0);
        V dx = K(0.0);
        V dy = K(0.0);
        V dz = K(0.0);
        V grip_lost = K(0.0);
        V late = K(0.0);
        V taut = K(0.0);
        V taut_clock = K(0.0);
        V taut_rate = K(0.0);
        V through = K(0.0);
        V vx = K(0.0);
        V vy = K(0.0);
        V vz = K(0.0);
        V which = K(0.0);
        V wx = K(0.0);
        V wy = K(0.0);
        V wz = K(0.0);
        V x = K(0.0);
        V y = K(0.0);
        V z = K(0.0);
        for (;;) {
            if (taken < kept_circling_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                const M idle = lanes_not(active);
                row = lanes_expand(lists->kept_circling_row + taken, idle, row);
                turns = lanes_select(idle, K(0.0), turns);
                circled = lanes_expand(lists->kept_circling_circled + taken, idle, circled);
                clock = lanes_expand(lists->kept_circling_clock + taken, idle, clock);
                clock_error = lanes_expand(lists->kept_circling_clock_error + taken, idle, clock_error);
                doubt = lanes_expand(lists->kept_circling_doubt + taken, idle, doubt);
                dvx = lanes_expand(lists->kept_circling_dvx + taken, idle, dvx);
                dvy = lanes_expand(lists->kept_circling_dvy + taken, idle, dvy);
                dvz = lanes_expand(lists->kept_circling_dvz + taken, idle, dvz);
                dwx = lanes_expand(lists->kept_circling_dwx + taken, idle, dwx);
                dwy = lanes_expand(lists->kept_circling_dwy + taken, idle, dwy);
                dwz = lanes_expand(lists->kept_circling_dwz + taken, idle, dwz);
                dx = lanes_expand(lists->kept_circling_dx + taken, idle, dx);
                dy = lanes_expand(lists->kept_circling_dy + taken, idle, dy);
                dz = lanes_expand(lists->kept_circling_dz + taken, idle, dz);
                grip_lost = lanes_expand(lists->kept_circling_grip_lost + taken, idle, grip_lost);
                late = lanes_expand(lists->kept_circling_late + taken, idle, late);
                taut = lanes_expand(lists->kept_circling_taut + taken, idle, taut);
                taut_clock = lanes_expand(lists->kept_circling_taut_clock + taken, idle, taut_clock);
                taut_rate = lanes_expand(lists->kept_circling_taut_rate + taken, idle, taut_rate);
                through = lanes_expand(lists->kept_circling_through + taken, idle, through);
                vx = lanes_expand(lists->kept_circling_vx + taken, idle, vx);
                vy = lanes_expand(lists->kept_circling_vy + taken, idle, vy);
                vz = lanes_expand(lists->kept_circling_vz + taken, idle, vz);
                which = lanes_expand(lists->kept_circling_which + taken, idle, which);
                wx = lanes_expand(lists->kept_circling_wx + taken, idle, wx);
                wy = lanes_expand(lists->kept_circling_wy + taken, idle, wy);
                wz = lanes_expand(lists->kept_circling_wz + taken, idle, wz);
                x = lanes_expand(lists->kept_circling_x + taken, idle, x);
                y = lanes_expand(lists->kept_circling_y + taken, idle, y);
                z = lanes_expand(lists->kept_circling_z + taken, idle, z);
                if (varying) {
                    p_ball_radius = lanes_expand(lists->kept_circling_p_ball_radius + taken, idle, p_ball_radius);
                    p_board_bottom = lanes_expand(lists->kept_circling_p_board_bottom + taken, idle, p_board_bottom);
                    p_board_distance = lanes_expand(lists->kept_circling_p_board_distance + taken, idle, p_board_distance);
                    p_board_half_width = lanes_expand(lists->kept_circling_p_board_half_width + taken, idle, p_board_half_width);
                    p_board_thickness = lanes_expand(lists->kept_circling_p_board_thickness + taken, idle, p_board_thickness);
                    p_board_top = lanes_expand(lists->kept_circling_p_board_top + taken, idle, p_board_top);
                    p_bridge_depth = lanes_expand(lists->kept_circling_p_bridge_depth + taken, idle, p_bridge_depth);
                    p_bridge_half_width = lanes_expand(lists->kept_circling_p_bridge_half_width + taken, idle, p_bridge_half_width);
                    p_end_depth = lanes_expand(lists->kept_circling_p_end_depth + taken, idle, p_end_depth);
                    p_gravity = lanes_expand(lists->kept_circling_p_gravity + taken, idle, p_gravity);
                    p_ring_friction = lanes_expand(lists->kept_circling_p_ring_friction + taken, idle, p_ring_friction);
                    p_ring_radius = lanes_expand(lists->kept_circling_p_ring_radius + taken, idle, p_ring_radius);
                    p_wire_radius = lanes_expand(lists->kept_circling_p_wire_radius + taken, idle, p_wire_radius);
                }
                const size_t room = LANES_WIDTH - busy, left = kept_circling_shots - taken;
                active = lanes_leading(idle, left, active);
                taken += left < room ? left : room;
                busy += left < room ? left : room;
            }
            if (busy == 0)
                break;
            M circling = active;
            const LANES(court_error_bounds_out) _o332 =
                LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            V position_error = _o332.position_error;
            V velocity_error = _o332.velocity_error;
            const LANES(court_ring_tube_out) _o333 =
                LANES(court_ring_tube)(p_ball_radius, p_wire_radius);
            V per_reach = _o333.per_reach;
            const LANES(court_ring_round_start_out) _o334 =
                LANES(court_ring_round_start)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, wx, wy, wz, x, y, z);
            V cosine_0 = _o334.cosine_0;
            V sine_0 = _o334.sine_0;
            V climb_0 = _o334.climb_0;
            V along_0 = _o334.along_0;
            V turn_rate_0 = _o334.turn_rate_0;
            V cos_0 = _o334.cos_0;
            V sin_0 = _o334.sin_0;
            V near_0 = _o334.near_0;
            const LANES(court_ring_round_0_out) _o335 =
                LANES(court_ring_round_0)(along_0, p_ball_radius, climb_0, cos_0, cosine_0, p_gravity, near_0, p_ring_radius, sin_0, sine_0, turn_rate_0, p_wire_radius);
            V omega_0 = _o335.omega_0;
            V around_0 = _o335.around_0;
            V tilted_0 = _o335.tilted_0;
            V pressed_0 = _o335.pressed_0;
            V force_0 = _o335.force_0;
            V cosine_1 = _o335.cosine_1;
            V sine_1 = _o335.sine_1;
            V climb_1 = _o335.climb_1;
            V along_1 = _o335.along_1;
            V turn_rate_1 = _o335.turn_rate_1;
            V cos_1 = _o335.cos_1;
            V sin_1 = _o335.sin_1;
            const LANES(court_ring_round_1_out) _o336 =
                LANES(court_ring_round_1)(along_0, along_1, around_0, p_ball_radius, climb_0, climb_1, cos_0, cos_1, cosine_0, cosine_1, p_gravity, near_0, omega_0, pressed_0, p_ring_radius, sin_0, sin_1, sine_0, sine_1, tilted_0, turn_rate_0, turn_rate_1, p_wire_radius);
            V near_1 = _o336.near_1;
            V omega_1 = _o336.omega_1;
            V around_1 = _o336.around_1;
            V tilted_1 = _o336.tilted_1;
            V pressed_1 = _o336.pressed_1;
            V force_1 = _o336.force_1;
            V cosine_2 = _o336.cosine_2;
            V sine_2 = _o336.sine_2;
            V climb_2 = _o336.climb_2;
            V along_2 = _o336.along_2;
            V turn_rate_2 = _o336.turn_rate_2;
            V cos_2 = _o336.cos_2;
            V sin_2 = _o336.sin_2;
            const LANES(court_ring_round_2_out) _o337 =
                LANES(court_ring_round_2)(along_0, along_1, along_2, around_0, around_1, p_ball_radius, climb_0, climb_1, climb_2, cos_0, cos_1, cos_2, cosine_0, cosine_1, cosine_2, p_gravity, near_0, near_1, omega_0, omega_1, pressed_0, pressed_1, p_ring_radius, sin_0, sin_1, sin_2, sine_0, sine_1, sine_2, tilted_0, tilted_1, turn_rate_0, turn_rate_1, turn_rate_2, p_wire_radius);
            V near_2 = _o337.near_2;
            V omega_2 = _o337.omega_2;
            V around_2 = _o337.around_2;
            V tilted_2 = _o337.tilted_2;
            V pressed_2 = _o337.pressed_2;
            V force_2 = _o337.force_2;
            V cosine_3 = _o337.cosine_3;
            V sine_3 = _o337.sine_3;
            V climb_3 = _o337.climb_3;
            V along_3 = _o337.along_3;
            V turn_rate_3 = _o337.turn_rate_3;
            V cos_3 = _o337.cos_3;
            V sin_3 = _o337.sin_3;
            const LANES(court_ring_round_3_out) _o338 =
                LANES(court_ring_round_3)(along_0, along_1, along_2, along_3, around_0, around_1, around_2, p_ball_radius, climb_0, climb_1, climb_2, climb_3, cos_0, cos_1, cos_2, cos_3, cosine_0, cosine_1, cosine_2, cosine_3, p_gravity, near_0, near_1, near_2, omega_0, omega_1, omega_2, pressed_0, pressed_1, pressed_2, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sine_0, sine_1, sine_2, sine_3, tilted_0, tilted_1, tilted_2, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, p_wire_radius);
            V near_3 = _o338.near_3;
            V omega_3 = _o338.omega_3;
            V around_3 = _o338.around_3;
            V tilted_3 = _o338.tilted_3;
            V pressed_3 = _o338.pressed_3;
            V force_3 = _o338.force_3;
            V cosine_4 = _o338.cosine_4;
            V sine_4 = _o338.sine_4;
            V climb_4 = _o338.climb_4;
            V along_4 = _o338.along_4;
            V turn_rate_4 = _o338.turn_rate_4;
            V cos_4 = _o338.cos_4;
            V sin_4 = _o338.sin_4;
            const LANES(court_ring_round_4_out) _o339 =
                LANES(court_ring_round_4)(along_0, along_1, along_2, along_3, along_4, around_0, around_1, around_2, around_3, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, cos_0, cos_1, cos_2, cos_3, cos_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, p_gravity, near_0, near_1, near_2, near_3, omega_0, omega_1, omega_2, omega_3, pressed_0, pressed_1, pressed_2, pressed_3, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sine_0, sine_1, sine_2, sine_3, sine_4, tilted_0, tilted_1, tilted_2, tilted_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, p_wire_radius);
            V near_4 = _o339.near_4;
            V omega_4 = _o339.omega_4;
            V around_4 = _o339.around_4;
            V tilted_4 = _o339.tilted_4;
            V pressed_4 = _o339.pressed_4;
            V force_4 = _o339.force_4;
            V cosine_5 = _o339.cosine_5;
            V sine_5 = _o339.sine_5;
            V climb_5 = _o339.climb_5;
            V along_5 = _o339.along_5;
            V turn_rate_5 = _o339.turn_rate_5;
            V cos_5 = _o339.cos_5;
            V sin_5 = _o339.sin_5;
            const LANES(court_ring_round_5_out) _o340 =
                LANES(court_ring_round_5)(along_0, along_1, along_2, along_3, along_4, along_5, around_0, around_1, around_2, around_3, around_4, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, p_gravity, near_0, near_1, near_2, near_3, near_4, omega_0, omega_1, omega_2, omega_3, omega_4, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, p_wire_radius);
            V near_5 = _o340.near_5;
            V omega_5 = _o340.omega_5;
            V around_5 = _o340.around_5;
            V tilted_5 = _o340.tilted_5;
            V pressed_5 = _o340.pressed_5;
            V force_5 = _o340.force_5;
            V cosine_6 = _o340.cosine_6;
            V sine_6 = _o340.sine_6;
            V climb_6 = _o340.climb_6;
            V along_6 = _o340.along_6;
            V turn_rate_6 = _o340.turn_rate_6;
            V cos_6 = _o340.cos_6;
            V sin_6 = _o340.sin_6;
            const LANES(court_ring_round_6_out) _o341 =
                LANES(court_ring_round_6)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, around_0, around_1, around_2, around_3, around_4, around_5, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, p_wire_radius);
            V near_6 = _o341.near_6;
            V omega_6 = _o341.omega_6;
            V around_6 = _o341.around_6;
            V tilted_6 = _o341.tilted_6;
            V pressed_6 = _o341.pressed_6;
            V force_6 = _o341.force_6;
            V cosine_7 = _o341.cosine_7;
            V sine_7 = _o341.sine_7;
            V climb_7 = _o341.climb_7;
            V along_7 = _o341.along_7;
            V turn_rate_7 = _o341.turn_rate_7;
            V cos_7 = _o341.cos_7;
            V sin_7 = _o341.sin_7;
            const LANES(court_ring_round_7_out) _o342 =
                LANES(court_ring_round_7)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, p_wire_radius);
            V near_7 = _o342.near_7;
            V omega_7 = _o342.omega_7;
            V around_7 = _o342.around_7;
            V tilted_7 = _o342.tilted_7;
            V pressed_7 = _o342.pressed_7;
            V force_7 = _o342.force_7;
            V cosine_8 = _o342.cosine_8;
            V sine_8 = _o342.sine_8;
            V climb_8 = _o342.climb_8;
            V along_8 = _o342.along_8;
            V turn_rate_8 = _o342.turn_rate_8;
            V cos_8 = _o342.cos_8;
            V sin_8 = _o342.sin_8;
            const LANES(court_ring_round_8_out) _o343 =
                LANES(court_ring_round_8)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, p_wire_radius);
            V near_8 = _o343.near_8;
            V omega_8 = _o343.omega_8;
            V around_8 = _o343.around_8;
            V tilted_8 = _o343.tilted_8;
            V pressed_8 = _o343.pressed_8;
            V force_8 = _o343.force_8;
            V cosine_9 = _o343.cosine_9;
            V sine_9 = _o343.sine_9;
            V climb_9 = _o343.climb_9;
            V along_9 = _o343.along_9;
            V turn_rate_9 = _o343.turn_rate_9;
            V cos_9 = _o343.cos_9;
            V sin_9 = _o343.sin_9;
            const LANES(court_ring_round_9_out) _o344 =
                LANES(court_ring_round_9)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V near_9 = _o344.near_9;
            V omega_9 = _o344.omega_9;
            V around_9 = _o344.around_9;
            V tilted_9 = _o344.tilted_9;
            V pressed_9 = _o344.pressed_9;
            V force_9 = _o344.force_9;
            V cosine_10 = _o344.cosine_10;
            V sine_10 = _o344.sine_10;
            V climb_10 = _o344.climb_10;
            V along_10 = _o344.along_10;
            V turn_rate_10 = _o344.turn_rate_10;
            V cos_10 = _o344.cos_10;
            V sin_10 = _o344.sin_10;
            const LANES(court_ring_round_10_out) _o345 =
                LANES(court_ring_round_10)(along_0, along_1, along_10, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V near_10 = _o345.near_10;
            V omega_10 = _o345.omega_10;
            V around_10 = _o345.around_10;
            V tilted_10 = _o345.tilted_10;
            V pressed_10 = _o345.pressed_10;
            V force_10 = _o345.force_10;
            V cosine_11 = _o345.cosine_11;
            V sine_11 = _o345.sine_11;
            V climb_11 = _o345.climb_11;
            V along_11 = _o345.along_11;
            V turn_rate_11 = _o345.turn_rate_11;
            V cos_11 = _o345.cos_11;
            V sin_11 = _o345.sin_11;
            const LANES(court_ring_round_11_out) _o346 =
                LANES(court_ring_round_11)(along_0, along_1, along_10, along_11, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_10, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_10, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_10, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_10, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V force_11 = _o346.force_11;
            V cosine_12 = _o346.cosine_12;
            V sine_12 = _o346.sine_12;
            V climb_12 = _o346.climb_12;
            V along_12 = _o346.along_12;
            V turn_rate_12 = _o346.turn_rate_12;
            V cos_12 = _o346.cos_12;
            V sin_12 = _o346.sin_12;
            const LANES(court_ring_round_pace_out) _o347 =
                LANES(court_ring_round_pace)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_12, cosine_0, cosine_12, force_0, force_1, force_10, force_11, force_2, force_3, force_4, force_5, force_6, force_7, force_8, force_9, p_gravity, omega_0, p_ring_radius, sin_0, sin_12, sine_0, sine_12, turn_rate_0, turn_rate_11, turn_rate_12, p_wire_radius);
            V stride = _o347.stride;
            V strongest = _o347.strongest;
            V fastest = _o347.fastest;
            V sway = _o347.sway;
            V force = _o347.force;
            V force_rate = _o347.force_rate;
            V force_bend = _o347.force_bend;
            V brace = _o347.brace;
            V vx_1 = _o347.vx_1;
            V vy_1 = _o347.vy_1;
            V vz_1 = _o347.vz_1;
            const LANES(court_ring_round_pulled_out) _o348 =
                LANES(court_ring_round_pulled)(climb_0, climb_1, cosine_0, cosine_1, p_gravity, omega_0, omega_1, turn_rate_0, turn_rate_1);
            V drag = _o348.drag;
            V drag_rate = _o348.drag_rate;
            const LANES(court_ring_impact_strained_out) _o349 =
                LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, p_ring_friction);
            V strain = _o349.strain;
            V strain_rate = _o349.strain_rate;
            const LANES(court_losing_out) _o350 =
                LANES(court_losing)(grip_lost, strain);
            M loses = _o350.loses;
            const M _m351 = lanes_both(active, loses);
            if (lanes_any(_m351)) {
                const LANES(court_lost_grip_out) _o352 =
                    LANES(court_lost_grip)(clock, strain, strain_rate, taut, taut_clock, taut_rate);
                grip_lost = lanes_select(_m351, _o352.grip_lost, grip_lost);
            }
            const LANES(court_tightened_out) _o353 =
                LANES(court_tightened)(clock, strain, strain_rate);
            taut = _o353.taut;
            taut_rate = _o353.taut_rate;
            taut_clock = _o353.taut_clock;
            const LANES(court_leaving_force_out) _o354 =
                LANES(court_leaving_force)(p_ball_radius, brace, doubt, fastest, force, force_bend, force_rate, p_gravity, per_reach, position_error, stride, velocity_error, vx, vx_1, vy, vy_1, vz, vz_1, which);
            stride = _o354.stride;
            which = _o354.which;
            M rests = _o354.rests;
            doubt = _o354.doubt;
            const LANES(court_backboard_beside_out) _o355 =
                LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            V gap = _o355.gap;
            V nearing = _o355.nearing;
            V dent = _o355.dent;
            const LANES(court_beside_body_out) _o356 =
                LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(1.0), late, nearing, position_error, stride, strongest, which, x, y, z);
            stride = _o356.stride;
            which = _o356.which;
            doubt = _o356.doubt;
            late = _o356.late;
            const LANES(court_bridge_beside_out) _o357 =
                LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o357.gap;
            nearing = _o357.nearing;
            dent = _o357.dent;
            const LANES(court_beside_body_out) _o358 =
                LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(2.0), late, nearing, position_error, stride, strongest, which, x, y, z);
            stride = _o358.stride;
            which = _o358.which;
            doubt = _o358.doubt;
            late = _o358.late;
            const LANES(court_end_beside_out) _o359 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o359.gap;
            nearing = _o359.nearing;
            dent = _o359.dent;
            const LANES(court_beside_gate_out) _o360 =
                LANES(court_beside_gate)(p_ball_radius, dent, doubt, fastest, gap, K(3.0), late, nearing, position_error, stride, strongest, which, x, y, z);
            stride = _o360.stride;
            which = _o360.which;
            doubt = _o360.doubt;
            late = _o360.late;
            const LANES(court_beside_time_out) _o361 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o361.stride;
            which = _o361.which;
            const LANES(court_apart_out) _o362 =
                LANES(court_apart)(p_ball_radius, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz);
            V apart = _o362.apart;
            const LANES(court_neighbour_out) _o363 =
                LANES(court_neighbour)(apart, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, vx, vy, vz, wx, wy, wz, x, y, z);
            V far_x = _o363.far_x;
            V far_y = _o363.far_y;
            V far_z = _o363.far_z;
            V far_vx = _o363.far_vx;
            V far_vy = _o363.far_vy;
            V far_vz = _o363.far_vz;
            V far_wx = _o363.far_wx;
            V far_wy = _o363.far_wy;
            V far_wz = _o363.far_wz;
            const LANES(court_passing_from_out) _o364 =
                LANES(court_passing_from)(z);
            M over = _o364.over;
            const LANES(court_alone_out) _o365 =
                LANES(court_alone)();
            V berth = _o365.nearest;
            const LANES(court_leaps_out) _o366 =
                LANES(court_leaps)(stride);
            V forth = _o366.forth;
            V back = _o366.back;
            const LANES(court_backboard_around_out) _o367 =
                LANES(court_backboard_around)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            gap = _o367.gap;
            nearing = _o367.nearing;
            const LANES(court_cleared_out) _o368 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o368.berth;
            const LANES(court_bridge_around_out) _o369 =
                LANES(court_bridge_around)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o369.gap;
            nearing = _o369.nearing;
            const LANES(court_cleared_out) _o370 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o370.berth;
            const LANES(court_end_around_out) _o371 =
                LANES(court_end_around)(p_end_depth, vz, z);
            gap = _o371.gap;
            nearing = _o371.nearing;
            const LANES(court_cleared_out) _o372 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o372.berth;
            const LANES(court_ring_round_moved_out) _o373 =
                LANES(court_ring_round_moved)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_12, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_12, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_12, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_12, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, stride, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_12, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            x = _o373.x;
            y = _o373.y;
            z = _o373.z;
            vx = _o373.vx;
            vy = _o373.vy;
            vz = _o373.vz;
            wx = _o373.wx;
            wy = _o373.wy;
            wz = _o373.wz;
            V climb = _o373.climb;
            const LANES(court_passing_in_contact_out) _o374 =
                LANES(court_passing_in_contact)(over, p_ring_radius, through, x, y, z);
            through = _o374.through;
            const LANES(court_backboard_around_out) _o375 =
                LANES(court_backboard_around)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            gap = _o375.gap;
            nearing = _o375.nearing;
            const LANES(court_cleared_out) _o376 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o376.berth;
            const LANES(court_bridge_around_out) _o377 =
                LANES(court_bridge_around)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o377.gap;
            nearing = _o377.nearing;
            const LANES(court_cleared_out) _o378 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o378.berth;
            const LANES(court_end_around_out) _o379 =
                LANES(court_end_around)(p_end_depth, vz, z);
            gap = _o379.gap;
            nearing = _o379.nearing;
            const LANES(court_cleared_out) _o380 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o380.berth;
            const LANES(court_ring_swung_out) _o381 =
                LANES(court_ring_swung)(p_ball_radius, berth, circled, climb, climb_0, doubt, fastest, force, force_bend, force_rate, p_gravity, position_error, stride, sway, velocity_error, which, p_wire_radius);
            circled = _o381.circled;
            M endless = _o381.endless;
            doubt = _o381.doubt;
            const LANES(court_for_ever_out) _o382 =
                LANES(court_for_ever)(endless, which);
            which = _o382.which;
            const LANES(court_ring_round_start_out) _o383 =
                LANES(court_ring_round_start)(p_ball_radius, p_ring_radius, far_vx, far_vy, far_vz, p_wire_radius, far_wx, far_wy, far_wz, far_x, far_y, far_z);
            cosine_0 = _o383.cosine_0;
            sine_0 = _o383.sine_0;
            climb_0 = _o383.climb_0;
            along_0 = _o383.along_0;
            turn_rate_0 = _o383.turn_rate_0;
            cos_0 = _o383.cos_0;
            sin_0 = _o383.sin_0;
            near_0 = _o383.near_0;
            const LANES(court_ring_round_0_out) _o384 =
                LANES(court_ring_round_0)(along_0, p_ball_radius, climb_0, cos_0, cosine_0, p_gravity, near_0, p_ring_radius, sin_0, sine_0, turn_rate_0, p_wire_radius);
            omega_0 = _o384.omega_0;
            around_0 = _o384.around_0;
            tilted_0 = _o384.tilted_0;
            pressed_0 = _o384.pressed_0;
            cosine_1 = _o384.cosine_1;
            sine_1 = _o384.sine_1;
            climb_1 = _o384.climb_1;
            along_1 = _o384.along_1;
            turn_rate_1 = _o384.turn_rate_1;
            cos_1 = _o384.cos_1;
            sin_1 = _o384.sin_1;
            const LANES(court_ring_round_1_out) _o385 =
                LANES(court_ring_round_1)(along_0, along_1, around_0, p_ball_radius, climb_0, climb_1, cos_0, cos_1, cosine_0, cosine_1, p_gravity, near_0, omega_0, pressed_0, p_ring_radius, sin_0, sin_1, sine_0, sine_1, tilted_0, turn_rate_0, turn_rate_1, p_wire_radius);
            near_1 = _o385.near_1;
            omega_1 = _o385.omega_1;
            around_1 = _o385.around_1;
            tilted_1 = _o385.tilted_1;
            pressed_1 = _o385.pressed_1;
            cosine_2 = _o385.cosine_2;
            sine_2 = _o385.sine_2;
            climb_2 = _o385.climb_2;
            along_2 = _o385.along_2;
            turn_rate_2 = _o385.turn_rate_2;
            cos_2 = _o385.cos_2;
            sin_2 = _o385.sin_2;
            const LANES(court_ring_round_2_out) _o386 =
                LANES(court_ring_round_2)(along_0, along_1, along_2, around_0, around_1, p_ball_radius, climb_0, climb_1, climb_2, cos_0, cos_1, cos_2, cosine_0, cosine_1, cosine_2, p_gravity, near_0, near_1, omega_0, omega_1, pressed_0, pressed_1, p_ring_radius, sin_0, sin_1, sin_2, sine_0, sine_1, sine_2, tilted_0, tilted_1, turn_rate_0, turn_rate_1, turn_rate_2, p_wire_radius);
            near_2 = _o386.near_2;
            omega_2 = _o386.omega_2;
            around_2 = _o386.around_2;
            tilted_2 = _o386.tilted_2;
            pressed_2 = _o386.pressed_2;
            cosine_3 = _o386.cosine_3;
            sine_3 = _o386.sine_3;
            climb_3 = _o386.climb_3;
            along_3 = _o386.along_3;
            turn_rate_3 = _o386.turn_rate_3;
            cos_3 = _o386.cos_3;
            sin_3 = _o386.sin_3;
            const LANES(court_ring_round_3_out) _o387 =
                LANES(court_ring_round_3)(along_0, along_1, along_2, along_3, around_0, around_1, around_2, p_ball_radius, climb_0, climb_1, climb_2, climb_3, cos_0, cos_1, cos_2, cos_3, cosine_0, cosine_1, cosine_2, cosine_3, p_gravity, near_0, near_1, near_2, omega_0, omega_1, omega_2, pressed_0, pressed_1, pressed_2, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sine_0, sine_1, sine_2, sine_3, tilted_0, tilted_1, tilted_2, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, p_wire_radius);
            near_3 = _o387.near_3;
            omega_3 = _o387.omega_3;
            around_3 = _o387.around_3;
            tilted_3 = _o387.tilted_3;
            pressed_3 = _o387.pressed_3;
            cosine_4 = _o387.cosine_4;
            sine_4 = _o387.sine_4;
            climb_4 = _o387.climb_4;
            along_4 = _o387.along_4;
            turn_rate_4 = _o387.turn_rate_4;
            cos_4 = _o387.cos_4;
            sin_4 = _o387.sin_4;
            const LANES(court_ring_round_4_out) _o388 =
                LANES(court_ring_round_4)(along_0, along_1, along_2, along_3, along_4, around_0, around_1, around_2, around_3, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, cos_0, cos_1, cos_2, cos_3, cos_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, p_gravity, near_0, near_1, near_2, near_3, omega_0, omega_1, omega_2, omega_3, pressed_0, pressed_1, pressed_2, pressed_3, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sine_0, sine_1, sine_2, sine_3, sine_4, tilted_0, tilted_1, tilted_2, tilted_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, p_wire_radius);
            near_4 = _o388.near_4;
            omega_4 = _o388.omega_4;
            around_4 = _o388.around_4;
            tilted_4 = _o388.tilted_4;
            pressed_4 = _o388.pressed_4;
            cosine_5 = _o388.cosine_5;
            sine_5 = _o388.sine_5;
            climb_5 = _o388.climb_5;
            along_5 = _o388.along_5;
            turn_rate_5 = _o388.turn_rate_5;
            cos_5 = _o388.cos_5;
            sin_5 = _o388.sin_5;
            const LANES(court_ring_round_5_out) _o389 =
                LANES(court_ring_round_5)(along_0, along_1, along_2, along_3, along_4, along_5, around_0, around_1, around_2, around_3, around_4, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, p_gravity, near_0, near_1, near_2, near_3, near_4, omega_0, omega_1, omega_2, omega_3, omega_4, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, p_wire_radius);
            near_5 = _o389.near_5;
            omega_5 = _o389.omega_5;
            around_5 = _o389.around_5;
            tilted_5 = _o389.tilted_5;
            pressed_5 = _o389.pressed_5;
            cosine_6 = _o389.cosine_6;
            sine_6 = _o389.sine_6;
            climb_6 = _o389.climb_6;
            along_6 = _o389.along_6;
            turn_rate_6 = _o389.turn_rate_6;
            cos_6 = _o389.cos_6;
            sin_6 = _o389.sin_6;
            const LANES(court_ring_round_6_out) _o390 =
                LANES(court_ring_round_6)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, around_0, around_1, around_2, around_3, around_4, around_5, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, p_wire_radius);
            near_6 = _o390.near_6;
            omega_6 = _o390.omega_6;
            around_6 = _o390.around_6;
            tilted_6 = _o390.tilted_6;
            pressed_6 = _o390.pressed_6;
            cosine_7 = _o390.cosine_7;
            sine_7 = _o390.sine_7;
            climb_7 = _o390.climb_7;
            along_7 = _o390.along_7;
            turn_rate_7 = _o390.turn_rate_7;
            cos_7 = _o390.cos_7;
            sin_7 = _o390.sin_7;
            const LANES(court_ring_round_7_out) _o391 =
                LANES(court_ring_round_7)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, p_wire_radius);
            near_7 = _o391.near_7;
            omega_7 = _o391.omega_7;
            around_7 = _o391.around_7;
            tilted_7 = _o391.tilted_7;
            pressed_7 = _o391.pressed_7;
            cosine_8 = _o391.cosine_8;
            sine_8 = _o391.sine_8;
            climb_8 = _o391.climb_8;
            along_8 = _o391.along_8;
            turn_rate_8 = _o391.turn_rate_8;
            cos_8 = _o391.cos_8;
            sin_8 = _o391.sin_8;
            const LANES(court_ring_round_8_out) _o392 =
                LANES(court_ring_round_8)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, p_wire_radius);
            near_8 = _o392.near_8;
            omega_8 = _o392.omega_8;
            around_8 = _o392.around_8;
            tilted_8 = _o392.tilted_8;
            pressed_8 = _o392.pressed_8;
            cosine_9 = _o392.cosine_9;
            sine_9 = _o392.sine_9;
            climb_9 = _o392.climb_9;
            along_9 = _o392.along_9;
            turn_rate_9 = _o392.turn_rate_9;
            cos_9 = _o392.cos_9;
            sin_9 = _o392.sin_9;
            const LANES(court_ring_round_9_out) _o393 =
                LANES(court_ring_round_9)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            near_9 = _o393.near_9;
            omega_9 = _o393.omega_9;
            around_9 = _o393.around_9;
            tilted_9 = _o393.tilted_9;
            pressed_9 = _o393.pressed_9;
            cosine_10 = _o393.cosine_10;
            sine_10 = _o393.sine_10;
            climb_10 = _o393.climb_10;
            along_10 = _o393.along_10;
            turn_rate_10 = _o393.turn_rate_10;
            cos_10 = _o393.cos_10;
            sin_10 = _o393.sin_10;
            const LANES(court_ring_round_10_out) _o394 =
                LANES(court_ring_round_10)(along_0, along_1, along_10, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            near_10 = _o394.near_10;
            omega_10 = _o394.omega_10;
            around_10 = _o394.around_10;
            tilted_10 = _o394.tilted_10;
            pressed_10 = _o394.pressed_10;
            cosine_11 = _o394.cosine_11;
            sine_11 = _o394.sine_11;
            climb_11 = _o394.climb_11;
            along_11 = _o394.along_11;
            turn_rate_11 = _o394.turn_rate_11;
            cos_11 = _o394.cos_11;
            sin_11 = _o394.sin_11;
            const LANES(court_ring_round_11_out) _o395 =
                LANES(court_ring_round_11)(along_0, along_1, along_10, along_11, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_10, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_10, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_10, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_10, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            cosine_12 = _o395.cosine_12;
            sine_12 = _o395.sine_12;
            climb_12 = _o395.climb_12;
            along_12 = _o395.along_12;
            turn_rate_12 = _o395.turn_rate_12;
            cos_12 = _o395.cos_12;
            sin_12 = _o395.sin_12;
            const LANES(court_ring_round_moved_out) _o396 =
                LANES(court_ring_round_moved)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_12, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_12, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_12, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_12, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, stride, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_12, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            far_x = _o396.x;
            far_y = _o396.y;
            far_z = _o396.z;
            far_vx = _o396.vx;
            far_vy = _o396.vy;
            far_vz = _o396.vz;
            far_wx = _o396.wx;
            far_wy = _o396.wy;
            far_wz = _o396.wz;
            const LANES(court_compared_out) _o397 =
                LANES(court_compared)(apart, p_ball_radius, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_x, far_y, far_z, vx, vy, vz, wx, wy, wz, x, y, z);
            dx = _o397.dx;
            dy = _o397.dy;
            dz = _o397.dz;
            dvx = _o397.dvx;
            dvy = _o397.dvy;
            dvz = _o397.dvz;
            dwx = _o397.dwx;
            dwy = _o397.dwy;
            dwz = _o397.dwz;
            const LANES(court_rolled_on_out) _o398 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o398.clock;
            circling = _o398.rolling;
            turns = lanes_add(turns, K(1.0));
            const M ended = lanes_both(active, lanes_not(lanes_both(circling, lanes_less(turns, K(16.0)))));
            if (lanes_any(ended)) {
                double ended_row[LANES_WIDTH];
                lanes_store(ended_row, row);
                double ended_circled[LANES_WIDTH];
                lanes_store(ended_circled, circled);
                double ended_circling[LANES_WIDTH];
                lanes_store(ended_circling, lanes_select(circling, K(1.0), K(0.0)));
                double ended_clock[LANES_WIDTH];
                lanes_store(ended_clock, clock);
                double ended_doubt[LANES_WIDTH];
                lanes_store(ended_doubt, doubt);
                double ended_dvx[LANES_WIDTH];
                lanes_store(ended_dvx, dvx);
                double ended_dvy[LANES_WIDTH];
                lanes_store(ended_dvy, dvy);
                double ended_dvz[LANES_WIDTH];
                lanes_store(ended_dvz, dvz);
                double ended_dwx[LANES_WIDTH];
                lanes_store(ended_dwx, dwx);
                double ended_dwy[LANES_WIDTH];
                lanes_store(ended_dwy, dwy);
                double ended_dwz[LANES_WIDTH];
                lanes_store(ended_dwz, dwz);
                double ended_dx[LANES_WIDTH];
                lanes_store(ended_dx, dx);
                double ended_dy[LANES_WIDTH];
                lanes_store(ended_dy, dy);
                double ended_dz[LANES_WIDTH];
                lanes_store(ended_dz, dz);
                double ended_grip_lost[LANES_WIDTH];
                lanes_store(ended_grip_lost, grip_lost);
                double ended_late[LANES_WIDTH];
                lanes_store(ended_late, late);
                double ended_per_reach[LANES_WIDTH];
                lanes_store(ended_per_reach, per_reach);
                double ended_position_error[LANES_WIDTH];
                lanes_store(ended_position_error, position_error);
                double ended_rests[LANES_WIDTH];
                lanes_store(ended_rests, lanes_select(rests, K(1.0), K(0.0)));
                double ended_taut[LANES_WIDTH];
                lanes_store(ended_taut, taut);
                double ended_taut_clock[LANES_WIDTH];
                lanes_store(ended_taut_clock, taut_clock);
                double ended_taut_rate[LANES_WIDTH];
                lanes_store(ended_taut_rate, taut_rate);
                double ended_through[LANES_WIDTH];
                lanes_store(ended_through, through);
                double ended_velocity_error[LANES_WIDTH];
                lanes_store(ended_velocity_error, velocity_error);
                double ended_vx[LANES_WIDTH];
                lanes_store(ended_vx, vx);
                double ended_vy[LANES_WIDTH];
                lanes_store(ended_vy, vy);
                double ended_vz[LANES_WIDTH];
                lanes_store(ended_vz, vz);
                double ended_which[LANES_WIDTH];
                lanes_store(ended_which, which);
                double ended_wx[LANES_WIDTH];
                lanes_store(ended_wx, wx);
                double ended_wy[LANES_WIDTH];
                lanes_store(ended_wy, wy);
                double ended_wz[LANES_WIDTH];
                lanes_store(ended_wz, wz);
                double ended_x[LANES_WIDTH];
                lanes_store(ended_x, x);
                double ended_y[LANES_WIDTH];
                lanes_store(ended_y, y);
                double ended_z[LANES_WIDTH];
                lanes_store(ended_z, z);
                for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                    const int lane = LANES_LOWEST(bits);
                    const size_t k = (size_t)ended_row[lane];
                    lists->kept_circled[k] = ended_circled[lane];
                    lists->kept_circling[k] = ended_circling[lane];
                    lists->kept_clock[k] = ended_clock[lane];
                    lists->kept_doubt[k] = ended_doubt[lane];
                    lists->kept_dvx[k] = ended_dvx[lane];
                    lists->kept_dvy[k] = ended_dvy[lane];
                    lists->kept_dvz[k] = ended_dvz[lane];
                    lists->kept_dwx[k] = ended_dwx[lane];
                    lists->kept_dwy[k] = ended_dwy[lane];
                    lists->kept_dwz[k] = ended_dwz[lane];
                    lists->kept_dx[k] = ended_dx[lane];
                    lists->kept_dy[k] = ended_dy[lane];
                    lists->kept_dz[k] = ended_dz[lane];
                    lists->kept_grip_lost[k] = ended_grip_lost[lane];
                    lists->kept_late[k] = ended_late[lane];
                    lists->kept_per_reach[k] = ended_per_reach[lane];
                    lists->kept_position_error[k] = ended_position_error[lane];
                    lists->kept_rests[k] = ended_rests[lane];
                    lists->kept_taut[k] = ended_taut[lane];
                    lists->kept_taut_clock[k] = ended_taut_clock[lane];
                    lists->kept_taut_rate[k] = ended_taut_rate[lane];
                    lists->kept_through[k] = ended_through[lane];
                    lists->kept_velocity_error[k] = ended_velocity_error[lane];
                    lists->kept_vx[k] = ended_vx[lane];
                    lists->kept_vy[k] = ended_vy[lane];
                    lists->kept_vz[k] = ended_vz[lane];
                    lists->kept_which[k] = ended_which[lane];
                    lists->kept_wx[k] = ended_wx[lane];
                    lists->kept_wy[k] = ended_wy[lane];
                    lists->kept_wz[k] = ended_wz[lane];
                    lists->kept_x[k] = ended_x[lane];
                    lists->kept_y[k] = ended_y[lane];
                    lists->kept_z[k] = ended_z[lane];
                }
                busy -= lanes_many(ended);
                active = lanes_both(active, lanes_not(ended));
            }
        }
    }
    }
    {
    size_t kept_leaves_shots = 0;
    for (size_t i = 0; i < kept_shots; i += LANES_WIDTH) {
        const M rows = lanes_first(kept_shots - i);
        M circling = lanes_less(K(0.0), lanes_load(lists->kept_circling + i));
        V clock_error = lanes_load(lists->kept_clock_error + i);
        V doubt = lanes_load(lists->kept_doubt + i);
        V dvx = lanes_load(lists->kept_dvx + i);
        V dvy = lanes_load(lists->kept_dvy + i);
        V dvz = lanes_load(lists->kept_dvz + i);
        V dwx = lanes_load(lists->kept_dwx + i);
        V dwy = lanes_load(lists->kept_dwy + i);
        V dwz = lanes_load(lists->kept_dwz + i);
        V dx = lanes_load(lists->kept_dx + i);
        V dy = lanes_load(lists->kept_dy + i);
        V dz = lanes_load(lists->kept_dz + i);
        V held = lanes_load(lists->kept_held + i);
        M leaves = lanes_less(K(0.0), lanes_load(lists->kept_leaves + i));
        V lift = lanes_load(lists->kept_lift + i);
        const V p_ball_radius = lanes_load(varying ? lists->kept_p_ball_radius + i : lists->p_ball_radius);
        const V p_board_bottom = lanes_load(varying ? lists->kept_p_board_bottom + i : lists->p_board_bottom);
        const V p_board_distance = lanes_load(varying ? lists->kept_p_board_distance + i : lists->p_board_distance);
        const V p_board_half_width = lanes_load(varying ? lists->kept_p_board_half_width + i : lists->p_board_half_width);
        const V p_board_thickness = lanes_load(varying ? lists->kept_p_board_thickness + i : lists->p_board_thickness);
        const V p_board_top = lanes_load(varying ? lists->kept_p_board_top + i : lists->p_board_top);
        const V p_bridge_depth = lanes_load(varying ? lists->kept_p_bridge_depth + i : lists->p_bridge_depth);
        const V p_bridge_half_width = lanes_load(varying ? lists->kept_p_bridge_half_width + i : lists->p_bridge_half_width);
        const V p_end_depth = lanes_load(varying ? lists->kept_p_end_depth + i : lists->p_end_depth);
        const V p_gravity = lanes_load(varying ? lists->kept_p_gravity + i : lists->p_gravity);
        const V p_ring_radius = lanes_load(varying ? lists->kept_p_ring_radius + i : lists->p_ring_radius);
        const V p_wire_radius = lanes_load(varying ? lists->kept_p_wire_radius + i : lists->p_wire_radius);
        V per_reach = lanes_load(lists->kept_per_reach + i);
        M rolling = lanes_less(K(0.0), lanes_load(lists->kept_rolling + i));
        V snap = lanes_load(lists->kept_snap + i);
        V surge = lanes_load(lists->kept_surge + i);
        V vx = lanes_load(lists->kept_vx + i);
        V vy = lanes_load(lists->kept_vy + i);
        V vz = lanes_load(lists->kept_vz + i);
        V x = lanes_load(lists->kept_x + i);
        V y = lanes_load(lists->kept_y + i);
        V z = lanes_load(lists->kept_z + i);
        const LANES(court_rejoined_out) _o399 =
            LANES(court_rejoined)(circling, rolling);
        rolling = _o399.rolling;
        lanes_store(lists->kept_rolling + i, lanes_select(rolling, K(1.0), K(0.0)));
        const M packed = lanes_both(rows, leaves);
        if (lanes_any(packed)) {
            lanes_pack(lists->kept_leaves_row + kept_leaves_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
            lanes_pack(lists->kept_leaves_clock_error + kept_leaves_shots, packed, clock_error);
            lanes_pack(lists->kept_leaves_doubt + kept_leaves_shots, packed, doubt);
            lanes_pack(lists->kept_leaves_dvx + kept_leaves_shots, packed, dvx);
            lanes_pack(lists->kept_leaves_dvy + kept_leaves_shots, packed, dvy);
            lanes_pack(lists->kept_leaves_dvz + kept_leaves_shots, packed, dvz);
            lanes_pack(lists->kept_leaves_dwx + kept_leaves_shots, packed, dwx);
            lanes_pack(lists->kept_leaves_dwy + kept_leaves_shots, packed, dwy);
            lanes_pack(lists->kept_leaves_dwz + kept_leaves_shots, packed, dwz);
            lanes_pack(lists->kept_leaves_dx + kept_leaves_shots, packed, dx);
            lanes_pack(lists->kept_leaves_dy + kept_leaves_shots, packed, dy);
            lanes_pack(lists->kept_leaves_dz + kept_leaves_shots, packed, dz);
            lanes_pack(lists->kept_leaves_held + kept_leaves_shots, packed, held);
            lanes_pack(lists->kept_leaves_lift + kept_leaves_shots, packed, lift);
            if (varying)
                lanes_pack(lists->kept_leaves_p_ball_radius + kept_leaves_shots, packed, p_ball_radius);
            if (varying)
                lanes_pack(lists->kept_leaves_p_board_bottom + kept_leaves_shots, packed, p_board_bottom);
            if (varying)
                lanes_pack(lists->kept_leaves_p_board_distance + kept_leaves_shots, packed, p_board_distance);
            if (varying)
                lanes_pack(lists->kept_leaves_p_board_half_width + kept_leaves_shots, packed, p_board_half_width);
            if (varying)
                lanes_pack(lists->kept_leaves_p_board_thickness + kept_leaves_shots, packed, p_board_thickness);
            if (varying)
                lanes_pack(lists->kept_leaves_p_board_top + kept_leaves_shots, packed, p_board_top);
            if (varying)
                lanes_pack(lists->kept_leaves_p_bridge_depth + kept_leaves_shots, packed, p_bridge_depth);
            if (varying)
                lanes_pack(lists->kept_leaves_p_bridge_half_width + kept_leaves_shots, packed, p_bridge_half_width);
            if (varying)
                lanes_pack(lists->kept_leaves_p_end_depth + kept_leaves_shots, packed, p_end_depth);
            if (varying)
                lanes_pack(lists->kept_leaves_p_gravity + kept_leaves_shots, packed, p_gravity);
            if (varying)
                lanes_pack(lists->kept_leaves_p_ring_radius + kept_leaves_shots, packed, p_ring_radius);
            if (varying)
                lanes_pack(lists->kept_leaves_p_wire_radius + kept_leaves_shots, packed, p_wire_radius);
            lanes_pack(lists->kept_leaves_per_reach + kept_leaves_shots, packed, per_reach);
            lanes_pack(lists->kept_leaves_snap + kept_leaves_shots, packed, snap);
            lanes_pack(lists->kept_leaves_surge + kept_leaves_shots, packed, surge);
            lanes_pack(lists->kept_leaves_vx + kept_leaves_shots, packed, vx);
            lanes_pack(lists->kept_leaves_vy + kept_leaves_shots, packed, vy);
            lanes_pack(lists->kept_leaves_vz + kept_leaves_shots, packed, vz);
            lanes_pack(lists->kept_leaves_x + kept_leaves_shots, packed, x);
            lanes_pack(lists->kept_leaves_y + kept_leaves_shots, packed, y);
            lanes_pack(lists->kept_leaves_z + kept_leaves_shots, packed, z);
            kept_leaves_shots += lanes_many(packed);
        }
    }
    if (kept_leaves_shots)
        LANES(court_bounded_leaves)(lists, kept_leaves_shots, varying);
    for (size_t k = 0; k < kept_leaves_shots; k++) {
        const size_t row = (size_t)lists->kept_leaves_row[k];
        lists->kept_doubt[row] = lists->kept_leaves_doubt[k];
        lists->kept_position_error[row] = lists->kept_leaves_position_error[k];
        lists->kept_velocity_error[row] = lists->kept_leaves_velocity_error[k];
        lists->kept_when[row] = lists->kept_leaves_when[k];
        lists->kept_which[row] = lists->kept_leaves_which[k];
    }
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_slow)(LANES(court_bounded_lists) *lists, size_t slow_shots, size_t varying)
{
    for (size_t i = 0; i < slow_shots; i += LANES_WIDTH) {
        const M rows = lanes_first(slow_shots - i);
        V assured = lanes_load(lists->slow_assured + i);
        V held = lanes_load(lists->slow_held + i);
        V mode = lanes_load(lists->slow_mode + i);
        V outcome = lanes_load(lists->slow_outcome + i);
        const V p_backboard_friction = lanes_load(varying ? lists->slow_p_backboard_friction + i : lists->p_backboard_friction);
        const V p_backboard_restitution = lanes_load(varying ? lists->slow_p_backboard_restitution + i : lists->p_backboard_restitution);
        const V p_ball_radius = lanes_load(varying ? lists->slow_p_ball_radius + i : lists->p_ball_radius);
        const V p_board_bottom = lanes_load(varying ? lists->slow_p_board_bottom + i : lists->p_board_bottom);
        const V p_board_distance = lanes_load(varying ? lists->slow_p_board_distance + i : lists->p_board_distance);
        const V p_board_half_width = lanes_load(varying ? lists->slow_p_board_half_width + i : lists->p_board_half_width);
        const V p_board_thickness = lanes_load(varying ? lists->slow_p_board_thickness + i : lists->p_board_thickness);
        const V p_board_top = lanes_load(varying ? lists->slow_p_board_top + i : lists->p_board_top);
        const V p_bridge_depth = lanes_load(varying ? lists->slow_p_bridge_depth + i : lists->p_bridge_depth);
        const V p_bridge_friction = lanes_load(varying ? lists->slow_p_bridge_friction + i : lists->p_bridge_friction);
        const V p_bridge_half_width = lanes_load(varying ? lists->slow_p_bridge_half_width + i : lists->p_bridge_half_width);
        const V p_bridge_restitution = lanes_load(varying ? lists->slow_p_bridge_restitution + i : lists->p_bridge_restitution);
        const V p_end_depth = lanes_load(varying ? lists->slow_p_end_depth + i : lists->p_end_depth);
        const V p_gravity = lanes_load(varying ? lists->slow_p_gravity + i : lists->p_gravity);
        const V p_ring_friction = lanes_load(varying ? lists->slow_p_ring_friction + i : lists->p_ring_friction);
        const V p_ring_radius = lanes_load(varying ? lists->slow_p_ring_radius + i : lists->p_ring_radius);
        const V p_ring_restitution = lanes_load(varying ? lists->slow_p_ring_restitution + i : lists->p_ring_restitution);
        const V p_wire_radius = lanes_load(varying ? lists->slow_p_wire_radius + i : lists->p_wire_radius);
        V slip_left = lanes_load(lists->slow_slip_left + i);
        V uncertain = lanes_load(lists->slow_uncertain + i);
        V velocity_error = lanes_load(lists->slow_velocity_error + i);
        V vx = lanes_load(lists->slow_vx + i);
        V vy = lanes_load(lists->slow_vy + i);
        V vz = lanes_load(lists->slow_vz + i);
        V which = lanes_load(lists->slow_which + i);
        V wx = lanes_load(lists->slow_wx + i);
        V wy = lanes_load(lists->slow_wy + i);
        V wz = lanes_load(lists->slow_wz + i);
        V x = lanes_load(lists->slow_x + i);
        V y = lanes_load(lists->slow_y + i);
        V z = lanes_load(lists->slow_z + i);
        const LANES(court_ring_normal_out) _o544 =
            LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
        V nx = _o544.nx;
        V ny = _o544.ny;
        V nz = _o544.nz;
        const LANES(court_here_out) _o545 =
            LANES(court_here)(K(1.0), which);
        M here = _o545.here;
        const M _m546 = lanes_both(rows, here);
        {
            const LANES(court_backboard_normal_out) _o547 =
                LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
            nx = lanes_select(_m546, _o547.nx, nx);
            ny = lanes_select(_m546, _o547.ny, ny);
            nz = lanes_select(_m546, _o547.nz, nz);
        }
        const LANES(court_here_out) _o548 =
            LANES(court_here)(K(2.0), which);
        here = _o548.here;
        const M _m549 = lanes_both(rows, here);
        {
            const LANES(court_bridge_normal_out) _o550 =
                LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
            nx = lanes_select(_m549, _o550.nx, nx);
            ny = lanes_select(_m549, _o550.ny, ny);
            nz = lanes_select(_m549, _o550.nz, nz);
        }
        const LANES(court_nearly_out) _o551 =
            LANES(court_nearly)(p_ball_radius, p_gravity, nx, ny, nz, vx, vy, vz);
        M nearly = _o551.nearly;
        const LANES(court_gripped_out) _o552 =
            LANES(court_gripped)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
        V rolled_x = _o552.rolled_x;
        V rolled_y = _o552.rolled_y;
        V rolled_z = _o552.rolled_z;
        V slip = _o552.slip;
        V bounce = _o552.bounce;
        const LANES(court_here_out) _o553 =
            LANES(court_here)(K(0.0), which);
        here = _o553.here;
        const M _m554 = lanes_both(rows, here);
        if (lanes_any(_m554)) {
            const LANES(court_ring_turning_out) _o555 =
                LANES(court_ring_turning)(p_ball_radius, p_ring_radius, rolled_x, rolled_y, rolled_z, p_wire_radius, x, y);
            V turning_x = _o555.turning_x;
            V turning_y = _o555.turning_y;
            V turning_z = _o555.turning_z;
            const LANES(court_pressed_on_out) _o556 =
                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
            V press = _o556.press;
            V weight = _o556.weight;
            V drag = _o556.drag;
            V thrust_x = _o556.thrust_x;
            V thrust_y = _o556.thrust_y;
            V thrust_z = _o556.thrust_z;
            const LANES(court_alone_out) _o557 =
                LANES(court_alone)();
            V nearest = _o557.nearest;
            V wedge = _o557.wedge;
            const LANES(court_backboard_closing_out) _o558 =
                LANES(court_backboard_closing)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z);
            V gap = _o558.gap;
            V nearing = _o558.nearing;
            V swerve = _o558.swerve;
            V facing = _o558.facing;
            const LANES(court_neared_body_out) _o559 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o559.nearest;
            wedge = _o559.wedge;
            const LANES(court_bridge_closing_out) _o560 =
                LANES(court_bridge_closing)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
            gap = _o560.gap;
            nearing = _o560.nearing;
            swerve = _o560.swerve;
            facing = _o560.facing;
            const LANES(court_neared_body_out) _o561 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o561.nearest;
            wedge = _o561.wedge;
            const LANES(court_end_beside_out) _o562 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o562.gap;
            const LANES(court_neared_out) _o563 =
                LANES(court_neared)(gap, nearest);
            nearest = _o563.nearest;
            const LANES(court_ring_parting_out) _o564 =
                LANES(court_ring_parting)(p_gravity, p_ring_radius, vx, vy, vz, x, y, z);
            V lift = _o564.lift;
            const LANES(court_ring_impact_settling_out) _o565 =
                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_ring_friction, p_ring_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz);
            M settles = _o565.settles;
            M lodges = _o565.lodges;
            M slides = _o565.slides;
            M parts = _o565.parts;
            assured = lanes_select(_m554, _o565.assured, assured);
            M unsure = _o565.unsure;
            const LANES(court_settled_out) _o566 =
                LANES(court_settled)(K(0.0), lodges, nearly, outcome, parts, settles, slides, uncertain, unsure);
            mode = lanes_select(_m554, _o566.mode, mode);
            held = lanes_select(_m554, _o566.held, held);
            outcome = lanes_select(_m554, _o566.outcome, outcome);
            slip_left = lanes_select(_m554, _o566.slip_left, slip_left);
            uncertain = lanes_select(_m554, _o566.uncertain, uncertain);
        }
        const LANES(court_here_out) _o567 =
            LANES(court_here)(K(1.0), which);
        here = _o567.here;
        const M _m568 = lanes_both(rows, here);
        if (lanes_any(_m568)) {
            const LANES(court_backboard_turning_out) _o569 =
                LANES(court_backboard_turning)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, rolled_x, rolled_y, rolled_z, x, y, z);
            V turning_x = _o569.turning_x;
            V turning_y = _o569.turning_y;
            V turning_z = _o569.turning_z;
            const LANES(court_pressed_on_out) _o570 =
                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
            V press = _o570.press;
            V weight = _o570.weight;
            V drag = _o570.drag;
            V thrust_x = _o570.thrust_x;
            V thrust_y = _o570.thrust_y;
            V thrust_z = _o570.thrust_z;
            const LANES(court_alone_out) _o571 =
                LANES(court_alone)();
            V nearest = _o571.nearest;
            V wedge = _o571.wedge;
            const LANES(court_ring_closing_out) _o572 =
                LANES(court_ring_closing)(p_ball_radius, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
            V gap = _o572.gap;
            V nearing = _o572.nearing;
            V swerve = _o572.swerve;
            V facing = _o572.facing;
            const LANES(court_neared_body_out) _o573 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o573.nearest;
            wedge = _o573.wedge;
            const LANES(court_bridge_closing_out) _o574 =
                LANES(court_bridge_closing)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
            gap = _o574.gap;
            nearing = _o574.nearing;
            swerve = _o574.swerve;
            facing = _o574.facing;
            const LANES(court_neared_body_out) _o575 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o575.nearest;
            wedge = _o575.wedge;
            const LANES(court_end_beside_out) _o576 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o576.gap;
            const LANES(court_neared_out) _o577 =
                LANES(court_neared)(gap, nearest);
            nearest = _o577.nearest;
            const LANES(court_backboard_parting_out) _o578 =
                LANES(court_backboard_parting)(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, vx, vy, vz, x, y, z);
            V lift = _o578.lift;
            const LANES(court_ring_impact_settling_out) _o579 =
                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_backboard_friction, p_backboard_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz);
            M settles = _o579.settles;
            M lodges = _o579.lodges;
            M slides = _o579.slides;
            M parts = _o579.parts;
            assured = lanes_select(_m568, _o579.assured, assured);
            M unsure = _o579.unsure;
            const LANES(court_settled_out) _o580 =
                LANES(court_settled)(K(1.0), lodges, nearly, outcome, parts, settles, slides, uncertain, unsure);
            mode = lanes_select(_m568, _o580.mode, mode);
            held = lanes_select(_m568, _o580.held, held);
            outcome = lanes_select(_m568, _o580.outcome, outcome);
            slip_left = lanes_select(_m568, _o580.slip_left, slip_left);
            uncertain = lanes_select(_m568, _o580.uncertain, uncertain);
        }
        const LANES(court_here_out) _o581 =
            LANES(court_here)(K(2.0), which);
        here = _o581.here;
        const M _m582 = lanes_both(rows, here);
        if (lanes_any(_m582)) {
            const LANES(court_bridge_turning_out) _o583 =
                LANES(court_bridge_turning)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, rolled_x, rolled_y, rolled_z, p_wire_radius, x, y, z);
            V turning_x = _o583.turning_x;
            V turning_y = _o583.turning_y;
            V turning_z = _o583.turning_z;
            const LANES(court_pressed_on_out) _o584 =
                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
            V press = _o584.press;
            V weight = _o584.weight;
            V drag = _o584.drag;
            V thrust_x = _o584.thrust_x;
            V thrust_y = _o584.thrust_y;
            V thrust_z = _o584.thrust_z;
            const LANES(court_alone_out) _o585 =
                LANES(court_alone)();
            V nearest = _o585.nearest;
            V wedge = _o585.wedge;
            const LANES(court_ring_closing_out) _o586 =
                LANES(court_ring_closing)(p_ball_radius, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
            V gap = _o586.gap;
            V nearing = _o586.nearing;
            V swerve = _o586.swerve;
            V facing = _o586.facing;
            const LANES(court_neared_body_out) _o587 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o587.nearest;
            wedge = _o587.wedge;
            const LANES(court_backboard_closing_out) _o588 =
                LANES(court_backboard_closing)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z);
            gap = _o588.gap;
            nearing = _o588.nearing;
            swerve = _o588.swerve;
            facing = _o588.facing;
            const LANES(court_neared_body_out) _o589 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o589.nearest;
            wedge = _o589.wedge;
            const LANES(court_end_beside_out) _o590 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o590.gap;
            const LANES(court_neared_out) _o591 =
                LANES(court_neared)(gap, nearest);
            nearest = _o591.nearest;
            const LANES(court_bridge_parting_out) _o592 =
                LANES(court_bridge_parting)(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            V lift = _o592.lift;
            const LANES(court_ring_impact_settling_out) _o593 =
                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_bridge_friction, p_bridge_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz);
            M settles = _o593.settles;
            M lodges = _o593.lodges;
            M slides = _o593.slides;
            M parts = _o593.parts;
            assured = lanes_select(_m582, _o593.assured, assured);
            M unsure = _o593.unsure;
            const LANES(court_settled_out) _o594 =
                LANES(court_settled)(K(2.0), lodges, nearly, outcome, parts, settles, slides, uncertain, unsure);
            mode = lanes_select(_m582, _o594.mode, mode);
            held = lanes_select(_m582, _o594.held, held);
            outcome = lanes_select(_m582, _o594.outcome, outcome);
            slip_left = lanes_select(_m582, _o594.slip_left, slip_left);
            uncertain = lanes_select(_m582, _o594.uncertain, uncertain);
        }
        lanes_store(lists->slow_assured + i, assured);
        lanes_store(lists->slow_held + i, held);
        lanes_store(lists->slow_mode + i, mode);
        lanes_store(lists->slow_outcome + i, outcome);
        lanes_store(lists->slow_slip_left + i, slip_left);
        lanes_store(lists->slow_uncertain + i, uncertain);
    }
}

/* Run the job: fill the rows, take every shot to its next event, make room of those that ended.
   Errors are bounded. */
static void LANES(court_bounded)(const court_job *job)
{
    LANES(court_bounded_lists) all, *const lists = &all;
    const V most_contacts = K((double)job->max_contacts);
    const V time_limit = K(job->time_limit);
    const V claims = K(job->results->time_error || job->results->state_error ? 1.0 : 0.0);
    const size_t varying = job->varying ? ~(size_t)0 : 0;
    const int recording = job->results->events != NULL;
    size_t begun = 0, end = 0, shots = 0;
    int streams = 0; /* whether the shots before ended all at once: then those to come will, too */

    lists->waiting = 0;
    if (job->shots == 0)
        return;
    lanes_store(lists->p_ball_radius, K(*job->parameters[0]));
    lanes_store(lists->p_ring_radius, K(*job->parameters[1]));
    lanes_store(lists->p_wire_radius, K(*job->parameters[2]));
    lanes_store(lists->p_board_distance, K(*job->parameters[3]));
    lanes_store(lists->p_board_half_width, K(*job->parameters[4]));
    lanes_store(lists->p_board_bottom, K(*job->parameters[5]));
    lanes_store(lists->p_board_top, K(*job->parameters[6]));
    lanes_store(lists->p_board_thickness, K(*job->parameters[7]));
    lanes_store(lists->p_bridge_half_width, K(*job->parameters[8]));
    lanes_store(lists->p_bridge_depth, K(*job->parameters[9]));
    lanes_store(lists->p_gravity, K(*job->parameters[10]));
    lanes_store(lists->p_end_depth, K(*job->parameters[11]));
    lanes_store(lists->p_ring_restitution, K(*job->parameters[12]));
    lanes_store(lists->p_backboard_restitution, K(*job->parameters[13]));
    lanes_store(lists->p_bridge_restitution, K(*job->parameters[14]));
    lanes_store(lists->p_ring_friction, K(*job->parameters[15]));
    lanes_store(lists->p_backboard_friction, K(*job->parameters[16]));
    lanes_store(lists->p_bridge_friction, K(*job->parameters[17]));
    lanes_store(lists->p_tangential_restitution, K(*job->parameters[18]));
    lanes_store(lists->p_restitution_speed, K(*job->parameters[19]));
    const M all_permitted = LANES(court_permit)(lanes_load(lists->p_ball_radius), lanes_load(lists->p_ring_radius), lanes_load(lists->p_wire_radius), lanes_load(lists->p_board_distance), lanes_load(lists->p_board_half_width), lanes_load(lists->p_board_bottom), lanes_load(lists->p_board_top), lanes_load(lists->p_board_thickness), lanes_load(lists->p_bridge_half_width), lanes_load(lists->p_bridge_depth), lanes_load(lists->p_gravity), lanes_load(lists->p_end_depth), lanes_load(lists->p_ring_restitution), lanes_load(lists->p_backboard_restitution), lanes_load(lists->p_bridge_restitution), lanes_load(lists->p_ring_friction), lanes_load(lists->p_backboard_friction), lanes_load(lists->p_bridge_friction), lanes_load(lists->p_tangential_restitution), lanes_load(lists->p_restitution_speed));
    for (;;) {
        if (job->stop && *job->stop)
            return;
        if (begun == end && end < job->shots)
            begun = court_take(job, &end);
        int following = shots == 0;
        if (lists->waiting + LANES_WIDTH > LANES_SHOTS || (shots == 0 && begun == end)) {
            shots += LANES(court_bounded_resume)(lists, shots, job);
            following = 0;
        }
        const size_t fresh = shots;
        if (begun < end && shots < LANES_SHOTS) {
            const size_t room = LANES_SHOTS - shots, left = end - begun;
            shots += left < room ? left : room;
            LANES(court_bounded_begin)(lists, fresh, shots - fresh, job, begun);
            begun += shots - fresh;
        }
        if (shots == 0)
            return;

        /* A new shot is looked at once. */
        for (size_t i = fresh; i < shots; i += LANES_WIDTH) {
            V last = lanes_load(lists->last + i);
            const V p_backboard_friction = lanes_load(lists->p_backboard_friction + (i & varying));
            const V p_backboard_restitution = lanes_load(lists->p_backboard_restitution + (i & varying));
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_bottom = lanes_load(lists->p_board_bottom + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_board_half_width = lanes_load(lists->p_board_half_width + (i & varying));
            const V p_board_thickness = lanes_load(lists->p_board_thickness + (i & varying));
            const V p_board_top = lanes_load(lists->p_board_top + (i & varying));
            const V p_bridge_depth = lanes_load(lists->p_bridge_depth + (i & varying));
            const V p_bridge_friction = lanes_load(lists->p_bridge_friction + (i & varying));
            const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + (i & varying));
            const V p_bridge_restitution = lanes_load(lists->p_bridge_restitution + (i & varying));
            const V p_end_depth = lanes_load(lists->p_end_depth + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_restitution_speed = lanes_load(lists->p_restitution_speed + (i & varying));
            const V p_ring_friction = lanes_load(lists->p_ring_friction + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
            const V p_ring_restitution = lanes_load(lists->p_ring_restitution + (i & varying));
            const V p_tangential_restitution = lanes_load(lists->p_tangential_restitution + (i & varying));
            const V p_wire_radius = lanes_load(lists->p_wire_radius + (i & varying));
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V wx = lanes_load(lists->wx + i);
            V wy = lanes_load(lists->wy + i);
            V wz = lanes_load(lists->wz + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            M permitted = all_permitted;
            if (varying)
                permitted = LANES(court_permit)(p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_gravity, p_end_depth, p_ring_restitution, p_backboard_restitution, p_bridge_restitution, p_ring_friction, p_backboard_friction, p_bridge_friction, p_tangential_restitution, p_restitution_speed);
            const LANES(court_finite_state_out) _o1 =
                LANES(court_finite_state)(vx, vy, vz, wx, wy, wz, x, y, z);
            M finite = _o1.finite;
            const LANES(court_valid_out) _o2 =
                LANES(court_valid)(last, x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_end_depth);
            V valid = _o2.valid;
            V doubt = _o2.doubt;
            const LANES(court_admitted_out) _o3 =
                LANES(court_admitted)(doubt, finite, permitted, valid);
            V outcome = _o3.outcome;
            V uncertain = _o3.uncertain;
            const LANES(court_passing_start_out) _o4 =
                LANES(court_passing_start)(last, outcome, uncertain, x, y, z, p_ring_radius, p_end_depth);
            V through = _o4.through;
            uncertain = _o4.uncertain;
            lanes_store(lists->outcome + i, outcome);
            lanes_store(lists->through + i, through);
            lanes_store(lists->uncertain + i, uncertain);
        }

        M refused = lanes_nowhere();
        for (size_t i = fresh; i < shots; i += LANES_WIDTH)
            refused = lanes_either(refused, lanes_both(lanes_first(shots - i), lanes_at_most(K(0.0), lanes_load(lists->outcome + i))));
        if (lanes_any(refused)) {
            shots = LANES(court_bounded_leave)(lists, fresh, shots, job);
            following = 0;
        }

        /* To the next event, and what it does to the ball. */
        {
        size_t open_shots = 0;
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            LANES(court_ahead)(job, begun + i, streams);
            V clock_error = lanes_load(lists->clock_error + i);
            V dvx = lanes_load(lists->dvx + i);
            V dvy = lanes_load(lists->dvy + i);
            V dvz = lanes_load(lists->dvz + i);
            V dwx = lanes_load(lists->dwx + i);
            V dwy = lanes_load(lists->dwy + i);
            V dwz = lanes_load(lists->dwz + i);
            V dx = lanes_load(lists->dx + i);
            V dy = lanes_load(lists->dy + i);
            V dz = lanes_load(lists->dz + i);
            V last = lanes_load(lists->last + i);
            V mode = lanes_load(lists->mode + i);
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_end_depth = lanes_load(lists->p_end_depth + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
            const V p_wire_radius = lanes_load(lists->p_wire_radius + (i & varying));
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const LANES(court_error_bounds_out) _o5 =
                LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            V position_error = _o5.position_error;
            V velocity_error = _o5.velocity_error;
            V time_error = _o5.time_error;
            const LANES(court_scale_out) _o6 =
                LANES(court_scale)(x, y, z, vx, vy, vz, p_gravity);
            V extent = _o6.extent;
            V speed = _o6.speed;
            V excess = _o6.excess;
            const LANES(court_opening_out) _o7 =
                LANES(court_opening)(excess, position_error, velocity_error);
            V when = _o7.when;
            V which = _o7.which;
            V late = _o7.late;
            V doubt = _o7.doubt;
            const LANES(court_limited_out) _o8 =
                LANES(court_limited)(time_limit);
            M limited = _o8.limited;
            const LANES(court_kept_out) _o9 =
                LANES(court_kept)(mode, when);
            M kept = _o9.kept;
            when = _o9.when;
            M rests = _o9.rests;
            M rolling = _o9.rolling;
            V began = _o9.began;
            const LANES(court_left_out) _o10 =
                LANES(court_left)(K(3.0), last);
            V leaving = _o10.leaving;
            const LANES(court_end_arrival_out) _o11 =
                LANES(court_end_arrival)(leaving, z, vz, p_gravity, p_end_depth);
            V time = _o11.time;
            V rate = _o11.rate;
            V bend = _o11.bend;
            V apex = _o11.apex;
            V height = _o11.height;
            const LANES(court_meeting_plane_out) _o12 =
                LANES(court_meeting_plane)(apex, bend, rate, time);
            M arrives = _o12.arrives;
            V ceiling = _o12.ceiling;
            V nearest = _o12.nearest;
            const LANES(court_end_margin_out) _o13 =
                LANES(court_end_margin)(nearest, extent, speed, position_error, velocity_error, p_gravity, p_end_depth);
            V margin = _o13.margin;
            const LANES(court_crossing_out) _o14 =
                LANES(court_crossing)(margin, K(0.0), rate, ceiling);
            V clearance = _o14.clearance;
            V delay = _o14.delay;
            const LANES(court_timely_out) _o15 =
                LANES(court_timely)(arrives, delay, late, time, when);
            M possible = _o15.possible;
            const LANES(court_grazed_out) _o16 =
                LANES(court_grazed)(apex, doubt, height, margin);
            doubt = _o16.doubt;
            const M _m17 = lanes_both(rows, possible);
            {
                const LANES(court_crossed_out) _o18 =
                    LANES(court_crossed)(arrives, clearance, doubt, time);
                doubt = lanes_select(_m17, _o18.doubt, doubt);
                const LANES(court_tied_out) _o19 =
                    LANES(court_tied)(arrives, delay, doubt, late, time, when);
                doubt = lanes_select(_m17, _o19.doubt, doubt);
                late = lanes_select(_m17, _o19.late, late);
                const LANES(court_sooner_out) _o20 =
                    LANES(court_sooner)(arrives, K(3.0), time, when, which);
                when = lanes_select(_m17, _o20.when, when);
                which = lanes_select(_m17, _o20.which, which);
            }
            const LANES(court_horizon_out) _o21 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o21.horizon;
            V pad = _o21.pad;
            const LANES(court_ring_clear_out) _o22 =
                LANES(court_ring_clear)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V clear = _o22.clear;
            const LANES(court_opens_in_flight_out) _o23 =
                LANES(court_opens_in_flight)(clear, kept);
            M open = _o23.open;
            lanes_store(lists->began + i, began);
            lanes_store(lists->doubt + i, doubt);
            lanes_store(lists->extent + i, extent);
            lanes_store(lists->kept + i, lanes_select(kept, K(1.0), K(0.0)));
            lanes_store(lists->late + i, late);
            lanes_store(lists->limited + i, lanes_select(limited, K(1.0), K(0.0)));
            lanes_store(lists->position_error + i, position_error);
            lanes_store(lists->rests + i, lanes_select(rests, K(1.0), K(0.0)));
            lanes_store(lists->rolling + i, lanes_select(rolling, K(1.0), K(0.0)));
            lanes_store(lists->speed + i, speed);
            lanes_store(lists->time_error + i, time_error);
            lanes_store(lists->velocity_error + i, velocity_error);
            lanes_store(lists->when + i, when);
            lanes_store(lists->which + i, which);
            const M packed = lanes_both(rows, open);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_row + open_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_doubt + open_shots, packed, doubt);
                lanes_pack(lists->open_extent + open_shots, packed, extent);
                lanes_pack(lists->open_last + open_shots, packed, last);
                lanes_pack(lists->open_late + open_shots, packed, late);
                if (varying)
                    lanes_pack(lists->open_p_ball_radius + open_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_p_gravity + open_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->open_p_ring_radius + open_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->open_p_wire_radius + open_shots, packed, p_wire_radius);
                lanes_pack(lists->open_pad + open_shots, packed, pad);
                lanes_pack(lists->open_position_error + open_shots, packed, position_error);
                lanes_pack(lists->open_speed + open_shots, packed, speed);
                lanes_pack(lists->open_until + open_shots, packed, until);
                lanes_pack(lists->open_velocity_error + open_shots, packed, velocity_error);
                lanes_pack(lists->open_vx + open_shots, packed, vx);
                lanes_pack(lists->open_vy + open_shots, packed, vy);
                lanes_pack(lists->open_vz + open_shots, packed, vz);
                lanes_pack(lists->open_when + open_shots, packed, when);
                lanes_pack(lists->open_which + open_shots, packed, which);
                lanes_pack(lists->open_x + open_shots, packed, x);
                lanes_pack(lists->open_y + open_shots, packed, y);
                lanes_pack(lists->open_z + open_shots, packed, z);
                open_shots += lanes_many(packed);
            }
        }
        {
        size_t open_leaping_shots = 0;
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_shots - i);
            V doubt = lanes_load(lists->open_doubt + i);
            V extent = lanes_load(lists->open_extent + i);
            V last = lanes_load(lists->open_last + i);
            V late = lanes_load(lists->open_late + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius);
            const V p_gravity = lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->open_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->open_p_wire_radius + i : lists->p_wire_radius);
            V pad = lanes_load(lists->open_pad + i);
            V position_error = lanes_load(lists->open_position_error + i);
            V speed = lanes_load(lists->open_speed + i);
            V until = lanes_load(lists->open_until + i);
            V velocity_error = lanes_load(lists->open_velocity_error + i);
            V vx = lanes_load(lists->open_vx + i);
            V vy = lanes_load(lists->open_vy + i);
            V vz = lanes_load(lists->open_vz + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(court_beginning_out) _o24 =
                LANES(court_beginning)();
            V share = _o24.share;
            V arrival = _o24.arrival;
            M certain = _o24.certain;
            const LANES(court_left_out) _o25 =
                LANES(court_left)(K(0.0), last);
            V leaving = _o25.leaving;
            const LANES(court_ring_opened_out) _o26 =
                LANES(court_ring_opened)(lanes_narrow(until), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
            S onset = _o26.t;
            S wide_end = _o26.end;
            M searching = _o26.searching;
            S wide_low1 = _o26.low1;
            S wide_high1 = _o26.high1;
            S wide_low2 = _o26.low2;
            S wide_high2 = _o26.high2;
            S lapsed = _o26.latest;
            M sound = _o26.sound;
            const LANES(court_opened_out) _o27 =
                LANES(court_opened)(lanes_wide(lapsed), lanes_wide(onset));
            V since = _o27.time;
            V latest = _o27.latest;
            const LANES(court_ring_started_out) _o28 =
                LANES(court_ring_started)(x, y, z, vx, vy, vz, p_ring_radius);
            V rho_start = _o28.rho_start;
            V parting = _o28.parting;
            V drift = _o28.drift;
            const LANES(court_flight_out) _o29 =
                LANES(court_flight)(since, x, y, z, vx, vy, vz, p_gravity);
            V near_x = _o29.x;
            V near_y = _o29.y;
            V near_z = _o29.z;
            V near_vz = _o29.vz;
            const LANES(court_ring_grain_out) _o30 =
                LANES(court_ring_grain)(onset, wide_end, lanes_narrow(leaving), lapsed, lanes_narrow(near_x), lanes_narrow(near_y), lanes_narrow(near_z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(near_vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(parting), lanes_narrow(drift), wide_low1, wide_high1, wide_low2, wide_high2, lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
            S short_share = _o30.share;
            S short_t = _o30.t;
            S short_end = _o30.end;
            S short_x = _o30.x;
            S short_y = _o30.y;
            S short_z = _o30.z;
            S short_vx = _o30.vx;
            S short_vy = _o30.vy;
            S short_vz = _o30.vz;
            S short_steady = _o30.steady;
            S short_swing = _o30.swing;
            S short_rho_start = _o30.rho_start;
            S short_ceiling = _o30.ceiling;
            S short_flat = _o30.flat;
            S short_tilt = _o30.tilt;
            S short_jerk = _o30.jerk;
            S short_grit = _o30.grit;
            S short_parting = _o30.parting;
            S short_drift = _o30.drift;
            S short_rate_margin = _o30.rate_margin;
            S short_low1 = _o30.low1;
            S short_high1 = _o30.high1;
            S short_low2 = _o30.low2;
            S short_high2 = _o30.high2;
            M fits = _o30.fits;
            const LANES(court_coarse_out) _o31 =
                LANES(court_coarse)(lanes_wide(short_ceiling), fits, lanes_wide(short_flat), lanes_wide(short_rate_margin), searching, lanes_wide(short_share), sound);
            M leaping = _o31.leaping;
            searching = _o31.searching;
            M served = _o31.served;
            V ceiling = _o31.ceiling;
            V flat = _o31.flat;
            V tilt = _o31.tilt;
            V allowing = _o31.allowing;
            const LANES(court_allowance_out) _o32 =
                LANES(court_allowance)(allowing, latest, extent, speed, position_error, velocity_error, p_gravity);
            V excess = _o32.excess;
            const LANES(court_ring_lost_out) _o33 =
                LANES(court_ring_lost)(until, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V lost = _o33.lost;
            const LANES(court_beyond_out) _o34 =
                LANES(court_beyond)(doubt, excess, late, lost, pad);
            doubt = _o34.doubt;
            const M _m35 = lanes_both(rows, leaping);
            if (lanes_any(_m35)) {
                const LANES(court_ring_leap_out) _o36 =
                    LANES(court_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
                short_t = singles_select(singles_of(_m35), _o36.t, short_t);
                short_end = singles_select(singles_of(_m35), _o36.end, short_end);
                certain = lanes_choose(_m35, _o36.certain, certain);
                leaping = lanes_choose(_m35, _o36.leaping, leaping);
            }
            lanes_store(lists->open_arrival + i, arrival);
            lanes_store(lists->open_ceiling + i, ceiling);
            lanes_store(lists->open_certain + i, lanes_select(certain, K(1.0), K(0.0)));
            lanes_store(lists->open_doubt + i, doubt);
            lanes_store(lists->open_flat + i, flat);
            lanes_store(lists->open_latest + i, latest);
            lanes_store(lists->open_rho_start + i, rho_start);
            lanes_store(lists->open_searching + i, lanes_select(searching, K(1.0), K(0.0)));
            lanes_store(lists->open_served + i, lanes_select(served, K(1.0), K(0.0)));
            lanes_store(lists->open_share + i, share);
            singles_store(lists->open_short_t + i, short_t);
            lanes_store(lists->open_since + i, since);
            lanes_store(lists->open_tilt + i, tilt);
            const M packed = lanes_both(rows, leaping);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_leaping_row + open_leaping_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                if (varying)
                    lanes_pack(lists->open_leaping_p_ball_radius + open_leaping_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_leaping_p_gravity + open_leaping_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->open_leaping_p_ring_radius + open_leaping_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->open_leaping_p_wire_radius + open_leaping_shots, packed, p_wire_radius);
                singles_pack(lists->open_leaping_short_ceiling + open_leaping_shots, packed, short_ceiling);
                singles_pack(lists->open_leaping_short_drift + open_leaping_shots, packed, short_drift);
                singles_pack(lists->open_leaping_short_end + open_leaping_shots, packed, short_end);
                singles_pack(lists->open_leaping_short_flat + open_leaping_shots, packed, short_flat);
                singles_pack(lists->open_leaping_short_grit + open_leaping_shots, packed, short_grit);
                singles_pack(lists->open_leaping_short_high1 + open_leaping_shots, packed, short_high1);
                singles_pack(lists->open_leaping_short_high2 + open_leaping_shots, packed, short_high2);
                singles_pack(lists->open_leaping_short_jerk + open_leaping_shots, packed, short_jerk);
                singles_pack(lists->open_leaping_short_low1 + open_leaping_shots, packed, short_low1);
                singles_pack(lists->open_leaping_short_low2 + open_leaping_shots, packed, short_low2);
                singles_pack(lists->open_leaping_short_parting + open_leaping_shots, packed, short_parting);
                singles_pack(lists->open_leaping_short_rate_margin + open_leaping_shots, packed, short_rate_margin);
                singles_pack(lists->open_leaping_short_rho_start + open_leaping_shots, packed, short_rho_start);
                singles_pack(lists->open_leaping_short_steady + open_leaping_shots, packed, short_steady);
                singles_pack(lists->open_leaping_short_swing + open_leaping_shots, packed, short_swing);
                singles_pack(lists->open_leaping_short_t + open_leaping_shots, packed, short_t);
                singles_pack(lists->open_leaping_short_tilt + open_leaping_shots, packed, short_tilt);
                singles_pack(lists->open_leaping_short_vx + open_leaping_shots, packed, short_vx);
                singles_pack(lists->open_leaping_short_vy + open_leaping_shots, packed, short_vy);
                singles_pack(lists->open_leaping_short_vz + open_leaping_shots, packed, short_vz);
                singles_pack(lists->open_leaping_short_x + open_leaping_shots, packed, short_x);
                singles_pack(lists->open_leaping_short_y + open_leaping_shots, packed, short_y);
                singles_pack(lists->open_leaping_short_z + open_leaping_shots, packed, short_z);
                open_leaping_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
            V p_ball_radius = lanes_load(lists->p_ball_radius);
            V p_gravity = lanes_load(lists->p_gravity);
            V p_ring_radius = lanes_load(lists->p_ring_radius);
            V p_wire_radius = lanes_load(lists->p_wire_radius);
            S short_ceiling = KS(0.0);
            S short_drift = KS(0.0);
            S short_end = KS(0.0);
            S short_flat = KS(0.0);
            S short_grit = KS(0.0);
            S short_high1 = KS(0.0);
            S short_high2 = KS(0.0);
            S short_jerk = KS(0.0);
            S short_low1 = KS(0.0);
            S short_low2 = KS(0.0);
            S short_parting = KS(0.0);
            S short_rate_margin = KS(0.0);
            S short_rho_start = KS(0.0);
            S short_steady = KS(0.0);
            S short_swing = KS(0.0);
            S short_t = KS(0.0);
            S short_tilt = KS(0.0);
            S short_vx = KS(0.0);
            S short_vy = KS(0.0);
            S short_vz = KS(0.0);
            S short_x = KS(0.0);
            S short_y = KS(0.0);
            S short_z = KS(0.0);
            for (;;) {
                if (taken < open_leaping_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->open_leaping_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    short_ceiling = singles_expand(lists->open_leaping_short_ceiling + taken, idle, short_ceiling);
                    short_drift = singles_expand(lists->open_leaping_short_drift + taken, idle, short_drift);
                    short_end = singles_expand(lists->open_leaping_short_end + taken, idle, short_end);
                    short_flat = singles_expand(lists->open_leaping_short_flat + taken, idle, short_flat);
                    short_grit = singles_expand(lists->open_leaping_short_grit + taken, idle, short_grit);
                    short_high1 = singles_expand(lists->open_leaping_short_high1 + taken, idle, short_high1);
                    short_high2 = singles_expand(lists->open_leaping_short_high2 + taken, idle, short_high2);
                    short_jerk = singles_expand(lists->open_leaping_short_jerk + taken, idle, short_jerk);
                    short_low1 = singles_expand(lists->open_leaping_short_low1 + taken, idle, short_low1);
                    short_low2 = singles_expand(lists->open_leaping_short_low2 + taken, idle, short_low2);
                    short_parting = singles_expand(lists->open_leaping_short_parting + taken, idle, short_parting);
                    short_rate_margin = singles_expand(lists->open_leaping_short_rate_margin + taken, idle, short_rate_margin);
                    short_rho_start = singles_expand(lists->open_leaping_short_rho_start + taken, idle, short_rho_start);
                    short_steady = singles_expand(lists->open_leaping_short_steady + taken, idle, short_steady);
                    short_swing = singles_expand(lists->open_leaping_short_swing + taken, idle, short_swing);
                    short_t = singles_expand(lists->open_leaping_short_t + taken, idle, short_t);
                    short_tilt = singles_expand(lists->open_leaping_short_tilt + taken, idle, short_tilt);
                    short_vx = singles_expand(lists->open_leaping_short_vx + taken, idle, short_vx);
                    short_vy = singles_expand(lists->open_leaping_short_vy + taken, idle, short_vy);
                    short_vz = singles_expand(lists->open_leaping_short_vz + taken, idle, short_vz);
                    short_x = singles_expand(lists->open_leaping_short_x + taken, idle, short_x);
                    short_y = singles_expand(lists->open_leaping_short_y + taken, idle, short_y);
                    short_z = singles_expand(lists->open_leaping_short_z + taken, idle, short_z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->open_leaping_p_ball_radius + taken, idle, p_ball_radius);
                        p_gravity = lanes_expand(lists->open_leaping_p_gravity + taken, idle, p_gravity);
                        p_ring_radius = lanes_expand(lists->open_leaping_p_ring_radius + taken, idle, p_ring_radius);
                        p_wire_radius = lanes_expand(lists->open_leaping_p_wire_radius + taken, idle, p_wire_radius);
                    }
                    const size_t room = LANES_WIDTH - busy, left = open_leaping_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M leaping = active;
                const LANES(court_ring_leap_out) _o37 =
                    LANES(court_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
                short_t = _o37.t;
                short_end = _o37.end;
                M certain = _o37.certain;
                leaping = _o37.leaping;
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(leaping, lanes_less(turns, K(24.0)))));
                if (lanes_any(ended)) {
                    double ended_row[LANES_WIDTH];
                    lanes_store(ended_row, row);
                    double ended_certain[LANES_WIDTH];
                    lanes_store(ended_certain, lanes_select(certain, K(1.0), K(0.0)));
                    float ended_short_t[LANES_WIDTH];
                    singles_store(ended_short_t, short_t);
                    for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                        const int lane = LANES_LOWEST(bits);
                        const size_t k = (size_t)ended_row[lane];
                        lists->open_certain[k] = ended_certain[lane];
                        lists->open_short_t[k] = ended_short_t[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        {
        size_t open_searching_shots = 0;
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_shots - i);
            V arrival = lanes_load(lists->open_arrival + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_certain + i));
            V doubt = lanes_load(lists->open_doubt + i);
            V extent = lanes_load(lists->open_extent + i);
            V last = lanes_load(lists->open_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius);
            const V p_gravity = lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->open_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->open_p_wire_radius + i : lists->p_wire_radius);
            V position_error = lanes_load(lists->open_position_error + i);
            M searching = lanes_less(K(0.0), lanes_load(lists->open_searching + i));
            M served = lanes_less(K(0.0), lanes_load(lists->open_served + i));
            V share = lanes_load(lists->open_share + i);
            S short_t = singles_load(lists->open_short_t + i);
            V since = lanes_load(lists->open_since + i);
            V speed = lanes_load(lists->open_speed + i);
            V until = lanes_load(lists->open_until + i);
            V velocity_error = lanes_load(lists->open_velocity_error + i);
            V vx = lanes_load(lists->open_vx + i);
            V vy = lanes_load(lists->open_vy + i);
            V vz = lanes_load(lists->open_vz + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(court_leapt_out) _o38 =
                LANES(court_leapt)(arrival, certain, lanes_wide(short_t), searching, served, since);
            arrival = _o38.arrival;
            V t = _o38.t;
            searching = _o38.searching;
            lanes_store(lists->open_arrival + i, arrival);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_searching_row + open_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_searching_arrival + open_searching_shots, packed, arrival);
                lanes_pack(lists->open_searching_certain + open_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->open_searching_doubt + open_searching_shots, packed, doubt);
                lanes_pack(lists->open_searching_extent + open_searching_shots, packed, extent);
                lanes_pack(lists->open_searching_last + open_searching_shots, packed, last);
                if (varying)
                    lanes_pack(lists->open_searching_p_ball_radius + open_searching_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_searching_p_gravity + open_searching_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->open_searching_p_ring_radius + open_searching_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->open_searching_p_wire_radius + open_searching_shots, packed, p_wire_radius);
                lanes_pack(lists->open_searching_position_error + open_searching_shots, packed, position_error);
                lanes_pack(lists->open_searching_share + open_searching_shots, packed, share);
                lanes_pack(lists->open_searching_speed + open_searching_shots, packed, speed);
                lanes_pack(lists->open_searching_t + open_searching_shots, packed, t);
                lanes_pack(lists->open_searching_until + open_searching_shots, packed, until);
                lanes_pack(lists->open_searching_velocity_error + open_searching_shots, packed, velocity_error);
                lanes_pack(lists->open_searching_vx + open_searching_shots, packed, vx);
                lanes_pack(lists->open_searching_vy + open_searching_shots, packed, vy);
                lanes_pack(lists->open_searching_vz + open_searching_shots, packed, vz);
                lanes_pack(lists->open_searching_x + open_searching_shots, packed, x);
                lanes_pack(lists->open_searching_y + open_searching_shots, packed, y);
                lanes_pack(lists->open_searching_z + open_searching_shots, packed, z);
                open_searching_shots += lanes_many(packed);
            }
        }
        {
        size_t open_searching_searching_shots = 0;
        for (size_t i = 0; i < open_searching_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_searching_shots - i);
            V arrival = lanes_load(lists->open_searching_arrival + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_searching_certain + i));
            V doubt = lanes_load(lists->open_searching_doubt + i);
            V extent = lanes_load(lists->open_searching_extent + i);
            V last = lanes_load(lists->open_searching_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_searching_p_ball_radius + i : lists->p_ball_radius);
            const V p_gravity = lanes_load(varying ? lists->open_searching_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->open_searching_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->open_searching_p_wire_radius + i : lists->p_wire_radius);
            V position_error = lanes_load(lists->open_searching_position_error + i);
            V share = lanes_load(lists->open_searching_share + i);
            V speed = lanes_load(lists->open_searching_speed + i);
            V t = lanes_load(lists->open_searching_t + i);
            V until = lanes_load(lists->open_searching_until + i);
            V velocity_error = lanes_load(lists->open_searching_velocity_error + i);
            V vx = lanes_load(lists->open_searching_vx + i);
            V vy = lanes_load(lists->open_searching_vy + i);
            V vz = lanes_load(lists->open_searching_vz + i);
            V x = lanes_load(lists->open_searching_x + i);
            V y = lanes_load(lists->open_searching_y + i);
            V z = lanes_load(lists->open_searching_z + i);
            const LANES(court_ring_prepare_out) _o39 =
                LANES(court_ring_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V steady = _o39.steady;
            V swing = _o39.swing;
            V rho_start = _o39.rho_start;
            V low0 = _o39.low0;
            V high0 = _o39.high0;
            V low1 = _o39.low1;
            V high1 = _o39.high1;
            V low2 = _o39.low2;
            V high2 = _o39.high2;
            V ceiling = _o39.ceiling;
            V latest = _o39.latest;
            const LANES(court_allowance_out) _o40 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
            V position_level = _o40.position_level;
            V velocity_level = _o40.velocity_level;
            const LANES(court_ring_margins_out) _o41 =
                LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V flat = _o41.margin;
            V tilt = _o41.leaving_margin;
            V rate_slack = _o41.rate_margin;
            const LANES(court_ring_enter_out) _o42 =
                LANES(court_ring_enter)(t, K(0.0), high0, high1, high2, low0, low1, low2, t);
            t = _o42.t;
            V end = _o42.end;
            M searching = _o42.searching;
            lanes_store(lists->open_searching_ceiling + i, ceiling);
            lanes_store(lists->open_searching_flat + i, flat);
            lanes_store(lists->open_searching_latest + i, latest);
            lanes_store(lists->open_searching_rho_start + i, rho_start);
            lanes_store(lists->open_searching_searching + i, lanes_select(searching, K(1.0), K(0.0)));
            lanes_store(lists->open_searching_t + i, t);
            lanes_store(lists->open_searching_tilt + i, tilt);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_searching_searching_row + open_searching_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_searching_searching_arrival + open_searching_searching_shots, packed, arrival);
                lanes_pack(lists->open_searching_searching_ceiling + open_searching_searching_shots, packed, ceiling);
                lanes_pack(lists->open_searching_searching_certain + open_searching_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->open_searching_searching_doubt + open_searching_searching_shots, packed, doubt);
                lanes_pack(lists->open_searching_searching_end + open_searching_searching_shots, packed, end);
                lanes_pack(lists->open_searching_searching_extent + open_searching_searching_shots, packed, extent);
                lanes_pack(lists->open_searching_searching_flat + open_searching_searching_shots, packed, flat);
                lanes_pack(lists->open_searching_searching_high0 + open_searching_searching_shots, packed, high0);
                lanes_pack(lists->open_searching_searching_high1 + open_searching_searching_shots, packed, high1);
                lanes_pack(lists->open_searching_searching_high2 + open_searching_searching_shots, packed, high2);
                lanes_pack(lists->open_searching_searching_last + open_searching_searching_shots, packed, last);
                lanes_pack(lists->open_searching_searching_latest + open_searching_searching_shots, packed, latest);
                lanes_pack(lists->open_searching_searching_low0 + open_searching_searching_shots, packed, low0);
                lanes_pack(lists->open_searching_searching_low1 + open_searching_searching_shots, packed, low1);
                lanes_pack(lists->open_searching_searching_low2 + open_searching_searching_shots, packed, low2);
                if (varying)
                    lanes_pack(lists->open_searching_searching_p_ball_radius + open_searching_searching_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_searching_searching_p_gravity + open_searching_searching_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->open_searching_searching_p_ring_radius + open_searching_searching_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->open_searching_searching_p_wire_radius + open_searching_searching_shots, packed, p_wire_radius);
                lanes_pack(lists->open_searching_searching_position_error + open_searching_searching_shots, packed, position_error);
                lanes_pack(lists->open_searching_searching_rate_slack + open_searching_searching_shots, packed, rate_slack);
                lanes_pack(lists->open_searching_searching_rho_start + open_searching_searching_shots, packed, rho_start);
                lanes_pack(lists->open_searching_searching_share + open_searching_searching_shots, packed, share);
                lanes_pack(lists->open_searching_searching_speed + open_searching_searching_shots, packed, speed);
                lanes_pack(lists->open_searching_searching_steady + open_searching_searching_shots, packed, steady);
                lanes_pack(lists->open_searching_searching_swing + open_searching_searching_shots, packed, swing);
                lanes_pack(lists->open_searching_searching_t + open_searching_searching_shots, packed, t);
                lanes_pack(lists->open_searching_searching_tilt + open_searching_searching_shots, packed, tilt);
                lanes_pack(lists->open_searching_searching_velocity_error + open_searching_searching_shots, packed, velocity_error);
                lanes_pack(lists->open_searching_searching_vx + open_searching_searching_shots, packed, vx);
                lanes_pack(lists->open_searching_searching_vy + open_searching_searching_shots, packed, vy);
                lanes_pack(lists->open_searching_searching_vz + open_searching_searching_shots, packed, vz);
                lanes_pack(lists->open_searching_searching_x + open_searching_searching_shots, packed, x);
                lanes_pack(lists->open_searching_searching_y + open_searching_searching_shots, packed, y);
                lanes_pack(lists->open_searching_searching_z + open_searching_searching_shots, packed, z);
                open_searching_searching_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
            V p_ball_radius = lanes_load(lists->p_ball_radius);
            V p_gravity = lanes_load(lists->p_gravity);
            V p_ring_radius = lanes_load(lists->p_ring_radius);
            V p_wire_radius = lanes_load(lists->p_wire_radius);
            V arrival = K(0.0);
            V ceiling = K(0.0);
            M certain = lanes_nowhere();
            V doubt = K(0.0);
            V end = K(0.0);
            V extent = K(0.0);
            V flat = K(0.0);
            V high0 = K(0.0);
            V high1 = K(0.0);
            V high2 = K(0.0);
            V last = K(0.0);
            V latest = K(0.0);
            V low0 = K(0.0);
            V low1 = K(0.0);
            V low2 = K(0.0);
            V position_error = K(0.0);
            V rate_slack = K(0.0);
            V rho_start = K(0.0);
            V share = K(0.0);
            V speed = K(0.0);
            V steady = K(0.0);
            V swing = K(0.0);
            V t = K(0.0);
            V tilt = K(0.0);
            V velocity_error = K(0.0);
            V vx = K(0.0);
            V vy = K(0.0);
            V vz = K(0.0);
            V x = K(0.0);
            V y = K(0.0);
            V z = K(0.0);
            for (;;) {
                if (taken < open_searching_searching_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->open_searching_searching_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->open_searching_searching_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->open_searching_searching_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->open_searching_searching_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    doubt = lanes_expand(lists->open_searching_searching_doubt + taken, idle, doubt);
                    end = lanes_expand(lists->open_searching_searching_end + taken, idle, end);
                    extent = lanes_expand(lists->open_searching_searching_extent + taken, idle, extent);
                    flat = lanes_expand(lists->open_searching_searching_flat + taken, idle, flat);
                    high0 = lanes_expand(lists->open_searching_searching_high0 + taken, idle, high0);
                    high1 = lanes_expand(lists->open_searching_searching_high1 + taken, idle, high1);
                    high2 = lanes_expand(lists->open_searching_searching_high2 + taken, idle, high2);
                    last = lanes_expand(lists->open_searching_searching_last + taken, idle, last);
                    latest = lanes_expand(lists->open_searching_searching_latest + taken, idle, latest);
                    low0 = lanes_expand(lists->open_searching_searching_low0 + taken, idle, low0);
                    low1 = lanes_expand(lists->open_searching_searching_low1 + taken, idle, low1);
                    low2 = lanes_expand(lists->open_searching_searching_low2 + taken, idle, low2);
                    position_error = lanes_expand(lists->open_searching_searching_position_error + taken, idle, position_error);
                    rate_slack = lanes_expand(lists->open_searching_searching_rate_slack + taken, idle, rate_slack);
                    rho_start = lanes_expand(lists->open_searching_searching_rho_start + taken, idle, rho_start);
                    share = lanes_expand(lists->open_searching_searching_share + taken, idle, share);
                    speed = lanes_expand(lists->open_searching_searching_speed + taken, idle, speed);
                    steady = lanes_expand(lists->open_searching_searching_steady + taken, idle, steady);
                    swing = lanes_expand(lists->open_searching_searching_swing + taken, idle, swing);
                    t = lanes_expand(lists->open_searching_searching_t + taken, idle, t);
                    tilt = lanes_expand(lists->open_searching_searching_tilt + taken, idle, tilt);
                    velocity_error = lanes_expand(lists->open_searching_searching_velocity_error + taken, idle, velocity_error);
                    vx = lanes_expand(lists->open_searching_searching_vx + taken, idle, vx);
                    vy = lanes_expand(lists->open_searching_searching_vy + taken, idle, vy);
                    vz = lanes_expand(lists->open_searching_searching_vz + taken, idle, vz);
                    x = lanes_expand(lists->open_searching_searching_x + taken, idle, x);
                    y = lanes_expand(lists->open_searching_searching_y + taken, idle, y);
                    z = lanes_expand(lists->open_searching_searching_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->open_searching_searching_p_ball_radius + taken, idle, p_ball_radius);
                        p_gravity = lanes_expand(lists->open_searching_searching_p_gravity + taken, idle, p_gravity);
                        p_ring_radius = lanes_expand(lists->open_searching_searching_p_ring_radius + taken, idle, p_ring_radius);
                        p_wire_radius = lanes_expand(lists->open_searching_searching_p_wire_radius + taken, idle, p_wire_radius);
                    }
                    const size_t room = LANES_WIDTH - busy, left = open_searching_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o43 =
                    LANES(court_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = _o43.leaving;
                V margin = _o43.margin;
                const LANES(court_ring_advance_out) _o44 =
                    LANES(court_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V gap = _o44.gap;
                V rate = _o44.rate;
                V bend = _o44.bend;
                V step = _o44.step;
                V next = _o44.next;
                V clearance = _o44.clearance;
                const LANES(court_struck_out) _o45 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o45.hit;
                M sure = _o45.sure;
                M vague = _o45.vague;
                const M _m46 = lanes_both(active, vague);
                if (lanes_any(_m46)) {
                    const LANES(court_finer_out) _o47 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m46, _o47.share, share);
                    const LANES(court_allowance_out) _o48 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o48.position_level;
                    V velocity_level = _o48.velocity_level;
                    V excess = _o48.excess;
                    const LANES(court_ring_margins_out) _o49 =
                        LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    flat = lanes_select(_m46, _o49.margin, flat);
                    tilt = lanes_select(_m46, _o49.leaving_margin, tilt);
                    rate_slack = lanes_select(_m46, _o49.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o50 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m46, _o50.doubt, doubt);
                }
                const LANES(court_advanced_out) _o51 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o51.arrival;
                certain = _o51.certain;
                M exhausted = _o51.exhausted;
                searching = _o51.searching;
                t = _o51.t;
                const M _m52 = lanes_both(active, exhausted);
                {
                    const LANES(court_ring_enter_out) _o53 =
                        LANES(court_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m52, _o53.t, t);
                    end = lanes_select(_m52, _o53.end, end);
                    searching = lanes_choose(_m52, _o53.searching, searching);
                }
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(searching, lanes_less(turns, K(201.0)))));
                if (lanes_any(ended)) {
                    double ended_row[LANES_WIDTH];
                    lanes_store(ended_row, row);
                    double ended_arrival[LANES_WIDTH];
                    lanes_store(ended_arrival, arrival);
                    double ended_certain[LANES_WIDTH];
                    lanes_store(ended_certain, lanes_select(certain, K(1.0), K(0.0)));
                    double ended_doubt[LANES_WIDTH];
                    lanes_store(ended_doubt, doubt);
                    double ended_flat[LANES_WIDTH];
                    lanes_store(ended_flat, flat);
                    double ended_searching[LANES_WIDTH];
                    lanes_store(ended_searching, lanes_select(searching, K(1.0), K(0.0)));
                    double ended_t[LANES_WIDTH];
                    lanes_store(ended_t, t);
                    double ended_tilt[LANES_WIDTH];
                    lanes_store(ended_tilt, tilt);
                    for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                        const int lane = LANES_LOWEST(bits);
                        const size_t k = (size_t)ended_row[lane];
                        lists->open_searching_arrival[k] = ended_arrival[lane];
                        lists->open_searching_certain[k] = ended_certain[lane];
                        lists->open_searching_doubt[k] = ended_doubt[lane];
                        lists->open_searching_flat[k] = ended_flat[lane];
                        lists->open_searching_searching[k] = ended_searching[lane];
                        lists->open_searching_t[k] = ended_t[lane];
                        lists->open_searching_tilt[k] = ended_tilt[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        for (size_t i = 0; i < open_searching_shots; i += LANES_WIDTH) {
            V doubt = lanes_load(lists->open_searching_doubt + i);
            M searching = lanes_less(K(0.0), lanes_load(lists->open_searching_searching + i));
            V t = lanes_load(lists->open_searching_t + i);
            const LANES(court_questioned_out) _o54 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o54.doubt;
            lanes_store(lists->open_searching_doubt + i, doubt);
        }
        for (size_t k = 0; k < open_searching_shots; k++) {
            const size_t row = (size_t)lists->open_searching_row[k];
            lists->open_arrival[row] = lists->open_searching_arrival[k];
            lists->open_ceiling[row] = lists->open_searching_ceiling[k];
            lists->open_certain[row] = lists->open_searching_certain[k];
            lists->open_doubt[row] = lists->open_searching_doubt[k];
            lists->open_flat[row] = lists->open_searching_flat[k];
            lists->open_latest[row] = lists->open_searching_latest[k];
            lists->open_rho_start[row] = lists->open_searching_rho_start[k];
            lists->open_tilt[row] = lists->open_searching_tilt[k];
        }
        }
        {
        size_t open_refining_shots = 0;
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_shots - i);
            V arrival = lanes_load(lists->open_arrival + i);
            V ceiling = lanes_load(lists->open_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_certain + i));
            V flat = lanes_load(lists->open_flat + i);
            V last = lanes_load(lists->open_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius);
            const V p_gravity = lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->open_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->open_p_wire_radius + i : lists->p_wire_radius);
            V rho_start = lanes_load(lists->open_rho_start + i);
            V tilt = lanes_load(lists->open_tilt + i);
            V vx = lanes_load(lists->open_vx + i);
            V vy = lanes_load(lists->open_vy + i);
            V vz = lanes_load(lists->open_vz + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(court_found_out) _o55 =
                LANES(court_found)(arrival);
            M arrives = _o55.arrives;
            M refining = _o55.refining;
            V rate = _o55.rate;
            const LANES(court_nearby_out) _o56 =
                LANES(court_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o56.leaving;
            const M _m57 = lanes_both(rows, refining);
            if (lanes_any(_m57)) {
                const LANES(court_ring_refine_out) _o58 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V refined = _o58.time;
                V gap = _o58.gap;
                rate = lanes_select(_m57, _o58.rate, rate);
                const LANES(court_polished_out) _o59 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m57, _o59.arrival, arrival);
                refining = lanes_choose(_m57, _o59.refining, refining);
            }
            const M _m60 = lanes_both(rows, refining);
            if (lanes_any(_m60)) {
                const LANES(court_ring_refine_out) _o61 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V refined = _o61.time;
                V gap = _o61.gap;
                rate = lanes_select(_m60, _o61.rate, rate);
                const LANES(court_polished_out) _o62 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m60, _o62.arrival, arrival);
                refining = lanes_choose(_m60, _o62.refining, refining);
            }
            lanes_store(lists->open_arrival + i, arrival);
            lanes_store(lists->open_arrives + i, lanes_select(arrives, K(1.0), K(0.0)));
            lanes_store(lists->open_leaving + i, leaving);
            lanes_store(lists->open_rate + i, rate);
            const M packed = lanes_both(rows, refining);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_refining_row + open_refining_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_refining_arrival + open_refining_shots, packed, arrival);
                lanes_pack(lists->open_refining_ceiling + open_refining_shots, packed, ceiling);
                lanes_pack(lists->open_refining_certain + open_refining_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->open_refining_leaving + open_refining_shots, packed, leaving);
                if (varying)
                    lanes_pack(lists->open_refining_p_ball_radius + open_refining_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_refining_p_gravity + open_refining_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->open_refining_p_ring_radius + open_refining_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->open_refining_p_wire_radius + open_refining_shots, packed, p_wire_radius);
                lanes_pack(lists->open_refining_rho_start + open_refining_shots, packed, rho_start);
                lanes_pack(lists->open_refining_vx + open_refining_shots, packed, vx);
                lanes_pack(lists->open_refining_vy + open_refining_shots, packed, vy);
                lanes_pack(lists->open_refining_vz + open_refining_shots, packed, vz);
                lanes_pack(lists->open_refining_x + open_refining_shots, packed, x);
                lanes_pack(lists->open_refining_y + open_refining_shots, packed, y);
                lanes_pack(lists->open_refining_z + open_refining_shots, packed, z);
                open_refining_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
            V p_ball_radius = lanes_load(lists->p_ball_radius);
            V p_gravity = lanes_load(lists->p_gravity);
            V p_ring_radius = lanes_load(lists->p_ring_radius);
            V p_wire_radius = lanes_load(lists->p_wire_radius);
            V arrival = K(0.0);
            V ceiling = K(0.0);
            M certain = lanes_nowhere();
            V leaving = K(0.0);
            V rho_start = K(0.0);
            V vx = K(0.0);
            V vy = K(0.0);
            V vz = K(0.0);
            V x = K(0.0);
            V y = K(0.0);
            V z = K(0.0);
            for (;;) {
                if (taken < open_refining_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->open_refining_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->open_refining_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->open_refining_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->open_refining_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    leaving = lanes_expand(lists->open_refining_leaving + taken, idle, leaving);
                    rho_start = lanes_expand(lists->open_refining_rho_start + taken, idle, rho_start);
                    vx = lanes_expand(lists->open_refining_vx + taken, idle, vx);
                    vy = lanes_expand(lists->open_refining_vy + taken, idle, vy);
                    vz = lanes_expand(lists->open_refining_vz + taken, idle, vz);
                    x = lanes_expand(lists->open_refining_x + taken, idle, x);
                    y = lanes_expand(lists->open_refining_y + taken, idle, y);
                    z = lanes_expand(lists->open_refining_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->open_refining_p_ball_radius + taken, idle, p_ball_radius);
                        p_gravity = lanes_expand(lists->open_refining_p_gravity + taken, idle, p_gravity);
                        p_ring_radius = lanes_expand(lists->open_refining_p_ring_radius + taken, idle, p_ring_radius);
                        p_wire_radius = lanes_expand(lists->open_refining_p_wire_radius + taken, idle, p_wire_radius);
                    }
                    const size_t room = LANES_WIDTH - busy, left = open_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_ring_refine_out) _o63 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V refined = _o63.time;
                V gap = _o63.gap;
                V rate = _o63.rate;
                const LANES(court_polished_out) _o64 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o64.arrival;
                refining = _o64.refining;
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(refining, lanes_less(turns, K(8.0)))));
                if (lanes_any(ended)) {
                    double ended_row[LANES_WIDTH];
                    lanes_store(ended_row, row);
                    double ended_arrival[LANES_WIDTH];
                    lanes_store(ended_arrival, arrival);
                    double ended_rate[LANES_WIDTH];
                    lanes_store(ended_rate, rate);
                    for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                        const int lane = LANES_LOWEST(bits);
                        const size_t k = (size_t)ended_row[lane];
                        lists->open_arrival[k] = ended_arrival[lane];
                        lists->open_rate[k] = ended_rate[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            V arrival = lanes_load(lists->open_arrival + i);
            M arrives = lanes_less(K(0.0), lanes_load(lists->open_arrives + i));
            V ceiling = lanes_load(lists->open_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_certain + i));
            V doubt = lanes_load(lists->open_doubt + i);
            V extent = lanes_load(lists->open_extent + i);
            V late = lanes_load(lists->open_late + i);
            V latest = lanes_load(lists->open_latest + i);
            V leaving = lanes_load(lists->open_leaving + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius);
            const V p_gravity = lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->open_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->open_p_wire_radius + i : lists->p_wire_radius);
            V position_error = lanes_load(lists->open_position_error + i);
            V rate = lanes_load(lists->open_rate + i);
            V speed = lanes_load(lists->open_speed + i);
            V velocity_error = lanes_load(lists->open_velocity_error + i);
            V when = lanes_load(lists->open_when + i);
            V which = lanes_load(lists->open_which + i);
            const LANES(court_ring_margins_out) _o65 =
                LANES(court_ring_margins)(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V flat = _o65.margin;
            V tilt = _o65.leaving_margin;
            V rate_margin = _o65.rate_margin;
            const LANES(court_own_margin_out) _o66 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o66.margin;
            const LANES(court_crossing_out) _o67 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o67.clearance;
            V delay = _o67.delay;
            const LANES(court_landed_out) _o68 =
                LANES(court_landed)(arrival);
            V time = _o68.time;
            const LANES(court_landed_surely_out) _o69 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o69.delay;
            doubt = _o69.doubt;
            const LANES(court_tied_out) _o70 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o70.doubt;
            late = _o70.late;
            const LANES(court_sooner_out) _o71 =
                LANES(court_sooner)(arrives, K(0.0), time, when, which);
            when = _o71.when;
            which = _o71.which;
            lanes_store(lists->open_doubt + i, doubt);
            lanes_store(lists->open_late + i, late);
            lanes_store(lists->open_when + i, when);
            lanes_store(lists->open_which + i, which);
        }
        for (size_t k = 0; k < open_shots; k++) {
            const size_t row = (size_t)lists->open_row[k];
            lists->doubt[row] = lists->open_doubt[k];
            lists->late[row] = lists->open_late[k];
            lists->when[row] = lists->open_when[k];
            lists->which[row] = lists->open_which[k];
        }
        }
        {
        size_t reachable_shots = 0;
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            V doubt = lanes_load(lists->doubt + i);
            V extent = lanes_load(lists->extent + i);
            M kept = lanes_less(K(0.0), lanes_load(lists->kept + i));
            V last = lanes_load(lists->last + i);
            V late = lanes_load(lists->late + i);
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_bottom = lanes_load(lists->p_board_bottom + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_board_half_width = lanes_load(lists->p_board_half_width + (i & varying));
            const V p_board_thickness = lanes_load(lists->p_board_thickness + (i & varying));
            const V p_board_top = lanes_load(lists->p_board_top + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            V position_error = lanes_load(lists->position_error + i);
            V speed = lanes_load(lists->speed + i);
            V velocity_error = lanes_load(lists->velocity_error + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V when = lanes_load(lists->when + i);
            V which = lanes_load(lists->which + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const LANES(court_horizon_out) _o72 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o72.horizon;
            V pad = _o72.pad;
            const LANES(court_halved_out) _o73 =
                LANES(court_halved)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, late, pad, p_gravity);
            V middle_x = _o73.middle_x;
            V reach_x = _o73.reach_x;
            V later_middle_x = _o73.later_middle_x;
            V later_reach_x = _o73.later_reach_x;
            V middle_y = _o73.middle_y;
            V reach_y = _o73.reach_y;
            V later_middle_y = _o73.later_middle_y;
            V later_reach_y = _o73.later_reach_y;
            V middle_z = _o73.middle_z;
            V reach_z = _o73.reach_z;
            V later_middle_z = _o73.later_middle_z;
            V later_reach_z = _o73.later_reach_z;
            const LANES(court_backboard_near_out) _o74 =
                LANES(court_backboard_near)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, later_middle_x, later_middle_y, later_middle_z, later_reach_x, later_reach_y, later_reach_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
            M reachable = _o74.near;
            const LANES(court_reachable_in_flight_out) _o75 =
                LANES(court_reachable_in_flight)(kept, reachable);
            reachable = _o75.reachable;
            const M packed = lanes_both(rows, reachable);
            if (lanes_any(packed)) {
                lanes_pack(lists->reachable_row + reachable_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->reachable_doubt + reachable_shots, packed, doubt);
                lanes_pack(lists->reachable_extent + reachable_shots, packed, extent);
                lanes_pack(lists->reachable_last + reachable_shots, packed, last);
                lanes_pack(lists->reachable_late + reachable_shots, packed, late);
                if (varying)
                    lanes_pack(lists->reachable_p_ball_radius + reachable_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->reachable_p_board_bottom + reachable_shots, packed, p_board_bottom);
                if (varying)
                    lanes_pack(lists->reachable_p_board_distance + reachable_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->reachable_p_board_half_width + reachable_shots, packed, p_board_half_width);
                if (varying)
                    lanes_pack(lists->reachable_p_board_thickness + reachable_shots, packed, p_board_thickness);
                if (varying)
                    lanes_pack(lists->reachable_p_board_top + reachable_shots, packed, p_board_top);
                if (varying)
                    lanes_pack(lists->reachable_p_gravity + reachable_shots, packed, p_gravity);
                lanes_pack(lists->reachable_position_error + reachable_shots, packed, position_error);
                lanes_pack(lists->reachable_speed + reachable_shots, packed, speed);
                lanes_pack(lists->reachable_velocity_error + reachable_shots, packed, velocity_error);
                lanes_pack(lists->reachable_vx + reachable_shots, packed, vx);
                lanes_pack(lists->reachable_vy + reachable_shots, packed, vy);
                lanes_pack(lists->reachable_vz + reachable_shots, packed, vz);
                lanes_pack(lists->reachable_when + reachable_shots, packed, when);
                lanes_pack(lists->reachable_which + reachable_shots, packed, which);
                lanes_pack(lists->reachable_x + reachable_shots, packed, x);
                lanes_pack(lists->reachable_y + reachable_shots, packed, y);
                lanes_pack(lists->reachable_z + reachable_shots, packed, z);
                reachable_shots += lanes_many(packed);
            }
        }
        {
        size_t reachable_searching_shots = 0;
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(reachable_shots - i);
            V doubt = lanes_load(lists->reachable_doubt + i);
            V extent = lanes_load(lists->reachable_extent + i);
            V last = lanes_load(lists->reachable_last + i);
            V late = lanes_load(lists->reachable_late + i);
            const V p_ball_radius = lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_bottom = lanes_load(varying ? lists->reachable_p_board_bottom + i : lists->p_board_bottom);
            const V p_board_distance = lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance);
            const V p_board_half_width = lanes_load(varying ? lists->reachable_p_board_half_width + i : lists->p_board_half_width);
            const V p_board_thickness = lanes_load(varying ? lists->reachable_p_board_thickness + i : lists->p_board_thickness);
            const V p_board_top = lanes_load(varying ? lists->reachable_p_board_top + i : lists->p_board_top);
            const V p_gravity = lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity);
            V position_error = lanes_load(lists->reachable_position_error + i);
            V speed = lanes_load(lists->reachable_speed + i);
            V velocity_error = lanes_load(lists->reachable_velocity_error + i);
            V vx = lanes_load(lists->reachable_vx + i);
            V vy = lanes_load(lists->reachable_vy + i);
            V vz = lanes_load(lists->reachable_vz + i);
            V when = lanes_load(lists->reachable_when + i);
            V x = lanes_load(lists->reachable_x + i);
            V y = lanes_load(lists->reachable_y + i);
            V z = lanes_load(lists->reachable_z + i);
            const LANES(court_horizon_out) _o76 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o76.horizon;
            V pad = _o76.pad;
            const LANES(court_backboard_prepare_out) _o77 =
                LANES(court_backboard_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V low0 = _o77.low0;
            V high0 = _o77.high0;
            V low1 = _o77.low1;
            V high1 = _o77.high1;
            V ceiling = _o77.ceiling;
            V latest = _o77.latest;
            V lost = _o77.lost;
            const LANES(court_beginning_out) _o78 =
                LANES(court_beginning)();
            V share = _o78.share;
            V arrival = _o78.arrival;
            M certain = _o78.certain;
            const LANES(court_allowance_out) _o79 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
            V position_level = _o79.position_level;
            V velocity_level = _o79.velocity_level;
            V excess = _o79.excess;
            const LANES(court_backboard_margins_out) _o80 =
                LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V flat = _o80.margin;
            V tilt = _o80.leaving_margin;
            V rate_slack = _o80.rate_margin;
            const LANES(court_backboard_enter_out) _o81 =
                LANES(court_backboard_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o81.t;
            V end = _o81.end;
            M searching = _o81.searching;
            const LANES(court_beyond_windows_out) _o82 =
                LANES(court_beyond_windows)(doubt, excess, late, lost, pad, searching);
            doubt = _o82.doubt;
            const M _m83 = lanes_both(rows, searching);
            if (lanes_any(_m83)) {
                const LANES(court_nearby_out) _o84 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o84.leaving;
                V margin = _o84.margin;
                const LANES(court_backboard_advance_out) _o85 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V gap = _o85.gap;
                V rate = _o85.rate;
                V bend = _o85.bend;
                V step = _o85.step;
                V next = _o85.next;
                V clearance = _o85.clearance;
                const LANES(court_struck_or_still_out) _o86 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o86.hit;
                M sure = _o86.sure;
                M vague = _o86.vague;
                const M _m87 = lanes_both(_m83, vague);
                if (lanes_any(_m87)) {
                    const LANES(court_finer_out) _o88 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m87, _o88.share, share);
                    const LANES(court_allowance_out) _o89 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o89.position_level;
                    V velocity_level = _o89.velocity_level;
                    V excess = _o89.excess;
                    const LANES(court_backboard_margins_out) _o90 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                    flat = lanes_select(_m87, _o90.margin, flat);
                    tilt = lanes_select(_m87, _o90.leaving_margin, tilt);
                    rate_slack = lanes_select(_m87, _o90.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o91 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m87, _o91.doubt, doubt);
                }
                const LANES(court_advanced_out) _o92 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = lanes_select(_m83, _o92.arrival, arrival);
                certain = lanes_choose(_m83, _o92.certain, certain);
                M exhausted = _o92.exhausted;
                searching = lanes_choose(_m83, _o92.searching, searching);
                t = lanes_select(_m83, _o92.t, t);
                const M _m93 = lanes_both(_m83, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o94 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m93, _o94.t, t);
                    end = lanes_select(_m93, _o94.end, end);
                    searching = lanes_choose(_m93, _o94.searching, searching);
                }
            }
            lanes_store(lists->reachable_arrival + i, arrival);
            lanes_store(lists->reachable_ceiling + i, ceiling);
            lanes_store(lists->reachable_certain + i, lanes_select(certain, K(1.0), K(0.0)));
            lanes_store(lists->reachable_doubt + i, doubt);
            lanes_store(lists->reachable_flat + i, flat);
            lanes_store(lists->reachable_latest + i, latest);
            lanes_store(lists->reachable_searching + i, lanes_select(searching, K(1.0), K(0.0)));
            lanes_store(lists->reachable_t + i, t);
            lanes_store(lists->reachable_tilt + i, tilt);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->reachable_searching_row + reachable_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->reachable_searching_arrival + reachable_searching_shots, packed, arrival);
                lanes_pack(lists->reachable_searching_ceiling + reachable_searching_shots, packed, ceiling);
                lanes_pack(lists->reachable_searching_certain + reachable_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->reachable_searching_doubt + reachable_searching_shots, packed, doubt);
                lanes_pack(lists->reachable_searching_end + reachable_searching_shots, packed, end);
                lanes_pack(lists->reachable_searching_extent + reachable_searching_shots, packed, extent);
                lanes_pack(lists->reachable_searching_flat + reachable_searching_shots, packed, flat);
                lanes_pack(lists->reachable_searching_high0 + reachable_searching_shots, packed, high0);
                lanes_pack(lists->reachable_searching_high1 + reachable_searching_shots, packed, high1);
                lanes_pack(lists->reachable_searching_last + reachable_searching_shots, packed, last);
                lanes_pack(lists->reachable_searching_latest + reachable_searching_shots, packed, latest);
                lanes_pack(lists->reachable_searching_low0 + reachable_searching_shots, packed, low0);
                lanes_pack(lists->reachable_searching_low1 + reachable_searching_shots, packed, low1);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_ball_radius + reachable_searching_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_board_bottom + reachable_searching_shots, packed, p_board_bottom);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_board_distance + reachable_searching_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_board_half_width + reachable_searching_shots, packed, p_board_half_width);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_board_thickness + reachable_searching_shots, packed, p_board_thickness);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_board_top + reachable_searching_shots, packed, p_board_top);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_gravity + reachable_searching_shots, packed, p_gravity);
                lanes_pack(lists->reachable_searching_position_error + reachable_searching_shots, packed, position_error);
                lanes_pack(lists->reachable_searching_rate_slack + reachable_searching_shots, packed, rate_slack);
                lanes_pack(lists->reachable_searching_share + reachable_searching_shots, packed, share);
                lanes_pack(lists->reachable_searching_speed + reachable_searching_shots, packed, speed);
                lanes_pack(lists->reachable_searching_t + reachable_searching_shots, packed, t);
                lanes_pack(lists->reachable_searching_tilt + reachable_searching_shots, packed, tilt);
                lanes_pack(lists->reachable_searching_velocity_error + reachable_searching_shots, packed, velocity_error);
                lanes_pack(lists->reachable_searching_vx + reachable_searching_shots, packed, vx);
                lanes_pack(lists->reachable_searching_vy + reachable_searching_shots, packed, vy);
                lanes_pack(lists->reachable_searching_vz + reachable_searching_shots, packed, vz);
                lanes_pack(lists->reachable_searching_x + reachable_searching_shots, packed, x);
                lanes_pack(lists->reachable_searching_y + reachable_searching_shots, packed, y);
                lanes_pack(lists->reachable_searching_z + reachable_searching_shots, packed, z);
                reachable_searching_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
            V p_ball_radius = lanes_load(lists->p_ball_radius);
            V p_board_bottom = lanes_load(lists->p_board_bottom);
            V p_board_distance = lanes_load(lists->p_board_distance);
            V p_board_half_width = lanes_load(lists->p_board_half_width);
            V p_board_thickness = lanes_load(lists->p_board_thickness);
            V p_board_top = lanes_load(lists->p_board_top);
            V p_gravity = lanes_load(lists->p_gravity);
            V arrival = K(0.0);
            V ceiling = K(0.0);
            M certain = lanes_nowhere();
            V doubt = K(0.0);
            V end = K(0.0);
            V extent = K(0.0);
            V flat = K(0.0);
            V high0 = K(0.0);
            V high1 = K(0.0);
            V last = K(0.0);
            V latest = K(0.0);
            V low0 = K(0.0);
            V low1 = K(0.0);
            V position_error = K(0.0);
            V rate_slack = K(0.0);
            V share = K(0.0);
            V speed = K(0.0);
            V t = K(0.0);
            V tilt = K(0.0);
            V velocity_error = K(0.0);
            V vx = K(0.0);
            V vy = K(0.0);
            V vz = K(0.0);
            V x = K(0.0);
            V y = K(0.0);
            V z = K(0.0);
            for (;;) {
                if (taken < reachable_searching_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->reachable_searching_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->reachable_searching_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->reachable_searching_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->reachable_searching_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    doubt = lanes_expand(lists->reachable_searching_doubt + taken, idle, doubt);
                    end = lanes_expand(lists->reachable_searching_end + taken, idle, end);
                    extent = lanes_expand(lists->reachable_searching_extent + taken, idle, extent);
                    flat = lanes_expand(lists->reachable_searching_flat + taken, idle, flat);
                    high0 = lanes_expand(lists->reachable_searching_high0 + taken, idle, high0);
                    high1 = lanes_expand(lists->reachable_searching_high1 + taken, idle, high1);
                    last = lanes_expand(lists->reachable_searching_last + taken, idle, last);
                    latest = lanes_expand(lists->reachable_searching_latest + taken, idle, latest);
                    low0 = lanes_expand(lists->reachable_searching_low0 + taken, idle, low0);
                    low1 = lanes_expand(lists->reachable_searching_low1 + taken, idle, low1);
                    position_error = lanes_expand(lists->reachable_searching_position_error + taken, idle, position_error);
                    rate_slack = lanes_expand(lists->reachable_searching_rate_slack + taken, idle, rate_slack);
                    share = lanes_expand(lists->reachable_searching_share + taken, idle, share);
                    speed = lanes_expand(lists->reachable_searching_speed + taken, idle, speed);
                    t = lanes_expand(lists->reachable_searching_t + taken, idle, t);
                    tilt = lanes_expand(lists->reachable_searching_tilt + taken, idle, tilt);
                    velocity_error = lanes_expand(lists->reachable_searching_velocity_error + taken, idle, velocity_error);
                    vx = lanes_expand(lists->reachable_searching_vx + taken, idle, vx);
                    vy = lanes_expand(lists->reachable_searching_vy + taken, idle, vy);
                    vz = lanes_expand(lists->reachable_searching_vz + taken, idle, vz);
                    x = lanes_expand(lists->reachable_searching_x + taken, idle, x);
                    y = lanes_expand(lists->reachable_searching_y + taken, idle, y);
                    z = lanes_expand(lists->reachable_searching_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->reachable_searching_p_ball_radius + taken, idle, p_ball_radius);
                        p_board_bottom = lanes_expand(lists->reachable_searching_p_board_bottom + taken, idle, p_board_bottom);
                        p_board_distance = lanes_expand(lists->reachable_searching_p_board_distance + taken, idle, p_board_distance);
                        p_board_half_width = lanes_expand(lists->reachable_searching_p_board_half_width + taken, idle, p_board_half_width);
                        p_board_thickness = lanes_expand(lists->reachable_searching_p_board_thickness + taken, idle, p_board_thickness);
                        p_board_top = lanes_expand(lists->reachable_searching_p_board_top + taken, idle, p_board_top);
                        p_gravity = lanes_expand(lists->reachable_searching_p_gravity + taken, idle, p_gravity);
                    }
                    const size_t room = LANES_WIDTH - busy, left = reachable_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o95 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o95.leaving;
                V margin = _o95.margin;
                const LANES(court_backboard_advance_out) _o96 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V gap = _o96.gap;
                V rate = _o96.rate;
                V bend = _o96.bend;
                V step = _o96.step;
                V next = _o96.next;
                V clearance = _o96.clearance;
                const LANES(court_struck_or_still_out) _o97 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o97.hit;
                M sure = _o97.sure;
                M vague = _o97.vague;
                const M _m98 = lanes_both(active, vague);
                if (lanes_any(_m98)) {
                    const LANES(court_finer_out) _o99 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m98, _o99.share, share);
                    const LANES(court_allowance_out) _o100 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o100.position_level;
                    V velocity_level = _o100.velocity_level;
                    V excess = _o100.excess;
                    const LANES(court_backboard_margins_out) _o101 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                    flat = lanes_select(_m98, _o101.margin, flat);
                    tilt = lanes_select(_m98, _o101.leaving_margin, tilt);
                    rate_slack = lanes_select(_m98, _o101.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o102 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m98, _o102.doubt, doubt);
                }
                const LANES(court_advanced_out) _o103 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o103.arrival;
                certain = _o103.certain;
                M exhausted = _o103.exhausted;
                searching = _o103.searching;
                t = _o103.t;
                const M _m104 = lanes_both(active, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o105 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m104, _o105.t, t);
                    end = lanes_select(_m104, _o105.end, end);
                    searching = lanes_choose(_m104, _o105.searching, searching);
                }
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(searching, lanes_less(turns, K(201.0)))));
                if (lanes_any(ended)) {
                    double ended_row[LANES_WIDTH];
                    lanes_store(ended_row, row);
                    double ended_arrival[LANES_WIDTH];
                    lanes_store(ended_arrival, arrival);
                    double ended_certain[LANES_WIDTH];
                    lanes_store(ended_certain, lanes_select(certain, K(1.0), K(0.0)));
                    double ended_doubt[LANES_WIDTH];
                    lanes_store(ended_doubt, doubt);
                    double ended_flat[LANES_WIDTH];
                    lanes_store(ended_flat, flat);
                    double ended_searching[LANES_WIDTH];
                    lanes_store(ended_searching, lanes_select(searching, K(1.0), K(0.0)));
                    double ended_t[LANES_WIDTH];
                    lanes_store(ended_t, t);
                    double ended_tilt[LANES_WIDTH];
                    lanes_store(ended_tilt, tilt);
                    for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                        const int lane = LANES_LOWEST(bits);
                        const size_t k = (size_t)ended_row[lane];
                        lists->reachable_arrival[k] = ended_arrival[lane];
                        lists->reachable_certain[k] = ended_certain[lane];
                        lists->reachable_doubt[k] = ended_doubt[lane];
                        lists->reachable_flat[k] = ended_flat[lane];
                        lists->reachable_searching[k] = ended_searching[lane];
                        lists->reachable_t[k] = ended_t[lane];
                        lists->reachable_tilt[k] = ended_tilt[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        {
        size_t reachable_refining_shots = 0;
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(reachable_shots - i);
            V arrival = lanes_load(lists->reachable_arrival + i);
            V ceiling = lanes_load(lists->reachable_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->reachable_certain + i));
            V doubt = lanes_load(lists->reachable_doubt + i);
            V flat = lanes_load(lists->reachable_flat + i);
            V last = lanes_load(lists->reachable_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_bottom = lanes_load(varying ? lists->reachable_p_board_bottom + i : lists->p_board_bottom);
            const V p_board_distance = lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance);
            const V p_board_half_width = lanes_load(varying ? lists->reachable_p_board_half_width + i : lists->p_board_half_width);
            const V p_board_thickness = lanes_load(varying ? lists->reachable_p_board_thickness + i : lists->p_board_thickness);
            const V p_board_top = lanes_load(varying ? lists->reachable_p_board_top + i : lists->p_board_top);
            const V p_gravity = lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity);
            M searching = lanes_less(K(0.0), lanes_load(lists->reachable_searching + i));
            V t = lanes_load(lists->reachable_t + i);
            V tilt = lanes_load(lists->reachable_tilt + i);
            V vx = lanes_load(lists->reachable_vx + i);
            V vy = lanes_load(lists->reachable_vy + i);
            V vz = lanes_load(lists->reachable_vz + i);
            V x = lanes_load(lists->reachable_x + i);
            V y = lanes_load(lists->reachable_y + i);
            V z = lanes_load(lists->reachable_z + i);
            const LANES(court_questioned_out) _o106 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o106.doubt;
            const LANES(court_found_out) _o107 =
                LANES(court_found)(arrival);
            M arrives = _o107.arrives;
            M refining = _o107.refining;
            V rate = _o107.rate;
            const LANES(court_nearby_out) _o108 =
                LANES(court_nearby)(flat, K(1.0), last, arrival, tilt);
            V leaving = _o108.leaving;
            const M _m109 = lanes_both(rows, refining);
            if (lanes_any(_m109)) {
                const LANES(court_backboard_refine_out) _o110 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V refined = _o110.time;
                V gap = _o110.gap;
                rate = lanes_select(_m109, _o110.rate, rate);
                const LANES(court_polished_out) _o111 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m109, _o111.arrival, arrival);
                refining = lanes_choose(_m109, _o111.refining, refining);
            }
            const M _m112 = lanes_both(rows, refining);
            if (lanes_any(_m112)) {
                const LANES(court_backboard_refine_out) _o113 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V refined = _o113.time;
                V gap = _o113.gap;
                rate = lanes_select(_m112, _o113.rate, rate);
                const LANES(court_polished_out) _o114 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m112, _o114.arrival, arrival);
                refining = lanes_choose(_m112, _o114.refining, refining);
            }
            lanes_store(lists->reachable_arrival + i, arrival);
            lanes_store(lists->reachable_arrives + i, lanes_select(arrives, K(1.0), K(0.0)));
            lanes_store(lists->reachable_doubt + i, doubt);
            lanes_store(lists->reachable_leaving + i, leaving);
            lanes_store(lists->reachable_rate + i, rate);
            const M packed = lanes_both(rows, refining);
            if (lanes_any(packed)) {
                lanes_pack(lists->reachable_refining_row + reachable_refining_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->reachable_refining_arrival + reachable_refining_shots, packed, arrival);
                lanes_pack(lists->reachable_refining_ceiling + reachable_refining_shots, packed, ceiling);
                lanes_pack(lists->reachable_refining_certain + reachable_refining_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->reachable_refining_leaving + reachable_refining_shots, packed, leaving);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_ball_radius + reachable_refining_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_board_bottom + reachable_refining_shots, packed, p_board_bottom);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_board_distance + reachable_refining_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_board_half_width + reachable_refining_shots, packed, p_board_half_width);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_board_thickness + reachable_refining_shots, packed, p_board_thickness);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_board_top + reachable_refining_shots, packed, p_board_top);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_gravity + reachable_refining_shots, packed, p_gravity);
                lanes_pack(lists->reachable_refining_vx + reachable_refining_shots, packed, vx);
                lanes_pack(lists->reachable_refining_vy + reachable_refining_shots, packed, vy);
                lanes_pack(lists->reachable_refining_vz + reachable_refining_shots, packed, vz);
                lanes_pack(lists->reachable_refining_x + reachable_refining_shots, packed, x);
                lanes_pack(lists->reachable_refining_y + reachable_refining_shots, packed, y);
                lanes_pack(lists->reachable_refining_z + reachable_refining_shots, packed, z);
                reachable_refining_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
            V p_ball_radius = lanes_load(lists->p_ball_radius);
            V p_board_bottom = lanes_load(lists->p_board_bottom);
            V p_board_distance = lanes_load(lists->p_board_distance);
            V p_board_half_width = lanes_load(lists->p_board_half_width);
            V p_board_thickness = lanes_load(lists->p_board_thickness);
            V p_board_top = lanes_load(lists->p_board_top);
            V p_gravity = lanes_load(lists->p_gravity);
            V arrival = K(0.0);
            V ceiling = K(0.0);
            M certain = lanes_nowhere();
            V leaving = K(0.0);
            V vx = K(0.0);
            V vy = K(0.0);
            V vz = K(0.0);
            V x = K(0.0);
            V y = K(0.0);
            V z = K(0.0);
            for (;;) {
                if (taken < reachable_refining_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->reachable_refining_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->reachable_refining_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->reachable_refining_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->reachable_refining_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    leaving = lanes_expand(lists->reachable_refining_leaving + taken, idle, leaving);
                    vx = lanes_expand(lists->reachable_refining_vx + taken, idle, vx);
                    vy = lanes_expand(lists->reachable_refining_vy + taken, idle, vy);
                    vz = lanes_expand(lists->reachable_refining_vz + taken, idle, vz);
                    x = lanes_expand(lists->reachable_refining_x + taken, idle, x);
                    y = lanes_expand(lists->reachable_refining_y + taken, idle, y);
                    z = lanes_expand(lists->reachable_refining_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->reachable_refining_p_ball_radius + taken, idle, p_ball_radius);
                        p_board_bottom = lanes_expand(lists->reachable_refining_p_board_bottom + taken, idle, p_board_bottom);
                        p_board_distance = lanes_expand(lists->reachable_refining_p_board_distance + taken, idle, p_board_distance);
                        p_board_half_width = lanes_expand(lists->reachable_refining_p_board_half_width + taken, idle, p_board_half_width);
                        p_board_thickness = lanes_expand(lists->reachable_refining_p_board_thickness + taken, idle, p_board_thickness);
                        p_board_top = lanes_expand(lists->reachable_refining_p_board_top + taken, idle, p_board_top);
                        p_gravity = lanes_expand(lists->reachable_refining_p_gravity + taken, idle, p_gravity);
                    }
                    const size_t room = LANES_WIDTH - busy, left = reachable_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_backboard_refine_out) _o115 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V refined = _o115.time;
                V gap = _o115.gap;
                V rate = _o115.rate;
                const LANES(court_polished_out) _o116 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o116.arrival;
                refining = _o116.refining;
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(refining, lanes_less(turns, K(8.0)))));
                if (lanes_any(ended)) {
                    double ended_row[LANES_WIDTH];
                    lanes_store(ended_row, row);
                    double ended_arrival[LANES_WIDTH];
                    lanes_store(ended_arrival, arrival);
                    double ended_rate[LANES_WIDTH];
                    lanes_store(ended_rate, rate);
                    for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                        const int lane = LANES_LOWEST(bits);
                        const size_t k = (size_t)ended_row[lane];
                        lists->reachable_arrival[k] = ended_arrival[lane];
                        lists->reachable_rate[k] = ended_rate[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            V arrival = lanes_load(lists->reachable_arrival + i);
            M arrives = lanes_less(K(0.0), lanes_load(lists->reachable_arrives + i));
            V ceiling = lanes_load(lists->reachable_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->reachable_certain + i));
            V doubt = lanes_load(lists->reachable_doubt + i);
            V extent = lanes_load(lists->reachable_extent + i);
            V late = lanes_load(lists->reachable_late + i);
            V latest = lanes_load(lists->reachable_latest + i);
            V leaving = lanes_load(lists->reachable_leaving + i);
            const V p_ball_radius = lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_bottom = lanes_load(varying ? lists->reachable_p_board_bottom + i : lists->p_board_bottom);
            const V p_board_distance = lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance);
            const V p_board_half_width = lanes_load(varying ? lists->reachable_p_board_half_width + i : lists->p_board_half_width);
            const V p_board_thickness = lanes_load(varying ? lists->reachable_p_board_thickness + i : lists->p_board_thickness);
            const V p_board_top = lanes_load(varying ? lists->reachable_p_board_top + i : lists->p_board_top);
            const V p_gravity = lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity);
            V position_error = lanes_load(lists->reachable_position_error + i);
            V rate = lanes_load(lists->reachable_rate + i);
            V speed = lanes_load(lists->reachable_speed + i);
            V velocity_error = lanes_load(lists->reachable_velocity_error + i);
            V when = lanes_load(lists->reachable_when + i);
            V which = lanes_load(lists->reachable_which + i);
            const LANES(court_backboard_margins_out) _o117 =
                LANES(court_backboard_margins)(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V flat = _o117.margin;
            V tilt = _o117.leaving_margin;
            V rate_margin = _o117.rate_margin;
            const LANES(court_own_margin_out) _o118 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o118.margin;
            const LANES(court_crossing_out) _o119 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o119.clearance;
            V delay = _o119.delay;
            const LANES(court_landed_out) _o120 =
                LANES(court_landed)(arrival);
            V time = _o120.time;
            const LANES(court_landed_surely_out) _o121 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o121.delay;
            doubt = _o121.doubt;
            const LANES(court_tied_out) _o122 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o122.doubt;
            late = _o122.late;
            const LANES(court_sooner_out) _o123 =
                LANES(court_sooner)(arrives, K(1.0), time, when, which);
            when = _o123.when;
            which = _o123.which;
            lanes_store(lists->reachable_doubt + i, doubt);
            lanes_store(lists->reachable_late + i, late);
            lanes_store(lists->reachable_when + i, when);
            lanes_store(lists->reachable_which + i, which);
        }
        for (size_t k = 0; k < reachable_shots; k++) {
            const size_t row = (size_t)lists->reachable_row[k];
            lists->doubt[row] = lists->reachable_doubt[k];
            lists->late[row] = lists->reachable_late[k];
            lists->when[row] = lists->reachable_when[k];
            lists->which[row] = lists->reachable_which[k];
        }
        }
        {
        size_t reachable_shots = 0;
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            V doubt = lanes_load(lists->doubt + i);
            V extent = lanes_load(lists->extent + i);
            M kept = lanes_less(K(0.0), lanes_load(lists->kept + i));
            V last = lanes_load(lists->last + i);
            V late = lanes_load(lists->late + i);
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_bridge_depth = lanes_load(lists->p_bridge_depth + (i & varying));
            const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
            const V p_wire_radius = lanes_load(lists->p_wire_radius + (i & varying));
            V position_error = lanes_load(lists->position_error + i);
            V speed = lanes_load(lists->speed + i);
            V velocity_error = lanes_load(lists->velocity_error + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V when = lanes_load(lists->when + i);
            V which = lanes_load(lists->which + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const LANES(court_horizon_out) _o124 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o124.horizon;
            V pad = _o124.pad;
            const LANES(court_halved_out) _o125 =
                LANES(court_halved)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, late, pad, p_gravity);
            V middle_x = _o125.middle_x;
            V reach_x = _o125.reach_x;
            V later_middle_x = _o125.later_middle_x;
            V later_reach_x = _o125.later_reach_x;
            V middle_y = _o125.middle_y;
            V reach_y = _o125.reach_y;
            V later_middle_y = _o125.later_middle_y;
            V later_reach_y = _o125.later_reach_y;
            V middle_z = _o125.middle_z;
            V reach_z = _o125.reach_z;
            V later_middle_z = _o125.later_middle_z;
            V later_reach_z = _o125.later_reach_z;
            const LANES(court_bridge_near_out) _o126 =
                LANES(court_bridge_near)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, later_middle_x, later_middle_y, later_middle_z, later_reach_x, later_reach_y, later_reach_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
            M reachable = _o126.near;
            const LANES(court_reachable_in_flight_out) _o127 =
                LANES(court_reachable_in_flight)(kept, reachable);
            reachable = _o127.reachable;
            const M packed = lanes_both(rows, reachable);
            if (lanes_any(packed)) {
                lanes_pack(lists->reachable_row + reachable_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->reachable_doubt + reachable_shots, packed, doubt);
                lanes_pack(lists->reachable_extent + reachable_shots, packed, extent);
                lanes_pack(lists->reachable_last + reachable_shots, packed, last);
                lanes_pack(lists->reachable_late + reachable_shots, packed, late);
                if (varying)
                    lanes_pack(lists->reachable_p_ball_radius + reachable_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->reachable_p_board_distance + reachable_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->reachable_p_bridge_depth + reachable_shots, packed, p_bridge_depth);
                if (varying)
                    lanes_pack(lists->reachable_p_bridge_half_width + reachable_shots, packed, p_bridge_half_width);
                if (varying)
                    lanes_pack(lists->reachable_p_gravity + reachable_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->reachable_p_ring_radius + reachable_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->reachable_p_wire_radius + reachable_shots, packed, p_wire_radius);
                lanes_pack(lists->reachable_position_error + reachable_shots, packed, position_error);
                lanes_pack(lists->reachable_speed + reachable_shots, packed, speed);
                lanes_pack(lists->reachable_velocity_error + reachable_shots, packed, velocity_error);
                lanes_pack(lists->reachable_vx + reachable_shots, packed, vx);
                lanes_pack(lists->reachable_vy + reachable_shots, packed, vy);
                lanes_pack(lists->reachable_vz + reachable_shots, packed, vz);
                lanes_pack(lists->reachable_when + reachable_shots, packed, when);
                lanes_pack(lists->reachable_which + reachable_shots, packed, which);
                lanes_pack(lists->reachable_x + reachable_shots, packed, x);
                lanes_pack(lists->reachable_y + reachable_shots, packed, y);
                lanes_pack(lists->reachable_z + reachable_shots, packed, z);
                reachable_shots += lanes_many(packed);
            }
        }
        {
        size_t reachable_searching_shots = 0;
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(reachable_shots - i);
            V doubt = lanes_load(lists->reachable_doubt + i);
            V extent = lanes_load(lists->reachable_extent + i);
            V last = lanes_load(lists->reachable_last + i);
            V late = lanes_load(lists->reachable_late + i);
            const V p_ball_radius = lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_distance = lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance);
            const V p_bridge_depth = lanes_load(varying ? lists->reachable_p_bridge_depth + i : lists->p_bridge_depth);
            const V p_bridge_half_width = lanes_load(varying ? lists->reachable_p_bridge_half_width + i : lists->p_bridge_half_width);
            const V p_gravity = lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->reachable_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->reachable_p_wire_radius + i : lists->p_wire_radius);
            V position_error = lanes_load(lists->reachable_position_error + i);
            V speed = lanes_load(lists->reachable_speed + i);
            V velocity_error = lanes_load(lists->reachable_velocity_error + i);
            V vx = lanes_load(lists->reachable_vx + i);
            V vy = lanes_load(lists->reachable_vy + i);
            V vz = lanes_load(lists->reachable_vz + i);
            V when = lanes_load(lists->reachable_when + i);
            V x = lanes_load(lists->reachable_x + i);
            V y = lanes_load(lists->reachable_y + i);
            V z = lanes_load(lists->reachable_z + i);
            const LANES(court_horizon_out) _o128 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o128.horizon;
            V pad = _o128.pad;
            const LANES(court_bridge_prepare_out) _o129 =
                LANES(court_bridge_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V low0 = _o129.low0;
            V high0 = _o129.high0;
            V low1 = _o129.low1;
            V high1 = _o129.high1;
            V ceiling = _o129.ceiling;
            V latest = _o129.latest;
            V lost = _o129.lost;
            const LANES(court_beginning_out) _o130 =
                LANES(court_beginning)();
            V share = _o130.share;
            V arrival = _o130.arrival;
            M certain = _o130.certain;
            const LANES(court_allowance_out) _o131 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
            V position_level = _o131.position_level;
            V velocity_level = _o131.velocity_level;
            V excess = _o131.excess;
            const LANES(court_bridge_margins_out) _o132 =
                LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V flat = _o132.margin;
            V tilt = _o132.leaving_margin;
            V rate_slack = _o132.rate_margin;
            const LANES(court_bridge_enter_out) _o133 =
                LANES(court_bridge_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o133.t;
            V end = _o133.end;
            M searching = _o133.searching;
            const LANES(court_beyond_windows_out) _o134 =
                LANES(court_beyond_windows)(doubt, excess, late, lost, pad, searching);
            doubt = _o134.doubt;
            const M _m135 = lanes_both(rows, searching);
            if (lanes_any(_m135)) {
                const LANES(court_nearby_out) _o136 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o136.leaving;
                V margin = _o136.margin;
                const LANES(court_bridge_advance_out) _o137 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V gap = _o137.gap;
                V rate = _o137.rate;
                V bend = _o137.bend;
                V step = _o137.step;
                V next = _o137.next;
                V clearance = _o137.clearance;
                const LANES(court_struck_or_still_out) _o138 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o138.hit;
                M sure = _o138.sure;
                M vague = _o138.vague;
                const M _m139 = lanes_both(_m135, vague);
                if (lanes_any(_m139)) {
                    const LANES(court_finer_out) _o140 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m139, _o140.share, share);
                    const LANES(court_allowance_out) _o141 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o141.position_level;
                    V velocity_level = _o141.velocity_level;
                    V excess = _o141.excess;
                    const LANES(court_bridge_margins_out) _o142 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                    flat = lanes_select(_m139, _o142.margin, flat);
                    tilt = lanes_select(_m139, _o142.leaving_margin, tilt);
                    rate_slack = lanes_select(_m139, _o142.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o143 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m139, _o143.doubt, doubt);
                }
                const LANES(court_advanced_out) _o144 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = lanes_select(_m135, _o144.arrival, arrival);
                certain = lanes_choose(_m135, _o144.certain, certain);
                M exhausted = _o144.exhausted;
                searching = lanes_choose(_m135, _o144.searching, searching);
                t = lanes_select(_m135, _o144.t, t);
                const M _m145 = lanes_both(_m135, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o146 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m145, _o146.t, t);
                    end = lanes_select(_m145, _o146.end, end);
                    searching = lanes_choose(_m145, _o146.searching, searching);
                }
            }
            lanes_store(lists->reachable_arrival + i, arrival);
            lanes_store(lists->reachable_ceiling + i, ceiling);
            lanes_store(lists->reachable_certain + i, lanes_select(certain, K(1.0), K(0.0)));
            lanes_store(lists->reachable_doubt + i, doubt);
            lanes_store(lists->reachable_flat + i, flat);
            lanes_store(lists->reachable_latest + i, latest);
            lanes_store(lists->reachable_searching + i, lanes_select(searching, K(1.0), K(0.0)));
            lanes_store(lists->reachable_t + i, t);
            lanes_store(lists->reachable_tilt + i, tilt);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->reachable_searching_row + reachable_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->reachable_searching_arrival + reachable_searching_shots, packed, arrival);
                lanes_pack(lists->reachable_searching_ceiling + reachable_searching_shots, packed, ceiling);
                lanes_pack(lists->reachable_searching_certain + reachable_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->reachable_searching_doubt + reachable_searching_shots, packed, doubt);
                lanes_pack(lists->reachable_searching_end + reachable_searching_shots, packed, end);
                lanes_pack(lists->reachable_searching_extent + reachable_searching_shots, packed, extent);
                lanes_pack(lists->reachable_searching_flat + reachable_searching_shots, packed, flat);
                lanes_pack(lists->reachable_searching_high0 + reachable_searching_shots, packed, high0);
                lanes_pack(lists->reachable_searching_high1 + reachable_searching_shots, packed, high1);
                lanes_pack(lists->reachable_searching_last + reachable_searching_shots, packed, last);
                lanes_pack(lists->reachable_searching_latest + reachable_searching_shots, packed, latest);
                lanes_pack(lists->reachable_searching_low0 + reachable_searching_shots, packed, low0);
                lanes_pack(lists->reachable_searching_low1 + reachable_searching_shots, packed, low1);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_ball_radius + reachable_searching_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_board_distance + reachable_searching_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_bridge_depth + reachable_searching_shots, packed, p_bridge_depth);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_bridge_half_width + reachable_searching_shots, packed, p_bridge_half_width);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_gravity + reachable_searching_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_ring_radius + reachable_searching_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->reachable_searching_p_wire_radius + reachable_searching_shots, packed, p_wire_radius);
                lanes_pack(lists->reachable_searching_position_error + reachable_searching_shots, packed, position_error);
                lanes_pack(lists->reachable_searching_rate_slack + reachable_searching_shots, packed, rate_slack);
                lanes_pack(lists->reachable_searching_share + reachable_searching_shots, packed, share);
                lanes_pack(lists->reachable_searching_speed + reachable_searching_shots, packed, speed);
                lanes_pack(lists->reachable_searching_t + reachable_searching_shots, packed, t);
                lanes_pack(lists->reachable_searching_tilt + reachable_searching_shots, packed, tilt);
                lanes_pack(lists->reachable_searching_velocity_error + reachable_searching_shots, packed, velocity_error);
                lanes_pack(lists->reachable_searching_vx + reachable_searching_shots, packed, vx);
                lanes_pack(lists->reachable_searching_vy + reachable_searching_shots, packed, vy);
                lanes_pack(lists->reachable_searching_vz + reachable_searching_shots, packed, vz);
                lanes_pack(lists->reachable_searching_x + reachable_searching_shots, packed, x);
                lanes_pack(lists->reachable_searching_y + reachable_searching_shots, packed, y);
                lanes_pack(lists->reachable_searching_z + reachable_searching_shots, packed, z);
                reachable_searching_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
            V p_ball_radius = lanes_load(lists->p_ball_radius);
            V p_board_distance = lanes_load(lists->p_board_distance);
            V p_bridge_depth = lanes_load(lists->p_bridge_depth);
            V p_bridge_half_width = lanes_load(lists->p_bridge_half_width);
            V p_gravity = lanes_load(lists->p_gravity);
            V p_ring_radius = lanes_load(lists->p_ring_radius);
            V p_wire_radius = lanes_load(lists->p_wire_radius);
            V arrival = K(0.0);
            V ceiling = K(0.0);
            M certain = lanes_nowhere();
            V doubt = K(0.0);
            V end = K(0.0);
            V extent = K(0.0);
            V flat = K(0.0);
            V high0 = K(0.0);
            V high1 = K(0.0);
            V last = K(0.0);
            V latest = K(0.0);
            V low0 = K(0.0);
            V low1 = K(0.0);
            V position_error = K(0.0);
            V rate_slack = K(0.0);
            V share = K(0.0);
            V speed = K(0.0);
            V t = K(0.0);
            V tilt = K(0.0);
            V velocity_error = K(0.0);
            V vx = K(0.0);
            V vy = K(0.0);
            V vz = K(0.0);
            V x = K(0.0);
            V y = K(0.0);
            V z = K(0.0);
            for (;;) {
                if (taken < reachable_searching_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->reachable_searching_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->reachable_searching_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->reachable_searching_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->reachable_searching_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    doubt = lanes_expand(lists->reachable_searching_doubt + taken, idle, doubt);
                    end = lanes_expand(lists->reachable_searching_end + taken, idle, end);
                    extent = lanes_expand(lists->reachable_searching_extent + taken, idle, extent);
                    flat = lanes_expand(lists->reachable_searching_flat + taken, idle, flat);
                    high0 = lanes_expand(lists->reachable_searching_high0 + taken, idle, high0);
                    high1 = lanes_expand(lists->reachable_searching_high1 + taken, idle, high1);
                    last = lanes_expand(lists->reachable_searching_last + taken, idle, last);
                    latest = lanes_expand(lists->reachable_searching_latest + taken, idle, latest);
                    low0 = lanes_expand(lists->reachable_searching_low0 + taken, idle, low0);
                    low1 = lanes_expand(lists->reachable_searching_low1 + taken, idle, low1);
                    position_error = lanes_expand(lists->reachable_searching_position_error + taken, idle, position_error);
                    rate_slack = lanes_expand(lists->reachable_searching_rate_slack + taken, idle, rate_slack);
                    share = lanes_expand(lists->reachable_searching_share + taken, idle, share);
                    speed = lanes_expand(lists->reachable_searching_speed + taken, idle, speed);
                    t = lanes_expand(lists->reachable_searching_t + taken, idle, t);
                    tilt = lanes_expand(lists->reachable_searching_tilt + taken, idle, tilt);
                    velocity_error = lanes_expand(lists->reachable_searching_velocity_error + taken, idle, velocity_error);
                    vx = lanes_expand(lists->reachable_searching_vx + taken, idle, vx);
                    vy = lanes_expand(lists->reachable_searching_vy + taken, idle, vy);
                    vz = lanes_expand(lists->reachable_searching_vz + taken, idle, vz);
                    x = lanes_expand(lists->reachable_searching_x + taken, idle, x);
                    y = lanes_expand(lists->reachable_searching_y + taken, idle, y);
                    z = lanes_expand(lists->reachable_searching_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->reachable_searching_p_ball_radius + taken, idle, p_ball_radius);
                        p_board_distance = lanes_expand(lists->reachable_searching_p_board_distance + taken, idle, p_board_distance);
                        p_bridge_depth = lanes_expand(lists->reachable_searching_p_bridge_depth + taken, idle, p_bridge_depth);
                        p_bridge_half_width = lanes_expand(lists->reachable_searching_p_bridge_half_width + taken, idle, p_bridge_half_width);
                        p_gravity = lanes_expand(lists->reachable_searching_p_gravity + taken, idle, p_gravity);
                        p_ring_radius = lanes_expand(lists->reachable_searching_p_ring_radius + taken, idle, p_ring_radius);
                        p_wire_radius = lanes_expand(lists->reachable_searching_p_wire_radius + taken, idle, p_wire_radius);
                    }
                    const size_t room = LANES_WIDTH - busy, left = reachable_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o147 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o147.leaving;
                V margin = _o147.margin;
                const LANES(court_bridge_advance_out) _o148 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V gap = _o148.gap;
                V rate = _o148.rate;
                V bend = _o148.bend;
                V step = _o148.step;
                V next = _o148.next;
                V clearance = _o148.clearance;
                const LANES(court_struck_or_still_out) _o149 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o149.hit;
                M sure = _o149.sure;
                M vague = _o149.vague;
                const M _m150 = lanes_both(active, vague);
                if (lanes_any(_m150)) {
                    const LANES(court_finer_out) _o151 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m150, _o151.share, share);
                    const LANES(court_allowance_out) _o152 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o152.position_level;
                    V velocity_level = _o152.velocity_level;
                    V excess = _o152.excess;
                    const LANES(court_bridge_margins_out) _o153 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                    flat = lanes_select(_m150, _o153.margin, flat);
                    tilt = lanes_select(_m150, _o153.leaving_margin, tilt);
                    rate_slack = lanes_select(_m150, _o153.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o154 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m150, _o154.doubt, doubt);
                }
                const LANES(court_advanced_out) _o155 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o155.arrival;
                certain = _o155.certain;
                M exhausted = _o155.exhausted;
                searching = _o155.searching;
                t = _o155.t;
                const M _m156 = lanes_both(active, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o157 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m156, _o157.t, t);
                    end = lanes_select(_m156, _o157.end, end);
                    searching = lanes_choose(_m156, _o157.searching, searching);
                }
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(searching, lanes_less(turns, K(201.0)))));
                if (lanes_any(ended)) {
                    double ended_row[LANES_WIDTH];
                    lanes_store(ended_row, row);
                    double ended_arrival[LANES_WIDTH];
                    lanes_store(ended_arrival, arrival);
                    double ended_certain[LANES_WIDTH];
                    lanes_store(ended_certain, lanes_select(certain, K(1.0), K(0.0)));
                    double ended_doubt[LANES_WIDTH];
                    lanes_store(ended_doubt, doubt);
                    double ended_flat[LANES_WIDTH];
                    lanes_store(ended_flat, flat);
                    double ended_searching[LANES_WIDTH];
                    lanes_store(ended_searching, lanes_select(searching, K(1.0), K(0.0)));
                    double ended_t[LANES_WIDTH];
                    lanes_store(ended_t, t);
                    double ended_tilt[LANES_WIDTH];
                    lanes_store(ended_tilt, tilt);
                    for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                        const int lane = LANES_LOWEST(bits);
                        const size_t k = (size_t)ended_row[lane];
                        lists->reachable_arrival[k] = ended_arrival[lane];
                        lists->reachable_certain[k] = ended_certain[lane];
                        lists->reachable_doubt[k] = ended_doubt[lane];
                        lists->reachable_flat[k] = ended_flat[lane];
                        lists->reachable_searching[k] = ended_searching[lane];
                        lists->reachable_t[k] = ended_t[lane];
                        lists->reachable_tilt[k] = ended_tilt[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        {
        size_t reachable_refining_shots = 0;
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(reachable_shots - i);
            V arrival = lanes_load(lists->reachable_arrival + i);
            V ceiling = lanes_load(lists->reachable_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->reachable_certain + i));
            V doubt = lanes_load(lists->reachable_doubt + i);
            V flat = lanes_load(lists->reachable_flat + i);
            V last = lanes_load(lists->reachable_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_distance = lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance);
            const V p_bridge_depth = lanes_load(varying ? lists->reachable_p_bridge_depth + i : lists->p_bridge_depth);
            const V p_bridge_half_width = lanes_load(varying ? lists->reachable_p_bridge_half_width + i : lists->p_bridge_half_width);
            const V p_gravity = lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->reachable_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->reachable_p_wire_radius + i : lists->p_wire_radius);
            M searching = lanes_less(K(0.0), lanes_load(lists->reachable_searching + i));
            V t = lanes_load(lists->reachable_t + i);
            V tilt = lanes_load(lists->reachable_tilt + i);
            V vx = lanes_load(lists->reachable_vx + i);
            V vy = lanes_load(lists->reachable_vy + i);
            V vz = lanes_load(lists->reachable_vz + i);
            V x = lanes_load(lists->reachable_x + i);
            V y = lanes_load(lists->reachable_y + i);
            V z = lanes_load(lists->reachable_z + i);
            const LANES(court_questioned_out) _o158 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o158.doubt;
            const LANES(court_found_out) _o159 =
                LANES(court_found)(arrival);
            M arrives = _o159.arrives;
            M refining = _o159.refining;
            V rate = _o159.rate;
            const LANES(court_nearby_out) _o160 =
                LANES(court_nearby)(flat, K(2.0), last, arrival, tilt);
            V leaving = _o160.leaving;
            const M _m161 = lanes_both(rows, refining);
            if (lanes_any(_m161)) {
                const LANES(court_bridge_refine_out) _o162 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V refined = _o162.time;
                V gap = _o162.gap;
                rate = lanes_select(_m161, _o162.rate, rate);
                const LANES(court_polished_out) _o163 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m161, _o163.arrival, arrival);
                refining = lanes_choose(_m161, _o163.refining, refining);
            }
            const M _m164 = lanes_both(rows, refining);
            if (lanes_any(_m164)) {
                const LANES(court_bridge_refine_out) _o165 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V refined = _o165.time;
                V gap = _o165.gap;
                rate = lanes_select(_m164, _o165.rate, rate);
                const LANES(court_polished_out) _o166 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m164, _o166.arrival, arrival);
                refining = lanes_choose(_m164, _o166.refining, refining);
            }
            lanes_store(lists->reachable_arrival + i, arrival);
            lanes_store(lists->reachable_arrives + i, lanes_select(arrives, K(1.0), K(0.0)));
            lanes_store(lists->reachable_doubt + i, doubt);
            lanes_store(lists->reachable_leaving + i, leaving);
            lanes_store(lists->reachable_rate + i, rate);
            const M packed = lanes_both(rows, refining);
            if (lanes_any(packed)) {
                lanes_pack(lists->reachable_refining_row + reachable_refining_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->reachable_refining_arrival + reachable_refining_shots, packed, arrival);
                lanes_pack(lists->reachable_refining_ceiling + reachable_refining_shots, packed, ceiling);
                lanes_pack(lists->reachable_refining_certain + reachable_refining_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->reachable_refining_leaving + reachable_refining_shots, packed, leaving);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_ball_radius + reachable_refining_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_board_distance + reachable_refining_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_bridge_depth + reachable_refining_shots, packed, p_bridge_depth);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_bridge_half_width + reachable_refining_shots, packed, p_bridge_half_width);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_gravity + reachable_refining_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_ring_radius + reachable_refining_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->reachable_refining_p_wire_radius + reachable_refining_shots, packed, p_wire_radius);
                lanes_pack(lists->reachable_refining_vx + reachable_refining_shots, packed, vx);
                lanes_pack(lists->reachable_refining_vy + reachable_refining_shots, packed, vy);
                lanes_pack(lists->reachable_refining_vz + reachable_refining_shots, packed, vz);
                lanes_pack(lists->reachable_refining_x + reachable_refining_shots, packed, x);
                lanes_pack(lists->reachable_refining_y + reachable_refining_shots, packed, y);
                lanes_pack(lists->reachable_refining_z + reachable_refining_shots, packed, z);
                reachable_refining_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
            V p_ball_radius = lanes_load(lists->p_ball_radius);
            V p_board_distance = lanes_load(lists->p_board_distance);
            V p_bridge_depth = lanes_load(lists->p_bridge_depth);
            V p_bridge_half_width = lanes_load(lists->p_bridge_half_width);
            V p_gravity = lanes_load(lists->p_gravity);
            V p_ring_radius = lanes_load(lists->p_ring_radius);
            V p_wire_radius = lanes_load(lists->p_wire_radius);
            V arrival = K(0.0);
            V ceiling = K(0.0);
            M certain = lanes_nowhere();
            V leaving = K(0.0);
            V vx = K(0.0);
            V vy = K(0.0);
            V vz = K(0.0);
            V x = K(0.0);
            V y = K(0.0);
            V z = K(0.0);
            for (;;) {
                if (taken < reachable_refining_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->reachable_refining_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->reachable_refining_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->reachable_refining_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->reachable_refining_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    leaving = lanes_expand(lists->reachable_refining_leaving + taken, idle, leaving);
                    vx = lanes_expand(lists->reachable_refining_vx + taken, idle, vx);
                    vy = lanes_expand(lists->reachable_refining_vy + taken, idle, vy);
                    vz = lanes_expand(lists->reachable_refining_vz + taken, idle, vz);
                    x = lanes_expand(lists->reachable_refining_x + taken, idle, x);
                    y = lanes_expand(lists->reachable_refining_y + taken, idle, y);
                    z = lanes_expand(lists->reachable_refining_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->reachable_refining_p_ball_radius + taken, idle, p_ball_radius);
                        p_board_distance = lanes_expand(lists->reachable_refining_p_board_distance + taken, idle, p_board_distance);
                        p_bridge_depth = lanes_expand(lists->reachable_refining_p_bridge_depth + taken, idle, p_bridge_depth);
                        p_bridge_half_width = lanes_expand(lists->reachable_refining_p_bridge_half_width + taken, idle, p_bridge_half_width);
                        p_gravity = lanes_expand(lists->reachable_refining_p_gravity + taken, idle, p_gravity);
                        p_ring_radius = lanes_expand(lists->reachable_refining_p_ring_radius + taken, idle, p_ring_radius);
                        p_wire_radius = lanes_expand(lists->reachable_refining_p_wire_radius + taken, idle, p_wire_radius);
                    }
                    const size_t room = LANES_WIDTH - busy, left = reachable_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_bridge_refine_out) _o167 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V refined = _o167.time;
                V gap = _o167.gap;
                V rate = _o167.rate;
                const LANES(court_polished_out) _o168 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o168.arrival;
                refining = _o168.refining;
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(refining, lanes_less(turns, K(8.0)))));
                if (lanes_any(ended)) {
                    double ended_row[LANES_WIDTH];
                    lanes_store(ended_row, row);
                    double ended_arrival[LANES_WIDTH];
                    lanes_store(ended_arrival, arrival);
                    double ended_rate[LANES_WIDTH];
                    lanes_store(ended_rate, rate);
                    for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {
                        const int lane = LANES_LOWEST(bits);
                        const size_t k = (size_t)ended_row[lane];
                        lists->reachable_arrival[k] = ended_arrival[lane];
                        lists->reachable_rate[k] = ended_rate[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            V arrival = lanes_load(lists->reachable_arrival + i);
            M arrives = lanes_less(K(0.0), lanes_load(lists->reachable_arrives + i));
            V ceiling = lanes_load(lists->reachable_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->reachable_certain + i));
            V doubt = lanes_load(lists->reachable_doubt + i);
            V extent = lanes_load(lists->reachable_extent + i);
            V late = lanes_load(lists->reachable_late + i);
            V latest = lanes_load(lists->reachable_latest + i);
            V leaving = lanes_load(lists->reachable_leaving + i);
            const V p_ball_radius = lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_distance = lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance);
            const V p_bridge_depth = lanes_load(varying ? lists->reachable_p_bridge_depth + i : lists->p_bridge_depth);
            const V p_bridge_half_width = lanes_load(varying ? lists->reachable_p_bridge_half_width + i : lists->p_bridge_half_width);
            const V p_gravity = lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->reachable_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->reachable_p_wire_radius + i : lists->p_wire_radius);
            V position_error = lanes_load(lists->reachable_position_error + i);
            V rate = lanes_load(lists->reachable_rate + i);
            V speed = lanes_load(lists->reachable_speed + i);
            V velocity_error = lanes_load(lists->reachable_velocity_error + i);
            V when = lanes_load(lists->reachable_when + i);
            V which = lanes_load(lists->reachable_which + i);
            const LANES(court_bridge_margins_out) _o169 =
                LANES(court_bridge_margins)(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V flat = _o169.margin;
            V tilt = _o169.leaving_margin;
            V rate_margin = _o169.rate_margin;
            const LANES(court_own_margin_out) _o170 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o170.margin;
            const LANES(court_crossing_out) _o171 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o171.clearance;
            V delay = _o171.delay;
            const LANES(court_landed_out) _o172 =
                LANES(court_landed)(arrival);
            V time = _o172.time;
            const LANES(court_landed_surely_out) _o173 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o173.delay;
            doubt = _o173.doubt;
            const LANES(court_tied_out) _o174 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o174.doubt;
            late = _o174.late;
            const LANES(court_sooner_out) _o175 =
                LANES(court_sooner)(arrives, K(2.0), time, when, which);
            when = _o175.when;
            which = _o175.which;
            lanes_store(lists->reachable_doubt + i, doubt);
            lanes_store(lists->reachable_late + i, late);
            lanes_store(lists->reachable_when + i, when);
            lanes_store(lists->reachable_which + i, which);
        }
        for (size_t k = 0; k < reachable_shots; k++) {
            const size_t row = (size_t)lists->reachable_row[k];
            lists->doubt[row] = lists->reachable_doubt[k];
            lists->late[row] = lists->reachable_late[k];
            lists->when[row] = lists->reachable_when[k];
            lists->which[row] = lists->reachable_which[k];
        }
        }
        {
        size_t kept_shots = 0;
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            V circled = lanes_load(lists->circled + i);
            V clock = lanes_load(lists->clock + i);
            V clock_error = lanes_load(lists->clock_error + i);
            V doubt = lanes_load(lists->doubt + i);
            V dvx = lanes_load(lists->dvx + i);
            V dvy = lanes_load(lists->dvy + i);
            V dvz = lanes_load(lists->dvz + i);
            V dwx = lanes_load(lists->dwx + i);
            V dwy = lanes_load(lists->dwy + i);
            V dwz = lanes_load(lists->dwz + i);
            V dx = lanes_load(lists->dx + i);
            V dy = lanes_load(lists->dy + i);
            V dz = lanes_load(lists->dz + i);
            V grip_lost = lanes_load(lists->grip_lost + i);
            V held = lanes_load(lists->held + i);
            M kept = lanes_less(K(0.0), lanes_load(lists->kept + i));
            V late = lanes_load(lists->late + i);
            M limited = lanes_less(K(0.0), lanes_load(lists->limited + i));
            V mode = lanes_load(lists->mode + i);
            const V p_backboard_friction = lanes_load(lists->p_backboard_friction + (i & varying));
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_bottom = lanes_load(lists->p_board_bottom + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_board_half_width = lanes_load(lists->p_board_half_width + (i & varying));
            const V p_board_thickness = lanes_load(lists->p_board_thickness + (i & varying));
            const V p_board_top = lanes_load(lists->p_board_top + (i & varying));
            const V p_bridge_depth = lanes_load(lists->p_bridge_depth + (i & varying));
            const V p_bridge_friction = lanes_load(lists->p_bridge_friction + (i & varying));
            const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + (i & varying));
            const V p_end_depth = lanes_load(lists->p_end_depth + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_ring_friction = lanes_load(lists->p_ring_friction + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
            const V p_wire_radius = lanes_load(lists->p_wire_radius + (i & varying));
            V position_error = lanes_load(lists->position_error + i);
            M rests = lanes_less(K(0.0), lanes_load(lists->rests + i));
            V taut = lanes_load(lists->taut + i);
            V taut_clock = lanes_load(lists->taut_clock + i);
            V taut_rate = lanes_load(lists->taut_rate + i);
            V through = lanes_load(lists->through + i);
            V time_error = lanes_load(lists->time_error + i);
            V velocity_error = lanes_load(lists->velocity_error + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V when = lanes_load(lists->when + i);
            V which = lanes_load(lists->which + i);
            V wx = lanes_load(lists->wx + i);
            V wy = lanes_load(lists->wy + i);
            V wz = lanes_load(lists->wz + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const M _m176 = lanes_both(rows, limited);
            if (lanes_any(_m176)) {
                const LANES(court_expiry_out) _o177 =
                    LANES(court_expiry)(clock, doubt, late, time_error, time_limit, when, which);
                V time = _o177.time;
                V delay = _o177.delay;
                M arrives = _o177.arrives;
                doubt = lanes_select(_m176, _o177.doubt, doubt);
                const LANES(court_tied_out) _o178 =
                    LANES(court_tied)(arrives, delay, doubt, late, time, when);
                doubt = lanes_select(_m176, _o178.doubt, doubt);
                late = lanes_select(_m176, _o178.late, late);
                const LANES(court_sooner_out) _o179 =
                    LANES(court_sooner)(arrives, K(4.0), time, when, which);
                when = lanes_select(_m176, _o179.when, when);
                which = lanes_select(_m176, _o179.which, which);
            }
            lanes_store(lists->doubt + i, doubt);
            lanes_store(lists->late + i, late);
            lanes_store(lists->when + i, when);
            lanes_store(lists->which + i, which);
            const M packed = lanes_both(rows, kept);
            if (lanes_any(packed)) {
                lanes_pack(lists->kept_row + kept_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->kept_circled + kept_shots, packed, circled);
                lanes_pack(lists->kept_clock + kept_shots, packed, clock);
                lanes_pack(lists->kept_clock_error + kept_shots, packed, clock_error);
                lanes_pack(lists->kept_dvx + kept_shots, packed, dvx);
                lanes_pack(lists->kept_dvy + kept_shots, packed, dvy);
                lanes_pack(lists->kept_dvz + kept_shots, packed, dvz);
                lanes_pack(lists->kept_dwx + kept_shots, packed, dwx);
                lanes_pack(lists->kept_dwy + kept_shots, packed, dwy);
                lanes_pack(lists->kept_dwz + kept_shots, packed, dwz);
                lanes_pack(lists->kept_dx + kept_shots, packed, dx);
                lanes_pack(lists->kept_dy + kept_shots, packed, dy);
                lanes_pack(lists->kept_dz + kept_shots, packed, dz);
                lanes_pack(lists->kept_grip_lost + kept_shots, packed, grip_lost);
                lanes_pack(lists->kept_held + kept_shots, packed, held);
                lanes_pack(lists->kept_mode + kept_shots, packed, mode);
                if (varying)
                    lanes_pack(lists->kept_p_backboard_friction + kept_shots, packed, p_backboard_friction);
                if (varying)
                    lanes_pack(lists->kept_p_ball_radius + kept_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->kept_p_board_bottom + kept_shots, packed, p_board_bottom);
                if (varying)
                    lanes_pack(lists->kept_p_board_distance + kept_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->kept_p_board_half_width + kept_shots, packed, p_board_half_width);
                if (varying)
                    lanes_pack(lists->kept_p_board_thickness + kept_shots, packed, p_board_thickness);
                if (varying)
                    lanes_pack(lists->kept_p_board_top + kept_shots, packed, p_board_top);
                if (varying)
                    lanes_pack(lists->kept_p_bridge_depth + kept_shots, packed, p_bridge_depth);
                if (varying)
                    lanes_pack(lists->kept_p_bridge_friction + kept_shots, packed, p_bridge_friction);
                if (varying)
                    lanes_pack(lists->kept_p_bridge_half_width + kept_shots, packed, p_bridge_half_width);
                if (varying)
                    lanes_pack(lists->kept_p_end_depth + kept_shots, packed, p_end_depth);
                if (varying)
                    lanes_pack(lists->kept_p_gravity + kept_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->kept_p_ring_friction + kept_shots, packed, p_ring_friction);
                if (varying)
                    lanes_pack(lists->kept_p_ring_radius + kept_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->kept_p_wire_radius + kept_shots, packed, p_wire_radius);
                lanes_pack(lists->kept_position_error + kept_shots, packed, position_error);
                lanes_pack(lists->kept_rests + kept_shots, packed, lanes_select(rests, K(1.0), K(0.0)));
                lanes_pack(lists->kept_taut + kept_shots, packed, taut);
                lanes_pack(lists->kept_taut_clock + kept_shots, packed, taut_clock);
                lanes_pack(lists->kept_taut_rate + kept_shots, packed, taut_rate);
                lanes_pack(lists->kept_through + kept_shots, packed, through);
                lanes_pack(lists->kept_velocity_error + kept_shots, packed, velocity_error);
                lanes_pack(lists->kept_vx + kept_shots, packed, vx);
                lanes_pack(lists->kept_vy + kept_shots, packed, vy);
                lanes_pack(lists->kept_vz + kept_shots, packed, vz);
                lanes_pack(lists->kept_when + kept_shots, packed, when);
                lanes_pack(lists->kept_wx + kept_shots, packed, wx);
                lanes_pack(lists->kept_wy + kept_shots, packed, wy);
                lanes_pack(lists->kept_wz + kept_shots, packed, wz);
                lanes_pack(lists->kept_x + kept_shots, packed, x);
                lanes_pack(lists->kept_y + kept_shots, packed, y);
                lanes_pack(lists->kept_z + kept_shots, packed, z);
                kept_shots += lanes_many(packed);
            }
        }
        if (kept_shots)
            LANES(court_bounded_kept)(lists, kept_shots, varying, time_limit);
        for (size_t k = 0; k < kept_shots; k++) {
            const size_t row = (size_t)lists->kept_row[k];
            lists->began[row] = lists->kept_began[k];
            lists->circled[row] = lists->kept_circled[k];
            lists->clock[row] = lists->kept_clock[k];
            lists->doubt[row] = lists->kept_doubt[k];
            lists->dvx[row] = lists->kept_dvx[k];
            lists->dvy[row] = lists->kept_dvy[k];
            lists->dvz[row] = lists->kept_dvz[k];
            lists->dwx[row] = lists->kept_dwx[k];
            lists->dwy[row] = lists->kept_dwy[k];
            lists->dwz[row] = lists->kept_dwz[k];
            lists->dx[row] = lists->kept_dx[k];
            lists->dy[row] = lists->kept_dy[k];
            lists->dz[row] = lists->kept_dz[k];
            lists->grip_lost[row] = lists->kept_grip_lost[k];
            lists->late[row] = lists->kept_late[k];
            lists->position_error[row] = lists->kept_position_error[k];
            lists->rests[row] = lists->kept_rests[k];
            lists->rolling[row] = lists->kept_rolling[k];
            lists->taut[row] = lists->kept_taut[k];
            lists->taut_clock[row] = lists->kept_taut_clock[k];
            lists->taut_rate[row] = lists->kept_taut_rate[k];
            lists->through[row] = lists->kept_through[k];
            lists->velocity_error[row] = lists->kept_velocity_error[k];
            lists->vx[row] = lists->kept_vx[k];
            lists->vy[row] = lists->kept_vy[k];
            lists->vz[row] = lists->kept_vz[k];
            lists->when[row] = lists->kept_when[k];
            lists->which[row] = lists->kept_which[k];
            lists->wx[row] = lists->kept_wx[k];
            lists->wy[row] = lists->kept_wy[k];
            lists->wz[row] = lists->kept_wz[k];
            lists->x[row] = lists->kept_x[k];
            lists->y[row] = lists->kept_y[k];
            lists->z[row] = lists->kept_z[k];
        }
        }
        {
        size_t slow_shots = 0;
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            V assured = lanes_load(lists->assured + i);
            V began = lanes_load(lists->began + i);
            V clock = lanes_load(lists->clock + i);
            V clock_error = lanes_load(lists->clock_error + i);
            V contacts = lanes_load(lists->contacts + i);
            V count_0 = lanes_load(lists->count_0 + i);
            V count_1 = lanes_load(lists->count_1 + i);
            V count_2 = lanes_load(lists->count_2 + i);
            V doubt = lanes_load(lists->doubt + i);
            V dvx = lanes_load(lists->dvx + i);
            V dvy = lanes_load(lists->dvy + i);
            V dvz = lanes_load(lists->dvz + i);
            V dwx = lanes_load(lists->dwx + i);
            V dwy = lanes_load(lists->dwy + i);
            V dwz = lanes_load(lists->dwz + i);
            V dx = lanes_load(lists->dx + i);
            V dy = lanes_load(lists->dy + i);
            V dz = lanes_load(lists->dz + i);
            V extent = lanes_load(lists->extent + i);
            V first = lanes_load(lists->first + i);
            V held = lanes_load(lists->held + i);
            M kept = lanes_less(K(0.0), lanes_load(lists->kept + i));
            V last = lanes_load(lists->last + i);
            V late = lanes_load(lists->late + i);
            M limited = lanes_less(K(0.0), lanes_load(lists->limited + i));
            V mode = lanes_load(lists->mode + i);
            const V p_backboard_friction = lanes_load(lists->p_backboard_friction + (i & varying));
            const V p_backboard_restitution = lanes_load(lists->p_backboard_restitution + (i & varying));
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_bottom = lanes_load(lists->p_board_bottom + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_board_half_width = lanes_load(lists->p_board_half_width + (i & varying));
            const V p_board_thickness = lanes_load(lists->p_board_thickness + (i & varying));
            const V p_board_top = lanes_load(lists->p_board_top + (i & varying));
            const V p_bridge_depth = lanes_load(lists->p_bridge_depth + (i & varying));
            const V p_bridge_friction = lanes_load(lists->p_bridge_friction + (i & varying));
            const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + (i & varying));
            const V p_bridge_restitution = lanes_load(lists->p_bridge_restitution + (i & varying));
            const V p_end_depth = lanes_load(lists->p_end_depth + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_restitution_speed = lanes_load(lists->p_restitution_speed + (i & varying));
            const V p_ring_friction = lanes_load(lists->p_ring_friction + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
            const V p_ring_restitution = lanes_load(lists->p_ring_restitution + (i & varying));
            const V p_tangential_restitution = lanes_load(lists->p_tangential_restitution + (i & varying));
            const V p_wire_radius = lanes_load(lists->p_wire_radius + (i & varying));
            V position_error = lanes_load(lists->position_error + i);
            M rests = lanes_less(K(0.0), lanes_load(lists->rests + i));
            M rolling = lanes_less(K(0.0), lanes_load(lists->rolling + i));
            V rolls = lanes_load(lists->rolls + i);
            V slip_left = lanes_load(lists->slip_left + i);
            V speed = lanes_load(lists->speed + i);
            V through = lanes_load(lists->through + i);
            V uncertain = lanes_load(lists->uncertain + i);
            V velocity_error = lanes_load(lists->velocity_error + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V when = lanes_load(lists->when + i);
            V which = lanes_load(lists->which + i);
            V wx = lanes_load(lists->wx + i);
            V wy = lanes_load(lists->wy + i);
            V wz = lanes_load(lists->wz + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const LANES(court_departed_out) _o460 =
                LANES(court_departed)(K(3.0), which);
            M moves = _o460.moves;
            M ends = _o460.ends;
            M touches = _o460.touches;
            V reached = _o460.reached;
            M edge = _o460.edge;
            const LANES(court_body_of_out) _o461 =
                LANES(court_body_of)(which);
            V body = _o461.body;
            const M _m462 = lanes_both(rows, moves);
            if (lanes_any(_m462)) {
                const LANES(court_passing_doubt_out) _o463 =
                    LANES(court_passing_doubt)(when, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ring_radius, p_gravity);
                M unsure = _o463.unsure;
                const LANES(court_undecided_out) _o464 =
                    LANES(court_undecided)(uncertain, unsure);
                uncertain = lanes_select(_m462, _o464.uncertain, uncertain);
                const LANES(court_passing_out) _o465 =
                    LANES(court_passing)(through, when, x, y, z, vx, vy, vz, p_ring_radius, p_gravity);
                through = lanes_select(_m462, _o465.through, through);
                const LANES(court_flight_out) _o466 =
                    LANES(court_flight)(when, x, y, z, vx, vy, vz, p_gravity);
                x = lanes_select(_m462, _o466.x, x);
                y = lanes_select(_m462, _o466.y, y);
                z = lanes_select(_m462, _o466.z, z);
                vx = lanes_select(_m462, _o466.vx, vx);
                vy = lanes_select(_m462, _o466.vy, vy);
                vz = lanes_select(_m462, _o466.vz, vz);
                const LANES(court_ticked_out) _o467 =
                    LANES(court_ticked)(clock, when);
                clock = lanes_select(_m462, _o467.clock, clock);
            }
            const M _m468 = lanes_both(rows, limited);
            if (lanes_any(_m468)) {
                const LANES(court_expired_out) _o469 =
                    LANES(court_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m468, _o469.clock, clock);
                body = lanes_select(_m468, _o469.body, body);
                reached = lanes_select(_m468, _o469.reached, reached);
                ends = lanes_choose(_m468, _o469.ends, ends);
            }
            const LANES(court_unhopped_out) _o470 =
                LANES(court_unhopped)();
            M hopped = _o470.hopped;
            const M _m471 = lanes_both(rows, kept);
            if (lanes_any(_m471)) {
                const LANES(court_kept_on_out) _o472 =
                    LANES(court_kept_on)(began, body, clock, doubt, ends, held, last, reached, rests, rolling, rolls, which);
                body = lanes_select(_m471, _o472.body, body);
                reached = lanes_select(_m471, _o472.reached, reached);
                doubt = lanes_select(_m471, _o472.doubt, doubt);
                ends = lanes_choose(_m471, _o472.ends, ends);
                hopped = lanes_choose(_m471, _o472.hopped, hopped);
                last = lanes_select(_m471, _o472.last, last);
                mode = lanes_select(_m471, _o472.mode, mode);
                held = lanes_select(_m471, _o472.held, held);
                rolls = lanes_select(_m471, _o472.rolls, rolls);
            }
            const LANES(court_displacement_out) _o473 =
                LANES(court_displacement)(late, when, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_gravity, p_end_depth);
            V slack = _o473.margin;
            const LANES(court_here_out) _o474 =
                LANES(court_here)(K(3.0), which);
            M here = _o474.here;
            const M _m475 = lanes_both(rows, here);
            {
                const LANES(court_end_bounds_out) _o476 =
                    LANES(court_end_bounds)(x, y, p_ring_radius);
                V g0 = _o476.g0;
                const LANES(court_end_reached_out) _o477 =
                    LANES(court_end_reached)(g0, through);
                reached = lanes_select(_m475, _o477.reached, reached);
                const LANES(court_end_edge_out) _o478 =
                    LANES(court_end_edge)(g0, slack, through);
                edge = lanes_choose(_m475, _o478.edge, edge);
            }
            const LANES(court_doubted_in_contact_out) _o479 =
                LANES(court_doubted_in_contact)(assured, doubt, edge, last, late, uncertain, when, which);
            uncertain = _o479.uncertain;
            const LANES(court_accounted_out) _o480 =
                LANES(court_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o480.contacts;
            V outcome = _o480.outcome;
            if (recording) {
                lanes_store(lists->body + i, body);
                lanes_store(lists->x_before + i, x);
                lanes_store(lists->y_before + i, y);
                lanes_store(lists->z_before + i, z);
                lanes_store(lists->vx_before + i, vx);
                lanes_store(lists->vy_before + i, vy);
                lanes_store(lists->vz_before + i, vz);
                lanes_store(lists->wx_before + i, wx);
                lanes_store(lists->wy_before + i, wy);
                lanes_store(lists->wz_before + i, wz);
            }
            const LANES(court_meeting_out) _o481 =
                LANES(court_meeting)(claims, ends, touches);
            M meeting = _o481.meeting;
            const LANES(court_unslowed_out) _o482 =
                LANES(court_unslowed)();
            M slow = _o482.slow;
            const M _m483 = lanes_both(rows, meeting);
            if (lanes_any(_m483)) {
                const LANES(court_end_normal_out) _o484 =
                    LANES(court_end_normal)();
                V nx = _o484.nx;
                V ny = _o484.ny;
                V nz = _o484.nz;
                const LANES(court_here_out) _o485 =
                    LANES(court_here)(K(0.0), which);
                M here = _o485.here;
                const M _m486 = lanes_both(_m483, here);
                {
                    const LANES(court_ring_normal_out) _o487 =
                        LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m486, _o487.nx, nx);
                    ny = lanes_select(_m486, _o487.ny, ny);
                    nz = lanes_select(_m486, _o487.nz, nz);
                    const LANES(court_counted_out) _o488 =
                        LANES(court_counted)(count_0);
                    count_0 = lanes_select(_m486, _o488.count, count_0);
                }
                const LANES(court_here_out) _o489 =
                    LANES(court_here)(K(1.0), which);
                here = _o489.here;
                const M _m490 = lanes_both(_m483, here);
                {
                    const LANES(court_backboard_normal_out) _o491 =
                        LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m490, _o491.nx, nx);
                    ny = lanes_select(_m490, _o491.ny, ny);
                    nz = lanes_select(_m490, _o491.nz, nz);
                    const LANES(court_counted_out) _o492 =
                        LANES(court_counted)(count_1);
                    count_1 = lanes_select(_m490, _o492.count, count_1);
                }
                const LANES(court_here_out) _o493 =
                    LANES(court_here)(K(2.0), which);
                here = _o493.here;
                const M _m494 = lanes_both(_m483, here);
                {
                    const LANES(court_bridge_normal_out) _o495 =
                        LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m494, _o495.nx, nx);
                    ny = lanes_select(_m494, _o495.ny, ny);
                    nz = lanes_select(_m494, _o495.nz, nz);
                    const LANES(court_counted_out) _o496 =
                        LANES(court_counted)(count_2);
                    count_2 = lanes_select(_m494, _o496.count, count_2);
                }
                const LANES(court_elsewhere_out) _o497 =
                    LANES(court_elsewhere)();
                V curving = _o497.curving;
                const LANES(court_anew_out) _o498 =
                    LANES(court_anew)();
                V left_nx = _o498.left_nx;
                V left_ny = _o498.left_ny;
                V left_nz = _o498.left_nz;
                const LANES(court_again_out) _o499 =
                    LANES(court_again)(K(0.0), last, which);
                M again = _o499.again;
                const M _m500 = lanes_both(_m483, again);
                if (lanes_any(_m500)) {
                    const LANES(court_ring_curvature_out) _o501 =
                        LANES(court_ring_curvature)(p_ball_radius, p_ring_radius, p_wire_radius);
                    curving = lanes_select(_m500, _o501.curvature, curving);
                    const LANES(court_started_out) _o502 =
                        LANES(court_started)(p_gravity, when, vx, vy, vz, x, y, z);
                    V from_x = _o502.from_x;
                    V from_y = _o502.from_y;
                    V from_z = _o502.from_z;
                    const LANES(court_ring_normal_out) _o503 =
                        LANES(court_ring_normal)(from_x, from_y, from_z, p_ball_radius, p_ring_radius, p_wire_radius);
                    left_nx = lanes_select(_m500, _o503.nx, left_nx);
                    left_ny = lanes_select(_m500, _o503.ny, left_ny);
                    left_nz = lanes_select(_m500, _o503.nz, left_nz);
                }
                const LANES(court_again_out) _o504 =
                    LANES(court_again)(K(1.0), last, which);
                again = _o504.again;
                const M _m505 = lanes_both(_m483, again);
                if (lanes_any(_m505)) {
                    const LANES(court_backboard_curvature_out) _o506 =
                        LANES(court_backboard_curvature)(p_ball_radius);
                    curving = lanes_select(_m505, _o506.curvature, curving);
                    const LANES(court_started_out) _o507 =
                        LANES(court_started)(p_gravity, when, vx, vy, vz, x, y, z);
                    V from_x = _o507.from_x;
                    V from_y = _o507.from_y;
                    V from_z = _o507.from_z;
                    const LANES(court_backboard_normal_out) _o508 =
                        LANES(court_backboard_normal)(from_x, from_y, from_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    left_nx = lanes_select(_m505, _o508.nx, left_nx);
                    left_ny = lanes_select(_m505, _o508.ny, left_ny);
                    left_nz = lanes_select(_m505, _o508.nz, left_nz);
                }
                const LANES(court_again_out) _o509 =
                    LANES(court_again)(K(2.0), last, which);
                again = _o509.again;
                const M _m510 = lanes_both(_m483, again);
                if (lanes_any(_m510)) {
                    const LANES(court_bridge_curvature_out) _o511 =
                        LANES(court_bridge_curvature)(p_ball_radius);
                    curving = lanes_select(_m510, _o511.curvature, curving);
                    const LANES(court_started_out) _o512 =
                        LANES(court_started)(p_gravity, when, vx, vy, vz, x, y, z);
                    V from_x = _o512.from_x;
                    V from_y = _o512.from_y;
                    V from_z = _o512.from_z;
                    const LANES(court_bridge_normal_out) _o513 =
                        LANES(court_bridge_normal)(from_x, from_y, from_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    left_nx = lanes_select(_m510, _o513.nx, left_nx);
                    left_ny = lanes_select(_m510, _o513.ny, left_ny);
                    left_nz = lanes_select(_m510, _o513.nz, left_nz);
                }
                const LANES(court_carry_flight_out) _o514 =
                    LANES(court_carry_flight)(when, x, y, z, vx, vy, vz, nx, ny, nz, clock, contacts, late, dx, dy, dz, dvx, dvy, dvz, left_nx, left_ny, left_nz, curving, p_gravity);
                dx = lanes_select(_m483, _o514.dx, dx);
                dy = lanes_select(_m483, _o514.dy, dy);
                dz = lanes_select(_m483, _o514.dz, dz);
                V lifting = _o514.lifting;
                dvx = lanes_select(_m483, _o514.dvx, dvx);
                dvy = lanes_select(_m483, _o514.dvy, dvy);
                dvz = lanes_select(_m483, _o514.dvz, dvz);
                V belated = _o514.delay;
                V shift = _o514.shift;
                const LANES(court_delayed_out) _o515 =
                    LANES(court_delayed)(clock_error, belated);
                clock_error = lanes_select(_m483, _o515.clock_error, clock_error);
                const M _m516 = lanes_both(_m483, ends);
                {
                    const LANES(court_floored_out) _o517 =
                        LANES(court_floored)(dx, dy, dz, shift);
                    dx = lanes_select(_m516, _o517.dx, dx);
                    dy = lanes_select(_m516, _o517.dy, dy);
                    dz = lanes_select(_m516, _o517.dz, dz);
                }
                const LANES(court_unturned_out) _o518 =
                    LANES(court_unturned)();
                V dnx = _o518.dnx;
                V dny = _o518.dny;
                V dnz = _o518.dnz;
                V turn = _o518.turn;
                const LANES(court_here_out) _o519 =
                    LANES(court_here)(K(0.0), which);
                here = _o519.here;
                const M _m520 = lanes_both(_m483, here);
                if (lanes_any(_m520)) {
                    const LANES(court_ring_carry_normal_out) _o521 =
                        LANES(court_ring_carry_normal)(x, y, dx, dy, dz, shift, p_ball_radius, p_ring_radius, p_wire_radius);
                    dnx = lanes_select(_m520, _o521.dnx, dnx);
                    dny = lanes_select(_m520, _o521.dny, dny);
                    dnz = lanes_select(_m520, _o521.dnz, dnz);
                    turn = lanes_select(_m520, _o521.turn, turn);
                }
                const LANES(court_here_out) _o522 =
                    LANES(court_here)(K(1.0), which);
                here = _o522.here;
                const M _m523 = lanes_both(_m483, here);
                {
                    const LANES(court_backboard_carry_normal_out) _o524 =
                        LANES(court_backboard_carry_normal)(x, y, z, dx, dy, dz, shift, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    dnx = lanes_select(_m523, _o524.dnx, dnx);
                    dny = lanes_select(_m523, _o524.dny, dny);
                    dnz = lanes_select(_m523, _o524.dnz, dnz);
                    turn = lanes_select(_m523, _o524.turn, turn);
                }
                const LANES(court_here_out) _o525 =
                    LANES(court_here)(K(2.0), which);
                here = _o525.here;
                const M _m526 = lanes_both(_m483, here);
                {
                    const LANES(court_bridge_carry_normal_out) _o527 =
                        LANES(court_bridge_carry_normal)(x, y, z, dx, dy, dz, shift, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    dnx = lanes_select(_m526, _o527.dnx, dnx);
                    dny = lanes_select(_m526, _o527.dny, dny);
                    dnz = lanes_select(_m526, _o527.dnz, dnz);
                    turn = lanes_select(_m526, _o527.turn, turn);
                }
                const LANES(court_untaken_out) _o528 =
                    LANES(court_untaken)();
                M struck_0 = _o528.mine;
                const LANES(court_ring_impact_taken_out) _o529 =
                    LANES(court_ring_impact_taken)(p_ring_restitution, p_ring_friction);
                V its_0_ring_impact = _o529.its_0;
                V its_1_ring_impact = _o529.its_1;
                {
                    const double *const _t531[][2] = {
                        {lists->p_ring_friction, lists->p_ring_restitution},
                        {lists->p_backboard_friction, lists->p_backboard_restitution},
                        {lists->p_bridge_friction, lists->p_bridge_restitution},
                    };
                    static const double _t532[][1] = {
                        {0.0},
                        {1.0},
                        {2.0},
                    };
                    for (size_t _k530 = 0; _k530 < 3; _k530++) {
                        const V own_1 = lanes_load(_t531[_k530][0] + (i & varying));
                        const V own_2 = lanes_load(_t531[_k530][1] + (i & varying));
                        const V own_index = K(_t532[_k530][0]);
                        const LANES(court_here_out) _o533 =
                            LANES(court_here)(own_index, which);
                        M here = _o533.here;
                        const M _m534 = lanes_both(_m483, here);
                        if (lanes_any(_m534)) {
                            const LANES(court_ring_impact_taken_out) _o535 =
                                LANES(court_ring_impact_taken)(own_2, own_1);
                            struck_0 = lanes_choose(_m534, _o535.mine, struck_0);
                            its_0_ring_impact = lanes_select(_m534, _o535.its_0, its_0_ring_impact);
                            its_1_ring_impact = lanes_select(_m534, _o535.its_1, its_1_ring_impact);
                        }
                    }
                }
                const M _m536 = lanes_both(_m483, struck_0);
                if (lanes_any(_m536)) {
                    const LANES(court_ring_impact_doubt_out) _o537 =
                        LANES(court_ring_impact_doubt)(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, turn, p_ball_radius, its_0_ring_impact, its_1_ring_impact, p_tangential_restitution, p_restitution_speed);
                    M unsure = _o537.unsure;
                    const LANES(court_undecided_out) _o538 =
                        LANES(court_undecided)(uncertain, unsure);
                    uncertain = lanes_select(_m536, _o538.uncertain, uncertain);
                    const LANES(court_carry_ring_impact_out) _o539 =
                        LANES(court_carry_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, dnx, dny, dnz, turn, lifting, p_ball_radius, its_0_ring_impact, its_1_ring_impact, p_tangential_restitution, p_restitution_speed);
                    dvx = lanes_select(_m536, _o539.dvx, dvx);
                    dvy = lanes_select(_m536, _o539.dvy, dvy);
                    dvz = lanes_select(_m536, _o539.dvz, dvz);
                    dwx = lanes_select(_m536, _o539.dwx, dwx);
                    dwy = lanes_select(_m536, _o539.dwy, dwy);
                    dwz = lanes_select(_m536, _o539.dwz, dwz);
                    const LANES(court_ring_impact_out) _o540 =
                        LANES(court_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, its_0_ring_impact, its_1_ring_impact, p_tangential_restitution, p_restitution_speed);
                    vx = lanes_select(_m536, _o540.vx, vx);
                    vy = lanes_select(_m536, _o540.vy, vy);
                    vz = lanes_select(_m536, _o540.vz, vz);
                    wx = lanes_select(_m536, _o540.wx, wx);
                    wy = lanes_select(_m536, _o540.wy, wy);
                    wz = lanes_select(_m536, _o540.wz, wz);
                }
                const M _m541 = lanes_both(_m483, touches);
                {
                    const LANES(court_touched_out) _o542 =
                        LANES(court_touched)(body, first, which);
                    first = lanes_select(_m541, _o542.first, first);
                    last = lanes_select(_m541, _o542.last, last);
                    const LANES(court_slowed_out) _o543 =
                        LANES(court_slowed)(p_ball_radius, p_gravity, nx, ny, nz, position_error, vx, vy, vz);
                    slow = lanes_choose(_m541, _o543.slow, slow);
                    assured = lanes_select(_m541, _o543.assured, assured);
                }
            }
            lanes_store(lists->assured + i, assured);
            lanes_store(lists->clock + i, clock);
            lanes_store(lists->clock_error + i, clock_error);
            lanes_store(lists->contacts + i, contacts);
            lanes_store(lists->count_0 + i, count_0);
            lanes_store(lists->count_1 + i, count_1);
            lanes_store(lists->count_2 + i, count_2);
            lanes_store(lists->dvx + i, dvx);
            lanes_store(lists->dvy + i, dvy);
            lanes_store(lists->dvz + i, dvz);
            lanes_store(lists->dwx + i, dwx);
            lanes_store(lists->dwy + i, dwy);
            lanes_store(lists->dwz + i, dwz);
            lanes_store(lists->dx + i, dx);
            lanes_store(lists->dy + i, dy);
            lanes_store(lists->dz + i, dz);
            lanes_store(lists->first + i, first);
            lanes_store(lists->held + i, held);
            lanes_store(lists->hopped + i, lanes_select(hopped, K(1.0), K(0.0)));
            lanes_store(lists->last + i, last);
            lanes_store(lists->mode + i, mode);
            lanes_store(lists->outcome + i, outcome);
            lanes_store(lists->rolls + i, rolls);
            lanes_store(lists->through + i, through);
            lanes_store(lists->uncertain + i, uncertain);
            lanes_store(lists->vx + i, vx);
            lanes_store(lists->vy + i, vy);
            lanes_store(lists->vz + i, vz);
            lanes_store(lists->wx + i, wx);
            lanes_store(lists->wy + i, wy);
            lanes_store(lists->wz + i, wz);
            lanes_store(lists->x + i, x);
            lanes_store(lists->y + i, y);
            lanes_store(lists->z + i, z);
            const M packed = lanes_both(rows, slow);
            if (lanes_any(packed)) {
                lanes_pack(lists->slow_row + slow_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->slow_assured + slow_shots, packed, assured);
                lanes_pack(lists->slow_held + slow_shots, packed, held);
                lanes_pack(lists->slow_mode + slow_shots, packed, mode);
                lanes_pack(lists->slow_outcome + slow_shots, packed, outcome);
                if (varying)
                    lanes_pack(lists->slow_p_backboard_friction + slow_shots, packed, p_backboard_friction);
                if (varying)
                    lanes_pack(lists->slow_p_backboard_restitution + slow_shots, packed, p_backboard_restitution);
                if (varying)
                    lanes_pack(lists->slow_p_ball_radius + slow_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->slow_p_board_bottom + slow_shots, packed, p_board_bottom);
                if (varying)
                    lanes_pack(lists->slow_p_board_distance + slow_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->slow_p_board_half_width + slow_shots, packed, p_board_half_width);
                if (varying)
                    lanes_pack(lists->slow_p_board_thickness + slow_shots, packed, p_board_thickness);
                if (varying)
                    lanes_pack(lists->slow_p_board_top + slow_shots, packed, p_board_top);
                if (varying)
                    lanes_pack(lists->slow_p_bridge_depth + slow_shots, packed, p_bridge_depth);
                if (varying)
                    lanes_pack(lists->slow_p_bridge_friction + slow_shots, packed, p_bridge_friction);
                if (varying)
                    lanes_pack(lists->slow_p_bridge_half_width + slow_shots, packed, p_bridge_half_width);
                if (varying)
                    lanes_pack(lists->slow_p_bridge_restitution + slow_shots, packed, p_bridge_restitution);
                if (varying)
                    lanes_pack(lists->slow_p_end_depth + slow_shots, packed, p_end_depth);
                if (varying)
                    lanes_pack(lists->slow_p_gravity + slow_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->slow_p_ring_friction + slow_shots, packed, p_ring_friction);
                if (varying)
                    lanes_pack(lists->slow_p_ring_radius + slow_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->slow_p_ring_restitution + slow_shots, packed, p_ring_restitution);
                if (varying)
                    lanes_pack(lists->slow_p_wire_radius + slow_shots, packed, p_wire_radius);
                lanes_pack(lists->slow_slip_left + slow_shots, packed, slip_left);
                lanes_pack(lists->slow_uncertain + slow_shots, packed, uncertain);
                lanes_pack(lists->slow_velocity_error + slow_shots, packed, velocity_error);
                lanes_pack(lists->slow_vx + slow_shots, packed, vx);
                lanes_pack(lists->slow_vy + slow_shots, packed, vy);
                lanes_pack(lists->slow_vz + slow_shots, packed, vz);
                lanes_pack(lists->slow_which + slow_shots, packed, which);
                lanes_pack(lists->slow_wx + slow_shots, packed, wx);
                lanes_pack(lists->slow_wy + slow_shots, packed, wy);
                lanes_pack(lists->slow_wz + slow_shots, packed, wz);
                lanes_pack(lists->slow_x + slow_shots, packed, x);
                lanes_pack(lists->slow_y + slow_shots, packed, y);
                lanes_pack(lists->slow_z + slow_shots, packed, z);
                slow_shots += lanes_many(packed);
            }
        }
        if (slow_shots)
            LANES(court_bounded_slow)(lists, slow_shots, varying);
        for (size_t k = 0; k < slow_shots; k++) {
            const size_t row = (size_t)lists->slow_row[k];
            lists->assured[row] = lists->slow_assured[k];
            lists->held[row] = lists->slow_held[k];
            lists->mode[row] = lists->slow_mode[k];
            lists->outcome[row] = lists->slow_outcome[k];
            lists->slip_left[row] = lists->slow_slip_left[k];
            lists->uncertain[row] = lists->slow_uncertain[k];
        }
        }
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            V clock = lanes_load(lists->clock + i);
            V clock_error = lanes_load(lists->clock_error + i);
            V dvx = lanes_load(lists->dvx + i);
            V dvy = lanes_load(lists->dvy + i);
            V dvz = lanes_load(lists->dvz + i);
            V dwx = lanes_load(lists->dwx + i);
            V dwy = lanes_load(lists->dwy + i);
            V dwz = lanes_load(lists->dwz + i);
            V dx = lanes_load(lists->dx + i);
            V dy = lanes_load(lists->dy + i);
            V dz = lanes_load(lists->dz + i);
            M hopped = lanes_less(K(0.0), lanes_load(lists->hopped + i));
            M limited = lanes_less(K(0.0), lanes_load(lists->limited + i));
            V outcome = lanes_load(lists->outcome + i);
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V when = lanes_load(lists->when + i);
            V which = lanes_load(lists->which + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const M _m595 = lanes_both(rows, limited);
            if (lanes_any(_m595)) {
                const LANES(court_timed_out) _o596 =
                    LANES(court_timed)(claims, K(4.0), which);
                M timed = _o596.timed;
                const M _m597 = lanes_both(_m595, timed);
                if (lanes_any(_m597)) {
                    const LANES(court_carry_time_out) _o598 =
                        LANES(court_carry_time)(when, x, y, z, vx, vy, vz, clock, clock_error, dx, dy, dz, dvx, dvy, dvz, p_gravity);
                    dx = lanes_select(_m597, _o598.dx, dx);
                    dy = lanes_select(_m597, _o598.dy, dy);
                    dz = lanes_select(_m597, _o598.dz, dz);
                    dvx = lanes_select(_m597, _o598.dvx, dvx);
                    dvy = lanes_select(_m597, _o598.dvy, dvy);
                    dvz = lanes_select(_m597, _o598.dvz, dvz);
                    clock_error = lanes_select(_m597, _o598.clock_error, clock_error);
                }
                lanes_store(lists->clock_error + i, clock_error);
                lanes_store(lists->dvx + i, dvx);
                lanes_store(lists->dvy + i, dvy);
                lanes_store(lists->dvz + i, dvz);
            }
            const M _m599 = lanes_both(rows, hopped);
            if (lanes_any(_m599)) {
                const LANES(court_carry_hop_out) _o600 =
                    LANES(court_carry_hop)(dvx, dvy, dvz, dx, dy, dz, vx, vy, vz, when, x, y, z);
                dx = lanes_select(_m599, _o600.dx, dx);
                dy = lanes_select(_m599, _o600.dy, dy);
                dz = lanes_select(_m599, _o600.dz, dz);
            }
            const LANES(court_closing_out) _o601 =
                LANES(court_closing)(claims, outcome);
            M closed = _o601.closed;
            V position_claim = _o601.position_claim;
            V velocity_claim = _o601.velocity_claim;
            V spin_claim = _o601.spin_claim;
            V time_claim = _o601.time_claim;
            const M _m602 = lanes_both(rows, closed);
            if (lanes_any(_m602)) {
                const LANES(court_claimed_errors_out) _o603 =
                    LANES(court_claimed_errors)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
                position_claim = lanes_select(_m602, _o603.position_error, position_claim);
                velocity_claim = lanes_select(_m602, _o603.velocity_error, velocity_claim);
                spin_claim = lanes_select(_m602, _o603.spin_error, spin_claim);
                time_claim = lanes_select(_m602, _o603.time_error, time_claim);
            }
            lanes_store(lists->dx + i, dx);
            lanes_store(lists->dy + i, dy);
            lanes_store(lists->dz + i, dz);
            lanes_store(lists->position_claim + i, position_claim);
            lanes_store(lists->spin_claim + i, spin_claim);
            lanes_store(lists->time_claim + i, time_claim);
            lanes_store(lists->velocity_claim + i, velocity_claim);
        }
        if (recording)
            for (size_t k = 0; k < shots; k++) {
                if (lists->body[k] < 0.0)
                    continue;
                const size_t shot = lists->shot[k], rows = COURT_LOG_ROWS * (size_t)job->max_contacts + 1;
                int32_t *used = job->results->event_counts + shot;
                court_event *event = job->results->events + shot * rows + (size_t)(*used)++;
                const int64_t body = (int64_t)lists->body[k], staying = body - COURT_SURFACES - 1;
                event->shot = (int64_t)shot;
                event->surface = staying < 0 ? body : staying / 2;
                event->kind = staying < -1 ? COURT_EVENT_IMPACT : staying < 0 ? COURT_EVENT_END : staying % 2 ? COURT_EVENT_LEAVE : COURT_EVENT_ROLL;
                event->time = lists->clock[k];
                event->before[0] = lists->x_before[k];
                event->after[0] = lists->x[k];
                event->before[1] = lists->y_before[k];
                event->after[1] = lists->y[k];
                event->before[2] = lists->z_before[k];
                event->after[2] = lists->z[k];
                event->before[3] = lists->vx_before[k];
                event->after[3] = lists->vx[k];
                event->before[4] = lists->vy_before[k];
                event->after[4] = lists->vy[k];
                event->before[5] = lists->vz_before[k];
                event->after[5] = lists->vz[k];
                event->before[6] = lists->wx_before[k];
                event->after[6] = lists->wx[k];
                event->before[7] = lists->wy_before[k];
                event->after[7] = lists->wy[k];
                event->before[8] = lists->wz_before[k];
                event->after[8] = lists->wz[k];
            }

        M going = lanes_nowhere();
        for (size_t i = 0; i < shots; i += LANES_WIDTH)
            going = lanes_either(going, lanes_both(lanes_first(shots - i), lanes_less(lanes_load(lists->outcome + i), K(0.0))));
        if (following && !lanes_any(going)) {
            LANES(court_bounded_finish_all)(lists, shots, job);
            shots = 0;
            streams = 1;
            continue;
        }
        streams = 0;
        shots = LANES(court_bounded_leave)(lists, 0, shots, job);
    }
}

static void LANES(court_run)(const court_job *job)
{
    const court_results *out = job->results;
    if (out->grip_lost || out->time_error || out->state_error || out->uncertain)
        LANES(court_bounded)(job);
    else
        LANES(court_plain)(job);
}

#undef V
#undef M
#undef K
#undef lanes_all
#undef lanes_add
#undef lanes_sub
#undef lanes_mul
#undef lanes_div
#undef lanes_neg
#undef lanes_sqrt
#undef lanes_abs
#undef lanes_max
#undef lanes_min
#undef lanes_less
#undef lanes_at_most
#undef lanes_equal
#undef lanes_both
#undef lanes_either
#undef lanes_not
#undef lanes_nowhere
#undef lanes_select
#undef lanes_choose
#undef lanes_any
#undef lanes_load
#undef lanes_store
#undef lanes_gather
#undef lanes_columns
#undef lanes_rows
#undef lanes_bits
#undef lanes_of
#undef lanes_many
#undef lanes_first
#undef lanes_leading
#undef lanes_count_up
#undef lanes_pack
#undef lanes_expand
