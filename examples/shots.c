/* A few free throws in C. Compile and run it from the root of the checkout:

   cc -O2 -ffp-contract=off -Igenerated/c examples/shots.c generated/c/hoop.c -lm -o shots && ./shots

   Under flags that change the bits, hoop.c does not compile or hoop_simulate returns -2. */

#include "hoop.h"

#include <math.h>
#include <stdio.h>

/* x y z (m), vx vy vz (m/s), wx wy wz (rad/s): 13.75 ft from the ring's centre and 8 ft above the
   floor, with 3 Hz of backspin. The speed grows from row to row. */
static const double shots[][HOOP_STATE] = {
    {4.191, 0, -0.6096, -4.40, 0, 5.3128, 0, 18.85, 0},
    {4.191, 0, -0.6096, -4.45, 0, 5.35, 0, 18.85, 0},
    {4.191, 0, -0.6096, -4.50, 0, 5.58, 0, 18.85, 0},
    {4.191, 0, -0.6096, -4.60, 0.2, 5.60, 0, 18.85, 0},
};
enum { SHOTS = sizeof shots / sizeof *shots };

int main(void)
{
    /* hoopgen.PAPER, in the order of HOOP_P_*: m, restitution, m/s², m. */
    static const double hoop[HOOP_PARAMETERS] = {0.12128, 0.235, 0.01, 0.381, 0.9144, -0.14,
                                                 0.9268, 0.0762, 0.7, 9.81, 0.024256};
    static const char *const words[] = {"made", "missed", "capped", "short",
                                        "invalid", "lodged", "endless"};
    const double *parameters[HOOP_PARAMETERS];
    int64_t strides[HOOP_PARAMETERS] = {0}; /* one value for all shots */
    uint8_t outcome[SHOTS];
    int32_t contacts[SHOTS];
    double time[SHOTS];
    const hoop_results results = {.outcome = outcome, .contacts = contacts, .time = time};

    for (int k = 0; k < HOOP_PARAMETERS; k++)
        parameters[k] = &hoop[k];
    const int width = hoop_simulate(SHOTS, shots[0], parameters, strides, NULL, 40, INFINITY, 0, NULL,
                                    &results);
    if (width < 0) { /* a HOOP_ERROR_*, as hoop.h explains */
        fprintf(stderr, "hoop_simulate: %d\n", width);
        return 1;
    }
    for (int k = 0; k < SHOTS; k++)
        printf("%-8s %2d contacts %.17g s\n", words[outcome[k]], (int)contacts[k], time[k]);
    return 0;
}
