/* Noise and states of releases: included once for every width.

   Generated from templates/c/drawing.h.j2, the same for every scene, with
   Jinja2 3.1.6. Do not edit: change templates/ and run `make generate`. */

/* Uniform number in the open interval (0, 1), an odd multiple of 2^-53. 2 operations: 1 addition, 1 multiplication. */
static inline double WIDE(uniform_number)(double bits)
{
    return 1.1102230246251565e-16 + (2.220446049250313e-16 * bits);
}

/* First term of a sum of weighted normal numbers. 1 operation: 1 multiplication. */
static inline double WIDE(first_term)(double weight, double normal)
{
    return weight * normal;
}

/* Sum of weighted normal numbers with one more term. 2 operations: 1 addition, 1 multiplication. */
static inline double WIDE(next_term)(double total, double weight, double normal)
{
    return total + (weight * normal);
}

/* Noise of a variable. 1 operation: 1 multiplication. */
static inline double WIDE(deviation_of_sum)(double total, double deviation)
{
    return total * deviation;
}

/* Write the noise of `count` shots, from shot `start` on, of each variable: its deviation times its row of the
   factor of the correlations (`variables` entries, those after its own are not read) times normal numbers. */
APART static void WIDE(noise)(size_t variables, const uint64_t *streams, const double *weights, const double *deviations, uint64_t seed, uint64_t start, size_t count, double *const *noise)
{
    uint64_t words[TILE];
    double numbers[TILE];
    for (size_t first = 0; first < count; first += TILE) {
        const size_t shots = count - first < TILE ? count - first : TILE;
        for (size_t k = 0; k < variables; k++) {
            philox_words(seed, streams[k], start + first, shots, words);
            for (size_t i = 0; i < shots; i++)
                numbers[i] = WIDE(uniform_number)((double)(int64_t)(words[i] >> 12));
            WIDE(normal_quantile)(shots, numbers, noise[k] + first);
        }
        /* A row needs normal numbers of its own and of earlier variables alone: the last one's are free first. */
        for (size_t k = variables; k-- > 0;) {
            size_t terms = 0;
            for (size_t j = 0; j <= k; j++) {
                const double weight = weights[k * variables + j], *normals = noise[j] + first;
                if (weight == 0.0)
                    continue;
                if (terms++ == 0)
                    for (size_t i = 0; i < shots; i++)
                        numbers[i] = WIDE(first_term)(weight, normals[i]);
                else
                    for (size_t i = 0; i < shots; i++)
                        numbers[i] = WIDE(next_term)(numbers[i], weight, normals[i]);
            }
            for (size_t i = 0; i < shots; i++)
                noise[k][first + i] = WIDE(deviation_of_sum)(numbers[i], deviations[k]);
        }
    }
}

/* Write the states of `count` releases, one after the other. `strides` is 1 for an argument with a value for each
   shot, and 0 for one number. */
APART static void WIDE(release_states)(size_t count, const double *const *arguments, const int64_t *strides, double height_of_ring, double *states)
{
    double shared[8][TILE], ring_height[TILE], heading[TILE], component[9][TILE];
    double sin_heading[TILE], cos_heading[TILE], sin_elevation[TILE], cos_elevation[TILE], sin_angle[TILE], cos_angle[TILE];
    for (size_t i = 0; i < TILE && i < count; i++) {
        ring_height[i] = height_of_ring;
        for (size_t k = 0; k < 8; k++)
            if (!strides[k])
                shared[k][i] = *arguments[k];
    }
    for (size_t first = 0; first < count; first += TILE) {
        const size_t shots = count - first < TILE ? count - first : TILE;
        const double *const speed = strides[0] ? arguments[0] + first : shared[0];
        const double *const elevation = strides[1] ? arguments[1] + first : shared[1];
        const double *const azimuth = strides[2] ? arguments[2] + first : shared[2];
        const double *const backspin = strides[3] ? arguments[3] + first : shared[3];
        const double *const sidespin = strides[4] ? arguments[4] + first : shared[4];
        const double *const height = strides[5] ? arguments[5] + first : shared[5];
        const double *const distance = strides[6] ? arguments[6] + first : shared[6];
        const double *const angle = strides[7] ? arguments[7] + first : shared[7];
        const _Bool elevation_is_new = !first || strides[1];
        const _Bool azimuth_is_new = !first || strides[2];
        const _Bool angle_is_new = !first || strides[7];
        if (azimuth_is_new || angle_is_new) {
            WIDE(release_heading)(shots, azimuth, angle, heading);
            WIDE(sine_cosine)(shots, heading, sin_heading, cos_heading);
        }
        if (elevation_is_new)
            WIDE(sine_cosine)(shots, elevation, sin_elevation, cos_elevation);
        if (angle_is_new)
            WIDE(sine_cosine)(shots, angle, sin_angle, cos_angle);
        WIDE(release_state)(shots, speed, backspin, sidespin, height, distance, ring_height, sin_heading, cos_heading, sin_elevation, cos_elevation, sin_angle, cos_angle, component[0], component[1], component[2], component[3], component[4], component[5], component[6], component[7], component[8]);
        /* A zero is added, so that no zero is negative. */
        for (size_t i = 0; i < shots; i++)
            for (size_t k = 0; k < 9; k++)
                states[(first + i) * 9 + k] = component[k][i] + 0.0;
    }
}
