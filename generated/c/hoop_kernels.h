/* Kernels of the scene hoop, in C.

   Generated from templates/c/kernels.h.j2, scene hoop, derivation 4e3fee7f36fc1578,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Included once for every vector width, after these are defined:
     V, M          a vector of doubles and its comparison result (or double and int)
     K(c)          the constant c in every lane
     LANES(name)   the name of a function for this width
     lanes_sqrt, lanes_abs, lanes_select */

/* Position and velocity at time t of a flight.
   Eq. 3. 11 operations: 3 additions, 2 subtractions, 6 multiplications. */
typedef struct {
    V x;
    V y;
    V z;
    V vx;
    V vy;
    V vz;
} LANES(hoop_flight_out);

LANES_INLINE LANES(hoop_flight_out)
LANES(hoop_flight)(V t, V x, V y, V z, V vx, V vy, V vz, V gravity)
{
    return (LANES(hoop_flight_out)){ x + (t * vx), y + (t * vy), z + (t * (vz - ((K(0.5) * gravity) * t))), vx, vy, vz - (gravity * t) };
}

/* Positive clearance if a crossing is certain, and the bound on its delay.
   Taylor's theorem with the margins of the gap and its rate. 11 operations: 1 addition, 1 subtraction, 4 multiplications, 1 division, 1 negation, 1 comparison, 2 selections. */
typedef struct {
    V clearance;
    V delay;
} LANES(hoop_crossing_out);

LANES_INLINE LANES(hoop_crossing_out)
LANES(hoop_crossing)(V margin, V rate_margin, V rate, V ceiling)
{
    const V s0 = -(rate + rate_margin);
    const M s1 = K(0.0) < s0;
    return (LANES(hoop_crossing_out)){ lanes_select(s1, ((s0 * s0) - ((K(6.0) * ceiling) * margin)), s0), lanes_select(s1, ((K(6.0) * margin) / s0), K(INFINITY)) };
}

/* Errors of a state that a search allows for, and by how much the errors exceed them.
   a share of the size of the flight. 10 operations: 2 additions, 2 subtractions, 4 multiplications, 1 comparison, 1 selection. */
typedef struct {
    V level;
    V velocity_level;
    V excess;
} LANES(hoop_allowance_out);

LANES_INLINE LANES(hoop_allowance_out)
LANES(hoop_allowance)(V share, V horizon, V extent, V speed, V position_error, V velocity_error, V gravity)
{
    const V s0 = speed + (gravity * horizon);
    const V s1 = share * (extent + (horizon * s0));
    const V s2 = share * s0;
    const V s3 = position_error - s1;
    const V s4 = velocity_error - s2;
    return (LANES(hoop_allowance_out)){ s1, s2, lanes_select((s3 < s4), s4, s3) };
}

/* A time after which no event is wanted, and how long that is after t.
   the earliest arrival, with room for its delay. 5 operations: 2 additions, 2 multiplications, 1 division. */
typedef struct {
    V horizon;
    V pad;
} LANES(hoop_horizon_out);

LANES_INLINE LANES(hoop_horizon_out)
LANES(hoop_horizon)(V t, V speed, V gravity)
{
    const V s0 = K(9.5367431640625e-07) * (t + (speed * (K(1.0) / gravity)));
    return (LANES(hoop_horizon_out)){ t + s0, s0 };
}

/* Sums of the sizes of the coordinates and of the velocities; excess over the largest.
   what rounding errors are measured by. 24 operations: 4 additions, 1 subtraction, 1 division, 6 absolute values, 6 comparisons, 6 selections. */
typedef struct {
    V extent;
    V speed;
    V excess;
} LANES(hoop_scale_out);

LANES_INLINE LANES(hoop_scale_out)
LANES(hoop_scale)(V x, V y, V z, V vx, V vy, V vz, V gravity)
{
    const V s0 = lanes_abs(x);
    const V s1 = lanes_abs(y);
    const V s2 = lanes_abs(z);
    const V s3 = lanes_abs(vx);
    const V s4 = lanes_abs(vy);
    const V s5 = lanes_abs(vz);
    const V s6 = K(1.0) / gravity;
    const V s7 = lanes_select((s6 < s0), s0, s6);
    const V s8 = lanes_select((s7 < s1), s1, s7);
    const V s9 = lanes_select((s8 < s2), s2, s8);
    const V s10 = lanes_select((s9 < s3), s3, s9);
    const V s11 = lanes_select((s10 < s4), s4, s10);
    return (LANES(hoop_scale_out)){ (s0 + s1) + s2, (s3 + s4) + s5, lanes_select((s11 < s5), s5, s11) - K(2.9073548971824276e+135) };
}

/* Bound on the error of a length at a computed arrival.
   running error analysis. 25 operations: 15 additions, 8 multiplications, 2 absolute values. */
typedef struct {
    V margin;
} LANES(hoop_displacement_out);

LANES_INLINE LANES(hoop_displacement_out)
LANES(hoop_displacement)(V delay, V horizon, V extent, V speed, V position_error, V velocity_error, V ball_radius, V ring_radius, V wire_radius, V board_distance, V board_half_width, V board_bottom, V board_top, V bridge_half_width, V gravity, V end_depth)
{
    const V s0 = speed + (gravity * horizon);
    const V s1 = extent + (horizon * s0);
    const V s2 = (((((ball_radius + board_distance) + board_half_width) + bridge_half_width) + end_depth) + ring_radius) + wire_radius;
    const V s3 = ((K(1.0009765625) * delay) * s0) + (K(4.445228907190568e-16) * (s1 + ((s2 + lanes_abs(board_bottom)) + lanes_abs(board_top))));
    return (LANES(hoop_displacement_out)){ s3 + (K(3.0029296875) * ((position_error + (horizon * velocity_error)) + (K(4.440892098500626e-16) * s1))) };
}

/* Errors of a state at the end of a flight to a surface, from those at its start.
   derivative of Eq. 3 and of the contact time, with roundings. 118 operations: 24 additions, 1 subtraction, 30 multiplications, 3 divisions, 5 negations, 17 absolute values, 19 comparisons, 19 selections. */
typedef struct {
    V dx;
    V dy;
    V dz;
    V dvx;
    V dvy;
    V dvz;
    V delay;
    V shift;
} LANES(hoop_carry_flight_out);

LANES_INLINE LANES(hoop_carry_flight_out)
LANES(hoop_carry_flight)(V t, V x, V y, V z, V vx, V vy, V vz, V nx, V ny, V nz, V clock, V contacts, V late, V dx, V dy, V dz, V dvx, V dvy, V dvz, V curving, V gravity)
{
    const V s0 = dx + (dvx * t);
    const V s1 = lanes_abs(vx);
    const V s2 = K(2.0) * t;
    const V s3 = K(1.1102230246251565e-16) * ((s2 * s1) + lanes_abs(x));
    const V s4 = s0 + lanes_select((s0 < K(0.0)), (-s3), s3);
    const V s5 = dy + (dvy * t);
    const V s6 = lanes_abs(vy);
    const V s7 = K(1.1102230246251565e-16) * ((s2 * s6) + lanes_abs(y));
    const V s8 = s5 + lanes_select((s5 < K(0.0)), (-s7), s7);
    const V s9 = dz + (dvz * t);
    const V s10 = lanes_abs(vz);
    const V s11 = K(1.1102230246251565e-16) * (((gravity * (t * t)) + (s2 * s10)) + lanes_abs(z));
    const V s12 = s9 + lanes_select((s9 < K(0.0)), (-s11), s11);
    const V s13 = ((nx * vx) + (ny * vy)) + (nz * vz);
    const V s14 = (-(((nx * s4) + (ny * s8)) + (nz * s12))) / s13;
    const V s15 = (vx * s14) + s4;
    const V s16 = lanes_select((s1 < s6), s6, s1);
    const V s17 = lanes_select((s16 < s10), s10, s16);
    const V s18 = lanes_abs(dx);
    const V s19 = lanes_abs(dy);
    const V s20 = lanes_select((s18 < s19), s19, s18);
    const V s21 = lanes_abs(dz);
    const V s22 = lanes_select((s20 < s21), s21, s20);
    const V s23 = curving * (t * s17);
    const V s24 = lanes_abs(dvx);
    const V s25 = lanes_abs(dvy);
    const V s26 = lanes_select((s24 < s25), s25, s24);
    const V s27 = lanes_abs(dvz);
    const V s28 = lanes_select((s3 < s7), s7, s3);
    const V s29 = (t * lanes_select((s26 < s27), s27, s26)) + lanes_select((s28 < s11), s11, s28);
    const V s30 = ((s17 / lanes_abs(s13)) * ((s22 * lanes_select((s23 < K(1.0)), s23, K(1.0))) + s29)) + (s29 + s22);
    const V s31 = s30 / (K(8.0) + (K(8.0) * contacts));
    const V s32 = -s31;
    const V s33 = (vy * s14) + s8;
    const V s34 = (vz * s14) + s12;
    const V s35 = lanes_abs(s14);
    const V s36 = K(0.0625) * late;
    return (LANES(hoop_carry_flight_out)){ lanes_select((lanes_abs(s15) < s31), lanes_select((s15 < K(0.0)), s32, s31), s15), lanes_select((lanes_abs(s33) < s31), lanes_select((s33 < K(0.0)), s32, s31), s33), lanes_select((lanes_abs(s34) < s31), lanes_select((s34 < K(0.0)), s32, s31), s34), dvx, dvy, dvz - (gravity * s14), (K(4.440892098500626e-16) * (clock + t)) + lanes_select((s35 < s36), s36, s35), s30 };
}

/* Bounds on the errors of a state and its time that decisions allow for.
   the carried errors times a guard. 25 operations: 4 multiplications, 9 absolute values, 6 comparisons, 6 selections. */
typedef struct {
    V position_error;
    V velocity_error;
    V spin_error;
    V time_error;
} LANES(hoop_error_bounds_out);

LANES_INLINE LANES(hoop_error_bounds_out)
LANES(hoop_error_bounds)(V clock_error, V dx, V dy, V dz, V dvx, V dvy, V dvz, V dwx, V dwy, V dwz)
{
    const V s0 = lanes_abs(dx);
    const V s1 = lanes_abs(dy);
    const V s2 = lanes_select((s0 < s1), s1, s0);
    const V s3 = lanes_abs(dz);
    const V s4 = lanes_abs(dvx);
    const V s5 = lanes_abs(dvy);
    const V s6 = lanes_select((s4 < s5), s5, s4);
    const V s7 = lanes_abs(dvz);
    const V s8 = lanes_abs(dwx);
    const V s9 = lanes_abs(dwy);
    const V s10 = lanes_select((s8 < s9), s9, s8);
    const V s11 = lanes_abs(dwz);
    return (LANES(hoop_error_bounds_out)){ K(16.0) * lanes_select((s2 < s3), s3, s2), K(16.0) * lanes_select((s6 < s7), s7, s6), K(16.0) * lanes_select((s10 < s11), s11, s10), K(16.0) * clock_error };
}

/* Bounds on the errors of a state and its time that a shot claims.
   the carried errors times a larger guard. 25 operations: 4 multiplications, 9 absolute values, 6 comparisons, 6 selections. */
typedef struct {
    V position_error;
    V velocity_error;
    V spin_error;
    V time_error;
} LANES(hoop_claimed_errors_out);

LANES_INLINE LANES(hoop_claimed_errors_out)
LANES(hoop_claimed_errors)(V clock_error, V dx, V dy, V dz, V dvx, V dvy, V dvz, V dwx, V dwy, V dwz)
{
    const V s0 = lanes_abs(dx);
    const V s1 = lanes_abs(dy);
    const V s2 = lanes_select((s0 < s1), s1, s0);
    const V s3 = lanes_abs(dz);
    const V s4 = lanes_abs(dvx);
    const V s5 = lanes_abs(dvy);
    const V s6 = lanes_select((s4 < s5), s5, s4);
    const V s7 = lanes_abs(dvz);
    const V s8 = lanes_abs(dwx);
    const V s9 = lanes_abs(dwy);
    const V s10 = lanes_select((s8 < s9), s9, s8);
    const V s11 = lanes_abs(dwz);
    return (LANES(hoop_claimed_errors_out)){ K(64.0) * lanes_select((s2 < s3), s3, s2), K(64.0) * lanes_select((s6 < s7), s7, s6), K(64.0) * lanes_select((s10 < s11), s11, s10), K(64.0) * clock_error };
}

/* 1 where finite parameters are allowed.
   the scene's requirements. 24 operations: 2 subtractions, 11 comparisons, 11 selections. */
typedef struct {
    V allowed;
} LANES(hoop_allowed_out);

LANES_INLINE LANES(hoop_allowed_out)
LANES(hoop_allowed)(V ball_radius, V ring_radius, V wire_radius, V board_distance, V board_half_width, V bridge_half_width, V restitution, V gravity, V end_depth)
{
    const V s0 = lanes_select((K(0.0) < ring_radius), lanes_select((K(0.0) < ball_radius), lanes_select((K(0.0) < ((ring_radius - ball_radius) - wire_radius)), K(1.0), K(0.0)), K(0.0)), K(0.0));
    const V s1 = lanes_select((K(0.0) <= restitution), lanes_select((K(0.0) < bridge_half_width), lanes_select((K(0.0) < board_half_width), lanes_select((K(0.0) < board_distance), lanes_select((K(0.0) < wire_radius), s0, K(0.0)), K(0.0)), K(0.0)), K(0.0)), K(0.0));
    return (LANES(hoop_allowed_out)){ lanes_select((K(0.0) < end_depth), lanes_select((K(0.0) < gravity), lanes_select((restitution <= K(1.0)), s1, K(0.0)), K(0.0)), K(0.0)) };
}

/* Where the parameters are finite and allowed.
   IEEE 754. 34 operations: 11 absolute values, 12 comparisons, 11 conjunctions. */
typedef struct {
    M permitted;
} LANES(hoop_finite_parameters_out);

LANES_INLINE LANES(hoop_finite_parameters_out)
LANES(hoop_finite_parameters)(V ball_radius, V ring_radius, V wire_radius, V board_distance, V board_half_width, V board_bottom, V board_top, V bridge_half_width, V restitution, V gravity, V end_depth, V allowed)
{
    const M s0 = ((((K(0.0) < allowed) & (lanes_abs(ball_radius) < K(INFINITY))) & (lanes_abs(ring_radius) < K(INFINITY))) & (lanes_abs(wire_radius) < K(INFINITY))) & (lanes_abs(board_distance) < K(INFINITY));
    const M s1 = (((s0 & (lanes_abs(board_half_width) < K(INFINITY))) & (lanes_abs(board_bottom) < K(INFINITY))) & (lanes_abs(board_top) < K(INFINITY))) & (lanes_abs(bridge_half_width) < K(INFINITY));
    return (LANES(hoop_finite_parameters_out)){ ((s1 & (lanes_abs(restitution) < K(INFINITY))) & (lanes_abs(gravity) < K(INFINITY))) & (lanes_abs(end_depth) < K(INFINITY)) };
}

/* 1 where no surface is overlapped; 1 where that is in doubt.
   Table 2. 111 operations: 18 additions, 17 subtractions, 11 multiplications, 1 square root, 3 negations, 18 absolute values, 20 comparisons, 23 selections. */
typedef struct {
    V valid;
    V doubt;
} LANES(hoop_valid_out);

LANES_INLINE LANES(hoop_valid_out)
LANES(hoop_valid)(V last, V x, V y, V z, V ball_radius, V ring_radius, V wire_radius, V board_distance, V board_half_width, V board_bottom, V board_top, V bridge_half_width, V end_depth)
{
    const V s0 = lanes_sqrt(((x * x) + (y * y)));
    const V s1 = s0 - ring_radius;
    const V s2 = ball_radius + wire_radius;
    const V s3 = ((z * z) + (s1 * s1)) - (s2 * s2);
    const M s4 = lanes_abs(last) < K(0.5);
    const V s5 = lanes_select(s4, K(1.0), lanes_select((K(0.0) <= s3), K(1.0), K(0.0)));
    const V s6 = ball_radius - board_distance;
    const V s7 = x - s6;
    const V s8 = K(2.0) * ball_radius;
    const V s9 = (s6 - s8) - x;
    const V s10 = lanes_select((s7 < s9), s9, s7);
    const V s11 = -(board_half_width + y);
    const V s12 = lanes_select((s10 < s11), s11, s10);
    const V s13 = y - board_half_width;
    const V s14 = lanes_select((s12 < s13), s13, s12);
    const V s15 = board_bottom - z;
    const V s16 = lanes_select((s14 < s15), s15, s14);
    const V s17 = z - board_top;
    const V s18 = lanes_select((s16 < s17), s17, s16);
    const M s19 = lanes_abs((last - K(1.0))) < K(0.5);
    const V s20 = lanes_select(s19, s5, lanes_select((K(0.0) <= s18), s5, K(0.0)));
    const V s21 = z - s2;
    const V s22 = ((s2 - s8) - (K(2.0) * wire_radius)) - z;
    const V s23 = lanes_select((s21 < s22), s22, s21);
    const V s24 = -(bridge_half_width + y);
    const V s25 = lanes_select((s23 < s24), s24, s23);
    const V s26 = y - bridge_half_width;
    const V s27 = lanes_select((s25 < s26), s26, s25);
    const V s28 = ring_radius - s0;
    const V s29 = lanes_select((s27 < s28), s28, s27);
    const V s30 = lanes_select((s29 < x), x, s29);
    const V s31 = -(board_distance + x);
    const V s32 = lanes_select((s30 < s31), s31, s30);
    const M s33 = lanes_abs((last - K(2.0))) < K(0.5);
    const V s34 = ((((lanes_abs(ball_radius) + lanes_abs(board_bottom)) + lanes_abs(board_distance)) + lanes_abs(board_half_width)) + lanes_abs(board_top)) + lanes_abs(bridge_half_width);
    const V s35 = ((((s34 + lanes_abs(end_depth)) + lanes_abs(ring_radius)) + lanes_abs(wire_radius)) + lanes_abs(x)) + lanes_abs(y);
    const V s36 = K(1.7763568394002505e-15) * (s35 + lanes_abs(z));
    const V s37 = lanes_select(s4, K(0.0), lanes_select((lanes_abs(s3) <= (((K(4.0) * ball_radius) + (K(4.0) * wire_radius)) * s36)), K(1.0), K(0.0)));
    const V s38 = lanes_select(s19, s37, lanes_select((lanes_abs(s18) <= s36), K(1.0), s37));
    return (LANES(hoop_valid_out)){ lanes_select(s33, s20, lanes_select((K(0.0) <= s32), s20, K(0.0))), lanes_select(s33, s38, lanes_select((lanes_abs(s32) <= s36), K(1.0), s38)) };
}

/* Not positive where a crossing of the end plane is made.
   Table 2, success. 5 operations: 1 addition, 1 subtraction, 2 multiplications, 1 square root. */
typedef struct {
    V target;
} LANES(hoop_target_out);

LANES_INLINE LANES(hoop_target_out)
LANES(hoop_target)(V x, V y, V ring_radius)
{
    return (LANES(hoop_target_out)){ lanes_sqrt(((x * x) + (y * y))) - ring_radius };
}

/* 1 where the ball leaves a surface.
   Table 1. 2 operations: 1 comparison, 1 selection. */
typedef struct {
    V leaving;
} LANES(hoop_left_out);

LANES_INLINE LANES(hoop_left_out)
LANES(hoop_left)(V index, V last)
{
    return (LANES(hoop_left_out)){ lanes_select((last == index), K(1.0), K(0.0)) };
}

/* Whether a plane's only arrival is one, and the size of the bend there.
   Table 1. 12 operations: 1 absolute value, 6 comparisons, 4 conjunctions, 1 disjunction. */
typedef struct {
    M arrives;
    V ceiling;
} LANES(hoop_meeting_plane_out);

LANES_INLINE LANES(hoop_meeting_plane_out)
LANES(hoop_meeting_plane)(V bend, V rate, V time)
{
    const M s0 = (((rate < K(0.0)) | (((rate <= K(0.0)) & (bend < K(0.0))) & (time == K(0.0)))) & (K(0.0) <= time)) & (time < K(INFINITY));
    return (LANES(hoop_meeting_plane_out)){ s0, lanes_abs(bend) };
}

/* Whether an arrival may be the earliest, as far as their delays are bounded.
   Table 1. 5 operations: 1 addition, 1 subtraction, 1 comparison, 1 conjunction, 1 complement. */
typedef struct {
    M possible;
} LANES(hoop_timely_out);

LANES_INLINE LANES(hoop_timely_out)
LANES(hoop_timely)(M arrives, V delay, V late, V time, V when)
{
    return (LANES(hoop_timely_out)){ arrives & NOT(((delay + late) < (time - when))) };
}

/* A doubt where the gap's apex is zero within its error.
   Table 1. 7 operations: 1 absolute value, 3 comparisons, 2 conjunctions, 1 selection. */
typedef struct {
    V doubt;
} LANES(hoop_grazed_out);

LANES_INLINE LANES(hoop_grazed_out)
LANES(hoop_grazed)(V apex, V doubt, V height, V margin)
{
    return (LANES(hoop_grazed_out)){ lanes_select((((K(0.0) <= apex) & (lanes_abs(height) <= margin)) & (apex < doubt)), apex, doubt) };
}

/* A doubt about a decision at a time.
   Table 1. 3 operations: 1 comparison, 1 conjunction, 1 selection. */
typedef struct {
    V doubt;
} LANES(hoop_questioned_out);

LANES_INLINE LANES(hoop_questioned_out)
LANES(hoop_questioned)(V doubt, V time, M unsure)
{
    return (LANES(hoop_questioned_out)){ lanes_select((unsure & (time < doubt)), time, doubt) };
}

/* A doubt about an arrival whose crossing is not certain.
   Table 1. 6 operations: 2 comparisons, 2 conjunctions, 1 complement, 1 selection. */
typedef struct {
    V doubt;
} LANES(hoop_crossed_out);

LANES_INLINE LANES(hoop_crossed_out)
LANES(hoop_crossed)(M arrives, V clearance, V doubt, V time)
{
    return (LANES(hoop_crossed_out)){ lanes_select(((arrives & NOT((K(0.0) < clearance))) & (time < doubt)), time, doubt) };
}

/* A doubt about two arrivals within their delays; the delay of the earlier one.
   Table 1. 12 operations: 1 addition, 1 subtraction, 1 absolute value, 3 comparisons, 3 conjunctions, 3 selections. */
typedef struct {
    V doubt;
    V late;
} LANES(hoop_tied_out);

LANES_INLINE LANES(hoop_tied_out)
LANES(hoop_tied)(M arrives, V delay, V doubt, V late, V time, V when)
{
    const M s0 = time < when;
    const V s1 = lanes_select(s0, time, when);
    const V s2 = lanes_select(((arrives & (lanes_abs((time - when)) <= (delay + late))) & (s1 < doubt)), s1, doubt);
    return (LANES(hoop_tied_out)){ s2, lanes_select((arrives & s0), delay, late) };
}

/* The earlier of the earliest arrival so far and this one.
   Table 1. 4 operations: 1 comparison, 1 conjunction, 2 selections. */
typedef struct {
    V when;
    V which;
} LANES(hoop_sooner_out);

LANES_INLINE LANES(hoop_sooner_out)
LANES(hoop_sooner)(M arrives, V index, V time, V when, V which)
{
    const M s0 = arrives & (time < when);
    return (LANES(hoop_sooner_out)){ lanes_select(s0, time, when), lanes_select(s0, index, which) };
}

/* Where a surface is not certainly missed.
   Table 1. 2 operations: 1 comparison, 1 complement. */
typedef struct {
    M open;
} LANES(hoop_opens_out);

LANES_INLINE LANES(hoop_opens_out)
LANES(hoop_opens)(V clear)
{
    return (LANES(hoop_opens_out)){ NOT((K(0.0) < clear)) };
}

/* How a search begins: with the errors that it allows for, and nothing found.
   Table 1. No operations. */
typedef struct {
    V share;
    V arrival;
    M certain;
} LANES(hoop_beginning_out);

LANES_INLINE LANES(hoop_beginning_out)
LANES(hoop_beginning)(void)
{
    return (LANES(hoop_beginning_out)){ K(2.9802322387695312e-08), K(INFINITY), NOWHERE };
}

/* Nothing is certain where the errors exceed what the search allows for.
   Table 1. 6 operations: 3 comparisons, 2 disjunctions, 1 selection. */
typedef struct {
    V doubt;
} LANES(hoop_beyond_out);

LANES_INLINE LANES(hoop_beyond_out)
LANES(hoop_beyond)(V doubt, V excess, V late, V lost, V pad)
{
    return (LANES(hoop_beyond_out)){ lanes_select((((K(0.0) < excess) | (K(0.0) < lost)) | (pad < late)), K(0.0), doubt) };
}

/* 1 near the surface that the ball left, where F/t is known better than F; the margin.
   Table 1. 6 operations: 1 multiplication, 2 comparisons, 1 conjunction, 2 selections. */
typedef struct {
    V leaving;
    V margin;
} LANES(hoop_nearby_out);

LANES_INLINE LANES(hoop_nearby_out)
LANES(hoop_nearby)(V flat, V index, V last, V t, V tilt)
{
    const V s0 = t * tilt;
    const M s1 = (last == index) & (s0 < flat);
    return (LANES(hoop_nearby_out)){ lanes_select(s1, K(1.0), K(0.0)), lanes_select(s1, s0, flat) };
}

/* Whether the gap closes, surely, or is to be looked at with smaller errors allowed.
   Table 1. 17 operations: 1 subtraction, 6 comparisons, 6 conjunctions, 2 disjunctions, 2 complements. */
typedef struct {
    M hit;
    M sure;
    M vague;
} LANES(hoop_struck_out);

LANES_INLINE LANES(hoop_struck_out)
LANES(hoop_struck)(V bend, V clearance, V gap, V margin, V rate, V rate_margin, V share)
{
    const M s0 = (rate < K(0.0)) | ((rate <= rate_margin) & (bend < K(0.0)));
    const M s1 = K(0.0) < clearance;
    const M s2 = s0 & (((gap - margin) <= margin) | s1);
    const M s3 = s0 & s1;
    const M s4 = (s2 & NOT(s3)) & (K(0.0) < share);
    return (LANES(hoop_struck_out)){ s2 & NOT(s4), s3, s4 };
}

/* The next smaller errors that a search allows for.
   Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection. */
typedef struct {
    V share;
} LANES(hoop_finer_out);

LANES_INLINE LANES(hoop_finer_out)
LANES(hoop_finer)(V share)
{
    return (LANES(hoop_finer_out)){ lanes_select((K(2.842170943040401e-14) < share), (K(0.03125) * share), K(0.0)) };
}

/* A doubt where the errors exceed what is allowed for.
   Table 1. 4 operations: 2 comparisons, 1 conjunction, 1 selection. */
typedef struct {
    V doubt;
} LANES(hoop_exceeded_out);

LANES_INLINE LANES(hoop_exceeded_out)
LANES(hoop_exceeded)(V doubt, V excess, V t)
{
    return (LANES(hoop_exceeded_out)){ lanes_select(((K(0.0) < excess) & (t < doubt)), t, doubt) };
}

/* The search after a step: what it found, whether its window is exhausted, where it is.
   Table 1. 14 operations: 1 subtraction, 1 comparison, 4 conjunctions, 2 disjunctions, 3 complements, 3 selections. */
typedef struct {
    V arrival;
    M certain;
    M exhausted;
    M searching;
    V t;
} LANES(hoop_advanced_out);

LANES_INLINE LANES(hoop_advanced_out)
LANES(hoop_advanced)(V arrival, M certain, V end, M hit, V next, V root, V step, M sure, V t, M vague)
{
    const M s0 = NOT(hit);
    const M s1 = (s0 & NOT(vague)) & ((end - t) <= step);
    return (LANES(hoop_advanced_out)){ lanes_select(hit, lanes_select(sure, root, t), arrival), certain | (hit & sure), s1, s0 & NOT(s1), lanes_select((hit | vague), t, next) };
}

/* Whether a search found an arrival.
   Table 1. 1 operation: 1 comparison. */
typedef struct {
    M arrives;
} LANES(hoop_found_out);

LANES_INLINE LANES(hoop_found_out)
LANES(hoop_found)(V arrival)
{
    return (LANES(hoop_found_out)){ arrival < K(INFINITY) };
}

/* A root that is certain, refined.
   Table 1. 1 operation: 1 selection. */
typedef struct {
    V arrival;
} LANES(hoop_polished_out);

LANES_INLINE LANES(hoop_polished_out)
LANES(hoop_polished)(V arrival, M certain, V refined)
{
    return (LANES(hoop_polished_out)){ lanes_select(certain, refined, arrival) };
}

/* The margin of the form that an arrival was found with.
   Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection. */
typedef struct {
    V margin;
} LANES(hoop_own_margin_out);

LANES_INLINE LANES(hoop_own_margin_out)
LANES(hoop_own_margin)(V arrival, V flat, V leaving, V tilt)
{
    return (LANES(hoop_own_margin_out)){ lanes_select((K(0.0) < leaving), (arrival * tilt), flat) };
}

/* The time of an arrival, not before the flight.
   Table 1. 2 operations: 1 comparison, 1 selection. */
typedef struct {
    V time;
} LANES(hoop_landed_out);

LANES_INLINE LANES(hoop_landed_out)
LANES(hoop_landed)(V arrival)
{
    return (LANES(hoop_landed_out)){ lanes_select((arrival < K(0.0)), K(0.0), arrival) };
}

/* The delay of an arrival that is certain, a doubt about another one.
   Table 1. 8 operations: 2 comparisons, 3 conjunctions, 1 complement, 2 selections. */
typedef struct {
    V delay;
    V doubt;
} LANES(hoop_landed_surely_out);

LANES_INLINE LANES(hoop_landed_surely_out)
LANES(hoop_landed_surely)(M arrives, M certain, V clearance, V delay, V doubt, V time)
{
    const M s0 = certain & (K(0.0) < clearance);
    return (LANES(hoop_landed_surely_out)){ lanes_select(s0, delay, K(0.0)), lanes_select(((arrives & NOT(s0)) & (time < doubt)), time, doubt) };
}

/* A search that begins outside the surface.
   Table 1. No operations. */
typedef struct {
    V side;
} LANES(hoop_outside_out);

LANES_INLINE LANES(hoop_outside_out)
LANES(hoop_outside)(void)
{
    return (LANES(hoop_outside_out)){ K(1.0) };
}

/* Whether a shot can start, and whether that is in doubt.
   Table 1. 7 operations: 2 comparisons, 3 conjunctions, 2 selections. */
typedef struct {
    V outcome;
    V uncertain;
} LANES(hoop_admitted_out);

LANES_INLINE LANES(hoop_admitted_out)
LANES(hoop_admitted)(V doubt, M finite, M permitted, V valid)
{
    const M s0 = permitted & finite;
    return (LANES(hoop_admitted_out)){ lanes_select((s0 & (K(0.0) < valid)), K(-1.0), K(4.0)), lanes_select((s0 & (K(0.0) < doubt)), K(1.0), K(0.0)) };
}

/* Where every number of a state is finite.
   Table 1. 26 operations: 9 absolute values, 9 comparisons, 8 conjunctions. */
typedef struct {
    M finite;
} LANES(hoop_finite_state_out);

LANES_INLINE LANES(hoop_finite_state_out)
LANES(hoop_finite_state)(V vx, V vy, V vz, V wx, V wy, V wz, V x, V y, V z)
{
    const M s0 = ((((lanes_abs(x) < K(INFINITY)) & (lanes_abs(y) < K(INFINITY))) & (lanes_abs(z) < K(INFINITY))) & (lanes_abs(vx) < K(INFINITY))) & (lanes_abs(vy) < K(INFINITY));
    const M s1 = (((s0 & (lanes_abs(vz) < K(INFINITY))) & (lanes_abs(wx) < K(INFINITY))) & (lanes_abs(wy) < K(INFINITY))) & (lanes_abs(wz) < K(INFINITY));
    return (LANES(hoop_finite_state_out)){ s1 };
}

/* No arrival yet; nothing is certain where the errors are not bounded.
   Table 1. 6 operations: 3 comparisons, 2 conjunctions, 1 selection. */
typedef struct {
    V when;
    V which;
    V late;
    V doubt;
} LANES(hoop_opening_out);

LANES_INLINE LANES(hoop_opening_out)
LANES(hoop_opening)(V excess, V position_error, V velocity_error)
{
    return (LANES(hoop_opening_out)){ K(INFINITY), K(-1.0), K(0.0), lanes_select((((position_error < K(INFINITY)) & (velocity_error < K(INFINITY))) & (excess <= K(0.0))), K(INFINITY), K(0.0)) };
}

/* Whether there is no event, the end, or a contact.
   Table 1. 5 operations: 2 comparisons, 1 conjunction, 2 complements. */
typedef struct {
    M stays;
    M moves;
    M ends;
    M touches;
} LANES(hoop_departed_out);

LANES_INLINE LANES(hoop_departed_out)
LANES(hoop_departed)(V index, V which)
{
    const M s0 = which < K(0.0);
    const M s1 = NOT(s0);
    const M s2 = which == index;
    return (LANES(hoop_departed_out)){ s0, s1, s2, s1 & NOT(s2) };
}

/* The time of the event.
   Table 1. 1 operation: 1 addition. */
typedef struct {
    V clock;
} LANES(hoop_ticked_out);

LANES_INLINE LANES(hoop_ticked_out)
LANES(hoop_ticked)(V clock, V when)
{
    return (LANES(hoop_ticked_out)){ clock + when };
}

/* 1 where a decision up to this event, or on the target, lies within its error.
   Table 1. 10 operations: 1 addition, 1 absolute value, 3 comparisons, 2 conjunctions, 1 disjunction, 1 complement, 1 selection. */
typedef struct {
    V uncertain;
} LANES(hoop_doubted_out);

LANES_INLINE LANES(hoop_doubted_out)
LANES(hoop_doubted)(V doubt, M ends, V late, V miss, V slack, V uncertain, V when)
{
    const V s0 = lanes_select(((NOT(((late + when) < doubt)) & (doubt < K(INFINITY))) | (ends & (lanes_abs(miss) <= slack))), K(1.0), uncertain);
    return (LANES(hoop_doubted_out)){ s0 };
}

/* How many contacts there were, and whether the shot ends and how.
   Table 1. 8 operations: 1 addition, 2 comparisons, 5 selections. */
typedef struct {
    V contacts;
    V outcome;
} LANES(hoop_accounted_out);

LANES_INLINE LANES(hoop_accounted_out)
LANES(hoop_accounted)(V contacts, M ends, V miss, V most_contacts, M touches)
{
    const V s0 = K(1.0) + contacts;
    return (LANES(hoop_accounted_out)){ lanes_select(touches, s0, contacts), lanes_select(touches, lanes_select((most_contacts <= s0), K(2.0), K(-1.0)), lanes_select(ends, lanes_select((miss <= K(0.0)), K(0.0), K(1.0)), K(3.0))) };
}

/* Where an event changes the ball, or its errors are asked for.
   Table 1. 3 operations: 1 comparison, 1 conjunction, 1 disjunction. */
typedef struct {
    M meeting;
} LANES(hoop_meeting_out);

LANES_INLINE LANES(hoop_meeting_out)
LANES(hoop_meeting)(V claims, M ends, M touches)
{
    return (LANES(hoop_meeting_out)){ touches | (ends & (K(0.0) < claims)) };
}

/* Whether the event is on a surface.
   Table 1. 1 operation: 1 comparison. */
typedef struct {
    M here;
} LANES(hoop_here_out);

LANES_INLINE LANES(hoop_here_out)
LANES(hoop_here)(V index, V which)
{
    return (LANES(hoop_here_out)){ which == index };
}

/* One more contact.
   Table 1. 1 operation: 1 addition. */
typedef struct {
    V count;
} LANES(hoop_counted_out);

LANES_INLINE LANES(hoop_counted_out)
LANES(hoop_counted)(V count)
{
    return (LANES(hoop_counted_out)){ K(1.0) + count };
}

/* A ball that meets another surface.
   Table 1. No operations. */
typedef struct {
    V curving;
} LANES(hoop_elsewhere_out);

LANES_INLINE LANES(hoop_elsewhere_out)
LANES(hoop_elsewhere)(void)
{
    return (LANES(hoop_elsewhere_out)){ K(INFINITY) };
}

/* Whether the ball meets the surface that it touched last.
   Table 1. 3 operations: 2 comparisons, 1 conjunction. */
typedef struct {
    M again;
} LANES(hoop_again_out);

LANES_INLINE LANES(hoop_again_out)
LANES(hoop_again)(V index, V last, V which)
{
    return (LANES(hoop_again_out)){ (which == index) & (last == which) };
}

/* The error of the event's time.
   Table 1. 1 operation: 1 addition. */
typedef struct {
    V clock_error;
} LANES(hoop_delayed_out);

LANES_INLINE LANES(hoop_delayed_out)
LANES(hoop_delayed)(V clock_error, V delay)
{
    return (LANES(hoop_delayed_out)){ clock_error + delay };
}

/* Errors of the position at the end, not below what one flight can make.
   Table 1. 9 operations: 3 absolute values, 3 comparisons, 3 selections. */
typedef struct {
    V dx;
    V dy;
    V dz;
} LANES(hoop_floored_out);

LANES_INLINE LANES(hoop_floored_out)
LANES(hoop_floored)(V dx, V dy, V dz, V shift)
{
    return (LANES(hoop_floored_out)){ lanes_select((lanes_abs(dx) < shift), shift, dx), lanes_select((lanes_abs(dy) < shift), shift, dy), lanes_select((lanes_abs(dz) < shift), shift, dz) };
}

/* A normal without error.
   Table 1. No operations. */
typedef struct {
    V dnx;
    V dny;
    V dnz;
    V turn;
} LANES(hoop_unturned_out);

LANES_INLINE LANES(hoop_unturned_out)
LANES(hoop_unturned)(void)
{
    return (LANES(hoop_unturned_out)){ K(0.0), K(0.0), K(0.0), K(0.0) };
}

/* The surfaces that were touched first and last.
   Table 1. 2 operations: 1 comparison, 1 selection. */
typedef struct {
    V first;
    V last;
} LANES(hoop_touched_out);

LANES_INLINE LANES(hoop_touched_out)
LANES(hoop_touched)(V body, V first, V which)
{
    return (LANES(hoop_touched_out)){ lanes_select((first < K(0.0)), body, first), which };
}

/* Where a shot has ended whose errors are asked for.
   Table 1. 3 operations: 2 comparisons, 1 conjunction. */
typedef struct {
    M closed;
} LANES(hoop_closing_out);

LANES_INLINE LANES(hoop_closing_out)
LANES(hoop_closing)(V claims, V outcome)
{
    return (LANES(hoop_closing_out)){ (K(0.0) < claims) & (K(0.0) <= outcome) };
}

/* The body that the event is on.
   Table 1. No operations. */
typedef struct {
    V body;
} LANES(hoop_body_of_out);

LANES_INLINE LANES(hoop_body_of_out)
LANES(hoop_body_of)(V which)
{
    return (LANES(hoop_body_of_out)){ which };
}

/* Velocity and spin after a contact, frame-free.
   Eqs. 11-17, the frame eliminated. 63 operations: 10 additions, 12 subtractions, 40 multiplications, 1 division. */
typedef struct {
    V vx;
    V vy;
    V vz;
    V wx;
    V wy;
    V wz;
} LANES(hoop_impact_out);

LANES_INLINE LANES(hoop_impact_out)
LANES(hoop_impact)(V vx, V vy, V vz, V wx, V wy, V wz, V nx, V ny, V nz, V ball_radius, V restitution)
{
    const V s0 = K(0.4) * ball_radius;
    const V s1 = ((nx * vx) + (ny * vy)) + (nz * vz);
    const V s2 = (s0 * ((nz * wy) - (ny * wz))) + (K(0.6) * (vx - (nx * s1)));
    const V s3 = (s0 * ((nx * wz) - (nz * wx))) + (K(0.6) * (vy - (ny * s1)));
    const V s4 = (s0 * ((ny * wx) - (nx * wy))) + (K(0.6) * (vz - (nz * s1)));
    const V s5 = ((nx * wx) + (ny * wy)) + (nz * wz);
    const V s6 = K(1.0) / ball_radius;
    return (LANES(hoop_impact_out)){ s2 - ((nx * restitution) * s1), s3 - ((ny * restitution) * s1), s4 - ((nz * restitution) * s1), (nx * s5) + (s6 * ((ny * s4) - (nz * s3))), (ny * s5) + (s6 * ((nz * s2) - (nx * s4))), (nz * s5) + (s6 * ((nx * s3) - (ny * s2))) };
}

/* Errors of velocity and spin after a contact, from those before it.
   derivative of the frame-free Eq. 17, with roundings. 243 operations: 46 additions, 30 subtractions, 97 multiplications, 4 divisions, 4 negations, 18 absolute values, 22 comparisons, 22 selections. */
typedef struct {
    V dvx;
    V dvy;
    V dvz;
    V dwx;
    V dwy;
    V dwz;
} LANES(hoop_carry_impact_out);

LANES_INLINE LANES(hoop_carry_impact_out)
LANES(hoop_carry_impact)(V vx, V vy, V vz, V wx, V wy, V wz, V nx, V ny, V nz, V contacts, V dvx, V dvy, V dvz, V dwx, V dwy, V dwz, V dnx, V dny, V dnz, V turn, V ball_radius, V restitution)
{
    const V s0 = K(0.4) * ball_radius;
    const V s1 = ((nx * vx) + (ny * vy)) + (nz * vz);
    const V s2 = (((((dnx * vx) + (dny * vy)) + (dnz * vz)) + (dvx * nx)) + (dvy * ny)) + (dvz * nz);
    const V s3 = (s0 * ((((dnz * wy) + (dwy * nz)) - (dny * wz)) - (dwz * ny))) + (K(0.6) * ((dvx - (dnx * s1)) - (nx * s2)));
    const V s4 = (s3 - ((dnx * restitution) * s1)) - ((nx * restitution) * s2);
    const V s5 = ((ball_radius * ((lanes_abs(wx) + lanes_abs(wy)) + lanes_abs(wz))) + lanes_abs(vx)) + lanes_abs(vy);
    const V s6 = s5 + lanes_abs(vz);
    const V s7 = K(2.220446049250313e-16) * s6;
    const V s8 = -s7;
    const V s9 = s4 + lanes_select((s4 < K(0.0)), s8, s7);
    const V s10 = K(8.0) + (K(8.0) * contacts);
    const V s11 = lanes_abs(dwx);
    const V s12 = lanes_abs(dwy);
    const V s13 = lanes_select((s11 < s12), s12, s11);
    const V s14 = lanes_abs(dwz);
    const V s15 = lanes_abs(dvx);
    const V s16 = lanes_abs(dvy);
    const V s17 = lanes_select((s15 < s16), s16, s15);
    const V s18 = lanes_abs(dvz);
    const V s19 = ((ball_radius * lanes_select((s13 < s14), s14, s13)) + (turn * s6)) + lanes_select((s17 < s18), s18, s17);
    const V s20 = s19 / s10;
    const V s21 = -s20;
    const V s22 = (s0 * ((((dnx * wz) + (dwz * nx)) - (dnz * wx)) - (dwx * nz))) + (K(0.6) * ((dvy - (dny * s1)) - (ny * s2)));
    const V s23 = (s22 - ((dny * restitution) * s1)) - ((ny * restitution) * s2);
    const V s24 = s23 + lanes_select((s23 < K(0.0)), s8, s7);
    const V s25 = (s0 * ((((dny * wx) + (dwx * ny)) - (dnx * wy)) - (dwy * nx))) + (K(0.6) * ((dvz - (dnz * s1)) - (nz * s2)));
    const V s26 = (s25 - ((dnz * restitution) * s1)) - ((nz * restitution) * s2);
    const V s27 = s26 + lanes_select((s26 < K(0.0)), s8, s7);
    const V s28 = ((nx * wx) + (ny * wy)) + (nz * wz);
    const V s29 = (((((dnx * wx) + (dny * wy)) + (dnz * wz)) + (dwx * nx)) + (dwy * ny)) + (dwz * nz);
    const V s30 = K(1.0) / ball_radius;
    const V s31 = (s0 * ((ny * wx) - (nx * wy))) + (K(0.6) * (vz - (nz * s1)));
    const V s32 = (s0 * ((nx * wz) - (nz * wx))) + (K(0.6) * (vy - (ny * s1)));
    const V s33 = ((dnx * s28) + (nx * s29)) + (s30 * ((((dny * s31) + (ny * s25)) - (dnz * s32)) - (nz * s22)));
    const V s34 = s7 / ball_radius;
    const V s35 = -s34;
    const V s36 = s33 + lanes_select((s33 < K(0.0)), s35, s34);
    const V s37 = s19 / (ball_radius * s10);
    const V s38 = -s37;
    const V s39 = (s0 * ((nz * wy) - (ny * wz))) + (K(0.6) * (vx - (nx * s1)));
    const V s40 = ((dny * s28) + (ny * s29)) + (s30 * ((((dnz * s39) + (nz * s3)) - (dnx * s31)) - (nx * s25)));
    const V s41 = s40 + lanes_select((s40 < K(0.0)), s35, s34);
    const V s42 = ((dnz * s28) + (nz * s29)) + (s30 * ((((dnx * s32) + (nx * s22)) - (dny * s39)) - (ny * s3)));
    const V s43 = s42 + lanes_select((s42 < K(0.0)), s35, s34);
    return (LANES(hoop_carry_impact_out)){ lanes_select((lanes_abs(s9) < s20), lanes_select((s9 < K(0.0)), s21, s20), s9), lanes_select((lanes_abs(s24) < s20), lanes_select((s24 < K(0.0)), s21, s20), s24), lanes_select((lanes_abs(s27) < s20), lanes_select((s27 < K(0.0)), s21, s20), s27), lanes_select((lanes_abs(s36) < s37), lanes_select((s36 < K(0.0)), s38, s37), s36), lanes_select((lanes_abs(s41) < s37), lanes_select((s41 < K(0.0)), s38, s37), s41), lanes_select((lanes_abs(s43) < s37), lanes_select((s43 < K(0.0)), s38, s37), s43) };
}

/* Outward unit normal n3 at a contact.
   Table 2. 13 operations: 2 additions, 1 subtraction, 7 multiplications, 2 divisions, 1 square root. */
typedef struct {
    V nx;
    V ny;
    V nz;
} LANES(hoop_ring_normal_out);

LANES_INLINE LANES(hoop_ring_normal_out)
LANES(hoop_ring_normal)(V x, V y, V z, V ball_radius, V ring_radius, V wire_radius)
{
    const V s0 = K(1.0) / (ball_radius + wire_radius);
    const V s1 = lanes_sqrt(((x * x) + (y * y)));
    const V s2 = (s0 * (s1 - ring_radius)) * (K(1.0) / s1);
    return (LANES(hoop_ring_normal_out)){ x * s2, y * s2, z * s0 };
}

/* Bound on the rate at which the normal turns along the contact surface.
   Table 2. 6 operations: 1 addition, 2 subtractions, 1 division, 1 comparison, 1 selection. */
typedef struct {
    V curvature;
} LANES(hoop_ring_curvature_out);

LANES_INLINE LANES(hoop_ring_curvature_out)
LANES(hoop_ring_curvature)(V ball_radius, V ring_radius, V wire_radius)
{
    const V s0 = (ring_radius - ball_radius) - wire_radius;
    const V s1 = ball_radius + wire_radius;
    return (LANES(hoop_ring_curvature_out)){ K(1.0) / lanes_select((s0 < s1), s0, s1) };
}

/* Error of the normal, from that of the position.
   derivative of Table 2's normal. 38 operations: 6 additions, 3 subtractions, 21 multiplications, 4 divisions, 1 square root, 1 negation, 1 comparison, 1 selection. */
typedef struct {
    V dnx;
    V dny;
    V dnz;
    V turn;
} LANES(hoop_ring_carry_normal_out);

LANES_INLINE LANES(hoop_ring_carry_normal_out)
LANES(hoop_ring_carry_normal)(V x, V y, V dx, V dy, V dz, V shift, V ball_radius, V ring_radius, V wire_radius)
{
    const V s0 = ball_radius + wire_radius;
    const V s1 = K(1.0) / s0;
    const V s2 = lanes_sqrt(((x * x) + (y * y)));
    const V s3 = s2 - ring_radius;
    const V s4 = K(1.0) / s2;
    const V s5 = (s1 * s3) * s4;
    const V s6 = (K(0.5) * (((K(2.0) * dx) * x) + ((K(2.0) * dy) * y))) / s2;
    const V s7 = ((s6 * s1) * s4) + (((-(s6 * (s4 * s4))) * s1) * s3);
    const V s8 = (ring_radius - ball_radius) - wire_radius;
    return (LANES(hoop_ring_carry_normal_out)){ (dx * s5) + (x * s7), (dy * s5) + (y * s7), dz * s1, shift * (K(1.0) / lanes_select((s8 < s0), s8, s0)) };
}

/* Positive if there certainly is no contact before the horizon.
   bounds of the event condition. 146 operations: 27 additions, 19 subtractions, 67 multiplications, 1 division, 2 square roots, 15 comparisons, 15 selections. */
typedef struct {
    V clear;
} LANES(hoop_ring_clear_out);

LANES_INLINE LANES(hoop_ring_clear_out)
LANES(hoop_ring_clear)(V horizon, V x, V y, V z, V vx, V vy, V vz, V extent, V speed, V position_error, V velocity_error, V ball_radius, V ring_radius, V wire_radius, V gravity)
{
    const V s0 = ball_radius + wire_radius;
    const V s1 = (K(0.000244140625) * ring_radius) - (ring_radius - s0);
    const V s2 = position_error + (horizon * velocity_error);
    const V s3 = (s2 - (K(1.52587890625e-05) * ball_radius)) - (K(1.52587890625e-05) * wire_radius);
    const V s4 = K(1.00006103515625) * s0;
    const V s5 = ring_radius + s4;
    const V s6 = vz * vz;
    const V s7 = s6 + ((K(2.0) * gravity) * (z - s4));
    const V s8 = K(1.0) / gravity;
    const V s9 = lanes_sqrt(s7);
    const V s10 = s8 * (vz - s9);
    const V s11 = s8 * (vz + s9);
    const V s12 = x + (vx * s11);
    const V s13 = y + (vy * s11);
    const V s14 = (s12 * s12) + (s13 * s13);
    const V s15 = lanes_sqrt(s14);
    const V s16 = s15 - ring_radius;
    const V s17 = z + ((vz - ((K(0.5) * gravity) * s11)) * s11);
    const V s18 = s5 * s5;
    const V s19 = K(9.313225746154785e-10) * s18;
    const V s20 = (((s16 * s16) + (s17 * s17)) - (s0 * s0)) - s19;
    const V s21 = (vx * vx) + (vy * vy);
    const V s22 = ring_radius - s4;
    const V s23 = K(0.0001220703125) * ring_radius;
    const V s24 = lanes_select((s22 < s23), s23, s22);
    const V s25 = s24 * s24;
    const V s26 = s24 * s25;
    const V s27 = ((((K(2.0) * s6) + ((K(4.0) * gravity) * z)) + (K(2.0) * s21)) - ((K(6.0003662109375) * gravity) * s0)) * s26;
    const V s28 = (vy * x) - (vx * y);
    const V s29 = s28 * s28;
    const V s30 = s27 - ((K(2.0) * ring_radius) * s29);
    const V s31 = (s16 * ((vx * s12) + (vy * s13))) + ((s17 * (vz - (gravity * s11))) * s15);
    const V s32 = x + (horizon * vx);
    const V s33 = y + (horizon * vy);
    const V s34 = lanes_select(((((s19 + (s32 * s32)) + (s33 * s33)) - s25) < K(0.0)), K(1.0), lanes_select((((s21 * (s19 + s25)) - s29) < K(0.0)), K(1.0), K(0.0)));
    const V s35 = lanes_select(((((K(4.0) * (s31 * s31)) * s26) - (((K(2.0) * s30) * s14) * s20)) < K(0.0)), s34, K(0.0));
    const V s36 = lanes_select((horizon < (s11 - (K(9.313225746154785e-10) * horizon))), K(1.0), lanes_select((K(0.0) < s20), lanes_select((K(0.0) < s30), s35, K(0.0)), K(0.0)));
    const V s37 = (vx * x) + (vy * y);
    const V s38 = (s10 * s21) + s37;
    const V s39 = lanes_select((s38 < K(0.0)), lanes_select((s18 < ((s10 * (s37 + s38)) + ((x * x) + (y * y)))), s36, K(0.0)), K(0.0));
    const V s40 = lanes_select(((extent + (horizon * (speed + (gravity * horizon)))) < (K(65536.0) * s5)), lanes_select((K(0.0) < s7), lanes_select((s10 < K(0.0)), s36, s39), K(0.0)), K(0.0));
    return (LANES(hoop_ring_clear_out)){ lanes_select((K(0.0) < lanes_select((s1 < s3), s3, s1)), K(0.0), lanes_select((s2 < (K(5.820766091346741e-11) * s5)), s40, K(0.0))) };
}

/* Constants and windows of the search along a flight, and the errors it allows for.
   bounds of the event condition. 177 operations: 28 additions, 20 subtractions, 48 multiplications, 3 divisions, 5 square roots, 1 negation, 5 absolute values, 30 comparisons, 37 selections. */
typedef struct {
    V steady;
    V swing;
    V rho_start;
    V low0;
    V high0;
    V low1;
    V high1;
    V low2;
    V high2;
    V ceiling;
    V latest;
    V lost;
} LANES(hoop_ring_prepare_out);

LANES_INLINE LANES(hoop_ring_prepare_out)
LANES(hoop_ring_prepare)(V horizon, V x, V y, V z, V vx, V vy, V vz, V position_error, V velocity_error, V ball_radius, V ring_radius, V wire_radius, V gravity)
{
    const V s0 = vz * vz;
    const V s1 = (vx * vx) + (vy * vy);
    const V s2 = ((K(2.0) * s0) + ((K(4.0) * gravity) * z)) + (K(2.0) * s1);
    const V s3 = (vy * x) - (vx * y);
    const V s4 = s3 * s3;
    const V s5 = (K(2.0) * ring_radius) * s4;
    const V s6 = (x * x) + (y * y);
    const V s7 = ball_radius + wire_radius;
    const V s8 = K(1.00006103515625) * s7;
    const V s9 = K(2.0) * gravity;
    const V s10 = K(8.881784197001252e-16) * (s0 + (s9 * (lanes_abs(z) + s8)));
    const V s11 = (s0 + (s9 * (z + s8))) + s10;
    const V s12 = K(1.0) / gravity;
    const V s13 = lanes_sqrt(s11);
    const V s14 = K(1.7763568394002505e-15) * (lanes_abs(vz) + s13);
    const M s15 = K(0.0) <= s11;
    const V s16 = lanes_select(s15, (s12 * ((vz - s13) - s14)), K(INFINITY));
    const V s17 = ring_radius + s8;
    const V s18 = s17 * s17;
    const V s19 = (K(1.7763568394002505e-15) * s1) * (s18 + s6);
    const V s20 = ((s18 * s1) + s19) - s4;
    const V s21 = (vx * x) + (vy * y);
    const V s22 = lanes_sqrt(s20);
    const V s23 = K(1.7763568394002505e-15) * ((lanes_abs(s21) + lanes_abs(s3)) + s22);
    const V s24 = K(1.0) / s1;
    const M s25 = K(0.0) <= s20;
    const M s26 = K(2.409919865102884e-181) < s1;
    const V s27 = lanes_select(s26, lanes_select(s25, ((-((s21 + s22) + s23)) * s24), K(INFINITY)), (-K(INFINITY)));
    const V s28 = lanes_select((s16 < s27), s27, s16);
    const V s29 = ring_radius - s8;
    const V s30 = K(0.0001220703125) * ring_radius;
    const V s31 = lanes_select((s29 < s30), s30, s29);
    const V s32 = ((s1 * (s31 * s31)) - s19) - s4;
    const V s33 = lanes_sqrt(lanes_select((s32 < K(0.0)), K(0.0), s32));
    const V s34 = lanes_select(s26, lanes_select(s25, (((s22 + s23) - s21) * s24), (-K(INFINITY))), K(INFINITY));
    const M s35 = K(0.0) < lanes_select(s26, s32, K(0.0));
    const V s36 = lanes_select(s35, (((s23 - s21) - s33) * s24), s34);
    const V s37 = (s0 + (s9 * (z - s8))) - s10;
    const V s38 = lanes_sqrt(lanes_select((s37 < K(0.0)), K(0.0), s37));
    const V s39 = lanes_select(s15, (s12 * ((vz + s13) + s14)), (-K(INFINITY)));
    const M s40 = K(0.0) < s37;
    const V s41 = lanes_select(s40, (s12 * ((vz + s14) - s38)), s39);
    const V s42 = lanes_select((s36 < s41), s36, s41);
    const V s43 = lanes_select(s35, (((s33 - s21) - s23) * s24), K(INFINITY));
    const V s44 = lanes_select((s43 < s36), s36, s43);
    const V s45 = lanes_select((s16 < s44), s44, s16);
    const V s46 = lanes_select((s34 < s41), s34, s41);
    const V s47 = lanes_select(s40, (s12 * ((vz + s38) - s14)), K(INFINITY));
    const V s48 = lanes_select((s47 < s41), s41, s47);
    const M s49 = s45 <= s46;
    const V s50 = lanes_select(s49, s45, lanes_select((s48 < s27), s27, s48));
    const V s51 = lanes_select(s49, s46, lanes_select((s36 < s39), s36, s39));
    const V s52 = lanes_select((s48 < s44), s44, s48);
    const V s53 = lanes_select((s34 < s39), s34, s39);
    const V s54 = K(1.0) / s31;
    const V s55 = lanes_select((K(0.0) < s42), s42, K(0.0));
    const V s56 = lanes_select((s55 < s51), s51, s55);
    const V s57 = lanes_select((s56 < s53), s53, s56);
    const V s58 = (K(0.000244140625) * ring_radius) - (ring_radius - s7);
    const V s59 = ((position_error + (horizon * velocity_error)) - (K(1.52587890625e-05) * ball_radius)) - (K(1.52587890625e-05) * wire_radius);
    return (LANES(hoop_ring_prepare_out)){ s2, s5, lanes_sqrt(s6), lanes_select((K(0.0) < s28), s28, K(0.0)), lanes_select((s42 < horizon), s42, horizon), lanes_select((K(0.0) < s50), s50, K(0.0)), lanes_select((s51 < horizon), s51, horizon), lanes_select((K(0.0) < s52), s52, K(0.0)), lanes_select((s53 < horizon), s53, horizon), (((K(6.0003662109375) * gravity) * s7) + (s5 * (s54 * (s54 * s54)))) + lanes_abs(s2), lanes_select((s57 < horizon), s57, horizon), lanes_select((s58 < s59), s59, s58) };
}

/* Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.
   running error analysis. 47 operations: 14 additions, 1 subtraction, 27 multiplications, 1 division, 2 comparisons, 2 selections. */
typedef struct {
    V margin;
    V leaving_margin;
    V rate_margin;
} LANES(hoop_ring_margins_out);

LANES_INLINE LANES(hoop_ring_margins_out)
LANES(hoop_ring_margins)(V horizon, V extent, V speed, V position_error, V velocity_error, V ball_radius, V ring_radius, V wire_radius, V gravity)
{
    const V s0 = ball_radius + wire_radius;
    const V s1 = speed + (gravity * horizon);
    const V s2 = K(1.00006103515625) * s0;
    const V s3 = s2 * s1;
    const V s4 = ring_radius + s2;
    const V s5 = extent + (horizon * s1);
    const V s6 = (position_error + (horizon * velocity_error)) + (K(4.440892098500626e-16) * s5);
    const V s7 = ring_radius - s2;
    const V s8 = K(0.0001220703125) * ring_radius;
    const V s9 = s2 / lanes_select((s7 < s8), s8, s7);
    const V s10 = lanes_select((K(1.0) < s9), s9, K(1.0));
    const V s11 = K(5.0) * (((s1 * s10) * s6) + (s2 * (velocity_error + (K(2.220446049250313e-16) * s1))));
    const V s12 = K(1.0009765625) * ((((K(3.552713678800501e-15) * s1) * ((s5 * s10) + s4)) + (K(4.440892098500626e-16) * s3)) + s11);
    return (LANES(hoop_ring_margins_out)){ K(1.0009765625) * ((((K(4.440892098500626e-16) * horizon) * s3) + ((K(1.3323489447131243e-15) * s0) * s4)) + ((K(5.00030517578125) * s0) * s6)), s12, K(1.0009765625) * ((K(3.552713678800501e-15) * (s4 * s1)) + s11) };
}

/* Newton's next value of a root near t, and the rate there.
   Newton's method. 56 operations: 15 additions, 6 subtractions, 30 multiplications, 2 divisions, 1 square root, 1 comparison, 1 selection. */
typedef struct {
    V time;
    V rate;
} LANES(hoop_ring_refine_out);

LANES_INLINE LANES(hoop_ring_refine_out)
LANES(hoop_ring_refine)(V t, V leaving, V x, V y, V z, V vx, V vy, V vz, V rho_start, V ball_radius, V ring_radius, V wire_radius, V gravity)
{
    const V s0 = x + (t * vx);
    const V s1 = y + (t * vy);
    const V s2 = lanes_sqrt(((s0 * s0) + (s1 * s1)));
    const V s3 = rho_start + s2;
    const V s4 = K(1.0) / (s3 * s2);
    const V s5 = s2 - ring_radius;
    const V s6 = vz - ((K(0.5) * gravity) * t);
    const V s7 = z + (t * s6);
    const V s8 = K(2.0) * ((((s3 * s4) * ((vx * s0) + (vy * s1))) * s5) + ((vz - (gravity * t)) * s7));
    const V s9 = (((t * ((vx * vx) + (vy * vy))) + (K(2.0) * ((vx * x) + (vy * y)))) * ((rho_start - ring_radius) + s5)) * (s2 * s4);
    const V s10 = ball_radius + wire_radius;
    const V s11 = lanes_select((K(0.0) < leaving), (t * (s9 + ((z + s7) * s6))), (((s5 * s5) + (s7 * s7)) - (s10 * s10))) / s8;
    return (LANES(hoop_ring_refine_out)){ t - s11, s8 };
}

/* Gap, rate, bend, a step without a root and its end, Newton's root and its clearance.
   Newton from the left under a curvature bound. 146 operations: 28 additions, 17 subtractions, 55 multiplications, 5 divisions, 2 square roots, 2 negations, 2 absolute values, 16 comparisons, 19 selections. */
typedef struct {
    V gap;
    V rate;
    V bend;
    V step;
    V next;
    V root;
    V clearance;
} LANES(hoop_ring_advance_out);

LANES_INLINE LANES(hoop_ring_advance_out)
LANES(hoop_ring_advance)(V t, V end, V leaving, V margin, V rate_margin, V ceiling, V x, V y, V z, V vx, V vy, V vz, V steady, V swing, V rho_start, V ball_radius, V ring_radius, V wire_radius, V gravity)
{
    const V s0 = x + (t * vx);
    const V s1 = y + (t * vy);
    const V s2 = lanes_sqrt(((s0 * s0) + (s1 * s1)));
    const V s3 = s2 - ring_radius;
    const V s4 = rho_start + s2;
    const V s5 = K(1.0) / (s4 * s2);
    const V s6 = (((t * ((vx * vx) + (vy * vy))) + (K(2.0) * ((vx * x) + (vy * y)))) * ((rho_start - ring_radius) + s3)) * (s2 * s5);
    const V s7 = vz - ((K(0.5) * gravity) * t);
    const V s8 = z + (t * s7);
    const V s9 = ball_radius + wire_radius;
    const V s10 = lanes_select((K(0.0) < leaving), (t * (s6 + ((z + s8) * s7))), (((s3 * s3) + (s8 * s8)) - (s9 * s9)));
    const V s11 = s4 * s5;
    const V s12 = s11 * ((vx * s0) + (vy * s1));
    const V s13 = vz - (gravity * t);
    const V s14 = (s12 * s3) + (s13 * s8);
    const V s15 = K(2.0) * s14;
    const V s16 = K(6.0) * gravity;
    const V s17 = s16 * s8;
    const V s18 = swing * (s11 * (s11 * s11));
    const V s19 = K(1.00006103515625) * s9;
    const V s20 = s15 - rate_margin;
    const V s21 = s10 - margin;
    const V s22 = lanes_select((s21 < K(0.0)), K(0.0), s21);
    const V s23 = (s17 + s18) - steady;
    const M s24 = s20 < K(0.0);
    const V s25 = K(2.0) * s22;
    const V s26 = lanes_select((K(0.0) < lanes_select((K(0.0) <= s20), s22, K(0.0))), K(INFINITY), (lanes_select(s24, s25, (K(4.0) * s20)) / lanes_select(s24, (-s20), lanes_select((K(0.0) < s23), s23, K(0.0)))));
    const V s27 = end - t;
    const V s28 = lanes_select((s26 < s27), s26, s27);
    const V s29 = (s28 * lanes_select((s13 < K(0.0)), K(0.0), s13)) + s8;
    const V s30 = s16 * lanes_select((s19 < s29), s19, s29);
    const V s31 = ((s28 * lanes_select((K(0.0) < s12), K(0.0), s12)) + s2) - (K(9.094947017729282e-13) * (ring_radius + s19));
    const V s32 = ring_radius - s19;
    const V s33 = K(0.0001220703125) * ring_radius;
    const V s34 = lanes_select((s32 < s33), s33, s32);
    const V s35 = K(1.0) / lanes_select((s31 < s34), s34, s31);
    const V s36 = swing * (s35 * (s35 * s35));
    const V s37 = ((s30 + s36) + (K(9.094947017729282e-13) * ((s36 + lanes_abs(steady)) + lanes_abs(s30)))) - steady;
    const V s38 = ((K(2.0) * s37) * s22) + (s20 * s20);
    const V s39 = lanes_sqrt(s38);
    const V s40 = lanes_select((K(0.0) <= s38), (lanes_select(s24, s25, (s20 + s39)) / lanes_select(s24, (s39 - s20), lanes_select((K(0.0) < s37), s37, K(0.0)))), K(INFINITY));
    const V s41 = lanes_select((s40 < s28), s40, s28);
    const V s42 = -(rate_margin + s15);
    return (LANES(hoop_ring_advance_out)){ s10, s15, (steady - s17) - s18, s41, t + s41, t - ((K(0.5) * s10) / s14), lanes_select((K(0.0) < s42), ((s42 * s42) - ((K(8.0) * ceiling) * (margin + (K(32.0) * s22)))), s42) };
}

/* The first window that begins no earlier than a time, if there is one.
   Table 1. 18 operations: 6 comparisons, 3 conjunctions, 3 disjunctions, 6 selections. */
typedef struct {
    V t;
    V end;
    M searching;
} LANES(hoop_ring_enter_out);

LANES_INLINE LANES(hoop_ring_enter_out)
LANES(hoop_ring_enter)(V after, V end, V high0, V high1, V high2, V low0, V low1, V low2, V t)
{
    const M s0 = (low0 < high0) & (after <= low0);
    const M s1 = (low1 < high1) & (after <= low1);
    const M s2 = (low2 < high2) & (after <= low2);
    return (LANES(hoop_ring_enter_out)){ lanes_select(s0, low0, lanes_select(s1, low1, lanes_select(s2, low2, t))), lanes_select(s0, high0, lanes_select(s1, high1, lanes_select(s2, high2, end))), ((NOWHERE | s2) | s1) | s0 };
}

/* Outward unit normal n3 at a contact.
   Table 2. No operations. */
typedef struct {
    V nx;
    V ny;
    V nz;
} LANES(hoop_backboard_normal_out);

LANES_INLINE LANES(hoop_backboard_normal_out)
LANES(hoop_backboard_normal)(void)
{
    return (LANES(hoop_backboard_normal_out)){ K(1.0), K(0.0), K(0.0) };
}

/* Bound on the rate at which the normal turns along the contact surface.
   Table 2. No operations. */
typedef struct {
    V curvature;
} LANES(hoop_backboard_curvature_out);

LANES_INLINE LANES(hoop_backboard_curvature_out)
LANES(hoop_backboard_curvature)(void)
{
    return (LANES(hoop_backboard_curvature_out)){ K(0.0) };
}

/* The g of Eq. 2: a contact counts where none is positive.
   Eq. 2, Table 2. 5 operations: 1 addition, 3 subtractions, 1 negation. */
typedef struct {
    V g0;
    V g1;
    V g2;
    V g3;
} LANES(hoop_backboard_bounds_out);

LANES_INLINE LANES(hoop_backboard_bounds_out)
LANES(hoop_backboard_bounds)(V y, V z, V board_half_width, V board_bottom, V board_top)
{
    return (LANES(hoop_backboard_bounds_out)){ -(board_half_width + y), y - board_half_width, board_bottom - z, z - board_top };
}

/* Time of the only arrival, the gap's rate there and its bend.
   Eq. 3 in Table 2, solved. 9 operations: 2 subtractions, 1 division, 1 negation, 1 absolute value, 2 comparisons, 2 selections. */
typedef struct {
    V time;
    V rate;
    V bend;
    V apex;
    V height;
} LANES(hoop_backboard_arrival_out);

LANES_INLINE LANES(hoop_backboard_arrival_out)
LANES(hoop_backboard_arrival)(V leaving, V x, V vx, V ball_radius, V board_distance)
{
    const V s0 = lanes_select((K(0.0) < leaving), K(0.0), (x - (ball_radius - board_distance)));
    return (LANES(hoop_backboard_arrival_out)){ -(s0 / vx), vx, K(0.0), lanes_select((lanes_abs(vx) <= K(0.0)), K(0.0), K(-1.0)), s0 };
}

/* Rounding-error bound of the gap up to the horizon.
   running error analysis. 15 operations: 7 additions, 8 multiplications. */
typedef struct {
    V margin;
} LANES(hoop_backboard_margin_out);

LANES_INLINE LANES(hoop_backboard_margin_out)
LANES(hoop_backboard_margin)(V horizon, V extent, V speed, V position_error, V velocity_error, V ball_radius, V board_distance, V gravity)
{
    const V s0 = extent + (horizon * (speed + (gravity * horizon)));
    return (LANES(hoop_backboard_margin_out)){ (((K(6.667843360785852e-16) * ball_radius) + (K(8.890457814381136e-16) * board_distance)) + (K(2.222614453595284e-16) * s0)) + (K(2.001953125) * ((position_error + (horizon * velocity_error)) + (K(4.440892098500626e-16) * s0))) };
}

/* The point of the contact plane nearest to a position.
   Table 2. 1 operation: 1 subtraction. */
typedef struct {
    V x;
    V y;
    V z;
} LANES(hoop_backboard_place_out);

LANES_INLINE LANES(hoop_backboard_place_out)
LANES(hoop_backboard_place)(V y, V z, V ball_radius, V board_distance)
{
    return (LANES(hoop_backboard_place_out)){ ball_radius - board_distance, y, z };
}

/* Where a contact counts (Eq. 2).
   Table 1. 7 operations: 4 comparisons, 3 conjunctions. */
typedef struct {
    M arrives;
} LANES(hoop_backboard_within_out);

LANES_INLINE LANES(hoop_backboard_within_out)
LANES(hoop_backboard_within)(V g0, V g1, V g2, V g3)
{
    return (LANES(hoop_backboard_within_out)){ (((g0 <= K(0.0)) & (g1 <= K(0.0))) & (g2 <= K(0.0))) & (g3 <= K(0.0)) };
}

/* Where that, or the crossing, lies within its error.
   Table 1. 19 operations: 1 negation, 9 comparisons, 8 conjunctions, 1 complement. */
typedef struct {
    M unsure;
} LANES(hoop_backboard_edges_out);

LANES_INLINE LANES(hoop_backboard_edges_out)
LANES(hoop_backboard_edges)(V clearance, V g0, V g1, V g2, V g3, V slack)
{
    const V s0 = -slack;
    const M s1 = NOT((((((g0 < s0) & (g1 < s0)) & (g2 < s0)) & (g3 < s0)) & (K(0.0) < clearance)));
    return (LANES(hoop_backboard_edges_out)){ ((((g0 <= slack) & (g1 <= slack)) & (g2 <= slack)) & (g3 <= slack)) & s1 };
}

/* Outward unit normal n3 at a contact.
   Table 2. No operations. */
typedef struct {
    V nx;
    V ny;
    V nz;
} LANES(hoop_bridge_normal_out);

LANES_INLINE LANES(hoop_bridge_normal_out)
LANES(hoop_bridge_normal)(void)
{
    return (LANES(hoop_bridge_normal_out)){ K(0.0), K(0.0), K(1.0) };
}

/* Bound on the rate at which the normal turns along the contact surface.
   Table 2. No operations. */
typedef struct {
    V curvature;
} LANES(hoop_bridge_curvature_out);

LANES_INLINE LANES(hoop_bridge_curvature_out)
LANES(hoop_bridge_curvature)(void)
{
    return (LANES(hoop_bridge_curvature_out)){ K(0.0) };
}

/* The g of Eq. 2: a contact counts where none is positive.
   Eq. 2, Table 2. 10 operations: 3 additions, 2 subtractions, 2 multiplications, 1 square root, 2 negations. */
typedef struct {
    V g0;
    V g1;
    V g2;
    V g3;
    V g4;
} LANES(hoop_bridge_bounds_out);

LANES_INLINE LANES(hoop_bridge_bounds_out)
LANES(hoop_bridge_bounds)(V x, V y, V ring_radius, V board_distance, V bridge_half_width)
{
    return (LANES(hoop_bridge_bounds_out)){ -(bridge_half_width + y), y - bridge_half_width, ring_radius - lanes_sqrt(((x * x) + (y * y))), x, -(board_distance + x) };
}

/* Time of the only arrival, the gap's rate there and its bend.
   Eq. 3 in Table 2, solved. 25 operations: 3 additions, 2 subtractions, 7 multiplications, 2 divisions, 1 square root, 5 negations, 2 comparisons, 3 selections. */
typedef struct {
    V time;
    V rate;
    V bend;
    V apex;
    V height;
} LANES(hoop_bridge_arrival_out);

LANES_INLINE LANES(hoop_bridge_arrival_out)
LANES(hoop_bridge_arrival)(V leaving, V z, V vz, V ball_radius, V wire_radius, V gravity)
{
    const V s0 = lanes_select((K(0.0) < leaving), K(0.0), (z - (ball_radius + wire_radius)));
    const V s1 = (vz * vz) + ((K(2.0) * gravity) * s0);
    const V s2 = lanes_sqrt(s1);
    const M s3 = vz < K(0.0);
    const V s4 = -(K(1.0) / gravity);
    return (LANES(hoop_bridge_arrival_out)){ lanes_select(s3, (K(2.0) * s0), (vz + s2)) / lanes_select(s3, (s2 - vz), gravity), -s2, -gravity, -(vz * s4), -((K(0.5) * s4) * s1) };
}

/* Rounding-error bound of the gap up to the horizon.
   running error analysis. 15 operations: 7 additions, 8 multiplications. */
typedef struct {
    V margin;
} LANES(hoop_bridge_margin_out);

LANES_INLINE LANES(hoop_bridge_margin_out)
LANES(hoop_bridge_margin)(V horizon, V extent, V speed, V position_error, V velocity_error, V ball_radius, V wire_radius, V gravity)
{
    const V s0 = extent + (horizon * (speed + (gravity * horizon)));
    return (LANES(hoop_bridge_margin_out)){ (((K(6.667843360785852e-16) * ball_radius) + (K(6.667843360785852e-16) * wire_radius)) + (K(2.222614453595284e-16) * s0)) + (K(2.001953125) * ((position_error + (horizon * velocity_error)) + (K(4.440892098500626e-16) * s0))) };
}

/* The point of the contact plane nearest to a position.
   Table 2. 1 operation: 1 addition. */
typedef struct {
    V x;
    V y;
    V z;
} LANES(hoop_bridge_place_out);

LANES_INLINE LANES(hoop_bridge_place_out)
LANES(hoop_bridge_place)(V x, V y, V ball_radius, V wire_radius)
{
    return (LANES(hoop_bridge_place_out)){ x, y, ball_radius + wire_radius };
}

/* Where a contact counts (Eq. 2).
   Table 1. 9 operations: 5 comparisons, 4 conjunctions. */
typedef struct {
    M arrives;
} LANES(hoop_bridge_within_out);

LANES_INLINE LANES(hoop_bridge_within_out)
LANES(hoop_bridge_within)(V g0, V g1, V g2, V g3, V g4)
{
    return (LANES(hoop_bridge_within_out)){ ((((g0 <= K(0.0)) & (g1 <= K(0.0))) & (g2 <= K(0.0))) & (g3 <= K(0.0))) & (g4 <= K(0.0)) };
}

/* Where that, or the crossing, lies within its error.
   Table 1. 23 operations: 1 negation, 11 comparisons, 10 conjunctions, 1 complement. */
typedef struct {
    M unsure;
} LANES(hoop_bridge_edges_out);

LANES_INLINE LANES(hoop_bridge_edges_out)
LANES(hoop_bridge_edges)(V clearance, V g0, V g1, V g2, V g3, V g4, V slack)
{
    const V s0 = -slack;
    const M s1 = (((((g0 < s0) & (g1 < s0)) & (g2 < s0)) & (g3 < s0)) & (g4 < s0)) & (K(0.0) < clearance);
    const M s2 = (((((g0 <= slack) & (g1 <= slack)) & (g2 <= slack)) & (g3 <= slack)) & (g4 <= slack)) & NOT(s1);
    return (LANES(hoop_bridge_edges_out)){ s2 };
}

/* Outward unit normal n3 at a contact.
   Table 2. No operations. */
typedef struct {
    V nx;
    V ny;
    V nz;
} LANES(hoop_end_normal_out);

LANES_INLINE LANES(hoop_end_normal_out)
LANES(hoop_end_normal)(void)
{
    return (LANES(hoop_end_normal_out)){ K(0.0), K(0.0), K(1.0) };
}

/* Time of the only arrival, the gap's rate there and its bend.
   Eq. 3 in Table 2, solved. 25 operations: 2 additions, 2 subtractions, 7 multiplications, 2 divisions, 1 square root, 6 negations, 2 comparisons, 3 selections. */
typedef struct {
    V time;
    V rate;
    V bend;
    V apex;
    V height;
} LANES(hoop_end_arrival_out);

LANES_INLINE LANES(hoop_end_arrival_out)
LANES(hoop_end_arrival)(V leaving, V z, V vz, V gravity, V end_depth)
{
    const V s0 = lanes_select((K(0.0) < leaving), K(0.0), (z - (-end_depth)));
    const V s1 = (vz * vz) + ((K(2.0) * gravity) * s0);
    const V s2 = lanes_sqrt(s1);
    const M s3 = vz < K(0.0);
    const V s4 = -(K(1.0) / gravity);
    return (LANES(hoop_end_arrival_out)){ lanes_select(s3, (K(2.0) * s0), (vz + s2)) / lanes_select(s3, (s2 - vz), gravity), -s2, -gravity, -(vz * s4), -((K(0.5) * s4) * s1) };
}

/* Rounding-error bound of the gap up to the horizon.
   running error analysis. 13 operations: 6 additions, 7 multiplications. */
typedef struct {
    V margin;
} LANES(hoop_end_margin_out);

LANES_INLINE LANES(hoop_end_margin_out)
LANES(hoop_end_margin)(V horizon, V extent, V speed, V position_error, V velocity_error, V gravity, V end_depth)
{
    const V s0 = extent + (horizon * (speed + (gravity * horizon)));
    return (LANES(hoop_end_margin_out)){ ((K(6.667843360785852e-16) * end_depth) + (K(2.222614453595284e-16) * s0)) + (K(2.001953125) * ((position_error + (horizon * velocity_error)) + (K(4.440892098500626e-16) * s0))) };
}

