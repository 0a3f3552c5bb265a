/* The article's method (section 2.1): evaluate the functions of Table 2 at t = eps, eps + eps_max, ..., and bisect
 * after a change of sign until the bracket is below eps. All surfaces are marched together, so the march ends at the
 * first contact instead of running to the end plane four times; signs are taken a block of steps at a time, which the
 * compiler turns into vector code. The answer is that of the plain march. options = {eps_max, eps}. */
#include "model.h"

enum { BLOCK = 16 };

/* Which functions are positive, a bit a surface. The ring's sign is that of its polynomial,
 * (rho^2 + z^2 + R_H^2 - R^2)^2 - 4 R_H^2 rho^2: no root to take. */
static inline int64_t signs(const Scene *scene, const State *start, double t)
{
    double radius = contact_radius(scene), ring = scene->ring_radius;
    double x = start->x + start->vx * t;
    double y = start->y + start->vy * t;
    double z = start->z + (start->vz - 0.5 * scene->gravity * t) * t;
    double rho2 = x * x + y * y;
    double sum = rho2 + z * z + (ring * ring - radius * radius);
    int64_t positive = sum * sum - 4.0 * ring * ring * rho2 > 0.0 ? 1 << RING : 0;
    positive |= x + scene->board_distance - scene->ball_radius > 0.0 ? 1 << BACKBOARD : 0;
    positive |= z - radius > 0.0 ? 1 << BRIDGE : 0;
    positive |= z + scene->end_depth > 0.0 ? 1 << END : 0;
    return positive;
}

/* The outside end of the bracket, so that the next flight starts outside the surface. */
static double bisect(const Scene *scene, int surface, const State *start, double outside,
                     double inside, double eps)
{
    while (inside - outside >= eps) {
        double middle = 0.5 * (outside + inside);
        State s = fly(start, scene->gravity, middle);
        if (surface_function(scene, surface, &s) > 0.0) outside = middle;
        else inside = middle;
    }
    return outside;
}

static int next_event(const Scene *scene, const double *options, State *state, double *time)
{
    const State start = *state;
    const double step = options[0], eps = options[1];
    int64_t before = signs(scene, &start, eps);

    for (int32_t first = 1;; first += BLOCK) {
        int64_t change = 0;
        for (int32_t k = first; k < first + BLOCK; ++k)
            change |= signs(scene, &start, eps + (double)k * step) ^ before;
        for (int32_t k = first; change && k < first + BLOCK; ++k) {
            double inside = eps + (double)k * step, earliest = INFINITY;
            int64_t now = signs(scene, &start, inside), arrived = before & ~now;
            int surface = NO_SURFACE;
            before = now;
            for (int r = 0; arrived && r < 4; ++r) {
                if (!(arrived >> r & 1)) continue;
                double t = bisect(scene, r, &start, inside - step, inside, eps);
                State s = fly(&start, scene->gravity, t);
                if (t < earliest && inside_bounds(scene, r, &s)) {
                    earliest = t;
                    surface = r;
                }
            }
            if (surface != NO_SURFACE) {
                *state = fly(&start, scene->gravity, earliest);
                *time += earliest;
                return surface;
            }
        }
        State s = fly(&start, scene->gravity, eps + (double)(first + BLOCK) * step);
        if (out_of_reach(scene, &s)) return NO_SURFACE;
    }
}

#include "loop.h"
