/* The event loop of the scene hoop, LANES_WIDTH shots abreast.

   Generated from templates/c/engine.h.j2, scene hoop, derivation 7b799bc075893f3b,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Included by hoop.c once for every width. The shots in flight fill the first rows of the lists;
   when one ends, the last takes its row. Stages go over all rows, and over those of a list of their
   own where only some shots need them. No shot's result depends on its neighbours. */

#include "hoop_lanes.h"
#include "hoop_kernels.h"

/* A column, with room for a whole row of lanes behind its end. */
typedef double LANES(hoop_column)[LANES_SHOTS + LANES_WIDTH];
typedef float LANES(hoop_singles)[LANES_SHOTS + LANES_WIDTH];

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
    const LANES(hoop_finite_parameters_out) _o2 =
        LANES(hoop_finite_parameters)(p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_restitution, p_gravity, p_end_depth, allowed);
    M permitted = _o2.permitted;
    return permitted;
}

/* Shots in flight, a column for each quantity, and the lists of those that need a longer look. */
typedef struct {
    _Alignas(64) size_t shot[LANES_SHOTS];
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
} LANES(hoop_plain_lists);

/* Put the next shots into rows, from one on. */
LANES_INLINE void LANES(hoop_plain_begin)(LANES(hoop_plain_lists) *lists, size_t row, size_t shots, const hoop_job *job, size_t start)
{
    const double *state = job->states + HOOP_STATE * start;
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

/* Run the job: fill the rows, take every shot to its next event, make room of those that ended.
   No errors are bounded: the same path, with less work. */
static void LANES(hoop_plain)(const hoop_job *job)
{
    LANES(hoop_plain_lists) all, *const lists = &all;
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
    const M all_permitted = LANES(hoop_permit)(lanes_load(lists->p_ball_radius), lanes_load(lists->p_ring_radius), lanes_load(lists->p_wire_radius), lanes_load(lists->p_board_distance), lanes_load(lists->p_board_half_width), lanes_load(lists->p_board_bottom), lanes_load(lists->p_board_top), lanes_load(lists->p_bridge_half_width), lanes_load(lists->p_restitution), lanes_load(lists->p_gravity), lanes_load(lists->p_end_depth));
    for (;;) {
        if (job->stop && *job->stop)
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
            V last = lanes_load(lists->last + i);
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_bottom = lanes_load(lists->p_board_bottom + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_board_half_width = lanes_load(lists->p_board_half_width + (i & varying));
            const V p_board_top = lanes_load(lists->p_board_top + (i & varying));
            const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + (i & varying));
            const V p_end_depth = lanes_load(lists->p_end_depth + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_restitution = lanes_load(lists->p_restitution + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
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
                permitted = LANES(hoop_permit)(p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_restitution, p_gravity, p_end_depth);
            const LANES(hoop_finite_state_out) _o1 =
                LANES(hoop_finite_state)(vx, vy, vz, wx, wy, wz, x, y, z);
            M finite = _o1.finite;
            const LANES(hoop_valid_out) _o2 =
                LANES(hoop_valid)(last, x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_end_depth);
            V valid = _o2.valid;
            const LANES(hoop_admitted_out) _o3 =
                LANES(hoop_admitted)(K(INFINITY), finite, permitted, valid);
            V outcome = _o3.outcome;
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
            V last = lanes_load(lists->last + i);
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_bottom = lanes_load(lists->p_board_bottom + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_board_half_width = lanes_load(lists->p_board_half_width + (i & varying));
            const V p_board_top = lanes_load(lists->p_board_top + (i & varying));
            const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + (i & varying));
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
            const LANES(hoop_error_bounds_out) _o4 =
                LANES(hoop_error_bounds)(KS(0.0), KS(0.0), KS(0.0), KS(0.0), KS(0.0), KS(0.0), KS(0.0), KS(0.0), KS(0.0), KS(0.0));
            S time_error = _o4.time_error;
            const LANES(hoop_scale_out) _o5 =
                LANES(hoop_scale)(x, y, z, vx, vy, vz, p_gravity);
            V extent = _o5.extent;
            V speed = _o5.speed;
            V excess = _o5.excess;
            const LANES(hoop_opening_out) _o6 =
                LANES(hoop_opening)(excess, K(0.0), K(0.0));
            V when = _o6.when;
            V which = _o6.which;
            const LANES(hoop_limited_out) _o7 =
                LANES(hoop_limited)(time_limit);
            M limited = _o7.limited;
            const LANES(hoop_left_out) _o8 =
                LANES(hoop_left)(K(3.0), last);
            V leaving = _o8.leaving;
            const LANES(hoop_end_arrival_out) _o9 =
                LANES(hoop_end_arrival)(leaving, z, vz, p_gravity, p_end_depth);
            V time = _o9.time;
            V rate = _o9.rate;
            V bend = _o9.bend;
            V apex = _o9.apex;
            const LANES(hoop_meeting_plane_out) _o10 =
                LANES(hoop_meeting_plane)(apex, bend, rate, time);
            M arrives = _o10.arrives;
            const LANES(hoop_timely_out) _o11 =
                LANES(hoop_timely)(arrives, K(0.0), K(0.0), time, when);
            M possible = _o11.possible;
            const M _m12 = lanes_both(rows, possible);
            {
                const LANES(hoop_sooner_out) _o13 =
                    LANES(hoop_sooner)(arrives, K(3.0), time, when, which);
                when = lanes_select(_m12, _o13.when, when);
                which = lanes_select(_m12, _o13.which, which);
            }
            const LANES(hoop_released_out) _o14 =
                LANES(hoop_released)(last);
            M released = _o14.released;
            M reachable = _o14.reachable;
            const M _m15 = lanes_both(rows, released);
            if (lanes_any(_m15)) {
                const LANES(hoop_horizon_out) _o16 =
                    LANES(hoop_horizon)(when, speed, p_gravity);
                V until = _o16.horizon;
                V pad = _o16.pad;
                const LANES(hoop_reachable_out) _o17 =
                    LANES(hoop_reachable)(p_ball_radius, p_board_distance, p_bridge_half_width, extent, p_gravity, until, K(0.0), pad, K(0.0), p_ring_radius, speed, K(0.0), vx, x);
                reachable = lanes_choose(_m15, _o17.reachable, reachable);
            }
            const M _m18 = lanes_both(rows, reachable);
            if (lanes_any(_m18)) {
                const LANES(hoop_left_out) _o19 =
                    LANES(hoop_left)(K(1.0), last);
                V leaving = _o19.leaving;
                const LANES(hoop_backboard_arrival_out) _o20 =
                    LANES(hoop_backboard_arrival)(leaving, x, vx, p_ball_radius, p_board_distance);
                V time = _o20.time;
                V rate = _o20.rate;
                V bend = _o20.bend;
                V apex = _o20.apex;
                const LANES(hoop_meeting_plane_out) _o21 =
                    LANES(hoop_meeting_plane)(apex, bend, rate, time);
                M arrives = _o21.arrives;
                const LANES(hoop_timely_out) _o22 =
                    LANES(hoop_timely)(arrives, K(0.0), K(0.0), time, when);
                M possible = _o22.possible;
                const M _m23 = lanes_both(_m18, possible);
                {
                    const LANES(hoop_flight_out) _o24 =
                        LANES(hoop_flight)(time, x, y, z, vx, vy, vz, p_gravity);
                    V there_y = _o24.y;
                    V there_z = _o24.z;
                    const LANES(hoop_backboard_bounds_out) _o25 =
                        LANES(hoop_backboard_bounds)(there_y, there_z, p_board_half_width, p_board_bottom, p_board_top);
                    V g0 = _o25.g0;
                    V g1 = _o25.g1;
                    V g2 = _o25.g2;
                    V g3 = _o25.g3;
                    const LANES(hoop_backboard_within_out) _o26 =
                        LANES(hoop_backboard_within)(g0, g1, g2, g3);
                    M arrives = _o26.arrives;
                    const LANES(hoop_sooner_out) _o27 =
                        LANES(hoop_sooner)(arrives, K(1.0), time, when, which);
                    when = lanes_select(_m23, _o27.when, when);
                    which = lanes_select(_m23, _o27.which, which);
                }
                const LANES(hoop_left_out) _o28 =
                    LANES(hoop_left)(K(2.0), last);
                leaving = _o28.leaving;
                const LANES(hoop_bridge_arrival_out) _o29 =
                    LANES(hoop_bridge_arrival)(leaving, z, vz, p_ball_radius, p_wire_radius, p_gravity);
                time = _o29.time;
                rate = _o29.rate;
                bend = _o29.bend;
                apex = _o29.apex;
                const LANES(hoop_meeting_plane_out) _o30 =
                    LANES(hoop_meeting_plane)(apex, bend, rate, time);
                arrives = _o30.arrives;
                const LANES(hoop_timely_out) _o31 =
                    LANES(hoop_timely)(arrives, K(0.0), K(0.0), time, when);
                possible = _o31.possible;
                const M _m32 = lanes_both(_m18, possible);
                if (lanes_any(_m32)) {
                    const LANES(hoop_flight_out) _o33 =
                        LANES(hoop_flight)(time, x, y, z, vx, vy, vz, p_gravity);
                    V there_x = _o33.x;
                    V there_y = _o33.y;
                    const LANES(hoop_bridge_bounds_out) _o34 =
                        LANES(hoop_bridge_bounds)(there_x, there_y, p_ring_radius, p_board_distance, p_bridge_half_width);
                    V g0 = _o34.g0;
                    V g1 = _o34.g1;
                    V g2 = _o34.g2;
                    V g3 = _o34.g3;
                    V g4 = _o34.g4;
                    const LANES(hoop_bridge_within_out) _o35 =
                        LANES(hoop_bridge_within)(g0, g1, g2, g3, g4);
                    M arrives = _o35.arrives;
                    const LANES(hoop_sooner_out) _o36 =
                        LANES(hoop_sooner)(arrives, K(2.0), time, when, which);
                    when = lanes_select(_m32, _o36.when, when);
                    which = lanes_select(_m32, _o36.which, which);
                }
            }
            const LANES(hoop_horizon_out) _o37 =
                LANES(hoop_horizon)(when, speed, p_gravity);
            V until = _o37.horizon;
            const LANES(hoop_ring_clear_out) _o38 =
                LANES(hoop_ring_clear)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V clear = _o38.clear;
            const LANES(hoop_opens_out) _o39 =
                LANES(hoop_opens)(clear);
            M open = _o39.open;
            lanes_store(lists->limited + i, lanes_select(limited, K(1.0), K(0.0)));
            singles_store(lists->time_error + i, time_error);
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
            const LANES(hoop_beginning_out) _o40 =
                LANES(hoop_beginning)();
            V share = _o40.share;
            V arrival = _o40.arrival;
            M certain = _o40.certain;
            const LANES(hoop_left_out) _o41 =
                LANES(hoop_left)(K(0.0), last);
            V leaving = _o41.leaving;
            const LANES(hoop_ring_opened_out) _o42 =
                LANES(hoop_ring_opened)(lanes_narrow(until), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
            S onset = _o42.t;
            S wide_end = _o42.end;
            M searching = _o42.searching;
            S wide_low1 = _o42.low1;
            S wide_high1 = _o42.high1;
            S wide_low2 = _o42.low2;
            S wide_high2 = _o42.high2;
            S lapsed = _o42.latest;
            M sound = _o42.sound;
            const LANES(hoop_opened_out) _o43 =
                LANES(hoop_opened)(lanes_wide(lapsed), lanes_wide(onset));
            V since = _o43.time;
            const LANES(hoop_ring_started_out) _o44 =
                LANES(hoop_ring_started)(x, y, z, vx, vy, vz, p_ring_radius);
            V rho_start = _o44.rho_start;
            V parting = _o44.parting;
            V drift = _o44.drift;
            const LANES(hoop_flight_out) _o45 =
                LANES(hoop_flight)(since, x, y, z, vx, vy, vz, p_gravity);
            V near_x = _o45.x;
            V near_y = _o45.y;
            V near_z = _o45.z;
            V near_vz = _o45.vz;
            const LANES(hoop_ring_grain_out) _o46 =
                LANES(hoop_ring_grain)(onset, wide_end, lanes_narrow(leaving), lapsed, lanes_narrow(near_x), lanes_narrow(near_y), lanes_narrow(near_z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(near_vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(parting), lanes_narrow(drift), wide_low1, wide_high1, wide_low2, wide_high2, lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
            S short_share = _o46.share;
            S short_t = _o46.t;
            S short_end = _o46.end;
            S short_x = _o46.x;
            S short_y = _o46.y;
            S short_z = _o46.z;
            S short_vx = _o46.vx;
            S short_vy = _o46.vy;
            S short_vz = _o46.vz;
            S short_steady = _o46.steady;
            S short_swing = _o46.swing;
            S short_rho_start = _o46.rho_start;
            S short_ceiling = _o46.ceiling;
            S short_flat = _o46.flat;
            S short_tilt = _o46.tilt;
            S short_jerk = _o46.jerk;
            S short_grit = _o46.grit;
            S short_parting = _o46.parting;
            S short_drift = _o46.drift;
            S short_rate_margin = _o46.rate_margin;
            S short_low1 = _o46.low1;
            S short_high1 = _o46.high1;
            S short_low2 = _o46.low2;
            S short_high2 = _o46.high2;
            M fits = _o46.fits;
            const LANES(hoop_coarse_out) _o47 =
                LANES(hoop_coarse)(lanes_wide(short_ceiling), fits, lanes_wide(short_flat), lanes_wide(short_rate_margin), searching, lanes_wide(short_share), sound);
            M leaping = _o47.leaping;
            searching = _o47.searching;
            M served = _o47.served;
            V ceiling = _o47.ceiling;
            V flat = _o47.flat;
            V tilt = _o47.tilt;
            const M _m48 = lanes_both(rows, leaping);
            if (lanes_any(_m48)) {
                const LANES(hoop_ring_leap_out) _o49 =
                    LANES(hoop_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
                short_t = singles_select(singles_of(_m48), _o49.t, short_t);
                short_end = singles_select(singles_of(_m48), _o49.end, short_end);
                certain = lanes_choose(_m48, _o49.certain, certain);
                leaping = lanes_choose(_m48, _o49.leaping, leaping);
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
                const LANES(hoop_ring_leap_out) _o50 =
                    LANES(hoop_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
                short_t = _o50.t;
                short_end = _o50.end;
                M certain = _o50.certain;
                leaping = _o50.leaping;
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
            const LANES(hoop_leapt_out) _o51 =
                LANES(hoop_leapt)(arrival, certain, lanes_wide(short_t), searching, served, since);
            arrival = _o51.arrival;
            V t = _o51.t;
            searching = _o51.searching;
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
            const LANES(hoop_ring_prepare_out) _o52 =
                LANES(hoop_ring_prepare)(until, x, y, z, vx, vy, vz, K(0.0), K(0.0), p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V steady = _o52.steady;
            V swing = _o52.swing;
            V rho_start = _o52.rho_start;
            V low0 = _o52.low0;
            V high0 = _o52.high0;
            V low1 = _o52.low1;
            V high1 = _o52.high1;
            V low2 = _o52.low2;
            V high2 = _o52.high2;
            V ceiling = _o52.ceiling;
            V latest = _o52.latest;
            const LANES(hoop_allowance_out) _o53 =
                LANES(hoop_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
            V position_level = _o53.position_level;
            V velocity_level = _o53.velocity_level;
            const LANES(hoop_ring_margins_out) _o54 =
                LANES(hoop_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V flat = _o54.margin;
            V tilt = _o54.leaving_margin;
            V rate_slack = _o54.rate_margin;
            const LANES(hoop_ring_enter_out) _o55 =
                LANES(hoop_ring_enter)(t, K(0.0), high0, high1, high2, low0, low1, low2, t);
            t = _o55.t;
            V end = _o55.end;
            M searching = _o55.searching;
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
                const LANES(hoop_nearby_out) _o56 =
                    LANES(hoop_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = _o56.leaving;
                V margin = _o56.margin;
                const LANES(hoop_ring_advance_out) _o57 =
                    LANES(hoop_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V gap = _o57.gap;
                V rate = _o57.rate;
                V bend = _o57.bend;
                V step = _o57.step;
                V next = _o57.next;
                V clearance = _o57.clearance;
                const LANES(hoop_struck_out) _o58 =
                    LANES(hoop_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o58.hit;
                M sure = _o58.sure;
                M vague = _o58.vague;
                const M _m59 = lanes_both(active, vague);
                if (lanes_any(_m59)) {
                    const LANES(hoop_finer_out) _o60 =
                        LANES(hoop_finer)(share);
                    share = lanes_select(_m59, _o60.share, share);
                    const LANES(hoop_allowance_out) _o61 =
                        LANES(hoop_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
                    V position_level = _o61.position_level;
                    V velocity_level = _o61.velocity_level;
                    const LANES(hoop_ring_margins_out) _o62 =
                        LANES(hoop_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    flat = lanes_select(_m59, _o62.margin, flat);
                    tilt = lanes_select(_m59, _o62.leaving_margin, tilt);
                    rate_slack = lanes_select(_m59, _o62.rate_margin, rate_slack);
                }
                const LANES(hoop_advanced_out) _o63 =
                    LANES(hoop_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o63.arrival;
                certain = _o63.certain;
                M exhausted = _o63.exhausted;
                searching = _o63.searching;
                t = _o63.t;
                const M _m64 = lanes_both(active, exhausted);
                {
                    const LANES(hoop_ring_enter_out) _o65 =
                        LANES(hoop_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m64, _o65.t, t);
                    end = lanes_select(_m64, _o65.end, end);
                    searching = lanes_choose(_m64, _o65.searching, searching);
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
            const LANES(hoop_found_out) _o66 =
                LANES(hoop_found)(arrival);
            M arrives = _o66.arrives;
            M refining = _o66.refining;
            const LANES(hoop_nearby_out) _o67 =
                LANES(hoop_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o67.leaving;
            const M _m68 = lanes_both(rows, refining);
            if (lanes_any(_m68)) {
                const LANES(hoop_ring_refine_out) _o69 =
                    LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V refined = _o69.time;
                V gap = _o69.gap;
                V rate = _o69.rate;
                const LANES(hoop_polished_out) _o70 =
                    LANES(hoop_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m68, _o70.arrival, arrival);
                refining = lanes_choose(_m68, _o70.refining, refining);
            }
            const M _m71 = lanes_both(rows, refining);
            if (lanes_any(_m71)) {
                const LANES(hoop_ring_refine_out) _o72 =
                    LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V refined = _o72.time;
                V gap = _o72.gap;
                V rate = _o72.rate;
                const LANES(hoop_polished_out) _o73 =
                    LANES(hoop_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m71, _o73.arrival, arrival);
                refining = lanes_choose(_m71, _o73.refining, refining);
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
                const LANES(hoop_ring_refine_out) _o74 =
                    LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V refined = _o74.time;
                V gap = _o74.gap;
                V rate = _o74.rate;
                const LANES(hoop_polished_out) _o75 =
                    LANES(hoop_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o75.arrival;
                refining = _o75.refining;
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
            const LANES(hoop_landed_out) _o76 =
                LANES(hoop_landed)(arrival);
            V time = _o76.time;
            const LANES(hoop_sooner_out) _o77 =
                LANES(hoop_sooner)(arrives, K(0.0), time, when, which);
            when = _o77.when;
            which = _o77.which;
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
            V clock = lanes_load(lists->clock + i);
            V contacts = lanes_load(lists->contacts + i);
            M limited = lanes_less(K(0.0), lanes_load(lists->limited + i));
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_restitution = lanes_load(lists->p_restitution + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
            const V p_wire_radius = lanes_load(lists->p_wire_radius + (i & varying));
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
            const M _m78 = lanes_both(rows, limited);
            if (lanes_any(_m78)) {
                const LANES(hoop_expiry_out) _o79 =
                    LANES(hoop_expiry)(clock, K(INFINITY), K(0.0), lanes_wide(time_error), time_limit, when, which);
                V time = _o79.time;
                M arrives = _o79.arrives;
                const LANES(hoop_sooner_out) _o80 =
                    LANES(hoop_sooner)(arrives, K(4.0), time, when, which);
                when = lanes_select(_m78, _o80.when, when);
                which = lanes_select(_m78, _o80.which, which);
            }
            const LANES(hoop_departed_out) _o81 =
                LANES(hoop_departed)(K(3.0), which);
            M moves = _o81.moves;
            M ends = _o81.ends;
            M touches = _o81.touches;
            V reached = _o81.reached;
            const LANES(hoop_body_of_out) _o82 =
                LANES(hoop_body_of)(which);
            V body = _o82.body;
            const M _m83 = lanes_both(rows, moves);
            {
                const LANES(hoop_flight_out) _o84 =
                    LANES(hoop_flight)(when, x, y, z, vx, vy, vz, p_gravity);
                x = lanes_select(_m83, _o84.x, x);
                y = lanes_select(_m83, _o84.y, y);
                z = lanes_select(_m83, _o84.z, z);
                vx = lanes_select(_m83, _o84.vx, vx);
                vy = lanes_select(_m83, _o84.vy, vy);
                vz = lanes_select(_m83, _o84.vz, vz);
                const LANES(hoop_ticked_out) _o85 =
                    LANES(hoop_ticked)(clock, when);
                clock = lanes_select(_m83, _o85.clock, clock);
            }
            const M _m86 = lanes_both(rows, limited);
            if (lanes_any(_m86)) {
                const LANES(hoop_expired_out) _o87 =
                    LANES(hoop_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m86, _o87.clock, clock);
                body = lanes_select(_m86, _o87.body, body);
                reached = lanes_select(_m86, _o87.reached, reached);
                ends = lanes_choose(_m86, _o87.ends, ends);
            }
            const LANES(hoop_here_out) _o88 =
                LANES(hoop_here)(K(3.0), which);
            M here = _o88.here;
            const M _m89 = lanes_both(rows, here);
            {
                const LANES(hoop_end_bounds_out) _o90 =
                    LANES(hoop_end_bounds)(x, y, p_ring_radius);
                V g0 = _o90.g0;
                const LANES(hoop_end_reached_out) _o91 =
                    LANES(hoop_end_reached)(g0);
                reached = lanes_select(_m89, _o91.reached, reached);
            }
            const LANES(hoop_accounted_out) _o92 =
                LANES(hoop_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o92.contacts;
            V outcome = _o92.outcome;
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
            const LANES(hoop_meeting_out) _o93 =
                LANES(hoop_meeting)(K(0.0), ends, touches);
            M meeting = _o93.meeting;
            const M _m94 = lanes_both(rows, meeting);
            if (lanes_any(_m94)) {
                V count_0 = lanes_load(lists->count_0 + i);
                V count_1 = lanes_load(lists->count_1 + i);
                V count_2 = lanes_load(lists->count_2 + i);
                V first = lanes_load(lists->first + i);
                V last = lanes_load(lists->last + i);
                const LANES(hoop_end_normal_out) _o95 =
                    LANES(hoop_end_normal)();
                V nx = _o95.nx;
                V ny = _o95.ny;
                V nz = _o95.nz;
                const LANES(hoop_here_out) _o96 =
                    LANES(hoop_here)(K(0.0), which);
                M here = _o96.here;
                const M _m97 = lanes_both(_m94, here);
                {
                    const LANES(hoop_ring_normal_out) _o98 =
                        LANES(hoop_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m97, _o98.nx, nx);
                    ny = lanes_select(_m97, _o98.ny, ny);
                    nz = lanes_select(_m97, _o98.nz, nz);
                    const LANES(hoop_counted_out) _o99 =
                        LANES(hoop_counted)(count_0);
                    count_0 = lanes_select(_m97, _o99.count, count_0);
                }
                const LANES(hoop_here_out) _o100 =
                    LANES(hoop_here)(K(1.0), which);
                here = _o100.here;
                const M _m101 = lanes_both(_m94, here);
                {
                    const LANES(hoop_backboard_normal_out) _o102 =
                        LANES(hoop_backboard_normal)();
                    nx = lanes_select(_m101, _o102.nx, nx);
                    ny = lanes_select(_m101, _o102.ny, ny);
                    nz = lanes_select(_m101, _o102.nz, nz);
                    const LANES(hoop_counted_out) _o103 =
                        LANES(hoop_counted)(count_1);
                    count_1 = lanes_select(_m101, _o103.count, count_1);
                }
                const LANES(hoop_here_out) _o104 =
                    LANES(hoop_here)(K(2.0), which);
                here = _o104.here;
                const M _m105 = lanes_both(_m94, here);
                {
                    const LANES(hoop_bridge_normal_out) _o106 =
                        LANES(hoop_bridge_normal)();
                    nx = lanes_select(_m105, _o106.nx, nx);
                    ny = lanes_select(_m105, _o106.ny, ny);
                    nz = lanes_select(_m105, _o106.nz, nz);
                    const LANES(hoop_counted_out) _o107 =
                        LANES(hoop_counted)(count_2);
                    count_2 = lanes_select(_m105, _o107.count, count_2);
                }
                const M _m108 = lanes_both(_m94, touches);
                if (lanes_any(_m108)) {
                    const LANES(hoop_impact_out) _o109 =
                        LANES(hoop_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, p_restitution);
                    vx = lanes_select(_m108, _o109.vx, vx);
                    vy = lanes_select(_m108, _o109.vy, vy);
                    vz = lanes_select(_m108, _o109.vz, vz);
                    wx = lanes_select(_m108, _o109.wx, wx);
                    wy = lanes_select(_m108, _o109.wy, wy);
                    wz = lanes_select(_m108, _o109.wz, wz);
                }
                const LANES(hoop_here_out) _o110 =
                    LANES(hoop_here)(K(1.0), which);
                here = _o110.here;
                const M _m111 = lanes_both(_m94, here);
                {
                    const LANES(hoop_backboard_place_out) _o112 =
                        LANES(hoop_backboard_place)(y, z, p_ball_radius, p_board_distance);
                    x = lanes_select(_m111, _o112.x, x);
                    y = lanes_select(_m111, _o112.y, y);
                    z = lanes_select(_m111, _o112.z, z);
                }
                const LANES(hoop_here_out) _o113 =
                    LANES(hoop_here)(K(2.0), which);
                here = _o113.here;
                const M _m114 = lanes_both(_m94, here);
                {
                    const LANES(hoop_bridge_place_out) _o115 =
                        LANES(hoop_bridge_place)(x, y, p_ball_radius, p_wire_radius);
                    x = lanes_select(_m114, _o115.x, x);
                    y = lanes_select(_m114, _o115.y, y);
                    z = lanes_select(_m114, _o115.z, z);
                }
                const M _m116 = lanes_both(_m94, touches);
                {
                    const LANES(hoop_touched_out) _o117 =
                        LANES(hoop_touched)(body, first, which);
                    first = lanes_select(_m116, _o117.first, first);
                    last = lanes_select(_m116, _o117.last, last);
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
    _Alignas(64) size_t shot[LANES_SHOTS];
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
} LANES(hoop_bounded_lists);

/* Put the next shots into rows, from one on. */
LANES_INLINE void LANES(hoop_bounded_begin)(LANES(hoop_bounded_lists) *lists, size_t row, size_t shots, const hoop_job *job, size_t start)
{
    const double *state = job->states + HOOP_STATE * start;
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

/* Run the job: fill the rows, take every shot to its next event, make room of those that ended.
   Errors are bounded. */
static void LANES(hoop_bounded)(const hoop_job *job)
{
    LANES(hoop_bounded_lists) all, *const lists = &all;
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
    const M all_permitted = LANES(hoop_permit)(lanes_load(lists->p_ball_radius), lanes_load(lists->p_ring_radius), lanes_load(lists->p_wire_radius), lanes_load(lists->p_board_distance), lanes_load(lists->p_board_half_width), lanes_load(lists->p_board_bottom), lanes_load(lists->p_board_top), lanes_load(lists->p_bridge_half_width), lanes_load(lists->p_restitution), lanes_load(lists->p_gravity), lanes_load(lists->p_end_depth));
    for (;;) {
        if (job->stop && *job->stop)
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
            V last = lanes_load(lists->last + i);
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_bottom = lanes_load(lists->p_board_bottom + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_board_half_width = lanes_load(lists->p_board_half_width + (i & varying));
            const V p_board_top = lanes_load(lists->p_board_top + (i & varying));
            const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + (i & varying));
            const V p_end_depth = lanes_load(lists->p_end_depth + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_restitution = lanes_load(lists->p_restitution + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
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
                permitted = LANES(hoop_permit)(p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_restitution, p_gravity, p_end_depth);
            const LANES(hoop_finite_state_out) _o1 =
                LANES(hoop_finite_state)(vx, vy, vz, wx, wy, wz, x, y, z);
            M finite = _o1.finite;
            const LANES(hoop_valid_out) _o2 =
                LANES(hoop_valid)(last, x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_end_depth);
            V valid = _o2.valid;
            V doubt = _o2.doubt;
            const LANES(hoop_admitted_out) _o3 =
                LANES(hoop_admitted)(doubt, finite, permitted, valid);
            V outcome = _o3.outcome;
            V uncertain = _o3.uncertain;
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
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_bottom = lanes_load(lists->p_board_bottom + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_board_half_width = lanes_load(lists->p_board_half_width + (i & varying));
            const V p_board_top = lanes_load(lists->p_board_top + (i & varying));
            const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + (i & varying));
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
            const LANES(hoop_error_bounds_out) _o4 =
                LANES(hoop_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            S position_error = _o4.position_error;
            S velocity_error = _o4.velocity_error;
            S time_error = _o4.time_error;
            const LANES(hoop_scale_out) _o5 =
                LANES(hoop_scale)(x, y, z, vx, vy, vz, p_gravity);
            V extent = _o5.extent;
            V speed = _o5.speed;
            V excess = _o5.excess;
            const LANES(hoop_opening_out) _o6 =
                LANES(hoop_opening)(excess, lanes_wide(position_error), lanes_wide(velocity_error));
            V when = _o6.when;
            V which = _o6.which;
            V late = _o6.late;
            V doubt = _o6.doubt;
            const LANES(hoop_limited_out) _o7 =
                LANES(hoop_limited)(time_limit);
            M limited = _o7.limited;
            const LANES(hoop_left_out) _o8 =
                LANES(hoop_left)(K(3.0), last);
            V leaving = _o8.leaving;
            const LANES(hoop_end_arrival_out) _o9 =
                LANES(hoop_end_arrival)(leaving, z, vz, p_gravity, p_end_depth);
            V time = _o9.time;
            V rate = _o9.rate;
            V bend = _o9.bend;
            V apex = _o9.apex;
            V height = _o9.height;
            const LANES(hoop_meeting_plane_out) _o10 =
                LANES(hoop_meeting_plane)(apex, bend, rate, time);
            M arrives = _o10.arrives;
            V ceiling = _o10.ceiling;
            V nearest = _o10.nearest;
            const LANES(hoop_end_margin_out) _o11 =
                LANES(hoop_end_margin)(nearest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), p_gravity, p_end_depth);
            V margin = _o11.margin;
            const LANES(hoop_crossing_out) _o12 =
                LANES(hoop_crossing)(margin, K(0.0), rate, ceiling);
            V clearance = _o12.clearance;
            V delay = _o12.delay;
            const LANES(hoop_timely_out) _o13 =
                LANES(hoop_timely)(arrives, delay, late, time, when);
            M possible = _o13.possible;
            const LANES(hoop_grazed_out) _o14 =
                LANES(hoop_grazed)(apex, doubt, height, margin);
            doubt = _o14.doubt;
            const M _m15 = lanes_both(rows, possible);
            {
                const LANES(hoop_crossed_out) _o16 =
                    LANES(hoop_crossed)(arrives, clearance, doubt, time);
                doubt = lanes_select(_m15, _o16.doubt, doubt);
                const LANES(hoop_tied_out) _o17 =
                    LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
                doubt = lanes_select(_m15, _o17.doubt, doubt);
                late = lanes_select(_m15, _o17.late, late);
                const LANES(hoop_sooner_out) _o18 =
                    LANES(hoop_sooner)(arrives, K(3.0), time, when, which);
                when = lanes_select(_m15, _o18.when, when);
                which = lanes_select(_m15, _o18.which, which);
            }
            const LANES(hoop_released_out) _o19 =
                LANES(hoop_released)(last);
            M released = _o19.released;
            M reachable = _o19.reachable;
            const M _m20 = lanes_both(rows, released);
            if (lanes_any(_m20)) {
                const LANES(hoop_horizon_out) _o21 =
                    LANES(hoop_horizon)(when, speed, p_gravity);
                V until = _o21.horizon;
                V pad = _o21.pad;
                const LANES(hoop_reachable_out) _o22 =
                    LANES(hoop_reachable)(p_ball_radius, p_board_distance, p_bridge_half_width, extent, p_gravity, until, late, pad, lanes_wide(position_error), p_ring_radius, speed, lanes_wide(velocity_error), vx, x);
                reachable = lanes_choose(_m20, _o22.reachable, reachable);
            }
            const M _m23 = lanes_both(rows, reachable);
            if (lanes_any(_m23)) {
                const LANES(hoop_left_out) _o24 =
                    LANES(hoop_left)(K(1.0), last);
                V leaving = _o24.leaving;
                const LANES(hoop_backboard_arrival_out) _o25 =
                    LANES(hoop_backboard_arrival)(leaving, x, vx, p_ball_radius, p_board_distance);
                V time = _o25.time;
                V rate = _o25.rate;
                V bend = _o25.bend;
                V apex = _o25.apex;
                V height = _o25.height;
                const LANES(hoop_meeting_plane_out) _o26 =
                    LANES(hoop_meeting_plane)(apex, bend, rate, time);
                M arrives = _o26.arrives;
                V ceiling = _o26.ceiling;
                V nearest = _o26.nearest;
                const LANES(hoop_backboard_margin_out) _o27 =
                    LANES(hoop_backboard_margin)(nearest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), p_ball_radius, p_board_distance, p_gravity);
                V margin = _o27.margin;
                const LANES(hoop_crossing_out) _o28 =
                    LANES(hoop_crossing)(margin, K(0.0), rate, ceiling);
                V clearance = _o28.clearance;
                V delay = _o28.delay;
                const LANES(hoop_timely_out) _o29 =
                    LANES(hoop_timely)(arrives, delay, late, time, when);
                M possible = _o29.possible;
                const LANES(hoop_grazed_out) _o30 =
                    LANES(hoop_grazed)(apex, doubt, height, margin);
                doubt = lanes_select(_m23, _o30.doubt, doubt);
                const M _m31 = lanes_both(_m23, possible);
                if (lanes_any(_m31)) {
                    const LANES(hoop_flight_out) _o32 =
                        LANES(hoop_flight)(time, x, y, z, vx, vy, vz, p_gravity);
                    V there_y = _o32.y;
                    V there_z = _o32.z;
                    const LANES(hoop_backboard_bounds_out) _o33 =
                        LANES(hoop_backboard_bounds)(there_y, there_z, p_board_half_width, p_board_bottom, p_board_top);
                    V g0 = _o33.g0;
                    V g1 = _o33.g1;
                    V g2 = _o33.g2;
                    V g3 = _o33.g3;
                    const LANES(hoop_displacement_out) _o34 =
                        LANES(hoop_displacement)(delay, time, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_gravity, p_end_depth);
                    V slack = _o34.margin;
                    const LANES(hoop_backboard_edges_out) _o35 =
                        LANES(hoop_backboard_edges)(clearance, g0, g1, g2, g3, slack);
                    M unsure = _o35.unsure;
                    const LANES(hoop_questioned_out) _o36 =
                        LANES(hoop_questioned)(doubt, time, unsure);
                    doubt = lanes_select(_m31, _o36.doubt, doubt);
                    const LANES(hoop_backboard_within_out) _o37 =
                        LANES(hoop_backboard_within)(g0, g1, g2, g3);
                    M arrives = _o37.arrives;
                    const LANES(hoop_tied_out) _o38 =
                        LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
                    doubt = lanes_select(_m31, _o38.doubt, doubt);
                    late = lanes_select(_m31, _o38.late, late);
                    const LANES(hoop_sooner_out) _o39 =
                        LANES(hoop_sooner)(arrives, K(1.0), time, when, which);
                    when = lanes_select(_m31, _o39.when, when);
                    which = lanes_select(_m31, _o39.which, which);
                }
                const LANES(hoop_left_out) _o40 =
                    LANES(hoop_left)(K(2.0), last);
                leaving = _o40.leaving;
                const LANES(hoop_bridge_arrival_out) _o41 =
                    LANES(hoop_bridge_arrival)(leaving, z, vz, p_ball_radius, p_wire_radius, p_gravity);
                time = _o41.time;
                rate = _o41.rate;
                bend = _o41.bend;
                apex = _o41.apex;
                height = _o41.height;
                const LANES(hoop_meeting_plane_out) _o42 =
                    LANES(hoop_meeting_plane)(apex, bend, rate, time);
                arrives = _o42.arrives;
                ceiling = _o42.ceiling;
                nearest = _o42.nearest;
                const LANES(hoop_bridge_margin_out) _o43 =
                    LANES(hoop_bridge_margin)(nearest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), p_ball_radius, p_wire_radius, p_gravity);
                margin = _o43.margin;
                const LANES(hoop_crossing_out) _o44 =
                    LANES(hoop_crossing)(margin, K(0.0), rate, ceiling);
                clearance = _o44.clearance;
                delay = _o44.delay;
                const LANES(hoop_timely_out) _o45 =
                    LANES(hoop_timely)(arrives, delay, late, time, when);
                possible = _o45.possible;
                const LANES(hoop_grazed_out) _o46 =
                    LANES(hoop_grazed)(apex, doubt, height, margin);
                doubt = lanes_select(_m23, _o46.doubt, doubt);
                const M _m47 = lanes_both(_m23, possible);
                if (lanes_any(_m47)) {
                    const LANES(hoop_flight_out) _o48 =
                        LANES(hoop_flight)(time, x, y, z, vx, vy, vz, p_gravity);
                    V there_x = _o48.x;
                    V there_y = _o48.y;
                    const LANES(hoop_bridge_bounds_out) _o49 =
                        LANES(hoop_bridge_bounds)(there_x, there_y, p_ring_radius, p_board_distance, p_bridge_half_width);
                    V g0 = _o49.g0;
                    V g1 = _o49.g1;
                    V g2 = _o49.g2;
                    V g3 = _o49.g3;
                    V g4 = _o49.g4;
                    const LANES(hoop_displacement_out) _o50 =
                        LANES(hoop_displacement)(delay, time, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_gravity, p_end_depth);
                    V slack = _o50.margin;
                    const LANES(hoop_bridge_edges_out) _o51 =
                        LANES(hoop_bridge_edges)(clearance, g0, g1, g2, g3, g4, slack);
                    M unsure = _o51.unsure;
                    const LANES(hoop_questioned_out) _o52 =
                        LANES(hoop_questioned)(doubt, time, unsure);
                    doubt = lanes_select(_m47, _o52.doubt, doubt);
                    const LANES(hoop_bridge_within_out) _o53 =
                        LANES(hoop_bridge_within)(g0, g1, g2, g3, g4);
                    M arrives = _o53.arrives;
                    const LANES(hoop_tied_out) _o54 =
                        LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
                    doubt = lanes_select(_m47, _o54.doubt, doubt);
                    late = lanes_select(_m47, _o54.late, late);
                    const LANES(hoop_sooner_out) _o55 =
                        LANES(hoop_sooner)(arrives, K(2.0), time, when, which);
                    when = lanes_select(_m47, _o55.when, when);
                    which = lanes_select(_m47, _o55.which, which);
                }
            }
            const LANES(hoop_horizon_out) _o56 =
                LANES(hoop_horizon)(when, speed, p_gravity);
            V until = _o56.horizon;
            V pad = _o56.pad;
            const LANES(hoop_ring_clear_out) _o57 =
                LANES(hoop_ring_clear)(until, x, y, z, vx, vy, vz, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V clear = _o57.clear;
            const LANES(hoop_opens_out) _o58 =
                LANES(hoop_opens)(clear);
            M open = _o58.open;
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
                if (varying)
                    lanes_pack(lists->open_p_ball_radius + open_shots, packed, p_ball_radius);
                if (varying)
                    lanes_pack(lists->open_p_gravity + open_shots, packed, p_gravity);
                if (varying)
                    lanes_pack(lists->open_p_ring_radius + open_shots, packed, p_ring_radius);
                if (varying)
                    lanes_pack(lists->open_p_wire_radius + open_shots, packed, p_wire_radius);
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
            const LANES(hoop_beginning_out) _o59 =
                LANES(hoop_beginning)();
            V share = _o59.share;
            V arrival = _o59.arrival;
            M certain = _o59.certain;
            const LANES(hoop_left_out) _o60 =
                LANES(hoop_left)(K(0.0), last);
            V leaving = _o60.leaving;
            const LANES(hoop_ring_opened_out) _o61 =
                LANES(hoop_ring_opened)(lanes_narrow(until), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
            S onset = _o61.t;
            S wide_end = _o61.end;
            M searching = _o61.searching;
            S wide_low1 = _o61.low1;
            S wide_high1 = _o61.high1;
            S wide_low2 = _o61.low2;
            S wide_high2 = _o61.high2;
            S lapsed = _o61.latest;
            M sound = _o61.sound;
            const LANES(hoop_opened_out) _o62 =
                LANES(hoop_opened)(lanes_wide(lapsed), lanes_wide(onset));
            V since = _o62.time;
            V latest = _o62.latest;
            const LANES(hoop_ring_started_out) _o63 =
                LANES(hoop_ring_started)(x, y, z, vx, vy, vz, p_ring_radius);
            V rho_start = _o63.rho_start;
            V parting = _o63.parting;
            V drift = _o63.drift;
            const LANES(hoop_flight_out) _o64 =
                LANES(hoop_flight)(since, x, y, z, vx, vy, vz, p_gravity);
            V near_x = _o64.x;
            V near_y = _o64.y;
            V near_z = _o64.z;
            V near_vz = _o64.vz;
            const LANES(hoop_ring_grain_out) _o65 =
                LANES(hoop_ring_grain)(onset, wide_end, lanes_narrow(leaving), lapsed, lanes_narrow(near_x), lanes_narrow(near_y), lanes_narrow(near_z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(near_vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(parting), lanes_narrow(drift), wide_low1, wide_high1, wide_low2, wide_high2, lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
            S short_share = _o65.share;
            S short_t = _o65.t;
            S short_end = _o65.end;
            S short_x = _o65.x;
            S short_y = _o65.y;
            S short_z = _o65.z;
            S short_vx = _o65.vx;
            S short_vy = _o65.vy;
            S short_vz = _o65.vz;
            S short_steady = _o65.steady;
            S short_swing = _o65.swing;
            S short_rho_start = _o65.rho_start;
            S short_ceiling = _o65.ceiling;
            S short_flat = _o65.flat;
            S short_tilt = _o65.tilt;
            S short_jerk = _o65.jerk;
            S short_grit = _o65.grit;
            S short_parting = _o65.parting;
            S short_drift = _o65.drift;
            S short_rate_margin = _o65.rate_margin;
            S short_low1 = _o65.low1;
            S short_high1 = _o65.high1;
            S short_low2 = _o65.low2;
            S short_high2 = _o65.high2;
            M fits = _o65.fits;
            const LANES(hoop_coarse_out) _o66 =
                LANES(hoop_coarse)(lanes_wide(short_ceiling), fits, lanes_wide(short_flat), lanes_wide(short_rate_margin), searching, lanes_wide(short_share), sound);
            M leaping = _o66.leaping;
            searching = _o66.searching;
            M served = _o66.served;
            V ceiling = _o66.ceiling;
            V flat = _o66.flat;
            V tilt = _o66.tilt;
            V allowing = _o66.allowing;
            const LANES(hoop_allowance_out) _o67 =
                LANES(hoop_allowance)(allowing, latest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), p_gravity);
            V excess = _o67.excess;
            const LANES(hoop_ring_lost_out) _o68 =
                LANES(hoop_ring_lost)(until, lanes_wide(position_error), lanes_wide(velocity_error), p_ball_radius, p_ring_radius, p_wire_radius);
            V lost = _o68.lost;
            const LANES(hoop_beyond_out) _o69 =
                LANES(hoop_beyond)(doubt, excess, late, lost, pad);
            doubt = _o69.doubt;
            const M _m70 = lanes_both(rows, leaping);
            if (lanes_any(_m70)) {
                const LANES(hoop_ring_leap_out) _o71 =
                    LANES(hoop_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
                short_t = singles_select(singles_of(_m70), _o71.t, short_t);
                short_end = singles_select(singles_of(_m70), _o71.end, short_end);
                certain = lanes_choose(_m70, _o71.certain, certain);
                leaping = lanes_choose(_m70, _o71.leaping, leaping);
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
                const LANES(hoop_ring_leap_out) _o72 =
                    LANES(hoop_ring_leap)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_steady, short_swing, short_rho_start, short_flat, short_tilt, short_grit, short_jerk, short_parting, short_drift, short_low1, short_high1, short_low2, short_high2, lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius), lanes_narrow(p_gravity));
                short_t = _o72.t;
                short_end = _o72.end;
                M certain = _o72.certain;
                leaping = _o72.leaping;
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
            const LANES(hoop_leapt_out) _o73 =
                LANES(hoop_leapt)(arrival, certain, lanes_wide(short_t), searching, served, since);
            arrival = _o73.arrival;
            V t = _o73.t;
            searching = _o73.searching;
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
            const LANES(hoop_ring_prepare_out) _o74 =
                LANES(hoop_ring_prepare)(until, x, y, z, vx, vy, vz, lanes_wide(position_error), lanes_wide(velocity_error), p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V steady = _o74.steady;
            V swing = _o74.swing;
            V rho_start = _o74.rho_start;
            V low0 = _o74.low0;
            V high0 = _o74.high0;
            V low1 = _o74.low1;
            V high1 = _o74.high1;
            V low2 = _o74.low2;
            V high2 = _o74.high2;
            V ceiling = _o74.ceiling;
            V latest = _o74.latest;
            const LANES(hoop_allowance_out) _o75 =
                LANES(hoop_allowance)(share, latest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), p_gravity);
            V position_level = _o75.position_level;
            V velocity_level = _o75.velocity_level;
            const LANES(hoop_ring_margins_out) _o76 =
                LANES(hoop_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V flat = _o76.margin;
            V tilt = _o76.leaving_margin;
            V rate_slack = _o76.rate_margin;
            const LANES(hoop_ring_enter_out) _o77 =
                LANES(hoop_ring_enter)(t, K(0.0), high0, high1, high2, low0, low1, low2, t);
            t = _o77.t;
            V end = _o77.end;
            M searching = _o77.searching;
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
                const LANES(hoop_nearby_out) _o78 =
                    LANES(hoop_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = _o78.leaving;
                V margin = _o78.margin;
                const LANES(hoop_ring_advance_out) _o79 =
                    LANES(hoop_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V gap = _o79.gap;
                V rate = _o79.rate;
                V bend = _o79.bend;
                V step = _o79.step;
                V next = _o79.next;
                V clearance = _o79.clearance;
                const LANES(hoop_struck_out) _o80 =
                    LANES(hoop_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o80.hit;
                M sure = _o80.sure;
                M vague = _o80.vague;
                const M _m81 = lanes_both(active, vague);
                if (lanes_any(_m81)) {
                    const LANES(hoop_finer_out) _o82 =
                        LANES(hoop_finer)(share);
                    share = lanes_select(_m81, _o82.share, share);
                    const LANES(hoop_allowance_out) _o83 =
                        LANES(hoop_allowance)(share, latest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), p_gravity);
                    V position_level = _o83.position_level;
                    V velocity_level = _o83.velocity_level;
                    V excess = _o83.excess;
                    const LANES(hoop_ring_margins_out) _o84 =
                        LANES(hoop_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    flat = lanes_select(_m81, _o84.margin, flat);
                    tilt = lanes_select(_m81, _o84.leaving_margin, tilt);
                    rate_slack = lanes_select(_m81, _o84.rate_margin, rate_slack);
                    const LANES(hoop_exceeded_out) _o85 =
                        LANES(hoop_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m81, _o85.doubt, doubt);
                }
                const LANES(hoop_advanced_out) _o86 =
                    LANES(hoop_advanced)(arrival, certain, end, hit, next, step, sure, t, vague);
                arrival = _o86.arrival;
                certain = _o86.certain;
                M exhausted = _o86.exhausted;
                searching = _o86.searching;
                t = _o86.t;
                const M _m87 = lanes_both(active, exhausted);
                {
                    const LANES(hoop_ring_enter_out) _o88 =
                        LANES(hoop_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m87, _o88.t, t);
                    end = lanes_select(_m87, _o88.end, end);
                    searching = lanes_choose(_m87, _o88.searching, searching);
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
            const LANES(hoop_questioned_out) _o89 =
                LANES(hoop_questioned)(doubt, t, searching);
            doubt = _o89.doubt;
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
            const LANES(hoop_found_out) _o90 =
                LANES(hoop_found)(arrival);
            M arrives = _o90.arrives;
            M refining = _o90.refining;
            V rate = _o90.rate;
            const LANES(hoop_nearby_out) _o91 =
                LANES(hoop_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o91.leaving;
            const M _m92 = lanes_both(rows, refining);
            if (lanes_any(_m92)) {
                const LANES(hoop_ring_refine_out) _o93 =
                    LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V refined = _o93.time;
                V gap = _o93.gap;
                rate = lanes_select(_m92, _o93.rate, rate);
                const LANES(hoop_polished_out) _o94 =
                    LANES(hoop_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m92, _o94.arrival, arrival);
                refining = lanes_choose(_m92, _o94.refining, refining);
            }
            const M _m95 = lanes_both(rows, refining);
            if (lanes_any(_m95)) {
                const LANES(hoop_ring_refine_out) _o96 =
                    LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V refined = _o96.time;
                V gap = _o96.gap;
                rate = lanes_select(_m95, _o96.rate, rate);
                const LANES(hoop_polished_out) _o97 =
                    LANES(hoop_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = lanes_select(_m95, _o97.arrival, arrival);
                refining = lanes_choose(_m95, _o97.refining, refining);
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
                const LANES(hoop_ring_refine_out) _o98 =
                    LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V refined = _o98.time;
                V gap = _o98.gap;
                V rate = _o98.rate;
                const LANES(hoop_polished_out) _o99 =
                    LANES(hoop_polished)(arrival, ceiling, certain, gap, rate, refined);
                arrival = _o99.arrival;
                refining = _o99.refining;
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
            S position_error = singles_load(lists->open_position_error + i);
            V rate = lanes_load(lists->open_rate + i);
            V speed = lanes_load(lists->open_speed + i);
            S velocity_error = singles_load(lists->open_velocity_error + i);
            V when = lanes_load(lists->open_when + i);
            V which = lanes_load(lists->open_which + i);
            const LANES(hoop_ring_margins_out) _o100 =
                LANES(hoop_ring_margins)(latest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V flat = _o100.margin;
            V tilt = _o100.leaving_margin;
            V rate_margin = _o100.rate_margin;
            const LANES(hoop_own_margin_out) _o101 =
                LANES(hoop_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o101.margin;
            const LANES(hoop_crossing_out) _o102 =
                LANES(hoop_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o102.clearance;
            V delay = _o102.delay;
            const LANES(hoop_landed_out) _o103 =
                LANES(hoop_landed)(arrival);
            V time = _o103.time;
            const LANES(hoop_landed_surely_out) _o104 =
                LANES(hoop_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o104.delay;
            doubt = _o104.doubt;
            const LANES(hoop_tied_out) _o105 =
                LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o105.doubt;
            late = _o105.late;
            const LANES(hoop_sooner_out) _o106 =
                LANES(hoop_sooner)(arrives, K(0.0), time, when, which);
            when = _o106.when;
            which = _o106.which;
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
            const V p_ball_radius = lanes_load(lists->p_ball_radius + (i & varying));
            const V p_board_bottom = lanes_load(lists->p_board_bottom + (i & varying));
            const V p_board_distance = lanes_load(lists->p_board_distance + (i & varying));
            const V p_board_half_width = lanes_load(lists->p_board_half_width + (i & varying));
            const V p_board_top = lanes_load(lists->p_board_top + (i & varying));
            const V p_bridge_half_width = lanes_load(lists->p_bridge_half_width + (i & varying));
            const V p_end_depth = lanes_load(lists->p_end_depth + (i & varying));
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_restitution = lanes_load(lists->p_restitution + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
            const V p_wire_radius = lanes_load(lists->p_wire_radius + (i & varying));
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
            const M _m107 = lanes_both(rows, limited);
            if (lanes_any(_m107)) {
                const LANES(hoop_expiry_out) _o108 =
                    LANES(hoop_expiry)(clock, doubt, late, lanes_wide(time_error), time_limit, when, which);
                V time = _o108.time;
                V delay = _o108.delay;
                M arrives = _o108.arrives;
                doubt = lanes_select(_m107, _o108.doubt, doubt);
                const LANES(hoop_tied_out) _o109 =
                    LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
                doubt = lanes_select(_m107, _o109.doubt, doubt);
                late = lanes_select(_m107, _o109.late, late);
                const LANES(hoop_sooner_out) _o110 =
                    LANES(hoop_sooner)(arrives, K(4.0), time, when, which);
                when = lanes_select(_m107, _o110.when, when);
                which = lanes_select(_m107, _o110.which, which);
            }
            const LANES(hoop_departed_out) _o111 =
                LANES(hoop_departed)(K(3.0), which);
            M moves = _o111.moves;
            M ends = _o111.ends;
            M touches = _o111.touches;
            V reached = _o111.reached;
            M edge = _o111.edge;
            const LANES(hoop_body_of_out) _o112 =
                LANES(hoop_body_of)(which);
            V body = _o112.body;
            const M _m113 = lanes_both(rows, moves);
            {
                const LANES(hoop_flight_out) _o114 =
                    LANES(hoop_flight)(when, x, y, z, vx, vy, vz, p_gravity);
                x = lanes_select(_m113, _o114.x, x);
                y = lanes_select(_m113, _o114.y, y);
                z = lanes_select(_m113, _o114.z, z);
                vx = lanes_select(_m113, _o114.vx, vx);
                vy = lanes_select(_m113, _o114.vy, vy);
                vz = lanes_select(_m113, _o114.vz, vz);
                const LANES(hoop_ticked_out) _o115 =
                    LANES(hoop_ticked)(clock, when);
                clock = lanes_select(_m113, _o115.clock, clock);
            }
            const M _m116 = lanes_both(rows, limited);
            if (lanes_any(_m116)) {
                const LANES(hoop_expired_out) _o117 =
                    LANES(hoop_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m116, _o117.clock, clock);
                body = lanes_select(_m116, _o117.body, body);
                reached = lanes_select(_m116, _o117.reached, reached);
                ends = lanes_choose(_m116, _o117.ends, ends);
            }
            const LANES(hoop_displacement_out) _o118 =
                LANES(hoop_displacement)(late, when, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_gravity, p_end_depth);
            V slack = _o118.margin;
            const LANES(hoop_here_out) _o119 =
                LANES(hoop_here)(K(3.0), which);
            M here = _o119.here;
            const M _m120 = lanes_both(rows, here);
            {
                const LANES(hoop_end_bounds_out) _o121 =
                    LANES(hoop_end_bounds)(x, y, p_ring_radius);
                V g0 = _o121.g0;
                const LANES(hoop_end_reached_out) _o122 =
                    LANES(hoop_end_reached)(g0);
                reached = lanes_select(_m120, _o122.reached, reached);
                const LANES(hoop_end_edge_out) _o123 =
                    LANES(hoop_end_edge)(g0, slack);
                edge = lanes_choose(_m120, _o123.edge, edge);
            }
            const LANES(hoop_doubted_out) _o124 =
                LANES(hoop_doubted)(doubt, edge, late, uncertain, when);
            uncertain = _o124.uncertain;
            const LANES(hoop_accounted_out) _o125 =
                LANES(hoop_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o125.contacts;
            V outcome = _o125.outcome;
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
            const LANES(hoop_meeting_out) _o126 =
                LANES(hoop_meeting)(claims, ends, touches);
            M meeting = _o126.meeting;
            const M _m127 = lanes_both(rows, meeting);
            if (lanes_any(_m127)) {
                V count_0 = lanes_load(lists->count_0 + i);
                V count_1 = lanes_load(lists->count_1 + i);
                V count_2 = lanes_load(lists->count_2 + i);
                V first = lanes_load(lists->first + i);
                V last = lanes_load(lists->last + i);
                const LANES(hoop_end_normal_out) _o128 =
                    LANES(hoop_end_normal)();
                V nx = _o128.nx;
                V ny = _o128.ny;
                V nz = _o128.nz;
                const LANES(hoop_here_out) _o129 =
                    LANES(hoop_here)(K(0.0), which);
                M here = _o129.here;
                const M _m130 = lanes_both(_m127, here);
                {
                    const LANES(hoop_ring_normal_out) _o131 =
                        LANES(hoop_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m130, _o131.nx, nx);
                    ny = lanes_select(_m130, _o131.ny, ny);
                    nz = lanes_select(_m130, _o131.nz, nz);
                    const LANES(hoop_counted_out) _o132 =
                        LANES(hoop_counted)(count_0);
                    count_0 = lanes_select(_m130, _o132.count, count_0);
                }
                const LANES(hoop_here_out) _o133 =
                    LANES(hoop_here)(K(1.0), which);
                here = _o133.here;
                const M _m134 = lanes_both(_m127, here);
                {
                    const LANES(hoop_backboard_normal_out) _o135 =
                        LANES(hoop_backboard_normal)();
                    nx = lanes_select(_m134, _o135.nx, nx);
                    ny = lanes_select(_m134, _o135.ny, ny);
                    nz = lanes_select(_m134, _o135.nz, nz);
                    const LANES(hoop_counted_out) _o136 =
                        LANES(hoop_counted)(count_1);
                    count_1 = lanes_select(_m134, _o136.count, count_1);
                }
                const LANES(hoop_here_out) _o137 =
                    LANES(hoop_here)(K(2.0), which);
                here = _o137.here;
                const M _m138 = lanes_both(_m127, here);
                {
                    const LANES(hoop_bridge_normal_out) _o139 =
                        LANES(hoop_bridge_normal)();
                    nx = lanes_select(_m138, _o139.nx, nx);
                    ny = lanes_select(_m138, _o139.ny, ny);
                    nz = lanes_select(_m138, _o139.nz, nz);
                    const LANES(hoop_counted_out) _o140 =
                        LANES(hoop_counted)(count_2);
                    count_2 = lanes_select(_m138, _o140.count, count_2);
                }
                const LANES(hoop_elsewhere_out) _o141 =
                    LANES(hoop_elsewhere)();
                V curving = _o141.curving;
                const LANES(hoop_again_out) _o142 =
                    LANES(hoop_again)(K(0.0), last, which);
                M again = _o142.again;
                const M _m143 = lanes_both(_m127, again);
                {
                    const LANES(hoop_ring_curvature_out) _o144 =
                        LANES(hoop_ring_curvature)(p_ball_radius, p_ring_radius, p_wire_radius);
                    curving = lanes_select(_m143, _o144.curvature, curving);
                }
                const LANES(hoop_again_out) _o145 =
                    LANES(hoop_again)(K(1.0), last, which);
                again = _o145.again;
                const M _m146 = lanes_both(_m127, again);
                {
                    const LANES(hoop_backboard_curvature_out) _o147 =
                        LANES(hoop_backboard_curvature)();
                    curving = lanes_select(_m146, _o147.curvature, curving);
                }
                const LANES(hoop_again_out) _o148 =
                    LANES(hoop_again)(K(2.0), last, which);
                again = _o148.again;
                const M _m149 = lanes_both(_m127, again);
                {
                    const LANES(hoop_bridge_curvature_out) _o150 =
                        LANES(hoop_bridge_curvature)();
                    curving = lanes_select(_m149, _o150.curvature, curving);
                }
                const LANES(hoop_carry_flight_out) _o151 =
                    LANES(hoop_carry_flight)(lanes_narrow(when), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(nx), lanes_narrow(ny), lanes_narrow(nz), lanes_narrow(clock), lanes_narrow(contacts), lanes_narrow(late), dx, dy, dz, dvx, dvy, dvz, lanes_narrow(curving), lanes_narrow(p_gravity));
                dx = singles_select(singles_of(_m127), _o151.dx, dx);
                dy = singles_select(singles_of(_m127), _o151.dy, dy);
                dz = singles_select(singles_of(_m127), _o151.dz, dz);
                dvx = singles_select(singles_of(_m127), _o151.dvx, dvx);
                dvy = singles_select(singles_of(_m127), _o151.dvy, dvy);
                dvz = singles_select(singles_of(_m127), _o151.dvz, dvz);
                S belated = _o151.delay;
                S shift = _o151.shift;
                const LANES(hoop_delayed_out) _o152 =
                    LANES(hoop_delayed)(clock_error, belated);
                clock_error = singles_select(singles_of(_m127), _o152.clock_error, clock_error);
                const M _m153 = lanes_both(_m127, ends);
                {
                    const LANES(hoop_floored_out) _o154 =
                        LANES(hoop_floored)(dx, dy, dz, shift);
                    dx = singles_select(singles_of(_m153), _o154.dx, dx);
                    dy = singles_select(singles_of(_m153), _o154.dy, dy);
                    dz = singles_select(singles_of(_m153), _o154.dz, dz);
                }
                const LANES(hoop_unturned_out) _o155 =
                    LANES(hoop_unturned)();
                S dnx = _o155.dnx;
                S dny = _o155.dny;
                S dnz = _o155.dnz;
                S turn = _o155.turn;
                const LANES(hoop_here_out) _o156 =
                    LANES(hoop_here)(K(0.0), which);
                here = _o156.here;
                const M _m157 = lanes_both(_m127, here);
                if (lanes_any(_m157)) {
                    const LANES(hoop_ring_carry_normal_out) _o158 =
                        LANES(hoop_ring_carry_normal)(lanes_narrow(x), lanes_narrow(y), dx, dy, dz, shift, lanes_narrow(p_ball_radius), lanes_narrow(p_ring_radius), lanes_narrow(p_wire_radius));
                    dnx = singles_select(singles_of(_m157), _o158.dnx, dnx);
                    dny = singles_select(singles_of(_m157), _o158.dny, dny);
                    dnz = singles_select(singles_of(_m157), _o158.dnz, dnz);
                    turn = singles_select(singles_of(_m157), _o158.turn, turn);
                }
                const M _m159 = lanes_both(_m127, touches);
                if (lanes_any(_m159)) {
                    const LANES(hoop_carry_impact_out) _o160 =
                        LANES(hoop_carry_impact)(lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(wx), lanes_narrow(wy), lanes_narrow(wz), lanes_narrow(nx), lanes_narrow(ny), lanes_narrow(nz), lanes_narrow(contacts), dvx, dvy, dvz, dwx, dwy, dwz, dnx, dny, dnz, turn, lanes_narrow(p_ball_radius), lanes_narrow(p_restitution));
                    dvx = singles_select(singles_of(_m159), _o160.dvx, dvx);
                    dvy = singles_select(singles_of(_m159), _o160.dvy, dvy);
                    dvz = singles_select(singles_of(_m159), _o160.dvz, dvz);
                    dwx = singles_select(singles_of(_m159), _o160.dwx, dwx);
                    dwy = singles_select(singles_of(_m159), _o160.dwy, dwy);
                    dwz = singles_select(singles_of(_m159), _o160.dwz, dwz);
                    const LANES(hoop_impact_out) _o161 =
                        LANES(hoop_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, p_restitution);
                    vx = lanes_select(_m159, _o161.vx, vx);
                    vy = lanes_select(_m159, _o161.vy, vy);
                    vz = lanes_select(_m159, _o161.vz, vz);
                    wx = lanes_select(_m159, _o161.wx, wx);
                    wy = lanes_select(_m159, _o161.wy, wy);
                    wz = lanes_select(_m159, _o161.wz, wz);
                }
                const LANES(hoop_here_out) _o162 =
                    LANES(hoop_here)(K(1.0), which);
                here = _o162.here;
                const M _m163 = lanes_both(_m127, here);
                {
                    const LANES(hoop_backboard_place_out) _o164 =
                        LANES(hoop_backboard_place)(y, z, p_ball_radius, p_board_distance);
                    x = lanes_select(_m163, _o164.x, x);
                    y = lanes_select(_m163, _o164.y, y);
                    z = lanes_select(_m163, _o164.z, z);
                }
                const LANES(hoop_here_out) _o165 =
                    LANES(hoop_here)(K(2.0), which);
                here = _o165.here;
                const M _m166 = lanes_both(_m127, here);
                {
                    const LANES(hoop_bridge_place_out) _o167 =
                        LANES(hoop_bridge_place)(x, y, p_ball_radius, p_wire_radius);
                    x = lanes_select(_m166, _o167.x, x);
                    y = lanes_select(_m166, _o167.y, y);
                    z = lanes_select(_m166, _o167.z, z);
                }
                const M _m168 = lanes_both(_m127, touches);
                {
                    const LANES(hoop_touched_out) _o169 =
                        LANES(hoop_touched)(body, first, which);
                    first = lanes_select(_m168, _o169.first, first);
                    last = lanes_select(_m168, _o169.last, last);
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
            const M _m170 = lanes_both(rows, limited);
            if (lanes_any(_m170)) {
                const LANES(hoop_timed_out) _o171 =
                    LANES(hoop_timed)(claims, K(4.0), which);
                M timed = _o171.timed;
                const M _m172 = lanes_both(_m170, timed);
                if (lanes_any(_m172)) {
                    const LANES(hoop_carry_time_out) _o173 =
                        LANES(hoop_carry_time)(lanes_narrow(when), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(clock), clock_error, dx, dy, dz, dvx, dvy, dvz, lanes_narrow(p_gravity));
                    dx = singles_select(singles_of(_m172), _o173.dx, dx);
                    dy = singles_select(singles_of(_m172), _o173.dy, dy);
                    dz = singles_select(singles_of(_m172), _o173.dz, dz);
                    dvx = singles_select(singles_of(_m172), _o173.dvx, dvx);
                    dvy = singles_select(singles_of(_m172), _o173.dvy, dvy);
                    dvz = singles_select(singles_of(_m172), _o173.dvz, dvz);
                    clock_error = singles_select(singles_of(_m172), _o173.clock_error, clock_error);
                }
            }
            const LANES(hoop_closing_out) _o174 =
                LANES(hoop_closing)(lanes_narrow(claims), lanes_narrow(outcome));
            M closed = _o174.closed;
            S position_claim = _o174.position_claim;
            S velocity_claim = _o174.velocity_claim;
            S spin_claim = _o174.spin_claim;
            S time_claim = _o174.time_claim;
            const M _m175 = lanes_both(rows, closed);
            if (lanes_any(_m175)) {
                const LANES(hoop_claimed_errors_out) _o176 =
                    LANES(hoop_claimed_errors)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
                position_claim = singles_select(singles_of(_m175), _o176.position_error, position_claim);
                velocity_claim = singles_select(singles_of(_m175), _o176.velocity_error, velocity_claim);
                spin_claim = singles_select(singles_of(_m175), _o176.spin_error, spin_claim);
                time_claim = singles_select(singles_of(_m175), _o176.time_error, time_claim);
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

static void LANES(hoop_run)(const hoop_job *job)
{
    const hoop_results *out = job->results;
    if (out->time_error || out->state_error || out->uncertain)
        LANES(hoop_bounded)(job);
    else
        LANES(hoop_plain)(job);
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
