/* Kernels of the scene hoop, in C.

   Generated from templates/c/kernels.h.j2, scene hoop, derivation d045c64f80c6d78c,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Included once for every vector width, after these are defined:
     V, M          a vector of doubles and its comparison result (or double and int)
     K(c)          the constant c in every lane
     S, Q, KS(c)   the same in single precision
     LANES(name)   the name of a function for this width
     lanes_sqrt, lanes_abs, lanes_select */

/* Position and velocity at time t of a flight.
   Eq. 3. 10 operations: 3 additions, 2 subtractions, 5 multiplications. */
typedef struct {
    V x, y, z, vx, vy, vz;
} LANES(hoop_flight_out);

LANES_INLINE LANES(hoop_flight_out)
LANES(hoop_flight)(V t, V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1)
{
    return (LANES(hoop_flight_out)){ lanes_add(x, lanes_mul(vx, t)), lanes_add(y, lanes_mul(vy, t)), lanes_add(z, lanes_mul(t, lanes_sub(vz, lanes_mul(_c1, t)))), vx, vy, lanes_sub(vz, lanes_mul(_c0, t)) };
}

/* Clearance, positive if a crossing is certain, and a bound on its delay.
   Taylor's theorem with the margins of the gap and its rate. 10 operations: 1 addition, 1 subtraction, 3 multiplications, 1 division, 1 negation, 1 comparison, 2 selections. */
typedef struct {
    V clearance, delay;
} LANES(hoop_crossing_out);

LANES_INLINE LANES(hoop_crossing_out)
LANES(hoop_crossing)(V margin, V rate_margin, V rate, V ceiling)
{
    const V _s0 = lanes_neg(lanes_add(rate, rate_margin));
    const V _s1 = lanes_mul(K(6.0), margin);
    const M _s2 = lanes_less(K(0.0), _s0);
    return (LANES(hoop_crossing_out)){ lanes_select(_s2, lanes_sub(lanes_mul(_s0, _s0), lanes_mul(_s1, ceiling)), _s0), lanes_select(_s2, lanes_div(_s1, _s0), K(INFINITY)) };
}

/* Errors of the state that a search allows for, and by how much the errors exceed them.
   a share of the size of the flight. 10 operations: 2 additions, 2 subtractions, 4 multiplications, 1 comparison, 1 selection. */
typedef struct {
    V position_level, velocity_level, excess;
} LANES(hoop_allowance_out);

LANES_INLINE LANES(hoop_allowance_out)
LANES(hoop_allowance)(V share, V horizon, V extent, V speed, V position_error, V velocity_error, V _c0)
{
    const V _s0 = lanes_add(speed, lanes_mul(_c0, horizon));
    const V _s1 = lanes_mul(share, lanes_add(extent, lanes_mul(horizon, _s0)));
    const V _s2 = lanes_mul(share, _s0);
    const V _s3 = lanes_sub(position_error, _s1);
    const V _s4 = lanes_sub(velocity_error, _s2);
    return (LANES(hoop_allowance_out)){ _s1, _s2, lanes_max(_s3, _s4) };
}

/* Time after which no event is wanted, and how long that is after t.
   the earliest arrival, with room for its delay. 4 operations: 2 additions, 2 multiplications. */
typedef struct {
    V horizon, pad;
} LANES(hoop_horizon_out);

LANES_INLINE LANES(hoop_horizon_out)
LANES(hoop_horizon)(V t, V speed, V _c0)
{
    const V _s0 = lanes_mul(K(9.5367431640625e-07), lanes_add(t, lanes_mul(speed, _c0)));
    return (LANES(hoop_horizon_out)){ lanes_add(t, _s0), _s0 };
}

/* Sums of the sizes of position and velocity, and the excess of the flight's size.
   the measure of rounding errors. 17 operations: 4 additions, 1 subtraction, 2 multiplications, 6 absolute values, 2 comparisons, 2 selections. */
typedef struct {
    V extent, speed, excess;
} LANES(hoop_scale_out);

LANES_INLINE LANES(hoop_scale_out)
LANES(hoop_scale)(V x, V y, V z, V vx, V vy, V vz, V _c0)
{
    const V _s0 = lanes_add(lanes_add(lanes_abs(x), lanes_abs(y)), lanes_abs(z));
    const V _s1 = lanes_add(lanes_add(lanes_abs(vx), lanes_abs(vy)), lanes_abs(vz));
    const V _s2 = lanes_max(_s0, _s1);
    const V _s3 = lanes_mul(_c0, lanes_mul(_s1, _s1));
    return (LANES(hoop_scale_out)){ _s0, _s1, lanes_sub(lanes_max(_s2, _s3), K(1.152921504606847e+18)) };
}

/* Bound on the error of a length at a computed arrival.
   running error analysis. 15 operations: 7 additions, 8 multiplications. */
typedef struct {
    V margin;
} LANES(hoop_displacement_out);

LANES_INLINE LANES(hoop_displacement_out)
LANES(hoop_displacement)(V delay, V horizon, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1)
{
    const V _s0 = lanes_add(speed, lanes_mul(_c0, horizon));
    const V _s1 = lanes_add(extent, lanes_mul(horizon, _s0));
    return (LANES(hoop_displacement_out)){ lanes_add(lanes_add(lanes_mul(lanes_mul(K(1.0009765625), delay), _s0), lanes_mul(K(4.445228907190568e-16), lanes_add(_s1, _c1))), lanes_mul(K(3.0029296875), lanes_add(lanes_add(position_error, lanes_mul(horizon, velocity_error)), lanes_mul(K(4.440892098500626e-16), _s1)))) };
}

/* Velocity along the normal before the impact.
   Table 2. 5 operations: 2 additions, 3 multiplications. */
typedef struct {
    V normal_velocity;
} LANES(hoop_normal_velocity_out);

LANES_INLINE LANES(hoop_normal_velocity_out)
LANES(hoop_normal_velocity)(V vx, V vy, V vz, V nx, V ny, V nz)
{
    return (LANES(hoop_normal_velocity_out)){ lanes_add(lanes_add(lanes_mul(nx, vx), lanes_mul(ny, vy)), lanes_mul(nz, vz)) };
}

/* Bounds on the errors where a flight crosses the end plane.
   Eq. 3, with roundings. 62 operations: 25 additions, 1 subtraction, 22 multiplications, 1 division, 8 absolute values, 1 comparison, 4 selections. */
typedef struct {
    S position_bound, velocity_bound, spin_bound, delay;
} LANES(hoop_carry_end_out);

LANES_INLINE LANES(hoop_carry_end_out)
LANES(hoop_carry_end)(S t, S x, S y, S z, S vx, S vy, S vz, S clock, S position_bound, S velocity_bound, S spin_bound, S root_offset, S normal_velocity, S _c0, S _c1)
{
    const S _s0 = singles_abs(vx);
    const S _s1 = singles_mul(KS(2.0), t);
    const S _s2 = singles_abs(vy);
    const S _s3 = singles_add(singles_add(singles_mul(_c1, singles_mul(t, t)), singles_mul(_s1, singles_abs(singles_add(vz, singles_mul(_c1, t))))), singles_abs(z));
    const S _s4 = singles_add(singles_add(singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s1, _s0), singles_abs(x)))), singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s1, _s2), singles_abs(y))))), singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), _s3)));
    const S _s5 = singles_add(singles_add(singles_add(position_bound, root_offset), singles_mul(t, velocity_bound)), _s4);
    const S _s6 = singles_abs(normal_velocity);
    const S _s7 = singles_div(singles_mul(KS(1.1), _s5), _s6);
    const S _s8 = singles_abs(vz);
    const S _s9 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_add(singles_add(singles_mul(_c0, t), _s0), _s2), _s8)));
    const S _s10 = singles_add(singles_mul(_c0, _s7), singles_add(velocity_bound, _s9));
    const S _s11 = singles_mul(KS(1.0009765625), singles_add(singles_mul(_s7, singles_add(_s10, singles_add(singles_add(_s0, _s2), _s8))), _s5));
    const Q _s12 = singles_at_most(singles_sub(singles_mul(KS(12.0), _s10), _s6), KS(0.0));
    return (LANES(hoop_carry_end_out)){ singles_select(_s12, _s11, KS(INFINITY)), singles_select(_s12, singles_mul(KS(1.0009765625), _s10), KS(INFINITY)), singles_select(_s12, singles_mul(KS(1.0009765625), spin_bound), KS(INFINITY)), singles_add(singles_mul(KS(4.440892098500626e-16), singles_add(t, clock)), singles_select(_s12, singles_mul(KS(1.0009765625), _s7), KS(INFINITY))) };
}

/* Whether a bound on an error is not finite.
   comparison. 8 operations: 4 comparisons, 3 conjunctions, 1 complement. */
typedef struct {
    M unbounded;
} LANES(hoop_unbounded_out);

LANES_INLINE LANES(hoop_unbounded_out)
LANES(hoop_unbounded)(S clock_error, S position_bound, S velocity_bound, S spin_bound)
{
    return (LANES(hoop_unbounded_out)){ singles_truth(singles_not(singles_both(singles_both(singles_both(singles_less(position_bound, KS(INFINITY)), singles_less(velocity_bound, KS(INFINITY))), singles_less(spin_bound, KS(INFINITY))), singles_less(clock_error, KS(INFINITY))))) };
}

/* Bounds on the errors at the time limit.
   Eq. 3, with roundings. 50 operations: 24 additions, 19 multiplications, 7 absolute values. */
typedef struct {
    S position_bound, velocity_bound, spin_bound, clock_error;
} LANES(hoop_carry_time_out);

LANES_INLINE LANES(hoop_carry_time_out)
LANES(hoop_carry_time)(S t, S x, S y, S z, S vx, S vy, S vz, S clock, S clock_error, S position_bound, S velocity_bound, S spin_bound, S _c0, S _c1)
{
    const S _s0 = singles_add(clock_error, singles_mul(KS(4.440892098500626e-16), singles_add(t, clock)));
    const S _s1 = singles_abs(vx);
    const S _s2 = singles_abs(vy);
    const S _s3 = singles_abs(vz);
    const S _s4 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_add(singles_add(singles_mul(_c0, t), _s1), _s2), _s3)));
    const S _s5 = singles_add(singles_add(velocity_bound, singles_mul(_c0, _s0)), _s4);
    const S _s6 = singles_mul(KS(2.0), t);
    const S _s7 = singles_add(singles_add(singles_mul(_c1, singles_mul(t, t)), singles_mul(_s6, singles_abs(singles_add(vz, singles_mul(_c1, t))))), singles_abs(z));
    const S _s8 = singles_add(singles_add(singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s6, _s1), singles_abs(x)))), singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s6, _s2), singles_abs(y))))), singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), _s7)));
    const S _s9 = singles_add(singles_add(singles_add(position_bound, singles_mul(t, velocity_bound)), singles_mul(_s0, singles_add(_s5, singles_add(singles_add(_s1, _s2), _s3)))), _s8);
    return (LANES(hoop_carry_time_out)){ singles_mul(KS(1.0009765625), _s9), singles_mul(KS(1.0009765625), _s5), singles_mul(KS(1.0009765625), spin_bound), KS(0.0) };
}

/* Bounds on the errors of state and time that decisions use.
   the carried bounds. No operations. */
typedef struct {
    S position_error, velocity_error, spin_error, time_error;
} LANES(hoop_error_bounds_out);

LANES_INLINE LANES(hoop_error_bounds_out)
LANES(hoop_error_bounds)(S clock_error, S position_bound, S velocity_bound, S spin_bound)
{
    return (LANES(hoop_error_bounds_out)){ position_bound, velocity_bound, spin_bound, clock_error };
}

/* Bounds on the errors of state and time that are reported.
   the carried bounds. No operations. */
typedef struct {
    S position_error, velocity_error, spin_error, time_error;
} LANES(hoop_claimed_errors_out);

LANES_INLINE LANES(hoop_claimed_errors_out)
LANES(hoop_claimed_errors)(S clock_error, S position_bound, S velocity_bound, S spin_bound)
{
    return (LANES(hoop_claimed_errors_out)){ position_bound, velocity_bound, spin_bound, clock_error };
}

/* 1 if finite parameters are allowed.
   the scene's requirements. 24 operations: 2 subtractions, 11 comparisons, 11 selections. */
typedef struct {
    V allowed;
} LANES(hoop_allowed_out);

LANES_INLINE LANES(hoop_allowed_out)
LANES(hoop_allowed)(const LANES(column) *p, size_t row)
{
    V _v0 = lanes_select(lanes_less(K(0.0), lanes_sub(lanes_sub(lanes_load(p[1] + row), lanes_load(p[0] + row)), lanes_load(p[2] + row))), K(1.0), K(0.0));
    static const int _t0[][1] = {
        {0},
        {1},
        {2},
        {3},
        {4},
        {7},
    };
    for (size_t _k0 = 0; _k0 < 6; _k0++) {
        _v0 = lanes_select(lanes_less(K(0.0), lanes_load(p[_t0[_k0][0]] + row)), _v0, K(0.0));
    }
    const V _s3 = lanes_select(lanes_at_most(K(0.0), lanes_load(p[8] + row)), _v0, K(0.0));
    return (LANES(hoop_allowed_out)){ lanes_select(lanes_less(K(0.0), lanes_load(p[10] + row)), lanes_select(lanes_less(K(0.0), lanes_load(p[9] + row)), lanes_select(lanes_at_most(lanes_load(p[8] + row), K(1.0)), _s3, K(0.0)), K(0.0)), K(0.0)) };
}

/* Whether the parameters are allowed, and no arithmetic with them over- or underflows.
   the range of numbers. 38 operations: 11 absolute values, 14 comparisons, 13 conjunctions. */
typedef struct {
    M permitted;
} LANES(hoop_parameters_in_range_out);

LANES_INLINE LANES(hoop_parameters_in_range_out)
LANES(hoop_parameters_in_range)(const LANES(column) *p, size_t row, V allowed)
{
    const V _s0 = lanes_abs(lanes_load(p[0] + row));
    M _v1 = lanes_both(lanes_both(lanes_less(K(0.0), allowed), lanes_at_most(_s0, K(1073741824.0))), lanes_at_most(K(9.313225746154785e-10), _s0));
    static const int _t1[][1] = {
        {1},
        {2},
        {3},
        {4},
        {5},
        {6},
        {7},
    };
    for (size_t _k1 = 0; _k1 < 7; _k1++) {
        _v1 = lanes_both(_v1, lanes_at_most(lanes_abs(lanes_load(p[_t1[_k1][0]] + row)), K(1073741824.0)));
    }
    const V _s4 = lanes_abs(lanes_load(p[9] + row));
    const M _s5 = lanes_both(lanes_both(lanes_both(lanes_both(_v1, lanes_at_most(lanes_abs(lanes_load(p[8] + row)), K(1.2676506002282294e+30))), lanes_at_most(_s4, K(1073741824.0))), lanes_at_most(K(9.313225746154785e-10), _s4)), lanes_at_most(lanes_abs(lanes_load(p[10] + row)), K(1073741824.0)));
    return (LANES(hoop_parameters_in_range_out)){ _s5 };
}

/* 1 if the ball overlaps no surface; 1 if that is undecided.
   Table 2. 101 operations: 8 additions, 15 subtractions, 6 multiplications, 2 square roots, 3 negations, 12 absolute values, 26 comparisons, 29 selections. */
typedef struct {
    V valid, undecided_time;
} LANES(hoop_valid_out);

LANES_INLINE LANES(hoop_valid_out)
LANES(hoop_valid)(V last, V x, V y, V z, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7, V _c8, V _c9, V _c10, V _c11, V _c12, V _c13, V _c14)
{
    const V _s0 = lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y)));
    const V _s1 = lanes_sub(_s0, _c1);
    const V _s2 = lanes_add(lanes_mul(z, z), lanes_mul(_s1, _s1));
    const V _s3 = lanes_sub(_s2, _c9);
    const M _s4 = lanes_less(lanes_abs(last), K(0.5));
    const V _s5 = lanes_select(_s4, K(1.0), lanes_select(lanes_at_most(K(0.0), _s3), K(1.0), K(0.0)));
    const V _s6 = lanes_sub(x, _c10);
    const V _s7 = lanes_sub(_c11, x);
    const V _s8 = lanes_max(_s6, _s7);
    const V _s9 = lanes_neg(lanes_add(_c4, y));
    const V _s10 = lanes_max(_s8, _s9);
    const V _s11 = lanes_sub(y, _c4);
    const V _s12 = lanes_max(_s10, _s11);
    const V _s13 = lanes_sub(_c5, z);
    const V _s14 = lanes_max(_s12, _s13);
    const V _s15 = lanes_sub(z, _c6);
    const V _s16 = lanes_max(_s14, _s15);
    const M _s17 = lanes_less(lanes_abs(lanes_sub(last, K(1.0))), K(0.5));
    const V _s18 = lanes_select(_s17, _s5, lanes_select(lanes_at_most(K(0.0), _s16), _s5, K(0.0)));
    const V _s19 = lanes_sub(z, _c8);
    const V _s20 = lanes_sub(_c12, z);
    const V _s21 = lanes_max(_s19, _s20);
    const V _s22 = lanes_neg(lanes_add(_c7, y));
    const V _s23 = lanes_max(_s21, _s22);
    const V _s24 = lanes_sub(y, _c7);
    const V _s25 = lanes_max(_s23, _s24);
    const V _s26 = lanes_sub(_c1, _s0);
    const V _s27 = lanes_max(_s25, _s26);
    const V _s28 = lanes_max(_s27, x);
    const V _s29 = lanes_neg(lanes_add(_c3, x));
    const V _s30 = lanes_max(_s28, _s29);
    const M _s31 = lanes_less(lanes_abs(lanes_sub(last, K(2.0))), K(0.5));
    const V _s32 = lanes_mul(K(1.7763568394002505e-15), lanes_add(lanes_add(lanes_add(_c13, lanes_abs(x)), lanes_abs(y)), lanes_abs(z)));
    const V _s33 = lanes_mul(_c14, _s32);
    const V _s34 = lanes_select(lanes_at_most(lanes_abs(lanes_sub(lanes_sub(lanes_sqrt(_s2), _c0), _c2)), _s32), lanes_select(lanes_at_most(_s3, _s33), K(0.0), K(1.0)), K(1.0));
    const V _s35 = lanes_select(_s4, _s34, lanes_select(lanes_at_most(lanes_abs(_s3), _s33), K(1.0), K(0.0)));
    const V _s36 = lanes_select(_s17, lanes_select(lanes_at_most(lanes_abs(_s6), _s32), lanes_select(lanes_at_most(_s16, _s32), _s35, K(1.0)), K(1.0)), lanes_select(lanes_at_most(lanes_abs(_s16), _s32), K(1.0), _s35));
    return (LANES(hoop_valid_out)){ lanes_select(_s31, _s18, lanes_select(lanes_at_most(K(0.0), _s30), _s18, K(0.0))), lanes_select(_s31, lanes_select(lanes_at_most(lanes_abs(_s19), _s32), lanes_select(lanes_at_most(_s30, _s32), _s36, K(1.0)), K(1.0)), lanes_select(lanes_at_most(lanes_abs(_s30), _s32), K(1.0), _s36)) };
}

/* Whether the ball starts near a surface; otherwise its start is valid and decided.
   Table 2. 23 operations: 4 additions, 3 subtractions, 2 multiplications, 1 negation, 3 absolute values, 5 comparisons, 2 conjunctions, 2 disjunctions, 1 complement. */
typedef struct {
    M close;
    V valid, undecided_time;
} LANES(hoop_aside_out);

LANES_INLINE LANES(hoop_aside_out)
LANES(hoop_aside)(V x, V y, V z, V _c0, V _c1, V _c2, V _c3, V _c4)
{
    const V _s0 = lanes_abs(x);
    const V _s1 = lanes_mul(K(8.0), lanes_mul(K(1.7763568394002505e-15), lanes_add(lanes_add(lanes_add(_c1, _s0), lanes_abs(y)), lanes_abs(z))));
    const M _s2 = lanes_not(lanes_both(lanes_both(lanes_less(_s1, lanes_sub(_s0, _c2)), lanes_either(lanes_less(_s1, lanes_sub(x, _c3)), lanes_less(_s1, lanes_sub(_c4, x)))), lanes_either(lanes_less(_s1, x), lanes_less(_s1, lanes_neg(lanes_add(_c0, x))))));
    return (LANES(hoop_aside_out)){ _s2, K(1.0), K(0.0) };
}

/* 1 if the flight starts on this surface.
   Table 1. 2 operations: 1 comparison, 1 selection. */
typedef struct {
    V leaving;
} LANES(hoop_left_out);

LANES_INLINE LANES(hoop_left_out)
LANES(hoop_left)(V index, V last)
{
    return (LANES(hoop_left_out)){ lanes_select(lanes_equal(last, index), K(1.0), K(0.0)) };
}

/* Whether the ball has touched nothing yet.
   Table 1. 2 operations: 1 comparison, 1 complement. */
typedef struct {
    M released, reachable;
} LANES(hoop_released_out);

LANES_INLINE LANES(hoop_released_out)
LANES(hoop_released)(V last)
{
    const M _s0 = lanes_less(last, K(0.0));
    return (LANES(hoop_released_out)){ _s0, lanes_not(_s0) };
}

/* Whether a plane's only root is an arrival, the size of F'', and the nearest time.
   Table 1. 13 operations: 1 absolute value, 6 comparisons, 4 conjunctions, 1 disjunction, 1 selection. */
typedef struct {
    M arrives;
    V ceiling, nearest;
} LANES(hoop_plane_root_out);

LANES_INLINE LANES(hoop_plane_root_out)
LANES(hoop_plane_root)(V rate, V bend, V apex, V time)
{
    const M _s0 = lanes_both(lanes_both(lanes_either(lanes_less(rate, K(0.0)), lanes_both(lanes_both(lanes_at_most(rate, K(0.0)), lanes_less(bend, K(0.0))), lanes_equal(time, K(0.0)))), lanes_at_most(K(0.0), time)), lanes_less(time, K(INFINITY)));
    return (LANES(hoop_plane_root_out)){ _s0, lanes_abs(bend), lanes_select(_s0, time, apex) };
}

/* Whether a plane's only root is an arrival, the size of F'', and the nearest time.
   Table 1. 17 operations: 1 absolute value, 8 comparisons, 4 conjunctions, 1 disjunction, 3 selections. */
typedef struct {
    M arrives;
    V ceiling, nearest;
} LANES(hoop_level_root_out);

LANES_INLINE LANES(hoop_level_root_out)
LANES(hoop_level_root)(V rate, V bend, V height, V time, V when)
{
    const M _s0 = lanes_both(lanes_both(lanes_either(lanes_less(rate, K(0.0)), lanes_both(lanes_both(lanes_at_most(rate, K(0.0)), lanes_less(bend, K(0.0))), lanes_equal(time, K(0.0)))), lanes_at_most(K(0.0), time)), lanes_less(time, K(INFINITY)));
    const V _s1 = lanes_select(_s0, time, lanes_select(lanes_less(height, K(0.0)), K(0.0), K(INFINITY)));
    return (LANES(hoop_level_root_out)){ _s0, lanes_abs(bend), lanes_min(when, _s1) };
}

/* Whether an arrival may be the earliest within the delays.
   Table 1. 5 operations: 1 addition, 1 subtraction, 1 comparison, 1 conjunction, 1 complement. */
typedef struct {
    M possible;
} LANES(hoop_within_time_out);

LANES_INLINE LANES(hoop_within_time_out)
LANES(hoop_within_time)(V time, V when, V delay, V earliest_delay, M arrives)
{
    return (LANES(hoop_within_time_out)){ lanes_both(arrives, lanes_not(lanes_less(lanes_add(delay, earliest_delay), lanes_sub(time, when)))) };
}

/* Undecided time 0 if the largest gap from the start on is zero within its error.
   Table 1. 5 operations: 1 absolute value, 2 comparisons, 1 conjunction, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(hoop_apex_undecided_out);

LANES_INLINE LANES(hoop_apex_undecided_out)
LANES(hoop_apex_undecided)(V margin, V apex, V height, V undecided_time)
{
    return (LANES(hoop_apex_undecided_out)){ lanes_select(lanes_both(lanes_at_most(K(0.0), apex), lanes_at_most(lanes_abs(height), margin)), K(0.0), undecided_time) };
}

/* Undecided time 0 if the gap of a plane is zero within its error, and falls.
   Table 1. 7 operations: 2 multiplications, 1 absolute value, 2 comparisons, 1 conjunction, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(hoop_side_undecided_out);

LANES_INLINE LANES(hoop_side_undecided_out)
LANES(hoop_side_undecided)(V rate, V margin, V height, V undecided_time, V velocity_error)
{
    return (LANES(hoop_side_undecided_out)){ lanes_select(lanes_both(lanes_less(rate, lanes_mul(K(2.0), velocity_error)), lanes_at_most(lanes_abs(height), lanes_mul(K(2.0), margin))), K(0.0), undecided_time) };
}

/* Earliest undecided time, with that of an undecided predicate.
   Table 1. 3 operations: 1 comparison, 1 conjunction, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(hoop_predicate_undecided_out);

LANES_INLINE LANES(hoop_predicate_undecided_out)
LANES(hoop_predicate_undecided)(V time, V undecided_time, M undecided)
{
    return (LANES(hoop_predicate_undecided_out)){ lanes_select(lanes_both(undecided, lanes_less(time, undecided_time)), time, undecided_time) };
}

/* Earliest undecided time, with that from which on a contact near an edge may be.
   Table 1. 4 operations: 1 multiplication, 1 comparison, 1 conjunction, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(hoop_bounds_undecided_out);

LANES_INLINE LANES(hoop_bounds_undecided_out)
LANES(hoop_bounds_undecided)(V time, V undecided_time, M undecided)
{
    const V _s0 = lanes_mul(K(0.5), time);
    return (LANES(hoop_bounds_undecided_out)){ lanes_select(lanes_both(undecided, lanes_less(_s0, undecided_time)), _s0, undecided_time) };
}

/* Earliest undecided time, with that of an arrival whose crossing is not certain.
   Table 1. 6 operations: 2 comparisons, 2 conjunctions, 1 complement, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(hoop_crossing_undecided_out);

LANES_INLINE LANES(hoop_crossing_undecided_out)
LANES(hoop_crossing_undecided)(V clearance, V time, V undecided_time, M arrives)
{
    return (LANES(hoop_crossing_undecided_out)){ lanes_select(lanes_both(lanes_both(arrives, lanes_not(lanes_less(K(0.0), clearance))), lanes_less(time, undecided_time)), time, undecided_time) };
}

/* Earliest undecided time, with that of a tie; the delay of the earlier arrival.
   Table 1. 16 operations: 1 addition, 2 subtractions, 1 multiplication, 1 absolute value, 4 comparisons, 3 conjunctions, 4 selections. */
typedef struct {
    V undecided_time, earliest_delay;
} LANES(hoop_tie_undecided_out);

LANES_INLINE LANES(hoop_tie_undecided_out)
LANES(hoop_tie_undecided)(V time, V when, V delay, V earliest_delay, V undecided_time, M arrives)
{
    const V _s0 = lanes_add(delay, earliest_delay);
    const M _s1 = lanes_less(time, when);
    const V _s2 = lanes_select(_s1, time, when);
    const V _s3 = lanes_mul(K(0.5), _s2);
    const V _s4 = lanes_sub(_s2, lanes_min(_s3, _s0));
    const V _s5 = lanes_select(lanes_both(lanes_both(arrives, lanes_at_most(lanes_abs(lanes_sub(time, when)), _s0)), lanes_less(_s4, undecided_time)), _s4, undecided_time);
    return (LANES(hoop_tie_undecided_out)){ _s5, lanes_select(lanes_both(arrives, _s1), delay, earliest_delay) };
}

/* Time and surface of the earliest arrival, with this one.
   Table 1. 4 operations: 1 comparison, 1 conjunction, 2 selections. */
typedef struct {
    V when, which;
} LANES(hoop_earliest_out);

LANES_INLINE LANES(hoop_earliest_out)
LANES(hoop_earliest)(V index, V time, V when, V which, M arrives)
{
    const M _s0 = lanes_both(arrives, lanes_less(time, when));
    return (LANES(hoop_earliest_out)){ lanes_select(_s0, time, when), lanes_select(_s0, index, which) };
}

/* Start value: the surface is certainly missed.
   Table 1. No operations. */
typedef struct {
    V clear;
} LANES(hoop_missed_out);

LANES_INLINE LANES(hoop_missed_out)
LANES(hoop_missed)(void)
{
    return (LANES(hoop_missed_out)){ K(1.0) };
}

/* Whether the flight may hit a surface.
   Table 1. 2 operations: 1 comparison, 1 complement. */
typedef struct {
    M open;
} LANES(hoop_opens_out);

LANES_INLINE LANES(hoop_opens_out)
LANES(hoop_opens)(V clear)
{
    return (LANES(hoop_opens_out)){ lanes_not(lanes_less(K(0.0), clear)) };
}

/* Start values of a search: its error budget, and no arrival.
   Table 1. No operations. */
typedef struct {
    V share, arrival;
    M certain;
} LANES(hoop_beginning_out);

LANES_INLINE LANES(hoop_beginning_out)
LANES(hoop_beginning)(void)
{
    return (LANES(hoop_beginning_out)){ K(2.9802322387695312e-08), K(INFINITY), mask_none() };
}

/* Undecided time 0 if errors exceed the budget of a search, or its bounds fail.
   Table 1. 7 operations: 1 multiplication, 3 comparisons, 2 disjunctions, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(hoop_out_of_budget_out);

LANES_INLINE LANES(hoop_out_of_budget_out)
LANES(hoop_out_of_budget)(V pad, V budget_exceeded, V earliest_delay, V undecided_time, V excess)
{
    return (LANES(hoop_out_of_budget_out)){ lanes_select(lanes_either(lanes_either(lanes_less(K(0.0), excess), lanes_less(pad, lanes_mul(K(0.5), earliest_delay))), lanes_less(K(0.0), budget_exceeded)), K(0.0), undecided_time) };
}

/* Undecided time 0 if the earliest arrival may be after the horizon.
   Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(hoop_overdue_out);

LANES_INLINE LANES(hoop_overdue_out)
LANES(hoop_overdue)(V pad, V earliest_delay, V undecided_time)
{
    return (LANES(hoop_overdue_out)){ lanes_select(lanes_less(pad, lanes_mul(K(0.5), earliest_delay)), K(0.0), undecided_time) };
}

/* 1 near the surface that the ball left, where F/t is more exact than F; the margin.
   Table 1. 6 operations: 1 multiplication, 2 comparisons, 1 conjunction, 2 selections. */
typedef struct {
    V leaving, margin;
} LANES(hoop_nearby_out);

LANES_INLINE LANES(hoop_nearby_out)
LANES(hoop_nearby)(V t, V flat, V tilt, V index, V last)
{
    const V _s0 = lanes_mul(t, tilt);
    const M _s1 = lanes_both(lanes_equal(last, index), lanes_less(_s0, flat));
    return (LANES(hoop_nearby_out)){ lanes_select(_s1, K(1.0), K(0.0)), lanes_select(_s1, _s0, flat) };
}

/* Begin of the first window and end of the last one, from single precision.
   Table 1. No operations. */
typedef struct {
    V time, latest;
} LANES(hoop_opened_out);

LANES_INLINE LANES(hoop_opened_out)
LANES(hoop_opened)(V horizon, V time)
{
    return (LANES(hoop_opened_out)){ time, horizon };
}

/* Whether a search begins in single precision; its ceiling, margins and error budget.
   Table 1. 6 operations: 3 conjunctions, 1 disjunction, 1 complement, 1 selection. */
typedef struct {
    M stepping, searching, single_precision;
    V ceiling, flat, tilt, allowing;
} LANES(hoop_coarse_out);

LANES_INLINE LANES(hoop_coarse_out)
LANES(hoop_coarse)(V rate_margin, V flat, V ceiling, V share, M searching, M representable, M fits)
{
    const M _s0 = lanes_both(lanes_both(searching, representable), fits);
    return (LANES(hoop_coarse_out)){ _s0, lanes_either(searching, lanes_not(representable)), _s0, ceiling, flat, rate_margin, lanes_select(lanes_both(representable, fits), share, K(2.9802322387695312e-08)) };
}

/* Root from the search in single precision; whether and where the search goes on.
   Table 1. 7 operations: 1 addition, 1 comparison, 2 conjunctions, 1 complement, 2 selections. */
typedef struct {
    V arrival, t;
    M searching;
} LANES(hoop_stepped_out);

LANES_INLINE LANES(hoop_stepped_out)
LANES(hoop_stepped)(V arrival, V lasting, M searching, V since, M single_precision, M certain)
{
    const V _s0 = lanes_add(lasting, since);
    return (LANES(hoop_stepped_out)){ lanes_select(certain, _s0, arrival), lanes_select(single_precision, _s0, K(0.0)), lanes_both(lanes_both(searching, lanes_not(certain)), lanes_less(lasting, K(INFINITY))) };
}

/* Whether the gap closes, certainly closes, or needs a smaller error budget.
   Table 1. 17 operations: 1 subtraction, 6 comparisons, 6 conjunctions, 2 disjunctions, 2 complements. */
typedef struct {
    M hit, sure, needs_refinement;
} LANES(hoop_gap_closes_out);

LANES_INLINE LANES(hoop_gap_closes_out)
LANES(hoop_gap_closes)(V gap, V rate, V bend, V margin, V rate_margin, V clearance, V share)
{
    const M _s0 = lanes_either(lanes_less(rate, K(0.0)), lanes_both(lanes_at_most(rate, rate_margin), lanes_less(bend, K(0.0))));
    const M _s1 = lanes_less(K(0.0), clearance);
    const M _s2 = lanes_both(_s0, lanes_either(lanes_at_most(lanes_sub(gap, margin), margin), _s1));
    const M _s3 = lanes_both(_s0, _s1);
    const M _s4 = lanes_both(lanes_both(_s2, lanes_not(_s3)), lanes_less(K(0.0), share));
    return (LANES(hoop_gap_closes_out)){ lanes_both(_s2, lanes_not(_s4)), _s3, _s4 };
}

/* Next smaller error budget.
   Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection. */
typedef struct {
    V share;
} LANES(hoop_smaller_budget_out);

LANES_INLINE LANES(hoop_smaller_budget_out)
LANES(hoop_smaller_budget)(V share)
{
    return (LANES(hoop_smaller_budget_out)){ lanes_select(lanes_less(K(2.842170943040401e-14), share), lanes_mul(K(0.03125), share), K(0.0)) };
}

/* Earliest undecided time, with the present one if the errors exceed the budget.
   Table 1. 4 operations: 2 comparisons, 1 conjunction, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(hoop_budget_undecided_out);

LANES_INLINE LANES(hoop_budget_undecided_out)
LANES(hoop_budget_undecided)(V t, V undecided_time, V excess)
{
    return (LANES(hoop_budget_undecided_out)){ lanes_select(lanes_both(lanes_less(K(0.0), excess), lanes_less(t, undecided_time)), t, undecided_time) };
}

/* Root, time and state of a search after a step, and whether its window is exhausted.
   Table 1. 14 operations: 1 subtraction, 1 comparison, 4 conjunctions, 2 disjunctions, 3 complements, 3 selections. */
typedef struct {
    V arrival;
    M certain, exhausted, searching;
    V t;
} LANES(hoop_advanced_out);

LANES_INLINE LANES(hoop_advanced_out)
LANES(hoop_advanced)(V t, V end, V step, V next, V arrival, M hit, M sure, M needs_refinement, M certain)
{
    const M _s0 = lanes_not(hit);
    const M _s1 = lanes_both(lanes_both(_s0, lanes_not(needs_refinement)), lanes_at_most(lanes_sub(end, t), step));
    return (LANES(hoop_advanced_out)){ lanes_select(hit, lanes_select(sure, next, t), arrival), lanes_either(certain, lanes_both(hit, sure)), _s1, lanes_both(_s0, lanes_not(_s1)), lanes_select(lanes_either(hit, needs_refinement), t, next) };
}

/* Whether a search found an arrival.
   Table 1. 1 operation: 1 comparison. */
typedef struct {
    M arrives, refining;
    V rate;
} LANES(hoop_found_out);

LANES_INLINE LANES(hoop_found_out)
LANES(hoop_found)(V arrival)
{
    const M _s0 = lanes_less(arrival, K(INFINITY));
    return (LANES(hoop_found_out)){ _s0, _s0, K(0.0) };
}

/* A certain root, refined, and whether h is above 2^-24, so that it is refined again.
   Table 1. 7 operations: 3 multiplications, 1 absolute value, 1 comparison, 1 conjunction, 1 selection. */
typedef struct {
    V arrival;
    M refining;
} LANES(hoop_refined_root_out);

LANES_INLINE LANES(hoop_refined_root_out)
LANES(hoop_refined_root)(V gap, V rate, V ceiling, V arrival, V refined, M certain)
{
    return (LANES(hoop_refined_root_out)){ lanes_select(certain, refined, arrival), lanes_both(certain, lanes_less(lanes_mul(K(5.960464477539063e-08), lanes_mul(rate, rate)), lanes_mul(ceiling, lanes_abs(gap)))) };
}

/* Margin of the form, F or F/t, in which an arrival was found.
   Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection. */
typedef struct {
    V margin;
} LANES(hoop_own_margin_out);

LANES_INLINE LANES(hoop_own_margin_out)
LANES(hoop_own_margin)(V leaving, V flat, V tilt, V arrival)
{
    return (LANES(hoop_own_margin_out)){ lanes_select(lanes_less(K(0.0), leaving), lanes_mul(tilt, arrival), flat) };
}

/* Time of an arrival, not before the flight.
   Table 1. 2 operations: 1 comparison, 1 selection. */
typedef struct {
    V time;
} LANES(hoop_arrival_time_out);

LANES_INLINE LANES(hoop_arrival_time_out)
LANES(hoop_arrival_time)(V arrival)
{
    return (LANES(hoop_arrival_time_out)){ lanes_select(lanes_less(arrival, K(0.0)), K(0.0), arrival) };
}

/* Delay of a certain arrival; the earliest undecided time, with that of any other one.
   Table 1. 10 operations: 1 subtraction, 2 comparisons, 3 conjunctions, 1 complement, 3 selections. */
typedef struct {
    V delay, undecided_time;
} LANES(hoop_arrival_certainty_out);

LANES_INLINE LANES(hoop_arrival_certainty_out)
LANES(hoop_arrival_certainty)(V clearance, V time, V delay, V undecided_time, M arrives, M certain)
{
    const M _s0 = lanes_both(certain, lanes_less(K(0.0), clearance));
    const V _s1 = lanes_select(certain, lanes_sub(time, delay), time);
    return (LANES(hoop_arrival_certainty_out)){ lanes_select(_s0, delay, K(0.0)), lanes_select(lanes_both(lanes_both(arrives, lanes_not(_s0)), lanes_less(_s1, undecided_time)), _s1, undecided_time) };
}

/* Whether all numbers of a release are small enough not to overflow.
   Table 1. 26 operations: 9 absolute values, 9 comparisons, 8 conjunctions. */
typedef struct {
    M in_range;
} LANES(hoop_state_in_range_out);

LANES_INLINE LANES(hoop_state_in_range_out)
LANES(hoop_state_in_range)(V x, V y, V z, V vx, V vy, V vz, V wx, V wy, V wz)
{
    const M _s0 = lanes_both(lanes_both(lanes_both(lanes_both(lanes_at_most(lanes_abs(x), K(1073741824.0)), lanes_at_most(lanes_abs(y), K(1073741824.0))), lanes_at_most(lanes_abs(z), K(1073741824.0))), lanes_at_most(lanes_abs(vx), K(1073741824.0))), lanes_at_most(lanes_abs(vy), K(1073741824.0)));
    const M _s1 = lanes_both(lanes_both(lanes_both(lanes_both(_s0, lanes_at_most(lanes_abs(vz), K(1073741824.0))), lanes_at_most(lanes_abs(wx), K(1073741824.0))), lanes_at_most(lanes_abs(wy), K(1073741824.0))), lanes_at_most(lanes_abs(wz), K(1073741824.0)));
    return (LANES(hoop_state_in_range_out)){ _s1 };
}

/* Start values: no arrival; an uncertain shot if its errors are not bounded.
   Table 1. 6 operations: 3 comparisons, 2 conjunctions, 1 selection. */
typedef struct {
    V when, which, earliest_delay, undecided_time;
} LANES(hoop_opening_out);

LANES_INLINE LANES(hoop_opening_out)
LANES(hoop_opening)(V excess, V position_error, V velocity_error)
{
    return (LANES(hoop_opening_out)){ K(INFINITY), K(-1.0), K(0.0), lanes_select(lanes_both(lanes_both(lanes_less(position_error, K(INFINITY)), lanes_less(velocity_error, K(INFINITY))), lanes_at_most(excess, K(0.0))), K(INFINITY), K(0.0)) };
}

/* Whether there is a time limit.
   Table 1. 1 operation: 1 comparison. */
typedef struct {
    M limited;
} LANES(hoop_limited_out);

LANES_INLINE LANES(hoop_limited_out)
LANES(hoop_limited)(V time_limit)
{
    return (LANES(hoop_limited_out)){ lanes_less(time_limit, K(INFINITY)) };
}

/* Time of the event.
   Table 1. 1 operation: 1 addition. */
typedef struct {
    V clock;
} LANES(hoop_event_clock_out);

LANES_INLINE LANES(hoop_event_clock_out)
LANES(hoop_event_clock)(V when, V clock)
{
    return (LANES(hoop_event_clock_out)){ lanes_add(when, clock) };
}

/* 1 if a decision up to this event, or the choice of the end, lies within its error.
   Table 1. 7 operations: 1 addition, 2 comparisons, 1 conjunction, 1 disjunction, 1 complement, 1 selection. */
typedef struct {
    V uncertain;
} LANES(hoop_flight_undecided_out);

LANES_INLINE LANES(hoop_flight_undecided_out)
LANES(hoop_flight_undecided)(V when, V earliest_delay, V undecided_time, V uncertain, M edge)
{
    const V _s0 = lanes_select(lanes_either(lanes_both(lanes_not(lanes_less(lanes_add(when, earliest_delay), undecided_time)), lanes_less(undecided_time, K(INFINITY))), edge), K(1.0), uncertain);
    return (LANES(hoop_flight_undecided_out)){ _s0 };
}

/* Whether an event changes the motion, or its errors are wanted.
   Table 1. 3 operations: 1 comparison, 1 conjunction, 1 disjunction. */
typedef struct {
    M meeting;
} LANES(hoop_meeting_out);

LANES_INLINE LANES(hoop_meeting_out)
LANES(hoop_meeting)(V claims, M ends, M touches)
{
    return (LANES(hoop_meeting_out)){ lanes_either(touches, lanes_both(ends, lanes_less(K(0.0), claims))) };
}

/* Whether the event is on a surface.
   Table 1. 1 operation: 1 comparison. */
typedef struct {
    M here;
} LANES(hoop_here_out);

LANES_INLINE LANES(hoop_here_out)
LANES(hoop_here)(V index, V which)
{
    return (LANES(hoop_here_out)){ lanes_equal(which, index) };
}

/* One more contact.
   Table 1. 1 operation: 1 addition. */
typedef struct {
    V count;
} LANES(hoop_counted_out);

LANES_INLINE LANES(hoop_counted_out)
LANES(hoop_counted)(V count)
{
    return (LANES(hoop_counted_out)){ lanes_add(K(1.0), count) };
}

/* 1 if a bound on an error is not finite.
   Table 1. 1 operation: 1 selection. */
typedef struct {
    V uncertain;
} LANES(hoop_without_bounds_out);

LANES_INLINE LANES(hoop_without_bounds_out)
LANES(hoop_without_bounds)(M unbounded, V uncertain)
{
    return (LANES(hoop_without_bounds_out)){ lanes_select(unbounded, K(1.0), uncertain) };
}

/* How the bounds on errors are carried over a contact.
   Table 1. 4 operations: 2 comparisons, 2 conjunctions. */
typedef struct {
    M carries, tightens;
} LANES(hoop_tightens_out);

LANES_INLINE LANES(hoop_tightens_out)
LANES(hoop_tightens)(V tightening, M touches)
{
    return (LANES(hoop_tightens_out)){ lanes_both(touches, lanes_at_most(tightening, K(0.0))), lanes_both(touches, lanes_less(K(0.0), tightening)) };
}

/* 1 if the flight began on the surface that the ball meets.
   Table 1. 2 operations: 1 comparison, 1 selection. */
typedef struct {
    V back;
} LANES(hoop_came_back_out);

LANES_INLINE LANES(hoop_came_back_out)
LANES(hoop_came_back)(V last, V which)
{
    return (LANES(hoop_came_back_out)){ lanes_select(lanes_equal(last, which), K(1.0), K(0.0)) };
}

/* Body touched first and surface touched last.
   Table 1. 2 operations: 1 comparison, 1 selection. */
typedef struct {
    V first, last;
} LANES(hoop_touched_out);

LANES_INLINE LANES(hoop_touched_out)
LANES(hoop_touched)(V which, V body, V first)
{
    return (LANES(hoop_touched_out)){ lanes_select(lanes_less(first, K(0.0)), body, first), which };
}

/* Whether a shot has ended at the time limit and its errors are wanted.
   Table 1. 3 operations: 2 comparisons, 1 conjunction. */
typedef struct {
    M ends_by_time_limit;
} LANES(hoop_ends_by_time_limit_out);

LANES_INLINE LANES(hoop_ends_by_time_limit_out)
LANES(hoop_ends_by_time_limit)(V index, V which, V claims)
{
    return (LANES(hoop_ends_by_time_limit_out)){ lanes_both(lanes_equal(which, index), lanes_less(K(0.0), claims)) };
}

/* Body that the event is on.
   Table 1. No operations. */
typedef struct {
    V body;
} LANES(hoop_body_of_out);

LANES_INLINE LANES(hoop_body_of_out)
LANES(hoop_body_of)(V which)
{
    return (LANES(hoop_body_of_out)){ which };
}

/* Outcome of a shot at its start, and whether that is uncertain.
   Table 1. 7 operations: 2 comparisons, 3 conjunctions, 2 selections. */
typedef struct {
    V outcome, uncertain;
} LANES(hoop_admitted_out);

LANES_INLINE LANES(hoop_admitted_out)
LANES(hoop_admitted)(V undecided_time, V valid, M permitted, M in_range)
{
    const M _s0 = lanes_both(permitted, in_range);
    return (LANES(hoop_admitted_out)){ lanes_select(lanes_both(_s0, lanes_less(K(0.0), valid)), K(-1.0), K(4.0)), lanes_select(lanes_both(_s0, lanes_less(K(0.0), undecided_time)), K(1.0), K(0.0)) };
}

/* Whether a shot that has ended may be certain with tighter bounds: it is not capped.
   Table 1. 6 operations: 3 comparisons, 2 conjunctions, 1 complement. */
typedef struct {
    M loose;
} LANES(hoop_loose_out);

LANES_INLINE LANES(hoop_loose_out)
LANES(hoop_loose)(V contacts, V outcome, V uncertain)
{
    return (LANES(hoop_loose_out)){ lanes_both(lanes_both(lanes_less(K(0.0), uncertain), lanes_less(K(0.0), contacts)), lanes_not(lanes_equal(outcome, K(2.0)))) };
}

/* The time limit as an arrival.
   Table 1. 12 operations: 2 additions, 1 subtraction, 1 multiplication, 4 comparisons, 1 conjunction, 1 complement, 2 selections. */
typedef struct {
    V time, delay;
    M arrives;
    V undecided_time;
} LANES(hoop_expiry_out);

LANES_INLINE LANES(hoop_expiry_out)
LANES(hoop_expiry)(V when, V which, V earliest_delay, V undecided_time, V time_error, V clock, V time_limit)
{
    const V _s0 = lanes_sub(time_limit, clock);
    return (LANES(hoop_expiry_out)){ lanes_max(K(0.0), _s0), lanes_add(time_error, lanes_mul(K(4.440892098500626e-16), time_limit)), lanes_at_most(K(0.0), which), lanes_select(lanes_both(lanes_not(lanes_less(lanes_add(when, earliest_delay), undecided_time)), lanes_less(undecided_time, K(INFINITY))), K(0.0), undecided_time) };
}

/* Whether there is no event, an end, or a contact, and the outcome without one.
   Table 1. 5 operations: 3 comparisons, 1 conjunction, 1 complement. */
typedef struct {
    M stays, moves, ends, touches;
    V reached;
    M edge;
} LANES(hoop_departed_out);

LANES_INLINE LANES(hoop_departed_out)
LANES(hoop_departed)(V index, V which)
{
    const M _s0 = lanes_less(which, K(0.0));
    const M _s1 = lanes_not(_s0);
    return (LANES(hoop_departed_out)){ _s0, _s1, lanes_at_most(index, which), lanes_both(_s1, lanes_less(which, index)), K(3.0), mask_none() };
}

/* Time, body and outcome of a shot that the time limit ends.
   Table 1. 6 operations: 1 comparison, 1 conjunction, 1 complement, 3 selections. */
typedef struct {
    V clock, body, reached;
    M ends;
} LANES(hoop_expired_out);

LANES_INLINE LANES(hoop_expired_out)
LANES(hoop_expired)(V index, V which, V body, V clock, V reached, V time_limit, M ends)
{
    const M _s0 = lanes_equal(which, index);
    return (LANES(hoop_expired_out)){ lanes_select(_s0, time_limit, clock), lanes_select(_s0, K(3.0), body), lanes_select(_s0, K(6.0), reached), lanes_both(ends, lanes_not(_s0)) };
}

/* Number of contacts, and the outcome if the shot ends.
   Table 1. 5 operations: 1 addition, 1 comparison, 3 selections. */
typedef struct {
    V contacts, outcome;
} LANES(hoop_accounted_out);

LANES_INLINE LANES(hoop_accounted_out)
LANES(hoop_accounted)(V contacts, V most_contacts, V reached, M touches)
{
    const V _s0 = lanes_add(K(1.0), contacts);
    return (LANES(hoop_accounted_out)){ lanes_select(touches, _s0, contacts), lanes_select(touches, lanes_select(lanes_at_most(most_contacts, _s0), K(2.0), K(-1.0)), reached) };
}

/* Sum of the errors of the contacts' times.
   Table 1. 1 operation: 1 addition. */
typedef struct {
    S clock_error;
} LANES(hoop_clock_error_sum_out);

LANES_INLINE LANES(hoop_clock_error_sum_out)
LANES(hoop_clock_error_sum)(S delay, S clock_error)
{
    return (LANES(hoop_clock_error_sum_out)){ singles_add(delay, clock_error) };
}

/* Whether bounds on errors are wanted here, and their start values.
   Table 1. 5 operations: 3 comparisons, 1 conjunction, 1 disjunction. */
typedef struct {
    M reports;
    S position_claim, velocity_claim, spin_claim, time_claim;
} LANES(hoop_closing_out);

LANES_INLINE LANES(hoop_closing_out)
LANES(hoop_closing)(S outcome, S claims)
{
    return (LANES(hoop_closing_out)){ singles_truth(singles_either(singles_both(singles_less(KS(0.0), claims), singles_at_most(KS(0.0), outcome)), singles_less(KS(1.0), claims))), KS(0.0), KS(0.0), KS(0.0), KS(0.0) };
}

/* Whether a flight with these ends may come to a plate.
   Table 1. 31 operations: 6 additions, 2 subtractions, 9 multiplications, 7 comparisons, 2 conjunctions, 1 complement, 4 selections. */
typedef struct {
    M reachable;
} LANES(hoop_reachable_out);

LANES_INLINE LANES(hoop_reachable_out)
LANES(hoop_reachable)(V x, V vx, V horizon, V extent, V speed, V pad, V earliest_delay, V position_error, V velocity_error, V _c0, V _c1, V _c2, V _c3, V _c4)
{
    const V _s0 = lanes_add(lanes_add(position_error, lanes_mul(horizon, velocity_error)), lanes_mul(K(9.313225746154785e-10), lanes_add(extent, lanes_mul(horizon, lanes_add(speed, lanes_mul(_c0, horizon))))));
    const V _s1 = lanes_select(lanes_less(pad, earliest_delay), K(INFINITY), _s0);
    const V _s2 = lanes_add(x, lanes_mul(vx, horizon));
    const V _s3 = lanes_min(_s2, x);
    const V _s4 = lanes_sub(_c1, lanes_mul(K(2.0), _s1));
    const V _s5 = lanes_max(_s3, _c4);
    const V _s6 = lanes_min(K(0.0), _s5);
    const M _s7 = lanes_both(lanes_less(_s1, lanes_sub(_s3, _c2)), lanes_both(lanes_less(K(0.0), _s4), lanes_less(lanes_mul(K(1.0000000000009095), lanes_add(_c3, lanes_mul(_s6, _s6))), lanes_mul(_s4, _s4))));
    return (LANES(hoop_reachable_out)){ lanes_not(_s7) };
}

/* Undecided time 0 if errors are too large to decide on which side a flight begins.
   Table 1. 5 operations: 3 multiplications, 1 comparison, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(hoop_plane_start_out);

LANES_INLINE LANES(hoop_plane_start_out)
LANES(hoop_plane_start)(V undecided_time, V position_error, V velocity_error, V _c0)
{
    const V _s0 = lanes_mul(K(2.0), velocity_error);
    return (LANES(hoop_plane_start_out)){ lanes_select(lanes_less(lanes_mul(position_error, _c0), lanes_mul(_s0, _s0)), K(0.0), undecided_time) };
}

/* The same, through the product of derivatives since an earlier contact.
   derivative of the frame-free Eq. 17, with roundings. 1508 operations: 468 additions, 68 subtractions, 708 multiplications, 6 divisions, 40 negations, 128 absolute values, 16 comparisons, 74 selections. */
typedef struct {
    S place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound, spin_bound, left_nx, left_ny, left_nz, left_ex, left_ey, left_bend_s, left_bend_e, delay, origin_s, origin_e, origin_u, origin_v, origin_w, origin_t, recent_s, recent_e, recent_u, recent_v, recent_w, recent_t, product_11, product_12, product_13, product_14, product_15, product_16, product_21, product_22, product_23, product_24, product_25, product_26, product_31, product_32, product_33, product_34, product_35, product_36, product_41, product_42, product_43, product_44, product_45, product_46, product_51, product_52, product_53, product_54, product_55, product_56, product_61, product_62, product_63, product_64, product_65, product_66, continued;
} LANES(hoop_tighten_impact_out);

LANES_INLINE LANES(hoop_tighten_impact_out)
LANES(hoop_tighten_impact)(S t, S x, S y, S z, S vx, S vy, S vz, S wx, S wy, S wz, S nx, S ny, S nz, S clock, S left_nx, S left_ny, S left_nz, S place_n, S place_s, S place_e, S pace_n, S pace_s, S pace_e, S turn_n, S turn_z, S position_bound, S velocity_bound, S spin_bound, S tangent_x, S tangent_y, S bend_s, S bend_e, S left_ex, S left_ey, S left_bend_s, S left_bend_e, S sharpest_bend, S root_offset, S root_level, S normal_rounding, S normal_velocity, S back, S origin_s, S origin_e, S origin_u, S origin_v, S origin_w, S origin_t, S product_11, S product_12, S product_13, S product_14, S product_15, S product_16, S product_21, S product_22, S product_23, S product_24, S product_25, S product_26, S product_31, S product_32, S product_33, S product_34, S product_35, S product_36, S product_41, S product_42, S product_43, S product_44, S product_45, S product_46, S product_51, S product_52, S product_53, S product_54, S product_55, S product_56, S product_61, S product_62, S product_63, S product_64, S product_65, S product_66, S recent_s, S recent_e, S recent_u, S recent_v, S recent_w, S recent_t, S continued, S _c0, S _c1, S _c2, S _c3, S _c4, S _c5, S _c6, S _c7, S _c8, S _c9)
{
    const S _s0 = singles_neg(singles_mul(_c2, nz));
    const S _s1 = singles_abs(vx);
    const S _s2 = singles_mul(KS(2.0), t);
    const S _s3 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s2, _s1), singles_abs(x))));
    const S _s4 = singles_abs(vy);
    const S _s5 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s2, _s4), singles_abs(y))));
    const S _s6 = singles_add(singles_add(singles_mul(_c3, singles_mul(t, t)), singles_mul(_s2, singles_abs(singles_add(vz, singles_mul(_c3, t))))), singles_abs(z));
    const S _s7 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), _s6));
    const S _s8 = singles_add(singles_add(singles_add(position_bound, singles_mul(t, velocity_bound)), singles_add(singles_add(_s3, _s5), _s7)), singles_max(root_offset, root_level));
    const S _s9 = singles_add(singles_add(singles_mul(nx, left_nx), singles_mul(ny, left_ny)), singles_mul(nz, left_nz));
    const S _s10 = singles_sub(_s9, back);
    const S _s11 = singles_mul(nz, tangent_y);
    const S _s12 = singles_neg(singles_mul(nz, tangent_x));
    const S _s13 = singles_add(singles_mul(left_ex, _s11), singles_mul(left_ey, _s12));
    const S _s14 = singles_mul(left_bend_s, _s13);
    const S _s15 = singles_add(singles_mul(vx, tangent_x), singles_mul(vy, tangent_y));
    const S _s16 = singles_add(singles_mul(tangent_x, left_ex), singles_mul(tangent_y, left_ey));
    const S _s17 = singles_mul(left_bend_s, _s16);
    const S _s18 = singles_sub(singles_mul(ny, tangent_x), singles_mul(nx, tangent_y));
    const S _s19 = singles_add(singles_add(singles_mul(vx, _s11), singles_mul(vy, _s12)), singles_mul(vz, _s18));
    const S _s20 = singles_neg(singles_mul(_c2, _s18));
    const S _s21 = singles_sub(_s19, singles_mul(t, _s20));
    const S _s22 = singles_sub(singles_mul(_s14, _s15), singles_mul(_s17, _s21));
    const S _s23 = singles_mul(left_nz, left_ey);
    const S _s24 = singles_neg(singles_mul(left_nz, left_ex));
    const S _s25 = singles_sub(singles_mul(left_ny, left_ex), singles_mul(left_nx, left_ey));
    const S _s26 = singles_add(singles_add(singles_mul(nx, _s23), singles_mul(ny, _s24)), singles_mul(nz, _s25));
    const S _s27 = singles_add(singles_mul(t, _s22), _s26);
    const S _s28 = singles_mul(left_bend_e, _s18);
    const S _s29 = singles_mul(_s28, _s15);
    const S _s30 = singles_add(singles_mul(nx, left_ex), singles_mul(ny, left_ey));
    const S _s31 = singles_add(singles_mul(t, _s29), _s30);
    const S _s32 = singles_mul(t, _s9);
    const S _s33 = singles_mul(t, _s26);
    const S _s34 = singles_add(singles_add(singles_add(singles_add(singles_mul(place_n, singles_abs(_s10)), singles_mul(place_s, singles_abs(_s27))), singles_mul(place_e, singles_abs(_s31))), singles_mul(pace_n, singles_abs(_s32))), singles_mul(pace_s, singles_abs(_s33)));
    const S _s35 = singles_mul(t, _s30);
    const S _s36 = singles_mul(_c2, t);
    const S _s37 = singles_abs(vz);
    const S _s38 = singles_add(singles_add(_s1, _s4), _s37);
    const S _s39 = singles_add(singles_mul(place_s, left_bend_s), singles_mul(place_e, left_bend_e));
    const S _s40 = singles_mul(singles_add(_s36, _s38), _s39);
    const S _s41 = singles_mul(KS(7.62939453125e-06), singles_add(singles_mul(t, _s40), _s8));
    const S _s42 = singles_add(singles_add(singles_add(root_offset, singles_mul(singles_mul(KS(1.02), singles_mul(sharpest_bend, _s8)), _s8)), singles_add(_s34, singles_mul(pace_e, singles_abs(_s35)))), _s41);
    const S _s43 = singles_abs(normal_velocity);
    const S _s44 = singles_div(singles_mul(KS(1.1), _s42), _s43);
    const S _s45 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_add(singles_add(_s36, _s1), _s4), _s37)));
    const S _s46 = singles_add(velocity_bound, _s45);
    const S _s47 = singles_add(singles_mul(_c2, _s44), _s46);
    const S _s48 = singles_add(_s47, _s38);
    const S _s49 = singles_add(singles_mul(_s44, _s48), _s8);
    const S _s50 = singles_mul(KS(1.02), sharpest_bend);
    const S _s51 = singles_mul(_s50, _s49);
    const S _s52 = singles_sub(singles_mul(KS(12.0), singles_add(singles_add(singles_mul(singles_abs(_s0), _s44), singles_mul(_s51, _s48)), _s46)), _s43);
    const S _s53 = singles_sub(singles_mul(KS(100.0), singles_mul(sharpest_bend, _s49)), KS(1.0));
    const S _s54 = singles_max(_s52, _s53);
    const S _s55 = singles_add(singles_mul(_c3, singles_mul(_s44, _s44)), singles_mul(_s44, _s46));
    const S _s56 = singles_div(singles_add(singles_mul(_s51, _s49), _s55), _s43);
    const S _s57 = singles_add(singles_mul(_s56, _s38), _s55);
    const S _s58 = singles_add(singles_add(root_level, _s57), singles_add(singles_add(singles_mul(singles_abs(nx), _s3), singles_mul(singles_abs(ny), _s5)), singles_mul(singles_abs(nz), _s7)));
    const S _s59 = singles_mul(bend_s, _s58);
    const S _s60 = singles_sub(singles_mul(KS(4194304.0), singles_add(singles_mul(place_n, left_bend_s), _s59)), KS(1.0));
    const S _s61 = singles_mul(KS(1.0009765625), _s58);
    const Q _s62 = singles_at_most(singles_max(_s54, _s60), KS(0.0));
    const S _s63 = singles_div(KS(1.0), normal_velocity);
    const S _s64 = singles_neg(singles_mul(_s63, _s35));
    const S _s65 = singles_add(singles_mul(_s64, _s19), singles_mul(t, _s13));
    const Q _s66 = singles_less(KS(0.0), continued);
    const S _s67 = singles_select(_s66, product_51, KS(0.0));
    const S _s68 = singles_neg(singles_mul(_s63, _s32));
    const S _s69 = singles_add(singles_add(singles_mul(left_nx, _s11), singles_mul(left_ny, _s12)), singles_mul(left_nz, _s18));
    const S _s70 = singles_add(singles_mul(_s68, _s19), singles_mul(t, _s69));
    const S _s71 = singles_select(_s66, product_31, KS(0.0));
    const S _s72 = singles_neg(singles_mul(_s63, _s33));
    const S _s73 = singles_add(singles_add(singles_mul(_s12, _s24), singles_mul(_s11, _s23)), singles_mul(_s18, _s25));
    const S _s74 = singles_add(singles_mul(_s72, _s19), singles_mul(t, _s73));
    const S _s75 = singles_select(_s66, product_41, KS(0.0));
    const S _s76 = singles_neg(singles_mul(_s63, _s31));
    const S _s77 = singles_mul(nz, left_bend_e);
    const S _s78 = singles_neg(singles_mul(_s77, _s15));
    const S _s79 = singles_add(singles_mul(_s76, _s19), singles_add(singles_mul(t, _s78), _s13));
    const S _s80 = singles_select(_s66, product_21, KS(0.0));
    const S _s81 = singles_neg(singles_mul(_s63, _s27));
    const S _s82 = singles_sub(normal_velocity, singles_mul(t, _s0));
    const S _s83 = singles_mul(left_bend_s, _s30);
    const S _s84 = singles_sub(singles_mul(_s17, _s82), singles_mul(_s83, _s15));
    const S _s85 = singles_add(singles_mul(_s81, _s19), singles_add(singles_mul(t, _s84), _s73));
    const S _s86 = singles_select(_s66, product_11, KS(1.0));
    const S _s87 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s65, _s67), singles_mul(_s70, _s71)), singles_mul(_s74, _s75)), singles_mul(_s79, _s80)), singles_mul(_s85, _s86));
    const S _s88 = singles_select(_s66, origin_s, place_s);
    const S _s89 = singles_select(_s66, product_52, KS(0.0));
    const S _s90 = singles_select(_s66, product_32, KS(0.0));
    const S _s91 = singles_select(_s66, product_42, KS(0.0));
    const S _s92 = singles_select(_s66, product_22, KS(1.0));
    const S _s93 = singles_select(_s66, product_12, KS(0.0));
    const S _s94 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s65, _s89), singles_mul(_s70, _s90)), singles_mul(_s74, _s91)), singles_mul(_s79, _s92)), singles_mul(_s85, _s93));
    const S _s95 = singles_select(_s66, origin_e, place_e);
    const S _s96 = singles_select(_s66, product_53, KS(0.0));
    const S _s97 = singles_select(_s66, product_33, KS(1.0));
    const S _s98 = singles_select(_s66, product_43, KS(0.0));
    const S _s99 = singles_select(_s66, product_23, KS(0.0));
    const S _s100 = singles_select(_s66, product_13, KS(0.0));
    const S _s101 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s65, _s96), singles_mul(_s70, _s97)), singles_mul(_s74, _s98)), singles_mul(_s79, _s99)), singles_mul(_s85, _s100));
    const S _s102 = singles_select(_s66, origin_u, pace_n);
    const S _s103 = singles_select(_s66, product_54, KS(0.0));
    const S _s104 = singles_select(_s66, product_34, KS(0.0));
    const S _s105 = singles_select(_s66, product_44, KS(1.0));
    const S _s106 = singles_select(_s66, product_24, KS(0.0));
    const S _s107 = singles_select(_s66, product_14, KS(0.0));
    const S _s108 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s65, _s103), singles_mul(_s70, _s104)), singles_mul(_s74, _s105)), singles_mul(_s79, _s106)), singles_mul(_s85, _s107));
    const S _s109 = singles_select(_s66, origin_v, pace_s);
    const S _s110 = singles_select(_s66, product_55, KS(1.0));
    const S _s111 = singles_select(_s66, product_35, KS(0.0));
    const S _s112 = singles_select(_s66, product_45, KS(0.0));
    const S _s113 = singles_select(_s66, product_25, KS(0.0));
    const S _s114 = singles_select(_s66, product_15, KS(0.0));
    const S _s115 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s65, _s110), singles_mul(_s70, _s111)), singles_mul(_s74, _s112)), singles_mul(_s79, _s113)), singles_mul(_s85, _s114));
    const S _s116 = singles_select(_s66, origin_w, pace_e);
    const S _s117 = singles_add(singles_add(singles_add(singles_add(singles_mul(singles_abs(_s87), _s88), singles_mul(singles_abs(_s94), _s95)), singles_mul(singles_abs(_s101), _s102)), singles_mul(singles_abs(_s108), _s109)), singles_mul(singles_abs(_s115), _s116));
    const S _s118 = singles_select(_s66, product_56, KS(0.0));
    const S _s119 = singles_select(_s66, product_36, KS(0.0));
    const S _s120 = singles_select(_s66, product_46, KS(0.0));
    const S _s121 = singles_select(_s66, product_26, KS(0.0));
    const S _s122 = singles_select(_s66, product_16, KS(0.0));
    const S _s123 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s65, _s118), singles_mul(_s70, _s119)), singles_mul(_s74, _s120)), singles_mul(_s79, _s121)), singles_mul(_s85, _s122));
    const S _s124 = singles_select(_s66, origin_t, turn_n);
    const S _s125 = singles_add(_s117, singles_mul(singles_abs(_s123), _s124));
    const S _s126 = singles_abs(_s19);
    const S _s127 = singles_div(singles_add(root_offset, _s41), _s43);
    const S _s128 = singles_add(singles_mul(_s126, _s127), singles_add(singles_add(singles_mul(singles_abs(_s12), _s5), singles_mul(singles_abs(_s11), _s3)), singles_mul(singles_abs(_s18), _s7)));
    const S _s129 = singles_add(singles_add(_s57, singles_mul(KS(7.62939453125e-06), _s49)), _s41);
    const S _s130 = singles_neg(singles_mul(_s63, _s10));
    const S _s131 = singles_add(singles_mul(_s130, _s19), _s69);
    const S _s132 = singles_add(singles_mul(KS(9.5367431640625e-07), pace_e), singles_select(_s66, recent_w, KS(0.0)));
    const S _s133 = singles_add(singles_mul(KS(9.5367431640625e-07), pace_n), singles_select(_s66, recent_u, KS(0.0)));
    const S _s134 = singles_add(singles_mul(KS(9.5367431640625e-07), pace_s), singles_select(_s66, recent_v, KS(0.0)));
    const S _s135 = singles_add(singles_mul(KS(9.5367431640625e-07), place_e), singles_select(_s66, recent_e, KS(0.0)));
    const S _s136 = singles_add(singles_add(singles_add(singles_add(singles_mul(place_n, singles_abs(_s131)), singles_mul(singles_abs(_s65), _s132)), singles_mul(singles_abs(_s70), _s133)), singles_mul(singles_abs(_s74), _s134)), singles_mul(singles_abs(_s79), _s135));
    const S _s137 = singles_add(singles_mul(KS(9.5367431640625e-07), place_s), singles_select(_s66, recent_s, KS(0.0)));
    const S _s138 = singles_mul(KS(1.0009765625), singles_add(singles_add(_s128, _s129), singles_add(_s136, singles_mul(singles_abs(_s85), _s137))));
    const S _s139 = singles_mul(KS(1.0009765625), singles_add(_s125, _s138));
    const S _s140 = singles_add(singles_mul(_s64, _s15), singles_mul(t, _s16));
    const S _s141 = singles_add(singles_mul(left_nx, tangent_x), singles_mul(left_ny, tangent_y));
    const S _s142 = singles_add(singles_mul(_s68, _s15), singles_mul(t, _s141));
    const S _s143 = singles_add(singles_mul(tangent_x, _s23), singles_mul(tangent_y, _s24));
    const S _s144 = singles_add(singles_mul(_s72, _s15), singles_mul(t, _s143));
    const S _s145 = singles_sub(singles_mul(_s77, _s21), singles_mul(_s28, _s82));
    const S _s146 = singles_add(singles_mul(_s76, _s15), singles_add(singles_mul(t, _s145), _s16));
    const S _s147 = singles_sub(singles_mul(_s83, _s21), singles_mul(_s14, _s82));
    const S _s148 = singles_add(singles_mul(_s81, _s15), singles_add(singles_mul(t, _s147), _s143));
    const S _s149 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s140, _s67), singles_mul(_s142, _s71)), singles_mul(_s144, _s75)), singles_mul(_s146, _s80)), singles_mul(_s148, _s86));
    const S _s150 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s140, _s89), singles_mul(_s142, _s90)), singles_mul(_s144, _s91)), singles_mul(_s146, _s92)), singles_mul(_s148, _s93));
    const S _s151 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s140, _s96), singles_mul(_s142, _s97)), singles_mul(_s144, _s98)), singles_mul(_s146, _s99)), singles_mul(_s148, _s100));
    const S _s152 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s140, _s103), singles_mul(_s142, _s104)), singles_mul(_s144, _s105)), singles_mul(_s146, _s106)), singles_mul(_s148, _s107));
    const S _s153 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s140, _s110), singles_mul(_s142, _s111)), singles_mul(_s144, _s112)), singles_mul(_s146, _s113)), singles_mul(_s148, _s114));
    const S _s154 = singles_add(singles_add(singles_add(singles_add(singles_mul(singles_abs(_s149), _s88), singles_mul(singles_abs(_s150), _s95)), singles_mul(singles_abs(_s151), _s102)), singles_mul(singles_abs(_s152), _s109)), singles_mul(singles_abs(_s153), _s116));
    const S _s155 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s140, _s118), singles_mul(_s142, _s119)), singles_mul(_s144, _s120)), singles_mul(_s146, _s121)), singles_mul(_s148, _s122));
    const S _s156 = singles_add(_s154, singles_mul(singles_abs(_s155), _s124));
    const S _s157 = singles_abs(_s15);
    const S _s158 = singles_add(singles_mul(_s157, _s127), singles_add(singles_add(singles_mul(_c4, _s7), singles_mul(singles_abs(tangent_x), _s3)), singles_mul(singles_abs(tangent_y), _s5)));
    const S _s159 = singles_add(singles_mul(_s130, _s15), _s141);
    const S _s160 = singles_add(singles_add(singles_add(singles_add(singles_mul(place_n, singles_abs(_s159)), singles_mul(singles_abs(_s140), _s132)), singles_mul(singles_abs(_s142), _s133)), singles_mul(singles_abs(_s144), _s134)), singles_mul(singles_abs(_s146), _s135));
    const S _s161 = singles_mul(KS(1.0009765625), singles_add(singles_add(_s158, _s129), singles_add(_s160, singles_mul(singles_abs(_s148), _s137))));
    const S _s162 = singles_mul(KS(1.0009765625), singles_add(_s156, _s161));
    const S _s163 = singles_neg(singles_mul(_c1, _s0));
    const S _s164 = singles_neg(singles_mul(bend_s, _s19));
    const S _s165 = singles_neg(singles_mul(_c1, _s164));
    const S _s166 = singles_mul(bend_e, _s18);
    const S _s167 = singles_mul(_s166, _s15);
    const S _s168 = singles_neg(singles_mul(_c1, _s167));
    const S _s169 = singles_sub(singles_sub(singles_add(singles_mul(_s163, _s64), singles_neg(singles_mul(_c1, _s30))), singles_mul(_s165, _s65)), singles_mul(_s168, _s140));
    const S _s170 = singles_sub(singles_sub(singles_add(singles_mul(_s163, _s68), singles_neg(singles_mul(_c1, _s9))), singles_mul(_s165, _s70)), singles_mul(_s168, _s142));
    const S _s171 = singles_sub(singles_sub(singles_add(singles_mul(_s163, _s72), singles_neg(singles_mul(_c1, _s26))), singles_mul(_s165, _s74)), singles_mul(_s168, _s144));
    const S _s172 = singles_sub(singles_sub(singles_add(singles_mul(_s163, _s76), singles_neg(singles_mul(_c1, _s29))), singles_mul(_s165, _s79)), singles_mul(_s168, _s146));
    const S _s173 = singles_sub(singles_sub(singles_add(singles_mul(_s163, _s81), singles_neg(singles_mul(_c1, _s22))), singles_mul(_s165, _s85)), singles_mul(_s168, _s148));
    const S _s174 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s169, _s67), singles_mul(_s170, _s71)), singles_mul(_s171, _s75)), singles_mul(_s172, _s80)), singles_mul(_s173, _s86));
    const S _s175 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s169, _s89), singles_mul(_s170, _s90)), singles_mul(_s171, _s91)), singles_mul(_s172, _s92)), singles_mul(_s173, _s93));
    const S _s176 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s169, _s96), singles_mul(_s170, _s97)), singles_mul(_s171, _s98)), singles_mul(_s172, _s99)), singles_mul(_s173, _s100));
    const S _s177 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s169, _s103), singles_mul(_s170, _s104)), singles_mul(_s171, _s105)), singles_mul(_s172, _s106)), singles_mul(_s173, _s107));
    const S _s178 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s169, _s110), singles_mul(_s170, _s111)), singles_mul(_s171, _s112)), singles_mul(_s172, _s113)), singles_mul(_s173, _s114));
    const S _s179 = singles_add(singles_add(singles_add(singles_add(singles_mul(singles_abs(_s174), _s88), singles_mul(singles_abs(_s175), _s95)), singles_mul(singles_abs(_s176), _s102)), singles_mul(singles_abs(_s177), _s109)), singles_mul(singles_abs(_s178), _s116));
    const S _s180 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s169, _s118), singles_mul(_s170, _s119)), singles_mul(_s171, _s120)), singles_mul(_s172, _s121)), singles_mul(_s173, _s122));
    const S _s181 = singles_add(_s179, singles_mul(singles_abs(_s180), _s124));
    const S _s182 = singles_add(singles_mul(_c2, _s127), _s45);
    const S _s183 = singles_add(_s182, singles_add(singles_mul(singles_abs(_s164), _s128), singles_mul(singles_abs(_s167), _s158)));
    const S _s184 = singles_add(normal_rounding, _s59);
    const S _s185 = singles_add(singles_add(singles_abs(wx), singles_abs(wy)), singles_abs(wz));
    const S _s186 = singles_mul(singles_mul(_c6, _s184), _s185);
    const S _s187 = singles_mul(_c0, _s185);
    const S _s188 = singles_add(_s187, _s38);
    const S _s189 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.5543122344752192e-15), _s188));
    const S _s190 = singles_mul(_c2, _s56);
    const S _s191 = singles_mul(singles_add(bend_s, bend_e), _s129);
    const S _s192 = singles_mul(_s51, _s51);
    const S _s193 = singles_add(singles_mul(_s50, _s57), singles_mul(KS(2.0), _s192));
    const S _s194 = singles_add(singles_add(singles_add(_s190, singles_mul(_s51, singles_add(singles_mul(spin_bound, _c6), singles_mul(_c7, _s47)))), singles_mul(_s191, _s188)), singles_mul(_s193, singles_add(singles_mul(_c6, _s185), singles_mul(_c7, _s38))));
    const S _s195 = singles_add(spin_bound, singles_mul(_s39, _s185));
    const S _s196 = singles_mul(KS(7.62939453125e-06), singles_add(singles_add(singles_mul(_c0, _s195), singles_mul(_s51, singles_add(_s187, singles_mul(KS(4.0), _s38)))), singles_mul(KS(2.0), singles_add(_s40, _s47))));
    const S _s197 = singles_add(singles_add(_s194, singles_mul(singles_mul(_s192, _c5), _s48)), _s196);
    const S _s198 = singles_add(singles_add(singles_mul(_c1, _s183), singles_mul(_c5, singles_add(singles_mul(normal_rounding, singles_add(_s38, _s43)), singles_mul(singles_mul(KS(2.0), _s59), _s43)))), singles_add(singles_add(_s186, _s189), _s197));
    const S _s199 = singles_add(singles_mul(place_n, singles_abs(singles_sub(singles_sub(singles_mul(_s163, _s130), singles_mul(_s165, _s131)), singles_mul(_s168, _s159)))), singles_mul(singles_abs(_s169), _s132));
    const S _s200 = singles_add(singles_add(singles_add(singles_add(_s199, singles_mul(singles_abs(_s170), _s133)), singles_mul(singles_abs(_s171), _s134)), singles_mul(singles_abs(_s172), _s135)), singles_mul(singles_abs(_s173), _s137));
    const S _s201 = singles_mul(KS(1.0009765625), singles_add(_s198, _s200));
    const S _s202 = singles_mul(KS(1.0009765625), singles_add(_s181, _s201));
    const S _s203 = singles_mul(_c6, _s141);
    const S _s204 = singles_select(_s66, product_61, KS(0.0));
    const S _s205 = singles_mul(KS(0.6), _s20);
    const S _s206 = singles_add(singles_add(singles_mul(wx, _s11), singles_mul(wy, _s12)), singles_mul(wz, _s18));
    const S _s207 = singles_add(singles_add(singles_mul(nx, wx), singles_mul(ny, wy)), singles_mul(nz, wz));
    const S _s208 = singles_mul(_s18, _s207);
    const S _s209 = singles_mul(bend_e, singles_sub(singles_mul(nz, _s206), _s208));
    const S _s210 = singles_mul(nz, bend_e);
    const S _s211 = singles_neg(singles_mul(_s210, _s15));
    const S _s212 = singles_add(singles_mul(_c6, _s209), singles_mul(KS(0.6), _s211));
    const S _s213 = singles_sub(singles_add(singles_mul(_s64, _s205), singles_add(singles_mul(_c6, singles_neg(singles_mul(_c8, _s143))), singles_mul(KS(0.6), _s13))), singles_mul(_s212, _s140));
    const S _s214 = singles_mul(bend_s, normal_velocity);
    const S _s215 = singles_mul(KS(0.6), _s214);
    const S _s216 = singles_sub(_s213, singles_mul(_s65, _s215));
    const S _s217 = singles_sub(singles_sub(singles_add(singles_mul(_s68, _s205), singles_mul(KS(0.6), _s69)), singles_mul(_s212, _s142)), singles_mul(_s70, _s215));
    const S _s218 = singles_sub(singles_sub(singles_add(singles_mul(_s72, _s205), singles_add(singles_mul(_c6, singles_mul(_c8, _s16)), singles_mul(KS(0.6), _s73))), singles_mul(_s212, _s144)), singles_mul(_s74, _s215));
    const S _s219 = singles_sub(singles_add(singles_mul(_s76, _s205), singles_add(singles_mul(_c6, singles_sub(singles_mul(_s77, _s206), singles_mul(_s28, _s207))), singles_mul(KS(0.6), _s78))), singles_mul(_s212, _s146));
    const S _s220 = singles_sub(_s219, singles_mul(_s79, _s215));
    const S _s221 = singles_sub(singles_add(singles_mul(_s81, _s205), singles_add(singles_mul(_c6, singles_sub(singles_mul(_s83, _s206), singles_mul(_s14, _s207))), singles_mul(KS(0.6), _s84))), singles_mul(_s212, _s148));
    const S _s222 = singles_sub(_s221, singles_mul(_s85, _s215));
    const S _s223 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s203, _s204), singles_mul(_s216, _s67)), singles_mul(_s217, _s71)), singles_mul(_s218, _s75)), singles_mul(_s220, _s80)), singles_mul(_s222, _s86));
    const S _s224 = singles_select(_s66, product_62, KS(0.0));
    const S _s225 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s203, _s224), singles_mul(_s216, _s89)), singles_mul(_s217, _s90)), singles_mul(_s218, _s91)), singles_mul(_s220, _s92)), singles_mul(_s222, _s93));
    const S _s226 = singles_select(_s66, product_63, KS(0.0));
    const S _s227 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s203, _s226), singles_mul(_s216, _s96)), singles_mul(_s217, _s97)), singles_mul(_s218, _s98)), singles_mul(_s220, _s99)), singles_mul(_s222, _s100));
    const S _s228 = singles_select(_s66, product_64, KS(0.0));
    const S _s229 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s203, _s228), singles_mul(_s216, _s103)), singles_mul(_s217, _s104)), singles_mul(_s218, _s105)), singles_mul(_s220, _s106)), singles_mul(_s222, _s107));
    const S _s230 = singles_select(_s66, product_65, KS(0.0));
    const S _s231 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s203, _s230), singles_mul(_s216, _s110)), singles_mul(_s217, _s111)), singles_mul(_s218, _s112)), singles_mul(_s220, _s113)), singles_mul(_s222, _s114));
    const S _s232 = singles_add(singles_add(singles_add(singles_add(singles_mul(singles_abs(_s223), _s88), singles_mul(singles_abs(_s225), _s95)), singles_mul(singles_abs(_s227), _s102)), singles_mul(singles_abs(_s229), _s109)), singles_mul(singles_abs(_s231), _s116));
    const S _s233 = singles_select(_s66, product_66, KS(1.0));
    const S _s234 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s203, _s233), singles_mul(_s216, _s118)), singles_mul(_s217, _s119)), singles_mul(_s218, _s120)), singles_mul(_s220, _s121)), singles_mul(_s222, _s122));
    const S _s235 = singles_add(_s232, singles_mul(singles_abs(_s234), _s124));
    const S _s236 = singles_mul(_c4, _s128);
    const S _s237 = singles_add(_s236, singles_mul(singles_abs(_s209), _s158));
    const S _s238 = singles_add(_s182, singles_add(singles_mul(singles_abs(_s214), _s128), singles_mul(singles_abs(_s211), _s158)));
    const S _s239 = singles_add(singles_add(singles_add(singles_mul(singles_mul(normal_rounding, _c5), _s43), _s186), _s189), _s197);
    const S _s240 = singles_add(singles_mul(place_n, singles_abs(singles_sub(singles_sub(singles_mul(_s130, _s205), singles_mul(_s212, _s159)), singles_mul(_s131, _s215)))), singles_mul(turn_z, singles_abs(singles_mul(_c6, _s16))));
    const S _s241 = singles_add(singles_mul(KS(9.5367431640625e-07), turn_n), singles_select(_s66, recent_t, KS(0.0)));
    const S _s242 = singles_add(singles_add(singles_add(_s240, singles_mul(turn_z, singles_abs(singles_mul(_c6, _s143)))), singles_mul(singles_abs(_s203), _s241)), singles_mul(singles_abs(_s216), _s132));
    const S _s243 = singles_add(singles_add(singles_add(singles_add(_s242, singles_mul(singles_abs(_s217), _s133)), singles_mul(singles_abs(_s218), _s134)), singles_mul(singles_abs(_s220), _s135)), singles_mul(singles_abs(_s222), _s137));
    const S _s244 = singles_mul(KS(1.0009765625), singles_add(singles_add(singles_add(singles_mul(_c6, _s237), singles_mul(KS(0.6), _s238)), _s239), _s243));
    const S _s245 = singles_mul(KS(1.0009765625), singles_add(_s235, _s244));
    const S _s246 = singles_neg(singles_mul(_c6, _s69));
    const S _s247 = singles_mul(bend_s, _s207);
    const S _s248 = singles_neg(singles_mul(_c6, _s247));
    const S _s249 = singles_mul(bend_e, singles_sub(singles_mul(nz, _s19), singles_mul(normal_velocity, _s18)));
    const S _s250 = singles_add(singles_mul(wx, tangent_x), singles_mul(wy, tangent_y));
    const S _s251 = singles_neg(singles_mul(_s210, _s250));
    const S _s252 = singles_sub(singles_mul(KS(0.6), _s249), singles_mul(_c6, _s251));
    const S _s253 = singles_sub(singles_sub(singles_sub(singles_mul(KS(0.6), _s16), singles_mul(_c6, singles_neg(singles_mul(_c8, _s73)))), singles_mul(_s248, _s65)), singles_mul(_s252, _s140));
    const S _s254 = singles_sub(singles_sub(singles_mul(KS(0.6), _s141), singles_mul(_s248, _s70)), singles_mul(_s252, _s142));
    const S _s255 = singles_sub(singles_sub(singles_sub(singles_mul(KS(0.6), _s143), singles_mul(_c6, singles_mul(_c8, _s13))), singles_mul(_s248, _s74)), singles_mul(_s252, _s144));
    const S _s256 = singles_sub(singles_sub(singles_sub(singles_mul(KS(0.6), _s145), singles_mul(_c6, singles_neg(singles_mul(_s77, _s250)))), singles_mul(_s248, _s79)), singles_mul(_s252, _s146));
    const S _s257 = singles_sub(singles_sub(singles_sub(singles_mul(KS(0.6), _s147), singles_mul(_c6, singles_sub(singles_mul(_s17, _s207), singles_mul(_s83, _s250)))), singles_mul(_s248, _s85)), singles_mul(_s252, _s148));
    const S _s258 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s246, _s204), singles_mul(_s253, _s67)), singles_mul(_s254, _s71)), singles_mul(_s255, _s75)), singles_mul(_s256, _s80)), singles_mul(_s257, _s86));
    const S _s259 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s246, _s224), singles_mul(_s253, _s89)), singles_mul(_s254, _s90)), singles_mul(_s255, _s91)), singles_mul(_s256, _s92)), singles_mul(_s257, _s93));
    const S _s260 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s246, _s226), singles_mul(_s253, _s96)), singles_mul(_s254, _s97)), singles_mul(_s255, _s98)), singles_mul(_s256, _s99)), singles_mul(_s257, _s100));
    const S _s261 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s246, _s228), singles_mul(_s253, _s103)), singles_mul(_s254, _s104)), singles_mul(_s255, _s105)), singles_mul(_s256, _s106)), singles_mul(_s257, _s107));
    const S _s262 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s246, _s230), singles_mul(_s253, _s110)), singles_mul(_s254, _s111)), singles_mul(_s255, _s112)), singles_mul(_s256, _s113)), singles_mul(_s257, _s114));
    const S _s263 = singles_add(singles_add(singles_add(singles_add(singles_mul(singles_abs(_s258), _s88), singles_mul(singles_abs(_s259), _s95)), singles_mul(singles_abs(_s260), _s102)), singles_mul(singles_abs(_s261), _s109)), singles_mul(singles_abs(_s262), _s116));
    const S _s264 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s246, _s233), singles_mul(_s253, _s118)), singles_mul(_s254, _s119)), singles_mul(_s255, _s120)), singles_mul(_s256, _s121)), singles_mul(_s257, _s122));
    const S _s265 = singles_add(_s263, singles_mul(singles_abs(_s264), _s124));
    const S _s266 = singles_abs(_s247);
    const S _s267 = singles_add(singles_mul(_s266, _s128), singles_mul(singles_abs(_s251), _s158));
    const S _s268 = singles_add(_s182, singles_add(_s236, singles_mul(singles_abs(_s249), _s158)));
    const S _s269 = singles_add(singles_mul(place_n, singles_abs(singles_neg(singles_add(singles_mul(_s248, _s131), singles_mul(_s252, _s159))))), singles_mul(turn_z, singles_abs(singles_neg(singles_mul(_c6, _s13)))));
    const S _s270 = singles_add(singles_add(_s269, singles_mul(turn_z, singles_abs(singles_neg(singles_mul(_c6, _s73))))), singles_mul(singles_abs(_s246), _s241));
    const S _s271 = singles_add(singles_add(singles_add(singles_add(_s270, singles_mul(singles_abs(_s253), _s132)), singles_mul(singles_abs(_s254), _s133)), singles_mul(singles_abs(_s255), _s134)), singles_mul(singles_abs(_s256), _s135));
    const S _s272 = singles_mul(KS(1.0009765625), singles_add(singles_add(singles_add(singles_mul(_c6, _s267), singles_mul(KS(0.6), _s268)), _s239), singles_add(_s271, singles_mul(singles_abs(_s257), _s137))));
    const S _s273 = singles_mul(KS(1.0009765625), singles_add(_s265, _s272));
    const S _s274 = singles_neg(singles_mul(bend_s, _s206));
    const S _s275 = singles_mul(_s166, _s250);
    const S _s276 = singles_neg(singles_add(singles_mul(_s274, _s70), singles_mul(_s275, _s142)));
    const S _s277 = singles_sub(singles_sub(singles_neg(singles_mul(_c8, _s26)), singles_mul(_s274, _s65)), singles_mul(_s275, _s140));
    const S _s278 = singles_sub(singles_sub(singles_mul(_c8, _s30), singles_mul(_s274, _s74)), singles_mul(_s275, _s144));
    const S _s279 = singles_sub(singles_sub(singles_mul(_s28, _s250), singles_mul(_s274, _s79)), singles_mul(_s275, _s146));
    const S _s280 = singles_sub(singles_sub(singles_sub(singles_mul(_s14, _s250), singles_mul(_s17, _s206)), singles_mul(_s274, _s85)), singles_mul(_s275, _s148));
    const S _s281 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s276, _s71), singles_mul(_s9, _s204)), singles_mul(_s277, _s67)), singles_mul(_s278, _s75)), singles_mul(_s279, _s80)), singles_mul(_s280, _s86));
    const S _s282 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s276, _s90), singles_mul(_s9, _s224)), singles_mul(_s277, _s89)), singles_mul(_s278, _s91)), singles_mul(_s279, _s92)), singles_mul(_s280, _s93));
    const S _s283 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s276, _s97), singles_mul(_s9, _s226)), singles_mul(_s277, _s96)), singles_mul(_s278, _s98)), singles_mul(_s279, _s99)), singles_mul(_s280, _s100));
    const S _s284 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s276, _s104), singles_mul(_s9, _s228)), singles_mul(_s277, _s103)), singles_mul(_s278, _s105)), singles_mul(_s279, _s106)), singles_mul(_s280, _s107));
    const S _s285 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s276, _s111), singles_mul(_s9, _s230)), singles_mul(_s277, _s110)), singles_mul(_s278, _s112)), singles_mul(_s279, _s113)), singles_mul(_s280, _s114));
    const S _s286 = singles_add(singles_add(singles_add(singles_add(singles_mul(singles_abs(_s281), _s88), singles_mul(singles_abs(_s282), _s95)), singles_mul(singles_abs(_s283), _s102)), singles_mul(singles_abs(_s284), _s109)), singles_mul(singles_abs(_s285), _s116));
    const S _s287 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_mul(_s276, _s119), singles_mul(_s9, _s233)), singles_mul(_s277, _s118)), singles_mul(_s278, _s120)), singles_mul(_s279, _s121)), singles_mul(_s280, _s122));
    const S _s288 = singles_add(_s286, singles_mul(singles_abs(_s287), _s124));
    const S _s289 = singles_add(singles_mul(singles_abs(_s274), _s128), singles_mul(singles_abs(_s275), _s158));
    const S _s290 = singles_add(singles_mul(_c8, _s38), _s185);
    const S _s291 = singles_add(singles_add(singles_add(singles_mul(_c8, singles_add(_s190, _s196)), singles_mul(_s51, singles_add(singles_mul(KS(2.0), spin_bound), singles_mul(_c9, _s47)))), singles_mul(_s192, singles_add(spin_bound, _s185))), singles_mul(_s191, _s290));
    const S _s292 = singles_add(singles_add(_s291, singles_mul(_s193, singles_add(singles_mul(_c9, _s38), singles_mul(KS(2.0), _s185)))), singles_mul(KS(7.62939453125e-06), singles_add(singles_mul(_s51, _s185), _s195)));
    const S _s293 = singles_add(singles_add(singles_add(singles_add(singles_mul(_c8, _s189), singles_mul(KS(2.0), singles_mul(_s184, _s185))), singles_mul(KS(0.6), singles_mul(singles_mul(normal_rounding, _c8), _s38))), _s289), _s292);
    const S _s294 = singles_add(singles_mul(place_n, singles_abs(singles_neg(singles_add(singles_mul(_s274, _s131), singles_mul(_s275, _s159))))), singles_mul(turn_z, singles_abs(_s30)));
    const S _s295 = singles_add(singles_add(singles_add(singles_add(_s294, singles_mul(turn_z, singles_abs(_s26))), singles_mul(singles_abs(_s276), _s133)), singles_mul(singles_abs(_s9), _s241)), singles_mul(singles_abs(_s277), _s132));
    const S _s296 = singles_add(_s293, singles_add(singles_add(singles_add(_s295, singles_mul(singles_abs(_s278), _s134)), singles_mul(singles_abs(_s279), _s135)), singles_mul(singles_abs(_s280), _s137)));
    const S _s297 = singles_mul(KS(1.0009765625), _s296);
    const S _s298 = singles_mul(KS(1.0009765625), singles_add(_s288, _s297));
    const S _s299 = singles_add(singles_mul(_c8, singles_add(_s189, _s239)), singles_mul(KS(2.0), singles_mul(_s184, singles_add(singles_mul(_c9, singles_add(_s157, _s126)), _s185))));
    const S _s300 = singles_max(_s183, _s238);
    const S _s301 = singles_max(_s289, _s267);
    const S _s302 = singles_mul(KS(1.0009765625), singles_add(singles_add(_s299, singles_add(singles_mul(_c8, singles_max(_s300, _s268)), singles_max(_s301, _s237))), _s292));
    const S _s303 = singles_max(_s61, _s139);
    const S _s304 = singles_select(_s62, singles_mul(KS(1.0009765625), singles_add(singles_mul(KS(0.421875), singles_add(singles_add(_s162, _s139), _s61)), singles_mul(KS(0.578125), singles_max(_s303, _s162)))), KS(INFINITY));
    const S _s305 = singles_mul(_c4, _s139);
    const S _s306 = singles_add(singles_mul(_c6, _s250), singles_mul(KS(0.6), _s19));
    const S _s307 = singles_neg(singles_mul(_c1, normal_velocity));
    const S _s308 = singles_add(_s305, singles_mul(singles_abs(singles_mul(bend_e, singles_sub(singles_mul(nz, _s306), singles_mul(_s307, _s18)))), _s162));
    const S _s309 = singles_mul(KS(7.62939453125e-06), singles_add(singles_mul(bend_s, _s139), singles_mul(bend_e, _s162)));
    const S _s310 = singles_mul(_s188, _s309);
    const S _s311 = singles_add(singles_add(_s308, _s310), _s273);
    const S _s312 = singles_sub(singles_mul(KS(0.6), _s15), singles_mul(_c6, _s206));
    const S _s313 = singles_add(singles_add(singles_mul(singles_abs(singles_mul(bend_s, _s307)), _s139), singles_mul(singles_abs(singles_neg(singles_mul(_s210, _s312))), _s162)), _s310);
    const S _s314 = singles_add(_s313, _s245);
    const S _s315 = singles_add(singles_add(singles_mul(singles_abs(singles_neg(singles_mul(bend_s, _s306))), _s139), singles_mul(singles_abs(singles_mul(_s166, _s312)), _s162)), _s310);
    const S _s316 = singles_add(_s315, _s202);
    const S _s317 = singles_max(_s316, _s314);
    const S _s318 = singles_select(_s62, singles_mul(KS(1.0009765625), singles_add(singles_mul(KS(0.421875), singles_add(singles_add(_s311, _s314), _s316)), singles_mul(KS(0.578125), singles_max(_s317, _s311)))), KS(INFINITY));
    const S _s319 = singles_neg(singles_mul(_c8, _s312));
    const S _s320 = singles_mul(_c8, _s306);
    const S _s321 = singles_mul(_s290, _s309);
    const S _s322 = singles_add(singles_add(singles_mul(singles_abs(singles_neg(singles_mul(bend_s, _s319))), _s139), singles_mul(singles_abs(singles_mul(singles_mul(bend_e, _s320), _s18)), _s162)), _s321);
    const S _s323 = singles_add(_s322, _s298);
    const S _s324 = singles_add(singles_add(singles_div(_s245, _c0), _s305), singles_mul(singles_abs(singles_mul(bend_e, singles_sub(singles_mul(nz, _s319), _s208))), _s162));
    const S _s325 = singles_add(singles_add(_s324, _s321), _s302);
    const S _s326 = singles_add(singles_add(singles_add(singles_div(_s273, _c0), singles_mul(_s266, _s139)), singles_mul(singles_abs(singles_neg(singles_mul(_s210, _s320))), _s162)), _s321);
    const S _s327 = singles_add(_s326, _s302);
    const S _s328 = singles_max(_s323, _s327);
    const S _s329 = singles_select(_s62, singles_mul(KS(1.0009765625), singles_add(singles_mul(KS(0.421875), singles_add(singles_add(_s323, _s325), _s327)), singles_mul(KS(0.578125), singles_max(_s328, _s325)))), KS(INFINITY));
    const S _s330 = singles_mul(KS(0.25), singles_add(singles_add(singles_add(singles_add(singles_add(_s156, _s125), singles_mul(KS(0.125), _s181)), singles_mul(KS(0.125), _s235)), singles_mul(KS(0.125), _s265)), singles_mul(KS(0.015625), _s288)));
    const Q _s331 = singles_at_most(singles_add(singles_add(singles_add(singles_add(singles_add(_s161, _s138), singles_mul(KS(0.125), _s201)), singles_mul(KS(0.125), _s244)), singles_mul(KS(0.125), _s272)), singles_mul(KS(0.015625), _s297)), _s330);
    return (LANES(hoop_tighten_impact_out)){ singles_select(_s62, _s61, KS(INFINITY)), singles_select(_s62, _s139, KS(INFINITY)), singles_select(_s62, _s162, KS(INFINITY)), singles_select(_s62, _s202, KS(INFINITY)), singles_select(_s62, _s245, KS(INFINITY)), singles_select(_s62, _s273, KS(INFINITY)), singles_select(_s62, _s298, KS(INFINITY)), singles_select(_s62, _s302, KS(INFINITY)), _s304, _s318, _s329, nx, ny, nz, tangent_x, tangent_y, bend_s, bend_e, singles_add(singles_mul(KS(4.440892098500626e-16), singles_add(t, clock)), singles_select(_s62, singles_mul(KS(1.0009765625), _s44), KS(INFINITY))), _s88, _s95, _s102, _s109, _s116, _s124, _s138, _s161, _s201, _s244, _s272, _s297, _s87, _s94, _s101, _s108, _s115, _s123, _s149, _s150, _s151, _s152, _s153, _s155, _s174, _s175, _s176, _s177, _s178, _s180, _s223, _s225, _s227, _s229, _s231, _s234, _s258, _s259, _s260, _s261, _s262, _s264, _s281, _s282, _s283, _s284, _s285, _s287, singles_select(_s331, KS(1.0), KS(0.0)) };
}

/* Velocity and spin after a contact, frame-free.
   Eqs. 11-17, the frame eliminated. 61 operations: 10 additions, 12 subtractions, 39 multiplications. */
typedef struct {
    V vx, vy, vz, wx, wy, wz;
} LANES(hoop_impact_out);

LANES_INLINE LANES(hoop_impact_out)
LANES(hoop_impact)(V vx, V vy, V vz, V wx, V wy, V wz, V nx, V ny, V nz, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_add(lanes_add(lanes_mul(nx, vx), lanes_mul(ny, vy)), lanes_mul(nz, vz));
    const V _s1 = lanes_add(lanes_mul(_c1, lanes_sub(lanes_mul(nz, wy), lanes_mul(ny, wz))), lanes_mul(K(0.6), lanes_sub(vx, lanes_mul(nx, _s0))));
    const V _s2 = lanes_add(lanes_mul(_c1, lanes_sub(lanes_mul(nx, wz), lanes_mul(nz, wx))), lanes_mul(K(0.6), lanes_sub(vy, lanes_mul(ny, _s0))));
    const V _s3 = lanes_add(lanes_mul(_c1, lanes_sub(lanes_mul(ny, wx), lanes_mul(nx, wy))), lanes_mul(K(0.6), lanes_sub(vz, lanes_mul(nz, _s0))));
    const V _s4 = lanes_add(lanes_add(lanes_mul(nx, wx), lanes_mul(ny, wy)), lanes_mul(nz, wz));
    return (LANES(hoop_impact_out)){ lanes_sub(_s1, lanes_mul(lanes_mul(_c0, nx), _s0)), lanes_sub(_s2, lanes_mul(lanes_mul(_c0, ny), _s0)), lanes_sub(_s3, lanes_mul(lanes_mul(_c0, nz), _s0)), lanes_add(lanes_mul(nx, _s4), lanes_mul(_c2, lanes_sub(lanes_mul(ny, _s3), lanes_mul(nz, _s2)))), lanes_add(lanes_mul(ny, _s4), lanes_mul(_c2, lanes_sub(lanes_mul(nz, _s1), lanes_mul(nx, _s3)))), lanes_add(lanes_mul(nz, _s4), lanes_mul(_c2, lanes_sub(lanes_mul(nx, _s2), lanes_mul(ny, _s1)))) };
}

/* Bounds on errors after a contact, from those at the departure before it.
   derivative of the frame-free Eq. 17, with roundings. 952 operations: 254 additions, 68 subtractions, 453 multiplications, 6 divisions, 40 negations, 92 absolute values, 14 comparisons, 25 selections. */
typedef struct {
    S place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound, spin_bound, left_nx, left_ny, left_nz, left_ex, left_ey, left_bend_s, left_bend_e, delay;
} LANES(hoop_carry_impact_out);

LANES_INLINE LANES(hoop_carry_impact_out)
LANES(hoop_carry_impact)(S t, S x, S y, S z, S vx, S vy, S vz, S wx, S wy, S wz, S nx, S ny, S nz, S clock, S left_nx, S left_ny, S left_nz, S place_n, S place_s, S place_e, S pace_n, S pace_s, S pace_e, S turn_n, S turn_z, S position_bound, S velocity_bound, S spin_bound, S tangent_x, S tangent_y, S bend_s, S bend_e, S left_ex, S left_ey, S left_bend_s, S left_bend_e, S sharpest_bend, S root_offset, S root_level, S normal_rounding, S normal_velocity, S back, S _c0, S _c1, S _c2, S _c3, S _c4, S _c5, S _c6, S _c7, S _c8, S _c9)
{
    const S _s0 = singles_neg(singles_mul(_c2, nz));
    const S _s1 = singles_abs(vx);
    const S _s2 = singles_mul(KS(2.0), t);
    const S _s3 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s2, _s1), singles_abs(x))));
    const S _s4 = singles_abs(vy);
    const S _s5 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s2, _s4), singles_abs(y))));
    const S _s6 = singles_add(singles_add(singles_mul(_c3, singles_mul(t, t)), singles_mul(_s2, singles_abs(singles_add(vz, singles_mul(_c3, t))))), singles_abs(z));
    const S _s7 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), _s6));
    const S _s8 = singles_add(singles_add(singles_add(position_bound, singles_mul(t, velocity_bound)), singles_add(singles_add(_s3, _s5), _s7)), singles_max(root_offset, root_level));
    const S _s9 = singles_add(singles_add(singles_mul(nx, left_nx), singles_mul(ny, left_ny)), singles_mul(nz, left_nz));
    const S _s10 = singles_sub(_s9, back);
    const S _s11 = singles_mul(nz, tangent_y);
    const S _s12 = singles_neg(singles_mul(nz, tangent_x));
    const S _s13 = singles_add(singles_mul(left_ex, _s11), singles_mul(left_ey, _s12));
    const S _s14 = singles_mul(left_bend_s, _s13);
    const S _s15 = singles_add(singles_mul(vx, tangent_x), singles_mul(vy, tangent_y));
    const S _s16 = singles_add(singles_mul(tangent_x, left_ex), singles_mul(tangent_y, left_ey));
    const S _s17 = singles_mul(left_bend_s, _s16);
    const S _s18 = singles_sub(singles_mul(ny, tangent_x), singles_mul(nx, tangent_y));
    const S _s19 = singles_add(singles_add(singles_mul(vx, _s11), singles_mul(vy, _s12)), singles_mul(vz, _s18));
    const S _s20 = singles_neg(singles_mul(_c2, _s18));
    const S _s21 = singles_sub(_s19, singles_mul(t, _s20));
    const S _s22 = singles_sub(singles_mul(_s14, _s15), singles_mul(_s17, _s21));
    const S _s23 = singles_mul(left_nz, left_ey);
    const S _s24 = singles_neg(singles_mul(left_nz, left_ex));
    const S _s25 = singles_sub(singles_mul(left_ny, left_ex), singles_mul(left_nx, left_ey));
    const S _s26 = singles_add(singles_add(singles_mul(nx, _s23), singles_mul(ny, _s24)), singles_mul(nz, _s25));
    const S _s27 = singles_add(singles_mul(t, _s22), _s26);
    const S _s28 = singles_mul(left_bend_e, _s18);
    const S _s29 = singles_mul(_s28, _s15);
    const S _s30 = singles_add(singles_mul(nx, left_ex), singles_mul(ny, left_ey));
    const S _s31 = singles_add(singles_mul(t, _s29), _s30);
    const S _s32 = singles_mul(t, _s9);
    const S _s33 = singles_mul(t, _s26);
    const S _s34 = singles_add(singles_add(singles_add(singles_add(singles_mul(place_n, singles_abs(_s10)), singles_mul(place_s, singles_abs(_s27))), singles_mul(place_e, singles_abs(_s31))), singles_mul(pace_n, singles_abs(_s32))), singles_mul(pace_s, singles_abs(_s33)));
    const S _s35 = singles_mul(t, _s30);
    const S _s36 = singles_mul(_c2, t);
    const S _s37 = singles_abs(vz);
    const S _s38 = singles_add(singles_add(_s1, _s4), _s37);
    const S _s39 = singles_add(singles_mul(place_s, left_bend_s), singles_mul(place_e, left_bend_e));
    const S _s40 = singles_mul(singles_add(_s36, _s38), _s39);
    const S _s41 = singles_mul(KS(7.62939453125e-06), singles_add(singles_mul(t, _s40), _s8));
    const S _s42 = singles_add(singles_add(singles_add(root_offset, singles_mul(singles_mul(KS(1.02), singles_mul(sharpest_bend, _s8)), _s8)), singles_add(_s34, singles_mul(pace_e, singles_abs(_s35)))), _s41);
    const S _s43 = singles_abs(normal_velocity);
    const S _s44 = singles_div(singles_mul(KS(1.1), _s42), _s43);
    const S _s45 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_add(singles_add(_s36, _s1), _s4), _s37)));
    const S _s46 = singles_add(velocity_bound, _s45);
    const S _s47 = singles_add(singles_mul(_c2, _s44), _s46);
    const S _s48 = singles_add(_s47, _s38);
    const S _s49 = singles_add(singles_mul(_s44, _s48), _s8);
    const S _s50 = singles_mul(KS(1.02), sharpest_bend);
    const S _s51 = singles_mul(_s50, _s49);
    const S _s52 = singles_sub(singles_mul(KS(12.0), singles_add(singles_add(singles_mul(singles_abs(_s0), _s44), singles_mul(_s51, _s48)), _s46)), _s43);
    const S _s53 = singles_sub(singles_mul(KS(100.0), singles_mul(sharpest_bend, _s49)), KS(1.0));
    const S _s54 = singles_max(_s52, _s53);
    const S _s55 = singles_add(singles_mul(_c3, singles_mul(_s44, _s44)), singles_mul(_s44, _s46));
    const S _s56 = singles_div(singles_add(singles_mul(_s51, _s49), _s55), _s43);
    const S _s57 = singles_add(singles_mul(_s56, _s38), _s55);
    const S _s58 = singles_add(singles_add(root_level, _s57), singles_add(singles_add(singles_mul(singles_abs(nx), _s3), singles_mul(singles_abs(ny), _s5)), singles_mul(singles_abs(nz), _s7)));
    const S _s59 = singles_mul(bend_s, _s58);
    const S _s60 = singles_sub(singles_mul(KS(4194304.0), singles_add(singles_mul(place_n, left_bend_s), _s59)), KS(1.0));
    const S _s61 = singles_mul(KS(1.0009765625), _s58);
    const Q _s62 = singles_at_most(singles_max(_s54, _s60), KS(0.0));
    const S _s63 = singles_abs(_s19);
    const S _s64 = singles_div(singles_add(root_offset, _s41), _s43);
    const S _s65 = singles_add(singles_mul(_s63, _s64), singles_add(singles_add(singles_mul(singles_abs(_s12), _s5), singles_mul(singles_abs(_s11), _s3)), singles_mul(singles_abs(_s18), _s7)));
    const S _s66 = singles_add(singles_add(_s57, singles_mul(KS(7.62939453125e-06), _s49)), _s41);
    const S _s67 = singles_div(KS(1.0), normal_velocity);
    const S _s68 = singles_neg(singles_mul(_s67, _s10));
    const S _s69 = singles_add(singles_add(singles_mul(left_nx, _s11), singles_mul(left_ny, _s12)), singles_mul(left_nz, _s18));
    const S _s70 = singles_add(singles_mul(_s68, _s19), _s69);
    const S _s71 = singles_neg(singles_mul(_s67, _s27));
    const S _s72 = singles_sub(normal_velocity, singles_mul(t, _s0));
    const S _s73 = singles_mul(left_bend_s, _s30);
    const S _s74 = singles_sub(singles_mul(_s17, _s72), singles_mul(_s73, _s15));
    const S _s75 = singles_add(singles_add(singles_mul(_s12, _s24), singles_mul(_s11, _s23)), singles_mul(_s18, _s25));
    const S _s76 = singles_add(singles_mul(_s71, _s19), singles_add(singles_mul(t, _s74), _s75));
    const S _s77 = singles_neg(singles_mul(_s67, _s31));
    const S _s78 = singles_mul(nz, left_bend_e);
    const S _s79 = singles_neg(singles_mul(_s78, _s15));
    const S _s80 = singles_add(singles_mul(_s77, _s19), singles_add(singles_mul(t, _s79), _s13));
    const S _s81 = singles_neg(singles_mul(_s67, _s32));
    const S _s82 = singles_add(singles_mul(_s81, _s19), singles_mul(t, _s69));
    const S _s83 = singles_neg(singles_mul(_s67, _s33));
    const S _s84 = singles_add(singles_mul(_s83, _s19), singles_mul(t, _s75));
    const S _s85 = singles_add(singles_add(singles_add(singles_add(singles_mul(place_n, singles_abs(_s70)), singles_mul(place_s, singles_abs(_s76))), singles_mul(place_e, singles_abs(_s80))), singles_mul(pace_n, singles_abs(_s82))), singles_mul(pace_s, singles_abs(_s84)));
    const S _s86 = singles_neg(singles_mul(_s67, _s35));
    const S _s87 = singles_add(singles_mul(_s86, _s19), singles_mul(t, _s13));
    const S _s88 = singles_mul(KS(1.0009765625), singles_add(singles_add(_s65, _s66), singles_add(_s85, singles_mul(pace_e, singles_abs(_s87)))));
    const S _s89 = singles_abs(_s15);
    const S _s90 = singles_add(singles_mul(_s89, _s64), singles_add(singles_add(singles_mul(_c4, _s7), singles_mul(singles_abs(tangent_x), _s3)), singles_mul(singles_abs(tangent_y), _s5)));
    const S _s91 = singles_add(singles_mul(left_nx, tangent_x), singles_mul(left_ny, tangent_y));
    const S _s92 = singles_add(singles_mul(_s68, _s15), _s91);
    const S _s93 = singles_sub(singles_mul(_s73, _s21), singles_mul(_s14, _s72));
    const S _s94 = singles_add(singles_mul(tangent_x, _s23), singles_mul(tangent_y, _s24));
    const S _s95 = singles_add(singles_mul(_s71, _s15), singles_add(singles_mul(t, _s93), _s94));
    const S _s96 = singles_sub(singles_mul(_s78, _s21), singles_mul(_s28, _s72));
    const S _s97 = singles_add(singles_mul(_s77, _s15), singles_add(singles_mul(t, _s96), _s16));
    const S _s98 = singles_add(singles_mul(_s81, _s15), singles_mul(t, _s91));
    const S _s99 = singles_add(singles_mul(_s83, _s15), singles_mul(t, _s94));
    const S _s100 = singles_add(singles_add(singles_add(singles_add(singles_mul(place_n, singles_abs(_s92)), singles_mul(place_s, singles_abs(_s95))), singles_mul(place_e, singles_abs(_s97))), singles_mul(pace_n, singles_abs(_s98))), singles_mul(pace_s, singles_abs(_s99)));
    const S _s101 = singles_add(singles_mul(_s86, _s15), singles_mul(t, _s16));
    const S _s102 = singles_mul(KS(1.0009765625), singles_add(singles_add(_s90, _s66), singles_add(_s100, singles_mul(pace_e, singles_abs(_s101)))));
    const S _s103 = singles_add(singles_mul(_c2, _s64), _s45);
    const S _s104 = singles_neg(singles_mul(bend_s, _s19));
    const S _s105 = singles_mul(bend_e, _s18);
    const S _s106 = singles_mul(_s105, _s15);
    const S _s107 = singles_add(_s103, singles_add(singles_mul(singles_abs(_s104), _s65), singles_mul(singles_abs(_s106), _s90)));
    const S _s108 = singles_add(normal_rounding, _s59);
    const S _s109 = singles_add(singles_add(singles_abs(wx), singles_abs(wy)), singles_abs(wz));
    const S _s110 = singles_mul(singles_mul(_c6, _s108), _s109);
    const S _s111 = singles_mul(_c0, _s109);
    const S _s112 = singles_add(_s111, _s38);
    const S _s113 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.5543122344752192e-15), _s112));
    const S _s114 = singles_mul(_c2, _s56);
    const S _s115 = singles_mul(singles_add(bend_s, bend_e), _s66);
    const S _s116 = singles_mul(_s51, _s51);
    const S _s117 = singles_add(singles_mul(_s50, _s57), singles_mul(KS(2.0), _s116));
    const S _s118 = singles_add(singles_add(singles_add(_s114, singles_mul(_s51, singles_add(singles_mul(spin_bound, _c6), singles_mul(_c7, _s47)))), singles_mul(_s115, _s112)), singles_mul(_s117, singles_add(singles_mul(_c6, _s109), singles_mul(_c7, _s38))));
    const S _s119 = singles_add(spin_bound, singles_mul(_s39, _s109));
    const S _s120 = singles_mul(KS(7.62939453125e-06), singles_add(singles_add(singles_mul(_c0, _s119), singles_mul(_s51, singles_add(_s111, singles_mul(KS(4.0), _s38)))), singles_mul(KS(2.0), singles_add(_s40, _s47))));
    const S _s121 = singles_add(singles_add(_s118, singles_mul(singles_mul(_s116, _c5), _s48)), _s120);
    const S _s122 = singles_add(singles_add(singles_mul(_c1, _s107), singles_mul(_c5, singles_add(singles_mul(normal_rounding, singles_add(_s38, _s43)), singles_mul(singles_mul(KS(2.0), _s59), _s43)))), singles_add(singles_add(_s110, _s113), _s121));
    const S _s123 = singles_neg(singles_mul(_c1, _s0));
    const S _s124 = singles_neg(singles_mul(_c1, _s104));
    const S _s125 = singles_neg(singles_mul(_c1, _s106));
    const S _s126 = singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s123, _s71), singles_neg(singles_mul(_c1, _s22))), singles_mul(_s124, _s76)), singles_mul(_s125, _s95)));
    const S _s127 = singles_add(singles_mul(place_n, singles_abs(singles_sub(singles_sub(singles_mul(_s123, _s68), singles_mul(_s124, _s70)), singles_mul(_s125, _s92)))), singles_mul(place_s, _s126));
    const S _s128 = singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s123, _s77), singles_neg(singles_mul(_c1, _s29))), singles_mul(_s124, _s80)), singles_mul(_s125, _s97)));
    const S _s129 = singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s123, _s81), singles_neg(singles_mul(_c1, _s9))), singles_mul(_s124, _s82)), singles_mul(_s125, _s98)));
    const S _s130 = singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s123, _s83), singles_neg(singles_mul(_c1, _s26))), singles_mul(_s124, _s84)), singles_mul(_s125, _s99)));
    const S _s131 = singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s123, _s86), singles_neg(singles_mul(_c1, _s30))), singles_mul(_s124, _s87)), singles_mul(_s125, _s101)));
    const S _s132 = singles_add(_s122, singles_add(singles_add(singles_add(singles_add(_s127, singles_mul(place_e, _s128)), singles_mul(pace_n, _s129)), singles_mul(pace_s, _s130)), singles_mul(pace_e, _s131)));
    const S _s133 = singles_mul(KS(1.0009765625), _s132);
    const S _s134 = singles_mul(_c4, _s65);
    const S _s135 = singles_add(singles_add(singles_mul(wx, _s11), singles_mul(wy, _s12)), singles_mul(wz, _s18));
    const S _s136 = singles_add(singles_add(singles_mul(nx, wx), singles_mul(ny, wy)), singles_mul(nz, wz));
    const S _s137 = singles_mul(_s18, _s136);
    const S _s138 = singles_mul(bend_e, singles_sub(singles_mul(nz, _s135), _s137));
    const S _s139 = singles_add(_s134, singles_mul(singles_abs(_s138), _s90));
    const S _s140 = singles_mul(bend_s, normal_velocity);
    const S _s141 = singles_mul(nz, bend_e);
    const S _s142 = singles_neg(singles_mul(_s141, _s15));
    const S _s143 = singles_add(_s103, singles_add(singles_mul(singles_abs(_s140), _s65), singles_mul(singles_abs(_s142), _s90)));
    const S _s144 = singles_add(singles_add(singles_add(singles_mul(singles_mul(normal_rounding, _c5), _s43), _s110), _s113), _s121);
    const S _s145 = singles_mul(KS(0.6), _s20);
    const S _s146 = singles_add(singles_mul(_c6, _s138), singles_mul(KS(0.6), _s142));
    const S _s147 = singles_mul(KS(0.6), _s140);
    const S _s148 = singles_sub(singles_add(singles_mul(_s71, _s145), singles_add(singles_mul(_c6, singles_sub(singles_mul(_s73, _s135), singles_mul(_s14, _s136))), singles_mul(KS(0.6), _s74))), singles_mul(_s146, _s95));
    const S _s149 = singles_add(singles_mul(place_n, singles_abs(singles_sub(singles_sub(singles_mul(_s68, _s145), singles_mul(_s146, _s92)), singles_mul(_s70, _s147)))), singles_mul(place_s, singles_abs(singles_sub(_s148, singles_mul(_s76, _s147)))));
    const S _s150 = singles_sub(singles_add(singles_mul(_s77, _s145), singles_add(singles_mul(_c6, singles_sub(singles_mul(_s78, _s135), singles_mul(_s28, _s136))), singles_mul(KS(0.6), _s79))), singles_mul(_s146, _s97));
    const S _s151 = singles_mul(pace_n, singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s81, _s145), singles_mul(KS(0.6), _s69)), singles_mul(_s146, _s98)), singles_mul(_s82, _s147))));
    const S _s152 = singles_add(singles_add(_s149, singles_mul(place_e, singles_abs(singles_sub(_s150, singles_mul(_s80, _s147))))), _s151);
    const S _s153 = singles_sub(singles_sub(singles_add(singles_mul(_s83, _s145), singles_add(singles_mul(_c6, singles_mul(_c8, _s16)), singles_mul(KS(0.6), _s75))), singles_mul(_s146, _s99)), singles_mul(_s84, _s147));
    const S _s154 = singles_sub(singles_add(singles_mul(_s86, _s145), singles_add(singles_mul(_c6, singles_neg(singles_mul(_c8, _s94))), singles_mul(KS(0.6), _s13))), singles_mul(_s146, _s101));
    const S _s155 = singles_add(singles_add(singles_add(_s152, singles_mul(pace_s, singles_abs(_s153))), singles_mul(pace_e, singles_abs(singles_sub(_s154, singles_mul(_s87, _s147))))), singles_mul(turn_n, singles_abs(singles_mul(_c6, _s91))));
    const S _s156 = singles_add(singles_add(singles_add(singles_mul(_c6, _s139), singles_mul(KS(0.6), _s143)), _s144), singles_add(singles_add(_s155, singles_mul(turn_z, singles_abs(singles_mul(_c6, _s16)))), singles_mul(turn_z, singles_abs(singles_mul(_c6, _s94)))));
    const S _s157 = singles_mul(KS(1.0009765625), _s156);
    const S _s158 = singles_mul(bend_s, _s136);
    const S _s159 = singles_abs(_s158);
    const S _s160 = singles_add(singles_mul(wx, tangent_x), singles_mul(wy, tangent_y));
    const S _s161 = singles_neg(singles_mul(_s141, _s160));
    const S _s162 = singles_add(singles_mul(_s159, _s65), singles_mul(singles_abs(_s161), _s90));
    const S _s163 = singles_mul(bend_e, singles_sub(singles_mul(nz, _s19), singles_mul(normal_velocity, _s18)));
    const S _s164 = singles_add(_s103, singles_add(_s134, singles_mul(singles_abs(_s163), _s90)));
    const S _s165 = singles_neg(singles_mul(_c6, _s158));
    const S _s166 = singles_sub(singles_mul(KS(0.6), _s163), singles_mul(_c6, _s161));
    const S _s167 = singles_sub(singles_sub(singles_sub(singles_mul(KS(0.6), _s93), singles_mul(_c6, singles_sub(singles_mul(_s17, _s136), singles_mul(_s73, _s160)))), singles_mul(_s165, _s76)), singles_mul(_s166, _s95));
    const S _s168 = singles_add(singles_mul(place_n, singles_abs(singles_neg(singles_add(singles_mul(_s165, _s70), singles_mul(_s166, _s92))))), singles_mul(place_s, singles_abs(_s167)));
    const S _s169 = singles_sub(singles_sub(singles_sub(singles_mul(KS(0.6), _s96), singles_mul(_c6, singles_neg(singles_mul(_s78, _s160)))), singles_mul(_s165, _s80)), singles_mul(_s166, _s97));
    const S _s170 = singles_add(singles_add(_s168, singles_mul(place_e, singles_abs(_s169))), singles_mul(pace_n, singles_abs(singles_sub(singles_sub(singles_mul(KS(0.6), _s91), singles_mul(_s165, _s82)), singles_mul(_s166, _s98)))));
    const S _s171 = singles_abs(singles_sub(singles_sub(singles_sub(singles_mul(KS(0.6), _s94), singles_mul(_c6, singles_mul(_c8, _s13))), singles_mul(_s165, _s84)), singles_mul(_s166, _s99)));
    const S _s172 = singles_sub(singles_sub(singles_sub(singles_mul(KS(0.6), _s16), singles_mul(_c6, singles_neg(singles_mul(_c8, _s75)))), singles_mul(_s165, _s87)), singles_mul(_s166, _s101));
    const S _s173 = singles_add(singles_add(singles_add(singles_add(_s170, singles_mul(pace_s, _s171)), singles_mul(pace_e, singles_abs(_s172))), singles_mul(turn_n, singles_abs(singles_neg(singles_mul(_c6, _s69))))), singles_mul(turn_z, singles_abs(singles_neg(singles_mul(_c6, _s13)))));
    const S _s174 = singles_add(singles_add(singles_add(singles_mul(_c6, _s162), singles_mul(KS(0.6), _s164)), _s144), singles_add(_s173, singles_mul(turn_z, singles_abs(singles_neg(singles_mul(_c6, _s75))))));
    const S _s175 = singles_mul(KS(1.0009765625), _s174);
    const S _s176 = singles_neg(singles_mul(bend_s, _s135));
    const S _s177 = singles_mul(_s105, _s160);
    const S _s178 = singles_add(singles_mul(singles_abs(_s176), _s65), singles_mul(singles_abs(_s177), _s90));
    const S _s179 = singles_add(singles_mul(_c8, _s38), _s109);
    const S _s180 = singles_add(singles_add(singles_add(singles_mul(_c8, singles_add(_s114, _s120)), singles_mul(_s51, singles_add(singles_mul(KS(2.0), spin_bound), singles_mul(_c9, _s47)))), singles_mul(_s116, singles_add(spin_bound, _s109))), singles_mul(_s115, _s179));
    const S _s181 = singles_add(singles_add(_s180, singles_mul(_s117, singles_add(singles_mul(_c9, _s38), singles_mul(KS(2.0), _s109)))), singles_mul(KS(7.62939453125e-06), singles_add(singles_mul(_s51, _s109), _s119)));
    const S _s182 = singles_add(singles_add(singles_add(singles_add(singles_mul(_c8, _s113), singles_mul(KS(2.0), singles_mul(_s108, _s109))), singles_mul(KS(0.6), singles_mul(singles_mul(normal_rounding, _c8), _s38))), _s178), _s181);
    const S _s183 = singles_mul(place_s, singles_abs(singles_sub(singles_sub(singles_sub(singles_mul(_s14, _s160), singles_mul(_s17, _s135)), singles_mul(_s176, _s76)), singles_mul(_s177, _s95))));
    const S _s184 = singles_add(singles_mul(place_n, singles_abs(singles_neg(singles_add(singles_mul(_s176, _s70), singles_mul(_s177, _s92))))), _s183);
    const S _s185 = singles_add(_s184, singles_mul(place_e, singles_abs(singles_sub(singles_sub(singles_mul(_s28, _s160), singles_mul(_s176, _s80)), singles_mul(_s177, _s97)))));
    const S _s186 = singles_add(_s185, singles_mul(pace_n, singles_abs(singles_neg(singles_add(singles_mul(_s176, _s82), singles_mul(_s177, _s98))))));
    const S _s187 = singles_add(_s186, singles_mul(pace_s, singles_abs(singles_sub(singles_sub(singles_mul(_c8, _s30), singles_mul(_s176, _s84)), singles_mul(_s177, _s99)))));
    const S _s188 = singles_mul(pace_e, singles_abs(singles_sub(singles_sub(singles_neg(singles_mul(_c8, _s26)), singles_mul(_s176, _s87)), singles_mul(_s177, _s101))));
    const S _s189 = singles_add(_s182, singles_add(singles_add(singles_add(singles_add(_s187, _s188), singles_mul(turn_n, singles_abs(_s9))), singles_mul(turn_z, singles_abs(_s30))), singles_mul(turn_z, singles_abs(_s26))));
    const S _s190 = singles_mul(KS(1.0009765625), _s189);
    const S _s191 = singles_add(singles_mul(_c8, singles_add(_s113, _s144)), singles_mul(KS(2.0), singles_mul(_s108, singles_add(singles_mul(_c9, singles_add(_s89, _s63)), _s109))));
    const S _s192 = singles_max(_s107, _s143);
    const S _s193 = singles_max(_s178, _s162);
    const S _s194 = singles_mul(KS(1.0009765625), singles_add(singles_add(_s191, singles_add(singles_mul(_c8, singles_max(_s192, _s164)), singles_max(_s193, _s139))), _s181));
    const S _s195 = singles_max(_s61, _s88);
    const S _s196 = singles_select(_s62, singles_mul(KS(1.0009765625), singles_add(singles_mul(KS(0.421875), singles_add(singles_add(_s61, _s102), _s88)), singles_mul(KS(0.578125), singles_max(_s195, _s102)))), KS(INFINITY));
    const S _s197 = singles_mul(_c4, _s88);
    const S _s198 = singles_add(singles_mul(_c6, _s160), singles_mul(KS(0.6), _s19));
    const S _s199 = singles_neg(singles_mul(_c1, normal_velocity));
    const S _s200 = singles_add(_s197, singles_mul(singles_abs(singles_mul(bend_e, singles_sub(singles_mul(nz, _s198), singles_mul(_s199, _s18)))), _s102));
    const S _s201 = singles_mul(KS(7.62939453125e-06), singles_add(singles_mul(bend_s, _s88), singles_mul(bend_e, _s102)));
    const S _s202 = singles_mul(_s112, _s201);
    const S _s203 = singles_add(singles_add(_s200, _s202), _s175);
    const S _s204 = singles_sub(singles_mul(KS(0.6), _s15), singles_mul(_c6, _s135));
    const S _s205 = singles_add(singles_add(singles_mul(singles_abs(singles_mul(bend_s, _s199)), _s88), singles_mul(singles_abs(singles_neg(singles_mul(_s141, _s204))), _s102)), _s202);
    const S _s206 = singles_add(_s205, _s157);
    const S _s207 = singles_add(singles_add(singles_mul(singles_abs(singles_neg(singles_mul(bend_s, _s198))), _s88), singles_mul(singles_abs(singles_mul(_s105, _s204)), _s102)), _s202);
    const S _s208 = singles_add(_s207, _s133);
    const S _s209 = singles_max(_s208, _s206);
    const S _s210 = singles_select(_s62, singles_mul(KS(1.0009765625), singles_add(singles_mul(KS(0.421875), singles_add(singles_add(_s203, _s206), _s208)), singles_mul(KS(0.578125), singles_max(_s209, _s203)))), KS(INFINITY));
    const S _s211 = singles_neg(singles_mul(_c8, _s204));
    const S _s212 = singles_mul(_c8, _s198);
    const S _s213 = singles_mul(_s179, _s201);
    const S _s214 = singles_add(singles_add(singles_mul(singles_abs(singles_neg(singles_mul(bend_s, _s211))), _s88), singles_mul(singles_abs(singles_mul(singles_mul(bend_e, _s212), _s18)), _s102)), _s213);
    const S _s215 = singles_add(_s214, _s190);
    const S _s216 = singles_add(singles_add(singles_div(_s157, _c0), _s197), singles_mul(singles_abs(singles_mul(bend_e, singles_sub(singles_mul(nz, _s211), _s137))), _s102));
    const S _s217 = singles_add(singles_add(_s216, _s213), _s194);
    const S _s218 = singles_add(singles_add(singles_add(singles_div(_s175, _c0), singles_mul(_s159, _s88)), singles_mul(singles_abs(singles_neg(singles_mul(_s141, _s212))), _s102)), _s213);
    const S _s219 = singles_add(_s218, _s194);
    const S _s220 = singles_max(_s215, _s219);
    const S _s221 = singles_select(_s62, singles_mul(KS(1.0009765625), singles_add(singles_mul(KS(0.421875), singles_add(singles_add(_s215, _s217), _s219)), singles_mul(KS(0.578125), singles_max(_s220, _s217)))), KS(INFINITY));
    return (LANES(hoop_carry_impact_out)){ singles_select(_s62, _s61, KS(INFINITY)), singles_select(_s62, _s88, KS(INFINITY)), singles_select(_s62, _s102, KS(INFINITY)), singles_select(_s62, _s133, KS(INFINITY)), singles_select(_s62, _s157, KS(INFINITY)), singles_select(_s62, _s175, KS(INFINITY)), singles_select(_s62, _s190, KS(INFINITY)), singles_select(_s62, _s194, KS(INFINITY)), _s196, _s210, _s221, nx, ny, nz, tangent_x, tangent_y, bend_s, bend_e, singles_add(singles_mul(KS(4.440892098500626e-16), singles_add(t, clock)), singles_select(_s62, singles_mul(KS(1.0009765625), _s44), KS(INFINITY))) };
}

/* Outward unit normal n3 at a contact.
   Table 2. 11 operations: 1 addition, 1 subtraction, 7 multiplications, 1 division, 1 square root. */
typedef struct {
    V nx, ny, nz;
} LANES(hoop_ring_normal_out);

LANES_INLINE LANES(hoop_ring_normal_out)
LANES(hoop_ring_normal)(V x, V y, V z, V _c0, V _c1)
{
    const V _s0 = lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y)));
    const V _s1 = lanes_mul(lanes_mul(_c1, lanes_sub(_s0, _c0)), lanes_div(K(1.0), _s0));
    return (LANES(hoop_ring_normal_out)){ lanes_mul(x, _s1), lanes_mul(y, _s1), lanes_mul(z, _c1) };
}

/* Tangent and curvatures at a contact, and bounds on the roundings there.
   Table 2, running error analysis. 105 operations: 34 additions, 38 multiplications, 4 divisions, 1 square root, 1 negation, 11 absolute values, 7 comparisons, 9 selections. */
typedef struct {
    S tangent_x, tangent_y, bend_s, bend_e, sharpest_bend, root_offset, root_level, normal_rounding;
} LANES(hoop_ring_tangents_out);

LANES_INLINE LANES(hoop_ring_tangents_out)
LANES(hoop_ring_tangents)(S t, S x, S y, S z, S vx, S vy, S vz, S nx, S ny, S nz, S place_n, S normal_velocity, S back, S _c0, S _c1, S _c2, S _c3, S _c4, S _c5, S _c6, S _c7, S _c8, S _c9)
{
    const S _s0 = singles_sqrt(singles_add(singles_mul(x, x), singles_mul(y, y)));
    const S _s1 = singles_div(KS(1.0), _s0);
    const S _s2 = singles_mul(_c0, t);
    const S _s3 = singles_add(vz, _s2);
    const S _s4 = singles_abs(vx);
    const S _s5 = singles_abs(vy);
    const S _s6 = singles_abs(vz);
    const S _s7 = singles_div(singles_mul(t, singles_add(singles_mul(KS(2.0), singles_add(_c5, singles_max(KS(0.0), _s3))), singles_add(singles_add(singles_add(_s2, _s4), _s5), _s6))), _c3);
    const S _s8 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_mul(t, singles_abs(normal_velocity))));
    const S _s9 = singles_mul(t, t);
    const S _s10 = singles_add(singles_mul(_c0, _s9), singles_mul(t, singles_add(singles_add(_s4, _s5), _s6)));
    const S _s11 = singles_mul(KS(2.0), t);
    const S _s12 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s11, _s4), singles_abs(x))));
    const S _s13 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s11, _s5), singles_abs(y))));
    const S _s14 = singles_add(singles_add(singles_mul(_c6, _s9), singles_mul(_s11, singles_abs(singles_add(vz, singles_mul(_c6, t))))), singles_abs(z));
    const S _s15 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), _s14));
    const S _s16 = singles_add(singles_div(singles_mul(singles_mul(KS(1.5), _s10), singles_add(singles_add(_s12, _s13), _s15)), _c3), singles_mul(_c7, _s10));
    const S _s17 = singles_mul(KS(1.125), _s16);
    const S _s18 = singles_mul(KS(1.7763568394002505e-15), singles_mul(singles_div(singles_mul(normal_velocity, normal_velocity), singles_add(singles_add(singles_mul(vx, vx), singles_mul(vy, vy)), singles_mul(vz, vz))), _c1));
    const S _s19 = singles_add(singles_add(_s8, _s16), singles_max(_s17, _s18));
    const S _s20 = singles_add(singles_mul(KS(1.1102230246251565e-16), singles_add(_c8, singles_mul(KS(2.0), _s0))), singles_add(singles_add(singles_mul(singles_abs(nx), _s12), singles_mul(singles_abs(ny), _s13)), singles_mul(singles_abs(nz), _s15)));
    const S _s21 = singles_mul(KS(1.125), _s20);
    const S _s22 = singles_add(singles_add(_s8, _s20), singles_max(_s21, _s18));
    const S _s23 = singles_add(place_n, _s22);
    const Q _s24 = singles_at_most(singles_mul(KS(4.0), _s7), KS(1.0));
    const Q _s25 = singles_less(KS(0.0), back);
    const S _s26 = singles_add(place_n, _s19);
    return (LANES(hoop_ring_tangents_out)){ singles_neg(singles_mul(y, _s1)), singles_mul(x, _s1), _c2, _s1, _c4, singles_select(_s25, singles_select(_s24, _s19, singles_max(_s19, _s23)), _s22), singles_select(_s25, singles_select(_s24, _s26, singles_max(_s26, _s22)), _s22), _c9 };
}

/* Positive if errors of the state exceed those that a search allows for.
   running error analysis. 17 operations: 5 additions, 2 subtractions, 8 multiplications, 1 comparison, 1 selection. */
typedef struct {
    V excess;
} LANES(hoop_ring_excess_out);

LANES_INLINE LANES(hoop_ring_excess_out)
LANES(hoop_ring_excess)(V share, V horizon, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_add(speed, lanes_mul(_c0, horizon));
    const V _s1 = lanes_mul(horizon, _s0);
    const V _s2 = lanes_sub(lanes_add(position_error, lanes_mul(horizon, velocity_error)), lanes_mul(share, lanes_add(_s1, lanes_add(extent, _s1))));
    const V _s3 = lanes_add(lanes_mul(lanes_mul(_s0, _c2), _s2), lanes_mul(_c1, lanes_sub(velocity_error, lanes_mul(share, _s0))));
    return (LANES(hoop_ring_excess_out)){ lanes_max(_s2, _s3) };
}

/* Positive if there is certainly no contact before the horizon.
   bounds of the event condition. 119 operations: 24 additions, 16 subtractions, 49 multiplications, 2 square roots, 14 comparisons, 14 selections. */
typedef struct {
    V clear;
} LANES(hoop_ring_clear_out);

LANES_INLINE LANES(hoop_ring_clear_out)
LANES(hoop_ring_clear)(V horizon, V x, V y, V z, V vx, V vy, V vz, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7, V _c8, V _c9, V _c10, V _c11, V _c12, V _c13, V _c14, V _c15, V _c16, V _c17, V _c18, V _c19)
{
    const V _s0 = lanes_add(position_error, lanes_mul(horizon, velocity_error));
    const V _s1 = lanes_sub(lanes_sub(_s0, _c3), _c4);
    const V _s2 = lanes_mul(vz, vz);
    const V _s3 = lanes_add(_s2, lanes_mul(_c8, lanes_sub(z, _c5)));
    const V _s4 = lanes_sqrt(_s3);
    const V _s5 = lanes_mul(_c9, lanes_sub(vz, _s4));
    const V _s6 = lanes_mul(_c9, lanes_add(vz, _s4));
    const V _s7 = lanes_add(x, lanes_mul(vx, _s6));
    const V _s8 = lanes_add(y, lanes_mul(vy, _s6));
    const V _s9 = lanes_add(lanes_mul(_s7, _s7), lanes_mul(_s8, _s8));
    const V _s10 = lanes_sqrt(_s9);
    const V _s11 = lanes_sub(_s10, _c0);
    const V _s12 = lanes_add(z, lanes_mul(lanes_sub(vz, lanes_mul(_c10, _s6)), _s6));
    const V _s13 = lanes_sub(lanes_sub(lanes_add(lanes_mul(_s11, _s11), lanes_mul(_s12, _s12)), _c11), _c13);
    const V _s14 = lanes_add(lanes_mul(vx, vx), lanes_mul(vy, vy));
    const V _s15 = lanes_sub(lanes_mul(x, vy), lanes_mul(y, vx));
    const V _s16 = lanes_mul(_s15, _s15);
    const V _s17 = lanes_sub(lanes_mul(lanes_sub(lanes_add(lanes_add(lanes_mul(K(2.0), _s2), lanes_mul(_c14, z)), lanes_mul(K(2.0), _s14)), _c15), _c17), lanes_mul(_c18, _s16));
    const V _s18 = lanes_add(lanes_mul(_s11, lanes_add(lanes_mul(vx, _s7), lanes_mul(vy, _s8))), lanes_mul(lanes_mul(_s12, lanes_sub(vz, lanes_mul(_c1, _s6))), _s10));
    const V _s19 = lanes_add(x, lanes_mul(vx, horizon));
    const V _s20 = lanes_add(y, lanes_mul(vy, horizon));
    const V _s21 = lanes_select(lanes_less(lanes_sub(lanes_add(lanes_add(_c13, lanes_mul(_s19, _s19)), lanes_mul(_s20, _s20)), _c16), K(0.0)), K(1.0), lanes_select(lanes_less(lanes_sub(lanes_mul(_s14, _c19), _s16), K(0.0)), K(1.0), K(0.0)));
    const V _s22 = lanes_select(lanes_less(lanes_sub(lanes_mul(lanes_mul(K(4.0), lanes_mul(_s18, _s18)), _c17), lanes_mul(lanes_mul(lanes_mul(K(2.0), _s17), _s9), _s13)), K(0.0)), _s21, K(0.0));
    const V _s23 = lanes_select(lanes_less(horizon, lanes_sub(_s6, lanes_mul(K(9.313225746154785e-10), horizon))), K(1.0), lanes_select(lanes_less(K(0.0), _s13), lanes_select(lanes_less(K(0.0), _s17), _s22, K(0.0)), K(0.0)));
    const V _s24 = lanes_add(lanes_mul(x, vx), lanes_mul(y, vy));
    const V _s25 = lanes_add(lanes_mul(_s5, _s14), _s24);
    const V _s26 = lanes_select(lanes_less(_s25, K(0.0)), lanes_select(lanes_less(_c12, lanes_add(lanes_mul(_s5, lanes_add(_s24, _s25)), lanes_add(lanes_mul(x, x), lanes_mul(y, y)))), _s23, K(0.0)), K(0.0));
    const V _s27 = lanes_select(lanes_less(lanes_add(extent, lanes_mul(horizon, lanes_add(speed, lanes_mul(_c1, horizon)))), _c7), lanes_select(lanes_less(K(0.0), _s3), lanes_select(lanes_less(_s5, K(0.0)), _s23, _s26), K(0.0)), K(0.0));
    return (LANES(hoop_ring_clear_out)){ lanes_select(lanes_less(K(0.0), lanes_max(_c2, _s1)), K(0.0), lanes_select(lanes_less(_s0, _c6), _s27, K(0.0))) };
}

/* Constants and windows of the search along a flight, and its error budget.
   bounds of the event condition. 163 operations: 28 additions, 17 subtractions, 38 multiplications, 1 division, 6 square roots, 1 negation, 5 absolute values, 30 comparisons, 37 selections. */
typedef struct {
    V energy2, moment2, rho_start, low0, high0, low1, high1, low2, high2, ceiling, latest, budget_exceeded;
} LANES(hoop_ring_prepare_out);

LANES_INLINE LANES(hoop_ring_prepare_out)
LANES(hoop_ring_prepare)(V horizon, V x, V y, V z, V vx, V vy, V vz, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7, V _c8, V _c9, V _c10, V _c11, V _c12, V _c13)
{
    const V _s0 = lanes_mul(vz, vz);
    const V _s1 = lanes_add(lanes_mul(vx, vx), lanes_mul(vy, vy));
    const V _s2 = lanes_add(lanes_add(lanes_mul(K(2.0), _s0), lanes_mul(_c0, z)), lanes_mul(K(2.0), _s1));
    const V _s3 = lanes_sub(lanes_mul(x, vy), lanes_mul(y, vx));
    const V _s4 = lanes_mul(_s3, _s3);
    const V _s5 = lanes_mul(_c1, _s4);
    const V _s6 = lanes_add(lanes_mul(x, x), lanes_mul(y, y));
    const V _s7 = lanes_mul(K(8.881784197001252e-16), lanes_add(_s0, lanes_mul(_c3, lanes_add(lanes_abs(z), _c2))));
    const V _s8 = lanes_add(lanes_add(_s0, lanes_mul(_c3, lanes_add(z, _c2))), _s7);
    const V _s9 = lanes_sqrt(_s8);
    const V _s10 = lanes_mul(K(1.7763568394002505e-15), lanes_add(lanes_abs(vz), _s9));
    const M _s11 = lanes_at_most(K(0.0), _s8);
    const V _s12 = lanes_select(_s11, lanes_mul(_c4, lanes_sub(lanes_sub(vz, _s9), _s10)), K(INFINITY));
    const V _s13 = lanes_mul(lanes_mul(K(1.7763568394002505e-15), _s1), lanes_add(_c5, _s6));
    const V _s14 = lanes_sub(lanes_add(lanes_mul(_c5, _s1), _s13), _s4);
    const V _s15 = lanes_add(lanes_mul(x, vx), lanes_mul(y, vy));
    const V _s16 = lanes_sqrt(_s14);
    const V _s17 = lanes_mul(K(1.7763568394002505e-15), lanes_add(lanes_add(lanes_abs(_s15), lanes_abs(_s3)), _s16));
    const V _s18 = lanes_div(K(1.0), _s1);
    const M _s19 = lanes_at_most(K(0.0), _s14);
    const M _s20 = lanes_less(K(2.409919865102884e-181), _s1);
    const V _s21 = lanes_select(_s20, lanes_select(_s19, lanes_mul(lanes_neg(lanes_add(lanes_add(_s15, _s16), _s17)), _s18), K(INFINITY)), K(-INFINITY));
    const V _s22 = lanes_max(_s12, _s21);
    const V _s23 = lanes_sub(lanes_sub(lanes_mul(_s1, _c6), _s13), _s4);
    const V _s24 = lanes_sqrt(lanes_max(_s23, K(0.0)));
    const V _s25 = lanes_select(_s20, lanes_select(_s19, lanes_mul(lanes_sub(lanes_add(_s16, _s17), _s15), _s18), K(-INFINITY)), K(INFINITY));
    const M _s26 = lanes_less(K(0.0), lanes_select(_s20, _s23, K(0.0)));
    const V _s27 = lanes_select(_s26, lanes_mul(lanes_sub(lanes_sub(_s17, _s15), _s24), _s18), _s25);
    const V _s28 = lanes_sub(lanes_add(_s0, lanes_mul(_c3, lanes_sub(z, _c2))), _s7);
    const V _s29 = lanes_sqrt(lanes_max(_s28, K(0.0)));
    const V _s30 = lanes_select(_s11, lanes_mul(_c4, lanes_add(lanes_add(vz, _s9), _s10)), K(-INFINITY));
    const M _s31 = lanes_less(K(0.0), _s28);
    const V _s32 = lanes_select(_s31, lanes_mul(_c4, lanes_sub(lanes_add(vz, _s10), _s29)), _s30);
    const V _s33 = lanes_min(_s27, _s32);
    const V _s34 = lanes_select(_s26, lanes_mul(lanes_sub(lanes_sub(_s24, _s15), _s17), _s18), K(INFINITY));
    const V _s35 = lanes_max(_s34, _s27);
    const V _s36 = lanes_max(_s12, _s35);
    const V _s37 = lanes_min(_s25, _s32);
    const V _s38 = lanes_select(_s31, lanes_mul(_c4, lanes_sub(lanes_add(vz, _s29), _s10)), K(INFINITY));
    const V _s39 = lanes_max(_s38, _s32);
    const M _s40 = lanes_at_most(_s36, _s37);
    const V _s41 = lanes_select(_s40, _s36, lanes_max(_s39, _s21));
    const V _s42 = lanes_select(_s40, _s37, lanes_min(_s27, _s30));
    const V _s43 = lanes_max(_s39, _s35);
    const V _s44 = lanes_min(_s25, _s30);
    const V _s45 = lanes_max(K(0.0), _s33);
    const V _s46 = lanes_max(_s45, _s42);
    const V _s47 = lanes_max(_s46, _s44);
    const V _s48 = lanes_add(lanes_mul(_c10, lanes_sqrt(lanes_mul(_c4, lanes_add(_c11, extent)))), lanes_mul(lanes_mul(K(2.0), speed), _c4));
    const V _s49 = lanes_sub(lanes_sub(lanes_add(position_error, lanes_mul(velocity_error, lanes_min(_s48, horizon))), _c12), _c13);
    return (LANES(hoop_ring_prepare_out)){ _s2, _s5, lanes_sqrt(_s6), lanes_max(K(0.0), _s22), lanes_min(_s33, horizon), lanes_max(K(0.0), _s41), lanes_min(_s42, horizon), lanes_max(K(0.0), _s43), lanes_min(_s44, horizon), lanes_add(lanes_add(_c7, lanes_mul(_s5, _c8)), lanes_abs(_s2)), lanes_min(_s47, horizon), lanes_max(_c9, _s49) };
}

/* Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.
   running error analysis. 34 operations: 12 additions, 22 multiplications. */
typedef struct {
    V margin, leaving_margin, rate_margin;
} LANES(hoop_ring_margins_out);

LANES_INLINE LANES(hoop_ring_margins_out)
LANES(hoop_ring_margins)(V horizon, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(speed, lanes_mul(_c0, horizon));
    const V _s1 = lanes_mul(_c1, _s0);
    const V _s2 = lanes_add(extent, lanes_mul(horizon, _s0));
    const V _s3 = lanes_add(lanes_add(position_error, lanes_mul(horizon, velocity_error)), lanes_mul(K(4.440892098500626e-16), _s2));
    const V _s4 = lanes_mul(K(5.0), lanes_add(lanes_mul(lanes_mul(_s0, _c5), _s3), lanes_mul(_c1, lanes_add(velocity_error, lanes_mul(K(2.220446049250313e-16), _s0)))));
    const V _s5 = lanes_mul(K(1.0009765625), lanes_add(lanes_add(lanes_mul(lanes_mul(K(3.552713678800501e-15), _s0), lanes_add(lanes_mul(_s2, _c5), _c2)), lanes_mul(K(4.440892098500626e-16), _s1)), _s4));
    return (LANES(hoop_ring_margins_out)){ lanes_mul(K(1.0009765625), lanes_add(lanes_add(lanes_mul(lanes_mul(K(4.440892098500626e-16), horizon), _s1), _c3), lanes_mul(_c4, _s3))), _s5, lanes_mul(K(1.0009765625), lanes_add(lanes_mul(K(3.552713678800501e-15), lanes_mul(_c2, _s0)), _s4)) };
}

/* Newton's next value of a root near t, and gap and rate there.
   Newton's method. 53 operations: 14 additions, 6 subtractions, 28 multiplications, 2 divisions, 1 square root, 1 comparison, 1 selection. */
typedef struct {
    V time, gap, rate;
} LANES(hoop_ring_refine_out);

LANES_INLINE LANES(hoop_ring_refine_out)
LANES(hoop_ring_refine)(V t, V leaving, V x, V y, V z, V vx, V vy, V vz, V rho_start, V _c0, V _c1, V _c2, V _c3)
{
    const V _s0 = lanes_add(x, lanes_mul(vx, t));
    const V _s1 = lanes_add(y, lanes_mul(vy, t));
    const V _s2 = lanes_sqrt(lanes_add(lanes_mul(_s0, _s0), lanes_mul(_s1, _s1)));
    const V _s3 = lanes_add(rho_start, _s2);
    const V _s4 = lanes_div(K(1.0), lanes_mul(_s3, _s2));
    const V _s5 = lanes_sub(_s2, _c0);
    const V _s6 = lanes_sub(vz, lanes_mul(_c2, t));
    const V _s7 = lanes_add(z, lanes_mul(t, _s6));
    const V _s8 = lanes_mul(K(2.0), lanes_add(lanes_mul(lanes_mul(lanes_mul(_s3, _s4), lanes_add(lanes_mul(vx, _s0), lanes_mul(vy, _s1))), _s5), lanes_mul(_s7, lanes_sub(vz, lanes_mul(_c1, t)))));
    const V _s9 = lanes_mul(lanes_mul(lanes_add(lanes_mul(t, lanes_add(lanes_mul(vx, vx), lanes_mul(vy, vy))), lanes_mul(K(2.0), lanes_add(lanes_mul(x, vx), lanes_mul(y, vy)))), lanes_add(lanes_sub(rho_start, _c0), _s5)), lanes_mul(_s2, _s4));
    const V _s10 = lanes_select(lanes_less(K(0.0), leaving), lanes_mul(t, lanes_add(_s9, lanes_mul(lanes_add(z, _s7), _s6))), lanes_sub(lanes_add(lanes_mul(_s5, _s5), lanes_mul(_s7, _s7)), _c3));
    return (LANES(hoop_ring_refine_out)){ lanes_sub(t, lanes_div(_s10, _s8)), _s10, _s8 };
}

/* Gap, rate, second derivative, a step without a root, its end, and the clearance.
   Newton from the left under a curvature bound. 132 operations: 27 additions, 15 subtractions, 47 multiplications, 4 divisions, 2 square roots, 2 negations, 2 absolute values, 15 comparisons, 18 selections. */
typedef struct {
    V gap, rate, bend, step, next, clearance;
} LANES(hoop_ring_advance_out);

LANES_INLINE LANES(hoop_ring_advance_out)
LANES(hoop_ring_advance)(V t, V end, V leaving, V margin, V rate_margin, V ceiling, V x, V y, V z, V vx, V vy, V vz, V energy2, V moment2, V rho_start, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7)
{
    const V _s0 = lanes_add(x, lanes_mul(vx, t));
    const V _s1 = lanes_add(y, lanes_mul(vy, t));
    const V _s2 = lanes_sqrt(lanes_add(lanes_mul(_s0, _s0), lanes_mul(_s1, _s1)));
    const V _s3 = lanes_sub(_s2, _c0);
    const V _s4 = lanes_add(rho_start, _s2);
    const V _s5 = lanes_div(K(1.0), lanes_mul(_s4, _s2));
    const V _s6 = lanes_mul(lanes_mul(lanes_add(lanes_mul(t, lanes_add(lanes_mul(vx, vx), lanes_mul(vy, vy))), lanes_mul(K(2.0), lanes_add(lanes_mul(x, vx), lanes_mul(y, vy)))), lanes_add(lanes_sub(rho_start, _c0), _s3)), lanes_mul(_s2, _s5));
    const V _s7 = lanes_sub(vz, lanes_mul(_c2, t));
    const V _s8 = lanes_add(z, lanes_mul(t, _s7));
    const V _s9 = lanes_select(lanes_less(K(0.0), leaving), lanes_mul(t, lanes_add(_s6, lanes_mul(lanes_add(z, _s8), _s7))), lanes_sub(lanes_add(lanes_mul(_s3, _s3), lanes_mul(_s8, _s8)), _c3));
    const V _s10 = lanes_mul(_s4, _s5);
    const V _s11 = lanes_mul(_s10, lanes_add(lanes_mul(vx, _s0), lanes_mul(vy, _s1)));
    const V _s12 = lanes_sub(vz, lanes_mul(_c1, t));
    const V _s13 = lanes_mul(K(2.0), lanes_add(lanes_mul(_s11, _s3), lanes_mul(_s8, _s12)));
    const V _s14 = lanes_mul(_c4, _s8);
    const V _s15 = lanes_mul(moment2, lanes_mul(_s10, lanes_mul(_s10, _s10)));
    const V _s16 = lanes_sub(_s13, rate_margin);
    const V _s17 = lanes_sub(_s9, margin);
    const V _s18 = lanes_max(_s17, K(0.0));
    const V _s19 = lanes_sub(lanes_add(_s14, _s15), energy2);
    const M _s20 = lanes_less(_s16, K(0.0));
    const V _s21 = lanes_mul(K(2.0), _s18);
    const V _s22 = lanes_select(lanes_less(K(0.0), lanes_select(lanes_at_most(K(0.0), _s16), _s18, K(0.0))), K(INFINITY), lanes_div(lanes_select(_s20, _s21, lanes_mul(K(4.0), _s16)), lanes_select(_s20, lanes_neg(_s16), lanes_max(K(0.0), _s19))));
    const V _s23 = lanes_sub(end, t);
    const V _s24 = lanes_min(_s22, _s23);
    const V _s25 = lanes_add(_c6, lanes_add(lanes_mul(_s24, lanes_max(_s12, K(0.0))), _s8));
    const V _s26 = lanes_mul(_c4, lanes_min(_c5, _s25));
    const V _s27 = lanes_sub(lanes_add(lanes_mul(_s24, lanes_min(K(0.0), _s11)), _s2), _c6);
    const V _s28 = lanes_div(K(1.0), lanes_max(_s27, _c7));
    const V _s29 = lanes_mul(moment2, lanes_mul(_s28, lanes_mul(_s28, _s28)));
    const V _s30 = lanes_sub(lanes_add(lanes_add(_s26, _s29), lanes_mul(K(9.094947017729282e-13), lanes_add(lanes_add(_s29, lanes_abs(energy2)), lanes_abs(_s26)))), energy2);
    const V _s31 = lanes_add(lanes_mul(lanes_mul(K(2.0), _s30), _s18), lanes_mul(_s16, _s16));
    const V _s32 = lanes_sqrt(_s31);
    const V _s33 = lanes_select(lanes_at_most(K(0.0), _s31), lanes_div(lanes_select(_s20, _s21, lanes_add(_s16, _s32)), lanes_select(_s20, lanes_sub(_s32, _s16), lanes_max(K(0.0), _s30))), K(INFINITY));
    const V _s34 = lanes_min(_s33, _s24);
    const V _s35 = lanes_neg(lanes_add(rate_margin, _s13));
    return (LANES(hoop_ring_advance_out)){ _s9, _s13, lanes_sub(lanes_sub(energy2, _s14), _s15), _s34, lanes_add(t, _s34), lanes_select(lanes_less(K(0.0), _s35), lanes_sub(lanes_mul(_s35, _s35), lanes_mul(lanes_mul(K(8.0), ceiling), lanes_add(margin, _s21))), _s35) };
}

/* Windows of the search along a flight, and whether single precision serves for it.
   bounds of the event condition. 171 operations: 21 additions, 15 subtractions, 29 multiplications, 1 division, 4 square roots, 1 negation, 4 absolute values, 42 comparisons, 7 conjunctions, 3 disjunctions, 44 selections. */
typedef struct {
    S t, end;
    M searching;
    S low1, high1, low2, high2, latest;
    M representable;
} LANES(hoop_ring_opened_out);

LANES_INLINE LANES(hoop_ring_opened_out)
LANES(hoop_ring_opened)(S horizon, S x, S y, S z, S vx, S vy, S vz, S extent, S speed, S _c0, S _c1, S _c2, S _c3, S _c4, S _c5, S _c6, S _c7, S _c8, S _c9)
{
    const S _s0 = singles_mul(vz, vz);
    const S _s1 = singles_mul(KS(4.76837158203125e-07), singles_add(_s0, singles_mul(_c2, singles_add(singles_abs(z), _c1))));
    const S _s2 = singles_add(singles_add(_s0, singles_mul(_c2, singles_add(z, _c1))), _s1);
    const S _s3 = singles_sqrt(_s2);
    const S _s4 = singles_mul(KS(9.5367431640625e-07), singles_add(singles_abs(vz), _s3));
    const Q _s5 = singles_at_most(KS(0.0), _s2);
    const S _s6 = singles_select(_s5, singles_mul(_c3, singles_sub(singles_sub(vz, _s3), _s4)), KS(INFINITY));
    const S _s7 = singles_add(singles_mul(vx, vx), singles_mul(vy, vy));
    const S _s8 = singles_mul(singles_mul(KS(9.5367431640625e-07), _s7), singles_add(_c5, singles_add(singles_mul(x, x), singles_mul(y, y))));
    const S _s9 = singles_sub(singles_mul(x, vy), singles_mul(y, vx));
    const S _s10 = singles_mul(_s9, _s9);
    const S _s11 = singles_sub(singles_add(singles_mul(_c5, _s7), _s8), _s10);
    const S _s12 = singles_add(singles_mul(x, vx), singles_mul(y, vy));
    const S _s13 = singles_sqrt(_s11);
    const S _s14 = singles_mul(KS(9.5367431640625e-07), singles_add(singles_add(singles_abs(_s12), singles_abs(_s9)), _s13));
    const S _s15 = singles_div(KS(1.0), _s7);
    const Q _s16 = singles_at_most(KS(0.0), _s11);
    const Q _s17 = singles_less(KS(8.673617379884035e-19), _s7);
    const S _s18 = singles_select(_s17, singles_select(_s16, singles_mul(singles_neg(singles_add(singles_add(_s12, _s13), _s14)), _s15), KS(INFINITY)), KS(-INFINITY));
    const S _s19 = singles_max(_s6, _s18);
    const S _s20 = singles_max(KS(0.0), _s19);
    const S _s21 = singles_max(KS(0.0), _s20);
    const S _s22 = singles_sub(singles_sub(singles_mul(_s7, _c7), _s8), _s10);
    const S _s23 = singles_sqrt(singles_max(_s22, KS(0.0)));
    const S _s24 = singles_select(_s17, singles_select(_s16, singles_mul(singles_sub(singles_add(_s13, _s14), _s12), _s15), KS(-INFINITY)), KS(INFINITY));
    const Q _s25 = singles_less(KS(0.0), singles_select(_s17, _s22, KS(0.0)));
    const S _s26 = singles_select(_s25, singles_mul(singles_sub(singles_sub(_s14, _s12), _s23), _s15), _s24);
    const S _s27 = singles_sub(singles_add(_s0, singles_mul(_c2, singles_sub(z, _c1))), _s1);
    const S _s28 = singles_sqrt(singles_max(_s27, KS(0.0)));
    const S _s29 = singles_select(_s5, singles_mul(_c3, singles_add(singles_add(vz, _s3), _s4)), KS(-INFINITY));
    const Q _s30 = singles_less(KS(0.0), _s27);
    const S _s31 = singles_select(_s30, singles_mul(_c3, singles_sub(singles_add(vz, _s4), _s28)), _s29);
    const S _s32 = singles_min(_s26, _s31);
    const S _s33 = singles_mul(KS(1.000000238418579), horizon);
    const S _s34 = singles_min(_s32, _s33);
    const Q _s35 = singles_less(_s21, _s34);
    const S _s36 = singles_select(_s25, singles_mul(singles_sub(singles_sub(_s23, _s12), _s14), _s15), KS(INFINITY));
    const S _s37 = singles_max(_s36, _s26);
    const S _s38 = singles_max(_s6, _s37);
    const S _s39 = singles_min(_s24, _s31);
    const S _s40 = singles_select(_s30, singles_mul(_c3, singles_sub(singles_add(vz, _s28), _s4)), KS(INFINITY));
    const S _s41 = singles_max(_s40, _s31);
    const Q _s42 = singles_at_most(_s38, _s39);
    const S _s43 = singles_select(_s42, _s38, singles_max(_s41, _s18));
    const S _s44 = singles_max(KS(0.0), _s43);
    const S _s45 = singles_max(KS(0.0), _s44);
    const S _s46 = singles_select(_s42, _s39, singles_min(_s26, _s29));
    const S _s47 = singles_min(_s46, _s33);
    const Q _s48 = singles_less(_s45, _s47);
    const S _s49 = singles_max(_s41, _s37);
    const S _s50 = singles_max(KS(0.0), _s49);
    const S _s51 = singles_max(KS(0.0), _s50);
    const S _s52 = singles_min(_s24, _s29);
    const S _s53 = singles_min(_s52, _s33);
    const Q _s54 = singles_less(_s51, _s53);
    const S _s55 = singles_max(KS(0.0), _s32);
    const S _s56 = singles_max(_s55, _s46);
    const S _s57 = singles_max(_s56, _s52);
    const Q _s58 = singles_both(singles_both(singles_both(singles_both(singles_both(singles_at_most(_c4, _c8), singles_at_most(_c4, _c9)), singles_at_most(_c4, KS(4096.0))), singles_at_most(KS(0.000244140625), _c6)), singles_at_most(_c0, KS(4096.0))), singles_at_most(KS(0.000244140625), _c0));
    return (LANES(hoop_ring_opened_out)){ singles_select(_s35, _s21, singles_select(_s48, _s45, singles_select(_s54, _s51, KS(0.0)))), singles_select(_s35, _s34, singles_select(_s48, _s47, singles_select(_s54, _s53, KS(0.0)))), singles_truth(singles_either(singles_either(singles_either(singles_mask_none(), _s54), _s48), _s35)), _s44, _s47, _s50, _s53, singles_min(_s57, _s33), singles_truth(singles_both(singles_both(_s58, singles_at_most(extent, KS(4096.0))), singles_at_most(speed, KS(4096.0)))) };
}

/* Constants, margins and windows of the search in single precision, from its begin.
   running error analysis. 85 operations: 18 additions, 7 subtractions, 42 multiplications, 2 divisions, 1 square root, 5 absolute values, 5 comparisons, 1 conjunction, 4 selections. */
typedef struct {
    S share, t, end, x, y, z, vx, vy, vz, energy2, moment2, rho_start, ceiling, flat, tilt, jerk, quotient_margin, start_rate, rho_rate, rate_margin, low1, high1, low2, high2;
    M fits;
} LANES(hoop_ring_resolution_out);

LANES_INLINE LANES(hoop_ring_resolution_out)
LANES(hoop_ring_resolution)(S t, S end, S leaving, S horizon, S x, S y, S z, S vx, S vy, S vz, S extent, S speed, S start_rate, S rho_rate, S low1, S high1, S low2, S high2, S _c0, S _c1, S _c2, S _c3, S _c4, S _c5, S _c6, S _c7, S _c8, S _c9, S _c10, S _c11)
{
    const Q _s0 = singles_less(KS(0.0), leaving);
    const S _s1 = singles_add(speed, singles_mul(_c0, horizon));
    const S _s2 = singles_mul(_s1, _c3);
    const S _s3 = singles_add(extent, singles_mul(horizon, _s1));
    const S _s4 = singles_mul(KS(5.0), singles_add(singles_mul(_s2, _s3), singles_mul(_c1, _s1)));
    const S _s5 = singles_div(singles_mul(KS(0.00390625), start_rate), _s4);
    const S _s6 = singles_min(_s5, KS(2.9802322387695312e-08));
    const S _s7 = singles_select(_s0, singles_max(KS(2.842170943040401e-14), _s6), KS(2.9802322387695312e-08));
    const S _s8 = singles_add(singles_add(singles_mul(KS(2.0), singles_mul(vz, vz)), singles_mul(_c4, z)), singles_mul(KS(2.0), singles_add(singles_mul(vx, vx), singles_mul(vy, vy))));
    const S _s9 = singles_sub(singles_mul(x, vy), singles_mul(y, vx));
    const S _s10 = singles_mul(_c5, singles_mul(_s9, _s9));
    const S _s11 = singles_add(singles_add(_c6, singles_mul(_s10, _c7)), singles_abs(_s8));
    const S _s12 = singles_sub(horizon, t);
    const S _s13 = singles_mul(_c0, singles_mul(_s12, _s12));
    const S _s14 = singles_add(singles_mul(_s3, _s7), singles_mul(KS(9.5367431640625e-07), singles_add(_s13, _c8)));
    const S _s15 = singles_div(singles_mul(KS(0.5), singles_mul(singles_mul(_s10, singles_add(singles_abs(vx), singles_abs(vy))), _c7)), _c2);
    return (LANES(hoop_ring_resolution_out)){ _s7, KS(0.0), singles_sub(end, t), x, y, z, vx, vy, vz, _s8, _s10, singles_sqrt(singles_add(singles_mul(x, x), singles_mul(y, y))), singles_mul(KS(1.0009765625), _s11), singles_mul(_c9, _s14), singles_select(_s0, singles_mul(KS(1.0009765625), singles_add(singles_mul(KS(4.76837158203125e-07), singles_abs(start_rate)), singles_mul(singles_add(KS(5.684341886080802e-14), _s7), _s4))), KS(INFINITY)), singles_mul(KS(1.0009765625), singles_add(singles_mul(_c0, singles_add(singles_mul(_c0, _s12), singles_abs(vz))), _s15)), singles_mul(_c10, _s11), start_rate, rho_rate, singles_mul(KS(5.0), singles_add(singles_mul(singles_mul(KS(1.0009765625), _s2), _s14), singles_mul(singles_mul(singles_add(KS(2.384185791015625e-07), _s7), _c1), _s1))), singles_sub(low1, t), singles_sub(high1, t), singles_sub(low2, t), singles_sub(high2, t), singles_truth(singles_both(singles_at_most(_s13, _c11), singles_at_most(singles_mul(t, leaving), KS(0.0)))) };
}

/* Time and window of the search after a step, whether a root is certain, and whether it goes on.
   Newton from the left under a curvature bound. 220 operations: 38 additions, 19 subtractions, 72 multiplications, 4 divisions, 2 square roots, 3 negations, 5 absolute values, 29 comparisons, 6 conjunctions, 5 disjunctions, 4 complements, 33 selections. */
typedef struct {
    S t, end;
    M certain, stepping;
} LANES(hoop_ring_step_out);

LANES_INLINE LANES(hoop_ring_step_out)
LANES(hoop_ring_step)(S t, S end, S rate_margin, S ceiling, S x, S y, S z, S vx, S vy, S vz, S energy2, S moment2, S rho_start, S flat, S tilt, S quotient_margin, S jerk, S start_rate, S rho_rate, S low1, S high1, S low2, S high2, S _c0, S _c1, S _c2, S _c3, S _c4, S _c5, S _c6, S _c7, S _c8, S _c9)
{
    const S _s0 = singles_add(tilt, singles_mul(t, quotient_margin));
    const S _s1 = singles_mul(t, _s0);
    const Q _s2 = singles_less(_s1, flat);
    const S _s3 = singles_mul(singles_mul(t, t), jerk);
    const Q _s4 = singles_both(_s2, singles_less(_s3, rate_margin));
    const S _s5 = singles_select(_s4, singles_add(_s3, singles_mul(KS(2.0), _s0)), rate_margin);
    const S _s6 = singles_add(singles_mul(vx, vx), singles_mul(vy, vy));
    const S _s7 = singles_add(x, singles_mul(vx, t));
    const S _s8 = singles_add(y, singles_mul(vy, t));
    const S _s9 = singles_sqrt(singles_add(singles_mul(_s7, _s7), singles_mul(_s8, _s8)));
    const S _s10 = singles_add(rho_start, _s9);
    const S _s11 = singles_div(KS(1.0), singles_mul(_s10, _s9));
    const S _s12 = singles_mul(_s9, _s11);
    const S _s13 = singles_mul(_s12, singles_add(singles_mul(t, _s6), singles_mul(KS(2.0), singles_add(singles_mul(x, vx), singles_mul(y, vy)))));
    const S _s14 = singles_sub(vz, singles_mul(_c2, t));
    const S _s15 = singles_add(singles_add(singles_mul(singles_mul(singles_mul(KS(2.0), singles_sub(rho_start, _c0)), singles_sub(_s6, singles_mul(rho_rate, _s13))), _s12), singles_mul(_s13, _s13)), singles_mul(_s14, _s14));
    const S _s16 = singles_add(start_rate, singles_mul(t, singles_sub(_s15, singles_mul(_c1, z))));
    const S _s17 = singles_mul(_s10, _s11);
    const S _s18 = singles_mul(_s17, singles_add(singles_mul(vx, _s7), singles_mul(vy, _s8)));
    const S _s19 = singles_sub(_s9, _c0);
    const S _s20 = singles_add(z, singles_mul(t, _s14));
    const S _s21 = singles_sub(vz, singles_mul(_c1, t));
    const S _s22 = singles_select(_s4, singles_sub(singles_mul(KS(2.0), _s16), start_rate), singles_mul(KS(2.0), singles_add(singles_mul(_s18, _s19), singles_mul(_s20, _s21))));
    const S _s23 = singles_neg(singles_add(_s5, _s22));
    const S _s24 = singles_select(_s2, _s1, flat);
    const S _s25 = singles_sub(singles_select(_s2, singles_mul(t, _s16), singles_sub(singles_add(singles_mul(_s19, _s19), singles_mul(_s20, _s20)), _c3)), _s24);
    const S _s26 = singles_max(_s25, KS(0.0));
    const S _s27 = singles_mul(KS(2.0), singles_add(_s26, singles_mul(KS(2.0), _s24)));
    const S _s28 = singles_sub(_s22, _s5);
    const S _s29 = singles_mul(_c4, _s20);
    const S _s30 = singles_mul(moment2, singles_mul(_s17, singles_mul(_s17, _s17)));
    const S _s31 = singles_sub(singles_add(_s29, _s30), energy2);
    const Q _s32 = singles_less(_s28, KS(0.0));
    const S _s33 = singles_mul(KS(2.0), _s26);
    const S _s34 = singles_select(singles_less(KS(0.0), singles_select(singles_at_most(KS(0.0), _s28), _s26, KS(0.0))), KS(INFINITY), singles_div(singles_select(_s32, singles_add(_s33, singles_mul(KS(8.0), _s24)), singles_mul(KS(4.0), _s28)), singles_select(_s32, singles_neg(_s28), singles_max(KS(0.0), _s31))));
    const S _s35 = singles_sub(end, t);
    const S _s36 = singles_min(_s34, _s35);
    const S _s37 = singles_add(_c6, singles_add(singles_mul(_s36, singles_max(_s21, KS(0.0))), _s20));
    const S _s38 = singles_mul(_c4, singles_min(_c5, _s37));
    const S _s39 = singles_mul(singles_add(singles_abs(vx), singles_abs(vy)), _s36);
    const S _s40 = singles_sub(singles_sub(singles_add(singles_mul(_s36, singles_min(KS(0.0), _s18)), _s9), singles_mul(KS(0.0001220703125), _s39)), _c7);
    const S _s41 = singles_div(KS(1.0), singles_max(_s40, _c8));
    const S _s42 = singles_mul(moment2, singles_mul(_s41, singles_mul(_s41, _s41)));
    const S _s43 = singles_abs(energy2);
    const S _s44 = singles_sub(singles_add(singles_add(_s38, _s42), singles_mul(KS(3.814697265625e-06), singles_add(singles_add(_s42, _s43), singles_abs(_s38)))), energy2);
    const S _s45 = singles_neg(_s21);
    const S _s46 = singles_add(singles_mul(_c4, singles_add(_c9, singles_mul(singles_add(singles_mul(_c1, _s36), singles_max(_s45, KS(0.0))), _s36))), singles_mul(singles_mul(KS(3.0), singles_mul(_s30, _s17)), _s39));
    const S _s47 = singles_add(energy2, singles_add(_s46, singles_mul(KS(0.000244140625), singles_add(singles_add(_s43, singles_abs(_s29)), _s30))));
    const S _s48 = singles_sub(singles_sub(_s47, _s29), _s30);
    const S _s49 = singles_select(singles_less(KS(0.0), _s23), singles_sub(singles_mul(_s23, _s23), singles_mul(singles_mul(KS(8.0), _s27), singles_select(singles_at_most(_s27, singles_mul(_s23, _s36)), singles_max(_s44, _s48), ceiling))), _s23);
    const Q _s50 = singles_less(KS(0.0), _s49);
    const S _s51 = singles_add(singles_mul(singles_mul(KS(2.0), _s44), _s26), singles_mul(_s28, _s28));
    const S _s52 = singles_sqrt(_s51);
    const S _s53 = singles_select(singles_at_most(KS(0.0), _s51), singles_div(singles_select(_s32, _s33, singles_add(_s52, _s28)), singles_select(_s32, singles_sub(_s52, _s28), singles_max(KS(0.0), _s44))), KS(INFINITY));
    const S _s54 = singles_min(_s53, _s36);
    const S _s55 = singles_add(t, _s54);
    const Q _s56 = singles_both(singles_not(_s50), singles_either(singles_both(singles_less(_s22, KS(0.0)), singles_at_most(_s25, _s24)), singles_both(singles_less(t, end), singles_not(singles_less(t, _s55)))));
    const Q _s57 = singles_not(singles_either(_s50, _s56));
    const Q _s58 = singles_both(_s57, singles_at_most(_s35, _s54));
    const S _s59 = singles_max(end, low1);
    const Q _s60 = singles_less(_s59, high1);
    const S _s61 = singles_max(end, low2);
    const Q _s62 = singles_less(_s61, high2);
    return (LANES(hoop_ring_step_out)){ singles_select(_s58, singles_select(_s60, _s59, singles_select(_s62, _s61, KS(INFINITY))), singles_select(_s56, t, _s55)), singles_select(_s58, singles_select(_s60, high1, singles_select(_s62, high2, end)), end), singles_truth(_s50), singles_truth(singles_both(_s57, singles_either(singles_not(_s58), singles_either(singles_either(singles_mask_none(), _s62), _s60)))) };
}

/* Distance from the axis, its rate and that of the gap, at the start of a flight.
   Table 2. 13 operations: 3 additions, 1 subtraction, 7 multiplications, 1 division, 1 square root. */
typedef struct {
    V rho_start, start_rate, rho_rate;
} LANES(hoop_ring_started_out);

LANES_INLINE LANES(hoop_ring_started_out)
LANES(hoop_ring_started)(V x, V y, V z, V vx, V vy, V vz, V _c0)
{
    const V _s0 = lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y)));
    const V _s1 = lanes_div(lanes_add(lanes_mul(x, vx), lanes_mul(y, vy)), _s0);
    return (LANES(hoop_ring_started_out)){ _s0, lanes_mul(K(2.0), lanes_add(lanes_mul(z, vz), lanes_mul(_s1, lanes_sub(_s0, _c0)))), _s1 };
}

/* Positive if errors of the state exceed those that a search allows for.
   running error analysis. 23 operations: 5 additions, 4 subtractions, 10 multiplications, 2 comparisons, 2 selections. */
typedef struct {
    V excess;
} LANES(hoop_ring_coarse_excess_out);

LANES_INLINE LANES(hoop_ring_coarse_excess_out)
LANES(hoop_ring_coarse_excess)(V share, V horizon, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1, V _c2, V _c3)
{
    const V _s0 = lanes_add(speed, lanes_mul(_c0, horizon));
    const V _s1 = lanes_mul(share, lanes_add(extent, lanes_mul(horizon, _s0)));
    const V _s2 = lanes_sub(lanes_sub(lanes_add(position_error, lanes_mul(horizon, velocity_error)), _s1), _c2);
    const V _s3 = lanes_sub(lanes_add(position_error, lanes_mul(lanes_mul(K(0.5), horizon), velocity_error)), _s1);
    const V _s4 = lanes_add(lanes_mul(lanes_mul(_s0, _c3), lanes_max(_s3, _s2)), lanes_mul(_c1, lanes_sub(velocity_error, lanes_mul(share, _s0))));
    return (LANES(hoop_ring_coarse_excess_out)){ lanes_max(_s2, _s4) };
}

/* Positive if the bounds of the search do not hold.
   bounds of the event condition. 15 operations: 3 additions, 2 subtractions, 5 multiplications, 1 square root, 2 comparisons, 2 selections. */
typedef struct {
    V budget_exceeded;
} LANES(hoop_ring_budget_exceeded_out);

LANES_INLINE LANES(hoop_ring_budget_exceeded_out)
LANES(hoop_ring_budget_exceeded)(V horizon, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(lanes_mul(_c1, lanes_sqrt(lanes_mul(_c2, lanes_add(_c3, extent)))), lanes_mul(lanes_mul(K(2.0), speed), _c2));
    const V _s1 = lanes_sub(lanes_sub(lanes_add(position_error, lanes_mul(velocity_error, lanes_min(_s0, horizon))), _c4), _c5);
    return (LANES(hoop_ring_budget_exceeded_out)){ lanes_max(_c0, _s1) };
}

/* Whether the ball may do other than rise and drop through the hole.
   Table 1. 79 operations: 20 additions, 5 subtractions, 30 multiplications, 12 comparisons, 11 conjunctions, 1 complement. */
typedef struct {
    M unproved;
} LANES(hoop_ring_drops_through_out);

LANES_INLINE LANES(hoop_ring_drops_through_out)
LANES(hoop_ring_drops_through)(S x, S y, S z, S vx, S vy, S vz, S horizon, S extent, S speed, S position_error, S velocity_error, S _c0, S _c1, S _c2, S _c3, S _c4, S _c5, S _c6, S _c7, S _c8, S _c9)
{
    const S _s0 = singles_mul(vz, _c2);
    const S _s1 = singles_add(x, singles_mul(vx, _s0));
    const S _s2 = singles_add(y, singles_mul(vy, _s0));
    const S _s3 = singles_mul(KS(0.125), singles_sub(horizon, _s0));
    const S _s4 = singles_sub(horizon, _s3);
    const S _s5 = singles_add(z, singles_mul(singles_sub(vz, singles_mul(_c4, _s4)), _s4));
    const Q _s6 = singles_both(singles_both(singles_both(singles_less(KS(0.0), vz), singles_less(_c1, singles_add(singles_mul(_s1, _s1), singles_mul(_s2, _s2)))), singles_less(singles_add(singles_mul(vx, _s1), singles_mul(vy, _s2)), KS(0.0))), singles_less(_c3, _s5));
    const S _s7 = singles_add(x, singles_mul(vx, _s4));
    const S _s8 = singles_add(y, singles_mul(vy, _s4));
    const S _s9 = singles_add(_s5, _c5);
    const S _s10 = singles_sub(horizon, singles_mul(KS(0.25), _s3));
    const S _s11 = singles_add(x, singles_mul(vx, _s10));
    const S _s12 = singles_add(y, singles_mul(vy, _s10));
    const S _s13 = singles_add(singles_mul(_s11, _s11), singles_mul(_s12, _s12));
    const S _s14 = singles_add(singles_add(z, singles_mul(singles_sub(vz, singles_mul(_c4, _s10)), _s10)), _c5);
    const Q _s15 = singles_both(singles_both(singles_both(_s6, singles_less(singles_add(singles_mul(_s7, _s7), singles_mul(_s8, _s8)), singles_mul(_s9, _s9))), singles_less(_s13, singles_mul(_s14, _s14))), singles_less(KS(0.0), _s14));
    const S _s16 = singles_add(x, singles_mul(vx, horizon));
    const S _s17 = singles_add(y, singles_mul(vy, horizon));
    const Q _s18 = singles_both(singles_both(singles_both(singles_both(_s15, singles_less(_s13, _c7)), singles_less(singles_add(singles_mul(_s16, _s16), singles_mul(_s17, _s17)), _c7)), singles_less(KS(0.0), _c6)), singles_less(singles_add(extent, singles_mul(horizon, singles_add(speed, singles_mul(_c0, horizon)))), _c8));
    return (LANES(hoop_ring_drops_through_out)){ singles_truth(singles_not(singles_both(_s18, singles_less(singles_add(position_error, singles_mul(horizon, velocity_error)), _c9)))) };
}

/* First window that ends later than a time, from then on.
   Table 1. 18 operations: 6 comparisons, 3 disjunctions, 9 selections. */
typedef struct {
    V t, end;
    M searching;
} LANES(hoop_ring_enter_out);

LANES_INLINE LANES(hoop_ring_enter_out)
LANES(hoop_ring_enter)(V t, V end, V after, V low0, V low1, V low2, V high0, V high1, V high2)
{
    const V _s0 = lanes_max(after, low0);
    const M _s1 = lanes_less(_s0, high0);
    const V _s2 = lanes_max(after, low1);
    const M _s3 = lanes_less(_s2, high1);
    const V _s4 = lanes_max(after, low2);
    const M _s5 = lanes_less(_s4, high2);
    return (LANES(hoop_ring_enter_out)){ lanes_select(_s1, _s0, lanes_select(_s3, _s2, lanes_select(_s5, _s4, t))), lanes_select(_s1, high0, lanes_select(_s3, high1, lanes_select(_s5, high2, end))), lanes_either(lanes_either(lanes_either(mask_none(), _s5), _s3), _s1) };
}

/* Outward unit normal n3 at a contact.
   Table 2. No operations. */
typedef struct {
    V nx, ny, nz;
} LANES(hoop_backboard_normal_out);

LANES_INLINE LANES(hoop_backboard_normal_out)
LANES(hoop_backboard_normal)(void)
{
    return (LANES(hoop_backboard_normal_out)){ K(1.0), K(0.0), K(0.0) };
}

/* Tangent and curvatures at a contact, and bounds on the roundings there.
   Table 2, running error analysis. 8 operations: 2 additions, 4 multiplications, 2 absolute values. */
typedef struct {
    S tangent_x, tangent_y, bend_s, bend_e, sharpest_bend, root_offset, root_level, normal_rounding;
} LANES(hoop_backboard_tangents_out);

LANES_INLINE LANES(hoop_backboard_tangents_out)
LANES(hoop_backboard_tangents)(S t, S x, S vx)
{
    const S _s0 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(singles_mul(KS(4.0), t), singles_mul(KS(2.0), singles_abs(vx))), singles_abs(x))));
    return (LANES(hoop_backboard_tangents_out)){ KS(0.0), KS(1.0), KS(0.0), KS(0.0), KS(0.0), _s0, _s0, KS(0.0) };
}

/* The g of Eq. 2: a contact counts if none is positive.
   Eq. 2, Table 2. 5 operations: 1 addition, 3 subtractions, 1 negation. */
typedef struct {
    V g0, g1, g2, g3;
} LANES(hoop_backboard_bounds_out);

LANES_INLINE LANES(hoop_backboard_bounds_out)
LANES(hoop_backboard_bounds)(V y, V z, V _c0, V _c1, V _c2)
{
    return (LANES(hoop_backboard_bounds_out)){ lanes_neg(lanes_add(_c0, y)), lanes_sub(y, _c0), lanes_sub(_c1, z), lanes_sub(z, _c2) };
}

/* Time of the only arrival, the gap's first two derivatives there, and its apex.
   Eq. 3 in Table 2, solved. 8 operations: 1 subtraction, 1 division, 1 negation, 2 comparisons, 3 selections. */
typedef struct {
    V time, rate, bend, apex, height;
} LANES(hoop_backboard_arrival_out);

LANES_INLINE LANES(hoop_backboard_arrival_out)
LANES(hoop_backboard_arrival)(V leaving, V x, V vx, V _c0)
{
    const M _s0 = lanes_less(K(0.0), leaving);
    const V _s1 = lanes_select(_s0, K(0.0), lanes_sub(x, _c0));
    return (LANES(hoop_backboard_arrival_out)){ lanes_neg(lanes_div(_s1, vx)), vx, K(0.0), K(0.0), lanes_select(_s0, lanes_select(lanes_less(vx, K(0.0)), K(0.0), K(INFINITY)), _s1) };
}

/* Rounding-error bound of the gap up to the horizon.
   running error analysis. 12 operations: 6 additions, 6 multiplications. */
typedef struct {
    V margin;
} LANES(hoop_backboard_margin_out);

LANES_INLINE LANES(hoop_backboard_margin_out)
LANES(hoop_backboard_margin)(V horizon, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1)
{
    const V _s0 = lanes_add(extent, lanes_mul(horizon, lanes_add(speed, lanes_mul(_c0, horizon))));
    return (LANES(hoop_backboard_margin_out)){ lanes_add(lanes_add(_c1, lanes_mul(K(2.222614453595284e-16), _s0)), lanes_mul(K(2.001953125), lanes_add(lanes_add(position_error, lanes_mul(horizon, velocity_error)), lanes_mul(K(4.440892098500626e-16), _s0)))) };
}

/* Point of the contact plane nearest to a position.
   Table 2. No operations. */
typedef struct {
    V x, y, z;
} LANES(hoop_backboard_place_out);

LANES_INLINE LANES(hoop_backboard_place_out)
LANES(hoop_backboard_place)(V y, V z, V _c0)
{
    return (LANES(hoop_backboard_place_out)){ _c0, y, z };
}

/* Whether a contact counts (Eq. 2).
   Table 1. 7 operations: 4 comparisons, 3 conjunctions. */
typedef struct {
    M arrives;
} LANES(hoop_backboard_within_out);

LANES_INLINE LANES(hoop_backboard_within_out)
LANES(hoop_backboard_within)(V g0, V g1, V g2, V g3)
{
    return (LANES(hoop_backboard_within_out)){ lanes_both(lanes_both(lanes_both(lanes_at_most(g0, K(0.0)), lanes_at_most(g1, K(0.0))), lanes_at_most(g2, K(0.0))), lanes_at_most(g3, K(0.0))) };
}

/* Whether the bounds or the crossing lie within their errors.
   Table 1. 19 operations: 1 negation, 9 comparisons, 8 conjunctions, 1 complement. */
typedef struct {
    M undecided;
} LANES(hoop_backboard_edges_out);

LANES_INLINE LANES(hoop_backboard_edges_out)
LANES(hoop_backboard_edges)(V clearance, V slack, V g0, V g1, V g2, V g3)
{
    const V _s0 = lanes_neg(slack);
    const M _s1 = lanes_not(lanes_both(lanes_both(lanes_both(lanes_both(lanes_less(g0, _s0), lanes_less(g1, _s0)), lanes_less(g2, _s0)), lanes_less(g3, _s0)), lanes_less(K(0.0), clearance)));
    return (LANES(hoop_backboard_edges_out)){ lanes_both(lanes_both(lanes_both(lanes_both(lanes_at_most(g0, slack), lanes_at_most(g1, slack)), lanes_at_most(g2, slack)), lanes_at_most(g3, slack)), _s1) };
}

/* Outward unit normal n3 at a contact.
   Table 2. No operations. */
typedef struct {
    V nx, ny, nz;
} LANES(hoop_bridge_normal_out);

LANES_INLINE LANES(hoop_bridge_normal_out)
LANES(hoop_bridge_normal)(void)
{
    return (LANES(hoop_bridge_normal_out)){ K(0.0), K(0.0), K(1.0) };
}

/* Tangent and curvatures at a contact, and bounds on the roundings there.
   Table 2, running error analysis. 11 operations: 4 additions, 4 multiplications, 3 absolute values. */
typedef struct {
    S tangent_x, tangent_y, bend_s, bend_e, sharpest_bend, root_offset, root_level, normal_rounding;
} LANES(hoop_bridge_tangents_out);

LANES_INLINE LANES(hoop_bridge_tangents_out)
LANES(hoop_bridge_tangents)(S t, S z, S vz, S _c0)
{
    const S _s0 = singles_add(singles_mul(singles_mul(KS(4.0), t), singles_add(singles_abs(vz), singles_abs(singles_add(vz, singles_mul(_c0, t))))), singles_abs(z));
    const S _s1 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), _s0));
    return (LANES(hoop_bridge_tangents_out)){ KS(0.0), KS(1.0), KS(0.0), KS(0.0), KS(0.0), _s1, _s1, KS(0.0) };
}

/* The g of Eq. 2: a contact counts if none is positive.
   Eq. 2, Table 2. 10 operations: 3 additions, 2 subtractions, 2 multiplications, 1 square root, 2 negations. */
typedef struct {
    V g0, g1, g2, g3, g4;
} LANES(hoop_bridge_bounds_out);

LANES_INLINE LANES(hoop_bridge_bounds_out)
LANES(hoop_bridge_bounds)(V x, V y, V _c0, V _c1, V _c2)
{
    return (LANES(hoop_bridge_bounds_out)){ lanes_neg(lanes_add(_c2, y)), lanes_sub(y, _c2), lanes_sub(_c0, lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y)))), x, lanes_neg(lanes_add(_c1, x)) };
}

/* Time of the only arrival, the gap's first two derivatives there, and its apex.
   Eq. 3 in Table 2, solved. 23 operations: 2 additions, 2 subtractions, 5 multiplications, 1 division, 1 square root, 3 negations, 1 absolute value, 2 comparisons, 6 selections. */
typedef struct {
    V time, rate, bend, apex, height;
} LANES(hoop_bridge_arrival_out);

LANES_INLINE LANES(hoop_bridge_arrival_out)
LANES(hoop_bridge_arrival)(V leaving, V z, V vz, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const M _s0 = lanes_less(K(0.0), leaving);
    const V _s1 = lanes_select(_s0, K(0.0), lanes_sub(z, _c1));
    const V _s2 = lanes_add(lanes_mul(vz, vz), lanes_mul(_c2, _s1));
    const V _s3 = lanes_select(_s0, lanes_abs(vz), lanes_sqrt(_s2));
    const M _s4 = lanes_less(vz, K(0.0));
    return (LANES(hoop_bridge_arrival_out)){ lanes_div(lanes_select(_s4, lanes_mul(K(2.0), _s1), lanes_add(vz, _s3)), lanes_select(_s4, lanes_sub(_s3, vz), _c0)), lanes_neg(_s3), _c3, lanes_select(_s4, K(0.0), lanes_neg(lanes_mul(vz, _c4))), lanes_select(_s4, _s1, lanes_neg(lanes_mul(_c5, _s2))) };
}

/* Rounding-error bound of the gap up to the horizon.
   running error analysis. 12 operations: 6 additions, 6 multiplications. */
typedef struct {
    V margin;
} LANES(hoop_bridge_margin_out);

LANES_INLINE LANES(hoop_bridge_margin_out)
LANES(hoop_bridge_margin)(V horizon, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1)
{
    const V _s0 = lanes_add(extent, lanes_mul(horizon, lanes_add(speed, lanes_mul(_c0, horizon))));
    return (LANES(hoop_bridge_margin_out)){ lanes_add(lanes_add(_c1, lanes_mul(K(2.222614453595284e-16), _s0)), lanes_mul(K(2.001953125), lanes_add(lanes_add(position_error, lanes_mul(horizon, velocity_error)), lanes_mul(K(4.440892098500626e-16), _s0)))) };
}

/* Point of the contact plane nearest to a position.
   Table 2. No operations. */
typedef struct {
    V x, y, z;
} LANES(hoop_bridge_place_out);

LANES_INLINE LANES(hoop_bridge_place_out)
LANES(hoop_bridge_place)(V x, V y, V _c0)
{
    return (LANES(hoop_bridge_place_out)){ x, y, _c0 };
}

/* Whether a contact counts (Eq. 2).
   Table 1. 9 operations: 5 comparisons, 4 conjunctions. */
typedef struct {
    M arrives;
} LANES(hoop_bridge_within_out);

LANES_INLINE LANES(hoop_bridge_within_out)
LANES(hoop_bridge_within)(V g0, V g1, V g2, V g3, V g4)
{
    return (LANES(hoop_bridge_within_out)){ lanes_both(lanes_both(lanes_both(lanes_both(lanes_at_most(g0, K(0.0)), lanes_at_most(g1, K(0.0))), lanes_at_most(g2, K(0.0))), lanes_at_most(g3, K(0.0))), lanes_at_most(g4, K(0.0))) };
}

/* Whether the bounds or the crossing lie within their errors.
   Table 1. 23 operations: 1 negation, 11 comparisons, 10 conjunctions, 1 complement. */
typedef struct {
    M undecided;
} LANES(hoop_bridge_edges_out);

LANES_INLINE LANES(hoop_bridge_edges_out)
LANES(hoop_bridge_edges)(V clearance, V slack, V g0, V g1, V g2, V g3, V g4)
{
    const V _s0 = lanes_neg(slack);
    const M _s1 = lanes_both(lanes_both(lanes_both(lanes_both(lanes_both(lanes_less(g0, _s0), lanes_less(g1, _s0)), lanes_less(g2, _s0)), lanes_less(g3, _s0)), lanes_less(g4, _s0)), lanes_less(K(0.0), clearance));
    const M _s2 = lanes_both(lanes_both(lanes_both(lanes_both(lanes_both(lanes_at_most(g0, slack), lanes_at_most(g1, slack)), lanes_at_most(g2, slack)), lanes_at_most(g3, slack)), lanes_at_most(g4, slack)), lanes_not(_s1));
    return (LANES(hoop_bridge_edges_out)){ _s2 };
}

/* Outward unit normal n3 at a contact.
   Table 2. No operations. */
typedef struct {
    V nx, ny, nz;
} LANES(hoop_end_normal_out);

LANES_INLINE LANES(hoop_end_normal_out)
LANES(hoop_end_normal)(void)
{
    return (LANES(hoop_end_normal_out)){ K(0.0), K(0.0), K(1.0) };
}

/* Tangent and curvatures at a contact, and bounds on the roundings there.
   Table 2, running error analysis. 11 operations: 4 additions, 4 multiplications, 3 absolute values. */
typedef struct {
    S tangent_x, tangent_y, bend_s, bend_e, sharpest_bend, root_offset, root_level, normal_rounding;
} LANES(hoop_end_tangents_out);

LANES_INLINE LANES(hoop_end_tangents_out)
LANES(hoop_end_tangents)(S t, S z, S vz, S _c0)
{
    const S _s0 = singles_add(singles_mul(singles_mul(KS(4.0), t), singles_add(singles_abs(vz), singles_abs(singles_add(vz, singles_mul(_c0, t))))), singles_abs(z));
    const S _s1 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), _s0));
    return (LANES(hoop_end_tangents_out)){ KS(0.0), KS(1.0), KS(0.0), KS(0.0), KS(0.0), _s1, _s1, KS(0.0) };
}

/* Time of the only arrival, the gap's first two derivatives there, and its apex.
   Eq. 3 in Table 2, solved. 23 operations: 2 additions, 2 subtractions, 5 multiplications, 1 division, 1 square root, 3 negations, 1 absolute value, 2 comparisons, 6 selections. */
typedef struct {
    V time, rate, bend, apex, height;
} LANES(hoop_end_arrival_out);

LANES_INLINE LANES(hoop_end_arrival_out)
LANES(hoop_end_arrival)(V leaving, V z, V vz, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const M _s0 = lanes_less(K(0.0), leaving);
    const V _s1 = lanes_select(_s0, K(0.0), lanes_sub(z, _c1));
    const V _s2 = lanes_add(lanes_mul(vz, vz), lanes_mul(_c2, _s1));
    const V _s3 = lanes_select(_s0, lanes_abs(vz), lanes_sqrt(_s2));
    const M _s4 = lanes_less(vz, K(0.0));
    return (LANES(hoop_end_arrival_out)){ lanes_div(lanes_select(_s4, lanes_mul(K(2.0), _s1), lanes_add(vz, _s3)), lanes_select(_s4, lanes_sub(_s3, vz), _c0)), lanes_neg(_s3), _c3, lanes_select(_s4, K(0.0), lanes_neg(lanes_mul(vz, _c4))), lanes_select(_s4, _s1, lanes_neg(lanes_mul(_c5, _s2))) };
}

/* Rounding-error bound of the gap up to the horizon.
   running error analysis. 12 operations: 6 additions, 6 multiplications. */
typedef struct {
    V margin;
} LANES(hoop_end_margin_out);

LANES_INLINE LANES(hoop_end_margin_out)
LANES(hoop_end_margin)(V horizon, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1)
{
    const V _s0 = lanes_add(extent, lanes_mul(horizon, lanes_add(speed, lanes_mul(_c0, horizon))));
    return (LANES(hoop_end_margin_out)){ lanes_add(lanes_add(_c1, lanes_mul(K(2.222614453595284e-16), _s0)), lanes_mul(K(2.001953125), lanes_add(lanes_add(position_error, lanes_mul(horizon, velocity_error)), lanes_mul(K(4.440892098500626e-16), _s0)))) };
}

/* Bounds of the ends on a plane; the first whose bounds all hold is reached.
   Table 2, success. 5 operations: 1 addition, 1 subtraction, 2 multiplications, 1 square root. */
typedef struct {
    V g0;
} LANES(hoop_end_bounds_out);

LANES_INLINE LANES(hoop_end_bounds_out)
LANES(hoop_end_bounds)(V x, V y, V _c0)
{
    return (LANES(hoop_end_bounds_out)){ lanes_sub(lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y))), _c0) };
}

/* End that a crossing reaches.
   Table 1. 2 operations: 1 comparison, 1 selection. */
typedef struct {
    V reached;
} LANES(hoop_end_reached_out);

LANES_INLINE LANES(hoop_end_reached_out)
LANES(hoop_end_reached)(V g0)
{
    return (LANES(hoop_end_reached_out)){ lanes_select(lanes_at_most(g0, K(0.0)), K(0.0), K(1.0)) };
}

/* Whether the choice of the end lies within its error.
   Table 1. 5 operations: 1 negation, 2 comparisons, 1 conjunction, 1 complement. */
typedef struct {
    M edge;
} LANES(hoop_end_edge_out);

LANES_INLINE LANES(hoop_end_edge_out)
LANES(hoop_end_edge)(V slack, V g0)
{
    return (LANES(hoop_end_edge_out)){ lanes_both(lanes_at_most(g0, slack), lanes_not(lanes_less(g0, lanes_neg(slack)))) };
}

