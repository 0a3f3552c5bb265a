/* What the two time-stepping peers share: advance, look for penetration, locate the contact inside the step. They
 * differ in the length of the step alone. */
#ifndef BENCHMARKS_STEPPING_H
#define BENCHMARKS_STEPPING_H

#include "model.h"

static double step_length(const Scene *scene, const double *options, const State *s);

/* Time inside the step at which the ball reaches the surface, by bisection on its function, from the outside. */
static double locate(const Scene *scene, int surface, const State *start, double step)
{
    double outside = 0.0, inside = step;
    for (int halving = 0; halving < 32; ++halving) {
        double middle = 0.5 * (outside + inside);
        State s = fly(start, scene->gravity, middle);
        if (surface_function(scene, surface, &s) >= 0.0) outside = middle;
        else inside = middle;
    }
    return outside;
}

static inline int approaches(const Scene *scene, int surface, const State *s)
{
    double n[3];
    outward_normal(scene, surface, s, n);
    return s->vx * n[0] + s->vy * n[1] + s->vz * n[2] < 0.0;
}

/* Inside the ring's contact surface; the root is taken only near the ring. */
static inline int inside_ring(const Scene *scene, double x, double y, double z)
{
    double radius = contact_radius(scene);
    if (fabs(z) >= radius) return 0;
    double rho2 = x * x + y * y;
    double inner = scene->ring_radius - radius, outer = scene->ring_radius + radius;
    if (rho2 <= inner * inner || rho2 >= outer * outer) return 0;
    return ring_function(scene, x, y, z) < 0.0;
}

/* The first contact inside the step, NO_SURFACE if its penetrations are past the edges or leaving. */
static int respond(const Scene *scene, const State *before, const int penetrates[4], double step,
                   State *contact, double *after)
{
    int surface = NO_SURFACE;
    *after = INFINITY;
    for (int r = 0; r < 4; ++r) {
        if (!penetrates[r]) continue;
        double t = locate(scene, r, before, step);
        State s = fly(before, scene->gravity, t);
        if (r == RING && !approaches(scene, RING, &s)) {
            /* A bounce too short to see inside the step: respond at its end, where it comes back. */
            t = step;
            s = fly(before, scene->gravity, t);
            if (!approaches(scene, RING, &s)) continue;
        }
        if (t < *after && inside_bounds(scene, r, &s)) {
            *after = t;
            surface = r;
            *contact = s;
        }
    }
    return surface;
}

static int next_event(const Scene *scene, const double *options, State *state, double *time)
{
    const double top = contact_radius(scene), end = -scene->end_depth;
    const double front = scene->ball_radius - scene->board_distance;
    const double fall = 0.5 * scene->gravity;
    State now = *state;
    double elapsed = 0.0;
    for (;;) {
        const double step = step_length(scene, options, &now);
        const double x = now.x + now.vx * step, y = now.y + now.vy * step;
        const double z = now.z + (now.vz - fall * step) * step;
        const int penetrates[4] = {
            inside_ring(scene, x, y, z),
            x < front && now.x >= front,
            z < top && now.z >= top,
            z < end && now.z >= end,
        };
        if (penetrates[RING] | penetrates[BACKBOARD] | penetrates[BRIDGE] | penetrates[END]) {
            State contact;
            double after;
            int surface = respond(scene, &now, penetrates, step, &contact, &after);
            if (surface != NO_SURFACE) {
                *state = contact;
                *time += elapsed + after;
                return surface;
            }
        }
        now.x = x;
        now.y = y;
        now.z = z;
        now.vz -= scene->gravity * step;
        elapsed += step;
        if (z < end && out_of_reach(scene, &now)) return NO_SURFACE;
    }
}

#endif
