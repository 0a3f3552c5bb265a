/* The event loop of the scene hoop, LANES_WIDTH shots abreast.

   Generated from templates/c/engine.h.j2, scene hoop, derivation 4e3fee7f36fc1578,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Included by hoop.c once for every width. A lane holds a shot; when it ends, the next one takes
   its place. No lane's result depends on its neighbours. */

#if LANES_WIDTH == 1
typedef double LANES(vector);
typedef int LANES(mask);
#else
typedef double LANES(vector) __attribute__((vector_size(8 * LANES_WIDTH)));
typedef int64_t LANES(mask) __attribute__((vector_size(8 * LANES_WIDTH)));
#endif

#define V LANES(vector)
#define M LANES(mask)
#define lanes_select LANES(select)
#define lanes_choose LANES(choose)
#define lanes_abs LANES(abs)
#define lanes_sqrt LANES(sqrt)
#define lanes_any LANES(any)
#define lanes_load LANES(load)
#define lanes_store LANES(store)
#define lanes_gather LANES(gather)

#if LANES_WIDTH == 1
#define K(c) (c)
#define NOT(m) (!(m))
#define NOWHERE 0
LANES_INLINE V lanes_select(M m, V a, V b) { return m ? a : b; }
LANES_INLINE V lanes_abs(V a) { return fabs(a); }
LANES_INLINE V lanes_sqrt(V a) { return sqrt(a); }
LANES_INLINE int lanes_any(M m) { return m; }
#else
#define K(c) ((c) - (V){0})
#define NOT(m) (~(m))
#define NOWHERE ((M){0})
LANES_INLINE V lanes_select(M m, V a, V b) { return (V)(((M)a & m) | ((M)b & ~m)); }
LANES_INLINE V lanes_abs(V a) { return (V)((M)a & (INT64_MAX - (M){0})); }
LANES_INLINE V lanes_sqrt(V a)
{
    V root = a;
    for (int lane = 0; lane < LANES_WIDTH; lane++)
        root[lane] = sqrt(a[lane]);
    return root;
}
LANES_INLINE int lanes_any(M m)
{
    int64_t any = 0;
    for (int lane = 0; lane < LANES_WIDTH; lane++)
        any |= m[lane];
    return any != 0;
}
#endif

/* Where one truth holds instead of another. */
LANES_INLINE M lanes_choose(M m, M a, M b) { return (a & m) | (b & NOT(m)); }

LANES_INLINE V lanes_load(const double *row)
{
    V a;
    memcpy(&a, row, sizeof a);
    return a;
}

LANES_INLINE void lanes_store(double *row, V a) { memcpy(row, &a, sizeof a); }

LANES_INLINE V lanes_gather(const double *first, int64_t stride)
{
#if LANES_WIDTH == 1
    (void)stride;
    return *first;
#else
    V a;
    for (int lane = 0; lane < LANES_WIDTH; lane++)
        a[lane] = first[stride * lane];
    return a;
#endif
}

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
    double ball_radius[LANES_WIDTH], ring_radius[LANES_WIDTH], wire_radius[LANES_WIDTH], board_distance[LANES_WIDTH], board_half_width[LANES_WIDTH], board_bottom[LANES_WIDTH], board_top[LANES_WIDTH], bridge_half_width[LANES_WIDTH], restitution[LANES_WIDTH], gravity[LANES_WIDTH], end_depth[LANES_WIDTH];
    double from[LANES_WIDTH];     /* surface that the shot starts on, -1: none */
    double occupied[LANES_WIDTH]; /* 1: holds a shot */
    double fresh[LANES_WIDTH];    /* 1: and has not been looked at */
    size_t shot[LANES_WIDTH];
} LANES(hoop_pool);

/* Where the parameters are finite and allowed. */
LANES_INLINE M LANES(hoop_permit)(V ball_radius, V ring_radius, V wire_radius, V board_distance, V board_half_width, V board_bottom, V board_top, V bridge_half_width, V restitution, V gravity, V end_depth)
{
    const LANES(hoop_allowed_out) o1 =
        LANES(hoop_allowed)(ball_radius, ring_radius, wire_radius, board_distance, board_half_width, bridge_half_width, restitution, gravity, end_depth);
    V allowed = o1.allowed;
    const LANES(hoop_finite_parameters_out) o2 =
        LANES(hoop_finite_parameters)(ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, restitution, gravity, end_depth, allowed);
    M permitted = o2.permitted;
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
        pool->ball_radius[lane] = job->parameters[0][job->strides[0] * (int64_t)shot];
        pool->ring_radius[lane] = job->parameters[1][job->strides[1] * (int64_t)shot];
        pool->wire_radius[lane] = job->parameters[2][job->strides[2] * (int64_t)shot];
        pool->board_distance[lane] = job->parameters[3][job->strides[3] * (int64_t)shot];
        pool->board_half_width[lane] = job->parameters[4][job->strides[4] * (int64_t)shot];
        pool->board_bottom[lane] = job->parameters[5][job->strides[5] * (int64_t)shot];
        pool->board_top[lane] = job->parameters[6][job->strides[6] * (int64_t)shot];
        pool->bridge_half_width[lane] = job->parameters[7][job->strides[7] * (int64_t)shot];
        pool->restitution[lane] = job->parameters[8][job->strides[8] * (int64_t)shot];
        pool->gravity[lane] = job->parameters[9][job->strides[9] * (int64_t)shot];
        pool->end_depth[lane] = job->parameters[10][job->strides[10] * (int64_t)shot];
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
        lanes_store(pool->ball_radius, lanes_gather(job->parameters[0] + job->strides[0] * (int64_t)first, job->strides[0]));
        lanes_store(pool->ring_radius, lanes_gather(job->parameters[1] + job->strides[1] * (int64_t)first, job->strides[1]));
        lanes_store(pool->wire_radius, lanes_gather(job->parameters[2] + job->strides[2] * (int64_t)first, job->strides[2]));
        lanes_store(pool->board_distance, lanes_gather(job->parameters[3] + job->strides[3] * (int64_t)first, job->strides[3]));
        lanes_store(pool->board_half_width, lanes_gather(job->parameters[4] + job->strides[4] * (int64_t)first, job->strides[4]));
        lanes_store(pool->board_bottom, lanes_gather(job->parameters[5] + job->strides[5] * (int64_t)first, job->strides[5]));
        lanes_store(pool->board_top, lanes_gather(job->parameters[6] + job->strides[6] * (int64_t)first, job->strides[6]));
        lanes_store(pool->bridge_half_width, lanes_gather(job->parameters[7] + job->strides[7] * (int64_t)first, job->strides[7]));
        lanes_store(pool->restitution, lanes_gather(job->parameters[8] + job->strides[8] * (int64_t)first, job->strides[8]));
        lanes_store(pool->gravity, lanes_gather(job->parameters[9] + job->strides[9] * (int64_t)first, job->strides[9]));
        lanes_store(pool->end_depth, lanes_gather(job->parameters[10] + job->strides[10] * (int64_t)first, job->strides[10]));
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
    const int invalid = (int)pool->outcome[lane] == HOOP_INVALID;
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

/* Run the job: fill the lanes, take every lane to its next event, free those that ended.
   No errors are bounded: the same path, with less work. */
LANES_INLINE void LANES(hoop_plain)(const hoop_job *job)
{
    LANES(hoop_pool) pool;
    memset(&pool, 0, sizeof pool);
    const V zero = K(0.0);
    const V most_contacts = K((double)job->max_contacts);
    size_t next = 0;

    if (job->results->event_counts)
        memset(job->results->event_counts, 0, job->shots * sizeof(int32_t));
    if (!job->varying)
        for (int lane = 0; lane < LANES_WIDTH; lane++) {
            pool.ball_radius[lane] = *job->parameters[0];
            pool.ring_radius[lane] = *job->parameters[1];
            pool.wire_radius[lane] = *job->parameters[2];
            pool.board_distance[lane] = *job->parameters[3];
            pool.board_half_width[lane] = *job->parameters[4];
            pool.board_bottom[lane] = *job->parameters[5];
            pool.board_top[lane] = *job->parameters[6];
            pool.bridge_half_width[lane] = *job->parameters[7];
            pool.restitution[lane] = *job->parameters[8];
            pool.gravity[lane] = *job->parameters[9];
            pool.end_depth[lane] = *job->parameters[10];
        }
    M permitted = LANES(hoop_permit)(lanes_load(pool.ball_radius), lanes_load(pool.ring_radius), lanes_load(pool.wire_radius), lanes_load(pool.board_distance), lanes_load(pool.board_half_width), lanes_load(pool.board_bottom), lanes_load(pool.board_top), lanes_load(pool.bridge_half_width), lanes_load(pool.restitution), lanes_load(pool.gravity), lanes_load(pool.end_depth));
    for (int flights = 0;;) {
        int refilled = 0;
        if (job->stop && *job->stop)
            return;
        if (flights == 0 && job->shots - next >= LANES_WIDTH) {
            LANES(hoop_begin_all)(&pool, job, next);
            next += LANES_WIDTH;
            flights = LANES_WIDTH;
            refilled = 1;
        }
        for (int lane = 0; flights < LANES_WIDTH && next < job->shots; lane++)
            if (pool.occupied[lane] == 0.0) {
                LANES(hoop_begin)(&pool, lane, job, next++);
                flights++;
                refilled = 1;
            }
        if (flights == 0)
            return;

        const V ball_radius = lanes_load(pool.ball_radius);
        const V ring_radius = lanes_load(pool.ring_radius);
        const V wire_radius = lanes_load(pool.wire_radius);
        const V board_distance = lanes_load(pool.board_distance);
        const V board_half_width = lanes_load(pool.board_half_width);
        const V board_bottom = lanes_load(pool.board_bottom);
        const V board_top = lanes_load(pool.board_top);
        const V bridge_half_width = lanes_load(pool.bridge_half_width);
        const V restitution = lanes_load(pool.restitution);
        const V gravity = lanes_load(pool.gravity);
        const V end_depth = lanes_load(pool.end_depth);
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
        const M flying = lanes_load(pool.occupied) > zero;

        /* A new shot is looked at once; one that is not valid ends here. */
        if (refilled) {
            const M fresh = flying & (lanes_load(pool.fresh) > zero);
            clock = lanes_select(fresh, K(0.0), clock);
            last = lanes_select(fresh, lanes_load(pool.from), last);
            first = lanes_select(fresh, K(-1.0), first);
            contacts = lanes_select(fresh, K(0.0), contacts);
            count_0 = lanes_select(fresh, K(0.0), count_0);
            count_1 = lanes_select(fresh, K(0.0), count_1);
            count_2 = lanes_select(fresh, K(0.0), count_2);
            outcome = lanes_select(fresh, K(-1.0), outcome);

            if (job->varying)
                permitted = LANES(hoop_permit)(ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, restitution, gravity, end_depth);
            const LANES(hoop_finite_state_out) o3 =
                LANES(hoop_finite_state)(vx, vy, vz, wx, wy, wz, x, y, z);
            M finite = o3.finite;
            const LANES(hoop_valid_out) o4 =
                LANES(hoop_valid)(last, x, y, z, ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, end_depth);
            V valid = o4.valid;
            const LANES(hoop_admitted_out) o5 =
                LANES(hoop_admitted)(K(INFINITY), finite, permitted, valid);
            outcome = lanes_select(fresh, o5.outcome, outcome);
            lanes_store(pool.fresh, zero);
            if (lanes_any(fresh & (outcome >= zero))) {
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
        const LANES(hoop_scale_out) o6 =
            LANES(hoop_scale)(x, y, z, vx, vy, vz, gravity);
        V extent = o6.extent;
        V speed = o6.speed;
        V excess = o6.excess;
        const LANES(hoop_opening_out) o7 =
            LANES(hoop_opening)(excess, K(0.0), K(0.0));
        V when = o7.when;
        V which = o7.which;
        const LANES(hoop_left_out) o8 =
            LANES(hoop_left)(K(3.0), last);
        V leaving = o8.leaving;
        const LANES(hoop_end_arrival_out) o9 =
            LANES(hoop_end_arrival)(leaving, z, vz, gravity, end_depth);
        V time = o9.time;
        V rate = o9.rate;
        V bend = o9.bend;
        const LANES(hoop_meeting_plane_out) o10 =
            LANES(hoop_meeting_plane)(bend, rate, time);
        M arrives = o10.arrives;
        const LANES(hoop_timely_out) o11 =
            LANES(hoop_timely)(arrives, K(0.0), K(0.0), time, when);
        M possible = o11.possible;
        const M m12 = flying & possible;
        {
            const LANES(hoop_sooner_out) o13 =
                LANES(hoop_sooner)(arrives, K(3.0), time, when, which);
            when = lanes_select(m12, o13.when, when);
            which = lanes_select(m12, o13.which, which);
        }
        const LANES(hoop_left_out) o14 =
            LANES(hoop_left)(K(1.0), last);
        leaving = o14.leaving;
        const LANES(hoop_backboard_arrival_out) o15 =
            LANES(hoop_backboard_arrival)(leaving, x, vx, ball_radius, board_distance);
        time = o15.time;
        rate = o15.rate;
        bend = o15.bend;
        const LANES(hoop_meeting_plane_out) o16 =
            LANES(hoop_meeting_plane)(bend, rate, time);
        arrives = o16.arrives;
        const LANES(hoop_timely_out) o17 =
            LANES(hoop_timely)(arrives, K(0.0), K(0.0), time, when);
        possible = o17.possible;
        const M m18 = flying & possible;
        {
            const LANES(hoop_flight_out) o19 =
                LANES(hoop_flight)(time, x, y, z, vx, vy, vz, gravity);
            V there_y = o19.y;
            V there_z = o19.z;
            const LANES(hoop_backboard_bounds_out) o20 =
                LANES(hoop_backboard_bounds)(there_y, there_z, board_half_width, board_bottom, board_top);
            V g0 = o20.g0;
            V g1 = o20.g1;
            V g2 = o20.g2;
            V g3 = o20.g3;
            const LANES(hoop_backboard_within_out) o21 =
                LANES(hoop_backboard_within)(g0, g1, g2, g3);
            M arrives = o21.arrives;
            const LANES(hoop_sooner_out) o22 =
                LANES(hoop_sooner)(arrives, K(1.0), time, when, which);
            when = lanes_select(m18, o22.when, when);
            which = lanes_select(m18, o22.which, which);
        }
        const LANES(hoop_left_out) o23 =
            LANES(hoop_left)(K(2.0), last);
        leaving = o23.leaving;
        const LANES(hoop_bridge_arrival_out) o24 =
            LANES(hoop_bridge_arrival)(leaving, z, vz, ball_radius, wire_radius, gravity);
        time = o24.time;
        rate = o24.rate;
        bend = o24.bend;
        const LANES(hoop_meeting_plane_out) o25 =
            LANES(hoop_meeting_plane)(bend, rate, time);
        arrives = o25.arrives;
        const LANES(hoop_timely_out) o26 =
            LANES(hoop_timely)(arrives, K(0.0), K(0.0), time, when);
        possible = o26.possible;
        const M m27 = flying & possible;
        if (lanes_any(m27)) {
            const LANES(hoop_flight_out) o28 =
                LANES(hoop_flight)(time, x, y, z, vx, vy, vz, gravity);
            V there_x = o28.x;
            V there_y = o28.y;
            const LANES(hoop_bridge_bounds_out) o29 =
                LANES(hoop_bridge_bounds)(there_x, there_y, ring_radius, board_distance, bridge_half_width);
            V g0 = o29.g0;
            V g1 = o29.g1;
            V g2 = o29.g2;
            V g3 = o29.g3;
            V g4 = o29.g4;
            const LANES(hoop_bridge_within_out) o30 =
                LANES(hoop_bridge_within)(g0, g1, g2, g3, g4);
            M arrives = o30.arrives;
            const LANES(hoop_sooner_out) o31 =
                LANES(hoop_sooner)(arrives, K(2.0), time, when, which);
            when = lanes_select(m27, o31.when, when);
            which = lanes_select(m27, o31.which, which);
        }
        const LANES(hoop_horizon_out) o32 =
            LANES(hoop_horizon)(when, speed, gravity);
        V until = o32.horizon;
        const LANES(hoop_ring_clear_out) o33 =
            LANES(hoop_ring_clear)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), ball_radius, ring_radius, wire_radius, gravity);
        V clear = o33.clear;
        const LANES(hoop_opens_out) o34 =
            LANES(hoop_opens)(clear);
        M open = o34.open;
        const M m35 = flying & open;
        if (lanes_any(m35)) {
            const LANES(hoop_ring_prepare_out) o36 =
                LANES(hoop_ring_prepare)(until, x, y, z, vx, vy, vz, K(0.0), K(0.0), ball_radius, ring_radius, wire_radius, gravity);
            V steady = o36.steady;
            V swing = o36.swing;
            V rho_start = o36.rho_start;
            V low0 = o36.low0;
            V high0 = o36.high0;
            V low1 = o36.low1;
            V high1 = o36.high1;
            V low2 = o36.low2;
            V high2 = o36.high2;
            V ceiling = o36.ceiling;
            V latest = o36.latest;
            const LANES(hoop_beginning_out) o37 =
                LANES(hoop_beginning)();
            V share = o37.share;
            V arrival = o37.arrival;
            M certain = o37.certain;
            const LANES(hoop_allowance_out) o38 =
                LANES(hoop_allowance)(share, latest, extent, speed, K(0.0), K(0.0), gravity);
            V level = o38.level;
            V velocity_level = o38.velocity_level;
            const LANES(hoop_ring_margins_out) o39 =
                LANES(hoop_ring_margins)(latest, extent, speed, level, velocity_level, ball_radius, ring_radius, wire_radius, gravity);
            V flat = o39.margin;
            V tilt = o39.leaving_margin;
            V rate_slack = o39.rate_margin;
            const LANES(hoop_ring_enter_out) o40 =
                LANES(hoop_ring_enter)(K(0.0), K(0.0), high0, high1, high2, low0, low1, low2, K(0.0));
            V t = o40.t;
            V end = o40.end;
            M searching = o40.searching;
            for (int turn = 0; turn < 201; turn++) {
                const M m41 = m35 & searching;
                if (!lanes_any(m41))
                    break;
                const LANES(hoop_nearby_out) o42 =
                    LANES(hoop_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = o42.leaving;
                V margin = o42.margin;
                const LANES(hoop_ring_advance_out) o43 =
                    LANES(hoop_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, ball_radius, ring_radius, wire_radius, gravity);
                V gap = o43.gap;
                V rate = o43.rate;
                V bend = o43.bend;
                V step = o43.step;
                V next = o43.next;
                V root = o43.root;
                V clearance = o43.clearance;
                const LANES(hoop_struck_out) o44 =
                    LANES(hoop_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = o44.hit;
                M sure = o44.sure;
                M vague = o44.vague;
                const M m45 = m41 & vague;
                if (lanes_any(m45)) {
                    const LANES(hoop_finer_out) o46 =
                        LANES(hoop_finer)(share);
                    share = lanes_select(m45, o46.share, share);
                    const LANES(hoop_allowance_out) o47 =
                        LANES(hoop_allowance)(share, latest, extent, speed, K(0.0), K(0.0), gravity);
                    V level = o47.level;
                    V velocity_level = o47.velocity_level;
                    const LANES(hoop_ring_margins_out) o48 =
                        LANES(hoop_ring_margins)(latest, extent, speed, level, velocity_level, ball_radius, ring_radius, wire_radius, gravity);
                    flat = lanes_select(m45, o48.margin, flat);
                    tilt = lanes_select(m45, o48.leaving_margin, tilt);
                    rate_slack = lanes_select(m45, o48.rate_margin, rate_slack);
                }
                const LANES(hoop_advanced_out) o49 =
                    LANES(hoop_advanced)(arrival, certain, end, hit, next, root, step, sure, t, vague);
                arrival = lanes_select(m41, o49.arrival, arrival);
                certain = lanes_choose(m41, o49.certain, certain);
                M exhausted = o49.exhausted;
                searching = lanes_choose(m41, o49.searching, searching);
                t = lanes_select(m41, o49.t, t);
                const M m50 = m41 & exhausted;
                {
                    const LANES(hoop_ring_enter_out) o51 =
                        LANES(hoop_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(m50, o51.t, t);
                    end = lanes_select(m50, o51.end, end);
                    searching = lanes_choose(m50, o51.searching, searching);
                }
            }
            const LANES(hoop_found_out) o52 =
                LANES(hoop_found)(arrival);
            M arrives = o52.arrives;
            const LANES(hoop_nearby_out) o53 =
                LANES(hoop_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = o53.leaving;
            const LANES(hoop_ring_refine_out) o54 =
                LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, ball_radius, ring_radius, wire_radius, gravity);
            V refined = o54.time;
            const LANES(hoop_polished_out) o55 =
                LANES(hoop_polished)(arrival, certain, refined);
            arrival = o55.arrival;
            const LANES(hoop_ring_refine_out) o56 =
                LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, ball_radius, ring_radius, wire_radius, gravity);
            refined = o56.time;
            const LANES(hoop_polished_out) o57 =
                LANES(hoop_polished)(arrival, certain, refined);
            arrival = o57.arrival;
            const LANES(hoop_landed_out) o58 =
                LANES(hoop_landed)(arrival);
            V time = o58.time;
            const LANES(hoop_sooner_out) o59 =
                LANES(hoop_sooner)(arrives, K(0.0), time, when, which);
            when = lanes_select(m35, o59.when, when);
            which = lanes_select(m35, o59.which, which);
        }
        const LANES(hoop_departed_out) o60 =
            LANES(hoop_departed)(K(3.0), which);
        M moves = o60.moves;
        M ends = o60.ends;
        M touches = o60.touches;
        const LANES(hoop_body_of_out) o61 =
            LANES(hoop_body_of)(which);
        V body = o61.body;
        const M m62 = flying & moves;
        {
            const LANES(hoop_flight_out) o63 =
                LANES(hoop_flight)(when, x, y, z, vx, vy, vz, gravity);
            x = lanes_select(m62, o63.x, x);
            y = lanes_select(m62, o63.y, y);
            z = lanes_select(m62, o63.z, z);
            vx = lanes_select(m62, o63.vx, vx);
            vy = lanes_select(m62, o63.vy, vy);
            vz = lanes_select(m62, o63.vz, vz);
            const LANES(hoop_ticked_out) o64 =
                LANES(hoop_ticked)(clock, when);
            clock = lanes_select(m62, o64.clock, clock);
        }
        const LANES(hoop_target_out) o65 =
            LANES(hoop_target)(x, y, ring_radius);
        V miss = o65.target;
        const LANES(hoop_accounted_out) o66 =
            LANES(hoop_accounted)(contacts, ends, miss, most_contacts, touches);
        contacts = o66.contacts;
        outcome = o66.outcome;
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
        const LANES(hoop_meeting_out) o67 =
            LANES(hoop_meeting)(K(0.0), ends, touches);
        M meeting = o67.meeting;
        const M m68 = flying & meeting;
        if (lanes_any(m68)) {
            const LANES(hoop_end_normal_out) o69 =
                LANES(hoop_end_normal)();
            V nx = o69.nx;
            V ny = o69.ny;
            V nz = o69.nz;
            const LANES(hoop_here_out) o70 =
                LANES(hoop_here)(K(0.0), which);
            M here = o70.here;
            const M m71 = m68 & here;
            {
                const LANES(hoop_ring_normal_out) o72 =
                    LANES(hoop_ring_normal)(x, y, z, ball_radius, ring_radius, wire_radius);
                nx = lanes_select(m71, o72.nx, nx);
                ny = lanes_select(m71, o72.ny, ny);
                nz = lanes_select(m71, o72.nz, nz);
                const LANES(hoop_counted_out) o73 =
                    LANES(hoop_counted)(count_0);
                count_0 = lanes_select(m71, o73.count, count_0);
            }
            const LANES(hoop_here_out) o74 =
                LANES(hoop_here)(K(1.0), which);
            here = o74.here;
            const M m75 = m68 & here;
            {
                const LANES(hoop_backboard_normal_out) o76 =
                    LANES(hoop_backboard_normal)();
                nx = lanes_select(m75, o76.nx, nx);
                ny = lanes_select(m75, o76.ny, ny);
                nz = lanes_select(m75, o76.nz, nz);
                const LANES(hoop_counted_out) o77 =
                    LANES(hoop_counted)(count_1);
                count_1 = lanes_select(m75, o77.count, count_1);
            }
            const LANES(hoop_here_out) o78 =
                LANES(hoop_here)(K(2.0), which);
            here = o78.here;
            const M m79 = m68 & here;
            {
                const LANES(hoop_bridge_normal_out) o80 =
                    LANES(hoop_bridge_normal)();
                nx = lanes_select(m79, o80.nx, nx);
                ny = lanes_select(m79, o80.ny, ny);
                nz = lanes_select(m79, o80.nz, nz);
                const LANES(hoop_counted_out) o81 =
                    LANES(hoop_counted)(count_2);
                count_2 = lanes_select(m79, o81.count, count_2);
            }
            const M m82 = m68 & touches;
            if (lanes_any(m82)) {
                const LANES(hoop_impact_out) o83 =
                    LANES(hoop_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, ball_radius, restitution);
                vx = lanes_select(m82, o83.vx, vx);
                vy = lanes_select(m82, o83.vy, vy);
                vz = lanes_select(m82, o83.vz, vz);
                wx = lanes_select(m82, o83.wx, wx);
                wy = lanes_select(m82, o83.wy, wy);
                wz = lanes_select(m82, o83.wz, wz);
            }
            const LANES(hoop_here_out) o84 =
                LANES(hoop_here)(K(1.0), which);
            here = o84.here;
            const M m85 = m68 & here;
            {
                const LANES(hoop_backboard_place_out) o86 =
                    LANES(hoop_backboard_place)(y, z, ball_radius, board_distance);
                x = lanes_select(m85, o86.x, x);
                y = lanes_select(m85, o86.y, y);
                z = lanes_select(m85, o86.z, z);
            }
            const LANES(hoop_here_out) o87 =
                LANES(hoop_here)(K(2.0), which);
            here = o87.here;
            const M m88 = m68 & here;
            {
                const LANES(hoop_bridge_place_out) o89 =
                    LANES(hoop_bridge_place)(x, y, ball_radius, wire_radius);
                x = lanes_select(m88, o89.x, x);
                y = lanes_select(m88, o89.y, y);
                z = lanes_select(m88, o89.z, z);
            }
            const M m90 = m68 & touches;
            {
                const LANES(hoop_touched_out) o91 =
                    LANES(hoop_touched)(body, first, which);
                first = lanes_select(m90, o91.first, first);
                last = lanes_select(m90, o91.last, last);
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
    const V claims = K(job->results->time_error || job->results->state_error ? 1.0 : 0.0);
    size_t next = 0;

    if (job->results->event_counts)
        memset(job->results->event_counts, 0, job->shots * sizeof(int32_t));
    if (!job->varying)
        for (int lane = 0; lane < LANES_WIDTH; lane++) {
            pool.ball_radius[lane] = *job->parameters[0];
            pool.ring_radius[lane] = *job->parameters[1];
            pool.wire_radius[lane] = *job->parameters[2];
            pool.board_distance[lane] = *job->parameters[3];
            pool.board_half_width[lane] = *job->parameters[4];
            pool.board_bottom[lane] = *job->parameters[5];
            pool.board_top[lane] = *job->parameters[6];
            pool.bridge_half_width[lane] = *job->parameters[7];
            pool.restitution[lane] = *job->parameters[8];
            pool.gravity[lane] = *job->parameters[9];
            pool.end_depth[lane] = *job->parameters[10];
        }
    M permitted = LANES(hoop_permit)(lanes_load(pool.ball_radius), lanes_load(pool.ring_radius), lanes_load(pool.wire_radius), lanes_load(pool.board_distance), lanes_load(pool.board_half_width), lanes_load(pool.board_bottom), lanes_load(pool.board_top), lanes_load(pool.bridge_half_width), lanes_load(pool.restitution), lanes_load(pool.gravity), lanes_load(pool.end_depth));
    for (int flights = 0;;) {
        int refilled = 0;
        if (job->stop && *job->stop)
            return;
        if (flights == 0 && job->shots - next >= LANES_WIDTH) {
            LANES(hoop_begin_all)(&pool, job, next);
            next += LANES_WIDTH;
            flights = LANES_WIDTH;
            refilled = 1;
        }
        for (int lane = 0; flights < LANES_WIDTH && next < job->shots; lane++)
            if (pool.occupied[lane] == 0.0) {
                LANES(hoop_begin)(&pool, lane, job, next++);
                flights++;
                refilled = 1;
            }
        if (flights == 0)
            return;

        const V ball_radius = lanes_load(pool.ball_radius);
        const V ring_radius = lanes_load(pool.ring_radius);
        const V wire_radius = lanes_load(pool.wire_radius);
        const V board_distance = lanes_load(pool.board_distance);
        const V board_half_width = lanes_load(pool.board_half_width);
        const V board_bottom = lanes_load(pool.board_bottom);
        const V board_top = lanes_load(pool.board_top);
        const V bridge_half_width = lanes_load(pool.bridge_half_width);
        const V restitution = lanes_load(pool.restitution);
        const V gravity = lanes_load(pool.gravity);
        const V end_depth = lanes_load(pool.end_depth);
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
        const M flying = lanes_load(pool.occupied) > zero;

        /* A new shot is looked at once; one that is not valid ends here. */
        if (refilled) {
            const M fresh = flying & (lanes_load(pool.fresh) > zero);
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
                permitted = LANES(hoop_permit)(ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, restitution, gravity, end_depth);
            const LANES(hoop_finite_state_out) o3 =
                LANES(hoop_finite_state)(vx, vy, vz, wx, wy, wz, x, y, z);
            M finite = o3.finite;
            const LANES(hoop_valid_out) o4 =
                LANES(hoop_valid)(last, x, y, z, ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, end_depth);
            V valid = o4.valid;
            V doubt = o4.doubt;
            const LANES(hoop_admitted_out) o5 =
                LANES(hoop_admitted)(doubt, finite, permitted, valid);
            outcome = lanes_select(fresh, o5.outcome, outcome);
            uncertain = lanes_select(fresh, o5.uncertain, uncertain);
            lanes_store(pool.fresh, zero);
            if (lanes_any(fresh & (outcome >= zero))) {
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
        const LANES(hoop_error_bounds_out) o6 =
            LANES(hoop_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
        V position_error = o6.position_error;
        V velocity_error = o6.velocity_error;
        const LANES(hoop_scale_out) o7 =
            LANES(hoop_scale)(x, y, z, vx, vy, vz, gravity);
        V extent = o7.extent;
        V speed = o7.speed;
        V excess = o7.excess;
        const LANES(hoop_opening_out) o8 =
            LANES(hoop_opening)(excess, position_error, velocity_error);
        V when = o8.when;
        V which = o8.which;
        V late = o8.late;
        V doubt = o8.doubt;
        const LANES(hoop_left_out) o9 =
            LANES(hoop_left)(K(3.0), last);
        V leaving = o9.leaving;
        const LANES(hoop_end_arrival_out) o10 =
            LANES(hoop_end_arrival)(leaving, z, vz, gravity, end_depth);
        V time = o10.time;
        V rate = o10.rate;
        V bend = o10.bend;
        V apex = o10.apex;
        V height = o10.height;
        const LANES(hoop_meeting_plane_out) o11 =
            LANES(hoop_meeting_plane)(bend, rate, time);
        M arrives = o11.arrives;
        V ceiling = o11.ceiling;
        const LANES(hoop_end_margin_out) o12 =
            LANES(hoop_end_margin)(time, extent, speed, position_error, velocity_error, gravity, end_depth);
        V margin = o12.margin;
        const LANES(hoop_crossing_out) o13 =
            LANES(hoop_crossing)(margin, K(0.0), rate, ceiling);
        V clearance = o13.clearance;
        V delay = o13.delay;
        const LANES(hoop_timely_out) o14 =
            LANES(hoop_timely)(arrives, delay, late, time, when);
        M possible = o14.possible;
        const LANES(hoop_end_margin_out) o15 =
            LANES(hoop_end_margin)(apex, extent, speed, position_error, velocity_error, gravity, end_depth);
        margin = o15.margin;
        const LANES(hoop_grazed_out) o16 =
            LANES(hoop_grazed)(apex, doubt, height, margin);
        doubt = o16.doubt;
        const M m17 = flying & possible;
        {
            const LANES(hoop_crossed_out) o18 =
                LANES(hoop_crossed)(arrives, clearance, doubt, time);
            doubt = lanes_select(m17, o18.doubt, doubt);
            const LANES(hoop_tied_out) o19 =
                LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
            doubt = lanes_select(m17, o19.doubt, doubt);
            late = lanes_select(m17, o19.late, late);
            const LANES(hoop_sooner_out) o20 =
                LANES(hoop_sooner)(arrives, K(3.0), time, when, which);
            when = lanes_select(m17, o20.when, when);
            which = lanes_select(m17, o20.which, which);
        }
        const LANES(hoop_left_out) o21 =
            LANES(hoop_left)(K(1.0), last);
        leaving = o21.leaving;
        const LANES(hoop_backboard_arrival_out) o22 =
            LANES(hoop_backboard_arrival)(leaving, x, vx, ball_radius, board_distance);
        time = o22.time;
        rate = o22.rate;
        bend = o22.bend;
        apex = o22.apex;
        height = o22.height;
        const LANES(hoop_meeting_plane_out) o23 =
            LANES(hoop_meeting_plane)(bend, rate, time);
        arrives = o23.arrives;
        ceiling = o23.ceiling;
        const LANES(hoop_backboard_margin_out) o24 =
            LANES(hoop_backboard_margin)(time, extent, speed, position_error, velocity_error, ball_radius, board_distance, gravity);
        margin = o24.margin;
        const LANES(hoop_crossing_out) o25 =
            LANES(hoop_crossing)(margin, K(0.0), rate, ceiling);
        clearance = o25.clearance;
        delay = o25.delay;
        const LANES(hoop_timely_out) o26 =
            LANES(hoop_timely)(arrives, delay, late, time, when);
        possible = o26.possible;
        const LANES(hoop_backboard_margin_out) o27 =
            LANES(hoop_backboard_margin)(apex, extent, speed, position_error, velocity_error, ball_radius, board_distance, gravity);
        margin = o27.margin;
        const LANES(hoop_grazed_out) o28 =
            LANES(hoop_grazed)(apex, doubt, height, margin);
        doubt = o28.doubt;
        const M m29 = flying & possible;
        if (lanes_any(m29)) {
            const LANES(hoop_flight_out) o30 =
                LANES(hoop_flight)(time, x, y, z, vx, vy, vz, gravity);
            V there_y = o30.y;
            V there_z = o30.z;
            const LANES(hoop_backboard_bounds_out) o31 =
                LANES(hoop_backboard_bounds)(there_y, there_z, board_half_width, board_bottom, board_top);
            V g0 = o31.g0;
            V g1 = o31.g1;
            V g2 = o31.g2;
            V g3 = o31.g3;
            const LANES(hoop_displacement_out) o32 =
                LANES(hoop_displacement)(delay, time, extent, speed, position_error, velocity_error, ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, gravity, end_depth);
            V slack = o32.margin;
            const LANES(hoop_backboard_edges_out) o33 =
                LANES(hoop_backboard_edges)(clearance, g0, g1, g2, g3, slack);
            M unsure = o33.unsure;
            const LANES(hoop_questioned_out) o34 =
                LANES(hoop_questioned)(doubt, time, unsure);
            doubt = lanes_select(m29, o34.doubt, doubt);
            const LANES(hoop_backboard_within_out) o35 =
                LANES(hoop_backboard_within)(g0, g1, g2, g3);
            M arrives = o35.arrives;
            const LANES(hoop_tied_out) o36 =
                LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
            doubt = lanes_select(m29, o36.doubt, doubt);
            late = lanes_select(m29, o36.late, late);
            const LANES(hoop_sooner_out) o37 =
                LANES(hoop_sooner)(arrives, K(1.0), time, when, which);
            when = lanes_select(m29, o37.when, when);
            which = lanes_select(m29, o37.which, which);
        }
        const LANES(hoop_left_out) o38 =
            LANES(hoop_left)(K(2.0), last);
        leaving = o38.leaving;
        const LANES(hoop_bridge_arrival_out) o39 =
            LANES(hoop_bridge_arrival)(leaving, z, vz, ball_radius, wire_radius, gravity);
        time = o39.time;
        rate = o39.rate;
        bend = o39.bend;
        apex = o39.apex;
        height = o39.height;
        const LANES(hoop_meeting_plane_out) o40 =
            LANES(hoop_meeting_plane)(bend, rate, time);
        arrives = o40.arrives;
        ceiling = o40.ceiling;
        const LANES(hoop_bridge_margin_out) o41 =
            LANES(hoop_bridge_margin)(time, extent, speed, position_error, velocity_error, ball_radius, wire_radius, gravity);
        margin = o41.margin;
        const LANES(hoop_crossing_out) o42 =
            LANES(hoop_crossing)(margin, K(0.0), rate, ceiling);
        clearance = o42.clearance;
        delay = o42.delay;
        const LANES(hoop_timely_out) o43 =
            LANES(hoop_timely)(arrives, delay, late, time, when);
        possible = o43.possible;
        const LANES(hoop_bridge_margin_out) o44 =
            LANES(hoop_bridge_margin)(apex, extent, speed, position_error, velocity_error, ball_radius, wire_radius, gravity);
        margin = o44.margin;
        const LANES(hoop_grazed_out) o45 =
            LANES(hoop_grazed)(apex, doubt, height, margin);
        doubt = o45.doubt;
        const M m46 = flying & possible;
        if (lanes_any(m46)) {
            const LANES(hoop_flight_out) o47 =
                LANES(hoop_flight)(time, x, y, z, vx, vy, vz, gravity);
            V there_x = o47.x;
            V there_y = o47.y;
            const LANES(hoop_bridge_bounds_out) o48 =
                LANES(hoop_bridge_bounds)(there_x, there_y, ring_radius, board_distance, bridge_half_width);
            V g0 = o48.g0;
            V g1 = o48.g1;
            V g2 = o48.g2;
            V g3 = o48.g3;
            V g4 = o48.g4;
            const LANES(hoop_displacement_out) o49 =
                LANES(hoop_displacement)(delay, time, extent, speed, position_error, velocity_error, ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, gravity, end_depth);
            V slack = o49.margin;
            const LANES(hoop_bridge_edges_out) o50 =
                LANES(hoop_bridge_edges)(clearance, g0, g1, g2, g3, g4, slack);
            M unsure = o50.unsure;
            const LANES(hoop_questioned_out) o51 =
                LANES(hoop_questioned)(doubt, time, unsure);
            doubt = lanes_select(m46, o51.doubt, doubt);
            const LANES(hoop_bridge_within_out) o52 =
                LANES(hoop_bridge_within)(g0, g1, g2, g3, g4);
            M arrives = o52.arrives;
            const LANES(hoop_tied_out) o53 =
                LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
            doubt = lanes_select(m46, o53.doubt, doubt);
            late = lanes_select(m46, o53.late, late);
            const LANES(hoop_sooner_out) o54 =
                LANES(hoop_sooner)(arrives, K(2.0), time, when, which);
            when = lanes_select(m46, o54.when, when);
            which = lanes_select(m46, o54.which, which);
        }
        const LANES(hoop_horizon_out) o55 =
            LANES(hoop_horizon)(when, speed, gravity);
        V until = o55.horizon;
        V pad = o55.pad;
        const LANES(hoop_ring_clear_out) o56 =
            LANES(hoop_ring_clear)(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, ball_radius, ring_radius, wire_radius, gravity);
        V clear = o56.clear;
        const LANES(hoop_opens_out) o57 =
            LANES(hoop_opens)(clear);
        M open = o57.open;
        const M m58 = flying & open;
        if (lanes_any(m58)) {
            const LANES(hoop_ring_prepare_out) o59 =
                LANES(hoop_ring_prepare)(until, x, y, z, vx, vy, vz, position_error, velocity_error, ball_radius, ring_radius, wire_radius, gravity);
            V steady = o59.steady;
            V swing = o59.swing;
            V rho_start = o59.rho_start;
            V low0 = o59.low0;
            V high0 = o59.high0;
            V low1 = o59.low1;
            V high1 = o59.high1;
            V low2 = o59.low2;
            V high2 = o59.high2;
            V ceiling = o59.ceiling;
            V latest = o59.latest;
            V lost = o59.lost;
            const LANES(hoop_beginning_out) o60 =
                LANES(hoop_beginning)();
            V share = o60.share;
            V arrival = o60.arrival;
            M certain = o60.certain;
            const LANES(hoop_allowance_out) o61 =
                LANES(hoop_allowance)(share, latest, extent, speed, position_error, velocity_error, gravity);
            V level = o61.level;
            V velocity_level = o61.velocity_level;
            V excess = o61.excess;
            const LANES(hoop_ring_margins_out) o62 =
                LANES(hoop_ring_margins)(latest, extent, speed, level, velocity_level, ball_radius, ring_radius, wire_radius, gravity);
            V flat = o62.margin;
            V tilt = o62.leaving_margin;
            V rate_slack = o62.rate_margin;
            const LANES(hoop_beyond_out) o63 =
                LANES(hoop_beyond)(doubt, excess, late, lost, pad);
            doubt = lanes_select(m58, o63.doubt, doubt);
            const LANES(hoop_ring_enter_out) o64 =
                LANES(hoop_ring_enter)(K(0.0), K(0.0), high0, high1, high2, low0, low1, low2, K(0.0));
            V t = o64.t;
            V end = o64.end;
            M searching = o64.searching;
            for (int turn = 0; turn < 201; turn++) {
                const M m65 = m58 & searching;
                if (!lanes_any(m65))
                    break;
                const LANES(hoop_nearby_out) o66 =
                    LANES(hoop_nearby)(flat, K(0.0), last, t, tilt);
                V leaving = o66.leaving;
                V margin = o66.margin;
                const LANES(hoop_ring_advance_out) o67 =
                    LANES(hoop_ring_advance)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, steady, swing, rho_start, ball_radius, ring_radius, wire_radius, gravity);
                V gap = o67.gap;
                V rate = o67.rate;
                V bend = o67.bend;
                V step = o67.step;
                V next = o67.next;
                V root = o67.root;
                V clearance = o67.clearance;
                const LANES(hoop_struck_out) o68 =
                    LANES(hoop_struck)(bend, clearance, gap, margin, rate, rate_slack, share);
                M hit = o68.hit;
                M sure = o68.sure;
                M vague = o68.vague;
                const M m69 = m65 & vague;
                if (lanes_any(m69)) {
                    const LANES(hoop_finer_out) o70 =
                        LANES(hoop_finer)(share);
                    share = lanes_select(m69, o70.share, share);
                    const LANES(hoop_allowance_out) o71 =
                        LANES(hoop_allowance)(share, latest, extent, speed, position_error, velocity_error, gravity);
                    V level = o71.level;
                    V velocity_level = o71.velocity_level;
                    V excess = o71.excess;
                    const LANES(hoop_ring_margins_out) o72 =
                        LANES(hoop_ring_margins)(latest, extent, speed, level, velocity_level, ball_radius, ring_radius, wire_radius, gravity);
                    flat = lanes_select(m69, o72.margin, flat);
                    tilt = lanes_select(m69, o72.leaving_margin, tilt);
                    rate_slack = lanes_select(m69, o72.rate_margin, rate_slack);
                    const LANES(hoop_exceeded_out) o73 =
                        LANES(hoop_exceeded)(doubt, excess, t);
                    doubt = lanes_select(m69, o73.doubt, doubt);
                }
                const LANES(hoop_advanced_out) o74 =
                    LANES(hoop_advanced)(arrival, certain, end, hit, next, root, step, sure, t, vague);
                arrival = lanes_select(m65, o74.arrival, arrival);
                certain = lanes_choose(m65, o74.certain, certain);
                M exhausted = o74.exhausted;
                searching = lanes_choose(m65, o74.searching, searching);
                t = lanes_select(m65, o74.t, t);
                const M m75 = m65 & exhausted;
                {
                    const LANES(hoop_ring_enter_out) o76 =
                        LANES(hoop_ring_enter)(end, end, high0, high1, high2, low0, low1, low2, t);
                    t = lanes_select(m75, o76.t, t);
                    end = lanes_select(m75, o76.end, end);
                    searching = lanes_choose(m75, o76.searching, searching);
                }
            }
            const LANES(hoop_questioned_out) o77 =
                LANES(hoop_questioned)(doubt, t, searching);
            doubt = lanes_select(m58, o77.doubt, doubt);
            const LANES(hoop_found_out) o78 =
                LANES(hoop_found)(arrival);
            M arrives = o78.arrives;
            const LANES(hoop_nearby_out) o79 =
                LANES(hoop_nearby)(flat, K(0.0), last, arrival, tilt);
            V leaving = o79.leaving;
            const LANES(hoop_ring_refine_out) o80 =
                LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, ball_radius, ring_radius, wire_radius, gravity);
            V refined = o80.time;
            const LANES(hoop_polished_out) o81 =
                LANES(hoop_polished)(arrival, certain, refined);
            arrival = o81.arrival;
            const LANES(hoop_ring_refine_out) o82 =
                LANES(hoop_ring_refine)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, ball_radius, ring_radius, wire_radius, gravity);
            refined = o82.time;
            V rate = o82.rate;
            const LANES(hoop_polished_out) o83 =
                LANES(hoop_polished)(arrival, certain, refined);
            arrival = o83.arrival;
            const LANES(hoop_ring_margins_out) o84 =
                LANES(hoop_ring_margins)(latest, extent, speed, position_error, velocity_error, ball_radius, ring_radius, wire_radius, gravity);
            flat = o84.margin;
            tilt = o84.leaving_margin;
            V rate_margin = o84.rate_margin;
            const LANES(hoop_own_margin_out) o85 =
                LANES(hoop_own_margin)(arrival, flat, leaving, tilt);
            V margin = o85.margin;
            const LANES(hoop_crossing_out) o86 =
                LANES(hoop_crossing)(margin, rate_margin, rate, ceiling);
            V clearance = o86.clearance;
            V delay = o86.delay;
            const LANES(hoop_landed_out) o87 =
                LANES(hoop_landed)(arrival);
            V time = o87.time;
            const LANES(hoop_landed_surely_out) o88 =
                LANES(hoop_landed_surely)(arrives, certain, clearance, delay, doubt, time);
            delay = o88.delay;
            doubt = lanes_select(m58, o88.doubt, doubt);
            const LANES(hoop_tied_out) o89 =
                LANES(hoop_tied)(arrives, delay, doubt, late, time, when);
            doubt = lanes_select(m58, o89.doubt, doubt);
            late = lanes_select(m58, o89.late, late);
            const LANES(hoop_sooner_out) o90 =
                LANES(hoop_sooner)(arrives, K(0.0), time, when, which);
            when = lanes_select(m58, o90.when, when);
            which = lanes_select(m58, o90.which, which);
        }
        const LANES(hoop_departed_out) o91 =
            LANES(hoop_departed)(K(3.0), which);
        M moves = o91.moves;
        M ends = o91.ends;
        M touches = o91.touches;
        const LANES(hoop_body_of_out) o92 =
            LANES(hoop_body_of)(which);
        V body = o92.body;
        const M m93 = flying & moves;
        {
            const LANES(hoop_flight_out) o94 =
                LANES(hoop_flight)(when, x, y, z, vx, vy, vz, gravity);
            x = lanes_select(m93, o94.x, x);
            y = lanes_select(m93, o94.y, y);
            z = lanes_select(m93, o94.z, z);
            vx = lanes_select(m93, o94.vx, vx);
            vy = lanes_select(m93, o94.vy, vy);
            vz = lanes_select(m93, o94.vz, vz);
            const LANES(hoop_ticked_out) o95 =
                LANES(hoop_ticked)(clock, when);
            clock = lanes_select(m93, o95.clock, clock);
        }
        const LANES(hoop_displacement_out) o96 =
            LANES(hoop_displacement)(late, when, extent, speed, position_error, velocity_error, ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, gravity, end_depth);
        V slack = o96.margin;
        const LANES(hoop_target_out) o97 =
            LANES(hoop_target)(x, y, ring_radius);
        V miss = o97.target;
        const LANES(hoop_doubted_out) o98 =
            LANES(hoop_doubted)(doubt, ends, late, miss, slack, uncertain, when);
        uncertain = o98.uncertain;
        const LANES(hoop_accounted_out) o99 =
            LANES(hoop_accounted)(contacts, ends, miss, most_contacts, touches);
        contacts = o99.contacts;
        outcome = o99.outcome;
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
        const LANES(hoop_meeting_out) o100 =
            LANES(hoop_meeting)(claims, ends, touches);
        M meeting = o100.meeting;
        const M m101 = flying & meeting;
        if (lanes_any(m101)) {
            const LANES(hoop_end_normal_out) o102 =
                LANES(hoop_end_normal)();
            V nx = o102.nx;
            V ny = o102.ny;
            V nz = o102.nz;
            const LANES(hoop_here_out) o103 =
                LANES(hoop_here)(K(0.0), which);
            M here = o103.here;
            const M m104 = m101 & here;
            {
                const LANES(hoop_ring_normal_out) o105 =
                    LANES(hoop_ring_normal)(x, y, z, ball_radius, ring_radius, wire_radius);
                nx = lanes_select(m104, o105.nx, nx);
                ny = lanes_select(m104, o105.ny, ny);
                nz = lanes_select(m104, o105.nz, nz);
                const LANES(hoop_counted_out) o106 =
                    LANES(hoop_counted)(count_0);
                count_0 = lanes_select(m104, o106.count, count_0);
            }
            const LANES(hoop_here_out) o107 =
                LANES(hoop_here)(K(1.0), which);
            here = o107.here;
            const M m108 = m101 & here;
            {
                const LANES(hoop_backboard_normal_out) o109 =
                    LANES(hoop_backboard_normal)();
                nx = lanes_select(m108, o109.nx, nx);
                ny = lanes_select(m108, o109.ny, ny);
                nz = lanes_select(m108, o109.nz, nz);
                const LANES(hoop_counted_out) o110 =
                    LANES(hoop_counted)(count_1);
                count_1 = lanes_select(m108, o110.count, count_1);
            }
            const LANES(hoop_here_out) o111 =
                LANES(hoop_here)(K(2.0), which);
            here = o111.here;
            const M m112 = m101 & here;
            {
                const LANES(hoop_bridge_normal_out) o113 =
                    LANES(hoop_bridge_normal)();
                nx = lanes_select(m112, o113.nx, nx);
                ny = lanes_select(m112, o113.ny, ny);
                nz = lanes_select(m112, o113.nz, nz);
                const LANES(hoop_counted_out) o114 =
                    LANES(hoop_counted)(count_2);
                count_2 = lanes_select(m112, o114.count, count_2);
            }
            const LANES(hoop_elsewhere_out) o115 =
                LANES(hoop_elsewhere)();
            V curving = o115.curving;
            const LANES(hoop_again_out) o116 =
                LANES(hoop_again)(K(0.0), last, which);
            M again = o116.again;
            const M m117 = m101 & again;
            {
                const LANES(hoop_ring_curvature_out) o118 =
                    LANES(hoop_ring_curvature)(ball_radius, ring_radius, wire_radius);
                curving = lanes_select(m117, o118.curvature, curving);
            }
            const LANES(hoop_again_out) o119 =
                LANES(hoop_again)(K(1.0), last, which);
            again = o119.again;
            const M m120 = m101 & again;
            {
                const LANES(hoop_backboard_curvature_out) o121 =
                    LANES(hoop_backboard_curvature)();
                curving = lanes_select(m120, o121.curvature, curving);
            }
            const LANES(hoop_again_out) o122 =
                LANES(hoop_again)(K(2.0), last, which);
            again = o122.again;
            const M m123 = m101 & again;
            {
                const LANES(hoop_bridge_curvature_out) o124 =
                    LANES(hoop_bridge_curvature)();
                curving = lanes_select(m123, o124.curvature, curving);
            }
            const LANES(hoop_carry_flight_out) o125 =
                LANES(hoop_carry_flight)(when, x, y, z, vx, vy, vz, nx, ny, nz, clock, contacts, late, dx, dy, dz, dvx, dvy, dvz, curving, gravity);
            dx = lanes_select(m101, o125.dx, dx);
            dy = lanes_select(m101, o125.dy, dy);
            dz = lanes_select(m101, o125.dz, dz);
            dvx = lanes_select(m101, o125.dvx, dvx);
            dvy = lanes_select(m101, o125.dvy, dvy);
            dvz = lanes_select(m101, o125.dvz, dvz);
            V delay = o125.delay;
            V shift = o125.shift;
            const LANES(hoop_delayed_out) o126 =
                LANES(hoop_delayed)(clock_error, delay);
            clock_error = lanes_select(m101, o126.clock_error, clock_error);
            const M m127 = m101 & ends;
            {
                const LANES(hoop_floored_out) o128 =
                    LANES(hoop_floored)(dx, dy, dz, shift);
                dx = lanes_select(m127, o128.dx, dx);
                dy = lanes_select(m127, o128.dy, dy);
                dz = lanes_select(m127, o128.dz, dz);
            }
            const LANES(hoop_unturned_out) o129 =
                LANES(hoop_unturned)();
            V dnx = o129.dnx;
            V dny = o129.dny;
            V dnz = o129.dnz;
            V turn = o129.turn;
            const LANES(hoop_here_out) o130 =
                LANES(hoop_here)(K(0.0), which);
            here = o130.here;
            const M m131 = m101 & here;
            if (lanes_any(m131)) {
                const LANES(hoop_ring_carry_normal_out) o132 =
                    LANES(hoop_ring_carry_normal)(x, y, dx, dy, dz, shift, ball_radius, ring_radius, wire_radius);
                dnx = lanes_select(m131, o132.dnx, dnx);
                dny = lanes_select(m131, o132.dny, dny);
                dnz = lanes_select(m131, o132.dnz, dnz);
                turn = lanes_select(m131, o132.turn, turn);
            }
            const M m133 = m101 & touches;
            if (lanes_any(m133)) {
                const LANES(hoop_carry_impact_out) o134 =
                    LANES(hoop_carry_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, contacts, dvx, dvy, dvz, dwx, dwy, dwz, dnx, dny, dnz, turn, ball_radius, restitution);
                dvx = lanes_select(m133, o134.dvx, dvx);
                dvy = lanes_select(m133, o134.dvy, dvy);
                dvz = lanes_select(m133, o134.dvz, dvz);
                dwx = lanes_select(m133, o134.dwx, dwx);
                dwy = lanes_select(m133, o134.dwy, dwy);
                dwz = lanes_select(m133, o134.dwz, dwz);
                const LANES(hoop_impact_out) o135 =
                    LANES(hoop_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, ball_radius, restitution);
                vx = lanes_select(m133, o135.vx, vx);
                vy = lanes_select(m133, o135.vy, vy);
                vz = lanes_select(m133, o135.vz, vz);
                wx = lanes_select(m133, o135.wx, wx);
                wy = lanes_select(m133, o135.wy, wy);
                wz = lanes_select(m133, o135.wz, wz);
            }
            const LANES(hoop_here_out) o136 =
                LANES(hoop_here)(K(1.0), which);
            here = o136.here;
            const M m137 = m101 & here;
            {
                const LANES(hoop_backboard_place_out) o138 =
                    LANES(hoop_backboard_place)(y, z, ball_radius, board_distance);
                x = lanes_select(m137, o138.x, x);
                y = lanes_select(m137, o138.y, y);
                z = lanes_select(m137, o138.z, z);
            }
            const LANES(hoop_here_out) o139 =
                LANES(hoop_here)(K(2.0), which);
            here = o139.here;
            const M m140 = m101 & here;
            {
                const LANES(hoop_bridge_place_out) o141 =
                    LANES(hoop_bridge_place)(x, y, ball_radius, wire_radius);
                x = lanes_select(m140, o141.x, x);
                y = lanes_select(m140, o141.y, y);
                z = lanes_select(m140, o141.z, z);
            }
            const M m142 = m101 & touches;
            {
                const LANES(hoop_touched_out) o143 =
                    LANES(hoop_touched)(body, first, which);
                first = lanes_select(m142, o143.first, first);
                last = lanes_select(m142, o143.last, last);
            }
        }
        const LANES(hoop_closing_out) o144 =
            LANES(hoop_closing)(claims, outcome);
        M closed = o144.closed;
        const M m145 = flying & closed;
        {
            const LANES(hoop_claimed_errors_out) o146 =
                LANES(hoop_claimed_errors)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            position_claim = lanes_select(m145, o146.position_error, position_claim);
            velocity_claim = lanes_select(m145, o146.velocity_error, velocity_claim);
            spin_claim = lanes_select(m145, o146.spin_error, spin_claim);
            time_claim = lanes_select(m145, o146.time_error, time_claim);
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
#undef NOT
#undef NOWHERE
#undef lanes_select
#undef lanes_choose
#undef lanes_abs
#undef lanes_sqrt
#undef lanes_any
#undef lanes_load
#undef lanes_store
#undef lanes_gather
