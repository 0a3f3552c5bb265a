/* The event loop of the scene court, LANES_WIDTH shots abreast.

   Generated from templates/c/engine.h.j2, scene court, derivation 17608efa79d077d6,
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
   their results: else each store waits for its line. */
LANES_INLINE void LANES(court_ahead)(const court_job *job, size_t shot)
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
    if (out->state)
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
    (void)job, (void)shot;
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
    LANES(court_column) waiting_outcome;
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
    _Alignas(64) double fixed[169][LANES_WIDTH];
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
    if (out->state)
        for (size_t k = 0; k < shots; k++) {
            out->state[9 * (start + k) + 0] = (double)lists->x[k];
            out->state[9 * (start + k) + 1] = (double)lists->y[k];
            out->state[9 * (start + k) + 2] = (double)lists->z[k];
            out->state[9 * (start + k) + 3] = (double)lists->vx[k];
            out->state[9 * (start + k) + 4] = (double)lists->vy[k];
            out->state[9 * (start + k) + 5] = (double)lists->vz[k];
            out->state[9 * (start + k) + 6] = (double)lists->wx[k];
            out->state[9 * (start + k) + 7] = (double)lists->wy[k];
            out->state[9 * (start + k) + 8] = (double)lists->wz[k];
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
    lanes_pack(lists->waiting_outcome + lists->waiting, who, lanes_load(lists->outcome + row));
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
    memcpy(lists->x + row, lists->waiting_x + from, shots * sizeof(double));
    memcpy(lists->y + row, lists->waiting_y + from, shots * sizeof(double));
    memcpy(lists->z + row, lists->waiting_z + from, shots * sizeof(double));
    memcpy(lists->vx + row, lists->waiting_vx + from, shots * sizeof(double));
    memcpy(lists->vy + row, lists->waiting_vy + from, shots * sizeof(double));
    memcpy(lists->vz + row, lists->waiting_vz + from, shots * sizeof(double));
    memcpy(lists->wx + row, lists->waiting_wx + from, shots * sizeof(double));
    memcpy(lists->wy + row, lists->waiting_wy + from, shots * sizeof(double));
    memcpy(lists->wz + row, lists->waiting_wz + from, shots * sizeof(double));
    memcpy(lists->clock + row, lists->waiting_clock + from, shots * sizeof(double));
    memcpy(lists->last + row, lists->waiting_last + from, shots * sizeof(double));
    memcpy(lists->first + row, lists->waiting_first + from, shots * sizeof(double));
    memcpy(lists->contacts + row, lists->waiting_contacts + from, shots * sizeof(double));
    memcpy(lists->count_0 + row, lists->waiting_count_0 + from, shots * sizeof(double));
    memcpy(lists->count_1 + row, lists->waiting_count_1 + from, shots * sizeof(double));
    memcpy(lists->count_2 + row, lists->waiting_count_2 + from, shots * sizeof(double));
    memcpy(lists->held + row, lists->waiting_held + from, shots * sizeof(double));
    memcpy(lists->mode + row, lists->waiting_mode + from, shots * sizeof(double));
    memcpy(lists->circled + row, lists->waiting_circled + from, shots * sizeof(double));
    memcpy(lists->rolls + row, lists->waiting_rolls + from, shots * sizeof(double));
    memcpy(lists->slip_left + row, lists->waiting_slip_left + from, shots * sizeof(double));
    memcpy(lists->through + row, lists->waiting_through + from, shots * sizeof(double));
    memcpy(lists->outcome + row, lists->waiting_outcome + from, shots * sizeof(double));
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
            lanes_pack(lists->outcome + kept, going, lanes_load(lists->outcome + i));
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
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_add(p_board_distance, p_board_thickness);
        const V _s2 = lanes_abs(p_board_bottom);
        const V _s3 = lanes_abs(p_board_top);
        const V _s4 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_abs(p_ball_radius), _s2), lanes_abs(p_board_distance)), lanes_abs(p_board_half_width)), lanes_abs(p_board_thickness)), _s3);
        const V _s5 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s4, lanes_abs(p_bridge_depth)), lanes_abs(p_bridge_half_width)), lanes_abs(p_end_depth)), lanes_abs(p_ring_radius)), lanes_abs(p_wire_radius));
        const V _s6 = lanes_div(K(1.0), p_gravity);
        const V _s7 = lanes_neg(p_gravity);
        const V _s8 = lanes_neg(_s6);
        const V _s9 = lanes_sub(p_ring_radius, _s0);
        const V _s10 = lanes_mul(K(1.00006103515625), _s0);
        const V _s11 = lanes_add(p_ring_radius, _s10);
        const V _s12 = lanes_mul(_s11, _s11);
        const V _s13 = lanes_mul(K(9.313225746154785e-10), _s12);
        const V _s14 = lanes_sub(p_ring_radius, _s10);
        const V _s15 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s16 = lanes_max(_s14, _s15);
        const V _s17 = lanes_mul(_s16, _s16);
        const V _s18 = lanes_div(K(1.0), _s16);
        const V _s19 = lanes_div(_s10, _s16);
        const V _s20 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s21 = lanes_mul(K(0.5), p_board_thickness);
        const V _s22 = lanes_add(p_board_distance, _s21);
        const V _s23 = lanes_mul(K(0.5), p_board_bottom);
        const V _s24 = lanes_mul(K(0.5), p_board_top);
        const V _s25 = lanes_add(_s23, _s24);
        const V _s26 = lanes_add(p_ball_radius, _s21);
        const V _s27 = lanes_add(p_ball_radius, _s24);
        const V _s28 = lanes_sub(_s27, _s23);
        const V _s29 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s30 = lanes_min(_s29, _s26);
        const V _s31 = lanes_min(_s28, _s30);
        const V _s32 = lanes_mul(K(6.103515625e-05), _s31);
        const V _s33 = lanes_abs(_s7);
        const V _s34 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s31));
        const V _s35 = lanes_mul(K(1.25), _s33);
        const V _s36 = lanes_max(_s26, _s29);
        const V _s37 = lanes_mul(K(0.5), p_board_distance);
        const V _s38 = lanes_mul(K(0.5), p_ring_radius);
        const V _s39 = lanes_add(_s37, _s38);
        const V _s40 = lanes_mul(K(0.5), p_bridge_depth);
        const V _s41 = lanes_add(p_ball_radius, _s37);
        const V _s42 = lanes_add(p_ball_radius, _s40);
        const V _s43 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s44 = lanes_sub(_s41, _s38);
        const V _s45 = lanes_min(_s43, _s44);
        const V _s46 = lanes_min(_s42, _s45);
        const V _s47 = lanes_mul(K(6.103515625e-05), _s46);
        const V _s48 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s46));
        const V _s49 = lanes_max(_s44, _s43);
        const V _s50 = lanes_mul(K(1.4210854715202004e-14), p_ball_radius);
        const V _s51 = lanes_add(lanes_add(_s50, lanes_mul(K(2.842170943040401e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_board_thickness));
        const V _s52 = lanes_add(_s50, lanes_mul(K(2.842170943040401e-14), p_board_half_width));
        const V _s53 = lanes_add(lanes_add(_s50, lanes_mul(K(1.4210854715202004e-14), _s2)), lanes_mul(K(1.4210854715202004e-14), _s3));
        const V _s54 = lanes_add(lanes_add(_s50, lanes_mul(K(1.4210854715202004e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_ring_radius));
        const V _s55 = lanes_add(_s50, lanes_mul(K(2.842170943040401e-14), p_bridge_half_width));
        const V _s56 = lanes_add(lanes_add(_s50, lanes_mul(K(1.4210854715202004e-14), p_wire_radius)), lanes_mul(K(1.4210854715202004e-14), lanes_abs(lanes_sub(p_bridge_depth, p_wire_radius))));
        const V _s57 = lanes_neg(p_board_half_width);
        const V _s58 = lanes_max(K(0.0), _s57);
        const V _s59 = lanes_max(_s58, _s57);
        const V _s60 = lanes_neg(_s1);
        const V _s61 = lanes_max(K(0.0), _s60);
        const V _s62 = lanes_max(_s61, p_board_distance);
        const V _s63 = lanes_neg(p_board_distance);
        const V _s64 = lanes_max(K(0.0), _s63);
        const V _s65 = lanes_max(_s64, p_ring_radius);
        const V _s66 = lanes_neg(p_bridge_half_width);
        const V _s67 = lanes_max(K(0.0), _s66);
        const V _s68 = lanes_max(_s67, _s66);
        const V _s69 = lanes_mul(p_gravity, p_gravity);
        const V _s70 = lanes_add(K(0.4), lanes_mul(K(0.4), p_tangential_restitution));
        const V _s71 = lanes_sub(K(1.0), p_ring_restitution);
        const V _s72 = lanes_add(K(1.0), p_ring_restitution);
        const V _s73 = lanes_sub(K(1.0), p_backboard_restitution);
        const V _s74 = lanes_add(K(1.0), p_backboard_restitution);
        const V _s75 = lanes_sub(K(1.0), p_bridge_restitution);
        const V _s76 = lanes_add(K(1.0), p_bridge_restitution);
        lanes_store(lists->fixed[0], p_ball_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[8], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[9], _s1);
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[11], lanes_add(lanes_mul(K(4.0), p_ball_radius), lanes_mul(K(4.0), p_wire_radius)));
        lanes_store(lists->fixed[12], _s5);
        lanes_store(lists->fixed[13], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[14], lanes_mul(p_ring_radius, p_ring_radius));
        lanes_store(lists->fixed[15], _s6);
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[18], _s7);
        lanes_store(lists->fixed[19], _s8);
        lanes_store(lists->fixed[20], lanes_mul(K(0.5), _s8));
        lanes_store(lists->fixed[21], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), _s9));
        lanes_store(lists->fixed[22], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[23], lanes_mul(K(2.0), p_ball_radius));
        lanes_store(lists->fixed[24], lanes_mul(K(2.0), p_wire_radius));
        lanes_store(lists->fixed[25], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[26], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[27], _s10);
        lanes_store(lists->fixed[28], lanes_mul(K(5.820766091346741e-11), _s11));
        lanes_store(lists->fixed[29], lanes_mul(K(65536.0), _s11));
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[31], _s12);
        lanes_store(lists->fixed[32], _s13);
        lanes_store(lists->fixed[33], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[34], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s0));
        lanes_store(lists->fixed[35], _s17);
        lanes_store(lists->fixed[36], lanes_mul(_s16, _s17));
        lanes_store(lists->fixed[37], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[38], lanes_add(_s13, _s17));
        lanes_store(lists->fixed[39], lanes_mul(_s18, lanes_mul(_s18, _s18)));
        lanes_store(lists->fixed[40], _s11);
        lanes_store(lists->fixed[41], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s0), _s11));
        lanes_store(lists->fixed[42], lanes_mul(K(5.00030517578125), _s0));
        lanes_store(lists->fixed[43], lanes_max(K(1.0), _s19));
        lanes_store(lists->fixed[44], lanes_mul(K(6.0), p_gravity));
        lanes_store(lists->fixed[45], lanes_mul(K(9.094947017729282e-13), _s11));
        lanes_store(lists->fixed[46], _s16);
        lanes_store(lists->fixed[47], lanes_abs(K(0.0)));
        lanes_store(lists->fixed[48], lanes_mul(K(0.0625), p_gravity));
        lanes_store(lists->fixed[49], lanes_mul(K(1.0000000009313226), _s20));
        lanes_store(lists->fixed[50], lanes_neg(_s22));
        lanes_store(lists->fixed[51], lanes_mul(K(1.0000000009313226), _s21));
        lanes_store(lists->fixed[52], lanes_mul(K(1.0000000009313226), p_board_half_width));
        lanes_store(lists->fixed[53], _s25);
        lanes_store(lists->fixed[54], lanes_mul(K(1.0000000009313226), lanes_sub(_s24, _s23)));
        lanes_store(lists->fixed[55], _s24);
        lanes_store(lists->fixed[56], _s23);
        lanes_store(lists->fixed[57], _s31);
        lanes_store(lists->fixed[58], lanes_add(_s26, _s32));
        lanes_store(lists->fixed[59], _s22);
        lanes_store(lists->fixed[60], lanes_add(_s29, _s32));
        lanes_store(lists->fixed[61], lanes_sub(lanes_add(_s27, _s32), _s23));
        lanes_store(lists->fixed[62], lanes_mul(_s35, _s34));
        lanes_store(lists->fixed[63], lanes_abs(_s25));
        lanes_store(lists->fixed[64], lanes_max(_s36, _s28));
        lanes_store(lists->fixed[65], lanes_mul(K(1.52587890625e-05), _s31));
        lanes_store(lists->fixed[66], lanes_mul(K(5.55653613398821e-16), _s20));
        lanes_store(lists->fixed[67], _s34);
        lanes_store(lists->fixed[68], lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        lanes_store(lists->fixed[69], lanes_mul(K(2.001953125), _s34));
        lanes_store(lists->fixed[70], lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        lanes_store(lists->fixed[71], lanes_add(lanes_mul(K(2.220446049250313e-16), _s2), lanes_mul(K(2.220446049250313e-16), _s3)));
        lanes_store(lists->fixed[72], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s34, _s34)));
        lanes_store(lists->fixed[73], lanes_mul(K(12.01171875), _s34));
        lanes_store(lists->fixed[74], lanes_mul(K(6.667843360785852e-15), _s34));
        lanes_store(lists->fixed[75], lanes_mul(K(6.005859375), _s34));
        lanes_store(lists->fixed[76], lanes_mul(K(2.667137344314341e-15), _s34));
        lanes_store(lists->fixed[77], _s20);
        lanes_store(lists->fixed[78], _s33);
        lanes_store(lists->fixed[79], lanes_mul(K(0.5), _s33));
        lanes_store(lists->fixed[80], lanes_neg(_s39));
        lanes_store(lists->fixed[81], lanes_mul(K(1.0000000009313226), lanes_sub(_s37, _s38)));
        lanes_store(lists->fixed[82], lanes_mul(K(1.0000000009313226), p_bridge_half_width));
        lanes_store(lists->fixed[83], lanes_sub(p_wire_radius, _s40));
        lanes_store(lists->fixed[84], lanes_mul(K(1.0000000009313226), _s40));
        lanes_store(lists->fixed[85], _s37);
        lanes_store(lists->fixed[86], _s40);
        lanes_store(lists->fixed[87], _s38);
        lanes_store(lists->fixed[88], _s46);
        lanes_store(lists->fixed[89], lanes_sub(lanes_add(_s41, _s47), _s38));
        lanes_store(lists->fixed[90], _s39);
        lanes_store(lists->fixed[91], lanes_add(_s43, _s47));
        lanes_store(lists->fixed[92], lanes_add(_s42, _s47));
        lanes_store(lists->fixed[93], lanes_mul(_s35, _s48));
        lanes_store(lists->fixed[94], lanes_abs(lanes_sub(_s40, p_wire_radius)));
        lanes_store(lists->fixed[95], lanes_max(_s49, _s42));
        lanes_store(lists->fixed[96], lanes_mul(K(1.52587890625e-05), _s46));
        lanes_store(lists->fixed[97], _s48);
        lanes_store(lists->fixed[98], lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        lanes_store(lists->fixed[99], lanes_mul(K(2.001953125), _s48));
        lanes_store(lists->fixed[100], lanes_add(lanes_mul(K(1.1102230246251565e-16), p_board_distance), lanes_mul(K(1.1102230246251565e-16), p_ring_radius)));
        lanes_store(lists->fixed[101], lanes_add(lanes_mul(K(2.220446049250313e-16), p_bridge_depth), lanes_mul(K(5.551115123125783e-16), p_wire_radius)));
        lanes_store(lists->fixed[102], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s48, _s48)));
        lanes_store(lists->fixed[103], lanes_mul(K(12.01171875), _s48));
        lanes_store(lists->fixed[104], lanes_mul(K(6.667843360785852e-15), _s48));
        lanes_store(lists->fixed[105], lanes_mul(K(6.005859375), _s48));
        lanes_store(lists->fixed[106], lanes_mul(K(2.667137344314341e-15), _s48));
        lanes_store(lists->fixed[107], lanes_div(K(1.0), _s0));
        lanes_store(lists->fixed[108], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[109], _s51);
        lanes_store(lists->fixed[110], lanes_neg(_s51));
        lanes_store(lists->fixed[111], _s52);
        lanes_store(lists->fixed[112], lanes_neg(_s52));
        lanes_store(lists->fixed[113], _s53);
        lanes_store(lists->fixed[114], lanes_neg(_s53));
        lanes_store(lists->fixed[115], _s54);
        lanes_store(lists->fixed[116], lanes_neg(_s54));
        lanes_store(lists->fixed[117], _s55);
        lanes_store(lists->fixed[118], lanes_neg(_s55));
        lanes_store(lists->fixed[119], _s56);
        lanes_store(lists->fixed[120], lanes_neg(_s56));
        lanes_store(lists->fixed[121], lanes_mul(K(0.6), p_gravity));
        lanes_store(lists->fixed[122], lanes_mul(K(0.015625), p_gravity));
        lanes_store(lists->fixed[123], lanes_mul(K(0.4), p_gravity));
        lanes_store(lists->fixed[124], lanes_mul(K(5.684341886080802e-14), lanes_sqrt(lanes_mul(p_ball_radius, p_gravity))));
        lanes_store(lists->fixed[125], lanes_mul(K(5.684341886080802e-14), p_gravity));
        lanes_store(lists->fixed[126], _s0);
        lanes_store(lists->fixed[127], lanes_mul(K(3.637978807091713e-12), p_ball_radius));
        lanes_store(lists->fixed[128], p_bridge_depth);
        lanes_store(lists->fixed[129], lanes_mul(K(0.3333333333333333), p_ring_radius));
        lanes_store(lists->fixed[130], lanes_mul(K(0.25), p_ring_radius));
        lanes_store(lists->fixed[131], lanes_mul(K(0.2), p_ring_radius));
        lanes_store(lists->fixed[132], lanes_mul(K(0.16666666666666666), p_ring_radius));
        lanes_store(lists->fixed[133], lanes_mul(K(0.14285714285714285), p_ring_radius));
        lanes_store(lists->fixed[134], lanes_mul(K(0.125), p_ring_radius));
        lanes_store(lists->fixed[135], lanes_mul(K(0.1111111111111111), p_ring_radius));
        lanes_store(lists->fixed[136], lanes_mul(K(0.1), p_ring_radius));
        lanes_store(lists->fixed[137], lanes_mul(K(0.09090909090909091), p_ring_radius));
        lanes_store(lists->fixed[138], lanes_mul(K(0.08333333333333333), p_ring_radius));
        lanes_store(lists->fixed[139], lanes_sqrt(lanes_div(p_gravity, _s0)));
        lanes_store(lists->fixed[140], lanes_div(K(1.0), _s9));
        lanes_store(lists->fixed[141], lanes_mul(K(0.8), p_gravity));
        lanes_store(lists->fixed[142], lanes_sqrt(lanes_add(lanes_mul(_s59, _s59), lanes_mul(_s62, _s62))));
        lanes_store(lists->fixed[143], lanes_sqrt(lanes_add(lanes_mul(_s65, _s65), lanes_mul(_s68, _s68))));
        lanes_store(lists->fixed[144], lanes_mul(K(0.000244140625), _s0));
        lanes_store(lists->fixed[145], lanes_mul(K(0.00390625), p_gravity));
        lanes_store(lists->fixed[146], lanes_mul(lanes_mul(K(0.000244140625), _s69), _s0));
        lanes_store(lists->fixed[147], lanes_mul(K(6.0), _s69));
        lanes_store(lists->fixed[148], lanes_mul(K(0.0078125), p_gravity));
        lanes_store(lists->fixed[149], lanes_max(K(0.0), p_gravity));
        lanes_store(lists->fixed[150], p_restitution_speed);
        lanes_store(lists->fixed[151], _s70);
        lanes_store(lists->fixed[152], lanes_mul(_s70, _s70));
        lanes_store(lists->fixed[153], lanes_mul(K(7.275957614183426e-12), p_ball_radius));
        lanes_store(lists->fixed[154], lanes_mul(K(1.1920928955078125e-07), p_ball_radius));
        lanes_store(lists->fixed[155], lanes_mul(K(0.4), p_ball_radius));
        lanes_store(lists->fixed[156], _s71);
        lanes_store(lists->fixed[157], lanes_mul(_s71, _s71));
        lanes_store(lists->fixed[158], lanes_mul(p_ring_friction, _s72));
        lanes_store(lists->fixed[159], lanes_mul(_s72, _s71));
        lanes_store(lists->fixed[160], lanes_mul(K(3.725290298461914e-09), p_ball_radius));
        lanes_store(lists->fixed[161], _s73);
        lanes_store(lists->fixed[162], lanes_mul(_s73, _s73));
        lanes_store(lists->fixed[163], lanes_mul(p_backboard_friction, _s74));
        lanes_store(lists->fixed[164], lanes_mul(_s74, _s73));
        lanes_store(lists->fixed[165], _s75);
        lanes_store(lists->fixed[166], lanes_mul(_s75, _s75));
        lanes_store(lists->fixed[167], lanes_mul(p_bridge_friction, _s76));
        lanes_store(lists->fixed[168], lanes_mul(_s76, _s75));
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
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_abs(p_ball_radius), lanes_abs(p_board_bottom)), lanes_abs(p_board_distance)), lanes_abs(p_board_half_width)), lanes_abs(p_board_thickness)), lanes_abs(p_board_top));
        const V _s2 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s1, lanes_abs(p_bridge_depth)), lanes_abs(p_bridge_half_width)), lanes_abs(p_end_depth)), lanes_abs(p_ring_radius)), lanes_abs(p_wire_radius));
        lanes_store(lists->fixed[0], p_ball_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[8], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[11], lanes_add(lanes_mul(K(4.0), p_ball_radius), lanes_mul(K(4.0), p_wire_radius)));
        lanes_store(lists->fixed[12], _s2);
        lanes_store(lists->fixed[13], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[14], lanes_mul(p_ring_radius, p_ring_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f6)(LANES(court_plain_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[8], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[13], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[15], _s1);
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[18], lanes_neg(p_gravity));
        lanes_store(lists->fixed[19], _s2);
        lanes_store(lists->fixed[20], lanes_mul(K(0.5), _s2));
        lanes_store(lists->fixed[21], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s0)));
        lanes_store(lists->fixed[22], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[23], lanes_mul(K(2.0), p_ball_radius));
        lanes_store(lists->fixed[24], lanes_mul(K(2.0), p_wire_radius));
        lanes_store(lists->fixed[25], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[26], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[27], _s3);
        lanes_store(lists->fixed[28], lanes_mul(K(5.820766091346741e-11), _s4));
        lanes_store(lists->fixed[29], lanes_mul(K(65536.0), _s4));
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[31], _s5);
        lanes_store(lists->fixed[32], _s6);
        lanes_store(lists->fixed[33], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[34], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s0));
        lanes_store(lists->fixed[35], _s10);
        lanes_store(lists->fixed[36], lanes_mul(_s9, _s10));
        lanes_store(lists->fixed[37], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[38], lanes_add(_s6, _s10));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f21)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->open_p_ball_radius + i);
    const V p_gravity = lanes_load(lists->open_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->open_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->open_p_wire_radius + i);
    {
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
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
static void LANES(court_plain_fix_f32)(LANES(court_plain_lists) *lists, size_t taken, M idle)
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
static void LANES(court_plain_fix_f35)(LANES(court_plain_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[15], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[21], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s0)));
        lanes_store(lists->fixed[22], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[23], lanes_mul(K(2.0), p_ball_radius));
        lanes_store(lists->fixed[24], lanes_mul(K(2.0), p_wire_radius));
        lanes_store(lists->fixed[25], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[26], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[27], _s1);
        lanes_store(lists->fixed[31], lanes_mul(_s2, _s2));
        lanes_store(lists->fixed[33], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[34], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s0));
        lanes_store(lists->fixed[35], lanes_mul(_s5, _s5));
        lanes_store(lists->fixed[37], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[39], lanes_mul(_s6, lanes_mul(_s6, _s6)));
        lanes_store(lists->fixed[40], _s2);
        lanes_store(lists->fixed[41], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s0), _s2));
        lanes_store(lists->fixed[42], lanes_mul(K(5.00030517578125), _s0));
        lanes_store(lists->fixed[43], lanes_max(K(1.0), _s7));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f40)(LANES(court_plain_lists) *lists, size_t taken, M idle)
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
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[8], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[27], _s1);
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[40], _s2);
        lanes_store(lists->fixed[41], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s0), _s2));
        lanes_store(lists->fixed[42], lanes_mul(K(5.00030517578125), _s0));
        lanes_store(lists->fixed[43], lanes_max(K(1.0), _s6));
        lanes_store(lists->fixed[44], lanes_mul(K(6.0), p_gravity));
        lanes_store(lists->fixed[45], lanes_mul(K(9.094947017729282e-13), _s2));
        lanes_store(lists->fixed[46], _s5);
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f51)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->open_p_ball_radius + i);
    const V p_gravity = lanes_load(lists->open_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->open_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->open_p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[8], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f60)(LANES(court_plain_lists) *lists, size_t taken, M idle)
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
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[8], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f65)(LANES(court_plain_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[15], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[47], lanes_abs(K(0.0)));
        lanes_store(lists->fixed[48], lanes_mul(K(0.0625), p_gravity));
        lanes_store(lists->fixed[49], lanes_mul(K(1.0000000009313226), lanes_mul(p_ball_radius, p_ball_radius)));
        lanes_store(lists->fixed[50], lanes_neg(lanes_add(p_board_distance, _s0)));
        lanes_store(lists->fixed[51], lanes_mul(K(1.0000000009313226), _s0));
        lanes_store(lists->fixed[52], lanes_mul(K(1.0000000009313226), p_board_half_width));
        lanes_store(lists->fixed[53], lanes_add(_s1, _s2));
        lanes_store(lists->fixed[54], lanes_mul(K(1.0000000009313226), lanes_sub(_s2, _s1)));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f70)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->reachable_p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->reachable_p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->reachable_p_board_thickness + i);
    const V p_board_top = lanes_load(lists->reachable_p_board_top + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    {
        const V _s0 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s1 = lanes_mul(K(0.5), p_board_thickness);
        const V _s2 = lanes_mul(K(0.5), p_board_bottom);
        const V _s3 = lanes_mul(K(0.5), p_board_top);
        const V _s4 = lanes_add(p_ball_radius, _s1);
        const V _s5 = lanes_add(p_ball_radius, _s3);
        const V _s6 = lanes_sub(_s5, _s2);
        const V _s7 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s8 = lanes_min(_s7, _s4);
        const V _s9 = lanes_min(_s6, _s8);
        const V _s10 = lanes_mul(K(6.103515625e-05), _s9);
        const V _s11 = lanes_abs(lanes_neg(p_gravity));
        const V _s12 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s9));
        const V _s13 = lanes_max(_s4, _s7);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[15], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[22], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[55], _s3);
        lanes_store(lists->fixed[56], _s2);
        lanes_store(lists->fixed[57], _s9);
        lanes_store(lists->fixed[58], lanes_add(_s4, _s10));
        lanes_store(lists->fixed[59], lanes_add(p_board_distance, _s1));
        lanes_store(lists->fixed[60], lanes_add(_s7, _s10));
        lanes_store(lists->fixed[61], lanes_sub(lanes_add(_s5, _s10), _s2));
        lanes_store(lists->fixed[62], lanes_mul(lanes_mul(K(1.25), _s11), _s12));
        lanes_store(lists->fixed[63], lanes_abs(lanes_add(_s2, _s3)));
        lanes_store(lists->fixed[64], lanes_max(_s13, _s6));
        lanes_store(lists->fixed[65], lanes_mul(K(1.52587890625e-05), _s9));
        lanes_store(lists->fixed[66], lanes_mul(K(5.55653613398821e-16), _s0));
        lanes_store(lists->fixed[67], _s12);
        lanes_store(lists->fixed[68], lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        lanes_store(lists->fixed[69], lanes_mul(K(2.001953125), _s12));
        lanes_store(lists->fixed[70], lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        lanes_store(lists->fixed[71], lanes_add(lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_bottom)), lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_top))));
        lanes_store(lists->fixed[72], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s12, _s12)));
        lanes_store(lists->fixed[73], lanes_mul(K(12.01171875), _s12));
        lanes_store(lists->fixed[74], lanes_mul(K(6.667843360785852e-15), _s12));
        lanes_store(lists->fixed[75], lanes_mul(K(6.005859375), _s12));
        lanes_store(lists->fixed[76], lanes_mul(K(2.667137344314341e-15), _s12));
        lanes_store(lists->fixed[77], _s0);
        lanes_store(lists->fixed[78], _s11);
        lanes_store(lists->fixed[79], lanes_mul(K(0.5), _s11));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f88)(LANES(court_plain_lists) *lists, size_t taken, M idle)
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
        const V _s0 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s1 = lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_thickness));
        const V _s2 = lanes_sub(lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_top)), lanes_mul(K(0.5), p_board_bottom));
        const V _s3 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s4 = lanes_min(_s3, _s1);
        const V _s5 = lanes_abs(lanes_neg(p_gravity));
        const V _s6 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), lanes_min(_s2, _s4)));
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[66], lanes_mul(K(5.55653613398821e-16), _s0));
        lanes_store(lists->fixed[67], _s6);
        lanes_store(lists->fixed[68], lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        lanes_store(lists->fixed[69], lanes_mul(K(2.001953125), _s6));
        lanes_store(lists->fixed[70], lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        lanes_store(lists->fixed[71], lanes_add(lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_bottom)), lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_top))));
        lanes_store(lists->fixed[72], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s6, _s6)));
        lanes_store(lists->fixed[73], lanes_mul(K(12.01171875), _s6));
        lanes_store(lists->fixed[74], lanes_mul(K(6.667843360785852e-15), _s6));
        lanes_store(lists->fixed[75], lanes_mul(K(6.005859375), _s6));
        lanes_store(lists->fixed[76], lanes_mul(K(2.667137344314341e-15), _s6));
        lanes_store(lists->fixed[77], _s0);
        lanes_store(lists->fixed[78], _s5);
        lanes_store(lists->fixed[79], lanes_mul(K(0.5), _s5));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f99)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->reachable_p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->reachable_p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->reachable_p_board_thickness + i);
    const V p_board_top = lanes_load(lists->reachable_p_board_top + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    {
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[77], lanes_mul(p_ball_radius, p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f108)(LANES(court_plain_lists) *lists, size_t taken, M idle)
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
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[77], lanes_mul(p_ball_radius, p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f113)(LANES(court_plain_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[15], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[47], lanes_abs(K(0.0)));
        lanes_store(lists->fixed[48], lanes_mul(K(0.0625), p_gravity));
        lanes_store(lists->fixed[49], lanes_mul(K(1.0000000009313226), lanes_mul(p_ball_radius, p_ball_radius)));
        lanes_store(lists->fixed[80], lanes_neg(lanes_add(_s0, _s1)));
        lanes_store(lists->fixed[81], lanes_mul(K(1.0000000009313226), lanes_sub(_s0, _s1)));
        lanes_store(lists->fixed[82], lanes_mul(K(1.0000000009313226), p_bridge_half_width));
        lanes_store(lists->fixed[83], lanes_sub(p_wire_radius, _s2));
        lanes_store(lists->fixed[84], lanes_mul(K(1.0000000009313226), _s2));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f118)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_bridge_depth = lanes_load(lists->reachable_p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->reachable_p_bridge_half_width + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->reachable_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->reachable_p_wire_radius + i);
    {
        const V _s0 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s1 = lanes_abs(lanes_neg(p_gravity));
        const V _s2 = lanes_mul(K(0.5), p_board_distance);
        const V _s3 = lanes_mul(K(0.5), p_ring_radius);
        const V _s4 = lanes_mul(K(0.5), p_bridge_depth);
        const V _s5 = lanes_add(p_ball_radius, _s2);
        const V _s6 = lanes_add(p_ball_radius, _s4);
        const V _s7 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s8 = lanes_sub(_s5, _s3);
        const V _s9 = lanes_min(_s7, _s8);
        const V _s10 = lanes_min(_s6, _s9);
        const V _s11 = lanes_mul(K(6.103515625e-05), _s10);
        const V _s12 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s10));
        const V _s13 = lanes_max(_s8, _s7);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[15], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[22], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[66], lanes_mul(K(5.55653613398821e-16), _s0));
        lanes_store(lists->fixed[77], _s0);
        lanes_store(lists->fixed[78], _s1);
        lanes_store(lists->fixed[79], lanes_mul(K(0.5), _s1));
        lanes_store(lists->fixed[85], _s2);
        lanes_store(lists->fixed[86], _s4);
        lanes_store(lists->fixed[87], _s3);
        lanes_store(lists->fixed[88], _s10);
        lanes_store(lists->fixed[89], lanes_sub(lanes_add(_s5, _s11), _s3));
        lanes_store(lists->fixed[90], lanes_add(_s2, _s3));
        lanes_store(lists->fixed[91], lanes_add(_s7, _s11));
        lanes_store(lists->fixed[92], lanes_add(_s6, _s11));
        lanes_store(lists->fixed[93], lanes_mul(lanes_mul(K(1.25), _s1), _s12));
        lanes_store(lists->fixed[94], lanes_abs(lanes_sub(_s4, p_wire_radius)));
        lanes_store(lists->fixed[95], lanes_max(_s13, _s6));
        lanes_store(lists->fixed[96], lanes_mul(K(1.52587890625e-05), _s10));
        lanes_store(lists->fixed[97], _s12);
        lanes_store(lists->fixed[98], lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        lanes_store(lists->fixed[99], lanes_mul(K(2.001953125), _s12));
        lanes_store(lists->fixed[100], lanes_add(lanes_mul(K(1.1102230246251565e-16), p_board_distance), lanes_mul(K(1.1102230246251565e-16), p_ring_radius)));
        lanes_store(lists->fixed[101], lanes_add(lanes_mul(K(2.220446049250313e-16), p_bridge_depth), lanes_mul(K(5.551115123125783e-16), p_wire_radius)));
        lanes_store(lists->fixed[102], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s12, _s12)));
        lanes_store(lists->fixed[103], lanes_mul(K(12.01171875), _s12));
        lanes_store(lists->fixed[104], lanes_mul(K(6.667843360785852e-15), _s12));
        lanes_store(lists->fixed[105], lanes_mul(K(6.005859375), _s12));
        lanes_store(lists->fixed[106], lanes_mul(K(2.667137344314341e-15), _s12));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f136)(LANES(court_plain_lists) *lists, size_t taken, M idle)
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
        const V _s0 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s1 = lanes_abs(lanes_neg(p_gravity));
        const V _s2 = lanes_add(p_ball_radius, lanes_mul(K(0.5), p_bridge_depth));
        const V _s3 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s4 = lanes_sub(lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_distance)), lanes_mul(K(0.5), p_ring_radius));
        const V _s5 = lanes_min(_s3, _s4);
        const V _s6 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), lanes_min(_s2, _s5)));
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[66], lanes_mul(K(5.55653613398821e-16), _s0));
        lanes_store(lists->fixed[77], _s0);
        lanes_store(lists->fixed[78], _s1);
        lanes_store(lists->fixed[79], lanes_mul(K(0.5), _s1));
        lanes_store(lists->fixed[97], _s6);
        lanes_store(lists->fixed[98], lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        lanes_store(lists->fixed[99], lanes_mul(K(2.001953125), _s6));
        lanes_store(lists->fixed[100], lanes_add(lanes_mul(K(1.1102230246251565e-16), p_board_distance), lanes_mul(K(1.1102230246251565e-16), p_ring_radius)));
        lanes_store(lists->fixed[101], lanes_add(lanes_mul(K(2.220446049250313e-16), p_bridge_depth), lanes_mul(K(5.551115123125783e-16), p_wire_radius)));
        lanes_store(lists->fixed[102], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s6, _s6)));
        lanes_store(lists->fixed[103], lanes_mul(K(12.01171875), _s6));
        lanes_store(lists->fixed[104], lanes_mul(K(6.667843360785852e-15), _s6));
        lanes_store(lists->fixed[105], lanes_mul(K(6.005859375), _s6));
        lanes_store(lists->fixed[106], lanes_mul(K(2.667137344314341e-15), _s6));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f147)(LANES(court_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_bridge_depth = lanes_load(lists->reachable_p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->reachable_p_bridge_half_width + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->reachable_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->reachable_p_wire_radius + i);
    {
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[77], lanes_mul(p_ball_radius, p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f156)(LANES(court_plain_lists) *lists, size_t taken, M idle)
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
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[77], lanes_mul(p_ball_radius, p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f164)(LANES(court_plain_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[0], p_ball_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[107], lanes_div(K(1.0), lanes_add(p_ball_radius, p_wire_radius)));
        lanes_store(lists->fixed[108], lanes_div(K(1.0), p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f190)(LANES(court_plain_lists) *lists, size_t taken, M idle)
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
        lanes_store(lists->fixed[0], p_ball_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[13], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[14], lanes_mul(p_ring_radius, p_ring_radius));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[37], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[108], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[109], _s1);
        lanes_store(lists->fixed[110], lanes_neg(_s1));
        lanes_store(lists->fixed[111], _s2);
        lanes_store(lists->fixed[112], lanes_neg(_s2));
        lanes_store(lists->fixed[113], _s3);
        lanes_store(lists->fixed[114], lanes_neg(_s3));
        lanes_store(lists->fixed[115], _s4);
        lanes_store(lists->fixed[116], lanes_neg(_s4));
        lanes_store(lists->fixed[117], _s5);
        lanes_store(lists->fixed[118], lanes_neg(_s5));
        lanes_store(lists->fixed[119], _s6);
        lanes_store(lists->fixed[120], lanes_neg(_s6));
        lanes_store(lists->fixed[121], lanes_mul(K(0.6), p_gravity));
        lanes_store(lists->fixed[122], lanes_mul(K(0.015625), p_gravity));
        lanes_store(lists->fixed[123], lanes_mul(K(0.4), p_gravity));
        lanes_store(lists->fixed[124], lanes_mul(K(5.684341886080802e-14), lanes_sqrt(lanes_mul(p_ball_radius, p_gravity))));
        lanes_store(lists->fixed[125], lanes_mul(K(5.684341886080802e-14), p_gravity));
        lanes_store(lists->fixed[126], lanes_add(p_ball_radius, p_wire_radius));
        lanes_store(lists->fixed[127], lanes_mul(K(3.637978807091713e-12), p_ball_radius));
        lanes_store(lists->fixed[128], p_bridge_depth);
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f266)(LANES(court_plain_lists) *lists, size_t taken, M idle)
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
        lanes_store(lists->fixed[0], p_ball_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[9], _s1);
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[13], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[14], lanes_mul(p_ring_radius, p_ring_radius));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[87], lanes_mul(K(0.5), p_ring_radius));
        lanes_store(lists->fixed[107], lanes_div(K(1.0), _s0));
        lanes_store(lists->fixed[108], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[122], lanes_mul(K(0.015625), p_gravity));
        lanes_store(lists->fixed[124], lanes_mul(K(5.684341886080802e-14), lanes_sqrt(lanes_mul(p_ball_radius, p_gravity))));
        lanes_store(lists->fixed[125], lanes_mul(K(5.684341886080802e-14), p_gravity));
        lanes_store(lists->fixed[126], _s0);
        lanes_store(lists->fixed[127], lanes_mul(K(3.637978807091713e-12), p_ball_radius));
        lanes_store(lists->fixed[129], lanes_mul(K(0.3333333333333333), p_ring_radius));
        lanes_store(lists->fixed[130], lanes_mul(K(0.25), p_ring_radius));
        lanes_store(lists->fixed[131], lanes_mul(K(0.2), p_ring_radius));
        lanes_store(lists->fixed[132], lanes_mul(K(0.16666666666666666), p_ring_radius));
        lanes_store(lists->fixed[133], lanes_mul(K(0.14285714285714285), p_ring_radius));
        lanes_store(lists->fixed[134], lanes_mul(K(0.125), p_ring_radius));
        lanes_store(lists->fixed[135], lanes_mul(K(0.1111111111111111), p_ring_radius));
        lanes_store(lists->fixed[136], lanes_mul(K(0.1), p_ring_radius));
        lanes_store(lists->fixed[137], lanes_mul(K(0.09090909090909091), p_ring_radius));
        lanes_store(lists->fixed[138], lanes_mul(K(0.08333333333333333), p_ring_radius));
        lanes_store(lists->fixed[139], lanes_sqrt(lanes_div(p_gravity, _s0)));
        lanes_store(lists->fixed[140], lanes_div(K(1.0), lanes_sub(p_ring_radius, _s0)));
        lanes_store(lists->fixed[141], lanes_mul(K(0.8), p_gravity));
        lanes_store(lists->fixed[142], lanes_sqrt(lanes_add(lanes_mul(_s4, _s4), lanes_mul(_s7, _s7))));
        lanes_store(lists->fixed[143], lanes_sqrt(lanes_add(lanes_mul(_s10, _s10), lanes_mul(_s13, _s13))));
        lanes_store(lists->fixed[144], lanes_mul(K(0.000244140625), _s0));
        lanes_store(lists->fixed[145], lanes_mul(K(0.00390625), p_gravity));
        lanes_store(lists->fixed[146], lanes_mul(lanes_mul(K(0.000244140625), lanes_mul(p_gravity, p_gravity)), _s0));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f311)(LANES(court_plain_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[0], p_ball_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[13], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[18], lanes_neg(p_gravity));
        lanes_store(lists->fixed[37], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[44], lanes_mul(K(6.0), p_gravity));
        lanes_store(lists->fixed[107], lanes_div(K(1.0), _s0));
        lanes_store(lists->fixed[108], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[109], _s2);
        lanes_store(lists->fixed[110], lanes_neg(_s2));
        lanes_store(lists->fixed[111], _s3);
        lanes_store(lists->fixed[112], lanes_neg(_s3));
        lanes_store(lists->fixed[113], _s4);
        lanes_store(lists->fixed[114], lanes_neg(_s4));
        lanes_store(lists->fixed[115], _s5);
        lanes_store(lists->fixed[116], lanes_neg(_s5));
        lanes_store(lists->fixed[117], _s6);
        lanes_store(lists->fixed[118], lanes_neg(_s6));
        lanes_store(lists->fixed[119], _s7);
        lanes_store(lists->fixed[120], lanes_neg(_s7));
        lanes_store(lists->fixed[125], lanes_mul(K(5.684341886080802e-14), p_gravity));
        lanes_store(lists->fixed[126], _s0);
        lanes_store(lists->fixed[128], p_bridge_depth);
        lanes_store(lists->fixed[147], lanes_mul(K(6.0), lanes_mul(p_gravity, p_gravity)));
        lanes_store(lists->fixed[148], lanes_mul(K(0.0078125), p_gravity));
        lanes_store(lists->fixed[149], lanes_max(K(0.0), p_gravity));
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
            LANES(court_plain_fix_f311)(lists, i);
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
        const LANES(court_holding_out) _o312 =
            LANES(court_holding)(held, K(0.0));
        M here = _o312.here;
        const M _m313 = lanes_both(rows, here);
        if (lanes_any(_m313)) {
            const LANES(court_ring_tube_out) _o314 =
                LANES(court_ring_tube)(lanes_load(lists->fixed[107]));
            per_reach = lanes_select(_m313, _o314.per_reach, per_reach);
            const LANES(court_ring_parting_out) _o315 =
                LANES(court_ring_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[44]), lanes_load(lists->fixed[147]));
            lift = lanes_select(_m313, _o315.lift, lift);
            surge = lanes_select(_m313, _o315.surge, surge);
            snap = lanes_select(_m313, _o315.snap, snap);
        }
        const LANES(court_holding_out) _o316 =
            LANES(court_holding)(held, K(1.0));
        here = _o316.here;
        const M _m317 = lanes_both(rows, here);
        if (lanes_any(_m317)) {
            const LANES(court_backboard_tube_out) _o318 =
                LANES(court_backboard_tube)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[110]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[113]), lanes_load(lists->fixed[114]), lanes_load(lists->fixed[108]));
            per_reach = lanes_select(_m317, _o318.per_reach, per_reach);
            const LANES(court_backboard_parting_out) _o319 =
                LANES(court_backboard_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[18]), lanes_load(lists->fixed[9]));
            lift = lanes_select(_m317, _o319.lift, lift);
            surge = lanes_select(_m317, _o319.surge, surge);
            snap = lanes_select(_m317, _o319.snap, snap);
        }
        const LANES(court_holding_out) _o320 =
            LANES(court_holding)(held, K(2.0));
        here = _o320.here;
        const M _m321 = lanes_both(rows, here);
        if (lanes_any(_m321)) {
            const LANES(court_bridge_tube_out) _o322 =
                LANES(court_bridge_tube)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[115]), lanes_load(lists->fixed[116]), lanes_load(lists->fixed[117]), lanes_load(lists->fixed[118]), lanes_load(lists->fixed[119]), lanes_load(lists->fixed[120]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[108]));
            per_reach = lanes_select(_m321, _o322.per_reach, per_reach);
            const LANES(court_bridge_parting_out) _o323 =
                LANES(court_bridge_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[18]), lanes_load(lists->fixed[10]));
            lift = lanes_select(_m321, _o323.lift, lift);
            surge = lanes_select(_m321, _o323.surge, surge);
            snap = lanes_select(_m321, _o323.snap, snap);
        }
        const LANES(court_unmet_out) _o324 =
            LANES(court_unmet)();
        V spare = _o324.spare;
        const LANES(court_beside_out) _o325 =
            LANES(court_beside)(held, K(0.0));
        M beside = _o325.beside;
        const M _m326 = lanes_both(rows, beside);
        if (lanes_any(_m326)) {
            const LANES(court_ring_beside_out) _o327 =
                LANES(court_ring_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[37]), lanes_load(lists->fixed[126]));
            V gap = _o327.gap;
            V nearing = _o327.nearing;
            V dent = _o327.dent;
            const LANES(court_spared_out) _o328 =
                LANES(court_spared)(dent, gap, nearing, spare, vx, vy, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[148]));
            spare = lanes_select(_m326, _o328.spare, spare);
        }
        const LANES(court_beside_out) _o329 =
            LANES(court_beside)(held, K(1.0));
        beside = _o329.beside;
        const M _m330 = lanes_both(rows, beside);
        if (lanes_any(_m330)) {
            const LANES(court_backboard_beside_out) _o331 =
                LANES(court_backboard_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]));
            V gap = _o331.gap;
            V nearing = _o331.nearing;
            V dent = _o331.dent;
            const LANES(court_spared_out) _o332 =
                LANES(court_spared)(dent, gap, nearing, spare, vx, vy, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[148]));
            spare = lanes_select(_m330, _o332.spare, spare);
        }
        const LANES(court_beside_out) _o333 =
            LANES(court_beside)(held, K(2.0));
        beside = _o333.beside;
        const M _m334 = lanes_both(rows, beside);
        if (lanes_any(_m334)) {
            const LANES(court_bridge_beside_out) _o335 =
                LANES(court_bridge_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]));
            V gap = _o335.gap;
            V nearing = _o335.nearing;
            V dent = _o335.dent;
            const LANES(court_spared_out) _o336 =
                LANES(court_spared)(dent, gap, nearing, spare, vx, vy, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[148]));
            spare = lanes_select(_m334, _o336.spare, spare);
        }
        const LANES(court_beside_out) _o337 =
            LANES(court_beside)(held, K(3.0));
        beside = _o337.beside;
        const M _m338 = lanes_both(rows, beside);
        if (lanes_any(_m338)) {
            const LANES(court_end_beside_out) _o339 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[13]));
            V gap = _o339.gap;
            V nearing = _o339.nearing;
            V dent = _o339.dent;
            const LANES(court_spared_out) _o340 =
                LANES(court_spared)(dent, gap, nearing, spare, vx, vy, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[148]));
            spare = lanes_select(_m338, _o340.spare, spare);
        }
        const LANES(court_holding_out) _o341 =
            LANES(court_holding)(held, K(1.0));
        here = _o341.here;
        const M _m342 = lanes_both(rows, here);
        if (lanes_any(_m342)) {
            const LANES(court_backboard_seam0_out) _o343 =
                LANES(court_backboard_seam0)(vx, x, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[109]));
            V gap = _o343.gap;
            V nearing = _o343.nearing;
            V near = _o343.near;
            const LANES(court_spared_seam_out) _o344 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[149]));
            spare = lanes_select(_m342, _o344.spare, spare);
            const LANES(court_backboard_seam1_out) _o345 =
                LANES(court_backboard_seam1)(vx, x, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[109]));
            gap = _o345.gap;
            nearing = _o345.nearing;
            near = _o345.near;
            const LANES(court_spared_seam_out) _o346 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[149]));
            spare = lanes_select(_m342, _o346.spare, spare);
            const LANES(court_backboard_seam2_out) _o347 =
                LANES(court_backboard_seam2)(vy, y, lanes_load(lists->fixed[4]), lanes_load(lists->fixed[111]));
            gap = _o347.gap;
            nearing = _o347.nearing;
            near = _o347.near;
            const LANES(court_spared_seam_out) _o348 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[149]));
            spare = lanes_select(_m342, _o348.spare, spare);
            const LANES(court_backboard_seam3_out) _o349 =
                LANES(court_backboard_seam3)(vy, y, lanes_load(lists->fixed[4]), lanes_load(lists->fixed[111]));
            gap = _o349.gap;
            nearing = _o349.nearing;
            near = _o349.near;
            const LANES(court_spared_seam_out) _o350 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[149]));
            spare = lanes_select(_m342, _o350.spare, spare);
            const LANES(court_backboard_seam4_out) _o351 =
                LANES(court_backboard_seam4)(vz, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[113]));
            gap = _o351.gap;
            nearing = _o351.nearing;
            near = _o351.near;
            const LANES(court_spared_seam_out) _o352 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[149]));
            spare = lanes_select(_m342, _o352.spare, spare);
            const LANES(court_backboard_seam5_out) _o353 =
                LANES(court_backboard_seam5)(vz, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[113]));
            gap = _o353.gap;
            nearing = _o353.nearing;
            near = _o353.near;
            const LANES(court_spared_seam_out) _o354 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[149]));
            spare = lanes_select(_m342, _o354.spare, spare);
        }
        const LANES(court_holding_out) _o355 =
            LANES(court_holding)(held, K(2.0));
        here = _o355.here;
        const M _m356 = lanes_both(rows, here);
        if (lanes_any(_m356)) {
            const LANES(court_bridge_seam0_out) _o357 =
                LANES(court_bridge_seam0)(vx, x, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[115]));
            V gap = _o357.gap;
            V nearing = _o357.nearing;
            V near = _o357.near;
            const LANES(court_spared_seam_out) _o358 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[149]));
            spare = lanes_select(_m356, _o358.spare, spare);
            const LANES(court_bridge_seam1_out) _o359 =
                LANES(court_bridge_seam1)(vx, x, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[115]));
            gap = _o359.gap;
            nearing = _o359.nearing;
            near = _o359.near;
            const LANES(court_spared_seam_out) _o360 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[149]));
            spare = lanes_select(_m356, _o360.spare, spare);
            const LANES(court_bridge_seam2_out) _o361 =
                LANES(court_bridge_seam2)(vy, y, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[117]));
            gap = _o361.gap;
            nearing = _o361.nearing;
            near = _o361.near;
            const LANES(court_spared_seam_out) _o362 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[149]));
            spare = lanes_select(_m356, _o362.spare, spare);
            const LANES(court_bridge_seam3_out) _o363 =
                LANES(court_bridge_seam3)(vy, y, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[117]));
            gap = _o363.gap;
            nearing = _o363.nearing;
            near = _o363.near;
            const LANES(court_spared_seam_out) _o364 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[149]));
            spare = lanes_select(_m356, _o364.spare, spare);
            const LANES(court_bridge_seam4_out) _o365 =
                LANES(court_bridge_seam4)(vz, z, lanes_load(lists->fixed[128]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[119]));
            gap = _o365.gap;
            nearing = _o365.nearing;
            near = _o365.near;
            const LANES(court_spared_seam_out) _o366 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[149]));
            spare = lanes_select(_m356, _o366.spare, spare);
            const LANES(court_bridge_seam5_out) _o367 =
                LANES(court_bridge_seam5)(vz, z, lanes_load(lists->fixed[2]), lanes_load(lists->fixed[119]));
            gap = _o367.gap;
            nearing = _o367.nearing;
            near = _o367.near;
            const LANES(court_spared_seam_out) _o368 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[149]));
            spare = lanes_select(_m356, _o368.spare, spare);
        }
        const LANES(court_parted_out) _o369 =
            LANES(court_parted)(K(INFINITY), lift, per_reach, K(0.0), snap, spare, surge, K(0.0), vx, vy, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[148]), lanes_load(lists->fixed[125]));
        V when = _o369.when;
        const LANES(court_hopping_out) _o370 =
            LANES(court_hopping)();
        V which = _o370.which;
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
            LANES(court_plain_fix_f164)(lists, i);
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
        const LANES(court_resumed_out) _o165 =
            LANES(court_resumed)(clock, mode, K(0.0), K(0.0));
        V which = _o165.which;
        V began = _o165.began;
        M begins = _o165.begins;
        M rolling = _o165.rolling;
        M leaves = _o165.leaves;
        V nx = _o165.nx;
        V ny = _o165.ny;
        V nz = _o165.nz;
        V gap = _o165.gap;
        V bent_x = _o165.bent_x;
        V bent_y = _o165.bent_y;
        V bent_z = _o165.bent_z;
        V lift = _o165.lift;
        V surge = _o165.surge;
        V snap = _o165.snap;
        V per_reach = _o165.per_reach;
        const M _m166 = lanes_both(rows, begins);
        if (lanes_any(_m166)) {
            const LANES(court_holding_out) _o167 =
                LANES(court_holding)(held, K(0.0));
            M here = _o167.here;
            const M _m168 = lanes_both(_m166, here);
            {
                const LANES(court_ring_normal_out) _o169 =
                    LANES(court_ring_normal)(x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[107]));
                nx = lanes_select(_m168, _o169.nx, nx);
                ny = lanes_select(_m168, _o169.ny, ny);
                nz = lanes_select(_m168, _o169.nz, nz);
            }
            const LANES(court_holding_out) _o170 =
                LANES(court_holding)(held, K(1.0));
            here = _o170.here;
            const M _m171 = lanes_both(_m166, here);
            {
                const LANES(court_backboard_normal_out) _o172 =
                    LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[9]));
                nx = lanes_select(_m171, _o172.nx, nx);
                ny = lanes_select(_m171, _o172.ny, ny);
                nz = lanes_select(_m171, _o172.nz, nz);
            }
            const LANES(court_holding_out) _o173 =
                LANES(court_holding)(held, K(2.0));
            here = _o173.here;
            const M _m174 = lanes_both(_m166, here);
            {
                const LANES(court_bridge_normal_out) _o175 =
                    LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[10]));
                nx = lanes_select(_m174, _o175.nx, nx);
                ny = lanes_select(_m174, _o175.ny, ny);
                nz = lanes_select(_m174, _o175.nz, nz);
            }
            const LANES(court_roll_turn_rate_out) _o176 =
                LANES(court_roll_turn_rate)(nx, ny, nz, wx, wy, wz, lanes_load(lists->fixed[0]));
            V turn_rate = _o176.turn_rate;
            const LANES(court_gripped_out) _o177 =
                LANES(court_gripped)(nx, ny, nz, vx, vy, vz, wx, wy, wz, lanes_load(lists->fixed[0]));
            V rolled_x = _o177.rolled_x;
            V rolled_y = _o177.rolled_y;
            V rolled_z = _o177.rolled_z;
            const LANES(court_holding_out) _o178 =
                LANES(court_holding)(held, K(0.0));
            here = _o178.here;
            const M _m179 = lanes_both(_m166, here);
            {
                const LANES(court_ring_off_out) _o180 =
                    LANES(court_ring_off)(x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]));
                gap = lanes_select(_m179, _o180.gap, gap);
            }
            const LANES(court_holding_out) _o181 =
                LANES(court_holding)(held, K(1.0));
            here = _o181.here;
            const M _m182 = lanes_both(_m166, here);
            {
                const LANES(court_backboard_off_out) _o183 =
                    LANES(court_backboard_off)(x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]));
                gap = lanes_select(_m182, _o183.gap, gap);
            }
            const LANES(court_holding_out) _o184 =
                LANES(court_holding)(held, K(2.0));
            here = _o184.here;
            const M _m185 = lanes_both(_m166, here);
            {
                const LANES(court_bridge_off_out) _o186 =
                    LANES(court_bridge_off)(x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]));
                gap = lanes_select(_m185, _o186.gap, gap);
            }
            const LANES(court_roll_placed_out) _o187 =
                LANES(court_roll_placed)(gap, nx, ny, nz, turn_rate, rolled_x, rolled_y, rolled_z, x, y, z, lanes_load(lists->fixed[108]));
            x = lanes_select(_m166, _o187.x, x);
            y = lanes_select(_m166, _o187.y, y);
            z = lanes_select(_m166, _o187.z, z);
            vx = lanes_select(_m166, _o187.vx, vx);
            vy = lanes_select(_m166, _o187.vy, vy);
            vz = lanes_select(_m166, _o187.vz, vz);
            wx = lanes_select(_m166, _o187.wx, wx);
            wy = lanes_select(_m166, _o187.wy, wy);
            wz = lanes_select(_m166, _o187.wz, wz);
            const LANES(court_beginning_contact_out) _o188 =
                LANES(court_beginning_contact)();
            which = lanes_select(_m166, _o188.which, which);
            circled = lanes_select(_m166, _o188.circled, circled);
        }
        const LANES(court_circles_out) _o189 =
            LANES(court_circles)(held, K(0.0), rolling);
        M circling = _o189.circling;
        rolling = _o189.rolling;
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
                    LANES(court_plain_fix_f190)(lists, taken, idle);
                const size_t room = LANES_WIDTH - busy, left = kept_rolling_shots - taken;
                active = lanes_leading(idle, left, active);
                taken += left < room ? left : room;
                busy += left < room ? left : room;
            }
            if (busy == 0)
                break;
            M rolling = active;
            const LANES(court_holding_out) _o191 =
                LANES(court_holding)(held, K(1.0));
            M here = _o191.here;
            const M _m192 = lanes_both(active, here);
            if (lanes_any(_m192)) {
                const LANES(court_backboard_normal_out) _o193 =
                    LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[9]));
                nx = lanes_select(_m192, _o193.nx, nx);
                ny = lanes_select(_m192, _o193.ny, ny);
                nz = lanes_select(_m192, _o193.nz, nz);
                const LANES(court_backboard_tube_out) _o194 =
                    LANES(court_backboard_tube)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[110]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[112]), lanes_load(lists->fixed[113]), lanes_load(lists->fixed[114]), lanes_load(lists->fixed[108]));
                bent_x = lanes_select(_m192, _o194.bent_x, bent_x);
                bent_y = lanes_select(_m192, _o194.bent_y, bent_y);
                bent_z = lanes_select(_m192, _o194.bent_z, bent_z);
                per_reach = lanes_select(_m192, _o194.per_reach, per_reach);
            }
            const LANES(court_holding_out) _o195 =
                LANES(court_holding)(held, K(2.0));
            here = _o195.here;
            const M _m196 = lanes_both(active, here);
            if (lanes_any(_m196)) {
                const LANES(court_bridge_normal_out) _o197 =
                    LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[10]));
                nx = lanes_select(_m196, _o197.nx, nx);
                ny = lanes_select(_m196, _o197.ny, ny);
                nz = lanes_select(_m196, _o197.nz, nz);
                const LANES(court_bridge_tube_out) _o198 =
                    LANES(court_bridge_tube)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[115]), lanes_load(lists->fixed[116]), lanes_load(lists->fixed[117]), lanes_load(lists->fixed[118]), lanes_load(lists->fixed[119]), lanes_load(lists->fixed[120]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[108]));
                bent_x = lanes_select(_m196, _o198.bent_x, bent_x);
                bent_y = lanes_select(_m196, _o198.bent_y, bent_y);
                bent_z = lanes_select(_m196, _o198.bent_z, bent_z);
                per_reach = lanes_select(_m196, _o198.per_reach, per_reach);
            }
            const LANES(court_roll_start_out) _o199 =
                LANES(court_roll_start)(nx, ny, nz, vx, vy, vz, wx, wy, wz, lanes_load(lists->fixed[0]));
            V vx_0 = _o199.vx_0;
            V vy_0 = _o199.vy_0;
            V vz_0 = _o199.vz_0;
            V nx_0 = _o199.nx_0;
            V ny_0 = _o199.ny_0;
            V nz_0 = _o199.nz_0;
            V turn_rate_0 = _o199.turn_rate_0;
            const LANES(court_roll_0_out) _o200 =
                LANES(court_roll_0)(bent_x, bent_y, bent_z, nx_0, ny_0, nz_0, per_reach, turn_rate_0, vx_0, vy_0, vz_0, lanes_load(lists->fixed[121]));
            V lift_0 = _o200.lift_0;
            V tx_0 = _o200.tx_0;
            V ty_0 = _o200.ty_0;
            V tz_0 = _o200.tz_0;
            V vx_1 = _o200.vx_1;
            V vy_1 = _o200.vy_1;
            V vz_1 = _o200.vz_1;
            V nx_1 = _o200.nx_1;
            V ny_1 = _o200.ny_1;
            V nz_1 = _o200.nz_1;
            V turn_rate_1 = _o200.turn_rate_1;
            const LANES(court_roll_1_out) _o201 =
                LANES(court_roll_1)(bent_x, bent_y, bent_z, lift_0, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1, lanes_load(lists->fixed[121]));
            V lift_1 = _o201.lift_1;
            V tx_1 = _o201.tx_1;
            V ty_1 = _o201.ty_1;
            V tz_1 = _o201.tz_1;
            V vx_2 = _o201.vx_2;
            V vy_2 = _o201.vy_2;
            V vz_2 = _o201.vz_2;
            V nx_2 = _o201.nx_2;
            V ny_2 = _o201.ny_2;
            V nz_2 = _o201.nz_2;
            V turn_rate_2 = _o201.turn_rate_2;
            const LANES(court_roll_2_out) _o202 =
                LANES(court_roll_2)(bent_x, bent_y, bent_z, lift_0, lift_1, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2, lanes_load(lists->fixed[121]));
            V lift_2 = _o202.lift_2;
            V tx_2 = _o202.tx_2;
            V ty_2 = _o202.ty_2;
            V tz_2 = _o202.tz_2;
            V vx_3 = _o202.vx_3;
            V vy_3 = _o202.vy_3;
            V vz_3 = _o202.vz_3;
            V nx_3 = _o202.nx_3;
            V ny_3 = _o202.ny_3;
            V nz_3 = _o202.nz_3;
            V turn_rate_3 = _o202.turn_rate_3;
            const LANES(court_roll_3_out) _o203 =
                LANES(court_roll_3)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3, lanes_load(lists->fixed[121]));
            V lift_3 = _o203.lift_3;
            V tx_3 = _o203.tx_3;
            V ty_3 = _o203.ty_3;
            V tz_3 = _o203.tz_3;
            V vx_4 = _o203.vx_4;
            V vy_4 = _o203.vy_4;
            V vz_4 = _o203.vz_4;
            V nx_4 = _o203.nx_4;
            V ny_4 = _o203.ny_4;
            V nz_4 = _o203.nz_4;
            V turn_rate_4 = _o203.turn_rate_4;
            const LANES(court_roll_4_out) _o204 =
                LANES(court_roll_4)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4, lanes_load(lists->fixed[121]));
            V lift_4 = _o204.lift_4;
            V tx_4 = _o204.tx_4;
            V ty_4 = _o204.ty_4;
            V tz_4 = _o204.tz_4;
            V vx_5 = _o204.vx_5;
            V vy_5 = _o204.vy_5;
            V vz_5 = _o204.vz_5;
            V nx_5 = _o204.nx_5;
            V ny_5 = _o204.ny_5;
            V nz_5 = _o204.nz_5;
            V turn_rate_5 = _o204.turn_rate_5;
            const LANES(court_roll_5_out) _o205 =
                LANES(court_roll_5)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, lanes_load(lists->fixed[121]));
            V lift_5 = _o205.lift_5;
            V tx_5 = _o205.tx_5;
            V ty_5 = _o205.ty_5;
            V tz_5 = _o205.tz_5;
            V vx_6 = _o205.vx_6;
            V vy_6 = _o205.vy_6;
            V vz_6 = _o205.vz_6;
            V nx_6 = _o205.nx_6;
            V ny_6 = _o205.ny_6;
            V nz_6 = _o205.nz_6;
            V turn_rate_6 = _o205.turn_rate_6;
            const LANES(court_roll_6_out) _o206 =
                LANES(court_roll_6)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, lanes_load(lists->fixed[121]));
            V lift_6 = _o206.lift_6;
            V tx_6 = _o206.tx_6;
            V ty_6 = _o206.ty_6;
            V tz_6 = _o206.tz_6;
            V vx_7 = _o206.vx_7;
            V vy_7 = _o206.vy_7;
            V vz_7 = _o206.vz_7;
            V nx_7 = _o206.nx_7;
            V ny_7 = _o206.ny_7;
            V nz_7 = _o206.nz_7;
            V turn_rate_7 = _o206.turn_rate_7;
            const LANES(court_roll_7_out) _o207 =
                LANES(court_roll_7)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, lanes_load(lists->fixed[121]));
            V lift_7 = _o207.lift_7;
            V vx_8 = _o207.vx_8;
            V vy_8 = _o207.vy_8;
            V vz_8 = _o207.vz_8;
            V nx_8 = _o207.nx_8;
            V ny_8 = _o207.ny_8;
            V nz_8 = _o207.nz_8;
            V turn_rate_8 = _o207.turn_rate_8;
            const LANES(court_roll_pace_out) _o208 =
                LANES(court_roll_pace)(lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, lift_7, nx_8, ny_8, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, nz_8, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[122]), lanes_load(lists->fixed[123]));
            V stride = _o208.stride;
            V strongest = _o208.strongest;
            V fastest = _o208.fastest;
            V force = _o208.force;
            V force_rate = _o208.force_rate;
            V force_bend = _o208.force_bend;
            V brace = _o208.brace;
            const LANES(court_leaving_force_out) _o209 =
                LANES(court_leaving_force)(brace, K(INFINITY), fastest, force, force_bend, force_rate, per_reach, K(0.0), stride, K(0.0), vx, vx_1, vy, vy_1, vz, vz_1, which, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[124]), lanes_load(lists->fixed[125]));
            stride = _o209.stride;
            which = _o209.which;
            M rests = _o209.rests;
            const LANES(court_beside_out) _o210 =
                LANES(court_beside)(held, K(0.0));
            M beside = _o210.beside;
            const M _m211 = lanes_both(active, beside);
            if (lanes_any(_m211)) {
                const LANES(court_ring_beside_out) _o212 =
                    LANES(court_ring_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[37]), lanes_load(lists->fixed[126]));
                V gap = _o212.gap;
                V nearing = _o212.nearing;
                V dent = _o212.dent;
                const LANES(court_beside_body_out) _o213 =
                    LANES(court_beside_body)(dent, K(INFINITY), fastest, gap, K(0.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[127]));
                stride = lanes_select(_m211, _o213.stride, stride);
                which = lanes_select(_m211, _o213.which, which);
            }
            const LANES(court_beside_out) _o214 =
                LANES(court_beside)(held, K(1.0));
            beside = _o214.beside;
            const M _m215 = lanes_both(active, beside);
            if (lanes_any(_m215)) {
                const LANES(court_backboard_beside_out) _o216 =
                    LANES(court_backboard_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]));
                V gap = _o216.gap;
                V nearing = _o216.nearing;
                V dent = _o216.dent;
                const LANES(court_beside_body_out) _o217 =
                    LANES(court_beside_body)(dent, K(INFINITY), fastest, gap, K(1.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[127]));
                stride = lanes_select(_m215, _o217.stride, stride);
                which = lanes_select(_m215, _o217.which, which);
            }
            const LANES(court_beside_out) _o218 =
                LANES(court_beside)(held, K(2.0));
            beside = _o218.beside;
            const M _m219 = lanes_both(active, beside);
            if (lanes_any(_m219)) {
                const LANES(court_bridge_beside_out) _o220 =
                    LANES(court_bridge_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]));
                V gap = _o220.gap;
                V nearing = _o220.nearing;
                V dent = _o220.dent;
                const LANES(court_beside_body_out) _o221 =
                    LANES(court_beside_body)(dent, K(INFINITY), fastest, gap, K(2.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[127]));
                stride = lanes_select(_m219, _o221.stride, stride);
                which = lanes_select(_m219, _o221.which, which);
            }
            const LANES(court_end_beside_out) _o222 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[13]));
            V gap = _o222.gap;
            V nearing = _o222.nearing;
            V dent = _o222.dent;
            const LANES(court_beside_gate_out) _o223 =
                LANES(court_beside_gate)(dent, K(INFINITY), fastest, gap, K(3.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z, lanes_load(lists->fixed[0]));
            stride = _o223.stride;
            which = _o223.which;
            const LANES(court_holding_out) _o224 =
                LANES(court_holding)(held, K(1.0));
            here = _o224.here;
            const M _m225 = lanes_both(active, here);
            if (lanes_any(_m225)) {
                const LANES(court_backboard_seam0_out) _o226 =
                    LANES(court_backboard_seam0)(vx, x, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[109]));
                gap = lanes_select(_m225, _o226.gap, gap);
                V nearing = _o226.nearing;
                V near = _o226.near;
                const LANES(court_beside_seam_out) _o227 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m225, _o227.stride, stride);
                const LANES(court_backboard_seam1_out) _o228 =
                    LANES(court_backboard_seam1)(vx, x, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[109]));
                gap = lanes_select(_m225, _o228.gap, gap);
                nearing = _o228.nearing;
                near = _o228.near;
                const LANES(court_beside_seam_out) _o229 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m225, _o229.stride, stride);
                const LANES(court_backboard_seam2_out) _o230 =
                    LANES(court_backboard_seam2)(vy, y, lanes_load(lists->fixed[4]), lanes_load(lists->fixed[111]));
                gap = lanes_select(_m225, _o230.gap, gap);
                nearing = _o230.nearing;
                near = _o230.near;
                const LANES(court_beside_seam_out) _o231 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m225, _o231.stride, stride);
                const LANES(court_backboard_seam3_out) _o232 =
                    LANES(court_backboard_seam3)(vy, y, lanes_load(lists->fixed[4]), lanes_load(lists->fixed[111]));
                gap = lanes_select(_m225, _o232.gap, gap);
                nearing = _o232.nearing;
                near = _o232.near;
                const LANES(court_beside_seam_out) _o233 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m225, _o233.stride, stride);
                const LANES(court_backboard_seam4_out) _o234 =
                    LANES(court_backboard_seam4)(vz, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[113]));
                gap = lanes_select(_m225, _o234.gap, gap);
                nearing = _o234.nearing;
                near = _o234.near;
                const LANES(court_beside_seam_out) _o235 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m225, _o235.stride, stride);
                const LANES(court_backboard_seam5_out) _o236 =
                    LANES(court_backboard_seam5)(vz, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[113]));
                gap = lanes_select(_m225, _o236.gap, gap);
                nearing = _o236.nearing;
                near = _o236.near;
                const LANES(court_beside_seam_out) _o237 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m225, _o237.stride, stride);
            }
            const LANES(court_holding_out) _o238 =
                LANES(court_holding)(held, K(2.0));
            here = _o238.here;
            const M _m239 = lanes_both(active, here);
            if (lanes_any(_m239)) {
                const LANES(court_bridge_seam0_out) _o240 =
                    LANES(court_bridge_seam0)(vx, x, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[115]));
                gap = lanes_select(_m239, _o240.gap, gap);
                V nearing = _o240.nearing;
                V near = _o240.near;
                const LANES(court_beside_seam_out) _o241 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m239, _o241.stride, stride);
                const LANES(court_bridge_seam1_out) _o242 =
                    LANES(court_bridge_seam1)(vx, x, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[115]));
                gap = lanes_select(_m239, _o242.gap, gap);
                nearing = _o242.nearing;
                near = _o242.near;
                const LANES(court_beside_seam_out) _o243 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m239, _o243.stride, stride);
                const LANES(court_bridge_seam2_out) _o244 =
                    LANES(court_bridge_seam2)(vy, y, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[117]));
                gap = lanes_select(_m239, _o244.gap, gap);
                nearing = _o244.nearing;
                near = _o244.near;
                const LANES(court_beside_seam_out) _o245 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m239, _o245.stride, stride);
                const LANES(court_bridge_seam3_out) _o246 =
                    LANES(court_bridge_seam3)(vy, y, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[117]));
                gap = lanes_select(_m239, _o246.gap, gap);
                nearing = _o246.nearing;
                near = _o246.near;
                const LANES(court_beside_seam_out) _o247 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m239, _o247.stride, stride);
                const LANES(court_bridge_seam4_out) _o248 =
                    LANES(court_bridge_seam4)(vz, z, lanes_load(lists->fixed[128]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[119]));
                gap = lanes_select(_m239, _o248.gap, gap);
                nearing = _o248.nearing;
                near = _o248.near;
                const LANES(court_beside_seam_out) _o249 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m239, _o249.stride, stride);
                const LANES(court_bridge_seam5_out) _o250 =
                    LANES(court_bridge_seam5)(vz, z, lanes_load(lists->fixed[2]), lanes_load(lists->fixed[119]));
                gap = lanes_select(_m239, _o250.gap, gap);
                nearing = _o250.nearing;
                near = _o250.near;
                const LANES(court_beside_seam_out) _o251 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m239, _o251.stride, stride);
            }
            const LANES(court_beside_time_out) _o252 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o252.stride;
            which = _o252.which;
            const LANES(court_passing_from_out) _o253 =
                LANES(court_passing_from)(z);
            M over = _o253.over;
            const LANES(court_roll_moved_out) _o254 =
                LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, x, y, z);
            x = _o254.x;
            vx = _o254.vx;
            y = _o254.y;
            vy = _o254.vy;
            z = _o254.z;
            vz = _o254.vz;
            V turn_rate = _o254.turn_rate;
            const LANES(court_holding_out) _o255 =
                LANES(court_holding)(held, K(1.0));
            here = _o255.here;
            const M _m256 = lanes_both(active, here);
            if (lanes_any(_m256)) {
                const LANES(court_backboard_normal_out) _o257 =
                    LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[9]));
                nx = lanes_select(_m256, _o257.nx, nx);
                ny = lanes_select(_m256, _o257.ny, ny);
                nz = lanes_select(_m256, _o257.nz, nz);
                const LANES(court_backboard_off_out) _o258 =
                    LANES(court_backboard_off)(x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]));
                gap = lanes_select(_m256, _o258.gap, gap);
            }
            const LANES(court_holding_out) _o259 =
                LANES(court_holding)(held, K(2.0));
            here = _o259.here;
            const M _m260 = lanes_both(active, here);
            if (lanes_any(_m260)) {
                const LANES(court_bridge_normal_out) _o261 =
                    LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[10]));
                nx = lanes_select(_m260, _o261.nx, nx);
                ny = lanes_select(_m260, _o261.ny, ny);
                nz = lanes_select(_m260, _o261.nz, nz);
                const LANES(court_bridge_off_out) _o262 =
                    LANES(court_bridge_off)(x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]));
                gap = lanes_select(_m260, _o262.gap, gap);
            }
            const LANES(court_roll_placed_out) _o263 =
                LANES(court_roll_placed)(gap, nx, ny, nz, turn_rate, vx, vy, vz, x, y, z, lanes_load(lists->fixed[108]));
            x = _o263.x;
            y = _o263.y;
            z = _o263.z;
            vx = _o263.vx;
            vy = _o263.vy;
            vz = _o263.vz;
            wx = _o263.wx;
            wy = _o263.wy;
            wz = _o263.wz;
            const LANES(court_passing_in_contact_out) _o264 =
                LANES(court_passing_in_contact)(over, through, x, y, z, lanes_load(lists->fixed[14]));
            through = _o264.through;
            const LANES(court_rolled_on_out) _o265 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o265.clock;
            rolling = _o265.rolling;
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
                    LANES(court_plain_fix_f266)(lists, taken, idle);
                const size_t room = LANES_WIDTH - busy, left = kept_circling_shots - taken;
                active = lanes_leading(idle, left, active);
                taken += left < room ? left : room;
                busy += left < room ? left : room;
            }
            if (busy == 0)
                break;
            M circling = active;
            const LANES(court_ring_tube_out) _o267 =
                LANES(court_ring_tube)(lanes_load(lists->fixed[107]));
            V per_reach = _o267.per_reach;
            const LANES(court_ring_round_start_out) _o268 =
                LANES(court_ring_round_start)(vx, vy, vz, wx, wy, wz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[126]));
            V cosine_0 = _o268.cosine_0;
            V sine_0 = _o268.sine_0;
            V climb_0 = _o268.climb_0;
            V along_0 = _o268.along_0;
            V turn_rate_0 = _o268.turn_rate_0;
            V cos_0 = _o268.cos_0;
            V sin_0 = _o268.sin_0;
            V near_0 = _o268.near_0;
            const LANES(court_ring_round_0_out) _o269 =
                LANES(court_ring_round_0)(along_0, climb_0, cos_0, cosine_0, near_0, sin_0, sine_0, turn_rate_0, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[126]));
            V omega_0 = _o269.omega_0;
            V around_0 = _o269.around_0;
            V tilted_0 = _o269.tilted_0;
            V pressed_0 = _o269.pressed_0;
            V force_0 = _o269.force_0;
            V cosine_1 = _o269.cosine_1;
            V sine_1 = _o269.sine_1;
            V climb_1 = _o269.climb_1;
            V along_1 = _o269.along_1;
            V turn_rate_1 = _o269.turn_rate_1;
            V cos_1 = _o269.cos_1;
            V sin_1 = _o269.sin_1;
            const LANES(court_ring_round_1_out) _o270 =
                LANES(court_ring_round_1)(along_0, along_1, around_0, climb_0, climb_1, cos_0, cos_1, cosine_0, cosine_1, near_0, omega_0, pressed_0, sin_0, sin_1, sine_0, sine_1, tilted_0, turn_rate_0, turn_rate_1, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[87]));
            V near_1 = _o270.near_1;
            V omega_1 = _o270.omega_1;
            V around_1 = _o270.around_1;
            V tilted_1 = _o270.tilted_1;
            V pressed_1 = _o270.pressed_1;
            V force_1 = _o270.force_1;
            V cosine_2 = _o270.cosine_2;
            V sine_2 = _o270.sine_2;
            V climb_2 = _o270.climb_2;
            V along_2 = _o270.along_2;
            V turn_rate_2 = _o270.turn_rate_2;
            V cos_2 = _o270.cos_2;
            V sin_2 = _o270.sin_2;
            const LANES(court_ring_round_2_out) _o271 =
                LANES(court_ring_round_2)(along_0, along_1, along_2, around_0, around_1, climb_0, climb_1, climb_2, cos_0, cos_1, cos_2, cosine_0, cosine_1, cosine_2, near_0, near_1, omega_0, omega_1, pressed_0, pressed_1, sin_0, sin_1, sin_2, sine_0, sine_1, sine_2, tilted_0, tilted_1, turn_rate_0, turn_rate_1, turn_rate_2, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[129]));
            V near_2 = _o271.near_2;
            V omega_2 = _o271.omega_2;
            V around_2 = _o271.around_2;
            V tilted_2 = _o271.tilted_2;
            V pressed_2 = _o271.pressed_2;
            V force_2 = _o271.force_2;
            V cosine_3 = _o271.cosine_3;
            V sine_3 = _o271.sine_3;
            V climb_3 = _o271.climb_3;
            V along_3 = _o271.along_3;
            V turn_rate_3 = _o271.turn_rate_3;
            V cos_3 = _o271.cos_3;
            V sin_3 = _o271.sin_3;
            const LANES(court_ring_round_3_out) _o272 =
                LANES(court_ring_round_3)(along_0, along_1, along_2, along_3, around_0, around_1, around_2, climb_0, climb_1, climb_2, climb_3, cos_0, cos_1, cos_2, cos_3, cosine_0, cosine_1, cosine_2, cosine_3, near_0, near_1, near_2, omega_0, omega_1, omega_2, pressed_0, pressed_1, pressed_2, sin_0, sin_1, sin_2, sin_3, sine_0, sine_1, sine_2, sine_3, tilted_0, tilted_1, tilted_2, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[130]));
            V near_3 = _o272.near_3;
            V omega_3 = _o272.omega_3;
            V around_3 = _o272.around_3;
            V tilted_3 = _o272.tilted_3;
            V pressed_3 = _o272.pressed_3;
            V force_3 = _o272.force_3;
            V cosine_4 = _o272.cosine_4;
            V sine_4 = _o272.sine_4;
            V climb_4 = _o272.climb_4;
            V along_4 = _o272.along_4;
            V turn_rate_4 = _o272.turn_rate_4;
            V cos_4 = _o272.cos_4;
            V sin_4 = _o272.sin_4;
            const LANES(court_ring_round_4_out) _o273 =
                LANES(court_ring_round_4)(along_0, along_1, along_2, along_3, along_4, around_0, around_1, around_2, around_3, climb_0, climb_1, climb_2, climb_3, climb_4, cos_0, cos_1, cos_2, cos_3, cos_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, near_0, near_1, near_2, near_3, omega_0, omega_1, omega_2, omega_3, pressed_0, pressed_1, pressed_2, pressed_3, sin_0, sin_1, sin_2, sin_3, sin_4, sine_0, sine_1, sine_2, sine_3, sine_4, tilted_0, tilted_1, tilted_2, tilted_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[131]));
            V near_4 = _o273.near_4;
            V omega_4 = _o273.omega_4;
            V around_4 = _o273.around_4;
            V tilted_4 = _o273.tilted_4;
            V pressed_4 = _o273.pressed_4;
            V force_4 = _o273.force_4;
            V cosine_5 = _o273.cosine_5;
            V sine_5 = _o273.sine_5;
            V climb_5 = _o273.climb_5;
            V along_5 = _o273.along_5;
            V turn_rate_5 = _o273.turn_rate_5;
            V cos_5 = _o273.cos_5;
            V sin_5 = _o273.sin_5;
            const LANES(court_ring_round_5_out) _o274 =
                LANES(court_ring_round_5)(along_0, along_1, along_2, along_3, along_4, along_5, around_0, around_1, around_2, around_3, around_4, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, near_0, near_1, near_2, near_3, near_4, omega_0, omega_1, omega_2, omega_3, omega_4, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[132]));
            V near_5 = _o274.near_5;
            V omega_5 = _o274.omega_5;
            V around_5 = _o274.around_5;
            V tilted_5 = _o274.tilted_5;
            V pressed_5 = _o274.pressed_5;
            V force_5 = _o274.force_5;
            V cosine_6 = _o274.cosine_6;
            V sine_6 = _o274.sine_6;
            V climb_6 = _o274.climb_6;
            V along_6 = _o274.along_6;
            V turn_rate_6 = _o274.turn_rate_6;
            V cos_6 = _o274.cos_6;
            V sin_6 = _o274.sin_6;
            const LANES(court_ring_round_6_out) _o275 =
                LANES(court_ring_round_6)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, around_0, around_1, around_2, around_3, around_4, around_5, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, near_0, near_1, near_2, near_3, near_4, near_5, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[133]));
            V near_6 = _o275.near_6;
            V omega_6 = _o275.omega_6;
            V around_6 = _o275.around_6;
            V tilted_6 = _o275.tilted_6;
            V pressed_6 = _o275.pressed_6;
            V force_6 = _o275.force_6;
            V cosine_7 = _o275.cosine_7;
            V sine_7 = _o275.sine_7;
            V climb_7 = _o275.climb_7;
            V along_7 = _o275.along_7;
            V turn_rate_7 = _o275.turn_rate_7;
            V cos_7 = _o275.cos_7;
            V sin_7 = _o275.sin_7;
            const LANES(court_ring_round_7_out) _o276 =
                LANES(court_ring_round_7)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, near_0, near_1, near_2, near_3, near_4, near_5, near_6, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[134]));
            V near_7 = _o276.near_7;
            V omega_7 = _o276.omega_7;
            V around_7 = _o276.around_7;
            V tilted_7 = _o276.tilted_7;
            V pressed_7 = _o276.pressed_7;
            V force_7 = _o276.force_7;
            V cosine_8 = _o276.cosine_8;
            V sine_8 = _o276.sine_8;
            V climb_8 = _o276.climb_8;
            V along_8 = _o276.along_8;
            V turn_rate_8 = _o276.turn_rate_8;
            V cos_8 = _o276.cos_8;
            V sin_8 = _o276.sin_8;
            const LANES(court_ring_round_8_out) _o277 =
                LANES(court_ring_round_8)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[135]));
            V near_8 = _o277.near_8;
            V omega_8 = _o277.omega_8;
            V around_8 = _o277.around_8;
            V tilted_8 = _o277.tilted_8;
            V pressed_8 = _o277.pressed_8;
            V force_8 = _o277.force_8;
            V cosine_9 = _o277.cosine_9;
            V sine_9 = _o277.sine_9;
            V climb_9 = _o277.climb_9;
            V along_9 = _o277.along_9;
            V turn_rate_9 = _o277.turn_rate_9;
            V cos_9 = _o277.cos_9;
            V sin_9 = _o277.sin_9;
            const LANES(court_ring_round_9_out) _o278 =
                LANES(court_ring_round_9)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[136]));
            V near_9 = _o278.near_9;
            V omega_9 = _o278.omega_9;
            V around_9 = _o278.around_9;
            V tilted_9 = _o278.tilted_9;
            V pressed_9 = _o278.pressed_9;
            V force_9 = _o278.force_9;
            V cosine_10 = _o278.cosine_10;
            V sine_10 = _o278.sine_10;
            V climb_10 = _o278.climb_10;
            V along_10 = _o278.along_10;
            V turn_rate_10 = _o278.turn_rate_10;
            V cos_10 = _o278.cos_10;
            V sin_10 = _o278.sin_10;
            const LANES(court_ring_round_10_out) _o279 =
                LANES(court_ring_round_10)(along_0, along_1, along_10, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, climb_0, climb_1, climb_10, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, sin_0, sin_1, sin_10, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[137]));
            V near_10 = _o279.near_10;
            V omega_10 = _o279.omega_10;
            V around_10 = _o279.around_10;
            V tilted_10 = _o279.tilted_10;
            V pressed_10 = _o279.pressed_10;
            V force_10 = _o279.force_10;
            V cosine_11 = _o279.cosine_11;
            V sine_11 = _o279.sine_11;
            V climb_11 = _o279.climb_11;
            V along_11 = _o279.along_11;
            V turn_rate_11 = _o279.turn_rate_11;
            V cos_11 = _o279.cos_11;
            V sin_11 = _o279.sin_11;
            const LANES(court_ring_round_11_out) _o280 =
                LANES(court_ring_round_11)(along_0, along_1, along_10, along_11, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_10, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, climb_0, climb_1, climb_10, climb_11, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, near_1, near_10, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_10, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_10, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, sin_0, sin_1, sin_10, sin_11, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[138]));
            V force_11 = _o280.force_11;
            V cosine_12 = _o280.cosine_12;
            V sine_12 = _o280.sine_12;
            V climb_12 = _o280.climb_12;
            V along_12 = _o280.along_12;
            V turn_rate_12 = _o280.turn_rate_12;
            V cos_12 = _o280.cos_12;
            V sin_12 = _o280.sin_12;
            const LANES(court_ring_round_pace_out) _o281 =
                LANES(court_ring_round_pace)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_12, cosine_0, cosine_12, force_0, force_1, force_10, force_11, force_2, force_3, force_4, force_5, force_6, force_7, force_8, force_9, omega_0, sin_0, sin_12, sine_0, sine_12, turn_rate_0, turn_rate_11, turn_rate_12, lanes_load(lists->fixed[122]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[139]), lanes_load(lists->fixed[140]), lanes_load(lists->fixed[141]));
            V stride = _o281.stride;
            V strongest = _o281.strongest;
            V fastest = _o281.fastest;
            V sway = _o281.sway;
            V force = _o281.force;
            V force_rate = _o281.force_rate;
            V force_bend = _o281.force_bend;
            V brace = _o281.brace;
            V vx_1 = _o281.vx_1;
            V vy_1 = _o281.vy_1;
            V vz_1 = _o281.vz_1;
            const LANES(court_leaving_force_out) _o282 =
                LANES(court_leaving_force)(brace, K(INFINITY), fastest, force, force_bend, force_rate, per_reach, K(0.0), stride, K(0.0), vx, vx_1, vy, vy_1, vz, vz_1, which, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[124]), lanes_load(lists->fixed[125]));
            stride = _o282.stride;
            which = _o282.which;
            M rests = _o282.rests;
            const LANES(court_backboard_beside_out) _o283 =
                LANES(court_backboard_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]));
            V gap = _o283.gap;
            V nearing = _o283.nearing;
            V dent = _o283.dent;
            const LANES(court_beside_body_out) _o284 =
                LANES(court_beside_body)(dent, K(INFINITY), fastest, gap, K(1.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[127]));
            stride = _o284.stride;
            which = _o284.which;
            const LANES(court_bridge_beside_out) _o285 =
                LANES(court_bridge_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]));
            gap = _o285.gap;
            nearing = _o285.nearing;
            dent = _o285.dent;
            const LANES(court_beside_body_out) _o286 =
                LANES(court_beside_body)(dent, K(INFINITY), fastest, gap, K(2.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[127]));
            stride = _o286.stride;
            which = _o286.which;
            const LANES(court_end_beside_out) _o287 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[13]));
            gap = _o287.gap;
            nearing = _o287.nearing;
            dent = _o287.dent;
            const LANES(court_beside_gate_out) _o288 =
                LANES(court_beside_gate)(dent, K(INFINITY), fastest, gap, K(3.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z, lanes_load(lists->fixed[0]));
            stride = _o288.stride;
            which = _o288.which;
            const LANES(court_beside_time_out) _o289 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o289.stride;
            which = _o289.which;
            const LANES(court_passing_from_out) _o290 =
                LANES(court_passing_from)(z);
            M over = _o290.over;
            const LANES(court_alone_out) _o291 =
                LANES(court_alone)();
            V berth = _o291.nearest;
            const LANES(court_leaps_out) _o292 =
                LANES(court_leaps)(stride);
            V forth = _o292.forth;
            V back = _o292.back;
            const LANES(court_backboard_around_out) _o293 =
                LANES(court_backboard_around)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[142]));
            gap = _o293.gap;
            nearing = _o293.nearing;
            const LANES(court_cleared_out) _o294 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o294.berth;
            const LANES(court_bridge_around_out) _o295 =
                LANES(court_bridge_around)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[143]));
            gap = _o295.gap;
            nearing = _o295.nearing;
            const LANES(court_cleared_out) _o296 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o296.berth;
            const LANES(court_end_around_out) _o297 =
                LANES(court_end_around)(vz, z, lanes_load(lists->fixed[13]));
            gap = _o297.gap;
            nearing = _o297.nearing;
            const LANES(court_cleared_out) _o298 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o298.berth;
            const LANES(court_ring_round_moved_out) _o299 =
                LANES(court_ring_round_moved)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_12, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_12, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, sin_0, sin_1, sin_10, sin_11, sin_12, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_12, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, stride, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_12, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[108]));
            x = _o299.x;
            y = _o299.y;
            z = _o299.z;
            vx = _o299.vx;
            vy = _o299.vy;
            vz = _o299.vz;
            wx = _o299.wx;
            wy = _o299.wy;
            wz = _o299.wz;
            V climb = _o299.climb;
            const LANES(court_passing_in_contact_out) _o300 =
                LANES(court_passing_in_contact)(over, through, x, y, z, lanes_load(lists->fixed[14]));
            through = _o300.through;
            const LANES(court_backboard_around_out) _o301 =
                LANES(court_backboard_around)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[142]));
            gap = _o301.gap;
            nearing = _o301.nearing;
            const LANES(court_cleared_out) _o302 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o302.berth;
            const LANES(court_bridge_around_out) _o303 =
                LANES(court_bridge_around)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[143]));
            gap = _o303.gap;
            nearing = _o303.nearing;
            const LANES(court_cleared_out) _o304 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o304.berth;
            const LANES(court_end_around_out) _o305 =
                LANES(court_end_around)(vz, z, lanes_load(lists->fixed[13]));
            gap = _o305.gap;
            nearing = _o305.nearing;
            const LANES(court_cleared_out) _o306 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o306.berth;
            const LANES(court_ring_swung_out) _o307 =
                LANES(court_ring_swung)(berth, circled, climb, climb_0, K(INFINITY), fastest, force, force_bend, force_rate, K(0.0), stride, sway, K(0.0), which, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[144]), lanes_load(lists->fixed[145]), lanes_load(lists->fixed[122]), lanes_load(lists->fixed[107]), lanes_load(lists->fixed[146]));
            circled = _o307.circled;
            M endless = _o307.endless;
            const LANES(court_for_ever_out) _o308 =
                LANES(court_for_ever)(endless, which);
            which = _o308.which;
            const LANES(court_rolled_on_out) _o309 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o309.clock;
            circling = _o309.rolling;
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
        const LANES(court_rejoined_out) _o310 =
            LANES(court_rejoined)(circling, rolling);
        rolling = _o310.rolling;
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
static void LANES(court_plain_fix_f371)(LANES(court_plain_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[0], p_ball_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[14], lanes_mul(p_ring_radius, p_ring_radius));
        lanes_store(lists->fixed[15], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[30], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[107], lanes_div(K(1.0), lanes_add(p_ball_radius, p_wire_radius)));
        lanes_store(lists->fixed[108], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[150], p_restitution_speed);
        lanes_store(lists->fixed[151], _s0);
        lanes_store(lists->fixed[152], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[153], lanes_mul(K(7.275957614183426e-12), p_ball_radius));
        lanes_store(lists->fixed[154], lanes_mul(K(1.1920928955078125e-07), p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_plain_fix_f416)(LANES(court_plain_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[0], p_ball_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[13], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[18], lanes_neg(p_gravity));
        lanes_store(lists->fixed[44], lanes_mul(K(6.0), p_gravity));
        lanes_store(lists->fixed[107], lanes_div(K(1.0), lanes_add(p_ball_radius, p_wire_radius)));
        lanes_store(lists->fixed[108], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[123], lanes_mul(K(0.4), p_gravity));
        lanes_store(lists->fixed[127], lanes_mul(K(3.637978807091713e-12), p_ball_radius));
        lanes_store(lists->fixed[147], lanes_mul(K(6.0), lanes_mul(p_gravity, p_gravity)));
        lanes_store(lists->fixed[153], lanes_mul(K(7.275957614183426e-12), p_ball_radius));
        lanes_store(lists->fixed[155], lanes_mul(K(0.4), p_ball_radius));
        lanes_store(lists->fixed[156], _s0);
        lanes_store(lists->fixed[157], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[158], lanes_mul(p_ring_friction, _s1));
        lanes_store(lists->fixed[159], lanes_mul(_s1, _s0));
        lanes_store(lists->fixed[160], lanes_mul(K(3.725290298461914e-09), p_ball_radius));
        lanes_store(lists->fixed[161], _s2);
        lanes_store(lists->fixed[162], lanes_mul(_s2, _s2));
        lanes_store(lists->fixed[163], lanes_mul(p_backboard_friction, _s3));
        lanes_store(lists->fixed[164], lanes_mul(_s3, _s2));
        lanes_store(lists->fixed[165], _s4);
        lanes_store(lists->fixed[166], lanes_mul(_s4, _s4));
        lanes_store(lists->fixed[167], lanes_mul(p_bridge_friction, _s5));
        lanes_store(lists->fixed[168], lanes_mul(_s5, _s4));
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
            LANES(court_plain_fix_f416)(lists, i);
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
        const LANES(court_ring_normal_out) _o417 =
            LANES(court_ring_normal)(x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[107]));
        V nx = _o417.nx;
        V ny = _o417.ny;
        V nz = _o417.nz;
        const LANES(court_here_out) _o418 =
            LANES(court_here)(K(1.0), which);
        M here = _o418.here;
        const M _m419 = lanes_both(rows, here);
        {
            const LANES(court_backboard_normal_out) _o420 =
                LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[9]));
            nx = lanes_select(_m419, _o420.nx, nx);
            ny = lanes_select(_m419, _o420.ny, ny);
            nz = lanes_select(_m419, _o420.nz, nz);
        }
        const LANES(court_here_out) _o421 =
            LANES(court_here)(K(2.0), which);
        here = _o421.here;
        const M _m422 = lanes_both(rows, here);
        {
            const LANES(court_bridge_normal_out) _o423 =
                LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[10]));
            nx = lanes_select(_m422, _o423.nx, nx);
            ny = lanes_select(_m422, _o423.ny, ny);
            nz = lanes_select(_m422, _o423.nz, nz);
        }
        const LANES(court_nearly_out) _o424 =
            LANES(court_nearly)(nx, ny, nz, vx, vy, vz, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[153]));
        M nearly = _o424.nearly;
        const LANES(court_gripped_out) _o425 =
            LANES(court_gripped)(nx, ny, nz, vx, vy, vz, wx, wy, wz, lanes_load(lists->fixed[0]));
        V rolled_x = _o425.rolled_x;
        V rolled_y = _o425.rolled_y;
        V rolled_z = _o425.rolled_z;
        V slip = _o425.slip;
        V bounce = _o425.bounce;
        const LANES(court_here_out) _o426 =
            LANES(court_here)(K(0.0), which);
        here = _o426.here;
        const M _m427 = lanes_both(rows, here);
        if (lanes_any(_m427)) {
            const LANES(court_ring_turning_out) _o428 =
                LANES(court_ring_turning)(rolled_x, rolled_y, rolled_z, x, y, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[107]));
            V turning_x = _o428.turning_x;
            V turning_y = _o428.turning_y;
            V turning_z = _o428.turning_z;
            const LANES(court_pressed_on_out) _o429 =
                LANES(court_pressed_on)(nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[155]), lanes_load(lists->fixed[123]));
            V press = _o429.press;
            V weight = _o429.weight;
            V drag = _o429.drag;
            V thrust_x = _o429.thrust_x;
            V thrust_y = _o429.thrust_y;
            V thrust_z = _o429.thrust_z;
            const LANES(court_alone_out) _o430 =
                LANES(court_alone)();
            V nearest = _o430.nearest;
            V wedge = _o430.wedge;
            const LANES(court_backboard_closing_out) _o431 =
                LANES(court_backboard_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]));
            V gap = _o431.gap;
            V nearing = _o431.nearing;
            V swerve = _o431.swerve;
            V facing = _o431.facing;
            const LANES(court_neared_body_out) _o432 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o432.nearest;
            wedge = _o432.wedge;
            const LANES(court_bridge_closing_out) _o433 =
                LANES(court_bridge_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]));
            gap = _o433.gap;
            nearing = _o433.nearing;
            swerve = _o433.swerve;
            facing = _o433.facing;
            const LANES(court_neared_body_out) _o434 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o434.nearest;
            wedge = _o434.wedge;
            const LANES(court_end_beside_out) _o435 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[13]));
            gap = _o435.gap;
            const LANES(court_neared_out) _o436 =
                LANES(court_neared)(gap, nearest);
            nearest = _o436.nearest;
            const LANES(court_ring_parting_out) _o437 =
                LANES(court_ring_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[44]), lanes_load(lists->fixed[147]));
            V lift = _o437.lift;
            const LANES(court_ring_impact_settling_out) _o438 =
                LANES(court_ring_impact_settling)(bounce, drag, lift, nearest, press, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[156]), lanes_load(lists->fixed[157]), lanes_load(lists->fixed[158]), lanes_load(lists->fixed[159]), lanes_load(lists->fixed[127]), lanes_load(lists->fixed[160]));
            M settles = _o438.settles;
            M lodges = _o438.lodges;
            M slides = _o438.slides;
            M parts = _o438.parts;
            M unsure = _o438.unsure;
            const LANES(court_settled_out) _o439 =
                LANES(court_settled)(K(0.0), lodges, nearly, outcome, parts, settles, slides, K(0.0), unsure);
            mode = lanes_select(_m427, _o439.mode, mode);
            held = lanes_select(_m427, _o439.held, held);
            outcome = lanes_select(_m427, _o439.outcome, outcome);
            slip_left = lanes_select(_m427, _o439.slip_left, slip_left);
        }
        const LANES(court_here_out) _o440 =
            LANES(court_here)(K(1.0), which);
        here = _o440.here;
        const M _m441 = lanes_both(rows, here);
        if (lanes_any(_m441)) {
            const LANES(court_backboard_turning_out) _o442 =
                LANES(court_backboard_turning)(rolled_x, rolled_y, rolled_z, x, y, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[9]));
            V turning_x = _o442.turning_x;
            V turning_y = _o442.turning_y;
            V turning_z = _o442.turning_z;
            const LANES(court_pressed_on_out) _o443 =
                LANES(court_pressed_on)(nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[155]), lanes_load(lists->fixed[123]));
            V press = _o443.press;
            V weight = _o443.weight;
            V drag = _o443.drag;
            V thrust_x = _o443.thrust_x;
            V thrust_y = _o443.thrust_y;
            V thrust_z = _o443.thrust_z;
            const LANES(court_alone_out) _o444 =
                LANES(court_alone)();
            V nearest = _o444.nearest;
            V wedge = _o444.wedge;
            const LANES(court_ring_closing_out) _o445 =
                LANES(court_ring_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]));
            V gap = _o445.gap;
            V nearing = _o445.nearing;
            V swerve = _o445.swerve;
            V facing = _o445.facing;
            const LANES(court_neared_body_out) _o446 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o446.nearest;
            wedge = _o446.wedge;
            const LANES(court_bridge_closing_out) _o447 =
                LANES(court_bridge_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]));
            gap = _o447.gap;
            nearing = _o447.nearing;
            swerve = _o447.swerve;
            facing = _o447.facing;
            const LANES(court_neared_body_out) _o448 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o448.nearest;
            wedge = _o448.wedge;
            const LANES(court_end_beside_out) _o449 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[13]));
            gap = _o449.gap;
            const LANES(court_neared_out) _o450 =
                LANES(court_neared)(gap, nearest);
            nearest = _o450.nearest;
            const LANES(court_backboard_parting_out) _o451 =
                LANES(court_backboard_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[18]), lanes_load(lists->fixed[9]));
            V lift = _o451.lift;
            const LANES(court_ring_impact_settling_out) _o452 =
                LANES(court_ring_impact_settling)(bounce, drag, lift, nearest, press, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[161]), lanes_load(lists->fixed[162]), lanes_load(lists->fixed[163]), lanes_load(lists->fixed[164]), lanes_load(lists->fixed[127]), lanes_load(lists->fixed[160]));
            M settles = _o452.settles;
            M lodges = _o452.lodges;
            M slides = _o452.slides;
            M parts = _o452.parts;
            M unsure = _o452.unsure;
            const LANES(court_settled_out) _o453 =
                LANES(court_settled)(K(1.0), lodges, nearly, outcome, parts, settles, slides, K(0.0), unsure);
            mode = lanes_select(_m441, _o453.mode, mode);
            held = lanes_select(_m441, _o453.held, held);
            outcome = lanes_select(_m441, _o453.outcome, outcome);
            slip_left = lanes_select(_m441, _o453.slip_left, slip_left);
        }
        const LANES(court_here_out) _o454 =
            LANES(court_here)(K(2.0), which);
        here = _o454.here;
        const M _m455 = lanes_both(rows, here);
        if (lanes_any(_m455)) {
            const LANES(court_bridge_turning_out) _o456 =
                LANES(court_bridge_turning)(rolled_x, rolled_y, rolled_z, x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[10]));
            V turning_x = _o456.turning_x;
            V turning_y = _o456.turning_y;
            V turning_z = _o456.turning_z;
            const LANES(court_pressed_on_out) _o457 =
                LANES(court_pressed_on)(nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[155]), lanes_load(lists->fixed[123]));
            V press = _o457.press;
            V weight = _o457.weight;
            V drag = _o457.drag;
            V thrust_x = _o457.thrust_x;
            V thrust_y = _o457.thrust_y;
            V thrust_z = _o457.thrust_z;
            const LANES(court_alone_out) _o458 =
                LANES(court_alone)();
            V nearest = _o458.nearest;
            V wedge = _o458.wedge;
            const LANES(court_ring_closing_out) _o459 =
                LANES(court_ring_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]));
            V gap = _o459.gap;
            V nearing = _o459.nearing;
            V swerve = _o459.swerve;
            V facing = _o459.facing;
            const LANES(court_neared_body_out) _o460 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o460.nearest;
            wedge = _o460.wedge;
            const LANES(court_backboard_closing_out) _o461 =
                LANES(court_backboard_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]));
            gap = _o461.gap;
            nearing = _o461.nearing;
            swerve = _o461.swerve;
            facing = _o461.facing;
            const LANES(court_neared_body_out) _o462 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o462.nearest;
            wedge = _o462.wedge;
            const LANES(court_end_beside_out) _o463 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[13]));
            gap = _o463.gap;
            const LANES(court_neared_out) _o464 =
                LANES(court_neared)(gap, nearest);
            nearest = _o464.nearest;
            const LANES(court_bridge_parting_out) _o465 =
                LANES(court_bridge_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[18]), lanes_load(lists->fixed[10]));
            V lift = _o465.lift;
            const LANES(court_ring_impact_settling_out) _o466 =
                LANES(court_ring_impact_settling)(bounce, drag, lift, nearest, press, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[165]), lanes_load(lists->fixed[166]), lanes_load(lists->fixed[167]), lanes_load(lists->fixed[168]), lanes_load(lists->fixed[127]), lanes_load(lists->fixed[160]));
            M settles = _o466.settles;
            M lodges = _o466.lodges;
            M slides = _o466.slides;
            M parts = _o466.parts;
            M unsure = _o466.unsure;
            const LANES(court_settled_out) _o467 =
                LANES(court_settled)(K(2.0), lodges, nearly, outcome, parts, settles, slides, K(0.0), unsure);
            mode = lanes_select(_m455, _o467.mode, mode);
            held = lanes_select(_m455, _o467.held, held);
            outcome = lanes_select(_m455, _o467.outcome, outcome);
            slip_left = lanes_select(_m455, _o467.slip_left, slip_left);
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
            const LANES(court_valid_out) _o3 =
                LANES(court_valid)(last, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]));
            V valid = _o3.valid;
            const LANES(court_admitted_out) _o4 =
                LANES(court_admitted)(K(INFINITY), finite, permitted, valid);
            V outcome = _o4.outcome;
            const LANES(court_passing_start_out) _o5 =
                LANES(court_passing_start)(last, outcome, K(0.0), x, y, z, lanes_load(lists->fixed[13]), lanes_load(lists->fixed[14]));
            V through = _o5.through;
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
            LANES(court_ahead)(job, begun + i);
            if (LANES_SELDOM(varying))
                LANES(court_plain_fix_f6)(lists, i);
            V last = lanes_load(lists->last + i);
            V mode = lanes_load(lists->mode + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const LANES(court_error_bounds_out) _o7 =
                LANES(court_error_bounds)(K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0));
            V time_error = _o7.time_error;
            const LANES(court_scale_out) _o8 =
                LANES(court_scale)(x, y, z, vx, vy, vz, lanes_load(lists->fixed[15]));
            V extent = _o8.extent;
            V speed = _o8.speed;
            V excess = _o8.excess;
            const LANES(court_opening_out) _o9 =
                LANES(court_opening)(excess, K(0.0), K(0.0));
            V when = _o9.when;
            V which = _o9.which;
            const LANES(court_limited_out) _o10 =
                LANES(court_limited)(time_limit);
            M limited = _o10.limited;
            const LANES(court_kept_out) _o11 =
                LANES(court_kept)(mode, when);
            M kept = _o11.kept;
            when = _o11.when;
            M rests = _o11.rests;
            M rolling = _o11.rolling;
            V began = _o11.began;
            const LANES(court_left_out) _o12 =
                LANES(court_left)(K(3.0), last);
            V leaving = _o12.leaving;
            const LANES(court_end_arrival_out) _o13 =
                LANES(court_end_arrival)(leaving, z, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[18]), lanes_load(lists->fixed[19]), lanes_load(lists->fixed[20]));
            V time = _o13.time;
            V rate = _o13.rate;
            V bend = _o13.bend;
            const LANES(court_meeting_plane_out) _o14 =
                LANES(court_meeting_plane)(bend, rate, time);
            M arrives = _o14.arrives;
            const LANES(court_timely_out) _o15 =
                LANES(court_timely)(arrives, K(0.0), K(0.0), time, when);
            M possible = _o15.possible;
            const M _m16 = lanes_both(rows, possible);
            {
                const LANES(court_sooner_out) _o17 =
                    LANES(court_sooner)(arrives, K(3.0), time, when, which);
                when = lanes_select(_m16, _o17.when, when);
                which = lanes_select(_m16, _o17.which, which);
            }
            const LANES(court_horizon_out) _o18 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[15]));
            V until = _o18.horizon;
            const LANES(court_ring_clear_out) _o19 =
                LANES(court_ring_clear)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[23]), lanes_load(lists->fixed[24]), lanes_load(lists->fixed[25]), lanes_load(lists->fixed[26]), lanes_load(lists->fixed[27]), lanes_load(lists->fixed[28]), lanes_load(lists->fixed[29]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[34]), lanes_load(lists->fixed[35]), lanes_load(lists->fixed[36]), lanes_load(lists->fixed[37]), lanes_load(lists->fixed[38]));
            V clear = _o19.clear;
            const LANES(court_opens_in_flight_out) _o20 =
                LANES(court_opens_in_flight)(clear, kept);
            M open = _o20.open;
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
                LANES(court_plain_fix_f21)(lists, i);
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
            const LANES(court_beginning_out) _o22 =
                LANES(court_beginning)();
            V share = _o22.share;
            V arrival = _o22.arrival;
            M certain = _o22.certain;
            const LANES(court_left_out) _o23 =
                LANES(court_left)(K(0.0), last);
            V leaving = _o23.leaving;
            const LANES(court_ring_opened_out) _o24 =
                LANES(court_ring_opened)(lanes_narrow(until), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(extent), lanes_narrow(speed), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[2]), singles_load(lists->fixed_single[3]), singles_load(lists->fixed_single[4]), singles_load(lists->fixed_single[5]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[7]), singles_load(lists->fixed_single[8]), singles_load(lists->fixed_single[9]));
            S onset = _o24.t;
            S wide_end = _o24.end;
            M searching = _o24.searching;
            S wide_low1 = _o24.low1;
            S wide_high1 = _o24.high1;
            S wide_low2 = _o24.low2;
            S wide_high2 = _o24.high2;
            S lapsed = _o24.latest;
            M sound = _o24.sound;
            const LANES(court_opened_out) _o25 =
                LANES(court_opened)(lanes_wide(lapsed), lanes_wide(onset));
            V since = _o25.time;
            const LANES(court_ring_started_out) _o26 =
                LANES(court_ring_started)(x, y, z, vx, vy, vz, lanes_load(lists->fixed[1]));
            V rho_start = _o26.rho_start;
            V parting = _o26.parting;
            V drift = _o26.drift;
            const LANES(court_flight_out) _o27 =
                LANES(court_flight)(since, x, y, z, vx, vy, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[30]));
            V near_x = _o27.x;
            V near_y = _o27.y;
            V near_z = _o27.z;
            V near_vz = _o27.vz;
            const LANES(court_ring_grain_out) _o28 =
                LANES(court_ring_grain)(onset, wide_end, lanes_narrow(leaving), lapsed, lanes_narrow(near_x), lanes_narrow(near_y), lanes_narrow(near_z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(near_vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(parting), lanes_narrow(drift), wide_low1, wide_high1, wide_low2, wide_high2, singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[10]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[11]), singles_load(lists->fixed_single[12]), singles_load(lists->fixed_single[13]), singles_load(lists->fixed_single[14]), singles_load(lists->fixed_single[15]), singles_load(lists->fixed_single[4]), singles_load(lists->fixed_single[16]), singles_load(lists->fixed_single[17]), singles_load(lists->fixed_single[18]));
            S short_share = _o28.share;
            S short_t = _o28.t;
            S short_end = _o28.end;
            S short_x = _o28.x;
            S short_y = _o28.y;
            S short_z = _o28.z;
            S short_vx = _o28.vx;
            S short_vy = _o28.vy;
            S short_vz = _o28.vz;
            S short_steady = _o28.steady;
            S short_swing = _o28.swing;
            S short_rho_start = _o28.rho_start;
            S short_ceiling = _o28.ceiling;
            S short_flat = _o28.flat;
            S short_tilt = _o28.tilt;
            S short_jerk = _o28.jerk;
            S short_grit = _o28.grit;
            S short_parting = _o28.parting;
            S short_drift = _o28.drift;
            S short_rate_margin = _o28.rate_margin;
            S short_low1 = _o28.low1;
            S short_high1 = _o28.high1;
            S short_low2 = _o28.low2;
            S short_high2 = _o28.high2;
            M fits = _o28.fits;
            const LANES(court_coarse_out) _o29 =
                LANES(court_coarse)(lanes_wide(short_ceiling), fits, lanes_wide(short_flat), lanes_wide(short_rate_margin), searching, lanes_wide(short_share), sound);
            M leaping = _o29.leaping;
            searching = _o29.searching;
            M served = _o29.served;
            V ceiling = _o29.ceiling;
            V flat = _o29.flat;
            V tilt = _o29.tilt;
            const M _m30 = lanes_both(rows, leaping);
            if (lanes_any(_m30)) {
                const LANES(court_ring_leap_out) _o31 =
                    LANES(court_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, singles_load(lists->fixed_single[19]), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[20]), singles_load(lists->fixed_single[21]), singles_load(lists->fixed_single[22]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[23]), singles_load(lists->fixed_single[24]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[25]));
                short_t = singles_select(singles_of(_m30), _o31.t, short_t);
                short_end = singles_select(singles_of(_m30), _o31.end, short_end);
                certain = lanes_choose(_m30, _o31.certain, certain);
                leaping = lanes_choose(_m30, _o31.leaping, leaping);
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
                        LANES(court_plain_fix_f32)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_leaping_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M leaping = active;
                const LANES(court_ring_leap_out) _o33 =
                    LANES(court_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, singles_load(lists->fixed_single[19]), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[20]), singles_load(lists->fixed_single[21]), singles_load(lists->fixed_single[22]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[23]), singles_load(lists->fixed_single[24]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[25]));
                short_t = _o33.t;
                short_end = _o33.end;
                M certain = _o33.certain;
                leaping = _o33.leaping;
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
            const LANES(court_leapt_out) _o34 =
                LANES(court_leapt)(arrival, certain, lanes_wide(short_t), searching, served, since);
            arrival = _o34.arrival;
            V t = _o34.t;
            searching = _o34.searching;
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
                LANES(court_plain_fix_f35)(lists, i);
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
            const LANES(court_ring_prepare_out) _o36 =
                LANES(court_ring_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[37]), lanes_load(lists->fixed[27]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[35]), lanes_load(lists->fixed[34]), lanes_load(lists->fixed[39]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[23]), lanes_load(lists->fixed[24]), lanes_load(lists->fixed[25]), lanes_load(lists->fixed[26]));
            V steady = _o36.steady;
            V swing = _o36.swing;
            V rho_start = _o36.rho_start;
            V low0 = _o36.low0;
            V high0 = _o36.high0;
            V low1 = _o36.low1;
            V high1 = _o36.high1;
            V low2 = _o36.low2;
            V high2 = _o36.high2;
            V ceiling = _o36.ceiling;
            V latest = _o36.latest;
            const LANES(court_allowance_out) _o37 =
                LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[16]));
            V position_level = _o37.position_level;
            V velocity_level = _o37.velocity_level;
            const LANES(court_ring_margins_out) _o38 =
                LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[27]), lanes_load(lists->fixed[40]), lanes_load(lists->fixed[41]), lanes_load(lists->fixed[42]), lanes_load(lists->fixed[43]));
            V flat = _o38.margin;
            V tilt = _o38.leaving_margin;
            V rate_slack = _o38.rate_margin;
            const LANES(court_ring_enter_out) _o39 =
                LANES(court_ring_enter)(t, K(0.0), high0, high1, high2, low0, low1, low2, t);
            t = _o39.t;
            V end = _o39.end;
            M searching = _o39.searching;
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
                        LANES(court_plain_fix_f40)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_searching_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o41 =
                    LANES(court_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = _o41.leaving;
                V margin = _o41.margin;
                const LANES(court_ring_advance_out) _o42 =
                    LANES(court_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[44]), lanes_load(lists->fixed[27]), lanes_load(lists->fixed[45]), lanes_load(lists->fixed[46]));
                V gap = _o42.gap;
                V rate = _o42.rate;
                V bend = _o42.bend;
                V step = _o42.step;
                V next = _o42.next;
                V clearance = _o42.clearance;
                const LANES(court_struck_out) _o43 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o43.hit;
                M sure = _o43.sure;
                M vague = _o43.vague;
                const M _m44 = lanes_both(active, vague);
                if (lanes_any(_m44)) {
                    const LANES(court_finer_out) _o45 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m44, _o45.share, share);
                    const LANES(court_allowance_out) _o46 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[16]));
                    V position_level = _o46.position_level;
                    V velocity_level = _o46.velocity_level;
                    const LANES(court_ring_margins_out) _o47 =
                        LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[27]), lanes_load(lists->fixed[40]), lanes_load(lists->fixed[41]), lanes_load(lists->fixed[42]), lanes_load(lists->fixed[43]));
                    flat = lanes_select(_m44, _o47.margin, flat);
                    tilt = lanes_select(_m44, _o47.leaving_margin, tilt);
                    rate_slack = lanes_select(_m44, _o47.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o48 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o48.arrival;
                certain = _o48.certain;
                M exhausted = _o48.exhausted;
                searching = _o48.searching;
                t = _o48.t;
                const M _m49 = lanes_both(active, exhausted);
                {
                    const LANES(court_ring_enter_out) _o50 =
                        LANES(court_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m49, _o50.t, t);
                    end = lanes_select(_m49, _o50.end, end);
                    searching = lanes_choose(_m49, _o50.searching, searching);
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
                LANES(court_plain_fix_f51)(lists, i);
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
            const LANES(court_found_out) _o52 =
                LANES(court_found)(arrival);
            M arrives = _o52.arrives;
            M refining = _o52.refining;
            const LANES(court_nearby_out) _o53 =
                LANES(court_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o53.leaving;
            const M _m54 = lanes_both(rows, refining);
            if (lanes_any(_m54)) {
                const LANES(court_ring_refine_out) _o55 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[8]));
                V refined = _o55.time;
                V gap = _o55.gap;
                V rate = _o55.rate;
                const LANES(court_polished_out) _o56 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m54, _o56.arrival, arrival);
                refining = lanes_choose(_m54, _o56.refining, refining);
            }
            const M _m57 = lanes_both(rows, refining);
            if (lanes_any(_m57)) {
                const LANES(court_ring_refine_out) _o58 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[8]));
                V refined = _o58.time;
                V gap = _o58.gap;
                V rate = _o58.rate;
                const LANES(court_polished_out) _o59 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m57, _o59.arrival, arrival);
                refining = lanes_choose(_m57, _o59.refining, refining);
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
                        LANES(court_plain_fix_f60)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_ring_refine_out) _o61 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[8]));
                V refined = _o61.time;
                V gap = _o61.gap;
                V rate = _o61.rate;
                const LANES(court_polished_out) _o62 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o62.arrival;
                refining = _o62.refining;
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
            const LANES(court_landed_out) _o63 =
                LANES(court_landed)(arrival);
            V time = _o63.time;
            const LANES(court_sooner_out) _o64 =
                LANES(court_sooner)(arrives, K(0.0), time, when, which);
            when = _o64.when;
            which = _o64.which;
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
                LANES(court_plain_fix_f65)(lists, i);
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
            const LANES(court_horizon_out) _o66 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[15]));
            V until = _o66.horizon;
            V pad = _o66.pad;
            const LANES(court_halved_out) _o67 =
                LANES(court_halved)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), K(0.0), pad, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[47]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[48]));
            V middle_x = _o67.middle_x;
            V reach_x = _o67.reach_x;
            V later_middle_x = _o67.later_middle_x;
            V later_reach_x = _o67.later_reach_x;
            V middle_y = _o67.middle_y;
            V reach_y = _o67.reach_y;
            V later_middle_y = _o67.later_middle_y;
            V later_reach_y = _o67.later_reach_y;
            V middle_z = _o67.middle_z;
            V reach_z = _o67.reach_z;
            V later_middle_z = _o67.later_middle_z;
            V later_reach_z = _o67.later_reach_z;
            const LANES(court_backboard_near_out) _o68 =
                LANES(court_backboard_near)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, later_middle_x, later_middle_y, later_middle_z, later_reach_x, later_reach_y, later_reach_z, lanes_load(lists->fixed[49]), lanes_load(lists->fixed[50]), lanes_load(lists->fixed[51]), lanes_load(lists->fixed[52]), lanes_load(lists->fixed[53]), lanes_load(lists->fixed[54]));
            M reachable = _o68.near;
            const LANES(court_reachable_in_flight_out) _o69 =
                LANES(court_reachable_in_flight)(kept, reachable);
            reachable = _o69.reachable;
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
                LANES(court_plain_fix_f70)(lists, i);
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
            const LANES(court_horizon_out) _o71 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[15]));
            V until = _o71.horizon;
            const LANES(court_backboard_prepare_out) _o72 =
                LANES(court_backboard_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[55]), lanes_load(lists->fixed[56]), lanes_load(lists->fixed[57]), lanes_load(lists->fixed[58]), lanes_load(lists->fixed[59]), lanes_load(lists->fixed[60]), lanes_load(lists->fixed[61]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[62]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[63]), lanes_load(lists->fixed[64]), lanes_load(lists->fixed[65]));
            V low0 = _o72.low0;
            V high0 = _o72.high0;
            V low1 = _o72.low1;
            V high1 = _o72.high1;
            V ceiling = _o72.ceiling;
            V latest = _o72.latest;
            const LANES(court_beginning_out) _o73 =
                LANES(court_beginning)();
            V share = _o73.share;
            V arrival = _o73.arrival;
            M certain = _o73.certain;
            const LANES(court_allowance_out) _o74 =
                LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[16]));
            V position_level = _o74.position_level;
            V velocity_level = _o74.velocity_level;
            const LANES(court_backboard_margins_out) _o75 =
                LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[66]), lanes_load(lists->fixed[67]), lanes_load(lists->fixed[68]), lanes_load(lists->fixed[69]), lanes_load(lists->fixed[70]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[72]), lanes_load(lists->fixed[73]), lanes_load(lists->fixed[74]), lanes_load(lists->fixed[75]), lanes_load(lists->fixed[76]));
            V flat = _o75.margin;
            V tilt = _o75.leaving_margin;
            V rate_slack = _o75.rate_margin;
            const LANES(court_backboard_enter_out) _o76 =
                LANES(court_backboard_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o76.t;
            V end = _o76.end;
            M searching = _o76.searching;
            const M _m77 = lanes_both(rows, searching);
            if (lanes_any(_m77)) {
                const LANES(court_nearby_out) _o78 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o78.leaving;
                V margin = _o78.margin;
                const LANES(court_backboard_advance_out) _o79 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[77]), lanes_load(lists->fixed[78]), lanes_load(lists->fixed[67]), lanes_load(lists->fixed[79]));
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
                const M _m81 = lanes_both(_m77, vague);
                if (lanes_any(_m81)) {
                    const LANES(court_finer_out) _o82 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m81, _o82.share, share);
                    const LANES(court_allowance_out) _o83 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[16]));
                    V position_level = _o83.position_level;
                    V velocity_level = _o83.velocity_level;
                    const LANES(court_backboard_margins_out) _o84 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[66]), lanes_load(lists->fixed[67]), lanes_load(lists->fixed[68]), lanes_load(lists->fixed[69]), lanes_load(lists->fixed[70]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[72]), lanes_load(lists->fixed[73]), lanes_load(lists->fixed[74]), lanes_load(lists->fixed[75]), lanes_load(lists->fixed[76]));
                    flat = lanes_select(_m81, _o84.margin, flat);
                    tilt = lanes_select(_m81, _o84.leaving_margin, tilt);
                    rate_slack = lanes_select(_m81, _o84.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o85 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = lanes_select(_m77, _o85.arrival, arrival);
                certain = lanes_choose(_m77, _o85.certain, certain);
                M exhausted = _o85.exhausted;
                searching = lanes_choose(_m77, _o85.searching, searching);
                t = lanes_select(_m77, _o85.t, t);
                const M _m86 = lanes_both(_m77, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o87 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m86, _o87.t, t);
                    end = lanes_select(_m86, _o87.end, end);
                    searching = lanes_choose(_m86, _o87.searching, searching);
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
                        LANES(court_plain_fix_f88)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = reachable_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o89 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o89.leaving;
                V margin = _o89.margin;
                const LANES(court_backboard_advance_out) _o90 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[77]), lanes_load(lists->fixed[78]), lanes_load(lists->fixed[67]), lanes_load(lists->fixed[79]));
                V gap = _o90.gap;
                V rate = _o90.rate;
                V bend = _o90.bend;
                V step = _o90.step;
                V next = _o90.next;
                V clearance = _o90.clearance;
                const LANES(court_struck_or_still_out) _o91 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o91.hit;
                M sure = _o91.sure;
                M vague = _o91.vague;
                const M _m92 = lanes_both(active, vague);
                if (lanes_any(_m92)) {
                    const LANES(court_finer_out) _o93 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m92, _o93.share, share);
                    const LANES(court_allowance_out) _o94 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[16]));
                    V position_level = _o94.position_level;
                    V velocity_level = _o94.velocity_level;
                    const LANES(court_backboard_margins_out) _o95 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[66]), lanes_load(lists->fixed[67]), lanes_load(lists->fixed[68]), lanes_load(lists->fixed[69]), lanes_load(lists->fixed[70]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[72]), lanes_load(lists->fixed[73]), lanes_load(lists->fixed[74]), lanes_load(lists->fixed[75]), lanes_load(lists->fixed[76]));
                    flat = lanes_select(_m92, _o95.margin, flat);
                    tilt = lanes_select(_m92, _o95.leaving_margin, tilt);
                    rate_slack = lanes_select(_m92, _o95.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o96 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o96.arrival;
                certain = _o96.certain;
                M exhausted = _o96.exhausted;
                searching = _o96.searching;
                t = _o96.t;
                const M _m97 = lanes_both(active, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o98 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m97, _o98.t, t);
                    end = lanes_select(_m97, _o98.end, end);
                    searching = lanes_choose(_m97, _o98.searching, searching);
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
                LANES(court_plain_fix_f99)(lists, i);
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
            const LANES(court_found_out) _o100 =
                LANES(court_found)(arrival);
            M arrives = _o100.arrives;
            M refining = _o100.refining;
            const LANES(court_nearby_out) _o101 =
                LANES(court_nearby)(flat, K(1.0), last, arrival, tilt);
            V leaving = _o101.leaving;
            const M _m102 = lanes_both(rows, refining);
            if (lanes_any(_m102)) {
                const LANES(court_backboard_refine_out) _o103 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[77]));
                V refined = _o103.time;
                V gap = _o103.gap;
                V rate = _o103.rate;
                const LANES(court_polished_out) _o104 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m102, _o104.arrival, arrival);
                refining = lanes_choose(_m102, _o104.refining, refining);
            }
            const M _m105 = lanes_both(rows, refining);
            if (lanes_any(_m105)) {
                const LANES(court_backboard_refine_out) _o106 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[77]));
                V refined = _o106.time;
                V gap = _o106.gap;
                V rate = _o106.rate;
                const LANES(court_polished_out) _o107 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m105, _o107.arrival, arrival);
                refining = lanes_choose(_m105, _o107.refining, refining);
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
                        LANES(court_plain_fix_f108)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = reachable_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_backboard_refine_out) _o109 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[77]));
                V refined = _o109.time;
                V gap = _o109.gap;
                V rate = _o109.rate;
                const LANES(court_polished_out) _o110 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o110.arrival;
                refining = _o110.refining;
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
            const LANES(court_landed_out) _o111 =
                LANES(court_landed)(arrival);
            V time = _o111.time;
            const LANES(court_sooner_out) _o112 =
                LANES(court_sooner)(arrives, K(1.0), time, when, which);
            when = _o112.when;
            which = _o112.which;
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
                LANES(court_plain_fix_f113)(lists, i);
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
            const LANES(court_horizon_out) _o114 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[15]));
            V until = _o114.horizon;
            V pad = _o114.pad;
            const LANES(court_halved_out) _o115 =
                LANES(court_halved)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), K(0.0), pad, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[47]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[48]));
            V middle_x = _o115.middle_x;
            V reach_x = _o115.reach_x;
            V later_middle_x = _o115.later_middle_x;
            V later_reach_x = _o115.later_reach_x;
            V middle_y = _o115.middle_y;
            V reach_y = _o115.reach_y;
            V later_middle_y = _o115.later_middle_y;
            V later_reach_y = _o115.later_reach_y;
            V middle_z = _o115.middle_z;
            V reach_z = _o115.reach_z;
            V later_middle_z = _o115.later_middle_z;
            V later_reach_z = _o115.later_reach_z;
            const LANES(court_bridge_near_out) _o116 =
                LANES(court_bridge_near)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, later_middle_x, later_middle_y, later_middle_z, later_reach_x, later_reach_y, later_reach_z, lanes_load(lists->fixed[49]), lanes_load(lists->fixed[80]), lanes_load(lists->fixed[81]), lanes_load(lists->fixed[82]), lanes_load(lists->fixed[83]), lanes_load(lists->fixed[84]));
            M reachable = _o116.near;
            const LANES(court_reachable_in_flight_out) _o117 =
                LANES(court_reachable_in_flight)(kept, reachable);
            reachable = _o117.reachable;
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
                LANES(court_plain_fix_f118)(lists, i);
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
            const LANES(court_horizon_out) _o119 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[15]));
            V until = _o119.horizon;
            const LANES(court_bridge_prepare_out) _o120 =
                LANES(court_bridge_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[85]), lanes_load(lists->fixed[86]), lanes_load(lists->fixed[87]), lanes_load(lists->fixed[88]), lanes_load(lists->fixed[89]), lanes_load(lists->fixed[90]), lanes_load(lists->fixed[91]), lanes_load(lists->fixed[92]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[93]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[94]), lanes_load(lists->fixed[95]), lanes_load(lists->fixed[96]));
            V low0 = _o120.low0;
            V high0 = _o120.high0;
            V low1 = _o120.low1;
            V high1 = _o120.high1;
            V ceiling = _o120.ceiling;
            V latest = _o120.latest;
            const LANES(court_beginning_out) _o121 =
                LANES(court_beginning)();
            V share = _o121.share;
            V arrival = _o121.arrival;
            M certain = _o121.certain;
            const LANES(court_allowance_out) _o122 =
                LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[16]));
            V position_level = _o122.position_level;
            V velocity_level = _o122.velocity_level;
            const LANES(court_bridge_margins_out) _o123 =
                LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[66]), lanes_load(lists->fixed[97]), lanes_load(lists->fixed[98]), lanes_load(lists->fixed[99]), lanes_load(lists->fixed[100]), lanes_load(lists->fixed[101]), lanes_load(lists->fixed[102]), lanes_load(lists->fixed[103]), lanes_load(lists->fixed[104]), lanes_load(lists->fixed[105]), lanes_load(lists->fixed[106]));
            V flat = _o123.margin;
            V tilt = _o123.leaving_margin;
            V rate_slack = _o123.rate_margin;
            const LANES(court_bridge_enter_out) _o124 =
                LANES(court_bridge_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o124.t;
            V end = _o124.end;
            M searching = _o124.searching;
            const M _m125 = lanes_both(rows, searching);
            if (lanes_any(_m125)) {
                const LANES(court_nearby_out) _o126 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o126.leaving;
                V margin = _o126.margin;
                const LANES(court_bridge_advance_out) _o127 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[77]), lanes_load(lists->fixed[78]), lanes_load(lists->fixed[97]), lanes_load(lists->fixed[79]));
                V gap = _o127.gap;
                V rate = _o127.rate;
                V bend = _o127.bend;
                V step = _o127.step;
                V next = _o127.next;
                V clearance = _o127.clearance;
                const LANES(court_struck_or_still_out) _o128 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o128.hit;
                M sure = _o128.sure;
                M vague = _o128.vague;
                const M _m129 = lanes_both(_m125, vague);
                if (lanes_any(_m129)) {
                    const LANES(court_finer_out) _o130 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m129, _o130.share, share);
                    const LANES(court_allowance_out) _o131 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[16]));
                    V position_level = _o131.position_level;
                    V velocity_level = _o131.velocity_level;
                    const LANES(court_bridge_margins_out) _o132 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[66]), lanes_load(lists->fixed[97]), lanes_load(lists->fixed[98]), lanes_load(lists->fixed[99]), lanes_load(lists->fixed[100]), lanes_load(lists->fixed[101]), lanes_load(lists->fixed[102]), lanes_load(lists->fixed[103]), lanes_load(lists->fixed[104]), lanes_load(lists->fixed[105]), lanes_load(lists->fixed[106]));
                    flat = lanes_select(_m129, _o132.margin, flat);
                    tilt = lanes_select(_m129, _o132.leaving_margin, tilt);
                    rate_slack = lanes_select(_m129, _o132.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o133 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = lanes_select(_m125, _o133.arrival, arrival);
                certain = lanes_choose(_m125, _o133.certain, certain);
                M exhausted = _o133.exhausted;
                searching = lanes_choose(_m125, _o133.searching, searching);
                t = lanes_select(_m125, _o133.t, t);
                const M _m134 = lanes_both(_m125, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o135 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m134, _o135.t, t);
                    end = lanes_select(_m134, _o135.end, end);
                    searching = lanes_choose(_m134, _o135.searching, searching);
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
                        LANES(court_plain_fix_f136)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = reachable_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o137 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o137.leaving;
                V margin = _o137.margin;
                const LANES(court_bridge_advance_out) _o138 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[77]), lanes_load(lists->fixed[78]), lanes_load(lists->fixed[97]), lanes_load(lists->fixed[79]));
                V gap = _o138.gap;
                V rate = _o138.rate;
                V bend = _o138.bend;
                V step = _o138.step;
                V next = _o138.next;
                V clearance = _o138.clearance;
                const LANES(court_struck_or_still_out) _o139 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o139.hit;
                M sure = _o139.sure;
                M vague = _o139.vague;
                const M _m140 = lanes_both(active, vague);
                if (lanes_any(_m140)) {
                    const LANES(court_finer_out) _o141 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m140, _o141.share, share);
                    const LANES(court_allowance_out) _o142 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[16]));
                    V position_level = _o142.position_level;
                    V velocity_level = _o142.velocity_level;
                    const LANES(court_bridge_margins_out) _o143 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[66]), lanes_load(lists->fixed[97]), lanes_load(lists->fixed[98]), lanes_load(lists->fixed[99]), lanes_load(lists->fixed[100]), lanes_load(lists->fixed[101]), lanes_load(lists->fixed[102]), lanes_load(lists->fixed[103]), lanes_load(lists->fixed[104]), lanes_load(lists->fixed[105]), lanes_load(lists->fixed[106]));
                    flat = lanes_select(_m140, _o143.margin, flat);
                    tilt = lanes_select(_m140, _o143.leaving_margin, tilt);
                    rate_slack = lanes_select(_m140, _o143.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o144 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o144.arrival;
                certain = _o144.certain;
                M exhausted = _o144.exhausted;
                searching = _o144.searching;
                t = _o144.t;
                const M _m145 = lanes_both(active, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o146 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m145, _o146.t, t);
                    end = lanes_select(_m145, _o146.end, end);
                    searching = lanes_choose(_m145, _o146.searching, searching);
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
                LANES(court_plain_fix_f147)(lists, i);
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
            const LANES(court_found_out) _o148 =
                LANES(court_found)(arrival);
            M arrives = _o148.arrives;
            M refining = _o148.refining;
            const LANES(court_nearby_out) _o149 =
                LANES(court_nearby)(flat, K(2.0), last, arrival, tilt);
            V leaving = _o149.leaving;
            const M _m150 = lanes_both(rows, refining);
            if (lanes_any(_m150)) {
                const LANES(court_bridge_refine_out) _o151 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[77]));
                V refined = _o151.time;
                V gap = _o151.gap;
                V rate = _o151.rate;
                const LANES(court_polished_out) _o152 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m150, _o152.arrival, arrival);
                refining = lanes_choose(_m150, _o152.refining, refining);
            }
            const M _m153 = lanes_both(rows, refining);
            if (lanes_any(_m153)) {
                const LANES(court_bridge_refine_out) _o154 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[77]));
                V refined = _o154.time;
                V gap = _o154.gap;
                V rate = _o154.rate;
                const LANES(court_polished_out) _o155 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m153, _o155.arrival, arrival);
                refining = lanes_choose(_m153, _o155.refining, refining);
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
                        LANES(court_plain_fix_f156)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = reachable_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_bridge_refine_out) _o157 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[77]));
                V refined = _o157.time;
                V gap = _o157.gap;
                V rate = _o157.rate;
                const LANES(court_polished_out) _o158 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o158.arrival;
                refining = _o158.refining;
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
            const LANES(court_landed_out) _o159 =
                LANES(court_landed)(arrival);
            V time = _o159.time;
            const LANES(court_sooner_out) _o160 =
                LANES(court_sooner)(arrives, K(2.0), time, when, which);
            when = _o160.when;
            which = _o160.which;
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
            const M _m161 = lanes_both(rows, limited);
            if (lanes_any(_m161)) {
                const LANES(court_expiry_out) _o162 =
                    LANES(court_expiry)(clock, K(INFINITY), K(0.0), time_error, time_limit, when, which);
                V time = _o162.time;
                M arrives = _o162.arrives;
                const LANES(court_sooner_out) _o163 =
                    LANES(court_sooner)(arrives, K(4.0), time, when, which);
                when = lanes_select(_m161, _o163.when, when);
                which = lanes_select(_m161, _o163.which, which);
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
                LANES(court_plain_fix_f371)(lists, i);
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
            const LANES(court_departed_out) _o372 =
                LANES(court_departed)(K(3.0), which);
            M moves = _o372.moves;
            M ends = _o372.ends;
            M touches = _o372.touches;
            V reached = _o372.reached;
            const LANES(court_body_of_out) _o373 =
                LANES(court_body_of)(which);
            V body = _o373.body;
            const M _m374 = lanes_both(rows, moves);
            if (lanes_any(_m374)) {
                const LANES(court_passing_out) _o375 =
                    LANES(court_passing)(through, when, x, y, z, vx, vy, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[14]));
                through = lanes_select(_m374, _o375.through, through);
                const LANES(court_flight_out) _o376 =
                    LANES(court_flight)(when, x, y, z, vx, vy, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[30]));
                x = lanes_select(_m374, _o376.x, x);
                y = lanes_select(_m374, _o376.y, y);
                z = lanes_select(_m374, _o376.z, z);
                vx = lanes_select(_m374, _o376.vx, vx);
                vy = lanes_select(_m374, _o376.vy, vy);
                vz = lanes_select(_m374, _o376.vz, vz);
                const LANES(court_ticked_out) _o377 =
                    LANES(court_ticked)(clock, when);
                clock = lanes_select(_m374, _o377.clock, clock);
            }
            const M _m378 = lanes_both(rows, limited);
            if (lanes_any(_m378)) {
                const LANES(court_expired_out) _o379 =
                    LANES(court_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m378, _o379.clock, clock);
                body = lanes_select(_m378, _o379.body, body);
                reached = lanes_select(_m378, _o379.reached, reached);
                ends = lanes_choose(_m378, _o379.ends, ends);
            }
            const M _m380 = lanes_both(rows, kept);
            if (lanes_any(_m380)) {
                const LANES(court_kept_on_out) _o381 =
                    LANES(court_kept_on)(began, body, clock, K(INFINITY), ends, held, last, reached, rests, rolling, rolls, which);
                body = lanes_select(_m380, _o381.body, body);
                reached = lanes_select(_m380, _o381.reached, reached);
                ends = lanes_choose(_m380, _o381.ends, ends);
                last = lanes_select(_m380, _o381.last, last);
                mode = lanes_select(_m380, _o381.mode, mode);
                held = lanes_select(_m380, _o381.held, held);
                rolls = lanes_select(_m380, _o381.rolls, rolls);
            }
            const LANES(court_here_out) _o382 =
                LANES(court_here)(K(3.0), which);
            M here = _o382.here;
            const M _m383 = lanes_both(rows, here);
            {
                const LANES(court_end_bounds_out) _o384 =
                    LANES(court_end_bounds)(x, y, lanes_load(lists->fixed[1]));
                V g0 = _o384.g0;
                const LANES(court_end_reached_out) _o385 =
                    LANES(court_end_reached)(g0, through);
                reached = lanes_select(_m383, _o385.reached, reached);
            }
            const LANES(court_accounted_out) _o386 =
                LANES(court_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o386.contacts;
            V outcome = _o386.outcome;
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
            const LANES(court_meeting_out) _o387 =
                LANES(court_meeting)(K(0.0), ends, touches);
            M meeting = _o387.meeting;
            const LANES(court_unslowed_out) _o388 =
                LANES(court_unslowed)();
            M slow = _o388.slow;
            const M _m389 = lanes_both(rows, meeting);
            if (lanes_any(_m389)) {
                const LANES(court_end_normal_out) _o390 =
                    LANES(court_end_normal)();
                V nx = _o390.nx;
                V ny = _o390.ny;
                V nz = _o390.nz;
                const LANES(court_here_out) _o391 =
                    LANES(court_here)(K(0.0), which);
                M here = _o391.here;
                const M _m392 = lanes_both(_m389, here);
                {
                    const LANES(court_ring_normal_out) _o393 =
                        LANES(court_ring_normal)(x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[107]));
                    nx = lanes_select(_m392, _o393.nx, nx);
                    ny = lanes_select(_m392, _o393.ny, ny);
                    nz = lanes_select(_m392, _o393.nz, nz);
                    const LANES(court_counted_out) _o394 =
                        LANES(court_counted)(count_0);
                    count_0 = lanes_select(_m392, _o394.count, count_0);
                }
                const LANES(court_here_out) _o395 =
                    LANES(court_here)(K(1.0), which);
                here = _o395.here;
                const M _m396 = lanes_both(_m389, here);
                {
                    const LANES(court_backboard_normal_out) _o397 =
                        LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[9]));
                    nx = lanes_select(_m396, _o397.nx, nx);
                    ny = lanes_select(_m396, _o397.ny, ny);
                    nz = lanes_select(_m396, _o397.nz, nz);
                    const LANES(court_counted_out) _o398 =
                        LANES(court_counted)(count_1);
                    count_1 = lanes_select(_m396, _o398.count, count_1);
                }
                const LANES(court_here_out) _o399 =
                    LANES(court_here)(K(2.0), which);
                here = _o399.here;
                const M _m400 = lanes_both(_m389, here);
                {
                    const LANES(court_bridge_normal_out) _o401 =
                        LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[10]));
                    nx = lanes_select(_m400, _o401.nx, nx);
                    ny = lanes_select(_m400, _o401.ny, ny);
                    nz = lanes_select(_m400, _o401.nz, nz);
                    const LANES(court_counted_out) _o402 =
                        LANES(court_counted)(count_2);
                    count_2 = lanes_select(_m400, _o402.count, count_2);
                }
                const LANES(court_untaken_out) _o403 =
                    LANES(court_untaken)();
                M struck_0 = _o403.mine;
                const LANES(court_ring_impact_taken_out) _o404 =
                    LANES(court_ring_impact_taken)(p_ring_restitution, p_ring_friction);
                V its_0_ring_impact = _o404.its_0;
                V its_1_ring_impact = _o404.its_1;
                {
                    const double *const _t406[][2] = {
                        {lists->p_ring_friction, lists->p_ring_restitution},
                        {lists->p_backboard_friction, lists->p_backboard_restitution},
                        {lists->p_bridge_friction, lists->p_bridge_restitution},
                    };
                    static const double _t407[][1] = {
                        {0.0},
                        {1.0},
                        {2.0},
                    };
                    for (size_t _k405 = 0; _k405 < 3; _k405++) {
                        const V own_1 = lanes_load(_t406[_k405][0] + (i & varying));
                        const V own_2 = lanes_load(_t406[_k405][1] + (i & varying));
                        const V own_index = K(_t407[_k405][0]);
                        const LANES(court_here_out) _o408 =
                            LANES(court_here)(own_index, which);
                        M here = _o408.here;
                        const M _m409 = lanes_both(_m389, here);
                        if (lanes_any(_m409)) {
                            const LANES(court_ring_impact_taken_out) _o410 =
                                LANES(court_ring_impact_taken)(own_2, own_1);
                            struck_0 = lanes_choose(_m409, _o410.mine, struck_0);
                            its_0_ring_impact = lanes_select(_m409, _o410.its_0, its_0_ring_impact);
                            its_1_ring_impact = lanes_select(_m409, _o410.its_1, its_1_ring_impact);
                        }
                    }
                }
                const M _m411 = lanes_both(_m389, struck_0);
                if (lanes_any(_m411)) {
                    const LANES(court_ring_impact_out) _o412 =
                        LANES(court_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, its_0_ring_impact, its_1_ring_impact, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[150]), lanes_load(lists->fixed[151]), lanes_load(lists->fixed[152]));
                    vx = lanes_select(_m411, _o412.vx, vx);
                    vy = lanes_select(_m411, _o412.vy, vy);
                    vz = lanes_select(_m411, _o412.vz, vz);
                    wx = lanes_select(_m411, _o412.wx, wx);
                    wy = lanes_select(_m411, _o412.wy, wy);
                    wz = lanes_select(_m411, _o412.wz, wz);
                }
                const M _m413 = lanes_both(_m389, touches);
                {
                    const LANES(court_touched_out) _o414 =
                        LANES(court_touched)(body, first, which);
                    first = lanes_select(_m413, _o414.first, first);
                    last = lanes_select(_m413, _o414.last, last);
                    const LANES(court_slowed_out) _o415 =
                        LANES(court_slowed)(nx, ny, nz, K(0.0), vx, vy, vz, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[153]), lanes_load(lists->fixed[154]));
                    slow = lanes_choose(_m413, _o415.slow, slow);
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
            continue;
        }
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
    LANES(court_column) waiting_position_claim;
    LANES(court_column) waiting_velocity_claim;
    LANES(court_column) waiting_spin_claim;
    LANES(court_column) waiting_time_claim;
    LANES(court_column) waiting_outcome;
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
    _Alignas(64) double fixed[180][LANES_WIDTH];
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
    if (out->state)
        for (size_t k = 0; k < shots; k++) {
            out->state[9 * (start + k) + 0] = (double)lists->x[k];
            out->state[9 * (start + k) + 1] = (double)lists->y[k];
            out->state[9 * (start + k) + 2] = (double)lists->z[k];
            out->state[9 * (start + k) + 3] = (double)lists->vx[k];
            out->state[9 * (start + k) + 4] = (double)lists->vy[k];
            out->state[9 * (start + k) + 5] = (double)lists->vz[k];
            out->state[9 * (start + k) + 6] = (double)lists->wx[k];
            out->state[9 * (start + k) + 7] = (double)lists->wy[k];
            out->state[9 * (start + k) + 8] = (double)lists->wz[k];
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
    lanes_pack(lists->waiting_position_claim + lists->waiting, who, lanes_load(lists->position_claim + row));
    lanes_pack(lists->waiting_velocity_claim + lists->waiting, who, lanes_load(lists->velocity_claim + row));
    lanes_pack(lists->waiting_spin_claim + lists->waiting, who, lanes_load(lists->spin_claim + row));
    lanes_pack(lists->waiting_time_claim + lists->waiting, who, lanes_load(lists->time_claim + row));
    lanes_pack(lists->waiting_outcome + lists->waiting, who, lanes_load(lists->outcome + row));
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
    memcpy(lists->x + row, lists->waiting_x + from, shots * sizeof(double));
    memcpy(lists->y + row, lists->waiting_y + from, shots * sizeof(double));
    memcpy(lists->z + row, lists->waiting_z + from, shots * sizeof(double));
    memcpy(lists->vx + row, lists->waiting_vx + from, shots * sizeof(double));
    memcpy(lists->vy + row, lists->waiting_vy + from, shots * sizeof(double));
    memcpy(lists->vz + row, lists->waiting_vz + from, shots * sizeof(double));
    memcpy(lists->wx + row, lists->waiting_wx + from, shots * sizeof(double));
    memcpy(lists->wy + row, lists->waiting_wy + from, shots * sizeof(double));
    memcpy(lists->wz + row, lists->waiting_wz + from, shots * sizeof(double));
    memcpy(lists->dx + row, lists->waiting_dx + from, shots * sizeof(double));
    memcpy(lists->dy + row, lists->waiting_dy + from, shots * sizeof(double));
    memcpy(lists->dz + row, lists->waiting_dz + from, shots * sizeof(double));
    memcpy(lists->dvx + row, lists->waiting_dvx + from, shots * sizeof(double));
    memcpy(lists->dvy + row, lists->waiting_dvy + from, shots * sizeof(double));
    memcpy(lists->dvz + row, lists->waiting_dvz + from, shots * sizeof(double));
    memcpy(lists->dwx + row, lists->waiting_dwx + from, shots * sizeof(double));
    memcpy(lists->dwy + row, lists->waiting_dwy + from, shots * sizeof(double));
    memcpy(lists->dwz + row, lists->waiting_dwz + from, shots * sizeof(double));
    memcpy(lists->clock + row, lists->waiting_clock + from, shots * sizeof(double));
    memcpy(lists->clock_error + row, lists->waiting_clock_error + from, shots * sizeof(double));
    memcpy(lists->last + row, lists->waiting_last + from, shots * sizeof(double));
    memcpy(lists->first + row, lists->waiting_first + from, shots * sizeof(double));
    memcpy(lists->contacts + row, lists->waiting_contacts + from, shots * sizeof(double));
    memcpy(lists->count_0 + row, lists->waiting_count_0 + from, shots * sizeof(double));
    memcpy(lists->count_1 + row, lists->waiting_count_1 + from, shots * sizeof(double));
    memcpy(lists->count_2 + row, lists->waiting_count_2 + from, shots * sizeof(double));
    memcpy(lists->held + row, lists->waiting_held + from, shots * sizeof(double));
    memcpy(lists->mode + row, lists->waiting_mode + from, shots * sizeof(double));
    memcpy(lists->circled + row, lists->waiting_circled + from, shots * sizeof(double));
    memcpy(lists->assured + row, lists->waiting_assured + from, shots * sizeof(double));
    memcpy(lists->rolls + row, lists->waiting_rolls + from, shots * sizeof(double));
    memcpy(lists->slip_left + row, lists->waiting_slip_left + from, shots * sizeof(double));
    memcpy(lists->grip_lost + row, lists->waiting_grip_lost + from, shots * sizeof(double));
    memcpy(lists->taut + row, lists->waiting_taut + from, shots * sizeof(double));
    memcpy(lists->taut_rate + row, lists->waiting_taut_rate + from, shots * sizeof(double));
    memcpy(lists->taut_clock + row, lists->waiting_taut_clock + from, shots * sizeof(double));
    memcpy(lists->through + row, lists->waiting_through + from, shots * sizeof(double));
    memcpy(lists->uncertain + row, lists->waiting_uncertain + from, shots * sizeof(double));
    memcpy(lists->position_claim + row, lists->waiting_position_claim + from, shots * sizeof(double));
    memcpy(lists->velocity_claim + row, lists->waiting_velocity_claim + from, shots * sizeof(double));
    memcpy(lists->spin_claim + row, lists->waiting_spin_claim + from, shots * sizeof(double));
    memcpy(lists->time_claim + row, lists->waiting_time_claim + from, shots * sizeof(double));
    memcpy(lists->outcome + row, lists->waiting_outcome + from, shots * sizeof(double));
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
            lanes_pack(lists->position_claim + kept, going, lanes_load(lists->position_claim + i));
            lanes_pack(lists->velocity_claim + kept, going, lanes_load(lists->velocity_claim + i));
            lanes_pack(lists->spin_claim + kept, going, lanes_load(lists->spin_claim + i));
            lanes_pack(lists->time_claim + kept, going, lanes_load(lists->time_claim + i));
            lanes_pack(lists->outcome + kept, going, lanes_load(lists->outcome + i));
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
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_add(p_board_distance, p_board_thickness);
        const V _s2 = lanes_abs(p_board_bottom);
        const V _s3 = lanes_abs(p_board_top);
        const V _s4 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_abs(p_ball_radius), _s2), lanes_abs(p_board_distance)), lanes_abs(p_board_half_width)), lanes_abs(p_board_thickness)), _s3);
        const V _s5 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s4, lanes_abs(p_bridge_depth)), lanes_abs(p_bridge_half_width)), lanes_abs(p_end_depth)), lanes_abs(p_ring_radius)), lanes_abs(p_wire_radius));
        const V _s6 = lanes_div(K(1.0), p_gravity);
        const V _s7 = lanes_neg(p_gravity);
        const V _s8 = lanes_neg(_s6);
        const V _s9 = lanes_sub(p_ring_radius, _s0);
        const V _s10 = lanes_mul(K(1.00006103515625), _s0);
        const V _s11 = lanes_add(p_ring_radius, _s10);
        const V _s12 = lanes_mul(_s11, _s11);
        const V _s13 = lanes_mul(K(9.313225746154785e-10), _s12);
        const V _s14 = lanes_sub(p_ring_radius, _s10);
        const V _s15 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s16 = lanes_max(_s14, _s15);
        const V _s17 = lanes_mul(_s16, _s16);
        const V _s18 = lanes_div(K(1.0), _s16);
        const V _s19 = lanes_div(_s10, _s16);
        const V _s20 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s21 = lanes_mul(K(0.5), p_board_thickness);
        const V _s22 = lanes_add(p_board_distance, _s21);
        const V _s23 = lanes_mul(K(0.5), p_board_bottom);
        const V _s24 = lanes_mul(K(0.5), p_board_top);
        const V _s25 = lanes_add(_s23, _s24);
        const V _s26 = lanes_add(p_ball_radius, _s21);
        const V _s27 = lanes_add(p_ball_radius, _s24);
        const V _s28 = lanes_sub(_s27, _s23);
        const V _s29 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s30 = lanes_min(_s29, _s26);
        const V _s31 = lanes_min(_s28, _s30);
        const V _s32 = lanes_mul(K(6.103515625e-05), _s31);
        const V _s33 = lanes_abs(_s7);
        const V _s34 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s31));
        const V _s35 = lanes_mul(K(1.25), _s33);
        const V _s36 = lanes_max(_s26, _s29);
        const V _s37 = lanes_mul(K(0.5), p_board_distance);
        const V _s38 = lanes_mul(K(0.5), p_ring_radius);
        const V _s39 = lanes_add(_s37, _s38);
        const V _s40 = lanes_mul(K(0.5), p_bridge_depth);
        const V _s41 = lanes_add(p_ball_radius, _s37);
        const V _s42 = lanes_add(p_ball_radius, _s40);
        const V _s43 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s44 = lanes_sub(_s41, _s38);
        const V _s45 = lanes_min(_s43, _s44);
        const V _s46 = lanes_min(_s42, _s45);
        const V _s47 = lanes_mul(K(6.103515625e-05), _s46);
        const V _s48 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s46));
        const V _s49 = lanes_max(_s44, _s43);
        const V _s50 = lanes_mul(K(3.637978807091713e-12), p_ball_radius);
        const V _s51 = lanes_mul(K(1.4210854715202004e-14), p_ball_radius);
        const V _s52 = lanes_add(lanes_add(_s51, lanes_mul(K(2.842170943040401e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_board_thickness));
        const V _s53 = lanes_add(_s51, lanes_mul(K(2.842170943040401e-14), p_board_half_width));
        const V _s54 = lanes_add(lanes_add(_s51, lanes_mul(K(1.4210854715202004e-14), _s2)), lanes_mul(K(1.4210854715202004e-14), _s3));
        const V _s55 = lanes_add(lanes_add(_s51, lanes_mul(K(1.4210854715202004e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_ring_radius));
        const V _s56 = lanes_add(_s51, lanes_mul(K(2.842170943040401e-14), p_bridge_half_width));
        const V _s57 = lanes_add(lanes_add(_s51, lanes_mul(K(1.4210854715202004e-14), p_wire_radius)), lanes_mul(K(1.4210854715202004e-14), lanes_abs(lanes_sub(p_bridge_depth, p_wire_radius))));
        const V _s58 = lanes_neg(p_board_half_width);
        const V _s59 = lanes_max(K(0.0), _s58);
        const V _s60 = lanes_max(_s59, _s58);
        const V _s61 = lanes_neg(_s1);
        const V _s62 = lanes_max(K(0.0), _s61);
        const V _s63 = lanes_max(_s62, p_board_distance);
        const V _s64 = lanes_neg(p_board_distance);
        const V _s65 = lanes_max(K(0.0), _s64);
        const V _s66 = lanes_max(_s65, p_ring_radius);
        const V _s67 = lanes_neg(p_bridge_half_width);
        const V _s68 = lanes_max(K(0.0), _s67);
        const V _s69 = lanes_max(_s68, _s67);
        const V _s70 = lanes_mul(p_gravity, p_gravity);
        const V _s71 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(p_ball_radius, p_board_distance), p_board_half_width), p_board_thickness), p_bridge_depth), p_bridge_half_width), p_end_depth);
        const V _s72 = lanes_sub(lanes_sub(p_ring_radius, p_ball_radius), p_wire_radius);
        const V _s73 = lanes_add(K(0.4), lanes_mul(K(0.4), p_tangential_restitution));
        const V _s74 = lanes_sub(K(1.0), p_ring_restitution);
        const V _s75 = lanes_add(K(1.0), p_ring_restitution);
        const V _s76 = lanes_sub(K(1.0), p_backboard_restitution);
        const V _s77 = lanes_add(K(1.0), p_backboard_restitution);
        const V _s78 = lanes_sub(K(1.0), p_bridge_restitution);
        const V _s79 = lanes_add(K(1.0), p_bridge_restitution);
        lanes_store(lists->fixed[0], p_ball_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[8], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[9], _s1);
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[11], lanes_add(lanes_mul(K(4.0), p_ball_radius), lanes_mul(K(4.0), p_wire_radius)));
        lanes_store(lists->fixed[12], _s5);
        lanes_store(lists->fixed[13], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[14], lanes_mul(p_ring_radius, p_ring_radius));
        lanes_store(lists->fixed[15], _s6);
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[18], _s7);
        lanes_store(lists->fixed[19], _s8);
        lanes_store(lists->fixed[20], lanes_mul(K(0.5), _s8));
        lanes_store(lists->fixed[21], lanes_mul(K(6.667843360785852e-16), p_end_depth));
        lanes_store(lists->fixed[22], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), _s9));
        lanes_store(lists->fixed[23], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[24], lanes_mul(K(2.0), p_ball_radius));
        lanes_store(lists->fixed[25], lanes_mul(K(2.0), p_wire_radius));
        lanes_store(lists->fixed[26], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[27], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[28], _s10);
        lanes_store(lists->fixed[29], lanes_mul(K(5.820766091346741e-11), _s11));
        lanes_store(lists->fixed[30], lanes_mul(K(65536.0), _s11));
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[32], _s12);
        lanes_store(lists->fixed[33], _s13);
        lanes_store(lists->fixed[34], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[35], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s0));
        lanes_store(lists->fixed[36], _s17);
        lanes_store(lists->fixed[37], lanes_mul(_s16, _s17));
        lanes_store(lists->fixed[38], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[39], lanes_add(_s13, _s17));
        lanes_store(lists->fixed[40], lanes_mul(_s18, lanes_mul(_s18, _s18)));
        lanes_store(lists->fixed[41], _s11);
        lanes_store(lists->fixed[42], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s0), _s11));
        lanes_store(lists->fixed[43], lanes_mul(K(5.00030517578125), _s0));
        lanes_store(lists->fixed[44], lanes_max(K(1.0), _s19));
        lanes_store(lists->fixed[45], lanes_mul(K(6.0), p_gravity));
        lanes_store(lists->fixed[46], lanes_mul(K(9.094947017729282e-13), _s11));
        lanes_store(lists->fixed[47], _s16);
        lanes_store(lists->fixed[48], lanes_abs(K(0.0)));
        lanes_store(lists->fixed[49], lanes_mul(K(0.0625), p_gravity));
        lanes_store(lists->fixed[50], lanes_mul(K(1.0000000009313226), _s20));
        lanes_store(lists->fixed[51], lanes_neg(_s22));
        lanes_store(lists->fixed[52], lanes_mul(K(1.0000000009313226), _s21));
        lanes_store(lists->fixed[53], lanes_mul(K(1.0000000009313226), p_board_half_width));
        lanes_store(lists->fixed[54], _s25);
        lanes_store(lists->fixed[55], lanes_mul(K(1.0000000009313226), lanes_sub(_s24, _s23)));
        lanes_store(lists->fixed[56], _s24);
        lanes_store(lists->fixed[57], _s23);
        lanes_store(lists->fixed[58], _s31);
        lanes_store(lists->fixed[59], lanes_add(_s26, _s32));
        lanes_store(lists->fixed[60], _s22);
        lanes_store(lists->fixed[61], lanes_add(_s29, _s32));
        lanes_store(lists->fixed[62], lanes_sub(lanes_add(_s27, _s32), _s23));
        lanes_store(lists->fixed[63], lanes_mul(_s35, _s34));
        lanes_store(lists->fixed[64], lanes_abs(_s25));
        lanes_store(lists->fixed[65], lanes_max(_s36, _s28));
        lanes_store(lists->fixed[66], lanes_mul(K(1.52587890625e-05), _s31));
        lanes_store(lists->fixed[67], lanes_mul(K(5.55653613398821e-16), _s20));
        lanes_store(lists->fixed[68], _s34);
        lanes_store(lists->fixed[69], lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        lanes_store(lists->fixed[70], lanes_mul(K(2.001953125), _s34));
        lanes_store(lists->fixed[71], lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        lanes_store(lists->fixed[72], lanes_add(lanes_mul(K(2.220446049250313e-16), _s2), lanes_mul(K(2.220446049250313e-16), _s3)));
        lanes_store(lists->fixed[73], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s34, _s34)));
        lanes_store(lists->fixed[74], lanes_mul(K(12.01171875), _s34));
        lanes_store(lists->fixed[75], lanes_mul(K(6.667843360785852e-15), _s34));
        lanes_store(lists->fixed[76], lanes_mul(K(6.005859375), _s34));
        lanes_store(lists->fixed[77], lanes_mul(K(2.667137344314341e-15), _s34));
        lanes_store(lists->fixed[78], _s20);
        lanes_store(lists->fixed[79], _s33);
        lanes_store(lists->fixed[80], lanes_mul(K(0.5), _s33));
        lanes_store(lists->fixed[81], lanes_neg(_s39));
        lanes_store(lists->fixed[82], lanes_mul(K(1.0000000009313226), lanes_sub(_s37, _s38)));
        lanes_store(lists->fixed[83], lanes_mul(K(1.0000000009313226), p_bridge_half_width));
        lanes_store(lists->fixed[84], lanes_sub(p_wire_radius, _s40));
        lanes_store(lists->fixed[85], lanes_mul(K(1.0000000009313226), _s40));
        lanes_store(lists->fixed[86], _s37);
        lanes_store(lists->fixed[87], _s40);
        lanes_store(lists->fixed[88], _s38);
        lanes_store(lists->fixed[89], _s46);
        lanes_store(lists->fixed[90], lanes_sub(lanes_add(_s41, _s47), _s38));
        lanes_store(lists->fixed[91], _s39);
        lanes_store(lists->fixed[92], lanes_add(_s43, _s47));
        lanes_store(lists->fixed[93], lanes_add(_s42, _s47));
        lanes_store(lists->fixed[94], lanes_mul(_s35, _s48));
        lanes_store(lists->fixed[95], lanes_abs(lanes_sub(_s40, p_wire_radius)));
        lanes_store(lists->fixed[96], lanes_max(_s49, _s42));
        lanes_store(lists->fixed[97], lanes_mul(K(1.52587890625e-05), _s46));
        lanes_store(lists->fixed[98], _s48);
        lanes_store(lists->fixed[99], lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        lanes_store(lists->fixed[100], lanes_mul(K(2.001953125), _s48));
        lanes_store(lists->fixed[101], lanes_add(lanes_mul(K(1.1102230246251565e-16), p_board_distance), lanes_mul(K(1.1102230246251565e-16), p_ring_radius)));
        lanes_store(lists->fixed[102], lanes_add(lanes_mul(K(2.220446049250313e-16), p_bridge_depth), lanes_mul(K(5.551115123125783e-16), p_wire_radius)));
        lanes_store(lists->fixed[103], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s48, _s48)));
        lanes_store(lists->fixed[104], lanes_mul(K(12.01171875), _s48));
        lanes_store(lists->fixed[105], lanes_mul(K(6.667843360785852e-15), _s48));
        lanes_store(lists->fixed[106], lanes_mul(K(6.005859375), _s48));
        lanes_store(lists->fixed[107], lanes_mul(K(2.667137344314341e-15), _s48));
        lanes_store(lists->fixed[108], lanes_div(K(1.0), _s0));
        lanes_store(lists->fixed[109], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[110], _s50);
        lanes_store(lists->fixed[111], lanes_neg(_s50));
        lanes_store(lists->fixed[112], lanes_mul(K(1.4551915228366852e-11), p_ball_radius));
        lanes_store(lists->fixed[113], _s52);
        lanes_store(lists->fixed[114], lanes_neg(_s52));
        lanes_store(lists->fixed[115], _s53);
        lanes_store(lists->fixed[116], lanes_neg(_s53));
        lanes_store(lists->fixed[117], _s54);
        lanes_store(lists->fixed[118], lanes_neg(_s54));
        lanes_store(lists->fixed[119], _s55);
        lanes_store(lists->fixed[120], lanes_neg(_s55));
        lanes_store(lists->fixed[121], _s56);
        lanes_store(lists->fixed[122], lanes_neg(_s56));
        lanes_store(lists->fixed[123], _s57);
        lanes_store(lists->fixed[124], lanes_neg(_s57));
        lanes_store(lists->fixed[125], lanes_mul(K(0.6), p_gravity));
        lanes_store(lists->fixed[126], lanes_mul(K(0.015625), p_gravity));
        lanes_store(lists->fixed[127], lanes_mul(K(0.4), p_gravity));
        lanes_store(lists->fixed[128], lanes_mul(p_backboard_friction, p_backboard_friction));
        lanes_store(lists->fixed[129], lanes_mul(p_bridge_friction, p_bridge_friction));
        lanes_store(lists->fixed[130], lanes_mul(K(5.684341886080802e-14), lanes_sqrt(lanes_mul(p_ball_radius, p_gravity))));
        lanes_store(lists->fixed[131], lanes_mul(K(5.684341886080802e-14), p_gravity));
        lanes_store(lists->fixed[132], _s0);
        lanes_store(lists->fixed[133], p_bridge_depth);
        lanes_store(lists->fixed[134], lanes_mul(K(1.1102230246251565e-16), p_ball_radius));
        lanes_store(lists->fixed[135], lanes_mul(K(2.384185791015625e-07), p_ball_radius));
        lanes_store(lists->fixed[136], lanes_mul(K(0.3333333333333333), p_ring_radius));
        lanes_store(lists->fixed[137], lanes_mul(K(0.25), p_ring_radius));
        lanes_store(lists->fixed[138], lanes_mul(K(0.2), p_ring_radius));
        lanes_store(lists->fixed[139], lanes_mul(K(0.16666666666666666), p_ring_radius));
        lanes_store(lists->fixed[140], lanes_mul(K(0.14285714285714285), p_ring_radius));
        lanes_store(lists->fixed[141], lanes_mul(K(0.125), p_ring_radius));
        lanes_store(lists->fixed[142], lanes_mul(K(0.1111111111111111), p_ring_radius));
        lanes_store(lists->fixed[143], lanes_mul(K(0.1), p_ring_radius));
        lanes_store(lists->fixed[144], lanes_mul(K(0.09090909090909091), p_ring_radius));
        lanes_store(lists->fixed[145], lanes_mul(K(0.08333333333333333), p_ring_radius));
        lanes_store(lists->fixed[146], lanes_sqrt(lanes_div(p_gravity, _s0)));
        lanes_store(lists->fixed[147], lanes_div(K(1.0), _s9));
        lanes_store(lists->fixed[148], lanes_mul(K(0.8), p_gravity));
        lanes_store(lists->fixed[149], lanes_mul(p_ring_friction, p_ring_friction));
        lanes_store(lists->fixed[150], lanes_sqrt(lanes_add(lanes_mul(_s60, _s60), lanes_mul(_s63, _s63))));
        lanes_store(lists->fixed[151], lanes_sqrt(lanes_add(lanes_mul(_s66, _s66), lanes_mul(_s69, _s69))));
        lanes_store(lists->fixed[152], lanes_mul(K(0.000244140625), _s0));
        lanes_store(lists->fixed[153], lanes_mul(K(0.00390625), p_gravity));
        lanes_store(lists->fixed[154], lanes_mul(lanes_mul(K(0.000244140625), _s70), _s0));
        lanes_store(lists->fixed[155], lanes_mul(K(6.0), _s70));
        lanes_store(lists->fixed[156], lanes_mul(K(0.0078125), p_gravity));
        lanes_store(lists->fixed[157], lanes_max(K(0.0), p_gravity));
        lanes_store(lists->fixed[158], lanes_mul(K(8.0), _s6));
        lanes_store(lists->fixed[159], lanes_add(lanes_add(lanes_add(lanes_add(_s71, p_ring_radius), p_wire_radius), _s2), _s3));
        lanes_store(lists->fixed[160], lanes_div(K(1.0), lanes_min(_s72, _s0)));
        lanes_store(lists->fixed[161], p_restitution_speed);
        lanes_store(lists->fixed[162], _s73);
        lanes_store(lists->fixed[163], lanes_mul(_s73, _s73));
        lanes_store(lists->fixed[164], lanes_mul(K(7.275957614183426e-12), p_ball_radius));
        lanes_store(lists->fixed[165], lanes_mul(K(1.1920928955078125e-07), p_ball_radius));
        lanes_store(lists->fixed[166], lanes_mul(K(0.4), p_ball_radius));
        lanes_store(lists->fixed[167], _s74);
        lanes_store(lists->fixed[168], lanes_mul(_s74, _s74));
        lanes_store(lists->fixed[169], lanes_mul(p_ring_friction, _s75));
        lanes_store(lists->fixed[170], lanes_mul(_s75, _s74));
        lanes_store(lists->fixed[171], lanes_mul(K(3.725290298461914e-09), p_ball_radius));
        lanes_store(lists->fixed[172], _s76);
        lanes_store(lists->fixed[173], lanes_mul(_s76, _s76));
        lanes_store(lists->fixed[174], lanes_mul(p_backboard_friction, _s77));
        lanes_store(lists->fixed[175], lanes_mul(_s77, _s76));
        lanes_store(lists->fixed[176], _s78);
        lanes_store(lists->fixed[177], lanes_mul(_s78, _s78));
        lanes_store(lists->fixed[178], lanes_mul(p_bridge_friction, _s79));
        lanes_store(lists->fixed[179], lanes_mul(_s79, _s78));
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
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_abs(p_ball_radius), lanes_abs(p_board_bottom)), lanes_abs(p_board_distance)), lanes_abs(p_board_half_width)), lanes_abs(p_board_thickness)), lanes_abs(p_board_top));
        const V _s2 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s1, lanes_abs(p_bridge_depth)), lanes_abs(p_bridge_half_width)), lanes_abs(p_end_depth)), lanes_abs(p_ring_radius)), lanes_abs(p_wire_radius));
        lanes_store(lists->fixed[0], p_ball_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[8], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[11], lanes_add(lanes_mul(K(4.0), p_ball_radius), lanes_mul(K(4.0), p_wire_radius)));
        lanes_store(lists->fixed[12], _s2);
        lanes_store(lists->fixed[13], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[14], lanes_mul(p_ring_radius, p_ring_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f6)(LANES(court_bounded_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[8], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[13], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[15], _s1);
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[18], lanes_neg(p_gravity));
        lanes_store(lists->fixed[19], _s2);
        lanes_store(lists->fixed[20], lanes_mul(K(0.5), _s2));
        lanes_store(lists->fixed[21], lanes_mul(K(6.667843360785852e-16), p_end_depth));
        lanes_store(lists->fixed[22], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s0)));
        lanes_store(lists->fixed[23], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[24], lanes_mul(K(2.0), p_ball_radius));
        lanes_store(lists->fixed[25], lanes_mul(K(2.0), p_wire_radius));
        lanes_store(lists->fixed[26], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[27], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[28], _s3);
        lanes_store(lists->fixed[29], lanes_mul(K(5.820766091346741e-11), _s4));
        lanes_store(lists->fixed[30], lanes_mul(K(65536.0), _s4));
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[32], _s5);
        lanes_store(lists->fixed[33], _s6);
        lanes_store(lists->fixed[34], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[35], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s0));
        lanes_store(lists->fixed[36], _s10);
        lanes_store(lists->fixed[37], lanes_mul(_s9, _s10));
        lanes_store(lists->fixed[38], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[39], lanes_add(_s6, _s10));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f27)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->open_p_ball_radius + i);
    const V p_gravity = lanes_load(lists->open_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->open_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->open_p_wire_radius + i);
    {
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[15], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[22], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, lanes_add(p_ball_radius, p_wire_radius))));
        lanes_store(lists->fixed[23], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[24], lanes_mul(K(2.0), p_ball_radius));
        lanes_store(lists->fixed[25], lanes_mul(K(2.0), p_wire_radius));
        lanes_store(lists->fixed[26], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[27], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
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
static void LANES(court_bounded_fix_f41)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
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
static void LANES(court_bounded_fix_f44)(LANES(court_bounded_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[15], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[22], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s0)));
        lanes_store(lists->fixed[23], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[24], lanes_mul(K(2.0), p_ball_radius));
        lanes_store(lists->fixed[25], lanes_mul(K(2.0), p_wire_radius));
        lanes_store(lists->fixed[26], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[27], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[28], _s1);
        lanes_store(lists->fixed[32], lanes_mul(_s2, _s2));
        lanes_store(lists->fixed[34], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[35], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s0));
        lanes_store(lists->fixed[36], lanes_mul(_s5, _s5));
        lanes_store(lists->fixed[38], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[40], lanes_mul(_s6, lanes_mul(_s6, _s6)));
        lanes_store(lists->fixed[41], _s2);
        lanes_store(lists->fixed[42], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s0), _s2));
        lanes_store(lists->fixed[43], lanes_mul(K(5.00030517578125), _s0));
        lanes_store(lists->fixed[44], lanes_max(K(1.0), _s7));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f49)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
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
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[8], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[28], _s1);
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[41], _s2);
        lanes_store(lists->fixed[42], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s0), _s2));
        lanes_store(lists->fixed[43], lanes_mul(K(5.00030517578125), _s0));
        lanes_store(lists->fixed[44], lanes_max(K(1.0), _s6));
        lanes_store(lists->fixed[45], lanes_mul(K(6.0), p_gravity));
        lanes_store(lists->fixed[46], lanes_mul(K(9.094947017729282e-13), _s2));
        lanes_store(lists->fixed[47], _s5);
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f62)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->open_p_ball_radius + i);
    const V p_gravity = lanes_load(lists->open_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->open_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->open_p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[8], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f71)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
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
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[8], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f74)(LANES(court_bounded_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[28], _s1);
        lanes_store(lists->fixed[41], _s2);
        lanes_store(lists->fixed[42], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s0), _s2));
        lanes_store(lists->fixed[43], lanes_mul(K(5.00030517578125), _s0));
        lanes_store(lists->fixed[44], lanes_max(K(1.0), _s5));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f82)(LANES(court_bounded_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[15], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[48], lanes_abs(K(0.0)));
        lanes_store(lists->fixed[49], lanes_mul(K(0.0625), p_gravity));
        lanes_store(lists->fixed[50], lanes_mul(K(1.0000000009313226), lanes_mul(p_ball_radius, p_ball_radius)));
        lanes_store(lists->fixed[51], lanes_neg(lanes_add(p_board_distance, _s0)));
        lanes_store(lists->fixed[52], lanes_mul(K(1.0000000009313226), _s0));
        lanes_store(lists->fixed[53], lanes_mul(K(1.0000000009313226), p_board_half_width));
        lanes_store(lists->fixed[54], lanes_add(_s1, _s2));
        lanes_store(lists->fixed[55], lanes_mul(K(1.0000000009313226), lanes_sub(_s2, _s1)));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f87)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->reachable_p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->reachable_p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->reachable_p_board_thickness + i);
    const V p_board_top = lanes_load(lists->reachable_p_board_top + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    {
        const V _s0 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s1 = lanes_mul(K(0.5), p_board_thickness);
        const V _s2 = lanes_mul(K(0.5), p_board_bottom);
        const V _s3 = lanes_mul(K(0.5), p_board_top);
        const V _s4 = lanes_add(p_ball_radius, _s1);
        const V _s5 = lanes_add(p_ball_radius, _s3);
        const V _s6 = lanes_sub(_s5, _s2);
        const V _s7 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s8 = lanes_min(_s7, _s4);
        const V _s9 = lanes_min(_s6, _s8);
        const V _s10 = lanes_mul(K(6.103515625e-05), _s9);
        const V _s11 = lanes_abs(lanes_neg(p_gravity));
        const V _s12 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s9));
        const V _s13 = lanes_max(_s4, _s7);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[15], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[23], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[56], _s3);
        lanes_store(lists->fixed[57], _s2);
        lanes_store(lists->fixed[58], _s9);
        lanes_store(lists->fixed[59], lanes_add(_s4, _s10));
        lanes_store(lists->fixed[60], lanes_add(p_board_distance, _s1));
        lanes_store(lists->fixed[61], lanes_add(_s7, _s10));
        lanes_store(lists->fixed[62], lanes_sub(lanes_add(_s5, _s10), _s2));
        lanes_store(lists->fixed[63], lanes_mul(lanes_mul(K(1.25), _s11), _s12));
        lanes_store(lists->fixed[64], lanes_abs(lanes_add(_s2, _s3)));
        lanes_store(lists->fixed[65], lanes_max(_s13, _s6));
        lanes_store(lists->fixed[66], lanes_mul(K(1.52587890625e-05), _s9));
        lanes_store(lists->fixed[67], lanes_mul(K(5.55653613398821e-16), _s0));
        lanes_store(lists->fixed[68], _s12);
        lanes_store(lists->fixed[69], lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        lanes_store(lists->fixed[70], lanes_mul(K(2.001953125), _s12));
        lanes_store(lists->fixed[71], lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        lanes_store(lists->fixed[72], lanes_add(lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_bottom)), lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_top))));
        lanes_store(lists->fixed[73], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s12, _s12)));
        lanes_store(lists->fixed[74], lanes_mul(K(12.01171875), _s12));
        lanes_store(lists->fixed[75], lanes_mul(K(6.667843360785852e-15), _s12));
        lanes_store(lists->fixed[76], lanes_mul(K(6.005859375), _s12));
        lanes_store(lists->fixed[77], lanes_mul(K(2.667137344314341e-15), _s12));
        lanes_store(lists->fixed[78], _s0);
        lanes_store(lists->fixed[79], _s11);
        lanes_store(lists->fixed[80], lanes_mul(K(0.5), _s11));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f107)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
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
        const V _s0 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s1 = lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_thickness));
        const V _s2 = lanes_sub(lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_top)), lanes_mul(K(0.5), p_board_bottom));
        const V _s3 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s4 = lanes_min(_s3, _s1);
        const V _s5 = lanes_abs(lanes_neg(p_gravity));
        const V _s6 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), lanes_min(_s2, _s4)));
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[67], lanes_mul(K(5.55653613398821e-16), _s0));
        lanes_store(lists->fixed[68], _s6);
        lanes_store(lists->fixed[69], lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        lanes_store(lists->fixed[70], lanes_mul(K(2.001953125), _s6));
        lanes_store(lists->fixed[71], lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        lanes_store(lists->fixed[72], lanes_add(lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_bottom)), lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_top))));
        lanes_store(lists->fixed[73], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s6, _s6)));
        lanes_store(lists->fixed[74], lanes_mul(K(12.01171875), _s6));
        lanes_store(lists->fixed[75], lanes_mul(K(6.667843360785852e-15), _s6));
        lanes_store(lists->fixed[76], lanes_mul(K(6.005859375), _s6));
        lanes_store(lists->fixed[77], lanes_mul(K(2.667137344314341e-15), _s6));
        lanes_store(lists->fixed[78], _s0);
        lanes_store(lists->fixed[79], _s5);
        lanes_store(lists->fixed[80], lanes_mul(K(0.5), _s5));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f119)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->reachable_p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->reachable_p_board_half_width + i);
    const V p_board_thickness = lanes_load(lists->reachable_p_board_thickness + i);
    const V p_board_top = lanes_load(lists->reachable_p_board_top + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    {
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[78], lanes_mul(p_ball_radius, p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f129)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
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
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[78], lanes_mul(p_ball_radius, p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f132)(LANES(court_bounded_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[67], lanes_mul(K(5.55653613398821e-16), lanes_mul(p_ball_radius, p_ball_radius)));
        lanes_store(lists->fixed[68], _s4);
        lanes_store(lists->fixed[69], lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        lanes_store(lists->fixed[70], lanes_mul(K(2.001953125), _s4));
        lanes_store(lists->fixed[71], lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        lanes_store(lists->fixed[72], lanes_add(lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_bottom)), lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_top))));
        lanes_store(lists->fixed[73], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s4, _s4)));
        lanes_store(lists->fixed[74], lanes_mul(K(12.01171875), _s4));
        lanes_store(lists->fixed[75], lanes_mul(K(6.667843360785852e-15), _s4));
        lanes_store(lists->fixed[76], lanes_mul(K(6.005859375), _s4));
        lanes_store(lists->fixed[77], lanes_mul(K(2.667137344314341e-15), _s4));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f140)(LANES(court_bounded_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[15], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[48], lanes_abs(K(0.0)));
        lanes_store(lists->fixed[49], lanes_mul(K(0.0625), p_gravity));
        lanes_store(lists->fixed[50], lanes_mul(K(1.0000000009313226), lanes_mul(p_ball_radius, p_ball_radius)));
        lanes_store(lists->fixed[81], lanes_neg(lanes_add(_s0, _s1)));
        lanes_store(lists->fixed[82], lanes_mul(K(1.0000000009313226), lanes_sub(_s0, _s1)));
        lanes_store(lists->fixed[83], lanes_mul(K(1.0000000009313226), p_bridge_half_width));
        lanes_store(lists->fixed[84], lanes_sub(p_wire_radius, _s2));
        lanes_store(lists->fixed[85], lanes_mul(K(1.0000000009313226), _s2));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f145)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_bridge_depth = lanes_load(lists->reachable_p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->reachable_p_bridge_half_width + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->reachable_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->reachable_p_wire_radius + i);
    {
        const V _s0 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s1 = lanes_abs(lanes_neg(p_gravity));
        const V _s2 = lanes_mul(K(0.5), p_board_distance);
        const V _s3 = lanes_mul(K(0.5), p_ring_radius);
        const V _s4 = lanes_mul(K(0.5), p_bridge_depth);
        const V _s5 = lanes_add(p_ball_radius, _s2);
        const V _s6 = lanes_add(p_ball_radius, _s4);
        const V _s7 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s8 = lanes_sub(_s5, _s3);
        const V _s9 = lanes_min(_s7, _s8);
        const V _s10 = lanes_min(_s6, _s9);
        const V _s11 = lanes_mul(K(6.103515625e-05), _s10);
        const V _s12 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s10));
        const V _s13 = lanes_max(_s8, _s7);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[15], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[23], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[67], lanes_mul(K(5.55653613398821e-16), _s0));
        lanes_store(lists->fixed[78], _s0);
        lanes_store(lists->fixed[79], _s1);
        lanes_store(lists->fixed[80], lanes_mul(K(0.5), _s1));
        lanes_store(lists->fixed[86], _s2);
        lanes_store(lists->fixed[87], _s4);
        lanes_store(lists->fixed[88], _s3);
        lanes_store(lists->fixed[89], _s10);
        lanes_store(lists->fixed[90], lanes_sub(lanes_add(_s5, _s11), _s3));
        lanes_store(lists->fixed[91], lanes_add(_s2, _s3));
        lanes_store(lists->fixed[92], lanes_add(_s7, _s11));
        lanes_store(lists->fixed[93], lanes_add(_s6, _s11));
        lanes_store(lists->fixed[94], lanes_mul(lanes_mul(K(1.25), _s1), _s12));
        lanes_store(lists->fixed[95], lanes_abs(lanes_sub(_s4, p_wire_radius)));
        lanes_store(lists->fixed[96], lanes_max(_s13, _s6));
        lanes_store(lists->fixed[97], lanes_mul(K(1.52587890625e-05), _s10));
        lanes_store(lists->fixed[98], _s12);
        lanes_store(lists->fixed[99], lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        lanes_store(lists->fixed[100], lanes_mul(K(2.001953125), _s12));
        lanes_store(lists->fixed[101], lanes_add(lanes_mul(K(1.1102230246251565e-16), p_board_distance), lanes_mul(K(1.1102230246251565e-16), p_ring_radius)));
        lanes_store(lists->fixed[102], lanes_add(lanes_mul(K(2.220446049250313e-16), p_bridge_depth), lanes_mul(K(5.551115123125783e-16), p_wire_radius)));
        lanes_store(lists->fixed[103], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s12, _s12)));
        lanes_store(lists->fixed[104], lanes_mul(K(12.01171875), _s12));
        lanes_store(lists->fixed[105], lanes_mul(K(6.667843360785852e-15), _s12));
        lanes_store(lists->fixed[106], lanes_mul(K(6.005859375), _s12));
        lanes_store(lists->fixed[107], lanes_mul(K(2.667137344314341e-15), _s12));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f165)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
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
        const V _s0 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s1 = lanes_abs(lanes_neg(p_gravity));
        const V _s2 = lanes_add(p_ball_radius, lanes_mul(K(0.5), p_bridge_depth));
        const V _s3 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s4 = lanes_sub(lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_distance)), lanes_mul(K(0.5), p_ring_radius));
        const V _s5 = lanes_min(_s3, _s4);
        const V _s6 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), lanes_min(_s2, _s5)));
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[67], lanes_mul(K(5.55653613398821e-16), _s0));
        lanes_store(lists->fixed[78], _s0);
        lanes_store(lists->fixed[79], _s1);
        lanes_store(lists->fixed[80], lanes_mul(K(0.5), _s1));
        lanes_store(lists->fixed[98], _s6);
        lanes_store(lists->fixed[99], lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        lanes_store(lists->fixed[100], lanes_mul(K(2.001953125), _s6));
        lanes_store(lists->fixed[101], lanes_add(lanes_mul(K(1.1102230246251565e-16), p_board_distance), lanes_mul(K(1.1102230246251565e-16), p_ring_radius)));
        lanes_store(lists->fixed[102], lanes_add(lanes_mul(K(2.220446049250313e-16), p_bridge_depth), lanes_mul(K(5.551115123125783e-16), p_wire_radius)));
        lanes_store(lists->fixed[103], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s6, _s6)));
        lanes_store(lists->fixed[104], lanes_mul(K(12.01171875), _s6));
        lanes_store(lists->fixed[105], lanes_mul(K(6.667843360785852e-15), _s6));
        lanes_store(lists->fixed[106], lanes_mul(K(6.005859375), _s6));
        lanes_store(lists->fixed[107], lanes_mul(K(2.667137344314341e-15), _s6));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f177)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_bridge_depth = lanes_load(lists->reachable_p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->reachable_p_bridge_half_width + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->reachable_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->reachable_p_wire_radius + i);
    {
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[78], lanes_mul(p_ball_radius, p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f187)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
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
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[78], lanes_mul(p_ball_radius, p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f190)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->reachable_p_ball_radius + i);
    const V p_board_distance = lanes_load(lists->reachable_p_board_distance + i);
    const V p_bridge_depth = lanes_load(lists->reachable_p_bridge_depth + i);
    const V p_bridge_half_width = lanes_load(lists->reachable_p_bridge_half_width + i);
    const V p_gravity = lanes_load(lists->reachable_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->reachable_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->reachable_p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, lanes_mul(K(0.5), p_bridge_depth));
        const V _s1 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s2 = lanes_sub(lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_distance)), lanes_mul(K(0.5), p_ring_radius));
        const V _s3 = lanes_min(_s1, _s2);
        const V _s4 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), lanes_min(_s0, _s3)));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[67], lanes_mul(K(5.55653613398821e-16), lanes_mul(p_ball_radius, p_ball_radius)));
        lanes_store(lists->fixed[98], _s4);
        lanes_store(lists->fixed[99], lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        lanes_store(lists->fixed[100], lanes_mul(K(2.001953125), _s4));
        lanes_store(lists->fixed[101], lanes_add(lanes_mul(K(1.1102230246251565e-16), p_board_distance), lanes_mul(K(1.1102230246251565e-16), p_ring_radius)));
        lanes_store(lists->fixed[102], lanes_add(lanes_mul(K(2.220446049250313e-16), p_bridge_depth), lanes_mul(K(5.551115123125783e-16), p_wire_radius)));
        lanes_store(lists->fixed[103], lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s4, _s4)));
        lanes_store(lists->fixed[104], lanes_mul(K(12.01171875), _s4));
        lanes_store(lists->fixed[105], lanes_mul(K(6.667843360785852e-15), _s4));
        lanes_store(lists->fixed[106], lanes_mul(K(6.005859375), _s4));
        lanes_store(lists->fixed[107], lanes_mul(K(2.667137344314341e-15), _s4));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f202)(LANES(court_bounded_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[0], p_ball_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[108], lanes_div(K(1.0), lanes_add(p_ball_radius, p_wire_radius)));
        lanes_store(lists->fixed[109], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[110], _s0);
        lanes_store(lists->fixed[111], lanes_neg(_s0));
        lanes_store(lists->fixed[112], lanes_mul(K(1.4551915228366852e-11), p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f230)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
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
        lanes_store(lists->fixed[0], p_ball_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[13], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[14], lanes_mul(p_ring_radius, p_ring_radius));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[38], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[109], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[110], lanes_mul(K(3.637978807091713e-12), p_ball_radius));
        lanes_store(lists->fixed[113], _s1);
        lanes_store(lists->fixed[114], lanes_neg(_s1));
        lanes_store(lists->fixed[115], _s2);
        lanes_store(lists->fixed[116], lanes_neg(_s2));
        lanes_store(lists->fixed[117], _s3);
        lanes_store(lists->fixed[118], lanes_neg(_s3));
        lanes_store(lists->fixed[119], _s4);
        lanes_store(lists->fixed[120], lanes_neg(_s4));
        lanes_store(lists->fixed[121], _s5);
        lanes_store(lists->fixed[122], lanes_neg(_s5));
        lanes_store(lists->fixed[123], _s6);
        lanes_store(lists->fixed[124], lanes_neg(_s6));
        lanes_store(lists->fixed[125], lanes_mul(K(0.6), p_gravity));
        lanes_store(lists->fixed[126], lanes_mul(K(0.015625), p_gravity));
        lanes_store(lists->fixed[127], lanes_mul(K(0.4), p_gravity));
        lanes_store(lists->fixed[128], lanes_mul(p_backboard_friction, p_backboard_friction));
        lanes_store(lists->fixed[129], lanes_mul(p_bridge_friction, p_bridge_friction));
        lanes_store(lists->fixed[130], lanes_mul(K(5.684341886080802e-14), lanes_sqrt(lanes_mul(p_ball_radius, p_gravity))));
        lanes_store(lists->fixed[131], lanes_mul(K(5.684341886080802e-14), p_gravity));
        lanes_store(lists->fixed[132], lanes_add(p_ball_radius, p_wire_radius));
        lanes_store(lists->fixed[133], p_bridge_depth);
        lanes_store(lists->fixed[134], lanes_mul(K(1.1102230246251565e-16), p_ball_radius));
        lanes_store(lists->fixed[135], lanes_mul(K(2.384185791015625e-07), p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f356)(LANES(court_bounded_lists) *lists, size_t taken, M idle)
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
        lanes_store(lists->fixed[0], p_ball_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[9], _s1);
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[13], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[14], lanes_mul(p_ring_radius, p_ring_radius));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[88], lanes_mul(K(0.5), p_ring_radius));
        lanes_store(lists->fixed[108], lanes_div(K(1.0), _s0));
        lanes_store(lists->fixed[109], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[110], lanes_mul(K(3.637978807091713e-12), p_ball_radius));
        lanes_store(lists->fixed[126], lanes_mul(K(0.015625), p_gravity));
        lanes_store(lists->fixed[130], lanes_mul(K(5.684341886080802e-14), lanes_sqrt(lanes_mul(p_ball_radius, p_gravity))));
        lanes_store(lists->fixed[131], lanes_mul(K(5.684341886080802e-14), p_gravity));
        lanes_store(lists->fixed[132], _s0);
        lanes_store(lists->fixed[134], lanes_mul(K(1.1102230246251565e-16), p_ball_radius));
        lanes_store(lists->fixed[135], lanes_mul(K(2.384185791015625e-07), p_ball_radius));
        lanes_store(lists->fixed[136], lanes_mul(K(0.3333333333333333), p_ring_radius));
        lanes_store(lists->fixed[137], lanes_mul(K(0.25), p_ring_radius));
        lanes_store(lists->fixed[138], lanes_mul(K(0.2), p_ring_radius));
        lanes_store(lists->fixed[139], lanes_mul(K(0.16666666666666666), p_ring_radius));
        lanes_store(lists->fixed[140], lanes_mul(K(0.14285714285714285), p_ring_radius));
        lanes_store(lists->fixed[141], lanes_mul(K(0.125), p_ring_radius));
        lanes_store(lists->fixed[142], lanes_mul(K(0.1111111111111111), p_ring_radius));
        lanes_store(lists->fixed[143], lanes_mul(K(0.1), p_ring_radius));
        lanes_store(lists->fixed[144], lanes_mul(K(0.09090909090909091), p_ring_radius));
        lanes_store(lists->fixed[145], lanes_mul(K(0.08333333333333333), p_ring_radius));
        lanes_store(lists->fixed[146], lanes_sqrt(lanes_div(p_gravity, _s0)));
        lanes_store(lists->fixed[147], lanes_div(K(1.0), lanes_sub(p_ring_radius, _s0)));
        lanes_store(lists->fixed[148], lanes_mul(K(0.8), p_gravity));
        lanes_store(lists->fixed[149], lanes_mul(p_ring_friction, p_ring_friction));
        lanes_store(lists->fixed[150], lanes_sqrt(lanes_add(lanes_mul(_s4, _s4), lanes_mul(_s7, _s7))));
        lanes_store(lists->fixed[151], lanes_sqrt(lanes_add(lanes_mul(_s10, _s10), lanes_mul(_s13, _s13))));
        lanes_store(lists->fixed[152], lanes_mul(K(0.000244140625), _s0));
        lanes_store(lists->fixed[153], lanes_mul(K(0.00390625), p_gravity));
        lanes_store(lists->fixed[154], lanes_mul(lanes_mul(K(0.000244140625), lanes_mul(p_gravity, p_gravity)), _s0));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f425)(LANES(court_bounded_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[0], p_ball_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[13], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[18], lanes_neg(p_gravity));
        lanes_store(lists->fixed[38], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[45], lanes_mul(K(6.0), p_gravity));
        lanes_store(lists->fixed[108], lanes_div(K(1.0), _s0));
        lanes_store(lists->fixed[109], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[113], _s2);
        lanes_store(lists->fixed[114], lanes_neg(_s2));
        lanes_store(lists->fixed[115], _s3);
        lanes_store(lists->fixed[116], lanes_neg(_s3));
        lanes_store(lists->fixed[117], _s4);
        lanes_store(lists->fixed[118], lanes_neg(_s4));
        lanes_store(lists->fixed[119], _s5);
        lanes_store(lists->fixed[120], lanes_neg(_s5));
        lanes_store(lists->fixed[121], _s6);
        lanes_store(lists->fixed[122], lanes_neg(_s6));
        lanes_store(lists->fixed[123], _s7);
        lanes_store(lists->fixed[124], lanes_neg(_s7));
        lanes_store(lists->fixed[131], lanes_mul(K(5.684341886080802e-14), p_gravity));
        lanes_store(lists->fixed[132], _s0);
        lanes_store(lists->fixed[133], p_bridge_depth);
        lanes_store(lists->fixed[155], lanes_mul(K(6.0), lanes_mul(p_gravity, p_gravity)));
        lanes_store(lists->fixed[156], lanes_mul(K(0.0078125), p_gravity));
        lanes_store(lists->fixed[157], lanes_max(K(0.0), p_gravity));
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
            LANES(court_bounded_fix_f425)(lists, i);
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
        const LANES(court_error_bounds_out) _o426 =
            LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
        V position_error = _o426.position_error;
        V velocity_error = _o426.velocity_error;
        const LANES(court_holding_out) _o427 =
            LANES(court_holding)(held, K(0.0));
        M here = _o427.here;
        const M _m428 = lanes_both(rows, here);
        if (lanes_any(_m428)) {
            const LANES(court_ring_tube_out) _o429 =
                LANES(court_ring_tube)(lanes_load(lists->fixed[108]));
            per_reach = lanes_select(_m428, _o429.per_reach, per_reach);
            const LANES(court_ring_parting_out) _o430 =
                LANES(court_ring_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[45]), lanes_load(lists->fixed[155]));
            lift = lanes_select(_m428, _o430.lift, lift);
            surge = lanes_select(_m428, _o430.surge, surge);
            snap = lanes_select(_m428, _o430.snap, snap);
        }
        const LANES(court_holding_out) _o431 =
            LANES(court_holding)(held, K(1.0));
        here = _o431.here;
        const M _m432 = lanes_both(rows, here);
        if (lanes_any(_m432)) {
            const LANES(court_backboard_tube_out) _o433 =
                LANES(court_backboard_tube)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[113]), lanes_load(lists->fixed[114]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[115]), lanes_load(lists->fixed[116]), lanes_load(lists->fixed[117]), lanes_load(lists->fixed[118]), lanes_load(lists->fixed[109]));
            per_reach = lanes_select(_m432, _o433.per_reach, per_reach);
            const LANES(court_backboard_parting_out) _o434 =
                LANES(court_backboard_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[18]), lanes_load(lists->fixed[9]));
            lift = lanes_select(_m432, _o434.lift, lift);
            surge = lanes_select(_m432, _o434.surge, surge);
            snap = lanes_select(_m432, _o434.snap, snap);
        }
        const LANES(court_holding_out) _o435 =
            LANES(court_holding)(held, K(2.0));
        here = _o435.here;
        const M _m436 = lanes_both(rows, here);
        if (lanes_any(_m436)) {
            const LANES(court_bridge_tube_out) _o437 =
                LANES(court_bridge_tube)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[119]), lanes_load(lists->fixed[120]), lanes_load(lists->fixed[121]), lanes_load(lists->fixed[122]), lanes_load(lists->fixed[123]), lanes_load(lists->fixed[124]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[109]));
            per_reach = lanes_select(_m436, _o437.per_reach, per_reach);
            const LANES(court_bridge_parting_out) _o438 =
                LANES(court_bridge_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[18]), lanes_load(lists->fixed[10]));
            lift = lanes_select(_m436, _o438.lift, lift);
            surge = lanes_select(_m436, _o438.surge, surge);
            snap = lanes_select(_m436, _o438.snap, snap);
        }
        const LANES(court_unmet_out) _o439 =
            LANES(court_unmet)();
        V spare = _o439.spare;
        const LANES(court_beside_out) _o440 =
            LANES(court_beside)(held, K(0.0));
        M beside = _o440.beside;
        const M _m441 = lanes_both(rows, beside);
        if (lanes_any(_m441)) {
            const LANES(court_ring_beside_out) _o442 =
                LANES(court_ring_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[38]), lanes_load(lists->fixed[132]));
            V gap = _o442.gap;
            V nearing = _o442.nearing;
            V dent = _o442.dent;
            const LANES(court_spared_out) _o443 =
                LANES(court_spared)(dent, gap, nearing, spare, vx, vy, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[156]));
            spare = lanes_select(_m441, _o443.spare, spare);
        }
        const LANES(court_beside_out) _o444 =
            LANES(court_beside)(held, K(1.0));
        beside = _o444.beside;
        const M _m445 = lanes_both(rows, beside);
        if (lanes_any(_m445)) {
            const LANES(court_backboard_beside_out) _o446 =
                LANES(court_backboard_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]));
            V gap = _o446.gap;
            V nearing = _o446.nearing;
            V dent = _o446.dent;
            const LANES(court_spared_out) _o447 =
                LANES(court_spared)(dent, gap, nearing, spare, vx, vy, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[156]));
            spare = lanes_select(_m445, _o447.spare, spare);
        }
        const LANES(court_beside_out) _o448 =
            LANES(court_beside)(held, K(2.0));
        beside = _o448.beside;
        const M _m449 = lanes_both(rows, beside);
        if (lanes_any(_m449)) {
            const LANES(court_bridge_beside_out) _o450 =
                LANES(court_bridge_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]));
            V gap = _o450.gap;
            V nearing = _o450.nearing;
            V dent = _o450.dent;
            const LANES(court_spared_out) _o451 =
                LANES(court_spared)(dent, gap, nearing, spare, vx, vy, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[156]));
            spare = lanes_select(_m449, _o451.spare, spare);
        }
        const LANES(court_beside_out) _o452 =
            LANES(court_beside)(held, K(3.0));
        beside = _o452.beside;
        const M _m453 = lanes_both(rows, beside);
        if (lanes_any(_m453)) {
            const LANES(court_end_beside_out) _o454 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[13]));
            V gap = _o454.gap;
            V nearing = _o454.nearing;
            V dent = _o454.dent;
            const LANES(court_spared_out) _o455 =
                LANES(court_spared)(dent, gap, nearing, spare, vx, vy, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[156]));
            spare = lanes_select(_m453, _o455.spare, spare);
        }
        const LANES(court_holding_out) _o456 =
            LANES(court_holding)(held, K(1.0));
        here = _o456.here;
        const M _m457 = lanes_both(rows, here);
        if (lanes_any(_m457)) {
            const LANES(court_backboard_seam0_out) _o458 =
                LANES(court_backboard_seam0)(vx, x, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[113]));
            V gap = _o458.gap;
            V nearing = _o458.nearing;
            V near = _o458.near;
            const LANES(court_spared_seam_out) _o459 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[157]));
            spare = lanes_select(_m457, _o459.spare, spare);
            const LANES(court_backboard_seam1_out) _o460 =
                LANES(court_backboard_seam1)(vx, x, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[113]));
            gap = _o460.gap;
            nearing = _o460.nearing;
            near = _o460.near;
            const LANES(court_spared_seam_out) _o461 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[157]));
            spare = lanes_select(_m457, _o461.spare, spare);
            const LANES(court_backboard_seam2_out) _o462 =
                LANES(court_backboard_seam2)(vy, y, lanes_load(lists->fixed[4]), lanes_load(lists->fixed[115]));
            gap = _o462.gap;
            nearing = _o462.nearing;
            near = _o462.near;
            const LANES(court_spared_seam_out) _o463 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[157]));
            spare = lanes_select(_m457, _o463.spare, spare);
            const LANES(court_backboard_seam3_out) _o464 =
                LANES(court_backboard_seam3)(vy, y, lanes_load(lists->fixed[4]), lanes_load(lists->fixed[115]));
            gap = _o464.gap;
            nearing = _o464.nearing;
            near = _o464.near;
            const LANES(court_spared_seam_out) _o465 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[157]));
            spare = lanes_select(_m457, _o465.spare, spare);
            const LANES(court_backboard_seam4_out) _o466 =
                LANES(court_backboard_seam4)(vz, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[117]));
            gap = _o466.gap;
            nearing = _o466.nearing;
            near = _o466.near;
            const LANES(court_spared_seam_out) _o467 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[157]));
            spare = lanes_select(_m457, _o467.spare, spare);
            const LANES(court_backboard_seam5_out) _o468 =
                LANES(court_backboard_seam5)(vz, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[117]));
            gap = _o468.gap;
            nearing = _o468.nearing;
            near = _o468.near;
            const LANES(court_spared_seam_out) _o469 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[157]));
            spare = lanes_select(_m457, _o469.spare, spare);
        }
        const LANES(court_holding_out) _o470 =
            LANES(court_holding)(held, K(2.0));
        here = _o470.here;
        const M _m471 = lanes_both(rows, here);
        if (lanes_any(_m471)) {
            const LANES(court_bridge_seam0_out) _o472 =
                LANES(court_bridge_seam0)(vx, x, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[119]));
            V gap = _o472.gap;
            V nearing = _o472.nearing;
            V near = _o472.near;
            const LANES(court_spared_seam_out) _o473 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[157]));
            spare = lanes_select(_m471, _o473.spare, spare);
            const LANES(court_bridge_seam1_out) _o474 =
                LANES(court_bridge_seam1)(vx, x, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[119]));
            gap = _o474.gap;
            nearing = _o474.nearing;
            near = _o474.near;
            const LANES(court_spared_seam_out) _o475 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[157]));
            spare = lanes_select(_m471, _o475.spare, spare);
            const LANES(court_bridge_seam2_out) _o476 =
                LANES(court_bridge_seam2)(vy, y, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[121]));
            gap = _o476.gap;
            nearing = _o476.nearing;
            near = _o476.near;
            const LANES(court_spared_seam_out) _o477 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[157]));
            spare = lanes_select(_m471, _o477.spare, spare);
            const LANES(court_bridge_seam3_out) _o478 =
                LANES(court_bridge_seam3)(vy, y, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[121]));
            gap = _o478.gap;
            nearing = _o478.nearing;
            near = _o478.near;
            const LANES(court_spared_seam_out) _o479 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[157]));
            spare = lanes_select(_m471, _o479.spare, spare);
            const LANES(court_bridge_seam4_out) _o480 =
                LANES(court_bridge_seam4)(vz, z, lanes_load(lists->fixed[133]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[123]));
            gap = _o480.gap;
            nearing = _o480.nearing;
            near = _o480.near;
            const LANES(court_spared_seam_out) _o481 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[157]));
            spare = lanes_select(_m471, _o481.spare, spare);
            const LANES(court_bridge_seam5_out) _o482 =
                LANES(court_bridge_seam5)(vz, z, lanes_load(lists->fixed[2]), lanes_load(lists->fixed[123]));
            gap = _o482.gap;
            nearing = _o482.nearing;
            near = _o482.near;
            const LANES(court_spared_seam_out) _o483 =
                LANES(court_spared_seam)(gap, near, nearing, spare, lanes_load(lists->fixed[17]), lanes_load(lists->fixed[157]));
            spare = lanes_select(_m471, _o483.spare, spare);
        }
        const LANES(court_parted_out) _o484 =
            LANES(court_parted)(doubt, lift, per_reach, position_error, snap, spare, surge, velocity_error, vx, vy, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[156]), lanes_load(lists->fixed[131]));
        V when = _o484.when;
        doubt = _o484.doubt;
        const LANES(court_hopping_out) _o485 =
            LANES(court_hopping)();
        V which = _o485.which;
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
            LANES(court_bounded_fix_f202)(lists, i);
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
        const LANES(court_resumed_out) _o203 =
            LANES(court_resumed)(clock, mode, position_error, velocity_error);
        V which = _o203.which;
        V late = _o203.late;
        V began = _o203.began;
        V doubt = _o203.doubt;
        M begins = _o203.begins;
        M rolling = _o203.rolling;
        M leaves = _o203.leaves;
        V nx = _o203.nx;
        V ny = _o203.ny;
        V nz = _o203.nz;
        V gap = _o203.gap;
        V bent_x = _o203.bent_x;
        V bent_y = _o203.bent_y;
        V bent_z = _o203.bent_z;
        V lift = _o203.lift;
        V surge = _o203.surge;
        V snap = _o203.snap;
        V per_reach = _o203.per_reach;
        const M _m204 = lanes_both(rows, begins);
        if (lanes_any(_m204)) {
            const LANES(court_holding_out) _o205 =
                LANES(court_holding)(held, K(0.0));
            M here = _o205.here;
            const M _m206 = lanes_both(_m204, here);
            {
                const LANES(court_ring_normal_out) _o207 =
                    LANES(court_ring_normal)(x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[108]));
                nx = lanes_select(_m206, _o207.nx, nx);
                ny = lanes_select(_m206, _o207.ny, ny);
                nz = lanes_select(_m206, _o207.nz, nz);
            }
            const LANES(court_holding_out) _o208 =
                LANES(court_holding)(held, K(1.0));
            here = _o208.here;
            const M _m209 = lanes_both(_m204, here);
            {
                const LANES(court_backboard_normal_out) _o210 =
                    LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[9]));
                nx = lanes_select(_m209, _o210.nx, nx);
                ny = lanes_select(_m209, _o210.ny, ny);
                nz = lanes_select(_m209, _o210.nz, nz);
            }
            const LANES(court_holding_out) _o211 =
                LANES(court_holding)(held, K(2.0));
            here = _o211.here;
            const M _m212 = lanes_both(_m204, here);
            {
                const LANES(court_bridge_normal_out) _o213 =
                    LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[10]));
                nx = lanes_select(_m212, _o213.nx, nx);
                ny = lanes_select(_m212, _o213.ny, ny);
                nz = lanes_select(_m212, _o213.nz, nz);
            }
            const LANES(court_roll_turn_rate_out) _o214 =
                LANES(court_roll_turn_rate)(nx, ny, nz, wx, wy, wz, lanes_load(lists->fixed[0]));
            V turn_rate = _o214.turn_rate;
            const LANES(court_gripped_out) _o215 =
                LANES(court_gripped)(nx, ny, nz, vx, vy, vz, wx, wy, wz, lanes_load(lists->fixed[0]));
            V rolled_x = _o215.rolled_x;
            V rolled_y = _o215.rolled_y;
            V rolled_z = _o215.rolled_z;
            const LANES(court_holding_out) _o216 =
                LANES(court_holding)(held, K(0.0));
            here = _o216.here;
            const M _m217 = lanes_both(_m204, here);
            {
                const LANES(court_ring_off_out) _o218 =
                    LANES(court_ring_off)(x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]));
                gap = lanes_select(_m217, _o218.gap, gap);
            }
            const LANES(court_holding_out) _o219 =
                LANES(court_holding)(held, K(1.0));
            here = _o219.here;
            const M _m220 = lanes_both(_m204, here);
            {
                const LANES(court_backboard_off_out) _o221 =
                    LANES(court_backboard_off)(x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]));
                gap = lanes_select(_m220, _o221.gap, gap);
            }
            const LANES(court_holding_out) _o222 =
                LANES(court_holding)(held, K(2.0));
            here = _o222.here;
            const M _m223 = lanes_both(_m204, here);
            {
                const LANES(court_bridge_off_out) _o224 =
                    LANES(court_bridge_off)(x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]));
                gap = lanes_select(_m223, _o224.gap, gap);
            }
            const LANES(court_roll_placed_out) _o225 =
                LANES(court_roll_placed)(gap, nx, ny, nz, turn_rate, rolled_x, rolled_y, rolled_z, x, y, z, lanes_load(lists->fixed[109]));
            x = lanes_select(_m204, _o225.x, x);
            y = lanes_select(_m204, _o225.y, y);
            z = lanes_select(_m204, _o225.z, z);
            vx = lanes_select(_m204, _o225.vx, vx);
            vy = lanes_select(_m204, _o225.vy, vy);
            vz = lanes_select(_m204, _o225.vz, vz);
            wx = lanes_select(_m204, _o225.wx, wx);
            wy = lanes_select(_m204, _o225.wy, wy);
            wz = lanes_select(_m204, _o225.wz, wz);
            const LANES(court_begun_errors_out) _o226 =
                LANES(court_begun_errors)(dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, vx, vy, vz, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[110]), lanes_load(lists->fixed[111]), lanes_load(lists->fixed[112]));
            dx = lanes_select(_m204, _o226.dx, dx);
            dy = lanes_select(_m204, _o226.dy, dy);
            dz = lanes_select(_m204, _o226.dz, dz);
            dvx = lanes_select(_m204, _o226.dvx, dvx);
            dvy = lanes_select(_m204, _o226.dvy, dvy);
            dvz = lanes_select(_m204, _o226.dvz, dvz);
            dwx = lanes_select(_m204, _o226.dwx, dwx);
            dwy = lanes_select(_m204, _o226.dwy, dwy);
            dwz = lanes_select(_m204, _o226.dwz, dwz);
            const LANES(court_untaut_out) _o227 =
                LANES(court_untaut)();
            taut = lanes_select(_m204, _o227.taut, taut);
            const LANES(court_beginning_contact_out) _o228 =
                LANES(court_beginning_contact)();
            which = lanes_select(_m204, _o228.which, which);
            circled = lanes_select(_m204, _o228.circled, circled);
        }
        const LANES(court_circles_out) _o229 =
            LANES(court_circles)(held, K(0.0), rolling);
        M circling = _o229.circling;
        rolling = _o229.rolling;
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
                    LANES(court_bounded_fix_f230)(lists, taken, idle);
                const size_t room = LANES_WIDTH - busy, left = kept_rolling_shots - taken;
                active = lanes_leading(idle, left, active);
                taken += left < room ? left : room;
                busy += left < room ? left : room;
            }
            if (busy == 0)
                break;
            M rolling = active;
            const LANES(court_error_bounds_out) _o231 =
                LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            V position_error = _o231.position_error;
            V velocity_error = _o231.velocity_error;
            const LANES(court_holding_out) _o232 =
                LANES(court_holding)(held, K(1.0));
            M here = _o232.here;
            const M _m233 = lanes_both(active, here);
            if (lanes_any(_m233)) {
                const LANES(court_backboard_normal_out) _o234 =
                    LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[9]));
                nx = lanes_select(_m233, _o234.nx, nx);
                ny = lanes_select(_m233, _o234.ny, ny);
                nz = lanes_select(_m233, _o234.nz, nz);
                const LANES(court_backboard_tube_out) _o235 =
                    LANES(court_backboard_tube)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[113]), lanes_load(lists->fixed[114]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[115]), lanes_load(lists->fixed[116]), lanes_load(lists->fixed[117]), lanes_load(lists->fixed[118]), lanes_load(lists->fixed[109]));
                bent_x = lanes_select(_m233, _o235.bent_x, bent_x);
                bent_y = lanes_select(_m233, _o235.bent_y, bent_y);
                bent_z = lanes_select(_m233, _o235.bent_z, bent_z);
                per_reach = lanes_select(_m233, _o235.per_reach, per_reach);
            }
            const LANES(court_holding_out) _o236 =
                LANES(court_holding)(held, K(2.0));
            here = _o236.here;
            const M _m237 = lanes_both(active, here);
            if (lanes_any(_m237)) {
                const LANES(court_bridge_normal_out) _o238 =
                    LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[10]));
                nx = lanes_select(_m237, _o238.nx, nx);
                ny = lanes_select(_m237, _o238.ny, ny);
                nz = lanes_select(_m237, _o238.nz, nz);
                const LANES(court_bridge_tube_out) _o239 =
                    LANES(court_bridge_tube)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[119]), lanes_load(lists->fixed[120]), lanes_load(lists->fixed[121]), lanes_load(lists->fixed[122]), lanes_load(lists->fixed[123]), lanes_load(lists->fixed[124]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[109]));
                bent_x = lanes_select(_m237, _o239.bent_x, bent_x);
                bent_y = lanes_select(_m237, _o239.bent_y, bent_y);
                bent_z = lanes_select(_m237, _o239.bent_z, bent_z);
                per_reach = lanes_select(_m237, _o239.per_reach, per_reach);
            }
            const LANES(court_roll_start_out) _o240 =
                LANES(court_roll_start)(nx, ny, nz, vx, vy, vz, wx, wy, wz, lanes_load(lists->fixed[0]));
            V vx_0 = _o240.vx_0;
            V vy_0 = _o240.vy_0;
            V vz_0 = _o240.vz_0;
            V nx_0 = _o240.nx_0;
            V ny_0 = _o240.ny_0;
            V nz_0 = _o240.nz_0;
            V turn_rate_0 = _o240.turn_rate_0;
            const LANES(court_roll_0_out) _o241 =
                LANES(court_roll_0)(bent_x, bent_y, bent_z, nx_0, ny_0, nz_0, per_reach, turn_rate_0, vx_0, vy_0, vz_0, lanes_load(lists->fixed[125]));
            V lift_0 = _o241.lift_0;
            V tx_0 = _o241.tx_0;
            V ty_0 = _o241.ty_0;
            V tz_0 = _o241.tz_0;
            V vx_1 = _o241.vx_1;
            V vy_1 = _o241.vy_1;
            V vz_1 = _o241.vz_1;
            V nx_1 = _o241.nx_1;
            V ny_1 = _o241.ny_1;
            V nz_1 = _o241.nz_1;
            V turn_rate_1 = _o241.turn_rate_1;
            const LANES(court_roll_1_out) _o242 =
                LANES(court_roll_1)(bent_x, bent_y, bent_z, lift_0, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1, lanes_load(lists->fixed[125]));
            V lift_1 = _o242.lift_1;
            V tx_1 = _o242.tx_1;
            V ty_1 = _o242.ty_1;
            V tz_1 = _o242.tz_1;
            V vx_2 = _o242.vx_2;
            V vy_2 = _o242.vy_2;
            V vz_2 = _o242.vz_2;
            V nx_2 = _o242.nx_2;
            V ny_2 = _o242.ny_2;
            V nz_2 = _o242.nz_2;
            V turn_rate_2 = _o242.turn_rate_2;
            const LANES(court_roll_2_out) _o243 =
                LANES(court_roll_2)(bent_x, bent_y, bent_z, lift_0, lift_1, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2, lanes_load(lists->fixed[125]));
            V lift_2 = _o243.lift_2;
            V tx_2 = _o243.tx_2;
            V ty_2 = _o243.ty_2;
            V tz_2 = _o243.tz_2;
            V vx_3 = _o243.vx_3;
            V vy_3 = _o243.vy_3;
            V vz_3 = _o243.vz_3;
            V nx_3 = _o243.nx_3;
            V ny_3 = _o243.ny_3;
            V nz_3 = _o243.nz_3;
            V turn_rate_3 = _o243.turn_rate_3;
            const LANES(court_roll_3_out) _o244 =
                LANES(court_roll_3)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3, lanes_load(lists->fixed[125]));
            V lift_3 = _o244.lift_3;
            V tx_3 = _o244.tx_3;
            V ty_3 = _o244.ty_3;
            V tz_3 = _o244.tz_3;
            V vx_4 = _o244.vx_4;
            V vy_4 = _o244.vy_4;
            V vz_4 = _o244.vz_4;
            V nx_4 = _o244.nx_4;
            V ny_4 = _o244.ny_4;
            V nz_4 = _o244.nz_4;
            V turn_rate_4 = _o244.turn_rate_4;
            const LANES(court_roll_4_out) _o245 =
                LANES(court_roll_4)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4, lanes_load(lists->fixed[125]));
            V lift_4 = _o245.lift_4;
            V tx_4 = _o245.tx_4;
            V ty_4 = _o245.ty_4;
            V tz_4 = _o245.tz_4;
            V vx_5 = _o245.vx_5;
            V vy_5 = _o245.vy_5;
            V vz_5 = _o245.vz_5;
            V nx_5 = _o245.nx_5;
            V ny_5 = _o245.ny_5;
            V nz_5 = _o245.nz_5;
            V turn_rate_5 = _o245.turn_rate_5;
            const LANES(court_roll_5_out) _o246 =
                LANES(court_roll_5)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, lanes_load(lists->fixed[125]));
            V lift_5 = _o246.lift_5;
            V tx_5 = _o246.tx_5;
            V ty_5 = _o246.ty_5;
            V tz_5 = _o246.tz_5;
            V vx_6 = _o246.vx_6;
            V vy_6 = _o246.vy_6;
            V vz_6 = _o246.vz_6;
            V nx_6 = _o246.nx_6;
            V ny_6 = _o246.ny_6;
            V nz_6 = _o246.nz_6;
            V turn_rate_6 = _o246.turn_rate_6;
            const LANES(court_roll_6_out) _o247 =
                LANES(court_roll_6)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, lanes_load(lists->fixed[125]));
            V lift_6 = _o247.lift_6;
            V tx_6 = _o247.tx_6;
            V ty_6 = _o247.ty_6;
            V tz_6 = _o247.tz_6;
            V vx_7 = _o247.vx_7;
            V vy_7 = _o247.vy_7;
            V vz_7 = _o247.vz_7;
            V nx_7 = _o247.nx_7;
            V ny_7 = _o247.ny_7;
            V nz_7 = _o247.nz_7;
            V turn_rate_7 = _o247.turn_rate_7;
            const LANES(court_roll_7_out) _o248 =
                LANES(court_roll_7)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, lanes_load(lists->fixed[125]));
            V lift_7 = _o248.lift_7;
            V vx_8 = _o248.vx_8;
            V vy_8 = _o248.vy_8;
            V vz_8 = _o248.vz_8;
            V nx_8 = _o248.nx_8;
            V ny_8 = _o248.ny_8;
            V nz_8 = _o248.nz_8;
            V turn_rate_8 = _o248.turn_rate_8;
            const LANES(court_roll_pace_out) _o249 =
                LANES(court_roll_pace)(lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, lift_7, nx_8, ny_8, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, nz_8, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[127]));
            V stride = _o249.stride;
            V strongest = _o249.strongest;
            V fastest = _o249.fastest;
            V force = _o249.force;
            V force_rate = _o249.force_rate;
            V force_bend = _o249.force_bend;
            V brace = _o249.brace;
            const LANES(court_pulled_out) _o250 =
                LANES(court_pulled)(nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, turn_rate_0, turn_rate_1, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[127]));
            V drag = _o250.drag;
            V drag_rate = _o250.drag_rate;
            V strain = _o250.strain;
            V strain_rate = _o250.strain_rate;
            const LANES(court_holding_out) _o251 =
                LANES(court_holding)(held, K(1.0));
            here = _o251.here;
            const M _m252 = lanes_both(active, here);
            {
                const LANES(court_ring_impact_strained_out) _o253 =
                    LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, lanes_load(lists->fixed[128]));
                strain = lanes_select(_m252, _o253.strain, strain);
                strain_rate = lanes_select(_m252, _o253.strain_rate, strain_rate);
            }
            const LANES(court_holding_out) _o254 =
                LANES(court_holding)(held, K(2.0));
            here = _o254.here;
            const M _m255 = lanes_both(active, here);
            {
                const LANES(court_ring_impact_strained_out) _o256 =
                    LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, lanes_load(lists->fixed[129]));
                strain = lanes_select(_m255, _o256.strain, strain);
                strain_rate = lanes_select(_m255, _o256.strain_rate, strain_rate);
            }
            const LANES(court_losing_out) _o257 =
                LANES(court_losing)(grip_lost, strain);
            M loses = _o257.loses;
            const M _m258 = lanes_both(active, loses);
            if (lanes_any(_m258)) {
                const LANES(court_lost_grip_out) _o259 =
                    LANES(court_lost_grip)(clock, strain, strain_rate, taut, taut_clock, taut_rate);
                grip_lost = lanes_select(_m258, _o259.grip_lost, grip_lost);
            }
            const LANES(court_tightened_out) _o260 =
                LANES(court_tightened)(clock, strain, strain_rate);
            taut = _o260.taut;
            taut_rate = _o260.taut_rate;
            taut_clock = _o260.taut_clock;
            const LANES(court_leaving_force_out) _o261 =
                LANES(court_leaving_force)(brace, doubt, fastest, force, force_bend, force_rate, per_reach, position_error, stride, velocity_error, vx, vx_1, vy, vy_1, vz, vz_1, which, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[130]), lanes_load(lists->fixed[131]));
            stride = _o261.stride;
            which = _o261.which;
            M rests = _o261.rests;
            doubt = _o261.doubt;
            const LANES(court_beside_out) _o262 =
                LANES(court_beside)(held, K(0.0));
            M beside = _o262.beside;
            const M _m263 = lanes_both(active, beside);
            if (lanes_any(_m263)) {
                const LANES(court_ring_beside_out) _o264 =
                    LANES(court_ring_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[38]), lanes_load(lists->fixed[132]));
                V gap = _o264.gap;
                V nearing = _o264.nearing;
                V dent = _o264.dent;
                const LANES(court_beside_body_out) _o265 =
                    LANES(court_beside_body)(dent, doubt, fastest, gap, K(0.0), late, nearing, position_error, stride, strongest, which, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[110]));
                stride = lanes_select(_m263, _o265.stride, stride);
                which = lanes_select(_m263, _o265.which, which);
                doubt = lanes_select(_m263, _o265.doubt, doubt);
                late = lanes_select(_m263, _o265.late, late);
            }
            const LANES(court_beside_out) _o266 =
                LANES(court_beside)(held, K(1.0));
            beside = _o266.beside;
            const M _m267 = lanes_both(active, beside);
            if (lanes_any(_m267)) {
                const LANES(court_backboard_beside_out) _o268 =
                    LANES(court_backboard_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]));
                V gap = _o268.gap;
                V nearing = _o268.nearing;
                V dent = _o268.dent;
                const LANES(court_beside_body_out) _o269 =
                    LANES(court_beside_body)(dent, doubt, fastest, gap, K(1.0), late, nearing, position_error, stride, strongest, which, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[110]));
                stride = lanes_select(_m267, _o269.stride, stride);
                which = lanes_select(_m267, _o269.which, which);
                doubt = lanes_select(_m267, _o269.doubt, doubt);
                late = lanes_select(_m267, _o269.late, late);
            }
            const LANES(court_beside_out) _o270 =
                LANES(court_beside)(held, K(2.0));
            beside = _o270.beside;
            const M _m271 = lanes_both(active, beside);
            if (lanes_any(_m271)) {
                const LANES(court_bridge_beside_out) _o272 =
                    LANES(court_bridge_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]));
                V gap = _o272.gap;
                V nearing = _o272.nearing;
                V dent = _o272.dent;
                const LANES(court_beside_body_out) _o273 =
                    LANES(court_beside_body)(dent, doubt, fastest, gap, K(2.0), late, nearing, position_error, stride, strongest, which, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[110]));
                stride = lanes_select(_m271, _o273.stride, stride);
                which = lanes_select(_m271, _o273.which, which);
                doubt = lanes_select(_m271, _o273.doubt, doubt);
                late = lanes_select(_m271, _o273.late, late);
            }
            const LANES(court_end_beside_out) _o274 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[13]));
            V gap = _o274.gap;
            V nearing = _o274.nearing;
            V dent = _o274.dent;
            const LANES(court_beside_gate_out) _o275 =
                LANES(court_beside_gate)(dent, doubt, fastest, gap, K(3.0), late, nearing, position_error, stride, strongest, which, x, y, z, lanes_load(lists->fixed[0]));
            stride = _o275.stride;
            which = _o275.which;
            doubt = _o275.doubt;
            late = _o275.late;
            const LANES(court_holding_out) _o276 =
                LANES(court_holding)(held, K(1.0));
            here = _o276.here;
            const M _m277 = lanes_both(active, here);
            if (lanes_any(_m277)) {
                const LANES(court_backboard_seam0_out) _o278 =
                    LANES(court_backboard_seam0)(vx, x, lanes_load(lists->fixed[9]), lanes_load(lists->fixed[113]));
                gap = lanes_select(_m277, _o278.gap, gap);
                V nearing = _o278.nearing;
                V near = _o278.near;
                const LANES(court_beside_seam_out) _o279 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m277, _o279.stride, stride);
                const LANES(court_backboard_seam1_out) _o280 =
                    LANES(court_backboard_seam1)(vx, x, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[113]));
                gap = lanes_select(_m277, _o280.gap, gap);
                nearing = _o280.nearing;
                near = _o280.near;
                const LANES(court_beside_seam_out) _o281 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m277, _o281.stride, stride);
                const LANES(court_backboard_seam2_out) _o282 =
                    LANES(court_backboard_seam2)(vy, y, lanes_load(lists->fixed[4]), lanes_load(lists->fixed[115]));
                gap = lanes_select(_m277, _o282.gap, gap);
                nearing = _o282.nearing;
                near = _o282.near;
                const LANES(court_beside_seam_out) _o283 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m277, _o283.stride, stride);
                const LANES(court_backboard_seam3_out) _o284 =
                    LANES(court_backboard_seam3)(vy, y, lanes_load(lists->fixed[4]), lanes_load(lists->fixed[115]));
                gap = lanes_select(_m277, _o284.gap, gap);
                nearing = _o284.nearing;
                near = _o284.near;
                const LANES(court_beside_seam_out) _o285 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m277, _o285.stride, stride);
                const LANES(court_backboard_seam4_out) _o286 =
                    LANES(court_backboard_seam4)(vz, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[117]));
                gap = lanes_select(_m277, _o286.gap, gap);
                nearing = _o286.nearing;
                near = _o286.near;
                const LANES(court_beside_seam_out) _o287 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m277, _o287.stride, stride);
                const LANES(court_backboard_seam5_out) _o288 =
                    LANES(court_backboard_seam5)(vz, z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[117]));
                gap = lanes_select(_m277, _o288.gap, gap);
                nearing = _o288.nearing;
                near = _o288.near;
                const LANES(court_beside_seam_out) _o289 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m277, _o289.stride, stride);
            }
            const LANES(court_holding_out) _o290 =
                LANES(court_holding)(held, K(2.0));
            here = _o290.here;
            const M _m291 = lanes_both(active, here);
            if (lanes_any(_m291)) {
                const LANES(court_bridge_seam0_out) _o292 =
                    LANES(court_bridge_seam0)(vx, x, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[119]));
                gap = lanes_select(_m291, _o292.gap, gap);
                V nearing = _o292.nearing;
                V near = _o292.near;
                const LANES(court_beside_seam_out) _o293 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m291, _o293.stride, stride);
                const LANES(court_bridge_seam1_out) _o294 =
                    LANES(court_bridge_seam1)(vx, x, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[119]));
                gap = lanes_select(_m291, _o294.gap, gap);
                nearing = _o294.nearing;
                near = _o294.near;
                const LANES(court_beside_seam_out) _o295 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m291, _o295.stride, stride);
                const LANES(court_bridge_seam2_out) _o296 =
                    LANES(court_bridge_seam2)(vy, y, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[121]));
                gap = lanes_select(_m291, _o296.gap, gap);
                nearing = _o296.nearing;
                near = _o296.near;
                const LANES(court_beside_seam_out) _o297 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m291, _o297.stride, stride);
                const LANES(court_bridge_seam3_out) _o298 =
                    LANES(court_bridge_seam3)(vy, y, lanes_load(lists->fixed[7]), lanes_load(lists->fixed[121]));
                gap = lanes_select(_m291, _o298.gap, gap);
                nearing = _o298.nearing;
                near = _o298.near;
                const LANES(court_beside_seam_out) _o299 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m291, _o299.stride, stride);
                const LANES(court_bridge_seam4_out) _o300 =
                    LANES(court_bridge_seam4)(vz, z, lanes_load(lists->fixed[133]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[123]));
                gap = lanes_select(_m291, _o300.gap, gap);
                nearing = _o300.nearing;
                near = _o300.near;
                const LANES(court_beside_seam_out) _o301 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m291, _o301.stride, stride);
                const LANES(court_bridge_seam5_out) _o302 =
                    LANES(court_bridge_seam5)(vz, z, lanes_load(lists->fixed[2]), lanes_load(lists->fixed[123]));
                gap = lanes_select(_m291, _o302.gap, gap);
                nearing = _o302.nearing;
                near = _o302.near;
                const LANES(court_beside_seam_out) _o303 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m291, _o303.stride, stride);
            }
            const LANES(court_beside_time_out) _o304 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o304.stride;
            which = _o304.which;
            const LANES(court_apart_out) _o305 =
                LANES(court_apart)(dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[134]), lanes_load(lists->fixed[135]));
            V apart = _o305.apart;
            const LANES(court_neighbour_out) _o306 =
                LANES(court_neighbour)(apart, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, vx, vy, vz, wx, wy, wz, x, y, z);
            V far_x = _o306.far_x;
            V far_y = _o306.far_y;
            V far_z = _o306.far_z;
            V far_vx = _o306.far_vx;
            V far_vy = _o306.far_vy;
            V far_vz = _o306.far_vz;
            V far_wx = _o306.far_wx;
            V far_wy = _o306.far_wy;
            V far_wz = _o306.far_wz;
            V far_nx = _o306.far_nx;
            V far_ny = _o306.far_ny;
            V far_nz = _o306.far_nz;
            V far_gap = _o306.far_gap;
            const LANES(court_passing_from_out) _o307 =
                LANES(court_passing_from)(z);
            M over = _o307.over;
            const LANES(court_roll_moved_out) _o308 =
                LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, x, y, z);
            x = _o308.x;
            vx = _o308.vx;
            y = _o308.y;
            vy = _o308.vy;
            z = _o308.z;
            vz = _o308.vz;
            V turn_rate = _o308.turn_rate;
            const LANES(court_holding_out) _o309 =
                LANES(court_holding)(held, K(1.0));
            here = _o309.here;
            const M _m310 = lanes_both(active, here);
            if (lanes_any(_m310)) {
                const LANES(court_backboard_normal_out) _o311 =
                    LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[9]));
                nx = lanes_select(_m310, _o311.nx, nx);
                ny = lanes_select(_m310, _o311.ny, ny);
                nz = lanes_select(_m310, _o311.nz, nz);
                const LANES(court_backboard_off_out) _o312 =
                    LANES(court_backboard_off)(x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]));
                gap = lanes_select(_m310, _o312.gap, gap);
            }
            const LANES(court_holding_out) _o313 =
                LANES(court_holding)(held, K(2.0));
            here = _o313.here;
            const M _m314 = lanes_both(active, here);
            if (lanes_any(_m314)) {
                const LANES(court_bridge_normal_out) _o315 =
                    LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[10]));
                nx = lanes_select(_m314, _o315.nx, nx);
                ny = lanes_select(_m314, _o315.ny, ny);
                nz = lanes_select(_m314, _o315.nz, nz);
                const LANES(court_bridge_off_out) _o316 =
                    LANES(court_bridge_off)(x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]));
                gap = lanes_select(_m314, _o316.gap, gap);
            }
            const LANES(court_roll_placed_out) _o317 =
                LANES(court_roll_placed)(gap, nx, ny, nz, turn_rate, vx, vy, vz, x, y, z, lanes_load(lists->fixed[109]));
            x = _o317.x;
            y = _o317.y;
            z = _o317.z;
            vx = _o317.vx;
            vy = _o317.vy;
            vz = _o317.vz;
            wx = _o317.wx;
            wy = _o317.wy;
            wz = _o317.wz;
            const LANES(court_passing_in_contact_out) _o318 =
                LANES(court_passing_in_contact)(over, through, x, y, z, lanes_load(lists->fixed[14]));
            through = _o318.through;
            const LANES(court_holding_out) _o319 =
                LANES(court_holding)(held, K(1.0));
            here = _o319.here;
            const M _m320 = lanes_both(active, here);
            {
                const LANES(court_backboard_normal_out) _o321 =
                    LANES(court_backboard_normal)(far_x, far_y, far_z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[9]));
                far_nx = lanes_select(_m320, _o321.nx, far_nx);
                far_ny = lanes_select(_m320, _o321.ny, far_ny);
                far_nz = lanes_select(_m320, _o321.nz, far_nz);
            }
            const LANES(court_holding_out) _o322 =
                LANES(court_holding)(held, K(2.0));
            here = _o322.here;
            const M _m323 = lanes_both(active, here);
            {
                const LANES(court_bridge_normal_out) _o324 =
                    LANES(court_bridge_normal)(far_x, far_y, far_z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[10]));
                far_nx = lanes_select(_m323, _o324.nx, far_nx);
                far_ny = lanes_select(_m323, _o324.ny, far_ny);
                far_nz = lanes_select(_m323, _o324.nz, far_nz);
            }
            const LANES(court_roll_turn_rate_out) _o325 =
                LANES(court_roll_turn_rate)(far_nx, far_ny, far_nz, far_wx, far_wy, far_wz, lanes_load(lists->fixed[0]));
            turn_rate = _o325.turn_rate;
            const LANES(court_holding_out) _o326 =
                LANES(court_holding)(held, K(1.0));
            here = _o326.here;
            const M _m327 = lanes_both(active, here);
            if (lanes_any(_m327)) {
                const LANES(court_backboard_normal_out) _o328 =
                    LANES(court_backboard_normal)(far_x, far_y, far_z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[9]));
                far_nx = lanes_select(_m327, _o328.nx, far_nx);
                far_ny = lanes_select(_m327, _o328.ny, far_ny);
                far_nz = lanes_select(_m327, _o328.nz, far_nz);
                const LANES(court_backboard_off_out) _o329 =
                    LANES(court_backboard_off)(far_x, far_y, far_z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]));
                far_gap = lanes_select(_m327, _o329.gap, far_gap);
            }
            const LANES(court_holding_out) _o330 =
                LANES(court_holding)(held, K(2.0));
            here = _o330.here;
            const M _m331 = lanes_both(active, here);
            if (lanes_any(_m331)) {
                const LANES(court_bridge_normal_out) _o332 =
                    LANES(court_bridge_normal)(far_x, far_y, far_z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[10]));
                far_nx = lanes_select(_m331, _o332.nx, far_nx);
                far_ny = lanes_select(_m331, _o332.ny, far_ny);
                far_nz = lanes_select(_m331, _o332.nz, far_nz);
                const LANES(court_bridge_off_out) _o333 =
                    LANES(court_bridge_off)(far_x, far_y, far_z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]));
                far_gap = lanes_select(_m331, _o333.gap, far_gap);
            }
            const LANES(court_roll_placed_out) _o334 =
                LANES(court_roll_placed)(far_gap, far_nx, far_ny, far_nz, turn_rate, far_vx, far_vy, far_vz, far_x, far_y, far_z, lanes_load(lists->fixed[109]));
            far_x = _o334.x;
            far_y = _o334.y;
            far_z = _o334.z;
            far_vx = _o334.vx;
            far_vy = _o334.vy;
            far_vz = _o334.vz;
            far_wx = _o334.wx;
            far_wy = _o334.wy;
            far_wz = _o334.wz;
            const LANES(court_roll_start_out) _o335 =
                LANES(court_roll_start)(far_nx, far_ny, far_nz, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, lanes_load(lists->fixed[0]));
            vx_0 = _o335.vx_0;
            vy_0 = _o335.vy_0;
            vz_0 = _o335.vz_0;
            nx_0 = _o335.nx_0;
            ny_0 = _o335.ny_0;
            nz_0 = _o335.nz_0;
            turn_rate_0 = _o335.turn_rate_0;
            const LANES(court_roll_0_out) _o336 =
                LANES(court_roll_0)(bent_x, bent_y, bent_z, nx_0, ny_0, nz_0, per_reach, turn_rate_0, vx_0, vy_0, vz_0, lanes_load(lists->fixed[125]));
            lift_0 = _o336.lift_0;
            tx_0 = _o336.tx_0;
            ty_0 = _o336.ty_0;
            tz_0 = _o336.tz_0;
            vx_1 = _o336.vx_1;
            vy_1 = _o336.vy_1;
            vz_1 = _o336.vz_1;
            nx_1 = _o336.nx_1;
            ny_1 = _o336.ny_1;
            nz_1 = _o336.nz_1;
            turn_rate_1 = _o336.turn_rate_1;
            const LANES(court_roll_1_out) _o337 =
                LANES(court_roll_1)(bent_x, bent_y, bent_z, lift_0, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1, lanes_load(lists->fixed[125]));
            lift_1 = _o337.lift_1;
            tx_1 = _o337.tx_1;
            ty_1 = _o337.ty_1;
            tz_1 = _o337.tz_1;
            vx_2 = _o337.vx_2;
            vy_2 = _o337.vy_2;
            vz_2 = _o337.vz_2;
            nx_2 = _o337.nx_2;
            ny_2 = _o337.ny_2;
            nz_2 = _o337.nz_2;
            turn_rate_2 = _o337.turn_rate_2;
            const LANES(court_roll_2_out) _o338 =
                LANES(court_roll_2)(bent_x, bent_y, bent_z, lift_0, lift_1, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2, lanes_load(lists->fixed[125]));
            lift_2 = _o338.lift_2;
            tx_2 = _o338.tx_2;
            ty_2 = _o338.ty_2;
            tz_2 = _o338.tz_2;
            vx_3 = _o338.vx_3;
            vy_3 = _o338.vy_3;
            vz_3 = _o338.vz_3;
            nx_3 = _o338.nx_3;
            ny_3 = _o338.ny_3;
            nz_3 = _o338.nz_3;
            turn_rate_3 = _o338.turn_rate_3;
            const LANES(court_roll_3_out) _o339 =
                LANES(court_roll_3)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3, lanes_load(lists->fixed[125]));
            lift_3 = _o339.lift_3;
            tx_3 = _o339.tx_3;
            ty_3 = _o339.ty_3;
            tz_3 = _o339.tz_3;
            vx_4 = _o339.vx_4;
            vy_4 = _o339.vy_4;
            vz_4 = _o339.vz_4;
            nx_4 = _o339.nx_4;
            ny_4 = _o339.ny_4;
            nz_4 = _o339.nz_4;
            turn_rate_4 = _o339.turn_rate_4;
            const LANES(court_roll_4_out) _o340 =
                LANES(court_roll_4)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4, lanes_load(lists->fixed[125]));
            lift_4 = _o340.lift_4;
            tx_4 = _o340.tx_4;
            ty_4 = _o340.ty_4;
            tz_4 = _o340.tz_4;
            vx_5 = _o340.vx_5;
            vy_5 = _o340.vy_5;
            vz_5 = _o340.vz_5;
            nx_5 = _o340.nx_5;
            ny_5 = _o340.ny_5;
            nz_5 = _o340.nz_5;
            turn_rate_5 = _o340.turn_rate_5;
            const LANES(court_roll_5_out) _o341 =
                LANES(court_roll_5)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, lanes_load(lists->fixed[125]));
            lift_5 = _o341.lift_5;
            tx_5 = _o341.tx_5;
            ty_5 = _o341.ty_5;
            tz_5 = _o341.tz_5;
            vx_6 = _o341.vx_6;
            vy_6 = _o341.vy_6;
            vz_6 = _o341.vz_6;
            nx_6 = _o341.nx_6;
            ny_6 = _o341.ny_6;
            nz_6 = _o341.nz_6;
            turn_rate_6 = _o341.turn_rate_6;
            const LANES(court_roll_6_out) _o342 =
                LANES(court_roll_6)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, lanes_load(lists->fixed[125]));
            lift_6 = _o342.lift_6;
            tx_6 = _o342.tx_6;
            ty_6 = _o342.ty_6;
            tz_6 = _o342.tz_6;
            vx_7 = _o342.vx_7;
            vy_7 = _o342.vy_7;
            vz_7 = _o342.vz_7;
            nx_7 = _o342.nx_7;
            ny_7 = _o342.ny_7;
            nz_7 = _o342.nz_7;
            turn_rate_7 = _o342.turn_rate_7;
            const LANES(court_roll_7_out) _o343 =
                LANES(court_roll_7)(bent_x, bent_y, bent_z, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, lanes_load(lists->fixed[125]));
            vx_8 = _o343.vx_8;
            vy_8 = _o343.vy_8;
            vz_8 = _o343.vz_8;
            turn_rate_8 = _o343.turn_rate_8;
            const LANES(court_roll_moved_out) _o344 =
                LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, far_x, far_y, far_z);
            far_x = _o344.x;
            far_vx = _o344.vx;
            far_y = _o344.y;
            far_vy = _o344.vy;
            far_z = _o344.z;
            far_vz = _o344.vz;
            turn_rate = _o344.turn_rate;
            const LANES(court_holding_out) _o345 =
                LANES(court_holding)(held, K(1.0));
            here = _o345.here;
            const M _m346 = lanes_both(active, here);
            if (lanes_any(_m346)) {
                const LANES(court_backboard_normal_out) _o347 =
                    LANES(court_backboard_normal)(far_x, far_y, far_z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[9]));
                far_nx = lanes_select(_m346, _o347.nx, far_nx);
                far_ny = lanes_select(_m346, _o347.ny, far_ny);
                far_nz = lanes_select(_m346, _o347.nz, far_nz);
                const LANES(court_backboard_off_out) _o348 =
                    LANES(court_backboard_off)(far_x, far_y, far_z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]));
                far_gap = lanes_select(_m346, _o348.gap, far_gap);
            }
            const LANES(court_holding_out) _o349 =
                LANES(court_holding)(held, K(2.0));
            here = _o349.here;
            const M _m350 = lanes_both(active, here);
            if (lanes_any(_m350)) {
                const LANES(court_bridge_normal_out) _o351 =
                    LANES(court_bridge_normal)(far_x, far_y, far_z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[10]));
                far_nx = lanes_select(_m350, _o351.nx, far_nx);
                far_ny = lanes_select(_m350, _o351.ny, far_ny);
                far_nz = lanes_select(_m350, _o351.nz, far_nz);
                const LANES(court_bridge_off_out) _o352 =
                    LANES(court_bridge_off)(far_x, far_y, far_z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]));
                far_gap = lanes_select(_m350, _o352.gap, far_gap);
            }
            const LANES(court_roll_placed_out) _o353 =
                LANES(court_roll_placed)(far_gap, far_nx, far_ny, far_nz, turn_rate, far_vx, far_vy, far_vz, far_x, far_y, far_z, lanes_load(lists->fixed[109]));
            far_x = _o353.x;
            far_y = _o353.y;
            far_z = _o353.z;
            far_vx = _o353.vx;
            far_vy = _o353.vy;
            far_vz = _o353.vz;
            far_wx = _o353.wx;
            far_wy = _o353.wy;
            far_wz = _o353.wz;
            const LANES(court_compared_out) _o354 =
                LANES(court_compared)(apart, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_x, far_y, far_z, vx, vy, vz, wx, wy, wz, x, y, z, lanes_load(lists->fixed[0]));
            dx = _o354.dx;
            dy = _o354.dy;
            dz = _o354.dz;
            dvx = _o354.dvx;
            dvy = _o354.dvy;
            dvz = _o354.dvz;
            dwx = _o354.dwx;
            dwy = _o354.dwy;
            dwz = _o354.dwz;
            const LANES(court_rolled_on_out) _o355 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o355.clock;
            rolling = _o355.rolling;
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
                    LANES(court_bounded_fix_f356)(lists, taken, idle);
                const size_t room = LANES_WIDTH - busy, left = kept_circling_shots - taken;
                active = lanes_leading(idle, left, active);
                taken += left < room ? left : room;
                busy += left < room ? left : room;
            }
            if (busy == 0)
                break;
            M circling = active;
            const LANES(court_error_bounds_out) _o357 =
                LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            V position_error = _o357.position_error;
            V velocity_error = _o357.velocity_error;
            const LANES(court_ring_tube_out) _o358 =
                LANES(court_ring_tube)(lanes_load(lists->fixed[108]));
            V per_reach = _o358.per_reach;
            const LANES(court_ring_round_start_out) _o359 =
                LANES(court_ring_round_start)(vx, vy, vz, wx, wy, wz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[132]));
            V cosine_0 = _o359.cosine_0;
            V sine_0 = _o359.sine_0;
            V climb_0 = _o359.climb_0;
            V along_0 = _o359.along_0;
            V turn_rate_0 = _o359.turn_rate_0;
            V cos_0 = _o359.cos_0;
            V sin_0 = _o359.sin_0;
            V near_0 = _o359.near_0;
            const LANES(court_ring_round_0_out) _o360 =
                LANES(court_ring_round_0)(along_0, climb_0, cos_0, cosine_0, near_0, sin_0, sine_0, turn_rate_0, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[132]));
            V omega_0 = _o360.omega_0;
            V around_0 = _o360.around_0;
            V tilted_0 = _o360.tilted_0;
            V pressed_0 = _o360.pressed_0;
            V force_0 = _o360.force_0;
            V cosine_1 = _o360.cosine_1;
            V sine_1 = _o360.sine_1;
            V climb_1 = _o360.climb_1;
            V along_1 = _o360.along_1;
            V turn_rate_1 = _o360.turn_rate_1;
            V cos_1 = _o360.cos_1;
            V sin_1 = _o360.sin_1;
            const LANES(court_ring_round_1_out) _o361 =
                LANES(court_ring_round_1)(along_0, along_1, around_0, climb_0, climb_1, cos_0, cos_1, cosine_0, cosine_1, near_0, omega_0, pressed_0, sin_0, sin_1, sine_0, sine_1, tilted_0, turn_rate_0, turn_rate_1, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[88]));
            V near_1 = _o361.near_1;
            V omega_1 = _o361.omega_1;
            V around_1 = _o361.around_1;
            V tilted_1 = _o361.tilted_1;
            V pressed_1 = _o361.pressed_1;
            V force_1 = _o361.force_1;
            V cosine_2 = _o361.cosine_2;
            V sine_2 = _o361.sine_2;
            V climb_2 = _o361.climb_2;
            V along_2 = _o361.along_2;
            V turn_rate_2 = _o361.turn_rate_2;
            V cos_2 = _o361.cos_2;
            V sin_2 = _o361.sin_2;
            const LANES(court_ring_round_2_out) _o362 =
                LANES(court_ring_round_2)(along_0, along_1, along_2, around_0, around_1, climb_0, climb_1, climb_2, cos_0, cos_1, cos_2, cosine_0, cosine_1, cosine_2, near_0, near_1, omega_0, omega_1, pressed_0, pressed_1, sin_0, sin_1, sin_2, sine_0, sine_1, sine_2, tilted_0, tilted_1, turn_rate_0, turn_rate_1, turn_rate_2, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[136]));
            V near_2 = _o362.near_2;
            V omega_2 = _o362.omega_2;
            V around_2 = _o362.around_2;
            V tilted_2 = _o362.tilted_2;
            V pressed_2 = _o362.pressed_2;
            V force_2 = _o362.force_2;
            V cosine_3 = _o362.cosine_3;
            V sine_3 = _o362.sine_3;
            V climb_3 = _o362.climb_3;
            V along_3 = _o362.along_3;
            V turn_rate_3 = _o362.turn_rate_3;
            V cos_3 = _o362.cos_3;
            V sin_3 = _o362.sin_3;
            const LANES(court_ring_round_3_out) _o363 =
                LANES(court_ring_round_3)(along_0, along_1, along_2, along_3, around_0, around_1, around_2, climb_0, climb_1, climb_2, climb_3, cos_0, cos_1, cos_2, cos_3, cosine_0, cosine_1, cosine_2, cosine_3, near_0, near_1, near_2, omega_0, omega_1, omega_2, pressed_0, pressed_1, pressed_2, sin_0, sin_1, sin_2, sin_3, sine_0, sine_1, sine_2, sine_3, tilted_0, tilted_1, tilted_2, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[137]));
            V near_3 = _o363.near_3;
            V omega_3 = _o363.omega_3;
            V around_3 = _o363.around_3;
            V tilted_3 = _o363.tilted_3;
            V pressed_3 = _o363.pressed_3;
            V force_3 = _o363.force_3;
            V cosine_4 = _o363.cosine_4;
            V sine_4 = _o363.sine_4;
            V climb_4 = _o363.climb_4;
            V along_4 = _o363.along_4;
            V turn_rate_4 = _o363.turn_rate_4;
            V cos_4 = _o363.cos_4;
            V sin_4 = _o363.sin_4;
            const LANES(court_ring_round_4_out) _o364 =
                LANES(court_ring_round_4)(along_0, along_1, along_2, along_3, along_4, around_0, around_1, around_2, around_3, climb_0, climb_1, climb_2, climb_3, climb_4, cos_0, cos_1, cos_2, cos_3, cos_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, near_0, near_1, near_2, near_3, omega_0, omega_1, omega_2, omega_3, pressed_0, pressed_1, pressed_2, pressed_3, sin_0, sin_1, sin_2, sin_3, sin_4, sine_0, sine_1, sine_2, sine_3, sine_4, tilted_0, tilted_1, tilted_2, tilted_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[138]));
            V near_4 = _o364.near_4;
            V omega_4 = _o364.omega_4;
            V around_4 = _o364.around_4;
            V tilted_4 = _o364.tilted_4;
            V pressed_4 = _o364.pressed_4;
            V force_4 = _o364.force_4;
            V cosine_5 = _o364.cosine_5;
            V sine_5 = _o364.sine_5;
            V climb_5 = _o364.climb_5;
            V along_5 = _o364.along_5;
            V turn_rate_5 = _o364.turn_rate_5;
            V cos_5 = _o364.cos_5;
            V sin_5 = _o364.sin_5;
            const LANES(court_ring_round_5_out) _o365 =
                LANES(court_ring_round_5)(along_0, along_1, along_2, along_3, along_4, along_5, around_0, around_1, around_2, around_3, around_4, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, near_0, near_1, near_2, near_3, near_4, omega_0, omega_1, omega_2, omega_3, omega_4, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[139]));
            V near_5 = _o365.near_5;
            V omega_5 = _o365.omega_5;
            V around_5 = _o365.around_5;
            V tilted_5 = _o365.tilted_5;
            V pressed_5 = _o365.pressed_5;
            V force_5 = _o365.force_5;
            V cosine_6 = _o365.cosine_6;
            V sine_6 = _o365.sine_6;
            V climb_6 = _o365.climb_6;
            V along_6 = _o365.along_6;
            V turn_rate_6 = _o365.turn_rate_6;
            V cos_6 = _o365.cos_6;
            V sin_6 = _o365.sin_6;
            const LANES(court_ring_round_6_out) _o366 =
                LANES(court_ring_round_6)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, around_0, around_1, around_2, around_3, around_4, around_5, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, near_0, near_1, near_2, near_3, near_4, near_5, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[140]));
            V near_6 = _o366.near_6;
            V omega_6 = _o366.omega_6;
            V around_6 = _o366.around_6;
            V tilted_6 = _o366.tilted_6;
            V pressed_6 = _o366.pressed_6;
            V force_6 = _o366.force_6;
            V cosine_7 = _o366.cosine_7;
            V sine_7 = _o366.sine_7;
            V climb_7 = _o366.climb_7;
            V along_7 = _o366.along_7;
            V turn_rate_7 = _o366.turn_rate_7;
            V cos_7 = _o366.cos_7;
            V sin_7 = _o366.sin_7;
            const LANES(court_ring_round_7_out) _o367 =
                LANES(court_ring_round_7)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, near_0, near_1, near_2, near_3, near_4, near_5, near_6, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[141]));
            V near_7 = _o367.near_7;
            V omega_7 = _o367.omega_7;
            V around_7 = _o367.around_7;
            V tilted_7 = _o367.tilted_7;
            V pressed_7 = _o367.pressed_7;
            V force_7 = _o367.force_7;
            V cosine_8 = _o367.cosine_8;
            V sine_8 = _o367.sine_8;
            V climb_8 = _o367.climb_8;
            V along_8 = _o367.along_8;
            V turn_rate_8 = _o367.turn_rate_8;
            V cos_8 = _o367.cos_8;
            V sin_8 = _o367.sin_8;
            const LANES(court_ring_round_8_out) _o368 =
                LANES(court_ring_round_8)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[142]));
            V near_8 = _o368.near_8;
            V omega_8 = _o368.omega_8;
            V around_8 = _o368.around_8;
            V tilted_8 = _o368.tilted_8;
            V pressed_8 = _o368.pressed_8;
            V force_8 = _o368.force_8;
            V cosine_9 = _o368.cosine_9;
            V sine_9 = _o368.sine_9;
            V climb_9 = _o368.climb_9;
            V along_9 = _o368.along_9;
            V turn_rate_9 = _o368.turn_rate_9;
            V cos_9 = _o368.cos_9;
            V sin_9 = _o368.sin_9;
            const LANES(court_ring_round_9_out) _o369 =
                LANES(court_ring_round_9)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[143]));
            V near_9 = _o369.near_9;
            V omega_9 = _o369.omega_9;
            V around_9 = _o369.around_9;
            V tilted_9 = _o369.tilted_9;
            V pressed_9 = _o369.pressed_9;
            V force_9 = _o369.force_9;
            V cosine_10 = _o369.cosine_10;
            V sine_10 = _o369.sine_10;
            V climb_10 = _o369.climb_10;
            V along_10 = _o369.along_10;
            V turn_rate_10 = _o369.turn_rate_10;
            V cos_10 = _o369.cos_10;
            V sin_10 = _o369.sin_10;
            const LANES(court_ring_round_10_out) _o370 =
                LANES(court_ring_round_10)(along_0, along_1, along_10, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, climb_0, climb_1, climb_10, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, sin_0, sin_1, sin_10, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[144]));
            V near_10 = _o370.near_10;
            V omega_10 = _o370.omega_10;
            V around_10 = _o370.around_10;
            V tilted_10 = _o370.tilted_10;
            V pressed_10 = _o370.pressed_10;
            V force_10 = _o370.force_10;
            V cosine_11 = _o370.cosine_11;
            V sine_11 = _o370.sine_11;
            V climb_11 = _o370.climb_11;
            V along_11 = _o370.along_11;
            V turn_rate_11 = _o370.turn_rate_11;
            V cos_11 = _o370.cos_11;
            V sin_11 = _o370.sin_11;
            const LANES(court_ring_round_11_out) _o371 =
                LANES(court_ring_round_11)(along_0, along_1, along_10, along_11, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_10, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, climb_0, climb_1, climb_10, climb_11, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, near_1, near_10, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_10, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_10, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, sin_0, sin_1, sin_10, sin_11, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[145]));
            V force_11 = _o371.force_11;
            V cosine_12 = _o371.cosine_12;
            V sine_12 = _o371.sine_12;
            V climb_12 = _o371.climb_12;
            V along_12 = _o371.along_12;
            V turn_rate_12 = _o371.turn_rate_12;
            V cos_12 = _o371.cos_12;
            V sin_12 = _o371.sin_12;
            const LANES(court_ring_round_pace_out) _o372 =
                LANES(court_ring_round_pace)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_12, cosine_0, cosine_12, force_0, force_1, force_10, force_11, force_2, force_3, force_4, force_5, force_6, force_7, force_8, force_9, omega_0, sin_0, sin_12, sine_0, sine_12, turn_rate_0, turn_rate_11, turn_rate_12, lanes_load(lists->fixed[126]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[146]), lanes_load(lists->fixed[147]), lanes_load(lists->fixed[148]));
            V stride = _o372.stride;
            V strongest = _o372.strongest;
            V fastest = _o372.fastest;
            V sway = _o372.sway;
            V force = _o372.force;
            V force_rate = _o372.force_rate;
            V force_bend = _o372.force_bend;
            V brace = _o372.brace;
            V vx_1 = _o372.vx_1;
            V vy_1 = _o372.vy_1;
            V vz_1 = _o372.vz_1;
            const LANES(court_ring_round_pulled_out) _o373 =
                LANES(court_ring_round_pulled)(climb_0, climb_1, cosine_0, cosine_1, omega_0, omega_1, turn_rate_0, turn_rate_1, lanes_load(lists->fixed[16]));
            V drag = _o373.drag;
            V drag_rate = _o373.drag_rate;
            const LANES(court_ring_impact_strained_out) _o374 =
                LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, lanes_load(lists->fixed[149]));
            V strain = _o374.strain;
            V strain_rate = _o374.strain_rate;
            const LANES(court_losing_out) _o375 =
                LANES(court_losing)(grip_lost, strain);
            M loses = _o375.loses;
            const M _m376 = lanes_both(active, loses);
            if (lanes_any(_m376)) {
                const LANES(court_lost_grip_out) _o377 =
                    LANES(court_lost_grip)(clock, strain, strain_rate, taut, taut_clock, taut_rate);
                grip_lost = lanes_select(_m376, _o377.grip_lost, grip_lost);
            }
            const LANES(court_tightened_out) _o378 =
                LANES(court_tightened)(clock, strain, strain_rate);
            taut = _o378.taut;
            taut_rate = _o378.taut_rate;
            taut_clock = _o378.taut_clock;
            const LANES(court_leaving_force_out) _o379 =
                LANES(court_leaving_force)(brace, doubt, fastest, force, force_bend, force_rate, per_reach, position_error, stride, velocity_error, vx, vx_1, vy, vy_1, vz, vz_1, which, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[130]), lanes_load(lists->fixed[131]));
            stride = _o379.stride;
            which = _o379.which;
            M rests = _o379.rests;
            doubt = _o379.doubt;
            const LANES(court_backboard_beside_out) _o380 =
                LANES(court_backboard_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]));
            V gap = _o380.gap;
            V nearing = _o380.nearing;
            V dent = _o380.dent;
            const LANES(court_beside_body_out) _o381 =
                LANES(court_beside_body)(dent, doubt, fastest, gap, K(1.0), late, nearing, position_error, stride, strongest, which, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[110]));
            stride = _o381.stride;
            which = _o381.which;
            doubt = _o381.doubt;
            late = _o381.late;
            const LANES(court_bridge_beside_out) _o382 =
                LANES(court_bridge_beside)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]));
            gap = _o382.gap;
            nearing = _o382.nearing;
            dent = _o382.dent;
            const LANES(court_beside_body_out) _o383 =
                LANES(court_beside_body)(dent, doubt, fastest, gap, K(2.0), late, nearing, position_error, stride, strongest, which, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[110]));
            stride = _o383.stride;
            which = _o383.which;
            doubt = _o383.doubt;
            late = _o383.late;
            const LANES(court_end_beside_out) _o384 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[13]));
            gap = _o384.gap;
            nearing = _o384.nearing;
            dent = _o384.dent;
            const LANES(court_beside_gate_out) _o385 =
                LANES(court_beside_gate)(dent, doubt, fastest, gap, K(3.0), late, nearing, position_error, stride, strongest, which, x, y, z, lanes_load(lists->fixed[0]));
            stride = _o385.stride;
            which = _o385.which;
            doubt = _o385.doubt;
            late = _o385.late;
            const LANES(court_beside_time_out) _o386 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o386.stride;
            which = _o386.which;
            const LANES(court_apart_out) _o387 =
                LANES(court_apart)(dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[134]), lanes_load(lists->fixed[135]));
            V apart = _o387.apart;
            const LANES(court_neighbour_out) _o388 =
                LANES(court_neighbour)(apart, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, vx, vy, vz, wx, wy, wz, x, y, z);
            V far_x = _o388.far_x;
            V far_y = _o388.far_y;
            V far_z = _o388.far_z;
            V far_vx = _o388.far_vx;
            V far_vy = _o388.far_vy;
            V far_vz = _o388.far_vz;
            V far_wx = _o388.far_wx;
            V far_wy = _o388.far_wy;
            V far_wz = _o388.far_wz;
            const LANES(court_passing_from_out) _o389 =
                LANES(court_passing_from)(z);
            M over = _o389.over;
            const LANES(court_alone_out) _o390 =
                LANES(court_alone)();
            V berth = _o390.nearest;
            const LANES(court_leaps_out) _o391 =
                LANES(court_leaps)(stride);
            V forth = _o391.forth;
            V back = _o391.back;
            const LANES(court_backboard_around_out) _o392 =
                LANES(court_backboard_around)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[150]));
            gap = _o392.gap;
            nearing = _o392.nearing;
            const LANES(court_cleared_out) _o393 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o393.berth;
            const LANES(court_bridge_around_out) _o394 =
                LANES(court_bridge_around)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[151]));
            gap = _o394.gap;
            nearing = _o394.nearing;
            const LANES(court_cleared_out) _o395 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o395.berth;
            const LANES(court_end_around_out) _o396 =
                LANES(court_end_around)(vz, z, lanes_load(lists->fixed[13]));
            gap = _o396.gap;
            nearing = _o396.nearing;
            const LANES(court_cleared_out) _o397 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o397.berth;
            const LANES(court_ring_round_moved_out) _o398 =
                LANES(court_ring_round_moved)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_12, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_12, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, sin_0, sin_1, sin_10, sin_11, sin_12, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_12, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, stride, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_12, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[109]));
            x = _o398.x;
            y = _o398.y;
            z = _o398.z;
            vx = _o398.vx;
            vy = _o398.vy;
            vz = _o398.vz;
            wx = _o398.wx;
            wy = _o398.wy;
            wz = _o398.wz;
            V climb = _o398.climb;
            const LANES(court_passing_in_contact_out) _o399 =
                LANES(court_passing_in_contact)(over, through, x, y, z, lanes_load(lists->fixed[14]));
            through = _o399.through;
            const LANES(court_backboard_around_out) _o400 =
                LANES(court_backboard_around)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[150]));
            gap = _o400.gap;
            nearing = _o400.nearing;
            const LANES(court_cleared_out) _o401 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o401.berth;
            const LANES(court_bridge_around_out) _o402 =
                LANES(court_bridge_around)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[151]));
            gap = _o402.gap;
            nearing = _o402.nearing;
            const LANES(court_cleared_out) _o403 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o403.berth;
            const LANES(court_end_around_out) _o404 =
                LANES(court_end_around)(vz, z, lanes_load(lists->fixed[13]));
            gap = _o404.gap;
            nearing = _o404.nearing;
            const LANES(court_cleared_out) _o405 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o405.berth;
            const LANES(court_ring_swung_out) _o406 =
                LANES(court_ring_swung)(berth, circled, climb, climb_0, doubt, fastest, force, force_bend, force_rate, position_error, stride, sway, velocity_error, which, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[152]), lanes_load(lists->fixed[153]), lanes_load(lists->fixed[126]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[154]));
            circled = _o406.circled;
            M endless = _o406.endless;
            doubt = _o406.doubt;
            const LANES(court_for_ever_out) _o407 =
                LANES(court_for_ever)(endless, which);
            which = _o407.which;
            const LANES(court_ring_round_start_out) _o408 =
                LANES(court_ring_round_start)(far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_x, far_y, far_z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[132]));
            cosine_0 = _o408.cosine_0;
            sine_0 = _o408.sine_0;
            climb_0 = _o408.climb_0;
            along_0 = _o408.along_0;
            turn_rate_0 = _o408.turn_rate_0;
            cos_0 = _o408.cos_0;
            sin_0 = _o408.sin_0;
            near_0 = _o408.near_0;
            const LANES(court_ring_round_0_out) _o409 =
                LANES(court_ring_round_0)(along_0, climb_0, cos_0, cosine_0, near_0, sin_0, sine_0, turn_rate_0, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[132]));
            omega_0 = _o409.omega_0;
            around_0 = _o409.around_0;
            tilted_0 = _o409.tilted_0;
            pressed_0 = _o409.pressed_0;
            cosine_1 = _o409.cosine_1;
            sine_1 = _o409.sine_1;
            climb_1 = _o409.climb_1;
            along_1 = _o409.along_1;
            turn_rate_1 = _o409.turn_rate_1;
            cos_1 = _o409.cos_1;
            sin_1 = _o409.sin_1;
            const LANES(court_ring_round_1_out) _o410 =
                LANES(court_ring_round_1)(along_0, along_1, around_0, climb_0, climb_1, cos_0, cos_1, cosine_0, cosine_1, near_0, omega_0, pressed_0, sin_0, sin_1, sine_0, sine_1, tilted_0, turn_rate_0, turn_rate_1, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[88]));
            near_1 = _o410.near_1;
            omega_1 = _o410.omega_1;
            around_1 = _o410.around_1;
            tilted_1 = _o410.tilted_1;
            pressed_1 = _o410.pressed_1;
            cosine_2 = _o410.cosine_2;
            sine_2 = _o410.sine_2;
            climb_2 = _o410.climb_2;
            along_2 = _o410.along_2;
            turn_rate_2 = _o410.turn_rate_2;
            cos_2 = _o410.cos_2;
            sin_2 = _o410.sin_2;
            const LANES(court_ring_round_2_out) _o411 =
                LANES(court_ring_round_2)(along_0, along_1, along_2, around_0, around_1, climb_0, climb_1, climb_2, cos_0, cos_1, cos_2, cosine_0, cosine_1, cosine_2, near_0, near_1, omega_0, omega_1, pressed_0, pressed_1, sin_0, sin_1, sin_2, sine_0, sine_1, sine_2, tilted_0, tilted_1, turn_rate_0, turn_rate_1, turn_rate_2, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[136]));
            near_2 = _o411.near_2;
            omega_2 = _o411.omega_2;
            around_2 = _o411.around_2;
            tilted_2 = _o411.tilted_2;
            pressed_2 = _o411.pressed_2;
            cosine_3 = _o411.cosine_3;
            sine_3 = _o411.sine_3;
            climb_3 = _o411.climb_3;
            along_3 = _o411.along_3;
            turn_rate_3 = _o411.turn_rate_3;
            cos_3 = _o411.cos_3;
            sin_3 = _o411.sin_3;
            const LANES(court_ring_round_3_out) _o412 =
                LANES(court_ring_round_3)(along_0, along_1, along_2, along_3, around_0, around_1, around_2, climb_0, climb_1, climb_2, climb_3, cos_0, cos_1, cos_2, cos_3, cosine_0, cosine_1, cosine_2, cosine_3, near_0, near_1, near_2, omega_0, omega_1, omega_2, pressed_0, pressed_1, pressed_2, sin_0, sin_1, sin_2, sin_3, sine_0, sine_1, sine_2, sine_3, tilted_0, tilted_1, tilted_2, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[137]));
            near_3 = _o412.near_3;
            omega_3 = _o412.omega_3;
            around_3 = _o412.around_3;
            tilted_3 = _o412.tilted_3;
            pressed_3 = _o412.pressed_3;
            cosine_4 = _o412.cosine_4;
            sine_4 = _o412.sine_4;
            climb_4 = _o412.climb_4;
            along_4 = _o412.along_4;
            turn_rate_4 = _o412.turn_rate_4;
            cos_4 = _o412.cos_4;
            sin_4 = _o412.sin_4;
            const LANES(court_ring_round_4_out) _o413 =
                LANES(court_ring_round_4)(along_0, along_1, along_2, along_3, along_4, around_0, around_1, around_2, around_3, climb_0, climb_1, climb_2, climb_3, climb_4, cos_0, cos_1, cos_2, cos_3, cos_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, near_0, near_1, near_2, near_3, omega_0, omega_1, omega_2, omega_3, pressed_0, pressed_1, pressed_2, pressed_3, sin_0, sin_1, sin_2, sin_3, sin_4, sine_0, sine_1, sine_2, sine_3, sine_4, tilted_0, tilted_1, tilted_2, tilted_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[138]));
            near_4 = _o413.near_4;
            omega_4 = _o413.omega_4;
            around_4 = _o413.around_4;
            tilted_4 = _o413.tilted_4;
            pressed_4 = _o413.pressed_4;
            cosine_5 = _o413.cosine_5;
            sine_5 = _o413.sine_5;
            climb_5 = _o413.climb_5;
            along_5 = _o413.along_5;
            turn_rate_5 = _o413.turn_rate_5;
            cos_5 = _o413.cos_5;
            sin_5 = _o413.sin_5;
            const LANES(court_ring_round_5_out) _o414 =
                LANES(court_ring_round_5)(along_0, along_1, along_2, along_3, along_4, along_5, around_0, around_1, around_2, around_3, around_4, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, near_0, near_1, near_2, near_3, near_4, omega_0, omega_1, omega_2, omega_3, omega_4, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[139]));
            near_5 = _o414.near_5;
            omega_5 = _o414.omega_5;
            around_5 = _o414.around_5;
            tilted_5 = _o414.tilted_5;
            pressed_5 = _o414.pressed_5;
            cosine_6 = _o414.cosine_6;
            sine_6 = _o414.sine_6;
            climb_6 = _o414.climb_6;
            along_6 = _o414.along_6;
            turn_rate_6 = _o414.turn_rate_6;
            cos_6 = _o414.cos_6;
            sin_6 = _o414.sin_6;
            const LANES(court_ring_round_6_out) _o415 =
                LANES(court_ring_round_6)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, around_0, around_1, around_2, around_3, around_4, around_5, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, near_0, near_1, near_2, near_3, near_4, near_5, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[140]));
            near_6 = _o415.near_6;
            omega_6 = _o415.omega_6;
            around_6 = _o415.around_6;
            tilted_6 = _o415.tilted_6;
            pressed_6 = _o415.pressed_6;
            cosine_7 = _o415.cosine_7;
            sine_7 = _o415.sine_7;
            climb_7 = _o415.climb_7;
            along_7 = _o415.along_7;
            turn_rate_7 = _o415.turn_rate_7;
            cos_7 = _o415.cos_7;
            sin_7 = _o415.sin_7;
            const LANES(court_ring_round_7_out) _o416 =
                LANES(court_ring_round_7)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, near_0, near_1, near_2, near_3, near_4, near_5, near_6, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[141]));
            near_7 = _o416.near_7;
            omega_7 = _o416.omega_7;
            around_7 = _o416.around_7;
            tilted_7 = _o416.tilted_7;
            pressed_7 = _o416.pressed_7;
            cosine_8 = _o416.cosine_8;
            sine_8 = _o416.sine_8;
            climb_8 = _o416.climb_8;
            along_8 = _o416.along_8;
            turn_rate_8 = _o416.turn_rate_8;
            cos_8 = _o416.cos_8;
            sin_8 = _o416.sin_8;
            const LANES(court_ring_round_8_out) _o417 =
                LANES(court_ring_round_8)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[142]));
            near_8 = _o417.near_8;
            omega_8 = _o417.omega_8;
            around_8 = _o417.around_8;
            tilted_8 = _o417.tilted_8;
            pressed_8 = _o417.pressed_8;
            cosine_9 = _o417.cosine_9;
            sine_9 = _o417.sine_9;
            climb_9 = _o417.climb_9;
            along_9 = _o417.along_9;
            turn_rate_9 = _o417.turn_rate_9;
            cos_9 = _o417.cos_9;
            sin_9 = _o417.sin_9;
            const LANES(court_ring_round_9_out) _o418 =
                LANES(court_ring_round_9)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[143]));
            near_9 = _o418.near_9;
            omega_9 = _o418.omega_9;
            around_9 = _o418.around_9;
            tilted_9 = _o418.tilted_9;
            pressed_9 = _o418.pressed_9;
            cosine_10 = _o418.cosine_10;
            sine_10 = _o418.sine_10;
            climb_10 = _o418.climb_10;
            along_10 = _o418.along_10;
            turn_rate_10 = _o418.turn_rate_10;
            cos_10 = _o418.cos_10;
            sin_10 = _o418.sin_10;
            const LANES(court_ring_round_10_out) _o419 =
                LANES(court_ring_round_10)(along_0, along_1, along_10, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, climb_0, climb_1, climb_10, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, sin_0, sin_1, sin_10, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[144]));
            near_10 = _o419.near_10;
            omega_10 = _o419.omega_10;
            around_10 = _o419.around_10;
            tilted_10 = _o419.tilted_10;
            pressed_10 = _o419.pressed_10;
            cosine_11 = _o419.cosine_11;
            sine_11 = _o419.sine_11;
            climb_11 = _o419.climb_11;
            along_11 = _o419.along_11;
            turn_rate_11 = _o419.turn_rate_11;
            cos_11 = _o419.cos_11;
            sin_11 = _o419.sin_11;
            const LANES(court_ring_round_11_out) _o420 =
                LANES(court_ring_round_11)(along_0, along_1, along_10, along_11, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_10, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, climb_0, climb_1, climb_10, climb_11, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, near_0, near_1, near_10, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_10, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_10, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, sin_0, sin_1, sin_10, sin_11, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[145]));
            cosine_12 = _o420.cosine_12;
            sine_12 = _o420.sine_12;
            climb_12 = _o420.climb_12;
            along_12 = _o420.along_12;
            turn_rate_12 = _o420.turn_rate_12;
            cos_12 = _o420.cos_12;
            sin_12 = _o420.sin_12;
            const LANES(court_ring_round_moved_out) _o421 =
                LANES(court_ring_round_moved)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_12, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_12, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, sin_0, sin_1, sin_10, sin_11, sin_12, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_12, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, stride, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_12, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[132]), lanes_load(lists->fixed[109]));
            far_x = _o421.x;
            far_y = _o421.y;
            far_z = _o421.z;
            far_vx = _o421.vx;
            far_vy = _o421.vy;
            far_vz = _o421.vz;
            far_wx = _o421.wx;
            far_wy = _o421.wy;
            far_wz = _o421.wz;
            const LANES(court_compared_out) _o422 =
                LANES(court_compared)(apart, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_x, far_y, far_z, vx, vy, vz, wx, wy, wz, x, y, z, lanes_load(lists->fixed[0]));
            dx = _o422.dx;
            dy = _o422.dy;
            dz = _o422.dz;
            dvx = _o422.dvx;
            dvy = _o422.dvy;
            dvz = _o422.dvz;
            dwx = _o422.dwx;
            dwy = _o422.dwy;
            dwz = _o422.dwz;
            const LANES(court_rolled_on_out) _o423 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o423.clock;
            circling = _o423.rolling;
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
        const LANES(court_rejoined_out) _o424 =
            LANES(court_rejoined)(circling, rolling);
        rolling = _o424.rolling;
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
static void LANES(court_bounded_fix_f486)(LANES(court_bounded_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[0], p_ball_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[14], lanes_mul(p_ring_radius, p_ring_radius));
        lanes_store(lists->fixed[15], _s1);
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[31], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[34], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[108], lanes_div(K(1.0), _s0));
        lanes_store(lists->fixed[109], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[158], lanes_mul(K(8.0), _s1));
        lanes_store(lists->fixed[159], lanes_add(lanes_add(lanes_add(lanes_add(_s2, p_ring_radius), p_wire_radius), lanes_abs(p_board_bottom)), lanes_abs(p_board_top)));
        lanes_store(lists->fixed[160], lanes_div(K(1.0), lanes_min(_s3, _s0)));
        lanes_store(lists->fixed[161], p_restitution_speed);
        lanes_store(lists->fixed[162], _s4);
        lanes_store(lists->fixed[163], lanes_mul(_s4, _s4));
        lanes_store(lists->fixed[164], lanes_mul(K(7.275957614183426e-12), p_ball_radius));
        lanes_store(lists->fixed[165], lanes_mul(K(1.1920928955078125e-07), p_ball_radius));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(court_bounded_fix_f571)(LANES(court_bounded_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[0], p_ball_radius);
        lanes_store(lists->fixed[1], p_ring_radius);
        lanes_store(lists->fixed[2], p_wire_radius);
        lanes_store(lists->fixed[3], p_board_distance);
        lanes_store(lists->fixed[4], p_board_half_width);
        lanes_store(lists->fixed[5], p_board_bottom);
        lanes_store(lists->fixed[6], p_board_top);
        lanes_store(lists->fixed[7], p_bridge_half_width);
        lanes_store(lists->fixed[9], lanes_add(p_board_distance, p_board_thickness));
        lanes_store(lists->fixed[10], lanes_sub(p_wire_radius, p_bridge_depth));
        lanes_store(lists->fixed[13], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[18], lanes_neg(p_gravity));
        lanes_store(lists->fixed[45], lanes_mul(K(6.0), p_gravity));
        lanes_store(lists->fixed[108], lanes_div(K(1.0), lanes_add(p_ball_radius, p_wire_radius)));
        lanes_store(lists->fixed[109], lanes_div(K(1.0), p_ball_radius));
        lanes_store(lists->fixed[110], lanes_mul(K(3.637978807091713e-12), p_ball_radius));
        lanes_store(lists->fixed[127], lanes_mul(K(0.4), p_gravity));
        lanes_store(lists->fixed[155], lanes_mul(K(6.0), lanes_mul(p_gravity, p_gravity)));
        lanes_store(lists->fixed[164], lanes_mul(K(7.275957614183426e-12), p_ball_radius));
        lanes_store(lists->fixed[166], lanes_mul(K(0.4), p_ball_radius));
        lanes_store(lists->fixed[167], _s0);
        lanes_store(lists->fixed[168], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[169], lanes_mul(p_ring_friction, _s1));
        lanes_store(lists->fixed[170], lanes_mul(_s1, _s0));
        lanes_store(lists->fixed[171], lanes_mul(K(3.725290298461914e-09), p_ball_radius));
        lanes_store(lists->fixed[172], _s2);
        lanes_store(lists->fixed[173], lanes_mul(_s2, _s2));
        lanes_store(lists->fixed[174], lanes_mul(p_backboard_friction, _s3));
        lanes_store(lists->fixed[175], lanes_mul(_s3, _s2));
        lanes_store(lists->fixed[176], _s4);
        lanes_store(lists->fixed[177], lanes_mul(_s4, _s4));
        lanes_store(lists->fixed[178], lanes_mul(p_bridge_friction, _s5));
        lanes_store(lists->fixed[179], lanes_mul(_s5, _s4));
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
            LANES(court_bounded_fix_f571)(lists, i);
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
        const LANES(court_ring_normal_out) _o572 =
            LANES(court_ring_normal)(x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[108]));
        V nx = _o572.nx;
        V ny = _o572.ny;
        V nz = _o572.nz;
        const LANES(court_here_out) _o573 =
            LANES(court_here)(K(1.0), which);
        M here = _o573.here;
        const M _m574 = lanes_both(rows, here);
        {
            const LANES(court_backboard_normal_out) _o575 =
                LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[9]));
            nx = lanes_select(_m574, _o575.nx, nx);
            ny = lanes_select(_m574, _o575.ny, ny);
            nz = lanes_select(_m574, _o575.nz, nz);
        }
        const LANES(court_here_out) _o576 =
            LANES(court_here)(K(2.0), which);
        here = _o576.here;
        const M _m577 = lanes_both(rows, here);
        {
            const LANES(court_bridge_normal_out) _o578 =
                LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[10]));
            nx = lanes_select(_m577, _o578.nx, nx);
            ny = lanes_select(_m577, _o578.ny, ny);
            nz = lanes_select(_m577, _o578.nz, nz);
        }
        const LANES(court_nearly_out) _o579 =
            LANES(court_nearly)(nx, ny, nz, vx, vy, vz, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[164]));
        M nearly = _o579.nearly;
        const LANES(court_gripped_out) _o580 =
            LANES(court_gripped)(nx, ny, nz, vx, vy, vz, wx, wy, wz, lanes_load(lists->fixed[0]));
        V rolled_x = _o580.rolled_x;
        V rolled_y = _o580.rolled_y;
        V rolled_z = _o580.rolled_z;
        V slip = _o580.slip;
        V bounce = _o580.bounce;
        const LANES(court_here_out) _o581 =
            LANES(court_here)(K(0.0), which);
        here = _o581.here;
        const M _m582 = lanes_both(rows, here);
        if (lanes_any(_m582)) {
            const LANES(court_ring_turning_out) _o583 =
                LANES(court_ring_turning)(rolled_x, rolled_y, rolled_z, x, y, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[108]));
            V turning_x = _o583.turning_x;
            V turning_y = _o583.turning_y;
            V turning_z = _o583.turning_z;
            const LANES(court_pressed_on_out) _o584 =
                LANES(court_pressed_on)(nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[166]), lanes_load(lists->fixed[127]));
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
            const LANES(court_backboard_closing_out) _o586 =
                LANES(court_backboard_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]));
            V gap = _o586.gap;
            V nearing = _o586.nearing;
            V swerve = _o586.swerve;
            V facing = _o586.facing;
            const LANES(court_neared_body_out) _o587 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o587.nearest;
            wedge = _o587.wedge;
            const LANES(court_bridge_closing_out) _o588 =
                LANES(court_bridge_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]));
            gap = _o588.gap;
            nearing = _o588.nearing;
            swerve = _o588.swerve;
            facing = _o588.facing;
            const LANES(court_neared_body_out) _o589 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o589.nearest;
            wedge = _o589.wedge;
            const LANES(court_end_beside_out) _o590 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[13]));
            gap = _o590.gap;
            const LANES(court_neared_out) _o591 =
                LANES(court_neared)(gap, nearest);
            nearest = _o591.nearest;
            const LANES(court_ring_parting_out) _o592 =
                LANES(court_ring_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[45]), lanes_load(lists->fixed[155]));
            V lift = _o592.lift;
            const LANES(court_ring_impact_settling_out) _o593 =
                LANES(court_ring_impact_settling)(bounce, drag, lift, nearest, press, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[167]), lanes_load(lists->fixed[168]), lanes_load(lists->fixed[169]), lanes_load(lists->fixed[170]), lanes_load(lists->fixed[110]), lanes_load(lists->fixed[171]));
            M settles = _o593.settles;
            M lodges = _o593.lodges;
            M slides = _o593.slides;
            M parts = _o593.parts;
            assured = lanes_select(_m582, _o593.assured, assured);
            M unsure = _o593.unsure;
            const LANES(court_settled_out) _o594 =
                LANES(court_settled)(K(0.0), lodges, nearly, outcome, parts, settles, slides, uncertain, unsure);
            mode = lanes_select(_m582, _o594.mode, mode);
            held = lanes_select(_m582, _o594.held, held);
            outcome = lanes_select(_m582, _o594.outcome, outcome);
            slip_left = lanes_select(_m582, _o594.slip_left, slip_left);
            uncertain = lanes_select(_m582, _o594.uncertain, uncertain);
        }
        const LANES(court_here_out) _o595 =
            LANES(court_here)(K(1.0), which);
        here = _o595.here;
        const M _m596 = lanes_both(rows, here);
        if (lanes_any(_m596)) {
            const LANES(court_backboard_turning_out) _o597 =
                LANES(court_backboard_turning)(rolled_x, rolled_y, rolled_z, x, y, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[9]));
            V turning_x = _o597.turning_x;
            V turning_y = _o597.turning_y;
            V turning_z = _o597.turning_z;
            const LANES(court_pressed_on_out) _o598 =
                LANES(court_pressed_on)(nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[166]), lanes_load(lists->fixed[127]));
            V press = _o598.press;
            V weight = _o598.weight;
            V drag = _o598.drag;
            V thrust_x = _o598.thrust_x;
            V thrust_y = _o598.thrust_y;
            V thrust_z = _o598.thrust_z;
            const LANES(court_alone_out) _o599 =
                LANES(court_alone)();
            V nearest = _o599.nearest;
            V wedge = _o599.wedge;
            const LANES(court_ring_closing_out) _o600 =
                LANES(court_ring_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]));
            V gap = _o600.gap;
            V nearing = _o600.nearing;
            V swerve = _o600.swerve;
            V facing = _o600.facing;
            const LANES(court_neared_body_out) _o601 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o601.nearest;
            wedge = _o601.wedge;
            const LANES(court_bridge_closing_out) _o602 =
                LANES(court_bridge_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[10]));
            gap = _o602.gap;
            nearing = _o602.nearing;
            swerve = _o602.swerve;
            facing = _o602.facing;
            const LANES(court_neared_body_out) _o603 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o603.nearest;
            wedge = _o603.wedge;
            const LANES(court_end_beside_out) _o604 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[13]));
            gap = _o604.gap;
            const LANES(court_neared_out) _o605 =
                LANES(court_neared)(gap, nearest);
            nearest = _o605.nearest;
            const LANES(court_backboard_parting_out) _o606 =
                LANES(court_backboard_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[18]), lanes_load(lists->fixed[9]));
            V lift = _o606.lift;
            const LANES(court_ring_impact_settling_out) _o607 =
                LANES(court_ring_impact_settling)(bounce, drag, lift, nearest, press, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[172]), lanes_load(lists->fixed[173]), lanes_load(lists->fixed[174]), lanes_load(lists->fixed[175]), lanes_load(lists->fixed[110]), lanes_load(lists->fixed[171]));
            M settles = _o607.settles;
            M lodges = _o607.lodges;
            M slides = _o607.slides;
            M parts = _o607.parts;
            assured = lanes_select(_m596, _o607.assured, assured);
            M unsure = _o607.unsure;
            const LANES(court_settled_out) _o608 =
                LANES(court_settled)(K(1.0), lodges, nearly, outcome, parts, settles, slides, uncertain, unsure);
            mode = lanes_select(_m596, _o608.mode, mode);
            held = lanes_select(_m596, _o608.held, held);
            outcome = lanes_select(_m596, _o608.outcome, outcome);
            slip_left = lanes_select(_m596, _o608.slip_left, slip_left);
            uncertain = lanes_select(_m596, _o608.uncertain, uncertain);
        }
        const LANES(court_here_out) _o609 =
            LANES(court_here)(K(2.0), which);
        here = _o609.here;
        const M _m610 = lanes_both(rows, here);
        if (lanes_any(_m610)) {
            const LANES(court_bridge_turning_out) _o611 =
                LANES(court_bridge_turning)(rolled_x, rolled_y, rolled_z, x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[10]));
            V turning_x = _o611.turning_x;
            V turning_y = _o611.turning_y;
            V turning_z = _o611.turning_z;
            const LANES(court_pressed_on_out) _o612 =
                LANES(court_pressed_on)(nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[166]), lanes_load(lists->fixed[127]));
            V press = _o612.press;
            V weight = _o612.weight;
            V drag = _o612.drag;
            V thrust_x = _o612.thrust_x;
            V thrust_y = _o612.thrust_y;
            V thrust_z = _o612.thrust_z;
            const LANES(court_alone_out) _o613 =
                LANES(court_alone)();
            V nearest = _o613.nearest;
            V wedge = _o613.wedge;
            const LANES(court_ring_closing_out) _o614 =
                LANES(court_ring_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]));
            V gap = _o614.gap;
            V nearing = _o614.nearing;
            V swerve = _o614.swerve;
            V facing = _o614.facing;
            const LANES(court_neared_body_out) _o615 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o615.nearest;
            wedge = _o615.wedge;
            const LANES(court_backboard_closing_out) _o616 =
                LANES(court_backboard_closing)(nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[9]));
            gap = _o616.gap;
            nearing = _o616.nearing;
            swerve = _o616.swerve;
            facing = _o616.facing;
            const LANES(court_neared_body_out) _o617 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o617.nearest;
            wedge = _o617.wedge;
            const LANES(court_end_beside_out) _o618 =
                LANES(court_end_beside)(vz, z, lanes_load(lists->fixed[13]));
            gap = _o618.gap;
            const LANES(court_neared_out) _o619 =
                LANES(court_neared)(gap, nearest);
            nearest = _o619.nearest;
            const LANES(court_bridge_parting_out) _o620 =
                LANES(court_bridge_parting)(vx, vy, vz, x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[18]), lanes_load(lists->fixed[10]));
            V lift = _o620.lift;
            const LANES(court_ring_impact_settling_out) _o621 =
                LANES(court_ring_impact_settling)(bounce, drag, lift, nearest, press, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[176]), lanes_load(lists->fixed[177]), lanes_load(lists->fixed[178]), lanes_load(lists->fixed[179]), lanes_load(lists->fixed[110]), lanes_load(lists->fixed[171]));
            M settles = _o621.settles;
            M lodges = _o621.lodges;
            M slides = _o621.slides;
            M parts = _o621.parts;
            assured = lanes_select(_m610, _o621.assured, assured);
            M unsure = _o621.unsure;
            const LANES(court_settled_out) _o622 =
                LANES(court_settled)(K(2.0), lodges, nearly, outcome, parts, settles, slides, uncertain, unsure);
            mode = lanes_select(_m610, _o622.mode, mode);
            held = lanes_select(_m610, _o622.held, held);
            outcome = lanes_select(_m610, _o622.outcome, outcome);
            slip_left = lanes_select(_m610, _o622.slip_left, slip_left);
            uncertain = lanes_select(_m610, _o622.uncertain, uncertain);
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
static void LANES(court_bounded_fix_f623)(LANES(court_bounded_lists) *lists, size_t i)
{
    const V p_gravity = lanes_load(lists->p_gravity + i);
    {
        lanes_store(lists->fixed[16], p_gravity);
        lanes_store(lists->fixed[48], lanes_abs(K(0.0)));
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
            const LANES(court_valid_out) _o3 =
                LANES(court_valid)(last, x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[12]));
            V valid = _o3.valid;
            V doubt = _o3.doubt;
            const LANES(court_admitted_out) _o4 =
                LANES(court_admitted)(doubt, finite, permitted, valid);
            V outcome = _o4.outcome;
            V uncertain = _o4.uncertain;
            const LANES(court_passing_start_out) _o5 =
                LANES(court_passing_start)(last, outcome, uncertain, x, y, z, lanes_load(lists->fixed[13]), lanes_load(lists->fixed[14]));
            V through = _o5.through;
            uncertain = _o5.uncertain;
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
            LANES(court_ahead)(job, begun + i);
            if (LANES_SELDOM(varying))
                LANES(court_bounded_fix_f6)(lists, i);
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
            const LANES(court_error_bounds_out) _o7 =
                LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            V position_error = _o7.position_error;
            V velocity_error = _o7.velocity_error;
            V time_error = _o7.time_error;
            const LANES(court_scale_out) _o8 =
                LANES(court_scale)(x, y, z, vx, vy, vz, lanes_load(lists->fixed[15]));
            V extent = _o8.extent;
            V speed = _o8.speed;
            V excess = _o8.excess;
            const LANES(court_opening_out) _o9 =
                LANES(court_opening)(excess, position_error, velocity_error);
            V when = _o9.when;
            V which = _o9.which;
            V late = _o9.late;
            V doubt = _o9.doubt;
            const LANES(court_limited_out) _o10 =
                LANES(court_limited)(time_limit);
            M limited = _o10.limited;
            const LANES(court_kept_out) _o11 =
                LANES(court_kept)(mode, when);
            M kept = _o11.kept;
            when = _o11.when;
            M rests = _o11.rests;
            M rolling = _o11.rolling;
            V began = _o11.began;
            const LANES(court_left_out) _o12 =
                LANES(court_left)(K(3.0), last);
            V leaving = _o12.leaving;
            const LANES(court_end_arrival_out) _o13 =
                LANES(court_end_arrival)(leaving, z, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[18]), lanes_load(lists->fixed[19]), lanes_load(lists->fixed[20]));
            V time = _o13.time;
            V rate = _o13.rate;
            V bend = _o13.bend;
            V apex = _o13.apex;
            V height = _o13.height;
            const LANES(court_meeting_plane_out) _o14 =
                LANES(court_meeting_plane)(bend, rate, time);
            M arrives = _o14.arrives;
            V ceiling = _o14.ceiling;
            const LANES(court_end_margin_out) _o15 =
                LANES(court_end_margin)(time, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[21]));
            V margin = _o15.margin;
            const LANES(court_crossing_out) _o16 =
                LANES(court_crossing)(margin, K(0.0), rate, ceiling);
            V clearance = _o16.clearance;
            V delay = _o16.delay;
            const LANES(court_timely_out) _o17 =
                LANES(court_timely)(arrives, delay, late, time, when);
            M possible = _o17.possible;
            const LANES(court_end_margin_out) _o18 =
                LANES(court_end_margin)(apex, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[21]));
            margin = _o18.margin;
            const LANES(court_grazed_out) _o19 =
                LANES(court_grazed)(apex, doubt, height, margin);
            doubt = _o19.doubt;
            const M _m20 = lanes_both(rows, possible);
            {
                const LANES(court_crossed_out) _o21 =
                    LANES(court_crossed)(arrives, clearance, doubt, time);
                doubt = lanes_select(_m20, _o21.doubt, doubt);
                const LANES(court_tied_out) _o22 =
                    LANES(court_tied)(arrives, delay, doubt, late, time, when);
                doubt = lanes_select(_m20, _o22.doubt, doubt);
                late = lanes_select(_m20, _o22.late, late);
                const LANES(court_sooner_out) _o23 =
                    LANES(court_sooner)(arrives, K(3.0), time, when, which);
                when = lanes_select(_m20, _o23.when, when);
                which = lanes_select(_m20, _o23.which, which);
            }
            const LANES(court_horizon_out) _o24 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[15]));
            V until = _o24.horizon;
            V pad = _o24.pad;
            const LANES(court_ring_clear_out) _o25 =
                LANES(court_ring_clear)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[23]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[24]), lanes_load(lists->fixed[25]), lanes_load(lists->fixed[26]), lanes_load(lists->fixed[27]), lanes_load(lists->fixed[28]), lanes_load(lists->fixed[29]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[34]), lanes_load(lists->fixed[35]), lanes_load(lists->fixed[36]), lanes_load(lists->fixed[37]), lanes_load(lists->fixed[38]), lanes_load(lists->fixed[39]));
            V clear = _o25.clear;
            const LANES(court_opens_in_flight_out) _o26 =
                LANES(court_opens_in_flight)(clear, kept);
            M open = _o26.open;
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
                LANES(court_bounded_fix_f27)(lists, i);
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
            const LANES(court_beginning_out) _o28 =
                LANES(court_beginning)();
            V share = _o28.share;
            V arrival = _o28.arrival;
            M certain = _o28.certain;
            const LANES(court_left_out) _o29 =
                LANES(court_left)(K(0.0), last);
            V leaving = _o29.leaving;
            const LANES(court_ring_opened_out) _o30 =
                LANES(court_ring_opened)(lanes_narrow(until), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(extent), lanes_narrow(speed), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[2]), singles_load(lists->fixed_single[3]), singles_load(lists->fixed_single[4]), singles_load(lists->fixed_single[5]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[7]), singles_load(lists->fixed_single[8]), singles_load(lists->fixed_single[9]));
            S onset = _o30.t;
            S wide_end = _o30.end;
            M searching = _o30.searching;
            S wide_low1 = _o30.low1;
            S wide_high1 = _o30.high1;
            S wide_low2 = _o30.low2;
            S wide_high2 = _o30.high2;
            S lapsed = _o30.latest;
            M sound = _o30.sound;
            const LANES(court_opened_out) _o31 =
                LANES(court_opened)(lanes_wide(lapsed), lanes_wide(onset));
            V since = _o31.time;
            V latest = _o31.latest;
            const LANES(court_ring_started_out) _o32 =
                LANES(court_ring_started)(x, y, z, vx, vy, vz, lanes_load(lists->fixed[1]));
            V rho_start = _o32.rho_start;
            V parting = _o32.parting;
            V drift = _o32.drift;
            const LANES(court_flight_out) _o33 =
                LANES(court_flight)(since, x, y, z, vx, vy, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[31]));
            V near_x = _o33.x;
            V near_y = _o33.y;
            V near_z = _o33.z;
            V near_vz = _o33.vz;
            const LANES(court_ring_grain_out) _o34 =
                LANES(court_ring_grain)(onset, wide_end, lanes_narrow(leaving), lapsed, lanes_narrow(near_x), lanes_narrow(near_y), lanes_narrow(near_z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(near_vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(parting), lanes_narrow(drift), wide_low1, wide_high1, wide_low2, wide_high2, singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[10]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[11]), singles_load(lists->fixed_single[12]), singles_load(lists->fixed_single[13]), singles_load(lists->fixed_single[14]), singles_load(lists->fixed_single[15]), singles_load(lists->fixed_single[4]), singles_load(lists->fixed_single[16]), singles_load(lists->fixed_single[17]), singles_load(lists->fixed_single[18]));
            S short_share = _o34.share;
            S short_t = _o34.t;
            S short_end = _o34.end;
            S short_x = _o34.x;
            S short_y = _o34.y;
            S short_z = _o34.z;
            S short_vx = _o34.vx;
            S short_vy = _o34.vy;
            S short_vz = _o34.vz;
            S short_steady = _o34.steady;
            S short_swing = _o34.swing;
            S short_rho_start = _o34.rho_start;
            S short_ceiling = _o34.ceiling;
            S short_flat = _o34.flat;
            S short_tilt = _o34.tilt;
            S short_jerk = _o34.jerk;
            S short_grit = _o34.grit;
            S short_parting = _o34.parting;
            S short_drift = _o34.drift;
            S short_rate_margin = _o34.rate_margin;
            S short_low1 = _o34.low1;
            S short_high1 = _o34.high1;
            S short_low2 = _o34.low2;
            S short_high2 = _o34.high2;
            M fits = _o34.fits;
            const LANES(court_coarse_out) _o35 =
                LANES(court_coarse)(lanes_wide(short_ceiling), fits, lanes_wide(short_flat), lanes_wide(short_rate_margin), searching, lanes_wide(short_share), sound);
            M leaping = _o35.leaping;
            searching = _o35.searching;
            M served = _o35.served;
            V ceiling = _o35.ceiling;
            V flat = _o35.flat;
            V tilt = _o35.tilt;
            V allowing = _o35.allowing;
            const LANES(court_allowance_out) _o36 =
                LANES(court_allowance)(allowing, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[16]));
            V excess = _o36.excess;
            const LANES(court_ring_lost_out) _o37 =
                LANES(court_ring_lost)(until, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[22]), lanes_load(lists->fixed[23]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[24]), lanes_load(lists->fixed[25]), lanes_load(lists->fixed[26]), lanes_load(lists->fixed[27]));
            V lost = _o37.lost;
            const LANES(court_beyond_out) _o38 =
                LANES(court_beyond)(doubt, excess, late, lost, pad);
            doubt = _o38.doubt;
            const M _m39 = lanes_both(rows, leaping);
            if (lanes_any(_m39)) {
                const LANES(court_ring_leap_out) _o40 =
                    LANES(court_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, singles_load(lists->fixed_single[19]), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[20]), singles_load(lists->fixed_single[21]), singles_load(lists->fixed_single[22]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[23]), singles_load(lists->fixed_single[24]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[25]));
                short_t = singles_select(singles_of(_m39), _o40.t, short_t);
                short_end = singles_select(singles_of(_m39), _o40.end, short_end);
                certain = lanes_choose(_m39, _o40.certain, certain);
                leaping = lanes_choose(_m39, _o40.leaping, leaping);
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
                        LANES(court_bounded_fix_f41)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_leaping_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M leaping = active;
                const LANES(court_ring_leap_out) _o42 =
                    LANES(court_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, singles_load(lists->fixed_single[19]), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[20]), singles_load(lists->fixed_single[21]), singles_load(lists->fixed_single[22]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[23]), singles_load(lists->fixed_single[24]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[25]));
                short_t = _o42.t;
                short_end = _o42.end;
                M certain = _o42.certain;
                leaping = _o42.leaping;
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
            const LANES(court_leapt_out) _o43 =
                LANES(court_leapt)(arrival, certain, lanes_wide(short_t), searching, served, since);
            arrival = _o43.arrival;
            V t = _o43.t;
            searching = _o43.searching;
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
                LANES(court_bounded_fix_f44)(lists, i);
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
            const LANES(court_ring_prepare_out) _o45 =
                LANES(court_ring_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[34]), lanes_load(lists->fixed[38]), lanes_load(lists->fixed[28]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[36]), lanes_load(lists->fixed[35]), lanes_load(lists->fixed[40]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[23]), lanes_load(lists->fixed[24]), lanes_load(lists->fixed[25]), lanes_load(lists->fixed[26]), lanes_load(lists->fixed[27]));
            V steady = _o45.steady;
            V swing = _o45.swing;
            V rho_start = _o45.rho_start;
            V low0 = _o45.low0;
            V high0 = _o45.high0;
            V low1 = _o45.low1;
            V high1 = _o45.high1;
            V low2 = _o45.low2;
            V high2 = _o45.high2;
            V ceiling = _o45.ceiling;
            V latest = _o45.latest;
            const LANES(court_allowance_out) _o46 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[16]));
            V position_level = _o46.position_level;
            V velocity_level = _o46.velocity_level;
            const LANES(court_ring_margins_out) _o47 =
                LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[28]), lanes_load(lists->fixed[41]), lanes_load(lists->fixed[42]), lanes_load(lists->fixed[43]), lanes_load(lists->fixed[44]));
            V flat = _o47.margin;
            V tilt = _o47.leaving_margin;
            V rate_slack = _o47.rate_margin;
            const LANES(court_ring_enter_out) _o48 =
                LANES(court_ring_enter)(t, K(0.0), high0, high1, high2, low0, low1, low2, t);
            t = _o48.t;
            V end = _o48.end;
            M searching = _o48.searching;
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
                        LANES(court_bounded_fix_f49)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_searching_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o50 =
                    LANES(court_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = _o50.leaving;
                V margin = _o50.margin;
                const LANES(court_ring_advance_out) _o51 =
                    LANES(court_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[45]), lanes_load(lists->fixed[28]), lanes_load(lists->fixed[46]), lanes_load(lists->fixed[47]));
                V gap = _o51.gap;
                V rate = _o51.rate;
                V bend = _o51.bend;
                V step = _o51.step;
                V next = _o51.next;
                V clearance = _o51.clearance;
                const LANES(court_struck_out) _o52 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o52.hit;
                M sure = _o52.sure;
                M vague = _o52.vague;
                const M _m53 = lanes_both(active, vague);
                if (lanes_any(_m53)) {
                    const LANES(court_finer_out) _o54 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m53, _o54.share, share);
                    const LANES(court_allowance_out) _o55 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[16]));
                    V position_level = _o55.position_level;
                    V velocity_level = _o55.velocity_level;
                    V excess = _o55.excess;
                    const LANES(court_ring_margins_out) _o56 =
                        LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[28]), lanes_load(lists->fixed[41]), lanes_load(lists->fixed[42]), lanes_load(lists->fixed[43]), lanes_load(lists->fixed[44]));
                    flat = lanes_select(_m53, _o56.margin, flat);
                    tilt = lanes_select(_m53, _o56.leaving_margin, tilt);
                    rate_slack = lanes_select(_m53, _o56.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o57 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m53, _o57.doubt, doubt);
                }
                const LANES(court_advanced_out) _o58 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o58.arrival;
                certain = _o58.certain;
                M exhausted = _o58.exhausted;
                searching = _o58.searching;
                t = _o58.t;
                const M _m59 = lanes_both(active, exhausted);
                {
                    const LANES(court_ring_enter_out) _o60 =
                        LANES(court_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m59, _o60.t, t);
                    end = lanes_select(_m59, _o60.end, end);
                    searching = lanes_choose(_m59, _o60.searching, searching);
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
            const LANES(court_questioned_out) _o61 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o61.doubt;
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
                LANES(court_bounded_fix_f62)(lists, i);
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
            const LANES(court_found_out) _o63 =
                LANES(court_found)(arrival);
            M arrives = _o63.arrives;
            M refining = _o63.refining;
            V rate = _o63.rate;
            const LANES(court_nearby_out) _o64 =
                LANES(court_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o64.leaving;
            const M _m65 = lanes_both(rows, refining);
            if (lanes_any(_m65)) {
                const LANES(court_ring_refine_out) _o66 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[8]));
                V refined = _o66.time;
                V gap = _o66.gap;
                rate = lanes_select(_m65, _o66.rate, rate);
                const LANES(court_polished_out) _o67 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m65, _o67.arrival, arrival);
                refining = lanes_choose(_m65, _o67.refining, refining);
            }
            const M _m68 = lanes_both(rows, refining);
            if (lanes_any(_m68)) {
                const LANES(court_ring_refine_out) _o69 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[8]));
                V refined = _o69.time;
                V gap = _o69.gap;
                rate = lanes_select(_m68, _o69.rate, rate);
                const LANES(court_polished_out) _o70 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m68, _o70.arrival, arrival);
                refining = lanes_choose(_m68, _o70.refining, refining);
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
                        LANES(court_bounded_fix_f71)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_ring_refine_out) _o72 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[8]));
                V refined = _o72.time;
                V gap = _o72.gap;
                V rate = _o72.rate;
                const LANES(court_polished_out) _o73 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o73.arrival;
                refining = _o73.refining;
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
                LANES(court_bounded_fix_f74)(lists, i);
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
            const LANES(court_ring_margins_out) _o75 =
                LANES(court_ring_margins)(latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[28]), lanes_load(lists->fixed[41]), lanes_load(lists->fixed[42]), lanes_load(lists->fixed[43]), lanes_load(lists->fixed[44]));
            V flat = _o75.margin;
            V tilt = _o75.leaving_margin;
            V rate_margin = _o75.rate_margin;
            const LANES(court_own_margin_out) _o76 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o76.margin;
            const LANES(court_crossing_out) _o77 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o77.clearance;
            V delay = _o77.delay;
            const LANES(court_landed_out) _o78 =
                LANES(court_landed)(arrival);
            V time = _o78.time;
            const LANES(court_landed_surely_out) _o79 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o79.delay;
            doubt = _o79.doubt;
            const LANES(court_tied_out) _o80 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o80.doubt;
            late = _o80.late;
            const LANES(court_sooner_out) _o81 =
                LANES(court_sooner)(arrives, K(0.0), time, when, which);
            when = _o81.when;
            which = _o81.which;
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
                LANES(court_bounded_fix_f82)(lists, i);
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
            const LANES(court_horizon_out) _o83 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[15]));
            V until = _o83.horizon;
            V pad = _o83.pad;
            const LANES(court_halved_out) _o84 =
                LANES(court_halved)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, late, pad, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[48]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[49]));
            V middle_x = _o84.middle_x;
            V reach_x = _o84.reach_x;
            V later_middle_x = _o84.later_middle_x;
            V later_reach_x = _o84.later_reach_x;
            V middle_y = _o84.middle_y;
            V reach_y = _o84.reach_y;
            V later_middle_y = _o84.later_middle_y;
            V later_reach_y = _o84.later_reach_y;
            V middle_z = _o84.middle_z;
            V reach_z = _o84.reach_z;
            V later_middle_z = _o84.later_middle_z;
            V later_reach_z = _o84.later_reach_z;
            const LANES(court_backboard_near_out) _o85 =
                LANES(court_backboard_near)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, later_middle_x, later_middle_y, later_middle_z, later_reach_x, later_reach_y, later_reach_z, lanes_load(lists->fixed[50]), lanes_load(lists->fixed[51]), lanes_load(lists->fixed[52]), lanes_load(lists->fixed[53]), lanes_load(lists->fixed[54]), lanes_load(lists->fixed[55]));
            M reachable = _o85.near;
            const LANES(court_reachable_in_flight_out) _o86 =
                LANES(court_reachable_in_flight)(kept, reachable);
            reachable = _o86.reachable;
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
                LANES(court_bounded_fix_f87)(lists, i);
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
            const LANES(court_horizon_out) _o88 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[15]));
            V until = _o88.horizon;
            V pad = _o88.pad;
            const LANES(court_backboard_prepare_out) _o89 =
                LANES(court_backboard_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[56]), lanes_load(lists->fixed[57]), lanes_load(lists->fixed[58]), lanes_load(lists->fixed[59]), lanes_load(lists->fixed[60]), lanes_load(lists->fixed[61]), lanes_load(lists->fixed[62]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[63]), lanes_load(lists->fixed[23]), lanes_load(lists->fixed[64]), lanes_load(lists->fixed[65]), lanes_load(lists->fixed[66]));
            V low0 = _o89.low0;
            V high0 = _o89.high0;
            V low1 = _o89.low1;
            V high1 = _o89.high1;
            V ceiling = _o89.ceiling;
            V latest = _o89.latest;
            V lost = _o89.lost;
            const LANES(court_beginning_out) _o90 =
                LANES(court_beginning)();
            V share = _o90.share;
            V arrival = _o90.arrival;
            M certain = _o90.certain;
            const LANES(court_allowance_out) _o91 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[16]));
            V position_level = _o91.position_level;
            V velocity_level = _o91.velocity_level;
            V excess = _o91.excess;
            const LANES(court_backboard_margins_out) _o92 =
                LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[67]), lanes_load(lists->fixed[68]), lanes_load(lists->fixed[69]), lanes_load(lists->fixed[70]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[72]), lanes_load(lists->fixed[73]), lanes_load(lists->fixed[74]), lanes_load(lists->fixed[75]), lanes_load(lists->fixed[76]), lanes_load(lists->fixed[77]));
            V flat = _o92.margin;
            V tilt = _o92.leaving_margin;
            V rate_slack = _o92.rate_margin;
            const LANES(court_backboard_enter_out) _o93 =
                LANES(court_backboard_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o93.t;
            V end = _o93.end;
            M searching = _o93.searching;
            const LANES(court_beyond_windows_out) _o94 =
                LANES(court_beyond_windows)(doubt, excess, late, lost, pad, searching);
            doubt = _o94.doubt;
            const M _m95 = lanes_both(rows, searching);
            if (lanes_any(_m95)) {
                const LANES(court_nearby_out) _o96 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o96.leaving;
                V margin = _o96.margin;
                const LANES(court_backboard_advance_out) _o97 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[78]), lanes_load(lists->fixed[79]), lanes_load(lists->fixed[68]), lanes_load(lists->fixed[80]));
                V gap = _o97.gap;
                V rate = _o97.rate;
                V bend = _o97.bend;
                V step = _o97.step;
                V next = _o97.next;
                V clearance = _o97.clearance;
                const LANES(court_struck_or_still_out) _o98 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o98.hit;
                M sure = _o98.sure;
                M vague = _o98.vague;
                const M _m99 = lanes_both(_m95, vague);
                if (lanes_any(_m99)) {
                    const LANES(court_finer_out) _o100 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m99, _o100.share, share);
                    const LANES(court_allowance_out) _o101 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[16]));
                    V position_level = _o101.position_level;
                    V velocity_level = _o101.velocity_level;
                    V excess = _o101.excess;
                    const LANES(court_backboard_margins_out) _o102 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[67]), lanes_load(lists->fixed[68]), lanes_load(lists->fixed[69]), lanes_load(lists->fixed[70]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[72]), lanes_load(lists->fixed[73]), lanes_load(lists->fixed[74]), lanes_load(lists->fixed[75]), lanes_load(lists->fixed[76]), lanes_load(lists->fixed[77]));
                    flat = lanes_select(_m99, _o102.margin, flat);
                    tilt = lanes_select(_m99, _o102.leaving_margin, tilt);
                    rate_slack = lanes_select(_m99, _o102.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o103 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m99, _o103.doubt, doubt);
                }
                const LANES(court_advanced_out) _o104 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = lanes_select(_m95, _o104.arrival, arrival);
                certain = lanes_choose(_m95, _o104.certain, certain);
                M exhausted = _o104.exhausted;
                searching = lanes_choose(_m95, _o104.searching, searching);
                t = lanes_select(_m95, _o104.t, t);
                const M _m105 = lanes_both(_m95, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o106 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m105, _o106.t, t);
                    end = lanes_select(_m105, _o106.end, end);
                    searching = lanes_choose(_m105, _o106.searching, searching);
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
                        LANES(court_bounded_fix_f107)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = reachable_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o108 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o108.leaving;
                V margin = _o108.margin;
                const LANES(court_backboard_advance_out) _o109 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[78]), lanes_load(lists->fixed[79]), lanes_load(lists->fixed[68]), lanes_load(lists->fixed[80]));
                V gap = _o109.gap;
                V rate = _o109.rate;
                V bend = _o109.bend;
                V step = _o109.step;
                V next = _o109.next;
                V clearance = _o109.clearance;
                const LANES(court_struck_or_still_out) _o110 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o110.hit;
                M sure = _o110.sure;
                M vague = _o110.vague;
                const M _m111 = lanes_both(active, vague);
                if (lanes_any(_m111)) {
                    const LANES(court_finer_out) _o112 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m111, _o112.share, share);
                    const LANES(court_allowance_out) _o113 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[16]));
                    V position_level = _o113.position_level;
                    V velocity_level = _o113.velocity_level;
                    V excess = _o113.excess;
                    const LANES(court_backboard_margins_out) _o114 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[67]), lanes_load(lists->fixed[68]), lanes_load(lists->fixed[69]), lanes_load(lists->fixed[70]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[72]), lanes_load(lists->fixed[73]), lanes_load(lists->fixed[74]), lanes_load(lists->fixed[75]), lanes_load(lists->fixed[76]), lanes_load(lists->fixed[77]));
                    flat = lanes_select(_m111, _o114.margin, flat);
                    tilt = lanes_select(_m111, _o114.leaving_margin, tilt);
                    rate_slack = lanes_select(_m111, _o114.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o115 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m111, _o115.doubt, doubt);
                }
                const LANES(court_advanced_out) _o116 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o116.arrival;
                certain = _o116.certain;
                M exhausted = _o116.exhausted;
                searching = _o116.searching;
                t = _o116.t;
                const M _m117 = lanes_both(active, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o118 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m117, _o118.t, t);
                    end = lanes_select(_m117, _o118.end, end);
                    searching = lanes_choose(_m117, _o118.searching, searching);
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
                LANES(court_bounded_fix_f119)(lists, i);
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
            const LANES(court_questioned_out) _o120 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o120.doubt;
            const LANES(court_found_out) _o121 =
                LANES(court_found)(arrival);
            M arrives = _o121.arrives;
            M refining = _o121.refining;
            V rate = _o121.rate;
            const LANES(court_nearby_out) _o122 =
                LANES(court_nearby)(flat, K(1.0), last, arrival, tilt);
            V leaving = _o122.leaving;
            const M _m123 = lanes_both(rows, refining);
            if (lanes_any(_m123)) {
                const LANES(court_backboard_refine_out) _o124 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[78]));
                V refined = _o124.time;
                V gap = _o124.gap;
                rate = lanes_select(_m123, _o124.rate, rate);
                const LANES(court_polished_out) _o125 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m123, _o125.arrival, arrival);
                refining = lanes_choose(_m123, _o125.refining, refining);
            }
            const M _m126 = lanes_both(rows, refining);
            if (lanes_any(_m126)) {
                const LANES(court_backboard_refine_out) _o127 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[78]));
                V refined = _o127.time;
                V gap = _o127.gap;
                rate = lanes_select(_m126, _o127.rate, rate);
                const LANES(court_polished_out) _o128 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m126, _o128.arrival, arrival);
                refining = lanes_choose(_m126, _o128.refining, refining);
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
                        LANES(court_bounded_fix_f129)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = reachable_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_backboard_refine_out) _o130 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[78]));
                V refined = _o130.time;
                V gap = _o130.gap;
                V rate = _o130.rate;
                const LANES(court_polished_out) _o131 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o131.arrival;
                refining = _o131.refining;
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
                LANES(court_bounded_fix_f132)(lists, i);
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
            const LANES(court_backboard_margins_out) _o133 =
                LANES(court_backboard_margins)(latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[67]), lanes_load(lists->fixed[68]), lanes_load(lists->fixed[69]), lanes_load(lists->fixed[70]), lanes_load(lists->fixed[71]), lanes_load(lists->fixed[72]), lanes_load(lists->fixed[73]), lanes_load(lists->fixed[74]), lanes_load(lists->fixed[75]), lanes_load(lists->fixed[76]), lanes_load(lists->fixed[77]));
            V flat = _o133.margin;
            V tilt = _o133.leaving_margin;
            V rate_margin = _o133.rate_margin;
            const LANES(court_own_margin_out) _o134 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o134.margin;
            const LANES(court_crossing_out) _o135 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o135.clearance;
            V delay = _o135.delay;
            const LANES(court_landed_out) _o136 =
                LANES(court_landed)(arrival);
            V time = _o136.time;
            const LANES(court_landed_surely_out) _o137 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o137.delay;
            doubt = _o137.doubt;
            const LANES(court_tied_out) _o138 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o138.doubt;
            late = _o138.late;
            const LANES(court_sooner_out) _o139 =
                LANES(court_sooner)(arrives, K(1.0), time, when, which);
            when = _o139.when;
            which = _o139.which;
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
                LANES(court_bounded_fix_f140)(lists, i);
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
            const LANES(court_horizon_out) _o141 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[15]));
            V until = _o141.horizon;
            V pad = _o141.pad;
            const LANES(court_halved_out) _o142 =
                LANES(court_halved)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, late, pad, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[48]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[49]));
            V middle_x = _o142.middle_x;
            V reach_x = _o142.reach_x;
            V later_middle_x = _o142.later_middle_x;
            V later_reach_x = _o142.later_reach_x;
            V middle_y = _o142.middle_y;
            V reach_y = _o142.reach_y;
            V later_middle_y = _o142.later_middle_y;
            V later_reach_y = _o142.later_reach_y;
            V middle_z = _o142.middle_z;
            V reach_z = _o142.reach_z;
            V later_middle_z = _o142.later_middle_z;
            V later_reach_z = _o142.later_reach_z;
            const LANES(court_bridge_near_out) _o143 =
                LANES(court_bridge_near)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, later_middle_x, later_middle_y, later_middle_z, later_reach_x, later_reach_y, later_reach_z, lanes_load(lists->fixed[50]), lanes_load(lists->fixed[81]), lanes_load(lists->fixed[82]), lanes_load(lists->fixed[83]), lanes_load(lists->fixed[84]), lanes_load(lists->fixed[85]));
            M reachable = _o143.near;
            const LANES(court_reachable_in_flight_out) _o144 =
                LANES(court_reachable_in_flight)(kept, reachable);
            reachable = _o144.reachable;
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
                LANES(court_bounded_fix_f145)(lists, i);
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
            const LANES(court_horizon_out) _o146 =
                LANES(court_horizon)(when, speed, lanes_load(lists->fixed[15]));
            V until = _o146.horizon;
            V pad = _o146.pad;
            const LANES(court_bridge_prepare_out) _o147 =
                LANES(court_bridge_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[2]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[86]), lanes_load(lists->fixed[87]), lanes_load(lists->fixed[88]), lanes_load(lists->fixed[89]), lanes_load(lists->fixed[90]), lanes_load(lists->fixed[91]), lanes_load(lists->fixed[92]), lanes_load(lists->fixed[93]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[94]), lanes_load(lists->fixed[23]), lanes_load(lists->fixed[95]), lanes_load(lists->fixed[96]), lanes_load(lists->fixed[97]));
            V low0 = _o147.low0;
            V high0 = _o147.high0;
            V low1 = _o147.low1;
            V high1 = _o147.high1;
            V ceiling = _o147.ceiling;
            V latest = _o147.latest;
            V lost = _o147.lost;
            const LANES(court_beginning_out) _o148 =
                LANES(court_beginning)();
            V share = _o148.share;
            V arrival = _o148.arrival;
            M certain = _o148.certain;
            const LANES(court_allowance_out) _o149 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[16]));
            V position_level = _o149.position_level;
            V velocity_level = _o149.velocity_level;
            V excess = _o149.excess;
            const LANES(court_bridge_margins_out) _o150 =
                LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[67]), lanes_load(lists->fixed[98]), lanes_load(lists->fixed[99]), lanes_load(lists->fixed[100]), lanes_load(lists->fixed[101]), lanes_load(lists->fixed[102]), lanes_load(lists->fixed[103]), lanes_load(lists->fixed[104]), lanes_load(lists->fixed[105]), lanes_load(lists->fixed[106]), lanes_load(lists->fixed[107]));
            V flat = _o150.margin;
            V tilt = _o150.leaving_margin;
            V rate_slack = _o150.rate_margin;
            const LANES(court_bridge_enter_out) _o151 =
                LANES(court_bridge_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o151.t;
            V end = _o151.end;
            M searching = _o151.searching;
            const LANES(court_beyond_windows_out) _o152 =
                LANES(court_beyond_windows)(doubt, excess, late, lost, pad, searching);
            doubt = _o152.doubt;
            const M _m153 = lanes_both(rows, searching);
            if (lanes_any(_m153)) {
                const LANES(court_nearby_out) _o154 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o154.leaving;
                V margin = _o154.margin;
                const LANES(court_bridge_advance_out) _o155 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[78]), lanes_load(lists->fixed[79]), lanes_load(lists->fixed[98]), lanes_load(lists->fixed[80]));
                V gap = _o155.gap;
                V rate = _o155.rate;
                V bend = _o155.bend;
                V step = _o155.step;
                V next = _o155.next;
                V clearance = _o155.clearance;
                const LANES(court_struck_or_still_out) _o156 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o156.hit;
                M sure = _o156.sure;
                M vague = _o156.vague;
                const M _m157 = lanes_both(_m153, vague);
                if (lanes_any(_m157)) {
                    const LANES(court_finer_out) _o158 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m157, _o158.share, share);
                    const LANES(court_allowance_out) _o159 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[16]));
                    V position_level = _o159.position_level;
                    V velocity_level = _o159.velocity_level;
                    V excess = _o159.excess;
                    const LANES(court_bridge_margins_out) _o160 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[67]), lanes_load(lists->fixed[98]), lanes_load(lists->fixed[99]), lanes_load(lists->fixed[100]), lanes_load(lists->fixed[101]), lanes_load(lists->fixed[102]), lanes_load(lists->fixed[103]), lanes_load(lists->fixed[104]), lanes_load(lists->fixed[105]), lanes_load(lists->fixed[106]), lanes_load(lists->fixed[107]));
                    flat = lanes_select(_m157, _o160.margin, flat);
                    tilt = lanes_select(_m157, _o160.leaving_margin, tilt);
                    rate_slack = lanes_select(_m157, _o160.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o161 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m157, _o161.doubt, doubt);
                }
                const LANES(court_advanced_out) _o162 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = lanes_select(_m153, _o162.arrival, arrival);
                certain = lanes_choose(_m153, _o162.certain, certain);
                M exhausted = _o162.exhausted;
                searching = lanes_choose(_m153, _o162.searching, searching);
                t = lanes_select(_m153, _o162.t, t);
                const M _m163 = lanes_both(_m153, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o164 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m163, _o164.t, t);
                    end = lanes_select(_m163, _o164.end, end);
                    searching = lanes_choose(_m163, _o164.searching, searching);
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
                        LANES(court_bounded_fix_f165)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = reachable_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o166 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o166.leaving;
                V margin = _o166.margin;
                const LANES(court_bridge_advance_out) _o167 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[78]), lanes_load(lists->fixed[79]), lanes_load(lists->fixed[98]), lanes_load(lists->fixed[80]));
                V gap = _o167.gap;
                V rate = _o167.rate;
                V bend = _o167.bend;
                V step = _o167.step;
                V next = _o167.next;
                V clearance = _o167.clearance;
                const LANES(court_struck_or_still_out) _o168 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o168.hit;
                M sure = _o168.sure;
                M vague = _o168.vague;
                const M _m169 = lanes_both(active, vague);
                if (lanes_any(_m169)) {
                    const LANES(court_finer_out) _o170 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m169, _o170.share, share);
                    const LANES(court_allowance_out) _o171 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[16]));
                    V position_level = _o171.position_level;
                    V velocity_level = _o171.velocity_level;
                    V excess = _o171.excess;
                    const LANES(court_bridge_margins_out) _o172 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[67]), lanes_load(lists->fixed[98]), lanes_load(lists->fixed[99]), lanes_load(lists->fixed[100]), lanes_load(lists->fixed[101]), lanes_load(lists->fixed[102]), lanes_load(lists->fixed[103]), lanes_load(lists->fixed[104]), lanes_load(lists->fixed[105]), lanes_load(lists->fixed[106]), lanes_load(lists->fixed[107]));
                    flat = lanes_select(_m169, _o172.margin, flat);
                    tilt = lanes_select(_m169, _o172.leaving_margin, tilt);
                    rate_slack = lanes_select(_m169, _o172.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o173 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m169, _o173.doubt, doubt);
                }
                const LANES(court_advanced_out) _o174 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o174.arrival;
                certain = _o174.certain;
                M exhausted = _o174.exhausted;
                searching = _o174.searching;
                t = _o174.t;
                const M _m175 = lanes_both(active, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o176 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m175, _o176.t, t);
                    end = lanes_select(_m175, _o176.end, end);
                    searching = lanes_choose(_m175, _o176.searching, searching);
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
                LANES(court_bounded_fix_f177)(lists, i);
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
            const LANES(court_questioned_out) _o178 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o178.doubt;
            const LANES(court_found_out) _o179 =
                LANES(court_found)(arrival);
            M arrives = _o179.arrives;
            M refining = _o179.refining;
            V rate = _o179.rate;
            const LANES(court_nearby_out) _o180 =
                LANES(court_nearby)(flat, K(2.0), last, arrival, tilt);
            V leaving = _o180.leaving;
            const M _m181 = lanes_both(rows, refining);
            if (lanes_any(_m181)) {
                const LANES(court_bridge_refine_out) _o182 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[78]));
                V refined = _o182.time;
                V gap = _o182.gap;
                rate = lanes_select(_m181, _o182.rate, rate);
                const LANES(court_polished_out) _o183 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m181, _o183.arrival, arrival);
                refining = lanes_choose(_m181, _o183.refining, refining);
            }
            const M _m184 = lanes_both(rows, refining);
            if (lanes_any(_m184)) {
                const LANES(court_bridge_refine_out) _o185 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[78]));
                V refined = _o185.time;
                V gap = _o185.gap;
                rate = lanes_select(_m184, _o185.rate, rate);
                const LANES(court_polished_out) _o186 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m184, _o186.arrival, arrival);
                refining = lanes_choose(_m184, _o186.refining, refining);
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
                        LANES(court_bounded_fix_f187)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = reachable_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(court_bridge_refine_out) _o188 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[78]));
                V refined = _o188.time;
                V gap = _o188.gap;
                V rate = _o188.rate;
                const LANES(court_polished_out) _o189 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o189.arrival;
                refining = _o189.refining;
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
                LANES(court_bounded_fix_f190)(lists, i);
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
            const LANES(court_bridge_margins_out) _o191 =
                LANES(court_bridge_margins)(latest, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[67]), lanes_load(lists->fixed[98]), lanes_load(lists->fixed[99]), lanes_load(lists->fixed[100]), lanes_load(lists->fixed[101]), lanes_load(lists->fixed[102]), lanes_load(lists->fixed[103]), lanes_load(lists->fixed[104]), lanes_load(lists->fixed[105]), lanes_load(lists->fixed[106]), lanes_load(lists->fixed[107]));
            V flat = _o191.margin;
            V tilt = _o191.leaving_margin;
            V rate_margin = _o191.rate_margin;
            const LANES(court_own_margin_out) _o192 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o192.margin;
            const LANES(court_crossing_out) _o193 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o193.clearance;
            V delay = _o193.delay;
            const LANES(court_landed_out) _o194 =
                LANES(court_landed)(arrival);
            V time = _o194.time;
            const LANES(court_landed_surely_out) _o195 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o195.delay;
            doubt = _o195.doubt;
            const LANES(court_tied_out) _o196 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o196.doubt;
            late = _o196.late;
            const LANES(court_sooner_out) _o197 =
                LANES(court_sooner)(arrives, K(2.0), time, when, which);
            when = _o197.when;
            which = _o197.which;
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
            const M _m198 = lanes_both(rows, limited);
            if (lanes_any(_m198)) {
                const LANES(court_expiry_out) _o199 =
                    LANES(court_expiry)(clock, doubt, late, time_error, time_limit, when, which);
                V time = _o199.time;
                V delay = _o199.delay;
                M arrives = _o199.arrives;
                doubt = lanes_select(_m198, _o199.doubt, doubt);
                const LANES(court_tied_out) _o200 =
                    LANES(court_tied)(arrives, delay, doubt, late, time, when);
                doubt = lanes_select(_m198, _o200.doubt, doubt);
                late = lanes_select(_m198, _o200.late, late);
                const LANES(court_sooner_out) _o201 =
                    LANES(court_sooner)(arrives, K(4.0), time, when, which);
                when = lanes_select(_m198, _o201.when, when);
                which = lanes_select(_m198, _o201.which, which);
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
                LANES(court_bounded_fix_f486)(lists, i);
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
            const LANES(court_departed_out) _o487 =
                LANES(court_departed)(K(3.0), which);
            M moves = _o487.moves;
            M ends = _o487.ends;
            M touches = _o487.touches;
            V reached = _o487.reached;
            M edge = _o487.edge;
            const LANES(court_body_of_out) _o488 =
                LANES(court_body_of)(which);
            V body = _o488.body;
            const M _m489 = lanes_both(rows, moves);
            if (lanes_any(_m489)) {
                const LANES(court_passing_doubt_out) _o490 =
                    LANES(court_passing_doubt)(when, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[34]), lanes_load(lists->fixed[158]));
                M unsure = _o490.unsure;
                const LANES(court_undecided_out) _o491 =
                    LANES(court_undecided)(uncertain, unsure);
                uncertain = lanes_select(_m489, _o491.uncertain, uncertain);
                const LANES(court_passing_out) _o492 =
                    LANES(court_passing)(through, when, x, y, z, vx, vy, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[14]));
                through = lanes_select(_m489, _o492.through, through);
                const LANES(court_flight_out) _o493 =
                    LANES(court_flight)(when, x, y, z, vx, vy, vz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[31]));
                x = lanes_select(_m489, _o493.x, x);
                y = lanes_select(_m489, _o493.y, y);
                z = lanes_select(_m489, _o493.z, z);
                vx = lanes_select(_m489, _o493.vx, vx);
                vy = lanes_select(_m489, _o493.vy, vy);
                vz = lanes_select(_m489, _o493.vz, vz);
                const LANES(court_ticked_out) _o494 =
                    LANES(court_ticked)(clock, when);
                clock = lanes_select(_m489, _o494.clock, clock);
            }
            const M _m495 = lanes_both(rows, limited);
            if (lanes_any(_m495)) {
                const LANES(court_expired_out) _o496 =
                    LANES(court_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m495, _o496.clock, clock);
                body = lanes_select(_m495, _o496.body, body);
                reached = lanes_select(_m495, _o496.reached, reached);
                ends = lanes_choose(_m495, _o496.ends, ends);
            }
            const LANES(court_unhopped_out) _o497 =
                LANES(court_unhopped)();
            M hopped = _o497.hopped;
            const M _m498 = lanes_both(rows, kept);
            if (lanes_any(_m498)) {
                const LANES(court_kept_on_out) _o499 =
                    LANES(court_kept_on)(began, body, clock, doubt, ends, held, last, reached, rests, rolling, rolls, which);
                body = lanes_select(_m498, _o499.body, body);
                reached = lanes_select(_m498, _o499.reached, reached);
                doubt = lanes_select(_m498, _o499.doubt, doubt);
                ends = lanes_choose(_m498, _o499.ends, ends);
                hopped = lanes_choose(_m498, _o499.hopped, hopped);
                last = lanes_select(_m498, _o499.last, last);
                mode = lanes_select(_m498, _o499.mode, mode);
                held = lanes_select(_m498, _o499.held, held);
                rolls = lanes_select(_m498, _o499.rolls, rolls);
            }
            const LANES(court_displacement_out) _o500 =
                LANES(court_displacement)(late, when, extent, speed, position_error, velocity_error, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[159]));
            V slack = _o500.margin;
            const LANES(court_here_out) _o501 =
                LANES(court_here)(K(3.0), which);
            M here = _o501.here;
            const M _m502 = lanes_both(rows, here);
            {
                const LANES(court_end_bounds_out) _o503 =
                    LANES(court_end_bounds)(x, y, lanes_load(lists->fixed[1]));
                V g0 = _o503.g0;
                const LANES(court_end_reached_out) _o504 =
                    LANES(court_end_reached)(g0, through);
                reached = lanes_select(_m502, _o504.reached, reached);
                const LANES(court_end_edge_out) _o505 =
                    LANES(court_end_edge)(g0, slack, through);
                edge = lanes_choose(_m502, _o505.edge, edge);
            }
            const LANES(court_doubted_in_contact_out) _o506 =
                LANES(court_doubted_in_contact)(assured, doubt, edge, last, late, uncertain, when, which);
            uncertain = _o506.uncertain;
            const LANES(court_accounted_out) _o507 =
                LANES(court_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o507.contacts;
            V outcome = _o507.outcome;
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
            const LANES(court_meeting_out) _o508 =
                LANES(court_meeting)(claims, ends, touches);
            M meeting = _o508.meeting;
            const LANES(court_unslowed_out) _o509 =
                LANES(court_unslowed)();
            M slow = _o509.slow;
            const M _m510 = lanes_both(rows, meeting);
            if (lanes_any(_m510)) {
                const LANES(court_end_normal_out) _o511 =
                    LANES(court_end_normal)();
                V nx = _o511.nx;
                V ny = _o511.ny;
                V nz = _o511.nz;
                const LANES(court_here_out) _o512 =
                    LANES(court_here)(K(0.0), which);
                M here = _o512.here;
                const M _m513 = lanes_both(_m510, here);
                {
                    const LANES(court_ring_normal_out) _o514 =
                        LANES(court_ring_normal)(x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[108]));
                    nx = lanes_select(_m513, _o514.nx, nx);
                    ny = lanes_select(_m513, _o514.ny, ny);
                    nz = lanes_select(_m513, _o514.nz, nz);
                    const LANES(court_counted_out) _o515 =
                        LANES(court_counted)(count_0);
                    count_0 = lanes_select(_m513, _o515.count, count_0);
                }
                const LANES(court_here_out) _o516 =
                    LANES(court_here)(K(1.0), which);
                here = _o516.here;
                const M _m517 = lanes_both(_m510, here);
                {
                    const LANES(court_backboard_normal_out) _o518 =
                        LANES(court_backboard_normal)(x, y, z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[9]));
                    nx = lanes_select(_m517, _o518.nx, nx);
                    ny = lanes_select(_m517, _o518.ny, ny);
                    nz = lanes_select(_m517, _o518.nz, nz);
                    const LANES(court_counted_out) _o519 =
                        LANES(court_counted)(count_1);
                    count_1 = lanes_select(_m517, _o519.count, count_1);
                }
                const LANES(court_here_out) _o520 =
                    LANES(court_here)(K(2.0), which);
                here = _o520.here;
                const M _m521 = lanes_both(_m510, here);
                {
                    const LANES(court_bridge_normal_out) _o522 =
                        LANES(court_bridge_normal)(x, y, z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[10]));
                    nx = lanes_select(_m521, _o522.nx, nx);
                    ny = lanes_select(_m521, _o522.ny, ny);
                    nz = lanes_select(_m521, _o522.nz, nz);
                    const LANES(court_counted_out) _o523 =
                        LANES(court_counted)(count_2);
                    count_2 = lanes_select(_m521, _o523.count, count_2);
                }
                const LANES(court_elsewhere_out) _o524 =
                    LANES(court_elsewhere)();
                V curving = _o524.curving;
                const LANES(court_anew_out) _o525 =
                    LANES(court_anew)();
                V left_nx = _o525.left_nx;
                V left_ny = _o525.left_ny;
                V left_nz = _o525.left_nz;
                const LANES(court_again_out) _o526 =
                    LANES(court_again)(K(0.0), last, which);
                M again = _o526.again;
                const M _m527 = lanes_both(_m510, again);
                if (lanes_any(_m527)) {
                    const LANES(court_ring_curvature_out) _o528 =
                        LANES(court_ring_curvature)(lanes_load(lists->fixed[160]));
                    curving = lanes_select(_m527, _o528.curvature, curving);
                    const LANES(court_started_out) _o529 =
                        LANES(court_started)(when, vx, vy, vz, x, y, z, lanes_load(lists->fixed[31]));
                    V from_x = _o529.from_x;
                    V from_y = _o529.from_y;
                    V from_z = _o529.from_z;
                    const LANES(court_ring_normal_out) _o530 =
                        LANES(court_ring_normal)(from_x, from_y, from_z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[108]));
                    left_nx = lanes_select(_m527, _o530.nx, left_nx);
                    left_ny = lanes_select(_m527, _o530.ny, left_ny);
                    left_nz = lanes_select(_m527, _o530.nz, left_nz);
                }
                const LANES(court_again_out) _o531 =
                    LANES(court_again)(K(1.0), last, which);
                again = _o531.again;
                const M _m532 = lanes_both(_m510, again);
                if (lanes_any(_m532)) {
                    const LANES(court_backboard_curvature_out) _o533 =
                        LANES(court_backboard_curvature)(lanes_load(lists->fixed[109]));
                    curving = lanes_select(_m532, _o533.curvature, curving);
                    const LANES(court_started_out) _o534 =
                        LANES(court_started)(when, vx, vy, vz, x, y, z, lanes_load(lists->fixed[31]));
                    V from_x = _o534.from_x;
                    V from_y = _o534.from_y;
                    V from_z = _o534.from_z;
                    const LANES(court_backboard_normal_out) _o535 =
                        LANES(court_backboard_normal)(from_x, from_y, from_z, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[9]));
                    left_nx = lanes_select(_m532, _o535.nx, left_nx);
                    left_ny = lanes_select(_m532, _o535.ny, left_ny);
                    left_nz = lanes_select(_m532, _o535.nz, left_nz);
                }
                const LANES(court_again_out) _o536 =
                    LANES(court_again)(K(2.0), last, which);
                again = _o536.again;
                const M _m537 = lanes_both(_m510, again);
                if (lanes_any(_m537)) {
                    const LANES(court_bridge_curvature_out) _o538 =
                        LANES(court_bridge_curvature)(lanes_load(lists->fixed[109]));
                    curving = lanes_select(_m537, _o538.curvature, curving);
                    const LANES(court_started_out) _o539 =
                        LANES(court_started)(when, vx, vy, vz, x, y, z, lanes_load(lists->fixed[31]));
                    V from_x = _o539.from_x;
                    V from_y = _o539.from_y;
                    V from_z = _o539.from_z;
                    const LANES(court_bridge_normal_out) _o540 =
                        LANES(court_bridge_normal)(from_x, from_y, from_z, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[10]));
                    left_nx = lanes_select(_m537, _o540.nx, left_nx);
                    left_ny = lanes_select(_m537, _o540.ny, left_ny);
                    left_nz = lanes_select(_m537, _o540.nz, left_nz);
                }
                const LANES(court_carry_flight_out) _o541 =
                    LANES(court_carry_flight)(when, x, y, z, vx, vy, vz, nx, ny, nz, clock, contacts, late, dx, dy, dz, dvx, dvy, dvz, left_nx, left_ny, left_nz, curving, lanes_load(lists->fixed[16]));
                dx = lanes_select(_m510, _o541.dx, dx);
                dy = lanes_select(_m510, _o541.dy, dy);
                dz = lanes_select(_m510, _o541.dz, dz);
                V lifting = _o541.lifting;
                dvx = lanes_select(_m510, _o541.dvx, dvx);
                dvy = lanes_select(_m510, _o541.dvy, dvy);
                dvz = lanes_select(_m510, _o541.dvz, dvz);
                V delay = _o541.delay;
                V shift = _o541.shift;
                const LANES(court_delayed_out) _o542 =
                    LANES(court_delayed)(clock_error, delay);
                clock_error = lanes_select(_m510, _o542.clock_error, clock_error);
                const M _m543 = lanes_both(_m510, ends);
                {
                    const LANES(court_floored_out) _o544 =
                        LANES(court_floored)(dx, dy, dz, shift);
                    dx = lanes_select(_m543, _o544.dx, dx);
                    dy = lanes_select(_m543, _o544.dy, dy);
                    dz = lanes_select(_m543, _o544.dz, dz);
                }
                const LANES(court_unturned_out) _o545 =
                    LANES(court_unturned)();
                V dnx = _o545.dnx;
                V dny = _o545.dny;
                V dnz = _o545.dnz;
                V turn = _o545.turn;
                const LANES(court_here_out) _o546 =
                    LANES(court_here)(K(0.0), which);
                here = _o546.here;
                const M _m547 = lanes_both(_m510, here);
                if (lanes_any(_m547)) {
                    const LANES(court_ring_carry_normal_out) _o548 =
                        LANES(court_ring_carry_normal)(x, y, dx, dy, dz, shift, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[108]), lanes_load(lists->fixed[160]));
                    dnx = lanes_select(_m547, _o548.dnx, dnx);
                    dny = lanes_select(_m547, _o548.dny, dny);
                    dnz = lanes_select(_m547, _o548.dnz, dnz);
                    turn = lanes_select(_m547, _o548.turn, turn);
                }
                const LANES(court_here_out) _o549 =
                    LANES(court_here)(K(1.0), which);
                here = _o549.here;
                const M _m550 = lanes_both(_m510, here);
                {
                    const LANES(court_backboard_carry_normal_out) _o551 =
                        LANES(court_backboard_carry_normal)(x, y, z, dx, dy, dz, shift, lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[9]));
                    dnx = lanes_select(_m550, _o551.dnx, dnx);
                    dny = lanes_select(_m550, _o551.dny, dny);
                    dnz = lanes_select(_m550, _o551.dnz, dnz);
                    turn = lanes_select(_m550, _o551.turn, turn);
                }
                const LANES(court_here_out) _o552 =
                    LANES(court_here)(K(2.0), which);
                here = _o552.here;
                const M _m553 = lanes_both(_m510, here);
                {
                    const LANES(court_bridge_carry_normal_out) _o554 =
                        LANES(court_bridge_carry_normal)(x, y, z, dx, dy, dz, shift, lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[109]), lanes_load(lists->fixed[10]));
                    dnx = lanes_select(_m553, _o554.dnx, dnx);
                    dny = lanes_select(_m553, _o554.dny, dny);
                    dnz = lanes_select(_m553, _o554.dnz, dnz);
                    turn = lanes_select(_m553, _o554.turn, turn);
                }
                const LANES(court_untaken_out) _o555 =
                    LANES(court_untaken)();
                M struck_0 = _o555.mine;
                const LANES(court_ring_impact_taken_out) _o556 =
                    LANES(court_ring_impact_taken)(p_ring_restitution, p_ring_friction);
                V its_0_ring_impact = _o556.its_0;
                V its_1_ring_impact = _o556.its_1;
                {
                    const double *const _t558[][2] = {
                        {lists->p_ring_friction, lists->p_ring_restitution},
                        {lists->p_backboard_friction, lists->p_backboard_restitution},
                        {lists->p_bridge_friction, lists->p_bridge_restitution},
                    };
                    static const double _t559[][1] = {
                        {0.0},
                        {1.0},
                        {2.0},
                    };
                    for (size_t _k557 = 0; _k557 < 3; _k557++) {
                        const V own_1 = lanes_load(_t558[_k557][0] + (i & varying));
                        const V own_2 = lanes_load(_t558[_k557][1] + (i & varying));
                        const V own_index = K(_t559[_k557][0]);
                        const LANES(court_here_out) _o560 =
                            LANES(court_here)(own_index, which);
                        M here = _o560.here;
                        const M _m561 = lanes_both(_m510, here);
                        if (lanes_any(_m561)) {
                            const LANES(court_ring_impact_taken_out) _o562 =
                                LANES(court_ring_impact_taken)(own_2, own_1);
                            struck_0 = lanes_choose(_m561, _o562.mine, struck_0);
                            its_0_ring_impact = lanes_select(_m561, _o562.its_0, its_0_ring_impact);
                            its_1_ring_impact = lanes_select(_m561, _o562.its_1, its_1_ring_impact);
                        }
                    }
                }
                const M _m563 = lanes_both(_m510, struck_0);
                if (lanes_any(_m563)) {
                    const LANES(court_ring_impact_doubt_out) _o564 =
                        LANES(court_ring_impact_doubt)(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, turn, its_0_ring_impact, its_1_ring_impact, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[161]), lanes_load(lists->fixed[162]));
                    M unsure = _o564.unsure;
                    const LANES(court_undecided_out) _o565 =
                        LANES(court_undecided)(uncertain, unsure);
                    uncertain = lanes_select(_m563, _o565.uncertain, uncertain);
                    const LANES(court_carry_ring_impact_out) _o566 =
                        LANES(court_carry_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, dnx, dny, dnz, turn, lifting, its_0_ring_impact, its_1_ring_impact, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[161]), lanes_load(lists->fixed[162]), lanes_load(lists->fixed[163]));
                    dvx = lanes_select(_m563, _o566.dvx, dvx);
                    dvy = lanes_select(_m563, _o566.dvy, dvy);
                    dvz = lanes_select(_m563, _o566.dvz, dvz);
                    dwx = lanes_select(_m563, _o566.dwx, dwx);
                    dwy = lanes_select(_m563, _o566.dwy, dwy);
                    dwz = lanes_select(_m563, _o566.dwz, dwz);
                    const LANES(court_ring_impact_out) _o567 =
                        LANES(court_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, its_0_ring_impact, its_1_ring_impact, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[161]), lanes_load(lists->fixed[162]), lanes_load(lists->fixed[163]));
                    vx = lanes_select(_m563, _o567.vx, vx);
                    vy = lanes_select(_m563, _o567.vy, vy);
                    vz = lanes_select(_m563, _o567.vz, vz);
                    wx = lanes_select(_m563, _o567.wx, wx);
                    wy = lanes_select(_m563, _o567.wy, wy);
                    wz = lanes_select(_m563, _o567.wz, wz);
                }
                const M _m568 = lanes_both(_m510, touches);
                {
                    const LANES(court_touched_out) _o569 =
                        LANES(court_touched)(body, first, which);
                    first = lanes_select(_m568, _o569.first, first);
                    last = lanes_select(_m568, _o569.last, last);
                    const LANES(court_slowed_out) _o570 =
                        LANES(court_slowed)(nx, ny, nz, position_error, vx, vy, vz, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[164]), lanes_load(lists->fixed[165]));
                    slow = lanes_choose(_m568, _o570.slow, slow);
                    assured = lanes_select(_m568, _o570.assured, assured);
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
                LANES(court_bounded_fix_f623)(lists, i);
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
            V position_claim = lanes_load(lists->position_claim + i);
            V spin_claim = lanes_load(lists->spin_claim + i);
            V time_claim = lanes_load(lists->time_claim + i);
            V velocity_claim = lanes_load(lists->velocity_claim + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V when = lanes_load(lists->when + i);
            V which = lanes_load(lists->which + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const M _m624 = lanes_both(rows, limited);
            if (lanes_any(_m624)) {
                const LANES(court_timed_out) _o625 =
                    LANES(court_timed)(claims, K(4.0), which);
                M timed = _o625.timed;
                const M _m626 = lanes_both(_m624, timed);
                if (lanes_any(_m626)) {
                    const LANES(court_carry_time_out) _o627 =
                        LANES(court_carry_time)(when, x, y, z, vx, vy, vz, clock, clock_error, dx, dy, dz, dvx, dvy, dvz, lanes_load(lists->fixed[16]), lanes_load(lists->fixed[48]));
                    dx = lanes_select(_m626, _o627.dx, dx);
                    dy = lanes_select(_m626, _o627.dy, dy);
                    dz = lanes_select(_m626, _o627.dz, dz);
                    dvx = lanes_select(_m626, _o627.dvx, dvx);
                    dvy = lanes_select(_m626, _o627.dvy, dvy);
                    dvz = lanes_select(_m626, _o627.dvz, dvz);
                    clock_error = lanes_select(_m626, _o627.clock_error, clock_error);
                }
            }
            const M _m628 = lanes_both(rows, hopped);
            if (lanes_any(_m628)) {
                const LANES(court_carry_hop_out) _o629 =
                    LANES(court_carry_hop)(dvx, dvy, dvz, dx, dy, dz, vx, vy, vz, when, x, y, z);
                dx = lanes_select(_m628, _o629.dx, dx);
                dy = lanes_select(_m628, _o629.dy, dy);
                dz = lanes_select(_m628, _o629.dz, dz);
            }
            const LANES(court_closing_out) _o630 =
                LANES(court_closing)(claims, outcome);
            M closed = _o630.closed;
            const M _m631 = lanes_both(rows, closed);
            {
                const LANES(court_claimed_errors_out) _o632 =
                    LANES(court_claimed_errors)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
                position_claim = lanes_select(_m631, _o632.position_error, position_claim);
                velocity_claim = lanes_select(_m631, _o632.velocity_error, velocity_claim);
                spin_claim = lanes_select(_m631, _o632.spin_error, spin_claim);
                time_claim = lanes_select(_m631, _o632.time_error, time_claim);
            }
            lanes_store(lists->clock_error + i, clock_error);
            lanes_store(lists->dvx + i, dvx);
            lanes_store(lists->dvy + i, dvy);
            lanes_store(lists->dvz + i, dvz);
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
            continue;
        }
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
#undef lanes_bits
#undef lanes_of
#undef lanes_many
#undef lanes_first
#undef lanes_leading
#undef lanes_count_up
#undef lanes_pack
#undef lanes_expand
