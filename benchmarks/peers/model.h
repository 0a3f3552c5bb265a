/* The model every C peer flies: flight (Eq. 3), surfaces (Table 2), contact (Eqs. 11-17) in closed form. */
#ifndef BENCHMARKS_MODEL_H
#define BENCHMARKS_MODEL_H

#include <math.h>
#include <stdint.h>

typedef struct {
    double ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom,
        board_top, bridge_half_width, restitution, gravity, end_depth;
} Scene;

typedef struct {
    double x, y, z, vx, vy, vz, wx, wy, wz;
} State;

enum { RING, BACKBOARD, BRIDGE, END, NO_SURFACE };
enum { MADE, MISSED, CAPPED, SHORT };

static inline double contact_radius(const Scene *scene)
{
    return scene->ball_radius + scene->wire_radius;
}

/* Eq. 3. */
static inline State fly(const State *start, double gravity, double t)
{
    State s = *start;
    s.x += s.vx * t;
    s.y += s.vy * t;
    s.z += (s.vz - 0.5 * gravity * t) * t;
    s.vz -= gravity * t;
    return s;
}

/* The ring's f1 of Table 2; (x - x_C)^2 + (y - y_C)^2 is (rho - R_H)^2, finite on the axis too. */
static inline double ring_function(const Scene *scene, double x, double y, double z)
{
    double radius = contact_radius(scene);
    double across = sqrt(x * x + y * y) - scene->ring_radius;
    return across * across + z * z - radius * radius;
}

static inline double surface_function(const Scene *scene, int surface, const State *s)
{
    switch (surface) {
    case RING:
        return ring_function(scene, s->x, s->y, s->z);
    case BACKBOARD:
        return s->x + scene->board_distance - scene->ball_radius;
    case BRIDGE:
        return s->z - contact_radius(scene);
    default:
        return s->z + scene->end_depth;
    }
}

/* The inequality constraints of Table 2, and the sense of arrival that it leaves out. */
static inline int inside_bounds(const Scene *scene, int surface, const State *s)
{
    switch (surface) {
    case RING:
        return 1;
    case BACKBOARD:
        return s->vx < 0.0 && fabs(s->y) <= scene->board_half_width && s->z >= scene->board_bottom &&
               s->z <= scene->board_top;
    case BRIDGE:
        return s->vz < 0.0 && fabs(s->y) <= scene->bridge_half_width && s->x <= 0.0 &&
               s->x >= -scene->board_distance &&
               s->x * s->x + s->y * s->y >= scene->ring_radius * scene->ring_radius;
    default:
        return s->vz < 0.0;
    }
}

static inline void outward_normal(const Scene *scene, int surface, const State *s, double n[3])
{
    n[0] = surface == BACKBOARD ? 1.0 : 0.0;
    n[1] = 0.0;
    n[2] = surface == BACKBOARD ? 0.0 : 1.0;
    if (surface == RING) {
        double rho = sqrt(s->x * s->x + s->y * s->y);
        double across = rho - scene->ring_radius;
        double length = sqrt(across * across + s->z * s->z);
        n[0] = s->x * across / (rho * length);
        n[1] = s->y * across / (rho * length);
        n[2] = s->z / length;
    }
}

/* Eqs. 11-17 solved: the ball leaves rolling, with restitution. */
static inline void rebound(const Scene *scene, int surface, State *s)
{
    double n[3];
    outward_normal(scene, surface, s, n);
    double normal_speed = s->vx * n[0] + s->vy * n[1] + s->vz * n[2];
    double normal_spin = s->wx * n[0] + s->wy * n[1] + s->wz * n[2];
    double twice = 2.0 * scene->ball_radius;
    double tx = (3.0 * (s->vx - normal_speed * n[0]) + twice * (s->wy * n[2] - s->wz * n[1])) / 5.0;
    double ty = (3.0 * (s->vy - normal_speed * n[1]) + twice * (s->wz * n[0] - s->wx * n[2])) / 5.0;
    double tz = (3.0 * (s->vz - normal_speed * n[2]) + twice * (s->wx * n[1] - s->wy * n[0])) / 5.0;
    double away = -scene->restitution * normal_speed;
    s->vx = tx + away * n[0];
    s->vy = ty + away * n[1];
    s->vz = tz + away * n[2];
    s->wx = (n[1] * tz - n[2] * ty) / scene->ball_radius + normal_spin * n[0];
    s->wy = (n[2] * tx - n[0] * tz) / scene->ball_radius + normal_spin * n[1];
    s->wz = (n[0] * ty - n[1] * tx) / scene->ball_radius + normal_spin * n[2];
}

/* Below every surface and falling: the end plane cannot be crossed downwards any more. */
static inline int out_of_reach(const Scene *scene, const State *s)
{
    return s->vz <= 0.0 && s->z < -scene->end_depth && s->z < scene->board_bottom &&
           s->z < -contact_radius(scene);
}

#endif
