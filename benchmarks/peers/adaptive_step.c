/* Time stepping whose step follows the distance to the nearest contact surface: far away it strides, near by it creeps.
 * The step is the time in which the ball cannot cover that distance, |v| t + g t^2 / 2, but not below a shortest one.
 * options = {shortest}. */
#include "stepping.h"

static inline double larger(double a, double b) { return a > b ? a : b; }
static inline double smaller(double a, double b) { return a < b ? a : b; }

static double step_length(const Scene *scene, const double *options, const State *s)
{
    double rho = sqrt(s->x * s->x + s->y * s->y);
    double across = rho - scene->ring_radius;
    double nearest = fabs(sqrt(across * across + s->z * s->z) - contact_radius(scene));
    nearest = smaller(nearest, fabs(s->z + scene->end_depth));
    if (s->vx < 0.0) {
        double gap = fabs(s->x + scene->board_distance - scene->ball_radius);
        gap = larger(gap, fabs(s->y) - scene->board_half_width);
        gap = larger(gap, larger(scene->board_bottom - s->z, s->z - scene->board_top));
        nearest = smaller(nearest, gap);
    }
    double gap = fabs(s->z - contact_radius(scene));
    gap = larger(gap, fabs(s->y) - scene->bridge_half_width);
    gap = larger(gap, larger(-across, larger(s->x, -scene->board_distance - s->x)));
    nearest = smaller(nearest, gap);

    double speed2 = s->vx * s->vx + s->vy * s->vy + s->vz * s->vz;
    double fastest = sqrt(speed2) + sqrt(speed2 + 2.0 * scene->gravity * nearest);
    double safe = 2.0 * nearest / fastest;
    return safe > options[0] ? safe : options[0];
}

#include "loop.h"
