/* The event loop of the scene court, LANES_WIDTH shots abreast.

   Generated from templates/c/engine.h.j2, scene court, derivation 394a0d8707aa8072,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Included by court.c once for every width. The shots in flight fill the first rows of the lists;
   when one ends, the last takes its row. Stages go over all rows, and over those of a list of their
   own where only some shots need them. No shot's result depends on its neighbours. */

#include "court_lanes.h"
#include "court_kernels.h"

/* A column, with room for a whole row of lanes behind its end. */
typedef double LANES(court_column)[LANES_ROWS + LANES_WIDTH];
typedef float LANES(court_singles)[LANES_ROWS + LANES_WIDTH];

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
    _Alignas(64) size_t shot[LANES_ROWS];
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
    LANES(court_column) permitted;
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
    LANES(court_column) turning_p_ball_radius;
    LANES(court_column) turning_p_gravity;
    LANES(court_column) turning_p_ring_radius;
    LANES(court_column) turning_p_wire_radius;
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
    LANES(court_column) turning_p_board_bottom;
    LANES(court_column) turning_p_board_distance;
    LANES(court_column) turning_p_board_half_width;
    LANES(court_column) turning_p_board_thickness;
    LANES(court_column) turning_p_board_top;
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
    LANES(court_column) turning_p_bridge_depth;
    LANES(court_column) turning_p_bridge_half_width;
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
    LANES(court_column) turning_p_end_depth;
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
    /* What kernels make of parameters alone. */
    _Alignas(64) double fixed[175][LANES_WIDTH];
    _Alignas(64) float fixed_single[26][LANES_WIDTH];
} LANES(court_plain_lists);

/* Look at the parameters of a row of lanes. */
LANES_INLINE void LANES(court_plain_permitted)(LANES(court_plain_lists) *lists, size_t row)
{
    lanes_store(lists->permitted + row, lanes_select(LANES(court_permit)(lanes_load(lists->p_ball_radius + row), lanes_load(lists->p_ring_radius + row), lanes_load(lists->p_wire_radius + row), lanes_load(lists->p_board_distance + row), lanes_load(lists->p_board_half_width + row), lanes_load(lists->p_board_bottom + row), lanes_load(lists->p_board_top + row), lanes_load(lists->p_board_thickness + row), lanes_load(lists->p_bridge_half_width + row), lanes_load(lists->p_bridge_depth + row), lanes_load(lists->p_gravity + row), lanes_load(lists->p_end_depth + row), lanes_load(lists->p_ring_restitution + row), lanes_load(lists->p_backboard_restitution + row), lanes_load(lists->p_bridge_restitution + row), lanes_load(lists->p_ring_friction + row), lanes_load(lists->p_backboard_friction + row), lanes_load(lists->p_bridge_friction + row), lanes_load(lists->p_tangential_restitution + row), lanes_load(lists->p_restitution_speed + row)), K(1.0), K(0.0)));
}

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
    if (job->varying)
        for (k = 0; k < shots; k += LANES_WIDTH)
            LANES(court_plain_permitted)(lists, row + k);
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
    const size_t room = LANES_ROWS - row, shots = lists->waiting < room ? lists->waiting : room;
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

/* Make what kernels are given ready made, of the parameters of the first row. */
static void LANES(court_plain_fix)(LANES(court_plain_lists) *lists)
{
    (void)lists;
    const V p_backboard_friction = lanes_load(lists->p_backboard_friction);
    const V p_backboard_restitution = lanes_load(lists->p_backboard_restitution);
    const V p_ball_radius = lanes_load(lists->p_ball_radius);
    const V p_board_bottom = lanes_load(lists->p_board_bottom);
    const V p_board_distance = lanes_load(lists->p_board_distance);
    const V p_board_half_width = lanes_load(lists->p_board_half_width);
    const V p_board_thickness = lanes_load(lists->p_board_thickness);
    const V p_board_top = lanes_load(lists->p_board_top);
    const V p_bridge_depth = lanes_load(lists->p_bridge_depth);
    const V p_bridge_friction = lanes_load(lists->p_bridge_friction);
    const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width);
    const V p_bridge_restitution = lanes_load(lists->p_bridge_restitution);
    const V p_end_depth = lanes_load(lists->p_end_depth);
    const V p_gravity = lanes_load(lists->p_gravity);
    const V p_restitution_speed = lanes_load(lists->p_restitution_speed);
    const V p_ring_friction = lanes_load(lists->p_ring_friction);
    const V p_ring_radius = lanes_load(lists->p_ring_radius);
    const V p_ring_restitution = lanes_load(lists->p_ring_restitution);
    const V p_tangential_restitution = lanes_load(lists->p_tangential_restitution);
    const V p_wire_radius = lanes_load(lists->p_wire_radius);
    {
        const V _s0 = lanes_abs(p_board_bottom);
        const V _s1 = lanes_abs(p_board_top);
        const V _s2 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_abs(p_ball_radius), _s0), lanes_abs(p_board_distance)), lanes_abs(p_board_half_width)), lanes_abs(p_board_thickness)), _s1);
        const V _s3 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s2, lanes_abs(p_bridge_depth)), lanes_abs(p_bridge_half_width)), lanes_abs(p_end_depth)), lanes_abs(p_ring_radius)), lanes_abs(p_wire_radius));
        const V _s4 = lanes_mul(K(0.5), p_board_thickness);
        const V _s5 = lanes_add(p_board_distance, _s4);
        const V _s6 = lanes_add(p_ball_radius, _s4);
        const V _s7 = lanes_mul(K(0.5), p_board_distance);
        const V _s8 = lanes_mul(K(0.5), p_ring_radius);
        const V _s9 = lanes_add(_s7, _s8);
        const V _s10 = lanes_add(p_ball_radius, _s7);
        const V _s11 = lanes_sub(_s10, _s8);
        const V _s12 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s13 = lanes_add(p_board_distance, p_board_thickness);
        const V _s14 = lanes_div(K(1.0), p_gravity);
        const V _s15 = lanes_neg(p_gravity);
        const V _s16 = lanes_neg(_s14);
        const V _s17 = lanes_mul(K(1.00006103515625), _s12);
        const V _s18 = lanes_add(p_ring_radius, _s17);
        const V _s19 = lanes_mul(_s18, _s18);
        const V _s20 = lanes_mul(K(9.313225746154785e-10), _s19);
        const V _s21 = lanes_sub(p_ring_radius, _s17);
        const V _s22 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s23 = lanes_max(_s21, _s22);
        const V _s24 = lanes_mul(_s23, _s23);
        const V _s25 = lanes_div(K(1.0), _s23);
        const V _s26 = lanes_div(_s17, _s23);
        const V _s27 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s28 = lanes_mul(K(0.5), p_board_bottom);
        const V _s29 = lanes_mul(K(0.5), p_board_top);
        const V _s30 = lanes_add(_s28, _s29);
        const V _s31 = lanes_add(p_ball_radius, _s29);
        const V _s32 = lanes_sub(_s31, _s28);
        const V _s33 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s34 = lanes_min(_s33, _s6);
        const V _s35 = lanes_min(_s32, _s34);
        const V _s36 = lanes_mul(K(6.103515625e-05), _s35);
        const V _s37 = lanes_abs(_s15);
        const V _s38 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s35));
        const V _s39 = lanes_mul(K(1.25), _s37);
        const V _s40 = lanes_max(_s6, _s33);
        const V _s41 = lanes_mul(K(0.5), p_bridge_depth);
        const V _s42 = lanes_add(p_ball_radius, _s41);
        const V _s43 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s44 = lanes_min(_s43, _s11);
        const V _s45 = lanes_min(_s42, _s44);
        const V _s46 = lanes_mul(K(6.103515625e-05), _s45);
        const V _s47 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s45));
        const V _s48 = lanes_max(_s11, _s43);
        const V _s49 = lanes_mul(K(1.4210854715202004e-14), p_ball_radius);
        const V _s50 = lanes_add(lanes_add(_s49, lanes_mul(K(2.842170943040401e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_board_thickness));
        const V _s51 = lanes_add(_s49, lanes_mul(K(2.842170943040401e-14), p_board_half_width));
        const V _s52 = lanes_add(lanes_add(_s49, lanes_mul(K(1.4210854715202004e-14), _s0)), lanes_mul(K(1.4210854715202004e-14), _s1));
        const V _s53 = lanes_add(lanes_add(_s49, lanes_mul(K(1.4210854715202004e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_ring_radius));
        const V _s54 = lanes_add(_s49, lanes_mul(K(2.842170943040401e-14), p_bridge_half_width));
        const V _s55 = lanes_add(lanes_add(_s49, lanes_mul(K(1.4210854715202004e-14), p_wire_radius)), lanes_mul(K(1.4210854715202004e-14), lanes_abs(lanes_sub(p_bridge_depth, p_wire_radius))));
        const V _s56 = lanes_neg(p_board_half_width);
        const V _s57 = lanes_max(K(0.0), _s56);
        const V _s58 = lanes_max(_s57, _s56);
        const V _s59 = lanes_neg(_s13);
        const V _s60 = lanes_max(K(0.0), _s59);
        const V _s61 = lanes_max(_s60, p_board_distance);
        const V _s62 = lanes_neg(p_board_distance);
        const V _s63 = lanes_max(K(0.0), _s62);
        const V _s64 = lanes_max(_s63, p_ring_radius);
        const V _s65 = lanes_neg(p_bridge_half_width);
        const V _s66 = lanes_max(K(0.0), _s65);
        const V _s67 = lanes_max(_s66, _s65);
        const V _s68 = lanes_mul(p_gravity, p_gravity);
        const V _s69 = lanes_add(K(0.4), lanes_mul(K(0.4), p_tangential_restitution));
        const V _s70 = lanes_sub(K(1.0), p_ring_restitution);
        const V _s71 = lanes_add(K(1.0), p_ring_restitution);
        const V _s72 = lanes_sub(K(1.0), p_backboard_restitution);
        const V _s73 = lanes_add(K(1.0), p_backboard_restitution);
        const V _s74 = lanes_sub(K(1.0), p_bridge_restitution);
        const V _s75 = lanes_add(K(1.0), p_bridge_restitution);
        lanes_store(lists->fixed[0], _s3);
        lanes_store(lists->fixed[1], lanes_add(lanes_add(p_ball_radius, p_ring_radius), p_wire_radius));
        lanes_store(lists->fixed[2], lanes_neg(_s5));
        lanes_store(lists->fixed[3], _s6);
        lanes_store(lists->fixed[4], lanes_neg(_s9));
        lanes_store(lists->fixed[5], _s11);
        lanes_store(lists->fixed[6], p_ball_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[14], lanes_mul(_s12, _s12));
        lanes_store(lists->fixed[15], _s13);
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[17], lanes_add(lanes_mul(K(4.0), p_ball_radius), lanes_mul(K(4.0), p_wire_radius)));
        lanes_store(lists->fixed[18], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[19], lanes_mul(p_ring_radius, p_ring_radius));
        lanes_store(lists->fixed[20], _s14);
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[22], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[23], _s15);
        lanes_store(lists->fixed[24], _s16);
        lanes_store(lists->fixed[25], lanes_mul(K(0.5), _s16));
        lanes_store(lists->fixed[26], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s12)));
        lanes_store(lists->fixed[27], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[28], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[29], _s17);
        lanes_store(lists->fixed[30], lanes_mul(K(5.820766091346741e-11), _s18));
        lanes_store(lists->fixed[31], lanes_mul(K(65536.0), _s18));
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[33], _s19);
        lanes_store(lists->fixed[34], _s20);
        lanes_store(lists->fixed[35], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[36], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s12));
        lanes_store(lists->fixed[37], _s24);
        lanes_store(lists->fixed[38], lanes_mul(_s23, _s24));
        lanes_store(lists->fixed[39], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[40], lanes_add(_s20, _s24));
        lanes_store(lists->fixed[41], lanes_mul(_s25, lanes_mul(_s25, _s25)));
        lanes_store(lists->fixed[42], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[43], lanes_mul(K(2.0), p_ball_radius));
        lanes_store(lists->fixed[44], lanes_mul(K(2.0), p_wire_radius));
        lanes_store(lists->fixed[45], _s18);
        lanes_store(lists->fixed[46], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s12), _s18));
        lanes_store(lists->fixed[47], lanes_mul(K(5.00030517578125), _s12));
        lanes_store(lists->fixed[48], lanes_max(K(1.0), _s26));
        lanes_store(lists->fixed[49], lanes_mul(K(6.0), p_gravity));
        lanes_store(lists->fixed[50], lanes_mul(K(9.094947017729282e-13), _s18));
        lanes_store(lists->fixed[51], _s23);
        lanes_store(lists->fixed[52], lanes_abs(K(0.0)));
        lanes_store(lists->fixed[53], lanes_mul(K(0.0625), p_gravity));
        lanes_store(lists->fixed[54], lanes_mul(K(1.0000000009313226), _s27));
        lanes_store(lists->fixed[55], lanes_mul(K(1.0000000009313226), _s4));
        lanes_store(lists->fixed[56], lanes_mul(K(1.0000000009313226), p_board_half_width));
        lanes_store(lists->fixed[57], _s30);
        lanes_store(lists->fixed[58], lanes_mul(K(1.0000000009313226), lanes_sub(_s29, _s28)));
        lanes_store(lists->fixed[59], _s29);
        lanes_store(lists->fixed[60], _s28);
        lanes_store(lists->fixed[61], _s35);
        lanes_store(lists->fixed[62], lanes_add(_s6, _s36));
        lanes_store(lists->fixed[63], _s5);
        lanes_store(lists->fixed[64], lanes_add(_s33, _s36));
        lanes_store(lists->fixed[65], lanes_sub(lanes_add(_s31, _s36), _s28));
        lanes_store(lists->fixed[66], lanes_mul(_s39, _s38));
        lanes_store(lists->fixed[67], lanes_abs(_s30));
        lanes_store(lists->fixed[68], lanes_max(_s40, _s32));
        lanes_store(lists->fixed[69], lanes_mul(K(1.52587890625e-05), _s35));
        lanes_store(lists->fixed[70], lanes_mul(K(5.55653613398821e-16), _s27));
        lanes_store(lists->fixed[71], _s38);
        lanes_store(lists->fixed[72], lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        lanes_store(lists->fixed[73], lanes_mul(K(2.001953125), _s38));
        lanes_store(lists->fixed[74], lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        lanes_store(lists->fixed[75], lanes_add(lanes_mul(K(2.220446049250313e-16), _s0), lanes_mul(K(2.220446049250313e-16), _s1)));
        lanes_store(lists->fixed[76], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s38, _s38)));
        lanes_store(lists->fixed[77], lanes_mul(K(12.01171875), _s38));
        lanes_store(lists->fixed[78], lanes_mul(K(6.667843360785852e-15), _s38));
        lanes_store(lists->fixed[79], lanes_mul(K(6.005859375), _s38));
        lanes_store(lists->fixed[80], lanes_mul(K(2.667137344314341e-15), _s38));
        lanes_store(lists->fixed[81], _s27);
        lanes_store(lists->fixed[82], _s37);
        lanes_store(lists->fixed[83], lanes_mul(K(0.5), _s37));
        lanes_store(lists->fixed[84], lanes_mul(K(1.0000000009313226), lanes_sub(_s7, _s8)));
        lanes_store(lists->fixed[85], lanes_mul(K(1.0000000009313226), p_bridge_half_width));
        lanes_store(lists->fixed[86], lanes_sub(p_wire_radius, _s41));
        lanes_store(lists->fixed[87], lanes_mul(K(1.0000000009313226), _s41));
        lanes_store(lists->fixed[88], _s7);
        lanes_store(lists->fixed[89], _s41);
        lanes_store(lists->fixed[90], _s8);
        lanes_store(lists->fixed[91], _s45);
        lanes_store(lists->fixed[92], lanes_sub(lanes_add(_s10, _s46), _s8));
        lanes_store(lists->fixed[93], _s9);
        lanes_store(lists->fixed[94], lanes_add(_s43, _s46));
        lanes_store(lists->fixed[95], lanes_add(_s42, _s46));
        lanes_store(lists->fixed[96], lanes_mul(_s39, _s47));
        lanes_store(lists->fixed[97], lanes_abs(lanes_sub(_s41, p_wire_radius)));
        lanes_store(lists->fixed[98], lanes_max(_s48, _s42));
        lanes_store(lists->fixed[99], lanes_mul(K(1.52587890625e-05), _s45));
        lanes_store(lists->fixed[100], _s47);
        lanes_store(lists->fixed[101], lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        lanes_store(lists->fixed[102], lanes_mul(K(2.001953125), _s47));
        lanes_store(lists->fixed[103], lanes_add(lanes_mul(K(1.1102230246251565e-16), p_board_distance), lanes_mul(K(1.1102230246251565e-16), p_ring_radius)));
        lanes_store(lists->fixed[104], lanes_add(lanes_mul(K(2.220446049250313e-16), p_bridge_depth), lanes_mul(K(5.551115123125783e-16), p_wire_radius)));
        lanes_store(lists->fixed[105], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s47, _s47)));
        lanes_store(lists->fixed[106], lanes_mul(K(12.01171875), _s47));
        lanes_store(lists->fixed[107], lanes_mul(K(6.667843360785852e-15), _s47));
        lanes_store(lists->fixed[108], lanes_mul(K(6.005859375), _s47));
        lanes_store(lists->fixed[109], lanes_mul(K(2.667137344314341e-15), _s47));
        lanes_store(lists->fixed[110], lanes_div(K(1.0), _s12));
        lanes_store(lists->fixed[111], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[112], _s50);
        lanes_store(lists->fixed[113], lanes_neg(_s50));
        lanes_store(lists->fixed[114], _s51);
        lanes_store(lists->fixed[115], lanes_neg(_s51));
        lanes_store(lists->fixed[116], _s52);
        lanes_store(lists->fixed[117], lanes_neg(_s52));
        lanes_store(lists->fixed[118], _s53);
        lanes_store(lists->fixed[119], lanes_neg(_s53));
        lanes_store(lists->fixed[120], _s54);
        lanes_store(lists->fixed[121], lanes_neg(_s54));
        lanes_store(lists->fixed[122], _s55);
        lanes_store(lists->fixed[123], lanes_neg(_s55));
        lanes_store(lists->fixed[124], lanes_mul(K(0.6), p_gravity));
        lanes_store(lists->fixed[125], lanes_mul(K(0.015625), p_gravity));
        lanes_store(lists->fixed[126], lanes_mul(K(0.4), p_gravity));
        lanes_store(lists->fixed[127], lanes_mul(K(5.684341886080802e-14), lanes_sqrt(lanes_mul(p_ball_radius, p_gravity))));
        lanes_store(lists->fixed[128], lanes_mul(K(5.684341886080802e-14), p_gravity));
        lanes_store(lists->fixed[129], _s12);
        lanes_store(lists->fixed[130], lanes_mul(K(3.637978807091713e-12), p_ball_radius));
        lanes_store(lists->fixed[131], p_bridge_depth);
        lanes_store(lists->fixed[132], lanes_mul(K(0.6), p_ring_radius));
        lanes_store(lists->fixed[133], lanes_mul(K(0.3333333333333333), p_ring_radius));
        lanes_store(lists->fixed[134], lanes_mul(K(0.25), p_ring_radius));
        lanes_store(lists->fixed[135], lanes_mul(K(0.2), p_ring_radius));
        lanes_store(lists->fixed[136], lanes_mul(K(0.16666666666666666), p_ring_radius));
        lanes_store(lists->fixed[137], lanes_mul(K(0.14285714285714285), p_ring_radius));
        lanes_store(lists->fixed[138], lanes_mul(K(0.125), p_ring_radius));
        lanes_store(lists->fixed[139], lanes_mul(K(0.1111111111111111), p_ring_radius));
        lanes_store(lists->fixed[140], lanes_mul(K(0.1), p_ring_radius));
        lanes_store(lists->fixed[141], lanes_mul(K(0.09090909090909091), p_ring_radius));
        lanes_store(lists->fixed[142], lanes_mul(K(0.08333333333333333), p_ring_radius));
        lanes_store(lists->fixed[143], lanes_mul(K(2.2), p_gravity));
        lanes_store(lists->fixed[144], lanes_mul(K(3.0), p_ring_radius));
        lanes_store(lists->fixed[145], lanes_mul(K(6.0), p_ring_radius));
        lanes_store(lists->fixed[146], lanes_mul(K(0.8), p_gravity));
        lanes_store(lists->fixed[147], lanes_sqrt(lanes_add(lanes_mul(_s58, _s58), lanes_mul(_s61, _s61))));
        lanes_store(lists->fixed[148], lanes_sqrt(lanes_add(lanes_mul(_s64, _s64), lanes_mul(_s67, _s67))));
        lanes_store(lists->fixed[149], lanes_mul(K(0.000244140625), _s12));
        lanes_store(lists->fixed[150], lanes_mul(K(0.00390625), p_gravity));
        lanes_store(lists->fixed[151], lanes_mul(lanes_mul(K(0.000244140625), _s68), _s12));
        lanes_store(lists->fixed[152], lanes_mul(K(3.0), p_gravity));
        lanes_store(lists->fixed[153], lanes_mul(K(2.0), lanes_mul(K(3.0), _s68)));
        lanes_store(lists->fixed[154], lanes_mul(K(0.0078125), p_gravity));
        lanes_store(lists->fixed[155], lanes_max(K(0.0), p_gravity));
        lanes_store(lists->fixed[156], p_restitution_speed);
        lanes_store(lists->fixed[157], _s69);
        lanes_store(lists->fixed[158], lanes_mul(_s69, _s69));
        lanes_store(lists->fixed[159], lanes_mul(K(7.275957614183426e-12), p_ball_radius));
        lanes_store(lists->fixed[160], lanes_mul(K(1.1920928955078125e-07), p_ball_radius));
        lanes_store(lists->fixed[161], lanes_mul(K(0.4), p_ball_radius));
        lanes_store(lists->fixed[162], _s70);
        lanes_store(lists->fixed[163], lanes_mul(_s70, _s70));
        lanes_store(lists->fixed[164], lanes_mul(p_ring_friction, _s71));
        lanes_store(lists->fixed[165], lanes_mul(_s71, _s70));
        lanes_store(lists->fixed[166], lanes_mul(K(3.725290298461914e-09), p_ball_radius));
        lanes_store(lists->fixed[167], _s72);
        lanes_store(lists->fixed[168], lanes_mul(_s72, _s72));
        lanes_store(lists->fixed[169], lanes_mul(p_backboard_friction, _s73));
        lanes_store(lists->fixed[170], lanes_mul(_s73, _s72));
        lanes_store(lists->fixed[171], _s74);
        lanes_store(lists->fixed[172], lanes_mul(_s74, _s74));
        lanes_store(lists->fixed[173], lanes_mul(p_bridge_friction, _s75));
        lanes_store(lists->fixed[174], lanes_mul(_s75, _s74));
    }
    {
        const S _p_ball_radius = lanes_narrow(p_ball_radius);
        const S _p_ring_radius = lanes_narrow(p_ring_radius);
        const S _p_wire_radius = lanes_narrow(p_wire_radius);
        const S _p_gravity = lanes_narrow(p_gravity);
        const S _s0 = singles_add(_p_ball_radius, _p_wire_radius);
        const S _s1 = singles_mul(KS(1.00006103515625), _s0);
        const S _s2 = singles_add(_p_ring_radius, _s1);
        const S _s3 = singles_sub(_p_ring_radius, _s1);
        const S _s4 = singles_mul(KS(0.0001220703125), _p_ring_radius);
        const S _s5 = singles_max(_s3, _s4);
        const S _s6 = singles_div(_s0, _s5);
        const S _s7 = singles_max(KS(1.0), _s6);
        const S _s8 = singles_div(KS(1.0), _s5);
        singles_store(lists->fixed_single[0], _p_gravity);
        singles_store(lists->fixed_single[1], _s1);
        singles_store(lists->fixed_single[2], singles_mul(KS(2.0), _p_gravity));
        singles_store(lists->fixed_single[3], singles_div(KS(1.0), _p_gravity));
        singles_store(lists->fixed_single[4], _s2);
        singles_store(lists->fixed_single[5], singles_mul(_s2, _s2));
        singles_store(lists->fixed_single[6], _s5);
        singles_store(lists->fixed_single[7], singles_mul(_s5, _s5));
        singles_store(lists->fixed_single[8], singles_mul(KS(32.0), _s5));
        singles_store(lists->fixed_single[9], singles_add(singles_mul(KS(32.0), _p_ball_radius), singles_mul(KS(32.0), _p_wire_radius)));
        singles_store(lists->fixed_single[10], _s0);
        singles_store(lists->fixed_single[11], _s7);
        singles_store(lists->fixed_single[12], singles_mul(KS(4.0), _p_gravity));
        singles_store(lists->fixed_single[13], singles_mul(KS(2.0), _p_ring_radius));
        singles_store(lists->fixed_single[14], singles_mul(singles_mul(KS(6.0003662109375), _p_gravity), _s0));
        singles_store(lists->fixed_single[15], singles_mul(_s8, singles_mul(_s8, _s8)));
        singles_store(lists->fixed_single[16], singles_mul(KS(5.0048828125), _s0));
        singles_store(lists->fixed_single[17], singles_mul(KS(7.62939453125e-06), singles_mul(singles_div(_s2, _s5), _s7)));
        singles_store(lists->fixed_single[18], singles_add(singles_mul(KS(128.0), _p_ball_radius), singles_mul(KS(128.0), _p_wire_radius)));
        singles_store(lists->fixed_single[19], _p_ring_radius);
        singles_store(lists->fixed_single[20], singles_mul(KS(0.5), _p_gravity));
        singles_store(lists->fixed_single[21], singles_mul(_s0, _s0));
        singles_store(lists->fixed_single[22], singles_mul(KS(6.0), _p_gravity));
        singles_store(lists->fixed_single[23], singles_add(singles_mul(KS(0.0001220703125), _p_ball_radius), singles_mul(KS(0.0001220703125), _p_wire_radius)));
        singles_store(lists->fixed_single[24], singles_mul(KS(9.5367431640625e-07), _s2));
        singles_store(lists->fixed_single[25], singles_add(singles_mul(KS(0.000244140625), _p_ball_radius), singles_mul(KS(0.000244140625), _p_wire_radius)));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f1)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->p_board_thickness + i);
    const V p_board_top = lanes_load(lists->p_board_top + i);
    const V p_bridge_depth = lanes_load(lists->p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + i);
    const V p_end_depth = lanes_load(lists->p_end_depth + i);
    const V p_ring_radius = lanes_load(lists->p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->p_wire_radius + i);
    {
        const V _s0 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_abs(p_ball_radius), lanes_abs(p_board_bottom)), lanes_abs(p_board_distance)), lanes_abs(p_board_half_width)), lanes_abs(p_board_thickness)), lanes_abs(p_board_top));
        const V _s1 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s0, lanes_abs(p_bridge_depth)), lanes_abs(p_bridge_half_width)), lanes_abs(p_end_depth)), lanes_abs(p_ring_radius)), lanes_abs(p_wire_radius));
        const V _s2 = lanes_mul(K(0.5), p_board_thickness);
        const V _s3 = lanes_mul(K(0.5), p_board_distance);
        const V _s4 = lanes_mul(K(0.5), p_ring_radius);
        const V _s5 = lanes_add(p_ball_radius, p_wire_radius);
        lanes_store(lists->fixed[0], _s1);
        lanes_store(lists->fixed[1], lanes_add(lanes_add(p_ball_radius, p_ring_radius), p_wire_radius));
        lanes_store(lists->fixed[2], lanes_neg(lanes_add(p_board_distance, _s2)));
        lanes_store(lists->fixed[3], lanes_add(p_ball_radius, _s2));
        lanes_store(lists->fixed[4], lanes_neg(lanes_add(_s3, _s4)));
        lanes_store(lists->fixed[5], lanes_sub(lanes_add(p_ball_radius, _s3), _s4));
        lanes_store(lists->fixed[6], p_ball_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[14], lanes_mul(_s5, _s5));
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[17], lanes_add(lanes_mul(K(4.0), p_ball_radius), lanes_mul(K(4.0), p_wire_radius)));
        lanes_store(lists->fixed[18], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[19], lanes_mul(p_ring_radius, p_ring_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f8)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->p_ball_radius + i);
    const V p_end_depth = lanes_load(lists->p_end_depth + i);
    const V p_gravity = lanes_load(lists->p_gravity + i);
    const V p_ring_radius = lanes_load(lists->p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_div(K(1.0), p_gravity);
        const V _s2 = lanes_neg(_s1);
        const V _s3 = lanes_mul(K(1.00006103515625), _s0);
        const V _s4 = lanes_add(p_ring_radius, _s3);
        const V _s5 = lanes_mul(_s4, _s4);
        const V _s6 = lanes_mul(K(9.313225746154785e-10), _s5);
        const V _s7 = lanes_sub(p_ring_radius, _s3);
        const V _s8 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s9 = lanes_max(_s7, _s8);
        const V _s10 = lanes_mul(_s9, _s9);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[14], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[18], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[20], _s1);
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[22], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[23], lanes_neg(p_gravity));
        lanes_store(lists->fixed[24], _s2);
        lanes_store(lists->fixed[25], lanes_mul(K(0.5), _s2));
        lanes_store(lists->fixed[26], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s0)));
        lanes_store(lists->fixed[27], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[28], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[29], _s3);
        lanes_store(lists->fixed[30], lanes_mul(K(5.820766091346741e-11), _s4));
        lanes_store(lists->fixed[31], lanes_mul(K(65536.0), _s4));
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[33], _s5);
        lanes_store(lists->fixed[34], _s6);
        lanes_store(lists->fixed[35], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[36], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s0));
        lanes_store(lists->fixed[37], _s10);
        lanes_store(lists->fixed[38], lanes_mul(_s9, _s10));
        lanes_store(lists->fixed[39], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[40], lanes_add(_s6, _s10));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f23)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->open_p_ball_radius + i);
    const V p_gravity = lanes_load(lists->open_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->open_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->open_p_wire_radius + i);
    {
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
    }
    {
        const S _p_ball_radius = lanes_narrow(p_ball_radius);
        const S _p_ring_radius = lanes_narrow(p_ring_radius);
        const S _p_wire_radius = lanes_narrow(p_wire_radius);
        const S _p_gravity = lanes_narrow(p_gravity);
        const S _s0 = singles_add(_p_ball_radius, _p_wire_radius);
        const S _s1 = singles_mul(KS(1.00006103515625), _s0);
        const S _s2 = singles_add(_p_ring_radius, _s1);
        const S _s3 = singles_sub(_p_ring_radius, _s1);
        const S _s4 = singles_mul(KS(0.0001220703125), _p_ring_radius);
        const S _s5 = singles_max(_s3, _s4);
        const S _s6 = singles_div(_s0, _s5);
        const S _s7 = singles_max(KS(1.0), _s6);
        const S _s8 = singles_div(KS(1.0), _s5);
        singles_store(lists->fixed_single[0], _p_gravity);
        singles_store(lists->fixed_single[1], _s1);
        singles_store(lists->fixed_single[2], singles_mul(KS(2.0), _p_gravity));
        singles_store(lists->fixed_single[3], singles_div(KS(1.0), _p_gravity));
        singles_store(lists->fixed_single[4], _s2);
        singles_store(lists->fixed_single[5], singles_mul(_s2, _s2));
        singles_store(lists->fixed_single[6], _s5);
        singles_store(lists->fixed_single[7], singles_mul(_s5, _s5));
        singles_store(lists->fixed_single[8], singles_mul(KS(32.0), _s5));
        singles_store(lists->fixed_single[9], singles_add(singles_mul(KS(32.0), _p_ball_radius), singles_mul(KS(32.0), _p_wire_radius)));
        singles_store(lists->fixed_single[10], _s0);
        singles_store(lists->fixed_single[11], _s7);
        singles_store(lists->fixed_single[12], singles_mul(KS(4.0), _p_gravity));
        singles_store(lists->fixed_single[13], singles_mul(KS(2.0), _p_ring_radius));
        singles_store(lists->fixed_single[14], singles_mul(singles_mul(KS(6.0003662109375), _p_gravity), _s0));
        singles_store(lists->fixed_single[15], singles_mul(_s8, singles_mul(_s8, _s8)));
        singles_store(lists->fixed_single[16], singles_mul(KS(5.0048828125), _s0));
        singles_store(lists->fixed_single[17], singles_mul(KS(7.62939453125e-06), singles_mul(singles_div(_s2, _s5), _s7)));
        singles_store(lists->fixed_single[18], singles_add(singles_mul(KS(128.0), _p_ball_radius), singles_mul(KS(128.0), _p_wire_radius)));
        singles_store(lists->fixed_single[19], _p_ring_radius);
        singles_store(lists->fixed_single[20], singles_mul(KS(0.5), _p_gravity));
        singles_store(lists->fixed_single[21], singles_mul(_s0, _s0));
        singles_store(lists->fixed_single[22], singles_mul(KS(6.0), _p_gravity));
        singles_store(lists->fixed_single[23], singles_add(singles_mul(KS(0.0001220703125), _p_ball_radius), singles_mul(KS(0.0001220703125), _p_wire_radius)));
        singles_store(lists->fixed_single[24], singles_mul(KS(9.5367431640625e-07), _s2));
        singles_store(lists->fixed_single[25], singles_add(singles_mul(KS(0.000244140625), _p_ball_radius), singles_mul(KS(0.000244140625), _p_wire_radius)));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f34)(LANES(court_plain_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->open_leaping_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_gravity = lanes_expand(lists->open_leaping_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    const V p_ring_radius = lanes_expand(lists->open_leaping_p_ring_radius + taken, idle, lanes_load(lists->turning_p_ring_radius));
    const V p_wire_radius = lanes_expand(lists->open_leaping_p_wire_radius + taken, idle, lanes_load(lists->turning_p_wire_radius));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_gravity, p_gravity);
    lanes_store(lists->turning_p_ring_radius, p_ring_radius);
    lanes_store(lists->turning_p_wire_radius, p_wire_radius);
    {
        const S _p_ball_radius = lanes_narrow(p_ball_radius);
        const S _p_ring_radius = lanes_narrow(p_ring_radius);
        const S _p_wire_radius = lanes_narrow(p_wire_radius);
        const S _p_gravity = lanes_narrow(p_gravity);
        const S _s0 = singles_add(_p_ball_radius, _p_wire_radius);
        const S _s1 = singles_mul(KS(1.00006103515625), _s0);
        const S _s2 = singles_sub(_p_ring_radius, _s1);
        const S _s3 = singles_mul(KS(0.0001220703125), _p_ring_radius);
        singles_store(lists->fixed_single[0], _p_gravity);
        singles_store(lists->fixed_single[1], _s1);
        singles_store(lists->fixed_single[6], singles_max(_s2, _s3));
        singles_store(lists->fixed_single[19], _p_ring_radius);
        singles_store(lists->fixed_single[20], singles_mul(KS(0.5), _p_gravity));
        singles_store(lists->fixed_single[21], singles_mul(_s0, _s0));
        singles_store(lists->fixed_single[22], singles_mul(KS(6.0), _p_gravity));
        singles_store(lists->fixed_single[23], singles_add(singles_mul(KS(0.0001220703125), _p_ball_radius), singles_mul(KS(0.0001220703125), _p_wire_radius)));
        singles_store(lists->fixed_single[24], singles_mul(KS(9.5367431640625e-07), singles_add(_p_ring_radius, _s1)));
        singles_store(lists->fixed_single[25], singles_add(singles_mul(KS(0.000244140625), _p_ball_radius), singles_mul(KS(0.000244140625), _p_wire_radius)));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f37)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->open_searching_p_ball_radius + i);
    const V p_gravity = lanes_load(lists->open_searching_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->open_searching_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->open_searching_p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_mul(K(1.00006103515625), _s0);
        const V _s2 = lanes_add(p_ring_radius, _s1);
        const V _s3 = lanes_sub(p_ring_radius, _s1);
        const V _s4 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s5 = lanes_max(_s3, _s4);
        const V _s6 = lanes_div(K(1.0), _s5);
        const V _s7 = lanes_div(_s1, _s5);
        lanes_store(lists->fixed[20], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[22], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[26], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s0)));
        lanes_store(lists->fixed[27], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[28], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[29], _s1);
        lanes_store(lists->fixed[33], lanes_mul(_s2, _s2));
        lanes_store(lists->fixed[35], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[36], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s0));
        lanes_store(lists->fixed[37], lanes_mul(_s5, _s5));
        lanes_store(lists->fixed[39], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[41], lanes_mul(_s6, lanes_mul(_s6, _s6)));
        lanes_store(lists->fixed[42], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[43], lanes_mul(K(2.0), p_ball_radius));
        lanes_store(lists->fixed[44], lanes_mul(K(2.0), p_wire_radius));
        lanes_store(lists->fixed[45], _s2);
        lanes_store(lists->fixed[46], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s0), _s2));
        lanes_store(lists->fixed[47], lanes_mul(K(5.00030517578125), _s0));
        lanes_store(lists->fixed[48], lanes_max(K(1.0), _s7));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f42)(LANES(court_plain_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->open_searching_searching_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_gravity = lanes_expand(lists->open_searching_searching_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    const V p_ring_radius = lanes_expand(lists->open_searching_searching_p_ring_radius + taken, idle, lanes_load(lists->turning_p_ring_radius));
    const V p_wire_radius = lanes_expand(lists->open_searching_searching_p_wire_radius + taken, idle, lanes_load(lists->turning_p_wire_radius));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_gravity, p_gravity);
    lanes_store(lists->turning_p_ring_radius, p_ring_radius);
    lanes_store(lists->turning_p_wire_radius, p_wire_radius);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_mul(K(1.00006103515625), _s0);
        const V _s2 = lanes_add(p_ring_radius, _s1);
        const V _s3 = lanes_sub(p_ring_radius, _s1);
        const V _s4 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s5 = lanes_max(_s3, _s4);
        const V _s6 = lanes_div(_s1, _s5);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[14], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[29], _s1);
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[45], _s2);
        lanes_store(lists->fixed[46], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s0), _s2));
        lanes_store(lists->fixed[47], lanes_mul(K(5.00030517578125), _s0));
        lanes_store(lists->fixed[48], lanes_max(K(1.0), _s6));
        lanes_store(lists->fixed[49], lanes_mul(K(6.0), p_gravity));
        lanes_store(lists->fixed[50], lanes_mul(K(9.094947017729282e-13), _s2));
        lanes_store(lists->fixed[51], _s5);
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f53)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->open_p_ball_radius + i);
    const V p_gravity = lanes_load(lists->open_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->open_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->open_p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[14], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f62)(LANES(court_plain_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->open_refining_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_gravity = lanes_expand(lists->open_refining_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    const V p_ring_radius = lanes_expand(lists->open_refining_p_ring_radius + taken, idle, lanes_load(lists->turning_p_ring_radius));
    const V p_wire_radius = lanes_expand(lists->open_refining_p_wire_radius + taken, idle, lanes_load(lists->turning_p_wire_radius));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_gravity, p_gravity);
    lanes_store(lists->turning_p_ring_radius, p_ring_radius);
    lanes_store(lists->turning_p_wire_radius, p_wire_radius);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[14], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f67)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->p_board_thickness + i);
    const V p_board_top = lanes_load(lists->p_board_top + i);
    const V p_gravity = lanes_load(lists->p_gravity + i);
    {
        const V _s0 = lanes_mul(K(0.5), p_board_thickness);
        const V _s1 = lanes_mul(K(0.5), p_board_bottom);
        const V _s2 = lanes_mul(K(0.5), p_board_top);
        lanes_store(lists->fixed[2], lanes_neg(lanes_add(p_board_distance, _s0)));
        lanes_store(lists->fixed[20], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[52], lanes_abs(K(0.0)));
        lanes_store(lists->fixed[53], lanes_mul(K(0.0625), p_gravity));
        lanes_store(lists->fixed[54], lanes_mul(K(1.0000000009313226), lanes_mul(p_ball_radius, p_ball_radius)));
        lanes_store(lists->fixed[55], lanes_mul(K(1.0000000009313226), _s0));
        lanes_store(lists->fixed[56], lanes_mul(K(1.0000000009313226), p_board_half_width));
        lanes_store(lists->fixed[57], lanes_add(_s1, _s2));
        lanes_store(lists->fixed[58], lanes_mul(K(1.0000000009313226), lanes_sub(_s2, _s1)));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f72)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->reachable_p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->reachable_p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->reachable_p_board_thickness + i);
    const V p_board_top = lanes_load(lists->reachable_p_board_top + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    {
        const V _s0 = lanes_mul(K(0.5), p_board_thickness);
        const V _s1 = lanes_add(p_ball_radius, _s0);
        const V _s2 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s3 = lanes_mul(K(0.5), p_board_bottom);
        const V _s4 = lanes_mul(K(0.5), p_board_top);
        const V _s5 = lanes_add(p_ball_radius, _s4);
        const V _s6 = lanes_sub(_s5, _s3);
        const V _s7 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s8 = lanes_min(_s7, _s1);
        const V _s9 = lanes_min(_s6, _s8);
        const V _s10 = lanes_mul(K(6.103515625e-05), _s9);
        const V _s11 = lanes_abs(lanes_neg(p_gravity));
        const V _s12 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s9));
        const V _s13 = lanes_max(_s1, _s7);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[20], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[22], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[42], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[59], _s4);
        lanes_store(lists->fixed[60], _s3);
        lanes_store(lists->fixed[61], _s9);
        lanes_store(lists->fixed[62], lanes_add(_s1, _s10));
        lanes_store(lists->fixed[63], lanes_add(p_board_distance, _s0));
        lanes_store(lists->fixed[64], lanes_add(_s7, _s10));
        lanes_store(lists->fixed[65], lanes_sub(lanes_add(_s5, _s10), _s3));
        lanes_store(lists->fixed[66], lanes_mul(lanes_mul(K(1.25), _s11), _s12));
        lanes_store(lists->fixed[67], lanes_abs(lanes_add(_s3, _s4)));
        lanes_store(lists->fixed[68], lanes_max(_s13, _s6));
        lanes_store(lists->fixed[69], lanes_mul(K(1.52587890625e-05), _s9));
        lanes_store(lists->fixed[70], lanes_mul(K(5.55653613398821e-16), _s2));
        lanes_store(lists->fixed[71], _s12);
        lanes_store(lists->fixed[72], lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        lanes_store(lists->fixed[73], lanes_mul(K(2.001953125), _s12));
        lanes_store(lists->fixed[74], lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        lanes_store(lists->fixed[75], lanes_add(lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_bottom)), lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_top))));
        lanes_store(lists->fixed[76], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s12, _s12)));
        lanes_store(lists->fixed[77], lanes_mul(K(12.01171875), _s12));
        lanes_store(lists->fixed[78], lanes_mul(K(6.667843360785852e-15), _s12));
        lanes_store(lists->fixed[79], lanes_mul(K(6.005859375), _s12));
        lanes_store(lists->fixed[80], lanes_mul(K(2.667137344314341e-15), _s12));
        lanes_store(lists->fixed[81], _s2);
        lanes_store(lists->fixed[82], _s11);
        lanes_store(lists->fixed[83], lanes_mul(K(0.5), _s11));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f90)(LANES(court_plain_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->reachable_searching_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_board_bottom = lanes_expand(lists->reachable_searching_p_board_bottom + taken, idle, lanes_load(lists->turning_p_board_bottom));
    const V p_board_distance = lanes_expand(lists->reachable_searching_p_board_distance + taken, idle, lanes_load(lists->turning_p_board_distance));
    const V p_board_half_width = lanes_expand(lists->reachable_searching_p_board_half_width + taken, idle, lanes_load(lists->turning_p_board_half_width));
    const V p_board_thickness = lanes_expand(lists->reachable_searching_p_board_thickness + taken, idle, lanes_load(lists->turning_p_board_thickness));
    const V p_board_top = lanes_expand(lists->reachable_searching_p_board_top + taken, idle, lanes_load(lists->turning_p_board_top));
    const V p_gravity = lanes_expand(lists->reachable_searching_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_board_bottom, p_board_bottom);
    lanes_store(lists->turning_p_board_distance, p_board_distance);
    lanes_store(lists->turning_p_board_half_width, p_board_half_width);
    lanes_store(lists->turning_p_board_thickness, p_board_thickness);
    lanes_store(lists->turning_p_board_top, p_board_top);
    lanes_store(lists->turning_p_gravity, p_gravity);
    {
        const V _s0 = lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_thickness));
        const V _s1 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s2 = lanes_sub(lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_top)), lanes_mul(K(0.5), p_board_bottom));
        const V _s3 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s4 = lanes_min(_s3, _s0);
        const V _s5 = lanes_abs(lanes_neg(p_gravity));
        const V _s6 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), lanes_min(_s2, _s4)));
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[70], lanes_mul(K(5.55653613398821e-16), _s1));
        lanes_store(lists->fixed[71], _s6);
        lanes_store(lists->fixed[72], lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        lanes_store(lists->fixed[73], lanes_mul(K(2.001953125), _s6));
        lanes_store(lists->fixed[74], lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        lanes_store(lists->fixed[75], lanes_add(lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_bottom)), lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_top))));
        lanes_store(lists->fixed[76], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s6, _s6)));
        lanes_store(lists->fixed[77], lanes_mul(K(12.01171875), _s6));
        lanes_store(lists->fixed[78], lanes_mul(K(6.667843360785852e-15), _s6));
        lanes_store(lists->fixed[79], lanes_mul(K(6.005859375), _s6));
        lanes_store(lists->fixed[80], lanes_mul(K(2.667137344314341e-15), _s6));
        lanes_store(lists->fixed[81], _s1);
        lanes_store(lists->fixed[82], _s5);
        lanes_store(lists->fixed[83], lanes_mul(K(0.5), _s5));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f101)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->reachable_p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->reachable_p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->reachable_p_board_thickness + i);
    const V p_board_top = lanes_load(lists->reachable_p_board_top + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    {
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[81], lanes_mul(p_ball_radius, p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f110)(LANES(court_plain_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->reachable_refining_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_board_bottom = lanes_expand(lists->reachable_refining_p_board_bottom + taken, idle, lanes_load(lists->turning_p_board_bottom));
    const V p_board_distance = lanes_expand(lists->reachable_refining_p_board_distance + taken, idle, lanes_load(lists->turning_p_board_distance));
    const V p_board_half_width = lanes_expand(lists->reachable_refining_p_board_half_width + taken, idle, lanes_load(lists->turning_p_board_half_width));
    const V p_board_thickness = lanes_expand(lists->reachable_refining_p_board_thickness + taken, idle, lanes_load(lists->turning_p_board_thickness));
    const V p_board_top = lanes_expand(lists->reachable_refining_p_board_top + taken, idle, lanes_load(lists->turning_p_board_top));
    const V p_gravity = lanes_expand(lists->reachable_refining_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_board_bottom, p_board_bottom);
    lanes_store(lists->turning_p_board_distance, p_board_distance);
    lanes_store(lists->turning_p_board_half_width, p_board_half_width);
    lanes_store(lists->turning_p_board_thickness, p_board_thickness);
    lanes_store(lists->turning_p_board_top, p_board_top);
    lanes_store(lists->turning_p_gravity, p_gravity);
    {
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[81], lanes_mul(p_ball_radius, p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f115)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->p_ball_radius + i);
    const V p_board_distance = lanes_load(lists->p_board_distance + i);
    const V p_bridge_depth = lanes_load(lists->p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + i);
    const V p_gravity = lanes_load(lists->p_gravity + i);
    const V p_ring_radius = lanes_load(lists->p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->p_wire_radius + i);
    {
        const V _s0 = lanes_mul(K(0.5), p_board_distance);
        const V _s1 = lanes_mul(K(0.5), p_ring_radius);
        const V _s2 = lanes_mul(K(0.5), p_bridge_depth);
        lanes_store(lists->fixed[4], lanes_neg(lanes_add(_s0, _s1)));
        lanes_store(lists->fixed[20], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[52], lanes_abs(K(0.0)));
        lanes_store(lists->fixed[53], lanes_mul(K(0.0625), p_gravity));
        lanes_store(lists->fixed[54], lanes_mul(K(1.0000000009313226), lanes_mul(p_ball_radius, p_ball_radius)));
        lanes_store(lists->fixed[84], lanes_mul(K(1.0000000009313226), lanes_sub(_s0, _s1)));
        lanes_store(lists->fixed[85], lanes_mul(K(1.0000000009313226), p_bridge_half_width));
        lanes_store(lists->fixed[86], lanes_sub(p_wire_radius, _s2));
        lanes_store(lists->fixed[87], lanes_mul(K(1.0000000009313226), _s2));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f120)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_bridge_depth = lanes_load(lists->reachable_p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->reachable_p_bridge_half_width + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->reachable_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->reachable_p_wire_radius + i);
    {
        const V _s0 = lanes_mul(K(0.5), p_board_distance);
        const V _s1 = lanes_mul(K(0.5), p_ring_radius);
        const V _s2 = lanes_add(p_ball_radius, _s0);
        const V _s3 = lanes_sub(_s2, _s1);
        const V _s4 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s5 = lanes_abs(lanes_neg(p_gravity));
        const V _s6 = lanes_mul(K(0.5), p_bridge_depth);
        const V _s7 = lanes_add(p_ball_radius, _s6);
        const V _s8 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s9 = lanes_min(_s8, _s3);
        const V _s10 = lanes_min(_s7, _s9);
        const V _s11 = lanes_mul(K(6.103515625e-05), _s10);
        const V _s12 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s10));
        const V _s13 = lanes_max(_s3, _s8);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[20], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[22], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[42], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[70], lanes_mul(K(5.55653613398821e-16), _s4));
        lanes_store(lists->fixed[81], _s4);
        lanes_store(lists->fixed[82], _s5);
        lanes_store(lists->fixed[83], lanes_mul(K(0.5), _s5));
        lanes_store(lists->fixed[88], _s0);
        lanes_store(lists->fixed[89], _s6);
        lanes_store(lists->fixed[90], _s1);
        lanes_store(lists->fixed[91], _s10);
        lanes_store(lists->fixed[92], lanes_sub(lanes_add(_s2, _s11), _s1));
        lanes_store(lists->fixed[93], lanes_add(_s0, _s1));
        lanes_store(lists->fixed[94], lanes_add(_s8, _s11));
        lanes_store(lists->fixed[95], lanes_add(_s7, _s11));
        lanes_store(lists->fixed[96], lanes_mul(lanes_mul(K(1.25), _s5), _s12));
        lanes_store(lists->fixed[97], lanes_abs(lanes_sub(_s6, p_wire_radius)));
        lanes_store(lists->fixed[98], lanes_max(_s13, _s7));
        lanes_store(lists->fixed[99], lanes_mul(K(1.52587890625e-05), _s10));
        lanes_store(lists->fixed[100], _s12);
        lanes_store(lists->fixed[101], lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        lanes_store(lists->fixed[102], lanes_mul(K(2.001953125), _s12));
        lanes_store(lists->fixed[103], lanes_add(lanes_mul(K(1.1102230246251565e-16), p_board_distance), lanes_mul(K(1.1102230246251565e-16), p_ring_radius)));
        lanes_store(lists->fixed[104], lanes_add(lanes_mul(K(2.220446049250313e-16), p_bridge_depth), lanes_mul(K(5.551115123125783e-16), p_wire_radius)));
        lanes_store(lists->fixed[105], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s12, _s12)));
        lanes_store(lists->fixed[106], lanes_mul(K(12.01171875), _s12));
        lanes_store(lists->fixed[107], lanes_mul(K(6.667843360785852e-15), _s12));
        lanes_store(lists->fixed[108], lanes_mul(K(6.005859375), _s12));
        lanes_store(lists->fixed[109], lanes_mul(K(2.667137344314341e-15), _s12));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f138)(LANES(court_plain_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->reachable_searching_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_board_distance = lanes_expand(lists->reachable_searching_p_board_distance + taken, idle, lanes_load(lists->turning_p_board_distance));
    const V p_bridge_depth = lanes_expand(lists->reachable_searching_p_bridge_depth + taken, idle, lanes_load(lists->turning_p_bridge_depth));
    const V p_bridge_half_width = lanes_expand(lists->reachable_searching_p_bridge_half_width + taken, idle, lanes_load(lists->turning_p_bridge_half_width));
    const V p_gravity = lanes_expand(lists->reachable_searching_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    const V p_ring_radius = lanes_expand(lists->reachable_searching_p_ring_radius + taken, idle, lanes_load(lists->turning_p_ring_radius));
    const V p_wire_radius = lanes_expand(lists->reachable_searching_p_wire_radius + taken, idle, lanes_load(lists->turning_p_wire_radius));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_board_distance, p_board_distance);
    lanes_store(lists->turning_p_bridge_depth, p_bridge_depth);
    lanes_store(lists->turning_p_bridge_half_width, p_bridge_half_width);
    lanes_store(lists->turning_p_gravity, p_gravity);
    lanes_store(lists->turning_p_ring_radius, p_ring_radius);
    lanes_store(lists->turning_p_wire_radius, p_wire_radius);
    {
        const V _s0 = lanes_sub(lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_distance)), lanes_mul(K(0.5), p_ring_radius));
        const V _s1 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s2 = lanes_abs(lanes_neg(p_gravity));
        const V _s3 = lanes_add(p_ball_radius, lanes_mul(K(0.5), p_bridge_depth));
        const V _s4 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s5 = lanes_min(_s4, _s0);
        const V _s6 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), lanes_min(_s3, _s5)));
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[70], lanes_mul(K(5.55653613398821e-16), _s1));
        lanes_store(lists->fixed[81], _s1);
        lanes_store(lists->fixed[82], _s2);
        lanes_store(lists->fixed[83], lanes_mul(K(0.5), _s2));
        lanes_store(lists->fixed[100], _s6);
        lanes_store(lists->fixed[101], lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        lanes_store(lists->fixed[102], lanes_mul(K(2.001953125), _s6));
        lanes_store(lists->fixed[103], lanes_add(lanes_mul(K(1.1102230246251565e-16), p_board_distance), lanes_mul(K(1.1102230246251565e-16), p_ring_radius)));
        lanes_store(lists->fixed[104], lanes_add(lanes_mul(K(2.220446049250313e-16), p_bridge_depth), lanes_mul(K(5.551115123125783e-16), p_wire_radius)));
        lanes_store(lists->fixed[105], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s6, _s6)));
        lanes_store(lists->fixed[106], lanes_mul(K(12.01171875), _s6));
        lanes_store(lists->fixed[107], lanes_mul(K(6.667843360785852e-15), _s6));
        lanes_store(lists->fixed[108], lanes_mul(K(6.005859375), _s6));
        lanes_store(lists->fixed[109], lanes_mul(K(2.667137344314341e-15), _s6));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f149)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_bridge_depth = lanes_load(lists->reachable_p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->reachable_p_bridge_half_width + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->reachable_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->reachable_p_wire_radius + i);
    {
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[81], lanes_mul(p_ball_radius, p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f158)(LANES(court_plain_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->reachable_refining_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_board_distance = lanes_expand(lists->reachable_refining_p_board_distance + taken, idle, lanes_load(lists->turning_p_board_distance));
    const V p_bridge_depth = lanes_expand(lists->reachable_refining_p_bridge_depth + taken, idle, lanes_load(lists->turning_p_bridge_depth));
    const V p_bridge_half_width = lanes_expand(lists->reachable_refining_p_bridge_half_width + taken, idle, lanes_load(lists->turning_p_bridge_half_width));
    const V p_gravity = lanes_expand(lists->reachable_refining_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    const V p_ring_radius = lanes_expand(lists->reachable_refining_p_ring_radius + taken, idle, lanes_load(lists->turning_p_ring_radius));
    const V p_wire_radius = lanes_expand(lists->reachable_refining_p_wire_radius + taken, idle, lanes_load(lists->turning_p_wire_radius));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_board_distance, p_board_distance);
    lanes_store(lists->turning_p_bridge_depth, p_bridge_depth);
    lanes_store(lists->turning_p_bridge_half_width, p_bridge_half_width);
    lanes_store(lists->turning_p_gravity, p_gravity);
    lanes_store(lists->turning_p_ring_radius, p_ring_radius);
    lanes_store(lists->turning_p_wire_radius, p_wire_radius);
    {
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[81], lanes_mul(p_ball_radius, p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f166)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->kept_p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->kept_p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->kept_p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->kept_p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->kept_p_board_thickness + i);
    const V p_board_top = lanes_load(lists->kept_p_board_top + i);
    const V p_bridge_depth = lanes_load(lists->kept_p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->kept_p_bridge_half_width + i);
    const V p_ring_radius = lanes_load(lists->kept_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->kept_p_wire_radius + i);
    {
        lanes_store(lists->fixed[6], p_ball_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[110], lanes_div(K(1.0), lanes_add(p_ball_radius, p_wire_radius)));
        lanes_store(lists->fixed[111], lanes_div(K(1.0), p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f192)(LANES(court_plain_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->kept_rolling_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_board_bottom = lanes_expand(lists->kept_rolling_p_board_bottom + taken, idle, lanes_load(lists->turning_p_board_bottom));
    const V p_board_distance = lanes_expand(lists->kept_rolling_p_board_distance + taken, idle, lanes_load(lists->turning_p_board_distance));
    const V p_board_half_width = lanes_expand(lists->kept_rolling_p_board_half_width + taken, idle, lanes_load(lists->turning_p_board_half_width));
    const V p_board_thickness = lanes_expand(lists->kept_rolling_p_board_thickness + taken, idle, lanes_load(lists->turning_p_board_thickness));
    const V p_board_top = lanes_expand(lists->kept_rolling_p_board_top + taken, idle, lanes_load(lists->turning_p_board_top));
    const V p_bridge_depth = lanes_expand(lists->kept_rolling_p_bridge_depth + taken, idle, lanes_load(lists->turning_p_bridge_depth));
    const V p_bridge_half_width = lanes_expand(lists->kept_rolling_p_bridge_half_width + taken, idle, lanes_load(lists->turning_p_bridge_half_width));
    const V p_end_depth = lanes_expand(lists->kept_rolling_p_end_depth + taken, idle, lanes_load(lists->turning_p_end_depth));
    const V p_gravity = lanes_expand(lists->kept_rolling_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    const V p_ring_radius = lanes_expand(lists->kept_rolling_p_ring_radius + taken, idle, lanes_load(lists->turning_p_ring_radius));
    const V p_wire_radius = lanes_expand(lists->kept_rolling_p_wire_radius + taken, idle, lanes_load(lists->turning_p_wire_radius));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_board_bottom, p_board_bottom);
    lanes_store(lists->turning_p_board_distance, p_board_distance);
    lanes_store(lists->turning_p_board_half_width, p_board_half_width);
    lanes_store(lists->turning_p_board_thickness, p_board_thickness);
    lanes_store(lists->turning_p_board_top, p_board_top);
    lanes_store(lists->turning_p_bridge_depth, p_bridge_depth);
    lanes_store(lists->turning_p_bridge_half_width, p_bridge_half_width);
    lanes_store(lists->turning_p_end_depth, p_end_depth);
    lanes_store(lists->turning_p_gravity, p_gravity);
    lanes_store(lists->turning_p_ring_radius, p_ring_radius);
    lanes_store(lists->turning_p_wire_radius, p_wire_radius);
    {
        const V _s0 = lanes_mul(K(1.4210854715202004e-14), p_ball_radius);
        const V _s1 = lanes_add(lanes_add(_s0, lanes_mul(K(2.842170943040401e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_board_thickness));
        const V _s2 = lanes_add(_s0, lanes_mul(K(2.842170943040401e-14), p_board_half_width));
        const V _s3 = lanes_add(lanes_add(_s0, lanes_mul(K(1.4210854715202004e-14), lanes_abs(p_board_bottom))), lanes_mul(K(1.4210854715202004e-14), lanes_abs(p_board_top)));
        const V _s4 = lanes_add(lanes_add(_s0, lanes_mul(K(1.4210854715202004e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_ring_radius));
        const V _s5 = lanes_add(_s0, lanes_mul(K(2.842170943040401e-14), p_bridge_half_width));
        const V _s6 = lanes_add(lanes_add(_s0, lanes_mul(K(1.4210854715202004e-14), p_wire_radius)), lanes_mul(K(1.4210854715202004e-14), lanes_abs(lanes_sub(p_bridge_depth, p_wire_radius))));
        lanes_store(lists->fixed[6], p_ball_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[18], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[19], lanes_mul(p_ring_radius, p_ring_radius));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[39], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[111], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[112], _s1);
        lanes_store(lists->fixed[113], lanes_neg(_s1));
        lanes_store(lists->fixed[114], _s2);
        lanes_store(lists->fixed[115], lanes_neg(_s2));
        lanes_store(lists->fixed[116], _s3);
        lanes_store(lists->fixed[117], lanes_neg(_s3));
        lanes_store(lists->fixed[118], _s4);
        lanes_store(lists->fixed[119], lanes_neg(_s4));
        lanes_store(lists->fixed[120], _s5);
        lanes_store(lists->fixed[121], lanes_neg(_s5));
        lanes_store(lists->fixed[122], _s6);
        lanes_store(lists->fixed[123], lanes_neg(_s6));
        lanes_store(lists->fixed[124], lanes_mul(K(0.6), p_gravity));
        lanes_store(lists->fixed[125], lanes_mul(K(0.015625), p_gravity));
        lanes_store(lists->fixed[126], lanes_mul(K(0.4), p_gravity));
        lanes_store(lists->fixed[127], lanes_mul(K(5.684341886080802e-14), lanes_sqrt(lanes_mul(p_ball_radius, p_gravity))));
        lanes_store(lists->fixed[128], lanes_mul(K(5.684341886080802e-14), p_gravity));
        lanes_store(lists->fixed[129], lanes_add(p_ball_radius, p_wire_radius));
        lanes_store(lists->fixed[130], lanes_mul(K(3.637978807091713e-12), p_ball_radius));
        lanes_store(lists->fixed[131], p_bridge_depth);
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f268)(LANES(court_plain_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->kept_circling_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_board_bottom = lanes_expand(lists->kept_circling_p_board_bottom + taken, idle, lanes_load(lists->turning_p_board_bottom));
    const V p_board_distance = lanes_expand(lists->kept_circling_p_board_distance + taken, idle, lanes_load(lists->turning_p_board_distance));
    const V p_board_half_width = lanes_expand(lists->kept_circling_p_board_half_width + taken, idle, lanes_load(lists->turning_p_board_half_width));
    const V p_board_thickness = lanes_expand(lists->kept_circling_p_board_thickness + taken, idle, lanes_load(lists->turning_p_board_thickness));
    const V p_board_top = lanes_expand(lists->kept_circling_p_board_top + taken, idle, lanes_load(lists->turning_p_board_top));
    const V p_bridge_depth = lanes_expand(lists->kept_circling_p_bridge_depth + taken, idle, lanes_load(lists->turning_p_bridge_depth));
    const V p_bridge_half_width = lanes_expand(lists->kept_circling_p_bridge_half_width + taken, idle, lanes_load(lists->turning_p_bridge_half_width));
    const V p_end_depth = lanes_expand(lists->kept_circling_p_end_depth + taken, idle, lanes_load(lists->turning_p_end_depth));
    const V p_gravity = lanes_expand(lists->kept_circling_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    const V p_ring_radius = lanes_expand(lists->kept_circling_p_ring_radius + taken, idle, lanes_load(lists->turning_p_ring_radius));
    const V p_wire_radius = lanes_expand(lists->kept_circling_p_wire_radius + taken, idle, lanes_load(lists->turning_p_wire_radius));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_board_bottom, p_board_bottom);
    lanes_store(lists->turning_p_board_distance, p_board_distance);
    lanes_store(lists->turning_p_board_half_width, p_board_half_width);
    lanes_store(lists->turning_p_board_thickness, p_board_thickness);
    lanes_store(lists->turning_p_board_top, p_board_top);
    lanes_store(lists->turning_p_bridge_depth, p_bridge_depth);
    lanes_store(lists->turning_p_bridge_half_width, p_bridge_half_width);
    lanes_store(lists->turning_p_end_depth, p_end_depth);
    lanes_store(lists->turning_p_gravity, p_gravity);
    lanes_store(lists->turning_p_ring_radius, p_ring_radius);
    lanes_store(lists->turning_p_wire_radius, p_wire_radius);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_add(p_board_distance, p_board_thickness);
        const V _s2 = lanes_neg(p_board_half_width);
        const V _s3 = lanes_max(K(0.0), _s2);
        const V _s4 = lanes_max(_s3, _s2);
        const V _s5 = lanes_neg(_s1);
        const V _s6 = lanes_max(K(0.0), _s5);
        const V _s7 = lanes_max(_s6, p_board_distance);
        const V _s8 = lanes_neg(p_board_distance);
        const V _s9 = lanes_max(K(0.0), _s8);
        const V _s10 = lanes_max(_s9, p_ring_radius);
        const V _s11 = lanes_neg(p_bridge_half_width);
        const V _s12 = lanes_max(K(0.0), _s11);
        const V _s13 = lanes_max(_s12, _s11);
        lanes_store(lists->fixed[6], p_ball_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[15], _s1);
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[18], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[19], lanes_mul(p_ring_radius, p_ring_radius));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[90], lanes_mul(K(0.5), p_ring_radius));
        lanes_store(lists->fixed[110], lanes_div(K(1.0), _s0));
        lanes_store(lists->fixed[111], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[125], lanes_mul(K(0.015625), p_gravity));
        lanes_store(lists->fixed[127], lanes_mul(K(5.684341886080802e-14), lanes_sqrt(lanes_mul(p_ball_radius, p_gravity))));
        lanes_store(lists->fixed[128], lanes_mul(K(5.684341886080802e-14), p_gravity));
        lanes_store(lists->fixed[129], _s0);
        lanes_store(lists->fixed[130], lanes_mul(K(3.637978807091713e-12), p_ball_radius));
        lanes_store(lists->fixed[132], lanes_mul(K(0.6), p_ring_radius));
        lanes_store(lists->fixed[133], lanes_mul(K(0.3333333333333333), p_ring_radius));
        lanes_store(lists->fixed[134], lanes_mul(K(0.25), p_ring_radius));
        lanes_store(lists->fixed[135], lanes_mul(K(0.2), p_ring_radius));
        lanes_store(lists->fixed[136], lanes_mul(K(0.16666666666666666), p_ring_radius));
        lanes_store(lists->fixed[137], lanes_mul(K(0.14285714285714285), p_ring_radius));
        lanes_store(lists->fixed[138], lanes_mul(K(0.125), p_ring_radius));
        lanes_store(lists->fixed[139], lanes_mul(K(0.1111111111111111), p_ring_radius));
        lanes_store(lists->fixed[140], lanes_mul(K(0.1), p_ring_radius));
        lanes_store(lists->fixed[141], lanes_mul(K(0.09090909090909091), p_ring_radius));
        lanes_store(lists->fixed[142], lanes_mul(K(0.08333333333333333), p_ring_radius));
        lanes_store(lists->fixed[143], lanes_mul(K(2.2), p_gravity));
        lanes_store(lists->fixed[144], lanes_mul(K(3.0), p_ring_radius));
        lanes_store(lists->fixed[145], lanes_mul(K(6.0), p_ring_radius));
        lanes_store(lists->fixed[146], lanes_mul(K(0.8), p_gravity));
        lanes_store(lists->fixed[147], lanes_sqrt(lanes_add(lanes_mul(_s4, _s4), lanes_mul(_s7, _s7))));
        lanes_store(lists->fixed[148], lanes_sqrt(lanes_add(lanes_mul(_s10, _s10), lanes_mul(_s13, _s13))));
        lanes_store(lists->fixed[149], lanes_mul(K(0.000244140625), _s0));
        lanes_store(lists->fixed[150], lanes_mul(K(0.00390625), p_gravity));
        lanes_store(lists->fixed[151], lanes_mul(lanes_mul(K(0.000244140625), lanes_mul(p_gravity, p_gravity)), _s0));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f313)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->kept_leaves_p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->kept_leaves_p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->kept_leaves_p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->kept_leaves_p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->kept_leaves_p_board_thickness + i);
    const V p_board_top = lanes_load(lists->kept_leaves_p_board_top + i);
    const V p_bridge_depth = lanes_load(lists->kept_leaves_p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->kept_leaves_p_bridge_half_width + i);
    const V p_end_depth = lanes_load(lists->kept_leaves_p_end_depth + i);
    const V p_gravity = lanes_load(lists->kept_leaves_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->kept_leaves_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->kept_leaves_p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_mul(K(1.4210854715202004e-14), p_ball_radius);
        const V _s2 = lanes_add(lanes_add(_s1, lanes_mul(K(2.842170943040401e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_board_thickness));
        const V _s3 = lanes_add(_s1, lanes_mul(K(2.842170943040401e-14), p_board_half_width));
        const V _s4 = lanes_add(lanes_add(_s1, lanes_mul(K(1.4210854715202004e-14), lanes_abs(p_board_bottom))), lanes_mul(K(1.4210854715202004e-14), lanes_abs(p_board_top)));
        const V _s5 = lanes_add(lanes_add(_s1, lanes_mul(K(1.4210854715202004e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_ring_radius));
        const V _s6 = lanes_add(_s1, lanes_mul(K(2.842170943040401e-14), p_bridge_half_width));
        const V _s7 = lanes_add(lanes_add(_s1, lanes_mul(K(1.4210854715202004e-14), p_wire_radius)), lanes_mul(K(1.4210854715202004e-14), lanes_abs(lanes_sub(p_bridge_depth, p_wire_radius))));
        lanes_store(lists->fixed[6], p_ball_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[18], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[22], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[23], lanes_neg(p_gravity));
        lanes_store(lists->fixed[39], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[110], lanes_div(K(1.0), _s0));
        lanes_store(lists->fixed[111], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[112], _s2);
        lanes_store(lists->fixed[113], lanes_neg(_s2));
        lanes_store(lists->fixed[114], _s3);
        lanes_store(lists->fixed[115], lanes_neg(_s3));
        lanes_store(lists->fixed[116], _s4);
        lanes_store(lists->fixed[117], lanes_neg(_s4));
        lanes_store(lists->fixed[118], _s5);
        lanes_store(lists->fixed[119], lanes_neg(_s5));
        lanes_store(lists->fixed[120], _s6);
        lanes_store(lists->fixed[121], lanes_neg(_s6));
        lanes_store(lists->fixed[122], _s7);
        lanes_store(lists->fixed[123], lanes_neg(_s7));
        lanes_store(lists->fixed[128], lanes_mul(K(5.684341886080802e-14), p_gravity));
        lanes_store(lists->fixed[129], _s0);
        lanes_store(lists->fixed[131], p_bridge_depth);
        lanes_store(lists->fixed[152], lanes_mul(K(3.0), p_gravity));
        lanes_store(lists->fixed[153], lanes_mul(K(2.0), lanes_mul(K(3.0), lanes_mul(p_gravity, p_gravity))));
        lanes_store(lists->fixed[154], lanes_mul(K(0.0078125), p_gravity));
        lanes_store(lists->fixed[155], lanes_max(K(0.0), p_gravity));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_leaves)(LANES(court_plain_lists) *lists, size_t kept_leaves_shots, size_t varying)
{
    for (size_t i = 0; i < kept_leaves_shots; i += LANES_WIDTH) {
        const M rows = lanes_first(kept_leaves_shots - i);
        if (LANES_SELDOM(varying))
            LANES(court_plain_fix_f313)(lists, i);
        V held = lanes_load(lists->kept_leaves_held + i);
        V lift = lanes_load(lists->kept_leaves_lift + i);
        V per_reach = lanes_load(lists->kept_leaves_per_reach + i);
        V snap = lanes_load(lists->kept_leaves_snap + i);
        V surge = lanes_load(lists->kept_leaves_surge + i);
        V vx = lanes_load(lists->kept_leaves_vx + i);
        V vy = lanes_load(lists->kept_leaves_vy + i);
        V vz = lanes_load(lists->kept_leaves_vz + i);
        V x = lanes_load(lists->kept_leaves_x + i);
        V y = lanes_load(lists->kept_leaves_y + i);
        V z = lanes_load(lists->kept_leaves_z + i);
        const LANES(court_holding_out) _o314 =
            LANES(court_holding)(held, K(0.0));
        M here = _o314.here;
        const M _m315 = lanes_both(rows, here);
        if (lanes_any(_m315)) {
            const LANES(court_ring_tube_out) _o316 =
                LANES(court_ring_tube)(lanes_load(lists->fixed[110]));
            per_reach = lanes_select(_m315, _o316.per_reach, per_reach);
            const LANES(court_ring_parting_out) _o317 =
                LANES(court_ring_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[152]), lanes_load(lists->fixed[153]));
            lift = lanes_select(_m315, _o317.lift, lift);
            surge = lanes_select(_m315, _o317.surge, surge);
            snap = lanes_select(_m315, _o317.snap, snap);
        }
        const LANES(court_holding_out) _o318 =
            LANES(court_holding)(held, K(1.0));
        here = _o318.here;
        const M _m319 = lanes_both(rows, here);
        if (lanes_any(_m319)) {
            const LANES(court_backboard_tube_out) _o320 =
                LANES(court_backboard_tube)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[113]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[114]), lanes_load(lists->fixed[115]), lanes_load(lists->fixed[116]), lanes_load(lists->fixed[117]), lanes_load(lists->fixed[111]));
            per_reach = lanes_select(_m319, _o320.per_reach, per_reach);
            const LANES(court_backboard_parting_out) _o321 =
                LANES(court_backboard_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[23]));
            lift = lanes_select(_m319, _o321.lift, lift);
            surge = lanes_select(_m319, _o321.surge, surge);
            snap = lanes_select(_m319, _o321.snap, snap);
        }
        const LANES(court_holding_out) _o322 =
            LANES(court_holding)(held, K(2.0));
        here = _o322.here;
        const M _m323 = lanes_both(rows, here);
        if (lanes_any(_m323)) {
            const LANES(court_bridge_tube_out) _o324 =
                LANES(court_bridge_tube)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[118]), lanes_load(lists->fixed[119]), lanes_load(lists->fixed[120]), lanes_load(lists->fixed[121]), lanes_load(lists->fixed[122]), lanes_load(lists->fixed[123]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[111]));
            per_reach = lanes_select(_m323, _o324.per_reach, per_reach);
            const LANES(court_bridge_parting_out) _o325 =
                LANES(court_bridge_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[23]));
            lift = lanes_select(_m323, _o325.lift, lift);
            surge = lanes_select(_m323, _o325.surge, surge);
            snap = lanes_select(_m323, _o325.snap, snap);
        }
        const LANES(court_unmet_out) _o326 =
            LANES(court_unmet)();
        V spare = _o326.spare;
        const LANES(court_beside_out) _o327 =
            LANES(court_beside)(held, K(0.0));
        M beside = _o327.beside;
        const M _m328 = lanes_both(rows, beside);
        if (lanes_any(_m328)) {
            const LANES(court_ring_beside_out) _o329 =
                LANES(court_ring_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[39]), lanes_load(lists->fixed[129]));
            V gap = _o329.gap;
            V nearing = _o329.nearing;
            V dent = _o329.dent;
            const LANES(court_spared_out) _o330 =
                LANES(court_spared)(dent, gap, nearing, spare, vx, vy, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[154]));
            spare = lanes_select(_m328, _o330.spare, spare);
        }
        const LANES(court_beside_out) _o331 =
            LANES(court_beside)(held, K(1.0));
        beside = _o331.beside;
        const M _m332 = lanes_both(rows, beside);
        if (lanes_any(_m332)) {
            const LANES(court_backboard_beside_out) _o333 =
                LANES(court_backboard_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[15]));
            V gap = _o333.gap;
            V nearing = _o333.nearing;
            V dent = _o333.dent;
            const LANES(court_spared_out) _o334 =
                LANES(court_spared)(dent, gap, nearing, spare, vx, vy, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[154]));
            spare = lanes_select(_m332, _o334.spare, spare);
        }
        const LANES(court_beside_out) _o335 =
            LANES(court_beside)(held, K(2.0));
        beside = _o335.beside;
        const M _m336 = lanes_both(rows, beside);
        if (lanes_any(_m336)) {
            const LANES(court_bridge_beside_out) _o337 =
                LANES(court_bridge_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]));
            V gap = _o337.gap;
            V nearing = _o337.nearing;
            V dent = _o337.dent;
            const LANES(court_spared_out) _o338 =
                LANES(court_spared)(dent, gap, nearing, spare, vx, vy, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[154]));
            spare = lanes_select(_m336, _o338.spare, spare);
        }
        const LANES(court_beside_out) _o339 =
            LANES(court_beside)(held, K(3.0));
        beside = _o339.beside;
        const M _m340 = lanes_both(rows, beside);
        if (lanes_any(_m340)) {
            const LANES(court_end_beside_out) _o341 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[18]));
            V gap = _o341.gap;
            V nearing = _o341.nearing;
            V dent = _o341.dent;
            const LANES(court_spared_out) _o342 =
                LANES(court_spared)(dent, gap, nearing, spare, vx, vy, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[154]));
            spare = lanes_select(_m340, _o342.spare, spare);
        }
        const LANES(court_holding_out) _o343 =
            LANES(court_holding)(held, K(1.0));
        here = _o343.here;
        const M _m344 = lanes_both(rows, here);
        if (lanes_any(_m344)) {
            const LANES(court_backboard_seam0_out) _o345 =
                LANES(court_backboard_seam0)(vx, x, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[112]));
            V gap = _o345.gap;
            V nearing = _o345.nearing;
            V near = _o345.near;
            const LANES(court_spared_seam_out) _o346 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[155]));
            spare = lanes_select(_m344, _o346.spare, spare);
            const LANES(court_backboard_seam1_out) _o347 =
                LANES(court_backboard_seam1)(vx, x, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[112]));
            gap = _o347.gap;
            nearing = _o347.nearing;
            near = _o347.near;
            const LANES(court_spared_seam_out) _o348 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[155]));
            spare = lanes_select(_m344, _o348.spare, spare);
            const LANES(court_backboard_seam2_out) _o349 =
                LANES(court_backboard_seam2)(vy, y, lanes_load(lists->fixed[10]), lanes_load(lists->fixed[114]));
            gap = _o349.gap;
            nearing = _o349.nearing;
            near = _o349.near;
            const LANES(court_spared_seam_out) _o350 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[155]));
            spare = lanes_select(_m344, _o350.spare, spare);
            const LANES(court_backboard_seam3_out) _o351 =
                LANES(court_backboard_seam3)(vy, y, lanes_load(lists->fixed[10]), lanes_load(lists->fixed[114]));
            gap = _o351.gap;
            nearing = _o351.nearing;
            near = _o351.near;
            const LANES(court_spared_seam_out) _o352 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[155]));
            spare = lanes_select(_m344, _o352.spare, spare);
            const LANES(court_backboard_seam4_out) _o353 =
                LANES(court_backboard_seam4)(vz, z, lanes_load(lists->fixed[11]), lanes_load(lists->fixed[116]));
            gap = _o353.gap;
            nearing = _o353.nearing;
            near = _o353.near;
            const LANES(court_spared_seam_out) _o354 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[155]));
            spare = lanes_select(_m344, _o354.spare, spare);
            const LANES(court_backboard_seam5_out) _o355 =
                LANES(court_backboard_seam5)(vz, z, lanes_load(lists->fixed[12]), lanes_load(lists->fixed[116]));
            gap = _o355.gap;
            nearing = _o355.nearing;
            near = _o355.near;
            const LANES(court_spared_seam_out) _o356 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[155]));
            spare = lanes_select(_m344, _o356.spare, spare);
        }
        const LANES(court_holding_out) _o357 =
            LANES(court_holding)(held, K(2.0));
        here = _o357.here;
        const M _m358 = lanes_both(rows, here);
        if (lanes_any(_m358)) {
            const LANES(court_bridge_seam0_out) _o359 =
                LANES(court_bridge_seam0)(vx, x, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[118]));
            V gap = _o359.gap;
            V nearing = _o359.nearing;
            V near = _o359.near;
            const LANES(court_spared_seam_out) _o360 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[155]));
            spare = lanes_select(_m358, _o360.spare, spare);
            const LANES(court_bridge_seam1_out) _o361 =
                LANES(court_bridge_seam1)(vx, x, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[118]));
            gap = _o361.gap;
            nearing = _o361.nearing;
            near = _o361.near;
            const LANES(court_spared_seam_out) _o362 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[155]));
            spare = lanes_select(_m358, _o362.spare, spare);
            const LANES(court_bridge_seam2_out) _o363 =
                LANES(court_bridge_seam2)(vy, y, lanes_load(lists->fixed[13]), lanes_load(lists->fixed[120]));
            gap = _o363.gap;
            nearing = _o363.nearing;
            near = _o363.near;
            const LANES(court_spared_seam_out) _o364 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[155]));
            spare = lanes_select(_m358, _o364.spare, spare);
            const LANES(court_bridge_seam3_out) _o365 =
                LANES(court_bridge_seam3)(vy, y, lanes_load(lists->fixed[13]), lanes_load(lists->fixed[120]));
            gap = _o365.gap;
            nearing = _o365.nearing;
            near = _o365.near;
            const LANES(court_spared_seam_out) _o366 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[155]));
            spare = lanes_select(_m358, _o366.spare, spare);
            const LANES(court_bridge_seam4_out) _o367 =
                LANES(court_bridge_seam4)(vz, z, lanes_load(lists->fixed[131]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[122]));
            gap = _o367.gap;
            nearing = _o367.nearing;
            near = _o367.near;
            const LANES(court_spared_seam_out) _o368 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[155]));
            spare = lanes_select(_m358, _o368.spare, spare);
            const LANES(court_bridge_seam5_out) _o369 =
                LANES(court_bridge_seam5)(vz, z, lanes_load(lists->fixed[8]), lanes_load(lists->fixed[122]));
            gap = _o369.gap;
            nearing = _o369.nearing;
            near = _o369.near;
            const LANES(court_spared_seam_out) _o370 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[155]));
            spare = lanes_select(_m358, _o370.spare, spare);
        }
        const LANES(court_parted_out) _o371 =
            LANES(court_parted)(K(INFINITY), lift, per_reach, K(0.0), snap, spare, surge, K(0.0), vx, vy, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[154]), lanes_load(lists->fixed[128]));
        V when = _o371.when;
        const LANES(court_hopping_out) _o372 =
            LANES(court_hopping)();
        V which = _o372.which;
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
        if (LANES_SELDOM(varying))
            LANES(court_plain_fix_f166)(lists, i);
        V circled = lanes_load(lists->kept_circled + i);
        V clock = lanes_load(lists->kept_clock + i);
        V held = lanes_load(lists->kept_held + i);
        V mode = lanes_load(lists->kept_mode + i);
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
        const LANES(court_resumed_out) _o167 =
            LANES(court_resumed)(clock, mode, K(0.0), K(0.0));
        V which = _o167.which;
        V began = _o167.began;
        M begins = _o167.begins;
        M rolling = _o167.rolling;
        M leaves = _o167.leaves;
        V nx = _o167.nx;
        V ny = _o167.ny;
        V nz = _o167.nz;
        V gap = _o167.gap;
        V bent_x = _o167.bent_x;
        V bent_y = _o167.bent_y;
        V bent_z = _o167.bent_z;
        V lift = _o167.lift;
        V surge = _o167.surge;
        V snap = _o167.snap;
        V per_reach = _o167.per_reach;
        const M _m168 = lanes_both(rows, begins);
        if (lanes_any(_m168)) {
            const LANES(court_holding_out) _o169 =
                LANES(court_holding)(held, K(0.0));
            M here = _o169.here;
            const M _m170 = lanes_both(_m168, here);
            {
                const LANES(court_ring_normal_out) _o171 =
                    LANES(court_ring_normal)(x, y, z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[110]));
                nx = lanes_select(_m170, _o171.nx, nx);
                ny = lanes_select(_m170, _o171.ny, ny);
                nz = lanes_select(_m170, _o171.nz, nz);
            }
            const LANES(court_holding_out) _o172 =
                LANES(court_holding)(held, K(1.0));
            here = _o172.here;
            const M _m173 = lanes_both(_m168, here);
            {
                const LANES(court_backboard_normal_out) _o174 =
                    LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[15]));
                nx = lanes_select(_m173, _o174.nx, nx);
                ny = lanes_select(_m173, _o174.ny, ny);
                nz = lanes_select(_m173, _o174.nz, nz);
            }
            const LANES(court_holding_out) _o175 =
                LANES(court_holding)(held, K(2.0));
            here = _o175.here;
            const M _m176 = lanes_both(_m168, here);
            {
                const LANES(court_bridge_normal_out) _o177 =
                    LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[16]));
                nx = lanes_select(_m176, _o177.nx, nx);
                ny = lanes_select(_m176, _o177.ny, ny);
                nz = lanes_select(_m176, _o177.nz, nz);
            }
            const LANES(court_roll_turn_rate_out) _o178 =
                LANES(court_roll_turn_rate)(nx, ny, nz, wx, wy, wz, lanes_load(lists->fixed[6]));
            V turn_rate = _o178.turn_rate;
            const LANES(court_gripped_out) _o179 =
                LANES(court_gripped)(nx, ny, nz, vx, vy, vz, wx, wy, wz, lanes_load(lists->fixed[6]));
            V rolled_x = _o179.rolled_x;
            V rolled_y = _o179.rolled_y;
            V rolled_z = _o179.rolled_z;
            const LANES(court_holding_out) _o180 =
                LANES(court_holding)(held, K(0.0));
            here = _o180.here;
            const M _m181 = lanes_both(_m168, here);
            {
                const LANES(court_ring_off_out) _o182 =
                    LANES(court_ring_off)(x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]));
                gap = lanes_select(_m181, _o182.gap, gap);
            }
            const LANES(court_holding_out) _o183 =
                LANES(court_holding)(held, K(1.0));
            here = _o183.here;
            const M _m184 = lanes_both(_m168, here);
            {
                const LANES(court_backboard_off_out) _o185 =
                    LANES(court_backboard_off)(x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[15]));
                gap = lanes_select(_m184, _o185.gap, gap);
            }
            const LANES(court_holding_out) _o186 =
                LANES(court_holding)(held, K(2.0));
            here = _o186.here;
            const M _m187 = lanes_both(_m168, here);
            {
                const LANES(court_bridge_off_out) _o188 =
                    LANES(court_bridge_off)(x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]));
                gap = lanes_select(_m187, _o188.gap, gap);
            }
            const LANES(court_roll_placed_out) _o189 =
                LANES(court_roll_placed)(gap, nx, ny, nz, turn_rate, rolled_x, rolled_y, rolled_z, x, y, z, lanes_load(lists->fixed[111]));
            x = lanes_select(_m168, _o189.x, x);
            y = lanes_select(_m168, _o189.y, y);
            z = lanes_select(_m168, _o189.z, z);
            vx = lanes_select(_m168, _o189.vx, vx);
            vy = lanes_select(_m168, _o189.vy, vy);
            vz = lanes_select(_m168, _o189.vz, vz);
            wx = lanes_select(_m168, _o189.wx, wx);
            wy = lanes_select(_m168, _o189.wy, wy);
            wz = lanes_select(_m168, _o189.wz, wz);
            const LANES(court_beginning_contact_out) _o190 =
                LANES(court_beginning_contact)();
            which = lanes_select(_m168, _o190.which, which);
            circled = lanes_select(_m168, _o190.circled, circled);
        }
        const LANES(court_circles_out) _o191 =
            LANES(court_circles)(held, K(0.0), rolling);
        M circling = _o191.circling;
        rolling = _o191.rolling;
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
            if (LANES_SELDOM(varying)) {
                lanes_pack(lists->kept_rolling_p_ball_radius + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_ball_radius + i : lists->p_ball_radius));
                lanes_pack(lists->kept_rolling_p_board_bottom + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_board_bottom + i : lists->p_board_bottom));
                lanes_pack(lists->kept_rolling_p_board_distance + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_board_distance + i : lists->p_board_distance));
                lanes_pack(lists->kept_rolling_p_board_half_width + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_board_half_width + i : lists->p_board_half_width));
                lanes_pack(lists->kept_rolling_p_board_thickness + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_board_thickness + i : lists->p_board_thickness));
                lanes_pack(lists->kept_rolling_p_board_top + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_board_top + i : lists->p_board_top));
                lanes_pack(lists->kept_rolling_p_bridge_depth + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_bridge_depth + i : lists->p_bridge_depth));
                lanes_pack(lists->kept_rolling_p_bridge_half_width + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_bridge_half_width + i : lists->p_bridge_half_width));
                lanes_pack(lists->kept_rolling_p_end_depth + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_end_depth + i : lists->p_end_depth));
                lanes_pack(lists->kept_rolling_p_gravity + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_gravity + i : lists->p_gravity));
                lanes_pack(lists->kept_rolling_p_ring_radius + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_ring_radius + i : lists->p_ring_radius));
                lanes_pack(lists->kept_rolling_p_wire_radius + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_wire_radius + i : lists->p_wire_radius));
            }
            kept_rolling_shots += lanes_many(packed);
        }
    }
    {
        size_t taken = 0, busy = 0;
        M active = lanes_nowhere();
        V row = K(0.0), turns = K(0.0);
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
                if (LANES_SELDOM(varying))
                    LANES(court_plain_fix_f192)(lists, taken, idle);
                const size_t room = LANES_WIDTH - busy, left = kept_rolling_shots - taken;
                active = lanes_leading(idle, left, active);
                taken += left < room ? left : room;
                busy += left < room ? left : room;
            }
            if (busy == 0)
                break;
            M rolling = active;
            const LANES(court_holding_out) _o193 =
                LANES(court_holding)(held, K(1.0));
            M here = _o193.here;
            const M _m194 = lanes_both(active, here);
            if (lanes_any(_m194)) {
                const LANES(court_backboard_normal_out) _o195 =
                    LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[15]));
                nx = lanes_select(_m194, _o195.nx, nx);
                ny = lanes_select(_m194, _o195.ny, ny);
                nz = lanes_select(_m194, _o195.nz, nz);
                const LANES(court_backboard_tube_out) _o196 =
                    LANES(court_backboard_tube)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[113]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[114]), lanes_load(lists->fixed[115]), lanes_load(lists->fixed[116]), lanes_load(lists->fixed[117]), lanes_load(lists->fixed[111]));
                bent_x = lanes_select(_m194, _o196.bent_x, bent_x);
                bent_y = lanes_select(_m194, _o196.bent_y, bent_y);
                bent_z = lanes_select(_m194, _o196.bent_z, bent_z);
                per_reach = lanes_select(_m194, _o196.per_reach, per_reach);
            }
            const LANES(court_holding_out) _o197 =
                LANES(court_holding)(held, K(2.0));
            here = _o197.here;
            const M _m198 = lanes_both(active, here);
            if (lanes_any(_m198)) {
                const LANES(court_bridge_normal_out) _o199 =
                    LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[16]));
                nx = lanes_select(_m198, _o199.nx, nx);
                ny = lanes_select(_m198, _o199.ny, ny);
                nz = lanes_select(_m198, _o199.nz, nz);
                const LANES(court_bridge_tube_out) _o200 =
                    LANES(court_bridge_tube)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[118]), lanes_load(lists->fixed[119]), lanes_load(lists->fixed[120]), lanes_load(lists->fixed[121]), lanes_load(lists->fixed[122]), lanes_load(lists->fixed[123]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[111]));
                bent_x = lanes_select(_m198, _o200.bent_x, bent_x);
                bent_y = lanes_select(_m198, _o200.bent_y, bent_y);
                bent_z = lanes_select(_m198, _o200.bent_z, bent_z);
                per_reach = lanes_select(_m198, _o200.per_reach, per_reach);
            }
            const LANES(court_roll_start_out) _o201 =
                LANES(court_roll_start)(nx, ny, nz, vx, vy, vz, wx, wy, wz, lanes_load(lists->fixed[6]));
            V vx_0 = _o201.vx_0;
            V vy_0 = _o201.vy_0;
            V vz_0 = _o201.vz_0;
            V nx_0 = _o201.nx_0;
            V ny_0 = _o201.ny_0;
            V nz_0 = _o201.nz_0;
            V turn_rate_0 = _o201.turn_rate_0;
            const LANES(court_roll_0_out) _o202 =
                LANES(court_roll_0)(bent_x, bent_y, bent_z, nx_0, ny_0, nz_0, per_reach, turn_rate_0, vx_0, vy_0, vz_0, lanes_load(lists->fixed[124]));
            V lift_0 = _o202.lift_0;
            V tx_0 = _o202.tx_0;
            V ty_0 = _o202.ty_0;
            V tz_0 = _o202.tz_0;
            V vx_1 = _o202.vx_1;
            V vy_1 = _o202.vy_1;
            V vz_1 = _o202.vz_1;
            V nx_1 = _o202.nx_1;
            V ny_1 = _o202.ny_1;
            V nz_1 = _o202.nz_1;
            V turn_rate_1 = _o202.turn_rate_1;
            const LANES(court_roll_1_out) _o203 =
                LANES(court_roll_1)(bent_x, bent_y, bent_z, lift_0, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1, lanes_load(lists->fixed[124]));
            V lift_1 = _o203.lift_1;
            V tx_1 = _o203.tx_1;
            V ty_1 = _o203.ty_1;
            V tz_1 = _o203.tz_1;
            V vx_2 = _o203.vx_2;
            V vy_2 = _o203.vy_2;
            V vz_2 = _o203.vz_2;
            V nx_2 = _o203.nx_2;
            V ny_2 = _o203.ny_2;
            V nz_2 = _o203.nz_2;
            V turn_rate_2 = _o203.turn_rate_2;
            const LANES(court_roll_2_out) _o204 =
                LANES(court_roll_2)(bent_x, bent_y, bent_z, lift_0, lift_1, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2, lanes_load(lists->fixed[124]));
            V lift_2 = _o204.lift_2;
            V tx_2 = _o204.tx_2;
            V ty_2 = _o204.ty_2;
            V tz_2 = _o204.tz_2;
            V vx_3 = _o204.vx_3;
            V vy_3 = _o204.vy_3;
            V vz_3 = _o204.vz_3;
            V nx_3 = _o204.nx_3;
            V ny_3 = _o204.ny_3;
            V nz_3 = _o204.nz_3;
            V turn_rate_3 = _o204.turn_rate_3;
            const LANES(court_roll_3_out) _o205 =
                LANES(court_roll_3)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3, lanes_load(lists->fixed[124]));
            V lift_3 = _o205.lift_3;
            V tx_3 = _o205.tx_3;
            V ty_3 = _o205.ty_3;
            V tz_3 = _o205.tz_3;
            V vx_4 = _o205.vx_4;
            V vy_4 = _o205.vy_4;
            V vz_4 = _o205.vz_4;
            V nx_4 = _o205.nx_4;
            V ny_4 = _o205.ny_4;
            V nz_4 = _o205.nz_4;
            V turn_rate_4 = _o205.turn_rate_4;
            const LANES(court_roll_4_out) _o206 =
                LANES(court_roll_4)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4, lanes_load(lists->fixed[124]));
            V lift_4 = _o206.lift_4;
            V tx_4 = _o206.tx_4;
            V ty_4 = _o206.ty_4;
            V tz_4 = _o206.tz_4;
            V vx_5 = _o206.vx_5;
            V vy_5 = _o206.vy_5;
            V vz_5 = _o206.vz_5;
            V nx_5 = _o206.nx_5;
            V ny_5 = _o206.ny_5;
            V nz_5 = _o206.nz_5;
            V turn_rate_5 = _o206.turn_rate_5;
            const LANES(court_roll_5_out) _o207 =
                LANES(court_roll_5)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, lanes_load(lists->fixed[124]));
            V lift_5 = _o207.lift_5;
            V tx_5 = _o207.tx_5;
            V ty_5 = _o207.ty_5;
            V tz_5 = _o207.tz_5;
            V vx_6 = _o207.vx_6;
            V vy_6 = _o207.vy_6;
            V vz_6 = _o207.vz_6;
            V nx_6 = _o207.nx_6;
            V ny_6 = _o207.ny_6;
            V nz_6 = _o207.nz_6;
            V turn_rate_6 = _o207.turn_rate_6;
            const LANES(court_roll_6_out) _o208 =
                LANES(court_roll_6)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, lanes_load(lists->fixed[124]));
            V lift_6 = _o208.lift_6;
            V tx_6 = _o208.tx_6;
            V ty_6 = _o208.ty_6;
            V tz_6 = _o208.tz_6;
            V vx_7 = _o208.vx_7;
            V vy_7 = _o208.vy_7;
            V vz_7 = _o208.vz_7;
            V nx_7 = _o208.nx_7;
            V ny_7 = _o208.ny_7;
            V nz_7 = _o208.nz_7;
            V turn_rate_7 = _o208.turn_rate_7;
            const LANES(court_roll_7_out) _o209 =
                LANES(court_roll_7)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, lanes_load(lists->fixed[124]));
            V lift_7 = _o209.lift_7;
            V vx_8 = _o209.vx_8;
            V vy_8 = _o209.vy_8;
            V vz_8 = _o209.vz_8;
            V nx_8 = _o209.nx_8;
            V ny_8 = _o209.ny_8;
            V nz_8 = _o209.nz_8;
            V turn_rate_8 = _o209.turn_rate_8;
            const LANES(court_roll_pace_out) _o210 =
                LANES(court_roll_pace)(lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, lift_7, nx_8, ny_8, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, nz_8, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[125]), lanes_load(lists->fixed[126]));
            V stride = _o210.stride;
            V strongest = _o210.strongest;
            V fastest = _o210.fastest;
            V force = _o210.force;
            V force_rate = _o210.force_rate;
            V force_bend = _o210.force_bend;
            V brace = _o210.brace;
            const LANES(court_leaving_force_out) _o211 =
                LANES(court_leaving_force)(brace, K(INFINITY), fastest, force, force_bend, force_rate, per_reach, K(0.0), stride, K(0.0), vx, vx_1, vy, vy_1, vz, vz_1, which, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[127]), lanes_load(lists->fixed[128]));
            stride = _o211.stride;
            which = _o211.which;
            M rests = _o211.rests;
            const LANES(court_beside_out) _o212 =
                LANES(court_beside)(held, K(0.0));
            M beside = _o212.beside;
            const M _m213 = lanes_both(active, beside);
            if (lanes_any(_m213)) {
                const LANES(court_ring_beside_out) _o214 =
                    LANES(court_ring_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[39]), lanes_load(lists->fixed[129]));
                V gap = _o214.gap;
                V nearing = _o214.nearing;
                V dent = _o214.dent;
                const LANES(court_beside_body_out) _o215 =
                    LANES(court_beside_body)(dent, K(INFINITY), fastest, gap, K(0.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[130]));
                stride = lanes_select(_m213, _o215.stride, stride);
                which = lanes_select(_m213, _o215.which, which);
            }
            const LANES(court_beside_out) _o216 =
                LANES(court_beside)(held, K(1.0));
            beside = _o216.beside;
            const M _m217 = lanes_both(active, beside);
            if (lanes_any(_m217)) {
                const LANES(court_backboard_beside_out) _o218 =
                    LANES(court_backboard_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[15]));
                V gap = _o218.gap;
                V nearing = _o218.nearing;
                V dent = _o218.dent;
                const LANES(court_beside_body_out) _o219 =
                    LANES(court_beside_body)(dent, K(INFINITY), fastest, gap, K(1.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[130]));
                stride = lanes_select(_m217, _o219.stride, stride);
                which = lanes_select(_m217, _o219.which, which);
            }
            const LANES(court_beside_out) _o220 =
                LANES(court_beside)(held, K(2.0));
            beside = _o220.beside;
            const M _m221 = lanes_both(active, beside);
            if (lanes_any(_m221)) {
                const LANES(court_bridge_beside_out) _o222 =
                    LANES(court_bridge_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]));
                V gap = _o222.gap;
                V nearing = _o222.nearing;
                V dent = _o222.dent;
                const LANES(court_beside_body_out) _o223 =
                    LANES(court_beside_body)(dent, K(INFINITY), fastest, gap, K(2.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[130]));
                stride = lanes_select(_m221, _o223.stride, stride);
                which = lanes_select(_m221, _o223.which, which);
            }
            const LANES(court_end_beside_out) _o224 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[18]));
            V gap = _o224.gap;
            V nearing = _o224.nearing;
            V dent = _o224.dent;
            const LANES(court_beside_gate_out) _o225 =
                LANES(court_beside_gate)(dent, K(INFINITY), fastest, gap, K(3.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z, lanes_load(lists->fixed[6]));
            stride = _o225.stride;
            which = _o225.which;
            const LANES(court_holding_out) _o226 =
                LANES(court_holding)(held, K(1.0));
            here = _o226.here;
            const M _m227 = lanes_both(active, here);
            if (lanes_any(_m227)) {
                const LANES(court_backboard_seam0_out) _o228 =
                    LANES(court_backboard_seam0)(vx, x, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[112]));
                gap = lanes_select(_m227, _o228.gap, gap);
                V nearing = _o228.nearing;
                V near = _o228.near;
                const LANES(court_beside_seam_out) _o229 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m227, _o229.stride, stride);
                const LANES(court_backboard_seam1_out) _o230 =
                    LANES(court_backboard_seam1)(vx, x, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[112]));
                gap = lanes_select(_m227, _o230.gap, gap);
                nearing = _o230.nearing;
                near = _o230.near;
                const LANES(court_beside_seam_out) _o231 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m227, _o231.stride, stride);
                const LANES(court_backboard_seam2_out) _o232 =
                    LANES(court_backboard_seam2)(vy, y, lanes_load(lists->fixed[10]), lanes_load(lists->fixed[114]));
                gap = lanes_select(_m227, _o232.gap, gap);
                nearing = _o232.nearing;
                near = _o232.near;
                const LANES(court_beside_seam_out) _o233 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m227, _o233.stride, stride);
                const LANES(court_backboard_seam3_out) _o234 =
                    LANES(court_backboard_seam3)(vy, y, lanes_load(lists->fixed[10]), lanes_load(lists->fixed[114]));
                gap = lanes_select(_m227, _o234.gap, gap);
                nearing = _o234.nearing;
                near = _o234.near;
                const LANES(court_beside_seam_out) _o235 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m227, _o235.stride, stride);
                const LANES(court_backboard_seam4_out) _o236 =
                    LANES(court_backboard_seam4)(vz, z, lanes_load(lists->fixed[11]), lanes_load(lists->fixed[116]));
                gap = lanes_select(_m227, _o236.gap, gap);
                nearing = _o236.nearing;
                near = _o236.near;
                const LANES(court_beside_seam_out) _o237 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m227, _o237.stride, stride);
                const LANES(court_backboard_seam5_out) _o238 =
                    LANES(court_backboard_seam5)(vz, z, lanes_load(lists->fixed[12]), lanes_load(lists->fixed[116]));
                gap = lanes_select(_m227, _o238.gap, gap);
                nearing = _o238.nearing;
                near = _o238.near;
                const LANES(court_beside_seam_out) _o239 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m227, _o239.stride, stride);
            }
            const LANES(court_holding_out) _o240 =
                LANES(court_holding)(held, K(2.0));
            here = _o240.here;
            const M _m241 = lanes_both(active, here);
            if (lanes_any(_m241)) {
                const LANES(court_bridge_seam0_out) _o242 =
                    LANES(court_bridge_seam0)(vx, x, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[118]));
                gap = lanes_select(_m241, _o242.gap, gap);
                V nearing = _o242.nearing;
                V near = _o242.near;
                const LANES(court_beside_seam_out) _o243 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m241, _o243.stride, stride);
                const LANES(court_bridge_seam1_out) _o244 =
                    LANES(court_bridge_seam1)(vx, x, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[118]));
                gap = lanes_select(_m241, _o244.gap, gap);
                nearing = _o244.nearing;
                near = _o244.near;
                const LANES(court_beside_seam_out) _o245 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m241, _o245.stride, stride);
                const LANES(court_bridge_seam2_out) _o246 =
                    LANES(court_bridge_seam2)(vy, y, lanes_load(lists->fixed[13]), lanes_load(lists->fixed[120]));
                gap = lanes_select(_m241, _o246.gap, gap);
                nearing = _o246.nearing;
                near = _o246.near;
                const LANES(court_beside_seam_out) _o247 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m241, _o247.stride, stride);
                const LANES(court_bridge_seam3_out) _o248 =
                    LANES(court_bridge_seam3)(vy, y, lanes_load(lists->fixed[13]), lanes_load(lists->fixed[120]));
                gap = lanes_select(_m241, _o248.gap, gap);
                nearing = _o248.nearing;
                near = _o248.near;
                const LANES(court_beside_seam_out) _o249 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m241, _o249.stride, stride);
                const LANES(court_bridge_seam4_out) _o250 =
                    LANES(court_bridge_seam4)(vz, z, lanes_load(lists->fixed[131]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[122]));
                gap = lanes_select(_m241, _o250.gap, gap);
                nearing = _o250.nearing;
                near = _o250.near;
                const LANES(court_beside_seam_out) _o251 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m241, _o251.stride, stride);
                const LANES(court_bridge_seam5_out) _o252 =
                    LANES(court_bridge_seam5)(vz, z, lanes_load(lists->fixed[8]), lanes_load(lists->fixed[122]));
                gap = lanes_select(_m241, _o252.gap, gap);
                nearing = _o252.nearing;
                near = _o252.near;
                const LANES(court_beside_seam_out) _o253 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m241, _o253.stride, stride);
            }
            const LANES(court_beside_time_out) _o254 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o254.stride;
            which = _o254.which;
            const LANES(court_passing_from_out) _o255 =
                LANES(court_passing_from)(z);
            M over = _o255.over;
            const LANES(court_roll_moved_out) _o256 =
                LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, x, y, z);
            x = _o256.x;
            vx = _o256.vx;
            y = _o256.y;
            vy = _o256.vy;
            z = _o256.z;
            vz = _o256.vz;
            V turn_rate = _o256.turn_rate;
            const LANES(court_holding_out) _o257 =
                LANES(court_holding)(held, K(1.0));
            here = _o257.here;
            const M _m258 = lanes_both(active, here);
            if (lanes_any(_m258)) {
                const LANES(court_backboard_normal_out) _o259 =
                    LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[15]));
                nx = lanes_select(_m258, _o259.nx, nx);
                ny = lanes_select(_m258, _o259.ny, ny);
                nz = lanes_select(_m258, _o259.nz, nz);
                const LANES(court_backboard_off_out) _o260 =
                    LANES(court_backboard_off)(x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[15]));
                gap = lanes_select(_m258, _o260.gap, gap);
            }
            const LANES(court_holding_out) _o261 =
                LANES(court_holding)(held, K(2.0));
            here = _o261.here;
            const M _m262 = lanes_both(active, here);
            if (lanes_any(_m262)) {
                const LANES(court_bridge_normal_out) _o263 =
                    LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[16]));
                nx = lanes_select(_m262, _o263.nx, nx);
                ny = lanes_select(_m262, _o263.ny, ny);
                nz = lanes_select(_m262, _o263.nz, nz);
                const LANES(court_bridge_off_out) _o264 =
                    LANES(court_bridge_off)(x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]));
                gap = lanes_select(_m262, _o264.gap, gap);
            }
            const LANES(court_roll_placed_out) _o265 =
                LANES(court_roll_placed)(gap, nx, ny, nz, turn_rate, vx, vy, vz, x, y, z, lanes_load(lists->fixed[111]));
            x = _o265.x;
            y = _o265.y;
            z = _o265.z;
            vx = _o265.vx;
            vy = _o265.vy;
            vz = _o265.vz;
            wx = _o265.wx;
            wy = _o265.wy;
            wz = _o265.wz;
            const LANES(court_passing_in_contact_out) _o266 =
                LANES(court_passing_in_contact)(over, through, x, y, z, lanes_load(lists->fixed[19]));
            through = _o266.through;
            const LANES(court_rolled_on_out) _o267 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o267.clock;
            rolling = _o267.rolling;
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
            if (LANES_SELDOM(varying)) {
                lanes_pack(lists->kept_circling_p_ball_radius + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_ball_radius + i : lists->p_ball_radius));
                lanes_pack(lists->kept_circling_p_board_bottom + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_board_bottom + i : lists->p_board_bottom));
                lanes_pack(lists->kept_circling_p_board_distance + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_board_distance + i : lists->p_board_distance));
                lanes_pack(lists->kept_circling_p_board_half_width + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_board_half_width + i : lists->p_board_half_width));
                lanes_pack(lists->kept_circling_p_board_thickness + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_board_thickness + i : lists->p_board_thickness));
                lanes_pack(lists->kept_circling_p_board_top + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_board_top + i : lists->p_board_top));
                lanes_pack(lists->kept_circling_p_bridge_depth + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_bridge_depth + i : lists->p_bridge_depth));
                lanes_pack(lists->kept_circling_p_bridge_half_width + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_bridge_half_width + i : lists->p_bridge_half_width));
                lanes_pack(lists->kept_circling_p_end_depth + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_end_depth + i : lists->p_end_depth));
                lanes_pack(lists->kept_circling_p_gravity + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_gravity + i : lists->p_gravity));
                lanes_pack(lists->kept_circling_p_ring_radius + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_ring_radius + i : lists->p_ring_radius));
                lanes_pack(lists->kept_circling_p_wire_radius + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_wire_radius + i : lists->p_wire_radius));
            }
            kept_circling_shots += lanes_many(packed);
        }
    }
    {
        size_t taken = 0, busy = 0;
        M active = lanes_nowhere();
        V row = K(0.0), turns = K(0.0);
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
                if (LANES_SELDOM(varying))
                    LANES(court_plain_fix_f268)(lists, taken, idle);
                const size_t room = LANES_WIDTH - busy, left = kept_circling_shots - taken;
                active = lanes_leading(idle, left, active);
                taken += left < room ? left : room;
                busy += left < room ? left : room;
            }
            if (busy == 0)
                break;
            M circling = active;
            const LANES(court_ring_tube_out) _o269 =
                LANES(court_ring_tube)(lanes_load(lists->fixed[110]));
            V per_reach = _o269.per_reach;
            const LANES(court_ring_round_start_out) _o270 =
                LANES(court_ring_round_start)(per_reach, vx, vy, vz, wx, wy, wz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[129]));
            V cosine_0 = _o270.cosine_0;
            V sine_0 = _o270.sine_0;
            V climb_0 = _o270.climb_0;
            V along_0 = _o270.along_0;
            V turn_rate_0 = _o270.turn_rate_0;
            V cos_0 = _o270.cos_0;
            V sin_0 = _o270.sin_0;
            V tilted_0 = _o270.tilted_0;
            V near_0 = _o270.near_0;
            const LANES(court_ring_round_0_out) _o271 =
                LANES(court_ring_round_0)(along_0, climb_0, cosine_0, near_0, per_reach, sine_0, tilted_0, turn_rate_0, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[132]));
            V omega_0 = _o271.omega_0;
            V around_0 = _o271.around_0;
            V cosine_1 = _o271.cosine_1;
            V sine_1 = _o271.sine_1;
            V climb_1 = _o271.climb_1;
            V along_1 = _o271.along_1;
            V turn_rate_1 = _o271.turn_rate_1;
            V tilted_1 = _o271.tilted_1;
            const LANES(court_ring_round_1_out) _o272 =
                LANES(court_ring_round_1)(along_1, around_0, climb_0, climb_1, cosine_0, cosine_1, near_0, omega_0, per_reach, sine_0, sine_1, tilted_0, tilted_1, turn_rate_0, turn_rate_1, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[90]), lanes_load(lists->fixed[132]));
            V omega_1 = _o272.omega_1;
            V around_1 = _o272.around_1;
            V cosine_2 = _o272.cosine_2;
            V sine_2 = _o272.sine_2;
            V climb_2 = _o272.climb_2;
            V along_2 = _o272.along_2;
            V turn_rate_2 = _o272.turn_rate_2;
            V tilted_2 = _o272.tilted_2;
            const LANES(court_ring_round_2_out) _o273 =
                LANES(court_ring_round_2)(along_2, around_0, around_1, climb_0, climb_1, climb_2, cosine_0, cosine_1, cosine_2, near_0, omega_0, omega_1, per_reach, sine_0, sine_1, sine_2, tilted_0, tilted_1, tilted_2, turn_rate_0, turn_rate_1, turn_rate_2, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[133]), lanes_load(lists->fixed[132]));
            V omega_2 = _o273.omega_2;
            V around_2 = _o273.around_2;
            V cosine_3 = _o273.cosine_3;
            V sine_3 = _o273.sine_3;
            V climb_3 = _o273.climb_3;
            V along_3 = _o273.along_3;
            V turn_rate_3 = _o273.turn_rate_3;
            V tilted_3 = _o273.tilted_3;
            const LANES(court_ring_round_3_out) _o274 =
                LANES(court_ring_round_3)(along_3, around_0, around_1, around_2, climb_0, climb_1, climb_2, climb_3, cosine_0, cosine_1, cosine_2, cosine_3, near_0, omega_0, omega_1, omega_2, per_reach, sine_0, sine_1, sine_2, sine_3, tilted_0, tilted_1, tilted_2, tilted_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[134]), lanes_load(lists->fixed[132]));
            V omega_3 = _o274.omega_3;
            V around_3 = _o274.around_3;
            V cosine_4 = _o274.cosine_4;
            V sine_4 = _o274.sine_4;
            V climb_4 = _o274.climb_4;
            V along_4 = _o274.along_4;
            V turn_rate_4 = _o274.turn_rate_4;
            V tilted_4 = _o274.tilted_4;
            const LANES(court_ring_round_4_out) _o275 =
                LANES(court_ring_round_4)(along_4, around_0, around_1, around_2, around_3, climb_0, climb_1, climb_2, climb_3, climb_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, near_0, omega_0, omega_1, omega_2, omega_3, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[132]));
            V omega_4 = _o275.omega_4;
            V around_4 = _o275.around_4;
            V cosine_5 = _o275.cosine_5;
            V sine_5 = _o275.sine_5;
            V climb_5 = _o275.climb_5;
            V along_5 = _o275.along_5;
            V turn_rate_5 = _o275.turn_rate_5;
            V tilted_5 = _o275.tilted_5;
            const LANES(court_ring_round_5_out) _o276 =
                LANES(court_ring_round_5)(along_5, around_0, around_1, around_2, around_3, around_4, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[136]), lanes_load(lists->fixed[132]));
            V omega_5 = _o276.omega_5;
            V around_5 = _o276.around_5;
            V cosine_6 = _o276.cosine_6;
            V sine_6 = _o276.sine_6;
            V climb_6 = _o276.climb_6;
            V along_6 = _o276.along_6;
            V turn_rate_6 = _o276.turn_rate_6;
            V tilted_6 = _o276.tilted_6;
            const LANES(court_ring_round_6_out) _o277 =
                LANES(court_ring_round_6)(along_6, around_0, around_1, around_2, around_3, around_4, around_5, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[137]), lanes_load(lists->fixed[132]));
            V omega_6 = _o277.omega_6;
            V around_6 = _o277.around_6;
            V cosine_7 = _o277.cosine_7;
            V sine_7 = _o277.sine_7;
            V climb_7 = _o277.climb_7;
            V along_7 = _o277.along_7;
            V turn_rate_7 = _o277.turn_rate_7;
            V tilted_7 = _o277.tilted_7;
            const LANES(court_ring_round_7_out) _o278 =
                LANES(court_ring_round_7)(along_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[138]), lanes_load(lists->fixed[132]));
            V omega_7 = _o278.omega_7;
            V around_7 = _o278.around_7;
            V cosine_8 = _o278.cosine_8;
            V sine_8 = _o278.sine_8;
            V climb_8 = _o278.climb_8;
            V along_8 = _o278.along_8;
            V turn_rate_8 = _o278.turn_rate_8;
            V tilted_8 = _o278.tilted_8;
            const LANES(court_ring_round_8_out) _o279 =
                LANES(court_ring_round_8)(along_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[139]), lanes_load(lists->fixed[132]));
            V omega_8 = _o279.omega_8;
            V around_8 = _o279.around_8;
            V cosine_9 = _o279.cosine_9;
            V sine_9 = _o279.sine_9;
            V climb_9 = _o279.climb_9;
            V along_9 = _o279.along_9;
            V turn_rate_9 = _o279.turn_rate_9;
            V tilted_9 = _o279.tilted_9;
            const LANES(court_ring_round_9_out) _o280 =
                LANES(court_ring_round_9)(along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[140]), lanes_load(lists->fixed[132]));
            V omega_9 = _o280.omega_9;
            V around_9 = _o280.around_9;
            V cosine_10 = _o280.cosine_10;
            V sine_10 = _o280.sine_10;
            V climb_10 = _o280.climb_10;
            V along_10 = _o280.along_10;
            V turn_rate_10 = _o280.turn_rate_10;
            V tilted_10 = _o280.tilted_10;
            const LANES(court_ring_round_10_out) _o281 =
                LANES(court_ring_round_10)(along_10, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, climb_0, climb_1, climb_10, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cosine_0, cosine_1, cosine_10, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, per_reach, sine_0, sine_1, sine_10, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[141]), lanes_load(lists->fixed[132]));
            V omega_10 = _o281.omega_10;
            V around_10 = _o281.around_10;
            V cosine_11 = _o281.cosine_11;
            V sine_11 = _o281.sine_11;
            V climb_11 = _o281.climb_11;
            V along_11 = _o281.along_11;
            V turn_rate_11 = _o281.turn_rate_11;
            V tilted_11 = _o281.tilted_11;
            const LANES(court_ring_round_11_out) _o282 =
                LANES(court_ring_round_11)(along_11, around_0, around_1, around_10, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, climb_0, climb_1, climb_10, climb_11, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, omega_0, omega_1, omega_10, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, per_reach, sine_0, sine_1, sine_10, sine_11, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_11, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[142]), lanes_load(lists->fixed[132]));
            V omega_11 = _o282.omega_11;
            V cosine_12 = _o282.cosine_12;
            V sine_12 = _o282.sine_12;
            V climb_12 = _o282.climb_12;
            V along_12 = _o282.along_12;
            V turn_rate_12 = _o282.turn_rate_12;
            const LANES(court_ring_round_pace_out) _o283 =
                LANES(court_ring_round_pace)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cosine_0, cosine_12, omega_0, omega_1, omega_10, omega_11, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, per_reach, sin_0, sine_0, sine_12, turn_rate_0, turn_rate_11, turn_rate_12, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[125]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[143]), lanes_load(lists->fixed[144]), lanes_load(lists->fixed[145]), lanes_load(lists->fixed[146]));
            V stride = _o283.stride;
            V strongest = _o283.strongest;
            V fastest = _o283.fastest;
            V sway = _o283.sway;
            V force = _o283.force;
            V force_rate = _o283.force_rate;
            V force_bend = _o283.force_bend;
            V brace = _o283.brace;
            V vx_1 = _o283.vx_1;
            V vy_1 = _o283.vy_1;
            V vz_1 = _o283.vz_1;
            const LANES(court_leaving_force_out) _o284 =
                LANES(court_leaving_force)(brace, K(INFINITY), fastest, force, force_bend, force_rate, per_reach, K(0.0), stride, K(0.0), vx, vx_1, vy, vy_1, vz, vz_1, which, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[127]), lanes_load(lists->fixed[128]));
            stride = _o284.stride;
            which = _o284.which;
            M rests = _o284.rests;
            const LANES(court_backboard_beside_out) _o285 =
                LANES(court_backboard_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[15]));
            V gap = _o285.gap;
            V nearing = _o285.nearing;
            V dent = _o285.dent;
            const LANES(court_beside_body_out) _o286 =
                LANES(court_beside_body)(dent, K(INFINITY), fastest, gap, K(1.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[130]));
            stride = _o286.stride;
            which = _o286.which;
            const LANES(court_bridge_beside_out) _o287 =
                LANES(court_bridge_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]));
            gap = _o287.gap;
            nearing = _o287.nearing;
            dent = _o287.dent;
            const LANES(court_beside_body_out) _o288 =
                LANES(court_beside_body)(dent, K(INFINITY), fastest, gap, K(2.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[130]));
            stride = _o288.stride;
            which = _o288.which;
            const LANES(court_end_beside_out) _o289 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[18]));
            gap = _o289.gap;
            nearing = _o289.nearing;
            dent = _o289.dent;
            const LANES(court_beside_gate_out) _o290 =
                LANES(court_beside_gate)(dent, K(INFINITY), fastest, gap, K(3.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z, lanes_load(lists->fixed[6]));
            stride = _o290.stride;
            which = _o290.which;
            const LANES(court_beside_time_out) _o291 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o291.stride;
            which = _o291.which;
            const LANES(court_passing_from_out) _o292 =
                LANES(court_passing_from)(z);
            M over = _o292.over;
            const LANES(court_alone_out) _o293 =
                LANES(court_alone)();
            V berth = _o293.nearest;
            const LANES(court_leaps_out) _o294 =
                LANES(court_leaps)(stride);
            V forth = _o294.forth;
            V back = _o294.back;
            const LANES(court_backboard_around_out) _o295 =
                LANES(court_backboard_around)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[147]));
            gap = _o295.gap;
            nearing = _o295.nearing;
            const LANES(court_cleared_out) _o296 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o296.berth;
            const LANES(court_bridge_around_out) _o297 =
                LANES(court_bridge_around)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[148]));
            gap = _o297.gap;
            nearing = _o297.nearing;
            const LANES(court_cleared_out) _o298 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o298.berth;
            const LANES(court_end_around_out) _o299 =
                LANES(court_end_around)(vz, z, lanes_load(lists->fixed[18]));
            gap = _o299.gap;
            nearing = _o299.nearing;
            const LANES(court_cleared_out) _o300 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o300.berth;
            const LANES(court_ring_round_moved_out) _o301 =
                LANES(court_ring_round_moved)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cosine_0, cosine_1, cosine_10, cosine_11, cosine_12, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, omega_0, omega_1, omega_10, omega_11, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, sin_0, sine_0, sine_1, sine_10, sine_11, sine_12, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, stride, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_12, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[111]));
            x = _o301.x;
            y = _o301.y;
            z = _o301.z;
            vx = _o301.vx;
            vy = _o301.vy;
            vz = _o301.vz;
            wx = _o301.wx;
            wy = _o301.wy;
            wz = _o301.wz;
            V climb = _o301.climb;
            const LANES(court_passing_in_contact_out) _o302 =
                LANES(court_passing_in_contact)(over, through, x, y, z, lanes_load(lists->fixed[19]));
            through = _o302.through;
            const LANES(court_backboard_around_out) _o303 =
                LANES(court_backboard_around)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[147]));
            gap = _o303.gap;
            nearing = _o303.nearing;
            const LANES(court_cleared_out) _o304 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o304.berth;
            const LANES(court_bridge_around_out) _o305 =
                LANES(court_bridge_around)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[148]));
            gap = _o305.gap;
            nearing = _o305.nearing;
            const LANES(court_cleared_out) _o306 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o306.berth;
            const LANES(court_end_around_out) _o307 =
                LANES(court_end_around)(vz, z, lanes_load(lists->fixed[18]));
            gap = _o307.gap;
            nearing = _o307.nearing;
            const LANES(court_cleared_out) _o308 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o308.berth;
            const LANES(court_ring_swung_out) _o309 =
                LANES(court_ring_swung)(berth, circled, climb, climb_0, K(INFINITY), fastest, force, force_bend, force_rate, K(0.0), stride, sway, K(0.0), which, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[149]), lanes_load(lists->fixed[150]), lanes_load(lists->fixed[125]), lanes_load(lists->fixed[110]), lanes_load(lists->fixed[151]));
            circled = _o309.circled;
            M endless = _o309.endless;
            const LANES(court_for_ever_out) _o310 =
                LANES(court_for_ever)(endless, which);
            which = _o310.which;
            const LANES(court_rolled_on_out) _o311 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o311.clock;
            circling = _o311.rolling;
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
        const LANES(court_rejoined_out) _o312 =
            LANES(court_rejoined)(circling, rolling);
        rolling = _o312.rolling;
        lanes_store(lists->kept_rolling + i, lanes_select(rolling, K(1.0), K(0.0)));
        const M packed = lanes_both(rows, leaves);
        if (lanes_any(packed)) {
            lanes_pack(lists->kept_leaves_row + kept_leaves_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
            lanes_pack(lists->kept_leaves_held + kept_leaves_shots, packed, held);
            lanes_pack(lists->kept_leaves_lift + kept_leaves_shots, packed, lift);
            lanes_pack(lists->kept_leaves_per_reach + kept_leaves_shots, packed, per_reach);
            lanes_pack(lists->kept_leaves_snap + kept_leaves_shots, packed, snap);
            lanes_pack(lists->kept_leaves_surge + kept_leaves_shots, packed, surge);
            lanes_pack(lists->kept_leaves_vx + kept_leaves_shots, packed, vx);
            lanes_pack(lists->kept_leaves_vy + kept_leaves_shots, packed, vy);
            lanes_pack(lists->kept_leaves_vz + kept_leaves_shots, packed, vz);
            lanes_pack(lists->kept_leaves_x + kept_leaves_shots, packed, x);
            lanes_pack(lists->kept_leaves_y + kept_leaves_shots, packed, y);
            lanes_pack(lists->kept_leaves_z + kept_leaves_shots, packed, z);
            if (LANES_SELDOM(varying)) {
                lanes_pack(lists->kept_leaves_p_ball_radius + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_ball_radius + i : lists->p_ball_radius));
                lanes_pack(lists->kept_leaves_p_board_bottom + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_board_bottom + i : lists->p_board_bottom));
                lanes_pack(lists->kept_leaves_p_board_distance + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_board_distance + i : lists->p_board_distance));
                lanes_pack(lists->kept_leaves_p_board_half_width + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_board_half_width + i : lists->p_board_half_width));
                lanes_pack(lists->kept_leaves_p_board_thickness + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_board_thickness + i : lists->p_board_thickness));
                lanes_pack(lists->kept_leaves_p_board_top + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_board_top + i : lists->p_board_top));
                lanes_pack(lists->kept_leaves_p_bridge_depth + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_bridge_depth + i : lists->p_bridge_depth));
                lanes_pack(lists->kept_leaves_p_bridge_half_width + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_bridge_half_width + i : lists->p_bridge_half_width));
                lanes_pack(lists->kept_leaves_p_end_depth + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_end_depth + i : lists->p_end_depth));
                lanes_pack(lists->kept_leaves_p_gravity + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_gravity + i : lists->p_gravity));
                lanes_pack(lists->kept_leaves_p_ring_radius + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_ring_radius + i : lists->p_ring_radius));
                lanes_pack(lists->kept_leaves_p_wire_radius + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_wire_radius + i : lists->p_wire_radius));
            }
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
static void LANES(court_plain_fix_f373)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->p_board_thickness + i);
    const V p_board_top = lanes_load(lists->p_board_top + i);
    const V p_bridge_depth = lanes_load(lists->p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + i);
    const V p_gravity = lanes_load(lists->p_gravity + i);
    const V p_restitution_speed = lanes_load(lists->p_restitution_speed + i);
    const V p_ring_radius = lanes_load(lists->p_ring_radius + i);
    const V p_tangential_restitution = lanes_load(lists->p_tangential_restitution + i);
    const V p_wire_radius = lanes_load(lists->p_wire_radius + i);
    {
        const V _s0 = lanes_add(K(0.4), lanes_mul(K(0.4), p_tangential_restitution));
        lanes_store(lists->fixed[6], p_ball_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[19], lanes_mul(p_ring_radius, p_ring_radius));
        lanes_store(lists->fixed[20], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[22], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[32], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[110], lanes_div(K(1.0), lanes_add(p_ball_radius, p_wire_radius)));
        lanes_store(lists->fixed[111], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[156], p_restitution_speed);
        lanes_store(lists->fixed[157], _s0);
        lanes_store(lists->fixed[158], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[159], lanes_mul(K(7.275957614183426e-12), p_ball_radius));
        lanes_store(lists->fixed[160], lanes_mul(K(1.1920928955078125e-07), p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f418)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_backboard_friction = lanes_load(lists->slow_p_backboard_friction + i);
    const V p_backboard_restitution = lanes_load(lists->slow_p_backboard_restitution + i);
    const V p_ball_radius = lanes_load(lists->slow_p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->slow_p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->slow_p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->slow_p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->slow_p_board_thickness + i);
    const V p_board_top = lanes_load(lists->slow_p_board_top + i);
    const V p_bridge_depth = lanes_load(lists->slow_p_bridge_depth + i);
    const V p_bridge_friction = lanes_load(lists->slow_p_bridge_friction + i);
    const V p_bridge_half_width = lanes_load(lists->slow_p_bridge_half_width + i);
    const V p_bridge_restitution = lanes_load(lists->slow_p_bridge_restitution + i);
    const V p_end_depth = lanes_load(lists->slow_p_end_depth + i);
    const V p_gravity = lanes_load(lists->slow_p_gravity + i);
    const V p_ring_friction = lanes_load(lists->slow_p_ring_friction + i);
    const V p_ring_radius = lanes_load(lists->slow_p_ring_radius + i);
    const V p_ring_restitution = lanes_load(lists->slow_p_ring_restitution + i);
    const V p_wire_radius = lanes_load(lists->slow_p_wire_radius + i);
    {
        const V _s0 = lanes_sub(K(1.0), p_ring_restitution);
        const V _s1 = lanes_add(K(1.0), p_ring_restitution);
        const V _s2 = lanes_sub(K(1.0), p_backboard_restitution);
        const V _s3 = lanes_add(K(1.0), p_backboard_restitution);
        const V _s4 = lanes_sub(K(1.0), p_bridge_restitution);
        const V _s5 = lanes_add(K(1.0), p_bridge_restitution);
        lanes_store(lists->fixed[6], p_ball_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[18], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[23], lanes_neg(p_gravity));
        lanes_store(lists->fixed[110], lanes_div(K(1.0), lanes_add(p_ball_radius, p_wire_radius)));
        lanes_store(lists->fixed[111], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[126], lanes_mul(K(0.4), p_gravity));
        lanes_store(lists->fixed[130], lanes_mul(K(3.637978807091713e-12), p_ball_radius));
        lanes_store(lists->fixed[152], lanes_mul(K(3.0), p_gravity));
        lanes_store(lists->fixed[153], lanes_mul(K(2.0), lanes_mul(K(3.0), lanes_mul(p_gravity, p_gravity))));
        lanes_store(lists->fixed[159], lanes_mul(K(7.275957614183426e-12), p_ball_radius));
        lanes_store(lists->fixed[161], lanes_mul(K(0.4), p_ball_radius));
        lanes_store(lists->fixed[162], _s0);
        lanes_store(lists->fixed[163], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[164], lanes_mul(p_ring_friction, _s1));
        lanes_store(lists->fixed[165], lanes_mul(_s1, _s0));
        lanes_store(lists->fixed[166], lanes_mul(K(3.725290298461914e-09), p_ball_radius));
        lanes_store(lists->fixed[167], _s2);
        lanes_store(lists->fixed[168], lanes_mul(_s2, _s2));
        lanes_store(lists->fixed[169], lanes_mul(p_backboard_friction, _s3));
        lanes_store(lists->fixed[170], lanes_mul(_s3, _s2));
        lanes_store(lists->fixed[171], _s4);
        lanes_store(lists->fixed[172], lanes_mul(_s4, _s4));
        lanes_store(lists->fixed[173], lanes_mul(p_bridge_friction, _s5));
        lanes_store(lists->fixed[174], lanes_mul(_s5, _s4));
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
        if (LANES_SELDOM(varying))
            LANES(court_plain_fix_f418)(lists, i);
        V held = lanes_load(lists->slow_held + i);
        V mode = lanes_load(lists->slow_mode + i);
        V outcome = lanes_load(lists->slow_outcome + i);
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
        const LANES(court_ring_normal_out) _o419 =
            LANES(court_ring_normal)(x, y, z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[110]));
        V nx = _o419.nx;
        V ny = _o419.ny;
        V nz = _o419.nz;
        const LANES(court_here_out) _o420 =
            LANES(court_here)(K(1.0), which);
        M here = _o420.here;
        const M _m421 = lanes_both(rows, here);
        {
            const LANES(court_backboard_normal_out) _o422 =
                LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[15]));
            nx = lanes_select(_m421, _o422.nx, nx);
            ny = lanes_select(_m421, _o422.ny, ny);
            nz = lanes_select(_m421, _o422.nz, nz);
        }
        const LANES(court_here_out) _o423 =
            LANES(court_here)(K(2.0), which);
        here = _o423.here;
        const M _m424 = lanes_both(rows, here);
        {
            const LANES(court_bridge_normal_out) _o425 =
                LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[16]));
            nx = lanes_select(_m424, _o425.nx, nx);
            ny = lanes_select(_m424, _o425.ny, ny);
            nz = lanes_select(_m424, _o425.nz, nz);
        }
        const LANES(court_nearly_out) _o426 =
            LANES(court_nearly)(nx, ny, nz, vx, vy, vz, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[159]));
        M nearly = _o426.nearly;
        const LANES(court_gripped_out) _o427 =
            LANES(court_gripped)(nx, ny, nz, vx, vy, vz, wx, wy, wz, lanes_load(lists->fixed[6]));
        V rolled_x = _o427.rolled_x;
        V rolled_y = _o427.rolled_y;
        V rolled_z = _o427.rolled_z;
        V slip = _o427.slip;
        V bounce = _o427.bounce;
        const LANES(court_here_out) _o428 =
            LANES(court_here)(K(0.0), which);
        here = _o428.here;
        const M _m429 = lanes_both(rows, here);
        if (lanes_any(_m429)) {
            const LANES(court_ring_turning_out) _o430 =
                LANES(court_ring_turning)(rolled_x, rolled_y, rolled_z, x, y, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[110]));
            V turning_x = _o430.turning_x;
            V turning_y = _o430.turning_y;
            V turning_z = _o430.turning_z;
            const LANES(court_pressed_on_out) _o431 =
                LANES(court_pressed_on)(nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[161]), lanes_load(lists->fixed[126]));
            V press = _o431.press;
            V weight = _o431.weight;
            V drag = _o431.drag;
            V thrust_x = _o431.thrust_x;
            V thrust_y = _o431.thrust_y;
            V thrust_z = _o431.thrust_z;
            const LANES(court_alone_out) _o432 =
                LANES(court_alone)();
            V nearest = _o432.nearest;
            V wedge = _o432.wedge;
            const LANES(court_backboard_closing_out) _o433 =
                LANES(court_backboard_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[15]));
            V gap = _o433.gap;
            V nearing = _o433.nearing;
            V swerve = _o433.swerve;
            V facing = _o433.facing;
            const LANES(court_neared_body_out) _o434 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o434.nearest;
            wedge = _o434.wedge;
            const LANES(court_bridge_closing_out) _o435 =
                LANES(court_bridge_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]));
            gap = _o435.gap;
            nearing = _o435.nearing;
            swerve = _o435.swerve;
            facing = _o435.facing;
            const LANES(court_neared_body_out) _o436 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o436.nearest;
            wedge = _o436.wedge;
            const LANES(court_end_beside_out) _o437 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[18]));
            gap = _o437.gap;
            const LANES(court_neared_out) _o438 =
                LANES(court_neared)(gap, nearest);
            nearest = _o438.nearest;
            const LANES(court_ring_parting_out) _o439 =
                LANES(court_ring_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[152]), lanes_load(lists->fixed[153]));
            V lift = _o439.lift;
            const LANES(court_ring_impact_settling_out) _o440 =
                LANES(court_ring_impact_settling)(bounce, drag, lift, nearest, press, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[162]), lanes_load(lists->fixed[163]), lanes_load(lists->fixed[164]), lanes_load(lists->fixed[165]), lanes_load(lists->fixed[130]), lanes_load(lists->fixed[166]));
            M settles = _o440.settles;
            M lodges = _o440.lodges;
            M slides = _o440.slides;
            M parts = _o440.parts;
            M unsure = _o440.unsure;
            const LANES(court_settled_out) _o441 =
                LANES(court_settled)(K(0.0), lodges, nearly, outcome, parts, settles, slides, K(0.0), unsure);
            mode = lanes_select(_m429, _o441.mode, mode);
            held = lanes_select(_m429, _o441.held, held);
            outcome = lanes_select(_m429, _o441.outcome, outcome);
            slip_left = lanes_select(_m429, _o441.slip_left, slip_left);
        }
        const LANES(court_here_out) _o442 =
            LANES(court_here)(K(1.0), which);
        here = _o442.here;
        const M _m443 = lanes_both(rows, here);
        if (lanes_any(_m443)) {
            const LANES(court_backboard_turning_out) _o444 =
                LANES(court_backboard_turning)(rolled_x, rolled_y, rolled_z, x, y, z, lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[15]));
            V turning_x = _o444.turning_x;
            V turning_y = _o444.turning_y;
            V turning_z = _o444.turning_z;
            const LANES(court_pressed_on_out) _o445 =
                LANES(court_pressed_on)(nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[161]), lanes_load(lists->fixed[126]));
            V press = _o445.press;
            V weight = _o445.weight;
            V drag = _o445.drag;
            V thrust_x = _o445.thrust_x;
            V thrust_y = _o445.thrust_y;
            V thrust_z = _o445.thrust_z;
            const LANES(court_alone_out) _o446 =
                LANES(court_alone)();
            V nearest = _o446.nearest;
            V wedge = _o446.wedge;
            const LANES(court_ring_closing_out) _o447 =
                LANES(court_ring_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]));
            V gap = _o447.gap;
            V nearing = _o447.nearing;
            V swerve = _o447.swerve;
            V facing = _o447.facing;
            const LANES(court_neared_body_out) _o448 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o448.nearest;
            wedge = _o448.wedge;
            const LANES(court_bridge_closing_out) _o449 =
                LANES(court_bridge_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]));
            gap = _o449.gap;
            nearing = _o449.nearing;
            swerve = _o449.swerve;
            facing = _o449.facing;
            const LANES(court_neared_body_out) _o450 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o450.nearest;
            wedge = _o450.wedge;
            const LANES(court_end_beside_out) _o451 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[18]));
            gap = _o451.gap;
            const LANES(court_neared_out) _o452 =
                LANES(court_neared)(gap, nearest);
            nearest = _o452.nearest;
            const LANES(court_backboard_parting_out) _o453 =
                LANES(court_backboard_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[23]));
            V lift = _o453.lift;
            const LANES(court_ring_impact_settling_out) _o454 =
                LANES(court_ring_impact_settling)(bounce, drag, lift, nearest, press, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[167]), lanes_load(lists->fixed[168]), lanes_load(lists->fixed[169]), lanes_load(lists->fixed[170]), lanes_load(lists->fixed[130]), lanes_load(lists->fixed[166]));
            M settles = _o454.settles;
            M lodges = _o454.lodges;
            M slides = _o454.slides;
            M parts = _o454.parts;
            M unsure = _o454.unsure;
            const LANES(court_settled_out) _o455 =
                LANES(court_settled)(K(1.0), lodges, nearly, outcome, parts, settles, slides, K(0.0), unsure);
            mode = lanes_select(_m443, _o455.mode, mode);
            held = lanes_select(_m443, _o455.held, held);
            outcome = lanes_select(_m443, _o455.outcome, outcome);
            slip_left = lanes_select(_m443, _o455.slip_left, slip_left);
        }
        const LANES(court_here_out) _o456 =
            LANES(court_here)(K(2.0), which);
        here = _o456.here;
        const M _m457 = lanes_both(rows, here);
        if (lanes_any(_m457)) {
            const LANES(court_bridge_turning_out) _o458 =
                LANES(court_bridge_turning)(rolled_x, rolled_y, rolled_z, x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[16]));
            V turning_x = _o458.turning_x;
            V turning_y = _o458.turning_y;
            V turning_z = _o458.turning_z;
            const LANES(court_pressed_on_out) _o459 =
                LANES(court_pressed_on)(nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[161]), lanes_load(lists->fixed[126]));
            V press = _o459.press;
            V weight = _o459.weight;
            V drag = _o459.drag;
            V thrust_x = _o459.thrust_x;
            V thrust_y = _o459.thrust_y;
            V thrust_z = _o459.thrust_z;
            const LANES(court_alone_out) _o460 =
                LANES(court_alone)();
            V nearest = _o460.nearest;
            V wedge = _o460.wedge;
            const LANES(court_ring_closing_out) _o461 =
                LANES(court_ring_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]));
            V gap = _o461.gap;
            V nearing = _o461.nearing;
            V swerve = _o461.swerve;
            V facing = _o461.facing;
            const LANES(court_neared_body_out) _o462 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o462.nearest;
            wedge = _o462.wedge;
            const LANES(court_backboard_closing_out) _o463 =
                LANES(court_backboard_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[15]));
            gap = _o463.gap;
            nearing = _o463.nearing;
            swerve = _o463.swerve;
            facing = _o463.facing;
            const LANES(court_neared_body_out) _o464 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o464.nearest;
            wedge = _o464.wedge;
            const LANES(court_end_beside_out) _o465 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[18]));
            gap = _o465.gap;
            const LANES(court_neared_out) _o466 =
                LANES(court_neared)(gap, nearest);
            nearest = _o466.nearest;
            const LANES(court_bridge_parting_out) _o467 =
                LANES(court_bridge_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[23]));
            V lift = _o467.lift;
            const LANES(court_ring_impact_settling_out) _o468 =
                LANES(court_ring_impact_settling)(bounce, drag, lift, nearest, press, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[171]), lanes_load(lists->fixed[172]), lanes_load(lists->fixed[173]), lanes_load(lists->fixed[174]), lanes_load(lists->fixed[130]), lanes_load(lists->fixed[166]));
            M settles = _o468.settles;
            M lodges = _o468.lodges;
            M slides = _o468.slides;
            M parts = _o468.parts;
            M unsure = _o468.unsure;
            const LANES(court_settled_out) _o469 =
                LANES(court_settled)(K(2.0), lodges, nearly, outcome, parts, settles, slides, K(0.0), unsure);
            mode = lanes_select(_m457, _o469.mode, mode);
            held = lanes_select(_m457, _o469.held, held);
            outcome = lanes_select(_m457, _o469.outcome, outcome);
            slip_left = lanes_select(_m457, _o469.slip_left, slip_left);
        }
        lanes_store(lists->slow_held + i, held);
        lanes_store(lists->slow_mode + i, mode);
        lanes_store(lists->slow_outcome + i, outcome);
        lanes_store(lists->slow_slip_left + i, slip_left);
    }
}

/* Run the job: fill the rows, take every shot to its next event, make room of those that ended.
   No errors are bounded: the same path, with less work. */
static void LANES(court_plain)(const court_job *job, LANES(court_plain_lists) *const restrict lists)
{
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
    LANES(court_plain_permitted)(lists, 0);
    LANES(court_plain_fix)(lists);
    for (;;) {
        if (stopped(job))
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
            const M rows = lanes_first(shots - i);
            if (LANES_SELDOM(varying))
                LANES(court_plain_fix_f1)(lists, i);
            V last = lanes_load(lists->last + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V wx = lanes_load(lists->wx + i);
            V wy = lanes_load(lists->wy + i);
            V wz = lanes_load(lists->wz + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            M permitted = lanes_less(K(0.0), lanes_load(lists->permitted + (i & varying)));
            const LANES(court_finite_state_out) _o2 =
                LANES(court_finite_state)(vx, vy, vz, wx, wy, wz, x, y, z);
            M finite = _o2.finite;
            const LANES(court_aside_out) _o3 =
                LANES(court_aside)(x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]));
            M close = _o3.close;
            V valid = _o3.valid;
            const M _m4 = lanes_both(rows, close);
            if (lanes_any(_m4)) {
                const LANES(court_valid_out) _o5 =
                    LANES(court_valid)(last, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[14]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[0]));
                valid = lanes_select(_m4, _o5.valid, valid);
            }
            const LANES(court_admitted_out) _o6 =
                LANES(court_admitted)(K(INFINITY), finite, permitted, valid);
            V outcome = _o6.outcome;
            const LANES(court_passing_start_out) _o7 =
                LANES(court_passing_start)(last, outcome, K(0.0), x, y, z, lanes_load(lists->fixed[18]), lanes_load(lists->fixed[19]));
            V through = _o7.through;
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
            if (LANES_SELDOM(varying))
                LANES(court_plain_fix_f8)(lists, i);
            V last = lanes_load(lists->last + i);
            V mode = lanes_load(lists->mode + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const LANES(court_error_bounds_out) _o9 =
                LANES(court_error_bounds)(K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0));
            V time_error = _o9.time_error;
            const LANES(court_scale_out) _o10 =
                LANES(court_scale)(x, y, z, vx, vy, vz, lanes_load(lists->fixed[20]));
            V extent = _o10.extent;
            V speed = _o10.speed;
            V excess = _o10.excess;
            const LANES(court_opening_out) _o11 =
                LANES(court_opening)(excess, K(0.0), K(0.0));
            V when = _o11.when;
            V which = _o11.which;
            const LANES(court_limited_out) _o12 =
                LANES(court_limited)(time_limit);
            M limited = _o12.limited;
            const LANES(court_kept_out) _o13 =
                LANES(court_kept)(mode, when);
            M kept = _o13.kept;
            when = _o13.when;
            M rests = _o13.rests;
            M rolling = _o13.rolling;
            V began = _o13.began;
            const LANES(court_left_out) _o14 =
                LANES(court_left)(K(3.0), last);
            V leaving = _o14.leaving;
            const LANES(court_end_arrival_out) _o15 =
                LANES(court_end_arrival)(leaving, z, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[18]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[23]), lanes_load(lists->fixed[24]), lanes_load(lists->fixed[25]));
            V time = _o15.time;
            V rate = _o15.rate;
            V bend = _o15.bend;
            V apex = _o15.apex;
            const LANES(court_meeting_plane_out) _o16 =
                LANES(court_meeting_plane)(apex, bend, rate, time);
            M arrives = _o16.arrives;
            const LANES(court_timely_out) _o17 =
                LANES(court_timely)(arrives, K(0.0), K(0.0), time, when);
            M possible = _o17.possible;
            const M _m18 = lanes_both(rows, possible);
            {
                const LANES(court_sooner_out) _o19 =
                    LANES(court_sooner)(arrives, K(3.0), time, when, which);
                when = lanes_select(_m18, _o19.when, when);
                which = lanes_select(_m18, _o19.which, which);
            }
            const LANES(court_horizon_out) _o20 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[20]));
            V until = _o20.horizon;
            const LANES(court_ring_clear_out) _o21 =
                LANES(court_ring_clear)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[26]), lanes_load(lists->fixed[27]), lanes_load(lists->fixed[28]), lanes_load(lists->fixed[29]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[20]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[14]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[34]), lanes_load(lists->fixed[35]), lanes_load(lists->fixed[36]), lanes_load(lists->fixed[37]), lanes_load(lists->fixed[38]), lanes_load(lists->fixed[39]), lanes_load(lists->fixed[40]));
            V clear = _o21.clear;
            const LANES(court_opens_in_flight_out) _o22 =
                LANES(court_opens_in_flight)(clear, kept);
            M open = _o22.open;
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->open_p_ball_radius + open_shots, packed, lanes_load(lists->p_ball_radius + (i & varying)));
                    lanes_pack(lists->open_p_gravity + open_shots, packed, lanes_load(lists->p_gravity + (i & varying)));
                    lanes_pack(lists->open_p_ring_radius + open_shots, packed, lanes_load(lists->p_ring_radius + (i & varying)));
                    lanes_pack(lists->open_p_wire_radius + open_shots, packed, lanes_load(lists->p_wire_radius + (i & varying)));
                }
                open_shots += lanes_many(packed);
            }
        }
        {
        size_t open_leaping_shots = 0;
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_shots - i);
            if (LANES_SELDOM(varying))
                LANES(court_plain_fix_f23)(lists, i);
            V extent = lanes_load(lists->open_extent + i);
            V last = lanes_load(lists->open_last + i);
            V speed = lanes_load(lists->open_speed + i);
            V until = lanes_load(lists->open_until + i);
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
                LANES(court_ring_opened)(lanes_narrow(until), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(extent), lanes_narrow(speed), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[2]), singles_load(lists->fixed_single[3]), singles_load(lists->fixed_single[4]), singles_load(lists->fixed_single[5]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[7]), singles_load(lists->fixed_single[8]), singles_load(lists->fixed_single[9]));
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
            const LANES(court_ring_started_out) _o28 =
                LANES(court_ring_started)(x, y, z, vx, vy, vz, lanes_load(lists->fixed[7]));
            V rho_start = _o28.rho_start;
            V parting = _o28.parting;
            V drift = _o28.drift;
            const LANES(court_flight_out) _o29 =
                LANES(court_flight)(since, x, y, z, vx, vy, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[32]));
            V near_x = _o29.x;
            V near_y = _o29.y;
            V near_z = _o29.z;
            V near_vz = _o29.vz;
            const LANES(court_ring_grain_out) _o30 =
                LANES(court_ring_grain)(onset, wide_end, lanes_narrow(leaving), lapsed, lanes_narrow(near_x), lanes_narrow(near_y), lanes_narrow(near_z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(near_vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(parting), lanes_narrow(drift), wide_low1, wide_high1, wide_low2, wide_high2, singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[10]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[11]), singles_load(lists->fixed_single[12]), singles_load(lists->fixed_single[13]), singles_load(lists->fixed_single[14]), singles_load(lists->fixed_single[15]), singles_load(lists->fixed_single[4]), singles_load(lists->fixed_single[16]), singles_load(lists->fixed_single[17]), singles_load(lists->fixed_single[18]));
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
            const M _m32 = lanes_both(rows, leaping);
            if (lanes_any(_m32)) {
                const LANES(court_ring_leap_out) _o33 =
                    LANES(court_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, singles_load(lists->fixed_single[19]), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[20]), singles_load(lists->fixed_single[21]), singles_load(lists->fixed_single[22]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[23]), singles_load(lists->fixed_single[24]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[25]));
                short_t = singles_select(singles_of(_m32), _o33.t, short_t);
                short_end = singles_select(singles_of(_m32), _o33.end, short_end);
                certain = lanes_choose(_m32, _o33.certain, certain);
                leaping = lanes_choose(_m32, _o33.leaping, leaping);
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->open_leaping_p_ball_radius + open_leaping_shots, packed, lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius));
                    lanes_pack(lists->open_leaping_p_gravity + open_leaping_shots, packed, lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity));
                    lanes_pack(lists->open_leaping_p_ring_radius + open_leaping_shots, packed, lanes_load(varying ? lists->open_p_ring_radius + i : lists->p_ring_radius));
                    lanes_pack(lists->open_leaping_p_wire_radius + open_leaping_shots, packed, lanes_load(varying ? lists->open_p_wire_radius + i : lists->p_wire_radius));
                }
                open_leaping_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
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
                    if (LANES_SELDOM(varying))
                        LANES(court_plain_fix_f34)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_leaping_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M leaping = active;
                const LANES(court_ring_leap_out) _o35 =
                    LANES(court_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, singles_load(lists->fixed_single[19]), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[20]), singles_load(lists->fixed_single[21]), singles_load(lists->fixed_single[22]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[23]), singles_load(lists->fixed_single[24]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[25]));
                short_t = _o35.t;
                short_end = _o35.end;
                M certain = _o35.certain;
                leaping = _o35.leaping;
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
            const LANES(court_leapt_out) _o36 =
                LANES(court_leapt)(arrival, certain, lanes_wide(short_t), searching, served, since);
            arrival = _o36.arrival;
            V t = _o36.t;
            searching = _o36.searching;
            lanes_store(lists->open_arrival + i, arrival);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_searching_row + open_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_searching_arrival + open_searching_shots, packed, arrival);
                lanes_pack(lists->open_searching_certain + open_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->open_searching_extent + open_searching_shots, packed, extent);
                lanes_pack(lists->open_searching_last + open_searching_shots, packed, last);
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->open_searching_p_ball_radius + open_searching_shots, packed, lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius));
                    lanes_pack(lists->open_searching_p_gravity + open_searching_shots, packed, lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity));
                    lanes_pack(lists->open_searching_p_ring_radius + open_searching_shots, packed, lanes_load(varying ? lists->open_p_ring_radius + i : lists->p_ring_radius));
                    lanes_pack(lists->open_searching_p_wire_radius + open_searching_shots, packed, lanes_load(varying ? lists->open_p_wire_radius + i : lists->p_wire_radius));
                }
                open_searching_shots += lanes_many(packed);
            }
        }
        {
        size_t open_searching_searching_shots = 0;
        for (size_t i = 0; i < open_searching_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_searching_shots - i);
            if (LANES_SELDOM(varying))
                LANES(court_plain_fix_f37)(lists, i);
            V arrival = lanes_load(lists->open_searching_arrival + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_searching_certain + i));
            V extent = lanes_load(lists->open_searching_extent + i);
            V last = lanes_load(lists->open_searching_last + i);
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
            const LANES(court_ring_prepare_out) _o38 =
                LANES(court_ring_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[35]), lanes_load(lists->fixed[39]), lanes_load(lists->fixed[29]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[20]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[37]), lanes_load(lists->fixed[36]), lanes_load(lists->fixed[41]), lanes_load(lists->fixed[26]), lanes_load(lists->fixed[42]), lanes_load(lists->fixed[43]), lanes_load(lists->fixed[44]), lanes_load(lists->fixed[27]), lanes_load(lists->fixed[28]));
            V steady = _o38.steady;
            V swing = _o38.swing;
            V rho_start = _o38.rho_start;
            V low0 = _o38.low0;
            V high0 = _o38.high0;
            V low1 = _o38.low1;
            V high1 = _o38.high1;
            V low2 = _o38.low2;
            V high2 = _o38.high2;
            V ceiling = _o38.ceiling;
            V latest = _o38.latest;
            const LANES(court_allowance_out) _o39 =
                LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[21]));
            V position_level = _o39.position_level;
            V velocity_level = _o39.velocity_level;
            const LANES(court_ring_margins_out) _o40 =
                LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[29]), lanes_load(lists->fixed[45]), lanes_load(lists->fixed[46]), lanes_load(lists->fixed[47]), lanes_load(lists->fixed[48]));
            V flat = _o40.margin;
            V tilt = _o40.leaving_margin;
            V rate_slack = _o40.rate_margin;
            const LANES(court_ring_enter_out) _o41 =
                LANES(court_ring_enter)(t, K(0.0), high0, high1, high2, low0, low1, low2, t);
            t = _o41.t;
            V end = _o41.end;
            M searching = _o41.searching;
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->open_searching_searching_p_ball_radius + open_searching_searching_shots, packed, lanes_load(varying ? lists->open_searching_p_ball_radius + i : lists->p_ball_radius));
                    lanes_pack(lists->open_searching_searching_p_gravity + open_searching_searching_shots, packed, lanes_load(varying ? lists->open_searching_p_gravity + i : lists->p_gravity));
                    lanes_pack(lists->open_searching_searching_p_ring_radius + open_searching_searching_shots, packed, lanes_load(varying ? lists->open_searching_p_ring_radius + i : lists->p_ring_radius));
                    lanes_pack(lists->open_searching_searching_p_wire_radius + open_searching_searching_shots, packed, lanes_load(varying ? lists->open_searching_p_wire_radius + i : lists->p_wire_radius));
                }
                open_searching_searching_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
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
                    if (LANES_SELDOM(varying))
                        LANES(court_plain_fix_f42)(lists, taken, idle);
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
                    LANES(court_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[14]), lanes_load(lists->fixed[49]), lanes_load(lists->fixed[29]), lanes_load(lists->fixed[50]), lanes_load(lists->fixed[51]));
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
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[21]));
                    V position_level = _o48.position_level;
                    V velocity_level = _o48.velocity_level;
                    const LANES(court_ring_margins_out) _o49 =
                        LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[29]), lanes_load(lists->fixed[45]), lanes_load(lists->fixed[46]), lanes_load(lists->fixed[47]), lanes_load(lists->fixed[48]));
                    flat = lanes_select(_m46, _o49.margin, flat);
                    tilt = lanes_select(_m46, _o49.leaving_margin, tilt);
                    rate_slack = lanes_select(_m46, _o49.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o50 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o50.arrival;
                certain = _o50.certain;
                M exhausted = _o50.exhausted;
                searching = _o50.searching;
                t = _o50.t;
                const M _m51 = lanes_both(active, exhausted);
                {
                    const LANES(court_ring_enter_out) _o52 =
                        LANES(court_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m51, _o52.t, t);
                    end = lanes_select(_m51, _o52.end, end);
                    searching = lanes_choose(_m51, _o52.searching, searching);
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
            if (LANES_SELDOM(varying))
                LANES(court_plain_fix_f53)(lists, i);
            V arrival = lanes_load(lists->open_arrival + i);
            V ceiling = lanes_load(lists->open_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_certain + i));
            V flat = lanes_load(lists->open_flat + i);
            V last = lanes_load(lists->open_last + i);
            V rho_start = lanes_load(lists->open_rho_start + i);
            V tilt = lanes_load(lists->open_tilt + i);
            V vx = lanes_load(lists->open_vx + i);
            V vy = lanes_load(lists->open_vy + i);
            V vz = lanes_load(lists->open_vz + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(court_found_out) _o54 =
                LANES(court_found)(arrival);
            M arrives = _o54.arrives;
            M refining = _o54.refining;
            const LANES(court_nearby_out) _o55 =
                LANES(court_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o55.leaving;
            const M _m56 = lanes_both(rows, refining);
            if (lanes_any(_m56)) {
                const LANES(court_ring_refine_out) _o57 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[14]));
                V refined = _o57.time;
                V gap = _o57.gap;
                V rate = _o57.rate;
                const LANES(court_polished_out) _o58 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m56, _o58.arrival, arrival);
                refining = lanes_choose(_m56, _o58.refining, refining);
            }
            const M _m59 = lanes_both(rows, refining);
            if (lanes_any(_m59)) {
                const LANES(court_ring_refine_out) _o60 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[14]));
                V refined = _o60.time;
                V gap = _o60.gap;
                V rate = _o60.rate;
                const LANES(court_polished_out) _o61 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m59, _o61.arrival, arrival);
                refining = lanes_choose(_m59, _o61.refining, refining);
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
                lanes_pack(lists->open_refining_rho_start + open_refining_shots, packed, rho_start);
                lanes_pack(lists->open_refining_vx + open_refining_shots, packed, vx);
                lanes_pack(lists->open_refining_vy + open_refining_shots, packed, vy);
                lanes_pack(lists->open_refining_vz + open_refining_shots, packed, vz);
                lanes_pack(lists->open_refining_x + open_refining_shots, packed, x);
                lanes_pack(lists->open_refining_y + open_refining_shots, packed, y);
                lanes_pack(lists->open_refining_z + open_refining_shots, packed, z);
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->open_refining_p_ball_radius + open_refining_shots, packed, lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius));
                    lanes_pack(lists->open_refining_p_gravity + open_refining_shots, packed, lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity));
                    lanes_pack(lists->open_refining_p_ring_radius + open_refining_shots, packed, lanes_load(varying ? lists->open_p_ring_radius + i : lists->p_ring_radius));
                    lanes_pack(lists->open_refining_p_wire_radius + open_refining_shots, packed, lanes_load(varying ? lists->open_p_wire_radius + i : lists->p_wire_radius));
                }
                open_refining_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
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
                    if (LANES_SELDOM(varying))
                        LANES(court_plain_fix_f62)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_ring_refine_out) _o63 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[14]));
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
            const LANES(court_landed_out) _o65 =
                LANES(court_landed)(arrival);
            V time = _o65.time;
            const LANES(court_sooner_out) _o66 =
                LANES(court_sooner)(arrives, K(0.0), time, when, which);
            when = _o66.when;
            which = _o66.which;
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
            if (LANES_SELDOM(varying))
                LANES(court_plain_fix_f67)(lists, i);
            V extent = lanes_load(lists->extent + i);
            M kept = lanes_less(K(0.0), lanes_load(lists->kept + i));
            V last = lanes_load(lists->last + i);
            V speed = lanes_load(lists->speed + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V when = lanes_load(lists->when + i);
            V which = lanes_load(lists->which + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const LANES(court_horizon_out) _o68 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[20]));
            V until = _o68.horizon;
            V pad = _o68.pad;
            const LANES(court_halved_out) _o69 =
                LANES(court_halved)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), K(0.0), pad, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[52]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[53]));
            V middle_x = _o69.middle_x;
            V reach_x = _o69.reach_x;
            V later_middle_x = _o69.later_middle_x;
            V later_reach_x = _o69.later_reach_x;
            V middle_y = _o69.middle_y;
            V reach_y = _o69.reach_y;
            V later_middle_y = _o69.later_middle_y;
            V later_reach_y = _o69.later_reach_y;
            V middle_z = _o69.middle_z;
            V reach_z = _o69.reach_z;
            V later_middle_z = _o69.later_middle_z;
            V later_reach_z = _o69.later_reach_z;
            const LANES(court_backboard_near_out) _o70 =
                LANES(court_backboard_near)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, later_middle_x, later_middle_y, later_middle_z, later_reach_x, later_reach_y, later_reach_z, lanes_load(lists->fixed[54]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[55]), lanes_load(lists->fixed[56]), lanes_load(lists->fixed[57]), lanes_load(lists->fixed[58]));
            M reachable = _o70.near;
            const LANES(court_reachable_in_flight_out) _o71 =
                LANES(court_reachable_in_flight)(kept, reachable);
            reachable = _o71.reachable;
            const M packed = lanes_both(rows, reachable);
            if (lanes_any(packed)) {
                lanes_pack(lists->reachable_row + reachable_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->reachable_extent + reachable_shots, packed, extent);
                lanes_pack(lists->reachable_last + reachable_shots, packed, last);
                lanes_pack(lists->reachable_speed + reachable_shots, packed, speed);
                lanes_pack(lists->reachable_vx + reachable_shots, packed, vx);
                lanes_pack(lists->reachable_vy + reachable_shots, packed, vy);
                lanes_pack(lists->reachable_vz + reachable_shots, packed, vz);
                lanes_pack(lists->reachable_when + reachable_shots, packed, when);
                lanes_pack(lists->reachable_which + reachable_shots, packed, which);
                lanes_pack(lists->reachable_x + reachable_shots, packed, x);
                lanes_pack(lists->reachable_y + reachable_shots, packed, y);
                lanes_pack(lists->reachable_z + reachable_shots, packed, z);
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->reachable_p_ball_radius + reachable_shots, packed, lanes_load(lists->p_ball_radius + (i & varying)));
                    lanes_pack(lists->reachable_p_board_bottom + reachable_shots, packed, lanes_load(lists->p_board_bottom + (i & varying)));
                    lanes_pack(lists->reachable_p_board_distance + reachable_shots, packed, lanes_load(lists->p_board_distance + (i & varying)));
                    lanes_pack(lists->reachable_p_board_half_width + reachable_shots, packed, lanes_load(lists->p_board_half_width + (i & varying)));
                    lanes_pack(lists->reachable_p_board_thickness + reachable_shots, packed, lanes_load(lists->p_board_thickness + (i & varying)));
                    lanes_pack(lists->reachable_p_board_top + reachable_shots, packed, lanes_load(lists->p_board_top + (i & varying)));
                    lanes_pack(lists->reachable_p_gravity + reachable_shots, packed, lanes_load(lists->p_gravity + (i & varying)));
                }
                reachable_shots += lanes_many(packed);
            }
        }
        {
        size_t reachable_searching_shots = 0;
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(reachable_shots - i);
            if (LANES_SELDOM(varying))
                LANES(court_plain_fix_f72)(lists, i);
            V extent = lanes_load(lists->reachable_extent + i);
            V last = lanes_load(lists->reachable_last + i);
            V speed = lanes_load(lists->reachable_speed + i);
            V vx = lanes_load(lists->reachable_vx + i);
            V vy = lanes_load(lists->reachable_vy + i);
            V vz = lanes_load(lists->reachable_vz + i);
            V when = lanes_load(lists->reachable_when + i);
            V x = lanes_load(lists->reachable_x + i);
            V y = lanes_load(lists->reachable_y + i);
            V z = lanes_load(lists->reachable_z + i);
            const LANES(court_horizon_out) _o73 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[20]));
            V until = _o73.horizon;
            const LANES(court_backboard_prepare_out) _o74 =
                LANES(court_backboard_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[59]), lanes_load(lists->fixed[60]), lanes_load(lists->fixed[61]), lanes_load(lists->fixed[62]), lanes_load(lists->fixed[63]), lanes_load(lists->fixed[64]), lanes_load(lists->fixed[65]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[20]), lanes_load(lists->fixed[66]), lanes_load(lists->fixed[42]), lanes_load(lists->fixed[67]), lanes_load(lists->fixed[68]), lanes_load(lists->fixed[69]));
            V low0 = _o74.low0;
            V high0 = _o74.high0;
            V low1 = _o74.low1;
            V high1 = _o74.high1;
            V ceiling = _o74.ceiling;
            V latest = _o74.latest;
            const LANES(court_beginning_out) _o75 =
                LANES(court_beginning)();
            V share = _o75.share;
            V arrival = _o75.arrival;
            M certain = _o75.certain;
            const LANES(court_allowance_out) _o76 =
                LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[21]));
            V position_level = _o76.position_level;
            V velocity_level = _o76.velocity_level;
            const LANES(court_backboard_margins_out) _o77 =
                LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[70]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[72]), lanes_load(lists->fixed[73]), lanes_load(lists->fixed[74]), lanes_load(lists->fixed[75]), lanes_load(lists->fixed[76]), lanes_load(lists->fixed[77]), lanes_load(lists->fixed[78]), lanes_load(lists->fixed[79]), lanes_load(lists->fixed[80]));
            V flat = _o77.margin;
            V tilt = _o77.leaving_margin;
            V rate_slack = _o77.rate_margin;
            const LANES(court_backboard_enter_out) _o78 =
                LANES(court_backboard_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o78.t;
            V end = _o78.end;
            M searching = _o78.searching;
            const M _m79 = lanes_both(rows, searching);
            if (lanes_any(_m79)) {
                const LANES(court_nearby_out) _o80 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o80.leaving;
                V margin = _o80.margin;
                const LANES(court_backboard_advance_out) _o81 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[81]), lanes_load(lists->fixed[82]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[83]));
                V gap = _o81.gap;
                V rate = _o81.rate;
                V bend = _o81.bend;
                V step = _o81.step;
                V next = _o81.next;
                V clearance = _o81.clearance;
                const LANES(court_struck_or_still_out) _o82 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o82.hit;
                M sure = _o82.sure;
                M vague = _o82.vague;
                const M _m83 = lanes_both(_m79, vague);
                if (lanes_any(_m83)) {
                    const LANES(court_finer_out) _o84 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m83, _o84.share, share);
                    const LANES(court_allowance_out) _o85 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[21]));
                    V position_level = _o85.position_level;
                    V velocity_level = _o85.velocity_level;
                    const LANES(court_backboard_margins_out) _o86 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[70]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[72]), lanes_load(lists->fixed[73]), lanes_load(lists->fixed[74]), lanes_load(lists->fixed[75]), lanes_load(lists->fixed[76]), lanes_load(lists->fixed[77]), lanes_load(lists->fixed[78]), lanes_load(lists->fixed[79]), lanes_load(lists->fixed[80]));
                    flat = lanes_select(_m83, _o86.margin, flat);
                    tilt = lanes_select(_m83, _o86.leaving_margin, tilt);
                    rate_slack = lanes_select(_m83, _o86.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o87 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = lanes_select(_m79, _o87.arrival, arrival);
                certain = lanes_choose(_m79, _o87.certain, certain);
                M exhausted = _o87.exhausted;
                searching = lanes_choose(_m79, _o87.searching, searching);
                t = lanes_select(_m79, _o87.t, t);
                const M _m88 = lanes_both(_m79, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o89 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m88, _o89.t, t);
                    end = lanes_select(_m88, _o89.end, end);
                    searching = lanes_choose(_m88, _o89.searching, searching);
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->reachable_searching_p_ball_radius + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius));
                    lanes_pack(lists->reachable_searching_p_board_bottom + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_board_bottom + i : lists->p_board_bottom));
                    lanes_pack(lists->reachable_searching_p_board_distance + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance));
                    lanes_pack(lists->reachable_searching_p_board_half_width + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_board_half_width + i : lists->p_board_half_width));
                    lanes_pack(lists->reachable_searching_p_board_thickness + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_board_thickness + i : lists->p_board_thickness));
                    lanes_pack(lists->reachable_searching_p_board_top + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_board_top + i : lists->p_board_top));
                    lanes_pack(lists->reachable_searching_p_gravity + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity));
                }
                reachable_searching_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
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
                    if (LANES_SELDOM(varying))
                        LANES(court_plain_fix_f90)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = reachable_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o91 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o91.leaving;
                V margin = _o91.margin;
                const LANES(court_backboard_advance_out) _o92 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[81]), lanes_load(lists->fixed[82]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[83]));
                V gap = _o92.gap;
                V rate = _o92.rate;
                V bend = _o92.bend;
                V step = _o92.step;
                V next = _o92.next;
                V clearance = _o92.clearance;
                const LANES(court_struck_or_still_out) _o93 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o93.hit;
                M sure = _o93.sure;
                M vague = _o93.vague;
                const M _m94 = lanes_both(active, vague);
                if (lanes_any(_m94)) {
                    const LANES(court_finer_out) _o95 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m94, _o95.share, share);
                    const LANES(court_allowance_out) _o96 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[21]));
                    V position_level = _o96.position_level;
                    V velocity_level = _o96.velocity_level;
                    const LANES(court_backboard_margins_out) _o97 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[70]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[72]), lanes_load(lists->fixed[73]), lanes_load(lists->fixed[74]), lanes_load(lists->fixed[75]), lanes_load(lists->fixed[76]), lanes_load(lists->fixed[77]), lanes_load(lists->fixed[78]), lanes_load(lists->fixed[79]), lanes_load(lists->fixed[80]));
                    flat = lanes_select(_m94, _o97.margin, flat);
                    tilt = lanes_select(_m94, _o97.leaving_margin, tilt);
                    rate_slack = lanes_select(_m94, _o97.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o98 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o98.arrival;
                certain = _o98.certain;
                M exhausted = _o98.exhausted;
                searching = _o98.searching;
                t = _o98.t;
                const M _m99 = lanes_both(active, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o100 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m99, _o100.t, t);
                    end = lanes_select(_m99, _o100.end, end);
                    searching = lanes_choose(_m99, _o100.searching, searching);
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
            if (LANES_SELDOM(varying))
                LANES(court_plain_fix_f101)(lists, i);
            V arrival = lanes_load(lists->reachable_arrival + i);
            V ceiling = lanes_load(lists->reachable_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->reachable_certain + i));
            V flat = lanes_load(lists->reachable_flat + i);
            V last = lanes_load(lists->reachable_last + i);
            V tilt = lanes_load(lists->reachable_tilt + i);
            V vx = lanes_load(lists->reachable_vx + i);
            V vy = lanes_load(lists->reachable_vy + i);
            V vz = lanes_load(lists->reachable_vz + i);
            V x = lanes_load(lists->reachable_x + i);
            V y = lanes_load(lists->reachable_y + i);
            V z = lanes_load(lists->reachable_z + i);
            const LANES(court_found_out) _o102 =
                LANES(court_found)(arrival);
            M arrives = _o102.arrives;
            M refining = _o102.refining;
            const LANES(court_nearby_out) _o103 =
                LANES(court_nearby)(flat, K(1.0), last, arrival, tilt);
            V leaving = _o103.leaving;
            const M _m104 = lanes_both(rows, refining);
            if (lanes_any(_m104)) {
                const LANES(court_backboard_refine_out) _o105 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[81]));
                V refined = _o105.time;
                V gap = _o105.gap;
                V rate = _o105.rate;
                const LANES(court_polished_out) _o106 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m104, _o106.arrival, arrival);
                refining = lanes_choose(_m104, _o106.refining, refining);
            }
            const M _m107 = lanes_both(rows, refining);
            if (lanes_any(_m107)) {
                const LANES(court_backboard_refine_out) _o108 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[81]));
                V refined = _o108.time;
                V gap = _o108.gap;
                V rate = _o108.rate;
                const LANES(court_polished_out) _o109 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m107, _o109.arrival, arrival);
                refining = lanes_choose(_m107, _o109.refining, refining);
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
                lanes_pack(lists->reachable_refining_vx + reachable_refining_shots, packed, vx);
                lanes_pack(lists->reachable_refining_vy + reachable_refining_shots, packed, vy);
                lanes_pack(lists->reachable_refining_vz + reachable_refining_shots, packed, vz);
                lanes_pack(lists->reachable_refining_x + reachable_refining_shots, packed, x);
                lanes_pack(lists->reachable_refining_y + reachable_refining_shots, packed, y);
                lanes_pack(lists->reachable_refining_z + reachable_refining_shots, packed, z);
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->reachable_refining_p_ball_radius + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius));
                    lanes_pack(lists->reachable_refining_p_board_bottom + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_board_bottom + i : lists->p_board_bottom));
                    lanes_pack(lists->reachable_refining_p_board_distance + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance));
                    lanes_pack(lists->reachable_refining_p_board_half_width + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_board_half_width + i : lists->p_board_half_width));
                    lanes_pack(lists->reachable_refining_p_board_thickness + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_board_thickness + i : lists->p_board_thickness));
                    lanes_pack(lists->reachable_refining_p_board_top + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_board_top + i : lists->p_board_top));
                    lanes_pack(lists->reachable_refining_p_gravity + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity));
                }
                reachable_refining_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
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
                    if (LANES_SELDOM(varying))
                        LANES(court_plain_fix_f110)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = reachable_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_backboard_refine_out) _o111 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[81]));
                V refined = _o111.time;
                V gap = _o111.gap;
                V rate = _o111.rate;
                const LANES(court_polished_out) _o112 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o112.arrival;
                refining = _o112.refining;
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
            const LANES(court_landed_out) _o113 =
                LANES(court_landed)(arrival);
            V time = _o113.time;
            const LANES(court_sooner_out) _o114 =
                LANES(court_sooner)(arrives, K(1.0), time, when, which);
            when = _o114.when;
            which = _o114.which;
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
            if (LANES_SELDOM(varying))
                LANES(court_plain_fix_f115)(lists, i);
            V extent = lanes_load(lists->extent + i);
            M kept = lanes_less(K(0.0), lanes_load(lists->kept + i));
            V last = lanes_load(lists->last + i);
            V speed = lanes_load(lists->speed + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V when = lanes_load(lists->when + i);
            V which = lanes_load(lists->which + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const LANES(court_horizon_out) _o116 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[20]));
            V until = _o116.horizon;
            V pad = _o116.pad;
            const LANES(court_halved_out) _o117 =
                LANES(court_halved)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), K(0.0), pad, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[52]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[53]));
            V middle_x = _o117.middle_x;
            V reach_x = _o117.reach_x;
            V later_middle_x = _o117.later_middle_x;
            V later_reach_x = _o117.later_reach_x;
            V middle_y = _o117.middle_y;
            V reach_y = _o117.reach_y;
            V later_middle_y = _o117.later_middle_y;
            V later_reach_y = _o117.later_reach_y;
            V middle_z = _o117.middle_z;
            V reach_z = _o117.reach_z;
            V later_middle_z = _o117.later_middle_z;
            V later_reach_z = _o117.later_reach_z;
            const LANES(court_bridge_near_out) _o118 =
                LANES(court_bridge_near)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, later_middle_x, later_middle_y, later_middle_z, later_reach_x, later_reach_y, later_reach_z, lanes_load(lists->fixed[54]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[84]), lanes_load(lists->fixed[85]), lanes_load(lists->fixed[86]), lanes_load(lists->fixed[87]));
            M reachable = _o118.near;
            const LANES(court_reachable_in_flight_out) _o119 =
                LANES(court_reachable_in_flight)(kept, reachable);
            reachable = _o119.reachable;
            const M packed = lanes_both(rows, reachable);
            if (lanes_any(packed)) {
                lanes_pack(lists->reachable_row + reachable_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->reachable_extent + reachable_shots, packed, extent);
                lanes_pack(lists->reachable_last + reachable_shots, packed, last);
                lanes_pack(lists->reachable_speed + reachable_shots, packed, speed);
                lanes_pack(lists->reachable_vx + reachable_shots, packed, vx);
                lanes_pack(lists->reachable_vy + reachable_shots, packed, vy);
                lanes_pack(lists->reachable_vz + reachable_shots, packed, vz);
                lanes_pack(lists->reachable_when + reachable_shots, packed, when);
                lanes_pack(lists->reachable_which + reachable_shots, packed, which);
                lanes_pack(lists->reachable_x + reachable_shots, packed, x);
                lanes_pack(lists->reachable_y + reachable_shots, packed, y);
                lanes_pack(lists->reachable_z + reachable_shots, packed, z);
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->reachable_p_ball_radius + reachable_shots, packed, lanes_load(lists->p_ball_radius + (i & varying)));
                    lanes_pack(lists->reachable_p_board_distance + reachable_shots, packed, lanes_load(lists->p_board_distance + (i & varying)));
                    lanes_pack(lists->reachable_p_bridge_depth + reachable_shots, packed, lanes_load(lists->p_bridge_depth + (i & varying)));
                    lanes_pack(lists->reachable_p_bridge_half_width + reachable_shots, packed, lanes_load(lists->p_bridge_half_width + (i & varying)));
                    lanes_pack(lists->reachable_p_gravity + reachable_shots, packed, lanes_load(lists->p_gravity + (i & varying)));
                    lanes_pack(lists->reachable_p_ring_radius + reachable_shots, packed, lanes_load(lists->p_ring_radius + (i & varying)));
                    lanes_pack(lists->reachable_p_wire_radius + reachable_shots, packed, lanes_load(lists->p_wire_radius + (i & varying)));
                }
                reachable_shots += lanes_many(packed);
            }
        }
        {
        size_t reachable_searching_shots = 0;
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(reachable_shots - i);
            if (LANES_SELDOM(varying))
                LANES(court_plain_fix_f120)(lists, i);
            V extent = lanes_load(lists->reachable_extent + i);
            V last = lanes_load(lists->reachable_last + i);
            V speed = lanes_load(lists->reachable_speed + i);
            V vx = lanes_load(lists->reachable_vx + i);
            V vy = lanes_load(lists->reachable_vy + i);
            V vz = lanes_load(lists->reachable_vz + i);
            V when = lanes_load(lists->reachable_when + i);
            V x = lanes_load(lists->reachable_x + i);
            V y = lanes_load(lists->reachable_y + i);
            V z = lanes_load(lists->reachable_z + i);
            const LANES(court_horizon_out) _o121 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[20]));
            V until = _o121.horizon;
            const LANES(court_bridge_prepare_out) _o122 =
                LANES(court_bridge_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[88]), lanes_load(lists->fixed[89]), lanes_load(lists->fixed[90]), lanes_load(lists->fixed[91]), lanes_load(lists->fixed[92]), lanes_load(lists->fixed[93]), lanes_load(lists->fixed[94]), lanes_load(lists->fixed[95]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[20]), lanes_load(lists->fixed[96]), lanes_load(lists->fixed[42]), lanes_load(lists->fixed[97]), lanes_load(lists->fixed[98]), lanes_load(lists->fixed[99]));
            V low0 = _o122.low0;
            V high0 = _o122.high0;
            V low1 = _o122.low1;
            V high1 = _o122.high1;
            V ceiling = _o122.ceiling;
            V latest = _o122.latest;
            const LANES(court_beginning_out) _o123 =
                LANES(court_beginning)();
            V share = _o123.share;
            V arrival = _o123.arrival;
            M certain = _o123.certain;
            const LANES(court_allowance_out) _o124 =
                LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[21]));
            V position_level = _o124.position_level;
            V velocity_level = _o124.velocity_level;
            const LANES(court_bridge_margins_out) _o125 =
                LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[70]), lanes_load(lists->fixed[100]), lanes_load(lists->fixed[101]), lanes_load(lists->fixed[102]), lanes_load(lists->fixed[103]), lanes_load(lists->fixed[104]), lanes_load(lists->fixed[105]), lanes_load(lists->fixed[106]), lanes_load(lists->fixed[107]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[109]));
            V flat = _o125.margin;
            V tilt = _o125.leaving_margin;
            V rate_slack = _o125.rate_margin;
            const LANES(court_bridge_enter_out) _o126 =
                LANES(court_bridge_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o126.t;
            V end = _o126.end;
            M searching = _o126.searching;
            const M _m127 = lanes_both(rows, searching);
            if (lanes_any(_m127)) {
                const LANES(court_nearby_out) _o128 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o128.leaving;
                V margin = _o128.margin;
                const LANES(court_bridge_advance_out) _o129 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[81]), lanes_load(lists->fixed[82]), lanes_load(lists->fixed[100]), lanes_load(lists->fixed[83]));
                V gap = _o129.gap;
                V rate = _o129.rate;
                V bend = _o129.bend;
                V step = _o129.step;
                V next = _o129.next;
                V clearance = _o129.clearance;
                const LANES(court_struck_or_still_out) _o130 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o130.hit;
                M sure = _o130.sure;
                M vague = _o130.vague;
                const M _m131 = lanes_both(_m127, vague);
                if (lanes_any(_m131)) {
                    const LANES(court_finer_out) _o132 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m131, _o132.share, share);
                    const LANES(court_allowance_out) _o133 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[21]));
                    V position_level = _o133.position_level;
                    V velocity_level = _o133.velocity_level;
                    const LANES(court_bridge_margins_out) _o134 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[70]), lanes_load(lists->fixed[100]), lanes_load(lists->fixed[101]), lanes_load(lists->fixed[102]), lanes_load(lists->fixed[103]), lanes_load(lists->fixed[104]), lanes_load(lists->fixed[105]), lanes_load(lists->fixed[106]), lanes_load(lists->fixed[107]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[109]));
                    flat = lanes_select(_m131, _o134.margin, flat);
                    tilt = lanes_select(_m131, _o134.leaving_margin, tilt);
                    rate_slack = lanes_select(_m131, _o134.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o135 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = lanes_select(_m127, _o135.arrival, arrival);
                certain = lanes_choose(_m127, _o135.certain, certain);
                M exhausted = _o135.exhausted;
                searching = lanes_choose(_m127, _o135.searching, searching);
                t = lanes_select(_m127, _o135.t, t);
                const M _m136 = lanes_both(_m127, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o137 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m136, _o137.t, t);
                    end = lanes_select(_m136, _o137.end, end);
                    searching = lanes_choose(_m136, _o137.searching, searching);
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->reachable_searching_p_ball_radius + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius));
                    lanes_pack(lists->reachable_searching_p_board_distance + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance));
                    lanes_pack(lists->reachable_searching_p_bridge_depth + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_bridge_depth + i : lists->p_bridge_depth));
                    lanes_pack(lists->reachable_searching_p_bridge_half_width + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_bridge_half_width + i : lists->p_bridge_half_width));
                    lanes_pack(lists->reachable_searching_p_gravity + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity));
                    lanes_pack(lists->reachable_searching_p_ring_radius + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_ring_radius + i : lists->p_ring_radius));
                    lanes_pack(lists->reachable_searching_p_wire_radius + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_wire_radius + i : lists->p_wire_radius));
                }
                reachable_searching_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
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
                    if (LANES_SELDOM(varying))
                        LANES(court_plain_fix_f138)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = reachable_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o139 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o139.leaving;
                V margin = _o139.margin;
                const LANES(court_bridge_advance_out) _o140 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[81]), lanes_load(lists->fixed[82]), lanes_load(lists->fixed[100]), lanes_load(lists->fixed[83]));
                V gap = _o140.gap;
                V rate = _o140.rate;
                V bend = _o140.bend;
                V step = _o140.step;
                V next = _o140.next;
                V clearance = _o140.clearance;
                const LANES(court_struck_or_still_out) _o141 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o141.hit;
                M sure = _o141.sure;
                M vague = _o141.vague;
                const M _m142 = lanes_both(active, vague);
                if (lanes_any(_m142)) {
                    const LANES(court_finer_out) _o143 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m142, _o143.share, share);
                    const LANES(court_allowance_out) _o144 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[21]));
                    V position_level = _o144.position_level;
                    V velocity_level = _o144.velocity_level;
                    const LANES(court_bridge_margins_out) _o145 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[70]), lanes_load(lists->fixed[100]), lanes_load(lists->fixed[101]), lanes_load(lists->fixed[102]), lanes_load(lists->fixed[103]), lanes_load(lists->fixed[104]), lanes_load(lists->fixed[105]), lanes_load(lists->fixed[106]), lanes_load(lists->fixed[107]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[109]));
                    flat = lanes_select(_m142, _o145.margin, flat);
                    tilt = lanes_select(_m142, _o145.leaving_margin, tilt);
                    rate_slack = lanes_select(_m142, _o145.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o146 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o146.arrival;
                certain = _o146.certain;
                M exhausted = _o146.exhausted;
                searching = _o146.searching;
                t = _o146.t;
                const M _m147 = lanes_both(active, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o148 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m147, _o148.t, t);
                    end = lanes_select(_m147, _o148.end, end);
                    searching = lanes_choose(_m147, _o148.searching, searching);
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
            if (LANES_SELDOM(varying))
                LANES(court_plain_fix_f149)(lists, i);
            V arrival = lanes_load(lists->reachable_arrival + i);
            V ceiling = lanes_load(lists->reachable_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->reachable_certain + i));
            V flat = lanes_load(lists->reachable_flat + i);
            V last = lanes_load(lists->reachable_last + i);
            V tilt = lanes_load(lists->reachable_tilt + i);
            V vx = lanes_load(lists->reachable_vx + i);
            V vy = lanes_load(lists->reachable_vy + i);
            V vz = lanes_load(lists->reachable_vz + i);
            V x = lanes_load(lists->reachable_x + i);
            V y = lanes_load(lists->reachable_y + i);
            V z = lanes_load(lists->reachable_z + i);
            const LANES(court_found_out) _o150 =
                LANES(court_found)(arrival);
            M arrives = _o150.arrives;
            M refining = _o150.refining;
            const LANES(court_nearby_out) _o151 =
                LANES(court_nearby)(flat, K(2.0), last, arrival, tilt);
            V leaving = _o151.leaving;
            const M _m152 = lanes_both(rows, refining);
            if (lanes_any(_m152)) {
                const LANES(court_bridge_refine_out) _o153 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[81]));
                V refined = _o153.time;
                V gap = _o153.gap;
                V rate = _o153.rate;
                const LANES(court_polished_out) _o154 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m152, _o154.arrival, arrival);
                refining = lanes_choose(_m152, _o154.refining, refining);
            }
            const M _m155 = lanes_both(rows, refining);
            if (lanes_any(_m155)) {
                const LANES(court_bridge_refine_out) _o156 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[81]));
                V refined = _o156.time;
                V gap = _o156.gap;
                V rate = _o156.rate;
                const LANES(court_polished_out) _o157 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m155, _o157.arrival, arrival);
                refining = lanes_choose(_m155, _o157.refining, refining);
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
                lanes_pack(lists->reachable_refining_vx + reachable_refining_shots, packed, vx);
                lanes_pack(lists->reachable_refining_vy + reachable_refining_shots, packed, vy);
                lanes_pack(lists->reachable_refining_vz + reachable_refining_shots, packed, vz);
                lanes_pack(lists->reachable_refining_x + reachable_refining_shots, packed, x);
                lanes_pack(lists->reachable_refining_y + reachable_refining_shots, packed, y);
                lanes_pack(lists->reachable_refining_z + reachable_refining_shots, packed, z);
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->reachable_refining_p_ball_radius + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius));
                    lanes_pack(lists->reachable_refining_p_board_distance + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance));
                    lanes_pack(lists->reachable_refining_p_bridge_depth + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_bridge_depth + i : lists->p_bridge_depth));
                    lanes_pack(lists->reachable_refining_p_bridge_half_width + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_bridge_half_width + i : lists->p_bridge_half_width));
                    lanes_pack(lists->reachable_refining_p_gravity + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity));
                    lanes_pack(lists->reachable_refining_p_ring_radius + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_ring_radius + i : lists->p_ring_radius));
                    lanes_pack(lists->reachable_refining_p_wire_radius + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_wire_radius + i : lists->p_wire_radius));
                }
                reachable_refining_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
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
                    if (LANES_SELDOM(varying))
                        LANES(court_plain_fix_f158)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = reachable_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_bridge_refine_out) _o159 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[81]));
                V refined = _o159.time;
                V gap = _o159.gap;
                V rate = _o159.rate;
                const LANES(court_polished_out) _o160 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o160.arrival;
                refining = _o160.refining;
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
            const LANES(court_landed_out) _o161 =
                LANES(court_landed)(arrival);
            V time = _o161.time;
            const LANES(court_sooner_out) _o162 =
                LANES(court_sooner)(arrives, K(2.0), time, when, which);
            when = _o162.when;
            which = _o162.which;
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
            const M _m163 = lanes_both(rows, limited);
            if (lanes_any(_m163)) {
                const LANES(court_expiry_out) _o164 =
                    LANES(court_expiry)(clock, K(INFINITY), K(0.0), time_error, time_limit, when, which);
                V time = _o164.time;
                M arrives = _o164.arrives;
                const LANES(court_sooner_out) _o165 =
                    LANES(court_sooner)(arrives, K(4.0), time, when, which);
                when = lanes_select(_m163, _o165.when, when);
                which = lanes_select(_m163, _o165.which, which);
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->kept_p_ball_radius + kept_shots, packed, lanes_load(lists->p_ball_radius + (i & varying)));
                    lanes_pack(lists->kept_p_board_bottom + kept_shots, packed, lanes_load(lists->p_board_bottom + (i & varying)));
                    lanes_pack(lists->kept_p_board_distance + kept_shots, packed, lanes_load(lists->p_board_distance + (i & varying)));
                    lanes_pack(lists->kept_p_board_half_width + kept_shots, packed, lanes_load(lists->p_board_half_width + (i & varying)));
                    lanes_pack(lists->kept_p_board_thickness + kept_shots, packed, lanes_load(lists->p_board_thickness + (i & varying)));
                    lanes_pack(lists->kept_p_board_top + kept_shots, packed, lanes_load(lists->p_board_top + (i & varying)));
                    lanes_pack(lists->kept_p_bridge_depth + kept_shots, packed, lanes_load(lists->p_bridge_depth + (i & varying)));
                    lanes_pack(lists->kept_p_bridge_half_width + kept_shots, packed, lanes_load(lists->p_bridge_half_width + (i & varying)));
                    lanes_pack(lists->kept_p_end_depth + kept_shots, packed, lanes_load(lists->p_end_depth + (i & varying)));
                    lanes_pack(lists->kept_p_gravity + kept_shots, packed, lanes_load(lists->p_gravity + (i & varying)));
                    lanes_pack(lists->kept_p_ring_radius + kept_shots, packed, lanes_load(lists->p_ring_radius + (i & varying)));
                    lanes_pack(lists->kept_p_wire_radius + kept_shots, packed, lanes_load(lists->p_wire_radius + (i & varying)));
                }
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
            if (LANES_SELDOM(varying))
                LANES(court_plain_fix_f373)(lists, i);
            const V p_ring_friction = lanes_load(lists->p_ring_friction + (i & varying));
            const V p_ring_restitution = lanes_load(lists->p_ring_restitution + (i & varying));
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
            const LANES(court_departed_out) _o374 =
                LANES(court_departed)(K(3.0), which);
            M moves = _o374.moves;
            M ends = _o374.ends;
            M touches = _o374.touches;
            V reached = _o374.reached;
            const LANES(court_body_of_out) _o375 =
                LANES(court_body_of)(which);
            V body = _o375.body;
            const M _m376 = lanes_both(rows, moves);
            if (lanes_any(_m376)) {
                const LANES(court_passing_out) _o377 =
                    LANES(court_passing)(through, when, x, y, z, vx, vy, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[20]), lanes_load(lists->fixed[19]));
                through = lanes_select(_m376, _o377.through, through);
                const LANES(court_flight_out) _o378 =
                    LANES(court_flight)(when, x, y, z, vx, vy, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[32]));
                x = lanes_select(_m376, _o378.x, x);
                y = lanes_select(_m376, _o378.y, y);
                z = lanes_select(_m376, _o378.z, z);
                vx = lanes_select(_m376, _o378.vx, vx);
                vy = lanes_select(_m376, _o378.vy, vy);
                vz = lanes_select(_m376, _o378.vz, vz);
                const LANES(court_ticked_out) _o379 =
                    LANES(court_ticked)(clock, when);
                clock = lanes_select(_m376, _o379.clock, clock);
            }
            const M _m380 = lanes_both(rows, limited);
            if (lanes_any(_m380)) {
                const LANES(court_expired_out) _o381 =
                    LANES(court_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m380, _o381.clock, clock);
                body = lanes_select(_m380, _o381.body, body);
                reached = lanes_select(_m380, _o381.reached, reached);
                ends = lanes_choose(_m380, _o381.ends, ends);
            }
            const M _m382 = lanes_both(rows, kept);
            if (lanes_any(_m382)) {
                const LANES(court_kept_on_out) _o383 =
                    LANES(court_kept_on)(began, body, clock, K(INFINITY), ends, held, last, reached, rests, rolling, rolls, which);
                body = lanes_select(_m382, _o383.body, body);
                reached = lanes_select(_m382, _o383.reached, reached);
                ends = lanes_choose(_m382, _o383.ends, ends);
                last = lanes_select(_m382, _o383.last, last);
                mode = lanes_select(_m382, _o383.mode, mode);
                held = lanes_select(_m382, _o383.held, held);
                rolls = lanes_select(_m382, _o383.rolls, rolls);
            }
            const LANES(court_here_out) _o384 =
                LANES(court_here)(K(3.0), which);
            M here = _o384.here;
            const M _m385 = lanes_both(rows, here);
            {
                const LANES(court_end_bounds_out) _o386 =
                    LANES(court_end_bounds)(x, y, lanes_load(lists->fixed[7]));
                V g0 = _o386.g0;
                const LANES(court_end_reached_out) _o387 =
                    LANES(court_end_reached)(g0, through);
                reached = lanes_select(_m385, _o387.reached, reached);
            }
            const LANES(court_accounted_out) _o388 =
                LANES(court_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o388.contacts;
            V outcome = _o388.outcome;
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
            const LANES(court_meeting_out) _o389 =
                LANES(court_meeting)(K(0.0), ends, touches);
            M meeting = _o389.meeting;
            const LANES(court_unslowed_out) _o390 =
                LANES(court_unslowed)();
            M slow = _o390.slow;
            const M _m391 = lanes_both(rows, meeting);
            if (lanes_any(_m391)) {
                const LANES(court_end_normal_out) _o392 =
                    LANES(court_end_normal)();
                V nx = _o392.nx;
                V ny = _o392.ny;
                V nz = _o392.nz;
                const LANES(court_here_out) _o393 =
                    LANES(court_here)(K(0.0), which);
                M here = _o393.here;
                const M _m394 = lanes_both(_m391, here);
                {
                    const LANES(court_ring_normal_out) _o395 =
                        LANES(court_ring_normal)(x, y, z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[110]));
                    nx = lanes_select(_m394, _o395.nx, nx);
                    ny = lanes_select(_m394, _o395.ny, ny);
                    nz = lanes_select(_m394, _o395.nz, nz);
                    const LANES(court_counted_out) _o396 =
                        LANES(court_counted)(count_0);
                    count_0 = lanes_select(_m394, _o396.count, count_0);
                }
                const LANES(court_here_out) _o397 =
                    LANES(court_here)(K(1.0), which);
                here = _o397.here;
                const M _m398 = lanes_both(_m391, here);
                {
                    const LANES(court_backboard_normal_out) _o399 =
                        LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[15]));
                    nx = lanes_select(_m398, _o399.nx, nx);
                    ny = lanes_select(_m398, _o399.ny, ny);
                    nz = lanes_select(_m398, _o399.nz, nz);
                    const LANES(court_counted_out) _o400 =
                        LANES(court_counted)(count_1);
                    count_1 = lanes_select(_m398, _o400.count, count_1);
                }
                const LANES(court_here_out) _o401 =
                    LANES(court_here)(K(2.0), which);
                here = _o401.here;
                const M _m402 = lanes_both(_m391, here);
                {
                    const LANES(court_bridge_normal_out) _o403 =
                        LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[16]));
                    nx = lanes_select(_m402, _o403.nx, nx);
                    ny = lanes_select(_m402, _o403.ny, ny);
                    nz = lanes_select(_m402, _o403.nz, nz);
                    const LANES(court_counted_out) _o404 =
                        LANES(court_counted)(count_2);
                    count_2 = lanes_select(_m402, _o404.count, count_2);
                }
                const LANES(court_untaken_out) _o405 =
                    LANES(court_untaken)();
                M struck_0 = _o405.mine;
                const LANES(court_ring_impact_taken_out) _o406 =
                    LANES(court_ring_impact_taken)(p_ring_restitution, p_ring_friction);
                V its_0_ring_impact = _o406.its_0;
                V its_1_ring_impact = _o406.its_1;
                {
                    const double *const _t408[][2] = {
                        {lists->p_ring_friction, lists->p_ring_restitution},
                        {lists->p_backboard_friction, lists->p_backboard_restitution},
                        {lists->p_bridge_friction, lists->p_bridge_restitution},
                    };
                    static const double _t409[][1] = {
                        {0.0},
                        {1.0},
                        {2.0},
                    };
                    for (size_t _k407 = 0; _k407 < 3; _k407++) {
                        const V own_1 = lanes_load(_t408[_k407][0] + (i & varying));
                        const V own_2 = lanes_load(_t408[_k407][1] + (i & varying));
                        const V own_index = K(_t409[_k407][0]);
                        const LANES(court_here_out) _o410 =
                            LANES(court_here)(own_index, which);
                        M here = _o410.here;
                        const M _m411 = lanes_both(_m391, here);
                        if (lanes_any(_m411)) {
                            const LANES(court_ring_impact_taken_out) _o412 =
                                LANES(court_ring_impact_taken)(own_2, own_1);
                            struck_0 = lanes_choose(_m411, _o412.mine, struck_0);
                            its_0_ring_impact = lanes_select(_m411, _o412.its_0, its_0_ring_impact);
                            its_1_ring_impact = lanes_select(_m411, _o412.its_1, its_1_ring_impact);
                        }
                    }
                }
                const M _m413 = lanes_both(_m391, struck_0);
                if (lanes_any(_m413)) {
                    const LANES(court_ring_impact_out) _o414 =
                        LANES(court_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, its_0_ring_impact, its_1_ring_impact, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[156]), lanes_load(lists->fixed[157]), lanes_load(lists->fixed[158]));
                    vx = lanes_select(_m413, _o414.vx, vx);
                    vy = lanes_select(_m413, _o414.vy, vy);
                    vz = lanes_select(_m413, _o414.vz, vz);
                    wx = lanes_select(_m413, _o414.wx, wx);
                    wy = lanes_select(_m413, _o414.wy, wy);
                    wz = lanes_select(_m413, _o414.wz, wz);
                }
                const M _m415 = lanes_both(_m391, touches);
                {
                    const LANES(court_touched_out) _o416 =
                        LANES(court_touched)(body, first, which);
                    first = lanes_select(_m415, _o416.first, first);
                    last = lanes_select(_m415, _o416.last, last);
                    const LANES(court_slowed_out) _o417 =
                        LANES(court_slowed)(nx, ny, nz, K(0.0), vx, vy, vz, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[159]), lanes_load(lists->fixed[160]));
                    slow = lanes_choose(_m415, _o417.slow, slow);
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->slow_p_backboard_friction + slow_shots, packed, lanes_load(lists->p_backboard_friction + (i & varying)));
                    lanes_pack(lists->slow_p_backboard_restitution + slow_shots, packed, lanes_load(lists->p_backboard_restitution + (i & varying)));
                    lanes_pack(lists->slow_p_ball_radius + slow_shots, packed, lanes_load(lists->p_ball_radius + (i & varying)));
                    lanes_pack(lists->slow_p_board_bottom + slow_shots, packed, lanes_load(lists->p_board_bottom + (i & varying)));
                    lanes_pack(lists->slow_p_board_distance + slow_shots, packed, lanes_load(lists->p_board_distance + (i & varying)));
                    lanes_pack(lists->slow_p_board_half_width + slow_shots, packed, lanes_load(lists->p_board_half_width + (i & varying)));
                    lanes_pack(lists->slow_p_board_thickness + slow_shots, packed, lanes_load(lists->p_board_thickness + (i & varying)));
                    lanes_pack(lists->slow_p_board_top + slow_shots, packed, lanes_load(lists->p_board_top + (i & varying)));
                    lanes_pack(lists->slow_p_bridge_depth + slow_shots, packed, lanes_load(lists->p_bridge_depth + (i & varying)));
                    lanes_pack(lists->slow_p_bridge_friction + slow_shots, packed, lanes_load(lists->p_bridge_friction + (i & varying)));
                    lanes_pack(lists->slow_p_bridge_half_width + slow_shots, packed, lanes_load(lists->p_bridge_half_width + (i & varying)));
                    lanes_pack(lists->slow_p_bridge_restitution + slow_shots, packed, lanes_load(lists->p_bridge_restitution + (i & varying)));
                    lanes_pack(lists->slow_p_end_depth + slow_shots, packed, lanes_load(lists->p_end_depth + (i & varying)));
                    lanes_pack(lists->slow_p_gravity + slow_shots, packed, lanes_load(lists->p_gravity + (i & varying)));
                    lanes_pack(lists->slow_p_ring_friction + slow_shots, packed, lanes_load(lists->p_ring_friction + (i & varying)));
                    lanes_pack(lists->slow_p_ring_radius + slow_shots, packed, lanes_load(lists->p_ring_radius + (i & varying)));
                    lanes_pack(lists->slow_p_ring_restitution + slow_shots, packed, lanes_load(lists->p_ring_restitution + (i & varying)));
                    lanes_pack(lists->slow_p_wire_radius + slow_shots, packed, lanes_load(lists->p_wire_radius + (i & varying)));
                }
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
    _Alignas(64) size_t shot[LANES_ROWS];
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
    LANES(court_column) permitted;
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
    LANES(court_column) turning_p_ball_radius;
    LANES(court_column) turning_p_gravity;
    LANES(court_column) turning_p_ring_radius;
    LANES(court_column) turning_p_wire_radius;
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
    LANES(court_column) turning_p_board_bottom;
    LANES(court_column) turning_p_board_distance;
    LANES(court_column) turning_p_board_half_width;
    LANES(court_column) turning_p_board_thickness;
    LANES(court_column) turning_p_board_top;
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
    LANES(court_column) turning_p_bridge_depth;
    LANES(court_column) turning_p_bridge_half_width;
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
    LANES(court_column) turning_p_backboard_friction;
    LANES(court_column) turning_p_bridge_friction;
    LANES(court_column) turning_p_end_depth;
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
    LANES(court_column) turning_p_ring_friction;
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
    /* What kernels make of parameters alone. */
    _Alignas(64) double fixed[186][LANES_WIDTH];
    _Alignas(64) float fixed_single[26][LANES_WIDTH];
} LANES(court_bounded_lists);

/* Look at the parameters of a row of lanes. */
LANES_INLINE void LANES(court_bounded_permitted)(LANES(court_bounded_lists) *lists, size_t row)
{
    lanes_store(lists->permitted + row, lanes_select(LANES(court_permit)(lanes_load(lists->p_ball_radius + row), lanes_load(lists->p_ring_radius + row), lanes_load(lists->p_wire_radius + row), lanes_load(lists->p_board_distance + row), lanes_load(lists->p_board_half_width + row), lanes_load(lists->p_board_bottom + row), lanes_load(lists->p_board_top + row), lanes_load(lists->p_board_thickness + row), lanes_load(lists->p_bridge_half_width + row), lanes_load(lists->p_bridge_depth + row), lanes_load(lists->p_gravity + row), lanes_load(lists->p_end_depth + row), lanes_load(lists->p_ring_restitution + row), lanes_load(lists->p_backboard_restitution + row), lanes_load(lists->p_bridge_restitution + row), lanes_load(lists->p_ring_friction + row), lanes_load(lists->p_backboard_friction + row), lanes_load(lists->p_bridge_friction + row), lanes_load(lists->p_tangential_restitution + row), lanes_load(lists->p_restitution_speed + row)), K(1.0), K(0.0)));
}

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
    if (job->varying)
        for (k = 0; k < shots; k += LANES_WIDTH)
            LANES(court_bounded_permitted)(lists, row + k);
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
    const size_t room = LANES_ROWS - row, shots = lists->waiting < room ? lists->waiting : room;
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

/* Make what kernels are given ready made, of the parameters of the first row. */
static void LANES(court_bounded_fix)(LANES(court_bounded_lists) *lists)
{
    (void)lists;
    const V p_backboard_friction = lanes_load(lists->p_backboard_friction);
    const V p_backboard_restitution = lanes_load(lists->p_backboard_restitution);
    const V p_ball_radius = lanes_load(lists->p_ball_radius);
    const V p_board_bottom = lanes_load(lists->p_board_bottom);
    const V p_board_distance = lanes_load(lists->p_board_distance);
    const V p_board_half_width = lanes_load(lists->p_board_half_width);
    const V p_board_thickness = lanes_load(lists->p_board_thickness);
    const V p_board_top = lanes_load(lists->p_board_top);
    const V p_bridge_depth = lanes_load(lists->p_bridge_depth);
    const V p_bridge_friction = lanes_load(lists->p_bridge_friction);
    const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width);
    const V p_bridge_restitution = lanes_load(lists->p_bridge_restitution);
    const V p_end_depth = lanes_load(lists->p_end_depth);
    const V p_gravity = lanes_load(lists->p_gravity);
    const V p_restitution_speed = lanes_load(lists->p_restitution_speed);
    const V p_ring_friction = lanes_load(lists->p_ring_friction);
    const V p_ring_radius = lanes_load(lists->p_ring_radius);
    const V p_ring_restitution = lanes_load(lists->p_ring_restitution);
    const V p_tangential_restitution = lanes_load(lists->p_tangential_restitution);
    const V p_wire_radius = lanes_load(lists->p_wire_radius);
    {
        const V _s0 = lanes_abs(p_board_bottom);
        const V _s1 = lanes_abs(p_board_top);
        const V _s2 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_abs(p_ball_radius), _s0), lanes_abs(p_board_distance)), lanes_abs(p_board_half_width)), lanes_abs(p_board_thickness)), _s1);
        const V _s3 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s2, lanes_abs(p_bridge_depth)), lanes_abs(p_bridge_half_width)), lanes_abs(p_end_depth)), lanes_abs(p_ring_radius)), lanes_abs(p_wire_radius));
        const V _s4 = lanes_mul(K(0.5), p_board_thickness);
        const V _s5 = lanes_add(p_board_distance, _s4);
        const V _s6 = lanes_add(p_ball_radius, _s4);
        const V _s7 = lanes_mul(K(0.5), p_board_distance);
        const V _s8 = lanes_mul(K(0.5), p_ring_radius);
        const V _s9 = lanes_add(_s7, _s8);
        const V _s10 = lanes_add(p_ball_radius, _s7);
        const V _s11 = lanes_sub(_s10, _s8);
        const V _s12 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s13 = lanes_add(p_board_distance, p_board_thickness);
        const V _s14 = lanes_div(K(1.0), p_gravity);
        const V _s15 = lanes_neg(p_gravity);
        const V _s16 = lanes_neg(_s14);
        const V _s17 = lanes_mul(K(1.00006103515625), _s12);
        const V _s18 = lanes_add(p_ring_radius, _s17);
        const V _s19 = lanes_mul(_s18, _s18);
        const V _s20 = lanes_mul(K(9.313225746154785e-10), _s19);
        const V _s21 = lanes_sub(p_ring_radius, _s17);
        const V _s22 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s23 = lanes_max(_s21, _s22);
        const V _s24 = lanes_mul(_s23, _s23);
        const V _s25 = lanes_div(K(1.0), _s23);
        const V _s26 = lanes_div(_s17, _s23);
        const V _s27 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s28 = lanes_mul(K(0.5), p_board_bottom);
        const V _s29 = lanes_mul(K(0.5), p_board_top);
        const V _s30 = lanes_add(_s28, _s29);
        const V _s31 = lanes_add(p_ball_radius, _s29);
        const V _s32 = lanes_sub(_s31, _s28);
        const V _s33 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s34 = lanes_min(_s33, _s6);
        const V _s35 = lanes_min(_s32, _s34);
        const V _s36 = lanes_mul(K(6.103515625e-05), _s35);
        const V _s37 = lanes_abs(_s15);
        const V _s38 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s35));
        const V _s39 = lanes_mul(K(1.25), _s37);
        const V _s40 = lanes_max(_s6, _s33);
        const V _s41 = lanes_mul(K(0.5), p_bridge_depth);
        const V _s42 = lanes_add(p_ball_radius, _s41);
        const V _s43 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s44 = lanes_min(_s43, _s11);
        const V _s45 = lanes_min(_s42, _s44);
        const V _s46 = lanes_mul(K(6.103515625e-05), _s45);
        const V _s47 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s45));
        const V _s48 = lanes_max(_s11, _s43);
        const V _s49 = lanes_mul(K(3.637978807091713e-12), p_ball_radius);
        const V _s50 = lanes_mul(K(1.4210854715202004e-14), p_ball_radius);
        const V _s51 = lanes_add(lanes_add(_s50, lanes_mul(K(2.842170943040401e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_board_thickness));
        const V _s52 = lanes_add(_s50, lanes_mul(K(2.842170943040401e-14), p_board_half_width));
        const V _s53 = lanes_add(lanes_add(_s50, lanes_mul(K(1.4210854715202004e-14), _s0)), lanes_mul(K(1.4210854715202004e-14), _s1));
        const V _s54 = lanes_add(lanes_add(_s50, lanes_mul(K(1.4210854715202004e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_ring_radius));
        const V _s55 = lanes_add(_s50, lanes_mul(K(2.842170943040401e-14), p_bridge_half_width));
        const V _s56 = lanes_add(lanes_add(_s50, lanes_mul(K(1.4210854715202004e-14), p_wire_radius)), lanes_mul(K(1.4210854715202004e-14), lanes_abs(lanes_sub(p_bridge_depth, p_wire_radius))));
        const V _s57 = lanes_neg(p_board_half_width);
        const V _s58 = lanes_max(K(0.0), _s57);
        const V _s59 = lanes_max(_s58, _s57);
        const V _s60 = lanes_neg(_s13);
        const V _s61 = lanes_max(K(0.0), _s60);
        const V _s62 = lanes_max(_s61, p_board_distance);
        const V _s63 = lanes_neg(p_board_distance);
        const V _s64 = lanes_max(K(0.0), _s63);
        const V _s65 = lanes_max(_s64, p_ring_radius);
        const V _s66 = lanes_neg(p_bridge_half_width);
        const V _s67 = lanes_max(K(0.0), _s66);
        const V _s68 = lanes_max(_s67, _s66);
        const V _s69 = lanes_mul(p_gravity, p_gravity);
        const V _s70 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(p_ball_radius, p_board_distance), p_board_half_width), p_board_thickness), p_bridge_depth), p_bridge_half_width), p_end_depth);
        const V _s71 = lanes_sub(lanes_sub(p_ring_radius, p_ball_radius), p_wire_radius);
        const V _s72 = lanes_add(K(0.4), lanes_mul(K(0.4), p_tangential_restitution));
        const V _s73 = lanes_sub(K(1.0), p_ring_restitution);
        const V _s74 = lanes_add(K(1.0), p_ring_restitution);
        const V _s75 = lanes_sub(K(1.0), p_backboard_restitution);
        const V _s76 = lanes_add(K(1.0), p_backboard_restitution);
        const V _s77 = lanes_sub(K(1.0), p_bridge_restitution);
        const V _s78 = lanes_add(K(1.0), p_bridge_restitution);
        lanes_store(lists->fixed[0], _s3);
        lanes_store(lists->fixed[1], lanes_add(lanes_add(p_ball_radius, p_ring_radius), p_wire_radius));
        lanes_store(lists->fixed[2], lanes_neg(_s5));
        lanes_store(lists->fixed[3], _s6);
        lanes_store(lists->fixed[4], lanes_neg(_s9));
        lanes_store(lists->fixed[5], _s11);
        lanes_store(lists->fixed[6], p_ball_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[14], lanes_mul(_s12, _s12));
        lanes_store(lists->fixed[15], _s13);
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[17], lanes_add(lanes_mul(K(4.0), p_ball_radius), lanes_mul(K(4.0), p_wire_radius)));
        lanes_store(lists->fixed[18], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[19], lanes_mul(p_ring_radius, p_ring_radius));
        lanes_store(lists->fixed[20], _s14);
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[22], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[23], _s15);
        lanes_store(lists->fixed[24], _s16);
        lanes_store(lists->fixed[25], lanes_mul(K(0.5), _s16));
        lanes_store(lists->fixed[26], lanes_mul(K(6.667843360785852e-16), p_end_depth));
        lanes_store(lists->fixed[27], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s12)));
        lanes_store(lists->fixed[28], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[29], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[30], _s17);
        lanes_store(lists->fixed[31], lanes_mul(K(5.820766091346741e-11), _s18));
        lanes_store(lists->fixed[32], lanes_mul(K(65536.0), _s18));
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[34], _s19);
        lanes_store(lists->fixed[35], _s20);
        lanes_store(lists->fixed[36], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[37], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s12));
        lanes_store(lists->fixed[38], _s24);
        lanes_store(lists->fixed[39], lanes_mul(_s23, _s24));
        lanes_store(lists->fixed[40], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[41], lanes_add(_s20, _s24));
        lanes_store(lists->fixed[42], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[43], lanes_mul(K(2.0), p_ball_radius));
        lanes_store(lists->fixed[44], lanes_mul(K(2.0), p_wire_radius));
        lanes_store(lists->fixed[45], lanes_mul(_s25, lanes_mul(_s25, _s25)));
        lanes_store(lists->fixed[46], _s18);
        lanes_store(lists->fixed[47], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s12), _s18));
        lanes_store(lists->fixed[48], lanes_mul(K(5.00030517578125), _s12));
        lanes_store(lists->fixed[49], lanes_max(K(1.0), _s26));
        lanes_store(lists->fixed[50], lanes_mul(K(6.0), p_gravity));
        lanes_store(lists->fixed[51], lanes_mul(K(9.094947017729282e-13), _s18));
        lanes_store(lists->fixed[52], _s23);
        lanes_store(lists->fixed[53], lanes_abs(K(0.0)));
        lanes_store(lists->fixed[54], lanes_mul(K(0.0625), p_gravity));
        lanes_store(lists->fixed[55], lanes_mul(K(1.0000000009313226), _s27));
        lanes_store(lists->fixed[56], lanes_mul(K(1.0000000009313226), _s4));
        lanes_store(lists->fixed[57], lanes_mul(K(1.0000000009313226), p_board_half_width));
        lanes_store(lists->fixed[58], _s30);
        lanes_store(lists->fixed[59], lanes_mul(K(1.0000000009313226), lanes_sub(_s29, _s28)));
        lanes_store(lists->fixed[60], _s29);
        lanes_store(lists->fixed[61], _s28);
        lanes_store(lists->fixed[62], _s35);
        lanes_store(lists->fixed[63], lanes_add(_s6, _s36));
        lanes_store(lists->fixed[64], _s5);
        lanes_store(lists->fixed[65], lanes_add(_s33, _s36));
        lanes_store(lists->fixed[66], lanes_sub(lanes_add(_s31, _s36), _s28));
        lanes_store(lists->fixed[67], lanes_mul(_s39, _s38));
        lanes_store(lists->fixed[68], lanes_abs(_s30));
        lanes_store(lists->fixed[69], lanes_max(_s40, _s32));
        lanes_store(lists->fixed[70], lanes_mul(K(1.52587890625e-05), _s35));
        lanes_store(lists->fixed[71], lanes_mul(K(5.55653613398821e-16), _s27));
        lanes_store(lists->fixed[72], _s38);
        lanes_store(lists->fixed[73], lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        lanes_store(lists->fixed[74], lanes_mul(K(2.001953125), _s38));
        lanes_store(lists->fixed[75], lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        lanes_store(lists->fixed[76], lanes_add(lanes_mul(K(2.220446049250313e-16), _s0), lanes_mul(K(2.220446049250313e-16), _s1)));
        lanes_store(lists->fixed[77], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s38, _s38)));
        lanes_store(lists->fixed[78], lanes_mul(K(12.01171875), _s38));
        lanes_store(lists->fixed[79], lanes_mul(K(6.667843360785852e-15), _s38));
        lanes_store(lists->fixed[80], lanes_mul(K(6.005859375), _s38));
        lanes_store(lists->fixed[81], lanes_mul(K(2.667137344314341e-15), _s38));
        lanes_store(lists->fixed[82], _s27);
        lanes_store(lists->fixed[83], _s37);
        lanes_store(lists->fixed[84], lanes_mul(K(0.5), _s37));
        lanes_store(lists->fixed[85], lanes_mul(K(1.0000000009313226), lanes_sub(_s7, _s8)));
        lanes_store(lists->fixed[86], lanes_mul(K(1.0000000009313226), p_bridge_half_width));
        lanes_store(lists->fixed[87], lanes_sub(p_wire_radius, _s41));
        lanes_store(lists->fixed[88], lanes_mul(K(1.0000000009313226), _s41));
        lanes_store(lists->fixed[89], _s7);
        lanes_store(lists->fixed[90], _s41);
        lanes_store(lists->fixed[91], _s8);
        lanes_store(lists->fixed[92], _s45);
        lanes_store(lists->fixed[93], lanes_sub(lanes_add(_s10, _s46), _s8));
        lanes_store(lists->fixed[94], _s9);
        lanes_store(lists->fixed[95], lanes_add(_s43, _s46));
        lanes_store(lists->fixed[96], lanes_add(_s42, _s46));
        lanes_store(lists->fixed[97], lanes_mul(_s39, _s47));
        lanes_store(lists->fixed[98], lanes_abs(lanes_sub(_s41, p_wire_radius)));
        lanes_store(lists->fixed[99], lanes_max(_s48, _s42));
        lanes_store(lists->fixed[100], lanes_mul(K(1.52587890625e-05), _s45));
        lanes_store(lists->fixed[101], _s47);
        lanes_store(lists->fixed[102], lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        lanes_store(lists->fixed[103], lanes_mul(K(2.001953125), _s47));
        lanes_store(lists->fixed[104], lanes_add(lanes_mul(K(1.1102230246251565e-16), p_board_distance), lanes_mul(K(1.1102230246251565e-16), p_ring_radius)));
        lanes_store(lists->fixed[105], lanes_add(lanes_mul(K(2.220446049250313e-16), p_bridge_depth), lanes_mul(K(5.551115123125783e-16), p_wire_radius)));
        lanes_store(lists->fixed[106], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s47, _s47)));
        lanes_store(lists->fixed[107], lanes_mul(K(12.01171875), _s47));
        lanes_store(lists->fixed[108], lanes_mul(K(6.667843360785852e-15), _s47));
        lanes_store(lists->fixed[109], lanes_mul(K(6.005859375), _s47));
        lanes_store(lists->fixed[110], lanes_mul(K(2.667137344314341e-15), _s47));
        lanes_store(lists->fixed[111], lanes_div(K(1.0), _s12));
        lanes_store(lists->fixed[112], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[113], _s49);
        lanes_store(lists->fixed[114], lanes_neg(_s49));
        lanes_store(lists->fixed[115], lanes_mul(K(1.4551915228366852e-11), p_ball_radius));
        lanes_store(lists->fixed[116], _s51);
        lanes_store(lists->fixed[117], lanes_neg(_s51));
        lanes_store(lists->fixed[118], _s52);
        lanes_store(lists->fixed[119], lanes_neg(_s52));
        lanes_store(lists->fixed[120], _s53);
        lanes_store(lists->fixed[121], lanes_neg(_s53));
        lanes_store(lists->fixed[122], _s54);
        lanes_store(lists->fixed[123], lanes_neg(_s54));
        lanes_store(lists->fixed[124], _s55);
        lanes_store(lists->fixed[125], lanes_neg(_s55));
        lanes_store(lists->fixed[126], _s56);
        lanes_store(lists->fixed[127], lanes_neg(_s56));
        lanes_store(lists->fixed[128], lanes_mul(K(0.6), p_gravity));
        lanes_store(lists->fixed[129], lanes_mul(K(0.015625), p_gravity));
        lanes_store(lists->fixed[130], lanes_mul(K(0.4), p_gravity));
        lanes_store(lists->fixed[131], lanes_mul(p_backboard_friction, p_backboard_friction));
        lanes_store(lists->fixed[132], lanes_mul(p_bridge_friction, p_bridge_friction));
        lanes_store(lists->fixed[133], lanes_mul(K(5.684341886080802e-14), lanes_sqrt(lanes_mul(p_ball_radius, p_gravity))));
        lanes_store(lists->fixed[134], lanes_mul(K(5.684341886080802e-14), p_gravity));
        lanes_store(lists->fixed[135], _s12);
        lanes_store(lists->fixed[136], p_bridge_depth);
        lanes_store(lists->fixed[137], lanes_mul(K(1.1102230246251565e-16), p_ball_radius));
        lanes_store(lists->fixed[138], lanes_mul(K(2.384185791015625e-07), p_ball_radius));
        lanes_store(lists->fixed[139], lanes_mul(K(0.6), p_ring_radius));
        lanes_store(lists->fixed[140], lanes_mul(K(0.3333333333333333), p_ring_radius));
        lanes_store(lists->fixed[141], lanes_mul(K(0.25), p_ring_radius));
        lanes_store(lists->fixed[142], lanes_mul(K(0.2), p_ring_radius));
        lanes_store(lists->fixed[143], lanes_mul(K(0.16666666666666666), p_ring_radius));
        lanes_store(lists->fixed[144], lanes_mul(K(0.14285714285714285), p_ring_radius));
        lanes_store(lists->fixed[145], lanes_mul(K(0.125), p_ring_radius));
        lanes_store(lists->fixed[146], lanes_mul(K(0.1111111111111111), p_ring_radius));
        lanes_store(lists->fixed[147], lanes_mul(K(0.1), p_ring_radius));
        lanes_store(lists->fixed[148], lanes_mul(K(0.09090909090909091), p_ring_radius));
        lanes_store(lists->fixed[149], lanes_mul(K(0.08333333333333333), p_ring_radius));
        lanes_store(lists->fixed[150], lanes_mul(K(2.2), p_gravity));
        lanes_store(lists->fixed[151], lanes_mul(K(3.0), p_ring_radius));
        lanes_store(lists->fixed[152], lanes_mul(K(6.0), p_ring_radius));
        lanes_store(lists->fixed[153], lanes_mul(K(0.8), p_gravity));
        lanes_store(lists->fixed[154], lanes_mul(p_ring_friction, p_ring_friction));
        lanes_store(lists->fixed[155], lanes_sqrt(lanes_add(lanes_mul(_s59, _s59), lanes_mul(_s62, _s62))));
        lanes_store(lists->fixed[156], lanes_sqrt(lanes_add(lanes_mul(_s65, _s65), lanes_mul(_s68, _s68))));
        lanes_store(lists->fixed[157], lanes_mul(K(0.000244140625), _s12));
        lanes_store(lists->fixed[158], lanes_mul(K(0.00390625), p_gravity));
        lanes_store(lists->fixed[159], lanes_mul(lanes_mul(K(0.000244140625), _s69), _s12));
        lanes_store(lists->fixed[160], lanes_mul(K(3.0), p_gravity));
        lanes_store(lists->fixed[161], lanes_mul(K(2.0), lanes_mul(K(3.0), _s69)));
        lanes_store(lists->fixed[162], lanes_mul(K(0.0078125), p_gravity));
        lanes_store(lists->fixed[163], lanes_max(K(0.0), p_gravity));
        lanes_store(lists->fixed[164], lanes_mul(K(8.0), _s14));
        lanes_store(lists->fixed[165], lanes_add(lanes_add(lanes_add(lanes_add(_s70, p_ring_radius), p_wire_radius), _s0), _s1));
        lanes_store(lists->fixed[166], lanes_div(K(1.0), lanes_min(_s71, _s12)));
        lanes_store(lists->fixed[167], p_restitution_speed);
        lanes_store(lists->fixed[168], _s72);
        lanes_store(lists->fixed[169], lanes_mul(_s72, _s72));
        lanes_store(lists->fixed[170], lanes_mul(K(7.275957614183426e-12), p_ball_radius));
        lanes_store(lists->fixed[171], lanes_mul(K(1.1920928955078125e-07), p_ball_radius));
        lanes_store(lists->fixed[172], lanes_mul(K(0.4), p_ball_radius));
        lanes_store(lists->fixed[173], _s73);
        lanes_store(lists->fixed[174], lanes_mul(_s73, _s73));
        lanes_store(lists->fixed[175], lanes_mul(p_ring_friction, _s74));
        lanes_store(lists->fixed[176], lanes_mul(_s74, _s73));
        lanes_store(lists->fixed[177], lanes_mul(K(3.725290298461914e-09), p_ball_radius));
        lanes_store(lists->fixed[178], _s75);
        lanes_store(lists->fixed[179], lanes_mul(_s75, _s75));
        lanes_store(lists->fixed[180], lanes_mul(p_backboard_friction, _s76));
        lanes_store(lists->fixed[181], lanes_mul(_s76, _s75));
        lanes_store(lists->fixed[182], _s77);
        lanes_store(lists->fixed[183], lanes_mul(_s77, _s77));
        lanes_store(lists->fixed[184], lanes_mul(p_bridge_friction, _s78));
        lanes_store(lists->fixed[185], lanes_mul(_s78, _s77));
    }
    {
        const S _p_ball_radius = lanes_narrow(p_ball_radius);
        const S _p_ring_radius = lanes_narrow(p_ring_radius);
        const S _p_wire_radius = lanes_narrow(p_wire_radius);
        const S _p_gravity = lanes_narrow(p_gravity);
        const S _s0 = singles_add(_p_ball_radius, _p_wire_radius);
        const S _s1 = singles_mul(KS(1.00006103515625), _s0);
        const S _s2 = singles_add(_p_ring_radius, _s1);
        const S _s3 = singles_sub(_p_ring_radius, _s1);
        const S _s4 = singles_mul(KS(0.0001220703125), _p_ring_radius);
        const S _s5 = singles_max(_s3, _s4);
        const S _s6 = singles_div(_s0, _s5);
        const S _s7 = singles_max(KS(1.0), _s6);
        const S _s8 = singles_div(KS(1.0), _s5);
        singles_store(lists->fixed_single[0], _p_gravity);
        singles_store(lists->fixed_single[1], _s1);
        singles_store(lists->fixed_single[2], singles_mul(KS(2.0), _p_gravity));
        singles_store(lists->fixed_single[3], singles_div(KS(1.0), _p_gravity));
        singles_store(lists->fixed_single[4], _s2);
        singles_store(lists->fixed_single[5], singles_mul(_s2, _s2));
        singles_store(lists->fixed_single[6], _s5);
        singles_store(lists->fixed_single[7], singles_mul(_s5, _s5));
        singles_store(lists->fixed_single[8], singles_mul(KS(32.0), _s5));
        singles_store(lists->fixed_single[9], singles_add(singles_mul(KS(32.0), _p_ball_radius), singles_mul(KS(32.0), _p_wire_radius)));
        singles_store(lists->fixed_single[10], _s0);
        singles_store(lists->fixed_single[11], _s7);
        singles_store(lists->fixed_single[12], singles_mul(KS(4.0), _p_gravity));
        singles_store(lists->fixed_single[13], singles_mul(KS(2.0), _p_ring_radius));
        singles_store(lists->fixed_single[14], singles_mul(singles_mul(KS(6.0003662109375), _p_gravity), _s0));
        singles_store(lists->fixed_single[15], singles_mul(_s8, singles_mul(_s8, _s8)));
        singles_store(lists->fixed_single[16], singles_mul(KS(5.0048828125), _s0));
        singles_store(lists->fixed_single[17], singles_mul(KS(7.62939453125e-06), singles_mul(singles_div(_s2, _s5), _s7)));
        singles_store(lists->fixed_single[18], singles_add(singles_mul(KS(128.0), _p_ball_radius), singles_mul(KS(128.0), _p_wire_radius)));
        singles_store(lists->fixed_single[19], _p_ring_radius);
        singles_store(lists->fixed_single[20], singles_mul(KS(0.5), _p_gravity));
        singles_store(lists->fixed_single[21], singles_mul(_s0, _s0));
        singles_store(lists->fixed_single[22], singles_mul(KS(6.0), _p_gravity));
        singles_store(lists->fixed_single[23], singles_add(singles_mul(KS(0.0001220703125), _p_ball_radius), singles_mul(KS(0.0001220703125), _p_wire_radius)));
        singles_store(lists->fixed_single[24], singles_mul(KS(9.5367431640625e-07), _s2));
        singles_store(lists->fixed_single[25], singles_add(singles_mul(KS(0.000244140625), _p_ball_radius), singles_mul(KS(0.000244140625), _p_wire_radius)));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f1)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->p_board_thickness + i);
    const V p_board_top = lanes_load(lists->p_board_top + i);
    const V p_bridge_depth = lanes_load(lists->p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + i);
    const V p_end_depth = lanes_load(lists->p_end_depth + i);
    const V p_ring_radius = lanes_load(lists->p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->p_wire_radius + i);
    {
        const V _s0 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_abs(p_ball_radius), lanes_abs(p_board_bottom)), lanes_abs(p_board_distance)), lanes_abs(p_board_half_width)), lanes_abs(p_board_thickness)), lanes_abs(p_board_top));
        const V _s1 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s0, lanes_abs(p_bridge_depth)), lanes_abs(p_bridge_half_width)), lanes_abs(p_end_depth)), lanes_abs(p_ring_radius)), lanes_abs(p_wire_radius));
        const V _s2 = lanes_mul(K(0.5), p_board_thickness);
        const V _s3 = lanes_mul(K(0.5), p_board_distance);
        const V _s4 = lanes_mul(K(0.5), p_ring_radius);
        const V _s5 = lanes_add(p_ball_radius, p_wire_radius);
        lanes_store(lists->fixed[0], _s1);
        lanes_store(lists->fixed[1], lanes_add(lanes_add(p_ball_radius, p_ring_radius), p_wire_radius));
        lanes_store(lists->fixed[2], lanes_neg(lanes_add(p_board_distance, _s2)));
        lanes_store(lists->fixed[3], lanes_add(p_ball_radius, _s2));
        lanes_store(lists->fixed[4], lanes_neg(lanes_add(_s3, _s4)));
        lanes_store(lists->fixed[5], lanes_sub(lanes_add(p_ball_radius, _s3), _s4));
        lanes_store(lists->fixed[6], p_ball_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[14], lanes_mul(_s5, _s5));
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[17], lanes_add(lanes_mul(K(4.0), p_ball_radius), lanes_mul(K(4.0), p_wire_radius)));
        lanes_store(lists->fixed[18], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[19], lanes_mul(p_ring_radius, p_ring_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f8)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->p_ball_radius + i);
    const V p_end_depth = lanes_load(lists->p_end_depth + i);
    const V p_gravity = lanes_load(lists->p_gravity + i);
    const V p_ring_radius = lanes_load(lists->p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_div(K(1.0), p_gravity);
        const V _s2 = lanes_neg(_s1);
        const V _s3 = lanes_mul(K(1.00006103515625), _s0);
        const V _s4 = lanes_add(p_ring_radius, _s3);
        const V _s5 = lanes_mul(_s4, _s4);
        const V _s6 = lanes_mul(K(9.313225746154785e-10), _s5);
        const V _s7 = lanes_sub(p_ring_radius, _s3);
        const V _s8 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s9 = lanes_max(_s7, _s8);
        const V _s10 = lanes_mul(_s9, _s9);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[14], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[18], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[20], _s1);
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[22], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[23], lanes_neg(p_gravity));
        lanes_store(lists->fixed[24], _s2);
        lanes_store(lists->fixed[25], lanes_mul(K(0.5), _s2));
        lanes_store(lists->fixed[26], lanes_mul(K(6.667843360785852e-16), p_end_depth));
        lanes_store(lists->fixed[27], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s0)));
        lanes_store(lists->fixed[28], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[29], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[30], _s3);
        lanes_store(lists->fixed[31], lanes_mul(K(5.820766091346741e-11), _s4));
        lanes_store(lists->fixed[32], lanes_mul(K(65536.0), _s4));
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[34], _s5);
        lanes_store(lists->fixed[35], _s6);
        lanes_store(lists->fixed[36], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[37], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s0));
        lanes_store(lists->fixed[38], _s10);
        lanes_store(lists->fixed[39], lanes_mul(_s9, _s10));
        lanes_store(lists->fixed[40], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[41], lanes_add(_s6, _s10));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f28)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->open_p_ball_radius + i);
    const V p_gravity = lanes_load(lists->open_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->open_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->open_p_wire_radius + i);
    {
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[20], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[27], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, lanes_add(p_ball_radius, p_wire_radius))));
        lanes_store(lists->fixed[28], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[29], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[42], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[43], lanes_mul(K(2.0), p_ball_radius));
        lanes_store(lists->fixed[44], lanes_mul(K(2.0), p_wire_radius));
    }
    {
        const S _p_ball_radius = lanes_narrow(p_ball_radius);
        const S _p_ring_radius = lanes_narrow(p_ring_radius);
        const S _p_wire_radius = lanes_narrow(p_wire_radius);
        const S _p_gravity = lanes_narrow(p_gravity);
        const S _s0 = singles_add(_p_ball_radius, _p_wire_radius);
        const S _s1 = singles_mul(KS(1.00006103515625), _s0);
        const S _s2 = singles_add(_p_ring_radius, _s1);
        const S _s3 = singles_sub(_p_ring_radius, _s1);
        const S _s4 = singles_mul(KS(0.0001220703125), _p_ring_radius);
        const S _s5 = singles_max(_s3, _s4);
        const S _s6 = singles_div(_s0, _s5);
        const S _s7 = singles_max(KS(1.0), _s6);
        const S _s8 = singles_div(KS(1.0), _s5);
        singles_store(lists->fixed_single[0], _p_gravity);
        singles_store(lists->fixed_single[1], _s1);
        singles_store(lists->fixed_single[2], singles_mul(KS(2.0), _p_gravity));
        singles_store(lists->fixed_single[3], singles_div(KS(1.0), _p_gravity));
        singles_store(lists->fixed_single[4], _s2);
        singles_store(lists->fixed_single[5], singles_mul(_s2, _s2));
        singles_store(lists->fixed_single[6], _s5);
        singles_store(lists->fixed_single[7], singles_mul(_s5, _s5));
        singles_store(lists->fixed_single[8], singles_mul(KS(32.0), _s5));
        singles_store(lists->fixed_single[9], singles_add(singles_mul(KS(32.0), _p_ball_radius), singles_mul(KS(32.0), _p_wire_radius)));
        singles_store(lists->fixed_single[10], _s0);
        singles_store(lists->fixed_single[11], _s7);
        singles_store(lists->fixed_single[12], singles_mul(KS(4.0), _p_gravity));
        singles_store(lists->fixed_single[13], singles_mul(KS(2.0), _p_ring_radius));
        singles_store(lists->fixed_single[14], singles_mul(singles_mul(KS(6.0003662109375), _p_gravity), _s0));
        singles_store(lists->fixed_single[15], singles_mul(_s8, singles_mul(_s8, _s8)));
        singles_store(lists->fixed_single[16], singles_mul(KS(5.0048828125), _s0));
        singles_store(lists->fixed_single[17], singles_mul(KS(7.62939453125e-06), singles_mul(singles_div(_s2, _s5), _s7)));
        singles_store(lists->fixed_single[18], singles_add(singles_mul(KS(128.0), _p_ball_radius), singles_mul(KS(128.0), _p_wire_radius)));
        singles_store(lists->fixed_single[19], _p_ring_radius);
        singles_store(lists->fixed_single[20], singles_mul(KS(0.5), _p_gravity));
        singles_store(lists->fixed_single[21], singles_mul(_s0, _s0));
        singles_store(lists->fixed_single[22], singles_mul(KS(6.0), _p_gravity));
        singles_store(lists->fixed_single[23], singles_add(singles_mul(KS(0.0001220703125), _p_ball_radius), singles_mul(KS(0.0001220703125), _p_wire_radius)));
        singles_store(lists->fixed_single[24], singles_mul(KS(9.5367431640625e-07), _s2));
        singles_store(lists->fixed_single[25], singles_add(singles_mul(KS(0.000244140625), _p_ball_radius), singles_mul(KS(0.000244140625), _p_wire_radius)));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f42)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->open_leaping_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_gravity = lanes_expand(lists->open_leaping_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    const V p_ring_radius = lanes_expand(lists->open_leaping_p_ring_radius + taken, idle, lanes_load(lists->turning_p_ring_radius));
    const V p_wire_radius = lanes_expand(lists->open_leaping_p_wire_radius + taken, idle, lanes_load(lists->turning_p_wire_radius));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_gravity, p_gravity);
    lanes_store(lists->turning_p_ring_radius, p_ring_radius);
    lanes_store(lists->turning_p_wire_radius, p_wire_radius);
    {
        const S _p_ball_radius = lanes_narrow(p_ball_radius);
        const S _p_ring_radius = lanes_narrow(p_ring_radius);
        const S _p_wire_radius = lanes_narrow(p_wire_radius);
        const S _p_gravity = lanes_narrow(p_gravity);
        const S _s0 = singles_add(_p_ball_radius, _p_wire_radius);
        const S _s1 = singles_mul(KS(1.00006103515625), _s0);
        const S _s2 = singles_sub(_p_ring_radius, _s1);
        const S _s3 = singles_mul(KS(0.0001220703125), _p_ring_radius);
        singles_store(lists->fixed_single[0], _p_gravity);
        singles_store(lists->fixed_single[1], _s1);
        singles_store(lists->fixed_single[6], singles_max(_s2, _s3));
        singles_store(lists->fixed_single[19], _p_ring_radius);
        singles_store(lists->fixed_single[20], singles_mul(KS(0.5), _p_gravity));
        singles_store(lists->fixed_single[21], singles_mul(_s0, _s0));
        singles_store(lists->fixed_single[22], singles_mul(KS(6.0), _p_gravity));
        singles_store(lists->fixed_single[23], singles_add(singles_mul(KS(0.0001220703125), _p_ball_radius), singles_mul(KS(0.0001220703125), _p_wire_radius)));
        singles_store(lists->fixed_single[24], singles_mul(KS(9.5367431640625e-07), singles_add(_p_ring_radius, _s1)));
        singles_store(lists->fixed_single[25], singles_add(singles_mul(KS(0.000244140625), _p_ball_radius), singles_mul(KS(0.000244140625), _p_wire_radius)));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f45)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->open_searching_p_ball_radius + i);
    const V p_gravity = lanes_load(lists->open_searching_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->open_searching_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->open_searching_p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_mul(K(1.00006103515625), _s0);
        const V _s2 = lanes_add(p_ring_radius, _s1);
        const V _s3 = lanes_sub(p_ring_radius, _s1);
        const V _s4 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s5 = lanes_max(_s3, _s4);
        const V _s6 = lanes_div(K(1.0), _s5);
        const V _s7 = lanes_div(_s1, _s5);
        lanes_store(lists->fixed[20], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[22], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[27], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s0)));
        lanes_store(lists->fixed[28], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[29], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[30], _s1);
        lanes_store(lists->fixed[34], lanes_mul(_s2, _s2));
        lanes_store(lists->fixed[36], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[37], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s0));
        lanes_store(lists->fixed[38], lanes_mul(_s5, _s5));
        lanes_store(lists->fixed[40], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[42], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[43], lanes_mul(K(2.0), p_ball_radius));
        lanes_store(lists->fixed[44], lanes_mul(K(2.0), p_wire_radius));
        lanes_store(lists->fixed[45], lanes_mul(_s6, lanes_mul(_s6, _s6)));
        lanes_store(lists->fixed[46], _s2);
        lanes_store(lists->fixed[47], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s0), _s2));
        lanes_store(lists->fixed[48], lanes_mul(K(5.00030517578125), _s0));
        lanes_store(lists->fixed[49], lanes_max(K(1.0), _s7));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f50)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->open_searching_searching_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_gravity = lanes_expand(lists->open_searching_searching_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    const V p_ring_radius = lanes_expand(lists->open_searching_searching_p_ring_radius + taken, idle, lanes_load(lists->turning_p_ring_radius));
    const V p_wire_radius = lanes_expand(lists->open_searching_searching_p_wire_radius + taken, idle, lanes_load(lists->turning_p_wire_radius));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_gravity, p_gravity);
    lanes_store(lists->turning_p_ring_radius, p_ring_radius);
    lanes_store(lists->turning_p_wire_radius, p_wire_radius);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_mul(K(1.00006103515625), _s0);
        const V _s2 = lanes_add(p_ring_radius, _s1);
        const V _s3 = lanes_sub(p_ring_radius, _s1);
        const V _s4 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s5 = lanes_max(_s3, _s4);
        const V _s6 = lanes_div(_s1, _s5);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[14], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[30], _s1);
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[46], _s2);
        lanes_store(lists->fixed[47], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s0), _s2));
        lanes_store(lists->fixed[48], lanes_mul(K(5.00030517578125), _s0));
        lanes_store(lists->fixed[49], lanes_max(K(1.0), _s6));
        lanes_store(lists->fixed[50], lanes_mul(K(6.0), p_gravity));
        lanes_store(lists->fixed[51], lanes_mul(K(9.094947017729282e-13), _s2));
        lanes_store(lists->fixed[52], _s5);
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f63)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->open_p_ball_radius + i);
    const V p_gravity = lanes_load(lists->open_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->open_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->open_p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[14], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f72)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->open_refining_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_gravity = lanes_expand(lists->open_refining_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    const V p_ring_radius = lanes_expand(lists->open_refining_p_ring_radius + taken, idle, lanes_load(lists->turning_p_ring_radius));
    const V p_wire_radius = lanes_expand(lists->open_refining_p_wire_radius + taken, idle, lanes_load(lists->turning_p_wire_radius));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_gravity, p_gravity);
    lanes_store(lists->turning_p_ring_radius, p_ring_radius);
    lanes_store(lists->turning_p_wire_radius, p_wire_radius);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[14], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f75)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->open_p_ball_radius + i);
    const V p_gravity = lanes_load(lists->open_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->open_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->open_p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_mul(K(1.00006103515625), _s0);
        const V _s2 = lanes_add(p_ring_radius, _s1);
        const V _s3 = lanes_sub(p_ring_radius, _s1);
        const V _s4 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s5 = lanes_div(_s1, lanes_max(_s3, _s4));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[30], _s1);
        lanes_store(lists->fixed[46], _s2);
        lanes_store(lists->fixed[47], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s0), _s2));
        lanes_store(lists->fixed[48], lanes_mul(K(5.00030517578125), _s0));
        lanes_store(lists->fixed[49], lanes_max(K(1.0), _s5));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f83)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->p_board_thickness + i);
    const V p_board_top = lanes_load(lists->p_board_top + i);
    const V p_gravity = lanes_load(lists->p_gravity + i);
    {
        const V _s0 = lanes_mul(K(0.5), p_board_thickness);
        const V _s1 = lanes_mul(K(0.5), p_board_bottom);
        const V _s2 = lanes_mul(K(0.5), p_board_top);
        lanes_store(lists->fixed[2], lanes_neg(lanes_add(p_board_distance, _s0)));
        lanes_store(lists->fixed[20], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[53], lanes_abs(K(0.0)));
        lanes_store(lists->fixed[54], lanes_mul(K(0.0625), p_gravity));
        lanes_store(lists->fixed[55], lanes_mul(K(1.0000000009313226), lanes_mul(p_ball_radius, p_ball_radius)));
        lanes_store(lists->fixed[56], lanes_mul(K(1.0000000009313226), _s0));
        lanes_store(lists->fixed[57], lanes_mul(K(1.0000000009313226), p_board_half_width));
        lanes_store(lists->fixed[58], lanes_add(_s1, _s2));
        lanes_store(lists->fixed[59], lanes_mul(K(1.0000000009313226), lanes_sub(_s2, _s1)));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f88)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->reachable_p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->reachable_p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->reachable_p_board_thickness + i);
    const V p_board_top = lanes_load(lists->reachable_p_board_top + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    {
        const V _s0 = lanes_mul(K(0.5), p_board_thickness);
        const V _s1 = lanes_add(p_ball_radius, _s0);
        const V _s2 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s3 = lanes_mul(K(0.5), p_board_bottom);
        const V _s4 = lanes_mul(K(0.5), p_board_top);
        const V _s5 = lanes_add(p_ball_radius, _s4);
        const V _s6 = lanes_sub(_s5, _s3);
        const V _s7 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s8 = lanes_min(_s7, _s1);
        const V _s9 = lanes_min(_s6, _s8);
        const V _s10 = lanes_mul(K(6.103515625e-05), _s9);
        const V _s11 = lanes_abs(lanes_neg(p_gravity));
        const V _s12 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s9));
        const V _s13 = lanes_max(_s1, _s7);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[20], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[22], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[42], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[60], _s4);
        lanes_store(lists->fixed[61], _s3);
        lanes_store(lists->fixed[62], _s9);
        lanes_store(lists->fixed[63], lanes_add(_s1, _s10));
        lanes_store(lists->fixed[64], lanes_add(p_board_distance, _s0));
        lanes_store(lists->fixed[65], lanes_add(_s7, _s10));
        lanes_store(lists->fixed[66], lanes_sub(lanes_add(_s5, _s10), _s3));
        lanes_store(lists->fixed[67], lanes_mul(lanes_mul(K(1.25), _s11), _s12));
        lanes_store(lists->fixed[68], lanes_abs(lanes_add(_s3, _s4)));
        lanes_store(lists->fixed[69], lanes_max(_s13, _s6));
        lanes_store(lists->fixed[70], lanes_mul(K(1.52587890625e-05), _s9));
        lanes_store(lists->fixed[71], lanes_mul(K(5.55653613398821e-16), _s2));
        lanes_store(lists->fixed[72], _s12);
        lanes_store(lists->fixed[73], lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        lanes_store(lists->fixed[74], lanes_mul(K(2.001953125), _s12));
        lanes_store(lists->fixed[75], lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        lanes_store(lists->fixed[76], lanes_add(lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_bottom)), lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_top))));
        lanes_store(lists->fixed[77], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s12, _s12)));
        lanes_store(lists->fixed[78], lanes_mul(K(12.01171875), _s12));
        lanes_store(lists->fixed[79], lanes_mul(K(6.667843360785852e-15), _s12));
        lanes_store(lists->fixed[80], lanes_mul(K(6.005859375), _s12));
        lanes_store(lists->fixed[81], lanes_mul(K(2.667137344314341e-15), _s12));
        lanes_store(lists->fixed[82], _s2);
        lanes_store(lists->fixed[83], _s11);
        lanes_store(lists->fixed[84], lanes_mul(K(0.5), _s11));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f108)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->reachable_searching_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_board_bottom = lanes_expand(lists->reachable_searching_p_board_bottom + taken, idle, lanes_load(lists->turning_p_board_bottom));
    const V p_board_distance = lanes_expand(lists->reachable_searching_p_board_distance + taken, idle, lanes_load(lists->turning_p_board_distance));
    const V p_board_half_width = lanes_expand(lists->reachable_searching_p_board_half_width + taken, idle, lanes_load(lists->turning_p_board_half_width));
    const V p_board_thickness = lanes_expand(lists->reachable_searching_p_board_thickness + taken, idle, lanes_load(lists->turning_p_board_thickness));
    const V p_board_top = lanes_expand(lists->reachable_searching_p_board_top + taken, idle, lanes_load(lists->turning_p_board_top));
    const V p_gravity = lanes_expand(lists->reachable_searching_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_board_bottom, p_board_bottom);
    lanes_store(lists->turning_p_board_distance, p_board_distance);
    lanes_store(lists->turning_p_board_half_width, p_board_half_width);
    lanes_store(lists->turning_p_board_thickness, p_board_thickness);
    lanes_store(lists->turning_p_board_top, p_board_top);
    lanes_store(lists->turning_p_gravity, p_gravity);
    {
        const V _s0 = lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_thickness));
        const V _s1 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s2 = lanes_sub(lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_top)), lanes_mul(K(0.5), p_board_bottom));
        const V _s3 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s4 = lanes_min(_s3, _s0);
        const V _s5 = lanes_abs(lanes_neg(p_gravity));
        const V _s6 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), lanes_min(_s2, _s4)));
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[71], lanes_mul(K(5.55653613398821e-16), _s1));
        lanes_store(lists->fixed[72], _s6);
        lanes_store(lists->fixed[73], lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        lanes_store(lists->fixed[74], lanes_mul(K(2.001953125), _s6));
        lanes_store(lists->fixed[75], lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        lanes_store(lists->fixed[76], lanes_add(lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_bottom)), lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_top))));
        lanes_store(lists->fixed[77], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s6, _s6)));
        lanes_store(lists->fixed[78], lanes_mul(K(12.01171875), _s6));
        lanes_store(lists->fixed[79], lanes_mul(K(6.667843360785852e-15), _s6));
        lanes_store(lists->fixed[80], lanes_mul(K(6.005859375), _s6));
        lanes_store(lists->fixed[81], lanes_mul(K(2.667137344314341e-15), _s6));
        lanes_store(lists->fixed[82], _s1);
        lanes_store(lists->fixed[83], _s5);
        lanes_store(lists->fixed[84], lanes_mul(K(0.5), _s5));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f120)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->reachable_p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->reachable_p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->reachable_p_board_thickness + i);
    const V p_board_top = lanes_load(lists->reachable_p_board_top + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    {
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[82], lanes_mul(p_ball_radius, p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f130)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->reachable_refining_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_board_bottom = lanes_expand(lists->reachable_refining_p_board_bottom + taken, idle, lanes_load(lists->turning_p_board_bottom));
    const V p_board_distance = lanes_expand(lists->reachable_refining_p_board_distance + taken, idle, lanes_load(lists->turning_p_board_distance));
    const V p_board_half_width = lanes_expand(lists->reachable_refining_p_board_half_width + taken, idle, lanes_load(lists->turning_p_board_half_width));
    const V p_board_thickness = lanes_expand(lists->reachable_refining_p_board_thickness + taken, idle, lanes_load(lists->turning_p_board_thickness));
    const V p_board_top = lanes_expand(lists->reachable_refining_p_board_top + taken, idle, lanes_load(lists->turning_p_board_top));
    const V p_gravity = lanes_expand(lists->reachable_refining_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_board_bottom, p_board_bottom);
    lanes_store(lists->turning_p_board_distance, p_board_distance);
    lanes_store(lists->turning_p_board_half_width, p_board_half_width);
    lanes_store(lists->turning_p_board_thickness, p_board_thickness);
    lanes_store(lists->turning_p_board_top, p_board_top);
    lanes_store(lists->turning_p_gravity, p_gravity);
    {
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[82], lanes_mul(p_ball_radius, p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f133)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->reachable_p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->reachable_p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->reachable_p_board_thickness + i);
    const V p_board_top = lanes_load(lists->reachable_p_board_top + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    {
        const V _s0 = lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_thickness));
        const V _s1 = lanes_sub(lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_top)), lanes_mul(K(0.5), p_board_bottom));
        const V _s2 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s3 = lanes_min(_s2, _s0);
        const V _s4 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), lanes_min(_s1, _s3)));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[71], lanes_mul(K(5.55653613398821e-16), lanes_mul(p_ball_radius, p_ball_radius)));
        lanes_store(lists->fixed[72], _s4);
        lanes_store(lists->fixed[73], lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        lanes_store(lists->fixed[74], lanes_mul(K(2.001953125), _s4));
        lanes_store(lists->fixed[75], lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        lanes_store(lists->fixed[76], lanes_add(lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_bottom)), lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_top))));
        lanes_store(lists->fixed[77], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s4, _s4)));
        lanes_store(lists->fixed[78], lanes_mul(K(12.01171875), _s4));
        lanes_store(lists->fixed[79], lanes_mul(K(6.667843360785852e-15), _s4));
        lanes_store(lists->fixed[80], lanes_mul(K(6.005859375), _s4));
        lanes_store(lists->fixed[81], lanes_mul(K(2.667137344314341e-15), _s4));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f141)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->p_ball_radius + i);
    const V p_board_distance = lanes_load(lists->p_board_distance + i);
    const V p_bridge_depth = lanes_load(lists->p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + i);
    const V p_gravity = lanes_load(lists->p_gravity + i);
    const V p_ring_radius = lanes_load(lists->p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->p_wire_radius + i);
    {
        const V _s0 = lanes_mul(K(0.5), p_board_distance);
        const V _s1 = lanes_mul(K(0.5), p_ring_radius);
        const V _s2 = lanes_mul(K(0.5), p_bridge_depth);
        lanes_store(lists->fixed[4], lanes_neg(lanes_add(_s0, _s1)));
        lanes_store(lists->fixed[20], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[53], lanes_abs(K(0.0)));
        lanes_store(lists->fixed[54], lanes_mul(K(0.0625), p_gravity));
        lanes_store(lists->fixed[55], lanes_mul(K(1.0000000009313226), lanes_mul(p_ball_radius, p_ball_radius)));
        lanes_store(lists->fixed[85], lanes_mul(K(1.0000000009313226), lanes_sub(_s0, _s1)));
        lanes_store(lists->fixed[86], lanes_mul(K(1.0000000009313226), p_bridge_half_width));
        lanes_store(lists->fixed[87], lanes_sub(p_wire_radius, _s2));
        lanes_store(lists->fixed[88], lanes_mul(K(1.0000000009313226), _s2));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f146)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_bridge_depth = lanes_load(lists->reachable_p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->reachable_p_bridge_half_width + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->reachable_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->reachable_p_wire_radius + i);
    {
        const V _s0 = lanes_mul(K(0.5), p_board_distance);
        const V _s1 = lanes_mul(K(0.5), p_ring_radius);
        const V _s2 = lanes_add(p_ball_radius, _s0);
        const V _s3 = lanes_sub(_s2, _s1);
        const V _s4 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s5 = lanes_abs(lanes_neg(p_gravity));
        const V _s6 = lanes_mul(K(0.5), p_bridge_depth);
        const V _s7 = lanes_add(p_ball_radius, _s6);
        const V _s8 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s9 = lanes_min(_s8, _s3);
        const V _s10 = lanes_min(_s7, _s9);
        const V _s11 = lanes_mul(K(6.103515625e-05), _s10);
        const V _s12 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s10));
        const V _s13 = lanes_max(_s3, _s8);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[20], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[22], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[42], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[71], lanes_mul(K(5.55653613398821e-16), _s4));
        lanes_store(lists->fixed[82], _s4);
        lanes_store(lists->fixed[83], _s5);
        lanes_store(lists->fixed[84], lanes_mul(K(0.5), _s5));
        lanes_store(lists->fixed[89], _s0);
        lanes_store(lists->fixed[90], _s6);
        lanes_store(lists->fixed[91], _s1);
        lanes_store(lists->fixed[92], _s10);
        lanes_store(lists->fixed[93], lanes_sub(lanes_add(_s2, _s11), _s1));
        lanes_store(lists->fixed[94], lanes_add(_s0, _s1));
        lanes_store(lists->fixed[95], lanes_add(_s8, _s11));
        lanes_store(lists->fixed[96], lanes_add(_s7, _s11));
        lanes_store(lists->fixed[97], lanes_mul(lanes_mul(K(1.25), _s5), _s12));
        lanes_store(lists->fixed[98], lanes_abs(lanes_sub(_s6, p_wire_radius)));
        lanes_store(lists->fixed[99], lanes_max(_s13, _s7));
        lanes_store(lists->fixed[100], lanes_mul(K(1.52587890625e-05), _s10));
        lanes_store(lists->fixed[101], _s12);
        lanes_store(lists->fixed[102], lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        lanes_store(lists->fixed[103], lanes_mul(K(2.001953125), _s12));
        lanes_store(lists->fixed[104], lanes_add(lanes_mul(K(1.1102230246251565e-16), p_board_distance), lanes_mul(K(1.1102230246251565e-16), p_ring_radius)));
        lanes_store(lists->fixed[105], lanes_add(lanes_mul(K(2.220446049250313e-16), p_bridge_depth), lanes_mul(K(5.551115123125783e-16), p_wire_radius)));
        lanes_store(lists->fixed[106], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s12, _s12)));
        lanes_store(lists->fixed[107], lanes_mul(K(12.01171875), _s12));
        lanes_store(lists->fixed[108], lanes_mul(K(6.667843360785852e-15), _s12));
        lanes_store(lists->fixed[109], lanes_mul(K(6.005859375), _s12));
        lanes_store(lists->fixed[110], lanes_mul(K(2.667137344314341e-15), _s12));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f166)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->reachable_searching_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_board_distance = lanes_expand(lists->reachable_searching_p_board_distance + taken, idle, lanes_load(lists->turning_p_board_distance));
    const V p_bridge_depth = lanes_expand(lists->reachable_searching_p_bridge_depth + taken, idle, lanes_load(lists->turning_p_bridge_depth));
    const V p_bridge_half_width = lanes_expand(lists->reachable_searching_p_bridge_half_width + taken, idle, lanes_load(lists->turning_p_bridge_half_width));
    const V p_gravity = lanes_expand(lists->reachable_searching_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    const V p_ring_radius = lanes_expand(lists->reachable_searching_p_ring_radius + taken, idle, lanes_load(lists->turning_p_ring_radius));
    const V p_wire_radius = lanes_expand(lists->reachable_searching_p_wire_radius + taken, idle, lanes_load(lists->turning_p_wire_radius));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_board_distance, p_board_distance);
    lanes_store(lists->turning_p_bridge_depth, p_bridge_depth);
    lanes_store(lists->turning_p_bridge_half_width, p_bridge_half_width);
    lanes_store(lists->turning_p_gravity, p_gravity);
    lanes_store(lists->turning_p_ring_radius, p_ring_radius);
    lanes_store(lists->turning_p_wire_radius, p_wire_radius);
    {
        const V _s0 = lanes_sub(lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_distance)), lanes_mul(K(0.5), p_ring_radius));
        const V _s1 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s2 = lanes_abs(lanes_neg(p_gravity));
        const V _s3 = lanes_add(p_ball_radius, lanes_mul(K(0.5), p_bridge_depth));
        const V _s4 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s5 = lanes_min(_s4, _s0);
        const V _s6 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), lanes_min(_s3, _s5)));
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[71], lanes_mul(K(5.55653613398821e-16), _s1));
        lanes_store(lists->fixed[82], _s1);
        lanes_store(lists->fixed[83], _s2);
        lanes_store(lists->fixed[84], lanes_mul(K(0.5), _s2));
        lanes_store(lists->fixed[101], _s6);
        lanes_store(lists->fixed[102], lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        lanes_store(lists->fixed[103], lanes_mul(K(2.001953125), _s6));
        lanes_store(lists->fixed[104], lanes_add(lanes_mul(K(1.1102230246251565e-16), p_board_distance), lanes_mul(K(1.1102230246251565e-16), p_ring_radius)));
        lanes_store(lists->fixed[105], lanes_add(lanes_mul(K(2.220446049250313e-16), p_bridge_depth), lanes_mul(K(5.551115123125783e-16), p_wire_radius)));
        lanes_store(lists->fixed[106], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s6, _s6)));
        lanes_store(lists->fixed[107], lanes_mul(K(12.01171875), _s6));
        lanes_store(lists->fixed[108], lanes_mul(K(6.667843360785852e-15), _s6));
        lanes_store(lists->fixed[109], lanes_mul(K(6.005859375), _s6));
        lanes_store(lists->fixed[110], lanes_mul(K(2.667137344314341e-15), _s6));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f178)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_bridge_depth = lanes_load(lists->reachable_p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->reachable_p_bridge_half_width + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->reachable_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->reachable_p_wire_radius + i);
    {
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[82], lanes_mul(p_ball_radius, p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f188)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->reachable_refining_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_board_distance = lanes_expand(lists->reachable_refining_p_board_distance + taken, idle, lanes_load(lists->turning_p_board_distance));
    const V p_bridge_depth = lanes_expand(lists->reachable_refining_p_bridge_depth + taken, idle, lanes_load(lists->turning_p_bridge_depth));
    const V p_bridge_half_width = lanes_expand(lists->reachable_refining_p_bridge_half_width + taken, idle, lanes_load(lists->turning_p_bridge_half_width));
    const V p_gravity = lanes_expand(lists->reachable_refining_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    const V p_ring_radius = lanes_expand(lists->reachable_refining_p_ring_radius + taken, idle, lanes_load(lists->turning_p_ring_radius));
    const V p_wire_radius = lanes_expand(lists->reachable_refining_p_wire_radius + taken, idle, lanes_load(lists->turning_p_wire_radius));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_board_distance, p_board_distance);
    lanes_store(lists->turning_p_bridge_depth, p_bridge_depth);
    lanes_store(lists->turning_p_bridge_half_width, p_bridge_half_width);
    lanes_store(lists->turning_p_gravity, p_gravity);
    lanes_store(lists->turning_p_ring_radius, p_ring_radius);
    lanes_store(lists->turning_p_wire_radius, p_wire_radius);
    {
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[82], lanes_mul(p_ball_radius, p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f191)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_bridge_depth = lanes_load(lists->reachable_p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->reachable_p_bridge_half_width + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->reachable_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->reachable_p_wire_radius + i);
    {
        const V _s0 = lanes_sub(lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_distance)), lanes_mul(K(0.5), p_ring_radius));
        const V _s1 = lanes_add(p_ball_radius, lanes_mul(K(0.5), p_bridge_depth));
        const V _s2 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s3 = lanes_min(_s2, _s0);
        const V _s4 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), lanes_min(_s1, _s3)));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[71], lanes_mul(K(5.55653613398821e-16), lanes_mul(p_ball_radius, p_ball_radius)));
        lanes_store(lists->fixed[101], _s4);
        lanes_store(lists->fixed[102], lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        lanes_store(lists->fixed[103], lanes_mul(K(2.001953125), _s4));
        lanes_store(lists->fixed[104], lanes_add(lanes_mul(K(1.1102230246251565e-16), p_board_distance), lanes_mul(K(1.1102230246251565e-16), p_ring_radius)));
        lanes_store(lists->fixed[105], lanes_add(lanes_mul(K(2.220446049250313e-16), p_bridge_depth), lanes_mul(K(5.551115123125783e-16), p_wire_radius)));
        lanes_store(lists->fixed[106], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s4, _s4)));
        lanes_store(lists->fixed[107], lanes_mul(K(12.01171875), _s4));
        lanes_store(lists->fixed[108], lanes_mul(K(6.667843360785852e-15), _s4));
        lanes_store(lists->fixed[109], lanes_mul(K(6.005859375), _s4));
        lanes_store(lists->fixed[110], lanes_mul(K(2.667137344314341e-15), _s4));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f203)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->kept_p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->kept_p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->kept_p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->kept_p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->kept_p_board_thickness + i);
    const V p_board_top = lanes_load(lists->kept_p_board_top + i);
    const V p_bridge_depth = lanes_load(lists->kept_p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->kept_p_bridge_half_width + i);
    const V p_ring_radius = lanes_load(lists->kept_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->kept_p_wire_radius + i);
    {
        const V _s0 = lanes_mul(K(3.637978807091713e-12), p_ball_radius);
        lanes_store(lists->fixed[6], p_ball_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[111], lanes_div(K(1.0), lanes_add(p_ball_radius, p_wire_radius)));
        lanes_store(lists->fixed[112], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[113], _s0);
        lanes_store(lists->fixed[114], lanes_neg(_s0));
        lanes_store(lists->fixed[115], lanes_mul(K(1.4551915228366852e-11), p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f231)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
{
    const V p_backboard_friction = lanes_expand(lists->kept_rolling_p_backboard_friction + taken, idle, lanes_load(lists->turning_p_backboard_friction));
    const V p_ball_radius = lanes_expand(lists->kept_rolling_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_board_bottom = lanes_expand(lists->kept_rolling_p_board_bottom + taken, idle, lanes_load(lists->turning_p_board_bottom));
    const V p_board_distance = lanes_expand(lists->kept_rolling_p_board_distance + taken, idle, lanes_load(lists->turning_p_board_distance));
    const V p_board_half_width = lanes_expand(lists->kept_rolling_p_board_half_width + taken, idle, lanes_load(lists->turning_p_board_half_width));
    const V p_board_thickness = lanes_expand(lists->kept_rolling_p_board_thickness + taken, idle, lanes_load(lists->turning_p_board_thickness));
    const V p_board_top = lanes_expand(lists->kept_rolling_p_board_top + taken, idle, lanes_load(lists->turning_p_board_top));
    const V p_bridge_depth = lanes_expand(lists->kept_rolling_p_bridge_depth + taken, idle, lanes_load(lists->turning_p_bridge_depth));
    const V p_bridge_friction = lanes_expand(lists->kept_rolling_p_bridge_friction + taken, idle, lanes_load(lists->turning_p_bridge_friction));
    const V p_bridge_half_width = lanes_expand(lists->kept_rolling_p_bridge_half_width + taken, idle, lanes_load(lists->turning_p_bridge_half_width));
    const V p_end_depth = lanes_expand(lists->kept_rolling_p_end_depth + taken, idle, lanes_load(lists->turning_p_end_depth));
    const V p_gravity = lanes_expand(lists->kept_rolling_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    const V p_ring_radius = lanes_expand(lists->kept_rolling_p_ring_radius + taken, idle, lanes_load(lists->turning_p_ring_radius));
    const V p_wire_radius = lanes_expand(lists->kept_rolling_p_wire_radius + taken, idle, lanes_load(lists->turning_p_wire_radius));
    lanes_store(lists->turning_p_backboard_friction, p_backboard_friction);
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_board_bottom, p_board_bottom);
    lanes_store(lists->turning_p_board_distance, p_board_distance);
    lanes_store(lists->turning_p_board_half_width, p_board_half_width);
    lanes_store(lists->turning_p_board_thickness, p_board_thickness);
    lanes_store(lists->turning_p_board_top, p_board_top);
    lanes_store(lists->turning_p_bridge_depth, p_bridge_depth);
    lanes_store(lists->turning_p_bridge_friction, p_bridge_friction);
    lanes_store(lists->turning_p_bridge_half_width, p_bridge_half_width);
    lanes_store(lists->turning_p_end_depth, p_end_depth);
    lanes_store(lists->turning_p_gravity, p_gravity);
    lanes_store(lists->turning_p_ring_radius, p_ring_radius);
    lanes_store(lists->turning_p_wire_radius, p_wire_radius);
    {
        const V _s0 = lanes_mul(K(1.4210854715202004e-14), p_ball_radius);
        const V _s1 = lanes_add(lanes_add(_s0, lanes_mul(K(2.842170943040401e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_board_thickness));
        const V _s2 = lanes_add(_s0, lanes_mul(K(2.842170943040401e-14), p_board_half_width));
        const V _s3 = lanes_add(lanes_add(_s0, lanes_mul(K(1.4210854715202004e-14), lanes_abs(p_board_bottom))), lanes_mul(K(1.4210854715202004e-14), lanes_abs(p_board_top)));
        const V _s4 = lanes_add(lanes_add(_s0, lanes_mul(K(1.4210854715202004e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_ring_radius));
        const V _s5 = lanes_add(_s0, lanes_mul(K(2.842170943040401e-14), p_bridge_half_width));
        const V _s6 = lanes_add(lanes_add(_s0, lanes_mul(K(1.4210854715202004e-14), p_wire_radius)), lanes_mul(K(1.4210854715202004e-14), lanes_abs(lanes_sub(p_bridge_depth, p_wire_radius))));
        lanes_store(lists->fixed[6], p_ball_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[18], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[19], lanes_mul(p_ring_radius, p_ring_radius));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[40], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[112], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[113], lanes_mul(K(3.637978807091713e-12), p_ball_radius));
        lanes_store(lists->fixed[116], _s1);
        lanes_store(lists->fixed[117], lanes_neg(_s1));
        lanes_store(lists->fixed[118], _s2);
        lanes_store(lists->fixed[119], lanes_neg(_s2));
        lanes_store(lists->fixed[120], _s3);
        lanes_store(lists->fixed[121], lanes_neg(_s3));
        lanes_store(lists->fixed[122], _s4);
        lanes_store(lists->fixed[123], lanes_neg(_s4));
        lanes_store(lists->fixed[124], _s5);
        lanes_store(lists->fixed[125], lanes_neg(_s5));
        lanes_store(lists->fixed[126], _s6);
        lanes_store(lists->fixed[127], lanes_neg(_s6));
        lanes_store(lists->fixed[128], lanes_mul(K(0.6), p_gravity));
        lanes_store(lists->fixed[129], lanes_mul(K(0.015625), p_gravity));
        lanes_store(lists->fixed[130], lanes_mul(K(0.4), p_gravity));
        lanes_store(lists->fixed[131], lanes_mul(p_backboard_friction, p_backboard_friction));
        lanes_store(lists->fixed[132], lanes_mul(p_bridge_friction, p_bridge_friction));
        lanes_store(lists->fixed[133], lanes_mul(K(5.684341886080802e-14), lanes_sqrt(lanes_mul(p_ball_radius, p_gravity))));
        lanes_store(lists->fixed[134], lanes_mul(K(5.684341886080802e-14), p_gravity));
        lanes_store(lists->fixed[135], lanes_add(p_ball_radius, p_wire_radius));
        lanes_store(lists->fixed[136], p_bridge_depth);
        lanes_store(lists->fixed[137], lanes_mul(K(1.1102230246251565e-16), p_ball_radius));
        lanes_store(lists->fixed[138], lanes_mul(K(2.384185791015625e-07), p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f357)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
{
    const V p_ball_radius = lanes_expand(lists->kept_circling_p_ball_radius + taken, idle, lanes_load(lists->turning_p_ball_radius));
    const V p_board_bottom = lanes_expand(lists->kept_circling_p_board_bottom + taken, idle, lanes_load(lists->turning_p_board_bottom));
    const V p_board_distance = lanes_expand(lists->kept_circling_p_board_distance + taken, idle, lanes_load(lists->turning_p_board_distance));
    const V p_board_half_width = lanes_expand(lists->kept_circling_p_board_half_width + taken, idle, lanes_load(lists->turning_p_board_half_width));
    const V p_board_thickness = lanes_expand(lists->kept_circling_p_board_thickness + taken, idle, lanes_load(lists->turning_p_board_thickness));
    const V p_board_top = lanes_expand(lists->kept_circling_p_board_top + taken, idle, lanes_load(lists->turning_p_board_top));
    const V p_bridge_depth = lanes_expand(lists->kept_circling_p_bridge_depth + taken, idle, lanes_load(lists->turning_p_bridge_depth));
    const V p_bridge_half_width = lanes_expand(lists->kept_circling_p_bridge_half_width + taken, idle, lanes_load(lists->turning_p_bridge_half_width));
    const V p_end_depth = lanes_expand(lists->kept_circling_p_end_depth + taken, idle, lanes_load(lists->turning_p_end_depth));
    const V p_gravity = lanes_expand(lists->kept_circling_p_gravity + taken, idle, lanes_load(lists->turning_p_gravity));
    const V p_ring_friction = lanes_expand(lists->kept_circling_p_ring_friction + taken, idle, lanes_load(lists->turning_p_ring_friction));
    const V p_ring_radius = lanes_expand(lists->kept_circling_p_ring_radius + taken, idle, lanes_load(lists->turning_p_ring_radius));
    const V p_wire_radius = lanes_expand(lists->kept_circling_p_wire_radius + taken, idle, lanes_load(lists->turning_p_wire_radius));
    lanes_store(lists->turning_p_ball_radius, p_ball_radius);
    lanes_store(lists->turning_p_board_bottom, p_board_bottom);
    lanes_store(lists->turning_p_board_distance, p_board_distance);
    lanes_store(lists->turning_p_board_half_width, p_board_half_width);
    lanes_store(lists->turning_p_board_thickness, p_board_thickness);
    lanes_store(lists->turning_p_board_top, p_board_top);
    lanes_store(lists->turning_p_bridge_depth, p_bridge_depth);
    lanes_store(lists->turning_p_bridge_half_width, p_bridge_half_width);
    lanes_store(lists->turning_p_end_depth, p_end_depth);
    lanes_store(lists->turning_p_gravity, p_gravity);
    lanes_store(lists->turning_p_ring_friction, p_ring_friction);
    lanes_store(lists->turning_p_ring_radius, p_ring_radius);
    lanes_store(lists->turning_p_wire_radius, p_wire_radius);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_add(p_board_distance, p_board_thickness);
        const V _s2 = lanes_neg(p_board_half_width);
        const V _s3 = lanes_max(K(0.0), _s2);
        const V _s4 = lanes_max(_s3, _s2);
        const V _s5 = lanes_neg(_s1);
        const V _s6 = lanes_max(K(0.0), _s5);
        const V _s7 = lanes_max(_s6, p_board_distance);
        const V _s8 = lanes_neg(p_board_distance);
        const V _s9 = lanes_max(K(0.0), _s8);
        const V _s10 = lanes_max(_s9, p_ring_radius);
        const V _s11 = lanes_neg(p_bridge_half_width);
        const V _s12 = lanes_max(K(0.0), _s11);
        const V _s13 = lanes_max(_s12, _s11);
        lanes_store(lists->fixed[6], p_ball_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[15], _s1);
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[18], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[19], lanes_mul(p_ring_radius, p_ring_radius));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[91], lanes_mul(K(0.5), p_ring_radius));
        lanes_store(lists->fixed[111], lanes_div(K(1.0), _s0));
        lanes_store(lists->fixed[112], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[113], lanes_mul(K(3.637978807091713e-12), p_ball_radius));
        lanes_store(lists->fixed[129], lanes_mul(K(0.015625), p_gravity));
        lanes_store(lists->fixed[133], lanes_mul(K(5.684341886080802e-14), lanes_sqrt(lanes_mul(p_ball_radius, p_gravity))));
        lanes_store(lists->fixed[134], lanes_mul(K(5.684341886080802e-14), p_gravity));
        lanes_store(lists->fixed[135], _s0);
        lanes_store(lists->fixed[137], lanes_mul(K(1.1102230246251565e-16), p_ball_radius));
        lanes_store(lists->fixed[138], lanes_mul(K(2.384185791015625e-07), p_ball_radius));
        lanes_store(lists->fixed[139], lanes_mul(K(0.6), p_ring_radius));
        lanes_store(lists->fixed[140], lanes_mul(K(0.3333333333333333), p_ring_radius));
        lanes_store(lists->fixed[141], lanes_mul(K(0.25), p_ring_radius));
        lanes_store(lists->fixed[142], lanes_mul(K(0.2), p_ring_radius));
        lanes_store(lists->fixed[143], lanes_mul(K(0.16666666666666666), p_ring_radius));
        lanes_store(lists->fixed[144], lanes_mul(K(0.14285714285714285), p_ring_radius));
        lanes_store(lists->fixed[145], lanes_mul(K(0.125), p_ring_radius));
        lanes_store(lists->fixed[146], lanes_mul(K(0.1111111111111111), p_ring_radius));
        lanes_store(lists->fixed[147], lanes_mul(K(0.1), p_ring_radius));
        lanes_store(lists->fixed[148], lanes_mul(K(0.09090909090909091), p_ring_radius));
        lanes_store(lists->fixed[149], lanes_mul(K(0.08333333333333333), p_ring_radius));
        lanes_store(lists->fixed[150], lanes_mul(K(2.2), p_gravity));
        lanes_store(lists->fixed[151], lanes_mul(K(3.0), p_ring_radius));
        lanes_store(lists->fixed[152], lanes_mul(K(6.0), p_ring_radius));
        lanes_store(lists->fixed[153], lanes_mul(K(0.8), p_gravity));
        lanes_store(lists->fixed[154], lanes_mul(p_ring_friction, p_ring_friction));
        lanes_store(lists->fixed[155], lanes_sqrt(lanes_add(lanes_mul(_s4, _s4), lanes_mul(_s7, _s7))));
        lanes_store(lists->fixed[156], lanes_sqrt(lanes_add(lanes_mul(_s10, _s10), lanes_mul(_s13, _s13))));
        lanes_store(lists->fixed[157], lanes_mul(K(0.000244140625), _s0));
        lanes_store(lists->fixed[158], lanes_mul(K(0.00390625), p_gravity));
        lanes_store(lists->fixed[159], lanes_mul(lanes_mul(K(0.000244140625), lanes_mul(p_gravity, p_gravity)), _s0));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f426)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->kept_leaves_p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->kept_leaves_p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->kept_leaves_p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->kept_leaves_p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->kept_leaves_p_board_thickness + i);
    const V p_board_top = lanes_load(lists->kept_leaves_p_board_top + i);
    const V p_bridge_depth = lanes_load(lists->kept_leaves_p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->kept_leaves_p_bridge_half_width + i);
    const V p_end_depth = lanes_load(lists->kept_leaves_p_end_depth + i);
    const V p_gravity = lanes_load(lists->kept_leaves_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->kept_leaves_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->kept_leaves_p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_mul(K(1.4210854715202004e-14), p_ball_radius);
        const V _s2 = lanes_add(lanes_add(_s1, lanes_mul(K(2.842170943040401e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_board_thickness));
        const V _s3 = lanes_add(_s1, lanes_mul(K(2.842170943040401e-14), p_board_half_width));
        const V _s4 = lanes_add(lanes_add(_s1, lanes_mul(K(1.4210854715202004e-14), lanes_abs(p_board_bottom))), lanes_mul(K(1.4210854715202004e-14), lanes_abs(p_board_top)));
        const V _s5 = lanes_add(lanes_add(_s1, lanes_mul(K(1.4210854715202004e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_ring_radius));
        const V _s6 = lanes_add(_s1, lanes_mul(K(2.842170943040401e-14), p_bridge_half_width));
        const V _s7 = lanes_add(lanes_add(_s1, lanes_mul(K(1.4210854715202004e-14), p_wire_radius)), lanes_mul(K(1.4210854715202004e-14), lanes_abs(lanes_sub(p_bridge_depth, p_wire_radius))));
        lanes_store(lists->fixed[6], p_ball_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[18], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[22], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[23], lanes_neg(p_gravity));
        lanes_store(lists->fixed[40], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[111], lanes_div(K(1.0), _s0));
        lanes_store(lists->fixed[112], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[116], _s2);
        lanes_store(lists->fixed[117], lanes_neg(_s2));
        lanes_store(lists->fixed[118], _s3);
        lanes_store(lists->fixed[119], lanes_neg(_s3));
        lanes_store(lists->fixed[120], _s4);
        lanes_store(lists->fixed[121], lanes_neg(_s4));
        lanes_store(lists->fixed[122], _s5);
        lanes_store(lists->fixed[123], lanes_neg(_s5));
        lanes_store(lists->fixed[124], _s6);
        lanes_store(lists->fixed[125], lanes_neg(_s6));
        lanes_store(lists->fixed[126], _s7);
        lanes_store(lists->fixed[127], lanes_neg(_s7));
        lanes_store(lists->fixed[134], lanes_mul(K(5.684341886080802e-14), p_gravity));
        lanes_store(lists->fixed[135], _s0);
        lanes_store(lists->fixed[136], p_bridge_depth);
        lanes_store(lists->fixed[160], lanes_mul(K(3.0), p_gravity));
        lanes_store(lists->fixed[161], lanes_mul(K(2.0), lanes_mul(K(3.0), lanes_mul(p_gravity, p_gravity))));
        lanes_store(lists->fixed[162], lanes_mul(K(0.0078125), p_gravity));
        lanes_store(lists->fixed[163], lanes_max(K(0.0), p_gravity));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_leaves)(LANES(court_bounded_lists) *lists, size_t kept_leaves_shots, size_t varying)
{
    for (size_t i = 0; i < kept_leaves_shots; i += LANES_WIDTH) {
        const M rows = lanes_first(kept_leaves_shots - i);
        if (LANES_SELDOM(varying))
            LANES(court_bounded_fix_f426)(lists, i);
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
        V per_reach = lanes_load(lists->kept_leaves_per_reach + i);
        V snap = lanes_load(lists->kept_leaves_snap + i);
        V surge = lanes_load(lists->kept_leaves_surge + i);
        V vx = lanes_load(lists->kept_leaves_vx + i);
        V vy = lanes_load(lists->kept_leaves_vy + i);
        V vz = lanes_load(lists->kept_leaves_vz + i);
        V x = lanes_load(lists->kept_leaves_x + i);
        V y = lanes_load(lists->kept_leaves_y + i);
        V z = lanes_load(lists->kept_leaves_z + i);
        const LANES(court_error_bounds_out) _o427 =
            LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
        V position_error = _o427.position_error;
        V velocity_error = _o427.velocity_error;
        const LANES(court_holding_out) _o428 =
            LANES(court_holding)(held, K(0.0));
        M here = _o428.here;
        const M _m429 = lanes_both(rows, here);
        if (lanes_any(_m429)) {
            const LANES(court_ring_tube_out) _o430 =
                LANES(court_ring_tube)(lanes_load(lists->fixed[111]));
            per_reach = lanes_select(_m429, _o430.per_reach, per_reach);
            const LANES(court_ring_parting_out) _o431 =
                LANES(court_ring_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[160]), lanes_load(lists->fixed[161]));
            lift = lanes_select(_m429, _o431.lift, lift);
            surge = lanes_select(_m429, _o431.surge, surge);
            snap = lanes_select(_m429, _o431.snap, snap);
        }
        const LANES(court_holding_out) _o432 =
            LANES(court_holding)(held, K(1.0));
        here = _o432.here;
        const M _m433 = lanes_both(rows, here);
        if (lanes_any(_m433)) {
            const LANES(court_backboard_tube_out) _o434 =
                LANES(court_backboard_tube)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[116]), lanes_load(lists->fixed[117]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[118]), lanes_load(lists->fixed[119]), lanes_load(lists->fixed[120]), lanes_load(lists->fixed[121]), lanes_load(lists->fixed[112]));
            per_reach = lanes_select(_m433, _o434.per_reach, per_reach);
            const LANES(court_backboard_parting_out) _o435 =
                LANES(court_backboard_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[23]));
            lift = lanes_select(_m433, _o435.lift, lift);
            surge = lanes_select(_m433, _o435.surge, surge);
            snap = lanes_select(_m433, _o435.snap, snap);
        }
        const LANES(court_holding_out) _o436 =
            LANES(court_holding)(held, K(2.0));
        here = _o436.here;
        const M _m437 = lanes_both(rows, here);
        if (lanes_any(_m437)) {
            const LANES(court_bridge_tube_out) _o438 =
                LANES(court_bridge_tube)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[122]), lanes_load(lists->fixed[123]), lanes_load(lists->fixed[124]), lanes_load(lists->fixed[125]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[127]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[112]));
            per_reach = lanes_select(_m437, _o438.per_reach, per_reach);
            const LANES(court_bridge_parting_out) _o439 =
                LANES(court_bridge_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[23]));
            lift = lanes_select(_m437, _o439.lift, lift);
            surge = lanes_select(_m437, _o439.surge, surge);
            snap = lanes_select(_m437, _o439.snap, snap);
        }
        const LANES(court_unmet_out) _o440 =
            LANES(court_unmet)();
        V spare = _o440.spare;
        const LANES(court_beside_out) _o441 =
            LANES(court_beside)(held, K(0.0));
        M beside = _o441.beside;
        const M _m442 = lanes_both(rows, beside);
        if (lanes_any(_m442)) {
            const LANES(court_ring_beside_out) _o443 =
                LANES(court_ring_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[40]), lanes_load(lists->fixed[135]));
            V gap = _o443.gap;
            V nearing = _o443.nearing;
            V dent = _o443.dent;
            const LANES(court_spared_out) _o444 =
                LANES(court_spared)(dent, gap, nearing, spare, vx, vy, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[162]));
            spare = lanes_select(_m442, _o444.spare, spare);
        }
        const LANES(court_beside_out) _o445 =
            LANES(court_beside)(held, K(1.0));
        beside = _o445.beside;
        const M _m446 = lanes_both(rows, beside);
        if (lanes_any(_m446)) {
            const LANES(court_backboard_beside_out) _o447 =
                LANES(court_backboard_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[15]));
            V gap = _o447.gap;
            V nearing = _o447.nearing;
            V dent = _o447.dent;
            const LANES(court_spared_out) _o448 =
                LANES(court_spared)(dent, gap, nearing, spare, vx, vy, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[162]));
            spare = lanes_select(_m446, _o448.spare, spare);
        }
        const LANES(court_beside_out) _o449 =
            LANES(court_beside)(held, K(2.0));
        beside = _o449.beside;
        const M _m450 = lanes_both(rows, beside);
        if (lanes_any(_m450)) {
            const LANES(court_bridge_beside_out) _o451 =
                LANES(court_bridge_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]));
            V gap = _o451.gap;
            V nearing = _o451.nearing;
            V dent = _o451.dent;
            const LANES(court_spared_out) _o452 =
                LANES(court_spared)(dent, gap, nearing, spare, vx, vy, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[162]));
            spare = lanes_select(_m450, _o452.spare, spare);
        }
        const LANES(court_beside_out) _o453 =
            LANES(court_beside)(held, K(3.0));
        beside = _o453.beside;
        const M _m454 = lanes_both(rows, beside);
        if (lanes_any(_m454)) {
            const LANES(court_end_beside_out) _o455 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[18]));
            V gap = _o455.gap;
            V nearing = _o455.nearing;
            V dent = _o455.dent;
            const LANES(court_spared_out) _o456 =
                LANES(court_spared)(dent, gap, nearing, spare, vx, vy, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[162]));
            spare = lanes_select(_m454, _o456.spare, spare);
        }
        const LANES(court_holding_out) _o457 =
            LANES(court_holding)(held, K(1.0));
        here = _o457.here;
        const M _m458 = lanes_both(rows, here);
        if (lanes_any(_m458)) {
            const LANES(court_backboard_seam0_out) _o459 =
                LANES(court_backboard_seam0)(vx, x, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[116]));
            V gap = _o459.gap;
            V nearing = _o459.nearing;
            V near = _o459.near;
            const LANES(court_spared_seam_out) _o460 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[163]));
            spare = lanes_select(_m458, _o460.spare, spare);
            const LANES(court_backboard_seam1_out) _o461 =
                LANES(court_backboard_seam1)(vx, x, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[116]));
            gap = _o461.gap;
            nearing = _o461.nearing;
            near = _o461.near;
            const LANES(court_spared_seam_out) _o462 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[163]));
            spare = lanes_select(_m458, _o462.spare, spare);
            const LANES(court_backboard_seam2_out) _o463 =
                LANES(court_backboard_seam2)(vy, y, lanes_load(lists->fixed[10]), lanes_load(lists->fixed[118]));
            gap = _o463.gap;
            nearing = _o463.nearing;
            near = _o463.near;
            const LANES(court_spared_seam_out) _o464 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[163]));
            spare = lanes_select(_m458, _o464.spare, spare);
            const LANES(court_backboard_seam3_out) _o465 =
                LANES(court_backboard_seam3)(vy, y, lanes_load(lists->fixed[10]), lanes_load(lists->fixed[118]));
            gap = _o465.gap;
            nearing = _o465.nearing;
            near = _o465.near;
            const LANES(court_spared_seam_out) _o466 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[163]));
            spare = lanes_select(_m458, _o466.spare, spare);
            const LANES(court_backboard_seam4_out) _o467 =
                LANES(court_backboard_seam4)(vz, z, lanes_load(lists->fixed[11]), lanes_load(lists->fixed[120]));
            gap = _o467.gap;
            nearing = _o467.nearing;
            near = _o467.near;
            const LANES(court_spared_seam_out) _o468 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[163]));
            spare = lanes_select(_m458, _o468.spare, spare);
            const LANES(court_backboard_seam5_out) _o469 =
                LANES(court_backboard_seam5)(vz, z, lanes_load(lists->fixed[12]), lanes_load(lists->fixed[120]));
            gap = _o469.gap;
            nearing = _o469.nearing;
            near = _o469.near;
            const LANES(court_spared_seam_out) _o470 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[163]));
            spare = lanes_select(_m458, _o470.spare, spare);
        }
        const LANES(court_holding_out) _o471 =
            LANES(court_holding)(held, K(2.0));
        here = _o471.here;
        const M _m472 = lanes_both(rows, here);
        if (lanes_any(_m472)) {
            const LANES(court_bridge_seam0_out) _o473 =
                LANES(court_bridge_seam0)(vx, x, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[122]));
            V gap = _o473.gap;
            V nearing = _o473.nearing;
            V near = _o473.near;
            const LANES(court_spared_seam_out) _o474 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[163]));
            spare = lanes_select(_m472, _o474.spare, spare);
            const LANES(court_bridge_seam1_out) _o475 =
                LANES(court_bridge_seam1)(vx, x, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[122]));
            gap = _o475.gap;
            nearing = _o475.nearing;
            near = _o475.near;
            const LANES(court_spared_seam_out) _o476 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[163]));
            spare = lanes_select(_m472, _o476.spare, spare);
            const LANES(court_bridge_seam2_out) _o477 =
                LANES(court_bridge_seam2)(vy, y, lanes_load(lists->fixed[13]), lanes_load(lists->fixed[124]));
            gap = _o477.gap;
            nearing = _o477.nearing;
            near = _o477.near;
            const LANES(court_spared_seam_out) _o478 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[163]));
            spare = lanes_select(_m472, _o478.spare, spare);
            const LANES(court_bridge_seam3_out) _o479 =
                LANES(court_bridge_seam3)(vy, y, lanes_load(lists->fixed[13]), lanes_load(lists->fixed[124]));
            gap = _o479.gap;
            nearing = _o479.nearing;
            near = _o479.near;
            const LANES(court_spared_seam_out) _o480 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[163]));
            spare = lanes_select(_m472, _o480.spare, spare);
            const LANES(court_bridge_seam4_out) _o481 =
                LANES(court_bridge_seam4)(vz, z, lanes_load(lists->fixed[136]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[126]));
            gap = _o481.gap;
            nearing = _o481.nearing;
            near = _o481.near;
            const LANES(court_spared_seam_out) _o482 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[163]));
            spare = lanes_select(_m472, _o482.spare, spare);
            const LANES(court_bridge_seam5_out) _o483 =
                LANES(court_bridge_seam5)(vz, z, lanes_load(lists->fixed[8]), lanes_load(lists->fixed[126]));
            gap = _o483.gap;
            nearing = _o483.nearing;
            near = _o483.near;
            const LANES(court_spared_seam_out) _o484 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[163]));
            spare = lanes_select(_m472, _o484.spare, spare);
        }
        const LANES(court_parted_out) _o485 =
            LANES(court_parted)(doubt, lift, per_reach, position_error, snap, spare, surge, velocity_error, vx, vy, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[162]), lanes_load(lists->fixed[134]));
        V when = _o485.when;
        doubt = _o485.doubt;
        const LANES(court_hopping_out) _o486 =
            LANES(court_hopping)();
        V which = _o486.which;
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
        if (LANES_SELDOM(varying))
            LANES(court_bounded_fix_f203)(lists, i);
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
        const LANES(court_resumed_out) _o204 =
            LANES(court_resumed)(clock, mode, position_error, velocity_error);
        V which = _o204.which;
        V late = _o204.late;
        V began = _o204.began;
        V doubt = _o204.doubt;
        M begins = _o204.begins;
        M rolling = _o204.rolling;
        M leaves = _o204.leaves;
        V nx = _o204.nx;
        V ny = _o204.ny;
        V nz = _o204.nz;
        V gap = _o204.gap;
        V bent_x = _o204.bent_x;
        V bent_y = _o204.bent_y;
        V bent_z = _o204.bent_z;
        V lift = _o204.lift;
        V surge = _o204.surge;
        V snap = _o204.snap;
        V per_reach = _o204.per_reach;
        const M _m205 = lanes_both(rows, begins);
        if (lanes_any(_m205)) {
            const LANES(court_holding_out) _o206 =
                LANES(court_holding)(held, K(0.0));
            M here = _o206.here;
            const M _m207 = lanes_both(_m205, here);
            {
                const LANES(court_ring_normal_out) _o208 =
                    LANES(court_ring_normal)(x, y, z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[111]));
                nx = lanes_select(_m207, _o208.nx, nx);
                ny = lanes_select(_m207, _o208.ny, ny);
                nz = lanes_select(_m207, _o208.nz, nz);
            }
            const LANES(court_holding_out) _o209 =
                LANES(court_holding)(held, K(1.0));
            here = _o209.here;
            const M _m210 = lanes_both(_m205, here);
            {
                const LANES(court_backboard_normal_out) _o211 =
                    LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[15]));
                nx = lanes_select(_m210, _o211.nx, nx);
                ny = lanes_select(_m210, _o211.ny, ny);
                nz = lanes_select(_m210, _o211.nz, nz);
            }
            const LANES(court_holding_out) _o212 =
                LANES(court_holding)(held, K(2.0));
            here = _o212.here;
            const M _m213 = lanes_both(_m205, here);
            {
                const LANES(court_bridge_normal_out) _o214 =
                    LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[16]));
                nx = lanes_select(_m213, _o214.nx, nx);
                ny = lanes_select(_m213, _o214.ny, ny);
                nz = lanes_select(_m213, _o214.nz, nz);
            }
            const LANES(court_roll_turn_rate_out) _o215 =
                LANES(court_roll_turn_rate)(nx, ny, nz, wx, wy, wz, lanes_load(lists->fixed[6]));
            V turn_rate = _o215.turn_rate;
            const LANES(court_gripped_out) _o216 =
                LANES(court_gripped)(nx, ny, nz, vx, vy, vz, wx, wy, wz, lanes_load(lists->fixed[6]));
            V rolled_x = _o216.rolled_x;
            V rolled_y = _o216.rolled_y;
            V rolled_z = _o216.rolled_z;
            const LANES(court_holding_out) _o217 =
                LANES(court_holding)(held, K(0.0));
            here = _o217.here;
            const M _m218 = lanes_both(_m205, here);
            {
                const LANES(court_ring_off_out) _o219 =
                    LANES(court_ring_off)(x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]));
                gap = lanes_select(_m218, _o219.gap, gap);
            }
            const LANES(court_holding_out) _o220 =
                LANES(court_holding)(held, K(1.0));
            here = _o220.here;
            const M _m221 = lanes_both(_m205, here);
            {
                const LANES(court_backboard_off_out) _o222 =
                    LANES(court_backboard_off)(x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[15]));
                gap = lanes_select(_m221, _o222.gap, gap);
            }
            const LANES(court_holding_out) _o223 =
                LANES(court_holding)(held, K(2.0));
            here = _o223.here;
            const M _m224 = lanes_both(_m205, here);
            {
                const LANES(court_bridge_off_out) _o225 =
                    LANES(court_bridge_off)(x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]));
                gap = lanes_select(_m224, _o225.gap, gap);
            }
            const LANES(court_roll_placed_out) _o226 =
                LANES(court_roll_placed)(gap, nx, ny, nz, turn_rate, rolled_x, rolled_y, rolled_z, x, y, z, lanes_load(lists->fixed[112]));
            x = lanes_select(_m205, _o226.x, x);
            y = lanes_select(_m205, _o226.y, y);
            z = lanes_select(_m205, _o226.z, z);
            vx = lanes_select(_m205, _o226.vx, vx);
            vy = lanes_select(_m205, _o226.vy, vy);
            vz = lanes_select(_m205, _o226.vz, vz);
            wx = lanes_select(_m205, _o226.wx, wx);
            wy = lanes_select(_m205, _o226.wy, wy);
            wz = lanes_select(_m205, _o226.wz, wz);
            const LANES(court_begun_errors_out) _o227 =
                LANES(court_begun_errors)(dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, vx, vy, vz, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[113]), lanes_load(lists->fixed[114]), lanes_load(lists->fixed[115]));
            dx = lanes_select(_m205, _o227.dx, dx);
            dy = lanes_select(_m205, _o227.dy, dy);
            dz = lanes_select(_m205, _o227.dz, dz);
            dvx = lanes_select(_m205, _o227.dvx, dvx);
            dvy = lanes_select(_m205, _o227.dvy, dvy);
            dvz = lanes_select(_m205, _o227.dvz, dvz);
            dwx = lanes_select(_m205, _o227.dwx, dwx);
            dwy = lanes_select(_m205, _o227.dwy, dwy);
            dwz = lanes_select(_m205, _o227.dwz, dwz);
            const LANES(court_untaut_out) _o228 =
                LANES(court_untaut)();
            taut = lanes_select(_m205, _o228.taut, taut);
            const LANES(court_beginning_contact_out) _o229 =
                LANES(court_beginning_contact)();
            which = lanes_select(_m205, _o229.which, which);
            circled = lanes_select(_m205, _o229.circled, circled);
        }
        const LANES(court_circles_out) _o230 =
            LANES(court_circles)(held, K(0.0), rolling);
        M circling = _o230.circling;
        rolling = _o230.rolling;
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
            if (LANES_SELDOM(varying)) {
                lanes_pack(lists->kept_rolling_p_backboard_friction + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_backboard_friction + i : lists->p_backboard_friction));
                lanes_pack(lists->kept_rolling_p_ball_radius + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_ball_radius + i : lists->p_ball_radius));
                lanes_pack(lists->kept_rolling_p_board_bottom + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_board_bottom + i : lists->p_board_bottom));
                lanes_pack(lists->kept_rolling_p_board_distance + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_board_distance + i : lists->p_board_distance));
                lanes_pack(lists->kept_rolling_p_board_half_width + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_board_half_width + i : lists->p_board_half_width));
                lanes_pack(lists->kept_rolling_p_board_thickness + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_board_thickness + i : lists->p_board_thickness));
                lanes_pack(lists->kept_rolling_p_board_top + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_board_top + i : lists->p_board_top));
                lanes_pack(lists->kept_rolling_p_bridge_depth + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_bridge_depth + i : lists->p_bridge_depth));
                lanes_pack(lists->kept_rolling_p_bridge_friction + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_bridge_friction + i : lists->p_bridge_friction));
                lanes_pack(lists->kept_rolling_p_bridge_half_width + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_bridge_half_width + i : lists->p_bridge_half_width));
                lanes_pack(lists->kept_rolling_p_end_depth + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_end_depth + i : lists->p_end_depth));
                lanes_pack(lists->kept_rolling_p_gravity + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_gravity + i : lists->p_gravity));
                lanes_pack(lists->kept_rolling_p_ring_radius + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_ring_radius + i : lists->p_ring_radius));
                lanes_pack(lists->kept_rolling_p_wire_radius + kept_rolling_shots, packed, lanes_load(varying ? lists->kept_p_wire_radius + i : lists->p_wire_radius));
            }
            kept_rolling_shots += lanes_many(packed);
        }
    }
    {
        size_t taken = 0, busy = 0;
        M active = lanes_nowhere();
        V row = K(0.0), turns = K(0.0);
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
                if (LANES_SELDOM(varying))
                    LANES(court_bounded_fix_f231)(lists, taken, idle);
                const size_t room = LANES_WIDTH - busy, left = kept_rolling_shots - taken;
                active = lanes_leading(idle, left, active);
                taken += left < room ? left : room;
                busy += left < room ? left : room;
            }
            if (busy == 0)
                break;
            M rolling = active;
            const LANES(court_error_bounds_out) _o232 =
                LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            V position_error = _o232.position_error;
            V velocity_error = _o232.velocity_error;
            const LANES(court_holding_out) _o233 =
                LANES(court_holding)(held, K(1.0));
            M here = _o233.here;
            const M _m234 = lanes_both(active, here);
            if (lanes_any(_m234)) {
                const LANES(court_backboard_normal_out) _o235 =
                    LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[15]));
                nx = lanes_select(_m234, _o235.nx, nx);
                ny = lanes_select(_m234, _o235.ny, ny);
                nz = lanes_select(_m234, _o235.nz, nz);
                const LANES(court_backboard_tube_out) _o236 =
                    LANES(court_backboard_tube)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[116]), lanes_load(lists->fixed[117]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[118]), lanes_load(lists->fixed[119]), lanes_load(lists->fixed[120]), lanes_load(lists->fixed[121]), lanes_load(lists->fixed[112]));
                bent_x = lanes_select(_m234, _o236.bent_x, bent_x);
                bent_y = lanes_select(_m234, _o236.bent_y, bent_y);
                bent_z = lanes_select(_m234, _o236.bent_z, bent_z);
                per_reach = lanes_select(_m234, _o236.per_reach, per_reach);
            }
            const LANES(court_holding_out) _o237 =
                LANES(court_holding)(held, K(2.0));
            here = _o237.here;
            const M _m238 = lanes_both(active, here);
            if (lanes_any(_m238)) {
                const LANES(court_bridge_normal_out) _o239 =
                    LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[16]));
                nx = lanes_select(_m238, _o239.nx, nx);
                ny = lanes_select(_m238, _o239.ny, ny);
                nz = lanes_select(_m238, _o239.nz, nz);
                const LANES(court_bridge_tube_out) _o240 =
                    LANES(court_bridge_tube)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[122]), lanes_load(lists->fixed[123]), lanes_load(lists->fixed[124]), lanes_load(lists->fixed[125]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[127]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[112]));
                bent_x = lanes_select(_m238, _o240.bent_x, bent_x);
                bent_y = lanes_select(_m238, _o240.bent_y, bent_y);
                bent_z = lanes_select(_m238, _o240.bent_z, bent_z);
                per_reach = lanes_select(_m238, _o240.per_reach, per_reach);
            }
            const LANES(court_roll_start_out) _o241 =
                LANES(court_roll_start)(nx, ny, nz, vx, vy, vz, wx, wy, wz, lanes_load(lists->fixed[6]));
            V vx_0 = _o241.vx_0;
            V vy_0 = _o241.vy_0;
            V vz_0 = _o241.vz_0;
            V nx_0 = _o241.nx_0;
            V ny_0 = _o241.ny_0;
            V nz_0 = _o241.nz_0;
            V turn_rate_0 = _o241.turn_rate_0;
            const LANES(court_roll_0_out) _o242 =
                LANES(court_roll_0)(bent_x, bent_y, bent_z, nx_0, ny_0, nz_0, per_reach, turn_rate_0, vx_0, vy_0, vz_0, lanes_load(lists->fixed[128]));
            V lift_0 = _o242.lift_0;
            V tx_0 = _o242.tx_0;
            V ty_0 = _o242.ty_0;
            V tz_0 = _o242.tz_0;
            V vx_1 = _o242.vx_1;
            V vy_1 = _o242.vy_1;
            V vz_1 = _o242.vz_1;
            V nx_1 = _o242.nx_1;
            V ny_1 = _o242.ny_1;
            V nz_1 = _o242.nz_1;
            V turn_rate_1 = _o242.turn_rate_1;
            const LANES(court_roll_1_out) _o243 =
                LANES(court_roll_1)(bent_x, bent_y, bent_z, lift_0, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1, lanes_load(lists->fixed[128]));
            V lift_1 = _o243.lift_1;
            V tx_1 = _o243.tx_1;
            V ty_1 = _o243.ty_1;
            V tz_1 = _o243.tz_1;
            V vx_2 = _o243.vx_2;
            V vy_2 = _o243.vy_2;
            V vz_2 = _o243.vz_2;
            V nx_2 = _o243.nx_2;
            V ny_2 = _o243.ny_2;
            V nz_2 = _o243.nz_2;
            V turn_rate_2 = _o243.turn_rate_2;
            const LANES(court_roll_2_out) _o244 =
                LANES(court_roll_2)(bent_x, bent_y, bent_z, lift_0, lift_1, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2, lanes_load(lists->fixed[128]));
            V lift_2 = _o244.lift_2;
            V tx_2 = _o244.tx_2;
            V ty_2 = _o244.ty_2;
            V tz_2 = _o244.tz_2;
            V vx_3 = _o244.vx_3;
            V vy_3 = _o244.vy_3;
            V vz_3 = _o244.vz_3;
            V nx_3 = _o244.nx_3;
            V ny_3 = _o244.ny_3;
            V nz_3 = _o244.nz_3;
            V turn_rate_3 = _o244.turn_rate_3;
            const LANES(court_roll_3_out) _o245 =
                LANES(court_roll_3)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3, lanes_load(lists->fixed[128]));
            V lift_3 = _o245.lift_3;
            V tx_3 = _o245.tx_3;
            V ty_3 = _o245.ty_3;
            V tz_3 = _o245.tz_3;
            V vx_4 = _o245.vx_4;
            V vy_4 = _o245.vy_4;
            V vz_4 = _o245.vz_4;
            V nx_4 = _o245.nx_4;
            V ny_4 = _o245.ny_4;
            V nz_4 = _o245.nz_4;
            V turn_rate_4 = _o245.turn_rate_4;
            const LANES(court_roll_4_out) _o246 =
                LANES(court_roll_4)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4, lanes_load(lists->fixed[128]));
            V lift_4 = _o246.lift_4;
            V tx_4 = _o246.tx_4;
            V ty_4 = _o246.ty_4;
            V tz_4 = _o246.tz_4;
            V vx_5 = _o246.vx_5;
            V vy_5 = _o246.vy_5;
            V vz_5 = _o246.vz_5;
            V nx_5 = _o246.nx_5;
            V ny_5 = _o246.ny_5;
            V nz_5 = _o246.nz_5;
            V turn_rate_5 = _o246.turn_rate_5;
            const LANES(court_roll_5_out) _o247 =
                LANES(court_roll_5)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, lanes_load(lists->fixed[128]));
            V lift_5 = _o247.lift_5;
            V tx_5 = _o247.tx_5;
            V ty_5 = _o247.ty_5;
            V tz_5 = _o247.tz_5;
            V vx_6 = _o247.vx_6;
            V vy_6 = _o247.vy_6;
            V vz_6 = _o247.vz_6;
            V nx_6 = _o247.nx_6;
            V ny_6 = _o247.ny_6;
            V nz_6 = _o247.nz_6;
            V turn_rate_6 = _o247.turn_rate_6;
            const LANES(court_roll_6_out) _o248 =
                LANES(court_roll_6)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, lanes_load(lists->fixed[128]));
            V lift_6 = _o248.lift_6;
            V tx_6 = _o248.tx_6;
            V ty_6 = _o248.ty_6;
            V tz_6 = _o248.tz_6;
            V vx_7 = _o248.vx_7;
            V vy_7 = _o248.vy_7;
            V vz_7 = _o248.vz_7;
            V nx_7 = _o248.nx_7;
            V ny_7 = _o248.ny_7;
            V nz_7 = _o248.nz_7;
            V turn_rate_7 = _o248.turn_rate_7;
            const LANES(court_roll_7_out) _o249 =
                LANES(court_roll_7)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, lanes_load(lists->fixed[128]));
            V lift_7 = _o249.lift_7;
            V vx_8 = _o249.vx_8;
            V vy_8 = _o249.vy_8;
            V vz_8 = _o249.vz_8;
            V nx_8 = _o249.nx_8;
            V ny_8 = _o249.ny_8;
            V nz_8 = _o249.nz_8;
            V turn_rate_8 = _o249.turn_rate_8;
            const LANES(court_roll_pace_out) _o250 =
                LANES(court_roll_pace)(lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, lift_7, nx_8, ny_8, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, nz_8, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[130]));
            V stride = _o250.stride;
            V missed = _o250.missed;
            V strongest = _o250.strongest;
            V fastest = _o250.fastest;
            V force = _o250.force;
            V force_rate = _o250.force_rate;
            V force_bend = _o250.force_bend;
            V brace = _o250.brace;
            const LANES(court_pulled_out) _o251 =
                LANES(court_pulled)(nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, turn_rate_0, turn_rate_1, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[130]));
            V drag = _o251.drag;
            V drag_rate = _o251.drag_rate;
            V strain = _o251.strain;
            V strain_rate = _o251.strain_rate;
            const LANES(court_holding_out) _o252 =
                LANES(court_holding)(held, K(1.0));
            here = _o252.here;
            const M _m253 = lanes_both(active, here);
            {
                const LANES(court_ring_impact_strained_out) _o254 =
                    LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, lanes_load(lists->fixed[131]));
                strain = lanes_select(_m253, _o254.strain, strain);
                strain_rate = lanes_select(_m253, _o254.strain_rate, strain_rate);
            }
            const LANES(court_holding_out) _o255 =
                LANES(court_holding)(held, K(2.0));
            here = _o255.here;
            const M _m256 = lanes_both(active, here);
            {
                const LANES(court_ring_impact_strained_out) _o257 =
                    LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, lanes_load(lists->fixed[132]));
                strain = lanes_select(_m256, _o257.strain, strain);
                strain_rate = lanes_select(_m256, _o257.strain_rate, strain_rate);
            }
            const LANES(court_losing_out) _o258 =
                LANES(court_losing)(grip_lost, strain);
            M loses = _o258.loses;
            const M _m259 = lanes_both(active, loses);
            if (lanes_any(_m259)) {
                const LANES(court_lost_grip_out) _o260 =
                    LANES(court_lost_grip)(clock, strain, strain_rate, taut, taut_clock, taut_rate);
                grip_lost = lanes_select(_m259, _o260.grip_lost, grip_lost);
            }
            const LANES(court_tightened_out) _o261 =
                LANES(court_tightened)(clock, strain, strain_rate);
            taut = _o261.taut;
            taut_rate = _o261.taut_rate;
            taut_clock = _o261.taut_clock;
            const LANES(court_leaving_force_out) _o262 =
                LANES(court_leaving_force)(brace, doubt, fastest, force, force_bend, force_rate, per_reach, position_error, stride, velocity_error, vx, vx_1, vy, vy_1, vz, vz_1, which, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[133]), lanes_load(lists->fixed[134]));
            stride = _o262.stride;
            which = _o262.which;
            M rests = _o262.rests;
            doubt = _o262.doubt;
            const LANES(court_beside_out) _o263 =
                LANES(court_beside)(held, K(0.0));
            M beside = _o263.beside;
            const M _m264 = lanes_both(active, beside);
            if (lanes_any(_m264)) {
                const LANES(court_ring_beside_out) _o265 =
                    LANES(court_ring_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[40]), lanes_load(lists->fixed[135]));
                V gap = _o265.gap;
                V nearing = _o265.nearing;
                V dent = _o265.dent;
                const LANES(court_beside_body_out) _o266 =
                    LANES(court_beside_body)(dent, doubt, fastest, gap, K(0.0), late, nearing, position_error, stride, strongest, which, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[113]));
                stride = lanes_select(_m264, _o266.stride, stride);
                which = lanes_select(_m264, _o266.which, which);
                doubt = lanes_select(_m264, _o266.doubt, doubt);
                late = lanes_select(_m264, _o266.late, late);
            }
            const LANES(court_beside_out) _o267 =
                LANES(court_beside)(held, K(1.0));
            beside = _o267.beside;
            const M _m268 = lanes_both(active, beside);
            if (lanes_any(_m268)) {
                const LANES(court_backboard_beside_out) _o269 =
                    LANES(court_backboard_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[15]));
                V gap = _o269.gap;
                V nearing = _o269.nearing;
                V dent = _o269.dent;
                const LANES(court_beside_body_out) _o270 =
                    LANES(court_beside_body)(dent, doubt, fastest, gap, K(1.0), late, nearing, position_error, stride, strongest, which, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[113]));
                stride = lanes_select(_m268, _o270.stride, stride);
                which = lanes_select(_m268, _o270.which, which);
                doubt = lanes_select(_m268, _o270.doubt, doubt);
                late = lanes_select(_m268, _o270.late, late);
            }
            const LANES(court_beside_out) _o271 =
                LANES(court_beside)(held, K(2.0));
            beside = _o271.beside;
            const M _m272 = lanes_both(active, beside);
            if (lanes_any(_m272)) {
                const LANES(court_bridge_beside_out) _o273 =
                    LANES(court_bridge_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]));
                V gap = _o273.gap;
                V nearing = _o273.nearing;
                V dent = _o273.dent;
                const LANES(court_beside_body_out) _o274 =
                    LANES(court_beside_body)(dent, doubt, fastest, gap, K(2.0), late, nearing, position_error, stride, strongest, which, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[113]));
                stride = lanes_select(_m272, _o274.stride, stride);
                which = lanes_select(_m272, _o274.which, which);
                doubt = lanes_select(_m272, _o274.doubt, doubt);
                late = lanes_select(_m272, _o274.late, late);
            }
            const LANES(court_end_beside_out) _o275 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[18]));
            V gap = _o275.gap;
            V nearing = _o275.nearing;
            V dent = _o275.dent;
            const LANES(court_beside_gate_out) _o276 =
                LANES(court_beside_gate)(dent, doubt, fastest, gap, K(3.0), late, nearing, position_error, stride, strongest, which, x, y, z, lanes_load(lists->fixed[6]));
            stride = _o276.stride;
            which = _o276.which;
            doubt = _o276.doubt;
            late = _o276.late;
            const LANES(court_holding_out) _o277 =
                LANES(court_holding)(held, K(1.0));
            here = _o277.here;
            const M _m278 = lanes_both(active, here);
            if (lanes_any(_m278)) {
                const LANES(court_backboard_seam0_out) _o279 =
                    LANES(court_backboard_seam0)(vx, x, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[116]));
                gap = lanes_select(_m278, _o279.gap, gap);
                V nearing = _o279.nearing;
                V near = _o279.near;
                const LANES(court_beside_seam_out) _o280 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m278, _o280.stride, stride);
                const LANES(court_backboard_seam1_out) _o281 =
                    LANES(court_backboard_seam1)(vx, x, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[116]));
                gap = lanes_select(_m278, _o281.gap, gap);
                nearing = _o281.nearing;
                near = _o281.near;
                const LANES(court_beside_seam_out) _o282 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m278, _o282.stride, stride);
                const LANES(court_backboard_seam2_out) _o283 =
                    LANES(court_backboard_seam2)(vy, y, lanes_load(lists->fixed[10]), lanes_load(lists->fixed[118]));
                gap = lanes_select(_m278, _o283.gap, gap);
                nearing = _o283.nearing;
                near = _o283.near;
                const LANES(court_beside_seam_out) _o284 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m278, _o284.stride, stride);
                const LANES(court_backboard_seam3_out) _o285 =
                    LANES(court_backboard_seam3)(vy, y, lanes_load(lists->fixed[10]), lanes_load(lists->fixed[118]));
                gap = lanes_select(_m278, _o285.gap, gap);
                nearing = _o285.nearing;
                near = _o285.near;
                const LANES(court_beside_seam_out) _o286 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m278, _o286.stride, stride);
                const LANES(court_backboard_seam4_out) _o287 =
                    LANES(court_backboard_seam4)(vz, z, lanes_load(lists->fixed[11]), lanes_load(lists->fixed[120]));
                gap = lanes_select(_m278, _o287.gap, gap);
                nearing = _o287.nearing;
                near = _o287.near;
                const LANES(court_beside_seam_out) _o288 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m278, _o288.stride, stride);
                const LANES(court_backboard_seam5_out) _o289 =
                    LANES(court_backboard_seam5)(vz, z, lanes_load(lists->fixed[12]), lanes_load(lists->fixed[120]));
                gap = lanes_select(_m278, _o289.gap, gap);
                nearing = _o289.nearing;
                near = _o289.near;
                const LANES(court_beside_seam_out) _o290 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m278, _o290.stride, stride);
            }
            const LANES(court_holding_out) _o291 =
                LANES(court_holding)(held, K(2.0));
            here = _o291.here;
            const M _m292 = lanes_both(active, here);
            if (lanes_any(_m292)) {
                const LANES(court_bridge_seam0_out) _o293 =
                    LANES(court_bridge_seam0)(vx, x, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[122]));
                gap = lanes_select(_m292, _o293.gap, gap);
                V nearing = _o293.nearing;
                V near = _o293.near;
                const LANES(court_beside_seam_out) _o294 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m292, _o294.stride, stride);
                const LANES(court_bridge_seam1_out) _o295 =
                    LANES(court_bridge_seam1)(vx, x, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[122]));
                gap = lanes_select(_m292, _o295.gap, gap);
                nearing = _o295.nearing;
                near = _o295.near;
                const LANES(court_beside_seam_out) _o296 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m292, _o296.stride, stride);
                const LANES(court_bridge_seam2_out) _o297 =
                    LANES(court_bridge_seam2)(vy, y, lanes_load(lists->fixed[13]), lanes_load(lists->fixed[124]));
                gap = lanes_select(_m292, _o297.gap, gap);
                nearing = _o297.nearing;
                near = _o297.near;
                const LANES(court_beside_seam_out) _o298 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m292, _o298.stride, stride);
                const LANES(court_bridge_seam3_out) _o299 =
                    LANES(court_bridge_seam3)(vy, y, lanes_load(lists->fixed[13]), lanes_load(lists->fixed[124]));
                gap = lanes_select(_m292, _o299.gap, gap);
                nearing = _o299.nearing;
                near = _o299.near;
                const LANES(court_beside_seam_out) _o300 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m292, _o300.stride, stride);
                const LANES(court_bridge_seam4_out) _o301 =
                    LANES(court_bridge_seam4)(vz, z, lanes_load(lists->fixed[136]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[126]));
                gap = lanes_select(_m292, _o301.gap, gap);
                nearing = _o301.nearing;
                near = _o301.near;
                const LANES(court_beside_seam_out) _o302 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m292, _o302.stride, stride);
                const LANES(court_bridge_seam5_out) _o303 =
                    LANES(court_bridge_seam5)(vz, z, lanes_load(lists->fixed[8]), lanes_load(lists->fixed[126]));
                gap = lanes_select(_m292, _o303.gap, gap);
                nearing = _o303.nearing;
                near = _o303.near;
                const LANES(court_beside_seam_out) _o304 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m292, _o304.stride, stride);
            }
            const LANES(court_beside_time_out) _o305 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o305.stride;
            which = _o305.which;
            const LANES(court_apart_out) _o306 =
                LANES(court_apart)(dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[137]), lanes_load(lists->fixed[138]));
            V apart = _o306.apart;
            const LANES(court_neighbour_out) _o307 =
                LANES(court_neighbour)(apart, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, vx, vy, vz, wx, wy, wz, x, y, z);
            V far_x = _o307.far_x;
            V far_y = _o307.far_y;
            V far_z = _o307.far_z;
            V far_vx = _o307.far_vx;
            V far_vy = _o307.far_vy;
            V far_vz = _o307.far_vz;
            V far_wx = _o307.far_wx;
            V far_wy = _o307.far_wy;
            V far_wz = _o307.far_wz;
            V far_nx = _o307.far_nx;
            V far_ny = _o307.far_ny;
            V far_nz = _o307.far_nz;
            V far_gap = _o307.far_gap;
            const LANES(court_passing_from_out) _o308 =
                LANES(court_passing_from)(z);
            M over = _o308.over;
            const LANES(court_roll_moved_out) _o309 =
                LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, x, y, z);
            x = _o309.x;
            vx = _o309.vx;
            y = _o309.y;
            vy = _o309.vy;
            z = _o309.z;
            vz = _o309.vz;
            V turn_rate = _o309.turn_rate;
            const LANES(court_holding_out) _o310 =
                LANES(court_holding)(held, K(1.0));
            here = _o310.here;
            const M _m311 = lanes_both(active, here);
            if (lanes_any(_m311)) {
                const LANES(court_backboard_normal_out) _o312 =
                    LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[15]));
                nx = lanes_select(_m311, _o312.nx, nx);
                ny = lanes_select(_m311, _o312.ny, ny);
                nz = lanes_select(_m311, _o312.nz, nz);
                const LANES(court_backboard_off_out) _o313 =
                    LANES(court_backboard_off)(x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[15]));
                gap = lanes_select(_m311, _o313.gap, gap);
            }
            const LANES(court_holding_out) _o314 =
                LANES(court_holding)(held, K(2.0));
            here = _o314.here;
            const M _m315 = lanes_both(active, here);
            if (lanes_any(_m315)) {
                const LANES(court_bridge_normal_out) _o316 =
                    LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[16]));
                nx = lanes_select(_m315, _o316.nx, nx);
                ny = lanes_select(_m315, _o316.ny, ny);
                nz = lanes_select(_m315, _o316.nz, nz);
                const LANES(court_bridge_off_out) _o317 =
                    LANES(court_bridge_off)(x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]));
                gap = lanes_select(_m315, _o317.gap, gap);
            }
            const LANES(court_roll_placed_out) _o318 =
                LANES(court_roll_placed)(gap, nx, ny, nz, turn_rate, vx, vy, vz, x, y, z, lanes_load(lists->fixed[112]));
            x = _o318.x;
            y = _o318.y;
            z = _o318.z;
            vx = _o318.vx;
            vy = _o318.vy;
            vz = _o318.vz;
            wx = _o318.wx;
            wy = _o318.wy;
            wz = _o318.wz;
            const LANES(court_passing_in_contact_out) _o319 =
                LANES(court_passing_in_contact)(over, through, x, y, z, lanes_load(lists->fixed[19]));
            through = _o319.through;
            const LANES(court_holding_out) _o320 =
                LANES(court_holding)(held, K(1.0));
            here = _o320.here;
            const M _m321 = lanes_both(active, here);
            {
                const LANES(court_backboard_normal_out) _o322 =
                    LANES(court_backboard_normal)(far_x, far_y, far_z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[15]));
                far_nx = lanes_select(_m321, _o322.nx, far_nx);
                far_ny = lanes_select(_m321, _o322.ny, far_ny);
                far_nz = lanes_select(_m321, _o322.nz, far_nz);
            }
            const LANES(court_holding_out) _o323 =
                LANES(court_holding)(held, K(2.0));
            here = _o323.here;
            const M _m324 = lanes_both(active, here);
            {
                const LANES(court_bridge_normal_out) _o325 =
                    LANES(court_bridge_normal)(far_x, far_y, far_z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[16]));
                far_nx = lanes_select(_m324, _o325.nx, far_nx);
                far_ny = lanes_select(_m324, _o325.ny, far_ny);
                far_nz = lanes_select(_m324, _o325.nz, far_nz);
            }
            const LANES(court_roll_turn_rate_out) _o326 =
                LANES(court_roll_turn_rate)(far_nx, far_ny, far_nz, far_wx, far_wy, far_wz, lanes_load(lists->fixed[6]));
            turn_rate = _o326.turn_rate;
            const LANES(court_holding_out) _o327 =
                LANES(court_holding)(held, K(1.0));
            here = _o327.here;
            const M _m328 = lanes_both(active, here);
            if (lanes_any(_m328)) {
                const LANES(court_backboard_normal_out) _o329 =
                    LANES(court_backboard_normal)(far_x, far_y, far_z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[15]));
                far_nx = lanes_select(_m328, _o329.nx, far_nx);
                far_ny = lanes_select(_m328, _o329.ny, far_ny);
                far_nz = lanes_select(_m328, _o329.nz, far_nz);
                const LANES(court_backboard_off_out) _o330 =
                    LANES(court_backboard_off)(far_x, far_y, far_z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[15]));
                far_gap = lanes_select(_m328, _o330.gap, far_gap);
            }
            const LANES(court_holding_out) _o331 =
                LANES(court_holding)(held, K(2.0));
            here = _o331.here;
            const M _m332 = lanes_both(active, here);
            if (lanes_any(_m332)) {
                const LANES(court_bridge_normal_out) _o333 =
                    LANES(court_bridge_normal)(far_x, far_y, far_z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[16]));
                far_nx = lanes_select(_m332, _o333.nx, far_nx);
                far_ny = lanes_select(_m332, _o333.ny, far_ny);
                far_nz = lanes_select(_m332, _o333.nz, far_nz);
                const LANES(court_bridge_off_out) _o334 =
                    LANES(court_bridge_off)(far_x, far_y, far_z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]));
                far_gap = lanes_select(_m332, _o334.gap, far_gap);
            }
            const LANES(court_roll_placed_out) _o335 =
                LANES(court_roll_placed)(far_gap, far_nx, far_ny, far_nz, turn_rate, far_vx, far_vy, far_vz, far_x, far_y, far_z, lanes_load(lists->fixed[112]));
            far_x = _o335.x;
            far_y = _o335.y;
            far_z = _o335.z;
            far_vx = _o335.vx;
            far_vy = _o335.vy;
            far_vz = _o335.vz;
            far_wx = _o335.wx;
            far_wy = _o335.wy;
            far_wz = _o335.wz;
            const LANES(court_roll_start_out) _o336 =
                LANES(court_roll_start)(far_nx, far_ny, far_nz, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, lanes_load(lists->fixed[6]));
            vx_0 = _o336.vx_0;
            vy_0 = _o336.vy_0;
            vz_0 = _o336.vz_0;
            nx_0 = _o336.nx_0;
            ny_0 = _o336.ny_0;
            nz_0 = _o336.nz_0;
            turn_rate_0 = _o336.turn_rate_0;
            const LANES(court_roll_0_out) _o337 =
                LANES(court_roll_0)(bent_x, bent_y, bent_z, nx_0, ny_0, nz_0, per_reach, turn_rate_0, vx_0, vy_0, vz_0, lanes_load(lists->fixed[128]));
            lift_0 = _o337.lift_0;
            tx_0 = _o337.tx_0;
            ty_0 = _o337.ty_0;
            tz_0 = _o337.tz_0;
            vx_1 = _o337.vx_1;
            vy_1 = _o337.vy_1;
            vz_1 = _o337.vz_1;
            nx_1 = _o337.nx_1;
            ny_1 = _o337.ny_1;
            nz_1 = _o337.nz_1;
            turn_rate_1 = _o337.turn_rate_1;
            const LANES(court_roll_1_out) _o338 =
                LANES(court_roll_1)(bent_x, bent_y, bent_z, lift_0, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1, lanes_load(lists->fixed[128]));
            lift_1 = _o338.lift_1;
            tx_1 = _o338.tx_1;
            ty_1 = _o338.ty_1;
            tz_1 = _o338.tz_1;
            vx_2 = _o338.vx_2;
            vy_2 = _o338.vy_2;
            vz_2 = _o338.vz_2;
            nx_2 = _o338.nx_2;
            ny_2 = _o338.ny_2;
            nz_2 = _o338.nz_2;
            turn_rate_2 = _o338.turn_rate_2;
            const LANES(court_roll_2_out) _o339 =
                LANES(court_roll_2)(bent_x, bent_y, bent_z, lift_0, lift_1, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2, lanes_load(lists->fixed[128]));
            lift_2 = _o339.lift_2;
            tx_2 = _o339.tx_2;
            ty_2 = _o339.ty_2;
            tz_2 = _o339.tz_2;
            vx_3 = _o339.vx_3;
            vy_3 = _o339.vy_3;
            vz_3 = _o339.vz_3;
            nx_3 = _o339.nx_3;
            ny_3 = _o339.ny_3;
            nz_3 = _o339.nz_3;
            turn_rate_3 = _o339.turn_rate_3;
            const LANES(court_roll_3_out) _o340 =
                LANES(court_roll_3)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3, lanes_load(lists->fixed[128]));
            lift_3 = _o340.lift_3;
            tx_3 = _o340.tx_3;
            ty_3 = _o340.ty_3;
            tz_3 = _o340.tz_3;
            vx_4 = _o340.vx_4;
            vy_4 = _o340.vy_4;
            vz_4 = _o340.vz_4;
            nx_4 = _o340.nx_4;
            ny_4 = _o340.ny_4;
            nz_4 = _o340.nz_4;
            turn_rate_4 = _o340.turn_rate_4;
            const LANES(court_roll_4_out) _o341 =
                LANES(court_roll_4)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4, lanes_load(lists->fixed[128]));
            lift_4 = _o341.lift_4;
            tx_4 = _o341.tx_4;
            ty_4 = _o341.ty_4;
            tz_4 = _o341.tz_4;
            vx_5 = _o341.vx_5;
            vy_5 = _o341.vy_5;
            vz_5 = _o341.vz_5;
            nx_5 = _o341.nx_5;
            ny_5 = _o341.ny_5;
            nz_5 = _o341.nz_5;
            turn_rate_5 = _o341.turn_rate_5;
            const LANES(court_roll_5_out) _o342 =
                LANES(court_roll_5)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, lanes_load(lists->fixed[128]));
            lift_5 = _o342.lift_5;
            tx_5 = _o342.tx_5;
            ty_5 = _o342.ty_5;
            tz_5 = _o342.tz_5;
            vx_6 = _o342.vx_6;
            vy_6 = _o342.vy_6;
            vz_6 = _o342.vz_6;
            nx_6 = _o342.nx_6;
            ny_6 = _o342.ny_6;
            nz_6 = _o342.nz_6;
            turn_rate_6 = _o342.turn_rate_6;
            const LANES(court_roll_6_out) _o343 =
                LANES(court_roll_6)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, lanes_load(lists->fixed[128]));
            lift_6 = _o343.lift_6;
            tx_6 = _o343.tx_6;
            ty_6 = _o343.ty_6;
            tz_6 = _o343.tz_6;
            vx_7 = _o343.vx_7;
            vy_7 = _o343.vy_7;
            vz_7 = _o343.vz_7;
            nx_7 = _o343.nx_7;
            ny_7 = _o343.ny_7;
            nz_7 = _o343.nz_7;
            turn_rate_7 = _o343.turn_rate_7;
            const LANES(court_roll_7_out) _o344 =
                LANES(court_roll_7)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, lanes_load(lists->fixed[128]));
            vx_8 = _o344.vx_8;
            vy_8 = _o344.vy_8;
            vz_8 = _o344.vz_8;
            turn_rate_8 = _o344.turn_rate_8;
            const LANES(court_roll_moved_out) _o345 =
                LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, far_x, far_y, far_z);
            far_x = _o345.x;
            far_vx = _o345.vx;
            far_y = _o345.y;
            far_vy = _o345.vy;
            far_z = _o345.z;
            far_vz = _o345.vz;
            turn_rate = _o345.turn_rate;
            const LANES(court_holding_out) _o346 =
                LANES(court_holding)(held, K(1.0));
            here = _o346.here;
            const M _m347 = lanes_both(active, here);
            if (lanes_any(_m347)) {
                const LANES(court_backboard_normal_out) _o348 =
                    LANES(court_backboard_normal)(far_x, far_y, far_z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[15]));
                far_nx = lanes_select(_m347, _o348.nx, far_nx);
                far_ny = lanes_select(_m347, _o348.ny, far_ny);
                far_nz = lanes_select(_m347, _o348.nz, far_nz);
                const LANES(court_backboard_off_out) _o349 =
                    LANES(court_backboard_off)(far_x, far_y, far_z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[15]));
                far_gap = lanes_select(_m347, _o349.gap, far_gap);
            }
            const LANES(court_holding_out) _o350 =
                LANES(court_holding)(held, K(2.0));
            here = _o350.here;
            const M _m351 = lanes_both(active, here);
            if (lanes_any(_m351)) {
                const LANES(court_bridge_normal_out) _o352 =
                    LANES(court_bridge_normal)(far_x, far_y, far_z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[16]));
                far_nx = lanes_select(_m351, _o352.nx, far_nx);
                far_ny = lanes_select(_m351, _o352.ny, far_ny);
                far_nz = lanes_select(_m351, _o352.nz, far_nz);
                const LANES(court_bridge_off_out) _o353 =
                    LANES(court_bridge_off)(far_x, far_y, far_z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]));
                far_gap = lanes_select(_m351, _o353.gap, far_gap);
            }
            const LANES(court_roll_placed_out) _o354 =
                LANES(court_roll_placed)(far_gap, far_nx, far_ny, far_nz, turn_rate, far_vx, far_vy, far_vz, far_x, far_y, far_z, lanes_load(lists->fixed[112]));
            far_x = _o354.x;
            far_y = _o354.y;
            far_z = _o354.z;
            far_vx = _o354.vx;
            far_vy = _o354.vy;
            far_vz = _o354.vz;
            far_wx = _o354.wx;
            far_wy = _o354.wy;
            far_wz = _o354.wz;
            const LANES(court_compared_out) _o355 =
                LANES(court_compared)(apart, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_x, far_y, far_z, missed, stride, vx, vy, vz, wx, wy, wz, x, y, z, lanes_load(lists->fixed[6]));
            dx = _o355.dx;
            dy = _o355.dy;
            dz = _o355.dz;
            dvx = _o355.dvx;
            dvy = _o355.dvy;
            dvz = _o355.dvz;
            dwx = _o355.dwx;
            dwy = _o355.dwy;
            dwz = _o355.dwz;
            const LANES(court_rolled_on_out) _o356 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o356.clock;
            rolling = _o356.rolling;
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
            if (LANES_SELDOM(varying)) {
                lanes_pack(lists->kept_circling_p_ball_radius + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_ball_radius + i : lists->p_ball_radius));
                lanes_pack(lists->kept_circling_p_board_bottom + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_board_bottom + i : lists->p_board_bottom));
                lanes_pack(lists->kept_circling_p_board_distance + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_board_distance + i : lists->p_board_distance));
                lanes_pack(lists->kept_circling_p_board_half_width + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_board_half_width + i : lists->p_board_half_width));
                lanes_pack(lists->kept_circling_p_board_thickness + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_board_thickness + i : lists->p_board_thickness));
                lanes_pack(lists->kept_circling_p_board_top + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_board_top + i : lists->p_board_top));
                lanes_pack(lists->kept_circling_p_bridge_depth + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_bridge_depth + i : lists->p_bridge_depth));
                lanes_pack(lists->kept_circling_p_bridge_half_width + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_bridge_half_width + i : lists->p_bridge_half_width));
                lanes_pack(lists->kept_circling_p_end_depth + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_end_depth + i : lists->p_end_depth));
                lanes_pack(lists->kept_circling_p_gravity + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_gravity + i : lists->p_gravity));
                lanes_pack(lists->kept_circling_p_ring_friction + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_ring_friction + i : lists->p_ring_friction));
                lanes_pack(lists->kept_circling_p_ring_radius + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_ring_radius + i : lists->p_ring_radius));
                lanes_pack(lists->kept_circling_p_wire_radius + kept_circling_shots, packed, lanes_load(varying ? lists->kept_p_wire_radius + i : lists->p_wire_radius));
            }
            kept_circling_shots += lanes_many(packed);
        }
    }
    {
        size_t taken = 0, busy = 0;
        M active = lanes_nowhere();
        V row = K(0.0), turns = K(0.0);
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
                if (LANES_SELDOM(varying))
                    LANES(court_bounded_fix_f357)(lists, taken, idle);
                const size_t room = LANES_WIDTH - busy, left = kept_circling_shots - taken;
                active = lanes_leading(idle, left, active);
                taken += left < room ? left : room;
                busy += left < room ? left : room;
            }
            if (busy == 0)
                break;
            M circling = active;
            const LANES(court_error_bounds_out) _o358 =
                LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            V position_error = _o358.position_error;
            V velocity_error = _o358.velocity_error;
            const LANES(court_ring_tube_out) _o359 =
                LANES(court_ring_tube)(lanes_load(lists->fixed[111]));
            V per_reach = _o359.per_reach;
            const LANES(court_ring_round_start_out) _o360 =
                LANES(court_ring_round_start)(per_reach, vx, vy, vz, wx, wy, wz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[135]));
            V cosine_0 = _o360.cosine_0;
            V sine_0 = _o360.sine_0;
            V climb_0 = _o360.climb_0;
            V along_0 = _o360.along_0;
            V turn_rate_0 = _o360.turn_rate_0;
            V cos_0 = _o360.cos_0;
            V sin_0 = _o360.sin_0;
            V tilted_0 = _o360.tilted_0;
            V near_0 = _o360.near_0;
            const LANES(court_ring_round_0_out) _o361 =
                LANES(court_ring_round_0)(along_0, climb_0, cosine_0, near_0, per_reach, sine_0, tilted_0, turn_rate_0, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[139]));
            V omega_0 = _o361.omega_0;
            V around_0 = _o361.around_0;
            V cosine_1 = _o361.cosine_1;
            V sine_1 = _o361.sine_1;
            V climb_1 = _o361.climb_1;
            V along_1 = _o361.along_1;
            V turn_rate_1 = _o361.turn_rate_1;
            V tilted_1 = _o361.tilted_1;
            const LANES(court_ring_round_1_out) _o362 =
                LANES(court_ring_round_1)(along_1, around_0, climb_0, climb_1, cosine_0, cosine_1, near_0, omega_0, per_reach, sine_0, sine_1, tilted_0, tilted_1, turn_rate_0, turn_rate_1, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[91]), lanes_load(lists->fixed[139]));
            V omega_1 = _o362.omega_1;
            V around_1 = _o362.around_1;
            V cosine_2 = _o362.cosine_2;
            V sine_2 = _o362.sine_2;
            V climb_2 = _o362.climb_2;
            V along_2 = _o362.along_2;
            V turn_rate_2 = _o362.turn_rate_2;
            V tilted_2 = _o362.tilted_2;
            const LANES(court_ring_round_2_out) _o363 =
                LANES(court_ring_round_2)(along_2, around_0, around_1, climb_0, climb_1, climb_2, cosine_0, cosine_1, cosine_2, near_0, omega_0, omega_1, per_reach, sine_0, sine_1, sine_2, tilted_0, tilted_1, tilted_2, turn_rate_0, turn_rate_1, turn_rate_2, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[140]), lanes_load(lists->fixed[139]));
            V omega_2 = _o363.omega_2;
            V around_2 = _o363.around_2;
            V cosine_3 = _o363.cosine_3;
            V sine_3 = _o363.sine_3;
            V climb_3 = _o363.climb_3;
            V along_3 = _o363.along_3;
            V turn_rate_3 = _o363.turn_rate_3;
            V tilted_3 = _o363.tilted_3;
            const LANES(court_ring_round_3_out) _o364 =
                LANES(court_ring_round_3)(along_3, around_0, around_1, around_2, climb_0, climb_1, climb_2, climb_3, cosine_0, cosine_1, cosine_2, cosine_3, near_0, omega_0, omega_1, omega_2, per_reach, sine_0, sine_1, sine_2, sine_3, tilted_0, tilted_1, tilted_2, tilted_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[141]), lanes_load(lists->fixed[139]));
            V omega_3 = _o364.omega_3;
            V around_3 = _o364.around_3;
            V cosine_4 = _o364.cosine_4;
            V sine_4 = _o364.sine_4;
            V climb_4 = _o364.climb_4;
            V along_4 = _o364.along_4;
            V turn_rate_4 = _o364.turn_rate_4;
            V tilted_4 = _o364.tilted_4;
            const LANES(court_ring_round_4_out) _o365 =
                LANES(court_ring_round_4)(along_4, around_0, around_1, around_2, around_3, climb_0, climb_1, climb_2, climb_3, climb_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, near_0, omega_0, omega_1, omega_2, omega_3, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[142]), lanes_load(lists->fixed[139]));
            V omega_4 = _o365.omega_4;
            V around_4 = _o365.around_4;
            V cosine_5 = _o365.cosine_5;
            V sine_5 = _o365.sine_5;
            V climb_5 = _o365.climb_5;
            V along_5 = _o365.along_5;
            V turn_rate_5 = _o365.turn_rate_5;
            V tilted_5 = _o365.tilted_5;
            const LANES(court_ring_round_5_out) _o366 =
                LANES(court_ring_round_5)(along_5, around_0, around_1, around_2, around_3, around_4, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[143]), lanes_load(lists->fixed[139]));
            V omega_5 = _o366.omega_5;
            V around_5 = _o366.around_5;
            V cosine_6 = _o366.cosine_6;
            V sine_6 = _o366.sine_6;
            V climb_6 = _o366.climb_6;
            V along_6 = _o366.along_6;
            V turn_rate_6 = _o366.turn_rate_6;
            V tilted_6 = _o366.tilted_6;
            const LANES(court_ring_round_6_out) _o367 =
                LANES(court_ring_round_6)(along_6, around_0, around_1, around_2, around_3, around_4, around_5, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[144]), lanes_load(lists->fixed[139]));
            V omega_6 = _o367.omega_6;
            V around_6 = _o367.around_6;
            V cosine_7 = _o367.cosine_7;
            V sine_7 = _o367.sine_7;
            V climb_7 = _o367.climb_7;
            V along_7 = _o367.along_7;
            V turn_rate_7 = _o367.turn_rate_7;
            V tilted_7 = _o367.tilted_7;
            const LANES(court_ring_round_7_out) _o368 =
                LANES(court_ring_round_7)(along_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[145]), lanes_load(lists->fixed[139]));
            V omega_7 = _o368.omega_7;
            V around_7 = _o368.around_7;
            V cosine_8 = _o368.cosine_8;
            V sine_8 = _o368.sine_8;
            V climb_8 = _o368.climb_8;
            V along_8 = _o368.along_8;
            V turn_rate_8 = _o368.turn_rate_8;
            V tilted_8 = _o368.tilted_8;
            const LANES(court_ring_round_8_out) _o369 =
                LANES(court_ring_round_8)(along_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[146]), lanes_load(lists->fixed[139]));
            V omega_8 = _o369.omega_8;
            V around_8 = _o369.around_8;
            V cosine_9 = _o369.cosine_9;
            V sine_9 = _o369.sine_9;
            V climb_9 = _o369.climb_9;
            V along_9 = _o369.along_9;
            V turn_rate_9 = _o369.turn_rate_9;
            V tilted_9 = _o369.tilted_9;
            const LANES(court_ring_round_9_out) _o370 =
                LANES(court_ring_round_9)(along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[147]), lanes_load(lists->fixed[139]));
            V omega_9 = _o370.omega_9;
            V around_9 = _o370.around_9;
            V cosine_10 = _o370.cosine_10;
            V sine_10 = _o370.sine_10;
            V climb_10 = _o370.climb_10;
            V along_10 = _o370.along_10;
            V turn_rate_10 = _o370.turn_rate_10;
            V tilted_10 = _o370.tilted_10;
            const LANES(court_ring_round_10_out) _o371 =
                LANES(court_ring_round_10)(along_10, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, climb_0, climb_1, climb_10, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cosine_0, cosine_1, cosine_10, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, per_reach, sine_0, sine_1, sine_10, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[148]), lanes_load(lists->fixed[139]));
            V omega_10 = _o371.omega_10;
            V around_10 = _o371.around_10;
            V cosine_11 = _o371.cosine_11;
            V sine_11 = _o371.sine_11;
            V climb_11 = _o371.climb_11;
            V along_11 = _o371.along_11;
            V turn_rate_11 = _o371.turn_rate_11;
            V tilted_11 = _o371.tilted_11;
            const LANES(court_ring_round_11_out) _o372 =
                LANES(court_ring_round_11)(along_11, around_0, around_1, around_10, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, climb_0, climb_1, climb_10, climb_11, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, omega_0, omega_1, omega_10, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, per_reach, sine_0, sine_1, sine_10, sine_11, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_11, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[149]), lanes_load(lists->fixed[139]));
            V omega_11 = _o372.omega_11;
            V cosine_12 = _o372.cosine_12;
            V sine_12 = _o372.sine_12;
            V climb_12 = _o372.climb_12;
            V along_12 = _o372.along_12;
            V turn_rate_12 = _o372.turn_rate_12;
            const LANES(court_ring_round_pace_out) _o373 =
                LANES(court_ring_round_pace)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cosine_0, cosine_12, omega_0, omega_1, omega_10, omega_11, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, per_reach, sin_0, sine_0, sine_12, turn_rate_0, turn_rate_11, turn_rate_12, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[150]), lanes_load(lists->fixed[151]), lanes_load(lists->fixed[152]), lanes_load(lists->fixed[153]));
            V stride = _o373.stride;
            V missed = _o373.missed;
            V strongest = _o373.strongest;
            V fastest = _o373.fastest;
            V sway = _o373.sway;
            V force = _o373.force;
            V force_rate = _o373.force_rate;
            V force_bend = _o373.force_bend;
            V brace = _o373.brace;
            V vx_1 = _o373.vx_1;
            V vy_1 = _o373.vy_1;
            V vz_1 = _o373.vz_1;
            const LANES(court_ring_round_pulled_out) _o374 =
                LANES(court_ring_round_pulled)(climb_0, climb_1, cosine_0, cosine_1, omega_0, omega_1, turn_rate_0, turn_rate_1, lanes_load(lists->fixed[21]));
            V drag = _o374.drag;
            V drag_rate = _o374.drag_rate;
            const LANES(court_ring_impact_strained_out) _o375 =
                LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, lanes_load(lists->fixed[154]));
            V strain = _o375.strain;
            V strain_rate = _o375.strain_rate;
            const LANES(court_losing_out) _o376 =
                LANES(court_losing)(grip_lost, strain);
            M loses = _o376.loses;
            const M _m377 = lanes_both(active, loses);
            if (lanes_any(_m377)) {
                const LANES(court_lost_grip_out) _o378 =
                    LANES(court_lost_grip)(clock, strain, strain_rate, taut, taut_clock, taut_rate);
                grip_lost = lanes_select(_m377, _o378.grip_lost, grip_lost);
            }
            const LANES(court_tightened_out) _o379 =
                LANES(court_tightened)(clock, strain, strain_rate);
            taut = _o379.taut;
            taut_rate = _o379.taut_rate;
            taut_clock = _o379.taut_clock;
            const LANES(court_leaving_force_out) _o380 =
                LANES(court_leaving_force)(brace, doubt, fastest, force, force_bend, force_rate, per_reach, position_error, stride, velocity_error, vx, vx_1, vy, vy_1, vz, vz_1, which, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[133]), lanes_load(lists->fixed[134]));
            stride = _o380.stride;
            which = _o380.which;
            M rests = _o380.rests;
            doubt = _o380.doubt;
            const LANES(court_backboard_beside_out) _o381 =
                LANES(court_backboard_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[15]));
            V gap = _o381.gap;
            V nearing = _o381.nearing;
            V dent = _o381.dent;
            const LANES(court_beside_body_out) _o382 =
                LANES(court_beside_body)(dent, doubt, fastest, gap, K(1.0), late, nearing, position_error, stride, strongest, which, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[113]));
            stride = _o382.stride;
            which = _o382.which;
            doubt = _o382.doubt;
            late = _o382.late;
            const LANES(court_bridge_beside_out) _o383 =
                LANES(court_bridge_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]));
            gap = _o383.gap;
            nearing = _o383.nearing;
            dent = _o383.dent;
            const LANES(court_beside_body_out) _o384 =
                LANES(court_beside_body)(dent, doubt, fastest, gap, K(2.0), late, nearing, position_error, stride, strongest, which, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[113]));
            stride = _o384.stride;
            which = _o384.which;
            doubt = _o384.doubt;
            late = _o384.late;
            const LANES(court_end_beside_out) _o385 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[18]));
            gap = _o385.gap;
            nearing = _o385.nearing;
            dent = _o385.dent;
            const LANES(court_beside_gate_out) _o386 =
                LANES(court_beside_gate)(dent, doubt, fastest, gap, K(3.0), late, nearing, position_error, stride, strongest, which, x, y, z, lanes_load(lists->fixed[6]));
            stride = _o386.stride;
            which = _o386.which;
            doubt = _o386.doubt;
            late = _o386.late;
            const LANES(court_beside_time_out) _o387 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o387.stride;
            which = _o387.which;
            const LANES(court_apart_out) _o388 =
                LANES(court_apart)(dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[137]), lanes_load(lists->fixed[138]));
            V apart = _o388.apart;
            const LANES(court_neighbour_out) _o389 =
                LANES(court_neighbour)(apart, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, vx, vy, vz, wx, wy, wz, x, y, z);
            V far_x = _o389.far_x;
            V far_y = _o389.far_y;
            V far_z = _o389.far_z;
            V far_vx = _o389.far_vx;
            V far_vy = _o389.far_vy;
            V far_vz = _o389.far_vz;
            V far_wx = _o389.far_wx;
            V far_wy = _o389.far_wy;
            V far_wz = _o389.far_wz;
            const LANES(court_passing_from_out) _o390 =
                LANES(court_passing_from)(z);
            M over = _o390.over;
            const LANES(court_alone_out) _o391 =
                LANES(court_alone)();
            V berth = _o391.nearest;
            const LANES(court_leaps_out) _o392 =
                LANES(court_leaps)(stride);
            V forth = _o392.forth;
            V back = _o392.back;
            const LANES(court_backboard_around_out) _o393 =
                LANES(court_backboard_around)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[155]));
            gap = _o393.gap;
            nearing = _o393.nearing;
            const LANES(court_cleared_out) _o394 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o394.berth;
            const LANES(court_bridge_around_out) _o395 =
                LANES(court_bridge_around)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[156]));
            gap = _o395.gap;
            nearing = _o395.nearing;
            const LANES(court_cleared_out) _o396 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o396.berth;
            const LANES(court_end_around_out) _o397 =
                LANES(court_end_around)(vz, z, lanes_load(lists->fixed[18]));
            gap = _o397.gap;
            nearing = _o397.nearing;
            const LANES(court_cleared_out) _o398 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o398.berth;
            const LANES(court_ring_round_moved_out) _o399 =
                LANES(court_ring_round_moved)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cosine_0, cosine_1, cosine_10, cosine_11, cosine_12, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, omega_0, omega_1, omega_10, omega_11, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, sin_0, sine_0, sine_1, sine_10, sine_11, sine_12, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, stride, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_12, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[112]));
            x = _o399.x;
            y = _o399.y;
            z = _o399.z;
            vx = _o399.vx;
            vy = _o399.vy;
            vz = _o399.vz;
            wx = _o399.wx;
            wy = _o399.wy;
            wz = _o399.wz;
            V climb = _o399.climb;
            const LANES(court_passing_in_contact_out) _o400 =
                LANES(court_passing_in_contact)(over, through, x, y, z, lanes_load(lists->fixed[19]));
            through = _o400.through;
            const LANES(court_backboard_around_out) _o401 =
                LANES(court_backboard_around)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[155]));
            gap = _o401.gap;
            nearing = _o401.nearing;
            const LANES(court_cleared_out) _o402 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o402.berth;
            const LANES(court_bridge_around_out) _o403 =
                LANES(court_bridge_around)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[156]));
            gap = _o403.gap;
            nearing = _o403.nearing;
            const LANES(court_cleared_out) _o404 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o404.berth;
            const LANES(court_end_around_out) _o405 =
                LANES(court_end_around)(vz, z, lanes_load(lists->fixed[18]));
            gap = _o405.gap;
            nearing = _o405.nearing;
            const LANES(court_cleared_out) _o406 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o406.berth;
            const LANES(court_ring_swung_out) _o407 =
                LANES(court_ring_swung)(berth, circled, climb, climb_0, doubt, fastest, force, force_bend, force_rate, position_error, stride, sway, velocity_error, which, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[157]), lanes_load(lists->fixed[158]), lanes_load(lists->fixed[129]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[159]));
            circled = _o407.circled;
            M endless = _o407.endless;
            doubt = _o407.doubt;
            const LANES(court_for_ever_out) _o408 =
                LANES(court_for_ever)(endless, which);
            which = _o408.which;
            const LANES(court_ring_round_start_out) _o409 =
                LANES(court_ring_round_start)(per_reach, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_x, far_y, far_z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[135]));
            cosine_0 = _o409.cosine_0;
            sine_0 = _o409.sine_0;
            climb_0 = _o409.climb_0;
            along_0 = _o409.along_0;
            turn_rate_0 = _o409.turn_rate_0;
            cos_0 = _o409.cos_0;
            sin_0 = _o409.sin_0;
            tilted_0 = _o409.tilted_0;
            near_0 = _o409.near_0;
            const LANES(court_ring_round_0_out) _o410 =
                LANES(court_ring_round_0)(along_0, climb_0, cosine_0, near_0, per_reach, sine_0, tilted_0, turn_rate_0, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[139]));
            omega_0 = _o410.omega_0;
            around_0 = _o410.around_0;
            cosine_1 = _o410.cosine_1;
            sine_1 = _o410.sine_1;
            climb_1 = _o410.climb_1;
            along_1 = _o410.along_1;
            turn_rate_1 = _o410.turn_rate_1;
            tilted_1 = _o410.tilted_1;
            const LANES(court_ring_round_1_out) _o411 =
                LANES(court_ring_round_1)(along_1, around_0, climb_0, climb_1, cosine_0, cosine_1, near_0, omega_0, per_reach, sine_0, sine_1, tilted_0, tilted_1, turn_rate_0, turn_rate_1, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[91]), lanes_load(lists->fixed[139]));
            omega_1 = _o411.omega_1;
            around_1 = _o411.around_1;
            cosine_2 = _o411.cosine_2;
            sine_2 = _o411.sine_2;
            climb_2 = _o411.climb_2;
            along_2 = _o411.along_2;
            turn_rate_2 = _o411.turn_rate_2;
            tilted_2 = _o411.tilted_2;
            const LANES(court_ring_round_2_out) _o412 =
                LANES(court_ring_round_2)(along_2, around_0, around_1, climb_0, climb_1, climb_2, cosine_0, cosine_1, cosine_2, near_0, omega_0, omega_1, per_reach, sine_0, sine_1, sine_2, tilted_0, tilted_1, tilted_2, turn_rate_0, turn_rate_1, turn_rate_2, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[140]), lanes_load(lists->fixed[139]));
            omega_2 = _o412.omega_2;
            around_2 = _o412.around_2;
            cosine_3 = _o412.cosine_3;
            sine_3 = _o412.sine_3;
            climb_3 = _o412.climb_3;
            along_3 = _o412.along_3;
            turn_rate_3 = _o412.turn_rate_3;
            tilted_3 = _o412.tilted_3;
            const LANES(court_ring_round_3_out) _o413 =
                LANES(court_ring_round_3)(along_3, around_0, around_1, around_2, climb_0, climb_1, climb_2, climb_3, cosine_0, cosine_1, cosine_2, cosine_3, near_0, omega_0, omega_1, omega_2, per_reach, sine_0, sine_1, sine_2, sine_3, tilted_0, tilted_1, tilted_2, tilted_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[141]), lanes_load(lists->fixed[139]));
            omega_3 = _o413.omega_3;
            around_3 = _o413.around_3;
            cosine_4 = _o413.cosine_4;
            sine_4 = _o413.sine_4;
            climb_4 = _o413.climb_4;
            along_4 = _o413.along_4;
            turn_rate_4 = _o413.turn_rate_4;
            tilted_4 = _o413.tilted_4;
            const LANES(court_ring_round_4_out) _o414 =
                LANES(court_ring_round_4)(along_4, around_0, around_1, around_2, around_3, climb_0, climb_1, climb_2, climb_3, climb_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, near_0, omega_0, omega_1, omega_2, omega_3, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[142]), lanes_load(lists->fixed[139]));
            omega_4 = _o414.omega_4;
            around_4 = _o414.around_4;
            cosine_5 = _o414.cosine_5;
            sine_5 = _o414.sine_5;
            climb_5 = _o414.climb_5;
            along_5 = _o414.along_5;
            turn_rate_5 = _o414.turn_rate_5;
            tilted_5 = _o414.tilted_5;
            const LANES(court_ring_round_5_out) _o415 =
                LANES(court_ring_round_5)(along_5, around_0, around_1, around_2, around_3, around_4, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[143]), lanes_load(lists->fixed[139]));
            omega_5 = _o415.omega_5;
            around_5 = _o415.around_5;
            cosine_6 = _o415.cosine_6;
            sine_6 = _o415.sine_6;
            climb_6 = _o415.climb_6;
            along_6 = _o415.along_6;
            turn_rate_6 = _o415.turn_rate_6;
            tilted_6 = _o415.tilted_6;
            const LANES(court_ring_round_6_out) _o416 =
                LANES(court_ring_round_6)(along_6, around_0, around_1, around_2, around_3, around_4, around_5, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[144]), lanes_load(lists->fixed[139]));
            omega_6 = _o416.omega_6;
            around_6 = _o416.around_6;
            cosine_7 = _o416.cosine_7;
            sine_7 = _o416.sine_7;
            climb_7 = _o416.climb_7;
            along_7 = _o416.along_7;
            turn_rate_7 = _o416.turn_rate_7;
            tilted_7 = _o416.tilted_7;
            const LANES(court_ring_round_7_out) _o417 =
                LANES(court_ring_round_7)(along_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[145]), lanes_load(lists->fixed[139]));
            omega_7 = _o417.omega_7;
            around_7 = _o417.around_7;
            cosine_8 = _o417.cosine_8;
            sine_8 = _o417.sine_8;
            climb_8 = _o417.climb_8;
            along_8 = _o417.along_8;
            turn_rate_8 = _o417.turn_rate_8;
            tilted_8 = _o417.tilted_8;
            const LANES(court_ring_round_8_out) _o418 =
                LANES(court_ring_round_8)(along_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[146]), lanes_load(lists->fixed[139]));
            omega_8 = _o418.omega_8;
            around_8 = _o418.around_8;
            cosine_9 = _o418.cosine_9;
            sine_9 = _o418.sine_9;
            climb_9 = _o418.climb_9;
            along_9 = _o418.along_9;
            turn_rate_9 = _o418.turn_rate_9;
            tilted_9 = _o418.tilted_9;
            const LANES(court_ring_round_9_out) _o419 =
                LANES(court_ring_round_9)(along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, per_reach, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[147]), lanes_load(lists->fixed[139]));
            omega_9 = _o419.omega_9;
            around_9 = _o419.around_9;
            cosine_10 = _o419.cosine_10;
            sine_10 = _o419.sine_10;
            climb_10 = _o419.climb_10;
            along_10 = _o419.along_10;
            turn_rate_10 = _o419.turn_rate_10;
            tilted_10 = _o419.tilted_10;
            const LANES(court_ring_round_10_out) _o420 =
                LANES(court_ring_round_10)(along_10, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, climb_0, climb_1, climb_10, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cosine_0, cosine_1, cosine_10, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, per_reach, sine_0, sine_1, sine_10, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[148]), lanes_load(lists->fixed[139]));
            omega_10 = _o420.omega_10;
            around_10 = _o420.around_10;
            cosine_11 = _o420.cosine_11;
            sine_11 = _o420.sine_11;
            climb_11 = _o420.climb_11;
            along_11 = _o420.along_11;
            turn_rate_11 = _o420.turn_rate_11;
            tilted_11 = _o420.tilted_11;
            const LANES(court_ring_round_11_out) _o421 =
                LANES(court_ring_round_11)(along_11, around_0, around_1, around_10, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, climb_0, climb_1, climb_10, climb_11, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, omega_0, omega_1, omega_10, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, per_reach, sine_0, sine_1, sine_10, sine_11, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_11, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[149]), lanes_load(lists->fixed[139]));
            omega_11 = _o421.omega_11;
            cosine_12 = _o421.cosine_12;
            sine_12 = _o421.sine_12;
            climb_12 = _o421.climb_12;
            along_12 = _o421.along_12;
            turn_rate_12 = _o421.turn_rate_12;
            const LANES(court_ring_round_moved_out) _o422 =
                LANES(court_ring_round_moved)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cosine_0, cosine_1, cosine_10, cosine_11, cosine_12, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, omega_0, omega_1, omega_10, omega_11, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, sin_0, sine_0, sine_1, sine_10, sine_11, sine_12, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, stride, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_12, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[135]), lanes_load(lists->fixed[112]));
            far_x = _o422.x;
            far_y = _o422.y;
            far_z = _o422.z;
            far_vx = _o422.vx;
            far_vy = _o422.vy;
            far_vz = _o422.vz;
            far_wx = _o422.wx;
            far_wy = _o422.wy;
            far_wz = _o422.wz;
            const LANES(court_compared_out) _o423 =
                LANES(court_compared)(apart, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_x, far_y, far_z, missed, stride, vx, vy, vz, wx, wy, wz, x, y, z, lanes_load(lists->fixed[6]));
            dx = _o423.dx;
            dy = _o423.dy;
            dz = _o423.dz;
            dvx = _o423.dvx;
            dvy = _o423.dvy;
            dvz = _o423.dvz;
            dwx = _o423.dwx;
            dwy = _o423.dwy;
            dwz = _o423.dwz;
            const LANES(court_rolled_on_out) _o424 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o424.clock;
            circling = _o424.rolling;
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
        const LANES(court_rejoined_out) _o425 =
            LANES(court_rejoined)(circling, rolling);
        rolling = _o425.rolling;
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
            lanes_pack(lists->kept_leaves_per_reach + kept_leaves_shots, packed, per_reach);
            lanes_pack(lists->kept_leaves_snap + kept_leaves_shots, packed, snap);
            lanes_pack(lists->kept_leaves_surge + kept_leaves_shots, packed, surge);
            lanes_pack(lists->kept_leaves_vx + kept_leaves_shots, packed, vx);
            lanes_pack(lists->kept_leaves_vy + kept_leaves_shots, packed, vy);
            lanes_pack(lists->kept_leaves_vz + kept_leaves_shots, packed, vz);
            lanes_pack(lists->kept_leaves_x + kept_leaves_shots, packed, x);
            lanes_pack(lists->kept_leaves_y + kept_leaves_shots, packed, y);
            lanes_pack(lists->kept_leaves_z + kept_leaves_shots, packed, z);
            if (LANES_SELDOM(varying)) {
                lanes_pack(lists->kept_leaves_p_ball_radius + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_ball_radius + i : lists->p_ball_radius));
                lanes_pack(lists->kept_leaves_p_board_bottom + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_board_bottom + i : lists->p_board_bottom));
                lanes_pack(lists->kept_leaves_p_board_distance + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_board_distance + i : lists->p_board_distance));
                lanes_pack(lists->kept_leaves_p_board_half_width + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_board_half_width + i : lists->p_board_half_width));
                lanes_pack(lists->kept_leaves_p_board_thickness + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_board_thickness + i : lists->p_board_thickness));
                lanes_pack(lists->kept_leaves_p_board_top + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_board_top + i : lists->p_board_top));
                lanes_pack(lists->kept_leaves_p_bridge_depth + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_bridge_depth + i : lists->p_bridge_depth));
                lanes_pack(lists->kept_leaves_p_bridge_half_width + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_bridge_half_width + i : lists->p_bridge_half_width));
                lanes_pack(lists->kept_leaves_p_end_depth + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_end_depth + i : lists->p_end_depth));
                lanes_pack(lists->kept_leaves_p_gravity + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_gravity + i : lists->p_gravity));
                lanes_pack(lists->kept_leaves_p_ring_radius + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_ring_radius + i : lists->p_ring_radius));
                lanes_pack(lists->kept_leaves_p_wire_radius + kept_leaves_shots, packed, lanes_load(varying ? lists->kept_p_wire_radius + i : lists->p_wire_radius));
            }
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
static void LANES(court_bounded_fix_f487)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->p_board_thickness + i);
    const V p_board_top = lanes_load(lists->p_board_top + i);
    const V p_bridge_depth = lanes_load(lists->p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + i);
    const V p_end_depth = lanes_load(lists->p_end_depth + i);
    const V p_gravity = lanes_load(lists->p_gravity + i);
    const V p_restitution_speed = lanes_load(lists->p_restitution_speed + i);
    const V p_ring_radius = lanes_load(lists->p_ring_radius + i);
    const V p_tangential_restitution = lanes_load(lists->p_tangential_restitution + i);
    const V p_wire_radius = lanes_load(lists->p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_div(K(1.0), p_gravity);
        const V _s2 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(p_ball_radius, p_board_distance), p_board_half_width), p_board_thickness), p_bridge_depth), p_bridge_half_width), p_end_depth);
        const V _s3 = lanes_sub(lanes_sub(p_ring_radius, p_ball_radius), p_wire_radius);
        const V _s4 = lanes_add(K(0.4), lanes_mul(K(0.4), p_tangential_restitution));
        lanes_store(lists->fixed[6], p_ball_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[19], lanes_mul(p_ring_radius, p_ring_radius));
        lanes_store(lists->fixed[20], _s1);
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[22], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[33], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[36], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[111], lanes_div(K(1.0), _s0));
        lanes_store(lists->fixed[112], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[164], lanes_mul(K(8.0), _s1));
        lanes_store(lists->fixed[165], lanes_add(lanes_add(lanes_add(lanes_add(_s2, p_ring_radius), p_wire_radius), lanes_abs(p_board_bottom)), lanes_abs(p_board_top)));
        lanes_store(lists->fixed[166], lanes_div(K(1.0), lanes_min(_s3, _s0)));
        lanes_store(lists->fixed[167], p_restitution_speed);
        lanes_store(lists->fixed[168], _s4);
        lanes_store(lists->fixed[169], lanes_mul(_s4, _s4));
        lanes_store(lists->fixed[170], lanes_mul(K(7.275957614183426e-12), p_ball_radius));
        lanes_store(lists->fixed[171], lanes_mul(K(1.1920928955078125e-07), p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f572)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_backboard_friction = lanes_load(lists->slow_p_backboard_friction + i);
    const V p_backboard_restitution = lanes_load(lists->slow_p_backboard_restitution + i);
    const V p_ball_radius = lanes_load(lists->slow_p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->slow_p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->slow_p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->slow_p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->slow_p_board_thickness + i);
    const V p_board_top = lanes_load(lists->slow_p_board_top + i);
    const V p_bridge_depth = lanes_load(lists->slow_p_bridge_depth + i);
    const V p_bridge_friction = lanes_load(lists->slow_p_bridge_friction + i);
    const V p_bridge_half_width = lanes_load(lists->slow_p_bridge_half_width + i);
    const V p_bridge_restitution = lanes_load(lists->slow_p_bridge_restitution + i);
    const V p_end_depth = lanes_load(lists->slow_p_end_depth + i);
    const V p_gravity = lanes_load(lists->slow_p_gravity + i);
    const V p_ring_friction = lanes_load(lists->slow_p_ring_friction + i);
    const V p_ring_radius = lanes_load(lists->slow_p_ring_radius + i);
    const V p_ring_restitution = lanes_load(lists->slow_p_ring_restitution + i);
    const V p_wire_radius = lanes_load(lists->slow_p_wire_radius + i);
    {
        const V _s0 = lanes_sub(K(1.0), p_ring_restitution);
        const V _s1 = lanes_add(K(1.0), p_ring_restitution);
        const V _s2 = lanes_sub(K(1.0), p_backboard_restitution);
        const V _s3 = lanes_add(K(1.0), p_backboard_restitution);
        const V _s4 = lanes_sub(K(1.0), p_bridge_restitution);
        const V _s5 = lanes_add(K(1.0), p_bridge_restitution);
        lanes_store(lists->fixed[6], p_ball_radius);
        lanes_store(lists->fixed[7], p_ring_radius);
        lanes_store(lists->fixed[8], p_wire_radius);
        lanes_store(lists->fixed[9], p_board_distance);
        lanes_store(lists->fixed[10], p_board_half_width);
        lanes_store(lists->fixed[11], p_board_bottom);
        lanes_store(lists->fixed[12], p_board_top);
        lanes_store(lists->fixed[13], p_bridge_half_width);
        lanes_store(lists->fixed[15], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[18], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[23], lanes_neg(p_gravity));
        lanes_store(lists->fixed[111], lanes_div(K(1.0), lanes_add(p_ball_radius, p_wire_radius)));
        lanes_store(lists->fixed[112], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[113], lanes_mul(K(3.637978807091713e-12), p_ball_radius));
        lanes_store(lists->fixed[130], lanes_mul(K(0.4), p_gravity));
        lanes_store(lists->fixed[160], lanes_mul(K(3.0), p_gravity));
        lanes_store(lists->fixed[161], lanes_mul(K(2.0), lanes_mul(K(3.0), lanes_mul(p_gravity, p_gravity))));
        lanes_store(lists->fixed[170], lanes_mul(K(7.275957614183426e-12), p_ball_radius));
        lanes_store(lists->fixed[172], lanes_mul(K(0.4), p_ball_radius));
        lanes_store(lists->fixed[173], _s0);
        lanes_store(lists->fixed[174], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[175], lanes_mul(p_ring_friction, _s1));
        lanes_store(lists->fixed[176], lanes_mul(_s1, _s0));
        lanes_store(lists->fixed[177], lanes_mul(K(3.725290298461914e-09), p_ball_radius));
        lanes_store(lists->fixed[178], _s2);
        lanes_store(lists->fixed[179], lanes_mul(_s2, _s2));
        lanes_store(lists->fixed[180], lanes_mul(p_backboard_friction, _s3));
        lanes_store(lists->fixed[181], lanes_mul(_s3, _s2));
        lanes_store(lists->fixed[182], _s4);
        lanes_store(lists->fixed[183], lanes_mul(_s4, _s4));
        lanes_store(lists->fixed[184], lanes_mul(p_bridge_friction, _s5));
        lanes_store(lists->fixed[185], lanes_mul(_s5, _s4));
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
        if (LANES_SELDOM(varying))
            LANES(court_bounded_fix_f572)(lists, i);
        V assured = lanes_load(lists->slow_assured + i);
        V held = lanes_load(lists->slow_held + i);
        V mode = lanes_load(lists->slow_mode + i);
        V outcome = lanes_load(lists->slow_outcome + i);
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
        const LANES(court_ring_normal_out) _o573 =
            LANES(court_ring_normal)(x, y, z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[111]));
        V nx = _o573.nx;
        V ny = _o573.ny;
        V nz = _o573.nz;
        const LANES(court_here_out) _o574 =
            LANES(court_here)(K(1.0), which);
        M here = _o574.here;
        const M _m575 = lanes_both(rows, here);
        {
            const LANES(court_backboard_normal_out) _o576 =
                LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[15]));
            nx = lanes_select(_m575, _o576.nx, nx);
            ny = lanes_select(_m575, _o576.ny, ny);
            nz = lanes_select(_m575, _o576.nz, nz);
        }
        const LANES(court_here_out) _o577 =
            LANES(court_here)(K(2.0), which);
        here = _o577.here;
        const M _m578 = lanes_both(rows, here);
        {
            const LANES(court_bridge_normal_out) _o579 =
                LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[16]));
            nx = lanes_select(_m578, _o579.nx, nx);
            ny = lanes_select(_m578, _o579.ny, ny);
            nz = lanes_select(_m578, _o579.nz, nz);
        }
        const LANES(court_nearly_out) _o580 =
            LANES(court_nearly)(nx, ny, nz, vx, vy, vz, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[170]));
        M nearly = _o580.nearly;
        const LANES(court_gripped_out) _o581 =
            LANES(court_gripped)(nx, ny, nz, vx, vy, vz, wx, wy, wz, lanes_load(lists->fixed[6]));
        V rolled_x = _o581.rolled_x;
        V rolled_y = _o581.rolled_y;
        V rolled_z = _o581.rolled_z;
        V slip = _o581.slip;
        V bounce = _o581.bounce;
        const LANES(court_here_out) _o582 =
            LANES(court_here)(K(0.0), which);
        here = _o582.here;
        const M _m583 = lanes_both(rows, here);
        if (lanes_any(_m583)) {
            const LANES(court_ring_turning_out) _o584 =
                LANES(court_ring_turning)(rolled_x, rolled_y, rolled_z, x, y, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[111]));
            V turning_x = _o584.turning_x;
            V turning_y = _o584.turning_y;
            V turning_z = _o584.turning_z;
            const LANES(court_pressed_on_out) _o585 =
                LANES(court_pressed_on)(nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[172]), lanes_load(lists->fixed[130]));
            V press = _o585.press;
            V weight = _o585.weight;
            V drag = _o585.drag;
            V thrust_x = _o585.thrust_x;
            V thrust_y = _o585.thrust_y;
            V thrust_z = _o585.thrust_z;
            const LANES(court_alone_out) _o586 =
                LANES(court_alone)();
            V nearest = _o586.nearest;
            V wedge = _o586.wedge;
            const LANES(court_backboard_closing_out) _o587 =
                LANES(court_backboard_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[15]));
            V gap = _o587.gap;
            V nearing = _o587.nearing;
            V swerve = _o587.swerve;
            V facing = _o587.facing;
            const LANES(court_neared_body_out) _o588 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o588.nearest;
            wedge = _o588.wedge;
            const LANES(court_bridge_closing_out) _o589 =
                LANES(court_bridge_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]));
            gap = _o589.gap;
            nearing = _o589.nearing;
            swerve = _o589.swerve;
            facing = _o589.facing;
            const LANES(court_neared_body_out) _o590 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o590.nearest;
            wedge = _o590.wedge;
            const LANES(court_end_beside_out) _o591 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[18]));
            gap = _o591.gap;
            const LANES(court_neared_out) _o592 =
                LANES(court_neared)(gap, nearest);
            nearest = _o592.nearest;
            const LANES(court_ring_parting_out) _o593 =
                LANES(court_ring_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[160]), lanes_load(lists->fixed[161]));
            V lift = _o593.lift;
            const LANES(court_ring_impact_settling_out) _o594 =
                LANES(court_ring_impact_settling)(bounce, drag, lift, nearest, press, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[173]), lanes_load(lists->fixed[174]), lanes_load(lists->fixed[175]), lanes_load(lists->fixed[176]), lanes_load(lists->fixed[113]), lanes_load(lists->fixed[177]));
            M settles = _o594.settles;
            M lodges = _o594.lodges;
            M slides = _o594.slides;
            M parts = _o594.parts;
            assured = lanes_select(_m583, _o594.assured, assured);
            M unsure = _o594.unsure;
            const LANES(court_settled_out) _o595 =
                LANES(court_settled)(K(0.0), lodges, nearly, outcome, parts, settles, slides, uncertain, unsure);
            mode = lanes_select(_m583, _o595.mode, mode);
            held = lanes_select(_m583, _o595.held, held);
            outcome = lanes_select(_m583, _o595.outcome, outcome);
            slip_left = lanes_select(_m583, _o595.slip_left, slip_left);
            uncertain = lanes_select(_m583, _o595.uncertain, uncertain);
        }
        const LANES(court_here_out) _o596 =
            LANES(court_here)(K(1.0), which);
        here = _o596.here;
        const M _m597 = lanes_both(rows, here);
        if (lanes_any(_m597)) {
            const LANES(court_backboard_turning_out) _o598 =
                LANES(court_backboard_turning)(rolled_x, rolled_y, rolled_z, x, y, z, lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[15]));
            V turning_x = _o598.turning_x;
            V turning_y = _o598.turning_y;
            V turning_z = _o598.turning_z;
            const LANES(court_pressed_on_out) _o599 =
                LANES(court_pressed_on)(nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[172]), lanes_load(lists->fixed[130]));
            V press = _o599.press;
            V weight = _o599.weight;
            V drag = _o599.drag;
            V thrust_x = _o599.thrust_x;
            V thrust_y = _o599.thrust_y;
            V thrust_z = _o599.thrust_z;
            const LANES(court_alone_out) _o600 =
                LANES(court_alone)();
            V nearest = _o600.nearest;
            V wedge = _o600.wedge;
            const LANES(court_ring_closing_out) _o601 =
                LANES(court_ring_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]));
            V gap = _o601.gap;
            V nearing = _o601.nearing;
            V swerve = _o601.swerve;
            V facing = _o601.facing;
            const LANES(court_neared_body_out) _o602 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o602.nearest;
            wedge = _o602.wedge;
            const LANES(court_bridge_closing_out) _o603 =
                LANES(court_bridge_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]));
            gap = _o603.gap;
            nearing = _o603.nearing;
            swerve = _o603.swerve;
            facing = _o603.facing;
            const LANES(court_neared_body_out) _o604 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o604.nearest;
            wedge = _o604.wedge;
            const LANES(court_end_beside_out) _o605 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[18]));
            gap = _o605.gap;
            const LANES(court_neared_out) _o606 =
                LANES(court_neared)(gap, nearest);
            nearest = _o606.nearest;
            const LANES(court_backboard_parting_out) _o607 =
                LANES(court_backboard_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[23]));
            V lift = _o607.lift;
            const LANES(court_ring_impact_settling_out) _o608 =
                LANES(court_ring_impact_settling)(bounce, drag, lift, nearest, press, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[178]), lanes_load(lists->fixed[179]), lanes_load(lists->fixed[180]), lanes_load(lists->fixed[181]), lanes_load(lists->fixed[113]), lanes_load(lists->fixed[177]));
            M settles = _o608.settles;
            M lodges = _o608.lodges;
            M slides = _o608.slides;
            M parts = _o608.parts;
            assured = lanes_select(_m597, _o608.assured, assured);
            M unsure = _o608.unsure;
            const LANES(court_settled_out) _o609 =
                LANES(court_settled)(K(1.0), lodges, nearly, outcome, parts, settles, slides, uncertain, unsure);
            mode = lanes_select(_m597, _o609.mode, mode);
            held = lanes_select(_m597, _o609.held, held);
            outcome = lanes_select(_m597, _o609.outcome, outcome);
            slip_left = lanes_select(_m597, _o609.slip_left, slip_left);
            uncertain = lanes_select(_m597, _o609.uncertain, uncertain);
        }
        const LANES(court_here_out) _o610 =
            LANES(court_here)(K(2.0), which);
        here = _o610.here;
        const M _m611 = lanes_both(rows, here);
        if (lanes_any(_m611)) {
            const LANES(court_bridge_turning_out) _o612 =
                LANES(court_bridge_turning)(rolled_x, rolled_y, rolled_z, x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[16]));
            V turning_x = _o612.turning_x;
            V turning_y = _o612.turning_y;
            V turning_z = _o612.turning_z;
            const LANES(court_pressed_on_out) _o613 =
                LANES(court_pressed_on)(nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[172]), lanes_load(lists->fixed[130]));
            V press = _o613.press;
            V weight = _o613.weight;
            V drag = _o613.drag;
            V thrust_x = _o613.thrust_x;
            V thrust_y = _o613.thrust_y;
            V thrust_z = _o613.thrust_z;
            const LANES(court_alone_out) _o614 =
                LANES(court_alone)();
            V nearest = _o614.nearest;
            V wedge = _o614.wedge;
            const LANES(court_ring_closing_out) _o615 =
                LANES(court_ring_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]));
            V gap = _o615.gap;
            V nearing = _o615.nearing;
            V swerve = _o615.swerve;
            V facing = _o615.facing;
            const LANES(court_neared_body_out) _o616 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o616.nearest;
            wedge = _o616.wedge;
            const LANES(court_backboard_closing_out) _o617 =
                LANES(court_backboard_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[15]));
            gap = _o617.gap;
            nearing = _o617.nearing;
            swerve = _o617.swerve;
            facing = _o617.facing;
            const LANES(court_neared_body_out) _o618 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o618.nearest;
            wedge = _o618.wedge;
            const LANES(court_end_beside_out) _o619 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[18]));
            gap = _o619.gap;
            const LANES(court_neared_out) _o620 =
                LANES(court_neared)(gap, nearest);
            nearest = _o620.nearest;
            const LANES(court_bridge_parting_out) _o621 =
                LANES(court_bridge_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[23]));
            V lift = _o621.lift;
            const LANES(court_ring_impact_settling_out) _o622 =
                LANES(court_ring_impact_settling)(bounce, drag, lift, nearest, press, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[182]), lanes_load(lists->fixed[183]), lanes_load(lists->fixed[184]), lanes_load(lists->fixed[185]), lanes_load(lists->fixed[113]), lanes_load(lists->fixed[177]));
            M settles = _o622.settles;
            M lodges = _o622.lodges;
            M slides = _o622.slides;
            M parts = _o622.parts;
            assured = lanes_select(_m611, _o622.assured, assured);
            M unsure = _o622.unsure;
            const LANES(court_settled_out) _o623 =
                LANES(court_settled)(K(2.0), lodges, nearly, outcome, parts, settles, slides, uncertain, unsure);
            mode = lanes_select(_m611, _o623.mode, mode);
            held = lanes_select(_m611, _o623.held, held);
            outcome = lanes_select(_m611, _o623.outcome, outcome);
            slip_left = lanes_select(_m611, _o623.slip_left, slip_left);
            uncertain = lanes_select(_m611, _o623.uncertain, uncertain);
        }
        lanes_store(lists->slow_assured + i, assured);
        lanes_store(lists->slow_held + i, held);
        lanes_store(lists->slow_mode + i, mode);
        lanes_store(lists->slow_outcome + i, outcome);
        lanes_store(lists->slow_slip_left + i, slip_left);
        lanes_store(lists->slow_uncertain + i, uncertain);
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f624)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_gravity = lanes_load(lists->p_gravity + i);
    {
        lanes_store(lists->fixed[21], p_gravity);
        lanes_store(lists->fixed[53], lanes_abs(K(0.0)));
    }
}

/* Run the job: fill the rows, take every shot to its next event, make room of those that ended.
   Errors are bounded. */
static void LANES(court_bounded)(const court_job *job, LANES(court_bounded_lists) *const restrict lists)
{
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
    LANES(court_bounded_permitted)(lists, 0);
    LANES(court_bounded_fix)(lists);
    for (;;) {
        if (stopped(job))
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
            const M rows = lanes_first(shots - i);
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f1)(lists, i);
            V last = lanes_load(lists->last + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V wx = lanes_load(lists->wx + i);
            V wy = lanes_load(lists->wy + i);
            V wz = lanes_load(lists->wz + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            M permitted = lanes_less(K(0.0), lanes_load(lists->permitted + (i & varying)));
            const LANES(court_finite_state_out) _o2 =
                LANES(court_finite_state)(vx, vy, vz, wx, wy, wz, x, y, z);
            M finite = _o2.finite;
            const LANES(court_aside_out) _o3 =
                LANES(court_aside)(x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]));
            M close = _o3.close;
            V valid = _o3.valid;
            V doubt = _o3.doubt;
            const M _m4 = lanes_both(rows, close);
            if (lanes_any(_m4)) {
                const LANES(court_valid_out) _o5 =
                    LANES(court_valid)(last, x, y, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[14]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[0]));
                valid = lanes_select(_m4, _o5.valid, valid);
                doubt = lanes_select(_m4, _o5.doubt, doubt);
            }
            const LANES(court_admitted_out) _o6 =
                LANES(court_admitted)(doubt, finite, permitted, valid);
            V outcome = _o6.outcome;
            V uncertain = _o6.uncertain;
            const LANES(court_passing_start_out) _o7 =
                LANES(court_passing_start)(last, outcome, uncertain, x, y, z, lanes_load(lists->fixed[18]), lanes_load(lists->fixed[19]));
            V through = _o7.through;
            uncertain = _o7.uncertain;
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
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f8)(lists, i);
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
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const LANES(court_error_bounds_out) _o9 =
                LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            V position_error = _o9.position_error;
            V velocity_error = _o9.velocity_error;
            V time_error = _o9.time_error;
            const LANES(court_scale_out) _o10 =
                LANES(court_scale)(x, y, z, vx, vy, vz, lanes_load(lists->fixed[20]));
            V extent = _o10.extent;
            V speed = _o10.speed;
            V excess = _o10.excess;
            const LANES(court_opening_out) _o11 =
                LANES(court_opening)(excess, position_error, velocity_error);
            V when = _o11.when;
            V which = _o11.which;
            V late = _o11.late;
            V doubt = _o11.doubt;
            const LANES(court_limited_out) _o12 =
                LANES(court_limited)(time_limit);
            M limited = _o12.limited;
            const LANES(court_kept_out) _o13 =
                LANES(court_kept)(mode, when);
            M kept = _o13.kept;
            when = _o13.when;
            M rests = _o13.rests;
            M rolling = _o13.rolling;
            V began = _o13.began;
            const LANES(court_left_out) _o14 =
                LANES(court_left)(K(3.0), last);
            V leaving = _o14.leaving;
            const LANES(court_end_arrival_out) _o15 =
                LANES(court_end_arrival)(leaving, z, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[18]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[23]), lanes_load(lists->fixed[24]), lanes_load(lists->fixed[25]));
            V time = _o15.time;
            V rate = _o15.rate;
            V bend = _o15.bend;
            V apex = _o15.apex;
            V height = _o15.height;
            const LANES(court_meeting_plane_out) _o16 =
                LANES(court_meeting_plane)(apex, bend, rate, time);
            M arrives = _o16.arrives;
            V ceiling = _o16.ceiling;
            V nearest = _o16.nearest;
            const LANES(court_end_margin_out) _o17 =
                LANES(court_end_margin)(nearest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[26]));
            V margin = _o17.margin;
            const LANES(court_crossing_out) _o18 =
                LANES(court_crossing)(margin, K(0.0), rate, ceiling);
            V clearance = _o18.clearance;
            V delay = _o18.delay;
            const LANES(court_timely_out) _o19 =
                LANES(court_timely)(arrives, delay, late, time, when);
            M possible = _o19.possible;
            const LANES(court_grazed_out) _o20 =
                LANES(court_grazed)(apex, doubt, height, margin);
            doubt = _o20.doubt;
            const M _m21 = lanes_both(rows, possible);
            {
                const LANES(court_crossed_out) _o22 =
                    LANES(court_crossed)(arrives, clearance, doubt, time);
                doubt = lanes_select(_m21, _o22.doubt, doubt);
                const LANES(court_tied_out) _o23 =
                    LANES(court_tied)(arrives, delay, doubt, late, time, when);
                doubt = lanes_select(_m21, _o23.doubt, doubt);
                late = lanes_select(_m21, _o23.late, late);
                const LANES(court_sooner_out) _o24 =
                    LANES(court_sooner)(arrives, K(3.0), time, when, which);
                when = lanes_select(_m21, _o24.when, when);
                which = lanes_select(_m21, _o24.which, which);
            }
            const LANES(court_horizon_out) _o25 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[20]));
            V until = _o25.horizon;
            V pad = _o25.pad;
            const LANES(court_ring_clear_out) _o26 =
                LANES(court_ring_clear)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[27]), lanes_load(lists->fixed[28]), lanes_load(lists->fixed[29]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[20]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[14]), lanes_load(lists->fixed[34]), lanes_load(lists->fixed[35]), lanes_load(lists->fixed[36]), lanes_load(lists->fixed[37]), lanes_load(lists->fixed[38]), lanes_load(lists->fixed[39]), lanes_load(lists->fixed[40]), lanes_load(lists->fixed[41]));
            V clear = _o26.clear;
            const LANES(court_opens_in_flight_out) _o27 =
                LANES(court_opens_in_flight)(clear, kept);
            M open = _o27.open;
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->open_p_ball_radius + open_shots, packed, lanes_load(lists->p_ball_radius + (i & varying)));
                    lanes_pack(lists->open_p_gravity + open_shots, packed, lanes_load(lists->p_gravity + (i & varying)));
                    lanes_pack(lists->open_p_ring_radius + open_shots, packed, lanes_load(lists->p_ring_radius + (i & varying)));
                    lanes_pack(lists->open_p_wire_radius + open_shots, packed, lanes_load(lists->p_wire_radius + (i & varying)));
                }
                open_shots += lanes_many(packed);
            }
        }
        {
        size_t open_leaping_shots = 0;
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_shots - i);
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f28)(lists, i);
            V doubt = lanes_load(lists->open_doubt + i);
            V extent = lanes_load(lists->open_extent + i);
            V last = lanes_load(lists->open_last + i);
            V late = lanes_load(lists->open_late + i);
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
            const LANES(court_beginning_out) _o29 =
                LANES(court_beginning)();
            V share = _o29.share;
            V arrival = _o29.arrival;
            M certain = _o29.certain;
            const LANES(court_left_out) _o30 =
                LANES(court_left)(K(0.0), last);
            V leaving = _o30.leaving;
            const LANES(court_ring_opened_out) _o31 =
                LANES(court_ring_opened)(lanes_narrow(until), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(extent), lanes_narrow(speed), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[2]), singles_load(lists->fixed_single[3]), singles_load(lists->fixed_single[4]), singles_load(lists->fixed_single[5]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[7]), singles_load(lists->fixed_single[8]), singles_load(lists->fixed_single[9]));
            S onset = _o31.t;
            S wide_end = _o31.end;
            M searching = _o31.searching;
            S wide_low1 = _o31.low1;
            S wide_high1 = _o31.high1;
            S wide_low2 = _o31.low2;
            S wide_high2 = _o31.high2;
            S lapsed = _o31.latest;
            M sound = _o31.sound;
            const LANES(court_opened_out) _o32 =
                LANES(court_opened)(lanes_wide(lapsed), lanes_wide(onset));
            V since = _o32.time;
            V latest = _o32.latest;
            const LANES(court_ring_started_out) _o33 =
                LANES(court_ring_started)(x, y, z, vx, vy, vz, lanes_load(lists->fixed[7]));
            V rho_start = _o33.rho_start;
            V parting = _o33.parting;
            V drift = _o33.drift;
            const LANES(court_flight_out) _o34 =
                LANES(court_flight)(since, x, y, z, vx, vy, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[33]));
            V near_x = _o34.x;
            V near_y = _o34.y;
            V near_z = _o34.z;
            V near_vz = _o34.vz;
            const LANES(court_ring_grain_out) _o35 =
                LANES(court_ring_grain)(onset, wide_end, lanes_narrow(leaving), lapsed, lanes_narrow(near_x), lanes_narrow(near_y), lanes_narrow(near_z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(near_vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(parting), lanes_narrow(drift), wide_low1, wide_high1, wide_low2, wide_high2, singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[10]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[11]), singles_load(lists->fixed_single[12]), singles_load(lists->fixed_single[13]), singles_load(lists->fixed_single[14]), singles_load(lists->fixed_single[15]), singles_load(lists->fixed_single[4]), singles_load(lists->fixed_single[16]), singles_load(lists->fixed_single[17]), singles_load(lists->fixed_single[18]));
            S short_share = _o35.share;
            S short_t = _o35.t;
            S short_end = _o35.end;
            S short_x = _o35.x;
            S short_y = _o35.y;
            S short_z = _o35.z;
            S short_vx = _o35.vx;
            S short_vy = _o35.vy;
            S short_vz = _o35.vz;
            S short_steady = _o35.steady;
            S short_swing = _o35.swing;
            S short_rho_start = _o35.rho_start;
            S short_ceiling = _o35.ceiling;
            S short_flat = _o35.flat;
            S short_tilt = _o35.tilt;
            S short_jerk = _o35.jerk;
            S short_grit = _o35.grit;
            S short_parting = _o35.parting;
            S short_drift = _o35.drift;
            S short_rate_margin = _o35.rate_margin;
            S short_low1 = _o35.low1;
            S short_high1 = _o35.high1;
            S short_low2 = _o35.low2;
            S short_high2 = _o35.high2;
            M fits = _o35.fits;
            const LANES(court_coarse_out) _o36 =
                LANES(court_coarse)(lanes_wide(short_ceiling), fits, lanes_wide(short_flat), lanes_wide(short_rate_margin), searching, lanes_wide(short_share), sound);
            M leaping = _o36.leaping;
            searching = _o36.searching;
            M served = _o36.served;
            V ceiling = _o36.ceiling;
            V flat = _o36.flat;
            V tilt = _o36.tilt;
            V allowing = _o36.allowing;
            const LANES(court_allowance_out) _o37 =
                LANES(court_allowance)(allowing, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[21]));
            V excess = _o37.excess;
            const LANES(court_ring_lost_out) _o38 =
                LANES(court_ring_lost)(until, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[27]), lanes_load(lists->fixed[42]), lanes_load(lists->fixed[20]), lanes_load(lists->fixed[43]), lanes_load(lists->fixed[44]), lanes_load(lists->fixed[28]), lanes_load(lists->fixed[29]));
            V lost = _o38.lost;
            const LANES(court_beyond_out) _o39 =
                LANES(court_beyond)(doubt, excess, late, lost, pad);
            doubt = _o39.doubt;
            const M _m40 = lanes_both(rows, leaping);
            if (lanes_any(_m40)) {
                const LANES(court_ring_leap_out) _o41 =
                    LANES(court_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, singles_load(lists->fixed_single[19]), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[20]), singles_load(lists->fixed_single[21]), singles_load(lists->fixed_single[22]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[23]), singles_load(lists->fixed_single[24]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[25]));
                short_t = singles_select(singles_of(_m40), _o41.t, short_t);
                short_end = singles_select(singles_of(_m40), _o41.end, short_end);
                certain = lanes_choose(_m40, _o41.certain, certain);
                leaping = lanes_choose(_m40, _o41.leaping, leaping);
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->open_leaping_p_ball_radius + open_leaping_shots, packed, lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius));
                    lanes_pack(lists->open_leaping_p_gravity + open_leaping_shots, packed, lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity));
                    lanes_pack(lists->open_leaping_p_ring_radius + open_leaping_shots, packed, lanes_load(varying ? lists->open_p_ring_radius + i : lists->p_ring_radius));
                    lanes_pack(lists->open_leaping_p_wire_radius + open_leaping_shots, packed, lanes_load(varying ? lists->open_p_wire_radius + i : lists->p_wire_radius));
                }
                open_leaping_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
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
                    if (LANES_SELDOM(varying))
                        LANES(court_bounded_fix_f42)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_leaping_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M leaping = active;
                const LANES(court_ring_leap_out) _o43 =
                    LANES(court_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, singles_load(lists->fixed_single[19]), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[20]), singles_load(lists->fixed_single[21]), singles_load(lists->fixed_single[22]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[23]), singles_load(lists->fixed_single[24]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[25]));
                short_t = _o43.t;
                short_end = _o43.end;
                M certain = _o43.certain;
                leaping = _o43.leaping;
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
            const LANES(court_leapt_out) _o44 =
                LANES(court_leapt)(arrival, certain, lanes_wide(short_t), searching, served, since);
            arrival = _o44.arrival;
            V t = _o44.t;
            searching = _o44.searching;
            lanes_store(lists->open_arrival + i, arrival);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_searching_row + open_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_searching_arrival + open_searching_shots, packed, arrival);
                lanes_pack(lists->open_searching_certain + open_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->open_searching_doubt + open_searching_shots, packed, doubt);
                lanes_pack(lists->open_searching_extent + open_searching_shots, packed, extent);
                lanes_pack(lists->open_searching_last + open_searching_shots, packed, last);
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->open_searching_p_ball_radius + open_searching_shots, packed, lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius));
                    lanes_pack(lists->open_searching_p_gravity + open_searching_shots, packed, lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity));
                    lanes_pack(lists->open_searching_p_ring_radius + open_searching_shots, packed, lanes_load(varying ? lists->open_p_ring_radius + i : lists->p_ring_radius));
                    lanes_pack(lists->open_searching_p_wire_radius + open_searching_shots, packed, lanes_load(varying ? lists->open_p_wire_radius + i : lists->p_wire_radius));
                }
                open_searching_shots += lanes_many(packed);
            }
        }
        {
        size_t open_searching_searching_shots = 0;
        for (size_t i = 0; i < open_searching_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_searching_shots - i);
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f45)(lists, i);
            V arrival = lanes_load(lists->open_searching_arrival + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_searching_certain + i));
            V doubt = lanes_load(lists->open_searching_doubt + i);
            V extent = lanes_load(lists->open_searching_extent + i);
            V last = lanes_load(lists->open_searching_last + i);
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
            const LANES(court_ring_prepare_out) _o46 =
                LANES(court_ring_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[36]), lanes_load(lists->fixed[40]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[20]), lanes_load(lists->fixed[34]), lanes_load(lists->fixed[38]), lanes_load(lists->fixed[37]), lanes_load(lists->fixed[45]), lanes_load(lists->fixed[27]), lanes_load(lists->fixed[42]), lanes_load(lists->fixed[43]), lanes_load(lists->fixed[44]), lanes_load(lists->fixed[28]), lanes_load(lists->fixed[29]));
            V steady = _o46.steady;
            V swing = _o46.swing;
            V rho_start = _o46.rho_start;
            V low0 = _o46.low0;
            V high0 = _o46.high0;
            V low1 = _o46.low1;
            V high1 = _o46.high1;
            V low2 = _o46.low2;
            V high2 = _o46.high2;
            V ceiling = _o46.ceiling;
            V latest = _o46.latest;
            const LANES(court_allowance_out) _o47 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[21]));
            V position_level = _o47.position_level;
            V velocity_level = _o47.velocity_level;
            const LANES(court_ring_margins_out) _o48 =
                LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[46]), lanes_load(lists->fixed[47]), lanes_load(lists->fixed[48]), lanes_load(lists->fixed[49]));
            V flat = _o48.margin;
            V tilt = _o48.leaving_margin;
            V rate_slack = _o48.rate_margin;
            const LANES(court_ring_enter_out) _o49 =
                LANES(court_ring_enter)(t, K(0.0), high0, high1, high2, low0, low1, low2, t);
            t = _o49.t;
            V end = _o49.end;
            M searching = _o49.searching;
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->open_searching_searching_p_ball_radius + open_searching_searching_shots, packed, lanes_load(varying ? lists->open_searching_p_ball_radius + i : lists->p_ball_radius));
                    lanes_pack(lists->open_searching_searching_p_gravity + open_searching_searching_shots, packed, lanes_load(varying ? lists->open_searching_p_gravity + i : lists->p_gravity));
                    lanes_pack(lists->open_searching_searching_p_ring_radius + open_searching_searching_shots, packed, lanes_load(varying ? lists->open_searching_p_ring_radius + i : lists->p_ring_radius));
                    lanes_pack(lists->open_searching_searching_p_wire_radius + open_searching_searching_shots, packed, lanes_load(varying ? lists->open_searching_p_wire_radius + i : lists->p_wire_radius));
                }
                open_searching_searching_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
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
                    if (LANES_SELDOM(varying))
                        LANES(court_bounded_fix_f50)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_searching_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o51 =
                    LANES(court_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = _o51.leaving;
                V margin = _o51.margin;
                const LANES(court_ring_advance_out) _o52 =
                    LANES(court_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[14]), lanes_load(lists->fixed[50]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[51]), lanes_load(lists->fixed[52]));
                V gap = _o52.gap;
                V rate = _o52.rate;
                V bend = _o52.bend;
                V step = _o52.step;
                V next = _o52.next;
                V clearance = _o52.clearance;
                const LANES(court_struck_out) _o53 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o53.hit;
                M sure = _o53.sure;
                M vague = _o53.vague;
                const M _m54 = lanes_both(active, vague);
                if (lanes_any(_m54)) {
                    const LANES(court_finer_out) _o55 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m54, _o55.share, share);
                    const LANES(court_allowance_out) _o56 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[21]));
                    V position_level = _o56.position_level;
                    V velocity_level = _o56.velocity_level;
                    V excess = _o56.excess;
                    const LANES(court_ring_margins_out) _o57 =
                        LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[46]), lanes_load(lists->fixed[47]), lanes_load(lists->fixed[48]), lanes_load(lists->fixed[49]));
                    flat = lanes_select(_m54, _o57.margin, flat);
                    tilt = lanes_select(_m54, _o57.leaving_margin, tilt);
                    rate_slack = lanes_select(_m54, _o57.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o58 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m54, _o58.doubt, doubt);
                }
                const LANES(court_advanced_out) _o59 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o59.arrival;
                certain = _o59.certain;
                M exhausted = _o59.exhausted;
                searching = _o59.searching;
                t = _o59.t;
                const M _m60 = lanes_both(active, exhausted);
                {
                    const LANES(court_ring_enter_out) _o61 =
                        LANES(court_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m60, _o61.t, t);
                    end = lanes_select(_m60, _o61.end, end);
                    searching = lanes_choose(_m60, _o61.searching, searching);
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
            const LANES(court_questioned_out) _o62 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o62.doubt;
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
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f63)(lists, i);
            V arrival = lanes_load(lists->open_arrival + i);
            V ceiling = lanes_load(lists->open_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_certain + i));
            V flat = lanes_load(lists->open_flat + i);
            V last = lanes_load(lists->open_last + i);
            V rho_start = lanes_load(lists->open_rho_start + i);
            V tilt = lanes_load(lists->open_tilt + i);
            V vx = lanes_load(lists->open_vx + i);
            V vy = lanes_load(lists->open_vy + i);
            V vz = lanes_load(lists->open_vz + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(court_found_out) _o64 =
                LANES(court_found)(arrival);
            M arrives = _o64.arrives;
            M refining = _o64.refining;
            V rate = _o64.rate;
            const LANES(court_nearby_out) _o65 =
                LANES(court_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o65.leaving;
            const M _m66 = lanes_both(rows, refining);
            if (lanes_any(_m66)) {
                const LANES(court_ring_refine_out) _o67 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[14]));
                V refined = _o67.time;
                V gap = _o67.gap;
                rate = lanes_select(_m66, _o67.rate, rate);
                const LANES(court_polished_out) _o68 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m66, _o68.arrival, arrival);
                refining = lanes_choose(_m66, _o68.refining, refining);
            }
            const M _m69 = lanes_both(rows, refining);
            if (lanes_any(_m69)) {
                const LANES(court_ring_refine_out) _o70 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[14]));
                V refined = _o70.time;
                V gap = _o70.gap;
                rate = lanes_select(_m69, _o70.rate, rate);
                const LANES(court_polished_out) _o71 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m69, _o71.arrival, arrival);
                refining = lanes_choose(_m69, _o71.refining, refining);
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
                lanes_pack(lists->open_refining_rho_start + open_refining_shots, packed, rho_start);
                lanes_pack(lists->open_refining_vx + open_refining_shots, packed, vx);
                lanes_pack(lists->open_refining_vy + open_refining_shots, packed, vy);
                lanes_pack(lists->open_refining_vz + open_refining_shots, packed, vz);
                lanes_pack(lists->open_refining_x + open_refining_shots, packed, x);
                lanes_pack(lists->open_refining_y + open_refining_shots, packed, y);
                lanes_pack(lists->open_refining_z + open_refining_shots, packed, z);
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->open_refining_p_ball_radius + open_refining_shots, packed, lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius));
                    lanes_pack(lists->open_refining_p_gravity + open_refining_shots, packed, lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity));
                    lanes_pack(lists->open_refining_p_ring_radius + open_refining_shots, packed, lanes_load(varying ? lists->open_p_ring_radius + i : lists->p_ring_radius));
                    lanes_pack(lists->open_refining_p_wire_radius + open_refining_shots, packed, lanes_load(varying ? lists->open_p_wire_radius + i : lists->p_wire_radius));
                }
                open_refining_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
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
                    if (LANES_SELDOM(varying))
                        LANES(court_bounded_fix_f72)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_ring_refine_out) _o73 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[14]));
                V refined = _o73.time;
                V gap = _o73.gap;
                V rate = _o73.rate;
                const LANES(court_polished_out) _o74 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o74.arrival;
                refining = _o74.refining;
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
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f75)(lists, i);
            V arrival = lanes_load(lists->open_arrival + i);
            M arrives = lanes_less(K(0.0), lanes_load(lists->open_arrives + i));
            V ceiling = lanes_load(lists->open_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_certain + i));
            V doubt = lanes_load(lists->open_doubt + i);
            V extent = lanes_load(lists->open_extent + i);
            V late = lanes_load(lists->open_late + i);
            V latest = lanes_load(lists->open_latest + i);
            V leaving = lanes_load(lists->open_leaving + i);
            V position_error = lanes_load(lists->open_position_error + i);
            V rate = lanes_load(lists->open_rate + i);
            V speed = lanes_load(lists->open_speed + i);
            V velocity_error = lanes_load(lists->open_velocity_error + i);
            V when = lanes_load(lists->open_when + i);
            V which = lanes_load(lists->open_which + i);
            const LANES(court_ring_margins_out) _o76 =
                LANES(court_ring_margins)(latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[46]), lanes_load(lists->fixed[47]), lanes_load(lists->fixed[48]), lanes_load(lists->fixed[49]));
            V flat = _o76.margin;
            V tilt = _o76.leaving_margin;
            V rate_margin = _o76.rate_margin;
            const LANES(court_own_margin_out) _o77 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o77.margin;
            const LANES(court_crossing_out) _o78 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o78.clearance;
            V delay = _o78.delay;
            const LANES(court_landed_out) _o79 =
                LANES(court_landed)(arrival);
            V time = _o79.time;
            const LANES(court_landed_surely_out) _o80 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o80.delay;
            doubt = _o80.doubt;
            const LANES(court_tied_out) _o81 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o81.doubt;
            late = _o81.late;
            const LANES(court_sooner_out) _o82 =
                LANES(court_sooner)(arrives, K(0.0), time, when, which);
            when = _o82.when;
            which = _o82.which;
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
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f83)(lists, i);
            V doubt = lanes_load(lists->doubt + i);
            V extent = lanes_load(lists->extent + i);
            M kept = lanes_less(K(0.0), lanes_load(lists->kept + i));
            V last = lanes_load(lists->last + i);
            V late = lanes_load(lists->late + i);
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
            const LANES(court_horizon_out) _o84 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[20]));
            V until = _o84.horizon;
            V pad = _o84.pad;
            const LANES(court_halved_out) _o85 =
                LANES(court_halved)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, late, pad, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[53]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[54]));
            V middle_x = _o85.middle_x;
            V reach_x = _o85.reach_x;
            V later_middle_x = _o85.later_middle_x;
            V later_reach_x = _o85.later_reach_x;
            V middle_y = _o85.middle_y;
            V reach_y = _o85.reach_y;
            V later_middle_y = _o85.later_middle_y;
            V later_reach_y = _o85.later_reach_y;
            V middle_z = _o85.middle_z;
            V reach_z = _o85.reach_z;
            V later_middle_z = _o85.later_middle_z;
            V later_reach_z = _o85.later_reach_z;
            const LANES(court_backboard_near_out) _o86 =
                LANES(court_backboard_near)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, later_middle_x, later_middle_y, later_middle_z, later_reach_x, later_reach_y, later_reach_z, lanes_load(lists->fixed[55]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[56]), lanes_load(lists->fixed[57]), lanes_load(lists->fixed[58]), lanes_load(lists->fixed[59]));
            M reachable = _o86.near;
            const LANES(court_reachable_in_flight_out) _o87 =
                LANES(court_reachable_in_flight)(kept, reachable);
            reachable = _o87.reachable;
            const M packed = lanes_both(rows, reachable);
            if (lanes_any(packed)) {
                lanes_pack(lists->reachable_row + reachable_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->reachable_doubt + reachable_shots, packed, doubt);
                lanes_pack(lists->reachable_extent + reachable_shots, packed, extent);
                lanes_pack(lists->reachable_last + reachable_shots, packed, last);
                lanes_pack(lists->reachable_late + reachable_shots, packed, late);
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->reachable_p_ball_radius + reachable_shots, packed, lanes_load(lists->p_ball_radius + (i & varying)));
                    lanes_pack(lists->reachable_p_board_bottom + reachable_shots, packed, lanes_load(lists->p_board_bottom + (i & varying)));
                    lanes_pack(lists->reachable_p_board_distance + reachable_shots, packed, lanes_load(lists->p_board_distance + (i & varying)));
                    lanes_pack(lists->reachable_p_board_half_width + reachable_shots, packed, lanes_load(lists->p_board_half_width + (i & varying)));
                    lanes_pack(lists->reachable_p_board_thickness + reachable_shots, packed, lanes_load(lists->p_board_thickness + (i & varying)));
                    lanes_pack(lists->reachable_p_board_top + reachable_shots, packed, lanes_load(lists->p_board_top + (i & varying)));
                    lanes_pack(lists->reachable_p_gravity + reachable_shots, packed, lanes_load(lists->p_gravity + (i & varying)));
                }
                reachable_shots += lanes_many(packed);
            }
        }
        {
        size_t reachable_searching_shots = 0;
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(reachable_shots - i);
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f88)(lists, i);
            V doubt = lanes_load(lists->reachable_doubt + i);
            V extent = lanes_load(lists->reachable_extent + i);
            V last = lanes_load(lists->reachable_last + i);
            V late = lanes_load(lists->reachable_late + i);
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
            const LANES(court_horizon_out) _o89 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[20]));
            V until = _o89.horizon;
            V pad = _o89.pad;
            const LANES(court_backboard_prepare_out) _o90 =
                LANES(court_backboard_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[60]), lanes_load(lists->fixed[61]), lanes_load(lists->fixed[62]), lanes_load(lists->fixed[63]), lanes_load(lists->fixed[64]), lanes_load(lists->fixed[65]), lanes_load(lists->fixed[66]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[20]), lanes_load(lists->fixed[67]), lanes_load(lists->fixed[42]), lanes_load(lists->fixed[68]), lanes_load(lists->fixed[69]), lanes_load(lists->fixed[70]));
            V low0 = _o90.low0;
            V high0 = _o90.high0;
            V low1 = _o90.low1;
            V high1 = _o90.high1;
            V ceiling = _o90.ceiling;
            V latest = _o90.latest;
            V lost = _o90.lost;
            const LANES(court_beginning_out) _o91 =
                LANES(court_beginning)();
            V share = _o91.share;
            V arrival = _o91.arrival;
            M certain = _o91.certain;
            const LANES(court_allowance_out) _o92 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[21]));
            V position_level = _o92.position_level;
            V velocity_level = _o92.velocity_level;
            V excess = _o92.excess;
            const LANES(court_backboard_margins_out) _o93 =
                LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[72]), lanes_load(lists->fixed[73]), lanes_load(lists->fixed[74]), lanes_load(lists->fixed[75]), lanes_load(lists->fixed[76]), lanes_load(lists->fixed[77]), lanes_load(lists->fixed[78]), lanes_load(lists->fixed[79]), lanes_load(lists->fixed[80]), lanes_load(lists->fixed[81]));
            V flat = _o93.margin;
            V tilt = _o93.leaving_margin;
            V rate_slack = _o93.rate_margin;
            const LANES(court_backboard_enter_out) _o94 =
                LANES(court_backboard_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o94.t;
            V end = _o94.end;
            M searching = _o94.searching;
            const LANES(court_beyond_windows_out) _o95 =
                LANES(court_beyond_windows)(doubt, excess, late, lost, pad, searching);
            doubt = _o95.doubt;
            const M _m96 = lanes_both(rows, searching);
            if (lanes_any(_m96)) {
                const LANES(court_nearby_out) _o97 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o97.leaving;
                V margin = _o97.margin;
                const LANES(court_backboard_advance_out) _o98 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[82]), lanes_load(lists->fixed[83]), lanes_load(lists->fixed[72]), lanes_load(lists->fixed[84]));
                V gap = _o98.gap;
                V rate = _o98.rate;
                V bend = _o98.bend;
                V step = _o98.step;
                V next = _o98.next;
                V clearance = _o98.clearance;
                const LANES(court_struck_or_still_out) _o99 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o99.hit;
                M sure = _o99.sure;
                M vague = _o99.vague;
                const M _m100 = lanes_both(_m96, vague);
                if (lanes_any(_m100)) {
                    const LANES(court_finer_out) _o101 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m100, _o101.share, share);
                    const LANES(court_allowance_out) _o102 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[21]));
                    V position_level = _o102.position_level;
                    V velocity_level = _o102.velocity_level;
                    V excess = _o102.excess;
                    const LANES(court_backboard_margins_out) _o103 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[72]), lanes_load(lists->fixed[73]), lanes_load(lists->fixed[74]), lanes_load(lists->fixed[75]), lanes_load(lists->fixed[76]), lanes_load(lists->fixed[77]), lanes_load(lists->fixed[78]), lanes_load(lists->fixed[79]), lanes_load(lists->fixed[80]), lanes_load(lists->fixed[81]));
                    flat = lanes_select(_m100, _o103.margin, flat);
                    tilt = lanes_select(_m100, _o103.leaving_margin, tilt);
                    rate_slack = lanes_select(_m100, _o103.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o104 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m100, _o104.doubt, doubt);
                }
                const LANES(court_advanced_out) _o105 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = lanes_select(_m96, _o105.arrival, arrival);
                certain = lanes_choose(_m96, _o105.certain, certain);
                M exhausted = _o105.exhausted;
                searching = lanes_choose(_m96, _o105.searching, searching);
                t = lanes_select(_m96, _o105.t, t);
                const M _m106 = lanes_both(_m96, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o107 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m106, _o107.t, t);
                    end = lanes_select(_m106, _o107.end, end);
                    searching = lanes_choose(_m106, _o107.searching, searching);
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->reachable_searching_p_ball_radius + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius));
                    lanes_pack(lists->reachable_searching_p_board_bottom + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_board_bottom + i : lists->p_board_bottom));
                    lanes_pack(lists->reachable_searching_p_board_distance + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance));
                    lanes_pack(lists->reachable_searching_p_board_half_width + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_board_half_width + i : lists->p_board_half_width));
                    lanes_pack(lists->reachable_searching_p_board_thickness + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_board_thickness + i : lists->p_board_thickness));
                    lanes_pack(lists->reachable_searching_p_board_top + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_board_top + i : lists->p_board_top));
                    lanes_pack(lists->reachable_searching_p_gravity + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity));
                }
                reachable_searching_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
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
                    if (LANES_SELDOM(varying))
                        LANES(court_bounded_fix_f108)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = reachable_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o109 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o109.leaving;
                V margin = _o109.margin;
                const LANES(court_backboard_advance_out) _o110 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[82]), lanes_load(lists->fixed[83]), lanes_load(lists->fixed[72]), lanes_load(lists->fixed[84]));
                V gap = _o110.gap;
                V rate = _o110.rate;
                V bend = _o110.bend;
                V step = _o110.step;
                V next = _o110.next;
                V clearance = _o110.clearance;
                const LANES(court_struck_or_still_out) _o111 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o111.hit;
                M sure = _o111.sure;
                M vague = _o111.vague;
                const M _m112 = lanes_both(active, vague);
                if (lanes_any(_m112)) {
                    const LANES(court_finer_out) _o113 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m112, _o113.share, share);
                    const LANES(court_allowance_out) _o114 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[21]));
                    V position_level = _o114.position_level;
                    V velocity_level = _o114.velocity_level;
                    V excess = _o114.excess;
                    const LANES(court_backboard_margins_out) _o115 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[72]), lanes_load(lists->fixed[73]), lanes_load(lists->fixed[74]), lanes_load(lists->fixed[75]), lanes_load(lists->fixed[76]), lanes_load(lists->fixed[77]), lanes_load(lists->fixed[78]), lanes_load(lists->fixed[79]), lanes_load(lists->fixed[80]), lanes_load(lists->fixed[81]));
                    flat = lanes_select(_m112, _o115.margin, flat);
                    tilt = lanes_select(_m112, _o115.leaving_margin, tilt);
                    rate_slack = lanes_select(_m112, _o115.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o116 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m112, _o116.doubt, doubt);
                }
                const LANES(court_advanced_out) _o117 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o117.arrival;
                certain = _o117.certain;
                M exhausted = _o117.exhausted;
                searching = _o117.searching;
                t = _o117.t;
                const M _m118 = lanes_both(active, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o119 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m118, _o119.t, t);
                    end = lanes_select(_m118, _o119.end, end);
                    searching = lanes_choose(_m118, _o119.searching, searching);
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
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f120)(lists, i);
            V arrival = lanes_load(lists->reachable_arrival + i);
            V ceiling = lanes_load(lists->reachable_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->reachable_certain + i));
            V doubt = lanes_load(lists->reachable_doubt + i);
            V flat = lanes_load(lists->reachable_flat + i);
            V last = lanes_load(lists->reachable_last + i);
            M searching = lanes_less(K(0.0), lanes_load(lists->reachable_searching + i));
            V t = lanes_load(lists->reachable_t + i);
            V tilt = lanes_load(lists->reachable_tilt + i);
            V vx = lanes_load(lists->reachable_vx + i);
            V vy = lanes_load(lists->reachable_vy + i);
            V vz = lanes_load(lists->reachable_vz + i);
            V x = lanes_load(lists->reachable_x + i);
            V y = lanes_load(lists->reachable_y + i);
            V z = lanes_load(lists->reachable_z + i);
            const LANES(court_questioned_out) _o121 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o121.doubt;
            const LANES(court_found_out) _o122 =
                LANES(court_found)(arrival);
            M arrives = _o122.arrives;
            M refining = _o122.refining;
            V rate = _o122.rate;
            const LANES(court_nearby_out) _o123 =
                LANES(court_nearby)(flat, K(1.0), last, arrival, tilt);
            V leaving = _o123.leaving;
            const M _m124 = lanes_both(rows, refining);
            if (lanes_any(_m124)) {
                const LANES(court_backboard_refine_out) _o125 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[82]));
                V refined = _o125.time;
                V gap = _o125.gap;
                rate = lanes_select(_m124, _o125.rate, rate);
                const LANES(court_polished_out) _o126 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m124, _o126.arrival, arrival);
                refining = lanes_choose(_m124, _o126.refining, refining);
            }
            const M _m127 = lanes_both(rows, refining);
            if (lanes_any(_m127)) {
                const LANES(court_backboard_refine_out) _o128 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[82]));
                V refined = _o128.time;
                V gap = _o128.gap;
                rate = lanes_select(_m127, _o128.rate, rate);
                const LANES(court_polished_out) _o129 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m127, _o129.arrival, arrival);
                refining = lanes_choose(_m127, _o129.refining, refining);
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
                lanes_pack(lists->reachable_refining_vx + reachable_refining_shots, packed, vx);
                lanes_pack(lists->reachable_refining_vy + reachable_refining_shots, packed, vy);
                lanes_pack(lists->reachable_refining_vz + reachable_refining_shots, packed, vz);
                lanes_pack(lists->reachable_refining_x + reachable_refining_shots, packed, x);
                lanes_pack(lists->reachable_refining_y + reachable_refining_shots, packed, y);
                lanes_pack(lists->reachable_refining_z + reachable_refining_shots, packed, z);
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->reachable_refining_p_ball_radius + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius));
                    lanes_pack(lists->reachable_refining_p_board_bottom + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_board_bottom + i : lists->p_board_bottom));
                    lanes_pack(lists->reachable_refining_p_board_distance + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance));
                    lanes_pack(lists->reachable_refining_p_board_half_width + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_board_half_width + i : lists->p_board_half_width));
                    lanes_pack(lists->reachable_refining_p_board_thickness + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_board_thickness + i : lists->p_board_thickness));
                    lanes_pack(lists->reachable_refining_p_board_top + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_board_top + i : lists->p_board_top));
                    lanes_pack(lists->reachable_refining_p_gravity + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity));
                }
                reachable_refining_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
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
                    if (LANES_SELDOM(varying))
                        LANES(court_bounded_fix_f130)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = reachable_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_backboard_refine_out) _o131 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[82]));
                V refined = _o131.time;
                V gap = _o131.gap;
                V rate = _o131.rate;
                const LANES(court_polished_out) _o132 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o132.arrival;
                refining = _o132.refining;
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
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f133)(lists, i);
            V arrival = lanes_load(lists->reachable_arrival + i);
            M arrives = lanes_less(K(0.0), lanes_load(lists->reachable_arrives + i));
            V ceiling = lanes_load(lists->reachable_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->reachable_certain + i));
            V doubt = lanes_load(lists->reachable_doubt + i);
            V extent = lanes_load(lists->reachable_extent + i);
            V late = lanes_load(lists->reachable_late + i);
            V latest = lanes_load(lists->reachable_latest + i);
            V leaving = lanes_load(lists->reachable_leaving + i);
            V position_error = lanes_load(lists->reachable_position_error + i);
            V rate = lanes_load(lists->reachable_rate + i);
            V speed = lanes_load(lists->reachable_speed + i);
            V velocity_error = lanes_load(lists->reachable_velocity_error + i);
            V when = lanes_load(lists->reachable_when + i);
            V which = lanes_load(lists->reachable_which + i);
            const LANES(court_backboard_margins_out) _o134 =
                LANES(court_backboard_margins)(latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[72]), lanes_load(lists->fixed[73]), lanes_load(lists->fixed[74]), lanes_load(lists->fixed[75]), lanes_load(lists->fixed[76]), lanes_load(lists->fixed[77]), lanes_load(lists->fixed[78]), lanes_load(lists->fixed[79]), lanes_load(lists->fixed[80]), lanes_load(lists->fixed[81]));
            V flat = _o134.margin;
            V tilt = _o134.leaving_margin;
            V rate_margin = _o134.rate_margin;
            const LANES(court_own_margin_out) _o135 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o135.margin;
            const LANES(court_crossing_out) _o136 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o136.clearance;
            V delay = _o136.delay;
            const LANES(court_landed_out) _o137 =
                LANES(court_landed)(arrival);
            V time = _o137.time;
            const LANES(court_landed_surely_out) _o138 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o138.delay;
            doubt = _o138.doubt;
            const LANES(court_tied_out) _o139 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o139.doubt;
            late = _o139.late;
            const LANES(court_sooner_out) _o140 =
                LANES(court_sooner)(arrives, K(1.0), time, when, which);
            when = _o140.when;
            which = _o140.which;
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
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f141)(lists, i);
            V doubt = lanes_load(lists->doubt + i);
            V extent = lanes_load(lists->extent + i);
            M kept = lanes_less(K(0.0), lanes_load(lists->kept + i));
            V last = lanes_load(lists->last + i);
            V late = lanes_load(lists->late + i);
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
            const LANES(court_horizon_out) _o142 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[20]));
            V until = _o142.horizon;
            V pad = _o142.pad;
            const LANES(court_halved_out) _o143 =
                LANES(court_halved)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, late, pad, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[53]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[54]));
            V middle_x = _o143.middle_x;
            V reach_x = _o143.reach_x;
            V later_middle_x = _o143.later_middle_x;
            V later_reach_x = _o143.later_reach_x;
            V middle_y = _o143.middle_y;
            V reach_y = _o143.reach_y;
            V later_middle_y = _o143.later_middle_y;
            V later_reach_y = _o143.later_reach_y;
            V middle_z = _o143.middle_z;
            V reach_z = _o143.reach_z;
            V later_middle_z = _o143.later_middle_z;
            V later_reach_z = _o143.later_reach_z;
            const LANES(court_bridge_near_out) _o144 =
                LANES(court_bridge_near)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, later_middle_x, later_middle_y, later_middle_z, later_reach_x, later_reach_y, later_reach_z, lanes_load(lists->fixed[55]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[85]), lanes_load(lists->fixed[86]), lanes_load(lists->fixed[87]), lanes_load(lists->fixed[88]));
            M reachable = _o144.near;
            const LANES(court_reachable_in_flight_out) _o145 =
                LANES(court_reachable_in_flight)(kept, reachable);
            reachable = _o145.reachable;
            const M packed = lanes_both(rows, reachable);
            if (lanes_any(packed)) {
                lanes_pack(lists->reachable_row + reachable_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->reachable_doubt + reachable_shots, packed, doubt);
                lanes_pack(lists->reachable_extent + reachable_shots, packed, extent);
                lanes_pack(lists->reachable_last + reachable_shots, packed, last);
                lanes_pack(lists->reachable_late + reachable_shots, packed, late);
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->reachable_p_ball_radius + reachable_shots, packed, lanes_load(lists->p_ball_radius + (i & varying)));
                    lanes_pack(lists->reachable_p_board_distance + reachable_shots, packed, lanes_load(lists->p_board_distance + (i & varying)));
                    lanes_pack(lists->reachable_p_bridge_depth + reachable_shots, packed, lanes_load(lists->p_bridge_depth + (i & varying)));
                    lanes_pack(lists->reachable_p_bridge_half_width + reachable_shots, packed, lanes_load(lists->p_bridge_half_width + (i & varying)));
                    lanes_pack(lists->reachable_p_gravity + reachable_shots, packed, lanes_load(lists->p_gravity + (i & varying)));
                    lanes_pack(lists->reachable_p_ring_radius + reachable_shots, packed, lanes_load(lists->p_ring_radius + (i & varying)));
                    lanes_pack(lists->reachable_p_wire_radius + reachable_shots, packed, lanes_load(lists->p_wire_radius + (i & varying)));
                }
                reachable_shots += lanes_many(packed);
            }
        }
        {
        size_t reachable_searching_shots = 0;
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(reachable_shots - i);
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f146)(lists, i);
            V doubt = lanes_load(lists->reachable_doubt + i);
            V extent = lanes_load(lists->reachable_extent + i);
            V last = lanes_load(lists->reachable_last + i);
            V late = lanes_load(lists->reachable_late + i);
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
            const LANES(court_horizon_out) _o147 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[20]));
            V until = _o147.horizon;
            V pad = _o147.pad;
            const LANES(court_bridge_prepare_out) _o148 =
                LANES(court_bridge_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[8]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[89]), lanes_load(lists->fixed[90]), lanes_load(lists->fixed[91]), lanes_load(lists->fixed[92]), lanes_load(lists->fixed[93]), lanes_load(lists->fixed[94]), lanes_load(lists->fixed[95]), lanes_load(lists->fixed[96]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[20]), lanes_load(lists->fixed[97]), lanes_load(lists->fixed[42]), lanes_load(lists->fixed[98]), lanes_load(lists->fixed[99]), lanes_load(lists->fixed[100]));
            V low0 = _o148.low0;
            V high0 = _o148.high0;
            V low1 = _o148.low1;
            V high1 = _o148.high1;
            V ceiling = _o148.ceiling;
            V latest = _o148.latest;
            V lost = _o148.lost;
            const LANES(court_beginning_out) _o149 =
                LANES(court_beginning)();
            V share = _o149.share;
            V arrival = _o149.arrival;
            M certain = _o149.certain;
            const LANES(court_allowance_out) _o150 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[21]));
            V position_level = _o150.position_level;
            V velocity_level = _o150.velocity_level;
            V excess = _o150.excess;
            const LANES(court_bridge_margins_out) _o151 =
                LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[101]), lanes_load(lists->fixed[102]), lanes_load(lists->fixed[103]), lanes_load(lists->fixed[104]), lanes_load(lists->fixed[105]), lanes_load(lists->fixed[106]), lanes_load(lists->fixed[107]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[110]));
            V flat = _o151.margin;
            V tilt = _o151.leaving_margin;
            V rate_slack = _o151.rate_margin;
            const LANES(court_bridge_enter_out) _o152 =
                LANES(court_bridge_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o152.t;
            V end = _o152.end;
            M searching = _o152.searching;
            const LANES(court_beyond_windows_out) _o153 =
                LANES(court_beyond_windows)(doubt, excess, late, lost, pad, searching);
            doubt = _o153.doubt;
            const M _m154 = lanes_both(rows, searching);
            if (lanes_any(_m154)) {
                const LANES(court_nearby_out) _o155 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o155.leaving;
                V margin = _o155.margin;
                const LANES(court_bridge_advance_out) _o156 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[82]), lanes_load(lists->fixed[83]), lanes_load(lists->fixed[101]), lanes_load(lists->fixed[84]));
                V gap = _o156.gap;
                V rate = _o156.rate;
                V bend = _o156.bend;
                V step = _o156.step;
                V next = _o156.next;
                V clearance = _o156.clearance;
                const LANES(court_struck_or_still_out) _o157 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o157.hit;
                M sure = _o157.sure;
                M vague = _o157.vague;
                const M _m158 = lanes_both(_m154, vague);
                if (lanes_any(_m158)) {
                    const LANES(court_finer_out) _o159 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m158, _o159.share, share);
                    const LANES(court_allowance_out) _o160 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[21]));
                    V position_level = _o160.position_level;
                    V velocity_level = _o160.velocity_level;
                    V excess = _o160.excess;
                    const LANES(court_bridge_margins_out) _o161 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[101]), lanes_load(lists->fixed[102]), lanes_load(lists->fixed[103]), lanes_load(lists->fixed[104]), lanes_load(lists->fixed[105]), lanes_load(lists->fixed[106]), lanes_load(lists->fixed[107]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[110]));
                    flat = lanes_select(_m158, _o161.margin, flat);
                    tilt = lanes_select(_m158, _o161.leaving_margin, tilt);
                    rate_slack = lanes_select(_m158, _o161.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o162 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m158, _o162.doubt, doubt);
                }
                const LANES(court_advanced_out) _o163 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = lanes_select(_m154, _o163.arrival, arrival);
                certain = lanes_choose(_m154, _o163.certain, certain);
                M exhausted = _o163.exhausted;
                searching = lanes_choose(_m154, _o163.searching, searching);
                t = lanes_select(_m154, _o163.t, t);
                const M _m164 = lanes_both(_m154, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o165 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m164, _o165.t, t);
                    end = lanes_select(_m164, _o165.end, end);
                    searching = lanes_choose(_m164, _o165.searching, searching);
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->reachable_searching_p_ball_radius + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius));
                    lanes_pack(lists->reachable_searching_p_board_distance + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance));
                    lanes_pack(lists->reachable_searching_p_bridge_depth + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_bridge_depth + i : lists->p_bridge_depth));
                    lanes_pack(lists->reachable_searching_p_bridge_half_width + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_bridge_half_width + i : lists->p_bridge_half_width));
                    lanes_pack(lists->reachable_searching_p_gravity + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity));
                    lanes_pack(lists->reachable_searching_p_ring_radius + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_ring_radius + i : lists->p_ring_radius));
                    lanes_pack(lists->reachable_searching_p_wire_radius + reachable_searching_shots, packed, lanes_load(varying ? lists->reachable_p_wire_radius + i : lists->p_wire_radius));
                }
                reachable_searching_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
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
                    if (LANES_SELDOM(varying))
                        LANES(court_bounded_fix_f166)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = reachable_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o167 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o167.leaving;
                V margin = _o167.margin;
                const LANES(court_bridge_advance_out) _o168 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[82]), lanes_load(lists->fixed[83]), lanes_load(lists->fixed[101]), lanes_load(lists->fixed[84]));
                V gap = _o168.gap;
                V rate = _o168.rate;
                V bend = _o168.bend;
                V step = _o168.step;
                V next = _o168.next;
                V clearance = _o168.clearance;
                const LANES(court_struck_or_still_out) _o169 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o169.hit;
                M sure = _o169.sure;
                M vague = _o169.vague;
                const M _m170 = lanes_both(active, vague);
                if (lanes_any(_m170)) {
                    const LANES(court_finer_out) _o171 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m170, _o171.share, share);
                    const LANES(court_allowance_out) _o172 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[21]));
                    V position_level = _o172.position_level;
                    V velocity_level = _o172.velocity_level;
                    V excess = _o172.excess;
                    const LANES(court_bridge_margins_out) _o173 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[101]), lanes_load(lists->fixed[102]), lanes_load(lists->fixed[103]), lanes_load(lists->fixed[104]), lanes_load(lists->fixed[105]), lanes_load(lists->fixed[106]), lanes_load(lists->fixed[107]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[110]));
                    flat = lanes_select(_m170, _o173.margin, flat);
                    tilt = lanes_select(_m170, _o173.leaving_margin, tilt);
                    rate_slack = lanes_select(_m170, _o173.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o174 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m170, _o174.doubt, doubt);
                }
                const LANES(court_advanced_out) _o175 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o175.arrival;
                certain = _o175.certain;
                M exhausted = _o175.exhausted;
                searching = _o175.searching;
                t = _o175.t;
                const M _m176 = lanes_both(active, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o177 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m176, _o177.t, t);
                    end = lanes_select(_m176, _o177.end, end);
                    searching = lanes_choose(_m176, _o177.searching, searching);
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
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f178)(lists, i);
            V arrival = lanes_load(lists->reachable_arrival + i);
            V ceiling = lanes_load(lists->reachable_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->reachable_certain + i));
            V doubt = lanes_load(lists->reachable_doubt + i);
            V flat = lanes_load(lists->reachable_flat + i);
            V last = lanes_load(lists->reachable_last + i);
            M searching = lanes_less(K(0.0), lanes_load(lists->reachable_searching + i));
            V t = lanes_load(lists->reachable_t + i);
            V tilt = lanes_load(lists->reachable_tilt + i);
            V vx = lanes_load(lists->reachable_vx + i);
            V vy = lanes_load(lists->reachable_vy + i);
            V vz = lanes_load(lists->reachable_vz + i);
            V x = lanes_load(lists->reachable_x + i);
            V y = lanes_load(lists->reachable_y + i);
            V z = lanes_load(lists->reachable_z + i);
            const LANES(court_questioned_out) _o179 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o179.doubt;
            const LANES(court_found_out) _o180 =
                LANES(court_found)(arrival);
            M arrives = _o180.arrives;
            M refining = _o180.refining;
            V rate = _o180.rate;
            const LANES(court_nearby_out) _o181 =
                LANES(court_nearby)(flat, K(2.0), last, arrival, tilt);
            V leaving = _o181.leaving;
            const M _m182 = lanes_both(rows, refining);
            if (lanes_any(_m182)) {
                const LANES(court_bridge_refine_out) _o183 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[82]));
                V refined = _o183.time;
                V gap = _o183.gap;
                rate = lanes_select(_m182, _o183.rate, rate);
                const LANES(court_polished_out) _o184 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m182, _o184.arrival, arrival);
                refining = lanes_choose(_m182, _o184.refining, refining);
            }
            const M _m185 = lanes_both(rows, refining);
            if (lanes_any(_m185)) {
                const LANES(court_bridge_refine_out) _o186 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[82]));
                V refined = _o186.time;
                V gap = _o186.gap;
                rate = lanes_select(_m185, _o186.rate, rate);
                const LANES(court_polished_out) _o187 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m185, _o187.arrival, arrival);
                refining = lanes_choose(_m185, _o187.refining, refining);
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
                lanes_pack(lists->reachable_refining_vx + reachable_refining_shots, packed, vx);
                lanes_pack(lists->reachable_refining_vy + reachable_refining_shots, packed, vy);
                lanes_pack(lists->reachable_refining_vz + reachable_refining_shots, packed, vz);
                lanes_pack(lists->reachable_refining_x + reachable_refining_shots, packed, x);
                lanes_pack(lists->reachable_refining_y + reachable_refining_shots, packed, y);
                lanes_pack(lists->reachable_refining_z + reachable_refining_shots, packed, z);
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->reachable_refining_p_ball_radius + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_ball_radius + i : lists->p_ball_radius));
                    lanes_pack(lists->reachable_refining_p_board_distance + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_board_distance + i : lists->p_board_distance));
                    lanes_pack(lists->reachable_refining_p_bridge_depth + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_bridge_depth + i : lists->p_bridge_depth));
                    lanes_pack(lists->reachable_refining_p_bridge_half_width + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_bridge_half_width + i : lists->p_bridge_half_width));
                    lanes_pack(lists->reachable_refining_p_gravity + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_gravity + i : lists->p_gravity));
                    lanes_pack(lists->reachable_refining_p_ring_radius + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_ring_radius + i : lists->p_ring_radius));
                    lanes_pack(lists->reachable_refining_p_wire_radius + reachable_refining_shots, packed, lanes_load(varying ? lists->reachable_p_wire_radius + i : lists->p_wire_radius));
                }
                reachable_refining_shots += lanes_many(packed);
            }
        }
        {
            size_t taken = 0, busy = 0;
            M active = lanes_nowhere();
            V row = K(0.0), turns = K(0.0);
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
                    if (LANES_SELDOM(varying))
                        LANES(court_bounded_fix_f188)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = reachable_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_bridge_refine_out) _o189 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[82]));
                V refined = _o189.time;
                V gap = _o189.gap;
                V rate = _o189.rate;
                const LANES(court_polished_out) _o190 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o190.arrival;
                refining = _o190.refining;
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
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f191)(lists, i);
            V arrival = lanes_load(lists->reachable_arrival + i);
            M arrives = lanes_less(K(0.0), lanes_load(lists->reachable_arrives + i));
            V ceiling = lanes_load(lists->reachable_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->reachable_certain + i));
            V doubt = lanes_load(lists->reachable_doubt + i);
            V extent = lanes_load(lists->reachable_extent + i);
            V late = lanes_load(lists->reachable_late + i);
            V latest = lanes_load(lists->reachable_latest + i);
            V leaving = lanes_load(lists->reachable_leaving + i);
            V position_error = lanes_load(lists->reachable_position_error + i);
            V rate = lanes_load(lists->reachable_rate + i);
            V speed = lanes_load(lists->reachable_speed + i);
            V velocity_error = lanes_load(lists->reachable_velocity_error + i);
            V when = lanes_load(lists->reachable_when + i);
            V which = lanes_load(lists->reachable_which + i);
            const LANES(court_bridge_margins_out) _o192 =
                LANES(court_bridge_margins)(latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[101]), lanes_load(lists->fixed[102]), lanes_load(lists->fixed[103]), lanes_load(lists->fixed[104]), lanes_load(lists->fixed[105]), lanes_load(lists->fixed[106]), lanes_load(lists->fixed[107]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[110]));
            V flat = _o192.margin;
            V tilt = _o192.leaving_margin;
            V rate_margin = _o192.rate_margin;
            const LANES(court_own_margin_out) _o193 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o193.margin;
            const LANES(court_crossing_out) _o194 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o194.clearance;
            V delay = _o194.delay;
            const LANES(court_landed_out) _o195 =
                LANES(court_landed)(arrival);
            V time = _o195.time;
            const LANES(court_landed_surely_out) _o196 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o196.delay;
            doubt = _o196.doubt;
            const LANES(court_tied_out) _o197 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o197.doubt;
            late = _o197.late;
            const LANES(court_sooner_out) _o198 =
                LANES(court_sooner)(arrives, K(2.0), time, when, which);
            when = _o198.when;
            which = _o198.which;
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
            const M _m199 = lanes_both(rows, limited);
            if (lanes_any(_m199)) {
                const LANES(court_expiry_out) _o200 =
                    LANES(court_expiry)(clock, doubt, late, time_error, time_limit, when, which);
                V time = _o200.time;
                V delay = _o200.delay;
                M arrives = _o200.arrives;
                doubt = lanes_select(_m199, _o200.doubt, doubt);
                const LANES(court_tied_out) _o201 =
                    LANES(court_tied)(arrives, delay, doubt, late, time, when);
                doubt = lanes_select(_m199, _o201.doubt, doubt);
                late = lanes_select(_m199, _o201.late, late);
                const LANES(court_sooner_out) _o202 =
                    LANES(court_sooner)(arrives, K(4.0), time, when, which);
                when = lanes_select(_m199, _o202.when, when);
                which = lanes_select(_m199, _o202.which, which);
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->kept_p_backboard_friction + kept_shots, packed, lanes_load(lists->p_backboard_friction + (i & varying)));
                    lanes_pack(lists->kept_p_ball_radius + kept_shots, packed, lanes_load(lists->p_ball_radius + (i & varying)));
                    lanes_pack(lists->kept_p_board_bottom + kept_shots, packed, lanes_load(lists->p_board_bottom + (i & varying)));
                    lanes_pack(lists->kept_p_board_distance + kept_shots, packed, lanes_load(lists->p_board_distance + (i & varying)));
                    lanes_pack(lists->kept_p_board_half_width + kept_shots, packed, lanes_load(lists->p_board_half_width + (i & varying)));
                    lanes_pack(lists->kept_p_board_thickness + kept_shots, packed, lanes_load(lists->p_board_thickness + (i & varying)));
                    lanes_pack(lists->kept_p_board_top + kept_shots, packed, lanes_load(lists->p_board_top + (i & varying)));
                    lanes_pack(lists->kept_p_bridge_depth + kept_shots, packed, lanes_load(lists->p_bridge_depth + (i & varying)));
                    lanes_pack(lists->kept_p_bridge_friction + kept_shots, packed, lanes_load(lists->p_bridge_friction + (i & varying)));
                    lanes_pack(lists->kept_p_bridge_half_width + kept_shots, packed, lanes_load(lists->p_bridge_half_width + (i & varying)));
                    lanes_pack(lists->kept_p_end_depth + kept_shots, packed, lanes_load(lists->p_end_depth + (i & varying)));
                    lanes_pack(lists->kept_p_gravity + kept_shots, packed, lanes_load(lists->p_gravity + (i & varying)));
                    lanes_pack(lists->kept_p_ring_friction + kept_shots, packed, lanes_load(lists->p_ring_friction + (i & varying)));
                    lanes_pack(lists->kept_p_ring_radius + kept_shots, packed, lanes_load(lists->p_ring_radius + (i & varying)));
                    lanes_pack(lists->kept_p_wire_radius + kept_shots, packed, lanes_load(lists->p_wire_radius + (i & varying)));
                }
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
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f487)(lists, i);
            const V p_ring_friction = lanes_load(lists->p_ring_friction + (i & varying));
            const V p_ring_restitution = lanes_load(lists->p_ring_restitution + (i & varying));
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
            const LANES(court_departed_out) _o488 =
                LANES(court_departed)(K(3.0), which);
            M moves = _o488.moves;
            M ends = _o488.ends;
            M touches = _o488.touches;
            V reached = _o488.reached;
            M edge = _o488.edge;
            const LANES(court_body_of_out) _o489 =
                LANES(court_body_of)(which);
            V body = _o489.body;
            const M _m490 = lanes_both(rows, moves);
            if (lanes_any(_m490)) {
                const LANES(court_passing_doubt_out) _o491 =
                    LANES(court_passing_doubt)(when, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[20]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[36]), lanes_load(lists->fixed[164]));
                M unsure = _o491.unsure;
                const LANES(court_undecided_out) _o492 =
                    LANES(court_undecided)(uncertain, unsure);
                uncertain = lanes_select(_m490, _o492.uncertain, uncertain);
                const LANES(court_passing_out) _o493 =
                    LANES(court_passing)(through, when, x, y, z, vx, vy, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[20]), lanes_load(lists->fixed[19]));
                through = lanes_select(_m490, _o493.through, through);
                const LANES(court_flight_out) _o494 =
                    LANES(court_flight)(when, x, y, z, vx, vy, vz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[33]));
                x = lanes_select(_m490, _o494.x, x);
                y = lanes_select(_m490, _o494.y, y);
                z = lanes_select(_m490, _o494.z, z);
                vx = lanes_select(_m490, _o494.vx, vx);
                vy = lanes_select(_m490, _o494.vy, vy);
                vz = lanes_select(_m490, _o494.vz, vz);
                const LANES(court_ticked_out) _o495 =
                    LANES(court_ticked)(clock, when);
                clock = lanes_select(_m490, _o495.clock, clock);
            }
            const M _m496 = lanes_both(rows, limited);
            if (lanes_any(_m496)) {
                const LANES(court_expired_out) _o497 =
                    LANES(court_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m496, _o497.clock, clock);
                body = lanes_select(_m496, _o497.body, body);
                reached = lanes_select(_m496, _o497.reached, reached);
                ends = lanes_choose(_m496, _o497.ends, ends);
            }
            const LANES(court_unhopped_out) _o498 =
                LANES(court_unhopped)();
            M hopped = _o498.hopped;
            const M _m499 = lanes_both(rows, kept);
            if (lanes_any(_m499)) {
                const LANES(court_kept_on_out) _o500 =
                    LANES(court_kept_on)(began, body, clock, doubt, ends, held, last, reached, rests, rolling, rolls, which);
                body = lanes_select(_m499, _o500.body, body);
                reached = lanes_select(_m499, _o500.reached, reached);
                doubt = lanes_select(_m499, _o500.doubt, doubt);
                ends = lanes_choose(_m499, _o500.ends, ends);
                hopped = lanes_choose(_m499, _o500.hopped, hopped);
                last = lanes_select(_m499, _o500.last, last);
                mode = lanes_select(_m499, _o500.mode, mode);
                held = lanes_select(_m499, _o500.held, held);
                rolls = lanes_select(_m499, _o500.rolls, rolls);
            }
            const LANES(court_displacement_out) _o501 =
                LANES(court_displacement)(late, when, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[165]));
            V slack = _o501.margin;
            const LANES(court_here_out) _o502 =
                LANES(court_here)(K(3.0), which);
            M here = _o502.here;
            const M _m503 = lanes_both(rows, here);
            {
                const LANES(court_end_bounds_out) _o504 =
                    LANES(court_end_bounds)(x, y, lanes_load(lists->fixed[7]));
                V g0 = _o504.g0;
                const LANES(court_end_reached_out) _o505 =
                    LANES(court_end_reached)(g0, through);
                reached = lanes_select(_m503, _o505.reached, reached);
                const LANES(court_end_edge_out) _o506 =
                    LANES(court_end_edge)(g0, slack, through);
                edge = lanes_choose(_m503, _o506.edge, edge);
            }
            const LANES(court_doubted_in_contact_out) _o507 =
                LANES(court_doubted_in_contact)(assured, doubt, edge, last, late, uncertain, when, which);
            uncertain = _o507.uncertain;
            const LANES(court_accounted_out) _o508 =
                LANES(court_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o508.contacts;
            V outcome = _o508.outcome;
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
            const LANES(court_meeting_out) _o509 =
                LANES(court_meeting)(claims, ends, touches);
            M meeting = _o509.meeting;
            const LANES(court_unslowed_out) _o510 =
                LANES(court_unslowed)();
            M slow = _o510.slow;
            const M _m511 = lanes_both(rows, meeting);
            if (lanes_any(_m511)) {
                const LANES(court_end_normal_out) _o512 =
                    LANES(court_end_normal)();
                V nx = _o512.nx;
                V ny = _o512.ny;
                V nz = _o512.nz;
                const LANES(court_here_out) _o513 =
                    LANES(court_here)(K(0.0), which);
                M here = _o513.here;
                const M _m514 = lanes_both(_m511, here);
                {
                    const LANES(court_ring_normal_out) _o515 =
                        LANES(court_ring_normal)(x, y, z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[111]));
                    nx = lanes_select(_m514, _o515.nx, nx);
                    ny = lanes_select(_m514, _o515.ny, ny);
                    nz = lanes_select(_m514, _o515.nz, nz);
                    const LANES(court_counted_out) _o516 =
                        LANES(court_counted)(count_0);
                    count_0 = lanes_select(_m514, _o516.count, count_0);
                }
                const LANES(court_here_out) _o517 =
                    LANES(court_here)(K(1.0), which);
                here = _o517.here;
                const M _m518 = lanes_both(_m511, here);
                {
                    const LANES(court_backboard_normal_out) _o519 =
                        LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[15]));
                    nx = lanes_select(_m518, _o519.nx, nx);
                    ny = lanes_select(_m518, _o519.ny, ny);
                    nz = lanes_select(_m518, _o519.nz, nz);
                    const LANES(court_counted_out) _o520 =
                        LANES(court_counted)(count_1);
                    count_1 = lanes_select(_m518, _o520.count, count_1);
                }
                const LANES(court_here_out) _o521 =
                    LANES(court_here)(K(2.0), which);
                here = _o521.here;
                const M _m522 = lanes_both(_m511, here);
                {
                    const LANES(court_bridge_normal_out) _o523 =
                        LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[16]));
                    nx = lanes_select(_m522, _o523.nx, nx);
                    ny = lanes_select(_m522, _o523.ny, ny);
                    nz = lanes_select(_m522, _o523.nz, nz);
                    const LANES(court_counted_out) _o524 =
                        LANES(court_counted)(count_2);
                    count_2 = lanes_select(_m522, _o524.count, count_2);
                }
                const LANES(court_elsewhere_out) _o525 =
                    LANES(court_elsewhere)();
                V curving = _o525.curving;
                const LANES(court_anew_out) _o526 =
                    LANES(court_anew)();
                V left_nx = _o526.left_nx;
                V left_ny = _o526.left_ny;
                V left_nz = _o526.left_nz;
                const LANES(court_again_out) _o527 =
                    LANES(court_again)(K(0.0), last, which);
                M again = _o527.again;
                const M _m528 = lanes_both(_m511, again);
                if (lanes_any(_m528)) {
                    const LANES(court_ring_curvature_out) _o529 =
                        LANES(court_ring_curvature)(lanes_load(lists->fixed[166]));
                    curving = lanes_select(_m528, _o529.curvature, curving);
                    const LANES(court_started_out) _o530 =
                        LANES(court_started)(when, vx, vy, vz, x, y, z, lanes_load(lists->fixed[33]));
                    V from_x = _o530.from_x;
                    V from_y = _o530.from_y;
                    V from_z = _o530.from_z;
                    const LANES(court_ring_normal_out) _o531 =
                        LANES(court_ring_normal)(from_x, from_y, from_z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[111]));
                    left_nx = lanes_select(_m528, _o531.nx, left_nx);
                    left_ny = lanes_select(_m528, _o531.ny, left_ny);
                    left_nz = lanes_select(_m528, _o531.nz, left_nz);
                }
                const LANES(court_again_out) _o532 =
                    LANES(court_again)(K(1.0), last, which);
                again = _o532.again;
                const M _m533 = lanes_both(_m511, again);
                if (lanes_any(_m533)) {
                    const LANES(court_backboard_curvature_out) _o534 =
                        LANES(court_backboard_curvature)(lanes_load(lists->fixed[112]));
                    curving = lanes_select(_m533, _o534.curvature, curving);
                    const LANES(court_started_out) _o535 =
                        LANES(court_started)(when, vx, vy, vz, x, y, z, lanes_load(lists->fixed[33]));
                    V from_x = _o535.from_x;
                    V from_y = _o535.from_y;
                    V from_z = _o535.from_z;
                    const LANES(court_backboard_normal_out) _o536 =
                        LANES(court_backboard_normal)(from_x, from_y, from_z, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[15]));
                    left_nx = lanes_select(_m533, _o536.nx, left_nx);
                    left_ny = lanes_select(_m533, _o536.ny, left_ny);
                    left_nz = lanes_select(_m533, _o536.nz, left_nz);
                }
                const LANES(court_again_out) _o537 =
                    LANES(court_again)(K(2.0), last, which);
                again = _o537.again;
                const M _m538 = lanes_both(_m511, again);
                if (lanes_any(_m538)) {
                    const LANES(court_bridge_curvature_out) _o539 =
                        LANES(court_bridge_curvature)(lanes_load(lists->fixed[112]));
                    curving = lanes_select(_m538, _o539.curvature, curving);
                    const LANES(court_started_out) _o540 =
                        LANES(court_started)(when, vx, vy, vz, x, y, z, lanes_load(lists->fixed[33]));
                    V from_x = _o540.from_x;
                    V from_y = _o540.from_y;
                    V from_z = _o540.from_z;
                    const LANES(court_bridge_normal_out) _o541 =
                        LANES(court_bridge_normal)(from_x, from_y, from_z, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[16]));
                    left_nx = lanes_select(_m538, _o541.nx, left_nx);
                    left_ny = lanes_select(_m538, _o541.ny, left_ny);
                    left_nz = lanes_select(_m538, _o541.nz, left_nz);
                }
                const LANES(court_carry_flight_out) _o542 =
                    LANES(court_carry_flight)(when, x, y, z, vx, vy, vz, nx, ny, nz, clock, contacts, late, dx, dy, dz, dvx, dvy, dvz, left_nx, left_ny, left_nz, curving, lanes_load(lists->fixed[21]));
                dx = lanes_select(_m511, _o542.dx, dx);
                dy = lanes_select(_m511, _o542.dy, dy);
                dz = lanes_select(_m511, _o542.dz, dz);
                V lifting = _o542.lifting;
                dvx = lanes_select(_m511, _o542.dvx, dvx);
                dvy = lanes_select(_m511, _o542.dvy, dvy);
                dvz = lanes_select(_m511, _o542.dvz, dvz);
                V belated = _o542.delay;
                V shift = _o542.shift;
                const LANES(court_delayed_out) _o543 =
                    LANES(court_delayed)(clock_error, belated);
                clock_error = lanes_select(_m511, _o543.clock_error, clock_error);
                const M _m544 = lanes_both(_m511, ends);
                {
                    const LANES(court_floored_out) _o545 =
                        LANES(court_floored)(dx, dy, dz, shift);
                    dx = lanes_select(_m544, _o545.dx, dx);
                    dy = lanes_select(_m544, _o545.dy, dy);
                    dz = lanes_select(_m544, _o545.dz, dz);
                }
                const LANES(court_unturned_out) _o546 =
                    LANES(court_unturned)();
                V dnx = _o546.dnx;
                V dny = _o546.dny;
                V dnz = _o546.dnz;
                V turn = _o546.turn;
                const LANES(court_here_out) _o547 =
                    LANES(court_here)(K(0.0), which);
                here = _o547.here;
                const M _m548 = lanes_both(_m511, here);
                if (lanes_any(_m548)) {
                    const LANES(court_ring_carry_normal_out) _o549 =
                        LANES(court_ring_carry_normal)(x, y, dx, dy, dz, shift, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[166]));
                    dnx = lanes_select(_m548, _o549.dnx, dnx);
                    dny = lanes_select(_m548, _o549.dny, dny);
                    dnz = lanes_select(_m548, _o549.dnz, dnz);
                    turn = lanes_select(_m548, _o549.turn, turn);
                }
                const LANES(court_here_out) _o550 =
                    LANES(court_here)(K(1.0), which);
                here = _o550.here;
                const M _m551 = lanes_both(_m511, here);
                {
                    const LANES(court_backboard_carry_normal_out) _o552 =
                        LANES(court_backboard_carry_normal)(x, y, z, dx, dy, dz, shift, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[15]));
                    dnx = lanes_select(_m551, _o552.dnx, dnx);
                    dny = lanes_select(_m551, _o552.dny, dny);
                    dnz = lanes_select(_m551, _o552.dnz, dnz);
                    turn = lanes_select(_m551, _o552.turn, turn);
                }
                const LANES(court_here_out) _o553 =
                    LANES(court_here)(K(2.0), which);
                here = _o553.here;
                const M _m554 = lanes_both(_m511, here);
                {
                    const LANES(court_bridge_carry_normal_out) _o555 =
                        LANES(court_bridge_carry_normal)(x, y, z, dx, dy, dz, shift, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[16]));
                    dnx = lanes_select(_m554, _o555.dnx, dnx);
                    dny = lanes_select(_m554, _o555.dny, dny);
                    dnz = lanes_select(_m554, _o555.dnz, dnz);
                    turn = lanes_select(_m554, _o555.turn, turn);
                }
                const LANES(court_untaken_out) _o556 =
                    LANES(court_untaken)();
                M struck_0 = _o556.mine;
                const LANES(court_ring_impact_taken_out) _o557 =
                    LANES(court_ring_impact_taken)(p_ring_restitution, p_ring_friction);
                V its_0_ring_impact = _o557.its_0;
                V its_1_ring_impact = _o557.its_1;
                {
                    const double *const _t559[][2] = {
                        {lists->p_ring_friction, lists->p_ring_restitution},
                        {lists->p_backboard_friction, lists->p_backboard_restitution},
                        {lists->p_bridge_friction, lists->p_bridge_restitution},
                    };
                    static const double _t560[][1] = {
                        {0.0},
                        {1.0},
                        {2.0},
                    };
                    for (size_t _k558 = 0; _k558 < 3; _k558++) {
                        const V own_1 = lanes_load(_t559[_k558][0] + (i & varying));
                        const V own_2 = lanes_load(_t559[_k558][1] + (i & varying));
                        const V own_index = K(_t560[_k558][0]);
                        const LANES(court_here_out) _o561 =
                            LANES(court_here)(own_index, which);
                        M here = _o561.here;
                        const M _m562 = lanes_both(_m511, here);
                        if (lanes_any(_m562)) {
                            const LANES(court_ring_impact_taken_out) _o563 =
                                LANES(court_ring_impact_taken)(own_2, own_1);
                            struck_0 = lanes_choose(_m562, _o563.mine, struck_0);
                            its_0_ring_impact = lanes_select(_m562, _o563.its_0, its_0_ring_impact);
                            its_1_ring_impact = lanes_select(_m562, _o563.its_1, its_1_ring_impact);
                        }
                    }
                }
                const M _m564 = lanes_both(_m511, struck_0);
                if (lanes_any(_m564)) {
                    const LANES(court_ring_impact_doubt_out) _o565 =
                        LANES(court_ring_impact_doubt)(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, turn, its_0_ring_impact, its_1_ring_impact, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[167]), lanes_load(lists->fixed[168]));
                    M unsure = _o565.unsure;
                    const LANES(court_undecided_out) _o566 =
                        LANES(court_undecided)(uncertain, unsure);
                    uncertain = lanes_select(_m564, _o566.uncertain, uncertain);
                    const LANES(court_carry_ring_impact_out) _o567 =
                        LANES(court_carry_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, dnx, dny, dnz, turn, lifting, its_0_ring_impact, its_1_ring_impact, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[167]), lanes_load(lists->fixed[168]), lanes_load(lists->fixed[169]), lanes_load(lists->fixed[112]));
                    dvx = lanes_select(_m564, _o567.dvx, dvx);
                    dvy = lanes_select(_m564, _o567.dvy, dvy);
                    dvz = lanes_select(_m564, _o567.dvz, dvz);
                    dwx = lanes_select(_m564, _o567.dwx, dwx);
                    dwy = lanes_select(_m564, _o567.dwy, dwy);
                    dwz = lanes_select(_m564, _o567.dwz, dwz);
                    const LANES(court_ring_impact_out) _o568 =
                        LANES(court_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, its_0_ring_impact, its_1_ring_impact, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[167]), lanes_load(lists->fixed[168]), lanes_load(lists->fixed[169]));
                    vx = lanes_select(_m564, _o568.vx, vx);
                    vy = lanes_select(_m564, _o568.vy, vy);
                    vz = lanes_select(_m564, _o568.vz, vz);
                    wx = lanes_select(_m564, _o568.wx, wx);
                    wy = lanes_select(_m564, _o568.wy, wy);
                    wz = lanes_select(_m564, _o568.wz, wz);
                }
                const M _m569 = lanes_both(_m511, touches);
                {
                    const LANES(court_touched_out) _o570 =
                        LANES(court_touched)(body, first, which);
                    first = lanes_select(_m569, _o570.first, first);
                    last = lanes_select(_m569, _o570.last, last);
                    const LANES(court_slowed_out) _o571 =
                        LANES(court_slowed)(nx, ny, nz, position_error, vx, vy, vz, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[170]), lanes_load(lists->fixed[171]));
                    slow = lanes_choose(_m569, _o571.slow, slow);
                    assured = lanes_select(_m569, _o571.assured, assured);
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
                if (LANES_SELDOM(varying)) {
                    lanes_pack(lists->slow_p_backboard_friction + slow_shots, packed, lanes_load(lists->p_backboard_friction + (i & varying)));
                    lanes_pack(lists->slow_p_backboard_restitution + slow_shots, packed, lanes_load(lists->p_backboard_restitution + (i & varying)));
                    lanes_pack(lists->slow_p_ball_radius + slow_shots, packed, lanes_load(lists->p_ball_radius + (i & varying)));
                    lanes_pack(lists->slow_p_board_bottom + slow_shots, packed, lanes_load(lists->p_board_bottom + (i & varying)));
                    lanes_pack(lists->slow_p_board_distance + slow_shots, packed, lanes_load(lists->p_board_distance + (i & varying)));
                    lanes_pack(lists->slow_p_board_half_width + slow_shots, packed, lanes_load(lists->p_board_half_width + (i & varying)));
                    lanes_pack(lists->slow_p_board_thickness + slow_shots, packed, lanes_load(lists->p_board_thickness + (i & varying)));
                    lanes_pack(lists->slow_p_board_top + slow_shots, packed, lanes_load(lists->p_board_top + (i & varying)));
                    lanes_pack(lists->slow_p_bridge_depth + slow_shots, packed, lanes_load(lists->p_bridge_depth + (i & varying)));
                    lanes_pack(lists->slow_p_bridge_friction + slow_shots, packed, lanes_load(lists->p_bridge_friction + (i & varying)));
                    lanes_pack(lists->slow_p_bridge_half_width + slow_shots, packed, lanes_load(lists->p_bridge_half_width + (i & varying)));
                    lanes_pack(lists->slow_p_bridge_restitution + slow_shots, packed, lanes_load(lists->p_bridge_restitution + (i & varying)));
                    lanes_pack(lists->slow_p_end_depth + slow_shots, packed, lanes_load(lists->p_end_depth + (i & varying)));
                    lanes_pack(lists->slow_p_gravity + slow_shots, packed, lanes_load(lists->p_gravity + (i & varying)));
                    lanes_pack(lists->slow_p_ring_friction + slow_shots, packed, lanes_load(lists->p_ring_friction + (i & varying)));
                    lanes_pack(lists->slow_p_ring_radius + slow_shots, packed, lanes_load(lists->p_ring_radius + (i & varying)));
                    lanes_pack(lists->slow_p_ring_restitution + slow_shots, packed, lanes_load(lists->p_ring_restitution + (i & varying)));
                    lanes_pack(lists->slow_p_wire_radius + slow_shots, packed, lanes_load(lists->p_wire_radius + (i & varying)));
                }
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
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f624)(lists, i);
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
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V when = lanes_load(lists->when + i);
            V which = lanes_load(lists->which + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const M _m625 = lanes_both(rows, limited);
            if (lanes_any(_m625)) {
                const LANES(court_timed_out) _o626 =
                    LANES(court_timed)(claims, K(4.0), which);
                M timed = _o626.timed;
                const M _m627 = lanes_both(_m625, timed);
                if (lanes_any(_m627)) {
                    const LANES(court_carry_time_out) _o628 =
                        LANES(court_carry_time)(when, x, y, z, vx, vy, vz, clock, clock_error, dx, dy, dz, dvx, dvy, dvz, lanes_load(lists->fixed[21]), lanes_load(lists->fixed[53]));
                    dx = lanes_select(_m627, _o628.dx, dx);
                    dy = lanes_select(_m627, _o628.dy, dy);
                    dz = lanes_select(_m627, _o628.dz, dz);
                    dvx = lanes_select(_m627, _o628.dvx, dvx);
                    dvy = lanes_select(_m627, _o628.dvy, dvy);
                    dvz = lanes_select(_m627, _o628.dvz, dvz);
                    clock_error = lanes_select(_m627, _o628.clock_error, clock_error);
                }
                lanes_store(lists->clock_error + i, clock_error);
                lanes_store(lists->dvx + i, dvx);
                lanes_store(lists->dvy + i, dvy);
                lanes_store(lists->dvz + i, dvz);
            }
            const M _m629 = lanes_both(rows, hopped);
            if (lanes_any(_m629)) {
                const LANES(court_carry_hop_out) _o630 =
                    LANES(court_carry_hop)(dvx, dvy, dvz, dx, dy, dz, vx, vy, vz, when, x, y, z);
                dx = lanes_select(_m629, _o630.dx, dx);
                dy = lanes_select(_m629, _o630.dy, dy);
                dz = lanes_select(_m629, _o630.dz, dz);
            }
            const LANES(court_closing_out) _o631 =
                LANES(court_closing)(claims, outcome);
            M closed = _o631.closed;
            V position_claim = _o631.position_claim;
            V velocity_claim = _o631.velocity_claim;
            V spin_claim = _o631.spin_claim;
            V time_claim = _o631.time_claim;
            const M _m632 = lanes_both(rows, closed);
            if (lanes_any(_m632)) {
                const LANES(court_claimed_errors_out) _o633 =
                    LANES(court_claimed_errors)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
                position_claim = lanes_select(_m632, _o633.position_error, position_claim);
                velocity_claim = lanes_select(_m632, _o633.velocity_error, velocity_claim);
                spin_claim = lanes_select(_m632, _o633.spin_error, spin_claim);
                time_claim = lanes_select(_m632, _o633.time_error, time_claim);
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

/* Run the job; return 0 if there is no memory for it. */
static int LANES(court_run)(const court_job *job)
{
    const court_results *out = job->results;
    const int bounds = out->grip_lost || out->time_error || out->state_error || out->uncertain;
    /* Not on the stack: they may be megabytes, and threads have little of it. */
    const size_t size = bounds ? sizeof(LANES(court_bounded_lists)) : sizeof(LANES(court_plain_lists));
    void *const room = malloc(size + 63);
    if (room == NULL)
        return 0;
    void *const lists = (void *)(((uintptr_t)room + 63) / 64 * 64);
    if (bounds)
        LANES(court_bounded)(job, lists);
    else
        LANES(court_plain)(job, lists);
    free(room);
    return 1;
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
