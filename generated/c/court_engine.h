/* The event loop of the scene court, LANES_WIDTH shots abreast.

   Generated from templates/c/engine.h.j2, scene court, derivation b518d3b1118d80e6,
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
    LANES(court_column) middle_x;
    LANES(court_column) middle_y;
    LANES(court_column) middle_z;
    LANES(court_column) reach_x;
    LANES(court_column) reach_y;
    LANES(court_column) reach_z;
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
        const LANES(court_holding_out) _o288 =
            LANES(court_holding)(held, K(0.0));
        M here = _o288.here;
        const M _m289 = lanes_both(rows, here);
        if (lanes_any(_m289)) {
            const LANES(court_ring_tube_out) _o290 =
                LANES(court_ring_tube)(p_ball_radius, p_wire_radius);
            per_reach = lanes_select(_m289, _o290.per_reach, per_reach);
            const LANES(court_ring_parting_out) _o291 =
                LANES(court_ring_parting)(p_gravity, p_ring_radius, vx, vy, vz, x, y, z);
            lift = lanes_select(_m289, _o291.lift, lift);
            surge = lanes_select(_m289, _o291.surge, surge);
            snap = lanes_select(_m289, _o291.snap, snap);
        }
        const LANES(court_holding_out) _o292 =
            LANES(court_holding)(held, K(1.0));
        here = _o292.here;
        const M _m293 = lanes_both(rows, here);
        if (lanes_any(_m293)) {
            const LANES(court_backboard_tube_out) _o294 =
                LANES(court_backboard_tube)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            per_reach = lanes_select(_m293, _o294.per_reach, per_reach);
            const LANES(court_backboard_parting_out) _o295 =
                LANES(court_backboard_parting)(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, vx, vy, vz, x, y, z);
            lift = lanes_select(_m293, _o295.lift, lift);
            surge = lanes_select(_m293, _o295.surge, surge);
            snap = lanes_select(_m293, _o295.snap, snap);
        }
        const LANES(court_holding_out) _o296 =
            LANES(court_holding)(held, K(2.0));
        here = _o296.here;
        const M _m297 = lanes_both(rows, here);
        if (lanes_any(_m297)) {
            const LANES(court_bridge_tube_out) _o298 =
                LANES(court_bridge_tube)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            per_reach = lanes_select(_m297, _o298.per_reach, per_reach);
            const LANES(court_bridge_parting_out) _o299 =
                LANES(court_bridge_parting)(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            lift = lanes_select(_m297, _o299.lift, lift);
            surge = lanes_select(_m297, _o299.surge, surge);
            snap = lanes_select(_m297, _o299.snap, snap);
        }
        const LANES(court_unmet_out) _o300 =
            LANES(court_unmet)();
        V spare = _o300.spare;
        const LANES(court_beside_out) _o301 =
            LANES(court_beside)(held, K(0.0));
        M beside = _o301.beside;
        const M _m302 = lanes_both(rows, beside);
        if (lanes_any(_m302)) {
            const LANES(court_ring_beside_out) _o303 =
                LANES(court_ring_beside)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            V gap = _o303.gap;
            V nearing = _o303.nearing;
            V dent = _o303.dent;
            const LANES(court_spared_out) _o304 =
                LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
            spare = lanes_select(_m302, _o304.spare, spare);
        }
        const LANES(court_beside_out) _o305 =
            LANES(court_beside)(held, K(1.0));
        beside = _o305.beside;
        const M _m306 = lanes_both(rows, beside);
        if (lanes_any(_m306)) {
            const LANES(court_backboard_beside_out) _o307 =
                LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            V gap = _o307.gap;
            V nearing = _o307.nearing;
            V dent = _o307.dent;
            const LANES(court_spared_out) _o308 =
                LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
            spare = lanes_select(_m306, _o308.spare, spare);
        }
        const LANES(court_beside_out) _o309 =
            LANES(court_beside)(held, K(2.0));
        beside = _o309.beside;
        const M _m310 = lanes_both(rows, beside);
        if (lanes_any(_m310)) {
            const LANES(court_bridge_beside_out) _o311 =
                LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            V gap = _o311.gap;
            V nearing = _o311.nearing;
            V dent = _o311.dent;
            const LANES(court_spared_out) _o312 =
                LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
            spare = lanes_select(_m310, _o312.spare, spare);
        }
        const LANES(court_beside_out) _o313 =
            LANES(court_beside)(held, K(3.0));
        beside = _o313.beside;
        const M _m314 = lanes_both(rows, beside);
        if (lanes_any(_m314)) {
            const LANES(court_end_beside_out) _o315 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            V gap = _o315.gap;
            V nearing = _o315.nearing;
            V dent = _o315.dent;
            const LANES(court_spared_out) _o316 =
                LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
            spare = lanes_select(_m314, _o316.spare, spare);
        }
        const LANES(court_holding_out) _o317 =
            LANES(court_holding)(held, K(1.0));
        here = _o317.here;
        const M _m318 = lanes_both(rows, here);
        if (lanes_any(_m318)) {
            const LANES(court_backboard_seam0_out) _o319 =
                LANES(court_backboard_seam0)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
            V gap = _o319.gap;
            V nearing = _o319.nearing;
            V near = _o319.near;
            const LANES(court_spared_seam_out) _o320 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m318, _o320.spare, spare);
            const LANES(court_backboard_seam1_out) _o321 =
                LANES(court_backboard_seam1)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
            gap = _o321.gap;
            nearing = _o321.nearing;
            near = _o321.near;
            const LANES(court_spared_seam_out) _o322 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m318, _o322.spare, spare);
            const LANES(court_backboard_seam2_out) _o323 =
                LANES(court_backboard_seam2)(p_ball_radius, p_board_half_width, vy, y);
            gap = _o323.gap;
            nearing = _o323.nearing;
            near = _o323.near;
            const LANES(court_spared_seam_out) _o324 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m318, _o324.spare, spare);
            const LANES(court_backboard_seam3_out) _o325 =
                LANES(court_backboard_seam3)(p_ball_radius, p_board_half_width, vy, y);
            gap = _o325.gap;
            nearing = _o325.nearing;
            near = _o325.near;
            const LANES(court_spared_seam_out) _o326 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m318, _o326.spare, spare);
            const LANES(court_backboard_seam4_out) _o327 =
                LANES(court_backboard_seam4)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
            gap = _o327.gap;
            nearing = _o327.nearing;
            near = _o327.near;
            const LANES(court_spared_seam_out) _o328 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m318, _o328.spare, spare);
            const LANES(court_backboard_seam5_out) _o329 =
                LANES(court_backboard_seam5)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
            gap = _o329.gap;
            nearing = _o329.nearing;
            near = _o329.near;
            const LANES(court_spared_seam_out) _o330 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m318, _o330.spare, spare);
        }
        const LANES(court_holding_out) _o331 =
            LANES(court_holding)(held, K(2.0));
        here = _o331.here;
        const M _m332 = lanes_both(rows, here);
        if (lanes_any(_m332)) {
            const LANES(court_bridge_seam0_out) _o333 =
                LANES(court_bridge_seam0)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
            V gap = _o333.gap;
            V nearing = _o333.nearing;
            V near = _o333.near;
            const LANES(court_spared_seam_out) _o334 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m332, _o334.spare, spare);
            const LANES(court_bridge_seam1_out) _o335 =
                LANES(court_bridge_seam1)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
            gap = _o335.gap;
            nearing = _o335.nearing;
            near = _o335.near;
            const LANES(court_spared_seam_out) _o336 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m332, _o336.spare, spare);
            const LANES(court_bridge_seam2_out) _o337 =
                LANES(court_bridge_seam2)(p_ball_radius, p_bridge_half_width, vy, y);
            gap = _o337.gap;
            nearing = _o337.nearing;
            near = _o337.near;
            const LANES(court_spared_seam_out) _o338 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m332, _o338.spare, spare);
            const LANES(court_bridge_seam3_out) _o339 =
                LANES(court_bridge_seam3)(p_ball_radius, p_bridge_half_width, vy, y);
            gap = _o339.gap;
            nearing = _o339.nearing;
            near = _o339.near;
            const LANES(court_spared_seam_out) _o340 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m332, _o340.spare, spare);
            const LANES(court_bridge_seam4_out) _o341 =
                LANES(court_bridge_seam4)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
            gap = _o341.gap;
            nearing = _o341.nearing;
            near = _o341.near;
            const LANES(court_spared_seam_out) _o342 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m332, _o342.spare, spare);
            const LANES(court_bridge_seam5_out) _o343 =
                LANES(court_bridge_seam5)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
            gap = _o343.gap;
            nearing = _o343.nearing;
            near = _o343.near;
            const LANES(court_spared_seam_out) _o344 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m332, _o344.spare, spare);
        }
        const LANES(court_parted_out) _o345 =
            LANES(court_parted)(K(INFINITY), p_gravity, lift, per_reach, K(0.0), snap, spare, surge, K(0.0), vx, vy, vz);
        V when = _o345.when;
        const LANES(court_hopping_out) _o346 =
            LANES(court_hopping)();
        V which = _o346.which;
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
        const LANES(court_resumed_out) _o144 =
            LANES(court_resumed)(clock, mode, K(0.0), K(0.0));
        V which = _o144.which;
        V began = _o144.began;
        M begins = _o144.begins;
        M rolling = _o144.rolling;
        M leaves = _o144.leaves;
        V nx = _o144.nx;
        V ny = _o144.ny;
        V nz = _o144.nz;
        V gap = _o144.gap;
        V bent_x = _o144.bent_x;
        V bent_y = _o144.bent_y;
        V bent_z = _o144.bent_z;
        V lift = _o144.lift;
        V surge = _o144.surge;
        V snap = _o144.snap;
        V per_reach = _o144.per_reach;
        const M _m145 = lanes_both(rows, begins);
        if (lanes_any(_m145)) {
            const LANES(court_holding_out) _o146 =
                LANES(court_holding)(held, K(0.0));
            M here = _o146.here;
            const M _m147 = lanes_both(_m145, here);
            {
                const LANES(court_ring_normal_out) _o148 =
                    LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                nx = lanes_select(_m147, _o148.nx, nx);
                ny = lanes_select(_m147, _o148.ny, ny);
                nz = lanes_select(_m147, _o148.nz, nz);
            }
            const LANES(court_holding_out) _o149 =
                LANES(court_holding)(held, K(1.0));
            here = _o149.here;
            const M _m150 = lanes_both(_m145, here);
            {
                const LANES(court_backboard_normal_out) _o151 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m150, _o151.nx, nx);
                ny = lanes_select(_m150, _o151.ny, ny);
                nz = lanes_select(_m150, _o151.nz, nz);
            }
            const LANES(court_holding_out) _o152 =
                LANES(court_holding)(held, K(2.0));
            here = _o152.here;
            const M _m153 = lanes_both(_m145, here);
            {
                const LANES(court_bridge_normal_out) _o154 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m153, _o154.nx, nx);
                ny = lanes_select(_m153, _o154.ny, ny);
                nz = lanes_select(_m153, _o154.nz, nz);
            }
            const LANES(court_roll_turn_rate_out) _o155 =
                LANES(court_roll_turn_rate)(p_ball_radius, nx, ny, nz, wx, wy, wz);
            V turn_rate = _o155.turn_rate;
            const LANES(court_gripped_out) _o156 =
                LANES(court_gripped)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
            V rolled_x = _o156.rolled_x;
            V rolled_y = _o156.rolled_y;
            V rolled_z = _o156.rolled_z;
            const LANES(court_holding_out) _o157 =
                LANES(court_holding)(held, K(0.0));
            here = _o157.here;
            const M _m158 = lanes_both(_m145, here);
            {
                const LANES(court_ring_off_out) _o159 =
                    LANES(court_ring_off)(p_ball_radius, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m158, _o159.gap, gap);
            }
            const LANES(court_holding_out) _o160 =
                LANES(court_holding)(held, K(1.0));
            here = _o160.here;
            const M _m161 = lanes_both(_m145, here);
            {
                const LANES(court_backboard_off_out) _o162 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z);
                gap = lanes_select(_m161, _o162.gap, gap);
            }
            const LANES(court_holding_out) _o163 =
                LANES(court_holding)(held, K(2.0));
            here = _o163.here;
            const M _m164 = lanes_both(_m145, here);
            {
                const LANES(court_bridge_off_out) _o165 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m164, _o165.gap, gap);
            }
            const LANES(court_roll_placed_out) _o166 =
                LANES(court_roll_placed)(p_ball_radius, gap, nx, ny, nz, turn_rate, rolled_x, rolled_y, rolled_z, x, y, z);
            x = lanes_select(_m145, _o166.x, x);
            y = lanes_select(_m145, _o166.y, y);
            z = lanes_select(_m145, _o166.z, z);
            vx = lanes_select(_m145, _o166.vx, vx);
            vy = lanes_select(_m145, _o166.vy, vy);
            vz = lanes_select(_m145, _o166.vz, vz);
            wx = lanes_select(_m145, _o166.wx, wx);
            wy = lanes_select(_m145, _o166.wy, wy);
            wz = lanes_select(_m145, _o166.wz, wz);
            const LANES(court_beginning_contact_out) _o167 =
                LANES(court_beginning_contact)();
            which = lanes_select(_m145, _o167.which, which);
            circled = lanes_select(_m145, _o167.circled, circled);
        }
        const LANES(court_circles_out) _o168 =
            LANES(court_circles)(held, K(0.0), rolling);
        M circling = _o168.circling;
        rolling = _o168.rolling;
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
            const LANES(court_holding_out) _o169 =
                LANES(court_holding)(held, K(1.0));
            M here = _o169.here;
            const M _m170 = lanes_both(active, here);
            if (lanes_any(_m170)) {
                const LANES(court_backboard_normal_out) _o171 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m170, _o171.nx, nx);
                ny = lanes_select(_m170, _o171.ny, ny);
                nz = lanes_select(_m170, _o171.nz, nz);
                const LANES(court_backboard_tube_out) _o172 =
                    LANES(court_backboard_tube)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                bent_x = lanes_select(_m170, _o172.bent_x, bent_x);
                bent_y = lanes_select(_m170, _o172.bent_y, bent_y);
                bent_z = lanes_select(_m170, _o172.bent_z, bent_z);
                per_reach = lanes_select(_m170, _o172.per_reach, per_reach);
            }
            const LANES(court_holding_out) _o173 =
                LANES(court_holding)(held, K(2.0));
            here = _o173.here;
            const M _m174 = lanes_both(active, here);
            if (lanes_any(_m174)) {
                const LANES(court_bridge_normal_out) _o175 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m174, _o175.nx, nx);
                ny = lanes_select(_m174, _o175.ny, ny);
                nz = lanes_select(_m174, _o175.nz, nz);
                const LANES(court_bridge_tube_out) _o176 =
                    LANES(court_bridge_tube)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                bent_x = lanes_select(_m174, _o176.bent_x, bent_x);
                bent_y = lanes_select(_m174, _o176.bent_y, bent_y);
                bent_z = lanes_select(_m174, _o176.bent_z, bent_z);
                per_reach = lanes_select(_m174, _o176.per_reach, per_reach);
            }
            const LANES(court_roll_start_out) _o177 =
                LANES(court_roll_start)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
            V vx_0 = _o177.vx_0;
            V vy_0 = _o177.vy_0;
            V vz_0 = _o177.vz_0;
            V nx_0 = _o177.nx_0;
            V ny_0 = _o177.ny_0;
            V nz_0 = _o177.nz_0;
            V turn_rate_0 = _o177.turn_rate_0;
            const LANES(court_roll_0_out) _o178 =
                LANES(court_roll_0)(bent_x, bent_y, bent_z, p_gravity, nx_0, ny_0, nz_0, per_reach, turn_rate_0, vx_0, vy_0, vz_0);
            V lift_0 = _o178.lift_0;
            V tx_0 = _o178.tx_0;
            V ty_0 = _o178.ty_0;
            V tz_0 = _o178.tz_0;
            V vx_1 = _o178.vx_1;
            V vy_1 = _o178.vy_1;
            V vz_1 = _o178.vz_1;
            V nx_1 = _o178.nx_1;
            V ny_1 = _o178.ny_1;
            V nz_1 = _o178.nz_1;
            V turn_rate_1 = _o178.turn_rate_1;
            const LANES(court_roll_1_out) _o179 =
                LANES(court_roll_1)(bent_x, bent_y, bent_z, p_gravity, lift_0, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1);
            V lift_1 = _o179.lift_1;
            V tx_1 = _o179.tx_1;
            V ty_1 = _o179.ty_1;
            V tz_1 = _o179.tz_1;
            V vx_2 = _o179.vx_2;
            V vy_2 = _o179.vy_2;
            V vz_2 = _o179.vz_2;
            V nx_2 = _o179.nx_2;
            V ny_2 = _o179.ny_2;
            V nz_2 = _o179.nz_2;
            V turn_rate_2 = _o179.turn_rate_2;
            const LANES(court_roll_2_out) _o180 =
                LANES(court_roll_2)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2);
            V lift_2 = _o180.lift_2;
            V tx_2 = _o180.tx_2;
            V ty_2 = _o180.ty_2;
            V tz_2 = _o180.tz_2;
            V vx_3 = _o180.vx_3;
            V vy_3 = _o180.vy_3;
            V vz_3 = _o180.vz_3;
            V nx_3 = _o180.nx_3;
            V ny_3 = _o180.ny_3;
            V nz_3 = _o180.nz_3;
            V turn_rate_3 = _o180.turn_rate_3;
            const LANES(court_roll_3_out) _o181 =
                LANES(court_roll_3)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3);
            V lift_3 = _o181.lift_3;
            V tx_3 = _o181.tx_3;
            V ty_3 = _o181.ty_3;
            V tz_3 = _o181.tz_3;
            V vx_4 = _o181.vx_4;
            V vy_4 = _o181.vy_4;
            V vz_4 = _o181.vz_4;
            V nx_4 = _o181.nx_4;
            V ny_4 = _o181.ny_4;
            V nz_4 = _o181.nz_4;
            V turn_rate_4 = _o181.turn_rate_4;
            const LANES(court_roll_4_out) _o182 =
                LANES(court_roll_4)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4);
            V lift_4 = _o182.lift_4;
            V tx_4 = _o182.tx_4;
            V ty_4 = _o182.ty_4;
            V tz_4 = _o182.tz_4;
            V vx_5 = _o182.vx_5;
            V vy_5 = _o182.vy_5;
            V vz_5 = _o182.vz_5;
            V nx_5 = _o182.nx_5;
            V ny_5 = _o182.ny_5;
            V nz_5 = _o182.nz_5;
            V turn_rate_5 = _o182.turn_rate_5;
            const LANES(court_roll_5_out) _o183 =
                LANES(court_roll_5)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5);
            V lift_5 = _o183.lift_5;
            V tx_5 = _o183.tx_5;
            V ty_5 = _o183.ty_5;
            V tz_5 = _o183.tz_5;
            V vx_6 = _o183.vx_6;
            V vy_6 = _o183.vy_6;
            V vz_6 = _o183.vz_6;
            V nx_6 = _o183.nx_6;
            V ny_6 = _o183.ny_6;
            V nz_6 = _o183.nz_6;
            V turn_rate_6 = _o183.turn_rate_6;
            const LANES(court_roll_6_out) _o184 =
                LANES(court_roll_6)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6);
            V lift_6 = _o184.lift_6;
            V tx_6 = _o184.tx_6;
            V ty_6 = _o184.ty_6;
            V tz_6 = _o184.tz_6;
            V vx_7 = _o184.vx_7;
            V vy_7 = _o184.vy_7;
            V vz_7 = _o184.vz_7;
            V nx_7 = _o184.nx_7;
            V ny_7 = _o184.ny_7;
            V nz_7 = _o184.nz_7;
            V turn_rate_7 = _o184.turn_rate_7;
            const LANES(court_roll_7_out) _o185 =
                LANES(court_roll_7)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7);
            V lift_7 = _o185.lift_7;
            V vx_8 = _o185.vx_8;
            V vy_8 = _o185.vy_8;
            V vz_8 = _o185.vz_8;
            V nx_8 = _o185.nx_8;
            V ny_8 = _o185.ny_8;
            V nz_8 = _o185.nz_8;
            V turn_rate_8 = _o185.turn_rate_8;
            const LANES(court_roll_pace_out) _o186 =
                LANES(court_roll_pace)(p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, lift_7, nx_8, ny_8, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, nz_8, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8);
            V stride = _o186.stride;
            V strongest = _o186.strongest;
            V fastest = _o186.fastest;
            V force = _o186.force;
            V force_rate = _o186.force_rate;
            V force_bend = _o186.force_bend;
            V brace = _o186.brace;
            const LANES(court_leaving_force_out) _o187 =
                LANES(court_leaving_force)(p_ball_radius, brace, K(INFINITY), fastest, force, force_bend, force_rate, p_gravity, per_reach, K(0.0), stride, K(0.0), vx, vx_1, vy, vy_1, vz, vz_1, which);
            stride = _o187.stride;
            which = _o187.which;
            M rests = _o187.rests;
            const LANES(court_beside_out) _o188 =
                LANES(court_beside)(held, K(0.0));
            M beside = _o188.beside;
            const M _m189 = lanes_both(active, beside);
            if (lanes_any(_m189)) {
                const LANES(court_ring_beside_out) _o190 =
                    LANES(court_ring_beside)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                V gap = _o190.gap;
                V nearing = _o190.nearing;
                V dent = _o190.dent;
                const LANES(court_beside_body_out) _o191 =
                    LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(0.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
                stride = lanes_select(_m189, _o191.stride, stride);
                which = lanes_select(_m189, _o191.which, which);
            }
            const LANES(court_beside_out) _o192 =
                LANES(court_beside)(held, K(1.0));
            beside = _o192.beside;
            const M _m193 = lanes_both(active, beside);
            if (lanes_any(_m193)) {
                const LANES(court_backboard_beside_out) _o194 =
                    LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                V gap = _o194.gap;
                V nearing = _o194.nearing;
                V dent = _o194.dent;
                const LANES(court_beside_body_out) _o195 =
                    LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(1.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
                stride = lanes_select(_m193, _o195.stride, stride);
                which = lanes_select(_m193, _o195.which, which);
            }
            const LANES(court_beside_out) _o196 =
                LANES(court_beside)(held, K(2.0));
            beside = _o196.beside;
            const M _m197 = lanes_both(active, beside);
            if (lanes_any(_m197)) {
                const LANES(court_bridge_beside_out) _o198 =
                    LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                V gap = _o198.gap;
                V nearing = _o198.nearing;
                V dent = _o198.dent;
                const LANES(court_beside_body_out) _o199 =
                    LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(2.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
                stride = lanes_select(_m197, _o199.stride, stride);
                which = lanes_select(_m197, _o199.which, which);
            }
            const LANES(court_end_beside_out) _o200 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            V gap = _o200.gap;
            V nearing = _o200.nearing;
            V dent = _o200.dent;
            const LANES(court_beside_gate_out) _o201 =
                LANES(court_beside_gate)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(3.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
            stride = _o201.stride;
            which = _o201.which;
            const LANES(court_holding_out) _o202 =
                LANES(court_holding)(held, K(1.0));
            here = _o202.here;
            const M _m203 = lanes_both(active, here);
            if (lanes_any(_m203)) {
                const LANES(court_backboard_seam0_out) _o204 =
                    LANES(court_backboard_seam0)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                gap = lanes_select(_m203, _o204.gap, gap);
                V nearing = _o204.nearing;
                V near = _o204.near;
                const LANES(court_beside_seam_out) _o205 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m203, _o205.stride, stride);
                const LANES(court_backboard_seam1_out) _o206 =
                    LANES(court_backboard_seam1)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                gap = lanes_select(_m203, _o206.gap, gap);
                nearing = _o206.nearing;
                near = _o206.near;
                const LANES(court_beside_seam_out) _o207 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m203, _o207.stride, stride);
                const LANES(court_backboard_seam2_out) _o208 =
                    LANES(court_backboard_seam2)(p_ball_radius, p_board_half_width, vy, y);
                gap = lanes_select(_m203, _o208.gap, gap);
                nearing = _o208.nearing;
                near = _o208.near;
                const LANES(court_beside_seam_out) _o209 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m203, _o209.stride, stride);
                const LANES(court_backboard_seam3_out) _o210 =
                    LANES(court_backboard_seam3)(p_ball_radius, p_board_half_width, vy, y);
                gap = lanes_select(_m203, _o210.gap, gap);
                nearing = _o210.nearing;
                near = _o210.near;
                const LANES(court_beside_seam_out) _o211 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m203, _o211.stride, stride);
                const LANES(court_backboard_seam4_out) _o212 =
                    LANES(court_backboard_seam4)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                gap = lanes_select(_m203, _o212.gap, gap);
                nearing = _o212.nearing;
                near = _o212.near;
                const LANES(court_beside_seam_out) _o213 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m203, _o213.stride, stride);
                const LANES(court_backboard_seam5_out) _o214 =
                    LANES(court_backboard_seam5)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                gap = lanes_select(_m203, _o214.gap, gap);
                nearing = _o214.nearing;
                near = _o214.near;
                const LANES(court_beside_seam_out) _o215 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m203, _o215.stride, stride);
            }
            const LANES(court_holding_out) _o216 =
                LANES(court_holding)(held, K(2.0));
            here = _o216.here;
            const M _m217 = lanes_both(active, here);
            if (lanes_any(_m217)) {
                const LANES(court_bridge_seam0_out) _o218 =
                    LANES(court_bridge_seam0)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                gap = lanes_select(_m217, _o218.gap, gap);
                V nearing = _o218.nearing;
                V near = _o218.near;
                const LANES(court_beside_seam_out) _o219 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m217, _o219.stride, stride);
                const LANES(court_bridge_seam1_out) _o220 =
                    LANES(court_bridge_seam1)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                gap = lanes_select(_m217, _o220.gap, gap);
                nearing = _o220.nearing;
                near = _o220.near;
                const LANES(court_beside_seam_out) _o221 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m217, _o221.stride, stride);
                const LANES(court_bridge_seam2_out) _o222 =
                    LANES(court_bridge_seam2)(p_ball_radius, p_bridge_half_width, vy, y);
                gap = lanes_select(_m217, _o222.gap, gap);
                nearing = _o222.nearing;
                near = _o222.near;
                const LANES(court_beside_seam_out) _o223 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m217, _o223.stride, stride);
                const LANES(court_bridge_seam3_out) _o224 =
                    LANES(court_bridge_seam3)(p_ball_radius, p_bridge_half_width, vy, y);
                gap = lanes_select(_m217, _o224.gap, gap);
                nearing = _o224.nearing;
                near = _o224.near;
                const LANES(court_beside_seam_out) _o225 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m217, _o225.stride, stride);
                const LANES(court_bridge_seam4_out) _o226 =
                    LANES(court_bridge_seam4)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                gap = lanes_select(_m217, _o226.gap, gap);
                nearing = _o226.nearing;
                near = _o226.near;
                const LANES(court_beside_seam_out) _o227 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m217, _o227.stride, stride);
                const LANES(court_bridge_seam5_out) _o228 =
                    LANES(court_bridge_seam5)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                gap = lanes_select(_m217, _o228.gap, gap);
                nearing = _o228.nearing;
                near = _o228.near;
                const LANES(court_beside_seam_out) _o229 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m217, _o229.stride, stride);
            }
            const LANES(court_beside_time_out) _o230 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o230.stride;
            which = _o230.which;
            const LANES(court_passing_from_out) _o231 =
                LANES(court_passing_from)(z);
            M over = _o231.over;
            const LANES(court_roll_moved_out) _o232 =
                LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, x, y, z);
            x = _o232.x;
            vx = _o232.vx;
            y = _o232.y;
            vy = _o232.vy;
            z = _o232.z;
            vz = _o232.vz;
            V turn_rate = _o232.turn_rate;
            const LANES(court_holding_out) _o233 =
                LANES(court_holding)(held, K(1.0));
            here = _o233.here;
            const M _m234 = lanes_both(active, here);
            if (lanes_any(_m234)) {
                const LANES(court_backboard_normal_out) _o235 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m234, _o235.nx, nx);
                ny = lanes_select(_m234, _o235.ny, ny);
                nz = lanes_select(_m234, _o235.nz, nz);
                const LANES(court_backboard_off_out) _o236 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z);
                gap = lanes_select(_m234, _o236.gap, gap);
            }
            const LANES(court_holding_out) _o237 =
                LANES(court_holding)(held, K(2.0));
            here = _o237.here;
            const M _m238 = lanes_both(active, here);
            if (lanes_any(_m238)) {
                const LANES(court_bridge_normal_out) _o239 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m238, _o239.nx, nx);
                ny = lanes_select(_m238, _o239.ny, ny);
                nz = lanes_select(_m238, _o239.nz, nz);
                const LANES(court_bridge_off_out) _o240 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m238, _o240.gap, gap);
            }
            const LANES(court_roll_placed_out) _o241 =
                LANES(court_roll_placed)(p_ball_radius, gap, nx, ny, nz, turn_rate, vx, vy, vz, x, y, z);
            x = _o241.x;
            y = _o241.y;
            z = _o241.z;
            vx = _o241.vx;
            vy = _o241.vy;
            vz = _o241.vz;
            wx = _o241.wx;
            wy = _o241.wy;
            wz = _o241.wz;
            const LANES(court_passing_in_contact_out) _o242 =
                LANES(court_passing_in_contact)(over, p_ring_radius, through, x, y, z);
            through = _o242.through;
            const LANES(court_rolled_on_out) _o243 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o243.clock;
            rolling = _o243.rolling;
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
            const LANES(court_ring_tube_out) _o244 =
                LANES(court_ring_tube)(p_ball_radius, p_wire_radius);
            V per_reach = _o244.per_reach;
            const LANES(court_ring_round_start_out) _o245 =
                LANES(court_ring_round_start)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, wx, wy, wz, x, y, z);
            V cosine_0 = _o245.cosine_0;
            V sine_0 = _o245.sine_0;
            V climb_0 = _o245.climb_0;
            V along_0 = _o245.along_0;
            V turn_rate_0 = _o245.turn_rate_0;
            V cos_0 = _o245.cos_0;
            V sin_0 = _o245.sin_0;
            V near_0 = _o245.near_0;
            const LANES(court_ring_round_0_out) _o246 =
                LANES(court_ring_round_0)(along_0, p_ball_radius, climb_0, cos_0, cosine_0, p_gravity, near_0, p_ring_radius, sin_0, sine_0, turn_rate_0, p_wire_radius);
            V omega_0 = _o246.omega_0;
            V around_0 = _o246.around_0;
            V tilted_0 = _o246.tilted_0;
            V pressed_0 = _o246.pressed_0;
            V force_0 = _o246.force_0;
            V cosine_1 = _o246.cosine_1;
            V sine_1 = _o246.sine_1;
            V climb_1 = _o246.climb_1;
            V along_1 = _o246.along_1;
            V turn_rate_1 = _o246.turn_rate_1;
            V cos_1 = _o246.cos_1;
            V sin_1 = _o246.sin_1;
            const LANES(court_ring_round_1_out) _o247 =
                LANES(court_ring_round_1)(along_0, along_1, around_0, p_ball_radius, climb_0, climb_1, cos_0, cos_1, cosine_0, cosine_1, p_gravity, near_0, omega_0, pressed_0, p_ring_radius, sin_0, sin_1, sine_0, sine_1, tilted_0, turn_rate_0, turn_rate_1, p_wire_radius);
            V near_1 = _o247.near_1;
            V omega_1 = _o247.omega_1;
            V around_1 = _o247.around_1;
            V tilted_1 = _o247.tilted_1;
            V pressed_1 = _o247.pressed_1;
            V force_1 = _o247.force_1;
            V cosine_2 = _o247.cosine_2;
            V sine_2 = _o247.sine_2;
            V climb_2 = _o247.climb_2;
            V along_2 = _o247.along_2;
            V turn_rate_2 = _o247.turn_rate_2;
            V cos_2 = _o247.cos_2;
            V sin_2 = _o247.sin_2;
            const LANES(court_ring_round_2_out) _o248 =
                LANES(court_ring_round_2)(along_0, along_1, along_2, around_0, around_1, p_ball_radius, climb_0, climb_1, climb_2, cos_0, cos_1, cos_2, cosine_0, cosine_1, cosine_2, p_gravity, near_0, near_1, omega_0, omega_1, pressed_0, pressed_1, p_ring_radius, sin_0, sin_1, sin_2, sine_0, sine_1, sine_2, tilted_0, tilted_1, turn_rate_0, turn_rate_1, turn_rate_2, p_wire_radius);
            V near_2 = _o248.near_2;
            V omega_2 = _o248.omega_2;
            V around_2 = _o248.around_2;
            V tilted_2 = _o248.tilted_2;
            V pressed_2 = _o248.pressed_2;
            V force_2 = _o248.force_2;
            V cosine_3 = _o248.cosine_3;
            V sine_3 = _o248.sine_3;
            V climb_3 = _o248.climb_3;
            V along_3 = _o248.along_3;
            V turn_rate_3 = _o248.turn_rate_3;
            V cos_3 = _o248.cos_3;
            V sin_3 = _o248.sin_3;
            const LANES(court_ring_round_3_out) _o249 =
                LANES(court_ring_round_3)(along_0, along_1, along_2, along_3, around_0, around_1, around_2, p_ball_radius, climb_0, climb_1, climb_2, climb_3, cos_0, cos_1, cos_2, cos_3, cosine_0, cosine_1, cosine_2, cosine_3, p_gravity, near_0, near_1, near_2, omega_0, omega_1, omega_2, pressed_0, pressed_1, pressed_2, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sine_0, sine_1, sine_2, sine_3, tilted_0, tilted_1, tilted_2, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, p_wire_radius);
            V near_3 = _o249.near_3;
            V omega_3 = _o249.omega_3;
            V around_3 = _o249.around_3;
            V tilted_3 = _o249.tilted_3;
            V pressed_3 = _o249.pressed_3;
            V force_3 = _o249.force_3;
            V cosine_4 = _o249.cosine_4;
            V sine_4 = _o249.sine_4;
            V climb_4 = _o249.climb_4;
            V along_4 = _o249.along_4;
            V turn_rate_4 = _o249.turn_rate_4;
            V cos_4 = _o249.cos_4;
            V sin_4 = _o249.sin_4;
            const LANES(court_ring_round_4_out) _o250 =
                LANES(court_ring_round_4)(along_0, along_1, along_2, along_3, along_4, around_0, around_1, around_2, around_3, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, cos_0, cos_1, cos_2, cos_3, cos_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, p_gravity, near_0, near_1, near_2, near_3, omega_0, omega_1, omega_2, omega_3, pressed_0, pressed_1, pressed_2, pressed_3, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sine_0, sine_1, sine_2, sine_3, sine_4, tilted_0, tilted_1, tilted_2, tilted_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, p_wire_radius);
            V near_4 = _o250.near_4;
            V omega_4 = _o250.omega_4;
            V around_4 = _o250.around_4;
            V tilted_4 = _o250.tilted_4;
            V pressed_4 = _o250.pressed_4;
            V force_4 = _o250.force_4;
            V cosine_5 = _o250.cosine_5;
            V sine_5 = _o250.sine_5;
            V climb_5 = _o250.climb_5;
            V along_5 = _o250.along_5;
            V turn_rate_5 = _o250.turn_rate_5;
            V cos_5 = _o250.cos_5;
            V sin_5 = _o250.sin_5;
            const LANES(court_ring_round_5_out) _o251 =
                LANES(court_ring_round_5)(along_0, along_1, along_2, along_3, along_4, along_5, around_0, around_1, around_2, around_3, around_4, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, p_gravity, near_0, near_1, near_2, near_3, near_4, omega_0, omega_1, omega_2, omega_3, omega_4, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, p_wire_radius);
            V near_5 = _o251.near_5;
            V omega_5 = _o251.omega_5;
            V around_5 = _o251.around_5;
            V tilted_5 = _o251.tilted_5;
            V pressed_5 = _o251.pressed_5;
            V force_5 = _o251.force_5;
            V cosine_6 = _o251.cosine_6;
            V sine_6 = _o251.sine_6;
            V climb_6 = _o251.climb_6;
            V along_6 = _o251.along_6;
            V turn_rate_6 = _o251.turn_rate_6;
            V cos_6 = _o251.cos_6;
            V sin_6 = _o251.sin_6;
            const LANES(court_ring_round_6_out) _o252 =
                LANES(court_ring_round_6)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, around_0, around_1, around_2, around_3, around_4, around_5, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, p_wire_radius);
            V near_6 = _o252.near_6;
            V omega_6 = _o252.omega_6;
            V around_6 = _o252.around_6;
            V tilted_6 = _o252.tilted_6;
            V pressed_6 = _o252.pressed_6;
            V force_6 = _o252.force_6;
            V cosine_7 = _o252.cosine_7;
            V sine_7 = _o252.sine_7;
            V climb_7 = _o252.climb_7;
            V along_7 = _o252.along_7;
            V turn_rate_7 = _o252.turn_rate_7;
            V cos_7 = _o252.cos_7;
            V sin_7 = _o252.sin_7;
            const LANES(court_ring_round_7_out) _o253 =
                LANES(court_ring_round_7)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, p_wire_radius);
            V near_7 = _o253.near_7;
            V omega_7 = _o253.omega_7;
            V around_7 = _o253.around_7;
            V tilted_7 = _o253.tilted_7;
            V pressed_7 = _o253.pressed_7;
            V force_7 = _o253.force_7;
            V cosine_8 = _o253.cosine_8;
            V sine_8 = _o253.sine_8;
            V climb_8 = _o253.climb_8;
            V along_8 = _o253.along_8;
            V turn_rate_8 = _o253.turn_rate_8;
            V cos_8 = _o253.cos_8;
            V sin_8 = _o253.sin_8;
            const LANES(court_ring_round_8_out) _o254 =
                LANES(court_ring_round_8)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, p_wire_radius);
            V near_8 = _o254.near_8;
            V omega_8 = _o254.omega_8;
            V around_8 = _o254.around_8;
            V tilted_8 = _o254.tilted_8;
            V pressed_8 = _o254.pressed_8;
            V force_8 = _o254.force_8;
            V cosine_9 = _o254.cosine_9;
            V sine_9 = _o254.sine_9;
            V climb_9 = _o254.climb_9;
            V along_9 = _o254.along_9;
            V turn_rate_9 = _o254.turn_rate_9;
            V cos_9 = _o254.cos_9;
            V sin_9 = _o254.sin_9;
            const LANES(court_ring_round_9_out) _o255 =
                LANES(court_ring_round_9)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V near_9 = _o255.near_9;
            V omega_9 = _o255.omega_9;
            V around_9 = _o255.around_9;
            V tilted_9 = _o255.tilted_9;
            V pressed_9 = _o255.pressed_9;
            V force_9 = _o255.force_9;
            V cosine_10 = _o255.cosine_10;
            V sine_10 = _o255.sine_10;
            V climb_10 = _o255.climb_10;
            V along_10 = _o255.along_10;
            V turn_rate_10 = _o255.turn_rate_10;
            V cos_10 = _o255.cos_10;
            V sin_10 = _o255.sin_10;
            const LANES(court_ring_round_10_out) _o256 =
                LANES(court_ring_round_10)(along_0, along_1, along_10, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V near_10 = _o256.near_10;
            V omega_10 = _o256.omega_10;
            V around_10 = _o256.around_10;
            V tilted_10 = _o256.tilted_10;
            V pressed_10 = _o256.pressed_10;
            V force_10 = _o256.force_10;
            V cosine_11 = _o256.cosine_11;
            V sine_11 = _o256.sine_11;
            V climb_11 = _o256.climb_11;
            V along_11 = _o256.along_11;
            V turn_rate_11 = _o256.turn_rate_11;
            V cos_11 = _o256.cos_11;
            V sin_11 = _o256.sin_11;
            const LANES(court_ring_round_11_out) _o257 =
                LANES(court_ring_round_11)(along_0, along_1, along_10, along_11, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_10, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_10, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_10, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_10, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V force_11 = _o257.force_11;
            V cosine_12 = _o257.cosine_12;
            V sine_12 = _o257.sine_12;
            V climb_12 = _o257.climb_12;
            V along_12 = _o257.along_12;
            V turn_rate_12 = _o257.turn_rate_12;
            V cos_12 = _o257.cos_12;
            V sin_12 = _o257.sin_12;
            const LANES(court_ring_round_pace_out) _o258 =
                LANES(court_ring_round_pace)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_12, cosine_0, cosine_12, force_0, force_1, force_10, force_11, force_2, force_3, force_4, force_5, force_6, force_7, force_8, force_9, p_gravity, omega_0, p_ring_radius, sin_0, sin_12, sine_0, sine_12, turn_rate_0, turn_rate_11, turn_rate_12, p_wire_radius);
            V stride = _o258.stride;
            V strongest = _o258.strongest;
            V fastest = _o258.fastest;
            V sway = _o258.sway;
            V force = _o258.force;
            V force_rate = _o258.force_rate;
            V force_bend = _o258.force_bend;
            V brace = _o258.brace;
            V vx_1 = _o258.vx_1;
            V vy_1 = _o258.vy_1;
            V vz_1 = _o258.vz_1;
            const LANES(court_leaving_force_out) _o259 =
                LANES(court_leaving_force)(p_ball_radius, brace, K(INFINITY), fastest, force, force_bend, force_rate, p_gravity, per_reach, K(0.0), stride, K(0.0), vx, vx_1, vy, vy_1, vz, vz_1, which);
            stride = _o259.stride;
            which = _o259.which;
            M rests = _o259.rests;
            const LANES(court_backboard_beside_out) _o260 =
                LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            V gap = _o260.gap;
            V nearing = _o260.nearing;
            V dent = _o260.dent;
            const LANES(court_beside_body_out) _o261 =
                LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(1.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
            stride = _o261.stride;
            which = _o261.which;
            const LANES(court_bridge_beside_out) _o262 =
                LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o262.gap;
            nearing = _o262.nearing;
            dent = _o262.dent;
            const LANES(court_beside_body_out) _o263 =
                LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(2.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
            stride = _o263.stride;
            which = _o263.which;
            const LANES(court_end_beside_out) _o264 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o264.gap;
            nearing = _o264.nearing;
            dent = _o264.dent;
            const LANES(court_beside_gate_out) _o265 =
                LANES(court_beside_gate)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(3.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
            stride = _o265.stride;
            which = _o265.which;
            const LANES(court_beside_time_out) _o266 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o266.stride;
            which = _o266.which;
            const LANES(court_passing_from_out) _o267 =
                LANES(court_passing_from)(z);
            M over = _o267.over;
            const LANES(court_alone_out) _o268 =
                LANES(court_alone)();
            V berth = _o268.nearest;
            const LANES(court_leaps_out) _o269 =
                LANES(court_leaps)(stride);
            V forth = _o269.forth;
            V back = _o269.back;
            const LANES(court_backboard_around_out) _o270 =
                LANES(court_backboard_around)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            gap = _o270.gap;
            nearing = _o270.nearing;
            const LANES(court_cleared_out) _o271 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o271.berth;
            const LANES(court_bridge_around_out) _o272 =
                LANES(court_bridge_around)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o272.gap;
            nearing = _o272.nearing;
            const LANES(court_cleared_out) _o273 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o273.berth;
            const LANES(court_end_around_out) _o274 =
                LANES(court_end_around)(p_end_depth, vz, z);
            gap = _o274.gap;
            nearing = _o274.nearing;
            const LANES(court_cleared_out) _o275 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o275.berth;
            const LANES(court_ring_round_moved_out) _o276 =
                LANES(court_ring_round_moved)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_12, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_12, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_12, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_12, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, stride, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_12, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            x = _o276.x;
            y = _o276.y;
            z = _o276.z;
            vx = _o276.vx;
            vy = _o276.vy;
            vz = _o276.vz;
            wx = _o276.wx;
            wy = _o276.wy;
            wz = _o276.wz;
            V climb = _o276.climb;
            const LANES(court_passing_in_contact_out) _o277 =
                LANES(court_passing_in_contact)(over, p_ring_radius, through, x, y, z);
            through = _o277.through;
            const LANES(court_backboard_around_out) _o278 =
                LANES(court_backboard_around)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            gap = _o278.gap;
            nearing = _o278.nearing;
            const LANES(court_cleared_out) _o279 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o279.berth;
            const LANES(court_bridge_around_out) _o280 =
                LANES(court_bridge_around)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o280.gap;
            nearing = _o280.nearing;
            const LANES(court_cleared_out) _o281 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o281.berth;
            const LANES(court_end_around_out) _o282 =
                LANES(court_end_around)(p_end_depth, vz, z);
            gap = _o282.gap;
            nearing = _o282.nearing;
            const LANES(court_cleared_out) _o283 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o283.berth;
            const LANES(court_ring_swung_out) _o284 =
                LANES(court_ring_swung)(p_ball_radius, berth, circled, climb, climb_0, K(INFINITY), fastest, force, force_bend, force_rate, p_gravity, K(0.0), stride, sway, K(0.0), which, p_wire_radius);
            circled = _o284.circled;
            M endless = _o284.endless;
            const LANES(court_for_ever_out) _o285 =
                LANES(court_for_ever)(endless, which);
            which = _o285.which;
            const LANES(court_rolled_on_out) _o286 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o286.clock;
            circling = _o286.rolling;
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
        const LANES(court_rejoined_out) _o287 =
            LANES(court_rejoined)(circling, rolling);
        rolling = _o287.rolling;
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
        const LANES(court_ring_normal_out) _o391 =
            LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
        V nx = _o391.nx;
        V ny = _o391.ny;
        V nz = _o391.nz;
        const LANES(court_here_out) _o392 =
            LANES(court_here)(K(1.0), which);
        M here = _o392.here;
        const M _m393 = lanes_both(rows, here);
        {
            const LANES(court_backboard_normal_out) _o394 =
                LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
            nx = lanes_select(_m393, _o394.nx, nx);
            ny = lanes_select(_m393, _o394.ny, ny);
            nz = lanes_select(_m393, _o394.nz, nz);
        }
        const LANES(court_here_out) _o395 =
            LANES(court_here)(K(2.0), which);
        here = _o395.here;
        const M _m396 = lanes_both(rows, here);
        {
            const LANES(court_bridge_normal_out) _o397 =
                LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
            nx = lanes_select(_m396, _o397.nx, nx);
            ny = lanes_select(_m396, _o397.ny, ny);
            nz = lanes_select(_m396, _o397.nz, nz);
        }
        const LANES(court_nearly_out) _o398 =
            LANES(court_nearly)(p_ball_radius, p_gravity, nx, ny, nz, vx, vy, vz);
        M nearly = _o398.nearly;
        const LANES(court_gripped_out) _o399 =
            LANES(court_gripped)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
        V rolled_x = _o399.rolled_x;
        V rolled_y = _o399.rolled_y;
        V rolled_z = _o399.rolled_z;
        V slip = _o399.slip;
        V bounce = _o399.bounce;
        const LANES(court_here_out) _o400 =
            LANES(court_here)(K(0.0), which);
        here = _o400.here;
        const M _m401 = lanes_both(rows, here);
        if (lanes_any(_m401)) {
            const LANES(court_ring_turning_out) _o402 =
                LANES(court_ring_turning)(p_ball_radius, p_ring_radius, rolled_x, rolled_y, rolled_z, p_wire_radius, x, y);
            V turning_x = _o402.turning_x;
            V turning_y = _o402.turning_y;
            V turning_z = _o402.turning_z;
            const LANES(court_pressed_on_out) _o403 =
                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
            V press = _o403.press;
            V weight = _o403.weight;
            V drag = _o403.drag;
            V thrust_x = _o403.thrust_x;
            V thrust_y = _o403.thrust_y;
            V thrust_z = _o403.thrust_z;
            const LANES(court_alone_out) _o404 =
                LANES(court_alone)();
            V nearest = _o404.nearest;
            V wedge = _o404.wedge;
            const LANES(court_backboard_closing_out) _o405 =
                LANES(court_backboard_closing)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z);
            V gap = _o405.gap;
            V nearing = _o405.nearing;
            V swerve = _o405.swerve;
            V facing = _o405.facing;
            const LANES(court_neared_body_out) _o406 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o406.nearest;
            wedge = _o406.wedge;
            const LANES(court_bridge_closing_out) _o407 =
                LANES(court_bridge_closing)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
            gap = _o407.gap;
            nearing = _o407.nearing;
            swerve = _o407.swerve;
            facing = _o407.facing;
            const LANES(court_neared_body_out) _o408 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o408.nearest;
            wedge = _o408.wedge;
            const LANES(court_end_beside_out) _o409 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o409.gap;
            const LANES(court_neared_out) _o410 =
                LANES(court_neared)(gap, nearest);
            nearest = _o410.nearest;
            const LANES(court_ring_parting_out) _o411 =
                LANES(court_ring_parting)(p_gravity, p_ring_radius, vx, vy, vz, x, y, z);
            V lift = _o411.lift;
            const LANES(court_ring_impact_settling_out) _o412 =
                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_ring_friction, p_ring_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz);
            M settles = _o412.settles;
            M lodges = _o412.lodges;
            M slides = _o412.slides;
            M parts = _o412.parts;
            M unsure = _o412.unsure;
            const LANES(court_settled_out) _o413 =
                LANES(court_settled)(K(0.0), lodges, nearly, outcome, parts, settles, slides, K(0.0), unsure);
            mode = lanes_select(_m401, _o413.mode, mode);
            held = lanes_select(_m401, _o413.held, held);
            outcome = lanes_select(_m401, _o413.outcome, outcome);
            slip_left = lanes_select(_m401, _o413.slip_left, slip_left);
        }
        const LANES(court_here_out) _o414 =
            LANES(court_here)(K(1.0), which);
        here = _o414.here;
        const M _m415 = lanes_both(rows, here);
        if (lanes_any(_m415)) {
            const LANES(court_backboard_turning_out) _o416 =
                LANES(court_backboard_turning)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, rolled_x, rolled_y, rolled_z, x, y, z);
            V turning_x = _o416.turning_x;
            V turning_y = _o416.turning_y;
            V turning_z = _o416.turning_z;
            const LANES(court_pressed_on_out) _o417 =
                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
            V press = _o417.press;
            V weight = _o417.weight;
            V drag = _o417.drag;
            V thrust_x = _o417.thrust_x;
            V thrust_y = _o417.thrust_y;
            V thrust_z = _o417.thrust_z;
            const LANES(court_alone_out) _o418 =
                LANES(court_alone)();
            V nearest = _o418.nearest;
            V wedge = _o418.wedge;
            const LANES(court_ring_closing_out) _o419 =
                LANES(court_ring_closing)(p_ball_radius, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
            V gap = _o419.gap;
            V nearing = _o419.nearing;
            V swerve = _o419.swerve;
            V facing = _o419.facing;
            const LANES(court_neared_body_out) _o420 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o420.nearest;
            wedge = _o420.wedge;
            const LANES(court_bridge_closing_out) _o421 =
                LANES(court_bridge_closing)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
            gap = _o421.gap;
            nearing = _o421.nearing;
            swerve = _o421.swerve;
            facing = _o421.facing;
            const LANES(court_neared_body_out) _o422 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o422.nearest;
            wedge = _o422.wedge;
            const LANES(court_end_beside_out) _o423 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o423.gap;
            const LANES(court_neared_out) _o424 =
                LANES(court_neared)(gap, nearest);
            nearest = _o424.nearest;
            const LANES(court_backboard_parting_out) _o425 =
                LANES(court_backboard_parting)(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, vx, vy, vz, x, y, z);
            V lift = _o425.lift;
            const LANES(court_ring_impact_settling_out) _o426 =
                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_backboard_friction, p_backboard_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz);
            M settles = _o426.settles;
            M lodges = _o426.lodges;
            M slides = _o426.slides;
            M parts = _o426.parts;
            M unsure = _o426.unsure;
            const LANES(court_settled_out) _o427 =
                LANES(court_settled)(K(1.0), lodges, nearly, outcome, parts, settles, slides, K(0.0), unsure);
            mode = lanes_select(_m415, _o427.mode, mode);
            held = lanes_select(_m415, _o427.held, held);
            outcome = lanes_select(_m415, _o427.outcome, outcome);
            slip_left = lanes_select(_m415, _o427.slip_left, slip_left);
        }
        const LANES(court_here_out) _o428 =
            LANES(court_here)(K(2.0), which);
        here = _o428.here;
        const M _m429 = lanes_both(rows, here);
        if (lanes_any(_m429)) {
            const LANES(court_bridge_turning_out) _o430 =
                LANES(court_bridge_turning)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, rolled_x, rolled_y, rolled_z, p_wire_radius, x, y, z);
            V turning_x = _o430.turning_x;
            V turning_y = _o430.turning_y;
            V turning_z = _o430.turning_z;
            const LANES(court_pressed_on_out) _o431 =
                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
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
            const LANES(court_ring_closing_out) _o433 =
                LANES(court_ring_closing)(p_ball_radius, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
            V gap = _o433.gap;
            V nearing = _o433.nearing;
            V swerve = _o433.swerve;
            V facing = _o433.facing;
            const LANES(court_neared_body_out) _o434 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o434.nearest;
            wedge = _o434.wedge;
            const LANES(court_backboard_closing_out) _o435 =
                LANES(court_backboard_closing)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z);
            gap = _o435.gap;
            nearing = _o435.nearing;
            swerve = _o435.swerve;
            facing = _o435.facing;
            const LANES(court_neared_body_out) _o436 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o436.nearest;
            wedge = _o436.wedge;
            const LANES(court_end_beside_out) _o437 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o437.gap;
            const LANES(court_neared_out) _o438 =
                LANES(court_neared)(gap, nearest);
            nearest = _o438.nearest;
            const LANES(court_bridge_parting_out) _o439 =
                LANES(court_bridge_parting)(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            V lift = _o439.lift;
            const LANES(court_ring_impact_settling_out) _o440 =
                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_bridge_friction, p_bridge_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz);
            M settles = _o440.settles;
            M lodges = _o440.lodges;
            M slides = _o440.slides;
            M parts = _o440.parts;
            M unsure = _o440.unsure;
            const LANES(court_settled_out) _o441 =
                LANES(court_settled)(K(2.0), lodges, nearly, outcome, parts, settles, slides, K(0.0), unsure);
            mode = lanes_select(_m429, _o441.mode, mode);
            held = lanes_select(_m429, _o441.held, held);
            outcome = lanes_select(_m429, _o441.outcome, outcome);
            slip_left = lanes_select(_m429, _o441.slip_left, slip_left);
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
    size_t begun = 0, shots = 0;

    lists->waiting = 0;
    if (job->shots == 0)
        return;
    if (recording)
        memset(job->results->event_counts, 0, job->shots * sizeof(int32_t));
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
        int following = shots == 0;
        if (lists->waiting + LANES_WIDTH > LANES_SHOTS || (shots == 0 && begun == job->shots)) {
            shots += LANES(court_plain_resume)(lists, shots, job);
            following = 0;
        }
        const size_t fresh = shots;
        if (begun < job->shots && shots < LANES_SHOTS) {
            const size_t room = LANES_SHOTS - shots, left = job->shots - begun;
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
            LANES(court_ahead)(job, begun + i);
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
            const LANES(court_meeting_plane_out) _o12 =
                LANES(court_meeting_plane)(bend, rate, time);
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
            const LANES(court_swept_out) _o58 =
                LANES(court_swept)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), K(0.0), pad, p_gravity);
            V middle_x = _o58.middle_x;
            V middle_y = _o58.middle_y;
            V middle_z = _o58.middle_z;
            V reach_x = _o58.reach_x;
            V reach_y = _o58.reach_y;
            V reach_z = _o58.reach_z;
            const LANES(court_backboard_near_out) _o59 =
                LANES(court_backboard_near)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
            M reachable = _o59.near;
            const LANES(court_reachable_in_flight_out) _o60 =
                LANES(court_reachable_in_flight)(kept, reachable);
            reachable = _o60.reachable;
            lanes_store(lists->middle_x + i, middle_x);
            lanes_store(lists->middle_y + i, middle_y);
            lanes_store(lists->middle_z + i, middle_z);
            lanes_store(lists->reach_x + i, reach_x);
            lanes_store(lists->reach_y + i, reach_y);
            lanes_store(lists->reach_z + i, reach_z);
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
            V middle_x = lanes_load(lists->middle_x + i);
            V middle_y = lanes_load(lists->middle_y + i);
            V middle_z = lanes_load(lists->middle_z + i);
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_bridge_depth = lanes_load(lists->p_bridge_depth + (i & varying));
            const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
            const V p_wire_radius = lanes_load(lists->p_wire_radius + (i & varying));
            V reach_x = lanes_load(lists->reach_x + i);
            V reach_y = lanes_load(lists->reach_y + i);
            V reach_z = lanes_load(lists->reach_z + i);
            V speed = lanes_load(lists->speed + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V when = lanes_load(lists->when + i);
            V which = lanes_load(lists->which + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const LANES(court_bridge_near_out) _o100 =
                LANES(court_bridge_near)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
            M reachable = _o100.near;
            const LANES(court_reachable_in_flight_out) _o101 =
                LANES(court_reachable_in_flight)(kept, reachable);
            reachable = _o101.reachable;
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
            const LANES(court_horizon_out) _o102 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o102.horizon;
            const LANES(court_bridge_prepare_out) _o103 =
                LANES(court_bridge_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V low0 = _o103.low0;
            V high0 = _o103.high0;
            V low1 = _o103.low1;
            V high1 = _o103.high1;
            V ceiling = _o103.ceiling;
            V latest = _o103.latest;
            const LANES(court_beginning_out) _o104 =
                LANES(court_beginning)();
            V share = _o104.share;
            V arrival = _o104.arrival;
            M certain = _o104.certain;
            const LANES(court_allowance_out) _o105 =
                LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
            V position_level = _o105.position_level;
            V velocity_level = _o105.velocity_level;
            const LANES(court_bridge_margins_out) _o106 =
                LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V flat = _o106.margin;
            V tilt = _o106.leaving_margin;
            V rate_slack = _o106.rate_margin;
            const LANES(court_bridge_enter_out) _o107 =
                LANES(court_bridge_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o107.t;
            V end = _o107.end;
            M searching = _o107.searching;
            const M _m108 = lanes_both(rows, searching);
            if (lanes_any(_m108)) {
                const LANES(court_nearby_out) _o109 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o109.leaving;
                V margin = _o109.margin;
                const LANES(court_bridge_advance_out) _o110 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
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
                const M _m112 = lanes_both(_m108, vague);
                if (lanes_any(_m112)) {
                    const LANES(court_finer_out) _o113 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m112, _o113.share, share);
                    const LANES(court_allowance_out) _o114 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
                    V position_level = _o114.position_level;
                    V velocity_level = _o114.velocity_level;
                    const LANES(court_bridge_margins_out) _o115 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                    flat = lanes_select(_m112, _o115.margin, flat);
                    tilt = lanes_select(_m112, _o115.leaving_margin, tilt);
                    rate_slack = lanes_select(_m112, _o115.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o116 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = lanes_select(_m108, _o116.arrival, arrival);
                certain = lanes_choose(_m108, _o116.certain, certain);
                M exhausted = _o116.exhausted;
                searching = lanes_choose(_m108, _o116.searching, searching);
                t = lanes_select(_m108, _o116.t, t);
                const M _m117 = lanes_both(_m108, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o118 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m117, _o118.t, t);
                    end = lanes_select(_m117, _o118.end, end);
                    searching = lanes_choose(_m117, _o118.searching, searching);
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
                const LANES(court_nearby_out) _o119 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o119.leaving;
                V margin = _o119.margin;
                const LANES(court_bridge_advance_out) _o120 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V gap = _o120.gap;
                V rate = _o120.rate;
                V bend = _o120.bend;
                V step = _o120.step;
                V next = _o120.next;
                V clearance = _o120.clearance;
                const LANES(court_struck_or_still_out) _o121 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o121.hit;
                M sure = _o121.sure;
                M vague = _o121.vague;
                const M _m122 = lanes_both(active, vague);
                if (lanes_any(_m122)) {
                    const LANES(court_finer_out) _o123 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m122, _o123.share, share);
                    const LANES(court_allowance_out) _o124 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
                    V position_level = _o124.position_level;
                    V velocity_level = _o124.velocity_level;
                    const LANES(court_bridge_margins_out) _o125 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                    flat = lanes_select(_m122, _o125.margin, flat);
                    tilt = lanes_select(_m122, _o125.leaving_margin, tilt);
                    rate_slack = lanes_select(_m122, _o125.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o126 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o126.arrival;
                certain = _o126.certain;
                M exhausted = _o126.exhausted;
                searching = _o126.searching;
                t = _o126.t;
                const M _m127 = lanes_both(active, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o128 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m127, _o128.t, t);
                    end = lanes_select(_m127, _o128.end, end);
                    searching = lanes_choose(_m127, _o128.searching, searching);
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
            const LANES(court_found_out) _o129 =
                LANES(court_found)(arrival);
            M arrives = _o129.arrives;
            M refining = _o129.refining;
            const LANES(court_nearby_out) _o130 =
                LANES(court_nearby)(flat, K(2.0), last, arrival, tilt);
            V leaving = _o130.leaving;
            const M _m131 = lanes_both(rows, refining);
            if (lanes_any(_m131)) {
                const LANES(court_bridge_refine_out) _o132 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V refined = _o132.time;
                V gap = _o132.gap;
                V rate = _o132.rate;
                const LANES(court_polished_out) _o133 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m131, _o133.arrival, arrival);
                refining = lanes_choose(_m131, _o133.refining, refining);
            }
            const M _m134 = lanes_both(rows, refining);
            if (lanes_any(_m134)) {
                const LANES(court_bridge_refine_out) _o135 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V refined = _o135.time;
                V gap = _o135.gap;
                V rate = _o135.rate;
                const LANES(court_polished_out) _o136 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m134, _o136.arrival, arrival);
                refining = lanes_choose(_m134, _o136.refining, refining);
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
                const LANES(court_bridge_refine_out) _o137 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V refined = _o137.time;
                V gap = _o137.gap;
                V rate = _o137.rate;
                const LANES(court_polished_out) _o138 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o138.arrival;
                refining = _o138.refining;
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
            const LANES(court_landed_out) _o139 =
                LANES(court_landed)(arrival);
            V time = _o139.time;
            const LANES(court_sooner_out) _o140 =
                LANES(court_sooner)(arrives, K(2.0), time, when, which);
            when = _o140.when;
            which = _o140.which;
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
            const M _m141 = lanes_both(rows, limited);
            if (lanes_any(_m141)) {
                const LANES(court_expiry_out) _o142 =
                    LANES(court_expiry)(clock, K(INFINITY), K(0.0), time_error, time_limit, when, which);
                V time = _o142.time;
                M arrives = _o142.arrives;
                const LANES(court_sooner_out) _o143 =
                    LANES(court_sooner)(arrives, K(4.0), time, when, which);
                when = lanes_select(_m141, _o143.when, when);
                which = lanes_select(_m141, _o143.which, which);
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
            const LANES(court_departed_out) _o347 =
                LANES(court_departed)(K(3.0), which);
            M moves = _o347.moves;
            M ends = _o347.ends;
            M touches = _o347.touches;
            V reached = _o347.reached;
            const LANES(court_body_of_out) _o348 =
                LANES(court_body_of)(which);
            V body = _o348.body;
            const M _m349 = lanes_both(rows, moves);
            if (lanes_any(_m349)) {
                const LANES(court_passing_out) _o350 =
                    LANES(court_passing)(through, when, x, y, z, vx, vy, vz, p_ring_radius, p_gravity);
                through = lanes_select(_m349, _o350.through, through);
                const LANES(court_flight_out) _o351 =
                    LANES(court_flight)(when, x, y, z, vx, vy, vz, p_gravity);
                x = lanes_select(_m349, _o351.x, x);
                y = lanes_select(_m349, _o351.y, y);
                z = lanes_select(_m349, _o351.z, z);
                vx = lanes_select(_m349, _o351.vx, vx);
                vy = lanes_select(_m349, _o351.vy, vy);
                vz = lanes_select(_m349, _o351.vz, vz);
                const LANES(court_ticked_out) _o352 =
                    LANES(court_ticked)(clock, when);
                clock = lanes_select(_m349, _o352.clock, clock);
            }
            const M _m353 = lanes_both(rows, limited);
            if (lanes_any(_m353)) {
                const LANES(court_expired_out) _o354 =
                    LANES(court_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m353, _o354.clock, clock);
                body = lanes_select(_m353, _o354.body, body);
                reached = lanes_select(_m353, _o354.reached, reached);
                ends = lanes_choose(_m353, _o354.ends, ends);
            }
            const M _m355 = lanes_both(rows, kept);
            if (lanes_any(_m355)) {
                const LANES(court_kept_on_out) _o356 =
                    LANES(court_kept_on)(began, body, clock, K(INFINITY), ends, held, last, reached, rests, rolling, rolls, which);
                body = lanes_select(_m355, _o356.body, body);
                reached = lanes_select(_m355, _o356.reached, reached);
                ends = lanes_choose(_m355, _o356.ends, ends);
                last = lanes_select(_m355, _o356.last, last);
                mode = lanes_select(_m355, _o356.mode, mode);
                held = lanes_select(_m355, _o356.held, held);
                rolls = lanes_select(_m355, _o356.rolls, rolls);
            }
            const LANES(court_here_out) _o357 =
                LANES(court_here)(K(3.0), which);
            M here = _o357.here;
            const M _m358 = lanes_both(rows, here);
            {
                const LANES(court_end_bounds_out) _o359 =
                    LANES(court_end_bounds)(x, y, p_ring_radius);
                V g0 = _o359.g0;
                const LANES(court_end_reached_out) _o360 =
                    LANES(court_end_reached)(g0, through);
                reached = lanes_select(_m358, _o360.reached, reached);
            }
            const LANES(court_accounted_out) _o361 =
                LANES(court_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o361.contacts;
            V outcome = _o361.outcome;
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
            const LANES(court_meeting_out) _o362 =
                LANES(court_meeting)(K(0.0), ends, touches);
            M meeting = _o362.meeting;
            const LANES(court_unslowed_out) _o363 =
                LANES(court_unslowed)();
            M slow = _o363.slow;
            const M _m364 = lanes_both(rows, meeting);
            if (lanes_any(_m364)) {
                const LANES(court_end_normal_out) _o365 =
                    LANES(court_end_normal)();
                V nx = _o365.nx;
                V ny = _o365.ny;
                V nz = _o365.nz;
                const LANES(court_here_out) _o366 =
                    LANES(court_here)(K(0.0), which);
                M here = _o366.here;
                const M _m367 = lanes_both(_m364, here);
                {
                    const LANES(court_ring_normal_out) _o368 =
                        LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m367, _o368.nx, nx);
                    ny = lanes_select(_m367, _o368.ny, ny);
                    nz = lanes_select(_m367, _o368.nz, nz);
                    const LANES(court_counted_out) _o369 =
                        LANES(court_counted)(count_0);
                    count_0 = lanes_select(_m367, _o369.count, count_0);
                }
                const LANES(court_here_out) _o370 =
                    LANES(court_here)(K(1.0), which);
                here = _o370.here;
                const M _m371 = lanes_both(_m364, here);
                {
                    const LANES(court_backboard_normal_out) _o372 =
                        LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m371, _o372.nx, nx);
                    ny = lanes_select(_m371, _o372.ny, ny);
                    nz = lanes_select(_m371, _o372.nz, nz);
                    const LANES(court_counted_out) _o373 =
                        LANES(court_counted)(count_1);
                    count_1 = lanes_select(_m371, _o373.count, count_1);
                }
                const LANES(court_here_out) _o374 =
                    LANES(court_here)(K(2.0), which);
                here = _o374.here;
                const M _m375 = lanes_both(_m364, here);
                {
                    const LANES(court_bridge_normal_out) _o376 =
                        LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m375, _o376.nx, nx);
                    ny = lanes_select(_m375, _o376.ny, ny);
                    nz = lanes_select(_m375, _o376.nz, nz);
                    const LANES(court_counted_out) _o377 =
                        LANES(court_counted)(count_2);
                    count_2 = lanes_select(_m375, _o377.count, count_2);
                }
                const LANES(court_untaken_out) _o378 =
                    LANES(court_untaken)();
                M struck_0 = _o378.mine;
                const LANES(court_ring_impact_taken_out) _o379 =
                    LANES(court_ring_impact_taken)(p_ring_restitution, p_ring_friction);
                V its_0_ring_impact = _o379.its_0;
                V its_1_ring_impact = _o379.its_1;
                {
                    const double *const _t381[][2] = {
                        {lists->p_ring_friction, lists->p_ring_restitution},
                        {lists->p_backboard_friction, lists->p_backboard_restitution},
                        {lists->p_bridge_friction, lists->p_bridge_restitution},
                    };
                    static const double _t382[][1] = {
                        {0.0},
                        {1.0},
                        {2.0},
                    };
                    for (size_t _k380 = 0; _k380 < 3; _k380++) {
                        const V own_1 = lanes_load(_t381[_k380][0] + (i & varying));
                        const V own_2 = lanes_load(_t381[_k380][1] + (i & varying));
                        const V own_index = K(_t382[_k380][0]);
                        const LANES(court_here_out) _o383 =
                            LANES(court_here)(own_index, which);
                        M here = _o383.here;
                        const M _m384 = lanes_both(_m364, here);
                        if (lanes_any(_m384)) {
                            const LANES(court_ring_impact_taken_out) _o385 =
                                LANES(court_ring_impact_taken)(own_2, own_1);
                            struck_0 = lanes_choose(_m384, _o385.mine, struck_0);
                            its_0_ring_impact = lanes_select(_m384, _o385.its_0, its_0_ring_impact);
                            its_1_ring_impact = lanes_select(_m384, _o385.its_1, its_1_ring_impact);
                        }
                    }
                }
                const M _m386 = lanes_both(_m364, struck_0);
                if (lanes_any(_m386)) {
                    const LANES(court_ring_impact_out) _o387 =
                        LANES(court_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, its_0_ring_impact, its_1_ring_impact, p_tangential_restitution, p_restitution_speed);
                    vx = lanes_select(_m386, _o387.vx, vx);
                    vy = lanes_select(_m386, _o387.vy, vy);
                    vz = lanes_select(_m386, _o387.vz, vz);
                    wx = lanes_select(_m386, _o387.wx, wx);
                    wy = lanes_select(_m386, _o387.wy, wy);
                    wz = lanes_select(_m386, _o387.wz, wz);
                }
                const M _m388 = lanes_both(_m364, touches);
                {
                    const LANES(court_touched_out) _o389 =
                        LANES(court_touched)(body, first, which);
                    first = lanes_select(_m388, _o389.first, first);
                    last = lanes_select(_m388, _o389.last, last);
                    const LANES(court_slowed_out) _o390 =
                        LANES(court_slowed)(p_ball_radius, p_gravity, nx, ny, nz, K(0.0), vx, vy, vz);
                    slow = lanes_choose(_m388, _o390.slow, slow);
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
    LANES(court_column) middle_x;
    LANES(court_column) middle_y;
    LANES(court_column) middle_z;
    LANES(court_column) reach_x;
    LANES(court_column) reach_y;
    LANES(court_column) reach_z;
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
        const LANES(court_error_bounds_out) _o399 =
            LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
        V position_error = _o399.position_error;
        V velocity_error = _o399.velocity_error;
        const LANES(court_holding_out) _o400 =
            LANES(court_holding)(held, K(0.0));
        M here = _o400.here;
        const M _m401 = lanes_both(rows, here);
        if (lanes_any(_m401)) {
            const LANES(court_ring_tube_out) _o402 =
                LANES(court_ring_tube)(p_ball_radius, p_wire_radius);
            per_reach = lanes_select(_m401, _o402.per_reach, per_reach);
            const LANES(court_ring_parting_out) _o403 =
                LANES(court_ring_parting)(p_gravity, p_ring_radius, vx, vy, vz, x, y, z);
            lift = lanes_select(_m401, _o403.lift, lift);
            surge = lanes_select(_m401, _o403.surge, surge);
            snap = lanes_select(_m401, _o403.snap, snap);
        }
        const LANES(court_holding_out) _o404 =
            LANES(court_holding)(held, K(1.0));
        here = _o404.here;
        const M _m405 = lanes_both(rows, here);
        if (lanes_any(_m405)) {
            const LANES(court_backboard_tube_out) _o406 =
                LANES(court_backboard_tube)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            per_reach = lanes_select(_m405, _o406.per_reach, per_reach);
            const LANES(court_backboard_parting_out) _o407 =
                LANES(court_backboard_parting)(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, vx, vy, vz, x, y, z);
            lift = lanes_select(_m405, _o407.lift, lift);
            surge = lanes_select(_m405, _o407.surge, surge);
            snap = lanes_select(_m405, _o407.snap, snap);
        }
        const LANES(court_holding_out) _o408 =
            LANES(court_holding)(held, K(2.0));
        here = _o408.here;
        const M _m409 = lanes_both(rows, here);
        if (lanes_any(_m409)) {
            const LANES(court_bridge_tube_out) _o410 =
                LANES(court_bridge_tube)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            per_reach = lanes_select(_m409, _o410.per_reach, per_reach);
            const LANES(court_bridge_parting_out) _o411 =
                LANES(court_bridge_parting)(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            lift = lanes_select(_m409, _o411.lift, lift);
            surge = lanes_select(_m409, _o411.surge, surge);
            snap = lanes_select(_m409, _o411.snap, snap);
        }
        const LANES(court_unmet_out) _o412 =
            LANES(court_unmet)();
        V spare = _o412.spare;
        const LANES(court_beside_out) _o413 =
            LANES(court_beside)(held, K(0.0));
        M beside = _o413.beside;
        const M _m414 = lanes_both(rows, beside);
        if (lanes_any(_m414)) {
            const LANES(court_ring_beside_out) _o415 =
                LANES(court_ring_beside)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            V gap = _o415.gap;
            V nearing = _o415.nearing;
            V dent = _o415.dent;
            const LANES(court_spared_out) _o416 =
                LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
            spare = lanes_select(_m414, _o416.spare, spare);
        }
        const LANES(court_beside_out) _o417 =
            LANES(court_beside)(held, K(1.0));
        beside = _o417.beside;
        const M _m418 = lanes_both(rows, beside);
        if (lanes_any(_m418)) {
            const LANES(court_backboard_beside_out) _o419 =
                LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            V gap = _o419.gap;
            V nearing = _o419.nearing;
            V dent = _o419.dent;
            const LANES(court_spared_out) _o420 =
                LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
            spare = lanes_select(_m418, _o420.spare, spare);
        }
        const LANES(court_beside_out) _o421 =
            LANES(court_beside)(held, K(2.0));
        beside = _o421.beside;
        const M _m422 = lanes_both(rows, beside);
        if (lanes_any(_m422)) {
            const LANES(court_bridge_beside_out) _o423 =
                LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            V gap = _o423.gap;
            V nearing = _o423.nearing;
            V dent = _o423.dent;
            const LANES(court_spared_out) _o424 =
                LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
            spare = lanes_select(_m422, _o424.spare, spare);
        }
        const LANES(court_beside_out) _o425 =
            LANES(court_beside)(held, K(3.0));
        beside = _o425.beside;
        const M _m426 = lanes_both(rows, beside);
        if (lanes_any(_m426)) {
            const LANES(court_end_beside_out) _o427 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            V gap = _o427.gap;
            V nearing = _o427.nearing;
            V dent = _o427.dent;
            const LANES(court_spared_out) _o428 =
                LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
            spare = lanes_select(_m426, _o428.spare, spare);
        }
        const LANES(court_holding_out) _o429 =
            LANES(court_holding)(held, K(1.0));
        here = _o429.here;
        const M _m430 = lanes_both(rows, here);
        if (lanes_any(_m430)) {
            const LANES(court_backboard_seam0_out) _o431 =
                LANES(court_backboard_seam0)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
            V gap = _o431.gap;
            V nearing = _o431.nearing;
            V near = _o431.near;
            const LANES(court_spared_seam_out) _o432 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m430, _o432.spare, spare);
            const LANES(court_backboard_seam1_out) _o433 =
                LANES(court_backboard_seam1)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
            gap = _o433.gap;
            nearing = _o433.nearing;
            near = _o433.near;
            const LANES(court_spared_seam_out) _o434 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m430, _o434.spare, spare);
            const LANES(court_backboard_seam2_out) _o435 =
                LANES(court_backboard_seam2)(p_ball_radius, p_board_half_width, vy, y);
            gap = _o435.gap;
            nearing = _o435.nearing;
            near = _o435.near;
            const LANES(court_spared_seam_out) _o436 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m430, _o436.spare, spare);
            const LANES(court_backboard_seam3_out) _o437 =
                LANES(court_backboard_seam3)(p_ball_radius, p_board_half_width, vy, y);
            gap = _o437.gap;
            nearing = _o437.nearing;
            near = _o437.near;
            const LANES(court_spared_seam_out) _o438 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m430, _o438.spare, spare);
            const LANES(court_backboard_seam4_out) _o439 =
                LANES(court_backboard_seam4)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
            gap = _o439.gap;
            nearing = _o439.nearing;
            near = _o439.near;
            const LANES(court_spared_seam_out) _o440 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m430, _o440.spare, spare);
            const LANES(court_backboard_seam5_out) _o441 =
                LANES(court_backboard_seam5)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
            gap = _o441.gap;
            nearing = _o441.nearing;
            near = _o441.near;
            const LANES(court_spared_seam_out) _o442 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m430, _o442.spare, spare);
        }
        const LANES(court_holding_out) _o443 =
            LANES(court_holding)(held, K(2.0));
        here = _o443.here;
        const M _m444 = lanes_both(rows, here);
        if (lanes_any(_m444)) {
            const LANES(court_bridge_seam0_out) _o445 =
                LANES(court_bridge_seam0)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
            V gap = _o445.gap;
            V nearing = _o445.nearing;
            V near = _o445.near;
            const LANES(court_spared_seam_out) _o446 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m444, _o446.spare, spare);
            const LANES(court_bridge_seam1_out) _o447 =
                LANES(court_bridge_seam1)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
            gap = _o447.gap;
            nearing = _o447.nearing;
            near = _o447.near;
            const LANES(court_spared_seam_out) _o448 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m444, _o448.spare, spare);
            const LANES(court_bridge_seam2_out) _o449 =
                LANES(court_bridge_seam2)(p_ball_radius, p_bridge_half_width, vy, y);
            gap = _o449.gap;
            nearing = _o449.nearing;
            near = _o449.near;
            const LANES(court_spared_seam_out) _o450 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m444, _o450.spare, spare);
            const LANES(court_bridge_seam3_out) _o451 =
                LANES(court_bridge_seam3)(p_ball_radius, p_bridge_half_width, vy, y);
            gap = _o451.gap;
            nearing = _o451.nearing;
            near = _o451.near;
            const LANES(court_spared_seam_out) _o452 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m444, _o452.spare, spare);
            const LANES(court_bridge_seam4_out) _o453 =
                LANES(court_bridge_seam4)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
            gap = _o453.gap;
            nearing = _o453.nearing;
            near = _o453.near;
            const LANES(court_spared_seam_out) _o454 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m444, _o454.spare, spare);
            const LANES(court_bridge_seam5_out) _o455 =
                LANES(court_bridge_seam5)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
            gap = _o455.gap;
            nearing = _o455.nearing;
            near = _o455.near;
            const LANES(court_spared_seam_out) _o456 =
                LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
            spare = lanes_select(_m444, _o456.spare, spare);
        }
        const LANES(court_parted_out) _o457 =
            LANES(court_parted)(doubt, p_gravity, lift, per_reach, position_error, snap, spare, surge, velocity_error, vx, vy, vz);
        V when = _o457.when;
        doubt = _o457.doubt;
        const LANES(court_hopping_out) _o458 =
            LANES(court_hopping)();
        V which = _o458.which;
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
        const LANES(court_resumed_out) _o179 =
            LANES(court_resumed)(clock, mode, position_error, velocity_error);
        V which = _o179.which;
        V late = _o179.late;
        V began = _o179.began;
        V doubt = _o179.doubt;
        M begins = _o179.begins;
        M rolling = _o179.rolling;
        M leaves = _o179.leaves;
        V nx = _o179.nx;
        V ny = _o179.ny;
        V nz = _o179.nz;
        V gap = _o179.gap;
        V bent_x = _o179.bent_x;
        V bent_y = _o179.bent_y;
        V bent_z = _o179.bent_z;
        V lift = _o179.lift;
        V surge = _o179.surge;
        V snap = _o179.snap;
        V per_reach = _o179.per_reach;
        const M _m180 = lanes_both(rows, begins);
        if (lanes_any(_m180)) {
            const LANES(court_holding_out) _o181 =
                LANES(court_holding)(held, K(0.0));
            M here = _o181.here;
            const M _m182 = lanes_both(_m180, here);
            {
                const LANES(court_ring_normal_out) _o183 =
                    LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                nx = lanes_select(_m182, _o183.nx, nx);
                ny = lanes_select(_m182, _o183.ny, ny);
                nz = lanes_select(_m182, _o183.nz, nz);
            }
            const LANES(court_holding_out) _o184 =
                LANES(court_holding)(held, K(1.0));
            here = _o184.here;
            const M _m185 = lanes_both(_m180, here);
            {
                const LANES(court_backboard_normal_out) _o186 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m185, _o186.nx, nx);
                ny = lanes_select(_m185, _o186.ny, ny);
                nz = lanes_select(_m185, _o186.nz, nz);
            }
            const LANES(court_holding_out) _o187 =
                LANES(court_holding)(held, K(2.0));
            here = _o187.here;
            const M _m188 = lanes_both(_m180, here);
            {
                const LANES(court_bridge_normal_out) _o189 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m188, _o189.nx, nx);
                ny = lanes_select(_m188, _o189.ny, ny);
                nz = lanes_select(_m188, _o189.nz, nz);
            }
            const LANES(court_roll_turn_rate_out) _o190 =
                LANES(court_roll_turn_rate)(p_ball_radius, nx, ny, nz, wx, wy, wz);
            V turn_rate = _o190.turn_rate;
            const LANES(court_gripped_out) _o191 =
                LANES(court_gripped)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
            V rolled_x = _o191.rolled_x;
            V rolled_y = _o191.rolled_y;
            V rolled_z = _o191.rolled_z;
            const LANES(court_holding_out) _o192 =
                LANES(court_holding)(held, K(0.0));
            here = _o192.here;
            const M _m193 = lanes_both(_m180, here);
            {
                const LANES(court_ring_off_out) _o194 =
                    LANES(court_ring_off)(p_ball_radius, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m193, _o194.gap, gap);
            }
            const LANES(court_holding_out) _o195 =
                LANES(court_holding)(held, K(1.0));
            here = _o195.here;
            const M _m196 = lanes_both(_m180, here);
            {
                const LANES(court_backboard_off_out) _o197 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z);
                gap = lanes_select(_m196, _o197.gap, gap);
            }
            const LANES(court_holding_out) _o198 =
                LANES(court_holding)(held, K(2.0));
            here = _o198.here;
            const M _m199 = lanes_both(_m180, here);
            {
                const LANES(court_bridge_off_out) _o200 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m199, _o200.gap, gap);
            }
            const LANES(court_roll_placed_out) _o201 =
                LANES(court_roll_placed)(p_ball_radius, gap, nx, ny, nz, turn_rate, rolled_x, rolled_y, rolled_z, x, y, z);
            x = lanes_select(_m180, _o201.x, x);
            y = lanes_select(_m180, _o201.y, y);
            z = lanes_select(_m180, _o201.z, z);
            vx = lanes_select(_m180, _o201.vx, vx);
            vy = lanes_select(_m180, _o201.vy, vy);
            vz = lanes_select(_m180, _o201.vz, vz);
            wx = lanes_select(_m180, _o201.wx, wx);
            wy = lanes_select(_m180, _o201.wy, wy);
            wz = lanes_select(_m180, _o201.wz, wz);
            const LANES(court_begun_errors_out) _o202 =
                LANES(court_begun_errors)(p_ball_radius, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, vx, vy, vz);
            dx = lanes_select(_m180, _o202.dx, dx);
            dy = lanes_select(_m180, _o202.dy, dy);
            dz = lanes_select(_m180, _o202.dz, dz);
            dvx = lanes_select(_m180, _o202.dvx, dvx);
            dvy = lanes_select(_m180, _o202.dvy, dvy);
            dvz = lanes_select(_m180, _o202.dvz, dvz);
            dwx = lanes_select(_m180, _o202.dwx, dwx);
            dwy = lanes_select(_m180, _o202.dwy, dwy);
            dwz = lanes_select(_m180, _o202.dwz, dwz);
            const LANES(court_untaut_out) _o203 =
                LANES(court_untaut)();
            taut = lanes_select(_m180, _o203.taut, taut);
            const LANES(court_beginning_contact_out) _o204 =
                LANES(court_beginning_contact)();
            which = lanes_select(_m180, _o204.which, which);
            circled = lanes_select(_m180, _o204.circled, circled);
        }
        const LANES(court_circles_out) _o205 =
            LANES(court_circles)(held, K(0.0), rolling);
        M circling = _o205.circling;
        rolling = _o205.rolling;
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
            const LANES(court_error_bounds_out) _o206 =
                LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            V position_error = _o206.position_error;
            V velocity_error = _o206.velocity_error;
            const LANES(court_holding_out) _o207 =
                LANES(court_holding)(held, K(1.0));
            M here = _o207.here;
            const M _m208 = lanes_both(active, here);
            if (lanes_any(_m208)) {
                const LANES(court_backboard_normal_out) _o209 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m208, _o209.nx, nx);
                ny = lanes_select(_m208, _o209.ny, ny);
                nz = lanes_select(_m208, _o209.nz, nz);
                const LANES(court_backboard_tube_out) _o210 =
                    LANES(court_backboard_tube)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                bent_x = lanes_select(_m208, _o210.bent_x, bent_x);
                bent_y = lanes_select(_m208, _o210.bent_y, bent_y);
                bent_z = lanes_select(_m208, _o210.bent_z, bent_z);
                per_reach = lanes_select(_m208, _o210.per_reach, per_reach);
            }
            const LANES(court_holding_out) _o211 =
                LANES(court_holding)(held, K(2.0));
            here = _o211.here;
            const M _m212 = lanes_both(active, here);
            if (lanes_any(_m212)) {
                const LANES(court_bridge_normal_out) _o213 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m212, _o213.nx, nx);
                ny = lanes_select(_m212, _o213.ny, ny);
                nz = lanes_select(_m212, _o213.nz, nz);
                const LANES(court_bridge_tube_out) _o214 =
                    LANES(court_bridge_tube)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                bent_x = lanes_select(_m212, _o214.bent_x, bent_x);
                bent_y = lanes_select(_m212, _o214.bent_y, bent_y);
                bent_z = lanes_select(_m212, _o214.bent_z, bent_z);
                per_reach = lanes_select(_m212, _o214.per_reach, per_reach);
            }
            const LANES(court_roll_start_out) _o215 =
                LANES(court_roll_start)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
            V vx_0 = _o215.vx_0;
            V vy_0 = _o215.vy_0;
            V vz_0 = _o215.vz_0;
            V nx_0 = _o215.nx_0;
            V ny_0 = _o215.ny_0;
            V nz_0 = _o215.nz_0;
            V turn_rate_0 = _o215.turn_rate_0;
            const LANES(court_roll_0_out) _o216 =
                LANES(court_roll_0)(bent_x, bent_y, bent_z, p_gravity, nx_0, ny_0, nz_0, per_reach, turn_rate_0, vx_0, vy_0, vz_0);
            V lift_0 = _o216.lift_0;
            V tx_0 = _o216.tx_0;
            V ty_0 = _o216.ty_0;
            V tz_0 = _o216.tz_0;
            V vx_1 = _o216.vx_1;
            V vy_1 = _o216.vy_1;
            V vz_1 = _o216.vz_1;
            V nx_1 = _o216.nx_1;
            V ny_1 = _o216.ny_1;
            V nz_1 = _o216.nz_1;
            V turn_rate_1 = _o216.turn_rate_1;
            const LANES(court_roll_1_out) _o217 =
                LANES(court_roll_1)(bent_x, bent_y, bent_z, p_gravity, lift_0, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1);
            V lift_1 = _o217.lift_1;
            V tx_1 = _o217.tx_1;
            V ty_1 = _o217.ty_1;
            V tz_1 = _o217.tz_1;
            V vx_2 = _o217.vx_2;
            V vy_2 = _o217.vy_2;
            V vz_2 = _o217.vz_2;
            V nx_2 = _o217.nx_2;
            V ny_2 = _o217.ny_2;
            V nz_2 = _o217.nz_2;
            V turn_rate_2 = _o217.turn_rate_2;
            const LANES(court_roll_2_out) _o218 =
                LANES(court_roll_2)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2);
            V lift_2 = _o218.lift_2;
            V tx_2 = _o218.tx_2;
            V ty_2 = _o218.ty_2;
            V tz_2 = _o218.tz_2;
            V vx_3 = _o218.vx_3;
            V vy_3 = _o218.vy_3;
            V vz_3 = _o218.vz_3;
            V nx_3 = _o218.nx_3;
            V ny_3 = _o218.ny_3;
            V nz_3 = _o218.nz_3;
            V turn_rate_3 = _o218.turn_rate_3;
            const LANES(court_roll_3_out) _o219 =
                LANES(court_roll_3)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3);
            V lift_3 = _o219.lift_3;
            V tx_3 = _o219.tx_3;
            V ty_3 = _o219.ty_3;
            V tz_3 = _o219.tz_3;
            V vx_4 = _o219.vx_4;
            V vy_4 = _o219.vy_4;
            V vz_4 = _o219.vz_4;
            V nx_4 = _o219.nx_4;
            V ny_4 = _o219.ny_4;
            V nz_4 = _o219.nz_4;
            V turn_rate_4 = _o219.turn_rate_4;
            const LANES(court_roll_4_out) _o220 =
                LANES(court_roll_4)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4);
            V lift_4 = _o220.lift_4;
            V tx_4 = _o220.tx_4;
            V ty_4 = _o220.ty_4;
            V tz_4 = _o220.tz_4;
            V vx_5 = _o220.vx_5;
            V vy_5 = _o220.vy_5;
            V vz_5 = _o220.vz_5;
            V nx_5 = _o220.nx_5;
            V ny_5 = _o220.ny_5;
            V nz_5 = _o220.nz_5;
            V turn_rate_5 = _o220.turn_rate_5;
            const LANES(court_roll_5_out) _o221 =
                LANES(court_roll_5)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5);
            V lift_5 = _o221.lift_5;
            V tx_5 = _o221.tx_5;
            V ty_5 = _o221.ty_5;
            V tz_5 = _o221.tz_5;
            V vx_6 = _o221.vx_6;
            V vy_6 = _o221.vy_6;
            V vz_6 = _o221.vz_6;
            V nx_6 = _o221.nx_6;
            V ny_6 = _o221.ny_6;
            V nz_6 = _o221.nz_6;
            V turn_rate_6 = _o221.turn_rate_6;
            const LANES(court_roll_6_out) _o222 =
                LANES(court_roll_6)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6);
            V lift_6 = _o222.lift_6;
            V tx_6 = _o222.tx_6;
            V ty_6 = _o222.ty_6;
            V tz_6 = _o222.tz_6;
            V vx_7 = _o222.vx_7;
            V vy_7 = _o222.vy_7;
            V vz_7 = _o222.vz_7;
            V nx_7 = _o222.nx_7;
            V ny_7 = _o222.ny_7;
            V nz_7 = _o222.nz_7;
            V turn_rate_7 = _o222.turn_rate_7;
            const LANES(court_roll_7_out) _o223 =
                LANES(court_roll_7)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7);
            V lift_7 = _o223.lift_7;
            V vx_8 = _o223.vx_8;
            V vy_8 = _o223.vy_8;
            V vz_8 = _o223.vz_8;
            V nx_8 = _o223.nx_8;
            V ny_8 = _o223.ny_8;
            V nz_8 = _o223.nz_8;
            V turn_rate_8 = _o223.turn_rate_8;
            const LANES(court_roll_pace_out) _o224 =
                LANES(court_roll_pace)(p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, lift_7, nx_8, ny_8, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, nz_8, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8);
            V stride = _o224.stride;
            V strongest = _o224.strongest;
            V fastest = _o224.fastest;
            V force = _o224.force;
            V force_rate = _o224.force_rate;
            V force_bend = _o224.force_bend;
            V brace = _o224.brace;
            const LANES(court_pulled_out) _o225 =
                LANES(court_pulled)(p_gravity, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, turn_rate_0, turn_rate_1, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1);
            V drag = _o225.drag;
            V drag_rate = _o225.drag_rate;
            V strain = _o225.strain;
            V strain_rate = _o225.strain_rate;
            const LANES(court_holding_out) _o226 =
                LANES(court_holding)(held, K(1.0));
            here = _o226.here;
            const M _m227 = lanes_both(active, here);
            {
                const LANES(court_ring_impact_strained_out) _o228 =
                    LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, p_backboard_friction);
                strain = lanes_select(_m227, _o228.strain, strain);
                strain_rate = lanes_select(_m227, _o228.strain_rate, strain_rate);
            }
            const LANES(court_holding_out) _o229 =
                LANES(court_holding)(held, K(2.0));
            here = _o229.here;
            const M _m230 = lanes_both(active, here);
            {
                const LANES(court_ring_impact_strained_out) _o231 =
                    LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, p_bridge_friction);
                strain = lanes_select(_m230, _o231.strain, strain);
                strain_rate = lanes_select(_m230, _o231.strain_rate, strain_rate);
            }
            const LANES(court_losing_out) _o232 =
                LANES(court_losing)(grip_lost, strain);
            M loses = _o232.loses;
            const M _m233 = lanes_both(active, loses);
            if (lanes_any(_m233)) {
                const LANES(court_lost_grip_out) _o234 =
                    LANES(court_lost_grip)(clock, strain, strain_rate, taut, taut_clock, taut_rate);
                grip_lost = lanes_select(_m233, _o234.grip_lost, grip_lost);
            }
            const LANES(court_tightened_out) _o235 =
                LANES(court_tightened)(clock, strain, strain_rate);
            taut = _o235.taut;
            taut_rate = _o235.taut_rate;
            taut_clock = _o235.taut_clock;
            const LANES(court_leaving_force_out) _o236 =
                LANES(court_leaving_force)(p_ball_radius, brace, doubt, fastest, force, force_bend, force_rate, p_gravity, per_reach, position_error, stride, velocity_error, vx, vx_1, vy, vy_1, vz, vz_1, which);
            stride = _o236.stride;
            which = _o236.which;
            M rests = _o236.rests;
            doubt = _o236.doubt;
            const LANES(court_beside_out) _o237 =
                LANES(court_beside)(held, K(0.0));
            M beside = _o237.beside;
            const M _m238 = lanes_both(active, beside);
            if (lanes_any(_m238)) {
                const LANES(court_ring_beside_out) _o239 =
                    LANES(court_ring_beside)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                V gap = _o239.gap;
                V nearing = _o239.nearing;
                V dent = _o239.dent;
                const LANES(court_beside_body_out) _o240 =
                    LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(0.0), late, nearing, position_error, stride, strongest, which, x, y, z);
                stride = lanes_select(_m238, _o240.stride, stride);
                which = lanes_select(_m238, _o240.which, which);
                doubt = lanes_select(_m238, _o240.doubt, doubt);
                late = lanes_select(_m238, _o240.late, late);
            }
            const LANES(court_beside_out) _o241 =
                LANES(court_beside)(held, K(1.0));
            beside = _o241.beside;
            const M _m242 = lanes_both(active, beside);
            if (lanes_any(_m242)) {
                const LANES(court_backboard_beside_out) _o243 =
                    LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                V gap = _o243.gap;
                V nearing = _o243.nearing;
                V dent = _o243.dent;
                const LANES(court_beside_body_out) _o244 =
                    LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(1.0), late, nearing, position_error, stride, strongest, which, x, y, z);
                stride = lanes_select(_m242, _o244.stride, stride);
                which = lanes_select(_m242, _o244.which, which);
                doubt = lanes_select(_m242, _o244.doubt, doubt);
                late = lanes_select(_m242, _o244.late, late);
            }
            const LANES(court_beside_out) _o245 =
                LANES(court_beside)(held, K(2.0));
            beside = _o245.beside;
            const M _m246 = lanes_both(active, beside);
            if (lanes_any(_m246)) {
                const LANES(court_bridge_beside_out) _o247 =
                    LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                V gap = _o247.gap;
                V nearing = _o247.nearing;
                V dent = _o247.dent;
                const LANES(court_beside_body_out) _o248 =
                    LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(2.0), late, nearing, position_error, stride, strongest, which, x, y, z);
                stride = lanes_select(_m246, _o248.stride, stride);
                which = lanes_select(_m246, _o248.which, which);
                doubt = lanes_select(_m246, _o248.doubt, doubt);
                late = lanes_select(_m246, _o248.late, late);
            }
            const LANES(court_end_beside_out) _o249 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            V gap = _o249.gap;
            V nearing = _o249.nearing;
            V dent = _o249.dent;
            const LANES(court_beside_gate_out) _o250 =
                LANES(court_beside_gate)(p_ball_radius, dent, doubt, fastest, gap, K(3.0), late, nearing, position_error, stride, strongest, which, x, y, z);
            stride = _o250.stride;
            which = _o250.which;
            doubt = _o250.doubt;
            late = _o250.late;
            const LANES(court_holding_out) _o251 =
                LANES(court_holding)(held, K(1.0));
            here = _o251.here;
            const M _m252 = lanes_both(active, here);
            if (lanes_any(_m252)) {
                const LANES(court_backboard_seam0_out) _o253 =
                    LANES(court_backboard_seam0)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                gap = lanes_select(_m252, _o253.gap, gap);
                V nearing = _o253.nearing;
                V near = _o253.near;
                const LANES(court_beside_seam_out) _o254 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m252, _o254.stride, stride);
                const LANES(court_backboard_seam1_out) _o255 =
                    LANES(court_backboard_seam1)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                gap = lanes_select(_m252, _o255.gap, gap);
                nearing = _o255.nearing;
                near = _o255.near;
                const LANES(court_beside_seam_out) _o256 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m252, _o256.stride, stride);
                const LANES(court_backboard_seam2_out) _o257 =
                    LANES(court_backboard_seam2)(p_ball_radius, p_board_half_width, vy, y);
                gap = lanes_select(_m252, _o257.gap, gap);
                nearing = _o257.nearing;
                near = _o257.near;
                const LANES(court_beside_seam_out) _o258 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m252, _o258.stride, stride);
                const LANES(court_backboard_seam3_out) _o259 =
                    LANES(court_backboard_seam3)(p_ball_radius, p_board_half_width, vy, y);
                gap = lanes_select(_m252, _o259.gap, gap);
                nearing = _o259.nearing;
                near = _o259.near;
                const LANES(court_beside_seam_out) _o260 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m252, _o260.stride, stride);
                const LANES(court_backboard_seam4_out) _o261 =
                    LANES(court_backboard_seam4)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                gap = lanes_select(_m252, _o261.gap, gap);
                nearing = _o261.nearing;
                near = _o261.near;
                const LANES(court_beside_seam_out) _o262 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m252, _o262.stride, stride);
                const LANES(court_backboard_seam5_out) _o263 =
                    LANES(court_backboard_seam5)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                gap = lanes_select(_m252, _o263.gap, gap);
                nearing = _o263.nearing;
                near = _o263.near;
                const LANES(court_beside_seam_out) _o264 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m252, _o264.stride, stride);
            }
            const LANES(court_holding_out) _o265 =
                LANES(court_holding)(held, K(2.0));
            here = _o265.here;
            const M _m266 = lanes_both(active, here);
            if (lanes_any(_m266)) {
                const LANES(court_bridge_seam0_out) _o267 =
                    LANES(court_bridge_seam0)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                gap = lanes_select(_m266, _o267.gap, gap);
                V nearing = _o267.nearing;
                V near = _o267.near;
                const LANES(court_beside_seam_out) _o268 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m266, _o268.stride, stride);
                const LANES(court_bridge_seam1_out) _o269 =
                    LANES(court_bridge_seam1)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                gap = lanes_select(_m266, _o269.gap, gap);
                nearing = _o269.nearing;
                near = _o269.near;
                const LANES(court_beside_seam_out) _o270 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m266, _o270.stride, stride);
                const LANES(court_bridge_seam2_out) _o271 =
                    LANES(court_bridge_seam2)(p_ball_radius, p_bridge_half_width, vy, y);
                gap = lanes_select(_m266, _o271.gap, gap);
                nearing = _o271.nearing;
                near = _o271.near;
                const LANES(court_beside_seam_out) _o272 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m266, _o272.stride, stride);
                const LANES(court_bridge_seam3_out) _o273 =
                    LANES(court_bridge_seam3)(p_ball_radius, p_bridge_half_width, vy, y);
                gap = lanes_select(_m266, _o273.gap, gap);
                nearing = _o273.nearing;
                near = _o273.near;
                const LANES(court_beside_seam_out) _o274 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m266, _o274.stride, stride);
                const LANES(court_bridge_seam4_out) _o275 =
                    LANES(court_bridge_seam4)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                gap = lanes_select(_m266, _o275.gap, gap);
                nearing = _o275.nearing;
                near = _o275.near;
                const LANES(court_beside_seam_out) _o276 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m266, _o276.stride, stride);
                const LANES(court_bridge_seam5_out) _o277 =
                    LANES(court_bridge_seam5)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                gap = lanes_select(_m266, _o277.gap, gap);
                nearing = _o277.nearing;
                near = _o277.near;
                const LANES(court_beside_seam_out) _o278 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m266, _o278.stride, stride);
            }
            const LANES(court_beside_time_out) _o279 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o279.stride;
            which = _o279.which;
            const LANES(court_apart_out) _o280 =
                LANES(court_apart)(p_ball_radius, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz);
            V apart = _o280.apart;
            const LANES(court_neighbour_out) _o281 =
                LANES(court_neighbour)(apart, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, vx, vy, vz, wx, wy, wz, x, y, z);
            V far_x = _o281.far_x;
            V far_y = _o281.far_y;
            V far_z = _o281.far_z;
            V far_vx = _o281.far_vx;
            V far_vy = _o281.far_vy;
            V far_vz = _o281.far_vz;
            V far_wx = _o281.far_wx;
            V far_wy = _o281.far_wy;
            V far_wz = _o281.far_wz;
            V far_nx = _o281.far_nx;
            V far_ny = _o281.far_ny;
            V far_nz = _o281.far_nz;
            V far_gap = _o281.far_gap;
            const LANES(court_passing_from_out) _o282 =
                LANES(court_passing_from)(z);
            M over = _o282.over;
            const LANES(court_roll_moved_out) _o283 =
                LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, x, y, z);
            x = _o283.x;
            vx = _o283.vx;
            y = _o283.y;
            vy = _o283.vy;
            z = _o283.z;
            vz = _o283.vz;
            V turn_rate = _o283.turn_rate;
            const LANES(court_holding_out) _o284 =
                LANES(court_holding)(held, K(1.0));
            here = _o284.here;
            const M _m285 = lanes_both(active, here);
            if (lanes_any(_m285)) {
                const LANES(court_backboard_normal_out) _o286 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m285, _o286.nx, nx);
                ny = lanes_select(_m285, _o286.ny, ny);
                nz = lanes_select(_m285, _o286.nz, nz);
                const LANES(court_backboard_off_out) _o287 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z);
                gap = lanes_select(_m285, _o287.gap, gap);
            }
            const LANES(court_holding_out) _o288 =
                LANES(court_holding)(held, K(2.0));
            here = _o288.here;
            const M _m289 = lanes_both(active, here);
            if (lanes_any(_m289)) {
                const LANES(court_bridge_normal_out) _o290 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m289, _o290.nx, nx);
                ny = lanes_select(_m289, _o290.ny, ny);
                nz = lanes_select(_m289, _o290.nz, nz);
                const LANES(court_bridge_off_out) _o291 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m289, _o291.gap, gap);
            }
            const LANES(court_roll_placed_out) _o292 =
                LANES(court_roll_placed)(p_ball_radius, gap, nx, ny, nz, turn_rate, vx, vy, vz, x, y, z);
            x = _o292.x;
            y = _o292.y;
            z = _o292.z;
            vx = _o292.vx;
            vy = _o292.vy;
            vz = _o292.vz;
            wx = _o292.wx;
            wy = _o292.wy;
            wz = _o292.wz;
            const LANES(court_passing_in_contact_out) _o293 =
                LANES(court_passing_in_contact)(over, p_ring_radius, through, x, y, z);
            through = _o293.through;
            const LANES(court_holding_out) _o294 =
                LANES(court_holding)(held, K(1.0));
            here = _o294.here;
            const M _m295 = lanes_both(active, here);
            {
                const LANES(court_backboard_normal_out) _o296 =
                    LANES(court_backboard_normal)(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                far_nx = lanes_select(_m295, _o296.nx, far_nx);
                far_ny = lanes_select(_m295, _o296.ny, far_ny);
                far_nz = lanes_select(_m295, _o296.nz, far_nz);
            }
            const LANES(court_holding_out) _o297 =
                LANES(court_holding)(held, K(2.0));
            here = _o297.here;
            const M _m298 = lanes_both(active, here);
            {
                const LANES(court_bridge_normal_out) _o299 =
                    LANES(court_bridge_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                far_nx = lanes_select(_m298, _o299.nx, far_nx);
                far_ny = lanes_select(_m298, _o299.ny, far_ny);
                far_nz = lanes_select(_m298, _o299.nz, far_nz);
            }
            const LANES(court_roll_turn_rate_out) _o300 =
                LANES(court_roll_turn_rate)(p_ball_radius, far_nx, far_ny, far_nz, far_wx, far_wy, far_wz);
            turn_rate = _o300.turn_rate;
            const LANES(court_holding_out) _o301 =
                LANES(court_holding)(held, K(1.0));
            here = _o301.here;
            const M _m302 = lanes_both(active, here);
            if (lanes_any(_m302)) {
                const LANES(court_backboard_normal_out) _o303 =
                    LANES(court_backboard_normal)(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                far_nx = lanes_select(_m302, _o303.nx, far_nx);
                far_ny = lanes_select(_m302, _o303.ny, far_ny);
                far_nz = lanes_select(_m302, _o303.nz, far_nz);
                const LANES(court_backboard_off_out) _o304 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, far_x, far_y, far_z);
                far_gap = lanes_select(_m302, _o304.gap, far_gap);
            }
            const LANES(court_holding_out) _o305 =
                LANES(court_holding)(held, K(2.0));
            here = _o305.here;
            const M _m306 = lanes_both(active, here);
            if (lanes_any(_m306)) {
                const LANES(court_bridge_normal_out) _o307 =
                    LANES(court_bridge_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                far_nx = lanes_select(_m306, _o307.nx, far_nx);
                far_ny = lanes_select(_m306, _o307.ny, far_ny);
                far_nz = lanes_select(_m306, _o307.nz, far_nz);
                const LANES(court_bridge_off_out) _o308 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, far_x, far_y, far_z);
                far_gap = lanes_select(_m306, _o308.gap, far_gap);
            }
            const LANES(court_roll_placed_out) _o309 =
                LANES(court_roll_placed)(p_ball_radius, far_gap, far_nx, far_ny, far_nz, turn_rate, far_vx, far_vy, far_vz, far_x, far_y, far_z);
            far_x = _o309.x;
            far_y = _o309.y;
            far_z = _o309.z;
            far_vx = _o309.vx;
            far_vy = _o309.vy;
            far_vz = _o309.vz;
            far_wx = _o309.wx;
            far_wy = _o309.wy;
            far_wz = _o309.wz;
            const LANES(court_roll_start_out) _o310 =
                LANES(court_roll_start)(p_ball_radius, far_nx, far_ny, far_nz, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz);
            vx_0 = _o310.vx_0;
            vy_0 = _o310.vy_0;
            vz_0 = _o310.vz_0;
            nx_0 = _o310.nx_0;
            ny_0 = _o310.ny_0;
            nz_0 = _o310.nz_0;
            turn_rate_0 = _o310.turn_rate_0;
            const LANES(court_roll_0_out) _o311 =
                LANES(court_roll_0)(bent_x, bent_y, bent_z, p_gravity, nx_0, ny_0, nz_0, per_reach, turn_rate_0, vx_0, vy_0, vz_0);
            lift_0 = _o311.lift_0;
            tx_0 = _o311.tx_0;
            ty_0 = _o311.ty_0;
            tz_0 = _o311.tz_0;
            vx_1 = _o311.vx_1;
            vy_1 = _o311.vy_1;
            vz_1 = _o311.vz_1;
            nx_1 = _o311.nx_1;
            ny_1 = _o311.ny_1;
            nz_1 = _o311.nz_1;
            turn_rate_1 = _o311.turn_rate_1;
            const LANES(court_roll_1_out) _o312 =
                LANES(court_roll_1)(bent_x, bent_y, bent_z, p_gravity, lift_0, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1);
            lift_1 = _o312.lift_1;
            tx_1 = _o312.tx_1;
            ty_1 = _o312.ty_1;
            tz_1 = _o312.tz_1;
            vx_2 = _o312.vx_2;
            vy_2 = _o312.vy_2;
            vz_2 = _o312.vz_2;
            nx_2 = _o312.nx_2;
            ny_2 = _o312.ny_2;
            nz_2 = _o312.nz_2;
            turn_rate_2 = _o312.turn_rate_2;
            const LANES(court_roll_2_out) _o313 =
                LANES(court_roll_2)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2);
            lift_2 = _o313.lift_2;
            tx_2 = _o313.tx_2;
            ty_2 = _o313.ty_2;
            tz_2 = _o313.tz_2;
            vx_3 = _o313.vx_3;
            vy_3 = _o313.vy_3;
            vz_3 = _o313.vz_3;
            nx_3 = _o313.nx_3;
            ny_3 = _o313.ny_3;
            nz_3 = _o313.nz_3;
            turn_rate_3 = _o313.turn_rate_3;
            const LANES(court_roll_3_out) _o314 =
                LANES(court_roll_3)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3);
            lift_3 = _o314.lift_3;
            tx_3 = _o314.tx_3;
            ty_3 = _o314.ty_3;
            tz_3 = _o314.tz_3;
            vx_4 = _o314.vx_4;
            vy_4 = _o314.vy_4;
            vz_4 = _o314.vz_4;
            nx_4 = _o314.nx_4;
            ny_4 = _o314.ny_4;
            nz_4 = _o314.nz_4;
            turn_rate_4 = _o314.turn_rate_4;
            const LANES(court_roll_4_out) _o315 =
                LANES(court_roll_4)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4);
            lift_4 = _o315.lift_4;
            tx_4 = _o315.tx_4;
            ty_4 = _o315.ty_4;
            tz_4 = _o315.tz_4;
            vx_5 = _o315.vx_5;
            vy_5 = _o315.vy_5;
            vz_5 = _o315.vz_5;
            nx_5 = _o315.nx_5;
            ny_5 = _o315.ny_5;
            nz_5 = _o315.nz_5;
            turn_rate_5 = _o315.turn_rate_5;
            const LANES(court_roll_5_out) _o316 =
                LANES(court_roll_5)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5);
            lift_5 = _o316.lift_5;
            tx_5 = _o316.tx_5;
            ty_5 = _o316.ty_5;
            tz_5 = _o316.tz_5;
            vx_6 = _o316.vx_6;
            vy_6 = _o316.vy_6;
            vz_6 = _o316.vz_6;
            nx_6 = _o316.nx_6;
            ny_6 = _o316.ny_6;
            nz_6 = _o316.nz_6;
            turn_rate_6 = _o316.turn_rate_6;
            const LANES(court_roll_6_out) _o317 =
                LANES(court_roll_6)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6);
            lift_6 = _o317.lift_6;
            tx_6 = _o317.tx_6;
            ty_6 = _o317.ty_6;
            tz_6 = _o317.tz_6;
            vx_7 = _o317.vx_7;
            vy_7 = _o317.vy_7;
            vz_7 = _o317.vz_7;
            nx_7 = _o317.nx_7;
            ny_7 = _o317.ny_7;
            nz_7 = _o317.nz_7;
            turn_rate_7 = _o317.turn_rate_7;
            const LANES(court_roll_7_out) _o318 =
                LANES(court_roll_7)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7);
            vx_8 = _o318.vx_8;
            vy_8 = _o318.vy_8;
            vz_8 = _o318.vz_8;
            turn_rate_8 = _o318.turn_rate_8;
            const LANES(court_roll_moved_out) _o319 =
                LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, far_x, far_y, far_z);
            far_x = _o319.x;
            far_vx = _o319.vx;
            far_y = _o319.y;
            far_vy = _o319.vy;
            far_z = _o319.z;
            far_vz = _o319.vz;
            turn_rate = _o319.turn_rate;
            const LANES(court_holding_out) _o320 =
                LANES(court_holding)(held, K(1.0));
            here = _o320.here;
            const M _m321 = lanes_both(active, here);
            if (lanes_any(_m321)) {
                const LANES(court_backboard_normal_out) _o322 =
                    LANES(court_backboard_normal)(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                far_nx = lanes_select(_m321, _o322.nx, far_nx);
                far_ny = lanes_select(_m321, _o322.ny, far_ny);
                far_nz = lanes_select(_m321, _o322.nz, far_nz);
                const LANES(court_backboard_off_out) _o323 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, far_x, far_y, far_z);
                far_gap = lanes_select(_m321, _o323.gap, far_gap);
            }
            const LANES(court_holding_out) _o324 =
                LANES(court_holding)(held, K(2.0));
            here = _o324.here;
            const M _m325 = lanes_both(active, here);
            if (lanes_any(_m325)) {
                const LANES(court_bridge_normal_out) _o326 =
                    LANES(court_bridge_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                far_nx = lanes_select(_m325, _o326.nx, far_nx);
                far_ny = lanes_select(_m325, _o326.ny, far_ny);
                far_nz = lanes_select(_m325, _o326.nz, far_nz);
                const LANES(court_bridge_off_out) _o327 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, far_x, far_y, far_z);
                far_gap = lanes_select(_m325, _o327.gap, far_gap);
            }
            const LANES(court_roll_placed_out) _o328 =
                LANES(court_roll_placed)(p_ball_radius, far_gap, far_nx, far_ny, far_nz, turn_rate, far_vx, far_vy, far_vz, far_x, far_y, far_z);
            far_x = _o328.x;
            far_y = _o328.y;
            far_z = _o328.z;
            far_vx = _o328.vx;
            far_vy = _o328.vy;
            far_vz = _o328.vz;
            far_wx = _o328.wx;
            far_wy = _o328.wy;
            far_wz = _o328.wz;
            const LANES(court_compared_out) _o329 =
                LANES(court_compared)(apart, p_ball_radius, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_x, far_y, far_z, vx, vy, vz, wx, wy, wz, x, y, z);
            dx = _o329.dx;
            dy = _o329.dy;
            dz = _o329.dz;
            dvx = _o329.dvx;
            dvy = _o329.dvy;
            dvz = _o329.dvz;
            dwx = _o329.dwx;
            dwy = _o329.dwy;
            dwz = _o329.dwz;
            const LANES(court_rolled_on_out) _o330 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o330.clock;
            rolling = _o330.rolling;
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
            const LANES(court_error_bounds_out) _o331 =
                LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            V position_error = _o331.position_error;
            V velocity_error = _o331.velocity_error;
            const LANES(court_ring_tube_out) _o332 =
                LANES(court_ring_tube)(p_ball_radius, p_wire_radius);
            V per_reach = _o332.per_reach;
            const LANES(court_ring_round_start_out) _o333 =
                LANES(court_ring_round_start)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, wx, wy, wz, x, y, z);
            V cosine_0 = _o333.cosine_0;
            V sine_0 = _o333.sine_0;
            V climb_0 = _o333.climb_0;
            V along_0 = _o333.along_0;
            V turn_rate_0 = _o333.turn_rate_0;
            V cos_0 = _o333.cos_0;
            V sin_0 = _o333.sin_0;
            V near_0 = _o333.near_0;
            const LANES(court_ring_round_0_out) _o334 =
                LANES(court_ring_round_0)(along_0, p_ball_radius, climb_0, cos_0, cosine_0, p_gravity, near_0, p_ring_radius, sin_0, sine_0, turn_rate_0, p_wire_radius);
            V omega_0 = _o334.omega_0;
            V around_0 = _o334.around_0;
            V tilted_0 = _o334.tilted_0;
            V pressed_0 = _o334.pressed_0;
            V force_0 = _o334.force_0;
            V cosine_1 = _o334.cosine_1;
            V sine_1 = _o334.sine_1;
            V climb_1 = _o334.climb_1;
            V along_1 = _o334.along_1;
            V turn_rate_1 = _o334.turn_rate_1;
            V cos_1 = _o334.cos_1;
            V sin_1 = _o334.sin_1;
            const LANES(court_ring_round_1_out) _o335 =
                LANES(court_ring_round_1)(along_0, along_1, around_0, p_ball_radius, climb_0, climb_1, cos_0, cos_1, cosine_0, cosine_1, p_gravity, near_0, omega_0, pressed_0, p_ring_radius, sin_0, sin_1, sine_0, sine_1, tilted_0, turn_rate_0, turn_rate_1, p_wire_radius);
            V near_1 = _o335.near_1;
            V omega_1 = _o335.omega_1;
            V around_1 = _o335.around_1;
            V tilted_1 = _o335.tilted_1;
            V pressed_1 = _o335.pressed_1;
            V force_1 = _o335.force_1;
            V cosine_2 = _o335.cosine_2;
            V sine_2 = _o335.sine_2;
            V climb_2 = _o335.climb_2;
            V along_2 = _o335.along_2;
            V turn_rate_2 = _o335.turn_rate_2;
            V cos_2 = _o335.cos_2;
            V sin_2 = _o335.sin_2;
            const LANES(court_ring_round_2_out) _o336 =
                LANES(court_ring_round_2)(along_0, along_1, along_2, around_0, around_1, p_ball_radius, climb_0, climb_1, climb_2, cos_0, cos_1, cos_2, cosine_0, cosine_1, cosine_2, p_gravity, near_0, near_1, omega_0, omega_1, pressed_0, pressed_1, p_ring_radius, sin_0, sin_1, sin_2, sine_0, sine_1, sine_2, tilted_0, tilted_1, turn_rate_0, turn_rate_1, turn_rate_2, p_wire_radius);
            V near_2 = _o336.near_2;
            V omega_2 = _o336.omega_2;
            V around_2 = _o336.around_2;
            V tilted_2 = _o336.tilted_2;
            V pressed_2 = _o336.pressed_2;
            V force_2 = _o336.force_2;
            V cosine_3 = _o336.cosine_3;
            V sine_3 = _o336.sine_3;
            V climb_3 = _o336.climb_3;
            V along_3 = _o336.along_3;
            V turn_rate_3 = _o336.turn_rate_3;
            V cos_3 = _o336.cos_3;
            V sin_3 = _o336.sin_3;
            const LANES(court_ring_round_3_out) _o337 =
                LANES(court_ring_round_3)(along_0, along_1, along_2, along_3, around_0, around_1, around_2, p_ball_radius, climb_0, climb_1, climb_2, climb_3, cos_0, cos_1, cos_2, cos_3, cosine_0, cosine_1, cosine_2, cosine_3, p_gravity, near_0, near_1, near_2, omega_0, omega_1, omega_2, pressed_0, pressed_1, pressed_2, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sine_0, sine_1, sine_2, sine_3, tilted_0, tilted_1, tilted_2, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, p_wire_radius);
            V near_3 = _o337.near_3;
            V omega_3 = _o337.omega_3;
            V around_3 = _o337.around_3;
            V tilted_3 = _o337.tilted_3;
            V pressed_3 = _o337.pressed_3;
            V force_3 = _o337.force_3;
            V cosine_4 = _o337.cosine_4;
            V sine_4 = _o337.sine_4;
            V climb_4 = _o337.climb_4;
            V along_4 = _o337.along_4;
            V turn_rate_4 = _o337.turn_rate_4;
            V cos_4 = _o337.cos_4;
            V sin_4 = _o337.sin_4;
            const LANES(court_ring_round_4_out) _o338 =
                LANES(court_ring_round_4)(along_0, along_1, along_2, along_3, along_4, around_0, around_1, around_2, around_3, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, cos_0, cos_1, cos_2, cos_3, cos_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, p_gravity, near_0, near_1, near_2, near_3, omega_0, omega_1, omega_2, omega_3, pressed_0, pressed_1, pressed_2, pressed_3, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sine_0, sine_1, sine_2, sine_3, sine_4, tilted_0, tilted_1, tilted_2, tilted_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, p_wire_radius);
            V near_4 = _o338.near_4;
            V omega_4 = _o338.omega_4;
            V around_4 = _o338.around_4;
            V tilted_4 = _o338.tilted_4;
            V pressed_4 = _o338.pressed_4;
            V force_4 = _o338.force_4;
            V cosine_5 = _o338.cosine_5;
            V sine_5 = _o338.sine_5;
            V climb_5 = _o338.climb_5;
            V along_5 = _o338.along_5;
            V turn_rate_5 = _o338.turn_rate_5;
            V cos_5 = _o338.cos_5;
            V sin_5 = _o338.sin_5;
            const LANES(court_ring_round_5_out) _o339 =
                LANES(court_ring_round_5)(along_0, along_1, along_2, along_3, along_4, along_5, around_0, around_1, around_2, around_3, around_4, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, p_gravity, near_0, near_1, near_2, near_3, near_4, omega_0, omega_1, omega_2, omega_3, omega_4, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, p_wire_radius);
            V near_5 = _o339.near_5;
            V omega_5 = _o339.omega_5;
            V around_5 = _o339.around_5;
            V tilted_5 = _o339.tilted_5;
            V pressed_5 = _o339.pressed_5;
            V force_5 = _o339.force_5;
            V cosine_6 = _o339.cosine_6;
            V sine_6 = _o339.sine_6;
            V climb_6 = _o339.climb_6;
            V along_6 = _o339.along_6;
            V turn_rate_6 = _o339.turn_rate_6;
            V cos_6 = _o339.cos_6;
            V sin_6 = _o339.sin_6;
            const LANES(court_ring_round_6_out) _o340 =
                LANES(court_ring_round_6)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, around_0, around_1, around_2, around_3, around_4, around_5, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, p_wire_radius);
            V near_6 = _o340.near_6;
            V omega_6 = _o340.omega_6;
            V around_6 = _o340.around_6;
            V tilted_6 = _o340.tilted_6;
            V pressed_6 = _o340.pressed_6;
            V force_6 = _o340.force_6;
            V cosine_7 = _o340.cosine_7;
            V sine_7 = _o340.sine_7;
            V climb_7 = _o340.climb_7;
            V along_7 = _o340.along_7;
            V turn_rate_7 = _o340.turn_rate_7;
            V cos_7 = _o340.cos_7;
            V sin_7 = _o340.sin_7;
            const LANES(court_ring_round_7_out) _o341 =
                LANES(court_ring_round_7)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, p_wire_radius);
            V near_7 = _o341.near_7;
            V omega_7 = _o341.omega_7;
            V around_7 = _o341.around_7;
            V tilted_7 = _o341.tilted_7;
            V pressed_7 = _o341.pressed_7;
            V force_7 = _o341.force_7;
            V cosine_8 = _o341.cosine_8;
            V sine_8 = _o341.sine_8;
            V climb_8 = _o341.climb_8;
            V along_8 = _o341.along_8;
            V turn_rate_8 = _o341.turn_rate_8;
            V cos_8 = _o341.cos_8;
            V sin_8 = _o341.sin_8;
            const LANES(court_ring_round_8_out) _o342 =
                LANES(court_ring_round_8)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, p_wire_radius);
            V near_8 = _o342.near_8;
            V omega_8 = _o342.omega_8;
            V around_8 = _o342.around_8;
            V tilted_8 = _o342.tilted_8;
            V pressed_8 = _o342.pressed_8;
            V force_8 = _o342.force_8;
            V cosine_9 = _o342.cosine_9;
            V sine_9 = _o342.sine_9;
            V climb_9 = _o342.climb_9;
            V along_9 = _o342.along_9;
            V turn_rate_9 = _o342.turn_rate_9;
            V cos_9 = _o342.cos_9;
            V sin_9 = _o342.sin_9;
            const LANES(court_ring_round_9_out) _o343 =
                LANES(court_ring_round_9)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V near_9 = _o343.near_9;
            V omega_9 = _o343.omega_9;
            V around_9 = _o343.around_9;
            V tilted_9 = _o343.tilted_9;
            V pressed_9 = _o343.pressed_9;
            V force_9 = _o343.force_9;
            V cosine_10 = _o343.cosine_10;
            V sine_10 = _o343.sine_10;
            V climb_10 = _o343.climb_10;
            V along_10 = _o343.along_10;
            V turn_rate_10 = _o343.turn_rate_10;
            V cos_10 = _o343.cos_10;
            V sin_10 = _o343.sin_10;
            const LANES(court_ring_round_10_out) _o344 =
                LANES(court_ring_round_10)(along_0, along_1, along_10, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V near_10 = _o344.near_10;
            V omega_10 = _o344.omega_10;
            V around_10 = _o344.around_10;
            V tilted_10 = _o344.tilted_10;
            V pressed_10 = _o344.pressed_10;
            V force_10 = _o344.force_10;
            V cosine_11 = _o344.cosine_11;
            V sine_11 = _o344.sine_11;
            V climb_11 = _o344.climb_11;
            V along_11 = _o344.along_11;
            V turn_rate_11 = _o344.turn_rate_11;
            V cos_11 = _o344.cos_11;
            V sin_11 = _o344.sin_11;
            const LANES(court_ring_round_11_out) _o345 =
                LANES(court_ring_round_11)(along_0, along_1, along_10, along_11, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_10, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_10, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_10, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_10, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V force_11 = _o345.force_11;
            V cosine_12 = _o345.cosine_12;
            V sine_12 = _o345.sine_12;
            V climb_12 = _o345.climb_12;
            V along_12 = _o345.along_12;
            V turn_rate_12 = _o345.turn_rate_12;
            V cos_12 = _o345.cos_12;
            V sin_12 = _o345.sin_12;
            const LANES(court_ring_round_pace_out) _o346 =
                LANES(court_ring_round_pace)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_12, cosine_0, cosine_12, force_0, force_1, force_10, force_11, force_2, force_3, force_4, force_5, force_6, force_7, force_8, force_9, p_gravity, omega_0, p_ring_radius, sin_0, sin_12, sine_0, sine_12, turn_rate_0, turn_rate_11, turn_rate_12, p_wire_radius);
            V stride = _o346.stride;
            V strongest = _o346.strongest;
            V fastest = _o346.fastest;
            V sway = _o346.sway;
            V force = _o346.force;
            V force_rate = _o346.force_rate;
            V force_bend = _o346.force_bend;
            V brace = _o346.brace;
            V vx_1 = _o346.vx_1;
            V vy_1 = _o346.vy_1;
            V vz_1 = _o346.vz_1;
            const LANES(court_ring_round_pulled_out) _o347 =
                LANES(court_ring_round_pulled)(climb_0, climb_1, cosine_0, cosine_1, p_gravity, omega_0, omega_1, turn_rate_0, turn_rate_1);
            V drag = _o347.drag;
            V drag_rate = _o347.drag_rate;
            const LANES(court_ring_impact_strained_out) _o348 =
                LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, p_ring_friction);
            V strain = _o348.strain;
            V strain_rate = _o348.strain_rate;
            const LANES(court_losing_out) _o349 =
                LANES(court_losing)(grip_lost, strain);
            M loses = _o349.loses;
            const M _m350 = lanes_both(active, loses);
            if (lanes_any(_m350)) {
                const LANES(court_lost_grip_out) _o351 =
                    LANES(court_lost_grip)(clock, strain, strain_rate, taut, taut_clock, taut_rate);
                grip_lost = lanes_select(_m350, _o351.grip_lost, grip_lost);
            }
            const LANES(court_tightened_out) _o352 =
                LANES(court_tightened)(clock, strain, strain_rate);
            taut = _o352.taut;
            taut_rate = _o352.taut_rate;
            taut_clock = _o352.taut_clock;
            const LANES(court_leaving_force_out) _o353 =
                LANES(court_leaving_force)(p_ball_radius, brace, doubt, fastest, force, force_bend, force_rate, p_gravity, per_reach, position_error, stride, velocity_error, vx, vx_1, vy, vy_1, vz, vz_1, which);
            stride = _o353.stride;
            which = _o353.which;
            M rests = _o353.rests;
            doubt = _o353.doubt;
            const LANES(court_backboard_beside_out) _o354 =
                LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            V gap = _o354.gap;
            V nearing = _o354.nearing;
            V dent = _o354.dent;
            const LANES(court_beside_body_out) _o355 =
                LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(1.0), late, nearing, position_error, stride, strongest, which, x, y, z);
            stride = _o355.stride;
            which = _o355.which;
            doubt = _o355.doubt;
            late = _o355.late;
            const LANES(court_bridge_beside_out) _o356 =
                LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o356.gap;
            nearing = _o356.nearing;
            dent = _o356.dent;
            const LANES(court_beside_body_out) _o357 =
                LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(2.0), late, nearing, position_error, stride, strongest, which, x, y, z);
            stride = _o357.stride;
            which = _o357.which;
            doubt = _o357.doubt;
            late = _o357.late;
            const LANES(court_end_beside_out) _o358 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o358.gap;
            nearing = _o358.nearing;
            dent = _o358.dent;
            const LANES(court_beside_gate_out) _o359 =
                LANES(court_beside_gate)(p_ball_radius, dent, doubt, fastest, gap, K(3.0), late, nearing, position_error, stride, strongest, which, x, y, z);
            stride = _o359.stride;
            which = _o359.which;
            doubt = _o359.doubt;
            late = _o359.late;
            const LANES(court_beside_time_out) _o360 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o360.stride;
            which = _o360.which;
            const LANES(court_apart_out) _o361 =
                LANES(court_apart)(p_ball_radius, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz);
            V apart = _o361.apart;
            const LANES(court_neighbour_out) _o362 =
                LANES(court_neighbour)(apart, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, vx, vy, vz, wx, wy, wz, x, y, z);
            V far_x = _o362.far_x;
            V far_y = _o362.far_y;
            V far_z = _o362.far_z;
            V far_vx = _o362.far_vx;
            V far_vy = _o362.far_vy;
            V far_vz = _o362.far_vz;
            V far_wx = _o362.far_wx;
            V far_wy = _o362.far_wy;
            V far_wz = _o362.far_wz;
            const LANES(court_passing_from_out) _o363 =
                LANES(court_passing_from)(z);
            M over = _o363.over;
            const LANES(court_alone_out) _o364 =
                LANES(court_alone)();
            V berth = _o364.nearest;
            const LANES(court_leaps_out) _o365 =
                LANES(court_leaps)(stride);
            V forth = _o365.forth;
            V back = _o365.back;
            const LANES(court_backboard_around_out) _o366 =
                LANES(court_backboard_around)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            gap = _o366.gap;
            nearing = _o366.nearing;
            const LANES(court_cleared_out) _o367 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o367.berth;
            const LANES(court_bridge_around_out) _o368 =
                LANES(court_bridge_around)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o368.gap;
            nearing = _o368.nearing;
            const LANES(court_cleared_out) _o369 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o369.berth;
            const LANES(court_end_around_out) _o370 =
                LANES(court_end_around)(p_end_depth, vz, z);
            gap = _o370.gap;
            nearing = _o370.nearing;
            const LANES(court_cleared_out) _o371 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o371.berth;
            const LANES(court_ring_round_moved_out) _o372 =
                LANES(court_ring_round_moved)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_12, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_12, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_12, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_12, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, stride, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_12, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            x = _o372.x;
            y = _o372.y;
            z = _o372.z;
            vx = _o372.vx;
            vy = _o372.vy;
            vz = _o372.vz;
            wx = _o372.wx;
            wy = _o372.wy;
            wz = _o372.wz;
            V climb = _o372.climb;
            const LANES(court_passing_in_contact_out) _o373 =
                LANES(court_passing_in_contact)(over, p_ring_radius, through, x, y, z);
            through = _o373.through;
            const LANES(court_backboard_around_out) _o374 =
                LANES(court_backboard_around)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            gap = _o374.gap;
            nearing = _o374.nearing;
            const LANES(court_cleared_out) _o375 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o375.berth;
            const LANES(court_bridge_around_out) _o376 =
                LANES(court_bridge_around)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o376.gap;
            nearing = _o376.nearing;
            const LANES(court_cleared_out) _o377 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o377.berth;
            const LANES(court_end_around_out) _o378 =
                LANES(court_end_around)(p_end_depth, vz, z);
            gap = _o378.gap;
            nearing = _o378.nearing;
            const LANES(court_cleared_out) _o379 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o379.berth;
            const LANES(court_ring_swung_out) _o380 =
                LANES(court_ring_swung)(p_ball_radius, berth, circled, climb, climb_0, doubt, fastest, force, force_bend, force_rate, p_gravity, position_error, stride, sway, velocity_error, which, p_wire_radius);
            circled = _o380.circled;
            M endless = _o380.endless;
            doubt = _o380.doubt;
            const LANES(court_for_ever_out) _o381 =
                LANES(court_for_ever)(endless, which);
            which = _o381.which;
            const LANES(court_ring_round_start_out) _o382 =
                LANES(court_ring_round_start)(p_ball_radius, p_ring_radius, far_vx, far_vy, far_vz, p_wire_radius, far_wx, far_wy, far_wz, far_x, far_y, far_z);
            cosine_0 = _o382.cosine_0;
            sine_0 = _o382.sine_0;
            climb_0 = _o382.climb_0;
            along_0 = _o382.along_0;
            turn_rate_0 = _o382.turn_rate_0;
            cos_0 = _o382.cos_0;
            sin_0 = _o382.sin_0;
            near_0 = _o382.near_0;
            const LANES(court_ring_round_0_out) _o383 =
                LANES(court_ring_round_0)(along_0, p_ball_radius, climb_0, cos_0, cosine_0, p_gravity, near_0, p_ring_radius, sin_0, sine_0, turn_rate_0, p_wire_radius);
            omega_0 = _o383.omega_0;
            around_0 = _o383.around_0;
            tilted_0 = _o383.tilted_0;
            pressed_0 = _o383.pressed_0;
            cosine_1 = _o383.cosine_1;
            sine_1 = _o383.sine_1;
            climb_1 = _o383.climb_1;
            along_1 = _o383.along_1;
            turn_rate_1 = _o383.turn_rate_1;
            cos_1 = _o383.cos_1;
            sin_1 = _o383.sin_1;
            const LANES(court_ring_round_1_out) _o384 =
                LANES(court_ring_round_1)(along_0, along_1, around_0, p_ball_radius, climb_0, climb_1, cos_0, cos_1, cosine_0, cosine_1, p_gravity, near_0, omega_0, pressed_0, p_ring_radius, sin_0, sin_1, sine_0, sine_1, tilted_0, turn_rate_0, turn_rate_1, p_wire_radius);
            near_1 = _o384.near_1;
            omega_1 = _o384.omega_1;
            around_1 = _o384.around_1;
            tilted_1 = _o384.tilted_1;
            pressed_1 = _o384.pressed_1;
            cosine_2 = _o384.cosine_2;
            sine_2 = _o384.sine_2;
            climb_2 = _o384.climb_2;
            along_2 = _o384.along_2;
            turn_rate_2 = _o384.turn_rate_2;
            cos_2 = _o384.cos_2;
            sin_2 = _o384.sin_2;
            const LANES(court_ring_round_2_out) _o385 =
                LANES(court_ring_round_2)(along_0, along_1, along_2, around_0, around_1, p_ball_radius, climb_0, climb_1, climb_2, cos_0, cos_1, cos_2, cosine_0, cosine_1, cosine_2, p_gravity, near_0, near_1, omega_0, omega_1, pressed_0, pressed_1, p_ring_radius, sin_0, sin_1, sin_2, sine_0, sine_1, sine_2, tilted_0, tilted_1, turn_rate_0, turn_rate_1, turn_rate_2, p_wire_radius);
            near_2 = _o385.near_2;
            omega_2 = _o385.omega_2;
            around_2 = _o385.around_2;
            tilted_2 = _o385.tilted_2;
            pressed_2 = _o385.pressed_2;
            cosine_3 = _o385.cosine_3;
            sine_3 = _o385.sine_3;
            climb_3 = _o385.climb_3;
            along_3 = _o385.along_3;
            turn_rate_3 = _o385.turn_rate_3;
            cos_3 = _o385.cos_3;
            sin_3 = _o385.sin_3;
            const LANES(court_ring_round_3_out) _o386 =
                LANES(court_ring_round_3)(along_0, along_1, along_2, along_3, around_0, around_1, around_2, p_ball_radius, climb_0, climb_1, climb_2, climb_3, cos_0, cos_1, cos_2, cos_3, cosine_0, cosine_1, cosine_2, cosine_3, p_gravity, near_0, near_1, near_2, omega_0, omega_1, omega_2, pressed_0, pressed_1, pressed_2, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sine_0, sine_1, sine_2, sine_3, tilted_0, tilted_1, tilted_2, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, p_wire_radius);
            near_3 = _o386.near_3;
            omega_3 = _o386.omega_3;
            around_3 = _o386.around_3;
            tilted_3 = _o386.tilted_3;
            pressed_3 = _o386.pressed_3;
            cosine_4 = _o386.cosine_4;
            sine_4 = _o386.sine_4;
            climb_4 = _o386.climb_4;
            along_4 = _o386.along_4;
            turn_rate_4 = _o386.turn_rate_4;
            cos_4 = _o386.cos_4;
            sin_4 = _o386.sin_4;
            const LANES(court_ring_round_4_out) _o387 =
                LANES(court_ring_round_4)(along_0, along_1, along_2, along_3, along_4, around_0, around_1, around_2, around_3, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, cos_0, cos_1, cos_2, cos_3, cos_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, p_gravity, near_0, near_1, near_2, near_3, omega_0, omega_1, omega_2, omega_3, pressed_0, pressed_1, pressed_2, pressed_3, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sine_0, sine_1, sine_2, sine_3, sine_4, tilted_0, tilted_1, tilted_2, tilted_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, p_wire_radius);
            near_4 = _o387.near_4;
            omega_4 = _o387.omega_4;
            around_4 = _o387.around_4;
            tilted_4 = _o387.tilted_4;
            pressed_4 = _o387.pressed_4;
            cosine_5 = _o387.cosine_5;
            sine_5 = _o387.sine_5;
            climb_5 = _o387.climb_5;
            along_5 = _o387.along_5;
            turn_rate_5 = _o387.turn_rate_5;
            cos_5 = _o387.cos_5;
            sin_5 = _o387.sin_5;
            const LANES(court_ring_round_5_out) _o388 =
                LANES(court_ring_round_5)(along_0, along_1, along_2, along_3, along_4, along_5, around_0, around_1, around_2, around_3, around_4, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, p_gravity, near_0, near_1, near_2, near_3, near_4, omega_0, omega_1, omega_2, omega_3, omega_4, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, p_wire_radius);
            near_5 = _o388.near_5;
            omega_5 = _o388.omega_5;
            around_5 = _o388.around_5;
            tilted_5 = _o388.tilted_5;
            pressed_5 = _o388.pressed_5;
            cosine_6 = _o388.cosine_6;
            sine_6 = _o388.sine_6;
            climb_6 = _o388.climb_6;
            along_6 = _o388.along_6;
            turn_rate_6 = _o388.turn_rate_6;
            cos_6 = _o388.cos_6;
            sin_6 = _o388.sin_6;
            const LANES(court_ring_round_6_out) _o389 =
                LANES(court_ring_round_6)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, around_0, around_1, around_2, around_3, around_4, around_5, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, p_wire_radius);
            near_6 = _o389.near_6;
            omega_6 = _o389.omega_6;
            around_6 = _o389.around_6;
            tilted_6 = _o389.tilted_6;
            pressed_6 = _o389.pressed_6;
            cosine_7 = _o389.cosine_7;
            sine_7 = _o389.sine_7;
            climb_7 = _o389.climb_7;
            along_7 = _o389.along_7;
            turn_rate_7 = _o389.turn_rate_7;
            cos_7 = _o389.cos_7;
            sin_7 = _o389.sin_7;
            const LANES(court_ring_round_7_out) _o390 =
                LANES(court_ring_round_7)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, p_wire_radius);
            near_7 = _o390.near_7;
            omega_7 = _o390.omega_7;
            around_7 = _o390.around_7;
            tilted_7 = _o390.tilted_7;
            pressed_7 = _o390.pressed_7;
            cosine_8 = _o390.cosine_8;
            sine_8 = _o390.sine_8;
            climb_8 = _o390.climb_8;
            along_8 = _o390.along_8;
            turn_rate_8 = _o390.turn_rate_8;
            cos_8 = _o390.cos_8;
            sin_8 = _o390.sin_8;
            const LANES(court_ring_round_8_out) _o391 =
                LANES(court_ring_round_8)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, p_wire_radius);
            near_8 = _o391.near_8;
            omega_8 = _o391.omega_8;
            around_8 = _o391.around_8;
            tilted_8 = _o391.tilted_8;
            pressed_8 = _o391.pressed_8;
            cosine_9 = _o391.cosine_9;
            sine_9 = _o391.sine_9;
            climb_9 = _o391.climb_9;
            along_9 = _o391.along_9;
            turn_rate_9 = _o391.turn_rate_9;
            cos_9 = _o391.cos_9;
            sin_9 = _o391.sin_9;
            const LANES(court_ring_round_9_out) _o392 =
                LANES(court_ring_round_9)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            near_9 = _o392.near_9;
            omega_9 = _o392.omega_9;
            around_9 = _o392.around_9;
            tilted_9 = _o392.tilted_9;
            pressed_9 = _o392.pressed_9;
            cosine_10 = _o392.cosine_10;
            sine_10 = _o392.sine_10;
            climb_10 = _o392.climb_10;
            along_10 = _o392.along_10;
            turn_rate_10 = _o392.turn_rate_10;
            cos_10 = _o392.cos_10;
            sin_10 = _o392.sin_10;
            const LANES(court_ring_round_10_out) _o393 =
                LANES(court_ring_round_10)(along_0, along_1, along_10, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            near_10 = _o393.near_10;
            omega_10 = _o393.omega_10;
            around_10 = _o393.around_10;
            tilted_10 = _o393.tilted_10;
            pressed_10 = _o393.pressed_10;
            cosine_11 = _o393.cosine_11;
            sine_11 = _o393.sine_11;
            climb_11 = _o393.climb_11;
            along_11 = _o393.along_11;
            turn_rate_11 = _o393.turn_rate_11;
            cos_11 = _o393.cos_11;
            sin_11 = _o393.sin_11;
            const LANES(court_ring_round_11_out) _o394 =
                LANES(court_ring_round_11)(along_0, along_1, along_10, along_11, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_10, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_10, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_10, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_10, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            cosine_12 = _o394.cosine_12;
            sine_12 = _o394.sine_12;
            climb_12 = _o394.climb_12;
            along_12 = _o394.along_12;
            turn_rate_12 = _o394.turn_rate_12;
            cos_12 = _o394.cos_12;
            sin_12 = _o394.sin_12;
            const LANES(court_ring_round_moved_out) _o395 =
                LANES(court_ring_round_moved)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_12, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_12, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_12, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_12, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, stride, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_12, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            far_x = _o395.x;
            far_y = _o395.y;
            far_z = _o395.z;
            far_vx = _o395.vx;
            far_vy = _o395.vy;
            far_vz = _o395.vz;
            far_wx = _o395.wx;
            far_wy = _o395.wy;
            far_wz = _o395.wz;
            const LANES(court_compared_out) _o396 =
                LANES(court_compared)(apart, p_ball_radius, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_x, far_y, far_z, vx, vy, vz, wx, wy, wz, x, y, z);
            dx = _o396.dx;
            dy = _o396.dy;
            dz = _o396.dz;
            dvx = _o396.dvx;
            dvy = _o396.dvy;
            dvz = _o396.dvz;
            dwx = _o396.dwx;
            dwy = _o396.dwy;
            dwz = _o396.dwz;
            const LANES(court_rolled_on_out) _o397 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o397.clock;
            circling = _o397.rolling;
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
        const LANES(court_rejoined_out) _o398 =
            LANES(court_rejoined)(circling, rolling);
        rolling = _o398.rolling;
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
        const LANES(court_ring_normal_out) _o543 =
            LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
        V nx = _o543.nx;
        V ny = _o543.ny;
        V nz = _o543.nz;
        const LANES(court_here_out) _o544 =
            LANES(court_here)(K(1.0), which);
        M here = _o544.here;
        const M _m545 = lanes_both(rows, here);
        {
            const LANES(court_backboard_normal_out) _o546 =
                LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
            nx = lanes_select(_m545, _o546.nx, nx);
            ny = lanes_select(_m545, _o546.ny, ny);
            nz = lanes_select(_m545, _o546.nz, nz);
        }
        const LANES(court_here_out) _o547 =
            LANES(court_here)(K(2.0), which);
        here = _o547.here;
        const M _m548 = lanes_both(rows, here);
        {
            const LANES(court_bridge_normal_out) _o549 =
                LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
            nx = lanes_select(_m548, _o549.nx, nx);
            ny = lanes_select(_m548, _o549.ny, ny);
            nz = lanes_select(_m548, _o549.nz, nz);
        }
        const LANES(court_nearly_out) _o550 =
            LANES(court_nearly)(p_ball_radius, p_gravity, nx, ny, nz, vx, vy, vz);
        M nearly = _o550.nearly;
        const LANES(court_gripped_out) _o551 =
            LANES(court_gripped)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
        V rolled_x = _o551.rolled_x;
        V rolled_y = _o551.rolled_y;
        V rolled_z = _o551.rolled_z;
        V slip = _o551.slip;
        V bounce = _o551.bounce;
        const LANES(court_here_out) _o552 =
            LANES(court_here)(K(0.0), which);
        here = _o552.here;
        const M _m553 = lanes_both(rows, here);
        if (lanes_any(_m553)) {
            const LANES(court_ring_turning_out) _o554 =
                LANES(court_ring_turning)(p_ball_radius, p_ring_radius, rolled_x, rolled_y, rolled_z, p_wire_radius, x, y);
            V turning_x = _o554.turning_x;
            V turning_y = _o554.turning_y;
            V turning_z = _o554.turning_z;
            const LANES(court_pressed_on_out) _o555 =
                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
            V press = _o555.press;
            V weight = _o555.weight;
            V drag = _o555.drag;
            V thrust_x = _o555.thrust_x;
            V thrust_y = _o555.thrust_y;
            V thrust_z = _o555.thrust_z;
            const LANES(court_alone_out) _o556 =
                LANES(court_alone)();
            V nearest = _o556.nearest;
            V wedge = _o556.wedge;
            const LANES(court_backboard_closing_out) _o557 =
                LANES(court_backboard_closing)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z);
            V gap = _o557.gap;
            V nearing = _o557.nearing;
            V swerve = _o557.swerve;
            V facing = _o557.facing;
            const LANES(court_neared_body_out) _o558 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o558.nearest;
            wedge = _o558.wedge;
            const LANES(court_bridge_closing_out) _o559 =
                LANES(court_bridge_closing)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
            gap = _o559.gap;
            nearing = _o559.nearing;
            swerve = _o559.swerve;
            facing = _o559.facing;
            const LANES(court_neared_body_out) _o560 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o560.nearest;
            wedge = _o560.wedge;
            const LANES(court_end_beside_out) _o561 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o561.gap;
            const LANES(court_neared_out) _o562 =
                LANES(court_neared)(gap, nearest);
            nearest = _o562.nearest;
            const LANES(court_ring_parting_out) _o563 =
                LANES(court_ring_parting)(p_gravity, p_ring_radius, vx, vy, vz, x, y, z);
            V lift = _o563.lift;
            const LANES(court_ring_impact_settling_out) _o564 =
                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_ring_friction, p_ring_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz);
            M settles = _o564.settles;
            M lodges = _o564.lodges;
            M slides = _o564.slides;
            M parts = _o564.parts;
            assured = lanes_select(_m553, _o564.assured, assured);
            M unsure = _o564.unsure;
            const LANES(court_settled_out) _o565 =
                LANES(court_settled)(K(0.0), lodges, nearly, outcome, parts, settles, slides, uncertain, unsure);
            mode = lanes_select(_m553, _o565.mode, mode);
            held = lanes_select(_m553, _o565.held, held);
            outcome = lanes_select(_m553, _o565.outcome, outcome);
            slip_left = lanes_select(_m553, _o565.slip_left, slip_left);
            uncertain = lanes_select(_m553, _o565.uncertain, uncertain);
        }
        const LANES(court_here_out) _o566 =
            LANES(court_here)(K(1.0), which);
        here = _o566.here;
        const M _m567 = lanes_both(rows, here);
        if (lanes_any(_m567)) {
            const LANES(court_backboard_turning_out) _o568 =
                LANES(court_backboard_turning)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, rolled_x, rolled_y, rolled_z, x, y, z);
            V turning_x = _o568.turning_x;
            V turning_y = _o568.turning_y;
            V turning_z = _o568.turning_z;
            const LANES(court_pressed_on_out) _o569 =
                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
            V press = _o569.press;
            V weight = _o569.weight;
            V drag = _o569.drag;
            V thrust_x = _o569.thrust_x;
            V thrust_y = _o569.thrust_y;
            V thrust_z = _o569.thrust_z;
            const LANES(court_alone_out) _o570 =
                LANES(court_alone)();
            V nearest = _o570.nearest;
            V wedge = _o570.wedge;
            const LANES(court_ring_closing_out) _o571 =
                LANES(court_ring_closing)(p_ball_radius, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
            V gap = _o571.gap;
            V nearing = _o571.nearing;
            V swerve = _o571.swerve;
            V facing = _o571.facing;
            const LANES(court_neared_body_out) _o572 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o572.nearest;
            wedge = _o572.wedge;
            const LANES(court_bridge_closing_out) _o573 =
                LANES(court_bridge_closing)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
            gap = _o573.gap;
            nearing = _o573.nearing;
            swerve = _o573.swerve;
            facing = _o573.facing;
            const LANES(court_neared_body_out) _o574 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o574.nearest;
            wedge = _o574.wedge;
            const LANES(court_end_beside_out) _o575 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o575.gap;
            const LANES(court_neared_out) _o576 =
                LANES(court_neared)(gap, nearest);
            nearest = _o576.nearest;
            const LANES(court_backboard_parting_out) _o577 =
                LANES(court_backboard_parting)(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, vx, vy, vz, x, y, z);
            V lift = _o577.lift;
            const LANES(court_ring_impact_settling_out) _o578 =
                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_backboard_friction, p_backboard_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz);
            M settles = _o578.settles;
            M lodges = _o578.lodges;
            M slides = _o578.slides;
            M parts = _o578.parts;
            assured = lanes_select(_m567, _o578.assured, assured);
            M unsure = _o578.unsure;
            const LANES(court_settled_out) _o579 =
                LANES(court_settled)(K(1.0), lodges, nearly, outcome, parts, settles, slides, uncertain, unsure);
            mode = lanes_select(_m567, _o579.mode, mode);
            held = lanes_select(_m567, _o579.held, held);
            outcome = lanes_select(_m567, _o579.outcome, outcome);
            slip_left = lanes_select(_m567, _o579.slip_left, slip_left);
            uncertain = lanes_select(_m567, _o579.uncertain, uncertain);
        }
        const LANES(court_here_out) _o580 =
            LANES(court_here)(K(2.0), which);
        here = _o580.here;
        const M _m581 = lanes_both(rows, here);
        if (lanes_any(_m581)) {
            const LANES(court_bridge_turning_out) _o582 =
                LANES(court_bridge_turning)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, rolled_x, rolled_y, rolled_z, p_wire_radius, x, y, z);
            V turning_x = _o582.turning_x;
            V turning_y = _o582.turning_y;
            V turning_z = _o582.turning_z;
            const LANES(court_pressed_on_out) _o583 =
                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
            V press = _o583.press;
            V weight = _o583.weight;
            V drag = _o583.drag;
            V thrust_x = _o583.thrust_x;
            V thrust_y = _o583.thrust_y;
            V thrust_z = _o583.thrust_z;
            const LANES(court_alone_out) _o584 =
                LANES(court_alone)();
            V nearest = _o584.nearest;
            V wedge = _o584.wedge;
            const LANES(court_ring_closing_out) _o585 =
                LANES(court_ring_closing)(p_ball_radius, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
            V gap = _o585.gap;
            V nearing = _o585.nearing;
            V swerve = _o585.swerve;
            V facing = _o585.facing;
            const LANES(court_neared_body_out) _o586 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o586.nearest;
            wedge = _o586.wedge;
            const LANES(court_backboard_closing_out) _o587 =
                LANES(court_backboard_closing)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z);
            gap = _o587.gap;
            nearing = _o587.nearing;
            swerve = _o587.swerve;
            facing = _o587.facing;
            const LANES(court_neared_body_out) _o588 =
                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
            nearest = _o588.nearest;
            wedge = _o588.wedge;
            const LANES(court_end_beside_out) _o589 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o589.gap;
            const LANES(court_neared_out) _o590 =
                LANES(court_neared)(gap, nearest);
            nearest = _o590.nearest;
            const LANES(court_bridge_parting_out) _o591 =
                LANES(court_bridge_parting)(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            V lift = _o591.lift;
            const LANES(court_ring_impact_settling_out) _o592 =
                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_bridge_friction, p_bridge_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz);
            M settles = _o592.settles;
            M lodges = _o592.lodges;
            M slides = _o592.slides;
            M parts = _o592.parts;
            assured = lanes_select(_m581, _o592.assured, assured);
            M unsure = _o592.unsure;
            const LANES(court_settled_out) _o593 =
                LANES(court_settled)(K(2.0), lodges, nearly, outcome, parts, settles, slides, uncertain, unsure);
            mode = lanes_select(_m581, _o593.mode, mode);
            held = lanes_select(_m581, _o593.held, held);
            outcome = lanes_select(_m581, _o593.outcome, outcome);
            slip_left = lanes_select(_m581, _o593.slip_left, slip_left);
            uncertain = lanes_select(_m581, _o593.uncertain, uncertain);
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
    size_t begun = 0, shots = 0;

    lists->waiting = 0;
    if (job->shots == 0)
        return;
    if (recording)
        memset(job->results->event_counts, 0, job->shots * sizeof(int32_t));
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
        int following = shots == 0;
        if (lists->waiting + LANES_WIDTH > LANES_SHOTS || (shots == 0 && begun == job->shots)) {
            shots += LANES(court_bounded_resume)(lists, shots, job);
            following = 0;
        }
        const size_t fresh = shots;
        if (begun < job->shots && shots < LANES_SHOTS) {
            const size_t room = LANES_SHOTS - shots, left = job->shots - begun;
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
            LANES(court_ahead)(job, begun + i);
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
                LANES(court_meeting_plane)(bend, rate, time);
            M arrives = _o12.arrives;
            V ceiling = _o12.ceiling;
            const LANES(court_end_margin_out) _o13 =
                LANES(court_end_margin)(time, extent, speed, position_error, velocity_error, p_gravity, p_end_depth);
            V margin = _o13.margin;
            const LANES(court_crossing_out) _o14 =
                LANES(court_crossing)(margin, K(0.0), rate, ceiling);
            V clearance = _o14.clearance;
            V delay = _o14.delay;
            const LANES(court_timely_out) _o15 =
                LANES(court_timely)(arrives, delay, late, time, when);
            M possible = _o15.possible;
            const LANES(court_end_margin_out) _o16 =
                LANES(court_end_margin)(apex, extent, speed, position_error, velocity_error, p_gravity, p_end_depth);
            margin = _o16.margin;
            const LANES(court_grazed_out) _o17 =
                LANES(court_grazed)(apex, doubt, height, margin);
            doubt = _o17.doubt;
            const M _m18 = lanes_both(rows, possible);
            {
                const LANES(court_crossed_out) _o19 =
                    LANES(court_crossed)(arrives, clearance, doubt, time);
                doubt = lanes_select(_m18, _o19.doubt, doubt);
                const LANES(court_tied_out) _o20 =
                    LANES(court_tied)(arrives, delay, doubt, late, time, when);
                doubt = lanes_select(_m18, _o20.doubt, doubt);
                late = lanes_select(_m18, _o20.late, late);
                const LANES(court_sooner_out) _o21 =
                    LANES(court_sooner)(arrives, K(3.0), time, when, which);
                when = lanes_select(_m18, _o21.when, when);
                which = lanes_select(_m18, _o21.which, which);
            }
            const LANES(court_horizon_out) _o22 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o22.horizon;
            V pad = _o22.pad;
            const LANES(court_ring_clear_out) _o23 =
                LANES(court_ring_clear)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V clear = _o23.clear;
            const LANES(court_opens_in_flight_out) _o24 =
                LANES(court_opens_in_flight)(clear, kept);
            M open = _o24.open;
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
            const LANES(court_beginning_out) _o25 =
                LANES(court_beginning)();
            V share = _o25.share;
            V arrival = _o25.arrival;
            M certain = _o25.certain;
            const LANES(court_left_out) _o26 =
                LANES(court_left)(K(0.0), last);
            V leaving = _o26.leaving;
            const LANES(court_ring_opened_out) _o27 =
                LANES(court_ring_opened)(lanes_narrow(until), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
            S onset = _o27.t;
            S wide_end = _o27.end;
            M searching = _o27.searching;
            S wide_low1 = _o27.low1;
            S wide_high1 = _o27.high1;
            S wide_low2 = _o27.low2;
            S wide_high2 = _o27.high2;
            S lapsed = _o27.latest;
            M sound = _o27.sound;
            const LANES(court_opened_out) _o28 =
                LANES(court_opened)(lanes_wide(lapsed), lanes_wide(onset));
            V since = _o28.time;
            V latest = _o28.latest;
            const LANES(court_ring_started_out) _o29 =
                LANES(court_ring_started)(x, y, z, vx, vy, vz, p_ring_radius);
            V rho_start = _o29.rho_start;
            V parting = _o29.parting;
            V drift = _o29.drift;
            const LANES(court_flight_out) _o30 =
                LANES(court_flight)(since, x, y, z, vx, vy, vz, p_gravity);
            V near_x = _o30.x;
            V near_y = _o30.y;
            V near_z = _o30.z;
            V near_vz = _o30.vz;
            const LANES(court_ring_grain_out) _o31 =
                LANES(court_ring_grain)(onset, wide_end, lanes_narrow(leaving), lapsed, lanes_narrow(near_x), lanes_narrow(near_y), lanes_narrow(near_z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(near_vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(parting), lanes_narrow(drift), wide_low1, wide_high1, wide_low2, wide_high2, lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
            S short_share = _o31.share;
            S short_t = _o31.t;
            S short_end = _o31.end;
            S short_x = _o31.x;
            S short_y = _o31.y;
            S short_z = _o31.z;
            S short_vx = _o31.vx;
            S short_vy = _o31.vy;
            S short_vz = _o31.vz;
            S short_steady = _o31.steady;
            S short_swing = _o31.swing;
            S short_rho_start = _o31.rho_start;
            S short_ceiling = _o31.ceiling;
            S short_flat = _o31.flat;
            S short_tilt = _o31.tilt;
            S short_jerk = _o31.jerk;
            S short_grit = _o31.grit;
            S short_parting = _o31.parting;
            S short_drift = _o31.drift;
            S short_rate_margin = _o31.rate_margin;
            S short_low1 = _o31.low1;
            S short_high1 = _o31.high1;
            S short_low2 = _o31.low2;
            S short_high2 = _o31.high2;
            M fits = _o31.fits;
            const LANES(court_coarse_out) _o32 =
                LANES(court_coarse)(lanes_wide(short_ceiling), fits, lanes_wide(short_flat), lanes_wide(short_rate_margin), searching, lanes_wide(short_share), sound);
            M leaping = _o32.leaping;
            searching = _o32.searching;
            M served = _o32.served;
            V ceiling = _o32.ceiling;
            V flat = _o32.flat;
            V tilt = _o32.tilt;
            V allowing = _o32.allowing;
            const LANES(court_allowance_out) _o33 =
                LANES(court_allowance)(allowing, latest, extent, speed, position_error, velocity_error, p_gravity);
            V excess = _o33.excess;
            const LANES(court_ring_lost_out) _o34 =
                LANES(court_ring_lost)(until, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V lost = _o34.lost;
            const LANES(court_beyond_out) _o35 =
                LANES(court_beyond)(doubt, excess, late, lost, pad);
            doubt = _o35.doubt;
            const M _m36 = lanes_both(rows, leaping);
            if (lanes_any(_m36)) {
                const LANES(court_ring_leap_out) _o37 =
                    LANES(court_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
                short_t = singles_select(singles_of(_m36), _o37.t, short_t);
                short_end = singles_select(singles_of(_m36), _o37.end, short_end);
                certain = lanes_choose(_m36, _o37.certain, certain);
                leaping = lanes_choose(_m36, _o37.leaping, leaping);
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
                const LANES(court_ring_leap_out) _o38 =
                    LANES(court_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
                short_t = _o38.t;
                short_end = _o38.end;
                M certain = _o38.certain;
                leaping = _o38.leaping;
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
            const LANES(court_leapt_out) _o39 =
                LANES(court_leapt)(arrival, certain, lanes_wide(short_t), searching, served, since);
            arrival = _o39.arrival;
            V t = _o39.t;
            searching = _o39.searching;
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
            const LANES(court_ring_prepare_out) _o40 =
                LANES(court_ring_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V steady = _o40.steady;
            V swing = _o40.swing;
            V rho_start = _o40.rho_start;
            V low0 = _o40.low0;
            V high0 = _o40.high0;
            V low1 = _o40.low1;
            V high1 = _o40.high1;
            V low2 = _o40.low2;
            V high2 = _o40.high2;
            V ceiling = _o40.ceiling;
            V latest = _o40.latest;
            const LANES(court_allowance_out) _o41 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
            V position_level = _o41.position_level;
            V velocity_level = _o41.velocity_level;
            const LANES(court_ring_margins_out) _o42 =
                LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V flat = _o42.margin;
            V tilt = _o42.leaving_margin;
            V rate_slack = _o42.rate_margin;
            const LANES(court_ring_enter_out) _o43 =
                LANES(court_ring_enter)(t, K(0.0), high0, high1, high2, low0, low1, low2, t);
            t = _o43.t;
            V end = _o43.end;
            M searching = _o43.searching;
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
                const LANES(court_nearby_out) _o44 =
                    LANES(court_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = _o44.leaving;
                V margin = _o44.margin;
                const LANES(court_ring_advance_out) _o45 =
                    LANES(court_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V gap = _o45.gap;
                V rate = _o45.rate;
                V bend = _o45.bend;
                V step = _o45.step;
                V next = _o45.next;
                V clearance = _o45.clearance;
                const LANES(court_struck_out) _o46 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o46.hit;
                M sure = _o46.sure;
                M vague = _o46.vague;
                const M _m47 = lanes_both(active, vague);
                if (lanes_any(_m47)) {
                    const LANES(court_finer_out) _o48 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m47, _o48.share, share);
                    const LANES(court_allowance_out) _o49 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o49.position_level;
                    V velocity_level = _o49.velocity_level;
                    V excess = _o49.excess;
                    const LANES(court_ring_margins_out) _o50 =
                        LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    flat = lanes_select(_m47, _o50.margin, flat);
                    tilt = lanes_select(_m47, _o50.leaving_margin, tilt);
                    rate_slack = lanes_select(_m47, _o50.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o51 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m47, _o51.doubt, doubt);
                }
                const LANES(court_advanced_out) _o52 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o52.arrival;
                certain = _o52.certain;
                M exhausted = _o52.exhausted;
                searching = _o52.searching;
                t = _o52.t;
                const M _m53 = lanes_both(active, exhausted);
                {
                    const LANES(court_ring_enter_out) _o54 =
                        LANES(court_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m53, _o54.t, t);
                    end = lanes_select(_m53, _o54.end, end);
                    searching = lanes_choose(_m53, _o54.searching, searching);
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
            const LANES(court_questioned_out) _o55 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o55.doubt;
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
            const LANES(court_found_out) _o56 =
                LANES(court_found)(arrival);
            M arrives = _o56.arrives;
            M refining = _o56.refining;
            V rate = _o56.rate;
            const LANES(court_nearby_out) _o57 =
                LANES(court_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o57.leaving;
            const M _m58 = lanes_both(rows, refining);
            if (lanes_any(_m58)) {
                const LANES(court_ring_refine_out) _o59 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V refined = _o59.time;
                V gap = _o59.gap;
                rate = lanes_select(_m58, _o59.rate, rate);
                const LANES(court_polished_out) _o60 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m58, _o60.arrival, arrival);
                refining = lanes_choose(_m58, _o60.refining, refining);
            }
            const M _m61 = lanes_both(rows, refining);
            if (lanes_any(_m61)) {
                const LANES(court_ring_refine_out) _o62 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V refined = _o62.time;
                V gap = _o62.gap;
                rate = lanes_select(_m61, _o62.rate, rate);
                const LANES(court_polished_out) _o63 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m61, _o63.arrival, arrival);
                refining = lanes_choose(_m61, _o63.refining, refining);
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
                const LANES(court_ring_refine_out) _o64 =
                    LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V refined = _o64.time;
                V gap = _o64.gap;
                V rate = _o64.rate;
                const LANES(court_polished_out) _o65 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o65.arrival;
                refining = _o65.refining;
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
            const LANES(court_ring_margins_out) _o66 =
                LANES(court_ring_margins)(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V flat = _o66.margin;
            V tilt = _o66.leaving_margin;
            V rate_margin = _o66.rate_margin;
            const LANES(court_own_margin_out) _o67 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o67.margin;
            const LANES(court_crossing_out) _o68 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o68.clearance;
            V delay = _o68.delay;
            const LANES(court_landed_out) _o69 =
                LANES(court_landed)(arrival);
            V time = _o69.time;
            const LANES(court_landed_surely_out) _o70 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o70.delay;
            doubt = _o70.doubt;
            const LANES(court_tied_out) _o71 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o71.doubt;
            late = _o71.late;
            const LANES(court_sooner_out) _o72 =
                LANES(court_sooner)(arrives, K(0.0), time, when, which);
            when = _o72.when;
            which = _o72.which;
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
            const LANES(court_horizon_out) _o73 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o73.horizon;
            V pad = _o73.pad;
            const LANES(court_swept_out) _o74 =
                LANES(court_swept)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, late, pad, p_gravity);
            V middle_x = _o74.middle_x;
            V middle_y = _o74.middle_y;
            V middle_z = _o74.middle_z;
            V reach_x = _o74.reach_x;
            V reach_y = _o74.reach_y;
            V reach_z = _o74.reach_z;
            const LANES(court_backboard_near_out) _o75 =
                LANES(court_backboard_near)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
            M reachable = _o75.near;
            const LANES(court_reachable_in_flight_out) _o76 =
                LANES(court_reachable_in_flight)(kept, reachable);
            reachable = _o76.reachable;
            lanes_store(lists->middle_x + i, middle_x);
            lanes_store(lists->middle_y + i, middle_y);
            lanes_store(lists->middle_z + i, middle_z);
            lanes_store(lists->reach_x + i, reach_x);
            lanes_store(lists->reach_y + i, reach_y);
            lanes_store(lists->reach_z + i, reach_z);
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
            const LANES(court_horizon_out) _o77 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o77.horizon;
            V pad = _o77.pad;
            const LANES(court_backboard_prepare_out) _o78 =
                LANES(court_backboard_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V low0 = _o78.low0;
            V high0 = _o78.high0;
            V low1 = _o78.low1;
            V high1 = _o78.high1;
            V ceiling = _o78.ceiling;
            V latest = _o78.latest;
            V lost = _o78.lost;
            const LANES(court_beginning_out) _o79 =
                LANES(court_beginning)();
            V share = _o79.share;
            V arrival = _o79.arrival;
            M certain = _o79.certain;
            const LANES(court_allowance_out) _o80 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
            V position_level = _o80.position_level;
            V velocity_level = _o80.velocity_level;
            V excess = _o80.excess;
            const LANES(court_backboard_margins_out) _o81 =
                LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V flat = _o81.margin;
            V tilt = _o81.leaving_margin;
            V rate_slack = _o81.rate_margin;
            const LANES(court_backboard_enter_out) _o82 =
                LANES(court_backboard_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o82.t;
            V end = _o82.end;
            M searching = _o82.searching;
            const LANES(court_beyond_windows_out) _o83 =
                LANES(court_beyond_windows)(doubt, excess, late, lost, pad, searching);
            doubt = _o83.doubt;
            const M _m84 = lanes_both(rows, searching);
            if (lanes_any(_m84)) {
                const LANES(court_nearby_out) _o85 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o85.leaving;
                V margin = _o85.margin;
                const LANES(court_backboard_advance_out) _o86 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V gap = _o86.gap;
                V rate = _o86.rate;
                V bend = _o86.bend;
                V step = _o86.step;
                V next = _o86.next;
                V clearance = _o86.clearance;
                const LANES(court_struck_or_still_out) _o87 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o87.hit;
                M sure = _o87.sure;
                M vague = _o87.vague;
                const M _m88 = lanes_both(_m84, vague);
                if (lanes_any(_m88)) {
                    const LANES(court_finer_out) _o89 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m88, _o89.share, share);
                    const LANES(court_allowance_out) _o90 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o90.position_level;
                    V velocity_level = _o90.velocity_level;
                    V excess = _o90.excess;
                    const LANES(court_backboard_margins_out) _o91 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                    flat = lanes_select(_m88, _o91.margin, flat);
                    tilt = lanes_select(_m88, _o91.leaving_margin, tilt);
                    rate_slack = lanes_select(_m88, _o91.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o92 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m88, _o92.doubt, doubt);
                }
                const LANES(court_advanced_out) _o93 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = lanes_select(_m84, _o93.arrival, arrival);
                certain = lanes_choose(_m84, _o93.certain, certain);
                M exhausted = _o93.exhausted;
                searching = lanes_choose(_m84, _o93.searching, searching);
                t = lanes_select(_m84, _o93.t, t);
                const M _m94 = lanes_both(_m84, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o95 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m94, _o95.t, t);
                    end = lanes_select(_m94, _o95.end, end);
                    searching = lanes_choose(_m94, _o95.searching, searching);
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
                const LANES(court_nearby_out) _o96 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o96.leaving;
                V margin = _o96.margin;
                const LANES(court_backboard_advance_out) _o97 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
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
                const M _m99 = lanes_both(active, vague);
                if (lanes_any(_m99)) {
                    const LANES(court_finer_out) _o100 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m99, _o100.share, share);
                    const LANES(court_allowance_out) _o101 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o101.position_level;
                    V velocity_level = _o101.velocity_level;
                    V excess = _o101.excess;
                    const LANES(court_backboard_margins_out) _o102 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                    flat = lanes_select(_m99, _o102.margin, flat);
                    tilt = lanes_select(_m99, _o102.leaving_margin, tilt);
                    rate_slack = lanes_select(_m99, _o102.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o103 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m99, _o103.doubt, doubt);
                }
                const LANES(court_advanced_out) _o104 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o104.arrival;
                certain = _o104.certain;
                M exhausted = _o104.exhausted;
                searching = _o104.searching;
                t = _o104.t;
                const M _m105 = lanes_both(active, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o106 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m105, _o106.t, t);
                    end = lanes_select(_m105, _o106.end, end);
                    searching = lanes_choose(_m105, _o106.searching, searching);
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
            const LANES(court_questioned_out) _o107 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o107.doubt;
            const LANES(court_found_out) _o108 =
                LANES(court_found)(arrival);
            M arrives = _o108.arrives;
            M refining = _o108.refining;
            V rate = _o108.rate;
            const LANES(court_nearby_out) _o109 =
                LANES(court_nearby)(flat, K(1.0), last, arrival, tilt);
            V leaving = _o109.leaving;
            const M _m110 = lanes_both(rows, refining);
            if (lanes_any(_m110)) {
                const LANES(court_backboard_refine_out) _o111 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V refined = _o111.time;
                V gap = _o111.gap;
                rate = lanes_select(_m110, _o111.rate, rate);
                const LANES(court_polished_out) _o112 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m110, _o112.arrival, arrival);
                refining = lanes_choose(_m110, _o112.refining, refining);
            }
            const M _m113 = lanes_both(rows, refining);
            if (lanes_any(_m113)) {
                const LANES(court_backboard_refine_out) _o114 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V refined = _o114.time;
                V gap = _o114.gap;
                rate = lanes_select(_m113, _o114.rate, rate);
                const LANES(court_polished_out) _o115 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m113, _o115.arrival, arrival);
                refining = lanes_choose(_m113, _o115.refining, refining);
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
                const LANES(court_backboard_refine_out) _o116 =
                    LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V refined = _o116.time;
                V gap = _o116.gap;
                V rate = _o116.rate;
                const LANES(court_polished_out) _o117 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o117.arrival;
                refining = _o117.refining;
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
            const LANES(court_backboard_margins_out) _o118 =
                LANES(court_backboard_margins)(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V flat = _o118.margin;
            V tilt = _o118.leaving_margin;
            V rate_margin = _o118.rate_margin;
            const LANES(court_own_margin_out) _o119 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o119.margin;
            const LANES(court_crossing_out) _o120 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o120.clearance;
            V delay = _o120.delay;
            const LANES(court_landed_out) _o121 =
                LANES(court_landed)(arrival);
            V time = _o121.time;
            const LANES(court_landed_surely_out) _o122 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o122.delay;
            doubt = _o122.doubt;
            const LANES(court_tied_out) _o123 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o123.doubt;
            late = _o123.late;
            const LANES(court_sooner_out) _o124 =
                LANES(court_sooner)(arrives, K(1.0), time, when, which);
            when = _o124.when;
            which = _o124.which;
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
            V middle_x = lanes_load(lists->middle_x + i);
            V middle_y = lanes_load(lists->middle_y + i);
            V middle_z = lanes_load(lists->middle_z + i);
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_bridge_depth = lanes_load(lists->p_bridge_depth + (i & varying));
            const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
            const V p_wire_radius = lanes_load(lists->p_wire_radius + (i & varying));
            V position_error = lanes_load(lists->position_error + i);
            V reach_x = lanes_load(lists->reach_x + i);
            V reach_y = lanes_load(lists->reach_y + i);
            V reach_z = lanes_load(lists->reach_z + i);
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
            const LANES(court_bridge_near_out) _o125 =
                LANES(court_bridge_near)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
            M reachable = _o125.near;
            const LANES(court_reachable_in_flight_out) _o126 =
                LANES(court_reachable_in_flight)(kept, reachable);
            reachable = _o126.reachable;
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
            const LANES(court_horizon_out) _o127 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o127.horizon;
            V pad = _o127.pad;
            const LANES(court_bridge_prepare_out) _o128 =
                LANES(court_bridge_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V low0 = _o128.low0;
            V high0 = _o128.high0;
            V low1 = _o128.low1;
            V high1 = _o128.high1;
            V ceiling = _o128.ceiling;
            V latest = _o128.latest;
            V lost = _o128.lost;
            const LANES(court_beginning_out) _o129 =
                LANES(court_beginning)();
            V share = _o129.share;
            V arrival = _o129.arrival;
            M certain = _o129.certain;
            const LANES(court_allowance_out) _o130 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
            V position_level = _o130.position_level;
            V velocity_level = _o130.velocity_level;
            V excess = _o130.excess;
            const LANES(court_bridge_margins_out) _o131 =
                LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V flat = _o131.margin;
            V tilt = _o131.leaving_margin;
            V rate_slack = _o131.rate_margin;
            const LANES(court_bridge_enter_out) _o132 =
                LANES(court_bridge_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o132.t;
            V end = _o132.end;
            M searching = _o132.searching;
            const LANES(court_beyond_windows_out) _o133 =
                LANES(court_beyond_windows)(doubt, excess, late, lost, pad, searching);
            doubt = _o133.doubt;
            const M _m134 = lanes_both(rows, searching);
            if (lanes_any(_m134)) {
                const LANES(court_nearby_out) _o135 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o135.leaving;
                V margin = _o135.margin;
                const LANES(court_bridge_advance_out) _o136 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V gap = _o136.gap;
                V rate = _o136.rate;
                V bend = _o136.bend;
                V step = _o136.step;
                V next = _o136.next;
                V clearance = _o136.clearance;
                const LANES(court_struck_or_still_out) _o137 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o137.hit;
                M sure = _o137.sure;
                M vague = _o137.vague;
                const M _m138 = lanes_both(_m134, vague);
                if (lanes_any(_m138)) {
                    const LANES(court_finer_out) _o139 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m138, _o139.share, share);
                    const LANES(court_allowance_out) _o140 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o140.position_level;
                    V velocity_level = _o140.velocity_level;
                    V excess = _o140.excess;
                    const LANES(court_bridge_margins_out) _o141 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                    flat = lanes_select(_m138, _o141.margin, flat);
                    tilt = lanes_select(_m138, _o141.leaving_margin, tilt);
                    rate_slack = lanes_select(_m138, _o141.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o142 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m138, _o142.doubt, doubt);
                }
                const LANES(court_advanced_out) _o143 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = lanes_select(_m134, _o143.arrival, arrival);
                certain = lanes_choose(_m134, _o143.certain, certain);
                M exhausted = _o143.exhausted;
                searching = lanes_choose(_m134, _o143.searching, searching);
                t = lanes_select(_m134, _o143.t, t);
                const M _m144 = lanes_both(_m134, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o145 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m144, _o145.t, t);
                    end = lanes_select(_m144, _o145.end, end);
                    searching = lanes_choose(_m144, _o145.searching, searching);
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
                const LANES(court_nearby_out) _o146 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o146.leaving;
                V margin = _o146.margin;
                const LANES(court_bridge_advance_out) _o147 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V gap = _o147.gap;
                V rate = _o147.rate;
                V bend = _o147.bend;
                V step = _o147.step;
                V next = _o147.next;
                V clearance = _o147.clearance;
                const LANES(court_struck_or_still_out) _o148 =
                    LANES(court_struck_or_still)(bend, clearance, end, gap, margin, next, rate, rate_slack, share, t);
                M hit = _o148.hit;
                M sure = _o148.sure;
                M vague = _o148.vague;
                const M _m149 = lanes_both(active, vague);
                if (lanes_any(_m149)) {
                    const LANES(court_finer_out) _o150 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m149, _o150.share, share);
                    const LANES(court_allowance_out) _o151 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o151.position_level;
                    V velocity_level = _o151.velocity_level;
                    V excess = _o151.excess;
                    const LANES(court_bridge_margins_out) _o152 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                    flat = lanes_select(_m149, _o152.margin, flat);
                    tilt = lanes_select(_m149, _o152.leaving_margin, tilt);
                    rate_slack = lanes_select(_m149, _o152.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o153 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m149, _o153.doubt, doubt);
                }
                const LANES(court_advanced_out) _o154 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o154.arrival;
                certain = _o154.certain;
                M exhausted = _o154.exhausted;
                searching = _o154.searching;
                t = _o154.t;
                const M _m155 = lanes_both(active, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o156 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m155, _o156.t, t);
                    end = lanes_select(_m155, _o156.end, end);
                    searching = lanes_choose(_m155, _o156.searching, searching);
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
            const LANES(court_questioned_out) _o157 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o157.doubt;
            const LANES(court_found_out) _o158 =
                LANES(court_found)(arrival);
            M arrives = _o158.arrives;
            M refining = _o158.refining;
            V rate = _o158.rate;
            const LANES(court_nearby_out) _o159 =
                LANES(court_nearby)(flat, K(2.0), last, arrival, tilt);
            V leaving = _o159.leaving;
            const M _m160 = lanes_both(rows, refining);
            if (lanes_any(_m160)) {
                const LANES(court_bridge_refine_out) _o161 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V refined = _o161.time;
                V gap = _o161.gap;
                rate = lanes_select(_m160, _o161.rate, rate);
                const LANES(court_polished_out) _o162 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m160, _o162.arrival, arrival);
                refining = lanes_choose(_m160, _o162.refining, refining);
            }
            const M _m163 = lanes_both(rows, refining);
            if (lanes_any(_m163)) {
                const LANES(court_bridge_refine_out) _o164 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V refined = _o164.time;
                V gap = _o164.gap;
                rate = lanes_select(_m163, _o164.rate, rate);
                const LANES(court_polished_out) _o165 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m163, _o165.arrival, arrival);
                refining = lanes_choose(_m163, _o165.refining, refining);
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
                const LANES(court_bridge_refine_out) _o166 =
                    LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V refined = _o166.time;
                V gap = _o166.gap;
                V rate = _o166.rate;
                const LANES(court_polished_out) _o167 =
                    LANES(court_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o167.arrival;
                refining = _o167.refining;
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
            const LANES(court_bridge_margins_out) _o168 =
                LANES(court_bridge_margins)(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V flat = _o168.margin;
            V tilt = _o168.leaving_margin;
            V rate_margin = _o168.rate_margin;
            const LANES(court_own_margin_out) _o169 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o169.margin;
            const LANES(court_crossing_out) _o170 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o170.clearance;
            V delay = _o170.delay;
            const LANES(court_landed_out) _o171 =
                LANES(court_landed)(arrival);
            V time = _o171.time;
            const LANES(court_landed_surely_out) _o172 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o172.delay;
            doubt = _o172.doubt;
            const LANES(court_tied_out) _o173 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o173.doubt;
            late = _o173.late;
            const LANES(court_sooner_out) _o174 =
                LANES(court_sooner)(arrives, K(2.0), time, when, which);
            when = _o174.when;
            which = _o174.which;
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
            const M _m175 = lanes_both(rows, limited);
            if (lanes_any(_m175)) {
                const LANES(court_expiry_out) _o176 =
                    LANES(court_expiry)(clock, doubt, late, time_error, time_limit, when, which);
                V time = _o176.time;
                V delay = _o176.delay;
                M arrives = _o176.arrives;
                doubt = lanes_select(_m175, _o176.doubt, doubt);
                const LANES(court_tied_out) _o177 =
                    LANES(court_tied)(arrives, delay, doubt, late, time, when);
                doubt = lanes_select(_m175, _o177.doubt, doubt);
                late = lanes_select(_m175, _o177.late, late);
                const LANES(court_sooner_out) _o178 =
                    LANES(court_sooner)(arrives, K(4.0), time, when, which);
                when = lanes_select(_m175, _o178.when, when);
                which = lanes_select(_m175, _o178.which, which);
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
            const LANES(court_departed_out) _o459 =
                LANES(court_departed)(K(3.0), which);
            M moves = _o459.moves;
            M ends = _o459.ends;
            M touches = _o459.touches;
            V reached = _o459.reached;
            M edge = _o459.edge;
            const LANES(court_body_of_out) _o460 =
                LANES(court_body_of)(which);
            V body = _o460.body;
            const M _m461 = lanes_both(rows, moves);
            if (lanes_any(_m461)) {
                const LANES(court_passing_doubt_out) _o462 =
                    LANES(court_passing_doubt)(when, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ring_radius, p_gravity);
                M unsure = _o462.unsure;
                const LANES(court_undecided_out) _o463 =
                    LANES(court_undecided)(uncertain, unsure);
                uncertain = lanes_select(_m461, _o463.uncertain, uncertain);
                const LANES(court_passing_out) _o464 =
                    LANES(court_passing)(through, when, x, y, z, vx, vy, vz, p_ring_radius, p_gravity);
                through = lanes_select(_m461, _o464.through, through);
                const LANES(court_flight_out) _o465 =
                    LANES(court_flight)(when, x, y, z, vx, vy, vz, p_gravity);
                x = lanes_select(_m461, _o465.x, x);
                y = lanes_select(_m461, _o465.y, y);
                z = lanes_select(_m461, _o465.z, z);
                vx = lanes_select(_m461, _o465.vx, vx);
                vy = lanes_select(_m461, _o465.vy, vy);
                vz = lanes_select(_m461, _o465.vz, vz);
                const LANES(court_ticked_out) _o466 =
                    LANES(court_ticked)(clock, when);
                clock = lanes_select(_m461, _o466.clock, clock);
            }
            const M _m467 = lanes_both(rows, limited);
            if (lanes_any(_m467)) {
                const LANES(court_expired_out) _o468 =
                    LANES(court_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m467, _o468.clock, clock);
                body = lanes_select(_m467, _o468.body, body);
                reached = lanes_select(_m467, _o468.reached, reached);
                ends = lanes_choose(_m467, _o468.ends, ends);
            }
            const LANES(court_unhopped_out) _o469 =
                LANES(court_unhopped)();
            M hopped = _o469.hopped;
            const M _m470 = lanes_both(rows, kept);
            if (lanes_any(_m470)) {
                const LANES(court_kept_on_out) _o471 =
                    LANES(court_kept_on)(began, body, clock, doubt, ends, held, last, reached, rests, rolling, rolls, which);
                body = lanes_select(_m470, _o471.body, body);
                reached = lanes_select(_m470, _o471.reached, reached);
                doubt = lanes_select(_m470, _o471.doubt, doubt);
                ends = lanes_choose(_m470, _o471.ends, ends);
                hopped = lanes_choose(_m470, _o471.hopped, hopped);
                last = lanes_select(_m470, _o471.last, last);
                mode = lanes_select(_m470, _o471.mode, mode);
                held = lanes_select(_m470, _o471.held, held);
                rolls = lanes_select(_m470, _o471.rolls, rolls);
            }
            const LANES(court_displacement_out) _o472 =
                LANES(court_displacement)(late, when, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_gravity, p_end_depth);
            V slack = _o472.margin;
            const LANES(court_here_out) _o473 =
                LANES(court_here)(K(3.0), which);
            M here = _o473.here;
            const M _m474 = lanes_both(rows, here);
            {
                const LANES(court_end_bounds_out) _o475 =
                    LANES(court_end_bounds)(x, y, p_ring_radius);
                V g0 = _o475.g0;
                const LANES(court_end_reached_out) _o476 =
                    LANES(court_end_reached)(g0, through);
                reached = lanes_select(_m474, _o476.reached, reached);
                const LANES(court_end_edge_out) _o477 =
                    LANES(court_end_edge)(g0, slack, through);
                edge = lanes_choose(_m474, _o477.edge, edge);
            }
            const LANES(court_doubted_in_contact_out) _o478 =
                LANES(court_doubted_in_contact)(assured, doubt, edge, last, late, uncertain, when, which);
            uncertain = _o478.uncertain;
            const LANES(court_accounted_out) _o479 =
                LANES(court_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o479.contacts;
            V outcome = _o479.outcome;
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
            const LANES(court_meeting_out) _o480 =
                LANES(court_meeting)(claims, ends, touches);
            M meeting = _o480.meeting;
            const LANES(court_unslowed_out) _o481 =
                LANES(court_unslowed)();
            M slow = _o481.slow;
            const M _m482 = lanes_both(rows, meeting);
            if (lanes_any(_m482)) {
                const LANES(court_end_normal_out) _o483 =
                    LANES(court_end_normal)();
                V nx = _o483.nx;
                V ny = _o483.ny;
                V nz = _o483.nz;
                const LANES(court_here_out) _o484 =
                    LANES(court_here)(K(0.0), which);
                M here = _o484.here;
                const M _m485 = lanes_both(_m482, here);
                {
                    const LANES(court_ring_normal_out) _o486 =
                        LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m485, _o486.nx, nx);
                    ny = lanes_select(_m485, _o486.ny, ny);
                    nz = lanes_select(_m485, _o486.nz, nz);
                    const LANES(court_counted_out) _o487 =
                        LANES(court_counted)(count_0);
                    count_0 = lanes_select(_m485, _o487.count, count_0);
                }
                const LANES(court_here_out) _o488 =
                    LANES(court_here)(K(1.0), which);
                here = _o488.here;
                const M _m489 = lanes_both(_m482, here);
                {
                    const LANES(court_backboard_normal_out) _o490 =
                        LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m489, _o490.nx, nx);
                    ny = lanes_select(_m489, _o490.ny, ny);
                    nz = lanes_select(_m489, _o490.nz, nz);
                    const LANES(court_counted_out) _o491 =
                        LANES(court_counted)(count_1);
                    count_1 = lanes_select(_m489, _o491.count, count_1);
                }
                const LANES(court_here_out) _o492 =
                    LANES(court_here)(K(2.0), which);
                here = _o492.here;
                const M _m493 = lanes_both(_m482, here);
                {
                    const LANES(court_bridge_normal_out) _o494 =
                        LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m493, _o494.nx, nx);
                    ny = lanes_select(_m493, _o494.ny, ny);
                    nz = lanes_select(_m493, _o494.nz, nz);
                    const LANES(court_counted_out) _o495 =
                        LANES(court_counted)(count_2);
                    count_2 = lanes_select(_m493, _o495.count, count_2);
                }
                const LANES(court_elsewhere_out) _o496 =
                    LANES(court_elsewhere)();
                V curving = _o496.curving;
                const LANES(court_anew_out) _o497 =
                    LANES(court_anew)();
                V left_nx = _o497.left_nx;
                V left_ny = _o497.left_ny;
                V left_nz = _o497.left_nz;
                const LANES(court_again_out) _o498 =
                    LANES(court_again)(K(0.0), last, which);
                M again = _o498.again;
                const M _m499 = lanes_both(_m482, again);
                if (lanes_any(_m499)) {
                    const LANES(court_ring_curvature_out) _o500 =
                        LANES(court_ring_curvature)(p_ball_radius, p_ring_radius, p_wire_radius);
                    curving = lanes_select(_m499, _o500.curvature, curving);
                    const LANES(court_started_out) _o501 =
                        LANES(court_started)(p_gravity, when, vx, vy, vz, x, y, z);
                    V from_x = _o501.from_x;
                    V from_y = _o501.from_y;
                    V from_z = _o501.from_z;
                    const LANES(court_ring_normal_out) _o502 =
                        LANES(court_ring_normal)(from_x, from_y, from_z, p_ball_radius, p_ring_radius, p_wire_radius);
                    left_nx = lanes_select(_m499, _o502.nx, left_nx);
                    left_ny = lanes_select(_m499, _o502.ny, left_ny);
                    left_nz = lanes_select(_m499, _o502.nz, left_nz);
                }
                const LANES(court_again_out) _o503 =
                    LANES(court_again)(K(1.0), last, which);
                again = _o503.again;
                const M _m504 = lanes_both(_m482, again);
                if (lanes_any(_m504)) {
                    const LANES(court_backboard_curvature_out) _o505 =
                        LANES(court_backboard_curvature)(p_ball_radius);
                    curving = lanes_select(_m504, _o505.curvature, curving);
                    const LANES(court_started_out) _o506 =
                        LANES(court_started)(p_gravity, when, vx, vy, vz, x, y, z);
                    V from_x = _o506.from_x;
                    V from_y = _o506.from_y;
                    V from_z = _o506.from_z;
                    const LANES(court_backboard_normal_out) _o507 =
                        LANES(court_backboard_normal)(from_x, from_y, from_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    left_nx = lanes_select(_m504, _o507.nx, left_nx);
                    left_ny = lanes_select(_m504, _o507.ny, left_ny);
                    left_nz = lanes_select(_m504, _o507.nz, left_nz);
                }
                const LANES(court_again_out) _o508 =
                    LANES(court_again)(K(2.0), last, which);
                again = _o508.again;
                const M _m509 = lanes_both(_m482, again);
                if (lanes_any(_m509)) {
                    const LANES(court_bridge_curvature_out) _o510 =
                        LANES(court_bridge_curvature)(p_ball_radius);
                    curving = lanes_select(_m509, _o510.curvature, curving);
                    const LANES(court_started_out) _o511 =
                        LANES(court_started)(p_gravity, when, vx, vy, vz, x, y, z);
                    V from_x = _o511.from_x;
                    V from_y = _o511.from_y;
                    V from_z = _o511.from_z;
                    const LANES(court_bridge_normal_out) _o512 =
                        LANES(court_bridge_normal)(from_x, from_y, from_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    left_nx = lanes_select(_m509, _o512.nx, left_nx);
                    left_ny = lanes_select(_m509, _o512.ny, left_ny);
                    left_nz = lanes_select(_m509, _o512.nz, left_nz);
                }
                const LANES(court_carry_flight_out) _o513 =
                    LANES(court_carry_flight)(when, x, y, z, vx, vy, vz, nx, ny, nz, clock, contacts, late, dx, dy, dz, dvx, dvy, dvz, left_nx, left_ny, left_nz, curving, p_gravity);
                dx = lanes_select(_m482, _o513.dx, dx);
                dy = lanes_select(_m482, _o513.dy, dy);
                dz = lanes_select(_m482, _o513.dz, dz);
                V lifting = _o513.lifting;
                dvx = lanes_select(_m482, _o513.dvx, dvx);
                dvy = lanes_select(_m482, _o513.dvy, dvy);
                dvz = lanes_select(_m482, _o513.dvz, dvz);
                V delay = _o513.delay;
                V shift = _o513.shift;
                const LANES(court_delayed_out) _o514 =
                    LANES(court_delayed)(clock_error, delay);
                clock_error = lanes_select(_m482, _o514.clock_error, clock_error);
                const M _m515 = lanes_both(_m482, ends);
                {
                    const LANES(court_floored_out) _o516 =
                        LANES(court_floored)(dx, dy, dz, shift);
                    dx = lanes_select(_m515, _o516.dx, dx);
                    dy = lanes_select(_m515, _o516.dy, dy);
                    dz = lanes_select(_m515, _o516.dz, dz);
                }
                const LANES(court_unturned_out) _o517 =
                    LANES(court_unturned)();
                V dnx = _o517.dnx;
                V dny = _o517.dny;
                V dnz = _o517.dnz;
                V turn = _o517.turn;
                const LANES(court_here_out) _o518 =
                    LANES(court_here)(K(0.0), which);
                here = _o518.here;
                const M _m519 = lanes_both(_m482, here);
                if (lanes_any(_m519)) {
                    const LANES(court_ring_carry_normal_out) _o520 =
                        LANES(court_ring_carry_normal)(x, y, dx, dy, dz, shift, p_ball_radius, p_ring_radius, p_wire_radius);
                    dnx = lanes_select(_m519, _o520.dnx, dnx);
                    dny = lanes_select(_m519, _o520.dny, dny);
                    dnz = lanes_select(_m519, _o520.dnz, dnz);
                    turn = lanes_select(_m519, _o520.turn, turn);
                }
                const LANES(court_here_out) _o521 =
                    LANES(court_here)(K(1.0), which);
                here = _o521.here;
                const M _m522 = lanes_both(_m482, here);
                {
                    const LANES(court_backboard_carry_normal_out) _o523 =
                        LANES(court_backboard_carry_normal)(x, y, z, dx, dy, dz, shift, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    dnx = lanes_select(_m522, _o523.dnx, dnx);
                    dny = lanes_select(_m522, _o523.dny, dny);
                    dnz = lanes_select(_m522, _o523.dnz, dnz);
                    turn = lanes_select(_m522, _o523.turn, turn);
                }
                const LANES(court_here_out) _o524 =
                    LANES(court_here)(K(2.0), which);
                here = _o524.here;
                const M _m525 = lanes_both(_m482, here);
                {
                    const LANES(court_bridge_carry_normal_out) _o526 =
                        LANES(court_bridge_carry_normal)(x, y, z, dx, dy, dz, shift, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    dnx = lanes_select(_m525, _o526.dnx, dnx);
                    dny = lanes_select(_m525, _o526.dny, dny);
                    dnz = lanes_select(_m525, _o526.dnz, dnz);
                    turn = lanes_select(_m525, _o526.turn, turn);
                }
                const LANES(court_untaken_out) _o527 =
                    LANES(court_untaken)();
                M struck_0 = _o527.mine;
                const LANES(court_ring_impact_taken_out) _o528 =
                    LANES(court_ring_impact_taken)(p_ring_restitution, p_ring_friction);
                V its_0_ring_impact = _o528.its_0;
                V its_1_ring_impact = _o528.its_1;
                {
                    const double *const _t530[][2] = {
                        {lists->p_ring_friction, lists->p_ring_restitution},
                        {lists->p_backboard_friction, lists->p_backboard_restitution},
                        {lists->p_bridge_friction, lists->p_bridge_restitution},
                    };
                    static const double _t531[][1] = {
                        {0.0},
                        {1.0},
                        {2.0},
                    };
                    for (size_t _k529 = 0; _k529 < 3; _k529++) {
                        const V own_1 = lanes_load(_t530[_k529][0] + (i & varying));
                        const V own_2 = lanes_load(_t530[_k529][1] + (i & varying));
                        const V own_index = K(_t531[_k529][0]);
                        const LANES(court_here_out) _o532 =
                            LANES(court_here)(own_index, which);
                        M here = _o532.here;
                        const M _m533 = lanes_both(_m482, here);
                        if (lanes_any(_m533)) {
                            const LANES(court_ring_impact_taken_out) _o534 =
                                LANES(court_ring_impact_taken)(own_2, own_1);
                            struck_0 = lanes_choose(_m533, _o534.mine, struck_0);
                            its_0_ring_impact = lanes_select(_m533, _o534.its_0, its_0_ring_impact);
                            its_1_ring_impact = lanes_select(_m533, _o534.its_1, its_1_ring_impact);
                        }
                    }
                }
                const M _m535 = lanes_both(_m482, struck_0);
                if (lanes_any(_m535)) {
                    const LANES(court_ring_impact_doubt_out) _o536 =
                        LANES(court_ring_impact_doubt)(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, turn, p_ball_radius, its_0_ring_impact, its_1_ring_impact, p_tangential_restitution, p_restitution_speed);
                    M unsure = _o536.unsure;
                    const LANES(court_undecided_out) _o537 =
                        LANES(court_undecided)(uncertain, unsure);
                    uncertain = lanes_select(_m535, _o537.uncertain, uncertain);
                    const LANES(court_carry_ring_impact_out) _o538 =
                        LANES(court_carry_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, dnx, dny, dnz, turn, lifting, p_ball_radius, its_0_ring_impact, its_1_ring_impact, p_tangential_restitution, p_restitution_speed);
                    dvx = lanes_select(_m535, _o538.dvx, dvx);
                    dvy = lanes_select(_m535, _o538.dvy, dvy);
                    dvz = lanes_select(_m535, _o538.dvz, dvz);
                    dwx = lanes_select(_m535, _o538.dwx, dwx);
                    dwy = lanes_select(_m535, _o538.dwy, dwy);
                    dwz = lanes_select(_m535, _o538.dwz, dwz);
                    const LANES(court_ring_impact_out) _o539 =
                        LANES(court_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, its_0_ring_impact, its_1_ring_impact, p_tangential_restitution, p_restitution_speed);
                    vx = lanes_select(_m535, _o539.vx, vx);
                    vy = lanes_select(_m535, _o539.vy, vy);
                    vz = lanes_select(_m535, _o539.vz, vz);
                    wx = lanes_select(_m535, _o539.wx, wx);
                    wy = lanes_select(_m535, _o539.wy, wy);
                    wz = lanes_select(_m535, _o539.wz, wz);
                }
                const M _m540 = lanes_both(_m482, touches);
                {
                    const LANES(court_touched_out) _o541 =
                        LANES(court_touched)(body, first, which);
                    first = lanes_select(_m540, _o541.first, first);
                    last = lanes_select(_m540, _o541.last, last);
                    const LANES(court_slowed_out) _o542 =
                        LANES(court_slowed)(p_ball_radius, p_gravity, nx, ny, nz, position_error, vx, vy, vz);
                    slow = lanes_choose(_m540, _o542.slow, slow);
                    assured = lanes_select(_m540, _o542.assured, assured);
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
            const M _m594 = lanes_both(rows, limited);
            if (lanes_any(_m594)) {
                const LANES(court_timed_out) _o595 =
                    LANES(court_timed)(claims, K(4.0), which);
                M timed = _o595.timed;
                const M _m596 = lanes_both(_m594, timed);
                if (lanes_any(_m596)) {
                    const LANES(court_carry_time_out) _o597 =
                        LANES(court_carry_time)(when, x, y, z, vx, vy, vz, clock, clock_error, dx, dy, dz, dvx, dvy, dvz, p_gravity);
                    dx = lanes_select(_m596, _o597.dx, dx);
                    dy = lanes_select(_m596, _o597.dy, dy);
                    dz = lanes_select(_m596, _o597.dz, dz);
                    dvx = lanes_select(_m596, _o597.dvx, dvx);
                    dvy = lanes_select(_m596, _o597.dvy, dvy);
                    dvz = lanes_select(_m596, _o597.dvz, dvz);
                    clock_error = lanes_select(_m596, _o597.clock_error, clock_error);
                }
            }
            const M _m598 = lanes_both(rows, hopped);
            if (lanes_any(_m598)) {
                const LANES(court_carry_hop_out) _o599 =
                    LANES(court_carry_hop)(dvx, dvy, dvz, dx, dy, dz, vx, vy, vz, when, x, y, z);
                dx = lanes_select(_m598, _o599.dx, dx);
                dy = lanes_select(_m598, _o599.dy, dy);
                dz = lanes_select(_m598, _o599.dz, dz);
            }
            const LANES(court_closing_out) _o600 =
                LANES(court_closing)(claims, outcome);
            M closed = _o600.closed;
            const M _m601 = lanes_both(rows, closed);
            {
                const LANES(court_claimed_errors_out) _o602 =
                    LANES(court_claimed_errors)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
                position_claim = lanes_select(_m601, _o602.position_error, position_claim);
                velocity_claim = lanes_select(_m601, _o602.velocity_error, velocity_claim);
                spin_claim = lanes_select(_m601, _o602.spin_error, spin_claim);
                time_claim = lanes_select(_m601, _o602.time_error, time_claim);
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
