/* The event loop of the scene court, LANES_WIDTH shots abreast.

   Generated from templates/c/engine.h.j2, scene court, derivation 47d312e35352038d,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Included by court.c once for every width. The shots in flight fill the first rows of the lists;
   when one ends, the last takes its row. Stages go over all rows, and over those of a list of their
   own where only some shots need them. No shot's result depends on its neighbours. */

#include "court_lanes.h"
#include "court_kernels.h"

/* A column, with room for a whole row of lanes behind its end. */
typedef double LANES(court_column)[LANES_SHOTS + LANES_WIDTH];

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
    _Alignas(64) size_t shot[LANES_SHOTS];
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
    LANES(court_column) rolls; /* how many times it began to roll */
    LANES(court_column) slip_left; /* 1: its bounces ended with slip left, which friction cannot stop */
    LANES(court_column) through; /* 1: it has fallen through the ring, -1: it came up through it */
    LANES(court_column) outcome; /* how it ended, -1: in flight */
    LANES(court_column) p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_gravity, p_end_depth, p_ring_restitution, p_backboard_restitution, p_bridge_restitution, p_ring_friction, p_backboard_friction, p_bridge_friction, p_tangential_restitution, p_restitution_speed;
    /* Shots whose balls stay in contact: they wait for one another. */
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
    LANES(court_column) kept_rolling_ring;
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
    const size_t room = LANES_SHOTS - row, shots = lists->waiting < room ? lists->waiting : room;
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
        if (lists->waiting >= LANES_SHOTS / 2 || (shots == 0 && begun == job->shots)) {
            shots += LANES(court_plain_resume)(lists, shots, job);
            following = 0;
        }
        const size_t fresh = shots;
        if (begun < job->shots) {
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
            const LANES(court_opens_out) _o18 =
                LANES(court_opens)(clear);
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
            const LANES(court_opens_out) _o44 =
                LANES(court_opens)(clear);
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
            const LANES(court_opens_out) _o70 =
                LANES(court_opens)(clear);
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
        {
        size_t kept_rolling_shots = 0;
        for (size_t i = 0; i < kept_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(kept_shots - i);
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
            V ring = _o97.ring;
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
            }
            lanes_store(lists->kept_began + i, began);
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
                lanes_pack(lists->kept_rolling_ring + kept_rolling_shots, packed, ring);
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
            V ring = K(0.0);
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
                    ring = lanes_expand(lists->kept_rolling_ring + taken, idle, ring);
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
                const LANES(court_holding_out) _o121 =
                    LANES(court_holding)(held, K(0.0));
                M here = _o121.here;
                const M _m122 = lanes_both(active, here);
                if (lanes_any(_m122)) {
                    const LANES(court_ring_normal_out) _o123 =
                        LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m122, _o123.nx, nx);
                    ny = lanes_select(_m122, _o123.ny, ny);
                    nz = lanes_select(_m122, _o123.nz, nz);
                    const LANES(court_ring_tube_out) _o124 =
                        LANES(court_ring_tube)(p_ball_radius, p_ring_radius, p_wire_radius);
                    bent_x = lanes_select(_m122, _o124.bent_x, bent_x);
                    bent_y = lanes_select(_m122, _o124.bent_y, bent_y);
                    bent_z = lanes_select(_m122, _o124.bent_z, bent_z);
                    per_reach = lanes_select(_m122, _o124.per_reach, per_reach);
                    ring = lanes_select(_m122, _o124.ring, ring);
                }
                const LANES(court_holding_out) _o125 =
                    LANES(court_holding)(held, K(1.0));
                here = _o125.here;
                const M _m126 = lanes_both(active, here);
                if (lanes_any(_m126)) {
                    const LANES(court_backboard_normal_out) _o127 =
                        LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m126, _o127.nx, nx);
                    ny = lanes_select(_m126, _o127.ny, ny);
                    nz = lanes_select(_m126, _o127.nz, nz);
                    const LANES(court_backboard_tube_out) _o128 =
                        LANES(court_backboard_tube)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                    bent_x = lanes_select(_m126, _o128.bent_x, bent_x);
                    bent_y = lanes_select(_m126, _o128.bent_y, bent_y);
                    bent_z = lanes_select(_m126, _o128.bent_z, bent_z);
                    per_reach = lanes_select(_m126, _o128.per_reach, per_reach);
                    ring = lanes_select(_m126, _o128.ring, ring);
                }
                const LANES(court_holding_out) _o129 =
                    LANES(court_holding)(held, K(2.0));
                here = _o129.here;
                const M _m130 = lanes_both(active, here);
                if (lanes_any(_m130)) {
                    const LANES(court_bridge_normal_out) _o131 =
                        LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m130, _o131.nx, nx);
                    ny = lanes_select(_m130, _o131.ny, ny);
                    nz = lanes_select(_m130, _o131.nz, nz);
                    const LANES(court_bridge_tube_out) _o132 =
                        LANES(court_bridge_tube)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                    bent_x = lanes_select(_m130, _o132.bent_x, bent_x);
                    bent_y = lanes_select(_m130, _o132.bent_y, bent_y);
                    bent_z = lanes_select(_m130, _o132.bent_z, bent_z);
                    per_reach = lanes_select(_m130, _o132.per_reach, per_reach);
                    ring = lanes_select(_m130, _o132.ring, ring);
                }
                const LANES(court_roll_start_out) _o133 =
                    LANES(court_roll_start)(p_ball_radius, nx, ny, nz, ring, vx, vy, vz, wx, wy, wz, x, y);
                V vx_0 = _o133.vx_0;
                V vy_0 = _o133.vy_0;
                V vz_0 = _o133.vz_0;
                V nx_0 = _o133.nx_0;
                V ny_0 = _o133.ny_0;
                V nz_0 = _o133.nz_0;
                V turn_rate_0 = _o133.turn_rate_0;
                V cos_0 = _o133.cos_0;
                V sin_0 = _o133.sin_0;
                V near_0 = _o133.near_0;
                const LANES(court_roll_0_out) _o134 =
                    LANES(court_roll_0)(bent_x, bent_y, bent_z, cos_0, p_gravity, near_0, nx_0, ny_0, nz_0, per_reach, ring, sin_0, turn_rate_0, vx_0, vy_0, vz_0);
                V across_0 = _o134.across_0;
                V round_0 = _o134.round_0;
                V lift_0 = _o134.lift_0;
                V tx_0 = _o134.tx_0;
                V ty_0 = _o134.ty_0;
                V tz_0 = _o134.tz_0;
                V vx_1 = _o134.vx_1;
                V vy_1 = _o134.vy_1;
                V vz_1 = _o134.vz_1;
                V nx_1 = _o134.nx_1;
                V ny_1 = _o134.ny_1;
                V nz_1 = _o134.nz_1;
                V turn_rate_1 = _o134.turn_rate_1;
                V cos_1 = _o134.cos_1;
                V sin_1 = _o134.sin_1;
                V widened_1 = _o134.widened_1;
                V near_1 = _o134.near_1;
                const LANES(court_roll_1_out) _o135 =
                    LANES(court_roll_1)(across_0, bent_x, bent_y, bent_z, cos_0, cos_1, p_gravity, lift_0, near_0, near_1, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, ring, round_0, sin_0, sin_1, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1, widened_1);
                V across_1 = _o135.across_1;
                V round_1 = _o135.round_1;
                V lift_1 = _o135.lift_1;
                V tx_1 = _o135.tx_1;
                V ty_1 = _o135.ty_1;
                V tz_1 = _o135.tz_1;
                V vx_2 = _o135.vx_2;
                V vy_2 = _o135.vy_2;
                V vz_2 = _o135.vz_2;
                V nx_2 = _o135.nx_2;
                V ny_2 = _o135.ny_2;
                V nz_2 = _o135.nz_2;
                V turn_rate_2 = _o135.turn_rate_2;
                V cos_2 = _o135.cos_2;
                V sin_2 = _o135.sin_2;
                V widened_2 = _o135.widened_2;
                V near_2 = _o135.near_2;
                const LANES(court_roll_2_out) _o136 =
                    LANES(court_roll_2)(across_0, across_1, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, p_gravity, lift_0, lift_1, near_0, near_1, near_2, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, ring, round_0, round_1, sin_0, sin_1, sin_2, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2, widened_1, widened_2);
                V across_2 = _o136.across_2;
                V round_2 = _o136.round_2;
                V lift_2 = _o136.lift_2;
                V tx_2 = _o136.tx_2;
                V ty_2 = _o136.ty_2;
                V tz_2 = _o136.tz_2;
                V vx_3 = _o136.vx_3;
                V vy_3 = _o136.vy_3;
                V vz_3 = _o136.vz_3;
                V nx_3 = _o136.nx_3;
                V ny_3 = _o136.ny_3;
                V nz_3 = _o136.nz_3;
                V turn_rate_3 = _o136.turn_rate_3;
                V cos_3 = _o136.cos_3;
                V sin_3 = _o136.sin_3;
                V widened_3 = _o136.widened_3;
                V near_3 = _o136.near_3;
                const LANES(court_roll_3_out) _o137 =
                    LANES(court_roll_3)(across_0, across_1, across_2, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, p_gravity, lift_0, lift_1, lift_2, near_0, near_1, near_2, near_3, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, ring, round_0, round_1, round_2, sin_0, sin_1, sin_2, sin_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3, widened_1, widened_2, widened_3);
                V across_3 = _o137.across_3;
                V round_3 = _o137.round_3;
                V lift_3 = _o137.lift_3;
                V tx_3 = _o137.tx_3;
                V ty_3 = _o137.ty_3;
                V tz_3 = _o137.tz_3;
                V vx_4 = _o137.vx_4;
                V vy_4 = _o137.vy_4;
                V vz_4 = _o137.vz_4;
                V nx_4 = _o137.nx_4;
                V ny_4 = _o137.ny_4;
                V nz_4 = _o137.nz_4;
                V turn_rate_4 = _o137.turn_rate_4;
                V cos_4 = _o137.cos_4;
                V sin_4 = _o137.sin_4;
                V widened_4 = _o137.widened_4;
                V near_4 = _o137.near_4;
                const LANES(court_roll_4_out) _o138 =
                    LANES(court_roll_4)(across_0, across_1, across_2, across_3, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, cos_4, p_gravity, lift_0, lift_1, lift_2, lift_3, near_0, near_1, near_2, near_3, near_4, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, ring, round_0, round_1, round_2, round_3, sin_0, sin_1, sin_2, sin_3, sin_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4, widened_1, widened_2, widened_3, widened_4);
                V across_4 = _o138.across_4;
                V round_4 = _o138.round_4;
                V lift_4 = _o138.lift_4;
                V tx_4 = _o138.tx_4;
                V ty_4 = _o138.ty_4;
                V tz_4 = _o138.tz_4;
                V vx_5 = _o138.vx_5;
                V vy_5 = _o138.vy_5;
                V vz_5 = _o138.vz_5;
                V nx_5 = _o138.nx_5;
                V ny_5 = _o138.ny_5;
                V nz_5 = _o138.nz_5;
                V turn_rate_5 = _o138.turn_rate_5;
                V cos_5 = _o138.cos_5;
                V sin_5 = _o138.sin_5;
                V widened_5 = _o138.widened_5;
                V near_5 = _o138.near_5;
                const LANES(court_roll_5_out) _o139 =
                    LANES(court_roll_5)(across_0, across_1, across_2, across_3, across_4, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, near_0, near_1, near_2, near_3, near_4, near_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, ring, round_0, round_1, round_2, round_3, round_4, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, widened_1, widened_2, widened_3, widened_4, widened_5);
                V across_5 = _o139.across_5;
                V round_5 = _o139.round_5;
                V lift_5 = _o139.lift_5;
                V tx_5 = _o139.tx_5;
                V ty_5 = _o139.ty_5;
                V tz_5 = _o139.tz_5;
                V vx_6 = _o139.vx_6;
                V vy_6 = _o139.vy_6;
                V vz_6 = _o139.vz_6;
                V nx_6 = _o139.nx_6;
                V ny_6 = _o139.ny_6;
                V nz_6 = _o139.nz_6;
                V turn_rate_6 = _o139.turn_rate_6;
                V cos_6 = _o139.cos_6;
                V sin_6 = _o139.sin_6;
                V widened_6 = _o139.widened_6;
                V near_6 = _o139.near_6;
                const LANES(court_roll_6_out) _o140 =
                    LANES(court_roll_6)(across_0, across_1, across_2, across_3, across_4, across_5, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, near_0, near_1, near_2, near_3, near_4, near_5, near_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, ring, round_0, round_1, round_2, round_3, round_4, round_5, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, widened_1, widened_2, widened_3, widened_4, widened_5, widened_6);
                V across_6 = _o140.across_6;
                V round_6 = _o140.round_6;
                V lift_6 = _o140.lift_6;
                V tx_6 = _o140.tx_6;
                V ty_6 = _o140.ty_6;
                V tz_6 = _o140.tz_6;
                V vx_7 = _o140.vx_7;
                V vy_7 = _o140.vy_7;
                V vz_7 = _o140.vz_7;
                V nx_7 = _o140.nx_7;
                V ny_7 = _o140.ny_7;
                V nz_7 = _o140.nz_7;
                V turn_rate_7 = _o140.turn_rate_7;
                V cos_7 = _o140.cos_7;
                V sin_7 = _o140.sin_7;
                V widened_7 = _o140.widened_7;
                V near_7 = _o140.near_7;
                const LANES(court_roll_7_out) _o141 =
                    LANES(court_roll_7)(across_0, across_1, across_2, across_3, across_4, across_5, across_6, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, ring, round_0, round_1, round_2, round_3, round_4, round_5, round_6, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, widened_1, widened_2, widened_3, widened_4, widened_5, widened_6, widened_7);
                V lift_7 = _o141.lift_7;
                V vx_8 = _o141.vx_8;
                V vy_8 = _o141.vy_8;
                V vz_8 = _o141.vz_8;
                V nx_8 = _o141.nx_8;
                V ny_8 = _o141.ny_8;
                V nz_8 = _o141.nz_8;
                V turn_rate_8 = _o141.turn_rate_8;
                const LANES(court_roll_pace_out) _o142 =
                    LANES(court_roll_pace)(p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, lift_7, nx_8, ny_8, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, nz_8, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8);
                V stride = _o142.stride;
                V strongest = _o142.strongest;
                V fastest = _o142.fastest;
                V force = _o142.force;
                V force_rate = _o142.force_rate;
                V force_bend = _o142.force_bend;
                const LANES(court_leaving_force_out) _o143 =
                    LANES(court_leaving_force)(p_ball_radius, K(INFINITY), fastest, force, force_bend, force_rate, p_gravity, per_reach, K(0.0), stride, K(0.0), vx, vx_1, vy, vy_1, vz, vz_1, which);
                stride = _o143.stride;
                which = _o143.which;
                M rests = _o143.rests;
                const LANES(court_beside_out) _o144 =
                    LANES(court_beside)(held, K(0.0));
                M beside = _o144.beside;
                const M _m145 = lanes_both(active, beside);
                if (lanes_any(_m145)) {
                    const LANES(court_ring_beside_out) _o146 =
                        LANES(court_ring_beside)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                    V gap = _o146.gap;
                    V nearing = _o146.nearing;
                    V dent = _o146.dent;
                    const LANES(court_beside_body_out) _o147 =
                        LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(0.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
                    stride = lanes_select(_m145, _o147.stride, stride);
                    which = lanes_select(_m145, _o147.which, which);
                }
                const LANES(court_beside_out) _o148 =
                    LANES(court_beside)(held, K(1.0));
                beside = _o148.beside;
                const M _m149 = lanes_both(active, beside);
                if (lanes_any(_m149)) {
                    const LANES(court_backboard_beside_out) _o150 =
                        LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                    V gap = _o150.gap;
                    V nearing = _o150.nearing;
                    V dent = _o150.dent;
                    const LANES(court_beside_body_out) _o151 =
                        LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(1.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
                    stride = lanes_select(_m149, _o151.stride, stride);
                    which = lanes_select(_m149, _o151.which, which);
                }
                const LANES(court_beside_out) _o152 =
                    LANES(court_beside)(held, K(2.0));
                beside = _o152.beside;
                const M _m153 = lanes_both(active, beside);
                if (lanes_any(_m153)) {
                    const LANES(court_bridge_beside_out) _o154 =
                        LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                    V gap = _o154.gap;
                    V nearing = _o154.nearing;
                    V dent = _o154.dent;
                    const LANES(court_beside_body_out) _o155 =
                        LANES(court_beside_body)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(2.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
                    stride = lanes_select(_m153, _o155.stride, stride);
                    which = lanes_select(_m153, _o155.which, which);
                }
                const LANES(court_end_beside_out) _o156 =
                    LANES(court_end_beside)(p_end_depth, vz, z);
                V gap = _o156.gap;
                V nearing = _o156.nearing;
                V dent = _o156.dent;
                const LANES(court_beside_gate_out) _o157 =
                    LANES(court_beside_gate)(p_ball_radius, dent, K(INFINITY), fastest, gap, K(3.0), K(0.0), nearing, K(0.0), stride, strongest, which, x, y, z);
                stride = _o157.stride;
                which = _o157.which;
                const LANES(court_holding_out) _o158 =
                    LANES(court_holding)(held, K(1.0));
                here = _o158.here;
                const M _m159 = lanes_both(active, here);
                if (lanes_any(_m159)) {
                    const LANES(court_backboard_seam0_out) _o160 =
                        LANES(court_backboard_seam0)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                    gap = lanes_select(_m159, _o160.gap, gap);
                    V nearing = _o160.nearing;
                    V near = _o160.near;
                    const LANES(court_beside_seam_out) _o161 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m159, _o161.stride, stride);
                    const LANES(court_backboard_seam1_out) _o162 =
                        LANES(court_backboard_seam1)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                    gap = lanes_select(_m159, _o162.gap, gap);
                    nearing = _o162.nearing;
                    near = _o162.near;
                    const LANES(court_beside_seam_out) _o163 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m159, _o163.stride, stride);
                    const LANES(court_backboard_seam2_out) _o164 =
                        LANES(court_backboard_seam2)(p_ball_radius, p_board_half_width, vy, y);
                    gap = lanes_select(_m159, _o164.gap, gap);
                    nearing = _o164.nearing;
                    near = _o164.near;
                    const LANES(court_beside_seam_out) _o165 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m159, _o165.stride, stride);
                    const LANES(court_backboard_seam3_out) _o166 =
                        LANES(court_backboard_seam3)(p_ball_radius, p_board_half_width, vy, y);
                    gap = lanes_select(_m159, _o166.gap, gap);
                    nearing = _o166.nearing;
                    near = _o166.near;
                    const LANES(court_beside_seam_out) _o167 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m159, _o167.stride, stride);
                    const LANES(court_backboard_seam4_out) _o168 =
                        LANES(court_backboard_seam4)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                    gap = lanes_select(_m159, _o168.gap, gap);
                    nearing = _o168.nearing;
                    near = _o168.near;
                    const LANES(court_beside_seam_out) _o169 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m159, _o169.stride, stride);
                    const LANES(court_backboard_seam5_out) _o170 =
                        LANES(court_backboard_seam5)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                    gap = lanes_select(_m159, _o170.gap, gap);
                    nearing = _o170.nearing;
                    near = _o170.near;
                    const LANES(court_beside_seam_out) _o171 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m159, _o171.stride, stride);
                }
                const LANES(court_holding_out) _o172 =
                    LANES(court_holding)(held, K(2.0));
                here = _o172.here;
                const M _m173 = lanes_both(active, here);
                if (lanes_any(_m173)) {
                    const LANES(court_bridge_seam0_out) _o174 =
                        LANES(court_bridge_seam0)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                    gap = lanes_select(_m173, _o174.gap, gap);
                    V nearing = _o174.nearing;
                    V near = _o174.near;
                    const LANES(court_beside_seam_out) _o175 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m173, _o175.stride, stride);
                    const LANES(court_bridge_seam1_out) _o176 =
                        LANES(court_bridge_seam1)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                    gap = lanes_select(_m173, _o176.gap, gap);
                    nearing = _o176.nearing;
                    near = _o176.near;
                    const LANES(court_beside_seam_out) _o177 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m173, _o177.stride, stride);
                    const LANES(court_bridge_seam2_out) _o178 =
                        LANES(court_bridge_seam2)(p_ball_radius, p_bridge_half_width, vy, y);
                    gap = lanes_select(_m173, _o178.gap, gap);
                    nearing = _o178.nearing;
                    near = _o178.near;
                    const LANES(court_beside_seam_out) _o179 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m173, _o179.stride, stride);
                    const LANES(court_bridge_seam3_out) _o180 =
                        LANES(court_bridge_seam3)(p_ball_radius, p_bridge_half_width, vy, y);
                    gap = lanes_select(_m173, _o180.gap, gap);
                    nearing = _o180.nearing;
                    near = _o180.near;
                    const LANES(court_beside_seam_out) _o181 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m173, _o181.stride, stride);
                    const LANES(court_bridge_seam4_out) _o182 =
                        LANES(court_bridge_seam4)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                    gap = lanes_select(_m173, _o182.gap, gap);
                    nearing = _o182.nearing;
                    near = _o182.near;
                    const LANES(court_beside_seam_out) _o183 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m173, _o183.stride, stride);
                    const LANES(court_bridge_seam5_out) _o184 =
                        LANES(court_bridge_seam5)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                    gap = lanes_select(_m173, _o184.gap, gap);
                    nearing = _o184.nearing;
                    near = _o184.near;
                    const LANES(court_beside_seam_out) _o185 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m173, _o185.stride, stride);
                }
                const LANES(court_beside_time_out) _o186 =
                    LANES(court_beside_time)(clock, stride, time_limit, which);
                stride = _o186.stride;
                which = _o186.which;
                const LANES(court_apart_out) _o187 =
                    LANES(court_apart)(p_ball_radius, K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0));
                V apart = _o187.apart;
                const LANES(court_neighbour_out) _o188 =
                    LANES(court_neighbour)(apart, K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), vx, vy, vz, wx, wy, wz, x, y, z);
                V far_x = _o188.far_x;
                V far_y = _o188.far_y;
                V far_z = _o188.far_z;
                V far_vx = _o188.far_vx;
                V far_vy = _o188.far_vy;
                V far_vz = _o188.far_vz;
                V far_wx = _o188.far_wx;
                V far_wy = _o188.far_wy;
                V far_wz = _o188.far_wz;
                const LANES(court_passing_from_out) _o189 =
                    LANES(court_passing_from)(z);
                M over = _o189.over;
                const LANES(court_roll_moved_out) _o190 =
                    LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, x, y, z);
                x = _o190.x;
                vx = _o190.vx;
                y = _o190.y;
                vy = _o190.vy;
                z = _o190.z;
                vz = _o190.vz;
                V turn_rate = _o190.turn_rate;
                const LANES(court_holding_out) _o191 =
                    LANES(court_holding)(held, K(0.0));
                here = _o191.here;
                const M _m192 = lanes_both(active, here);
                if (lanes_any(_m192)) {
                    const LANES(court_ring_normal_out) _o193 =
                        LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m192, _o193.nx, nx);
                    ny = lanes_select(_m192, _o193.ny, ny);
                    nz = lanes_select(_m192, _o193.nz, nz);
                    const LANES(court_ring_off_out) _o194 =
                        LANES(court_ring_off)(p_ball_radius, p_ring_radius, p_wire_radius, x, y, z);
                    gap = lanes_select(_m192, _o194.gap, gap);
                }
                const LANES(court_holding_out) _o195 =
                    LANES(court_holding)(held, K(1.0));
                here = _o195.here;
                const M _m196 = lanes_both(active, here);
                if (lanes_any(_m196)) {
                    const LANES(court_backboard_normal_out) _o197 =
                        LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m196, _o197.nx, nx);
                    ny = lanes_select(_m196, _o197.ny, ny);
                    nz = lanes_select(_m196, _o197.nz, nz);
                    const LANES(court_backboard_off_out) _o198 =
                        LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z);
                    gap = lanes_select(_m196, _o198.gap, gap);
                }
                const LANES(court_holding_out) _o199 =
                    LANES(court_holding)(held, K(2.0));
                here = _o199.here;
                const M _m200 = lanes_both(active, here);
                if (lanes_any(_m200)) {
                    const LANES(court_bridge_normal_out) _o201 =
                        LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m200, _o201.nx, nx);
                    ny = lanes_select(_m200, _o201.ny, ny);
                    nz = lanes_select(_m200, _o201.nz, nz);
                    const LANES(court_bridge_off_out) _o202 =
                        LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z);
                    gap = lanes_select(_m200, _o202.gap, gap);
                }
                const LANES(court_roll_placed_out) _o203 =
                    LANES(court_roll_placed)(p_ball_radius, gap, nx, ny, nz, turn_rate, vx, vy, vz, x, y, z);
                x = _o203.x;
                y = _o203.y;
                z = _o203.z;
                vx = _o203.vx;
                vy = _o203.vy;
                vz = _o203.vz;
                wx = _o203.wx;
                wy = _o203.wy;
                wz = _o203.wz;
                const LANES(court_passing_in_contact_out) _o204 =
                    LANES(court_passing_in_contact)(over, p_ring_radius, through, x, y, z);
                through = _o204.through;
                const LANES(court_holding_out) _o205 =
                    LANES(court_holding)(held, K(0.0));
                here = _o205.here;
                const M _m206 = lanes_both(active, here);
                {
                    const LANES(court_ring_normal_out) _o207 =
                        LANES(court_ring_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m206, _o207.nx, nx);
                    ny = lanes_select(_m206, _o207.ny, ny);
                    nz = lanes_select(_m206, _o207.nz, nz);
                }
                const LANES(court_holding_out) _o208 =
                    LANES(court_holding)(held, K(1.0));
                here = _o208.here;
                const M _m209 = lanes_both(active, here);
                {
                    const LANES(court_backboard_normal_out) _o210 =
                        LANES(court_backboard_normal)(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m209, _o210.nx, nx);
                    ny = lanes_select(_m209, _o210.ny, ny);
                    nz = lanes_select(_m209, _o210.nz, nz);
                }
                const LANES(court_holding_out) _o211 =
                    LANES(court_holding)(held, K(2.0));
                here = _o211.here;
                const M _m212 = lanes_both(active, here);
                {
                    const LANES(court_bridge_normal_out) _o213 =
                        LANES(court_bridge_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m212, _o213.nx, nx);
                    ny = lanes_select(_m212, _o213.ny, ny);
                    nz = lanes_select(_m212, _o213.nz, nz);
                }
                const LANES(court_roll_turn_rate_out) _o214 =
                    LANES(court_roll_turn_rate)(p_ball_radius, nx, ny, nz, far_wx, far_wy, far_wz);
                turn_rate = _o214.turn_rate;
                const LANES(court_holding_out) _o215 =
                    LANES(court_holding)(held, K(0.0));
                here = _o215.here;
                const M _m216 = lanes_both(active, here);
                if (lanes_any(_m216)) {
                    const LANES(court_ring_normal_out) _o217 =
                        LANES(court_ring_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m216, _o217.nx, nx);
                    ny = lanes_select(_m216, _o217.ny, ny);
                    nz = lanes_select(_m216, _o217.nz, nz);
                    const LANES(court_ring_off_out) _o218 =
                        LANES(court_ring_off)(p_ball_radius, p_ring_radius, p_wire_radius, far_x, far_y, far_z);
                    gap = lanes_select(_m216, _o218.gap, gap);
                }
                const LANES(court_holding_out) _o219 =
                    LANES(court_holding)(held, K(1.0));
                here = _o219.here;
                const M _m220 = lanes_both(active, here);
                if (lanes_any(_m220)) {
                    const LANES(court_backboard_normal_out) _o221 =
                        LANES(court_backboard_normal)(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m220, _o221.nx, nx);
                    ny = lanes_select(_m220, _o221.ny, ny);
                    nz = lanes_select(_m220, _o221.nz, nz);
                    const LANES(court_backboard_off_out) _o222 =
                        LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, far_x, far_y, far_z);
                    gap = lanes_select(_m220, _o222.gap, gap);
                }
                const LANES(court_holding_out) _o223 =
                    LANES(court_holding)(held, K(2.0));
                here = _o223.here;
                const M _m224 = lanes_both(active, here);
                if (lanes_any(_m224)) {
                    const LANES(court_bridge_normal_out) _o225 =
                        LANES(court_bridge_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m224, _o225.nx, nx);
                    ny = lanes_select(_m224, _o225.ny, ny);
                    nz = lanes_select(_m224, _o225.nz, nz);
                    const LANES(court_bridge_off_out) _o226 =
                        LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, far_x, far_y, far_z);
                    gap = lanes_select(_m224, _o226.gap, gap);
                }
                const LANES(court_roll_placed_out) _o227 =
                    LANES(court_roll_placed)(p_ball_radius, gap, nx, ny, nz, turn_rate, far_vx, far_vy, far_vz, far_x, far_y, far_z);
                far_x = _o227.x;
                far_y = _o227.y;
                far_z = _o227.z;
                far_vx = _o227.vx;
                far_vy = _o227.vy;
                far_vz = _o227.vz;
                far_wx = _o227.wx;
                far_wy = _o227.wy;
                far_wz = _o227.wz;
                const LANES(court_roll_start_out) _o228 =
                    LANES(court_roll_start)(p_ball_radius, nx, ny, nz, ring, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_x, far_y);
                vx_0 = _o228.vx_0;
                vy_0 = _o228.vy_0;
                vz_0 = _o228.vz_0;
                nx_0 = _o228.nx_0;
                ny_0 = _o228.ny_0;
                nz_0 = _o228.nz_0;
                turn_rate_0 = _o228.turn_rate_0;
                cos_0 = _o228.cos_0;
                sin_0 = _o228.sin_0;
                near_0 = _o228.near_0;
                const LANES(court_roll_0_out) _o229 =
                    LANES(court_roll_0)(bent_x, bent_y, bent_z, cos_0, p_gravity, near_0, nx_0, ny_0, nz_0, per_reach, ring, sin_0, turn_rate_0, vx_0, vy_0, vz_0);
                across_0 = _o229.across_0;
                round_0 = _o229.round_0;
                lift_0 = _o229.lift_0;
                tx_0 = _o229.tx_0;
                ty_0 = _o229.ty_0;
                tz_0 = _o229.tz_0;
                vx_1 = _o229.vx_1;
                vy_1 = _o229.vy_1;
                vz_1 = _o229.vz_1;
                nx_1 = _o229.nx_1;
                ny_1 = _o229.ny_1;
                nz_1 = _o229.nz_1;
                turn_rate_1 = _o229.turn_rate_1;
                cos_1 = _o229.cos_1;
                sin_1 = _o229.sin_1;
                widened_1 = _o229.widened_1;
                near_1 = _o229.near_1;
                const LANES(court_roll_1_out) _o230 =
                    LANES(court_roll_1)(across_0, bent_x, bent_y, bent_z, cos_0, cos_1, p_gravity, lift_0, near_0, near_1, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, ring, round_0, sin_0, sin_1, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1, widened_1);
                across_1 = _o230.across_1;
                round_1 = _o230.round_1;
                lift_1 = _o230.lift_1;
                tx_1 = _o230.tx_1;
                ty_1 = _o230.ty_1;
                tz_1 = _o230.tz_1;
                vx_2 = _o230.vx_2;
                vy_2 = _o230.vy_2;
                vz_2 = _o230.vz_2;
                nx_2 = _o230.nx_2;
                ny_2 = _o230.ny_2;
                nz_2 = _o230.nz_2;
                turn_rate_2 = _o230.turn_rate_2;
                cos_2 = _o230.cos_2;
                sin_2 = _o230.sin_2;
                widened_2 = _o230.widened_2;
                near_2 = _o230.near_2;
                const LANES(court_roll_2_out) _o231 =
                    LANES(court_roll_2)(across_0, across_1, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, p_gravity, lift_0, lift_1, near_0, near_1, near_2, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, ring, round_0, round_1, sin_0, sin_1, sin_2, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2, widened_1, widened_2);
                across_2 = _o231.across_2;
                round_2 = _o231.round_2;
                lift_2 = _o231.lift_2;
                tx_2 = _o231.tx_2;
                ty_2 = _o231.ty_2;
                tz_2 = _o231.tz_2;
                vx_3 = _o231.vx_3;
                vy_3 = _o231.vy_3;
                vz_3 = _o231.vz_3;
                nx_3 = _o231.nx_3;
                ny_3 = _o231.ny_3;
                nz_3 = _o231.nz_3;
                turn_rate_3 = _o231.turn_rate_3;
                cos_3 = _o231.cos_3;
                sin_3 = _o231.sin_3;
                widened_3 = _o231.widened_3;
                near_3 = _o231.near_3;
                const LANES(court_roll_3_out) _o232 =
                    LANES(court_roll_3)(across_0, across_1, across_2, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, p_gravity, lift_0, lift_1, lift_2, near_0, near_1, near_2, near_3, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, ring, round_0, round_1, round_2, sin_0, sin_1, sin_2, sin_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3, widened_1, widened_2, widened_3);
                across_3 = _o232.across_3;
                round_3 = _o232.round_3;
                lift_3 = _o232.lift_3;
                tx_3 = _o232.tx_3;
                ty_3 = _o232.ty_3;
                tz_3 = _o232.tz_3;
                vx_4 = _o232.vx_4;
                vy_4 = _o232.vy_4;
                vz_4 = _o232.vz_4;
                nx_4 = _o232.nx_4;
                ny_4 = _o232.ny_4;
                nz_4 = _o232.nz_4;
                turn_rate_4 = _o232.turn_rate_4;
                cos_4 = _o232.cos_4;
                sin_4 = _o232.sin_4;
                widened_4 = _o232.widened_4;
                near_4 = _o232.near_4;
                const LANES(court_roll_4_out) _o233 =
                    LANES(court_roll_4)(across_0, across_1, across_2, across_3, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, cos_4, p_gravity, lift_0, lift_1, lift_2, lift_3, near_0, near_1, near_2, near_3, near_4, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, ring, round_0, round_1, round_2, round_3, sin_0, sin_1, sin_2, sin_3, sin_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4, widened_1, widened_2, widened_3, widened_4);
                across_4 = _o233.across_4;
                round_4 = _o233.round_4;
                lift_4 = _o233.lift_4;
                tx_4 = _o233.tx_4;
                ty_4 = _o233.ty_4;
                tz_4 = _o233.tz_4;
                vx_5 = _o233.vx_5;
                vy_5 = _o233.vy_5;
                vz_5 = _o233.vz_5;
                nx_5 = _o233.nx_5;
                ny_5 = _o233.ny_5;
                nz_5 = _o233.nz_5;
                turn_rate_5 = _o233.turn_rate_5;
                cos_5 = _o233.cos_5;
                sin_5 = _o233.sin_5;
                widened_5 = _o233.widened_5;
                near_5 = _o233.near_5;
                const LANES(court_roll_5_out) _o234 =
                    LANES(court_roll_5)(across_0, across_1, across_2, across_3, across_4, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, near_0, near_1, near_2, near_3, near_4, near_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, ring, round_0, round_1, round_2, round_3, round_4, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, widened_1, widened_2, widened_3, widened_4, widened_5);
                across_5 = _o234.across_5;
                round_5 = _o234.round_5;
                lift_5 = _o234.lift_5;
                tx_5 = _o234.tx_5;
                ty_5 = _o234.ty_5;
                tz_5 = _o234.tz_5;
                vx_6 = _o234.vx_6;
                vy_6 = _o234.vy_6;
                vz_6 = _o234.vz_6;
                nx_6 = _o234.nx_6;
                ny_6 = _o234.ny_6;
                nz_6 = _o234.nz_6;
                turn_rate_6 = _o234.turn_rate_6;
                cos_6 = _o234.cos_6;
                sin_6 = _o234.sin_6;
                widened_6 = _o234.widened_6;
                near_6 = _o234.near_6;
                const LANES(court_roll_6_out) _o235 =
                    LANES(court_roll_6)(across_0, across_1, across_2, across_3, across_4, across_5, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, near_0, near_1, near_2, near_3, near_4, near_5, near_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, ring, round_0, round_1, round_2, round_3, round_4, round_5, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, widened_1, widened_2, widened_3, widened_4, widened_5, widened_6);
                across_6 = _o235.across_6;
                round_6 = _o235.round_6;
                lift_6 = _o235.lift_6;
                tx_6 = _o235.tx_6;
                ty_6 = _o235.ty_6;
                tz_6 = _o235.tz_6;
                vx_7 = _o235.vx_7;
                vy_7 = _o235.vy_7;
                vz_7 = _o235.vz_7;
                nx_7 = _o235.nx_7;
                ny_7 = _o235.ny_7;
                nz_7 = _o235.nz_7;
                turn_rate_7 = _o235.turn_rate_7;
                cos_7 = _o235.cos_7;
                sin_7 = _o235.sin_7;
                widened_7 = _o235.widened_7;
                near_7 = _o235.near_7;
                const LANES(court_roll_7_out) _o236 =
                    LANES(court_roll_7)(across_0, across_1, across_2, across_3, across_4, across_5, across_6, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, ring, round_0, round_1, round_2, round_3, round_4, round_5, round_6, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, widened_1, widened_2, widened_3, widened_4, widened_5, widened_6, widened_7);
                vx_8 = _o236.vx_8;
                vy_8 = _o236.vy_8;
                vz_8 = _o236.vz_8;
                turn_rate_8 = _o236.turn_rate_8;
                const LANES(court_roll_moved_out) _o237 =
                    LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, far_x, far_y, far_z);
                far_x = _o237.x;
                far_y = _o237.y;
                far_z = _o237.z;
                const LANES(court_holding_out) _o238 =
                    LANES(court_holding)(held, K(0.0));
                here = _o238.here;
                const M _m239 = lanes_both(active, here);
                {
                    const LANES(court_ring_normal_out) _o240 =
                        LANES(court_ring_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m239, _o240.nx, nx);
                    ny = lanes_select(_m239, _o240.ny, ny);
                    nz = lanes_select(_m239, _o240.nz, nz);
                }
                const LANES(court_holding_out) _o241 =
                    LANES(court_holding)(held, K(1.0));
                here = _o241.here;
                const M _m242 = lanes_both(active, here);
                {
                    const LANES(court_backboard_normal_out) _o243 =
                        LANES(court_backboard_normal)(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m242, _o243.nx, nx);
                    ny = lanes_select(_m242, _o243.ny, ny);
                    nz = lanes_select(_m242, _o243.nz, nz);
                }
                const LANES(court_holding_out) _o244 =
                    LANES(court_holding)(held, K(2.0));
                here = _o244.here;
                const M _m245 = lanes_both(active, here);
                {
                    const LANES(court_bridge_normal_out) _o246 =
                        LANES(court_bridge_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m245, _o246.nx, nx);
                    ny = lanes_select(_m245, _o246.ny, ny);
                    nz = lanes_select(_m245, _o246.nz, nz);
                }
                const LANES(court_rolled_on_out) _o247 =
                    LANES(court_rolled_on)(clock, rests, stride, which);
                clock = _o247.clock;
                rolling = _o247.rolling;
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(rolling, lanes_less(turns, K(64.0)))));
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
        for (size_t i = 0; i < kept_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(kept_shots - i);
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
            const M _m248 = lanes_both(rows, leaves);
            if (lanes_any(_m248)) {
                const LANES(court_holding_out) _o249 =
                    LANES(court_holding)(held, K(0.0));
                M here = _o249.here;
                const M _m250 = lanes_both(_m248, here);
                if (lanes_any(_m250)) {
                    const LANES(court_ring_tube_out) _o251 =
                        LANES(court_ring_tube)(p_ball_radius, p_ring_radius, p_wire_radius);
                    per_reach = lanes_select(_m250, _o251.per_reach, per_reach);
                    const LANES(court_ring_parting_out) _o252 =
                        LANES(court_ring_parting)(p_gravity, p_ring_radius, vx, vy, vz, x, y, z);
                    lift = lanes_select(_m250, _o252.lift, lift);
                    surge = lanes_select(_m250, _o252.surge, surge);
                    snap = lanes_select(_m250, _o252.snap, snap);
                }
                const LANES(court_holding_out) _o253 =
                    LANES(court_holding)(held, K(1.0));
                here = _o253.here;
                const M _m254 = lanes_both(_m248, here);
                if (lanes_any(_m254)) {
                    const LANES(court_backboard_tube_out) _o255 =
                        LANES(court_backboard_tube)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                    per_reach = lanes_select(_m254, _o255.per_reach, per_reach);
                    const LANES(court_backboard_parting_out) _o256 =
                        LANES(court_backboard_parting)(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, vx, vy, vz, x, y, z);
                    lift = lanes_select(_m254, _o256.lift, lift);
                    surge = lanes_select(_m254, _o256.surge, surge);
                    snap = lanes_select(_m254, _o256.snap, snap);
                }
                const LANES(court_holding_out) _o257 =
                    LANES(court_holding)(held, K(2.0));
                here = _o257.here;
                const M _m258 = lanes_both(_m248, here);
                if (lanes_any(_m258)) {
                    const LANES(court_bridge_tube_out) _o259 =
                        LANES(court_bridge_tube)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                    per_reach = lanes_select(_m258, _o259.per_reach, per_reach);
                    const LANES(court_bridge_parting_out) _o260 =
                        LANES(court_bridge_parting)(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                    lift = lanes_select(_m258, _o260.lift, lift);
                    surge = lanes_select(_m258, _o260.surge, surge);
                    snap = lanes_select(_m258, _o260.snap, snap);
                }
                const LANES(court_alone_out) _o261 =
                    LANES(court_alone)();
                V nearest = _o261.nearest;
                const LANES(court_beside_out) _o262 =
                    LANES(court_beside)(held, K(0.0));
                M beside = _o262.beside;
                const M _m263 = lanes_both(_m248, beside);
                if (lanes_any(_m263)) {
                    const LANES(court_ring_beside_out) _o264 =
                        LANES(court_ring_beside)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                    V gap = _o264.gap;
                    const LANES(court_neared_out) _o265 =
                        LANES(court_neared)(gap, nearest);
                    nearest = lanes_select(_m263, _o265.nearest, nearest);
                }
                const LANES(court_beside_out) _o266 =
                    LANES(court_beside)(held, K(1.0));
                beside = _o266.beside;
                const M _m267 = lanes_both(_m248, beside);
                if (lanes_any(_m267)) {
                    const LANES(court_backboard_beside_out) _o268 =
                        LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                    V gap = _o268.gap;
                    const LANES(court_neared_out) _o269 =
                        LANES(court_neared)(gap, nearest);
                    nearest = lanes_select(_m267, _o269.nearest, nearest);
                }
                const LANES(court_beside_out) _o270 =
                    LANES(court_beside)(held, K(2.0));
                beside = _o270.beside;
                const M _m271 = lanes_both(_m248, beside);
                if (lanes_any(_m271)) {
                    const LANES(court_bridge_beside_out) _o272 =
                        LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                    V gap = _o272.gap;
                    const LANES(court_neared_out) _o273 =
                        LANES(court_neared)(gap, nearest);
                    nearest = lanes_select(_m271, _o273.nearest, nearest);
                }
                const LANES(court_beside_out) _o274 =
                    LANES(court_beside)(held, K(3.0));
                beside = _o274.beside;
                const M _m275 = lanes_both(_m248, beside);
                {
                    const LANES(court_end_beside_out) _o276 =
                        LANES(court_end_beside)(p_end_depth, vz, z);
                    V gap = _o276.gap;
                    const LANES(court_neared_out) _o277 =
                        LANES(court_neared)(gap, nearest);
                    nearest = lanes_select(_m275, _o277.nearest, nearest);
                }
                const LANES(court_parted_out) _o278 =
                    LANES(court_parted)(K(INFINITY), p_gravity, lift, nearest, per_reach, K(0.0), snap, surge, K(0.0), vx, vy, vz);
                when = lanes_select(_m248, _o278.when, when);
                const LANES(court_hopping_out) _o279 =
                    LANES(court_hopping)();
                which = lanes_select(_m248, _o279.which, which);
            }
            lanes_store(lists->kept_when + i, when);
            lanes_store(lists->kept_which + i, which);
        }
        for (size_t k = 0; k < kept_shots; k++) {
            const size_t row = (size_t)lists->kept_row[k];
            lists->began[row] = lists->kept_began[k];
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
            const LANES(court_departed_out) _o280 =
                LANES(court_departed)(K(3.0), which);
            M moves = _o280.moves;
            M ends = _o280.ends;
            M touches = _o280.touches;
            V reached = _o280.reached;
            const LANES(court_body_of_out) _o281 =
                LANES(court_body_of)(which);
            V body = _o281.body;
            const M _m282 = lanes_both(rows, moves);
            if (lanes_any(_m282)) {
                const LANES(court_passing_out) _o283 =
                    LANES(court_passing)(through, when, x, y, z, vx, vy, vz, p_ring_radius, p_gravity);
                through = lanes_select(_m282, _o283.through, through);
                const LANES(court_flight_out) _o284 =
                    LANES(court_flight)(when, x, y, z, vx, vy, vz, p_gravity);
                x = lanes_select(_m282, _o284.x, x);
                y = lanes_select(_m282, _o284.y, y);
                z = lanes_select(_m282, _o284.z, z);
                vx = lanes_select(_m282, _o284.vx, vx);
                vy = lanes_select(_m282, _o284.vy, vy);
                vz = lanes_select(_m282, _o284.vz, vz);
                const LANES(court_ticked_out) _o285 =
                    LANES(court_ticked)(clock, when);
                clock = lanes_select(_m282, _o285.clock, clock);
            }
            const M _m286 = lanes_both(rows, limited);
            if (lanes_any(_m286)) {
                const LANES(court_expired_out) _o287 =
                    LANES(court_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m286, _o287.clock, clock);
                body = lanes_select(_m286, _o287.body, body);
                reached = lanes_select(_m286, _o287.reached, reached);
                ends = lanes_choose(_m286, _o287.ends, ends);
            }
            const M _m288 = lanes_both(rows, kept);
            if (lanes_any(_m288)) {
                const LANES(court_kept_on_out) _o289 =
                    LANES(court_kept_on)(began, body, clock, K(INFINITY), ends, held, last, reached, rests, rolling, rolls, which);
                body = lanes_select(_m288, _o289.body, body);
                reached = lanes_select(_m288, _o289.reached, reached);
                ends = lanes_choose(_m288, _o289.ends, ends);
                last = lanes_select(_m288, _o289.last, last);
                mode = lanes_select(_m288, _o289.mode, mode);
                held = lanes_select(_m288, _o289.held, held);
                rolls = lanes_select(_m288, _o289.rolls, rolls);
            }
            const LANES(court_here_out) _o290 =
                LANES(court_here)(K(3.0), which);
            M here = _o290.here;
            const M _m291 = lanes_both(rows, here);
            {
                const LANES(court_end_bounds_out) _o292 =
                    LANES(court_end_bounds)(x, y, p_ring_radius);
                V g0 = _o292.g0;
                const LANES(court_end_reached_out) _o293 =
                    LANES(court_end_reached)(g0, through);
                reached = lanes_select(_m291, _o293.reached, reached);
            }
            const LANES(court_accounted_out) _o294 =
                LANES(court_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o294.contacts;
            V outcome = _o294.outcome;
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
            const LANES(court_meeting_out) _o295 =
                LANES(court_meeting)(K(0.0), ends, touches);
            M meeting = _o295.meeting;
            const M _m296 = lanes_both(rows, meeting);
            if (lanes_any(_m296)) {
                const LANES(court_end_normal_out) _o297 =
                    LANES(court_end_normal)();
                V nx = _o297.nx;
                V ny = _o297.ny;
                V nz = _o297.nz;
                const LANES(court_here_out) _o298 =
                    LANES(court_here)(K(0.0), which);
                M here = _o298.here;
                const M _m299 = lanes_both(_m296, here);
                {
                    const LANES(court_ring_normal_out) _o300 =
                        LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m299, _o300.nx, nx);
                    ny = lanes_select(_m299, _o300.ny, ny);
                    nz = lanes_select(_m299, _o300.nz, nz);
                    const LANES(court_counted_out) _o301 =
                        LANES(court_counted)(count_0);
                    count_0 = lanes_select(_m299, _o301.count, count_0);
                }
                const LANES(court_here_out) _o302 =
                    LANES(court_here)(K(1.0), which);
                here = _o302.here;
                const M _m303 = lanes_both(_m296, here);
                {
                    const LANES(court_backboard_normal_out) _o304 =
                        LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m303, _o304.nx, nx);
                    ny = lanes_select(_m303, _o304.ny, ny);
                    nz = lanes_select(_m303, _o304.nz, nz);
                    const LANES(court_counted_out) _o305 =
                        LANES(court_counted)(count_1);
                    count_1 = lanes_select(_m303, _o305.count, count_1);
                }
                const LANES(court_here_out) _o306 =
                    LANES(court_here)(K(2.0), which);
                here = _o306.here;
                const M _m307 = lanes_both(_m296, here);
                {
                    const LANES(court_bridge_normal_out) _o308 =
                        LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m307, _o308.nx, nx);
                    ny = lanes_select(_m307, _o308.ny, ny);
                    nz = lanes_select(_m307, _o308.nz, nz);
                    const LANES(court_counted_out) _o309 =
                        LANES(court_counted)(count_2);
                    count_2 = lanes_select(_m307, _o309.count, count_2);
                }
                {
                    const double *const _t311[][2] = {
                        {lists->p_ring_friction, lists->p_ring_restitution},
                        {lists->p_backboard_friction, lists->p_backboard_restitution},
                        {lists->p_bridge_friction, lists->p_bridge_restitution},
                    };
                    static const double _t312[][1] = {
                        {0.0},
                        {1.0},
                        {2.0},
                    };
                    for (size_t _k310 = 0; _k310 < 3; _k310++) {
                        const V own_1 = lanes_load(_t311[_k310][0] + (i & varying));
                        const V own_2 = lanes_load(_t311[_k310][1] + (i & varying));
                        const V own_index = K(_t312[_k310][0]);
                        const LANES(court_here_out) _o313 =
                            LANES(court_here)(own_index, which);
                        M here = _o313.here;
                        const M _m314 = lanes_both(_m296, here);
                        if (lanes_any(_m314)) {
                            const LANES(court_ring_impact_out) _o315 =
                                LANES(court_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, own_2, own_1, p_tangential_restitution, p_restitution_speed);
                            vx = lanes_select(_m314, _o315.vx, vx);
                            vy = lanes_select(_m314, _o315.vy, vy);
                            vz = lanes_select(_m314, _o315.vz, vz);
                            wx = lanes_select(_m314, _o315.wx, wx);
                            wy = lanes_select(_m314, _o315.wy, wy);
                            wz = lanes_select(_m314, _o315.wz, wz);
                        }
                    }
                }
                const M _m316 = lanes_both(_m296, touches);
                {
                    const LANES(court_touched_out) _o317 =
                        LANES(court_touched)(body, first, which);
                    first = lanes_select(_m316, _o317.first, first);
                    last = lanes_select(_m316, _o317.last, last);
                }
                const M _m318 = lanes_both(_m296, touches);
                if (lanes_any(_m318)) {
                    const LANES(court_slowed_out) _o319 =
                        LANES(court_slowed)(p_ball_radius, nx, ny, nz, vx, vy, vz);
                    M slow = _o319.slow;
                    const M _m320 = lanes_both(_m318, slow);
                    if (lanes_any(_m320)) {
                        const LANES(court_gripped_out) _o321 =
                            LANES(court_gripped)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
                        V rolled_x = _o321.rolled_x;
                        V rolled_y = _o321.rolled_y;
                        V rolled_z = _o321.rolled_z;
                        V slip = _o321.slip;
                        V bounce = _o321.bounce;
                        const LANES(court_here_out) _o322 =
                            LANES(court_here)(K(0.0), which);
                        M here = _o322.here;
                        const M _m323 = lanes_both(_m320, here);
                        if (lanes_any(_m323)) {
                            const LANES(court_ring_turning_out) _o324 =
                                LANES(court_ring_turning)(p_ball_radius, p_ring_radius, rolled_x, rolled_y, rolled_z, p_wire_radius, x, y);
                            V turning_x = _o324.turning_x;
                            V turning_y = _o324.turning_y;
                            V turning_z = _o324.turning_z;
                            const LANES(court_pressed_on_out) _o325 =
                                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
                            V press = _o325.press;
                            V weight = _o325.weight;
                            V drag = _o325.drag;
                            V thrust_x = _o325.thrust_x;
                            V thrust_y = _o325.thrust_y;
                            V thrust_z = _o325.thrust_z;
                            const LANES(court_alone_out) _o326 =
                                LANES(court_alone)();
                            V nearest = _o326.nearest;
                            V wedge = _o326.wedge;
                            const LANES(court_backboard_closing_out) _o327 =
                                LANES(court_backboard_closing)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z);
                            V gap = _o327.gap;
                            V nearing = _o327.nearing;
                            V swerve = _o327.swerve;
                            V facing = _o327.facing;
                            const LANES(court_neared_body_out) _o328 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o328.nearest;
                            wedge = _o328.wedge;
                            const LANES(court_bridge_closing_out) _o329 =
                                LANES(court_bridge_closing)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
                            gap = _o329.gap;
                            nearing = _o329.nearing;
                            swerve = _o329.swerve;
                            facing = _o329.facing;
                            const LANES(court_neared_body_out) _o330 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o330.nearest;
                            wedge = _o330.wedge;
                            const LANES(court_end_beside_out) _o331 =
                                LANES(court_end_beside)(p_end_depth, vz, z);
                            gap = _o331.gap;
                            const LANES(court_neared_out) _o332 =
                                LANES(court_neared)(gap, nearest);
                            nearest = _o332.nearest;
                            const LANES(court_ring_parting_out) _o333 =
                                LANES(court_ring_parting)(p_gravity, p_ring_radius, vx, vy, vz, x, y, z);
                            V lift = _o333.lift;
                            const LANES(court_ring_impact_settling_out) _o334 =
                                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_ring_friction, p_ring_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz);
                            M settles = _o334.settles;
                            M lodges = _o334.lodges;
                            M slides = _o334.slides;
                            M parts = _o334.parts;
                            M unsure = _o334.unsure;
                            const LANES(court_settled_out) _o335 =
                                LANES(court_settled)(K(0.0), lodges, outcome, parts, settles, slides, K(0.0), unsure);
                            mode = lanes_select(_m323, _o335.mode, mode);
                            held = lanes_select(_m323, _o335.held, held);
                            outcome = lanes_select(_m323, _o335.outcome, outcome);
                            slip_left = lanes_select(_m323, _o335.slip_left, slip_left);
                        }
                        const LANES(court_here_out) _o336 =
                            LANES(court_here)(K(1.0), which);
                        here = _o336.here;
                        const M _m337 = lanes_both(_m320, here);
                        if (lanes_any(_m337)) {
                            const LANES(court_backboard_turning_out) _o338 =
                                LANES(court_backboard_turning)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, rolled_x, rolled_y, rolled_z, x, y, z);
                            V turning_x = _o338.turning_x;
                            V turning_y = _o338.turning_y;
                            V turning_z = _o338.turning_z;
                            const LANES(court_pressed_on_out) _o339 =
                                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
                            V press = _o339.press;
                            V weight = _o339.weight;
                            V drag = _o339.drag;
                            V thrust_x = _o339.thrust_x;
                            V thrust_y = _o339.thrust_y;
                            V thrust_z = _o339.thrust_z;
                            const LANES(court_alone_out) _o340 =
                                LANES(court_alone)();
                            V nearest = _o340.nearest;
                            V wedge = _o340.wedge;
                            const LANES(court_ring_closing_out) _o341 =
                                LANES(court_ring_closing)(p_ball_radius, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
                            V gap = _o341.gap;
                            V nearing = _o341.nearing;
                            V swerve = _o341.swerve;
                            V facing = _o341.facing;
                            const LANES(court_neared_body_out) _o342 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o342.nearest;
                            wedge = _o342.wedge;
                            const LANES(court_bridge_closing_out) _o343 =
                                LANES(court_bridge_closing)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
                            gap = _o343.gap;
                            nearing = _o343.nearing;
                            swerve = _o343.swerve;
                            facing = _o343.facing;
                            const LANES(court_neared_body_out) _o344 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o344.nearest;
                            wedge = _o344.wedge;
                            const LANES(court_end_beside_out) _o345 =
                                LANES(court_end_beside)(p_end_depth, vz, z);
                            gap = _o345.gap;
                            const LANES(court_neared_out) _o346 =
                                LANES(court_neared)(gap, nearest);
                            nearest = _o346.nearest;
                            const LANES(court_backboard_parting_out) _o347 =
                                LANES(court_backboard_parting)(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, vx, vy, vz, x, y, z);
                            V lift = _o347.lift;
                            const LANES(court_ring_impact_settling_out) _o348 =
                                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_backboard_friction, p_backboard_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz);
                            M settles = _o348.settles;
                            M lodges = _o348.lodges;
                            M slides = _o348.slides;
                            M parts = _o348.parts;
                            M unsure = _o348.unsure;
                            const LANES(court_settled_out) _o349 =
                                LANES(court_settled)(K(1.0), lodges, outcome, parts, settles, slides, K(0.0), unsure);
                            mode = lanes_select(_m337, _o349.mode, mode);
                            held = lanes_select(_m337, _o349.held, held);
                            outcome = lanes_select(_m337, _o349.outcome, outcome);
                            slip_left = lanes_select(_m337, _o349.slip_left, slip_left);
                        }
                        const LANES(court_here_out) _o350 =
                            LANES(court_here)(K(2.0), which);
                        here = _o350.here;
                        const M _m351 = lanes_both(_m320, here);
                        if (lanes_any(_m351)) {
                            const LANES(court_bridge_turning_out) _o352 =
                                LANES(court_bridge_turning)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, rolled_x, rolled_y, rolled_z, p_wire_radius, x, y, z);
                            V turning_x = _o352.turning_x;
                            V turning_y = _o352.turning_y;
                            V turning_z = _o352.turning_z;
                            const LANES(court_pressed_on_out) _o353 =
                                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
                            V press = _o353.press;
                            V weight = _o353.weight;
                            V drag = _o353.drag;
                            V thrust_x = _o353.thrust_x;
                            V thrust_y = _o353.thrust_y;
                            V thrust_z = _o353.thrust_z;
                            const LANES(court_alone_out) _o354 =
                                LANES(court_alone)();
                            V nearest = _o354.nearest;
                            V wedge = _o354.wedge;
                            const LANES(court_ring_closing_out) _o355 =
                                LANES(court_ring_closing)(p_ball_radius, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
                            V gap = _o355.gap;
                            V nearing = _o355.nearing;
                            V swerve = _o355.swerve;
                            V facing = _o355.facing;
                            const LANES(court_neared_body_out) _o356 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o356.nearest;
                            wedge = _o356.wedge;
                            const LANES(court_backboard_closing_out) _o357 =
                                LANES(court_backboard_closing)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z);
                            gap = _o357.gap;
                            nearing = _o357.nearing;
                            swerve = _o357.swerve;
                            facing = _o357.facing;
                            const LANES(court_neared_body_out) _o358 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o358.nearest;
                            wedge = _o358.wedge;
                            const LANES(court_end_beside_out) _o359 =
                                LANES(court_end_beside)(p_end_depth, vz, z);
                            gap = _o359.gap;
                            const LANES(court_neared_out) _o360 =
                                LANES(court_neared)(gap, nearest);
                            nearest = _o360.nearest;
                            const LANES(court_bridge_parting_out) _o361 =
                                LANES(court_bridge_parting)(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                            V lift = _o361.lift;
                            const LANES(court_ring_impact_settling_out) _o362 =
                                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_bridge_friction, p_bridge_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, K(0.0), wedge, weight, wx, wy, wz);
                            M settles = _o362.settles;
                            M lodges = _o362.lodges;
                            M slides = _o362.slides;
                            M parts = _o362.parts;
                            M unsure = _o362.unsure;
                            const LANES(court_settled_out) _o363 =
                                LANES(court_settled)(K(2.0), lodges, outcome, parts, settles, slides, K(0.0), unsure);
                            mode = lanes_select(_m351, _o363.mode, mode);
                            held = lanes_select(_m351, _o363.held, held);
                            outcome = lanes_select(_m351, _o363.outcome, outcome);
                            slip_left = lanes_select(_m351, _o363.slip_left, slip_left);
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
    _Alignas(64) size_t shot[LANES_SHOTS];
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
    /* Shots whose balls stay in contact: they wait for one another. */
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
    LANES(court_column) kept_rolling_p_ring_friction;
    LANES(court_column) kept_rolling_p_ring_radius;
    LANES(court_column) kept_rolling_p_wire_radius;
    LANES(court_column) kept_rolling_per_reach;
    LANES(court_column) kept_rolling_ring;
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
    const size_t room = LANES_SHOTS - row, shots = lists->waiting < room ? lists->waiting : room;
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
        if (lists->waiting >= LANES_SHOTS / 2 || (shots == 0 && begun == job->shots)) {
            shots += LANES(court_bounded_resume)(lists, shots, job);
            following = 0;
        }
        const size_t fresh = shots;
        if (begun < job->shots) {
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
            const LANES(court_opens_out) _o24 =
                LANES(court_opens)(clear);
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
            const LANES(court_opens_out) _o58 =
                LANES(court_opens)(clear);
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
            const LANES(court_opens_out) _o92 =
                LANES(court_opens)(clear);
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
        {
        size_t kept_rolling_shots = 0;
        for (size_t i = 0; i < kept_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(kept_shots - i);
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
            const V p_ring_friction = lanes_load(varying ? lists->kept_p_ring_friction + i : lists->p_ring_friction);
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
            V ring = _o128.ring;
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
            }
            lanes_store(lists->kept_began + i, began);
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
                    lanes_pack(lists->kept_rolling_p_ring_friction + kept_rolling_shots, packed, p_ring_friction);
                if (varying)
                    lanes_pack(lists->kept_rolling_p_ring_radius + kept_rolling_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->kept_rolling_p_wire_radius + kept_rolling_shots, packed, p_wire_radius);
                lanes_pack(lists->kept_rolling_per_reach + kept_rolling_shots, packed, per_reach);
                lanes_pack(lists->kept_rolling_ring + kept_rolling_shots, packed, ring);
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
            V p_ring_friction = lanes_load(lists->p_ring_friction);
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
            V ring = K(0.0);
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
                    ring = lanes_expand(lists->kept_rolling_ring + taken, idle, ring);
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
                        p_ring_friction = lanes_expand(lists->kept_rolling_p_ring_friction + taken, idle, p_ring_friction);
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
                const LANES(court_error_bounds_out) _o154 =
                    LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
                V position_error = _o154.position_error;
                V velocity_error = _o154.velocity_error;
                const LANES(court_holding_out) _o155 =
                    LANES(court_holding)(held, K(0.0));
                M here = _o155.here;
                const M _m156 = lanes_both(active, here);
                if (lanes_any(_m156)) {
                    const LANES(court_ring_normal_out) _o157 =
                        LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m156, _o157.nx, nx);
                    ny = lanes_select(_m156, _o157.ny, ny);
                    nz = lanes_select(_m156, _o157.nz, nz);
                    const LANES(court_ring_tube_out) _o158 =
                        LANES(court_ring_tube)(p_ball_radius, p_ring_radius, p_wire_radius);
                    bent_x = lanes_select(_m156, _o158.bent_x, bent_x);
                    bent_y = lanes_select(_m156, _o158.bent_y, bent_y);
                    bent_z = lanes_select(_m156, _o158.bent_z, bent_z);
                    per_reach = lanes_select(_m156, _o158.per_reach, per_reach);
                    ring = lanes_select(_m156, _o158.ring, ring);
                }
                const LANES(court_holding_out) _o159 =
                    LANES(court_holding)(held, K(1.0));
                here = _o159.here;
                const M _m160 = lanes_both(active, here);
                if (lanes_any(_m160)) {
                    const LANES(court_backboard_normal_out) _o161 =
                        LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m160, _o161.nx, nx);
                    ny = lanes_select(_m160, _o161.ny, ny);
                    nz = lanes_select(_m160, _o161.nz, nz);
                    const LANES(court_backboard_tube_out) _o162 =
                        LANES(court_backboard_tube)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                    bent_x = lanes_select(_m160, _o162.bent_x, bent_x);
                    bent_y = lanes_select(_m160, _o162.bent_y, bent_y);
                    bent_z = lanes_select(_m160, _o162.bent_z, bent_z);
                    per_reach = lanes_select(_m160, _o162.per_reach, per_reach);
                    ring = lanes_select(_m160, _o162.ring, ring);
                }
                const LANES(court_holding_out) _o163 =
                    LANES(court_holding)(held, K(2.0));
                here = _o163.here;
                const M _m164 = lanes_both(active, here);
                if (lanes_any(_m164)) {
                    const LANES(court_bridge_normal_out) _o165 =
                        LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m164, _o165.nx, nx);
                    ny = lanes_select(_m164, _o165.ny, ny);
                    nz = lanes_select(_m164, _o165.nz, nz);
                    const LANES(court_bridge_tube_out) _o166 =
                        LANES(court_bridge_tube)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                    bent_x = lanes_select(_m164, _o166.bent_x, bent_x);
                    bent_y = lanes_select(_m164, _o166.bent_y, bent_y);
                    bent_z = lanes_select(_m164, _o166.bent_z, bent_z);
                    per_reach = lanes_select(_m164, _o166.per_reach, per_reach);
                    ring = lanes_select(_m164, _o166.ring, ring);
                }
                const LANES(court_roll_start_out) _o167 =
                    LANES(court_roll_start)(p_ball_radius, nx, ny, nz, ring, vx, vy, vz, wx, wy, wz, x, y);
                V vx_0 = _o167.vx_0;
                V vy_0 = _o167.vy_0;
                V vz_0 = _o167.vz_0;
                V nx_0 = _o167.nx_0;
                V ny_0 = _o167.ny_0;
                V nz_0 = _o167.nz_0;
                V turn_rate_0 = _o167.turn_rate_0;
                V cos_0 = _o167.cos_0;
                V sin_0 = _o167.sin_0;
                V near_0 = _o167.near_0;
                const LANES(court_roll_0_out) _o168 =
                    LANES(court_roll_0)(bent_x, bent_y, bent_z, cos_0, p_gravity, near_0, nx_0, ny_0, nz_0, per_reach, ring, sin_0, turn_rate_0, vx_0, vy_0, vz_0);
                V across_0 = _o168.across_0;
                V round_0 = _o168.round_0;
                V lift_0 = _o168.lift_0;
                V tx_0 = _o168.tx_0;
                V ty_0 = _o168.ty_0;
                V tz_0 = _o168.tz_0;
                V vx_1 = _o168.vx_1;
                V vy_1 = _o168.vy_1;
                V vz_1 = _o168.vz_1;
                V nx_1 = _o168.nx_1;
                V ny_1 = _o168.ny_1;
                V nz_1 = _o168.nz_1;
                V turn_rate_1 = _o168.turn_rate_1;
                V cos_1 = _o168.cos_1;
                V sin_1 = _o168.sin_1;
                V widened_1 = _o168.widened_1;
                V near_1 = _o168.near_1;
                const LANES(court_roll_1_out) _o169 =
                    LANES(court_roll_1)(across_0, bent_x, bent_y, bent_z, cos_0, cos_1, p_gravity, lift_0, near_0, near_1, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, ring, round_0, sin_0, sin_1, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1, widened_1);
                V across_1 = _o169.across_1;
                V round_1 = _o169.round_1;
                V lift_1 = _o169.lift_1;
                V tx_1 = _o169.tx_1;
                V ty_1 = _o169.ty_1;
                V tz_1 = _o169.tz_1;
                V vx_2 = _o169.vx_2;
                V vy_2 = _o169.vy_2;
                V vz_2 = _o169.vz_2;
                V nx_2 = _o169.nx_2;
                V ny_2 = _o169.ny_2;
                V nz_2 = _o169.nz_2;
                V turn_rate_2 = _o169.turn_rate_2;
                V cos_2 = _o169.cos_2;
                V sin_2 = _o169.sin_2;
                V widened_2 = _o169.widened_2;
                V near_2 = _o169.near_2;
                const LANES(court_roll_2_out) _o170 =
                    LANES(court_roll_2)(across_0, across_1, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, p_gravity, lift_0, lift_1, near_0, near_1, near_2, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, ring, round_0, round_1, sin_0, sin_1, sin_2, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2, widened_1, widened_2);
                V across_2 = _o170.across_2;
                V round_2 = _o170.round_2;
                V lift_2 = _o170.lift_2;
                V tx_2 = _o170.tx_2;
                V ty_2 = _o170.ty_2;
                V tz_2 = _o170.tz_2;
                V vx_3 = _o170.vx_3;
                V vy_3 = _o170.vy_3;
                V vz_3 = _o170.vz_3;
                V nx_3 = _o170.nx_3;
                V ny_3 = _o170.ny_3;
                V nz_3 = _o170.nz_3;
                V turn_rate_3 = _o170.turn_rate_3;
                V cos_3 = _o170.cos_3;
                V sin_3 = _o170.sin_3;
                V widened_3 = _o170.widened_3;
                V near_3 = _o170.near_3;
                const LANES(court_roll_3_out) _o171 =
                    LANES(court_roll_3)(across_0, across_1, across_2, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, p_gravity, lift_0, lift_1, lift_2, near_0, near_1, near_2, near_3, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, ring, round_0, round_1, round_2, sin_0, sin_1, sin_2, sin_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3, widened_1, widened_2, widened_3);
                V across_3 = _o171.across_3;
                V round_3 = _o171.round_3;
                V lift_3 = _o171.lift_3;
                V tx_3 = _o171.tx_3;
                V ty_3 = _o171.ty_3;
                V tz_3 = _o171.tz_3;
                V vx_4 = _o171.vx_4;
                V vy_4 = _o171.vy_4;
                V vz_4 = _o171.vz_4;
                V nx_4 = _o171.nx_4;
                V ny_4 = _o171.ny_4;
                V nz_4 = _o171.nz_4;
                V turn_rate_4 = _o171.turn_rate_4;
                V cos_4 = _o171.cos_4;
                V sin_4 = _o171.sin_4;
                V widened_4 = _o171.widened_4;
                V near_4 = _o171.near_4;
                const LANES(court_roll_4_out) _o172 =
                    LANES(court_roll_4)(across_0, across_1, across_2, across_3, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, cos_4, p_gravity, lift_0, lift_1, lift_2, lift_3, near_0, near_1, near_2, near_3, near_4, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, ring, round_0, round_1, round_2, round_3, sin_0, sin_1, sin_2, sin_3, sin_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4, widened_1, widened_2, widened_3, widened_4);
                V across_4 = _o172.across_4;
                V round_4 = _o172.round_4;
                V lift_4 = _o172.lift_4;
                V tx_4 = _o172.tx_4;
                V ty_4 = _o172.ty_4;
                V tz_4 = _o172.tz_4;
                V vx_5 = _o172.vx_5;
                V vy_5 = _o172.vy_5;
                V vz_5 = _o172.vz_5;
                V nx_5 = _o172.nx_5;
                V ny_5 = _o172.ny_5;
                V nz_5 = _o172.nz_5;
                V turn_rate_5 = _o172.turn_rate_5;
                V cos_5 = _o172.cos_5;
                V sin_5 = _o172.sin_5;
                V widened_5 = _o172.widened_5;
                V near_5 = _o172.near_5;
                const LANES(court_roll_5_out) _o173 =
                    LANES(court_roll_5)(across_0, across_1, across_2, across_3, across_4, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, near_0, near_1, near_2, near_3, near_4, near_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, ring, round_0, round_1, round_2, round_3, round_4, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, widened_1, widened_2, widened_3, widened_4, widened_5);
                V across_5 = _o173.across_5;
                V round_5 = _o173.round_5;
                V lift_5 = _o173.lift_5;
                V tx_5 = _o173.tx_5;
                V ty_5 = _o173.ty_5;
                V tz_5 = _o173.tz_5;
                V vx_6 = _o173.vx_6;
                V vy_6 = _o173.vy_6;
                V vz_6 = _o173.vz_6;
                V nx_6 = _o173.nx_6;
                V ny_6 = _o173.ny_6;
                V nz_6 = _o173.nz_6;
                V turn_rate_6 = _o173.turn_rate_6;
                V cos_6 = _o173.cos_6;
                V sin_6 = _o173.sin_6;
                V widened_6 = _o173.widened_6;
                V near_6 = _o173.near_6;
                const LANES(court_roll_6_out) _o174 =
                    LANES(court_roll_6)(across_0, across_1, across_2, across_3, across_4, across_5, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, near_0, near_1, near_2, near_3, near_4, near_5, near_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, ring, round_0, round_1, round_2, round_3, round_4, round_5, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, widened_1, widened_2, widened_3, widened_4, widened_5, widened_6);
                V across_6 = _o174.across_6;
                V round_6 = _o174.round_6;
                V lift_6 = _o174.lift_6;
                V tx_6 = _o174.tx_6;
                V ty_6 = _o174.ty_6;
                V tz_6 = _o174.tz_6;
                V vx_7 = _o174.vx_7;
                V vy_7 = _o174.vy_7;
                V vz_7 = _o174.vz_7;
                V nx_7 = _o174.nx_7;
                V ny_7 = _o174.ny_7;
                V nz_7 = _o174.nz_7;
                V turn_rate_7 = _o174.turn_rate_7;
                V cos_7 = _o174.cos_7;
                V sin_7 = _o174.sin_7;
                V widened_7 = _o174.widened_7;
                V near_7 = _o174.near_7;
                const LANES(court_roll_7_out) _o175 =
                    LANES(court_roll_7)(across_0, across_1, across_2, across_3, across_4, across_5, across_6, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, ring, round_0, round_1, round_2, round_3, round_4, round_5, round_6, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, widened_1, widened_2, widened_3, widened_4, widened_5, widened_6, widened_7);
                V lift_7 = _o175.lift_7;
                V vx_8 = _o175.vx_8;
                V vy_8 = _o175.vy_8;
                V vz_8 = _o175.vz_8;
                V nx_8 = _o175.nx_8;
                V ny_8 = _o175.ny_8;
                V nz_8 = _o175.nz_8;
                V turn_rate_8 = _o175.turn_rate_8;
                const LANES(court_roll_pace_out) _o176 =
                    LANES(court_roll_pace)(p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, lift_7, nx_8, ny_8, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, nz_8, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8);
                V stride = _o176.stride;
                V strongest = _o176.strongest;
                V fastest = _o176.fastest;
                V force = _o176.force;
                V force_rate = _o176.force_rate;
                V force_bend = _o176.force_bend;
                const LANES(court_pulled_out) _o177 =
                    LANES(court_pulled)(p_gravity, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, turn_rate_0, turn_rate_1, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1);
                V drag = _o177.drag;
                V drag_rate = _o177.drag_rate;
                V strain = _o177.strain;
                V strain_rate = _o177.strain_rate;
                const LANES(court_holding_out) _o178 =
                    LANES(court_holding)(held, K(0.0));
                here = _o178.here;
                const M _m179 = lanes_both(active, here);
                {
                    const LANES(court_ring_impact_strained_out) _o180 =
                        LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, p_ring_friction);
                    strain = lanes_select(_m179, _o180.strain, strain);
                    strain_rate = lanes_select(_m179, _o180.strain_rate, strain_rate);
                }
                const LANES(court_holding_out) _o181 =
                    LANES(court_holding)(held, K(1.0));
                here = _o181.here;
                const M _m182 = lanes_both(active, here);
                {
                    const LANES(court_ring_impact_strained_out) _o183 =
                        LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, p_backboard_friction);
                    strain = lanes_select(_m182, _o183.strain, strain);
                    strain_rate = lanes_select(_m182, _o183.strain_rate, strain_rate);
                }
                const LANES(court_holding_out) _o184 =
                    LANES(court_holding)(held, K(2.0));
                here = _o184.here;
                const M _m185 = lanes_both(active, here);
                {
                    const LANES(court_ring_impact_strained_out) _o186 =
                        LANES(court_ring_impact_strained)(drag, drag_rate, force, force_rate, p_bridge_friction);
                    strain = lanes_select(_m185, _o186.strain, strain);
                    strain_rate = lanes_select(_m185, _o186.strain_rate, strain_rate);
                }
                const LANES(court_losing_out) _o187 =
                    LANES(court_losing)(grip_lost, strain);
                M loses = _o187.loses;
                const M _m188 = lanes_both(active, loses);
                if (lanes_any(_m188)) {
                    const LANES(court_lost_grip_out) _o189 =
                        LANES(court_lost_grip)(clock, strain, strain_rate, taut, taut_clock, taut_rate);
                    grip_lost = lanes_select(_m188, _o189.grip_lost, grip_lost);
                }
                const LANES(court_tightened_out) _o190 =
                    LANES(court_tightened)(clock, strain, strain_rate);
                taut = _o190.taut;
                taut_rate = _o190.taut_rate;
                taut_clock = _o190.taut_clock;
                const LANES(court_leaving_force_out) _o191 =
                    LANES(court_leaving_force)(p_ball_radius, doubt, fastest, force, force_bend, force_rate, p_gravity, per_reach, position_error, stride, velocity_error, vx, vx_1, vy, vy_1, vz, vz_1, which);
                stride = _o191.stride;
                which = _o191.which;
                M rests = _o191.rests;
                doubt = _o191.doubt;
                const LANES(court_beside_out) _o192 =
                    LANES(court_beside)(held, K(0.0));
                M beside = _o192.beside;
                const M _m193 = lanes_both(active, beside);
                if (lanes_any(_m193)) {
                    const LANES(court_ring_beside_out) _o194 =
                        LANES(court_ring_beside)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                    V gap = _o194.gap;
                    V nearing = _o194.nearing;
                    V dent = _o194.dent;
                    const LANES(court_beside_body_out) _o195 =
                        LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(0.0), late, nearing, position_error, stride, strongest, which, x, y, z);
                    stride = lanes_select(_m193, _o195.stride, stride);
                    which = lanes_select(_m193, _o195.which, which);
                    doubt = lanes_select(_m193, _o195.doubt, doubt);
                    late = lanes_select(_m193, _o195.late, late);
                }
                const LANES(court_beside_out) _o196 =
                    LANES(court_beside)(held, K(1.0));
                beside = _o196.beside;
                const M _m197 = lanes_both(active, beside);
                if (lanes_any(_m197)) {
                    const LANES(court_backboard_beside_out) _o198 =
                        LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                    V gap = _o198.gap;
                    V nearing = _o198.nearing;
                    V dent = _o198.dent;
                    const LANES(court_beside_body_out) _o199 =
                        LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(1.0), late, nearing, position_error, stride, strongest, which, x, y, z);
                    stride = lanes_select(_m197, _o199.stride, stride);
                    which = lanes_select(_m197, _o199.which, which);
                    doubt = lanes_select(_m197, _o199.doubt, doubt);
                    late = lanes_select(_m197, _o199.late, late);
                }
                const LANES(court_beside_out) _o200 =
                    LANES(court_beside)(held, K(2.0));
                beside = _o200.beside;
                const M _m201 = lanes_both(active, beside);
                if (lanes_any(_m201)) {
                    const LANES(court_bridge_beside_out) _o202 =
                        LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                    V gap = _o202.gap;
                    V nearing = _o202.nearing;
                    V dent = _o202.dent;
                    const LANES(court_beside_body_out) _o203 =
                        LANES(court_beside_body)(p_ball_radius, dent, doubt, fastest, gap, K(2.0), late, nearing, position_error, stride, strongest, which, x, y, z);
                    stride = lanes_select(_m201, _o203.stride, stride);
                    which = lanes_select(_m201, _o203.which, which);
                    doubt = lanes_select(_m201, _o203.doubt, doubt);
                    late = lanes_select(_m201, _o203.late, late);
                }
                const LANES(court_end_beside_out) _o204 =
                    LANES(court_end_beside)(p_end_depth, vz, z);
                V gap = _o204.gap;
                V nearing = _o204.nearing;
                V dent = _o204.dent;
                const LANES(court_beside_gate_out) _o205 =
                    LANES(court_beside_gate)(p_ball_radius, dent, doubt, fastest, gap, K(3.0), late, nearing, position_error, stride, strongest, which, x, y, z);
                stride = _o205.stride;
                which = _o205.which;
                doubt = _o205.doubt;
                late = _o205.late;
                const LANES(court_holding_out) _o206 =
                    LANES(court_holding)(held, K(1.0));
                here = _o206.here;
                const M _m207 = lanes_both(active, here);
                if (lanes_any(_m207)) {
                    const LANES(court_backboard_seam0_out) _o208 =
                        LANES(court_backboard_seam0)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                    gap = lanes_select(_m207, _o208.gap, gap);
                    V nearing = _o208.nearing;
                    V near = _o208.near;
                    const LANES(court_beside_seam_out) _o209 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m207, _o209.stride, stride);
                    const LANES(court_backboard_seam1_out) _o210 =
                        LANES(court_backboard_seam1)(p_ball_radius, p_board_distance, p_board_thickness, vx, x);
                    gap = lanes_select(_m207, _o210.gap, gap);
                    nearing = _o210.nearing;
                    near = _o210.near;
                    const LANES(court_beside_seam_out) _o211 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m207, _o211.stride, stride);
                    const LANES(court_backboard_seam2_out) _o212 =
                        LANES(court_backboard_seam2)(p_ball_radius, p_board_half_width, vy, y);
                    gap = lanes_select(_m207, _o212.gap, gap);
                    nearing = _o212.nearing;
                    near = _o212.near;
                    const LANES(court_beside_seam_out) _o213 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m207, _o213.stride, stride);
                    const LANES(court_backboard_seam3_out) _o214 =
                        LANES(court_backboard_seam3)(p_ball_radius, p_board_half_width, vy, y);
                    gap = lanes_select(_m207, _o214.gap, gap);
                    nearing = _o214.nearing;
                    near = _o214.near;
                    const LANES(court_beside_seam_out) _o215 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m207, _o215.stride, stride);
                    const LANES(court_backboard_seam4_out) _o216 =
                        LANES(court_backboard_seam4)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                    gap = lanes_select(_m207, _o216.gap, gap);
                    nearing = _o216.nearing;
                    near = _o216.near;
                    const LANES(court_beside_seam_out) _o217 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m207, _o217.stride, stride);
                    const LANES(court_backboard_seam5_out) _o218 =
                        LANES(court_backboard_seam5)(p_ball_radius, p_board_bottom, p_board_top, vz, z);
                    gap = lanes_select(_m207, _o218.gap, gap);
                    nearing = _o218.nearing;
                    near = _o218.near;
                    const LANES(court_beside_seam_out) _o219 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m207, _o219.stride, stride);
                }
                const LANES(court_holding_out) _o220 =
                    LANES(court_holding)(held, K(2.0));
                here = _o220.here;
                const M _m221 = lanes_both(active, here);
                if (lanes_any(_m221)) {
                    const LANES(court_bridge_seam0_out) _o222 =
                        LANES(court_bridge_seam0)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                    gap = lanes_select(_m221, _o222.gap, gap);
                    V nearing = _o222.nearing;
                    V near = _o222.near;
                    const LANES(court_beside_seam_out) _o223 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m221, _o223.stride, stride);
                    const LANES(court_bridge_seam1_out) _o224 =
                        LANES(court_bridge_seam1)(p_ball_radius, p_board_distance, p_ring_radius, vx, x);
                    gap = lanes_select(_m221, _o224.gap, gap);
                    nearing = _o224.nearing;
                    near = _o224.near;
                    const LANES(court_beside_seam_out) _o225 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m221, _o225.stride, stride);
                    const LANES(court_bridge_seam2_out) _o226 =
                        LANES(court_bridge_seam2)(p_ball_radius, p_bridge_half_width, vy, y);
                    gap = lanes_select(_m221, _o226.gap, gap);
                    nearing = _o226.nearing;
                    near = _o226.near;
                    const LANES(court_beside_seam_out) _o227 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m221, _o227.stride, stride);
                    const LANES(court_bridge_seam3_out) _o228 =
                        LANES(court_bridge_seam3)(p_ball_radius, p_bridge_half_width, vy, y);
                    gap = lanes_select(_m221, _o228.gap, gap);
                    nearing = _o228.nearing;
                    near = _o228.near;
                    const LANES(court_beside_seam_out) _o229 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m221, _o229.stride, stride);
                    const LANES(court_bridge_seam4_out) _o230 =
                        LANES(court_bridge_seam4)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                    gap = lanes_select(_m221, _o230.gap, gap);
                    nearing = _o230.nearing;
                    near = _o230.near;
                    const LANES(court_beside_seam_out) _o231 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m221, _o231.stride, stride);
                    const LANES(court_bridge_seam5_out) _o232 =
                        LANES(court_bridge_seam5)(p_ball_radius, p_bridge_depth, vz, p_wire_radius, z);
                    gap = lanes_select(_m221, _o232.gap, gap);
                    nearing = _o232.nearing;
                    near = _o232.near;
                    const LANES(court_beside_seam_out) _o233 =
                        LANES(court_beside_seam)(fastest, gap, near, nearing, stride, strongest);
                    stride = lanes_select(_m221, _o233.stride, stride);
                }
                const LANES(court_beside_time_out) _o234 =
                    LANES(court_beside_time)(clock, stride, time_limit, which);
                stride = _o234.stride;
                which = _o234.which;
                const LANES(court_apart_out) _o235 =
                    LANES(court_apart)(p_ball_radius, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz);
                V apart = _o235.apart;
                const LANES(court_neighbour_out) _o236 =
                    LANES(court_neighbour)(apart, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, vx, vy, vz, wx, wy, wz, x, y, z);
                V far_x = _o236.far_x;
                V far_y = _o236.far_y;
                V far_z = _o236.far_z;
                V far_vx = _o236.far_vx;
                V far_vy = _o236.far_vy;
                V far_vz = _o236.far_vz;
                V far_wx = _o236.far_wx;
                V far_wy = _o236.far_wy;
                V far_wz = _o236.far_wz;
                const LANES(court_passing_from_out) _o237 =
                    LANES(court_passing_from)(z);
                M over = _o237.over;
                const LANES(court_roll_moved_out) _o238 =
                    LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, x, y, z);
                x = _o238.x;
                vx = _o238.vx;
                y = _o238.y;
                vy = _o238.vy;
                z = _o238.z;
                vz = _o238.vz;
                V turn_rate = _o238.turn_rate;
                const LANES(court_holding_out) _o239 =
                    LANES(court_holding)(held, K(0.0));
                here = _o239.here;
                const M _m240 = lanes_both(active, here);
                if (lanes_any(_m240)) {
                    const LANES(court_ring_normal_out) _o241 =
                        LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m240, _o241.nx, nx);
                    ny = lanes_select(_m240, _o241.ny, ny);
                    nz = lanes_select(_m240, _o241.nz, nz);
                    const LANES(court_ring_off_out) _o242 =
                        LANES(court_ring_off)(p_ball_radius, p_ring_radius, p_wire_radius, x, y, z);
                    gap = lanes_select(_m240, _o242.gap, gap);
                }
                const LANES(court_holding_out) _o243 =
                    LANES(court_holding)(held, K(1.0));
                here = _o243.here;
                const M _m244 = lanes_both(active, here);
                if (lanes_any(_m244)) {
                    const LANES(court_backboard_normal_out) _o245 =
                        LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m244, _o245.nx, nx);
                    ny = lanes_select(_m244, _o245.ny, ny);
                    nz = lanes_select(_m244, _o245.nz, nz);
                    const LANES(court_backboard_off_out) _o246 =
                        LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z);
                    gap = lanes_select(_m244, _o246.gap, gap);
                }
                const LANES(court_holding_out) _o247 =
                    LANES(court_holding)(held, K(2.0));
                here = _o247.here;
                const M _m248 = lanes_both(active, here);
                if (lanes_any(_m248)) {
                    const LANES(court_bridge_normal_out) _o249 =
                        LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m248, _o249.nx, nx);
                    ny = lanes_select(_m248, _o249.ny, ny);
                    nz = lanes_select(_m248, _o249.nz, nz);
                    const LANES(court_bridge_off_out) _o250 =
                        LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z);
                    gap = lanes_select(_m248, _o250.gap, gap);
                }
                const LANES(court_roll_placed_out) _o251 =
                    LANES(court_roll_placed)(p_ball_radius, gap, nx, ny, nz, turn_rate, vx, vy, vz, x, y, z);
                x = _o251.x;
                y = _o251.y;
                z = _o251.z;
                vx = _o251.vx;
                vy = _o251.vy;
                vz = _o251.vz;
                wx = _o251.wx;
                wy = _o251.wy;
                wz = _o251.wz;
                const LANES(court_passing_in_contact_out) _o252 =
                    LANES(court_passing_in_contact)(over, p_ring_radius, through, x, y, z);
                through = _o252.through;
                const LANES(court_holding_out) _o253 =
                    LANES(court_holding)(held, K(0.0));
                here = _o253.here;
                const M _m254 = lanes_both(active, here);
                {
                    const LANES(court_ring_normal_out) _o255 =
                        LANES(court_ring_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m254, _o255.nx, nx);
                    ny = lanes_select(_m254, _o255.ny, ny);
                    nz = lanes_select(_m254, _o255.nz, nz);
                }
                const LANES(court_holding_out) _o256 =
                    LANES(court_holding)(held, K(1.0));
                here = _o256.here;
                const M _m257 = lanes_both(active, here);
                {
                    const LANES(court_backboard_normal_out) _o258 =
                        LANES(court_backboard_normal)(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m257, _o258.nx, nx);
                    ny = lanes_select(_m257, _o258.ny, ny);
                    nz = lanes_select(_m257, _o258.nz, nz);
                }
                const LANES(court_holding_out) _o259 =
                    LANES(court_holding)(held, K(2.0));
                here = _o259.here;
                const M _m260 = lanes_both(active, here);
                {
                    const LANES(court_bridge_normal_out) _o261 =
                        LANES(court_bridge_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m260, _o261.nx, nx);
                    ny = lanes_select(_m260, _o261.ny, ny);
                    nz = lanes_select(_m260, _o261.nz, nz);
                }
                const LANES(court_roll_turn_rate_out) _o262 =
                    LANES(court_roll_turn_rate)(p_ball_radius, nx, ny, nz, far_wx, far_wy, far_wz);
                turn_rate = _o262.turn_rate;
                const LANES(court_holding_out) _o263 =
                    LANES(court_holding)(held, K(0.0));
                here = _o263.here;
                const M _m264 = lanes_both(active, here);
                if (lanes_any(_m264)) {
                    const LANES(court_ring_normal_out) _o265 =
                        LANES(court_ring_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m264, _o265.nx, nx);
                    ny = lanes_select(_m264, _o265.ny, ny);
                    nz = lanes_select(_m264, _o265.nz, nz);
                    const LANES(court_ring_off_out) _o266 =
                        LANES(court_ring_off)(p_ball_radius, p_ring_radius, p_wire_radius, far_x, far_y, far_z);
                    gap = lanes_select(_m264, _o266.gap, gap);
                }
                const LANES(court_holding_out) _o267 =
                    LANES(court_holding)(held, K(1.0));
                here = _o267.here;
                const M _m268 = lanes_both(active, here);
                if (lanes_any(_m268)) {
                    const LANES(court_backboard_normal_out) _o269 =
                        LANES(court_backboard_normal)(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m268, _o269.nx, nx);
                    ny = lanes_select(_m268, _o269.ny, ny);
                    nz = lanes_select(_m268, _o269.nz, nz);
                    const LANES(court_backboard_off_out) _o270 =
                        LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, far_x, far_y, far_z);
                    gap = lanes_select(_m268, _o270.gap, gap);
                }
                const LANES(court_holding_out) _o271 =
                    LANES(court_holding)(held, K(2.0));
                here = _o271.here;
                const M _m272 = lanes_both(active, here);
                if (lanes_any(_m272)) {
                    const LANES(court_bridge_normal_out) _o273 =
                        LANES(court_bridge_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m272, _o273.nx, nx);
                    ny = lanes_select(_m272, _o273.ny, ny);
                    nz = lanes_select(_m272, _o273.nz, nz);
                    const LANES(court_bridge_off_out) _o274 =
                        LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, far_x, far_y, far_z);
                    gap = lanes_select(_m272, _o274.gap, gap);
                }
                const LANES(court_roll_placed_out) _o275 =
                    LANES(court_roll_placed)(p_ball_radius, gap, nx, ny, nz, turn_rate, far_vx, far_vy, far_vz, far_x, far_y, far_z);
                far_x = _o275.x;
                far_y = _o275.y;
                far_z = _o275.z;
                far_vx = _o275.vx;
                far_vy = _o275.vy;
                far_vz = _o275.vz;
                far_wx = _o275.wx;
                far_wy = _o275.wy;
                far_wz = _o275.wz;
                const LANES(court_roll_start_out) _o276 =
                    LANES(court_roll_start)(p_ball_radius, nx, ny, nz, ring, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_x, far_y);
                vx_0 = _o276.vx_0;
                vy_0 = _o276.vy_0;
                vz_0 = _o276.vz_0;
                nx_0 = _o276.nx_0;
                ny_0 = _o276.ny_0;
                nz_0 = _o276.nz_0;
                turn_rate_0 = _o276.turn_rate_0;
                cos_0 = _o276.cos_0;
                sin_0 = _o276.sin_0;
                near_0 = _o276.near_0;
                const LANES(court_roll_0_out) _o277 =
                    LANES(court_roll_0)(bent_x, bent_y, bent_z, cos_0, p_gravity, near_0, nx_0, ny_0, nz_0, per_reach, ring, sin_0, turn_rate_0, vx_0, vy_0, vz_0);
                across_0 = _o277.across_0;
                round_0 = _o277.round_0;
                lift_0 = _o277.lift_0;
                tx_0 = _o277.tx_0;
                ty_0 = _o277.ty_0;
                tz_0 = _o277.tz_0;
                vx_1 = _o277.vx_1;
                vy_1 = _o277.vy_1;
                vz_1 = _o277.vz_1;
                nx_1 = _o277.nx_1;
                ny_1 = _o277.ny_1;
                nz_1 = _o277.nz_1;
                turn_rate_1 = _o277.turn_rate_1;
                cos_1 = _o277.cos_1;
                sin_1 = _o277.sin_1;
                widened_1 = _o277.widened_1;
                near_1 = _o277.near_1;
                const LANES(court_roll_1_out) _o278 =
                    LANES(court_roll_1)(across_0, bent_x, bent_y, bent_z, cos_0, cos_1, p_gravity, lift_0, near_0, near_1, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, per_reach, ring, round_0, sin_0, sin_1, turn_rate_0, turn_rate_1, tx_0, ty_0, tz_0, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1, widened_1);
                across_1 = _o278.across_1;
                round_1 = _o278.round_1;
                lift_1 = _o278.lift_1;
                tx_1 = _o278.tx_1;
                ty_1 = _o278.ty_1;
                tz_1 = _o278.tz_1;
                vx_2 = _o278.vx_2;
                vy_2 = _o278.vy_2;
                vz_2 = _o278.vz_2;
                nx_2 = _o278.nx_2;
                ny_2 = _o278.ny_2;
                nz_2 = _o278.nz_2;
                turn_rate_2 = _o278.turn_rate_2;
                cos_2 = _o278.cos_2;
                sin_2 = _o278.sin_2;
                widened_2 = _o278.widened_2;
                near_2 = _o278.near_2;
                const LANES(court_roll_2_out) _o279 =
                    LANES(court_roll_2)(across_0, across_1, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, p_gravity, lift_0, lift_1, near_0, near_1, near_2, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, per_reach, ring, round_0, round_1, sin_0, sin_1, sin_2, turn_rate_0, turn_rate_1, turn_rate_2, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2, widened_1, widened_2);
                across_2 = _o279.across_2;
                round_2 = _o279.round_2;
                lift_2 = _o279.lift_2;
                tx_2 = _o279.tx_2;
                ty_2 = _o279.ty_2;
                tz_2 = _o279.tz_2;
                vx_3 = _o279.vx_3;
                vy_3 = _o279.vy_3;
                vz_3 = _o279.vz_3;
                nx_3 = _o279.nx_3;
                ny_3 = _o279.ny_3;
                nz_3 = _o279.nz_3;
                turn_rate_3 = _o279.turn_rate_3;
                cos_3 = _o279.cos_3;
                sin_3 = _o279.sin_3;
                widened_3 = _o279.widened_3;
                near_3 = _o279.near_3;
                const LANES(court_roll_3_out) _o280 =
                    LANES(court_roll_3)(across_0, across_1, across_2, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, p_gravity, lift_0, lift_1, lift_2, near_0, near_1, near_2, near_3, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, per_reach, ring, round_0, round_1, round_2, sin_0, sin_1, sin_2, sin_3, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3, widened_1, widened_2, widened_3);
                across_3 = _o280.across_3;
                round_3 = _o280.round_3;
                lift_3 = _o280.lift_3;
                tx_3 = _o280.tx_3;
                ty_3 = _o280.ty_3;
                tz_3 = _o280.tz_3;
                vx_4 = _o280.vx_4;
                vy_4 = _o280.vy_4;
                vz_4 = _o280.vz_4;
                nx_4 = _o280.nx_4;
                ny_4 = _o280.ny_4;
                nz_4 = _o280.nz_4;
                turn_rate_4 = _o280.turn_rate_4;
                cos_4 = _o280.cos_4;
                sin_4 = _o280.sin_4;
                widened_4 = _o280.widened_4;
                near_4 = _o280.near_4;
                const LANES(court_roll_4_out) _o281 =
                    LANES(court_roll_4)(across_0, across_1, across_2, across_3, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, cos_4, p_gravity, lift_0, lift_1, lift_2, lift_3, near_0, near_1, near_2, near_3, near_4, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, per_reach, ring, round_0, round_1, round_2, round_3, sin_0, sin_1, sin_2, sin_3, sin_4, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4, widened_1, widened_2, widened_3, widened_4);
                across_4 = _o281.across_4;
                round_4 = _o281.round_4;
                lift_4 = _o281.lift_4;
                tx_4 = _o281.tx_4;
                ty_4 = _o281.ty_4;
                tz_4 = _o281.tz_4;
                vx_5 = _o281.vx_5;
                vy_5 = _o281.vy_5;
                vz_5 = _o281.vz_5;
                nx_5 = _o281.nx_5;
                ny_5 = _o281.ny_5;
                nz_5 = _o281.nz_5;
                turn_rate_5 = _o281.turn_rate_5;
                cos_5 = _o281.cos_5;
                sin_5 = _o281.sin_5;
                widened_5 = _o281.widened_5;
                near_5 = _o281.near_5;
                const LANES(court_roll_5_out) _o282 =
                    LANES(court_roll_5)(across_0, across_1, across_2, across_3, across_4, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, near_0, near_1, near_2, near_3, near_4, near_5, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, per_reach, ring, round_0, round_1, round_2, round_3, round_4, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, widened_1, widened_2, widened_3, widened_4, widened_5);
                across_5 = _o282.across_5;
                round_5 = _o282.round_5;
                lift_5 = _o282.lift_5;
                tx_5 = _o282.tx_5;
                ty_5 = _o282.ty_5;
                tz_5 = _o282.tz_5;
                vx_6 = _o282.vx_6;
                vy_6 = _o282.vy_6;
                vz_6 = _o282.vz_6;
                nx_6 = _o282.nx_6;
                ny_6 = _o282.ny_6;
                nz_6 = _o282.nz_6;
                turn_rate_6 = _o282.turn_rate_6;
                cos_6 = _o282.cos_6;
                sin_6 = _o282.sin_6;
                widened_6 = _o282.widened_6;
                near_6 = _o282.near_6;
                const LANES(court_roll_6_out) _o283 =
                    LANES(court_roll_6)(across_0, across_1, across_2, across_3, across_4, across_5, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, near_0, near_1, near_2, near_3, near_4, near_5, near_6, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, per_reach, ring, round_0, round_1, round_2, round_3, round_4, round_5, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, widened_1, widened_2, widened_3, widened_4, widened_5, widened_6);
                across_6 = _o283.across_6;
                round_6 = _o283.round_6;
                lift_6 = _o283.lift_6;
                tx_6 = _o283.tx_6;
                ty_6 = _o283.ty_6;
                tz_6 = _o283.tz_6;
                vx_7 = _o283.vx_7;
                vy_7 = _o283.vy_7;
                vz_7 = _o283.vz_7;
                nx_7 = _o283.nx_7;
                ny_7 = _o283.ny_7;
                nz_7 = _o283.nz_7;
                turn_rate_7 = _o283.turn_rate_7;
                cos_7 = _o283.cos_7;
                sin_7 = _o283.sin_7;
                widened_7 = _o283.widened_7;
                near_7 = _o283.near_7;
                const LANES(court_roll_7_out) _o284 =
                    LANES(court_roll_7)(across_0, across_1, across_2, across_3, across_4, across_5, across_6, bent_x, bent_y, bent_z, cos_0, cos_1, cos_2, cos_3, cos_4, cos_5, cos_6, cos_7, p_gravity, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, near_0, near_1, near_2, near_3, near_4, near_5, near_6, near_7, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, per_reach, ring, round_0, round_1, round_2, round_3, round_4, round_5, round_6, sin_0, sin_1, sin_2, sin_3, sin_4, sin_5, sin_6, sin_7, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, widened_1, widened_2, widened_3, widened_4, widened_5, widened_6, widened_7);
                vx_8 = _o284.vx_8;
                vy_8 = _o284.vy_8;
                vz_8 = _o284.vz_8;
                turn_rate_8 = _o284.turn_rate_8;
                const LANES(court_roll_moved_out) _o285 =
                    LANES(court_roll_moved)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, far_x, far_y, far_z);
                far_x = _o285.x;
                far_vx = _o285.vx;
                far_y = _o285.y;
                far_vy = _o285.vy;
                far_z = _o285.z;
                far_vz = _o285.vz;
                turn_rate = _o285.turn_rate;
                const LANES(court_holding_out) _o286 =
                    LANES(court_holding)(held, K(0.0));
                here = _o286.here;
                const M _m287 = lanes_both(active, here);
                if (lanes_any(_m287)) {
                    const LANES(court_ring_normal_out) _o288 =
                        LANES(court_ring_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m287, _o288.nx, nx);
                    ny = lanes_select(_m287, _o288.ny, ny);
                    nz = lanes_select(_m287, _o288.nz, nz);
                    const LANES(court_ring_off_out) _o289 =
                        LANES(court_ring_off)(p_ball_radius, p_ring_radius, p_wire_radius, far_x, far_y, far_z);
                    gap = lanes_select(_m287, _o289.gap, gap);
                }
                const LANES(court_holding_out) _o290 =
                    LANES(court_holding)(held, K(1.0));
                here = _o290.here;
                const M _m291 = lanes_both(active, here);
                if (lanes_any(_m291)) {
                    const LANES(court_backboard_normal_out) _o292 =
                        LANES(court_backboard_normal)(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m291, _o292.nx, nx);
                    ny = lanes_select(_m291, _o292.ny, ny);
                    nz = lanes_select(_m291, _o292.nz, nz);
                    const LANES(court_backboard_off_out) _o293 =
                        LANES(court_backboard_off)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, far_x, far_y, far_z);
                    gap = lanes_select(_m291, _o293.gap, gap);
                }
                const LANES(court_holding_out) _o294 =
                    LANES(court_holding)(held, K(2.0));
                here = _o294.here;
                const M _m295 = lanes_both(active, here);
                if (lanes_any(_m295)) {
                    const LANES(court_bridge_normal_out) _o296 =
                        LANES(court_bridge_normal)(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m295, _o296.nx, nx);
                    ny = lanes_select(_m295, _o296.ny, ny);
                    nz = lanes_select(_m295, _o296.nz, nz);
                    const LANES(court_bridge_off_out) _o297 =
                        LANES(court_bridge_off)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, far_x, far_y, far_z);
                    gap = lanes_select(_m295, _o297.gap, gap);
                }
                const LANES(court_roll_placed_out) _o298 =
                    LANES(court_roll_placed)(p_ball_radius, gap, nx, ny, nz, turn_rate, far_vx, far_vy, far_vz, far_x, far_y, far_z);
                far_x = _o298.x;
                far_y = _o298.y;
                far_z = _o298.z;
                far_vx = _o298.vx;
                far_vy = _o298.vy;
                far_vz = _o298.vz;
                far_wx = _o298.wx;
                far_wy = _o298.wy;
                far_wz = _o298.wz;
                const LANES(court_compared_out) _o299 =
                    LANES(court_compared)(apart, p_ball_radius, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_x, far_y, far_z, vx, vy, vz, wx, wy, wz, x, y, z);
                dx = _o299.dx;
                dy = _o299.dy;
                dz = _o299.dz;
                dvx = _o299.dvx;
                dvy = _o299.dvy;
                dvz = _o299.dvz;
                dwx = _o299.dwx;
                dwy = _o299.dwy;
                dwz = _o299.dwz;
                const LANES(court_rolled_on_out) _o300 =
                    LANES(court_rolled_on)(clock, rests, stride, which);
                clock = _o300.clock;
                rolling = _o300.rolling;
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(rolling, lanes_less(turns, K(64.0)))));
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
        for (size_t i = 0; i < kept_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(kept_shots - i);
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
            const M _m301 = lanes_both(rows, leaves);
            if (lanes_any(_m301)) {
                const LANES(court_error_bounds_out) _o302 =
                    LANES(court_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
                position_error = lanes_select(_m301, _o302.position_error, position_error);
                velocity_error = lanes_select(_m301, _o302.velocity_error, velocity_error);
                const LANES(court_holding_out) _o303 =
                    LANES(court_holding)(held, K(0.0));
                M here = _o303.here;
                const M _m304 = lanes_both(_m301, here);
                if (lanes_any(_m304)) {
                    const LANES(court_ring_tube_out) _o305 =
                        LANES(court_ring_tube)(p_ball_radius, p_ring_radius, p_wire_radius);
                    per_reach = lanes_select(_m304, _o305.per_reach, per_reach);
                    const LANES(court_ring_parting_out) _o306 =
                        LANES(court_ring_parting)(p_gravity, p_ring_radius, vx, vy, vz, x, y, z);
                    lift = lanes_select(_m304, _o306.lift, lift);
                    surge = lanes_select(_m304, _o306.surge, surge);
                    snap = lanes_select(_m304, _o306.snap, snap);
                }
                const LANES(court_holding_out) _o307 =
                    LANES(court_holding)(held, K(1.0));
                here = _o307.here;
                const M _m308 = lanes_both(_m301, here);
                if (lanes_any(_m308)) {
                    const LANES(court_backboard_tube_out) _o309 =
                        LANES(court_backboard_tube)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                    per_reach = lanes_select(_m308, _o309.per_reach, per_reach);
                    const LANES(court_backboard_parting_out) _o310 =
                        LANES(court_backboard_parting)(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, vx, vy, vz, x, y, z);
                    lift = lanes_select(_m308, _o310.lift, lift);
                    surge = lanes_select(_m308, _o310.surge, surge);
                    snap = lanes_select(_m308, _o310.snap, snap);
                }
                const LANES(court_holding_out) _o311 =
                    LANES(court_holding)(held, K(2.0));
                here = _o311.here;
                const M _m312 = lanes_both(_m301, here);
                if (lanes_any(_m312)) {
                    const LANES(court_bridge_tube_out) _o313 =
                        LANES(court_bridge_tube)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                    per_reach = lanes_select(_m312, _o313.per_reach, per_reach);
                    const LANES(court_bridge_parting_out) _o314 =
                        LANES(court_bridge_parting)(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                    lift = lanes_select(_m312, _o314.lift, lift);
                    surge = lanes_select(_m312, _o314.surge, surge);
                    snap = lanes_select(_m312, _o314.snap, snap);
                }
                const LANES(court_alone_out) _o315 =
                    LANES(court_alone)();
                V nearest = _o315.nearest;
                const LANES(court_beside_out) _o316 =
                    LANES(court_beside)(held, K(0.0));
                M beside = _o316.beside;
                const M _m317 = lanes_both(_m301, beside);
                if (lanes_any(_m317)) {
                    const LANES(court_ring_beside_out) _o318 =
                        LANES(court_ring_beside)(p_ball_radius, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                    V gap = _o318.gap;
                    const LANES(court_neared_out) _o319 =
                        LANES(court_neared)(gap, nearest);
                    nearest = lanes_select(_m317, _o319.nearest, nearest);
                }
                const LANES(court_beside_out) _o320 =
                    LANES(court_beside)(held, K(1.0));
                beside = _o320.beside;
                const M _m321 = lanes_both(_m301, beside);
                if (lanes_any(_m321)) {
                    const LANES(court_backboard_beside_out) _o322 =
                        LANES(court_backboard_beside)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, vx, vy, vz, x, y, z);
                    V gap = _o322.gap;
                    const LANES(court_neared_out) _o323 =
                        LANES(court_neared)(gap, nearest);
                    nearest = lanes_select(_m321, _o323.nearest, nearest);
                }
                const LANES(court_beside_out) _o324 =
                    LANES(court_beside)(held, K(2.0));
                beside = _o324.beside;
                const M _m325 = lanes_both(_m301, beside);
                if (lanes_any(_m325)) {
                    const LANES(court_bridge_beside_out) _o326 =
                        LANES(court_bridge_beside)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                    V gap = _o326.gap;
                    const LANES(court_neared_out) _o327 =
                        LANES(court_neared)(gap, nearest);
                    nearest = lanes_select(_m325, _o327.nearest, nearest);
                }
                const LANES(court_beside_out) _o328 =
                    LANES(court_beside)(held, K(3.0));
                beside = _o328.beside;
                const M _m329 = lanes_both(_m301, beside);
                {
                    const LANES(court_end_beside_out) _o330 =
                        LANES(court_end_beside)(p_end_depth, vz, z);
                    V gap = _o330.gap;
                    const LANES(court_neared_out) _o331 =
                        LANES(court_neared)(gap, nearest);
                    nearest = lanes_select(_m329, _o331.nearest, nearest);
                }
                const LANES(court_parted_out) _o332 =
                    LANES(court_parted)(doubt, p_gravity, lift, nearest, per_reach, position_error, snap, surge, velocity_error, vx, vy, vz);
                when = lanes_select(_m301, _o332.when, when);
                doubt = lanes_select(_m301, _o332.doubt, doubt);
                const LANES(court_hopping_out) _o333 =
                    LANES(court_hopping)();
                which = lanes_select(_m301, _o333.which, which);
            }
            lanes_store(lists->kept_doubt + i, doubt);
            lanes_store(lists->kept_position_error + i, position_error);
            lanes_store(lists->kept_velocity_error + i, velocity_error);
            lanes_store(lists->kept_when + i, when);
            lanes_store(lists->kept_which + i, which);
        }
        for (size_t k = 0; k < kept_shots; k++) {
            const size_t row = (size_t)lists->kept_row[k];
            lists->began[row] = lists->kept_began[k];
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
            const LANES(court_departed_out) _o334 =
                LANES(court_departed)(K(3.0), which);
            M moves = _o334.moves;
            M ends = _o334.ends;
            M touches = _o334.touches;
            V reached = _o334.reached;
            M edge = _o334.edge;
            const LANES(court_body_of_out) _o335 =
                LANES(court_body_of)(which);
            V body = _o335.body;
            const M _m336 = lanes_both(rows, moves);
            if (lanes_any(_m336)) {
                const LANES(court_passing_doubt_out) _o337 =
                    LANES(court_passing_doubt)(when, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ring_radius, p_gravity);
                M unsure = _o337.unsure;
                const LANES(court_undecided_out) _o338 =
                    LANES(court_undecided)(uncertain, unsure);
                uncertain = lanes_select(_m336, _o338.uncertain, uncertain);
                const LANES(court_passing_out) _o339 =
                    LANES(court_passing)(through, when, x, y, z, vx, vy, vz, p_ring_radius, p_gravity);
                through = lanes_select(_m336, _o339.through, through);
                const LANES(court_flight_out) _o340 =
                    LANES(court_flight)(when, x, y, z, vx, vy, vz, p_gravity);
                x = lanes_select(_m336, _o340.x, x);
                y = lanes_select(_m336, _o340.y, y);
                z = lanes_select(_m336, _o340.z, z);
                vx = lanes_select(_m336, _o340.vx, vx);
                vy = lanes_select(_m336, _o340.vy, vy);
                vz = lanes_select(_m336, _o340.vz, vz);
                const LANES(court_ticked_out) _o341 =
                    LANES(court_ticked)(clock, when);
                clock = lanes_select(_m336, _o341.clock, clock);
            }
            const M _m342 = lanes_both(rows, limited);
            if (lanes_any(_m342)) {
                const LANES(court_expired_out) _o343 =
                    LANES(court_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m342, _o343.clock, clock);
                body = lanes_select(_m342, _o343.body, body);
                reached = lanes_select(_m342, _o343.reached, reached);
                ends = lanes_choose(_m342, _o343.ends, ends);
            }
            const LANES(court_unhopped_out) _o344 =
                LANES(court_unhopped)();
            M hopped = _o344.hopped;
            const M _m345 = lanes_both(rows, kept);
            if (lanes_any(_m345)) {
                const LANES(court_kept_on_out) _o346 =
                    LANES(court_kept_on)(began, body, clock, doubt, ends, held, last, reached, rests, rolling, rolls, which);
                body = lanes_select(_m345, _o346.body, body);
                reached = lanes_select(_m345, _o346.reached, reached);
                doubt = lanes_select(_m345, _o346.doubt, doubt);
                ends = lanes_choose(_m345, _o346.ends, ends);
                hopped = lanes_choose(_m345, _o346.hopped, hopped);
                last = lanes_select(_m345, _o346.last, last);
                mode = lanes_select(_m345, _o346.mode, mode);
                held = lanes_select(_m345, _o346.held, held);
                rolls = lanes_select(_m345, _o346.rolls, rolls);
            }
            const LANES(court_displacement_out) _o347 =
                LANES(court_displacement)(late, when, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_gravity, p_end_depth);
            V slack = _o347.margin;
            const LANES(court_here_out) _o348 =
                LANES(court_here)(K(3.0), which);
            M here = _o348.here;
            const M _m349 = lanes_both(rows, here);
            {
                const LANES(court_end_bounds_out) _o350 =
                    LANES(court_end_bounds)(x, y, p_ring_radius);
                V g0 = _o350.g0;
                const LANES(court_end_reached_out) _o351 =
                    LANES(court_end_reached)(g0, through);
                reached = lanes_select(_m349, _o351.reached, reached);
                const LANES(court_end_edge_out) _o352 =
                    LANES(court_end_edge)(g0, slack, through);
                edge = lanes_choose(_m349, _o352.edge, edge);
            }
            const LANES(court_doubted_in_contact_out) _o353 =
                LANES(court_doubted_in_contact)(assured, doubt, edge, last, late, uncertain, when, which);
            uncertain = _o353.uncertain;
            const LANES(court_accounted_out) _o354 =
                LANES(court_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o354.contacts;
            V outcome = _o354.outcome;
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
            const LANES(court_meeting_out) _o355 =
                LANES(court_meeting)(claims, ends, touches);
            M meeting = _o355.meeting;
            const M _m356 = lanes_both(rows, meeting);
            if (lanes_any(_m356)) {
                const LANES(court_end_normal_out) _o357 =
                    LANES(court_end_normal)();
                V nx = _o357.nx;
                V ny = _o357.ny;
                V nz = _o357.nz;
                const LANES(court_here_out) _o358 =
                    LANES(court_here)(K(0.0), which);
                M here = _o358.here;
                const M _m359 = lanes_both(_m356, here);
                {
                    const LANES(court_ring_normal_out) _o360 =
                        LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m359, _o360.nx, nx);
                    ny = lanes_select(_m359, _o360.ny, ny);
                    nz = lanes_select(_m359, _o360.nz, nz);
                    const LANES(court_counted_out) _o361 =
                        LANES(court_counted)(count_0);
                    count_0 = lanes_select(_m359, _o361.count, count_0);
                }
                const LANES(court_here_out) _o362 =
                    LANES(court_here)(K(1.0), which);
                here = _o362.here;
                const M _m363 = lanes_both(_m356, here);
                {
                    const LANES(court_backboard_normal_out) _o364 =
                        LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m363, _o364.nx, nx);
                    ny = lanes_select(_m363, _o364.ny, ny);
                    nz = lanes_select(_m363, _o364.nz, nz);
                    const LANES(court_counted_out) _o365 =
                        LANES(court_counted)(count_1);
                    count_1 = lanes_select(_m363, _o365.count, count_1);
                }
                const LANES(court_here_out) _o366 =
                    LANES(court_here)(K(2.0), which);
                here = _o366.here;
                const M _m367 = lanes_both(_m356, here);
                {
                    const LANES(court_bridge_normal_out) _o368 =
                        LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m367, _o368.nx, nx);
                    ny = lanes_select(_m367, _o368.ny, ny);
                    nz = lanes_select(_m367, _o368.nz, nz);
                    const LANES(court_counted_out) _o369 =
                        LANES(court_counted)(count_2);
                    count_2 = lanes_select(_m367, _o369.count, count_2);
                }
                const LANES(court_elsewhere_out) _o370 =
                    LANES(court_elsewhere)();
                V curving = _o370.curving;
                const LANES(court_again_out) _o371 =
                    LANES(court_again)(K(0.0), last, which);
                M again = _o371.again;
                const M _m372 = lanes_both(_m356, again);
                {
                    const LANES(court_ring_curvature_out) _o373 =
                        LANES(court_ring_curvature)(p_ball_radius, p_ring_radius, p_wire_radius);
                    curving = lanes_select(_m372, _o373.curvature, curving);
                }
                const LANES(court_again_out) _o374 =
                    LANES(court_again)(K(1.0), last, which);
                again = _o374.again;
                const M _m375 = lanes_both(_m356, again);
                {
                    const LANES(court_backboard_curvature_out) _o376 =
                        LANES(court_backboard_curvature)(p_ball_radius);
                    curving = lanes_select(_m375, _o376.curvature, curving);
                }
                const LANES(court_again_out) _o377 =
                    LANES(court_again)(K(2.0), last, which);
                again = _o377.again;
                const M _m378 = lanes_both(_m356, again);
                {
                    const LANES(court_bridge_curvature_out) _o379 =
                        LANES(court_bridge_curvature)(p_ball_radius);
                    curving = lanes_select(_m378, _o379.curvature, curving);
                }
                const LANES(court_carry_flight_out) _o380 =
                    LANES(court_carry_flight)(when, x, y, z, vx, vy, vz, nx, ny, nz, clock, contacts, late, dx, dy, dz, dvx, dvy, dvz, curving, p_gravity);
                dx = lanes_select(_m356, _o380.dx, dx);
                dy = lanes_select(_m356, _o380.dy, dy);
                dz = lanes_select(_m356, _o380.dz, dz);
                dvx = lanes_select(_m356, _o380.dvx, dvx);
                dvy = lanes_select(_m356, _o380.dvy, dvy);
                dvz = lanes_select(_m356, _o380.dvz, dvz);
                V delay = _o380.delay;
                V shift = _o380.shift;
                const LANES(court_delayed_out) _o381 =
                    LANES(court_delayed)(clock_error, delay);
                clock_error = lanes_select(_m356, _o381.clock_error, clock_error);
                const M _m382 = lanes_both(_m356, ends);
                {
                    const LANES(court_floored_out) _o383 =
                        LANES(court_floored)(dx, dy, dz, shift);
                    dx = lanes_select(_m382, _o383.dx, dx);
                    dy = lanes_select(_m382, _o383.dy, dy);
                    dz = lanes_select(_m382, _o383.dz, dz);
                }
                const LANES(court_unturned_out) _o384 =
                    LANES(court_unturned)();
                V dnx = _o384.dnx;
                V dny = _o384.dny;
                V dnz = _o384.dnz;
                V turn = _o384.turn;
                const LANES(court_here_out) _o385 =
                    LANES(court_here)(K(0.0), which);
                here = _o385.here;
                const M _m386 = lanes_both(_m356, here);
                if (lanes_any(_m386)) {
                    const LANES(court_ring_carry_normal_out) _o387 =
                        LANES(court_ring_carry_normal)(x, y, dx, dy, dz, shift, p_ball_radius, p_ring_radius, p_wire_radius);
                    dnx = lanes_select(_m386, _o387.dnx, dnx);
                    dny = lanes_select(_m386, _o387.dny, dny);
                    dnz = lanes_select(_m386, _o387.dnz, dnz);
                    turn = lanes_select(_m386, _o387.turn, turn);
                }
                const LANES(court_here_out) _o388 =
                    LANES(court_here)(K(1.0), which);
                here = _o388.here;
                const M _m389 = lanes_both(_m356, here);
                {
                    const LANES(court_backboard_carry_normal_out) _o390 =
                        LANES(court_backboard_carry_normal)(x, y, z, dx, dy, dz, shift, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    dnx = lanes_select(_m389, _o390.dnx, dnx);
                    dny = lanes_select(_m389, _o390.dny, dny);
                    dnz = lanes_select(_m389, _o390.dnz, dnz);
                    turn = lanes_select(_m389, _o390.turn, turn);
                }
                const LANES(court_here_out) _o391 =
                    LANES(court_here)(K(2.0), which);
                here = _o391.here;
                const M _m392 = lanes_both(_m356, here);
                {
                    const LANES(court_bridge_carry_normal_out) _o393 =
                        LANES(court_bridge_carry_normal)(x, y, z, dx, dy, dz, shift, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    dnx = lanes_select(_m392, _o393.dnx, dnx);
                    dny = lanes_select(_m392, _o393.dny, dny);
                    dnz = lanes_select(_m392, _o393.dnz, dnz);
                    turn = lanes_select(_m392, _o393.turn, turn);
                }
                {
                    const double *const _t395[][2] = {
                        {lists->p_ring_friction, lists->p_ring_restitution},
                        {lists->p_backboard_friction, lists->p_backboard_restitution},
                        {lists->p_bridge_friction, lists->p_bridge_restitution},
                    };
                    static const double _t396[][1] = {
                        {0.0},
                        {1.0},
                        {2.0},
                    };
                    for (size_t _k394 = 0; _k394 < 3; _k394++) {
                        const V own_1 = lanes_load(_t395[_k394][0] + (i & varying));
                        const V own_2 = lanes_load(_t395[_k394][1] + (i & varying));
                        const V own_index = K(_t396[_k394][0]);
                        const LANES(court_here_out) _o397 =
                            LANES(court_here)(own_index, which);
                        M here = _o397.here;
                        const M _m398 = lanes_both(_m356, here);
                        if (lanes_any(_m398)) {
                            const LANES(court_ring_impact_doubt_out) _o399 =
                                LANES(court_ring_impact_doubt)(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, turn, p_ball_radius, own_2, own_1, p_tangential_restitution, p_restitution_speed);
                            M unsure = _o399.unsure;
                            const LANES(court_undecided_out) _o400 =
                                LANES(court_undecided)(uncertain, unsure);
                            uncertain = lanes_select(_m398, _o400.uncertain, uncertain);
                            const LANES(court_carry_ring_impact_out) _o401 =
                                LANES(court_carry_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, contacts, dvx, dvy, dvz, dwx, dwy, dwz, dnx, dny, dnz, turn, p_ball_radius, own_2, own_1, p_tangential_restitution, p_restitution_speed);
                            dvx = lanes_select(_m398, _o401.dvx, dvx);
                            dvy = lanes_select(_m398, _o401.dvy, dvy);
                            dvz = lanes_select(_m398, _o401.dvz, dvz);
                            dwx = lanes_select(_m398, _o401.dwx, dwx);
                            dwy = lanes_select(_m398, _o401.dwy, dwy);
                            dwz = lanes_select(_m398, _o401.dwz, dwz);
                            const LANES(court_ring_impact_out) _o402 =
                                LANES(court_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, own_2, own_1, p_tangential_restitution, p_restitution_speed);
                            vx = lanes_select(_m398, _o402.vx, vx);
                            vy = lanes_select(_m398, _o402.vy, vy);
                            vz = lanes_select(_m398, _o402.vz, vz);
                            wx = lanes_select(_m398, _o402.wx, wx);
                            wy = lanes_select(_m398, _o402.wy, wy);
                            wz = lanes_select(_m398, _o402.wz, wz);
                        }
                    }
                }
                const M _m403 = lanes_both(_m356, touches);
                {
                    const LANES(court_touched_out) _o404 =
                        LANES(court_touched)(body, first, which);
                    first = lanes_select(_m403, _o404.first, first);
                    last = lanes_select(_m403, _o404.last, last);
                }
                const M _m405 = lanes_both(_m356, touches);
                if (lanes_any(_m405)) {
                    const LANES(court_slowed_out) _o406 =
                        LANES(court_slowed)(p_ball_radius, nx, ny, nz, vx, vy, vz);
                    M slow = _o406.slow;
                    assured = lanes_select(_m405, _o406.assured, assured);
                    const M _m407 = lanes_both(_m405, slow);
                    if (lanes_any(_m407)) {
                        const LANES(court_gripped_out) _o408 =
                            LANES(court_gripped)(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
                        V rolled_x = _o408.rolled_x;
                        V rolled_y = _o408.rolled_y;
                        V rolled_z = _o408.rolled_z;
                        V slip = _o408.slip;
                        V bounce = _o408.bounce;
                        const LANES(court_here_out) _o409 =
                            LANES(court_here)(K(0.0), which);
                        M here = _o409.here;
                        const M _m410 = lanes_both(_m407, here);
                        if (lanes_any(_m410)) {
                            const LANES(court_ring_turning_out) _o411 =
                                LANES(court_ring_turning)(p_ball_radius, p_ring_radius, rolled_x, rolled_y, rolled_z, p_wire_radius, x, y);
                            V turning_x = _o411.turning_x;
                            V turning_y = _o411.turning_y;
                            V turning_z = _o411.turning_z;
                            const LANES(court_pressed_on_out) _o412 =
                                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
                            V press = _o412.press;
                            V weight = _o412.weight;
                            V drag = _o412.drag;
                            V thrust_x = _o412.thrust_x;
                            V thrust_y = _o412.thrust_y;
                            V thrust_z = _o412.thrust_z;
                            const LANES(court_alone_out) _o413 =
                                LANES(court_alone)();
                            V nearest = _o413.nearest;
                            V wedge = _o413.wedge;
                            const LANES(court_backboard_closing_out) _o414 =
                                LANES(court_backboard_closing)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z);
                            V gap = _o414.gap;
                            V nearing = _o414.nearing;
                            V swerve = _o414.swerve;
                            V facing = _o414.facing;
                            const LANES(court_neared_body_out) _o415 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o415.nearest;
                            wedge = _o415.wedge;
                            const LANES(court_bridge_closing_out) _o416 =
                                LANES(court_bridge_closing)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
                            gap = _o416.gap;
                            nearing = _o416.nearing;
                            swerve = _o416.swerve;
                            facing = _o416.facing;
                            const LANES(court_neared_body_out) _o417 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o417.nearest;
                            wedge = _o417.wedge;
                            const LANES(court_end_beside_out) _o418 =
                                LANES(court_end_beside)(p_end_depth, vz, z);
                            gap = _o418.gap;
                            const LANES(court_neared_out) _o419 =
                                LANES(court_neared)(gap, nearest);
                            nearest = _o419.nearest;
                            const LANES(court_ring_parting_out) _o420 =
                                LANES(court_ring_parting)(p_gravity, p_ring_radius, vx, vy, vz, x, y, z);
                            V lift = _o420.lift;
                            const LANES(court_ring_impact_settling_out) _o421 =
                                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_ring_friction, p_ring_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz);
                            M settles = _o421.settles;
                            M lodges = _o421.lodges;
                            M slides = _o421.slides;
                            M parts = _o421.parts;
                            assured = lanes_select(_m410, _o421.assured, assured);
                            M unsure = _o421.unsure;
                            const LANES(court_settled_out) _o422 =
                                LANES(court_settled)(K(0.0), lodges, outcome, parts, settles, slides, uncertain, unsure);
                            mode = lanes_select(_m410, _o422.mode, mode);
                            held = lanes_select(_m410, _o422.held, held);
                            outcome = lanes_select(_m410, _o422.outcome, outcome);
                            slip_left = lanes_select(_m410, _o422.slip_left, slip_left);
                            uncertain = lanes_select(_m410, _o422.uncertain, uncertain);
                        }
                        const LANES(court_here_out) _o423 =
                            LANES(court_here)(K(1.0), which);
                        here = _o423.here;
                        const M _m424 = lanes_both(_m407, here);
                        if (lanes_any(_m424)) {
                            const LANES(court_backboard_turning_out) _o425 =
                                LANES(court_backboard_turning)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, rolled_x, rolled_y, rolled_z, x, y, z);
                            V turning_x = _o425.turning_x;
                            V turning_y = _o425.turning_y;
                            V turning_z = _o425.turning_z;
                            const LANES(court_pressed_on_out) _o426 =
                                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
                            V press = _o426.press;
                            V weight = _o426.weight;
                            V drag = _o426.drag;
                            V thrust_x = _o426.thrust_x;
                            V thrust_y = _o426.thrust_y;
                            V thrust_z = _o426.thrust_z;
                            const LANES(court_alone_out) _o427 =
                                LANES(court_alone)();
                            V nearest = _o427.nearest;
                            V wedge = _o427.wedge;
                            const LANES(court_ring_closing_out) _o428 =
                                LANES(court_ring_closing)(p_ball_radius, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
                            V gap = _o428.gap;
                            V nearing = _o428.nearing;
                            V swerve = _o428.swerve;
                            V facing = _o428.facing;
                            const LANES(court_neared_body_out) _o429 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o429.nearest;
                            wedge = _o429.wedge;
                            const LANES(court_bridge_closing_out) _o430 =
                                LANES(court_bridge_closing)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
                            gap = _o430.gap;
                            nearing = _o430.nearing;
                            swerve = _o430.swerve;
                            facing = _o430.facing;
                            const LANES(court_neared_body_out) _o431 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o431.nearest;
                            wedge = _o431.wedge;
                            const LANES(court_end_beside_out) _o432 =
                                LANES(court_end_beside)(p_end_depth, vz, z);
                            gap = _o432.gap;
                            const LANES(court_neared_out) _o433 =
                                LANES(court_neared)(gap, nearest);
                            nearest = _o433.nearest;
                            const LANES(court_backboard_parting_out) _o434 =
                                LANES(court_backboard_parting)(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, vx, vy, vz, x, y, z);
                            V lift = _o434.lift;
                            const LANES(court_ring_impact_settling_out) _o435 =
                                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_backboard_friction, p_backboard_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz);
                            M settles = _o435.settles;
                            M lodges = _o435.lodges;
                            M slides = _o435.slides;
                            M parts = _o435.parts;
                            assured = lanes_select(_m424, _o435.assured, assured);
                            M unsure = _o435.unsure;
                            const LANES(court_settled_out) _o436 =
                                LANES(court_settled)(K(1.0), lodges, outcome, parts, settles, slides, uncertain, unsure);
                            mode = lanes_select(_m424, _o436.mode, mode);
                            held = lanes_select(_m424, _o436.held, held);
                            outcome = lanes_select(_m424, _o436.outcome, outcome);
                            slip_left = lanes_select(_m424, _o436.slip_left, slip_left);
                            uncertain = lanes_select(_m424, _o436.uncertain, uncertain);
                        }
                        const LANES(court_here_out) _o437 =
                            LANES(court_here)(K(2.0), which);
                        here = _o437.here;
                        const M _m438 = lanes_both(_m407, here);
                        if (lanes_any(_m438)) {
                            const LANES(court_bridge_turning_out) _o439 =
                                LANES(court_bridge_turning)(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, rolled_x, rolled_y, rolled_z, p_wire_radius, x, y, z);
                            V turning_x = _o439.turning_x;
                            V turning_y = _o439.turning_y;
                            V turning_z = _o439.turning_z;
                            const LANES(court_pressed_on_out) _o440 =
                                LANES(court_pressed_on)(p_ball_radius, p_gravity, nx, ny, nz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, wx, wy, wz);
                            V press = _o440.press;
                            V weight = _o440.weight;
                            V drag = _o440.drag;
                            V thrust_x = _o440.thrust_x;
                            V thrust_y = _o440.thrust_y;
                            V thrust_z = _o440.thrust_z;
                            const LANES(court_alone_out) _o441 =
                                LANES(court_alone)();
                            V nearest = _o441.nearest;
                            V wedge = _o441.wedge;
                            const LANES(court_ring_closing_out) _o442 =
                                LANES(court_ring_closing)(p_ball_radius, nx, ny, nz, p_ring_radius, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, p_wire_radius, x, y, z);
                            V gap = _o442.gap;
                            V nearing = _o442.nearing;
                            V swerve = _o442.swerve;
                            V facing = _o442.facing;
                            const LANES(court_neared_body_out) _o443 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o443.nearest;
                            wedge = _o443.wedge;
                            const LANES(court_backboard_closing_out) _o444 =
                                LANES(court_backboard_closing)(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, nx, ny, nz, rolled_x, rolled_y, rolled_z, thrust_x, thrust_y, thrust_z, x, y, z);
                            gap = _o444.gap;
                            nearing = _o444.nearing;
                            swerve = _o444.swerve;
                            facing = _o444.facing;
                            const LANES(court_neared_body_out) _o445 =
                                LANES(court_neared_body)(facing, gap, nearest, nearing, press, swerve, wedge);
                            nearest = _o445.nearest;
                            wedge = _o445.wedge;
                            const LANES(court_end_beside_out) _o446 =
                                LANES(court_end_beside)(p_end_depth, vz, z);
                            gap = _o446.gap;
                            const LANES(court_neared_out) _o447 =
                                LANES(court_neared)(gap, nearest);
                            nearest = _o447.nearest;
                            const LANES(court_bridge_parting_out) _o448 =
                                LANES(court_bridge_parting)(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, vx, vy, vz, p_wire_radius, x, y, z);
                            V lift = _o448.lift;
                            const LANES(court_ring_impact_settling_out) _o449 =
                                LANES(court_ring_impact_settling)(p_ball_radius, bounce, drag, lift, nearest, press, p_bridge_friction, p_bridge_restitution, rolled_x, rolled_y, rolled_z, slip, turning_x, turning_y, turning_z, velocity_error, wedge, weight, wx, wy, wz);
                            M settles = _o449.settles;
                            M lodges = _o449.lodges;
                            M slides = _o449.slides;
                            M parts = _o449.parts;
                            assured = lanes_select(_m438, _o449.assured, assured);
                            M unsure = _o449.unsure;
                            const LANES(court_settled_out) _o450 =
                                LANES(court_settled)(K(2.0), lodges, outcome, parts, settles, slides, uncertain, unsure);
                            mode = lanes_select(_m438, _o450.mode, mode);
                            held = lanes_select(_m438, _o450.held, held);
                            outcome = lanes_select(_m438, _o450.outcome, outcome);
                            slip_left = lanes_select(_m438, _o450.slip_left, slip_left);
                            uncertain = lanes_select(_m438, _o450.uncertain, uncertain);
                        }
                    }
                }
            }
            const M _m451 = lanes_both(rows, limited);
            if (lanes_any(_m451)) {
                const LANES(court_timed_out) _o452 =
                    LANES(court_timed)(claims, K(4.0), which);
                M timed = _o452.timed;
                const M _m453 = lanes_both(_m451, timed);
                if (lanes_any(_m453)) {
                    const LANES(court_carry_time_out) _o454 =
                        LANES(court_carry_time)(when, x, y, z, vx, vy, vz, clock, clock_error, dx, dy, dz, dvx, dvy, dvz, p_gravity);
                    dx = lanes_select(_m453, _o454.dx, dx);
                    dy = lanes_select(_m453, _o454.dy, dy);
                    dz = lanes_select(_m453, _o454.dz, dz);
                    dvx = lanes_select(_m453, _o454.dvx, dvx);
                    dvy = lanes_select(_m453, _o454.dvy, dvy);
                    dvz = lanes_select(_m453, _o454.dvz, dvz);
                    clock_error = lanes_select(_m453, _o454.clock_error, clock_error);
                }
            }
            const M _m455 = lanes_both(rows, hopped);
            if (lanes_any(_m455)) {
                const LANES(court_carry_hop_out) _o456 =
                    LANES(court_carry_hop)(dvx, dvy, dvz, dx, dy, dz, vx, vy, vz, when, x, y, z);
                dx = lanes_select(_m455, _o456.dx, dx);
                dy = lanes_select(_m455, _o456.dy, dy);
                dz = lanes_select(_m455, _o456.dz, dz);
            }
            const LANES(court_closing_out) _o457 =
                LANES(court_closing)(claims, outcome);
            M closed = _o457.closed;
            const M _m458 = lanes_both(rows, closed);
            {
                const LANES(court_claimed_errors_out) _o459 =
                    LANES(court_claimed_errors)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
                position_claim = lanes_select(_m458, _o459.position_error, position_claim);
                velocity_claim = lanes_select(_m458, _o459.velocity_error, velocity_claim);
                spin_claim = lanes_select(_m458, _o459.spin_error, spin_claim);
                time_claim = lanes_select(_m458, _o459.time_error, time_claim);
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
