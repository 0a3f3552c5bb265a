/* The event loop of Table 1, which every C peer includes last. A peer is the function `next_event`: how it finds the
 * next contact is what the benchmark compares. */
#ifndef BENCHMARKS_LOOP_H
#define BENCHMARKS_LOOP_H

#include "model.h"

/* Moves `state` to its next event, adds the time that takes to `*time`, and returns the surface:
 * RING, BACKBOARD, BRIDGE, END, or NO_SURFACE when nothing lies ahead. `options` belongs to the peer. */
static int next_event(const Scene *scene, const double *options, State *state, double *time);

/* Table 1 for `count` shots of nine doubles. `surfaces` is (count, max_contacts), filled with -1 by the caller,
 * or NULL where the sequence is not wanted. */
void simulate(const double *states, int64_t count, const Scene *scene, const double *options,
              int max_contacts, uint8_t *outcome, int32_t *contacts, double *time, int8_t *surfaces)
{
    for (int64_t shot = 0; shot < count; ++shot) {
        const double *row = states + 9 * shot;
        State s = {row[0], row[1], row[2], row[3], row[4], row[5], row[6], row[7], row[8]};
        double elapsed = 0.0, last_contact = 0.0;
        int touched = 0, result = CAPPED;
        while (touched < max_contacts) {
            int surface = next_event(scene, options, &s, &elapsed);
            if (surface == END) {
                double limit = scene->ring_radius * scene->ring_radius;
                result = s.x * s.x + s.y * s.y <= limit ? MADE : MISSED;
                last_contact = elapsed;
                break;
            }
            if (surface == NO_SURFACE) {
                result = SHORT;
                break;
            }
            if (surfaces) surfaces[shot * max_contacts + touched] = (int8_t)surface;
            ++touched;
            last_contact = elapsed;
            rebound(scene, surface, &s);
        }
        outcome[shot] = (uint8_t)result;
        contacts[shot] = touched;
        time[shot] = last_contact;
    }
}

#endif
