/* The event loop of the scene hoop, LANES_WIDTH shots abreast.

   Generated from templates/c/engine.h.j2, scene hoop, derivation 604c640efcccdbbc,
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
#define lanes_abs LANES(abs)
#define lanes_sqrt LANES(sqrt)
#define lanes_any LANES(any)
#define lanes_load LANES(load)
#define lanes_store LANES(store)
#define lanes_gather LANES(gather)

#if LANES_WIDTH == 1
#define K(c) (c)
#define NOT(m) (!(m))
LANES_INLINE V lanes_select(M m, V a, V b) { return m ? a : b; }
LANES_INLINE V lanes_abs(V a) { return fabs(a); }
LANES_INLINE V lanes_sqrt(V a) { return sqrt(a); }
LANES_INLINE int lanes_any(M m) { return m; }
#else
#define K(c) ((c) - (V){0})
#define NOT(m) (~(m))
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
    double x[LANES_WIDTH], y[LANES_WIDTH], z[LANES_WIDTH], vx[LANES_WIDTH], vy[LANES_WIDTH], vz[LANES_WIDTH], wx[LANES_WIDTH], wy[LANES_WIDTH], wz[LANES_WIDTH];
    double ball_radius[LANES_WIDTH], ring_radius[LANES_WIDTH], wire_radius[LANES_WIDTH], board_distance[LANES_WIDTH], board_half_width[LANES_WIDTH], board_bottom[LANES_WIDTH], board_top[LANES_WIDTH], bridge_half_width[LANES_WIDTH], restitution[LANES_WIDTH], gravity[LANES_WIDTH], end_depth[LANES_WIDTH];
    double dx[LANES_WIDTH], dy[LANES_WIDTH], dz[LANES_WIDTH], dvx[LANES_WIDTH], dvy[LANES_WIDTH], dvz[LANES_WIDTH], dwx[LANES_WIDTH], dwy[LANES_WIDTH], dwz[LANES_WIDTH]; /* carried errors of the state */
    double clock_error[LANES_WIDTH];
    double bounds[4][LANES_WIDTH]; /* of the errors: position, velocity, spin, time */
    double clock[LANES_WIDTH];     /* time of the last contact */
    double last[LANES_WIDTH];      /* surface of the last contact, -1: none */
    double first[LANES_WIDTH];     /* surface of the first one */
    double contacts[LANES_WIDTH];
    double uncertain[LANES_WIDTH]; /* 1 or 0 */
    double count_ring[LANES_WIDTH];
    double count_backboard[LANES_WIDTH];
    double count_bridge[LANES_WIDTH];
    double from[LANES_WIDTH];      /* surface that the shot starts on, -1: none */
    double outcome[LANES_WIDTH];   /* -1: in flight */
    double occupied[LANES_WIDTH];  /* 1: holds a shot */
    double fresh[LANES_WIDTH];     /* 1: and has not been looked at */
    size_t shot[LANES_WIDTH];
} LANES(hoop_pool);

/* Where the parameters are finite and allowed. */
LANES_INLINE M LANES(hoop_check)(V ball_radius, V ring_radius, V wire_radius, V board_distance, V board_half_width, V board_bottom, V board_top, V bridge_half_width, V restitution, V gravity, V end_depth)
{
    V sum = K(0.0);
    sum = sum + (ball_radius - ball_radius);
    sum = sum + (ring_radius - ring_radius);
    sum = sum + (wire_radius - wire_radius);
    sum = sum + (board_distance - board_distance);
    sum = sum + (board_half_width - board_half_width);
    sum = sum + (board_bottom - board_bottom);
    sum = sum + (board_top - board_top);
    sum = sum + (bridge_half_width - bridge_half_width);
    sum = sum + (restitution - restitution);
    sum = sum + (gravity - gravity);
    sum = sum + (end_depth - end_depth);
    return (sum == K(0.0)) & (LANES(hoop_allowed)(ball_radius, ring_radius, wire_radius, board_distance, board_half_width, bridge_half_width, restitution, gravity, end_depth).allowed > K(0.0));
}

/* Put the next shot into a lane; all that starts at zero is set when it is first looked at. */
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
    if (out->outcome)
        out->outcome[shot] = (uint8_t)pool->outcome[lane];
    if (out->contacts)
        out->contacts[shot] = (int32_t)pool->contacts[lane];
    if (out->counts) {
        out->counts[HOOP_SURFACES * shot + 0] = (int32_t)pool->count_ring[lane];
        out->counts[HOOP_SURFACES * shot + 1] = (int32_t)pool->count_backboard[lane];
        out->counts[HOOP_SURFACES * shot + 2] = (int32_t)pool->count_bridge[lane];
    }
    if (out->first)
        out->first[shot] = (int8_t)pool->first[lane];
    if (out->time)
        out->time[shot] = invalid ? NAN : pool->clock[lane];
    if (out->state) {
        out->state[HOOP_STATE * shot + 0] = invalid ? NAN : pool->x[lane];
        out->state[HOOP_STATE * shot + 1] = invalid ? NAN : pool->y[lane];
        out->state[HOOP_STATE * shot + 2] = invalid ? NAN : pool->z[lane];
        out->state[HOOP_STATE * shot + 3] = invalid ? NAN : pool->vx[lane];
        out->state[HOOP_STATE * shot + 4] = invalid ? NAN : pool->vy[lane];
        out->state[HOOP_STATE * shot + 5] = invalid ? NAN : pool->vz[lane];
        out->state[HOOP_STATE * shot + 6] = invalid ? NAN : pool->wx[lane];
        out->state[HOOP_STATE * shot + 7] = invalid ? NAN : pool->wy[lane];
        out->state[HOOP_STATE * shot + 8] = invalid ? NAN : pool->wz[lane];
    }
    if (out->time_error)
        out->time_error[shot] = invalid ? NAN : pool->bounds[3][lane];
    if (out->state_error)
        for (int k = 0; k < 3; k++)
            out->state_error[3 * shot + (size_t)k] = invalid ? NAN : pool->bounds[k][lane];
    if (out->uncertain)
        out->uncertain[shot] = pool->uncertain[lane] > 0.0;
    pool->occupied[lane] = 0.0;
}

/* Run the job: fill the lanes, take every lane to its next event, free those that ended. Where
   nobody asks what is uncertain, `certified` is 0, a constant: the compiler leaves out all that only
   bounds errors. The path does not depend on it. */
LANES_INLINE void LANES(hoop_loop)(const hoop_job *job, const int certified)
{
    LANES(hoop_pool) pool;
    memset(&pool, 0, sizeof pool);
    const V most_contacts = K((double)job->max_contacts);
    const V zero = K(0.0), one = K(1.0), none = K(-1.0), never = K(INFINITY);
    const int wants_errors = certified && (job->results->time_error || job->results->state_error);
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
    M allowed = LANES(hoop_check)(lanes_load(pool.ball_radius), lanes_load(pool.ring_radius), lanes_load(pool.wire_radius), lanes_load(pool.board_distance), lanes_load(pool.board_half_width), lanes_load(pool.board_bottom), lanes_load(pool.board_top), lanes_load(pool.bridge_half_width), lanes_load(pool.restitution), lanes_load(pool.gravity), lanes_load(pool.end_depth));
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

        V x = lanes_load(pool.x);
        V y = lanes_load(pool.y);
        V z = lanes_load(pool.z);
        V vx = lanes_load(pool.vx);
        V vy = lanes_load(pool.vy);
        V vz = lanes_load(pool.vz);
        V wx = lanes_load(pool.wx);
        V wy = lanes_load(pool.wy);
        V wz = lanes_load(pool.wz);
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
        V dx = !certified ? zero : lanes_load(pool.dx);
        V dy = !certified ? zero : lanes_load(pool.dy);
        V dz = !certified ? zero : lanes_load(pool.dz);
        V dvx = !certified ? zero : lanes_load(pool.dvx);
        V dvy = !certified ? zero : lanes_load(pool.dvy);
        V dvz = !certified ? zero : lanes_load(pool.dvz);
        V dwx = !certified ? zero : lanes_load(pool.dwx);
        V dwy = !certified ? zero : lanes_load(pool.dwy);
        V dwz = !certified ? zero : lanes_load(pool.dwz);
        V clock_error = !certified ? zero : lanes_load(pool.clock_error);
        V uncertain = !certified ? zero : lanes_load(pool.uncertain);
        V clock = lanes_load(pool.clock);
        V last = lanes_load(pool.last);
        V first = lanes_load(pool.first);
        V contacts = lanes_load(pool.contacts);
        V count_ring = lanes_load(pool.count_ring);
        V count_backboard = lanes_load(pool.count_backboard);
        V count_bridge = lanes_load(pool.count_bridge);
        const M flying = lanes_load(pool.occupied) > zero;

        /* A new shot is looked at once; one that is not valid ends here. */
        if (refilled) {
            const M fresh = flying & (lanes_load(pool.fresh) > zero);
            dx = lanes_select(fresh, zero, dx);
            dy = lanes_select(fresh, zero, dy);
            dz = lanes_select(fresh, zero, dz);
            dvx = lanes_select(fresh, zero, dvx);
            dvy = lanes_select(fresh, zero, dvy);
            dvz = lanes_select(fresh, zero, dvz);
            dwx = lanes_select(fresh, zero, dwx);
            dwy = lanes_select(fresh, zero, dwy);
            dwz = lanes_select(fresh, zero, dwz);
            clock_error = lanes_select(fresh, zero, clock_error);
            uncertain = lanes_select(fresh, zero, uncertain);
            clock = lanes_select(fresh, zero, clock);
            last = lanes_select(fresh, lanes_load(pool.from), last);
            first = lanes_select(fresh, none, first);
            contacts = lanes_select(fresh, zero, contacts);
            count_ring = lanes_select(fresh, zero, count_ring);
            count_backboard = lanes_select(fresh, zero, count_backboard);
            count_bridge = lanes_select(fresh, zero, count_bridge);
            if (job->varying)
                allowed = LANES(hoop_check)(ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, restitution, gravity, end_depth);
            const LANES(hoop_valid_out) check = LANES(hoop_valid)(last, x, y, z, ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, end_depth);
            V sum = zero;
            sum = sum + (x - x);
            sum = sum + (y - y);
            sum = sum + (z - z);
            sum = sum + (vx - vx);
            sum = sum + (vy - vy);
            sum = sum + (vz - vz);
            sum = sum + (wx - wx);
            sum = sum + (wy - wy);
            sum = sum + (wz - wz);
            const M finite = allowed & (sum == zero);
            const M good = finite & (check.valid > zero);
            uncertain = lanes_select(fresh & finite & (check.doubt > zero), one, uncertain);
            lanes_store(pool.fresh, zero);
            if (lanes_any(fresh & NOT(good))) {
                lanes_store(pool.outcome, lanes_select(fresh & NOT(good), K((double)HOOP_INVALID), none));
                lanes_store(pool.dx, dx);
                lanes_store(pool.dy, dy);
                lanes_store(pool.dz, dz);
                lanes_store(pool.dvx, dvx);
                lanes_store(pool.dvy, dvy);
                lanes_store(pool.dvz, dvz);
                lanes_store(pool.dwx, dwx);
                lanes_store(pool.dwy, dwy);
                lanes_store(pool.dwz, dwz);
                lanes_store(pool.clock_error, clock_error);
                lanes_store(pool.uncertain, uncertain);
                lanes_store(pool.clock, clock);
                lanes_store(pool.last, last);
                lanes_store(pool.first, first);
                lanes_store(pool.contacts, contacts);
                lanes_store(pool.count_ring, count_ring);
                lanes_store(pool.count_backboard, count_backboard);
                lanes_store(pool.count_bridge, count_bridge);
                for (int lane = 0; lane < LANES_WIDTH; lane++)
                    if (pool.outcome[lane] >= 0.0 && pool.occupied[lane] != 0.0) {
                        LANES(hoop_finish)(&pool, lane, job);
                        flights--;
                    }
                continue;
            }
        }

        /* How far the state may be from the true one. */
        const LANES(hoop_error_bounds_out) bounds = LANES(hoop_error_bounds)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
        const V position_error = certified ? bounds.position_error : zero;
        const V velocity_error = certified ? bounds.velocity_error : zero;
        const LANES(hoop_scale_out) scale = LANES(hoop_scale)(x, y, z, vx, vy, vz, gravity);
        const V extent = scale.extent, speed = scale.speed;

        /* The earliest arrival: its time and surface, the bound on its delay, and the earliest
           time of a decision that lies within its rounding error. */
        V when = never, which = none, late = zero;
        const M bounded = (position_error < never) & (velocity_error < never) & (scale.excess <= zero);
        V doubt = lanes_select(bounded, never, zero);
        {
            const V leaving = lanes_select(last == K(3.0), one, zero);
            const LANES(hoop_end_arrival_out) a = LANES(hoop_end_arrival)(leaving, z, vz, gravity, end_depth);
            const M meets = (a.rate < zero) | ((a.rate <= zero) & (a.bend < zero) & (a.time == zero));
            M arrives = meets & (a.time >= zero) & (a.time < never);
            const V margin = LANES(hoop_end_margin)(a.time, extent, speed, position_error, velocity_error, gravity, end_depth).margin;
            const LANES(hoop_crossing_out) c = LANES(hoop_crossing)(margin, zero, a.rate, lanes_abs(a.bend));
            const V delay = certified ? c.delay : zero;
            arrives &= NOT(a.time - when > late + delay);
            {
                const V margin = LANES(hoop_end_margin)(a.apex, extent, speed, position_error, velocity_error, gravity, end_depth).margin;
                const M touches = (a.apex >= zero) & (lanes_abs(a.height) <= margin);
                doubt = lanes_select(touches & (a.apex < doubt), a.apex, doubt);
            }
            const M unsure = arrives & NOT(c.clearance > zero);
            doubt = lanes_select(unsure & (a.time < doubt), a.time, doubt);
                        {
                const M tie = arrives & (lanes_abs(a.time - when) <= delay + late);
                const V sooner = lanes_select(a.time < when, a.time, when);
                doubt = lanes_select(tie & (sooner < doubt), sooner, doubt);
                const M earlier = arrives & (a.time < when);
                when = lanes_select(earlier, a.time, when);
                which = lanes_select(earlier, K(3.0), which);
                late = lanes_select(earlier, delay, late);
            }
        }
        {
            const V leaving = lanes_select(last == K(1.0), one, zero);
            const LANES(hoop_backboard_arrival_out) a = LANES(hoop_backboard_arrival)(leaving, x, vx, ball_radius, board_distance);
            const M meets = (a.rate < zero) | ((a.rate <= zero) & (a.bend < zero) & (a.time == zero));
            M arrives = meets & (a.time >= zero) & (a.time < never);
            const V margin = LANES(hoop_backboard_margin)(a.time, extent, speed, position_error, velocity_error, ball_radius, board_distance, gravity).margin;
            const LANES(hoop_crossing_out) c = LANES(hoop_crossing)(margin, zero, a.rate, lanes_abs(a.bend));
            const V delay = certified ? c.delay : zero;
            arrives &= NOT(a.time - when > late + delay);
            {
                const V margin = LANES(hoop_backboard_margin)(a.apex, extent, speed, position_error, velocity_error, ball_radius, board_distance, gravity).margin;
                const M touches = (a.apex >= zero) & (lanes_abs(a.height) <= margin);
                doubt = lanes_select(touches & (a.apex < doubt), a.apex, doubt);
            }
            if (lanes_any(flying & arrives)) {
                const LANES(hoop_flight_out) f = LANES(hoop_flight)(a.time, x, y, z, vx, vy, vz, gravity);
                const LANES(hoop_backboard_bounds_out) g = LANES(hoop_backboard_bounds)(f.y, f.z, board_half_width, board_bottom, board_top);
                const V slack = LANES(hoop_displacement)(delay, a.time, extent, speed, position_error, velocity_error, ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, gravity, end_depth).margin;
                const M within = (g.g0 <= zero) & (g.g1 <= zero) & (g.g2 <= zero) & (g.g3 <= zero);
                const M near = (g.g0 <= slack) & (g.g1 <= slack) & (g.g2 <= slack) & (g.g3 <= slack);
                const M surely = (g.g0 < -slack) & (g.g1 < -slack) & (g.g2 < -slack) & (g.g3 < -slack);
                const M unsure = arrives & near & NOT(surely & (c.clearance > zero));
                doubt = lanes_select(unsure & (a.time < doubt), a.time, doubt);
                arrives &= within;
                            {
                const M tie = arrives & (lanes_abs(a.time - when) <= delay + late);
                const V sooner = lanes_select(a.time < when, a.time, when);
                doubt = lanes_select(tie & (sooner < doubt), sooner, doubt);
                const M earlier = arrives & (a.time < when);
                when = lanes_select(earlier, a.time, when);
                which = lanes_select(earlier, K(1.0), which);
                late = lanes_select(earlier, delay, late);
            }
            }
        }
        {
            const V leaving = lanes_select(last == K(2.0), one, zero);
            const LANES(hoop_bridge_arrival_out) a = LANES(hoop_bridge_arrival)(leaving, z, vz, ball_radius, wire_radius, gravity);
            const M meets = (a.rate < zero) | ((a.rate <= zero) & (a.bend < zero) & (a.time == zero));
            M arrives = meets & (a.time >= zero) & (a.time < never);
            const V margin = LANES(hoop_bridge_margin)(a.time, extent, speed, position_error, velocity_error, ball_radius, wire_radius, gravity).margin;
            const LANES(hoop_crossing_out) c = LANES(hoop_crossing)(margin, zero, a.rate, lanes_abs(a.bend));
            const V delay = certified ? c.delay : zero;
            arrives &= NOT(a.time - when > late + delay);
            {
                const V margin = LANES(hoop_bridge_margin)(a.apex, extent, speed, position_error, velocity_error, ball_radius, wire_radius, gravity).margin;
                const M touches = (a.apex >= zero) & (lanes_abs(a.height) <= margin);
                doubt = lanes_select(touches & (a.apex < doubt), a.apex, doubt);
            }
            if (lanes_any(flying & arrives)) {
                const LANES(hoop_flight_out) f = LANES(hoop_flight)(a.time, x, y, z, vx, vy, vz, gravity);
                const LANES(hoop_bridge_bounds_out) g = LANES(hoop_bridge_bounds)(f.x, f.y, ring_radius, board_distance, bridge_half_width);
                const V slack = LANES(hoop_displacement)(delay, a.time, extent, speed, position_error, velocity_error, ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, gravity, end_depth).margin;
                const M within = (g.g0 <= zero) & (g.g1 <= zero) & (g.g2 <= zero) & (g.g3 <= zero) & (g.g4 <= zero);
                const M near = (g.g0 <= slack) & (g.g1 <= slack) & (g.g2 <= slack) & (g.g3 <= slack) & (g.g4 <= slack);
                const M surely = (g.g0 < -slack) & (g.g1 < -slack) & (g.g2 < -slack) & (g.g3 < -slack) & (g.g4 < -slack);
                const M unsure = arrives & near & NOT(surely & (c.clearance > zero));
                doubt = lanes_select(unsure & (a.time < doubt), a.time, doubt);
                arrives &= within;
                            {
                const M tie = arrives & (lanes_abs(a.time - when) <= delay + late);
                const V sooner = lanes_select(a.time < when, a.time, when);
                doubt = lanes_select(tie & (sooner < doubt), sooner, doubt);
                const M earlier = arrives & (a.time < when);
                when = lanes_select(earlier, a.time, when);
                which = lanes_select(earlier, K(2.0), which);
                late = lanes_select(earlier, delay, late);
            }
            }
        }
        /* Nothing later than what has been found matters. */
        const LANES(hoop_horizon_out) until_ring = LANES(hoop_horizon)(when, speed, gravity);
        const M open_ring = flying & NOT(LANES(hoop_ring_clear)(until_ring.horizon, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, ball_radius, ring_radius, wire_radius, gravity).clear > zero);
        if (lanes_any(open_ring)) {
            const V horizon = until_ring.horizon;
            const LANES(hoop_ring_prepare_out) p = LANES(hoop_ring_prepare)(horizon, x, y, z, vx, vy, vz, position_error, velocity_error, ball_radius, ring_radius, wire_radius, gravity);
            const M gone = last == K(0.0);
            V share = K(2.9802322387695312e-08);
            const LANES(hoop_allowance_out) a = LANES(hoop_allowance)(share, p.latest, extent, speed, position_error, velocity_error, gravity);
            LANES(hoop_ring_margins_out) allowed = LANES(hoop_ring_margins)(p.latest, extent, speed, a.level, a.velocity_level, ball_radius, ring_radius, wire_radius, gravity);
            V t = zero, end = zero, arrival = never, delay = zero;
            const M beyond = open_ring & ((a.excess > zero) | (p.lost > zero) | (late > until_ring.pad));
            doubt = lanes_select(beyond, zero, doubt);
            M searching = flying & NOT(flying), certain = searching;
            const V low2 = lanes_select(p.low2 > zero, p.low2, zero);
            const V high2 = lanes_select(p.high2 < horizon, p.high2, horizon);
            {
                const M opens = open_ring & (low2 < high2);
                t = lanes_select(opens, low2, t);
                end = lanes_select(opens, high2, end);
                searching |= opens;
            }
            const V low1 = lanes_select(p.low1 > zero, p.low1, zero);
            const V high1 = lanes_select(p.high1 < horizon, p.high1, horizon);
            {
                const M opens = open_ring & (low1 < high1);
                t = lanes_select(opens, low1, t);
                end = lanes_select(opens, high1, end);
                searching |= opens;
            }
            const V low0 = lanes_select(p.low0 > zero, p.low0, zero);
            const V high0 = lanes_select(p.high0 < horizon, p.high0, horizon);
            {
                const M opens = open_ring & (low0 < high0);
                t = lanes_select(opens, low0, t);
                end = lanes_select(opens, high0, end);
                searching |= opens;
            }
            for (int step = 0; lanes_any(searching); step++) {
                /* Near the surface that the ball left, F/t is known better than F. */
                const V tilted = allowed.leaving_margin * t;
                const M nearby = gone & (tilted < allowed.margin);
                const V leaving = lanes_select(nearby, one, zero);
                const V margin = lanes_select(nearby, tilted, allowed.margin);
                const LANES(hoop_ring_advance_out) a = LANES(hoop_ring_advance)(t, end, leaving, margin, allowed.rate_margin, p.ceiling, x, y, z, vx, vy, vz, p.steady, p.swing, p.rho_start, ball_radius, ring_radius, wire_radius, gravity);
                const M falling = (a.rate < zero) | ((a.rate <= allowed.rate_margin) & (a.bend < zero));
                const M clear = falling & (a.clearance > zero);
                M hit = searching & falling & ((a.gap - margin <= margin) | clear);
                /* A root that is not certain is looked at again, with smaller errors allowed. */
                const M vague = hit & NOT(clear) & (share > zero);
                if (lanes_any(vague)) {
                    const V smaller = lanes_select(share > K(2.842170943040401e-14), share * K(0.03125), zero);
                    share = lanes_select(vague, smaller, share);
                    const LANES(hoop_allowance_out) less = LANES(hoop_allowance)(share, p.latest, extent, speed, position_error, velocity_error, gravity);
                    const LANES(hoop_ring_margins_out) fine = LANES(hoop_ring_margins)(p.latest, extent, speed, less.level, less.velocity_level, ball_radius, ring_radius, wire_radius, gravity);
                    allowed.margin = lanes_select(vague, fine.margin, allowed.margin);
                    allowed.leaving_margin = lanes_select(vague, fine.leaving_margin, allowed.leaving_margin);
                    allowed.rate_margin = lanes_select(vague, fine.rate_margin, allowed.rate_margin);
                    doubt = lanes_select(vague & (less.excess > zero) & (t < doubt), t, doubt);
                    hit &= NOT(vague);
                }
                arrival = lanes_select(hit, lanes_select(clear, a.root, t), arrival);
                certain |= hit & clear;
                searching &= NOT(hit);
                const M exhausted = searching & NOT(vague) & (a.step >= end - t);
                const V passed = end;
                t = lanes_select(searching & NOT(vague), a.next, t);
                if (lanes_any(exhausted)) {
                    M more = searching & NOT(searching);
                    {
                        const M opens = exhausted & (low2 < high2) & (low2 >= passed);
                        t = lanes_select(opens, low2, t);
                        end = lanes_select(opens, high2, end);
                        more |= opens;
                    }
                    {
                        const M opens = exhausted & (low1 < high1) & (low1 >= passed);
                        t = lanes_select(opens, low1, t);
                        end = lanes_select(opens, high1, end);
                        more |= opens;
                    }
                    {
                        const M opens = exhausted & (low0 < high0) & (low0 >= passed);
                        t = lanes_select(opens, low0, t);
                        end = lanes_select(opens, high0, end);
                        more |= opens;
                    }
                    searching &= NOT(exhausted) | more;
                }
                if (step == 200) {
                    doubt = lanes_select(searching & (t < doubt), t, doubt);
                    searching &= NOT(searching);
                }
            }
            const M arrives = arrival < never;
            {
                V t = arrival;
                const M nearby = gone & (allowed.leaving_margin * t < allowed.margin);
                const V leaving = lanes_select(nearby, one, zero);
                LANES(hoop_ring_refine_out) r = LANES(hoop_ring_refine)(t, leaving, x, y, z, vx, vy, vz, p.rho_start, ball_radius, ring_radius, wire_radius, gravity);
                t = lanes_select(certain, r.time, t);
                r = LANES(hoop_ring_refine)(t, leaving, x, y, z, vx, vy, vz, p.rho_start, ball_radius, ring_radius, wire_radius, gravity);
                t = lanes_select(certain, r.time, t);
                const LANES(hoop_ring_margins_out) own = LANES(hoop_ring_margins)(p.latest, extent, speed, position_error, velocity_error, ball_radius, ring_radius, wire_radius, gravity);
                const V margin = lanes_select(nearby, own.leaving_margin * t, own.margin);
                const LANES(hoop_crossing_out) c = LANES(hoop_crossing)(margin, own.rate_margin, r.rate, p.ceiling);
                certain &= c.clearance > zero;
                arrival = lanes_select(t < zero, zero, t);
                delay = certified ? lanes_select(certain, c.delay, zero) : zero;
                doubt = lanes_select(arrives & NOT(certain) & (arrival < doubt), arrival, doubt);
            }
                        {
                const M tie = arrives & (lanes_abs(arrival - when) <= delay + late);
                const V sooner = lanes_select(arrival < when, arrival, when);
                doubt = lanes_select(tie & (sooner < doubt), sooner, doubt);
                const M earlier = arrives & (arrival < when);
                when = lanes_select(earlier, arrival, when);
                which = lanes_select(earlier, K(0.0), which);
                late = lanes_select(earlier, delay, late);
            }
        }

        /* Fly there, and meet what is there. */
        const M stays = which < zero;
        const M ends = which == K(3.0);
        const M touches = flying & NOT(stays) & NOT(ends);
        const V t = lanes_select(stays, zero, when);
        const LANES(hoop_flight_out) f = LANES(hoop_flight)(t, x, y, z, vx, vy, vz, gravity);
        const V wx_before = wx, wy_before = wy, wz_before = wz;
        x = lanes_select(stays, x, f.x);
        y = lanes_select(stays, y, f.y);
        z = lanes_select(stays, z, f.z);
        vx = f.vx;
        vy = f.vy;
        vz = lanes_select(stays, vz, f.vz);
        clock = clock + t;
        const V x_before = x, y_before = y, z_before = z, vx_before = vx, vy_before = vy, vz_before = vz;
        M doubtful = NOT(doubt > when + late) & (doubt < never);
        {
            const V slack = LANES(hoop_displacement)(late, t, extent, speed, position_error, velocity_error, ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, gravity, end_depth).margin;
            const V miss = LANES(hoop_target)(x, y, ring_radius).target;
            doubtful |= ends & (lanes_abs(miss) <= slack);
            uncertain = certified ? lanes_select(doubtful, one, uncertain) : zero;
            V outcome = lanes_select(stays, K((double)HOOP_SHORT), none);
            outcome = lanes_select(ends, lanes_select(miss <= zero, K((double)HOOP_MADE), K((double)HOOP_MISSED)), outcome);
            contacts = lanes_select(touches, contacts + one, contacts);
            outcome = lanes_select(touches & (contacts >= most_contacts), K((double)HOOP_CAPPED), outcome);
            lanes_store(pool.outcome, outcome);
        }
        if (lanes_any(touches) || wants_errors) {
            const LANES(hoop_end_normal_out) level = LANES(hoop_end_normal)();
            V nx = level.nx, ny = level.ny, nz = level.nz;
            {
                const M here = which == K(0.0);
                const LANES(hoop_ring_normal_out) n = LANES(hoop_ring_normal)(x, y, z, ball_radius, ring_radius, wire_radius);
                nx = lanes_select(here, n.nx, nx);
                ny = lanes_select(here, n.ny, ny);
                nz = lanes_select(here, n.nz, nz);
                count_ring = lanes_select(here, count_ring + one, count_ring);
            }
            {
                const M here = which == K(1.0);
                const LANES(hoop_backboard_normal_out) n = LANES(hoop_backboard_normal)();
                nx = lanes_select(here, n.nx, nx);
                ny = lanes_select(here, n.ny, ny);
                nz = lanes_select(here, n.nz, nz);
                count_backboard = lanes_select(here, count_backboard + one, count_backboard);
            }
            {
                const M here = which == K(2.0);
                const LANES(hoop_bridge_normal_out) n = LANES(hoop_bridge_normal)();
                nx = lanes_select(here, n.nx, nx);
                ny = lanes_select(here, n.ny, ny);
                nz = lanes_select(here, n.nz, nz);
                count_bridge = lanes_select(here, count_bridge + one, count_bridge);
            }

            /* What this segment adds to the errors, and what the contact makes of them. */
            {
                V curving = never;
                curving = lanes_select((which == K(0.0)) & (last == which), LANES(hoop_ring_curvature)(ball_radius, ring_radius, wire_radius).curvature, curving);
                curving = lanes_select((which == K(1.0)) & (last == which), LANES(hoop_backboard_curvature)().curvature, curving);
                curving = lanes_select((which == K(2.0)) & (last == which), LANES(hoop_bridge_curvature)().curvature, curving);
                const LANES(hoop_carry_flight_out) carried = LANES(hoop_carry_flight)(t, x, y, z, vx, vy, vz, nx, ny, nz, clock, contacts, late, dx, dy, dz, dvx, dvy, dvz, curving, gravity);
                const V shift = carried.shift;
                clock_error = lanes_select(stays, clock_error, clock_error + carried.delay);
                dx = lanes_select(stays, dx, carried.dx);
                dy = lanes_select(stays, dy, carried.dy);
                dz = lanes_select(stays, dz, carried.dz);
                dvx = lanes_select(stays, dvx, carried.dvx);
                dvy = lanes_select(stays, dvy, carried.dvy);
                dvz = lanes_select(stays, dvz, carried.dvz);
                dx = lanes_select(ends & (lanes_abs(dx) < shift), shift, dx);
                dy = lanes_select(ends & (lanes_abs(dy) < shift), shift, dy);
                dz = lanes_select(ends & (lanes_abs(dz) < shift), shift, dz);
                V dnx = zero, dny = zero, dnz = zero, turn = zero;
                {
                    const M here = which == K(0.0);
                    const LANES(hoop_ring_carry_normal_out) turned = LANES(hoop_ring_carry_normal)(x, y, dx, dy, dz, shift, ball_radius, ring_radius, wire_radius);
                    dnx = lanes_select(here, turned.dnx, dnx);
                    dny = lanes_select(here, turned.dny, dny);
                    dnz = lanes_select(here, turned.dnz, dnz);
                    turn = lanes_select(here, turned.turn, turn);
                }
                const LANES(hoop_carry_impact_out) after = LANES(hoop_carry_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, contacts, dvx, dvy, dvz, dwx, dwy, dwz, dnx, dny, dnz, turn, ball_radius, restitution);
                dvx = lanes_select(touches, after.dvx, dvx);
                dvy = lanes_select(touches, after.dvy, dvy);
                dvz = lanes_select(touches, after.dvz, dvz);
                dwx = lanes_select(touches, after.dwx, dwx);
                dwy = lanes_select(touches, after.dwy, dwy);
                dwz = lanes_select(touches, after.dwz, dwz);
            }
            {
                const M here = which == K(1.0);
                const LANES(hoop_backboard_place_out) at = LANES(hoop_backboard_place)(y, z, ball_radius, board_distance);
                x = lanes_select(here, at.x, x);
                y = lanes_select(here, at.y, y);
                z = lanes_select(here, at.z, z);
            }
            {
                const M here = which == K(2.0);
                const LANES(hoop_bridge_place_out) at = LANES(hoop_bridge_place)(x, y, ball_radius, wire_radius);
                x = lanes_select(here, at.x, x);
                y = lanes_select(here, at.y, y);
                z = lanes_select(here, at.z, z);
            }
            {
                const LANES(hoop_impact_out) after = LANES(hoop_impact)(vx, vy, vz, wx, wy, wz, nx, ny, nz, ball_radius, restitution);
                vx = lanes_select(touches, after.vx, vx);
                vy = lanes_select(touches, after.vy, vy);
                vz = lanes_select(touches, after.vz, vz);
                wx = lanes_select(touches, after.wx, wx);
                wy = lanes_select(touches, after.wy, wy);
                wz = lanes_select(touches, after.wz, wz);
            }
            first = lanes_select(touches & (first < zero), which, first);
            last = lanes_select(touches, which, last);
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
        lanes_store(pool.count_ring, count_ring);
        lanes_store(pool.count_backboard, count_backboard);
        lanes_store(pool.count_bridge, count_bridge);
        if (certified) {
            lanes_store(pool.dx, dx);
            lanes_store(pool.dy, dy);
            lanes_store(pool.dz, dz);
            lanes_store(pool.dvx, dvx);
            lanes_store(pool.dvy, dvy);
            lanes_store(pool.dvz, dvz);
            lanes_store(pool.dwx, dwx);
            lanes_store(pool.dwy, dwy);
            lanes_store(pool.dwz, dwz);
            lanes_store(pool.clock_error, clock_error);
            lanes_store(pool.uncertain, uncertain);
        }

        if (wants_errors) {
            const LANES(hoop_claimed_errors_out) now = LANES(hoop_claimed_errors)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
            lanes_store(pool.bounds[0], now.position_error);
            lanes_store(pool.bounds[1], now.velocity_error);
            lanes_store(pool.bounds[2], now.spin_error);
            lanes_store(pool.bounds[3], now.time_error);
        }
        if (job->results->events) {
            double surface[LANES_WIDTH];
            double before[HOOP_STATE][LANES_WIDTH];
            lanes_store(surface, which);
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
    if (out->uncertain || out->time_error || out->state_error)
        LANES(hoop_loop)(job, 1);
    else
        LANES(hoop_loop)(job, 0);
}

#undef V
#undef M
#undef K
#undef NOT
#undef lanes_select
#undef lanes_abs
#undef lanes_sqrt
#undef lanes_any
#undef lanes_load
#undef lanes_store
#undef lanes_gather
