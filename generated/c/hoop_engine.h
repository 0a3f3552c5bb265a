/* The event loop of the scene hoop, LANES_WIDTH shots abreast.

   Generated from templates/c/engine.h.j2, scene hoop, derivation be2a322387c8577d,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Included by hoop.c once for every width. A lane holds a shot; when it ends, the next one takes
   its place. No lane's result depends on its neighbours. */

#include "hoop_lanes.h"
#include "hoop_kernels.h"

/* Shots in flight, a row of lanes for each quantity. */
typedef struct {
    double x[LANES_WIDTH]; /* of the state */
    double y[LANES_WIDTH]; /* of the state */
    double z[LANES_WIDTH]; /* of the state */
    double vx[LANES_WIDTH]; /* of the state */
    double vy[LANES_WIDTH]; /* of the state */
    double vz[LANES_WIDTH]; /* of the state */
    double wx[LANES_WIDTH]; /* of the state */
    double wy[LANES_WIDTH]; /* of the state */
    double wz[LANES_WIDTH]; /* of the state */
    double dx[LANES_WIDTH]; /* carried error of x */
    double dy[LANES_WIDTH]; /* carried error of y */
    double dz[LANES_WIDTH]; /* carried error of z */
    double dvx[LANES_WIDTH]; /* carried error of vx */
    double dvy[LANES_WIDTH]; /* carried error of vy */
    double dvz[LANES_WIDTH]; /* carried error of vz */
    double dwx[LANES_WIDTH]; /* carried error of wx */
    double dwy[LANES_WIDTH]; /* carried error of wy */
    double dwz[LANES_WIDTH]; /* carried error of wz */
    double clock[LANES_WIDTH]; /* time of the last event, s since the release */
    double clock_error[LANES_WIDTH]; /* what the contacts' times were off by, summed */
    double last[LANES_WIDTH]; /* surface that was touched last, -1: none */
    double first[LANES_WIDTH]; /* body that was touched first, -1: none */
    double contacts[LANES_WIDTH]; /* how many contacts there were */
    double count_0[LANES_WIDTH]; /* contacts with ring */
    double count_1[LANES_WIDTH]; /* contacts with backboard */
    double count_2[LANES_WIDTH]; /* contacts with bridge */
    double uncertain[LANES_WIDTH]; /* 1: a decision lies within its rounding-error bound */
    double position_claim[LANES_WIDTH]; /* bound on the error at the end */
    double velocity_claim[LANES_WIDTH]; /* bound on the error at the end */
    double spin_claim[LANES_WIDTH]; /* bound on the error at the end */
    double time_claim[LANES_WIDTH]; /* bound on the error at the end */
    double outcome[LANES_WIDTH]; /* how it ended, -1: in flight */
    double p_ball_radius[LANES_WIDTH], p_ring_radius[LANES_WIDTH], p_wire_radius[LANES_WIDTH], p_board_distance[LANES_WIDTH], p_board_half_width[LANES_WIDTH], p_board_bottom[LANES_WIDTH], p_board_top[LANES_WIDTH], p_bridge_half_width[LANES_WIDTH], p_restitution[LANES_WIDTH], p_gravity[LANES_WIDTH], p_end_depth[LANES_WIDTH];
    double from[LANES_WIDTH];     /* surface that the shot starts on, -1: none */
    double occupied[LANES_WIDTH]; /* 1: holds a shot */
    double fresh[LANES_WIDTH];    /* 1: and has not been looked at */
    size_t shot[LANES_WIDTH];
} LANES(hoop_pool);

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

/* Put the next shot into a lane; all that has a start of its own is set when it is first looked at. */
LANES_INLINE void LANES(hoop_begin)(LANES(hoop_pool) *pool, int lane, const hoop_job *job, size_t shot)
{
    const double *state = job->states + HOOP_STATE * shot;
    pool->x[lane] = state[0];
    pool->y[lane] = state[1];
    pool->z[lane] = state[2];
    pool->vx[lane] = state[3];
    pool->vy[lane] = state[4];
    pool->vz[lane] = state[5];
    pool->wx[lane] = state[6];
    pool->wy[lane] = state[7];
    pool->wz[lane] = state[8];
    if (job->varying) {
        pool->p_ball_radius[lane] = job->parameters[0][job->strides[0] * (int64_t)shot];
        pool->p_ring_radius[lane] = job->parameters[1][job->strides[1] * (int64_t)shot];
        pool->p_wire_radius[lane] = job->parameters[2][job->strides[2] * (int64_t)shot];
        pool->p_board_distance[lane] = job->parameters[3][job->strides[3] * (int64_t)shot];
        pool->p_board_half_width[lane] = job->parameters[4][job->strides[4] * (int64_t)shot];
        pool->p_board_bottom[lane] = job->parameters[5][job->strides[5] * (int64_t)shot];
        pool->p_board_top[lane] = job->parameters[6][job->strides[6] * (int64_t)shot];
        pool->p_bridge_half_width[lane] = job->parameters[7][job->strides[7] * (int64_t)shot];
        pool->p_restitution[lane] = job->parameters[8][job->strides[8] * (int64_t)shot];
        pool->p_gravity[lane] = job->parameters[9][job->strides[9] * (int64_t)shot];
        pool->p_end_depth[lane] = job->parameters[10][job->strides[10] * (int64_t)shot];
    }
    pool->from[lane] = job->leaving ? (double)job->leaving[shot] : -1.0;
    pool->occupied[lane] = 1.0;
    pool->fresh[lane] = 1.0;
    pool->shot[lane] = shot;
}

/* Put the next shots into all lanes. Whole rows are stored: a load of a row that was stored in
   pieces would wait for them. */
LANES_INLINE void LANES(hoop_begin_all)(LANES(hoop_pool) *pool, const hoop_job *job, size_t first)
{
    const double *state = job->states + HOOP_STATE * first;
#ifdef __GNUC__
    for (int line = 0; line < HOOP_STATE * LANES_WIDTH; line += 8)
        __builtin_prefetch(state + 4 * HOOP_STATE * LANES_WIDTH + line);
#endif
    lanes_store(pool->x, lanes_gather(state + 0, HOOP_STATE));
    lanes_store(pool->y, lanes_gather(state + 1, HOOP_STATE));
    lanes_store(pool->z, lanes_gather(state + 2, HOOP_STATE));
    lanes_store(pool->vx, lanes_gather(state + 3, HOOP_STATE));
    lanes_store(pool->vy, lanes_gather(state + 4, HOOP_STATE));
    lanes_store(pool->vz, lanes_gather(state + 5, HOOP_STATE));
    lanes_store(pool->wx, lanes_gather(state + 6, HOOP_STATE));
    lanes_store(pool->wy, lanes_gather(state + 7, HOOP_STATE));
    lanes_store(pool->wz, lanes_gather(state + 8, HOOP_STATE));
    if (job->varying) {
        lanes_store(pool->p_ball_radius, lanes_gather(job->parameters[0] + job->strides[0] * (int64_t)first, job->strides[0]));
        lanes_store(pool->p_ring_radius, lanes_gather(job->parameters[1] + job->strides[1] * (int64_t)first, job->strides[1]));
        lanes_store(pool->p_wire_radius, lanes_gather(job->parameters[2] + job->strides[2] * (int64_t)first, job->strides[2]));
        lanes_store(pool->p_board_distance, lanes_gather(job->parameters[3] + job->strides[3] * (int64_t)first, job->strides[3]));
        lanes_store(pool->p_board_half_width, lanes_gather(job->parameters[4] + job->strides[4] * (int64_t)first, job->strides[4]));
        lanes_store(pool->p_board_bottom, lanes_gather(job->parameters[5] + job->strides[5] * (int64_t)first, job->strides[5]));
        lanes_store(pool->p_board_top, lanes_gather(job->parameters[6] + job->strides[6] * (int64_t)first, job->strides[6]));
        lanes_store(pool->p_bridge_half_width, lanes_gather(job->parameters[7] + job->strides[7] * (int64_t)first, job->strides[7]));
        lanes_store(pool->p_restitution, lanes_gather(job->parameters[8] + job->strides[8] * (int64_t)first, job->strides[8]));
        lanes_store(pool->p_gravity, lanes_gather(job->parameters[9] + job->strides[9] * (int64_t)first, job->strides[9]));
        lanes_store(pool->p_end_depth, lanes_gather(job->parameters[10] + job->strides[10] * (int64_t)first, job->strides[10]));
    }
    for (int lane = 0; lane < LANES_WIDTH; lane++) {
        pool->from[lane] = job->leaving ? (double)job->leaving[first + (size_t)lane] : -1.0;
        pool->shot[lane] = first + (size_t)lane;
    }
    lanes_store(pool->occupied, K(1.0));
    lanes_store(pool->fresh, K(1.0));
}

/* Write the results of the shot in a lane and free it. */
LANES_INLINE void LANES(hoop_finish)(LANES(hoop_pool) *pool, int lane, const hoop_job *job)
{
    const hoop_results *out = job->results;
    const size_t shot = pool->shot[lane];
    const int invalid = (int)pool->outcome[lane] == HOOP_OUTCOME_INVALID;
    if (out->outcome) {
        out->outcome[shot] = (uint8_t)pool->outcome[lane];
    }
    if (out->contacts) {
        out->contacts[shot] = (int32_t)pool->contacts[lane];
    }
    if (out->counts) {
        out->counts[3 * shot + 0] = (int32_t)pool->count_0[lane];
        out->counts[3 * shot + 1] = (int32_t)pool->count_1[lane];
        out->counts[3 * shot + 2] = (int32_t)pool->count_2[lane];
    }
    if (out->first) {
        out->first[shot] = (int8_t)pool->first[lane];
    }
    if (out->time) {
        out->time[shot] = invalid ? NAN : pool->clock[lane];
    }
    if (out->state) {
        out->state[9 * shot + 0] = invalid ? NAN : pool->x[lane];
        out->state[9 * shot + 1] = invalid ? NAN : pool->y[lane];
        out->state[9 * shot + 2] = invalid ? NAN : pool->z[lane];
        out->state[9 * shot + 3] = invalid ? NAN : pool->vx[lane];
        out->state[9 * shot + 4] = invalid ? NAN : pool->vy[lane];
        out->state[9 * shot + 5] = invalid ? NAN : pool->vz[lane];
        out->state[9 * shot + 6] = invalid ? NAN : pool->wx[lane];
        out->state[9 * shot + 7] = invalid ? NAN : pool->wy[lane];
        out->state[9 * shot + 8] = invalid ? NAN : pool->wz[lane];
    }
    if (out->time_error) {
        out->time_error[shot] = invalid ? NAN : pool->time_claim[lane];
    }
    if (out->state_error) {
        out->state_error[3 * shot + 0] = invalid ? NAN : pool->position_claim[lane];
        out->state_error[3 * shot + 1] = invalid ? NAN : pool->velocity_claim[lane];
        out->state_error[3 * shot + 2] = invalid ? NAN : pool->spin_claim[lane];
    }
    if (out->uncertain) {
        out->uncertain[shot] = (uint8_t)pool->uncertain[lane];
    }
    pool->occupied[lane] = 0.0;
}

/* Write the results of the shots in all lanes, none of them invalid, which follow one another, and
   free them. */
LANES_INLINE void LANES(hoop_finish_all)(LANES(hoop_pool) *pool, const hoop_job *job)
{
    const hoop_results *out = job->results;
    const size_t first = pool->shot[0];
    if (out->outcome)
        for (int lane = 0; lane < LANES_WIDTH; lane++) {
            out->outcome[first + (size_t)lane] = (uint8_t)pool->outcome[lane];
        }
    if (out->contacts)
        for (int lane = 0; lane < LANES_WIDTH; lane++) {
            out->contacts[first + (size_t)lane] = (int32_t)pool->contacts[lane];
        }
    if (out->counts)
        for (int lane = 0; lane < LANES_WIDTH; lane++) {
            out->counts[3 * (first + (size_t)lane) + 0] = (int32_t)pool->count_0[lane];
            out->counts[3 * (first + (size_t)lane) + 1] = (int32_t)pool->count_1[lane];
            out->counts[3 * (first + (size_t)lane) + 2] = (int32_t)pool->count_2[lane];
        }
    if (out->first)
        for (int lane = 0; lane < LANES_WIDTH; lane++) {
            out->first[first + (size_t)lane] = (int8_t)pool->first[lane];
        }
    if (out->time)
        for (int lane = 0; lane < LANES_WIDTH; lane++) {
            out->time[first + (size_t)lane] = (double)pool->clock[lane];
        }
    if (out->state)
        for (int lane = 0; lane < LANES_WIDTH; lane++) {
            out->state[9 * (first + (size_t)lane) + 0] = (double)pool->x[lane];
            out->state[9 * (first + (size_t)lane) + 1] = (double)pool->y[lane];
            out->state[9 * (first + (size_t)lane) + 2] = (double)pool->z[lane];
            out->state[9 * (first + (size_t)lane) + 3] = (double)pool->vx[lane];
            out->state[9 * (first + (size_t)lane) + 4] = (double)pool->vy[lane];
            out->state[9 * (first + (size_t)lane) + 5] = (double)pool->vz[lane];
            out->state[9 * (first + (size_t)lane) + 6] = (double)pool->wx[lane];
            out->state[9 * (first + (size_t)lane) + 7] = (double)pool->wy[lane];
            out->state[9 * (first + (size_t)lane) + 8] = (double)pool->wz[lane];
        }
    if (out->time_error)
        for (int lane = 0; lane < LANES_WIDTH; lane++) {
            out->time_error[first + (size_t)lane] = (double)pool->time_claim[lane];
        }
    if (out->state_error)
        for (int lane = 0; lane < LANES_WIDTH; lane++) {
            out->state_error[3 * (first + (size_t)lane) + 0] = (double)pool->position_claim[lane];
            out->state_error[3 * (first + (size_t)lane) + 1] = (double)pool->velocity_claim[lane];
            out->state_error[3 * (first + (size_t)lane) + 2] = (double)pool->spin_claim[lane];
        }
    if (out->uncertain)
        for (int lane = 0; lane < LANES_WIDTH; lane++) {
            out->uncertain[first + (size_t)lane] = (uint8_t)pool->uncertain[lane];
        }
    lanes_store(pool->occupied, K(0.0));
}

/* Run the job: fill the lanes, take every lane to its next event, free those that ended.
   No errors are bounded: the same path, with less work. */
LANES_INLINE void LANES(hoop_plain)(const hoop_job *job)
{
    LANES(hoop_pool) pool;
    memset(&pool, 0, sizeof pool);
    const V zero = K(0.0);
    const V most_contacts = K((double)job->max_contacts);
    const V time_limit = K(job->time_limit);
    size_t begun = 0;

    if (job->results->event_counts)
        memset(job->results->event_counts, 0, job->shots * sizeof(int32_t));
    if (!job->varying)
        for (int lane = 0; lane < LANES_WIDTH; lane++) {
            pool.p_ball_radius[lane] = *job->parameters[0];
            pool.p_ring_radius[lane] = *job->parameters[1];
            pool.p_wire_radius[lane] = *job->parameters[2];
            pool.p_board_distance[lane] = *job->parameters[3];
            pool.p_board_half_width[lane] = *job->parameters[4];
            pool.p_board_bottom[lane] = *job->parameters[5];
            pool.p_board_top[lane] = *job->parameters[6];
            pool.p_bridge_half_width[lane] = *job->parameters[7];
            pool.p_restitution[lane] = *job->parameters[8];
            pool.p_gravity[lane] = *job->parameters[9];
            pool.p_end_depth[lane] = *job->parameters[10];
        }
    M permitted = LANES(hoop_permit)(lanes_load(pool.p_ball_radius), lanes_load(pool.p_ring_radius), lanes_load(pool.p_wire_radius), lanes_load(pool.p_board_distance), lanes_load(pool.p_board_half_width), lanes_load(pool.p_board_bottom), lanes_load(pool.p_board_top), lanes_load(pool.p_bridge_half_width), lanes_load(pool.p_restitution), lanes_load(pool.p_gravity), lanes_load(pool.p_end_depth));
    int following = 0; /* whether the lanes hold shots that follow one another */
    for (int flights = 0;;) {
        int refilled = 0;
        if (job->stop && *job->stop)
            return;
        if (flights == 0 && job->shots - begun >= LANES_WIDTH) {
            LANES(hoop_begin_all)(&pool, job, begun);
            begun += LANES_WIDTH;
            flights = LANES_WIDTH;
            refilled = following = 1;
        }
        for (int lane = 0; flights < LANES_WIDTH && begun < job->shots; lane++)
            if (pool.occupied[lane] == 0.0) {
                LANES(hoop_begin)(&pool, lane, job, begun++);
                flights++;
                refilled = 1;
                following = 0;
            }
        if (flights == 0)
            return;

        const V p_ball_radius = lanes_load(pool.p_ball_radius);
        const V p_ring_radius = lanes_load(pool.p_ring_radius);
        const V p_wire_radius = lanes_load(pool.p_wire_radius);
        const V p_board_distance = lanes_load(pool.p_board_distance);
        const V p_board_half_width = lanes_load(pool.p_board_half_width);
        const V p_board_bottom = lanes_load(pool.p_board_bottom);
        const V p_board_top = lanes_load(pool.p_board_top);
        const V p_bridge_half_width = lanes_load(pool.p_bridge_half_width);
        const V p_restitution = lanes_load(pool.p_restitution);
        const V p_gravity = lanes_load(pool.p_gravity);
        const V p_end_depth = lanes_load(pool.p_end_depth);
        V x = lanes_load(pool.x);
        V y = lanes_load(pool.y);
        V z = lanes_load(pool.z);
        V vx = lanes_load(pool.vx);
        V vy = lanes_load(pool.vy);
        V vz = lanes_load(pool.vz);
        V wx = lanes_load(pool.wx);
        V wy = lanes_load(pool.wy);
        V wz = lanes_load(pool.wz);
        V clock = lanes_load(pool.clock);
        V last = lanes_load(pool.last);
        V first = lanes_load(pool.first);
        V contacts = lanes_load(pool.contacts);
        V count_0 = lanes_load(pool.count_0);
        V count_1 = lanes_load(pool.count_1);
        V count_2 = lanes_load(pool.count_2);
        V outcome = lanes_load(pool.outcome);
        const M flying = lanes_less(zero, lanes_load(pool.occupied));

        /* A new shot is looked at once; one that is not valid ends here. */
        if (refilled) {
            const M fresh = lanes_both(flying, lanes_less(zero, lanes_load(pool.fresh)));
            clock = lanes_select(fresh, K(0.0), clock);
            last = lanes_select(fresh, lanes_load(pool.from), last);
            first = lanes_select(fresh, K(-1.0), first);
            contacts = lanes_select(fresh, K(0.0), contacts);
            count_0 = lanes_select(fresh, K(0.0), count_0);
            count_1 = lanes_select(fresh, K(0.0), count_1);
            count_2 = lanes_select(fresh, K(0.0), count_2);
            outcome = lanes_select(fresh, K(-1.0), outcome);

            if (job->varying)
                permitted = LANES(hoop_permit)(p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_restitution, p_gravity, p_end_depth);
            const LANES(hoop_finite_state_out) _o3 =
                LANES(hoop_finite_state)(vx, vy, vz, wx, wy, wz, x, y, z);
            M finite = _o3.finite;
            const LANES(hoop_valid_out) _o4 =
                LANES(hoop_valid)(last, x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_end_depth);
            V valid = _o4.valid;
            const LANES(hoop_admitted_out) _o5 =
                LANES(hoop_admitted)(K(INFINITY), finite, permitted, valid);
            outcome = lanes_select(fresh, _o5.outcome, outcome);
            lanes_store(pool.fresh, zero);
            if (lanes_any(lanes_both(fresh, lanes_at_most(zero, outcome)))) {
                lanes_store(pool.x, x);
                lanes_store(pool.y, y);
                lanes_store(pool.z, z);
                lanes_store(pool.vx, vx);
                lanes_store(pool.vy, vy);
                lanes_store(pool.vz, vz);
                lanes_store(pool.wx, wx);
                lanes_store(pool.wy, wy);
                lanes_store(pool.wz, wz);
                lanes_store(pool.clock, clock);
                lanes_store(pool.last, last);
                lanes_store(pool.first, first);
                lanes_store(pool.contacts, contacts);
                lanes_store(pool.count_0, count_0);
                lanes_store(pool.count_1, count_1);
                lanes_store(pool.count_2, count_2);
                lanes_store(pool.outcome, outcome);
                for (int lane = 0; lane < LANES_WIDTH; lane++)
                    if (pool.outcome[lane] >= 0.0 && pool.occupied[lane] != 0.0) {
                        LANES(hoop_finish)(&pool, lane, job);
                        flights--;
                    }
                continue;
            }
        }

        /* To the next event. */
        const LANES(hoop_error_bounds_out) _o6 =
            LANES(hoop_error_bounds)(K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0));
        V time_error = _o6.time_error;
        const LANES(hoop_scale_out) _o7 =
            LANES(hoop_scale)(x, y, z, vx, vy, vz, p_gravity);
        V extent = _o7.extent;
        V speed = _o7.speed;
        V excess = _o7.excess;
        const LANES(hoop_opening_out) _o8 =
            LANES(hoop_opening)(excess, K(0.0), K(0.0));
        V when = _o8.when;
        V which = _o8.which;
        const LANES(hoop_limited_out) _o9 =
            LANES(hoop_limited)(time_limit);
        M limited = _o9.limited;
        const LANES(hoop_left_out) _o10 =
            LANES(hoop_left)(K(3.0), last);
        V leaving = _o10.leaving;
        const LANES(hoop_end_arrival_out) _o11 =
            LANES(hoop_end_arrival)(leaving, z, vz, p_gravity, p_end_depth);
        V time = _o11.time;
        V rate = _o11.rate;
        V bend = _o11.bend;
        const LANES(hoop_meeting_plane_out) _o12 =
            LANES(hoop_meeting_plane)(bend, rate, time);
        M arrives = _o12.arrives;
        const LANES(hoop_timely_out) _o13 =
            LANES(hoop_timely)(arrives, K(0.0), K(0.0), time, when);
        M possible = _o13.possible;
        const M _m14 = lanes_both(flying, possible);
        {
            const LANES(hoop_sooner_out) _o15 =
                LANES(hoop_sooner)(arrives, K(3.0), time, when, which);
            when = lanes_select(_m14, _o15.when, when);
            which = lanes_select(_m14, _o15.which, which);
        }
        const LANES(hoop_left_out) _o16 =
            LANES(hoop_left)(K(1.0), last);
        leaving = _o16.leaving;
        const LANES(hoop_backboard_arrival_out) _o17 =
            LANES(hoop_backboard_arrival)(leaving, x, vx, p_ball_radius, p_board_distance);
        time = _o17.time;
        rate = _o17.rate;
        bend = _o17.bend;
        const LANES(hoop_meeting_plane_out) _o18 =
            LANES(hoop_meeting_plane)(bend, rate, time);
        arrives = _o18.arrives;
        const LANES(hoop_timely_out) _o19 =
            LANES(hoop_timely)(arrives, K(0.0), K(0.0), time, when);
        possible = _o19.possible;
        const M _m20 = lanes_both(flying, possible);
        {
            const LANES(hoop_flight_out) _o21 =
                LANES(hoop_flight)(time, x, y, z, vx, vy, vz, p_gravity);
            V there_y = _o21.y;
            V there_z = _o21.z;
            const LANES(hoop_backboard_bounds_out) _o22 =
                LANES(hoop_backboard_bounds)(there_y, there_z, p_board_half_width, p_board_bottom, p_board_top);
            V g0 = _o22.g0;
            V g1 = _o22.g1;
            V g2 = _o22.g2;
            V g3 = _o22.g3;
            const LANES(hoop_backboard_within_out) _o23 =
                LANES(hoop_backboard_within)(g0, g1, g2, g3);
            M arrives = _o23.arrives;
            const LANES(hoop_sooner_out) _o24 =
                LANES(hoop_sooner)(arrives, K(1.0), time, when, which);
            when = lanes_select(_m20, _o24.when, when);
            which = lanes_select(_m20, _o24.which, which);
        }
        const LANES(hoop_left_out) _o25 =
            LANES(hoop_left)(K(2.0), last);
        leaving = _o25.leaving;
        const LANES(hoop_bridge_arrival_out) _o26 =
            LANES(hoop_bridge_arrival)(leaving, z, vz, p_ball_radius, p_wire_radius, p_gravity);
        time = _o26.time;
        rate = _o26.rate;
        bend = _o26.bend;
        const LANES(hoop_meeting_plane_out) _o27 =
            LANES(hoop_meeting_plane)(bend, rate, time);
        arrives = _o27.arrives;
        const LANES(hoop_timely_out) _o28 =
            LANES(hoop_timely)(arrives, K(0.0), K(0.0), time, when);
        possible = _o28.possible;
        const M _m29 = lanes_both(flying, possible);
        if (lanes_any(_m29)) {
            const LANES(hoop_flight_out) _o30 =
                LANES(hoop_flight)(time, x, y, z, vx, vy, vz, p_gravity);
            V there_x = _o30.x;
            V there_y = _o30.y;
            const LANES(hoop_bridge_bounds_out) _o31 =
                LANES(hoop_bridge_bounds)(there_x, there_y, p_ring_radius, p_board_distance, p_bridge_half_width);
            V g0 = _o31.g0;
            V g1 = _o31.g1;
            V g2 = _o31.g2;
            V g3 = _o31.g3;
            V g4 = _o31.g4;
            const LANES(hoop_bridge_within_out) _o32 =
                LANES(hoop_bridge_within)(g0, g1, g2, g3, g4);
            M arrives = _o32.arrives;
            const LANES(hoop_sooner_out) _o33 =
                LANES(hoop_sooner)(arrives, K(2.0), time, when, which);
            when = lanes_select(_m29, _o33.when, when);
            which = lanes_select(_m29, _o33.which, which);
        }
        const LANES(hoop_horizon_out) _o34 =
            LANES(hoop_horizon)(when, speed, p_gravity);
        V until = _o34.horizon;
        const LANES(hoop_ring_clear_out) _o35 =
            LANES(hoop_ring_clear)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
        V clear = _o35.clear;
        const LANES(hoop_opens_out) _o36 =
            LANES(hoop_opens)(clear);
        M open = _o36.open;
        const M _m37 = lanes_both(flying, open);
        if (lanes_any(_m37)) {
            const LANES(hoop_ring_prepare_out) _o38 =
                LANES(hoop_ring_prepare)(until, x, y, z, vx, vy, vz, K(0.0), K(0.0), p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
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
            const LANES(hoop_beginning_out) _o39 =
                LANES(hoop_beginning)();
            V share = _o39.share;
            V arrival = _o39.arrival;
            M certain = _o39.certain;
            const LANES(hoop_allowance_out) _o40 =
                LANES(hoop_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
            V position_level = _o40.position_level;
            V velocity_level = _o40.velocity_level;
            const LANES(hoop_ring_margins_out) _o41 =
                LANES(hoop_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V flat = _o41.margin;
            V tilt = _o41.leaving_margin;
            V rate_slack = _o41.rate_margin;
            const LANES(hoop_ring_enter_out) _o42 =
                LANES(hoop_ring_enter)(K(0.0), K(0.0), high0, high1, high2, low0, low1, low2, K(0.0));
            V t = _o42.t;
            V end = _o42.end;
            M searching = _o42.searching;
            for (int _turn = 0; _turn < 201; _turn++) {
                const M _m43 = lanes_both(_m37, searching);
                if (!lanes_any(_m43))
                    break;
                const LANES(hoop_nearby_out) _o44 =
                    LANES(hoop_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = _o44.leaving;
                V margin = _o44.margin;
                const LANES(hoop_ring_advance_out) _o45 =
                    LANES(hoop_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V gap = _o45.gap;
                V rate = _o45.rate;
                V bend = _o45.bend;
                V step = _o45.step;
                V next = _o45.next;
                V root = _o45.root;
                V clearance = _o45.clearance;
                const LANES(hoop_struck_out) _o46 =
                    LANES(hoop_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o46.hit;
                M sure = _o46.sure;
                M vague = _o46.vague;
                const M _m47 = lanes_both(_m43, vague);
                if (lanes_any(_m47)) {
                    const LANES(hoop_finer_out) _o48 =
                        LANES(hoop_finer)(share);
                    share = lanes_select(_m47, _o48.share, share);
                    const LANES(hoop_allowance_out) _o49 =
                        LANES(hoop_allowance)(share, latest, extent, speed, K(0.0), K(0.0), p_gravity);
                    V position_level = _o49.position_level;
                    V velocity_level = _o49.velocity_level;
                    const LANES(hoop_ring_margins_out) _o50 =
                        LANES(hoop_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    flat = lanes_select(_m47, _o50.margin, flat);
                    tilt = lanes_select(_m47, _o50.leaving_margin, tilt);
                    rate_slack = lanes_select(_m47, _o50.rate_margin, rate_slack);
                }
                const LANES(hoop_advanced_out) _o51 =
                    LANES(hoop_advanced)(arrival, certain, end, hit, next, root, step, sure, t, vague);
                arrival = lanes_select(_m43, _o51.arrival, arrival);
                certain = lanes_choose(_m43, _o51.certain, certain);
                M exhausted = _o51.exhausted;
                searching = lanes_choose(_m43, _o51.searching, searching);
                t = lanes_select(_m43, _o51.t, t);
                const M _m52 = lanes_both(_m43, exhausted);
                {
                    const LANES(hoop_ring_enter_out) _o53 =
                        LANES(hoop_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m52, _o53.t, t);
                    end = lanes_select(_m52, _o53.end, end);
                    searching = lanes_choose(_m52, _o53.searching, searching);
                }
            }
            const LANES(hoop_found_out) _o54 =
                LANES(hoop_found)(arrival);
            M arrives = _o54.arrives;
            const LANES(hoop_nearby_out) _o55 =
                LANES(hoop_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o55.leaving;
            const LANES(hoop_ring_refine_out) _o56 =
                LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V refined = _o56.time;
            const LANES(hoop_polished_out) _o57 =
                LANES(hoop_polished)(arrival, certain, refined);
            arrival = _o57.arrival;
            const LANES(hoop_ring_refine_out) _o58 =
                LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            refined = _o58.time;
            const LANES(hoop_polished_out) _o59 =
                LANES(hoop_polished)(arrival, certain, refined);
            arrival = _o59.arrival;
            const LANES(hoop_landed_out) _o60 =
                LANES(hoop_landed)(arrival);
            V time = _o60.time;
            const LANES(hoop_sooner_out) _o61 =
                LANES(hoop_sooner)(arrives, K(0.0), time, when, which);
            when = lanes_select(_m37, _o61.when, when);
            which = lanes_select(_m37, _o61.which, which);
        }
        const M _m62 = lanes_both(flying, limited);
        if (lanes_any(_m62)) {
            const LANES(hoop_expiry_out) _o63 =
                LANES(hoop_expiry)(clock, K(INFINITY), K(0.0), time_error, time_limit, when, which);
            V time = _o63.time;
            M arrives = _o63.arrives;
            const LANES(hoop_sooner_out) _o64 =
                LANES(hoop_sooner)(arrives, K(4.0), time, when, which);
            when = lanes_select(_m62, _o64.when, when);
            which = lanes_select(_m62, _o64.which, which);
        }
        const LANES(hoop_departed_out) _o65 =
            LANES(hoop_departed)(K(3.0), which);
        M moves = _o65.moves;
        M ends = _o65.ends;
        M touches = _o65.touches;
        V reached = _o65.reached;
        const LANES(hoop_body_of_out) _o66 =
            LANES(hoop_body_of)(which);
        V body = _o66.body;
        const M _m67 = lanes_both(flying, moves);
        {
            const LANES(hoop_flight_out) _o68 =
                LANES(hoop_flight)(when, x, y, z, vx, vy, vz, p_gravity);
            x = lanes_select(_m67, _o68.x, x);
            y = lanes_select(_m67, _o68.y, y);
            z = lanes_select(_m67, _o68.z, z);
            vx = lanes_select(_m67, _o68.vx, vx);
            vy = lanes_select(_m67, _o68.vy, vy);
            vz = lanes_select(_m67, _o68.vz, vz);
            const LANES(hoop_ticked_out) _o69 =
                LANES(hoop_ticked)(clock, when);
            clock = lanes_select(_m67, _o69.clock, clock);
        }
        const M _m70 = lanes_both(flying, limited);
        if (lanes_any(_m70)) {
            const LANES(hoop_expired_out) _o71 =
                LANES(hoop_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
            clock = lanes_select(_m70, _o71.clock, clock);
            body = lanes_select(_m70, _o71.body, body);
            reached = lanes_select(_m70, _o71.reached, reached);
            ends = lanes_choose(_m70, _o71.ends, ends);
        }
        const LANES(hoop_here_out) _o72 =
            LANES(hoop_here)(K(3.0), which);
        M here = _o72.here;
        const M _m73 = lanes_both(flying, here);
        {
            const LANES(hoop_end_bounds_out) _o74 =
                LANES(hoop_end_bounds)(x, y, p_ring_radius);
            V g0 = _o74.g0;
            const LANES(hoop_end_reached_out) _o75 =
                LANES(hoop_end_reached)(g0);
            reached = lanes_select(_m73, _o75.reached, reached);
        }
        const LANES(hoop_accounted_out) _o76 =
            LANES(hoop_accounted)(contacts, most_contacts, reached, touches);
        contacts = _o76.contacts;
        outcome = _o76.outcome;
        const V x_before = x;
        const V y_before = y;
        const V z_before = z;
        const V vx_before = vx;
        const V vy_before = vy;
        const V vz_before = vz;
        const V wx_before = wx;
        const V wy_before = wy;
        const V wz_before = wz;

        /* What the event does to the ball. */
        const LANES(hoop_meeting_out) _o77 =
            LANES(hoop_meeting)(K(0.0), ends, touches);
        M meeting = _o77.meeting;
        const M _m78 = lanes_both(flying, meeting);
        if (lanes_any(_m78)) {
            const LANES(hoop_end_normal_out) _o79 =
                LANES(hoop_end_normal)();
            V nx = _o79.nx;
            V ny = _o79.ny;
            V nz = _o79.nz;
            const LANES(hoop_here_out) _o80 =
                LANES(hoop_here)(K(0.0), which);
            M here = _o80.here;
            const M _m81 = lanes_both(_m78, here);
            {
                const LANES(hoop_ring_normal_out) _o82 =
                    LANES(hoop_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                nx = lanes_select(_m81, _o82.nx, nx);
                ny = lanes_select(_m81, _o82.ny, ny);
                nz = lanes_select(_m81, _o82.nz, nz);
                const LANES(hoop_counted_out) _o83 =
                    LANES(hoop_counted)(count_0);
                count_0 = lanes_select(_m81, _o83.count, count_0);
            }
            const LANES(hoop_here_out) _o84 =
                LANES(hoop_here)(K(1.0), which);
            here = _o84.here;
            const M _m85 = lanes_both(_m78, here);
            {
                const LANES(hoop_backboard_normal_out) _o86 =
                    LANES(hoop_backboard_normal)();
                nx = lanes_select(_m85, _o86.nx, nx);
                ny = lanes_select(_m85, _o86.ny, ny);
                nz = lanes_select(_m85, _o86.nz, nz);
                const LANES(hoop_counted_out) _o87 =
                    LANES(hoop_counted)(count_1);
                count_1 = lanes_select(_m85, _o87.count, count_1);
            }
            const LANES(hoop_here_out) _o88 =
                LANES(hoop_here)(K(2.0), which);
            here = _o88.here;
            const M _m89 = lanes_both(_m78, here);
            {
                const LANES(hoop_bridge_normal_out) _o90 =
                    LANES(hoop_bridge_normal)();
                nx = lanes_select(_m89, _o90.nx, nx);
                ny = lanes_select(_m89, _o90.ny, ny);
                nz = lanes_select(_m89, _o90.nz, nz);
                const LANES(hoop_counted_out) _o91 =
                    LANES(hoop_counted)(count_2);
                count_2 = lanes_select(_m89, _o91.count, count_2);
            }
            const M _m92 = lanes_both(_m78, touches);
            if (lanes_any(_m92)) {
                const LANES(hoop_impact_out) _o93 =
                    LANES(hoop_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, p_restitution);
                vx = lanes_select(_m92, _o93.vx, vx);
                vy = lanes_select(_m92, _o93.vy, vy);
                vz = lanes_select(_m92, _o93.vz, vz);
                wx = lanes_select(_m92, _o93.wx, wx);
                wy = lanes_select(_m92, _o93.wy, wy);
                wz = lanes_select(_m92, _o93.wz, wz);
            }
            const LANES(hoop_here_out) _o94 =
                LANES(hoop_here)(K(1.0), which);
            here = _o94.here;
            const M _m95 = lanes_both(_m78, here);
            {
                const LANES(hoop_backboard_place_out) _o96 =
                    LANES(hoop_backboard_place)(y, z, p_ball_radius, p_board_distance);
                x = lanes_select(_m95, _o96.x, x);
                y = lanes_select(_m95, _o96.y, y);
                z = lanes_select(_m95, _o96.z, z);
            }
            const LANES(hoop_here_out) _o97 =
                LANES(hoop_here)(K(2.0), which);
            here = _o97.here;
            const M _m98 = lanes_both(_m78, here);
            {
                const LANES(hoop_bridge_place_out) _o99 =
                    LANES(hoop_bridge_place)(x, y, p_ball_radius, p_wire_radius);
                x = lanes_select(_m98, _o99.x, x);
                y = lanes_select(_m98, _o99.y, y);
                z = lanes_select(_m98, _o99.z, z);
            }
            const M _m100 = lanes_both(_m78, touches);
            {
                const LANES(hoop_touched_out) _o101 =
                    LANES(hoop_touched)(body, first, which);
                first = lanes_select(_m100, _o101.first, first);
                last = lanes_select(_m100, _o101.last, last);
            }
        }
        lanes_store(pool.x, x);
        lanes_store(pool.y, y);
        lanes_store(pool.z, z);
        lanes_store(pool.vx, vx);
        lanes_store(pool.vy, vy);
        lanes_store(pool.vz, vz);
        lanes_store(pool.wx, wx);
        lanes_store(pool.wy, wy);
        lanes_store(pool.wz, wz);
        lanes_store(pool.clock, clock);
        lanes_store(pool.last, last);
        lanes_store(pool.first, first);
        lanes_store(pool.contacts, contacts);
        lanes_store(pool.count_0, count_0);
        lanes_store(pool.count_1, count_1);
        lanes_store(pool.count_2, count_2);
        lanes_store(pool.outcome, outcome);
        if (job->results->events) {
            double surface[LANES_WIDTH];
            double before[HOOP_STATE][LANES_WIDTH];
            lanes_store(surface, body);
            lanes_store(before[0], x_before);
            lanes_store(before[1], y_before);
            lanes_store(before[2], z_before);
            lanes_store(before[3], vx_before);
            lanes_store(before[4], vy_before);
            lanes_store(before[5], vz_before);
            lanes_store(before[6], wx_before);
            lanes_store(before[7], wy_before);
            lanes_store(before[8], wz_before);
            for (int lane = 0; lane < LANES_WIDTH; lane++) {
                if (pool.occupied[lane] == 0.0 || surface[lane] < 0.0)
                    continue;
                const size_t shot = pool.shot[lane];
                int32_t *used = job->results->event_counts + shot;
                hoop_event *event = job->results->events + shot * ((size_t)job->max_contacts + 1) + (size_t)(*used)++;
                event->shot = (int64_t)shot;
                event->surface = (int64_t)surface[lane];
                event->time = pool.clock[lane];
                event->before[0] = before[0][lane];
                event->after[0] = pool.x[lane];
                event->before[1] = before[1][lane];
                event->after[1] = pool.y[lane];
                event->before[2] = before[2][lane];
                event->after[2] = pool.z[lane];
                event->before[3] = before[3][lane];
                event->after[3] = pool.vx[lane];
                event->before[4] = before[4][lane];
                event->after[4] = pool.vy[lane];
                event->before[5] = before[5][lane];
                event->after[5] = pool.vz[lane];
                event->before[6] = before[6][lane];
                event->after[6] = pool.wx[lane];
                event->before[7] = before[7][lane];
                event->after[7] = pool.wy[lane];
                event->before[8] = before[8][lane];
                event->after[8] = pool.wz[lane];
            }
        }
        const M going = lanes_less(outcome, zero);
        if (following && flights == LANES_WIDTH && !lanes_any(going)) {
            LANES(hoop_finish_all)(&pool, job);
            flights = 0;
            continue;
        }
        for (int lane = 0; lane < LANES_WIDTH; lane++)
            if (pool.occupied[lane] != 0.0 && pool.outcome[lane] >= 0.0) {
                LANES(hoop_finish)(&pool, lane, job);
                flights--;
            }
    }
}

/* Run the job: fill the lanes, take every lane to its next event, free those that ended.
   Errors are bounded. */
LANES_INLINE void LANES(hoop_bounded)(const hoop_job *job)
{
    LANES(hoop_pool) pool;
    memset(&pool, 0, sizeof pool);
    const V zero = K(0.0);
    const V most_contacts = K((double)job->max_contacts);
    const V time_limit = K(job->time_limit);
    const V claims = K(job->results->time_error || job->results->state_error ? 1.0 : 0.0);
    size_t begun = 0;

    if (job->results->event_counts)
        memset(job->results->event_counts, 0, job->shots * sizeof(int32_t));
    if (!job->varying)
        for (int lane = 0; lane < LANES_WIDTH; lane++) {
            pool.p_ball_radius[lane] = *job->parameters[0];
            pool.p_ring_radius[lane] = *job->parameters[1];
            pool.p_wire_radius[lane] = *job->parameters[2];
            pool.p_board_distance[lane] = *job->parameters[3];
            pool.p_board_half_width[lane] = *job->parameters[4];
            pool.p_board_bottom[lane] = *job->parameters[5];
            pool.p_board_top[lane] = *job->parameters[6];
            pool.p_bridge_half_width[lane] = *job->parameters[7];
            pool.p_restitution[lane] = *job->parameters[8];
            pool.p_gravity[lane] = *job->parameters[9];
            pool.p_end_depth[lane] = *job->parameters[10];
        }
    M permitted = LANES(hoop_permit)(lanes_load(pool.p_ball_radius), lanes_load(pool.p_ring_radius), lanes_load(pool.p_wire_radius), lanes_load(pool.p_board_distance), lanes_load(pool.p_board_half_width), lanes_load(pool.p_board_bottom), lanes_load(pool.p_board_top), lanes_load(pool.p_bridge_half_width), lanes_load(pool.p_restitution), lanes_load(pool.p_gravity), lanes_load(pool.p_end_depth));
    int following = 0; /* whether the lanes hold shots that follow one another */
    for (int flights = 0;;) {
        int refilled = 0;
        if (job->stop && *job->stop)
            return;
        if (flights == 0 && job->shots - begun >= LANES_WIDTH) {
            LANES(hoop_begin_all)(&pool, job, begun);
            begun += LANES_WIDTH;
            flights = LANES_WIDTH;
            refilled = following = 1;
        }
        for (int lane = 0; flights < LANES_WIDTH && begun < job->shots; lane++)
            if (pool.occupied[lane] == 0.0) {
                LANES(hoop_begin)(&pool, lane, job, begun++);
                flights++;
                refilled = 1;
                following = 0;
            }
        if (flights == 0)
            return;

        const V p_ball_radius = lanes_load(pool.p_ball_radius);
        const V p_ring_radius = lanes_load(pool.p_ring_radius);
        const V p_wire_radius = lanes_load(pool.p_wire_radius);
        const V p_board_distance = lanes_load(pool.p_board_distance);
        const V p_board_half_width = lanes_load(pool.p_board_half_width);
        const V p_board_bottom = lanes_load(pool.p_board_bottom);
        const V p_board_top = lanes_load(pool.p_board_top);
        const V p_bridge_half_width = lanes_load(pool.p_bridge_half_width);
        const V p_restitution = lanes_load(pool.p_restitution);
        const V p_gravity = lanes_load(pool.p_gravity);
        const V p_end_depth = lanes_load(pool.p_end_depth);
        V x = lanes_load(pool.x);
        V y = lanes_load(pool.y);
        V z = lanes_load(pool.z);
        V vx = lanes_load(pool.vx);
        V vy = lanes_load(pool.vy);
        V vz = lanes_load(pool.vz);
        V wx = lanes_load(pool.wx);
        V wy = lanes_load(pool.wy);
        V wz = lanes_load(pool.wz);
        V dx = lanes_load(pool.dx);
        V dy = lanes_load(pool.dy);
        V dz = lanes_load(pool.dz);
        V dvx = lanes_load(pool.dvx);
        V dvy = lanes_load(pool.dvy);
        V dvz = lanes_load(pool.dvz);
        V dwx = lanes_load(pool.dwx);
        V dwy = lanes_load(pool.dwy);
        V dwz = lanes_load(pool.dwz);
        V clock = lanes_load(pool.clock);
        V clock_error = lanes_load(pool.clock_error);
        V last = lanes_load(pool.last);
        V first = lanes_load(pool.first);
        V contacts = lanes_load(pool.contacts);
        V count_0 = lanes_load(pool.count_0);
        V count_1 = lanes_load(pool.count_1);
        V count_2 = lanes_load(pool.count_2);
        V uncertain = lanes_load(pool.uncertain);
        V position_claim = lanes_load(pool.position_claim);
        V velocity_claim = lanes_load(pool.velocity_claim);
        V spin_claim = lanes_load(pool.spin_claim);
        V time_claim = lanes_load(pool.time_claim);
        V outcome = lanes_load(pool.outcome);
        const M flying = lanes_less(zero, lanes_load(pool.occupied));

        /* A new shot is looked at once; one that is not valid ends here. */
        if (refilled) {
            const M fresh = lanes_both(flying, lanes_less(zero, lanes_load(pool.fresh)));
            dx = lanes_select(fresh, K(0.0), dx);
            dy = lanes_select(fresh, K(0.0), dy);
            dz = lanes_select(fresh, K(0.0), dz);
            dvx = lanes_select(fresh, K(0.0), dvx);
            dvy = lanes_select(fresh, K(0.0), dvy);
            dvz = lanes_select(fresh, K(0.0), dvz);
            dwx = lanes_select(fresh, K(0.0), dwx);
            dwy = lanes_select(fresh, K(0.0), dwy);
            dwz = lanes_select(fresh, K(0.0), dwz);
            clock = lanes_select(fresh, K(0.0), clock);
            clock_error = lanes_select(fresh, K(0.0), clock_error);
            last = lanes_select(fresh, lanes_load(pool.from), last);
            first = lanes_select(fresh, K(-1.0), first);
            contacts = lanes_select(fresh, K(0.0), contacts);
            count_0 = lanes_select(fresh, K(0.0), count_0);
            count_1 = lanes_select(fresh, K(0.0), count_1);
            count_2 = lanes_select(fresh, K(0.0), count_2);
            uncertain = lanes_select(fresh, K(0.0), uncertain);
            position_claim = lanes_select(fresh, K(0.0), position_claim);
            velocity_claim = lanes_select(fresh, K(0.0), velocity_claim);
            spin_claim = lanes_select(fresh, K(0.0), spin_claim);
            time_claim = lanes_select(fresh, K(0.0), time_claim);
            outcome = lanes_select(fresh, K(-1.0), outcome);

            if (job->varying)
                permitted = LANES(hoop_permit)(p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_restitution, p_gravity, p_end_depth);
            const LANES(hoop_finite_state_out) _o3 =
                LANES(hoop_finite_state)(vx, vy, vz, wx, wy, wz, x, y, z);
            M finite = _o3.finite;
            const LANES(hoop_valid_out) _o4 =
                LANES(hoop_valid)(last, x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_end_depth);
            V valid = _o4.valid;
            V doubt = _o4.doubt;
            const LANES(hoop_admitted_out) _o5 =
                LANES(hoop_admitted)(doubt, finite, permitted, valid);
            outcome = lanes_select(fresh, _o5.outcome, outcome);
            uncertain = lanes_select(fresh, _o5.uncertain, uncertain);
            lanes_store(pool.fresh, zero);
            if (lanes_any(lanes_both(fresh, lanes_at_most(zero, outcome)))) {
                lanes_store(pool.x, x);
                lanes_store(pool.y, y);
                lanes_store(pool.z, z);
                lanes_store(pool.vx, vx);
                lanes_store(pool.vy, vy);
                lanes_store(pool.vz, vz);
                lanes_store(pool.wx, wx);
                lanes_store(pool.wy, wy);
                lanes_store(pool.wz, wz);
                lanes_store(pool.dx, dx);
                lanes_store(pool.dy, dy);
                lanes_store(pool.dz, dz);
                lanes_store(pool.dvx, dvx);
                lanes_store(pool.dvy, dvy);
                lanes_store(pool.dvz, dvz);
                lanes_store(pool.dwx, dwx);
                lanes_store(pool.dwy, dwy);
                lanes_store(pool.dwz, dwz);
                lanes_store(pool.clock, clock);
                lanes_store(pool.clock_error, clock_error);
                lanes_store(pool.last, last);
                lanes_store(pool.first, first);
                lanes_store(pool.contacts, contacts);
                lanes_store(pool.count_0, count_0);
                lanes_store(pool.count_1, count_1);
                lanes_store(pool.count_2, count_2);
                lanes_store(pool.uncertain, uncertain);
                lanes_store(pool.position_claim, position_claim);
                lanes_store(pool.velocity_claim, velocity_claim);
                lanes_store(pool.spin_claim, spin_claim);
                lanes_store(pool.time_claim, time_claim);
                lanes_store(pool.outcome, outcome);
                for (int lane = 0; lane < LANES_WIDTH; lane++)
                    if (pool.outcome[lane] >= 0.0 && pool.occupied[lane] != 0.0) {
                        LANES(hoop_finish)(&pool, lane, job);
                        flights--;
                    }
                continue;
            }
        }

        /* To the next event. */
        const LANES(hoop_error_bounds_out) _o6 =
            LANES(hoop_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
        V position_error = _o6.position_error;
        V velocity_error = _o6.velocity_error;
        V time_error = _o6.time_error;
        const LANES(hoop_scale_out) _o7 =
            LANES(hoop_scale)(x, y, z, vx, vy, vz, p_gravity);
        V extent = _o7.extent;
        V speed = _o7.speed;
        V excess = _o7.excess;
        const LANES(hoop_opening_out) _o8 =
            LANES(hoop_opening)(excess, position_error, velocity_error);
        V when = _o8.when;
        V which = _o8.which;
        V late = _o8.late;
        V doubt = _o8.doubt;
        const LANES(hoop_limited_out) _o9 =
            LANES(hoop_limited)(time_limit);
        M limited = _o9.limited;
        const LANES(hoop_left_out) _o10 =
            LANES(hoop_left)(K(3.0), last);
        V leaving = _o10.leaving;
        const LANES(hoop_end_arrival_out) _o11 =
            LANES(hoop_end_arrival)(leaving, z, vz, p_gravity, p_end_depth);
        V time = _o11.time;
        V rate = _o11.rate;
        V bend = _o11.bend;
        V apex = _o11.apex;
        V height = _o11.height;
        const LANES(hoop_meeting_plane_out) _o12 =
            LANES(hoop_meeting_plane)(bend, rate, time);
        M arrives = _o12.arrives;
        V ceiling = _o12.ceiling;
        const LANES(hoop_end_margin_out) _o13 =
            LANES(hoop_end_margin)(time, extent, speed, position_error, velocity_error, p_gravity, p_end_depth);
        V margin = _o13.margin;
        const LANES(hoop_crossing_out) _o14 =
            LANES(hoop_crossing)(margin, K(0.0), rate, ceiling);
        V clearance = _o14.clearance;
        V delay = _o14.delay;
        const LANES(hoop_timely_out) _o15 =
            LANES(hoop_timely)(arrives, delay, late, time, when);
        M possible = _o15.possible;
        const LANES(hoop_end_margin_out) _o16 =
            LANES(hoop_end_margin)(apex, extent, speed, position_error, velocity_error, p_gravity, p_end_depth);
        margin = _o16.margin;
        const LANES(hoop_grazed_out) _o17 =
            LANES(hoop_grazed)(apex, doubt, height, margin);
        doubt = _o17.doubt;
        const M _m18 = lanes_both(flying, possible);
        {
            const LANES(hoop_crossed_out) _o19 =
                LANES(hoop_crossed)(arrives, clearance, doubt, time);
            doubt = lanes_select(_m18, _o19.doubt, doubt);
            const LANES(hoop_tied_out) _o20 =
                LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
            doubt = lanes_select(_m18, _o20.doubt, doubt);
            late = lanes_select(_m18, _o20.late, late);
            const LANES(hoop_sooner_out) _o21 =
                LANES(hoop_sooner)(arrives, K(3.0), time, when, which);
            when = lanes_select(_m18, _o21.when, when);
            which = lanes_select(_m18, _o21.which, which);
        }
        const LANES(hoop_left_out) _o22 =
            LANES(hoop_left)(K(1.0), last);
        leaving = _o22.leaving;
        const LANES(hoop_backboard_arrival_out) _o23 =
            LANES(hoop_backboard_arrival)(leaving, x, vx, p_ball_radius, p_board_distance);
        time = _o23.time;
        rate = _o23.rate;
        bend = _o23.bend;
        apex = _o23.apex;
        height = _o23.height;
        const LANES(hoop_meeting_plane_out) _o24 =
            LANES(hoop_meeting_plane)(bend, rate, time);
        arrives = _o24.arrives;
        ceiling = _o24.ceiling;
        const LANES(hoop_backboard_margin_out) _o25 =
            LANES(hoop_backboard_margin)(time, extent, speed, position_error, velocity_error, p_ball_radius, p_board_distance, p_gravity);
        margin = _o25.margin;
        const LANES(hoop_crossing_out) _o26 =
            LANES(hoop_crossing)(margin, K(0.0), rate, ceiling);
        clearance = _o26.clearance;
        delay = _o26.delay;
        const LANES(hoop_timely_out) _o27 =
            LANES(hoop_timely)(arrives, delay, late, time, when);
        possible = _o27.possible;
        const LANES(hoop_backboard_margin_out) _o28 =
            LANES(hoop_backboard_margin)(apex, extent, speed, position_error, velocity_error, p_ball_radius, p_board_distance, p_gravity);
        margin = _o28.margin;
        const LANES(hoop_grazed_out) _o29 =
            LANES(hoop_grazed)(apex, doubt, height, margin);
        doubt = _o29.doubt;
        const M _m30 = lanes_both(flying, possible);
        if (lanes_any(_m30)) {
            const LANES(hoop_flight_out) _o31 =
                LANES(hoop_flight)(time, x, y, z, vx, vy, vz, p_gravity);
            V there_y = _o31.y;
            V there_z = _o31.z;
            const LANES(hoop_backboard_bounds_out) _o32 =
                LANES(hoop_backboard_bounds)(there_y, there_z, p_board_half_width, p_board_bottom, p_board_top);
            V g0 = _o32.g0;
            V g1 = _o32.g1;
            V g2 = _o32.g2;
            V g3 = _o32.g3;
            const LANES(hoop_displacement_out) _o33 =
                LANES(hoop_displacement)(delay, time, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_gravity, p_end_depth);
            V slack = _o33.margin;
            const LANES(hoop_backboard_edges_out) _o34 =
                LANES(hoop_backboard_edges)(clearance, g0, g1, g2, g3, slack);
            M unsure = _o34.unsure;
            const LANES(hoop_questioned_out) _o35 =
                LANES(hoop_questioned)(doubt, time, unsure);
            doubt = lanes_select(_m30, _o35.doubt, doubt);
            const LANES(hoop_backboard_within_out) _o36 =
                LANES(hoop_backboard_within)(g0, g1, g2, g3);
            M arrives = _o36.arrives;
            const LANES(hoop_tied_out) _o37 =
                LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
            doubt = lanes_select(_m30, _o37.doubt, doubt);
            late = lanes_select(_m30, _o37.late, late);
            const LANES(hoop_sooner_out) _o38 =
                LANES(hoop_sooner)(arrives, K(1.0), time, when, which);
            when = lanes_select(_m30, _o38.when, when);
            which = lanes_select(_m30, _o38.which, which);
        }
        const LANES(hoop_left_out) _o39 =
            LANES(hoop_left)(K(2.0), last);
        leaving = _o39.leaving;
        const LANES(hoop_bridge_arrival_out) _o40 =
            LANES(hoop_bridge_arrival)(leaving, z, vz, p_ball_radius, p_wire_radius, p_gravity);
        time = _o40.time;
        rate = _o40.rate;
        bend = _o40.bend;
        apex = _o40.apex;
        height = _o40.height;
        const LANES(hoop_meeting_plane_out) _o41 =
            LANES(hoop_meeting_plane)(bend, rate, time);
        arrives = _o41.arrives;
        ceiling = _o41.ceiling;
        const LANES(hoop_bridge_margin_out) _o42 =
            LANES(hoop_bridge_margin)(time, extent, speed, position_error, velocity_error, p_ball_radius, p_wire_radius, p_gravity);
        margin = _o42.margin;
        const LANES(hoop_crossing_out) _o43 =
            LANES(hoop_crossing)(margin, K(0.0), rate, ceiling);
        clearance = _o43.clearance;
        delay = _o43.delay;
        const LANES(hoop_timely_out) _o44 =
            LANES(hoop_timely)(arrives, delay, late, time, when);
        possible = _o44.possible;
        const LANES(hoop_bridge_margin_out) _o45 =
            LANES(hoop_bridge_margin)(apex, extent, speed, position_error, velocity_error, p_ball_radius, p_wire_radius, p_gravity);
        margin = _o45.margin;
        const LANES(hoop_grazed_out) _o46 =
            LANES(hoop_grazed)(apex, doubt, height, margin);
        doubt = _o46.doubt;
        const M _m47 = lanes_both(flying, possible);
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
                LANES(hoop_displacement)(delay, time, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_gravity, p_end_depth);
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
        const LANES(hoop_horizon_out) _o56 =
            LANES(hoop_horizon)(when, speed, p_gravity);
        V until = _o56.horizon;
        V pad = _o56.pad;
        const LANES(hoop_ring_clear_out) _o57 =
            LANES(hoop_ring_clear)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
        V clear = _o57.clear;
        const LANES(hoop_opens_out) _o58 =
            LANES(hoop_opens)(clear);
        M open = _o58.open;
        const M _m59 = lanes_both(flying, open);
        if (lanes_any(_m59)) {
            const LANES(hoop_ring_prepare_out) _o60 =
                LANES(hoop_ring_prepare)(until, x, y, z, vx, vy, vz, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V steady = _o60.steady;
            V swing = _o60.swing;
            V rho_start = _o60.rho_start;
            V low0 = _o60.low0;
            V high0 = _o60.high0;
            V low1 = _o60.low1;
            V high1 = _o60.high1;
            V low2 = _o60.low2;
            V high2 = _o60.high2;
            V ceiling = _o60.ceiling;
            V latest = _o60.latest;
            V lost = _o60.lost;
            const LANES(hoop_beginning_out) _o61 =
                LANES(hoop_beginning)();
            V share = _o61.share;
            V arrival = _o61.arrival;
            M certain = _o61.certain;
            const LANES(hoop_allowance_out) _o62 =
                LANES(hoop_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
            V position_level = _o62.position_level;
            V velocity_level = _o62.velocity_level;
            V excess = _o62.excess;
            const LANES(hoop_ring_margins_out) _o63 =
                LANES(hoop_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V flat = _o63.margin;
            V tilt = _o63.leaving_margin;
            V rate_slack = _o63.rate_margin;
            const LANES(hoop_beyond_out) _o64 =
                LANES(hoop_beyond)(doubt, excess, late, lost, pad);
            doubt = lanes_select(_m59, _o64.doubt, doubt);
            const LANES(hoop_ring_enter_out) _o65 =
                LANES(hoop_ring_enter)(K(0.0), K(0.0), high0, high1, high2, low0, low1, low2, K(0.0));
            V t = _o65.t;
            V end = _o65.end;
            M searching = _o65.searching;
            for (int _turn = 0; _turn < 201; _turn++) {
                const M _m66 = lanes_both(_m59, searching);
                if (!lanes_any(_m66))
                    break;
                const LANES(hoop_nearby_out) _o67 =
                    LANES(hoop_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = _o67.leaving;
                V margin = _o67.margin;
                const LANES(hoop_ring_advance_out) _o68 =
                    LANES(hoop_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                V gap = _o68.gap;
                V rate = _o68.rate;
                V bend = _o68.bend;
                V step = _o68.step;
                V next = _o68.next;
                V root = _o68.root;
                V clearance = _o68.clearance;
                const LANES(hoop_struck_out) _o69 =
                    LANES(hoop_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = _o69.hit;
                M sure = _o69.sure;
                M vague = _o69.vague;
                const M _m70 = lanes_both(_m66, vague);
                if (lanes_any(_m70)) {
                    const LANES(hoop_finer_out) _o71 =
                        LANES(hoop_finer)(share);
                    share = lanes_select(_m70, _o71.share, share);
                    const LANES(hoop_allowance_out) _o72 =
                        LANES(hoop_allowance)(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    V position_level = _o72.position_level;
                    V velocity_level = _o72.velocity_level;
                    V excess = _o72.excess;
                    const LANES(hoop_ring_margins_out) _o73 =
                        LANES(hoop_ring_margins)(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    flat = lanes_select(_m70, _o73.margin, flat);
                    tilt = lanes_select(_m70, _o73.leaving_margin, tilt);
                    rate_slack = lanes_select(_m70, _o73.rate_margin, rate_slack);
                    const LANES(hoop_exceeded_out) _o74 =
                        LANES(hoop_exceeded)(doubt, excess, t);
                    doubt = lanes_select(_m70, _o74.doubt, doubt);
                }
                const LANES(hoop_advanced_out) _o75 =
                    LANES(hoop_advanced)(arrival, certain, end, hit, next, root, step, sure, t, vague);
                arrival = lanes_select(_m66, _o75.arrival, arrival);
                certain = lanes_choose(_m66, _o75.certain, certain);
                M exhausted = _o75.exhausted;
                searching = lanes_choose(_m66, _o75.searching, searching);
                t = lanes_select(_m66, _o75.t, t);
                const M _m76 = lanes_both(_m66, exhausted);
                {
                    const LANES(hoop_ring_enter_out) _o77 =
                        LANES(hoop_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(_m76, _o77.t, t);
                    end = lanes_select(_m76, _o77.end, end);
                    searching = lanes_choose(_m76, _o77.searching, searching);
                }
            }
            const LANES(hoop_questioned_out) _o78 =
                LANES(hoop_questioned)(doubt, t, searching);
            doubt = lanes_select(_m59, _o78.doubt, doubt);
            const LANES(hoop_found_out) _o79 =
                LANES(hoop_found)(arrival);
            M arrives = _o79.arrives;
            const LANES(hoop_nearby_out) _o80 =
                LANES(hoop_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = _o80.leaving;
            const LANES(hoop_ring_refine_out) _o81 =
                LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            V refined = _o81.time;
            const LANES(hoop_polished_out) _o82 =
                LANES(hoop_polished)(arrival, certain, refined);
            arrival = _o82.arrival;
            const LANES(hoop_ring_refine_out) _o83 =
                LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            refined = _o83.time;
            V rate = _o83.rate;
            const LANES(hoop_polished_out) _o84 =
                LANES(hoop_polished)(arrival, certain, refined);
            arrival = _o84.arrival;
            const LANES(hoop_ring_margins_out) _o85 =
                LANES(hoop_ring_margins)(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            flat = _o85.margin;
            tilt = _o85.leaving_margin;
            V rate_margin = _o85.rate_margin;
            const LANES(hoop_own_margin_out) _o86 =
                LANES(hoop_own_margin)(arrival, flat, leaving, tilt);
            V margin = _o86.margin;
            const LANES(hoop_crossing_out) _o87 =
                LANES(hoop_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = _o87.clearance;
            V delay = _o87.delay;
            const LANES(hoop_landed_out) _o88 =
                LANES(hoop_landed)(arrival);
            V time = _o88.time;
            const LANES(hoop_landed_surely_out) _o89 =
                LANES(hoop_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = _o89.delay;
            doubt = lanes_select(_m59, _o89.doubt, doubt);
            const LANES(hoop_tied_out) _o90 =
                LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
            doubt = lanes_select(_m59, _o90.doubt, doubt);
            late = lanes_select(_m59, _o90.late, late);
            const LANES(hoop_sooner_out) _o91 =
                LANES(hoop_sooner)(arrives, K(0.0), time, when, which);
            when = lanes_select(_m59, _o91.when, when);
            which = lanes_select(_m59, _o91.which, which);
        }
        const M _m92 = lanes_both(flying, limited);
        if (lanes_any(_m92)) {
            const LANES(hoop_expiry_out) _o93 =
                LANES(hoop_expiry)(clock, doubt, late, time_error, time_limit, when, which);
            V time = _o93.time;
            V delay = _o93.delay;
            M arrives = _o93.arrives;
            doubt = lanes_select(_m92, _o93.doubt, doubt);
            const LANES(hoop_tied_out) _o94 =
                LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
            doubt = lanes_select(_m92, _o94.doubt, doubt);
            late = lanes_select(_m92, _o94.late, late);
            const LANES(hoop_sooner_out) _o95 =
                LANES(hoop_sooner)(arrives, K(4.0), time, when, which);
            when = lanes_select(_m92, _o95.when, when);
            which = lanes_select(_m92, _o95.which, which);
        }
        const LANES(hoop_departed_out) _o96 =
            LANES(hoop_departed)(K(3.0), which);
        M moves = _o96.moves;
        M ends = _o96.ends;
        M touches = _o96.touches;
        V reached = _o96.reached;
        M edge = _o96.edge;
        const LANES(hoop_body_of_out) _o97 =
            LANES(hoop_body_of)(which);
        V body = _o97.body;
        const M _m98 = lanes_both(flying, moves);
        {
            const LANES(hoop_flight_out) _o99 =
                LANES(hoop_flight)(when, x, y, z, vx, vy, vz, p_gravity);
            x = lanes_select(_m98, _o99.x, x);
            y = lanes_select(_m98, _o99.y, y);
            z = lanes_select(_m98, _o99.z, z);
            vx = lanes_select(_m98, _o99.vx, vx);
            vy = lanes_select(_m98, _o99.vy, vy);
            vz = lanes_select(_m98, _o99.vz, vz);
            const LANES(hoop_ticked_out) _o100 =
                LANES(hoop_ticked)(clock, when);
            clock = lanes_select(_m98, _o100.clock, clock);
        }
        const M _m101 = lanes_both(flying, limited);
        if (lanes_any(_m101)) {
            const LANES(hoop_expired_out) _o102 =
                LANES(hoop_expired)(body, clock, ends, K(4.0), reached, time_limit, which);
            clock = lanes_select(_m101, _o102.clock, clock);
            body = lanes_select(_m101, _o102.body, body);
            reached = lanes_select(_m101, _o102.reached, reached);
            ends = lanes_choose(_m101, _o102.ends, ends);
        }
        const LANES(hoop_displacement_out) _o103 =
            LANES(hoop_displacement)(late, when, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_gravity, p_end_depth);
        V slack = _o103.margin;
        const LANES(hoop_here_out) _o104 =
            LANES(hoop_here)(K(3.0), which);
        M here = _o104.here;
        const M _m105 = lanes_both(flying, here);
        {
            const LANES(hoop_end_bounds_out) _o106 =
                LANES(hoop_end_bounds)(x, y, p_ring_radius);
            V g0 = _o106.g0;
            const LANES(hoop_end_reached_out) _o107 =
                LANES(hoop_end_reached)(g0);
            reached = lanes_select(_m105, _o107.reached, reached);
            const LANES(hoop_end_edge_out) _o108 =
                LANES(hoop_end_edge)(g0, slack);
            edge = lanes_choose(_m105, _o108.edge, edge);
        }
        const LANES(hoop_doubted_out) _o109 =
            LANES(hoop_doubted)(doubt, edge, late, uncertain, when);
        uncertain = _o109.uncertain;
        const LANES(hoop_accounted_out) _o110 =
            LANES(hoop_accounted)(contacts, most_contacts, reached, touches);
        contacts = _o110.contacts;
        outcome = _o110.outcome;
        const V x_before = x;
        const V y_before = y;
        const V z_before = z;
        const V vx_before = vx;
        const V vy_before = vy;
        const V vz_before = vz;
        const V wx_before = wx;
        const V wy_before = wy;
        const V wz_before = wz;

        /* What the event does to the ball. */
        const LANES(hoop_meeting_out) _o111 =
            LANES(hoop_meeting)(claims, ends, touches);
        M meeting = _o111.meeting;
        const M _m112 = lanes_both(flying, meeting);
        if (lanes_any(_m112)) {
            const LANES(hoop_end_normal_out) _o113 =
                LANES(hoop_end_normal)();
            V nx = _o113.nx;
            V ny = _o113.ny;
            V nz = _o113.nz;
            const LANES(hoop_here_out) _o114 =
                LANES(hoop_here)(K(0.0), which);
            M here = _o114.here;
            const M _m115 = lanes_both(_m112, here);
            {
                const LANES(hoop_ring_normal_out) _o116 =
                    LANES(hoop_ring_normal)(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                nx = lanes_select(_m115, _o116.nx, nx);
                ny = lanes_select(_m115, _o116.ny, ny);
                nz = lanes_select(_m115, _o116.nz, nz);
                const LANES(hoop_counted_out) _o117 =
                    LANES(hoop_counted)(count_0);
                count_0 = lanes_select(_m115, _o117.count, count_0);
            }
            const LANES(hoop_here_out) _o118 =
                LANES(hoop_here)(K(1.0), which);
            here = _o118.here;
            const M _m119 = lanes_both(_m112, here);
            {
                const LANES(hoop_backboard_normal_out) _o120 =
                    LANES(hoop_backboard_normal)();
                nx = lanes_select(_m119, _o120.nx, nx);
                ny = lanes_select(_m119, _o120.ny, ny);
                nz = lanes_select(_m119, _o120.nz, nz);
                const LANES(hoop_counted_out) _o121 =
                    LANES(hoop_counted)(count_1);
                count_1 = lanes_select(_m119, _o121.count, count_1);
            }
            const LANES(hoop_here_out) _o122 =
                LANES(hoop_here)(K(2.0), which);
            here = _o122.here;
            const M _m123 = lanes_both(_m112, here);
            {
                const LANES(hoop_bridge_normal_out) _o124 =
                    LANES(hoop_bridge_normal)();
                nx = lanes_select(_m123, _o124.nx, nx);
                ny = lanes_select(_m123, _o124.ny, ny);
                nz = lanes_select(_m123, _o124.nz, nz);
                const LANES(hoop_counted_out) _o125 =
                    LANES(hoop_counted)(count_2);
                count_2 = lanes_select(_m123, _o125.count, count_2);
            }
            const LANES(hoop_elsewhere_out) _o126 =
                LANES(hoop_elsewhere)();
            V curving = _o126.curving;
            const LANES(hoop_again_out) _o127 =
                LANES(hoop_again)(K(0.0), last, which);
            M again = _o127.again;
            const M _m128 = lanes_both(_m112, again);
            {
                const LANES(hoop_ring_curvature_out) _o129 =
                    LANES(hoop_ring_curvature)(p_ball_radius, p_ring_radius, p_wire_radius);
                curving = lanes_select(_m128, _o129.curvature, curving);
            }
            const LANES(hoop_again_out) _o130 =
                LANES(hoop_again)(K(1.0), last, which);
            again = _o130.again;
            const M _m131 = lanes_both(_m112, again);
            {
                const LANES(hoop_backboard_curvature_out) _o132 =
                    LANES(hoop_backboard_curvature)();
                curving = lanes_select(_m131, _o132.curvature, curving);
            }
            const LANES(hoop_again_out) _o133 =
                LANES(hoop_again)(K(2.0), last, which);
            again = _o133.again;
            const M _m134 = lanes_both(_m112, again);
            {
                const LANES(hoop_bridge_curvature_out) _o135 =
                    LANES(hoop_bridge_curvature)();
                curving = lanes_select(_m134, _o135.curvature, curving);
            }
            const LANES(hoop_carry_flight_out) _o136 =
                LANES(hoop_carry_flight)(when, x, y, z, vx, vy, vz, nx, ny, nz, clock, contacts, late, dx, dy, dz, dvx, dvy, dvz, curving, p_gravity);
            dx = lanes_select(_m112, _o136.dx, dx);
            dy = lanes_select(_m112, _o136.dy, dy);
            dz = lanes_select(_m112, _o136.dz, dz);
            dvx = lanes_select(_m112, _o136.dvx, dvx);
            dvy = lanes_select(_m112, _o136.dvy, dvy);
            dvz = lanes_select(_m112, _o136.dvz, dvz);
            V delay = _o136.delay;
            V shift = _o136.shift;
            const LANES(hoop_delayed_out) _o137 =
                LANES(hoop_delayed)(clock_error, delay);
            clock_error = lanes_select(_m112, _o137.clock_error, clock_error);
            const M _m138 = lanes_both(_m112, ends);
            {
                const LANES(hoop_floored_out) _o139 =
                    LANES(hoop_floored)(dx, dy, dz, shift);
                dx = lanes_select(_m138, _o139.dx, dx);
                dy = lanes_select(_m138, _o139.dy, dy);
                dz = lanes_select(_m138, _o139.dz, dz);
            }
            const LANES(hoop_unturned_out) _o140 =
                LANES(hoop_unturned)();
            V dnx = _o140.dnx;
            V dny = _o140.dny;
            V dnz = _o140.dnz;
            V turn = _o140.turn;
            const LANES(hoop_here_out) _o141 =
                LANES(hoop_here)(K(0.0), which);
            here = _o141.here;
            const M _m142 = lanes_both(_m112, here);
            if (lanes_any(_m142)) {
                const LANES(hoop_ring_carry_normal_out) _o143 =
                    LANES(hoop_ring_carry_normal)(x, y, dx, dy, dz, shift, p_ball_radius, p_ring_radius, p_wire_radius);
                dnx = lanes_select(_m142, _o143.dnx, dnx);
                dny = lanes_select(_m142, _o143.dny, dny);
                dnz = lanes_select(_m142, _o143.dnz, dnz);
                turn = lanes_select(_m142, _o143.turn, turn);
            }
            const M _m144 = lanes_both(_m112, touches);
            if (lanes_any(_m144)) {
                const LANES(hoop_carry_impact_out) _o145 =
                    LANES(hoop_carry_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, contacts, dvx, dvy, dvz, dwx, dwy, dwz, dnx, dny, dnz, turn, p_ball_radius, p_restitution);
                dvx = lanes_select(_m144, _o145.dvx, dvx);
                dvy = lanes_select(_m144, _o145.dvy, dvy);
                dvz = lanes_select(_m144, _o145.dvz, dvz);
                dwx = lanes_select(_m144, _o145.dwx, dwx);
                dwy = lanes_select(_m144, _o145.dwy, dwy);
                dwz = lanes_select(_m144, _o145.dwz, dwz);
                const LANES(hoop_impact_out) _o146 =
                    LANES(hoop_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, p_restitution);
                vx = lanes_select(_m144, _o146.vx, vx);
                vy = lanes_select(_m144, _o146.vy, vy);
                vz = lanes_select(_m144, _o146.vz, vz);
                wx = lanes_select(_m144, _o146.wx, wx);
                wy = lanes_select(_m144, _o146.wy, wy);
                wz = lanes_select(_m144, _o146.wz, wz);
            }
            const LANES(hoop_here_out) _o147 =
                LANES(hoop_here)(K(1.0), which);
            here = _o147.here;
            const M _m148 = lanes_both(_m112, here);
            {
                const LANES(hoop_backboard_place_out) _o149 =
                    LANES(hoop_backboard_place)(y, z, p_ball_radius, p_board_distance);
                x = lanes_select(_m148, _o149.x, x);
                y = lanes_select(_m148, _o149.y, y);
                z = lanes_select(_m148, _o149.z, z);
            }
            const LANES(hoop_here_out) _o150 =
                LANES(hoop_here)(K(2.0), which);
            here = _o150.here;
            const M _m151 = lanes_both(_m112, here);
            {
                const LANES(hoop_bridge_place_out) _o152 =
                    LANES(hoop_bridge_place)(x, y, p_ball_radius, p_wire_radius);
                x = lanes_select(_m151, _o152.x, x);
                y = lanes_select(_m151, _o152.y, y);
                z = lanes_select(_m151, _o152.z, z);
            }
            const M _m153 = lanes_both(_m112, touches);
            {
                const LANES(hoop_touched_out) _o154 =
                    LANES(hoop_touched)(body, first, which);
                first = lanes_select(_m153, _o154.first, first);
                last = lanes_select(_m153, _o154.last, last);
            }
        }
        const M _m155 = lanes_both(flying, limited);
        if (lanes_any(_m155)) {
            const LANES(hoop_timed_out) _o156 =
                LANES(hoop_timed)(claims, K(4.0), which);
            M timed = _o156.timed;
            const M _m157 = lanes_both(_m155, timed);
            if (lanes_any(_m157)) {
                const LANES(hoop_carry_time_out) _o158 =
                    LANES(hoop_carry_time)(when, x, y, z, vx, vy, vz, clock, clock_error, dx, dy, dz, dvx, dvy, dvz, p_gravity);
                dx = lanes_select(_m157, _o158.dx, dx);
                dy = lanes_select(_m157, _o158.dy, dy);
                dz = lanes_select(_m157, _o158.dz, dz);
                dvx = lanes_select(_m157, _o158.dvx, dvx);
                dvy = lanes_select(_m157, _o158.dvy, dvy);
                dvz = lanes_select(_m157, _o158.dvz, dvz);
                clock_error = lanes_select(_m157, _o158.clock_error, clock_error);
            }
        }
        const LANES(hoop_closing_out) _o159 =
            LANES(hoop_closing)(claims, outcome);
        M closed = _o159.closed;
        const M _m160 = lanes_both(flying, closed);
        {
            const LANES(hoop_claimed_errors_out) _o161 =
                LANES(hoop_claimed_errors)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            position_claim = lanes_select(_m160, _o161.position_error, position_claim);
            velocity_claim = lanes_select(_m160, _o161.velocity_error, velocity_claim);
            spin_claim = lanes_select(_m160, _o161.spin_error, spin_claim);
            time_claim = lanes_select(_m160, _o161.time_error, time_claim);
        }
        lanes_store(pool.x, x);
        lanes_store(pool.y, y);
        lanes_store(pool.z, z);
        lanes_store(pool.vx, vx);
        lanes_store(pool.vy, vy);
        lanes_store(pool.vz, vz);
        lanes_store(pool.wx, wx);
        lanes_store(pool.wy, wy);
        lanes_store(pool.wz, wz);
        lanes_store(pool.dx, dx);
        lanes_store(pool.dy, dy);
        lanes_store(pool.dz, dz);
        lanes_store(pool.dvx, dvx);
        lanes_store(pool.dvy, dvy);
        lanes_store(pool.dvz, dvz);
        lanes_store(pool.dwx, dwx);
        lanes_store(pool.dwy, dwy);
        lanes_store(pool.dwz, dwz);
        lanes_store(pool.clock, clock);
        lanes_store(pool.clock_error, clock_error);
        lanes_store(pool.last, last);
        lanes_store(pool.first, first);
        lanes_store(pool.contacts, contacts);
        lanes_store(pool.count_0, count_0);
        lanes_store(pool.count_1, count_1);
        lanes_store(pool.count_2, count_2);
        lanes_store(pool.uncertain, uncertain);
        lanes_store(pool.position_claim, position_claim);
        lanes_store(pool.velocity_claim, velocity_claim);
        lanes_store(pool.spin_claim, spin_claim);
        lanes_store(pool.time_claim, time_claim);
        lanes_store(pool.outcome, outcome);
        if (job->results->events) {
            double surface[LANES_WIDTH];
            double before[HOOP_STATE][LANES_WIDTH];
            lanes_store(surface, body);
            lanes_store(before[0], x_before);
            lanes_store(before[1], y_before);
            lanes_store(before[2], z_before);
            lanes_store(before[3], vx_before);
            lanes_store(before[4], vy_before);
            lanes_store(before[5], vz_before);
            lanes_store(before[6], wx_before);
            lanes_store(before[7], wy_before);
            lanes_store(before[8], wz_before);
            for (int lane = 0; lane < LANES_WIDTH; lane++) {
                if (pool.occupied[lane] == 0.0 || surface[lane] < 0.0)
                    continue;
                const size_t shot = pool.shot[lane];
                int32_t *used = job->results->event_counts + shot;
                hoop_event *event = job->results->events + shot * ((size_t)job->max_contacts + 1) + (size_t)(*used)++;
                event->shot = (int64_t)shot;
                event->surface = (int64_t)surface[lane];
                event->time = pool.clock[lane];
                event->before[0] = before[0][lane];
                event->after[0] = pool.x[lane];
                event->before[1] = before[1][lane];
                event->after[1] = pool.y[lane];
                event->before[2] = before[2][lane];
                event->after[2] = pool.z[lane];
                event->before[3] = before[3][lane];
                event->after[3] = pool.vx[lane];
                event->before[4] = before[4][lane];
                event->after[4] = pool.vy[lane];
                event->before[5] = before[5][lane];
                event->after[5] = pool.vz[lane];
                event->before[6] = before[6][lane];
                event->after[6] = pool.wx[lane];
                event->before[7] = before[7][lane];
                event->after[7] = pool.wy[lane];
                event->before[8] = before[8][lane];
                event->after[8] = pool.wz[lane];
            }
        }
        const M going = lanes_less(outcome, zero);
        if (following && flights == LANES_WIDTH && !lanes_any(going)) {
            LANES(hoop_finish_all)(&pool, job);
            flights = 0;
            continue;
        }
        for (int lane = 0; lane < LANES_WIDTH; lane++)
            if (pool.occupied[lane] != 0.0 && pool.outcome[lane] >= 0.0) {
                LANES(hoop_finish)(&pool, lane, job);
                flights--;
            }
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
