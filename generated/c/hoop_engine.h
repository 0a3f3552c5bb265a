/* The event loop of the scene hoop, LANES_WIDTH shots abreast.

   Generated from templates/c/engine.h.j2, scene hoop, derivation 8b478a501bbb95cb,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Included by hoop.c once for every width. The shots in flight fill the first rows of the lists;
   when one ends, the last takes its row. Stages go over all rows, and over those of a list of their
   own where only some shots need them. No shot's result depends on its neighbours. */

#include "hoop_lanes.h"
#include "hoop_kernels.h"

/* A column, with room for a whole row of lanes behind its end. */
typedef double LANES(hoop_column)[LANES_ROWS + LANES_WIDTH];
typedef float LANES(hoop_singles)[LANES_ROWS + LANES_WIDTH];

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
LANES_INLINE M LANES(hoop_permit)(V p_ball_radius, V p_ring_radius, V p_wire_radius, V p_board_distance, V p_board_half_width, V p_board_bottom, V p_board_top, V p_bridge_half_width, V p_restitution, V p_gravity, V p_end_depth)
{
    const LANES(hoop_allowed_out) _o1 =
        LANES(hoop_allowed)(p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_bridge_half_width, p_restitution, p_gravity, p_end_depth);
    V allowed = _o1.allowed;
    const LANES(hoop_parameters_in_range_out) _o2 =
        LANES(hoop_parameters_in_range)(p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_restitution, p_gravity, p_end_depth, allowed);
    M permitted = _o2.permitted;
    return permitted;
}

/* Shots in flight, a column for each quantity, and the lists of those that need a longer look. */
typedef struct {
    _Alignas(64) size_t shot[LANES_ROWS];
    LANES(hoop_column) x; /* of the state */
    LANES(hoop_column) y; /* of the state */
    LANES(hoop_column) z; /* of the state */
    LANES(hoop_column) vx; /* of the state */
    LANES(hoop_column) vy; /* of the state */
    LANES(hoop_column) vz; /* of the state */
    LANES(hoop_column) wx; /* of the state */
    LANES(hoop_column) wy; /* of the state */
    LANES(hoop_column) wz; /* of the state */
    LANES(hoop_column) clock; /* time of the last event, s since the release */
    LANES(hoop_column) last; /* surface that was touched last, -1: none */
    LANES(hoop_column) first; /* body that was touched first, -1: none */
    LANES(hoop_column) contacts; /* how many contacts there were */
    LANES(hoop_column) count_0; /* contacts with ring */
    LANES(hoop_column) count_1; /* contacts with backboard */
    LANES(hoop_column) count_2; /* contacts with bridge */
    LANES(hoop_column) outcome; /* how it ended, -1: in flight */
    LANES(hoop_column) p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_restitution, p_gravity, p_end_depth;
    LANES(hoop_column) x_before, y_before, z_before, vx_before, vy_before, vz_before, wx_before, wy_before, wz_before;
    LANES(hoop_column) body;
    LANES(hoop_column) permitted;
    LANES(hoop_column) limited;
    LANES(hoop_singles) time_error;
    LANES(hoop_column) when;
    LANES(hoop_column) which;
    LANES(hoop_column) open_row;
    LANES(hoop_column) open_extent;
    LANES(hoop_column) open_last;
    LANES(hoop_column) open_p_ball_radius;
    LANES(hoop_column) open_p_gravity;
    LANES(hoop_column) open_p_ring_radius;
    LANES(hoop_column) open_p_wire_radius;
    LANES(hoop_column) open_speed;
    LANES(hoop_column) open_until;
    LANES(hoop_column) open_vx;
    LANES(hoop_column) open_vy;
    LANES(hoop_column) open_vz;
    LANES(hoop_column) open_when;
    LANES(hoop_column) open_which;
    LANES(hoop_column) open_x;
    LANES(hoop_column) open_y;
    LANES(hoop_column) open_z;
    LANES(hoop_column) open_arrival;
    LANES(hoop_column) open_ceiling;
    LANES(hoop_column) open_certain;
    LANES(hoop_column) open_flat;
    LANES(hoop_column) open_rho_start;
    LANES(hoop_column) open_searching;
    LANES(hoop_column) open_served;
    LANES(hoop_column) open_share;
    LANES(hoop_singles) open_short_t;
    LANES(hoop_column) open_since;
    LANES(hoop_column) open_tilt;
    LANES(hoop_column) open_leaping_row;
    LANES(hoop_column) open_leaping_leaping;
    LANES(hoop_column) open_leaping_p_ball_radius;
    LANES(hoop_column) open_leaping_p_gravity;
    LANES(hoop_column) open_leaping_p_ring_radius;
    LANES(hoop_column) open_leaping_p_wire_radius;
    LANES(hoop_singles) open_leaping_short_ceiling;
    LANES(hoop_singles) open_leaping_short_drift;
    LANES(hoop_singles) open_leaping_short_end;
    LANES(hoop_singles) open_leaping_short_flat;
    LANES(hoop_singles) open_leaping_short_grit;
    LANES(hoop_singles) open_leaping_short_high1;
    LANES(hoop_singles) open_leaping_short_high2;
    LANES(hoop_singles) open_leaping_short_jerk;
    LANES(hoop_singles) open_leaping_short_low1;
    LANES(hoop_singles) open_leaping_short_low2;
    LANES(hoop_singles) open_leaping_short_parting;
    LANES(hoop_singles) open_leaping_short_rate_margin;
    LANES(hoop_singles) open_leaping_short_rho_start;
    LANES(hoop_singles) open_leaping_short_steady;
    LANES(hoop_singles) open_leaping_short_swing;
    LANES(hoop_singles) open_leaping_short_t;
    LANES(hoop_singles) open_leaping_short_tilt;
    LANES(hoop_singles) open_leaping_short_vx;
    LANES(hoop_singles) open_leaping_short_vy;
    LANES(hoop_singles) open_leaping_short_vz;
    LANES(hoop_singles) open_leaping_short_x;
    LANES(hoop_singles) open_leaping_short_y;
    LANES(hoop_singles) open_leaping_short_z;
    LANES(hoop_column) turning_p_ball_radius;
    LANES(hoop_column) turning_p_gravity;
    LANES(hoop_column) turning_p_ring_radius;
    LANES(hoop_column) turning_p_wire_radius;
    LANES(hoop_column) open_searching_row;
    LANES(hoop_column) open_searching_arrival;
    LANES(hoop_column) open_searching_certain;
    LANES(hoop_column) open_searching_extent;
    LANES(hoop_column) open_searching_last;
    LANES(hoop_column) open_searching_p_ball_radius;
    LANES(hoop_column) open_searching_p_gravity;
    LANES(hoop_column) open_searching_p_ring_radius;
    LANES(hoop_column) open_searching_p_wire_radius;
    LANES(hoop_column) open_searching_share;
    LANES(hoop_column) open_searching_speed;
    LANES(hoop_column) open_searching_t;
    LANES(hoop_column) open_searching_until;
    LANES(hoop_column) open_searching_vx;
    LANES(hoop_column) open_searching_vy;
    LANES(hoop_column) open_searching_vz;
    LANES(hoop_column) open_searching_x;
    LANES(hoop_column) open_searching_y;
    LANES(hoop_column) open_searching_z;
    LANES(hoop_column) open_searching_ceiling;
    LANES(hoop_column) open_searching_flat;
    LANES(hoop_column) open_searching_rho_start;
    LANES(hoop_column) open_searching_tilt;
    LANES(hoop_column) open_searching_searching_row;
    LANES(hoop_column) open_searching_searching_arrival;
    LANES(hoop_column) open_searching_searching_ceiling;
    LANES(hoop_column) open_searching_searching_certain;
    LANES(hoop_column) open_searching_searching_end;
    LANES(hoop_column) open_searching_searching_extent;
    LANES(hoop_column) open_searching_searching_flat;
    LANES(hoop_column) open_searching_searching_high0;
    LANES(hoop_column) open_searching_searching_high1;
    LANES(hoop_column) open_searching_searching_high2;
    LANES(hoop_column) open_searching_searching_last;
    LANES(hoop_column) open_searching_searching_latest;
    LANES(hoop_column) open_searching_searching_low0;
    LANES(hoop_column) open_searching_searching_low1;
    LANES(hoop_column) open_searching_searching_low2;
    LANES(hoop_column) open_searching_searching_p_ball_radius;
    LANES(hoop_column) open_searching_searching_p_gravity;
    LANES(hoop_column) open_searching_searching_p_ring_radius;
    LANES(hoop_column) open_searching_searching_p_wire_radius;
    LANES(hoop_column) open_searching_searching_rate_slack;
    LANES(hoop_column) open_searching_searching_rho_start;
    LANES(hoop_column) open_searching_searching_searching;
    LANES(hoop_column) open_searching_searching_share;
    LANES(hoop_column) open_searching_searching_speed;
    LANES(hoop_column) open_searching_searching_steady;
    LANES(hoop_column) open_searching_searching_swing;
    LANES(hoop_column) open_searching_searching_t;
    LANES(hoop_column) open_searching_searching_tilt;
    LANES(hoop_column) open_searching_searching_vx;
    LANES(hoop_column) open_searching_searching_vy;
    LANES(hoop_column) open_searching_searching_vz;
    LANES(hoop_column) open_searching_searching_x;
    LANES(hoop_column) open_searching_searching_y;
    LANES(hoop_column) open_searching_searching_z;
    LANES(hoop_column) open_arrives;
    LANES(hoop_column) open_refining_row;
    LANES(hoop_column) open_refining_arrival;
    LANES(hoop_column) open_refining_ceiling;
    LANES(hoop_column) open_refining_certain;
    LANES(hoop_column) open_refining_leaving;
    LANES(hoop_column) open_refining_p_ball_radius;
    LANES(hoop_column) open_refining_p_gravity;
    LANES(hoop_column) open_refining_p_ring_radius;
    LANES(hoop_column) open_refining_p_wire_radius;
    LANES(hoop_column) open_refining_refining;
    LANES(hoop_column) open_refining_rho_start;
    LANES(hoop_column) open_refining_vx;
    LANES(hoop_column) open_refining_vy;
    LANES(hoop_column) open_refining_vz;
    LANES(hoop_column) open_refining_x;
    LANES(hoop_column) open_refining_y;
    LANES(hoop_column) open_refining_z;
    /* What kernels make of parameters alone. */
    _Alignas(64) double fixed[53][LANES_WIDTH];
    _Alignas(64) float fixed_single[26][LANES_WIDTH];
} LANES(hoop_plain_lists);

/* Look at the parameters of a row of lanes. */
LANES_INLINE void LANES(hoop_plain_permitted)(LANES(hoop_plain_lists) *lists, size_t row)
{
    lanes_store(lists->permitted + row, lanes_select(LANES(hoop_permit)(lanes_load(lists->p_ball_radius + row), lanes_load(lists->p_ring_radius + row), lanes_load(lists->p_wire_radius + row), lanes_load(lists->p_board_distance + row), lanes_load(lists->p_board_half_width + row), lanes_load(lists->p_board_bottom + row), lanes_load(lists->p_board_top + row), lanes_load(lists->p_bridge_half_width + row), lanes_load(lists->p_restitution + row), lanes_load(lists->p_gravity + row), lanes_load(lists->p_end_depth + row)), K(1.0), K(0.0)));
}

/* Have zeros in the lanes behind the last row, which are computed with, too: not what memory held. */
LANES_INLINE void LANES(hoop_plain_fill)(LANES(hoop_plain_lists) *lists, size_t row, int varying)
{
    lanes_store(lists->x + row, K(0.0));
    lanes_store(lists->y + row, K(0.0));
    lanes_store(lists->z + row, K(0.0));
    lanes_store(lists->vx + row, K(0.0));
    lanes_store(lists->vy + row, K(0.0));
    lanes_store(lists->vz + row, K(0.0));
    lanes_store(lists->wx + row, K(0.0));
    lanes_store(lists->wy + row, K(0.0));
    lanes_store(lists->wz + row, K(0.0));
    lanes_store(lists->clock + row, K(0.0));
    lanes_store(lists->first + row, K(0.0));
    lanes_store(lists->contacts + row, K(0.0));
    lanes_store(lists->count_0 + row, K(0.0));
    lanes_store(lists->count_1 + row, K(0.0));
    lanes_store(lists->count_2 + row, K(0.0));
    lanes_store(lists->outcome + row, K(0.0));
    lanes_store(lists->last + row, K(0.0));
    if (varying) {
        lanes_store(lists->p_ball_radius + row, K(0.0));
        lanes_store(lists->p_ring_radius + row, K(0.0));
        lanes_store(lists->p_wire_radius + row, K(0.0));
        lanes_store(lists->p_board_distance + row, K(0.0));
        lanes_store(lists->p_board_half_width + row, K(0.0));
        lanes_store(lists->p_board_bottom + row, K(0.0));
        lanes_store(lists->p_board_top + row, K(0.0));
        lanes_store(lists->p_bridge_half_width + row, K(0.0));
        lanes_store(lists->p_restitution + row, K(0.0));
        lanes_store(lists->p_gravity + row, K(0.0));
        lanes_store(lists->p_end_depth + row, K(0.0));
        lanes_store(lists->permitted + row, K(0.0));
    }
}

/* Put the next shots into rows, from one on. */
LANES_INLINE void LANES(hoop_plain_begin)(LANES(hoop_plain_lists) *lists, size_t row, size_t shots, const hoop_job *job, size_t start)
{
    const double *state = job->states + HOOP_STATE * start;
    size_t k = 0;
    LANES(hoop_plain_fill)(lists, row + shots, job->varying);
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
        lanes_columns(columns, state + HOOP_STATE * k, HOOP_STATE);
    }
    for (; k < shots; k++) {
        lists->x[row + k] = state[HOOP_STATE * k + 0];
        lists->y[row + k] = state[HOOP_STATE * k + 1];
        lists->z[row + k] = state[HOOP_STATE * k + 2];
        lists->vx[row + k] = state[HOOP_STATE * k + 3];
        lists->vy[row + k] = state[HOOP_STATE * k + 4];
        lists->vz[row + k] = state[HOOP_STATE * k + 5];
        lists->wx[row + k] = state[HOOP_STATE * k + 6];
        lists->wy[row + k] = state[HOOP_STATE * k + 7];
        lists->wz[row + k] = state[HOOP_STATE * k + 8];
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
            lists->p_bridge_half_width[row + k] = job->parameters[7][job->strides[7] * (int64_t)(start + k)];
            lists->p_restitution[row + k] = job->parameters[8][job->strides[8] * (int64_t)(start + k)];
            lists->p_gravity[row + k] = job->parameters[9][job->strides[9] * (int64_t)(start + k)];
            lists->p_end_depth[row + k] = job->parameters[10][job->strides[10] * (int64_t)(start + k)];
        }
    if (job->varying)
        for (k = 0; k < shots; k += LANES_WIDTH)
            LANES(hoop_plain_permitted)(lists, row + k);
    for (k = 0; k < shots; k++)
        lists->shot[row + k] = start + k;
    for (k = 0; k < shots; k += LANES_WIDTH) {
        lanes_store(lists->clock + row + k, K(0.0));
        lanes_store(lists->first + row + k, K(-1.0));
        lanes_store(lists->contacts + row + k, K(0.0));
        lanes_store(lists->count_0 + row + k, K(0.0));
        lanes_store(lists->count_1 + row + k, K(0.0));
        lanes_store(lists->count_2 + row + k, K(0.0));
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
LANES_INLINE void LANES(hoop_plain_finish_all)(const LANES(hoop_plain_lists) *lists, size_t shots, const hoop_job *job)
{
    const hoop_results *out = job->results;
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
        double rows[HOOP_STATE * LANES_WIDTH];
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
            lanes_rows(rows, columns, HOOP_STATE);
            stream(out->state + HOOP_STATE * (start + k), rows, HOOP_STATE * some);
        }
    }
}

/* Write the results of the shot in a row. */
LANES_INLINE void LANES(hoop_plain_finish)(const LANES(hoop_plain_lists) *lists, size_t row, const hoop_job *job)
{
    const hoop_results *out = job->results;
    const size_t shot = lists->shot[row];
    const int invalid = (int)lists->outcome[row] == HOOP_OUTCOME_INVALID;
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
}

/* Write the results of the shots that have ended, from a row on; the others close up. */
LANES_INLINE size_t LANES(hoop_plain_leave)(LANES(hoop_plain_lists) *lists, size_t start, size_t shots, const hoop_job *job)
{
    size_t kept = start;
    for (size_t i = start; i < shots; i += LANES_WIDTH) {
        const M rows = lanes_first(shots - i);
        M going = lanes_both(rows, lanes_less(lanes_load(lists->outcome + i), K(0.0)));
        for (unsigned bits = lanes_bits(rows) & ~lanes_bits(going); bits; bits &= bits - 1)
            LANES(hoop_plain_finish)(lists, i + (size_t)LANES_LOWEST(bits), job);
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
            if (job->varying) {
                lanes_pack(lists->p_ball_radius + kept, going, lanes_load(lists->p_ball_radius + i));
                lanes_pack(lists->p_ring_radius + kept, going, lanes_load(lists->p_ring_radius + i));
                lanes_pack(lists->p_wire_radius + kept, going, lanes_load(lists->p_wire_radius + i));
                lanes_pack(lists->p_board_distance + kept, going, lanes_load(lists->p_board_distance + i));
                lanes_pack(lists->p_board_half_width + kept, going, lanes_load(lists->p_board_half_width + i));
                lanes_pack(lists->p_board_bottom + kept, going, lanes_load(lists->p_board_bottom + i));
                lanes_pack(lists->p_board_top + kept, going, lanes_load(lists->p_board_top + i));
                lanes_pack(lists->p_bridge_half_width + kept, going, lanes_load(lists->p_bridge_half_width + i));
                lanes_pack(lists->p_restitution + kept, going, lanes_load(lists->p_restitution + i));
                lanes_pack(lists->p_gravity + kept, going, lanes_load(lists->p_gravity + i));
                lanes_pack(lists->p_end_depth + kept, going, lanes_load(lists->p_end_depth + i));
            }
        }
        kept += lanes_many(going);
    }
    return kept;
}

/* Make what kernels are given ready made, of the parameters of the first row. */
static void LANES(hoop_plain_fix)(LANES(hoop_plain_lists) *lists)
{
    (void)lists;
    const V p_ball_radius = lanes_load(lists->p_ball_radius);
    const V p_board_bottom = lanes_load(lists->p_board_bottom);
    const V p_board_distance = lanes_load(lists->p_board_distance);
    const V p_board_half_width = lanes_load(lists->p_board_half_width);
    const V p_board_top = lanes_load(lists->p_board_top);
    const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width);
    const V p_end_depth = lanes_load(lists->p_end_depth);
    const V p_gravity = lanes_load(lists->p_gravity);
    const V p_restitution = lanes_load(lists->p_restitution);
    const V p_ring_radius = lanes_load(lists->p_ring_radius);
    const V p_wire_radius = lanes_load(lists->p_wire_radius);
    {
        const V _s0 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_abs(p_ball_radius), lanes_abs(p_board_bottom)), lanes_abs(p_board_distance)), lanes_abs(p_board_half_width)), lanes_abs(p_board_top)), lanes_abs(p_bridge_half_width));
        const V _s1 = lanes_sub(p_ball_radius, p_board_distance);
        const V _s2 = lanes_mul(K(2.0), p_ball_radius);
        const V _s3 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s4 = lanes_mul(K(2.0), p_wire_radius);
        const V _s5 = lanes_div(K(1.0), p_gravity);
        const V _s6 = lanes_neg(_s5);
        const V _s7 = lanes_mul(K(1.00006103515625), _s3);
        const V _s8 = lanes_add(p_ring_radius, _s7);
        const V _s9 = lanes_mul(_s8, _s8);
        const V _s10 = lanes_mul(K(9.313225746154785e-10), _s9);
        const V _s11 = lanes_sub(p_ring_radius, _s7);
        const V _s12 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s13 = lanes_max(_s11, _s12);
        const V _s14 = lanes_mul(_s13, _s13);
        const V _s15 = lanes_div(K(1.0), _s13);
        const V _s16 = lanes_div(_s7, _s13);
        lanes_store(lists->fixed[0], p_board_distance);
        lanes_store(lists->fixed[1], lanes_add(lanes_add(lanes_add(_s0, lanes_abs(p_end_depth)), lanes_abs(p_ring_radius)), lanes_abs(p_wire_radius)));
        lanes_store(lists->fixed[2], lanes_add(lanes_add(p_ball_radius, p_ring_radius), p_wire_radius));
        lanes_store(lists->fixed[3], _s1);
        lanes_store(lists->fixed[4], lanes_sub(_s1, _s2));
        lanes_store(lists->fixed[5], p_ring_radius);
        lanes_store(lists->fixed[6], p_board_half_width);
        lanes_store(lists->fixed[7], p_board_bottom);
        lanes_store(lists->fixed[8], p_board_top);
        lanes_store(lists->fixed[9], p_bridge_half_width);
        lanes_store(lists->fixed[10], _s3);
        lanes_store(lists->fixed[11], lanes_mul(_s3, _s3));
        lanes_store(lists->fixed[12], lanes_sub(lanes_sub(_s3, _s2), _s4));
        lanes_store(lists->fixed[13], lanes_add(lanes_mul(K(4.0), p_ball_radius), lanes_mul(K(4.0), p_wire_radius)));
        lanes_store(lists->fixed[14], _s5);
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[16], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[18], lanes_neg(p_gravity));
        lanes_store(lists->fixed[19], _s6);
        lanes_store(lists->fixed[20], lanes_mul(K(0.5), _s6));
        lanes_store(lists->fixed[21], lanes_mul(p_bridge_half_width, p_bridge_half_width));
        lanes_store(lists->fixed[22], lanes_neg(p_board_distance));
        lanes_store(lists->fixed[23], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[24], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s3)));
        lanes_store(lists->fixed[25], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[26], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[27], _s7);
        lanes_store(lists->fixed[28], lanes_mul(K(5.820766091346741e-11), _s8));
        lanes_store(lists->fixed[29], lanes_mul(K(65536.0), _s8));
        lanes_store(lists->fixed[30], _s9);
        lanes_store(lists->fixed[31], _s10);
        lanes_store(lists->fixed[32], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[33], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s3));
        lanes_store(lists->fixed[34], _s14);
        lanes_store(lists->fixed[35], lanes_mul(_s13, _s14));
        lanes_store(lists->fixed[36], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[37], lanes_add(_s10, _s14));
        lanes_store(lists->fixed[38], lanes_mul(_s15, lanes_mul(_s15, _s15)));
        lanes_store(lists->fixed[39], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[40], _s2);
        lanes_store(lists->fixed[41], _s4);
        lanes_store(lists->fixed[42], _s8);
        lanes_store(lists->fixed[43], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s3), _s8));
        lanes_store(lists->fixed[44], lanes_mul(K(5.00030517578125), _s3));
        lanes_store(lists->fixed[45], lanes_max(K(1.0), _s16));
        lanes_store(lists->fixed[46], lanes_mul(K(6.0), p_gravity));
        lanes_store(lists->fixed[47], lanes_mul(K(9.094947017729282e-13), _s8));
        lanes_store(lists->fixed[48], _s13);
        lanes_store(lists->fixed[49], lanes_div(K(1.0), _s3));
        lanes_store(lists->fixed[50], p_restitution);
        lanes_store(lists->fixed[51], lanes_mul(K(0.4), p_ball_radius));
        lanes_store(lists->fixed[52], lanes_div(K(1.0), p_ball_radius));
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
static void LANES(hoop_plain_fix_f1)(LANES(hoop_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->p_board_half_width + i);
    const V p_board_top = lanes_load(lists->p_board_top + i);
    const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + i);
    const V p_end_depth = lanes_load(lists->p_end_depth + i);
    const V p_ring_radius = lanes_load(lists->p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->p_wire_radius + i);
    {
        const V _s0 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_abs(p_ball_radius), lanes_abs(p_board_bottom)), lanes_abs(p_board_distance)), lanes_abs(p_board_half_width)), lanes_abs(p_board_top)), lanes_abs(p_bridge_half_width));
        const V _s1 = lanes_sub(p_ball_radius, p_board_distance);
        const V _s2 = lanes_mul(K(2.0), p_ball_radius);
        const V _s3 = lanes_add(p_ball_radius, p_wire_radius);
        lanes_store(lists->fixed[0], p_board_distance);
        lanes_store(lists->fixed[1], lanes_add(lanes_add(lanes_add(_s0, lanes_abs(p_end_depth)), lanes_abs(p_ring_radius)), lanes_abs(p_wire_radius)));
        lanes_store(lists->fixed[2], lanes_add(lanes_add(p_ball_radius, p_ring_radius), p_wire_radius));
        lanes_store(lists->fixed[3], _s1);
        lanes_store(lists->fixed[4], lanes_sub(_s1, _s2));
        lanes_store(lists->fixed[5], p_ring_radius);
        lanes_store(lists->fixed[6], p_board_half_width);
        lanes_store(lists->fixed[7], p_board_bottom);
        lanes_store(lists->fixed[8], p_board_top);
        lanes_store(lists->fixed[9], p_bridge_half_width);
        lanes_store(lists->fixed[10], _s3);
        lanes_store(lists->fixed[11], lanes_mul(_s3, _s3));
        lanes_store(lists->fixed[12], lanes_sub(lanes_sub(_s3, _s2), lanes_mul(K(2.0), p_wire_radius)));
        lanes_store(lists->fixed[13], lanes_add(lanes_mul(K(4.0), p_ball_radius), lanes_mul(K(4.0), p_wire_radius)));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(hoop_plain_fix_f7)(LANES(hoop_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->p_board_half_width + i);
    const V p_board_top = lanes_load(lists->p_board_top + i);
    const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + i);
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
        lanes_store(lists->fixed[0], p_board_distance);
        lanes_store(lists->fixed[3], lanes_sub(p_ball_radius, p_board_distance));
        lanes_store(lists->fixed[5], p_ring_radius);
        lanes_store(lists->fixed[6], p_board_half_width);
        lanes_store(lists->fixed[7], p_board_bottom);
        lanes_store(lists->fixed[8], p_board_top);
        lanes_store(lists->fixed[9], p_bridge_half_width);
        lanes_store(lists->fixed[10], _s0);
        lanes_store(lists->fixed[11], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[14], _s1);
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[16], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[18], lanes_neg(p_gravity));
        lanes_store(lists->fixed[19], _s2);
        lanes_store(lists->fixed[20], lanes_mul(K(0.5), _s2));
        lanes_store(lists->fixed[21], lanes_mul(p_bridge_half_width, p_bridge_half_width));
        lanes_store(lists->fixed[22], lanes_neg(p_board_distance));
        lanes_store(lists->fixed[23], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[24], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s0)));
        lanes_store(lists->fixed[25], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[26], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[27], _s3);
        lanes_store(lists->fixed[28], lanes_mul(K(5.820766091346741e-11), _s4));
        lanes_store(lists->fixed[29], lanes_mul(K(65536.0), _s4));
        lanes_store(lists->fixed[30], _s5);
        lanes_store(lists->fixed[31], _s6);
        lanes_store(lists->fixed[32], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[33], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s0));
        lanes_store(lists->fixed[34], _s10);
        lanes_store(lists->fixed[35], lanes_mul(_s9, _s10));
        lanes_store(lists->fixed[36], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[37], lanes_add(_s6, _s10));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(hoop_plain_fix_f44)(LANES(hoop_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->open_p_ball_radius + i);
    const V p_gravity = lanes_load(lists->open_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->open_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->open_p_wire_radius + i);
    {
        lanes_store(lists->fixed[5], p_ring_radius);
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[23], lanes_mul(K(0.5), p_gravity));
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
static void LANES(hoop_plain_fix_f55)(LANES(hoop_plain_lists) *lists, size_t taken, M idle)
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
static void LANES(hoop_plain_fix_f58)(LANES(hoop_plain_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[14], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[24], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s0)));
        lanes_store(lists->fixed[25], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[26], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[27], _s1);
        lanes_store(lists->fixed[30], lanes_mul(_s2, _s2));
        lanes_store(lists->fixed[32], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[33], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s0));
        lanes_store(lists->fixed[34], lanes_mul(_s5, _s5));
        lanes_store(lists->fixed[36], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[38], lanes_mul(_s6, lanes_mul(_s6, _s6)));
        lanes_store(lists->fixed[39], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[40], lanes_mul(K(2.0), p_ball_radius));
        lanes_store(lists->fixed[41], lanes_mul(K(2.0), p_wire_radius));
        lanes_store(lists->fixed[42], _s2);
        lanes_store(lists->fixed[43], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s0), _s2));
        lanes_store(lists->fixed[44], lanes_mul(K(5.00030517578125), _s0));
        lanes_store(lists->fixed[45], lanes_max(K(1.0), _s7));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(hoop_plain_fix_f63)(LANES(hoop_plain_lists) *lists, size_t taken, M idle)
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
        lanes_store(lists->fixed[5], p_ring_radius);
        lanes_store(lists->fixed[11], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[23], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[27], _s1);
        lanes_store(lists->fixed[42], _s2);
        lanes_store(lists->fixed[43], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s0), _s2));
        lanes_store(lists->fixed[44], lanes_mul(K(5.00030517578125), _s0));
        lanes_store(lists->fixed[45], lanes_max(K(1.0), _s6));
        lanes_store(lists->fixed[46], lanes_mul(K(6.0), p_gravity));
        lanes_store(lists->fixed[47], lanes_mul(K(9.094947017729282e-13), _s2));
        lanes_store(lists->fixed[48], _s5);
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(hoop_plain_fix_f74)(LANES(hoop_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->open_p_ball_radius + i);
    const V p_gravity = lanes_load(lists->open_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->open_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->open_p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        lanes_store(lists->fixed[5], p_ring_radius);
        lanes_store(lists->fixed[11], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[23], lanes_mul(K(0.5), p_gravity));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(hoop_plain_fix_f83)(LANES(hoop_plain_lists) *lists, size_t taken, M idle)
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
        lanes_store(lists->fixed[5], p_ring_radius);
        lanes_store(lists->fixed[11], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[23], lanes_mul(K(0.5), p_gravity));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(hoop_plain_fix_f88)(LANES(hoop_plain_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->p_ball_radius + i);
    const V p_board_distance = lanes_load(lists->p_board_distance + i);
    const V p_gravity = lanes_load(lists->p_gravity + i);
    const V p_restitution = lanes_load(lists->p_restitution + i);
    const V p_ring_radius = lanes_load(lists->p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        lanes_store(lists->fixed[3], lanes_sub(p_ball_radius, p_board_distance));
        lanes_store(lists->fixed[5], p_ring_radius);
        lanes_store(lists->fixed[10], _s0);
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[23], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[49], lanes_div(K(1.0), _s0));
        lanes_store(lists->fixed[50], p_restitution);
        lanes_store(lists->fixed[51], lanes_mul(K(0.4), p_ball_radius));
        lanes_store(lists->fixed[52], lanes_div(K(1.0), p_ball_radius));
    }
}

/* Run the job: fill the rows, take every shot to its next event, make room of those that ended.
   No errors are bounded: the same path, with less work. */
static void LANES(hoop_plain)(const hoop_job *job, LANES(hoop_plain_lists) *const restrict lists)
{
    const V most_contacts = K((double)job->max_contacts);
    const V time_limit = K(job->time_limit);
    const size_t varying = job->varying ? ~(size_t)0 : 0;
    const int recording = job->results->events != NULL;
    size_t begun = 0, end = 0, shots = 0;
    int streams = 0; /* whether the shots before ended all at once: then those to come will, too */

    if (job->shots == 0)
        return;
    lanes_store(lists->p_ball_radius, K(*job->parameters[0]));
    lanes_store(lists->p_ring_radius, K(*job->parameters[1]));
    lanes_store(lists->p_wire_radius, K(*job->parameters[2]));
    lanes_store(lists->p_board_distance, K(*job->parameters[3]));
    lanes_store(lists->p_board_half_width, K(*job->parameters[4]));
    lanes_store(lists->p_board_bottom, K(*job->parameters[5]));
    lanes_store(lists->p_board_top, K(*job->parameters[6]));
    lanes_store(lists->p_bridge_half_width, K(*job->parameters[7]));
    lanes_store(lists->p_restitution, K(*job->parameters[8]));
    lanes_store(lists->p_gravity, K(*job->parameters[9]));
    lanes_store(lists->p_end_depth, K(*job->parameters[10]));
    LANES(hoop_plain_permitted)(lists, 0);
    LANES(hoop_plain_fix)(lists);
    for (;;) {
        if (stopped(job))
            return;
        if (begun == end && end < job->shots)
            begun = hoop_take(job, &end);
        int following = shots == 0;
        const size_t fresh = shots;
        if (begun < end) {
            const size_t room = LANES_SHOTS - shots, left = end - begun;
            shots += left < room ? left : room;
            LANES(hoop_plain_begin)(lists, fresh, shots - fresh, job, begun);
            begun += shots - fresh;
        }
        if (shots == 0)
            return;

        /* A new shot is looked at once. */
        for (size_t i = fresh; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            if (LANES_SELDOM(varying))
                LANES(hoop_plain_fix_f1)(lists, i);
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
            const LANES(hoop_state_in_range_out) _o2 =
                LANES(hoop_state_in_range)(vx, vy, vz, wx, wy, wz, x, y, z);
            M in_range = _o2.in_range;
            const LANES(hoop_aside_out) _o3 =
                LANES(hoop_aside)(x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]));
            M close = _o3.close;
            V valid = _o3.valid;
            const M _m4 = lanes_both(rows, close);
            if (lanes_any(_m4)) {
                const LANES(hoop_valid_out) _o5 =
                    LANES(hoop_valid)(last, x, y, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[0]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[1]));
                valid = lanes_select(_m4, _o5.valid, valid);
            }
            const LANES(hoop_admitted_out) _o6 =
                LANES(hoop_admitted)(K(INFINITY), in_range, permitted, valid);
            V outcome = _o6.outcome;
            lanes_store(lists->outcome + i, outcome);
        }

        M refused = lanes_nowhere();
        for (size_t i = fresh; i < shots; i += LANES_WIDTH)
            refused = lanes_either(refused, lanes_both(lanes_first(shots - i), lanes_at_most(K(0.0), lanes_load(lists->outcome + i))));
        if (lanes_any(refused)) {
            shots = LANES(hoop_plain_leave)(lists, fresh, shots, job);
            following = 0;
        }

        /* To the next event, and what it does to the ball. */
        {
        size_t open_shots = 0;
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            LANES(hoop_ahead)(job, begun + i, streams);
            if (LANES_SELDOM(varying))
                LANES(hoop_plain_fix_f7)(lists, i);
            V last = lanes_load(lists->last + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const LANES(hoop_error_bounds_out) _o8 =
                LANES(hoop_error_bounds)(KS(0.0), KS(0.0), KS(0.0), KS(0.0), KS(0.0), KS(0.0), KS(0.0), KS(0.0), KS(0.0), KS(0.0));
            S time_error = _o8.time_error;
            const LANES(hoop_scale_out) _o9 =
                LANES(hoop_scale)(x, y, z, vx, vy, vz, lanes_load(lists->fixed[14]));
            V extent = _o9.extent;
            V speed = _o9.speed;
            V excess = _o9.excess;
            const LANES(hoop_opening_out) _o10 =
                LANES(hoop_opening)(excess, K(0.0), K(0.0));
            V when = _o10.when;
            V which = _o10.which;
            const LANES(hoop_limited_out) _o11 =
                LANES(hoop_limited)(time_limit);
            M limited = _o11.limited;
            const LANES(hoop_left_out) _o12 =
                LANES(hoop_left)(K(3.0), last);
            V leaving = _o12.leaving;
            const LANES(hoop_end_arrival_out) _o13 =
                LANES(hoop_end_arrival)(leaving, z, vz, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[18]), lanes_load(lists->fixed[19]), lanes_load(lists->fixed[20]));
            V time = _o13.time;
            V rate = _o13.rate;
            V bend = _o13.bend;
            V apex = _o13.apex;
            const LANES(hoop_meeting_plane_out) _o14 =
                LANES(hoop_meeting_plane)(apex, bend, rate, time);
            M arrives = _o14.arrives;
            const LANES(hoop_timely_out) _o15 =
                LANES(hoop_timely)(arrives, K(0.0), K(0.0), time, when);
            M possible = _o15.possible;
            const M _m16 = lanes_both(rows, possible);
            {
                const LANES(hoop_sooner_out) _o17 =
                    LANES(hoop_sooner)(arrives, K(3.0), time, when, which);
                when = lanes_select(_m16, _o17.when, when);
                which = lanes_select(_m16, _o17.which, which);
            }
            const LANES(hoop_released_out) _o18 =
                LANES(hoop_released)(last);
            M released = _o18.released;
            M reachable = _o18.reachable;
            const M _m19 = lanes_both(rows, released);
            if (lanes_any(_m19)) {
                const LANES(hoop_horizon_out) _o20 =
                    LANES(hoop_horizon)(when, speed, lanes_load(lists->fixed[14]));
                V until = _o20.horizon;
                V pad = _o20.pad;
                const LANES(hoop_reachable_out) _o21 =
                    LANES(hoop_reachable)(extent, until, K(0.0), pad, K(0.0), speed, K(0.0), vx, x, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[21]), lanes_load(lists->fixed[22]));
                reachable = lanes_choose(_m19, _o21.reachable, reachable);
            }
            const M _m22 = lanes_both(rows, reachable);
            if (lanes_any(_m22)) {
                const LANES(hoop_left_out) _o23 =
                    LANES(hoop_left)(K(1.0), last);
                V leaving = _o23.leaving;
                const LANES(hoop_backboard_arrival_out) _o24 =
                    LANES(hoop_backboard_arrival)(leaving, x, vx, lanes_load(lists->fixed[3]));
                V time = _o24.time;
                V rate = _o24.rate;
                V bend = _o24.bend;
                V apex = _o24.apex;
                const LANES(hoop_meeting_plane_out) _o25 =
                    LANES(hoop_meeting_plane)(apex, bend, rate, time);
                M arrives = _o25.arrives;
                const LANES(hoop_timely_out) _o26 =
                    LANES(hoop_timely)(arrives, K(0.0), K(0.0), time, when);
                M possible = _o26.possible;
                const M _m27 = lanes_both(_m22, possible);
                {
                    const LANES(hoop_flight_out) _o28 =
                        LANES(hoop_flight)(time, x, y, z, vx, vy, vz, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[23]));
                    V there_y = _o28.y;
                    V there_z = _o28.z;
                    const LANES(hoop_backboard_bounds_out) _o29 =
                        LANES(hoop_backboard_bounds)(there_y, there_z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]));
                    V g0 = _o29.g0;
                    V g1 = _o29.g1;
                    V g2 = _o29.g2;
                    V g3 = _o29.g3;
                    const LANES(hoop_backboard_within_out) _o30 =
                        LANES(hoop_backboard_within)(g0, g1, g2, g3);
                    M arrives = _o30.arrives;
                    const LANES(hoop_sooner_out) _o31 =
                        LANES(hoop_sooner)(arrives, K(1.0), time, when, which);
                    when = lanes_select(_m27, _o31.when, when);
                    which = lanes_select(_m27, _o31.which, which);
                }
                const LANES(hoop_left_out) _o32 =
                    LANES(hoop_left)(K(2.0), last);
                leaving = _o32.leaving;
                const LANES(hoop_bridge_arrival_out) _o33 =
                    LANES(hoop_bridge_arrival)(leaving, z, vz, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[18]), lanes_load(lists->fixed[19]), lanes_load(lists->fixed[20]));
                time = _o33.time;
                rate = _o33.rate;
                bend = _o33.bend;
                apex = _o33.apex;
                const LANES(hoop_meeting_plane_out) _o34 =
                    LANES(hoop_meeting_plane)(apex, bend, rate, time);
                arrives = _o34.arrives;
                const LANES(hoop_timely_out) _o35 =
                    LANES(hoop_timely)(arrives, K(0.0), K(0.0), time, when);
                possible = _o35.possible;
                const M _m36 = lanes_both(_m22, possible);
                if (lanes_any(_m36)) {
                    const LANES(hoop_flight_out) _o37 =
                        LANES(hoop_flight)(time, x, y, z, vx, vy, vz, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[23]));
                    V there_x = _o37.x;
                    V there_y = _o37.y;
                    const LANES(hoop_bridge_bounds_out) _o38 =
                        LANES(hoop_bridge_bounds)(there_x, there_y, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[0]), lanes_load(lists->fixed[9]));
                    V g0 = _o38.g0;
                    V g1 = _o38.g1;
                    V g2 = _o38.g2;
                    V g3 = _o38.g3;
                    V g4 = _o38.g4;
                    const LANES(hoop_bridge_within_out) _o39 =
                        LANES(hoop_bridge_within)(g0, g1, g2, g3, g4);
                    M arrives = _o39.arrives;
                    const LANES(hoop_sooner_out) _o40 =
                        LANES(hoop_sooner)(arrives, K(2.0), time, when, which);
                    when = lanes_select(_m36, _o40.when, when);
                    which = lanes_select(_m36, _o40.which, which);
                }
            }
            const LANES(hoop_horizon_out) _o41 =
                LANES(hoop_horizon)(when, speed, lanes_load(lists->fixed[14]));
            V until = _o41.horizon;
            const LANES(hoop_ring_clear_out) _o42 =
                LANES(hoop_ring_clear)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[24]), lanes_load(lists->fixed[25]), lanes_load(lists->fixed[26]), lanes_load(lists->fixed[27]), lanes_load(lists->fixed[28]), lanes_load(lists->fixed[29]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[14]), lanes_load(lists->fixed[23]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[34]), lanes_load(lists->fixed[35]), lanes_load(lists->fixed[36]), lanes_load(lists->fixed[37]));
            V clear = _o42.clear;
            const LANES(hoop_opens_out) _o43 =
                LANES(hoop_opens)(clear);
            M open = _o43.open;
            lanes_store(lists->limited + i, lanes_select(limited, K(1.0), K(0.0)));
            singles_store(lists->time_error + i, time_error);
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
        if (open_shots) {
            lanes_store(lists->open_row + open_shots, K(0.0));
            lanes_store(lists->open_extent + open_shots, K(0.0));
            lanes_store(lists->open_last + open_shots, K(0.0));
            lanes_store(lists->open_speed + open_shots, K(0.0));
            lanes_store(lists->open_until + open_shots, K(0.0));
            lanes_store(lists->open_vx + open_shots, K(0.0));
            lanes_store(lists->open_vy + open_shots, K(0.0));
            lanes_store(lists->open_vz + open_shots, K(0.0));
            lanes_store(lists->open_when + open_shots, K(0.0));
            lanes_store(lists->open_which + open_shots, K(0.0));
            lanes_store(lists->open_x + open_shots, K(0.0));
            lanes_store(lists->open_y + open_shots, K(0.0));
            lanes_store(lists->open_z + open_shots, K(0.0));
            if (LANES_SELDOM(varying)) {
                lanes_store(lists->open_p_ball_radius + open_shots, K(0.0));
                lanes_store(lists->open_p_gravity + open_shots, K(0.0));
                lanes_store(lists->open_p_ring_radius + open_shots, K(0.0));
                lanes_store(lists->open_p_wire_radius + open_shots, K(0.0));
            }
        }
        {
        size_t open_leaping_shots = 0;
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_shots - i);
            if (LANES_SELDOM(varying))
                LANES(hoop_plain_fix_f44)(lists, i);
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
            const LANES(hoop_beginning_out) _o45 =
                LANES(hoop_beginning)();
            V share = _o45.share;
            V arrival = _o45.arrival;
            M certain = _o45.certain;
            const LANES(hoop_left_out) _o46 =
                LANES(hoop_left)(K(0.0), last);
            V leaving = _o46.leaving;
            const LANES(hoop_ring_opened_out) _o47 =
                LANES(hoop_ring_opened)(lanes_narrow(until), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(extent), lanes_narrow(speed), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[2]), singles_load(lists->fixed_single[3]), singles_load(lists->fixed_single[4]), singles_load(lists->fixed_single[5]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[7]), singles_load(lists->fixed_single[8]), singles_load(lists->fixed_single[9]));
            S onset = _o47.t;
            S wide_end = _o47.end;
            M searching = _o47.searching;
            S wide_low1 = _o47.low1;
            S wide_high1 = _o47.high1;
            S wide_low2 = _o47.low2;
            S wide_high2 = _o47.high2;
            S lapsed = _o47.latest;
            M sound = _o47.sound;
            const LANES(hoop_opened_out) _o48 =
                LANES(hoop_opened)(lanes_wide(lapsed), lanes_wide(onset));
            V since = _o48.time;
            const LANES(hoop_ring_started_out) _o49 =
                LANES(hoop_ring_started)(x, y, z, vx, vy, vz, lanes_load(lists->fixed[5]));
            V rho_start = _o49.rho_start;
            V parting = _o49.parting;
            V drift = _o49.drift;
            const LANES(hoop_flight_out) _o50 =
                LANES(hoop_flight)(since, x, y, z, vx, vy, vz, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[23]));
            V near_x = _o50.x;
            V near_y = _o50.y;
            V near_z = _o50.z;
            V near_vz = _o50.vz;
            const LANES(hoop_ring_grain_out) _o51 =
                LANES(hoop_ring_grain)(onset, wide_end, lanes_narrow(leaving), lapsed, lanes_narrow(near_x), lanes_narrow(near_y), lanes_narrow(near_z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(near_vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(parting), lanes_narrow(drift), wide_low1, wide_high1, wide_low2, wide_high2, singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[10]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[11]), singles_load(lists->fixed_single[12]), singles_load(lists->fixed_single[13]), singles_load(lists->fixed_single[14]), singles_load(lists->fixed_single[15]), singles_load(lists->fixed_single[4]), singles_load(lists->fixed_single[16]), singles_load(lists->fixed_single[17]), singles_load(lists->fixed_single[18]));
            S short_share = _o51.share;
            S short_t = _o51.t;
            S short_end = _o51.end;
            S short_x = _o51.x;
            S short_y = _o51.y;
            S short_z = _o51.z;
            S short_vx = _o51.vx;
            S short_vy = _o51.vy;
            S short_vz = _o51.vz;
            S short_steady = _o51.steady;
            S short_swing = _o51.swing;
            S short_rho_start = _o51.rho_start;
            S short_ceiling = _o51.ceiling;
            S short_flat = _o51.flat;
            S short_tilt = _o51.tilt;
            S short_jerk = _o51.jerk;
            S short_grit = _o51.grit;
            S short_parting = _o51.parting;
            S short_drift = _o51.drift;
            S short_rate_margin = _o51.rate_margin;
            S short_low1 = _o51.low1;
            S short_high1 = _o51.high1;
            S short_low2 = _o51.low2;
            S short_high2 = _o51.high2;
            M fits = _o51.fits;
            const LANES(hoop_coarse_out) _o52 =
                LANES(hoop_coarse)(lanes_wide(short_ceiling), fits, lanes_wide(short_flat), lanes_wide(short_rate_margin), searching, lanes_wide(short_share), sound);
            M leaping = _o52.leaping;
            searching = _o52.searching;
            M served = _o52.served;
            V ceiling = _o52.ceiling;
            V flat = _o52.flat;
            V tilt = _o52.tilt;
            const M _m53 = lanes_both(rows, leaping);
            if (lanes_any(_m53)) {
                const LANES(hoop_ring_leap_out) _o54 =
                    LANES(hoop_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, singles_load(lists->fixed_single[19]), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[20]), singles_load(lists->fixed_single[21]), singles_load(lists->fixed_single[22]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[23]), singles_load(lists->fixed_single[24]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[25]));
                short_t = singles_select(singles_of(_m53), _o54.t, short_t);
                short_end = singles_select(singles_of(_m53), _o54.end, short_end);
                certain = lanes_choose(_m53, _o54.certain, certain);
                leaping = lanes_choose(_m53, _o54.leaping, leaping);
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
        if (open_leaping_shots) {
            lanes_store(lists->open_leaping_row + open_leaping_shots, K(0.0));
            singles_store(lists->open_leaping_short_ceiling + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_drift + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_end + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_flat + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_grit + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_high1 + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_high2 + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_jerk + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_low1 + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_low2 + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_parting + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_rate_margin + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_rho_start + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_steady + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_swing + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_t + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_tilt + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_vx + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_vy + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_vz + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_x + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_y + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_z + open_leaping_shots, KS(0.0));
            if (LANES_SELDOM(varying)) {
                lanes_store(lists->open_leaping_p_ball_radius + open_leaping_shots, K(0.0));
                lanes_store(lists->open_leaping_p_gravity + open_leaping_shots, K(0.0));
                lanes_store(lists->open_leaping_p_ring_radius + open_leaping_shots, K(0.0));
                lanes_store(lists->open_leaping_p_wire_radius + open_leaping_shots, K(0.0));
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
                        LANES(hoop_plain_fix_f55)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_leaping_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M leaping = active;
                const LANES(hoop_ring_leap_out) _o56 =
                    LANES(hoop_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, singles_load(lists->fixed_single[19]), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[20]), singles_load(lists->fixed_single[21]), singles_load(lists->fixed_single[22]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[23]), singles_load(lists->fixed_single[24]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[25]));
                short_t = _o56.t;
                short_end = _o56.end;
                M certain = _o56.certain;
                leaping = _o56.leaping;
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
            const LANES(hoop_leapt_out) _o57 =
                LANES(hoop_leapt)(arrival, certain, lanes_wide(short_t), searching, served, since);
            arrival = _o57.arrival;
            V t = _o57.t;
            searching = _o57.searching;
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
        if (open_searching_shots) {
            lanes_store(lists->open_searching_row + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_arrival + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_certain + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_extent + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_last + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_share + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_speed + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_t + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_until + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_vx + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_vy + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_vz + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_x + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_y + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_z + open_searching_shots, K(0.0));
            if (LANES_SELDOM(varying)) {
                lanes_store(lists->open_searching_p_ball_radius + open_searching_shots, K(0.0));
                lanes_store(lists->open_searching_p_gravity + open_searching_shots, K(0.0));
                lanes_store(lists->open_searching_p_ring_radius + open_searching_shots, K(0.0));
                lanes_store(lists->open_searching_p_wire_radius + open_searching_shots, K(0.0));
            }
        }
        {
        size_t open_searching_searching_shots = 0;
        for (size_t i = 0; i < open_searching_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_searching_shots - i);
            if (LANES_SELDOM(varying))
                LANES(hoop_plain_fix_f58)(lists, i);
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
            const LANES(hoop_ring_prepare_out) _o59 =
                LANES(hoop_ring_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[36]), lanes_load(lists->fixed[27]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[14]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[34]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[38]), lanes_load(lists->fixed[24]), lanes_load(lists->fixed[39]), lanes_load(lists->fixed[40]), lanes_load(lists->fixed[41]), lanes_load(lists->fixed[25]), lanes_load(lists->fixed[26]));
            V steady = _o59.steady;
            V swing = _o59.swing;
            V rho_start = _o59.rho_start;
            V low0 = _o59.low0;
            V high0 = _o59.high0;
            V low1 = _o59.low1;
            V high1 = _o59.high1;
            V low2 = _o59.low2;
            V high2 = _o59.high2;
            V ceiling = _o59.ceiling;
            V latest = _o59.latest;
            const LANES(hoop_allowance_out) _o60 =
                LANES(hoop_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[15]));
            V position_level = _o60.position_level;
            V velocity_level = _o60.velocity_level;
            const LANES(hoop_ring_margins_out) _o61 =
                LANES(hoop_ring_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[27]), lanes_load(lists->fixed[42]), lanes_load(lists->fixed[43]), lanes_load(lists->fixed[44]), lanes_load(lists->fixed[45]));
            V flat = _o61.margin;
            V tilt = _o61.leaving_margin;
            V rate_slack = _o61.rate_margin;
            const LANES(hoop_ring_enter_out) _o62 =
                LANES(hoop_ring_enter)(t, K(0.0), high0, high1, high2, low0, low1, low2, t);
            t = _o62.t;
            V end = _o62.end;
            M searching = _o62.searching;
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
        if (open_searching_searching_shots) {
            lanes_store(lists->open_searching_searching_row + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_arrival + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_ceiling + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_certain + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_end + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_extent + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_flat + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_high0 + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_high1 + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_high2 + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_last + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_latest + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_low0 + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_low1 + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_low2 + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_rate_slack + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_rho_start + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_share + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_speed + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_steady + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_swing + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_t + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_tilt + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_vx + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_vy + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_vz + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_x + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_y + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_z + open_searching_searching_shots, K(0.0));
            if (LANES_SELDOM(varying)) {
                lanes_store(lists->open_searching_searching_p_ball_radius + open_searching_searching_shots, K(0.0));
                lanes_store(lists->open_searching_searching_p_gravity + open_searching_searching_shots, K(0.0));
                lanes_store(lists->open_searching_searching_p_ring_radius + open_searching_searching_shots, K(0.0));
                lanes_store(lists->open_searching_searching_p_wire_radius + open_searching_searching_shots, K(0.0));
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
                        LANES(hoop_plain_fix_f63)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_searching_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(hoop_nearby_out) _o64 =
                    LANES(hoop_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = _o64.leaving;
                V margin = _o64.margin;
                const LANES(hoop_ring_advance_out) _o65 =
                    LANES(hoop_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[23]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[46]), lanes_load(lists->fixed[27]), lanes_load(lists->fixed[47]), lanes_load(lists->fixed[48]));
                V gap = _o65.gap;
                V rate = _o65.rate;
                V bend = _o65.bend;
                V step = _o65.step;
                V next = _o65.next;
                V clearance = _o65.clearance;
                const LANES(hoop_struck_out) _o66 =
                    LANES(hoop_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o66.hit;
                M sure = _o66.sure;
                M vague = _o66.vague;
                const M _m67 = lanes_both(active, vague);
                if (lanes_any(_m67)) {
                    const LANES(hoop_finer_out) _o68 =
                        LANES(hoop_finer)(share);
                    share = lanes_select(_m67, _o68.share, share);
                    const LANES(hoop_allowance_out) _o69 =
                        LANES(hoop_allowance)(share, latest, extent, speed, K(0.0), K(0.0), lanes_load(lists->fixed[15]));
                    V position_level = _o69.position_level;
                    V velocity_level = _o69.velocity_level;
                    const LANES(hoop_ring_margins_out) _o70 =
                        LANES(hoop_ring_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[27]), lanes_load(lists->fixed[42]), lanes_load(lists->fixed[43]), lanes_load(lists->fixed[44]), lanes_load(lists->fixed[45]));
                    flat = lanes_select(_m67, _o70.margin, flat);
                    tilt = lanes_select(_m67, _o70.leaving_margin, tilt);
                    rate_slack = lanes_select(_m67, _o70.rate_margin, rate_slack);
                }
                const LANES(hoop_advanced_out) _o71 =
                    LANES(hoop_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o71.arrival;
                certain = _o71.certain;
                M exhausted = _o71.exhausted;
                searching = _o71.searching;
                t = _o71.t;
                const M _m72 = lanes_both(active, exhausted);
                {
                    const LANES(hoop_ring_enter_out) _o73 =
                        LANES(hoop_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m72, _o73.t, t);
                    end = lanes_select(_m72, _o73.end, end);
                    searching = lanes_choose(_m72, _o73.searching, searching);
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
                LANES(hoop_plain_fix_f74)(lists, i);
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
            const LANES(hoop_found_out) _o75 =
                LANES(hoop_found)(arrival);
            M arrives = _o75.arrives;
            M refining = _o75.refining;
            const LANES(hoop_nearby_out) _o76 =
                LANES(hoop_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o76.leaving;
            const M _m77 = lanes_both(rows, refining);
            if (lanes_any(_m77)) {
                const LANES(hoop_ring_refine_out) _o78 =
                    LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[23]), lanes_load(lists->fixed[11]));
                V refined = _o78.time;
                V gap = _o78.gap;
                V rate = _o78.rate;
                const LANES(hoop_polished_out) _o79 =
                    LANES(hoop_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m77, _o79.arrival, arrival);
                refining = lanes_choose(_m77, _o79.refining, refining);
            }
            const M _m80 = lanes_both(rows, refining);
            if (lanes_any(_m80)) {
                const LANES(hoop_ring_refine_out) _o81 =
                    LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[23]), lanes_load(lists->fixed[11]));
                V refined = _o81.time;
                V gap = _o81.gap;
                V rate = _o81.rate;
                const LANES(hoop_polished_out) _o82 =
                    LANES(hoop_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m80, _o82.arrival, arrival);
                refining = lanes_choose(_m80, _o82.refining, refining);
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
        if (open_refining_shots) {
            lanes_store(lists->open_refining_row + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_arrival + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_ceiling + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_certain + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_leaving + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_rho_start + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_vx + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_vy + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_vz + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_x + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_y + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_z + open_refining_shots, K(0.0));
            if (LANES_SELDOM(varying)) {
                lanes_store(lists->open_refining_p_ball_radius + open_refining_shots, K(0.0));
                lanes_store(lists->open_refining_p_gravity + open_refining_shots, K(0.0));
                lanes_store(lists->open_refining_p_ring_radius + open_refining_shots, K(0.0));
                lanes_store(lists->open_refining_p_wire_radius + open_refining_shots, K(0.0));
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
                        LANES(hoop_plain_fix_f83)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(hoop_ring_refine_out) _o84 =
                    LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[23]), lanes_load(lists->fixed[11]));
                V refined = _o84.time;
                V gap = _o84.gap;
                V rate = _o84.rate;
                const LANES(hoop_polished_out) _o85 =
                    LANES(hoop_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o85.arrival;
                refining = _o85.refining;
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
            const LANES(hoop_landed_out) _o86 =
                LANES(hoop_landed)(arrival);
            V time = _o86.time;
            const LANES(hoop_sooner_out) _o87 =
                LANES(hoop_sooner)(arrives, K(0.0), time, when, which);
            when = _o87.when;
            which = _o87.which;
            lanes_store(lists->open_when + i, when);
            lanes_store(lists->open_which + i, which);
        }
        for (size_t k = 0; k < open_shots; k++) {
            const size_t row = (size_t)lists->open_row[k];
            lists->when[row] = lists->open_when[k];
            lists->which[row] = lists->open_which[k];
        }
        }
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            if (LANES_SELDOM(varying))
                LANES(hoop_plain_fix_f88)(lists, i);
            V clock = lanes_load(lists->clock + i);
            V contacts = lanes_load(lists->contacts + i);
            M limited = lanes_less(K(0.0), lanes_load(lists->limited + i));
            S time_error = singles_load(lists->time_error + i);
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
            const M _m89 = lanes_both(rows, limited);
            if (lanes_any(_m89)) {
                const LANES(hoop_expiry_out) _o90 =
                    LANES(hoop_expiry)(clock, K(INFINITY), K(0.0), lanes_wide(time_error), time_limit, when, which);
                V time = _o90.time;
                M arrives = _o90.arrives;
                const LANES(hoop_sooner_out) _o91 =
                    LANES(hoop_sooner)(arrives, K(4.0), time, when, which);
                when = lanes_select(_m89, _o91.when, when);
                which = lanes_select(_m89, _o91.which, which);
            }
            const LANES(hoop_departed_out) _o92 =
                LANES(hoop_departed)(K(3.0), which);
            M moves = _o92.moves;
            M ends = _o92.ends;
            M touches = _o92.touches;
            V reached = _o92.reached;
            const LANES(hoop_body_of_out) _o93 =
                LANES(hoop_body_of)(which);
            V body = _o93.body;
            const M _m94 = lanes_both(rows, moves);
            {
                const LANES(hoop_flight_out) _o95 =
                    LANES(hoop_flight)(when, x, y, z, vx, vy, vz, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[23]));
                x = lanes_select(_m94, _o95.x, x);
                y = lanes_select(_m94, _o95.y, y);
                z = lanes_select(_m94, _o95.z, z);
                vx = lanes_select(_m94, _o95.vx, vx);
                vy = lanes_select(_m94, _o95.vy, vy);
                vz = lanes_select(_m94, _o95.vz, vz);
                const LANES(hoop_ticked_out) _o96 =
                    LANES(hoop_ticked)(clock, when);
                clock = lanes_select(_m94, _o96.clock, clock);
            }
            const M _m97 = lanes_both(rows, limited);
            if (lanes_any(_m97)) {
                const LANES(hoop_expired_out) _o98 =
                    LANES(hoop_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m97, _o98.clock, clock);
                body = lanes_select(_m97, _o98.body, body);
                reached = lanes_select(_m97, _o98.reached, reached);
                ends = lanes_choose(_m97, _o98.ends, ends);
            }
            const LANES(hoop_here_out) _o99 =
                LANES(hoop_here)(K(3.0), which);
            M here = _o99.here;
            const M _m100 = lanes_both(rows, here);
            {
                const LANES(hoop_end_bounds_out) _o101 =
                    LANES(hoop_end_bounds)(x, y, lanes_load(lists->fixed[5]));
                V g0 = _o101.g0;
                const LANES(hoop_end_reached_out) _o102 =
                    LANES(hoop_end_reached)(g0);
                reached = lanes_select(_m100, _o102.reached, reached);
            }
            const LANES(hoop_accounted_out) _o103 =
                LANES(hoop_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o103.contacts;
            V outcome = _o103.outcome;
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
            const LANES(hoop_meeting_out) _o104 =
                LANES(hoop_meeting)(K(0.0), ends, touches);
            M meeting = _o104.meeting;
            const M _m105 = lanes_both(rows, meeting);
            if (lanes_any(_m105)) {
                V count_0 = lanes_load(lists->count_0 + i);
                V count_1 = lanes_load(lists->count_1 + i);
                V count_2 = lanes_load(lists->count_2 + i);
                V first = lanes_load(lists->first + i);
                V last = lanes_load(lists->last + i);
                const LANES(hoop_end_normal_out) _o106 =
                    LANES(hoop_end_normal)();
                V nx = _o106.nx;
                V ny = _o106.ny;
                V nz = _o106.nz;
                const LANES(hoop_here_out) _o107 =
                    LANES(hoop_here)(K(0.0), which);
                M here = _o107.here;
                const M _m108 = lanes_both(_m105, here);
                {
                    const LANES(hoop_ring_normal_out) _o109 =
                        LANES(hoop_ring_normal)(x, y, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[49]));
                    nx = lanes_select(_m108, _o109.nx, nx);
                    ny = lanes_select(_m108, _o109.ny, ny);
                    nz = lanes_select(_m108, _o109.nz, nz);
                    const LANES(hoop_counted_out) _o110 =
                        LANES(hoop_counted)(count_0);
                    count_0 = lanes_select(_m108, _o110.count, count_0);
                }
                const LANES(hoop_here_out) _o111 =
                    LANES(hoop_here)(K(1.0), which);
                here = _o111.here;
                const M _m112 = lanes_both(_m105, here);
                {
                    const LANES(hoop_backboard_normal_out) _o113 =
                        LANES(hoop_backboard_normal)();
                    nx = lanes_select(_m112, _o113.nx, nx);
                    ny = lanes_select(_m112, _o113.ny, ny);
                    nz = lanes_select(_m112, _o113.nz, nz);
                    const LANES(hoop_counted_out) _o114 =
                        LANES(hoop_counted)(count_1);
                    count_1 = lanes_select(_m112, _o114.count, count_1);
                }
                const LANES(hoop_here_out) _o115 =
                    LANES(hoop_here)(K(2.0), which);
                here = _o115.here;
                const M _m116 = lanes_both(_m105, here);
                {
                    const LANES(hoop_bridge_normal_out) _o117 =
                        LANES(hoop_bridge_normal)();
                    nx = lanes_select(_m116, _o117.nx, nx);
                    ny = lanes_select(_m116, _o117.ny, ny);
                    nz = lanes_select(_m116, _o117.nz, nz);
                    const LANES(hoop_counted_out) _o118 =
                        LANES(hoop_counted)(count_2);
                    count_2 = lanes_select(_m116, _o118.count, count_2);
                }
                const M _m119 = lanes_both(_m105, touches);
                if (lanes_any(_m119)) {
                    const LANES(hoop_impact_out) _o120 =
                        LANES(hoop_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, lanes_load(lists->fixed[50]), lanes_load(lists->fixed[51]), lanes_load(lists->fixed[52]));
                    vx = lanes_select(_m119, _o120.vx, vx);
                    vy = lanes_select(_m119, _o120.vy, vy);
                    vz = lanes_select(_m119, _o120.vz, vz);
                    wx = lanes_select(_m119, _o120.wx, wx);
                    wy = lanes_select(_m119, _o120.wy, wy);
                    wz = lanes_select(_m119, _o120.wz, wz);
                }
                const LANES(hoop_here_out) _o121 =
                    LANES(hoop_here)(K(1.0), which);
                here = _o121.here;
                const M _m122 = lanes_both(_m105, here);
                {
                    const LANES(hoop_backboard_place_out) _o123 =
                        LANES(hoop_backboard_place)(y, z, lanes_load(lists->fixed[3]));
                    x = lanes_select(_m122, _o123.x, x);
                    y = lanes_select(_m122, _o123.y, y);
                    z = lanes_select(_m122, _o123.z, z);
                }
                const LANES(hoop_here_out) _o124 =
                    LANES(hoop_here)(K(2.0), which);
                here = _o124.here;
                const M _m125 = lanes_both(_m105, here);
                {
                    const LANES(hoop_bridge_place_out) _o126 =
                        LANES(hoop_bridge_place)(x, y, lanes_load(lists->fixed[10]));
                    x = lanes_select(_m125, _o126.x, x);
                    y = lanes_select(_m125, _o126.y, y);
                    z = lanes_select(_m125, _o126.z, z);
                }
                const M _m127 = lanes_both(_m105, touches);
                {
                    const LANES(hoop_touched_out) _o128 =
                        LANES(hoop_touched)(body, first, which);
                    first = lanes_select(_m127, _o128.first, first);
                    last = lanes_select(_m127, _o128.last, last);
                }
                lanes_store(lists->count_0 + i, count_0);
                lanes_store(lists->count_1 + i, count_1);
                lanes_store(lists->count_2 + i, count_2);
                lanes_store(lists->first + i, first);
                lanes_store(lists->last + i, last);
                lanes_store(lists->wx + i, wx);
                lanes_store(lists->wy + i, wy);
                lanes_store(lists->wz + i, wz);
            }
            lanes_store(lists->clock + i, clock);
            lanes_store(lists->contacts + i, contacts);
            lanes_store(lists->outcome + i, outcome);
            lanes_store(lists->vx + i, vx);
            lanes_store(lists->vy + i, vy);
            lanes_store(lists->vz + i, vz);
            lanes_store(lists->x + i, x);
            lanes_store(lists->y + i, y);
            lanes_store(lists->z + i, z);
        }
        if (recording)
            for (size_t k = 0; k < shots; k++) {
                if (lists->body[k] < 0.0)
                    continue;
                const size_t shot = lists->shot[k], rows = HOOP_LOG_ROWS * (size_t)job->max_contacts + 1;
                int32_t *used = job->results->event_counts + shot;
                hoop_event *event = job->results->events + shot * rows + (size_t)(*used)++;
                const int64_t body = (int64_t)lists->body[k], staying = body - HOOP_SURFACES - 1;
                event->shot = (int64_t)shot;
                event->surface = staying < 0 ? body : staying / 2;
                event->kind = staying < -1 ? HOOP_EVENT_IMPACT : staying < 0 ? HOOP_EVENT_END : staying % 2 ? HOOP_EVENT_LEAVE : HOOP_EVENT_ROLL;
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
            LANES(hoop_plain_finish_all)(lists, shots, job);
            shots = 0;
            streams = 1;
            continue;
        }
        streams = 0;
        shots = LANES(hoop_plain_leave)(lists, 0, shots, job);
    }
}

/* Shots in flight, a column for each quantity, and the lists of those that need a longer look. */
typedef struct {
    _Alignas(64) size_t shot[LANES_ROWS];
    LANES(hoop_column) x; /* of the state */
    LANES(hoop_column) y; /* of the state */
    LANES(hoop_column) z; /* of the state */
    LANES(hoop_column) vx; /* of the state */
    LANES(hoop_column) vy; /* of the state */
    LANES(hoop_column) vz; /* of the state */
    LANES(hoop_column) wx; /* of the state */
    LANES(hoop_column) wy; /* of the state */
    LANES(hoop_column) wz; /* of the state */
    LANES(hoop_singles) dx; /* carried error of x */
    LANES(hoop_singles) dy; /* carried error of y */
    LANES(hoop_singles) dz; /* carried error of z */
    LANES(hoop_singles) dvx; /* carried error of vx */
    LANES(hoop_singles) dvy; /* carried error of vy */
    LANES(hoop_singles) dvz; /* carried error of vz */
    LANES(hoop_singles) dwx; /* carried error of wx */
    LANES(hoop_singles) dwy; /* carried error of wy */
    LANES(hoop_singles) dwz; /* carried error of wz */
    LANES(hoop_column) clock; /* time of the last event, s since the release */
    LANES(hoop_singles) clock_error; /* what the contacts' times were off by, summed */
    LANES(hoop_column) last; /* surface that was touched last, -1: none */
    LANES(hoop_column) first; /* body that was touched first, -1: none */
    LANES(hoop_column) contacts; /* how many contacts there were */
    LANES(hoop_column) count_0; /* contacts with ring */
    LANES(hoop_column) count_1; /* contacts with backboard */
    LANES(hoop_column) count_2; /* contacts with bridge */
    LANES(hoop_column) uncertain; /* 1: a decision lies within its rounding-error bound */
    LANES(hoop_singles) position_claim; /* bound on the error at the end */
    LANES(hoop_singles) velocity_claim; /* bound on the error at the end */
    LANES(hoop_singles) spin_claim; /* bound on the error at the end */
    LANES(hoop_singles) time_claim; /* bound on the error at the end */
    LANES(hoop_column) outcome; /* how it ended, -1: in flight */
    LANES(hoop_column) p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_restitution, p_gravity, p_end_depth;
    LANES(hoop_column) x_before, y_before, z_before, vx_before, vy_before, vz_before, wx_before, wy_before, wz_before;
    LANES(hoop_column) body;
    LANES(hoop_column) permitted;
    LANES(hoop_column) doubt;
    LANES(hoop_column) extent;
    LANES(hoop_column) late;
    LANES(hoop_column) limited;
    LANES(hoop_singles) position_error;
    LANES(hoop_column) speed;
    LANES(hoop_singles) time_error;
    LANES(hoop_singles) velocity_error;
    LANES(hoop_column) when;
    LANES(hoop_column) which;
    LANES(hoop_column) open_row;
    LANES(hoop_column) open_doubt;
    LANES(hoop_column) open_extent;
    LANES(hoop_column) open_last;
    LANES(hoop_column) open_late;
    LANES(hoop_column) open_p_ball_radius;
    LANES(hoop_column) open_p_gravity;
    LANES(hoop_column) open_p_ring_radius;
    LANES(hoop_column) open_p_wire_radius;
    LANES(hoop_column) open_pad;
    LANES(hoop_singles) open_position_error;
    LANES(hoop_column) open_speed;
    LANES(hoop_column) open_until;
    LANES(hoop_singles) open_velocity_error;
    LANES(hoop_column) open_vx;
    LANES(hoop_column) open_vy;
    LANES(hoop_column) open_vz;
    LANES(hoop_column) open_when;
    LANES(hoop_column) open_which;
    LANES(hoop_column) open_x;
    LANES(hoop_column) open_y;
    LANES(hoop_column) open_z;
    LANES(hoop_column) open_arrival;
    LANES(hoop_column) open_ceiling;
    LANES(hoop_column) open_certain;
    LANES(hoop_column) open_flat;
    LANES(hoop_column) open_latest;
    LANES(hoop_column) open_rho_start;
    LANES(hoop_column) open_searching;
    LANES(hoop_column) open_served;
    LANES(hoop_column) open_share;
    LANES(hoop_singles) open_short_t;
    LANES(hoop_column) open_since;
    LANES(hoop_column) open_tilt;
    LANES(hoop_column) open_leaping_row;
    LANES(hoop_column) open_leaping_leaping;
    LANES(hoop_column) open_leaping_p_ball_radius;
    LANES(hoop_column) open_leaping_p_gravity;
    LANES(hoop_column) open_leaping_p_ring_radius;
    LANES(hoop_column) open_leaping_p_wire_radius;
    LANES(hoop_singles) open_leaping_short_ceiling;
    LANES(hoop_singles) open_leaping_short_drift;
    LANES(hoop_singles) open_leaping_short_end;
    LANES(hoop_singles) open_leaping_short_flat;
    LANES(hoop_singles) open_leaping_short_grit;
    LANES(hoop_singles) open_leaping_short_high1;
    LANES(hoop_singles) open_leaping_short_high2;
    LANES(hoop_singles) open_leaping_short_jerk;
    LANES(hoop_singles) open_leaping_short_low1;
    LANES(hoop_singles) open_leaping_short_low2;
    LANES(hoop_singles) open_leaping_short_parting;
    LANES(hoop_singles) open_leaping_short_rate_margin;
    LANES(hoop_singles) open_leaping_short_rho_start;
    LANES(hoop_singles) open_leaping_short_steady;
    LANES(hoop_singles) open_leaping_short_swing;
    LANES(hoop_singles) open_leaping_short_t;
    LANES(hoop_singles) open_leaping_short_tilt;
    LANES(hoop_singles) open_leaping_short_vx;
    LANES(hoop_singles) open_leaping_short_vy;
    LANES(hoop_singles) open_leaping_short_vz;
    LANES(hoop_singles) open_leaping_short_x;
    LANES(hoop_singles) open_leaping_short_y;
    LANES(hoop_singles) open_leaping_short_z;
    LANES(hoop_column) turning_p_ball_radius;
    LANES(hoop_column) turning_p_gravity;
    LANES(hoop_column) turning_p_ring_radius;
    LANES(hoop_column) turning_p_wire_radius;
    LANES(hoop_column) open_searching_row;
    LANES(hoop_column) open_searching_arrival;
    LANES(hoop_column) open_searching_certain;
    LANES(hoop_column) open_searching_doubt;
    LANES(hoop_column) open_searching_extent;
    LANES(hoop_column) open_searching_last;
    LANES(hoop_column) open_searching_p_ball_radius;
    LANES(hoop_column) open_searching_p_gravity;
    LANES(hoop_column) open_searching_p_ring_radius;
    LANES(hoop_column) open_searching_p_wire_radius;
    LANES(hoop_singles) open_searching_position_error;
    LANES(hoop_column) open_searching_share;
    LANES(hoop_column) open_searching_speed;
    LANES(hoop_column) open_searching_t;
    LANES(hoop_column) open_searching_until;
    LANES(hoop_singles) open_searching_velocity_error;
    LANES(hoop_column) open_searching_vx;
    LANES(hoop_column) open_searching_vy;
    LANES(hoop_column) open_searching_vz;
    LANES(hoop_column) open_searching_x;
    LANES(hoop_column) open_searching_y;
    LANES(hoop_column) open_searching_z;
    LANES(hoop_column) open_searching_ceiling;
    LANES(hoop_column) open_searching_flat;
    LANES(hoop_column) open_searching_latest;
    LANES(hoop_column) open_searching_rho_start;
    LANES(hoop_column) open_searching_searching;
    LANES(hoop_column) open_searching_tilt;
    LANES(hoop_column) open_searching_searching_row;
    LANES(hoop_column) open_searching_searching_arrival;
    LANES(hoop_column) open_searching_searching_ceiling;
    LANES(hoop_column) open_searching_searching_certain;
    LANES(hoop_column) open_searching_searching_doubt;
    LANES(hoop_column) open_searching_searching_end;
    LANES(hoop_column) open_searching_searching_extent;
    LANES(hoop_column) open_searching_searching_flat;
    LANES(hoop_column) open_searching_searching_high0;
    LANES(hoop_column) open_searching_searching_high1;
    LANES(hoop_column) open_searching_searching_high2;
    LANES(hoop_column) open_searching_searching_last;
    LANES(hoop_column) open_searching_searching_latest;
    LANES(hoop_column) open_searching_searching_low0;
    LANES(hoop_column) open_searching_searching_low1;
    LANES(hoop_column) open_searching_searching_low2;
    LANES(hoop_column) open_searching_searching_p_ball_radius;
    LANES(hoop_column) open_searching_searching_p_gravity;
    LANES(hoop_column) open_searching_searching_p_ring_radius;
    LANES(hoop_column) open_searching_searching_p_wire_radius;
    LANES(hoop_singles) open_searching_searching_position_error;
    LANES(hoop_column) open_searching_searching_rate_slack;
    LANES(hoop_column) open_searching_searching_rho_start;
    LANES(hoop_column) open_searching_searching_searching;
    LANES(hoop_column) open_searching_searching_share;
    LANES(hoop_column) open_searching_searching_speed;
    LANES(hoop_column) open_searching_searching_steady;
    LANES(hoop_column) open_searching_searching_swing;
    LANES(hoop_column) open_searching_searching_t;
    LANES(hoop_column) open_searching_searching_tilt;
    LANES(hoop_singles) open_searching_searching_velocity_error;
    LANES(hoop_column) open_searching_searching_vx;
    LANES(hoop_column) open_searching_searching_vy;
    LANES(hoop_column) open_searching_searching_vz;
    LANES(hoop_column) open_searching_searching_x;
    LANES(hoop_column) open_searching_searching_y;
    LANES(hoop_column) open_searching_searching_z;
    LANES(hoop_column) open_arrives;
    LANES(hoop_column) open_leaving;
    LANES(hoop_column) open_rate;
    LANES(hoop_column) open_refining_row;
    LANES(hoop_column) open_refining_arrival;
    LANES(hoop_column) open_refining_ceiling;
    LANES(hoop_column) open_refining_certain;
    LANES(hoop_column) open_refining_leaving;
    LANES(hoop_column) open_refining_p_ball_radius;
    LANES(hoop_column) open_refining_p_gravity;
    LANES(hoop_column) open_refining_p_ring_radius;
    LANES(hoop_column) open_refining_p_wire_radius;
    LANES(hoop_column) open_refining_refining;
    LANES(hoop_column) open_refining_rho_start;
    LANES(hoop_column) open_refining_vx;
    LANES(hoop_column) open_refining_vy;
    LANES(hoop_column) open_refining_vz;
    LANES(hoop_column) open_refining_x;
    LANES(hoop_column) open_refining_y;
    LANES(hoop_column) open_refining_z;
    /* What kernels make of parameters alone. */
    _Alignas(64) double fixed[58][LANES_WIDTH];
    _Alignas(64) float fixed_single[33][LANES_WIDTH];
} LANES(hoop_bounded_lists);

/* Look at the parameters of a row of lanes. */
LANES_INLINE void LANES(hoop_bounded_permitted)(LANES(hoop_bounded_lists) *lists, size_t row)
{
    lanes_store(lists->permitted + row, lanes_select(LANES(hoop_permit)(lanes_load(lists->p_ball_radius + row), lanes_load(lists->p_ring_radius + row), lanes_load(lists->p_wire_radius + row), lanes_load(lists->p_board_distance + row), lanes_load(lists->p_board_half_width + row), lanes_load(lists->p_board_bottom + row), lanes_load(lists->p_board_top + row), lanes_load(lists->p_bridge_half_width + row), lanes_load(lists->p_restitution + row), lanes_load(lists->p_gravity + row), lanes_load(lists->p_end_depth + row)), K(1.0), K(0.0)));
}

/* Have zeros in the lanes behind the last row, which are computed with, too: not what memory held. */
LANES_INLINE void LANES(hoop_bounded_fill)(LANES(hoop_bounded_lists) *lists, size_t row, int varying)
{
    lanes_store(lists->x + row, K(0.0));
    lanes_store(lists->y + row, K(0.0));
    lanes_store(lists->z + row, K(0.0));
    lanes_store(lists->vx + row, K(0.0));
    lanes_store(lists->vy + row, K(0.0));
    lanes_store(lists->vz + row, K(0.0));
    lanes_store(lists->wx + row, K(0.0));
    lanes_store(lists->wy + row, K(0.0));
    lanes_store(lists->wz + row, K(0.0));
    singles_store(lists->dx + row, KS(0.0));
    singles_store(lists->dy + row, KS(0.0));
    singles_store(lists->dz + row, KS(0.0));
    singles_store(lists->dvx + row, KS(0.0));
    singles_store(lists->dvy + row, KS(0.0));
    singles_store(lists->dvz + row, KS(0.0));
    singles_store(lists->dwx + row, KS(0.0));
    singles_store(lists->dwy + row, KS(0.0));
    singles_store(lists->dwz + row, KS(0.0));
    lanes_store(lists->clock + row, K(0.0));
    singles_store(lists->clock_error + row, KS(0.0));
    lanes_store(lists->first + row, K(0.0));
    lanes_store(lists->contacts + row, K(0.0));
    lanes_store(lists->count_0 + row, K(0.0));
    lanes_store(lists->count_1 + row, K(0.0));
    lanes_store(lists->count_2 + row, K(0.0));
    lanes_store(lists->uncertain + row, K(0.0));
    singles_store(lists->position_claim + row, KS(0.0));
    singles_store(lists->velocity_claim + row, KS(0.0));
    singles_store(lists->spin_claim + row, KS(0.0));
    singles_store(lists->time_claim + row, KS(0.0));
    lanes_store(lists->outcome + row, K(0.0));
    lanes_store(lists->last + row, K(0.0));
    if (varying) {
        lanes_store(lists->p_ball_radius + row, K(0.0));
        lanes_store(lists->p_ring_radius + row, K(0.0));
        lanes_store(lists->p_wire_radius + row, K(0.0));
        lanes_store(lists->p_board_distance + row, K(0.0));
        lanes_store(lists->p_board_half_width + row, K(0.0));
        lanes_store(lists->p_board_bottom + row, K(0.0));
        lanes_store(lists->p_board_top + row, K(0.0));
        lanes_store(lists->p_bridge_half_width + row, K(0.0));
        lanes_store(lists->p_restitution + row, K(0.0));
        lanes_store(lists->p_gravity + row, K(0.0));
        lanes_store(lists->p_end_depth + row, K(0.0));
        lanes_store(lists->permitted + row, K(0.0));
    }
}

/* Put the next shots into rows, from one on. */
LANES_INLINE void LANES(hoop_bounded_begin)(LANES(hoop_bounded_lists) *lists, size_t row, size_t shots, const hoop_job *job, size_t start)
{
    const double *state = job->states + HOOP_STATE * start;
    size_t k = 0;
    LANES(hoop_bounded_fill)(lists, row + shots, job->varying);
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
        lanes_columns(columns, state + HOOP_STATE * k, HOOP_STATE);
    }
    for (; k < shots; k++) {
        lists->x[row + k] = state[HOOP_STATE * k + 0];
        lists->y[row + k] = state[HOOP_STATE * k + 1];
        lists->z[row + k] = state[HOOP_STATE * k + 2];
        lists->vx[row + k] = state[HOOP_STATE * k + 3];
        lists->vy[row + k] = state[HOOP_STATE * k + 4];
        lists->vz[row + k] = state[HOOP_STATE * k + 5];
        lists->wx[row + k] = state[HOOP_STATE * k + 6];
        lists->wy[row + k] = state[HOOP_STATE * k + 7];
        lists->wz[row + k] = state[HOOP_STATE * k + 8];
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
            lists->p_bridge_half_width[row + k] = job->parameters[7][job->strides[7] * (int64_t)(start + k)];
            lists->p_restitution[row + k] = job->parameters[8][job->strides[8] * (int64_t)(start + k)];
            lists->p_gravity[row + k] = job->parameters[9][job->strides[9] * (int64_t)(start + k)];
            lists->p_end_depth[row + k] = job->parameters[10][job->strides[10] * (int64_t)(start + k)];
        }
    if (job->varying)
        for (k = 0; k < shots; k += LANES_WIDTH)
            LANES(hoop_bounded_permitted)(lists, row + k);
    for (k = 0; k < shots; k++)
        lists->shot[row + k] = start + k;
    for (k = 0; k < shots; k += LANES_WIDTH) {
        singles_store(lists->dx + row + k, KS(0.0));
        singles_store(lists->dy + row + k, KS(0.0));
        singles_store(lists->dz + row + k, KS(0.0));
        singles_store(lists->dvx + row + k, KS(0.0));
        singles_store(lists->dvy + row + k, KS(0.0));
        singles_store(lists->dvz + row + k, KS(0.0));
        singles_store(lists->dwx + row + k, KS(0.0));
        singles_store(lists->dwy + row + k, KS(0.0));
        singles_store(lists->dwz + row + k, KS(0.0));
        lanes_store(lists->clock + row + k, K(0.0));
        singles_store(lists->clock_error + row + k, KS(0.0));
        lanes_store(lists->first + row + k, K(-1.0));
        lanes_store(lists->contacts + row + k, K(0.0));
        lanes_store(lists->count_0 + row + k, K(0.0));
        lanes_store(lists->count_1 + row + k, K(0.0));
        lanes_store(lists->count_2 + row + k, K(0.0));
        lanes_store(lists->uncertain + row + k, K(0.0));
        singles_store(lists->position_claim + row + k, KS(0.0));
        singles_store(lists->velocity_claim + row + k, KS(0.0));
        singles_store(lists->spin_claim + row + k, KS(0.0));
        singles_store(lists->time_claim + row + k, KS(0.0));
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
LANES_INLINE void LANES(hoop_bounded_finish_all)(const LANES(hoop_bounded_lists) *lists, size_t shots, const hoop_job *job)
{
    const hoop_results *out = job->results;
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
        double rows[HOOP_STATE * LANES_WIDTH];
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
            lanes_rows(rows, columns, HOOP_STATE);
            stream(out->state + HOOP_STATE * (start + k), rows, HOOP_STATE * some);
        }
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
LANES_INLINE void LANES(hoop_bounded_finish)(const LANES(hoop_bounded_lists) *lists, size_t row, const hoop_job *job)
{
    const hoop_results *out = job->results;
    const size_t shot = lists->shot[row];
    const int invalid = (int)lists->outcome[row] == HOOP_OUTCOME_INVALID;
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

/* Write the results of the shots that have ended, from a row on; the others close up. */
LANES_INLINE size_t LANES(hoop_bounded_leave)(LANES(hoop_bounded_lists) *lists, size_t start, size_t shots, const hoop_job *job)
{
    size_t kept = start;
    for (size_t i = start; i < shots; i += LANES_WIDTH) {
        const M rows = lanes_first(shots - i);
        M going = lanes_both(rows, lanes_less(lanes_load(lists->outcome + i), K(0.0)));
        for (unsigned bits = lanes_bits(rows) & ~lanes_bits(going); bits; bits &= bits - 1)
            LANES(hoop_bounded_finish)(lists, i + (size_t)LANES_LOWEST(bits), job);
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
            singles_pack(lists->dx + kept, going, singles_load(lists->dx + i));
            singles_pack(lists->dy + kept, going, singles_load(lists->dy + i));
            singles_pack(lists->dz + kept, going, singles_load(lists->dz + i));
            singles_pack(lists->dvx + kept, going, singles_load(lists->dvx + i));
            singles_pack(lists->dvy + kept, going, singles_load(lists->dvy + i));
            singles_pack(lists->dvz + kept, going, singles_load(lists->dvz + i));
            singles_pack(lists->dwx + kept, going, singles_load(lists->dwx + i));
            singles_pack(lists->dwy + kept, going, singles_load(lists->dwy + i));
            singles_pack(lists->dwz + kept, going, singles_load(lists->dwz + i));
            lanes_pack(lists->clock + kept, going, lanes_load(lists->clock + i));
            singles_pack(lists->clock_error + kept, going, singles_load(lists->clock_error + i));
            lanes_pack(lists->last + kept, going, lanes_load(lists->last + i));
            lanes_pack(lists->first + kept, going, lanes_load(lists->first + i));
            lanes_pack(lists->contacts + kept, going, lanes_load(lists->contacts + i));
            lanes_pack(lists->count_0 + kept, going, lanes_load(lists->count_0 + i));
            lanes_pack(lists->count_1 + kept, going, lanes_load(lists->count_1 + i));
            lanes_pack(lists->count_2 + kept, going, lanes_load(lists->count_2 + i));
            lanes_pack(lists->uncertain + kept, going, lanes_load(lists->uncertain + i));
            if (job->varying) {
                lanes_pack(lists->p_ball_radius + kept, going, lanes_load(lists->p_ball_radius + i));
                lanes_pack(lists->p_ring_radius + kept, going, lanes_load(lists->p_ring_radius + i));
                lanes_pack(lists->p_wire_radius + kept, going, lanes_load(lists->p_wire_radius + i));
                lanes_pack(lists->p_board_distance + kept, going, lanes_load(lists->p_board_distance + i));
                lanes_pack(lists->p_board_half_width + kept, going, lanes_load(lists->p_board_half_width + i));
                lanes_pack(lists->p_board_bottom + kept, going, lanes_load(lists->p_board_bottom + i));
                lanes_pack(lists->p_board_top + kept, going, lanes_load(lists->p_board_top + i));
                lanes_pack(lists->p_bridge_half_width + kept, going, lanes_load(lists->p_bridge_half_width + i));
                lanes_pack(lists->p_restitution + kept, going, lanes_load(lists->p_restitution + i));
                lanes_pack(lists->p_gravity + kept, going, lanes_load(lists->p_gravity + i));
                lanes_pack(lists->p_end_depth + kept, going, lanes_load(lists->p_end_depth + i));
            }
        }
        kept += lanes_many(going);
    }
    return kept;
}

/* Make what kernels are given ready made, of the parameters of the first row. */
static void LANES(hoop_bounded_fix)(LANES(hoop_bounded_lists) *lists)
{
    (void)lists;
    const V p_ball_radius = lanes_load(lists->p_ball_radius);
    const V p_board_bottom = lanes_load(lists->p_board_bottom);
    const V p_board_distance = lanes_load(lists->p_board_distance);
    const V p_board_half_width = lanes_load(lists->p_board_half_width);
    const V p_board_top = lanes_load(lists->p_board_top);
    const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width);
    const V p_end_depth = lanes_load(lists->p_end_depth);
    const V p_gravity = lanes_load(lists->p_gravity);
    const V p_restitution = lanes_load(lists->p_restitution);
    const V p_ring_radius = lanes_load(lists->p_ring_radius);
    const V p_wire_radius = lanes_load(lists->p_wire_radius);
    {
        const V _s0 = lanes_abs(p_board_bottom);
        const V _s1 = lanes_abs(p_board_top);
        const V _s2 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_abs(p_ball_radius), _s0), lanes_abs(p_board_distance)), lanes_abs(p_board_half_width)), _s1), lanes_abs(p_bridge_half_width));
        const V _s3 = lanes_sub(p_ball_radius, p_board_distance);
        const V _s4 = lanes_mul(K(2.0), p_ball_radius);
        const V _s5 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s6 = lanes_mul(K(2.0), p_wire_radius);
        const V _s7 = lanes_div(K(1.0), p_gravity);
        const V _s8 = lanes_neg(_s7);
        const V _s9 = lanes_mul(K(6.667843360785852e-16), p_ball_radius);
        const V _s10 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(p_ball_radius, p_board_distance), p_board_half_width), p_bridge_half_width), p_end_depth), p_ring_radius), p_wire_radius);
        const V _s11 = lanes_mul(K(1.00006103515625), _s5);
        const V _s12 = lanes_add(p_ring_radius, _s11);
        const V _s13 = lanes_mul(_s12, _s12);
        const V _s14 = lanes_mul(K(9.313225746154785e-10), _s13);
        const V _s15 = lanes_sub(p_ring_radius, _s11);
        const V _s16 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s17 = lanes_max(_s15, _s16);
        const V _s18 = lanes_mul(_s17, _s17);
        const V _s19 = lanes_div(K(1.0), _s17);
        const V _s20 = lanes_div(_s11, _s17);
        const V _s21 = lanes_sub(lanes_sub(p_ring_radius, p_ball_radius), p_wire_radius);
        lanes_store(lists->fixed[0], p_board_distance);
        lanes_store(lists->fixed[1], lanes_add(lanes_add(lanes_add(_s2, lanes_abs(p_end_depth)), lanes_abs(p_ring_radius)), lanes_abs(p_wire_radius)));
        lanes_store(lists->fixed[2], lanes_add(lanes_add(p_ball_radius, p_ring_radius), p_wire_radius));
        lanes_store(lists->fixed[3], _s3);
        lanes_store(lists->fixed[4], lanes_sub(_s3, _s4));
        lanes_store(lists->fixed[5], p_ring_radius);
        lanes_store(lists->fixed[6], p_board_half_width);
        lanes_store(lists->fixed[7], p_board_bottom);
        lanes_store(lists->fixed[8], p_board_top);
        lanes_store(lists->fixed[9], p_bridge_half_width);
        lanes_store(lists->fixed[10], _s5);
        lanes_store(lists->fixed[11], lanes_mul(_s5, _s5));
        lanes_store(lists->fixed[12], lanes_sub(lanes_sub(_s5, _s4), _s6));
        lanes_store(lists->fixed[13], lanes_add(lanes_mul(K(4.0), p_ball_radius), lanes_mul(K(4.0), p_wire_radius)));
        lanes_store(lists->fixed[14], _s7);
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[16], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[18], lanes_neg(p_gravity));
        lanes_store(lists->fixed[19], _s8);
        lanes_store(lists->fixed[20], lanes_mul(K(0.5), _s8));
        lanes_store(lists->fixed[21], lanes_mul(K(6.667843360785852e-16), p_end_depth));
        lanes_store(lists->fixed[22], lanes_mul(p_bridge_half_width, p_bridge_half_width));
        lanes_store(lists->fixed[23], lanes_neg(p_board_distance));
        lanes_store(lists->fixed[24], lanes_add(_s9, lanes_mul(K(8.890457814381136e-16), p_board_distance)));
        lanes_store(lists->fixed[25], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[26], lanes_add(lanes_add(_s10, _s0), _s1));
        lanes_store(lists->fixed[27], lanes_add(_s9, lanes_mul(K(6.667843360785852e-16), p_wire_radius)));
        lanes_store(lists->fixed[28], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s5)));
        lanes_store(lists->fixed[29], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[30], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[31], _s11);
        lanes_store(lists->fixed[32], lanes_mul(K(5.820766091346741e-11), _s12));
        lanes_store(lists->fixed[33], lanes_mul(K(65536.0), _s12));
        lanes_store(lists->fixed[34], _s13);
        lanes_store(lists->fixed[35], _s14);
        lanes_store(lists->fixed[36], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[37], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s5));
        lanes_store(lists->fixed[38], _s18);
        lanes_store(lists->fixed[39], lanes_mul(_s17, _s18));
        lanes_store(lists->fixed[40], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[41], lanes_add(_s14, _s18));
        lanes_store(lists->fixed[42], lanes_sqrt(K(2.0)));
        lanes_store(lists->fixed[43], _s4);
        lanes_store(lists->fixed[44], _s6);
        lanes_store(lists->fixed[45], lanes_mul(_s19, lanes_mul(_s19, _s19)));
        lanes_store(lists->fixed[46], _s12);
        lanes_store(lists->fixed[47], lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s5), _s12));
        lanes_store(lists->fixed[48], lanes_mul(K(5.00030517578125), _s5));
        lanes_store(lists->fixed[49], lanes_max(K(1.0), _s20));
        lanes_store(lists->fixed[50], lanes_mul(K(6.0), p_gravity));
        lanes_store(lists->fixed[51], lanes_mul(K(9.094947017729282e-13), _s12));
        lanes_store(lists->fixed[52], _s17);
        lanes_store(lists->fixed[53], lanes_div(K(1.0), _s5));
        lanes_store(lists->fixed[54], lanes_div(K(1.0), lanes_min(_s21, _s5)));
        lanes_store(lists->fixed[55], p_restitution);
        lanes_store(lists->fixed[56], lanes_mul(K(0.4), p_ball_radius));
        lanes_store(lists->fixed[57], lanes_div(K(1.0), p_ball_radius));
    }
    {
        const S _p_ball_radius = lanes_narrow(p_ball_radius);
        const S _p_ring_radius = lanes_narrow(p_ring_radius);
        const S _p_wire_radius = lanes_narrow(p_wire_radius);
        const S _p_gravity = lanes_narrow(p_gravity);
        const S _p_restitution = lanes_narrow(p_restitution);
        const S _s0 = singles_add(_p_ball_radius, _p_wire_radius);
        const S _s1 = singles_mul(KS(1.00006103515625), _s0);
        const S _s2 = singles_add(_p_ring_radius, _s1);
        const S _s3 = singles_sub(_p_ring_radius, _s1);
        const S _s4 = singles_mul(KS(0.0001220703125), _p_ring_radius);
        const S _s5 = singles_max(_s3, _s4);
        const S _s6 = singles_div(_s0, _s5);
        const S _s7 = singles_max(KS(1.0), _s6);
        const S _s8 = singles_div(KS(1.0), _s5);
        const S _s9 = singles_sub(singles_sub(_p_ring_radius, _p_ball_radius), _p_wire_radius);
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
        singles_store(lists->fixed_single[26], singles_div(KS(1.0), _s0));
        singles_store(lists->fixed_single[27], singles_div(KS(1.0), singles_min(_s9, _s0)));
        singles_store(lists->fixed_single[28], _p_ball_radius);
        singles_store(lists->fixed_single[29], _p_restitution);
        singles_store(lists->fixed_single[30], singles_mul(KS(0.4), _p_ball_radius));
        singles_store(lists->fixed_single[31], singles_div(KS(1.0), _p_ball_radius));
        singles_store(lists->fixed_single[32], singles_abs(KS(0.0)));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(hoop_bounded_fix_f1)(LANES(hoop_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->p_board_half_width + i);
    const V p_board_top = lanes_load(lists->p_board_top + i);
    const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + i);
    const V p_end_depth = lanes_load(lists->p_end_depth + i);
    const V p_ring_radius = lanes_load(lists->p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->p_wire_radius + i);
    {
        const V _s0 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_abs(p_ball_radius), lanes_abs(p_board_bottom)), lanes_abs(p_board_distance)), lanes_abs(p_board_half_width)), lanes_abs(p_board_top)), lanes_abs(p_bridge_half_width));
        const V _s1 = lanes_sub(p_ball_radius, p_board_distance);
        const V _s2 = lanes_mul(K(2.0), p_ball_radius);
        const V _s3 = lanes_add(p_ball_radius, p_wire_radius);
        lanes_store(lists->fixed[0], p_board_distance);
        lanes_store(lists->fixed[1], lanes_add(lanes_add(lanes_add(_s0, lanes_abs(p_end_depth)), lanes_abs(p_ring_radius)), lanes_abs(p_wire_radius)));
        lanes_store(lists->fixed[2], lanes_add(lanes_add(p_ball_radius, p_ring_radius), p_wire_radius));
        lanes_store(lists->fixed[3], _s1);
        lanes_store(lists->fixed[4], lanes_sub(_s1, _s2));
        lanes_store(lists->fixed[5], p_ring_radius);
        lanes_store(lists->fixed[6], p_board_half_width);
        lanes_store(lists->fixed[7], p_board_bottom);
        lanes_store(lists->fixed[8], p_board_top);
        lanes_store(lists->fixed[9], p_bridge_half_width);
        lanes_store(lists->fixed[10], _s3);
        lanes_store(lists->fixed[11], lanes_mul(_s3, _s3));
        lanes_store(lists->fixed[12], lanes_sub(lanes_sub(_s3, _s2), lanes_mul(K(2.0), p_wire_radius)));
        lanes_store(lists->fixed[13], lanes_add(lanes_mul(K(4.0), p_ball_radius), lanes_mul(K(4.0), p_wire_radius)));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(hoop_bounded_fix_f7)(LANES(hoop_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->p_board_half_width + i);
    const V p_board_top = lanes_load(lists->p_board_top + i);
    const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + i);
    const V p_end_depth = lanes_load(lists->p_end_depth + i);
    const V p_gravity = lanes_load(lists->p_gravity + i);
    const V p_ring_radius = lanes_load(lists->p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_div(K(1.0), p_gravity);
        const V _s2 = lanes_neg(_s1);
        const V _s3 = lanes_mul(K(6.667843360785852e-16), p_ball_radius);
        const V _s4 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(p_ball_radius, p_board_distance), p_board_half_width), p_bridge_half_width), p_end_depth), p_ring_radius), p_wire_radius);
        const V _s5 = lanes_mul(K(1.00006103515625), _s0);
        const V _s6 = lanes_add(p_ring_radius, _s5);
        const V _s7 = lanes_mul(_s6, _s6);
        const V _s8 = lanes_mul(K(9.313225746154785e-10), _s7);
        const V _s9 = lanes_sub(p_ring_radius, _s5);
        const V _s10 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s11 = lanes_max(_s9, _s10);
        const V _s12 = lanes_mul(_s11, _s11);
        lanes_store(lists->fixed[0], p_board_distance);
        lanes_store(lists->fixed[3], lanes_sub(p_ball_radius, p_board_distance));
        lanes_store(lists->fixed[5], p_ring_radius);
        lanes_store(lists->fixed[6], p_board_half_width);
        lanes_store(lists->fixed[7], p_board_bottom);
        lanes_store(lists->fixed[8], p_board_top);
        lanes_store(lists->fixed[9], p_bridge_half_width);
        lanes_store(lists->fixed[10], _s0);
        lanes_store(lists->fixed[11], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[14], _s1);
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[16], lanes_neg(p_end_depth));
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[18], lanes_neg(p_gravity));
        lanes_store(lists->fixed[19], _s2);
        lanes_store(lists->fixed[20], lanes_mul(K(0.5), _s2));
        lanes_store(lists->fixed[21], lanes_mul(K(6.667843360785852e-16), p_end_depth));
        lanes_store(lists->fixed[22], lanes_mul(p_bridge_half_width, p_bridge_half_width));
        lanes_store(lists->fixed[23], lanes_neg(p_board_distance));
        lanes_store(lists->fixed[24], lanes_add(_s3, lanes_mul(K(8.890457814381136e-16), p_board_distance)));
        lanes_store(lists->fixed[25], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[26], lanes_add(lanes_add(_s4, lanes_abs(p_board_bottom)), lanes_abs(p_board_top)));
        lanes_store(lists->fixed[27], lanes_add(_s3, lanes_mul(K(6.667843360785852e-16), p_wire_radius)));
        lanes_store(lists->fixed[28], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s0)));
        lanes_store(lists->fixed[29], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[30], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[31], _s5);
        lanes_store(lists->fixed[32], lanes_mul(K(5.820766091346741e-11), _s6));
        lanes_store(lists->fixed[33], lanes_mul(K(65536.0), _s6));
        lanes_store(lists->fixed[34], _s7);
        lanes_store(lists->fixed[35], _s8);
        lanes_store(lists->fixed[36], lanes_mul(K(4.0), p_gravity));
        lanes_store(lists->fixed[37], lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s0));
        lanes_store(lists->fixed[38], _s12);
        lanes_store(lists->fixed[39], lanes_mul(_s11, _s12));
        lanes_store(lists->fixed[40], lanes_mul(K(2.0), p_ring_radius));
        lanes_store(lists->fixed[41], lanes_add(_s8, _s12));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(hoop_bounded_fix_f63)(LANES(hoop_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->open_p_ball_radius + i);
    const V p_gravity = lanes_load(lists->open_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->open_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->open_p_wire_radius + i);
    {
        lanes_store(lists->fixed[5], p_ring_radius);
        lanes_store(lists->fixed[14], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[25], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[28], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, lanes_add(p_ball_radius, p_wire_radius))));
        lanes_store(lists->fixed[29], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[30], lanes_mul(K(1.52587890625e-05), p_wire_radius));
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
static void LANES(hoop_bounded_fix_f77)(LANES(hoop_bounded_lists) *lists, size_t taken, M idle)
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
static void LANES(hoop_bounded_fix_f80)(LANES(hoop_bounded_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[14], lanes_div(K(1.0), p_gravity));
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[17], lanes_mul(K(2.0), p_gravity));
        lanes_store(lists->fixed[28], lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s0)));
        lanes_store(lists->fixed[29], lanes_mul(K(1.52587890625e-05), p_ball_radius));
        lanes_store(lists->fixed[30], lanes_mul(K(1.52587890625e-05), p_wire_radius));
        lanes_store(lists->fixed[31], _s1);
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
static void LANES(hoop_bounded_fix_f85)(LANES(hoop_bounded_lists) *lists, size_t taken, M idle)
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
        lanes_store(lists->fixed[5], p_ring_radius);
        lanes_store(lists->fixed[11], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[25], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[31], _s1);
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
static void LANES(hoop_bounded_fix_f98)(LANES(hoop_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->open_p_ball_radius + i);
    const V p_gravity = lanes_load(lists->open_p_gravity + i);
    const V p_ring_radius = lanes_load(lists->open_p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->open_p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        lanes_store(lists->fixed[5], p_ring_radius);
        lanes_store(lists->fixed[11], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[25], lanes_mul(K(0.5), p_gravity));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(hoop_bounded_fix_f107)(LANES(hoop_bounded_lists) *lists, size_t taken, M idle)
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
        lanes_store(lists->fixed[5], p_ring_radius);
        lanes_store(lists->fixed[11], lanes_mul(_s0, _s0));
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[25], lanes_mul(K(0.5), p_gravity));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static void LANES(hoop_bounded_fix_f110)(LANES(hoop_bounded_lists) *lists, size_t i)
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
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[31], _s1);
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
static void LANES(hoop_bounded_fix_f118)(LANES(hoop_bounded_lists) *lists, size_t i)
{
    const V p_ball_radius = lanes_load(lists->p_ball_radius + i);
    const V p_board_bottom = lanes_load(lists->p_board_bottom + i);
    const V p_board_distance = lanes_load(lists->p_board_distance + i);
    const V p_board_half_width = lanes_load(lists->p_board_half_width + i);
    const V p_board_top = lanes_load(lists->p_board_top + i);
    const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + i);
    const V p_end_depth = lanes_load(lists->p_end_depth + i);
    const V p_gravity = lanes_load(lists->p_gravity + i);
    const V p_restitution = lanes_load(lists->p_restitution + i);
    const V p_ring_radius = lanes_load(lists->p_ring_radius + i);
    const V p_wire_radius = lanes_load(lists->p_wire_radius + i);
    {
        const V _s0 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s1 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(p_ball_radius, p_board_distance), p_board_half_width), p_bridge_half_width), p_end_depth), p_ring_radius), p_wire_radius);
        const V _s2 = lanes_sub(lanes_sub(p_ring_radius, p_ball_radius), p_wire_radius);
        lanes_store(lists->fixed[3], lanes_sub(p_ball_radius, p_board_distance));
        lanes_store(lists->fixed[5], p_ring_radius);
        lanes_store(lists->fixed[10], _s0);
        lanes_store(lists->fixed[15], p_gravity);
        lanes_store(lists->fixed[25], lanes_mul(K(0.5), p_gravity));
        lanes_store(lists->fixed[26], lanes_add(lanes_add(_s1, lanes_abs(p_board_bottom)), lanes_abs(p_board_top)));
        lanes_store(lists->fixed[53], lanes_div(K(1.0), _s0));
        lanes_store(lists->fixed[54], lanes_div(K(1.0), lanes_min(_s2, _s0)));
        lanes_store(lists->fixed[55], p_restitution);
        lanes_store(lists->fixed[56], lanes_mul(K(0.4), p_ball_radius));
        lanes_store(lists->fixed[57], lanes_div(K(1.0), p_ball_radius));
    }
    {
        const S _p_ball_radius = lanes_narrow(p_ball_radius);
        const S _p_ring_radius = lanes_narrow(p_ring_radius);
        const S _p_wire_radius = lanes_narrow(p_wire_radius);
        const S _p_gravity = lanes_narrow(p_gravity);
        const S _p_restitution = lanes_narrow(p_restitution);
        const S _s0 = singles_add(_p_ball_radius, _p_wire_radius);
        const S _s1 = singles_sub(singles_sub(_p_ring_radius, _p_ball_radius), _p_wire_radius);
        singles_store(lists->fixed_single[0], _p_gravity);
        singles_store(lists->fixed_single[19], _p_ring_radius);
        singles_store(lists->fixed_single[26], singles_div(KS(1.0), _s0));
        singles_store(lists->fixed_single[27], singles_div(KS(1.0), singles_min(_s1, _s0)));
        singles_store(lists->fixed_single[28], _p_ball_radius);
        singles_store(lists->fixed_single[29], _p_restitution);
        singles_store(lists->fixed_single[30], singles_mul(KS(0.4), _p_ball_radius));
        singles_store(lists->fixed_single[31], singles_div(KS(1.0), _p_ball_radius));
        singles_store(lists->fixed_single[32], singles_abs(KS(0.0)));
    }
}

/* Run the job: fill the rows, take every shot to its next event, make room of those that ended.
   Errors are bounded. */
static void LANES(hoop_bounded)(const hoop_job *job, LANES(hoop_bounded_lists) *const restrict lists)
{
    const V most_contacts = K((double)job->max_contacts);
    const V time_limit = K(job->time_limit);
    const V claims = K(job->results->time_error || job->results->state_error ? 1.0 : 0.0);
    const size_t varying = job->varying ? ~(size_t)0 : 0;
    const int recording = job->results->events != NULL;
    size_t begun = 0, end = 0, shots = 0;
    int streams = 0; /* whether the shots before ended all at once: then those to come will, too */

    if (job->shots == 0)
        return;
    lanes_store(lists->p_ball_radius, K(*job->parameters[0]));
    lanes_store(lists->p_ring_radius, K(*job->parameters[1]));
    lanes_store(lists->p_wire_radius, K(*job->parameters[2]));
    lanes_store(lists->p_board_distance, K(*job->parameters[3]));
    lanes_store(lists->p_board_half_width, K(*job->parameters[4]));
    lanes_store(lists->p_board_bottom, K(*job->parameters[5]));
    lanes_store(lists->p_board_top, K(*job->parameters[6]));
    lanes_store(lists->p_bridge_half_width, K(*job->parameters[7]));
    lanes_store(lists->p_restitution, K(*job->parameters[8]));
    lanes_store(lists->p_gravity, K(*job->parameters[9]));
    lanes_store(lists->p_end_depth, K(*job->parameters[10]));
    LANES(hoop_bounded_permitted)(lists, 0);
    LANES(hoop_bounded_fix)(lists);
    for (;;) {
        if (stopped(job))
            return;
        if (begun == end && end < job->shots)
            begun = hoop_take(job, &end);
        int following = shots == 0;
        const size_t fresh = shots;
        if (begun < end) {
            const size_t room = LANES_SHOTS - shots, left = end - begun;
            shots += left < room ? left : room;
            LANES(hoop_bounded_begin)(lists, fresh, shots - fresh, job, begun);
            begun += shots - fresh;
        }
        if (shots == 0)
            return;

        /* A new shot is looked at once. */
        for (size_t i = fresh; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            if (LANES_SELDOM(varying))
                LANES(hoop_bounded_fix_f1)(lists, i);
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
            const LANES(hoop_state_in_range_out) _o2 =
                LANES(hoop_state_in_range)(vx, vy, vz, wx, wy, wz, x, y, z);
            M in_range = _o2.in_range;
            const LANES(hoop_aside_out) _o3 =
                LANES(hoop_aside)(x, y, z, lanes_load(lists->fixed[0]), lanes_load(lists->fixed[1]), lanes_load(lists->fixed[2]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]));
            M close = _o3.close;
            V valid = _o3.valid;
            V doubt = _o3.doubt;
            const M _m4 = lanes_both(rows, close);
            if (lanes_any(_m4)) {
                const LANES(hoop_valid_out) _o5 =
                    LANES(hoop_valid)(last, x, y, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[0]), lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]), lanes_load(lists->fixed[9]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[4]), lanes_load(lists->fixed[12]), lanes_load(lists->fixed[13]), lanes_load(lists->fixed[1]));
                valid = lanes_select(_m4, _o5.valid, valid);
                doubt = lanes_select(_m4, _o5.doubt, doubt);
            }
            const LANES(hoop_admitted_out) _o6 =
                LANES(hoop_admitted)(doubt, in_range, permitted, valid);
            V outcome = _o6.outcome;
            V uncertain = _o6.uncertain;
            lanes_store(lists->outcome + i, outcome);
            lanes_store(lists->uncertain + i, uncertain);
        }

        M refused = lanes_nowhere();
        for (size_t i = fresh; i < shots; i += LANES_WIDTH)
            refused = lanes_either(refused, lanes_both(lanes_first(shots - i), lanes_at_most(K(0.0), lanes_load(lists->outcome + i))));
        if (lanes_any(refused)) {
            shots = LANES(hoop_bounded_leave)(lists, fresh, shots, job);
            following = 0;
        }

        /* To the next event, and what it does to the ball. */
        {
        size_t open_shots = 0;
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            LANES(hoop_ahead)(job, begun + i, streams);
            if (LANES_SELDOM(varying))
                LANES(hoop_bounded_fix_f7)(lists, i);
            S clock_error = singles_load(lists->clock_error + i);
            S dvx = singles_load(lists->dvx + i);
            S dvy = singles_load(lists->dvy + i);
            S dvz = singles_load(lists->dvz + i);
            S dwx = singles_load(lists->dwx + i);
            S dwy = singles_load(lists->dwy + i);
            S dwz = singles_load(lists->dwz + i);
            S dx = singles_load(lists->dx + i);
            S dy = singles_load(lists->dy + i);
            S dz = singles_load(lists->dz + i);
            V last = lanes_load(lists->last + i);
            V vx = lanes_load(lists->vx + i);
            V vy = lanes_load(lists->vy + i);
            V vz = lanes_load(lists->vz + i);
            V x = lanes_load(lists->x + i);
            V y = lanes_load(lists->y + i);
            V z = lanes_load(lists->z + i);
            const LANES(hoop_error_bounds_out) _o8 =
                LANES(hoop_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            S position_error = _o8.position_error;
            S velocity_error = _o8.velocity_error;
            S time_error = _o8.time_error;
            const LANES(hoop_scale_out) _o9 =
                LANES(hoop_scale)(x, y, z, vx, vy, vz, lanes_load(lists->fixed[14]));
            V extent = _o9.extent;
            V speed = _o9.speed;
            V excess = _o9.excess;
            const LANES(hoop_opening_out) _o10 =
                LANES(hoop_opening)(excess, lanes_wide(position_error), lanes_wide(velocity_error));
            V when = _o10.when;
            V which = _o10.which;
            V late = _o10.late;
            V doubt = _o10.doubt;
            const LANES(hoop_limited_out) _o11 =
                LANES(hoop_limited)(time_limit);
            M limited = _o11.limited;
            const LANES(hoop_left_out) _o12 =
                LANES(hoop_left)(K(3.0), last);
            V leaving = _o12.leaving;
            const LANES(hoop_end_arrival_out) _o13 =
                LANES(hoop_end_arrival)(leaving, z, vz, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[16]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[18]), lanes_load(lists->fixed[19]), lanes_load(lists->fixed[20]));
            V time = _o13.time;
            V rate = _o13.rate;
            V bend = _o13.bend;
            V apex = _o13.apex;
            V height = _o13.height;
            const LANES(hoop_meeting_plane_out) _o14 =
                LANES(hoop_meeting_plane)(apex, bend, rate, time);
            M arrives = _o14.arrives;
            V ceiling = _o14.ceiling;
            V nearest = _o14.nearest;
            const LANES(hoop_end_margin_out) _o15 =
                LANES(hoop_end_margin)(nearest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[21]));
            V margin = _o15.margin;
            const LANES(hoop_crossing_out) _o16 =
                LANES(hoop_crossing)(margin, K(0.0), rate, ceiling);
            V clearance = _o16.clearance;
            V delay = _o16.delay;
            const LANES(hoop_timely_out) _o17 =
                LANES(hoop_timely)(arrives, delay, late, time, when);
            M possible = _o17.possible;
            const LANES(hoop_grazed_out) _o18 =
                LANES(hoop_grazed)(apex, doubt, height, margin);
            doubt = _o18.doubt;
            const M _m19 = lanes_both(rows, possible);
            {
                const LANES(hoop_crossed_out) _o20 =
                    LANES(hoop_crossed)(arrives, clearance, doubt, time);
                doubt = lanes_select(_m19, _o20.doubt, doubt);
                const LANES(hoop_tied_out) _o21 =
                    LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
                doubt = lanes_select(_m19, _o21.doubt, doubt);
                late = lanes_select(_m19, _o21.late, late);
                const LANES(hoop_sooner_out) _o22 =
                    LANES(hoop_sooner)(arrives, K(3.0), time, when, which);
                when = lanes_select(_m19, _o22.when, when);
                which = lanes_select(_m19, _o22.which, which);
            }
            const LANES(hoop_released_out) _o23 =
                LANES(hoop_released)(last);
            M released = _o23.released;
            M reachable = _o23.reachable;
            const M _m24 = lanes_both(rows, released);
            if (lanes_any(_m24)) {
                const LANES(hoop_horizon_out) _o25 =
                    LANES(hoop_horizon)(when, speed, lanes_load(lists->fixed[14]));
                V until = _o25.horizon;
                V pad = _o25.pad;
                const LANES(hoop_reachable_out) _o26 =
                    LANES(hoop_reachable)(extent, until, late, pad, lanes_wide(position_error), speed, lanes_wide(velocity_error), vx, x, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[3]), lanes_load(lists->fixed[22]), lanes_load(lists->fixed[23]));
                reachable = lanes_choose(_m24, _o26.reachable, reachable);
            }
            const M _m27 = lanes_both(rows, reachable);
            if (lanes_any(_m27)) {
                const LANES(hoop_left_out) _o28 =
                    LANES(hoop_left)(K(1.0), last);
                V leaving = _o28.leaving;
                const LANES(hoop_backboard_arrival_out) _o29 =
                    LANES(hoop_backboard_arrival)(leaving, x, vx, lanes_load(lists->fixed[3]));
                V time = _o29.time;
                V rate = _o29.rate;
                V bend = _o29.bend;
                V apex = _o29.apex;
                V height = _o29.height;
                const LANES(hoop_meeting_plane_out) _o30 =
                    LANES(hoop_meeting_plane)(apex, bend, rate, time);
                M arrives = _o30.arrives;
                V ceiling = _o30.ceiling;
                V nearest = _o30.nearest;
                const LANES(hoop_backboard_margin_out) _o31 =
                    LANES(hoop_backboard_margin)(nearest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[24]));
                V margin = _o31.margin;
                const LANES(hoop_crossing_out) _o32 =
                    LANES(hoop_crossing)(margin, K(0.0), rate, ceiling);
                V clearance = _o32.clearance;
                V delay = _o32.delay;
                const LANES(hoop_timely_out) _o33 =
                    LANES(hoop_timely)(arrives, delay, late, time, when);
                M possible = _o33.possible;
                const LANES(hoop_grazed_out) _o34 =
                    LANES(hoop_grazed)(apex, doubt, height, margin);
                doubt = lanes_select(_m27, _o34.doubt, doubt);
                const M _m35 = lanes_both(_m27, possible);
                if (lanes_any(_m35)) {
                    const LANES(hoop_flight_out) _o36 =
                        LANES(hoop_flight)(time, x, y, z, vx, vy, vz, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[25]));
                    V there_y = _o36.y;
                    V there_z = _o36.z;
                    const LANES(hoop_backboard_bounds_out) _o37 =
                        LANES(hoop_backboard_bounds)(there_y, there_z, lanes_load(lists->fixed[6]), lanes_load(lists->fixed[7]), lanes_load(lists->fixed[8]));
                    V g0 = _o37.g0;
                    V g1 = _o37.g1;
                    V g2 = _o37.g2;
                    V g3 = _o37.g3;
                    const LANES(hoop_displacement_out) _o38 =
                        LANES(hoop_displacement)(delay, time, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[26]));
                    V slack = _o38.margin;
                    const LANES(hoop_backboard_edges_out) _o39 =
                        LANES(hoop_backboard_edges)(clearance, g0, g1, g2, g3, slack);
                    M unsure = _o39.unsure;
                    const LANES(hoop_questioned_out) _o40 =
                        LANES(hoop_questioned)(doubt, time, unsure);
                    doubt = lanes_select(_m35, _o40.doubt, doubt);
                    const LANES(hoop_backboard_within_out) _o41 =
                        LANES(hoop_backboard_within)(g0, g1, g2, g3);
                    M arrives = _o41.arrives;
                    const LANES(hoop_tied_out) _o42 =
                        LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
                    doubt = lanes_select(_m35, _o42.doubt, doubt);
                    late = lanes_select(_m35, _o42.late, late);
                    const LANES(hoop_sooner_out) _o43 =
                        LANES(hoop_sooner)(arrives, K(1.0), time, when, which);
                    when = lanes_select(_m35, _o43.when, when);
                    which = lanes_select(_m35, _o43.which, which);
                }
                const LANES(hoop_left_out) _o44 =
                    LANES(hoop_left)(K(2.0), last);
                leaving = _o44.leaving;
                const LANES(hoop_bridge_arrival_out) _o45 =
                    LANES(hoop_bridge_arrival)(leaving, z, vz, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[10]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[18]), lanes_load(lists->fixed[19]), lanes_load(lists->fixed[20]));
                time = _o45.time;
                rate = _o45.rate;
                bend = _o45.bend;
                apex = _o45.apex;
                height = _o45.height;
                const LANES(hoop_meeting_plane_out) _o46 =
                    LANES(hoop_meeting_plane)(apex, bend, rate, time);
                arrives = _o46.arrives;
                ceiling = _o46.ceiling;
                nearest = _o46.nearest;
                const LANES(hoop_bridge_margin_out) _o47 =
                    LANES(hoop_bridge_margin)(nearest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[27]));
                margin = _o47.margin;
                const LANES(hoop_crossing_out) _o48 =
                    LANES(hoop_crossing)(margin, K(0.0), rate, ceiling);
                clearance = _o48.clearance;
                delay = _o48.delay;
                const LANES(hoop_timely_out) _o49 =
                    LANES(hoop_timely)(arrives, delay, late, time, when);
                possible = _o49.possible;
                const LANES(hoop_grazed_out) _o50 =
                    LANES(hoop_grazed)(apex, doubt, height, margin);
                doubt = lanes_select(_m27, _o50.doubt, doubt);
                const M _m51 = lanes_both(_m27, possible);
                if (lanes_any(_m51)) {
                    const LANES(hoop_flight_out) _o52 =
                        LANES(hoop_flight)(time, x, y, z, vx, vy, vz, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[25]));
                    V there_x = _o52.x;
                    V there_y = _o52.y;
                    const LANES(hoop_bridge_bounds_out) _o53 =
                        LANES(hoop_bridge_bounds)(there_x, there_y, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[0]), lanes_load(lists->fixed[9]));
                    V g0 = _o53.g0;
                    V g1 = _o53.g1;
                    V g2 = _o53.g2;
                    V g3 = _o53.g3;
                    V g4 = _o53.g4;
                    const LANES(hoop_displacement_out) _o54 =
                        LANES(hoop_displacement)(delay, time, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[26]));
                    V slack = _o54.margin;
                    const LANES(hoop_bridge_edges_out) _o55 =
                        LANES(hoop_bridge_edges)(clearance, g0, g1, g2, g3, g4, slack);
                    M unsure = _o55.unsure;
                    const LANES(hoop_questioned_out) _o56 =
                        LANES(hoop_questioned)(doubt, time, unsure);
                    doubt = lanes_select(_m51, _o56.doubt, doubt);
                    const LANES(hoop_bridge_within_out) _o57 =
                        LANES(hoop_bridge_within)(g0, g1, g2, g3, g4);
                    M arrives = _o57.arrives;
                    const LANES(hoop_tied_out) _o58 =
                        LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
                    doubt = lanes_select(_m51, _o58.doubt, doubt);
                    late = lanes_select(_m51, _o58.late, late);
                    const LANES(hoop_sooner_out) _o59 =
                        LANES(hoop_sooner)(arrives, K(2.0), time, when, which);
                    when = lanes_select(_m51, _o59.when, when);
                    which = lanes_select(_m51, _o59.which, which);
                }
            }
            const LANES(hoop_horizon_out) _o60 =
                LANES(hoop_horizon)(when, speed, lanes_load(lists->fixed[14]));
            V until = _o60.horizon;
            V pad = _o60.pad;
            const LANES(hoop_ring_clear_out) _o61 =
                LANES(hoop_ring_clear)(until, x, y, z, vx, vy, vz, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), lanes_load(lists->fixed[5]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[28]), lanes_load(lists->fixed[29]), lanes_load(lists->fixed[30]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[32]), lanes_load(lists->fixed[33]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[14]), lanes_load(lists->fixed[25]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[34]), lanes_load(lists->fixed[35]), lanes_load(lists->fixed[36]), lanes_load(lists->fixed[37]), lanes_load(lists->fixed[38]), lanes_load(lists->fixed[39]), lanes_load(lists->fixed[40]), lanes_load(lists->fixed[41]));
            V clear = _o61.clear;
            const LANES(hoop_opens_out) _o62 =
                LANES(hoop_opens)(clear);
            M open = _o62.open;
            lanes_store(lists->doubt + i, doubt);
            lanes_store(lists->extent + i, extent);
            lanes_store(lists->late + i, late);
            lanes_store(lists->limited + i, lanes_select(limited, K(1.0), K(0.0)));
            singles_store(lists->position_error + i, position_error);
            lanes_store(lists->speed + i, speed);
            singles_store(lists->time_error + i, time_error);
            singles_store(lists->velocity_error + i, velocity_error);
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
                singles_pack(lists->open_position_error + open_shots, packed, position_error);
                lanes_pack(lists->open_speed + open_shots, packed, speed);
                lanes_pack(lists->open_until + open_shots, packed, until);
                singles_pack(lists->open_velocity_error + open_shots, packed, velocity_error);
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
        if (open_shots) {
            lanes_store(lists->open_row + open_shots, K(0.0));
            lanes_store(lists->open_doubt + open_shots, K(0.0));
            lanes_store(lists->open_extent + open_shots, K(0.0));
            lanes_store(lists->open_last + open_shots, K(0.0));
            lanes_store(lists->open_late + open_shots, K(0.0));
            lanes_store(lists->open_pad + open_shots, K(0.0));
            singles_store(lists->open_position_error + open_shots, KS(0.0));
            lanes_store(lists->open_speed + open_shots, K(0.0));
            lanes_store(lists->open_until + open_shots, K(0.0));
            singles_store(lists->open_velocity_error + open_shots, KS(0.0));
            lanes_store(lists->open_vx + open_shots, K(0.0));
            lanes_store(lists->open_vy + open_shots, K(0.0));
            lanes_store(lists->open_vz + open_shots, K(0.0));
            lanes_store(lists->open_when + open_shots, K(0.0));
            lanes_store(lists->open_which + open_shots, K(0.0));
            lanes_store(lists->open_x + open_shots, K(0.0));
            lanes_store(lists->open_y + open_shots, K(0.0));
            lanes_store(lists->open_z + open_shots, K(0.0));
            if (LANES_SELDOM(varying)) {
                lanes_store(lists->open_p_ball_radius + open_shots, K(0.0));
                lanes_store(lists->open_p_gravity + open_shots, K(0.0));
                lanes_store(lists->open_p_ring_radius + open_shots, K(0.0));
                lanes_store(lists->open_p_wire_radius + open_shots, K(0.0));
            }
        }
        {
        size_t open_leaping_shots = 0;
        for (size_t i = 0; i < open_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_shots - i);
            if (LANES_SELDOM(varying))
                LANES(hoop_bounded_fix_f63)(lists, i);
            V doubt = lanes_load(lists->open_doubt + i);
            V extent = lanes_load(lists->open_extent + i);
            V last = lanes_load(lists->open_last + i);
            V late = lanes_load(lists->open_late + i);
            V pad = lanes_load(lists->open_pad + i);
            S position_error = singles_load(lists->open_position_error + i);
            V speed = lanes_load(lists->open_speed + i);
            V until = lanes_load(lists->open_until + i);
            S velocity_error = singles_load(lists->open_velocity_error + i);
            V vx = lanes_load(lists->open_vx + i);
            V vy = lanes_load(lists->open_vy + i);
            V vz = lanes_load(lists->open_vz + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(hoop_beginning_out) _o64 =
                LANES(hoop_beginning)();
            V share = _o64.share;
            V arrival = _o64.arrival;
            M certain = _o64.certain;
            const LANES(hoop_left_out) _o65 =
                LANES(hoop_left)(K(0.0), last);
            V leaving = _o65.leaving;
            const LANES(hoop_ring_opened_out) _o66 =
                LANES(hoop_ring_opened)(lanes_narrow(until), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(extent), lanes_narrow(speed), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[2]), singles_load(lists->fixed_single[3]), singles_load(lists->fixed_single[4]), singles_load(lists->fixed_single[5]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[7]), singles_load(lists->fixed_single[8]), singles_load(lists->fixed_single[9]));
            S onset = _o66.t;
            S wide_end = _o66.end;
            M searching = _o66.searching;
            S wide_low1 = _o66.low1;
            S wide_high1 = _o66.high1;
            S wide_low2 = _o66.low2;
            S wide_high2 = _o66.high2;
            S lapsed = _o66.latest;
            M sound = _o66.sound;
            const LANES(hoop_opened_out) _o67 =
                LANES(hoop_opened)(lanes_wide(lapsed), lanes_wide(onset));
            V since = _o67.time;
            V latest = _o67.latest;
            const LANES(hoop_ring_started_out) _o68 =
                LANES(hoop_ring_started)(x, y, z, vx, vy, vz, lanes_load(lists->fixed[5]));
            V rho_start = _o68.rho_start;
            V parting = _o68.parting;
            V drift = _o68.drift;
            const LANES(hoop_flight_out) _o69 =
                LANES(hoop_flight)(since, x, y, z, vx, vy, vz, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[25]));
            V near_x = _o69.x;
            V near_y = _o69.y;
            V near_z = _o69.z;
            V near_vz = _o69.vz;
            const LANES(hoop_ring_grain_out) _o70 =
                LANES(hoop_ring_grain)(onset, wide_end, lanes_narrow(leaving), lapsed, lanes_narrow(near_x), lanes_narrow(near_y), lanes_narrow(near_z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(near_vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(parting), lanes_narrow(drift), wide_low1, wide_high1, wide_low2, wide_high2, singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[10]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[11]), singles_load(lists->fixed_single[12]), singles_load(lists->fixed_single[13]), singles_load(lists->fixed_single[14]), singles_load(lists->fixed_single[15]), singles_load(lists->fixed_single[4]), singles_load(lists->fixed_single[16]), singles_load(lists->fixed_single[17]), singles_load(lists->fixed_single[18]));
            S short_share = _o70.share;
            S short_t = _o70.t;
            S short_end = _o70.end;
            S short_x = _o70.x;
            S short_y = _o70.y;
            S short_z = _o70.z;
            S short_vx = _o70.vx;
            S short_vy = _o70.vy;
            S short_vz = _o70.vz;
            S short_steady = _o70.steady;
            S short_swing = _o70.swing;
            S short_rho_start = _o70.rho_start;
            S short_ceiling = _o70.ceiling;
            S short_flat = _o70.flat;
            S short_tilt = _o70.tilt;
            S short_jerk = _o70.jerk;
            S short_grit = _o70.grit;
            S short_parting = _o70.parting;
            S short_drift = _o70.drift;
            S short_rate_margin = _o70.rate_margin;
            S short_low1 = _o70.low1;
            S short_high1 = _o70.high1;
            S short_low2 = _o70.low2;
            S short_high2 = _o70.high2;
            M fits = _o70.fits;
            const LANES(hoop_coarse_out) _o71 =
                LANES(hoop_coarse)(lanes_wide(short_ceiling), fits, lanes_wide(short_flat), lanes_wide(short_rate_margin), searching, lanes_wide(short_share), sound);
            M leaping = _o71.leaping;
            searching = _o71.searching;
            M served = _o71.served;
            V ceiling = _o71.ceiling;
            V flat = _o71.flat;
            V tilt = _o71.tilt;
            V allowing = _o71.allowing;
            const LANES(hoop_allowance_out) _o72 =
                LANES(hoop_allowance)(allowing, latest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), lanes_load(lists->fixed[15]));
            V excess = _o72.excess;
            const LANES(hoop_ring_lost_out) _o73 =
                LANES(hoop_ring_lost)(until, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), lanes_load(lists->fixed[28]), lanes_load(lists->fixed[42]), lanes_load(lists->fixed[14]), lanes_load(lists->fixed[43]), lanes_load(lists->fixed[44]), lanes_load(lists->fixed[29]), lanes_load(lists->fixed[30]));
            V lost = _o73.lost;
            const LANES(hoop_beyond_out) _o74 =
                LANES(hoop_beyond)(doubt, excess, late, lost, pad);
            doubt = _o74.doubt;
            const M _m75 = lanes_both(rows, leaping);
            if (lanes_any(_m75)) {
                const LANES(hoop_ring_leap_out) _o76 =
                    LANES(hoop_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, singles_load(lists->fixed_single[19]), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[20]), singles_load(lists->fixed_single[21]), singles_load(lists->fixed_single[22]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[23]), singles_load(lists->fixed_single[24]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[25]));
                short_t = singles_select(singles_of(_m75), _o76.t, short_t);
                short_end = singles_select(singles_of(_m75), _o76.end, short_end);
                certain = lanes_choose(_m75, _o76.certain, certain);
                leaping = lanes_choose(_m75, _o76.leaping, leaping);
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
        if (open_leaping_shots) {
            lanes_store(lists->open_leaping_row + open_leaping_shots, K(0.0));
            singles_store(lists->open_leaping_short_ceiling + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_drift + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_end + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_flat + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_grit + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_high1 + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_high2 + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_jerk + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_low1 + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_low2 + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_parting + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_rate_margin + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_rho_start + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_steady + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_swing + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_t + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_tilt + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_vx + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_vy + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_vz + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_x + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_y + open_leaping_shots, KS(0.0));
            singles_store(lists->open_leaping_short_z + open_leaping_shots, KS(0.0));
            if (LANES_SELDOM(varying)) {
                lanes_store(lists->open_leaping_p_ball_radius + open_leaping_shots, K(0.0));
                lanes_store(lists->open_leaping_p_gravity + open_leaping_shots, K(0.0));
                lanes_store(lists->open_leaping_p_ring_radius + open_leaping_shots, K(0.0));
                lanes_store(lists->open_leaping_p_wire_radius + open_leaping_shots, K(0.0));
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
                        LANES(hoop_bounded_fix_f77)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_leaping_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M leaping = active;
                const LANES(hoop_ring_leap_out) _o78 =
                    LANES(hoop_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, singles_load(lists->fixed_single[19]), singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[20]), singles_load(lists->fixed_single[21]), singles_load(lists->fixed_single[22]), singles_load(lists->fixed_single[1]), singles_load(lists->fixed_single[23]), singles_load(lists->fixed_single[24]), singles_load(lists->fixed_single[6]), singles_load(lists->fixed_single[25]));
                short_t = _o78.t;
                short_end = _o78.end;
                M certain = _o78.certain;
                leaping = _o78.leaping;
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
            S position_error = singles_load(lists->open_position_error + i);
            M searching = lanes_less(K(0.0), lanes_load(lists->open_searching + i));
            M served = lanes_less(K(0.0), lanes_load(lists->open_served + i));
            V share = lanes_load(lists->open_share + i);
            S short_t = singles_load(lists->open_short_t + i);
            V since = lanes_load(lists->open_since + i);
            V speed = lanes_load(lists->open_speed + i);
            V until = lanes_load(lists->open_until + i);
            S velocity_error = singles_load(lists->open_velocity_error + i);
            V vx = lanes_load(lists->open_vx + i);
            V vy = lanes_load(lists->open_vy + i);
            V vz = lanes_load(lists->open_vz + i);
            V x = lanes_load(lists->open_x + i);
            V y = lanes_load(lists->open_y + i);
            V z = lanes_load(lists->open_z + i);
            const LANES(hoop_leapt_out) _o79 =
                LANES(hoop_leapt)(arrival, certain, lanes_wide(short_t), searching, served, since);
            arrival = _o79.arrival;
            V t = _o79.t;
            searching = _o79.searching;
            lanes_store(lists->open_arrival + i, arrival);
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(lists->open_searching_row + open_searching_shots, packed, lanes_add(lanes_count_up(), K((double)i)));
                lanes_pack(lists->open_searching_arrival + open_searching_shots, packed, arrival);
                lanes_pack(lists->open_searching_certain + open_searching_shots, packed, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(lists->open_searching_doubt + open_searching_shots, packed, doubt);
                lanes_pack(lists->open_searching_extent + open_searching_shots, packed, extent);
                lanes_pack(lists->open_searching_last + open_searching_shots, packed, last);
                singles_pack(lists->open_searching_position_error + open_searching_shots, packed, position_error);
                lanes_pack(lists->open_searching_share + open_searching_shots, packed, share);
                lanes_pack(lists->open_searching_speed + open_searching_shots, packed, speed);
                lanes_pack(lists->open_searching_t + open_searching_shots, packed, t);
                lanes_pack(lists->open_searching_until + open_searching_shots, packed, until);
                singles_pack(lists->open_searching_velocity_error + open_searching_shots, packed, velocity_error);
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
        if (open_searching_shots) {
            lanes_store(lists->open_searching_row + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_arrival + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_certain + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_doubt + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_extent + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_last + open_searching_shots, K(0.0));
            singles_store(lists->open_searching_position_error + open_searching_shots, KS(0.0));
            lanes_store(lists->open_searching_share + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_speed + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_t + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_until + open_searching_shots, K(0.0));
            singles_store(lists->open_searching_velocity_error + open_searching_shots, KS(0.0));
            lanes_store(lists->open_searching_vx + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_vy + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_vz + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_x + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_y + open_searching_shots, K(0.0));
            lanes_store(lists->open_searching_z + open_searching_shots, K(0.0));
            if (LANES_SELDOM(varying)) {
                lanes_store(lists->open_searching_p_ball_radius + open_searching_shots, K(0.0));
                lanes_store(lists->open_searching_p_gravity + open_searching_shots, K(0.0));
                lanes_store(lists->open_searching_p_ring_radius + open_searching_shots, K(0.0));
                lanes_store(lists->open_searching_p_wire_radius + open_searching_shots, K(0.0));
            }
        }
        {
        size_t open_searching_searching_shots = 0;
        for (size_t i = 0; i < open_searching_shots; i += LANES_WIDTH) {
            const M rows = lanes_first(open_searching_shots - i);
            if (LANES_SELDOM(varying))
                LANES(hoop_bounded_fix_f80)(lists, i);
            V arrival = lanes_load(lists->open_searching_arrival + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_searching_certain + i));
            V doubt = lanes_load(lists->open_searching_doubt + i);
            V extent = lanes_load(lists->open_searching_extent + i);
            V last = lanes_load(lists->open_searching_last + i);
            S position_error = singles_load(lists->open_searching_position_error + i);
            V share = lanes_load(lists->open_searching_share + i);
            V speed = lanes_load(lists->open_searching_speed + i);
            V t = lanes_load(lists->open_searching_t + i);
            V until = lanes_load(lists->open_searching_until + i);
            S velocity_error = singles_load(lists->open_searching_velocity_error + i);
            V vx = lanes_load(lists->open_searching_vx + i);
            V vy = lanes_load(lists->open_searching_vy + i);
            V vz = lanes_load(lists->open_searching_vz + i);
            V x = lanes_load(lists->open_searching_x + i);
            V y = lanes_load(lists->open_searching_y + i);
            V z = lanes_load(lists->open_searching_z + i);
            const LANES(hoop_ring_prepare_out) _o81 =
                LANES(hoop_ring_prepare)(until, x, y, z, vx, vy, vz, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), lanes_load(lists->fixed[36]), lanes_load(lists->fixed[40]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[17]), lanes_load(lists->fixed[14]), lanes_load(lists->fixed[34]), lanes_load(lists->fixed[38]), lanes_load(lists->fixed[37]), lanes_load(lists->fixed[45]), lanes_load(lists->fixed[28]), lanes_load(lists->fixed[42]), lanes_load(lists->fixed[43]), lanes_load(lists->fixed[44]), lanes_load(lists->fixed[29]), lanes_load(lists->fixed[30]));
            V steady = _o81.steady;
            V swing = _o81.swing;
            V rho_start = _o81.rho_start;
            V low0 = _o81.low0;
            V high0 = _o81.high0;
            V low1 = _o81.low1;
            V high1 = _o81.high1;
            V low2 = _o81.low2;
            V high2 = _o81.high2;
            V ceiling = _o81.ceiling;
            V latest = _o81.latest;
            const LANES(hoop_allowance_out) _o82 =
                LANES(hoop_allowance)(share, latest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), lanes_load(lists->fixed[15]));
            V position_level = _o82.position_level;
            V velocity_level = _o82.velocity_level;
            const LANES(hoop_ring_margins_out) _o83 =
                LANES(hoop_ring_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[46]), lanes_load(lists->fixed[47]), lanes_load(lists->fixed[48]), lanes_load(lists->fixed[49]));
            V flat = _o83.margin;
            V tilt = _o83.leaving_margin;
            V rate_slack = _o83.rate_margin;
            const LANES(hoop_ring_enter_out) _o84 =
                LANES(hoop_ring_enter)(t, K(0.0), high0, high1, high2, low0, low1, low2, t);
            t = _o84.t;
            V end = _o84.end;
            M searching = _o84.searching;
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
                singles_pack(lists->open_searching_searching_position_error + open_searching_searching_shots, packed, position_error);
                lanes_pack(lists->open_searching_searching_rate_slack + open_searching_searching_shots, packed, rate_slack);
                lanes_pack(lists->open_searching_searching_rho_start + open_searching_searching_shots, packed, rho_start);
                lanes_pack(lists->open_searching_searching_share + open_searching_searching_shots, packed, share);
                lanes_pack(lists->open_searching_searching_speed + open_searching_searching_shots, packed, speed);
                lanes_pack(lists->open_searching_searching_steady + open_searching_searching_shots, packed, steady);
                lanes_pack(lists->open_searching_searching_swing + open_searching_searching_shots, packed, swing);
                lanes_pack(lists->open_searching_searching_t + open_searching_searching_shots, packed, t);
                lanes_pack(lists->open_searching_searching_tilt + open_searching_searching_shots, packed, tilt);
                singles_pack(lists->open_searching_searching_velocity_error + open_searching_searching_shots, packed, velocity_error);
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
        if (open_searching_searching_shots) {
            lanes_store(lists->open_searching_searching_row + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_arrival + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_ceiling + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_certain + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_doubt + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_end + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_extent + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_flat + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_high0 + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_high1 + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_high2 + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_last + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_latest + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_low0 + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_low1 + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_low2 + open_searching_searching_shots, K(0.0));
            singles_store(lists->open_searching_searching_position_error + open_searching_searching_shots, KS(0.0));
            lanes_store(lists->open_searching_searching_rate_slack + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_rho_start + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_share + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_speed + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_steady + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_swing + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_t + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_tilt + open_searching_searching_shots, K(0.0));
            singles_store(lists->open_searching_searching_velocity_error + open_searching_searching_shots, KS(0.0));
            lanes_store(lists->open_searching_searching_vx + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_vy + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_vz + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_x + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_y + open_searching_searching_shots, K(0.0));
            lanes_store(lists->open_searching_searching_z + open_searching_searching_shots, K(0.0));
            if (LANES_SELDOM(varying)) {
                lanes_store(lists->open_searching_searching_p_ball_radius + open_searching_searching_shots, K(0.0));
                lanes_store(lists->open_searching_searching_p_gravity + open_searching_searching_shots, K(0.0));
                lanes_store(lists->open_searching_searching_p_ring_radius + open_searching_searching_shots, K(0.0));
                lanes_store(lists->open_searching_searching_p_wire_radius + open_searching_searching_shots, K(0.0));
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
            S position_error = KS(0.0);
            V rate_slack = K(0.0);
            V rho_start = K(0.0);
            V share = K(0.0);
            V speed = K(0.0);
            V steady = K(0.0);
            V swing = K(0.0);
            V t = K(0.0);
            V tilt = K(0.0);
            S velocity_error = KS(0.0);
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
                    position_error = singles_expand(lists->open_searching_searching_position_error + taken, idle, position_error);
                    rate_slack = lanes_expand(lists->open_searching_searching_rate_slack + taken, idle, rate_slack);
                    rho_start = lanes_expand(lists->open_searching_searching_rho_start + taken, idle, rho_start);
                    share = lanes_expand(lists->open_searching_searching_share + taken, idle, share);
                    speed = lanes_expand(lists->open_searching_searching_speed + taken, idle, speed);
                    steady = lanes_expand(lists->open_searching_searching_steady + taken, idle, steady);
                    swing = lanes_expand(lists->open_searching_searching_swing + taken, idle, swing);
                    t = lanes_expand(lists->open_searching_searching_t + taken, idle, t);
                    tilt = lanes_expand(lists->open_searching_searching_tilt + taken, idle, tilt);
                    velocity_error = singles_expand(lists->open_searching_searching_velocity_error + taken, idle, velocity_error);
                    vx = lanes_expand(lists->open_searching_searching_vx + taken, idle, vx);
                    vy = lanes_expand(lists->open_searching_searching_vy + taken, idle, vy);
                    vz = lanes_expand(lists->open_searching_searching_vz + taken, idle, vz);
                    x = lanes_expand(lists->open_searching_searching_x + taken, idle, x);
                    y = lanes_expand(lists->open_searching_searching_y + taken, idle, y);
                    z = lanes_expand(lists->open_searching_searching_z + taken, idle, z);
                    if (LANES_SELDOM(varying))
                        LANES(hoop_bounded_fix_f85)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_searching_searching_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                const LANES(hoop_nearby_out) _o86 =
                    LANES(hoop_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = _o86.leaving;
                V margin = _o86.margin;
                const LANES(hoop_ring_advance_out) _o87 =
                    LANES(hoop_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[25]), lanes_load(lists->fixed[11]), lanes_load(lists->fixed[50]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[51]), lanes_load(lists->fixed[52]));
                V gap = _o87.gap;
                V rate = _o87.rate;
                V bend = _o87.bend;
                V step = _o87.step;
                V next = _o87.next;
                V clearance = _o87.clearance;
                const LANES(hoop_struck_out) _o88 =
                    LANES(hoop_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o88.hit;
                M sure = _o88.sure;
                M vague = _o88.vague;
                const M _m89 = lanes_both(active, vague);
                if (lanes_any(_m89)) {
                    const LANES(hoop_finer_out) _o90 =
                        LANES(hoop_finer)(share);
                    share = lanes_select(_m89, _o90.share, share);
                    const LANES(hoop_allowance_out) _o91 =
                        LANES(hoop_allowance)(share, latest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), lanes_load(lists->fixed[15]));
                    V position_level = _o91.position_level;
                    V velocity_level = _o91.velocity_level;
                    V excess = _o91.excess;
                    const LANES(hoop_ring_margins_out) _o92 =
                        LANES(hoop_ring_margins)(latest, extent, speed, position_level, velocity_level, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[46]), lanes_load(lists->fixed[47]), lanes_load(lists->fixed[48]), lanes_load(lists->fixed[49]));
                    flat = lanes_select(_m89, _o92.margin, flat);
                    tilt = lanes_select(_m89, _o92.leaving_margin, tilt);
                    rate_slack = lanes_select(_m89, _o92.rate_margin, rate_slack);
                    const LANES(hoop_exceeded_out) _o93 =
                        LANES(hoop_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m89, _o93.doubt, doubt);
                }
                const LANES(hoop_advanced_out) _o94 =
                    LANES(hoop_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o94.arrival;
                certain = _o94.certain;
                M exhausted = _o94.exhausted;
                searching = _o94.searching;
                t = _o94.t;
                const M _m95 = lanes_both(active, exhausted);
                {
                    const LANES(hoop_ring_enter_out) _o96 =
                        LANES(hoop_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m95, _o96.t, t);
                    end = lanes_select(_m95, _o96.end, end);
                    searching = lanes_choose(_m95, _o96.searching, searching);
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
            const LANES(hoop_questioned_out) _o97 =
                LANES(hoop_questioned)(doubt, t, searching);
            doubt = _o97.doubt;
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
                LANES(hoop_bounded_fix_f98)(lists, i);
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
            const LANES(hoop_found_out) _o99 =
                LANES(hoop_found)(arrival);
            M arrives = _o99.arrives;
            M refining = _o99.refining;
            V rate = _o99.rate;
            const LANES(hoop_nearby_out) _o100 =
                LANES(hoop_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o100.leaving;
            const M _m101 = lanes_both(rows, refining);
            if (lanes_any(_m101)) {
                const LANES(hoop_ring_refine_out) _o102 =
                    LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[25]), lanes_load(lists->fixed[11]));
                V refined = _o102.time;
                V gap = _o102.gap;
                rate = lanes_select(_m101, _o102.rate, rate);
                const LANES(hoop_polished_out) _o103 =
                    LANES(hoop_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m101, _o103.arrival, arrival);
                refining = lanes_choose(_m101, _o103.refining, refining);
            }
            const M _m104 = lanes_both(rows, refining);
            if (lanes_any(_m104)) {
                const LANES(hoop_ring_refine_out) _o105 =
                    LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[25]), lanes_load(lists->fixed[11]));
                V refined = _o105.time;
                V gap = _o105.gap;
                rate = lanes_select(_m104, _o105.rate, rate);
                const LANES(hoop_polished_out) _o106 =
                    LANES(hoop_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m104, _o106.arrival, arrival);
                refining = lanes_choose(_m104, _o106.refining, refining);
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
        if (open_refining_shots) {
            lanes_store(lists->open_refining_row + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_arrival + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_ceiling + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_certain + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_leaving + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_rho_start + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_vx + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_vy + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_vz + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_x + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_y + open_refining_shots, K(0.0));
            lanes_store(lists->open_refining_z + open_refining_shots, K(0.0));
            if (LANES_SELDOM(varying)) {
                lanes_store(lists->open_refining_p_ball_radius + open_refining_shots, K(0.0));
                lanes_store(lists->open_refining_p_gravity + open_refining_shots, K(0.0));
                lanes_store(lists->open_refining_p_ring_radius + open_refining_shots, K(0.0));
                lanes_store(lists->open_refining_p_wire_radius + open_refining_shots, K(0.0));
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
                        LANES(hoop_bounded_fix_f107)(lists, taken, idle);
                    const size_t room = LANES_WIDTH - busy, left = open_refining_shots - taken;
                    active = lanes_leading(idle, left, active);
                    taken += left < room ? left : room;
                    busy += left < room ? left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                const LANES(hoop_ring_refine_out) _o108 =
                    LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[25]), lanes_load(lists->fixed[11]));
                V refined = _o108.time;
                V gap = _o108.gap;
                V rate = _o108.rate;
                const LANES(hoop_polished_out) _o109 =
                    LANES(hoop_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o109.arrival;
                refining = _o109.refining;
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
                LANES(hoop_bounded_fix_f110)(lists, i);
            V arrival = lanes_load(lists->open_arrival + i);
            M arrives = lanes_less(K(0.0), lanes_load(lists->open_arrives + i));
            V ceiling = lanes_load(lists->open_ceiling + i);
            M certain = lanes_less(K(0.0), lanes_load(lists->open_certain + i));
            V doubt = lanes_load(lists->open_doubt + i);
            V extent = lanes_load(lists->open_extent + i);
            V late = lanes_load(lists->open_late + i);
            V latest = lanes_load(lists->open_latest + i);
            V leaving = lanes_load(lists->open_leaving + i);
            S position_error = singles_load(lists->open_position_error + i);
            V rate = lanes_load(lists->open_rate + i);
            V speed = lanes_load(lists->open_speed + i);
            S velocity_error = singles_load(lists->open_velocity_error + i);
            V when = lanes_load(lists->open_when + i);
            V which = lanes_load(lists->open_which + i);
            const LANES(hoop_ring_margins_out) _o111 =
                LANES(hoop_ring_margins)(latest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[31]), lanes_load(lists->fixed[46]), lanes_load(lists->fixed[47]), lanes_load(lists->fixed[48]), lanes_load(lists->fixed[49]));
            V flat = _o111.margin;
            V tilt = _o111.leaving_margin;
            V rate_margin = _o111.rate_margin;
            const LANES(hoop_own_margin_out) _o112 =
                LANES(hoop_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o112.margin;
            const LANES(hoop_crossing_out) _o113 =
                LANES(hoop_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o113.clearance;
            V delay = _o113.delay;
            const LANES(hoop_landed_out) _o114 =
                LANES(hoop_landed)(arrival);
            V time = _o114.time;
            const LANES(hoop_landed_surely_out) _o115 =
                LANES(hoop_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o115.delay;
            doubt = _o115.doubt;
            const LANES(hoop_tied_out) _o116 =
                LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o116.doubt;
            late = _o116.late;
            const LANES(hoop_sooner_out) _o117 =
                LANES(hoop_sooner)(arrives, K(0.0), time, when, which);
            when = _o117.when;
            which = _o117.which;
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
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_first(shots - i);
            if (LANES_SELDOM(varying))
                LANES(hoop_bounded_fix_f118)(lists, i);
            V clock = lanes_load(lists->clock + i);
            S clock_error = singles_load(lists->clock_error + i);
            V contacts = lanes_load(lists->contacts + i);
            V doubt = lanes_load(lists->doubt + i);
            S dvx = singles_load(lists->dvx + i);
            S dvy = singles_load(lists->dvy + i);
            S dvz = singles_load(lists->dvz + i);
            S dwx = singles_load(lists->dwx + i);
            S dwy = singles_load(lists->dwy + i);
            S dwz = singles_load(lists->dwz + i);
            S dx = singles_load(lists->dx + i);
            S dy = singles_load(lists->dy + i);
            S dz = singles_load(lists->dz + i);
            V extent = lanes_load(lists->extent + i);
            V late = lanes_load(lists->late + i);
            M limited = lanes_less(K(0.0), lanes_load(lists->limited + i));
            S position_error = singles_load(lists->position_error + i);
            V speed = lanes_load(lists->speed + i);
            S time_error = singles_load(lists->time_error + i);
            V uncertain = lanes_load(lists->uncertain + i);
            S velocity_error = singles_load(lists->velocity_error + i);
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
            const M _m119 = lanes_both(rows, limited);
            if (lanes_any(_m119)) {
                const LANES(hoop_expiry_out) _o120 =
                    LANES(hoop_expiry)(clock, doubt, late, lanes_wide(time_error), time_limit, when, which);
                V time = _o120.time;
                V delay = _o120.delay;
                M arrives = _o120.arrives;
                doubt = lanes_select(_m119, _o120.doubt, doubt);
                const LANES(hoop_tied_out) _o121 =
                    LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
                doubt = lanes_select(_m119, _o121.doubt, doubt);
                late = lanes_select(_m119, _o121.late, late);
                const LANES(hoop_sooner_out) _o122 =
                    LANES(hoop_sooner)(arrives, K(4.0), time, when, which);
                when = lanes_select(_m119, _o122.when, when);
                which = lanes_select(_m119, _o122.which, which);
            }
            const LANES(hoop_departed_out) _o123 =
                LANES(hoop_departed)(K(3.0), which);
            M moves = _o123.moves;
            M ends = _o123.ends;
            M touches = _o123.touches;
            V reached = _o123.reached;
            M edge = _o123.edge;
            const LANES(hoop_body_of_out) _o124 =
                LANES(hoop_body_of)(which);
            V body = _o124.body;
            const M _m125 = lanes_both(rows, moves);
            {
                const LANES(hoop_flight_out) _o126 =
                    LANES(hoop_flight)(when, x, y, z, vx, vy, vz, lanes_load(lists->fixed[15]), lanes_load(lists->fixed[25]));
                x = lanes_select(_m125, _o126.x, x);
                y = lanes_select(_m125, _o126.y, y);
                z = lanes_select(_m125, _o126.z, z);
                vx = lanes_select(_m125, _o126.vx, vx);
                vy = lanes_select(_m125, _o126.vy, vy);
                vz = lanes_select(_m125, _o126.vz, vz);
                const LANES(hoop_ticked_out) _o127 =
                    LANES(hoop_ticked)(clock, when);
                clock = lanes_select(_m125, _o127.clock, clock);
            }
            const M _m128 = lanes_both(rows, limited);
            if (lanes_any(_m128)) {
                const LANES(hoop_expired_out) _o129 =
                    LANES(hoop_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m128, _o129.clock, clock);
                body = lanes_select(_m128, _o129.body, body);
                reached = lanes_select(_m128, _o129.reached, reached);
                ends = lanes_choose(_m128, _o129.ends, ends);
            }
            const LANES(hoop_displacement_out) _o130 =
                LANES(hoop_displacement)(late, when, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), lanes_load(lists->fixed[15]), lanes_load(lists->fixed[26]));
            V slack = _o130.margin;
            const LANES(hoop_here_out) _o131 =
                LANES(hoop_here)(K(3.0), which);
            M here = _o131.here;
            const M _m132 = lanes_both(rows, here);
            {
                const LANES(hoop_end_bounds_out) _o133 =
                    LANES(hoop_end_bounds)(x, y, lanes_load(lists->fixed[5]));
                V g0 = _o133.g0;
                const LANES(hoop_end_reached_out) _o134 =
                    LANES(hoop_end_reached)(g0);
                reached = lanes_select(_m132, _o134.reached, reached);
                const LANES(hoop_end_edge_out) _o135 =
                    LANES(hoop_end_edge)(g0, slack);
                edge = lanes_choose(_m132, _o135.edge, edge);
            }
            const LANES(hoop_doubted_out) _o136 =
                LANES(hoop_doubted)(doubt, edge, late, uncertain, when);
            uncertain = _o136.uncertain;
            const LANES(hoop_accounted_out) _o137 =
                LANES(hoop_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o137.contacts;
            V outcome = _o137.outcome;
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
            const LANES(hoop_meeting_out) _o138 =
                LANES(hoop_meeting)(claims, ends, touches);
            M meeting = _o138.meeting;
            const M _m139 = lanes_both(rows, meeting);
            if (lanes_any(_m139)) {
                V count_0 = lanes_load(lists->count_0 + i);
                V count_1 = lanes_load(lists->count_1 + i);
                V count_2 = lanes_load(lists->count_2 + i);
                V first = lanes_load(lists->first + i);
                V last = lanes_load(lists->last + i);
                const LANES(hoop_end_normal_out) _o140 =
                    LANES(hoop_end_normal)();
                V nx = _o140.nx;
                V ny = _o140.ny;
                V nz = _o140.nz;
                const LANES(hoop_here_out) _o141 =
                    LANES(hoop_here)(K(0.0), which);
                M here = _o141.here;
                const M _m142 = lanes_both(_m139, here);
                {
                    const LANES(hoop_ring_normal_out) _o143 =
                        LANES(hoop_ring_normal)(x, y, z, lanes_load(lists->fixed[5]), lanes_load(lists->fixed[53]));
                    nx = lanes_select(_m142, _o143.nx, nx);
                    ny = lanes_select(_m142, _o143.ny, ny);
                    nz = lanes_select(_m142, _o143.nz, nz);
                    const LANES(hoop_counted_out) _o144 =
                        LANES(hoop_counted)(count_0);
                    count_0 = lanes_select(_m142, _o144.count, count_0);
                }
                const LANES(hoop_here_out) _o145 =
                    LANES(hoop_here)(K(1.0), which);
                here = _o145.here;
                const M _m146 = lanes_both(_m139, here);
                {
                    const LANES(hoop_backboard_normal_out) _o147 =
                        LANES(hoop_backboard_normal)();
                    nx = lanes_select(_m146, _o147.nx, nx);
                    ny = lanes_select(_m146, _o147.ny, ny);
                    nz = lanes_select(_m146, _o147.nz, nz);
                    const LANES(hoop_counted_out) _o148 =
                        LANES(hoop_counted)(count_1);
                    count_1 = lanes_select(_m146, _o148.count, count_1);
                }
                const LANES(hoop_here_out) _o149 =
                    LANES(hoop_here)(K(2.0), which);
                here = _o149.here;
                const M _m150 = lanes_both(_m139, here);
                {
                    const LANES(hoop_bridge_normal_out) _o151 =
                        LANES(hoop_bridge_normal)();
                    nx = lanes_select(_m150, _o151.nx, nx);
                    ny = lanes_select(_m150, _o151.ny, ny);
                    nz = lanes_select(_m150, _o151.nz, nz);
                    const LANES(hoop_counted_out) _o152 =
                        LANES(hoop_counted)(count_2);
                    count_2 = lanes_select(_m150, _o152.count, count_2);
                }
                const LANES(hoop_elsewhere_out) _o153 =
                    LANES(hoop_elsewhere)();
                V curving = _o153.curving;
                const LANES(hoop_again_out) _o154 =
                    LANES(hoop_again)(K(0.0), last, which);
                M again = _o154.again;
                const M _m155 = lanes_both(_m139, again);
                {
                    const LANES(hoop_ring_curvature_out) _o156 =
                        LANES(hoop_ring_curvature)(lanes_load(lists->fixed[54]));
                    curving = lanes_select(_m155, _o156.curvature, curving);
                }
                const LANES(hoop_again_out) _o157 =
                    LANES(hoop_again)(K(1.0), last, which);
                again = _o157.again;
                const M _m158 = lanes_both(_m139, again);
                {
                    const LANES(hoop_backboard_curvature_out) _o159 =
                        LANES(hoop_backboard_curvature)();
                    curving = lanes_select(_m158, _o159.curvature, curving);
                }
                const LANES(hoop_again_out) _o160 =
                    LANES(hoop_again)(K(2.0), last, which);
                again = _o160.again;
                const M _m161 = lanes_both(_m139, again);
                {
                    const LANES(hoop_bridge_curvature_out) _o162 =
                        LANES(hoop_bridge_curvature)();
                    curving = lanes_select(_m161, _o162.curvature, curving);
                }
                const LANES(hoop_carry_flight_out) _o163 =
                    LANES(hoop_carry_flight)(lanes_narrow(when), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(nx), lanes_narrow(ny), lanes_narrow(nz), lanes_narrow(clock), lanes_narrow(contacts), lanes_narrow(late), dx, dy, dz, dvx, dvy, dvz, lanes_narrow(curving), singles_load(lists->fixed_single[0]));
                dx = singles_select(singles_of(_m139), _o163.dx, dx);
                dy = singles_select(singles_of(_m139), _o163.dy, dy);
                dz = singles_select(singles_of(_m139), _o163.dz, dz);
                dvx = singles_select(singles_of(_m139), _o163.dvx, dvx);
                dvy = singles_select(singles_of(_m139), _o163.dvy, dvy);
                dvz = singles_select(singles_of(_m139), _o163.dvz, dvz);
                S belated = _o163.delay;
                S shift = _o163.shift;
                const LANES(hoop_delayed_out) _o164 =
                    LANES(hoop_delayed)(clock_error, belated);
                clock_error = singles_select(singles_of(_m139), _o164.clock_error, clock_error);
                const M _m165 = lanes_both(_m139, ends);
                {
                    const LANES(hoop_floored_out) _o166 =
                        LANES(hoop_floored)(dx, dy, dz, shift);
                    dx = singles_select(singles_of(_m165), _o166.dx, dx);
                    dy = singles_select(singles_of(_m165), _o166.dy, dy);
                    dz = singles_select(singles_of(_m165), _o166.dz, dz);
                }
                const LANES(hoop_unturned_out) _o167 =
                    LANES(hoop_unturned)();
                S dnx = _o167.dnx;
                S dny = _o167.dny;
                S dnz = _o167.dnz;
                S turn = _o167.turn;
                const LANES(hoop_here_out) _o168 =
                    LANES(hoop_here)(K(0.0), which);
                here = _o168.here;
                const M _m169 = lanes_both(_m139, here);
                if (lanes_any(_m169)) {
                    const LANES(hoop_ring_carry_normal_out) _o170 =
                        LANES(hoop_ring_carry_normal)(lanes_narrow(x), lanes_narrow(y), dx, dy, dz, shift, singles_load(lists->fixed_single[19]), singles_load(lists->fixed_single[26]), singles_load(lists->fixed_single[27]));
                    dnx = singles_select(singles_of(_m169), _o170.dnx, dnx);
                    dny = singles_select(singles_of(_m169), _o170.dny, dny);
                    dnz = singles_select(singles_of(_m169), _o170.dnz, dnz);
                    turn = singles_select(singles_of(_m169), _o170.turn, turn);
                }
                const M _m171 = lanes_both(_m139, touches);
                if (lanes_any(_m171)) {
                    const LANES(hoop_carry_impact_out) _o172 =
                        LANES(hoop_carry_impact)(lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(wx), lanes_narrow(wy), lanes_narrow(wz), lanes_narrow(nx), lanes_narrow(ny), lanes_narrow(nz), lanes_narrow(contacts), dvx, dvy, dvz, dwx, dwy, dwz, dnx, dny, dnz, turn, singles_load(lists->fixed_single[28]), singles_load(lists->fixed_single[29]), singles_load(lists->fixed_single[30]), singles_load(lists->fixed_single[31]));
                    dvx = singles_select(singles_of(_m171), _o172.dvx, dvx);
                    dvy = singles_select(singles_of(_m171), _o172.dvy, dvy);
                    dvz = singles_select(singles_of(_m171), _o172.dvz, dvz);
                    dwx = singles_select(singles_of(_m171), _o172.dwx, dwx);
                    dwy = singles_select(singles_of(_m171), _o172.dwy, dwy);
                    dwz = singles_select(singles_of(_m171), _o172.dwz, dwz);
                    const LANES(hoop_impact_out) _o173 =
                        LANES(hoop_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, lanes_load(lists->fixed[55]), lanes_load(lists->fixed[56]), lanes_load(lists->fixed[57]));
                    vx = lanes_select(_m171, _o173.vx, vx);
                    vy = lanes_select(_m171, _o173.vy, vy);
                    vz = lanes_select(_m171, _o173.vz, vz);
                    wx = lanes_select(_m171, _o173.wx, wx);
                    wy = lanes_select(_m171, _o173.wy, wy);
                    wz = lanes_select(_m171, _o173.wz, wz);
                }
                const LANES(hoop_here_out) _o174 =
                    LANES(hoop_here)(K(1.0), which);
                here = _o174.here;
                const M _m175 = lanes_both(_m139, here);
                {
                    const LANES(hoop_backboard_place_out) _o176 =
                        LANES(hoop_backboard_place)(y, z, lanes_load(lists->fixed[3]));
                    x = lanes_select(_m175, _o176.x, x);
                    y = lanes_select(_m175, _o176.y, y);
                    z = lanes_select(_m175, _o176.z, z);
                }
                const LANES(hoop_here_out) _o177 =
                    LANES(hoop_here)(K(2.0), which);
                here = _o177.here;
                const M _m178 = lanes_both(_m139, here);
                {
                    const LANES(hoop_bridge_place_out) _o179 =
                        LANES(hoop_bridge_place)(x, y, lanes_load(lists->fixed[10]));
                    x = lanes_select(_m178, _o179.x, x);
                    y = lanes_select(_m178, _o179.y, y);
                    z = lanes_select(_m178, _o179.z, z);
                }
                const M _m180 = lanes_both(_m139, touches);
                {
                    const LANES(hoop_touched_out) _o181 =
                        LANES(hoop_touched)(body, first, which);
                    first = lanes_select(_m180, _o181.first, first);
                    last = lanes_select(_m180, _o181.last, last);
                }
                lanes_store(lists->count_0 + i, count_0);
                lanes_store(lists->count_1 + i, count_1);
                lanes_store(lists->count_2 + i, count_2);
                singles_store(lists->dwx + i, dwx);
                singles_store(lists->dwy + i, dwy);
                singles_store(lists->dwz + i, dwz);
                lanes_store(lists->first + i, first);
                lanes_store(lists->last + i, last);
                lanes_store(lists->wx + i, wx);
                lanes_store(lists->wy + i, wy);
                lanes_store(lists->wz + i, wz);
            }
            const M _m182 = lanes_both(rows, limited);
            if (lanes_any(_m182)) {
                const LANES(hoop_timed_out) _o183 =
                    LANES(hoop_timed)(claims, K(4.0), which);
                M timed = _o183.timed;
                const M _m184 = lanes_both(_m182, timed);
                if (lanes_any(_m184)) {
                    const LANES(hoop_carry_time_out) _o185 =
                        LANES(hoop_carry_time)(lanes_narrow(when), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(clock), clock_error, dx, dy, dz, dvx, dvy, dvz, singles_load(lists->fixed_single[0]), singles_load(lists->fixed_single[32]));
                    dx = singles_select(singles_of(_m184), _o185.dx, dx);
                    dy = singles_select(singles_of(_m184), _o185.dy, dy);
                    dz = singles_select(singles_of(_m184), _o185.dz, dz);
                    dvx = singles_select(singles_of(_m184), _o185.dvx, dvx);
                    dvy = singles_select(singles_of(_m184), _o185.dvy, dvy);
                    dvz = singles_select(singles_of(_m184), _o185.dvz, dvz);
                    clock_error = singles_select(singles_of(_m184), _o185.clock_error, clock_error);
                }
            }
            const LANES(hoop_closing_out) _o186 =
                LANES(hoop_closing)(lanes_narrow(claims), lanes_narrow(outcome));
            M closed = _o186.closed;
            S position_claim = _o186.position_claim;
            S velocity_claim = _o186.velocity_claim;
            S spin_claim = _o186.spin_claim;
            S time_claim = _o186.time_claim;
            const M _m187 = lanes_both(rows, closed);
            if (lanes_any(_m187)) {
                const LANES(hoop_claimed_errors_out) _o188 =
                    LANES(hoop_claimed_errors)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
                position_claim = singles_select(singles_of(_m187), _o188.position_error, position_claim);
                velocity_claim = singles_select(singles_of(_m187), _o188.velocity_error, velocity_claim);
                spin_claim = singles_select(singles_of(_m187), _o188.spin_error, spin_claim);
                time_claim = singles_select(singles_of(_m187), _o188.time_error, time_claim);
            }
            lanes_store(lists->clock + i, clock);
            singles_store(lists->clock_error + i, clock_error);
            lanes_store(lists->contacts + i, contacts);
            singles_store(lists->dvx + i, dvx);
            singles_store(lists->dvy + i, dvy);
            singles_store(lists->dvz + i, dvz);
            singles_store(lists->dx + i, dx);
            singles_store(lists->dy + i, dy);
            singles_store(lists->dz + i, dz);
            lanes_store(lists->outcome + i, outcome);
            singles_store(lists->position_claim + i, position_claim);
            singles_store(lists->spin_claim + i, spin_claim);
            singles_store(lists->time_claim + i, time_claim);
            lanes_store(lists->uncertain + i, uncertain);
            singles_store(lists->velocity_claim + i, velocity_claim);
            lanes_store(lists->vx + i, vx);
            lanes_store(lists->vy + i, vy);
            lanes_store(lists->vz + i, vz);
            lanes_store(lists->x + i, x);
            lanes_store(lists->y + i, y);
            lanes_store(lists->z + i, z);
        }
        if (recording)
            for (size_t k = 0; k < shots; k++) {
                if (lists->body[k] < 0.0)
                    continue;
                const size_t shot = lists->shot[k], rows = HOOP_LOG_ROWS * (size_t)job->max_contacts + 1;
                int32_t *used = job->results->event_counts + shot;
                hoop_event *event = job->results->events + shot * rows + (size_t)(*used)++;
                const int64_t body = (int64_t)lists->body[k], staying = body - HOOP_SURFACES - 1;
                event->shot = (int64_t)shot;
                event->surface = staying < 0 ? body : staying / 2;
                event->kind = staying < -1 ? HOOP_EVENT_IMPACT : staying < 0 ? HOOP_EVENT_END : staying % 2 ? HOOP_EVENT_LEAVE : HOOP_EVENT_ROLL;
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
            LANES(hoop_bounded_finish_all)(lists, shots, job);
            shots = 0;
            streams = 1;
            continue;
        }
        streams = 0;
        shots = LANES(hoop_bounded_leave)(lists, 0, shots, job);
    }
}

/* Run the job; return 0 if there is no memory for it. */
static int LANES(hoop_run)(const hoop_job *job)
{
    const hoop_results *out = job->results;
    const int bounds = out->time_error || out->state_error || out->uncertain;
    /* Not on the stack: they may be megabytes, and threads have little of it. */
    const size_t size = bounds ? sizeof(LANES(hoop_bounded_lists)) : sizeof(LANES(hoop_plain_lists));
    void *const room = malloc(size + 63);
    if (room == NULL)
        return 0;
    void *const lists = (void *)(((uintptr_t)room + 63) / 64 * 64);
    if (bounds)
        LANES(hoop_bounded)(job, lists);
    else
        LANES(hoop_plain)(job, lists);
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
