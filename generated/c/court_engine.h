/* The event loop of the scene court, LANES_WIDTH shots abreast.

   Generated from templates/c/engine.h.j2, scene court, derivation 39c0af57d7c91c6f,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Included by court.c once for every width. The shots in flight fill the first rows of the lists;
   when one ends, the last takes its row. Stages go over all rows, and over those of a list of their
   own where only some shots need them. No shot's result depends on its neighbours. */

#include "court_lanes.h"
#include "court_kernels.h"

/* A column, with room for a whole row of lanes behind its end. */
typedef double LANES(court_column)[LANES_SHOTS + LANES_WIDTH];

/* Have the states of the shots from one on fetched while others are worked on. */
LANES_INLINE void LANES(court_ahead)(const court_job *job, size_t shot)
{
#ifdef __GNUC__
    const double *state = job->states + COURT_STATE * shot;
    for (int line = 0; line < COURT_STATE * LANES_WIDTH; line += 8)
        __builtin_prefetch(state + line, 0, 2);
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
    LANES(court_column) through; /* 1: it has fallen through the ring, -1: it came up through it */
    LANES(court_column) outcome; /* how it ended, -1: in flight */
    LANES(court_column) p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_gravity, p_end_depth, p_ring_restitution, p_backboard_restitution, p_bridge_restitution, p_ring_friction, p_backboard_friction, p_bridge_friction, p_tangential_restitution, p_restitution_speed;
    LANES(court_column) x_before, y_before, z_before, vx_before, vy_before, vz_before, wx_before, wy_before, wz_before;
    LANES(court_column) body;
    LANES(court_column) extent;
    LANES(court_column) limited;
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
}

/* Write the results of the shots that have ended, from a row on; the others close up. */
LANES_INLINE size_t LANES(court_plain_leave)(LANES(court_plain_lists) *lists, size_t start, size_t shots, const court_job *job)
{
    size_t kept = start;
    for (size_t i = start; i < shots; i += LANES_WIDTH) {
        const M rows = lanes_first(shots - i);
        const M going = lanes_both(rows, lanes_less(lanes_load(lists->outcome + i), K(0.0)));
        for (unsigned bits = lanes_bits(rows) & ~lanes_bits(going); bits; bits &= bits - 1)
            LANES(court_plain_finish)(lists, i + (size_t)LANES_LOWEST(bits), job);
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
            const LANES(court_left_out) _o9 =
                LANES(court_left)(K(3.0), last);
            V leaving = _o9.leaving;
            const LANES(court_end_arrival_out) _o10 =
                LANES(court_end_arrival)(leaving, z, vz, p_gravity, p_end_depth);
            V time = _o10.time;
            V rate = _o10.rate;
            V bend = _o10.bend;
            const LANES(court_meeting_plane_out) _o11 =
                LANES(court_meeting_plane)(bend, rate, time);
            M arrives = _o11.arrives;
            const LANES(court_timely_out) _o12 =
                LANES(court_timely)(arrives, K(0.0), K(0.0), time, when);
            M possible = _o12.possible;
            const M _m13 = lanes_both(rows, possible);
            {
                const LANES(court_sooner_out) _o14 =
                    LANES(court_sooner)(arrives, K(3.0), time, when, which);
                when = lanes_select(_m13, _o14.when, when);
                which = lanes_select(_m13, _o14.which, which);
            }
            const LANES(court_horizon_out) _o15 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o15.horizon;
            const LANES(court_ring_clear_out) _o16 =
                LANES(court_ring_clear)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V clear = _o16.clear;
            const LANES(court_opens_out) _o17 =
                LANES(court_opens)(clear);
            M open = _o17.open;
            lanes_store(lists->extent + i, extent);
            lanes_store(lists->limited + i, lanes_select(limited, K(1.0), K(0.0)));
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
            const LANES(court_ring_prepare_out) _o18 =
                LANES(court_ring_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V steady = _o18.steady;
            V swing = _o18.swing;
            V rho_start = _o18.rho_start;
            V low0 = _o18.low0;
            V high0 = _o18.high0;
            V low1 = _o18.low1;
            V high1 = _o18.high1;
            V low2 = _o18.low2;
            V high2 = _o18.high2;
            V ceiling = _o18.ceiling;
            V latest = _o18.latest;
            const LANES(court_beginning_out) _o19 =
                LANES(court_beginning)();
            V share = _o19.share;
            V arrival = _o19.arrival;
            M certain = _o19.certain;
            const LANES(court_allowance_out) _o20 =
                LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
            V position_level = _o20.position_level;
            V velocity_level = _o20.velocity_level;
            const LANES(court_ring_margins_out) _o21 =
                LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V flat = _o21.margin;
            V tilt = _o21.leaving_margin;
            V rate_slack = _o21.rate_margin;
            const LANES(court_ring_enter_out) _o22 =
                LANES(court_ring_enter)(K(0.0), K(0.0), high0, high1, high2, low0, low1, low2, K(0.0));
            V t = _o22.t;
            V end = _o22.end;
            M searching = _o22.searching;
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
                const LANES(court_nearby_out) _o23 =
                    LANES(court_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = _o23.leaving;
                V margin = _o23.margin;
                const LANES(court_ring_advance_out) _o24 =
                    LANES(court_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V gap = _o24.gap;
                V rate = _o24.rate;
                V bend = _o24.bend;
                V step = _o24.step;
                V next = _o24.next;
                V root = _o24.root;
                V clearance = _o24.clearance;
                const LANES(court_struck_out) _o25 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o25.hit;
                M sure = _o25.sure;
                M vague = _o25.vague;
                const M _m26 = lanes_both(active, vague);
                if (lanes_any(_m26)) {
                    const LANES(court_finer_out) _o27 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m26, _o27.share, share);
                    const LANES(court_allowance_out) _o28 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
                    V position_level = _o28.position_level;
                    V velocity_level = _o28.velocity_level;
                    const LANES(court_ring_margins_out) _o29 =
                        LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    flat = lanes_select(_m26, _o29.margin, flat);
                    tilt = lanes_select(_m26, _o29.leaving_margin, tilt);
                    rate_slack = lanes_select(_m26, _o29.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o30 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, root, step, sure, t, vague);
                arrival = _o30.arrival;
                certain = _o30.certain;
                M exhausted = _o30.exhausted;
                searching = _o30.searching;
                t = _o30.t;
                const M _m31 = lanes_both(active, exhausted);
                {
                    const LANES(court_ring_enter_out) _o32 =
                        LANES(court_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m31, _o32.t, t);
                    end = lanes_select(_m31, _o32.end, end);
                    searching = lanes_choose(_m31, _o32.searching, searching);
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
            const LANES(court_found_out) _o33 =
                LANES(court_found)(arrival);
            M arrives = _o33.arrives;
            const LANES(court_nearby_out) _o34 =
                LANES(court_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o34.leaving;
            const LANES(court_ring_refine_out) _o35 =
                LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V refined = _o35.time;
            const LANES(court_polished_out) _o36 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o36.arrival;
            const LANES(court_ring_refine_out) _o37 =
                LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            refined = _o37.time;
            const LANES(court_polished_out) _o38 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o38.arrival;
            const LANES(court_landed_out) _o39 =
                LANES(court_landed)(arrival);
            V time = _o39.time;
            const LANES(court_sooner_out) _o40 =
                LANES(court_sooner)(arrives, K(0.0), time, when, which);
            when = _o40.when;
            which = _o40.which;
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
            const LANES(court_horizon_out) _o41 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o41.horizon;
            const LANES(court_backboard_clear_out) _o42 =
                LANES(court_backboard_clear)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V clear = _o42.clear;
            const LANES(court_opens_out) _o43 =
                LANES(court_opens)(clear);
            M open = _o43.open;
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
            const LANES(court_backboard_prepare_out) _o44 =
                LANES(court_backboard_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V low0 = _o44.low0;
            V high0 = _o44.high0;
            V low1 = _o44.low1;
            V high1 = _o44.high1;
            V ceiling = _o44.ceiling;
            V latest = _o44.latest;
            const LANES(court_beginning_out) _o45 =
                LANES(court_beginning)();
            V share = _o45.share;
            V arrival = _o45.arrival;
            M certain = _o45.certain;
            const LANES(court_allowance_out) _o46 =
                LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
            V position_level = _o46.position_level;
            V velocity_level = _o46.velocity_level;
            const LANES(court_backboard_margins_out) _o47 =
                LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V flat = _o47.margin;
            V tilt = _o47.leaving_margin;
            V rate_slack = _o47.rate_margin;
            const LANES(court_backboard_enter_out) _o48 =
                LANES(court_backboard_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o48.t;
            V end = _o48.end;
            M searching = _o48.searching;
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
                const LANES(court_nearby_out) _o49 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o49.leaving;
                V margin = _o49.margin;
                const LANES(court_backboard_advance_out) _o50 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V gap = _o50.gap;
                V rate = _o50.rate;
                V bend = _o50.bend;
                V step = _o50.step;
                V next = _o50.next;
                V root = _o50.root;
                V clearance = _o50.clearance;
                const LANES(court_struck_out) _o51 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o51.hit;
                M sure = _o51.sure;
                M vague = _o51.vague;
                const M _m52 = lanes_both(active, vague);
                if (lanes_any(_m52)) {
                    const LANES(court_finer_out) _o53 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m52, _o53.share, share);
                    const LANES(court_allowance_out) _o54 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
                    V position_level = _o54.position_level;
                    V velocity_level = _o54.velocity_level;
                    const LANES(court_backboard_margins_out) _o55 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                    flat = lanes_select(_m52, _o55.margin, flat);
                    tilt = lanes_select(_m52, _o55.leaving_margin, tilt);
                    rate_slack = lanes_select(_m52, _o55.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o56 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, root, step, sure, t, vague);
                arrival = _o56.arrival;
                certain = _o56.certain;
                M exhausted = _o56.exhausted;
                searching = _o56.searching;
                t = _o56.t;
                const M _m57 = lanes_both(active, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o58 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m57, _o58.t, t);
                    end = lanes_select(_m57, _o58.end, end);
                    searching = lanes_choose(_m57, _o58.searching, searching);
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
            const LANES(court_found_out) _o59 =
                LANES(court_found)(arrival);
            M arrives = _o59.arrives;
            const LANES(court_nearby_out) _o60 =
                LANES(court_nearby)(flat, K(1.0), last, arrival, tilt);
            V leaving = _o60.leaving;
            const LANES(court_backboard_refine_out) _o61 =
                LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V refined = _o61.time;
            const LANES(court_polished_out) _o62 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o62.arrival;
            const LANES(court_backboard_refine_out) _o63 =
                LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            refined = _o63.time;
            const LANES(court_polished_out) _o64 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o64.arrival;
            const LANES(court_landed_out) _o65 =
                LANES(court_landed)(arrival);
            V time = _o65.time;
            const LANES(court_sooner_out) _o66 =
                LANES(court_sooner)(arrives, K(1.0), time, when, which);
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
            const LANES(court_horizon_out) _o67 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o67.horizon;
            const LANES(court_bridge_clear_out) _o68 =
                LANES(court_bridge_clear)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V clear = _o68.clear;
            const LANES(court_opens_out) _o69 =
                LANES(court_opens)(clear);
            M open = _o69.open;
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
            const LANES(court_bridge_prepare_out) _o70 =
                LANES(court_bridge_prepare)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V low0 = _o70.low0;
            V high0 = _o70.high0;
            V low1 = _o70.low1;
            V high1 = _o70.high1;
            V ceiling = _o70.ceiling;
            V latest = _o70.latest;
            const LANES(court_beginning_out) _o71 =
                LANES(court_beginning)();
            V share = _o71.share;
            V arrival = _o71.arrival;
            M certain = _o71.certain;
            const LANES(court_allowance_out) _o72 =
                LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
            V position_level = _o72.position_level;
            V velocity_level = _o72.velocity_level;
            const LANES(court_bridge_margins_out) _o73 =
                LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V flat = _o73.margin;
            V tilt = _o73.leaving_margin;
            V rate_slack = _o73.rate_margin;
            const LANES(court_bridge_enter_out) _o74 =
                LANES(court_bridge_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o74.t;
            V end = _o74.end;
            M searching = _o74.searching;
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
                const LANES(court_nearby_out) _o75 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o75.leaving;
                V margin = _o75.margin;
                const LANES(court_bridge_advance_out) _o76 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V gap = _o76.gap;
                V rate = _o76.rate;
                V bend = _o76.bend;
                V step = _o76.step;
                V next = _o76.next;
                V root = _o76.root;
                V clearance = _o76.clearance;
                const LANES(court_struck_out) _o77 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o77.hit;
                M sure = _o77.sure;
                M vague = _o77.vague;
                const M _m78 = lanes_both(active, vague);
                if (lanes_any(_m78)) {
                    const LANES(court_finer_out) _o79 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m78, _o79.share, share);
                    const LANES(court_allowance_out) _o80 =
                        LANES(court_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
                    V position_level = _o80.position_level;
                    V velocity_level = _o80.velocity_level;
                    const LANES(court_bridge_margins_out) _o81 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                    flat = lanes_select(_m78, _o81.margin, flat);
                    tilt = lanes_select(_m78, _o81.leaving_margin, tilt);
                    rate_slack = lanes_select(_m78, _o81.rate_margin, rate_slack);
                }
                const LANES(court_advanced_out) _o82 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, root, step, sure, t, vague);
                arrival = _o82.arrival;
                certain = _o82.certain;
                M exhausted = _o82.exhausted;
                searching = _o82.searching;
                t = _o82.t;
                const M _m83 = lanes_both(active, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o84 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m83, _o84.t, t);
                    end = lanes_select(_m83, _o84.end, end);
                    searching = lanes_choose(_m83, _o84.searching, searching);
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
            const LANES(court_found_out) _o85 =
                LANES(court_found)(arrival);
            M arrives = _o85.arrives;
            const LANES(court_nearby_out) _o86 =
                LANES(court_nearby)(flat, K(2.0), last, arrival, tilt);
            V leaving = _o86.leaving;
            const LANES(court_bridge_refine_out) _o87 =
                LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V refined = _o87.time;
            const LANES(court_polished_out) _o88 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o88.arrival;
            const LANES(court_bridge_refine_out) _o89 =
                LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            refined = _o89.time;
            const LANES(court_polished_out) _o90 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o90.arrival;
            const LANES(court_landed_out) _o91 =
                LANES(court_landed)(arrival);
            V time = _o91.time;
            const LANES(court_sooner_out) _o92 =
                LANES(court_sooner)(arrives, K(2.0), time, when, which);
            when = _o92.when;
            which = _o92.which;
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
            V count_0 = lanes_load(lists->count_0 + i);
            V count_1 = lanes_load(lists->count_1 + i);
            V count_2 = lanes_load(lists->count_2 + i);
            V first = lanes_load(lists->first + i);
            V last = lanes_load(lists->last + i);
            M limited = lanes_less(K(0.0), lanes_load(lists->limited + i));
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
            const V p_gravity = lanes_load(lists->p_gravity + (i & varying));
            const V p_restitution_speed = lanes_load(lists->p_restitution_speed + (i & varying));
            const V p_ring_friction = lanes_load(lists->p_ring_friction + (i & varying));
            const V p_ring_radius = lanes_load(lists->p_ring_radius + (i & varying));
            const V p_ring_restitution = lanes_load(lists->p_ring_restitution + (i & varying));
            const V p_tangential_restitution = lanes_load(lists->p_tangential_restitution + (i & varying));
            const V p_wire_radius = lanes_load(lists->p_wire_radius + (i & varying));
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
            const M _m93 = lanes_both(rows, limited);
            if (lanes_any(_m93)) {
                const LANES(court_expiry_out) _o94 =
                    LANES(court_expiry)(clock, K(INFINITY), K(0.0), time_error, time_limit, when, which);
                V time = _o94.time;
                M arrives = _o94.arrives;
                const LANES(court_sooner_out) _o95 =
                    LANES(court_sooner)(arrives, K(4.0), time, when, which);
                when = lanes_select(_m93, _o95.when, when);
                which = lanes_select(_m93, _o95.which, which);
            }
            const LANES(court_departed_out) _o96 =
                LANES(court_departed)(K(3.0), which);
            M moves = _o96.moves;
            M ends = _o96.ends;
            M touches = _o96.touches;
            V reached = _o96.reached;
            const LANES(court_body_of_out) _o97 =
                LANES(court_body_of)(which);
            V body = _o97.body;
            const M _m98 = lanes_both(rows, moves);
            if (lanes_any(_m98)) {
                const LANES(court_passing_out) _o99 =
                    LANES(court_passing)(through, when, x, y, z, vx, vy, vz, p_ring_radius, p_gravity);
                through = lanes_select(_m98, _o99.through, through);
                const LANES(court_flight_out) _o100 =
                    LANES(court_flight)(when, x, y, z, vx, vy, vz, p_gravity);
                x = lanes_select(_m98, _o100.x, x);
                y = lanes_select(_m98, _o100.y, y);
                z = lanes_select(_m98, _o100.z, z);
                vx = lanes_select(_m98, _o100.vx, vx);
                vy = lanes_select(_m98, _o100.vy, vy);
                vz = lanes_select(_m98, _o100.vz, vz);
                const LANES(court_ticked_out) _o101 =
                    LANES(court_ticked)(clock, when);
                clock = lanes_select(_m98, _o101.clock, clock);
            }
            const M _m102 = lanes_both(rows, limited);
            if (lanes_any(_m102)) {
                const LANES(court_expired_out) _o103 =
                    LANES(court_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m102, _o103.clock, clock);
                body = lanes_select(_m102, _o103.body, body);
                reached = lanes_select(_m102, _o103.reached, reached);
                ends = lanes_choose(_m102, _o103.ends, ends);
            }
            const LANES(court_here_out) _o104 =
                LANES(court_here)(K(3.0), which);
            M here = _o104.here;
            const M _m105 = lanes_both(rows, here);
            {
                const LANES(court_end_bounds_out) _o106 =
                    LANES(court_end_bounds)(x, y, p_ring_radius);
                V g0 = _o106.g0;
                const LANES(court_end_reached_out) _o107 =
                    LANES(court_end_reached)(g0, through);
                reached = lanes_select(_m105, _o107.reached, reached);
            }
            const LANES(court_accounted_out) _o108 =
                LANES(court_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o108.contacts;
            V outcome = _o108.outcome;
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
            const LANES(court_meeting_out) _o109 =
                LANES(court_meeting)(K(0.0), ends, touches);
            M meeting = _o109.meeting;
            const M _m110 = lanes_both(rows, meeting);
            if (lanes_any(_m110)) {
                const LANES(court_end_normal_out) _o111 =
                    LANES(court_end_normal)();
                V nx = _o111.nx;
                V ny = _o111.ny;
                V nz = _o111.nz;
                const LANES(court_here_out) _o112 =
                    LANES(court_here)(K(0.0), which);
                M here = _o112.here;
                const M _m113 = lanes_both(_m110, here);
                {
                    const LANES(court_ring_normal_out) _o114 =
                        LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m113, _o114.nx, nx);
                    ny = lanes_select(_m113, _o114.ny, ny);
                    nz = lanes_select(_m113, _o114.nz, nz);
                    const LANES(court_counted_out) _o115 =
                        LANES(court_counted)(count_0);
                    count_0 = lanes_select(_m113, _o115.count, count_0);
                }
                const LANES(court_here_out) _o116 =
                    LANES(court_here)(K(1.0), which);
                here = _o116.here;
                const M _m117 = lanes_both(_m110, here);
                {
                    const LANES(court_backboard_normal_out) _o118 =
                        LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m117, _o118.nx, nx);
                    ny = lanes_select(_m117, _o118.ny, ny);
                    nz = lanes_select(_m117, _o118.nz, nz);
                    const LANES(court_counted_out) _o119 =
                        LANES(court_counted)(count_1);
                    count_1 = lanes_select(_m117, _o119.count, count_1);
                }
                const LANES(court_here_out) _o120 =
                    LANES(court_here)(K(2.0), which);
                here = _o120.here;
                const M _m121 = lanes_both(_m110, here);
                {
                    const LANES(court_bridge_normal_out) _o122 =
                        LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m121, _o122.nx, nx);
                    ny = lanes_select(_m121, _o122.ny, ny);
                    nz = lanes_select(_m121, _o122.nz, nz);
                    const LANES(court_counted_out) _o123 =
                        LANES(court_counted)(count_2);
                    count_2 = lanes_select(_m121, _o123.count, count_2);
                }
                const LANES(court_here_out) _o124 =
                    LANES(court_here)(K(0.0), which);
                here = _o124.here;
                const M _m125 = lanes_both(_m110, here);
                if (lanes_any(_m125)) {
                    const LANES(court_ring_impact_out) _o126 =
                        LANES(court_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, p_ring_restitution, p_ring_friction, p_tangential_restitution, p_restitution_speed);
                    vx = lanes_select(_m125, _o126.vx, vx);
                    vy = lanes_select(_m125, _o126.vy, vy);
                    vz = lanes_select(_m125, _o126.vz, vz);
                    wx = lanes_select(_m125, _o126.wx, wx);
                    wy = lanes_select(_m125, _o126.wy, wy);
                    wz = lanes_select(_m125, _o126.wz, wz);
                }
                const LANES(court_here_out) _o127 =
                    LANES(court_here)(K(1.0), which);
                here = _o127.here;
                const M _m128 = lanes_both(_m110, here);
                if (lanes_any(_m128)) {
                    const LANES(court_backboard_impact_out) _o129 =
                        LANES(court_backboard_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, p_backboard_restitution, p_backboard_friction, p_tangential_restitution, p_restitution_speed);
                    vx = lanes_select(_m128, _o129.vx, vx);
                    vy = lanes_select(_m128, _o129.vy, vy);
                    vz = lanes_select(_m128, _o129.vz, vz);
                    wx = lanes_select(_m128, _o129.wx, wx);
                    wy = lanes_select(_m128, _o129.wy, wy);
                    wz = lanes_select(_m128, _o129.wz, wz);
                }
                const LANES(court_here_out) _o130 =
                    LANES(court_here)(K(2.0), which);
                here = _o130.here;
                const M _m131 = lanes_both(_m110, here);
                if (lanes_any(_m131)) {
                    const LANES(court_bridge_impact_out) _o132 =
                        LANES(court_bridge_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, p_bridge_restitution, p_bridge_friction, p_tangential_restitution, p_restitution_speed);
                    vx = lanes_select(_m131, _o132.vx, vx);
                    vy = lanes_select(_m131, _o132.vy, vy);
                    vz = lanes_select(_m131, _o132.vz, vz);
                    wx = lanes_select(_m131, _o132.wx, wx);
                    wy = lanes_select(_m131, _o132.wy, wy);
                    wz = lanes_select(_m131, _o132.wz, wz);
                }
                const M _m133 = lanes_both(_m110, touches);
                {
                    const LANES(court_touched_out) _o134 =
                        LANES(court_touched)(body, first, which);
                    first = lanes_select(_m133, _o134.first, first);
                    last = lanes_select(_m133, _o134.last, last);
                }
            }
            lanes_store(lists->clock + i, clock);
            lanes_store(lists->contacts + i, contacts);
            lanes_store(lists->count_0 + i, count_0);
            lanes_store(lists->count_1 + i, count_1);
            lanes_store(lists->count_2 + i, count_2);
            lanes_store(lists->first + i, first);
            lanes_store(lists->last + i, last);
            lanes_store(lists->outcome + i, outcome);
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
                const size_t shot = lists->shot[k];
                int32_t *used = job->results->event_counts + shot;
                court_event *event = job->results->events + shot * ((size_t)job->max_contacts + 1) + (size_t)(*used)++;
                event->shot = (int64_t)shot;
                event->surface = (int64_t)lists->body[k];
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
    LANES(court_column) through; /* 1: it has fallen through the ring, -1: it came up through it */
    LANES(court_column) uncertain; /* 1: a decision lies within its rounding-error bound */
    LANES(court_column) position_claim; /* bound on the error at the end */
    LANES(court_column) velocity_claim; /* bound on the error at the end */
    LANES(court_column) spin_claim; /* bound on the error at the end */
    LANES(court_column) time_claim; /* bound on the error at the end */
    LANES(court_column) outcome; /* how it ended, -1: in flight */
    LANES(court_column) p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_gravity, p_end_depth, p_ring_restitution, p_backboard_restitution, p_bridge_restitution, p_ring_friction, p_backboard_friction, p_bridge_friction, p_tangential_restitution, p_restitution_speed;
    LANES(court_column) x_before, y_before, z_before, vx_before, vy_before, vz_before, wx_before, wy_before, wz_before;
    LANES(court_column) body;
    LANES(court_column) doubt;
    LANES(court_column) extent;
    LANES(court_column) late;
    LANES(court_column) limited;
    LANES(court_column) position_error;
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
LANES_INLINE size_t LANES(court_bounded_leave)(LANES(court_bounded_lists) *lists, size_t start, size_t shots, const court_job *job)
{
    size_t kept = start;
    for (size_t i = start; i < shots; i += LANES_WIDTH) {
        const M rows = lanes_first(shots - i);
        const M going = lanes_both(rows, lanes_less(lanes_load(lists->outcome + i), K(0.0)));
        for (unsigned bits = lanes_bits(rows) & ~lanes_bits(going); bits; bits &= bits - 1)
            LANES(court_bounded_finish)(lists, i + (size_t)LANES_LOWEST(bits), job);
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
            const LANES(court_left_out) _o9 =
                LANES(court_left)(K(3.0), last);
            V leaving = _o9.leaving;
            const LANES(court_end_arrival_out) _o10 =
                LANES(court_end_arrival)(leaving, z, vz, p_gravity, p_end_depth);
            V time = _o10.time;
            V rate = _o10.rate;
            V bend = _o10.bend;
            V apex = _o10.apex;
            V height = _o10.height;
            const LANES(court_meeting_plane_out) _o11 =
                LANES(court_meeting_plane)(bend, rate, time);
            M arrives = _o11.arrives;
            V ceiling = _o11.ceiling;
            const LANES(court_end_margin_out) _o12 =
                LANES(court_end_margin)(time, extent, speed, position_error, velocity_error, p_gravity, p_end_depth);
            V margin = _o12.margin;
            const LANES(court_crossing_out) _o13 =
                LANES(court_crossing)(margin, K(0.0), rate, ceiling);
            V clearance = _o13.clearance;
            V delay = _o13.delay;
            const LANES(court_timely_out) _o14 =
                LANES(court_timely)(arrives, delay, late, time, when);
            M possible = _o14.possible;
            const LANES(court_end_margin_out) _o15 =
                LANES(court_end_margin)(apex, extent, speed, position_error, velocity_error, p_gravity, p_end_depth);
            margin = _o15.margin;
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
            const LANES(court_opens_out) _o23 =
                LANES(court_opens)(clear);
            M open = _o23.open;
            lanes_store(lists->doubt + i, doubt);
            lanes_store(lists->extent + i, extent);
            lanes_store(lists->late + i, late);
            lanes_store(lists->limited + i, lanes_select(limited, K(1.0), K(0.0)));
            lanes_store(lists->position_error + i, position_error);
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
            const LANES(court_ring_prepare_out) _o24 =
                LANES(court_ring_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V steady = _o24.steady;
            V swing = _o24.swing;
            V rho_start = _o24.rho_start;
            V low0 = _o24.low0;
            V high0 = _o24.high0;
            V low1 = _o24.low1;
            V high1 = _o24.high1;
            V low2 = _o24.low2;
            V high2 = _o24.high2;
            V ceiling = _o24.ceiling;
            V latest = _o24.latest;
            V lost = _o24.lost;
            const LANES(court_beginning_out) _o25 =
                LANES(court_beginning)();
            V share = _o25.share;
            V arrival = _o25.arrival;
            M certain = _o25.certain;
            const LANES(court_allowance_out) _o26 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
            V position_level = _o26.position_level;
            V velocity_level = _o26.velocity_level;
            V excess = _o26.excess;
            const LANES(court_ring_margins_out) _o27 =
                LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V flat = _o27.margin;
            V tilt = _o27.leaving_margin;
            V rate_slack = _o27.rate_margin;
            const LANES(court_beyond_out) _o28 =
                LANES(court_beyond)(doubt, excess, late, lost, pad);
            doubt = _o28.doubt;
            const LANES(court_ring_enter_out) _o29 =
                LANES(court_ring_enter)(K(0.0), K(0.0), high0, high1, high2, low0, low1, low2, K(0.0));
            V t = _o29.t;
            V end = _o29.end;
            M searching = _o29.searching;
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
                const LANES(court_nearby_out) _o30 =
                    LANES(court_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = _o30.leaving;
                V margin = _o30.margin;
                const LANES(court_ring_advance_out) _o31 =
                    LANES(court_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V gap = _o31.gap;
                V rate = _o31.rate;
                V bend = _o31.bend;
                V step = _o31.step;
                V next = _o31.next;
                V root = _o31.root;
                V clearance = _o31.clearance;
                const LANES(court_struck_out) _o32 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o32.hit;
                M sure = _o32.sure;
                M vague = _o32.vague;
                const M _m33 = lanes_both(active, vague);
                if (lanes_any(_m33)) {
                    const LANES(court_finer_out) _o34 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m33, _o34.share, share);
                    const LANES(court_allowance_out) _o35 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o35.position_level;
                    V velocity_level = _o35.velocity_level;
                    V excess = _o35.excess;
                    const LANES(court_ring_margins_out) _o36 =
                        LANES(court_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    flat = lanes_select(_m33, _o36.margin, flat);
                    tilt = lanes_select(_m33, _o36.leaving_margin, tilt);
                    rate_slack = lanes_select(_m33, _o36.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o37 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m33, _o37.doubt, doubt);
                }
                const LANES(court_advanced_out) _o38 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, root, step, sure, t, vague);
                arrival = _o38.arrival;
                certain = _o38.certain;
                M exhausted = _o38.exhausted;
                searching = _o38.searching;
                t = _o38.t;
                const M _m39 = lanes_both(active, exhausted);
                {
                    const LANES(court_ring_enter_out) _o40 =
                        LANES(court_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m39, _o40.t, t);
                    end = lanes_select(_m39, _o40.end, end);
                    searching = lanes_choose(_m39, _o40.searching, searching);
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
            const LANES(court_questioned_out) _o41 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o41.doubt;
            const LANES(court_found_out) _o42 =
                LANES(court_found)(arrival);
            M arrives = _o42.arrives;
            const LANES(court_nearby_out) _o43 =
                LANES(court_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o43.leaving;
            const LANES(court_ring_refine_out) _o44 =
                LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V refined = _o44.time;
            const LANES(court_polished_out) _o45 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o45.arrival;
            const LANES(court_ring_refine_out) _o46 =
                LANES(court_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            refined = _o46.time;
            V rate = _o46.rate;
            const LANES(court_polished_out) _o47 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o47.arrival;
            const LANES(court_ring_margins_out) _o48 =
                LANES(court_ring_margins)(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            flat = _o48.margin;
            tilt = _o48.leaving_margin;
            V rate_margin = _o48.rate_margin;
            const LANES(court_own_margin_out) _o49 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o49.margin;
            const LANES(court_crossing_out) _o50 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o50.clearance;
            V delay = _o50.delay;
            const LANES(court_landed_out) _o51 =
                LANES(court_landed)(arrival);
            V time = _o51.time;
            const LANES(court_landed_surely_out) _o52 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o52.delay;
            doubt = _o52.doubt;
            const LANES(court_tied_out) _o53 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o53.doubt;
            late = _o53.late;
            const LANES(court_sooner_out) _o54 =
                LANES(court_sooner)(arrives, K(0.0), time, when, which);
            when = _o54.when;
            which = _o54.which;
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
            const LANES(court_horizon_out) _o55 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o55.horizon;
            V pad = _o55.pad;
            const LANES(court_backboard_clear_out) _o56 =
                LANES(court_backboard_clear)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V clear = _o56.clear;
            const LANES(court_opens_out) _o57 =
                LANES(court_opens)(clear);
            M open = _o57.open;
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
            const LANES(court_backboard_prepare_out) _o58 =
                LANES(court_backboard_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V low0 = _o58.low0;
            V high0 = _o58.high0;
            V low1 = _o58.low1;
            V high1 = _o58.high1;
            V ceiling = _o58.ceiling;
            V latest = _o58.latest;
            V lost = _o58.lost;
            const LANES(court_beginning_out) _o59 =
                LANES(court_beginning)();
            V share = _o59.share;
            V arrival = _o59.arrival;
            M certain = _o59.certain;
            const LANES(court_allowance_out) _o60 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
            V position_level = _o60.position_level;
            V velocity_level = _o60.velocity_level;
            V excess = _o60.excess;
            const LANES(court_backboard_margins_out) _o61 =
                LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V flat = _o61.margin;
            V tilt = _o61.leaving_margin;
            V rate_slack = _o61.rate_margin;
            const LANES(court_beyond_out) _o62 =
                LANES(court_beyond)(doubt, excess, late, lost, pad);
            doubt = _o62.doubt;
            const LANES(court_backboard_enter_out) _o63 =
                LANES(court_backboard_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o63.t;
            V end = _o63.end;
            M searching = _o63.searching;
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
                const LANES(court_nearby_out) _o64 =
                    LANES(court_nearby)(flat, K(1.0), last, t, tilt);
                V leaving = _o64.leaving;
                V margin = _o64.margin;
                const LANES(court_backboard_advance_out) _o65 =
                    LANES(court_backboard_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                V gap = _o65.gap;
                V rate = _o65.rate;
                V bend = _o65.bend;
                V step = _o65.step;
                V next = _o65.next;
                V root = _o65.root;
                V clearance = _o65.clearance;
                const LANES(court_struck_out) _o66 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o66.hit;
                M sure = _o66.sure;
                M vague = _o66.vague;
                const M _m67 = lanes_both(active, vague);
                if (lanes_any(_m67)) {
                    const LANES(court_finer_out) _o68 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m67, _o68.share, share);
                    const LANES(court_allowance_out) _o69 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o69.position_level;
                    V velocity_level = _o69.velocity_level;
                    V excess = _o69.excess;
                    const LANES(court_backboard_margins_out) _o70 =
                        LANES(court_backboard_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                    flat = lanes_select(_m67, _o70.margin, flat);
                    tilt = lanes_select(_m67, _o70.leaving_margin, tilt);
                    rate_slack = lanes_select(_m67, _o70.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o71 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m67, _o71.doubt, doubt);
                }
                const LANES(court_advanced_out) _o72 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, root, step, sure, t, vague);
                arrival = _o72.arrival;
                certain = _o72.certain;
                M exhausted = _o72.exhausted;
                searching = _o72.searching;
                t = _o72.t;
                const M _m73 = lanes_both(active, exhausted);
                {
                    const LANES(court_backboard_enter_out) _o74 =
                        LANES(court_backboard_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m73, _o74.t, t);
                    end = lanes_select(_m73, _o74.end, end);
                    searching = lanes_choose(_m73, _o74.searching, searching);
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
            const LANES(court_questioned_out) _o75 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o75.doubt;
            const LANES(court_found_out) _o76 =
                LANES(court_found)(arrival);
            M arrives = _o76.arrives;
            const LANES(court_nearby_out) _o77 =
                LANES(court_nearby)(flat, K(1.0), last, arrival, tilt);
            V leaving = _o77.leaving;
            const LANES(court_backboard_refine_out) _o78 =
                LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            V refined = _o78.time;
            const LANES(court_polished_out) _o79 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o79.arrival;
            const LANES(court_backboard_refine_out) _o80 =
                LANES(court_backboard_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            refined = _o80.time;
            V rate = _o80.rate;
            const LANES(court_polished_out) _o81 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o81.arrival;
            const LANES(court_backboard_margins_out) _o82 =
                LANES(court_backboard_margins)(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            flat = _o82.margin;
            tilt = _o82.leaving_margin;
            V rate_margin = _o82.rate_margin;
            const LANES(court_own_margin_out) _o83 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o83.margin;
            const LANES(court_crossing_out) _o84 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o84.clearance;
            V delay = _o84.delay;
            const LANES(court_landed_out) _o85 =
                LANES(court_landed)(arrival);
            V time = _o85.time;
            const LANES(court_landed_surely_out) _o86 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o86.delay;
            doubt = _o86.doubt;
            const LANES(court_tied_out) _o87 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o87.doubt;
            late = _o87.late;
            const LANES(court_sooner_out) _o88 =
                LANES(court_sooner)(arrives, K(1.0), time, when, which);
            when = _o88.when;
            which = _o88.which;
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
            const LANES(court_horizon_out) _o89 =
                LANES(court_horizon)(when, speed, p_gravity);
            V until = _o89.horizon;
            V pad = _o89.pad;
            const LANES(court_bridge_clear_out) _o90 =
                LANES(court_bridge_clear)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V clear = _o90.clear;
            const LANES(court_opens_out) _o91 =
                LANES(court_opens)(clear);
            M open = _o91.open;
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
            const LANES(court_bridge_prepare_out) _o92 =
                LANES(court_bridge_prepare)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V low0 = _o92.low0;
            V high0 = _o92.high0;
            V low1 = _o92.low1;
            V high1 = _o92.high1;
            V ceiling = _o92.ceiling;
            V latest = _o92.latest;
            V lost = _o92.lost;
            const LANES(court_beginning_out) _o93 =
                LANES(court_beginning)();
            V share = _o93.share;
            V arrival = _o93.arrival;
            M certain = _o93.certain;
            const LANES(court_allowance_out) _o94 =
                LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
            V position_level = _o94.position_level;
            V velocity_level = _o94.velocity_level;
            V excess = _o94.excess;
            const LANES(court_bridge_margins_out) _o95 =
                LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V flat = _o95.margin;
            V tilt = _o95.leaving_margin;
            V rate_slack = _o95.rate_margin;
            const LANES(court_beyond_out) _o96 =
                LANES(court_beyond)(doubt, excess, late, lost, pad);
            doubt = _o96.doubt;
            const LANES(court_bridge_enter_out) _o97 =
                LANES(court_bridge_enter)(K(0.0), K(0.0), high0, high1, low0, low1, K(0.0));
            V t = _o97.t;
            V end = _o97.end;
            M searching = _o97.searching;
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
                const LANES(court_nearby_out) _o98 =
                    LANES(court_nearby)(flat, K(2.0), last, t, tilt);
                V leaving = _o98.leaving;
                V margin = _o98.margin;
                const LANES(court_bridge_advance_out) _o99 =
                    LANES(court_bridge_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                V gap = _o99.gap;
                V rate = _o99.rate;
                V bend = _o99.bend;
                V step = _o99.step;
                V next = _o99.next;
                V root = _o99.root;
                V clearance = _o99.clearance;
                const LANES(court_struck_out) _o100 =
                    LANES(court_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o100.hit;
                M sure = _o100.sure;
                M vague = _o100.vague;
                const M _m101 = lanes_both(active, vague);
                if (lanes_any(_m101)) {
                    const LANES(court_finer_out) _o102 =
                        LANES(court_finer)(share);
                    share = lanes_select(_m101, _o102.share, share);
                    const LANES(court_allowance_out) _o103 =
                        LANES(court_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o103.position_level;
                    V velocity_level = _o103.velocity_level;
                    V excess = _o103.excess;
                    const LANES(court_bridge_margins_out) _o104 =
                        LANES(court_bridge_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                    flat = lanes_select(_m101, _o104.margin, flat);
                    tilt = lanes_select(_m101, _o104.leaving_margin, tilt);
                    rate_slack = lanes_select(_m101, _o104.rate_margin, rate_slack);
                    const LANES(court_exceeded_out) _o105 =
                        LANES(court_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m101, _o105.doubt, doubt);
                }
                const LANES(court_advanced_out) _o106 =
                    LANES(court_advanced)(arrival, certain, end, hit, next, root, step, sure, t, vague);
                arrival = _o106.arrival;
                certain = _o106.certain;
                M exhausted = _o106.exhausted;
                searching = _o106.searching;
                t = _o106.t;
                const M _m107 = lanes_both(active, exhausted);
                {
                    const LANES(court_bridge_enter_out) _o108 =
                        LANES(court_bridge_enter)(end, end, high0, high1, low0, low1, t);
                    t = lanes_select(_m107, _o108.t, t);
                    end = lanes_select(_m107, _o108.end, end);
                    searching = lanes_choose(_m107, _o108.searching, searching);
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
            const LANES(court_questioned_out) _o109 =
                LANES(court_questioned)(doubt, t, searching);
            doubt = _o109.doubt;
            const LANES(court_found_out) _o110 =
                LANES(court_found)(arrival);
            M arrives = _o110.arrives;
            const LANES(court_nearby_out) _o111 =
                LANES(court_nearby)(flat, K(2.0), last, arrival, tilt);
            V leaving = _o111.leaving;
            const LANES(court_bridge_refine_out) _o112 =
                LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            V refined = _o112.time;
            const LANES(court_polished_out) _o113 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o113.arrival;
            const LANES(court_bridge_refine_out) _o114 =
                LANES(court_bridge_refine)(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            refined = _o114.time;
            V rate = _o114.rate;
            const LANES(court_polished_out) _o115 =
                LANES(court_polished)(arrival, certain, refined);
            arrival = _o115.arrival;
            const LANES(court_bridge_margins_out) _o116 =
                LANES(court_bridge_margins)(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            flat = _o116.margin;
            tilt = _o116.leaving_margin;
            V rate_margin = _o116.rate_margin;
            const LANES(court_own_margin_out) _o117 =
                LANES(court_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o117.margin;
            const LANES(court_crossing_out) _o118 =
                LANES(court_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o118.clearance;
            V delay = _o118.delay;
            const LANES(court_landed_out) _o119 =
                LANES(court_landed)(arrival);
            V time = _o119.time;
            const LANES(court_landed_surely_out) _o120 =
                LANES(court_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o120.delay;
            doubt = _o120.doubt;
            const LANES(court_tied_out) _o121 =
                LANES(court_tied)(arrives, delay, doubt, late, time, when);
            doubt = _o121.doubt;
            late = _o121.late;
            const LANES(court_sooner_out) _o122 =
                LANES(court_sooner)(arrives, K(2.0), time, when, which);
            when = _o122.when;
            which = _o122.which;
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
            V last = lanes_load(lists->last + i);
            V late = lanes_load(lists->late + i);
            M limited = lanes_less(K(0.0), lanes_load(lists->limited + i));
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
            V speed = lanes_load(lists->speed + i);
            V spin_claim = lanes_load(lists->spin_claim + i);
            V through = lanes_load(lists->through + i);
            V time_claim = lanes_load(lists->time_claim + i);
            V time_error = lanes_load(lists->time_error + i);
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
            const M _m123 = lanes_both(rows, limited);
            if (lanes_any(_m123)) {
                const LANES(court_expiry_out) _o124 =
                    LANES(court_expiry)(clock, doubt, late, time_error, time_limit, when, which);
                V time = _o124.time;
                V delay = _o124.delay;
                M arrives = _o124.arrives;
                doubt = lanes_select(_m123, _o124.doubt, doubt);
                const LANES(court_tied_out) _o125 =
                    LANES(court_tied)(arrives, delay, doubt, late, time, when);
                doubt = lanes_select(_m123, _o125.doubt, doubt);
                late = lanes_select(_m123, _o125.late, late);
                const LANES(court_sooner_out) _o126 =
                    LANES(court_sooner)(arrives, K(4.0), time, when, which);
                when = lanes_select(_m123, _o126.when, when);
                which = lanes_select(_m123, _o126.which, which);
            }
            const LANES(court_departed_out) _o127 =
                LANES(court_departed)(K(3.0), which);
            M moves = _o127.moves;
            M ends = _o127.ends;
            M touches = _o127.touches;
            V reached = _o127.reached;
            M edge = _o127.edge;
            const LANES(court_body_of_out) _o128 =
                LANES(court_body_of)(which);
            V body = _o128.body;
            const M _m129 = lanes_both(rows, moves);
            if (lanes_any(_m129)) {
                const LANES(court_passing_doubt_out) _o130 =
                    LANES(court_passing_doubt)(when, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ring_radius, p_gravity);
                M unsure = _o130.unsure;
                const LANES(court_undecided_out) _o131 =
                    LANES(court_undecided)(uncertain, unsure);
                uncertain = lanes_select(_m129, _o131.uncertain, uncertain);
                const LANES(court_passing_out) _o132 =
                    LANES(court_passing)(through, when, x, y, z, vx, vy, vz, p_ring_radius, p_gravity);
                through = lanes_select(_m129, _o132.through, through);
                const LANES(court_flight_out) _o133 =
                    LANES(court_flight)(when, x, y, z, vx, vy, vz, p_gravity);
                x = lanes_select(_m129, _o133.x, x);
                y = lanes_select(_m129, _o133.y, y);
                z = lanes_select(_m129, _o133.z, z);
                vx = lanes_select(_m129, _o133.vx, vx);
                vy = lanes_select(_m129, _o133.vy, vy);
                vz = lanes_select(_m129, _o133.vz, vz);
                const LANES(court_ticked_out) _o134 =
                    LANES(court_ticked)(clock, when);
                clock = lanes_select(_m129, _o134.clock, clock);
            }
            const M _m135 = lanes_both(rows, limited);
            if (lanes_any(_m135)) {
                const LANES(court_expired_out) _o136 =
                    LANES(court_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
                clock = lanes_select(_m135, _o136.clock, clock);
                body = lanes_select(_m135, _o136.body, body);
                reached = lanes_select(_m135, _o136.reached, reached);
                ends = lanes_choose(_m135, _o136.ends, ends);
            }
            const LANES(court_displacement_out) _o137 =
                LANES(court_displacement)(late, when, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_gravity, p_end_depth);
            V slack = _o137.margin;
            const LANES(court_here_out) _o138 =
                LANES(court_here)(K(3.0), which);
            M here = _o138.here;
            const M _m139 = lanes_both(rows, here);
            {
                const LANES(court_end_bounds_out) _o140 =
                    LANES(court_end_bounds)(x, y, p_ring_radius);
                V g0 = _o140.g0;
                const LANES(court_end_reached_out) _o141 =
                    LANES(court_end_reached)(g0, through);
                reached = lanes_select(_m139, _o141.reached, reached);
                const LANES(court_end_edge_out) _o142 =
                    LANES(court_end_edge)(g0, slack, through);
                edge = lanes_choose(_m139, _o142.edge, edge);
            }
            const LANES(court_doubted_out) _o143 =
                LANES(court_doubted)(doubt, edge, late, uncertain, when);
            uncertain = _o143.uncertain;
            const LANES(court_accounted_out) _o144 =
                LANES(court_accounted)(contacts, most_contacts, reached, touches);
            contacts = _o144.contacts;
            V outcome = _o144.outcome;
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
            const LANES(court_meeting_out) _o145 =
                LANES(court_meeting)(claims, ends, touches);
            M meeting = _o145.meeting;
            const M _m146 = lanes_both(rows, meeting);
            if (lanes_any(_m146)) {
                const LANES(court_end_normal_out) _o147 =
                    LANES(court_end_normal)();
                V nx = _o147.nx;
                V ny = _o147.ny;
                V nz = _o147.nz;
                const LANES(court_here_out) _o148 =
                    LANES(court_here)(K(0.0), which);
                M here = _o148.here;
                const M _m149 = lanes_both(_m146, here);
                {
                    const LANES(court_ring_normal_out) _o150 =
                        LANES(court_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = lanes_select(_m149, _o150.nx, nx);
                    ny = lanes_select(_m149, _o150.ny, ny);
                    nz = lanes_select(_m149, _o150.nz, nz);
                    const LANES(court_counted_out) _o151 =
                        LANES(court_counted)(count_0);
                    count_0 = lanes_select(_m149, _o151.count, count_0);
                }
                const LANES(court_here_out) _o152 =
                    LANES(court_here)(K(1.0), which);
                here = _o152.here;
                const M _m153 = lanes_both(_m146, here);
                {
                    const LANES(court_backboard_normal_out) _o154 =
                        LANES(court_backboard_normal)(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = lanes_select(_m153, _o154.nx, nx);
                    ny = lanes_select(_m153, _o154.ny, ny);
                    nz = lanes_select(_m153, _o154.nz, nz);
                    const LANES(court_counted_out) _o155 =
                        LANES(court_counted)(count_1);
                    count_1 = lanes_select(_m153, _o155.count, count_1);
                }
                const LANES(court_here_out) _o156 =
                    LANES(court_here)(K(2.0), which);
                here = _o156.here;
                const M _m157 = lanes_both(_m146, here);
                {
                    const LANES(court_bridge_normal_out) _o158 =
                        LANES(court_bridge_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = lanes_select(_m157, _o158.nx, nx);
                    ny = lanes_select(_m157, _o158.ny, ny);
                    nz = lanes_select(_m157, _o158.nz, nz);
                    const LANES(court_counted_out) _o159 =
                        LANES(court_counted)(count_2);
                    count_2 = lanes_select(_m157, _o159.count, count_2);
                }
                const LANES(court_elsewhere_out) _o160 =
                    LANES(court_elsewhere)();
                V curving = _o160.curving;
                const LANES(court_again_out) _o161 =
                    LANES(court_again)(K(0.0), last, which);
                M again = _o161.again;
                const M _m162 = lanes_both(_m146, again);
                {
                    const LANES(court_ring_curvature_out) _o163 =
                        LANES(court_ring_curvature)(p_ball_radius, p_ring_radius, p_wire_radius);
                    curving = lanes_select(_m162, _o163.curvature, curving);
                }
                const LANES(court_again_out) _o164 =
                    LANES(court_again)(K(1.0), last, which);
                again = _o164.again;
                const M _m165 = lanes_both(_m146, again);
                {
                    const LANES(court_backboard_curvature_out) _o166 =
                        LANES(court_backboard_curvature)(p_ball_radius);
                    curving = lanes_select(_m165, _o166.curvature, curving);
                }
                const LANES(court_again_out) _o167 =
                    LANES(court_again)(K(2.0), last, which);
                again = _o167.again;
                const M _m168 = lanes_both(_m146, again);
                {
                    const LANES(court_bridge_curvature_out) _o169 =
                        LANES(court_bridge_curvature)(p_ball_radius);
                    curving = lanes_select(_m168, _o169.curvature, curving);
                }
                const LANES(court_carry_flight_out) _o170 =
                    LANES(court_carry_flight)(when, x, y, z, vx, vy, vz, nx, ny, nz, clock, contacts, late, dx, dy, dz, dvx, dvy, dvz, curving, p_gravity);
                dx = lanes_select(_m146, _o170.dx, dx);
                dy = lanes_select(_m146, _o170.dy, dy);
                dz = lanes_select(_m146, _o170.dz, dz);
                dvx = lanes_select(_m146, _o170.dvx, dvx);
                dvy = lanes_select(_m146, _o170.dvy, dvy);
                dvz = lanes_select(_m146, _o170.dvz, dvz);
                V delay = _o170.delay;
                V shift = _o170.shift;
                const LANES(court_delayed_out) _o171 =
                    LANES(court_delayed)(clock_error, delay);
                clock_error = lanes_select(_m146, _o171.clock_error, clock_error);
                const M _m172 = lanes_both(_m146, ends);
                {
                    const LANES(court_floored_out) _o173 =
                        LANES(court_floored)(dx, dy, dz, shift);
                    dx = lanes_select(_m172, _o173.dx, dx);
                    dy = lanes_select(_m172, _o173.dy, dy);
                    dz = lanes_select(_m172, _o173.dz, dz);
                }
                const LANES(court_unturned_out) _o174 =
                    LANES(court_unturned)();
                V dnx = _o174.dnx;
                V dny = _o174.dny;
                V dnz = _o174.dnz;
                V turn = _o174.turn;
                const LANES(court_here_out) _o175 =
                    LANES(court_here)(K(0.0), which);
                here = _o175.here;
                const M _m176 = lanes_both(_m146, here);
                if (lanes_any(_m176)) {
                    const LANES(court_ring_carry_normal_out) _o177 =
                        LANES(court_ring_carry_normal)(x, y, dx, dy, dz, shift, p_ball_radius, p_ring_radius, p_wire_radius);
                    dnx = lanes_select(_m176, _o177.dnx, dnx);
                    dny = lanes_select(_m176, _o177.dny, dny);
                    dnz = lanes_select(_m176, _o177.dnz, dnz);
                    turn = lanes_select(_m176, _o177.turn, turn);
                }
                const LANES(court_here_out) _o178 =
                    LANES(court_here)(K(1.0), which);
                here = _o178.here;
                const M _m179 = lanes_both(_m146, here);
                {
                    const LANES(court_backboard_carry_normal_out) _o180 =
                        LANES(court_backboard_carry_normal)(x, y, z, dx, dy, dz, shift, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    dnx = lanes_select(_m179, _o180.dnx, dnx);
                    dny = lanes_select(_m179, _o180.dny, dny);
                    dnz = lanes_select(_m179, _o180.dnz, dnz);
                    turn = lanes_select(_m179, _o180.turn, turn);
                }
                const LANES(court_here_out) _o181 =
                    LANES(court_here)(K(2.0), which);
                here = _o181.here;
                const M _m182 = lanes_both(_m146, here);
                {
                    const LANES(court_bridge_carry_normal_out) _o183 =
                        LANES(court_bridge_carry_normal)(x, y, z, dx, dy, dz, shift, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    dnx = lanes_select(_m182, _o183.dnx, dnx);
                    dny = lanes_select(_m182, _o183.dny, dny);
                    dnz = lanes_select(_m182, _o183.dnz, dnz);
                    turn = lanes_select(_m182, _o183.turn, turn);
                }
                const LANES(court_here_out) _o184 =
                    LANES(court_here)(K(0.0), which);
                here = _o184.here;
                const M _m185 = lanes_both(_m146, here);
                if (lanes_any(_m185)) {
                    const LANES(court_ring_impact_doubt_out) _o186 =
                        LANES(court_ring_impact_doubt)(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, turn, p_ball_radius, p_ring_restitution, p_ring_friction, p_tangential_restitution, p_restitution_speed);
                    M unsure = _o186.unsure;
                    const LANES(court_undecided_out) _o187 =
                        LANES(court_undecided)(uncertain, unsure);
                    uncertain = lanes_select(_m185, _o187.uncertain, uncertain);
                    const LANES(court_carry_ring_impact_out) _o188 =
                        LANES(court_carry_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, contacts, dvx, dvy, dvz, dwx, dwy, dwz, dnx, dny, dnz, turn, p_ball_radius, p_ring_restitution, p_ring_friction, p_tangential_restitution, p_restitution_speed);
                    dvx = lanes_select(_m185, _o188.dvx, dvx);
                    dvy = lanes_select(_m185, _o188.dvy, dvy);
                    dvz = lanes_select(_m185, _o188.dvz, dvz);
                    dwx = lanes_select(_m185, _o188.dwx, dwx);
                    dwy = lanes_select(_m185, _o188.dwy, dwy);
                    dwz = lanes_select(_m185, _o188.dwz, dwz);
                    const LANES(court_ring_impact_out) _o189 =
                        LANES(court_ring_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, p_ring_restitution, p_ring_friction, p_tangential_restitution, p_restitution_speed);
                    vx = lanes_select(_m185, _o189.vx, vx);
                    vy = lanes_select(_m185, _o189.vy, vy);
                    vz = lanes_select(_m185, _o189.vz, vz);
                    wx = lanes_select(_m185, _o189.wx, wx);
                    wy = lanes_select(_m185, _o189.wy, wy);
                    wz = lanes_select(_m185, _o189.wz, wz);
                }
                const LANES(court_here_out) _o190 =
                    LANES(court_here)(K(1.0), which);
                here = _o190.here;
                const M _m191 = lanes_both(_m146, here);
                if (lanes_any(_m191)) {
                    const LANES(court_backboard_impact_doubt_out) _o192 =
                        LANES(court_backboard_impact_doubt)(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, turn, p_ball_radius, p_backboard_restitution, p_backboard_friction, p_tangential_restitution, p_restitution_speed);
                    M unsure = _o192.unsure;
                    const LANES(court_undecided_out) _o193 =
                        LANES(court_undecided)(uncertain, unsure);
                    uncertain = lanes_select(_m191, _o193.uncertain, uncertain);
                    const LANES(court_carry_backboard_impact_out) _o194 =
                        LANES(court_carry_backboard_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, contacts, dvx, dvy, dvz, dwx, dwy, dwz, dnx, dny, dnz, turn, p_ball_radius, p_backboard_restitution, p_backboard_friction, p_tangential_restitution, p_restitution_speed);
                    dvx = lanes_select(_m191, _o194.dvx, dvx);
                    dvy = lanes_select(_m191, _o194.dvy, dvy);
                    dvz = lanes_select(_m191, _o194.dvz, dvz);
                    dwx = lanes_select(_m191, _o194.dwx, dwx);
                    dwy = lanes_select(_m191, _o194.dwy, dwy);
                    dwz = lanes_select(_m191, _o194.dwz, dwz);
                    const LANES(court_backboard_impact_out) _o195 =
                        LANES(court_backboard_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, p_backboard_restitution, p_backboard_friction, p_tangential_restitution, p_restitution_speed);
                    vx = lanes_select(_m191, _o195.vx, vx);
                    vy = lanes_select(_m191, _o195.vy, vy);
                    vz = lanes_select(_m191, _o195.vz, vz);
                    wx = lanes_select(_m191, _o195.wx, wx);
                    wy = lanes_select(_m191, _o195.wy, wy);
                    wz = lanes_select(_m191, _o195.wz, wz);
                }
                const LANES(court_here_out) _o196 =
                    LANES(court_here)(K(2.0), which);
                here = _o196.here;
                const M _m197 = lanes_both(_m146, here);
                if (lanes_any(_m197)) {
                    const LANES(court_bridge_impact_doubt_out) _o198 =
                        LANES(court_bridge_impact_doubt)(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, turn, p_ball_radius, p_bridge_restitution, p_bridge_friction, p_tangential_restitution, p_restitution_speed);
                    M unsure = _o198.unsure;
                    const LANES(court_undecided_out) _o199 =
                        LANES(court_undecided)(uncertain, unsure);
                    uncertain = lanes_select(_m197, _o199.uncertain, uncertain);
                    const LANES(court_carry_bridge_impact_out) _o200 =
                        LANES(court_carry_bridge_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, contacts, dvx, dvy, dvz, dwx, dwy, dwz, dnx, dny, dnz, turn, p_ball_radius, p_bridge_restitution, p_bridge_friction, p_tangential_restitution, p_restitution_speed);
                    dvx = lanes_select(_m197, _o200.dvx, dvx);
                    dvy = lanes_select(_m197, _o200.dvy, dvy);
                    dvz = lanes_select(_m197, _o200.dvz, dvz);
                    dwx = lanes_select(_m197, _o200.dwx, dwx);
                    dwy = lanes_select(_m197, _o200.dwy, dwy);
                    dwz = lanes_select(_m197, _o200.dwz, dwz);
                    const LANES(court_bridge_impact_out) _o201 =
                        LANES(court_bridge_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, p_bridge_restitution, p_bridge_friction, p_tangential_restitution, p_restitution_speed);
                    vx = lanes_select(_m197, _o201.vx, vx);
                    vy = lanes_select(_m197, _o201.vy, vy);
                    vz = lanes_select(_m197, _o201.vz, vz);
                    wx = lanes_select(_m197, _o201.wx, wx);
                    wy = lanes_select(_m197, _o201.wy, wy);
                    wz = lanes_select(_m197, _o201.wz, wz);
                }
                const M _m202 = lanes_both(_m146, touches);
                {
                    const LANES(court_touched_out) _o203 =
                        LANES(court_touched)(body, first, which);
                    first = lanes_select(_m202, _o203.first, first);
                    last = lanes_select(_m202, _o203.last, last);
                }
            }
            const M _m204 = lanes_both(rows, limited);
            if (lanes_any(_m204)) {
                const LANES(court_timed_out) _o205 =
                    LANES(court_timed)(claims, K(4.0), which);
                M timed = _o205.timed;
                const M _m206 = lanes_both(_m204, timed);
                if (lanes_any(_m206)) {
                    const LANES(court_carry_time_out) _o207 =
                        LANES(court_carry_time)(when, x, y, z, vx, vy, vz, clock, clock_error, dx, dy, dz, dvx, dvy, dvz, p_gravity);
                    dx = lanes_select(_m206, _o207.dx, dx);
                    dy = lanes_select(_m206, _o207.dy, dy);
                    dz = lanes_select(_m206, _o207.dz, dz);
                    dvx = lanes_select(_m206, _o207.dvx, dvx);
                    dvy = lanes_select(_m206, _o207.dvy, dvy);
                    dvz = lanes_select(_m206, _o207.dvz, dvz);
                    clock_error = lanes_select(_m206, _o207.clock_error, clock_error);
                }
            }
            const LANES(court_closing_out) _o208 =
                LANES(court_closing)(claims, outcome);
            M closed = _o208.closed;
            const M _m209 = lanes_both(rows, closed);
            {
                const LANES(court_claimed_errors_out) _o210 =
                    LANES(court_claimed_errors)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
                position_claim = lanes_select(_m209, _o210.position_error, position_claim);
                velocity_claim = lanes_select(_m209, _o210.velocity_error, velocity_claim);
                spin_claim = lanes_select(_m209, _o210.spin_error, spin_claim);
                time_claim = lanes_select(_m209, _o210.time_error, time_claim);
            }
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
            lanes_store(lists->last + i, last);
            lanes_store(lists->outcome + i, outcome);
            lanes_store(lists->position_claim + i, position_claim);
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
                const size_t shot = lists->shot[k];
                int32_t *used = job->results->event_counts + shot;
                court_event *event = job->results->events + shot * ((size_t)job->max_contacts + 1) + (size_t)(*used)++;
                event->shot = (int64_t)shot;
                event->surface = (int64_t)lists->body[k];
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
    if (out->time_error || out->state_error || out->uncertain)
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
