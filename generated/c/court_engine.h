/* The event loop of the scene court, LANES_WIDTH shots abreast.

   Generated from templates/c/engine.h.j2, scene court, derivation 21d553f17b586a5d,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Included by court.c once for every width. The shots in flight fill the first rows of the lists;
   when one ends, the last takes its row. Stages go over all rows, and over those of a list of their
   own where only some shots need them. No shot's result depends on its neighbours. */

#include "court_lanes.h"
#include "court_kernels.h"

/* A column, with room for a whole row of lanes behind its end. */
typedef double LANES(court_column)[2 * LANES_SHOTS + LANES_WIDTH];

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
    LANES(court_column) open_certain;
    LANES(court_column) open_flat;
    LANES(court_column) open_rho_start;
    LANES(court_column) open_tilt;
    LANES(court_column) open_searching_row;
    LANES(court_column) open_searching_arrival;
    LANES(court_column) open_searching_ceiling;
    LANES(court_column) open_searching_certain;
    LANES(court_column) open_searching_end;
    LANES(court_column) open_searching_extent;
    LANES(court_column) open_searching_flat;
    LANES(court_column) open_searching_high0;
    LANES(court_column) open_searching_high1;
    LANES(court_column) open_searching_high2;
    LANES(court_column) open_searching_last;
    LANES(court_column) open_searching_latest;
    LANES(court_column) open_searching_low0;
    LANES(court_column) open_searching_low1;
    LANES(court_column) open_searching_low2;
    LANES(court_column) open_searching_p_ball_radius;
    LANES(court_column) open_searching_p_gravity;
    LANES(court_column) open_searching_p_ring_radius;
    LANES(court_column) open_searching_p_wire_radius;
    LANES(court_column) open_searching_rate_slack;
    LANES(court_column) open_searching_rho_start;
    LANES(court_column) open_searching_searching;
    LANES(court_column) open_searching_share;
    LANES(court_column) open_searching_speed;
    LANES(court_column) open_searching_steady;
    LANES(court_column) open_searching_swing;
    LANES(court_column) open_searching_t;
    LANES(court_column) open_searching_tilt;
    LANES(court_column) open_searching_vx;
    LANES(court_column) open_searching_vy;
    LANES(court_column) open_searching_vz;
    LANES(court_column) open_searching_x;
    LANES(court_column) open_searching_y;
    LANES(court_column) open_searching_z;
    LANES(court_column) open_p_board_bottom;
    LANES(court_column) open_p_board_distance;
    LANES(court_column) open_p_board_half_width;
    LANES(court_column) open_p_board_thickness;
    LANES(court_column) open_p_board_top;
    LANES(court_column) open_searching_p_board_bottom;
    LANES(court_column) open_searching_p_board_distance;
    LANES(court_column) open_searching_p_board_half_width;
    LANES(court_column) open_searching_p_board_thickness;
    LANES(court_column) open_searching_p_board_top;
    LANES(court_column) open_p_bridge_depth;
    LANES(court_column) open_p_bridge_half_width;
    LANES(court_column) open_searching_p_bridge_depth;
    LANES(court_column) open_searching_p_bridge_half_width;
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
        const LANES(court_resumed_out) _o97 =
            LANES(court_resumed)(clock, mode, K(0.0), K(0.0));
        V which = _o97.which;
        V began = _o97.began;
        M begins = _o97.begins;
        M rolling = _o97.rolling;
        M leaves = _o97.leaves;
        V nx = _o97.nx;
        V ny = _o97.ny;
        V nz = _o97.nz;
        V gap = _o97.gap;
        V bent_x = _o97.bent_x;
        V bent_y = _o97.bent_y;
        V bent_z = _o97.bent_z;
        V lift = _o97.lift;
        V surge = _o97.surge;
        V snap = _o97.snap;
        V per_reach = _o97.per_reach;
        const M _m98 = lanes_both(rows, begins);
        if (lanes_any(_m98)) {
            const LANES(court_holding_out) _o99 =
                LANES(court_holding)(held, K(0.0));
            M here = _o99.here;
            const M _m100 = lanes_both(_m98, here);
            {
                const LANES(court_ring_normal_out) _o101 =
                    LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                nx = lanes_select(_m100, _o101.nx, nx);
                ny = lanes_select(_m100, _o101.ny, ny);
                nz = lanes_select(_m100, _o101.nz, nz);
            }
            const LANES(court_holding_out) _o102 =
                LANES(court_holding)(held, K(1.0));
            here = _o102.here;
            const M _m103 = lanes_both(_m98, here);
            {
                const LANES(court_backboard_normal_out) _o104 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m103, _o104.nx, nx);
                ny = lanes_select(_m103, _o104.ny, ny);
                nz = lanes_select(_m103, _o104.nz, nz);
            }
            const LANES(court_holding_out) _o105 =
                LANES(court_holding)(held, K(2.0));
            here = _o105.here;
            const M _m106 = lanes_both(_m98, here);
            {
                const LANES(court_bridge_normal_out) _o107 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m106, _o107.nx, nx);
                ny = lanes_select(_m106, _o107.ny, ny);
                nz = lanes_select(_m106, _o107.nz, nz);
            }
            const LANES(court_roll_turn_rate_out) _o108 =
                LANES(court_roll_turn_rate)(p_ball_radius, nx, ny, nz, wx, wy, wz);
            V turn_rate = _o108.turn_rate;
            const LANES(court_gripped_out) _o109 =
                LANES(court_gripped)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
            V rolled_x = _o109.rolled_x;
            V rolled_y = _o109.rolled_y;
            V rolled_z = _o109.rolled_z;
            const LANES(court_holding_out) _o110 =
                LANES(court_holding)(held, K(0.0));
            here = _o110.here;
            const M _m111 = lanes_both(_m98, here);
            {
                const LANES(court_ring_off_out) _o112 =
                    LANES(court_ring_off)(p_ball_radius, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m111, _o112.gap, gap);
            }
            const LANES(court_holding_out) _o113 =
                LANES(court_holding)(held, K(1.0));
            here = _o113.here;
            const M _m114 = lanes_both(_m98, here);
            {
                const LANES(court_backboard_off_out) _o115 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z);
                gap = lanes_select(_m114, _o115.gap, gap);
            }
            const LANES(court_holding_out) _o116 =
                LANES(court_holding)(held, K(2.0));
            here = _o116.here;
            const M _m117 = lanes_both(_m98, here);
            {
                const LANES(court_bridge_off_out) _o118 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m117, _o118.gap, gap);
            }
            const LANES(court_roll_placed_out) _o119 =
                LANES(court_roll_placed)(p_ball_radius, gap, nx, ny, nz, turn_rate, rolled_x, rolled_y, rolled_z, x, y, z);
            x = lanes_select(_m98, _o119.x, x);
            y = lanes_select(_m98, _o119.y, y);
            z = lanes_select(_m98, _o119.z, z);
            vx = lanes_select(_m98, _o119.vx, vx);
            vy = lanes_select(_m98, _o119.vy, vy);
            vz = lanes_select(_m98, _o119.vz, vz);
            wx = lanes_select(_m98, _o119.wx, wx);
            wy = lanes_select(_m98, _o119.wy, wy);
            wz = lanes_select(_m98, _o119.wz, wz);
            const LANES(court_beginning_contact_out) _o120 =
                LANES(court_beginning_contact)();
            which = lanes_select(_m98, _o120.which, which);
            circled = lanes_select(_m98, _o120.circled, circled);
        }
        const LANES(court_circles_out) _o121 =
            LANES(court_circles)(held, K(0.0), rolling);
        M circling = _o121.circling;
        rolling = _o121.rolling;
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
            const LANES(court_holding_out) _o122 =
                LANES(court_holding)(held, K(1.0));
            M here = _o122.here;
            const M _m123 = lanes_both(active, here);
            if (lanes_any(_m123)) {
                const LANES(court_backboard_normal_out) _o124 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m123, _o124.nx, nx);
                ny = lanes_select(_m123, _o124.ny, ny);
                nz = lanes_select(_m123, _o124.nz, nz);
                const LANES(court_backboard_tube_out) _o125 =
                    LANES(court_backboard_tube)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                bent_x = lanes_select(_m123, _o125.bent_x, bent_x);
                bent_y = lanes_select(_m123, _o125.bent_y, bent_y);
                bent_z = lanes_select(_m123, _o125.bent_z, bent_z);
                per_reach = lanes_select(_m123, _o125.per_reach, per_reach);
            }
            const LANES(court_holding_out) _o126 =
                LANES(court_holding)(held, K(2.0));
            here = _o126.here;
            const M _m127 = lanes_both(active, here);
            if (lanes_any(_m127)) {
                const LANES(court_bridge_normal_out) _o128 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m127, _o128.nx, nx);
                ny = lanes_select(_m127, _o128.ny, ny);
                nz = lanes_select(_m127, _o128.nz, nz);
                const LANES(court_bridge_tube_out) _o129 =
                    LANES(court_bridge_tube)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                bent_x = lanes_select(_m127, _o129.bent_x, bent_x);
                bent_y = lanes_select(_m127, _o129.bent_y, bent_y);
                bent_z = lanes_select(_m127, _o129.bent_z, bent_z);
                per_reach = lanes_select(_m127, _o129.per_reach, per_reach);
            }
            const LANES(court_roll_start_out) _o130 =
                LANES(court_roll_start)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
            V vx_0 = _o130.vx_0;
            V vy_0 = _o130.vy_0;
            V vz_0 = _o130.vz_0;
            V nx_0 = _o130.nx_0;
            V ny_0 = _o130.ny_0;
            V nz_0 = _o130.nz_0;
            V turn_rate_0 = _o130.turn_rate_0;
            const LANES(court_roll_0_out) _o131 =
                LANES(court_roll_0)(bent_x, bent_y, bent_z, p_gravity, nx_0, ny_0, nz_0, per_reach, turn_rate_0, vx_0, vy_0, vz_0);
            V lift_0 = _o131.lift_0;
            V tx_0 = _o131.tx_0;
            V ty_0 = _o131.ty_0;
            V tz_0 = _o131.tz_0;
            V vx_1 = _o131.vx_1;
            V vy_1 = _o131.vy_1;
            V vz_1 = _o131.vz_1;
            V nx_1 = _o131.nx_1;
            V ny_1 = _o131.ny_1;
            V nz_1 = _o131.nz_1;
            V turn_rate_1 = _o131.turn_rate_1;
            const LANES(court_roll_1_out) _o132 =
                LANES(court_roll_1)(bent_x, bent_y, bent_z, p_gravity, lift_0, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1);
            V lift_1 = _o132.lift_1;
            V tx_1 = _o132.tx_1;
            V ty_1 = _o132.ty_1;
            V tz_1 = _o132.tz_1;
            V vx_2 = _o132.vx_2;
            V vy_2 = _o132.vy_2;
            V vz_2 = _o132.vz_2;
            V nx_2 = _o132.nx_2;
            V ny_2 = _o132.ny_2;
            V nz_2 = _o132.nz_2;
            V turn_rate_2 = _o132.turn_rate_2;
            const LANES(court_roll_2_out) _o133 =
                LANES(court_roll_2)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2);
            V lift_2 = _o133.lift_2;
            V tx_2 = _o133.tx_2;
            V ty_2 = _o133.ty_2;
            V tz_2 = _o133.tz_2;
            V vx_3 = _o133.vx_3;
            V vy_3 = _o133.vy_3;
            V vz_3 = _o133.vz_3;
            V nx_3 = _o133.nx_3;
            V ny_3 = _o133.ny_3;
            V nz_3 = _o133.nz_3;
            V turn_rate_3 = _o133.turn_rate_3;
            const LANES(court_roll_3_out) _o134 =
                LANES(court_roll_3)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3);
            V lift_3 = _o134.lift_3;
            V tx_3 = _o134.tx_3;
            V ty_3 = _o134.ty_3;
            V tz_3 = _o134.tz_3;
            V vx_4 = _o134.vx_4;
            V vy_4 = _o134.vy_4;
            V vz_4 = _o134.vz_4;
            V nx_4 = _o134.nx_4;
            V ny_4 = _o134.ny_4;
            V nz_4 = _o134.nz_4;
            V turn_rate_4 = _o134.turn_rate_4;
            const LANES(court_roll_4_out) _o135 =
                LANES(court_roll_4)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4);
            V lift_4 = _o135.lift_4;
            V tx_4 = _o135.tx_4;
            V ty_4 = _o135.ty_4;
            V tz_4 = _o135.tz_4;
            V vx_5 = _o135.vx_5;
            V vy_5 = _o135.vy_5;
            V vz_5 = _o135.vz_5;
            V nx_5 = _o135.nx_5;
            V ny_5 = _o135.ny_5;
            V nz_5 = _o135.nz_5;
            V turn_rate_5 = _o135.turn_rate_5;
            const LANES(court_roll_5_out) _o136 =
                LANES(court_roll_5)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5);
            V lift_5 = _o136.lift_5;
            V tx_5 = _o136.tx_5;
            V ty_5 = _o136.ty_5;
            V tz_5 = _o136.tz_5;
            V vx_6 = _o136.vx_6;
            V vy_6 = _o136.vy_6;
            V vz_6 = _o136.vz_6;
            V nx_6 = _o136.nx_6;
            V ny_6 = _o136.ny_6;
            V nz_6 = _o136.nz_6;
            V turn_rate_6 = _o136.turn_rate_6;
            const LANES(court_roll_6_out) _o137 =
                LANES(court_roll_6)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6);
            V lift_6 = _o137.lift_6;
            V tx_6 = _o137.tx_6;
            V ty_6 = _o137.ty_6;
            V tz_6 = _o137.tz_6;
            V vx_7 = _o137.vx_7;
            V vy_7 = _o137.vy_7;
            V vz_7 = _o137.vz_7;
            V nx_7 = _o137.nx_7;
            V ny_7 = _o137.ny_7;
            V nz_7 = _o137.nz_7;
            V turn_rate_7 = _o137.turn_rate_7;
            const LANES(court_roll_7_out) _o138 =
                LANES(court_roll_7)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7);
            V lift_7 = _o138.lift_7;
            V vx_8 = _o138.vx_8;
            V vy_8 = _o138.vy_8;
            V vz_8 = _o138.vz_8;
            V nx_8 = _o138.nx_8;
            V ny_8 = _o138.ny_8;
            V nz_8 = _o138.nz_8;
            V turn_rate_8 = _o138.turn_rate_8;
            const LANES(court_roll_pace_out) _o139 =
                LANES(court_roll_pace)(p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, lift_7, nx_8, ny_8, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, nz_8, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8);
            V stride = _o139.stride;
            V strongest = _o139.strongest;
            V fastest = _o139.fastest;
            V force = _o139.force;
            V force_rate = _o139.force_rate;
            V force_bend = _o139.force_bend;
            V brace = _o139.brace;
            const LANES(court_leaving_force_out) _o140 =
                LANES(court_leaving_force)(p_ball_radius, brace, K(INFINITY), fastest, force, force_bend, force_rate, p_gravity, per_reach, K(0.0), stride, K(0.0), vx, vx_1, vy, vy_1, vz, vz_1, which);
            stride = _o140.stride;
            which = _o140.which;
            M rests = _o140.rests;
            const LANES(court_beside_out) _o141 =
                LANES(court_beside)(held, K(0.0));
            M beside = _o141.beside;
            const M _m142 = lanes_both(active, beside);
            if (lanes_any(_m142)) {
                const LANES(court_ring_beside_out) _o143 =
                    LANES(court_ring_beside)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                V gap = _o143.gap;
                V nearing = _o143.nearing;
                V dent = _o143.dent;
                const LANES(court_beside_body_out) _o144 =
                    LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(0.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
                stride = lanes_select(_m142, _o144.stride, stride);
                which = lanes_select(_m142, _o144.which, which);
            }
            const LANES(court_beside_out) _o145 =
                LANES(court_beside)(held, K(1.0));
            beside = _o145.beside;
            const M _m146 = lanes_both(active, beside);
            if (lanes_any(_m146)) {
                const LANES(court_backboard_beside_out) _o147 =
                    LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                V gap = _o147.gap;
                V nearing = _o147.nearing;
                V dent = _o147.dent;
                const LANES(court_beside_body_out) _o148 =
                    LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(1.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
                stride = lanes_select(_m146, _o148.stride, stride);
                which = lanes_select(_m146, _o148.which, which);
            }
            const LANES(court_beside_out) _o149 =
                LANES(court_beside)(held, K(2.0));
            beside = _o149.beside;
            const M _m150 = lanes_both(active, beside);
            if (lanes_any(_m150)) {
                const LANES(court_bridge_beside_out) _o151 =
                    LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                V gap = _o151.gap;
                V nearing = _o151.nearing;
                V dent = _o151.dent;
                const LANES(court_beside_body_out) _o152 =
                    LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(2.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
                stride = lanes_select(_m150, _o152.stride, stride);
                which = lanes_select(_m150, _o152.which, which);
            }
            const LANES(court_end_beside_out) _o153 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            V gap = _o153.gap;
            V nearing = _o153.nearing;
            V dent = _o153.dent;
            const LANES(court_beside_gate_out) _o154 =
                LANES(court_beside_gate)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(3.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
            stride = _o154.stride;
            which = _o154.which;
            const LANES(court_holding_out) _o155 =
                LANES(court_holding)(held, K(1.0));
            here = _o155.here;
            const M _m156 = lanes_both(active, here);
            if (lanes_any(_m156)) {
                const LANES(court_backboard_seam0_out) _o157 =
                    LANES(court_backboard_seam0)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                gap = lanes_select(_m156, _o157.gap, gap);
                V nearing = _o157.nearing;
                V near = _o157.near;
                const LANES(court_beside_seam_out) _o158 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m156, _o158.stride, stride);
                const LANES(court_backboard_seam1_out) _o159 =
                    LANES(court_backboard_seam1)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                gap = lanes_select(_m156, _o159.gap, gap);
                nearing = _o159.nearing;
                near = _o159.near;
                const LANES(court_beside_seam_out) _o160 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m156, _o160.stride, stride);
                const LANES(court_backboard_seam2_out) _o161 =
                    LANES(court_backboard_seam2)(p_ball_radius, p_board_half_width, vy, y);
                gap = lanes_select(_m156, _o161.gap, gap);
                nearing = _o161.nearing;
                near = _o161.near;
                const LANES(court_beside_seam_out) _o162 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m156, _o162.stride, stride);
                const LANES(court_backboard_seam3_out) _o163 =
                    LANES(court_backboard_seam3)(p_ball_radius, p_board_half_width, vy, y);
                gap = lanes_select(_m156, _o163.gap, gap);
                nearing = _o163.nearing;
                near = _o163.near;
                const LANES(court_beside_seam_out) _o164 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m156, _o164.stride, stride);
                const LANES(court_backboard_seam4_out) _o165 =
                    LANES(court_backboard_seam4)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                gap = lanes_select(_m156, _o165.gap, gap);
                nearing = _o165.nearing;
                near = _o165.near;
                const LANES(court_beside_seam_out) _o166 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m156, _o166.stride, stride);
                const LANES(court_backboard_seam5_out) _o167 =
                    LANES(court_backboard_seam5)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                gap = lanes_select(_m156, _o167.gap, gap);
                nearing = _o167.nearing;
                near = _o167.near;
                const LANES(court_beside_seam_out) _o168 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m156, _o168.stride, stride);
            }
            const LANES(court_holding_out) _o169 =
                LANES(court_holding)(held, K(2.0));
            here = _o169.here;
            const M _m170 = lanes_both(active, here);
            if (lanes_any(_m170)) {
                const LANES(court_bridge_seam0_out) _o171 =
                    LANES(court_bridge_seam0)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                gap = lanes_select(_m170, _o171.gap, gap);
                V nearing = _o171.nearing;
                V near = _o171.near;
                const LANES(court_beside_seam_out) _o172 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m170, _o172.stride, stride);
                const LANES(court_bridge_seam1_out) _o173 =
                    LANES(court_bridge_seam1)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                gap = lanes_select(_m170, _o173.gap, gap);
                nearing = _o173.nearing;
                near = _o173.near;
                const LANES(court_beside_seam_out) _o174 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m170, _o174.stride, stride);
                const LANES(court_bridge_seam2_out) _o175 =
                    LANES(court_bridge_seam2)(p_ball_radius, p_bridge_half_width, vy, y);
                gap = lanes_select(_m170, _o175.gap, gap);
                nearing = _o175.nearing;
                near = _o175.near;
                const LANES(court_beside_seam_out) _o176 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m170, _o176.stride, stride);
                const LANES(court_bridge_seam3_out) _o177 =
                    LANES(court_bridge_seam3)(p_ball_radius, p_bridge_half_width, vy, y);
                gap = lanes_select(_m170, _o177.gap, gap);
                nearing = _o177.nearing;
                near = _o177.near;
                const LANES(court_beside_seam_out) _o178 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m170, _o178.stride, stride);
                const LANES(court_bridge_seam4_out) _o179 =
                    LANES(court_bridge_seam4)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                gap = lanes_select(_m170, _o179.gap, gap);
                nearing = _o179.nearing;
                near = _o179.near;
                const LANES(court_beside_seam_out) _o180 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m170, _o180.stride, stride);
                const LANES(court_bridge_seam5_out) _o181 =
                    LANES(court_bridge_seam5)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                gap = lanes_select(_m170, _o181.gap, gap);
                nearing = _o181.nearing;
                near = _o181.near;
                const LANES(court_beside_seam_out) _o182 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m170, _o182.stride, stride);
            }
            const LANES(court_beside_time_out) _o183 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o183.stride;
            which = _o183.which;
            const LANES(court_passing_from_out) _o184 =
                LANES(court_passing_from)(z);
            M over = _o184.over;
            const LANES(court_roll_moved_out) _o185 =
                LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, x, y, z);
            x = _o185.x;
            vx = _o185.vx;
            y = _o185.y;
            vy = _o185.vy;
            z = _o185.z;
            vz = _o185.vz;
            V turn_rate = _o185.turn_rate;
            const LANES(court_holding_out) _o186 =
                LANES(court_holding)(held, K(1.0));
            here = _o186.here;
            const M _m187 = lanes_both(active, here);
            if (lanes_any(_m187)) {
                const LANES(court_backboard_normal_out) _o188 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m187, _o188.nx, nx);
                ny = lanes_select(_m187, _o188.ny, ny);
                nz = lanes_select(_m187, _o188.nz, nz);
                const LANES(court_backboard_off_out) _o189 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z);
                gap = lanes_select(_m187, _o189.gap, gap);
            }
            const LANES(court_holding_out) _o190 =
                LANES(court_holding)(held, K(2.0));
            here = _o190.here;
            const M _m191 = lanes_both(active, here);
            if (lanes_any(_m191)) {
                const LANES(court_bridge_normal_out) _o192 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m191, _o192.nx, nx);
                ny = lanes_select(_m191, _o192.ny, ny);
                nz = lanes_select(_m191, _o192.nz, nz);
                const LANES(court_bridge_off_out) _o193 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m191, _o193.gap, gap);
            }
            const LANES(court_roll_placed_out) _o194 =
                LANES(court_roll_placed)(p_ball_radius, gap, nx, ny, nz, turn_rate, vx, vy, vz, x, y, z);
            x = _o194.x;
            y = _o194.y;
            z = _o194.z;
            vx = _o194.vx;
            vy = _o194.vy;
            vz = _o194.vz;
            wx = _o194.wx;
            wy = _o194.wy;
            wz = _o194.wz;
            const LANES(court_passing_in_contact_out) _o195 =
                LANES(court_passing_in_contact)(over, p_ring_radius, through, x, y, z);
            through = _o195.through;
            const LANES(court_rolled_on_out) _o196 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o196.clock;
            rolling = _o196.rolling;
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
            const LANES(court_ring_tube_out) _o197 =
                LANES(court_ring_tube)(p_ball_radius, p_wire_radius);
            V per_reach = _o197.per_reach;
            const LANES(court_ring_round_start_out) _o198 =
                LANES(court_ring_round_start)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, wx, wy, wz, x, y, z);
            V cosine_0 = _o198.cosine_0;
            V sine_0 = _o198.sine_0;
            V climb_0 = _o198.climb_0;
            V along_0 = _o198.along_0;
            V turn_rate_0 = _o198.turn_rate_0;
            V cos_0 = _o198.cos_0;
            V sin_0 = _o198.sin_0;
            V near_0 = _o198.near_0;
            const LANES(court_ring_round_0_out) _o199 =
                LANES(court_ring_round_0)(along_0, p_ball_radius, climb_0, cos_0, cosine_0, p_gravity, near_0, p_ring_radius, sin_0, sine_0, turn_rate_0, p_wire_radius);
            V omega_0 = _o199.omega_0;
            V around_0 = _o199.around_0;
            V tilted_0 = _o199.tilted_0;
            V pressed_0 = _o199.pressed_0;
            V force_0 = _o199.force_0;
            V cosine_1 = _o199.cosine_1;
            V sine_1 = _o199.sine_1;
            V climb_1 = _o199.climb_1;
            V along_1 = _o199.along_1;
            V turn_rate_1 = _o199.turn_rate_1;
            V cos_1 = _o199.cos_1;
            V sin_1 = _o199.sin_1;
            const LANES(court_ring_round_1_out) _o200 =
                LANES(court_ring_round_1)(along_0, along_1, around_0, p_ball_radius, climb_0, climb_1, cos_0, cos_1, cosine_0, cosine_1, p_gravity, near_0, omega_0, pressed_0, p_ring_radius, sin_0, sin_1, sine_0, sine_1, tilted_0, turn_rate_0, turn_rate_1, p_wire_radius);
            V near_1 = _o200.near_1;
            V omega_1 = _o200.omega_1;
            V around_1 = _o200.around_1;
            V tilted_1 = _o200.tilted_1;
            V pressed_1 = _o200.pressed_1;
            V force_1 = _o200.force_1;
            V cosine_2 = _o200.cosine_2;
            V sine_2 = _o200.sine_2;
            V climb_2 = _o200.climb_2;
            V along_2 = _o200.along_2;
            V turn_rate_2 = _o200.turn_rate_2;
            V cos_2 = _o200.cos_2;
            V sin_2 = _o200.sin_2;
            const LANES(court_ring_round_2_out) _o201 =
                LANES(court_ring_round_2)(along_0, along_1, along_2, around_0, around_1, p_ball_radius, climb_0, climb_1, climb_2, cos_0, cos_1, cos_2, cosine_0, cosine_1, cosine_2, p_gravity, near_0, near_1, omega_0, omega_1, pressed_0, pressed_1, p_ring_radius, sin_0, sin_1, sin_2, sine_0, sine_1, sine_2, tilted_0, tilted_1, turn_rate_0, turn_rate_1, turn_rate_2, p_wire_radius);
            V near_2 = _o201.near_2;
            V omega_2 = _o201.omega_2;
            V around_2 = _o201.around_2;
            V tilted_2 = _o201.tilted_2;
            V pressed_2 = _o201.pressed_2;
            V force_2 = _o201.force_2;
            V cosine_3 = _o201.cosine_3;
            V sine_3 = _o201.sine_3;
            V climb_3 = _o201.climb_3;
            V along_3 = _o201.along_3;
            V turn_rate_3 = _o201.turn_rate_3;
            V cos_3 = _o201.cos_3;
            V sin_3 = _o201.sin_3;
            const LANES(court_ring_round_3_out) _o202 =
                LANES(court_ring_round_3)(along_0, along_1, along_2, along_3, around_0, around_1, around_2, p_ball_radius, climb_0, climb_1, climb_2, climb_3, cos_0, cos_1, cos_2, cos_3, cosine_0, cosine_1, cosine_2, cosine_3, p_gravity, near_0, near_1, near_2, omega_0, omega_1, omega_2, pressed_0, pressed_1, pressed_2, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sine_0, sine_1, sine_2, sine_3, tilted_0, tilted_1, tilted_2, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, p_wire_radius);
            V near_3 = _o202.near_3;
            V omega_3 = _o202.omega_3;
            V around_3 = _o202.around_3;
            V tilted_3 = _o202.tilted_3;
            V pressed_3 = _o202.pressed_3;
            V force_3 = _o202.force_3;
            V cosine_4 = _o202.cosine_4;
            V sine_4 = _o202.sine_4;
            V climb_4 = _o202.climb_4;
            V along_4 = _o202.along_4;
            V turn_rate_4 = _o202.turn_rate_4;
            V cos_4 = _o202.cos_4;
            V sin_4 = _o202.sin_4;
            const LANES(court_ring_round_4_out) _o203 =
                LANES(court_ring_round_4)(along_0, along_1, along_2, along_3, along_4, around_0, around_1, around_2, around_3, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, cos_0, cos_1, cos_2, cos_3, cos_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, p_gravity, near_0, near_1, near_2, near_3, omega_0, omega_1, omega_2, omega_3, pressed_0, pressed_1, pressed_2, pressed_3, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sine_0, sine_1, sine_2, sine_3, sine_4, tilted_0, tilted_1, tilted_2, tilted_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, p_wire_radius);
            V near_4 = _o203.near_4;
            V omega_4 = _o203.omega_4;
            V around_4 = _o203.around_4;
            V tilted_4 = _o203.tilted_4;
            V pressed_4 = _o203.pressed_4;
            V force_4 = _o203.force_4;
            V cosine_5 = _o203.cosine_5;
            V sine_5 = _o203.sine_5;
            V climb_5 = _o203.climb_5;
            V along_5 = _o203.along_5;
            V turn_rate_5 = _o203.turn_rate_5;
            V cos_5 = _o203.cos_5;
            V sin_5 = _o203.sin_5;
            const LANES(court_ring_round_5_out) _o204 =
                LANES(court_ring_round_5)(along_0, along_1, along_2, along_3, along_4, along_5, around_0, around_1, around_2, around_3, around_4, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, p_gravity, near_0, near_1, near_2, near_3, near_4, omega_0, omega_1, omega_2, omega_3, omega_4, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, p_wire_radius);
            V near_5 = _o204.near_5;
            V omega_5 = _o204.omega_5;
            V around_5 = _o204.around_5;
            V tilted_5 = _o204.tilted_5;
            V pressed_5 = _o204.pressed_5;
            V force_5 = _o204.force_5;
            V cosine_6 = _o204.cosine_6;
            V sine_6 = _o204.sine_6;
            V climb_6 = _o204.climb_6;
            V along_6 = _o204.along_6;
            V turn_rate_6 = _o204.turn_rate_6;
            V cos_6 = _o204.cos_6;
            V sin_6 = _o204.sin_6;
            const LANES(court_ring_round_6_out) _o205 =
                LANES(court_ring_round_6)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, around_0, around_1, around_2, around_3, around_4, around_5, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, p_wire_radius);
            V near_6 = _o205.near_6;
            V omega_6 = _o205.omega_6;
            V around_6 = _o205.around_6;
            V tilted_6 = _o205.tilted_6;
            V pressed_6 = _o205.pressed_6;
            V force_6 = _o205.force_6;
            V cosine_7 = _o205.cosine_7;
            V sine_7 = _o205.sine_7;
            V climb_7 = _o205.climb_7;
            V along_7 = _o205.along_7;
            V turn_rate_7 = _o205.turn_rate_7;
            V cos_7 = _o205.cos_7;
            V sin_7 = _o205.sin_7;
            const LANES(court_ring_round_7_out) _o206 =
                LANES(court_ring_round_7)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, p_wire_radius);
            V near_7 = _o206.near_7;
            V omega_7 = _o206.omega_7;
            V around_7 = _o206.around_7;
            V tilted_7 = _o206.tilted_7;
            V pressed_7 = _o206.pressed_7;
            V force_7 = _o206.force_7;
            V cosine_8 = _o206.cosine_8;
            V sine_8 = _o206.sine_8;
            V climb_8 = _o206.climb_8;
            V along_8 = _o206.along_8;
            V turn_rate_8 = _o206.turn_rate_8;
            V cos_8 = _o206.cos_8;
            V sin_8 = _o206.sin_8;
            const LANES(court_ring_round_8_out) _o207 =
                LANES(court_ring_round_8)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, p_wire_radius);
            V near_8 = _o207.near_8;
            V omega_8 = _o207.omega_8;
            V around_8 = _o207.around_8;
            V tilted_8 = _o207.tilted_8;
            V pressed_8 = _o207.pressed_8;
            V force_8 = _o207.force_8;
            V cosine_9 = _o207.cosine_9;
            V sine_9 = _o207.sine_9;
            V climb_9 = _o207.climb_9;
            V along_9 = _o207.along_9;
            V turn_rate_9 = _o207.turn_rate_9;
            V cos_9 = _o207.cos_9;
            V sin_9 = _o207.sin_9;
            const LANES(court_ring_round_9_out) _o208 =
                LANES(court_ring_round_9)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V near_9 = _o208.near_9;
            V omega_9 = _o208.omega_9;
            V around_9 = _o208.around_9;
            V tilted_9 = _o208.tilted_9;
            V pressed_9 = _o208.pressed_9;
            V force_9 = _o208.force_9;
            V cosine_10 = _o208.cosine_10;
            V sine_10 = _o208.sine_10;
            V climb_10 = _o208.climb_10;
            V along_10 = _o208.along_10;
            V turn_rate_10 = _o208.turn_rate_10;
            V cos_10 = _o208.cos_10;
            V sin_10 = _o208.sin_10;
            const LANES(court_ring_round_10_out) _o209 =
                LANES(court_ring_round_10)(along_0, along_1, along_10, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V near_10 = _o209.near_10;
            V omega_10 = _o209.omega_10;
            V around_10 = _o209.around_10;
            V tilted_10 = _o209.tilted_10;
            V pressed_10 = _o209.pressed_10;
            V force_10 = _o209.force_10;
            V cosine_11 = _o209.cosine_11;
            V sine_11 = _o209.sine_11;
            V climb_11 = _o209.climb_11;
            V along_11 = _o209.along_11;
            V turn_rate_11 = _o209.turn_rate_11;
            V cos_11 = _o209.cos_11;
            V sin_11 = _o209.sin_11;
            const LANES(court_ring_round_11_out) _o210 =
                LANES(court_ring_round_11)(along_0, along_1, along_10, along_11, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_10, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_10, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_10, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_10, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V force_11 = _o210.force_11;
            V cosine_12 = _o210.cosine_12;
            V sine_12 = _o210.sine_12;
            V climb_12 = _o210.climb_12;
            V along_12 = _o210.along_12;
            V turn_rate_12 = _o210.turn_rate_12;
            V cos_12 = _o210.cos_12;
            V sin_12 = _o210.sin_12;
            const LANES(court_ring_round_pace_out) _o211 =
                LANES(court_ring_round_pace)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_12, cosine_0, cosine_12, force_0, force_1, force_10, force_11, force_2, force_3, force_4, force_5, force_6, force_7, force_8, force_9, p_gravity, omega_0, p_ring_radius, sin_0, sin_12, sine_0, sine_12, turn_rate_0, turn_rate_11, turn_rate_12, p_wire_radius);
            V stride = _o211.stride;
            V strongest = _o211.strongest;
            V fastest = _o211.fastest;
            V sway = _o211.sway;
            V force = _o211.force;
            V force_rate = _o211.force_rate;
            V force_bend = _o211.force_bend;
            V brace = _o211.brace;
            V vx_1 = _o211.vx_1;
            V vy_1 = _o211.vy_1;
            V vz_1 = _o211.vz_1;
            const LANES(court_leaving_force_out) _o212 =
                LANES(court_leaving_force)(p_ball_radius, brace, K(INFINITY), fastest, force, force_bend, force_rate, p_gravity, per_reach, K(0.0), stride, K(0.0), vx, vx_1, vy, vy_1, vz, vz_1, which);
            stride = _o212.stride;
            which = _o212.which;
            M rests = _o212.rests;
            const LANES(court_backboard_beside_out) _o213 =
                LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            V gap = _o213.gap;
            V nearing = _o213.nearing;
            V dent = _o213.dent;
            const LANES(court_beside_body_out) _o214 =
                LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(1.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
            stride = _o214.stride;
            which = _o214.which;
            const LANES(court_bridge_beside_out) _o215 =
                LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o215.gap;
            nearing = _o215.nearing;
            dent = _o215.dent;
            const LANES(court_beside_body_out) _o216 =
                LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(2.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
            stride = _o216.stride;
            which = _o216.which;
            const LANES(court_end_beside_out) _o217 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o217.gap;
            nearing = _o217.nearing;
            dent = _o217.dent;
            const LANES(court_beside_gate_out) _o218 =
                LANES(court_beside_gate)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(3.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
            stride = _o218.stride;
            which = _o218.which;
            const LANES(court_beside_time_out) _o219 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o219.stride;
            which = _o219.which;
            const LANES(court_passing_from_out) _o220 =
                LANES(court_passing_from)(z);
            M over = _o220.over;
            const LANES(court_alone_out) _o221 =
                LANES(court_alone)();
            V berth = _o221.nearest;
            const LANES(court_leaps_out) _o222 =
                LANES(court_leaps)(stride);
            V forth = _o222.forth;
            V back = _o222.back;
            const LANES(court_backboard_around_out) _o223 =
                LANES(court_backboard_around)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            gap = _o223.gap;
            nearing = _o223.nearing;
            const LANES(court_cleared_out) _o224 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o224.berth;
            const LANES(court_bridge_around_out) _o225 =
                LANES(court_bridge_around)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o225.gap;
            nearing = _o225.nearing;
            const LANES(court_cleared_out) _o226 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o226.berth;
            const LANES(court_end_around_out) _o227 =
                LANES(court_end_around)(p_end_depth, vz, z);
            gap = _o227.gap;
            nearing = _o227.nearing;
            const LANES(court_cleared_out) _o228 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o228.berth;
            const LANES(court_ring_round_moved_out) _o229 =
                LANES(court_ring_round_moved)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_12, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_12, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_12, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_12, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, stride, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_12, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            x = _o229.x;
            y = _o229.y;
            z = _o229.z;
            vx = _o229.vx;
            vy = _o229.vy;
            vz = _o229.vz;
            wx = _o229.wx;
            wy = _o229.wy;
            wz = _o229.wz;
            V climb = _o229.climb;
            const LANES(court_passing_in_contact_out) _o230 =
                LANES(court_passing_in_contact)(over, p_ring_radius, through, x, y, z);
            through = _o230.through;
            const LANES(court_backboard_around_out) _o231 =
                LANES(court_backboard_around)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            gap = _o231.gap;
            nearing = _o231.nearing;
            const LANES(court_cleared_out) _o232 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o232.berth;
            const LANES(court_bridge_around_out) _o233 =
                LANES(court_bridge_around)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o233.gap;
            nearing = _o233.nearing;
            const LANES(court_cleared_out) _o234 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o234.berth;
            const LANES(court_end_around_out) _o235 =
                LANES(court_end_around)(p_end_depth, vz, z);
            gap = _o235.gap;
            nearing = _o235.nearing;
            const LANES(court_cleared_out) _o236 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o236.berth;
            const LANES(court_ring_swung_out) _o237 =
                LANES(court_ring_swung)(p_ball_radius, berth, circled, climb, climb_0, K(INFINITY), fastest, force, force_bend, force_rate, p_gravity, K(0.0), stride, sway, K(0.0), which, p_wire_radius);
            circled = _o237.circled;
            M endless = _o237.endless;
            const LANES(court_for_ever_out) _o238 =
                LANES(court_for_ever)(endless, which);
            which = _o238.which;
            const LANES(court_rolled_on_out) _o239 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o239.clock;
            circling = _o239.rolling;
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
        V when = lanes_load(lists->kept_when + i);
        V which = lanes_load(lists->kept_which + i);
        V x = lanes_load(lists->kept_x + i);
        V y = lanes_load(lists->kept_y + i);
        V z = lanes_load(lists->kept_z + i);
        const LANES(court_rejoined_out) _o240 =
            LANES(court_rejoined)(circling, rolling);
        rolling = _o240.rolling;
        const M _m241 = lanes_both(rows, leaves);
        if (lanes_any(_m241)) {
            const LANES(court_holding_out) _o242 =
                LANES(court_holding)(held, K(0.0));
            M here = _o242.here;
            const M _m243 = lanes_both(_m241, here);
            if (lanes_any(_m243)) {
                const LANES(court_ring_tube_out) _o244 =
                    LANES(court_ring_tube)(p_ball_radius, p_wire_radius);
                per_reach = lanes_select(_m243, _o244.per_reach, per_reach);
                const LANES(court_ring_parting_out) _o245 =
                    LANES(court_ring_parting)(p_gravity, p_ring_radius, vx, vy, vz, x, y, z);
                lift = lanes_select(_m243, _o245.lift, lift);
                surge = lanes_select(_m243, _o245.surge, surge);
                snap = lanes_select(_m243, _o245.snap, snap);
            }
            const LANES(court_holding_out) _o246 =
                LANES(court_holding)(held, K(1.0));
            here = _o246.here;
            const M _m247 = lanes_both(_m241, here);
            if (lanes_any(_m247)) {
                const LANES(court_backboard_tube_out) _o248 =
                    LANES(court_backboard_tube)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                per_reach = lanes_select(_m247, _o248.per_reach, per_reach);
                const LANES(court_backboard_parting_out) _o249 =
                    LANES(court_backboard_parting)(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, vx, vy, vz, x, y, z);
                lift = lanes_select(_m247, _o249.lift, lift);
                surge = lanes_select(_m247, _o249.surge, surge);
                snap = lanes_select(_m247, _o249.snap, snap);
            }
            const LANES(court_holding_out) _o250 =
                LANES(court_holding)(held, K(2.0));
            here = _o250.here;
            const M _m251 = lanes_both(_m241, here);
            if (lanes_any(_m251)) {
                const LANES(court_bridge_tube_out) _o252 =
                    LANES(court_bridge_tube)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                per_reach = lanes_select(_m251, _o252.per_reach, per_reach);
                const LANES(court_bridge_parting_out) _o253 =
                    LANES(court_bridge_parting)(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                lift = lanes_select(_m251, _o253.lift, lift);
                surge = lanes_select(_m251, _o253.surge, surge);
                snap = lanes_select(_m251, _o253.snap, snap);
            }
            const LANES(court_unmet_out) _o254 =
                LANES(court_unmet)();
            V spare = _o254.spare;
            const LANES(court_beside_out) _o255 =
                LANES(court_beside)(held, K(0.0));
            M beside = _o255.beside;
            const M _m256 = lanes_both(_m241, beside);
            if (lanes_any(_m256)) {
                const LANES(court_ring_beside_out) _o257 =
                    LANES(court_ring_beside)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                V gap = _o257.gap;
                V nearing = _o257.nearing;
                V dent = _o257.dent;
                const LANES(court_spared_out) _o258 =
                    LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
                spare = lanes_select(_m256, _o258.spare, spare);
            }
            const LANES(court_beside_out) _o259 =
                LANES(court_beside)(held, K(1.0));
            beside = _o259.beside;
            const M _m260 = lanes_both(_m241, beside);
            if (lanes_any(_m260)) {
                const LANES(court_backboard_beside_out) _o261 =
                    LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                V gap = _o261.gap;
                V nearing = _o261.nearing;
                V dent = _o261.dent;
                const LANES(court_spared_out) _o262 =
                    LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
                spare = lanes_select(_m260, _o262.spare, spare);
            }
            const LANES(court_beside_out) _o263 =
                LANES(court_beside)(held, K(2.0));
            beside = _o263.beside;
            const M _m264 = lanes_both(_m241, beside);
            if (lanes_any(_m264)) {
                const LANES(court_bridge_beside_out) _o265 =
                    LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                V gap = _o265.gap;
                V nearing = _o265.nearing;
                V dent = _o265.dent;
                const LANES(court_spared_out) _o266 =
                    LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
                spare = lanes_select(_m264, _o266.spare, spare);
            }
            const LANES(court_beside_out) _o267 =
                LANES(court_beside)(held, K(3.0));
            beside = _o267.beside;
            const M _m268 = lanes_both(_m241, beside);
            if (lanes_any(_m268)) {
                const LANES(court_end_beside_out) _o269 =
                    LANES(court_end_beside)(p_end_depth, vz, z);
                V gap = _o269.gap;
                V nearing = _o269.nearing;
                V dent = _o269.dent;
                const LANES(court_spared_out) _o270 =
                    LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
                spare = lanes_select(_m268, _o270.spare, spare);
            }
            const LANES(court_holding_out) _o271 =
                LANES(court_holding)(held, K(1.0));
            here = _o271.here;
            const M _m272 = lanes_both(_m241, here);
            if (lanes_any(_m272)) {
                const LANES(court_backboard_seam0_out) _o273 =
                    LANES(court_backboard_seam0)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                V gap = _o273.gap;
                V nearing = _o273.nearing;
                V near = _o273.near;
                const LANES(court_spared_seam_out) _o274 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m272, _o274.spare, spare);
                const LANES(court_backboard_seam1_out) _o275 =
                    LANES(court_backboard_seam1)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                gap = _o275.gap;
                nearing = _o275.nearing;
                near = _o275.near;
                const LANES(court_spared_seam_out) _o276 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m272, _o276.spare, spare);
                const LANES(court_backboard_seam2_out) _o277 =
                    LANES(court_backboard_seam2)(p_ball_radius, p_board_half_width, vy, y);
                gap = _o277.gap;
                nearing = _o277.nearing;
                near = _o277.near;
                const LANES(court_spared_seam_out) _o278 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m272, _o278.spare, spare);
                const LANES(court_backboard_seam3_out) _o279 =
                    LANES(court_backboard_seam3)(p_ball_radius, p_board_half_width, vy, y);
                gap = _o279.gap;
                nearing = _o279.nearing;
                near = _o279.near;
                const LANES(court_spared_seam_out) _o280 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m272, _o280.spare, spare);
                const LANES(court_backboard_seam4_out) _o281 =
                    LANES(court_backboard_seam4)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                gap = _o281.gap;
                nearing = _o281.nearing;
                near = _o281.near;
                const LANES(court_spared_seam_out) _o282 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m272, _o282.spare, spare);
                const LANES(court_backboard_seam5_out) _o283 =
                    LANES(court_backboard_seam5)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                gap = _o283.gap;
                nearing = _o283.nearing;
                near = _o283.near;
                const LANES(court_spared_seam_out) _o284 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m272, _o284.spare, spare);
            }
            const LANES(court_holding_out) _o285 =
                LANES(court_holding)(held, K(2.0));
            here = _o285.here;
            const M _m286 = lanes_both(_m241, here);
            if (lanes_any(_m286)) {
                const LANES(court_bridge_seam0_out) _o287 =
                    LANES(court_bridge_seam0)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                V gap = _o287.gap;
                V nearing = _o287.nearing;
                V near = _o287.near;
                const LANES(court_spared_seam_out) _o288 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m286, _o288.spare, spare);
                const LANES(court_bridge_seam1_out) _o289 =
                    LANES(court_bridge_seam1)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                gap = _o289.gap;
                nearing = _o289.nearing;
                near = _o289.near;
                const LANES(court_spared_seam_out) _o290 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m286, _o290.spare, spare);
                const LANES(court_bridge_seam2_out) _o291 =
                    LANES(court_bridge_seam2)(p_ball_radius, p_bridge_half_width, vy, y);
                gap = _o291.gap;
                nearing = _o291.nearing;
                near = _o291.near;
                const LANES(court_spared_seam_out) _o292 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m286, _o292.spare, spare);
                const LANES(court_bridge_seam3_out) _o293 =
                    LANES(court_bridge_seam3)(p_ball_radius, p_bridge_half_width, vy, y);
                gap = _o293.gap;
                nearing = _o293.nearing;
                near = _o293.near;
                const LANES(court_spared_seam_out) _o294 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m286, _o294.spare, spare);
                const LANES(court_bridge_seam4_out) _o295 =
                    LANES(court_bridge_seam4)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                gap = _o295.gap;
                nearing = _o295.nearing;
                near = _o295.near;
                const LANES(court_spared_seam_out) _o296 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m286, _o296.spare, spare);
                const LANES(court_bridge_seam5_out) _o297 =
                    LANES(court_bridge_seam5)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                gap = _o297.gap;
                nearing = _o297.nearing;
                near = _o297.near;
                const LANES(court_spared_seam_out) _o298 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m286, _o298.spare, spare);
            }
            const LANES(court_parted_out) _o299 =
                LANES(court_parted)(K(INFINITY), p_gravity, lift, per_reach, K(0.0), snap, spare, surge, K(0.0), vx, vy, vz);
            when = lanes_select(_m241, _o299.when, when);
            const LANES(court_hopping_out) _o300 =
                LANES(court_hopping)();
            which = lanes_select(_m241, _o300.which, which);
        }
        lanes_store(lists->kept_rolling + i, lanes_select(rolling, K(1.0), K(0.0)));
        lanes_store(lists->kept_when + i, when);
        lanes_store(lists->kept_which + i, which);
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
        size_t open_searching_shots = 0;
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
            const LANES(court_ring_prepare_out) _o19 =
                LANES(court_ring_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V steady = _o19.steady;
            V swing = _o19.swing;
            V rho_start = _o19.rho_start;
            V low0 = _o19.low0;
            V high0 = _o19.high0;
            V low1 = _o19.low1;
            V high1 = _o19.high1;
            V low2 = _o19.low2;
            V high2 = _o19.high2;
            V ceiling = _o19.ceiling;
            V latest = _o19.latest;
            const LANES(court_beginning_out) _o20 =
                LANES(court_beginning)();
            V share = _o20.share;
            V arrival = _o20.arrival;
            M certain = _o20.certain;
            const LANES(court_allowance_out) _o21 =
                LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
            V position_level = _o21.position_level;
            V velocity_level = _o21.velocity_level;
            const LANES(court_ring_margins_out) _o22 =
                LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V flat = _o22.margin;
            V tilt = _o22.leaving_margin;
            V rate_slack = _o22.rate_margin;
            const LANES(court_ring_enter_out) _o23 =
                LANES(court_ring_enter)(K(0.0), K(0.0), high0, high1, high2, low0, low1, low2, K(0.0));
            V t = _o23.t;
            V end = _o23.end;
            M searching = _o23.searching;
            lanes_store(lists->open_arrival + i, arrival);
            lanes_store(lists->open_certain + i, lanes_select(certain, K(1.0), K(0.0)));
            lanes_store(lists->open_flat + i, flat);
            lanes_store(lists->open_rho_start + i, rho_start);
            lanes_store(lists->open_tilt + i, tilt);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_searching_row + open_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_searching_arrival + open_searching_shots, packed, arrival);
                lanes_pack(lists->open_searching_ceiling + open_searching_shots, packed, ceiling);
                lanes_pack(lists->open_searching_certain + open_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->open_searching_end + open_searching_shots, packed, end);
                lanes_pack(lists->open_searching_extent + open_searching_shots, packed, extent);
                lanes_pack(lists->open_searching_flat + open_searching_shots, packed, flat);
                lanes_pack(lists->open_searching_high0 + open_searching_shots, packed, high0);
                lanes_pack(lists->open_searching_high1 + open_searching_shots, packed, high1);
                lanes_pack(lists->open_searching_high2 + open_searching_shots, packed, high2);
                lanes_pack(lists->open_searching_last + open_searching_shots, packed, last);
                lanes_pack(lists->open_searching_latest + open_searching_shots, packed, latest);
                lanes_pack(lists->open_searching_low0 + open_searching_shots, packed, low0);
                lanes_pack(lists->open_searching_low1 + open_searching_shots, packed, low1);
                lanes_pack(lists->open_searching_low2 + open_searching_shots, packed, low2);
                if (varying)
                    lanes_pack(lists->open_searching_p_ball_radius + open_searching_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_searching_p_gravity + open_searching_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->open_searching_p_ring_radius + open_searching_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->open_searching_p_wire_radius + open_searching_shots, packed, p_wire_radius);
                lanes_pack(lists->open_searching_rate_slack + open_searching_shots, packed, rate_slack);
                lanes_pack(lists->open_searching_rho_start + open_searching_shots, packed, rho_start);
                lanes_pack(lists->open_searching_share + open_searching_shots, packed, share);
                lanes_pack(lists->open_searching_speed + open_searching_shots, packed, speed);
                lanes_pack(lists->open_searching_steady + open_searching_shots, packed, steady);
                lanes_pack(lists->open_searching_swing + open_searching_shots, packed, swing);
                lanes_pack(lists->open_searching_t + open_searching_shots, packed, t);
                lanes_pack(lists->open_searching_tilt + open_searching_shots, packed, tilt);
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
                if (taken < open_searching_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->open_searching_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->open_searching_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->open_searching_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->open_searching_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    end = lanes_expand(lists->open_searching_end + taken, idle, end);
                    extent = lanes_expand(lists->open_searching_extent + taken, idle, extent);
                    flat = lanes_expand(lists->open_searching_flat + taken, idle, flat);
                    high0 = lanes_expand(lists->open_searching_high0 + taken, idle, high0);
                    high1 = lanes_expand(lists->open_searching_high1 + taken, idle, high1);
                    high2 = lanes_expand(lists->open_searching_high2 + taken, idle, high2);
                    last = lanes_expand(lists->open_searching_last + taken, idle, last);
                    latest = lanes_expand(lists->open_searching_latest + taken, idle, latest);
                    low0 = lanes_expand(lists->open_searching_low0 + taken, idle, low0);
                    low1 = lanes_expand(lists->open_searching_low1 + taken, idle, low1);
                    low2 = lanes_expand(lists->open_searching_low2 + taken, idle, low2);
                    rate_slack = lanes_expand(lists->open_searching_rate_slack + taken, idle, rate_slack);
                    rho_start = lanes_expand(lists->open_searching_rho_start + taken, idle, rho_start);
                    share = lanes_expand(lists->open_searching_share + taken, idle, share);
                    speed = lanes_expand(lists->open_searching_speed + taken, idle, speed);
                    steady = lanes_expand(lists->open_searching_steady + taken, idle, steady);
                    swing = lanes_expand(lists->open_searching_swing + taken, idle, swing);
                    t = lanes_expand(lists->open_searching_t + taken, idle, t);
                    tilt = lanes_expand(lists->open_searching_tilt + taken, idle, tilt);
                    vx = lanes_expand(lists->open_searching_vx + taken, idle, vx);
                    vy = lanes_expand(lists->open_searching_vy + taken, idle, vy);
                    vz = lanes_expand(lists->open_searching_vz + taken, idle, vz);
                    x = lanes_expand(lists->open_searching_x + taken, idle, x);
                    y = lanes_expand(lists->open_searching_y + taken, idle, y);
                    z = lanes_expand(lists->open_searching_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->open_searching_p_ball_radius + taken, idle, p_ball_radius);
                        p_gravity = lanes_expand(lists->open_searching_p_gravity + taken, idle, p_gravity);
                        p_ring_radius = lanes_expand(lists->open_searching_p_ring_radius + taken, idle, p_ring_radius);
                        p_wire_radius = lanes_expand(lists->open_searching_p_wire_radius + taken, idle, p_wire_radius);
                    }
                    const size_t room = LANES_WIDTH - busy, left = open_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o24 =
                    LANES(court_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = _o24.leaving;
                V margin = _o24.margin;
                const LANES(court_ring_advance_out) _o25 =
                    LANES(court_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V gap = _o25.gap;
                V rate = _o25.rate;
                V bend = _o25.bend;
                V step = _o25.step;
                V next = _o25.next;
                V root = _o25.root;
                V clearance = _o25.clearance;
                const LANES(court_struck_out) _o26 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o26.hit;
                M sure = _o26.sure;
                M vague = _o26.vague;
                const M _m27 = lanes_both(active, vague);
                if (lanes_any(_m27)) {
                    const LANES(court_finer_out) _o28 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m27, _o28.share, share);
                    const LANES(court_allowance_out) _o29 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
                    V position_level = _o29.position_level;
                    V velocity_level = _o29.velocity_level;
                    const LANES(court_ring_margins_out) _o30 =
                        LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    flat = lanes_select(_m27, _o30.margin, flat);
                    tilt = lanes_select(_m27, _o30.leaving_margin, tilt);
                    rate_slack = lanes_select(_m27, _o30.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o31 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, root, step, sure, t, vague);
                arrival = _o31.arrival;
                certain = _o31.certain;
                M exhausted = _o31.exhausted;
                searching = _o31.searching;
                t = _o31.t;
                const M _m32 = lanes_both(active, exhausted);
                {
                    const LANES(court_ring_enter_out) _o33 =
                        LANES(court_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m32, _o33.t, t);
                    end = lanes_select(_m32, _o33.end, end);
                    searching = lanes_choose(_m32, _o33.searching, searching);
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
                        lists->open_arrival[k] = ended_arrival[lane];
                        lists->open_certain[k] = ended_certain[lane];
                        lists->open_flat[k] = ended_flat[lane];
                        lists->open_tilt[k] = ended_tilt[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            V arrival = lanes_load(lists->open_arrival + i);
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
            V when = lanes_load(lists->open_when + i);
            V which = lanes_load(lists->open_which + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(court_found_out) _o34 =
                LANES(court_found)(arrival);
            M arrives = _o34.arrives;
            const LANES(court_nearby_out) _o35 =
                LANES(court_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o35.leaving;
            const LANES(court_ring_refine_out) _o36 =
                LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V refined = _o36.time;
            const LANES(court_polished_out) _o37 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o37.arrival;
            const LANES(court_ring_refine_out) _o38 =
                LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            refined = _o38.time;
            const LANES(court_polished_out) _o39 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o39.arrival;
            const LANES(court_landed_out) _o40 =
                LANES(court_landed)(arrival);
            V time = _o40.time;
            const LANES(court_sooner_out) _o41 =
                LANES(court_sooner)(arrives, K(0.0), time, when, which);
            when = _o41.when;
            which = _o41.which;
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
        size_t open_shots = 0;
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
            const LANES(court_horizon_out) _o42 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o42.horizon;
            const LANES(court_backboard_clear_out) _o43 =
                LANES(court_backboard_clear)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V clear = _o43.clear;
            const LANES(court_opens_in_flight_out) _o44 =
                LANES(court_opens_in_flight)(clear, kept);
            M open = _o44.open;
            const M packed = lanes_both(rows, open);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_row + open_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_extent + open_shots, packed, extent);
                lanes_pack(lists->open_last + open_shots, packed, last);
                if (varying)
                    lanes_pack(lists->open_p_ball_radius + open_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_p_board_bottom + open_shots, packed, p_board_bottom);
                if (varying)
                    lanes_pack(lists->open_p_board_distance + open_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->open_p_board_half_width + open_shots, packed, p_board_half_width);
                if (varying)
                    lanes_pack(lists->open_p_board_thickness + open_shots, packed, p_board_thickness);
                if (varying)
                    lanes_pack(lists->open_p_board_top + open_shots, packed, p_board_top);
                if (varying)
                    lanes_pack(lists->open_p_gravity + open_shots, packed, p_gravity);
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
        size_t open_searching_shots = 0;
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_shots - i);
            V extent = lanes_load(lists->open_extent + i);
            V last = lanes_load(lists->open_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_bottom = lanes_load(varying ? lists->open_p_board_bottom + i : lists->p_board_bottom);
            const V p_board_distance = lanes_load(varying ? lists->open_p_board_distance + i : lists->p_board_distance);
            const V p_board_half_width = lanes_load(varying ? lists->open_p_board_half_width + i : lists->p_board_half_width);
            const V p_board_thickness = lanes_load(varying ? lists->open_p_board_thickness + i : lists->p_board_thickness);
            const V p_board_top = lanes_load(varying ? lists->open_p_board_top + i : lists->p_board_top);
            const V p_gravity = lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity);
            V speed = lanes_load(lists->open_speed + i);
            V until = lanes_load(lists->open_until + i);
            V vx = lanes_load(lists->open_vx + i);
            V vy = lanes_load(lists->open_vy + i);
            V vz = lanes_load(lists->open_vz + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(court_backboard_prepare_out) _o45 =
                LANES(court_backboard_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V low0 = _o45.low0;
            V high0 = _o45.high0;
            V low1 = _o45.low1;
            V high1 = _o45.high1;
            V ceiling = _o45.ceiling;
            V latest = _o45.latest;
            const LANES(court_beginning_out) _o46 =
                LANES(court_beginning)();
            V share = _o46.share;
            V arrival = _o46.arrival;
            M certain = _o46.certain;
            const LANES(court_allowance_out) _o47 =
                LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
            V position_level = _o47.position_level;
            V velocity_level = _o47.velocity_level;
            const LANES(court_backboard_margins_out) _o48 =
                LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V flat = _o48.margin;
            V tilt = _o48.leaving_margin;
            V rate_slack = _o48.rate_margin;
            const LANES(court_backboard_enter_out) _o49 =
                LANES(court_backboard_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o49.t;
            V end = _o49.end;
            M searching = _o49.searching;
            lanes_store(lists->open_arrival + i, arrival);
            lanes_store(lists->open_certain + i, lanes_select(certain, K(1.0), K(0.0)));
            lanes_store(lists->open_flat + i, flat);
            lanes_store(lists->open_tilt + i, tilt);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_searching_row + open_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_searching_arrival + open_searching_shots, packed, arrival);
                lanes_pack(lists->open_searching_ceiling + open_searching_shots, packed, ceiling);
                lanes_pack(lists->open_searching_certain + open_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->open_searching_end + open_searching_shots, packed, end);
                lanes_pack(lists->open_searching_extent + open_searching_shots, packed, extent);
                lanes_pack(lists->open_searching_flat + open_searching_shots, packed, flat);
                lanes_pack(lists->open_searching_high0 + open_searching_shots, packed, high0);
                lanes_pack(lists->open_searching_high1 + open_searching_shots, packed, high1);
                lanes_pack(lists->open_searching_last + open_searching_shots, packed, last);
                lanes_pack(lists->open_searching_latest + open_searching_shots, packed, latest);
                lanes_pack(lists->open_searching_low0 + open_searching_shots, packed, low0);
                lanes_pack(lists->open_searching_low1 + open_searching_shots, packed, low1);
                if (varying)
                    lanes_pack(lists->open_searching_p_ball_radius + open_searching_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_searching_p_board_bottom + open_searching_shots, packed, p_board_bottom);
                if (varying)
                    lanes_pack(lists->open_searching_p_board_distance + open_searching_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->open_searching_p_board_half_width + open_searching_shots, packed, p_board_half_width);
                if (varying)
                    lanes_pack(lists->open_searching_p_board_thickness + open_searching_shots, packed, p_board_thickness);
                if (varying)
                    lanes_pack(lists->open_searching_p_board_top + open_searching_shots, packed, p_board_top);
                if (varying)
                    lanes_pack(lists->open_searching_p_gravity + open_searching_shots, packed, p_gravity);
                lanes_pack(lists->open_searching_rate_slack + open_searching_shots, packed, rate_slack);
                lanes_pack(lists->open_searching_share + open_searching_shots, packed, share);
                lanes_pack(lists->open_searching_speed + open_searching_shots, packed, speed);
                lanes_pack(lists->open_searching_t + open_searching_shots, packed, t);
                lanes_pack(lists->open_searching_tilt + open_searching_shots, packed, tilt);
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
                if (taken < open_searching_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->open_searching_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->open_searching_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->open_searching_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->open_searching_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    end = lanes_expand(lists->open_searching_end + taken, idle, end);
                    extent = lanes_expand(lists->open_searching_extent + taken, idle, extent);
                    flat = lanes_expand(lists->open_searching_flat + taken, idle, flat);
                    high0 = lanes_expand(lists->open_searching_high0 + taken, idle, high0);
                    high1 = lanes_expand(lists->open_searching_high1 + taken, idle, high1);
                    last = lanes_expand(lists->open_searching_last + taken, idle, last);
                    latest = lanes_expand(lists->open_searching_latest + taken, idle, latest);
                    low0 = lanes_expand(lists->open_searching_low0 + taken, idle, low0);
                    low1 = lanes_expand(lists->open_searching_low1 + taken, idle, low1);
                    rate_slack = lanes_expand(lists->open_searching_rate_slack + taken, idle, rate_slack);
                    share = lanes_expand(lists->open_searching_share + taken, idle, share);
                    speed = lanes_expand(lists->open_searching_speed + taken, idle, speed);
                    t = lanes_expand(lists->open_searching_t + taken, idle, t);
                    tilt = lanes_expand(lists->open_searching_tilt + taken, idle, tilt);
                    vx = lanes_expand(lists->open_searching_vx + taken, idle, vx);
                    vy = lanes_expand(lists->open_searching_vy + taken, idle, vy);
                    vz = lanes_expand(lists->open_searching_vz + taken, idle, vz);
                    x = lanes_expand(lists->open_searching_x + taken, idle, x);
                    y = lanes_expand(lists->open_searching_y + taken, idle, y);
                    z = lanes_expand(lists->open_searching_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->open_searching_p_ball_radius + taken, idle, p_ball_radius);
                        p_board_bottom = lanes_expand(lists->open_searching_p_board_bottom + taken, idle, p_board_bottom);
                        p_board_distance = lanes_expand(lists->open_searching_p_board_distance + taken, idle, p_board_distance);
                        p_board_half_width = lanes_expand(lists->open_searching_p_board_half_width + taken, idle, p_board_half_width);
                        p_board_thickness = lanes_expand(lists->open_searching_p_board_thickness + taken, idle, p_board_thickness);
                        p_board_top = lanes_expand(lists->open_searching_p_board_top + taken, idle, p_board_top);
                        p_gravity = lanes_expand(lists->open_searching_p_gravity + taken, idle, p_gravity);
                    }
                    const size_t room = LANES_WIDTH - busy, left = open_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o50 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o50.leaving;
                V margin = _o50.margin;
                const LANES(court_backboard_advance_out) _o51 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V gap = _o51.gap;
                V rate = _o51.rate;
                V bend = _o51.bend;
                V step = _o51.step;
                V next = _o51.next;
                V root = _o51.root;
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
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
                    V position_level = _o55.position_level;
                    V velocity_level = _o55.velocity_level;
                    const LANES(court_backboard_margins_out) _o56 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                    flat = lanes_select(_m53, _o56.margin, flat);
                    tilt = lanes_select(_m53, _o56.leaving_margin, tilt);
                    rate_slack = lanes_select(_m53, _o56.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o57 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, root, step, sure, t, vague);
                arrival = _o57.arrival;
                certain = _o57.certain;
                M exhausted = _o57.exhausted;
                searching = _o57.searching;
                t = _o57.t;
                const M _m58 = lanes_both(active, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o59 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m58, _o59.t, t);
                    end = lanes_select(_m58, _o59.end, end);
                    searching = lanes_choose(_m58, _o59.searching, searching);
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
                        lists->open_arrival[k] = ended_arrival[lane];
                        lists->open_certain[k] = ended_certain[lane];
                        lists->open_flat[k] = ended_flat[lane];
                        lists->open_tilt[k] = ended_tilt[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            V arrival = lanes_load(lists->open_arrival + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_certain + i));
            V flat = lanes_load(lists->open_flat + i);
            V last = lanes_load(lists->open_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_bottom = lanes_load(varying ? lists->open_p_board_bottom + i : lists->p_board_bottom);
            const V p_board_distance = lanes_load(varying ? lists->open_p_board_distance + i : lists->p_board_distance);
            const V p_board_half_width = lanes_load(varying ? lists->open_p_board_half_width + i : lists->p_board_half_width);
            const V p_board_thickness = lanes_load(varying ? lists->open_p_board_thickness + i : lists->p_board_thickness);
            const V p_board_top = lanes_load(varying ? lists->open_p_board_top + i : lists->p_board_top);
            const V p_gravity = lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity);
            V tilt = lanes_load(lists->open_tilt + i);
            V vx = lanes_load(lists->open_vx + i);
            V vy = lanes_load(lists->open_vy + i);
            V vz = lanes_load(lists->open_vz + i);
            V when = lanes_load(lists->open_when + i);
            V which = lanes_load(lists->open_which + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(court_found_out) _o60 =
                LANES(court_found)(arrival);
            M arrives = _o60.arrives;
            const LANES(court_nearby_out) _o61 =
                LANES(court_nearby)(flat, K(1.0), last, arrival, tilt);
            V leaving = _o61.leaving;
            const LANES(court_backboard_refine_out) _o62 =
                LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V refined = _o62.time;
            const LANES(court_polished_out) _o63 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o63.arrival;
            const LANES(court_backboard_refine_out) _o64 =
                LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            refined = _o64.time;
            const LANES(court_polished_out) _o65 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o65.arrival;
            const LANES(court_landed_out) _o66 =
                LANES(court_landed)(arrival);
            V time = _o66.time;
            const LANES(court_sooner_out) _o67 =
                LANES(court_sooner)(arrives, K(1.0), time, when, which);
            when = _o67.when;
            which = _o67.which;
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
        size_t open_shots = 0;
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
            const LANES(court_horizon_out) _o68 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o68.horizon;
            const LANES(court_bridge_clear_out) _o69 =
                LANES(court_bridge_clear)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V clear = _o69.clear;
            const LANES(court_opens_in_flight_out) _o70 =
                LANES(court_opens_in_flight)(clear, kept);
            M open = _o70.open;
            const M packed = lanes_both(rows, open);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_row + open_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_extent + open_shots, packed, extent);
                lanes_pack(lists->open_last + open_shots, packed, last);
                if (varying)
                    lanes_pack(lists->open_p_ball_radius + open_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_p_board_distance + open_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->open_p_bridge_depth + open_shots, packed, p_bridge_depth);
                if (varying)
                    lanes_pack(lists->open_p_bridge_half_width + open_shots, packed, p_bridge_half_width);
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
        size_t open_searching_shots = 0;
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_shots - i);
            V extent = lanes_load(lists->open_extent + i);
            V last = lanes_load(lists->open_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_distance = lanes_load(varying ? lists->open_p_board_distance + i : lists->p_board_distance);
            const V p_bridge_depth = lanes_load(varying ? lists->open_p_bridge_depth + i : lists->p_bridge_depth);
            const V p_bridge_half_width = lanes_load(varying ? lists->open_p_bridge_half_width + i : lists->p_bridge_half_width);
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
            const LANES(court_bridge_prepare_out) _o71 =
                LANES(court_bridge_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V low0 = _o71.low0;
            V high0 = _o71.high0;
            V low1 = _o71.low1;
            V high1 = _o71.high1;
            V ceiling = _o71.ceiling;
            V latest = _o71.latest;
            const LANES(court_beginning_out) _o72 =
                LANES(court_beginning)();
            V share = _o72.share;
            V arrival = _o72.arrival;
            M certain = _o72.certain;
            const LANES(court_allowance_out) _o73 =
                LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
            V position_level = _o73.position_level;
            V velocity_level = _o73.velocity_level;
            const LANES(court_bridge_margins_out) _o74 =
                LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V flat = _o74.margin;
            V tilt = _o74.leaving_margin;
            V rate_slack = _o74.rate_margin;
            const LANES(court_bridge_enter_out) _o75 =
                LANES(court_bridge_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o75.t;
            V end = _o75.end;
            M searching = _o75.searching;
            lanes_store(lists->open_arrival + i, arrival);
            lanes_store(lists->open_certain + i, lanes_select(certain, K(1.0), K(0.0)));
            lanes_store(lists->open_flat + i, flat);
            lanes_store(lists->open_tilt + i, tilt);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_searching_row + open_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_searching_arrival + open_searching_shots, packed, arrival);
                lanes_pack(lists->open_searching_ceiling + open_searching_shots, packed, ceiling);
                lanes_pack(lists->open_searching_certain + open_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->open_searching_end + open_searching_shots, packed, end);
                lanes_pack(lists->open_searching_extent + open_searching_shots, packed, extent);
                lanes_pack(lists->open_searching_flat + open_searching_shots, packed, flat);
                lanes_pack(lists->open_searching_high0 + open_searching_shots, packed, high0);
                lanes_pack(lists->open_searching_high1 + open_searching_shots, packed, high1);
                lanes_pack(lists->open_searching_last + open_searching_shots, packed, last);
                lanes_pack(lists->open_searching_latest + open_searching_shots, packed, latest);
                lanes_pack(lists->open_searching_low0 + open_searching_shots, packed, low0);
                lanes_pack(lists->open_searching_low1 + open_searching_shots, packed, low1);
                if (varying)
                    lanes_pack(lists->open_searching_p_ball_radius + open_searching_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_searching_p_board_distance + open_searching_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->open_searching_p_bridge_depth + open_searching_shots, packed, p_bridge_depth);
                if (varying)
                    lanes_pack(lists->open_searching_p_bridge_half_width + open_searching_shots, packed, p_bridge_half_width);
                if (varying)
                    lanes_pack(lists->open_searching_p_gravity + open_searching_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->open_searching_p_ring_radius + open_searching_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->open_searching_p_wire_radius + open_searching_shots, packed, p_wire_radius);
                lanes_pack(lists->open_searching_rate_slack + open_searching_shots, packed, rate_slack);
                lanes_pack(lists->open_searching_share + open_searching_shots, packed, share);
                lanes_pack(lists->open_searching_speed + open_searching_shots, packed, speed);
                lanes_pack(lists->open_searching_t + open_searching_shots, packed, t);
                lanes_pack(lists->open_searching_tilt + open_searching_shots, packed, tilt);
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
                if (taken < open_searching_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->open_searching_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->open_searching_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->open_searching_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->open_searching_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    end = lanes_expand(lists->open_searching_end + taken, idle, end);
                    extent = lanes_expand(lists->open_searching_extent + taken, idle, extent);
                    flat = lanes_expand(lists->open_searching_flat + taken, idle, flat);
                    high0 = lanes_expand(lists->open_searching_high0 + taken, idle, high0);
                    high1 = lanes_expand(lists->open_searching_high1 + taken, idle, high1);
                    last = lanes_expand(lists->open_searching_last + taken, idle, last);
                    latest = lanes_expand(lists->open_searching_latest + taken, idle, latest);
                    low0 = lanes_expand(lists->open_searching_low0 + taken, idle, low0);
                    low1 = lanes_expand(lists->open_searching_low1 + taken, idle, low1);
                    rate_slack = lanes_expand(lists->open_searching_rate_slack + taken, idle, rate_slack);
                    share = lanes_expand(lists->open_searching_share + taken, idle, share);
                    speed = lanes_expand(lists->open_searching_speed + taken, idle, speed);
                    t = lanes_expand(lists->open_searching_t + taken, idle, t);
                    tilt = lanes_expand(lists->open_searching_tilt + taken, idle, tilt);
                    vx = lanes_expand(lists->open_searching_vx + taken, idle, vx);
                    vy = lanes_expand(lists->open_searching_vy + taken, idle, vy);
                    vz = lanes_expand(lists->open_searching_vz + taken, idle, vz);
                    x = lanes_expand(lists->open_searching_x + taken, idle, x);
                    y = lanes_expand(lists->open_searching_y + taken, idle, y);
                    z = lanes_expand(lists->open_searching_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->open_searching_p_ball_radius + taken, idle, p_ball_radius);
                        p_board_distance = lanes_expand(lists->open_searching_p_board_distance + taken, idle, p_board_distance);
                        p_bridge_depth = lanes_expand(lists->open_searching_p_bridge_depth + taken, idle, p_bridge_depth);
                        p_bridge_half_width = lanes_expand(lists->open_searching_p_bridge_half_width + taken, idle, p_bridge_half_width);
                        p_gravity = lanes_expand(lists->open_searching_p_gravity + taken, idle, p_gravity);
                        p_ring_radius = lanes_expand(lists->open_searching_p_ring_radius + taken, idle, p_ring_radius);
                        p_wire_radius = lanes_expand(lists->open_searching_p_wire_radius + taken, idle, p_wire_radius);
                    }
                    const size_t room = LANES_WIDTH - busy, left = open_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o76 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o76.leaving;
                V margin = _o76.margin;
                const LANES(court_bridge_advance_out) _o77 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V gap = _o77.gap;
                V rate = _o77.rate;
                V bend = _o77.bend;
                V step = _o77.step;
                V next = _o77.next;
                V root = _o77.root;
                V clearance = _o77.clearance;
                const LANES(court_struck_out) _o78 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o78.hit;
                M sure = _o78.sure;
                M vague = _o78.vague;
                const M _m79 = lanes_both(active, vague);
                if (lanes_any(_m79)) {
                    const LANES(court_finer_out) _o80 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m79, _o80.share, share);
                    const LANES(court_allowance_out) _o81 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
                    V position_level = _o81.position_level;
                    V velocity_level = _o81.velocity_level;
                    const LANES(court_bridge_margins_out) _o82 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                    flat = lanes_select(_m79, _o82.margin, flat);
                    tilt = lanes_select(_m79, _o82.leaving_margin, tilt);
                    rate_slack = lanes_select(_m79, _o82.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o83 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, root, step, sure, t, vague);
                arrival = _o83.arrival;
                certain = _o83.certain;
                M exhausted = _o83.exhausted;
                searching = _o83.searching;
                t = _o83.t;
                const M _m84 = lanes_both(active, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o85 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m84, _o85.t, t);
                    end = lanes_select(_m84, _o85.end, end);
                    searching = lanes_choose(_m84, _o85.searching, searching);
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
                        lists->open_arrival[k] = ended_arrival[lane];
                        lists->open_certain[k] = ended_certain[lane];
                        lists->open_flat[k] = ended_flat[lane];
                        lists->open_tilt[k] = ended_tilt[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            V arrival = lanes_load(lists->open_arrival + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_certain + i));
            V flat = lanes_load(lists->open_flat + i);
            V last = lanes_load(lists->open_last + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_distance = lanes_load(varying ? lists->open_p_board_distance + i : lists->p_board_distance);
            const V p_bridge_depth = lanes_load(varying ? lists->open_p_bridge_depth + i : lists->p_bridge_depth);
            const V p_bridge_half_width = lanes_load(varying ? lists->open_p_bridge_half_width + i : lists->p_bridge_half_width);
            const V p_gravity = lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->open_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->open_p_wire_radius + i : lists->p_wire_radius);
            V tilt = lanes_load(lists->open_tilt + i);
            V vx = lanes_load(lists->open_vx + i);
            V vy = lanes_load(lists->open_vy + i);
            V vz = lanes_load(lists->open_vz + i);
            V when = lanes_load(lists->open_when + i);
            V which = lanes_load(lists->open_which + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(court_found_out) _o86 =
                LANES(court_found)(arrival);
            M arrives = _o86.arrives;
            const LANES(court_nearby_out) _o87 =
                LANES(court_nearby)(flat, K(2.0), last, arrival, tilt);
            V leaving = _o87.leaving;
            const LANES(court_bridge_refine_out) _o88 =
                LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V refined = _o88.time;
            const LANES(court_polished_out) _o89 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o89.arrival;
            const LANES(court_bridge_refine_out) _o90 =
                LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            refined = _o90.time;
            const LANES(court_polished_out) _o91 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o91.arrival;
            const LANES(court_landed_out) _o92 =
                LANES(court_landed)(arrival);
            V time = _o92.time;
            const LANES(court_sooner_out) _o93 =
                LANES(court_sooner)(arrives, K(2.0), time, when, which);
            when = _o93.when;
            which = _o93.which;
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
            const M _m94 = lanes_both(rows, limited);
            if (lanes_any(_m94)) {
                const LANES(court_expiry_out) _o95 =
                    LANES(court_expiry)(clock, K(INFINITY), K(0.0), time_error, time_limit, when, which);
                V time = _o95.time;
                M arrives = _o95.arrives;
                const LANES(court_sooner_out) _o96 =
                    LANES(court_sooner)(arrives, K(4.0), time, when, which);
                when = lanes_select(_m94, _o96.when, when);
                which = lanes_select(_m94, _o96.which, which);
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
            const LANES(court_departed_out) _o301 =
                LANES(court_departed)(K(3.0), which);
            M moves = _o301.moves;
            M ends = _o301.ends;
            M touches = _o301.touches;
            V reached = _o301.reached;
            const LANES(court_body_of_out) _o302 =
                LANES(court_body_of)(which);
            V body = _o302.body;
            const M _m303 = lanes_both(rows, moves);
            if (lanes_any(_m303)) {
                const LANES(court_passing_out) _o304 =
                    LANES(court_passing)(through, when, x, y, z, vx, vy, vz, p_ring_radius, p_gravity);
                through = lanes_select(_m303, _o304.through, through);
                const LANES(court_flight_out) _o305 =
                    LANES(court_flight)(when, x, y, z, vx, vy, vz, p_gravity);
                x = lanes_select(_m303, _o305.x, x);
                y = lanes_select(_m303, _o305.y, y);
                z = lanes_select(_m303, _o305.z, z);
                vx = lanes_select(_m303, _o305.vx, vx);
                vy = lanes_select(_m303, _o305.vy, vy);
                vz = lanes_select(_m303, _o305.vz, vz);
                const LANES(court_ticked_out) _o306 =
                    LANES(court_ticked)(clock, when);
                clock = lanes_select(_m303, _o306.clock, clock);
            }
            const M _m307 = lanes_both(rows, limited);
            if (lanes_any(_m307)) {
                const LANES(court_expired_out) _o308 =
                    LANES(court_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m307, _o308.clock, clock);
                body = lanes_select(_m307, _o308.body, body);
                reached = lanes_select(_m307, _o308.reached, reached);
                ends = lanes_choose(_m307, _o308.ends, ends);
            }
            const M _m309 = lanes_both(rows, kept);
            if (lanes_any(_m309)) {
                const LANES(court_kept_on_out) _o310 =
                    LANES(court_kept_on)(began, body, clock, K(INFINITY), ends, held, last, reached, rests, rolling, rolls, which);
                body = lanes_select(_m309, _o310.body, body);
                reached = lanes_select(_m309, _o310.reached, reached);
                ends = lanes_choose(_m309, _o310.ends, ends);
                last = lanes_select(_m309, _o310.last, last);
                mode = lanes_select(_m309, _o310.mode, mode);
                held = lanes_select(_m309, _o310.held, held);
                rolls = lanes_select(_m309, _o310.rolls, rolls);
            }
            const LANES(court_here_out) _o311 =
                LANES(court_here)(K(3.0), which);
            M here = _o311.here;
            const M _m312 = lanes_both(rows, here);
            {
                const LANES(court_end_bounds_out) _o313 =
                    LANES(court_end_bounds)(x, y, p_ring_radius);
                V g0 = _o313.g0;
                const LANES(court_end_reached_out) _o314 =
                    LANES(court_end_reached)(g0, through);
                reached = lanes_select(_m312, _o314.reached, reached);
            }
            const LANES(court_accounted_out) _o315 =
                LANES(court_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o315.contacts;
            V outcome = _o315.outcome;
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
            const LANES(court_meeting_out) _o316 =
                LANES(court_meeting)(K(0.0), ends, touches);
            M meeting = _o316.meeting;
            const M _m317 = lanes_both(rows, meeting);
            if (lanes_any(_m317)) {
                const LANES(court_end_normal_out) _o318 =
                    LANES(court_end_normal)();
                V nx = _o318.nx;
                V ny = _o318.ny;
                V nz = _o318.nz;
                const LANES(court_here_out) _o319 =
                    LANES(court_here)(K(0.0), which);
                M here = _o319.here;
                const M _m320 = lanes_both(_m317, here);
                {
                    const LANES(court_ring_normal_out) _o321 =
                        LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m320, _o321.nx, nx);
                    ny = lanes_select(_m320, _o321.ny, ny);
                    nz = lanes_select(_m320, _o321.nz, nz);
                    const LANES(court_counted_out) _o322 =
                        LANES(court_counted)(count_0);
                    count_0 = lanes_select(_m320, _o322.count, count_0);
                }
                const LANES(court_here_out) _o323 =
                    LANES(court_here)(K(1.0), which);
                here = _o323.here;
                const M _m324 = lanes_both(_m317, here);
                {
                    const LANES(court_backboard_normal_out) _o325 =
                        LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m324, _o325.nx, nx);
                    ny = lanes_select(_m324, _o325.ny, ny);
                    nz = lanes_select(_m324, _o325.nz, nz);
                    const LANES(court_counted_out) _o326 =
                        LANES(court_counted)(count_1);
                    count_1 = lanes_select(_m324, _o326.count, count_1);
                }
                const LANES(court_here_out) _o327 =
                    LANES(court_here)(K(2.0), which);
                here = _o327.here;
                const M _m328 = lanes_both(_m317, here);
                {
                    const LANES(court_bridge_normal_out) _o329 =
                        LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m328, _o329.nx, nx);
                    ny = lanes_select(_m328, _o329.ny, ny);
                    nz = lanes_select(_m328, _o329.nz, nz);
                    const LANES(court_counted_out) _o330 =
                        LANES(court_counted)(count_2);
                    count_2 = lanes_select(_m328, _o330.count, count_2);
                }
                const LANES(court_untaken_out) _o331 =
                    LANES(court_untaken)();
                M struck_0 = _o331.mine;
                const LANES(court_ring_impact_taken_out) _o332 =
                    LANES(court_ring_impact_taken)(p_ring_restitution, p_ring_friction);
                V its_0_ring_impact = _o332.its_0;
                V its_1_ring_impact = _o332.its_1;
                {
                    const double *const _t334[][2] = {
                        {lists->p_ring_friction, lists->p_ring_restitution},
                        {lists->p_backboard_friction, lists->p_backboard_restitution},
                        {lists->p_bridge_friction, lists->p_bridge_restitution},
                    };
                    static const double _t335[][1] = {
                        {0.0},
                        {1.0},
                        {2.0},
                    };
                    for (size_t _k333 = 0; _k333 < 3; _k333++) {
                        const V own_1 = lanes_load(_t334[_k333][0] + (i & varying));
                        const V own_2 = lanes_load(_t334[_k333][1] + (i & varying));
                        const V own_index = K(_t335[_k333][0]);
                        const LANES(court_here_out) _o336 =
                            LANES(court_here)(own_index, which);
                        M here = _o336.here;
                        const M _m337 = lanes_both(_m317, here);
                        if (lanes_any(_m337)) {
                            const LANES(court_ring_impact_taken_out) _o338 =
                                LANES(court_ring_impact_taken)(own_2, own_1);
                            struck_0 = lanes_choose(_m337, _o338.mine, struck_0);
                            its_0_ring_impact = lanes_select(_m337, _o338.its_0, its_0_ring_impact);
                            its_1_ring_impact = lanes_select(_m337, _o338.its_1, its_1_ring_impact);
                        }
                    }
                }
                const M _m339 = lanes_both(_m317, struck_0);
                if (lanes_any(_m339)) {
                    const LANES(court_ring_impact_out) _o340 =
                        LANES(court_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, its_0_ring_impact, its_1_ring_impact, p_tangential_restitution, p_restitution_speed);
                    vx = lanes_select(_m339, _o340.vx, vx);
                    vy = lanes_select(_m339, _o340.vy, vy);
                    vz = lanes_select(_m339, _o340.vz, vz);
                    wx = lanes_select(_m339, _o340.wx, wx);
                    wy = lanes_select(_m339, _o340.wy, wy);
                    wz = lanes_select(_m339, _o340.wz, wz);
                }
                const M _m341 = lanes_both(_m317, touches);
                {
                    const LANES(court_touched_out) _o342 =
                        LANES(court_touched)(body, first, which);
                    first = lanes_select(_m341, _o342.first, first);
                    last = lanes_select(_m341, _o342.last, last);
                }
                const M _m343 = lanes_both(_m317, touches);
                if (lanes_any(_m343)) {
                    const LANES(court_slowed_out) _o344 =
                        LANES(court_slowed)(p_ball_radius, p_gravity, nx, ny, nz, K(0.0), vx, vy, vz);
                    M slow = _o344.slow;
                    M nearly = _o344.nearly;
                    const M _m345 = lanes_both(_m343, slow);
                    if (lanes_any(_m345)) {
                        const LANES(court_gripped_out) _o346 =
                            LANES(court_gripped)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
                        V rolled_x = _o346.rolled_x;
                        V rolled_y = _o346.rolled_y;
                        V rolled_z = _o346.rolled_z;
                        V slip = _o346.slip;
                        V bounce = _o346.bounce;
                        const LANES(court_here_out) _o347 =
                            LANES(court_here)(K(0.0), which);
                        M here = _o347.here;
                        const M _m348 = lanes_both(_m345, here);
                        if (lanes_any(_m348)) {
                            const LANES(court_ring_turning_out) _o349 =
                                LANES(court_ring_turning)(p_ball_radius, p_ring_radius, rolled_x, rolled_y, rolled_z, p_wire_radius, x, y);
                            V turning_x = _o349.turning_x;
                            V turning_y = _o349.turning_y;
                            V turning_z = _o349.turning_z;
                            const LANES(court_pressed_on_out) _o350 =
                                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
                            V press = _o350.press;
                            V weight = _o350.weight;
                            V drag = _o350.drag;
                            V thrust_x = _o350.thrust_x;
                            V thrust_y = _o350.thrust_y;
                            V thrust_z = _o350.thrust_z;
                            const LANES(court_alone_out) _o351 =
                                LANES(court_alone)();
                            V nearest = _o351.nearest;
                            V wedge = _o351.wedge;
                            const LANES(court_backboard_closing_out) _o352 =
                                LANES(court_backboard_closing)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z);
                            V gap = _o352.gap;
                            V nearing = _o352.nearing;
                            V swerve = _o352.swerve;
                            V facing = _o352.facing;
                            const LANES(court_neared_body_out) _o353 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o353.nearest;
                            wedge = _o353.wedge;
                            const LANES(court_bridge_closing_out) _o354 =
                                LANES(court_bridge_closing)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
                            gap = _o354.gap;
                            nearing = _o354.nearing;
                            swerve = _o354.swerve;
                            facing = _o354.facing;
                            const LANES(court_neared_body_out) _o355 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o355.nearest;
                            wedge = _o355.wedge;
                            const LANES(court_end_beside_out) _o356 =
                                LANES(court_end_beside)(p_end_depth, vz, z);
                            gap = _o356.gap;
                            const LANES(court_neared_out) _o357 =
                                LANES(court_neared)(gap, nearest);
                            nearest = _o357.nearest;
                            const LANES(court_ring_parting_out) _o358 =
                                LANES(court_ring_parting)(p_gravity, p_ring_radius, vx, vy, vz, x, y, z);
                            V lift = _o358.lift;
                            const LANES(court_ring_impact_settling_out) _o359 =
                                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_ring_friction, p_ring_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz);
                            M settles = _o359.settles;
                            M lodges = _o359.lodges;
                            M slides = _o359.slides;
                            M parts = _o359.parts;
                            M unsure = _o359.unsure;
                            const LANES(court_settled_out) _o360 =
                                LANES(court_settled)(K(0.0), lodges, nearly, outcome, parts, settles, slides, K(0.0), unsure);
                            mode = lanes_select(_m348, _o360.mode, mode);
                            held = lanes_select(_m348, _o360.held, held);
                            outcome = lanes_select(_m348, _o360.outcome, outcome);
                            slip_left = lanes_select(_m348, _o360.slip_left, slip_left);
                        }
                        const LANES(court_here_out) _o361 =
                            LANES(court_here)(K(1.0), which);
                        here = _o361.here;
                        const M _m362 = lanes_both(_m345, here);
                        if (lanes_any(_m362)) {
                            const LANES(court_backboard_turning_out) _o363 =
                                LANES(court_backboard_turning)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, rolled_x, rolled_y, rolled_z, x, y, z);
                            V turning_x = _o363.turning_x;
                            V turning_y = _o363.turning_y;
                            V turning_z = _o363.turning_z;
                            const LANES(court_pressed_on_out) _o364 =
                                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
                            V press = _o364.press;
                            V weight = _o364.weight;
                            V drag = _o364.drag;
                            V thrust_x = _o364.thrust_x;
                            V thrust_y = _o364.thrust_y;
                            V thrust_z = _o364.thrust_z;
                            const LANES(court_alone_out) _o365 =
                                LANES(court_alone)();
                            V nearest = _o365.nearest;
                            V wedge = _o365.wedge;
                            const LANES(court_ring_closing_out) _o366 =
                                LANES(court_ring_closing)(p_ball_radius, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
                            V gap = _o366.gap;
                            V nearing = _o366.nearing;
                            V swerve = _o366.swerve;
                            V facing = _o366.facing;
                            const LANES(court_neared_body_out) _o367 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o367.nearest;
                            wedge = _o367.wedge;
                            const LANES(court_bridge_closing_out) _o368 =
                                LANES(court_bridge_closing)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
                            gap = _o368.gap;
                            nearing = _o368.nearing;
                            swerve = _o368.swerve;
                            facing = _o368.facing;
                            const LANES(court_neared_body_out) _o369 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o369.nearest;
                            wedge = _o369.wedge;
                            const LANES(court_end_beside_out) _o370 =
                                LANES(court_end_beside)(p_end_depth, vz, z);
                            gap = _o370.gap;
                            const LANES(court_neared_out) _o371 =
                                LANES(court_neared)(gap, nearest);
                            nearest = _o371.nearest;
                            const LANES(court_backboard_parting_out) _o372 =
                                LANES(court_backboard_parting)(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, vx, vy, vz, x, y, z);
                            V lift = _o372.lift;
                            const LANES(court_ring_impact_settling_out) _o373 =
                                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_backboard_friction, p_backboard_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz);
                            M settles = _o373.settles;
                            M lodges = _o373.lodges;
                            M slides = _o373.slides;
                            M parts = _o373.parts;
                            M unsure = _o373.unsure;
                            const LANES(court_settled_out) _o374 =
                                LANES(court_settled)(K(1.0), lodges, nearly, outcome, parts, settles, slides, K(0.0), unsure);
                            mode = lanes_select(_m362, _o374.mode, mode);
                            held = lanes_select(_m362, _o374.held, held);
                            outcome = lanes_select(_m362, _o374.outcome, outcome);
                            slip_left = lanes_select(_m362, _o374.slip_left, slip_left);
                        }
                        const LANES(court_here_out) _o375 =
                            LANES(court_here)(K(2.0), which);
                        here = _o375.here;
                        const M _m376 = lanes_both(_m345, here);
                        if (lanes_any(_m376)) {
                            const LANES(court_bridge_turning_out) _o377 =
                                LANES(court_bridge_turning)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, rolled_x, rolled_y, rolled_z, p_wire_radius, x, y, z);
                            V turning_x = _o377.turning_x;
                            V turning_y = _o377.turning_y;
                            V turning_z = _o377.turning_z;
                            const LANES(court_pressed_on_out) _o378 =
                                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
                            V press = _o378.press;
                            V weight = _o378.weight;
                            V drag = _o378.drag;
                            V thrust_x = _o378.thrust_x;
                            V thrust_y = _o378.thrust_y;
                            V thrust_z = _o378.thrust_z;
                            const LANES(court_alone_out) _o379 =
                                LANES(court_alone)();
                            V nearest = _o379.nearest;
                            V wedge = _o379.wedge;
                            const LANES(court_ring_closing_out) _o380 =
                                LANES(court_ring_closing)(p_ball_radius, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
                            V gap = _o380.gap;
                            V nearing = _o380.nearing;
                            V swerve = _o380.swerve;
                            V facing = _o380.facing;
                            const LANES(court_neared_body_out) _o381 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o381.nearest;
                            wedge = _o381.wedge;
                            const LANES(court_backboard_closing_out) _o382 =
                                LANES(court_backboard_closing)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z);
                            gap = _o382.gap;
                            nearing = _o382.nearing;
                            swerve = _o382.swerve;
                            facing = _o382.facing;
                            const LANES(court_neared_body_out) _o383 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o383.nearest;
                            wedge = _o383.wedge;
                            const LANES(court_end_beside_out) _o384 =
                                LANES(court_end_beside)(p_end_depth, vz, z);
                            gap = _o384.gap;
                            const LANES(court_neared_out) _o385 =
                                LANES(court_neared)(gap, nearest);
                            nearest = _o385.nearest;
                            const LANES(court_bridge_parting_out) _o386 =
                                LANES(court_bridge_parting)(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                            V lift = _o386.lift;
                            const LANES(court_ring_impact_settling_out) _o387 =
                                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_bridge_friction, p_bridge_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz);
                            M settles = _o387.settles;
                            M lodges = _o387.lodges;
                            M slides = _o387.slides;
                            M parts = _o387.parts;
                            M unsure = _o387.unsure;
                            const LANES(court_settled_out) _o388 =
                                LANES(court_settled)(K(2.0), lodges, nearly, outcome, parts, settles, slides, K(0.0), unsure);
                            mode = lanes_select(_m376, _o388.mode, mode);
                            held = lanes_select(_m376, _o388.held, held);
                            outcome = lanes_select(_m376, _o388.outcome, outcome);
                            slip_left = lanes_select(_m376, _o388.slip_left, slip_left);
                        }
                    }
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
            lanes_store(lists->slip_left + i, slip_left);
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
    LANES(court_column) open_t;
    LANES(court_column) open_tilt;
    LANES(court_column) open_searching_row;
    LANES(court_column) open_searching_arrival;
    LANES(court_column) open_searching_ceiling;
    LANES(court_column) open_searching_certain;
    LANES(court_column) open_searching_doubt;
    LANES(court_column) open_searching_end;
    LANES(court_column) open_searching_extent;
    LANES(court_column) open_searching_flat;
    LANES(court_column) open_searching_high0;
    LANES(court_column) open_searching_high1;
    LANES(court_column) open_searching_high2;
    LANES(court_column) open_searching_last;
    LANES(court_column) open_searching_latest;
    LANES(court_column) open_searching_low0;
    LANES(court_column) open_searching_low1;
    LANES(court_column) open_searching_low2;
    LANES(court_column) open_searching_p_ball_radius;
    LANES(court_column) open_searching_p_gravity;
    LANES(court_column) open_searching_p_ring_radius;
    LANES(court_column) open_searching_p_wire_radius;
    LANES(court_column) open_searching_position_error;
    LANES(court_column) open_searching_rate_slack;
    LANES(court_column) open_searching_rho_start;
    LANES(court_column) open_searching_searching;
    LANES(court_column) open_searching_share;
    LANES(court_column) open_searching_speed;
    LANES(court_column) open_searching_steady;
    LANES(court_column) open_searching_swing;
    LANES(court_column) open_searching_t;
    LANES(court_column) open_searching_tilt;
    LANES(court_column) open_searching_velocity_error;
    LANES(court_column) open_searching_vx;
    LANES(court_column) open_searching_vy;
    LANES(court_column) open_searching_vz;
    LANES(court_column) open_searching_x;
    LANES(court_column) open_searching_y;
    LANES(court_column) open_searching_z;
    LANES(court_column) open_p_board_bottom;
    LANES(court_column) open_p_board_distance;
    LANES(court_column) open_p_board_half_width;
    LANES(court_column) open_p_board_thickness;
    LANES(court_column) open_p_board_top;
    LANES(court_column) open_searching_p_board_bottom;
    LANES(court_column) open_searching_p_board_distance;
    LANES(court_column) open_searching_p_board_half_width;
    LANES(court_column) open_searching_p_board_thickness;
    LANES(court_column) open_searching_p_board_top;
    LANES(court_column) open_p_bridge_depth;
    LANES(court_column) open_p_bridge_half_width;
    LANES(court_column) open_searching_p_bridge_depth;
    LANES(court_column) open_searching_p_bridge_half_width;
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
        const LANES(court_resumed_out) _o128 =
            LANES(court_resumed)(clock, mode, position_error, velocity_error);
        V which = _o128.which;
        V late = _o128.late;
        V began = _o128.began;
        V doubt = _o128.doubt;
        M begins = _o128.begins;
        M rolling = _o128.rolling;
        M leaves = _o128.leaves;
        V nx = _o128.nx;
        V ny = _o128.ny;
        V nz = _o128.nz;
        V gap = _o128.gap;
        V bent_x = _o128.bent_x;
        V bent_y = _o128.bent_y;
        V bent_z = _o128.bent_z;
        V lift = _o128.lift;
        V surge = _o128.surge;
        V snap = _o128.snap;
        V per_reach = _o128.per_reach;
        const M _m129 = lanes_both(rows, begins);
        if (lanes_any(_m129)) {
            const LANES(court_holding_out) _o130 =
                LANES(court_holding)(held, K(0.0));
            M here = _o130.here;
            const M _m131 = lanes_both(_m129, here);
            {
                const LANES(court_ring_normal_out) _o132 =
                    LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                nx = lanes_select(_m131, _o132.nx, nx);
                ny = lanes_select(_m131, _o132.ny, ny);
                nz = lanes_select(_m131, _o132.nz, nz);
            }
            const LANES(court_holding_out) _o133 =
                LANES(court_holding)(held, K(1.0));
            here = _o133.here;
            const M _m134 = lanes_both(_m129, here);
            {
                const LANES(court_backboard_normal_out) _o135 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m134, _o135.nx, nx);
                ny = lanes_select(_m134, _o135.ny, ny);
                nz = lanes_select(_m134, _o135.nz, nz);
            }
            const LANES(court_holding_out) _o136 =
                LANES(court_holding)(held, K(2.0));
            here = _o136.here;
            const M _m137 = lanes_both(_m129, here);
            {
                const LANES(court_bridge_normal_out) _o138 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m137, _o138.nx, nx);
                ny = lanes_select(_m137, _o138.ny, ny);
                nz = lanes_select(_m137, _o138.nz, nz);
            }
            const LANES(court_roll_turn_rate_out) _o139 =
                LANES(court_roll_turn_rate)(p_ball_radius, nx, ny, nz, wx, wy, wz);
            V turn_rate = _o139.turn_rate;
            const LANES(court_gripped_out) _o140 =
                LANES(court_gripped)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
            V rolled_x = _o140.rolled_x;
            V rolled_y = _o140.rolled_y;
            V rolled_z = _o140.rolled_z;
            const LANES(court_holding_out) _o141 =
                LANES(court_holding)(held, K(0.0));
            here = _o141.here;
            const M _m142 = lanes_both(_m129, here);
            {
                const LANES(court_ring_off_out) _o143 =
                    LANES(court_ring_off)(p_ball_radius, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m142, _o143.gap, gap);
            }
            const LANES(court_holding_out) _o144 =
                LANES(court_holding)(held, K(1.0));
            here = _o144.here;
            const M _m145 = lanes_both(_m129, here);
            {
                const LANES(court_backboard_off_out) _o146 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z);
                gap = lanes_select(_m145, _o146.gap, gap);
            }
            const LANES(court_holding_out) _o147 =
                LANES(court_holding)(held, K(2.0));
            here = _o147.here;
            const M _m148 = lanes_both(_m129, here);
            {
                const LANES(court_bridge_off_out) _o149 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z);
                gap = lanes_select(_m148, _o149.gap, gap);
            }
            const LANES(court_roll_placed_out) _o150 =
                LANES(court_roll_placed)(p_ball_radius, gap, nx, ny, nz, turn_rate, rolled_x, rolled_y, rolled_z, x, y, z);
            x = lanes_select(_m129, _o150.x, x);
            y = lanes_select(_m129, _o150.y, y);
            z = lanes_select(_m129, _o150.z, z);
            vx = lanes_select(_m129, _o150.vx, vx);
            vy = lanes_select(_m129, _o150.vy, vy);
            vz = lanes_select(_m129, _o150.vz, vz);
            wx = lanes_select(_m129, _o150.wx, wx);
            wy = lanes_select(_m129, _o150.wy, wy);
            wz = lanes_select(_m129, _o150.wz, wz);
            const LANES(court_begun_errors_out) _o151 =
                LANES(court_begun_errors)(p_ball_radius, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, vx, vy, vz);
            dx = lanes_select(_m129, _o151.dx, dx);
            dy = lanes_select(_m129, _o151.dy, dy);
            dz = lanes_select(_m129, _o151.dz, dz);
            dvx = lanes_select(_m129, _o151.dvx, dvx);
            dvy = lanes_select(_m129, _o151.dvy, dvy);
            dvz = lanes_select(_m129, _o151.dvz, dvz);
            dwx = lanes_select(_m129, _o151.dwx, dwx);
            dwy = lanes_select(_m129, _o151.dwy, dwy);
            dwz = lanes_select(_m129, _o151.dwz, dwz);
            const LANES(court_untaut_out) _o152 =
                LANES(court_untaut)();
            taut = lanes_select(_m129, _o152.taut, taut);
            const LANES(court_beginning_contact_out) _o153 =
                LANES(court_beginning_contact)();
            which = lanes_select(_m129, _o153.which, which);
            circled = lanes_select(_m129, _o153.circled, circled);
        }
        const LANES(court_circles_out) _o154 =
            LANES(court_circles)(held, K(0.0), rolling);
        M circling = _o154.circling;
        rolling = _o154.rolling;
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
            const LANES(court_error_bounds_out) _o155 =
                LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            V position_error = _o155.position_error;
            V velocity_error = _o155.velocity_error;
            const LANES(court_holding_out) _o156 =
                LANES(court_holding)(held, K(1.0));
            M here = _o156.here;
            const M _m157 = lanes_both(active, here);
            if (lanes_any(_m157)) {
                const LANES(court_backboard_normal_out) _o158 =
                    LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = lanes_select(_m157, _o158.nx, nx);
                ny = lanes_select(_m157, _o158.ny, ny);
                nz = lanes_select(_m157, _o158.nz, nz);
                const LANES(court_backboard_tube_out) _o159 =
                    LANES(court_backboard_tube)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                bent_x = lanes_select(_m157, _o159.bent_x, bent_x);
                bent_y = lanes_select(_m157, _o159.bent_y, bent_y);
                bent_z = lanes_select(_m157, _o159.bent_z, bent_z);
                per_reach = lanes_select(_m157, _o159.per_reach, per_reach);
            }
            const LANES(court_holding_out) _o160 =
                LANES(court_holding)(held, K(2.0));
            here = _o160.here;
            const M _m161 = lanes_both(active, here);
            if (lanes_any(_m161)) {
                const LANES(court_bridge_normal_out) _o162 =
                    LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = lanes_select(_m161, _o162.nx, nx);
                ny = lanes_select(_m161, _o162.ny, ny);
                nz = lanes_select(_m161, _o162.nz, nz);
                const LANES(court_bridge_tube_out) _o163 =
                    LANES(court_bridge_tube)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                bent_x = lanes_select(_m161, _o163.bent_x, bent_x);
                bent_y = lanes_select(_m161, _o163.bent_y, bent_y);
                bent_z = lanes_select(_m161, _o163.bent_z, bent_z);
                per_reach = lanes_select(_m161, _o163.per_reach, per_reach);
            }
            const LANES(court_roll_start_out) _o164 =
                LANES(court_roll_start)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
            V vx_0 = _o164.vx_0;
            V vy_0 = _o164.vy_0;
            V vz_0 = _o164.vz_0;
            V nx_0 = _o164.nx_0;
            V ny_0 = _o164.ny_0;
            V nz_0 = _o164.nz_0;
            V turn_rate_0 = _o164.turn_rate_0;
            const LANES(court_roll_0_out) _o165 =
                LANES(court_roll_0)(bent_x, bent_y, bent_z, p_gravity, nx_0, ny_0, nz_0, per_reach, turn_rate_0, vx_0, vy_0, vz_0);
            V lift_0 = _o165.lift_0;
            V tx_0 = _o165.tx_0;
            V ty_0 = _o165.ty_0;
            V tz_0 = _o165.tz_0;
            V vx_1 = _o165.vx_1;
            V vy_1 = _o165.vy_1;
            V vz_1 = _o165.vz_1;
            V nx_1 = _o165.nx_1;
            V ny_1 = _o165.ny_1;
            V nz_1 = _o165.nz_1;
            V turn_rate_1 = _o165.turn_rate_1;
            const LANES(court_roll_1_out) _o166 =
                LANES(court_roll_1)(bent_x, bent_y, bent_z, p_gravity, lift_0, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1);
            V lift_1 = _o166.lift_1;
            V tx_1 = _o166.tx_1;
            V ty_1 = _o166.ty_1;
            V tz_1 = _o166.tz_1;
            V vx_2 = _o166.vx_2;
            V vy_2 = _o166.vy_2;
            V vz_2 = _o166.vz_2;
            V nx_2 = _o166.nx_2;
            V ny_2 = _o166.ny_2;
            V nz_2 = _o166.nz_2;
            V turn_rate_2 = _o166.turn_rate_2;
            const LANES(court_roll_2_out) _o167 =
                LANES(court_roll_2)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2);
            V lift_2 = _o167.lift_2;
            V tx_2 = _o167.tx_2;
            V ty_2 = _o167.ty_2;
            V tz_2 = _o167.tz_2;
            V vx_3 = _o167.vx_3;
            V vy_3 = _o167.vy_3;
            V vz_3 = _o167.vz_3;
            V nx_3 = _o167.nx_3;
            V ny_3 = _o167.ny_3;
            V nz_3 = _o167.nz_3;
            V turn_rate_3 = _o167.turn_rate_3;
            const LANES(court_roll_3_out) _o168 =
                LANES(court_roll_3)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3);
            V lift_3 = _o168.lift_3;
            V tx_3 = _o168.tx_3;
            V ty_3 = _o168.ty_3;
            V tz_3 = _o168.tz_3;
            V vx_4 = _o168.vx_4;
            V vy_4 = _o168.vy_4;
            V vz_4 = _o168.vz_4;
            V nx_4 = _o168.nx_4;
            V ny_4 = _o168.ny_4;
            V nz_4 = _o168.nz_4;
            V turn_rate_4 = _o168.turn_rate_4;
            const LANES(court_roll_4_out) _o169 =
                LANES(court_roll_4)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4);
            V lift_4 = _o169.lift_4;
            V tx_4 = _o169.tx_4;
            V ty_4 = _o169.ty_4;
            V tz_4 = _o169.tz_4;
            V vx_5 = _o169.vx_5;
            V vy_5 = _o169.vy_5;
            V vz_5 = _o169.vz_5;
            V nx_5 = _o169.nx_5;
            V ny_5 = _o169.ny_5;
            V nz_5 = _o169.nz_5;
            V turn_rate_5 = _o169.turn_rate_5;
            const LANES(court_roll_5_out) _o170 =
                LANES(court_roll_5)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5);
            V lift_5 = _o170.lift_5;
            V tx_5 = _o170.tx_5;
            V ty_5 = _o170.ty_5;
            V tz_5 = _o170.tz_5;
            V vx_6 = _o170.vx_6;
            V vy_6 = _o170.vy_6;
            V vz_6 = _o170.vz_6;
            V nx_6 = _o170.nx_6;
            V ny_6 = _o170.ny_6;
            V nz_6 = _o170.nz_6;
            V turn_rate_6 = _o170.turn_rate_6;
            const LANES(court_roll_6_out) _o171 =
                LANES(court_roll_6)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6);
            V lift_6 = _o171.lift_6;
            V tx_6 = _o171.tx_6;
            V ty_6 = _o171.ty_6;
            V tz_6 = _o171.tz_6;
            V vx_7 = _o171.vx_7;
            V vy_7 = _o171.vy_7;
            V vz_7 = _o171.vz_7;
            V nx_7 = _o171.nx_7;
            V ny_7 = _o171.ny_7;
            V nz_7 = _o171.nz_7;
            V turn_rate_7 = _o171.turn_rate_7;
            const LANES(court_roll_7_out) _o172 =
                LANES(court_roll_7)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7);
            V lift_7 = _o172.lift_7;
            V vx_8 = _o172.vx_8;
            V vy_8 = _o172.vy_8;
            V vz_8 = _o172.vz_8;
            V nx_8 = _o172.nx_8;
            V ny_8 = _o172.ny_8;
            V nz_8 = _o172.nz_8;
            V turn_rate_8 = _o172.turn_rate_8;
            const LANES(court_roll_pace_out) _o173 =
                LANES(court_roll_pace)(p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, lift_7, nx_8, ny_8, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, nz_8, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8);
            V stride = _o173.stride;
            V strongest = _o173.strongest;
            V fastest = _o173.fastest;
            V force = _o173.force;
            V force_rate = _o173.force_rate;
            V force_bend = _o173.force_bend;
            V brace = _o173.brace;
            const LANES(court_pulled_out) _o174 =
                LANES(court_pulled)(p_gravity, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, turn_rate_0, turn_rate_1, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1);
            V drag = _o174.drag;
            V drag_rate = _o174.drag_rate;
            V strain = _o174.strain;
            V strain_rate = _o174.strain_rate;
            const LANES(court_holding_out) _o175 =
                LANES(court_holding)(held, K(1.0));
            here = _o175.here;
            const M _m176 = lanes_both(active, here);
            {
                const LANES(court_ring_impact_strained_out) _o177 =
                    LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, p_backboard_friction);
                strain = lanes_select(_m176, _o177.strain, strain);
                strain_rate = lanes_select(_m176, _o177.strain_rate, strain_rate);
            }
            const LANES(court_holding_out) _o178 =
                LANES(court_holding)(held, K(2.0));
            here = _o178.here;
            const M _m179 = lanes_both(active, here);
            {
                const LANES(court_ring_impact_strained_out) _o180 =
                    LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, p_bridge_friction);
                strain = lanes_select(_m179, _o180.strain, strain);
                strain_rate = lanes_select(_m179, _o180.strain_rate, strain_rate);
            }
            const LANES(court_losing_out) _o181 =
                LANES(court_losing)(grip_lost, strain);
            M loses = _o181.loses;
            const M _m182 = lanes_both(active, loses);
            if (lanes_any(_m182)) {
                const LANES(court_lost_grip_out) _o183 =
                    LANES(court_lost_grip)(clock, strain, strain_rate, taut, taut_clock, taut_rate);
                grip_lost = lanes_select(_m182, _o183.grip_lost, grip_lost);
            }
            const LANES(court_tightened_out) _o184 =
                LANES(court_tightened)(clock, strain, strain_rate);
            taut = _o184.taut;
            taut_rate = _o184.taut_rate;
            taut_clock = _o184.taut_clock;
            const LANES(court_leaving_force_out) _o185 =
                LANES(court_leaving_force)(p_ball_radius, brace, doubt, fastest, force, force_bend, force_rate, p_gravity, per_reach, position_error, stride, velocity_error, vx, vx_1, vy, vy_1, vz, vz_1, which);
            stride = _o185.stride;
            which = _o185.which;
            M rests = _o185.rests;
            doubt = _o185.doubt;
            const LANES(court_beside_out) _o186 =
                LANES(court_beside)(held, K(0.0));
            M beside = _o186.beside;
            const M _m187 = lanes_both(active, beside);
            if (lanes_any(_m187)) {
                const LANES(court_ring_beside_out) _o188 =
                    LANES(court_ring_beside)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                V gap = _o188.gap;
                V nearing = _o188.nearing;
                V dent = _o188.dent;
                const LANES(court_beside_body_out) _o189 =
                    LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(0.0), late, nearing, position_error, stride, strongest, which, x, y, z);
                stride = lanes_select(_m187, _o189.stride, stride);
                which = lanes_select(_m187, _o189.which, which);
                doubt = lanes_select(_m187, _o189.doubt, doubt);
                late = lanes_select(_m187, _o189.late, late);
            }
            const LANES(court_beside_out) _o190 =
                LANES(court_beside)(held, K(1.0));
            beside = _o190.beside;
            const M _m191 = lanes_both(active, beside);
            if (lanes_any(_m191)) {
                const LANES(court_backboard_beside_out) _o192 =
                    LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                V gap = _o192.gap;
                V nearing = _o192.nearing;
                V dent = _o192.dent;
                const LANES(court_beside_body_out) _o193 =
                    LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(1.0), late, nearing, position_error, stride, strongest, which, x, y, z);
                stride = lanes_select(_m191, _o193.stride, stride);
                which = lanes_select(_m191, _o193.which, which);
                doubt = lanes_select(_m191, _o193.doubt, doubt);
                late = lanes_select(_m191, _o193.late, late);
            }
            const LANES(court_beside_out) _o194 =
                LANES(court_beside)(held, K(2.0));
            beside = _o194.beside;
            const M _m195 = lanes_both(active, beside);
            if (lanes_any(_m195)) {
                const LANES(court_bridge_beside_out) _o196 =
                    LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                V gap = _o196.gap;
                V nearing = _o196.nearing;
                V dent = _o196.dent;
                const LANES(court_beside_body_out) _o197 =
                    LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(2.0), late, nearing, position_error, stride, strongest, which, x, y, z);
                stride = lanes_select(_m195, _o197.stride, stride);
                which = lanes_select(_m195, _o197.which, which);
                doubt = lanes_select(_m195, _o197.doubt, doubt);
                late = lanes_select(_m195, _o197.late, late);
            }
            const LANES(court_end_beside_out) _o198 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            V gap = _o198.gap;
            V nearing = _o198.nearing;
            V dent = _o198.dent;
            const LANES(court_beside_gate_out) _o199 =
                LANES(court_beside_gate)(p_ball_radius, dent, doubt, fastest, gap, K(3.0), late, nearing, position_error, stride, strongest, which, x, y, z);
            stride = _o199.stride;
            which = _o199.which;
            doubt = _o199.doubt;
            late = _o199.late;
            const LANES(court_holding_out) _o200 =
                LANES(court_holding)(held, K(1.0));
            here = _o200.here;
            const M _m201 = lanes_both(active, here);
            if (lanes_any(_m201)) {
                const LANES(court_backboard_seam0_out) _o202 =
                    LANES(court_backboard_seam0)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                gap = lanes_select(_m201, _o202.gap, gap);
                V nearing = _o202.nearing;
                V near = _o202.near;
                const LANES(court_beside_seam_out) _o203 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m201, _o203.stride, stride);
                const LANES(court_backboard_seam1_out) _o204 =
                    LANES(court_backboard_seam1)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                gap = lanes_select(_m201, _o204.gap, gap);
                nearing = _o204.nearing;
                near = _o204.near;
                const LANES(court_beside_seam_out) _o205 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m201, _o205.stride, stride);
                const LANES(court_backboard_seam2_out) _o206 =
                    LANES(court_backboard_seam2)(p_ball_radius, p_board_half_width, vy, y);
                gap = lanes_select(_m201, _o206.gap, gap);
                nearing = _o206.nearing;
                near = _o206.near;
                const LANES(court_beside_seam_out) _o207 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m201, _o207.stride, stride);
                const LANES(court_backboard_seam3_out) _o208 =
                    LANES(court_backboard_seam3)(p_ball_radius, p_board_half_width, vy, y);
                gap = lanes_select(_m201, _o208.gap, gap);
                nearing = _o208.nearing;
                near = _o208.near;
                const LANES(court_beside_seam_out) _o209 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m201, _o209.stride, stride);
                const LANES(court_backboard_seam4_out) _o210 =
                    LANES(court_backboard_seam4)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                gap = lanes_select(_m201, _o210.gap, gap);
                nearing = _o210.nearing;
                near = _o210.near;
                const LANES(court_beside_seam_out) _o211 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m201, _o211.stride, stride);
                const LANES(court_backboard_seam5_out) _o212 =
                    LANES(court_backboard_seam5)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                gap = lanes_select(_m201, _o212.gap, gap);
                nearing = _o212.nearing;
                near = _o212.near;
                const LANES(court_beside_seam_out) _o213 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m201, _o213.stride, stride);
            }
            const LANES(court_holding_out) _o214 =
                LANES(court_holding)(held, K(2.0));
            here = _o214.here;
            const M _m215 = lanes_both(active, here);
            if (lanes_any(_m215)) {
                const LANES(court_bridge_seam0_out) _o216 =
                    LANES(court_bridge_seam0)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                gap = lanes_select(_m215, _o216.gap, gap);
                V nearing = _o216.nearing;
                V near = _o216.near;
                const LANES(court_beside_seam_out) _o217 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m215, _o217.stride, stride);
                const LANES(court_bridge_seam1_out) _o218 =
                    LANES(court_bridge_seam1)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                gap = lanes_select(_m215, _o218.gap, gap);
                nearing = _o218.nearing;
                near = _o218.near;
                const LANES(court_beside_seam_out) _o219 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m215, _o219.stride, stride);
                const LANES(court_bridge_seam2_out) _o220 =
                    LANES(court_bridge_seam2)(p_ball_radius, p_bridge_half_width, vy, y);
                gap = lanes_select(_m215, _o220.gap, gap);
                nearing = _o220.nearing;
                near = _o220.near;
                const LANES(court_beside_seam_out) _o221 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m215, _o221.stride, stride);
                const LANES(court_bridge_seam3_out) _o222 =
                    LANES(court_bridge_seam3)(p_ball_radius, p_bridge_half_width, vy, y);
                gap = lanes_select(_m215, _o222.gap, gap);
                nearing = _o222.nearing;
                near = _o222.near;
                const LANES(court_beside_seam_out) _o223 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m215, _o223.stride, stride);
                const LANES(court_bridge_seam4_out) _o224 =
                    LANES(court_bridge_seam4)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                gap = lanes_select(_m215, _o224.gap, gap);
                nearing = _o224.nearing;
                near = _o224.near;
                const LANES(court_beside_seam_out) _o225 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m215, _o225.stride, stride);
                const LANES(court_bridge_seam5_out) _o226 =
                    LANES(court_bridge_seam5)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                gap = lanes_select(_m215, _o226.gap, gap);
                nearing = _o226.nearing;
                near = _o226.near;
                const LANES(court_beside_seam_out) _o227 =
                    LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                stride = lanes_select(_m215, _o227.stride, stride);
            }
            const LANES(court_beside_time_out) _o228 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o228.stride;
            which = _o228.which;
            const LANES(court_apart_out) _o229 =
                LANES(court_apart)(p_ball_radius, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz);
            V apart = _o229.apart;
            const LANES(court_neighbour_out) _o230 =
                LANES(court_neighbour)(apart, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, vx, vy, vz, wx, wy, wz, x, y, z);
            V far_x = _o230.far_x;
            V far_y = _o230.far_y;
            V far_z = _o230.far_z;
            V far_vx = _o230.far_vx;
            V far_vy = _o230.far_vy;
            V far_vz = _o230.far_vz;
            V far_wx = _o230.far_wx;
            V far_wy = _o230.far_wy;
            V far_wz = _o230.far_wz;
            V far_nx = _o230.far_nx;
            V far_ny = _o230.far_ny;
            V far_nz = _o230.far_nz;
            V far_gap = _o230.far_gap;
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
            const LANES(court_holding_out) _o243 =
                LANES(court_holding)(held, K(1.0));
            here = _o243.here;
            const M _m244 = lanes_both(active, here);
            {
                const LANES(court_backboard_normal_out) _o245 =
                    LANES(court_backboard_normal)(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                far_nx = lanes_select(_m244, _o245.nx, far_nx);
                far_ny = lanes_select(_m244, _o245.ny, far_ny);
                far_nz = lanes_select(_m244, _o245.nz, far_nz);
            }
            const LANES(court_holding_out) _o246 =
                LANES(court_holding)(held, K(2.0));
            here = _o246.here;
            const M _m247 = lanes_both(active, here);
            {
                const LANES(court_bridge_normal_out) _o248 =
                    LANES(court_bridge_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                far_nx = lanes_select(_m247, _o248.nx, far_nx);
                far_ny = lanes_select(_m247, _o248.ny, far_ny);
                far_nz = lanes_select(_m247, _o248.nz, far_nz);
            }
            const LANES(court_roll_turn_rate_out) _o249 =
                LANES(court_roll_turn_rate)(p_ball_radius, far_nx, far_ny, far_nz, far_wx, far_wy, far_wz);
            turn_rate = _o249.turn_rate;
            const LANES(court_holding_out) _o250 =
                LANES(court_holding)(held, K(1.0));
            here = _o250.here;
            const M _m251 = lanes_both(active, here);
            if (lanes_any(_m251)) {
                const LANES(court_backboard_normal_out) _o252 =
                    LANES(court_backboard_normal)(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                far_nx = lanes_select(_m251, _o252.nx, far_nx);
                far_ny = lanes_select(_m251, _o252.ny, far_ny);
                far_nz = lanes_select(_m251, _o252.nz, far_nz);
                const LANES(court_backboard_off_out) _o253 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, far_x, far_y, far_z);
                far_gap = lanes_select(_m251, _o253.gap, far_gap);
            }
            const LANES(court_holding_out) _o254 =
                LANES(court_holding)(held, K(2.0));
            here = _o254.here;
            const M _m255 = lanes_both(active, here);
            if (lanes_any(_m255)) {
                const LANES(court_bridge_normal_out) _o256 =
                    LANES(court_bridge_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                far_nx = lanes_select(_m255, _o256.nx, far_nx);
                far_ny = lanes_select(_m255, _o256.ny, far_ny);
                far_nz = lanes_select(_m255, _o256.nz, far_nz);
                const LANES(court_bridge_off_out) _o257 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, far_x, far_y, far_z);
                far_gap = lanes_select(_m255, _o257.gap, far_gap);
            }
            const LANES(court_roll_placed_out) _o258 =
                LANES(court_roll_placed)(p_ball_radius, far_gap, far_nx, far_ny, far_nz, turn_rate, far_vx, far_vy, far_vz, far_x, far_y, far_z);
            far_x = _o258.x;
            far_y = _o258.y;
            far_z = _o258.z;
            far_vx = _o258.vx;
            far_vy = _o258.vy;
            far_vz = _o258.vz;
            far_wx = _o258.wx;
            far_wy = _o258.wy;
            far_wz = _o258.wz;
            const LANES(court_roll_start_out) _o259 =
                LANES(court_roll_start)(p_ball_radius, far_nx, far_ny, far_nz, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz);
            vx_0 = _o259.vx_0;
            vy_0 = _o259.vy_0;
            vz_0 = _o259.vz_0;
            nx_0 = _o259.nx_0;
            ny_0 = _o259.ny_0;
            nz_0 = _o259.nz_0;
            turn_rate_0 = _o259.turn_rate_0;
            const LANES(court_roll_0_out) _o260 =
                LANES(court_roll_0)(bent_x, bent_y, bent_z, p_gravity, nx_0, ny_0, nz_0, per_reach, turn_rate_0, vx_0, vy_0, vz_0);
            lift_0 = _o260.lift_0;
            tx_0 = _o260.tx_0;
            ty_0 = _o260.ty_0;
            tz_0 = _o260.tz_0;
            vx_1 = _o260.vx_1;
            vy_1 = _o260.vy_1;
            vz_1 = _o260.vz_1;
            nx_1 = _o260.nx_1;
            ny_1 = _o260.ny_1;
            nz_1 = _o260.nz_1;
            turn_rate_1 = _o260.turn_rate_1;
            const LANES(court_roll_1_out) _o261 =
                LANES(court_roll_1)(bent_x, bent_y, bent_z, p_gravity, lift_0, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1);
            lift_1 = _o261.lift_1;
            tx_1 = _o261.tx_1;
            ty_1 = _o261.ty_1;
            tz_1 = _o261.tz_1;
            vx_2 = _o261.vx_2;
            vy_2 = _o261.vy_2;
            vz_2 = _o261.vz_2;
            nx_2 = _o261.nx_2;
            ny_2 = _o261.ny_2;
            nz_2 = _o261.nz_2;
            turn_rate_2 = _o261.turn_rate_2;
            const LANES(court_roll_2_out) _o262 =
                LANES(court_roll_2)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2);
            lift_2 = _o262.lift_2;
            tx_2 = _o262.tx_2;
            ty_2 = _o262.ty_2;
            tz_2 = _o262.tz_2;
            vx_3 = _o262.vx_3;
            vy_3 = _o262.vy_3;
            vz_3 = _o262.vz_3;
            nx_3 = _o262.nx_3;
            ny_3 = _o262.ny_3;
            nz_3 = _o262.nz_3;
            turn_rate_3 = _o262.turn_rate_3;
            const LANES(court_roll_3_out) _o263 =
                LANES(court_roll_3)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3);
            lift_3 = _o263.lift_3;
            tx_3 = _o263.tx_3;
            ty_3 = _o263.ty_3;
            tz_3 = _o263.tz_3;
            vx_4 = _o263.vx_4;
            vy_4 = _o263.vy_4;
            vz_4 = _o263.vz_4;
            nx_4 = _o263.nx_4;
            ny_4 = _o263.ny_4;
            nz_4 = _o263.nz_4;
            turn_rate_4 = _o263.turn_rate_4;
            const LANES(court_roll_4_out) _o264 =
                LANES(court_roll_4)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4);
            lift_4 = _o264.lift_4;
            tx_4 = _o264.tx_4;
            ty_4 = _o264.ty_4;
            tz_4 = _o264.tz_4;
            vx_5 = _o264.vx_5;
            vy_5 = _o264.vy_5;
            vz_5 = _o264.vz_5;
            nx_5 = _o264.nx_5;
            ny_5 = _o264.ny_5;
            nz_5 = _o264.nz_5;
            turn_rate_5 = _o264.turn_rate_5;
            const LANES(court_roll_5_out) _o265 =
                LANES(court_roll_5)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5);
            lift_5 = _o265.lift_5;
            tx_5 = _o265.tx_5;
            ty_5 = _o265.ty_5;
            tz_5 = _o265.tz_5;
            vx_6 = _o265.vx_6;
            vy_6 = _o265.vy_6;
            vz_6 = _o265.vz_6;
            nx_6 = _o265.nx_6;
            ny_6 = _o265.ny_6;
            nz_6 = _o265.nz_6;
            turn_rate_6 = _o265.turn_rate_6;
            const LANES(court_roll_6_out) _o266 =
                LANES(court_roll_6)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6);
            lift_6 = _o266.lift_6;
            tx_6 = _o266.tx_6;
            ty_6 = _o266.ty_6;
            tz_6 = _o266.tz_6;
            vx_7 = _o266.vx_7;
            vy_7 = _o266.vy_7;
            vz_7 = _o266.vz_7;
            nx_7 = _o266.nx_7;
            ny_7 = _o266.ny_7;
            nz_7 = _o266.nz_7;
            turn_rate_7 = _o266.turn_rate_7;
            const LANES(court_roll_7_out) _o267 =
                LANES(court_roll_7)(bent_x, bent_y, bent_z, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7);
            vx_8 = _o267.vx_8;
            vy_8 = _o267.vy_8;
            vz_8 = _o267.vz_8;
            turn_rate_8 = _o267.turn_rate_8;
            const LANES(court_roll_moved_out) _o268 =
                LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, far_x, far_y, far_z);
            far_x = _o268.x;
            far_vx = _o268.vx;
            far_y = _o268.y;
            far_vy = _o268.vy;
            far_z = _o268.z;
            far_vz = _o268.vz;
            turn_rate = _o268.turn_rate;
            const LANES(court_holding_out) _o269 =
                LANES(court_holding)(held, K(1.0));
            here = _o269.here;
            const M _m270 = lanes_both(active, here);
            if (lanes_any(_m270)) {
                const LANES(court_backboard_normal_out) _o271 =
                    LANES(court_backboard_normal)(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                far_nx = lanes_select(_m270, _o271.nx, far_nx);
                far_ny = lanes_select(_m270, _o271.ny, far_ny);
                far_nz = lanes_select(_m270, _o271.nz, far_nz);
                const LANES(court_backboard_off_out) _o272 =
                    LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, far_x, far_y, far_z);
                far_gap = lanes_select(_m270, _o272.gap, far_gap);
            }
            const LANES(court_holding_out) _o273 =
                LANES(court_holding)(held, K(2.0));
            here = _o273.here;
            const M _m274 = lanes_both(active, here);
            if (lanes_any(_m274)) {
                const LANES(court_bridge_normal_out) _o275 =
                    LANES(court_bridge_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                far_nx = lanes_select(_m274, _o275.nx, far_nx);
                far_ny = lanes_select(_m274, _o275.ny, far_ny);
                far_nz = lanes_select(_m274, _o275.nz, far_nz);
                const LANES(court_bridge_off_out) _o276 =
                    LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, far_x, far_y, far_z);
                far_gap = lanes_select(_m274, _o276.gap, far_gap);
            }
            const LANES(court_roll_placed_out) _o277 =
                LANES(court_roll_placed)(p_ball_radius, far_gap, far_nx, far_ny, far_nz, turn_rate, far_vx, far_vy, far_vz, far_x, far_y, far_z);
            far_x = _o277.x;
            far_y = _o277.y;
            far_z = _o277.z;
            far_vx = _o277.vx;
            far_vy = _o277.vy;
            far_vz = _o277.vz;
            far_wx = _o277.wx;
            far_wy = _o277.wy;
            far_wz = _o277.wz;
            const LANES(court_compared_out) _o278 =
                LANES(court_compared)(apart, p_ball_radius, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_x, far_y, far_z, vx, vy, vz, wx, wy, wz, x, y, z);
            dx = _o278.dx;
            dy = _o278.dy;
            dz = _o278.dz;
            dvx = _o278.dvx;
            dvy = _o278.dvy;
            dvz = _o278.dvz;
            dwx = _o278.dwx;
            dwy = _o278.dwy;
            dwz = _o278.dwz;
            const LANES(court_rolled_on_out) _o279 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o279.clock;
            rolling = _o279.rolling;
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
            const LANES(court_error_bounds_out) _o280 =
                LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            V position_error = _o280.position_error;
            V velocity_error = _o280.velocity_error;
            const LANES(court_ring_tube_out) _o281 =
                LANES(court_ring_tube)(p_ball_radius, p_wire_radius);
            V per_reach = _o281.per_reach;
            const LANES(court_ring_round_start_out) _o282 =
                LANES(court_ring_round_start)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, wx, wy, wz, x, y, z);
            V cosine_0 = _o282.cosine_0;
            V sine_0 = _o282.sine_0;
            V climb_0 = _o282.climb_0;
            V along_0 = _o282.along_0;
            V turn_rate_0 = _o282.turn_rate_0;
            V cos_0 = _o282.cos_0;
            V sin_0 = _o282.sin_0;
            V near_0 = _o282.near_0;
            const LANES(court_ring_round_0_out) _o283 =
                LANES(court_ring_round_0)(along_0, p_ball_radius, climb_0, cos_0, cosine_0, p_gravity, near_0, p_ring_radius, sin_0, sine_0, turn_rate_0, p_wire_radius);
            V omega_0 = _o283.omega_0;
            V around_0 = _o283.around_0;
            V tilted_0 = _o283.tilted_0;
            V pressed_0 = _o283.pressed_0;
            V force_0 = _o283.force_0;
            V cosine_1 = _o283.cosine_1;
            V sine_1 = _o283.sine_1;
            V climb_1 = _o283.climb_1;
            V along_1 = _o283.along_1;
            V turn_rate_1 = _o283.turn_rate_1;
            V cos_1 = _o283.cos_1;
            V sin_1 = _o283.sin_1;
            const LANES(court_ring_round_1_out) _o284 =
                LANES(court_ring_round_1)(along_0, along_1, around_0, p_ball_radius, climb_0, climb_1, cos_0, cos_1, cosine_0, cosine_1, p_gravity, near_0, omega_0, pressed_0, p_ring_radius, sin_0, sin_1, sine_0, sine_1, tilted_0, turn_rate_0, turn_rate_1, p_wire_radius);
            V near_1 = _o284.near_1;
            V omega_1 = _o284.omega_1;
            V around_1 = _o284.around_1;
            V tilted_1 = _o284.tilted_1;
            V pressed_1 = _o284.pressed_1;
            V force_1 = _o284.force_1;
            V cosine_2 = _o284.cosine_2;
            V sine_2 = _o284.sine_2;
            V climb_2 = _o284.climb_2;
            V along_2 = _o284.along_2;
            V turn_rate_2 = _o284.turn_rate_2;
            V cos_2 = _o284.cos_2;
            V sin_2 = _o284.sin_2;
            const LANES(court_ring_round_2_out) _o285 =
                LANES(court_ring_round_2)(along_0, along_1, along_2, around_0, around_1, p_ball_radius, climb_0, climb_1, climb_2, cos_0, cos_1, cos_2, cosine_0, cosine_1, cosine_2, p_gravity, near_0, near_1, omega_0, omega_1, pressed_0, pressed_1, p_ring_radius, sin_0, sin_1, sin_2, sine_0, sine_1, sine_2, tilted_0, tilted_1, turn_rate_0, turn_rate_1, turn_rate_2, p_wire_radius);
            V near_2 = _o285.near_2;
            V omega_2 = _o285.omega_2;
            V around_2 = _o285.around_2;
            V tilted_2 = _o285.tilted_2;
            V pressed_2 = _o285.pressed_2;
            V force_2 = _o285.force_2;
            V cosine_3 = _o285.cosine_3;
            V sine_3 = _o285.sine_3;
            V climb_3 = _o285.climb_3;
            V along_3 = _o285.along_3;
            V turn_rate_3 = _o285.turn_rate_3;
            V cos_3 = _o285.cos_3;
            V sin_3 = _o285.sin_3;
            const LANES(court_ring_round_3_out) _o286 =
                LANES(court_ring_round_3)(along_0, along_1, along_2, along_3, around_0, around_1, around_2, p_ball_radius, climb_0, climb_1, climb_2, climb_3, cos_0, cos_1, cos_2, cos_3, cosine_0, cosine_1, cosine_2, cosine_3, p_gravity, near_0, near_1, near_2, omega_0, omega_1, omega_2, pressed_0, pressed_1, pressed_2, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sine_0, sine_1, sine_2, sine_3, tilted_0, tilted_1, tilted_2, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, p_wire_radius);
            V near_3 = _o286.near_3;
            V omega_3 = _o286.omega_3;
            V around_3 = _o286.around_3;
            V tilted_3 = _o286.tilted_3;
            V pressed_3 = _o286.pressed_3;
            V force_3 = _o286.force_3;
            V cosine_4 = _o286.cosine_4;
            V sine_4 = _o286.sine_4;
            V climb_4 = _o286.climb_4;
            V along_4 = _o286.along_4;
            V turn_rate_4 = _o286.turn_rate_4;
            V cos_4 = _o286.cos_4;
            V sin_4 = _o286.sin_4;
            const LANES(court_ring_round_4_out) _o287 =
                LANES(court_ring_round_4)(along_0, along_1, along_2, along_3, along_4, around_0, around_1, around_2, around_3, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, cos_0, cos_1, cos_2, cos_3, cos_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, p_gravity, near_0, near_1, near_2, near_3, omega_0, omega_1, omega_2, omega_3, pressed_0, pressed_1, pressed_2, pressed_3, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sine_0, sine_1, sine_2, sine_3, sine_4, tilted_0, tilted_1, tilted_2, tilted_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, p_wire_radius);
            V near_4 = _o287.near_4;
            V omega_4 = _o287.omega_4;
            V around_4 = _o287.around_4;
            V tilted_4 = _o287.tilted_4;
            V pressed_4 = _o287.pressed_4;
            V force_4 = _o287.force_4;
            V cosine_5 = _o287.cosine_5;
            V sine_5 = _o287.sine_5;
            V climb_5 = _o287.climb_5;
            V along_5 = _o287.along_5;
            V turn_rate_5 = _o287.turn_rate_5;
            V cos_5 = _o287.cos_5;
            V sin_5 = _o287.sin_5;
            const LANES(court_ring_round_5_out) _o288 =
                LANES(court_ring_round_5)(along_0, along_1, along_2, along_3, along_4, along_5, around_0, around_1, around_2, around_3, around_4, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, p_gravity, near_0, near_1, near_2, near_3, near_4, omega_0, omega_1, omega_2, omega_3, omega_4, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, p_wire_radius);
            V near_5 = _o288.near_5;
            V omega_5 = _o288.omega_5;
            V around_5 = _o288.around_5;
            V tilted_5 = _o288.tilted_5;
            V pressed_5 = _o288.pressed_5;
            V force_5 = _o288.force_5;
            V cosine_6 = _o288.cosine_6;
            V sine_6 = _o288.sine_6;
            V climb_6 = _o288.climb_6;
            V along_6 = _o288.along_6;
            V turn_rate_6 = _o288.turn_rate_6;
            V cos_6 = _o288.cos_6;
            V sin_6 = _o288.sin_6;
            const LANES(court_ring_round_6_out) _o289 =
                LANES(court_ring_round_6)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, around_0, around_1, around_2, around_3, around_4, around_5, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, p_wire_radius);
            V near_6 = _o289.near_6;
            V omega_6 = _o289.omega_6;
            V around_6 = _o289.around_6;
            V tilted_6 = _o289.tilted_6;
            V pressed_6 = _o289.pressed_6;
            V force_6 = _o289.force_6;
            V cosine_7 = _o289.cosine_7;
            V sine_7 = _o289.sine_7;
            V climb_7 = _o289.climb_7;
            V along_7 = _o289.along_7;
            V turn_rate_7 = _o289.turn_rate_7;
            V cos_7 = _o289.cos_7;
            V sin_7 = _o289.sin_7;
            const LANES(court_ring_round_7_out) _o290 =
                LANES(court_ring_round_7)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, p_wire_radius);
            V near_7 = _o290.near_7;
            V omega_7 = _o290.omega_7;
            V around_7 = _o290.around_7;
            V tilted_7 = _o290.tilted_7;
            V pressed_7 = _o290.pressed_7;
            V force_7 = _o290.force_7;
            V cosine_8 = _o290.cosine_8;
            V sine_8 = _o290.sine_8;
            V climb_8 = _o290.climb_8;
            V along_8 = _o290.along_8;
            V turn_rate_8 = _o290.turn_rate_8;
            V cos_8 = _o290.cos_8;
            V sin_8 = _o290.sin_8;
            const LANES(court_ring_round_8_out) _o291 =
                LANES(court_ring_round_8)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, p_wire_radius);
            V near_8 = _o291.near_8;
            V omega_8 = _o291.omega_8;
            V around_8 = _o291.around_8;
            V tilted_8 = _o291.tilted_8;
            V pressed_8 = _o291.pressed_8;
            V force_8 = _o291.force_8;
            V cosine_9 = _o291.cosine_9;
            V sine_9 = _o291.sine_9;
            V climb_9 = _o291.climb_9;
            V along_9 = _o291.along_9;
            V turn_rate_9 = _o291.turn_rate_9;
            V cos_9 = _o291.cos_9;
            V sin_9 = _o291.sin_9;
            const LANES(court_ring_round_9_out) _o292 =
                LANES(court_ring_round_9)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V near_9 = _o292.near_9;
            V omega_9 = _o292.omega_9;
            V around_9 = _o292.around_9;
            V tilted_9 = _o292.tilted_9;
            V pressed_9 = _o292.pressed_9;
            V force_9 = _o292.force_9;
            V cosine_10 = _o292.cosine_10;
            V sine_10 = _o292.sine_10;
            V climb_10 = _o292.climb_10;
            V along_10 = _o292.along_10;
            V turn_rate_10 = _o292.turn_rate_10;
            V cos_10 = _o292.cos_10;
            V sin_10 = _o292.sin_10;
            const LANES(court_ring_round_10_out) _o293 =
                LANES(court_ring_round_10)(along_0, along_1, along_10, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V near_10 = _o293.near_10;
            V omega_10 = _o293.omega_10;
            V around_10 = _o293.around_10;
            V tilted_10 = _o293.tilted_10;
            V pressed_10 = _o293.pressed_10;
            V force_10 = _o293.force_10;
            V cosine_11 = _o293.cosine_11;
            V sine_11 = _o293.sine_11;
            V climb_11 = _o293.climb_11;
            V along_11 = _o293.along_11;
            V turn_rate_11 = _o293.turn_rate_11;
            V cos_11 = _o293.cos_11;
            V sin_11 = _o293.sin_11;
            const LANES(court_ring_round_11_out) _o294 =
                LANES(court_ring_round_11)(along_0, along_1, along_10, along_11, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_10, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_10, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_10, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_10, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            V force_11 = _o294.force_11;
            V cosine_12 = _o294.cosine_12;
            V sine_12 = _o294.sine_12;
            V climb_12 = _o294.climb_12;
            V along_12 = _o294.along_12;
            V turn_rate_12 = _o294.turn_rate_12;
            V cos_12 = _o294.cos_12;
            V sin_12 = _o294.sin_12;
            const LANES(court_ring_round_pace_out) _o295 =
                LANES(court_ring_round_pace)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_12, cosine_0, cosine_12, force_0, force_1, force_10, force_11, force_2, force_3, force_4, force_5, force_6, force_7, force_8, force_9, p_gravity, omega_0, p_ring_radius, sin_0, sin_12, sine_0, sine_12, turn_rate_0, turn_rate_11, turn_rate_12, p_wire_radius);
            V stride = _o295.stride;
            V strongest = _o295.strongest;
            V fastest = _o295.fastest;
            V sway = _o295.sway;
            V force = _o295.force;
            V force_rate = _o295.force_rate;
            V force_bend = _o295.force_bend;
            V brace = _o295.brace;
            V vx_1 = _o295.vx_1;
            V vy_1 = _o295.vy_1;
            V vz_1 = _o295.vz_1;
            const LANES(court_ring_round_pulled_out) _o296 =
                LANES(court_ring_round_pulled)(climb_0, climb_1, cosine_0, cosine_1, p_gravity, omega_0, omega_1, turn_rate_0, turn_rate_1);
            V drag = _o296.drag;
            V drag_rate = _o296.drag_rate;
            const LANES(court_ring_impact_strained_out) _o297 =
                LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, p_ring_friction);
            V strain = _o297.strain;
            V strain_rate = _o297.strain_rate;
            const LANES(court_losing_out) _o298 =
                LANES(court_losing)(grip_lost, strain);
            M loses = _o298.loses;
            const M _m299 = lanes_both(active, loses);
            if (lanes_any(_m299)) {
                const LANES(court_lost_grip_out) _o300 =
                    LANES(court_lost_grip)(clock, strain, strain_rate, taut, taut_clock, taut_rate);
                grip_lost = lanes_select(_m299, _o300.grip_lost, grip_lost);
            }
            const LANES(court_tightened_out) _o301 =
                LANES(court_tightened)(clock, strain, strain_rate);
            taut = _o301.taut;
            taut_rate = _o301.taut_rate;
            taut_clock = _o301.taut_clock;
            const LANES(court_leaving_force_out) _o302 =
                LANES(court_leaving_force)(p_ball_radius, brace, doubt, fastest, force, force_bend, force_rate, p_gravity, per_reach, position_error, stride, velocity_error, vx, vx_1, vy, vy_1, vz, vz_1, which);
            stride = _o302.stride;
            which = _o302.which;
            M rests = _o302.rests;
            doubt = _o302.doubt;
            const LANES(court_backboard_beside_out) _o303 =
                LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            V gap = _o303.gap;
            V nearing = _o303.nearing;
            V dent = _o303.dent;
            const LANES(court_beside_body_out) _o304 =
                LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(1.0), late, nearing, position_error, stride, strongest, which, x, y, z);
            stride = _o304.stride;
            which = _o304.which;
            doubt = _o304.doubt;
            late = _o304.late;
            const LANES(court_bridge_beside_out) _o305 =
                LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o305.gap;
            nearing = _o305.nearing;
            dent = _o305.dent;
            const LANES(court_beside_body_out) _o306 =
                LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(2.0), late, nearing, position_error, stride, strongest, which, x, y, z);
            stride = _o306.stride;
            which = _o306.which;
            doubt = _o306.doubt;
            late = _o306.late;
            const LANES(court_end_beside_out) _o307 =
                LANES(court_end_beside)(p_end_depth, vz, z);
            gap = _o307.gap;
            nearing = _o307.nearing;
            dent = _o307.dent;
            const LANES(court_beside_gate_out) _o308 =
                LANES(court_beside_gate)(p_ball_radius, dent, doubt, fastest, gap, K(3.0), late, nearing, position_error, stride, strongest, which, x, y, z);
            stride = _o308.stride;
            which = _o308.which;
            doubt = _o308.doubt;
            late = _o308.late;
            const LANES(court_beside_time_out) _o309 =
                LANES(court_beside_time)(clock, stride, time_limit, which);
            stride = _o309.stride;
            which = _o309.which;
            const LANES(court_apart_out) _o310 =
                LANES(court_apart)(p_ball_radius, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz);
            V apart = _o310.apart;
            const LANES(court_neighbour_out) _o311 =
                LANES(court_neighbour)(apart, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, vx, vy, vz, wx, wy, wz, x, y, z);
            V far_x = _o311.far_x;
            V far_y = _o311.far_y;
            V far_z = _o311.far_z;
            V far_vx = _o311.far_vx;
            V far_vy = _o311.far_vy;
            V far_vz = _o311.far_vz;
            V far_wx = _o311.far_wx;
            V far_wy = _o311.far_wy;
            V far_wz = _o311.far_wz;
            const LANES(court_passing_from_out) _o312 =
                LANES(court_passing_from)(z);
            M over = _o312.over;
            const LANES(court_alone_out) _o313 =
                LANES(court_alone)();
            V berth = _o313.nearest;
            const LANES(court_leaps_out) _o314 =
                LANES(court_leaps)(stride);
            V forth = _o314.forth;
            V back = _o314.back;
            const LANES(court_backboard_around_out) _o315 =
                LANES(court_backboard_around)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            gap = _o315.gap;
            nearing = _o315.nearing;
            const LANES(court_cleared_out) _o316 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o316.berth;
            const LANES(court_bridge_around_out) _o317 =
                LANES(court_bridge_around)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o317.gap;
            nearing = _o317.nearing;
            const LANES(court_cleared_out) _o318 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o318.berth;
            const LANES(court_end_around_out) _o319 =
                LANES(court_end_around)(p_end_depth, vz, z);
            gap = _o319.gap;
            nearing = _o319.nearing;
            const LANES(court_cleared_out) _o320 =
                LANES(court_cleared)(berth, gap, forth, nearing);
            berth = _o320.berth;
            const LANES(court_ring_round_moved_out) _o321 =
                LANES(court_ring_round_moved)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_12, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_12, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_12, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_12, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, stride, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_12, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            x = _o321.x;
            y = _o321.y;
            z = _o321.z;
            vx = _o321.vx;
            vy = _o321.vy;
            vz = _o321.vz;
            wx = _o321.wx;
            wy = _o321.wy;
            wz = _o321.wz;
            V climb = _o321.climb;
            const LANES(court_passing_in_contact_out) _o322 =
                LANES(court_passing_in_contact)(over, p_ring_radius, through, x, y, z);
            through = _o322.through;
            const LANES(court_backboard_around_out) _o323 =
                LANES(court_backboard_around)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
            gap = _o323.gap;
            nearing = _o323.nearing;
            const LANES(court_cleared_out) _o324 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o324.berth;
            const LANES(court_bridge_around_out) _o325 =
                LANES(court_bridge_around)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
            gap = _o325.gap;
            nearing = _o325.nearing;
            const LANES(court_cleared_out) _o326 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o326.berth;
            const LANES(court_end_around_out) _o327 =
                LANES(court_end_around)(p_end_depth, vz, z);
            gap = _o327.gap;
            nearing = _o327.nearing;
            const LANES(court_cleared_out) _o328 =
                LANES(court_cleared)(berth, gap, back, nearing);
            berth = _o328.berth;
            const LANES(court_ring_swung_out) _o329 =
                LANES(court_ring_swung)(p_ball_radius, berth, circled, climb, climb_0, doubt, fastest, force, force_bend, force_rate, p_gravity, position_error, stride, sway, velocity_error, which, p_wire_radius);
            circled = _o329.circled;
            M endless = _o329.endless;
            doubt = _o329.doubt;
            const LANES(court_for_ever_out) _o330 =
                LANES(court_for_ever)(endless, which);
            which = _o330.which;
            const LANES(court_ring_round_start_out) _o331 =
                LANES(court_ring_round_start)(p_ball_radius, p_ring_radius, far_vx, far_vy, far_vz, p_wire_radius, far_wx, far_wy, far_wz, far_x, far_y, far_z);
            cosine_0 = _o331.cosine_0;
            sine_0 = _o331.sine_0;
            climb_0 = _o331.climb_0;
            along_0 = _o331.along_0;
            turn_rate_0 = _o331.turn_rate_0;
            cos_0 = _o331.cos_0;
            sin_0 = _o331.sin_0;
            near_0 = _o331.near_0;
            const LANES(court_ring_round_0_out) _o332 =
                LANES(court_ring_round_0)(along_0, p_ball_radius, climb_0, cos_0, cosine_0, p_gravity, near_0, p_ring_radius, sin_0, sine_0, turn_rate_0, p_wire_radius);
            omega_0 = _o332.omega_0;
            around_0 = _o332.around_0;
            tilted_0 = _o332.tilted_0;
            pressed_0 = _o332.pressed_0;
            cosine_1 = _o332.cosine_1;
            sine_1 = _o332.sine_1;
            climb_1 = _o332.climb_1;
            along_1 = _o332.along_1;
            turn_rate_1 = _o332.turn_rate_1;
            cos_1 = _o332.cos_1;
            sin_1 = _o332.sin_1;
            const LANES(court_ring_round_1_out) _o333 =
                LANES(court_ring_round_1)(along_0, along_1, around_0, p_ball_radius, climb_0, climb_1, cos_0, cos_1, cosine_0, cosine_1, p_gravity, near_0, omega_0, pressed_0, p_ring_radius, sin_0, sin_1, sine_0, sine_1, tilted_0, turn_rate_0, turn_rate_1, p_wire_radius);
            near_1 = _o333.near_1;
            omega_1 = _o333.omega_1;
            around_1 = _o333.around_1;
            tilted_1 = _o333.tilted_1;
            pressed_1 = _o333.pressed_1;
            cosine_2 = _o333.cosine_2;
            sine_2 = _o333.sine_2;
            climb_2 = _o333.climb_2;
            along_2 = _o333.along_2;
            turn_rate_2 = _o333.turn_rate_2;
            cos_2 = _o333.cos_2;
            sin_2 = _o333.sin_2;
            const LANES(court_ring_round_2_out) _o334 =
                LANES(court_ring_round_2)(along_0, along_1, along_2, around_0, around_1, p_ball_radius, climb_0, climb_1, climb_2, cos_0, cos_1, cos_2, cosine_0, cosine_1, cosine_2, p_gravity, near_0, near_1, omega_0, omega_1, pressed_0, pressed_1, p_ring_radius, sin_0, sin_1, sin_2, sine_0, sine_1, sine_2, tilted_0, tilted_1, turn_rate_0, turn_rate_1, turn_rate_2, p_wire_radius);
            near_2 = _o334.near_2;
            omega_2 = _o334.omega_2;
            around_2 = _o334.around_2;
            tilted_2 = _o334.tilted_2;
            pressed_2 = _o334.pressed_2;
            cosine_3 = _o334.cosine_3;
            sine_3 = _o334.sine_3;
            climb_3 = _o334.climb_3;
            along_3 = _o334.along_3;
            turn_rate_3 = _o334.turn_rate_3;
            cos_3 = _o334.cos_3;
            sin_3 = _o334.sin_3;
            const LANES(court_ring_round_3_out) _o335 =
                LANES(court_ring_round_3)(along_0, along_1, along_2, along_3, around_0, around_1, around_2, p_ball_radius, climb_0, climb_1, climb_2, climb_3, cos_0, cos_1, cos_2, cos_3, cosine_0, cosine_1, cosine_2, cosine_3, p_gravity, near_0, near_1, near_2, omega_0, omega_1, omega_2, pressed_0, pressed_1, pressed_2, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sine_0, sine_1, sine_2, sine_3, tilted_0, tilted_1, tilted_2, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, p_wire_radius);
            near_3 = _o335.near_3;
            omega_3 = _o335.omega_3;
            around_3 = _o335.around_3;
            tilted_3 = _o335.tilted_3;
            pressed_3 = _o335.pressed_3;
            cosine_4 = _o335.cosine_4;
            sine_4 = _o335.sine_4;
            climb_4 = _o335.climb_4;
            along_4 = _o335.along_4;
            turn_rate_4 = _o335.turn_rate_4;
            cos_4 = _o335.cos_4;
            sin_4 = _o335.sin_4;
            const LANES(court_ring_round_4_out) _o336 =
                LANES(court_ring_round_4)(along_0, along_1, along_2, along_3, along_4, around_0, around_1, around_2, around_3, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, cos_0, cos_1, cos_2, cos_3, cos_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, p_gravity, near_0, near_1, near_2, near_3, omega_0, omega_1, omega_2, omega_3, pressed_0, pressed_1, pressed_2, pressed_3, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sine_0, sine_1, sine_2, sine_3, sine_4, tilted_0, tilted_1, tilted_2, tilted_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, p_wire_radius);
            near_4 = _o336.near_4;
            omega_4 = _o336.omega_4;
            around_4 = _o336.around_4;
            tilted_4 = _o336.tilted_4;
            pressed_4 = _o336.pressed_4;
            cosine_5 = _o336.cosine_5;
            sine_5 = _o336.sine_5;
            climb_5 = _o336.climb_5;
            along_5 = _o336.along_5;
            turn_rate_5 = _o336.turn_rate_5;
            cos_5 = _o336.cos_5;
            sin_5 = _o336.sin_5;
            const LANES(court_ring_round_5_out) _o337 =
                LANES(court_ring_round_5)(along_0, along_1, along_2, along_3, along_4, along_5, around_0, around_1, around_2, around_3, around_4, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, p_gravity, near_0, near_1, near_2, near_3, near_4, omega_0, omega_1, omega_2, omega_3, omega_4, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, p_wire_radius);
            near_5 = _o337.near_5;
            omega_5 = _o337.omega_5;
            around_5 = _o337.around_5;
            tilted_5 = _o337.tilted_5;
            pressed_5 = _o337.pressed_5;
            cosine_6 = _o337.cosine_6;
            sine_6 = _o337.sine_6;
            climb_6 = _o337.climb_6;
            along_6 = _o337.along_6;
            turn_rate_6 = _o337.turn_rate_6;
            cos_6 = _o337.cos_6;
            sin_6 = _o337.sin_6;
            const LANES(court_ring_round_6_out) _o338 =
                LANES(court_ring_round_6)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, around_0, around_1, around_2, around_3, around_4, around_5, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, p_wire_radius);
            near_6 = _o338.near_6;
            omega_6 = _o338.omega_6;
            around_6 = _o338.around_6;
            tilted_6 = _o338.tilted_6;
            pressed_6 = _o338.pressed_6;
            cosine_7 = _o338.cosine_7;
            sine_7 = _o338.sine_7;
            climb_7 = _o338.climb_7;
            along_7 = _o338.along_7;
            turn_rate_7 = _o338.turn_rate_7;
            cos_7 = _o338.cos_7;
            sin_7 = _o338.sin_7;
            const LANES(court_ring_round_7_out) _o339 =
                LANES(court_ring_round_7)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, p_wire_radius);
            near_7 = _o339.near_7;
            omega_7 = _o339.omega_7;
            around_7 = _o339.around_7;
            tilted_7 = _o339.tilted_7;
            pressed_7 = _o339.pressed_7;
            cosine_8 = _o339.cosine_8;
            sine_8 = _o339.sine_8;
            climb_8 = _o339.climb_8;
            along_8 = _o339.along_8;
            turn_rate_8 = _o339.turn_rate_8;
            cos_8 = _o339.cos_8;
            sin_8 = _o339.sin_8;
            const LANES(court_ring_round_8_out) _o340 =
                LANES(court_ring_round_8)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, p_wire_radius);
            near_8 = _o340.near_8;
            omega_8 = _o340.omega_8;
            around_8 = _o340.around_8;
            tilted_8 = _o340.tilted_8;
            pressed_8 = _o340.pressed_8;
            cosine_9 = _o340.cosine_9;
            sine_9 = _o340.sine_9;
            climb_9 = _o340.climb_9;
            along_9 = _o340.along_9;
            turn_rate_9 = _o340.turn_rate_9;
            cos_9 = _o340.cos_9;
            sin_9 = _o340.sin_9;
            const LANES(court_ring_round_9_out) _o341 =
                LANES(court_ring_round_9)(along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, p_ball_radius, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, p_ring_radius, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            near_9 = _o341.near_9;
            omega_9 = _o341.omega_9;
            around_9 = _o341.around_9;
            tilted_9 = _o341.tilted_9;
            pressed_9 = _o341.pressed_9;
            cosine_10 = _o341.cosine_10;
            sine_10 = _o341.sine_10;
            climb_10 = _o341.climb_10;
            along_10 = _o341.along_10;
            turn_rate_10 = _o341.turn_rate_10;
            cos_10 = _o341.cos_10;
            sin_10 = _o341.sin_10;
            const LANES(court_ring_round_10_out) _o342 =
                LANES(court_ring_round_10)(along_0, along_1, along_10, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            near_10 = _o342.near_10;
            omega_10 = _o342.omega_10;
            around_10 = _o342.around_10;
            tilted_10 = _o342.tilted_10;
            pressed_10 = _o342.pressed_10;
            cosine_11 = _o342.cosine_11;
            sine_11 = _o342.sine_11;
            climb_11 = _o342.climb_11;
            along_11 = _o342.along_11;
            turn_rate_11 = _o342.turn_rate_11;
            cos_11 = _o342.cos_11;
            sin_11 = _o342.sin_11;
            const LANES(court_ring_round_11_out) _o343 =
                LANES(court_ring_round_11)(along_0, along_1, along_10, along_11, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, around_0, around_1, around_10, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_gravity, near_0, near_1, near_10, near_2, near_3, near_4, near_5, near_6, near_7, near_8, near_9, omega_0, omega_1, omega_10, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, pressed_0, pressed_1, pressed_10, pressed_2, pressed_3, pressed_4, pressed_5, pressed_6, pressed_7, pressed_8, pressed_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, tilted_0, tilted_1, tilted_10, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            cosine_12 = _o343.cosine_12;
            sine_12 = _o343.sine_12;
            climb_12 = _o343.climb_12;
            along_12 = _o343.along_12;
            turn_rate_12 = _o343.turn_rate_12;
            cos_12 = _o343.cos_12;
            sin_12 = _o343.sin_12;
            const LANES(court_ring_round_moved_out) _o344 =
                LANES(court_ring_round_moved)(along_0, along_1, along_10, along_11, along_12, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, p_ball_radius, climb_0, climb_1, climb_10, climb_11, climb_12, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cos_0, cos_1, cos_10, cos_11, cos_12, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, cos_8, cos_9, cosine_0, cosine_1, cosine_10, cosine_11, cosine_12, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, p_ring_radius, sin_0, sin_1, sin_10, sin_11, sin_12, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, sin_8, sin_9, sine_0, sine_1, sine_10, sine_11, sine_12, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, stride, turn_rate_0, turn_rate_1, turn_rate_10, turn_rate_11, turn_rate_12, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, p_wire_radius);
            far_x = _o344.x;
            far_y = _o344.y;
            far_z = _o344.z;
            far_vx = _o344.vx;
            far_vy = _o344.vy;
            far_vz = _o344.vz;
            far_wx = _o344.wx;
            far_wy = _o344.wy;
            far_wz = _o344.wz;
            const LANES(court_compared_out) _o345 =
                LANES(court_compared)(apart, p_ball_radius, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_x, far_y, far_z, vx, vy, vz, wx, wy, wz, x, y, z);
            dx = _o345.dx;
            dy = _o345.dy;
            dz = _o345.dz;
            dvx = _o345.dvx;
            dvy = _o345.dvy;
            dvz = _o345.dvz;
            dwx = _o345.dwx;
            dwy = _o345.dwy;
            dwz = _o345.dwz;
            const LANES(court_rolled_on_out) _o346 =
                LANES(court_rolled_on)(clock, rests, stride, which);
            clock = _o346.clock;
            circling = _o346.rolling;
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
        V position_error = lanes_load(lists->kept_position_error + i);
        M rolling = lanes_less(K(0.0), lanes_load(lists->kept_rolling + i));
        V snap = lanes_load(lists->kept_snap + i);
        V surge = lanes_load(lists->kept_surge + i);
        V velocity_error = lanes_load(lists->kept_velocity_error + i);
        V vx = lanes_load(lists->kept_vx + i);
        V vy = lanes_load(lists->kept_vy + i);
        V vz = lanes_load(lists->kept_vz + i);
        V when = lanes_load(lists->kept_when + i);
        V which = lanes_load(lists->kept_which + i);
        V x = lanes_load(lists->kept_x + i);
        V y = lanes_load(lists->kept_y + i);
        V z = lanes_load(lists->kept_z + i);
        const LANES(court_rejoined_out) _o347 =
            LANES(court_rejoined)(circling, rolling);
        rolling = _o347.rolling;
        const M _m348 = lanes_both(rows, leaves);
        if (lanes_any(_m348)) {
            const LANES(court_error_bounds_out) _o349 =
                LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            position_error = lanes_select(_m348, _o349.position_error, position_error);
            velocity_error = lanes_select(_m348, _o349.velocity_error, velocity_error);
            const LANES(court_holding_out) _o350 =
                LANES(court_holding)(held, K(0.0));
            M here = _o350.here;
            const M _m351 = lanes_both(_m348, here);
            if (lanes_any(_m351)) {
                const LANES(court_ring_tube_out) _o352 =
                    LANES(court_ring_tube)(p_ball_radius, p_wire_radius);
                per_reach = lanes_select(_m351, _o352.per_reach, per_reach);
                const LANES(court_ring_parting_out) _o353 =
                    LANES(court_ring_parting)(p_gravity, p_ring_radius, vx, vy, vz, x, y, z);
                lift = lanes_select(_m351, _o353.lift, lift);
                surge = lanes_select(_m351, _o353.surge, surge);
                snap = lanes_select(_m351, _o353.snap, snap);
            }
            const LANES(court_holding_out) _o354 =
                LANES(court_holding)(held, K(1.0));
            here = _o354.here;
            const M _m355 = lanes_both(_m348, here);
            if (lanes_any(_m355)) {
                const LANES(court_backboard_tube_out) _o356 =
                    LANES(court_backboard_tube)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                per_reach = lanes_select(_m355, _o356.per_reach, per_reach);
                const LANES(court_backboard_parting_out) _o357 =
                    LANES(court_backboard_parting)(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, vx, vy, vz, x, y, z);
                lift = lanes_select(_m355, _o357.lift, lift);
                surge = lanes_select(_m355, _o357.surge, surge);
                snap = lanes_select(_m355, _o357.snap, snap);
            }
            const LANES(court_holding_out) _o358 =
                LANES(court_holding)(held, K(2.0));
            here = _o358.here;
            const M _m359 = lanes_both(_m348, here);
            if (lanes_any(_m359)) {
                const LANES(court_bridge_tube_out) _o360 =
                    LANES(court_bridge_tube)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                per_reach = lanes_select(_m359, _o360.per_reach, per_reach);
                const LANES(court_bridge_parting_out) _o361 =
                    LANES(court_bridge_parting)(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                lift = lanes_select(_m359, _o361.lift, lift);
                surge = lanes_select(_m359, _o361.surge, surge);
                snap = lanes_select(_m359, _o361.snap, snap);
            }
            const LANES(court_unmet_out) _o362 =
                LANES(court_unmet)();
            V spare = _o362.spare;
            const LANES(court_beside_out) _o363 =
                LANES(court_beside)(held, K(0.0));
            M beside = _o363.beside;
            const M _m364 = lanes_both(_m348, beside);
            if (lanes_any(_m364)) {
                const LANES(court_ring_beside_out) _o365 =
                    LANES(court_ring_beside)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                V gap = _o365.gap;
                V nearing = _o365.nearing;
                V dent = _o365.dent;
                const LANES(court_spared_out) _o366 =
                    LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
                spare = lanes_select(_m364, _o366.spare, spare);
            }
            const LANES(court_beside_out) _o367 =
                LANES(court_beside)(held, K(1.0));
            beside = _o367.beside;
            const M _m368 = lanes_both(_m348, beside);
            if (lanes_any(_m368)) {
                const LANES(court_backboard_beside_out) _o369 =
                    LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                V gap = _o369.gap;
                V nearing = _o369.nearing;
                V dent = _o369.dent;
                const LANES(court_spared_out) _o370 =
                    LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
                spare = lanes_select(_m368, _o370.spare, spare);
            }
            const LANES(court_beside_out) _o371 =
                LANES(court_beside)(held, K(2.0));
            beside = _o371.beside;
            const M _m372 = lanes_both(_m348, beside);
            if (lanes_any(_m372)) {
                const LANES(court_bridge_beside_out) _o373 =
                    LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                V gap = _o373.gap;
                V nearing = _o373.nearing;
                V dent = _o373.dent;
                const LANES(court_spared_out) _o374 =
                    LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
                spare = lanes_select(_m372, _o374.spare, spare);
            }
            const LANES(court_beside_out) _o375 =
                LANES(court_beside)(held, K(3.0));
            beside = _o375.beside;
            const M _m376 = lanes_both(_m348, beside);
            if (lanes_any(_m376)) {
                const LANES(court_end_beside_out) _o377 =
                    LANES(court_end_beside)(p_end_depth, vz, z);
                V gap = _o377.gap;
                V nearing = _o377.nearing;
                V dent = _o377.dent;
                const LANES(court_spared_out) _o378 =
                    LANES(court_spared)(dent, gap, p_gravity, nearing, spare, vx, vy, vz);
                spare = lanes_select(_m376, _o378.spare, spare);
            }
            const LANES(court_holding_out) _o379 =
                LANES(court_holding)(held, K(1.0));
            here = _o379.here;
            const M _m380 = lanes_both(_m348, here);
            if (lanes_any(_m380)) {
                const LANES(court_backboard_seam0_out) _o381 =
                    LANES(court_backboard_seam0)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                V gap = _o381.gap;
                V nearing = _o381.nearing;
                V near = _o381.near;
                const LANES(court_spared_seam_out) _o382 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m380, _o382.spare, spare);
                const LANES(court_backboard_seam1_out) _o383 =
                    LANES(court_backboard_seam1)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                gap = _o383.gap;
                nearing = _o383.nearing;
                near = _o383.near;
                const LANES(court_spared_seam_out) _o384 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m380, _o384.spare, spare);
                const LANES(court_backboard_seam2_out) _o385 =
                    LANES(court_backboard_seam2)(p_ball_radius, p_board_half_width, vy, y);
                gap = _o385.gap;
                nearing = _o385.nearing;
                near = _o385.near;
                const LANES(court_spared_seam_out) _o386 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m380, _o386.spare, spare);
                const LANES(court_backboard_seam3_out) _o387 =
                    LANES(court_backboard_seam3)(p_ball_radius, p_board_half_width, vy, y);
                gap = _o387.gap;
                nearing = _o387.nearing;
                near = _o387.near;
                const LANES(court_spared_seam_out) _o388 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m380, _o388.spare, spare);
                const LANES(court_backboard_seam4_out) _o389 =
                    LANES(court_backboard_seam4)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                gap = _o389.gap;
                nearing = _o389.nearing;
                near = _o389.near;
                const LANES(court_spared_seam_out) _o390 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m380, _o390.spare, spare);
                const LANES(court_backboard_seam5_out) _o391 =
                    LANES(court_backboard_seam5)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                gap = _o391.gap;
                nearing = _o391.nearing;
                near = _o391.near;
                const LANES(court_spared_seam_out) _o392 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m380, _o392.spare, spare);
            }
            const LANES(court_holding_out) _o393 =
                LANES(court_holding)(held, K(2.0));
            here = _o393.here;
            const M _m394 = lanes_both(_m348, here);
            if (lanes_any(_m394)) {
                const LANES(court_bridge_seam0_out) _o395 =
                    LANES(court_bridge_seam0)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                V gap = _o395.gap;
                V nearing = _o395.nearing;
                V near = _o395.near;
                const LANES(court_spared_seam_out) _o396 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m394, _o396.spare, spare);
                const LANES(court_bridge_seam1_out) _o397 =
                    LANES(court_bridge_seam1)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                gap = _o397.gap;
                nearing = _o397.nearing;
                near = _o397.near;
                const LANES(court_spared_seam_out) _o398 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m394, _o398.spare, spare);
                const LANES(court_bridge_seam2_out) _o399 =
                    LANES(court_bridge_seam2)(p_ball_radius, p_bridge_half_width, vy, y);
                gap = _o399.gap;
                nearing = _o399.nearing;
                near = _o399.near;
                const LANES(court_spared_seam_out) _o400 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m394, _o400.spare, spare);
                const LANES(court_bridge_seam3_out) _o401 =
                    LANES(court_bridge_seam3)(p_ball_radius, p_bridge_half_width, vy, y);
                gap = _o401.gap;
                nearing = _o401.nearing;
                near = _o401.near;
                const LANES(court_spared_seam_out) _o402 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m394, _o402.spare, spare);
                const LANES(court_bridge_seam4_out) _o403 =
                    LANES(court_bridge_seam4)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                gap = _o403.gap;
                nearing = _o403.nearing;
                near = _o403.near;
                const LANES(court_spared_seam_out) _o404 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m394, _o404.spare, spare);
                const LANES(court_bridge_seam5_out) _o405 =
                    LANES(court_bridge_seam5)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                gap = _o405.gap;
                nearing = _o405.nearing;
                near = _o405.near;
                const LANES(court_spared_seam_out) _o406 =
                    LANES(court_spared_seam)(gap, p_gravity, near, nearing, spare);
                spare = lanes_select(_m394, _o406.spare, spare);
            }
            const LANES(court_parted_out) _o407 =
                LANES(court_parted)(doubt, p_gravity, lift, per_reach, position_error, snap, spare, surge, velocity_error, vx, vy, vz);
            when = lanes_select(_m348, _o407.when, when);
            doubt = lanes_select(_m348, _o407.doubt, doubt);
            const LANES(court_hopping_out) _o408 =
                LANES(court_hopping)();
            which = lanes_select(_m348, _o408.which, which);
        }
        lanes_store(lists->kept_doubt + i, doubt);
        lanes_store(lists->kept_position_error + i, position_error);
        lanes_store(lists->kept_rolling + i, lanes_select(rolling, K(1.0), K(0.0)));
        lanes_store(lists->kept_velocity_error + i, velocity_error);
        lanes_store(lists->kept_when + i, when);
        lanes_store(lists->kept_which + i, which);
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
        size_t open_searching_shots = 0;
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
            const LANES(court_ring_prepare_out) _o25 =
                LANES(court_ring_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V steady = _o25.steady;
            V swing = _o25.swing;
            V rho_start = _o25.rho_start;
            V low0 = _o25.low0;
            V high0 = _o25.high0;
            V low1 = _o25.low1;
            V high1 = _o25.high1;
            V low2 = _o25.low2;
            V high2 = _o25.high2;
            V ceiling = _o25.ceiling;
            V latest = _o25.latest;
            V lost = _o25.lost;
            const LANES(court_beginning_out) _o26 =
                LANES(court_beginning)();
            V share = _o26.share;
            V arrival = _o26.arrival;
            M certain = _o26.certain;
            const LANES(court_allowance_out) _o27 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
            V position_level = _o27.position_level;
            V velocity_level = _o27.velocity_level;
            V excess = _o27.excess;
            const LANES(court_ring_margins_out) _o28 =
                LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V flat = _o28.margin;
            V tilt = _o28.leaving_margin;
            V rate_slack = _o28.rate_margin;
            const LANES(court_beyond_out) _o29 =
                LANES(court_beyond)(doubt, excess, late, lost, pad);
            doubt = _o29.doubt;
            const LANES(court_ring_enter_out) _o30 =
                LANES(court_ring_enter)(K(0.0), K(0.0), high0, high1, high2, low0, low1, low2, K(0.0));
            V t = _o30.t;
            V end = _o30.end;
            M searching = _o30.searching;
            lanes_store(lists->open_arrival + i, arrival);
            lanes_store(lists->open_ceiling + i, ceiling);
            lanes_store(lists->open_certain + i, lanes_select(certain, K(1.0), K(0.0)));
            lanes_store(lists->open_doubt + i, doubt);
            lanes_store(lists->open_flat + i, flat);
            lanes_store(lists->open_latest + i, latest);
            lanes_store(lists->open_rho_start + i, rho_start);
            lanes_store(lists->open_searching + i, lanes_select(searching, K(1.0), K(0.0)));
            lanes_store(lists->open_t + i, t);
            lanes_store(lists->open_tilt + i, tilt);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_searching_row + open_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_searching_arrival + open_searching_shots, packed, arrival);
                lanes_pack(lists->open_searching_ceiling + open_searching_shots, packed, ceiling);
                lanes_pack(lists->open_searching_certain + open_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->open_searching_doubt + open_searching_shots, packed, doubt);
                lanes_pack(lists->open_searching_end + open_searching_shots, packed, end);
                lanes_pack(lists->open_searching_extent + open_searching_shots, packed, extent);
                lanes_pack(lists->open_searching_flat + open_searching_shots, packed, flat);
                lanes_pack(lists->open_searching_high0 + open_searching_shots, packed, high0);
                lanes_pack(lists->open_searching_high1 + open_searching_shots, packed, high1);
                lanes_pack(lists->open_searching_high2 + open_searching_shots, packed, high2);
                lanes_pack(lists->open_searching_last + open_searching_shots, packed, last);
                lanes_pack(lists->open_searching_latest + open_searching_shots, packed, latest);
                lanes_pack(lists->open_searching_low0 + open_searching_shots, packed, low0);
                lanes_pack(lists->open_searching_low1 + open_searching_shots, packed, low1);
                lanes_pack(lists->open_searching_low2 + open_searching_shots, packed, low2);
                if (varying)
                    lanes_pack(lists->open_searching_p_ball_radius + open_searching_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_searching_p_gravity + open_searching_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->open_searching_p_ring_radius + open_searching_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->open_searching_p_wire_radius + open_searching_shots, packed, p_wire_radius);
                lanes_pack(lists->open_searching_position_error + open_searching_shots, packed, position_error);
                lanes_pack(lists->open_searching_rate_slack + open_searching_shots, packed, rate_slack);
                lanes_pack(lists->open_searching_rho_start + open_searching_shots, packed, rho_start);
                lanes_pack(lists->open_searching_share + open_searching_shots, packed, share);
                lanes_pack(lists->open_searching_speed + open_searching_shots, packed, speed);
                lanes_pack(lists->open_searching_steady + open_searching_shots, packed, steady);
                lanes_pack(lists->open_searching_swing + open_searching_shots, packed, swing);
                lanes_pack(lists->open_searching_t + open_searching_shots, packed, t);
                lanes_pack(lists->open_searching_tilt + open_searching_shots, packed, tilt);
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
                if (taken < open_searching_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->open_searching_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->open_searching_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->open_searching_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->open_searching_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    doubt = lanes_expand(lists->open_searching_doubt + taken, idle, doubt);
                    end = lanes_expand(lists->open_searching_end + taken, idle, end);
                    extent = lanes_expand(lists->open_searching_extent + taken, idle, extent);
                    flat = lanes_expand(lists->open_searching_flat + taken, idle, flat);
                    high0 = lanes_expand(lists->open_searching_high0 + taken, idle, high0);
                    high1 = lanes_expand(lists->open_searching_high1 + taken, idle, high1);
                    high2 = lanes_expand(lists->open_searching_high2 + taken, idle, high2);
                    last = lanes_expand(lists->open_searching_last + taken, idle, last);
                    latest = lanes_expand(lists->open_searching_latest + taken, idle, latest);
                    low0 = lanes_expand(lists->open_searching_low0 + taken, idle, low0);
                    low1 = lanes_expand(lists->open_searching_low1 + taken, idle, low1);
                    low2 = lanes_expand(lists->open_searching_low2 + taken, idle, low2);
                    position_error = lanes_expand(lists->open_searching_position_error + taken, idle, position_error);
                    rate_slack = lanes_expand(lists->open_searching_rate_slack + taken, idle, rate_slack);
                    rho_start = lanes_expand(lists->open_searching_rho_start + taken, idle, rho_start);
                    share = lanes_expand(lists->open_searching_share + taken, idle, share);
                    speed = lanes_expand(lists->open_searching_speed + taken, idle, speed);
                    steady = lanes_expand(lists->open_searching_steady + taken, idle, steady);
                    swing = lanes_expand(lists->open_searching_swing + taken, idle, swing);
                    t = lanes_expand(lists->open_searching_t + taken, idle, t);
                    tilt = lanes_expand(lists->open_searching_tilt + taken, idle, tilt);
                    velocity_error = lanes_expand(lists->open_searching_velocity_error + taken, idle, velocity_error);
                    vx = lanes_expand(lists->open_searching_vx + taken, idle, vx);
                    vy = lanes_expand(lists->open_searching_vy + taken, idle, vy);
                    vz = lanes_expand(lists->open_searching_vz + taken, idle, vz);
                    x = lanes_expand(lists->open_searching_x + taken, idle, x);
                    y = lanes_expand(lists->open_searching_y + taken, idle, y);
                    z = lanes_expand(lists->open_searching_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->open_searching_p_ball_radius + taken, idle, p_ball_radius);
                        p_gravity = lanes_expand(lists->open_searching_p_gravity + taken, idle, p_gravity);
                        p_ring_radius = lanes_expand(lists->open_searching_p_ring_radius + taken, idle, p_ring_radius);
                        p_wire_radius = lanes_expand(lists->open_searching_p_wire_radius + taken, idle, p_wire_radius);
                    }
                    const size_t room = LANES_WIDTH - busy, left = open_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o31 =
                    LANES(court_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = _o31.leaving;
                V margin = _o31.margin;
                const LANES(court_ring_advance_out) _o32 =
                    LANES(court_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V gap = _o32.gap;
                V rate = _o32.rate;
                V bend = _o32.bend;
                V step = _o32.step;
                V next = _o32.next;
                V root = _o32.root;
                V clearance = _o32.clearance;
                const LANES(court_struck_out) _o33 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o33.hit;
                M sure = _o33.sure;
                M vague = _o33.vague;
                const M _m34 = lanes_both(active, vague);
                if (lanes_any(_m34)) {
                    const LANES(court_finer_out) _o35 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m34, _o35.share, share);
                    const LANES(court_allowance_out) _o36 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o36.position_level;
                    V velocity_level = _o36.velocity_level;
                    V excess = _o36.excess;
                    const LANES(court_ring_margins_out) _o37 =
                        LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    flat = lanes_select(_m34, _o37.margin, flat);
                    tilt = lanes_select(_m34, _o37.leaving_margin, tilt);
                    rate_slack = lanes_select(_m34, _o37.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o38 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m34, _o38.doubt, doubt);
                }
                const LANES(court_advanced_out) _o39 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, root, step, sure, t, vague);
                arrival = _o39.arrival;
                certain = _o39.certain;
                M exhausted = _o39.exhausted;
                searching = _o39.searching;
                t = _o39.t;
                const M _m40 = lanes_both(active, exhausted);
                {
                    const LANES(court_ring_enter_out) _o41 =
                        LANES(court_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m40, _o41.t, t);
                    end = lanes_select(_m40, _o41.end, end);
                    searching = lanes_choose(_m40, _o41.searching, searching);
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
                        lists->open_arrival[k] = ended_arrival[lane];
                        lists->open_certain[k] = ended_certain[lane];
                        lists->open_doubt[k] = ended_doubt[lane];
                        lists->open_flat[k] = ended_flat[lane];
                        lists->open_searching[k] = ended_searching[lane];
                        lists->open_t[k] = ended_t[lane];
                        lists->open_tilt[k] = ended_tilt[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            V arrival = lanes_load(lists->open_arrival + i);
            V ceiling = lanes_load(lists->open_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_certain + i));
            V doubt = lanes_load(lists->open_doubt + i);
            V extent = lanes_load(lists->open_extent + i);
            V flat = lanes_load(lists->open_flat + i);
            V last = lanes_load(lists->open_last + i);
            V late = lanes_load(lists->open_late + i);
            V latest = lanes_load(lists->open_latest + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius);
            const V p_gravity = lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->open_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->open_p_wire_radius + i : lists->p_wire_radius);
            V position_error = lanes_load(lists->open_position_error + i);
            V rho_start = lanes_load(lists->open_rho_start + i);
            M searching = lanes_less(K(0.0), lanes_load(lists->open_searching + i));
            V speed = lanes_load(lists->open_speed + i);
            V t = lanes_load(lists->open_t + i);
            V tilt = lanes_load(lists->open_tilt + i);
            V velocity_error = lanes_load(lists->open_velocity_error + i);
            V vx = lanes_load(lists->open_vx + i);
            V vy = lanes_load(lists->open_vy + i);
            V vz = lanes_load(lists->open_vz + i);
            V when = lanes_load(lists->open_when + i);
            V which = lanes_load(lists->open_which + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(court_questioned_out) _o42 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o42.doubt;
            const LANES(court_found_out) _o43 =
                LANES(court_found)(arrival);
            M arrives = _o43.arrives;
            const LANES(court_nearby_out) _o44 =
                LANES(court_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o44.leaving;
            const LANES(court_ring_refine_out) _o45 =
                LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V refined = _o45.time;
            const LANES(court_polished_out) _o46 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o46.arrival;
            const LANES(court_ring_refine_out) _o47 =
                LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            refined = _o47.time;
            V rate = _o47.rate;
            const LANES(court_polished_out) _o48 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o48.arrival;
            const LANES(court_ring_margins_out) _o49 =
                LANES(court_ring_margins)(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            flat = _o49.margin;
            tilt = _o49.leaving_margin;
            V rate_margin = _o49.rate_margin;
            const LANES(court_own_margin_out) _o50 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o50.margin;
            const LANES(court_crossing_out) _o51 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o51.clearance;
            V delay = _o51.delay;
            const LANES(court_landed_out) _o52 =
                LANES(court_landed)(arrival);
            V time = _o52.time;
            const LANES(court_landed_surely_out) _o53 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o53.delay;
            doubt = _o53.doubt;
            const LANES(court_tied_out) _o54 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o54.doubt;
            late = _o54.late;
            const LANES(court_sooner_out) _o55 =
                LANES(court_sooner)(arrives, K(0.0), time, when, which);
            when = _o55.when;
            which = _o55.which;
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
        size_t open_shots = 0;
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
            const LANES(court_horizon_out) _o56 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o56.horizon;
            V pad = _o56.pad;
            const LANES(court_backboard_clear_out) _o57 =
                LANES(court_backboard_clear)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V clear = _o57.clear;
            const LANES(court_opens_in_flight_out) _o58 =
                LANES(court_opens_in_flight)(clear, kept);
            M open = _o58.open;
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
                    lanes_pack(lists->open_p_board_bottom + open_shots, packed, p_board_bottom);
                if (varying)
                    lanes_pack(lists->open_p_board_distance + open_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->open_p_board_half_width + open_shots, packed, p_board_half_width);
                if (varying)
                    lanes_pack(lists->open_p_board_thickness + open_shots, packed, p_board_thickness);
                if (varying)
                    lanes_pack(lists->open_p_board_top + open_shots, packed, p_board_top);
                if (varying)
                    lanes_pack(lists->open_p_gravity + open_shots, packed, p_gravity);
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
        size_t open_searching_shots = 0;
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_shots - i);
            V doubt = lanes_load(lists->open_doubt + i);
            V extent = lanes_load(lists->open_extent + i);
            V last = lanes_load(lists->open_last + i);
            V late = lanes_load(lists->open_late + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_bottom = lanes_load(varying ? lists->open_p_board_bottom + i : lists->p_board_bottom);
            const V p_board_distance = lanes_load(varying ? lists->open_p_board_distance + i : lists->p_board_distance);
            const V p_board_half_width = lanes_load(varying ? lists->open_p_board_half_width + i : lists->p_board_half_width);
            const V p_board_thickness = lanes_load(varying ? lists->open_p_board_thickness + i : lists->p_board_thickness);
            const V p_board_top = lanes_load(varying ? lists->open_p_board_top + i : lists->p_board_top);
            const V p_gravity = lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity);
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
            const LANES(court_backboard_prepare_out) _o59 =
                LANES(court_backboard_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V low0 = _o59.low0;
            V high0 = _o59.high0;
            V low1 = _o59.low1;
            V high1 = _o59.high1;
            V ceiling = _o59.ceiling;
            V latest = _o59.latest;
            V lost = _o59.lost;
            const LANES(court_beginning_out) _o60 =
                LANES(court_beginning)();
            V share = _o60.share;
            V arrival = _o60.arrival;
            M certain = _o60.certain;
            const LANES(court_allowance_out) _o61 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
            V position_level = _o61.position_level;
            V velocity_level = _o61.velocity_level;
            V excess = _o61.excess;
            const LANES(court_backboard_margins_out) _o62 =
                LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V flat = _o62.margin;
            V tilt = _o62.leaving_margin;
            V rate_slack = _o62.rate_margin;
            const LANES(court_beyond_out) _o63 =
                LANES(court_beyond)(doubt, excess, late, lost, pad);
            doubt = _o63.doubt;
            const LANES(court_backboard_enter_out) _o64 =
                LANES(court_backboard_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o64.t;
            V end = _o64.end;
            M searching = _o64.searching;
            lanes_store(lists->open_arrival + i, arrival);
            lanes_store(lists->open_ceiling + i, ceiling);
            lanes_store(lists->open_certain + i, lanes_select(certain, K(1.0), K(0.0)));
            lanes_store(lists->open_doubt + i, doubt);
            lanes_store(lists->open_flat + i, flat);
            lanes_store(lists->open_latest + i, latest);
            lanes_store(lists->open_searching + i, lanes_select(searching, K(1.0), K(0.0)));
            lanes_store(lists->open_t + i, t);
            lanes_store(lists->open_tilt + i, tilt);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_searching_row + open_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_searching_arrival + open_searching_shots, packed, arrival);
                lanes_pack(lists->open_searching_ceiling + open_searching_shots, packed, ceiling);
                lanes_pack(lists->open_searching_certain + open_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->open_searching_doubt + open_searching_shots, packed, doubt);
                lanes_pack(lists->open_searching_end + open_searching_shots, packed, end);
                lanes_pack(lists->open_searching_extent + open_searching_shots, packed, extent);
                lanes_pack(lists->open_searching_flat + open_searching_shots, packed, flat);
                lanes_pack(lists->open_searching_high0 + open_searching_shots, packed, high0);
                lanes_pack(lists->open_searching_high1 + open_searching_shots, packed, high1);
                lanes_pack(lists->open_searching_last + open_searching_shots, packed, last);
                lanes_pack(lists->open_searching_latest + open_searching_shots, packed, latest);
                lanes_pack(lists->open_searching_low0 + open_searching_shots, packed, low0);
                lanes_pack(lists->open_searching_low1 + open_searching_shots, packed, low1);
                if (varying)
                    lanes_pack(lists->open_searching_p_ball_radius + open_searching_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_searching_p_board_bottom + open_searching_shots, packed, p_board_bottom);
                if (varying)
                    lanes_pack(lists->open_searching_p_board_distance + open_searching_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->open_searching_p_board_half_width + open_searching_shots, packed, p_board_half_width);
                if (varying)
                    lanes_pack(lists->open_searching_p_board_thickness + open_searching_shots, packed, p_board_thickness);
                if (varying)
                    lanes_pack(lists->open_searching_p_board_top + open_searching_shots, packed, p_board_top);
                if (varying)
                    lanes_pack(lists->open_searching_p_gravity + open_searching_shots, packed, p_gravity);
                lanes_pack(lists->open_searching_position_error + open_searching_shots, packed, position_error);
                lanes_pack(lists->open_searching_rate_slack + open_searching_shots, packed, rate_slack);
                lanes_pack(lists->open_searching_share + open_searching_shots, packed, share);
                lanes_pack(lists->open_searching_speed + open_searching_shots, packed, speed);
                lanes_pack(lists->open_searching_t + open_searching_shots, packed, t);
                lanes_pack(lists->open_searching_tilt + open_searching_shots, packed, tilt);
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
                if (taken < open_searching_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->open_searching_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->open_searching_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->open_searching_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->open_searching_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    doubt = lanes_expand(lists->open_searching_doubt + taken, idle, doubt);
                    end = lanes_expand(lists->open_searching_end + taken, idle, end);
                    extent = lanes_expand(lists->open_searching_extent + taken, idle, extent);
                    flat = lanes_expand(lists->open_searching_flat + taken, idle, flat);
                    high0 = lanes_expand(lists->open_searching_high0 + taken, idle, high0);
                    high1 = lanes_expand(lists->open_searching_high1 + taken, idle, high1);
                    last = lanes_expand(lists->open_searching_last + taken, idle, last);
                    latest = lanes_expand(lists->open_searching_latest + taken, idle, latest);
                    low0 = lanes_expand(lists->open_searching_low0 + taken, idle, low0);
                    low1 = lanes_expand(lists->open_searching_low1 + taken, idle, low1);
                    position_error = lanes_expand(lists->open_searching_position_error + taken, idle, position_error);
                    rate_slack = lanes_expand(lists->open_searching_rate_slack + taken, idle, rate_slack);
                    share = lanes_expand(lists->open_searching_share + taken, idle, share);
                    speed = lanes_expand(lists->open_searching_speed + taken, idle, speed);
                    t = lanes_expand(lists->open_searching_t + taken, idle, t);
                    tilt = lanes_expand(lists->open_searching_tilt + taken, idle, tilt);
                    velocity_error = lanes_expand(lists->open_searching_velocity_error + taken, idle, velocity_error);
                    vx = lanes_expand(lists->open_searching_vx + taken, idle, vx);
                    vy = lanes_expand(lists->open_searching_vy + taken, idle, vy);
                    vz = lanes_expand(lists->open_searching_vz + taken, idle, vz);
                    x = lanes_expand(lists->open_searching_x + taken, idle, x);
                    y = lanes_expand(lists->open_searching_y + taken, idle, y);
                    z = lanes_expand(lists->open_searching_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->open_searching_p_ball_radius + taken, idle, p_ball_radius);
                        p_board_bottom = lanes_expand(lists->open_searching_p_board_bottom + taken, idle, p_board_bottom);
                        p_board_distance = lanes_expand(lists->open_searching_p_board_distance + taken, idle, p_board_distance);
                        p_board_half_width = lanes_expand(lists->open_searching_p_board_half_width + taken, idle, p_board_half_width);
                        p_board_thickness = lanes_expand(lists->open_searching_p_board_thickness + taken, idle, p_board_thickness);
                        p_board_top = lanes_expand(lists->open_searching_p_board_top + taken, idle, p_board_top);
                        p_gravity = lanes_expand(lists->open_searching_p_gravity + taken, idle, p_gravity);
                    }
                    const size_t room = LANES_WIDTH - busy, left = open_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o65 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o65.leaving;
                V margin = _o65.margin;
                const LANES(court_backboard_advance_out) _o66 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V gap = _o66.gap;
                V rate = _o66.rate;
                V bend = _o66.bend;
                V step = _o66.step;
                V next = _o66.next;
                V root = _o66.root;
                V clearance = _o66.clearance;
                const LANES(court_struck_out) _o67 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o67.hit;
                M sure = _o67.sure;
                M vague = _o67.vague;
                const M _m68 = lanes_both(active, vague);
                if (lanes_any(_m68)) {
                    const LANES(court_finer_out) _o69 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m68, _o69.share, share);
                    const LANES(court_allowance_out) _o70 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o70.position_level;
                    V velocity_level = _o70.velocity_level;
                    V excess = _o70.excess;
                    const LANES(court_backboard_margins_out) _o71 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                    flat = lanes_select(_m68, _o71.margin, flat);
                    tilt = lanes_select(_m68, _o71.leaving_margin, tilt);
                    rate_slack = lanes_select(_m68, _o71.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o72 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m68, _o72.doubt, doubt);
                }
                const LANES(court_advanced_out) _o73 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, root, step, sure, t, vague);
                arrival = _o73.arrival;
                certain = _o73.certain;
                M exhausted = _o73.exhausted;
                searching = _o73.searching;
                t = _o73.t;
                const M _m74 = lanes_both(active, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o75 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m74, _o75.t, t);
                    end = lanes_select(_m74, _o75.end, end);
                    searching = lanes_choose(_m74, _o75.searching, searching);
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
                        lists->open_arrival[k] = ended_arrival[lane];
                        lists->open_certain[k] = ended_certain[lane];
                        lists->open_doubt[k] = ended_doubt[lane];
                        lists->open_flat[k] = ended_flat[lane];
                        lists->open_searching[k] = ended_searching[lane];
                        lists->open_t[k] = ended_t[lane];
                        lists->open_tilt[k] = ended_tilt[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            V arrival = lanes_load(lists->open_arrival + i);
            V ceiling = lanes_load(lists->open_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_certain + i));
            V doubt = lanes_load(lists->open_doubt + i);
            V extent = lanes_load(lists->open_extent + i);
            V flat = lanes_load(lists->open_flat + i);
            V last = lanes_load(lists->open_last + i);
            V late = lanes_load(lists->open_late + i);
            V latest = lanes_load(lists->open_latest + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_bottom = lanes_load(varying ? lists->open_p_board_bottom + i : lists->p_board_bottom);
            const V p_board_distance = lanes_load(varying ? lists->open_p_board_distance + i : lists->p_board_distance);
            const V p_board_half_width = lanes_load(varying ? lists->open_p_board_half_width + i : lists->p_board_half_width);
            const V p_board_thickness = lanes_load(varying ? lists->open_p_board_thickness + i : lists->p_board_thickness);
            const V p_board_top = lanes_load(varying ? lists->open_p_board_top + i : lists->p_board_top);
            const V p_gravity = lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity);
            V position_error = lanes_load(lists->open_position_error + i);
            M searching = lanes_less(K(0.0), lanes_load(lists->open_searching + i));
            V speed = lanes_load(lists->open_speed + i);
            V t = lanes_load(lists->open_t + i);
            V tilt = lanes_load(lists->open_tilt + i);
            V velocity_error = lanes_load(lists->open_velocity_error + i);
            V vx = lanes_load(lists->open_vx + i);
            V vy = lanes_load(lists->open_vy + i);
            V vz = lanes_load(lists->open_vz + i);
            V when = lanes_load(lists->open_when + i);
            V which = lanes_load(lists->open_which + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(court_questioned_out) _o76 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o76.doubt;
            const LANES(court_found_out) _o77 =
                LANES(court_found)(arrival);
            M arrives = _o77.arrives;
            const LANES(court_nearby_out) _o78 =
                LANES(court_nearby)(flat, K(1.0), last, arrival, tilt);
            V leaving = _o78.leaving;
            const LANES(court_backboard_refine_out) _o79 =
                LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V refined = _o79.time;
            const LANES(court_polished_out) _o80 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o80.arrival;
            const LANES(court_backboard_refine_out) _o81 =
                LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            refined = _o81.time;
            V rate = _o81.rate;
            const LANES(court_polished_out) _o82 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o82.arrival;
            const LANES(court_backboard_margins_out) _o83 =
                LANES(court_backboard_margins)(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            flat = _o83.margin;
            tilt = _o83.leaving_margin;
            V rate_margin = _o83.rate_margin;
            const LANES(court_own_margin_out) _o84 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o84.margin;
            const LANES(court_crossing_out) _o85 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o85.clearance;
            V delay = _o85.delay;
            const LANES(court_landed_out) _o86 =
                LANES(court_landed)(arrival);
            V time = _o86.time;
            const LANES(court_landed_surely_out) _o87 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o87.delay;
            doubt = _o87.doubt;
            const LANES(court_tied_out) _o88 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o88.doubt;
            late = _o88.late;
            const LANES(court_sooner_out) _o89 =
                LANES(court_sooner)(arrives, K(1.0), time, when, which);
            when = _o89.when;
            which = _o89.which;
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
        size_t open_shots = 0;
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
            const LANES(court_horizon_out) _o90 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o90.horizon;
            V pad = _o90.pad;
            const LANES(court_bridge_clear_out) _o91 =
                LANES(court_bridge_clear)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V clear = _o91.clear;
            const LANES(court_opens_in_flight_out) _o92 =
                LANES(court_opens_in_flight)(clear, kept);
            M open = _o92.open;
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
                    lanes_pack(lists->open_p_board_distance + open_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->open_p_bridge_depth + open_shots, packed, p_bridge_depth);
                if (varying)
                    lanes_pack(lists->open_p_bridge_half_width + open_shots, packed, p_bridge_half_width);
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
        size_t open_searching_shots = 0;
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_shots - i);
            V doubt = lanes_load(lists->open_doubt + i);
            V extent = lanes_load(lists->open_extent + i);
            V last = lanes_load(lists->open_last + i);
            V late = lanes_load(lists->open_late + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_distance = lanes_load(varying ? lists->open_p_board_distance + i : lists->p_board_distance);
            const V p_bridge_depth = lanes_load(varying ? lists->open_p_bridge_depth + i : lists->p_bridge_depth);
            const V p_bridge_half_width = lanes_load(varying ? lists->open_p_bridge_half_width + i : lists->p_bridge_half_width);
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
            const LANES(court_bridge_prepare_out) _o93 =
                LANES(court_bridge_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V low0 = _o93.low0;
            V high0 = _o93.high0;
            V low1 = _o93.low1;
            V high1 = _o93.high1;
            V ceiling = _o93.ceiling;
            V latest = _o93.latest;
            V lost = _o93.lost;
            const LANES(court_beginning_out) _o94 =
                LANES(court_beginning)();
            V share = _o94.share;
            V arrival = _o94.arrival;
            M certain = _o94.certain;
            const LANES(court_allowance_out) _o95 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
            V position_level = _o95.position_level;
            V velocity_level = _o95.velocity_level;
            V excess = _o95.excess;
            const LANES(court_bridge_margins_out) _o96 =
                LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V flat = _o96.margin;
            V tilt = _o96.leaving_margin;
            V rate_slack = _o96.rate_margin;
            const LANES(court_beyond_out) _o97 =
                LANES(court_beyond)(doubt, excess, late, lost, pad);
            doubt = _o97.doubt;
            const LANES(court_bridge_enter_out) _o98 =
                LANES(court_bridge_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o98.t;
            V end = _o98.end;
            M searching = _o98.searching;
            lanes_store(lists->open_arrival + i, arrival);
            lanes_store(lists->open_ceiling + i, ceiling);
            lanes_store(lists->open_certain + i, lanes_select(certain, K(1.0), K(0.0)));
            lanes_store(lists->open_doubt + i, doubt);
            lanes_store(lists->open_flat + i, flat);
            lanes_store(lists->open_latest + i, latest);
            lanes_store(lists->open_searching + i, lanes_select(searching, K(1.0), K(0.0)));
            lanes_store(lists->open_t + i, t);
            lanes_store(lists->open_tilt + i, tilt);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_searching_row + open_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_searching_arrival + open_searching_shots, packed, arrival);
                lanes_pack(lists->open_searching_ceiling + open_searching_shots, packed, ceiling);
                lanes_pack(lists->open_searching_certain + open_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->open_searching_doubt + open_searching_shots, packed, doubt);
                lanes_pack(lists->open_searching_end + open_searching_shots, packed, end);
                lanes_pack(lists->open_searching_extent + open_searching_shots, packed, extent);
                lanes_pack(lists->open_searching_flat + open_searching_shots, packed, flat);
                lanes_pack(lists->open_searching_high0 + open_searching_shots, packed, high0);
                lanes_pack(lists->open_searching_high1 + open_searching_shots, packed, high1);
                lanes_pack(lists->open_searching_last + open_searching_shots, packed, last);
                lanes_pack(lists->open_searching_latest + open_searching_shots, packed, latest);
                lanes_pack(lists->open_searching_low0 + open_searching_shots, packed, low0);
                lanes_pack(lists->open_searching_low1 + open_searching_shots, packed, low1);
                if (varying)
                    lanes_pack(lists->open_searching_p_ball_radius + open_searching_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_searching_p_board_distance + open_searching_shots, packed, p_board_distance);
                if (varying)
                    lanes_pack(lists->open_searching_p_bridge_depth + open_searching_shots, packed, p_bridge_depth);
                if (varying)
                    lanes_pack(lists->open_searching_p_bridge_half_width + open_searching_shots, packed, p_bridge_half_width);
                if (varying)
                    lanes_pack(lists->open_searching_p_gravity + open_searching_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->open_searching_p_ring_radius + open_searching_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->open_searching_p_wire_radius + open_searching_shots, packed, p_wire_radius);
                lanes_pack(lists->open_searching_position_error + open_searching_shots, packed, position_error);
                lanes_pack(lists->open_searching_rate_slack + open_searching_shots, packed, rate_slack);
                lanes_pack(lists->open_searching_share + open_searching_shots, packed, share);
                lanes_pack(lists->open_searching_speed + open_searching_shots, packed, speed);
                lanes_pack(lists->open_searching_t + open_searching_shots, packed, t);
                lanes_pack(lists->open_searching_tilt + open_searching_shots, packed, tilt);
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
                if (taken < open_searching_shots && busy + LANES_SPARE <= LANES_WIDTH) {
                    const M idle = lanes_not(active);
                    row = lanes_expand(lists->open_searching_row + taken, idle, row);
                    turns = lanes_select(idle, K(0.0), turns);
                    arrival = lanes_expand(lists->open_searching_arrival + taken, idle, arrival);
                    ceiling = lanes_expand(lists->open_searching_ceiling + taken, idle, ceiling);
                    certain = lanes_less(K(0.0), lanes_expand(lists->open_searching_certain + taken, idle, lanes_select(certain, K(1.0), K(0.0))));
                    doubt = lanes_expand(lists->open_searching_doubt + taken, idle, doubt);
                    end = lanes_expand(lists->open_searching_end + taken, idle, end);
                    extent = lanes_expand(lists->open_searching_extent + taken, idle, extent);
                    flat = lanes_expand(lists->open_searching_flat + taken, idle, flat);
                    high0 = lanes_expand(lists->open_searching_high0 + taken, idle, high0);
                    high1 = lanes_expand(lists->open_searching_high1 + taken, idle, high1);
                    last = lanes_expand(lists->open_searching_last + taken, idle, last);
                    latest = lanes_expand(lists->open_searching_latest + taken, idle, latest);
                    low0 = lanes_expand(lists->open_searching_low0 + taken, idle, low0);
                    low1 = lanes_expand(lists->open_searching_low1 + taken, idle, low1);
                    position_error = lanes_expand(lists->open_searching_position_error + taken, idle, position_error);
                    rate_slack = lanes_expand(lists->open_searching_rate_slack + taken, idle, rate_slack);
                    share = lanes_expand(lists->open_searching_share + taken, idle, share);
                    speed = lanes_expand(lists->open_searching_speed + taken, idle, speed);
                    t = lanes_expand(lists->open_searching_t + taken, idle, t);
                    tilt = lanes_expand(lists->open_searching_tilt + taken, idle, tilt);
                    velocity_error = lanes_expand(lists->open_searching_velocity_error + taken, idle, velocity_error);
                    vx = lanes_expand(lists->open_searching_vx + taken, idle, vx);
                    vy = lanes_expand(lists->open_searching_vy + taken, idle, vy);
                    vz = lanes_expand(lists->open_searching_vz + taken, idle, vz);
                    x = lanes_expand(lists->open_searching_x + taken, idle, x);
                    y = lanes_expand(lists->open_searching_y + taken, idle, y);
                    z = lanes_expand(lists->open_searching_z + taken, idle, z);
                    if (varying) {
                        p_ball_radius = lanes_expand(lists->open_searching_p_ball_radius + taken, idle, p_ball_radius);
                        p_board_distance = lanes_expand(lists->open_searching_p_board_distance + taken, idle, p_board_distance);
                        p_bridge_depth = lanes_expand(lists->open_searching_p_bridge_depth + taken, idle, p_bridge_depth);
                        p_bridge_half_width = lanes_expand(lists->open_searching_p_bridge_half_width + taken, idle, p_bridge_half_width);
                        p_gravity = lanes_expand(lists->open_searching_p_gravity + taken, idle, p_gravity);
                        p_ring_radius = lanes_expand(lists->open_searching_p_ring_radius + taken, idle, p_ring_radius);
                        p_wire_radius = lanes_expand(lists->open_searching_p_wire_radius + taken, idle, p_wire_radius);
                    }
                    const size_t room = LANES_WIDTH - busy, left = open_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(court_nearby_out) _o99 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o99.leaving;
                V margin = _o99.margin;
                const LANES(court_bridge_advance_out) _o100 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V gap = _o100.gap;
                V rate = _o100.rate;
                V bend = _o100.bend;
                V step = _o100.step;
                V next = _o100.next;
                V root = _o100.root;
                V clearance = _o100.clearance;
                const LANES(court_struck_out) _o101 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o101.hit;
                M sure = _o101.sure;
                M vague = _o101.vague;
                const M _m102 = lanes_both(active, vague);
                if (lanes_any(_m102)) {
                    const LANES(court_finer_out) _o103 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m102, _o103.share, share);
                    const LANES(court_allowance_out) _o104 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o104.position_level;
                    V velocity_level = _o104.velocity_level;
                    V excess = _o104.excess;
                    const LANES(court_bridge_margins_out) _o105 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                    flat = lanes_select(_m102, _o105.margin, flat);
                    tilt = lanes_select(_m102, _o105.leaving_margin, tilt);
                    rate_slack = lanes_select(_m102, _o105.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o106 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m102, _o106.doubt, doubt);
                }
                const LANES(court_advanced_out) _o107 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, root, step, sure, t, vague);
                arrival = _o107.arrival;
                certain = _o107.certain;
                M exhausted = _o107.exhausted;
                searching = _o107.searching;
                t = _o107.t;
                const M _m108 = lanes_both(active, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o109 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m108, _o109.t, t);
                    end = lanes_select(_m108, _o109.end, end);
                    searching = lanes_choose(_m108, _o109.searching, searching);
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
                        lists->open_arrival[k] = ended_arrival[lane];
                        lists->open_certain[k] = ended_certain[lane];
                        lists->open_doubt[k] = ended_doubt[lane];
                        lists->open_flat[k] = ended_flat[lane];
                        lists->open_searching[k] = ended_searching[lane];
                        lists->open_t[k] = ended_t[lane];
                        lists->open_tilt[k] = ended_tilt[lane];
                    }
                    busy -= lanes_many(ended);
                    active = lanes_both(active, lanes_not(ended));
                }
            }
        }
        }
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            V arrival = lanes_load(lists->open_arrival + i);
            V ceiling = lanes_load(lists->open_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_certain + i));
            V doubt = lanes_load(lists->open_doubt + i);
            V extent = lanes_load(lists->open_extent + i);
            V flat = lanes_load(lists->open_flat + i);
            V last = lanes_load(lists->open_last + i);
            V late = lanes_load(lists->open_late + i);
            V latest = lanes_load(lists->open_latest + i);
            const V p_ball_radius = lanes_load(varying ? lists->open_p_ball_radius + i : lists->p_ball_radius);
            const V p_board_distance = lanes_load(varying ? lists->open_p_board_distance + i : lists->p_board_distance);
            const V p_bridge_depth = lanes_load(varying ? lists->open_p_bridge_depth + i : lists->p_bridge_depth);
            const V p_bridge_half_width = lanes_load(varying ? lists->open_p_bridge_half_width + i : lists->p_bridge_half_width);
            const V p_gravity = lanes_load(varying ? lists->open_p_gravity + i : lists->p_gravity);
            const V p_ring_radius = lanes_load(varying ? lists->open_p_ring_radius + i : lists->p_ring_radius);
            const V p_wire_radius = lanes_load(varying ? lists->open_p_wire_radius + i : lists->p_wire_radius);
            V position_error = lanes_load(lists->open_position_error + i);
            M searching = lanes_less(K(0.0), lanes_load(lists->open_searching + i));
            V speed = lanes_load(lists->open_speed + i);
            V t = lanes_load(lists->open_t + i);
            V tilt = lanes_load(lists->open_tilt + i);
            V velocity_error = lanes_load(lists->open_velocity_error + i);
            V vx = lanes_load(lists->open_vx + i);
            V vy = lanes_load(lists->open_vy + i);
            V vz = lanes_load(lists->open_vz + i);
            V when = lanes_load(lists->open_when + i);
            V which = lanes_load(lists->open_which + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(court_questioned_out) _o110 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o110.doubt;
            const LANES(court_found_out) _o111 =
                LANES(court_found)(arrival);
            M arrives = _o111.arrives;
            const LANES(court_nearby_out) _o112 =
                LANES(court_nearby)(flat, K(2.0), last, arrival, tilt);
            V leaving = _o112.leaving;
            const LANES(court_bridge_refine_out) _o113 =
                LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V refined = _o113.time;
            const LANES(court_polished_out) _o114 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o114.arrival;
            const LANES(court_bridge_refine_out) _o115 =
                LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            refined = _o115.time;
            V rate = _o115.rate;
            const LANES(court_polished_out) _o116 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o116.arrival;
            const LANES(court_bridge_margins_out) _o117 =
                LANES(court_bridge_margins)(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            flat = _o117.margin;
            tilt = _o117.leaving_margin;
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
                LANES(court_sooner)(arrives, K(2.0), time, when, which);
            when = _o123.when;
            which = _o123.which;
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
            const M _m124 = lanes_both(rows, limited);
            if (lanes_any(_m124)) {
                const LANES(court_expiry_out) _o125 =
                    LANES(court_expiry)(clock, doubt, late, time_error, time_limit, when, which);
                V time = _o125.time;
                V delay = _o125.delay;
                M arrives = _o125.arrives;
                doubt = lanes_select(_m124, _o125.doubt, doubt);
                const LANES(court_tied_out) _o126 =
                    LANES(court_tied)(arrives, delay, doubt, late, time, when);
                doubt = lanes_select(_m124, _o126.doubt, doubt);
                late = lanes_select(_m124, _o126.late, late);
                const LANES(court_sooner_out) _o127 =
                    LANES(court_sooner)(arrives, K(4.0), time, when, which);
                when = lanes_select(_m124, _o127.when, when);
                which = lanes_select(_m124, _o127.which, which);
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
            V position_claim = lanes_load(lists->position_claim + i);
            V position_error = lanes_load(lists->position_error + i);
            M rests = lanes_less(K(0.0), lanes_load(lists->rests + i));
            M rolling = lanes_less(K(0.0), lanes_load(lists->rolling + i));
            V rolls = lanes_load(lists->rolls + i);
            V slip_left = lanes_load(lists->slip_left + i);
            V speed = lanes_load(lists->speed + i);
            V spin_claim = lanes_load(lists->spin_claim + i);
            V through = lanes_load(lists->through + i);
            V time_claim = lanes_load(lists->time_claim + i);
            V uncertain = lanes_load(lists->uncertain + i);
            V velocity_claim = lanes_load(lists->velocity_claim + i);
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
            const LANES(court_departed_out) _o409 =
                LANES(court_departed)(K(3.0), which);
            M moves = _o409.moves;
            M ends = _o409.ends;
            M touches = _o409.touches;
            V reached = _o409.reached;
            M edge = _o409.edge;
            const LANES(court_body_of_out) _o410 =
                LANES(court_body_of)(which);
            V body = _o410.body;
            const M _m411 = lanes_both(rows, moves);
            if (lanes_any(_m411)) {
                const LANES(court_passing_doubt_out) _o412 =
                    LANES(court_passing_doubt)(when, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ring_radius, p_gravity);
                M unsure = _o412.unsure;
                const LANES(court_undecided_out) _o413 =
                    LANES(court_undecided)(uncertain, unsure);
                uncertain = lanes_select(_m411, _o413.uncertain, uncertain);
                const LANES(court_passing_out) _o414 =
                    LANES(court_passing)(through, when, x, y, z, vx, vy, vz, p_ring_radius, p_gravity);
                through = lanes_select(_m411, _o414.through, through);
                const LANES(court_flight_out) _o415 =
                    LANES(court_flight)(when, x, y, z, vx, vy, vz, p_gravity);
                x = lanes_select(_m411, _o415.x, x);
                y = lanes_select(_m411, _o415.y, y);
                z = lanes_select(_m411, _o415.z, z);
                vx = lanes_select(_m411, _o415.vx, vx);
                vy = lanes_select(_m411, _o415.vy, vy);
                vz = lanes_select(_m411, _o415.vz, vz);
                const LANES(court_ticked_out) _o416 =
                    LANES(court_ticked)(clock, when);
                clock = lanes_select(_m411, _o416.clock, clock);
            }
            const M _m417 = lanes_both(rows, limited);
            if (lanes_any(_m417)) {
                const LANES(court_expired_out) _o418 =
                    LANES(court_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m417, _o418.clock, clock);
                body = lanes_select(_m417, _o418.body, body);
                reached = lanes_select(_m417, _o418.reached, reached);
                ends = lanes_choose(_m417, _o418.ends, ends);
            }
            const LANES(court_unhopped_out) _o419 =
                LANES(court_unhopped)();
            M hopped = _o419.hopped;
            const M _m420 = lanes_both(rows, kept);
            if (lanes_any(_m420)) {
                const LANES(court_kept_on_out) _o421 =
                    LANES(court_kept_on)(began, body, clock, doubt, ends, held, last, reached, rests, rolling, rolls, which);
                body = lanes_select(_m420, _o421.body, body);
                reached = lanes_select(_m420, _o421.reached, reached);
                doubt = lanes_select(_m420, _o421.doubt, doubt);
                ends = lanes_choose(_m420, _o421.ends, ends);
                hopped = lanes_choose(_m420, _o421.hopped, hopped);
                last = lanes_select(_m420, _o421.last, last);
                mode = lanes_select(_m420, _o421.mode, mode);
                held = lanes_select(_m420, _o421.held, held);
                rolls = lanes_select(_m420, _o421.rolls, rolls);
            }
            const LANES(court_displacement_out) _o422 =
                LANES(court_displacement)(late, when, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_gravity, p_end_depth);
            V slack = _o422.margin;
            const LANES(court_here_out) _o423 =
                LANES(court_here)(K(3.0), which);
            M here = _o423.here;
            const M _m424 = lanes_both(rows, here);
            {
                const LANES(court_end_bounds_out) _o425 =
                    LANES(court_end_bounds)(x, y, p_ring_radius);
                V g0 = _o425.g0;
                const LANES(court_end_reached_out) _o426 =
                    LANES(court_end_reached)(g0, through);
                reached = lanes_select(_m424, _o426.reached, reached);
                const LANES(court_end_edge_out) _o427 =
                    LANES(court_end_edge)(g0, slack, through);
                edge = lanes_choose(_m424, _o427.edge, edge);
            }
            const LANES(court_doubted_in_contact_out) _o428 =
                LANES(court_doubted_in_contact)(assured, doubt, edge, last, late, uncertain, when, which);
            uncertain = _o428.uncertain;
            const LANES(court_accounted_out) _o429 =
                LANES(court_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o429.contacts;
            V outcome = _o429.outcome;
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
            const LANES(court_meeting_out) _o430 =
                LANES(court_meeting)(claims, ends, touches);
            M meeting = _o430.meeting;
            const M _m431 = lanes_both(rows, meeting);
            if (lanes_any(_m431)) {
                const LANES(court_end_normal_out) _o432 =
                    LANES(court_end_normal)();
                V nx = _o432.nx;
                V ny = _o432.ny;
                V nz = _o432.nz;
                const LANES(court_here_out) _o433 =
                    LANES(court_here)(K(0.0), which);
                M here = _o433.here;
                const M _m434 = lanes_both(_m431, here);
                {
                    const LANES(court_ring_normal_out) _o435 =
                        LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m434, _o435.nx, nx);
                    ny = lanes_select(_m434, _o435.ny, ny);
                    nz = lanes_select(_m434, _o435.nz, nz);
                    const LANES(court_counted_out) _o436 =
                        LANES(court_counted)(count_0);
                    count_0 = lanes_select(_m434, _o436.count, count_0);
                }
                const LANES(court_here_out) _o437 =
                    LANES(court_here)(K(1.0), which);
                here = _o437.here;
                const M _m438 = lanes_both(_m431, here);
                {
                    const LANES(court_backboard_normal_out) _o439 =
                        LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m438, _o439.nx, nx);
                    ny = lanes_select(_m438, _o439.ny, ny);
                    nz = lanes_select(_m438, _o439.nz, nz);
                    const LANES(court_counted_out) _o440 =
                        LANES(court_counted)(count_1);
                    count_1 = lanes_select(_m438, _o440.count, count_1);
                }
                const LANES(court_here_out) _o441 =
                    LANES(court_here)(K(2.0), which);
                here = _o441.here;
                const M _m442 = lanes_both(_m431, here);
                {
                    const LANES(court_bridge_normal_out) _o443 =
                        LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m442, _o443.nx, nx);
                    ny = lanes_select(_m442, _o443.ny, ny);
                    nz = lanes_select(_m442, _o443.nz, nz);
                    const LANES(court_counted_out) _o444 =
                        LANES(court_counted)(count_2);
                    count_2 = lanes_select(_m442, _o444.count, count_2);
                }
                const LANES(court_elsewhere_out) _o445 =
                    LANES(court_elsewhere)();
                V curving = _o445.curving;
                const LANES(court_anew_out) _o446 =
                    LANES(court_anew)();
                V left_nx = _o446.left_nx;
                V left_ny = _o446.left_ny;
                V left_nz = _o446.left_nz;
                const LANES(court_again_out) _o447 =
                    LANES(court_again)(K(0.0), last, which);
                M again = _o447.again;
                const M _m448 = lanes_both(_m431, again);
                if (lanes_any(_m448)) {
                    const LANES(court_ring_curvature_out) _o449 =
                        LANES(court_ring_curvature)(p_ball_radius, p_ring_radius, p_wire_radius);
                    curving = lanes_select(_m448, _o449.curvature, curving);
                    const LANES(court_started_out) _o450 =
                        LANES(court_started)(p_gravity, when, vx, vy, vz, x, y, z);
                    V from_x = _o450.from_x;
                    V from_y = _o450.from_y;
                    V from_z = _o450.from_z;
                    const LANES(court_ring_normal_out) _o451 =
                        LANES(court_ring_normal)(from_x, from_y, from_z, p_ball_radius, p_ring_radius, p_wire_radius);
                    left_nx = lanes_select(_m448, _o451.nx, left_nx);
                    left_ny = lanes_select(_m448, _o451.ny, left_ny);
                    left_nz = lanes_select(_m448, _o451.nz, left_nz);
                }
                const LANES(court_again_out) _o452 =
                    LANES(court_again)(K(1.0), last, which);
                again = _o452.again;
                const M _m453 = lanes_both(_m431, again);
                if (lanes_any(_m453)) {
                    const LANES(court_backboard_curvature_out) _o454 =
                        LANES(court_backboard_curvature)(p_ball_radius);
                    curving = lanes_select(_m453, _o454.curvature, curving);
                    const LANES(court_started_out) _o455 =
                        LANES(court_started)(p_gravity, when, vx, vy, vz, x, y, z);
                    V from_x = _o455.from_x;
                    V from_y = _o455.from_y;
                    V from_z = _o455.from_z;
                    const LANES(court_backboard_normal_out) _o456 =
                        LANES(court_backboard_normal)(from_x, from_y, from_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    left_nx = lanes_select(_m453, _o456.nx, left_nx);
                    left_ny = lanes_select(_m453, _o456.ny, left_ny);
                    left_nz = lanes_select(_m453, _o456.nz, left_nz);
                }
                const LANES(court_again_out) _o457 =
                    LANES(court_again)(K(2.0), last, which);
                again = _o457.again;
                const M _m458 = lanes_both(_m431, again);
                if (lanes_any(_m458)) {
                    const LANES(court_bridge_curvature_out) _o459 =
                        LANES(court_bridge_curvature)(p_ball_radius);
                    curving = lanes_select(_m458, _o459.curvature, curving);
                    const LANES(court_started_out) _o460 =
                        LANES(court_started)(p_gravity, when, vx, vy, vz, x, y, z);
                    V from_x = _o460.from_x;
                    V from_y = _o460.from_y;
                    V from_z = _o460.from_z;
                    const LANES(court_bridge_normal_out) _o461 =
                        LANES(court_bridge_normal)(from_x, from_y, from_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    left_nx = lanes_select(_m458, _o461.nx, left_nx);
                    left_ny = lanes_select(_m458, _o461.ny, left_ny);
                    left_nz = lanes_select(_m458, _o461.nz, left_nz);
                }
                const LANES(court_carry_flight_out) _o462 =
                    LANES(court_carry_flight)(when, x, y, z, vx, vy, vz, nx, ny, nz, clock, contacts, late, dx, dy, dz, dvx, dvy, dvz, left_nx, left_ny, left_nz, curving, p_gravity);
                dx = lanes_select(_m431, _o462.dx, dx);
                dy = lanes_select(_m431, _o462.dy, dy);
                dz = lanes_select(_m431, _o462.dz, dz);
                V lifting = _o462.lifting;
                dvx = lanes_select(_m431, _o462.dvx, dvx);
                dvy = lanes_select(_m431, _o462.dvy, dvy);
                dvz = lanes_select(_m431, _o462.dvz, dvz);
                V delay = _o462.delay;
                V shift = _o462.shift;
                const LANES(court_delayed_out) _o463 =
                    LANES(court_delayed)(clock_error, delay);
                clock_error = lanes_select(_m431, _o463.clock_error, clock_error);
                const M _m464 = lanes_both(_m431, ends);
                {
                    const LANES(court_floored_out) _o465 =
                        LANES(court_floored)(dx, dy, dz, shift);
                    dx = lanes_select(_m464, _o465.dx, dx);
                    dy = lanes_select(_m464, _o465.dy, dy);
                    dz = lanes_select(_m464, _o465.dz, dz);
                }
                const LANES(court_unturned_out) _o466 =
                    LANES(court_unturned)();
                V dnx = _o466.dnx;
                V dny = _o466.dny;
                V dnz = _o466.dnz;
                V turn = _o466.turn;
                const LANES(court_here_out) _o467 =
                    LANES(court_here)(K(0.0), which);
                here = _o467.here;
                const M _m468 = lanes_both(_m431, here);
                if (lanes_any(_m468)) {
                    const LANES(court_ring_carry_normal_out) _o469 =
                        LANES(court_ring_carry_normal)(x, y, dx, dy, dz, shift, p_ball_radius, p_ring_radius, p_wire_radius);
                    dnx = lanes_select(_m468, _o469.dnx, dnx);
                    dny = lanes_select(_m468, _o469.dny, dny);
                    dnz = lanes_select(_m468, _o469.dnz, dnz);
                    turn = lanes_select(_m468, _o469.turn, turn);
                }
                const LANES(court_here_out) _o470 =
                    LANES(court_here)(K(1.0), which);
                here = _o470.here;
                const M _m471 = lanes_both(_m431, here);
                {
                    const LANES(court_backboard_carry_normal_out) _o472 =
                        LANES(court_backboard_carry_normal)(x, y, z, dx, dy, dz, shift, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    dnx = lanes_select(_m471, _o472.dnx, dnx);
                    dny = lanes_select(_m471, _o472.dny, dny);
                    dnz = lanes_select(_m471, _o472.dnz, dnz);
                    turn = lanes_select(_m471, _o472.turn, turn);
                }
                const LANES(court_here_out) _o473 =
                    LANES(court_here)(K(2.0), which);
                here = _o473.here;
                const M _m474 = lanes_both(_m431, here);
                {
                    const LANES(court_bridge_carry_normal_out) _o475 =
                        LANES(court_bridge_carry_normal)(x, y, z, dx, dy, dz, shift, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    dnx = lanes_select(_m474, _o475.dnx, dnx);
                    dny = lanes_select(_m474, _o475.dny, dny);
                    dnz = lanes_select(_m474, _o475.dnz, dnz);
                    turn = lanes_select(_m474, _o475.turn, turn);
                }
                const LANES(court_untaken_out) _o476 =
                    LANES(court_untaken)();
                M struck_0 = _o476.mine;
                const LANES(court_ring_impact_taken_out) _o477 =
                    LANES(court_ring_impact_taken)(p_ring_restitution, p_ring_friction);
                V its_0_ring_impact = _o477.its_0;
                V its_1_ring_impact = _o477.its_1;
                {
                    const double *const _t479[][2] = {
                        {lists->p_ring_friction, lists->p_ring_restitution},
                        {lists->p_backboard_friction, lists->p_backboard_restitution},
                        {lists->p_bridge_friction, lists->p_bridge_restitution},
                    };
                    static const double _t480[][1] = {
                        {0.0},
                        {1.0},
                        {2.0},
                    };
                    for (size_t _k478 = 0; _k478 < 3; _k478++) {
                        const V own_1 = lanes_load(_t479[_k478][0] + (i & varying));
                        const V own_2 = lanes_load(_t479[_k478][1] + (i & varying));
                        const V own_index = K(_t480[_k478][0]);
                        const LANES(court_here_out) _o481 =
                            LANES(court_here)(own_index, which);
                        M here = _o481.here;
                        const M _m482 = lanes_both(_m431, here);
                        if (lanes_any(_m482)) {
                            const LANES(court_ring_impact_taken_out) _o483 =
                                LANES(court_ring_impact_taken)(own_2, own_1);
                            struck_0 = lanes_choose(_m482, _o483.mine, struck_0);
                            its_0_ring_impact = lanes_select(_m482, _o483.its_0, its_0_ring_impact);
                            its_1_ring_impact = lanes_select(_m482, _o483.its_1, its_1_ring_impact);
                        }
                    }
                }
                const M _m484 = lanes_both(_m431, struck_0);
                if (lanes_any(_m484)) {
                    const LANES(court_ring_impact_doubt_out) _o485 =
                        LANES(court_ring_impact_doubt)(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, turn, p_ball_radius, its_0_ring_impact, its_1_ring_impact, p_tangential_restitution, p_restitution_speed);
                    M unsure = _o485.unsure;
                    const LANES(court_undecided_out) _o486 =
                        LANES(court_undecided)(uncertain, unsure);
                    uncertain = lanes_select(_m484, _o486.uncertain, uncertain);
                    const LANES(court_carry_ring_impact_out) _o487 =
                        LANES(court_carry_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, dnx, dny, dnz, turn, lifting, p_ball_radius, its_0_ring_impact, its_1_ring_impact, p_tangential_restitution, p_restitution_speed);
                    dvx = lanes_select(_m484, _o487.dvx, dvx);
                    dvy = lanes_select(_m484, _o487.dvy, dvy);
                    dvz = lanes_select(_m484, _o487.dvz, dvz);
                    dwx = lanes_select(_m484, _o487.dwx, dwx);
                    dwy = lanes_select(_m484, _o487.dwy, dwy);
                    dwz = lanes_select(_m484, _o487.dwz, dwz);
                    const LANES(court_ring_impact_out) _o488 =
                        LANES(court_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, its_0_ring_impact, its_1_ring_impact, p_tangential_restitution, p_restitution_speed);
                    vx = lanes_select(_m484, _o488.vx, vx);
                    vy = lanes_select(_m484, _o488.vy, vy);
                    vz = lanes_select(_m484, _o488.vz, vz);
                    wx = lanes_select(_m484, _o488.wx, wx);
                    wy = lanes_select(_m484, _o488.wy, wy);
                    wz = lanes_select(_m484, _o488.wz, wz);
                }
                const M _m489 = lanes_both(_m431, touches);
                {
                    const LANES(court_touched_out) _o490 =
                        LANES(court_touched)(body, first, which);
                    first = lanes_select(_m489, _o490.first, first);
                    last = lanes_select(_m489, _o490.last, last);
                }
                const M _m491 = lanes_both(_m431, touches);
                if (lanes_any(_m491)) {
                    const LANES(court_slowed_out) _o492 =
                        LANES(court_slowed)(p_ball_radius, p_gravity, nx, ny, nz, position_error, vx, vy, vz);
                    M slow = _o492.slow;
                    M nearly = _o492.nearly;
                    assured = lanes_select(_m491, _o492.assured, assured);
                    const M _m493 = lanes_both(_m491, slow);
                    if (lanes_any(_m493)) {
                        const LANES(court_gripped_out) _o494 =
                            LANES(court_gripped)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
                        V rolled_x = _o494.rolled_x;
                        V rolled_y = _o494.rolled_y;
                        V rolled_z = _o494.rolled_z;
                        V slip = _o494.slip;
                        V bounce = _o494.bounce;
                        const LANES(court_here_out) _o495 =
                            LANES(court_here)(K(0.0), which);
                        M here = _o495.here;
                        const M _m496 = lanes_both(_m493, here);
                        if (lanes_any(_m496)) {
                            const LANES(court_ring_turning_out) _o497 =
                                LANES(court_ring_turning)(p_ball_radius, p_ring_radius, rolled_x, rolled_y, rolled_z, p_wire_radius, x, y);
                            V turning_x = _o497.turning_x;
                            V turning_y = _o497.turning_y;
                            V turning_z = _o497.turning_z;
                            const LANES(court_pressed_on_out) _o498 =
                                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
                            V press = _o498.press;
                            V weight = _o498.weight;
                            V drag = _o498.drag;
                            V thrust_x = _o498.thrust_x;
                            V thrust_y = _o498.thrust_y;
                            V thrust_z = _o498.thrust_z;
                            const LANES(court_alone_out) _o499 =
                                LANES(court_alone)();
                            V nearest = _o499.nearest;
                            V wedge = _o499.wedge;
                            const LANES(court_backboard_closing_out) _o500 =
                                LANES(court_backboard_closing)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z);
                            V gap = _o500.gap;
                            V nearing = _o500.nearing;
                            V swerve = _o500.swerve;
                            V facing = _o500.facing;
                            const LANES(court_neared_body_out) _o501 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o501.nearest;
                            wedge = _o501.wedge;
                            const LANES(court_bridge_closing_out) _o502 =
                                LANES(court_bridge_closing)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
                            gap = _o502.gap;
                            nearing = _o502.nearing;
                            swerve = _o502.swerve;
                            facing = _o502.facing;
                            const LANES(court_neared_body_out) _o503 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o503.nearest;
                            wedge = _o503.wedge;
                            const LANES(court_end_beside_out) _o504 =
                                LANES(court_end_beside)(p_end_depth, vz, z);
                            gap = _o504.gap;
                            const LANES(court_neared_out) _o505 =
                                LANES(court_neared)(gap, nearest);
                            nearest = _o505.nearest;
                            const LANES(court_ring_parting_out) _o506 =
                                LANES(court_ring_parting)(p_gravity, p_ring_radius, vx, vy, vz, x, y, z);
                            V lift = _o506.lift;
                            const LANES(court_ring_impact_settling_out) _o507 =
                                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_ring_friction, p_ring_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz);
                            M settles = _o507.settles;
                            M lodges = _o507.lodges;
                            M slides = _o507.slides;
                            M parts = _o507.parts;
                            assured = lanes_select(_m496, _o507.assured, assured);
                            M unsure = _o507.unsure;
                            const LANES(court_settled_out) _o508 =
                                LANES(court_settled)(K(0.0), lodges, nearly, outcome, parts, settles, slides, uncertain, unsure);
                            mode = lanes_select(_m496, _o508.mode, mode);
                            held = lanes_select(_m496, _o508.held, held);
                            outcome = lanes_select(_m496, _o508.outcome, outcome);
                            slip_left = lanes_select(_m496, _o508.slip_left, slip_left);
                            uncertain = lanes_select(_m496, _o508.uncertain, uncertain);
                        }
                        const LANES(court_here_out) _o509 =
                            LANES(court_here)(K(1.0), which);
                        here = _o509.here;
                        const M _m510 = lanes_both(_m493, here);
                        if (lanes_any(_m510)) {
                            const LANES(court_backboard_turning_out) _o511 =
                                LANES(court_backboard_turning)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, rolled_x, rolled_y, rolled_z, x, y, z);
                            V turning_x = _o511.turning_x;
                            V turning_y = _o511.turning_y;
                            V turning_z = _o511.turning_z;
                            const LANES(court_pressed_on_out) _o512 =
                                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
                            V press = _o512.press;
                            V weight = _o512.weight;
                            V drag = _o512.drag;
                            V thrust_x = _o512.thrust_x;
                            V thrust_y = _o512.thrust_y;
                            V thrust_z = _o512.thrust_z;
                            const LANES(court_alone_out) _o513 =
                                LANES(court_alone)();
                            V nearest = _o513.nearest;
                            V wedge = _o513.wedge;
                            const LANES(court_ring_closing_out) _o514 =
                                LANES(court_ring_closing)(p_ball_radius, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
                            V gap = _o514.gap;
                            V nearing = _o514.nearing;
                            V swerve = _o514.swerve;
                            V facing = _o514.facing;
                            const LANES(court_neared_body_out) _o515 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o515.nearest;
                            wedge = _o515.wedge;
                            const LANES(court_bridge_closing_out) _o516 =
                                LANES(court_bridge_closing)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
                            gap = _o516.gap;
                            nearing = _o516.nearing;
                            swerve = _o516.swerve;
                            facing = _o516.facing;
                            const LANES(court_neared_body_out) _o517 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o517.nearest;
                            wedge = _o517.wedge;
                            const LANES(court_end_beside_out) _o518 =
                                LANES(court_end_beside)(p_end_depth, vz, z);
                            gap = _o518.gap;
                            const LANES(court_neared_out) _o519 =
                                LANES(court_neared)(gap, nearest);
                            nearest = _o519.nearest;
                            const LANES(court_backboard_parting_out) _o520 =
                                LANES(court_backboard_parting)(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, vx, vy, vz, x, y, z);
                            V lift = _o520.lift;
                            const LANES(court_ring_impact_settling_out) _o521 =
                                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_backboard_friction, p_backboard_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz);
                            M settles = _o521.settles;
                            M lodges = _o521.lodges;
                            M slides = _o521.slides;
                            M parts = _o521.parts;
                            assured = lanes_select(_m510, _o521.assured, assured);
                            M unsure = _o521.unsure;
                            const LANES(court_settled_out) _o522 =
                                LANES(court_settled)(K(1.0), lodges, nearly, outcome, parts, settles, slides, uncertain, unsure);
                            mode = lanes_select(_m510, _o522.mode, mode);
                            held = lanes_select(_m510, _o522.held, held);
                            outcome = lanes_select(_m510, _o522.outcome, outcome);
                            slip_left = lanes_select(_m510, _o522.slip_left, slip_left);
                            uncertain = lanes_select(_m510, _o522.uncertain, uncertain);
                        }
                        const LANES(court_here_out) _o523 =
                            LANES(court_here)(K(2.0), which);
                        here = _o523.here;
                        const M _m524 = lanes_both(_m493, here);
                        if (lanes_any(_m524)) {
                            const LANES(court_bridge_turning_out) _o525 =
                                LANES(court_bridge_turning)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, rolled_x, rolled_y, rolled_z, p_wire_radius, x, y, z);
                            V turning_x = _o525.turning_x;
                            V turning_y = _o525.turning_y;
                            V turning_z = _o525.turning_z;
                            const LANES(court_pressed_on_out) _o526 =
                                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
                            V press = _o526.press;
                            V weight = _o526.weight;
                            V drag = _o526.drag;
                            V thrust_x = _o526.thrust_x;
                            V thrust_y = _o526.thrust_y;
                            V thrust_z = _o526.thrust_z;
                            const LANES(court_alone_out) _o527 =
                                LANES(court_alone)();
                            V nearest = _o527.nearest;
                            V wedge = _o527.wedge;
                            const LANES(court_ring_closing_out) _o528 =
                                LANES(court_ring_closing)(p_ball_radius, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
                            V gap = _o528.gap;
                            V nearing = _o528.nearing;
                            V swerve = _o528.swerve;
                            V facing = _o528.facing;
                            const LANES(court_neared_body_out) _o529 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o529.nearest;
                            wedge = _o529.wedge;
                            const LANES(court_backboard_closing_out) _o530 =
                                LANES(court_backboard_closing)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z);
                            gap = _o530.gap;
                            nearing = _o530.nearing;
                            swerve = _o530.swerve;
                            facing = _o530.facing;
                            const LANES(court_neared_body_out) _o531 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o531.nearest;
                            wedge = _o531.wedge;
                            const LANES(court_end_beside_out) _o532 =
                                LANES(court_end_beside)(p_end_depth, vz, z);
                            gap = _o532.gap;
                            const LANES(court_neared_out) _o533 =
                                LANES(court_neared)(gap, nearest);
                            nearest = _o533.nearest;
                            const LANES(court_bridge_parting_out) _o534 =
                                LANES(court_bridge_parting)(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                            V lift = _o534.lift;
                            const LANES(court_ring_impact_settling_out) _o535 =
                                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_bridge_friction, p_bridge_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz);
                            M settles = _o535.settles;
                            M lodges = _o535.lodges;
                            M slides = _o535.slides;
                            M parts = _o535.parts;
                            assured = lanes_select(_m524, _o535.assured, assured);
                            M unsure = _o535.unsure;
                            const LANES(court_settled_out) _o536 =
                                LANES(court_settled)(K(2.0), lodges, nearly, outcome, parts, settles, slides, uncertain, unsure);
                            mode = lanes_select(_m524, _o536.mode, mode);
                            held = lanes_select(_m524, _o536.held, held);
                            outcome = lanes_select(_m524, _o536.outcome, outcome);
                            slip_left = lanes_select(_m524, _o536.slip_left, slip_left);
                            uncertain = lanes_select(_m524, _o536.uncertain, uncertain);
                        }
                    }
                }
            }
            const M _m537 = lanes_both(rows, limited);
            if (lanes_any(_m537)) {
                const LANES(court_timed_out) _o538 =
                    LANES(court_timed)(claims, K(4.0), which);
                M timed = _o538.timed;
                const M _m539 = lanes_both(_m537, timed);
                if (lanes_any(_m539)) {
                    const LANES(court_carry_time_out) _o540 =
                        LANES(court_carry_time)(when, x, y, z, vx, vy, vz, clock, clock_error, dx, dy, dz, dvx, dvy, dvz, p_gravity);
                    dx = lanes_select(_m539, _o540.dx, dx);
                    dy = lanes_select(_m539, _o540.dy, dy);
                    dz = lanes_select(_m539, _o540.dz, dz);
                    dvx = lanes_select(_m539, _o540.dvx, dvx);
                    dvy = lanes_select(_m539, _o540.dvy, dvy);
                    dvz = lanes_select(_m539, _o540.dvz, dvz);
                    clock_error = lanes_select(_m539, _o540.clock_error, clock_error);
                }
            }
            const M _m541 = lanes_both(rows, hopped);
            if (lanes_any(_m541)) {
                const LANES(court_carry_hop_out) _o542 =
                    LANES(court_carry_hop)(dvx, dvy, dvz, dx, dy, dz, vx, vy, vz, when, x, y, z);
                dx = lanes_select(_m541, _o542.dx, dx);
                dy = lanes_select(_m541, _o542.dy, dy);
                dz = lanes_select(_m541, _o542.dz, dz);
            }
            const LANES(court_closing_out) _o543 =
                LANES(court_closing)(claims, outcome);
            M closed = _o543.closed;
            const M _m544 = lanes_both(rows, closed);
            {
                const LANES(court_claimed_errors_out) _o545 =
                    LANES(court_claimed_errors)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
                position_claim = lanes_select(_m544, _o545.position_error, position_claim);
                velocity_claim = lanes_select(_m544, _o545.velocity_error, velocity_claim);
                spin_claim = lanes_select(_m544, _o545.spin_error, spin_claim);
                time_claim = lanes_select(_m544, _o545.time_error, time_claim);
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
            lanes_store(lists->last + i, last);
            lanes_store(lists->mode + i, mode);
            lanes_store(lists->outcome + i, outcome);
            lanes_store(lists->position_claim + i, position_claim);
            lanes_store(lists->rolls + i, rolls);
            lanes_store(lists->slip_left + i, slip_left);
            lanes_store(lists->spin_claim + i, spin_claim);
            lanes_store(lists->through + i, through);
            lanes_store(lists->time_claim + i, time_claim);
            lanes_store(lists->uncertain + i, uncertain);
            lanes_store(lists->velocity_claim + i, velocity_claim);
            lanes_store(lists->vx + i, vx);
            lanes_store(lists->vy + i, vy);
            lanes_store(lists->vz + i, vz);
            lanes_store(lists->wx + i, wx);
            lanes_store(lists->wy + i, wy);
            lanes_store(lists->wz + i, wz);
            lanes_store(lists->x + i, x);
            lanes_store(lists->y + i, y);
            lanes_store(lists->z + i, z);
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
