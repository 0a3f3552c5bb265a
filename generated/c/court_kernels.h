/* Kernels of the scene court, in C.

   Generated from templates/c/kernels.h.j2, scene court, derivation 6850e5812fbcfc63,
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
} LANES(court_flight_out);

LANES_INLINE LANES(court_flight_out)
LANES(court_flight)(V t, V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1)
{
    return (LANES(court_flight_out)){ lanes_add(x, lanes_mul(vx, t)), lanes_add(y, lanes_mul(vy, t)), lanes_add(z, lanes_mul(t, lanes_sub(vz, lanes_mul(_c1, t)))), vx, vy, lanes_sub(vz, lanes_mul(_c0, t)) };
}

/* Clearance, positive if a crossing is certain, and a bound on its delay.
   Taylor's theorem with the margins of the gap and its rate. 10 operations: 1 addition, 1 subtraction, 3 multiplications, 1 division, 1 negation, 1 comparison, 2 selections. */
typedef struct {
    V clearance, delay;
} LANES(court_crossing_out);

LANES_INLINE LANES(court_crossing_out)
LANES(court_crossing)(V margin, V rate_margin, V rate, V ceiling)
{
    const V _s0 = lanes_neg(lanes_add(rate, rate_margin));
    const V _s1 = lanes_mul(K(6.0), margin);
    const M _s2 = lanes_less(K(0.0), _s0);
    return (LANES(court_crossing_out)){ lanes_select(_s2, lanes_sub(lanes_mul(_s0, _s0), lanes_mul(_s1, ceiling)), _s0), lanes_select(_s2, lanes_div(_s1, _s0), K(INFINITY)) };
}

/* Errors of the state that a search allows for, and by how much the errors exceed them.
   a share of the size of the flight. 10 operations: 2 additions, 2 subtractions, 4 multiplications, 1 comparison, 1 selection. */
typedef struct {
    V position_level, velocity_level, excess;
} LANES(court_allowance_out);

LANES_INLINE LANES(court_allowance_out)
LANES(court_allowance)(V share, V horizon, V extent, V speed, V position_error, V velocity_error, V _c0)
{
    const V _s0 = lanes_add(speed, lanes_mul(_c0, horizon));
    const V _s1 = lanes_mul(share, lanes_add(extent, lanes_mul(horizon, _s0)));
    const V _s2 = lanes_mul(share, _s0);
    const V _s3 = lanes_sub(position_error, _s1);
    const V _s4 = lanes_sub(velocity_error, _s2);
    return (LANES(court_allowance_out)){ _s1, _s2, lanes_max(_s3, _s4) };
}

/* Time after which no event is wanted, and how long that is after t.
   the earliest arrival, with room for its delay. 4 operations: 2 additions, 2 multiplications. */
typedef struct {
    V horizon, pad;
} LANES(court_horizon_out);

LANES_INLINE LANES(court_horizon_out)
LANES(court_horizon)(V t, V speed, V _c0)
{
    const V _s0 = lanes_mul(K(9.5367431640625e-07), lanes_add(t, lanes_mul(speed, _c0)));
    return (LANES(court_horizon_out)){ lanes_add(t, _s0), _s0 };
}

/* Sums of the sizes of position and velocity, and the excess of the flight's size.
   the measure of rounding errors. 17 operations: 4 additions, 1 subtraction, 2 multiplications, 6 absolute values, 2 comparisons, 2 selections. */
typedef struct {
    V extent, speed, excess;
} LANES(court_scale_out);

LANES_INLINE LANES(court_scale_out)
LANES(court_scale)(V x, V y, V z, V vx, V vy, V vz, V _c0)
{
    const V _s0 = lanes_add(lanes_add(lanes_abs(x), lanes_abs(y)), lanes_abs(z));
    const V _s1 = lanes_add(lanes_add(lanes_abs(vx), lanes_abs(vy)), lanes_abs(vz));
    const V _s2 = lanes_max(_s0, _s1);
    const V _s3 = lanes_mul(_c0, lanes_mul(_s1, _s1));
    return (LANES(court_scale_out)){ _s0, _s1, lanes_sub(lanes_max(_s2, _s3), K(1.152921504606847e+18)) };
}

/* Bound on the error of a length at a computed arrival.
   running error analysis. 15 operations: 7 additions, 8 multiplications. */
typedef struct {
    V margin;
} LANES(court_displacement_out);

LANES_INLINE LANES(court_displacement_out)
LANES(court_displacement)(V delay, V horizon, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1)
{
    const V _s0 = lanes_add(speed, lanes_mul(_c0, horizon));
    const V _s1 = lanes_add(extent, lanes_mul(horizon, _s0));
    return (LANES(court_displacement_out)){ lanes_add(lanes_add(lanes_mul(lanes_mul(K(1.0009765625), delay), _s0), lanes_mul(K(4.445228907190568e-16), lanes_add(_s1, _c1))), lanes_mul(K(3.0029296875), lanes_add(lanes_add(position_error, lanes_mul(horizon, velocity_error)), lanes_mul(K(4.440892098500626e-16), _s1)))) };
}

/* Velocity along the normal before the impact.
   Table 2. 5 operations: 2 additions, 3 multiplications. */
typedef struct {
    V normal_velocity;
} LANES(court_normal_velocity_out);

LANES_INLINE LANES(court_normal_velocity_out)
LANES(court_normal_velocity)(V vx, V vy, V vz, V nx, V ny, V nz)
{
    return (LANES(court_normal_velocity_out)){ lanes_add(lanes_add(lanes_mul(nx, vx), lanes_mul(ny, vy)), lanes_mul(nz, vz)) };
}

/* Bounds on the errors where a flight crosses the end plane.
   Eq. 3, with roundings. 62 operations: 25 additions, 1 subtraction, 22 multiplications, 1 division, 8 absolute values, 1 comparison, 4 selections. */
typedef struct {
    S position_bound, velocity_bound, spin_bound, delay;
} LANES(court_bound_end_out);

LANES_INLINE LANES(court_bound_end_out)
LANES(court_bound_end)(S t, S x, S y, S z, S vx, S vy, S vz, S clock, S position_bound, S velocity_bound, S spin_bound, S root_offset, S normal_velocity, S _c0, S _c1)
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
    return (LANES(court_bound_end_out)){ singles_select(_s12, _s11, KS(INFINITY)), singles_select(_s12, singles_mul(KS(1.0009765625), _s10), KS(INFINITY)), singles_select(_s12, singles_mul(KS(1.0009765625), spin_bound), KS(INFINITY)), singles_add(singles_mul(KS(4.440892098500626e-16), singles_add(t, clock)), singles_select(_s12, singles_mul(KS(1.0009765625), _s7), KS(INFINITY))) };
}

/* Bounds on the errors at the time limit.
   Eq. 3, with roundings. 50 operations: 24 additions, 19 multiplications, 7 absolute values. */
typedef struct {
    S position_bound, velocity_bound, spin_bound, clock_bound;
} LANES(court_bound_time_out);

LANES_INLINE LANES(court_bound_time_out)
LANES(court_bound_time)(S t, S x, S y, S z, S vx, S vy, S vz, S clock, S position_bound, S velocity_bound, S spin_bound, S clock_bound, S _c0, S _c1)
{
    const S _s0 = singles_add(clock_bound, singles_mul(KS(4.440892098500626e-16), singles_add(t, clock)));
    const S _s1 = singles_abs(vx);
    const S _s2 = singles_abs(vy);
    const S _s3 = singles_abs(vz);
    const S _s4 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_add(singles_add(singles_mul(_c0, t), _s1), _s2), _s3)));
    const S _s5 = singles_add(singles_add(velocity_bound, singles_mul(_c0, _s0)), _s4);
    const S _s6 = singles_mul(KS(2.0), t);
    const S _s7 = singles_add(singles_add(singles_mul(_c1, singles_mul(t, t)), singles_mul(_s6, singles_abs(singles_add(vz, singles_mul(_c1, t))))), singles_abs(z));
    const S _s8 = singles_add(singles_add(singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s6, _s1), singles_abs(x)))), singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s6, _s2), singles_abs(y))))), singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), _s7)));
    const S _s9 = singles_add(singles_add(singles_add(position_bound, singles_mul(t, velocity_bound)), singles_mul(_s0, singles_add(_s5, singles_add(singles_add(_s1, _s2), _s3)))), _s8);
    return (LANES(court_bound_time_out)){ singles_mul(KS(1.0009765625), _s9), singles_mul(KS(1.0009765625), _s5), singles_mul(KS(1.0009765625), spin_bound), KS(0.0) };
}

/* Whether the bounds of a shot are estimated from a contact on.
   comparison. 17 operations: 2 additions, 4 multiplications, 5 comparisons, 2 conjunctions, 2 disjunctions, 1 complement, 1 selection. */
typedef struct {
    V estimated;
} LANES(court_estimated_after_contact_out);

LANES_INLINE LANES(court_estimated_after_contact_out)
LANES(court_estimated_after_contact)(V vx, V vy, V vz, V nx, V ny, V nz, V position_bound, V velocity_bound, V spin_bound, V estimated, V _c0)
{
    const V _s0 = lanes_add(lanes_add(lanes_mul(nx, vx), lanes_mul(ny, vy)), lanes_mul(nz, vz));
    const M _s1 = lanes_either(lanes_either(lanes_less(K(0.0), estimated), lanes_not(lanes_both(lanes_both(lanes_at_most(position_bound, K(1.1641532182693481e-10)), lanes_less(velocity_bound, K(INFINITY))), lanes_less(spin_bound, K(INFINITY))))), lanes_less(lanes_mul(_s0, _s0), _c0));
    return (LANES(court_estimated_after_contact_out)){ lanes_select(_s1, K(1.0), K(0.0)) };
}

/* Whether a contact, and an end, of a shot is met that is not estimated.
   Table 1. 3 operations: 1 comparison, 2 conjunctions. */
typedef struct {
    M proves_contact, proves_end;
} LANES(court_proves_out);

LANES_INLINE LANES(court_proves_out)
LANES(court_proves)(M ends, M touches, V estimated)
{
    const M _s0 = lanes_at_most(estimated, K(0.0));
    return (LANES(court_proves_out)){ lanes_both(touches, _s0), lanes_both(ends, _s0) };
}

/* A ball that may begin to roll is estimated from then on.
   Table 1. No operations. */
typedef struct {
    V estimated;
} LANES(court_estimates_out);

LANES_INLINE LANES(court_estimates_out)
LANES(court_estimates)(void)
{
    return (LANES(court_estimates_out)){ K(1.0) };
}

/* Sum of the proved bounds on the delays of contacts.
   Table 1. 1 operation: 1 addition. */
typedef struct {
    S clock_bound;
} LANES(court_clock_bound_sum_out);

LANES_INLINE LANES(court_clock_bound_sum_out)
LANES(court_clock_bound_sum)(S delay, S clock_bound)
{
    return (LANES(court_clock_bound_sum_out)){ singles_add(delay, clock_bound) };
}

/* Errors of the state at the end of a flight to a surface, from those at its start.
   derivative of Eq. 3 and of the contact time, with roundings. 165 operations: 36 additions, 2 subtractions, 43 multiplications, 2 divisions, 10 negations, 17 absolute values, 23 comparisons, 32 selections. */
typedef struct {
    V dx, dy, dz, lifting, dvx, dvy, dvz, delay, shift;
} LANES(court_carry_flight_out);

LANES_INLINE LANES(court_carry_flight_out)
LANES(court_carry_flight)(V t, V x, V y, V z, V vx, V vy, V vz, V nx, V ny, V nz, V clock, V contacts, V earliest_delay, V dx, V dy, V dz, V dvx, V dvy, V dvz, V left_nx, V left_ny, V left_nz, V curving, V _c0)
{
    const V _s0 = lanes_abs(vx);
    const V _s1 = lanes_abs(vy);
    const V _s2 = lanes_max(_s0, _s1);
    const V _s3 = lanes_abs(vz);
    const V _s4 = lanes_max(_s2, _s3);
    const V _s5 = lanes_mul(curving, lanes_mul(t, _s4));
    const V _s6 = lanes_min(_s5, K(1.0));
    const V _s7 = lanes_add(dx, lanes_mul(dvx, t));
    const V _s8 = lanes_abs(x);
    const V _s9 = lanes_abs(y);
    const V _s10 = lanes_abs(z);
    const V _s11 = lanes_add(K(1.0), lanes_mul(curving, lanes_add(lanes_add(_s8, _s9), _s10)));
    const V _s12 = lanes_mul(K(2.0), t);
    const V _s13 = lanes_mul(_s12, _s0);
    const V _s14 = lanes_add(K(7.888609052210118e-31), lanes_mul(K(1.1102230246251565e-16), lanes_add(_s13, _s8)));
    const M _s15 = lanes_less(curving, K(INFINITY));
    const V _s16 = lanes_select(_s15, lanes_mul(K(4.440892098500626e-16), lanes_mul(_s13, _s11)), _s14);
    const M _s17 = lanes_less(_s7, K(0.0));
    const V _s18 = lanes_add(dy, lanes_mul(dvy, t));
    const V _s19 = lanes_mul(_s12, _s1);
    const V _s20 = lanes_add(K(7.888609052210118e-31), lanes_mul(K(1.1102230246251565e-16), lanes_add(_s19, _s9)));
    const V _s21 = lanes_select(_s15, lanes_mul(K(4.440892098500626e-16), lanes_mul(_s19, _s11)), _s20);
    const M _s22 = lanes_less(_s18, K(0.0));
    const V _s23 = lanes_add(dz, lanes_mul(dvz, t));
    const V _s24 = lanes_add(lanes_mul(_c0, lanes_mul(t, t)), lanes_mul(_s12, _s3));
    const V _s25 = lanes_add(K(7.888609052210118e-31), lanes_mul(K(1.1102230246251565e-16), lanes_add(_s24, _s10)));
    const V _s26 = lanes_select(_s15, lanes_mul(K(4.440892098500626e-16), lanes_mul(_s24, _s11)), _s25);
    const M _s27 = lanes_less(_s23, K(0.0));
    const V _s28 = lanes_add(lanes_add(lanes_mul(nx, lanes_add(_s7, lanes_select(_s17, lanes_neg(_s16), _s16))), lanes_mul(ny, lanes_add(_s18, lanes_select(_s22, lanes_neg(_s21), _s21)))), lanes_mul(nz, lanes_add(_s23, lanes_select(_s27, lanes_neg(_s26), _s26))));
    const V _s29 = lanes_div(K(1.0), lanes_add(lanes_add(lanes_mul(nx, vx), lanes_mul(ny, vy)), lanes_mul(nz, vz)));
    const V _s30 = lanes_neg(lanes_mul(lanes_sub(_s28, lanes_add(lanes_add(lanes_mul(dx, left_nx), lanes_mul(dy, left_ny)), lanes_mul(dz, left_nz))), _s29));
    const V _s31 = lanes_add(lanes_mul(vx, _s30), lanes_add(_s7, lanes_select(_s17, lanes_neg(_s14), _s14)));
    const V _s32 = lanes_abs(_s31);
    const V _s33 = lanes_abs(dx);
    const V _s34 = lanes_abs(dy);
    const V _s35 = lanes_max(_s33, _s34);
    const V _s36 = lanes_abs(dz);
    const V _s37 = lanes_max(_s35, _s36);
    const V _s38 = lanes_abs(dvx);
    const V _s39 = lanes_abs(dvy);
    const V _s40 = lanes_max(_s38, _s39);
    const V _s41 = lanes_abs(dvz);
    const V _s42 = lanes_mul(t, lanes_max(_s40, _s41));
    const V _s43 = lanes_max(_s16, _s21);
    const V _s44 = lanes_max(_s14, _s20);
    const V _s45 = lanes_add(lanes_add(_s42, lanes_max(_s44, _s25)), _s37);
    const V _s46 = lanes_add(lanes_mul(lanes_mul(lanes_abs(_s29), _s4), lanes_add(lanes_mul(_s37, _s6), lanes_add(_s42, lanes_max(_s43, _s26)))), _s45);
    const V _s47 = lanes_div(K(1.0), lanes_add(K(8.0), lanes_mul(K(8.0), contacts)));
    const V _s48 = lanes_mul(_s46, _s47);
    const V _s49 = lanes_max(_s32, _s48);
    const M _s50 = lanes_less(_s6, K(0.25));
    const V _s51 = lanes_add(lanes_mul(vy, _s30), lanes_add(_s18, lanes_select(_s22, lanes_neg(_s20), _s20)));
    const V _s52 = lanes_abs(_s51);
    const V _s53 = lanes_max(_s52, _s48);
    const V _s54 = lanes_add(lanes_mul(vz, _s30), lanes_add(_s23, lanes_select(_s27, lanes_neg(_s25), _s25)));
    const V _s55 = lanes_abs(_s54);
    const V _s56 = lanes_max(_s55, _s48);
    const V _s57 = lanes_abs(_s30);
    const V _s58 = lanes_mul(K(0.0625), earliest_delay);
    return (LANES(court_carry_flight_out)){ lanes_select(_s50, _s31, lanes_select(lanes_less(_s31, K(0.0)), lanes_neg(_s49), _s49)), lanes_select(_s50, _s51, lanes_select(lanes_less(_s51, K(0.0)), lanes_neg(_s53), _s53)), lanes_select(_s50, _s54, lanes_select(lanes_less(_s54, K(0.0)), lanes_neg(_s56), _s56)), lanes_select(_s50, K(0.125), _s47), dvx, dvy, lanes_sub(dvz, lanes_mul(_c0, _s30)), lanes_add(lanes_mul(K(4.440892098500626e-16), lanes_add(t, clock)), lanes_max(_s57, _s58)), lanes_select(_s50, _s45, _s46) };
}

/* Errors of the state at the time limit, from those at the start of the flight.
   derivative of Eq. 3, with roundings. 64 operations: 20 additions, 18 multiplications, 1 negation, 13 absolute values, 6 comparisons, 6 selections. */
typedef struct {
    V dx, dy, dz, dvx, dvy, dvz, clock_error;
} LANES(court_carry_time_out);

LANES_INLINE LANES(court_carry_time_out)
LANES(court_carry_time)(V t, V x, V y, V z, V vx, V vy, V vz, V clock, V clock_error, V dx, V dy, V dz, V dvx, V dvy, V dvz, V _c0, V _c1)
{
    const V _s0 = lanes_abs(vx);
    const V _s1 = lanes_add(clock_error, lanes_mul(K(4.440892098500626e-16), lanes_add(t, clock)));
    const V _s2 = lanes_abs(dvx);
    const V _s3 = lanes_abs(dvy);
    const V _s4 = lanes_max(_s2, _s3);
    const V _s5 = lanes_abs(dvz);
    const V _s6 = lanes_mul(K(2.0), t);
    const V _s7 = lanes_add(K(7.888609052210118e-31), lanes_mul(K(1.1102230246251565e-16), lanes_add(lanes_mul(_s6, _s0), lanes_abs(x))));
    const V _s8 = lanes_abs(vy);
    const V _s9 = lanes_add(K(7.888609052210118e-31), lanes_mul(K(1.1102230246251565e-16), lanes_add(lanes_mul(_s6, _s8), lanes_abs(y))));
    const V _s10 = lanes_max(_s7, _s9);
    const V _s11 = lanes_abs(vz);
    const V _s12 = lanes_add(K(7.888609052210118e-31), lanes_mul(K(1.1102230246251565e-16), lanes_add(lanes_add(lanes_mul(_c0, lanes_mul(t, t)), lanes_mul(_s6, _s11)), lanes_abs(z))));
    const V _s13 = lanes_abs(dx);
    const V _s14 = lanes_abs(dy);
    const V _s15 = lanes_max(_s13, _s14);
    const V _s16 = lanes_abs(dz);
    const V _s17 = lanes_add(lanes_add(lanes_mul(t, lanes_max(_s4, _s5)), lanes_max(_s10, _s12)), lanes_max(_s15, _s16));
    return (LANES(court_carry_time_out)){ lanes_add(lanes_mul(_s0, _s1), _s17), lanes_add(lanes_mul(_s8, _s1), _s17), lanes_add(lanes_mul(_s11, _s1), _s17), lanes_add(lanes_add(_c1, lanes_mul(K(2.220446049250313e-16), _s0)), _s2), lanes_add(lanes_add(_c1, lanes_mul(K(2.220446049250313e-16), _s8)), _s3), lanes_add(lanes_add(lanes_mul(K(2.220446049250313e-16), _s11), _s5), lanes_abs(lanes_neg(lanes_mul(_c0, _s1)))), K(0.0) };
}

/* Bounds on the errors of state and time that decisions allow for.
   the carried errors times a factor. 30 operations: 4 multiplications, 9 absolute values, 7 comparisons, 10 selections. */
typedef struct {
    V position_error, velocity_error, spin_error, time_error;
} LANES(court_error_bounds_out);

LANES_INLINE LANES(court_error_bounds_out)
LANES(court_error_bounds)(V clock_error, V dx, V dy, V dz, V dvx, V dvy, V dvz, V dwx, V dwy, V dwz, V position_bound, V velocity_bound, V spin_bound, V estimated, V clock_bound)
{
    const V _s0 = lanes_abs(dx);
    const V _s1 = lanes_abs(dy);
    const V _s2 = lanes_max(_s0, _s1);
    const V _s3 = lanes_abs(dz);
    const M _s4 = lanes_less(K(0.0), estimated);
    const V _s5 = lanes_abs(dvx);
    const V _s6 = lanes_abs(dvy);
    const V _s7 = lanes_max(_s5, _s6);
    const V _s8 = lanes_abs(dvz);
    const V _s9 = lanes_abs(dwx);
    const V _s10 = lanes_abs(dwy);
    const V _s11 = lanes_max(_s9, _s10);
    const V _s12 = lanes_abs(dwz);
    return (LANES(court_error_bounds_out)){ lanes_select(_s4, lanes_mul(K(16.0), lanes_max(_s2, _s3)), position_bound), lanes_select(_s4, lanes_mul(K(16.0), lanes_max(_s7, _s8)), velocity_bound), lanes_select(_s4, lanes_mul(K(16.0), lanes_max(_s11, _s12)), spin_bound), lanes_select(_s4, lanes_mul(K(16.0), clock_error), clock_bound) };
}

/* Bounds on the errors of state and time that are reported.
   the carried errors times a larger factor. 30 operations: 4 multiplications, 9 absolute values, 7 comparisons, 10 selections. */
typedef struct {
    V position_error, velocity_error, spin_error, time_error;
} LANES(court_claimed_errors_out);

LANES_INLINE LANES(court_claimed_errors_out)
LANES(court_claimed_errors)(V clock_error, V dx, V dy, V dz, V dvx, V dvy, V dvz, V dwx, V dwy, V dwz, V position_bound, V velocity_bound, V spin_bound, V estimated, V clock_bound)
{
    const V _s0 = lanes_abs(dx);
    const V _s1 = lanes_abs(dy);
    const V _s2 = lanes_max(_s0, _s1);
    const V _s3 = lanes_abs(dz);
    const M _s4 = lanes_less(K(0.0), estimated);
    const V _s5 = lanes_abs(dvx);
    const V _s6 = lanes_abs(dvy);
    const V _s7 = lanes_max(_s5, _s6);
    const V _s8 = lanes_abs(dvz);
    const V _s9 = lanes_abs(dwx);
    const V _s10 = lanes_abs(dwy);
    const V _s11 = lanes_max(_s9, _s10);
    const V _s12 = lanes_abs(dwz);
    return (LANES(court_claimed_errors_out)){ lanes_select(_s4, lanes_mul(K(64.0), lanes_max(_s2, _s3)), position_bound), lanes_select(_s4, lanes_mul(K(64.0), lanes_max(_s7, _s8)), velocity_bound), lanes_select(_s4, lanes_mul(K(64.0), lanes_max(_s11, _s12)), spin_bound), lanes_select(_s4, lanes_mul(K(64.0), clock_error), clock_bound) };
}

/* 1 if finite parameters are allowed.
   the scene's requirements. 64 operations: 6 subtractions, 29 comparisons, 29 selections. */
typedef struct {
    V allowed;
} LANES(court_allowed_out);

LANES_INLINE LANES(court_allowed_out)
LANES(court_allowed)(const LANES(column) *p, size_t row)
{
    const V _s0 = lanes_select(lanes_less(K(0.0), lanes_sub(lanes_load(p[6] + row), lanes_load(p[5] + row))), lanes_select(lanes_less(K(0.0), lanes_sub(lanes_sub(lanes_load(p[3] + row), lanes_load(p[1] + row)), lanes_load(p[2] + row))), lanes_select(lanes_less(K(0.0), lanes_sub(lanes_sub(lanes_load(p[1] + row), lanes_load(p[0] + row)), lanes_load(p[2] + row))), K(1.0), K(0.0)), K(0.0)), K(0.0));
    V _v1 = lanes_select(lanes_less(K(0.0), lanes_sub(lanes_load(p[4] + row), lanes_load(p[8] + row))), _s0, K(0.0));
    static const int _t1[][1] = {
        {0},
        {1},
        {2},
        {3},
        {4},
        {7},
        {8},
        {9},
        {10},
        {11},
    };
    for (size_t _k1 = 0; _k1 < 10; _k1++) {
        _v1 = lanes_select(lanes_less(K(0.0), lanes_load(p[_t1[_k1][0]] + row)), _v1, K(0.0));
    }
    V _v4 = _v1;
    static const int _t4[][2] = {
        {12, 12},
        {13, 13},
        {14, 14},
    };
    for (size_t _k4 = 0; _k4 < 3; _k4++) {
        _v4 = lanes_select(lanes_at_most(K(0.0), lanes_load(p[_t4[_k4][0]] + row)), _v4, K(0.0));
        _v4 = lanes_select(lanes_at_most(lanes_load(p[_t4[_k4][1]] + row), K(1.0)), _v4, K(0.0));
    }
    const V _s7 = lanes_select(lanes_at_most(K(0.0), lanes_load(p[16] + row)), lanes_select(lanes_at_most(K(0.0), lanes_load(p[15] + row)), _v4, K(0.0)), K(0.0));
    const V _s8 = lanes_select(lanes_at_most(K(-1.0), lanes_load(p[19] + row)), lanes_select(lanes_at_most(lanes_load(p[18] + row), K(1.0)), lanes_select(lanes_at_most(K(0.015625), lanes_load(p[18] + row)), lanes_select(lanes_less(K(0.0), lanes_load(p[18] + row)), lanes_select(lanes_at_most(K(0.0), lanes_load(p[17] + row)), _s7, K(0.0)), K(0.0)), K(0.0)), K(0.0)), K(0.0));
    return (LANES(court_allowed_out)){ lanes_select(lanes_less(K(0.0), lanes_load(p[20] + row)), lanes_select(lanes_at_most(lanes_load(p[19] + row), K(1.0)), _s8, K(0.0)), K(0.0)) };
}

/* Whether the parameters are allowed, and no arithmetic with them over- or underflows.
   the range of numbers. 68 operations: 21 absolute values, 24 comparisons, 23 conjunctions. */
typedef struct {
    M permitted;
} LANES(court_parameters_in_range_out);

LANES_INLINE LANES(court_parameters_in_range_out)
LANES(court_parameters_in_range)(const LANES(column) *p, size_t row, V allowed)
{
    const V _s0 = lanes_abs(lanes_load(p[0] + row));
    const V _s1 = lanes_abs(lanes_load(p[10] + row));
    M _v2 = lanes_both(lanes_both(lanes_less(K(0.0), allowed), lanes_at_most(_s0, K(1073741824.0))), lanes_at_most(K(9.313225746154785e-10), _s0));
    static const int _t2[][1] = {
        {1},
        {2},
        {3},
        {4},
        {5},
        {6},
        {7},
        {8},
        {9},
        {10},
    };
    for (size_t _k2 = 0; _k2 < 10; _k2++) {
        _v2 = lanes_both(_v2, lanes_at_most(lanes_abs(lanes_load(p[_t2[_k2][0]] + row)), K(1073741824.0)));
    }
    const M _s5 = lanes_both(_v2, lanes_at_most(K(9.313225746154785e-10), _s1));
    const M _s6 = lanes_both(lanes_both(lanes_both(lanes_both(_s5, lanes_at_most(lanes_abs(lanes_load(p[11] + row)), K(1073741824.0))), lanes_at_most(lanes_abs(lanes_load(p[12] + row)), K(1.2676506002282294e+30))), lanes_at_most(lanes_abs(lanes_load(p[13] + row)), K(1.2676506002282294e+30))), lanes_at_most(lanes_abs(lanes_load(p[14] + row)), K(1.2676506002282294e+30)));
    const M _s7 = lanes_both(lanes_both(lanes_both(lanes_both(_s6, lanes_at_most(lanes_abs(lanes_load(p[15] + row)), K(INFINITY))), lanes_at_most(lanes_abs(lanes_load(p[16] + row)), K(INFINITY))), lanes_at_most(lanes_abs(lanes_load(p[17] + row)), K(INFINITY))), lanes_at_most(lanes_abs(lanes_load(p[18] + row)), K(1.2676506002282294e+30)));
    return (LANES(court_parameters_in_range_out)){ lanes_both(lanes_both(_s7, lanes_at_most(lanes_abs(lanes_load(p[19] + row)), K(1.2676506002282294e+30))), lanes_at_most(lanes_abs(lanes_load(p[20] + row)), K(INFINITY))) };
}

/* 1 if the ball overlaps no surface; 1 if that is undecided.
   Table 2. 105 operations: 14 additions, 18 subtractions, 12 multiplications, 3 square roots, 4 negations, 9 absolute values, 21 comparisons, 24 selections. */
typedef struct {
    V valid, undecided_time;
} LANES(court_valid_out);

LANES_INLINE LANES(court_valid_out)
LANES(court_valid)(V last, V x, V y, V z, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7, V _c8, V _c9, V _c10, V _c11, V _c12)
{
    const V _s0 = lanes_sub(lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y))), _c1);
    const V _s1 = lanes_sub(lanes_add(lanes_mul(z, z), lanes_mul(_s0, _s0)), _c8);
    const M _s2 = lanes_less(lanes_abs(last), K(0.5));
    const V _s3 = lanes_select(_s2, K(1.0), lanes_select(lanes_at_most(K(0.0), _s1), K(1.0), K(0.0)));
    const V _s4 = lanes_sub(z, _c6);
    const V _s5 = lanes_sub(_c5, z);
    const V _s6 = lanes_sub(lanes_max(_s4, K(0.0)), lanes_max(_s5, K(0.0)));
    const V _s7 = lanes_add(_c3, x);
    const V _s8 = lanes_neg(lanes_add(_c9, x));
    const V _s9 = lanes_sub(lanes_max(_s7, K(0.0)), lanes_max(_s8, K(0.0)));
    const V _s10 = lanes_sub(y, _c4);
    const V _s11 = lanes_neg(lanes_add(_c4, y));
    const V _s12 = lanes_sub(lanes_max(_s10, K(0.0)), lanes_max(_s11, K(0.0)));
    const V _s13 = lanes_sub(lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s6, _s6), lanes_mul(_s9, _s9)), lanes_mul(_s12, _s12))), _c0);
    const M _s14 = lanes_less(lanes_abs(lanes_sub(last, K(1.0))), K(0.5));
    const V _s15 = lanes_select(_s14, _s3, lanes_select(lanes_at_most(K(0.0), _s13), _s3, K(0.0)));
    const V _s16 = lanes_add(_c1, x);
    const V _s17 = lanes_neg(_s7);
    const V _s18 = lanes_sub(lanes_max(_s16, K(0.0)), lanes_max(_s17, K(0.0)));
    const V _s19 = lanes_sub(z, _c2);
    const V _s20 = lanes_sub(_c10, z);
    const V _s21 = lanes_sub(lanes_max(_s19, K(0.0)), lanes_max(_s20, K(0.0)));
    const V _s22 = lanes_sub(y, _c7);
    const V _s23 = lanes_neg(lanes_add(_c7, y));
    const V _s24 = lanes_sub(lanes_max(_s22, K(0.0)), lanes_max(_s23, K(0.0)));
    const V _s25 = lanes_sub(lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s18, _s18), lanes_mul(_s21, _s21)), lanes_mul(_s24, _s24))), _c0);
    const M _s26 = lanes_less(lanes_abs(lanes_sub(last, K(2.0))), K(0.5));
    const V _s27 = lanes_mul(K(1.7763568394002505e-15), lanes_add(lanes_add(lanes_add(_c12, lanes_abs(x)), lanes_abs(y)), lanes_abs(z)));
    const V _s28 = lanes_select(_s2, K(0.0), lanes_select(lanes_at_most(lanes_abs(_s1), lanes_mul(_c11, _s27)), K(1.0), K(0.0)));
    const V _s29 = lanes_select(_s14, _s28, lanes_select(lanes_at_most(lanes_abs(_s13), _s27), K(1.0), _s28));
    return (LANES(court_valid_out)){ lanes_select(_s26, _s15, lanes_select(lanes_at_most(K(0.0), _s25), _s15, K(0.0))), lanes_select(_s26, _s29, lanes_select(lanes_at_most(lanes_abs(_s25), _s27), K(1.0), _s29)) };
}

/* Whether the ball starts near a surface; otherwise its start is valid and decided.
   Table 2. 21 operations: 3 additions, 5 subtractions, 2 multiplications, 5 absolute values, 3 comparisons, 2 conjunctions, 1 complement. */
typedef struct {
    M close;
    V valid, undecided_time;
} LANES(court_aside_out);

LANES_INLINE LANES(court_aside_out)
LANES(court_aside)(V x, V y, V z, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_abs(x);
    const V _s1 = lanes_mul(K(8.0), lanes_mul(K(1.7763568394002505e-15), lanes_add(lanes_add(lanes_add(_c0, _s0), lanes_abs(y)), lanes_abs(z))));
    const M _s2 = lanes_both(lanes_both(lanes_less(_s1, lanes_sub(_s0, _c1)), lanes_less(_s1, lanes_sub(lanes_abs(lanes_sub(x, _c2)), _c3))), lanes_less(_s1, lanes_sub(lanes_abs(lanes_sub(x, _c4)), _c5)));
    return (LANES(court_aside_out)){ lanes_not(_s2), K(1.0), K(0.0) };
}

/* Whether a ball counts as fallen through the ring at its start.
   Table 2, success. 20 operations: 2 additions, 1 subtraction, 3 multiplications, 1 absolute value, 6 comparisons, 5 conjunctions, 2 selections. */
typedef struct {
    V through, uncertain;
} LANES(court_passing_start_out);

LANES_INLINE LANES(court_passing_start_out)
LANES(court_passing_start)(V last, V outcome, V uncertain, V x, V y, V z, V _c0, V _c1)
{
    const M _s0 = lanes_both(lanes_both(lanes_at_most(K(0.0), last), lanes_less(z, K(0.0))), lanes_at_most(_c0, z));
    const V _s1 = lanes_add(lanes_mul(x, x), lanes_mul(y, y));
    const V _s2 = lanes_select(lanes_both(lanes_both(_s0, lanes_at_most(lanes_abs(lanes_sub(_s1, _c1)), lanes_mul(K(8.881784197001252e-16), lanes_add(_c1, _s1)))), lanes_less(outcome, K(0.0))), K(1.0), uncertain);
    return (LANES(court_passing_start_out)){ lanes_select(lanes_both(_s0, lanes_less(_s1, _c1)), K(1.0), K(0.0)), _s2 };
}

/* 1 for a ball that fell through the ring's disc, -1 for one that came up, else 0.
   Eq. 3, its roots in the ring's plane. 62 operations: 9 additions, 2 subtractions, 15 multiplications, 1 square root, 16 comparisons, 9 conjunctions, 2 disjunctions, 8 selections. */
typedef struct {
    V through;
} LANES(court_passing_out);

LANES_INLINE LANES(court_passing_out)
LANES(court_passing)(V through, V t, V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1, V _c2, V _c3, V _c4)
{
    const M _s0 = lanes_less(z, K(0.0));
    const V _s1 = lanes_add(z, lanes_mul(t, lanes_sub(vz, lanes_mul(_c1, t))));
    const M _s2 = lanes_less(_s1, K(0.0));
    const V _s3 = lanes_add(lanes_mul(vz, vz), lanes_mul(_c2, z));
    const M _s4 = lanes_both(lanes_both(lanes_both(lanes_both(_s0, _s2), lanes_less(K(0.0), vz)), lanes_less(K(0.0), _s3)), lanes_less(vz, lanes_mul(_c0, t)));
    const V _s5 = lanes_sqrt(lanes_max(_s3, K(0.0)));
    const V _s6 = lanes_mul(lanes_add(vz, _s5), _c3);
    const V _s7 = lanes_max(K(0.0), _s6);
    const V _s8 = lanes_min(_s7, t);
    const V _s9 = lanes_add(x, lanes_mul(vx, _s8));
    const V _s10 = lanes_add(y, lanes_mul(vy, _s8));
    const V _s11 = lanes_mul(lanes_sub(vz, _s5), _c3);
    const V _s12 = lanes_max(K(0.0), _s11);
    const V _s13 = lanes_min(_s12, t);
    const V _s14 = lanes_add(x, lanes_mul(vx, _s13));
    const V _s15 = lanes_add(y, lanes_mul(vy, _s13));
    const V _s16 = lanes_select(lanes_both(lanes_either(_s4, lanes_both(_s0, lanes_at_most(K(0.0), _s1))), lanes_less(lanes_add(lanes_mul(_s14, _s14), lanes_mul(_s15, _s15)), _c4)), lanes_select(lanes_equal(through, K(1.0)), K(0.0), K(-1.0)), through);
    const V _s17 = lanes_select(lanes_both(lanes_both(lanes_either(_s4, lanes_both(_s2, lanes_at_most(K(0.0), z))), lanes_less(lanes_add(lanes_mul(_s9, _s9), lanes_mul(_s10, _s10)), _c4)), lanes_equal(_s16, K(0.0))), K(1.0), _s16);
    return (LANES(court_passing_out)){ _s17 };
}

/* Whether the passing of the disc lies within its error.
   running error analysis. 102 operations: 18 additions, 4 subtractions, 27 multiplications, 4 square roots, 6 absolute values, 20 comparisons, 11 conjunctions, 6 disjunctions, 6 selections. */
typedef struct {
    M undecided;
} LANES(court_passing_undecided_out);

LANES_INLINE LANES(court_passing_undecided_out)
LANES(court_passing_undecided)(V t, V x, V y, V z, V vx, V vy, V vz, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6)
{
    const V _s0 = lanes_add(z, lanes_mul(t, lanes_sub(vz, lanes_mul(_c2, t))));
    const V _s1 = lanes_mul(vz, vz);
    const V _s2 = lanes_mul(_c1, t);
    const V _s3 = lanes_add(speed, _s2);
    const V _s4 = lanes_mul(K(1.0009765625), lanes_add(lanes_add(position_error, lanes_mul(t, velocity_error)), lanes_mul(K(4.440892098500626e-16), lanes_add(extent, lanes_mul(t, _s3)))));
    const V _s5 = lanes_add(lanes_mul(K(8.881784197001252e-16), lanes_mul(_s1, _c3)), _s4);
    const M _s6 = lanes_less(z, K(0.0));
    const M _s7 = lanes_less(_s0, K(0.0));
    const M _s8 = lanes_both(lanes_both(_s6, _s7), lanes_less(K(0.0), vz));
    const V _s9 = lanes_add(_s1, lanes_mul(_c4, z));
    const V _s10 = lanes_sqrt(lanes_max(_s9, K(0.0)));
    const V _s11 = lanes_mul(lanes_add(vz, _s10), _c3);
    const V _s12 = lanes_max(K(0.0), _s11);
    const V _s13 = lanes_min(_s12, t);
    const V _s14 = lanes_add(x, lanes_mul(vx, _s13));
    const V _s15 = lanes_add(y, lanes_mul(vy, _s13));
    const V _s16 = lanes_sqrt(lanes_add(lanes_mul(_s14, _s14), lanes_mul(_s15, _s15)));
    const V _s17 = lanes_mul(lanes_sub(vz, _s10), _c3);
    const V _s18 = lanes_max(K(0.0), _s17);
    const V _s19 = lanes_min(_s18, t);
    const V _s20 = lanes_add(x, lanes_mul(vx, _s19));
    const V _s21 = lanes_add(y, lanes_mul(vy, _s19));
    const V _s22 = lanes_sqrt(lanes_add(lanes_mul(_s20, _s20), lanes_mul(_s21, _s21)));
    const V _s23 = lanes_mul(lanes_mul(K(1.0009765625), _s3), lanes_add(lanes_sqrt(lanes_mul(_c6, _s5)), lanes_mul(K(8.881784197001252e-16), lanes_add(t, lanes_mul(lanes_abs(vz), _c3)))));
    const V _s24 = lanes_add(_s23, _s4);
    const M _s25 = lanes_both(lanes_either(lanes_either(lanes_both(lanes_less(K(0.0), position_error), lanes_at_most(lanes_abs(z), position_error)), lanes_at_most(lanes_abs(_s0), _s5)), lanes_both(_s8, lanes_at_most(lanes_abs(_s9), lanes_mul(_c5, _s5)))), lanes_at_most(lanes_min(_s16, _s22), lanes_add(_c0, _s24)));
    const M _s26 = lanes_both(lanes_both(_s8, lanes_less(K(0.0), _s9)), lanes_less(vz, _s2));
    const M _s27 = lanes_either(_s25, lanes_either(lanes_both(lanes_either(_s26, lanes_both(_s6, lanes_at_most(K(0.0), _s0))), lanes_at_most(lanes_abs(lanes_sub(_s22, _c0)), _s24)), lanes_both(lanes_either(_s26, lanes_both(_s7, lanes_at_most(K(0.0), z))), lanes_at_most(lanes_abs(lanes_sub(_s16, _c0)), _s24))));
    return (LANES(court_passing_undecided_out)){ _s27 };
}

/* Whether a ball in contact is not below the ring's disc.
   Table 1. 1 operation: 1 comparison. */
typedef struct {
    M over;
} LANES(court_passing_from_out);

LANES_INLINE LANES(court_passing_from_out)
LANES(court_passing_from)(V z)
{
    return (LANES(court_passing_from_out)){ lanes_at_most(K(0.0), z) };
}

/* Passing of the ring's disc in a step in contact.
   Table 1. 17 operations: 1 addition, 2 multiplications, 5 comparisons, 5 conjunctions, 1 complement, 3 selections. */
typedef struct {
    V through;
} LANES(court_passing_in_contact_out);

LANES_INLINE LANES(court_passing_in_contact_out)
LANES(court_passing_in_contact)(V x, V y, V z, V through, M over, V _c0)
{
    const M _s0 = lanes_less(lanes_add(lanes_mul(x, x), lanes_mul(y, y)), _c0);
    const V _s1 = lanes_select(lanes_both(lanes_both(lanes_not(over), lanes_at_most(K(0.0), z)), _s0), lanes_select(lanes_equal(through, K(1.0)), K(0.0), K(-1.0)), through);
    return (LANES(court_passing_in_contact_out)){ lanes_select(lanes_both(lanes_both(lanes_both(over, lanes_less(z, K(0.0))), _s0), lanes_equal(_s1, K(0.0))), K(1.0), _s1) };
}

/* Boxes of the first and the second half of the flight until the horizon.
   Eq. 3, the chords of both and what it is off them. 59 operations: 21 additions, 5 subtractions, 25 multiplications, 1 negation, 5 absolute values, 1 comparison, 1 selection. */
typedef struct {
    V middle_x, reach_x, later_middle_x, later_reach_x, middle_y, reach_y, later_middle_y, later_reach_y, middle_z, reach_z, later_middle_z, later_reach_z;
} LANES(court_half_flight_boxes_out);

LANES_INLINE LANES(court_half_flight_boxes_out)
LANES(court_half_flight_boxes)(V horizon, V x, V y, V z, V vx, V vy, V vz, V extent, V speed, V position_error, V velocity_error, V earliest_delay, V pad, V _c0, V _c1, V _c2, V _c3)
{
    const V _s0 = lanes_mul(K(0.5), horizon);
    const V _s1 = lanes_mul(vx, _s0);
    const V _s2 = lanes_mul(K(0.5), _s1);
    const V _s3 = lanes_add(lanes_add(position_error, lanes_mul(horizon, velocity_error)), lanes_mul(K(9.313225746154785e-10), lanes_add(extent, lanes_mul(horizon, lanes_add(speed, lanes_mul(_c0, horizon))))));
    const V _s4 = lanes_select(lanes_less(pad, earliest_delay), K(INFINITY), _s3);
    const V _s5 = lanes_mul(K(1.0000000009313226), lanes_add(lanes_add(_c1, lanes_mul(K(0.5), lanes_abs(_s1))), _s4));
    const V _s6 = lanes_mul(vy, _s0);
    const V _s7 = lanes_mul(K(0.5), _s6);
    const V _s8 = lanes_mul(K(1.0000000009313226), lanes_add(lanes_add(_c1, lanes_mul(K(0.5), lanes_abs(_s6))), _s4));
    const V _s9 = lanes_mul(_c2, _s0);
    const V _s10 = lanes_mul(_s0, lanes_sub(vz, _s9));
    const V _s11 = lanes_neg(lanes_mul(_c3, lanes_mul(_s0, _s0)));
    const V _s12 = lanes_abs(_s11);
    const V _s13 = lanes_mul(_s0, lanes_sub(lanes_sub(vz, lanes_mul(_c0, _s0)), _s9));
    return (LANES(court_half_flight_boxes_out)){ lanes_add(x, _s2), _s5, lanes_add(_s2, lanes_add(x, _s1)), _s5, lanes_add(y, _s7), _s8, lanes_add(_s7, lanes_add(y, _s6)), _s8, lanes_sub(lanes_add(z, lanes_mul(K(0.5), _s10)), _s11), lanes_mul(K(1.0000000009313226), lanes_add(lanes_add(_s12, lanes_mul(K(0.5), lanes_abs(_s10))), _s4)), lanes_sub(lanes_add(lanes_mul(K(0.5), _s13), lanes_add(z, _s10)), _s11), lanes_mul(K(1.0000000009313226), lanes_add(lanes_add(_s12, lanes_mul(K(0.5), lanes_abs(_s13))), _s4)) };
}

/* Start value: no surface of this kind.
   Table 1. No operations. */
typedef struct {
    M of_this_kind;
} LANES(court_other_kind_out);

LANES_INLINE LANES(court_other_kind_out)
LANES(court_other_kind)(void)
{
    return (LANES(court_other_kind_out)){ mask_none() };
}

/* 1 if the flight starts on this surface.
   Table 1. 2 operations: 1 comparison, 1 selection. */
typedef struct {
    V leaving;
} LANES(court_left_out);

LANES_INLINE LANES(court_left_out)
LANES(court_left)(V index, V last)
{
    return (LANES(court_left_out)){ lanes_select(lanes_equal(last, index), K(1.0), K(0.0)) };
}

/* Whether a plane's only root is an arrival, the size of F'', and the nearest time.
   Table 1. 13 operations: 1 absolute value, 6 comparisons, 4 conjunctions, 1 disjunction, 1 selection. */
typedef struct {
    M arrives;
    V ceiling, nearest;
} LANES(court_plane_root_out);

LANES_INLINE LANES(court_plane_root_out)
LANES(court_plane_root)(V rate, V bend, V apex, V time)
{
    const M _s0 = lanes_both(lanes_both(lanes_either(lanes_less(rate, K(0.0)), lanes_both(lanes_both(lanes_at_most(rate, K(0.0)), lanes_less(bend, K(0.0))), lanes_equal(time, K(0.0)))), lanes_at_most(K(0.0), time)), lanes_less(time, K(INFINITY)));
    return (LANES(court_plane_root_out)){ _s0, lanes_abs(bend), lanes_select(_s0, time, apex) };
}

/* Whether an arrival may be the earliest within the delays.
   Table 1. 5 operations: 1 addition, 1 subtraction, 1 comparison, 1 conjunction, 1 complement. */
typedef struct {
    M possible;
} LANES(court_within_time_out);

LANES_INLINE LANES(court_within_time_out)
LANES(court_within_time)(V time, V when, V delay, V earliest_delay, M arrives)
{
    return (LANES(court_within_time_out)){ lanes_both(arrives, lanes_not(lanes_less(lanes_add(delay, earliest_delay), lanes_sub(time, when)))) };
}

/* Undecided time 0 if the largest gap from the start on is zero within its error.
   Table 1. 5 operations: 1 absolute value, 2 comparisons, 1 conjunction, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(court_apex_undecided_out);

LANES_INLINE LANES(court_apex_undecided_out)
LANES(court_apex_undecided)(V margin, V apex, V height, V undecided_time)
{
    return (LANES(court_apex_undecided_out)){ lanes_select(lanes_both(lanes_at_most(K(0.0), apex), lanes_at_most(lanes_abs(height), margin)), K(0.0), undecided_time) };
}

/* Earliest undecided time, with that of an undecided predicate.
   Table 1. 3 operations: 1 comparison, 1 conjunction, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(court_predicate_undecided_out);

LANES_INLINE LANES(court_predicate_undecided_out)
LANES(court_predicate_undecided)(V time, V undecided_time, M undecided)
{
    return (LANES(court_predicate_undecided_out)){ lanes_select(lanes_both(undecided, lanes_less(time, undecided_time)), time, undecided_time) };
}

/* Earliest undecided time, with that of an arrival whose crossing is not certain.
   Table 1. 6 operations: 2 comparisons, 2 conjunctions, 1 complement, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(court_crossing_undecided_out);

LANES_INLINE LANES(court_crossing_undecided_out)
LANES(court_crossing_undecided)(V clearance, V time, V undecided_time, M arrives)
{
    return (LANES(court_crossing_undecided_out)){ lanes_select(lanes_both(lanes_both(arrives, lanes_not(lanes_less(K(0.0), clearance))), lanes_less(time, undecided_time)), time, undecided_time) };
}

/* Earliest undecided time, with that of a tie; the delay of the earlier arrival.
   Table 1. 16 operations: 1 addition, 2 subtractions, 1 multiplication, 1 absolute value, 4 comparisons, 3 conjunctions, 4 selections. */
typedef struct {
    V undecided_time, earliest_delay;
} LANES(court_tie_undecided_out);

LANES_INLINE LANES(court_tie_undecided_out)
LANES(court_tie_undecided)(V time, V when, V delay, V earliest_delay, V undecided_time, M arrives)
{
    const V _s0 = lanes_add(delay, earliest_delay);
    const M _s1 = lanes_less(time, when);
    const V _s2 = lanes_select(_s1, time, when);
    const V _s3 = lanes_mul(K(0.5), _s2);
    const V _s4 = lanes_sub(_s2, lanes_min(_s3, _s0));
    const V _s5 = lanes_select(lanes_both(lanes_both(arrives, lanes_at_most(lanes_abs(lanes_sub(time, when)), _s0)), lanes_less(_s4, undecided_time)), _s4, undecided_time);
    return (LANES(court_tie_undecided_out)){ _s5, lanes_select(lanes_both(arrives, _s1), delay, earliest_delay) };
}

/* Time and surface of the earliest arrival, with this one.
   Table 1. 4 operations: 1 comparison, 1 conjunction, 2 selections. */
typedef struct {
    V when, which;
} LANES(court_earliest_out);

LANES_INLINE LANES(court_earliest_out)
LANES(court_earliest)(V index, V time, V when, V which, M arrives)
{
    const M _s0 = lanes_both(arrives, lanes_less(time, when));
    return (LANES(court_earliest_out)){ lanes_select(_s0, time, when), lanes_select(_s0, index, which) };
}

/* Start value: the surface is certainly missed.
   Table 1. No operations. */
typedef struct {
    V clear;
} LANES(court_missed_out);

LANES_INLINE LANES(court_missed_out)
LANES(court_missed)(void)
{
    return (LANES(court_missed_out)){ K(1.0) };
}

/* Start values of a search: its error budget, and no arrival.
   Table 1. No operations. */
typedef struct {
    V share, arrival;
    M certain;
} LANES(court_beginning_out);

LANES_INLINE LANES(court_beginning_out)
LANES(court_beginning)(void)
{
    return (LANES(court_beginning_out)){ K(2.9802322387695312e-08), K(INFINITY), mask_none() };
}

/* Undecided time 0 if errors exceed the budget of a search, or its bounds fail.
   Table 1. 7 operations: 1 multiplication, 3 comparisons, 2 disjunctions, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(court_out_of_budget_out);

LANES_INLINE LANES(court_out_of_budget_out)
LANES(court_out_of_budget)(V pad, V budget_exceeded, V earliest_delay, V undecided_time, V excess)
{
    return (LANES(court_out_of_budget_out)){ lanes_select(lanes_either(lanes_either(lanes_less(K(0.0), excess), lanes_less(pad, lanes_mul(K(0.5), earliest_delay))), lanes_less(K(0.0), budget_exceeded)), K(0.0), undecided_time) };
}

/* Undecided time 0 if errors exceed the budget of an open window, or its bounds fail.
   Table 1. 8 operations: 1 multiplication, 3 comparisons, 1 conjunction, 2 disjunctions, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(court_out_of_budget_in_windows_out);

LANES_INLINE LANES(court_out_of_budget_in_windows_out)
LANES(court_out_of_budget_in_windows)(V pad, V budget_exceeded, V earliest_delay, V undecided_time, V excess, M searching)
{
    const V _s0 = lanes_select(lanes_either(lanes_both(searching, lanes_either(lanes_less(K(0.0), excess), lanes_less(pad, lanes_mul(K(0.5), earliest_delay)))), lanes_less(K(0.0), budget_exceeded)), K(0.0), undecided_time);
    return (LANES(court_out_of_budget_in_windows_out)){ _s0 };
}

/* Undecided time 0 if the earliest arrival may be after the horizon.
   Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(court_overdue_out);

LANES_INLINE LANES(court_overdue_out)
LANES(court_overdue)(V pad, V earliest_delay, V undecided_time)
{
    return (LANES(court_overdue_out)){ lanes_select(lanes_less(pad, lanes_mul(K(0.5), earliest_delay)), K(0.0), undecided_time) };
}

/* 1 near the surface that the ball left, where F/t is more exact than F; the margin.
   Table 1. 6 operations: 1 multiplication, 2 comparisons, 1 conjunction, 2 selections. */
typedef struct {
    V leaving, margin;
} LANES(court_nearby_out);

LANES_INLINE LANES(court_nearby_out)
LANES(court_nearby)(V t, V flat, V tilt, V index, V last)
{
    const V _s0 = lanes_mul(t, tilt);
    const M _s1 = lanes_both(lanes_equal(last, index), lanes_less(_s0, flat));
    return (LANES(court_nearby_out)){ lanes_select(_s1, K(1.0), K(0.0)), lanes_select(_s1, _s0, flat) };
}

/* Begin of the first window and end of the last one, from single precision.
   Table 1. No operations. */
typedef struct {
    V time, latest;
} LANES(court_opened_out);

LANES_INLINE LANES(court_opened_out)
LANES(court_opened)(V horizon, V time)
{
    return (LANES(court_opened_out)){ time, horizon };
}

/* Whether a search begins in single precision; its ceiling, margins and error budget.
   Table 1. 6 operations: 3 conjunctions, 1 disjunction, 1 complement, 1 selection. */
typedef struct {
    M stepping, searching, single_precision;
    V ceiling, flat, tilt, allowing;
} LANES(court_coarse_out);

LANES_INLINE LANES(court_coarse_out)
LANES(court_coarse)(V rate_margin, V flat, V ceiling, V share, M searching, M representable, M fits)
{
    const M _s0 = lanes_both(lanes_both(searching, representable), fits);
    return (LANES(court_coarse_out)){ _s0, lanes_either(searching, lanes_not(representable)), _s0, ceiling, flat, rate_margin, lanes_select(lanes_both(representable, fits), share, K(2.9802322387695312e-08)) };
}

/* Root from the search in single precision; whether and where the search goes on.
   Table 1. 7 operations: 1 addition, 1 comparison, 2 conjunctions, 1 complement, 2 selections. */
typedef struct {
    V arrival, t;
    M searching;
} LANES(court_stepped_out);

LANES_INLINE LANES(court_stepped_out)
LANES(court_stepped)(V arrival, V lasting, M searching, V since, M single_precision, M certain)
{
    const V _s0 = lanes_add(lasting, since);
    return (LANES(court_stepped_out)){ lanes_select(certain, _s0, arrival), lanes_select(single_precision, _s0, K(0.0)), lanes_both(lanes_both(searching, lanes_not(certain)), lanes_less(lasting, K(INFINITY))) };
}

/* Whether the gap closes, certainly closes, or needs a smaller error budget.
   Table 1. 17 operations: 1 subtraction, 6 comparisons, 6 conjunctions, 2 disjunctions, 2 complements. */
typedef struct {
    M hit, sure, needs_refinement;
} LANES(court_gap_closes_out);

LANES_INLINE LANES(court_gap_closes_out)
LANES(court_gap_closes)(V gap, V rate, V bend, V margin, V rate_margin, V clearance, V share)
{
    const M _s0 = lanes_either(lanes_less(rate, K(0.0)), lanes_both(lanes_at_most(rate, rate_margin), lanes_less(bend, K(0.0))));
    const M _s1 = lanes_less(K(0.0), clearance);
    const M _s2 = lanes_both(_s0, lanes_either(lanes_at_most(lanes_sub(gap, margin), margin), _s1));
    const M _s3 = lanes_both(_s0, _s1);
    const M _s4 = lanes_both(lanes_both(_s2, lanes_not(_s3)), lanes_less(K(0.0), share));
    return (LANES(court_gap_closes_out)){ lanes_both(_s2, lanes_not(_s4)), _s3, _s4 };
}

/* Whether the gap closes; a step that moves nothing needs a smaller budget, too.
   Table 1. 25 operations: 1 subtraction, 8 comparisons, 9 conjunctions, 3 disjunctions, 4 complements. */
typedef struct {
    M hit, sure, needs_refinement;
} LANES(court_gap_closes_or_stalls_out);

LANES_INLINE LANES(court_gap_closes_or_stalls_out)
LANES(court_gap_closes_or_stalls)(V t, V end, V gap, V rate, V bend, V margin, V rate_margin, V next, V clearance, V share)
{
    const M _s0 = lanes_either(lanes_less(rate, K(0.0)), lanes_both(lanes_at_most(rate, rate_margin), lanes_less(bend, K(0.0))));
    const M _s1 = lanes_less(K(0.0), clearance);
    const M _s2 = lanes_both(_s0, lanes_either(lanes_at_most(lanes_sub(gap, margin), margin), _s1));
    const M _s3 = lanes_both(_s0, _s1);
    const M _s4 = lanes_less(K(0.0), share);
    const M _s5 = lanes_both(lanes_both(_s2, lanes_not(_s3)), _s4);
    const M _s6 = lanes_either(_s5, lanes_both(lanes_both(lanes_not(_s2), lanes_both(lanes_less(t, end), lanes_not(lanes_less(t, next)))), _s4));
    return (LANES(court_gap_closes_or_stalls_out)){ lanes_both(_s2, lanes_not(_s5)), _s3, _s6 };
}

/* Next smaller error budget.
   Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection. */
typedef struct {
    V share;
} LANES(court_smaller_budget_out);

LANES_INLINE LANES(court_smaller_budget_out)
LANES(court_smaller_budget)(V share)
{
    return (LANES(court_smaller_budget_out)){ lanes_select(lanes_less(K(2.842170943040401e-14), share), lanes_mul(K(0.03125), share), K(0.0)) };
}

/* Earliest undecided time, with the present one if the errors exceed the budget.
   Table 1. 4 operations: 2 comparisons, 1 conjunction, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(court_budget_undecided_out);

LANES_INLINE LANES(court_budget_undecided_out)
LANES(court_budget_undecided)(V t, V undecided_time, V excess)
{
    return (LANES(court_budget_undecided_out)){ lanes_select(lanes_both(lanes_less(K(0.0), excess), lanes_less(t, undecided_time)), t, undecided_time) };
}

/* Root, time and state of a search after a step, and whether its window is exhausted.
   Table 1. 14 operations: 1 subtraction, 1 comparison, 4 conjunctions, 2 disjunctions, 3 complements, 3 selections. */
typedef struct {
    V arrival;
    M certain, exhausted, searching;
    V t;
} LANES(court_advanced_out);

LANES_INLINE LANES(court_advanced_out)
LANES(court_advanced)(V t, V end, V step, V next, V arrival, M hit, M sure, M needs_refinement, M certain)
{
    const M _s0 = lanes_not(hit);
    const M _s1 = lanes_both(lanes_both(_s0, lanes_not(needs_refinement)), lanes_at_most(lanes_sub(end, t), step));
    return (LANES(court_advanced_out)){ lanes_select(hit, lanes_select(sure, next, t), arrival), lanes_either(certain, lanes_both(hit, sure)), _s1, lanes_both(_s0, lanes_not(_s1)), lanes_select(lanes_either(hit, needs_refinement), t, next) };
}

/* Whether a search found an arrival.
   Table 1. 1 operation: 1 comparison. */
typedef struct {
    M arrives, refining;
    V rate;
} LANES(court_found_out);

LANES_INLINE LANES(court_found_out)
LANES(court_found)(V arrival)
{
    const M _s0 = lanes_less(arrival, K(INFINITY));
    return (LANES(court_found_out)){ _s0, _s0, K(0.0) };
}

/* A root or a return that is not certain, refined, and whether it is refined again.
   Table 1. 11 operations: 3 multiplications, 1 absolute value, 3 comparisons, 2 conjunctions, 1 disjunction, 1 selection. */
typedef struct {
    V arrival;
    M refining;
} LANES(court_refined_return_out);

LANES_INLINE LANES(court_refined_return_out)
LANES(court_refined_return)(V leaving, V gap, V rate, V ceiling, V arrival, V refined, M certain)
{
    const M _s0 = lanes_either(certain, lanes_both(lanes_less(K(0.0), leaving), lanes_less(rate, K(0.0))));
    return (LANES(court_refined_return_out)){ lanes_select(_s0, refined, arrival), lanes_both(_s0, lanes_less(lanes_mul(K(5.960464477539063e-08), lanes_mul(rate, rate)), lanes_mul(ceiling, lanes_abs(gap)))) };
}

/* Margin of the form, F or F/t, in which an arrival was found.
   Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection. */
typedef struct {
    V margin;
} LANES(court_own_margin_out);

LANES_INLINE LANES(court_own_margin_out)
LANES(court_own_margin)(V leaving, V flat, V tilt, V arrival)
{
    return (LANES(court_own_margin_out)){ lanes_select(lanes_less(K(0.0), leaving), lanes_mul(tilt, arrival), flat) };
}

/* Time of an arrival, not before the flight.
   Table 1. 2 operations: 1 comparison, 1 selection. */
typedef struct {
    V time;
} LANES(court_arrival_time_out);

LANES_INLINE LANES(court_arrival_time_out)
LANES(court_arrival_time)(V arrival)
{
    return (LANES(court_arrival_time_out)){ lanes_select(lanes_less(arrival, K(0.0)), K(0.0), arrival) };
}

/* Delay of a certain arrival; the earliest undecided time, with where the search of any other one stands, which may have been refined since.
   Table 1. 12 operations: 1 subtraction, 3 comparisons, 3 conjunctions, 1 complement, 4 selections. */
typedef struct {
    V delay, undecided_time;
} LANES(court_return_certainty_out);

LANES_INLINE LANES(court_return_certainty_out)
LANES(court_return_certainty)(V t, V clearance, V time, V delay, V undecided_time, M arrives, M certain)
{
    const M _s0 = lanes_both(certain, lanes_less(K(0.0), clearance));
    const V _s1 = lanes_select(certain, lanes_sub(time, delay), lanes_min(time, t));
    return (LANES(court_return_certainty_out)){ lanes_select(_s0, delay, K(0.0)), lanes_select(lanes_both(lanes_both(arrives, lanes_not(_s0)), lanes_less(_s1, undecided_time)), _s1, undecided_time) };
}

/* Start values: the ball is outside the surface, and not known to begin at it.
   Table 1. No operations. */
typedef struct {
    V side, gap_at_start;
} LANES(court_outside_out);

LANES_INLINE LANES(court_outside_out)
LANES(court_outside)(void)
{
    return (LANES(court_outside_out)){ K(1.0), K(INFINITY) };
}

/* Whether all numbers of a release are small enough not to overflow.
   Table 1. 26 operations: 9 absolute values, 9 comparisons, 8 conjunctions. */
typedef struct {
    M in_range;
} LANES(court_state_in_range_out);

LANES_INLINE LANES(court_state_in_range_out)
LANES(court_state_in_range)(V x, V y, V z, V vx, V vy, V vz, V wx, V wy, V wz)
{
    const M _s0 = lanes_both(lanes_both(lanes_both(lanes_both(lanes_at_most(lanes_abs(x), K(1073741824.0)), lanes_at_most(lanes_abs(y), K(1073741824.0))), lanes_at_most(lanes_abs(z), K(1073741824.0))), lanes_at_most(lanes_abs(vx), K(1073741824.0))), lanes_at_most(lanes_abs(vy), K(1073741824.0)));
    const M _s1 = lanes_both(lanes_both(lanes_both(lanes_both(_s0, lanes_at_most(lanes_abs(vz), K(1073741824.0))), lanes_at_most(lanes_abs(wx), K(1073741824.0))), lanes_at_most(lanes_abs(wy), K(1073741824.0))), lanes_at_most(lanes_abs(wz), K(1073741824.0)));
    return (LANES(court_state_in_range_out)){ _s1 };
}

/* Start values: no arrival; an uncertain shot if its errors are not bounded.
   Table 1. 6 operations: 3 comparisons, 2 conjunctions, 1 selection. */
typedef struct {
    V when, which, earliest_delay, undecided_time;
} LANES(court_opening_out);

LANES_INLINE LANES(court_opening_out)
LANES(court_opening)(V excess, V position_error, V velocity_error)
{
    return (LANES(court_opening_out)){ K(INFINITY), K(-1.0), K(0.0), lanes_select(lanes_both(lanes_both(lanes_less(position_error, K(INFINITY)), lanes_less(velocity_error, K(INFINITY))), lanes_at_most(excess, K(0.0))), K(INFINITY), K(0.0)) };
}

/* Whether there is a time limit.
   Table 1. 1 operation: 1 comparison. */
typedef struct {
    M limited;
} LANES(court_limited_out);

LANES_INLINE LANES(court_limited_out)
LANES(court_limited)(V time_limit)
{
    return (LANES(court_limited_out)){ lanes_less(time_limit, K(INFINITY)) };
}

/* Time of the event.
   Table 1. 1 operation: 1 addition. */
typedef struct {
    V clock;
} LANES(court_event_clock_out);

LANES_INLINE LANES(court_event_clock_out)
LANES(court_event_clock)(V when, V clock)
{
    return (LANES(court_event_clock_out)){ lanes_add(when, clock) };
}

/* Whether an event changes the motion, or its errors are wanted.
   Table 1. 3 operations: 1 comparison, 1 conjunction, 1 disjunction. */
typedef struct {
    M meeting;
} LANES(court_meeting_out);

LANES_INLINE LANES(court_meeting_out)
LANES(court_meeting)(V claims, M ends, M touches)
{
    return (LANES(court_meeting_out)){ lanes_either(touches, lanes_both(ends, lanes_less(K(0.0), claims))) };
}

/* Whether the event is on a surface.
   Table 1. 1 operation: 1 comparison. */
typedef struct {
    M here;
} LANES(court_here_out);

LANES_INLINE LANES(court_here_out)
LANES(court_here)(V index, V which)
{
    return (LANES(court_here_out)){ lanes_equal(which, index) };
}

/* One more contact.
   Table 1. 1 operation: 1 addition. */
typedef struct {
    V count;
} LANES(court_counted_out);

LANES_INLINE LANES(court_counted_out)
LANES(court_counted)(V count)
{
    return (LANES(court_counted_out)){ lanes_add(K(1.0), count) };
}

/* Start value: another surface.
   Table 1. No operations. */
typedef struct {
    V curving;
} LANES(court_elsewhere_out);

LANES_INLINE LANES(court_elsewhere_out)
LANES(court_elsewhere)(void)
{
    return (LANES(court_elsewhere_out)){ K(INFINITY) };
}

/* 1 if the flight began on the surface that the ball meets.
   Table 1. 2 operations: 1 comparison, 1 selection. */
typedef struct {
    V back;
} LANES(court_came_back_out);

LANES_INLINE LANES(court_came_back_out)
LANES(court_came_back)(V last, V which)
{
    return (LANES(court_came_back_out)){ lanes_select(lanes_equal(last, which), K(1.0), K(0.0)) };
}

/* Whether the ball meets the same surface again.
   Table 1. 3 operations: 2 comparisons, 1 conjunction. */
typedef struct {
    M again;
} LANES(court_again_out);

LANES_INLINE LANES(court_again_out)
LANES(court_again)(V index, V last, V which)
{
    return (LANES(court_again_out)){ lanes_both(lanes_equal(which, index), lanes_equal(last, which)) };
}

/* Body touched first and surface touched last.
   Table 1. 2 operations: 1 comparison, 1 selection. */
typedef struct {
    V first, last;
} LANES(court_touched_out);

LANES_INLINE LANES(court_touched_out)
LANES(court_touched)(V which, V body, V first)
{
    return (LANES(court_touched_out)){ lanes_select(lanes_less(first, K(0.0)), body, first), which };
}

/* Whether a shot has ended at the time limit and its errors are wanted.
   Table 1. 3 operations: 2 comparisons, 1 conjunction. */
typedef struct {
    M ends_by_time_limit;
} LANES(court_ends_by_time_limit_out);

LANES_INLINE LANES(court_ends_by_time_limit_out)
LANES(court_ends_by_time_limit)(V index, V which, V claims)
{
    return (LANES(court_ends_by_time_limit_out)){ lanes_both(lanes_equal(which, index), lanes_less(K(0.0), claims)) };
}

/* 1 if a decision within a contact lies within its error.
   Table 1. 1 operation: 1 selection. */
typedef struct {
    V uncertain;
} LANES(court_undecided_out);

LANES_INLINE LANES(court_undecided_out)
LANES(court_undecided)(V uncertain, M undecided)
{
    return (LANES(court_undecided_out)){ lanes_select(undecided, K(1.0), uncertain) };
}

/* Body that the event is on.
   Table 1. No operations. */
typedef struct {
    V body;
} LANES(court_body_of_out);

LANES_INLINE LANES(court_body_of_out)
LANES(court_body_of)(V which)
{
    return (LANES(court_body_of_out)){ which };
}

/* Outcome of a shot at its start, and whether that is uncertain.
   Table 1. 7 operations: 2 comparisons, 3 conjunctions, 2 selections. */
typedef struct {
    V outcome, uncertain;
} LANES(court_admitted_out);

LANES_INLINE LANES(court_admitted_out)
LANES(court_admitted)(V undecided_time, V valid, M permitted, M in_range)
{
    const M _s0 = lanes_both(permitted, in_range);
    return (LANES(court_admitted_out)){ lanes_select(lanes_both(_s0, lanes_less(K(0.0), valid)), K(-1.0), K(4.0)), lanes_select(lanes_both(_s0, lanes_less(K(0.0), undecided_time)), K(1.0), K(0.0)) };
}

/* The time limit as an arrival.
   Table 1. 12 operations: 2 additions, 1 subtraction, 1 multiplication, 4 comparisons, 1 conjunction, 1 complement, 2 selections. */
typedef struct {
    V time, delay;
    M arrives;
    V undecided_time;
} LANES(court_expiry_out);

LANES_INLINE LANES(court_expiry_out)
LANES(court_expiry)(V when, V which, V earliest_delay, V undecided_time, V time_error, V clock, V time_limit)
{
    const V _s0 = lanes_sub(time_limit, clock);
    return (LANES(court_expiry_out)){ lanes_max(K(0.0), _s0), lanes_add(time_error, lanes_mul(K(4.440892098500626e-16), time_limit)), lanes_at_most(K(0.0), which), lanes_select(lanes_both(lanes_not(lanes_less(lanes_add(when, earliest_delay), undecided_time)), lanes_less(undecided_time, K(INFINITY))), K(0.0), undecided_time) };
}

/* Whether there is no event, an end, or a contact, and the outcome without one.
   Table 1. 5 operations: 3 comparisons, 1 conjunction, 1 complement. */
typedef struct {
    M stays, moves, ends, touches;
    V reached;
    M edge;
} LANES(court_departed_out);

LANES_INLINE LANES(court_departed_out)
LANES(court_departed)(V index, V which)
{
    const M _s0 = lanes_less(which, K(0.0));
    const M _s1 = lanes_not(_s0);
    return (LANES(court_departed_out)){ _s0, _s1, lanes_at_most(index, which), lanes_both(_s1, lanes_less(which, index)), K(3.0), mask_none() };
}

/* Time, body and outcome of a shot that the time limit ends.
   Table 1. 6 operations: 1 comparison, 1 conjunction, 1 complement, 3 selections. */
typedef struct {
    V clock, body, reached;
    M ends;
} LANES(court_expired_out);

LANES_INLINE LANES(court_expired_out)
LANES(court_expired)(V index, V which, V body, V clock, V reached, V time_limit, M ends)
{
    const M _s0 = lanes_equal(which, index);
    return (LANES(court_expired_out)){ lanes_select(_s0, time_limit, clock), lanes_select(_s0, K(3.0), body), lanes_select(_s0, K(6.0), reached), lanes_both(ends, lanes_not(_s0)) };
}

/* Number of contacts, and the outcome if the shot ends.
   Table 1. 5 operations: 1 addition, 1 comparison, 3 selections. */
typedef struct {
    V contacts, outcome;
} LANES(court_accounted_out);

LANES_INLINE LANES(court_accounted_out)
LANES(court_accounted)(V contacts, V most_contacts, V reached, M touches)
{
    const V _s0 = lanes_add(K(1.0), contacts);
    return (LANES(court_accounted_out)){ lanes_select(touches, _s0, contacts), lanes_select(touches, lanes_select(lanes_at_most(most_contacts, _s0), K(2.0), K(-1.0)), reached) };
}

/* Sum of the errors of the contacts' times.
   Table 1. 1 operation: 1 addition. */
typedef struct {
    V clock_error;
} LANES(court_clock_error_sum_out);

LANES_INLINE LANES(court_clock_error_sum_out)
LANES(court_clock_error_sum)(V delay, V clock_error)
{
    return (LANES(court_clock_error_sum_out)){ lanes_add(delay, clock_error) };
}

/* Whether bounds on errors are wanted here, and their start values.
   Table 1. 5 operations: 3 comparisons, 1 conjunction, 1 disjunction. */
typedef struct {
    M reports;
    V position_claim, velocity_claim, spin_claim, time_claim;
} LANES(court_closing_out);

LANES_INLINE LANES(court_closing_out)
LANES(court_closing)(V outcome, V claims)
{
    return (LANES(court_closing_out)){ lanes_either(lanes_both(lanes_less(K(0.0), claims), lanes_at_most(K(0.0), outcome)), lanes_less(K(1.0), claims)), K(0.0), K(0.0), K(0.0), K(0.0) };
}

/* Errors at the end, not below the largest that one flight can cause.
   Table 1. 9 operations: 3 absolute values, 3 comparisons, 3 selections. */
typedef struct {
    V dx, dy, dz;
} LANES(court_error_floor_out);

LANES_INLINE LANES(court_error_floor_out)
LANES(court_error_floor)(V dx, V dy, V dz, V shift)
{
    return (LANES(court_error_floor_out)){ lanes_select(lanes_less(lanes_abs(dx), shift), shift, dx), lanes_select(lanes_less(lanes_abs(dy), shift), shift, dy), lanes_select(lanes_less(lanes_abs(dz), shift), shift, dz) };
}

/* Start values: a normal without error.
   Table 1. No operations. */
typedef struct {
    V dnx, dny, dnz, turn;
} LANES(court_no_normal_error_out);

LANES_INLINE LANES(court_no_normal_error_out)
LANES(court_no_normal_error)(void)
{
    return (LANES(court_no_normal_error_out)){ K(0.0), K(0.0), K(0.0), K(0.0) };
}

/* Whether a ball in contact rolls on the ring.
   Table 1. 4 operations: 1 comparison, 2 conjunctions, 1 complement. */
typedef struct {
    M circling, rolling;
} LANES(court_circles_out);

LANES_INLINE LANES(court_circles_out)
LANES(court_circles)(V index, V held, M rolling)
{
    const M _s0 = lanes_equal(held, index);
    return (LANES(court_circles_out)){ lanes_both(rolling, _s0), lanes_both(rolling, lanes_not(_s0)) };
}

/* Half a step, from the start and from the end.
   Table 1. 2 operations: 1 multiplication, 1 negation. */
typedef struct {
    V forth, back;
} LANES(court_half_steps_out);

LANES_INLINE LANES(court_half_steps_out)
LANES(court_half_steps)(V stride)
{
    const V _s0 = lanes_mul(K(0.5), stride);
    return (LANES(court_half_steps_out)){ _s0, lanes_neg(_s0) };
}

/* Distance from the nearest other surface, at any azimuth.
   tangents. 6 operations: 1 addition, 1 multiplication, 2 comparisons, 2 selections. */
typedef struct {
    V azimuth_clearance;
} LANES(court_clearance_at_any_azimuth_out);

LANES_INLINE LANES(court_clearance_at_any_azimuth_out)
LANES(court_clearance_at_any_azimuth)(V gap, V nearing, V half_step, V azimuth_clearance)
{
    const V _s0 = lanes_mul(nearing, half_step);
    const V _s1 = lanes_add(gap, lanes_min(_s0, K(0.0)));
    return (LANES(court_clearance_at_any_azimuth_out)){ lanes_min(_s1, azimuth_clearance) };
}

/* Event: the ball certainly rolls for ever.
   Table 1. 1 operation: 1 selection. */
typedef struct {
    V which;
} LANES(court_rolls_for_ever_out);

LANES_INLINE LANES(court_rolls_for_ever_out)
LANES(court_rolls_for_ever)(V which, M endless)
{
    return (LANES(court_rolls_for_ever_out)){ lanes_select(endless, K(8.0), which) };
}

/* Whether a ball goes on in contact, on whichever surface.
   Table 1. 1 operation: 1 disjunction. */
typedef struct {
    M rolling;
} LANES(court_still_in_contact_out);

LANES_INLINE LANES(court_still_in_contact_out)
LANES(court_still_in_contact)(M rolling, M circling)
{
    return (LANES(court_still_in_contact_out)){ lanes_either(rolling, circling) };
}

/* Coefficients of order 1 of a rolling ball, from those of lower order.
   Newton, Euler and rolling without slip. 42 operations: 7 additions, 5 subtractions, 29 multiplications, 1 negation. */
typedef struct {
    V lift_0, tx_0, ty_0, tz_0, vx_1, vy_1, vz_1, nx_1, ny_1, nz_1, turn_rate_1;
} LANES(court_roll_0_out);

LANES_INLINE LANES(court_roll_0_out)
LANES(court_roll_0)(V nx_0, V ny_0, V nz_0, V vx_0, V vy_0, V vz_0, V bent_x, V bent_y, V bent_z, V per_reach, V turn_rate_0, V _c0, V _c1, V _c2, V _c3)
{
    const V _s0 = lanes_mul(lanes_mul(vx_0, bent_x), per_reach);
    const V _s1 = lanes_mul(lanes_mul(vy_0, bent_y), per_reach);
    const V _s2 = lanes_mul(lanes_mul(vz_0, bent_z), per_reach);
    const V _s3 = lanes_sub(lanes_mul(lanes_mul(_c0, nz_0), _c1), lanes_add(lanes_add(lanes_mul(vx_0, _s0), lanes_mul(vy_0, _s1)), lanes_mul(vz_0, _s2)));
    const V _s4 = lanes_sub(lanes_mul(ny_0, _s2), lanes_mul(nz_0, _s1));
    const V _s5 = lanes_sub(lanes_mul(nz_0, _s0), lanes_mul(nx_0, _s2));
    const V _s6 = lanes_sub(lanes_mul(nx_0, _s1), lanes_mul(ny_0, _s0));
    return (LANES(court_roll_0_out)){ _s3, _s4, _s5, _s6, lanes_add(lanes_mul(_c2, lanes_mul(turn_rate_0, _s4)), lanes_mul(nx_0, _s3)), lanes_add(lanes_mul(_c2, lanes_mul(turn_rate_0, _s5)), lanes_mul(ny_0, _s3)), lanes_sub(lanes_add(lanes_mul(_c2, lanes_mul(turn_rate_0, _s6)), lanes_mul(nz_0, _s3)), _c3), _s0, _s1, _s2, lanes_neg(lanes_add(lanes_add(lanes_mul(vx_0, _s4), lanes_mul(vy_0, _s5)), lanes_mul(vz_0, _s6))) };
}

/* Coefficients of order 2 of a rolling ball, from those of lower order.
   Newton, Euler and rolling without slip. 81 operations: 25 additions, 4 subtractions, 51 multiplications, 1 negation. */
typedef struct {
    V lift_1, tx_1, ty_1, tz_1, vx_2, vy_2, vz_2, nx_2, ny_2, nz_2, turn_rate_2;
} LANES(court_roll_1_out);

LANES_INLINE LANES(court_roll_1_out)
LANES(court_roll_1)(V nx_0, V nx_1, V ny_0, V ny_1, V nz_0, V nz_1, V vx_0, V vx_1, V vy_0, V vy_1, V vz_0, V vz_1, V bent_x, V bent_y, V bent_z, V per_reach, V turn_rate_0, V turn_rate_1, V lift_0, V tx_0, V ty_0, V tz_0, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_mul(lanes_mul(vx_1, bent_x), per_reach);
    const V _s1 = lanes_mul(lanes_mul(vy_1, bent_y), per_reach);
    const V _s2 = lanes_mul(lanes_mul(vz_1, bent_z), per_reach);
    const V _s3 = lanes_sub(lanes_mul(lanes_mul(_c0, nz_1), _c1), lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, vx_1), lanes_mul(vx_0, _s0)), lanes_add(lanes_mul(ny_1, vy_1), lanes_mul(vy_0, _s1))), lanes_add(lanes_mul(nz_1, vz_1), lanes_mul(vz_0, _s2))));
    const V _s4 = lanes_mul(ny_1, nz_1);
    const V _s5 = lanes_sub(lanes_add(lanes_mul(ny_0, _s2), _s4), lanes_add(_s4, lanes_mul(nz_0, _s1)));
    const V _s6 = lanes_mul(nx_1, nz_1);
    const V _s7 = lanes_sub(lanes_add(_s6, lanes_mul(nz_0, _s0)), lanes_add(lanes_mul(nx_0, _s2), _s6));
    const V _s8 = lanes_mul(nx_1, ny_1);
    const V _s9 = lanes_sub(lanes_add(lanes_mul(nx_0, _s1), _s8), lanes_add(_s8, lanes_mul(ny_0, _s0)));
    const V _s10 = lanes_neg(lanes_mul(K(0.5), lanes_add(lanes_add(lanes_add(lanes_mul(vx_0, _s5), lanes_mul(vx_1, tx_0)), lanes_add(lanes_mul(vy_0, _s7), lanes_mul(vy_1, ty_0))), lanes_add(lanes_mul(vz_0, _s9), lanes_mul(vz_1, tz_0)))));
    return (LANES(court_roll_1_out)){ _s3, _s5, _s7, _s9, lanes_mul(K(0.5), lanes_add(lanes_mul(_c2, lanes_add(lanes_mul(turn_rate_0, _s5), lanes_mul(turn_rate_1, tx_0))), lanes_add(lanes_mul(nx_0, _s3), lanes_mul(nx_1, lift_0)))), lanes_mul(K(0.5), lanes_add(lanes_mul(_c2, lanes_add(lanes_mul(turn_rate_0, _s7), lanes_mul(turn_rate_1, ty_0))), lanes_add(lanes_mul(ny_0, _s3), lanes_mul(ny_1, lift_0)))), lanes_mul(K(0.5), lanes_add(lanes_mul(_c2, lanes_add(lanes_mul(turn_rate_0, _s9), lanes_mul(turn_rate_1, tz_0))), lanes_add(lanes_mul(nz_0, _s3), lanes_mul(nz_1, lift_0)))), lanes_mul(K(0.5), _s0), lanes_mul(K(0.5), _s1), lanes_mul(K(0.5), _s2), _s10 };
}

/* Coefficients of order 3 of a rolling ball, from those of lower order.
   Newton, Euler and rolling without slip. 125 operations: 43 additions, 4 subtractions, 77 multiplications, 1 negation. */
typedef struct {
    V lift_2, tx_2, ty_2, tz_2, vx_3, vy_3, vz_3, nx_3, ny_3, nz_3, turn_rate_3;
} LANES(court_roll_2_out);

LANES_INLINE LANES(court_roll_2_out)
LANES(court_roll_2)(V nx_0, V nx_1, V nx_2, V ny_0, V ny_1, V ny_2, V nz_0, V nz_1, V nz_2, V vx_0, V vx_1, V vx_2, V vy_0, V vy_1, V vy_2, V vz_0, V vz_1, V vz_2, V bent_x, V bent_y, V bent_z, V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V lift_0, V lift_1, V tx_0, V tx_1, V ty_0, V ty_1, V tz_0, V tz_1, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_mul(K(2.0), nx_2);
    const V _s1 = lanes_mul(lanes_mul(vx_2, bent_x), per_reach);
    const V _s2 = lanes_mul(K(2.0), ny_2);
    const V _s3 = lanes_mul(lanes_mul(vy_2, bent_y), per_reach);
    const V _s4 = lanes_mul(lanes_mul(vz_2, bent_z), per_reach);
    const V _s5 = lanes_sub(lanes_mul(lanes_mul(_c0, nz_2), _c1), lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, vx_2), lanes_mul(_s0, vx_1)), lanes_mul(vx_0, _s1)), lanes_add(lanes_add(lanes_mul(ny_1, vy_2), lanes_mul(_s2, vy_1)), lanes_mul(vy_0, _s3))), lanes_add(lanes_add(lanes_mul(nz_1, vz_2), lanes_mul(lanes_mul(K(2.0), nz_2), vz_1)), lanes_mul(vz_0, _s4))));
    const V _s6 = lanes_sub(lanes_add(lanes_add(lanes_mul(ny_0, _s4), lanes_mul(lanes_mul(K(2.0), ny_1), nz_2)), lanes_mul(ny_2, nz_1)), lanes_add(lanes_add(lanes_mul(ny_1, nz_2), lanes_mul(_s2, nz_1)), lanes_mul(nz_0, _s3)));
    const V _s7 = lanes_mul(K(2.0), nx_1);
    const V _s8 = lanes_sub(lanes_add(lanes_add(lanes_mul(nx_1, nz_2), lanes_mul(_s0, nz_1)), lanes_mul(nz_0, _s1)), lanes_add(lanes_add(lanes_mul(nx_0, _s4), lanes_mul(_s7, nz_2)), lanes_mul(nx_2, nz_1)));
    const V _s9 = lanes_sub(lanes_add(lanes_add(lanes_mul(nx_0, _s3), lanes_mul(_s7, ny_2)), lanes_mul(nx_2, ny_1)), lanes_add(lanes_add(lanes_mul(nx_1, ny_2), lanes_mul(_s0, ny_1)), lanes_mul(ny_0, _s1)));
    const V _s10 = lanes_mul(K(0.3333333333333333), lanes_add(lanes_mul(_c2, lanes_add(lanes_add(lanes_mul(turn_rate_0, _s6), lanes_mul(turn_rate_1, tx_1)), lanes_mul(turn_rate_2, tx_0))), lanes_add(lanes_add(lanes_mul(nx_0, _s5), lanes_mul(nx_1, lift_1)), lanes_mul(nx_2, lift_0))));
    const V _s11 = lanes_mul(K(0.3333333333333333), lanes_add(lanes_mul(_c2, lanes_add(lanes_add(lanes_mul(turn_rate_0, _s8), lanes_mul(turn_rate_1, ty_1)), lanes_mul(turn_rate_2, ty_0))), lanes_add(lanes_add(lanes_mul(ny_0, _s5), lanes_mul(ny_1, lift_1)), lanes_mul(ny_2, lift_0))));
    const V _s12 = lanes_mul(K(0.3333333333333333), lanes_add(lanes_mul(_c2, lanes_add(lanes_add(lanes_mul(turn_rate_0, _s9), lanes_mul(turn_rate_1, tz_1)), lanes_mul(turn_rate_2, tz_0))), lanes_add(lanes_add(lanes_mul(nz_0, _s5), lanes_mul(nz_1, lift_1)), lanes_mul(nz_2, lift_0))));
    const V _s13 = lanes_mul(K(0.3333333333333333), lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(vx_0, _s6), lanes_mul(vx_1, tx_1)), lanes_mul(vx_2, tx_0)), lanes_add(lanes_add(lanes_mul(vy_0, _s8), lanes_mul(vy_1, ty_1)), lanes_mul(vy_2, ty_0))), lanes_add(lanes_add(lanes_mul(vz_0, _s9), lanes_mul(vz_1, tz_1)), lanes_mul(vz_2, tz_0))));
    return (LANES(court_roll_2_out)){ _s5, _s6, _s8, _s9, _s10, _s11, _s12, lanes_mul(K(0.3333333333333333), _s1), lanes_mul(K(0.3333333333333333), _s3), lanes_mul(K(0.3333333333333333), _s4), lanes_neg(_s13) };
}

/* Coefficients of order 4 of a rolling ball, from those of lower order.
   Newton, Euler and rolling without slip. 161 operations: 61 additions, 4 subtractions, 95 multiplications, 1 negation. */
typedef struct {
    V lift_3, tx_3, ty_3, tz_3, vx_4, vy_4, vz_4, nx_4, ny_4, nz_4, turn_rate_4;
} LANES(court_roll_3_out);

LANES_INLINE LANES(court_roll_3_out)
LANES(court_roll_3)(V nx_0, V nx_1, V nx_2, V nx_3, V ny_0, V ny_1, V ny_2, V ny_3, V nz_0, V nz_1, V nz_2, V nz_3, V vx_0, V vx_1, V vx_2, V vx_3, V vy_0, V vy_1, V vy_2, V vy_3, V vz_0, V vz_1, V vz_2, V vz_3, V bent_x, V bent_y, V bent_z, V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V lift_0, V lift_1, V lift_2, V tx_0, V tx_1, V tx_2, V ty_0, V ty_1, V ty_2, V tz_0, V tz_1, V tz_2, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_mul(K(2.0), nx_2);
    const V _s1 = lanes_mul(K(3.0), nx_3);
    const V _s2 = lanes_mul(lanes_mul(vx_3, bent_x), per_reach);
    const V _s3 = lanes_mul(K(2.0), ny_2);
    const V _s4 = lanes_mul(K(3.0), ny_3);
    const V _s5 = lanes_mul(lanes_mul(vy_3, bent_y), per_reach);
    const V _s6 = lanes_mul(lanes_mul(vz_3, bent_z), per_reach);
    const V _s7 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, vx_3), lanes_mul(_s0, vx_2)), lanes_mul(_s1, vx_1)), lanes_mul(vx_0, _s2)), lanes_add(lanes_add(lanes_add(lanes_mul(ny_1, vy_3), lanes_mul(_s3, vy_2)), lanes_mul(_s4, vy_1)), lanes_mul(vy_0, _s5))), lanes_add(lanes_add(lanes_add(lanes_mul(nz_1, vz_3), lanes_mul(lanes_mul(K(2.0), nz_2), vz_2)), lanes_mul(lanes_mul(K(3.0), nz_3), vz_1)), lanes_mul(vz_0, _s6)));
    const V _s8 = lanes_sub(lanes_mul(lanes_mul(_c0, nz_3), _c1), _s7);
    const V _s9 = lanes_mul(_s3, nz_2);
    const V _s10 = lanes_sub(lanes_add(lanes_add(lanes_add(lanes_mul(ny_0, _s6), lanes_mul(lanes_mul(K(3.0), ny_1), nz_3)), _s9), lanes_mul(ny_3, nz_1)), lanes_add(lanes_add(lanes_add(lanes_mul(ny_1, nz_3), _s9), lanes_mul(_s4, nz_1)), lanes_mul(nz_0, _s5)));
    const V _s11 = lanes_mul(_s0, nz_2);
    const V _s12 = lanes_mul(K(3.0), nx_1);
    const V _s13 = lanes_sub(lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, nz_3), _s11), lanes_mul(_s1, nz_1)), lanes_mul(nz_0, _s2)), lanes_add(lanes_add(lanes_add(lanes_mul(nx_0, _s6), lanes_mul(_s12, nz_3)), _s11), lanes_mul(nx_3, nz_1)));
    const V _s14 = lanes_mul(_s0, ny_2);
    const V _s15 = lanes_sub(lanes_add(lanes_add(lanes_add(lanes_mul(nx_0, _s5), lanes_mul(_s12, ny_3)), _s14), lanes_mul(nx_3, ny_1)), lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, ny_3), _s14), lanes_mul(_s1, ny_1)), lanes_mul(ny_0, _s2)));
    const V _s16 = lanes_add(lanes_mul(_c2, lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, _s10), lanes_mul(turn_rate_1, tx_2)), lanes_mul(turn_rate_2, tx_1)), lanes_mul(turn_rate_3, tx_0))), lanes_add(lanes_add(lanes_add(lanes_mul(nx_0, _s8), lanes_mul(nx_1, lift_2)), lanes_mul(nx_2, lift_1)), lanes_mul(nx_3, lift_0)));
    const V _s17 = lanes_add(lanes_mul(_c2, lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, _s13), lanes_mul(turn_rate_1, ty_2)), lanes_mul(turn_rate_2, ty_1)), lanes_mul(turn_rate_3, ty_0))), lanes_add(lanes_add(lanes_add(lanes_mul(ny_0, _s8), lanes_mul(ny_1, lift_2)), lanes_mul(ny_2, lift_1)), lanes_mul(ny_3, lift_0)));
    const V _s18 = lanes_add(lanes_mul(_c2, lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, _s15), lanes_mul(turn_rate_1, tz_2)), lanes_mul(turn_rate_2, tz_1)), lanes_mul(turn_rate_3, tz_0))), lanes_add(lanes_add(lanes_add(lanes_mul(nz_0, _s8), lanes_mul(nz_1, lift_2)), lanes_mul(nz_2, lift_1)), lanes_mul(nz_3, lift_0)));
    const V _s19 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(vx_0, _s10), lanes_mul(vx_1, tx_2)), lanes_mul(vx_2, tx_1)), lanes_mul(vx_3, tx_0)), lanes_add(lanes_add(lanes_add(lanes_mul(vy_0, _s13), lanes_mul(vy_1, ty_2)), lanes_mul(vy_2, ty_1)), lanes_mul(vy_3, ty_0))), lanes_add(lanes_add(lanes_add(lanes_mul(vz_0, _s15), lanes_mul(vz_1, tz_2)), lanes_mul(vz_2, tz_1)), lanes_mul(vz_3, tz_0)));
    return (LANES(court_roll_3_out)){ _s8, _s10, _s13, _s15, lanes_mul(K(0.25), _s16), lanes_mul(K(0.25), _s17), lanes_mul(K(0.25), _s18), lanes_mul(K(0.25), _s2), lanes_mul(K(0.25), _s5), lanes_mul(K(0.25), _s6), lanes_neg(lanes_mul(K(0.25), _s19)) };
}

/* Coefficients of order 5 of a rolling ball, from those of lower order.
   Newton, Euler and rolling without slip. 207 operations: 79 additions, 4 subtractions, 123 multiplications, 1 negation. */
typedef struct {
    V lift_4, tx_4, ty_4, tz_4, vx_5, vy_5, vz_5, nx_5, ny_5, nz_5, turn_rate_5;
} LANES(court_roll_4_out);

LANES_INLINE LANES(court_roll_4_out)
LANES(court_roll_4)(V nx_0, V nx_1, V nx_2, V nx_3, V nx_4, V ny_0, V ny_1, V ny_2, V ny_3, V ny_4, V nz_0, V nz_1, V nz_2, V nz_3, V nz_4, V vx_0, V vx_1, V vx_2, V vx_3, V vx_4, V vy_0, V vy_1, V vy_2, V vy_3, V vy_4, V vz_0, V vz_1, V vz_2, V vz_3, V vz_4, V bent_x, V bent_y, V bent_z, V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V turn_rate_4, V lift_0, V lift_1, V lift_2, V lift_3, V tx_0, V tx_1, V tx_2, V tx_3, V ty_0, V ty_1, V ty_2, V ty_3, V tz_0, V tz_1, V tz_2, V tz_3, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_mul(K(2.0), nx_2);
    const V _s1 = lanes_mul(K(3.0), nx_3);
    const V _s2 = lanes_mul(K(4.0), nx_4);
    const V _s3 = lanes_mul(lanes_mul(vx_4, bent_x), per_reach);
    const V _s4 = lanes_mul(K(2.0), ny_2);
    const V _s5 = lanes_mul(K(3.0), ny_3);
    const V _s6 = lanes_mul(K(4.0), ny_4);
    const V _s7 = lanes_mul(lanes_mul(vy_4, bent_y), per_reach);
    const V _s8 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, vx_4), lanes_mul(_s0, vx_3)), lanes_mul(_s1, vx_2)), lanes_mul(_s2, vx_1)), lanes_mul(vx_0, _s3)), lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(ny_1, vy_4), lanes_mul(_s4, vy_3)), lanes_mul(_s5, vy_2)), lanes_mul(_s6, vy_1)), lanes_mul(vy_0, _s7)));
    const V _s9 = lanes_mul(lanes_mul(vz_4, bent_z), per_reach);
    const V _s10 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nz_1, vz_4), lanes_mul(lanes_mul(K(2.0), nz_2), vz_3)), lanes_mul(lanes_mul(K(3.0), nz_3), vz_2)), lanes_mul(lanes_mul(K(4.0), nz_4), vz_1)), lanes_mul(vz_0, _s9));
    const V _s11 = lanes_sub(lanes_mul(lanes_mul(_c0, nz_4), _c1), lanes_add(_s8, _s10));
    const V _s12 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(ny_0, _s9), lanes_mul(lanes_mul(K(4.0), ny_1), nz_4)), lanes_mul(lanes_mul(K(3.0), ny_2), nz_3)), lanes_mul(lanes_mul(K(2.0), ny_3), nz_2)), lanes_mul(ny_4, nz_1));
    const V _s13 = lanes_sub(_s12, lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(ny_1, nz_4), lanes_mul(_s4, nz_3)), lanes_mul(_s5, nz_2)), lanes_mul(_s6, nz_1)), lanes_mul(nz_0, _s7)));
    const V _s14 = lanes_mul(K(4.0), nx_1);
    const V _s15 = lanes_mul(K(3.0), nx_2);
    const V _s16 = lanes_mul(K(2.0), nx_3);
    const V _s17 = lanes_sub(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, nz_4), lanes_mul(_s0, nz_3)), lanes_mul(_s1, nz_2)), lanes_mul(_s2, nz_1)), lanes_mul(nz_0, _s3)), lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_0, _s9), lanes_mul(_s14, nz_4)), lanes_mul(_s15, nz_3)), lanes_mul(_s16, nz_2)), lanes_mul(nx_4, nz_1)));
    const V _s18 = lanes_sub(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_0, _s7), lanes_mul(_s14, ny_4)), lanes_mul(_s15, ny_3)), lanes_mul(_s16, ny_2)), lanes_mul(nx_4, ny_1)), lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, ny_4), lanes_mul(_s0, ny_3)), lanes_mul(_s1, ny_2)), lanes_mul(_s2, ny_1)), lanes_mul(ny_0, _s3)));
    const V _s19 = lanes_mul(_c2, lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, _s13), lanes_mul(turn_rate_1, tx_3)), lanes_mul(turn_rate_2, tx_2)), lanes_mul(turn_rate_3, tx_1)), lanes_mul(turn_rate_4, tx_0)));
    const V _s20 = lanes_add(_s19, lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_0, _s11), lanes_mul(nx_1, lift_3)), lanes_mul(nx_2, lift_2)), lanes_mul(nx_3, lift_1)), lanes_mul(nx_4, lift_0)));
    const V _s21 = lanes_mul(_c2, lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, _s17), lanes_mul(turn_rate_1, ty_3)), lanes_mul(turn_rate_2, ty_2)), lanes_mul(turn_rate_3, ty_1)), lanes_mul(turn_rate_4, ty_0)));
    const V _s22 = lanes_add(_s21, lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(ny_0, _s11), lanes_mul(ny_1, lift_3)), lanes_mul(ny_2, lift_2)), lanes_mul(ny_3, lift_1)), lanes_mul(ny_4, lift_0)));
    const V _s23 = lanes_mul(_c2, lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, _s18), lanes_mul(turn_rate_1, tz_3)), lanes_mul(turn_rate_2, tz_2)), lanes_mul(turn_rate_3, tz_1)), lanes_mul(turn_rate_4, tz_0)));
    const V _s24 = lanes_add(_s23, lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nz_0, _s11), lanes_mul(nz_1, lift_3)), lanes_mul(nz_2, lift_2)), lanes_mul(nz_3, lift_1)), lanes_mul(nz_4, lift_0)));
    const V _s25 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(vx_0, _s13), lanes_mul(vx_1, tx_3)), lanes_mul(vx_2, tx_2)), lanes_mul(vx_3, tx_1)), lanes_mul(vx_4, tx_0)), lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(vy_0, _s17), lanes_mul(vy_1, ty_3)), lanes_mul(vy_2, ty_2)), lanes_mul(vy_3, ty_1)), lanes_mul(vy_4, ty_0)));
    const V _s26 = lanes_add(_s25, lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(vz_0, _s18), lanes_mul(vz_1, tz_3)), lanes_mul(vz_2, tz_2)), lanes_mul(vz_3, tz_1)), lanes_mul(vz_4, tz_0)));
    return (LANES(court_roll_4_out)){ _s11, _s13, _s17, _s18, lanes_mul(K(0.2), _s20), lanes_mul(K(0.2), _s22), lanes_mul(K(0.2), _s24), lanes_mul(K(0.2), _s3), lanes_mul(K(0.2), _s7), lanes_mul(K(0.2), _s9), lanes_neg(lanes_mul(K(0.2), _s26)) };
}

/* Coefficients of order 6 of a rolling ball, from those of lower order.
   Newton, Euler and rolling without slip. 243 operations: 97 additions, 4 subtractions, 141 multiplications, 1 negation. */
typedef struct {
    V lift_5, tx_5, ty_5, tz_5, vx_6, vy_6, vz_6, nx_6, ny_6, nz_6, turn_rate_6;
} LANES(court_roll_5_out);

LANES_INLINE LANES(court_roll_5_out)
LANES(court_roll_5)(V nx_0, V nx_1, V nx_2, V nx_3, V nx_4, V nx_5, V ny_0, V ny_1, V ny_2, V ny_3, V ny_4, V ny_5, V nz_0, V nz_1, V nz_2, V nz_3, V nz_4, V nz_5, V vx_0, V vx_1, V vx_2, V vx_3, V vx_4, V vx_5, V vy_0, V vy_1, V vy_2, V vy_3, V vy_4, V vy_5, V vz_0, V vz_1, V vz_2, V vz_3, V vz_4, V vz_5, V bent_x, V bent_y, V bent_z, V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V turn_rate_4, V turn_rate_5, V lift_0, V lift_1, V lift_2, V lift_3, V lift_4, V tx_0, V tx_1, V tx_2, V tx_3, V tx_4, V ty_0, V ty_1, V ty_2, V ty_3, V ty_4, V tz_0, V tz_1, V tz_2, V tz_3, V tz_4, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_mul(K(2.0), nx_2);
    const V _s1 = lanes_mul(K(3.0), nx_3);
    const V _s2 = lanes_mul(K(4.0), nx_4);
    const V _s3 = lanes_mul(K(5.0), nx_5);
    const V _s4 = lanes_mul(lanes_mul(vx_5, bent_x), per_reach);
    const V _s5 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, vx_5), lanes_mul(_s0, vx_4)), lanes_mul(_s1, vx_3)), lanes_mul(_s2, vx_2)), lanes_mul(_s3, vx_1)), lanes_mul(vx_0, _s4));
    const V _s6 = lanes_mul(K(2.0), ny_2);
    const V _s7 = lanes_mul(K(3.0), ny_3);
    const V _s8 = lanes_mul(K(4.0), ny_4);
    const V _s9 = lanes_mul(K(5.0), ny_5);
    const V _s10 = lanes_mul(lanes_mul(vy_5, bent_y), per_reach);
    const V _s11 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(ny_1, vy_5), lanes_mul(_s6, vy_4)), lanes_mul(_s7, vy_3)), lanes_mul(_s8, vy_2)), lanes_mul(_s9, vy_1)), lanes_mul(vy_0, _s10));
    const V _s12 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nz_1, vz_5), lanes_mul(lanes_mul(K(2.0), nz_2), vz_4)), lanes_mul(lanes_mul(K(3.0), nz_3), vz_3)), lanes_mul(lanes_mul(K(4.0), nz_4), vz_2)), lanes_mul(lanes_mul(K(5.0), nz_5), vz_1));
    const V _s13 = lanes_mul(lanes_mul(vz_5, bent_z), per_reach);
    const V _s14 = lanes_sub(lanes_mul(lanes_mul(_c0, nz_5), _c1), lanes_add(lanes_add(_s5, _s11), lanes_add(_s12, lanes_mul(vz_0, _s13))));
    const V _s15 = lanes_mul(_s7, nz_3);
    const V _s16 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(ny_0, _s13), lanes_mul(lanes_mul(K(5.0), ny_1), nz_5)), lanes_mul(lanes_mul(K(4.0), ny_2), nz_4)), _s15), lanes_mul(lanes_mul(K(2.0), ny_4), nz_2));
    const V _s17 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(ny_1, nz_5), lanes_mul(_s6, nz_4)), _s15), lanes_mul(_s8, nz_2)), lanes_mul(_s9, nz_1)), lanes_mul(nz_0, _s10));
    const V _s18 = lanes_sub(lanes_add(_s16, lanes_mul(ny_5, nz_1)), _s17);
    const V _s19 = lanes_mul(_s1, nz_3);
    const V _s20 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, nz_5), lanes_mul(_s0, nz_4)), _s19), lanes_mul(_s2, nz_2)), lanes_mul(_s3, nz_1)), lanes_mul(nz_0, _s4));
    const V _s21 = lanes_mul(K(5.0), nx_1);
    const V _s22 = lanes_mul(K(4.0), nx_2);
    const V _s23 = lanes_mul(K(2.0), nx_4);
    const V _s24 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_0, _s13), lanes_mul(_s21, nz_5)), lanes_mul(_s22, nz_4)), _s19), lanes_mul(_s23, nz_2)), lanes_mul(nx_5, nz_1));
    const V _s25 = lanes_sub(_s20, _s24);
    const V _s26 = lanes_mul(_s1, ny_3);
    const V _s27 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_0, _s10), lanes_mul(_s21, ny_5)), lanes_mul(_s22, ny_4)), _s26), lanes_mul(_s23, ny_2)), lanes_mul(nx_5, ny_1));
    const V _s28 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, ny_5), lanes_mul(_s0, ny_4)), _s26), lanes_mul(_s2, ny_2)), lanes_mul(_s3, ny_1)), lanes_mul(ny_0, _s4));
    const V _s29 = lanes_sub(_s27, _s28);
    const V _s30 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, _s18), lanes_mul(turn_rate_1, tx_4)), lanes_mul(turn_rate_2, tx_3)), lanes_mul(turn_rate_3, tx_2)), lanes_mul(turn_rate_4, tx_1)), lanes_mul(turn_rate_5, tx_0));
    const V _s31 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_0, _s14), lanes_mul(nx_1, lift_4)), lanes_mul(nx_2, lift_3)), lanes_mul(nx_3, lift_2)), lanes_mul(nx_4, lift_1)), lanes_mul(nx_5, lift_0));
    const V _s32 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, _s25), lanes_mul(turn_rate_1, ty_4)), lanes_mul(turn_rate_2, ty_3)), lanes_mul(turn_rate_3, ty_2)), lanes_mul(turn_rate_4, ty_1)), lanes_mul(turn_rate_5, ty_0));
    const V _s33 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(ny_0, _s14), lanes_mul(ny_1, lift_4)), lanes_mul(ny_2, lift_3)), lanes_mul(ny_3, lift_2)), lanes_mul(ny_4, lift_1)), lanes_mul(ny_5, lift_0));
    const V _s34 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, _s29), lanes_mul(turn_rate_1, tz_4)), lanes_mul(turn_rate_2, tz_3)), lanes_mul(turn_rate_3, tz_2)), lanes_mul(turn_rate_4, tz_1)), lanes_mul(turn_rate_5, tz_0));
    const V _s35 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nz_0, _s14), lanes_mul(nz_1, lift_4)), lanes_mul(nz_2, lift_3)), lanes_mul(nz_3, lift_2)), lanes_mul(nz_4, lift_1)), lanes_mul(nz_5, lift_0));
    const V _s36 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(vx_0, _s18), lanes_mul(vx_1, tx_4)), lanes_mul(vx_2, tx_3)), lanes_mul(vx_3, tx_2)), lanes_mul(vx_4, tx_1)), lanes_mul(vx_5, tx_0));
    const V _s37 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(vy_0, _s25), lanes_mul(vy_1, ty_4)), lanes_mul(vy_2, ty_3)), lanes_mul(vy_3, ty_2)), lanes_mul(vy_4, ty_1)), lanes_mul(vy_5, ty_0));
    const V _s38 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(vz_0, _s29), lanes_mul(vz_1, tz_4)), lanes_mul(vz_2, tz_3)), lanes_mul(vz_3, tz_2)), lanes_mul(vz_4, tz_1)), lanes_mul(vz_5, tz_0));
    return (LANES(court_roll_5_out)){ _s14, _s18, _s25, _s29, lanes_mul(K(0.16666666666666666), lanes_add(lanes_mul(_c2, _s30), _s31)), lanes_mul(K(0.16666666666666666), lanes_add(lanes_mul(_c2, _s32), _s33)), lanes_mul(K(0.16666666666666666), lanes_add(lanes_mul(_c2, _s34), _s35)), lanes_mul(K(0.16666666666666666), _s4), lanes_mul(K(0.16666666666666666), _s10), lanes_mul(K(0.16666666666666666), _s13), lanes_neg(lanes_mul(K(0.16666666666666666), lanes_add(lanes_add(_s36, _s37), _s38))) };
}

/* Coefficients of order 7 of a rolling ball, from those of lower order.
   Newton, Euler and rolling without slip. 289 operations: 115 additions, 4 subtractions, 169 multiplications, 1 negation. */
typedef struct {
    V lift_6, tx_6, ty_6, tz_6, vx_7, vy_7, vz_7, nx_7, ny_7, nz_7, turn_rate_7;
} LANES(court_roll_6_out);

LANES_INLINE LANES(court_roll_6_out)
LANES(court_roll_6)(V nx_0, V nx_1, V nx_2, V nx_3, V nx_4, V nx_5, V nx_6, V ny_0, V ny_1, V ny_2, V ny_3, V ny_4, V ny_5, V ny_6, V nz_0, V nz_1, V nz_2, V nz_3, V nz_4, V nz_5, V nz_6, V vx_0, V vx_1, V vx_2, V vx_3, V vx_4, V vx_5, V vx_6, V vy_0, V vy_1, V vy_2, V vy_3, V vy_4, V vy_5, V vy_6, V vz_0, V vz_1, V vz_2, V vz_3, V vz_4, V vz_5, V vz_6, V bent_x, V bent_y, V bent_z, V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V turn_rate_4, V turn_rate_5, V turn_rate_6, V lift_0, V lift_1, V lift_2, V lift_3, V lift_4, V lift_5, V tx_0, V tx_1, V tx_2, V tx_3, V tx_4, V tx_5, V ty_0, V ty_1, V ty_2, V ty_3, V ty_4, V ty_5, V tz_0, V tz_1, V tz_2, V tz_3, V tz_4, V tz_5, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_mul(K(2.0), nx_2);
    const V _s1 = lanes_mul(K(3.0), nx_3);
    const V _s2 = lanes_mul(K(4.0), nx_4);
    const V _s3 = lanes_mul(K(5.0), nx_5);
    const V _s4 = lanes_mul(K(6.0), nx_6);
    const V _s5 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, vx_6), lanes_mul(_s0, vx_5)), lanes_mul(_s1, vx_4)), lanes_mul(_s2, vx_3)), lanes_mul(_s3, vx_2)), lanes_mul(_s4, vx_1));
    const V _s6 = lanes_mul(lanes_mul(vx_6, bent_x), per_reach);
    const V _s7 = lanes_mul(K(2.0), ny_2);
    const V _s8 = lanes_mul(K(3.0), ny_3);
    const V _s9 = lanes_mul(K(4.0), ny_4);
    const V _s10 = lanes_mul(K(5.0), ny_5);
    const V _s11 = lanes_mul(K(6.0), ny_6);
    const V _s12 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(ny_1, vy_6), lanes_mul(_s7, vy_5)), lanes_mul(_s8, vy_4)), lanes_mul(_s9, vy_3)), lanes_mul(_s10, vy_2)), lanes_mul(_s11, vy_1));
    const V _s13 = lanes_mul(lanes_mul(vy_6, bent_y), per_reach);
    const V _s14 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nz_1, vz_6), lanes_mul(lanes_mul(K(2.0), nz_2), vz_5)), lanes_mul(lanes_mul(K(3.0), nz_3), vz_4)), lanes_mul(lanes_mul(K(4.0), nz_4), vz_3)), lanes_mul(lanes_mul(K(5.0), nz_5), vz_2));
    const V _s15 = lanes_mul(lanes_mul(vz_6, bent_z), per_reach);
    const V _s16 = lanes_sub(lanes_mul(lanes_mul(_c0, nz_6), _c1), lanes_add(lanes_add(lanes_add(_s5, lanes_mul(vx_0, _s6)), lanes_add(_s12, lanes_mul(vy_0, _s13))), lanes_add(lanes_add(_s14, lanes_mul(lanes_mul(K(6.0), nz_6), vz_1)), lanes_mul(vz_0, _s15))));
    const V _s17 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(ny_0, _s15), lanes_mul(lanes_mul(K(6.0), ny_1), nz_6)), lanes_mul(lanes_mul(K(5.0), ny_2), nz_5)), lanes_mul(lanes_mul(K(4.0), ny_3), nz_4)), lanes_mul(lanes_mul(K(3.0), ny_4), nz_3));
    const V _s18 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(ny_1, nz_6), lanes_mul(_s7, nz_5)), lanes_mul(_s8, nz_4)), lanes_mul(_s9, nz_3)), lanes_mul(_s10, nz_2)), lanes_mul(_s11, nz_1));
    const V _s19 = lanes_sub(lanes_add(lanes_add(_s17, lanes_mul(lanes_mul(K(2.0), ny_5), nz_2)), lanes_mul(ny_6, nz_1)), lanes_add(_s18, lanes_mul(nz_0, _s13)));
    const V _s20 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, nz_6), lanes_mul(_s0, nz_5)), lanes_mul(_s1, nz_4)), lanes_mul(_s2, nz_3)), lanes_mul(_s3, nz_2)), lanes_mul(_s4, nz_1));
    const V _s21 = lanes_mul(K(6.0), nx_1);
    const V _s22 = lanes_mul(K(5.0), nx_2);
    const V _s23 = lanes_mul(K(4.0), nx_3);
    const V _s24 = lanes_mul(K(3.0), nx_4);
    const V _s25 = lanes_mul(K(2.0), nx_5);
    const V _s26 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_0, _s15), lanes_mul(_s21, nz_6)), lanes_mul(_s22, nz_5)), lanes_mul(_s23, nz_4)), lanes_mul(_s24, nz_3)), lanes_mul(_s25, nz_2));
    const V _s27 = lanes_sub(lanes_add(_s20, lanes_mul(nz_0, _s6)), lanes_add(_s26, lanes_mul(nx_6, nz_1)));
    const V _s28 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_0, _s13), lanes_mul(_s21, ny_6)), lanes_mul(_s22, ny_5)), lanes_mul(_s23, ny_4)), lanes_mul(_s24, ny_3)), lanes_mul(_s25, ny_2));
    const V _s29 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, ny_6), lanes_mul(_s0, ny_5)), lanes_mul(_s1, ny_4)), lanes_mul(_s2, ny_3)), lanes_mul(_s3, ny_2)), lanes_mul(_s4, ny_1));
    const V _s30 = lanes_sub(lanes_add(_s28, lanes_mul(nx_6, ny_1)), lanes_add(_s29, lanes_mul(ny_0, _s6)));
    const V _s31 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, _s19), lanes_mul(turn_rate_1, tx_5)), lanes_mul(turn_rate_2, tx_4)), lanes_mul(turn_rate_3, tx_3)), lanes_mul(turn_rate_4, tx_2)), lanes_mul(turn_rate_5, tx_1));
    const V _s32 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_0, _s16), lanes_mul(nx_1, lift_5)), lanes_mul(nx_2, lift_4)), lanes_mul(nx_3, lift_3)), lanes_mul(nx_4, lift_2)), lanes_mul(nx_5, lift_1));
    const V _s33 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, _s27), lanes_mul(turn_rate_1, ty_5)), lanes_mul(turn_rate_2, ty_4)), lanes_mul(turn_rate_3, ty_3)), lanes_mul(turn_rate_4, ty_2)), lanes_mul(turn_rate_5, ty_1));
    const V _s34 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(ny_0, _s16), lanes_mul(ny_1, lift_5)), lanes_mul(ny_2, lift_4)), lanes_mul(ny_3, lift_3)), lanes_mul(ny_4, lift_2)), lanes_mul(ny_5, lift_1));
    const V _s35 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, _s30), lanes_mul(turn_rate_1, tz_5)), lanes_mul(turn_rate_2, tz_4)), lanes_mul(turn_rate_3, tz_3)), lanes_mul(turn_rate_4, tz_2)), lanes_mul(turn_rate_5, tz_1));
    const V _s36 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nz_0, _s16), lanes_mul(nz_1, lift_5)), lanes_mul(nz_2, lift_4)), lanes_mul(nz_3, lift_3)), lanes_mul(nz_4, lift_2)), lanes_mul(nz_5, lift_1));
    const V _s37 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(vx_0, _s19), lanes_mul(vx_1, tx_5)), lanes_mul(vx_2, tx_4)), lanes_mul(vx_3, tx_3)), lanes_mul(vx_4, tx_2)), lanes_mul(vx_5, tx_1));
    const V _s38 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(vy_0, _s27), lanes_mul(vy_1, ty_5)), lanes_mul(vy_2, ty_4)), lanes_mul(vy_3, ty_3)), lanes_mul(vy_4, ty_2)), lanes_mul(vy_5, ty_1));
    const V _s39 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(vz_0, _s30), lanes_mul(vz_1, tz_5)), lanes_mul(vz_2, tz_4)), lanes_mul(vz_3, tz_3)), lanes_mul(vz_4, tz_2)), lanes_mul(vz_5, tz_1));
    const V _s40 = lanes_neg(lanes_mul(K(0.14285714285714285), lanes_add(lanes_add(lanes_add(_s37, lanes_mul(vx_6, tx_0)), lanes_add(_s38, lanes_mul(vy_6, ty_0))), lanes_add(_s39, lanes_mul(vz_6, tz_0)))));
    return (LANES(court_roll_6_out)){ _s16, _s19, _s27, _s30, lanes_mul(K(0.14285714285714285), lanes_add(lanes_mul(_c2, lanes_add(_s31, lanes_mul(turn_rate_6, tx_0))), lanes_add(_s32, lanes_mul(nx_6, lift_0)))), lanes_mul(K(0.14285714285714285), lanes_add(lanes_mul(_c2, lanes_add(_s33, lanes_mul(turn_rate_6, ty_0))), lanes_add(_s34, lanes_mul(ny_6, lift_0)))), lanes_mul(K(0.14285714285714285), lanes_add(lanes_mul(_c2, lanes_add(_s35, lanes_mul(turn_rate_6, tz_0))), lanes_add(_s36, lanes_mul(nz_6, lift_0)))), lanes_mul(K(0.14285714285714285), _s6), lanes_mul(K(0.14285714285714285), _s13), lanes_mul(K(0.14285714285714285), _s15), _s40 };
}

/* Coefficients of order 8 of a rolling ball, from those of lower order.
   Newton, Euler and rolling without slip. 325 operations: 133 additions, 4 subtractions, 187 multiplications, 1 negation. */
typedef struct {
    V lift_7, tx_7, ty_7, tz_7, vx_8, vy_8, vz_8, nx_8, ny_8, nz_8, turn_rate_8;
} LANES(court_roll_7_out);

LANES_INLINE LANES(court_roll_7_out)
LANES(court_roll_7)(V nx_0, V nx_1, V nx_2, V nx_3, V nx_4, V nx_5, V nx_6, V nx_7, V ny_0, V ny_1, V ny_2, V ny_3, V ny_4, V ny_5, V ny_6, V ny_7, V nz_0, V nz_1, V nz_2, V nz_3, V nz_4, V nz_5, V nz_6, V nz_7, V vx_0, V vx_1, V vx_2, V vx_3, V vx_4, V vx_5, V vx_6, V vx_7, V vy_0, V vy_1, V vy_2, V vy_3, V vy_4, V vy_5, V vy_6, V vy_7, V vz_0, V vz_1, V vz_2, V vz_3, V vz_4, V vz_5, V vz_6, V vz_7, V bent_x, V bent_y, V bent_z, V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V turn_rate_4, V turn_rate_5, V turn_rate_6, V turn_rate_7, V lift_0, V lift_1, V lift_2, V lift_3, V lift_4, V lift_5, V lift_6, V tx_0, V tx_1, V tx_2, V tx_3, V tx_4, V tx_5, V tx_6, V ty_0, V ty_1, V ty_2, V ty_3, V ty_4, V ty_5, V ty_6, V tz_0, V tz_1, V tz_2, V tz_3, V tz_4, V tz_5, V tz_6, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_mul(K(2.0), nx_2);
    const V _s1 = lanes_mul(K(3.0), nx_3);
    const V _s2 = lanes_mul(K(4.0), nx_4);
    const V _s3 = lanes_mul(K(5.0), nx_5);
    const V _s4 = lanes_mul(K(6.0), nx_6);
    const V _s5 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, vx_7), lanes_mul(_s0, vx_6)), lanes_mul(_s1, vx_5)), lanes_mul(_s2, vx_4)), lanes_mul(_s3, vx_3)), lanes_mul(_s4, vx_2));
    const V _s6 = lanes_mul(K(7.0), nx_7);
    const V _s7 = lanes_mul(lanes_mul(vx_7, bent_x), per_reach);
    const V _s8 = lanes_mul(K(2.0), ny_2);
    const V _s9 = lanes_mul(K(3.0), ny_3);
    const V _s10 = lanes_mul(K(4.0), ny_4);
    const V _s11 = lanes_mul(K(5.0), ny_5);
    const V _s12 = lanes_mul(K(6.0), ny_6);
    const V _s13 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(ny_1, vy_7), lanes_mul(_s8, vy_6)), lanes_mul(_s9, vy_5)), lanes_mul(_s10, vy_4)), lanes_mul(_s11, vy_3)), lanes_mul(_s12, vy_2));
    const V _s14 = lanes_mul(K(7.0), ny_7);
    const V _s15 = lanes_mul(lanes_mul(vy_7, bent_y), per_reach);
    const V _s16 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nz_1, vz_7), lanes_mul(lanes_mul(K(2.0), nz_2), vz_6)), lanes_mul(lanes_mul(K(3.0), nz_3), vz_5)), lanes_mul(lanes_mul(K(4.0), nz_4), vz_4)), lanes_mul(lanes_mul(K(5.0), nz_5), vz_3));
    const V _s17 = lanes_mul(lanes_mul(vz_7, bent_z), per_reach);
    const V _s18 = lanes_add(lanes_add(lanes_add(lanes_add(_s5, lanes_mul(_s6, vx_1)), lanes_mul(vx_0, _s7)), lanes_add(lanes_add(_s13, lanes_mul(_s14, vy_1)), lanes_mul(vy_0, _s15))), lanes_add(lanes_add(lanes_add(_s16, lanes_mul(lanes_mul(K(6.0), nz_6), vz_2)), lanes_mul(lanes_mul(K(7.0), nz_7), vz_1)), lanes_mul(vz_0, _s17)));
    const V _s19 = lanes_sub(lanes_mul(lanes_mul(_c0, nz_7), _c1), _s18);
    const V _s20 = lanes_mul(_s10, nz_4);
    const V _s21 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(ny_0, _s17), lanes_mul(lanes_mul(K(7.0), ny_1), nz_7)), lanes_mul(lanes_mul(K(6.0), ny_2), nz_6)), lanes_mul(lanes_mul(K(5.0), ny_3), nz_5)), _s20);
    const V _s22 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(ny_1, nz_7), lanes_mul(_s8, nz_6)), lanes_mul(_s9, nz_5)), _s20), lanes_mul(_s11, nz_3)), lanes_mul(_s12, nz_2));
    const V _s23 = lanes_sub(lanes_add(lanes_add(lanes_add(_s21, lanes_mul(lanes_mul(K(3.0), ny_5), nz_3)), lanes_mul(lanes_mul(K(2.0), ny_6), nz_2)), lanes_mul(ny_7, nz_1)), lanes_add(lanes_add(_s22, lanes_mul(_s14, nz_1)), lanes_mul(nz_0, _s15)));
    const V _s24 = lanes_mul(_s2, nz_4);
    const V _s25 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, nz_7), lanes_mul(_s0, nz_6)), lanes_mul(_s1, nz_5)), _s24), lanes_mul(_s3, nz_3)), lanes_mul(_s4, nz_2));
    const V _s26 = lanes_mul(K(7.0), nx_1);
    const V _s27 = lanes_mul(K(6.0), nx_2);
    const V _s28 = lanes_mul(K(5.0), nx_3);
    const V _s29 = lanes_mul(K(3.0), nx_5);
    const V _s30 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_0, _s17), lanes_mul(_s26, nz_7)), lanes_mul(_s27, nz_6)), lanes_mul(_s28, nz_5)), _s24), lanes_mul(_s29, nz_3));
    const V _s31 = lanes_mul(K(2.0), nx_6);
    const V _s32 = lanes_sub(lanes_add(lanes_add(_s25, lanes_mul(_s6, nz_1)), lanes_mul(nz_0, _s7)), lanes_add(lanes_add(_s30, lanes_mul(_s31, nz_2)), lanes_mul(nx_7, nz_1)));
    const V _s33 = lanes_mul(_s2, ny_4);
    const V _s34 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_0, _s15), lanes_mul(_s26, ny_7)), lanes_mul(_s27, ny_6)), lanes_mul(_s28, ny_5)), _s33), lanes_mul(_s29, ny_3));
    const V _s35 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_1, ny_7), lanes_mul(_s0, ny_6)), lanes_mul(_s1, ny_5)), _s33), lanes_mul(_s3, ny_3)), lanes_mul(_s4, ny_2));
    const V _s36 = lanes_sub(lanes_add(lanes_add(_s34, lanes_mul(_s31, ny_2)), lanes_mul(nx_7, ny_1)), lanes_add(lanes_add(_s35, lanes_mul(_s6, ny_1)), lanes_mul(ny_0, _s7)));
    const V _s37 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, _s23), lanes_mul(turn_rate_1, tx_6)), lanes_mul(turn_rate_2, tx_5)), lanes_mul(turn_rate_3, tx_4)), lanes_mul(turn_rate_4, tx_3)), lanes_mul(turn_rate_5, tx_2));
    const V _s38 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nx_0, _s19), lanes_mul(nx_1, lift_6)), lanes_mul(nx_2, lift_5)), lanes_mul(nx_3, lift_4)), lanes_mul(nx_4, lift_3)), lanes_mul(nx_5, lift_2));
    const V _s39 = lanes_mul(K(0.125), lanes_add(lanes_mul(_c2, lanes_add(lanes_add(_s37, lanes_mul(turn_rate_6, tx_1)), lanes_mul(turn_rate_7, tx_0))), lanes_add(lanes_add(_s38, lanes_mul(nx_6, lift_1)), lanes_mul(nx_7, lift_0))));
    const V _s40 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, _s32), lanes_mul(turn_rate_1, ty_6)), lanes_mul(turn_rate_2, ty_5)), lanes_mul(turn_rate_3, ty_4)), lanes_mul(turn_rate_4, ty_3)), lanes_mul(turn_rate_5, ty_2));
    const V _s41 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(ny_0, _s19), lanes_mul(ny_1, lift_6)), lanes_mul(ny_2, lift_5)), lanes_mul(ny_3, lift_4)), lanes_mul(ny_4, lift_3)), lanes_mul(ny_5, lift_2));
    const V _s42 = lanes_mul(K(0.125), lanes_add(lanes_mul(_c2, lanes_add(lanes_add(_s40, lanes_mul(turn_rate_6, ty_1)), lanes_mul(turn_rate_7, ty_0))), lanes_add(lanes_add(_s41, lanes_mul(ny_6, lift_1)), lanes_mul(ny_7, lift_0))));
    const V _s43 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, _s36), lanes_mul(turn_rate_1, tz_6)), lanes_mul(turn_rate_2, tz_5)), lanes_mul(turn_rate_3, tz_4)), lanes_mul(turn_rate_4, tz_3)), lanes_mul(turn_rate_5, tz_2));
    const V _s44 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(nz_0, _s19), lanes_mul(nz_1, lift_6)), lanes_mul(nz_2, lift_5)), lanes_mul(nz_3, lift_4)), lanes_mul(nz_4, lift_3)), lanes_mul(nz_5, lift_2));
    const V _s45 = lanes_mul(K(0.125), lanes_add(lanes_mul(_c2, lanes_add(lanes_add(_s43, lanes_mul(turn_rate_6, tz_1)), lanes_mul(turn_rate_7, tz_0))), lanes_add(lanes_add(_s44, lanes_mul(nz_6, lift_1)), lanes_mul(nz_7, lift_0))));
    const V _s46 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(vx_0, _s23), lanes_mul(vx_1, tx_6)), lanes_mul(vx_2, tx_5)), lanes_mul(vx_3, tx_4)), lanes_mul(vx_4, tx_3)), lanes_mul(vx_5, tx_2));
    const V _s47 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(vy_0, _s32), lanes_mul(vy_1, ty_6)), lanes_mul(vy_2, ty_5)), lanes_mul(vy_3, ty_4)), lanes_mul(vy_4, ty_3)), lanes_mul(vy_5, ty_2));
    const V _s48 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(vz_0, _s36), lanes_mul(vz_1, tz_6)), lanes_mul(vz_2, tz_5)), lanes_mul(vz_3, tz_4)), lanes_mul(vz_4, tz_3)), lanes_mul(vz_5, tz_2));
    const V _s49 = lanes_mul(K(0.125), lanes_add(lanes_add(lanes_add(lanes_add(_s46, lanes_mul(vx_6, tx_1)), lanes_mul(vx_7, tx_0)), lanes_add(lanes_add(_s47, lanes_mul(vy_6, ty_1)), lanes_mul(vy_7, ty_0))), lanes_add(lanes_add(_s48, lanes_mul(vz_6, tz_1)), lanes_mul(vz_7, tz_0))));
    return (LANES(court_roll_7_out)){ _s19, _s23, _s32, _s36, _s39, _s42, _s45, lanes_mul(K(0.125), _s7), lanes_mul(K(0.125), _s15), lanes_mul(K(0.125), _s17), lanes_neg(_s49) };
}

/* Start value of the normal where the flight began: another surface.
   Table 1. No operations. */
typedef struct {
    V left_nx, left_ny, left_nz;
} LANES(court_other_start_surface_out);

LANES_INLINE LANES(court_other_start_surface_out)
LANES(court_other_start_surface)(void)
{
    return (LANES(court_other_start_surface_out)){ K(0.0), K(0.0), K(0.0) };
}

/* Position at the start of a flight.
   Eq. 3. 8 operations: 1 addition, 3 subtractions, 4 multiplications. */
typedef struct {
    V from_x, from_y, from_z;
} LANES(court_started_out);

LANES_INLINE LANES(court_started_out)
LANES(court_started)(V x, V y, V z, V vx, V vy, V vz, V t, V _c0)
{
    return (LANES(court_started_out)){ lanes_sub(x, lanes_mul(vx, t)), lanes_sub(y, lanes_mul(vy, t)), lanes_sub(z, lanes_mul(t, lanes_add(vz, lanes_mul(_c0, t)))) };
}

/* Constant terms of the series.
   rolling. 6 operations: 2 additions, 4 multiplications. */
typedef struct {
    V vx_0, vy_0, vz_0, nx_0, ny_0, nz_0, turn_rate_0;
} LANES(court_roll_start_out);

LANES_INLINE LANES(court_roll_start_out)
LANES(court_roll_start)(V nx, V ny, V nz, V vx, V vy, V vz, V wx, V wy, V wz, V _c0)
{
    return (LANES(court_roll_start_out)){ vx, vy, vz, nx, ny, nz, lanes_mul(_c0, lanes_add(lanes_add(lanes_mul(nx, wx), lanes_mul(ny, wy)), lanes_mul(nz, wz))) };
}

/* Position, velocity and turn rate of a rolling ball at time t.
   its series. 142 operations: 59 additions, 83 multiplications. */
typedef struct {
    V x, vx, y, vy, z, vz, turn_rate;
} LANES(court_roll_moved_out);

LANES_INLINE LANES(court_roll_moved_out)
LANES(court_roll_moved)(V x, V y, V z, V vx_0, V vx_1, V vx_2, V vx_3, V vx_4, V vx_5, V vx_6, V vx_7, V vx_8, V vy_0, V vy_1, V vy_2, V vy_3, V vy_4, V vy_5, V vy_6, V vy_7, V vy_8, V vz_0, V vz_1, V vz_2, V vz_3, V vz_4, V vz_5, V vz_6, V vz_7, V vz_8, V t, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V turn_rate_4, V turn_rate_5, V turn_rate_6, V turn_rate_7, V turn_rate_8)
{
    const V _s0 = lanes_mul(t, lanes_add(lanes_mul(K(0.14285714285714285), vx_6), lanes_mul(t, lanes_add(lanes_mul(K(0.125), vx_7), lanes_mul(lanes_mul(K(0.1111111111111111), vx_8), t)))));
    const V _s1 = lanes_add(lanes_mul(K(0.25), vx_3), lanes_mul(t, lanes_add(lanes_mul(K(0.2), vx_4), lanes_mul(t, lanes_add(lanes_mul(K(0.16666666666666666), vx_5), _s0)))));
    const V _s2 = lanes_add(vx_0, lanes_mul(t, lanes_add(lanes_mul(K(0.5), vx_1), lanes_mul(t, lanes_add(lanes_mul(K(0.3333333333333333), vx_2), lanes_mul(t, _s1))))));
    const V _s3 = lanes_add(vx_5, lanes_mul(t, lanes_add(vx_6, lanes_mul(t, lanes_add(vx_7, lanes_mul(vx_8, t))))));
    const V _s4 = lanes_add(vx_2, lanes_mul(t, lanes_add(vx_3, lanes_mul(t, lanes_add(vx_4, lanes_mul(t, _s3))))));
    const V _s5 = lanes_mul(t, lanes_add(lanes_mul(K(0.14285714285714285), vy_6), lanes_mul(t, lanes_add(lanes_mul(K(0.125), vy_7), lanes_mul(lanes_mul(K(0.1111111111111111), vy_8), t)))));
    const V _s6 = lanes_add(lanes_mul(K(0.25), vy_3), lanes_mul(t, lanes_add(lanes_mul(K(0.2), vy_4), lanes_mul(t, lanes_add(lanes_mul(K(0.16666666666666666), vy_5), _s5)))));
    const V _s7 = lanes_add(vy_0, lanes_mul(t, lanes_add(lanes_mul(K(0.5), vy_1), lanes_mul(t, lanes_add(lanes_mul(K(0.3333333333333333), vy_2), lanes_mul(t, _s6))))));
    const V _s8 = lanes_add(vy_5, lanes_mul(t, lanes_add(vy_6, lanes_mul(t, lanes_add(vy_7, lanes_mul(vy_8, t))))));
    const V _s9 = lanes_add(vy_2, lanes_mul(t, lanes_add(vy_3, lanes_mul(t, lanes_add(vy_4, lanes_mul(t, _s8))))));
    const V _s10 = lanes_mul(t, lanes_add(lanes_mul(K(0.14285714285714285), vz_6), lanes_mul(t, lanes_add(lanes_mul(K(0.125), vz_7), lanes_mul(lanes_mul(K(0.1111111111111111), vz_8), t)))));
    const V _s11 = lanes_add(lanes_mul(K(0.25), vz_3), lanes_mul(t, lanes_add(lanes_mul(K(0.2), vz_4), lanes_mul(t, lanes_add(lanes_mul(K(0.16666666666666666), vz_5), _s10)))));
    const V _s12 = lanes_add(vz_0, lanes_mul(t, lanes_add(lanes_mul(K(0.5), vz_1), lanes_mul(t, lanes_add(lanes_mul(K(0.3333333333333333), vz_2), lanes_mul(t, _s11))))));
    const V _s13 = lanes_add(vz_5, lanes_mul(t, lanes_add(vz_6, lanes_mul(t, lanes_add(vz_7, lanes_mul(vz_8, t))))));
    const V _s14 = lanes_add(vz_2, lanes_mul(t, lanes_add(vz_3, lanes_mul(t, lanes_add(vz_4, lanes_mul(t, _s13))))));
    const V _s15 = lanes_add(turn_rate_5, lanes_mul(t, lanes_add(turn_rate_6, lanes_mul(t, lanes_add(turn_rate_7, lanes_mul(t, turn_rate_8))))));
    const V _s16 = lanes_add(turn_rate_2, lanes_mul(t, lanes_add(turn_rate_3, lanes_mul(t, lanes_add(turn_rate_4, lanes_mul(t, _s15))))));
    return (LANES(court_roll_moved_out)){ lanes_add(x, lanes_mul(t, _s2)), lanes_add(vx_0, lanes_mul(t, lanes_add(vx_1, lanes_mul(t, _s4)))), lanes_add(y, lanes_mul(t, _s7)), lanes_add(vy_0, lanes_mul(t, lanes_add(vy_1, lanes_mul(t, _s9)))), lanes_add(z, lanes_mul(t, _s12)), lanes_add(vz_0, lanes_mul(t, lanes_add(vz_1, lanes_mul(t, _s14)))), lanes_add(turn_rate_0, lanes_mul(t, lanes_add(turn_rate_1, lanes_mul(t, _s16)))) };
}

/* State of a ball put onto the surface, rolling.
   v = R_B (w × n). 35 operations: 5 additions, 9 subtractions, 21 multiplications. */
typedef struct {
    V x, y, z, vx, vy, vz, wx, wy, wz;
} LANES(court_roll_placed_out);

LANES_INLINE LANES(court_roll_placed_out)
LANES(court_roll_placed)(V x, V y, V z, V nx, V ny, V nz, V vx, V vy, V vz, V gap, V turn_rate, V _c0)
{
    const V _s0 = lanes_add(lanes_add(lanes_mul(nx, vx), lanes_mul(ny, vy)), lanes_mul(nz, vz));
    const V _s1 = lanes_sub(vx, lanes_mul(nx, _s0));
    const V _s2 = lanes_sub(vy, lanes_mul(ny, _s0));
    const V _s3 = lanes_sub(vz, lanes_mul(nz, _s0));
    return (LANES(court_roll_placed_out)){ lanes_sub(x, lanes_mul(nx, gap)), lanes_sub(y, lanes_mul(ny, gap)), lanes_sub(z, lanes_mul(nz, gap)), _s1, _s2, _s3, lanes_mul(_c0, lanes_sub(lanes_add(lanes_mul(nx, turn_rate), lanes_mul(ny, _s3)), lanes_mul(nz, _s2))), lanes_mul(_c0, lanes_sub(lanes_add(lanes_mul(ny, turn_rate), lanes_mul(nz, _s1)), lanes_mul(nx, _s3))), lanes_mul(_c0, lanes_sub(lanes_add(lanes_mul(nx, _s2), lanes_mul(nz, turn_rate)), lanes_mul(ny, _s1))) };
}

/* Length of a step of the series, bounds of the motion in it, and the normal force.
   the last terms of the series. 166 operations: 53 additions, 56 multiplications, 1 division, 4 square roots, 2 negations, 46 absolute values, 2 comparisons, 2 selections. */
typedef struct {
    V stride, missed, strongest, fastest, force, force_rate, force_bend, friction_force_rate;
} LANES(court_roll_step_out);

LANES_INLINE LANES(court_roll_step_out)
LANES(court_roll_step)(V nx_8, V ny_8, V nz_0, V nz_1, V nz_2, V nz_3, V nz_4, V nz_5, V nz_6, V nz_7, V nz_8, V vx_0, V vx_1, V vx_2, V vx_3, V vx_4, V vx_5, V vx_6, V vx_7, V vx_8, V vy_0, V vy_1, V vy_2, V vy_3, V vy_4, V vy_5, V vy_6, V vy_7, V vy_8, V vz_0, V vz_1, V vz_2, V vz_3, V vz_4, V vz_5, V vz_6, V vz_7, V vz_8, V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V turn_rate_4, V turn_rate_5, V turn_rate_6, V turn_rate_7, V turn_rate_8, V lift_0, V lift_1, V lift_2, V lift_3, V lift_4, V lift_5, V lift_6, V lift_7, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_add(lanes_add(lanes_add(lanes_abs(vx_0), lanes_abs(vy_0)), lanes_abs(vz_0)), lanes_abs(turn_rate_0));
    const V _s1 = lanes_add(_c1, _s0);
    const V _s2 = lanes_abs(per_reach);
    const V _s3 = lanes_add(lanes_add(lanes_add(lanes_abs(vx_7), lanes_abs(vy_7)), lanes_abs(vz_7)), lanes_abs(turn_rate_7));
    const V _s4 = lanes_add(lanes_add(lanes_add(lanes_abs(vx_8), lanes_abs(vy_8)), lanes_abs(vz_8)), lanes_abs(turn_rate_8));
    const V _s5 = lanes_add(lanes_mul(lanes_add(lanes_mul(_s2, _s0), lanes_sqrt(lanes_mul(_c0, _s2))), _s3), _s4);
    const V _s6 = lanes_mul(_s1, lanes_add(lanes_add(lanes_abs(nx_8), lanes_abs(ny_8)), lanes_abs(nz_8)));
    const V _s7 = lanes_sqrt(lanes_sqrt(lanes_sqrt(lanes_div(lanes_mul(K(1.4210854715202004e-14), _s1), lanes_max(_s5, _s6)))));
    const V _s8 = lanes_min(_s7, K(1.0));
    const V _s9 = lanes_mul(lanes_mul(K(2.0), lanes_add(lanes_add(lanes_add(lanes_abs(vx_2), lanes_abs(vy_2)), lanes_abs(vz_2)), lanes_abs(turn_rate_2))), _s8);
    const V _s10 = lanes_mul(_s8, _s8);
    const V _s11 = lanes_mul(lanes_mul(K(3.0), lanes_add(lanes_add(lanes_add(lanes_abs(vx_3), lanes_abs(vy_3)), lanes_abs(vz_3)), lanes_abs(turn_rate_3))), _s10);
    const V _s12 = lanes_mul(_s8, _s10);
    const V _s13 = lanes_mul(lanes_mul(K(4.0), lanes_add(lanes_add(lanes_add(lanes_abs(vx_4), lanes_abs(vy_4)), lanes_abs(vz_4)), lanes_abs(turn_rate_4))), _s12);
    const V _s14 = lanes_mul(_s10, _s10);
    const V _s15 = lanes_mul(lanes_mul(K(5.0), lanes_add(lanes_add(lanes_add(lanes_abs(vx_5), lanes_abs(vy_5)), lanes_abs(vz_5)), lanes_abs(turn_rate_5))), _s14);
    const V _s16 = lanes_mul(_s8, _s14);
    const V _s17 = lanes_mul(lanes_mul(K(6.0), lanes_add(lanes_add(lanes_add(lanes_abs(vx_6), lanes_abs(vy_6)), lanes_abs(vz_6)), lanes_abs(turn_rate_6))), _s16);
    const V _s18 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s9, _s11), _s13), _s15), _s17), lanes_mul(lanes_mul(K(7.0), _s3), lanes_mul(_s10, _s14))), lanes_mul(lanes_mul(K(8.0), _s4), lanes_mul(_s12, _s14)));
    const V _s19 = lanes_add(_s18, lanes_add(lanes_add(lanes_add(lanes_abs(vx_1), lanes_abs(vy_1)), lanes_abs(vz_1)), lanes_abs(turn_rate_1)));
    const V _s20 = lanes_mul(_c0, nz_1);
    const V _s21 = lanes_mul(lanes_mul(K(6.0), lanes_abs(lanes_add(lift_3, lanes_mul(lanes_mul(_c0, nz_3), _c2)))), _s8);
    const V _s22 = lanes_mul(lanes_mul(K(12.0), lanes_abs(lanes_add(lift_4, lanes_mul(lanes_mul(_c0, nz_4), _c2)))), _s10);
    const V _s23 = lanes_mul(lanes_mul(K(20.0), lanes_abs(lanes_add(lift_5, lanes_mul(lanes_mul(_c0, nz_5), _c2)))), _s12);
    const V _s24 = lanes_mul(lanes_mul(K(30.0), lanes_abs(lanes_add(lift_6, lanes_mul(lanes_mul(_c0, nz_6), _c2)))), _s14);
    const V _s25 = lanes_mul(lanes_mul(K(42.0), lanes_abs(lanes_add(lift_7, lanes_mul(lanes_mul(_c0, nz_7), _c2)))), _s16);
    const V _s26 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s21, _s22), _s23), _s24), _s25), lanes_mul(K(2.0), lanes_abs(lanes_add(lift_2, lanes_mul(lanes_mul(_c0, nz_2), _c2)))));
    return (LANES(court_roll_step_out)){ _s8, lanes_mul(K(1.7763568394002505e-15), _s1), _s19, lanes_add(lanes_mul(_s19, _s8), _s0), lanes_add(lift_0, lanes_mul(lanes_mul(_c0, nz_0), _c2)), lanes_add(lift_1, lanes_mul(_s20, _c2)), _s26, lanes_neg(lanes_mul(lanes_mul(K(2.0), lanes_neg(_s20)), _c2)) };
}

/* 1 if a ball that may stay on a surface is on a seam of it, within the errors.
   Table 1. 13 operations: 4 additions, 2 multiplications, 4 absolute values, 1 comparison, 1 conjunction, 1 selection. */
typedef struct {
    V uncertain;
} LANES(court_seam_undecided_out);

LANES_INLINE LANES(court_seam_undecided_out)
LANES(court_seam_undecided)(V x, V y, V z, V gap, V position_error, V uncertain, M nearly, V _c0)
{
    const V _s0 = lanes_add(lanes_mul(K(4.0), position_error), lanes_mul(K(8.881784197001252e-16), lanes_add(lanes_add(lanes_add(_c0, lanes_abs(x)), lanes_abs(y)), lanes_abs(z))));
    return (LANES(court_seam_undecided_out)){ lanes_select(lanes_both(nearly, lanes_at_most(lanes_abs(gap), _s0)), K(1.0), uncertain) };
}

/* Spin about the normal, times the ball's radius.
   s = R_B (w·n). 6 operations: 2 additions, 4 multiplications. */
typedef struct {
    V turn_rate;
} LANES(court_roll_turn_rate_out);

LANES_INLINE LANES(court_roll_turn_rate_out)
LANES(court_roll_turn_rate)(V nx, V ny, V nz, V wx, V wy, V wz, V _c0)
{
    return (LANES(court_roll_turn_rate_out)){ lanes_mul(_c0, lanes_add(lanes_add(lanes_mul(nx, wx), lanes_mul(ny, wy)), lanes_mul(nz, wz))) };
}

/* Normal force, its part from free fall, friction and acceleration of a rolling ball.
   N = -a·n - v·n', F = beta (-a_t + s n × n'). 52 operations: 13 additions, 5 subtractions, 31 multiplications, 1 square root, 2 negations. */
typedef struct {
    V press, weight, rolling_friction, rolling_acceleration_x, rolling_acceleration_y, rolling_acceleration_z;
} LANES(court_pressed_on_out);

LANES_INLINE LANES(court_pressed_on_out)
LANES(court_pressed_on)(V nx, V ny, V nz, V wx, V wy, V wz, V rolled_x, V rolled_y, V rolled_z, V turning_x, V turning_y, V turning_z, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_neg(lanes_mul(_c1, nz));
    const V _s1 = lanes_sub(lanes_neg(_s0), lanes_add(lanes_add(lanes_mul(rolled_x, turning_x), lanes_mul(rolled_y, turning_y)), lanes_mul(rolled_z, turning_z)));
    const V _s2 = lanes_add(lanes_add(lanes_mul(nx, wx), lanes_mul(ny, wy)), lanes_mul(nz, wz));
    const V _s3 = lanes_mul(lanes_add(lanes_mul(nx, _s0), lanes_mul(lanes_mul(_c0, lanes_sub(lanes_mul(ny, turning_z), lanes_mul(nz, turning_y))), _s2)), _c2);
    const V _s4 = lanes_mul(lanes_add(lanes_mul(ny, _s0), lanes_mul(lanes_mul(_c0, lanes_sub(lanes_mul(nz, turning_x), lanes_mul(nx, turning_z))), _s2)), _c2);
    const V _s5 = lanes_mul(lanes_add(lanes_add(_c1, lanes_mul(nz, _s0)), lanes_mul(lanes_mul(_c0, lanes_sub(lanes_mul(nx, turning_y), lanes_mul(ny, turning_x))), _s2)), _c2);
    return (LANES(court_pressed_on_out)){ _s1, _s0, lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s3, _s3), lanes_mul(_s4, _s4)), lanes_mul(_s5, _s5))), lanes_add(lanes_mul(nx, _s1), _s3), lanes_add(lanes_mul(ny, _s1), _s4), lanes_sub(lanes_add(lanes_mul(nz, _s1), _s5), _c1) };
}

/* Whether a ball leaves so slowly that its bounces may end here.
   Table 1. 19 operations: 5 additions, 8 multiplications, 1 division, 3 comparisons, 1 conjunction, 1 disjunction. */
typedef struct {
    M slow;
    V assured;
} LANES(court_leaves_slowly_out);

LANES_INLINE LANES(court_leaves_slowly_out)
LANES(court_leaves_slowly)(V nx, V ny, V nz, V vx, V vy, V vz, V position_error, V _c0, V _c1, V _c2, V _c3)
{
    const V _s0 = lanes_add(lanes_add(lanes_mul(nx, vx), lanes_mul(ny, vy)), lanes_mul(nz, vz));
    const V _s1 = lanes_mul(_s0, _s0);
    const V _s2 = lanes_mul(_c2, lanes_add(_c1, lanes_div(lanes_add(lanes_add(lanes_mul(vx, vx), lanes_mul(vy, vy)), lanes_mul(vz, vz)), _c0)));
    return (LANES(court_leaves_slowly_out)){ lanes_either(lanes_less(_s1, _s2), lanes_both(lanes_less(_s1, _c3), lanes_less(K(0.0), position_error))), K(0.0) };
}

/* Whether this bounce is so small that it may be the last.
   half a hop's height. 15 operations: 5 additions, 8 multiplications, 1 division, 1 comparison. */
typedef struct {
    M nearly;
} LANES(court_nearly_out);

LANES_INLINE LANES(court_nearly_out)
LANES(court_nearly)(V nx, V ny, V nz, V vx, V vy, V vz, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_add(lanes_add(lanes_mul(nx, vx), lanes_mul(ny, vy)), lanes_mul(nz, vz));
    const V _s1 = lanes_mul(_c2, lanes_add(_c1, lanes_div(lanes_add(lanes_add(lanes_mul(vx, vx), lanes_mul(vy, vy)), lanes_mul(vz, vz)), _c0)));
    return (LANES(court_nearly_out)){ lanes_less(lanes_mul(_s0, _s0), _s1) };
}

/* Velocity after the contact point stops; its slip, and the speed off the surface.
   the momenta that a contact conserves. 40 operations: 4 additions, 12 subtractions, 21 multiplications, 1 square root, 1 comparison, 1 selection. */
typedef struct {
    V rolled_x, rolled_y, rolled_z, slip, bounce;
} LANES(court_gripped_out);

LANES_INLINE LANES(court_gripped_out)
LANES(court_gripped)(V nx, V ny, V nz, V vx, V vy, V vz, V wx, V wy, V wz, V _c0, V _c1)
{
    const V _s0 = lanes_add(lanes_add(lanes_mul(nx, vx), lanes_mul(ny, vy)), lanes_mul(nz, vz));
    const V _s1 = lanes_sub(vx, lanes_mul(nx, _s0));
    const V _s2 = lanes_sub(_s1, lanes_mul(_c0, lanes_sub(lanes_mul(nz, wy), lanes_mul(ny, wz))));
    const V _s3 = lanes_sub(vy, lanes_mul(ny, _s0));
    const V _s4 = lanes_sub(_s3, lanes_mul(_c0, lanes_sub(lanes_mul(nx, wz), lanes_mul(nz, wx))));
    const V _s5 = lanes_sub(vz, lanes_mul(nz, _s0));
    const V _s6 = lanes_sub(_s5, lanes_mul(_c0, lanes_sub(lanes_mul(ny, wx), lanes_mul(nx, wy))));
    return (LANES(court_gripped_out)){ lanes_sub(_s1, lanes_mul(_c1, _s2)), lanes_sub(_s3, lanes_mul(_c1, _s4)), lanes_sub(_s5, lanes_mul(_c1, _s6)), lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s6, _s6), lanes_mul(_s4, _s4)), lanes_mul(_s2, _s2))), lanes_max(K(0.0), _s0) };
}

/* Start values: no surface beside the ball.
   Table 1. No operations. */
typedef struct {
    V nearest, second_contact_gap;
} LANES(court_isolated_out);

LANES_INLINE LANES(court_isolated_out)
LANES(court_isolated)(void)
{
    return (LANES(court_isolated_out)){ K(INFINITY), K(INFINITY) };
}

/* Distance to a body beside a rolling ball, and whether it holds the ball, too.
   Table 1. 18 operations: 1 addition, 4 multiplications, 1 division, 2 absolute values, 5 comparisons, 1 conjunction, 4 selections. */
typedef struct {
    V nearest, second_contact_gap;
} LANES(court_near_body_out);

LANES_INLINE LANES(court_near_body_out)
LANES(court_near_body)(V gap, V nearest, V second_contact_gap, V rolling_gap_acceleration, V normal_cosine, V press, V nearing)
{
    const V _s0 = lanes_abs(gap);
    const V _s1 = lanes_abs(rolling_gap_acceleration);
    const V _s2 = lanes_mul(K(9.5367431640625e-07), press);
    const V _s3 = lanes_select(lanes_both(lanes_less(rolling_gap_acceleration, lanes_mul(K(9.094947017729282e-13), press)), lanes_less(normal_cosine, K(0.9999990463256836))), lanes_add(lanes_div(lanes_mul(K(0.5), lanes_mul(nearing, nearing)), lanes_max(_s1, _s2)), _s0), K(INFINITY));
    return (LANES(court_near_body_out)){ lanes_min(_s0, nearest), lanes_min(_s3, second_contact_gap) };
}

/* Distance to an end plane beside the ball.
   Table 1. 3 operations: 1 absolute value, 1 comparison, 1 selection. */
typedef struct {
    V nearest;
} LANES(court_near_end_plane_out);

LANES_INLINE LANES(court_near_end_plane_out)
LANES(court_near_end_plane)(V gap, V nearest)
{
    const V _s0 = lanes_abs(gap);
    return (LANES(court_near_end_plane_out)){ lanes_min(_s0, nearest) };
}

/* Errors with those of the jump to the end of the bounces.
   its bound. 38 operations: 12 additions, 1 multiplication, 2 divisions, 2 negations, 3 absolute values, 9 comparisons, 9 selections. */
typedef struct {
    V dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz;
} LANES(court_jump_errors_out);

LANES_INLINE LANES(court_jump_errors_out)
LANES(court_jump_errors)(V vx, V vy, V vz, V dx, V dy, V dz, V dvx, V dvy, V dvz, V dwx, V dwy, V dwz, V _c0, V _c1, V _c2, V _c3)
{
    const V _s0 = lanes_mul(_c3, lanes_add(K(1.0), lanes_div(lanes_add(lanes_add(lanes_abs(vx), lanes_abs(vy)), lanes_abs(vz)), _c0)));
    const V _s1 = lanes_neg(_s0);
    const V _s2 = lanes_div(_s0, _c0);
    const V _s3 = lanes_neg(_s2);
    return (LANES(court_jump_errors_out)){ lanes_add(dx, lanes_select(lanes_less(dx, K(0.0)), _c2, _c1)), lanes_add(dy, lanes_select(lanes_less(dy, K(0.0)), _c2, _c1)), lanes_add(dz, lanes_select(lanes_less(dz, K(0.0)), _c2, _c1)), lanes_add(dvx, lanes_select(lanes_less(dvx, K(0.0)), _s1, _s0)), lanes_add(dvy, lanes_select(lanes_less(dvy, K(0.0)), _s1, _s0)), lanes_add(dvz, lanes_select(lanes_less(dvz, K(0.0)), _s1, _s0)), lanes_add(dwx, lanes_select(lanes_less(dwx, K(0.0)), _s3, _s2)), lanes_add(dwy, lanes_select(lanes_less(dwy, K(0.0)), _s3, _s2)), lanes_add(dwz, lanes_select(lanes_less(dwz, K(0.0)), _s3, _s2)) };
}

/* Whether the normal force vanishes or the ball rests; else a time for which neither can.
   N = 0. 81 operations: 12 additions, 1 subtraction, 17 multiplications, 2 divisions, 1 square root, 2 negations, 8 absolute values, 14 comparisons, 7 conjunctions, 3 disjunctions, 3 complements, 11 selections. */
typedef struct {
    V stride, which;
    M rests;
    V undecided_time;
} LANES(court_leaving_force_out);

LANES_INLINE LANES(court_leaving_force_out)
LANES(court_leaving_force)(V vx, V vx_1, V vy, V vy_1, V vz, V vz_1, V which, V undecided_time, V position_error, V velocity_error, V per_reach, V force, V force_rate, V force_bend, V friction_force_rate, V stride, V fastest, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_abs(per_reach);
    const V _s1 = lanes_add(_c0, lanes_mul(lanes_mul(fastest, fastest), _s0));
    const V _s2 = lanes_mul(K(5.684341886080802e-14), _s1);
    const M _s3 = lanes_less(force_rate, K(0.0));
    const M _s4 = lanes_either(lanes_less(force, lanes_neg(_s2)), lanes_both(lanes_at_most(force, _s2), _s3));
    const V _s5 = lanes_neg(lanes_add(force_rate, friction_force_rate));
    const V _s6 = lanes_add(force, lanes_select(lanes_less(_s5, K(0.0)), lanes_div(lanes_mul(_s5, _s5), lanes_mul(_c0, lanes_mul(_s0, _s1))), K(0.0)));
    const M _s7 = lanes_both(_s4, lanes_less(_s2, _s6));
    const M _s8 = lanes_both(_s4, lanes_not(_s7));
    const M _s9 = lanes_both(lanes_at_most(lanes_add(lanes_add(lanes_abs(vx), lanes_abs(vy)), lanes_abs(vz)), _c1), lanes_at_most(lanes_add(lanes_add(lanes_abs(vx_1), lanes_abs(vy_1)), lanes_abs(vz_1)), _c2));
    const V _s10 = lanes_mul(force_rate, force_rate);
    const V _s11 = lanes_add(force_bend, lanes_mul(K(9.094947017729282e-13), _s1));
    const V _s12 = lanes_select(_s7, _s6, lanes_max(force, K(0.0)));
    const V _s13 = lanes_add(_s10, lanes_mul(lanes_mul(K(2.0), _s11), _s12));
    const V _s14 = lanes_sqrt(_s13);
    const V _s15 = lanes_select(lanes_at_most(K(0.0), _s13), lanes_div(lanes_select(_s3, lanes_mul(K(2.0), _s12), lanes_add(force_rate, _s14)), lanes_select(_s3, lanes_sub(_s14, force_rate), lanes_max(K(0.0), _s11))), K(INFINITY));
    const V _s16 = lanes_add(lanes_mul(lanes_mul(K(8.0), _s0), lanes_add(lanes_mul(position_error, _s1), lanes_mul(velocity_error, fastest))), _s2);
    const M _s17 = lanes_either(_s7, lanes_both(lanes_at_most(lanes_abs(force), _s16), lanes_not(lanes_less(lanes_mul(lanes_mul(K(8.0), _s11), _s16), _s10))));
    return (LANES(court_leaving_force_out)){ lanes_select(lanes_either(_s8, _s9), K(0.0), lanes_min(_s15, stride)), lanes_select(lanes_both(_s8, lanes_equal(which, K(-1.0))), K(6.0), which), lanes_both(_s9, lanes_not(_s8)), lanes_select(_s17, K(0.0), undecided_time) };
}

/* Whether a rolling ball meets another surface; else a time for which it cannot.
   a parabola below the distance. 54 operations: 7 additions, 1 subtraction, 11 multiplications, 2 divisions, 1 square root, 1 negation, 4 absolute values, 9 comparisons, 5 conjunctions, 1 disjunction, 2 complements, 10 selections. */
typedef struct {
    V stride, which, undecided_time, earliest_delay;
} LANES(court_beside_body_out);

LANES_INLINE LANES(court_beside_body_out)
LANES(court_beside_body)(V x, V y, V z, V gap, V index, V which, V earliest_delay, V undecided_time, V position_error, V nearing, V gap_curvature, V stride, V strongest, V fastest, V _c0, V _c1)
{
    const V _s0 = lanes_mul(K(7.105427357601002e-15), lanes_add(lanes_add(lanes_add(_c0, lanes_abs(x)), lanes_abs(y)), lanes_abs(z)));
    const M _s1 = lanes_at_most(gap, _s0);
    const M _s2 = lanes_less(nearing, K(0.0));
    const M _s3 = lanes_both(_s1, _s2);
    const V _s4 = lanes_mul(nearing, nearing);
    const V _s5 = lanes_add(strongest, lanes_mul(gap_curvature, lanes_mul(fastest, fastest)));
    const V _s6 = lanes_select(_s1, _c1, gap);
    const V _s7 = lanes_add(_s4, lanes_mul(lanes_mul(K(2.0), _s5), _s6));
    const V _s8 = lanes_sqrt(_s7);
    const V _s9 = lanes_select(lanes_at_most(K(0.0), _s7), lanes_div(lanes_select(_s2, lanes_mul(K(2.0), _s6), lanes_add(nearing, _s8)), lanes_select(_s2, lanes_sub(_s8, nearing), lanes_max(K(0.0), _s5))), K(INFINITY));
    const M _s10 = lanes_equal(which, K(-1.0));
    const M _s11 = lanes_both(_s3, _s10);
    const V _s12 = lanes_add(lanes_mul(K(2.0), position_error), _s0);
    const M _s13 = lanes_either(lanes_both(lanes_both(lanes_at_most(gap, _s12), lanes_at_most(lanes_neg(_s12), gap)), lanes_not(lanes_less(lanes_mul(lanes_mul(K(8.0), _s12), _s5), _s4))), lanes_both(_s3, lanes_not(_s10)));
    return (LANES(court_beside_body_out)){ lanes_select(_s3, K(0.0), lanes_min(_s9, stride)), lanes_select(_s11, index, which), lanes_select(_s13, K(0.0), undecided_time), lanes_select(_s11, lanes_div(lanes_mul(K(2.0), _s12), lanes_abs(nearing)), earliest_delay) };
}

/* Whether a rolling ball crosses an end plane; else a time for which it cannot.
   a parabola below the distance. 60 operations: 7 additions, 1 subtraction, 11 multiplications, 2 divisions, 1 square root, 2 negations, 4 absolute values, 12 comparisons, 6 conjunctions, 1 disjunction, 2 complements, 11 selections. */
typedef struct {
    V stride, which, undecided_time, earliest_delay;
} LANES(court_beside_end_plane_out);

LANES_INLINE LANES(court_beside_end_plane_out)
LANES(court_beside_end_plane)(V x, V y, V z, V gap, V index, V which, V earliest_delay, V undecided_time, V position_error, V nearing, V gap_curvature, V stride, V strongest, V fastest, V _c0)
{
    const V _s0 = lanes_mul(K(7.105427357601002e-15), lanes_add(lanes_add(lanes_add(_c0, lanes_abs(x)), lanes_abs(y)), lanes_abs(z)));
    const M _s1 = lanes_less(nearing, K(0.0));
    const M _s2 = lanes_both(lanes_both(lanes_at_most(gap, _s0), _s1), lanes_at_most(lanes_neg(_s0), gap));
    const V _s3 = lanes_mul(nearing, nearing);
    const V _s4 = lanes_add(strongest, lanes_mul(gap_curvature, lanes_mul(fastest, fastest)));
    const V _s5 = lanes_max(gap, K(0.0));
    const V _s6 = lanes_add(_s3, lanes_mul(lanes_mul(K(2.0), _s4), _s5));
    const V _s7 = lanes_sqrt(_s6);
    const V _s8 = lanes_select(lanes_less(K(0.0), gap), lanes_select(lanes_at_most(K(0.0), _s6), lanes_div(lanes_select(_s1, lanes_mul(K(2.0), _s5), lanes_add(nearing, _s7)), lanes_select(_s1, lanes_sub(_s7, nearing), lanes_max(K(0.0), _s4))), K(INFINITY)), K(INFINITY));
    const M _s9 = lanes_equal(which, K(-1.0));
    const M _s10 = lanes_both(_s2, _s9);
    const V _s11 = lanes_add(lanes_mul(K(2.0), position_error), _s0);
    const M _s12 = lanes_either(lanes_both(lanes_both(lanes_at_most(gap, _s11), lanes_at_most(lanes_neg(_s11), gap)), lanes_not(lanes_less(lanes_mul(lanes_mul(K(8.0), _s11), _s4), _s3))), lanes_both(_s2, lanes_not(_s9)));
    return (LANES(court_beside_end_plane_out)){ lanes_select(_s2, K(0.0), lanes_min(_s8, stride)), lanes_select(_s10, index, which), lanes_select(_s12, K(0.0), undecided_time), lanes_select(_s10, lanes_div(lanes_mul(K(2.0), _s11), lanes_abs(nearing)), earliest_delay) };
}

/* Time for which a rolling ball certainly stays on one part of its surface.
   a parabola below the distance. 28 operations: 3 additions, 1 subtraction, 5 multiplications, 1 division, 1 square root, 1 negation, 2 absolute values, 6 comparisons, 8 selections. */
typedef struct {
    V stride;
} LANES(court_beside_seam_out);

LANES_INLINE LANES(court_beside_seam_out)
LANES(court_beside_seam)(V gap, V near, V nearing, V stride, V strongest, V fastest)
{
    const V _s0 = lanes_abs(gap);
    const M _s1 = lanes_at_most(_s0, near);
    const V _s2 = lanes_select(_s1, K(0.0), _s0);
    const V _s3 = lanes_select(_s1, lanes_add(lanes_mul(K(9.5367431640625e-07), fastest), lanes_abs(nearing)), lanes_select(lanes_less(K(0.0), gap), nearing, lanes_neg(nearing)));
    const V _s4 = lanes_add(lanes_mul(lanes_mul(K(2.0), strongest), _s2), lanes_mul(_s3, _s3));
    const V _s5 = lanes_sqrt(_s4);
    const M _s6 = lanes_less(_s3, K(0.0));
    const V _s7 = lanes_select(lanes_at_most(K(0.0), _s4), lanes_div(lanes_select(_s6, lanes_mul(K(2.0), _s2), lanes_add(_s5, _s3)), lanes_select(_s6, lanes_sub(_s5, _s3), lanes_max(K(0.0), strongest))), K(INFINITY));
    return (LANES(court_beside_seam_out)){ lanes_min(_s7, stride) };
}

/* The time limit as an event in contact.
   Table 1. 10 operations: 1 subtraction, 4 comparisons, 1 conjunction, 1 complement, 3 selections. */
typedef struct {
    V stride, which;
} LANES(court_beside_time_out);

LANES_INLINE LANES(court_beside_time_out)
LANES(court_beside_time)(V which, V clock, V time_limit, V stride)
{
    const V _s0 = lanes_sub(time_limit, clock);
    const V _s1 = lanes_min(_s0, stride);
    return (LANES(court_beside_time_out)){ lanes_max(K(0.0), _s1), lanes_select(lanes_both(lanes_not(lanes_less(clock, time_limit)), lanes_equal(which, K(-1.0))), K(4.0), which) };
}

/* Time after a step, and whether another step follows.
   Table 1. 4 operations: 1 addition, 1 comparison, 1 conjunction, 1 complement. */
typedef struct {
    V clock;
    M rolling;
} LANES(court_rolled_on_out);

LANES_INLINE LANES(court_rolled_on_out)
LANES(court_rolled_on)(V which, V clock, V stride, M rests)
{
    return (LANES(court_rolled_on_out)){ lanes_add(clock, stride), lanes_both(lanes_equal(which, K(-1.0)), lanes_not(rests)) };
}

/* Start value: no surface beside the ball.
   Table 1. No operations. */
typedef struct {
    V free_time;
} LANES(court_no_contact_out);

LANES_INLINE LANES(court_no_contact_out)
LANES(court_no_contact)(void)
{
    return (LANES(court_no_contact_out)){ K(INFINITY) };
}

/* Time for which a ball that leaves certainly meets no other body.
   a parabola below the distance. 29 operations: 6 additions, 1 subtraction, 6 multiplications, 1 division, 1 square root, 3 absolute values, 5 comparisons, 6 selections. */
typedef struct {
    V free_time;
} LANES(court_neighbour_free_time_out);

LANES_INLINE LANES(court_neighbour_free_time_out)
LANES(court_neighbour_free_time)(V vx, V vy, V vz, V gap, V free_time, V nearing, V gap_curvature, V _c0, V _c1)
{
    const V _s0 = lanes_add(lanes_add(lanes_add(_c1, lanes_abs(vx)), lanes_abs(vy)), lanes_abs(vz));
    const V _s1 = lanes_add(_c0, lanes_mul(gap_curvature, lanes_mul(_s0, _s0)));
    const V _s2 = lanes_max(gap, K(0.0));
    const V _s3 = lanes_add(lanes_mul(nearing, nearing), lanes_mul(lanes_mul(K(2.0), _s1), _s2));
    const V _s4 = lanes_sqrt(_s3);
    const M _s5 = lanes_less(nearing, K(0.0));
    const V _s6 = lanes_select(lanes_at_most(K(0.0), _s3), lanes_div(lanes_select(_s5, lanes_mul(K(2.0), _s2), lanes_add(nearing, _s4)), lanes_select(_s5, lanes_sub(_s4, nearing), lanes_max(K(0.0), _s1))), K(INFINITY));
    return (LANES(court_neighbour_free_time_out)){ lanes_min(_s6, free_time) };
}

/* Time for which a ball that leaves crosses no end plane; else that is undecided.
   a parabola below the distance. 54 operations: 8 additions, 2 subtractions, 8 multiplications, 3 divisions, 2 square roots, 2 negations, 4 absolute values, 11 comparisons, 1 disjunction, 13 selections. */
typedef struct {
    V free_time, undecided_time;
} LANES(court_end_plane_free_time_out);

LANES_INLINE LANES(court_end_plane_free_time_out)
LANES(court_end_plane_free_time)(V vx, V vy, V vz, V gap, V undecided_time, V free_time, V nearing, V gap_curvature, V _c0, V _c1)
{
    const M _s0 = lanes_less(K(0.0), gap);
    const V _s1 = lanes_mul(nearing, nearing);
    const V _s2 = lanes_add(lanes_add(lanes_add(_c1, lanes_abs(vx)), lanes_abs(vy)), lanes_abs(vz));
    const V _s3 = lanes_add(_c0, lanes_mul(gap_curvature, lanes_mul(_s2, _s2)));
    const V _s4 = lanes_max(gap, K(0.0));
    const V _s5 = lanes_mul(K(2.0), _s3);
    const V _s6 = lanes_add(_s1, lanes_mul(_s5, _s4));
    const V _s7 = lanes_sqrt(_s6);
    const V _s8 = lanes_max(K(0.0), _s3);
    const M _s9 = lanes_less(nearing, K(0.0));
    const V _s10 = lanes_select(lanes_at_most(K(0.0), _s6), lanes_div(lanes_select(_s9, lanes_mul(K(2.0), _s4), lanes_add(nearing, _s7)), lanes_select(_s9, lanes_sub(_s7, nearing), _s8)), K(INFINITY));
    const V _s11 = lanes_neg(gap);
    const V _s12 = lanes_max(_s11, K(0.0));
    const V _s13 = lanes_add(_s1, lanes_mul(_s5, _s12));
    const V _s14 = lanes_sqrt(_s13);
    const M _s15 = lanes_less(lanes_neg(nearing), K(0.0));
    const V _s16 = lanes_select(lanes_at_most(K(0.0), _s13), lanes_div(lanes_select(_s15, lanes_mul(K(2.0), _s12), lanes_sub(_s14, nearing)), lanes_select(_s15, lanes_add(nearing, _s14), _s8)), K(INFINITY));
    const V _s17 = lanes_div(lanes_abs(nearing), _s3);
    return (LANES(court_end_plane_free_time_out)){ lanes_select(_s0, lanes_min(_s10, free_time), free_time), lanes_select(lanes_either(_s0, lanes_less(K(0.0078125), lanes_max(_s16, _s17))), undecided_time, K(0.0)) };
}

/* Time for which it certainly reaches no seam, where the distance bends differently.
   a parabola below the distance. 21 operations: 2 additions, 1 subtraction, 3 multiplications, 1 division, 1 square root, 1 negation, 1 absolute value, 5 comparisons, 6 selections. */
typedef struct {
    V free_time;
} LANES(court_seam_free_time_out);

LANES_INLINE LANES(court_seam_free_time_out)
LANES(court_seam_free_time)(V gap, V free_time, V near, V nearing, V _c0, V _c1)
{
    const V _s0 = lanes_abs(gap);
    const V _s1 = lanes_select(lanes_less(K(0.0), gap), nearing, lanes_neg(nearing));
    const V _s2 = lanes_add(lanes_mul(_c0, _s0), lanes_mul(_s1, _s1));
    const V _s3 = lanes_sqrt(_s2);
    const M _s4 = lanes_less(_s1, K(0.0));
    const V _s5 = lanes_select(lanes_at_most(K(0.0), _s2), lanes_div(lanes_select(_s4, lanes_mul(K(2.0), _s0), lanes_add(_s3, _s1)), lanes_select(_s4, lanes_sub(_s3, _s1), _c1)), K(INFINITY));
    return (LANES(court_seam_free_time_out)){ lanes_select(lanes_at_most(_s0, near), free_time, lanes_min(_s5, free_time)) };
}

/* Time for which a ball that leaves a surface certainly meets neither it nor another.
   Taylor's theorem of the gap. 67 operations: 10 additions, 1 subtraction, 19 multiplications, 5 divisions, 4 square roots, 6 absolute values, 11 comparisons, 1 disjunction, 10 selections. */
typedef struct {
    V when, undecided_time;
} LANES(court_separated_out);

LANES_INLINE LANES(court_separated_out)
LANES(court_separated)(V vx, V vy, V vz, V undecided_time, V position_error, V velocity_error, V clock, V time_limit, V per_reach, V free_time, V lift, V gap_jerk, V gap_snap, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_sub(time_limit, clock);
    const V _s1 = lanes_mul(K(0.25), free_time);
    const V _s2 = lanes_add(lanes_add(lanes_add(_c1, lanes_abs(vx)), lanes_abs(vy)), lanes_abs(vz));
    const V _s3 = lanes_abs(per_reach);
    const V _s4 = lanes_add(_c0, lanes_mul(lanes_mul(_s2, _s2), _s3));
    const V _s5 = lanes_add(lanes_add(K(1.0), lanes_mul(_s2, _s3)), lanes_sqrt(lanes_mul(_c0, _s3)));
    const V _s6 = lanes_mul(lanes_mul(K(64.0), _s4), lanes_mul(_s5, lanes_mul(_s5, _s5)));
    const V _s7 = lanes_mul(K(0.5), gap_jerk);
    const V _s8 = lanes_sqrt(lanes_div(_s7, _s6));
    const V _s9 = lanes_mul(K(9.313225746154785e-10), _s6);
    const V _s10 = lanes_add(lanes_abs(gap_snap), _s9);
    const V _s11 = lanes_div(_s7, _s10);
    const V _s12 = lanes_max(K(0.0), lift);
    const V _s13 = lanes_sqrt(lanes_div(lanes_mul(K(128.0), _s12), _s6));
    const V _s14 = lanes_sqrt(lanes_div(lanes_mul(K(0.5), _s12), _s10));
    const V _s15 = lanes_div(_s12, lanes_add(lanes_mul(K(4.0), lanes_abs(gap_jerk)), _s9));
    const V _s16 = lanes_min(_s14, _s15);
    const V _s17 = lanes_select(lanes_less(K(0.0), gap_jerk), lanes_min(_s8, _s11), lanes_min(_s13, _s16));
    const V _s18 = lanes_min(_s17, K(0.0078125));
    const V _s19 = lanes_min(_s1, _s18);
    const V _s20 = lanes_min(_s0, _s19);
    const V _s21 = lanes_add(_c2, lanes_mul(lanes_mul(K(16.0), lanes_add(lanes_mul(position_error, _s4), lanes_mul(velocity_error, _s2))), _s3));
    return (LANES(court_separated_out)){ lanes_max(K(0.0), _s20), lanes_select(lanes_either(lanes_less(lanes_mul(_s21, _s5), gap_jerk), lanes_less(_s21, lift)), undecided_time, K(0.0)) };
}

/* Scale from the errors to the neighbouring motion.
   a chosen distance. 27 operations: 3 additions, 2 multiplications, 1 division, 9 absolute values, 6 comparisons, 6 selections. */
typedef struct {
    V neighbour_scale;
} LANES(court_neighbour_scale_out);

LANES_INLINE LANES(court_neighbour_scale_out)
LANES(court_neighbour_scale)(V dx, V dy, V dz, V dvx, V dvy, V dvz, V dwx, V dwy, V dwz, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_abs(dwx);
    const V _s1 = lanes_abs(dwy);
    const V _s2 = lanes_max(_s0, _s1);
    const V _s3 = lanes_abs(dwz);
    const V _s4 = lanes_abs(dvx);
    const V _s5 = lanes_abs(dvy);
    const V _s6 = lanes_max(_s4, _s5);
    const V _s7 = lanes_abs(dvz);
    const V _s8 = lanes_abs(dx);
    const V _s9 = lanes_abs(dy);
    const V _s10 = lanes_max(_s8, _s9);
    const V _s11 = lanes_abs(dz);
    const V _s12 = lanes_add(lanes_add(_c1, lanes_mul(K(0.125), lanes_add(lanes_mul(_c0, lanes_max(_s2, _s3)), lanes_max(_s6, _s7)))), lanes_max(_s10, _s11));
    return (LANES(court_neighbour_scale_out)){ lanes_div(_c2, _s12) };
}

/* State of a neighbouring motion, along the errors.
   Table 1. 18 operations: 9 additions, 9 multiplications. */
typedef struct {
    V far_x, far_y, far_z, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_nx, far_ny, far_nz, far_gap;
} LANES(court_neighbour_out);

LANES_INLINE LANES(court_neighbour_out)
LANES(court_neighbour)(V x, V y, V z, V vx, V vy, V vz, V wx, V wy, V wz, V dx, V dy, V dz, V dvx, V dvy, V dvz, V dwx, V dwy, V dwz, V neighbour_scale)
{
    return (LANES(court_neighbour_out)){ lanes_add(x, lanes_mul(dx, neighbour_scale)), lanes_add(y, lanes_mul(dy, neighbour_scale)), lanes_add(z, lanes_mul(dz, neighbour_scale)), lanes_add(vx, lanes_mul(dvx, neighbour_scale)), lanes_add(vy, lanes_mul(dvy, neighbour_scale)), lanes_add(vz, lanes_mul(dvz, neighbour_scale)), lanes_add(wx, lanes_mul(dwx, neighbour_scale)), lanes_add(wy, lanes_mul(dwy, neighbour_scale)), lanes_add(wz, lanes_mul(dwz, neighbour_scale)), K(0.0), K(0.0), K(0.0), K(0.0) };
}

/* Errors after a step, with its roundings and truncation errors.
   differences. 72 operations: 19 additions, 9 subtractions, 4 multiplications, 10 divisions, 3 negations, 9 absolute values, 9 comparisons, 9 selections. */
typedef struct {
    V dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz;
} LANES(court_compared_out);

LANES_INLINE LANES(court_compared_out)
LANES(court_compared)(V x, V y, V z, V vx, V vy, V vz, V wx, V wy, V wz, V far_x, V far_y, V far_z, V far_vx, V far_vy, V far_vz, V far_wx, V far_wy, V far_wz, V stride, V missed, V neighbour_scale, V _c0)
{
    const V _s0 = lanes_div(lanes_sub(far_x, x), neighbour_scale);
    const V _s1 = lanes_add(lanes_mul(stride, missed), lanes_mul(K(4.440892098500626e-16), lanes_add(lanes_add(lanes_add(_c0, lanes_abs(x)), lanes_abs(y)), lanes_abs(z))));
    const V _s2 = lanes_neg(_s1);
    const V _s3 = lanes_div(lanes_sub(far_y, y), neighbour_scale);
    const V _s4 = lanes_div(lanes_sub(far_z, z), neighbour_scale);
    const V _s5 = lanes_div(lanes_sub(far_vx, vx), neighbour_scale);
    const V _s6 = lanes_add(lanes_add(lanes_mul(_c0, lanes_add(lanes_add(lanes_abs(wx), lanes_abs(wy)), lanes_abs(wz))), lanes_abs(vx)), lanes_abs(vy));
    const V _s7 = lanes_add(missed, lanes_mul(K(4.440892098500626e-16), lanes_add(_s6, lanes_abs(vz))));
    const V _s8 = lanes_neg(_s7);
    const V _s9 = lanes_div(lanes_sub(far_vy, vy), neighbour_scale);
    const V _s10 = lanes_div(lanes_sub(far_vz, vz), neighbour_scale);
    const V _s11 = lanes_div(lanes_sub(far_wx, wx), neighbour_scale);
    const V _s12 = lanes_div(_s7, _c0);
    const V _s13 = lanes_neg(_s12);
    const V _s14 = lanes_div(lanes_sub(far_wy, wy), neighbour_scale);
    const V _s15 = lanes_div(lanes_sub(far_wz, wz), neighbour_scale);
    return (LANES(court_compared_out)){ lanes_add(_s0, lanes_select(lanes_less(_s0, K(0.0)), _s2, _s1)), lanes_add(_s3, lanes_select(lanes_less(_s3, K(0.0)), _s2, _s1)), lanes_add(_s4, lanes_select(lanes_less(_s4, K(0.0)), _s2, _s1)), lanes_add(_s5, lanes_select(lanes_less(_s5, K(0.0)), _s8, _s7)), lanes_add(_s9, lanes_select(lanes_less(_s9, K(0.0)), _s8, _s7)), lanes_add(_s10, lanes_select(lanes_less(_s10, K(0.0)), _s8, _s7)), lanes_add(_s11, lanes_select(lanes_less(_s11, K(0.0)), _s13, _s12)), lanes_add(_s14, lanes_select(lanes_less(_s14, K(0.0)), _s13, _s12)), lanes_add(_s15, lanes_select(lanes_less(_s15, K(0.0)), _s13, _s12)) };
}

/* Errors after the flight of a departure.
   derivative of Eq. 3. 34 operations: 9 additions, 10 multiplications, 3 negations, 6 absolute values, 3 comparisons, 3 selections. */
typedef struct {
    V dx, dy, dz;
} LANES(court_carry_hop_out);

LANES_INLINE LANES(court_carry_hop_out)
LANES(court_carry_hop)(V x, V y, V z, V vx, V vy, V vz, V dx, V dy, V dz, V dvx, V dvy, V dvz, V when)
{
    const V _s0 = lanes_add(dx, lanes_mul(dvx, when));
    const V _s1 = lanes_mul(K(2.0), when);
    const V _s2 = lanes_mul(K(1.1102230246251565e-16), lanes_add(lanes_mul(_s1, lanes_abs(vx)), lanes_abs(x)));
    const V _s3 = lanes_add(dy, lanes_mul(dvy, when));
    const V _s4 = lanes_mul(K(1.1102230246251565e-16), lanes_add(lanes_mul(_s1, lanes_abs(vy)), lanes_abs(y)));
    const V _s5 = lanes_add(dz, lanes_mul(dvz, when));
    const V _s6 = lanes_mul(K(1.1102230246251565e-16), lanes_add(lanes_mul(_s1, lanes_abs(vz)), lanes_abs(z)));
    return (LANES(court_carry_hop_out)){ lanes_add(_s0, lanes_select(lanes_less(_s0, K(0.0)), lanes_neg(_s2), _s2)), lanes_add(_s3, lanes_select(lanes_less(_s3, K(0.0)), lanes_neg(_s4), _s4)), lanes_add(_s5, lanes_select(lanes_less(_s5, K(0.0)), lanes_neg(_s6), _s6)) };
}

/* Whether the ball starts on a surface that it can roll on.
   Table 1. 4 operations: 2 comparisons, 1 conjunction, 1 selection. */
typedef struct {
    V mode;
} LANES(court_started_on_surface_out);

LANES_INLINE LANES(court_started_on_surface_out)
LANES(court_started_on_surface)(V last)
{
    return (LANES(court_started_on_surface_out)){ lanes_select(lanes_both(lanes_at_most(K(0.0), last), lanes_at_most(last, K(2.0))), K(5.0), K(0.0)) };
}

/* Start on a surface: no event, whatever surface the turn is about.
   Table 1. 5 operations: 1 comparison, 2 conjunctions, 1 complement, 1 selection. */
typedef struct {
    M moves, touches;
    V body;
} LANES(court_nothing_happens_yet_out);

LANES_INLINE LANES(court_nothing_happens_yet_out)
LANES(court_nothing_happens_yet)(V body, M touches, V mode, M moves)
{
    const M _s0 = lanes_equal(mode, K(5.0));
    const M _s1 = lanes_not(_s0);
    return (LANES(court_nothing_happens_yet_out)){ lanes_both(moves, _s1), lanes_both(touches, _s1), lanes_select(_s0, K(-1.0), body) };
}

/* Start value for a ball without a contact: whether it may stay where it starts.
   Table 1. 1 operation: 1 comparison. */
typedef struct {
    M slow;
} LANES(court_slow_at_start_out);

LANES_INLINE LANES(court_slow_at_start_out)
LANES(court_slow_at_start)(V mode)
{
    return (LANES(court_slow_at_start_out)){ lanes_equal(mode, K(5.0)) };
}

/* Whether a ball starts on a surface, which it may be off by the caller's digits.
   Table 1. 1 operation: 1 comparison. */
typedef struct {
    M put_on;
} LANES(court_off_at_start_out);

LANES_INLINE LANES(court_off_at_start_out)
LANES(court_off_at_start)(V mode)
{
    return (LANES(court_off_at_start_out)){ lanes_equal(mode, K(5.0)) };
}

/* Place of a ball that starts on a surface, put onto it along the normal.
   Table 2. 14 operations: 2 additions, 3 subtractions, 7 multiplications, 1 division, 1 square root. */
typedef struct {
    V x, y, z;
} LANES(court_placed_at_start_out);

LANES_INLINE LANES(court_placed_at_start_out)
LANES(court_placed_at_start)(V x, V y, V z, V nx, V ny, V nz, V gap)
{
    const V _s0 = lanes_mul(gap, lanes_div(K(1.0), lanes_sqrt(lanes_add(lanes_add(lanes_mul(nx, nx), lanes_mul(ny, ny)), lanes_mul(nz, nz)))));
    return (LANES(court_placed_at_start_out)){ lanes_sub(x, lanes_mul(nx, _s0)), lanes_sub(y, lanes_mul(ny, _s0)), lanes_sub(z, lanes_mul(nz, _s0)) };
}

/* Errors with the rounding of that place.
   its bound. 17 operations: 6 additions, 1 multiplication, 1 negation, 3 absolute values, 3 comparisons, 3 selections. */
typedef struct {
    V dx, dy, dz;
} LANES(court_start_errors_out);

LANES_INLINE LANES(court_start_errors_out)
LANES(court_start_errors)(V x, V y, V z, V dx, V dy, V dz, V _c0)
{
    const V _s0 = lanes_mul(K(8.881784197001252e-16), lanes_add(lanes_add(lanes_add(_c0, lanes_abs(x)), lanes_abs(y)), lanes_abs(z)));
    const V _s1 = lanes_neg(_s0);
    return (LANES(court_start_errors_out)){ lanes_add(dx, lanes_select(lanes_less(dx, K(0.0)), _s1, _s0)), lanes_add(dy, lanes_select(lanes_less(dy, K(0.0)), _s1, _s0)), lanes_add(dz, lanes_select(lanes_less(dz, K(0.0)), _s1, _s0)) };
}

/* 1 if it is undecided whether the speed along the normal is a rounding.
   Table 1. 33 operations: 10 additions, 8 multiplications, 1 division, 10 absolute values, 2 comparisons, 1 conjunction, 1 selection. */
typedef struct {
    V uncertain;
} LANES(court_undecided_at_start_out);

LANES_INLINE LANES(court_undecided_at_start_out)
LANES(court_undecided_at_start)(V x, V y, V z, V nx, V ny, V nz, V vx, V vy, V vz, V wx, V wy, V wz, V uncertain, V _c0)
{
    const V _s0 = lanes_add(lanes_add(lanes_mul(_c0, lanes_add(lanes_add(lanes_abs(wx), lanes_abs(wy)), lanes_abs(wz))), lanes_abs(vx)), lanes_abs(vy));
    const V _s1 = lanes_mul(K(3.552713678800501e-15), lanes_add(K(1.0), lanes_div(lanes_add(lanes_add(lanes_abs(x), lanes_abs(y)), lanes_abs(z)), _c0)));
    const V _s2 = lanes_mul(_s1, lanes_add(_s0, lanes_abs(vz)));
    const V _s3 = lanes_abs(lanes_add(lanes_add(lanes_mul(nx, vx), lanes_mul(ny, vy)), lanes_mul(nz, vz)));
    return (LANES(court_undecided_at_start_out)){ lanes_select(lanes_both(lanes_less(lanes_mul(K(0.5), _s2), _s3), lanes_less(_s3, lanes_mul(K(2.0), _s2))), K(1.0), uncertain) };
}

/* Errors with the rounding of a velocity along the surface.
   its bound. 32 operations: 11 additions, 4 multiplications, 1 division, 1 negation, 9 absolute values, 3 comparisons, 3 selections. */
typedef struct {
    V dvx, dvy, dvz;
} LANES(court_start_velocity_errors_out);

LANES_INLINE LANES(court_start_velocity_errors_out)
LANES(court_start_velocity_errors)(V x, V y, V z, V vx, V vy, V vz, V wx, V wy, V wz, V dvx, V dvy, V dvz, V _c0)
{
    const V _s0 = lanes_add(lanes_add(lanes_mul(_c0, lanes_add(lanes_add(lanes_abs(wx), lanes_abs(wy)), lanes_abs(wz))), lanes_abs(vx)), lanes_abs(vy));
    const V _s1 = lanes_mul(K(3.552713678800501e-15), lanes_add(K(1.0), lanes_div(lanes_add(lanes_add(lanes_abs(x), lanes_abs(y)), lanes_abs(z)), _c0)));
    const V _s2 = lanes_mul(K(0.03125), lanes_mul(_s1, lanes_add(_s0, lanes_abs(vz))));
    const V _s3 = lanes_neg(_s2);
    return (LANES(court_start_velocity_errors_out)){ lanes_add(dvx, lanes_select(lanes_less(dvx, K(0.0)), _s3, _s2)), lanes_add(dvy, lanes_select(lanes_less(dvy, K(0.0)), _s3, _s2)), lanes_add(dvz, lanes_select(lanes_less(dvz, K(0.0)), _s3, _s2)) };
}

/* Velocity of a ball that starts on a surface, along it if it is so to roundings.
   the normal of Table 2. 35 operations: 10 additions, 3 subtractions, 9 multiplications, 1 division, 10 absolute values, 1 comparison, 1 selection. */
typedef struct {
    V vx, vy, vz;
} LANES(court_velocity_at_start_out);

LANES_INLINE LANES(court_velocity_at_start_out)
LANES(court_velocity_at_start)(V x, V y, V z, V nx, V ny, V nz, V vx, V vy, V vz, V wx, V wy, V wz, V _c0)
{
    const V _s0 = lanes_add(lanes_add(lanes_mul(nx, vx), lanes_mul(ny, vy)), lanes_mul(nz, vz));
    const V _s1 = lanes_add(lanes_add(lanes_mul(_c0, lanes_add(lanes_add(lanes_abs(wx), lanes_abs(wy)), lanes_abs(wz))), lanes_abs(vx)), lanes_abs(vy));
    const V _s2 = lanes_mul(K(3.552713678800501e-15), lanes_add(K(1.0), lanes_div(lanes_add(lanes_add(lanes_abs(x), lanes_abs(y)), lanes_abs(z)), _c0)));
    const V _s3 = lanes_select(lanes_at_most(lanes_abs(_s0), lanes_mul(_s2, lanes_add(_s1, lanes_abs(vz)))), _s0, K(0.0));
    return (LANES(court_velocity_at_start_out)){ lanes_sub(vx, lanes_mul(nx, _s3)), lanes_sub(vy, lanes_mul(ny, _s3)), lanes_sub(vz, lanes_mul(nz, _s3)) };
}

/* Whether the ball is in contact, and has no flight to search.
   Table 1. 2 operations: 1 comparison, 1 selection. */
typedef struct {
    M in_contact;
    V when;
    M rests, rolling;
    V began;
} LANES(court_in_contact_out);

LANES_INLINE LANES(court_in_contact_out)
LANES(court_in_contact)(V when, V mode)
{
    const M _s0 = lanes_less(K(0.0), mode);
    return (LANES(court_in_contact_out)){ _s0, lanes_select(_s0, K(0.0), when), mask_none(), mask_none(), K(0.0) };
}

/* Whether a ball in flight may hit a surface.
   Table 1. 4 operations: 1 comparison, 1 conjunction, 2 complements. */
typedef struct {
    M open;
} LANES(court_opens_in_flight_out);

LANES_INLINE LANES(court_opens_in_flight_out)
LANES(court_opens_in_flight)(V clear, M in_contact)
{
    return (LANES(court_opens_in_flight_out)){ lanes_both(lanes_not(lanes_less(K(0.0), clear)), lanes_not(in_contact)) };
}

/* Whether a ball in flight may reach the box of a surface.
   Table 1. 2 operations: 1 conjunction, 1 complement. */
typedef struct {
    M reachable;
} LANES(court_reachable_in_flight_out);

LANES_INLINE LANES(court_reachable_in_flight_out)
LANES(court_reachable_in_flight)(M reachable, M in_contact)
{
    return (LANES(court_reachable_in_flight_out)){ lanes_both(reachable, lanes_not(in_contact)) };
}

/* Start values of a turn in contact: no event yet, and the surface that the ball is on.
   Table 1. 9 operations: 6 comparisons, 1 conjunction, 2 selections. */
typedef struct {
    V which, earliest_delay, began, undecided_time;
    M begins, rolling, leaves;
    V nx, ny, nz, gap, bent_x, bent_y, bent_z, lift, gap_jerk, gap_snap, per_reach;
} LANES(court_resumed_out);

LANES_INLINE LANES(court_resumed_out)
LANES(court_resumed)(V last, V position_error, V velocity_error, V clock, V mode)
{
    return (LANES(court_resumed_out)){ lanes_select(lanes_equal(mode, K(5.0)), last, K(-1.0)), K(0.0), clock, lanes_select(lanes_both(lanes_less(position_error, K(INFINITY)), lanes_less(velocity_error, K(INFINITY))), K(INFINITY), K(0.0)), lanes_equal(mode, K(1.0)), lanes_equal(mode, K(2.0)), lanes_equal(mode, K(3.0)), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0) };
}

/* 1 if a decision lies within its error, unless that only delays bounces on a surface.
   Table 1. 16 operations: 1 addition, 6 comparisons, 5 conjunctions, 1 disjunction, 2 complements, 1 selection. */
typedef struct {
    V uncertain;
} LANES(court_contact_undecided_out);

LANES_INLINE LANES(court_contact_undecided_out)
LANES(court_contact_undecided)(V last, V when, V which, V earliest_delay, V undecided_time, V position_error, V velocity_error, V uncertain, M edge, V assured)
{
    const M _s0 = lanes_both(lanes_either(lanes_both(lanes_not(lanes_less(lanes_add(when, earliest_delay), undecided_time)), lanes_less(undecided_time, K(INFINITY))), edge), lanes_not(lanes_both(lanes_both(lanes_less(K(0.0), assured), lanes_equal(which, last)), lanes_both(lanes_less(position_error, K(INFINITY)), lanes_less(velocity_error, K(INFINITY))))));
    return (LANES(court_contact_undecided_out)){ lanes_select(_s0, K(1.0), uncertain) };
}

/* Whether the ball stays on a surface.
   Table 1. 1 operation: 1 comparison. */
typedef struct {
    M here;
} LANES(court_holding_out);

LANES_INLINE LANES(court_holding_out)
LANES(court_holding)(V index, V held)
{
    return (LANES(court_holding_out)){ lanes_equal(held, index) };
}

/* Whether a surface is another than the one that the ball stays on.
   Table 1. 2 operations: 1 comparison, 1 complement. */
typedef struct {
    M beside;
} LANES(court_beside_out);

LANES_INLINE LANES(court_beside_out)
LANES(court_beside)(V index, V held)
{
    return (LANES(court_beside_out)){ lanes_not(lanes_equal(held, index)) };
}

/* Whether a surface is another than that of the event.
   Table 1. 2 operations: 1 comparison, 1 complement. */
typedef struct {
    M beside;
} LANES(court_other_surface_out);

LANES_INLINE LANES(court_other_surface_out)
LANES(court_other_surface)(V index, V which)
{
    return (LANES(court_other_surface_out)){ lanes_not(lanes_equal(which, index)) };
}

/* Start value: the ball has not departed.
   Table 1. No operations. */
typedef struct {
    M hopped;
} LANES(court_no_departure_out);

LANES_INLINE LANES(court_no_departure_out)
LANES(court_no_departure)(void)
{
    return (LANES(court_no_departure_out)){ mask_none() };
}

/* Event: the contact begins.
   Table 1. No operations. */
typedef struct {
    V which, circled;
} LANES(court_beginning_contact_out);

LANES_INLINE LANES(court_beginning_contact_out)
LANES(court_beginning_contact)(void)
{
    return (LANES(court_beginning_contact_out)){ K(5.0), K(0.0) };
}

/* Event: the ball is off the surface.
   Table 1. No operations. */
typedef struct {
    V which;
} LANES(court_detachment_out);

LANES_INLINE LANES(court_detachment_out)
LANES(court_detachment)(void)
{
    return (LANES(court_detachment_out)){ K(7.0) };
}

/* Log entry, outcome and mode of a ball in contact after a turn.
   Table 1. 41 operations: 3 additions, 1 subtraction, 1 multiplication, 10 comparisons, 2 conjunctions, 5 disjunctions, 1 complement, 18 selections. */
typedef struct {
    V body, reached, undecided_time;
    M ends, hopped;
    V last, mode, held, rolls;
} LANES(court_stay_in_contact_out);

LANES_INLINE LANES(court_stay_in_contact_out)
LANES(court_stay_in_contact)(V last, V which, V undecided_time, V body, V clock, V reached, M ends, V held, V mode, V rolls, M rolling, V began, M rests)
{
    const M _s0 = lanes_equal(which, K(5.0));
    const V _s1 = lanes_mul(K(2.0), lanes_select(lanes_equal(held, K(2.0)), K(2.0), lanes_select(lanes_equal(held, K(1.0)), K(1.0), lanes_select(lanes_equal(held, K(0.0)), K(0.0), K(-1.0)))));
    const M _s2 = lanes_equal(which, K(6.0));
    const M _s3 = lanes_equal(which, K(7.0));
    const M _s4 = lanes_equal(which, K(8.0));
    const M _s5 = lanes_both(rolling, lanes_at_most(lanes_sub(clock, began), K(5.960464477539063e-08)));
    const M _s6 = lanes_less(K(4.0), which);
    const M _s7 = lanes_equal(mode, K(5.0));
    const V _s8 = lanes_select(_s5, K(2.0), lanes_select(_s4, K(6.0), lanes_select(rests, K(5.0), lanes_select(lanes_either(lanes_either(_s6, rolling), _s7), K(-1.0), reached))));
    return (LANES(court_stay_in_contact_out)){ lanes_select(_s0, lanes_add(K(4.0), _s1), lanes_select(_s2, lanes_add(K(5.0), _s1), lanes_select(_s3, K(-1.0), lanes_select(_s4, K(3.0), body)))), _s8, lanes_select(_s5, K(0.0), undecided_time), lanes_both(ends, lanes_not(_s6)), _s3, lanes_select(_s3, K(-1.0), last), lanes_select(lanes_either(_s0, rolling), K(2.0), lanes_select(_s7, K(5.0), lanes_select(_s2, K(3.0), K(0.0)))), lanes_select(lanes_either(lanes_either(_s0, _s2), rolling), held, K(-1.0)), lanes_select(_s0, lanes_add(K(1.0), rolls), rolls) };
}

/* Whether the ball stays on the surface, slides, leaves, or is wedged.
   Table 1. 26 operations: 4 comparisons, 7 conjunctions, 5 disjunctions, 2 complements, 8 selections. */
typedef struct {
    V mode, held, outcome, slip_left, uncertain;
} LANES(court_settled_out);

LANES_INLINE LANES(court_settled_out)
LANES(court_settled)(V index, V position_error, V velocity_error, V outcome, V uncertain, M undecided, V mode, M settles, M nearly, M lodges, M slides, M unpressed)
{
    const M _s0 = lanes_either(lanes_either(lodges, lanes_both(undecided, lanes_either(nearly, lanes_not(lanes_equal(mode, K(5.0)))))), lanes_both(nearly, lanes_not(lanes_both(lanes_less(position_error, K(INFINITY)), lanes_less(velocity_error, K(INFINITY))))));
    return (LANES(court_settled_out)){ lanes_select(nearly, lanes_select(settles, K(1.0), lanes_select(unpressed, K(3.0), K(0.0))), K(0.0)), lanes_select(lanes_both(nearly, lanes_either(settles, unpressed)), index, K(-1.0)), lanes_select(lanes_both(lanes_both(nearly, lanes_either(lodges, slides)), lanes_less(outcome, K(0.0))), lanes_select(lodges, K(5.0), K(2.0)), outcome), lanes_select(lanes_both(nearly, slides), K(1.0), K(0.0)), lanes_select(_s0, K(1.0), uncertain) };
}

/* Square of the friction that rolling takes, per unit mass, and its rate.
   F = beta (-a_t + s n × n'). 54 operations: 17 additions, 35 multiplications, 2 negations. */
typedef struct {
    V rolling_friction, rolling_friction_rate, grip_deficit, grip_deficit_rate;
} LANES(court_ring_friction_out);

LANES_INLINE LANES(court_ring_friction_out)
LANES(court_ring_friction)(V nx_0, V nx_1, V ny_0, V ny_1, V nz_0, V nz_1, V turn_rate_0, V turn_rate_1, V tx_0, V tx_1, V ty_0, V ty_1, V tz_0, V tz_1, V _c0, V _c1)
{
    const V _s0 = lanes_neg(lanes_mul(_c0, nz_0));
    const V _s1 = lanes_mul(lanes_add(lanes_mul(nx_0, _s0), lanes_mul(turn_rate_0, tx_0)), _c1);
    const V _s2 = lanes_mul(lanes_add(lanes_mul(ny_0, _s0), lanes_mul(turn_rate_0, ty_0)), _c1);
    const V _s3 = lanes_mul(lanes_add(lanes_add(_c0, lanes_mul(nz_0, _s0)), lanes_mul(turn_rate_0, tz_0)), _c1);
    const V _s4 = lanes_neg(lanes_mul(_c0, nz_1));
    const V _s5 = lanes_mul(lanes_mul(K(2.0), _s1), lanes_mul(lanes_add(lanes_add(lanes_add(lanes_mul(nx_0, _s4), lanes_mul(nx_1, _s0)), lanes_mul(turn_rate_0, tx_1)), lanes_mul(turn_rate_1, tx_0)), _c1));
    const V _s6 = lanes_mul(lanes_mul(K(2.0), _s2), lanes_mul(lanes_add(lanes_add(lanes_add(lanes_mul(ny_0, _s4), lanes_mul(ny_1, _s0)), lanes_mul(turn_rate_0, ty_1)), lanes_mul(turn_rate_1, ty_0)), _c1));
    const V _s7 = lanes_mul(lanes_mul(K(2.0), _s3), lanes_mul(lanes_add(lanes_add(lanes_add(lanes_mul(nz_0, _s4), lanes_mul(nz_1, _s0)), lanes_mul(turn_rate_0, tz_1)), lanes_mul(turn_rate_1, tz_0)), _c1));
    return (LANES(court_ring_friction_out)){ lanes_add(lanes_add(lanes_mul(_s1, _s1), lanes_mul(_s2, _s2)), lanes_mul(_s3, _s3)), lanes_add(lanes_add(_s5, _s6), _s7), K(-INFINITY), K(0.0) };
}

/* Start value of a contact: no excess is known.
   Table 1. No operations. */
typedef struct {
    V last_grip_deficit;
} LANES(court_forget_grip_deficit_out);

LANES_INLINE LANES(court_forget_grip_deficit_out)
LANES(court_forget_grip_deficit)(void)
{
    return (LANES(court_forget_grip_deficit_out)){ K(INFINITY) };
}

/* Whether friction exceeds its limit for the first time.
   F² > mu² N². 3 operations: 2 comparisons, 1 conjunction. */
typedef struct {
    M loses;
} LANES(court_exceeds_grip_out);

LANES_INLINE LANES(court_exceeds_grip_out)
LANES(court_exceeds_grip)(V grip_deficit, V grip_lost)
{
    return (LANES(court_exceeds_grip_out)){ lanes_both(lanes_less(K(0.0), grip_deficit), lanes_equal(grip_lost, K(INFINITY))) };
}

/* Time at which friction first exceeded its limit.
   a cubic between the ends of a step. 97 operations: 22 additions, 9 subtractions, 28 multiplications, 5 divisions, 1 negation, 16 comparisons, 1 conjunction, 15 selections. */
typedef struct {
    V grip_lost;
} LANES(court_grip_lost_time_out);

LANES_INLINE LANES(court_grip_lost_time_out)
LANES(court_grip_lost_time)(V clock, V grip_deficit, V grip_deficit_rate, V last_grip_deficit, V last_grip_deficit_rate, V last_grip_clock)
{
    const V _s0 = lanes_sub(clock, last_grip_clock);
    const V _s1 = lanes_sub(grip_deficit, last_grip_deficit);
    const V _s2 = lanes_neg(lanes_div(last_grip_deficit, _s1));
    const V _s3 = lanes_min(_s2, K(1.0));
    const V _s4 = lanes_max(K(0.0), _s3);
    const V _s5 = lanes_mul(grip_deficit_rate, _s0);
    const V _s6 = lanes_mul(last_grip_deficit_rate, _s0);
    const V _s7 = lanes_sub(lanes_add(_s5, _s6), lanes_mul(K(2.0), _s1));
    const V _s8 = lanes_sub(lanes_sub(lanes_mul(K(3.0), _s1), _s5), lanes_mul(K(2.0), _s6));
    const V _s9 = lanes_add(last_grip_deficit, lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s7, _s4), _s8), _s4), _s6), _s4));
    const V _s10 = lanes_mul(K(3.0), _s7);
    const V _s11 = lanes_mul(K(2.0), _s8);
    const V _s12 = lanes_add(lanes_mul(lanes_add(lanes_mul(_s10, _s4), _s11), _s4), _s6);
    const V _s13 = lanes_sub(_s4, lanes_div(_s9, lanes_select(lanes_less(K(0.0), _s12), _s12, _s1)));
    const V _s14 = lanes_min(_s13, K(1.0));
    const V _s15 = lanes_max(K(0.0), _s14);
    const V _s16 = lanes_add(last_grip_deficit, lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s7, _s15), _s8), _s15), _s6), _s15));
    const V _s17 = lanes_add(lanes_mul(lanes_add(lanes_mul(_s10, _s15), _s11), _s15), _s6);
    const V _s18 = lanes_sub(_s15, lanes_div(_s16, lanes_select(lanes_less(K(0.0), _s17), _s17, _s1)));
    const V _s19 = lanes_min(_s18, K(1.0));
    const V _s20 = lanes_max(K(0.0), _s19);
    const V _s21 = lanes_add(last_grip_deficit, lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s7, _s20), _s8), _s20), _s6), _s20));
    const V _s22 = lanes_add(lanes_mul(lanes_add(lanes_mul(_s10, _s20), _s11), _s20), _s6);
    const V _s23 = lanes_sub(_s20, lanes_div(_s21, lanes_select(lanes_less(K(0.0), _s22), _s22, _s1)));
    const V _s24 = lanes_min(_s23, K(1.0));
    const V _s25 = lanes_max(K(0.0), _s24);
    const V _s26 = lanes_add(last_grip_deficit, lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s7, _s25), _s8), _s25), _s6), _s25));
    const V _s27 = lanes_add(lanes_mul(lanes_add(lanes_mul(_s10, _s25), _s11), _s25), _s6);
    const V _s28 = lanes_sub(_s25, lanes_div(_s26, lanes_select(lanes_less(K(0.0), _s27), _s27, _s1)));
    const V _s29 = lanes_min(_s28, K(1.0));
    return (LANES(court_grip_lost_time_out)){ lanes_select(lanes_both(lanes_less(last_grip_deficit, K(INFINITY)), lanes_less(last_grip_deficit, grip_deficit)), lanes_add(last_grip_clock, lanes_mul(_s0, lanes_max(K(0.0), _s29))), clock) };
}

/* Excess, rate and time at the end of this step, for the next one.
   Table 1. No operations. */
typedef struct {
    V last_grip_deficit, last_grip_deficit_rate, last_grip_clock;
} LANES(court_remember_grip_deficit_out);

LANES_INLINE LANES(court_remember_grip_deficit_out)
LANES(court_remember_grip_deficit)(V clock, V grip_deficit, V grip_deficit_rate)
{
    return (LANES(court_remember_grip_deficit_out)){ grip_deficit, grip_deficit_rate, clock };
}

/* Undecided time 0 if errors are too large to decide on which side a flight begins.
   Table 1. 5 operations: 3 multiplications, 1 comparison, 1 selection. */
typedef struct {
    V undecided_time;
} LANES(court_plane_start_out);

LANES_INLINE LANES(court_plane_start_out)
LANES(court_plane_start)(V undecided_time, V position_error, V velocity_error, V _c0)
{
    const V _s0 = lanes_mul(K(2.0), velocity_error);
    return (LANES(court_plane_start_out)){ lanes_select(lanes_less(lanes_mul(position_error, _c0), lanes_mul(_s0, _s0)), K(0.0), undecided_time) };
}

/* The parameters in which one body's law differs from another's.
   data. 1 operation: 1 complement. */
typedef struct {
    M of_this_kind;
    V its_0, its_1;
} LANES(court_ring_impact_taken_out);

LANES_INLINE LANES(court_ring_impact_taken_out)
LANES(court_ring_impact_taken)(V p_ring_restitution, V p_ring_friction)
{
    return (LANES(court_ring_impact_taken_out)){ lanes_not(mask_none()), p_ring_restitution, p_ring_friction };
}

/* Whether a decision within the contact lies within its error.
   the law's own slack. 84 operations: 14 additions, 11 subtractions, 28 multiplications, 2 divisions, 1 square root, 1 negation, 13 absolute values, 7 comparisons, 2 conjunctions, 1 complement, 4 selections. */
typedef struct {
    M undecided;
} LANES(court_ring_impact_undecided_out);

LANES_INLINE LANES(court_ring_impact_undecided_out)
LANES(court_ring_impact_undecided)(V vx, V vy, V vz, V wx, V wy, V wz, V nx, V ny, V nz, V dvx, V dvy, V dvz, V dwx, V dwy, V dwz, V turn, V p_ring_restitution, V p_ring_friction, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_abs(dwx);
    const V _s1 = lanes_abs(dwy);
    const V _s2 = lanes_max(_s0, _s1);
    const V _s3 = lanes_abs(dwz);
    const V _s4 = lanes_add(lanes_add(lanes_mul(_c0, lanes_add(lanes_add(lanes_abs(wx), lanes_abs(wy)), lanes_abs(wz))), lanes_abs(vx)), lanes_abs(vy));
    const V _s5 = lanes_add(_s4, lanes_abs(vz));
    const V _s6 = lanes_abs(dvx);
    const V _s7 = lanes_abs(dvy);
    const V _s8 = lanes_max(_s6, _s7);
    const V _s9 = lanes_abs(dvz);
    const V _s10 = lanes_mul(K(64.0), lanes_add(lanes_add(lanes_add(lanes_mul(_c0, lanes_max(_s2, _s3)), lanes_mul(turn, _s5)), lanes_max(_s8, _s9)), lanes_mul(K(4.440892098500626e-16), _s5)));
    const V _s11 = lanes_add(lanes_add(lanes_mul(nx, vx), lanes_mul(ny, vy)), lanes_mul(nz, vz));
    const V _s12 = lanes_sub(lanes_sub(vz, lanes_mul(nz, _s11)), lanes_mul(_c0, lanes_sub(lanes_mul(ny, wx), lanes_mul(nx, wy))));
    const V _s13 = lanes_sub(lanes_sub(vy, lanes_mul(ny, _s11)), lanes_mul(_c0, lanes_sub(lanes_mul(nx, wz), lanes_mul(nz, wx))));
    const V _s14 = lanes_sub(lanes_sub(vx, lanes_mul(nx, _s11)), lanes_mul(_c0, lanes_sub(lanes_mul(nz, wy), lanes_mul(ny, wz))));
    const V _s15 = lanes_mul(p_ring_friction, lanes_mul(lanes_add(K(1.0), lanes_div(p_ring_restitution, lanes_sub(K(1.0), lanes_div(_s11, _c1)))), _s11));
    const V _s16 = lanes_sub(lanes_mul(_c2, lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s12, _s12), lanes_mul(_s13, _s13)), lanes_mul(_s14, _s14)))), lanes_neg(_s15));
    const M _s17 = lanes_both(lanes_both(lanes_less(K(0.0), p_ring_friction), lanes_less(p_ring_friction, K(INFINITY))), lanes_not(lanes_less(lanes_mul(lanes_add(lanes_mul(K(2.0), p_ring_friction), _c2), _s10), lanes_abs(_s16))));
    return (LANES(court_ring_impact_undecided_out)){ _s17 };
}

/* Whether the bounces end in rolling, sliding, a wedge or departure, and whether that is certain.
   a geometric series of bounces. 222 operations: 35 additions, 4 subtractions, 65 multiplications, 10 divisions, 1 square root, 2 negations, 22 absolute values, 33 comparisons, 32 conjunctions, 10 disjunctions, 5 complements, 3 selections. */
typedef struct {
    M settles, lodges, slides, unpressed;
    V assured;
    M undecided;
} LANES(court_ring_impact_settling_out);

LANES_INLINE LANES(court_ring_impact_settling_out)
LANES(court_ring_impact_settling)(V p_ring_friction, V p_ring_restitution, V x, V y, V z, V nx, V ny, V nz, V vx, V vy, V vz, V wx, V wy, V wz, V position_error, V velocity_error, V mode, V per_reach, V rolled_x, V rolled_y, V rolled_z, V turning_x, V turning_y, V turning_z, V slip, V bounce, V nearest, V second_contact_gap, V press, V weight, V rolling_friction, V lift, V gap_jerk, V _c0, V _c1, V _c2, V _c3, V _c4)
{
    const V _s0 = lanes_sub(K(1.0), p_ring_restitution);
    const M _s1 = lanes_less(K(0.0), _s0);
    const V _s2 = lanes_div(bounce, press);
    const V _s3 = lanes_add(K(4.440892098500626e-16), lanes_add(lanes_add(lanes_abs(turning_x), lanes_abs(turning_y)), lanes_abs(turning_z)));
    const V _s4 = lanes_mul(_c0, lanes_add(lanes_add(lanes_abs(wx), lanes_abs(wy)), lanes_abs(wz)));
    const V _s5 = lanes_add(lanes_add(lanes_add(_s4, lanes_abs(rolled_x)), lanes_abs(rolled_y)), lanes_abs(rolled_z));
    const V _s6 = lanes_abs(weight);
    const V _s7 = lanes_mul(lanes_mul(K(8.0), _s3), lanes_add(lanes_mul(_s3, _s5), _s6));
    const V _s8 = lanes_mul(_s0, _s0);
    const V _s9 = lanes_add(lanes_sqrt(lanes_mul(_c0, _s6)), _s5);
    const V _s10 = lanes_mul(K(1.4210854715202004e-14), _s9);
    const V _s11 = lanes_mul(K(2.0), rolling_friction);
    const V _s12 = lanes_add(K(1.0), p_ring_restitution);
    const V _s13 = lanes_mul(p_ring_friction, _s12);
    const V _s14 = lanes_mul(press, _s13);
    const M _s15 = lanes_both(lanes_both(lanes_both(lanes_both(lanes_less(K(0.0), press), _s1), lanes_less(lanes_mul(lanes_mul(K(3.0), _s2), _s7), lanes_mul(press, _s8))), lanes_at_most(slip, lanes_add(lanes_mul(lanes_mul(K(8.0), rolling_friction), _s2), _s10))), lanes_at_most(_s11, _s14));
    const V _s16 = lanes_mul(K(0.5), bounce);
    const V _s17 = lanes_mul(_s12, _s0);
    const V _s18 = lanes_mul(K(4.0), rolling_friction);
    const V _s19 = lanes_add(lanes_add(lanes_mul(_s16, _s2), lanes_div(lanes_mul(_s18, lanes_mul(_s2, _s2)), _s17)), lanes_div(lanes_mul(lanes_mul(lanes_mul(K(4.0), slip), _c2), _s2), _s0));
    const M _s20 = lanes_both(_s15, lanes_at_most(_s19, _c3));
    const M _s21 = lanes_at_most(second_contact_gap, _c4);
    const V _s22 = lanes_div(lanes_mul(lanes_mul(K(16.0), _s2), _s5), _s0);
    const M _s23 = lanes_less(lanes_add(_c4, _s22), nearest);
    const M _s24 = lanes_at_most(_s22, _c4);
    const M _s25 = lanes_equal(mode, K(5.0));
    const V _s26 = lanes_mul(K(3.552713678800501e-15), lanes_add(K(1.0), lanes_div(lanes_add(lanes_add(lanes_abs(x), lanes_abs(y)), lanes_abs(z)), _c0)));
    const V _s27 = lanes_mul(_s26, lanes_add(lanes_add(lanes_add(_s4, lanes_abs(vx)), lanes_abs(vy)), lanes_abs(vz)));
    const V _s28 = lanes_neg(lanes_add(lanes_add(lanes_mul(nx, vx), lanes_mul(ny, vy)), lanes_mul(nz, vz)));
    const M _s29 = lanes_both(lanes_both(_s25, lanes_at_most(bounce, _s27)), lanes_at_most(_s28, _s27));
    const M _s30 = lanes_both(_s29, lanes_less(K(0.0), gap_jerk));
    const V _s31 = lanes_abs(lift);
    const V _s32 = lanes_mul(K(2.2737367544323206e-13), lanes_add(_c1, lanes_div(lanes_add(lanes_add(lanes_mul(vx, vx), lanes_mul(vy, vy)), lanes_mul(vz, vz)), _c0)));
    const M _s33 = lanes_both(_s30, lanes_at_most(_s31, _s32));
    const M _s34 = lanes_not(_s33);
    const V _s35 = lanes_neg(lift);
    const V _s36 = lanes_min(_s35, press);
    const V _s37 = lanes_div(bounce, _s36);
    const M _s38 = lanes_both(lanes_both(lanes_both(lanes_less(K(0.0), _s36), _s1), lanes_less(lanes_mul(lanes_mul(K(3.0), _s37), _s7), lanes_mul(_s8, _s36))), lanes_less(lanes_add(_c4, lanes_div(lanes_mul(lanes_mul(K(16.0), _s37), _s5), _s0)), nearest));
    const M _s39 = lanes_both(_s38, lanes_at_most(lanes_add(lanes_mul(_s16, _s37), lanes_div(lanes_mul(_s18, lanes_mul(_s37, _s37)), _s17)), _c3));
    const V _s40 = lanes_add(lanes_div(lanes_mul(K(2.0), lanes_add(lanes_mul(_s11, _s37), lanes_select(lanes_less(K(0.0), bounce), lanes_mul(bounce, _s13), K(0.0)))), lanes_mul(_c2, _s0)), lanes_mul(K(1.4551915228366852e-11), _s9));
    const M _s41 = lanes_either(lanes_both(lanes_both(lanes_at_most(bounce, _s10), lanes_at_most(K(0.0), lift)), lanes_not(lanes_both(_s25, lanes_less(lanes_mul(K(0.5), _s27), _s28)))), _s33);
    const V _s42 = lanes_add(slip, _s5);
    const V _s43 = lanes_abs(per_reach);
    const V _s44 = lanes_add(_c1, lanes_mul(lanes_mul(_s42, _s42), _s43));
    const V _s45 = lanes_add(lanes_mul(lanes_mul(K(8.0), lanes_add(lanes_mul(position_error, _s44), lanes_mul(velocity_error, _s42))), _s43), lanes_mul(K(3.552713678800501e-15), _s44));
    const M _s46 = lanes_both(lanes_both(lanes_at_most(lanes_mul(bounce, lanes_abs(lanes_sub(_s19, _c3))), lanes_mul(lanes_mul(K(2.0), velocity_error), _c3)), lanes_less(K(0.0), lanes_mul(p_ring_restitution, bounce))), lanes_not(_s29));
    const V _s47 = lanes_mul(K(8.0), velocity_error);
    const M _s48 = lanes_both(_s39, lanes_either(lanes_less(lanes_abs(lanes_sub(slip, _s40)), _s47), lanes_less(lanes_abs(lanes_sub(_s11, _s14)), lanes_mul(_s47, lanes_add(lanes_mul(_s13, _s3), _s3)))));
    const M _s49 = lanes_either(lanes_either(lanes_either(lanes_either(lanes_at_most(lanes_abs(press), _s45), lanes_at_most(_s31, _s45)), _s46), _s48), lanes_both(lanes_both(_s20, _s24), lanes_not(_s23)));
    return (LANES(court_ring_impact_settling_out)){ lanes_both(lanes_both(lanes_both(_s20, lanes_not(_s21)), lanes_either(_s23, _s24)), _s34), lanes_both(lanes_both(_s20, _s21), _s34), lanes_both(lanes_both(_s39, lanes_either(lanes_less(_s40, slip), lanes_less(_s14, _s11))), _s34), _s41, lanes_select(lanes_either(lanes_both(_s15, _s23), _s38), K(1.0), K(0.0)), lanes_either(lanes_both(_s49, _s34), lanes_both(_s30, lanes_both(lanes_less(lanes_mul(K(0.5), _s32), _s31), lanes_less(_s31, lanes_mul(K(2.0), _s32))))) };
}

/* Excess F² - mu² N² and its rate.
   Coulomb's law. 8 operations: 2 subtractions, 6 multiplications. */
typedef struct {
    V grip_deficit, grip_deficit_rate;
} LANES(court_ring_impact_grip_deficit_out);

LANES_INLINE LANES(court_ring_impact_grip_deficit_out)
LANES(court_ring_impact_grip_deficit)(V p_ring_friction, V rolling_friction, V rolling_friction_rate, V force, V force_rate)
{
    const V _s0 = lanes_mul(p_ring_friction, p_ring_friction);
    return (LANES(court_ring_impact_grip_deficit_out)){ lanes_sub(rolling_friction, lanes_mul(_s0, lanes_mul(force, force))), lanes_sub(rolling_friction_rate, lanes_mul(_s0, lanes_mul(K(2.0), lanes_mul(force, force_rate)))) };
}

/* Slip of a contact, the share of it that friction takes, and the margin of grip.
   momentum, angular momentum and Coulomb's law of friction. 60 operations: 5 additions, 11 subtractions, 26 multiplications, 4 divisions, 1 square root, 1 negation, 4 comparisons, 8 selections. */
typedef struct {
    V slip_share, slip_margin, slip_speed, slip_x, slip_y, slip_z;
} LANES(court_ring_impact_slip_out);

LANES_INLINE LANES(court_ring_impact_slip_out)
LANES(court_ring_impact_slip)(V vx, V vy, V vz, V wx, V wy, V wz, V nx, V ny, V nz, V p_ring_restitution, V p_ring_friction, V _c0, V _c1, V _c2, V _c3)
{
    const V _s0 = lanes_add(lanes_add(lanes_mul(nx, vx), lanes_mul(ny, vy)), lanes_mul(nz, vz));
    const V _s1 = lanes_sub(lanes_sub(vz, lanes_mul(nz, _s0)), lanes_mul(_c0, lanes_sub(lanes_mul(ny, wx), lanes_mul(nx, wy))));
    const V _s2 = lanes_sub(lanes_sub(vy, lanes_mul(ny, _s0)), lanes_mul(_c0, lanes_sub(lanes_mul(nx, wz), lanes_mul(nz, wx))));
    const V _s3 = lanes_sub(lanes_sub(vx, lanes_mul(nx, _s0)), lanes_mul(_c0, lanes_sub(lanes_mul(nz, wy), lanes_mul(ny, wz))));
    const V _s4 = lanes_add(lanes_add(lanes_mul(_s1, _s1), lanes_mul(_s2, _s2)), lanes_mul(_s3, _s3));
    const V _s5 = lanes_mul(p_ring_friction, lanes_mul(lanes_add(K(1.0), lanes_div(p_ring_restitution, lanes_sub(K(1.0), lanes_div(_s0, _c1)))), _s0));
    const V _s6 = lanes_neg(_s5);
    const V _s7 = lanes_sqrt(_s4);
    const M _s8 = lanes_less(p_ring_friction, K(INFINITY));
    const M _s9 = lanes_less(K(0.0), p_ring_friction);
    const V _s10 = lanes_div(K(1.0), _s7);
    const M _s11 = lanes_less(K(0.0), _s7);
    return (LANES(court_ring_impact_slip_out)){ lanes_select(_s9, lanes_select(_s8, lanes_select(lanes_at_most(lanes_mul(_s4, _c3), lanes_mul(_s6, _s6)), _c2, lanes_div(_s6, _s7)), _c2), K(0.0)), lanes_select(_s9, lanes_select(_s8, lanes_sub(_s6, lanes_mul(_c2, _s7)), K(1.0)), K(1.0)), _s7, lanes_select(_s11, lanes_mul(_s3, _s10), K(0.0)), lanes_select(_s11, lanes_mul(_s2, _s10), K(0.0)), lanes_select(_s11, lanes_mul(_s1, _s10), K(0.0)) };
}

/* Bounds on errors after a contact, from those at the departure before it.
   derivative of the contact with friction, with roundings. 1515 operations: 369 additions, 141 subtractions, 722 multiplications, 12 divisions, 92 negations, 132 absolute values, 16 comparisons, 31 selections. */
typedef struct {
    S place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound, spin_bound, left_nx, left_ny, left_nz, left_ex, left_ey, left_bend_s, left_bend_e, delay;
} LANES(court_bound_ring_impact_out);

LANES_INLINE LANES(court_bound_ring_impact_out)
LANES(court_bound_ring_impact)(S t, S x, S y, S z, S vx, S vy, S vz, S wx, S wy, S wz, S nx, S ny, S nz, S clock, S left_nx, S left_ny, S left_nz, S place_n, S place_s, S place_e, S pace_n, S pace_s, S pace_e, S turn_n, S turn_z, S position_bound, S velocity_bound, S spin_bound, S tangent_x, S tangent_y, S bend_s, S bend_e, S left_ex, S left_ey, S left_bend_s, S left_bend_e, S sharpest_bend, S root_offset, S root_level, S normal_rounding, S normal_velocity, S back, S slip_share, S slip_margin, S slip_speed, S slip_x, S slip_y, S slip_z, S p_ring_restitution, S p_ring_friction, S _c0, S _c1, S _c2, S _c3, S _c4, S _c5, S _c6, S _c7, S _c8, S _c9, S _c10, S _c11)
{
    const S _s0 = singles_neg(singles_mul(_c1, nz));
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
    const S _s20 = singles_neg(singles_mul(_c1, _s18));
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
    const S _s36 = singles_mul(_c1, t);
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
    const S _s47 = singles_add(singles_mul(_c1, _s44), _s46);
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
    const S _s61 = singles_max(_s54, _s60);
    const S _s62 = singles_add(singles_add(singles_abs(wx), singles_abs(wy)), singles_abs(wz));
    const S _s63 = singles_mul(KS(1.125), _s51);
    const S _s64 = singles_add(spin_bound, singles_mul(_s63, singles_add(spin_bound, _s62)));
    const S _s65 = singles_add(singles_mul(_s63, _s48), _s47);
    const S _s66 = singles_add(singles_mul(_c0, _s64), _s65);
    const S _s67 = singles_add(normal_rounding, _s59);
    const S _s68 = singles_add(singles_mul(normal_rounding, singles_add(_s38, _s43)), singles_mul(singles_mul(KS(2.0), _s59), _s43));
    const S _s69 = singles_add(singles_mul(singles_mul(_c0, _s67), _s62), _s68);
    const S _s70 = singles_add(_s66, _s69);
    const S _s71 = singles_mul(_s67, _s38);
    const S _s72 = singles_add(KS(1.0), p_ring_restitution);
    const S _s73 = singles_select(singles_less(p_ring_friction, KS(INFINITY)), singles_mul(p_ring_friction, _s72), KS(0.0));
    const S _s74 = singles_add(singles_mul(_c0, _s62), _s38);
    const S _s75 = singles_mul(_c4, _s74);
    const S _s76 = singles_sub(singles_add(singles_mul(KS(1.125), singles_add(singles_mul(_c4, _s70), singles_mul(singles_add(_s71, _s65), _s73))), singles_mul(KS(3.552713678800501e-15), singles_add(_s75, singles_mul(_s38, _s73)))), singles_abs(slip_margin));
    const S _s77 = singles_max(_s61, _s76);
    const Q _s78 = singles_less(slip_margin, KS(0.0));
    const S _s79 = singles_select(_s78, singles_sub(singles_mul(KS(5.0), singles_add(singles_mul(KS(9.5367431640625e-07), _s74), _s70)), slip_speed), KS(-1.0));
    const S _s80 = singles_mul(KS(1.0009765625), _s58);
    const Q _s81 = singles_at_most(singles_max(_s77, _s79), KS(0.0));
    const S _s82 = singles_div(singles_add(root_offset, _s41), _s43);
    const S _s83 = singles_add(singles_mul(singles_abs(_s19), _s82), singles_add(singles_add(singles_mul(singles_abs(_s12), _s5), singles_mul(singles_abs(_s11), _s3)), singles_mul(singles_abs(_s18), _s7)));
    const S _s84 = singles_add(singles_add(_s57, singles_mul(KS(7.62939453125e-06), _s49)), _s41);
    const S _s85 = singles_div(KS(1.0), normal_velocity);
    const S _s86 = singles_neg(singles_mul(_s85, _s10));
    const S _s87 = singles_add(singles_add(singles_mul(left_nx, _s11), singles_mul(left_ny, _s12)), singles_mul(left_nz, _s18));
    const S _s88 = singles_add(singles_mul(_s86, _s19), _s87);
    const S _s89 = singles_neg(singles_mul(_s85, _s27));
    const S _s90 = singles_sub(normal_velocity, singles_mul(t, _s0));
    const S _s91 = singles_mul(left_bend_s, _s30);
    const S _s92 = singles_sub(singles_mul(_s17, _s90), singles_mul(_s91, _s15));
    const S _s93 = singles_add(singles_add(singles_mul(_s12, _s24), singles_mul(_s11, _s23)), singles_mul(_s18, _s25));
    const S _s94 = singles_add(singles_mul(_s89, _s19), singles_add(singles_mul(t, _s92), _s93));
    const S _s95 = singles_neg(singles_mul(_s85, _s31));
    const S _s96 = singles_mul(nz, left_bend_e);
    const S _s97 = singles_neg(singles_mul(_s96, _s15));
    const S _s98 = singles_add(singles_mul(_s95, _s19), singles_add(singles_mul(t, _s97), _s13));
    const S _s99 = singles_neg(singles_mul(_s85, _s32));
    const S _s100 = singles_add(singles_mul(_s99, _s19), singles_mul(t, _s87));
    const S _s101 = singles_neg(singles_mul(_s85, _s33));
    const S _s102 = singles_add(singles_mul(_s101, _s19), singles_mul(t, _s93));
    const S _s103 = singles_add(singles_add(singles_add(singles_add(singles_mul(place_n, singles_abs(_s88)), singles_mul(place_s, singles_abs(_s94))), singles_mul(place_e, singles_abs(_s98))), singles_mul(pace_n, singles_abs(_s100))), singles_mul(pace_s, singles_abs(_s102)));
    const S _s104 = singles_neg(singles_mul(_s85, _s35));
    const S _s105 = singles_add(singles_mul(_s104, _s19), singles_mul(t, _s13));
    const S _s106 = singles_mul(KS(1.0009765625), singles_add(singles_add(_s83, _s84), singles_add(_s103, singles_mul(pace_e, singles_abs(_s105)))));
    const S _s107 = singles_add(singles_mul(singles_abs(_s15), _s82), singles_add(singles_add(singles_mul(_c5, _s7), singles_mul(singles_abs(tangent_x), _s3)), singles_mul(singles_abs(tangent_y), _s5)));
    const S _s108 = singles_add(singles_mul(left_nx, tangent_x), singles_mul(left_ny, tangent_y));
    const S _s109 = singles_add(singles_mul(_s86, _s15), _s108);
    const S _s110 = singles_sub(singles_mul(_s91, _s21), singles_mul(_s14, _s90));
    const S _s111 = singles_add(singles_mul(tangent_x, _s23), singles_mul(tangent_y, _s24));
    const S _s112 = singles_add(singles_mul(_s89, _s15), singles_add(singles_mul(t, _s110), _s111));
    const S _s113 = singles_sub(singles_mul(_s96, _s21), singles_mul(_s28, _s90));
    const S _s114 = singles_add(singles_mul(_s95, _s15), singles_add(singles_mul(t, _s113), _s16));
    const S _s115 = singles_add(singles_mul(_s99, _s15), singles_mul(t, _s108));
    const S _s116 = singles_add(singles_mul(_s101, _s15), singles_mul(t, _s111));
    const S _s117 = singles_add(singles_add(singles_add(singles_add(singles_mul(place_n, singles_abs(_s109)), singles_mul(place_s, singles_abs(_s112))), singles_mul(place_e, singles_abs(_s114))), singles_mul(pace_n, singles_abs(_s115))), singles_mul(pace_s, singles_abs(_s116)));
    const S _s118 = singles_add(singles_mul(_s104, _s15), singles_mul(t, _s16));
    const S _s119 = singles_mul(KS(1.0009765625), singles_add(singles_add(_s107, _s84), singles_add(_s117, singles_mul(pace_e, singles_abs(_s118)))));
    const S _s120 = singles_add(KS(1.0), singles_div(_s43, _c2));
    const S _s121 = singles_mul(p_ring_restitution, singles_sub(singles_div(KS(1.0), _s120), singles_div(singles_mul(_s43, _c6), singles_mul(_s120, _s120))));
    const S _s122 = singles_add(singles_mul(_c1, _s82), _s45);
    const S _s123 = singles_neg(singles_mul(bend_s, _s19));
    const S _s124 = singles_mul(bend_e, _s18);
    const S _s125 = singles_mul(_s124, _s15);
    const S _s126 = singles_add(_s122, singles_add(singles_mul(singles_abs(_s123), _s83), singles_mul(singles_abs(_s125), _s107)));
    const S _s127 = singles_select(_s78, _s73, KS(0.0));
    const S _s128 = singles_add(singles_mul(_c7, _s74), singles_mul(singles_mul(KS(4.0), _s38), _s127));
    const S _s129 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(KS(20.0), _s74), _s128)));
    const S _s130 = singles_div(p_ring_restitution, _c2);
    const S _s131 = singles_mul(_s65, _s65);
    const S _s132 = singles_mul(KS(1.125), singles_add(singles_mul(_c4, _s66), singles_mul(_s65, _s127)));
    const S _s133 = singles_mul(singles_add(bend_s, bend_e), _s84);
    const S _s134 = singles_add(_s75, _s38);
    const S _s135 = singles_add(singles_mul(_s50, _s57), singles_mul(KS(2.0), singles_mul(_s51, _s51)));
    const S _s136 = singles_mul(KS(1.125), _s135);
    const S _s137 = singles_add(singles_mul(_c1, _s56), singles_mul(KS(1.125), singles_add(singles_mul(_s51, _s47), singles_mul(_s135, _s38))));
    const S _s138 = singles_add(singles_add(singles_add(singles_add(singles_mul(_s130, _s131), singles_mul(_s63, singles_add(_s65, _s132))), singles_mul(_s133, _s134)), singles_mul(_s136, _s134)), _s137);
    const S _s139 = singles_mul(KS(4.0), _s51);
    const S _s140 = singles_add(singles_mul(_s139, _s38), singles_mul(KS(2.0), singles_add(_s40, _s47)));
    const S _s141 = singles_add(singles_mul(_s139, _s62), singles_mul(KS(2.0), singles_add(spin_bound, singles_mul(_s39, _s62))));
    const S _s142 = singles_mul(KS(2.0), singles_add(singles_mul(_c4, singles_add(singles_mul(_c0, _s141), _s140)), singles_mul(_s140, _s127)));
    const S _s143 = singles_mul(KS(1.125), singles_add(singles_mul(spin_bound, _s51), singles_mul(_s135, _s62)));
    const S _s144 = singles_select(_s78, singles_add(singles_mul(singles_div(_s66, slip_speed), singles_add(singles_mul(singles_mul(KS(1.02), _s65), _s127), singles_mul(singles_mul(KS(1.05), slip_share), _s66))), singles_mul(singles_mul(p_ring_friction, _s130), _s131)), KS(0.0));
    const S _s145 = singles_add(singles_add(singles_mul(_c4, singles_add(singles_mul(_c0, _s143), _s137)), singles_mul(_s137, _s127)), _s144);
    const S _s146 = singles_add(singles_add(_s138, singles_mul(KS(7.62939453125e-06), singles_add(_s140, _s142))), _s145);
    const S _s147 = singles_mul(KS(1.125), singles_add(singles_mul(_s71, _s127), singles_mul(_c4, _s69)));
    const S _s148 = singles_neg(singles_mul(_s0, _s121));
    const S _s149 = singles_neg(singles_mul(_s121, _s123));
    const S _s150 = singles_neg(singles_mul(_s121, _s125));
    const S _s151 = singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s89, _s148), singles_neg(singles_mul(_s121, _s22))), singles_mul(_s149, _s94)), singles_mul(_s150, _s112)));
    const S _s152 = singles_add(singles_mul(place_n, singles_abs(singles_sub(singles_sub(singles_mul(_s86, _s148), singles_mul(_s149, _s88)), singles_mul(_s150, _s109)))), singles_mul(place_s, _s151));
    const S _s153 = singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s95, _s148), singles_neg(singles_mul(_s121, _s29))), singles_mul(_s149, _s98)), singles_mul(_s150, _s114)));
    const S _s154 = singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s99, _s148), singles_neg(singles_mul(_s121, _s9))), singles_mul(_s149, _s100)), singles_mul(_s150, _s115)));
    const S _s155 = singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s101, _s148), singles_neg(singles_mul(_s121, _s26))), singles_mul(_s149, _s102)), singles_mul(_s150, _s116)));
    const S _s156 = singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s104, _s148), singles_neg(singles_mul(_s121, _s30))), singles_mul(_s149, _s105)), singles_mul(_s150, _s118)));
    const S _s157 = singles_add(singles_add(singles_add(singles_mul(_s72, _s68), singles_mul(singles_abs(singles_neg(_s121)), _s126)), singles_add(singles_add(_s129, _s146), _s147)), singles_add(singles_add(singles_add(singles_add(_s152, singles_mul(place_e, _s153)), singles_mul(pace_n, _s154)), singles_mul(pace_s, _s155)), singles_mul(pace_e, _s156)));
    const S _s158 = singles_mul(KS(1.0009765625), _s157);
    const S _s159 = singles_add(singles_add(singles_add(singles_mul(singles_mul(normal_rounding, _s72), _s43), _s129), _s146), _s147);
    const S _s160 = singles_add(singles_add(singles_mul(slip_x, _s11), singles_mul(slip_y, _s12)), singles_mul(slip_z, _s18));
    const S _s161 = singles_select(_s78, slip_share, KS(0.0));
    const S _s162 = singles_neg(singles_mul(_s160, _s161));
    const S _s163 = singles_add(slip_share, singles_mul(_s162, _s160));
    const S _s164 = singles_mul(bend_s, normal_velocity);
    const S _s165 = singles_mul(nz, bend_e);
    const S _s166 = singles_neg(singles_mul(_s165, _s15));
    const S _s167 = singles_add(_s122, singles_add(singles_mul(singles_abs(_s164), _s83), singles_mul(singles_abs(_s166), _s107)));
    const S _s168 = singles_add(singles_mul(tangent_x, slip_x), singles_mul(tangent_y, slip_y));
    const S _s169 = singles_neg(singles_mul(singles_mul(_c0, _s168), _s161));
    const S _s170 = singles_mul(_s169, _s160);
    const S _s171 = singles_add(singles_add(singles_mul(nx, wx), singles_mul(ny, wy)), singles_mul(nz, wz));
    const S _s172 = singles_mul(bend_s, _s171);
    const S _s173 = singles_abs(_s172);
    const S _s174 = singles_add(singles_mul(wx, tangent_x), singles_mul(wy, tangent_y));
    const S _s175 = singles_neg(singles_mul(_s165, _s174));
    const S _s176 = singles_add(singles_mul(_s173, _s83), singles_mul(singles_abs(_s175), _s107));
    const S _s177 = singles_neg(singles_mul(_s168, _s161));
    const S _s178 = singles_mul(_s177, _s160);
    const S _s179 = singles_mul(_c5, _s83);
    const S _s180 = singles_mul(bend_e, singles_sub(singles_mul(nz, _s19), singles_mul(normal_velocity, _s18)));
    const S _s181 = singles_add(_s122, singles_add(_s179, singles_mul(singles_abs(_s180), _s107)));
    const S _s182 = singles_select(_s78, singles_mul(p_ring_friction, singles_add(KS(1.0), _s121)), KS(0.0));
    const S _s183 = singles_neg(_s182);
    const S _s184 = singles_mul(_s160, _s183);
    const S _s185 = singles_add(singles_add(singles_add(singles_mul(singles_abs(singles_sub(KS(1.0), _s163)), _s167), singles_mul(singles_abs(singles_neg(_s170)), _s176)), singles_mul(singles_abs(singles_neg(_s178)), _s181)), singles_mul(singles_abs(singles_neg(_s184)), _s126));
    const S _s186 = singles_neg(singles_mul(singles_mul(_c8, _s160), _s161));
    const S _s187 = singles_add(singles_mul(_s186, _s160), singles_mul(slip_share, _c8));
    const S _s188 = singles_add(singles_add(singles_mul(wx, _s11), singles_mul(wy, _s12)), singles_mul(wz, _s18));
    const S _s189 = singles_mul(_s18, _s171);
    const S _s190 = singles_mul(bend_e, singles_sub(singles_mul(nz, _s188), _s189));
    const S _s191 = singles_add(_s179, singles_mul(singles_abs(_s190), _s107));
    const S _s192 = singles_neg(singles_add(singles_mul(_s0, _s182), singles_mul(singles_mul(_s20, _s160), _s161)));
    const S _s193 = singles_add(singles_mul(_s192, _s160), singles_mul(slip_share, _s20));
    const S _s194 = singles_sub(_s20, _s193);
    const S _s195 = singles_sub(_s166, singles_mul(_c0, _s190));
    const S _s196 = singles_add(singles_mul(_c0, _s175), _s180);
    const S _s197 = singles_neg(singles_add(singles_mul(_s125, _s182), singles_mul(singles_add(singles_mul(_s195, _s160), singles_mul(_s196, _s168)), _s161)));
    const S _s198 = singles_add(singles_mul(_s197, _s160), singles_mul(slip_share, _s195));
    const S _s199 = singles_sub(_s166, _s198);
    const S _s200 = singles_mul(_c0, _s172);
    const S _s201 = singles_neg(singles_add(singles_mul(_s123, _s182), singles_mul(singles_add(singles_mul(_s200, _s168), singles_mul(_s164, _s160)), _s161)));
    const S _s202 = singles_add(singles_mul(_s201, _s160), singles_mul(slip_share, _s164));
    const S _s203 = singles_sub(_s164, _s202);
    const S _s204 = singles_add(singles_mul(_c0, singles_sub(singles_mul(_s17, _s171), singles_mul(_s91, _s174))), _s110);
    const S _s205 = singles_sub(_s92, singles_mul(_c0, singles_sub(singles_mul(_s91, _s188), singles_mul(_s14, _s171))));
    const S _s206 = singles_neg(singles_add(singles_mul(_s22, _s182), singles_mul(singles_add(singles_mul(_s204, _s168), singles_mul(_s205, _s160)), _s161)));
    const S _s207 = singles_add(singles_mul(_s206, _s160), singles_mul(slip_share, _s205));
    const S _s208 = singles_mul(place_s, singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s89, _s194), singles_sub(_s92, _s207)), singles_mul(_s112, _s199)), singles_mul(_s94, _s203))));
    const S _s209 = singles_add(singles_mul(place_n, singles_abs(singles_sub(singles_sub(singles_mul(_s86, _s194), singles_mul(_s109, _s199)), singles_mul(_s88, _s203)))), _s208);
    const S _s210 = singles_add(singles_mul(_c0, singles_neg(singles_mul(_s96, _s174))), _s113);
    const S _s211 = singles_sub(_s97, singles_mul(_c0, singles_sub(singles_mul(_s96, _s188), singles_mul(_s28, _s171))));
    const S _s212 = singles_neg(singles_add(singles_mul(_s29, _s182), singles_mul(singles_add(singles_mul(_s210, _s168), singles_mul(_s211, _s160)), _s161)));
    const S _s213 = singles_add(singles_mul(_s212, _s160), singles_mul(slip_share, _s211));
    const S _s214 = singles_mul(place_e, singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s95, _s194), singles_sub(_s97, _s213)), singles_mul(_s114, _s199)), singles_mul(_s98, _s203))));
    const S _s215 = singles_neg(singles_add(singles_mul(singles_add(singles_mul(_s108, _s168), singles_mul(_s87, _s160)), _s161), singles_mul(_s9, _s182)));
    const S _s216 = singles_add(singles_mul(_s215, _s160), singles_mul(slip_share, _s87));
    const S _s217 = singles_mul(pace_n, singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s99, _s194), singles_sub(_s87, _s216)), singles_mul(_s115, _s199)), singles_mul(_s100, _s203))));
    const S _s218 = singles_sub(_s93, singles_mul(_c0, singles_mul(_c9, _s16)));
    const S _s219 = singles_add(singles_mul(_c0, singles_mul(_c9, _s13)), _s111);
    const S _s220 = singles_neg(singles_add(singles_mul(singles_add(singles_mul(_s218, _s160), singles_mul(_s219, _s168)), _s161), singles_mul(_s26, _s182)));
    const S _s221 = singles_add(singles_mul(_s220, _s160), singles_mul(slip_share, _s218));
    const S _s222 = singles_mul(pace_s, singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s101, _s194), singles_sub(_s93, _s221)), singles_mul(_s116, _s199)), singles_mul(_s102, _s203))));
    const S _s223 = singles_sub(_s13, singles_mul(_c0, singles_neg(singles_mul(_c9, _s111))));
    const S _s224 = singles_add(singles_mul(_c0, singles_neg(singles_mul(_c9, _s93))), _s16);
    const S _s225 = singles_neg(singles_add(singles_mul(_s30, _s182), singles_mul(singles_add(singles_mul(_s223, _s160), singles_mul(_s224, _s168)), _s161)));
    const S _s226 = singles_add(singles_mul(_s225, _s160), singles_mul(slip_share, _s223));
    const S _s227 = singles_mul(pace_e, singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s104, _s194), singles_sub(_s13, _s226)), singles_mul(_s118, _s199)), singles_mul(_s105, _s203))));
    const S _s228 = singles_neg(singles_mul(_c0, _s108));
    const S _s229 = singles_mul(_c0, _s87);
    const S _s230 = singles_neg(singles_mul(singles_add(singles_mul(_s228, _s160), singles_mul(_s229, _s168)), _s161));
    const S _s231 = singles_add(singles_mul(_s230, _s160), singles_mul(slip_share, _s228));
    const S _s232 = singles_neg(singles_mul(_c0, _s16));
    const S _s233 = singles_mul(_c0, _s13);
    const S _s234 = singles_neg(singles_mul(singles_add(singles_mul(_s232, _s160), singles_mul(_s233, _s168)), _s161));
    const S _s235 = singles_add(singles_mul(_s234, _s160), singles_mul(slip_share, _s232));
    const S _s236 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_add(_s209, _s214), _s217), _s222), _s227), singles_mul(turn_n, singles_abs(singles_neg(_s231)))), singles_mul(turn_z, singles_abs(singles_neg(_s235))));
    const S _s237 = singles_neg(singles_mul(_c0, _s111));
    const S _s238 = singles_mul(_c0, _s93);
    const S _s239 = singles_neg(singles_mul(singles_add(singles_mul(_s237, _s160), singles_mul(_s238, _s168)), _s161));
    const S _s240 = singles_add(singles_mul(_s239, _s160), singles_mul(slip_share, _s237));
    const S _s241 = singles_add(singles_add(_s159, singles_add(_s185, singles_mul(singles_abs(singles_neg(_s187)), _s191))), singles_add(_s236, singles_mul(turn_z, singles_abs(singles_neg(_s240)))));
    const S _s242 = singles_mul(KS(1.0009765625), _s241);
    const S _s243 = singles_add(slip_share, singles_mul(_s177, _s168));
    const S _s244 = singles_mul(_s186, _s168);
    const S _s245 = singles_mul(_s162, _s168);
    const S _s246 = singles_mul(_s168, _s183);
    const S _s247 = singles_add(singles_add(singles_add(singles_mul(singles_abs(singles_sub(KS(1.0), _s243)), _s181), singles_mul(singles_abs(singles_neg(_s244)), _s191)), singles_mul(singles_abs(singles_neg(_s245)), _s167)), singles_mul(singles_abs(singles_neg(_s246)), _s126));
    const S _s248 = singles_add(singles_mul(_s169, _s168), singles_mul(_c0, slip_share));
    const S _s249 = singles_mul(_s168, _s192);
    const S _s250 = singles_neg(_s249);
    const S _s251 = singles_add(singles_mul(_s168, _s197), singles_mul(slip_share, _s196));
    const S _s252 = singles_sub(_s180, _s251);
    const S _s253 = singles_add(singles_mul(_s168, _s201), singles_mul(slip_share, _s200));
    const S _s254 = singles_neg(_s253);
    const S _s255 = singles_add(singles_mul(_s168, _s206), singles_mul(slip_share, _s204));
    const S _s256 = singles_mul(place_s, singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s89, _s250), singles_sub(_s110, _s255)), singles_mul(_s112, _s252)), singles_mul(_s94, _s254))));
    const S _s257 = singles_add(singles_mul(place_n, singles_abs(singles_sub(singles_sub(singles_mul(_s86, _s250), singles_mul(_s109, _s252)), singles_mul(_s88, _s254)))), _s256);
    const S _s258 = singles_add(singles_mul(_s168, _s212), singles_mul(slip_share, _s210));
    const S _s259 = singles_mul(place_e, singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s95, _s250), singles_sub(_s113, _s258)), singles_mul(_s114, _s252)), singles_mul(_s98, _s254))));
    const S _s260 = singles_add(singles_mul(_s168, _s215), singles_mul(slip_share, _s108));
    const S _s261 = singles_mul(pace_n, singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s99, _s250), singles_sub(_s108, _s260)), singles_mul(_s115, _s252)), singles_mul(_s100, _s254))));
    const S _s262 = singles_add(singles_mul(_s168, _s220), singles_mul(slip_share, _s219));
    const S _s263 = singles_mul(pace_s, singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s101, _s250), singles_sub(_s111, _s262)), singles_mul(_s116, _s252)), singles_mul(_s102, _s254))));
    const S _s264 = singles_add(singles_mul(_s168, _s225), singles_mul(slip_share, _s224));
    const S _s265 = singles_mul(pace_e, singles_abs(singles_sub(singles_sub(singles_add(singles_mul(_s104, _s250), singles_sub(_s16, _s264)), singles_mul(_s118, _s252)), singles_mul(_s105, _s254))));
    const S _s266 = singles_add(singles_mul(_s230, _s168), singles_mul(slip_share, _s229));
    const S _s267 = singles_add(singles_mul(_s234, _s168), singles_mul(slip_share, _s233));
    const S _s268 = singles_add(singles_add(singles_add(singles_add(singles_add(singles_add(_s257, _s259), _s261), _s263), _s265), singles_mul(turn_n, singles_abs(singles_neg(_s266)))), singles_mul(turn_z, singles_abs(singles_neg(_s267))));
    const S _s269 = singles_add(singles_mul(_s239, _s168), singles_mul(slip_share, _s238));
    const S _s270 = singles_add(singles_add(_s159, singles_add(_s247, singles_mul(singles_abs(singles_neg(_s248)), _s176))), singles_add(_s268, singles_mul(turn_z, singles_abs(singles_neg(_s269)))));
    const S _s271 = singles_mul(KS(1.0009765625), _s270);
    const S _s272 = singles_neg(singles_mul(bend_s, _s188));
    const S _s273 = singles_mul(_s124, _s174);
    const S _s274 = singles_add(singles_mul(_s75, _c10), _s62);
    const S _s275 = singles_add(singles_add(singles_add(singles_mul(_s63, singles_add(singles_mul(_s132, _c10), _s64)), singles_mul(_s133, _s274)), singles_mul(_s136, _s274)), singles_mul(_s145, _c10));
    const S _s276 = singles_add(singles_add(singles_mul(singles_add(singles_mul(singles_mul(_c4, _s67), _s74), _s147), _c10), singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s128, _c10), singles_mul(KS(4.0), _s62))))), singles_add(singles_add(_s275, singles_mul(KS(7.62939453125e-06), singles_add(singles_mul(_c10, _s142), _s141))), _s143));
    const S _s277 = singles_mul(place_s, singles_abs(singles_sub(singles_sub(singles_sub(singles_mul(_s14, _s174), singles_mul(_s17, _s188)), singles_mul(_s272, _s94)), singles_mul(_s273, _s112))));
    const S _s278 = singles_add(singles_mul(place_n, singles_abs(singles_neg(singles_add(singles_mul(_s272, _s88), singles_mul(_s273, _s109))))), _s277);
    const S _s279 = singles_add(_s278, singles_mul(place_e, singles_abs(singles_sub(singles_sub(singles_mul(_s28, _s174), singles_mul(_s272, _s98)), singles_mul(_s273, _s114)))));
    const S _s280 = singles_add(_s279, singles_mul(pace_n, singles_abs(singles_neg(singles_add(singles_mul(_s272, _s100), singles_mul(_s273, _s115))))));
    const S _s281 = singles_add(_s280, singles_mul(pace_s, singles_abs(singles_sub(singles_sub(singles_mul(_c9, _s30), singles_mul(_s272, _s102)), singles_mul(_s273, _s116)))));
    const S _s282 = singles_mul(pace_e, singles_abs(singles_sub(singles_sub(singles_neg(singles_mul(_c9, _s26)), singles_mul(_s272, _s105)), singles_mul(_s273, _s118))));
    const S _s283 = singles_add(singles_add(singles_add(singles_mul(singles_abs(_s272), _s83), singles_mul(singles_abs(_s273), _s107)), _s276), singles_add(singles_add(singles_add(singles_add(_s281, _s282), singles_mul(turn_n, singles_abs(_s9))), singles_mul(turn_z, singles_abs(_s30))), singles_mul(turn_z, singles_abs(_s26))));
    const S _s284 = singles_mul(KS(1.0009765625), _s283);
    const S _s285 = singles_add(singles_mul(singles_abs(singles_mul(_c9, singles_neg(singles_mul(_s244, _c11)))), _s191), singles_mul(singles_abs(singles_mul(_c9, singles_neg(singles_mul(_s245, _c11)))), _s167));
    const S _s286 = singles_add(_s285, singles_mul(singles_abs(singles_mul(_c9, singles_neg(singles_mul(_s246, _c11)))), _s126));
    const S _s287 = singles_add(_s286, singles_mul(singles_abs(singles_mul(_c9, singles_sub(KS(1.0), singles_mul(_c11, _s243)))), _s181));
    const S _s288 = singles_add(_s287, singles_mul(singles_abs(singles_mul(_c9, singles_sub(_c0, singles_mul(_c11, _s248)))), _s176));
    const S _s289 = singles_mul(singles_abs(singles_neg(singles_mul(_c9, singles_neg(singles_mul(_s170, _c11))))), _s176);
    const S _s290 = singles_mul(singles_abs(singles_neg(singles_mul(_c9, singles_neg(singles_mul(_s178, _c11))))), _s181);
    const S _s291 = singles_mul(singles_abs(singles_neg(singles_mul(_c9, singles_neg(singles_mul(_s184, _c11))))), _s126);
    const S _s292 = singles_mul(singles_abs(singles_neg(singles_mul(_c9, singles_sub(KS(1.0), singles_mul(_c11, _s163))))), _s167);
    const S _s293 = singles_mul(singles_abs(singles_neg(singles_mul(_c9, singles_sub(_c8, singles_mul(_c11, _s187))))), _s191);
    const S _s294 = singles_add(singles_add(singles_add(singles_add(_s289, _s290), _s291), _s292), _s293);
    const S _s295 = singles_mul(_c9, singles_neg(singles_mul(_s249, _c11)));
    const S _s296 = singles_mul(_c9, singles_sub(_s200, singles_mul(_c11, _s253)));
    const S _s297 = singles_mul(_c9, singles_sub(_s196, singles_mul(_c11, _s251)));
    const S _s298 = singles_sub(singles_sub(singles_add(singles_mul(_s295, _s89), singles_mul(_c9, singles_sub(_s204, singles_mul(_c11, _s255)))), singles_mul(_s296, _s94)), singles_mul(_s297, _s112));
    const S _s299 = singles_add(singles_mul(place_n, singles_abs(singles_sub(singles_sub(singles_mul(_s295, _s86), singles_mul(_s296, _s88)), singles_mul(_s297, _s109)))), singles_mul(place_s, singles_abs(_s298)));
    const S _s300 = singles_sub(singles_sub(singles_add(singles_mul(_s295, _s95), singles_mul(_c9, singles_sub(_s210, singles_mul(_c11, _s258)))), singles_mul(_s296, _s98)), singles_mul(_s297, _s114));
    const S _s301 = singles_sub(singles_sub(singles_add(singles_mul(_s295, _s99), singles_mul(_c9, singles_sub(_s108, singles_mul(_c11, _s260)))), singles_mul(_s296, _s100)), singles_mul(_s297, _s115));
    const S _s302 = singles_sub(singles_sub(singles_add(singles_mul(_s295, _s101), singles_mul(_c9, singles_sub(_s219, singles_mul(_c11, _s262)))), singles_mul(_s296, _s102)), singles_mul(_s297, _s116));
    const S _s303 = singles_sub(singles_sub(singles_add(singles_mul(_s295, _s104), singles_mul(_c9, singles_sub(_s224, singles_mul(_c11, _s264)))), singles_mul(_s296, _s105)), singles_mul(_s297, _s118));
    const S _s304 = singles_add(singles_add(singles_add(singles_add(_s299, singles_mul(place_e, singles_abs(_s300))), singles_mul(pace_n, singles_abs(_s301))), singles_mul(pace_s, singles_abs(_s302))), singles_mul(pace_e, singles_abs(_s303)));
    const S _s305 = singles_add(_s304, singles_mul(turn_n, singles_abs(singles_mul(_c9, singles_sub(_s229, singles_mul(_c11, _s266))))));
    const S _s306 = singles_add(_s305, singles_mul(turn_z, singles_abs(singles_mul(_c9, singles_sub(_s233, singles_mul(_c11, _s267))))));
    const S _s307 = singles_add(_s306, singles_mul(turn_z, singles_abs(singles_mul(_c9, singles_sub(_s238, singles_mul(_c11, _s269))))));
    const S _s308 = singles_neg(singles_mul(_c9, singles_sub(_s20, singles_mul(_c11, _s193))));
    const S _s309 = singles_neg(singles_mul(_c9, singles_sub(_s164, singles_mul(_c11, _s202))));
    const S _s310 = singles_neg(singles_mul(_c9, singles_sub(_s195, singles_mul(_c11, _s198))));
    const S _s311 = singles_sub(singles_add(singles_mul(_s308, _s89), singles_neg(singles_mul(_c9, singles_sub(_s205, singles_mul(_c11, _s207))))), singles_mul(_s309, _s94));
    const S _s312 = singles_add(singles_mul(place_n, singles_abs(singles_sub(singles_sub(singles_mul(_s308, _s86), singles_mul(_s309, _s88)), singles_mul(_s310, _s109)))), singles_mul(place_s, singles_abs(singles_sub(_s311, singles_mul(_s310, _s112)))));
    const S _s313 = singles_sub(singles_add(singles_mul(_s308, _s95), singles_neg(singles_mul(_c9, singles_sub(_s211, singles_mul(_c11, _s213))))), singles_mul(_s309, _s98));
    const S _s314 = singles_sub(singles_add(singles_mul(_s308, _s99), singles_neg(singles_mul(_c9, singles_sub(_s87, singles_mul(_c11, _s216))))), singles_mul(_s309, _s100));
    const S _s315 = singles_add(singles_add(_s312, singles_mul(place_e, singles_abs(singles_sub(_s313, singles_mul(_s310, _s114))))), singles_mul(pace_n, singles_abs(singles_sub(_s314, singles_mul(_s310, _s115)))));
    const S _s316 = singles_sub(singles_add(singles_mul(_s308, _s101), singles_neg(singles_mul(_c9, singles_sub(_s218, singles_mul(_c11, _s221))))), singles_mul(_s309, _s102));
    const S _s317 = singles_sub(singles_add(singles_mul(_s308, _s104), singles_neg(singles_mul(_c9, singles_sub(_s223, singles_mul(_c11, _s226))))), singles_mul(_s309, _s105));
    const S _s318 = singles_add(singles_add(_s315, singles_mul(pace_s, singles_abs(singles_sub(_s316, singles_mul(_s310, _s116))))), singles_mul(pace_e, singles_abs(singles_sub(_s317, singles_mul(_s310, _s118)))));
    const S _s319 = singles_mul(turn_n, singles_abs(singles_neg(singles_mul(_c9, singles_sub(_s228, singles_mul(_c11, _s231))))));
    const S _s320 = singles_mul(turn_z, singles_abs(singles_neg(singles_mul(_c9, singles_sub(_s232, singles_mul(_c11, _s235))))));
    const S _s321 = singles_mul(turn_z, singles_abs(singles_neg(singles_mul(_c9, singles_sub(_s237, singles_mul(_c11, _s240))))));
    const S _s322 = singles_add(singles_add(singles_add(_s318, _s319), _s320), _s321);
    const S _s323 = singles_mul(KS(1.0009765625), singles_add(singles_add(singles_add(singles_mul(_c9, _s159), _s276), singles_max(_s288, _s294)), singles_max(_s307, _s322)));
    const S _s324 = singles_max(_s80, _s106);
    const S _s325 = singles_select(_s81, singles_mul(KS(1.0009765625), singles_add(singles_mul(KS(0.421875), singles_add(singles_add(_s80, _s119), _s106)), singles_mul(KS(0.578125), singles_max(_s324, _s119)))), KS(INFINITY));
    const S _s326 = singles_mul(_c5, _s106);
    const S _s327 = singles_mul(slip_share, singles_sub(_s19, singles_mul(_c0, _s174)));
    const S _s328 = singles_sub(_s19, _s327);
    const S _s329 = singles_mul(_s43, singles_div(p_ring_restitution, _s120));
    const S _s330 = singles_add(_s326, singles_mul(singles_abs(singles_mul(bend_e, singles_sub(singles_mul(nz, _s328), singles_mul(_s329, _s18)))), _s119));
    const S _s331 = singles_mul(KS(7.62939453125e-06), singles_add(singles_mul(bend_s, _s106), singles_mul(bend_e, _s119)));
    const S _s332 = singles_mul(_s134, _s331);
    const S _s333 = singles_add(singles_add(_s330, _s332), _s271);
    const S _s334 = singles_mul(slip_share, singles_add(singles_mul(_c0, _s188), _s15));
    const S _s335 = singles_sub(_s15, _s334);
    const S _s336 = singles_add(singles_add(singles_mul(singles_abs(singles_mul(bend_s, _s329)), _s106), singles_mul(singles_abs(singles_neg(singles_mul(_s165, _s335))), _s119)), _s332);
    const S _s337 = singles_add(_s336, _s242);
    const S _s338 = singles_add(singles_add(singles_mul(singles_abs(singles_neg(singles_mul(bend_s, _s328))), _s106), singles_mul(singles_abs(singles_mul(_s124, _s335)), _s119)), _s332);
    const S _s339 = singles_add(_s338, _s158);
    const S _s340 = singles_max(_s339, _s337);
    const S _s341 = singles_select(_s81, singles_mul(KS(1.0009765625), singles_add(singles_mul(KS(0.421875), singles_add(singles_add(_s333, _s337), _s339)), singles_mul(KS(0.578125), singles_max(_s340, _s333)))), KS(INFINITY));
    const S _s342 = singles_sub(_s188, singles_mul(_s334, _c10));
    const S _s343 = singles_add(singles_mul(_s327, _c10), _s174);
    const S _s344 = singles_mul(_s274, _s331);
    const S _s345 = singles_add(singles_add(singles_mul(singles_abs(singles_neg(singles_mul(bend_s, _s342))), _s106), singles_mul(singles_abs(singles_mul(_s124, _s343)), _s119)), _s344);
    const S _s346 = singles_add(_s345, _s284);
    const S _s347 = singles_add(singles_add(singles_add(singles_div(_s271, _c0), singles_mul(_s173, _s106)), singles_mul(singles_abs(singles_neg(singles_mul(_s165, _s343))), _s119)), _s344);
    const S _s348 = singles_add(_s347, _s323);
    const S _s349 = singles_add(singles_add(singles_div(_s242, _c0), _s326), singles_mul(singles_abs(singles_mul(bend_e, singles_sub(singles_mul(nz, _s342), _s189))), _s119));
    const S _s350 = singles_add(singles_add(_s349, _s344), _s323);
    const S _s351 = singles_max(_s346, _s348);
    const S _s352 = singles_select(_s81, singles_mul(KS(1.0009765625), singles_add(singles_mul(KS(0.421875), singles_add(singles_add(_s346, _s348), _s350)), singles_mul(KS(0.578125), singles_max(_s351, _s350)))), KS(INFINITY));
    return (LANES(court_bound_ring_impact_out)){ singles_select(_s81, _s80, KS(INFINITY)), singles_select(_s81, _s106, KS(INFINITY)), singles_select(_s81, _s119, KS(INFINITY)), singles_select(_s81, _s158, KS(INFINITY)), singles_select(_s81, _s242, KS(INFINITY)), singles_select(_s81, _s271, KS(INFINITY)), singles_select(_s81, _s284, KS(INFINITY)), singles_select(_s81, _s323, KS(INFINITY)), _s325, _s341, _s352, nx, ny, nz, tangent_x, tangent_y, bend_s, bend_e, singles_add(singles_mul(KS(4.440892098500626e-16), singles_add(t, clock)), singles_select(_s81, singles_mul(KS(1.0009765625), _s44), KS(INFINITY))) };
}

/* Velocity and spin after a contact, frame-free.
   momentum, angular momentum and Coulomb's law of friction. 79 operations: 8 additions, 19 subtractions, 40 multiplications, 4 divisions, 1 square root, 1 negation, 3 comparisons, 3 selections. */
typedef struct {
    V vx, vy, vz, wx, wy, wz;
} LANES(court_ring_impact_out);

LANES_INLINE LANES(court_ring_impact_out)
LANES(court_ring_impact)(V vx, V vy, V vz, V wx, V wy, V wz, V nx, V ny, V nz, V p_ring_restitution, V p_ring_friction, V _c0, V _c1, V _c2, V _c3, V _c4)
{
    const V _s0 = lanes_add(lanes_add(lanes_mul(nx, vx), lanes_mul(ny, vy)), lanes_mul(nz, vz));
    const V _s1 = lanes_sub(vx, lanes_mul(nx, _s0));
    const V _s2 = lanes_sub(_s1, lanes_mul(_c0, lanes_sub(lanes_mul(nz, wy), lanes_mul(ny, wz))));
    const V _s3 = lanes_sub(vz, lanes_mul(nz, _s0));
    const V _s4 = lanes_sub(_s3, lanes_mul(_c0, lanes_sub(lanes_mul(ny, wx), lanes_mul(nx, wy))));
    const V _s5 = lanes_sub(vy, lanes_mul(ny, _s0));
    const V _s6 = lanes_sub(_s5, lanes_mul(_c0, lanes_sub(lanes_mul(nx, wz), lanes_mul(nz, wx))));
    const V _s7 = lanes_add(lanes_add(lanes_mul(_s4, _s4), lanes_mul(_s6, _s6)), lanes_mul(_s2, _s2));
    const V _s8 = lanes_div(p_ring_restitution, lanes_sub(K(1.0), lanes_div(_s0, _c1)));
    const V _s9 = lanes_neg(lanes_mul(p_ring_friction, lanes_mul(lanes_add(K(1.0), _s8), _s0)));
    const V _s10 = lanes_select(lanes_less(K(0.0), p_ring_friction), lanes_select(lanes_less(p_ring_friction, K(INFINITY)), lanes_select(lanes_at_most(lanes_mul(_s7, _c3), lanes_mul(_s9, _s9)), _c2, lanes_div(_s9, lanes_sqrt(_s7))), _c2), K(0.0));
    const V _s11 = lanes_div(_s10, _c4);
    return (LANES(court_ring_impact_out)){ lanes_sub(lanes_sub(_s1, lanes_mul(_s2, _s10)), lanes_mul(lanes_mul(nx, _s8), _s0)), lanes_sub(lanes_sub(_s5, lanes_mul(_s6, _s10)), lanes_mul(lanes_mul(ny, _s8), _s0)), lanes_sub(lanes_sub(_s3, lanes_mul(_s4, _s10)), lanes_mul(lanes_mul(nz, _s8), _s0)), lanes_add(wx, lanes_mul(_s11, lanes_sub(lanes_mul(ny, _s4), lanes_mul(nz, _s6)))), lanes_add(wy, lanes_mul(_s11, lanes_sub(lanes_mul(nz, _s2), lanes_mul(nx, _s4)))), lanes_add(wz, lanes_mul(_s11, lanes_sub(lanes_mul(nx, _s6), lanes_mul(ny, _s2)))) };
}

/* Errors of velocity and spin after a contact, from those before it.
   derivative of the contact with friction, with roundings. 306 operations: 59 additions, 38 subtractions, 124 multiplications, 9 divisions, 1 square root, 13 negations, 18 absolute values, 19 comparisons, 25 selections. */
typedef struct {
    V dvx, dvy, dvz, dwx, dwy, dwz;
} LANES(court_carry_ring_impact_out);

LANES_INLINE LANES(court_carry_ring_impact_out)
LANES(court_carry_ring_impact)(V vx, V vy, V vz, V wx, V wy, V wz, V nx, V ny, V nz, V dvx, V dvy, V dvz, V dwx, V dwy, V dwz, V dnx, V dny, V dnz, V turn, V lifting, V p_ring_restitution, V p_ring_friction, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(lanes_add(lanes_add(lanes_mul(nx, dvx), lanes_mul(vx, dnx)), lanes_add(lanes_mul(ny, dvy), lanes_mul(vy, dny))), lanes_add(lanes_mul(nz, dvz), lanes_mul(vz, dnz)));
    const V _s1 = lanes_add(lanes_add(lanes_mul(nx, vx), lanes_mul(ny, vy)), lanes_mul(nz, vz));
    const V _s2 = lanes_sub(dvx, lanes_add(lanes_mul(nx, _s0), lanes_mul(dnx, _s1)));
    const V _s3 = lanes_sub(lanes_sub(vx, lanes_mul(nx, _s1)), lanes_mul(_c0, lanes_sub(lanes_mul(nz, wy), lanes_mul(ny, wz))));
    const V _s4 = lanes_sub(lanes_sub(vz, lanes_mul(nz, _s1)), lanes_mul(_c0, lanes_sub(lanes_mul(ny, wx), lanes_mul(nx, wy))));
    const V _s5 = lanes_sub(lanes_sub(vy, lanes_mul(ny, _s1)), lanes_mul(_c0, lanes_sub(lanes_mul(nx, wz), lanes_mul(nz, wx))));
    const V _s6 = lanes_add(lanes_add(lanes_mul(_s4, _s4), lanes_mul(_s5, _s5)), lanes_mul(_s3, _s3));
    const V _s7 = lanes_sub(K(1.0), lanes_div(_s1, _c1));
    const V _s8 = lanes_div(p_ring_restitution, _s7);
    const V _s9 = lanes_add(K(1.0), _s8);
    const V _s10 = lanes_neg(lanes_mul(p_ring_friction, lanes_mul(_s9, _s1)));
    const V _s11 = lanes_neg(lanes_div(lanes_mul(p_ring_restitution, lanes_neg(lanes_div(_s0, _c1))), lanes_mul(_s7, _s7)));
    const V _s12 = lanes_sqrt(_s6);
    const V _s13 = lanes_sub(dvz, lanes_add(lanes_mul(nz, _s0), lanes_mul(dnz, _s1)));
    const V _s14 = lanes_sub(_s13, lanes_mul(_c0, lanes_sub(lanes_add(lanes_mul(ny, dwx), lanes_mul(wx, dny)), lanes_add(lanes_mul(nx, dwy), lanes_mul(wy, dnx)))));
    const V _s15 = lanes_sub(dvy, lanes_add(lanes_mul(ny, _s0), lanes_mul(dny, _s1)));
    const V _s16 = lanes_sub(_s15, lanes_mul(_c0, lanes_sub(lanes_add(lanes_mul(nx, dwz), lanes_mul(wz, dnx)), lanes_add(lanes_mul(nz, dwx), lanes_mul(wx, dnz)))));
    const V _s17 = lanes_sub(_s2, lanes_mul(_c0, lanes_sub(lanes_add(lanes_mul(nz, dwy), lanes_mul(wy, dnz)), lanes_add(lanes_mul(ny, dwz), lanes_mul(wz, dny)))));
    const V _s18 = lanes_div(lanes_mul(lanes_mul(K(0.5), _s10), lanes_add(lanes_add(lanes_mul(lanes_mul(K(2.0), _s4), _s14), lanes_mul(lanes_mul(K(2.0), _s5), _s16)), lanes_mul(lanes_mul(K(2.0), _s3), _s17))), lanes_mul(_s12, _s6));
    const V _s19 = lanes_sub(lanes_div(lanes_neg(lanes_mul(p_ring_friction, lanes_add(lanes_mul(_s9, _s0), lanes_mul(_s11, _s1)))), _s12), _s18);
    const M _s20 = lanes_at_most(lanes_mul(_s6, _c3), lanes_mul(_s10, _s10));
    const M _s21 = lanes_less(p_ring_friction, K(INFINITY));
    const M _s22 = lanes_less(K(0.0), p_ring_friction);
    const V _s23 = lanes_select(_s22, lanes_select(_s21, lanes_select(_s20, K(0.0), _s19), K(0.0)), K(0.0));
    const V _s24 = lanes_select(_s22, lanes_select(_s21, lanes_select(_s20, _c2, lanes_div(_s10, _s12)), _c2), K(0.0));
    const V _s25 = lanes_sub(lanes_sub(_s2, lanes_add(lanes_mul(_s3, _s23), lanes_mul(_s17, _s24))), lanes_add(lanes_add(lanes_mul(lanes_mul(nx, _s8), _s0), lanes_mul(lanes_mul(nx, _s11), _s1)), lanes_mul(lanes_mul(dnx, _s8), _s1)));
    const V _s26 = lanes_add(lanes_add(lanes_mul(_c0, lanes_add(lanes_add(lanes_abs(wx), lanes_abs(wy)), lanes_abs(wz))), lanes_abs(vx)), lanes_abs(vy));
    const V _s27 = lanes_add(_s26, lanes_abs(vz));
    const V _s28 = lanes_add(K(7.888609052210118e-31), lanes_mul(K(2.220446049250313e-16), _s27));
    const V _s29 = lanes_add(lanes_abs(_s25), _s28);
    const V _s30 = lanes_abs(dwx);
    const V _s31 = lanes_abs(dwy);
    const V _s32 = lanes_max(_s30, _s31);
    const V _s33 = lanes_abs(dwz);
    const V _s34 = lanes_abs(dvx);
    const V _s35 = lanes_abs(dvy);
    const V _s36 = lanes_max(_s34, _s35);
    const V _s37 = lanes_abs(dvz);
    const V _s38 = lanes_mul(lifting, lanes_add(lanes_add(lanes_mul(_c0, lanes_max(_s32, _s33)), lanes_mul(turn, _s27)), lanes_max(_s36, _s37)));
    const V _s39 = lanes_max(_s29, _s38);
    const M _s40 = lanes_less(_s25, K(0.0));
    const V _s41 = lanes_sub(_s39, _s29);
    const V _s42 = lanes_sub(lanes_sub(_s15, lanes_add(lanes_mul(_s5, _s23), lanes_mul(_s16, _s24))), lanes_add(lanes_add(lanes_mul(lanes_mul(ny, _s8), _s0), lanes_mul(lanes_mul(ny, _s11), _s1)), lanes_mul(lanes_mul(dny, _s8), _s1)));
    const V _s43 = lanes_add(lanes_abs(_s42), _s28);
    const V _s44 = lanes_max(_s43, _s38);
    const V _s45 = lanes_sub(_s44, _s43);
    const M _s46 = lanes_less(_s42, K(0.0));
    const V _s47 = lanes_sub(lanes_sub(_s13, lanes_add(lanes_mul(_s4, _s23), lanes_mul(_s14, _s24))), lanes_add(lanes_add(lanes_mul(lanes_mul(nz, _s8), _s0), lanes_mul(lanes_mul(nz, _s11), _s1)), lanes_mul(lanes_mul(dnz, _s8), _s1)));
    const V _s48 = lanes_add(lanes_abs(_s47), _s28);
    const V _s49 = lanes_max(_s48, _s38);
    const V _s50 = lanes_sub(_s49, _s48);
    const M _s51 = lanes_less(_s47, K(0.0));
    const V _s52 = lanes_add(lanes_add(lanes_mul(nx, lanes_select(_s40, lanes_neg(_s41), _s41)), lanes_mul(ny, lanes_select(_s46, lanes_neg(_s45), _s45))), lanes_mul(nz, lanes_select(_s51, lanes_neg(_s50), _s50)));
    const V _s53 = lanes_div(_s23, _c4);
    const V _s54 = lanes_div(_s24, _c4);
    const V _s55 = lanes_add(dwx, lanes_add(lanes_mul(_s53, lanes_sub(lanes_mul(ny, _s4), lanes_mul(nz, _s5))), lanes_mul(_s54, lanes_sub(lanes_add(lanes_mul(ny, _s14), lanes_mul(dny, _s4)), lanes_add(lanes_mul(nz, _s16), lanes_mul(dnz, _s5))))));
    const V _s56 = lanes_mul(_c5, _s28);
    const V _s57 = lanes_add(lanes_abs(_s55), _s56);
    const V _s58 = lanes_mul(_c5, _s38);
    const V _s59 = lanes_max(_s57, _s58);
    const V _s60 = lanes_add(dwy, lanes_add(lanes_mul(_s53, lanes_sub(lanes_mul(nz, _s3), lanes_mul(nx, _s4))), lanes_mul(_s54, lanes_sub(lanes_add(lanes_mul(nz, _s17), lanes_mul(dnz, _s3)), lanes_add(lanes_mul(nx, _s14), lanes_mul(dnx, _s4))))));
    const V _s61 = lanes_add(lanes_abs(_s60), _s56);
    const V _s62 = lanes_max(_s61, _s58);
    const V _s63 = lanes_add(dwz, lanes_add(lanes_mul(_s53, lanes_sub(lanes_mul(nx, _s5), lanes_mul(ny, _s3))), lanes_mul(_s54, lanes_sub(lanes_add(lanes_mul(nx, _s16), lanes_mul(dnx, _s5)), lanes_add(lanes_mul(ny, _s17), lanes_mul(dny, _s3))))));
    const V _s64 = lanes_add(lanes_abs(_s63), _s56);
    const V _s65 = lanes_max(_s64, _s58);
    return (LANES(court_carry_ring_impact_out)){ lanes_sub(lanes_select(_s40, lanes_neg(_s39), _s39), lanes_mul(nx, _s52)), lanes_sub(lanes_select(_s46, lanes_neg(_s44), _s44), lanes_mul(ny, _s52)), lanes_sub(lanes_select(_s51, lanes_neg(_s49), _s49), lanes_mul(nz, _s52)), lanes_select(lanes_less(_s55, K(0.0)), lanes_neg(_s59), _s59), lanes_select(lanes_less(_s60, K(0.0)), lanes_neg(_s62), _s62), lanes_select(lanes_less(_s63, K(0.0)), lanes_neg(_s65), _s65) };
}

/* Outward unit normal n3 at a contact.
   Table 2. 11 operations: 1 addition, 1 subtraction, 7 multiplications, 1 division, 1 square root. */
typedef struct {
    V nx, ny, nz;
} LANES(court_ring_normal_out);

LANES_INLINE LANES(court_ring_normal_out)
LANES(court_ring_normal)(V x, V y, V z, V _c0, V _c1)
{
    const V _s0 = lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y)));
    const V _s1 = lanes_mul(lanes_mul(_c1, lanes_sub(_s0, _c0)), lanes_div(K(1.0), _s0));
    return (LANES(court_ring_normal_out)){ lanes_mul(x, _s1), lanes_mul(y, _s1), lanes_mul(z, _c1) };
}

/* Bound on the rate at which the normal turns along the contact surface.
   Table 2. No operations. */
typedef struct {
    V curvature;
} LANES(court_ring_curvature_out);

LANES_INLINE LANES(court_ring_curvature_out)
LANES(court_ring_curvature)(V _c0)
{
    return (LANES(court_ring_curvature_out)){ _c0 };
}

/* Tangent and curvatures at a contact, and bounds on the roundings there.
   Table 2, running error analysis. 105 operations: 34 additions, 38 multiplications, 4 divisions, 1 square root, 1 negation, 11 absolute values, 7 comparisons, 9 selections. */
typedef struct {
    S tangent_x, tangent_y, bend_s, bend_e, sharpest_bend, root_offset, root_level, normal_rounding;
} LANES(court_ring_tangents_out);

LANES_INLINE LANES(court_ring_tangents_out)
LANES(court_ring_tangents)(S t, S x, S y, S z, S vx, S vy, S vz, S nx, S ny, S nz, S place_n, S normal_velocity, S back, S _c0, S _c1, S _c2, S _c3, S _c4, S _c5, S _c6, S _c7, S _c8, S _c9)
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
    return (LANES(court_ring_tangents_out)){ singles_neg(singles_mul(y, _s1)), singles_mul(x, _s1), _c2, _s1, _c4, singles_select(_s25, singles_select(_s24, _s19, singles_max(_s19, _s23)), _s22), singles_select(_s25, singles_select(_s24, _s26, singles_max(_s26, _s22)), _s22), _c9 };
}

/* Error of the normal, from that of the position.
   derivative of Table 2's normal. 27 operations: 5 additions, 1 subtraction, 18 multiplications, 1 division, 1 square root, 1 negation. */
typedef struct {
    V dnx, dny, dnz, turn;
} LANES(court_ring_carry_normal_out);

LANES_INLINE LANES(court_ring_carry_normal_out)
LANES(court_ring_carry_normal)(V x, V y, V dx, V dy, V dz, V shift, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y)));
    const V _s1 = lanes_div(K(1.0), _s0);
    const V _s2 = lanes_mul(lanes_add(lanes_mul(x, dx), lanes_mul(y, dy)), _s1);
    const V _s3 = lanes_sub(_s0, _c0);
    const V _s4 = lanes_mul(_c1, lanes_add(lanes_mul(_s2, _s1), lanes_mul(lanes_neg(lanes_mul(_s2, lanes_mul(_s1, _s1))), _s3)));
    const V _s5 = lanes_mul(lanes_mul(_c1, _s3), _s1);
    return (LANES(court_ring_carry_normal_out)){ lanes_add(lanes_mul(x, _s4), lanes_mul(dx, _s5)), lanes_add(lanes_mul(y, _s4), lanes_mul(dy, _s5)), lanes_mul(dz, _c1), lanes_mul(shift, _c2) };
}

/* Positive if errors of the state exceed those that a search allows for.
   running error analysis. 17 operations: 5 additions, 2 subtractions, 8 multiplications, 1 comparison, 1 selection. */
typedef struct {
    V excess;
} LANES(court_ring_excess_out);

LANES_INLINE LANES(court_ring_excess_out)
LANES(court_ring_excess)(V share, V horizon, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_add(speed, lanes_mul(_c0, horizon));
    const V _s1 = lanes_mul(horizon, _s0);
    const V _s2 = lanes_sub(lanes_add(position_error, lanes_mul(horizon, velocity_error)), lanes_mul(share, lanes_add(_s1, lanes_add(extent, _s1))));
    const V _s3 = lanes_add(lanes_mul(lanes_mul(_s0, _c2), _s2), lanes_mul(_c1, lanes_sub(velocity_error, lanes_mul(share, _s0))));
    return (LANES(court_ring_excess_out)){ lanes_max(_s2, _s3) };
}

/* Positive if there is certainly no contact before the horizon.
   bounds of the event condition. 119 operations: 24 additions, 16 subtractions, 49 multiplications, 2 square roots, 14 comparisons, 14 selections. */
typedef struct {
    V clear;
} LANES(court_ring_clear_out);

LANES_INLINE LANES(court_ring_clear_out)
LANES(court_ring_clear)(V horizon, V x, V y, V z, V vx, V vy, V vz, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7, V _c8, V _c9, V _c10, V _c11, V _c12, V _c13, V _c14, V _c15, V _c16, V _c17, V _c18, V _c19)
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
    return (LANES(court_ring_clear_out)){ lanes_select(lanes_less(K(0.0), lanes_max(_c2, _s1)), K(0.0), lanes_select(lanes_less(_s0, _c6), _s27, K(0.0))) };
}

/* Constants and windows of the search along a flight, and its error budget.
   bounds of the event condition. 163 operations: 28 additions, 17 subtractions, 38 multiplications, 1 division, 6 square roots, 1 negation, 5 absolute values, 30 comparisons, 37 selections. */
typedef struct {
    V energy2, moment2, rho_start, low0, high0, low1, high1, low2, high2, ceiling, latest, budget_exceeded;
} LANES(court_ring_prepare_out);

LANES_INLINE LANES(court_ring_prepare_out)
LANES(court_ring_prepare)(V horizon, V x, V y, V z, V vx, V vy, V vz, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7, V _c8, V _c9, V _c10, V _c11, V _c12, V _c13)
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
    return (LANES(court_ring_prepare_out)){ _s2, _s5, lanes_sqrt(_s6), lanes_max(K(0.0), _s22), lanes_min(_s33, horizon), lanes_max(K(0.0), _s41), lanes_min(_s42, horizon), lanes_max(K(0.0), _s43), lanes_min(_s44, horizon), lanes_add(lanes_add(_c7, lanes_mul(_s5, _c8)), lanes_abs(_s2)), lanes_min(_s47, horizon), lanes_max(_c9, _s49) };
}

/* Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.
   running error analysis. 34 operations: 12 additions, 22 multiplications. */
typedef struct {
    V margin, leaving_margin, rate_margin;
} LANES(court_ring_margins_out);

LANES_INLINE LANES(court_ring_margins_out)
LANES(court_ring_margins)(V horizon, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(speed, lanes_mul(_c0, horizon));
    const V _s1 = lanes_mul(_c1, _s0);
    const V _s2 = lanes_add(extent, lanes_mul(horizon, _s0));
    const V _s3 = lanes_add(lanes_add(position_error, lanes_mul(horizon, velocity_error)), lanes_mul(K(4.440892098500626e-16), _s2));
    const V _s4 = lanes_mul(K(5.0), lanes_add(lanes_mul(lanes_mul(_s0, _c5), _s3), lanes_mul(_c1, lanes_add(velocity_error, lanes_mul(K(2.220446049250313e-16), _s0)))));
    const V _s5 = lanes_mul(K(1.0009765625), lanes_add(lanes_add(lanes_mul(lanes_mul(K(3.552713678800501e-15), _s0), lanes_add(lanes_mul(_s2, _c5), _c2)), lanes_mul(K(4.440892098500626e-16), _s1)), _s4));
    return (LANES(court_ring_margins_out)){ lanes_mul(K(1.0009765625), lanes_add(lanes_add(lanes_mul(lanes_mul(K(4.440892098500626e-16), horizon), _s1), _c3), lanes_mul(_c4, _s3))), _s5, lanes_mul(K(1.0009765625), lanes_add(lanes_mul(K(3.552713678800501e-15), lanes_mul(_c2, _s0)), _s4)) };
}

/* Newton's next value of a root near t, and gap and rate there.
   Newton's method. 53 operations: 14 additions, 6 subtractions, 28 multiplications, 2 divisions, 1 square root, 1 comparison, 1 selection. */
typedef struct {
    V time, gap, rate;
} LANES(court_ring_refine_out);

LANES_INLINE LANES(court_ring_refine_out)
LANES(court_ring_refine)(V t, V leaving, V x, V y, V z, V vx, V vy, V vz, V rho_start, V _c0, V _c1, V _c2, V _c3)
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
    return (LANES(court_ring_refine_out)){ lanes_sub(t, lanes_div(_s10, _s8)), _s10, _s8 };
}

/* Gap, rate, second derivative, a step without a root, its end, and the clearance.
   Newton from the left under a curvature bound. 132 operations: 27 additions, 15 subtractions, 47 multiplications, 4 divisions, 2 square roots, 2 negations, 2 absolute values, 15 comparisons, 18 selections. */
typedef struct {
    V gap, rate, bend, step, next, clearance;
} LANES(court_ring_advance_out);

LANES_INLINE LANES(court_ring_advance_out)
LANES(court_ring_advance)(V t, V end, V leaving, V margin, V rate_margin, V ceiling, V x, V y, V z, V vx, V vy, V vz, V energy2, V moment2, V rho_start, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7)
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
    return (LANES(court_ring_advance_out)){ _s9, _s13, lanes_sub(lanes_sub(energy2, _s14), _s15), _s34, lanes_add(t, _s34), lanes_select(lanes_less(K(0.0), _s35), lanes_sub(lanes_mul(_s35, _s35), lanes_mul(lanes_mul(K(8.0), ceiling), lanes_add(margin, _s21))), _s35) };
}

/* Windows of the search along a flight, and whether single precision serves for it.
   bounds of the event condition. 171 operations: 21 additions, 15 subtractions, 29 multiplications, 1 division, 4 square roots, 1 negation, 4 absolute values, 42 comparisons, 7 conjunctions, 3 disjunctions, 44 selections. */
typedef struct {
    S t, end;
    M searching;
    S low1, high1, low2, high2, latest;
    M representable;
} LANES(court_ring_opened_out);

LANES_INLINE LANES(court_ring_opened_out)
LANES(court_ring_opened)(S horizon, S x, S y, S z, S vx, S vy, S vz, S extent, S speed, S _c0, S _c1, S _c2, S _c3, S _c4, S _c5, S _c6, S _c7, S _c8, S _c9)
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
    return (LANES(court_ring_opened_out)){ singles_select(_s35, _s21, singles_select(_s48, _s45, singles_select(_s54, _s51, KS(0.0)))), singles_select(_s35, _s34, singles_select(_s48, _s47, singles_select(_s54, _s53, KS(0.0)))), singles_truth(singles_either(singles_either(singles_either(singles_mask_none(), _s54), _s48), _s35)), _s44, _s47, _s50, _s53, singles_min(_s57, _s33), singles_truth(singles_both(singles_both(_s58, singles_at_most(extent, KS(4096.0))), singles_at_most(speed, KS(4096.0)))) };
}

/* Constants, margins and windows of the search in single precision, from its begin.
   running error analysis. 85 operations: 18 additions, 7 subtractions, 42 multiplications, 2 divisions, 1 square root, 5 absolute values, 5 comparisons, 1 conjunction, 4 selections. */
typedef struct {
    S share, t, end, x, y, z, vx, vy, vz, energy2, moment2, rho_start, ceiling, flat, tilt, jerk, quotient_margin, start_rate, rho_rate, rate_margin, low1, high1, low2, high2;
    M fits;
} LANES(court_ring_resolution_out);

LANES_INLINE LANES(court_ring_resolution_out)
LANES(court_ring_resolution)(S t, S end, S leaving, S horizon, S x, S y, S z, S vx, S vy, S vz, S extent, S speed, S start_rate, S rho_rate, S low1, S high1, S low2, S high2, S _c0, S _c1, S _c2, S _c3, S _c4, S _c5, S _c6, S _c7, S _c8, S _c9, S _c10, S _c11)
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
    return (LANES(court_ring_resolution_out)){ _s7, KS(0.0), singles_sub(end, t), x, y, z, vx, vy, vz, _s8, _s10, singles_sqrt(singles_add(singles_mul(x, x), singles_mul(y, y))), singles_mul(KS(1.0009765625), _s11), singles_mul(_c9, _s14), singles_select(_s0, singles_mul(KS(1.0009765625), singles_add(singles_mul(KS(4.76837158203125e-07), singles_abs(start_rate)), singles_mul(singles_add(KS(5.684341886080802e-14), _s7), _s4))), KS(INFINITY)), singles_mul(KS(1.0009765625), singles_add(singles_mul(_c0, singles_add(singles_mul(_c0, _s12), singles_abs(vz))), _s15)), singles_mul(_c10, _s11), start_rate, rho_rate, singles_mul(KS(5.0), singles_add(singles_mul(singles_mul(KS(1.0009765625), _s2), _s14), singles_mul(singles_mul(singles_add(KS(2.384185791015625e-07), _s7), _c1), _s1))), singles_sub(low1, t), singles_sub(high1, t), singles_sub(low2, t), singles_sub(high2, t), singles_truth(singles_both(singles_at_most(_s13, _c11), singles_at_most(singles_mul(t, leaving), KS(0.0)))) };
}

/* Time and window of the search after a step, whether a root is certain, and whether it goes on.
   Newton from the left under a curvature bound. 220 operations: 38 additions, 19 subtractions, 72 multiplications, 4 divisions, 2 square roots, 3 negations, 5 absolute values, 29 comparisons, 6 conjunctions, 5 disjunctions, 4 complements, 33 selections. */
typedef struct {
    S t, end;
    M certain, stepping;
} LANES(court_ring_step_out);

LANES_INLINE LANES(court_ring_step_out)
LANES(court_ring_step)(S t, S end, S rate_margin, S ceiling, S x, S y, S z, S vx, S vy, S vz, S energy2, S moment2, S rho_start, S flat, S tilt, S quotient_margin, S jerk, S start_rate, S rho_rate, S low1, S high1, S low2, S high2, S _c0, S _c1, S _c2, S _c3, S _c4, S _c5, S _c6, S _c7, S _c8, S _c9)
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
    return (LANES(court_ring_step_out)){ singles_select(_s58, singles_select(_s60, _s59, singles_select(_s62, _s61, KS(INFINITY))), singles_select(_s56, t, _s55)), singles_select(_s58, singles_select(_s60, high1, singles_select(_s62, high2, end)), end), singles_truth(_s50), singles_truth(singles_both(_s57, singles_either(singles_not(_s58), singles_either(singles_either(singles_mask_none(), _s62), _s60)))) };
}

/* Distance from the axis, its rate and that of the gap, at the start of a flight.
   Table 2. 13 operations: 3 additions, 1 subtraction, 7 multiplications, 1 division, 1 square root. */
typedef struct {
    V rho_start, start_rate, rho_rate;
} LANES(court_ring_started_out);

LANES_INLINE LANES(court_ring_started_out)
LANES(court_ring_started)(V x, V y, V z, V vx, V vy, V vz, V _c0)
{
    const V _s0 = lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y)));
    const V _s1 = lanes_div(lanes_add(lanes_mul(x, vx), lanes_mul(y, vy)), _s0);
    return (LANES(court_ring_started_out)){ _s0, lanes_mul(K(2.0), lanes_add(lanes_mul(z, vz), lanes_mul(_s1, lanes_sub(_s0, _c0)))), _s1 };
}

/* Positive if errors of the state exceed those that a search allows for.
   running error analysis. 23 operations: 5 additions, 4 subtractions, 10 multiplications, 2 comparisons, 2 selections. */
typedef struct {
    V excess;
} LANES(court_ring_coarse_excess_out);

LANES_INLINE LANES(court_ring_coarse_excess_out)
LANES(court_ring_coarse_excess)(V share, V horizon, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1, V _c2, V _c3)
{
    const V _s0 = lanes_add(speed, lanes_mul(_c0, horizon));
    const V _s1 = lanes_mul(share, lanes_add(extent, lanes_mul(horizon, _s0)));
    const V _s2 = lanes_sub(lanes_sub(lanes_add(position_error, lanes_mul(horizon, velocity_error)), _s1), _c2);
    const V _s3 = lanes_sub(lanes_add(position_error, lanes_mul(lanes_mul(K(0.5), horizon), velocity_error)), _s1);
    const V _s4 = lanes_add(lanes_mul(lanes_mul(_s0, _c3), lanes_max(_s3, _s2)), lanes_mul(_c1, lanes_sub(velocity_error, lanes_mul(share, _s0))));
    return (LANES(court_ring_coarse_excess_out)){ lanes_max(_s2, _s4) };
}

/* Positive if the bounds of the search do not hold.
   bounds of the event condition. 15 operations: 3 additions, 2 subtractions, 5 multiplications, 1 square root, 2 comparisons, 2 selections. */
typedef struct {
    V budget_exceeded;
} LANES(court_ring_budget_exceeded_out);

LANES_INLINE LANES(court_ring_budget_exceeded_out)
LANES(court_ring_budget_exceeded)(V horizon, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(lanes_mul(_c1, lanes_sqrt(lanes_mul(_c2, lanes_add(_c3, extent)))), lanes_mul(lanes_mul(K(2.0), speed), _c2));
    const V _s1 = lanes_sub(lanes_sub(lanes_add(position_error, lanes_mul(velocity_error, lanes_min(_s0, horizon))), _c4), _c5);
    return (LANES(court_ring_budget_exceeded_out)){ lanes_max(_c0, _s1) };
}

/* Distance, its rate, and a bound on how fast it bends down, by the squared speed.
   Table 2. 31 operations: 4 additions, 5 subtractions, 14 multiplications, 4 divisions, 2 square roots, 1 comparison, 1 selection. */
typedef struct {
    V gap, nearing, gap_curvature;
} LANES(court_ring_beside_out);

LANES_INLINE LANES(court_ring_beside_out)
LANES(court_ring_beside)(V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1, V _c2, V _c3, V _c4)
{
    const V _s0 = lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y)));
    const V _s1 = lanes_sub(_s0, _c1);
    const V _s2 = lanes_sqrt(lanes_add(lanes_mul(z, z), lanes_mul(_s1, _s1)));
    const V _s3 = lanes_add(lanes_mul(lanes_mul(K(2.0), z), vz), lanes_div(lanes_mul(lanes_mul(K(0.5), lanes_sub(lanes_mul(K(2.0), _s0), _c3)), lanes_add(lanes_mul(lanes_mul(K(2.0), x), vx), lanes_mul(lanes_mul(K(2.0), y), vy))), _s0));
    const V _s4 = lanes_sub(lanes_div(_c3, _s0), K(1.0));
    return (LANES(court_ring_beside_out)){ lanes_sub(lanes_sub(_s2, _c0), _c2), lanes_div(lanes_mul(K(0.5), _s3), _s2), lanes_div(lanes_max(K(0.0), _s4), _c4) };
}

/* Distance of a ball that rolls on another surface, and its first two derivatives.
   derivatives of Table 2's distance. 70 operations: 14 additions, 3 subtractions, 47 multiplications, 2 divisions, 2 square roots, 2 negations. */
typedef struct {
    V gap, nearing, rolling_gap_acceleration, normal_cosine;
} LANES(court_ring_closing_out);

LANES_INLINE LANES(court_ring_closing_out)
LANES(court_ring_closing)(V x, V y, V z, V nx, V ny, V nz, V rolled_x, V rolled_y, V rolled_z, V rolling_acceleration_x, V rolling_acceleration_y, V rolling_acceleration_z, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y)));
    const V _s1 = lanes_sub(_s0, _c1);
    const V _s2 = lanes_sqrt(lanes_add(lanes_mul(z, z), lanes_mul(_s1, _s1)));
    const V _s3 = lanes_mul(K(2.0), z);
    const V _s4 = lanes_mul(K(2.0), x);
    const V _s5 = lanes_mul(K(2.0), y);
    const V _s6 = lanes_add(lanes_mul(_s4, rolled_x), lanes_mul(_s5, rolled_y));
    const V _s7 = lanes_div(K(1.0), _s0);
    const V _s8 = lanes_mul(lanes_mul(K(0.5), _s6), _s7);
    const V _s9 = lanes_add(lanes_mul(_s3, rolled_z), lanes_mul(lanes_mul(K(2.0), _s8), _s1));
    const V _s10 = lanes_div(K(1.0), _s2);
    const V _s11 = lanes_mul(lanes_mul(K(0.5), _s9), _s10);
    const V _s12 = lanes_add(lanes_mul(lanes_neg(lanes_mul(_s8, lanes_mul(_s7, _s7))), _s6), lanes_mul(lanes_add(lanes_mul(K(2.0), lanes_add(lanes_mul(rolled_x, rolled_x), lanes_mul(x, rolling_acceleration_x))), lanes_mul(K(2.0), lanes_add(lanes_mul(rolled_y, rolled_y), lanes_mul(y, rolling_acceleration_y)))), _s7));
    const V _s13 = lanes_mul(lanes_add(lanes_mul(K(2.0), lanes_add(lanes_mul(rolled_z, rolled_z), lanes_mul(z, rolling_acceleration_z))), lanes_mul(K(2.0), lanes_add(lanes_mul(_s1, lanes_mul(K(0.5), _s12)), lanes_mul(_s8, _s8)))), _s10);
    const V _s14 = lanes_mul(K(0.5), lanes_add(lanes_mul(lanes_neg(lanes_mul(_s11, lanes_mul(_s10, _s10))), _s9), _s13));
    const V _s15 = lanes_mul(lanes_mul(K(2.0), lanes_mul(lanes_mul(K(0.5), lanes_add(lanes_mul(_s4, nx), lanes_mul(_s5, ny))), _s7)), _s1);
    return (LANES(court_ring_closing_out)){ lanes_sub(lanes_sub(_s2, _c0), _c2), _s11, _s14, lanes_mul(lanes_mul(K(0.5), lanes_add(lanes_mul(_s3, nz), _s15)), _s10) };
}

/* Distance from the surface.
   Table 2. 11 operations: 2 additions, 3 subtractions, 4 multiplications, 2 square roots. */
typedef struct {
    V gap;
} LANES(court_ring_distance_out);

LANES_INLINE LANES(court_ring_distance_out)
LANES(court_ring_distance)(V x, V y, V z, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_sub(lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y))), _c1);
    return (LANES(court_ring_distance_out)){ lanes_sub(lanes_sub(lanes_sqrt(lanes_add(lanes_mul(z, z), lanes_mul(_s0, _s0))), _c0), _c2) };
}

/* Curvature of the surface that the centre of a rolling ball stays on.
   Table 2. No operations. */
typedef struct {
    V bent_x, bent_y, bent_z, per_reach;
} LANES(court_ring_rolling_surface_out);

LANES_INLINE LANES(court_ring_rolling_surface_out)
LANES(court_ring_rolling_surface)(V _c0)
{
    return (LANES(court_ring_rolling_surface_out)){ K(1.0), K(1.0), K(1.0), _c0 };
}

/* Rate of the normal.
   derivative of Table 2's normal. 26 operations: 5 additions, 1 subtraction, 17 multiplications, 1 division, 1 square root, 1 negation. */
typedef struct {
    V turning_x, turning_y, turning_z;
} LANES(court_ring_turning_out);

LANES_INLINE LANES(court_ring_turning_out)
LANES(court_ring_turning)(V x, V y, V rolled_x, V rolled_y, V rolled_z, V _c0, V _c1)
{
    const V _s0 = lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y)));
    const V _s1 = lanes_div(K(1.0), _s0);
    const V _s2 = lanes_mul(lanes_add(lanes_mul(x, rolled_x), lanes_mul(y, rolled_y)), _s1);
    const V _s3 = lanes_sub(_s0, _c0);
    const V _s4 = lanes_mul(_c1, lanes_add(lanes_mul(_s2, _s1), lanes_mul(lanes_neg(lanes_mul(_s2, lanes_mul(_s1, _s1))), _s3)));
    const V _s5 = lanes_mul(lanes_mul(_c1, _s3), _s1);
    return (LANES(court_ring_turning_out)){ lanes_add(lanes_mul(x, _s4), lanes_mul(rolled_x, _s5)), lanes_add(lanes_mul(y, _s4), lanes_mul(rolled_y, _s5)), lanes_mul(rolled_z, _c1) };
}

/* Second to fourth derivative of the distance along a flight.
   derivatives of Table 2's distance. 144 operations: 41 additions, 2 subtractions, 90 multiplications, 2 divisions, 2 square roots, 7 negations. */
typedef struct {
    V lift, gap_jerk, gap_snap;
} LANES(court_ring_separation_out);

LANES_INLINE LANES(court_ring_separation_out)
LANES(court_ring_separation)(V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1, V _c2, V _c3)
{
    const V _s0 = lanes_add(lanes_mul(lanes_mul(K(2.0), x), vx), lanes_mul(lanes_mul(K(2.0), y), vy));
    const V _s1 = lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y)));
    const V _s2 = lanes_div(K(1.0), _s1);
    const V _s3 = lanes_mul(lanes_mul(K(0.5), _s0), _s2);
    const V _s4 = lanes_sub(_s1, _c1);
    const V _s5 = lanes_mul(K(2.0), _s3);
    const V _s6 = lanes_add(lanes_mul(lanes_mul(K(2.0), z), vz), lanes_mul(_s5, _s4));
    const V _s7 = lanes_div(K(1.0), lanes_sqrt(lanes_add(lanes_mul(z, z), lanes_mul(_s4, _s4))));
    const V _s8 = lanes_mul(lanes_mul(K(0.5), _s6), _s7);
    const V _s9 = lanes_mul(_s7, _s7);
    const V _s10 = lanes_neg(lanes_mul(_s8, _s9));
    const V _s11 = lanes_mul(_s2, _s2);
    const V _s12 = lanes_neg(lanes_mul(_s3, _s11));
    const V _s13 = lanes_add(lanes_mul(K(2.0), lanes_mul(vx, vx)), lanes_mul(K(2.0), lanes_mul(vy, vy)));
    const V _s14 = lanes_mul(K(0.5), lanes_add(lanes_mul(_s12, _s0), lanes_mul(_s13, _s2)));
    const V _s15 = lanes_add(lanes_mul(K(2.0), lanes_sub(lanes_mul(vz, vz), lanes_mul(_c0, z))), lanes_mul(K(2.0), lanes_add(lanes_mul(_s4, _s14), lanes_mul(_s3, _s3))));
    const V _s16 = lanes_mul(K(0.5), lanes_add(lanes_mul(_s10, _s6), lanes_mul(_s15, _s7)));
    const V _s17 = lanes_mul(_s10, _s15);
    const V _s18 = lanes_mul(K(2.0), _s10);
    const V _s19 = lanes_neg(lanes_add(lanes_mul(_s16, _s9), lanes_mul(lanes_mul(_s18, _s8), _s7)));
    const V _s20 = lanes_mul(_s12, _s13);
    const V _s21 = lanes_mul(K(2.0), _s12);
    const V _s22 = lanes_neg(lanes_add(lanes_mul(_s14, _s11), lanes_mul(lanes_mul(_s21, _s3), _s2)));
    const V _s23 = lanes_mul(K(0.5), lanes_add(_s20, lanes_add(_s20, lanes_mul(_s0, _s22))));
    const V _s24 = lanes_add(lanes_mul(K(2.0), lanes_neg(lanes_mul(_c2, vz))), lanes_mul(K(2.0), lanes_add(lanes_mul(_s5, _s14), lanes_add(lanes_mul(_s3, _s14), lanes_mul(_s4, _s23)))));
    const V _s25 = lanes_mul(K(0.5), lanes_add(lanes_add(_s17, lanes_mul(_s6, _s19)), lanes_add(_s17, lanes_mul(_s24, _s7))));
    const V _s26 = lanes_mul(_s10, _s24);
    const V _s27 = lanes_mul(_s3, _s23);
    const V _s28 = lanes_add(_s27, lanes_mul(_s14, _s14));
    const V _s29 = lanes_mul(_s13, _s22);
    const V _s30 = lanes_add(lanes_add(lanes_mul(_s23, _s11), lanes_mul(lanes_mul(_s21, _s14), _s2)), lanes_mul(K(2.0), lanes_add(lanes_add(lanes_mul(lanes_mul(_s12, _s12), _s3), lanes_mul(lanes_mul(_s12, _s14), _s2)), lanes_mul(lanes_mul(_s3, _s22), _s2))));
    const V _s31 = lanes_mul(K(0.5), lanes_add(_s29, lanes_add(_s29, lanes_add(lanes_mul(_s0, lanes_neg(_s30)), _s29))));
    const V _s32 = lanes_add(_c3, lanes_mul(K(2.0), lanes_add(lanes_mul(K(2.0), _s28), lanes_add(lanes_add(_s27, lanes_mul(_s4, _s31)), _s28))));
    const V _s33 = lanes_mul(_s15, _s19);
    const V _s34 = lanes_add(_s26, _s33);
    const V _s35 = lanes_add(lanes_add(lanes_mul(_s25, _s9), lanes_mul(lanes_mul(_s18, _s16), _s7)), lanes_mul(K(2.0), lanes_add(lanes_add(lanes_mul(lanes_mul(_s10, _s10), _s8), lanes_mul(lanes_mul(_s10, _s16), _s7)), lanes_mul(lanes_mul(_s8, _s19), _s7))));
    const V _s36 = lanes_mul(K(0.5), lanes_add(lanes_add(lanes_add(_s26, lanes_mul(_s32, _s7)), _s34), lanes_add(_s34, lanes_add(lanes_mul(_s6, lanes_neg(_s35)), _s33))));
    return (LANES(court_ring_separation_out)){ _s16, _s25, _s36 };
}

/* Constant terms, in the ring's coordinates.
   Routh's equations. 39 operations: 6 additions, 4 subtractions, 24 multiplications, 3 divisions, 2 square roots. */
typedef struct {
    V cosine_0, sine_0, climb_0, along_0, turn_rate_0, cos_0, sin_0, tilted_0, near_0;
} LANES(court_ring_round_start_out);

LANES_INLINE LANES(court_ring_round_start_out)
LANES(court_ring_round_start)(V x, V y, V z, V vx, V vy, V vz, V wx, V wy, V wz, V per_reach, V _c0, V _c1, V _c2, V _c3)
{
    const V _s0 = lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y)));
    const V _s1 = lanes_sub(_s0, _c1);
    const V _s2 = lanes_div(K(1.0), lanes_sqrt(lanes_add(lanes_mul(z, z), lanes_mul(_s1, _s1))));
    const V _s3 = lanes_mul(_s1, _s2);
    const V _s4 = lanes_mul(z, _s2);
    const V _s5 = lanes_div(K(1.0), _s0);
    const V _s6 = lanes_mul(x, _s5);
    const V _s7 = lanes_mul(y, _s5);
    const V _s8 = lanes_sub(lanes_mul(vy, _s6), lanes_mul(vx, _s7));
    const V _s9 = lanes_mul(_c0, lanes_add(lanes_mul(wz, _s4), lanes_mul(_s3, lanes_add(lanes_mul(wx, _s6), lanes_mul(wy, _s7)))));
    return (LANES(court_ring_round_start_out)){ _s3, _s4, lanes_mul(per_reach, lanes_sub(lanes_mul(vz, _s3), lanes_mul(_s4, lanes_add(lanes_mul(vx, _s6), lanes_mul(vy, _s7))))), _s8, _s9, _s6, _s7, lanes_sub(lanes_mul(_s4, _s8), lanes_mul(_c2, lanes_mul(_s9, _s3))), lanes_div(K(1.0), lanes_add(_c1, lanes_mul(_s3, _c3))) };
}

/* State of a ball that rolls on the ring at time t.
   Routh's equations. 221 operations: 82 additions, 10 subtractions, 126 multiplications, 1 division, 1 square root, 1 negation. */
typedef struct {
    V x, y, z, vx, vy, vz, wx, wy, wz, climb;
} LANES(court_ring_round_moved_out);

LANES_INLINE LANES(court_ring_round_moved_out)
LANES(court_ring_round_moved)(V t, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V turn_rate_4, V turn_rate_5, V turn_rate_6, V turn_rate_7, V turn_rate_8, V turn_rate_9, V turn_rate_10, V turn_rate_11, V turn_rate_12, V climb_0, V climb_1, V climb_2, V climb_3, V climb_4, V climb_5, V climb_6, V climb_7, V climb_8, V climb_9, V climb_10, V climb_11, V climb_12, V cosine_0, V cosine_1, V cosine_2, V cosine_3, V cosine_4, V cosine_5, V cosine_6, V cosine_7, V cosine_8, V cosine_9, V cosine_10, V cosine_11, V cosine_12, V sine_0, V sine_1, V sine_2, V sine_3, V sine_4, V sine_5, V sine_6, V sine_7, V sine_8, V sine_9, V sine_10, V sine_11, V sine_12, V along_0, V along_1, V along_2, V along_3, V along_4, V along_5, V along_6, V along_7, V along_8, V along_9, V along_10, V along_11, V along_12, V cos_0, V sin_0, V omega_0, V omega_1, V omega_2, V omega_3, V omega_4, V omega_5, V omega_6, V omega_7, V omega_8, V omega_9, V omega_10, V omega_11, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_add(cosine_9, lanes_mul(t, lanes_add(cosine_10, lanes_mul(t, lanes_add(cosine_11, lanes_mul(t, cosine_12))))));
    const V _s1 = lanes_add(cosine_6, lanes_mul(t, lanes_add(cosine_7, lanes_mul(t, lanes_add(cosine_8, lanes_mul(t, _s0))))));
    const V _s2 = lanes_add(cosine_3, lanes_mul(t, lanes_add(cosine_4, lanes_mul(t, lanes_add(cosine_5, lanes_mul(t, _s1))))));
    const V _s3 = lanes_add(cosine_0, lanes_mul(t, lanes_add(cosine_1, lanes_mul(t, lanes_add(cosine_2, lanes_mul(t, _s2))))));
    const V _s4 = lanes_add(sine_9, lanes_mul(t, lanes_add(sine_10, lanes_mul(t, lanes_add(sine_11, lanes_mul(t, sine_12))))));
    const V _s5 = lanes_add(sine_6, lanes_mul(t, lanes_add(sine_7, lanes_mul(t, lanes_add(sine_8, lanes_mul(t, _s4))))));
    const V _s6 = lanes_add(sine_3, lanes_mul(t, lanes_add(sine_4, lanes_mul(t, lanes_add(sine_5, lanes_mul(t, _s5))))));
    const V _s7 = lanes_add(sine_0, lanes_mul(t, lanes_add(sine_1, lanes_mul(t, lanes_add(sine_2, lanes_mul(t, _s6))))));
    const V _s8 = lanes_div(K(1.0), lanes_sqrt(lanes_add(lanes_mul(_s3, _s3), lanes_mul(_s7, _s7))));
    const V _s9 = lanes_mul(_s3, _s8);
    const V _s10 = lanes_add(_c0, lanes_mul(_s9, _c1));
    const V _s11 = lanes_mul(t, lanes_add(lanes_mul(K(0.1), omega_9), lanes_mul(t, lanes_add(lanes_mul(K(0.09090909090909091), omega_10), lanes_mul(lanes_mul(K(0.08333333333333333), t), omega_11)))));
    const V _s12 = lanes_add(lanes_mul(K(0.14285714285714285), omega_6), lanes_mul(t, lanes_add(lanes_mul(K(0.125), omega_7), lanes_mul(t, lanes_add(lanes_mul(K(0.1111111111111111), omega_8), _s11)))));
    const V _s13 = lanes_add(lanes_mul(K(0.25), omega_3), lanes_mul(t, lanes_add(lanes_mul(K(0.2), omega_4), lanes_mul(t, lanes_add(lanes_mul(K(0.16666666666666666), omega_5), lanes_mul(t, _s12))))));
    const V _s14 = lanes_add(omega_0, lanes_mul(t, lanes_add(lanes_mul(K(0.5), omega_1), lanes_mul(t, lanes_add(lanes_mul(K(0.3333333333333333), omega_2), lanes_mul(t, _s13))))));
    const V _s15 = lanes_mul(t, _s14);
    const V _s16 = lanes_mul(_s15, _s15);
    const V _s17 = lanes_sub(lanes_mul(lanes_add(K(2.48015873015873e-05), lanes_mul(lanes_sub(lanes_mul(K(2.08767569878681e-09), _s16), K(2.755731922398589e-07)), _s16)), _s16), K(0.001388888888888889));
    const V _s18 = lanes_add(K(1.0), lanes_mul(lanes_sub(lanes_mul(lanes_add(K(0.041666666666666664), lanes_mul(_s17, _s16)), _s16), K(0.5)), _s16));
    const V _s19 = lanes_add(K(0.008333333333333333), lanes_mul(lanes_sub(lanes_mul(lanes_sub(K(2.7557319223985893e-06), lanes_mul(K(2.505210838544172e-08), _s16)), _s16), K(0.0001984126984126984)), _s16));
    const V _s20 = lanes_mul(_s15, lanes_add(K(1.0), lanes_mul(lanes_sub(lanes_mul(_s19, _s16), K(0.16666666666666666)), _s16)));
    const V _s21 = lanes_sub(lanes_mul(cos_0, _s18), lanes_mul(sin_0, _s20));
    const V _s22 = lanes_add(lanes_mul(cos_0, _s20), lanes_mul(sin_0, _s18));
    const V _s23 = lanes_mul(_s7, _s8);
    const V _s24 = lanes_add(climb_9, lanes_mul(t, lanes_add(climb_10, lanes_mul(t, lanes_add(climb_11, lanes_mul(t, climb_12))))));
    const V _s25 = lanes_add(climb_6, lanes_mul(t, lanes_add(climb_7, lanes_mul(t, lanes_add(climb_8, lanes_mul(t, _s24))))));
    const V _s26 = lanes_add(climb_3, lanes_mul(t, lanes_add(climb_4, lanes_mul(t, lanes_add(climb_5, lanes_mul(t, _s25))))));
    const V _s27 = lanes_add(climb_0, lanes_mul(t, lanes_add(climb_1, lanes_mul(t, lanes_add(climb_2, lanes_mul(t, _s26))))));
    const V _s28 = lanes_mul(_c1, _s27);
    const V _s29 = lanes_neg(lanes_mul(_s28, _s23));
    const V _s30 = lanes_add(along_9, lanes_mul(t, lanes_add(along_10, lanes_mul(t, lanes_add(along_11, lanes_mul(t, along_12))))));
    const V _s31 = lanes_add(along_6, lanes_mul(t, lanes_add(along_7, lanes_mul(t, lanes_add(along_8, lanes_mul(t, _s30))))));
    const V _s32 = lanes_add(along_3, lanes_mul(t, lanes_add(along_4, lanes_mul(t, lanes_add(along_5, lanes_mul(t, _s31))))));
    const V _s33 = lanes_add(along_0, lanes_mul(t, lanes_add(along_1, lanes_mul(t, lanes_add(along_2, lanes_mul(t, _s32))))));
    const V _s34 = lanes_add(turn_rate_9, lanes_mul(t, lanes_add(turn_rate_10, lanes_mul(t, lanes_add(turn_rate_11, lanes_mul(t, turn_rate_12))))));
    const V _s35 = lanes_add(turn_rate_6, lanes_mul(t, lanes_add(turn_rate_7, lanes_mul(t, lanes_add(turn_rate_8, lanes_mul(t, _s34))))));
    const V _s36 = lanes_add(turn_rate_3, lanes_mul(t, lanes_add(turn_rate_4, lanes_mul(t, lanes_add(turn_rate_5, lanes_mul(t, _s35))))));
    const V _s37 = lanes_add(turn_rate_0, lanes_mul(t, lanes_add(turn_rate_1, lanes_mul(t, lanes_add(turn_rate_2, lanes_mul(t, _s36))))));
    const V _s38 = lanes_sub(lanes_mul(_s9, _s37), lanes_mul(_s23, _s33));
    return (LANES(court_ring_round_moved_out)){ lanes_mul(_s10, _s21), lanes_mul(_s10, _s22), lanes_mul(_s23, _c1), lanes_sub(lanes_mul(_s29, _s21), lanes_mul(_s33, _s22)), lanes_add(lanes_mul(_s29, _s22), lanes_mul(_s33, _s21)), lanes_mul(_s28, _s9), lanes_mul(_c2, lanes_add(lanes_mul(_s28, _s22), lanes_mul(_s21, _s38))), lanes_mul(_c2, lanes_sub(lanes_mul(_s22, _s38), lanes_mul(_s28, _s21))), lanes_mul(_c2, lanes_add(lanes_mul(_s9, _s33), lanes_mul(_s23, _s37))), _s27 };
}

/* Length of a step of the series, and bounds in it.
   Routh's equations. 322 operations: 94 additions, 5 subtractions, 164 multiplications, 2 divisions, 7 square roots, 1 negation, 45 absolute values, 2 comparisons, 2 selections. */
typedef struct {
    V stride, missed, strongest, fastest, section_acceleration, force, force_rate, force_bend, friction_force_rate, vx_1, vy_1, vz_1;
} LANES(court_ring_round_step_out);

LANES_INLINE LANES(court_ring_round_step_out)
LANES(court_ring_round_step)(V per_reach, V turn_rate_0, V turn_rate_11, V turn_rate_12, V climb_0, V climb_1, V climb_2, V climb_3, V climb_4, V climb_5, V climb_6, V climb_7, V climb_8, V climb_9, V climb_10, V climb_11, V climb_12, V cosine_0, V cosine_12, V sine_0, V sine_12, V along_0, V along_1, V along_2, V along_3, V along_4, V along_5, V along_6, V along_7, V along_8, V along_9, V along_10, V along_11, V along_12, V cos_0, V sin_0, V omega_0, V omega_1, V omega_2, V omega_3, V omega_4, V omega_5, V omega_6, V omega_7, V omega_8, V omega_9, V omega_10, V omega_11, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6)
{
    const V _s0 = lanes_abs(climb_0);
    const V _s1 = lanes_abs(along_0);
    const V _s2 = lanes_add(lanes_mul(_s0, _c2), lanes_add(lanes_abs(turn_rate_0), _s1));
    const V _s3 = lanes_add(_c1, _s2);
    const V _s4 = lanes_abs(climb_11);
    const V _s5 = lanes_abs(along_11);
    const V _s6 = lanes_abs(climb_12);
    const V _s7 = lanes_abs(along_12);
    const V _s8 = lanes_add(lanes_mul(lanes_mul(K(0.25), lanes_add(lanes_mul(per_reach, _s2), lanes_sqrt(lanes_mul(_c0, per_reach)))), lanes_add(lanes_mul(_s4, _c2), lanes_add(lanes_abs(turn_rate_11), _s5))), lanes_add(lanes_mul(_s6, _c2), lanes_add(lanes_abs(turn_rate_12), _s7)));
    const V _s9 = lanes_abs(omega_0);
    const V _s10 = lanes_mul(omega_0, omega_0);
    const V _s11 = lanes_mul(lanes_mul(K(4.0), _s9), lanes_mul(K(16.0), _s10));
    const V _s12 = lanes_mul(_s11, _s11);
    const V _s13 = lanes_mul(_s3, lanes_add(lanes_add(lanes_abs(cosine_12), lanes_abs(sine_12)), lanes_mul(K(4.547473508864641e-13), lanes_mul(_s12, _s12))));
    const V _s14 = lanes_sqrt(lanes_sqrt(lanes_div(lanes_mul(K(4.547473508864641e-13), _s3), lanes_max(_s8, _s13))));
    const V _s15 = lanes_sqrt(lanes_sqrt(_s14));
    const V _s16 = lanes_mul(lanes_mul(K(0.75), _s15), lanes_sqrt(lanes_sqrt(_s15)));
    const V _s17 = lanes_mul(_s16, lanes_mul(_s16, _s16));
    const V _s18 = lanes_mul(lanes_div(lanes_add(_s17, lanes_mul(K(2.0), _s14)), lanes_add(lanes_mul(K(2.0), _s17), _s14)), _s16);
    const V _s19 = lanes_min(_s18, K(0.0625));
    const V _s20 = lanes_abs(climb_10);
    const V _s21 = lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_mul(K(12.0), _s6), _s19), lanes_mul(K(11.0), _s4)), _s19), lanes_mul(K(10.0), _s20)), _s19);
    const V _s22 = lanes_abs(climb_9);
    const V _s23 = lanes_abs(climb_8);
    const V _s24 = lanes_abs(climb_7);
    const V _s25 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(_s21, lanes_mul(K(9.0), _s22)), _s19), lanes_mul(K(8.0), _s23)), _s19), lanes_mul(K(7.0), _s24));
    const V _s26 = lanes_abs(climb_6);
    const V _s27 = lanes_abs(climb_5);
    const V _s28 = lanes_abs(climb_4);
    const V _s29 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s25, _s19), lanes_mul(K(6.0), _s26)), _s19), lanes_mul(K(5.0), _s27)), _s19), lanes_mul(K(4.0), _s28));
    const V _s30 = lanes_abs(climb_3);
    const V _s31 = lanes_abs(climb_2);
    const V _s32 = lanes_abs(climb_1);
    const V _s33 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s29, _s19), lanes_mul(K(3.0), _s30)), _s19), lanes_mul(K(2.0), _s31)), _s19), _s32);
    const V _s34 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s6, _s19), _s4), _s19), _s20), _s19), _s22);
    const V _s35 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s34, _s19), _s23), _s19), _s24), _s19), _s26);
    const V _s36 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s35, _s19), _s27), _s19), _s28), _s19), _s30);
    const V _s37 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s36, _s19), _s31), _s19), _s32), _s19), _s0);
    const V _s38 = lanes_mul(_c2, lanes_add(_s33, lanes_mul(_s37, _s37)));
    const V _s39 = lanes_abs(omega_11);
    const V _s40 = lanes_abs(omega_10);
    const V _s41 = lanes_abs(omega_9);
    const V _s42 = lanes_abs(omega_8);
    const V _s43 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s39, _s19), _s40), _s19), _s41), _s19), _s42);
    const V _s44 = lanes_abs(omega_7);
    const V _s45 = lanes_abs(omega_6);
    const V _s46 = lanes_abs(omega_5);
    const V _s47 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s43, _s19), _s44), _s19), _s45), _s19), _s46);
    const V _s48 = lanes_abs(omega_4);
    const V _s49 = lanes_abs(omega_3);
    const V _s50 = lanes_abs(omega_2);
    const V _s51 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s47, _s19), _s48), _s19), _s49), _s19), _s50);
    const V _s52 = lanes_abs(omega_1);
    const V _s53 = lanes_add(lanes_mul(lanes_add(lanes_mul(_s51, _s19), _s52), _s19), _s9);
    const V _s54 = lanes_abs(along_10);
    const V _s55 = lanes_abs(along_9);
    const V _s56 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s7, _s19), _s5), _s19), _s54), _s19), _s55);
    const V _s57 = lanes_abs(along_8);
    const V _s58 = lanes_abs(along_7);
    const V _s59 = lanes_abs(along_6);
    const V _s60 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s56, _s19), _s57), _s19), _s58), _s19), _s59);
    const V _s61 = lanes_abs(along_5);
    const V _s62 = lanes_abs(along_4);
    const V _s63 = lanes_abs(along_3);
    const V _s64 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s60, _s19), _s61), _s19), _s62), _s19), _s63);
    const V _s65 = lanes_abs(along_2);
    const V _s66 = lanes_abs(along_1);
    const V _s67 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s64, _s19), _s65), _s19), _s66), _s19), _s1);
    const V _s68 = lanes_add(lanes_mul(_c2, _s37), _s67);
    const V _s69 = lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_mul(K(12.0), _s7), _s19), lanes_mul(K(11.0), _s5)), _s19), lanes_mul(K(10.0), _s54)), _s19);
    const V _s70 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(_s69, lanes_mul(K(9.0), _s55)), _s19), lanes_mul(K(8.0), _s57)), _s19), lanes_mul(K(7.0), _s58));
    const V _s71 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s70, _s19), lanes_mul(K(6.0), _s59)), _s19), lanes_mul(K(5.0), _s61)), _s19), lanes_mul(K(4.0), _s62));
    const V _s72 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s71, _s19), lanes_mul(K(3.0), _s63)), _s19), lanes_mul(K(2.0), _s65)), _s19), _s66);
    const V _s73 = lanes_mul(lanes_mul(climb_0, climb_0), _c2);
    const V _s74 = lanes_mul(along_0, omega_0);
    const V _s75 = lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_mul(K(11.0), _s39), _s19), lanes_mul(K(10.0), _s40)), _s19), lanes_mul(K(9.0), _s41)), _s19);
    const V _s76 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(_s75, lanes_mul(K(8.0), _s42)), _s19), lanes_mul(K(7.0), _s44)), _s19), lanes_mul(K(6.0), _s45));
    const V _s77 = lanes_add(lanes_mul(lanes_add(lanes_mul(lanes_add(lanes_mul(_s76, _s19), lanes_mul(K(5.0), _s46)), _s19), lanes_mul(K(4.0), _s48)), _s19), lanes_mul(K(3.0), _s49));
    const V _s78 = lanes_mul(_s37, _s19);
    const V _s79 = lanes_add(lanes_abs(sine_0), _s78);
    const V _s80 = lanes_mul(lanes_mul(_s53, lanes_add(lanes_mul(lanes_add(lanes_mul(_s77, _s19), lanes_mul(K(2.0), _s50)), _s19), _s52)), _s79);
    const V _s81 = lanes_mul(_c4, lanes_mul(_s53, _s53));
    const V _s82 = lanes_add(lanes_abs(cosine_0), _s78);
    const V _s83 = lanes_add(lanes_mul(lanes_add(lanes_mul(_c5, _s80), lanes_mul(_s37, lanes_add(lanes_mul(_s81, _s82), lanes_mul(_c3, _s79)))), _s37), lanes_mul(_s33, lanes_add(lanes_mul(_s81, _s79), lanes_mul(_c3, _s82))));
    const V _s84 = lanes_neg(lanes_add(lanes_add(lanes_mul(cosine_0, _s73), _s74), lanes_mul(lanes_mul(climb_1, sine_0), _c2)));
    const V _s85 = lanes_sub(along_1, lanes_mul(omega_0, lanes_mul(lanes_mul(climb_0, sine_0), _c2)));
    return (LANES(court_ring_round_step_out)){ _s19, lanes_mul(K(5.684341886080802e-14), _s3), lanes_add(_s38, lanes_add(lanes_mul(_s53, _s68), _s72)), _s68, _s38, lanes_sub(lanes_sub(lanes_mul(_c0, sine_0), _s73), lanes_mul(cosine_0, _s74)), lanes_mul(climb_0, lanes_add(lanes_mul(cosine_0, _c3), lanes_mul(sine_0, lanes_mul(_c4, _s10)))), _s83, lanes_mul(_c6, lanes_mul(climb_0, cosine_0)), lanes_sub(lanes_mul(cos_0, _s84), lanes_mul(sin_0, _s85)), lanes_add(lanes_mul(cos_0, _s85), lanes_mul(sin_0, _s84)), lanes_sub(lanes_mul(lanes_mul(climb_1, cosine_0), _c2), lanes_mul(sine_0, _s73)) };
}

/* Square of the friction that rolling on the ring takes, and its rate.
   Routh's equations. 24 operations: 6 additions, 18 multiplications. */
typedef struct {
    V rolling_friction, rolling_friction_rate, grip_deficit, grip_deficit_rate;
} LANES(court_ring_round_pulled_out);

LANES_INLINE LANES(court_ring_round_pulled_out)
LANES(court_ring_round_pulled)(V turn_rate_0, V turn_rate_1, V climb_0, V climb_1, V cosine_0, V cosine_1, V omega_0, V omega_1, V _c0, V _c1)
{
    const V _s0 = lanes_mul(_c1, lanes_mul(turn_rate_0, climb_0));
    const V _s1 = lanes_add(_c0, lanes_mul(turn_rate_0, omega_0));
    const V _s2 = lanes_mul(_c1, lanes_mul(cosine_0, _s1));
    const V _s3 = lanes_mul(_s2, lanes_mul(_c1, lanes_add(lanes_mul(cosine_0, lanes_add(lanes_mul(turn_rate_0, omega_1), lanes_mul(turn_rate_1, omega_0))), lanes_mul(cosine_1, _s1))));
    const V _s4 = lanes_mul(K(2.0), lanes_add(lanes_mul(_s0, lanes_mul(_c1, lanes_add(lanes_mul(turn_rate_0, climb_1), lanes_mul(turn_rate_1, climb_0)))), _s3));
    return (LANES(court_ring_round_pulled_out)){ lanes_add(lanes_mul(_s0, _s0), lanes_mul(_s2, _s2)), _s4, K(-INFINITY), K(0.0) };
}

/* Whether the ball certainly rolls on the ring for ever.
   Routh's equations. 41 operations: 3 additions, 3 subtractions, 15 multiplications, 1 absolute value, 8 comparisons, 6 conjunctions, 1 complement, 4 selections. */
typedef struct {
    V circled;
    M endless;
    V undecided_time;
} LANES(court_ring_swung_out);

LANES_INLINE LANES(court_ring_swung_out)
LANES(court_ring_swung)(V which, V undecided_time, V position_error, V velocity_error, V force, V force_rate, V force_bend, V stride, V fastest, V circled, V climb, V climb_0, V section_acceleration, V azimuth_clearance, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6)
{
    const V _s0 = lanes_mul(stride, stride);
    const M _s1 = lanes_both(lanes_less(_c2, lanes_sub(azimuth_clearance, lanes_mul(lanes_mul(K(0.125), section_acceleration), _s0))), lanes_less(_c3, lanes_sub(lanes_add(force, lanes_mul(stride, lanes_min(force_rate, K(0.0)))), lanes_mul(lanes_mul(K(0.5), force_bend), _s0))));
    const M _s2 = lanes_both(_s1, lanes_equal(which, K(-1.0)));
    const M _s3 = lanes_both(lanes_less(lanes_mul(climb, climb_0), K(0.0)), lanes_less(lanes_mul(_c4, stride), lanes_mul(lanes_abs(lanes_sub(climb, climb_0)), _c1)));
    const M _s4 = lanes_both(lanes_both(_s2, _s3), lanes_less(K(0.0), circled));
    const V _s5 = lanes_add(_c0, lanes_mul(lanes_mul(fastest, fastest), _c5));
    const M _s6 = lanes_not(lanes_less(lanes_mul(_s5, lanes_mul(K(512.0), lanes_add(lanes_mul(position_error, _s5), lanes_mul(velocity_error, fastest)))), _c6));
    return (LANES(court_ring_swung_out)){ lanes_select(_s2, lanes_select(_s3, K(1.0), circled), K(0.0)), _s4, lanes_select(lanes_both(_s4, _s6), K(0.0), undecided_time) };
}

/* Coefficients of order 1, from those of lower order.
   Routh's equations. 21 operations: 2 additions, 1 subtraction, 16 multiplications, 2 negations. */
typedef struct {
    V omega_0, around_0, cosine_1, sine_1, climb_1, along_1, turn_rate_1, tilted_1;
} LANES(court_ring_round_0_out);

LANES_INLINE LANES(court_ring_round_0_out)
LANES(court_ring_round_0)(V per_reach, V turn_rate_0, V near_0, V climb_0, V cosine_0, V sine_0, V along_0, V tilted_0, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_mul(near_0, along_0);
    const V _s1 = lanes_mul(climb_0, _s0);
    return (LANES(court_ring_round_0_out)){ _s0, _s1, lanes_neg(lanes_mul(climb_0, sine_0)), lanes_mul(climb_0, cosine_0), lanes_neg(lanes_mul(per_reach, lanes_add(lanes_mul(lanes_mul(_c0, cosine_0), _c2), lanes_mul(tilted_0, _s0)))), lanes_sub(lanes_mul(lanes_mul(sine_0, _s1), _c3), lanes_mul(_c4, lanes_mul(turn_rate_0, climb_0))), lanes_mul(_c1, _s1), lanes_add(lanes_mul(_c5, lanes_mul(cosine_0, _s1)), lanes_mul(_s1, _c3)) };
}

/* Coefficients of order 2, from those of lower order.
   Routh's equations. 43 operations: 9 additions, 2 subtractions, 30 multiplications, 2 negations. */
typedef struct {
    V omega_1, around_1, cosine_2, sine_2, climb_2, along_2, turn_rate_2, tilted_2;
} LANES(court_ring_round_1_out);

LANES_INLINE LANES(court_ring_round_1_out)
LANES(court_ring_round_1)(V per_reach, V turn_rate_0, V turn_rate_1, V near_0, V climb_0, V climb_1, V cosine_0, V cosine_1, V sine_0, V sine_1, V along_1, V omega_0, V around_0, V tilted_0, V tilted_1, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_mul(near_0, lanes_sub(along_1, lanes_mul(lanes_mul(cosine_1, omega_0), _c1)));
    const V _s1 = lanes_add(lanes_mul(climb_0, _s0), lanes_mul(climb_1, omega_0));
    return (LANES(court_ring_round_1_out)){ _s0, _s1, lanes_neg(lanes_mul(K(0.5), lanes_add(lanes_mul(climb_0, sine_1), lanes_mul(climb_1, sine_0)))), lanes_mul(K(0.5), lanes_add(lanes_mul(climb_0, cosine_1), lanes_mul(climb_1, cosine_0))), lanes_neg(lanes_mul(lanes_mul(K(0.5), per_reach), lanes_add(lanes_mul(lanes_mul(_c0, cosine_1), _c2), lanes_add(lanes_mul(omega_0, tilted_1), lanes_mul(tilted_0, _s0))))), lanes_mul(K(0.5), lanes_sub(lanes_mul(_c1, lanes_add(lanes_mul(sine_0, _s1), lanes_mul(sine_1, around_0))), lanes_mul(_c3, lanes_add(lanes_mul(turn_rate_0, climb_1), lanes_mul(turn_rate_1, climb_0))))), lanes_mul(_c4, _s1), lanes_mul(K(0.5), lanes_add(lanes_mul(_c5, lanes_add(lanes_mul(cosine_0, _s1), lanes_mul(cosine_1, around_0))), lanes_mul(_c1, _s1))) };
}

/* Coefficients of order 3, from those of lower order.
   Routh's equations. 59 operations: 17 additions, 2 subtractions, 38 multiplications, 2 negations. */
typedef struct {
    V omega_2, around_2, cosine_3, sine_3, climb_3, along_3, turn_rate_3, tilted_3;
} LANES(court_ring_round_2_out);

LANES_INLINE LANES(court_ring_round_2_out)
LANES(court_ring_round_2)(V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V near_0, V climb_0, V climb_1, V climb_2, V cosine_0, V cosine_1, V cosine_2, V sine_0, V sine_1, V sine_2, V along_2, V omega_0, V omega_1, V around_0, V around_1, V tilted_0, V tilted_1, V tilted_2, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_mul(near_0, lanes_sub(along_2, lanes_mul(_c1, lanes_add(lanes_mul(cosine_1, omega_1), lanes_mul(cosine_2, omega_0)))));
    const V _s1 = lanes_add(lanes_add(lanes_mul(climb_0, _s0), lanes_mul(climb_1, omega_1)), lanes_mul(climb_2, omega_0));
    const V _s2 = lanes_neg(lanes_mul(lanes_mul(K(0.3333333333333333), per_reach), lanes_add(lanes_mul(lanes_mul(_c0, cosine_2), _c2), lanes_add(lanes_add(lanes_mul(omega_0, tilted_2), lanes_mul(omega_1, tilted_1)), lanes_mul(tilted_0, _s0)))));
    const V _s3 = lanes_mul(K(0.3333333333333333), lanes_sub(lanes_mul(_c1, lanes_add(lanes_add(lanes_mul(sine_0, _s1), lanes_mul(sine_1, around_1)), lanes_mul(sine_2, around_0))), lanes_mul(_c3, lanes_add(lanes_add(lanes_mul(turn_rate_0, climb_2), lanes_mul(turn_rate_1, climb_1)), lanes_mul(turn_rate_2, climb_0)))));
    const V _s4 = lanes_mul(K(0.3333333333333333), lanes_add(lanes_mul(_c5, lanes_add(lanes_add(lanes_mul(cosine_0, _s1), lanes_mul(cosine_1, around_1)), lanes_mul(cosine_2, around_0))), lanes_mul(_c1, _s1)));
    return (LANES(court_ring_round_2_out)){ _s0, _s1, lanes_neg(lanes_mul(K(0.3333333333333333), lanes_add(lanes_add(lanes_mul(climb_0, sine_2), lanes_mul(climb_1, sine_1)), lanes_mul(climb_2, sine_0)))), lanes_mul(K(0.3333333333333333), lanes_add(lanes_add(lanes_mul(climb_0, cosine_2), lanes_mul(climb_1, cosine_1)), lanes_mul(climb_2, cosine_0))), _s2, _s3, lanes_mul(_c4, _s1), _s4 };
}

/* Coefficients of order 4, from those of lower order.
   Routh's equations. 75 operations: 25 additions, 2 subtractions, 46 multiplications, 2 negations. */
typedef struct {
    V omega_3, around_3, cosine_4, sine_4, climb_4, along_4, turn_rate_4, tilted_4;
} LANES(court_ring_round_3_out);

LANES_INLINE LANES(court_ring_round_3_out)
LANES(court_ring_round_3)(V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V near_0, V climb_0, V climb_1, V climb_2, V climb_3, V cosine_0, V cosine_1, V cosine_2, V cosine_3, V sine_0, V sine_1, V sine_2, V sine_3, V along_3, V omega_0, V omega_1, V omega_2, V around_0, V around_1, V around_2, V tilted_0, V tilted_1, V tilted_2, V tilted_3, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_mul(near_0, lanes_sub(along_3, lanes_mul(_c1, lanes_add(lanes_add(lanes_mul(cosine_1, omega_2), lanes_mul(cosine_2, omega_1)), lanes_mul(cosine_3, omega_0)))));
    const V _s1 = lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, _s0), lanes_mul(climb_1, omega_2)), lanes_mul(climb_2, omega_1)), lanes_mul(climb_3, omega_0));
    const V _s2 = lanes_neg(lanes_mul(K(0.25), lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, sine_3), lanes_mul(climb_1, sine_2)), lanes_mul(climb_2, sine_1)), lanes_mul(climb_3, sine_0))));
    const V _s3 = lanes_mul(lanes_mul(K(0.25), per_reach), lanes_add(lanes_mul(lanes_mul(_c0, cosine_3), _c2), lanes_add(lanes_add(lanes_add(lanes_mul(omega_0, tilted_3), lanes_mul(omega_1, tilted_2)), lanes_mul(omega_2, tilted_1)), lanes_mul(tilted_0, _s0))));
    const V _s4 = lanes_sub(lanes_mul(_c1, lanes_add(lanes_add(lanes_add(lanes_mul(sine_0, _s1), lanes_mul(sine_1, around_2)), lanes_mul(sine_2, around_1)), lanes_mul(sine_3, around_0))), lanes_mul(_c3, lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, climb_3), lanes_mul(turn_rate_1, climb_2)), lanes_mul(turn_rate_2, climb_1)), lanes_mul(turn_rate_3, climb_0))));
    const V _s5 = lanes_add(lanes_mul(_c5, lanes_add(lanes_add(lanes_add(lanes_mul(cosine_0, _s1), lanes_mul(cosine_1, around_2)), lanes_mul(cosine_2, around_1)), lanes_mul(cosine_3, around_0))), lanes_mul(_c1, _s1));
    return (LANES(court_ring_round_3_out)){ _s0, _s1, _s2, lanes_mul(K(0.25), lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, cosine_3), lanes_mul(climb_1, cosine_2)), lanes_mul(climb_2, cosine_1)), lanes_mul(climb_3, cosine_0))), lanes_neg(_s3), lanes_mul(K(0.25), _s4), lanes_mul(_c4, _s1), lanes_mul(K(0.25), _s5) };
}

/* Coefficients of order 5, from those of lower order.
   Routh's equations. 91 operations: 33 additions, 2 subtractions, 54 multiplications, 2 negations. */
typedef struct {
    V omega_4, around_4, cosine_5, sine_5, climb_5, along_5, turn_rate_5, tilted_5;
} LANES(court_ring_round_4_out);

LANES_INLINE LANES(court_ring_round_4_out)
LANES(court_ring_round_4)(V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V turn_rate_4, V near_0, V climb_0, V climb_1, V climb_2, V climb_3, V climb_4, V cosine_0, V cosine_1, V cosine_2, V cosine_3, V cosine_4, V sine_0, V sine_1, V sine_2, V sine_3, V sine_4, V along_4, V omega_0, V omega_1, V omega_2, V omega_3, V around_0, V around_1, V around_2, V around_3, V tilted_0, V tilted_1, V tilted_2, V tilted_3, V tilted_4, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_sub(along_4, lanes_mul(_c1, lanes_add(lanes_add(lanes_add(lanes_mul(cosine_1, omega_3), lanes_mul(cosine_2, omega_2)), lanes_mul(cosine_3, omega_1)), lanes_mul(cosine_4, omega_0))));
    const V _s1 = lanes_mul(near_0, _s0);
    const V _s2 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, _s1), lanes_mul(climb_1, omega_3)), lanes_mul(climb_2, omega_2)), lanes_mul(climb_3, omega_1)), lanes_mul(climb_4, omega_0));
    const V _s3 = lanes_mul(K(0.2), lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, sine_4), lanes_mul(climb_1, sine_3)), lanes_mul(climb_2, sine_2)), lanes_mul(climb_3, sine_1)), lanes_mul(climb_4, sine_0)));
    const V _s4 = lanes_mul(K(0.2), lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, cosine_4), lanes_mul(climb_1, cosine_3)), lanes_mul(climb_2, cosine_2)), lanes_mul(climb_3, cosine_1)), lanes_mul(climb_4, cosine_0)));
    const V _s5 = lanes_add(lanes_mul(lanes_mul(_c0, cosine_4), _c2), lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(omega_0, tilted_4), lanes_mul(omega_1, tilted_3)), lanes_mul(omega_2, tilted_2)), lanes_mul(omega_3, tilted_1)), lanes_mul(tilted_0, _s1)));
    const V _s6 = lanes_mul(_c1, lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(sine_0, _s2), lanes_mul(sine_1, around_3)), lanes_mul(sine_2, around_2)), lanes_mul(sine_3, around_1)), lanes_mul(sine_4, around_0)));
    const V _s7 = lanes_mul(_c3, lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, climb_4), lanes_mul(turn_rate_1, climb_3)), lanes_mul(turn_rate_2, climb_2)), lanes_mul(turn_rate_3, climb_1)), lanes_mul(turn_rate_4, climb_0)));
    const V _s8 = lanes_mul(_c5, lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(cosine_0, _s2), lanes_mul(cosine_1, around_3)), lanes_mul(cosine_2, around_2)), lanes_mul(cosine_3, around_1)), lanes_mul(cosine_4, around_0)));
    return (LANES(court_ring_round_4_out)){ _s1, _s2, lanes_neg(_s3), _s4, lanes_neg(lanes_mul(lanes_mul(K(0.2), per_reach), _s5)), lanes_mul(K(0.2), lanes_sub(_s6, _s7)), lanes_mul(_c4, _s2), lanes_mul(K(0.2), lanes_add(_s8, lanes_mul(_c1, _s2))) };
}

/* Coefficients of order 6, from those of lower order.
   Routh's equations. 107 operations: 41 additions, 2 subtractions, 62 multiplications, 2 negations. */
typedef struct {
    V omega_5, around_5, cosine_6, sine_6, climb_6, along_6, turn_rate_6, tilted_6;
} LANES(court_ring_round_5_out);

LANES_INLINE LANES(court_ring_round_5_out)
LANES(court_ring_round_5)(V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V turn_rate_4, V turn_rate_5, V near_0, V climb_0, V climb_1, V climb_2, V climb_3, V climb_4, V climb_5, V cosine_0, V cosine_1, V cosine_2, V cosine_3, V cosine_4, V cosine_5, V sine_0, V sine_1, V sine_2, V sine_3, V sine_4, V sine_5, V along_5, V omega_0, V omega_1, V omega_2, V omega_3, V omega_4, V around_0, V around_1, V around_2, V around_3, V around_4, V tilted_0, V tilted_1, V tilted_2, V tilted_3, V tilted_4, V tilted_5, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_mul(_c1, lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(cosine_1, omega_4), lanes_mul(cosine_2, omega_3)), lanes_mul(cosine_3, omega_2)), lanes_mul(cosine_4, omega_1)), lanes_mul(cosine_5, omega_0)));
    const V _s1 = lanes_mul(near_0, lanes_sub(along_5, _s0));
    const V _s2 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, _s1), lanes_mul(climb_1, omega_4)), lanes_mul(climb_2, omega_3)), lanes_mul(climb_3, omega_2)), lanes_mul(climb_4, omega_1)), lanes_mul(climb_5, omega_0));
    const V _s3 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, sine_5), lanes_mul(climb_1, sine_4)), lanes_mul(climb_2, sine_3)), lanes_mul(climb_3, sine_2)), lanes_mul(climb_4, sine_1)), lanes_mul(climb_5, sine_0));
    const V _s4 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, cosine_5), lanes_mul(climb_1, cosine_4)), lanes_mul(climb_2, cosine_3)), lanes_mul(climb_3, cosine_2)), lanes_mul(climb_4, cosine_1)), lanes_mul(climb_5, cosine_0));
    const V _s5 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(omega_0, tilted_5), lanes_mul(omega_1, tilted_4)), lanes_mul(omega_2, tilted_3)), lanes_mul(omega_3, tilted_2)), lanes_mul(omega_4, tilted_1)), lanes_mul(tilted_0, _s1));
    const V _s6 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(sine_0, _s2), lanes_mul(sine_1, around_4)), lanes_mul(sine_2, around_3)), lanes_mul(sine_3, around_2)), lanes_mul(sine_4, around_1)), lanes_mul(sine_5, around_0));
    const V _s7 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, climb_5), lanes_mul(turn_rate_1, climb_4)), lanes_mul(turn_rate_2, climb_3)), lanes_mul(turn_rate_3, climb_2)), lanes_mul(turn_rate_4, climb_1)), lanes_mul(turn_rate_5, climb_0));
    const V _s8 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(cosine_0, _s2), lanes_mul(cosine_1, around_4)), lanes_mul(cosine_2, around_3)), lanes_mul(cosine_3, around_2)), lanes_mul(cosine_4, around_1)), lanes_mul(cosine_5, around_0));
    return (LANES(court_ring_round_5_out)){ _s1, _s2, lanes_neg(lanes_mul(K(0.16666666666666666), _s3)), lanes_mul(K(0.16666666666666666), _s4), lanes_neg(lanes_mul(lanes_mul(K(0.16666666666666666), per_reach), lanes_add(lanes_mul(lanes_mul(_c0, cosine_5), _c2), _s5))), lanes_mul(K(0.16666666666666666), lanes_sub(lanes_mul(_c1, _s6), lanes_mul(_c3, _s7))), lanes_mul(_c4, _s2), lanes_mul(K(0.16666666666666666), lanes_add(lanes_mul(_c5, _s8), lanes_mul(_c1, _s2))) };
}

/* Coefficients of order 7, from those of lower order.
   Routh's equations. 123 operations: 49 additions, 2 subtractions, 70 multiplications, 2 negations. */
typedef struct {
    V omega_6, around_6, cosine_7, sine_7, climb_7, along_7, turn_rate_7, tilted_7;
} LANES(court_ring_round_6_out);

LANES_INLINE LANES(court_ring_round_6_out)
LANES(court_ring_round_6)(V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V turn_rate_4, V turn_rate_5, V turn_rate_6, V near_0, V climb_0, V climb_1, V climb_2, V climb_3, V climb_4, V climb_5, V climb_6, V cosine_0, V cosine_1, V cosine_2, V cosine_3, V cosine_4, V cosine_5, V cosine_6, V sine_0, V sine_1, V sine_2, V sine_3, V sine_4, V sine_5, V sine_6, V along_6, V omega_0, V omega_1, V omega_2, V omega_3, V omega_4, V omega_5, V around_0, V around_1, V around_2, V around_3, V around_4, V around_5, V tilted_0, V tilted_1, V tilted_2, V tilted_3, V tilted_4, V tilted_5, V tilted_6, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(cosine_1, omega_5), lanes_mul(cosine_2, omega_4)), lanes_mul(cosine_3, omega_3)), lanes_mul(cosine_4, omega_2)), lanes_mul(cosine_5, omega_1)), lanes_mul(cosine_6, omega_0));
    const V _s1 = lanes_mul(near_0, lanes_sub(along_6, lanes_mul(_c1, _s0)));
    const V _s2 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, _s1), lanes_mul(climb_1, omega_5)), lanes_mul(climb_2, omega_4)), lanes_mul(climb_3, omega_3)), lanes_mul(climb_4, omega_2)), lanes_mul(climb_5, omega_1));
    const V _s3 = lanes_add(_s2, lanes_mul(climb_6, omega_0));
    const V _s4 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, sine_6), lanes_mul(climb_1, sine_5)), lanes_mul(climb_2, sine_4)), lanes_mul(climb_3, sine_3)), lanes_mul(climb_4, sine_2)), lanes_mul(climb_5, sine_1));
    const V _s5 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, cosine_6), lanes_mul(climb_1, cosine_5)), lanes_mul(climb_2, cosine_4)), lanes_mul(climb_3, cosine_3)), lanes_mul(climb_4, cosine_2)), lanes_mul(climb_5, cosine_1));
    const V _s6 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(omega_0, tilted_6), lanes_mul(omega_1, tilted_5)), lanes_mul(omega_2, tilted_4)), lanes_mul(omega_3, tilted_3)), lanes_mul(omega_4, tilted_2)), lanes_mul(omega_5, tilted_1));
    const V _s7 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(sine_0, _s3), lanes_mul(sine_1, around_5)), lanes_mul(sine_2, around_4)), lanes_mul(sine_3, around_3)), lanes_mul(sine_4, around_2)), lanes_mul(sine_5, around_1));
    const V _s8 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, climb_6), lanes_mul(turn_rate_1, climb_5)), lanes_mul(turn_rate_2, climb_4)), lanes_mul(turn_rate_3, climb_3)), lanes_mul(turn_rate_4, climb_2)), lanes_mul(turn_rate_5, climb_1));
    const V _s9 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(cosine_0, _s3), lanes_mul(cosine_1, around_5)), lanes_mul(cosine_2, around_4)), lanes_mul(cosine_3, around_3)), lanes_mul(cosine_4, around_2)), lanes_mul(cosine_5, around_1));
    return (LANES(court_ring_round_6_out)){ _s1, _s3, lanes_neg(lanes_mul(K(0.14285714285714285), lanes_add(_s4, lanes_mul(climb_6, sine_0)))), lanes_mul(K(0.14285714285714285), lanes_add(_s5, lanes_mul(climb_6, cosine_0))), lanes_neg(lanes_mul(lanes_mul(K(0.14285714285714285), per_reach), lanes_add(lanes_mul(lanes_mul(_c0, cosine_6), _c2), lanes_add(_s6, lanes_mul(tilted_0, _s1))))), lanes_mul(K(0.14285714285714285), lanes_sub(lanes_mul(_c1, lanes_add(_s7, lanes_mul(sine_6, around_0))), lanes_mul(_c3, lanes_add(_s8, lanes_mul(turn_rate_6, climb_0))))), lanes_mul(_c4, _s3), lanes_mul(K(0.14285714285714285), lanes_add(lanes_mul(_c5, lanes_add(_s9, lanes_mul(cosine_6, around_0))), lanes_mul(_c1, _s3))) };
}

/* Coefficients of order 8, from those of lower order.
   Routh's equations. 139 operations: 57 additions, 2 subtractions, 78 multiplications, 2 negations. */
typedef struct {
    V omega_7, around_7, cosine_8, sine_8, climb_8, along_8, turn_rate_8, tilted_8;
} LANES(court_ring_round_7_out);

LANES_INLINE LANES(court_ring_round_7_out)
LANES(court_ring_round_7)(V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V turn_rate_4, V turn_rate_5, V turn_rate_6, V turn_rate_7, V near_0, V climb_0, V climb_1, V climb_2, V climb_3, V climb_4, V climb_5, V climb_6, V climb_7, V cosine_0, V cosine_1, V cosine_2, V cosine_3, V cosine_4, V cosine_5, V cosine_6, V cosine_7, V sine_0, V sine_1, V sine_2, V sine_3, V sine_4, V sine_5, V sine_6, V sine_7, V along_7, V omega_0, V omega_1, V omega_2, V omega_3, V omega_4, V omega_5, V omega_6, V around_0, V around_1, V around_2, V around_3, V around_4, V around_5, V around_6, V tilted_0, V tilted_1, V tilted_2, V tilted_3, V tilted_4, V tilted_5, V tilted_6, V tilted_7, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(cosine_1, omega_6), lanes_mul(cosine_2, omega_5)), lanes_mul(cosine_3, omega_4)), lanes_mul(cosine_4, omega_3)), lanes_mul(cosine_5, omega_2)), lanes_mul(cosine_6, omega_1));
    const V _s1 = lanes_mul(near_0, lanes_sub(along_7, lanes_mul(_c1, lanes_add(_s0, lanes_mul(cosine_7, omega_0)))));
    const V _s2 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, _s1), lanes_mul(climb_1, omega_6)), lanes_mul(climb_2, omega_5)), lanes_mul(climb_3, omega_4)), lanes_mul(climb_4, omega_3)), lanes_mul(climb_5, omega_2));
    const V _s3 = lanes_add(lanes_add(_s2, lanes_mul(climb_6, omega_1)), lanes_mul(climb_7, omega_0));
    const V _s4 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, sine_7), lanes_mul(climb_1, sine_6)), lanes_mul(climb_2, sine_5)), lanes_mul(climb_3, sine_4)), lanes_mul(climb_4, sine_3)), lanes_mul(climb_5, sine_2));
    const V _s5 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, cosine_7), lanes_mul(climb_1, cosine_6)), lanes_mul(climb_2, cosine_5)), lanes_mul(climb_3, cosine_4)), lanes_mul(climb_4, cosine_3)), lanes_mul(climb_5, cosine_2));
    const V _s6 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(omega_0, tilted_7), lanes_mul(omega_1, tilted_6)), lanes_mul(omega_2, tilted_5)), lanes_mul(omega_3, tilted_4)), lanes_mul(omega_4, tilted_3)), lanes_mul(omega_5, tilted_2));
    const V _s7 = lanes_neg(lanes_mul(lanes_mul(K(0.125), per_reach), lanes_add(lanes_mul(lanes_mul(_c0, cosine_7), _c2), lanes_add(lanes_add(_s6, lanes_mul(omega_6, tilted_1)), lanes_mul(tilted_0, _s1)))));
    const V _s8 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(sine_0, _s3), lanes_mul(sine_1, around_6)), lanes_mul(sine_2, around_5)), lanes_mul(sine_3, around_4)), lanes_mul(sine_4, around_3)), lanes_mul(sine_5, around_2));
    const V _s9 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, climb_7), lanes_mul(turn_rate_1, climb_6)), lanes_mul(turn_rate_2, climb_5)), lanes_mul(turn_rate_3, climb_4)), lanes_mul(turn_rate_4, climb_3)), lanes_mul(turn_rate_5, climb_2));
    const V _s10 = lanes_mul(K(0.125), lanes_sub(lanes_mul(_c1, lanes_add(lanes_add(_s8, lanes_mul(sine_6, around_1)), lanes_mul(sine_7, around_0))), lanes_mul(_c3, lanes_add(lanes_add(_s9, lanes_mul(turn_rate_6, climb_1)), lanes_mul(turn_rate_7, climb_0)))));
    const V _s11 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(cosine_0, _s3), lanes_mul(cosine_1, around_6)), lanes_mul(cosine_2, around_5)), lanes_mul(cosine_3, around_4)), lanes_mul(cosine_4, around_3)), lanes_mul(cosine_5, around_2));
    const V _s12 = lanes_mul(K(0.125), lanes_add(lanes_mul(_c5, lanes_add(lanes_add(_s11, lanes_mul(cosine_6, around_1)), lanes_mul(cosine_7, around_0))), lanes_mul(_c1, _s3)));
    return (LANES(court_ring_round_7_out)){ _s1, _s3, lanes_neg(lanes_mul(K(0.125), lanes_add(lanes_add(_s4, lanes_mul(climb_6, sine_1)), lanes_mul(climb_7, sine_0)))), lanes_mul(K(0.125), lanes_add(lanes_add(_s5, lanes_mul(climb_6, cosine_1)), lanes_mul(climb_7, cosine_0))), _s7, _s10, lanes_mul(_c4, _s3), _s12 };
}

/* Coefficients of order 9, from those of lower order.
   Routh's equations. 155 operations: 65 additions, 2 subtractions, 86 multiplications, 2 negations. */
typedef struct {
    V omega_8, around_8, cosine_9, sine_9, climb_9, along_9, turn_rate_9, tilted_9;
} LANES(court_ring_round_8_out);

LANES_INLINE LANES(court_ring_round_8_out)
LANES(court_ring_round_8)(V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V turn_rate_4, V turn_rate_5, V turn_rate_6, V turn_rate_7, V turn_rate_8, V near_0, V climb_0, V climb_1, V climb_2, V climb_3, V climb_4, V climb_5, V climb_6, V climb_7, V climb_8, V cosine_0, V cosine_1, V cosine_2, V cosine_3, V cosine_4, V cosine_5, V cosine_6, V cosine_7, V cosine_8, V sine_0, V sine_1, V sine_2, V sine_3, V sine_4, V sine_5, V sine_6, V sine_7, V sine_8, V along_8, V omega_0, V omega_1, V omega_2, V omega_3, V omega_4, V omega_5, V omega_6, V omega_7, V around_0, V around_1, V around_2, V around_3, V around_4, V around_5, V around_6, V around_7, V tilted_0, V tilted_1, V tilted_2, V tilted_3, V tilted_4, V tilted_5, V tilted_6, V tilted_7, V tilted_8, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(cosine_1, omega_7), lanes_mul(cosine_2, omega_6)), lanes_mul(cosine_3, omega_5)), lanes_mul(cosine_4, omega_4)), lanes_mul(cosine_5, omega_3)), lanes_mul(cosine_6, omega_2));
    const V _s1 = lanes_mul(near_0, lanes_sub(along_8, lanes_mul(_c1, lanes_add(lanes_add(_s0, lanes_mul(cosine_7, omega_1)), lanes_mul(cosine_8, omega_0)))));
    const V _s2 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, _s1), lanes_mul(climb_1, omega_7)), lanes_mul(climb_2, omega_6)), lanes_mul(climb_3, omega_5)), lanes_mul(climb_4, omega_4)), lanes_mul(climb_5, omega_3));
    const V _s3 = lanes_add(lanes_add(lanes_add(_s2, lanes_mul(climb_6, omega_2)), lanes_mul(climb_7, omega_1)), lanes_mul(climb_8, omega_0));
    const V _s4 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, sine_8), lanes_mul(climb_1, sine_7)), lanes_mul(climb_2, sine_6)), lanes_mul(climb_3, sine_5)), lanes_mul(climb_4, sine_4)), lanes_mul(climb_5, sine_3));
    const V _s5 = lanes_neg(lanes_mul(K(0.1111111111111111), lanes_add(lanes_add(lanes_add(_s4, lanes_mul(climb_6, sine_2)), lanes_mul(climb_7, sine_1)), lanes_mul(climb_8, sine_0))));
    const V _s6 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, cosine_8), lanes_mul(climb_1, cosine_7)), lanes_mul(climb_2, cosine_6)), lanes_mul(climb_3, cosine_5)), lanes_mul(climb_4, cosine_4)), lanes_mul(climb_5, cosine_3));
    const V _s7 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(omega_0, tilted_8), lanes_mul(omega_1, tilted_7)), lanes_mul(omega_2, tilted_6)), lanes_mul(omega_3, tilted_5)), lanes_mul(omega_4, tilted_4)), lanes_mul(omega_5, tilted_3));
    const V _s8 = lanes_mul(lanes_mul(K(0.1111111111111111), per_reach), lanes_add(lanes_mul(lanes_mul(_c0, cosine_8), _c2), lanes_add(lanes_add(lanes_add(_s7, lanes_mul(omega_6, tilted_2)), lanes_mul(omega_7, tilted_1)), lanes_mul(tilted_0, _s1))));
    const V _s9 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(sine_0, _s3), lanes_mul(sine_1, around_7)), lanes_mul(sine_2, around_6)), lanes_mul(sine_3, around_5)), lanes_mul(sine_4, around_4)), lanes_mul(sine_5, around_3));
    const V _s10 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, climb_8), lanes_mul(turn_rate_1, climb_7)), lanes_mul(turn_rate_2, climb_6)), lanes_mul(turn_rate_3, climb_5)), lanes_mul(turn_rate_4, climb_4)), lanes_mul(turn_rate_5, climb_3));
    const V _s11 = lanes_sub(lanes_mul(_c1, lanes_add(lanes_add(lanes_add(_s9, lanes_mul(sine_6, around_2)), lanes_mul(sine_7, around_1)), lanes_mul(sine_8, around_0))), lanes_mul(_c3, lanes_add(lanes_add(lanes_add(_s10, lanes_mul(turn_rate_6, climb_2)), lanes_mul(turn_rate_7, climb_1)), lanes_mul(turn_rate_8, climb_0))));
    const V _s12 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(cosine_0, _s3), lanes_mul(cosine_1, around_7)), lanes_mul(cosine_2, around_6)), lanes_mul(cosine_3, around_5)), lanes_mul(cosine_4, around_4)), lanes_mul(cosine_5, around_3));
    const V _s13 = lanes_add(lanes_mul(_c5, lanes_add(lanes_add(lanes_add(_s12, lanes_mul(cosine_6, around_2)), lanes_mul(cosine_7, around_1)), lanes_mul(cosine_8, around_0))), lanes_mul(_c1, _s3));
    return (LANES(court_ring_round_8_out)){ _s1, _s3, _s5, lanes_mul(K(0.1111111111111111), lanes_add(lanes_add(lanes_add(_s6, lanes_mul(climb_6, cosine_2)), lanes_mul(climb_7, cosine_1)), lanes_mul(climb_8, cosine_0))), lanes_neg(_s8), lanes_mul(K(0.1111111111111111), _s11), lanes_mul(_c4, _s3), lanes_mul(K(0.1111111111111111), _s13) };
}

/* Coefficients of order 10, from those of lower order.
   Routh's equations. 171 operations: 73 additions, 2 subtractions, 94 multiplications, 2 negations. */
typedef struct {
    V omega_9, around_9, cosine_10, sine_10, climb_10, along_10, turn_rate_10, tilted_10;
} LANES(court_ring_round_9_out);

LANES_INLINE LANES(court_ring_round_9_out)
LANES(court_ring_round_9)(V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V turn_rate_4, V turn_rate_5, V turn_rate_6, V turn_rate_7, V turn_rate_8, V turn_rate_9, V near_0, V climb_0, V climb_1, V climb_2, V climb_3, V climb_4, V climb_5, V climb_6, V climb_7, V climb_8, V climb_9, V cosine_0, V cosine_1, V cosine_2, V cosine_3, V cosine_4, V cosine_5, V cosine_6, V cosine_7, V cosine_8, V cosine_9, V sine_0, V sine_1, V sine_2, V sine_3, V sine_4, V sine_5, V sine_6, V sine_7, V sine_8, V sine_9, V along_9, V omega_0, V omega_1, V omega_2, V omega_3, V omega_4, V omega_5, V omega_6, V omega_7, V omega_8, V around_0, V around_1, V around_2, V around_3, V around_4, V around_5, V around_6, V around_7, V around_8, V tilted_0, V tilted_1, V tilted_2, V tilted_3, V tilted_4, V tilted_5, V tilted_6, V tilted_7, V tilted_8, V tilted_9, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(cosine_1, omega_8), lanes_mul(cosine_2, omega_7)), lanes_mul(cosine_3, omega_6)), lanes_mul(cosine_4, omega_5)), lanes_mul(cosine_5, omega_4)), lanes_mul(cosine_6, omega_3));
    const V _s1 = lanes_sub(along_9, lanes_mul(_c1, lanes_add(lanes_add(lanes_add(_s0, lanes_mul(cosine_7, omega_2)), lanes_mul(cosine_8, omega_1)), lanes_mul(cosine_9, omega_0))));
    const V _s2 = lanes_mul(near_0, _s1);
    const V _s3 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, _s2), lanes_mul(climb_1, omega_8)), lanes_mul(climb_2, omega_7)), lanes_mul(climb_3, omega_6)), lanes_mul(climb_4, omega_5)), lanes_mul(climb_5, omega_4));
    const V _s4 = lanes_add(lanes_add(lanes_add(lanes_add(_s3, lanes_mul(climb_6, omega_3)), lanes_mul(climb_7, omega_2)), lanes_mul(climb_8, omega_1)), lanes_mul(climb_9, omega_0));
    const V _s5 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, sine_9), lanes_mul(climb_1, sine_8)), lanes_mul(climb_2, sine_7)), lanes_mul(climb_3, sine_6)), lanes_mul(climb_4, sine_5)), lanes_mul(climb_5, sine_4));
    const V _s6 = lanes_mul(K(0.1), lanes_add(lanes_add(lanes_add(lanes_add(_s5, lanes_mul(climb_6, sine_3)), lanes_mul(climb_7, sine_2)), lanes_mul(climb_8, sine_1)), lanes_mul(climb_9, sine_0)));
    const V _s7 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, cosine_9), lanes_mul(climb_1, cosine_8)), lanes_mul(climb_2, cosine_7)), lanes_mul(climb_3, cosine_6)), lanes_mul(climb_4, cosine_5)), lanes_mul(climb_5, cosine_4));
    const V _s8 = lanes_mul(K(0.1), lanes_add(lanes_add(lanes_add(lanes_add(_s7, lanes_mul(climb_6, cosine_3)), lanes_mul(climb_7, cosine_2)), lanes_mul(climb_8, cosine_1)), lanes_mul(climb_9, cosine_0)));
    const V _s9 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(omega_0, tilted_9), lanes_mul(omega_1, tilted_8)), lanes_mul(omega_2, tilted_7)), lanes_mul(omega_3, tilted_6)), lanes_mul(omega_4, tilted_5)), lanes_mul(omega_5, tilted_4));
    const V _s10 = lanes_add(lanes_mul(lanes_mul(_c0, cosine_9), _c2), lanes_add(lanes_add(lanes_add(lanes_add(_s9, lanes_mul(omega_6, tilted_3)), lanes_mul(omega_7, tilted_2)), lanes_mul(omega_8, tilted_1)), lanes_mul(tilted_0, _s2)));
    const V _s11 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(sine_0, _s4), lanes_mul(sine_1, around_8)), lanes_mul(sine_2, around_7)), lanes_mul(sine_3, around_6)), lanes_mul(sine_4, around_5)), lanes_mul(sine_5, around_4));
    const V _s12 = lanes_mul(_c1, lanes_add(lanes_add(lanes_add(lanes_add(_s11, lanes_mul(sine_6, around_3)), lanes_mul(sine_7, around_2)), lanes_mul(sine_8, around_1)), lanes_mul(sine_9, around_0)));
    const V _s13 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, climb_9), lanes_mul(turn_rate_1, climb_8)), lanes_mul(turn_rate_2, climb_7)), lanes_mul(turn_rate_3, climb_6)), lanes_mul(turn_rate_4, climb_5)), lanes_mul(turn_rate_5, climb_4));
    const V _s14 = lanes_mul(_c3, lanes_add(lanes_add(lanes_add(lanes_add(_s13, lanes_mul(turn_rate_6, climb_3)), lanes_mul(turn_rate_7, climb_2)), lanes_mul(turn_rate_8, climb_1)), lanes_mul(turn_rate_9, climb_0)));
    const V _s15 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(cosine_0, _s4), lanes_mul(cosine_1, around_8)), lanes_mul(cosine_2, around_7)), lanes_mul(cosine_3, around_6)), lanes_mul(cosine_4, around_5)), lanes_mul(cosine_5, around_4));
    const V _s16 = lanes_mul(_c5, lanes_add(lanes_add(lanes_add(lanes_add(_s15, lanes_mul(cosine_6, around_3)), lanes_mul(cosine_7, around_2)), lanes_mul(cosine_8, around_1)), lanes_mul(cosine_9, around_0)));
    return (LANES(court_ring_round_9_out)){ _s2, _s4, lanes_neg(_s6), _s8, lanes_neg(lanes_mul(lanes_mul(K(0.1), per_reach), _s10)), lanes_mul(K(0.1), lanes_sub(_s12, _s14)), lanes_mul(_c4, _s4), lanes_mul(K(0.1), lanes_add(_s16, lanes_mul(_c1, _s4))) };
}

/* Coefficients of order 11, from those of lower order.
   Routh's equations. 187 operations: 81 additions, 2 subtractions, 102 multiplications, 2 negations. */
typedef struct {
    V omega_10, around_10, cosine_11, sine_11, climb_11, along_11, turn_rate_11, tilted_11;
} LANES(court_ring_round_10_out);

LANES_INLINE LANES(court_ring_round_10_out)
LANES(court_ring_round_10)(V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V turn_rate_4, V turn_rate_5, V turn_rate_6, V turn_rate_7, V turn_rate_8, V turn_rate_9, V turn_rate_10, V near_0, V climb_0, V climb_1, V climb_2, V climb_3, V climb_4, V climb_5, V climb_6, V climb_7, V climb_8, V climb_9, V climb_10, V cosine_0, V cosine_1, V cosine_2, V cosine_3, V cosine_4, V cosine_5, V cosine_6, V cosine_7, V cosine_8, V cosine_9, V cosine_10, V sine_0, V sine_1, V sine_2, V sine_3, V sine_4, V sine_5, V sine_6, V sine_7, V sine_8, V sine_9, V sine_10, V along_10, V omega_0, V omega_1, V omega_2, V omega_3, V omega_4, V omega_5, V omega_6, V omega_7, V omega_8, V omega_9, V around_0, V around_1, V around_2, V around_3, V around_4, V around_5, V around_6, V around_7, V around_8, V around_9, V tilted_0, V tilted_1, V tilted_2, V tilted_3, V tilted_4, V tilted_5, V tilted_6, V tilted_7, V tilted_8, V tilted_9, V tilted_10, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(cosine_1, omega_9), lanes_mul(cosine_2, omega_8)), lanes_mul(cosine_3, omega_7)), lanes_mul(cosine_4, omega_6)), lanes_mul(cosine_5, omega_5)), lanes_mul(cosine_6, omega_4));
    const V _s1 = lanes_mul(_c1, lanes_add(lanes_add(lanes_add(lanes_add(_s0, lanes_mul(cosine_7, omega_3)), lanes_mul(cosine_8, omega_2)), lanes_mul(cosine_9, omega_1)), lanes_mul(cosine_10, omega_0)));
    const V _s2 = lanes_mul(near_0, lanes_sub(along_10, _s1));
    const V _s3 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, _s2), lanes_mul(climb_1, omega_9)), lanes_mul(climb_2, omega_8)), lanes_mul(climb_3, omega_7)), lanes_mul(climb_4, omega_6)), lanes_mul(climb_5, omega_5));
    const V _s4 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s3, lanes_mul(climb_6, omega_4)), lanes_mul(climb_7, omega_3)), lanes_mul(climb_8, omega_2)), lanes_mul(climb_9, omega_1)), lanes_mul(climb_10, omega_0));
    const V _s5 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, sine_10), lanes_mul(climb_1, sine_9)), lanes_mul(climb_2, sine_8)), lanes_mul(climb_3, sine_7)), lanes_mul(climb_4, sine_6)), lanes_mul(climb_5, sine_5));
    const V _s6 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s5, lanes_mul(climb_6, sine_4)), lanes_mul(climb_7, sine_3)), lanes_mul(climb_8, sine_2)), lanes_mul(climb_9, sine_1)), lanes_mul(climb_10, sine_0));
    const V _s7 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, cosine_10), lanes_mul(climb_1, cosine_9)), lanes_mul(climb_2, cosine_8)), lanes_mul(climb_3, cosine_7)), lanes_mul(climb_4, cosine_6)), lanes_mul(climb_5, cosine_5));
    const V _s8 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s7, lanes_mul(climb_6, cosine_4)), lanes_mul(climb_7, cosine_3)), lanes_mul(climb_8, cosine_2)), lanes_mul(climb_9, cosine_1)), lanes_mul(climb_10, cosine_0));
    const V _s9 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(omega_0, tilted_10), lanes_mul(omega_1, tilted_9)), lanes_mul(omega_2, tilted_8)), lanes_mul(omega_3, tilted_7)), lanes_mul(omega_4, tilted_6)), lanes_mul(omega_5, tilted_5));
    const V _s10 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s9, lanes_mul(omega_6, tilted_4)), lanes_mul(omega_7, tilted_3)), lanes_mul(omega_8, tilted_2)), lanes_mul(omega_9, tilted_1)), lanes_mul(tilted_0, _s2));
    const V _s11 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(sine_0, _s4), lanes_mul(sine_1, around_9)), lanes_mul(sine_2, around_8)), lanes_mul(sine_3, around_7)), lanes_mul(sine_4, around_6)), lanes_mul(sine_5, around_5));
    const V _s12 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s11, lanes_mul(sine_6, around_4)), lanes_mul(sine_7, around_3)), lanes_mul(sine_8, around_2)), lanes_mul(sine_9, around_1)), lanes_mul(sine_10, around_0));
    const V _s13 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, climb_10), lanes_mul(turn_rate_1, climb_9)), lanes_mul(turn_rate_2, climb_8)), lanes_mul(turn_rate_3, climb_7)), lanes_mul(turn_rate_4, climb_6)), lanes_mul(turn_rate_5, climb_5));
    const V _s14 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s13, lanes_mul(turn_rate_6, climb_4)), lanes_mul(turn_rate_7, climb_3)), lanes_mul(turn_rate_8, climb_2)), lanes_mul(turn_rate_9, climb_1)), lanes_mul(turn_rate_10, climb_0));
    const V _s15 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(cosine_0, _s4), lanes_mul(cosine_1, around_9)), lanes_mul(cosine_2, around_8)), lanes_mul(cosine_3, around_7)), lanes_mul(cosine_4, around_6)), lanes_mul(cosine_5, around_5));
    const V _s16 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s15, lanes_mul(cosine_6, around_4)), lanes_mul(cosine_7, around_3)), lanes_mul(cosine_8, around_2)), lanes_mul(cosine_9, around_1)), lanes_mul(cosine_10, around_0));
    return (LANES(court_ring_round_10_out)){ _s2, _s4, lanes_neg(lanes_mul(K(0.09090909090909091), _s6)), lanes_mul(K(0.09090909090909091), _s8), lanes_neg(lanes_mul(lanes_mul(K(0.09090909090909091), per_reach), lanes_add(lanes_mul(lanes_mul(_c0, cosine_10), _c2), _s10))), lanes_mul(K(0.09090909090909091), lanes_sub(lanes_mul(_c1, _s12), lanes_mul(_c3, _s14))), lanes_mul(_c4, _s4), lanes_mul(K(0.09090909090909091), lanes_add(lanes_mul(_c5, _s16), lanes_mul(_c1, _s4))) };
}

/* Coefficients of order 12, from those of lower order.
   Routh's equations. 203 operations: 89 additions, 2 subtractions, 110 multiplications, 2 negations. */
typedef struct {
    V omega_11, around_11, cosine_12, sine_12, climb_12, along_12, turn_rate_12, tilted_12;
} LANES(court_ring_round_11_out);

LANES_INLINE LANES(court_ring_round_11_out)
LANES(court_ring_round_11)(V per_reach, V turn_rate_0, V turn_rate_1, V turn_rate_2, V turn_rate_3, V turn_rate_4, V turn_rate_5, V turn_rate_6, V turn_rate_7, V turn_rate_8, V turn_rate_9, V turn_rate_10, V turn_rate_11, V near_0, V climb_0, V climb_1, V climb_2, V climb_3, V climb_4, V climb_5, V climb_6, V climb_7, V climb_8, V climb_9, V climb_10, V climb_11, V cosine_0, V cosine_1, V cosine_2, V cosine_3, V cosine_4, V cosine_5, V cosine_6, V cosine_7, V cosine_8, V cosine_9, V cosine_10, V cosine_11, V sine_0, V sine_1, V sine_2, V sine_3, V sine_4, V sine_5, V sine_6, V sine_7, V sine_8, V sine_9, V sine_10, V sine_11, V along_11, V omega_0, V omega_1, V omega_2, V omega_3, V omega_4, V omega_5, V omega_6, V omega_7, V omega_8, V omega_9, V omega_10, V around_0, V around_1, V around_2, V around_3, V around_4, V around_5, V around_6, V around_7, V around_8, V around_9, V around_10, V tilted_0, V tilted_1, V tilted_2, V tilted_3, V tilted_4, V tilted_5, V tilted_6, V tilted_7, V tilted_8, V tilted_9, V tilted_10, V tilted_11, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(cosine_1, omega_10), lanes_mul(cosine_2, omega_9)), lanes_mul(cosine_3, omega_8)), lanes_mul(cosine_4, omega_7)), lanes_mul(cosine_5, omega_6)), lanes_mul(cosine_6, omega_5));
    const V _s1 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s0, lanes_mul(cosine_7, omega_4)), lanes_mul(cosine_8, omega_3)), lanes_mul(cosine_9, omega_2)), lanes_mul(cosine_10, omega_1)), lanes_mul(cosine_11, omega_0));
    const V _s2 = lanes_mul(near_0, lanes_sub(along_11, lanes_mul(_c1, _s1)));
    const V _s3 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, _s2), lanes_mul(climb_1, omega_10)), lanes_mul(climb_2, omega_9)), lanes_mul(climb_3, omega_8)), lanes_mul(climb_4, omega_7)), lanes_mul(climb_5, omega_6));
    const V _s4 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s3, lanes_mul(climb_6, omega_5)), lanes_mul(climb_7, omega_4)), lanes_mul(climb_8, omega_3)), lanes_mul(climb_9, omega_2)), lanes_mul(climb_10, omega_1));
    const V _s5 = lanes_add(_s4, lanes_mul(climb_11, omega_0));
    const V _s6 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, sine_11), lanes_mul(climb_1, sine_10)), lanes_mul(climb_2, sine_9)), lanes_mul(climb_3, sine_8)), lanes_mul(climb_4, sine_7)), lanes_mul(climb_5, sine_6));
    const V _s7 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s6, lanes_mul(climb_6, sine_5)), lanes_mul(climb_7, sine_4)), lanes_mul(climb_8, sine_3)), lanes_mul(climb_9, sine_2)), lanes_mul(climb_10, sine_1));
    const V _s8 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(climb_0, cosine_11), lanes_mul(climb_1, cosine_10)), lanes_mul(climb_2, cosine_9)), lanes_mul(climb_3, cosine_8)), lanes_mul(climb_4, cosine_7)), lanes_mul(climb_5, cosine_6));
    const V _s9 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s8, lanes_mul(climb_6, cosine_5)), lanes_mul(climb_7, cosine_4)), lanes_mul(climb_8, cosine_3)), lanes_mul(climb_9, cosine_2)), lanes_mul(climb_10, cosine_1));
    const V _s10 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(omega_0, tilted_11), lanes_mul(omega_1, tilted_10)), lanes_mul(omega_2, tilted_9)), lanes_mul(omega_3, tilted_8)), lanes_mul(omega_4, tilted_7)), lanes_mul(omega_5, tilted_6));
    const V _s11 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s10, lanes_mul(omega_6, tilted_5)), lanes_mul(omega_7, tilted_4)), lanes_mul(omega_8, tilted_3)), lanes_mul(omega_9, tilted_2)), lanes_mul(omega_10, tilted_1));
    const V _s12 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(sine_0, _s5), lanes_mul(sine_1, around_10)), lanes_mul(sine_2, around_9)), lanes_mul(sine_3, around_8)), lanes_mul(sine_4, around_7)), lanes_mul(sine_5, around_6));
    const V _s13 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s12, lanes_mul(sine_6, around_5)), lanes_mul(sine_7, around_4)), lanes_mul(sine_8, around_3)), lanes_mul(sine_9, around_2)), lanes_mul(sine_10, around_1));
    const V _s14 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(turn_rate_0, climb_11), lanes_mul(turn_rate_1, climb_10)), lanes_mul(turn_rate_2, climb_9)), lanes_mul(turn_rate_3, climb_8)), lanes_mul(turn_rate_4, climb_7)), lanes_mul(turn_rate_5, climb_6));
    const V _s15 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s14, lanes_mul(turn_rate_6, climb_5)), lanes_mul(turn_rate_7, climb_4)), lanes_mul(turn_rate_8, climb_3)), lanes_mul(turn_rate_9, climb_2)), lanes_mul(turn_rate_10, climb_1));
    const V _s16 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_mul(cosine_0, _s5), lanes_mul(cosine_1, around_10)), lanes_mul(cosine_2, around_9)), lanes_mul(cosine_3, around_8)), lanes_mul(cosine_4, around_7)), lanes_mul(cosine_5, around_6));
    const V _s17 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s16, lanes_mul(cosine_6, around_5)), lanes_mul(cosine_7, around_4)), lanes_mul(cosine_8, around_3)), lanes_mul(cosine_9, around_2)), lanes_mul(cosine_10, around_1));
    return (LANES(court_ring_round_11_out)){ _s2, _s5, lanes_neg(lanes_mul(K(0.08333333333333333), lanes_add(_s7, lanes_mul(climb_11, sine_0)))), lanes_mul(K(0.08333333333333333), lanes_add(_s9, lanes_mul(climb_11, cosine_0))), lanes_neg(lanes_mul(lanes_mul(K(0.08333333333333333), per_reach), lanes_add(lanes_mul(lanes_mul(_c0, cosine_11), _c2), lanes_add(_s11, lanes_mul(tilted_0, _s2))))), lanes_mul(K(0.08333333333333333), lanes_sub(lanes_mul(_c1, lanes_add(_s13, lanes_mul(sine_11, around_0))), lanes_mul(_c3, lanes_add(_s15, lanes_mul(turn_rate_11, climb_0))))), lanes_mul(_c4, _s5), lanes_mul(K(0.08333333333333333), lanes_add(lanes_mul(_c5, lanes_add(_s17, lanes_mul(cosine_11, around_0))), lanes_mul(_c1, _s5))) };
}

/* Whether the ball may do other than rise and drop through the hole.
   Table 1. 79 operations: 20 additions, 5 subtractions, 30 multiplications, 12 comparisons, 11 conjunctions, 1 complement. */
typedef struct {
    M unproved;
} LANES(court_ring_drops_through_out);

LANES_INLINE LANES(court_ring_drops_through_out)
LANES(court_ring_drops_through)(S x, S y, S z, S vx, S vy, S vz, S horizon, S extent, S speed, S position_error, S velocity_error, S _c0, S _c1, S _c2, S _c3, S _c4, S _c5, S _c6, S _c7, S _c8, S _c9)
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
    return (LANES(court_ring_drops_through_out)){ singles_truth(singles_not(singles_both(_s18, singles_less(singles_add(position_error, singles_mul(horizon, velocity_error)), _c9)))) };
}

/* First window that ends later than a time, from then on.
   Table 1. 18 operations: 6 comparisons, 3 disjunctions, 9 selections. */
typedef struct {
    V t, end;
    M searching;
} LANES(court_ring_enter_out);

LANES_INLINE LANES(court_ring_enter_out)
LANES(court_ring_enter)(V t, V end, V after, V low0, V low1, V low2, V high0, V high1, V high2)
{
    const V _s0 = lanes_max(after, low0);
    const M _s1 = lanes_less(_s0, high0);
    const V _s2 = lanes_max(after, low1);
    const M _s3 = lanes_less(_s2, high1);
    const V _s4 = lanes_max(after, low2);
    const M _s5 = lanes_less(_s4, high2);
    return (LANES(court_ring_enter_out)){ lanes_select(_s1, _s0, lanes_select(_s3, _s2, lanes_select(_s5, _s4, t))), lanes_select(_s1, high0, lanes_select(_s3, high1, lanes_select(_s5, high2, end))), lanes_either(lanes_either(lanes_either(mask_none(), _s5), _s3), _s1) };
}

/* Outward unit normal n3 at a contact.
   Table 2. 34 operations: 5 additions, 6 subtractions, 3 multiplications, 3 divisions, 1 square root, 2 negations, 7 comparisons, 7 selections. */
typedef struct {
    V nx, ny, nz;
} LANES(court_backboard_normal_out);

LANES_INLINE LANES(court_backboard_normal_out)
LANES(court_backboard_normal)(V x, V y, V z, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(_c0, x);
    const V _s1 = lanes_neg(lanes_add(_c4, x));
    const V _s2 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s3 = lanes_sub(y, _c1);
    const V _s4 = lanes_neg(lanes_add(_c1, y));
    const V _s5 = lanes_sub(lanes_max(_s3, K(0.0)), lanes_max(_s4, K(0.0)));
    const V _s6 = lanes_sub(z, _c3);
    const V _s7 = lanes_sub(_c2, z);
    const V _s8 = lanes_sub(lanes_max(_s6, K(0.0)), lanes_max(_s7, K(0.0)));
    const V _s9 = lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s2, _s2), lanes_mul(_s5, _s5)), lanes_mul(_s8, _s8)));
    const V _s10 = lanes_max(_s9, _c5);
    return (LANES(court_backboard_normal_out)){ lanes_div(_s2, _s10), lanes_div(_s5, _s10), lanes_div(_s8, _s10) };
}

/* Bound on the rate at which the normal turns along the contact surface.
   Table 2. 59 operations: 11 additions, 3 subtractions, 8 multiplications, 2 negations, 9 absolute values, 13 comparisons, 13 selections. */
typedef struct {
    V curvature;
} LANES(court_backboard_curvature_out);

LANES_INLINE LANES(court_backboard_curvature_out)
LANES(court_backboard_curvature)(V t, V x, V y, V z, V vx, V vy, V vz, V dx, V dy, V dz, V dvx, V dvy, V dvz, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6)
{
    const V _s0 = lanes_mul(K(2.0), t);
    const V _s1 = lanes_abs(dvx);
    const V _s2 = lanes_abs(dvy);
    const V _s3 = lanes_max(_s1, _s2);
    const V _s4 = lanes_abs(dvz);
    const V _s5 = lanes_abs(dx);
    const V _s6 = lanes_abs(dy);
    const V _s7 = lanes_max(_s5, _s6);
    const V _s8 = lanes_abs(dz);
    const V _s9 = lanes_mul(K(16.0), lanes_add(lanes_mul(t, lanes_max(_s3, _s4)), lanes_max(_s7, _s8)));
    const V _s10 = lanes_sub(z, _c3);
    const V _s11 = lanes_sub(_c2, z);
    const V _s12 = lanes_add(lanes_add(lanes_add(lanes_mul(_c4, lanes_mul(t, t)), lanes_mul(_s0, lanes_abs(vz))), _s9), lanes_max(_s10, _s11));
    const V _s13 = lanes_add(_c0, x);
    const V _s14 = lanes_neg(lanes_add(_c5, x));
    const V _s15 = lanes_add(lanes_add(lanes_mul(_s0, lanes_abs(vx)), _s9), lanes_max(_s13, _s14));
    const V _s16 = lanes_max(_s12, _s15);
    const V _s17 = lanes_sub(y, _c1);
    const V _s18 = lanes_neg(lanes_add(_c1, y));
    const V _s19 = lanes_add(lanes_add(lanes_mul(_s0, lanes_abs(vy)), _s9), lanes_max(_s17, _s18));
    const V _s20 = lanes_max(_s19, _s12);
    const V _s21 = lanes_max(_s15, _s19);
    const V _s22 = lanes_min(_s20, _s21);
    return (LANES(court_backboard_curvature_out)){ lanes_select(lanes_less(lanes_min(_s16, _s22), K(0.0)), K(0.0), _c6) };
}

/* Tangent and curvatures at a contact, and bounds on the roundings there.
   Table 2, running error analysis. 165 operations: 37 additions, 11 subtractions, 41 multiplications, 3 divisions, 1 square root, 3 negations, 20 absolute values, 23 comparisons, 2 conjunctions, 24 selections. */
typedef struct {
    S tangent_x, tangent_y, bend_s, bend_e, sharpest_bend, root_offset, root_level, normal_rounding;
} LANES(court_backboard_tangents_out);

LANES_INLINE LANES(court_backboard_tangents_out)
LANES(court_backboard_tangents)(S t, S x, S y, S z, S vx, S vy, S vz, S nx, S ny, S nz, S place_n, S normal_velocity, S back, S _c0, S _c1, S _c2, S _c3, S _c4, S _c5, S _c6, S _c7, S _c8, S _c9, S _c10, S _c11, S _c12, S _c13, S _c14, S _c15)
{
    const S _s0 = singles_sqrt(singles_add(singles_mul(nx, nx), singles_mul(ny, ny)));
    const Q _s1 = singles_less(KS(0.0), _s0);
    const S _s2 = singles_div(KS(1.0), _s0);
    const S _s3 = singles_sub(z, _c4);
    const S _s4 = singles_sub(_c3, z);
    const S _s5 = singles_abs(singles_sub(singles_max(_s3, KS(0.0)), singles_max(_s4, KS(0.0))));
    const S _s6 = singles_add(_c1, x);
    const S _s7 = singles_neg(singles_add(_c7, x));
    const S _s8 = singles_abs(singles_sub(singles_max(_s6, KS(0.0)), singles_max(_s7, KS(0.0))));
    const S _s9 = singles_sub(y, _c2);
    const S _s10 = singles_neg(singles_add(_c2, y));
    const S _s11 = singles_abs(singles_sub(singles_max(_s9, KS(0.0)), singles_max(_s10, KS(0.0))));
    const S _s12 = singles_select(singles_both(singles_less(KS(0.0), _s8), singles_less(KS(0.0), _s11)), singles_mul(_c6, _s2), KS(0.0));
    const S _s13 = singles_abs(_s3);
    const S _s14 = singles_abs(singles_sub(z, _c3));
    const S _s15 = singles_abs(_s9);
    const S _s16 = singles_abs(singles_sub(y, _c8));
    const S _s17 = singles_abs(singles_sub(x, _c9));
    const S _s18 = singles_abs(singles_sub(x, _c10));
    const S _s19 = singles_min(_s17, _s18);
    const S _s20 = singles_min(_s16, _s19);
    const S _s21 = singles_min(_s15, _s20);
    const S _s22 = singles_min(_s14, _s21);
    const S _s23 = singles_sub(singles_min(_s13, _s22), _c11);
    const S _s24 = singles_max(_c6, _s12);
    const S _s25 = singles_div(KS(1.0), singles_mul(KS(50.0), _s23));
    const S _s26 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_mul(t, singles_abs(normal_velocity))));
    const S _s27 = singles_mul(t, t);
    const S _s28 = singles_abs(vx);
    const S _s29 = singles_abs(vy);
    const S _s30 = singles_add(singles_mul(_c5, _s27), singles_mul(t, singles_add(singles_add(_s28, _s29), singles_abs(vz))));
    const S _s31 = singles_mul(KS(2.0), t);
    const S _s32 = singles_add(_c12, singles_mul(KS(1.1102230246251565e-16), _s8));
    const S _s33 = singles_add(singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s31, _s28), singles_abs(x)))), singles_mul(KS(2.0), _s32));
    const S _s34 = singles_mul(KS(1.1102230246251565e-16), _s11);
    const S _s35 = singles_add(singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s31, _s29), singles_abs(y)))), singles_mul(KS(2.0), _s34));
    const S _s36 = singles_add(singles_add(singles_mul(_c13, _s27), singles_mul(_s31, singles_abs(singles_add(vz, singles_mul(_c13, t))))), singles_abs(z));
    const S _s37 = singles_mul(KS(1.1102230246251565e-16), _s5);
    const S _s38 = singles_add(singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), _s36)), singles_mul(KS(2.0), _s37));
    const S _s39 = singles_add(singles_mul(singles_mul(_c6, _s30), singles_add(singles_add(_s33, _s35), _s38)), singles_mul(KS(1.3322676295501878e-15), _s30));
    const S _s40 = singles_mul(KS(1.125), _s39);
    const S _s41 = singles_mul(KS(1.7763568394002505e-15), singles_mul(_c0, singles_div(singles_mul(normal_velocity, normal_velocity), singles_add(singles_add(singles_mul(vx, vx), singles_mul(vy, vy)), singles_mul(vz, vz)))));
    const S _s42 = singles_add(singles_add(_s26, _s39), singles_max(_s40, _s41));
    const S _s43 = singles_add(_c14, singles_add(singles_add(singles_mul(singles_abs(nx), _s33), singles_mul(singles_abs(ny), _s35)), singles_mul(singles_abs(nz), _s38)));
    const S _s44 = singles_mul(KS(1.125), _s43);
    const S _s45 = singles_add(singles_add(_s26, _s43), singles_max(_s44, _s41));
    const S _s46 = singles_add(place_n, _s45);
    const Q _s47 = singles_less(KS(0.0), back);
    const S _s48 = singles_add(place_n, _s42);
    return (LANES(court_backboard_tangents_out)){ singles_select(_s1, singles_neg(singles_mul(ny, _s2)), KS(0.0)), singles_select(_s1, singles_mul(nx, _s2), KS(1.0)), singles_select(singles_both(singles_less(KS(0.0), _s5), _s1), _c6, KS(0.0)), _s12, singles_select(singles_less(KS(0.0), _s23), singles_max(_s24, _s25), KS(INFINITY)), singles_select(_s47, singles_max(_s42, _s46), _s45), singles_select(_s47, singles_max(_s48, _s45), _s45), singles_add(KS(8.881784197001252e-16), singles_mul(_c15, singles_add(singles_add(_s32, _s34), _s37))) };
}

/* Error of the normal, from that of the position.
   derivative of Table 2's normal. 98 operations: 10 additions, 12 subtractions, 17 multiplications, 7 divisions, 1 square root, 5 negations, 23 comparisons, 23 selections. */
typedef struct {
    V dnx, dny, dnz, turn;
} LANES(court_backboard_carry_normal_out);

LANES_INLINE LANES(court_backboard_carry_normal_out)
LANES(court_backboard_carry_normal)(V x, V y, V z, V dx, V dy, V dz, V shift, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6)
{
    const V _s0 = lanes_add(_c0, x);
    const V _s1 = lanes_neg(lanes_add(_c4, x));
    const V _s2 = lanes_sub(lanes_select(lanes_less(_s0, K(0.0)), K(0.0), dx), lanes_select(lanes_less(_s1, K(0.0)), K(0.0), lanes_neg(dx)));
    const V _s3 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s4 = lanes_sub(y, _c1);
    const V _s5 = lanes_neg(lanes_add(_c1, y));
    const V _s6 = lanes_sub(lanes_max(_s4, K(0.0)), lanes_max(_s5, K(0.0)));
    const V _s7 = lanes_sub(z, _c3);
    const V _s8 = lanes_sub(_c2, z);
    const V _s9 = lanes_sub(lanes_max(_s7, K(0.0)), lanes_max(_s8, K(0.0)));
    const V _s10 = lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s3, _s3), lanes_mul(_s6, _s6)), lanes_mul(_s9, _s9)));
    const V _s11 = lanes_max(_s10, _c5);
    const V _s12 = lanes_sub(lanes_select(lanes_less(_s4, K(0.0)), K(0.0), dy), lanes_select(lanes_less(_s5, K(0.0)), K(0.0), lanes_neg(dy)));
    const V _s13 = lanes_sub(lanes_select(lanes_less(_s7, K(0.0)), K(0.0), dz), lanes_select(lanes_less(_s8, K(0.0)), K(0.0), lanes_neg(dz)));
    const V _s14 = lanes_mul(lanes_mul(K(0.5), lanes_add(lanes_add(lanes_mul(lanes_mul(K(2.0), _s2), _s3), lanes_mul(lanes_mul(K(2.0), _s12), _s6)), lanes_mul(lanes_mul(K(2.0), _s13), _s9))), lanes_div(K(1.0), _s10));
    const V _s15 = lanes_select(lanes_less(_s10, _c5), K(0.0), _s14);
    const V _s16 = lanes_mul(_s11, _s11);
    const V _s17 = lanes_mul(K(16.0), shift);
    const V _s18 = lanes_add(_s17, lanes_max(_s7, _s8));
    const V _s19 = lanes_add(_s17, lanes_max(_s0, _s1));
    const V _s20 = lanes_max(_s18, _s19);
    const V _s21 = lanes_add(_s17, lanes_max(_s4, _s5));
    const V _s22 = lanes_max(_s21, _s18);
    const V _s23 = lanes_max(_s19, _s21);
    const V _s24 = lanes_min(_s22, _s23);
    return (LANES(court_backboard_carry_normal_out)){ lanes_sub(lanes_div(_s2, _s11), lanes_div(lanes_mul(_s3, _s15), _s16)), lanes_sub(lanes_div(_s12, _s11), lanes_div(lanes_mul(_s6, _s15), _s16)), lanes_sub(lanes_div(_s13, _s11), lanes_div(lanes_mul(_s9, _s15), _s16)), lanes_mul(shift, lanes_select(lanes_less(lanes_min(_s20, _s24), K(0.0)), K(0.0), _c6)) };
}

/* Constants and windows of the search along a flight, and its error budget.
   bounds of the event condition. 109 operations: 20 additions, 8 subtractions, 22 multiplications, 4 divisions, 3 square roots, 4 negations, 2 absolute values, 22 comparisons, 24 selections. */
typedef struct {
    V low0, high0, low1, high1, ceiling, latest, budget_exceeded;
} LANES(court_backboard_prepare_out);

LANES_INLINE LANES(court_backboard_prepare_out)
LANES(court_backboard_prepare)(V horizon, V x, V y, V z, V vx, V vy, V vz, V extent, V speed, V position_error, V velocity_error, V earliest_delay, V pad, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7, V _c8, V _c9, V _c10, V _c11, V _c12, V _c13, V _c14)
{
    const V _s0 = lanes_abs(vx);
    const V _s1 = lanes_add(_c5, x);
    const V _s2 = lanes_select(lanes_less(vx, K(0.0)), lanes_neg(_s1), _s1);
    const V _s3 = lanes_div(lanes_neg(lanes_add(_c4, _s2)), _s0);
    const V _s4 = lanes_max(K(0.0), _s3);
    const V _s5 = lanes_abs(vy);
    const V _s6 = lanes_select(lanes_less(vy, K(0.0)), lanes_neg(y), y);
    const V _s7 = lanes_div(lanes_neg(lanes_add(_c6, _s6)), _s5);
    const V _s8 = lanes_max(_s4, _s7);
    const V _s9 = lanes_mul(vz, vz);
    const V _s10 = lanes_sub(lanes_sub(z, _c2), _c1);
    const V _s11 = lanes_add(_s9, lanes_mul(_c8, lanes_add(_s10, _c7)));
    const V _s12 = lanes_sqrt(_s11);
    const M _s13 = lanes_at_most(K(0.0), _s11);
    const V _s14 = lanes_select(_s13, lanes_mul(_c9, lanes_sub(vz, _s12)), K(INFINITY));
    const V _s15 = lanes_max(_s8, _s14);
    const V _s16 = lanes_add(_s9, lanes_mul(_c8, lanes_sub(_s10, _c7)));
    const V _s17 = lanes_sqrt(lanes_max(_s16, K(0.0)));
    const V _s18 = lanes_select(_s13, lanes_mul(_c9, lanes_add(vz, _s12)), K(-INFINITY));
    const M _s19 = lanes_less(K(0.0), _s16);
    const V _s20 = lanes_select(_s19, lanes_mul(_c9, lanes_sub(vz, _s17)), _s18);
    const V _s21 = lanes_div(lanes_sub(_c6, _s6), _s5);
    const V _s22 = lanes_div(lanes_sub(_c4, _s2), _s0);
    const V _s23 = lanes_min(_s22, K(INFINITY));
    const V _s24 = lanes_min(_s21, _s23);
    const V _s25 = lanes_min(_s20, _s24);
    const V _s26 = lanes_select(_s19, lanes_mul(_c9, lanes_add(vz, _s17)), K(INFINITY));
    const V _s27 = lanes_max(_s8, _s26);
    const V _s28 = lanes_min(_s18, _s24);
    const V _s29 = lanes_max(K(0.0), _s25);
    const V _s30 = lanes_max(_s29, _s28);
    const V _s31 = lanes_min(_s30, horizon);
    const V _s32 = lanes_add(speed, lanes_mul(_c0, _s31));
    const V _s33 = lanes_add(lanes_add(lanes_add(_c5, extent), _c12), _c13);
    const V _s34 = lanes_add(lanes_mul(_c11, lanes_sqrt(lanes_mul(_c9, lanes_add(_s33, _c3)))), lanes_mul(lanes_mul(K(2.0), speed), _c9));
    const V _s35 = lanes_add(lanes_add(lanes_add(position_error, lanes_mul(velocity_error, lanes_min(_s34, horizon))), lanes_mul(K(3.552713678800501e-15), lanes_add(lanes_mul(lanes_mul(speed, speed), _c9), _s33))), lanes_select(lanes_less(lanes_mul(K(2.0), pad), earliest_delay), lanes_mul(earliest_delay, lanes_add(speed, lanes_mul(_c0, horizon))), K(0.0)));
    return (LANES(court_backboard_prepare_out)){ lanes_max(K(0.0), _s15), lanes_min(_s25, horizon), lanes_max(K(0.0), _s27), lanes_min(_s28, horizon), lanes_mul(K(2.0), lanes_add(_c10, lanes_mul(K(3.0), lanes_mul(_s32, _s32)))), _s31, lanes_sub(_s35, _c14) };
}

/* Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.
   running error analysis. 52 operations: 25 additions, 27 multiplications. */
typedef struct {
    V margin, leaving_margin, rate_margin;
} LANES(court_backboard_margins_out);

LANES_INLINE LANES(court_backboard_margins_out)
LANES(court_backboard_margins)(V horizon, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7, V _c8, V _c9, V _c10, V _c11)
{
    const V _s0 = lanes_add(speed, lanes_mul(_c0, horizon));
    const V _s1 = lanes_add(extent, lanes_mul(horizon, _s0));
    const V _s2 = lanes_mul(K(2.220446049250313e-16), _s1);
    const V _s3 = lanes_mul(K(2.0), lanes_add(lanes_add(position_error, lanes_mul(horizon, velocity_error)), lanes_mul(K(4.440892098500626e-16), _s1)));
    const V _s4 = lanes_add(lanes_add(_c3, _s2), _s3);
    const V _s5 = lanes_add(lanes_add(_c5, lanes_mul(K(3.3306690738754696e-16), _s1)), _s3);
    const V _s6 = lanes_add(lanes_add(_c6, _s2), _s3);
    const V _s7 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_c1, lanes_mul(_c4, _s4)), lanes_mul(_c4, _s5)), lanes_mul(_c4, _s6)), lanes_mul(lanes_mul(lanes_mul(K(1.3335686721571705e-15), horizon), _c2), _s0)), _c7);
    const V _s8 = lanes_mul(K(4.00390625), _s0);
    const V _s9 = lanes_add(lanes_add(lanes_add(lanes_mul(_c8, _s0), lanes_mul(_c9, lanes_add(velocity_error, lanes_mul(K(3.3306690738754696e-16), _s0)))), lanes_mul(_s8, _s4)), lanes_mul(_s8, _s5));
    const V _s10 = lanes_mul(K(2.001953125), _s0);
    const V _s11 = lanes_add(lanes_add(lanes_add(lanes_mul(_c10, _s0), lanes_mul(_c11, lanes_add(velocity_error, lanes_mul(K(2.220446049250313e-16), _s0)))), lanes_mul(_s10, _s4)), lanes_mul(_s10, _s5));
    return (LANES(court_backboard_margins_out)){ _s7, lanes_add(_s9, lanes_mul(_s8, _s6)), lanes_add(_s11, lanes_mul(_s10, _s6)) };
}

/* Newton's next value of a root near t, and gap and rate there.
   Newton's method. 98 operations: 18 additions, 19 subtractions, 24 multiplications, 1 division, 4 negations, 16 comparisons, 16 selections. */
typedef struct {
    V time, gap, rate;
} LANES(court_backboard_refine_out);

LANES_INLINE LANES(court_backboard_refine_out)
LANES(court_backboard_refine)(V t, V leaving, V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7)
{
    const V _s0 = lanes_add(x, lanes_mul(vx, t));
    const V _s1 = lanes_add(_c0, _s0);
    const V _s2 = lanes_neg(lanes_add(_c5, _s0));
    const V _s3 = lanes_sub(lanes_max(_s1, K(0.0)), lanes_max(_s2, K(0.0)));
    const V _s4 = lanes_add(y, lanes_mul(vy, t));
    const V _s5 = lanes_sub(_s4, _c1);
    const V _s6 = lanes_neg(lanes_add(_c1, _s4));
    const V _s7 = lanes_sub(lanes_max(_s5, K(0.0)), lanes_max(_s6, K(0.0)));
    const V _s8 = lanes_sub(vz, lanes_mul(_c6, t));
    const V _s9 = lanes_add(z, lanes_mul(t, _s8));
    const V _s10 = lanes_sub(_s9, _c3);
    const V _s11 = lanes_sub(_c2, _s9);
    const V _s12 = lanes_sub(lanes_max(_s10, K(0.0)), lanes_max(_s11, K(0.0)));
    const V _s13 = lanes_mul(K(2.0), lanes_add(lanes_add(lanes_mul(vx, _s3), lanes_mul(vy, _s7)), lanes_mul(lanes_sub(vz, lanes_mul(_c4, t)), _s12)));
    const V _s14 = lanes_add(_c0, x);
    const V _s15 = lanes_neg(lanes_add(_c5, x));
    const V _s16 = lanes_sub(lanes_max(_s14, K(0.0)), lanes_max(_s15, K(0.0)));
    const V _s17 = lanes_mul(_s3, _s3);
    const V _s18 = lanes_sub(y, _c1);
    const V _s19 = lanes_neg(lanes_add(_c1, y));
    const V _s20 = lanes_sub(lanes_max(_s18, K(0.0)), lanes_max(_s19, K(0.0)));
    const V _s21 = lanes_mul(_s7, _s7);
    const V _s22 = lanes_sub(z, _c3);
    const V _s23 = lanes_sub(_c2, z);
    const V _s24 = lanes_sub(lanes_max(_s22, K(0.0)), lanes_max(_s23, K(0.0)));
    const V _s25 = lanes_mul(_s12, _s12);
    const V _s26 = lanes_add(lanes_add(lanes_select(lanes_less(K(0.0), lanes_mul(_s16, _s3)), lanes_mul(t, lanes_mul(vx, lanes_add(_s16, _s3))), lanes_sub(_s17, lanes_mul(_s16, _s16))), lanes_select(lanes_less(K(0.0), lanes_mul(_s20, _s7)), lanes_mul(t, lanes_mul(vy, lanes_add(_s20, _s7))), lanes_sub(_s21, lanes_mul(_s20, _s20)))), lanes_select(lanes_less(K(0.0), lanes_mul(_s24, _s12)), lanes_mul(t, lanes_mul(_s8, lanes_add(_s24, _s12))), lanes_sub(_s25, lanes_mul(_s24, _s24))));
    const V _s27 = lanes_select(lanes_less(K(0.0), leaving), _s26, lanes_sub(lanes_add(lanes_add(_s17, _s21), _s25), _c7));
    return (LANES(court_backboard_refine_out)){ lanes_sub(t, lanes_div(_s27, _s13)), _s27, _s13 };
}

/* Gap, rate, second derivative, a step without a root, its end, and the clearance.
   Newton from the left under a curvature bound. 171 operations: 28 additions, 24 subtractions, 42 multiplications, 2 divisions, 1 square root, 7 negations, 4 absolute values, 30 comparisons, 33 selections. */
typedef struct {
    V gap, rate, bend, step, next, clearance;
} LANES(court_backboard_advance_out);

LANES_INLINE LANES(court_backboard_advance_out)
LANES(court_backboard_advance)(V t, V end, V leaving, V margin, V rate_margin, V ceiling, V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7, V _c8, V _c9, V _c10)
{
    const V _s0 = lanes_add(_c0, x);
    const V _s1 = lanes_neg(lanes_add(_c5, x));
    const V _s2 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s3 = lanes_add(x, lanes_mul(vx, t));
    const V _s4 = lanes_add(_c0, _s3);
    const V _s5 = lanes_neg(lanes_add(_c5, _s3));
    const V _s6 = lanes_sub(lanes_max(_s4, K(0.0)), lanes_max(_s5, K(0.0)));
    const V _s7 = lanes_mul(_s6, _s6);
    const V _s8 = lanes_sub(y, _c1);
    const V _s9 = lanes_neg(lanes_add(_c1, y));
    const V _s10 = lanes_sub(lanes_max(_s8, K(0.0)), lanes_max(_s9, K(0.0)));
    const V _s11 = lanes_add(y, lanes_mul(vy, t));
    const V _s12 = lanes_sub(_s11, _c1);
    const V _s13 = lanes_neg(lanes_add(_c1, _s11));
    const V _s14 = lanes_sub(lanes_max(_s12, K(0.0)), lanes_max(_s13, K(0.0)));
    const V _s15 = lanes_mul(_s14, _s14);
    const V _s16 = lanes_sub(z, _c3);
    const V _s17 = lanes_sub(_c2, z);
    const V _s18 = lanes_sub(lanes_max(_s16, K(0.0)), lanes_max(_s17, K(0.0)));
    const V _s19 = lanes_sub(vz, lanes_mul(_c6, t));
    const V _s20 = lanes_add(z, lanes_mul(t, _s19));
    const V _s21 = lanes_sub(_s20, _c3);
    const V _s22 = lanes_sub(_c2, _s20);
    const V _s23 = lanes_sub(lanes_max(_s21, K(0.0)), lanes_max(_s22, K(0.0)));
    const V _s24 = lanes_mul(_s23, _s23);
    const V _s25 = lanes_add(lanes_add(lanes_select(lanes_less(K(0.0), lanes_mul(_s2, _s6)), lanes_mul(t, lanes_mul(vx, lanes_add(_s2, _s6))), lanes_sub(_s7, lanes_mul(_s2, _s2))), lanes_select(lanes_less(K(0.0), lanes_mul(_s10, _s14)), lanes_mul(t, lanes_mul(vy, lanes_add(_s10, _s14))), lanes_sub(_s15, lanes_mul(_s10, _s10)))), lanes_select(lanes_less(K(0.0), lanes_mul(_s18, _s23)), lanes_mul(t, lanes_mul(_s19, lanes_add(_s18, _s23))), lanes_sub(_s24, lanes_mul(_s18, _s18))));
    const V _s26 = lanes_select(lanes_less(K(0.0), leaving), _s25, lanes_sub(lanes_add(lanes_add(_s7, _s15), _s24), _c7));
    const V _s27 = lanes_sub(vz, lanes_mul(_c4, t));
    const V _s28 = lanes_mul(K(2.0), lanes_add(lanes_add(lanes_mul(vx, _s6), lanes_mul(vy, _s14)), lanes_mul(_s27, _s23)));
    const V _s29 = lanes_abs(_s23);
    const V _s30 = lanes_mul(K(2.0), lanes_add(lanes_add(lanes_select(lanes_less(K(0.0), lanes_abs(_s6)), lanes_mul(vx, vx), K(0.0)), lanes_select(lanes_less(K(0.0), lanes_abs(_s14)), lanes_mul(vy, vy), K(0.0))), lanes_select(lanes_less(K(0.0), _s29), lanes_sub(lanes_mul(_s27, _s27), lanes_mul(_c4, _s23)), K(0.0))));
    const V _s31 = lanes_sub(_s28, rate_margin);
    const V _s32 = lanes_sub(_s26, margin);
    const V _s33 = lanes_max(_s32, K(0.0));
    const V _s34 = lanes_neg(_s30);
    const M _s35 = lanes_less(_s31, K(0.0));
    const V _s36 = lanes_mul(K(2.0), _s33);
    const V _s37 = lanes_select(lanes_less(K(0.0), lanes_select(lanes_at_most(K(0.0), _s31), _s33, K(0.0))), K(INFINITY), lanes_div(lanes_select(_s35, _s36, lanes_mul(K(4.0), _s31)), lanes_select(_s35, lanes_neg(_s31), lanes_max(K(0.0), _s34))));
    const V _s38 = lanes_sub(end, t);
    const V _s39 = lanes_min(_s37, _s38);
    const V _s40 = lanes_add(lanes_mul(lanes_add(lanes_mul(_c10, _s39), lanes_abs(_s27)), _s39), _s29);
    const V _s41 = lanes_add(lanes_mul(K(9.094947017729282e-13), ceiling), lanes_mul(K(2.0), lanes_mul(_c8, lanes_min(_c9, _s40))));
    const V _s42 = lanes_add(lanes_mul(lanes_mul(K(2.0), _s41), _s33), lanes_mul(_s31, _s31));
    const V _s43 = lanes_sqrt(_s42);
    const V _s44 = lanes_select(lanes_at_most(K(0.0), _s42), lanes_div(lanes_select(_s35, _s36, lanes_add(_s31, _s43)), lanes_select(_s35, lanes_sub(_s43, _s31), lanes_max(K(0.0), _s41))), K(INFINITY));
    const V _s45 = lanes_min(_s44, _s39);
    const V _s46 = lanes_neg(lanes_add(rate_margin, _s28));
    return (LANES(court_backboard_advance_out)){ _s26, _s28, _s30, _s45, lanes_add(t, _s45), lanes_select(lanes_less(K(0.0), _s46), lanes_sub(lanes_mul(_s46, _s46), lanes_mul(lanes_mul(K(8.0), ceiling), lanes_add(margin, _s36))), _s46) };
}

/* Whether a flight may reach the box of a surface at all.
   disjoint boxes. 23 operations: 5 additions, 2 subtractions, 5 multiplications, 5 comparisons, 1 conjunction, 2 complements, 3 selections. */
typedef struct {
    M near;
} LANES(court_backboard_near_out);

LANES_INLINE LANES(court_backboard_near_out)
LANES(court_backboard_near)(V horizon, V x, V vx, V extent, V speed, V position_error, V velocity_error, V earliest_delay, V pad, V _c0, V _c1, V _c2)
{
    const V _s0 = lanes_add(lanes_add(position_error, lanes_mul(horizon, velocity_error)), lanes_mul(K(9.313225746154785e-10), lanes_add(extent, lanes_mul(horizon, lanes_add(speed, lanes_mul(_c0, horizon))))));
    const V _s1 = lanes_select(lanes_less(pad, earliest_delay), K(INFINITY), _s0);
    const V _s2 = lanes_add(x, lanes_mul(vx, horizon));
    return (LANES(court_backboard_near_out)){ lanes_both(lanes_not(lanes_less(_s1, lanes_sub(lanes_min(_s2, x), _c1))), lanes_not(lanes_less(_s1, lanes_sub(_c2, lanes_max(x, _s2))))) };
}

/* Whether a flight that comes near a surface may come to it.
   a separating direction. 73 operations: 16 additions, 7 subtractions, 18 multiplications, 3 negations, 3 absolute values, 13 comparisons, 3 conjunctions, 2 disjunctions, 1 complement, 7 selections. */
typedef struct {
    M near;
} LANES(court_backboard_approaches_out);

LANES_INLINE LANES(court_backboard_approaches_out)
LANES(court_backboard_approaches)(V leaving, V horizon, V x, V y, V z, V vx, V vy, V vz, V extent, V speed, V position_error, V velocity_error, V earliest_delay, V pad, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6)
{
    const V _s0 = lanes_add(_c0, x);
    const V _s1 = lanes_neg(lanes_add(_c6, x));
    const V _s2 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s3 = lanes_sub(y, _c1);
    const V _s4 = lanes_neg(lanes_add(_c1, y));
    const V _s5 = lanes_sub(lanes_max(_s3, K(0.0)), lanes_max(_s4, K(0.0)));
    const V _s6 = lanes_sub(z, _c3);
    const V _s7 = lanes_sub(_c2, z);
    const V _s8 = lanes_sub(lanes_max(_s6, K(0.0)), lanes_max(_s7, K(0.0)));
    const V _s9 = lanes_add(lanes_add(lanes_abs(_s2), lanes_abs(_s5)), lanes_abs(_s8));
    const V _s10 = lanes_add(position_error, lanes_mul(K(9.313225746154785e-10), lanes_add(extent, _s9)));
    const M _s11 = lanes_both(lanes_either(lanes_at_most(K(1.0), leaving), lanes_less(lanes_add(_c5, lanes_mul(K(4.0), lanes_mul(_s10, _s9))), lanes_add(lanes_add(lanes_mul(_s2, _s2), lanes_mul(_s5, _s5)), lanes_mul(_s8, _s8)))), lanes_at_most(earliest_delay, pad));
    const V _s12 = lanes_mul(K(4.0), lanes_add(lanes_mul(velocity_error, _s9), lanes_mul(_s10, lanes_add(velocity_error, lanes_add(speed, lanes_mul(_c4, horizon))))));
    const V _s13 = lanes_mul(lanes_mul(K(0.5), horizon), lanes_neg(lanes_mul(_c4, _s8)));
    const M _s14 = lanes_at_most(lanes_add(lanes_sub(lanes_add(lanes_add(lanes_mul(vx, _s2), lanes_mul(vy, _s5)), lanes_mul(vz, _s8)), _s12), lanes_min(_s13, K(0.0))), K(0.0));
    const M _s15 = lanes_either(lanes_not(lanes_both(lanes_both(_s11, lanes_at_most(position_error, lanes_mul(K(2.9802322387695312e-08), extent))), lanes_at_most(velocity_error, lanes_mul(K(2.9802322387695312e-08), speed)))), _s14);
    return (LANES(court_backboard_approaches_out)){ _s15 };
}

/* Distance, its rate, and a bound on how fast it bends down, by the squared speed.
   Table 2. 58 operations: 7 additions, 10 subtractions, 10 multiplications, 1 division, 1 square root, 5 negations, 12 comparisons, 12 selections. */
typedef struct {
    V gap, nearing, gap_curvature;
} LANES(court_backboard_beside_out);

LANES_INLINE LANES(court_backboard_beside_out)
LANES(court_backboard_beside)(V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(_c2, x);
    const V _s1 = lanes_neg(lanes_add(_c5, x));
    const V _s2 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s3 = lanes_sub(y, _c3);
    const V _s4 = lanes_neg(lanes_add(_c3, y));
    const V _s5 = lanes_sub(lanes_max(_s3, K(0.0)), lanes_max(_s4, K(0.0)));
    const V _s6 = lanes_sub(z, _c4);
    const V _s7 = lanes_sub(_c1, z);
    const V _s8 = lanes_sub(lanes_max(_s6, K(0.0)), lanes_max(_s7, K(0.0)));
    const V _s9 = lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s2, _s2), lanes_mul(_s5, _s5)), lanes_mul(_s8, _s8)));
    const V _s10 = lanes_add(lanes_mul(lanes_mul(K(2.0), lanes_sub(lanes_select(lanes_less(_s0, K(0.0)), K(0.0), vx), lanes_select(lanes_less(_s1, K(0.0)), K(0.0), lanes_neg(vx)))), _s2), lanes_mul(lanes_mul(K(2.0), lanes_sub(lanes_select(lanes_less(_s3, K(0.0)), K(0.0), vy), lanes_select(lanes_less(_s4, K(0.0)), K(0.0), lanes_neg(vy)))), _s5));
    const V _s11 = lanes_add(_s10, lanes_mul(lanes_mul(K(2.0), lanes_sub(lanes_select(lanes_less(_s6, K(0.0)), K(0.0), vz), lanes_select(lanes_less(_s7, K(0.0)), K(0.0), lanes_neg(vz)))), _s8));
    return (LANES(court_backboard_beside_out)){ lanes_sub(_s9, _c0), lanes_div(lanes_mul(K(0.5), _s11), _s9), K(0.0) };
}

/* Distance of a ball that rolls on another surface, and its first two derivatives.
   derivatives of Table 2's distance. 114 operations: 15 additions, 16 subtractions, 33 multiplications, 1 division, 1 square root, 12 negations, 12 comparisons, 24 selections. */
typedef struct {
    V gap, nearing, rolling_gap_acceleration, normal_cosine;
} LANES(court_backboard_closing_out);

LANES_INLINE LANES(court_backboard_closing_out)
LANES(court_backboard_closing)(V x, V y, V z, V nx, V ny, V nz, V rolled_x, V rolled_y, V rolled_z, V rolling_acceleration_x, V rolling_acceleration_y, V rolling_acceleration_z, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(_c2, x);
    const V _s1 = lanes_neg(lanes_add(_c5, x));
    const V _s2 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s3 = lanes_sub(y, _c3);
    const V _s4 = lanes_neg(lanes_add(_c3, y));
    const V _s5 = lanes_sub(lanes_max(_s3, K(0.0)), lanes_max(_s4, K(0.0)));
    const V _s6 = lanes_sub(z, _c4);
    const V _s7 = lanes_sub(_c1, z);
    const V _s8 = lanes_sub(lanes_max(_s6, K(0.0)), lanes_max(_s7, K(0.0)));
    const V _s9 = lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s2, _s2), lanes_mul(_s5, _s5)), lanes_mul(_s8, _s8)));
    const M _s10 = lanes_less(_s0, K(0.0));
    const M _s11 = lanes_less(_s1, K(0.0));
    const V _s12 = lanes_sub(lanes_select(_s10, K(0.0), rolled_x), lanes_select(_s11, K(0.0), lanes_neg(rolled_x)));
    const M _s13 = lanes_less(_s3, K(0.0));
    const M _s14 = lanes_less(_s4, K(0.0));
    const V _s15 = lanes_sub(lanes_select(_s13, K(0.0), rolled_y), lanes_select(_s14, K(0.0), lanes_neg(rolled_y)));
    const M _s16 = lanes_less(_s6, K(0.0));
    const M _s17 = lanes_less(_s7, K(0.0));
    const V _s18 = lanes_sub(lanes_select(_s16, K(0.0), rolled_z), lanes_select(_s17, K(0.0), lanes_neg(rolled_z)));
    const V _s19 = lanes_add(lanes_add(lanes_mul(lanes_mul(K(2.0), _s12), _s2), lanes_mul(lanes_mul(K(2.0), _s15), _s5)), lanes_mul(lanes_mul(K(2.0), _s18), _s8));
    const V _s20 = lanes_div(K(1.0), _s9);
    const V _s21 = lanes_mul(lanes_mul(K(0.5), _s19), _s20);
    const V _s22 = lanes_mul(K(2.0), lanes_add(lanes_mul(lanes_sub(lanes_select(_s10, K(0.0), rolling_acceleration_x), lanes_select(_s11, K(0.0), lanes_neg(rolling_acceleration_x))), _s2), lanes_mul(_s12, _s12)));
    const V _s23 = lanes_mul(K(2.0), lanes_add(lanes_mul(lanes_sub(lanes_select(_s13, K(0.0), rolling_acceleration_y), lanes_select(_s14, K(0.0), lanes_neg(rolling_acceleration_y))), _s5), lanes_mul(_s15, _s15)));
    const V _s24 = lanes_mul(K(2.0), lanes_add(lanes_mul(lanes_sub(lanes_select(_s16, K(0.0), rolling_acceleration_z), lanes_select(_s17, K(0.0), lanes_neg(rolling_acceleration_z))), _s8), lanes_mul(_s18, _s18)));
    const V _s25 = lanes_mul(K(0.5), lanes_add(lanes_mul(lanes_neg(lanes_mul(_s21, lanes_mul(_s20, _s20))), _s19), lanes_mul(lanes_add(lanes_add(_s22, _s23), _s24), _s20)));
    const V _s26 = lanes_add(lanes_mul(lanes_mul(K(2.0), lanes_sub(lanes_select(_s10, K(0.0), nx), lanes_select(_s11, K(0.0), lanes_neg(nx)))), _s2), lanes_mul(lanes_mul(K(2.0), lanes_sub(lanes_select(_s13, K(0.0), ny), lanes_select(_s14, K(0.0), lanes_neg(ny)))), _s5));
    const V _s27 = lanes_add(_s26, lanes_mul(lanes_mul(K(2.0), lanes_sub(lanes_select(_s16, K(0.0), nz), lanes_select(_s17, K(0.0), lanes_neg(nz)))), _s8));
    return (LANES(court_backboard_closing_out)){ lanes_sub(_s9, _c0), _s21, _s25, lanes_mul(lanes_mul(K(0.5), _s27), _s20) };
}

/* Distance from the surface.
   Table 2. 30 operations: 5 additions, 7 subtractions, 3 multiplications, 1 square root, 2 negations, 6 comparisons, 6 selections. */
typedef struct {
    V gap;
} LANES(court_backboard_distance_out);

LANES_INLINE LANES(court_backboard_distance_out)
LANES(court_backboard_distance)(V x, V y, V z, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(_c2, x);
    const V _s1 = lanes_neg(lanes_add(_c5, x));
    const V _s2 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s3 = lanes_sub(y, _c3);
    const V _s4 = lanes_neg(lanes_add(_c3, y));
    const V _s5 = lanes_sub(lanes_max(_s3, K(0.0)), lanes_max(_s4, K(0.0)));
    const V _s6 = lanes_sub(z, _c4);
    const V _s7 = lanes_sub(_c1, z);
    const V _s8 = lanes_sub(lanes_max(_s6, K(0.0)), lanes_max(_s7, K(0.0)));
    return (LANES(court_backboard_distance_out)){ lanes_sub(lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s2, _s2), lanes_mul(_s5, _s5)), lanes_mul(_s8, _s8))), _c0) };
}

/* Curvature of the surface that the centre of a rolling ball stays on.
   Table 2. 47 operations: 3 additions, 3 subtractions, 5 negations, 18 comparisons, 6 conjunctions, 9 disjunctions, 3 selections. */
typedef struct {
    V bent_x, bent_y, bent_z, per_reach;
} LANES(court_backboard_rolling_surface_out);

LANES_INLINE LANES(court_backboard_rolling_surface_out)
LANES(court_backboard_rolling_surface)(V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7, V _c8, V _c9, V _c10, V _c11)
{
    const V _s0 = lanes_add(_c1, x);
    const V _s1 = lanes_neg(lanes_add(_c6, x));
    const V _s2 = lanes_select(lanes_either(lanes_either(lanes_less(_c4, _s0), lanes_both(lanes_less(_c5, _s0), lanes_less(K(0.0), vx))), lanes_either(lanes_less(_c4, _s1), lanes_both(lanes_less(_c5, _s1), lanes_less(K(0.0), lanes_neg(vx))))), K(1.0), K(0.0));
    const V _s3 = lanes_sub(y, _c2);
    const V _s4 = lanes_neg(lanes_add(_c2, y));
    const V _s5 = lanes_select(lanes_either(lanes_either(lanes_less(_c7, _s3), lanes_both(lanes_less(_c8, _s3), lanes_less(K(0.0), vy))), lanes_either(lanes_less(_c7, _s4), lanes_both(lanes_less(_c8, _s4), lanes_less(K(0.0), lanes_neg(vy))))), K(1.0), K(0.0));
    const V _s6 = lanes_sub(z, _c3);
    const V _s7 = lanes_sub(_c0, z);
    const V _s8 = lanes_select(lanes_either(lanes_either(lanes_less(_c9, _s6), lanes_both(lanes_less(_c10, _s6), lanes_less(K(0.0), vz))), lanes_either(lanes_less(_c9, _s7), lanes_both(lanes_less(_c10, _s7), lanes_less(K(0.0), lanes_neg(vz))))), K(1.0), K(0.0));
    return (LANES(court_backboard_rolling_surface_out)){ _s2, _s5, _s8, _c11 };
}

/* Rate of the normal.
   derivative of Table 2's normal. 75 operations: 7 additions, 12 subtractions, 15 multiplications, 7 divisions, 1 square root, 5 negations, 14 comparisons, 14 selections. */
typedef struct {
    V turning_x, turning_y, turning_z;
} LANES(court_backboard_turning_out);

LANES_INLINE LANES(court_backboard_turning_out)
LANES(court_backboard_turning)(V x, V y, V z, V rolled_x, V rolled_y, V rolled_z, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(_c1, x);
    const V _s1 = lanes_neg(lanes_add(_c4, x));
    const V _s2 = lanes_sub(lanes_select(lanes_less(_s0, K(0.0)), K(0.0), rolled_x), lanes_select(lanes_less(_s1, K(0.0)), K(0.0), lanes_neg(rolled_x)));
    const V _s3 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s4 = lanes_sub(y, _c2);
    const V _s5 = lanes_neg(lanes_add(_c2, y));
    const V _s6 = lanes_sub(lanes_max(_s4, K(0.0)), lanes_max(_s5, K(0.0)));
    const V _s7 = lanes_sub(z, _c3);
    const V _s8 = lanes_sub(_c0, z);
    const V _s9 = lanes_sub(lanes_max(_s7, K(0.0)), lanes_max(_s8, K(0.0)));
    const V _s10 = lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s3, _s3), lanes_mul(_s6, _s6)), lanes_mul(_s9, _s9)));
    const V _s11 = lanes_max(_s10, _c5);
    const V _s12 = lanes_sub(lanes_select(lanes_less(_s4, K(0.0)), K(0.0), rolled_y), lanes_select(lanes_less(_s5, K(0.0)), K(0.0), lanes_neg(rolled_y)));
    const V _s13 = lanes_sub(lanes_select(lanes_less(_s7, K(0.0)), K(0.0), rolled_z), lanes_select(lanes_less(_s8, K(0.0)), K(0.0), lanes_neg(rolled_z)));
    const V _s14 = lanes_mul(lanes_mul(K(0.5), lanes_add(lanes_add(lanes_mul(lanes_mul(K(2.0), _s2), _s3), lanes_mul(lanes_mul(K(2.0), _s12), _s6)), lanes_mul(lanes_mul(K(2.0), _s13), _s9))), lanes_div(K(1.0), _s10));
    const V _s15 = lanes_select(lanes_less(_s10, _c5), K(0.0), _s14);
    const V _s16 = lanes_mul(_s11, _s11);
    return (LANES(court_backboard_turning_out)){ lanes_sub(lanes_div(_s2, _s11), lanes_div(lanes_mul(_s3, _s15), _s16)), lanes_sub(lanes_div(_s12, _s11), lanes_div(lanes_mul(_s6, _s15), _s16)), lanes_sub(lanes_div(_s13, _s11), lanes_div(lanes_mul(_s9, _s15), _s16)) };
}

/* Second to fourth derivative of the distance along a flight.
   derivatives of Table 2's distance. 125 operations: 26 additions, 10 subtractions, 53 multiplications, 1 division, 1 square root, 8 negations, 12 comparisons, 14 selections. */
typedef struct {
    V lift, gap_jerk, gap_snap;
} LANES(court_backboard_separation_out);

LANES_INLINE LANES(court_backboard_separation_out)
LANES(court_backboard_separation)(V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6)
{
    const V _s0 = lanes_add(_c1, x);
    const V _s1 = lanes_neg(lanes_add(_c5, x));
    const V _s2 = lanes_sub(lanes_select(lanes_less(_s0, K(0.0)), K(0.0), vx), lanes_select(lanes_less(_s1, K(0.0)), K(0.0), lanes_neg(vx)));
    const V _s3 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s4 = lanes_sub(y, _c2);
    const V _s5 = lanes_neg(lanes_add(_c2, y));
    const V _s6 = lanes_sub(lanes_select(lanes_less(_s4, K(0.0)), K(0.0), vy), lanes_select(lanes_less(_s5, K(0.0)), K(0.0), lanes_neg(vy)));
    const V _s7 = lanes_sub(lanes_max(_s4, K(0.0)), lanes_max(_s5, K(0.0)));
    const V _s8 = lanes_sub(z, _c3);
    const M _s9 = lanes_less(_s8, K(0.0));
    const V _s10 = lanes_sub(_c0, z);
    const M _s11 = lanes_less(_s10, K(0.0));
    const V _s12 = lanes_sub(lanes_select(_s9, K(0.0), vz), lanes_select(_s11, K(0.0), lanes_neg(vz)));
    const V _s13 = lanes_sub(lanes_max(_s8, K(0.0)), lanes_max(_s10, K(0.0)));
    const V _s14 = lanes_add(lanes_add(lanes_mul(lanes_mul(K(2.0), _s2), _s3), lanes_mul(lanes_mul(K(2.0), _s6), _s7)), lanes_mul(lanes_mul(K(2.0), _s12), _s13));
    const V _s15 = lanes_div(K(1.0), lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s3, _s3), lanes_mul(_s7, _s7)), lanes_mul(_s13, _s13))));
    const V _s16 = lanes_mul(lanes_mul(K(0.5), _s14), _s15);
    const V _s17 = lanes_mul(_s15, _s15);
    const V _s18 = lanes_neg(lanes_mul(_s16, _s17));
    const V _s19 = lanes_sub(lanes_select(_s9, K(0.0), _c6), lanes_select(_s11, K(0.0), _c4));
    const V _s20 = lanes_add(lanes_add(lanes_mul(K(2.0), lanes_add(lanes_mul(_s19, _s13), lanes_mul(_s12, _s12))), lanes_mul(K(2.0), lanes_mul(_s2, _s2))), lanes_mul(K(2.0), lanes_mul(_s6, _s6)));
    const V _s21 = lanes_mul(K(0.5), lanes_add(lanes_mul(_s18, _s14), lanes_mul(_s20, _s15)));
    const V _s22 = lanes_mul(_s18, _s20);
    const V _s23 = lanes_mul(K(2.0), _s18);
    const V _s24 = lanes_neg(lanes_add(lanes_mul(_s21, _s17), lanes_mul(lanes_mul(_s23, _s16), _s15)));
    const V _s25 = lanes_mul(K(2.0), lanes_add(lanes_mul(lanes_mul(K(2.0), _s19), _s12), lanes_mul(_s19, _s12)));
    const V _s26 = lanes_mul(K(0.5), lanes_add(lanes_add(_s22, lanes_mul(_s14, _s24)), lanes_add(_s22, lanes_mul(_s25, _s15))));
    const V _s27 = lanes_mul(_s18, _s25);
    const V _s28 = lanes_mul(_s20, _s24);
    const V _s29 = lanes_add(_s27, _s28);
    const V _s30 = lanes_add(_s29, lanes_add(_s27, lanes_mul(_s15, lanes_mul(K(2.0), lanes_mul(K(3.0), lanes_mul(_s19, _s19))))));
    const V _s31 = lanes_add(lanes_add(lanes_mul(_s26, _s17), lanes_mul(lanes_mul(_s23, _s21), _s15)), lanes_mul(K(2.0), lanes_add(lanes_add(lanes_mul(lanes_mul(_s18, _s18), _s16), lanes_mul(lanes_mul(_s18, _s21), _s15)), lanes_mul(lanes_mul(_s16, _s24), _s15))));
    const V _s32 = lanes_mul(K(0.5), lanes_add(_s30, lanes_add(_s29, lanes_add(lanes_mul(_s14, lanes_neg(_s31)), _s28))));
    return (LANES(court_backboard_separation_out)){ _s21, _s26, _s32 };
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 1 operation: 1 addition. */
typedef struct {
    V gap, nearing, near;
} LANES(court_backboard_seam0_out);

LANES_INLINE LANES(court_backboard_seam0_out)
LANES(court_backboard_seam0)(V x, V vx, V _c0, V _c1)
{
    return (LANES(court_backboard_seam0_out)){ lanes_add(_c0, x), vx, _c1 };
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 1 operation: 1 addition. */
typedef struct {
    V gap, nearing, near;
} LANES(court_backboard_seam1_out);

LANES_INLINE LANES(court_backboard_seam1_out)
LANES(court_backboard_seam1)(V x, V vx, V _c0, V _c1)
{
    return (LANES(court_backboard_seam1_out)){ lanes_add(_c0, x), vx, _c1 };
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 1 operation: 1 addition. */
typedef struct {
    V gap, nearing, near;
} LANES(court_backboard_seam2_out);

LANES_INLINE LANES(court_backboard_seam2_out)
LANES(court_backboard_seam2)(V y, V vy, V _c0, V _c1)
{
    return (LANES(court_backboard_seam2_out)){ lanes_add(_c0, y), vy, _c1 };
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 1 operation: 1 subtraction. */
typedef struct {
    V gap, nearing, near;
} LANES(court_backboard_seam3_out);

LANES_INLINE LANES(court_backboard_seam3_out)
LANES(court_backboard_seam3)(V y, V vy, V _c0, V _c1)
{
    return (LANES(court_backboard_seam3_out)){ lanes_sub(y, _c0), vy, _c1 };
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 1 operation: 1 subtraction. */
typedef struct {
    V gap, nearing, near;
} LANES(court_backboard_seam4_out);

LANES_INLINE LANES(court_backboard_seam4_out)
LANES(court_backboard_seam4)(V z, V vz, V _c0, V _c1)
{
    return (LANES(court_backboard_seam4_out)){ lanes_sub(z, _c0), vz, _c1 };
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 1 operation: 1 subtraction. */
typedef struct {
    V gap, nearing, near;
} LANES(court_backboard_seam5_out);

LANES_INLINE LANES(court_backboard_seam5_out)
LANES(court_backboard_seam5)(V z, V vz, V _c0, V _c1)
{
    return (LANES(court_backboard_seam5_out)){ lanes_sub(z, _c0), vz, _c1 };
}

/* Bound below the distance at this height and distance from the axis, and its rate.
   Table 2. 43 operations: 4 additions, 6 subtractions, 15 multiplications, 2 divisions, 2 square roots, 2 negations, 6 comparisons, 6 selections. */
typedef struct {
    V gap, nearing;
} LANES(court_backboard_around_out);

LANES_INLINE LANES(court_backboard_around_out)
LANES(court_backboard_around)(V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1, V _c2, V _c3)
{
    const V _s0 = lanes_sub(z, _c2);
    const V _s1 = lanes_sub(_c1, z);
    const V _s2 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s3 = lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y)));
    const V _s4 = lanes_sub(_c3, _s3);
    const V _s5 = lanes_max(K(0.0), _s4);
    const V _s6 = lanes_sqrt(lanes_add(lanes_mul(_s2, _s2), lanes_mul(_s5, _s5)));
    const V _s7 = lanes_neg(lanes_mul(lanes_mul(K(0.5), lanes_add(lanes_mul(lanes_mul(K(2.0), x), vx), lanes_mul(lanes_mul(K(2.0), y), vy))), lanes_div(K(1.0), _s3)));
    const V _s8 = lanes_add(lanes_mul(lanes_mul(K(2.0), lanes_sub(lanes_select(lanes_less(_s0, K(0.0)), K(0.0), vz), lanes_select(lanes_less(_s1, K(0.0)), K(0.0), lanes_neg(vz)))), _s2), lanes_mul(lanes_mul(K(2.0), _s5), lanes_select(lanes_less(K(0.0), _s4), _s7, K(0.0))));
    return (LANES(court_backboard_around_out)){ lanes_sub(_s6, _c0), lanes_div(lanes_mul(K(0.5), _s8), _s6) };
}

/* First window that ends later than a time, from then on.
   Table 1. 12 operations: 4 comparisons, 2 disjunctions, 6 selections. */
typedef struct {
    V t, end;
    M searching;
} LANES(court_backboard_enter_out);

LANES_INLINE LANES(court_backboard_enter_out)
LANES(court_backboard_enter)(V t, V end, V after, V low0, V low1, V high0, V high1)
{
    const V _s0 = lanes_max(after, low0);
    const M _s1 = lanes_less(_s0, high0);
    const V _s2 = lanes_max(after, low1);
    const M _s3 = lanes_less(_s2, high1);
    return (LANES(court_backboard_enter_out)){ lanes_select(_s1, _s0, lanes_select(_s3, _s2, t)), lanes_select(_s1, high0, lanes_select(_s3, high1, end)), lanes_either(lanes_either(mask_none(), _s3), _s1) };
}

/* Outward unit normal n3 at a contact.
   Table 2. 34 operations: 5 additions, 6 subtractions, 3 multiplications, 3 divisions, 1 square root, 2 negations, 7 comparisons, 7 selections. */
typedef struct {
    V nx, ny, nz;
} LANES(court_bridge_normal_out);

LANES_INLINE LANES(court_bridge_normal_out)
LANES(court_bridge_normal)(V x, V y, V z, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(_c0, x);
    const V _s1 = lanes_neg(lanes_add(_c2, x));
    const V _s2 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s3 = lanes_sub(z, _c1);
    const V _s4 = lanes_sub(_c4, z);
    const V _s5 = lanes_sub(lanes_max(_s3, K(0.0)), lanes_max(_s4, K(0.0)));
    const V _s6 = lanes_sub(y, _c3);
    const V _s7 = lanes_neg(lanes_add(_c3, y));
    const V _s8 = lanes_sub(lanes_max(_s6, K(0.0)), lanes_max(_s7, K(0.0)));
    const V _s9 = lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s2, _s2), lanes_mul(_s5, _s5)), lanes_mul(_s8, _s8)));
    const V _s10 = lanes_max(_s9, _c5);
    return (LANES(court_bridge_normal_out)){ lanes_div(_s2, _s10), lanes_div(_s8, _s10), lanes_div(_s5, _s10) };
}

/* Bound on the rate at which the normal turns along the contact surface.
   Table 2. 59 operations: 11 additions, 3 subtractions, 8 multiplications, 2 negations, 9 absolute values, 13 comparisons, 13 selections. */
typedef struct {
    V curvature;
} LANES(court_bridge_curvature_out);

LANES_INLINE LANES(court_bridge_curvature_out)
LANES(court_bridge_curvature)(V t, V x, V y, V z, V vx, V vy, V vz, V dx, V dy, V dz, V dvx, V dvy, V dvz, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6)
{
    const V _s0 = lanes_mul(K(2.0), t);
    const V _s1 = lanes_abs(dvx);
    const V _s2 = lanes_abs(dvy);
    const V _s3 = lanes_max(_s1, _s2);
    const V _s4 = lanes_abs(dvz);
    const V _s5 = lanes_abs(dx);
    const V _s6 = lanes_abs(dy);
    const V _s7 = lanes_max(_s5, _s6);
    const V _s8 = lanes_abs(dz);
    const V _s9 = lanes_mul(K(16.0), lanes_add(lanes_mul(t, lanes_max(_s3, _s4)), lanes_max(_s7, _s8)));
    const V _s10 = lanes_sub(z, _c1);
    const V _s11 = lanes_sub(_c5, z);
    const V _s12 = lanes_add(lanes_add(lanes_add(lanes_mul(_c4, lanes_mul(t, t)), lanes_mul(_s0, lanes_abs(vz))), _s9), lanes_max(_s10, _s11));
    const V _s13 = lanes_add(_c0, x);
    const V _s14 = lanes_neg(lanes_add(_c2, x));
    const V _s15 = lanes_add(lanes_add(lanes_mul(_s0, lanes_abs(vx)), _s9), lanes_max(_s13, _s14));
    const V _s16 = lanes_max(_s12, _s15);
    const V _s17 = lanes_sub(y, _c3);
    const V _s18 = lanes_neg(lanes_add(_c3, y));
    const V _s19 = lanes_add(lanes_add(lanes_mul(_s0, lanes_abs(vy)), _s9), lanes_max(_s17, _s18));
    const V _s20 = lanes_max(_s19, _s12);
    const V _s21 = lanes_max(_s15, _s19);
    const V _s22 = lanes_min(_s20, _s21);
    return (LANES(court_bridge_curvature_out)){ lanes_select(lanes_less(lanes_min(_s16, _s22), K(0.0)), K(0.0), _c6) };
}

/* Tangent and curvatures at a contact, and bounds on the roundings there.
   Table 2, running error analysis. 165 operations: 37 additions, 11 subtractions, 41 multiplications, 3 divisions, 1 square root, 3 negations, 20 absolute values, 23 comparisons, 2 conjunctions, 24 selections. */
typedef struct {
    S tangent_x, tangent_y, bend_s, bend_e, sharpest_bend, root_offset, root_level, normal_rounding;
} LANES(court_bridge_tangents_out);

LANES_INLINE LANES(court_bridge_tangents_out)
LANES(court_bridge_tangents)(S t, S x, S y, S z, S vx, S vy, S vz, S nx, S ny, S nz, S place_n, S normal_velocity, S back, S _c0, S _c1, S _c2, S _c3, S _c4, S _c5, S _c6, S _c7, S _c8, S _c9, S _c10, S _c11, S _c12, S _c13, S _c14, S _c15)
{
    const S _s0 = singles_sqrt(singles_add(singles_mul(nx, nx), singles_mul(ny, ny)));
    const Q _s1 = singles_less(KS(0.0), _s0);
    const S _s2 = singles_div(KS(1.0), _s0);
    const S _s3 = singles_sub(z, _c2);
    const S _s4 = singles_sub(_c6, z);
    const S _s5 = singles_abs(singles_sub(singles_max(_s3, KS(0.0)), singles_max(_s4, KS(0.0))));
    const S _s6 = singles_add(_c1, x);
    const S _s7 = singles_neg(singles_add(_c3, x));
    const S _s8 = singles_abs(singles_sub(singles_max(_s6, KS(0.0)), singles_max(_s7, KS(0.0))));
    const S _s9 = singles_sub(y, _c4);
    const S _s10 = singles_neg(singles_add(_c4, y));
    const S _s11 = singles_abs(singles_sub(singles_max(_s9, KS(0.0)), singles_max(_s10, KS(0.0))));
    const S _s12 = singles_select(singles_both(singles_less(KS(0.0), _s8), singles_less(KS(0.0), _s11)), singles_mul(_c7, _s2), KS(0.0));
    const S _s13 = singles_abs(_s3);
    const S _s14 = singles_abs(singles_sub(z, _c6));
    const S _s15 = singles_abs(_s9);
    const S _s16 = singles_abs(singles_sub(y, _c8));
    const S _s17 = singles_abs(singles_sub(x, _c9));
    const S _s18 = singles_abs(singles_sub(x, _c10));
    const S _s19 = singles_min(_s17, _s18);
    const S _s20 = singles_min(_s16, _s19);
    const S _s21 = singles_min(_s15, _s20);
    const S _s22 = singles_min(_s14, _s21);
    const S _s23 = singles_sub(singles_min(_s13, _s22), _c11);
    const S _s24 = singles_max(_c7, _s12);
    const S _s25 = singles_div(KS(1.0), singles_mul(KS(50.0), _s23));
    const S _s26 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_mul(t, singles_abs(normal_velocity))));
    const S _s27 = singles_mul(t, t);
    const S _s28 = singles_abs(vx);
    const S _s29 = singles_abs(vy);
    const S _s30 = singles_add(singles_mul(_c5, _s27), singles_mul(t, singles_add(singles_add(_s28, _s29), singles_abs(vz))));
    const S _s31 = singles_mul(KS(2.0), t);
    const S _s32 = singles_mul(KS(1.1102230246251565e-16), _s8);
    const S _s33 = singles_add(singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s31, _s28), singles_abs(x)))), singles_mul(KS(2.0), _s32));
    const S _s34 = singles_mul(KS(1.1102230246251565e-16), _s11);
    const S _s35 = singles_add(singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), singles_add(singles_mul(_s31, _s29), singles_abs(y)))), singles_mul(KS(2.0), _s34));
    const S _s36 = singles_add(singles_add(singles_mul(_c12, _s27), singles_mul(_s31, singles_abs(singles_add(vz, singles_mul(_c12, t))))), singles_abs(z));
    const S _s37 = singles_add(_c13, singles_mul(KS(1.1102230246251565e-16), _s5));
    const S _s38 = singles_add(singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), _s36)), singles_mul(KS(2.0), _s37));
    const S _s39 = singles_add(singles_mul(singles_mul(_c7, _s30), singles_add(singles_add(_s33, _s35), _s38)), singles_mul(KS(1.3322676295501878e-15), _s30));
    const S _s40 = singles_mul(KS(1.125), _s39);
    const S _s41 = singles_mul(KS(1.7763568394002505e-15), singles_mul(_c0, singles_div(singles_mul(normal_velocity, normal_velocity), singles_add(singles_add(singles_mul(vx, vx), singles_mul(vy, vy)), singles_mul(vz, vz)))));
    const S _s42 = singles_add(singles_add(_s26, _s39), singles_max(_s40, _s41));
    const S _s43 = singles_add(_c14, singles_add(singles_add(singles_mul(singles_abs(nx), _s33), singles_mul(singles_abs(ny), _s35)), singles_mul(singles_abs(nz), _s38)));
    const S _s44 = singles_mul(KS(1.125), _s43);
    const S _s45 = singles_add(singles_add(_s26, _s43), singles_max(_s44, _s41));
    const S _s46 = singles_add(place_n, _s45);
    const Q _s47 = singles_less(KS(0.0), back);
    const S _s48 = singles_add(place_n, _s42);
    return (LANES(court_bridge_tangents_out)){ singles_select(_s1, singles_neg(singles_mul(ny, _s2)), KS(0.0)), singles_select(_s1, singles_mul(nx, _s2), KS(1.0)), singles_select(singles_both(singles_less(KS(0.0), _s5), _s1), _c7, KS(0.0)), _s12, singles_select(singles_less(KS(0.0), _s23), singles_max(_s24, _s25), KS(INFINITY)), singles_select(_s47, singles_max(_s42, _s46), _s45), singles_select(_s47, singles_max(_s48, _s45), _s45), singles_add(KS(8.881784197001252e-16), singles_mul(_c15, singles_add(singles_add(_s37, _s32), _s34))) };
}

/* Error of the normal, from that of the position.
   derivative of Table 2's normal. 98 operations: 10 additions, 12 subtractions, 17 multiplications, 7 divisions, 1 square root, 5 negations, 23 comparisons, 23 selections. */
typedef struct {
    V dnx, dny, dnz, turn;
} LANES(court_bridge_carry_normal_out);

LANES_INLINE LANES(court_bridge_carry_normal_out)
LANES(court_bridge_carry_normal)(V x, V y, V z, V dx, V dy, V dz, V shift, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6)
{
    const V _s0 = lanes_add(_c0, x);
    const V _s1 = lanes_neg(lanes_add(_c2, x));
    const V _s2 = lanes_sub(lanes_select(lanes_less(_s0, K(0.0)), K(0.0), dx), lanes_select(lanes_less(_s1, K(0.0)), K(0.0), lanes_neg(dx)));
    const V _s3 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s4 = lanes_sub(z, _c1);
    const V _s5 = lanes_sub(_c4, z);
    const V _s6 = lanes_sub(lanes_max(_s4, K(0.0)), lanes_max(_s5, K(0.0)));
    const V _s7 = lanes_sub(y, _c3);
    const V _s8 = lanes_neg(lanes_add(_c3, y));
    const V _s9 = lanes_sub(lanes_max(_s7, K(0.0)), lanes_max(_s8, K(0.0)));
    const V _s10 = lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s3, _s3), lanes_mul(_s6, _s6)), lanes_mul(_s9, _s9)));
    const V _s11 = lanes_max(_s10, _c5);
    const V _s12 = lanes_sub(lanes_select(lanes_less(_s4, K(0.0)), K(0.0), dz), lanes_select(lanes_less(_s5, K(0.0)), K(0.0), lanes_neg(dz)));
    const V _s13 = lanes_sub(lanes_select(lanes_less(_s7, K(0.0)), K(0.0), dy), lanes_select(lanes_less(_s8, K(0.0)), K(0.0), lanes_neg(dy)));
    const V _s14 = lanes_mul(lanes_mul(K(0.5), lanes_add(lanes_add(lanes_mul(lanes_mul(K(2.0), _s2), _s3), lanes_mul(lanes_mul(K(2.0), _s12), _s6)), lanes_mul(lanes_mul(K(2.0), _s13), _s9))), lanes_div(K(1.0), _s10));
    const V _s15 = lanes_select(lanes_less(_s10, _c5), K(0.0), _s14);
    const V _s16 = lanes_mul(_s11, _s11);
    const V _s17 = lanes_mul(K(16.0), shift);
    const V _s18 = lanes_add(_s17, lanes_max(_s4, _s5));
    const V _s19 = lanes_add(_s17, lanes_max(_s0, _s1));
    const V _s20 = lanes_max(_s18, _s19);
    const V _s21 = lanes_add(_s17, lanes_max(_s7, _s8));
    const V _s22 = lanes_max(_s21, _s18);
    const V _s23 = lanes_max(_s19, _s21);
    const V _s24 = lanes_min(_s22, _s23);
    return (LANES(court_bridge_carry_normal_out)){ lanes_sub(lanes_div(_s2, _s11), lanes_div(lanes_mul(_s3, _s15), _s16)), lanes_sub(lanes_div(_s13, _s11), lanes_div(lanes_mul(_s9, _s15), _s16)), lanes_sub(lanes_div(_s12, _s11), lanes_div(lanes_mul(_s6, _s15), _s16)), lanes_mul(shift, lanes_select(lanes_less(lanes_min(_s20, _s24), K(0.0)), K(0.0), _c6)) };
}

/* Constants and windows of the search along a flight, and its error budget.
   bounds of the event condition. 109 operations: 21 additions, 7 subtractions, 22 multiplications, 4 divisions, 3 square roots, 4 negations, 2 absolute values, 22 comparisons, 24 selections. */
typedef struct {
    V low0, high0, low1, high1, ceiling, latest, budget_exceeded;
} LANES(court_bridge_prepare_out);

LANES_INLINE LANES(court_bridge_prepare_out)
LANES(court_bridge_prepare)(V horizon, V x, V y, V z, V vx, V vy, V vz, V extent, V speed, V position_error, V velocity_error, V earliest_delay, V pad, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7, V _c8, V _c9, V _c10, V _c11, V _c12, V _c13, V _c14)
{
    const V _s0 = lanes_abs(vx);
    const V _s1 = lanes_add(_c5, x);
    const V _s2 = lanes_select(lanes_less(vx, K(0.0)), lanes_neg(_s1), _s1);
    const V _s3 = lanes_div(lanes_neg(lanes_add(_c4, _s2)), _s0);
    const V _s4 = lanes_max(K(0.0), _s3);
    const V _s5 = lanes_abs(vy);
    const V _s6 = lanes_select(lanes_less(vy, K(0.0)), lanes_neg(y), y);
    const V _s7 = lanes_div(lanes_neg(lanes_add(_c6, _s6)), _s5);
    const V _s8 = lanes_max(_s4, _s7);
    const V _s9 = lanes_mul(vz, vz);
    const V _s10 = lanes_sub(lanes_add(_c2, z), _c0);
    const V _s11 = lanes_add(_s9, lanes_mul(_c8, lanes_add(_c7, _s10)));
    const V _s12 = lanes_sqrt(_s11);
    const M _s13 = lanes_at_most(K(0.0), _s11);
    const V _s14 = lanes_select(_s13, lanes_mul(_c9, lanes_sub(vz, _s12)), K(INFINITY));
    const V _s15 = lanes_max(_s8, _s14);
    const V _s16 = lanes_add(_s9, lanes_mul(_c8, lanes_sub(_s10, _c7)));
    const V _s17 = lanes_sqrt(lanes_max(_s16, K(0.0)));
    const V _s18 = lanes_select(_s13, lanes_mul(_c9, lanes_add(vz, _s12)), K(-INFINITY));
    const M _s19 = lanes_less(K(0.0), _s16);
    const V _s20 = lanes_select(_s19, lanes_mul(_c9, lanes_sub(vz, _s17)), _s18);
    const V _s21 = lanes_div(lanes_sub(_c6, _s6), _s5);
    const V _s22 = lanes_div(lanes_sub(_c4, _s2), _s0);
    const V _s23 = lanes_min(_s22, K(INFINITY));
    const V _s24 = lanes_min(_s21, _s23);
    const V _s25 = lanes_min(_s20, _s24);
    const V _s26 = lanes_select(_s19, lanes_mul(_c9, lanes_add(vz, _s17)), K(INFINITY));
    const V _s27 = lanes_max(_s8, _s26);
    const V _s28 = lanes_min(_s18, _s24);
    const V _s29 = lanes_max(K(0.0), _s25);
    const V _s30 = lanes_max(_s29, _s28);
    const V _s31 = lanes_min(_s30, horizon);
    const V _s32 = lanes_add(speed, lanes_mul(_c1, _s31));
    const V _s33 = lanes_add(lanes_add(lanes_add(_c5, extent), _c12), _c13);
    const V _s34 = lanes_add(lanes_mul(_c11, lanes_sqrt(lanes_mul(_c9, lanes_add(_s33, _c3)))), lanes_mul(lanes_mul(K(2.0), speed), _c9));
    const V _s35 = lanes_add(lanes_add(lanes_add(position_error, lanes_mul(velocity_error, lanes_min(_s34, horizon))), lanes_mul(K(3.552713678800501e-15), lanes_add(lanes_mul(lanes_mul(speed, speed), _c9), _s33))), lanes_select(lanes_less(lanes_mul(K(2.0), pad), earliest_delay), lanes_mul(earliest_delay, lanes_add(speed, lanes_mul(_c1, horizon))), K(0.0)));
    return (LANES(court_bridge_prepare_out)){ lanes_max(K(0.0), _s15), lanes_min(_s25, horizon), lanes_max(K(0.0), _s27), lanes_min(_s28, horizon), lanes_mul(K(2.0), lanes_add(_c10, lanes_mul(K(3.0), lanes_mul(_s32, _s32)))), _s31, lanes_sub(_s35, _c14) };
}

/* Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.
   running error analysis. 52 operations: 25 additions, 27 multiplications. */
typedef struct {
    V margin, leaving_margin, rate_margin;
} LANES(court_bridge_margins_out);

LANES_INLINE LANES(court_bridge_margins_out)
LANES(court_bridge_margins)(V horizon, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7, V _c8, V _c9, V _c10, V _c11)
{
    const V _s0 = lanes_add(speed, lanes_mul(_c0, horizon));
    const V _s1 = lanes_add(extent, lanes_mul(horizon, _s0));
    const V _s2 = lanes_mul(K(2.220446049250313e-16), _s1);
    const V _s3 = lanes_mul(K(2.0), lanes_add(lanes_add(position_error, lanes_mul(horizon, velocity_error)), lanes_mul(K(4.440892098500626e-16), _s1)));
    const V _s4 = lanes_add(lanes_add(_c3, _s2), _s3);
    const V _s5 = lanes_add(lanes_add(_c5, _s2), _s3);
    const V _s6 = lanes_add(lanes_add(_c6, lanes_mul(K(3.3306690738754696e-16), _s1)), _s3);
    const V _s7 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_c1, lanes_mul(_c4, _s4)), lanes_mul(_c4, _s5)), lanes_mul(_c4, _s6)), lanes_mul(lanes_mul(lanes_mul(K(1.3335686721571705e-15), horizon), _c2), _s0)), _c7);
    const V _s8 = lanes_mul(K(4.00390625), _s0);
    const V _s9 = lanes_add(lanes_add(lanes_add(lanes_mul(_c8, _s0), lanes_mul(_c9, lanes_add(velocity_error, lanes_mul(K(3.3306690738754696e-16), _s0)))), lanes_mul(_s8, _s4)), lanes_mul(_s8, _s5));
    const V _s10 = lanes_mul(K(2.001953125), _s0);
    const V _s11 = lanes_add(lanes_add(lanes_add(lanes_mul(_c10, _s0), lanes_mul(_c11, lanes_add(velocity_error, lanes_mul(K(2.220446049250313e-16), _s0)))), lanes_mul(_s10, _s4)), lanes_mul(_s10, _s5));
    return (LANES(court_bridge_margins_out)){ _s7, lanes_add(_s9, lanes_mul(_s8, _s6)), lanes_add(_s11, lanes_mul(_s10, _s6)) };
}

/* Newton's next value of a root near t, and gap and rate there.
   Newton's method. 98 operations: 18 additions, 19 subtractions, 24 multiplications, 1 division, 4 negations, 16 comparisons, 16 selections. */
typedef struct {
    V time, gap, rate;
} LANES(court_bridge_refine_out);

LANES_INLINE LANES(court_bridge_refine_out)
LANES(court_bridge_refine)(V t, V leaving, V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7)
{
    const V _s0 = lanes_add(x, lanes_mul(vx, t));
    const V _s1 = lanes_add(_c0, _s0);
    const V _s2 = lanes_neg(lanes_add(_c2, _s0));
    const V _s3 = lanes_sub(lanes_max(_s1, K(0.0)), lanes_max(_s2, K(0.0)));
    const V _s4 = lanes_add(y, lanes_mul(vy, t));
    const V _s5 = lanes_sub(_s4, _c3);
    const V _s6 = lanes_neg(lanes_add(_c3, _s4));
    const V _s7 = lanes_sub(lanes_max(_s5, K(0.0)), lanes_max(_s6, K(0.0)));
    const V _s8 = lanes_sub(vz, lanes_mul(_c5, t));
    const V _s9 = lanes_add(z, lanes_mul(t, _s8));
    const V _s10 = lanes_sub(_s9, _c1);
    const V _s11 = lanes_sub(_c6, _s9);
    const V _s12 = lanes_sub(lanes_max(_s10, K(0.0)), lanes_max(_s11, K(0.0)));
    const V _s13 = lanes_mul(K(2.0), lanes_add(lanes_add(lanes_mul(vx, _s3), lanes_mul(vy, _s7)), lanes_mul(lanes_sub(vz, lanes_mul(_c4, t)), _s12)));
    const V _s14 = lanes_add(_c0, x);
    const V _s15 = lanes_neg(lanes_add(_c2, x));
    const V _s16 = lanes_sub(lanes_max(_s14, K(0.0)), lanes_max(_s15, K(0.0)));
    const V _s17 = lanes_mul(_s3, _s3);
    const V _s18 = lanes_sub(z, _c1);
    const V _s19 = lanes_sub(_c6, z);
    const V _s20 = lanes_sub(lanes_max(_s18, K(0.0)), lanes_max(_s19, K(0.0)));
    const V _s21 = lanes_mul(_s12, _s12);
    const V _s22 = lanes_sub(y, _c3);
    const V _s23 = lanes_neg(lanes_add(_c3, y));
    const V _s24 = lanes_sub(lanes_max(_s22, K(0.0)), lanes_max(_s23, K(0.0)));
    const V _s25 = lanes_mul(_s7, _s7);
    const V _s26 = lanes_add(lanes_add(lanes_select(lanes_less(K(0.0), lanes_mul(_s16, _s3)), lanes_mul(t, lanes_mul(vx, lanes_add(_s16, _s3))), lanes_sub(_s17, lanes_mul(_s16, _s16))), lanes_select(lanes_less(K(0.0), lanes_mul(_s20, _s12)), lanes_mul(t, lanes_mul(_s8, lanes_add(_s20, _s12))), lanes_sub(_s21, lanes_mul(_s20, _s20)))), lanes_select(lanes_less(K(0.0), lanes_mul(_s24, _s7)), lanes_mul(t, lanes_mul(vy, lanes_add(_s24, _s7))), lanes_sub(_s25, lanes_mul(_s24, _s24))));
    const V _s27 = lanes_select(lanes_less(K(0.0), leaving), _s26, lanes_sub(lanes_add(lanes_add(_s17, _s21), _s25), _c7));
    return (LANES(court_bridge_refine_out)){ lanes_sub(t, lanes_div(_s27, _s13)), _s27, _s13 };
}

/* Gap, rate, second derivative, a step without a root, its end, and the clearance.
   Newton from the left under a curvature bound. 171 operations: 28 additions, 24 subtractions, 42 multiplications, 2 divisions, 1 square root, 7 negations, 4 absolute values, 30 comparisons, 33 selections. */
typedef struct {
    V gap, rate, bend, step, next, clearance;
} LANES(court_bridge_advance_out);

LANES_INLINE LANES(court_bridge_advance_out)
LANES(court_bridge_advance)(V t, V end, V leaving, V margin, V rate_margin, V ceiling, V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7, V _c8, V _c9, V _c10)
{
    const V _s0 = lanes_add(_c0, x);
    const V _s1 = lanes_neg(lanes_add(_c2, x));
    const V _s2 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s3 = lanes_add(x, lanes_mul(vx, t));
    const V _s4 = lanes_add(_c0, _s3);
    const V _s5 = lanes_neg(lanes_add(_c2, _s3));
    const V _s6 = lanes_sub(lanes_max(_s4, K(0.0)), lanes_max(_s5, K(0.0)));
    const V _s7 = lanes_mul(_s6, _s6);
    const V _s8 = lanes_sub(z, _c1);
    const V _s9 = lanes_sub(_c5, z);
    const V _s10 = lanes_sub(lanes_max(_s8, K(0.0)), lanes_max(_s9, K(0.0)));
    const V _s11 = lanes_sub(vz, lanes_mul(_c6, t));
    const V _s12 = lanes_add(z, lanes_mul(t, _s11));
    const V _s13 = lanes_sub(_s12, _c1);
    const V _s14 = lanes_sub(_c5, _s12);
    const V _s15 = lanes_sub(lanes_max(_s13, K(0.0)), lanes_max(_s14, K(0.0)));
    const V _s16 = lanes_mul(_s15, _s15);
    const V _s17 = lanes_sub(y, _c3);
    const V _s18 = lanes_neg(lanes_add(_c3, y));
    const V _s19 = lanes_sub(lanes_max(_s17, K(0.0)), lanes_max(_s18, K(0.0)));
    const V _s20 = lanes_add(y, lanes_mul(vy, t));
    const V _s21 = lanes_sub(_s20, _c3);
    const V _s22 = lanes_neg(lanes_add(_c3, _s20));
    const V _s23 = lanes_sub(lanes_max(_s21, K(0.0)), lanes_max(_s22, K(0.0)));
    const V _s24 = lanes_mul(_s23, _s23);
    const V _s25 = lanes_add(lanes_add(lanes_select(lanes_less(K(0.0), lanes_mul(_s2, _s6)), lanes_mul(t, lanes_mul(vx, lanes_add(_s2, _s6))), lanes_sub(_s7, lanes_mul(_s2, _s2))), lanes_select(lanes_less(K(0.0), lanes_mul(_s10, _s15)), lanes_mul(t, lanes_mul(_s11, lanes_add(_s10, _s15))), lanes_sub(_s16, lanes_mul(_s10, _s10)))), lanes_select(lanes_less(K(0.0), lanes_mul(_s19, _s23)), lanes_mul(t, lanes_mul(vy, lanes_add(_s19, _s23))), lanes_sub(_s24, lanes_mul(_s19, _s19))));
    const V _s26 = lanes_select(lanes_less(K(0.0), leaving), _s25, lanes_sub(lanes_add(lanes_add(_s7, _s16), _s24), _c7));
    const V _s27 = lanes_sub(vz, lanes_mul(_c4, t));
    const V _s28 = lanes_mul(K(2.0), lanes_add(lanes_add(lanes_mul(vx, _s6), lanes_mul(vy, _s23)), lanes_mul(_s27, _s15)));
    const V _s29 = lanes_abs(_s15);
    const V _s30 = lanes_mul(K(2.0), lanes_add(lanes_add(lanes_select(lanes_less(K(0.0), lanes_abs(_s6)), lanes_mul(vx, vx), K(0.0)), lanes_select(lanes_less(K(0.0), _s29), lanes_sub(lanes_mul(_s27, _s27), lanes_mul(_c4, _s15)), K(0.0))), lanes_select(lanes_less(K(0.0), lanes_abs(_s23)), lanes_mul(vy, vy), K(0.0))));
    const V _s31 = lanes_sub(_s28, rate_margin);
    const V _s32 = lanes_sub(_s26, margin);
    const V _s33 = lanes_max(_s32, K(0.0));
    const V _s34 = lanes_neg(_s30);
    const M _s35 = lanes_less(_s31, K(0.0));
    const V _s36 = lanes_mul(K(2.0), _s33);
    const V _s37 = lanes_select(lanes_less(K(0.0), lanes_select(lanes_at_most(K(0.0), _s31), _s33, K(0.0))), K(INFINITY), lanes_div(lanes_select(_s35, _s36, lanes_mul(K(4.0), _s31)), lanes_select(_s35, lanes_neg(_s31), lanes_max(K(0.0), _s34))));
    const V _s38 = lanes_sub(end, t);
    const V _s39 = lanes_min(_s37, _s38);
    const V _s40 = lanes_add(lanes_mul(lanes_add(lanes_mul(_c10, _s39), lanes_abs(_s27)), _s39), _s29);
    const V _s41 = lanes_add(lanes_mul(K(9.094947017729282e-13), ceiling), lanes_mul(K(2.0), lanes_mul(_c8, lanes_min(_c9, _s40))));
    const V _s42 = lanes_add(lanes_mul(lanes_mul(K(2.0), _s41), _s33), lanes_mul(_s31, _s31));
    const V _s43 = lanes_sqrt(_s42);
    const V _s44 = lanes_select(lanes_at_most(K(0.0), _s42), lanes_div(lanes_select(_s35, _s36, lanes_add(_s31, _s43)), lanes_select(_s35, lanes_sub(_s43, _s31), lanes_max(K(0.0), _s41))), K(INFINITY));
    const V _s45 = lanes_min(_s44, _s39);
    const V _s46 = lanes_neg(lanes_add(rate_margin, _s28));
    return (LANES(court_bridge_advance_out)){ _s26, _s28, _s30, _s45, lanes_add(t, _s45), lanes_select(lanes_less(K(0.0), _s46), lanes_sub(lanes_mul(_s46, _s46), lanes_mul(lanes_mul(K(8.0), ceiling), lanes_add(margin, _s36))), _s46) };
}

/* Whether a flight may reach the box of a surface at all.
   disjoint boxes. 51 operations: 10 additions, 10 subtractions, 6 multiplications, 2 negations, 6 absolute values, 8 comparisons, 1 disjunction, 2 complements, 6 selections. */
typedef struct {
    M near, first_near, later_near;
} LANES(court_bridge_near_out);

LANES_INLINE LANES(court_bridge_near_out)
LANES(court_bridge_near)(V middle_x, V middle_y, V middle_z, V reach_x, V reach_y, V reach_z, V later_middle_x, V later_middle_y, V later_middle_z, V later_reach_x, V later_reach_y, V later_reach_z, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_sub(lanes_abs(lanes_sub(_c1, middle_x)), lanes_add(reach_x, _c2));
    const V _s1 = lanes_max(_s0, K(0.0));
    const V _s2 = lanes_sub(lanes_abs(lanes_neg(middle_y)), lanes_add(reach_y, _c3));
    const V _s3 = lanes_max(_s2, K(0.0));
    const V _s4 = lanes_sub(lanes_abs(lanes_sub(_c4, middle_z)), lanes_add(reach_z, _c5));
    const V _s5 = lanes_max(_s4, K(0.0));
    const M _s6 = lanes_not(lanes_less(_c0, lanes_add(lanes_add(lanes_mul(_s1, _s1), lanes_mul(_s3, _s3)), lanes_mul(_s5, _s5))));
    const V _s7 = lanes_sub(lanes_abs(lanes_sub(_c1, later_middle_x)), lanes_add(later_reach_x, _c2));
    const V _s8 = lanes_max(_s7, K(0.0));
    const V _s9 = lanes_sub(lanes_abs(lanes_neg(later_middle_y)), lanes_add(later_reach_y, _c3));
    const V _s10 = lanes_max(_s9, K(0.0));
    const V _s11 = lanes_sub(lanes_abs(lanes_sub(_c4, later_middle_z)), lanes_add(later_reach_z, _c5));
    const V _s12 = lanes_max(_s11, K(0.0));
    const M _s13 = lanes_not(lanes_less(_c0, lanes_add(lanes_add(lanes_mul(_s8, _s8), lanes_mul(_s10, _s10)), lanes_mul(_s12, _s12))));
    return (LANES(court_bridge_near_out)){ lanes_either(_s6, _s13), _s6, _s13 };
}

/* Whether a flight that comes near a surface may come to it.
   a separating direction. 79 operations: 17 additions, 7 subtractions, 19 multiplications, 3 negations, 3 absolute values, 14 comparisons, 5 conjunctions, 3 disjunctions, 1 complement, 7 selections. */
typedef struct {
    M near;
} LANES(court_bridge_approaches_out);

LANES_INLINE LANES(court_bridge_approaches_out)
LANES(court_bridge_approaches)(V leaving, V horizon, V x, V y, V z, V vx, V vy, V vz, V extent, V speed, V position_error, V velocity_error, V earliest_delay, V pad, M first_near, M later_near, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6)
{
    const V _s0 = lanes_add(_c0, x);
    const V _s1 = lanes_neg(lanes_add(_c2, x));
    const V _s2 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s3 = lanes_sub(z, _c1);
    const V _s4 = lanes_sub(_c6, z);
    const V _s5 = lanes_sub(lanes_max(_s3, K(0.0)), lanes_max(_s4, K(0.0)));
    const V _s6 = lanes_sub(y, _c3);
    const V _s7 = lanes_neg(lanes_add(_c3, y));
    const V _s8 = lanes_sub(lanes_max(_s6, K(0.0)), lanes_max(_s7, K(0.0)));
    const V _s9 = lanes_add(lanes_add(lanes_abs(_s2), lanes_abs(_s5)), lanes_abs(_s8));
    const V _s10 = lanes_add(position_error, lanes_mul(K(9.313225746154785e-10), lanes_add(extent, _s9)));
    const M _s11 = lanes_both(lanes_either(lanes_at_most(K(1.0), leaving), lanes_less(lanes_add(_c5, lanes_mul(K(4.0), lanes_mul(_s10, _s9))), lanes_add(lanes_add(lanes_mul(_s2, _s2), lanes_mul(_s5, _s5)), lanes_mul(_s8, _s8)))), lanes_at_most(earliest_delay, pad));
    const V _s12 = lanes_mul(K(4.0), lanes_add(lanes_mul(velocity_error, _s9), lanes_mul(_s10, lanes_add(velocity_error, lanes_add(speed, lanes_mul(_c4, horizon))))));
    const V _s13 = lanes_sub(lanes_add(lanes_add(lanes_mul(vx, _s2), lanes_mul(vy, _s8)), lanes_mul(vz, _s5)), _s12);
    const V _s14 = lanes_mul(lanes_mul(K(0.5), horizon), lanes_neg(lanes_mul(_c4, _s5)));
    const V _s15 = lanes_min(_s14, K(0.0));
    const M _s16 = lanes_either(lanes_not(lanes_both(lanes_both(_s11, lanes_at_most(position_error, lanes_mul(K(2.9802322387695312e-08), extent))), lanes_at_most(velocity_error, lanes_mul(K(2.9802322387695312e-08), speed)))), lanes_either(lanes_both(first_near, lanes_at_most(lanes_add(_s13, lanes_mul(K(0.5), _s15)), K(0.0))), lanes_both(later_near, lanes_at_most(lanes_add(_s13, _s15), K(0.0)))));
    return (LANES(court_bridge_approaches_out)){ _s16 };
}

/* Distance, its rate, and a bound on how fast it bends down, by the squared speed.
   Table 2. 58 operations: 7 additions, 10 subtractions, 10 multiplications, 1 division, 1 square root, 5 negations, 12 comparisons, 12 selections. */
typedef struct {
    V gap, nearing, gap_curvature;
} LANES(court_bridge_beside_out);

LANES_INLINE LANES(court_bridge_beside_out)
LANES(court_bridge_beside)(V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(_c3, x);
    const V _s1 = lanes_neg(lanes_add(_c1, x));
    const V _s2 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s3 = lanes_sub(z, _c4);
    const V _s4 = lanes_sub(_c5, z);
    const V _s5 = lanes_sub(lanes_max(_s3, K(0.0)), lanes_max(_s4, K(0.0)));
    const V _s6 = lanes_sub(y, _c2);
    const V _s7 = lanes_neg(lanes_add(_c2, y));
    const V _s8 = lanes_sub(lanes_max(_s6, K(0.0)), lanes_max(_s7, K(0.0)));
    const V _s9 = lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s2, _s2), lanes_mul(_s5, _s5)), lanes_mul(_s8, _s8)));
    const V _s10 = lanes_add(lanes_mul(lanes_mul(K(2.0), lanes_sub(lanes_select(lanes_less(_s0, K(0.0)), K(0.0), vx), lanes_select(lanes_less(_s1, K(0.0)), K(0.0), lanes_neg(vx)))), _s2), lanes_mul(lanes_mul(K(2.0), lanes_sub(lanes_select(lanes_less(_s3, K(0.0)), K(0.0), vz), lanes_select(lanes_less(_s4, K(0.0)), K(0.0), lanes_neg(vz)))), _s5));
    const V _s11 = lanes_add(_s10, lanes_mul(lanes_mul(K(2.0), lanes_sub(lanes_select(lanes_less(_s6, K(0.0)), K(0.0), vy), lanes_select(lanes_less(_s7, K(0.0)), K(0.0), lanes_neg(vy)))), _s8));
    return (LANES(court_bridge_beside_out)){ lanes_sub(_s9, _c0), lanes_div(lanes_mul(K(0.5), _s11), _s9), K(0.0) };
}

/* Distance of a ball that rolls on another surface, and its first two derivatives.
   derivatives of Table 2's distance. 114 operations: 15 additions, 16 subtractions, 33 multiplications, 1 division, 1 square root, 12 negations, 12 comparisons, 24 selections. */
typedef struct {
    V gap, nearing, rolling_gap_acceleration, normal_cosine;
} LANES(court_bridge_closing_out);

LANES_INLINE LANES(court_bridge_closing_out)
LANES(court_bridge_closing)(V x, V y, V z, V nx, V ny, V nz, V rolled_x, V rolled_y, V rolled_z, V rolling_acceleration_x, V rolling_acceleration_y, V rolling_acceleration_z, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(_c3, x);
    const V _s1 = lanes_neg(lanes_add(_c1, x));
    const V _s2 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s3 = lanes_sub(z, _c4);
    const V _s4 = lanes_sub(_c5, z);
    const V _s5 = lanes_sub(lanes_max(_s3, K(0.0)), lanes_max(_s4, K(0.0)));
    const V _s6 = lanes_sub(y, _c2);
    const V _s7 = lanes_neg(lanes_add(_c2, y));
    const V _s8 = lanes_sub(lanes_max(_s6, K(0.0)), lanes_max(_s7, K(0.0)));
    const V _s9 = lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s2, _s2), lanes_mul(_s5, _s5)), lanes_mul(_s8, _s8)));
    const M _s10 = lanes_less(_s0, K(0.0));
    const M _s11 = lanes_less(_s1, K(0.0));
    const V _s12 = lanes_sub(lanes_select(_s10, K(0.0), rolled_x), lanes_select(_s11, K(0.0), lanes_neg(rolled_x)));
    const M _s13 = lanes_less(_s3, K(0.0));
    const M _s14 = lanes_less(_s4, K(0.0));
    const V _s15 = lanes_sub(lanes_select(_s13, K(0.0), rolled_z), lanes_select(_s14, K(0.0), lanes_neg(rolled_z)));
    const M _s16 = lanes_less(_s6, K(0.0));
    const M _s17 = lanes_less(_s7, K(0.0));
    const V _s18 = lanes_sub(lanes_select(_s16, K(0.0), rolled_y), lanes_select(_s17, K(0.0), lanes_neg(rolled_y)));
    const V _s19 = lanes_add(lanes_add(lanes_mul(lanes_mul(K(2.0), _s12), _s2), lanes_mul(lanes_mul(K(2.0), _s15), _s5)), lanes_mul(lanes_mul(K(2.0), _s18), _s8));
    const V _s20 = lanes_div(K(1.0), _s9);
    const V _s21 = lanes_mul(lanes_mul(K(0.5), _s19), _s20);
    const V _s22 = lanes_mul(K(2.0), lanes_add(lanes_mul(lanes_sub(lanes_select(_s10, K(0.0), rolling_acceleration_x), lanes_select(_s11, K(0.0), lanes_neg(rolling_acceleration_x))), _s2), lanes_mul(_s12, _s12)));
    const V _s23 = lanes_mul(K(2.0), lanes_add(lanes_mul(lanes_sub(lanes_select(_s13, K(0.0), rolling_acceleration_z), lanes_select(_s14, K(0.0), lanes_neg(rolling_acceleration_z))), _s5), lanes_mul(_s15, _s15)));
    const V _s24 = lanes_mul(K(2.0), lanes_add(lanes_mul(lanes_sub(lanes_select(_s16, K(0.0), rolling_acceleration_y), lanes_select(_s17, K(0.0), lanes_neg(rolling_acceleration_y))), _s8), lanes_mul(_s18, _s18)));
    const V _s25 = lanes_mul(K(0.5), lanes_add(lanes_mul(lanes_neg(lanes_mul(_s21, lanes_mul(_s20, _s20))), _s19), lanes_mul(lanes_add(lanes_add(_s22, _s23), _s24), _s20)));
    const V _s26 = lanes_add(lanes_mul(lanes_mul(K(2.0), lanes_sub(lanes_select(_s10, K(0.0), nx), lanes_select(_s11, K(0.0), lanes_neg(nx)))), _s2), lanes_mul(lanes_mul(K(2.0), lanes_sub(lanes_select(_s13, K(0.0), nz), lanes_select(_s14, K(0.0), lanes_neg(nz)))), _s5));
    const V _s27 = lanes_add(_s26, lanes_mul(lanes_mul(K(2.0), lanes_sub(lanes_select(_s16, K(0.0), ny), lanes_select(_s17, K(0.0), lanes_neg(ny)))), _s8));
    return (LANES(court_bridge_closing_out)){ lanes_sub(_s9, _c0), _s21, _s25, lanes_mul(lanes_mul(K(0.5), _s27), _s20) };
}

/* Distance from the surface.
   Table 2. 30 operations: 5 additions, 7 subtractions, 3 multiplications, 1 square root, 2 negations, 6 comparisons, 6 selections. */
typedef struct {
    V gap;
} LANES(court_bridge_distance_out);

LANES_INLINE LANES(court_bridge_distance_out)
LANES(court_bridge_distance)(V x, V y, V z, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(_c3, x);
    const V _s1 = lanes_neg(lanes_add(_c1, x));
    const V _s2 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s3 = lanes_sub(z, _c4);
    const V _s4 = lanes_sub(_c5, z);
    const V _s5 = lanes_sub(lanes_max(_s3, K(0.0)), lanes_max(_s4, K(0.0)));
    const V _s6 = lanes_sub(y, _c2);
    const V _s7 = lanes_neg(lanes_add(_c2, y));
    const V _s8 = lanes_sub(lanes_max(_s6, K(0.0)), lanes_max(_s7, K(0.0)));
    return (LANES(court_bridge_distance_out)){ lanes_sub(lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s2, _s2), lanes_mul(_s5, _s5)), lanes_mul(_s8, _s8))), _c0) };
}

/* Curvature of the surface that the centre of a rolling ball stays on.
   Table 2. 47 operations: 3 additions, 3 subtractions, 5 negations, 18 comparisons, 6 conjunctions, 9 disjunctions, 3 selections. */
typedef struct {
    V bent_x, bent_y, bent_z, per_reach;
} LANES(court_bridge_rolling_surface_out);

LANES_INLINE LANES(court_bridge_rolling_surface_out)
LANES(court_bridge_rolling_surface)(V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6, V _c7, V _c8, V _c9, V _c10, V _c11)
{
    const V _s0 = lanes_add(_c2, x);
    const V _s1 = lanes_neg(lanes_add(_c0, x));
    const V _s2 = lanes_select(lanes_either(lanes_either(lanes_less(_c4, _s0), lanes_both(lanes_less(_c5, _s0), lanes_less(K(0.0), vx))), lanes_either(lanes_less(_c4, _s1), lanes_both(lanes_less(_c5, _s1), lanes_less(K(0.0), lanes_neg(vx))))), K(1.0), K(0.0));
    const V _s3 = lanes_sub(y, _c1);
    const V _s4 = lanes_neg(lanes_add(_c1, y));
    const V _s5 = lanes_select(lanes_either(lanes_either(lanes_less(_c6, _s3), lanes_both(lanes_less(_c7, _s3), lanes_less(K(0.0), vy))), lanes_either(lanes_less(_c6, _s4), lanes_both(lanes_less(_c7, _s4), lanes_less(K(0.0), lanes_neg(vy))))), K(1.0), K(0.0));
    const V _s6 = lanes_sub(z, _c3);
    const V _s7 = lanes_sub(_c10, z);
    const V _s8 = lanes_select(lanes_either(lanes_either(lanes_less(_c8, _s6), lanes_both(lanes_less(_c9, _s6), lanes_less(K(0.0), vz))), lanes_either(lanes_less(_c8, _s7), lanes_both(lanes_less(_c9, _s7), lanes_less(K(0.0), lanes_neg(vz))))), K(1.0), K(0.0));
    return (LANES(court_bridge_rolling_surface_out)){ _s2, _s5, _s8, _c11 };
}

/* Rate of the normal.
   derivative of Table 2's normal. 75 operations: 7 additions, 12 subtractions, 15 multiplications, 7 divisions, 1 square root, 5 negations, 14 comparisons, 14 selections. */
typedef struct {
    V turning_x, turning_y, turning_z;
} LANES(court_bridge_turning_out);

LANES_INLINE LANES(court_bridge_turning_out)
LANES(court_bridge_turning)(V x, V y, V z, V rolled_x, V rolled_y, V rolled_z, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const V _s0 = lanes_add(_c2, x);
    const V _s1 = lanes_neg(lanes_add(_c0, x));
    const V _s2 = lanes_sub(lanes_select(lanes_less(_s0, K(0.0)), K(0.0), rolled_x), lanes_select(lanes_less(_s1, K(0.0)), K(0.0), lanes_neg(rolled_x)));
    const V _s3 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s4 = lanes_sub(z, _c3);
    const V _s5 = lanes_sub(_c4, z);
    const V _s6 = lanes_sub(lanes_max(_s4, K(0.0)), lanes_max(_s5, K(0.0)));
    const V _s7 = lanes_sub(y, _c1);
    const V _s8 = lanes_neg(lanes_add(_c1, y));
    const V _s9 = lanes_sub(lanes_max(_s7, K(0.0)), lanes_max(_s8, K(0.0)));
    const V _s10 = lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s3, _s3), lanes_mul(_s6, _s6)), lanes_mul(_s9, _s9)));
    const V _s11 = lanes_max(_s10, _c5);
    const V _s12 = lanes_sub(lanes_select(lanes_less(_s4, K(0.0)), K(0.0), rolled_z), lanes_select(lanes_less(_s5, K(0.0)), K(0.0), lanes_neg(rolled_z)));
    const V _s13 = lanes_sub(lanes_select(lanes_less(_s7, K(0.0)), K(0.0), rolled_y), lanes_select(lanes_less(_s8, K(0.0)), K(0.0), lanes_neg(rolled_y)));
    const V _s14 = lanes_mul(lanes_mul(K(0.5), lanes_add(lanes_add(lanes_mul(lanes_mul(K(2.0), _s2), _s3), lanes_mul(lanes_mul(K(2.0), _s12), _s6)), lanes_mul(lanes_mul(K(2.0), _s13), _s9))), lanes_div(K(1.0), _s10));
    const V _s15 = lanes_select(lanes_less(_s10, _c5), K(0.0), _s14);
    const V _s16 = lanes_mul(_s11, _s11);
    return (LANES(court_bridge_turning_out)){ lanes_sub(lanes_div(_s2, _s11), lanes_div(lanes_mul(_s3, _s15), _s16)), lanes_sub(lanes_div(_s13, _s11), lanes_div(lanes_mul(_s9, _s15), _s16)), lanes_sub(lanes_div(_s12, _s11), lanes_div(lanes_mul(_s6, _s15), _s16)) };
}

/* Second to fourth derivative of the distance along a flight.
   derivatives of Table 2's distance. 125 operations: 26 additions, 10 subtractions, 53 multiplications, 1 division, 1 square root, 8 negations, 12 comparisons, 14 selections. */
typedef struct {
    V lift, gap_jerk, gap_snap;
} LANES(court_bridge_separation_out);

LANES_INLINE LANES(court_bridge_separation_out)
LANES(court_bridge_separation)(V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5, V _c6)
{
    const V _s0 = lanes_add(_c3, x);
    const V _s1 = lanes_neg(lanes_add(_c0, x));
    const V _s2 = lanes_sub(lanes_select(lanes_less(_s0, K(0.0)), K(0.0), vx), lanes_select(lanes_less(_s1, K(0.0)), K(0.0), lanes_neg(vx)));
    const V _s3 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s4 = lanes_sub(z, _c4);
    const M _s5 = lanes_less(_s4, K(0.0));
    const V _s6 = lanes_sub(_c5, z);
    const M _s7 = lanes_less(_s6, K(0.0));
    const V _s8 = lanes_sub(lanes_select(_s5, K(0.0), vz), lanes_select(_s7, K(0.0), lanes_neg(vz)));
    const V _s9 = lanes_sub(lanes_max(_s4, K(0.0)), lanes_max(_s6, K(0.0)));
    const V _s10 = lanes_sub(y, _c1);
    const V _s11 = lanes_neg(lanes_add(_c1, y));
    const V _s12 = lanes_sub(lanes_select(lanes_less(_s10, K(0.0)), K(0.0), vy), lanes_select(lanes_less(_s11, K(0.0)), K(0.0), lanes_neg(vy)));
    const V _s13 = lanes_sub(lanes_max(_s10, K(0.0)), lanes_max(_s11, K(0.0)));
    const V _s14 = lanes_add(lanes_add(lanes_mul(lanes_mul(K(2.0), _s2), _s3), lanes_mul(lanes_mul(K(2.0), _s8), _s9)), lanes_mul(lanes_mul(K(2.0), _s12), _s13));
    const V _s15 = lanes_div(K(1.0), lanes_sqrt(lanes_add(lanes_add(lanes_mul(_s3, _s3), lanes_mul(_s9, _s9)), lanes_mul(_s13, _s13))));
    const V _s16 = lanes_mul(lanes_mul(K(0.5), _s14), _s15);
    const V _s17 = lanes_mul(_s15, _s15);
    const V _s18 = lanes_neg(lanes_mul(_s16, _s17));
    const V _s19 = lanes_sub(lanes_select(_s5, K(0.0), _c6), lanes_select(_s7, K(0.0), _c2));
    const V _s20 = lanes_add(lanes_add(lanes_mul(K(2.0), lanes_add(lanes_mul(_s19, _s9), lanes_mul(_s8, _s8))), lanes_mul(K(2.0), lanes_mul(_s2, _s2))), lanes_mul(K(2.0), lanes_mul(_s12, _s12)));
    const V _s21 = lanes_mul(K(0.5), lanes_add(lanes_mul(_s18, _s14), lanes_mul(_s20, _s15)));
    const V _s22 = lanes_mul(_s18, _s20);
    const V _s23 = lanes_mul(K(2.0), _s18);
    const V _s24 = lanes_neg(lanes_add(lanes_mul(_s21, _s17), lanes_mul(lanes_mul(_s23, _s16), _s15)));
    const V _s25 = lanes_mul(K(2.0), lanes_add(lanes_mul(lanes_mul(K(2.0), _s19), _s8), lanes_mul(_s19, _s8)));
    const V _s26 = lanes_mul(K(0.5), lanes_add(lanes_add(_s22, lanes_mul(_s14, _s24)), lanes_add(_s22, lanes_mul(_s25, _s15))));
    const V _s27 = lanes_mul(_s18, _s25);
    const V _s28 = lanes_mul(_s20, _s24);
    const V _s29 = lanes_add(_s27, _s28);
    const V _s30 = lanes_add(_s29, lanes_add(_s27, lanes_mul(_s15, lanes_mul(K(2.0), lanes_mul(K(3.0), lanes_mul(_s19, _s19))))));
    const V _s31 = lanes_add(lanes_add(lanes_mul(_s26, _s17), lanes_mul(lanes_mul(_s23, _s21), _s15)), lanes_mul(K(2.0), lanes_add(lanes_add(lanes_mul(lanes_mul(_s18, _s18), _s16), lanes_mul(lanes_mul(_s18, _s21), _s15)), lanes_mul(lanes_mul(_s16, _s24), _s15))));
    const V _s32 = lanes_mul(K(0.5), lanes_add(_s30, lanes_add(_s29, lanes_add(lanes_mul(_s14, lanes_neg(_s31)), _s28))));
    return (LANES(court_bridge_separation_out)){ _s21, _s26, _s32 };
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 1 operation: 1 addition. */
typedef struct {
    V gap, nearing, near;
} LANES(court_bridge_seam0_out);

LANES_INLINE LANES(court_bridge_seam0_out)
LANES(court_bridge_seam0)(V x, V vx, V _c0, V _c1)
{
    return (LANES(court_bridge_seam0_out)){ lanes_add(_c0, x), vx, _c1 };
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 1 operation: 1 addition. */
typedef struct {
    V gap, nearing, near;
} LANES(court_bridge_seam1_out);

LANES_INLINE LANES(court_bridge_seam1_out)
LANES(court_bridge_seam1)(V x, V vx, V _c0, V _c1)
{
    return (LANES(court_bridge_seam1_out)){ lanes_add(_c0, x), vx, _c1 };
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 1 operation: 1 addition. */
typedef struct {
    V gap, nearing, near;
} LANES(court_bridge_seam2_out);

LANES_INLINE LANES(court_bridge_seam2_out)
LANES(court_bridge_seam2)(V y, V vy, V _c0, V _c1)
{
    return (LANES(court_bridge_seam2_out)){ lanes_add(_c0, y), vy, _c1 };
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 1 operation: 1 subtraction. */
typedef struct {
    V gap, nearing, near;
} LANES(court_bridge_seam3_out);

LANES_INLINE LANES(court_bridge_seam3_out)
LANES(court_bridge_seam3)(V y, V vy, V _c0, V _c1)
{
    return (LANES(court_bridge_seam3_out)){ lanes_sub(y, _c0), vy, _c1 };
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 2 operations: 1 addition, 1 subtraction. */
typedef struct {
    V gap, nearing, near;
} LANES(court_bridge_seam4_out);

LANES_INLINE LANES(court_bridge_seam4_out)
LANES(court_bridge_seam4)(V z, V vz, V _c0, V _c1, V _c2)
{
    return (LANES(court_bridge_seam4_out)){ lanes_sub(lanes_add(_c0, z), _c1), vz, _c2 };
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 1 operation: 1 subtraction. */
typedef struct {
    V gap, nearing, near;
} LANES(court_bridge_seam5_out);

LANES_INLINE LANES(court_bridge_seam5_out)
LANES(court_bridge_seam5)(V z, V vz, V _c0, V _c1)
{
    return (LANES(court_bridge_seam5_out)){ lanes_sub(z, _c0), vz, _c1 };
}

/* Bound below the distance at this height and distance from the axis, and its rate.
   Table 2. 43 operations: 4 additions, 6 subtractions, 15 multiplications, 2 divisions, 2 square roots, 2 negations, 6 comparisons, 6 selections. */
typedef struct {
    V gap, nearing;
} LANES(court_bridge_around_out);

LANES_INLINE LANES(court_bridge_around_out)
LANES(court_bridge_around)(V x, V y, V z, V vx, V vy, V vz, V _c0, V _c1, V _c2, V _c3)
{
    const V _s0 = lanes_sub(z, _c1);
    const V _s1 = lanes_sub(_c2, z);
    const V _s2 = lanes_sub(lanes_max(_s0, K(0.0)), lanes_max(_s1, K(0.0)));
    const V _s3 = lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y)));
    const V _s4 = lanes_sub(_c3, _s3);
    const V _s5 = lanes_max(K(0.0), _s4);
    const V _s6 = lanes_sqrt(lanes_add(lanes_mul(_s2, _s2), lanes_mul(_s5, _s5)));
    const V _s7 = lanes_neg(lanes_mul(lanes_mul(K(0.5), lanes_add(lanes_mul(lanes_mul(K(2.0), x), vx), lanes_mul(lanes_mul(K(2.0), y), vy))), lanes_div(K(1.0), _s3)));
    const V _s8 = lanes_add(lanes_mul(lanes_mul(K(2.0), lanes_sub(lanes_select(lanes_less(_s0, K(0.0)), K(0.0), vz), lanes_select(lanes_less(_s1, K(0.0)), K(0.0), lanes_neg(vz)))), _s2), lanes_mul(lanes_mul(K(2.0), _s5), lanes_select(lanes_less(K(0.0), _s4), _s7, K(0.0))));
    return (LANES(court_bridge_around_out)){ lanes_sub(_s6, _c0), lanes_div(lanes_mul(K(0.5), _s8), _s6) };
}

/* First window that ends later than a time, from then on.
   Table 1. 12 operations: 4 comparisons, 2 disjunctions, 6 selections. */
typedef struct {
    V t, end;
    M searching;
} LANES(court_bridge_enter_out);

LANES_INLINE LANES(court_bridge_enter_out)
LANES(court_bridge_enter)(V t, V end, V after, V low0, V low1, V high0, V high1)
{
    const V _s0 = lanes_max(after, low0);
    const M _s1 = lanes_less(_s0, high0);
    const V _s2 = lanes_max(after, low1);
    const M _s3 = lanes_less(_s2, high1);
    return (LANES(court_bridge_enter_out)){ lanes_select(_s1, _s0, lanes_select(_s3, _s2, t)), lanes_select(_s1, high0, lanes_select(_s3, high1, end)), lanes_either(lanes_either(mask_none(), _s3), _s1) };
}

/* Outward unit normal n3 at a contact.
   Table 2. No operations. */
typedef struct {
    V nx, ny, nz;
} LANES(court_end_normal_out);

LANES_INLINE LANES(court_end_normal_out)
LANES(court_end_normal)(void)
{
    return (LANES(court_end_normal_out)){ K(0.0), K(0.0), K(1.0) };
}

/* Tangent and curvatures at a contact, and bounds on the roundings there.
   Table 2, running error analysis. 11 operations: 4 additions, 4 multiplications, 3 absolute values. */
typedef struct {
    S tangent_x, tangent_y, bend_s, bend_e, sharpest_bend, root_offset, root_level, normal_rounding;
} LANES(court_end_tangents_out);

LANES_INLINE LANES(court_end_tangents_out)
LANES(court_end_tangents)(S t, S z, S vz, S _c0)
{
    const S _s0 = singles_add(singles_mul(singles_mul(KS(4.0), t), singles_add(singles_abs(vz), singles_abs(singles_add(vz, singles_mul(_c0, t))))), singles_abs(z));
    const S _s1 = singles_add(KS(7.888609052210118e-31), singles_mul(KS(1.1102230246251565e-16), _s0));
    return (LANES(court_end_tangents_out)){ KS(0.0), KS(1.0), KS(0.0), KS(0.0), KS(0.0), _s1, _s1, KS(0.0) };
}

/* Time of the only arrival, the gap's first two derivatives there, and its apex.
   Eq. 3 in Table 2, solved. 23 operations: 2 additions, 2 subtractions, 5 multiplications, 1 division, 1 square root, 3 negations, 1 absolute value, 2 comparisons, 6 selections. */
typedef struct {
    V time, rate, bend, apex, height;
} LANES(court_end_arrival_out);

LANES_INLINE LANES(court_end_arrival_out)
LANES(court_end_arrival)(V leaving, V z, V vz, V _c0, V _c1, V _c2, V _c3, V _c4, V _c5)
{
    const M _s0 = lanes_less(K(0.0), leaving);
    const V _s1 = lanes_select(_s0, K(0.0), lanes_sub(z, _c1));
    const V _s2 = lanes_add(lanes_mul(vz, vz), lanes_mul(_c2, _s1));
    const V _s3 = lanes_select(_s0, lanes_abs(vz), lanes_sqrt(_s2));
    const M _s4 = lanes_less(vz, K(0.0));
    return (LANES(court_end_arrival_out)){ lanes_div(lanes_select(_s4, lanes_mul(K(2.0), _s1), lanes_add(vz, _s3)), lanes_select(_s4, lanes_sub(_s3, vz), _c0)), lanes_neg(_s3), _c3, lanes_select(_s4, K(0.0), lanes_neg(lanes_mul(vz, _c4))), lanes_select(_s4, _s1, lanes_neg(lanes_mul(_c5, _s2))) };
}

/* Rounding-error bound of the gap up to the horizon.
   running error analysis. 12 operations: 6 additions, 6 multiplications. */
typedef struct {
    V margin;
} LANES(court_end_margin_out);

LANES_INLINE LANES(court_end_margin_out)
LANES(court_end_margin)(V horizon, V extent, V speed, V position_error, V velocity_error, V _c0, V _c1)
{
    const V _s0 = lanes_add(extent, lanes_mul(horizon, lanes_add(speed, lanes_mul(_c0, horizon))));
    return (LANES(court_end_margin_out)){ lanes_add(lanes_add(_c1, lanes_mul(K(2.222614453595284e-16), _s0)), lanes_mul(K(2.001953125), lanes_add(lanes_add(position_error, lanes_mul(horizon, velocity_error)), lanes_mul(K(4.440892098500626e-16), _s0)))) };
}

/* Bounds of the ends on a plane; the first whose bounds all hold is reached.
   Table 2, success. 5 operations: 1 addition, 1 subtraction, 2 multiplications, 1 square root. */
typedef struct {
    V g0;
} LANES(court_end_bounds_out);

LANES_INLINE LANES(court_end_bounds_out)
LANES(court_end_bounds)(V x, V y, V _c0)
{
    return (LANES(court_end_bounds_out)){ lanes_sub(lanes_sqrt(lanes_add(lanes_mul(x, x), lanes_mul(y, y))), _c0) };
}

/* Distance, its rate, and a bound on how fast it bends down, by the squared speed.
   Table 2. 1 operation: 1 subtraction. */
typedef struct {
    V gap, nearing, gap_curvature;
} LANES(court_end_beside_out);

LANES_INLINE LANES(court_end_beside_out)
LANES(court_end_beside)(V z, V vz, V _c0)
{
    return (LANES(court_end_beside_out)){ lanes_sub(z, _c0), vz, K(0.0) };
}

/* Bound below the distance at this height and distance from the axis, and its rate.
   Table 2. 1 operation: 1 subtraction. */
typedef struct {
    V gap, nearing;
} LANES(court_end_around_out);

LANES_INLINE LANES(court_end_around_out)
LANES(court_end_around)(V z, V vz, V _c0)
{
    return (LANES(court_end_around_out)){ lanes_sub(z, _c0), vz };
}

/* End that a crossing reaches.
   Table 1. 4 operations: 2 comparisons, 1 conjunction, 1 selection. */
typedef struct {
    V reached;
} LANES(court_end_reached_out);

LANES_INLINE LANES(court_end_reached_out)
LANES(court_end_reached)(V through, V g0)
{
    return (LANES(court_end_reached_out)){ lanes_select(lanes_both(lanes_at_most(g0, K(0.0)), lanes_equal(through, K(1.0))), K(0.0), K(1.0)) };
}

/* Whether the choice of the end lies within its error.
   Table 1. 7 operations: 1 negation, 3 comparisons, 2 conjunctions, 1 complement. */
typedef struct {
    M edge;
} LANES(court_end_edge_out);

LANES_INLINE LANES(court_end_edge_out)
LANES(court_end_edge)(V slack, V through, V g0)
{
    return (LANES(court_end_edge_out)){ lanes_both(lanes_both(lanes_at_most(g0, slack), lanes_not(lanes_less(g0, lanes_neg(slack)))), lanes_equal(through, K(1.0))) };
}

