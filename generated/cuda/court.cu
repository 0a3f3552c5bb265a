/* The event loop of the scene court in CUDA: a thread takes one shot from its release to its end.

   Generated from templates/cuda/scene.cu.j2, scene court, derivation 6850e5812fbcfc63,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   It needs no header. To give the bits of NumPy and C it is compiled with --fmad=false, --ftz=false,
   --prec-div=true and --prec-sqrt=true: then + - * / and square roots are rounded as IEEE 754 says, in
   double and in single precision. NVRTC calls what it compiles __CUDACC__. */

#if defined(__USE_FAST_MATH__) && __USE_FAST_MATH__
#error "fast-math changes results: compile without it"
#endif
/* VARIANT is 0 for the path alone, 1 for bounds on errors, too; both are compiled without it. */
#ifndef VARIANT
#define VARIANT 2
#endif

#define INFINITE __longlong_as_double(0x7ff0000000000000LL)
#define NOT_A_NUMBER __longlong_as_double(0x7ff8000000000000LL)

/* The same value, of which the compiler knows nothing. Of `a < 0.0 ? a : 0.0` it would make min.f64,
   which takes -0.0 for less than 0.0. It does not where it cannot know the value that is taken otherwise. */
static __device__ __forceinline__ double opaque(double value)
{
#ifdef __CUDACC__
    asm("" : "+d"(value));
#endif
    return value;
}

static __device__ __forceinline__ float opaque(float value)
{
#ifdef __CUDACC__
    asm("" : "+f"(value));
#endif
    return value;
}

static __device__ __forceinline__ bool opaque(bool value) { return value; }

/* The choices of all targets. Both values are there before one is taken: a branch would part threads. */
template <typename T> static __device__ __forceinline__ T choose(bool truth, T then, T other)
{
    other = opaque(other);
    return truth ? then : other;
}

template <typename T> static __device__ __forceinline__ T larger(T a, T b) { return choose(a < b, b, a); }

template <typename T> static __device__ __forceinline__ T smaller(T a, T b) { return choose(a < b, a, b); }

/* The parameters of a shot: each has one value for all shots, at a stride of 0, or one a shot. */
struct shot_parameters {
    const double *const *values;
    const long long *strides;
    long long shot;
};

static __device__ __forceinline__ double parameter(const shot_parameters &given, int number)
{
    return given.values[number][given.strides[number] * given.shot];
}

enum {
    COURT_OUTCOME_MADE = 0, /* Fell through the ring, and crossed the end plane inside the target. */
    COURT_OUTCOME_MISSED = 1, /* Crossed the end plane otherwise. */
    COURT_OUTCOME_CAPPED = 2, /* Had max_contacts contacts before it ended. */
    COURT_OUTCOME_SHORT = 3, /* Can never reach an end. */
    COURT_OUTCOME_INVALID = 4, /* Not finite, not allowed, a size out of range, or a start inside a surface. */
    COURT_OUTCOME_LODGED = 5, /* At rest, or wedged between bodies. */
    COURT_OUTCOME_ENDLESS = 6 /* Still moving at the time limit. */
};

/* What a row of the event log is. */
enum {
    COURT_EVENT_IMPACT = 0, /* The ball meets a body. */
    COURT_EVENT_ROLL = 1, /* Its bounces have accumulated: it stays in contact with the body. */
    COURT_EVENT_LEAVE = 2, /* That contact ends. */
    COURT_EVENT_END = 3 /* The shot ends. */
};

/* A row of the event log. */
struct court_event {
    long long shot, surface;
    double time, before[9], after[9];
    long long kind;
};

/* Bounds on the errors of such a row. */
struct court_event_errors {
    double time_error;
    double state_error[3];
};

static __device__ const int table_0[][1] = {
    {16},
    {17},
};

static __device__ const double table_1[][1] = {
    {1.0},
    {2.0},
};

static __device__ const int table_2[][2] = {
    {15, 12},
    {16, 13},
    {17, 14},
};

static __device__ const double table_3[][1] = {
    {0.0},
    {1.0},
    {2.0},
};

/* Position and velocity at time t of a flight.
   Eq. 3. 11 operations: 3 additions, 2 subtractions, 6 multiplications. */
struct kernel_flight_out {
    double x, y, z, vx, vy, vz;
};

static __device__ __forceinline__ kernel_flight_out kernel_flight(double t, double x, double y, double z, double vx, double vy, double vz, double p_gravity)
{
    return {x + (vx * t), y + (vy * t), z + (t * (vz - ((0.5 * p_gravity) * t))), vx, vy, vz - (p_gravity * t)};
}

/* Clearance, positive if a crossing is certain, and a bound on its delay.
   Taylor's theorem with the margins of the gap and its rate. 10 operations: 1 addition, 1 subtraction, 3 multiplications, 1 division, 1 negation, 1 comparison, 2 selections. */
struct kernel_crossing_out {
    double clearance, delay;
};

static __device__ __forceinline__ kernel_crossing_out kernel_crossing(double margin, double rate_margin, double rate, double ceiling)
{
    const double _s0 = -(rate + rate_margin);
    const double _s1 = 6.0 * margin;
    const bool _s2 = 0.0 < _s0;
    return {choose(_s2, ((_s0 * _s0) - (_s1 * ceiling)), _s0), choose(_s2, (_s1 / _s0), (INFINITE))};
}

/* Errors of the state that a search allows for, and by how much the errors exceed them.
   a share of the size of the flight. 10 operations: 2 additions, 2 subtractions, 4 multiplications, 1 comparison, 1 selection. */
struct kernel_allowance_out {
    double position_level, velocity_level, excess;
};

static __device__ __forceinline__ kernel_allowance_out kernel_allowance(double share, double horizon, double extent, double speed, double position_error, double velocity_error, double p_gravity)
{
    const double _s0 = speed + (p_gravity * horizon);
    const double _s1 = share * (extent + (horizon * _s0));
    const double _s2 = share * _s0;
    const double _s3 = position_error - _s1;
    const double _s4 = velocity_error - _s2;
    return {_s1, _s2, larger(_s3, _s4)};
}

/* Time after which no event is wanted, and how long that is after t.
   the earliest arrival, with room for its delay. 5 operations: 2 additions, 2 multiplications, 1 division. */
struct kernel_horizon_out {
    double horizon, pad;
};

static __device__ __forceinline__ kernel_horizon_out kernel_horizon(double t, double speed, double p_gravity)
{
    const double _s0 = 9.5367431640625e-07 * (t + (speed * (1.0 / p_gravity)));
    return {t + _s0, _s0};
}

/* Sums of the sizes of position and velocity, and the excess of the flight's size.
   the measure of rounding errors. 18 operations: 4 additions, 1 subtraction, 2 multiplications, 1 division, 6 absolute values, 2 comparisons, 2 selections. */
struct kernel_scale_out {
    double extent, speed, excess;
};

static __device__ __forceinline__ kernel_scale_out kernel_scale(double x, double y, double z, double vx, double vy, double vz, double p_gravity)
{
    const double _s0 = (fabs(x) + fabs(y)) + fabs(z);
    const double _s1 = (fabs(vx) + fabs(vy)) + fabs(vz);
    const double _s2 = larger(_s0, _s1);
    const double _s3 = (1.0 / p_gravity) * (_s1 * _s1);
    return {_s0, _s1, larger(_s2, _s3) - 1.152921504606847e+18};
}

/* Bound on the error of a length at a computed arrival.
   running error analysis. 27 operations: 17 additions, 8 multiplications, 2 absolute values. */
struct kernel_displacement_out {
    double margin;
};

static __device__ __forceinline__ kernel_displacement_out kernel_displacement(double delay, double horizon, double extent, double speed, double position_error, double velocity_error, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_board_distance, double p_board_half_width, double p_board_bottom, double p_board_top, double p_board_thickness, double p_bridge_half_width, double p_bridge_depth, double p_gravity, double p_end_depth)
{
    const double _s0 = speed + (p_gravity * horizon);
    const double _s1 = extent + (horizon * _s0);
    const double _s2 = (((((p_ball_radius + p_ring_radius) + p_wire_radius) + p_board_distance) + p_board_half_width) + p_board_thickness) + p_bridge_half_width;
    const double _s3 = 4.445228907190568e-16 * (_s1 + ((((_s2 + p_bridge_depth) + p_end_depth) + fabs(p_board_bottom)) + fabs(p_board_top)));
    return {(((1.0009765625 * delay) * _s0) + _s3) + (3.0029296875 * ((position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * _s1)))};
}

/* Velocity along the normal before the impact.
   Table 2. 5 operations: 2 additions, 3 multiplications. */
struct kernel_normal_velocity_out {
    double normal_velocity;
};

static __device__ __forceinline__ kernel_normal_velocity_out kernel_normal_velocity(double vx, double vy, double vz, double nx, double ny, double nz)
{
    return {((nx * vx) + (ny * vy)) + (nz * vz)};
}

/* Bounds on the errors where a flight crosses the end plane.
   Eq. 3, with roundings. 63 operations: 25 additions, 1 subtraction, 23 multiplications, 1 division, 8 absolute values, 1 comparison, 4 selections. */
struct kernel_bound_end_out {
    float position_bound, velocity_bound, spin_bound, delay;
};

static __device__ __forceinline__ kernel_bound_end_out kernel_bound_end(float t, float x, float y, float z, float vx, float vy, float vz, float clock, float position_bound, float velocity_bound, float spin_bound, float root_offset, float normal_velocity, float p_gravity)
{
    const float _s0 = fabsf(vx);
    const float _s1 = ((float)2.0) * t;
    const float _s2 = fabsf(vy);
    const float _s3 = ((float)0.5) * p_gravity;
    const float _s4 = ((_s3 * (t * t)) + (_s1 * fabsf((vz + (_s3 * t))))) + fabsf(z);
    const float _s5 = ((((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * ((_s1 * _s0) + fabsf(x)))) + (((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * ((_s1 * _s2) + fabsf(y))))) + (((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * _s4));
    const float _s6 = ((position_bound + root_offset) + (t * velocity_bound)) + _s5;
    const float _s7 = fabsf(normal_velocity);
    const float _s8 = (((float)1.1) * _s6) / _s7;
    const float _s9 = fabsf(vz);
    const float _s10 = ((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * ((((p_gravity * t) + _s0) + _s2) + _s9));
    const float _s11 = (p_gravity * _s8) + (velocity_bound + _s10);
    const float _s12 = ((float)1.0009765625) * ((_s8 * (_s11 + ((_s0 + _s2) + _s9))) + _s6);
    const bool _s13 = ((((float)12.0) * _s11) - _s7) <= ((float)0.0);
    return {choose(_s13, _s12, ((float)INFINITE)), choose(_s13, (((float)1.0009765625) * _s11), ((float)INFINITE)), choose(_s13, (((float)1.0009765625) * spin_bound), ((float)INFINITE)), (((float)4.440892098500626e-16) * (t + clock)) + choose(_s13, (((float)1.0009765625) * _s8), ((float)INFINITE))};
}

/* Bounds on the errors at the time limit.
   Eq. 3, with roundings. 51 operations: 24 additions, 20 multiplications, 7 absolute values. */
struct kernel_bound_time_out {
    float position_bound, velocity_bound, spin_bound, clock_bound;
};

static __device__ __forceinline__ kernel_bound_time_out kernel_bound_time(float t, float x, float y, float z, float vx, float vy, float vz, float clock, float position_bound, float velocity_bound, float spin_bound, float clock_bound, float p_gravity)
{
    const float _s0 = clock_bound + (((float)4.440892098500626e-16) * (t + clock));
    const float _s1 = fabsf(vx);
    const float _s2 = fabsf(vy);
    const float _s3 = fabsf(vz);
    const float _s4 = ((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * ((((p_gravity * t) + _s1) + _s2) + _s3));
    const float _s5 = (velocity_bound + (p_gravity * _s0)) + _s4;
    const float _s6 = ((float)2.0) * t;
    const float _s7 = ((float)0.5) * p_gravity;
    const float _s8 = ((_s7 * (t * t)) + (_s6 * fabsf((vz + (_s7 * t))))) + fabsf(z);
    const float _s9 = ((((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * ((_s6 * _s1) + fabsf(x)))) + (((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * ((_s6 * _s2) + fabsf(y))))) + (((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * _s8));
    const float _s10 = ((position_bound + (t * velocity_bound)) + (_s0 * (_s5 + ((_s1 + _s2) + _s3)))) + _s9;
    return {((float)1.0009765625) * _s10, ((float)1.0009765625) * _s5, ((float)1.0009765625) * spin_bound, (float)0.0};
}

/* Whether the bounds of a shot are estimated from a contact on.
   comparison. 19 operations: 2 additions, 6 multiplications, 5 comparisons, 2 conjunctions, 2 disjunctions, 1 complement, 1 selection. */
struct kernel_estimated_after_contact_out {
    double estimated;
};

static __device__ __forceinline__ kernel_estimated_after_contact_out kernel_estimated_after_contact(double vx, double vy, double vz, double nx, double ny, double nz, double position_bound, double velocity_bound, double spin_bound, double estimated, double p_ball_radius, double p_gravity)
{
    const double _s0 = ((nx * vx) + (ny * vy)) + (nz * vz);
    const bool _s1 = ((0.0 < estimated) || (!(((position_bound <= 1.1641532182693481e-10) && (velocity_bound < (INFINITE))) && (spin_bound < (INFINITE))))) || ((_s0 * _s0) < (1.52587890625e-05 * (p_ball_radius * p_gravity)));
    return {choose(_s1, 1.0, 0.0)};
}

/* Whether a contact, and an end, of a shot is met that is not estimated.
   Table 1. 3 operations: 1 comparison, 2 conjunctions. */
struct kernel_proves_out {
    bool proves_contact, proves_end;
};

static __device__ __forceinline__ kernel_proves_out kernel_proves(bool ends, bool touches, double estimated)
{
    const bool _s0 = estimated <= 0.0;
    return {touches && _s0, ends && _s0};
}

/* A ball that may begin to roll is estimated from then on.
   Table 1. No operations. */
struct kernel_estimates_out {
    double estimated;
};

static __device__ __forceinline__ kernel_estimates_out kernel_estimates()
{
    return {1.0};
}

/* Sum of the proved bounds on the delays of contacts.
   Table 1. 1 operation: 1 addition. */
struct kernel_clock_bound_sum_out {
    float clock_bound;
};

static __device__ __forceinline__ kernel_clock_bound_sum_out kernel_clock_bound_sum(float delay, float clock_bound)
{
    return {delay + clock_bound};
}

/* Errors of the state at the end of a flight to a surface, from those at its start.
   derivative of Eq. 3 and of the contact time, with roundings. 165 operations: 36 additions, 2 subtractions, 43 multiplications, 2 divisions, 10 negations, 17 absolute values, 23 comparisons, 32 selections. */
struct kernel_carry_flight_out {
    double dx, dy, dz, lifting, dvx, dvy, dvz, delay, shift;
};

static __device__ __forceinline__ kernel_carry_flight_out kernel_carry_flight(double t, double x, double y, double z, double vx, double vy, double vz, double nx, double ny, double nz, double clock, double contacts, double earliest_delay, double dx, double dy, double dz, double dvx, double dvy, double dvz, double left_nx, double left_ny, double left_nz, double curving, double p_gravity)
{
    const double _s0 = fabs(vx);
    const double _s1 = fabs(vy);
    const double _s2 = larger(_s0, _s1);
    const double _s3 = fabs(vz);
    const double _s4 = larger(_s2, _s3);
    const double _s5 = curving * (t * _s4);
    const double _s6 = smaller(_s5, 1.0);
    const double _s7 = dx + (dvx * t);
    const double _s8 = fabs(x);
    const double _s9 = fabs(y);
    const double _s10 = fabs(z);
    const double _s11 = 1.0 + (curving * ((_s8 + _s9) + _s10));
    const double _s12 = 2.0 * t;
    const double _s13 = _s12 * _s0;
    const double _s14 = 7.888609052210118e-31 + (1.1102230246251565e-16 * (_s13 + _s8));
    const bool _s15 = curving < (INFINITE);
    const double _s16 = choose(_s15, (4.440892098500626e-16 * (_s13 * _s11)), _s14);
    const bool _s17 = _s7 < 0.0;
    const double _s18 = dy + (dvy * t);
    const double _s19 = _s12 * _s1;
    const double _s20 = 7.888609052210118e-31 + (1.1102230246251565e-16 * (_s19 + _s9));
    const double _s21 = choose(_s15, (4.440892098500626e-16 * (_s19 * _s11)), _s20);
    const bool _s22 = _s18 < 0.0;
    const double _s23 = dz + (dvz * t);
    const double _s24 = (p_gravity * (t * t)) + (_s12 * _s3);
    const double _s25 = 7.888609052210118e-31 + (1.1102230246251565e-16 * (_s24 + _s10));
    const double _s26 = choose(_s15, (4.440892098500626e-16 * (_s24 * _s11)), _s25);
    const bool _s27 = _s23 < 0.0;
    const double _s28 = ((nx * (_s7 + choose(_s17, (-_s16), _s16))) + (ny * (_s18 + choose(_s22, (-_s21), _s21)))) + (nz * (_s23 + choose(_s27, (-_s26), _s26)));
    const double _s29 = 1.0 / (((nx * vx) + (ny * vy)) + (nz * vz));
    const double _s30 = -((_s28 - (((dx * left_nx) + (dy * left_ny)) + (dz * left_nz))) * _s29);
    const double _s31 = (vx * _s30) + (_s7 + choose(_s17, (-_s14), _s14));
    const double _s32 = fabs(_s31);
    const double _s33 = fabs(dx);
    const double _s34 = fabs(dy);
    const double _s35 = larger(_s33, _s34);
    const double _s36 = fabs(dz);
    const double _s37 = larger(_s35, _s36);
    const double _s38 = fabs(dvx);
    const double _s39 = fabs(dvy);
    const double _s40 = larger(_s38, _s39);
    const double _s41 = fabs(dvz);
    const double _s42 = t * larger(_s40, _s41);
    const double _s43 = larger(_s16, _s21);
    const double _s44 = larger(_s14, _s20);
    const double _s45 = (_s42 + larger(_s44, _s25)) + _s37;
    const double _s46 = ((fabs(_s29) * _s4) * ((_s37 * _s6) + (_s42 + larger(_s43, _s26)))) + _s45;
    const double _s47 = 1.0 / (8.0 + (8.0 * contacts));
    const double _s48 = _s46 * _s47;
    const double _s49 = larger(_s32, _s48);
    const bool _s50 = _s6 < 0.25;
    const double _s51 = (vy * _s30) + (_s18 + choose(_s22, (-_s20), _s20));
    const double _s52 = fabs(_s51);
    const double _s53 = larger(_s52, _s48);
    const double _s54 = (vz * _s30) + (_s23 + choose(_s27, (-_s25), _s25));
    const double _s55 = fabs(_s54);
    const double _s56 = larger(_s55, _s48);
    const double _s57 = fabs(_s30);
    const double _s58 = 0.0625 * earliest_delay;
    return {choose(_s50, _s31, choose((_s31 < 0.0), (-_s49), _s49)), choose(_s50, _s51, choose((_s51 < 0.0), (-_s53), _s53)), choose(_s50, _s54, choose((_s54 < 0.0), (-_s56), _s56)), choose(_s50, 0.125, _s47), dvx, dvy, dvz - (p_gravity * _s30), (4.440892098500626e-16 * (t + clock)) + larger(_s57, _s58), choose(_s50, _s45, _s46)};
}

/* Errors of the state at the time limit, from those at the start of the flight.
   derivative of Eq. 3, with roundings. 65 operations: 20 additions, 18 multiplications, 1 negation, 14 absolute values, 6 comparisons, 6 selections. */
struct kernel_carry_time_out {
    double dx, dy, dz, dvx, dvy, dvz, clock_error;
};

static __device__ __forceinline__ kernel_carry_time_out kernel_carry_time(double t, double x, double y, double z, double vx, double vy, double vz, double clock, double clock_error, double dx, double dy, double dz, double dvx, double dvy, double dvz, double p_gravity)
{
    const double _s0 = fabs(vx);
    const double _s1 = clock_error + (4.440892098500626e-16 * (t + clock));
    const double _s2 = fabs(dvx);
    const double _s3 = fabs(dvy);
    const double _s4 = larger(_s2, _s3);
    const double _s5 = fabs(dvz);
    const double _s6 = 2.0 * t;
    const double _s7 = 7.888609052210118e-31 + (1.1102230246251565e-16 * ((_s6 * _s0) + fabs(x)));
    const double _s8 = fabs(vy);
    const double _s9 = 7.888609052210118e-31 + (1.1102230246251565e-16 * ((_s6 * _s8) + fabs(y)));
    const double _s10 = larger(_s7, _s9);
    const double _s11 = fabs(vz);
    const double _s12 = 7.888609052210118e-31 + (1.1102230246251565e-16 * (((p_gravity * (t * t)) + (_s6 * _s11)) + fabs(z)));
    const double _s13 = fabs(dx);
    const double _s14 = fabs(dy);
    const double _s15 = larger(_s13, _s14);
    const double _s16 = fabs(dz);
    const double _s17 = ((t * larger(_s4, _s5)) + larger(_s10, _s12)) + larger(_s15, _s16);
    const double _s18 = fabs(0.0);
    return {(_s0 * _s1) + _s17, (_s8 * _s1) + _s17, (_s11 * _s1) + _s17, (_s18 + (2.220446049250313e-16 * _s0)) + _s2, (_s18 + (2.220446049250313e-16 * _s8)) + _s3, ((2.220446049250313e-16 * _s11) + _s5) + fabs((-(p_gravity * _s1))), 0.0};
}

/* Bounds on the errors of state and time that decisions allow for.
   the carried errors times a factor. 30 operations: 4 multiplications, 9 absolute values, 7 comparisons, 10 selections. */
struct kernel_error_bounds_out {
    double position_error, velocity_error, spin_error, time_error;
};

static __device__ __forceinline__ kernel_error_bounds_out kernel_error_bounds(double clock_error, double dx, double dy, double dz, double dvx, double dvy, double dvz, double dwx, double dwy, double dwz, double position_bound, double velocity_bound, double spin_bound, double estimated, double clock_bound)
{
    const double _s0 = fabs(dx);
    const double _s1 = fabs(dy);
    const double _s2 = larger(_s0, _s1);
    const double _s3 = fabs(dz);
    const bool _s4 = 0.0 < estimated;
    const double _s5 = fabs(dvx);
    const double _s6 = fabs(dvy);
    const double _s7 = larger(_s5, _s6);
    const double _s8 = fabs(dvz);
    const double _s9 = fabs(dwx);
    const double _s10 = fabs(dwy);
    const double _s11 = larger(_s9, _s10);
    const double _s12 = fabs(dwz);
    return {choose(_s4, (16.0 * larger(_s2, _s3)), position_bound), choose(_s4, (16.0 * larger(_s7, _s8)), velocity_bound), choose(_s4, (16.0 * larger(_s11, _s12)), spin_bound), choose(_s4, (16.0 * clock_error), clock_bound)};
}

/* Bounds on the errors of state and time that are reported.
   the carried errors times a larger factor. 30 operations: 4 multiplications, 9 absolute values, 7 comparisons, 10 selections. */
struct kernel_claimed_errors_out {
    double position_error, velocity_error, spin_error, time_error;
};

static __device__ __forceinline__ kernel_claimed_errors_out kernel_claimed_errors(double clock_error, double dx, double dy, double dz, double dvx, double dvy, double dvz, double dwx, double dwy, double dwz, double position_bound, double velocity_bound, double spin_bound, double estimated, double clock_bound)
{
    const double _s0 = fabs(dx);
    const double _s1 = fabs(dy);
    const double _s2 = larger(_s0, _s1);
    const double _s3 = fabs(dz);
    const bool _s4 = 0.0 < estimated;
    const double _s5 = fabs(dvx);
    const double _s6 = fabs(dvy);
    const double _s7 = larger(_s5, _s6);
    const double _s8 = fabs(dvz);
    const double _s9 = fabs(dwx);
    const double _s10 = fabs(dwy);
    const double _s11 = larger(_s9, _s10);
    const double _s12 = fabs(dwz);
    return {choose(_s4, (64.0 * larger(_s2, _s3)), position_bound), choose(_s4, (64.0 * larger(_s7, _s8)), velocity_bound), choose(_s4, (64.0 * larger(_s11, _s12)), spin_bound), choose(_s4, (64.0 * clock_error), clock_bound)};
}

/* 1 if finite parameters are allowed.
   the scene's requirements. 64 operations: 6 subtractions, 29 comparisons, 29 selections. */
struct kernel_allowed_out {
    double allowed;
};

static __device__ __forceinline__ kernel_allowed_out kernel_allowed(const shot_parameters &_given)
{
    const double _s0 = choose((0.0 < (parameter(_given, 6) - parameter(_given, 5))), choose((0.0 < ((parameter(_given, 3) - parameter(_given, 1)) - parameter(_given, 2))), choose((0.0 < ((parameter(_given, 1) - parameter(_given, 0)) - parameter(_given, 2))), 1.0, 0.0), 0.0), 0.0);
    double _v1 = choose((0.0 < (parameter(_given, 4) - parameter(_given, 8))), _s0, 0.0);
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
        _v1 = choose((0.0 < parameter(_given, _t1[_k1][0])), _v1, 0.0);
    }
    double _v4 = _v1;
    static const int _t4[][2] = {
        {12, 12},
        {13, 13},
        {14, 14},
    };
    for (size_t _k4 = 0; _k4 < 3; _k4++) {
        _v4 = choose((0.0 <= parameter(_given, _t4[_k4][0])), _v4, 0.0);
        _v4 = choose((parameter(_given, _t4[_k4][1]) <= 1.0), _v4, 0.0);
    }
    const double _s7 = choose((0.0 <= parameter(_given, 16)), choose((0.0 <= parameter(_given, 15)), _v4, 0.0), 0.0);
    const double _s8 = choose((-1.0 <= parameter(_given, 19)), choose((parameter(_given, 18) <= 1.0), choose((0.015625 <= parameter(_given, 18)), choose((0.0 < parameter(_given, 18)), choose((0.0 <= parameter(_given, 17)), _s7, 0.0), 0.0), 0.0), 0.0), 0.0);
    return {choose((0.0 < parameter(_given, 20)), choose((parameter(_given, 19) <= 1.0), _s8, 0.0), 0.0)};
}

/* Whether the parameters are allowed, and no arithmetic with them over- or underflows.
   the range of numbers. 68 operations: 21 absolute values, 24 comparisons, 23 conjunctions. */
struct kernel_parameters_in_range_out {
    bool permitted;
};

static __device__ __forceinline__ kernel_parameters_in_range_out kernel_parameters_in_range(const shot_parameters &_given, double allowed)
{
    const double _s0 = fabs(parameter(_given, 0));
    const double _s1 = fabs(parameter(_given, 10));
    bool _v2 = ((0.0 < allowed) && (_s0 <= 1073741824.0)) && (9.313225746154785e-10 <= _s0);
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
        _v2 = _v2 && (fabs(parameter(_given, _t2[_k2][0])) <= 1073741824.0);
    }
    const bool _s5 = _v2 && (9.313225746154785e-10 <= _s1);
    const bool _s6 = (((_s5 && (fabs(parameter(_given, 11)) <= 1073741824.0)) && (fabs(parameter(_given, 12)) <= 1.2676506002282294e+30)) && (fabs(parameter(_given, 13)) <= 1.2676506002282294e+30)) && (fabs(parameter(_given, 14)) <= 1.2676506002282294e+30);
    const bool _s7 = (((_s6 && (fabs(parameter(_given, 15)) <= (INFINITE))) && (fabs(parameter(_given, 16)) <= (INFINITE))) && (fabs(parameter(_given, 17)) <= (INFINITE))) && (fabs(parameter(_given, 18)) <= 1.2676506002282294e+30);
    return {(_s7 && (fabs(parameter(_given, 19)) <= 1.2676506002282294e+30)) && (fabs(parameter(_given, 20)) <= (INFINITE))};
}

/* 1 if the ball overlaps no surface; 1 if that is undecided.
   Table 2. 133 operations: 27 additions, 19 subtractions, 15 multiplications, 3 square roots, 4 negations, 20 absolute values, 21 comparisons, 24 selections. */
struct kernel_valid_out {
    double valid, undecided_time;
};

static __device__ __forceinline__ kernel_valid_out kernel_valid(double last, double x, double y, double z, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_board_distance, double p_board_half_width, double p_board_bottom, double p_board_top, double p_board_thickness, double p_bridge_half_width, double p_bridge_depth, double p_end_depth)
{
    const double _s0 = sqrt(((x * x) + (y * y))) - p_ring_radius;
    const double _s1 = p_ball_radius + p_wire_radius;
    const double _s2 = ((z * z) + (_s0 * _s0)) - (_s1 * _s1);
    const bool _s3 = fabs(last) < 0.5;
    const double _s4 = choose(_s3, 1.0, choose((0.0 <= _s2), 1.0, 0.0));
    const double _s5 = z - p_board_top;
    const double _s6 = p_board_bottom - z;
    const double _s7 = larger(_s5, 0.0) - larger(_s6, 0.0);
    const double _s8 = p_board_distance + x;
    const double _s9 = -((p_board_distance + p_board_thickness) + x);
    const double _s10 = larger(_s8, 0.0) - larger(_s9, 0.0);
    const double _s11 = y - p_board_half_width;
    const double _s12 = -(p_board_half_width + y);
    const double _s13 = larger(_s11, 0.0) - larger(_s12, 0.0);
    const double _s14 = sqrt((((_s7 * _s7) + (_s10 * _s10)) + (_s13 * _s13))) - p_ball_radius;
    const bool _s15 = fabs((last - 1.0)) < 0.5;
    const double _s16 = choose(_s15, _s4, choose((0.0 <= _s14), _s4, 0.0));
    const double _s17 = p_ring_radius + x;
    const double _s18 = -_s8;
    const double _s19 = larger(_s17, 0.0) - larger(_s18, 0.0);
    const double _s20 = z - p_wire_radius;
    const double _s21 = (p_wire_radius - p_bridge_depth) - z;
    const double _s22 = larger(_s20, 0.0) - larger(_s21, 0.0);
    const double _s23 = y - p_bridge_half_width;
    const double _s24 = -(p_bridge_half_width + y);
    const double _s25 = larger(_s23, 0.0) - larger(_s24, 0.0);
    const double _s26 = sqrt((((_s19 * _s19) + (_s22 * _s22)) + (_s25 * _s25))) - p_ball_radius;
    const bool _s27 = fabs((last - 2.0)) < 0.5;
    const double _s28 = ((((fabs(p_board_bottom) + fabs(p_board_top)) + fabs(p_ball_radius)) + fabs(p_ring_radius)) + fabs(p_wire_radius)) + fabs(p_board_distance);
    const double _s29 = ((((_s28 + fabs(p_board_half_width)) + fabs(p_board_thickness)) + fabs(p_bridge_half_width)) + fabs(p_bridge_depth)) + fabs(p_end_depth);
    const double _s30 = 1.7763568394002505e-15 * (((_s29 + fabs(x)) + fabs(y)) + fabs(z));
    const double _s31 = choose(_s3, 0.0, choose((fabs(_s2) <= (((4.0 * p_ball_radius) + (4.0 * p_wire_radius)) * _s30)), 1.0, 0.0));
    const double _s32 = choose(_s15, _s31, choose((fabs(_s14) <= _s30), 1.0, _s31));
    return {choose(_s27, _s16, choose((0.0 <= _s26), _s16, 0.0)), choose(_s27, _s32, choose((fabs(_s26) <= _s30), 1.0, _s32))};
}

/* Whether the ball starts near a surface; otherwise its start is valid and decided.
   Table 2. 54 operations: 19 additions, 6 subtractions, 5 multiplications, 2 negations, 16 absolute values, 3 comparisons, 2 conjunctions, 1 complement. */
struct kernel_aside_out {
    bool close;
    double valid, undecided_time;
};

static __device__ __forceinline__ kernel_aside_out kernel_aside(double x, double y, double z, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_board_distance, double p_board_half_width, double p_board_bottom, double p_board_top, double p_board_thickness, double p_bridge_half_width, double p_bridge_depth, double p_end_depth)
{
    const double _s0 = ((((fabs(p_board_bottom) + fabs(p_board_top)) + fabs(p_ball_radius)) + fabs(p_ring_radius)) + fabs(p_wire_radius)) + fabs(p_board_distance);
    const double _s1 = ((((_s0 + fabs(p_board_half_width)) + fabs(p_board_thickness)) + fabs(p_bridge_half_width)) + fabs(p_bridge_depth)) + fabs(p_end_depth);
    const double _s2 = fabs(x);
    const double _s3 = 8.0 * (1.7763568394002505e-15 * (((_s1 + _s2) + fabs(y)) + fabs(z)));
    const double _s4 = 0.5 * p_board_thickness;
    const bool _s5 = _s3 < (fabs((x - (-(p_board_distance + _s4)))) - (p_ball_radius + _s4));
    const double _s6 = 0.5 * p_ring_radius;
    const double _s7 = 0.5 * p_board_distance;
    const bool _s8 = _s3 < (fabs((x - (-(_s6 + _s7)))) - ((p_ball_radius + _s7) - _s6));
    const bool _s9 = ((_s3 < (_s2 - ((p_ball_radius + p_ring_radius) + p_wire_radius))) && _s5) && _s8;
    return {!_s9, 1.0, 0.0};
}

/* Whether a ball counts as fallen through the ring at its start.
   Table 2, success. 22 operations: 2 additions, 1 subtraction, 4 multiplications, 1 negation, 1 absolute value, 6 comparisons, 5 conjunctions, 2 selections. */
struct kernel_passing_start_out {
    double through, uncertain;
};

static __device__ __forceinline__ kernel_passing_start_out kernel_passing_start(double last, double outcome, double uncertain, double x, double y, double z, double p_ring_radius, double p_end_depth)
{
    const bool _s0 = ((0.0 <= last) && (z < 0.0)) && ((-p_end_depth) <= z);
    const double _s1 = (x * x) + (y * y);
    const double _s2 = p_ring_radius * p_ring_radius;
    const double _s3 = choose(((_s0 && (fabs((_s1 - _s2)) <= (8.881784197001252e-16 * (_s2 + _s1)))) && (outcome < 0.0)), 1.0, uncertain);
    return {choose((_s0 && (_s1 < _s2)), 1.0, 0.0), _s3};
}

/* 1 for a ball that fell through the ring's disc, -1 for one that came up, else 0.
   Eq. 3, its roots in the ring's plane. 66 operations: 9 additions, 2 subtractions, 18 multiplications, 1 division, 1 square root, 16 comparisons, 9 conjunctions, 2 disjunctions, 8 selections. */
struct kernel_passing_out {
    double through;
};

static __device__ __forceinline__ kernel_passing_out kernel_passing(double through, double t, double x, double y, double z, double vx, double vy, double vz, double p_ring_radius, double p_gravity)
{
    const bool _s0 = z < 0.0;
    const double _s1 = z + (t * (vz - ((0.5 * p_gravity) * t)));
    const bool _s2 = _s1 < 0.0;
    const double _s3 = (vz * vz) + ((2.0 * p_gravity) * z);
    const bool _s4 = (((_s0 && _s2) && (0.0 < vz)) && (0.0 < _s3)) && (vz < (p_gravity * t));
    const double _s5 = sqrt(larger(_s3, 0.0));
    const double _s6 = 1.0 / p_gravity;
    const double _s7 = (vz + _s5) * _s6;
    const double _s8 = larger(0.0, _s7);
    const double _s9 = smaller(_s8, t);
    const double _s10 = x + (vx * _s9);
    const double _s11 = y + (vy * _s9);
    const double _s12 = p_ring_radius * p_ring_radius;
    const double _s13 = (vz - _s5) * _s6;
    const double _s14 = larger(0.0, _s13);
    const double _s15 = smaller(_s14, t);
    const double _s16 = x + (vx * _s15);
    const double _s17 = y + (vy * _s15);
    const double _s18 = choose(((_s4 || (_s0 && (0.0 <= _s1))) && (((_s16 * _s16) + (_s17 * _s17)) < _s12)), choose((through == 1.0), 0.0, -1.0), through);
    const double _s19 = choose((((_s4 || (_s2 && (0.0 <= z))) && (((_s10 * _s10) + (_s11 * _s11)) < _s12)) && (_s18 == 0.0)), 1.0, _s18);
    return {_s19};
}

/* Whether the passing of the disc lies within its error.
   running error analysis. 107 operations: 18 additions, 4 subtractions, 31 multiplications, 1 division, 4 square roots, 6 absolute values, 20 comparisons, 11 conjunctions, 6 disjunctions, 6 selections. */
struct kernel_passing_undecided_out {
    bool undecided;
};

static __device__ __forceinline__ kernel_passing_undecided_out kernel_passing_undecided(double t, double x, double y, double z, double vx, double vy, double vz, double extent, double speed, double position_error, double velocity_error, double p_ring_radius, double p_gravity)
{
    const double _s0 = z + (t * (vz - ((0.5 * p_gravity) * t)));
    const double _s1 = vz * vz;
    const double _s2 = 1.0 / p_gravity;
    const double _s3 = p_gravity * t;
    const double _s4 = speed + _s3;
    const double _s5 = 1.0009765625 * ((position_error + (t * velocity_error)) + (4.440892098500626e-16 * (extent + (t * _s4))));
    const double _s6 = (8.881784197001252e-16 * (_s1 * _s2)) + _s5;
    const bool _s7 = z < 0.0;
    const bool _s8 = _s0 < 0.0;
    const bool _s9 = (_s7 && _s8) && (0.0 < vz);
    const double _s10 = _s1 + ((2.0 * p_gravity) * z);
    const double _s11 = sqrt(larger(_s10, 0.0));
    const double _s12 = (vz + _s11) * _s2;
    const double _s13 = larger(0.0, _s12);
    const double _s14 = smaller(_s13, t);
    const double _s15 = x + (vx * _s14);
    const double _s16 = y + (vy * _s14);
    const double _s17 = sqrt(((_s15 * _s15) + (_s16 * _s16)));
    const double _s18 = (vz - _s11) * _s2;
    const double _s19 = larger(0.0, _s18);
    const double _s20 = smaller(_s19, t);
    const double _s21 = x + (vx * _s20);
    const double _s22 = y + (vy * _s20);
    const double _s23 = sqrt(((_s21 * _s21) + (_s22 * _s22)));
    const double _s24 = (1.0009765625 * _s4) * (sqrt(((8.0 * _s2) * _s6)) + (8.881784197001252e-16 * (t + (fabs(vz) * _s2))));
    const double _s25 = _s24 + _s5;
    const bool _s26 = ((((0.0 < position_error) && (fabs(z) <= position_error)) || (fabs(_s0) <= _s6)) || (_s9 && (fabs(_s10) <= ((4.0 * p_gravity) * _s6)))) && (smaller(_s17, _s23) <= (p_ring_radius + _s25));
    const bool _s27 = (_s9 && (0.0 < _s10)) && (vz < _s3);
    const bool _s28 = _s26 || (((_s27 || (_s7 && (0.0 <= _s0))) && (fabs((_s23 - p_ring_radius)) <= _s25)) || ((_s27 || (_s8 && (0.0 <= z))) && (fabs((_s17 - p_ring_radius)) <= _s25)));
    return {_s28};
}

/* Whether a ball in contact is not below the ring's disc.
   Table 1. 1 operation: 1 comparison. */
struct kernel_passing_from_out {
    bool over;
};

static __device__ __forceinline__ kernel_passing_from_out kernel_passing_from(double z)
{
    return {0.0 <= z};
}

/* Passing of the ring's disc in a step in contact.
   Table 1. 18 operations: 1 addition, 3 multiplications, 5 comparisons, 5 conjunctions, 1 complement, 3 selections. */
struct kernel_passing_in_contact_out {
    double through;
};

static __device__ __forceinline__ kernel_passing_in_contact_out kernel_passing_in_contact(double p_ring_radius, double x, double y, double z, double through, bool over)
{
    const bool _s0 = ((x * x) + (y * y)) < (p_ring_radius * p_ring_radius);
    const double _s1 = choose((((!over) && (0.0 <= z)) && _s0), choose((through == 1.0), 0.0, -1.0), through);
    return {choose((((over && (z < 0.0)) && _s0) && (_s1 == 0.0)), 1.0, _s1)};
}

/* Boxes of the first and the second half of the flight until the horizon.
   Eq. 3, the chords of both and what it is off them. 62 operations: 21 additions, 5 subtractions, 27 multiplications, 1 negation, 6 absolute values, 1 comparison, 1 selection. */
struct kernel_half_flight_boxes_out {
    double middle_x, reach_x, later_middle_x, later_reach_x, middle_y, reach_y, later_middle_y, later_reach_y, middle_z, reach_z, later_middle_z, later_reach_z;
};

static __device__ __forceinline__ kernel_half_flight_boxes_out kernel_half_flight_boxes(double horizon, double x, double y, double z, double vx, double vy, double vz, double extent, double speed, double position_error, double velocity_error, double earliest_delay, double pad, double p_gravity)
{
    const double _s0 = 0.5 * horizon;
    const double _s1 = vx * _s0;
    const double _s2 = 0.5 * _s1;
    const double _s3 = fabs(0.0);
    const double _s4 = (position_error + (horizon * velocity_error)) + (9.313225746154785e-10 * (extent + (horizon * (speed + (p_gravity * horizon)))));
    const double _s5 = choose((pad < earliest_delay), (INFINITE), _s4);
    const double _s6 = 1.0000000009313226 * ((_s3 + (0.5 * fabs(_s1))) + _s5);
    const double _s7 = vy * _s0;
    const double _s8 = 0.5 * _s7;
    const double _s9 = 1.0000000009313226 * ((_s3 + (0.5 * fabs(_s7))) + _s5);
    const double _s10 = (0.5 * p_gravity) * _s0;
    const double _s11 = _s0 * (vz - _s10);
    const double _s12 = -((0.0625 * p_gravity) * (_s0 * _s0));
    const double _s13 = fabs(_s12);
    const double _s14 = _s0 * ((vz - (p_gravity * _s0)) - _s10);
    return {x + _s2, _s6, _s2 + (x + _s1), _s6, y + _s8, _s9, _s8 + (y + _s7), _s9, (z + (0.5 * _s11)) - _s12, 1.0000000009313226 * ((_s13 + (0.5 * fabs(_s11))) + _s5), ((0.5 * _s14) + (z + _s11)) - _s12, 1.0000000009313226 * ((_s13 + (0.5 * fabs(_s14))) + _s5)};
}

/* Start value: no surface of this kind.
   Table 1. No operations. */
struct kernel_other_kind_out {
    bool of_this_kind;
};

static __device__ __forceinline__ kernel_other_kind_out kernel_other_kind()
{
    return {false};
}

/* 1 if the flight starts on this surface.
   Table 1. 2 operations: 1 comparison, 1 selection. */
struct kernel_left_out {
    double leaving;
};

static __device__ __forceinline__ kernel_left_out kernel_left(double index, double last)
{
    return {choose((last == index), 1.0, 0.0)};
}

/* Whether a plane's only root is an arrival, the size of F'', and the nearest time.
   Table 1. 13 operations: 1 absolute value, 6 comparisons, 4 conjunctions, 1 disjunction, 1 selection. */
struct kernel_plane_root_out {
    bool arrives;
    double ceiling, nearest;
};

static __device__ __forceinline__ kernel_plane_root_out kernel_plane_root(double rate, double bend, double apex, double time)
{
    const bool _s0 = (((rate < 0.0) || (((rate <= 0.0) && (bend < 0.0)) && (time == 0.0))) && (0.0 <= time)) && (time < (INFINITE));
    return {_s0, fabs(bend), choose(_s0, time, apex)};
}

/* Whether an arrival may be the earliest within the delays.
   Table 1. 5 operations: 1 addition, 1 subtraction, 1 comparison, 1 conjunction, 1 complement. */
struct kernel_within_time_out {
    bool possible;
};

static __device__ __forceinline__ kernel_within_time_out kernel_within_time(double time, double when, double delay, double earliest_delay, bool arrives)
{
    return {arrives && (!((delay + earliest_delay) < (time - when)))};
}

/* Undecided time 0 if the largest gap from the start on is zero within its error.
   Table 1. 5 operations: 1 absolute value, 2 comparisons, 1 conjunction, 1 selection. */
struct kernel_apex_undecided_out {
    double undecided_time;
};

static __device__ __forceinline__ kernel_apex_undecided_out kernel_apex_undecided(double margin, double apex, double height, double undecided_time)
{
    return {choose(((0.0 <= apex) && (fabs(height) <= margin)), 0.0, undecided_time)};
}

/* Earliest undecided time, with that of an undecided predicate.
   Table 1. 3 operations: 1 comparison, 1 conjunction, 1 selection. */
struct kernel_predicate_undecided_out {
    double undecided_time;
};

static __device__ __forceinline__ kernel_predicate_undecided_out kernel_predicate_undecided(double time, double undecided_time, bool undecided)
{
    return {choose((undecided && (time < undecided_time)), time, undecided_time)};
}

/* Earliest undecided time, with that of an arrival whose crossing is not certain.
   Table 1. 6 operations: 2 comparisons, 2 conjunctions, 1 complement, 1 selection. */
struct kernel_crossing_undecided_out {
    double undecided_time;
};

static __device__ __forceinline__ kernel_crossing_undecided_out kernel_crossing_undecided(double clearance, double time, double undecided_time, bool arrives)
{
    return {choose(((arrives && (!(0.0 < clearance))) && (time < undecided_time)), time, undecided_time)};
}

/* Earliest undecided time, with that of a tie; the delay of the earlier arrival.
   Table 1. 16 operations: 1 addition, 2 subtractions, 1 multiplication, 1 absolute value, 4 comparisons, 3 conjunctions, 4 selections. */
struct kernel_tie_undecided_out {
    double undecided_time, earliest_delay;
};

static __device__ __forceinline__ kernel_tie_undecided_out kernel_tie_undecided(double time, double when, double delay, double earliest_delay, double undecided_time, bool arrives)
{
    const double _s0 = delay + earliest_delay;
    const bool _s1 = time < when;
    const double _s2 = choose(_s1, time, when);
    const double _s3 = 0.5 * _s2;
    const double _s4 = _s2 - smaller(_s3, _s0);
    const double _s5 = choose(((arrives && (fabs((time - when)) <= _s0)) && (_s4 < undecided_time)), _s4, undecided_time);
    return {_s5, choose((arrives && _s1), delay, earliest_delay)};
}

/* Time and surface of the earliest arrival, with this one.
   Table 1. 4 operations: 1 comparison, 1 conjunction, 2 selections. */
struct kernel_earliest_out {
    double when, which;
};

static __device__ __forceinline__ kernel_earliest_out kernel_earliest(double index, double time, double when, double which, bool arrives)
{
    const bool _s0 = arrives && (time < when);
    return {choose(_s0, time, when), choose(_s0, index, which)};
}

/* Start values of a search: its error budget, and no arrival.
   Table 1. No operations. */
struct kernel_beginning_out {
    double share, arrival;
    bool certain;
};

static __device__ __forceinline__ kernel_beginning_out kernel_beginning()
{
    return {2.9802322387695312e-08, INFINITE, false};
}

/* Undecided time 0 if errors exceed the budget of a search, or its bounds fail.
   Table 1. 7 operations: 1 multiplication, 3 comparisons, 2 disjunctions, 1 selection. */
struct kernel_out_of_budget_out {
    double undecided_time;
};

static __device__ __forceinline__ kernel_out_of_budget_out kernel_out_of_budget(double pad, double budget_exceeded, double earliest_delay, double undecided_time, double excess)
{
    return {choose((((0.0 < excess) || (pad < (0.5 * earliest_delay))) || (0.0 < budget_exceeded)), 0.0, undecided_time)};
}

/* Undecided time 0 if errors exceed the budget of an open window, or its bounds fail.
   Table 1. 8 operations: 1 multiplication, 3 comparisons, 1 conjunction, 2 disjunctions, 1 selection. */
struct kernel_out_of_budget_in_windows_out {
    double undecided_time;
};

static __device__ __forceinline__ kernel_out_of_budget_in_windows_out kernel_out_of_budget_in_windows(double pad, double budget_exceeded, double earliest_delay, double undecided_time, double excess, bool searching)
{
    const double _s0 = choose(((searching && ((0.0 < excess) || (pad < (0.5 * earliest_delay)))) || (0.0 < budget_exceeded)), 0.0, undecided_time);
    return {_s0};
}

/* Undecided time 0 if the earliest arrival may be after the horizon.
   Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection. */
struct kernel_overdue_out {
    double undecided_time;
};

static __device__ __forceinline__ kernel_overdue_out kernel_overdue(double pad, double earliest_delay, double undecided_time)
{
    return {choose((pad < (0.5 * earliest_delay)), 0.0, undecided_time)};
}

/* 1 near the surface that the ball left, where F/t is more exact than F; the margin.
   Table 1. 6 operations: 1 multiplication, 2 comparisons, 1 conjunction, 2 selections. */
struct kernel_nearby_out {
    double leaving, margin;
};

static __device__ __forceinline__ kernel_nearby_out kernel_nearby(double t, double flat, double tilt, double index, double last)
{
    const double _s0 = t * tilt;
    const bool _s1 = (last == index) && (_s0 < flat);
    return {choose(_s1, 1.0, 0.0), choose(_s1, _s0, flat)};
}

/* Begin of the first window and end of the last one, from single precision.
   Table 1. No operations. */
struct kernel_opened_out {
    double time, latest;
};

static __device__ __forceinline__ kernel_opened_out kernel_opened(double horizon, double time)
{
    return {time, horizon};
}

/* Whether a search begins in single precision; its ceiling, margins and error budget.
   Table 1. 6 operations: 3 conjunctions, 1 disjunction, 1 complement, 1 selection. */
struct kernel_coarse_out {
    bool stepping, searching, single_precision;
    double ceiling, flat, tilt, allowing;
};

static __device__ __forceinline__ kernel_coarse_out kernel_coarse(double rate_margin, double flat, double ceiling, double share, bool searching, bool representable, bool fits)
{
    const bool _s0 = (searching && representable) && fits;
    return {_s0, searching || (!representable), _s0, ceiling, flat, rate_margin, choose((representable && fits), share, 2.9802322387695312e-08)};
}

/* Root from the search in single precision; whether and where the search goes on.
   Table 1. 7 operations: 1 addition, 1 comparison, 2 conjunctions, 1 complement, 2 selections. */
struct kernel_stepped_out {
    double arrival, t;
    bool searching;
};

static __device__ __forceinline__ kernel_stepped_out kernel_stepped(double arrival, double lasting, bool searching, double since, bool single_precision, bool certain)
{
    const double _s0 = lasting + since;
    return {choose(certain, _s0, arrival), choose(single_precision, _s0, 0.0), (searching && (!certain)) && (lasting < (INFINITE))};
}

/* Whether the gap closes, certainly closes, or needs a smaller error budget.
   Table 1. 17 operations: 1 subtraction, 6 comparisons, 6 conjunctions, 2 disjunctions, 2 complements. */
struct kernel_gap_closes_out {
    bool hit, sure, needs_refinement;
};

static __device__ __forceinline__ kernel_gap_closes_out kernel_gap_closes(double gap, double rate, double bend, double margin, double rate_margin, double clearance, double share)
{
    const bool _s0 = (rate < 0.0) || ((rate <= rate_margin) && (bend < 0.0));
    const bool _s1 = 0.0 < clearance;
    const bool _s2 = _s0 && (((gap - margin) <= margin) || _s1);
    const bool _s3 = _s0 && _s1;
    const bool _s4 = (_s2 && (!_s3)) && (0.0 < share);
    return {_s2 && (!_s4), _s3, _s4};
}

/* Whether the gap closes; a step that moves nothing needs a smaller budget, too.
   Table 1. 25 operations: 1 subtraction, 8 comparisons, 9 conjunctions, 3 disjunctions, 4 complements. */
struct kernel_gap_closes_or_stalls_out {
    bool hit, sure, needs_refinement;
};

static __device__ __forceinline__ kernel_gap_closes_or_stalls_out kernel_gap_closes_or_stalls(double t, double end, double gap, double rate, double bend, double margin, double rate_margin, double next, double clearance, double share)
{
    const bool _s0 = (rate < 0.0) || ((rate <= rate_margin) && (bend < 0.0));
    const bool _s1 = 0.0 < clearance;
    const bool _s2 = _s0 && (((gap - margin) <= margin) || _s1);
    const bool _s3 = _s0 && _s1;
    const bool _s4 = 0.0 < share;
    const bool _s5 = (_s2 && (!_s3)) && _s4;
    const bool _s6 = _s5 || (((!_s2) && ((t < end) && (!(t < next)))) && _s4);
    return {_s2 && (!_s5), _s3, _s6};
}

/* Next smaller error budget.
   Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection. */
struct kernel_smaller_budget_out {
    double share;
};

static __device__ __forceinline__ kernel_smaller_budget_out kernel_smaller_budget(double share)
{
    return {choose((2.842170943040401e-14 < share), (0.03125 * share), 0.0)};
}

/* Earliest undecided time, with the present one if the errors exceed the budget.
   Table 1. 4 operations: 2 comparisons, 1 conjunction, 1 selection. */
struct kernel_budget_undecided_out {
    double undecided_time;
};

static __device__ __forceinline__ kernel_budget_undecided_out kernel_budget_undecided(double t, double undecided_time, double excess)
{
    return {choose(((0.0 < excess) && (t < undecided_time)), t, undecided_time)};
}

/* Root, time and state of a search after a step, and whether its window is exhausted.
   Table 1. 14 operations: 1 subtraction, 1 comparison, 4 conjunctions, 2 disjunctions, 3 complements, 3 selections. */
struct kernel_advanced_out {
    double arrival;
    bool certain, exhausted, searching;
    double t;
};

static __device__ __forceinline__ kernel_advanced_out kernel_advanced(double t, double end, double step, double next, double arrival, bool hit, bool sure, bool needs_refinement, bool certain)
{
    const bool _s0 = !hit;
    const bool _s1 = (_s0 && (!needs_refinement)) && ((end - t) <= step);
    return {choose(hit, choose(sure, next, t), arrival), certain || (hit && sure), _s1, _s0 && (!_s1), choose((hit || needs_refinement), t, next)};
}

/* Whether a search found an arrival.
   Table 1. 1 operation: 1 comparison. */
struct kernel_found_out {
    bool arrives, refining;
    double rate;
};

static __device__ __forceinline__ kernel_found_out kernel_found(double arrival)
{
    const bool _s0 = arrival < (INFINITE);
    return {_s0, _s0, 0.0};
}

/* A root or a return that is not certain, refined, and whether it is refined again.
   Table 1. 11 operations: 3 multiplications, 1 absolute value, 3 comparisons, 2 conjunctions, 1 disjunction, 1 selection. */
struct kernel_refined_return_out {
    double arrival;
    bool refining;
};

static __device__ __forceinline__ kernel_refined_return_out kernel_refined_return(double leaving, double gap, double rate, double ceiling, double arrival, double refined, bool certain)
{
    const bool _s0 = certain || ((0.0 < leaving) && (rate < 0.0));
    return {choose(_s0, refined, arrival), _s0 && ((5.960464477539063e-08 * (rate * rate)) < (ceiling * fabs(gap)))};
}

/* Margin of the form, F or F/t, in which an arrival was found.
   Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection. */
struct kernel_own_margin_out {
    double margin;
};

static __device__ __forceinline__ kernel_own_margin_out kernel_own_margin(double leaving, double flat, double tilt, double arrival)
{
    return {choose((0.0 < leaving), (tilt * arrival), flat)};
}

/* Time of an arrival, not before the flight.
   Table 1. 2 operations: 1 comparison, 1 selection. */
struct kernel_arrival_time_out {
    double time;
};

static __device__ __forceinline__ kernel_arrival_time_out kernel_arrival_time(double arrival)
{
    return {choose((arrival < 0.0), 0.0, arrival)};
}

/* Delay of a certain arrival; the earliest undecided time, with where the search of any other one stands, which may have been refined since.
   Table 1. 12 operations: 1 subtraction, 3 comparisons, 3 conjunctions, 1 complement, 4 selections. */
struct kernel_return_certainty_out {
    double delay, undecided_time;
};

static __device__ __forceinline__ kernel_return_certainty_out kernel_return_certainty(double t, double clearance, double time, double delay, double undecided_time, bool arrives, bool certain)
{
    const bool _s0 = certain && (0.0 < clearance);
    const double _s1 = choose(certain, (time - delay), smaller(time, t));
    return {choose(_s0, delay, 0.0), choose(((arrives && (!_s0)) && (_s1 < undecided_time)), _s1, undecided_time)};
}

/* Start values: the ball is outside the surface, and not known to begin at it.
   Table 1. No operations. */
struct kernel_outside_out {
    double side, gap_at_start;
};

static __device__ __forceinline__ kernel_outside_out kernel_outside()
{
    return {1.0, INFINITE};
}

/* Whether all numbers of a release are small enough not to overflow.
   Table 1. 26 operations: 9 absolute values, 9 comparisons, 8 conjunctions. */
struct kernel_state_in_range_out {
    bool in_range;
};

static __device__ __forceinline__ kernel_state_in_range_out kernel_state_in_range(double x, double y, double z, double vx, double vy, double vz, double wx, double wy, double wz)
{
    const bool _s0 = ((((fabs(x) <= 1073741824.0) && (fabs(y) <= 1073741824.0)) && (fabs(z) <= 1073741824.0)) && (fabs(vx) <= 1073741824.0)) && (fabs(vy) <= 1073741824.0);
    const bool _s1 = (((_s0 && (fabs(vz) <= 1073741824.0)) && (fabs(wx) <= 1073741824.0)) && (fabs(wy) <= 1073741824.0)) && (fabs(wz) <= 1073741824.0);
    return {_s1};
}

/* Start values: no arrival; an uncertain shot if its errors are not bounded.
   Table 1. 6 operations: 3 comparisons, 2 conjunctions, 1 selection. */
struct kernel_opening_out {
    double when, which, earliest_delay, undecided_time;
};

static __device__ __forceinline__ kernel_opening_out kernel_opening(double excess, double position_error, double velocity_error)
{
    return {INFINITE, -1.0, 0.0, choose((((position_error < (INFINITE)) && (velocity_error < (INFINITE))) && (excess <= 0.0)), (INFINITE), 0.0)};
}

/* Whether there is a time limit.
   Table 1. 1 operation: 1 comparison. */
struct kernel_limited_out {
    bool limited;
};

static __device__ __forceinline__ kernel_limited_out kernel_limited(double time_limit)
{
    return {time_limit < (INFINITE)};
}

/* Time of the event.
   Table 1. 1 operation: 1 addition. */
struct kernel_event_clock_out {
    double clock;
};

static __device__ __forceinline__ kernel_event_clock_out kernel_event_clock(double when, double clock)
{
    return {when + clock};
}

/* Whether an event changes the motion, or its errors are wanted.
   Table 1. 3 operations: 1 comparison, 1 conjunction, 1 disjunction. */
struct kernel_meeting_out {
    bool meeting;
};

static __device__ __forceinline__ kernel_meeting_out kernel_meeting(double claims, bool ends, bool touches)
{
    return {touches || (ends && (0.0 < claims))};
}

/* Whether the event is on a surface.
   Table 1. 1 operation: 1 comparison. */
struct kernel_here_out {
    bool here;
};

static __device__ __forceinline__ kernel_here_out kernel_here(double index, double which)
{
    return {which == index};
}

/* One more contact.
   Table 1. 1 operation: 1 addition. */
struct kernel_counted_out {
    double count;
};

static __device__ __forceinline__ kernel_counted_out kernel_counted(double count)
{
    return {1.0 + count};
}

/* Start value: another surface.
   Table 1. No operations. */
struct kernel_elsewhere_out {
    double curving;
};

static __device__ __forceinline__ kernel_elsewhere_out kernel_elsewhere()
{
    return {INFINITE};
}

/* 1 if the flight began on the surface that the ball meets.
   Table 1. 2 operations: 1 comparison, 1 selection. */
struct kernel_came_back_out {
    double back;
};

static __device__ __forceinline__ kernel_came_back_out kernel_came_back(double last, double which)
{
    return {choose((last == which), 1.0, 0.0)};
}

/* Whether the ball meets the same surface again.
   Table 1. 3 operations: 2 comparisons, 1 conjunction. */
struct kernel_again_out {
    bool again;
};

static __device__ __forceinline__ kernel_again_out kernel_again(double index, double last, double which)
{
    return {(which == index) && (last == which)};
}

/* Body touched first and surface touched last.
   Table 1. 2 operations: 1 comparison, 1 selection. */
struct kernel_touched_out {
    double first, last;
};

static __device__ __forceinline__ kernel_touched_out kernel_touched(double which, double body, double first)
{
    return {choose((first < 0.0), body, first), which};
}

/* Whether a shot has ended at the time limit and its errors are wanted.
   Table 1. 3 operations: 2 comparisons, 1 conjunction. */
struct kernel_ends_by_time_limit_out {
    bool ends_by_time_limit;
};

static __device__ __forceinline__ kernel_ends_by_time_limit_out kernel_ends_by_time_limit(double index, double which, double claims)
{
    return {(which == index) && (0.0 < claims)};
}

/* 1 if a decision within a contact lies within its error.
   Table 1. 1 operation: 1 selection. */
struct kernel_undecided_out {
    double uncertain;
};

static __device__ __forceinline__ kernel_undecided_out kernel_undecided(double uncertain, bool undecided)
{
    return {choose(undecided, 1.0, uncertain)};
}

/* Body that the event is on.
   Table 1. No operations. */
struct kernel_body_of_out {
    double body;
};

static __device__ __forceinline__ kernel_body_of_out kernel_body_of(double which)
{
    return {which};
}

/* Outcome of a shot at its start, and whether that is uncertain.
   Table 1. 7 operations: 2 comparisons, 3 conjunctions, 2 selections. */
struct kernel_admitted_out {
    double outcome, uncertain;
};

static __device__ __forceinline__ kernel_admitted_out kernel_admitted(double undecided_time, double valid, bool permitted, bool in_range)
{
    const bool _s0 = permitted && in_range;
    return {choose((_s0 && (0.0 < valid)), -1.0, 4.0), choose((_s0 && (0.0 < undecided_time)), 1.0, 0.0)};
}

/* The time limit as an arrival.
   Table 1. 12 operations: 2 additions, 1 subtraction, 1 multiplication, 4 comparisons, 1 conjunction, 1 complement, 2 selections. */
struct kernel_expiry_out {
    double time, delay;
    bool arrives;
    double undecided_time;
};

static __device__ __forceinline__ kernel_expiry_out kernel_expiry(double when, double which, double earliest_delay, double undecided_time, double time_error, double clock, double time_limit)
{
    const double _s0 = time_limit - clock;
    return {larger(0.0, _s0), time_error + (4.440892098500626e-16 * time_limit), 0.0 <= which, choose(((!((when + earliest_delay) < undecided_time)) && (undecided_time < (INFINITE))), 0.0, undecided_time)};
}

/* Whether there is no event, an end, or a contact, and the outcome without one.
   Table 1. 5 operations: 3 comparisons, 1 conjunction, 1 complement. */
struct kernel_departed_out {
    bool stays, moves, ends, touches;
    double reached;
    bool edge;
};

static __device__ __forceinline__ kernel_departed_out kernel_departed(double index, double which)
{
    const bool _s0 = which < 0.0;
    const bool _s1 = !_s0;
    return {_s0, _s1, index <= which, _s1 && (which < index), 3.0, false};
}

/* Time, body and outcome of a shot that the time limit ends.
   Table 1. 6 operations: 1 comparison, 1 conjunction, 1 complement, 3 selections. */
struct kernel_expired_out {
    double clock, body, reached;
    bool ends;
};

static __device__ __forceinline__ kernel_expired_out kernel_expired(double index, double which, double body, double clock, double reached, double time_limit, bool ends)
{
    const bool _s0 = which == index;
    return {choose(_s0, time_limit, clock), choose(_s0, 3.0, body), choose(_s0, 6.0, reached), ends && (!_s0)};
}

/* Number of contacts, and the outcome if the shot ends.
   Table 1. 5 operations: 1 addition, 1 comparison, 3 selections. */
struct kernel_accounted_out {
    double contacts, outcome;
};

static __device__ __forceinline__ kernel_accounted_out kernel_accounted(double contacts, double most_contacts, double reached, bool touches)
{
    const double _s0 = 1.0 + contacts;
    return {choose(touches, _s0, contacts), choose(touches, choose((most_contacts <= _s0), 2.0, -1.0), reached)};
}

/* Sum of the errors of the contacts' times.
   Table 1. 1 operation: 1 addition. */
struct kernel_clock_error_sum_out {
    double clock_error;
};

static __device__ __forceinline__ kernel_clock_error_sum_out kernel_clock_error_sum(double delay, double clock_error)
{
    return {delay + clock_error};
}

/* Whether bounds on errors are wanted here, and their start values.
   Table 1. 5 operations: 3 comparisons, 1 conjunction, 1 disjunction. */
struct kernel_closing_out {
    bool reports;
    double position_claim, velocity_claim, spin_claim, time_claim;
};

static __device__ __forceinline__ kernel_closing_out kernel_closing(double outcome, double claims)
{
    return {((0.0 < claims) && (0.0 <= outcome)) || (1.0 < claims), 0.0, 0.0, 0.0, 0.0};
}

/* Errors at the end, not below the largest that one flight can cause.
   Table 1. 9 operations: 3 absolute values, 3 comparisons, 3 selections. */
struct kernel_error_floor_out {
    double dx, dy, dz;
};

static __device__ __forceinline__ kernel_error_floor_out kernel_error_floor(double dx, double dy, double dz, double shift)
{
    return {choose((fabs(dx) < shift), shift, dx), choose((fabs(dy) < shift), shift, dy), choose((fabs(dz) < shift), shift, dz)};
}

/* Start values: a normal without error.
   Table 1. No operations. */
struct kernel_no_normal_error_out {
    double dnx, dny, dnz, turn;
};

static __device__ __forceinline__ kernel_no_normal_error_out kernel_no_normal_error()
{
    return {0.0, 0.0, 0.0, 0.0};
}

/* Whether a ball in contact rolls on the ring.
   Table 1. 4 operations: 1 comparison, 2 conjunctions, 1 complement. */
struct kernel_circles_out {
    bool circling, rolling;
};

static __device__ __forceinline__ kernel_circles_out kernel_circles(double index, double held, bool rolling)
{
    const bool _s0 = held == index;
    return {rolling && _s0, rolling && (!_s0)};
}

/* Half a step, from the start and from the end.
   Table 1. 2 operations: 1 multiplication, 1 negation. */
struct kernel_half_steps_out {
    double forth, back;
};

static __device__ __forceinline__ kernel_half_steps_out kernel_half_steps(double stride)
{
    const double _s0 = 0.5 * stride;
    return {_s0, -_s0};
}

/* Distance from the nearest other surface, at any azimuth.
   tangents. 6 operations: 1 addition, 1 multiplication, 2 comparisons, 2 selections. */
struct kernel_clearance_at_any_azimuth_out {
    double azimuth_clearance;
};

static __device__ __forceinline__ kernel_clearance_at_any_azimuth_out kernel_clearance_at_any_azimuth(double gap, double nearing, double half_step, double azimuth_clearance)
{
    const double _s0 = nearing * half_step;
    const double _s1 = gap + smaller(_s0, 0.0);
    return {smaller(_s1, azimuth_clearance)};
}

/* Event: the ball certainly rolls for ever.
   Table 1. 1 operation: 1 selection. */
struct kernel_rolls_for_ever_out {
    double which;
};

static __device__ __forceinline__ kernel_rolls_for_ever_out kernel_rolls_for_ever(double which, bool endless)
{
    return {choose(endless, 8.0, which)};
}

/* Whether a ball goes on in contact, on whichever surface.
   Table 1. 1 operation: 1 disjunction. */
struct kernel_still_in_contact_out {
    bool rolling;
};

static __device__ __forceinline__ kernel_still_in_contact_out kernel_still_in_contact(bool rolling, bool circling)
{
    return {rolling || circling};
}

/* Coefficients of order 1 of a rolling ball, from those of lower order.
   Newton, Euler and rolling without slip. 46 operations: 8 additions, 5 subtractions, 31 multiplications, 1 division, 1 negation. */
struct kernel_roll_0_out {
    double lift_0, tx_0, ty_0, tz_0, vx_1, vy_1, vz_1, nx_1, ny_1, nz_1, turn_rate_1;
};

static __device__ __forceinline__ kernel_roll_0_out kernel_roll_0(double p_gravity, double p_inertia, double nx_0, double ny_0, double nz_0, double vx_0, double vy_0, double vz_0, double bent_x, double bent_y, double bent_z, double per_reach, double turn_rate_0)
{
    const double _s0 = 1.0 / (1.0 + p_inertia);
    const double _s1 = (vx_0 * bent_x) * per_reach;
    const double _s2 = (vy_0 * bent_y) * per_reach;
    const double _s3 = (vz_0 * bent_z) * per_reach;
    const double _s4 = ((p_gravity * nz_0) * _s0) - (((vx_0 * _s1) + (vy_0 * _s2)) + (vz_0 * _s3));
    const double _s5 = (ny_0 * _s3) - (nz_0 * _s2);
    const double _s6 = (nz_0 * _s1) - (nx_0 * _s3);
    const double _s7 = (nx_0 * _s2) - (ny_0 * _s1);
    const double _s8 = p_inertia * _s0;
    return {_s4, _s5, _s6, _s7, (_s8 * (turn_rate_0 * _s5)) + (nx_0 * _s4), (_s8 * (turn_rate_0 * _s6)) + (ny_0 * _s4), ((_s8 * (turn_rate_0 * _s7)) + (nz_0 * _s4)) - (p_gravity * _s0), _s1, _s2, _s3, -(((vx_0 * _s5) + (vy_0 * _s6)) + (vz_0 * _s7))};
}

/* Coefficients of order 2 of a rolling ball, from those of lower order.
   Newton, Euler and rolling without slip. 84 operations: 26 additions, 4 subtractions, 52 multiplications, 1 division, 1 negation. */
struct kernel_roll_1_out {
    double lift_1, tx_1, ty_1, tz_1, vx_2, vy_2, vz_2, nx_2, ny_2, nz_2, turn_rate_2;
};

static __device__ __forceinline__ kernel_roll_1_out kernel_roll_1(double p_gravity, double p_inertia, double nx_0, double nx_1, double ny_0, double ny_1, double nz_0, double nz_1, double vx_0, double vx_1, double vy_0, double vy_1, double vz_0, double vz_1, double bent_x, double bent_y, double bent_z, double per_reach, double turn_rate_0, double turn_rate_1, double lift_0, double tx_0, double ty_0, double tz_0)
{
    const double _s0 = 1.0 / (1.0 + p_inertia);
    const double _s1 = (vx_1 * bent_x) * per_reach;
    const double _s2 = (vy_1 * bent_y) * per_reach;
    const double _s3 = (vz_1 * bent_z) * per_reach;
    const double _s4 = ((p_gravity * nz_1) * _s0) - ((((nx_1 * vx_1) + (vx_0 * _s1)) + ((ny_1 * vy_1) + (vy_0 * _s2))) + ((nz_1 * vz_1) + (vz_0 * _s3)));
    const double _s5 = ny_1 * nz_1;
    const double _s6 = ((ny_0 * _s3) + _s5) - (_s5 + (nz_0 * _s2));
    const double _s7 = nx_1 * nz_1;
    const double _s8 = (_s7 + (nz_0 * _s1)) - ((nx_0 * _s3) + _s7);
    const double _s9 = nx_1 * ny_1;
    const double _s10 = ((nx_0 * _s2) + _s9) - (_s9 + (ny_0 * _s1));
    const double _s11 = p_inertia * _s0;
    const double _s12 = -(0.5 * ((((vx_0 * _s6) + (vx_1 * tx_0)) + ((vy_0 * _s8) + (vy_1 * ty_0))) + ((vz_0 * _s10) + (vz_1 * tz_0))));
    return {_s4, _s6, _s8, _s10, 0.5 * ((_s11 * ((turn_rate_0 * _s6) + (turn_rate_1 * tx_0))) + ((nx_0 * _s4) + (nx_1 * lift_0))), 0.5 * ((_s11 * ((turn_rate_0 * _s8) + (turn_rate_1 * ty_0))) + ((ny_0 * _s4) + (ny_1 * lift_0))), 0.5 * ((_s11 * ((turn_rate_0 * _s10) + (turn_rate_1 * tz_0))) + ((nz_0 * _s4) + (nz_1 * lift_0))), 0.5 * _s1, 0.5 * _s2, 0.5 * _s3, _s12};
}

/* Coefficients of order 3 of a rolling ball, from those of lower order.
   Newton, Euler and rolling without slip. 128 operations: 44 additions, 4 subtractions, 78 multiplications, 1 division, 1 negation. */
struct kernel_roll_2_out {
    double lift_2, tx_2, ty_2, tz_2, vx_3, vy_3, vz_3, nx_3, ny_3, nz_3, turn_rate_3;
};

static __device__ __forceinline__ kernel_roll_2_out kernel_roll_2(double p_gravity, double p_inertia, double nx_0, double nx_1, double nx_2, double ny_0, double ny_1, double ny_2, double nz_0, double nz_1, double nz_2, double vx_0, double vx_1, double vx_2, double vy_0, double vy_1, double vy_2, double vz_0, double vz_1, double vz_2, double bent_x, double bent_y, double bent_z, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double lift_0, double lift_1, double tx_0, double tx_1, double ty_0, double ty_1, double tz_0, double tz_1)
{
    const double _s0 = 1.0 / (1.0 + p_inertia);
    const double _s1 = 2.0 * nx_2;
    const double _s2 = (vx_2 * bent_x) * per_reach;
    const double _s3 = 2.0 * ny_2;
    const double _s4 = (vy_2 * bent_y) * per_reach;
    const double _s5 = (vz_2 * bent_z) * per_reach;
    const double _s6 = ((p_gravity * nz_2) * _s0) - (((((nx_1 * vx_2) + (_s1 * vx_1)) + (vx_0 * _s2)) + (((ny_1 * vy_2) + (_s3 * vy_1)) + (vy_0 * _s4))) + (((nz_1 * vz_2) + ((2.0 * nz_2) * vz_1)) + (vz_0 * _s5)));
    const double _s7 = (((ny_0 * _s5) + ((2.0 * ny_1) * nz_2)) + (ny_2 * nz_1)) - (((ny_1 * nz_2) + (_s3 * nz_1)) + (nz_0 * _s4));
    const double _s8 = 2.0 * nx_1;
    const double _s9 = (((nx_1 * nz_2) + (_s1 * nz_1)) + (nz_0 * _s2)) - (((nx_0 * _s5) + (_s8 * nz_2)) + (nx_2 * nz_1));
    const double _s10 = (((nx_0 * _s4) + (_s8 * ny_2)) + (nx_2 * ny_1)) - (((nx_1 * ny_2) + (_s1 * ny_1)) + (ny_0 * _s2));
    const double _s11 = p_inertia * _s0;
    const double _s12 = 0.3333333333333333 * ((_s11 * (((turn_rate_0 * _s7) + (turn_rate_1 * tx_1)) + (turn_rate_2 * tx_0))) + (((nx_0 * _s6) + (nx_1 * lift_1)) + (nx_2 * lift_0)));
    const double _s13 = 0.3333333333333333 * ((_s11 * (((turn_rate_0 * _s9) + (turn_rate_1 * ty_1)) + (turn_rate_2 * ty_0))) + (((ny_0 * _s6) + (ny_1 * lift_1)) + (ny_2 * lift_0)));
    const double _s14 = 0.3333333333333333 * ((_s11 * (((turn_rate_0 * _s10) + (turn_rate_1 * tz_1)) + (turn_rate_2 * tz_0))) + (((nz_0 * _s6) + (nz_1 * lift_1)) + (nz_2 * lift_0)));
    const double _s15 = 0.3333333333333333 * (((((vx_0 * _s7) + (vx_1 * tx_1)) + (vx_2 * tx_0)) + (((vy_0 * _s9) + (vy_1 * ty_1)) + (vy_2 * ty_0))) + (((vz_0 * _s10) + (vz_1 * tz_1)) + (vz_2 * tz_0)));
    return {_s6, _s7, _s9, _s10, _s12, _s13, _s14, 0.3333333333333333 * _s2, 0.3333333333333333 * _s4, 0.3333333333333333 * _s5, -_s15};
}

/* Coefficients of order 4 of a rolling ball, from those of lower order.
   Newton, Euler and rolling without slip. 164 operations: 62 additions, 4 subtractions, 96 multiplications, 1 division, 1 negation. */
struct kernel_roll_3_out {
    double lift_3, tx_3, ty_3, tz_3, vx_4, vy_4, vz_4, nx_4, ny_4, nz_4, turn_rate_4;
};

static __device__ __forceinline__ kernel_roll_3_out kernel_roll_3(double p_gravity, double p_inertia, double nx_0, double nx_1, double nx_2, double nx_3, double ny_0, double ny_1, double ny_2, double ny_3, double nz_0, double nz_1, double nz_2, double nz_3, double vx_0, double vx_1, double vx_2, double vx_3, double vy_0, double vy_1, double vy_2, double vy_3, double vz_0, double vz_1, double vz_2, double vz_3, double bent_x, double bent_y, double bent_z, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double lift_0, double lift_1, double lift_2, double tx_0, double tx_1, double tx_2, double ty_0, double ty_1, double ty_2, double tz_0, double tz_1, double tz_2)
{
    const double _s0 = 1.0 / (1.0 + p_inertia);
    const double _s1 = 2.0 * nx_2;
    const double _s2 = 3.0 * nx_3;
    const double _s3 = (vx_3 * bent_x) * per_reach;
    const double _s4 = 2.0 * ny_2;
    const double _s5 = 3.0 * ny_3;
    const double _s6 = (vy_3 * bent_y) * per_reach;
    const double _s7 = (vz_3 * bent_z) * per_reach;
    const double _s8 = (((((nx_1 * vx_3) + (_s1 * vx_2)) + (_s2 * vx_1)) + (vx_0 * _s3)) + ((((ny_1 * vy_3) + (_s4 * vy_2)) + (_s5 * vy_1)) + (vy_0 * _s6))) + ((((nz_1 * vz_3) + ((2.0 * nz_2) * vz_2)) + ((3.0 * nz_3) * vz_1)) + (vz_0 * _s7));
    const double _s9 = ((p_gravity * nz_3) * _s0) - _s8;
    const double _s10 = _s4 * nz_2;
    const double _s11 = ((((ny_0 * _s7) + ((3.0 * ny_1) * nz_3)) + _s10) + (ny_3 * nz_1)) - ((((ny_1 * nz_3) + _s10) + (_s5 * nz_1)) + (nz_0 * _s6));
    const double _s12 = _s1 * nz_2;
    const double _s13 = 3.0 * nx_1;
    const double _s14 = ((((nx_1 * nz_3) + _s12) + (_s2 * nz_1)) + (nz_0 * _s3)) - ((((nx_0 * _s7) + (_s13 * nz_3)) + _s12) + (nx_3 * nz_1));
    const double _s15 = _s1 * ny_2;
    const double _s16 = ((((nx_0 * _s6) + (_s13 * ny_3)) + _s15) + (nx_3 * ny_1)) - ((((nx_1 * ny_3) + _s15) + (_s2 * ny_1)) + (ny_0 * _s3));
    const double _s17 = p_inertia * _s0;
    const double _s18 = (_s17 * ((((turn_rate_0 * _s11) + (turn_rate_1 * tx_2)) + (turn_rate_2 * tx_1)) + (turn_rate_3 * tx_0))) + ((((nx_0 * _s9) + (nx_1 * lift_2)) + (nx_2 * lift_1)) + (nx_3 * lift_0));
    const double _s19 = (_s17 * ((((turn_rate_0 * _s14) + (turn_rate_1 * ty_2)) + (turn_rate_2 * ty_1)) + (turn_rate_3 * ty_0))) + ((((ny_0 * _s9) + (ny_1 * lift_2)) + (ny_2 * lift_1)) + (ny_3 * lift_0));
    const double _s20 = (_s17 * ((((turn_rate_0 * _s16) + (turn_rate_1 * tz_2)) + (turn_rate_2 * tz_1)) + (turn_rate_3 * tz_0))) + ((((nz_0 * _s9) + (nz_1 * lift_2)) + (nz_2 * lift_1)) + (nz_3 * lift_0));
    const double _s21 = (((((vx_0 * _s11) + (vx_1 * tx_2)) + (vx_2 * tx_1)) + (vx_3 * tx_0)) + ((((vy_0 * _s14) + (vy_1 * ty_2)) + (vy_2 * ty_1)) + (vy_3 * ty_0))) + ((((vz_0 * _s16) + (vz_1 * tz_2)) + (vz_2 * tz_1)) + (vz_3 * tz_0));
    return {_s9, _s11, _s14, _s16, 0.25 * _s18, 0.25 * _s19, 0.25 * _s20, 0.25 * _s3, 0.25 * _s6, 0.25 * _s7, -(0.25 * _s21)};
}

/* Coefficients of order 5 of a rolling ball, from those of lower order.
   Newton, Euler and rolling without slip. 210 operations: 80 additions, 4 subtractions, 124 multiplications, 1 division, 1 negation. */
struct kernel_roll_4_out {
    double lift_4, tx_4, ty_4, tz_4, vx_5, vy_5, vz_5, nx_5, ny_5, nz_5, turn_rate_5;
};

static __device__ __forceinline__ kernel_roll_4_out kernel_roll_4(double p_gravity, double p_inertia, double nx_0, double nx_1, double nx_2, double nx_3, double nx_4, double ny_0, double ny_1, double ny_2, double ny_3, double ny_4, double nz_0, double nz_1, double nz_2, double nz_3, double nz_4, double vx_0, double vx_1, double vx_2, double vx_3, double vx_4, double vy_0, double vy_1, double vy_2, double vy_3, double vy_4, double vz_0, double vz_1, double vz_2, double vz_3, double vz_4, double bent_x, double bent_y, double bent_z, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double turn_rate_4, double lift_0, double lift_1, double lift_2, double lift_3, double tx_0, double tx_1, double tx_2, double tx_3, double ty_0, double ty_1, double ty_2, double ty_3, double tz_0, double tz_1, double tz_2, double tz_3)
{
    const double _s0 = 1.0 / (1.0 + p_inertia);
    const double _s1 = 2.0 * nx_2;
    const double _s2 = 3.0 * nx_3;
    const double _s3 = 4.0 * nx_4;
    const double _s4 = (vx_4 * bent_x) * per_reach;
    const double _s5 = 2.0 * ny_2;
    const double _s6 = 3.0 * ny_3;
    const double _s7 = 4.0 * ny_4;
    const double _s8 = (vy_4 * bent_y) * per_reach;
    const double _s9 = (((((nx_1 * vx_4) + (_s1 * vx_3)) + (_s2 * vx_2)) + (_s3 * vx_1)) + (vx_0 * _s4)) + (((((ny_1 * vy_4) + (_s5 * vy_3)) + (_s6 * vy_2)) + (_s7 * vy_1)) + (vy_0 * _s8));
    const double _s10 = (vz_4 * bent_z) * per_reach;
    const double _s11 = ((((nz_1 * vz_4) + ((2.0 * nz_2) * vz_3)) + ((3.0 * nz_3) * vz_2)) + ((4.0 * nz_4) * vz_1)) + (vz_0 * _s10);
    const double _s12 = ((p_gravity * nz_4) * _s0) - (_s9 + _s11);
    const double _s13 = ((((ny_0 * _s10) + ((4.0 * ny_1) * nz_4)) + ((3.0 * ny_2) * nz_3)) + ((2.0 * ny_3) * nz_2)) + (ny_4 * nz_1);
    const double _s14 = _s13 - (((((ny_1 * nz_4) + (_s5 * nz_3)) + (_s6 * nz_2)) + (_s7 * nz_1)) + (nz_0 * _s8));
    const double _s15 = 4.0 * nx_1;
    const double _s16 = 3.0 * nx_2;
    const double _s17 = 2.0 * nx_3;
    const double _s18 = (((((nx_1 * nz_4) + (_s1 * nz_3)) + (_s2 * nz_2)) + (_s3 * nz_1)) + (nz_0 * _s4)) - (((((nx_0 * _s10) + (_s15 * nz_4)) + (_s16 * nz_3)) + (_s17 * nz_2)) + (nx_4 * nz_1));
    const double _s19 = (((((nx_0 * _s8) + (_s15 * ny_4)) + (_s16 * ny_3)) + (_s17 * ny_2)) + (nx_4 * ny_1)) - (((((nx_1 * ny_4) + (_s1 * ny_3)) + (_s2 * ny_2)) + (_s3 * ny_1)) + (ny_0 * _s4));
    const double _s20 = p_inertia * _s0;
    const double _s21 = _s20 * (((((turn_rate_0 * _s14) + (turn_rate_1 * tx_3)) + (turn_rate_2 * tx_2)) + (turn_rate_3 * tx_1)) + (turn_rate_4 * tx_0));
    const double _s22 = _s21 + (((((nx_0 * _s12) + (nx_1 * lift_3)) + (nx_2 * lift_2)) + (nx_3 * lift_1)) + (nx_4 * lift_0));
    const double _s23 = _s20 * (((((turn_rate_0 * _s18) + (turn_rate_1 * ty_3)) + (turn_rate_2 * ty_2)) + (turn_rate_3 * ty_1)) + (turn_rate_4 * ty_0));
    const double _s24 = _s23 + (((((ny_0 * _s12) + (ny_1 * lift_3)) + (ny_2 * lift_2)) + (ny_3 * lift_1)) + (ny_4 * lift_0));
    const double _s25 = _s20 * (((((turn_rate_0 * _s19) + (turn_rate_1 * tz_3)) + (turn_rate_2 * tz_2)) + (turn_rate_3 * tz_1)) + (turn_rate_4 * tz_0));
    const double _s26 = _s25 + (((((nz_0 * _s12) + (nz_1 * lift_3)) + (nz_2 * lift_2)) + (nz_3 * lift_1)) + (nz_4 * lift_0));
    const double _s27 = (((((vx_0 * _s14) + (vx_1 * tx_3)) + (vx_2 * tx_2)) + (vx_3 * tx_1)) + (vx_4 * tx_0)) + (((((vy_0 * _s18) + (vy_1 * ty_3)) + (vy_2 * ty_2)) + (vy_3 * ty_1)) + (vy_4 * ty_0));
    const double _s28 = _s27 + (((((vz_0 * _s19) + (vz_1 * tz_3)) + (vz_2 * tz_2)) + (vz_3 * tz_1)) + (vz_4 * tz_0));
    return {_s12, _s14, _s18, _s19, 0.2 * _s22, 0.2 * _s24, 0.2 * _s26, 0.2 * _s4, 0.2 * _s8, 0.2 * _s10, -(0.2 * _s28)};
}

/* Coefficients of order 6 of a rolling ball, from those of lower order.
   Newton, Euler and rolling without slip. 246 operations: 98 additions, 4 subtractions, 142 multiplications, 1 division, 1 negation. */
struct kernel_roll_5_out {
    double lift_5, tx_5, ty_5, tz_5, vx_6, vy_6, vz_6, nx_6, ny_6, nz_6, turn_rate_6;
};

static __device__ __forceinline__ kernel_roll_5_out kernel_roll_5(double p_gravity, double p_inertia, double nx_0, double nx_1, double nx_2, double nx_3, double nx_4, double nx_5, double ny_0, double ny_1, double ny_2, double ny_3, double ny_4, double ny_5, double nz_0, double nz_1, double nz_2, double nz_3, double nz_4, double nz_5, double vx_0, double vx_1, double vx_2, double vx_3, double vx_4, double vx_5, double vy_0, double vy_1, double vy_2, double vy_3, double vy_4, double vy_5, double vz_0, double vz_1, double vz_2, double vz_3, double vz_4, double vz_5, double bent_x, double bent_y, double bent_z, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double turn_rate_4, double turn_rate_5, double lift_0, double lift_1, double lift_2, double lift_3, double lift_4, double tx_0, double tx_1, double tx_2, double tx_3, double tx_4, double ty_0, double ty_1, double ty_2, double ty_3, double ty_4, double tz_0, double tz_1, double tz_2, double tz_3, double tz_4)
{
    const double _s0 = 1.0 / (1.0 + p_inertia);
    const double _s1 = 2.0 * nx_2;
    const double _s2 = 3.0 * nx_3;
    const double _s3 = 4.0 * nx_4;
    const double _s4 = 5.0 * nx_5;
    const double _s5 = (vx_5 * bent_x) * per_reach;
    const double _s6 = (((((nx_1 * vx_5) + (_s1 * vx_4)) + (_s2 * vx_3)) + (_s3 * vx_2)) + (_s4 * vx_1)) + (vx_0 * _s5);
    const double _s7 = 2.0 * ny_2;
    const double _s8 = 3.0 * ny_3;
    const double _s9 = 4.0 * ny_4;
    const double _s10 = 5.0 * ny_5;
    const double _s11 = (vy_5 * bent_y) * per_reach;
    const double _s12 = (((((ny_1 * vy_5) + (_s7 * vy_4)) + (_s8 * vy_3)) + (_s9 * vy_2)) + (_s10 * vy_1)) + (vy_0 * _s11);
    const double _s13 = ((((nz_1 * vz_5) + ((2.0 * nz_2) * vz_4)) + ((3.0 * nz_3) * vz_3)) + ((4.0 * nz_4) * vz_2)) + ((5.0 * nz_5) * vz_1);
    const double _s14 = (vz_5 * bent_z) * per_reach;
    const double _s15 = ((p_gravity * nz_5) * _s0) - ((_s6 + _s12) + (_s13 + (vz_0 * _s14)));
    const double _s16 = _s8 * nz_3;
    const double _s17 = ((((ny_0 * _s14) + ((5.0 * ny_1) * nz_5)) + ((4.0 * ny_2) * nz_4)) + _s16) + ((2.0 * ny_4) * nz_2);
    const double _s18 = (((((ny_1 * nz_5) + (_s7 * nz_4)) + _s16) + (_s9 * nz_2)) + (_s10 * nz_1)) + (nz_0 * _s11);
    const double _s19 = (_s17 + (ny_5 * nz_1)) - _s18;
    const double _s20 = _s2 * nz_3;
    const double _s21 = (((((nx_1 * nz_5) + (_s1 * nz_4)) + _s20) + (_s3 * nz_2)) + (_s4 * nz_1)) + (nz_0 * _s5);
    const double _s22 = 5.0 * nx_1;
    const double _s23 = 4.0 * nx_2;
    const double _s24 = 2.0 * nx_4;
    const double _s25 = (((((nx_0 * _s14) + (_s22 * nz_5)) + (_s23 * nz_4)) + _s20) + (_s24 * nz_2)) + (nx_5 * nz_1);
    const double _s26 = _s21 - _s25;
    const double _s27 = _s2 * ny_3;
    const double _s28 = (((((nx_0 * _s11) + (_s22 * ny_5)) + (_s23 * ny_4)) + _s27) + (_s24 * ny_2)) + (nx_5 * ny_1);
    const double _s29 = (((((nx_1 * ny_5) + (_s1 * ny_4)) + _s27) + (_s3 * ny_2)) + (_s4 * ny_1)) + (ny_0 * _s5);
    const double _s30 = _s28 - _s29;
    const double _s31 = p_inertia * _s0;
    const double _s32 = (((((turn_rate_0 * _s19) + (turn_rate_1 * tx_4)) + (turn_rate_2 * tx_3)) + (turn_rate_3 * tx_2)) + (turn_rate_4 * tx_1)) + (turn_rate_5 * tx_0);
    const double _s33 = (((((nx_0 * _s15) + (nx_1 * lift_4)) + (nx_2 * lift_3)) + (nx_3 * lift_2)) + (nx_4 * lift_1)) + (nx_5 * lift_0);
    const double _s34 = (((((turn_rate_0 * _s26) + (turn_rate_1 * ty_4)) + (turn_rate_2 * ty_3)) + (turn_rate_3 * ty_2)) + (turn_rate_4 * ty_1)) + (turn_rate_5 * ty_0);
    const double _s35 = (((((ny_0 * _s15) + (ny_1 * lift_4)) + (ny_2 * lift_3)) + (ny_3 * lift_2)) + (ny_4 * lift_1)) + (ny_5 * lift_0);
    const double _s36 = (((((turn_rate_0 * _s30) + (turn_rate_1 * tz_4)) + (turn_rate_2 * tz_3)) + (turn_rate_3 * tz_2)) + (turn_rate_4 * tz_1)) + (turn_rate_5 * tz_0);
    const double _s37 = (((((nz_0 * _s15) + (nz_1 * lift_4)) + (nz_2 * lift_3)) + (nz_3 * lift_2)) + (nz_4 * lift_1)) + (nz_5 * lift_0);
    const double _s38 = (((((vx_0 * _s19) + (vx_1 * tx_4)) + (vx_2 * tx_3)) + (vx_3 * tx_2)) + (vx_4 * tx_1)) + (vx_5 * tx_0);
    const double _s39 = (((((vy_0 * _s26) + (vy_1 * ty_4)) + (vy_2 * ty_3)) + (vy_3 * ty_2)) + (vy_4 * ty_1)) + (vy_5 * ty_0);
    const double _s40 = (((((vz_0 * _s30) + (vz_1 * tz_4)) + (vz_2 * tz_3)) + (vz_3 * tz_2)) + (vz_4 * tz_1)) + (vz_5 * tz_0);
    return {_s15, _s19, _s26, _s30, 0.16666666666666666 * ((_s31 * _s32) + _s33), 0.16666666666666666 * ((_s31 * _s34) + _s35), 0.16666666666666666 * ((_s31 * _s36) + _s37), 0.16666666666666666 * _s5, 0.16666666666666666 * _s11, 0.16666666666666666 * _s14, -(0.16666666666666666 * ((_s38 + _s39) + _s40))};
}

/* Coefficients of order 7 of a rolling ball, from those of lower order.
   Newton, Euler and rolling without slip. 292 operations: 116 additions, 4 subtractions, 170 multiplications, 1 division, 1 negation. */
struct kernel_roll_6_out {
    double lift_6, tx_6, ty_6, tz_6, vx_7, vy_7, vz_7, nx_7, ny_7, nz_7, turn_rate_7;
};

static __device__ __forceinline__ kernel_roll_6_out kernel_roll_6(double p_gravity, double p_inertia, double nx_0, double nx_1, double nx_2, double nx_3, double nx_4, double nx_5, double nx_6, double ny_0, double ny_1, double ny_2, double ny_3, double ny_4, double ny_5, double ny_6, double nz_0, double nz_1, double nz_2, double nz_3, double nz_4, double nz_5, double nz_6, double vx_0, double vx_1, double vx_2, double vx_3, double vx_4, double vx_5, double vx_6, double vy_0, double vy_1, double vy_2, double vy_3, double vy_4, double vy_5, double vy_6, double vz_0, double vz_1, double vz_2, double vz_3, double vz_4, double vz_5, double vz_6, double bent_x, double bent_y, double bent_z, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double turn_rate_4, double turn_rate_5, double turn_rate_6, double lift_0, double lift_1, double lift_2, double lift_3, double lift_4, double lift_5, double tx_0, double tx_1, double tx_2, double tx_3, double tx_4, double tx_5, double ty_0, double ty_1, double ty_2, double ty_3, double ty_4, double ty_5, double tz_0, double tz_1, double tz_2, double tz_3, double tz_4, double tz_5)
{
    const double _s0 = 1.0 / (1.0 + p_inertia);
    const double _s1 = 2.0 * nx_2;
    const double _s2 = 3.0 * nx_3;
    const double _s3 = 4.0 * nx_4;
    const double _s4 = 5.0 * nx_5;
    const double _s5 = 6.0 * nx_6;
    const double _s6 = (((((nx_1 * vx_6) + (_s1 * vx_5)) + (_s2 * vx_4)) + (_s3 * vx_3)) + (_s4 * vx_2)) + (_s5 * vx_1);
    const double _s7 = (vx_6 * bent_x) * per_reach;
    const double _s8 = 2.0 * ny_2;
    const double _s9 = 3.0 * ny_3;
    const double _s10 = 4.0 * ny_4;
    const double _s11 = 5.0 * ny_5;
    const double _s12 = 6.0 * ny_6;
    const double _s13 = (((((ny_1 * vy_6) + (_s8 * vy_5)) + (_s9 * vy_4)) + (_s10 * vy_3)) + (_s11 * vy_2)) + (_s12 * vy_1);
    const double _s14 = (vy_6 * bent_y) * per_reach;
    const double _s15 = ((((nz_1 * vz_6) + ((2.0 * nz_2) * vz_5)) + ((3.0 * nz_3) * vz_4)) + ((4.0 * nz_4) * vz_3)) + ((5.0 * nz_5) * vz_2);
    const double _s16 = (vz_6 * bent_z) * per_reach;
    const double _s17 = ((p_gravity * nz_6) * _s0) - (((_s6 + (vx_0 * _s7)) + (_s13 + (vy_0 * _s14))) + ((_s15 + ((6.0 * nz_6) * vz_1)) + (vz_0 * _s16)));
    const double _s18 = ((((ny_0 * _s16) + ((6.0 * ny_1) * nz_6)) + ((5.0 * ny_2) * nz_5)) + ((4.0 * ny_3) * nz_4)) + ((3.0 * ny_4) * nz_3);
    const double _s19 = (((((ny_1 * nz_6) + (_s8 * nz_5)) + (_s9 * nz_4)) + (_s10 * nz_3)) + (_s11 * nz_2)) + (_s12 * nz_1);
    const double _s20 = ((_s18 + ((2.0 * ny_5) * nz_2)) + (ny_6 * nz_1)) - (_s19 + (nz_0 * _s14));
    const double _s21 = (((((nx_1 * nz_6) + (_s1 * nz_5)) + (_s2 * nz_4)) + (_s3 * nz_3)) + (_s4 * nz_2)) + (_s5 * nz_1);
    const double _s22 = 6.0 * nx_1;
    const double _s23 = 5.0 * nx_2;
    const double _s24 = 4.0 * nx_3;
    const double _s25 = 3.0 * nx_4;
    const double _s26 = 2.0 * nx_5;
    const double _s27 = (((((nx_0 * _s16) + (_s22 * nz_6)) + (_s23 * nz_5)) + (_s24 * nz_4)) + (_s25 * nz_3)) + (_s26 * nz_2);
    const double _s28 = (_s21 + (nz_0 * _s7)) - (_s27 + (nx_6 * nz_1));
    const double _s29 = (((((nx_0 * _s14) + (_s22 * ny_6)) + (_s23 * ny_5)) + (_s24 * ny_4)) + (_s25 * ny_3)) + (_s26 * ny_2);
    const double _s30 = (((((nx_1 * ny_6) + (_s1 * ny_5)) + (_s2 * ny_4)) + (_s3 * ny_3)) + (_s4 * ny_2)) + (_s5 * ny_1);
    const double _s31 = (_s29 + (nx_6 * ny_1)) - (_s30 + (ny_0 * _s7));
    const double _s32 = p_inertia * _s0;
    const double _s33 = (((((turn_rate_0 * _s20) + (turn_rate_1 * tx_5)) + (turn_rate_2 * tx_4)) + (turn_rate_3 * tx_3)) + (turn_rate_4 * tx_2)) + (turn_rate_5 * tx_1);
    const double _s34 = (((((nx_0 * _s17) + (nx_1 * lift_5)) + (nx_2 * lift_4)) + (nx_3 * lift_3)) + (nx_4 * lift_2)) + (nx_5 * lift_1);
    const double _s35 = (((((turn_rate_0 * _s28) + (turn_rate_1 * ty_5)) + (turn_rate_2 * ty_4)) + (turn_rate_3 * ty_3)) + (turn_rate_4 * ty_2)) + (turn_rate_5 * ty_1);
    const double _s36 = (((((ny_0 * _s17) + (ny_1 * lift_5)) + (ny_2 * lift_4)) + (ny_3 * lift_3)) + (ny_4 * lift_2)) + (ny_5 * lift_1);
    const double _s37 = (((((turn_rate_0 * _s31) + (turn_rate_1 * tz_5)) + (turn_rate_2 * tz_4)) + (turn_rate_3 * tz_3)) + (turn_rate_4 * tz_2)) + (turn_rate_5 * tz_1);
    const double _s38 = (((((nz_0 * _s17) + (nz_1 * lift_5)) + (nz_2 * lift_4)) + (nz_3 * lift_3)) + (nz_4 * lift_2)) + (nz_5 * lift_1);
    const double _s39 = (((((vx_0 * _s20) + (vx_1 * tx_5)) + (vx_2 * tx_4)) + (vx_3 * tx_3)) + (vx_4 * tx_2)) + (vx_5 * tx_1);
    const double _s40 = (((((vy_0 * _s28) + (vy_1 * ty_5)) + (vy_2 * ty_4)) + (vy_3 * ty_3)) + (vy_4 * ty_2)) + (vy_5 * ty_1);
    const double _s41 = (((((vz_0 * _s31) + (vz_1 * tz_5)) + (vz_2 * tz_4)) + (vz_3 * tz_3)) + (vz_4 * tz_2)) + (vz_5 * tz_1);
    const double _s42 = -(0.14285714285714285 * (((_s39 + (vx_6 * tx_0)) + (_s40 + (vy_6 * ty_0))) + (_s41 + (vz_6 * tz_0))));
    return {_s17, _s20, _s28, _s31, 0.14285714285714285 * ((_s32 * (_s33 + (turn_rate_6 * tx_0))) + (_s34 + (nx_6 * lift_0))), 0.14285714285714285 * ((_s32 * (_s35 + (turn_rate_6 * ty_0))) + (_s36 + (ny_6 * lift_0))), 0.14285714285714285 * ((_s32 * (_s37 + (turn_rate_6 * tz_0))) + (_s38 + (nz_6 * lift_0))), 0.14285714285714285 * _s7, 0.14285714285714285 * _s14, 0.14285714285714285 * _s16, _s42};
}

/* Coefficients of order 8 of a rolling ball, from those of lower order.
   Newton, Euler and rolling without slip. 328 operations: 134 additions, 4 subtractions, 188 multiplications, 1 division, 1 negation. */
struct kernel_roll_7_out {
    double lift_7, tx_7, ty_7, tz_7, vx_8, vy_8, vz_8, nx_8, ny_8, nz_8, turn_rate_8;
};

static __device__ __forceinline__ kernel_roll_7_out kernel_roll_7(double p_gravity, double p_inertia, double nx_0, double nx_1, double nx_2, double nx_3, double nx_4, double nx_5, double nx_6, double nx_7, double ny_0, double ny_1, double ny_2, double ny_3, double ny_4, double ny_5, double ny_6, double ny_7, double nz_0, double nz_1, double nz_2, double nz_3, double nz_4, double nz_5, double nz_6, double nz_7, double vx_0, double vx_1, double vx_2, double vx_3, double vx_4, double vx_5, double vx_6, double vx_7, double vy_0, double vy_1, double vy_2, double vy_3, double vy_4, double vy_5, double vy_6, double vy_7, double vz_0, double vz_1, double vz_2, double vz_3, double vz_4, double vz_5, double vz_6, double vz_7, double bent_x, double bent_y, double bent_z, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double turn_rate_4, double turn_rate_5, double turn_rate_6, double turn_rate_7, double lift_0, double lift_1, double lift_2, double lift_3, double lift_4, double lift_5, double lift_6, double tx_0, double tx_1, double tx_2, double tx_3, double tx_4, double tx_5, double tx_6, double ty_0, double ty_1, double ty_2, double ty_3, double ty_4, double ty_5, double ty_6, double tz_0, double tz_1, double tz_2, double tz_3, double tz_4, double tz_5, double tz_6)
{
    const double _s0 = 1.0 / (1.0 + p_inertia);
    const double _s1 = 2.0 * nx_2;
    const double _s2 = 3.0 * nx_3;
    const double _s3 = 4.0 * nx_4;
    const double _s4 = 5.0 * nx_5;
    const double _s5 = 6.0 * nx_6;
    const double _s6 = (((((nx_1 * vx_7) + (_s1 * vx_6)) + (_s2 * vx_5)) + (_s3 * vx_4)) + (_s4 * vx_3)) + (_s5 * vx_2);
    const double _s7 = 7.0 * nx_7;
    const double _s8 = (vx_7 * bent_x) * per_reach;
    const double _s9 = 2.0 * ny_2;
    const double _s10 = 3.0 * ny_3;
    const double _s11 = 4.0 * ny_4;
    const double _s12 = 5.0 * ny_5;
    const double _s13 = 6.0 * ny_6;
    const double _s14 = (((((ny_1 * vy_7) + (_s9 * vy_6)) + (_s10 * vy_5)) + (_s11 * vy_4)) + (_s12 * vy_3)) + (_s13 * vy_2);
    const double _s15 = 7.0 * ny_7;
    const double _s16 = (vy_7 * bent_y) * per_reach;
    const double _s17 = ((((nz_1 * vz_7) + ((2.0 * nz_2) * vz_6)) + ((3.0 * nz_3) * vz_5)) + ((4.0 * nz_4) * vz_4)) + ((5.0 * nz_5) * vz_3);
    const double _s18 = (vz_7 * bent_z) * per_reach;
    const double _s19 = (((_s6 + (_s7 * vx_1)) + (vx_0 * _s8)) + ((_s14 + (_s15 * vy_1)) + (vy_0 * _s16))) + (((_s17 + ((6.0 * nz_6) * vz_2)) + ((7.0 * nz_7) * vz_1)) + (vz_0 * _s18));
    const double _s20 = ((p_gravity * nz_7) * _s0) - _s19;
    const double _s21 = _s11 * nz_4;
    const double _s22 = ((((ny_0 * _s18) + ((7.0 * ny_1) * nz_7)) + ((6.0 * ny_2) * nz_6)) + ((5.0 * ny_3) * nz_5)) + _s21;
    const double _s23 = (((((ny_1 * nz_7) + (_s9 * nz_6)) + (_s10 * nz_5)) + _s21) + (_s12 * nz_3)) + (_s13 * nz_2);
    const double _s24 = (((_s22 + ((3.0 * ny_5) * nz_3)) + ((2.0 * ny_6) * nz_2)) + (ny_7 * nz_1)) - ((_s23 + (_s15 * nz_1)) + (nz_0 * _s16));
    const double _s25 = _s3 * nz_4;
    const double _s26 = (((((nx_1 * nz_7) + (_s1 * nz_6)) + (_s2 * nz_5)) + _s25) + (_s4 * nz_3)) + (_s5 * nz_2);
    const double _s27 = 7.0 * nx_1;
    const double _s28 = 6.0 * nx_2;
    const double _s29 = 5.0 * nx_3;
    const double _s30 = 3.0 * nx_5;
    const double _s31 = (((((nx_0 * _s18) + (_s27 * nz_7)) + (_s28 * nz_6)) + (_s29 * nz_5)) + _s25) + (_s30 * nz_3);
    const double _s32 = 2.0 * nx_6;
    const double _s33 = ((_s26 + (_s7 * nz_1)) + (nz_0 * _s8)) - ((_s31 + (_s32 * nz_2)) + (nx_7 * nz_1));
    const double _s34 = _s3 * ny_4;
    const double _s35 = (((((nx_0 * _s16) + (_s27 * ny_7)) + (_s28 * ny_6)) + (_s29 * ny_5)) + _s34) + (_s30 * ny_3);
    const double _s36 = (((((nx_1 * ny_7) + (_s1 * ny_6)) + (_s2 * ny_5)) + _s34) + (_s4 * ny_3)) + (_s5 * ny_2);
    const double _s37 = ((_s35 + (_s32 * ny_2)) + (nx_7 * ny_1)) - ((_s36 + (_s7 * ny_1)) + (ny_0 * _s8));
    const double _s38 = p_inertia * _s0;
    const double _s39 = (((((turn_rate_0 * _s24) + (turn_rate_1 * tx_6)) + (turn_rate_2 * tx_5)) + (turn_rate_3 * tx_4)) + (turn_rate_4 * tx_3)) + (turn_rate_5 * tx_2);
    const double _s40 = (((((nx_0 * _s20) + (nx_1 * lift_6)) + (nx_2 * lift_5)) + (nx_3 * lift_4)) + (nx_4 * lift_3)) + (nx_5 * lift_2);
    const double _s41 = 0.125 * ((_s38 * ((_s39 + (turn_rate_6 * tx_1)) + (turn_rate_7 * tx_0))) + ((_s40 + (nx_6 * lift_1)) + (nx_7 * lift_0)));
    const double _s42 = (((((turn_rate_0 * _s33) + (turn_rate_1 * ty_6)) + (turn_rate_2 * ty_5)) + (turn_rate_3 * ty_4)) + (turn_rate_4 * ty_3)) + (turn_rate_5 * ty_2);
    const double _s43 = (((((ny_0 * _s20) + (ny_1 * lift_6)) + (ny_2 * lift_5)) + (ny_3 * lift_4)) + (ny_4 * lift_3)) + (ny_5 * lift_2);
    const double _s44 = 0.125 * ((_s38 * ((_s42 + (turn_rate_6 * ty_1)) + (turn_rate_7 * ty_0))) + ((_s43 + (ny_6 * lift_1)) + (ny_7 * lift_0)));
    const double _s45 = (((((turn_rate_0 * _s37) + (turn_rate_1 * tz_6)) + (turn_rate_2 * tz_5)) + (turn_rate_3 * tz_4)) + (turn_rate_4 * tz_3)) + (turn_rate_5 * tz_2);
    const double _s46 = (((((nz_0 * _s20) + (nz_1 * lift_6)) + (nz_2 * lift_5)) + (nz_3 * lift_4)) + (nz_4 * lift_3)) + (nz_5 * lift_2);
    const double _s47 = 0.125 * ((_s38 * ((_s45 + (turn_rate_6 * tz_1)) + (turn_rate_7 * tz_0))) + ((_s46 + (nz_6 * lift_1)) + (nz_7 * lift_0)));
    const double _s48 = (((((vx_0 * _s24) + (vx_1 * tx_6)) + (vx_2 * tx_5)) + (vx_3 * tx_4)) + (vx_4 * tx_3)) + (vx_5 * tx_2);
    const double _s49 = (((((vy_0 * _s33) + (vy_1 * ty_6)) + (vy_2 * ty_5)) + (vy_3 * ty_4)) + (vy_4 * ty_3)) + (vy_5 * ty_2);
    const double _s50 = (((((vz_0 * _s37) + (vz_1 * tz_6)) + (vz_2 * tz_5)) + (vz_3 * tz_4)) + (vz_4 * tz_3)) + (vz_5 * tz_2);
    const double _s51 = 0.125 * ((((_s48 + (vx_6 * tx_1)) + (vx_7 * tx_0)) + ((_s49 + (vy_6 * ty_1)) + (vy_7 * ty_0))) + ((_s50 + (vz_6 * tz_1)) + (vz_7 * tz_0)));
    return {_s20, _s24, _s33, _s37, _s41, _s44, _s47, 0.125 * _s8, 0.125 * _s16, 0.125 * _s18, -_s51};
}

/* Start value of the normal where the flight began: another surface.
   Table 1. No operations. */
struct kernel_other_start_surface_out {
    double left_nx, left_ny, left_nz;
};

static __device__ __forceinline__ kernel_other_start_surface_out kernel_other_start_surface()
{
    return {0.0, 0.0, 0.0};
}

/* Position at the start of a flight.
   Eq. 3. 9 operations: 1 addition, 3 subtractions, 5 multiplications. */
struct kernel_started_out {
    double from_x, from_y, from_z;
};

static __device__ __forceinline__ kernel_started_out kernel_started(double p_gravity, double x, double y, double z, double vx, double vy, double vz, double t)
{
    return {x - (vx * t), y - (vy * t), z - (t * (vz + ((0.5 * p_gravity) * t)))};
}

/* Constant terms of the series.
   rolling. 6 operations: 2 additions, 4 multiplications. */
struct kernel_roll_start_out {
    double vx_0, vy_0, vz_0, nx_0, ny_0, nz_0, turn_rate_0;
};

static __device__ __forceinline__ kernel_roll_start_out kernel_roll_start(double p_ball_radius, double nx, double ny, double nz, double vx, double vy, double vz, double wx, double wy, double wz)
{
    return {vx, vy, vz, nx, ny, nz, p_ball_radius * (((nx * wx) + (ny * wy)) + (nz * wz))};
}

/* Position, velocity and turn rate of a rolling ball at time t.
   its series. 142 operations: 59 additions, 83 multiplications. */
struct kernel_roll_moved_out {
    double x, vx, y, vy, z, vz, turn_rate;
};

static __device__ __forceinline__ kernel_roll_moved_out kernel_roll_moved(double x, double y, double z, double vx_0, double vx_1, double vx_2, double vx_3, double vx_4, double vx_5, double vx_6, double vx_7, double vx_8, double vy_0, double vy_1, double vy_2, double vy_3, double vy_4, double vy_5, double vy_6, double vy_7, double vy_8, double vz_0, double vz_1, double vz_2, double vz_3, double vz_4, double vz_5, double vz_6, double vz_7, double vz_8, double t, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double turn_rate_4, double turn_rate_5, double turn_rate_6, double turn_rate_7, double turn_rate_8)
{
    const double _s0 = t * ((0.14285714285714285 * vx_6) + (t * ((0.125 * vx_7) + ((0.1111111111111111 * vx_8) * t))));
    const double _s1 = (0.25 * vx_3) + (t * ((0.2 * vx_4) + (t * ((0.16666666666666666 * vx_5) + _s0))));
    const double _s2 = vx_0 + (t * ((0.5 * vx_1) + (t * ((0.3333333333333333 * vx_2) + (t * _s1)))));
    const double _s3 = vx_5 + (t * (vx_6 + (t * (vx_7 + (vx_8 * t)))));
    const double _s4 = vx_2 + (t * (vx_3 + (t * (vx_4 + (t * _s3)))));
    const double _s5 = t * ((0.14285714285714285 * vy_6) + (t * ((0.125 * vy_7) + ((0.1111111111111111 * vy_8) * t))));
    const double _s6 = (0.25 * vy_3) + (t * ((0.2 * vy_4) + (t * ((0.16666666666666666 * vy_5) + _s5))));
    const double _s7 = vy_0 + (t * ((0.5 * vy_1) + (t * ((0.3333333333333333 * vy_2) + (t * _s6)))));
    const double _s8 = vy_5 + (t * (vy_6 + (t * (vy_7 + (vy_8 * t)))));
    const double _s9 = vy_2 + (t * (vy_3 + (t * (vy_4 + (t * _s8)))));
    const double _s10 = t * ((0.14285714285714285 * vz_6) + (t * ((0.125 * vz_7) + ((0.1111111111111111 * vz_8) * t))));
    const double _s11 = (0.25 * vz_3) + (t * ((0.2 * vz_4) + (t * ((0.16666666666666666 * vz_5) + _s10))));
    const double _s12 = vz_0 + (t * ((0.5 * vz_1) + (t * ((0.3333333333333333 * vz_2) + (t * _s11)))));
    const double _s13 = vz_5 + (t * (vz_6 + (t * (vz_7 + (vz_8 * t)))));
    const double _s14 = vz_2 + (t * (vz_3 + (t * (vz_4 + (t * _s13)))));
    const double _s15 = turn_rate_5 + (t * (turn_rate_6 + (t * (turn_rate_7 + (t * turn_rate_8)))));
    const double _s16 = turn_rate_2 + (t * (turn_rate_3 + (t * (turn_rate_4 + (t * _s15)))));
    return {x + (t * _s2), vx_0 + (t * (vx_1 + (t * _s4))), y + (t * _s7), vy_0 + (t * (vy_1 + (t * _s9))), z + (t * _s12), vz_0 + (t * (vz_1 + (t * _s14))), turn_rate_0 + (t * (turn_rate_1 + (t * _s16)))};
}

/* State of a ball put onto the surface, rolling.
   v = R_B (w × n). 36 operations: 5 additions, 9 subtractions, 21 multiplications, 1 division. */
struct kernel_roll_placed_out {
    double x, y, z, vx, vy, vz, wx, wy, wz;
};

static __device__ __forceinline__ kernel_roll_placed_out kernel_roll_placed(double p_ball_radius, double x, double y, double z, double nx, double ny, double nz, double vx, double vy, double vz, double gap, double turn_rate)
{
    const double _s0 = ((nx * vx) + (ny * vy)) + (nz * vz);
    const double _s1 = vx - (nx * _s0);
    const double _s2 = vy - (ny * _s0);
    const double _s3 = vz - (nz * _s0);
    const double _s4 = 1.0 / p_ball_radius;
    return {x - (nx * gap), y - (ny * gap), z - (nz * gap), _s1, _s2, _s3, _s4 * (((nx * turn_rate) + (ny * _s3)) - (nz * _s2)), _s4 * (((ny * turn_rate) + (nz * _s1)) - (nx * _s3)), _s4 * (((nx * _s2) + (nz * turn_rate)) - (ny * _s1))};
}

/* Length of a step of the series, bounds of the motion in it, and the normal force.
   the last terms of the series. 170 operations: 54 additions, 58 multiplications, 2 divisions, 4 square roots, 2 negations, 46 absolute values, 2 comparisons, 2 selections. */
struct kernel_roll_step_out {
    double stride, missed, strongest, fastest, force, force_rate, force_bend, friction_force_rate;
};

static __device__ __forceinline__ kernel_roll_step_out kernel_roll_step(double p_gravity, double p_inertia, double nx_8, double ny_8, double nz_0, double nz_1, double nz_2, double nz_3, double nz_4, double nz_5, double nz_6, double nz_7, double nz_8, double vx_0, double vx_1, double vx_2, double vx_3, double vx_4, double vx_5, double vx_6, double vx_7, double vx_8, double vy_0, double vy_1, double vy_2, double vy_3, double vy_4, double vy_5, double vy_6, double vy_7, double vy_8, double vz_0, double vz_1, double vz_2, double vz_3, double vz_4, double vz_5, double vz_6, double vz_7, double vz_8, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double turn_rate_4, double turn_rate_5, double turn_rate_6, double turn_rate_7, double turn_rate_8, double lift_0, double lift_1, double lift_2, double lift_3, double lift_4, double lift_5, double lift_6, double lift_7)
{
    const double _s0 = ((fabs(vx_0) + fabs(vy_0)) + fabs(vz_0)) + fabs(turn_rate_0);
    const double _s1 = (0.015625 * p_gravity) + _s0;
    const double _s2 = fabs(per_reach);
    const double _s3 = ((fabs(vx_7) + fabs(vy_7)) + fabs(vz_7)) + fabs(turn_rate_7);
    const double _s4 = ((fabs(vx_8) + fabs(vy_8)) + fabs(vz_8)) + fabs(turn_rate_8);
    const double _s5 = (((_s2 * _s0) + sqrt((p_gravity * _s2))) * _s3) + _s4;
    const double _s6 = _s1 * ((fabs(nx_8) + fabs(ny_8)) + fabs(nz_8));
    const double _s7 = sqrt(sqrt(sqrt(((1.4210854715202004e-14 * _s1) / larger(_s5, _s6)))));
    const double _s8 = smaller(_s7, 1.0);
    const double _s9 = (2.0 * (((fabs(vx_2) + fabs(vy_2)) + fabs(vz_2)) + fabs(turn_rate_2))) * _s8;
    const double _s10 = _s8 * _s8;
    const double _s11 = (3.0 * (((fabs(vx_3) + fabs(vy_3)) + fabs(vz_3)) + fabs(turn_rate_3))) * _s10;
    const double _s12 = _s8 * _s10;
    const double _s13 = (4.0 * (((fabs(vx_4) + fabs(vy_4)) + fabs(vz_4)) + fabs(turn_rate_4))) * _s12;
    const double _s14 = _s10 * _s10;
    const double _s15 = (5.0 * (((fabs(vx_5) + fabs(vy_5)) + fabs(vz_5)) + fabs(turn_rate_5))) * _s14;
    const double _s16 = _s8 * _s14;
    const double _s17 = (6.0 * (((fabs(vx_6) + fabs(vy_6)) + fabs(vz_6)) + fabs(turn_rate_6))) * _s16;
    const double _s18 = (((((_s9 + _s11) + _s13) + _s15) + _s17) + ((7.0 * _s3) * (_s10 * _s14))) + ((8.0 * _s4) * (_s12 * _s14));
    const double _s19 = _s18 + (((fabs(vx_1) + fabs(vy_1)) + fabs(vz_1)) + fabs(turn_rate_1));
    const double _s20 = p_inertia * (1.0 / (1.0 + p_inertia));
    const double _s21 = p_gravity * nz_1;
    const double _s22 = (6.0 * fabs((lift_3 + ((p_gravity * nz_3) * _s20)))) * _s8;
    const double _s23 = (12.0 * fabs((lift_4 + ((p_gravity * nz_4) * _s20)))) * _s10;
    const double _s24 = (20.0 * fabs((lift_5 + ((p_gravity * nz_5) * _s20)))) * _s12;
    const double _s25 = (30.0 * fabs((lift_6 + ((p_gravity * nz_6) * _s20)))) * _s14;
    const double _s26 = (42.0 * fabs((lift_7 + ((p_gravity * nz_7) * _s20)))) * _s16;
    const double _s27 = ((((_s22 + _s23) + _s24) + _s25) + _s26) + (2.0 * fabs((lift_2 + ((p_gravity * nz_2) * _s20))));
    return {_s8, 1.7763568394002505e-15 * _s1, _s19, (_s19 * _s8) + _s0, lift_0 + ((p_gravity * nz_0) * _s20), lift_1 + (_s21 * _s20), _s27, -((2.0 * (-_s21)) * _s20)};
}

/* 1 if a ball that may stay on a surface is on a seam of it, within the errors.
   Table 1. 13 operations: 4 additions, 2 multiplications, 4 absolute values, 1 comparison, 1 conjunction, 1 selection. */
struct kernel_seam_undecided_out {
    double uncertain;
};

static __device__ __forceinline__ kernel_seam_undecided_out kernel_seam_undecided(double p_ball_radius, double x, double y, double z, double gap, double position_error, double uncertain, bool nearly)
{
    const double _s0 = (4.0 * position_error) + (8.881784197001252e-16 * (((p_ball_radius + fabs(x)) + fabs(y)) + fabs(z)));
    return {choose((nearly && (fabs(gap) <= _s0)), 1.0, uncertain)};
}

/* Spin about the normal, times the ball's radius.
   s = R_B (w·n). 6 operations: 2 additions, 4 multiplications. */
struct kernel_roll_turn_rate_out {
    double turn_rate;
};

static __device__ __forceinline__ kernel_roll_turn_rate_out kernel_roll_turn_rate(double p_ball_radius, double nx, double ny, double nz, double wx, double wy, double wz)
{
    return {p_ball_radius * (((nx * wx) + (ny * wy)) + (nz * wz))};
}

/* Normal force, its part from free fall, friction and acceleration of a rolling ball.
   N = -a·n - v·n', F = beta (-a_t + s n × n'). 55 operations: 14 additions, 5 subtractions, 32 multiplications, 1 division, 1 square root, 2 negations. */
struct kernel_pressed_on_out {
    double press, weight, rolling_friction, rolling_acceleration_x, rolling_acceleration_y, rolling_acceleration_z;
};

static __device__ __forceinline__ kernel_pressed_on_out kernel_pressed_on(double p_ball_radius, double p_gravity, double p_inertia, double nx, double ny, double nz, double wx, double wy, double wz, double rolled_x, double rolled_y, double rolled_z, double turning_x, double turning_y, double turning_z)
{
    const double _s0 = -(p_gravity * nz);
    const double _s1 = (-_s0) - (((rolled_x * turning_x) + (rolled_y * turning_y)) + (rolled_z * turning_z));
    const double _s2 = ((nx * wx) + (ny * wy)) + (nz * wz);
    const double _s3 = p_inertia * (1.0 / (1.0 + p_inertia));
    const double _s4 = ((nx * _s0) + ((p_ball_radius * ((ny * turning_z) - (nz * turning_y))) * _s2)) * _s3;
    const double _s5 = ((ny * _s0) + ((p_ball_radius * ((nz * turning_x) - (nx * turning_z))) * _s2)) * _s3;
    const double _s6 = ((p_gravity + (nz * _s0)) + ((p_ball_radius * ((nx * turning_y) - (ny * turning_x))) * _s2)) * _s3;
    return {_s1, _s0, sqrt((((_s4 * _s4) + (_s5 * _s5)) + (_s6 * _s6))), (nx * _s1) + _s4, (ny * _s1) + _s5, ((nz * _s1) + _s6) - p_gravity};
}

/* Whether a ball leaves so slowly that its bounces may end here.
   Table 1. 21 operations: 5 additions, 10 multiplications, 1 division, 3 comparisons, 1 conjunction, 1 disjunction. */
struct kernel_leaves_slowly_out {
    bool slow;
    double assured;
};

static __device__ __forceinline__ kernel_leaves_slowly_out kernel_leaves_slowly(double p_ball_radius, double p_gravity, double nx, double ny, double nz, double vx, double vy, double vz, double position_error)
{
    const double _s0 = ((nx * vx) + (ny * vy)) + (nz * vz);
    const double _s1 = _s0 * _s0;
    const double _s2 = (7.275957614183426e-12 * p_ball_radius) * (p_gravity + ((((vx * vx) + (vy * vy)) + (vz * vz)) / p_ball_radius));
    return {(_s1 < _s2) || ((_s1 < (1.1920928955078125e-07 * p_ball_radius)) && (0.0 < position_error)), 0.0};
}

/* Whether this bounce is so small that it may be the last.
   half a hop's height. 16 operations: 5 additions, 9 multiplications, 1 division, 1 comparison. */
struct kernel_nearly_out {
    bool nearly;
};

static __device__ __forceinline__ kernel_nearly_out kernel_nearly(double p_ball_radius, double p_gravity, double nx, double ny, double nz, double vx, double vy, double vz)
{
    const double _s0 = ((nx * vx) + (ny * vy)) + (nz * vz);
    const double _s1 = (7.275957614183426e-12 * p_ball_radius) * (p_gravity + ((((vx * vx) + (vy * vy)) + (vz * vz)) / p_ball_radius));
    return {(_s0 * _s0) < _s1};
}

/* Velocity after the contact point stops; its slip, and the speed off the surface.
   the momenta that a contact conserves. 43 operations: 5 additions, 12 subtractions, 22 multiplications, 1 division, 1 square root, 1 comparison, 1 selection. */
struct kernel_gripped_out {
    double rolled_x, rolled_y, rolled_z, slip, bounce;
};

static __device__ __forceinline__ kernel_gripped_out kernel_gripped(double p_ball_radius, double p_inertia, double nx, double ny, double nz, double vx, double vy, double vz, double wx, double wy, double wz)
{
    const double _s0 = ((nx * vx) + (ny * vy)) + (nz * vz);
    const double _s1 = vx - (nx * _s0);
    const double _s2 = p_inertia * (1.0 / (1.0 + p_inertia));
    const double _s3 = _s1 - (p_ball_radius * ((nz * wy) - (ny * wz)));
    const double _s4 = vy - (ny * _s0);
    const double _s5 = _s4 - (p_ball_radius * ((nx * wz) - (nz * wx)));
    const double _s6 = vz - (nz * _s0);
    const double _s7 = _s6 - (p_ball_radius * ((ny * wx) - (nx * wy)));
    return {_s1 - (_s2 * _s3), _s4 - (_s2 * _s5), _s6 - (_s2 * _s7), sqrt((((_s7 * _s7) + (_s5 * _s5)) + (_s3 * _s3))), larger(0.0, _s0)};
}

/* Start values: no surface beside the ball.
   Table 1. No operations. */
struct kernel_isolated_out {
    double nearest, second_contact_gap;
};

static __device__ __forceinline__ kernel_isolated_out kernel_isolated()
{
    return {INFINITE, INFINITE};
}

/* Distance to a body beside a rolling ball, and whether it holds the ball, too.
   Table 1. 18 operations: 1 addition, 4 multiplications, 1 division, 2 absolute values, 5 comparisons, 1 conjunction, 4 selections. */
struct kernel_near_body_out {
    double nearest, second_contact_gap;
};

static __device__ __forceinline__ kernel_near_body_out kernel_near_body(double gap, double nearest, double second_contact_gap, double rolling_gap_acceleration, double normal_cosine, double press, double nearing)
{
    const double _s0 = fabs(gap);
    const double _s1 = fabs(rolling_gap_acceleration);
    const double _s2 = 9.5367431640625e-07 * press;
    const double _s3 = choose(((rolling_gap_acceleration < (9.094947017729282e-13 * press)) && (normal_cosine < 0.9999990463256836)), (((0.5 * (nearing * nearing)) / larger(_s1, _s2)) + _s0), (INFINITE));
    return {smaller(_s0, nearest), smaller(_s3, second_contact_gap)};
}

/* Distance to an end plane beside the ball.
   Table 1. 3 operations: 1 absolute value, 1 comparison, 1 selection. */
struct kernel_near_end_plane_out {
    double nearest;
};

static __device__ __forceinline__ kernel_near_end_plane_out kernel_near_end_plane(double gap, double nearest)
{
    const double _s0 = fabs(gap);
    return {smaller(_s0, nearest)};
}

/* Errors with those of the jump to the end of the bounces.
   its bound. 41 operations: 12 additions, 3 multiplications, 2 divisions, 3 negations, 3 absolute values, 9 comparisons, 9 selections. */
struct kernel_jump_errors_out {
    double dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz;
};

static __device__ __forceinline__ kernel_jump_errors_out kernel_jump_errors(double p_ball_radius, double vx, double vy, double vz, double dx, double dy, double dz, double dvx, double dvy, double dvz, double dwx, double dwy, double dwz)
{
    const double _s0 = 3.637978807091713e-12 * p_ball_radius;
    const double _s1 = -_s0;
    const double _s2 = (1.4551915228366852e-11 * p_ball_radius) * (1.0 + (((fabs(vx) + fabs(vy)) + fabs(vz)) / p_ball_radius));
    const double _s3 = -_s2;
    const double _s4 = _s2 / p_ball_radius;
    const double _s5 = -_s4;
    return {dx + choose((dx < 0.0), _s1, _s0), dy + choose((dy < 0.0), _s1, _s0), dz + choose((dz < 0.0), _s1, _s0), dvx + choose((dvx < 0.0), _s3, _s2), dvy + choose((dvy < 0.0), _s3, _s2), dvz + choose((dvz < 0.0), _s3, _s2), dwx + choose((dwx < 0.0), _s5, _s4), dwy + choose((dwy < 0.0), _s5, _s4), dwz + choose((dwz < 0.0), _s5, _s4)};
}

/* Whether the normal force vanishes or the ball rests; else a time for which neither can.
   N = 0. 85 operations: 12 additions, 1 subtraction, 20 multiplications, 2 divisions, 2 square roots, 2 negations, 8 absolute values, 14 comparisons, 7 conjunctions, 3 disjunctions, 3 complements, 11 selections. */
struct kernel_leaving_force_out {
    double stride, which;
    bool rests;
    double undecided_time;
};

static __device__ __forceinline__ kernel_leaving_force_out kernel_leaving_force(double p_ball_radius, double p_gravity, double vx, double vx_1, double vy, double vy_1, double vz, double vz_1, double which, double undecided_time, double position_error, double velocity_error, double per_reach, double force, double force_rate, double force_bend, double friction_force_rate, double stride, double fastest)
{
    const double _s0 = fabs(per_reach);
    const double _s1 = p_gravity + ((fastest * fastest) * _s0);
    const double _s2 = 5.684341886080802e-14 * _s1;
    const bool _s3 = force_rate < 0.0;
    const bool _s4 = (force < (-_s2)) || ((force <= _s2) && _s3);
    const double _s5 = -(force_rate + friction_force_rate);
    const double _s6 = force + choose((_s5 < 0.0), ((_s5 * _s5) / (p_gravity * (_s0 * _s1))), 0.0);
    const bool _s7 = _s4 && (_s2 < _s6);
    const bool _s8 = _s4 && (!_s7);
    const bool _s9 = (((fabs(vx) + fabs(vy)) + fabs(vz)) <= (5.684341886080802e-14 * sqrt((p_ball_radius * p_gravity)))) && (((fabs(vx_1) + fabs(vy_1)) + fabs(vz_1)) <= (5.684341886080802e-14 * p_gravity));
    const double _s10 = force_rate * force_rate;
    const double _s11 = force_bend + (9.094947017729282e-13 * _s1);
    const double _s12 = choose(_s7, _s6, larger(force, 0.0));
    const double _s13 = _s10 + ((2.0 * _s11) * _s12);
    const double _s14 = sqrt(_s13);
    const double _s15 = choose((0.0 <= _s13), (choose(_s3, (2.0 * _s12), (force_rate + _s14)) / choose(_s3, (_s14 - force_rate), larger(0.0, _s11))), (INFINITE));
    const double _s16 = ((8.0 * _s0) * ((position_error * _s1) + (velocity_error * fastest))) + _s2;
    const bool _s17 = _s7 || ((fabs(force) <= _s16) && (!(((8.0 * _s11) * _s16) < _s10)));
    return {choose((_s8 || _s9), 0.0, smaller(_s15, stride)), choose((_s8 && (which == -1.0)), 6.0, which), _s9 && (!_s8), choose(_s17, 0.0, undecided_time)};
}

/* Whether a rolling ball meets another surface; else a time for which it cannot.
   a parabola below the distance. 55 operations: 7 additions, 1 subtraction, 12 multiplications, 2 divisions, 1 square root, 1 negation, 4 absolute values, 9 comparisons, 5 conjunctions, 1 disjunction, 2 complements, 10 selections. */
struct kernel_beside_body_out {
    double stride, which, undecided_time, earliest_delay;
};

static __device__ __forceinline__ kernel_beside_body_out kernel_beside_body(double p_ball_radius, double x, double y, double z, double gap, double index, double which, double earliest_delay, double undecided_time, double position_error, double nearing, double gap_curvature, double stride, double strongest, double fastest)
{
    const double _s0 = 7.105427357601002e-15 * (((p_ball_radius + fabs(x)) + fabs(y)) + fabs(z));
    const bool _s1 = gap <= _s0;
    const bool _s2 = nearing < 0.0;
    const bool _s3 = _s1 && _s2;
    const double _s4 = nearing * nearing;
    const double _s5 = strongest + (gap_curvature * (fastest * fastest));
    const double _s6 = choose(_s1, (3.637978807091713e-12 * p_ball_radius), gap);
    const double _s7 = _s4 + ((2.0 * _s5) * _s6);
    const double _s8 = sqrt(_s7);
    const double _s9 = choose((0.0 <= _s7), (choose(_s2, (2.0 * _s6), (nearing + _s8)) / choose(_s2, (_s8 - nearing), larger(0.0, _s5))), (INFINITE));
    const bool _s10 = which == -1.0;
    const bool _s11 = _s3 && _s10;
    const double _s12 = (2.0 * position_error) + _s0;
    const bool _s13 = (((gap <= _s12) && ((-_s12) <= gap)) && (!(((8.0 * _s12) * _s5) < _s4))) || (_s3 && (!_s10));
    return {choose(_s3, 0.0, smaller(_s9, stride)), choose(_s11, index, which), choose(_s13, 0.0, undecided_time), choose(_s11, ((2.0 * _s12) / fabs(nearing)), earliest_delay)};
}

/* Whether a rolling ball crosses an end plane; else a time for which it cannot.
   a parabola below the distance. 60 operations: 7 additions, 1 subtraction, 11 multiplications, 2 divisions, 1 square root, 2 negations, 4 absolute values, 12 comparisons, 6 conjunctions, 1 disjunction, 2 complements, 11 selections. */
struct kernel_beside_end_plane_out {
    double stride, which, undecided_time, earliest_delay;
};

static __device__ __forceinline__ kernel_beside_end_plane_out kernel_beside_end_plane(double p_ball_radius, double x, double y, double z, double gap, double index, double which, double earliest_delay, double undecided_time, double position_error, double nearing, double gap_curvature, double stride, double strongest, double fastest)
{
    const double _s0 = 7.105427357601002e-15 * (((p_ball_radius + fabs(x)) + fabs(y)) + fabs(z));
    const bool _s1 = nearing < 0.0;
    const bool _s2 = ((gap <= _s0) && _s1) && ((-_s0) <= gap);
    const double _s3 = nearing * nearing;
    const double _s4 = strongest + (gap_curvature * (fastest * fastest));
    const double _s5 = larger(gap, 0.0);
    const double _s6 = _s3 + ((2.0 * _s4) * _s5);
    const double _s7 = sqrt(_s6);
    const double _s8 = choose((0.0 < gap), choose((0.0 <= _s6), (choose(_s1, (2.0 * _s5), (nearing + _s7)) / choose(_s1, (_s7 - nearing), larger(0.0, _s4))), (INFINITE)), (INFINITE));
    const bool _s9 = which == -1.0;
    const bool _s10 = _s2 && _s9;
    const double _s11 = (2.0 * position_error) + _s0;
    const bool _s12 = (((gap <= _s11) && ((-_s11) <= gap)) && (!(((8.0 * _s11) * _s4) < _s3))) || (_s2 && (!_s9));
    return {choose(_s2, 0.0, smaller(_s8, stride)), choose(_s10, index, which), choose(_s12, 0.0, undecided_time), choose(_s10, ((2.0 * _s11) / fabs(nearing)), earliest_delay)};
}

/* Time for which a rolling ball certainly stays on one part of its surface.
   a parabola below the distance. 28 operations: 3 additions, 1 subtraction, 5 multiplications, 1 division, 1 square root, 1 negation, 2 absolute values, 6 comparisons, 8 selections. */
struct kernel_beside_seam_out {
    double stride;
};

static __device__ __forceinline__ kernel_beside_seam_out kernel_beside_seam(double gap, double near, double nearing, double stride, double strongest, double fastest)
{
    const double _s0 = fabs(gap);
    const bool _s1 = _s0 <= near;
    const double _s2 = choose(_s1, 0.0, _s0);
    const double _s3 = choose(_s1, ((9.5367431640625e-07 * fastest) + fabs(nearing)), choose((0.0 < gap), nearing, (-nearing)));
    const double _s4 = ((2.0 * strongest) * _s2) + (_s3 * _s3);
    const double _s5 = sqrt(_s4);
    const bool _s6 = _s3 < 0.0;
    const double _s7 = choose((0.0 <= _s4), (choose(_s6, (2.0 * _s2), (_s5 + _s3)) / choose(_s6, (_s5 - _s3), larger(0.0, strongest))), (INFINITE));
    return {smaller(_s7, stride)};
}

/* The time limit as an event in contact.
   Table 1. 10 operations: 1 subtraction, 4 comparisons, 1 conjunction, 1 complement, 3 selections. */
struct kernel_beside_time_out {
    double stride, which;
};

static __device__ __forceinline__ kernel_beside_time_out kernel_beside_time(double which, double clock, double time_limit, double stride)
{
    const double _s0 = time_limit - clock;
    const double _s1 = smaller(_s0, stride);
    return {larger(0.0, _s1), choose(((!(clock < time_limit)) && (which == -1.0)), 4.0, which)};
}

/* Time after a step, and whether another step follows.
   Table 1. 4 operations: 1 addition, 1 comparison, 1 conjunction, 1 complement. */
struct kernel_rolled_on_out {
    double clock;
    bool rolling;
};

static __device__ __forceinline__ kernel_rolled_on_out kernel_rolled_on(double which, double clock, double stride, bool rests)
{
    return {clock + stride, (which == -1.0) && (!rests)};
}

/* Start value: no surface beside the ball.
   Table 1. No operations. */
struct kernel_no_contact_out {
    double free_time;
};

static __device__ __forceinline__ kernel_no_contact_out kernel_no_contact()
{
    return {INFINITE};
}

/* Time for which a ball that leaves certainly meets no other body.
   a parabola below the distance. 30 operations: 6 additions, 1 subtraction, 7 multiplications, 1 division, 1 square root, 3 absolute values, 5 comparisons, 6 selections. */
struct kernel_neighbour_free_time_out {
    double free_time;
};

static __device__ __forceinline__ kernel_neighbour_free_time_out kernel_neighbour_free_time(double p_gravity, double vx, double vy, double vz, double gap, double free_time, double nearing, double gap_curvature)
{
    const double _s0 = (((0.0078125 * p_gravity) + fabs(vx)) + fabs(vy)) + fabs(vz);
    const double _s1 = p_gravity + (gap_curvature * (_s0 * _s0));
    const double _s2 = larger(gap, 0.0);
    const double _s3 = (nearing * nearing) + ((2.0 * _s1) * _s2);
    const double _s4 = sqrt(_s3);
    const bool _s5 = nearing < 0.0;
    const double _s6 = choose((0.0 <= _s3), (choose(_s5, (2.0 * _s2), (nearing + _s4)) / choose(_s5, (_s4 - nearing), larger(0.0, _s1))), (INFINITE));
    return {smaller(_s6, free_time)};
}

/* Time for which a ball that leaves crosses no end plane; else that is undecided.
   a parabola below the distance. 55 operations: 8 additions, 2 subtractions, 9 multiplications, 3 divisions, 2 square roots, 2 negations, 4 absolute values, 11 comparisons, 1 disjunction, 13 selections. */
struct kernel_end_plane_free_time_out {
    double free_time, undecided_time;
};

static __device__ __forceinline__ kernel_end_plane_free_time_out kernel_end_plane_free_time(double p_gravity, double vx, double vy, double vz, double gap, double undecided_time, double free_time, double nearing, double gap_curvature)
{
    const bool _s0 = 0.0 < gap;
    const double _s1 = nearing * nearing;
    const double _s2 = (((0.0078125 * p_gravity) + fabs(vx)) + fabs(vy)) + fabs(vz);
    const double _s3 = p_gravity + (gap_curvature * (_s2 * _s2));
    const double _s4 = larger(gap, 0.0);
    const double _s5 = 2.0 * _s3;
    const double _s6 = _s1 + (_s5 * _s4);
    const double _s7 = sqrt(_s6);
    const double _s8 = larger(0.0, _s3);
    const bool _s9 = nearing < 0.0;
    const double _s10 = choose((0.0 <= _s6), (choose(_s9, (2.0 * _s4), (nearing + _s7)) / choose(_s9, (_s7 - nearing), _s8)), (INFINITE));
    const double _s11 = -gap;
    const double _s12 = larger(_s11, 0.0);
    const double _s13 = _s1 + (_s5 * _s12);
    const double _s14 = sqrt(_s13);
    const bool _s15 = (-nearing) < 0.0;
    const double _s16 = choose((0.0 <= _s13), (choose(_s15, (2.0 * _s12), (_s14 - nearing)) / choose(_s15, (nearing + _s14), _s8)), (INFINITE));
    const double _s17 = fabs(nearing) / _s3;
    return {choose(_s0, smaller(_s10, free_time), free_time), choose((_s0 || (0.0078125 < larger(_s16, _s17))), undecided_time, 0.0)};
}

/* Time for which it certainly reaches no seam, where the distance bends differently.
   a parabola below the distance. 24 operations: 2 additions, 1 subtraction, 4 multiplications, 1 division, 1 square root, 1 negation, 1 absolute value, 6 comparisons, 7 selections. */
struct kernel_seam_free_time_out {
    double free_time;
};

static __device__ __forceinline__ kernel_seam_free_time_out kernel_seam_free_time(double p_gravity, double gap, double free_time, double near, double nearing)
{
    const double _s0 = fabs(gap);
    const double _s1 = choose((0.0 < gap), nearing, (-nearing));
    const double _s2 = ((2.0 * p_gravity) * _s0) + (_s1 * _s1);
    const double _s3 = sqrt(_s2);
    const bool _s4 = _s1 < 0.0;
    const double _s5 = choose((0.0 <= _s2), (choose(_s4, (2.0 * _s0), (_s3 + _s1)) / choose(_s4, (_s3 - _s1), larger(0.0, p_gravity))), (INFINITE));
    return {choose((_s0 <= near), free_time, smaller(_s5, free_time))};
}

/* Time for which a ball that leaves a surface certainly meets neither it nor another.
   Taylor's theorem of the gap. 69 operations: 10 additions, 1 subtraction, 21 multiplications, 5 divisions, 4 square roots, 6 absolute values, 11 comparisons, 1 disjunction, 10 selections. */
struct kernel_separated_out {
    double when, undecided_time;
};

static __device__ __forceinline__ kernel_separated_out kernel_separated(double p_gravity, double vx, double vy, double vz, double undecided_time, double position_error, double velocity_error, double clock, double time_limit, double per_reach, double free_time, double lift, double gap_jerk, double gap_snap)
{
    const double _s0 = time_limit - clock;
    const double _s1 = 0.25 * free_time;
    const double _s2 = (((0.0078125 * p_gravity) + fabs(vx)) + fabs(vy)) + fabs(vz);
    const double _s3 = fabs(per_reach);
    const double _s4 = p_gravity + ((_s2 * _s2) * _s3);
    const double _s5 = (1.0 + (_s2 * _s3)) + sqrt((p_gravity * _s3));
    const double _s6 = (64.0 * _s4) * (_s5 * (_s5 * _s5));
    const double _s7 = 0.5 * gap_jerk;
    const double _s8 = sqrt((_s7 / _s6));
    const double _s9 = 9.313225746154785e-10 * _s6;
    const double _s10 = fabs(gap_snap) + _s9;
    const double _s11 = _s7 / _s10;
    const double _s12 = larger(0.0, lift);
    const double _s13 = sqrt(((128.0 * _s12) / _s6));
    const double _s14 = sqrt(((0.5 * _s12) / _s10));
    const double _s15 = _s12 / ((4.0 * fabs(gap_jerk)) + _s9);
    const double _s16 = smaller(_s14, _s15);
    const double _s17 = choose((0.0 < gap_jerk), smaller(_s8, _s11), smaller(_s13, _s16));
    const double _s18 = smaller(_s17, 0.0078125);
    const double _s19 = smaller(_s1, _s18);
    const double _s20 = smaller(_s0, _s19);
    const double _s21 = (5.684341886080802e-14 * p_gravity) + ((16.0 * ((position_error * _s4) + (velocity_error * _s2))) * _s3);
    return {larger(0.0, _s20), choose((((_s21 * _s5) < gap_jerk) || (_s21 < lift)), undecided_time, 0.0)};
}

/* Scale from the errors to the neighbouring motion.
   a chosen distance. 29 operations: 3 additions, 4 multiplications, 1 division, 9 absolute values, 6 comparisons, 6 selections. */
struct kernel_neighbour_scale_out {
    double neighbour_scale;
};

static __device__ __forceinline__ kernel_neighbour_scale_out kernel_neighbour_scale(double p_ball_radius, double dx, double dy, double dz, double dvx, double dvy, double dvz, double dwx, double dwy, double dwz)
{
    const double _s0 = fabs(dwx);
    const double _s1 = fabs(dwy);
    const double _s2 = larger(_s0, _s1);
    const double _s3 = fabs(dwz);
    const double _s4 = fabs(dvx);
    const double _s5 = fabs(dvy);
    const double _s6 = larger(_s4, _s5);
    const double _s7 = fabs(dvz);
    const double _s8 = fabs(dx);
    const double _s9 = fabs(dy);
    const double _s10 = larger(_s8, _s9);
    const double _s11 = fabs(dz);
    const double _s12 = ((1.1102230246251565e-16 * p_ball_radius) + (0.125 * ((p_ball_radius * larger(_s2, _s3)) + larger(_s6, _s7)))) + larger(_s10, _s11);
    return {(2.384185791015625e-07 * p_ball_radius) / _s12};
}

/* State of a neighbouring motion, along the errors.
   Table 1. 18 operations: 9 additions, 9 multiplications. */
struct kernel_neighbour_out {
    double far_x, far_y, far_z, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_nx, far_ny, far_nz, far_gap;
};

static __device__ __forceinline__ kernel_neighbour_out kernel_neighbour(double x, double y, double z, double vx, double vy, double vz, double wx, double wy, double wz, double dx, double dy, double dz, double dvx, double dvy, double dvz, double dwx, double dwy, double dwz, double neighbour_scale)
{
    return {x + (dx * neighbour_scale), y + (dy * neighbour_scale), z + (dz * neighbour_scale), vx + (dvx * neighbour_scale), vy + (dvy * neighbour_scale), vz + (dvz * neighbour_scale), wx + (dwx * neighbour_scale), wy + (dwy * neighbour_scale), wz + (dwz * neighbour_scale), 0.0, 0.0, 0.0, 0.0};
}

/* Errors after a step, with its roundings and truncation errors.
   differences. 72 operations: 19 additions, 9 subtractions, 4 multiplications, 10 divisions, 3 negations, 9 absolute values, 9 comparisons, 9 selections. */
struct kernel_compared_out {
    double dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz;
};

static __device__ __forceinline__ kernel_compared_out kernel_compared(double p_ball_radius, double x, double y, double z, double vx, double vy, double vz, double wx, double wy, double wz, double far_x, double far_y, double far_z, double far_vx, double far_vy, double far_vz, double far_wx, double far_wy, double far_wz, double stride, double missed, double neighbour_scale)
{
    const double _s0 = (far_x - x) / neighbour_scale;
    const double _s1 = (stride * missed) + (4.440892098500626e-16 * (((p_ball_radius + fabs(x)) + fabs(y)) + fabs(z)));
    const double _s2 = -_s1;
    const double _s3 = (far_y - y) / neighbour_scale;
    const double _s4 = (far_z - z) / neighbour_scale;
    const double _s5 = (far_vx - vx) / neighbour_scale;
    const double _s6 = ((p_ball_radius * ((fabs(wx) + fabs(wy)) + fabs(wz))) + fabs(vx)) + fabs(vy);
    const double _s7 = missed + (4.440892098500626e-16 * (_s6 + fabs(vz)));
    const double _s8 = -_s7;
    const double _s9 = (far_vy - vy) / neighbour_scale;
    const double _s10 = (far_vz - vz) / neighbour_scale;
    const double _s11 = (far_wx - wx) / neighbour_scale;
    const double _s12 = _s7 / p_ball_radius;
    const double _s13 = -_s12;
    const double _s14 = (far_wy - wy) / neighbour_scale;
    const double _s15 = (far_wz - wz) / neighbour_scale;
    return {_s0 + choose((_s0 < 0.0), _s2, _s1), _s3 + choose((_s3 < 0.0), _s2, _s1), _s4 + choose((_s4 < 0.0), _s2, _s1), _s5 + choose((_s5 < 0.0), _s8, _s7), _s9 + choose((_s9 < 0.0), _s8, _s7), _s10 + choose((_s10 < 0.0), _s8, _s7), _s11 + choose((_s11 < 0.0), _s13, _s12), _s14 + choose((_s14 < 0.0), _s13, _s12), _s15 + choose((_s15 < 0.0), _s13, _s12)};
}

/* Errors after the flight of a departure.
   derivative of Eq. 3. 34 operations: 9 additions, 10 multiplications, 3 negations, 6 absolute values, 3 comparisons, 3 selections. */
struct kernel_carry_hop_out {
    double dx, dy, dz;
};

static __device__ __forceinline__ kernel_carry_hop_out kernel_carry_hop(double x, double y, double z, double vx, double vy, double vz, double dx, double dy, double dz, double dvx, double dvy, double dvz, double when)
{
    const double _s0 = dx + (dvx * when);
    const double _s1 = 2.0 * when;
    const double _s2 = 1.1102230246251565e-16 * ((_s1 * fabs(vx)) + fabs(x));
    const double _s3 = dy + (dvy * when);
    const double _s4 = 1.1102230246251565e-16 * ((_s1 * fabs(vy)) + fabs(y));
    const double _s5 = dz + (dvz * when);
    const double _s6 = 1.1102230246251565e-16 * ((_s1 * fabs(vz)) + fabs(z));
    return {_s0 + choose((_s0 < 0.0), (-_s2), _s2), _s3 + choose((_s3 < 0.0), (-_s4), _s4), _s5 + choose((_s5 < 0.0), (-_s6), _s6)};
}

/* Whether the ball starts on a surface that it can roll on.
   Table 1. 4 operations: 2 comparisons, 1 conjunction, 1 selection. */
struct kernel_started_on_surface_out {
    double mode;
};

static __device__ __forceinline__ kernel_started_on_surface_out kernel_started_on_surface(double last)
{
    return {choose(((0.0 <= last) && (last <= 2.0)), 5.0, 0.0)};
}

/* Start on a surface: no event, whatever surface the turn is about.
   Table 1. 5 operations: 1 comparison, 2 conjunctions, 1 complement, 1 selection. */
struct kernel_nothing_happens_yet_out {
    bool moves, touches;
    double body;
};

static __device__ __forceinline__ kernel_nothing_happens_yet_out kernel_nothing_happens_yet(double body, bool touches, double mode, bool moves)
{
    const bool _s0 = mode == 5.0;
    const bool _s1 = !_s0;
    return {moves && _s1, touches && _s1, choose(_s0, -1.0, body)};
}

/* Start value for a ball without a contact: whether it may stay where it starts.
   Table 1. 1 operation: 1 comparison. */
struct kernel_slow_at_start_out {
    bool slow;
};

static __device__ __forceinline__ kernel_slow_at_start_out kernel_slow_at_start(double mode)
{
    return {mode == 5.0};
}

/* Whether a ball starts on a surface, which it may be off by the caller's digits.
   Table 1. 1 operation: 1 comparison. */
struct kernel_off_at_start_out {
    bool put_on;
};

static __device__ __forceinline__ kernel_off_at_start_out kernel_off_at_start(double mode)
{
    return {mode == 5.0};
}

/* Place of a ball that starts on a surface, put onto it along the normal.
   Table 2. 14 operations: 2 additions, 3 subtractions, 7 multiplications, 1 division, 1 square root. */
struct kernel_placed_at_start_out {
    double x, y, z;
};

static __device__ __forceinline__ kernel_placed_at_start_out kernel_placed_at_start(double x, double y, double z, double nx, double ny, double nz, double gap)
{
    const double _s0 = gap * (1.0 / sqrt((((nx * nx) + (ny * ny)) + (nz * nz))));
    return {x - (nx * _s0), y - (ny * _s0), z - (nz * _s0)};
}

/* Errors with the rounding of that place.
   its bound. 17 operations: 6 additions, 1 multiplication, 1 negation, 3 absolute values, 3 comparisons, 3 selections. */
struct kernel_start_errors_out {
    double dx, dy, dz;
};

static __device__ __forceinline__ kernel_start_errors_out kernel_start_errors(double p_ball_radius, double x, double y, double z, double dx, double dy, double dz)
{
    const double _s0 = 8.881784197001252e-16 * (((p_ball_radius + fabs(x)) + fabs(y)) + fabs(z));
    const double _s1 = -_s0;
    return {dx + choose((dx < 0.0), _s1, _s0), dy + choose((dy < 0.0), _s1, _s0), dz + choose((dz < 0.0), _s1, _s0)};
}

/* 1 if it is undecided whether the speed along the normal is a rounding.
   Table 1. 33 operations: 10 additions, 8 multiplications, 1 division, 10 absolute values, 2 comparisons, 1 conjunction, 1 selection. */
struct kernel_undecided_at_start_out {
    double uncertain;
};

static __device__ __forceinline__ kernel_undecided_at_start_out kernel_undecided_at_start(double p_ball_radius, double x, double y, double z, double nx, double ny, double nz, double vx, double vy, double vz, double wx, double wy, double wz, double uncertain)
{
    const double _s0 = ((p_ball_radius * ((fabs(wx) + fabs(wy)) + fabs(wz))) + fabs(vx)) + fabs(vy);
    const double _s1 = 3.552713678800501e-15 * (1.0 + (((fabs(x) + fabs(y)) + fabs(z)) / p_ball_radius));
    const double _s2 = _s1 * (_s0 + fabs(vz));
    const double _s3 = fabs((((nx * vx) + (ny * vy)) + (nz * vz)));
    return {choose((((0.5 * _s2) < _s3) && (_s3 < (2.0 * _s2))), 1.0, uncertain)};
}

/* Errors with the rounding of a velocity along the surface.
   its bound. 32 operations: 11 additions, 4 multiplications, 1 division, 1 negation, 9 absolute values, 3 comparisons, 3 selections. */
struct kernel_start_velocity_errors_out {
    double dvx, dvy, dvz;
};

static __device__ __forceinline__ kernel_start_velocity_errors_out kernel_start_velocity_errors(double p_ball_radius, double x, double y, double z, double vx, double vy, double vz, double wx, double wy, double wz, double dvx, double dvy, double dvz)
{
    const double _s0 = ((p_ball_radius * ((fabs(wx) + fabs(wy)) + fabs(wz))) + fabs(vx)) + fabs(vy);
    const double _s1 = 3.552713678800501e-15 * (1.0 + (((fabs(x) + fabs(y)) + fabs(z)) / p_ball_radius));
    const double _s2 = 0.03125 * (_s1 * (_s0 + fabs(vz)));
    const double _s3 = -_s2;
    return {dvx + choose((dvx < 0.0), _s3, _s2), dvy + choose((dvy < 0.0), _s3, _s2), dvz + choose((dvz < 0.0), _s3, _s2)};
}

/* Velocity of a ball that starts on a surface, along it if it is so to roundings.
   the normal of Table 2. 35 operations: 10 additions, 3 subtractions, 9 multiplications, 1 division, 10 absolute values, 1 comparison, 1 selection. */
struct kernel_velocity_at_start_out {
    double vx, vy, vz;
};

static __device__ __forceinline__ kernel_velocity_at_start_out kernel_velocity_at_start(double p_ball_radius, double x, double y, double z, double nx, double ny, double nz, double vx, double vy, double vz, double wx, double wy, double wz)
{
    const double _s0 = ((nx * vx) + (ny * vy)) + (nz * vz);
    const double _s1 = ((p_ball_radius * ((fabs(wx) + fabs(wy)) + fabs(wz))) + fabs(vx)) + fabs(vy);
    const double _s2 = 3.552713678800501e-15 * (1.0 + (((fabs(x) + fabs(y)) + fabs(z)) / p_ball_radius));
    const double _s3 = choose((fabs(_s0) <= (_s2 * (_s1 + fabs(vz)))), _s0, 0.0);
    return {vx - (nx * _s3), vy - (ny * _s3), vz - (nz * _s3)};
}

/* Whether the ball is in contact, and has no flight to search.
   Table 1. 2 operations: 1 comparison, 1 selection. */
struct kernel_in_contact_out {
    bool in_contact;
    double when;
    bool rests, rolling;
    double began;
};

static __device__ __forceinline__ kernel_in_contact_out kernel_in_contact(double when, double mode)
{
    const bool _s0 = 0.0 < mode;
    return {_s0, choose(_s0, 0.0, when), false, false, 0.0};
}

/* Whether a ball in flight may hit a surface.
   Table 1. 4 operations: 1 comparison, 1 conjunction, 2 complements. */
struct kernel_opens_in_flight_out {
    bool open;
};

static __device__ __forceinline__ kernel_opens_in_flight_out kernel_opens_in_flight(double clear, bool in_contact)
{
    return {(!(0.0 < clear)) && (!in_contact)};
}

/* Whether a ball in flight may reach the box of a surface.
   Table 1. 2 operations: 1 conjunction, 1 complement. */
struct kernel_reachable_in_flight_out {
    bool reachable;
};

static __device__ __forceinline__ kernel_reachable_in_flight_out kernel_reachable_in_flight(bool reachable, bool in_contact)
{
    return {reachable && (!in_contact)};
}

/* Start values of a turn in contact: no event yet, and the surface that the ball is on.
   Table 1. 9 operations: 6 comparisons, 1 conjunction, 2 selections. */
struct kernel_resumed_out {
    double which, earliest_delay, began, undecided_time;
    bool begins, rolling, leaves;
    double nx, ny, nz, gap, bent_x, bent_y, bent_z, lift, gap_jerk, gap_snap, per_reach;
};

static __device__ __forceinline__ kernel_resumed_out kernel_resumed(double last, double position_error, double velocity_error, double clock, double mode)
{
    return {choose((mode == 5.0), last, -1.0), 0.0, clock, choose(((position_error < (INFINITE)) && (velocity_error < (INFINITE))), (INFINITE), 0.0), mode == 1.0, mode == 2.0, mode == 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
}

/* 1 if a decision lies within its error, unless that only delays bounces on a surface.
   Table 1. 16 operations: 1 addition, 6 comparisons, 5 conjunctions, 1 disjunction, 2 complements, 1 selection. */
struct kernel_contact_undecided_out {
    double uncertain;
};

static __device__ __forceinline__ kernel_contact_undecided_out kernel_contact_undecided(double last, double when, double which, double earliest_delay, double undecided_time, double position_error, double velocity_error, double uncertain, bool edge, double assured)
{
    const bool _s0 = (((!((when + earliest_delay) < undecided_time)) && (undecided_time < (INFINITE))) || edge) && (!(((0.0 < assured) && (which == last)) && ((position_error < (INFINITE)) && (velocity_error < (INFINITE)))));
    return {choose(_s0, 1.0, uncertain)};
}

/* Whether the ball stays on a surface.
   Table 1. 1 operation: 1 comparison. */
struct kernel_holding_out {
    bool here;
};

static __device__ __forceinline__ kernel_holding_out kernel_holding(double index, double held)
{
    return {held == index};
}

/* Whether a surface is another than the one that the ball stays on.
   Table 1. 2 operations: 1 comparison, 1 complement. */
struct kernel_beside_out {
    bool beside;
};

static __device__ __forceinline__ kernel_beside_out kernel_beside(double index, double held)
{
    return {!(held == index)};
}

/* Whether a surface is another than that of the event.
   Table 1. 2 operations: 1 comparison, 1 complement. */
struct kernel_other_surface_out {
    bool beside;
};

static __device__ __forceinline__ kernel_other_surface_out kernel_other_surface(double index, double which)
{
    return {!(which == index)};
}

/* Start value: the ball has not departed.
   Table 1. No operations. */
struct kernel_no_departure_out {
    bool hopped;
};

static __device__ __forceinline__ kernel_no_departure_out kernel_no_departure()
{
    return {false};
}

/* Event: the contact begins.
   Table 1. No operations. */
struct kernel_beginning_contact_out {
    double which, circled;
};

static __device__ __forceinline__ kernel_beginning_contact_out kernel_beginning_contact()
{
    return {5.0, 0.0};
}

/* Event: the ball is off the surface.
   Table 1. No operations. */
struct kernel_detachment_out {
    double which;
};

static __device__ __forceinline__ kernel_detachment_out kernel_detachment()
{
    return {7.0};
}

/* Log entry, outcome and mode of a ball in contact after a turn.
   Table 1. 41 operations: 3 additions, 1 subtraction, 1 multiplication, 10 comparisons, 2 conjunctions, 5 disjunctions, 1 complement, 18 selections. */
struct kernel_stay_in_contact_out {
    double body, reached, undecided_time;
    bool ends, hopped;
    double last, mode, held, rolls;
};

static __device__ __forceinline__ kernel_stay_in_contact_out kernel_stay_in_contact(double last, double which, double undecided_time, double body, double clock, double reached, bool ends, double held, double mode, double rolls, bool rolling, double began, bool rests)
{
    const bool _s0 = which == 5.0;
    const double _s1 = 2.0 * choose((held == 2.0), 2.0, choose((held == 1.0), 1.0, choose((held == 0.0), 0.0, -1.0)));
    const bool _s2 = which == 6.0;
    const bool _s3 = which == 7.0;
    const bool _s4 = which == 8.0;
    const bool _s5 = rolling && ((clock - began) <= 5.960464477539063e-08);
    const bool _s6 = 4.0 < which;
    const bool _s7 = mode == 5.0;
    const double _s8 = choose(_s5, 2.0, choose(_s4, 6.0, choose(rests, 5.0, choose(((_s6 || rolling) || _s7), -1.0, reached))));
    return {choose(_s0, (4.0 + _s1), choose(_s2, (5.0 + _s1), choose(_s3, -1.0, choose(_s4, 3.0, body)))), _s8, choose(_s5, 0.0, undecided_time), ends && (!_s6), _s3, choose(_s3, -1.0, last), choose((_s0 || rolling), 2.0, choose(_s7, 5.0, choose(_s2, 3.0, 0.0))), choose(((_s0 || _s2) || rolling), held, -1.0), choose(_s0, (1.0 + rolls), rolls)};
}

/* Whether the ball stays on the surface, slides, leaves, or is wedged.
   Table 1. 26 operations: 4 comparisons, 7 conjunctions, 5 disjunctions, 2 complements, 8 selections. */
struct kernel_settled_out {
    double mode, held, outcome, slip_left, uncertain;
};

static __device__ __forceinline__ kernel_settled_out kernel_settled(double index, double position_error, double velocity_error, double outcome, double uncertain, bool undecided, double mode, bool settles, bool nearly, bool lodges, bool slides, bool unpressed)
{
    const bool _s0 = (lodges || (undecided && (nearly || (!(mode == 5.0))))) || (nearly && (!((position_error < (INFINITE)) && (velocity_error < (INFINITE)))));
    return {choose(nearly, choose(settles, 1.0, choose(unpressed, 3.0, 0.0)), 0.0), choose((nearly && (settles || unpressed)), index, -1.0), choose(((nearly && (lodges || slides)) && (outcome < 0.0)), choose(lodges, 5.0, 2.0), outcome), choose((nearly && slides), 1.0, 0.0), choose(_s0, 1.0, uncertain)};
}

/* Square of the friction that rolling takes, per unit mass, and its rate.
   F = beta (-a_t + s n × n'). 57 operations: 18 additions, 36 multiplications, 1 division, 2 negations. */
struct kernel_ring_friction_out {
    double rolling_friction, rolling_friction_rate, grip_deficit, grip_deficit_rate;
};

static __device__ __forceinline__ kernel_ring_friction_out kernel_ring_friction(double p_gravity, double p_inertia, double nx_0, double nx_1, double ny_0, double ny_1, double nz_0, double nz_1, double turn_rate_0, double turn_rate_1, double tx_0, double tx_1, double ty_0, double ty_1, double tz_0, double tz_1)
{
    const double _s0 = -(p_gravity * nz_0);
    const double _s1 = p_inertia * (1.0 / (1.0 + p_inertia));
    const double _s2 = ((nx_0 * _s0) + (turn_rate_0 * tx_0)) * _s1;
    const double _s3 = ((ny_0 * _s0) + (turn_rate_0 * ty_0)) * _s1;
    const double _s4 = ((p_gravity + (nz_0 * _s0)) + (turn_rate_0 * tz_0)) * _s1;
    const double _s5 = -(p_gravity * nz_1);
    const double _s6 = (2.0 * _s2) * (((((nx_0 * _s5) + (nx_1 * _s0)) + (turn_rate_0 * tx_1)) + (turn_rate_1 * tx_0)) * _s1);
    const double _s7 = (2.0 * _s3) * (((((ny_0 * _s5) + (ny_1 * _s0)) + (turn_rate_0 * ty_1)) + (turn_rate_1 * ty_0)) * _s1);
    const double _s8 = (2.0 * _s4) * (((((nz_0 * _s5) + (nz_1 * _s0)) + (turn_rate_0 * tz_1)) + (turn_rate_1 * tz_0)) * _s1);
    return {((_s2 * _s2) + (_s3 * _s3)) + (_s4 * _s4), (_s6 + _s7) + _s8, -INFINITE, 0.0};
}

/* Start value of a contact: no excess is known.
   Table 1. No operations. */
struct kernel_forget_grip_deficit_out {
    double last_grip_deficit;
};

static __device__ __forceinline__ kernel_forget_grip_deficit_out kernel_forget_grip_deficit()
{
    return {INFINITE};
}

/* Whether friction exceeds its limit for the first time.
   F² > mu² N². 3 operations: 2 comparisons, 1 conjunction. */
struct kernel_exceeds_grip_out {
    bool loses;
};

static __device__ __forceinline__ kernel_exceeds_grip_out kernel_exceeds_grip(double grip_deficit, double grip_lost)
{
    return {(0.0 < grip_deficit) && (grip_lost == (INFINITE))};
}

/* Time at which friction first exceeded its limit.
   a cubic between the ends of a step. 97 operations: 22 additions, 9 subtractions, 28 multiplications, 5 divisions, 1 negation, 16 comparisons, 1 conjunction, 15 selections. */
struct kernel_grip_lost_time_out {
    double grip_lost;
};

static __device__ __forceinline__ kernel_grip_lost_time_out kernel_grip_lost_time(double clock, double grip_deficit, double grip_deficit_rate, double last_grip_deficit, double last_grip_deficit_rate, double last_grip_clock)
{
    const double _s0 = clock - last_grip_clock;
    const double _s1 = grip_deficit - last_grip_deficit;
    const double _s2 = -(last_grip_deficit / _s1);
    const double _s3 = smaller(_s2, 1.0);
    const double _s4 = larger(0.0, _s3);
    const double _s5 = grip_deficit_rate * _s0;
    const double _s6 = last_grip_deficit_rate * _s0;
    const double _s7 = (_s5 + _s6) - (2.0 * _s1);
    const double _s8 = ((3.0 * _s1) - _s5) - (2.0 * _s6);
    const double _s9 = last_grip_deficit + (((((_s7 * _s4) + _s8) * _s4) + _s6) * _s4);
    const double _s10 = 3.0 * _s7;
    const double _s11 = 2.0 * _s8;
    const double _s12 = (((_s10 * _s4) + _s11) * _s4) + _s6;
    const double _s13 = _s4 - (_s9 / choose((0.0 < _s12), _s12, _s1));
    const double _s14 = smaller(_s13, 1.0);
    const double _s15 = larger(0.0, _s14);
    const double _s16 = last_grip_deficit + (((((_s7 * _s15) + _s8) * _s15) + _s6) * _s15);
    const double _s17 = (((_s10 * _s15) + _s11) * _s15) + _s6;
    const double _s18 = _s15 - (_s16 / choose((0.0 < _s17), _s17, _s1));
    const double _s19 = smaller(_s18, 1.0);
    const double _s20 = larger(0.0, _s19);
    const double _s21 = last_grip_deficit + (((((_s7 * _s20) + _s8) * _s20) + _s6) * _s20);
    const double _s22 = (((_s10 * _s20) + _s11) * _s20) + _s6;
    const double _s23 = _s20 - (_s21 / choose((0.0 < _s22), _s22, _s1));
    const double _s24 = smaller(_s23, 1.0);
    const double _s25 = larger(0.0, _s24);
    const double _s26 = last_grip_deficit + (((((_s7 * _s25) + _s8) * _s25) + _s6) * _s25);
    const double _s27 = (((_s10 * _s25) + _s11) * _s25) + _s6;
    const double _s28 = _s25 - (_s26 / choose((0.0 < _s27), _s27, _s1));
    const double _s29 = smaller(_s28, 1.0);
    return {choose(((last_grip_deficit < (INFINITE)) && (last_grip_deficit < grip_deficit)), (last_grip_clock + (_s0 * larger(0.0, _s29))), clock)};
}

/* Excess, rate and time at the end of this step, for the next one.
   Table 1. No operations. */
struct kernel_remember_grip_deficit_out {
    double last_grip_deficit, last_grip_deficit_rate, last_grip_clock;
};

static __device__ __forceinline__ kernel_remember_grip_deficit_out kernel_remember_grip_deficit(double clock, double grip_deficit, double grip_deficit_rate)
{
    return {grip_deficit, grip_deficit_rate, clock};
}

/* Undecided time 0 if errors are too large to decide on which side a flight begins.
   Table 1. 8 operations: 4 multiplications, 1 negation, 1 absolute value, 1 comparison, 1 selection. */
struct kernel_plane_start_out {
    double undecided_time;
};

static __device__ __forceinline__ kernel_plane_start_out kernel_plane_start(double p_gravity, double undecided_time, double position_error, double velocity_error)
{
    const double _s0 = 2.0 * velocity_error;
    const double _s1 = choose(((position_error * (0.5 * fabs((-p_gravity)))) < (_s0 * _s0)), 0.0, undecided_time);
    return {_s1};
}

/* The parameters in which one body's law differs from another's.
   data. 1 operation: 1 complement. */
struct kernel_ring_impact_taken_out {
    bool of_this_kind;
    double its_0, its_1;
};

static __device__ __forceinline__ kernel_ring_impact_taken_out kernel_ring_impact_taken(double p_ring_restitution, double p_ring_friction)
{
    return {!false, p_ring_restitution, p_ring_friction};
}

/* Whether a decision within the contact lies within its error.
   the law's own slack. 88 operations: 16 additions, 11 subtractions, 29 multiplications, 3 divisions, 1 square root, 1 negation, 13 absolute values, 7 comparisons, 2 conjunctions, 1 complement, 4 selections. */
struct kernel_ring_impact_undecided_out {
    bool undecided;
};

static __device__ __forceinline__ kernel_ring_impact_undecided_out kernel_ring_impact_undecided(double vx, double vy, double vz, double wx, double wy, double wz, double nx, double ny, double nz, double dvx, double dvy, double dvz, double dwx, double dwy, double dwz, double turn, double p_ball_radius, double p_ring_restitution, double p_ring_friction, double p_inertia, double p_tangential_restitution, double p_restitution_speed)
{
    const double _s0 = (p_inertia * (1.0 + p_tangential_restitution)) / (1.0 + p_inertia);
    const double _s1 = fabs(dwx);
    const double _s2 = fabs(dwy);
    const double _s3 = larger(_s1, _s2);
    const double _s4 = fabs(dwz);
    const double _s5 = ((p_ball_radius * ((fabs(wx) + fabs(wy)) + fabs(wz))) + fabs(vx)) + fabs(vy);
    const double _s6 = _s5 + fabs(vz);
    const double _s7 = fabs(dvx);
    const double _s8 = fabs(dvy);
    const double _s9 = larger(_s7, _s8);
    const double _s10 = fabs(dvz);
    const double _s11 = 64.0 * ((((p_ball_radius * larger(_s3, _s4)) + (turn * _s6)) + larger(_s9, _s10)) + (4.440892098500626e-16 * _s6));
    const double _s12 = ((nx * vx) + (ny * vy)) + (nz * vz);
    const double _s13 = (vz - (nz * _s12)) - (p_ball_radius * ((ny * wx) - (nx * wy)));
    const double _s14 = (vy - (ny * _s12)) - (p_ball_radius * ((nx * wz) - (nz * wx)));
    const double _s15 = (vx - (nx * _s12)) - (p_ball_radius * ((nz * wy) - (ny * wz)));
    const double _s16 = p_ring_friction * ((1.0 + (p_ring_restitution / (1.0 - (_s12 / p_restitution_speed)))) * _s12);
    const double _s17 = (_s0 * sqrt((((_s13 * _s13) + (_s14 * _s14)) + (_s15 * _s15)))) - (-_s16);
    const bool _s18 = ((0.0 < p_ring_friction) && (p_ring_friction < (INFINITE))) && (!((((2.0 * p_ring_friction) + _s0) * _s11) < fabs(_s17)));
    return {_s18};
}

/* Whether the bounces end in rolling, sliding, a wedge or departure, and whether that is certain.
   a geometric series of bounces. 227 operations: 36 additions, 4 subtractions, 68 multiplications, 11 divisions, 1 square root, 2 negations, 22 absolute values, 33 comparisons, 32 conjunctions, 10 disjunctions, 5 complements, 3 selections. */
struct kernel_ring_impact_settling_out {
    bool settles, lodges, slides, unpressed;
    double assured;
    bool undecided;
};

static __device__ __forceinline__ kernel_ring_impact_settling_out kernel_ring_impact_settling(double p_ball_radius, double p_gravity, double p_inertia, double p_ring_friction, double p_ring_restitution, double x, double y, double z, double nx, double ny, double nz, double vx, double vy, double vz, double wx, double wy, double wz, double position_error, double velocity_error, double mode, double per_reach, double rolled_x, double rolled_y, double rolled_z, double turning_x, double turning_y, double turning_z, double slip, double bounce, double nearest, double second_contact_gap, double press, double weight, double rolling_friction, double lift, double gap_jerk)
{
    const double _s0 = 1.0 - p_ring_restitution;
    const bool _s1 = 0.0 < _s0;
    const double _s2 = bounce / press;
    const double _s3 = 4.440892098500626e-16 + ((fabs(turning_x) + fabs(turning_y)) + fabs(turning_z));
    const double _s4 = p_ball_radius * ((fabs(wx) + fabs(wy)) + fabs(wz));
    const double _s5 = ((_s4 + fabs(rolled_x)) + fabs(rolled_y)) + fabs(rolled_z);
    const double _s6 = fabs(weight);
    const double _s7 = (8.0 * _s3) * ((_s3 * _s5) + _s6);
    const double _s8 = _s0 * _s0;
    const double _s9 = sqrt((p_ball_radius * _s6)) + _s5;
    const double _s10 = 1.4210854715202004e-14 * _s9;
    const double _s11 = 2.0 * rolling_friction;
    const double _s12 = 1.0 + p_ring_restitution;
    const double _s13 = p_ring_friction * _s12;
    const double _s14 = press * _s13;
    const bool _s15 = ((((0.0 < press) && _s1) && (((3.0 * _s2) * _s7) < (press * _s8))) && (slip <= (((8.0 * rolling_friction) * _s2) + _s10))) && (_s11 <= _s14);
    const double _s16 = 0.5 * bounce;
    const double _s17 = _s12 * _s0;
    const double _s18 = 4.0 * rolling_friction;
    const double _s19 = p_inertia * (1.0 / (1.0 + p_inertia));
    const double _s20 = ((_s16 * _s2) + ((_s18 * (_s2 * _s2)) / _s17)) + ((((4.0 * slip) * _s19) * _s2) / _s0);
    const double _s21 = 3.637978807091713e-12 * p_ball_radius;
    const bool _s22 = _s15 && (_s20 <= _s21);
    const double _s23 = 3.725290298461914e-09 * p_ball_radius;
    const bool _s24 = second_contact_gap <= _s23;
    const double _s25 = ((16.0 * _s2) * _s5) / _s0;
    const bool _s26 = (_s23 + _s25) < nearest;
    const bool _s27 = _s25 <= _s23;
    const bool _s28 = mode == 5.0;
    const double _s29 = 3.552713678800501e-15 * (1.0 + (((fabs(x) + fabs(y)) + fabs(z)) / p_ball_radius));
    const double _s30 = _s29 * (((_s4 + fabs(vx)) + fabs(vy)) + fabs(vz));
    const double _s31 = -(((nx * vx) + (ny * vy)) + (nz * vz));
    const bool _s32 = (_s28 && (bounce <= _s30)) && (_s31 <= _s30);
    const bool _s33 = _s32 && (0.0 < gap_jerk);
    const double _s34 = fabs(lift);
    const double _s35 = 2.2737367544323206e-13 * (p_gravity + ((((vx * vx) + (vy * vy)) + (vz * vz)) / p_ball_radius));
    const bool _s36 = _s33 && (_s34 <= _s35);
    const bool _s37 = !_s36;
    const double _s38 = -lift;
    const double _s39 = smaller(_s38, press);
    const double _s40 = bounce / _s39;
    const bool _s41 = (((0.0 < _s39) && _s1) && (((3.0 * _s40) * _s7) < (_s8 * _s39))) && ((_s23 + (((16.0 * _s40) * _s5) / _s0)) < nearest);
    const bool _s42 = _s41 && (((_s16 * _s40) + ((_s18 * (_s40 * _s40)) / _s17)) <= _s21);
    const double _s43 = ((2.0 * ((_s11 * _s40) + choose((0.0 < bounce), (bounce * _s13), 0.0))) / (_s19 * _s0)) + (1.4551915228366852e-11 * _s9);
    const bool _s44 = (((bounce <= _s10) && (0.0 <= lift)) && (!(_s28 && ((0.5 * _s30) < _s31)))) || _s36;
    const double _s45 = slip + _s5;
    const double _s46 = fabs(per_reach);
    const double _s47 = p_gravity + ((_s45 * _s45) * _s46);
    const double _s48 = ((8.0 * ((position_error * _s47) + (velocity_error * _s45))) * _s46) + (3.552713678800501e-15 * _s47);
    const bool _s49 = (((bounce * fabs((_s20 - _s21))) <= ((2.0 * velocity_error) * _s21)) && (0.0 < (p_ring_restitution * bounce))) && (!_s32);
    const double _s50 = 8.0 * velocity_error;
    const bool _s51 = _s42 && ((fabs((slip - _s43)) < _s50) || (fabs((_s11 - _s14)) < (_s50 * ((_s13 * _s3) + _s3))));
    const bool _s52 = ((((fabs(press) <= _s48) || (_s34 <= _s48)) || _s49) || _s51) || ((_s22 && _s27) && (!_s26));
    return {((_s22 && (!_s24)) && (_s26 || _s27)) && _s37, (_s22 && _s24) && _s37, (_s42 && ((_s43 < slip) || (_s14 < _s11))) && _s37, _s44, choose(((_s15 && _s26) || _s41), 1.0, 0.0), (_s52 && _s37) || (_s33 && (((0.5 * _s35) < _s34) && (_s34 < (2.0 * _s35))))};
}

/* Excess F² - mu² N² and its rate.
   Coulomb's law. 8 operations: 2 subtractions, 6 multiplications. */
struct kernel_ring_impact_grip_deficit_out {
    double grip_deficit, grip_deficit_rate;
};

static __device__ __forceinline__ kernel_ring_impact_grip_deficit_out kernel_ring_impact_grip_deficit(double p_ring_friction, double rolling_friction, double rolling_friction_rate, double force, double force_rate)
{
    const double _s0 = p_ring_friction * p_ring_friction;
    return {rolling_friction - (_s0 * (force * force)), rolling_friction_rate - (_s0 * (2.0 * (force * force_rate)))};
}

/* Slip of a contact, the share of it that friction takes, and the margin of grip.
   momentum, angular momentum and Coulomb's law of friction. 65 operations: 7 additions, 11 subtractions, 28 multiplications, 5 divisions, 1 square root, 1 negation, 4 comparisons, 8 selections. */
struct kernel_ring_impact_slip_out {
    double slip_share, slip_margin, slip_speed, slip_x, slip_y, slip_z;
};

static __device__ __forceinline__ kernel_ring_impact_slip_out kernel_ring_impact_slip(double vx, double vy, double vz, double wx, double wy, double wz, double nx, double ny, double nz, double p_ball_radius, double p_ring_restitution, double p_ring_friction, double p_inertia, double p_tangential_restitution, double p_restitution_speed)
{
    const double _s0 = ((nx * vx) + (ny * vy)) + (nz * vz);
    const double _s1 = (vz - (nz * _s0)) - (p_ball_radius * ((ny * wx) - (nx * wy)));
    const double _s2 = (vy - (ny * _s0)) - (p_ball_radius * ((nx * wz) - (nz * wx)));
    const double _s3 = (vx - (nx * _s0)) - (p_ball_radius * ((nz * wy) - (ny * wz)));
    const double _s4 = ((_s1 * _s1) + (_s2 * _s2)) + (_s3 * _s3);
    const double _s5 = (p_inertia * (1.0 + p_tangential_restitution)) / (1.0 + p_inertia);
    const double _s6 = p_ring_friction * ((1.0 + (p_ring_restitution / (1.0 - (_s0 / p_restitution_speed)))) * _s0);
    const double _s7 = -_s6;
    const double _s8 = sqrt(_s4);
    const bool _s9 = p_ring_friction < (INFINITE);
    const bool _s10 = 0.0 < p_ring_friction;
    const double _s11 = choose(_s10, choose(_s9, choose(((_s4 * (_s5 * _s5)) <= (_s7 * _s7)), _s5, (_s7 / _s8)), _s5), 0.0);
    const double _s12 = 1.0 / _s8;
    const bool _s13 = 0.0 < _s8;
    return {_s11, choose(_s10, choose(_s9, (_s7 - (_s5 * _s8)), 1.0), 1.0), _s8, choose(_s13, (_s3 * _s12), 0.0), choose(_s13, (_s2 * _s12), 0.0), choose(_s13, (_s1 * _s12), 0.0)};
}

/* Bounds on errors after a contact, from those at the departure before it.
   derivative of the contact with friction, with roundings. 1529 operations: 372 additions, 141 subtractions, 726 multiplications, 17 divisions, 93 negations, 133 absolute values, 16 comparisons, 31 selections. */
struct kernel_bound_ring_impact_out {
    float place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound, spin_bound, left_nx, left_ny, left_nz, left_ex, left_ey, left_bend_s, left_bend_e, delay;
};

static __device__ __forceinline__ kernel_bound_ring_impact_out kernel_bound_ring_impact(float t, float x, float y, float z, float vx, float vy, float vz, float wx, float wy, float wz, float nx, float ny, float nz, float clock, float left_nx, float left_ny, float left_nz, float place_n, float place_s, float place_e, float pace_n, float pace_s, float pace_e, float turn_n, float turn_z, float position_bound, float velocity_bound, float spin_bound, float tangent_x, float tangent_y, float bend_s, float bend_e, float left_ex, float left_ey, float left_bend_s, float left_bend_e, float sharpest_bend, float root_offset, float root_level, float normal_rounding, float normal_velocity, float back, float slip_share, float slip_margin, float slip_speed, float slip_x, float slip_y, float slip_z, float p_ball_radius, float p_gravity, float p_ring_restitution, float p_ring_friction, float p_inertia, float p_tangential_restitution, float p_restitution_speed)
{
    const float _s0 = -(p_gravity * nz);
    const float _s1 = fabsf(vx);
    const float _s2 = ((float)2.0) * t;
    const float _s3 = ((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * ((_s2 * _s1) + fabsf(x)));
    const float _s4 = fabsf(vy);
    const float _s5 = ((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * ((_s2 * _s4) + fabsf(y)));
    const float _s6 = ((float)0.5) * p_gravity;
    const float _s7 = ((_s6 * (t * t)) + (_s2 * fabsf((vz + (_s6 * t))))) + fabsf(z);
    const float _s8 = ((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * _s7);
    const float _s9 = ((position_bound + (t * velocity_bound)) + ((_s3 + _s5) + _s8)) + larger(root_offset, root_level);
    const float _s10 = ((nx * left_nx) + (ny * left_ny)) + (nz * left_nz);
    const float _s11 = _s10 - back;
    const float _s12 = nz * tangent_y;
    const float _s13 = -(nz * tangent_x);
    const float _s14 = (left_ex * _s12) + (left_ey * _s13);
    const float _s15 = left_bend_s * _s14;
    const float _s16 = (vx * tangent_x) + (vy * tangent_y);
    const float _s17 = (tangent_x * left_ex) + (tangent_y * left_ey);
    const float _s18 = left_bend_s * _s17;
    const float _s19 = (ny * tangent_x) - (nx * tangent_y);
    const float _s20 = ((vx * _s12) + (vy * _s13)) + (vz * _s19);
    const float _s21 = -(p_gravity * _s19);
    const float _s22 = _s20 - (t * _s21);
    const float _s23 = (_s15 * _s16) - (_s18 * _s22);
    const float _s24 = left_nz * left_ey;
    const float _s25 = -(left_nz * left_ex);
    const float _s26 = (left_ny * left_ex) - (left_nx * left_ey);
    const float _s27 = ((nx * _s24) + (ny * _s25)) + (nz * _s26);
    const float _s28 = (t * _s23) + _s27;
    const float _s29 = left_bend_e * _s19;
    const float _s30 = _s29 * _s16;
    const float _s31 = (nx * left_ex) + (ny * left_ey);
    const float _s32 = (t * _s30) + _s31;
    const float _s33 = t * _s10;
    const float _s34 = t * _s27;
    const float _s35 = ((((place_n * fabsf(_s11)) + (place_s * fabsf(_s28))) + (place_e * fabsf(_s32))) + (pace_n * fabsf(_s33))) + (pace_s * fabsf(_s34));
    const float _s36 = t * _s31;
    const float _s37 = p_gravity * t;
    const float _s38 = fabsf(vz);
    const float _s39 = (_s1 + _s4) + _s38;
    const float _s40 = (place_s * left_bend_s) + (place_e * left_bend_e);
    const float _s41 = (_s37 + _s39) * _s40;
    const float _s42 = ((float)7.62939453125e-06) * ((t * _s41) + _s9);
    const float _s43 = ((root_offset + ((((float)1.02) * (sharpest_bend * _s9)) * _s9)) + (_s35 + (pace_e * fabsf(_s36)))) + _s42;
    const float _s44 = fabsf(normal_velocity);
    const float _s45 = (((float)1.1) * _s43) / _s44;
    const float _s46 = ((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * (((_s37 + _s1) + _s4) + _s38));
    const float _s47 = velocity_bound + _s46;
    const float _s48 = (p_gravity * _s45) + _s47;
    const float _s49 = _s48 + _s39;
    const float _s50 = (_s45 * _s49) + _s9;
    const float _s51 = ((float)1.02) * sharpest_bend;
    const float _s52 = _s51 * _s50;
    const float _s53 = (((float)12.0) * (((fabsf(_s0) * _s45) + (_s52 * _s49)) + _s47)) - _s44;
    const float _s54 = (((float)100.0) * (sharpest_bend * _s50)) - ((float)1.0);
    const float _s55 = larger(_s53, _s54);
    const float _s56 = (_s6 * (_s45 * _s45)) + (_s45 * _s47);
    const float _s57 = ((_s52 * _s50) + _s56) / _s44;
    const float _s58 = (_s57 * _s39) + _s56;
    const float _s59 = (root_level + _s58) + (((fabsf(nx) * _s3) + (fabsf(ny) * _s5)) + (fabsf(nz) * _s8));
    const float _s60 = bend_s * _s59;
    const float _s61 = (((float)4194304.0) * ((place_n * left_bend_s) + _s60)) - ((float)1.0);
    const float _s62 = larger(_s55, _s61);
    const float _s63 = (p_inertia * (((float)1.0) + p_tangential_restitution)) / (((float)1.0) + p_inertia);
    const float _s64 = (fabsf(wx) + fabsf(wy)) + fabsf(wz);
    const float _s65 = ((float)1.125) * _s52;
    const float _s66 = spin_bound + (_s65 * (spin_bound + _s64));
    const float _s67 = (_s65 * _s49) + _s48;
    const float _s68 = (p_ball_radius * _s66) + _s67;
    const float _s69 = normal_rounding + _s60;
    const float _s70 = (normal_rounding * (_s39 + _s44)) + ((((float)2.0) * _s60) * _s44);
    const float _s71 = ((p_ball_radius * _s69) * _s64) + _s70;
    const float _s72 = _s68 + _s71;
    const float _s73 = _s69 * _s39;
    const float _s74 = ((float)1.0) + p_ring_restitution;
    const float _s75 = choose((p_ring_friction < ((float)INFINITE)), (p_ring_friction * _s74), ((float)0.0));
    const float _s76 = (p_ball_radius * _s64) + _s39;
    const float _s77 = _s63 * _s76;
    const float _s78 = ((((float)1.125) * ((_s63 * _s72) + ((_s73 + _s67) * _s75))) + (((float)3.552713678800501e-15) * (_s77 + (_s39 * _s75)))) - fabsf(slip_margin);
    const float _s79 = larger(_s62, _s78);
    const bool _s80 = slip_margin < ((float)0.0);
    const float _s81 = choose(_s80, ((((float)5.0) * ((((float)9.5367431640625e-07) * _s76) + _s72)) - slip_speed), ((float)-1.0));
    const float _s82 = ((float)1.0009765625) * _s59;
    const bool _s83 = larger(_s79, _s81) <= ((float)0.0);
    const float _s84 = (root_offset + _s42) / _s44;
    const float _s85 = (fabsf(_s20) * _s84) + (((fabsf(_s13) * _s5) + (fabsf(_s12) * _s3)) + (fabsf(_s19) * _s8));
    const float _s86 = (_s58 + (((float)7.62939453125e-06) * _s50)) + _s42;
    const float _s87 = ((float)1.0) / normal_velocity;
    const float _s88 = -(_s87 * _s11);
    const float _s89 = ((left_nx * _s12) + (left_ny * _s13)) + (left_nz * _s19);
    const float _s90 = (_s88 * _s20) + _s89;
    const float _s91 = -(_s87 * _s28);
    const float _s92 = normal_velocity - (t * _s0);
    const float _s93 = left_bend_s * _s31;
    const float _s94 = (_s18 * _s92) - (_s93 * _s16);
    const float _s95 = ((_s13 * _s25) + (_s12 * _s24)) + (_s19 * _s26);
    const float _s96 = (_s91 * _s20) + ((t * _s94) + _s95);
    const float _s97 = -(_s87 * _s32);
    const float _s98 = nz * left_bend_e;
    const float _s99 = -(_s98 * _s16);
    const float _s100 = (_s97 * _s20) + ((t * _s99) + _s14);
    const float _s101 = -(_s87 * _s33);
    const float _s102 = (_s101 * _s20) + (t * _s89);
    const float _s103 = -(_s87 * _s34);
    const float _s104 = (_s103 * _s20) + (t * _s95);
    const float _s105 = ((((place_n * fabsf(_s90)) + (place_s * fabsf(_s96))) + (place_e * fabsf(_s100))) + (pace_n * fabsf(_s102))) + (pace_s * fabsf(_s104));
    const float _s106 = -(_s87 * _s36);
    const float _s107 = (_s106 * _s20) + (t * _s14);
    const float _s108 = ((float)1.0009765625) * ((_s85 + _s86) + (_s105 + (pace_e * fabsf(_s107))));
    const float _s109 = fabsf(((float)0.0));
    const float _s110 = (fabsf(_s16) * _s84) + (((_s109 * _s8) + (fabsf(tangent_x) * _s3)) + (fabsf(tangent_y) * _s5));
    const float _s111 = (left_nx * tangent_x) + (left_ny * tangent_y);
    const float _s112 = (_s88 * _s16) + _s111;
    const float _s113 = (_s93 * _s22) - (_s15 * _s92);
    const float _s114 = (tangent_x * _s24) + (tangent_y * _s25);
    const float _s115 = (_s91 * _s16) + ((t * _s113) + _s114);
    const float _s116 = (_s98 * _s22) - (_s29 * _s92);
    const float _s117 = (_s97 * _s16) + ((t * _s116) + _s17);
    const float _s118 = (_s101 * _s16) + (t * _s111);
    const float _s119 = (_s103 * _s16) + (t * _s114);
    const float _s120 = ((((place_n * fabsf(_s112)) + (place_s * fabsf(_s115))) + (place_e * fabsf(_s117))) + (pace_n * fabsf(_s118))) + (pace_s * fabsf(_s119));
    const float _s121 = (_s106 * _s16) + (t * _s17);
    const float _s122 = ((float)1.0009765625) * ((_s110 + _s86) + (_s120 + (pace_e * fabsf(_s121))));
    const float _s123 = ((float)1.0) + (_s44 / p_restitution_speed);
    const float _s124 = p_ring_restitution * ((((float)1.0) / _s123) - ((_s44 * (((float)1.0) / p_restitution_speed)) / (_s123 * _s123)));
    const float _s125 = (p_gravity * _s84) + _s46;
    const float _s126 = -(bend_s * _s20);
    const float _s127 = bend_e * _s19;
    const float _s128 = _s127 * _s16;
    const float _s129 = _s125 + ((fabsf(_s126) * _s85) + (fabsf(_s128) * _s110));
    const float _s130 = choose(_s80, _s75, ((float)0.0));
    const float _s131 = ((((float)32.0) * _s63) * _s76) + ((((float)4.0) * _s39) * _s130);
    const float _s132 = ((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * ((((float)20.0) * _s76) + _s131));
    const float _s133 = p_ring_restitution / p_restitution_speed;
    const float _s134 = _s67 * _s67;
    const float _s135 = ((float)1.125) * ((_s63 * _s68) + (_s67 * _s130));
    const float _s136 = (bend_s + bend_e) * _s86;
    const float _s137 = _s77 + _s39;
    const float _s138 = (_s51 * _s58) + (((float)2.0) * (_s52 * _s52));
    const float _s139 = ((float)1.125) * _s138;
    const float _s140 = (p_gravity * _s57) + (((float)1.125) * ((_s52 * _s48) + (_s138 * _s39)));
    const float _s141 = ((((_s133 * _s134) + (_s65 * (_s67 + _s135))) + (_s136 * _s137)) + (_s139 * _s137)) + _s140;
    const float _s142 = ((float)4.0) * _s52;
    const float _s143 = (_s142 * _s39) + (((float)2.0) * (_s41 + _s48));
    const float _s144 = (_s142 * _s64) + (((float)2.0) * (spin_bound + (_s40 * _s64)));
    const float _s145 = ((float)2.0) * ((_s63 * ((p_ball_radius * _s144) + _s143)) + (_s143 * _s130));
    const float _s146 = ((float)1.125) * ((spin_bound * _s52) + (_s138 * _s64));
    const float _s147 = choose(_s80, (((_s68 / slip_speed) * (((((float)1.02) * _s67) * _s130) + ((((float)1.05) * slip_share) * _s68))) + ((p_ring_friction * _s133) * _s134)), ((float)0.0));
    const float _s148 = ((_s63 * ((p_ball_radius * _s146) + _s140)) + (_s140 * _s130)) + _s147;
    const float _s149 = (_s141 + (((float)7.62939453125e-06) * (_s143 + _s145))) + _s148;
    const float _s150 = ((float)1.125) * ((_s73 * _s130) + (_s63 * _s71));
    const float _s151 = -(_s0 * _s124);
    const float _s152 = -(_s124 * _s126);
    const float _s153 = -(_s124 * _s128);
    const float _s154 = fabsf(((((_s91 * _s151) + (-(_s124 * _s23))) - (_s152 * _s96)) - (_s153 * _s115)));
    const float _s155 = (place_n * fabsf((((_s88 * _s151) - (_s152 * _s90)) - (_s153 * _s112)))) + (place_s * _s154);
    const float _s156 = fabsf(((((_s97 * _s151) + (-(_s124 * _s30))) - (_s152 * _s100)) - (_s153 * _s117)));
    const float _s157 = fabsf(((((_s101 * _s151) + (-(_s124 * _s10))) - (_s152 * _s102)) - (_s153 * _s118)));
    const float _s158 = fabsf(((((_s103 * _s151) + (-(_s124 * _s27))) - (_s152 * _s104)) - (_s153 * _s119)));
    const float _s159 = fabsf(((((_s106 * _s151) + (-(_s124 * _s31))) - (_s152 * _s107)) - (_s153 * _s121)));
    const float _s160 = (((_s74 * _s70) + (fabsf((-_s124)) * _s129)) + ((_s132 + _s149) + _s150)) + ((((_s155 + (place_e * _s156)) + (pace_n * _s157)) + (pace_s * _s158)) + (pace_e * _s159));
    const float _s161 = ((float)1.0009765625) * _s160;
    const float _s162 = ((((normal_rounding * _s74) * _s44) + _s132) + _s149) + _s150;
    const float _s163 = ((slip_x * _s12) + (slip_y * _s13)) + (slip_z * _s19);
    const float _s164 = choose(_s80, slip_share, ((float)0.0));
    const float _s165 = -(_s163 * _s164);
    const float _s166 = slip_share + (_s165 * _s163);
    const float _s167 = bend_s * normal_velocity;
    const float _s168 = nz * bend_e;
    const float _s169 = -(_s168 * _s16);
    const float _s170 = _s125 + ((fabsf(_s167) * _s85) + (fabsf(_s169) * _s110));
    const float _s171 = (tangent_x * slip_x) + (tangent_y * slip_y);
    const float _s172 = -((p_ball_radius * _s171) * _s164);
    const float _s173 = _s172 * _s163;
    const float _s174 = ((nx * wx) + (ny * wy)) + (nz * wz);
    const float _s175 = bend_s * _s174;
    const float _s176 = fabsf(_s175);
    const float _s177 = (wx * tangent_x) + (wy * tangent_y);
    const float _s178 = -(_s168 * _s177);
    const float _s179 = (_s176 * _s85) + (fabsf(_s178) * _s110);
    const float _s180 = -(_s171 * _s164);
    const float _s181 = _s180 * _s163;
    const float _s182 = _s109 * _s85;
    const float _s183 = bend_e * ((nz * _s20) - (normal_velocity * _s19));
    const float _s184 = _s125 + (_s182 + (fabsf(_s183) * _s110));
    const float _s185 = choose(_s80, (p_ring_friction * (((float)1.0) + _s124)), ((float)0.0));
    const float _s186 = -_s185;
    const float _s187 = _s163 * _s186;
    const float _s188 = (((fabsf((((float)1.0) - _s166)) * _s170) + (fabsf((-_s173)) * _s179)) + (fabsf((-_s181)) * _s184)) + (fabsf((-_s187)) * _s129);
    const float _s189 = -p_ball_radius;
    const float _s190 = -((_s189 * _s163) * _s164);
    const float _s191 = (_s190 * _s163) + (slip_share * _s189);
    const float _s192 = ((wx * _s12) + (wy * _s13)) + (wz * _s19);
    const float _s193 = _s19 * _s174;
    const float _s194 = bend_e * ((nz * _s192) - _s193);
    const float _s195 = _s182 + (fabsf(_s194) * _s110);
    const float _s196 = -((_s0 * _s185) + ((_s21 * _s163) * _s164));
    const float _s197 = (_s196 * _s163) + (slip_share * _s21);
    const float _s198 = _s21 - _s197;
    const float _s199 = _s169 - (p_ball_radius * _s194);
    const float _s200 = (p_ball_radius * _s178) + _s183;
    const float _s201 = -((_s128 * _s185) + (((_s199 * _s163) + (_s200 * _s171)) * _s164));
    const float _s202 = (_s201 * _s163) + (slip_share * _s199);
    const float _s203 = _s169 - _s202;
    const float _s204 = p_ball_radius * _s175;
    const float _s205 = -((_s126 * _s185) + (((_s204 * _s171) + (_s167 * _s163)) * _s164));
    const float _s206 = (_s205 * _s163) + (slip_share * _s167);
    const float _s207 = _s167 - _s206;
    const float _s208 = (p_ball_radius * ((_s18 * _s174) - (_s93 * _s177))) + _s113;
    const float _s209 = _s94 - (p_ball_radius * ((_s93 * _s192) - (_s15 * _s174)));
    const float _s210 = -((_s23 * _s185) + (((_s208 * _s171) + (_s209 * _s163)) * _s164));
    const float _s211 = (_s210 * _s163) + (slip_share * _s209);
    const float _s212 = place_s * fabsf(((((_s91 * _s198) + (_s94 - _s211)) - (_s115 * _s203)) - (_s96 * _s207)));
    const float _s213 = (place_n * fabsf((((_s88 * _s198) - (_s112 * _s203)) - (_s90 * _s207)))) + _s212;
    const float _s214 = (p_ball_radius * (-(_s98 * _s177))) + _s116;
    const float _s215 = _s99 - (p_ball_radius * ((_s98 * _s192) - (_s29 * _s174)));
    const float _s216 = -((_s30 * _s185) + (((_s214 * _s171) + (_s215 * _s163)) * _s164));
    const float _s217 = (_s216 * _s163) + (slip_share * _s215);
    const float _s218 = place_e * fabsf(((((_s97 * _s198) + (_s99 - _s217)) - (_s117 * _s203)) - (_s100 * _s207)));
    const float _s219 = -((((_s111 * _s171) + (_s89 * _s163)) * _s164) + (_s10 * _s185));
    const float _s220 = (_s219 * _s163) + (slip_share * _s89);
    const float _s221 = pace_n * fabsf(((((_s101 * _s198) + (_s89 - _s220)) - (_s118 * _s203)) - (_s102 * _s207)));
    const float _s222 = ((float)1.0) / p_ball_radius;
    const float _s223 = _s95 - (p_ball_radius * (_s222 * _s17));
    const float _s224 = (p_ball_radius * (_s222 * _s14)) + _s114;
    const float _s225 = -((((_s223 * _s163) + (_s224 * _s171)) * _s164) + (_s27 * _s185));
    const float _s226 = (_s225 * _s163) + (slip_share * _s223);
    const float _s227 = pace_s * fabsf(((((_s103 * _s198) + (_s95 - _s226)) - (_s119 * _s203)) - (_s104 * _s207)));
    const float _s228 = _s14 - (p_ball_radius * (-(_s222 * _s114)));
    const float _s229 = (p_ball_radius * (-(_s222 * _s95))) + _s17;
    const float _s230 = -((_s31 * _s185) + (((_s228 * _s163) + (_s229 * _s171)) * _s164));
    const float _s231 = (_s230 * _s163) + (slip_share * _s228);
    const float _s232 = pace_e * fabsf(((((_s106 * _s198) + (_s14 - _s231)) - (_s121 * _s203)) - (_s107 * _s207)));
    const float _s233 = -(p_ball_radius * _s111);
    const float _s234 = p_ball_radius * _s89;
    const float _s235 = -(((_s233 * _s163) + (_s234 * _s171)) * _s164);
    const float _s236 = (_s235 * _s163) + (slip_share * _s233);
    const float _s237 = -(p_ball_radius * _s17);
    const float _s238 = p_ball_radius * _s14;
    const float _s239 = -(((_s237 * _s163) + (_s238 * _s171)) * _s164);
    const float _s240 = (_s239 * _s163) + (slip_share * _s237);
    const float _s241 = (((((_s213 + _s218) + _s221) + _s227) + _s232) + (turn_n * fabsf((-_s236)))) + (turn_z * fabsf((-_s240)));
    const float _s242 = -(p_ball_radius * _s114);
    const float _s243 = p_ball_radius * _s95;
    const float _s244 = -(((_s242 * _s163) + (_s243 * _s171)) * _s164);
    const float _s245 = (_s244 * _s163) + (slip_share * _s242);
    const float _s246 = (_s162 + (_s188 + (fabsf((-_s191)) * _s195))) + (_s241 + (turn_z * fabsf((-_s245))));
    const float _s247 = ((float)1.0009765625) * _s246;
    const float _s248 = slip_share + (_s180 * _s171);
    const float _s249 = _s190 * _s171;
    const float _s250 = _s165 * _s171;
    const float _s251 = _s171 * _s186;
    const float _s252 = (((fabsf((((float)1.0) - _s248)) * _s184) + (fabsf((-_s249)) * _s195)) + (fabsf((-_s250)) * _s170)) + (fabsf((-_s251)) * _s129);
    const float _s253 = (_s172 * _s171) + (p_ball_radius * slip_share);
    const float _s254 = _s171 * _s196;
    const float _s255 = -_s254;
    const float _s256 = (_s171 * _s201) + (slip_share * _s200);
    const float _s257 = _s183 - _s256;
    const float _s258 = (_s171 * _s205) + (slip_share * _s204);
    const float _s259 = -_s258;
    const float _s260 = (_s171 * _s210) + (slip_share * _s208);
    const float _s261 = place_s * fabsf(((((_s91 * _s255) + (_s113 - _s260)) - (_s115 * _s257)) - (_s96 * _s259)));
    const float _s262 = (place_n * fabsf((((_s88 * _s255) - (_s112 * _s257)) - (_s90 * _s259)))) + _s261;
    const float _s263 = (_s171 * _s216) + (slip_share * _s214);
    const float _s264 = place_e * fabsf(((((_s97 * _s255) + (_s116 - _s263)) - (_s117 * _s257)) - (_s100 * _s259)));
    const float _s265 = (_s171 * _s219) + (slip_share * _s111);
    const float _s266 = pace_n * fabsf(((((_s101 * _s255) + (_s111 - _s265)) - (_s118 * _s257)) - (_s102 * _s259)));
    const float _s267 = (_s171 * _s225) + (slip_share * _s224);
    const float _s268 = pace_s * fabsf(((((_s103 * _s255) + (_s114 - _s267)) - (_s119 * _s257)) - (_s104 * _s259)));
    const float _s269 = (_s171 * _s230) + (slip_share * _s229);
    const float _s270 = pace_e * fabsf(((((_s106 * _s255) + (_s17 - _s269)) - (_s121 * _s257)) - (_s107 * _s259)));
    const float _s271 = (_s235 * _s171) + (slip_share * _s234);
    const float _s272 = (_s239 * _s171) + (slip_share * _s238);
    const float _s273 = (((((_s262 + _s264) + _s266) + _s268) + _s270) + (turn_n * fabsf((-_s271)))) + (turn_z * fabsf((-_s272)));
    const float _s274 = (_s244 * _s171) + (slip_share * _s243);
    const float _s275 = (_s162 + (_s252 + (fabsf((-_s253)) * _s179))) + (_s273 + (turn_z * fabsf((-_s274))));
    const float _s276 = ((float)1.0009765625) * _s275;
    const float _s277 = -(bend_s * _s192);
    const float _s278 = _s127 * _s177;
    const float _s279 = ((float)1.0) / (p_ball_radius * p_inertia);
    const float _s280 = (_s77 * _s279) + _s64;
    const float _s281 = (((_s65 * ((_s135 * _s279) + _s66)) + (_s136 * _s280)) + (_s139 * _s280)) + (_s148 * _s279);
    const float _s282 = (((((_s63 * _s69) * _s76) + _s150) * _s279) + (((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * ((_s131 * _s279) + (((float)4.0) * _s64))))) + ((_s281 + (((float)7.62939453125e-06) * ((_s279 * _s145) + _s144))) + _s146);
    const float _s283 = place_s * fabsf(((((_s15 * _s177) - (_s18 * _s192)) - (_s277 * _s96)) - (_s278 * _s115)));
    const float _s284 = (place_n * fabsf((-((_s277 * _s90) + (_s278 * _s112))))) + _s283;
    const float _s285 = _s284 + (place_e * fabsf((((_s29 * _s177) - (_s277 * _s100)) - (_s278 * _s117))));
    const float _s286 = _s285 + (pace_n * fabsf((-((_s277 * _s102) + (_s278 * _s118)))));
    const float _s287 = _s286 + (pace_s * fabsf((((_s222 * _s31) - (_s277 * _s104)) - (_s278 * _s119))));
    const float _s288 = pace_e * fabsf((((-(_s222 * _s27)) - (_s277 * _s107)) - (_s278 * _s121)));
    const float _s289 = (((fabsf(_s277) * _s85) + (fabsf(_s278) * _s110)) + _s282) + ((((_s287 + _s288) + (turn_n * fabsf(_s10))) + (turn_z * fabsf(_s31))) + (turn_z * fabsf(_s27)));
    const float _s290 = ((float)1.0009765625) * _s289;
    const float _s291 = ((float)1.0) + (((float)1.0) / p_inertia);
    const float _s292 = (fabsf((_s222 * (-(_s249 * _s291)))) * _s195) + (fabsf((_s222 * (-(_s250 * _s291)))) * _s170);
    const float _s293 = _s292 + (fabsf((_s222 * (-(_s251 * _s291)))) * _s129);
    const float _s294 = _s293 + (fabsf((_s222 * (((float)1.0) - (_s291 * _s248)))) * _s184);
    const float _s295 = _s294 + (fabsf((_s222 * (p_ball_radius - (_s291 * _s253)))) * _s179);
    const float _s296 = fabsf((-(_s222 * (-(_s173 * _s291))))) * _s179;
    const float _s297 = fabsf((-(_s222 * (-(_s181 * _s291))))) * _s184;
    const float _s298 = fabsf((-(_s222 * (-(_s187 * _s291))))) * _s129;
    const float _s299 = fabsf((-(_s222 * (((float)1.0) - (_s291 * _s166))))) * _s170;
    const float _s300 = fabsf((-(_s222 * (_s189 - (_s291 * _s191))))) * _s195;
    const float _s301 = (((_s296 + _s297) + _s298) + _s299) + _s300;
    const float _s302 = _s222 * (-(_s254 * _s291));
    const float _s303 = _s222 * (_s204 - (_s291 * _s258));
    const float _s304 = _s222 * (_s200 - (_s291 * _s256));
    const float _s305 = (((_s302 * _s91) + (_s222 * (_s208 - (_s291 * _s260)))) - (_s303 * _s96)) - (_s304 * _s115);
    const float _s306 = (place_n * fabsf((((_s302 * _s88) - (_s303 * _s90)) - (_s304 * _s112)))) + (place_s * fabsf(_s305));
    const float _s307 = (((_s302 * _s97) + (_s222 * (_s214 - (_s291 * _s263)))) - (_s303 * _s100)) - (_s304 * _s117);
    const float _s308 = (((_s302 * _s101) + (_s222 * (_s111 - (_s291 * _s265)))) - (_s303 * _s102)) - (_s304 * _s118);
    const float _s309 = (((_s302 * _s103) + (_s222 * (_s224 - (_s291 * _s267)))) - (_s303 * _s104)) - (_s304 * _s119);
    const float _s310 = (((_s302 * _s106) + (_s222 * (_s229 - (_s291 * _s269)))) - (_s303 * _s107)) - (_s304 * _s121);
    const float _s311 = (((_s306 + (place_e * fabsf(_s307))) + (pace_n * fabsf(_s308))) + (pace_s * fabsf(_s309))) + (pace_e * fabsf(_s310));
    const float _s312 = _s311 + (turn_n * fabsf((_s222 * (_s234 - (_s291 * _s271)))));
    const float _s313 = _s312 + (turn_z * fabsf((_s222 * (_s238 - (_s291 * _s272)))));
    const float _s314 = _s313 + (turn_z * fabsf((_s222 * (_s243 - (_s291 * _s274)))));
    const float _s315 = -(_s222 * (_s21 - (_s291 * _s197)));
    const float _s316 = -(_s222 * (_s167 - (_s291 * _s206)));
    const float _s317 = -(_s222 * (_s199 - (_s291 * _s202)));
    const float _s318 = ((_s315 * _s91) + (-(_s222 * (_s209 - (_s291 * _s211))))) - (_s316 * _s96);
    const float _s319 = (place_n * fabsf((((_s315 * _s88) - (_s316 * _s90)) - (_s317 * _s112)))) + (place_s * fabsf((_s318 - (_s317 * _s115))));
    const float _s320 = ((_s315 * _s97) + (-(_s222 * (_s215 - (_s291 * _s217))))) - (_s316 * _s100);
    const float _s321 = ((_s315 * _s101) + (-(_s222 * (_s89 - (_s291 * _s220))))) - (_s316 * _s102);
    const float _s322 = (_s319 + (place_e * fabsf((_s320 - (_s317 * _s117))))) + (pace_n * fabsf((_s321 - (_s317 * _s118))));
    const float _s323 = ((_s315 * _s103) + (-(_s222 * (_s223 - (_s291 * _s226))))) - (_s316 * _s104);
    const float _s324 = ((_s315 * _s106) + (-(_s222 * (_s228 - (_s291 * _s231))))) - (_s316 * _s107);
    const float _s325 = (_s322 + (pace_s * fabsf((_s323 - (_s317 * _s119))))) + (pace_e * fabsf((_s324 - (_s317 * _s121))));
    const float _s326 = turn_n * fabsf((-(_s222 * (_s233 - (_s291 * _s236)))));
    const float _s327 = turn_z * fabsf((-(_s222 * (_s237 - (_s291 * _s240)))));
    const float _s328 = turn_z * fabsf((-(_s222 * (_s242 - (_s291 * _s245)))));
    const float _s329 = ((_s325 + _s326) + _s327) + _s328;
    const float _s330 = ((float)1.0009765625) * ((((_s222 * _s162) + _s282) + larger(_s295, _s301)) + larger(_s314, _s329));
    const float _s331 = larger(_s82, _s108);
    const float _s332 = choose(_s83, (((float)1.0009765625) * ((((float)0.421875) * ((_s82 + _s122) + _s108)) + (((float)0.578125) * larger(_s331, _s122)))), ((float)INFINITE));
    const float _s333 = _s109 * _s108;
    const float _s334 = slip_share * (_s20 - (p_ball_radius * _s177));
    const float _s335 = _s20 - _s334;
    const float _s336 = _s44 * (p_ring_restitution / _s123);
    const float _s337 = _s333 + (fabsf((bend_e * ((nz * _s335) - (_s336 * _s19)))) * _s122);
    const float _s338 = ((float)7.62939453125e-06) * ((bend_s * _s108) + (bend_e * _s122));
    const float _s339 = _s137 * _s338;
    const float _s340 = (_s337 + _s339) + _s276;
    const float _s341 = slip_share * ((p_ball_radius * _s192) + _s16);
    const float _s342 = _s16 - _s341;
    const float _s343 = ((fabsf((bend_s * _s336)) * _s108) + (fabsf((-(_s168 * _s342))) * _s122)) + _s339;
    const float _s344 = _s343 + _s247;
    const float _s345 = ((fabsf((-(bend_s * _s335))) * _s108) + (fabsf((_s127 * _s342)) * _s122)) + _s339;
    const float _s346 = _s345 + _s161;
    const float _s347 = larger(_s346, _s344);
    const float _s348 = choose(_s83, (((float)1.0009765625) * ((((float)0.421875) * ((_s340 + _s344) + _s346)) + (((float)0.578125) * larger(_s347, _s340)))), ((float)INFINITE));
    const float _s349 = _s192 - (_s341 * _s279);
    const float _s350 = (_s334 * _s279) + _s177;
    const float _s351 = _s280 * _s338;
    const float _s352 = ((fabsf((-(bend_s * _s349))) * _s108) + (fabsf((_s127 * _s350)) * _s122)) + _s351;
    const float _s353 = _s352 + _s290;
    const float _s354 = (((_s276 / p_ball_radius) + (_s176 * _s108)) + (fabsf((-(_s168 * _s350))) * _s122)) + _s351;
    const float _s355 = _s354 + _s330;
    const float _s356 = ((_s247 / p_ball_radius) + _s333) + (fabsf((bend_e * ((nz * _s349) - _s193))) * _s122);
    const float _s357 = (_s356 + _s351) + _s330;
    const float _s358 = larger(_s353, _s355);
    const float _s359 = choose(_s83, (((float)1.0009765625) * ((((float)0.421875) * ((_s353 + _s355) + _s357)) + (((float)0.578125) * larger(_s358, _s357)))), ((float)INFINITE));
    return {choose(_s83, _s82, ((float)INFINITE)), choose(_s83, _s108, ((float)INFINITE)), choose(_s83, _s122, ((float)INFINITE)), choose(_s83, _s161, ((float)INFINITE)), choose(_s83, _s247, ((float)INFINITE)), choose(_s83, _s276, ((float)INFINITE)), choose(_s83, _s290, ((float)INFINITE)), choose(_s83, _s330, ((float)INFINITE)), _s332, _s348, _s359, nx, ny, nz, tangent_x, tangent_y, bend_s, bend_e, (((float)4.440892098500626e-16) * (t + clock)) + choose(_s83, (((float)1.0009765625) * _s45), ((float)INFINITE))};
}

/* Velocity and spin after a contact, frame-free.
   momentum, angular momentum and Coulomb's law of friction. 85 operations: 10 additions, 19 subtractions, 43 multiplications, 5 divisions, 1 square root, 1 negation, 3 comparisons, 3 selections. */
struct kernel_ring_impact_out {
    double vx, vy, vz, wx, wy, wz;
};

static __device__ __forceinline__ kernel_ring_impact_out kernel_ring_impact(double vx, double vy, double vz, double wx, double wy, double wz, double nx, double ny, double nz, double p_ball_radius, double p_ring_restitution, double p_ring_friction, double p_inertia, double p_tangential_restitution, double p_restitution_speed)
{
    const double _s0 = ((nx * vx) + (ny * vy)) + (nz * vz);
    const double _s1 = vx - (nx * _s0);
    const double _s2 = _s1 - (p_ball_radius * ((nz * wy) - (ny * wz)));
    const double _s3 = vz - (nz * _s0);
    const double _s4 = _s3 - (p_ball_radius * ((ny * wx) - (nx * wy)));
    const double _s5 = vy - (ny * _s0);
    const double _s6 = _s5 - (p_ball_radius * ((nx * wz) - (nz * wx)));
    const double _s7 = ((_s4 * _s4) + (_s6 * _s6)) + (_s2 * _s2);
    const double _s8 = (p_inertia * (1.0 + p_tangential_restitution)) / (1.0 + p_inertia);
    const double _s9 = p_ring_restitution / (1.0 - (_s0 / p_restitution_speed));
    const double _s10 = -(p_ring_friction * ((1.0 + _s9) * _s0));
    const double _s11 = choose((0.0 < p_ring_friction), choose((p_ring_friction < (INFINITE)), choose(((_s7 * (_s8 * _s8)) <= (_s10 * _s10)), _s8, (_s10 / sqrt(_s7))), _s8), 0.0);
    const double _s12 = _s11 / (p_ball_radius * p_inertia);
    return {(_s1 - (_s2 * _s11)) - ((nx * _s9) * _s0), (_s5 - (_s6 * _s11)) - ((ny * _s9) * _s0), (_s3 - (_s4 * _s11)) - ((nz * _s9) * _s0), wx + (_s12 * ((ny * _s4) - (nz * _s6))), wy + (_s12 * ((nz * _s2) - (nx * _s4))), wz + (_s12 * ((nx * _s6) - (ny * _s2)))};
}

/* Errors of velocity and spin after a contact, from those before it.
   derivative of the contact with friction, with roundings. 313 operations: 61 additions, 38 subtractions, 127 multiplications, 11 divisions, 1 square root, 13 negations, 18 absolute values, 19 comparisons, 25 selections. */
struct kernel_carry_ring_impact_out {
    double dvx, dvy, dvz, dwx, dwy, dwz;
};

static __device__ __forceinline__ kernel_carry_ring_impact_out kernel_carry_ring_impact(double vx, double vy, double vz, double wx, double wy, double wz, double nx, double ny, double nz, double dvx, double dvy, double dvz, double dwx, double dwy, double dwz, double dnx, double dny, double dnz, double turn, double lifting, double p_ball_radius, double p_ring_restitution, double p_ring_friction, double p_inertia, double p_tangential_restitution, double p_restitution_speed)
{
    const double _s0 = (((nx * dvx) + (vx * dnx)) + ((ny * dvy) + (vy * dny))) + ((nz * dvz) + (vz * dnz));
    const double _s1 = ((nx * vx) + (ny * vy)) + (nz * vz);
    const double _s2 = dvx - ((nx * _s0) + (dnx * _s1));
    const double _s3 = (vx - (nx * _s1)) - (p_ball_radius * ((nz * wy) - (ny * wz)));
    const double _s4 = (vz - (nz * _s1)) - (p_ball_radius * ((ny * wx) - (nx * wy)));
    const double _s5 = (vy - (ny * _s1)) - (p_ball_radius * ((nx * wz) - (nz * wx)));
    const double _s6 = ((_s4 * _s4) + (_s5 * _s5)) + (_s3 * _s3);
    const double _s7 = (p_inertia * (1.0 + p_tangential_restitution)) / (1.0 + p_inertia);
    const double _s8 = 1.0 - (_s1 / p_restitution_speed);
    const double _s9 = p_ring_restitution / _s8;
    const double _s10 = 1.0 + _s9;
    const double _s11 = -(p_ring_friction * (_s10 * _s1));
    const double _s12 = -((p_ring_restitution * (-(_s0 / p_restitution_speed))) / (_s8 * _s8));
    const double _s13 = sqrt(_s6);
    const double _s14 = dvz - ((nz * _s0) + (dnz * _s1));
    const double _s15 = _s14 - (p_ball_radius * (((ny * dwx) + (wx * dny)) - ((nx * dwy) + (wy * dnx))));
    const double _s16 = dvy - ((ny * _s0) + (dny * _s1));
    const double _s17 = _s16 - (p_ball_radius * (((nx * dwz) + (wz * dnx)) - ((nz * dwx) + (wx * dnz))));
    const double _s18 = _s2 - (p_ball_radius * (((nz * dwy) + (wy * dnz)) - ((ny * dwz) + (wz * dny))));
    const double _s19 = ((0.5 * _s11) * ((((2.0 * _s4) * _s15) + ((2.0 * _s5) * _s17)) + ((2.0 * _s3) * _s18))) / (_s13 * _s6);
    const double _s20 = ((-(p_ring_friction * ((_s10 * _s0) + (_s12 * _s1)))) / _s13) - _s19;
    const bool _s21 = (_s6 * (_s7 * _s7)) <= (_s11 * _s11);
    const bool _s22 = p_ring_friction < (INFINITE);
    const bool _s23 = 0.0 < p_ring_friction;
    const double _s24 = choose(_s23, choose(_s22, choose(_s21, 0.0, _s20), 0.0), 0.0);
    const double _s25 = choose(_s23, choose(_s22, choose(_s21, _s7, (_s11 / _s13)), _s7), 0.0);
    const double _s26 = (_s2 - ((_s3 * _s24) + (_s18 * _s25))) - ((((nx * _s9) * _s0) + ((nx * _s12) * _s1)) + ((dnx * _s9) * _s1));
    const double _s27 = ((p_ball_radius * ((fabs(wx) + fabs(wy)) + fabs(wz))) + fabs(vx)) + fabs(vy);
    const double _s28 = _s27 + fabs(vz);
    const double _s29 = 7.888609052210118e-31 + (2.220446049250313e-16 * _s28);
    const double _s30 = fabs(_s26) + _s29;
    const double _s31 = fabs(dwx);
    const double _s32 = fabs(dwy);
    const double _s33 = larger(_s31, _s32);
    const double _s34 = fabs(dwz);
    const double _s35 = fabs(dvx);
    const double _s36 = fabs(dvy);
    const double _s37 = larger(_s35, _s36);
    const double _s38 = fabs(dvz);
    const double _s39 = lifting * (((p_ball_radius * larger(_s33, _s34)) + (turn * _s28)) + larger(_s37, _s38));
    const double _s40 = larger(_s30, _s39);
    const bool _s41 = _s26 < 0.0;
    const double _s42 = _s40 - _s30;
    const double _s43 = (_s16 - ((_s5 * _s24) + (_s17 * _s25))) - ((((ny * _s9) * _s0) + ((ny * _s12) * _s1)) + ((dny * _s9) * _s1));
    const double _s44 = fabs(_s43) + _s29;
    const double _s45 = larger(_s44, _s39);
    const double _s46 = _s45 - _s44;
    const bool _s47 = _s43 < 0.0;
    const double _s48 = (_s14 - ((_s4 * _s24) + (_s15 * _s25))) - ((((nz * _s9) * _s0) + ((nz * _s12) * _s1)) + ((dnz * _s9) * _s1));
    const double _s49 = fabs(_s48) + _s29;
    const double _s50 = larger(_s49, _s39);
    const double _s51 = _s50 - _s49;
    const bool _s52 = _s48 < 0.0;
    const double _s53 = ((nx * choose(_s41, (-_s42), _s42)) + (ny * choose(_s47, (-_s46), _s46))) + (nz * choose(_s52, (-_s51), _s51));
    const double _s54 = p_ball_radius * p_inertia;
    const double _s55 = _s24 / _s54;
    const double _s56 = _s25 / _s54;
    const double _s57 = dwx + ((_s55 * ((ny * _s4) - (nz * _s5))) + (_s56 * (((ny * _s15) + (dny * _s4)) - ((nz * _s17) + (dnz * _s5)))));
    const double _s58 = 1.0 / p_ball_radius;
    const double _s59 = _s58 * _s29;
    const double _s60 = fabs(_s57) + _s59;
    const double _s61 = _s58 * _s39;
    const double _s62 = larger(_s60, _s61);
    const double _s63 = dwy + ((_s55 * ((nz * _s3) - (nx * _s4))) + (_s56 * (((nz * _s18) + (dnz * _s3)) - ((nx * _s15) + (dnx * _s4)))));
    const double _s64 = fabs(_s63) + _s59;
    const double _s65 = larger(_s64, _s61);
    const double _s66 = dwz + ((_s55 * ((nx * _s5) - (ny * _s3))) + (_s56 * (((nx * _s17) + (dnx * _s5)) - ((ny * _s18) + (dny * _s3)))));
    const double _s67 = fabs(_s66) + _s59;
    const double _s68 = larger(_s67, _s61);
    return {choose(_s41, (-_s40), _s40) - (nx * _s53), choose(_s47, (-_s45), _s45) - (ny * _s53), choose(_s52, (-_s50), _s50) - (nz * _s53), choose((_s57 < 0.0), (-_s62), _s62), choose((_s63 < 0.0), (-_s65), _s65), choose((_s66 < 0.0), (-_s68), _s68)};
}

/* Outward unit normal n3 at a contact.
   Table 2. 13 operations: 2 additions, 1 subtraction, 7 multiplications, 2 divisions, 1 square root. */
struct kernel_ring_normal_out {
    double nx, ny, nz;
};

static __device__ __forceinline__ kernel_ring_normal_out kernel_ring_normal(double x, double y, double z, double p_ball_radius, double p_ring_radius, double p_wire_radius)
{
    const double _s0 = 1.0 / (p_ball_radius + p_wire_radius);
    const double _s1 = sqrt(((x * x) + (y * y)));
    const double _s2 = (_s0 * (_s1 - p_ring_radius)) * (1.0 / _s1);
    return {x * _s2, y * _s2, z * _s0};
}

/* Bound on the rate at which the normal turns along the contact surface.
   Table 2. 6 operations: 1 addition, 2 subtractions, 1 division, 1 comparison, 1 selection. */
struct kernel_ring_curvature_out {
    double curvature;
};

static __device__ __forceinline__ kernel_ring_curvature_out kernel_ring_curvature(double p_ball_radius, double p_ring_radius, double p_wire_radius)
{
    const double _s0 = (p_ring_radius - p_ball_radius) - p_wire_radius;
    const double _s1 = p_ball_radius + p_wire_radius;
    return {1.0 / smaller(_s0, _s1)};
}

/* Tangent and curvatures at a contact, and bounds on the roundings there.
   Table 2, running error analysis. 123 operations: 37 additions, 2 subtractions, 45 multiplications, 6 divisions, 3 square roots, 1 negation, 11 absolute values, 8 comparisons, 10 selections. */
struct kernel_ring_tangents_out {
    float tangent_x, tangent_y, bend_s, bend_e, sharpest_bend, root_offset, root_level, normal_rounding;
};

static __device__ __forceinline__ kernel_ring_tangents_out kernel_ring_tangents(float t, float x, float y, float z, float vx, float vy, float vz, float nx, float ny, float nz, float place_n, float normal_velocity, float back, float p_ball_radius, float p_ring_radius, float p_wire_radius, float p_gravity)
{
    const float _s0 = sqrtf(((x * x) + (y * y)));
    const float _s1 = ((float)1.0) / _s0;
    const float _s2 = p_ball_radius + p_wire_radius;
    const float _s3 = ((float)1.0) / _s2;
    const float _s4 = (p_ring_radius - p_ball_radius) - p_wire_radius;
    const float _s5 = smaller(_s4, _s2);
    const float _s6 = p_gravity * t;
    const float _s7 = vz + _s6;
    const float _s8 = fabsf(vx);
    const float _s9 = fabsf(vy);
    const float _s10 = fabsf(vz);
    const float _s11 = t * ((((float)2.0) * ((sqrtf(p_gravity) * sqrtf(_s2)) + larger(((float)0.0), _s7))) + (((_s6 + _s8) + _s9) + _s10));
    const float _s12 = ((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * (t * fabsf(normal_velocity)));
    const float _s13 = t * t;
    const float _s14 = (p_gravity * _s13) + (t * ((_s8 + _s9) + _s10));
    const float _s15 = ((float)2.0) * t;
    const float _s16 = ((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * ((_s15 * _s8) + fabsf(x)));
    const float _s17 = ((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * ((_s15 * _s9) + fabsf(y)));
    const float _s18 = ((float)0.5) * p_gravity;
    const float _s19 = ((_s18 * _s13) + (_s15 * fabsf((vz + (_s18 * t))))) + fabsf(z);
    const float _s20 = ((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * _s19);
    const float _s21 = ((float)2.0) * (p_ring_radius * _s3);
    const float _s22 = (((((float)1.5) * _s14) * ((_s16 + _s17) + _s20)) / _s5) + ((((float)1.1102230246251565e-16) * (((float)16.0) + _s21)) * _s14);
    const float _s23 = ((float)1.125) * _s22;
    const float _s24 = ((float)1.7763568394002505e-15) * (((normal_velocity * normal_velocity) / (((vx * vx) + (vy * vy)) + (vz * vz))) * _s2);
    const float _s25 = (_s12 + _s22) + larger(_s23, _s24);
    const float _s26 = (((float)1.1102230246251565e-16) * ((((float)3.5) * _s2) + (((float)2.0) * _s0))) + (((fabsf(nx) * _s16) + (fabsf(ny) * _s17)) + (fabsf(nz) * _s20));
    const float _s27 = ((float)1.125) * _s26;
    const float _s28 = (_s12 + _s26) + larger(_s27, _s24);
    const float _s29 = place_n + _s28;
    const bool _s30 = (((float)4.0) * (_s11 / _s5)) <= ((float)1.0);
    const bool _s31 = ((float)0.0) < back;
    const float _s32 = place_n + _s25;
    return {-(y * _s1), x * _s1, _s3, _s1, ((float)1.0) / _s5, choose(_s31, choose(_s30, _s25, larger(_s25, _s29)), _s28), choose(_s31, choose(_s30, _s32, larger(_s32, _s28)), _s28), ((float)1.1102230246251565e-16) * (((float)7.0) + _s21)};
}

/* Error of the normal, from that of the position.
   derivative of Table 2's normal. 34 operations: 6 additions, 3 subtractions, 18 multiplications, 3 divisions, 1 square root, 1 negation, 1 comparison, 1 selection. */
struct kernel_ring_carry_normal_out {
    double dnx, dny, dnz, turn;
};

static __device__ __forceinline__ kernel_ring_carry_normal_out kernel_ring_carry_normal(double x, double y, double dx, double dy, double dz, double shift, double p_ball_radius, double p_ring_radius, double p_wire_radius)
{
    const double _s0 = p_ball_radius + p_wire_radius;
    const double _s1 = 1.0 / _s0;
    const double _s2 = sqrt(((x * x) + (y * y)));
    const double _s3 = 1.0 / _s2;
    const double _s4 = ((x * dx) + (y * dy)) * _s3;
    const double _s5 = _s2 - p_ring_radius;
    const double _s6 = _s1 * ((_s4 * _s3) + ((-(_s4 * (_s3 * _s3))) * _s5));
    const double _s7 = (_s1 * _s5) * _s3;
    const double _s8 = (p_ring_radius - p_ball_radius) - p_wire_radius;
    return {(x * _s6) + (dx * _s7), (y * _s6) + (dy * _s7), dz * _s1, shift * (1.0 / smaller(_s8, _s0))};
}

/* Positive if errors of the state exceed those that a search allows for.
   running error analysis. 26 operations: 6 additions, 3 subtractions, 10 multiplications, 1 division, 3 comparisons, 3 selections. */
struct kernel_ring_excess_out {
    double excess;
};

static __device__ __forceinline__ kernel_ring_excess_out kernel_ring_excess(double share, double horizon, double extent, double speed, double position_error, double velocity_error, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_gravity)
{
    const double _s0 = speed + (p_gravity * horizon);
    const double _s1 = horizon * _s0;
    const double _s2 = (position_error + (horizon * velocity_error)) - (share * (_s1 + (extent + _s1)));
    const double _s3 = 1.00006103515625 * (p_ball_radius + p_wire_radius);
    const double _s4 = p_ring_radius - _s3;
    const double _s5 = 0.0001220703125 * p_ring_radius;
    const double _s6 = _s3 / larger(_s4, _s5);
    const double _s7 = ((_s0 * larger(1.0, _s6)) * _s2) + (_s3 * (velocity_error - (share * _s0)));
    return {larger(_s2, _s7)};
}

/* Positive if there is certainly no contact before the horizon.
   bounds of the event condition. 146 operations: 27 additions, 19 subtractions, 67 multiplications, 1 division, 2 square roots, 15 comparisons, 15 selections. */
struct kernel_ring_clear_out {
    double clear;
};

static __device__ __forceinline__ kernel_ring_clear_out kernel_ring_clear(double horizon, double x, double y, double z, double vx, double vy, double vz, double extent, double speed, double position_error, double velocity_error, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_gravity)
{
    const double _s0 = p_ball_radius + p_wire_radius;
    const double _s1 = (0.000244140625 * p_ring_radius) - (p_ring_radius - _s0);
    const double _s2 = position_error + (horizon * velocity_error);
    const double _s3 = (_s2 - (1.52587890625e-05 * p_ball_radius)) - (1.52587890625e-05 * p_wire_radius);
    const double _s4 = 1.00006103515625 * _s0;
    const double _s5 = p_ring_radius + _s4;
    const double _s6 = vz * vz;
    const double _s7 = _s6 + ((2.0 * p_gravity) * (z - _s4));
    const double _s8 = 1.0 / p_gravity;
    const double _s9 = sqrt(_s7);
    const double _s10 = _s8 * (vz - _s9);
    const double _s11 = _s8 * (vz + _s9);
    const double _s12 = x + (vx * _s11);
    const double _s13 = y + (vy * _s11);
    const double _s14 = (_s12 * _s12) + (_s13 * _s13);
    const double _s15 = sqrt(_s14);
    const double _s16 = _s15 - p_ring_radius;
    const double _s17 = z + ((vz - ((0.5 * p_gravity) * _s11)) * _s11);
    const double _s18 = _s5 * _s5;
    const double _s19 = 9.313225746154785e-10 * _s18;
    const double _s20 = (((_s16 * _s16) + (_s17 * _s17)) - (_s0 * _s0)) - _s19;
    const double _s21 = (vx * vx) + (vy * vy);
    const double _s22 = p_ring_radius - _s4;
    const double _s23 = 0.0001220703125 * p_ring_radius;
    const double _s24 = larger(_s22, _s23);
    const double _s25 = _s24 * _s24;
    const double _s26 = _s24 * _s25;
    const double _s27 = ((((2.0 * _s6) + ((4.0 * p_gravity) * z)) + (2.0 * _s21)) - ((6.0003662109375 * p_gravity) * _s0)) * _s26;
    const double _s28 = (x * vy) - (y * vx);
    const double _s29 = _s28 * _s28;
    const double _s30 = _s27 - ((2.0 * p_ring_radius) * _s29);
    const double _s31 = (_s16 * ((vx * _s12) + (vy * _s13))) + ((_s17 * (vz - (p_gravity * _s11))) * _s15);
    const double _s32 = x + (vx * horizon);
    const double _s33 = y + (vy * horizon);
    const double _s34 = choose(((((_s19 + (_s32 * _s32)) + (_s33 * _s33)) - _s25) < 0.0), 1.0, choose((((_s21 * (_s19 + _s25)) - _s29) < 0.0), 1.0, 0.0));
    const double _s35 = choose(((((4.0 * (_s31 * _s31)) * _s26) - (((2.0 * _s30) * _s14) * _s20)) < 0.0), _s34, 0.0);
    const double _s36 = choose((horizon < (_s11 - (9.313225746154785e-10 * horizon))), 1.0, choose((0.0 < _s20), choose((0.0 < _s30), _s35, 0.0), 0.0));
    const double _s37 = (x * vx) + (y * vy);
    const double _s38 = (_s10 * _s21) + _s37;
    const double _s39 = choose((_s38 < 0.0), choose((_s18 < ((_s10 * (_s37 + _s38)) + ((x * x) + (y * y)))), _s36, 0.0), 0.0);
    const double _s40 = choose(((extent + (horizon * (speed + (p_gravity * horizon)))) < (65536.0 * _s5)), choose((0.0 < _s7), choose((_s10 < 0.0), _s36, _s39), 0.0), 0.0);
    return {choose((0.0 < larger(_s1, _s3)), 0.0, choose((_s2 < (5.820766091346741e-11 * _s5)), _s40, 0.0))};
}

/* Constants and windows of the search along a flight, and its error budget.
   bounds of the event condition. 190 operations: 31 additions, 20 subtractions, 54 multiplications, 3 divisions, 7 square roots, 1 negation, 5 absolute values, 31 comparisons, 38 selections. */
struct kernel_ring_prepare_out {
    double energy2, moment2, rho_start, low0, high0, low1, high1, low2, high2, ceiling, latest, budget_exceeded;
};

static __device__ __forceinline__ kernel_ring_prepare_out kernel_ring_prepare(double horizon, double x, double y, double z, double vx, double vy, double vz, double extent, double speed, double position_error, double velocity_error, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_gravity)
{
    const double _s0 = vz * vz;
    const double _s1 = (vx * vx) + (vy * vy);
    const double _s2 = ((2.0 * _s0) + ((4.0 * p_gravity) * z)) + (2.0 * _s1);
    const double _s3 = (x * vy) - (y * vx);
    const double _s4 = _s3 * _s3;
    const double _s5 = (2.0 * p_ring_radius) * _s4;
    const double _s6 = (x * x) + (y * y);
    const double _s7 = p_ball_radius + p_wire_radius;
    const double _s8 = 1.00006103515625 * _s7;
    const double _s9 = 2.0 * p_gravity;
    const double _s10 = 8.881784197001252e-16 * (_s0 + (_s9 * (fabs(z) + _s8)));
    const double _s11 = (_s0 + (_s9 * (z + _s8))) + _s10;
    const double _s12 = 1.0 / p_gravity;
    const double _s13 = sqrt(_s11);
    const double _s14 = 1.7763568394002505e-15 * (fabs(vz) + _s13);
    const bool _s15 = 0.0 <= _s11;
    const double _s16 = choose(_s15, (_s12 * ((vz - _s13) - _s14)), (INFINITE));
    const double _s17 = p_ring_radius + _s8;
    const double _s18 = _s17 * _s17;
    const double _s19 = (1.7763568394002505e-15 * _s1) * (_s18 + _s6);
    const double _s20 = ((_s18 * _s1) + _s19) - _s4;
    const double _s21 = (x * vx) + (y * vy);
    const double _s22 = sqrt(_s20);
    const double _s23 = 1.7763568394002505e-15 * ((fabs(_s21) + fabs(_s3)) + _s22);
    const double _s24 = 1.0 / _s1;
    const bool _s25 = 0.0 <= _s20;
    const bool _s26 = 2.409919865102884e-181 < _s1;
    const double _s27 = choose(_s26, choose(_s25, ((-((_s21 + _s22) + _s23)) * _s24), (INFINITE)), (-INFINITE));
    const double _s28 = larger(_s16, _s27);
    const double _s29 = p_ring_radius - _s8;
    const double _s30 = 0.0001220703125 * p_ring_radius;
    const double _s31 = larger(_s29, _s30);
    const double _s32 = ((_s1 * (_s31 * _s31)) - _s19) - _s4;
    const double _s33 = sqrt(larger(_s32, 0.0));
    const double _s34 = choose(_s26, choose(_s25, (((_s22 + _s23) - _s21) * _s24), (-INFINITE)), (INFINITE));
    const bool _s35 = 0.0 < choose(_s26, _s32, 0.0);
    const double _s36 = choose(_s35, (((_s23 - _s21) - _s33) * _s24), _s34);
    const double _s37 = (_s0 + (_s9 * (z - _s8))) - _s10;
    const double _s38 = sqrt(larger(_s37, 0.0));
    const double _s39 = choose(_s15, (_s12 * ((vz + _s13) + _s14)), (-INFINITE));
    const bool _s40 = 0.0 < _s37;
    const double _s41 = choose(_s40, (_s12 * ((vz + _s14) - _s38)), _s39);
    const double _s42 = smaller(_s36, _s41);
    const double _s43 = choose(_s35, (((_s33 - _s21) - _s23) * _s24), (INFINITE));
    const double _s44 = larger(_s43, _s36);
    const double _s45 = larger(_s16, _s44);
    const double _s46 = smaller(_s34, _s41);
    const double _s47 = choose(_s40, (_s12 * ((vz + _s38) - _s14)), (INFINITE));
    const double _s48 = larger(_s47, _s41);
    const bool _s49 = _s45 <= _s46;
    const double _s50 = choose(_s49, _s45, larger(_s48, _s27));
    const double _s51 = choose(_s49, _s46, smaller(_s36, _s39));
    const double _s52 = larger(_s48, _s44);
    const double _s53 = smaller(_s34, _s39);
    const double _s54 = 1.0 / _s31;
    const double _s55 = larger(0.0, _s42);
    const double _s56 = larger(_s55, _s51);
    const double _s57 = larger(_s56, _s53);
    const double _s58 = (0.000244140625 * p_ring_radius) - (p_ring_radius - _s7);
    const double _s59 = sqrt(2.0) * sqrt((_s12 * (((2.0 * p_ball_radius) + (2.0 * p_wire_radius)) + extent)));
    const double _s60 = _s59 + ((2.0 * speed) * _s12);
    const double _s61 = ((position_error + (velocity_error * smaller(_s60, horizon))) - (1.52587890625e-05 * p_ball_radius)) - (1.52587890625e-05 * p_wire_radius);
    return {_s2, _s5, sqrt(_s6), larger(0.0, _s28), smaller(_s42, horizon), larger(0.0, _s50), smaller(_s51, horizon), larger(0.0, _s52), smaller(_s53, horizon), (((6.0003662109375 * p_gravity) * _s7) + (_s5 * (_s54 * (_s54 * _s54)))) + fabs(_s2), smaller(_s57, horizon), larger(_s58, _s61)};
}

/* Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.
   running error analysis. 47 operations: 14 additions, 1 subtraction, 27 multiplications, 1 division, 2 comparisons, 2 selections. */
struct kernel_ring_margins_out {
    double margin, leaving_margin, rate_margin;
};

static __device__ __forceinline__ kernel_ring_margins_out kernel_ring_margins(double horizon, double extent, double speed, double position_error, double velocity_error, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_gravity)
{
    const double _s0 = p_ball_radius + p_wire_radius;
    const double _s1 = speed + (p_gravity * horizon);
    const double _s2 = 1.00006103515625 * _s0;
    const double _s3 = _s2 * _s1;
    const double _s4 = p_ring_radius + _s2;
    const double _s5 = extent + (horizon * _s1);
    const double _s6 = (position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * _s5);
    const double _s7 = p_ring_radius - _s2;
    const double _s8 = 0.0001220703125 * p_ring_radius;
    const double _s9 = _s2 / larger(_s7, _s8);
    const double _s10 = larger(1.0, _s9);
    const double _s11 = 5.0 * (((_s1 * _s10) * _s6) + (_s2 * (velocity_error + (2.220446049250313e-16 * _s1))));
    const double _s12 = 1.0009765625 * ((((3.552713678800501e-15 * _s1) * ((_s5 * _s10) + _s4)) + (4.440892098500626e-16 * _s3)) + _s11);
    return {1.0009765625 * ((((4.440892098500626e-16 * horizon) * _s3) + ((1.3323489447131243e-15 * _s0) * _s4)) + ((5.00030517578125 * _s0) * _s6)), _s12, 1.0009765625 * ((3.552713678800501e-15 * (_s4 * _s1)) + _s11)};
}

/* Newton's next value of a root near t, and gap and rate there.
   Newton's method. 56 operations: 15 additions, 6 subtractions, 30 multiplications, 2 divisions, 1 square root, 1 comparison, 1 selection. */
struct kernel_ring_refine_out {
    double time, gap, rate;
};

static __device__ __forceinline__ kernel_ring_refine_out kernel_ring_refine(double t, double leaving, double x, double y, double z, double vx, double vy, double vz, double rho_start, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_gravity)
{
    const double _s0 = x + (vx * t);
    const double _s1 = y + (vy * t);
    const double _s2 = sqrt(((_s0 * _s0) + (_s1 * _s1)));
    const double _s3 = rho_start + _s2;
    const double _s4 = 1.0 / (_s3 * _s2);
    const double _s5 = _s2 - p_ring_radius;
    const double _s6 = vz - ((0.5 * p_gravity) * t);
    const double _s7 = z + (t * _s6);
    const double _s8 = 2.0 * ((((_s3 * _s4) * ((vx * _s0) + (vy * _s1))) * _s5) + (_s7 * (vz - (p_gravity * t))));
    const double _s9 = (((t * ((vx * vx) + (vy * vy))) + (2.0 * ((x * vx) + (y * vy)))) * ((rho_start - p_ring_radius) + _s5)) * (_s2 * _s4);
    const double _s10 = p_ball_radius + p_wire_radius;
    const double _s11 = choose((0.0 < leaving), (t * (_s9 + ((z + _s7) * _s6))), (((_s5 * _s5) + (_s7 * _s7)) - (_s10 * _s10)));
    return {t - (_s11 / _s8), _s11, _s8};
}

/* Gap, rate, second derivative, a step without a root, its end, and the clearance.
   Newton from the left under a curvature bound. 143 operations: 29 additions, 16 subtractions, 53 multiplications, 4 divisions, 2 square roots, 2 negations, 2 absolute values, 16 comparisons, 19 selections. */
struct kernel_ring_advance_out {
    double gap, rate, bend, step, next, clearance;
};

static __device__ __forceinline__ kernel_ring_advance_out kernel_ring_advance(double t, double end, double leaving, double margin, double rate_margin, double ceiling, double x, double y, double z, double vx, double vy, double vz, double energy2, double moment2, double rho_start, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_gravity)
{
    const double _s0 = x + (vx * t);
    const double _s1 = y + (vy * t);
    const double _s2 = sqrt(((_s0 * _s0) + (_s1 * _s1)));
    const double _s3 = _s2 - p_ring_radius;
    const double _s4 = rho_start + _s2;
    const double _s5 = 1.0 / (_s4 * _s2);
    const double _s6 = (((t * ((vx * vx) + (vy * vy))) + (2.0 * ((x * vx) + (y * vy)))) * ((rho_start - p_ring_radius) + _s3)) * (_s2 * _s5);
    const double _s7 = vz - ((0.5 * p_gravity) * t);
    const double _s8 = z + (t * _s7);
    const double _s9 = p_ball_radius + p_wire_radius;
    const double _s10 = choose((0.0 < leaving), (t * (_s6 + ((z + _s8) * _s7))), (((_s3 * _s3) + (_s8 * _s8)) - (_s9 * _s9)));
    const double _s11 = _s4 * _s5;
    const double _s12 = _s11 * ((vx * _s0) + (vy * _s1));
    const double _s13 = vz - (p_gravity * t);
    const double _s14 = 2.0 * ((_s12 * _s3) + (_s8 * _s13));
    const double _s15 = 6.0 * p_gravity;
    const double _s16 = _s15 * _s8;
    const double _s17 = moment2 * (_s11 * (_s11 * _s11));
    const double _s18 = 1.00006103515625 * _s9;
    const double _s19 = 9.094947017729282e-13 * (p_ring_radius + _s18);
    const double _s20 = _s14 - rate_margin;
    const double _s21 = _s10 - margin;
    const double _s22 = larger(_s21, 0.0);
    const double _s23 = (_s16 + _s17) - energy2;
    const bool _s24 = _s20 < 0.0;
    const double _s25 = 2.0 * _s22;
    const double _s26 = choose((0.0 < choose((0.0 <= _s20), _s22, 0.0)), (INFINITE), (choose(_s24, _s25, (4.0 * _s20)) / choose(_s24, (-_s20), larger(0.0, _s23))));
    const double _s27 = end - t;
    const double _s28 = smaller(_s26, _s27);
    const double _s29 = _s19 + ((_s28 * larger(_s13, 0.0)) + _s8);
    const double _s30 = _s15 * smaller(_s18, _s29);
    const double _s31 = ((_s28 * smaller(0.0, _s12)) + _s2) - _s19;
    const double _s32 = p_ring_radius - _s18;
    const double _s33 = 0.0001220703125 * p_ring_radius;
    const double _s34 = larger(_s32, _s33);
    const double _s35 = 1.0 / larger(_s31, _s34);
    const double _s36 = moment2 * (_s35 * (_s35 * _s35));
    const double _s37 = ((_s30 + _s36) + (9.094947017729282e-13 * ((_s36 + fabs(energy2)) + fabs(_s30)))) - energy2;
    const double _s38 = ((2.0 * _s37) * _s22) + (_s20 * _s20);
    const double _s39 = sqrt(_s38);
    const double _s40 = choose((0.0 <= _s38), (choose(_s24, _s25, (_s20 + _s39)) / choose(_s24, (_s39 - _s20), larger(0.0, _s37))), (INFINITE));
    const double _s41 = smaller(_s40, _s28);
    const double _s42 = -(rate_margin + _s14);
    return {_s10, _s14, (energy2 - _s16) - _s17, _s41, t + _s41, choose((0.0 < _s42), ((_s42 * _s42) - ((8.0 * ceiling) * (margin + _s25))), _s42)};
}

/* Windows of the search along a flight, and whether single precision serves for it.
   bounds of the event condition. 186 operations: 24 additions, 16 subtractions, 37 multiplications, 2 divisions, 4 square roots, 1 negation, 4 absolute values, 43 comparisons, 7 conjunctions, 3 disjunctions, 45 selections. */
struct kernel_ring_opened_out {
    float t, end;
    bool searching;
    float low1, high1, low2, high2, latest;
    bool representable;
};

static __device__ __forceinline__ kernel_ring_opened_out kernel_ring_opened(float horizon, float x, float y, float z, float vx, float vy, float vz, float extent, float speed, float p_ball_radius, float p_ring_radius, float p_wire_radius, float p_gravity)
{
    const float _s0 = vz * vz;
    const float _s1 = ((float)1.00006103515625) * (p_ball_radius + p_wire_radius);
    const float _s2 = ((float)2.0) * p_gravity;
    const float _s3 = ((float)4.76837158203125e-07) * (_s0 + (_s2 * (fabsf(z) + _s1)));
    const float _s4 = (_s0 + (_s2 * (z + _s1))) + _s3;
    const float _s5 = ((float)1.0) / p_gravity;
    const float _s6 = sqrtf(_s4);
    const float _s7 = ((float)9.5367431640625e-07) * (fabsf(vz) + _s6);
    const bool _s8 = ((float)0.0) <= _s4;
    const float _s9 = choose(_s8, (_s5 * ((vz - _s6) - _s7)), ((float)INFINITE));
    const float _s10 = (vx * vx) + (vy * vy);
    const float _s11 = p_ring_radius + _s1;
    const float _s12 = _s11 * _s11;
    const float _s13 = (((float)9.5367431640625e-07) * _s10) * (_s12 + ((x * x) + (y * y)));
    const float _s14 = (x * vy) - (y * vx);
    const float _s15 = _s14 * _s14;
    const float _s16 = ((_s12 * _s10) + _s13) - _s15;
    const float _s17 = (x * vx) + (y * vy);
    const float _s18 = sqrtf(_s16);
    const float _s19 = ((float)9.5367431640625e-07) * ((fabsf(_s17) + fabsf(_s14)) + _s18);
    const float _s20 = ((float)1.0) / _s10;
    const bool _s21 = ((float)0.0) <= _s16;
    const bool _s22 = ((float)8.673617379884035e-19) < _s10;
    const float _s23 = choose(_s22, choose(_s21, ((-((_s17 + _s18) + _s19)) * _s20), ((float)INFINITE)), (-(float)INFINITE));
    const float _s24 = larger(_s9, _s23);
    const float _s25 = larger(((float)0.0), _s24);
    const float _s26 = larger(((float)0.0), _s25);
    const float _s27 = p_ring_radius - _s1;
    const float _s28 = ((float)0.0001220703125) * p_ring_radius;
    const float _s29 = larger(_s27, _s28);
    const float _s30 = ((_s10 * (_s29 * _s29)) - _s13) - _s15;
    const float _s31 = sqrtf(larger(_s30, ((float)0.0)));
    const float _s32 = choose(_s22, choose(_s21, (((_s18 + _s19) - _s17) * _s20), (-(float)INFINITE)), ((float)INFINITE));
    const bool _s33 = ((float)0.0) < choose(_s22, _s30, ((float)0.0));
    const float _s34 = choose(_s33, (((_s19 - _s17) - _s31) * _s20), _s32);
    const float _s35 = (_s0 + (_s2 * (z - _s1))) - _s3;
    const float _s36 = sqrtf(larger(_s35, ((float)0.0)));
    const float _s37 = choose(_s8, (_s5 * ((vz + _s6) + _s7)), (-(float)INFINITE));
    const bool _s38 = ((float)0.0) < _s35;
    const float _s39 = choose(_s38, (_s5 * ((vz + _s7) - _s36)), _s37);
    const float _s40 = smaller(_s34, _s39);
    const float _s41 = ((float)1.000000238418579) * horizon;
    const float _s42 = smaller(_s40, _s41);
    const bool _s43 = _s26 < _s42;
    const float _s44 = choose(_s33, (((_s31 - _s17) - _s19) * _s20), ((float)INFINITE));
    const float _s45 = larger(_s44, _s34);
    const float _s46 = larger(_s9, _s45);
    const float _s47 = smaller(_s32, _s39);
    const float _s48 = choose(_s38, (_s5 * ((vz + _s36) - _s7)), ((float)INFINITE));
    const float _s49 = larger(_s48, _s39);
    const bool _s50 = _s46 <= _s47;
    const float _s51 = choose(_s50, _s46, larger(_s49, _s23));
    const float _s52 = larger(((float)0.0), _s51);
    const float _s53 = larger(((float)0.0), _s52);
    const float _s54 = choose(_s50, _s47, smaller(_s34, _s37));
    const float _s55 = smaller(_s54, _s41);
    const bool _s56 = _s53 < _s55;
    const float _s57 = larger(_s49, _s45);
    const float _s58 = larger(((float)0.0), _s57);
    const float _s59 = larger(((float)0.0), _s58);
    const float _s60 = smaller(_s32, _s37);
    const float _s61 = smaller(_s60, _s41);
    const bool _s62 = _s59 < _s61;
    const float _s63 = larger(((float)0.0), _s40);
    const float _s64 = larger(_s63, _s54);
    const float _s65 = larger(_s64, _s60);
    const bool _s66 = (((_s11 <= (((float)32.0) * _s29)) && (_s11 <= ((((float)32.0) * p_ball_radius) + (((float)32.0) * p_wire_radius)))) && (_s11 <= ((float)4096.0))) && (((float)0.000244140625) <= _s29);
    return {choose(_s43, _s26, choose(_s56, _s53, choose(_s62, _s59, ((float)0.0)))), choose(_s43, _s42, choose(_s56, _s55, choose(_s62, _s61, ((float)0.0)))), ((false || _s62) || _s56) || _s43, _s52, _s55, _s58, _s61, smaller(_s65, _s41), (((_s66 && (p_gravity <= ((float)4096.0))) && (((float)0.000244140625) <= p_gravity)) && (extent <= ((float)4096.0))) && (speed <= ((float)4096.0))};
}

/* Constants, margins and windows of the search in single precision, from its begin.
   running error analysis. 109 operations: 21 additions, 8 subtractions, 55 multiplications, 5 divisions, 1 square root, 5 absolute values, 7 comparisons, 1 conjunction, 6 selections. */
struct kernel_ring_resolution_out {
    float share, t, end, x, y, z, vx, vy, vz, energy2, moment2, rho_start, ceiling, flat, tilt, jerk, quotient_margin, start_rate, rho_rate, rate_margin, low1, high1, low2, high2;
    bool fits;
};

static __device__ __forceinline__ kernel_ring_resolution_out kernel_ring_resolution(float t, float end, float leaving, float horizon, float x, float y, float z, float vx, float vy, float vz, float extent, float speed, float start_rate, float rho_rate, float low1, float high1, float low2, float high2, float p_ball_radius, float p_ring_radius, float p_wire_radius, float p_gravity)
{
    const bool _s0 = ((float)0.0) < leaving;
    const float _s1 = speed + (p_gravity * horizon);
    const float _s2 = p_ball_radius + p_wire_radius;
    const float _s3 = ((float)1.00006103515625) * _s2;
    const float _s4 = p_ring_radius - _s3;
    const float _s5 = ((float)0.0001220703125) * p_ring_radius;
    const float _s6 = larger(_s4, _s5);
    const float _s7 = _s2 / _s6;
    const float _s8 = larger(((float)1.0), _s7);
    const float _s9 = _s1 * _s8;
    const float _s10 = extent + (horizon * _s1);
    const float _s11 = ((float)5.0) * ((_s9 * _s10) + (_s2 * _s1));
    const float _s12 = (((float)0.00390625) * start_rate) / _s11;
    const float _s13 = smaller(_s12, ((float)2.9802322387695312e-08));
    const float _s14 = choose(_s0, larger(((float)2.842170943040401e-14), _s13), ((float)2.9802322387695312e-08));
    const float _s15 = ((((float)2.0) * (vz * vz)) + ((((float)4.0) * p_gravity) * z)) + (((float)2.0) * ((vx * vx) + (vy * vy)));
    const float _s16 = (x * vy) - (y * vx);
    const float _s17 = (((float)2.0) * p_ring_radius) * (_s16 * _s16);
    const float _s18 = ((float)1.0) / _s6;
    const float _s19 = _s18 * (_s18 * _s18);
    const float _s20 = (((((float)6.0003662109375) * p_gravity) * _s2) + (_s17 * _s19)) + fabsf(_s15);
    const float _s21 = horizon - t;
    const float _s22 = p_gravity * (_s21 * _s21);
    const float _s23 = p_ring_radius + _s3;
    const float _s24 = (_s10 * _s14) + (((float)9.5367431640625e-07) * (_s22 + _s23));
    const float _s25 = (((float)0.5) * ((_s17 * (fabsf(vx) + fabsf(vy))) * _s19)) / _s6;
    return {_s14, (float)0.0, end - t, x, y, z, vx, vy, vz, _s15, _s17, sqrtf(((x * x) + (y * y))), ((float)1.0009765625) * _s20, (((float)5.0048828125) * _s2) * _s24, choose(_s0, (((float)1.0009765625) * ((((float)4.76837158203125e-07) * fabsf(start_rate)) + ((((float)5.684341886080802e-14) + _s14) * _s11))), ((float)INFINITE)), ((float)1.0009765625) * ((p_gravity * ((p_gravity * _s21) + fabsf(vz))) + _s25), (((float)7.62939453125e-06) * ((_s23 / _s6) * _s8)) * _s20, start_rate, rho_rate, ((float)5.0) * (((((float)1.0009765625) * _s9) * _s24) + (((((float)2.384185791015625e-07) + _s14) * _s2) * _s1)), low1 - t, high1 - t, low2 - t, high2 - t, (_s22 <= ((((float)128.0) * p_ball_radius) + (((float)128.0) * p_wire_radius))) && ((t * leaving) <= ((float)0.0))};
}

/* Time and window of the search after a step, whether a root is certain, and whether it goes on.
   Newton from the left under a curvature bound. 237 operations: 42 additions, 20 subtractions, 82 multiplications, 4 divisions, 2 square roots, 3 negations, 5 absolute values, 30 comparisons, 6 conjunctions, 5 disjunctions, 4 complements, 34 selections. */
struct kernel_ring_step_out {
    float t, end;
    bool certain, stepping;
};

static __device__ __forceinline__ kernel_ring_step_out kernel_ring_step(float t, float end, float rate_margin, float ceiling, float x, float y, float z, float vx, float vy, float vz, float energy2, float moment2, float rho_start, float flat, float tilt, float quotient_margin, float jerk, float start_rate, float rho_rate, float low1, float high1, float low2, float high2, float p_ball_radius, float p_ring_radius, float p_wire_radius, float p_gravity)
{
    const float _s0 = tilt + (t * quotient_margin);
    const float _s1 = t * _s0;
    const bool _s2 = _s1 < flat;
    const float _s3 = (t * t) * jerk;
    const bool _s4 = _s2 && (_s3 < rate_margin);
    const float _s5 = choose(_s4, (_s3 + (((float)2.0) * _s0)), rate_margin);
    const float _s6 = (vx * vx) + (vy * vy);
    const float _s7 = x + (vx * t);
    const float _s8 = y + (vy * t);
    const float _s9 = sqrtf(((_s7 * _s7) + (_s8 * _s8)));
    const float _s10 = rho_start + _s9;
    const float _s11 = ((float)1.0) / (_s10 * _s9);
    const float _s12 = _s9 * _s11;
    const float _s13 = _s12 * ((t * _s6) + (((float)2.0) * ((x * vx) + (y * vy))));
    const float _s14 = vz - ((((float)0.5) * p_gravity) * t);
    const float _s15 = ((((((float)2.0) * (rho_start - p_ring_radius)) * (_s6 - (rho_rate * _s13))) * _s12) + (_s13 * _s13)) + (_s14 * _s14);
    const float _s16 = start_rate + (t * (_s15 - (p_gravity * z)));
    const float _s17 = _s10 * _s11;
    const float _s18 = _s17 * ((vx * _s7) + (vy * _s8));
    const float _s19 = _s9 - p_ring_radius;
    const float _s20 = z + (t * _s14);
    const float _s21 = vz - (p_gravity * t);
    const float _s22 = choose(_s4, ((((float)2.0) * _s16) - start_rate), (((float)2.0) * ((_s18 * _s19) + (_s20 * _s21))));
    const float _s23 = -(_s5 + _s22);
    const float _s24 = p_ball_radius + p_wire_radius;
    const float _s25 = choose(_s2, _s1, flat);
    const float _s26 = choose(_s2, (t * _s16), (((_s19 * _s19) + (_s20 * _s20)) - (_s24 * _s24))) - _s25;
    const float _s27 = larger(_s26, ((float)0.0));
    const float _s28 = ((float)2.0) * (_s27 + (((float)2.0) * _s25));
    const float _s29 = _s22 - _s5;
    const float _s30 = ((float)6.0) * p_gravity;
    const float _s31 = _s30 * _s20;
    const float _s32 = moment2 * (_s17 * (_s17 * _s17));
    const float _s33 = (_s31 + _s32) - energy2;
    const bool _s34 = _s29 < ((float)0.0);
    const float _s35 = ((float)2.0) * _s27;
    const float _s36 = choose((((float)0.0) < choose((((float)0.0) <= _s29), _s27, ((float)0.0))), ((float)INFINITE), (choose(_s34, (_s35 + (((float)8.0) * _s25)), (((float)4.0) * _s29)) / choose(_s34, (-_s29), larger(((float)0.0), _s33))));
    const float _s37 = end - t;
    const float _s38 = smaller(_s36, _s37);
    const float _s39 = ((float)1.00006103515625) * _s24;
    const float _s40 = ((((float)0.0001220703125) * p_ball_radius) + (((float)0.0001220703125) * p_wire_radius)) + ((_s38 * larger(_s21, ((float)0.0))) + _s20);
    const float _s41 = _s30 * smaller(_s39, _s40);
    const float _s42 = (fabsf(vx) + fabsf(vy)) * _s38;
    const float _s43 = (((_s38 * smaller(((float)0.0), _s18)) + _s9) - (((float)0.0001220703125) * _s42)) - (((float)9.5367431640625e-07) * (p_ring_radius + _s39));
    const float _s44 = p_ring_radius - _s39;
    const float _s45 = ((float)0.0001220703125) * p_ring_radius;
    const float _s46 = larger(_s44, _s45);
    const float _s47 = ((float)1.0) / larger(_s43, _s46);
    const float _s48 = moment2 * (_s47 * (_s47 * _s47));
    const float _s49 = fabsf(energy2);
    const float _s50 = ((_s41 + _s48) + (((float)3.814697265625e-06) * ((_s48 + _s49) + fabsf(_s41)))) - energy2;
    const float _s51 = -_s21;
    const float _s52 = (_s30 * (((((float)0.000244140625) * p_ball_radius) + (((float)0.000244140625) * p_wire_radius)) + (((p_gravity * _s38) + larger(_s51, ((float)0.0))) * _s38))) + ((((float)3.0) * (_s32 * _s17)) * _s42);
    const float _s53 = energy2 + (_s52 + (((float)0.000244140625) * ((_s49 + fabsf(_s31)) + _s32)));
    const float _s54 = (_s53 - _s31) - _s32;
    const float _s55 = choose((((float)0.0) < _s23), ((_s23 * _s23) - ((((float)8.0) * _s28) * choose((_s28 <= (_s23 * _s38)), larger(_s50, _s54), ceiling))), _s23);
    const bool _s56 = ((float)0.0) < _s55;
    const float _s57 = ((((float)2.0) * _s50) * _s27) + (_s29 * _s29);
    const float _s58 = sqrtf(_s57);
    const float _s59 = choose((((float)0.0) <= _s57), (choose(_s34, _s35, (_s58 + _s29)) / choose(_s34, (_s58 - _s29), larger(((float)0.0), _s50))), ((float)INFINITE));
    const float _s60 = smaller(_s59, _s38);
    const float _s61 = t + _s60;
    const bool _s62 = (!_s56) && (((_s22 < ((float)0.0)) && (_s26 <= _s25)) || ((t < end) && (!(t < _s61))));
    const bool _s63 = !(_s56 || _s62);
    const bool _s64 = _s63 && (_s37 <= _s60);
    const float _s65 = larger(end, low1);
    const bool _s66 = _s65 < high1;
    const float _s67 = larger(end, low2);
    const bool _s68 = _s67 < high2;
    return {choose(_s64, choose(_s66, _s65, choose(_s68, _s67, ((float)INFINITE))), choose(_s62, t, _s61)), choose(_s64, choose(_s66, high1, choose(_s68, high2, end)), end), _s56, _s63 && ((!_s64) || ((false || _s68) || _s66))};
}

/* Distance from the axis, its rate and that of the gap, at the start of a flight.
   Table 2. 13 operations: 3 additions, 1 subtraction, 7 multiplications, 1 division, 1 square root. */
struct kernel_ring_started_out {
    double rho_start, start_rate, rho_rate;
};

static __device__ __forceinline__ kernel_ring_started_out kernel_ring_started(double x, double y, double z, double vx, double vy, double vz, double p_ring_radius)
{
    const double _s0 = sqrt(((x * x) + (y * y)));
    const double _s1 = ((x * vx) + (y * vy)) / _s0;
    return {_s0, 2.0 * ((z * vz) + (_s1 * (_s0 - p_ring_radius))), _s1};
}

/* Positive if errors of the state exceed those that a search allows for.
   running error analysis. 34 operations: 7 additions, 5 subtractions, 13 multiplications, 1 division, 4 comparisons, 4 selections. */
struct kernel_ring_coarse_excess_out {
    double excess;
};

static __device__ __forceinline__ kernel_ring_coarse_excess_out kernel_ring_coarse_excess(double share, double horizon, double extent, double speed, double position_error, double velocity_error, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_gravity)
{
    const double _s0 = speed + (p_gravity * horizon);
    const double _s1 = share * (extent + (horizon * _s0));
    const double _s2 = 1.00006103515625 * (p_ball_radius + p_wire_radius);
    const double _s3 = ((position_error + (horizon * velocity_error)) - _s1) - (8.940696716308594e-08 * (p_ring_radius + _s2));
    const double _s4 = p_ring_radius - _s2;
    const double _s5 = 0.0001220703125 * p_ring_radius;
    const double _s6 = _s2 / larger(_s4, _s5);
    const double _s7 = (position_error + ((0.5 * horizon) * velocity_error)) - _s1;
    const double _s8 = ((_s0 * larger(1.0, _s6)) * larger(_s7, _s3)) + (_s2 * (velocity_error - (share * _s0)));
    return {larger(_s3, _s8)};
}

/* Positive if the bounds of the search do not hold.
   bounds of the event condition. 26 operations: 5 additions, 4 subtractions, 10 multiplications, 1 division, 2 square roots, 2 comparisons, 2 selections. */
struct kernel_ring_budget_exceeded_out {
    double budget_exceeded;
};

static __device__ __forceinline__ kernel_ring_budget_exceeded_out kernel_ring_budget_exceeded(double horizon, double extent, double speed, double position_error, double velocity_error, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_gravity)
{
    const double _s0 = (0.000244140625 * p_ring_radius) - (p_ring_radius - (p_ball_radius + p_wire_radius));
    const double _s1 = 1.0 / p_gravity;
    const double _s2 = sqrt(2.0) * sqrt((_s1 * (((2.0 * p_ball_radius) + (2.0 * p_wire_radius)) + extent)));
    const double _s3 = _s2 + ((2.0 * speed) * _s1);
    const double _s4 = ((position_error + (velocity_error * smaller(_s3, horizon))) - (1.52587890625e-05 * p_ball_radius)) - (1.52587890625e-05 * p_wire_radius);
    return {larger(_s0, _s4)};
}

/* Distance, its rate, and a bound on how fast it bends down, by the squared speed.
   Table 2. 33 operations: 5 additions, 5 subtractions, 15 multiplications, 4 divisions, 2 square roots, 1 comparison, 1 selection. */
struct kernel_ring_beside_out {
    double gap, nearing, gap_curvature;
};

static __device__ __forceinline__ kernel_ring_beside_out kernel_ring_beside(double p_ball_radius, double p_ring_radius, double p_wire_radius, double x, double y, double z, double vx, double vy, double vz)
{
    const double _s0 = sqrt(((x * x) + (y * y)));
    const double _s1 = _s0 - p_ring_radius;
    const double _s2 = sqrt(((z * z) + (_s1 * _s1)));
    const double _s3 = 2.0 * p_ring_radius;
    const double _s4 = ((2.0 * z) * vz) + (((0.5 * ((2.0 * _s0) - _s3)) * (((2.0 * x) * vx) + ((2.0 * y) * vy))) / _s0);
    const double _s5 = (_s3 / _s0) - 1.0;
    return {(_s2 - p_ball_radius) - p_wire_radius, (0.5 * _s4) / _s2, larger(0.0, _s5) / (p_ball_radius + p_wire_radius)};
}

/* Distance of a ball that rolls on another surface, and its first two derivatives.
   derivatives of Table 2's distance. 70 operations: 14 additions, 3 subtractions, 47 multiplications, 2 divisions, 2 square roots, 2 negations. */
struct kernel_ring_closing_out {
    double gap, nearing, rolling_gap_acceleration, normal_cosine;
};

static __device__ __forceinline__ kernel_ring_closing_out kernel_ring_closing(double p_ball_radius, double p_ring_radius, double p_wire_radius, double x, double y, double z, double nx, double ny, double nz, double rolled_x, double rolled_y, double rolled_z, double rolling_acceleration_x, double rolling_acceleration_y, double rolling_acceleration_z)
{
    const double _s0 = sqrt(((x * x) + (y * y)));
    const double _s1 = _s0 - p_ring_radius;
    const double _s2 = sqrt(((z * z) + (_s1 * _s1)));
    const double _s3 = 2.0 * z;
    const double _s4 = 2.0 * x;
    const double _s5 = 2.0 * y;
    const double _s6 = (_s4 * rolled_x) + (_s5 * rolled_y);
    const double _s7 = 1.0 / _s0;
    const double _s8 = (0.5 * _s6) * _s7;
    const double _s9 = (_s3 * rolled_z) + ((2.0 * _s8) * _s1);
    const double _s10 = 1.0 / _s2;
    const double _s11 = (0.5 * _s9) * _s10;
    const double _s12 = ((-(_s8 * (_s7 * _s7))) * _s6) + (((2.0 * ((rolled_x * rolled_x) + (x * rolling_acceleration_x))) + (2.0 * ((rolled_y * rolled_y) + (y * rolling_acceleration_y)))) * _s7);
    const double _s13 = ((2.0 * ((rolled_z * rolled_z) + (z * rolling_acceleration_z))) + (2.0 * ((_s1 * (0.5 * _s12)) + (_s8 * _s8)))) * _s10;
    const double _s14 = 0.5 * (((-(_s11 * (_s10 * _s10))) * _s9) + _s13);
    const double _s15 = (2.0 * ((0.5 * ((_s4 * nx) + (_s5 * ny))) * _s7)) * _s1;
    return {(_s2 - p_ball_radius) - p_wire_radius, _s11, _s14, (0.5 * ((_s3 * nz) + _s15)) * _s10};
}

/* Distance from the surface.
   Table 2. 11 operations: 2 additions, 3 subtractions, 4 multiplications, 2 square roots. */
struct kernel_ring_distance_out {
    double gap;
};

static __device__ __forceinline__ kernel_ring_distance_out kernel_ring_distance(double p_ball_radius, double p_ring_radius, double p_wire_radius, double x, double y, double z)
{
    const double _s0 = sqrt(((x * x) + (y * y))) - p_ring_radius;
    return {(sqrt(((z * z) + (_s0 * _s0))) - p_ball_radius) - p_wire_radius};
}

/* Curvature of the surface that the centre of a rolling ball stays on.
   Table 2. 2 operations: 1 addition, 1 division. */
struct kernel_ring_rolling_surface_out {
    double bent_x, bent_y, bent_z, per_reach;
};

static __device__ __forceinline__ kernel_ring_rolling_surface_out kernel_ring_rolling_surface(double p_ball_radius, double p_wire_radius)
{
    return {1.0, 1.0, 1.0, 1.0 / (p_ball_radius + p_wire_radius)};
}

/* Rate of the normal.
   derivative of Table 2's normal. 28 operations: 6 additions, 1 subtraction, 17 multiplications, 2 divisions, 1 square root, 1 negation. */
struct kernel_ring_turning_out {
    double turning_x, turning_y, turning_z;
};

static __device__ __forceinline__ kernel_ring_turning_out kernel_ring_turning(double p_ball_radius, double p_ring_radius, double p_wire_radius, double x, double y, double rolled_x, double rolled_y, double rolled_z)
{
    const double _s0 = 1.0 / (p_ball_radius + p_wire_radius);
    const double _s1 = sqrt(((x * x) + (y * y)));
    const double _s2 = 1.0 / _s1;
    const double _s3 = ((x * rolled_x) + (y * rolled_y)) * _s2;
    const double _s4 = _s1 - p_ring_radius;
    const double _s5 = _s0 * ((_s3 * _s2) + ((-(_s3 * (_s2 * _s2))) * _s4));
    const double _s6 = (_s0 * _s4) * _s2;
    return {(x * _s5) + (rolled_x * _s6), (y * _s5) + (rolled_y * _s6), rolled_z * _s0};
}

/* Second to fourth derivative of the distance along a flight.
   derivatives of Table 2's distance. 148 operations: 41 additions, 2 subtractions, 94 multiplications, 2 divisions, 2 square roots, 7 negations. */
struct kernel_ring_separation_out {
    double lift, gap_jerk, gap_snap;
};

static __device__ __forceinline__ kernel_ring_separation_out kernel_ring_separation(double p_gravity, double p_ring_radius, double x, double y, double z, double vx, double vy, double vz)
{
    const double _s0 = ((2.0 * x) * vx) + ((2.0 * y) * vy);
    const double _s1 = sqrt(((x * x) + (y * y)));
    const double _s2 = 1.0 / _s1;
    const double _s3 = (0.5 * _s0) * _s2;
    const double _s4 = _s1 - p_ring_radius;
    const double _s5 = 2.0 * _s3;
    const double _s6 = ((2.0 * z) * vz) + (_s5 * _s4);
    const double _s7 = 1.0 / sqrt(((z * z) + (_s4 * _s4)));
    const double _s8 = (0.5 * _s6) * _s7;
    const double _s9 = _s7 * _s7;
    const double _s10 = -(_s8 * _s9);
    const double _s11 = _s2 * _s2;
    const double _s12 = -(_s3 * _s11);
    const double _s13 = (2.0 * (vx * vx)) + (2.0 * (vy * vy));
    const double _s14 = 0.5 * ((_s12 * _s0) + (_s13 * _s2));
    const double _s15 = (2.0 * ((vz * vz) - (p_gravity * z))) + (2.0 * ((_s4 * _s14) + (_s3 * _s3)));
    const double _s16 = 0.5 * ((_s10 * _s6) + (_s15 * _s7));
    const double _s17 = _s10 * _s15;
    const double _s18 = 2.0 * _s10;
    const double _s19 = -((_s16 * _s9) + ((_s18 * _s8) * _s7));
    const double _s20 = _s12 * _s13;
    const double _s21 = 2.0 * _s12;
    const double _s22 = -((_s14 * _s11) + ((_s21 * _s3) * _s2));
    const double _s23 = 0.5 * (_s20 + (_s20 + (_s0 * _s22)));
    const double _s24 = (2.0 * (-((3.0 * p_gravity) * vz))) + (2.0 * ((_s5 * _s14) + ((_s3 * _s14) + (_s4 * _s23))));
    const double _s25 = 0.5 * ((_s17 + (_s6 * _s19)) + (_s17 + (_s24 * _s7)));
    const double _s26 = _s10 * _s24;
    const double _s27 = _s3 * _s23;
    const double _s28 = _s27 + (_s14 * _s14);
    const double _s29 = _s13 * _s22;
    const double _s30 = ((_s23 * _s11) + ((_s21 * _s14) * _s2)) + (2.0 * ((((_s12 * _s12) * _s3) + ((_s12 * _s14) * _s2)) + ((_s3 * _s22) * _s2)));
    const double _s31 = 0.5 * (_s29 + (_s29 + ((_s0 * (-_s30)) + _s29)));
    const double _s32 = (2.0 * (3.0 * (p_gravity * p_gravity))) + (2.0 * ((2.0 * _s28) + ((_s27 + (_s4 * _s31)) + _s28)));
    const double _s33 = _s15 * _s19;
    const double _s34 = _s26 + _s33;
    const double _s35 = ((_s25 * _s9) + ((_s18 * _s16) * _s7)) + (2.0 * ((((_s10 * _s10) * _s8) + ((_s10 * _s16) * _s7)) + ((_s8 * _s19) * _s7)));
    const double _s36 = 0.5 * (((_s26 + (_s32 * _s7)) + _s34) + (_s34 + ((_s6 * (-_s35)) + _s33)));
    return {_s16, _s25, _s36};
}

/* Constant terms, in the ring's coordinates.
   Routh's equations. 43 operations: 8 additions, 4 subtractions, 25 multiplications, 4 divisions, 2 square roots. */
struct kernel_ring_round_start_out {
    double cosine_0, sine_0, climb_0, along_0, turn_rate_0, cos_0, sin_0, tilted_0, near_0;
};

static __device__ __forceinline__ kernel_ring_round_start_out kernel_ring_round_start(double p_ball_radius, double p_inertia, double p_ring_radius, double p_wire_radius, double x, double y, double z, double vx, double vy, double vz, double wx, double wy, double wz, double per_reach)
{
    const double _s0 = sqrt(((x * x) + (y * y)));
    const double _s1 = _s0 - p_ring_radius;
    const double _s2 = 1.0 / sqrt(((z * z) + (_s1 * _s1)));
    const double _s3 = _s1 * _s2;
    const double _s4 = z * _s2;
    const double _s5 = 1.0 / _s0;
    const double _s6 = x * _s5;
    const double _s7 = y * _s5;
    const double _s8 = (vy * _s6) - (vx * _s7);
    const double _s9 = p_ball_radius * ((wz * _s4) + (_s3 * ((wx * _s6) + (wy * _s7))));
    return {_s3, _s4, per_reach * ((vz * _s3) - (_s4 * ((vx * _s6) + (vy * _s7)))), _s8, _s9, _s6, _s7, (_s4 * _s8) - ((p_inertia * (1.0 / (1.0 + p_inertia))) * (_s9 * _s3)), 1.0 / (p_ring_radius + (_s3 * (p_ball_radius + p_wire_radius)))};
}

/* State of a ball that rolls on the ring at time t.
   Routh's equations. 223 operations: 83 additions, 10 subtractions, 126 multiplications, 2 divisions, 1 square root, 1 negation. */
struct kernel_ring_round_moved_out {
    double x, y, z, vx, vy, vz, wx, wy, wz, climb;
};

static __device__ __forceinline__ kernel_ring_round_moved_out kernel_ring_round_moved(double p_ball_radius, double p_ring_radius, double p_wire_radius, double t, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double turn_rate_4, double turn_rate_5, double turn_rate_6, double turn_rate_7, double turn_rate_8, double turn_rate_9, double turn_rate_10, double turn_rate_11, double turn_rate_12, double climb_0, double climb_1, double climb_2, double climb_3, double climb_4, double climb_5, double climb_6, double climb_7, double climb_8, double climb_9, double climb_10, double climb_11, double climb_12, double cosine_0, double cosine_1, double cosine_2, double cosine_3, double cosine_4, double cosine_5, double cosine_6, double cosine_7, double cosine_8, double cosine_9, double cosine_10, double cosine_11, double cosine_12, double sine_0, double sine_1, double sine_2, double sine_3, double sine_4, double sine_5, double sine_6, double sine_7, double sine_8, double sine_9, double sine_10, double sine_11, double sine_12, double along_0, double along_1, double along_2, double along_3, double along_4, double along_5, double along_6, double along_7, double along_8, double along_9, double along_10, double along_11, double along_12, double cos_0, double sin_0, double omega_0, double omega_1, double omega_2, double omega_3, double omega_4, double omega_5, double omega_6, double omega_7, double omega_8, double omega_9, double omega_10, double omega_11)
{
    const double _s0 = cosine_9 + (t * (cosine_10 + (t * (cosine_11 + (t * cosine_12)))));
    const double _s1 = cosine_6 + (t * (cosine_7 + (t * (cosine_8 + (t * _s0)))));
    const double _s2 = cosine_3 + (t * (cosine_4 + (t * (cosine_5 + (t * _s1)))));
    const double _s3 = cosine_0 + (t * (cosine_1 + (t * (cosine_2 + (t * _s2)))));
    const double _s4 = sine_9 + (t * (sine_10 + (t * (sine_11 + (t * sine_12)))));
    const double _s5 = sine_6 + (t * (sine_7 + (t * (sine_8 + (t * _s4)))));
    const double _s6 = sine_3 + (t * (sine_4 + (t * (sine_5 + (t * _s5)))));
    const double _s7 = sine_0 + (t * (sine_1 + (t * (sine_2 + (t * _s6)))));
    const double _s8 = 1.0 / sqrt(((_s3 * _s3) + (_s7 * _s7)));
    const double _s9 = _s3 * _s8;
    const double _s10 = p_ball_radius + p_wire_radius;
    const double _s11 = p_ring_radius + (_s9 * _s10);
    const double _s12 = t * ((0.1 * omega_9) + (t * ((0.09090909090909091 * omega_10) + ((0.08333333333333333 * t) * omega_11))));
    const double _s13 = (0.14285714285714285 * omega_6) + (t * ((0.125 * omega_7) + (t * ((0.1111111111111111 * omega_8) + _s12))));
    const double _s14 = (0.25 * omega_3) + (t * ((0.2 * omega_4) + (t * ((0.16666666666666666 * omega_5) + (t * _s13)))));
    const double _s15 = omega_0 + (t * ((0.5 * omega_1) + (t * ((0.3333333333333333 * omega_2) + (t * _s14)))));
    const double _s16 = t * _s15;
    const double _s17 = _s16 * _s16;
    const double _s18 = ((2.48015873015873e-05 + (((2.08767569878681e-09 * _s17) - 2.755731922398589e-07) * _s17)) * _s17) - 0.001388888888888889;
    const double _s19 = 1.0 + ((((0.041666666666666664 + (_s18 * _s17)) * _s17) - 0.5) * _s17);
    const double _s20 = 0.008333333333333333 + ((((2.7557319223985893e-06 - (2.505210838544172e-08 * _s17)) * _s17) - 0.0001984126984126984) * _s17);
    const double _s21 = _s16 * (1.0 + (((_s20 * _s17) - 0.16666666666666666) * _s17));
    const double _s22 = (cos_0 * _s19) - (sin_0 * _s21);
    const double _s23 = (cos_0 * _s21) + (sin_0 * _s19);
    const double _s24 = _s7 * _s8;
    const double _s25 = climb_9 + (t * (climb_10 + (t * (climb_11 + (t * climb_12)))));
    const double _s26 = climb_6 + (t * (climb_7 + (t * (climb_8 + (t * _s25)))));
    const double _s27 = climb_3 + (t * (climb_4 + (t * (climb_5 + (t * _s26)))));
    const double _s28 = climb_0 + (t * (climb_1 + (t * (climb_2 + (t * _s27)))));
    const double _s29 = _s10 * _s28;
    const double _s30 = -(_s29 * _s24);
    const double _s31 = along_9 + (t * (along_10 + (t * (along_11 + (t * along_12)))));
    const double _s32 = along_6 + (t * (along_7 + (t * (along_8 + (t * _s31)))));
    const double _s33 = along_3 + (t * (along_4 + (t * (along_5 + (t * _s32)))));
    const double _s34 = along_0 + (t * (along_1 + (t * (along_2 + (t * _s33)))));
    const double _s35 = 1.0 / p_ball_radius;
    const double _s36 = turn_rate_9 + (t * (turn_rate_10 + (t * (turn_rate_11 + (t * turn_rate_12)))));
    const double _s37 = turn_rate_6 + (t * (turn_rate_7 + (t * (turn_rate_8 + (t * _s36)))));
    const double _s38 = turn_rate_3 + (t * (turn_rate_4 + (t * (turn_rate_5 + (t * _s37)))));
    const double _s39 = turn_rate_0 + (t * (turn_rate_1 + (t * (turn_rate_2 + (t * _s38)))));
    const double _s40 = (_s9 * _s39) - (_s24 * _s34);
    return {_s11 * _s22, _s11 * _s23, _s24 * _s10, (_s30 * _s22) - (_s34 * _s23), (_s30 * _s23) + (_s34 * _s22), _s29 * _s9, _s35 * ((_s29 * _s23) + (_s22 * _s40)), _s35 * ((_s23 * _s40) - (_s29 * _s22)), _s35 * ((_s9 * _s34) + (_s24 * _s39)), _s28};
}

/* Length of a step of the series, and bounds in it.
   Routh's equations. 334 operations: 96 additions, 6 subtractions, 172 multiplications, 3 divisions, 7 square roots, 1 negation, 45 absolute values, 2 comparisons, 2 selections. */
struct kernel_ring_round_step_out {
    double stride, missed, strongest, fastest, section_acceleration, force, force_rate, force_bend, friction_force_rate, vx_1, vy_1, vz_1;
};

static __device__ __forceinline__ kernel_ring_round_step_out kernel_ring_round_step(double p_ball_radius, double p_gravity, double p_inertia, double p_ring_radius, double p_wire_radius, double per_reach, double turn_rate_0, double turn_rate_11, double turn_rate_12, double climb_0, double climb_1, double climb_2, double climb_3, double climb_4, double climb_5, double climb_6, double climb_7, double climb_8, double climb_9, double climb_10, double climb_11, double climb_12, double cosine_0, double cosine_12, double sine_0, double sine_12, double along_0, double along_1, double along_2, double along_3, double along_4, double along_5, double along_6, double along_7, double along_8, double along_9, double along_10, double along_11, double along_12, double cos_0, double sin_0, double omega_0, double omega_1, double omega_2, double omega_3, double omega_4, double omega_5, double omega_6, double omega_7, double omega_8, double omega_9, double omega_10, double omega_11)
{
    const double _s0 = fabs(climb_0);
    const double _s1 = p_ball_radius + p_wire_radius;
    const double _s2 = fabs(along_0);
    const double _s3 = (_s0 * _s1) + (fabs(turn_rate_0) + _s2);
    const double _s4 = (0.015625 * p_gravity) + _s3;
    const double _s5 = fabs(climb_11);
    const double _s6 = fabs(along_11);
    const double _s7 = fabs(climb_12);
    const double _s8 = fabs(along_12);
    const double _s9 = ((0.25 * ((per_reach * _s3) + sqrt((p_gravity * per_reach)))) * ((_s5 * _s1) + (fabs(turn_rate_11) + _s6))) + ((_s7 * _s1) + (fabs(turn_rate_12) + _s8));
    const double _s10 = fabs(omega_0);
    const double _s11 = omega_0 * omega_0;
    const double _s12 = (4.0 * _s10) * (16.0 * _s11);
    const double _s13 = _s12 * _s12;
    const double _s14 = _s4 * ((fabs(cosine_12) + fabs(sine_12)) + (4.547473508864641e-13 * (_s13 * _s13)));
    const double _s15 = sqrt(sqrt(((4.547473508864641e-13 * _s4) / larger(_s9, _s14))));
    const double _s16 = sqrt(sqrt(_s15));
    const double _s17 = (0.75 * _s16) * sqrt(sqrt(_s16));
    const double _s18 = _s17 * (_s17 * _s17);
    const double _s19 = ((_s18 + (2.0 * _s15)) / ((2.0 * _s18) + _s15)) * _s17;
    const double _s20 = smaller(_s19, 0.0625);
    const double _s21 = fabs(climb_10);
    const double _s22 = (((((12.0 * _s7) * _s20) + (11.0 * _s5)) * _s20) + (10.0 * _s21)) * _s20;
    const double _s23 = fabs(climb_9);
    const double _s24 = fabs(climb_8);
    const double _s25 = fabs(climb_7);
    const double _s26 = ((((_s22 + (9.0 * _s23)) * _s20) + (8.0 * _s24)) * _s20) + (7.0 * _s25);
    const double _s27 = fabs(climb_6);
    const double _s28 = fabs(climb_5);
    const double _s29 = fabs(climb_4);
    const double _s30 = (((((_s26 * _s20) + (6.0 * _s27)) * _s20) + (5.0 * _s28)) * _s20) + (4.0 * _s29);
    const double _s31 = fabs(climb_3);
    const double _s32 = fabs(climb_2);
    const double _s33 = fabs(climb_1);
    const double _s34 = (((((_s30 * _s20) + (3.0 * _s31)) * _s20) + (2.0 * _s32)) * _s20) + _s33;
    const double _s35 = (((((_s7 * _s20) + _s5) * _s20) + _s21) * _s20) + _s23;
    const double _s36 = (((((_s35 * _s20) + _s24) * _s20) + _s25) * _s20) + _s27;
    const double _s37 = (((((_s36 * _s20) + _s28) * _s20) + _s29) * _s20) + _s31;
    const double _s38 = (((((_s37 * _s20) + _s32) * _s20) + _s33) * _s20) + _s0;
    const double _s39 = _s1 * (_s34 + (_s38 * _s38));
    const double _s40 = fabs(omega_11);
    const double _s41 = fabs(omega_10);
    const double _s42 = fabs(omega_9);
    const double _s43 = fabs(omega_8);
    const double _s44 = (((((_s40 * _s20) + _s41) * _s20) + _s42) * _s20) + _s43;
    const double _s45 = fabs(omega_7);
    const double _s46 = fabs(omega_6);
    const double _s47 = fabs(omega_5);
    const double _s48 = (((((_s44 * _s20) + _s45) * _s20) + _s46) * _s20) + _s47;
    const double _s49 = fabs(omega_4);
    const double _s50 = fabs(omega_3);
    const double _s51 = fabs(omega_2);
    const double _s52 = (((((_s48 * _s20) + _s49) * _s20) + _s50) * _s20) + _s51;
    const double _s53 = fabs(omega_1);
    const double _s54 = (((_s52 * _s20) + _s53) * _s20) + _s10;
    const double _s55 = fabs(along_10);
    const double _s56 = fabs(along_9);
    const double _s57 = (((((_s8 * _s20) + _s6) * _s20) + _s55) * _s20) + _s56;
    const double _s58 = fabs(along_8);
    const double _s59 = fabs(along_7);
    const double _s60 = fabs(along_6);
    const double _s61 = (((((_s57 * _s20) + _s58) * _s20) + _s59) * _s20) + _s60;
    const double _s62 = fabs(along_5);
    const double _s63 = fabs(along_4);
    const double _s64 = fabs(along_3);
    const double _s65 = (((((_s61 * _s20) + _s62) * _s20) + _s63) * _s20) + _s64;
    const double _s66 = fabs(along_2);
    const double _s67 = fabs(along_1);
    const double _s68 = (((((_s65 * _s20) + _s66) * _s20) + _s67) * _s20) + _s2;
    const double _s69 = (_s1 * _s38) + _s68;
    const double _s70 = (((((12.0 * _s8) * _s20) + (11.0 * _s6)) * _s20) + (10.0 * _s55)) * _s20;
    const double _s71 = ((((_s70 + (9.0 * _s56)) * _s20) + (8.0 * _s58)) * _s20) + (7.0 * _s59);
    const double _s72 = (((((_s71 * _s20) + (6.0 * _s60)) * _s20) + (5.0 * _s62)) * _s20) + (4.0 * _s63);
    const double _s73 = (((((_s72 * _s20) + (3.0 * _s64)) * _s20) + (2.0 * _s66)) * _s20) + _s67;
    const double _s74 = (climb_0 * climb_0) * _s1;
    const double _s75 = along_0 * omega_0;
    const double _s76 = p_inertia * (1.0 / (1.0 + p_inertia));
    const double _s77 = p_gravity * (3.0 - (2.0 * _s76));
    const double _s78 = 3.0 * p_ring_radius;
    const double _s79 = (((((11.0 * _s40) * _s20) + (10.0 * _s41)) * _s20) + (9.0 * _s42)) * _s20;
    const double _s80 = ((((_s79 + (8.0 * _s43)) * _s20) + (7.0 * _s45)) * _s20) + (6.0 * _s46);
    const double _s81 = (((((_s80 * _s20) + (5.0 * _s47)) * _s20) + (4.0 * _s49)) * _s20) + (3.0 * _s50);
    const double _s82 = _s38 * _s20;
    const double _s83 = fabs(sine_0) + _s82;
    const double _s84 = (_s54 * ((((_s81 * _s20) + (2.0 * _s51)) * _s20) + _s53)) * _s83;
    const double _s85 = _s78 * (_s54 * _s54);
    const double _s86 = fabs(cosine_0) + _s82;
    const double _s87 = ((((6.0 * p_ring_radius) * _s84) + (_s38 * ((_s85 * _s86) + (_s77 * _s83)))) * _s38) + (_s34 * ((_s85 * _s83) + (_s77 * _s86)));
    const double _s88 = -(((cosine_0 * _s74) + _s75) + ((climb_1 * sine_0) * _s1));
    const double _s89 = along_1 - (omega_0 * ((climb_0 * sine_0) * _s1));
    return {_s20, 5.684341886080802e-14 * _s4, _s39 + ((_s54 * _s69) + _s73), _s69, _s39, ((p_gravity * sine_0) - _s74) - (cosine_0 * _s75), climb_0 * ((cosine_0 * _s77) + (sine_0 * (_s78 * _s11))), _s87, ((2.0 * p_gravity) * _s76) * (climb_0 * cosine_0), (cos_0 * _s88) - (sin_0 * _s89), (cos_0 * _s89) + (sin_0 * _s88), ((climb_1 * cosine_0) * _s1) - (sine_0 * _s74)};
}

/* Square of the friction that rolling on the ring takes, and its rate.
   Routh's equations. 27 operations: 7 additions, 19 multiplications, 1 division. */
struct kernel_ring_round_pulled_out {
    double rolling_friction, rolling_friction_rate, grip_deficit, grip_deficit_rate;
};

static __device__ __forceinline__ kernel_ring_round_pulled_out kernel_ring_round_pulled(double p_gravity, double p_inertia, double turn_rate_0, double turn_rate_1, double climb_0, double climb_1, double cosine_0, double cosine_1, double omega_0, double omega_1)
{
    const double _s0 = p_inertia * (1.0 / (1.0 + p_inertia));
    const double _s1 = _s0 * (turn_rate_0 * climb_0);
    const double _s2 = p_gravity + (turn_rate_0 * omega_0);
    const double _s3 = _s0 * (cosine_0 * _s2);
    const double _s4 = _s3 * (_s0 * ((cosine_0 * ((turn_rate_0 * omega_1) + (turn_rate_1 * omega_0))) + (cosine_1 * _s2)));
    const double _s5 = 2.0 * ((_s1 * (_s0 * ((turn_rate_0 * climb_1) + (turn_rate_1 * climb_0)))) + _s4);
    return {(_s1 * _s1) + (_s3 * _s3), _s5, -INFINITE, 0.0};
}

/* Whether the ball certainly rolls on the ring for ever.
   Routh's equations. 49 operations: 4 additions, 3 subtractions, 21 multiplications, 1 division, 1 absolute value, 8 comparisons, 6 conjunctions, 1 complement, 4 selections. */
struct kernel_ring_swung_out {
    double circled;
    bool endless;
    double undecided_time;
};

static __device__ __forceinline__ kernel_ring_swung_out kernel_ring_swung(double p_ball_radius, double p_gravity, double p_wire_radius, double which, double undecided_time, double position_error, double velocity_error, double force, double force_rate, double force_bend, double stride, double fastest, double circled, double climb, double climb_0, double section_acceleration, double azimuth_clearance)
{
    const double _s0 = p_ball_radius + p_wire_radius;
    const double _s1 = stride * stride;
    const bool _s2 = ((0.000244140625 * _s0) < (azimuth_clearance - ((0.125 * section_acceleration) * _s1))) && ((0.00390625 * p_gravity) < ((force + (stride * smaller(force_rate, 0.0))) - ((0.5 * force_bend) * _s1)));
    const bool _s3 = _s2 && (which == -1.0);
    const bool _s4 = ((climb * climb_0) < 0.0) && (((0.015625 * p_gravity) * stride) < (fabs((climb - climb_0)) * _s0));
    const bool _s5 = (_s3 && _s4) && (0.0 < circled);
    const double _s6 = p_gravity + ((fastest * fastest) * (1.0 / _s0));
    const bool _s7 = !((_s6 * (512.0 * ((position_error * _s6) + (velocity_error * fastest)))) < ((0.000244140625 * (p_gravity * p_gravity)) * _s0));
    return {choose(_s3, choose(_s4, 1.0, circled), 0.0), _s5, choose((_s5 && _s7), 0.0, undecided_time)};
}

/* Coefficients of order 1, from those of lower order.
   Routh's equations. 26 operations: 4 additions, 1 subtraction, 18 multiplications, 1 division, 2 negations. */
struct kernel_ring_round_0_out {
    double omega_0, around_0, cosine_1, sine_1, climb_1, along_1, turn_rate_1, tilted_1;
};

static __device__ __forceinline__ kernel_ring_round_0_out kernel_ring_round_0(double p_ball_radius, double p_gravity, double p_inertia, double p_ring_radius, double p_wire_radius, double per_reach, double turn_rate_0, double near_0, double climb_0, double cosine_0, double sine_0, double along_0, double tilted_0)
{
    const double _s0 = near_0 * along_0;
    const double _s1 = climb_0 * _s0;
    const double _s2 = 1.0 / (1.0 + p_inertia);
    const double _s3 = p_ball_radius + p_wire_radius;
    return {_s0, _s1, -(climb_0 * sine_0), climb_0 * cosine_0, -(per_reach * (((p_gravity * cosine_0) * _s2) + (tilted_0 * _s0))), ((sine_0 * _s1) * _s3) - ((p_inertia * _s2) * (turn_rate_0 * climb_0)), p_ring_radius * _s1, ((p_ring_radius * _s2) * (cosine_0 * _s1)) + (_s1 * _s3)};
}

/* Coefficients of order 2, from those of lower order.
   Routh's equations. 49 operations: 11 additions, 2 subtractions, 33 multiplications, 1 division, 2 negations. */
struct kernel_ring_round_1_out {
    double omega_1, around_1, cosine_2, sine_2, climb_2, along_2, turn_rate_2, tilted_2;
};

static __device__ __forceinline__ kernel_ring_round_1_out kernel_ring_round_1(double p_ball_radius, double p_gravity, double p_inertia, double p_ring_radius, double p_wire_radius, double per_reach, double turn_rate_0, double turn_rate_1, double near_0, double climb_0, double climb_1, double cosine_0, double cosine_1, double sine_0, double sine_1, double along_1, double omega_0, double around_0, double tilted_0, double tilted_1)
{
    const double _s0 = p_ball_radius + p_wire_radius;
    const double _s1 = near_0 * (along_1 - ((cosine_1 * omega_0) * _s0));
    const double _s2 = (climb_0 * _s1) + (climb_1 * omega_0);
    const double _s3 = 1.0 / (1.0 + p_inertia);
    return {_s1, _s2, -(0.5 * ((climb_0 * sine_1) + (climb_1 * sine_0))), 0.5 * ((climb_0 * cosine_1) + (climb_1 * cosine_0)), -((0.5 * per_reach) * (((p_gravity * cosine_1) * _s3) + ((omega_0 * tilted_1) + (tilted_0 * _s1)))), 0.5 * ((_s0 * ((sine_0 * _s2) + (sine_1 * around_0))) - ((p_inertia * _s3) * ((turn_rate_0 * climb_1) + (turn_rate_1 * climb_0)))), (0.5 * p_ring_radius) * _s2, 0.5 * (((p_ring_radius * _s3) * ((cosine_0 * _s2) + (cosine_1 * around_0))) + (_s0 * _s2))};
}

/* Coefficients of order 3, from those of lower order.
   Routh's equations. 65 operations: 19 additions, 2 subtractions, 41 multiplications, 1 division, 2 negations. */
struct kernel_ring_round_2_out {
    double omega_2, around_2, cosine_3, sine_3, climb_3, along_3, turn_rate_3, tilted_3;
};

static __device__ __forceinline__ kernel_ring_round_2_out kernel_ring_round_2(double p_ball_radius, double p_gravity, double p_inertia, double p_ring_radius, double p_wire_radius, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double near_0, double climb_0, double climb_1, double climb_2, double cosine_0, double cosine_1, double cosine_2, double sine_0, double sine_1, double sine_2, double along_2, double omega_0, double omega_1, double around_0, double around_1, double tilted_0, double tilted_1, double tilted_2)
{
    const double _s0 = p_ball_radius + p_wire_radius;
    const double _s1 = near_0 * (along_2 - (_s0 * ((cosine_1 * omega_1) + (cosine_2 * omega_0))));
    const double _s2 = ((climb_0 * _s1) + (climb_1 * omega_1)) + (climb_2 * omega_0);
    const double _s3 = 1.0 / (1.0 + p_inertia);
    const double _s4 = -((0.3333333333333333 * per_reach) * (((p_gravity * cosine_2) * _s3) + (((omega_0 * tilted_2) + (omega_1 * tilted_1)) + (tilted_0 * _s1))));
    const double _s5 = 0.3333333333333333 * ((_s0 * (((sine_0 * _s2) + (sine_1 * around_1)) + (sine_2 * around_0))) - ((p_inertia * _s3) * (((turn_rate_0 * climb_2) + (turn_rate_1 * climb_1)) + (turn_rate_2 * climb_0))));
    const double _s6 = 0.3333333333333333 * (((p_ring_radius * _s3) * (((cosine_0 * _s2) + (cosine_1 * around_1)) + (cosine_2 * around_0))) + (_s0 * _s2));
    return {_s1, _s2, -(0.3333333333333333 * (((climb_0 * sine_2) + (climb_1 * sine_1)) + (climb_2 * sine_0))), 0.3333333333333333 * (((climb_0 * cosine_2) + (climb_1 * cosine_1)) + (climb_2 * cosine_0)), _s4, _s5, (0.3333333333333333 * p_ring_radius) * _s2, _s6};
}

/* Coefficients of order 4, from those of lower order.
   Routh's equations. 81 operations: 27 additions, 2 subtractions, 49 multiplications, 1 division, 2 negations. */
struct kernel_ring_round_3_out {
    double omega_3, around_3, cosine_4, sine_4, climb_4, along_4, turn_rate_4, tilted_4;
};

static __device__ __forceinline__ kernel_ring_round_3_out kernel_ring_round_3(double p_ball_radius, double p_gravity, double p_inertia, double p_ring_radius, double p_wire_radius, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double near_0, double climb_0, double climb_1, double climb_2, double climb_3, double cosine_0, double cosine_1, double cosine_2, double cosine_3, double sine_0, double sine_1, double sine_2, double sine_3, double along_3, double omega_0, double omega_1, double omega_2, double around_0, double around_1, double around_2, double tilted_0, double tilted_1, double tilted_2, double tilted_3)
{
    const double _s0 = p_ball_radius + p_wire_radius;
    const double _s1 = near_0 * (along_3 - (_s0 * (((cosine_1 * omega_2) + (cosine_2 * omega_1)) + (cosine_3 * omega_0))));
    const double _s2 = (((climb_0 * _s1) + (climb_1 * omega_2)) + (climb_2 * omega_1)) + (climb_3 * omega_0);
    const double _s3 = -(0.25 * ((((climb_0 * sine_3) + (climb_1 * sine_2)) + (climb_2 * sine_1)) + (climb_3 * sine_0)));
    const double _s4 = 1.0 / (1.0 + p_inertia);
    const double _s5 = (0.25 * per_reach) * (((p_gravity * cosine_3) * _s4) + ((((omega_0 * tilted_3) + (omega_1 * tilted_2)) + (omega_2 * tilted_1)) + (tilted_0 * _s1)));
    const double _s6 = (_s0 * ((((sine_0 * _s2) + (sine_1 * around_2)) + (sine_2 * around_1)) + (sine_3 * around_0))) - ((p_inertia * _s4) * ((((turn_rate_0 * climb_3) + (turn_rate_1 * climb_2)) + (turn_rate_2 * climb_1)) + (turn_rate_3 * climb_0)));
    const double _s7 = ((p_ring_radius * _s4) * ((((cosine_0 * _s2) + (cosine_1 * around_2)) + (cosine_2 * around_1)) + (cosine_3 * around_0))) + (_s0 * _s2);
    return {_s1, _s2, _s3, 0.25 * ((((climb_0 * cosine_3) + (climb_1 * cosine_2)) + (climb_2 * cosine_1)) + (climb_3 * cosine_0)), -_s5, 0.25 * _s6, (0.25 * p_ring_radius) * _s2, 0.25 * _s7};
}

/* Coefficients of order 5, from those of lower order.
   Routh's equations. 97 operations: 35 additions, 2 subtractions, 57 multiplications, 1 division, 2 negations. */
struct kernel_ring_round_4_out {
    double omega_4, around_4, cosine_5, sine_5, climb_5, along_5, turn_rate_5, tilted_5;
};

static __device__ __forceinline__ kernel_ring_round_4_out kernel_ring_round_4(double p_ball_radius, double p_gravity, double p_inertia, double p_ring_radius, double p_wire_radius, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double turn_rate_4, double near_0, double climb_0, double climb_1, double climb_2, double climb_3, double climb_4, double cosine_0, double cosine_1, double cosine_2, double cosine_3, double cosine_4, double sine_0, double sine_1, double sine_2, double sine_3, double sine_4, double along_4, double omega_0, double omega_1, double omega_2, double omega_3, double around_0, double around_1, double around_2, double around_3, double tilted_0, double tilted_1, double tilted_2, double tilted_3, double tilted_4)
{
    const double _s0 = p_ball_radius + p_wire_radius;
    const double _s1 = along_4 - (_s0 * ((((cosine_1 * omega_3) + (cosine_2 * omega_2)) + (cosine_3 * omega_1)) + (cosine_4 * omega_0)));
    const double _s2 = near_0 * _s1;
    const double _s3 = ((((climb_0 * _s2) + (climb_1 * omega_3)) + (climb_2 * omega_2)) + (climb_3 * omega_1)) + (climb_4 * omega_0);
    const double _s4 = 0.2 * (((((climb_0 * sine_4) + (climb_1 * sine_3)) + (climb_2 * sine_2)) + (climb_3 * sine_1)) + (climb_4 * sine_0));
    const double _s5 = 0.2 * (((((climb_0 * cosine_4) + (climb_1 * cosine_3)) + (climb_2 * cosine_2)) + (climb_3 * cosine_1)) + (climb_4 * cosine_0));
    const double _s6 = 1.0 / (1.0 + p_inertia);
    const double _s7 = ((p_gravity * cosine_4) * _s6) + (((((omega_0 * tilted_4) + (omega_1 * tilted_3)) + (omega_2 * tilted_2)) + (omega_3 * tilted_1)) + (tilted_0 * _s2));
    const double _s8 = _s0 * (((((sine_0 * _s3) + (sine_1 * around_3)) + (sine_2 * around_2)) + (sine_3 * around_1)) + (sine_4 * around_0));
    const double _s9 = (p_inertia * _s6) * (((((turn_rate_0 * climb_4) + (turn_rate_1 * climb_3)) + (turn_rate_2 * climb_2)) + (turn_rate_3 * climb_1)) + (turn_rate_4 * climb_0));
    const double _s10 = (p_ring_radius * _s6) * (((((cosine_0 * _s3) + (cosine_1 * around_3)) + (cosine_2 * around_2)) + (cosine_3 * around_1)) + (cosine_4 * around_0));
    return {_s2, _s3, -_s4, _s5, -((0.2 * per_reach) * _s7), 0.2 * (_s8 - _s9), (0.2 * p_ring_radius) * _s3, 0.2 * (_s10 + (_s0 * _s3))};
}

/* Coefficients of order 6, from those of lower order.
   Routh's equations. 113 operations: 43 additions, 2 subtractions, 65 multiplications, 1 division, 2 negations. */
struct kernel_ring_round_5_out {
    double omega_5, around_5, cosine_6, sine_6, climb_6, along_6, turn_rate_6, tilted_6;
};

static __device__ __forceinline__ kernel_ring_round_5_out kernel_ring_round_5(double p_ball_radius, double p_gravity, double p_inertia, double p_ring_radius, double p_wire_radius, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double turn_rate_4, double turn_rate_5, double near_0, double climb_0, double climb_1, double climb_2, double climb_3, double climb_4, double climb_5, double cosine_0, double cosine_1, double cosine_2, double cosine_3, double cosine_4, double cosine_5, double sine_0, double sine_1, double sine_2, double sine_3, double sine_4, double sine_5, double along_5, double omega_0, double omega_1, double omega_2, double omega_3, double omega_4, double around_0, double around_1, double around_2, double around_3, double around_4, double tilted_0, double tilted_1, double tilted_2, double tilted_3, double tilted_4, double tilted_5)
{
    const double _s0 = p_ball_radius + p_wire_radius;
    const double _s1 = _s0 * (((((cosine_1 * omega_4) + (cosine_2 * omega_3)) + (cosine_3 * omega_2)) + (cosine_4 * omega_1)) + (cosine_5 * omega_0));
    const double _s2 = near_0 * (along_5 - _s1);
    const double _s3 = (((((climb_0 * _s2) + (climb_1 * omega_4)) + (climb_2 * omega_3)) + (climb_3 * omega_2)) + (climb_4 * omega_1)) + (climb_5 * omega_0);
    const double _s4 = (((((climb_0 * sine_5) + (climb_1 * sine_4)) + (climb_2 * sine_3)) + (climb_3 * sine_2)) + (climb_4 * sine_1)) + (climb_5 * sine_0);
    const double _s5 = (((((climb_0 * cosine_5) + (climb_1 * cosine_4)) + (climb_2 * cosine_3)) + (climb_3 * cosine_2)) + (climb_4 * cosine_1)) + (climb_5 * cosine_0);
    const double _s6 = 1.0 / (1.0 + p_inertia);
    const double _s7 = (((((omega_0 * tilted_5) + (omega_1 * tilted_4)) + (omega_2 * tilted_3)) + (omega_3 * tilted_2)) + (omega_4 * tilted_1)) + (tilted_0 * _s2);
    const double _s8 = (((((sine_0 * _s3) + (sine_1 * around_4)) + (sine_2 * around_3)) + (sine_3 * around_2)) + (sine_4 * around_1)) + (sine_5 * around_0);
    const double _s9 = (((((turn_rate_0 * climb_5) + (turn_rate_1 * climb_4)) + (turn_rate_2 * climb_3)) + (turn_rate_3 * climb_2)) + (turn_rate_4 * climb_1)) + (turn_rate_5 * climb_0);
    const double _s10 = (((((cosine_0 * _s3) + (cosine_1 * around_4)) + (cosine_2 * around_3)) + (cosine_3 * around_2)) + (cosine_4 * around_1)) + (cosine_5 * around_0);
    return {_s2, _s3, -(0.16666666666666666 * _s4), 0.16666666666666666 * _s5, -((0.16666666666666666 * per_reach) * (((p_gravity * cosine_5) * _s6) + _s7)), 0.16666666666666666 * ((_s0 * _s8) - ((p_inertia * _s6) * _s9)), (0.16666666666666666 * p_ring_radius) * _s3, 0.16666666666666666 * (((p_ring_radius * _s6) * _s10) + (_s0 * _s3))};
}

/* Coefficients of order 7, from those of lower order.
   Routh's equations. 129 operations: 51 additions, 2 subtractions, 73 multiplications, 1 division, 2 negations. */
struct kernel_ring_round_6_out {
    double omega_6, around_6, cosine_7, sine_7, climb_7, along_7, turn_rate_7, tilted_7;
};

static __device__ __forceinline__ kernel_ring_round_6_out kernel_ring_round_6(double p_ball_radius, double p_gravity, double p_inertia, double p_ring_radius, double p_wire_radius, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double turn_rate_4, double turn_rate_5, double turn_rate_6, double near_0, double climb_0, double climb_1, double climb_2, double climb_3, double climb_4, double climb_5, double climb_6, double cosine_0, double cosine_1, double cosine_2, double cosine_3, double cosine_4, double cosine_5, double cosine_6, double sine_0, double sine_1, double sine_2, double sine_3, double sine_4, double sine_5, double sine_6, double along_6, double omega_0, double omega_1, double omega_2, double omega_3, double omega_4, double omega_5, double around_0, double around_1, double around_2, double around_3, double around_4, double around_5, double tilted_0, double tilted_1, double tilted_2, double tilted_3, double tilted_4, double tilted_5, double tilted_6)
{
    const double _s0 = p_ball_radius + p_wire_radius;
    const double _s1 = (((((cosine_1 * omega_5) + (cosine_2 * omega_4)) + (cosine_3 * omega_3)) + (cosine_4 * omega_2)) + (cosine_5 * omega_1)) + (cosine_6 * omega_0);
    const double _s2 = near_0 * (along_6 - (_s0 * _s1));
    const double _s3 = (((((climb_0 * _s2) + (climb_1 * omega_5)) + (climb_2 * omega_4)) + (climb_3 * omega_3)) + (climb_4 * omega_2)) + (climb_5 * omega_1);
    const double _s4 = _s3 + (climb_6 * omega_0);
    const double _s5 = (((((climb_0 * sine_6) + (climb_1 * sine_5)) + (climb_2 * sine_4)) + (climb_3 * sine_3)) + (climb_4 * sine_2)) + (climb_5 * sine_1);
    const double _s6 = (((((climb_0 * cosine_6) + (climb_1 * cosine_5)) + (climb_2 * cosine_4)) + (climb_3 * cosine_3)) + (climb_4 * cosine_2)) + (climb_5 * cosine_1);
    const double _s7 = 1.0 / (1.0 + p_inertia);
    const double _s8 = (((((omega_0 * tilted_6) + (omega_1 * tilted_5)) + (omega_2 * tilted_4)) + (omega_3 * tilted_3)) + (omega_4 * tilted_2)) + (omega_5 * tilted_1);
    const double _s9 = (((((sine_0 * _s4) + (sine_1 * around_5)) + (sine_2 * around_4)) + (sine_3 * around_3)) + (sine_4 * around_2)) + (sine_5 * around_1);
    const double _s10 = (((((turn_rate_0 * climb_6) + (turn_rate_1 * climb_5)) + (turn_rate_2 * climb_4)) + (turn_rate_3 * climb_3)) + (turn_rate_4 * climb_2)) + (turn_rate_5 * climb_1);
    const double _s11 = (((((cosine_0 * _s4) + (cosine_1 * around_5)) + (cosine_2 * around_4)) + (cosine_3 * around_3)) + (cosine_4 * around_2)) + (cosine_5 * around_1);
    return {_s2, _s4, -(0.14285714285714285 * (_s5 + (climb_6 * sine_0))), 0.14285714285714285 * (_s6 + (climb_6 * cosine_0)), -((0.14285714285714285 * per_reach) * (((p_gravity * cosine_6) * _s7) + (_s8 + (tilted_0 * _s2)))), 0.14285714285714285 * ((_s0 * (_s9 + (sine_6 * around_0))) - ((p_inertia * _s7) * (_s10 + (turn_rate_6 * climb_0)))), (0.14285714285714285 * p_ring_radius) * _s4, 0.14285714285714285 * (((p_ring_radius * _s7) * (_s11 + (cosine_6 * around_0))) + (_s0 * _s4))};
}

/* Coefficients of order 8, from those of lower order.
   Routh's equations. 145 operations: 59 additions, 2 subtractions, 81 multiplications, 1 division, 2 negations. */
struct kernel_ring_round_7_out {
    double omega_7, around_7, cosine_8, sine_8, climb_8, along_8, turn_rate_8, tilted_8;
};

static __device__ __forceinline__ kernel_ring_round_7_out kernel_ring_round_7(double p_ball_radius, double p_gravity, double p_inertia, double p_ring_radius, double p_wire_radius, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double turn_rate_4, double turn_rate_5, double turn_rate_6, double turn_rate_7, double near_0, double climb_0, double climb_1, double climb_2, double climb_3, double climb_4, double climb_5, double climb_6, double climb_7, double cosine_0, double cosine_1, double cosine_2, double cosine_3, double cosine_4, double cosine_5, double cosine_6, double cosine_7, double sine_0, double sine_1, double sine_2, double sine_3, double sine_4, double sine_5, double sine_6, double sine_7, double along_7, double omega_0, double omega_1, double omega_2, double omega_3, double omega_4, double omega_5, double omega_6, double around_0, double around_1, double around_2, double around_3, double around_4, double around_5, double around_6, double tilted_0, double tilted_1, double tilted_2, double tilted_3, double tilted_4, double tilted_5, double tilted_6, double tilted_7)
{
    const double _s0 = p_ball_radius + p_wire_radius;
    const double _s1 = (((((cosine_1 * omega_6) + (cosine_2 * omega_5)) + (cosine_3 * omega_4)) + (cosine_4 * omega_3)) + (cosine_5 * omega_2)) + (cosine_6 * omega_1);
    const double _s2 = near_0 * (along_7 - (_s0 * (_s1 + (cosine_7 * omega_0))));
    const double _s3 = (((((climb_0 * _s2) + (climb_1 * omega_6)) + (climb_2 * omega_5)) + (climb_3 * omega_4)) + (climb_4 * omega_3)) + (climb_5 * omega_2);
    const double _s4 = (_s3 + (climb_6 * omega_1)) + (climb_7 * omega_0);
    const double _s5 = (((((climb_0 * sine_7) + (climb_1 * sine_6)) + (climb_2 * sine_5)) + (climb_3 * sine_4)) + (climb_4 * sine_3)) + (climb_5 * sine_2);
    const double _s6 = (((((climb_0 * cosine_7) + (climb_1 * cosine_6)) + (climb_2 * cosine_5)) + (climb_3 * cosine_4)) + (climb_4 * cosine_3)) + (climb_5 * cosine_2);
    const double _s7 = 1.0 / (1.0 + p_inertia);
    const double _s8 = (((((omega_0 * tilted_7) + (omega_1 * tilted_6)) + (omega_2 * tilted_5)) + (omega_3 * tilted_4)) + (omega_4 * tilted_3)) + (omega_5 * tilted_2);
    const double _s9 = -((0.125 * per_reach) * (((p_gravity * cosine_7) * _s7) + ((_s8 + (omega_6 * tilted_1)) + (tilted_0 * _s2))));
    const double _s10 = (((((sine_0 * _s4) + (sine_1 * around_6)) + (sine_2 * around_5)) + (sine_3 * around_4)) + (sine_4 * around_3)) + (sine_5 * around_2);
    const double _s11 = (((((turn_rate_0 * climb_7) + (turn_rate_1 * climb_6)) + (turn_rate_2 * climb_5)) + (turn_rate_3 * climb_4)) + (turn_rate_4 * climb_3)) + (turn_rate_5 * climb_2);
    const double _s12 = 0.125 * ((_s0 * ((_s10 + (sine_6 * around_1)) + (sine_7 * around_0))) - ((p_inertia * _s7) * ((_s11 + (turn_rate_6 * climb_1)) + (turn_rate_7 * climb_0))));
    const double _s13 = (((((cosine_0 * _s4) + (cosine_1 * around_6)) + (cosine_2 * around_5)) + (cosine_3 * around_4)) + (cosine_4 * around_3)) + (cosine_5 * around_2);
    const double _s14 = 0.125 * (((p_ring_radius * _s7) * ((_s13 + (cosine_6 * around_1)) + (cosine_7 * around_0))) + (_s0 * _s4));
    return {_s2, _s4, -(0.125 * ((_s5 + (climb_6 * sine_1)) + (climb_7 * sine_0))), 0.125 * ((_s6 + (climb_6 * cosine_1)) + (climb_7 * cosine_0)), _s9, _s12, (0.125 * p_ring_radius) * _s4, _s14};
}

/* Coefficients of order 9, from those of lower order.
   Routh's equations. 161 operations: 67 additions, 2 subtractions, 89 multiplications, 1 division, 2 negations. */
struct kernel_ring_round_8_out {
    double omega_8, around_8, cosine_9, sine_9, climb_9, along_9, turn_rate_9, tilted_9;
};

static __device__ __forceinline__ kernel_ring_round_8_out kernel_ring_round_8(double p_ball_radius, double p_gravity, double p_inertia, double p_ring_radius, double p_wire_radius, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double turn_rate_4, double turn_rate_5, double turn_rate_6, double turn_rate_7, double turn_rate_8, double near_0, double climb_0, double climb_1, double climb_2, double climb_3, double climb_4, double climb_5, double climb_6, double climb_7, double climb_8, double cosine_0, double cosine_1, double cosine_2, double cosine_3, double cosine_4, double cosine_5, double cosine_6, double cosine_7, double cosine_8, double sine_0, double sine_1, double sine_2, double sine_3, double sine_4, double sine_5, double sine_6, double sine_7, double sine_8, double along_8, double omega_0, double omega_1, double omega_2, double omega_3, double omega_4, double omega_5, double omega_6, double omega_7, double around_0, double around_1, double around_2, double around_3, double around_4, double around_5, double around_6, double around_7, double tilted_0, double tilted_1, double tilted_2, double tilted_3, double tilted_4, double tilted_5, double tilted_6, double tilted_7, double tilted_8)
{
    const double _s0 = p_ball_radius + p_wire_radius;
    const double _s1 = (((((cosine_1 * omega_7) + (cosine_2 * omega_6)) + (cosine_3 * omega_5)) + (cosine_4 * omega_4)) + (cosine_5 * omega_3)) + (cosine_6 * omega_2);
    const double _s2 = near_0 * (along_8 - (_s0 * ((_s1 + (cosine_7 * omega_1)) + (cosine_8 * omega_0))));
    const double _s3 = (((((climb_0 * _s2) + (climb_1 * omega_7)) + (climb_2 * omega_6)) + (climb_3 * omega_5)) + (climb_4 * omega_4)) + (climb_5 * omega_3);
    const double _s4 = ((_s3 + (climb_6 * omega_2)) + (climb_7 * omega_1)) + (climb_8 * omega_0);
    const double _s5 = (((((climb_0 * sine_8) + (climb_1 * sine_7)) + (climb_2 * sine_6)) + (climb_3 * sine_5)) + (climb_4 * sine_4)) + (climb_5 * sine_3);
    const double _s6 = -(0.1111111111111111 * (((_s5 + (climb_6 * sine_2)) + (climb_7 * sine_1)) + (climb_8 * sine_0)));
    const double _s7 = (((((climb_0 * cosine_8) + (climb_1 * cosine_7)) + (climb_2 * cosine_6)) + (climb_3 * cosine_5)) + (climb_4 * cosine_4)) + (climb_5 * cosine_3);
    const double _s8 = 1.0 / (1.0 + p_inertia);
    const double _s9 = (((((omega_0 * tilted_8) + (omega_1 * tilted_7)) + (omega_2 * tilted_6)) + (omega_3 * tilted_5)) + (omega_4 * tilted_4)) + (omega_5 * tilted_3);
    const double _s10 = (0.1111111111111111 * per_reach) * (((p_gravity * cosine_8) * _s8) + (((_s9 + (omega_6 * tilted_2)) + (omega_7 * tilted_1)) + (tilted_0 * _s2)));
    const double _s11 = (((((sine_0 * _s4) + (sine_1 * around_7)) + (sine_2 * around_6)) + (sine_3 * around_5)) + (sine_4 * around_4)) + (sine_5 * around_3);
    const double _s12 = (((((turn_rate_0 * climb_8) + (turn_rate_1 * climb_7)) + (turn_rate_2 * climb_6)) + (turn_rate_3 * climb_5)) + (turn_rate_4 * climb_4)) + (turn_rate_5 * climb_3);
    const double _s13 = (_s0 * (((_s11 + (sine_6 * around_2)) + (sine_7 * around_1)) + (sine_8 * around_0))) - ((p_inertia * _s8) * (((_s12 + (turn_rate_6 * climb_2)) + (turn_rate_7 * climb_1)) + (turn_rate_8 * climb_0)));
    const double _s14 = (((((cosine_0 * _s4) + (cosine_1 * around_7)) + (cosine_2 * around_6)) + (cosine_3 * around_5)) + (cosine_4 * around_4)) + (cosine_5 * around_3);
    const double _s15 = ((p_ring_radius * _s8) * (((_s14 + (cosine_6 * around_2)) + (cosine_7 * around_1)) + (cosine_8 * around_0))) + (_s0 * _s4);
    return {_s2, _s4, _s6, 0.1111111111111111 * (((_s7 + (climb_6 * cosine_2)) + (climb_7 * cosine_1)) + (climb_8 * cosine_0)), -_s10, 0.1111111111111111 * _s13, (0.1111111111111111 * p_ring_radius) * _s4, 0.1111111111111111 * _s15};
}

/* Coefficients of order 10, from those of lower order.
   Routh's equations. 177 operations: 75 additions, 2 subtractions, 97 multiplications, 1 division, 2 negations. */
struct kernel_ring_round_9_out {
    double omega_9, around_9, cosine_10, sine_10, climb_10, along_10, turn_rate_10, tilted_10;
};

static __device__ __forceinline__ kernel_ring_round_9_out kernel_ring_round_9(double p_ball_radius, double p_gravity, double p_inertia, double p_ring_radius, double p_wire_radius, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double turn_rate_4, double turn_rate_5, double turn_rate_6, double turn_rate_7, double turn_rate_8, double turn_rate_9, double near_0, double climb_0, double climb_1, double climb_2, double climb_3, double climb_4, double climb_5, double climb_6, double climb_7, double climb_8, double climb_9, double cosine_0, double cosine_1, double cosine_2, double cosine_3, double cosine_4, double cosine_5, double cosine_6, double cosine_7, double cosine_8, double cosine_9, double sine_0, double sine_1, double sine_2, double sine_3, double sine_4, double sine_5, double sine_6, double sine_7, double sine_8, double sine_9, double along_9, double omega_0, double omega_1, double omega_2, double omega_3, double omega_4, double omega_5, double omega_6, double omega_7, double omega_8, double around_0, double around_1, double around_2, double around_3, double around_4, double around_5, double around_6, double around_7, double around_8, double tilted_0, double tilted_1, double tilted_2, double tilted_3, double tilted_4, double tilted_5, double tilted_6, double tilted_7, double tilted_8, double tilted_9)
{
    const double _s0 = p_ball_radius + p_wire_radius;
    const double _s1 = (((((cosine_1 * omega_8) + (cosine_2 * omega_7)) + (cosine_3 * omega_6)) + (cosine_4 * omega_5)) + (cosine_5 * omega_4)) + (cosine_6 * omega_3);
    const double _s2 = along_9 - (_s0 * (((_s1 + (cosine_7 * omega_2)) + (cosine_8 * omega_1)) + (cosine_9 * omega_0)));
    const double _s3 = near_0 * _s2;
    const double _s4 = (((((climb_0 * _s3) + (climb_1 * omega_8)) + (climb_2 * omega_7)) + (climb_3 * omega_6)) + (climb_4 * omega_5)) + (climb_5 * omega_4);
    const double _s5 = (((_s4 + (climb_6 * omega_3)) + (climb_7 * omega_2)) + (climb_8 * omega_1)) + (climb_9 * omega_0);
    const double _s6 = (((((climb_0 * sine_9) + (climb_1 * sine_8)) + (climb_2 * sine_7)) + (climb_3 * sine_6)) + (climb_4 * sine_5)) + (climb_5 * sine_4);
    const double _s7 = 0.1 * ((((_s6 + (climb_6 * sine_3)) + (climb_7 * sine_2)) + (climb_8 * sine_1)) + (climb_9 * sine_0));
    const double _s8 = (((((climb_0 * cosine_9) + (climb_1 * cosine_8)) + (climb_2 * cosine_7)) + (climb_3 * cosine_6)) + (climb_4 * cosine_5)) + (climb_5 * cosine_4);
    const double _s9 = 0.1 * ((((_s8 + (climb_6 * cosine_3)) + (climb_7 * cosine_2)) + (climb_8 * cosine_1)) + (climb_9 * cosine_0));
    const double _s10 = 1.0 / (1.0 + p_inertia);
    const double _s11 = (((((omega_0 * tilted_9) + (omega_1 * tilted_8)) + (omega_2 * tilted_7)) + (omega_3 * tilted_6)) + (omega_4 * tilted_5)) + (omega_5 * tilted_4);
    const double _s12 = ((p_gravity * cosine_9) * _s10) + ((((_s11 + (omega_6 * tilted_3)) + (omega_7 * tilted_2)) + (omega_8 * tilted_1)) + (tilted_0 * _s3));
    const double _s13 = (((((sine_0 * _s5) + (sine_1 * around_8)) + (sine_2 * around_7)) + (sine_3 * around_6)) + (sine_4 * around_5)) + (sine_5 * around_4);
    const double _s14 = _s0 * ((((_s13 + (sine_6 * around_3)) + (sine_7 * around_2)) + (sine_8 * around_1)) + (sine_9 * around_0));
    const double _s15 = (((((turn_rate_0 * climb_9) + (turn_rate_1 * climb_8)) + (turn_rate_2 * climb_7)) + (turn_rate_3 * climb_6)) + (turn_rate_4 * climb_5)) + (turn_rate_5 * climb_4);
    const double _s16 = (p_inertia * _s10) * ((((_s15 + (turn_rate_6 * climb_3)) + (turn_rate_7 * climb_2)) + (turn_rate_8 * climb_1)) + (turn_rate_9 * climb_0));
    const double _s17 = (((((cosine_0 * _s5) + (cosine_1 * around_8)) + (cosine_2 * around_7)) + (cosine_3 * around_6)) + (cosine_4 * around_5)) + (cosine_5 * around_4);
    const double _s18 = (p_ring_radius * _s10) * ((((_s17 + (cosine_6 * around_3)) + (cosine_7 * around_2)) + (cosine_8 * around_1)) + (cosine_9 * around_0));
    return {_s3, _s5, -_s7, _s9, -((0.1 * per_reach) * _s12), 0.1 * (_s14 - _s16), (0.1 * p_ring_radius) * _s5, 0.1 * (_s18 + (_s0 * _s5))};
}

/* Coefficients of order 11, from those of lower order.
   Routh's equations. 193 operations: 83 additions, 2 subtractions, 105 multiplications, 1 division, 2 negations. */
struct kernel_ring_round_10_out {
    double omega_10, around_10, cosine_11, sine_11, climb_11, along_11, turn_rate_11, tilted_11;
};

static __device__ __forceinline__ kernel_ring_round_10_out kernel_ring_round_10(double p_ball_radius, double p_gravity, double p_inertia, double p_ring_radius, double p_wire_radius, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double turn_rate_4, double turn_rate_5, double turn_rate_6, double turn_rate_7, double turn_rate_8, double turn_rate_9, double turn_rate_10, double near_0, double climb_0, double climb_1, double climb_2, double climb_3, double climb_4, double climb_5, double climb_6, double climb_7, double climb_8, double climb_9, double climb_10, double cosine_0, double cosine_1, double cosine_2, double cosine_3, double cosine_4, double cosine_5, double cosine_6, double cosine_7, double cosine_8, double cosine_9, double cosine_10, double sine_0, double sine_1, double sine_2, double sine_3, double sine_4, double sine_5, double sine_6, double sine_7, double sine_8, double sine_9, double sine_10, double along_10, double omega_0, double omega_1, double omega_2, double omega_3, double omega_4, double omega_5, double omega_6, double omega_7, double omega_8, double omega_9, double around_0, double around_1, double around_2, double around_3, double around_4, double around_5, double around_6, double around_7, double around_8, double around_9, double tilted_0, double tilted_1, double tilted_2, double tilted_3, double tilted_4, double tilted_5, double tilted_6, double tilted_7, double tilted_8, double tilted_9, double tilted_10)
{
    const double _s0 = p_ball_radius + p_wire_radius;
    const double _s1 = (((((cosine_1 * omega_9) + (cosine_2 * omega_8)) + (cosine_3 * omega_7)) + (cosine_4 * omega_6)) + (cosine_5 * omega_5)) + (cosine_6 * omega_4);
    const double _s2 = _s0 * ((((_s1 + (cosine_7 * omega_3)) + (cosine_8 * omega_2)) + (cosine_9 * omega_1)) + (cosine_10 * omega_0));
    const double _s3 = near_0 * (along_10 - _s2);
    const double _s4 = (((((climb_0 * _s3) + (climb_1 * omega_9)) + (climb_2 * omega_8)) + (climb_3 * omega_7)) + (climb_4 * omega_6)) + (climb_5 * omega_5);
    const double _s5 = ((((_s4 + (climb_6 * omega_4)) + (climb_7 * omega_3)) + (climb_8 * omega_2)) + (climb_9 * omega_1)) + (climb_10 * omega_0);
    const double _s6 = (((((climb_0 * sine_10) + (climb_1 * sine_9)) + (climb_2 * sine_8)) + (climb_3 * sine_7)) + (climb_4 * sine_6)) + (climb_5 * sine_5);
    const double _s7 = ((((_s6 + (climb_6 * sine_4)) + (climb_7 * sine_3)) + (climb_8 * sine_2)) + (climb_9 * sine_1)) + (climb_10 * sine_0);
    const double _s8 = (((((climb_0 * cosine_10) + (climb_1 * cosine_9)) + (climb_2 * cosine_8)) + (climb_3 * cosine_7)) + (climb_4 * cosine_6)) + (climb_5 * cosine_5);
    const double _s9 = ((((_s8 + (climb_6 * cosine_4)) + (climb_7 * cosine_3)) + (climb_8 * cosine_2)) + (climb_9 * cosine_1)) + (climb_10 * cosine_0);
    const double _s10 = 1.0 / (1.0 + p_inertia);
    const double _s11 = (((((omega_0 * tilted_10) + (omega_1 * tilted_9)) + (omega_2 * tilted_8)) + (omega_3 * tilted_7)) + (omega_4 * tilted_6)) + (omega_5 * tilted_5);
    const double _s12 = ((((_s11 + (omega_6 * tilted_4)) + (omega_7 * tilted_3)) + (omega_8 * tilted_2)) + (omega_9 * tilted_1)) + (tilted_0 * _s3);
    const double _s13 = (((((sine_0 * _s5) + (sine_1 * around_9)) + (sine_2 * around_8)) + (sine_3 * around_7)) + (sine_4 * around_6)) + (sine_5 * around_5);
    const double _s14 = ((((_s13 + (sine_6 * around_4)) + (sine_7 * around_3)) + (sine_8 * around_2)) + (sine_9 * around_1)) + (sine_10 * around_0);
    const double _s15 = (((((turn_rate_0 * climb_10) + (turn_rate_1 * climb_9)) + (turn_rate_2 * climb_8)) + (turn_rate_3 * climb_7)) + (turn_rate_4 * climb_6)) + (turn_rate_5 * climb_5);
    const double _s16 = ((((_s15 + (turn_rate_6 * climb_4)) + (turn_rate_7 * climb_3)) + (turn_rate_8 * climb_2)) + (turn_rate_9 * climb_1)) + (turn_rate_10 * climb_0);
    const double _s17 = (((((cosine_0 * _s5) + (cosine_1 * around_9)) + (cosine_2 * around_8)) + (cosine_3 * around_7)) + (cosine_4 * around_6)) + (cosine_5 * around_5);
    const double _s18 = ((((_s17 + (cosine_6 * around_4)) + (cosine_7 * around_3)) + (cosine_8 * around_2)) + (cosine_9 * around_1)) + (cosine_10 * around_0);
    return {_s3, _s5, -(0.09090909090909091 * _s7), 0.09090909090909091 * _s9, -((0.09090909090909091 * per_reach) * (((p_gravity * cosine_10) * _s10) + _s12)), 0.09090909090909091 * ((_s0 * _s14) - ((p_inertia * _s10) * _s16)), (0.09090909090909091 * p_ring_radius) * _s5, 0.09090909090909091 * (((p_ring_radius * _s10) * _s18) + (_s0 * _s5))};
}

/* Coefficients of order 12, from those of lower order.
   Routh's equations. 209 operations: 91 additions, 2 subtractions, 113 multiplications, 1 division, 2 negations. */
struct kernel_ring_round_11_out {
    double omega_11, around_11, cosine_12, sine_12, climb_12, along_12, turn_rate_12, tilted_12;
};

static __device__ __forceinline__ kernel_ring_round_11_out kernel_ring_round_11(double p_ball_radius, double p_gravity, double p_inertia, double p_ring_radius, double p_wire_radius, double per_reach, double turn_rate_0, double turn_rate_1, double turn_rate_2, double turn_rate_3, double turn_rate_4, double turn_rate_5, double turn_rate_6, double turn_rate_7, double turn_rate_8, double turn_rate_9, double turn_rate_10, double turn_rate_11, double near_0, double climb_0, double climb_1, double climb_2, double climb_3, double climb_4, double climb_5, double climb_6, double climb_7, double climb_8, double climb_9, double climb_10, double climb_11, double cosine_0, double cosine_1, double cosine_2, double cosine_3, double cosine_4, double cosine_5, double cosine_6, double cosine_7, double cosine_8, double cosine_9, double cosine_10, double cosine_11, double sine_0, double sine_1, double sine_2, double sine_3, double sine_4, double sine_5, double sine_6, double sine_7, double sine_8, double sine_9, double sine_10, double sine_11, double along_11, double omega_0, double omega_1, double omega_2, double omega_3, double omega_4, double omega_5, double omega_6, double omega_7, double omega_8, double omega_9, double omega_10, double around_0, double around_1, double around_2, double around_3, double around_4, double around_5, double around_6, double around_7, double around_8, double around_9, double around_10, double tilted_0, double tilted_1, double tilted_2, double tilted_3, double tilted_4, double tilted_5, double tilted_6, double tilted_7, double tilted_8, double tilted_9, double tilted_10, double tilted_11)
{
    const double _s0 = p_ball_radius + p_wire_radius;
    const double _s1 = (((((cosine_1 * omega_10) + (cosine_2 * omega_9)) + (cosine_3 * omega_8)) + (cosine_4 * omega_7)) + (cosine_5 * omega_6)) + (cosine_6 * omega_5);
    const double _s2 = ((((_s1 + (cosine_7 * omega_4)) + (cosine_8 * omega_3)) + (cosine_9 * omega_2)) + (cosine_10 * omega_1)) + (cosine_11 * omega_0);
    const double _s3 = near_0 * (along_11 - (_s0 * _s2));
    const double _s4 = (((((climb_0 * _s3) + (climb_1 * omega_10)) + (climb_2 * omega_9)) + (climb_3 * omega_8)) + (climb_4 * omega_7)) + (climb_5 * omega_6);
    const double _s5 = ((((_s4 + (climb_6 * omega_5)) + (climb_7 * omega_4)) + (climb_8 * omega_3)) + (climb_9 * omega_2)) + (climb_10 * omega_1);
    const double _s6 = _s5 + (climb_11 * omega_0);
    const double _s7 = (((((climb_0 * sine_11) + (climb_1 * sine_10)) + (climb_2 * sine_9)) + (climb_3 * sine_8)) + (climb_4 * sine_7)) + (climb_5 * sine_6);
    const double _s8 = ((((_s7 + (climb_6 * sine_5)) + (climb_7 * sine_4)) + (climb_8 * sine_3)) + (climb_9 * sine_2)) + (climb_10 * sine_1);
    const double _s9 = (((((climb_0 * cosine_11) + (climb_1 * cosine_10)) + (climb_2 * cosine_9)) + (climb_3 * cosine_8)) + (climb_4 * cosine_7)) + (climb_5 * cosine_6);
    const double _s10 = ((((_s9 + (climb_6 * cosine_5)) + (climb_7 * cosine_4)) + (climb_8 * cosine_3)) + (climb_9 * cosine_2)) + (climb_10 * cosine_1);
    const double _s11 = 1.0 / (1.0 + p_inertia);
    const double _s12 = (((((omega_0 * tilted_11) + (omega_1 * tilted_10)) + (omega_2 * tilted_9)) + (omega_3 * tilted_8)) + (omega_4 * tilted_7)) + (omega_5 * tilted_6);
    const double _s13 = ((((_s12 + (omega_6 * tilted_5)) + (omega_7 * tilted_4)) + (omega_8 * tilted_3)) + (omega_9 * tilted_2)) + (omega_10 * tilted_1);
    const double _s14 = (((((sine_0 * _s6) + (sine_1 * around_10)) + (sine_2 * around_9)) + (sine_3 * around_8)) + (sine_4 * around_7)) + (sine_5 * around_6);
    const double _s15 = ((((_s14 + (sine_6 * around_5)) + (sine_7 * around_4)) + (sine_8 * around_3)) + (sine_9 * around_2)) + (sine_10 * around_1);
    const double _s16 = (((((turn_rate_0 * climb_11) + (turn_rate_1 * climb_10)) + (turn_rate_2 * climb_9)) + (turn_rate_3 * climb_8)) + (turn_rate_4 * climb_7)) + (turn_rate_5 * climb_6);
    const double _s17 = ((((_s16 + (turn_rate_6 * climb_5)) + (turn_rate_7 * climb_4)) + (turn_rate_8 * climb_3)) + (turn_rate_9 * climb_2)) + (turn_rate_10 * climb_1);
    const double _s18 = (((((cosine_0 * _s6) + (cosine_1 * around_10)) + (cosine_2 * around_9)) + (cosine_3 * around_8)) + (cosine_4 * around_7)) + (cosine_5 * around_6);
    const double _s19 = ((((_s18 + (cosine_6 * around_5)) + (cosine_7 * around_4)) + (cosine_8 * around_3)) + (cosine_9 * around_2)) + (cosine_10 * around_1);
    return {_s3, _s6, -(0.08333333333333333 * (_s8 + (climb_11 * sine_0))), 0.08333333333333333 * (_s10 + (climb_11 * cosine_0)), -((0.08333333333333333 * per_reach) * (((p_gravity * cosine_11) * _s11) + (_s13 + (tilted_0 * _s3)))), 0.08333333333333333 * ((_s0 * (_s15 + (sine_11 * around_0))) - ((p_inertia * _s11) * (_s17 + (turn_rate_11 * climb_0)))), (0.08333333333333333 * p_ring_radius) * _s6, 0.08333333333333333 * (((p_ring_radius * _s11) * (_s19 + (cosine_11 * around_0))) + (_s0 * _s6))};
}

/* First window that ends later than a time, from then on.
   Table 1. 18 operations: 6 comparisons, 3 disjunctions, 9 selections. */
struct kernel_ring_enter_out {
    double t, end;
    bool searching;
};

static __device__ __forceinline__ kernel_ring_enter_out kernel_ring_enter(double t, double end, double after, double low0, double low1, double low2, double high0, double high1, double high2)
{
    const double _s0 = larger(after, low0);
    const bool _s1 = _s0 < high0;
    const double _s2 = larger(after, low1);
    const bool _s3 = _s2 < high1;
    const double _s4 = larger(after, low2);
    const bool _s5 = _s4 < high2;
    return {choose(_s1, _s0, choose(_s3, _s2, choose(_s5, _s4, t))), choose(_s1, high0, choose(_s3, high1, choose(_s5, high2, end))), ((false || _s5) || _s3) || _s1};
}

/* Outward unit normal n3 at a contact.
   Table 2. 36 operations: 6 additions, 6 subtractions, 4 multiplications, 3 divisions, 1 square root, 2 negations, 7 comparisons, 7 selections. */
struct kernel_backboard_normal_out {
    double nx, ny, nz;
};

static __device__ __forceinline__ kernel_backboard_normal_out kernel_backboard_normal(double x, double y, double z, double p_ball_radius, double p_board_distance, double p_board_half_width, double p_board_bottom, double p_board_top, double p_board_thickness)
{
    const double _s0 = p_board_distance + x;
    const double _s1 = -((p_board_distance + p_board_thickness) + x);
    const double _s2 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s3 = y - p_board_half_width;
    const double _s4 = -(p_board_half_width + y);
    const double _s5 = larger(_s3, 0.0) - larger(_s4, 0.0);
    const double _s6 = z - p_board_top;
    const double _s7 = p_board_bottom - z;
    const double _s8 = larger(_s6, 0.0) - larger(_s7, 0.0);
    const double _s9 = sqrt((((_s2 * _s2) + (_s5 * _s5)) + (_s8 * _s8)));
    const double _s10 = 0.5 * p_ball_radius;
    const double _s11 = larger(_s9, _s10);
    return {_s2 / _s11, _s5 / _s11, _s8 / _s11};
}

/* Bound on the rate at which the normal turns along the contact surface.
   Table 2. 61 operations: 12 additions, 3 subtractions, 8 multiplications, 1 division, 2 negations, 9 absolute values, 13 comparisons, 13 selections. */
struct kernel_backboard_curvature_out {
    double curvature;
};

static __device__ __forceinline__ kernel_backboard_curvature_out kernel_backboard_curvature(double t, double x, double y, double z, double vx, double vy, double vz, double dx, double dy, double dz, double dvx, double dvy, double dvz, double p_ball_radius, double p_board_distance, double p_board_half_width, double p_board_bottom, double p_board_top, double p_board_thickness, double p_gravity)
{
    const double _s0 = 2.0 * t;
    const double _s1 = fabs(dvx);
    const double _s2 = fabs(dvy);
    const double _s3 = larger(_s1, _s2);
    const double _s4 = fabs(dvz);
    const double _s5 = fabs(dx);
    const double _s6 = fabs(dy);
    const double _s7 = larger(_s5, _s6);
    const double _s8 = fabs(dz);
    const double _s9 = 16.0 * ((t * larger(_s3, _s4)) + larger(_s7, _s8));
    const double _s10 = z - p_board_top;
    const double _s11 = p_board_bottom - z;
    const double _s12 = (((p_gravity * (t * t)) + (_s0 * fabs(vz))) + _s9) + larger(_s10, _s11);
    const double _s13 = p_board_distance + x;
    const double _s14 = -((p_board_distance + p_board_thickness) + x);
    const double _s15 = ((_s0 * fabs(vx)) + _s9) + larger(_s13, _s14);
    const double _s16 = larger(_s12, _s15);
    const double _s17 = y - p_board_half_width;
    const double _s18 = -(p_board_half_width + y);
    const double _s19 = ((_s0 * fabs(vy)) + _s9) + larger(_s17, _s18);
    const double _s20 = larger(_s19, _s12);
    const double _s21 = larger(_s15, _s19);
    const double _s22 = smaller(_s20, _s21);
    return {choose((smaller(_s16, _s22) < 0.0), 0.0, (1.0 / p_ball_radius))};
}

/* Tangent and curvatures at a contact, and bounds on the roundings there.
   Table 2, running error analysis. 185 operations: 43 additions, 11 subtractions, 49 multiplications, 4 divisions, 1 square root, 6 negations, 22 absolute values, 23 comparisons, 2 conjunctions, 24 selections. */
struct kernel_backboard_tangents_out {
    float tangent_x, tangent_y, bend_s, bend_e, sharpest_bend, root_offset, root_level, normal_rounding;
};

static __device__ __forceinline__ kernel_backboard_tangents_out kernel_backboard_tangents(float t, float x, float y, float z, float vx, float vy, float vz, float nx, float ny, float nz, float place_n, float normal_velocity, float back, float p_ball_radius, float p_board_distance, float p_board_half_width, float p_board_bottom, float p_board_top, float p_board_thickness, float p_gravity)
{
    const float _s0 = sqrtf(((nx * nx) + (ny * ny)));
    const bool _s1 = ((float)0.0) < _s0;
    const float _s2 = ((float)1.0) / _s0;
    const float _s3 = z - p_board_top;
    const float _s4 = p_board_bottom - z;
    const float _s5 = fabsf((larger(_s3, ((float)0.0)) - larger(_s4, ((float)0.0))));
    const float _s6 = ((float)1.0) / p_ball_radius;
    const float _s7 = p_board_distance + x;
    const float _s8 = p_board_distance + p_board_thickness;
    const float _s9 = -(_s8 + x);
    const float _s10 = fabsf((larger(_s7, ((float)0.0)) - larger(_s9, ((float)0.0))));
    const float _s11 = y - p_board_half_width;
    const float _s12 = -(p_board_half_width + y);
    const float _s13 = fabsf((larger(_s11, ((float)0.0)) - larger(_s12, ((float)0.0))));
    const float _s14 = choose(((((float)0.0) < _s10) && (((float)0.0) < _s13)), (_s6 * _s2), ((float)0.0));
    const float _s15 = fabsf(_s3);
    const float _s16 = fabsf((z - p_board_bottom));
    const float _s17 = fabsf(_s11);
    const float _s18 = fabsf((y - (-p_board_half_width)));
    const float _s19 = fabsf((x - (-p_board_distance)));
    const float _s20 = fabsf((x - (-_s8)));
    const float _s21 = smaller(_s19, _s20);
    const float _s22 = smaller(_s18, _s21);
    const float _s23 = smaller(_s17, _s22);
    const float _s24 = smaller(_s16, _s23);
    const float _s25 = ((float)9.5367431640625e-07) * (((((((float)2.0) * p_board_distance) + (((float)2.0) * p_board_half_width)) + p_board_thickness) + fabsf(p_board_bottom)) + fabsf(p_board_top));
    const float _s26 = smaller(_s15, _s24) - _s25;
    const float _s27 = larger(_s6, _s14);
    const float _s28 = ((float)1.0) / (((float)50.0) * _s26);
    const float _s29 = ((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * (t * fabsf(normal_velocity)));
    const float _s30 = t * t;
    const float _s31 = fabsf(vx);
    const float _s32 = fabsf(vy);
    const float _s33 = (p_gravity * _s30) + (t * ((_s31 + _s32) + fabsf(vz)));
    const float _s34 = ((float)2.0) * t;
    const float _s35 = ((((float)2.220446049250313e-16) * p_board_distance) + (((float)2.220446049250313e-16) * p_board_thickness)) + (((float)1.1102230246251565e-16) * _s10);
    const float _s36 = (((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * ((_s34 * _s31) + fabsf(x)))) + (((float)2.0) * _s35);
    const float _s37 = ((float)1.1102230246251565e-16) * _s13;
    const float _s38 = (((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * ((_s34 * _s32) + fabsf(y)))) + (((float)2.0) * _s37);
    const float _s39 = ((float)0.5) * p_gravity;
    const float _s40 = ((_s39 * _s30) + (_s34 * fabsf((vz + (_s39 * t))))) + fabsf(z);
    const float _s41 = ((float)1.1102230246251565e-16) * _s5;
    const float _s42 = (((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * _s40)) + (((float)2.0) * _s41);
    const float _s43 = ((_s6 * _s33) * ((_s36 + _s38) + _s42)) + (((float)1.3322676295501878e-15) * _s33);
    const float _s44 = ((float)1.125) * _s43;
    const float _s45 = ((float)1.7763568394002505e-15) * (p_ball_radius * ((normal_velocity * normal_velocity) / (((vx * vx) + (vy * vy)) + (vz * vz))));
    const float _s46 = (_s29 + _s43) + larger(_s44, _s45);
    const float _s47 = (((float)8.881784197001252e-16) * p_ball_radius) + (((fabsf(nx) * _s36) + (fabsf(ny) * _s38)) + (fabsf(nz) * _s42));
    const float _s48 = ((float)1.125) * _s47;
    const float _s49 = (_s29 + _s47) + larger(_s48, _s45);
    const float _s50 = place_n + _s49;
    const bool _s51 = ((float)0.0) < back;
    const float _s52 = place_n + _s46;
    return {choose(_s1, (-(ny * _s2)), ((float)0.0)), choose(_s1, (nx * _s2), ((float)1.0)), choose(((((float)0.0) < _s5) && _s1), _s6, ((float)0.0)), _s14, choose((((float)0.0) < _s26), larger(_s27, _s28), ((float)INFINITE)), choose(_s51, larger(_s46, _s50), _s49), choose(_s51, larger(_s52, _s49), _s49), ((float)8.881784197001252e-16) + ((((float)2.0) * _s6) * ((_s35 + _s37) + _s41))};
}

/* Error of the normal, from that of the position.
   derivative of Table 2's normal. 101 operations: 11 additions, 12 subtractions, 18 multiplications, 8 divisions, 1 square root, 5 negations, 23 comparisons, 23 selections. */
struct kernel_backboard_carry_normal_out {
    double dnx, dny, dnz, turn;
};

static __device__ __forceinline__ kernel_backboard_carry_normal_out kernel_backboard_carry_normal(double x, double y, double z, double dx, double dy, double dz, double shift, double p_ball_radius, double p_board_distance, double p_board_half_width, double p_board_bottom, double p_board_top, double p_board_thickness)
{
    const double _s0 = p_board_distance + x;
    const double _s1 = -((p_board_distance + p_board_thickness) + x);
    const double _s2 = choose((_s0 < 0.0), 0.0, dx) - choose((_s1 < 0.0), 0.0, (-dx));
    const double _s3 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s4 = y - p_board_half_width;
    const double _s5 = -(p_board_half_width + y);
    const double _s6 = larger(_s4, 0.0) - larger(_s5, 0.0);
    const double _s7 = z - p_board_top;
    const double _s8 = p_board_bottom - z;
    const double _s9 = larger(_s7, 0.0) - larger(_s8, 0.0);
    const double _s10 = sqrt((((_s3 * _s3) + (_s6 * _s6)) + (_s9 * _s9)));
    const double _s11 = 0.5 * p_ball_radius;
    const double _s12 = larger(_s10, _s11);
    const double _s13 = choose((_s4 < 0.0), 0.0, dy) - choose((_s5 < 0.0), 0.0, (-dy));
    const double _s14 = choose((_s7 < 0.0), 0.0, dz) - choose((_s8 < 0.0), 0.0, (-dz));
    const double _s15 = (0.5 * ((((2.0 * _s2) * _s3) + ((2.0 * _s13) * _s6)) + ((2.0 * _s14) * _s9))) * (1.0 / _s10);
    const double _s16 = choose((_s10 < _s11), 0.0, _s15);
    const double _s17 = _s12 * _s12;
    const double _s18 = 16.0 * shift;
    const double _s19 = _s18 + larger(_s7, _s8);
    const double _s20 = _s18 + larger(_s0, _s1);
    const double _s21 = larger(_s19, _s20);
    const double _s22 = _s18 + larger(_s4, _s5);
    const double _s23 = larger(_s22, _s19);
    const double _s24 = larger(_s20, _s22);
    const double _s25 = smaller(_s23, _s24);
    return {(_s2 / _s12) - ((_s3 * _s16) / _s17), (_s13 / _s12) - ((_s6 * _s16) / _s17), (_s14 / _s12) - ((_s9 * _s16) / _s17), shift * choose((smaller(_s21, _s25) < 0.0), 0.0, (1.0 / p_ball_radius))};
}

/* Constants and windows of the search along a flight, and its error budget.
   bounds of the event condition. 142 operations: 29 additions, 10 subtractions, 31 multiplications, 5 divisions, 4 square roots, 5 negations, 4 absolute values, 26 comparisons, 28 selections. */
struct kernel_backboard_prepare_out {
    double low0, high0, low1, high1, ceiling, latest, budget_exceeded;
};

static __device__ __forceinline__ kernel_backboard_prepare_out kernel_backboard_prepare(double horizon, double x, double y, double z, double vx, double vy, double vz, double extent, double speed, double position_error, double velocity_error, double earliest_delay, double pad, double p_ball_radius, double p_board_distance, double p_board_half_width, double p_board_bottom, double p_board_top, double p_board_thickness, double p_gravity)
{
    const double _s0 = fabs(vx);
    const double _s1 = 0.5 * p_board_thickness;
    const double _s2 = p_ball_radius + _s1;
    const double _s3 = 0.5 * p_board_top;
    const double _s4 = p_ball_radius + _s3;
    const double _s5 = 0.5 * p_board_bottom;
    const double _s6 = _s4 - _s5;
    const double _s7 = p_ball_radius + p_board_half_width;
    const double _s8 = smaller(_s7, _s2);
    const double _s9 = smaller(_s6, _s8);
    const double _s10 = 6.103515625e-05 * _s9;
    const double _s11 = _s2 + _s10;
    const double _s12 = p_board_distance + _s1;
    const double _s13 = _s12 + x;
    const double _s14 = choose((vx < 0.0), (-_s13), _s13);
    const double _s15 = (-(_s11 + _s14)) / _s0;
    const double _s16 = larger(0.0, _s15);
    const double _s17 = fabs(vy);
    const double _s18 = _s7 + _s10;
    const double _s19 = choose((vy < 0.0), (-y), y);
    const double _s20 = (-(_s18 + _s19)) / _s17;
    const double _s21 = larger(_s16, _s20);
    const double _s22 = vz * vz;
    const double _s23 = (z - _s5) - _s3;
    const double _s24 = (_s4 + _s10) - _s5;
    const double _s25 = 2.0 * p_gravity;
    const double _s26 = _s22 + (_s25 * (_s23 + _s24));
    const double _s27 = 1.0 / p_gravity;
    const double _s28 = sqrt(_s26);
    const bool _s29 = 0.0 <= _s26;
    const double _s30 = choose(_s29, (_s27 * (vz - _s28)), (INFINITE));
    const double _s31 = larger(_s21, _s30);
    const double _s32 = _s22 + (_s25 * (_s23 - _s24));
    const double _s33 = sqrt(larger(_s32, 0.0));
    const double _s34 = choose(_s29, (_s27 * (vz + _s28)), (-INFINITE));
    const bool _s35 = 0.0 < _s32;
    const double _s36 = choose(_s35, (_s27 * (vz - _s33)), _s34);
    const double _s37 = (_s18 - _s19) / _s17;
    const double _s38 = (_s11 - _s14) / _s0;
    const double _s39 = smaller(_s38, (INFINITE));
    const double _s40 = smaller(_s37, _s39);
    const double _s41 = smaller(_s36, _s40);
    const double _s42 = choose(_s35, (_s27 * (vz + _s33)), (INFINITE));
    const double _s43 = larger(_s21, _s42);
    const double _s44 = smaller(_s34, _s40);
    const double _s45 = larger(0.0, _s41);
    const double _s46 = larger(_s45, _s44);
    const double _s47 = smaller(_s46, horizon);
    const double _s48 = speed + (p_gravity * _s47);
    const double _s49 = 2.0 * (((1.25 * fabs((-p_gravity))) * (p_ball_radius + (0.0001220703125 * _s9))) + (3.0 * (_s48 * _s48)));
    const double _s50 = larger(_s2, _s7);
    const double _s51 = ((_s12 + extent) + fabs((_s5 + _s3))) + larger(_s50, _s6);
    const double _s52 = (sqrt(2.0) * sqrt((_s27 * (_s51 + _s9)))) + ((2.0 * speed) * _s27);
    const double _s53 = ((position_error + (velocity_error * smaller(_s52, horizon))) + (3.552713678800501e-15 * (((speed * speed) * _s27) + _s51))) + choose(((2.0 * pad) < earliest_delay), (earliest_delay * (speed + (p_gravity * horizon))), 0.0);
    return {larger(0.0, _s31), smaller(_s41, horizon), larger(0.0, _s43), smaller(_s44, horizon), _s49, _s47, _s53 - (1.52587890625e-05 * _s9)};
}

/* Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.
   running error analysis. 83 operations: 31 additions, 1 subtraction, 45 multiplications, 2 absolute values, 2 comparisons, 2 selections. */
struct kernel_backboard_margins_out {
    double margin, leaving_margin, rate_margin;
};

static __device__ __forceinline__ kernel_backboard_margins_out kernel_backboard_margins(double horizon, double extent, double speed, double position_error, double velocity_error, double p_ball_radius, double p_board_distance, double p_board_half_width, double p_board_bottom, double p_board_top, double p_board_thickness, double p_gravity)
{
    const double _s0 = (p_ball_radius + (0.5 * p_board_top)) - (0.5 * p_board_bottom);
    const double _s1 = p_ball_radius + p_board_half_width;
    const double _s2 = p_ball_radius + (0.5 * p_board_thickness);
    const double _s3 = smaller(_s1, _s2);
    const double _s4 = p_ball_radius + (0.0001220703125 * smaller(_s0, _s3));
    const double _s5 = speed + (p_gravity * horizon);
    const double _s6 = extent + (horizon * _s5);
    const double _s7 = 2.220446049250313e-16 * _s6;
    const double _s8 = 2.0 * ((position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * _s6));
    const double _s9 = ((3.3306690738754696e-16 * p_board_half_width) + _s7) + _s8;
    const double _s10 = 2.001953125 * _s4;
    const double _s11 = (((3.3306690738754696e-16 * p_board_distance) + (2.220446049250313e-16 * p_board_thickness)) + (3.3306690738754696e-16 * _s6)) + _s8;
    const double _s12 = (((2.220446049250313e-16 * fabs(p_board_bottom)) + (2.220446049250313e-16 * fabs(p_board_top))) + _s7) + _s8;
    const double _s13 = ((((5.55653613398821e-16 * (p_ball_radius * p_ball_radius)) + (_s10 * _s9)) + (_s10 * _s11)) + (_s10 * _s12)) + (((1.3335686721571705e-15 * horizon) * _s4) * _s5);
    const double _s14 = 4.00390625 * _s5;
    const double _s15 = ((((6.667843360785852e-15 * _s4) * _s5) + ((12.01171875 * _s4) * (velocity_error + (3.3306690738754696e-16 * _s5)))) + (_s14 * _s9)) + (_s14 * _s11);
    const double _s16 = 2.001953125 * _s5;
    const double _s17 = ((((2.667137344314341e-15 * _s4) * _s5) + ((6.005859375 * _s4) * (velocity_error + (2.220446049250313e-16 * _s5)))) + (_s16 * _s9)) + (_s16 * _s11);
    return {_s13 + (1.3335686721571705e-15 * (_s4 * _s4)), _s15 + (_s14 * _s12), _s17 + (_s16 * _s12)};
}

/* Newton's next value of a root near t, and gap and rate there.
   Newton's method. 101 operations: 19 additions, 19 subtractions, 26 multiplications, 1 division, 4 negations, 16 comparisons, 16 selections. */
struct kernel_backboard_refine_out {
    double time, gap, rate;
};

static __device__ __forceinline__ kernel_backboard_refine_out kernel_backboard_refine(double t, double leaving, double x, double y, double z, double vx, double vy, double vz, double p_ball_radius, double p_board_distance, double p_board_half_width, double p_board_bottom, double p_board_top, double p_board_thickness, double p_gravity)
{
    const double _s0 = x + (vx * t);
    const double _s1 = p_board_distance + _s0;
    const double _s2 = p_board_distance + p_board_thickness;
    const double _s3 = -(_s2 + _s0);
    const double _s4 = larger(_s1, 0.0) - larger(_s3, 0.0);
    const double _s5 = y + (vy * t);
    const double _s6 = _s5 - p_board_half_width;
    const double _s7 = -(p_board_half_width + _s5);
    const double _s8 = larger(_s6, 0.0) - larger(_s7, 0.0);
    const double _s9 = vz - ((0.5 * p_gravity) * t);
    const double _s10 = z + (t * _s9);
    const double _s11 = _s10 - p_board_top;
    const double _s12 = p_board_bottom - _s10;
    const double _s13 = larger(_s11, 0.0) - larger(_s12, 0.0);
    const double _s14 = 2.0 * (((vx * _s4) + (vy * _s8)) + ((vz - (p_gravity * t)) * _s13));
    const double _s15 = p_board_distance + x;
    const double _s16 = -(_s2 + x);
    const double _s17 = larger(_s15, 0.0) - larger(_s16, 0.0);
    const double _s18 = _s4 * _s4;
    const double _s19 = y - p_board_half_width;
    const double _s20 = -(p_board_half_width + y);
    const double _s21 = larger(_s19, 0.0) - larger(_s20, 0.0);
    const double _s22 = _s8 * _s8;
    const double _s23 = z - p_board_top;
    const double _s24 = p_board_bottom - z;
    const double _s25 = larger(_s23, 0.0) - larger(_s24, 0.0);
    const double _s26 = _s13 * _s13;
    const double _s27 = (choose((0.0 < (_s17 * _s4)), (t * (vx * (_s17 + _s4))), (_s18 - (_s17 * _s17))) + choose((0.0 < (_s21 * _s8)), (t * (vy * (_s21 + _s8))), (_s22 - (_s21 * _s21)))) + choose((0.0 < (_s25 * _s13)), (t * (_s9 * (_s25 + _s13))), (_s26 - (_s25 * _s25)));
    const double _s28 = choose((0.0 < leaving), _s27, (((_s18 + _s22) + _s26) - (p_ball_radius * p_ball_radius)));
    return {t - (_s28 / _s14), _s28, _s14};
}

/* Gap, rate, second derivative, a step without a root, its end, and the clearance.
   Newton from the left under a curvature bound. 190 operations: 33 additions, 25 subtractions, 49 multiplications, 2 divisions, 1 square root, 8 negations, 5 absolute values, 32 comparisons, 35 selections. */
struct kernel_backboard_advance_out {
    double gap, rate, bend, step, next, clearance;
};

static __device__ __forceinline__ kernel_backboard_advance_out kernel_backboard_advance(double t, double end, double leaving, double margin, double rate_margin, double ceiling, double x, double y, double z, double vx, double vy, double vz, double p_ball_radius, double p_board_distance, double p_board_half_width, double p_board_bottom, double p_board_top, double p_board_thickness, double p_gravity)
{
    const double _s0 = p_board_distance + x;
    const double _s1 = p_board_distance + p_board_thickness;
    const double _s2 = -(_s1 + x);
    const double _s3 = larger(_s0, 0.0) - larger(_s2, 0.0);
    const double _s4 = x + (vx * t);
    const double _s5 = p_board_distance + _s4;
    const double _s6 = -(_s1 + _s4);
    const double _s7 = larger(_s5, 0.0) - larger(_s6, 0.0);
    const double _s8 = _s7 * _s7;
    const double _s9 = y - p_board_half_width;
    const double _s10 = -(p_board_half_width + y);
    const double _s11 = larger(_s9, 0.0) - larger(_s10, 0.0);
    const double _s12 = y + (vy * t);
    const double _s13 = _s12 - p_board_half_width;
    const double _s14 = -(p_board_half_width + _s12);
    const double _s15 = larger(_s13, 0.0) - larger(_s14, 0.0);
    const double _s16 = _s15 * _s15;
    const double _s17 = z - p_board_top;
    const double _s18 = p_board_bottom - z;
    const double _s19 = larger(_s17, 0.0) - larger(_s18, 0.0);
    const double _s20 = vz - ((0.5 * p_gravity) * t);
    const double _s21 = z + (t * _s20);
    const double _s22 = _s21 - p_board_top;
    const double _s23 = p_board_bottom - _s21;
    const double _s24 = larger(_s22, 0.0) - larger(_s23, 0.0);
    const double _s25 = _s24 * _s24;
    const double _s26 = (choose((0.0 < (_s3 * _s7)), (t * (vx * (_s3 + _s7))), (_s8 - (_s3 * _s3))) + choose((0.0 < (_s11 * _s15)), (t * (vy * (_s11 + _s15))), (_s16 - (_s11 * _s11)))) + choose((0.0 < (_s19 * _s24)), (t * (_s20 * (_s19 + _s24))), (_s25 - (_s19 * _s19)));
    const double _s27 = choose((0.0 < leaving), _s26, (((_s8 + _s16) + _s25) - (p_ball_radius * p_ball_radius)));
    const double _s28 = vz - (p_gravity * t);
    const double _s29 = 2.0 * (((vx * _s7) + (vy * _s15)) + (_s28 * _s24));
    const double _s30 = fabs(_s24);
    const double _s31 = 2.0 * ((choose((0.0 < fabs(_s7)), (vx * vx), 0.0) + choose((0.0 < fabs(_s15)), (vy * vy), 0.0)) + choose((0.0 < _s30), ((_s28 * _s28) - (p_gravity * _s24)), 0.0));
    const double _s32 = fabs((-p_gravity));
    const double _s33 = (p_ball_radius + (0.5 * p_board_top)) - (0.5 * p_board_bottom);
    const double _s34 = p_ball_radius + p_board_half_width;
    const double _s35 = p_ball_radius + (0.5 * p_board_thickness);
    const double _s36 = smaller(_s34, _s35);
    const double _s37 = p_ball_radius + (0.0001220703125 * smaller(_s33, _s36));
    const double _s38 = _s29 - rate_margin;
    const double _s39 = _s27 - margin;
    const double _s40 = larger(_s39, 0.0);
    const double _s41 = -_s31;
    const bool _s42 = _s38 < 0.0;
    const double _s43 = 2.0 * _s40;
    const double _s44 = choose((0.0 < choose((0.0 <= _s38), _s40, 0.0)), (INFINITE), (choose(_s42, _s43, (4.0 * _s38)) / choose(_s42, (-_s38), larger(0.0, _s41))));
    const double _s45 = end - t;
    const double _s46 = smaller(_s44, _s45);
    const double _s47 = ((((0.5 * _s32) * _s46) + fabs(_s28)) * _s46) + _s30;
    const double _s48 = (9.094947017729282e-13 * ceiling) + (2.0 * (_s32 * smaller(_s37, _s47)));
    const double _s49 = ((2.0 * _s48) * _s40) + (_s38 * _s38);
    const double _s50 = sqrt(_s49);
    const double _s51 = choose((0.0 <= _s49), (choose(_s42, _s43, (_s38 + _s50)) / choose(_s42, (_s50 - _s38), larger(0.0, _s48))), (INFINITE));
    const double _s52 = smaller(_s51, _s46);
    const double _s53 = -(rate_margin + _s29);
    return {_s27, _s29, _s31, _s52, t + _s52, choose((0.0 < _s53), ((_s53 * _s53) - ((8.0 * ceiling) * (margin + _s43))), _s53)};
}

/* Whether a flight may reach the box of a surface at all.
   disjoint boxes. 27 operations: 7 additions, 3 subtractions, 5 multiplications, 1 negation, 5 comparisons, 1 conjunction, 2 complements, 3 selections. */
struct kernel_backboard_near_out {
    bool near;
};

static __device__ __forceinline__ kernel_backboard_near_out kernel_backboard_near(double horizon, double x, double vx, double extent, double speed, double position_error, double velocity_error, double earliest_delay, double pad, double p_ball_radius, double p_board_distance, double p_board_thickness, double p_gravity)
{
    const double _s0 = (position_error + (horizon * velocity_error)) + (9.313225746154785e-10 * (extent + (horizon * (speed + (p_gravity * horizon)))));
    const double _s1 = choose((pad < earliest_delay), (INFINITE), _s0);
    const double _s2 = x + (vx * horizon);
    const bool _s3 = !(_s1 < ((-((p_ball_radius + p_board_distance) + p_board_thickness)) - larger(x, _s2)));
    return {(!(_s1 < (smaller(_s2, x) - (p_ball_radius - p_board_distance)))) && _s3};
}

/* Whether a flight that comes near a surface may come to it.
   a separating direction. 75 operations: 17 additions, 7 subtractions, 19 multiplications, 3 negations, 3 absolute values, 13 comparisons, 3 conjunctions, 2 disjunctions, 1 complement, 7 selections. */
struct kernel_backboard_approaches_out {
    bool near;
};

static __device__ __forceinline__ kernel_backboard_approaches_out kernel_backboard_approaches(double leaving, double horizon, double x, double y, double z, double vx, double vy, double vz, double extent, double speed, double position_error, double velocity_error, double earliest_delay, double pad, double p_ball_radius, double p_board_distance, double p_board_half_width, double p_board_bottom, double p_board_top, double p_board_thickness, double p_gravity)
{
    const double _s0 = p_board_distance + x;
    const double _s1 = -((p_board_distance + p_board_thickness) + x);
    const double _s2 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s3 = y - p_board_half_width;
    const double _s4 = -(p_board_half_width + y);
    const double _s5 = larger(_s3, 0.0) - larger(_s4, 0.0);
    const double _s6 = z - p_board_top;
    const double _s7 = p_board_bottom - z;
    const double _s8 = larger(_s6, 0.0) - larger(_s7, 0.0);
    const double _s9 = (fabs(_s2) + fabs(_s5)) + fabs(_s8);
    const double _s10 = position_error + (9.313225746154785e-10 * (extent + _s9));
    const bool _s11 = ((1.0 <= leaving) || (((p_ball_radius * p_ball_radius) + (4.0 * (_s10 * _s9))) < (((_s2 * _s2) + (_s5 * _s5)) + (_s8 * _s8)))) && (earliest_delay <= pad);
    const double _s12 = 4.0 * ((velocity_error * _s9) + (_s10 * (velocity_error + (speed + (p_gravity * horizon)))));
    const double _s13 = (0.5 * horizon) * (-(p_gravity * _s8));
    const bool _s14 = (((((vx * _s2) + (vy * _s5)) + (vz * _s8)) - _s12) + smaller(_s13, 0.0)) <= 0.0;
    const bool _s15 = (!((_s11 && (position_error <= (2.9802322387695312e-08 * extent))) && (velocity_error <= (2.9802322387695312e-08 * speed)))) || _s14;
    return {_s15};
}

/* Distance, its rate, and a bound on how fast it bends down, by the squared speed.
   Table 2. 59 operations: 8 additions, 10 subtractions, 10 multiplications, 1 division, 1 square root, 5 negations, 12 comparisons, 12 selections. */
struct kernel_backboard_beside_out {
    double gap, nearing, gap_curvature;
};

static __device__ __forceinline__ kernel_backboard_beside_out kernel_backboard_beside(double p_ball_radius, double p_board_bottom, double p_board_distance, double p_board_half_width, double p_board_thickness, double p_board_top, double x, double y, double z, double vx, double vy, double vz)
{
    const double _s0 = p_board_distance + x;
    const double _s1 = -((p_board_distance + p_board_thickness) + x);
    const double _s2 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s3 = y - p_board_half_width;
    const double _s4 = -(p_board_half_width + y);
    const double _s5 = larger(_s3, 0.0) - larger(_s4, 0.0);
    const double _s6 = z - p_board_top;
    const double _s7 = p_board_bottom - z;
    const double _s8 = larger(_s6, 0.0) - larger(_s7, 0.0);
    const double _s9 = sqrt((((_s2 * _s2) + (_s5 * _s5)) + (_s8 * _s8)));
    const double _s10 = ((2.0 * (choose((_s0 < 0.0), 0.0, vx) - choose((_s1 < 0.0), 0.0, (-vx)))) * _s2) + ((2.0 * (choose((_s3 < 0.0), 0.0, vy) - choose((_s4 < 0.0), 0.0, (-vy)))) * _s5);
    const double _s11 = _s10 + ((2.0 * (choose((_s6 < 0.0), 0.0, vz) - choose((_s7 < 0.0), 0.0, (-vz)))) * _s8);
    return {_s9 - p_ball_radius, (0.5 * _s11) / _s9, 0.0};
}

/* Distance of a ball that rolls on another surface, and its first two derivatives.
   derivatives of Table 2's distance. 115 operations: 16 additions, 16 subtractions, 33 multiplications, 1 division, 1 square root, 12 negations, 12 comparisons, 24 selections. */
struct kernel_backboard_closing_out {
    double gap, nearing, rolling_gap_acceleration, normal_cosine;
};

static __device__ __forceinline__ kernel_backboard_closing_out kernel_backboard_closing(double p_ball_radius, double p_board_bottom, double p_board_distance, double p_board_half_width, double p_board_thickness, double p_board_top, double x, double y, double z, double nx, double ny, double nz, double rolled_x, double rolled_y, double rolled_z, double rolling_acceleration_x, double rolling_acceleration_y, double rolling_acceleration_z)
{
    const double _s0 = p_board_distance + x;
    const double _s1 = -((p_board_distance + p_board_thickness) + x);
    const double _s2 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s3 = y - p_board_half_width;
    const double _s4 = -(p_board_half_width + y);
    const double _s5 = larger(_s3, 0.0) - larger(_s4, 0.0);
    const double _s6 = z - p_board_top;
    const double _s7 = p_board_bottom - z;
    const double _s8 = larger(_s6, 0.0) - larger(_s7, 0.0);
    const double _s9 = sqrt((((_s2 * _s2) + (_s5 * _s5)) + (_s8 * _s8)));
    const bool _s10 = _s0 < 0.0;
    const bool _s11 = _s1 < 0.0;
    const double _s12 = choose(_s10, 0.0, rolled_x) - choose(_s11, 0.0, (-rolled_x));
    const bool _s13 = _s3 < 0.0;
    const bool _s14 = _s4 < 0.0;
    const double _s15 = choose(_s13, 0.0, rolled_y) - choose(_s14, 0.0, (-rolled_y));
    const bool _s16 = _s6 < 0.0;
    const bool _s17 = _s7 < 0.0;
    const double _s18 = choose(_s16, 0.0, rolled_z) - choose(_s17, 0.0, (-rolled_z));
    const double _s19 = (((2.0 * _s12) * _s2) + ((2.0 * _s15) * _s5)) + ((2.0 * _s18) * _s8);
    const double _s20 = 1.0 / _s9;
    const double _s21 = (0.5 * _s19) * _s20;
    const double _s22 = 2.0 * (((choose(_s10, 0.0, rolling_acceleration_x) - choose(_s11, 0.0, (-rolling_acceleration_x))) * _s2) + (_s12 * _s12));
    const double _s23 = 2.0 * (((choose(_s13, 0.0, rolling_acceleration_y) - choose(_s14, 0.0, (-rolling_acceleration_y))) * _s5) + (_s15 * _s15));
    const double _s24 = 2.0 * (((choose(_s16, 0.0, rolling_acceleration_z) - choose(_s17, 0.0, (-rolling_acceleration_z))) * _s8) + (_s18 * _s18));
    const double _s25 = 0.5 * (((-(_s21 * (_s20 * _s20))) * _s19) + (((_s22 + _s23) + _s24) * _s20));
    const double _s26 = ((2.0 * (choose(_s10, 0.0, nx) - choose(_s11, 0.0, (-nx)))) * _s2) + ((2.0 * (choose(_s13, 0.0, ny) - choose(_s14, 0.0, (-ny)))) * _s5);
    const double _s27 = _s26 + ((2.0 * (choose(_s16, 0.0, nz) - choose(_s17, 0.0, (-nz)))) * _s8);
    return {_s9 - p_ball_radius, _s21, _s25, (0.5 * _s27) * _s20};
}

/* Distance from the surface.
   Table 2. 31 operations: 6 additions, 7 subtractions, 3 multiplications, 1 square root, 2 negations, 6 comparisons, 6 selections. */
struct kernel_backboard_distance_out {
    double gap;
};

static __device__ __forceinline__ kernel_backboard_distance_out kernel_backboard_distance(double p_ball_radius, double p_board_bottom, double p_board_distance, double p_board_half_width, double p_board_thickness, double p_board_top, double x, double y, double z)
{
    const double _s0 = p_board_distance + x;
    const double _s1 = -((p_board_distance + p_board_thickness) + x);
    const double _s2 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s3 = y - p_board_half_width;
    const double _s4 = -(p_board_half_width + y);
    const double _s5 = larger(_s3, 0.0) - larger(_s4, 0.0);
    const double _s6 = z - p_board_top;
    const double _s7 = p_board_bottom - z;
    const double _s8 = larger(_s6, 0.0) - larger(_s7, 0.0);
    return {sqrt((((_s2 * _s2) + (_s5 * _s5)) + (_s8 * _s8))) - p_ball_radius};
}

/* Curvature of the surface that the centre of a rolling ball stays on.
   Table 2. 65 operations: 9 additions, 3 subtractions, 6 multiplications, 1 division, 8 negations, 2 absolute values, 18 comparisons, 6 conjunctions, 9 disjunctions, 3 selections. */
struct kernel_backboard_rolling_surface_out {
    double bent_x, bent_y, bent_z, per_reach;
};

static __device__ __forceinline__ kernel_backboard_rolling_surface_out kernel_backboard_rolling_surface(double p_ball_radius, double p_board_bottom, double p_board_distance, double p_board_half_width, double p_board_thickness, double p_board_top, double x, double y, double z, double vx, double vy, double vz)
{
    const double _s0 = 1.4210854715202004e-14 * p_ball_radius;
    const double _s1 = (_s0 + (2.842170943040401e-14 * p_board_distance)) + (1.4210854715202004e-14 * p_board_thickness);
    const double _s2 = p_board_distance + x;
    const double _s3 = -_s1;
    const double _s4 = -((p_board_distance + p_board_thickness) + x);
    const double _s5 = choose((((_s1 < _s2) || ((_s3 < _s2) && (0.0 < vx))) || ((_s1 < _s4) || ((_s3 < _s4) && (0.0 < (-vx))))), 1.0, 0.0);
    const double _s6 = _s0 + (2.842170943040401e-14 * p_board_half_width);
    const double _s7 = y - p_board_half_width;
    const double _s8 = -_s6;
    const double _s9 = -(p_board_half_width + y);
    const double _s10 = choose((((_s6 < _s7) || ((_s8 < _s7) && (0.0 < vy))) || ((_s6 < _s9) || ((_s8 < _s9) && (0.0 < (-vy))))), 1.0, 0.0);
    const double _s11 = (_s0 + (1.4210854715202004e-14 * fabs(p_board_bottom))) + (1.4210854715202004e-14 * fabs(p_board_top));
    const double _s12 = z - p_board_top;
    const double _s13 = -_s11;
    const double _s14 = p_board_bottom - z;
    const double _s15 = choose((((_s11 < _s12) || ((_s13 < _s12) && (0.0 < vz))) || ((_s11 < _s14) || ((_s13 < _s14) && (0.0 < (-vz))))), 1.0, 0.0);
    return {_s5, _s10, _s15, 1.0 / p_ball_radius};
}

/* Rate of the normal.
   derivative of Table 2's normal. 77 operations: 8 additions, 12 subtractions, 16 multiplications, 7 divisions, 1 square root, 5 negations, 14 comparisons, 14 selections. */
struct kernel_backboard_turning_out {
    double turning_x, turning_y, turning_z;
};

static __device__ __forceinline__ kernel_backboard_turning_out kernel_backboard_turning(double p_ball_radius, double p_board_bottom, double p_board_distance, double p_board_half_width, double p_board_thickness, double p_board_top, double x, double y, double z, double rolled_x, double rolled_y, double rolled_z)
{
    const double _s0 = p_board_distance + x;
    const double _s1 = -((p_board_distance + p_board_thickness) + x);
    const double _s2 = choose((_s0 < 0.0), 0.0, rolled_x) - choose((_s1 < 0.0), 0.0, (-rolled_x));
    const double _s3 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s4 = y - p_board_half_width;
    const double _s5 = -(p_board_half_width + y);
    const double _s6 = larger(_s4, 0.0) - larger(_s5, 0.0);
    const double _s7 = z - p_board_top;
    const double _s8 = p_board_bottom - z;
    const double _s9 = larger(_s7, 0.0) - larger(_s8, 0.0);
    const double _s10 = sqrt((((_s3 * _s3) + (_s6 * _s6)) + (_s9 * _s9)));
    const double _s11 = 0.5 * p_ball_radius;
    const double _s12 = larger(_s10, _s11);
    const double _s13 = choose((_s4 < 0.0), 0.0, rolled_y) - choose((_s5 < 0.0), 0.0, (-rolled_y));
    const double _s14 = choose((_s7 < 0.0), 0.0, rolled_z) - choose((_s8 < 0.0), 0.0, (-rolled_z));
    const double _s15 = (0.5 * ((((2.0 * _s2) * _s3) + ((2.0 * _s13) * _s6)) + ((2.0 * _s14) * _s9))) * (1.0 / _s10);
    const double _s16 = choose((_s10 < _s11), 0.0, _s15);
    const double _s17 = _s12 * _s12;
    return {(_s2 / _s12) - ((_s3 * _s16) / _s17), (_s13 / _s12) - ((_s6 * _s16) / _s17), (_s14 / _s12) - ((_s9 * _s16) / _s17)};
}

/* Second to fourth derivative of the distance along a flight.
   derivatives of Table 2's distance. 127 operations: 27 additions, 10 subtractions, 53 multiplications, 1 division, 1 square root, 9 negations, 12 comparisons, 14 selections. */
struct kernel_backboard_separation_out {
    double lift, gap_jerk, gap_snap;
};

static __device__ __forceinline__ kernel_backboard_separation_out kernel_backboard_separation(double p_board_bottom, double p_board_distance, double p_board_half_width, double p_board_thickness, double p_board_top, double p_gravity, double x, double y, double z, double vx, double vy, double vz)
{
    const double _s0 = p_board_distance + x;
    const double _s1 = -((p_board_distance + p_board_thickness) + x);
    const double _s2 = choose((_s0 < 0.0), 0.0, vx) - choose((_s1 < 0.0), 0.0, (-vx));
    const double _s3 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s4 = y - p_board_half_width;
    const double _s5 = -(p_board_half_width + y);
    const double _s6 = choose((_s4 < 0.0), 0.0, vy) - choose((_s5 < 0.0), 0.0, (-vy));
    const double _s7 = larger(_s4, 0.0) - larger(_s5, 0.0);
    const double _s8 = z - p_board_top;
    const bool _s9 = _s8 < 0.0;
    const double _s10 = p_board_bottom - z;
    const bool _s11 = _s10 < 0.0;
    const double _s12 = choose(_s9, 0.0, vz) - choose(_s11, 0.0, (-vz));
    const double _s13 = larger(_s8, 0.0) - larger(_s10, 0.0);
    const double _s14 = (((2.0 * _s2) * _s3) + ((2.0 * _s6) * _s7)) + ((2.0 * _s12) * _s13);
    const double _s15 = 1.0 / sqrt((((_s3 * _s3) + (_s7 * _s7)) + (_s13 * _s13)));
    const double _s16 = (0.5 * _s14) * _s15;
    const double _s17 = _s15 * _s15;
    const double _s18 = -(_s16 * _s17);
    const double _s19 = choose(_s9, 0.0, (-p_gravity)) - choose(_s11, 0.0, p_gravity);
    const double _s20 = ((2.0 * ((_s19 * _s13) + (_s12 * _s12))) + (2.0 * (_s2 * _s2))) + (2.0 * (_s6 * _s6));
    const double _s21 = 0.5 * ((_s18 * _s14) + (_s20 * _s15));
    const double _s22 = _s18 * _s20;
    const double _s23 = 2.0 * _s18;
    const double _s24 = -((_s21 * _s17) + ((_s23 * _s16) * _s15));
    const double _s25 = 2.0 * (((2.0 * _s19) * _s12) + (_s19 * _s12));
    const double _s26 = 0.5 * ((_s22 + (_s14 * _s24)) + (_s22 + (_s25 * _s15)));
    const double _s27 = _s18 * _s25;
    const double _s28 = _s20 * _s24;
    const double _s29 = _s27 + _s28;
    const double _s30 = _s29 + (_s27 + (_s15 * (2.0 * (3.0 * (_s19 * _s19)))));
    const double _s31 = ((_s26 * _s17) + ((_s23 * _s21) * _s15)) + (2.0 * ((((_s18 * _s18) * _s16) + ((_s18 * _s21) * _s15)) + ((_s16 * _s24) * _s15)));
    const double _s32 = 0.5 * (_s30 + (_s29 + ((_s14 * (-_s31)) + _s28)));
    return {_s21, _s26, _s32};
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 7 operations: 4 additions, 3 multiplications. */
struct kernel_backboard_seam0_out {
    double gap, nearing, near;
};

static __device__ __forceinline__ kernel_backboard_seam0_out kernel_backboard_seam0(double p_ball_radius, double p_board_distance, double p_board_thickness, double x, double vx)
{
    return {(p_board_distance + p_board_thickness) + x, vx, ((1.4210854715202004e-14 * p_ball_radius) + (2.842170943040401e-14 * p_board_distance)) + (1.4210854715202004e-14 * p_board_thickness)};
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 6 operations: 3 additions, 3 multiplications. */
struct kernel_backboard_seam1_out {
    double gap, nearing, near;
};

static __device__ __forceinline__ kernel_backboard_seam1_out kernel_backboard_seam1(double p_ball_radius, double p_board_distance, double p_board_thickness, double x, double vx)
{
    return {p_board_distance + x, vx, ((1.4210854715202004e-14 * p_ball_radius) + (2.842170943040401e-14 * p_board_distance)) + (1.4210854715202004e-14 * p_board_thickness)};
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 4 operations: 2 additions, 2 multiplications. */
struct kernel_backboard_seam2_out {
    double gap, nearing, near;
};

static __device__ __forceinline__ kernel_backboard_seam2_out kernel_backboard_seam2(double p_ball_radius, double p_board_half_width, double y, double vy)
{
    return {p_board_half_width + y, vy, (1.4210854715202004e-14 * p_ball_radius) + (2.842170943040401e-14 * p_board_half_width)};
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 4 operations: 1 addition, 1 subtraction, 2 multiplications. */
struct kernel_backboard_seam3_out {
    double gap, nearing, near;
};

static __device__ __forceinline__ kernel_backboard_seam3_out kernel_backboard_seam3(double p_ball_radius, double p_board_half_width, double y, double vy)
{
    return {y - p_board_half_width, vy, (1.4210854715202004e-14 * p_ball_radius) + (2.842170943040401e-14 * p_board_half_width)};
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 8 operations: 2 additions, 1 subtraction, 3 multiplications, 2 absolute values. */
struct kernel_backboard_seam4_out {
    double gap, nearing, near;
};

static __device__ __forceinline__ kernel_backboard_seam4_out kernel_backboard_seam4(double p_ball_radius, double p_board_bottom, double p_board_top, double z, double vz)
{
    return {z - p_board_bottom, vz, ((1.4210854715202004e-14 * p_ball_radius) + (1.4210854715202004e-14 * fabs(p_board_bottom))) + (1.4210854715202004e-14 * fabs(p_board_top))};
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 8 operations: 2 additions, 1 subtraction, 3 multiplications, 2 absolute values. */
struct kernel_backboard_seam5_out {
    double gap, nearing, near;
};

static __device__ __forceinline__ kernel_backboard_seam5_out kernel_backboard_seam5(double p_ball_radius, double p_board_bottom, double p_board_top, double z, double vz)
{
    return {z - p_board_top, vz, ((1.4210854715202004e-14 * p_ball_radius) + (1.4210854715202004e-14 * fabs(p_board_bottom))) + (1.4210854715202004e-14 * fabs(p_board_top))};
}

/* Bound below the distance at this height and distance from the axis, and its rate.
   Table 2. 58 operations: 6 additions, 6 subtractions, 17 multiplications, 2 divisions, 3 square roots, 4 negations, 10 comparisons, 10 selections. */
struct kernel_backboard_around_out {
    double gap, nearing;
};

static __device__ __forceinline__ kernel_backboard_around_out kernel_backboard_around(double p_ball_radius, double p_board_bottom, double p_board_distance, double p_board_half_width, double p_board_thickness, double p_board_top, double x, double y, double z, double vx, double vy, double vz)
{
    const double _s0 = z - p_board_top;
    const double _s1 = p_board_bottom - z;
    const double _s2 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s3 = -p_board_half_width;
    const double _s4 = larger(0.0, _s3);
    const double _s5 = larger(_s4, _s3);
    const double _s6 = -(p_board_distance + p_board_thickness);
    const double _s7 = larger(0.0, _s6);
    const double _s8 = larger(_s7, p_board_distance);
    const double _s9 = sqrt(((x * x) + (y * y)));
    const double _s10 = sqrt(((_s5 * _s5) + (_s8 * _s8))) - _s9;
    const double _s11 = larger(0.0, _s10);
    const double _s12 = sqrt(((_s2 * _s2) + (_s11 * _s11)));
    const double _s13 = -((0.5 * (((2.0 * x) * vx) + ((2.0 * y) * vy))) * (1.0 / _s9));
    const double _s14 = ((2.0 * (choose((_s0 < 0.0), 0.0, vz) - choose((_s1 < 0.0), 0.0, (-vz)))) * _s2) + ((2.0 * _s11) * choose((0.0 < _s10), _s13, 0.0));
    return {_s12 - p_ball_radius, (0.5 * _s14) / _s12};
}

/* First window that ends later than a time, from then on.
   Table 1. 12 operations: 4 comparisons, 2 disjunctions, 6 selections. */
struct kernel_backboard_enter_out {
    double t, end;
    bool searching;
};

static __device__ __forceinline__ kernel_backboard_enter_out kernel_backboard_enter(double t, double end, double after, double low0, double low1, double high0, double high1)
{
    const double _s0 = larger(after, low0);
    const bool _s1 = _s0 < high0;
    const double _s2 = larger(after, low1);
    const bool _s3 = _s2 < high1;
    return {choose(_s1, _s0, choose(_s3, _s2, t)), choose(_s1, high0, choose(_s3, high1, end)), (false || _s3) || _s1};
}

/* Outward unit normal n3 at a contact.
   Table 2. 36 operations: 5 additions, 7 subtractions, 4 multiplications, 3 divisions, 1 square root, 2 negations, 7 comparisons, 7 selections. */
struct kernel_bridge_normal_out {
    double nx, ny, nz;
};

static __device__ __forceinline__ kernel_bridge_normal_out kernel_bridge_normal(double x, double y, double z, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_board_distance, double p_bridge_half_width, double p_bridge_depth)
{
    const double _s0 = p_ring_radius + x;
    const double _s1 = -(p_board_distance + x);
    const double _s2 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s3 = z - p_wire_radius;
    const double _s4 = (p_wire_radius - p_bridge_depth) - z;
    const double _s5 = larger(_s3, 0.0) - larger(_s4, 0.0);
    const double _s6 = y - p_bridge_half_width;
    const double _s7 = -(p_bridge_half_width + y);
    const double _s8 = larger(_s6, 0.0) - larger(_s7, 0.0);
    const double _s9 = sqrt((((_s2 * _s2) + (_s5 * _s5)) + (_s8 * _s8)));
    const double _s10 = 0.5 * p_ball_radius;
    const double _s11 = larger(_s9, _s10);
    return {_s2 / _s11, _s8 / _s11, _s5 / _s11};
}

/* Bound on the rate at which the normal turns along the contact surface.
   Table 2. 61 operations: 11 additions, 4 subtractions, 8 multiplications, 1 division, 2 negations, 9 absolute values, 13 comparisons, 13 selections. */
struct kernel_bridge_curvature_out {
    double curvature;
};

static __device__ __forceinline__ kernel_bridge_curvature_out kernel_bridge_curvature(double t, double x, double y, double z, double vx, double vy, double vz, double dx, double dy, double dz, double dvx, double dvy, double dvz, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_board_distance, double p_bridge_half_width, double p_bridge_depth, double p_gravity)
{
    const double _s0 = 2.0 * t;
    const double _s1 = fabs(dvx);
    const double _s2 = fabs(dvy);
    const double _s3 = larger(_s1, _s2);
    const double _s4 = fabs(dvz);
    const double _s5 = fabs(dx);
    const double _s6 = fabs(dy);
    const double _s7 = larger(_s5, _s6);
    const double _s8 = fabs(dz);
    const double _s9 = 16.0 * ((t * larger(_s3, _s4)) + larger(_s7, _s8));
    const double _s10 = z - p_wire_radius;
    const double _s11 = (p_wire_radius - p_bridge_depth) - z;
    const double _s12 = (((p_gravity * (t * t)) + (_s0 * fabs(vz))) + _s9) + larger(_s10, _s11);
    const double _s13 = p_ring_radius + x;
    const double _s14 = -(p_board_distance + x);
    const double _s15 = ((_s0 * fabs(vx)) + _s9) + larger(_s13, _s14);
    const double _s16 = larger(_s12, _s15);
    const double _s17 = y - p_bridge_half_width;
    const double _s18 = -(p_bridge_half_width + y);
    const double _s19 = ((_s0 * fabs(vy)) + _s9) + larger(_s17, _s18);
    const double _s20 = larger(_s19, _s12);
    const double _s21 = larger(_s15, _s19);
    const double _s22 = smaller(_s20, _s21);
    return {choose((smaller(_s16, _s22) < 0.0), 0.0, (1.0 / p_ball_radius))};
}

/* Tangent and curvatures at a contact, and bounds on the roundings there.
   Table 2, running error analysis. 183 operations: 42 additions, 12 subtractions, 49 multiplications, 4 divisions, 1 square root, 6 negations, 20 absolute values, 23 comparisons, 2 conjunctions, 24 selections. */
struct kernel_bridge_tangents_out {
    float tangent_x, tangent_y, bend_s, bend_e, sharpest_bend, root_offset, root_level, normal_rounding;
};

static __device__ __forceinline__ kernel_bridge_tangents_out kernel_bridge_tangents(float t, float x, float y, float z, float vx, float vy, float vz, float nx, float ny, float nz, float place_n, float normal_velocity, float back, float p_ball_radius, float p_ring_radius, float p_wire_radius, float p_board_distance, float p_bridge_half_width, float p_bridge_depth, float p_gravity)
{
    const float _s0 = sqrtf(((nx * nx) + (ny * ny)));
    const bool _s1 = ((float)0.0) < _s0;
    const float _s2 = ((float)1.0) / _s0;
    const float _s3 = z - p_wire_radius;
    const float _s4 = p_wire_radius - p_bridge_depth;
    const float _s5 = _s4 - z;
    const float _s6 = fabsf((larger(_s3, ((float)0.0)) - larger(_s5, ((float)0.0))));
    const float _s7 = ((float)1.0) / p_ball_radius;
    const float _s8 = p_ring_radius + x;
    const float _s9 = -(p_board_distance + x);
    const float _s10 = fabsf((larger(_s8, ((float)0.0)) - larger(_s9, ((float)0.0))));
    const float _s11 = y - p_bridge_half_width;
    const float _s12 = -(p_bridge_half_width + y);
    const float _s13 = fabsf((larger(_s11, ((float)0.0)) - larger(_s12, ((float)0.0))));
    const float _s14 = choose(((((float)0.0) < _s10) && (((float)0.0) < _s13)), (_s7 * _s2), ((float)0.0));
    const float _s15 = fabsf(_s3);
    const float _s16 = fabsf((z - _s4));
    const float _s17 = fabsf(_s11);
    const float _s18 = fabsf((y - (-p_bridge_half_width)));
    const float _s19 = fabsf((x - (-p_ring_radius)));
    const float _s20 = fabsf((x - (-p_board_distance)));
    const float _s21 = smaller(_s19, _s20);
    const float _s22 = smaller(_s18, _s21);
    const float _s23 = smaller(_s17, _s22);
    const float _s24 = smaller(_s16, _s23);
    const float _s25 = ((float)9.5367431640625e-07) * ((((p_ring_radius + (((float)2.0) * p_wire_radius)) + p_board_distance) + (((float)2.0) * p_bridge_half_width)) + p_bridge_depth);
    const float _s26 = smaller(_s15, _s24) - _s25;
    const float _s27 = larger(_s7, _s14);
    const float _s28 = ((float)1.0) / (((float)50.0) * _s26);
    const float _s29 = ((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * (t * fabsf(normal_velocity)));
    const float _s30 = t * t;
    const float _s31 = fabsf(vx);
    const float _s32 = fabsf(vy);
    const float _s33 = (p_gravity * _s30) + (t * ((_s31 + _s32) + fabsf(vz)));
    const float _s34 = ((float)2.0) * t;
    const float _s35 = ((float)1.1102230246251565e-16) * _s10;
    const float _s36 = (((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * ((_s34 * _s31) + fabsf(x)))) + (((float)2.0) * _s35);
    const float _s37 = ((float)1.1102230246251565e-16) * _s13;
    const float _s38 = (((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * ((_s34 * _s32) + fabsf(y)))) + (((float)2.0) * _s37);
    const float _s39 = ((float)0.5) * p_gravity;
    const float _s40 = ((_s39 * _s30) + (_s34 * fabsf((vz + (_s39 * t))))) + fabsf(z);
    const float _s41 = ((((float)1.1102230246251565e-16) * p_wire_radius) + (((float)2.220446049250313e-16) * p_bridge_depth)) + (((float)1.1102230246251565e-16) * _s6);
    const float _s42 = (((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * _s40)) + (((float)2.0) * _s41);
    const float _s43 = ((_s7 * _s33) * ((_s36 + _s38) + _s42)) + (((float)1.3322676295501878e-15) * _s33);
    const float _s44 = ((float)1.125) * _s43;
    const float _s45 = ((float)1.7763568394002505e-15) * (p_ball_radius * ((normal_velocity * normal_velocity) / (((vx * vx) + (vy * vy)) + (vz * vz))));
    const float _s46 = (_s29 + _s43) + larger(_s44, _s45);
    const float _s47 = (((float)8.881784197001252e-16) * p_ball_radius) + (((fabsf(nx) * _s36) + (fabsf(ny) * _s38)) + (fabsf(nz) * _s42));
    const float _s48 = ((float)1.125) * _s47;
    const float _s49 = (_s29 + _s47) + larger(_s48, _s45);
    const float _s50 = place_n + _s49;
    const bool _s51 = ((float)0.0) < back;
    const float _s52 = place_n + _s46;
    return {choose(_s1, (-(ny * _s2)), ((float)0.0)), choose(_s1, (nx * _s2), ((float)1.0)), choose(((((float)0.0) < _s6) && _s1), _s7, ((float)0.0)), _s14, choose((((float)0.0) < _s26), larger(_s27, _s28), ((float)INFINITE)), choose(_s51, larger(_s46, _s50), _s49), choose(_s51, larger(_s52, _s49), _s49), ((float)8.881784197001252e-16) + ((((float)2.0) * _s7) * ((_s41 + _s35) + _s37))};
}

/* Error of the normal, from that of the position.
   derivative of Table 2's normal. 101 operations: 10 additions, 13 subtractions, 18 multiplications, 8 divisions, 1 square root, 5 negations, 23 comparisons, 23 selections. */
struct kernel_bridge_carry_normal_out {
    double dnx, dny, dnz, turn;
};

static __device__ __forceinline__ kernel_bridge_carry_normal_out kernel_bridge_carry_normal(double x, double y, double z, double dx, double dy, double dz, double shift, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_board_distance, double p_bridge_half_width, double p_bridge_depth)
{
    const double _s0 = p_ring_radius + x;
    const double _s1 = -(p_board_distance + x);
    const double _s2 = choose((_s0 < 0.0), 0.0, dx) - choose((_s1 < 0.0), 0.0, (-dx));
    const double _s3 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s4 = z - p_wire_radius;
    const double _s5 = (p_wire_radius - p_bridge_depth) - z;
    const double _s6 = larger(_s4, 0.0) - larger(_s5, 0.0);
    const double _s7 = y - p_bridge_half_width;
    const double _s8 = -(p_bridge_half_width + y);
    const double _s9 = larger(_s7, 0.0) - larger(_s8, 0.0);
    const double _s10 = sqrt((((_s3 * _s3) + (_s6 * _s6)) + (_s9 * _s9)));
    const double _s11 = 0.5 * p_ball_radius;
    const double _s12 = larger(_s10, _s11);
    const double _s13 = choose((_s4 < 0.0), 0.0, dz) - choose((_s5 < 0.0), 0.0, (-dz));
    const double _s14 = choose((_s7 < 0.0), 0.0, dy) - choose((_s8 < 0.0), 0.0, (-dy));
    const double _s15 = (0.5 * ((((2.0 * _s2) * _s3) + ((2.0 * _s13) * _s6)) + ((2.0 * _s14) * _s9))) * (1.0 / _s10);
    const double _s16 = choose((_s10 < _s11), 0.0, _s15);
    const double _s17 = _s12 * _s12;
    const double _s18 = 16.0 * shift;
    const double _s19 = _s18 + larger(_s4, _s5);
    const double _s20 = _s18 + larger(_s0, _s1);
    const double _s21 = larger(_s19, _s20);
    const double _s22 = _s18 + larger(_s7, _s8);
    const double _s23 = larger(_s22, _s19);
    const double _s24 = larger(_s20, _s22);
    const double _s25 = smaller(_s23, _s24);
    return {(_s2 / _s12) - ((_s3 * _s16) / _s17), (_s14 / _s12) - ((_s9 * _s16) / _s17), (_s13 / _s12) - ((_s6 * _s16) / _s17), shift * choose((smaller(_s21, _s25) < 0.0), 0.0, (1.0 / p_ball_radius))};
}

/* Constants and windows of the search along a flight, and its error budget.
   bounds of the event condition. 142 operations: 29 additions, 10 subtractions, 31 multiplications, 5 divisions, 4 square roots, 5 negations, 4 absolute values, 26 comparisons, 28 selections. */
struct kernel_bridge_prepare_out {
    double low0, high0, low1, high1, ceiling, latest, budget_exceeded;
};

static __device__ __forceinline__ kernel_bridge_prepare_out kernel_bridge_prepare(double horizon, double x, double y, double z, double vx, double vy, double vz, double extent, double speed, double position_error, double velocity_error, double earliest_delay, double pad, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_board_distance, double p_bridge_half_width, double p_bridge_depth, double p_gravity)
{
    const double _s0 = fabs(vx);
    const double _s1 = 0.5 * p_board_distance;
    const double _s2 = p_ball_radius + _s1;
    const double _s3 = 0.5 * p_bridge_depth;
    const double _s4 = p_ball_radius + _s3;
    const double _s5 = p_ball_radius + p_bridge_half_width;
    const double _s6 = 0.5 * p_ring_radius;
    const double _s7 = _s2 - _s6;
    const double _s8 = smaller(_s5, _s7);
    const double _s9 = smaller(_s4, _s8);
    const double _s10 = 6.103515625e-05 * _s9;
    const double _s11 = (_s2 + _s10) - _s6;
    const double _s12 = _s6 + _s1;
    const double _s13 = _s12 + x;
    const double _s14 = choose((vx < 0.0), (-_s13), _s13);
    const double _s15 = (-(_s11 + _s14)) / _s0;
    const double _s16 = larger(0.0, _s15);
    const double _s17 = fabs(vy);
    const double _s18 = _s5 + _s10;
    const double _s19 = choose((vy < 0.0), (-y), y);
    const double _s20 = (-(_s18 + _s19)) / _s17;
    const double _s21 = larger(_s16, _s20);
    const double _s22 = vz * vz;
    const double _s23 = _s4 + _s10;
    const double _s24 = (_s3 + z) - p_wire_radius;
    const double _s25 = 2.0 * p_gravity;
    const double _s26 = _s22 + (_s25 * (_s23 + _s24));
    const double _s27 = 1.0 / p_gravity;
    const double _s28 = sqrt(_s26);
    const bool _s29 = 0.0 <= _s26;
    const double _s30 = choose(_s29, (_s27 * (vz - _s28)), (INFINITE));
    const double _s31 = larger(_s21, _s30);
    const double _s32 = _s22 + (_s25 * (_s24 - _s23));
    const double _s33 = sqrt(larger(_s32, 0.0));
    const double _s34 = choose(_s29, (_s27 * (vz + _s28)), (-INFINITE));
    const bool _s35 = 0.0 < _s32;
    const double _s36 = choose(_s35, (_s27 * (vz - _s33)), _s34);
    const double _s37 = (_s18 - _s19) / _s17;
    const double _s38 = (_s11 - _s14) / _s0;
    const double _s39 = smaller(_s38, (INFINITE));
    const double _s40 = smaller(_s37, _s39);
    const double _s41 = smaller(_s36, _s40);
    const double _s42 = choose(_s35, (_s27 * (vz + _s33)), (INFINITE));
    const double _s43 = larger(_s21, _s42);
    const double _s44 = smaller(_s34, _s40);
    const double _s45 = larger(0.0, _s41);
    const double _s46 = larger(_s45, _s44);
    const double _s47 = smaller(_s46, horizon);
    const double _s48 = speed + (p_gravity * _s47);
    const double _s49 = 2.0 * (((1.25 * fabs((-p_gravity))) * (p_ball_radius + (0.0001220703125 * _s9))) + (3.0 * (_s48 * _s48)));
    const double _s50 = larger(_s7, _s5);
    const double _s51 = ((_s12 + extent) + fabs((_s3 - p_wire_radius))) + larger(_s50, _s4);
    const double _s52 = (sqrt(2.0) * sqrt((_s27 * (_s51 + _s9)))) + ((2.0 * speed) * _s27);
    const double _s53 = ((position_error + (velocity_error * smaller(_s52, horizon))) + (3.552713678800501e-15 * (((speed * speed) * _s27) + _s51))) + choose(((2.0 * pad) < earliest_delay), (earliest_delay * (speed + (p_gravity * horizon))), 0.0);
    return {larger(0.0, _s31), smaller(_s41, horizon), larger(0.0, _s43), smaller(_s44, horizon), _s49, _s47, _s53 - (1.52587890625e-05 * _s9)};
}

/* Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.
   running error analysis. 81 operations: 31 additions, 1 subtraction, 45 multiplications, 2 comparisons, 2 selections. */
struct kernel_bridge_margins_out {
    double margin, leaving_margin, rate_margin;
};

static __device__ __forceinline__ kernel_bridge_margins_out kernel_bridge_margins(double horizon, double extent, double speed, double position_error, double velocity_error, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_board_distance, double p_bridge_half_width, double p_bridge_depth, double p_gravity)
{
    const double _s0 = p_ball_radius + (0.5 * p_bridge_depth);
    const double _s1 = p_ball_radius + p_bridge_half_width;
    const double _s2 = (p_ball_radius + (0.5 * p_board_distance)) - (0.5 * p_ring_radius);
    const double _s3 = smaller(_s1, _s2);
    const double _s4 = p_ball_radius + (0.0001220703125 * smaller(_s0, _s3));
    const double _s5 = speed + (p_gravity * horizon);
    const double _s6 = extent + (horizon * _s5);
    const double _s7 = 2.220446049250313e-16 * _s6;
    const double _s8 = 2.0 * ((position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * _s6));
    const double _s9 = ((3.3306690738754696e-16 * p_bridge_half_width) + _s7) + _s8;
    const double _s10 = 2.001953125 * _s4;
    const double _s11 = (((1.1102230246251565e-16 * p_ring_radius) + (1.1102230246251565e-16 * p_board_distance)) + _s7) + _s8;
    const double _s12 = (((5.551115123125783e-16 * p_wire_radius) + (2.220446049250313e-16 * p_bridge_depth)) + (3.3306690738754696e-16 * _s6)) + _s8;
    const double _s13 = ((((5.55653613398821e-16 * (p_ball_radius * p_ball_radius)) + (_s10 * _s9)) + (_s10 * _s11)) + (_s10 * _s12)) + (((1.3335686721571705e-15 * horizon) * _s4) * _s5);
    const double _s14 = 4.00390625 * _s5;
    const double _s15 = ((((6.667843360785852e-15 * _s4) * _s5) + ((12.01171875 * _s4) * (velocity_error + (3.3306690738754696e-16 * _s5)))) + (_s14 * _s9)) + (_s14 * _s11);
    const double _s16 = 2.001953125 * _s5;
    const double _s17 = ((((2.667137344314341e-15 * _s4) * _s5) + ((6.005859375 * _s4) * (velocity_error + (2.220446049250313e-16 * _s5)))) + (_s16 * _s9)) + (_s16 * _s11);
    return {_s13 + (1.3335686721571705e-15 * (_s4 * _s4)), _s15 + (_s14 * _s12), _s17 + (_s16 * _s12)};
}

/* Newton's next value of a root near t, and gap and rate there.
   Newton's method. 101 operations: 18 additions, 20 subtractions, 26 multiplications, 1 division, 4 negations, 16 comparisons, 16 selections. */
struct kernel_bridge_refine_out {
    double time, gap, rate;
};

static __device__ __forceinline__ kernel_bridge_refine_out kernel_bridge_refine(double t, double leaving, double x, double y, double z, double vx, double vy, double vz, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_board_distance, double p_bridge_half_width, double p_bridge_depth, double p_gravity)
{
    const double _s0 = x + (vx * t);
    const double _s1 = p_ring_radius + _s0;
    const double _s2 = -(p_board_distance + _s0);
    const double _s3 = larger(_s1, 0.0) - larger(_s2, 0.0);
    const double _s4 = y + (vy * t);
    const double _s5 = _s4 - p_bridge_half_width;
    const double _s6 = -(p_bridge_half_width + _s4);
    const double _s7 = larger(_s5, 0.0) - larger(_s6, 0.0);
    const double _s8 = vz - ((0.5 * p_gravity) * t);
    const double _s9 = z + (t * _s8);
    const double _s10 = _s9 - p_wire_radius;
    const double _s11 = p_wire_radius - p_bridge_depth;
    const double _s12 = _s11 - _s9;
    const double _s13 = larger(_s10, 0.0) - larger(_s12, 0.0);
    const double _s14 = 2.0 * (((vx * _s3) + (vy * _s7)) + ((vz - (p_gravity * t)) * _s13));
    const double _s15 = p_ring_radius + x;
    const double _s16 = -(p_board_distance + x);
    const double _s17 = larger(_s15, 0.0) - larger(_s16, 0.0);
    const double _s18 = _s3 * _s3;
    const double _s19 = z - p_wire_radius;
    const double _s20 = _s11 - z;
    const double _s21 = larger(_s19, 0.0) - larger(_s20, 0.0);
    const double _s22 = _s13 * _s13;
    const double _s23 = y - p_bridge_half_width;
    const double _s24 = -(p_bridge_half_width + y);
    const double _s25 = larger(_s23, 0.0) - larger(_s24, 0.0);
    const double _s26 = _s7 * _s7;
    const double _s27 = (choose((0.0 < (_s17 * _s3)), (t * (vx * (_s17 + _s3))), (_s18 - (_s17 * _s17))) + choose((0.0 < (_s21 * _s13)), (t * (_s8 * (_s21 + _s13))), (_s22 - (_s21 * _s21)))) + choose((0.0 < (_s25 * _s7)), (t * (vy * (_s25 + _s7))), (_s26 - (_s25 * _s25)));
    const double _s28 = choose((0.0 < leaving), _s27, (((_s18 + _s22) + _s26) - (p_ball_radius * p_ball_radius)));
    return {t - (_s28 / _s14), _s28, _s14};
}

/* Gap, rate, second derivative, a step without a root, its end, and the clearance.
   Newton from the left under a curvature bound. 190 operations: 32 additions, 26 subtractions, 49 multiplications, 2 divisions, 1 square root, 8 negations, 5 absolute values, 32 comparisons, 35 selections. */
struct kernel_bridge_advance_out {
    double gap, rate, bend, step, next, clearance;
};

static __device__ __forceinline__ kernel_bridge_advance_out kernel_bridge_advance(double t, double end, double leaving, double margin, double rate_margin, double ceiling, double x, double y, double z, double vx, double vy, double vz, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_board_distance, double p_bridge_half_width, double p_bridge_depth, double p_gravity)
{
    const double _s0 = p_ring_radius + x;
    const double _s1 = -(p_board_distance + x);
    const double _s2 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s3 = x + (vx * t);
    const double _s4 = p_ring_radius + _s3;
    const double _s5 = -(p_board_distance + _s3);
    const double _s6 = larger(_s4, 0.0) - larger(_s5, 0.0);
    const double _s7 = _s6 * _s6;
    const double _s8 = z - p_wire_radius;
    const double _s9 = p_wire_radius - p_bridge_depth;
    const double _s10 = _s9 - z;
    const double _s11 = larger(_s8, 0.0) - larger(_s10, 0.0);
    const double _s12 = vz - ((0.5 * p_gravity) * t);
    const double _s13 = z + (t * _s12);
    const double _s14 = _s13 - p_wire_radius;
    const double _s15 = _s9 - _s13;
    const double _s16 = larger(_s14, 0.0) - larger(_s15, 0.0);
    const double _s17 = _s16 * _s16;
    const double _s18 = y - p_bridge_half_width;
    const double _s19 = -(p_bridge_half_width + y);
    const double _s20 = larger(_s18, 0.0) - larger(_s19, 0.0);
    const double _s21 = y + (vy * t);
    const double _s22 = _s21 - p_bridge_half_width;
    const double _s23 = -(p_bridge_half_width + _s21);
    const double _s24 = larger(_s22, 0.0) - larger(_s23, 0.0);
    const double _s25 = _s24 * _s24;
    const double _s26 = (choose((0.0 < (_s2 * _s6)), (t * (vx * (_s2 + _s6))), (_s7 - (_s2 * _s2))) + choose((0.0 < (_s11 * _s16)), (t * (_s12 * (_s11 + _s16))), (_s17 - (_s11 * _s11)))) + choose((0.0 < (_s20 * _s24)), (t * (vy * (_s20 + _s24))), (_s25 - (_s20 * _s20)));
    const double _s27 = choose((0.0 < leaving), _s26, (((_s7 + _s17) + _s25) - (p_ball_radius * p_ball_radius)));
    const double _s28 = vz - (p_gravity * t);
    const double _s29 = 2.0 * (((vx * _s6) + (vy * _s24)) + (_s28 * _s16));
    const double _s30 = fabs(_s16);
    const double _s31 = 2.0 * ((choose((0.0 < fabs(_s6)), (vx * vx), 0.0) + choose((0.0 < _s30), ((_s28 * _s28) - (p_gravity * _s16)), 0.0)) + choose((0.0 < fabs(_s24)), (vy * vy), 0.0));
    const double _s32 = fabs((-p_gravity));
    const double _s33 = p_ball_radius + (0.5 * p_bridge_depth);
    const double _s34 = p_ball_radius + p_bridge_half_width;
    const double _s35 = (p_ball_radius + (0.5 * p_board_distance)) - (0.5 * p_ring_radius);
    const double _s36 = smaller(_s34, _s35);
    const double _s37 = p_ball_radius + (0.0001220703125 * smaller(_s33, _s36));
    const double _s38 = _s29 - rate_margin;
    const double _s39 = _s27 - margin;
    const double _s40 = larger(_s39, 0.0);
    const double _s41 = -_s31;
    const bool _s42 = _s38 < 0.0;
    const double _s43 = 2.0 * _s40;
    const double _s44 = choose((0.0 < choose((0.0 <= _s38), _s40, 0.0)), (INFINITE), (choose(_s42, _s43, (4.0 * _s38)) / choose(_s42, (-_s38), larger(0.0, _s41))));
    const double _s45 = end - t;
    const double _s46 = smaller(_s44, _s45);
    const double _s47 = ((((0.5 * _s32) * _s46) + fabs(_s28)) * _s46) + _s30;
    const double _s48 = (9.094947017729282e-13 * ceiling) + (2.0 * (_s32 * smaller(_s37, _s47)));
    const double _s49 = ((2.0 * _s48) * _s40) + (_s38 * _s38);
    const double _s50 = sqrt(_s49);
    const double _s51 = choose((0.0 <= _s49), (choose(_s42, _s43, (_s38 + _s50)) / choose(_s42, (_s50 - _s38), larger(0.0, _s48))), (INFINITE));
    const double _s52 = smaller(_s51, _s46);
    const double _s53 = -(rate_margin + _s29);
    return {_s27, _s29, _s31, _s52, t + _s52, choose((0.0 < _s53), ((_s53 * _s53) - ((8.0 * ceiling) * (margin + _s43))), _s53)};
}

/* Whether a flight may reach the box of a surface at all.
   disjoint boxes. 63 operations: 11 additions, 12 subtractions, 14 multiplications, 3 negations, 6 absolute values, 8 comparisons, 1 disjunction, 2 complements, 6 selections. */
struct kernel_bridge_near_out {
    bool near, first_near, later_near;
};

static __device__ __forceinline__ kernel_bridge_near_out kernel_bridge_near(double middle_x, double middle_y, double middle_z, double reach_x, double reach_y, double reach_z, double later_middle_x, double later_middle_y, double later_middle_z, double later_reach_x, double later_reach_y, double later_reach_z, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_board_distance, double p_bridge_half_width, double p_bridge_depth)
{
    const double _s0 = 1.0000000009313226 * (p_ball_radius * p_ball_radius);
    const double _s1 = 0.5 * p_ring_radius;
    const double _s2 = 0.5 * p_board_distance;
    const double _s3 = -(_s1 + _s2);
    const double _s4 = 1.0000000009313226 * (_s2 - _s1);
    const double _s5 = fabs((_s3 - middle_x)) - (reach_x + _s4);
    const double _s6 = larger(_s5, 0.0);
    const double _s7 = 1.0000000009313226 * p_bridge_half_width;
    const double _s8 = fabs((-middle_y)) - (reach_y + _s7);
    const double _s9 = larger(_s8, 0.0);
    const double _s10 = 0.5 * p_bridge_depth;
    const double _s11 = p_wire_radius - _s10;
    const double _s12 = 1.0000000009313226 * _s10;
    const double _s13 = fabs((_s11 - middle_z)) - (reach_z + _s12);
    const double _s14 = larger(_s13, 0.0);
    const bool _s15 = !(_s0 < (((_s6 * _s6) + (_s9 * _s9)) + (_s14 * _s14)));
    const double _s16 = fabs((_s3 - later_middle_x)) - (later_reach_x + _s4);
    const double _s17 = larger(_s16, 0.0);
    const double _s18 = fabs((-later_middle_y)) - (later_reach_y + _s7);
    const double _s19 = larger(_s18, 0.0);
    const double _s20 = fabs((_s11 - later_middle_z)) - (later_reach_z + _s12);
    const double _s21 = larger(_s20, 0.0);
    const bool _s22 = !(_s0 < (((_s17 * _s17) + (_s19 * _s19)) + (_s21 * _s21)));
    return {_s15 || _s22, _s15, _s22};
}

/* Whether a flight that comes near a surface may come to it.
   a separating direction. 81 operations: 17 additions, 8 subtractions, 20 multiplications, 3 negations, 3 absolute values, 14 comparisons, 5 conjunctions, 3 disjunctions, 1 complement, 7 selections. */
struct kernel_bridge_approaches_out {
    bool near;
};

static __device__ __forceinline__ kernel_bridge_approaches_out kernel_bridge_approaches(double leaving, double horizon, double x, double y, double z, double vx, double vy, double vz, double extent, double speed, double position_error, double velocity_error, double earliest_delay, double pad, bool first_near, bool later_near, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_board_distance, double p_bridge_half_width, double p_bridge_depth, double p_gravity)
{
    const double _s0 = p_ring_radius + x;
    const double _s1 = -(p_board_distance + x);
    const double _s2 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s3 = z - p_wire_radius;
    const double _s4 = (p_wire_radius - p_bridge_depth) - z;
    const double _s5 = larger(_s3, 0.0) - larger(_s4, 0.0);
    const double _s6 = y - p_bridge_half_width;
    const double _s7 = -(p_bridge_half_width + y);
    const double _s8 = larger(_s6, 0.0) - larger(_s7, 0.0);
    const double _s9 = (fabs(_s2) + fabs(_s5)) + fabs(_s8);
    const double _s10 = position_error + (9.313225746154785e-10 * (extent + _s9));
    const bool _s11 = ((1.0 <= leaving) || (((p_ball_radius * p_ball_radius) + (4.0 * (_s10 * _s9))) < (((_s2 * _s2) + (_s5 * _s5)) + (_s8 * _s8)))) && (earliest_delay <= pad);
    const double _s12 = 4.0 * ((velocity_error * _s9) + (_s10 * (velocity_error + (speed + (p_gravity * horizon)))));
    const double _s13 = (((vx * _s2) + (vy * _s8)) + (vz * _s5)) - _s12;
    const double _s14 = (0.5 * horizon) * (-(p_gravity * _s5));
    const double _s15 = smaller(_s14, 0.0);
    const bool _s16 = (!((_s11 && (position_error <= (2.9802322387695312e-08 * extent))) && (velocity_error <= (2.9802322387695312e-08 * speed)))) || ((first_near && ((_s13 + (0.5 * _s15)) <= 0.0)) || (later_near && ((_s13 + _s15) <= 0.0)));
    return {_s16};
}

/* Distance, its rate, and a bound on how fast it bends down, by the squared speed.
   Table 2. 59 operations: 7 additions, 11 subtractions, 10 multiplications, 1 division, 1 square root, 5 negations, 12 comparisons, 12 selections. */
struct kernel_bridge_beside_out {
    double gap, nearing, gap_curvature;
};

static __device__ __forceinline__ kernel_bridge_beside_out kernel_bridge_beside(double p_ball_radius, double p_board_distance, double p_bridge_depth, double p_bridge_half_width, double p_ring_radius, double p_wire_radius, double x, double y, double z, double vx, double vy, double vz)
{
    const double _s0 = p_ring_radius + x;
    const double _s1 = -(p_board_distance + x);
    const double _s2 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s3 = z - p_wire_radius;
    const double _s4 = (p_wire_radius - p_bridge_depth) - z;
    const double _s5 = larger(_s3, 0.0) - larger(_s4, 0.0);
    const double _s6 = y - p_bridge_half_width;
    const double _s7 = -(p_bridge_half_width + y);
    const double _s8 = larger(_s6, 0.0) - larger(_s7, 0.0);
    const double _s9 = sqrt((((_s2 * _s2) + (_s5 * _s5)) + (_s8 * _s8)));
    const double _s10 = ((2.0 * (choose((_s0 < 0.0), 0.0, vx) - choose((_s1 < 0.0), 0.0, (-vx)))) * _s2) + ((2.0 * (choose((_s3 < 0.0), 0.0, vz) - choose((_s4 < 0.0), 0.0, (-vz)))) * _s5);
    const double _s11 = _s10 + ((2.0 * (choose((_s6 < 0.0), 0.0, vy) - choose((_s7 < 0.0), 0.0, (-vy)))) * _s8);
    return {_s9 - p_ball_radius, (0.5 * _s11) / _s9, 0.0};
}

/* Distance of a ball that rolls on another surface, and its first two derivatives.
   derivatives of Table 2's distance. 115 operations: 15 additions, 17 subtractions, 33 multiplications, 1 division, 1 square root, 12 negations, 12 comparisons, 24 selections. */
struct kernel_bridge_closing_out {
    double gap, nearing, rolling_gap_acceleration, normal_cosine;
};

static __device__ __forceinline__ kernel_bridge_closing_out kernel_bridge_closing(double p_ball_radius, double p_board_distance, double p_bridge_depth, double p_bridge_half_width, double p_ring_radius, double p_wire_radius, double x, double y, double z, double nx, double ny, double nz, double rolled_x, double rolled_y, double rolled_z, double rolling_acceleration_x, double rolling_acceleration_y, double rolling_acceleration_z)
{
    const double _s0 = p_ring_radius + x;
    const double _s1 = -(p_board_distance + x);
    const double _s2 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s3 = z - p_wire_radius;
    const double _s4 = (p_wire_radius - p_bridge_depth) - z;
    const double _s5 = larger(_s3, 0.0) - larger(_s4, 0.0);
    const double _s6 = y - p_bridge_half_width;
    const double _s7 = -(p_bridge_half_width + y);
    const double _s8 = larger(_s6, 0.0) - larger(_s7, 0.0);
    const double _s9 = sqrt((((_s2 * _s2) + (_s5 * _s5)) + (_s8 * _s8)));
    const bool _s10 = _s0 < 0.0;
    const bool _s11 = _s1 < 0.0;
    const double _s12 = choose(_s10, 0.0, rolled_x) - choose(_s11, 0.0, (-rolled_x));
    const bool _s13 = _s3 < 0.0;
    const bool _s14 = _s4 < 0.0;
    const double _s15 = choose(_s13, 0.0, rolled_z) - choose(_s14, 0.0, (-rolled_z));
    const bool _s16 = _s6 < 0.0;
    const bool _s17 = _s7 < 0.0;
    const double _s18 = choose(_s16, 0.0, rolled_y) - choose(_s17, 0.0, (-rolled_y));
    const double _s19 = (((2.0 * _s12) * _s2) + ((2.0 * _s15) * _s5)) + ((2.0 * _s18) * _s8);
    const double _s20 = 1.0 / _s9;
    const double _s21 = (0.5 * _s19) * _s20;
    const double _s22 = 2.0 * (((choose(_s10, 0.0, rolling_acceleration_x) - choose(_s11, 0.0, (-rolling_acceleration_x))) * _s2) + (_s12 * _s12));
    const double _s23 = 2.0 * (((choose(_s13, 0.0, rolling_acceleration_z) - choose(_s14, 0.0, (-rolling_acceleration_z))) * _s5) + (_s15 * _s15));
    const double _s24 = 2.0 * (((choose(_s16, 0.0, rolling_acceleration_y) - choose(_s17, 0.0, (-rolling_acceleration_y))) * _s8) + (_s18 * _s18));
    const double _s25 = 0.5 * (((-(_s21 * (_s20 * _s20))) * _s19) + (((_s22 + _s23) + _s24) * _s20));
    const double _s26 = ((2.0 * (choose(_s10, 0.0, nx) - choose(_s11, 0.0, (-nx)))) * _s2) + ((2.0 * (choose(_s13, 0.0, nz) - choose(_s14, 0.0, (-nz)))) * _s5);
    const double _s27 = _s26 + ((2.0 * (choose(_s16, 0.0, ny) - choose(_s17, 0.0, (-ny)))) * _s8);
    return {_s9 - p_ball_radius, _s21, _s25, (0.5 * _s27) * _s20};
}

/* Distance from the surface.
   Table 2. 31 operations: 5 additions, 8 subtractions, 3 multiplications, 1 square root, 2 negations, 6 comparisons, 6 selections. */
struct kernel_bridge_distance_out {
    double gap;
};

static __device__ __forceinline__ kernel_bridge_distance_out kernel_bridge_distance(double p_ball_radius, double p_board_distance, double p_bridge_depth, double p_bridge_half_width, double p_ring_radius, double p_wire_radius, double x, double y, double z)
{
    const double _s0 = p_ring_radius + x;
    const double _s1 = -(p_board_distance + x);
    const double _s2 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s3 = z - p_wire_radius;
    const double _s4 = (p_wire_radius - p_bridge_depth) - z;
    const double _s5 = larger(_s3, 0.0) - larger(_s4, 0.0);
    const double _s6 = y - p_bridge_half_width;
    const double _s7 = -(p_bridge_half_width + y);
    const double _s8 = larger(_s6, 0.0) - larger(_s7, 0.0);
    return {sqrt((((_s2 * _s2) + (_s5 * _s5)) + (_s8 * _s8))) - p_ball_radius};
}

/* Curvature of the surface that the centre of a rolling ball stays on.
   Table 2. 65 operations: 8 additions, 5 subtractions, 6 multiplications, 1 division, 8 negations, 1 absolute value, 18 comparisons, 6 conjunctions, 9 disjunctions, 3 selections. */
struct kernel_bridge_rolling_surface_out {
    double bent_x, bent_y, bent_z, per_reach;
};

static __device__ __forceinline__ kernel_bridge_rolling_surface_out kernel_bridge_rolling_surface(double p_ball_radius, double p_board_distance, double p_bridge_depth, double p_bridge_half_width, double p_ring_radius, double p_wire_radius, double x, double y, double z, double vx, double vy, double vz)
{
    const double _s0 = 1.4210854715202004e-14 * p_ball_radius;
    const double _s1 = (_s0 + (1.4210854715202004e-14 * p_ring_radius)) + (1.4210854715202004e-14 * p_board_distance);
    const double _s2 = p_ring_radius + x;
    const double _s3 = -_s1;
    const double _s4 = -(p_board_distance + x);
    const double _s5 = choose((((_s1 < _s2) || ((_s3 < _s2) && (0.0 < vx))) || ((_s1 < _s4) || ((_s3 < _s4) && (0.0 < (-vx))))), 1.0, 0.0);
    const double _s6 = _s0 + (2.842170943040401e-14 * p_bridge_half_width);
    const double _s7 = y - p_bridge_half_width;
    const double _s8 = -_s6;
    const double _s9 = -(p_bridge_half_width + y);
    const double _s10 = choose((((_s6 < _s7) || ((_s8 < _s7) && (0.0 < vy))) || ((_s6 < _s9) || ((_s8 < _s9) && (0.0 < (-vy))))), 1.0, 0.0);
    const double _s11 = (_s0 + (1.4210854715202004e-14 * p_wire_radius)) + (1.4210854715202004e-14 * fabs((p_bridge_depth - p_wire_radius)));
    const double _s12 = z - p_wire_radius;
    const double _s13 = -_s11;
    const double _s14 = (p_wire_radius - p_bridge_depth) - z;
    const double _s15 = choose((((_s11 < _s12) || ((_s13 < _s12) && (0.0 < vz))) || ((_s11 < _s14) || ((_s13 < _s14) && (0.0 < (-vz))))), 1.0, 0.0);
    return {_s5, _s10, _s15, 1.0 / p_ball_radius};
}

/* Rate of the normal.
   derivative of Table 2's normal. 77 operations: 7 additions, 13 subtractions, 16 multiplications, 7 divisions, 1 square root, 5 negations, 14 comparisons, 14 selections. */
struct kernel_bridge_turning_out {
    double turning_x, turning_y, turning_z;
};

static __device__ __forceinline__ kernel_bridge_turning_out kernel_bridge_turning(double p_ball_radius, double p_board_distance, double p_bridge_depth, double p_bridge_half_width, double p_ring_radius, double p_wire_radius, double x, double y, double z, double rolled_x, double rolled_y, double rolled_z)
{
    const double _s0 = p_ring_radius + x;
    const double _s1 = -(p_board_distance + x);
    const double _s2 = choose((_s0 < 0.0), 0.0, rolled_x) - choose((_s1 < 0.0), 0.0, (-rolled_x));
    const double _s3 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s4 = z - p_wire_radius;
    const double _s5 = (p_wire_radius - p_bridge_depth) - z;
    const double _s6 = larger(_s4, 0.0) - larger(_s5, 0.0);
    const double _s7 = y - p_bridge_half_width;
    const double _s8 = -(p_bridge_half_width + y);
    const double _s9 = larger(_s7, 0.0) - larger(_s8, 0.0);
    const double _s10 = sqrt((((_s3 * _s3) + (_s6 * _s6)) + (_s9 * _s9)));
    const double _s11 = 0.5 * p_ball_radius;
    const double _s12 = larger(_s10, _s11);
    const double _s13 = choose((_s4 < 0.0), 0.0, rolled_z) - choose((_s5 < 0.0), 0.0, (-rolled_z));
    const double _s14 = choose((_s7 < 0.0), 0.0, rolled_y) - choose((_s8 < 0.0), 0.0, (-rolled_y));
    const double _s15 = (0.5 * ((((2.0 * _s2) * _s3) + ((2.0 * _s13) * _s6)) + ((2.0 * _s14) * _s9))) * (1.0 / _s10);
    const double _s16 = choose((_s10 < _s11), 0.0, _s15);
    const double _s17 = _s12 * _s12;
    return {(_s2 / _s12) - ((_s3 * _s16) / _s17), (_s14 / _s12) - ((_s9 * _s16) / _s17), (_s13 / _s12) - ((_s6 * _s16) / _s17)};
}

/* Second to fourth derivative of the distance along a flight.
   derivatives of Table 2's distance. 127 operations: 26 additions, 11 subtractions, 53 multiplications, 1 division, 1 square root, 9 negations, 12 comparisons, 14 selections. */
struct kernel_bridge_separation_out {
    double lift, gap_jerk, gap_snap;
};

static __device__ __forceinline__ kernel_bridge_separation_out kernel_bridge_separation(double p_board_distance, double p_bridge_depth, double p_bridge_half_width, double p_gravity, double p_ring_radius, double p_wire_radius, double x, double y, double z, double vx, double vy, double vz)
{
    const double _s0 = p_ring_radius + x;
    const double _s1 = -(p_board_distance + x);
    const double _s2 = choose((_s0 < 0.0), 0.0, vx) - choose((_s1 < 0.0), 0.0, (-vx));
    const double _s3 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s4 = z - p_wire_radius;
    const bool _s5 = _s4 < 0.0;
    const double _s6 = (p_wire_radius - p_bridge_depth) - z;
    const bool _s7 = _s6 < 0.0;
    const double _s8 = choose(_s5, 0.0, vz) - choose(_s7, 0.0, (-vz));
    const double _s9 = larger(_s4, 0.0) - larger(_s6, 0.0);
    const double _s10 = y - p_bridge_half_width;
    const double _s11 = -(p_bridge_half_width + y);
    const double _s12 = choose((_s10 < 0.0), 0.0, vy) - choose((_s11 < 0.0), 0.0, (-vy));
    const double _s13 = larger(_s10, 0.0) - larger(_s11, 0.0);
    const double _s14 = (((2.0 * _s2) * _s3) + ((2.0 * _s8) * _s9)) + ((2.0 * _s12) * _s13);
    const double _s15 = 1.0 / sqrt((((_s3 * _s3) + (_s9 * _s9)) + (_s13 * _s13)));
    const double _s16 = (0.5 * _s14) * _s15;
    const double _s17 = _s15 * _s15;
    const double _s18 = -(_s16 * _s17);
    const double _s19 = choose(_s5, 0.0, (-p_gravity)) - choose(_s7, 0.0, p_gravity);
    const double _s20 = ((2.0 * ((_s19 * _s9) + (_s8 * _s8))) + (2.0 * (_s2 * _s2))) + (2.0 * (_s12 * _s12));
    const double _s21 = 0.5 * ((_s18 * _s14) + (_s20 * _s15));
    const double _s22 = _s18 * _s20;
    const double _s23 = 2.0 * _s18;
    const double _s24 = -((_s21 * _s17) + ((_s23 * _s16) * _s15));
    const double _s25 = 2.0 * (((2.0 * _s19) * _s8) + (_s19 * _s8));
    const double _s26 = 0.5 * ((_s22 + (_s14 * _s24)) + (_s22 + (_s25 * _s15)));
    const double _s27 = _s18 * _s25;
    const double _s28 = _s20 * _s24;
    const double _s29 = _s27 + _s28;
    const double _s30 = _s29 + (_s27 + (_s15 * (2.0 * (3.0 * (_s19 * _s19)))));
    const double _s31 = ((_s26 * _s17) + ((_s23 * _s21) * _s15)) + (2.0 * ((((_s18 * _s18) * _s16) + ((_s18 * _s21) * _s15)) + ((_s16 * _s24) * _s15)));
    const double _s32 = 0.5 * (_s30 + (_s29 + ((_s14 * (-_s31)) + _s28)));
    return {_s21, _s26, _s32};
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 6 operations: 3 additions, 3 multiplications. */
struct kernel_bridge_seam0_out {
    double gap, nearing, near;
};

static __device__ __forceinline__ kernel_bridge_seam0_out kernel_bridge_seam0(double p_ball_radius, double p_board_distance, double p_ring_radius, double x, double vx)
{
    return {p_board_distance + x, vx, ((1.4210854715202004e-14 * p_ball_radius) + (1.4210854715202004e-14 * p_ring_radius)) + (1.4210854715202004e-14 * p_board_distance)};
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 6 operations: 3 additions, 3 multiplications. */
struct kernel_bridge_seam1_out {
    double gap, nearing, near;
};

static __device__ __forceinline__ kernel_bridge_seam1_out kernel_bridge_seam1(double p_ball_radius, double p_board_distance, double p_ring_radius, double x, double vx)
{
    return {p_ring_radius + x, vx, ((1.4210854715202004e-14 * p_ball_radius) + (1.4210854715202004e-14 * p_ring_radius)) + (1.4210854715202004e-14 * p_board_distance)};
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 4 operations: 2 additions, 2 multiplications. */
struct kernel_bridge_seam2_out {
    double gap, nearing, near;
};

static __device__ __forceinline__ kernel_bridge_seam2_out kernel_bridge_seam2(double p_ball_radius, double p_bridge_half_width, double y, double vy)
{
    return {p_bridge_half_width + y, vy, (1.4210854715202004e-14 * p_ball_radius) + (2.842170943040401e-14 * p_bridge_half_width)};
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 4 operations: 1 addition, 1 subtraction, 2 multiplications. */
struct kernel_bridge_seam3_out {
    double gap, nearing, near;
};

static __device__ __forceinline__ kernel_bridge_seam3_out kernel_bridge_seam3(double p_ball_radius, double p_bridge_half_width, double y, double vy)
{
    return {y - p_bridge_half_width, vy, (1.4210854715202004e-14 * p_ball_radius) + (2.842170943040401e-14 * p_bridge_half_width)};
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 9 operations: 3 additions, 2 subtractions, 3 multiplications, 1 absolute value. */
struct kernel_bridge_seam4_out {
    double gap, nearing, near;
};

static __device__ __forceinline__ kernel_bridge_seam4_out kernel_bridge_seam4(double p_ball_radius, double p_bridge_depth, double p_wire_radius, double z, double vz)
{
    return {(p_bridge_depth + z) - p_wire_radius, vz, ((1.4210854715202004e-14 * p_ball_radius) + (1.4210854715202004e-14 * p_wire_radius)) + (1.4210854715202004e-14 * fabs((p_bridge_depth - p_wire_radius)))};
}

/* Distance of the ball from a seam of the surface, its rate, and half the seam's width.
   Table 2. 8 operations: 2 additions, 2 subtractions, 3 multiplications, 1 absolute value. */
struct kernel_bridge_seam5_out {
    double gap, nearing, near;
};

static __device__ __forceinline__ kernel_bridge_seam5_out kernel_bridge_seam5(double p_ball_radius, double p_bridge_depth, double p_wire_radius, double z, double vz)
{
    return {z - p_wire_radius, vz, ((1.4210854715202004e-14 * p_ball_radius) + (1.4210854715202004e-14 * p_wire_radius)) + (1.4210854715202004e-14 * fabs((p_bridge_depth - p_wire_radius)))};
}

/* Bound below the distance at this height and distance from the axis, and its rate.
   Table 2. 58 operations: 5 additions, 7 subtractions, 17 multiplications, 2 divisions, 3 square roots, 4 negations, 10 comparisons, 10 selections. */
struct kernel_bridge_around_out {
    double gap, nearing;
};

static __device__ __forceinline__ kernel_bridge_around_out kernel_bridge_around(double p_ball_radius, double p_board_distance, double p_bridge_depth, double p_bridge_half_width, double p_ring_radius, double p_wire_radius, double x, double y, double z, double vx, double vy, double vz)
{
    const double _s0 = z - p_wire_radius;
    const double _s1 = (p_wire_radius - p_bridge_depth) - z;
    const double _s2 = larger(_s0, 0.0) - larger(_s1, 0.0);
    const double _s3 = -p_board_distance;
    const double _s4 = larger(0.0, _s3);
    const double _s5 = larger(_s4, p_ring_radius);
    const double _s6 = -p_bridge_half_width;
    const double _s7 = larger(0.0, _s6);
    const double _s8 = larger(_s7, _s6);
    const double _s9 = sqrt(((x * x) + (y * y)));
    const double _s10 = sqrt(((_s5 * _s5) + (_s8 * _s8))) - _s9;
    const double _s11 = larger(0.0, _s10);
    const double _s12 = sqrt(((_s2 * _s2) + (_s11 * _s11)));
    const double _s13 = -((0.5 * (((2.0 * x) * vx) + ((2.0 * y) * vy))) * (1.0 / _s9));
    const double _s14 = ((2.0 * (choose((_s0 < 0.0), 0.0, vz) - choose((_s1 < 0.0), 0.0, (-vz)))) * _s2) + ((2.0 * _s11) * choose((0.0 < _s10), _s13, 0.0));
    return {_s12 - p_ball_radius, (0.5 * _s14) / _s12};
}

/* First window that ends later than a time, from then on.
   Table 1. 12 operations: 4 comparisons, 2 disjunctions, 6 selections. */
struct kernel_bridge_enter_out {
    double t, end;
    bool searching;
};

static __device__ __forceinline__ kernel_bridge_enter_out kernel_bridge_enter(double t, double end, double after, double low0, double low1, double high0, double high1)
{
    const double _s0 = larger(after, low0);
    const bool _s1 = _s0 < high0;
    const double _s2 = larger(after, low1);
    const bool _s3 = _s2 < high1;
    return {choose(_s1, _s0, choose(_s3, _s2, t)), choose(_s1, high0, choose(_s3, high1, end)), (false || _s3) || _s1};
}

/* Outward unit normal n3 at a contact.
   Table 2. No operations. */
struct kernel_end_normal_out {
    double nx, ny, nz;
};

static __device__ __forceinline__ kernel_end_normal_out kernel_end_normal()
{
    return {0.0, 0.0, 1.0};
}

/* Tangent and curvatures at a contact, and bounds on the roundings there.
   Table 2, running error analysis. 12 operations: 4 additions, 5 multiplications, 3 absolute values. */
struct kernel_end_tangents_out {
    float tangent_x, tangent_y, bend_s, bend_e, sharpest_bend, root_offset, root_level, normal_rounding;
};

static __device__ __forceinline__ kernel_end_tangents_out kernel_end_tangents(float t, float z, float vz, float p_gravity)
{
    const float _s0 = (((float)4.0) * t) * (fabsf(vz) + fabsf((vz + ((((float)0.5) * p_gravity) * t))));
    const float _s1 = ((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * (_s0 + fabsf(z)));
    return {(float)0.0, (float)1.0, (float)0.0, (float)0.0, (float)0.0, _s1, _s1, (float)0.0};
}

/* Time of the only arrival, the gap's first two derivatives there, and its apex.
   Eq. 3 in Table 2, solved. 29 operations: 2 additions, 2 subtractions, 7 multiplications, 2 divisions, 1 square root, 6 negations, 1 absolute value, 2 comparisons, 6 selections. */
struct kernel_end_arrival_out {
    double time, rate, bend, apex, height;
};

static __device__ __forceinline__ kernel_end_arrival_out kernel_end_arrival(double leaving, double z, double vz, double p_gravity, double p_end_depth)
{
    const bool _s0 = 0.0 < leaving;
    const double _s1 = choose(_s0, 0.0, (z - (-p_end_depth)));
    const double _s2 = (vz * vz) + ((2.0 * p_gravity) * _s1);
    const double _s3 = choose(_s0, fabs(vz), sqrt(_s2));
    const bool _s4 = vz < 0.0;
    const double _s5 = -(1.0 / p_gravity);
    return {choose(_s4, (2.0 * _s1), (vz + _s3)) / choose(_s4, (_s3 - vz), p_gravity), -_s3, -p_gravity, choose(_s4, 0.0, (-(vz * _s5))), choose(_s4, _s1, (-((0.5 * _s5) * _s2)))};
}

/* Rounding-error bound of the gap up to the horizon.
   running error analysis. 13 operations: 6 additions, 7 multiplications. */
struct kernel_end_margin_out {
    double margin;
};

static __device__ __forceinline__ kernel_end_margin_out kernel_end_margin(double horizon, double extent, double speed, double position_error, double velocity_error, double p_gravity, double p_end_depth)
{
    const double _s0 = extent + (horizon * (speed + (p_gravity * horizon)));
    return {((6.667843360785852e-16 * p_end_depth) + (2.222614453595284e-16 * _s0)) + (2.001953125 * ((position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * _s0)))};
}

/* Bounds of the ends on a plane; the first whose bounds all hold is reached.
   Table 2, success. 5 operations: 1 addition, 1 subtraction, 2 multiplications, 1 square root. */
struct kernel_end_bounds_out {
    double g0;
};

static __device__ __forceinline__ kernel_end_bounds_out kernel_end_bounds(double x, double y, double p_ring_radius)
{
    return {sqrt(((x * x) + (y * y))) - p_ring_radius};
}

/* Distance, its rate, and a bound on how fast it bends down, by the squared speed.
   Table 2. 2 operations: 1 subtraction, 1 negation. */
struct kernel_end_beside_out {
    double gap, nearing, gap_curvature;
};

static __device__ __forceinline__ kernel_end_beside_out kernel_end_beside(double p_end_depth, double z, double vz)
{
    return {z - (-p_end_depth), vz, 0.0};
}

/* Bound below the distance at this height and distance from the axis, and its rate.
   Table 2. 2 operations: 1 subtraction, 1 negation. */
struct kernel_end_around_out {
    double gap, nearing;
};

static __device__ __forceinline__ kernel_end_around_out kernel_end_around(double p_end_depth, double z, double vz)
{
    return {z - (-p_end_depth), vz};
}

/* End that a crossing reaches.
   Table 1. 4 operations: 2 comparisons, 1 conjunction, 1 selection. */
struct kernel_end_reached_out {
    double reached;
};

static __device__ __forceinline__ kernel_end_reached_out kernel_end_reached(double through, double g0)
{
    return {choose(((g0 <= 0.0) && (through == 1.0)), 0.0, 1.0)};
}

/* Whether the choice of the end lies within its error.
   Table 1. 7 operations: 1 negation, 3 comparisons, 2 conjunctions, 1 complement. */
struct kernel_end_edge_out {
    bool edge;
};

static __device__ __forceinline__ kernel_end_edge_out kernel_end_edge(double slack, double through, double g0)
{
    return {((g0 <= slack) && (!(g0 < (-slack)))) && (through == 1.0)};
}

/* The event loop is given
   _shots             how many there are; the log counts them from `_first` on
   _states            x y z vx vy vz wx wy wz of each
   _values, _strides  where each parameter's values are, and the step from one shot's to the next one's
   _leaving           the surface that each shot touches at the start and leaves, -1 for none; or null
   _results           the arrays of results, null for what is not wanted:
                      outcome, contacts, counts, first, time, state, rolls, slip_left, grip_lost, time_error, state_error, uncertain, estimated;
                      and of the event log, which has 3 * _max_contacts + 1 rows
                      for each shot, of their number, and of bounds on their errors: events,
                      event_counts, event_errors */

/* The event loop. Without BOUNDS, what it guards is never compiled, and what it would assign stays as it starts. */
template <bool BOUNDS>
static __device__ __forceinline__ void court_loop(
    long long _shots, long long _first, const double *_states, const double *const *_values,
    const long long *_strides, const signed char *_leaving, int _max_contacts, double time_limit,
    void *const *_results)
{
    const long long _shot = blockIdx.x * (long long)blockDim.x + threadIdx.x;
    if (_shot >= _shots)
        return;
    const shot_parameters _given = {_values, _strides, _shot};
    const double most_contacts = (double)_max_contacts;
    const double claims = !BOUNDS ? 0.0 : _results[15] ? 2.0 : _results[9] || _results[10] ? 1.0 : 0.0;
    const double p_ball_radius = parameter(_given, 0);
    const double p_ring_radius = parameter(_given, 1);
    const double p_wire_radius = parameter(_given, 2);
    const double p_board_distance = parameter(_given, 3);
    const double p_board_half_width = parameter(_given, 4);
    const double p_board_bottom = parameter(_given, 5);
    const double p_board_top = parameter(_given, 6);
    const double p_board_thickness = parameter(_given, 7);
    const double p_bridge_half_width = parameter(_given, 8);
    const double p_bridge_depth = parameter(_given, 9);
    const double p_gravity = parameter(_given, 10);
    const double p_end_depth = parameter(_given, 11);
    const double p_ring_restitution = parameter(_given, 12);
    const double p_ring_friction = parameter(_given, 15);
    const double p_inertia = parameter(_given, 18);
    const double p_tangential_restitution = parameter(_given, 19);
    const double p_restitution_speed = parameter(_given, 20);

    double x = 0.0, y = 0.0, z = 0.0, vx = 0.0, vy = 0.0, vz = 0.0, wx = 0.0, wy = 0.0, wz = 0.0,
        dx = 0.0, dy = 0.0, dz = 0.0, dvx = 0.0, dvy = 0.0, dvz = 0.0, dwx = 0.0, dwy = 0.0,
        dwz = 0.0, estimated = 0.0, clock = 0.0, clock_error = 0.0, last = 0.0, first = -1.0,
        contacts = 0.0, count_0 = 0.0, count_1 = 0.0, count_2 = 0.0, held = -1.0, mode = 0.0,
        circled = 0.0, assured = 0.0, rolls = 0.0, slip_left = 0.0, grip_lost = INFINITE,
        last_grip_deficit = INFINITE, last_grip_deficit_rate = 0.0, last_grip_clock = 0.0,
        through = 0.0, uncertain = 0.0, position_claim = 0.0, velocity_claim = 0.0,
        spin_claim = 0.0, time_claim = 0.0, outcome = -1.0, allowed = 0.0, valid = 0.0,
        undecided_time = INFINITE, position_error = 0.0, velocity_error = 0.0, time_error = 0.0,
        extent = 0.0, speed = 0.0, excess = 0.0, when = 0.0, which = 0.0, earliest_delay = 0.0,
        began = 0.0, leaving = 0.0, time = 0.0, rate = 0.0, bend = 0.0, apex = 0.0, height = 0.0,
        ceiling = 0.0, nearest = 0.0, margin = 0.0, clearance = 0.0, delay = 0.0, until = 0.0,
        pad = 0.0, clear = 0.0, share = 0.0, arrival = 0.0, since = 0.0, latest = 0.0,
        rho_start = 0.0, start_rate = 0.0, rho_rate = 0.0, near_x = 0.0, near_y = 0.0,
        near_z = 0.0, near_vz = 0.0, flat = 0.0, tilt = 0.0, allowing = 0.0, budget_exceeded = 0.0,
        t = 0.0, energy2 = 0.0, moment2 = 0.0, low0 = 0.0, high0 = 0.0, low1 = 0.0, high1 = 0.0,
        low2 = 0.0, high2 = 0.0, position_level = 0.0, velocity_level = 0.0, rate_slack = 0.0,
        end = 0.0, gap = 0.0, step = 0.0, next = 0.0, refined = 0.0, rate_margin = 0.0,
        middle_x = 0.0, reach_x = 0.0, later_middle_x = 0.0, later_reach_x = 0.0, middle_y = 0.0,
        reach_y = 0.0, later_middle_y = 0.0, later_reach_y = 0.0, middle_z = 0.0, reach_z = 0.0,
        later_middle_z = 0.0, later_reach_z = 0.0, nx = 0.0, ny = 0.0, nz = 0.0, bent_x = 0.0,
        bent_y = 0.0, bent_z = 0.0, lift = 0.0, gap_jerk = 0.0, gap_snap = 0.0, per_reach = 0.0,
        turn_rate = 0.0, rolled_x = 0.0, rolled_y = 0.0, rolled_z = 0.0, vx_0 = 0.0, vy_0 = 0.0,
        vz_0 = 0.0, nx_0 = 0.0, ny_0 = 0.0, nz_0 = 0.0, turn_rate_0 = 0.0, lift_0 = 0.0,
        tx_0 = 0.0, ty_0 = 0.0, tz_0 = 0.0, vx_1 = 0.0, vy_1 = 0.0, vz_1 = 0.0, nx_1 = 0.0,
        ny_1 = 0.0, nz_1 = 0.0, turn_rate_1 = 0.0, lift_1 = 0.0, tx_1 = 0.0, ty_1 = 0.0,
        tz_1 = 0.0, vx_2 = 0.0, vy_2 = 0.0, vz_2 = 0.0, nx_2 = 0.0, ny_2 = 0.0, nz_2 = 0.0,
        turn_rate_2 = 0.0, lift_2 = 0.0, tx_2 = 0.0, ty_2 = 0.0, tz_2 = 0.0, vx_3 = 0.0,
        vy_3 = 0.0, vz_3 = 0.0, nx_3 = 0.0, ny_3 = 0.0, nz_3 = 0.0, turn_rate_3 = 0.0,
        lift_3 = 0.0, tx_3 = 0.0, ty_3 = 0.0, tz_3 = 0.0, vx_4 = 0.0, vy_4 = 0.0, vz_4 = 0.0,
        nx_4 = 0.0, ny_4 = 0.0, nz_4 = 0.0, turn_rate_4 = 0.0, lift_4 = 0.0, tx_4 = 0.0,
        ty_4 = 0.0, tz_4 = 0.0, vx_5 = 0.0, vy_5 = 0.0, vz_5 = 0.0, nx_5 = 0.0, ny_5 = 0.0,
        nz_5 = 0.0, turn_rate_5 = 0.0, lift_5 = 0.0, tx_5 = 0.0, ty_5 = 0.0, tz_5 = 0.0,
        vx_6 = 0.0, vy_6 = 0.0, vz_6 = 0.0, nx_6 = 0.0, ny_6 = 0.0, nz_6 = 0.0, turn_rate_6 = 0.0,
        lift_6 = 0.0, tx_6 = 0.0, ty_6 = 0.0, tz_6 = 0.0, vx_7 = 0.0, vy_7 = 0.0, vz_7 = 0.0,
        nx_7 = 0.0, ny_7 = 0.0, nz_7 = 0.0, turn_rate_7 = 0.0, lift_7 = 0.0, vx_8 = 0.0,
        vy_8 = 0.0, vz_8 = 0.0, nx_8 = 0.0, ny_8 = 0.0, nz_8 = 0.0, turn_rate_8 = 0.0,
        stride = 0.0, missed = 0.0, strongest = 0.0, fastest = 0.0, force = 0.0, force_rate = 0.0,
        force_bend = 0.0, friction_force_rate = 0.0, rolling_friction = 0.0,
        rolling_friction_rate = 0.0, grip_deficit = 0.0, grip_deficit_rate = 0.0, nearing = 0.0,
        gap_curvature = 0.0, near = 0.0, neighbour_scale = 0.0, far_x = 0.0, far_y = 0.0,
        far_z = 0.0, far_vx = 0.0, far_vy = 0.0, far_vz = 0.0, far_wx = 0.0, far_wy = 0.0,
        far_wz = 0.0, far_nx = 0.0, far_ny = 0.0, far_nz = 0.0, far_gap = 0.0, cosine_0 = 0.0,
        sine_0 = 0.0, climb_0 = 0.0, along_0 = 0.0, cos_0 = 0.0, sin_0 = 0.0, tilted_0 = 0.0,
        near_0 = 0.0, omega_0 = 0.0, around_0 = 0.0, cosine_1 = 0.0, sine_1 = 0.0, climb_1 = 0.0,
        along_1 = 0.0, tilted_1 = 0.0, omega_1 = 0.0, around_1 = 0.0, cosine_2 = 0.0, sine_2 = 0.0,
        climb_2 = 0.0, along_2 = 0.0, tilted_2 = 0.0, omega_2 = 0.0, around_2 = 0.0,
        cosine_3 = 0.0, sine_3 = 0.0, climb_3 = 0.0, along_3 = 0.0, tilted_3 = 0.0, omega_3 = 0.0,
        around_3 = 0.0, cosine_4 = 0.0, sine_4 = 0.0, climb_4 = 0.0, along_4 = 0.0, tilted_4 = 0.0,
        omega_4 = 0.0, around_4 = 0.0, cosine_5 = 0.0, sine_5 = 0.0, climb_5 = 0.0, along_5 = 0.0,
        tilted_5 = 0.0, omega_5 = 0.0, around_5 = 0.0, cosine_6 = 0.0, sine_6 = 0.0, climb_6 = 0.0,
        along_6 = 0.0, tilted_6 = 0.0, omega_6 = 0.0, around_6 = 0.0, cosine_7 = 0.0, sine_7 = 0.0,
        climb_7 = 0.0, along_7 = 0.0, tilted_7 = 0.0, omega_7 = 0.0, around_7 = 0.0,
        cosine_8 = 0.0, sine_8 = 0.0, climb_8 = 0.0, along_8 = 0.0, tilted_8 = 0.0, omega_8 = 0.0,
        around_8 = 0.0, cosine_9 = 0.0, sine_9 = 0.0, climb_9 = 0.0, along_9 = 0.0,
        turn_rate_9 = 0.0, tilted_9 = 0.0, omega_9 = 0.0, around_9 = 0.0, cosine_10 = 0.0,
        sine_10 = 0.0, climb_10 = 0.0, along_10 = 0.0, turn_rate_10 = 0.0, tilted_10 = 0.0,
        omega_10 = 0.0, around_10 = 0.0, cosine_11 = 0.0, sine_11 = 0.0, climb_11 = 0.0,
        along_11 = 0.0, turn_rate_11 = 0.0, tilted_11 = 0.0, omega_11 = 0.0, cosine_12 = 0.0,
        sine_12 = 0.0, climb_12 = 0.0, along_12 = 0.0, turn_rate_12 = 0.0,
        section_acceleration = 0.0, azimuth_clearance = 0.0, forth = 0.0, back = 0.0, climb = 0.0,
        free_time = 0.0, reached = 0.0, body = 0.0, slack = 0.0, g0 = 0.0, curving = 0.0,
        left_nx = 0.0, left_ny = 0.0, left_nz = 0.0, from_x = 0.0, from_y = 0.0, from_z = 0.0,
        lifting = 0.0, belated = 0.0, shift = 0.0, dnx = 0.0, dny = 0.0, dnz = 0.0, turn = 0.0,
        normal_velocity = 0.0, its_0_ring_impact = 0.0, its_1_ring_impact = 0.0, slip_share = 0.0,
        slip_margin = 0.0, slip_speed = 0.0, slip_x = 0.0, slip_y = 0.0, slip_z = 0.0, slip = 0.0,
        bounce = 0.0, turning_x = 0.0, turning_y = 0.0, turning_z = 0.0, press = 0.0, weight = 0.0,
        rolling_acceleration_x = 0.0, rolling_acceleration_y = 0.0, rolling_acceleration_z = 0.0,
        second_contact_gap = 0.0, rolling_gap_acceleration = 0.0, normal_cosine = 0.0;
    float place_n = (float)0.0, place_s = (float)0.0, place_e = (float)0.0, pace_n = (float)0.0,
        pace_s = (float)0.0, pace_e = (float)0.0, turn_n = (float)0.0, turn_z = (float)0.0,
        position_bound = (float)0.0, velocity_bound = (float)0.0, spin_bound = (float)0.0,
        left_ex = (float)0.0, left_ey = (float)0.0, left_bend_s = (float)0.0,
        left_bend_e = (float)0.0, frame_nx = (float)0.0, frame_ny = (float)0.0,
        frame_nz = (float)0.0, clock_bound = (float)0.0, onset = (float)0.0, wide_end = (float)0.0,
        wide_low1 = (float)0.0, wide_high1 = (float)0.0, wide_low2 = (float)0.0,
        wide_high2 = (float)0.0, lapsed = (float)0.0, short_share = (float)0.0,
        short_t = (float)0.0, short_end = (float)0.0, short_x = (float)0.0, short_y = (float)0.0,
        short_z = (float)0.0, short_vx = (float)0.0, short_vy = (float)0.0, short_vz = (float)0.0,
        short_energy2 = (float)0.0, short_moment2 = (float)0.0, short_rho_start = (float)0.0,
        short_ceiling = (float)0.0, short_flat = (float)0.0, short_tilt = (float)0.0,
        short_jerk = (float)0.0, short_quotient_margin = (float)0.0, short_start_rate = (float)0.0,
        short_rho_rate = (float)0.0, short_rate_margin = (float)0.0, short_low1 = (float)0.0,
        short_high1 = (float)0.0, short_low2 = (float)0.0, short_high2 = (float)0.0,
        tangent_x = (float)0.0, tangent_y = (float)0.0, bend_s = (float)0.0, bend_e = (float)0.0,
        sharpest_bend = (float)0.0, root_offset = (float)0.0, root_level = (float)0.0,
        normal_rounding = (float)0.0, proved_delay = (float)0.0;
    bool permitted = false, in_range = false, close = false, limited = false, in_contact = false,
        rests = false, rolling = false, arrives = false, possible = false, open = false,
        certain = false, searching = false, representable = false, fits = false, stepping = false,
        single_precision = false, hit = false, sure = false, needs_refinement = false,
        exhausted = false, refining = false, reachable = false, first_near = false,
        later_near = false, begins = false, leaves = false, here = false, circling = false,
        loses = false, beside = false, over = false, endless = false, moves = false, ends = false,
        touches = false, edge = false, undecided = false, hopped = false, meeting = false,
        slow = false, again = false, proves_contact = false, proves_end = false, struck_0 = false,
        put_on = false, nearly = false, settles = false, lodges = false, slides = false,
        unpressed = false, ends_by_time_limit = false, reports = false;
    x = _states[9 * _shot + 0];
    y = _states[9 * _shot + 1];
    z = _states[9 * _shot + 2];
    vx = _states[9 * _shot + 3];
    vy = _states[9 * _shot + 4];
    vz = _states[9 * _shot + 5];
    wx = _states[9 * _shot + 6];
    wy = _states[9 * _shot + 7];
    wz = _states[9 * _shot + 8];
    last = _leaving ? (double)_leaving[_shot] : -1.0;

    court_event *_events = (court_event *)_results[13];
    court_event_errors *_errors = BOUNDS ? (court_event_errors *)_results[15] : 0;
    int _used = 0;
    const long long _rows = _shot * (3 * (long long)_max_contacts + 1);
    if (_events)
        _events += _rows;
    if (_errors)
        _errors += _rows;

    const kernel_allowed_out _o0 = kernel_allowed(_given);
    allowed = _o0.allowed;
    const kernel_parameters_in_range_out _o1 = kernel_parameters_in_range(_given, allowed);
    permitted = _o1.permitted;
    const kernel_state_in_range_out _o2 = kernel_state_in_range(x, y, z, vx, vy, vz, wx, wy, wz);
    in_range = _o2.in_range;
    const kernel_aside_out _o3 = kernel_aside(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_end_depth);
    close = _o3.close;
    valid = _o3.valid;
    if (BOUNDS)
        undecided_time = _o3.undecided_time;
    if (close) {
        const kernel_valid_out _o4 = kernel_valid(last, x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_end_depth);
        valid = _o4.valid;
        if (BOUNDS)
            undecided_time = _o4.undecided_time;
    }
    const kernel_admitted_out _o5 = kernel_admitted(undecided_time, valid, permitted, in_range);
    outcome = _o5.outcome;
    if (BOUNDS)
        uncertain = _o5.uncertain;
    const kernel_started_on_surface_out _o6 = kernel_started_on_surface(last);
    mode = _o6.mode;
    const kernel_passing_start_out _o7 = kernel_passing_start(last, outcome, uncertain, x, y, z, p_ring_radius, p_end_depth);
    through = _o7.through;
    if (BOUNDS)
        uncertain = _o7.uncertain;

    while (outcome < 0.0) {
        /* To the next event. */
        const kernel_error_bounds_out _o8 = kernel_error_bounds(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, position_bound, velocity_bound, spin_bound, estimated, clock_bound);
        time_error = _o8.time_error;
        if (BOUNDS) {
            position_error = _o8.position_error;
            velocity_error = _o8.velocity_error;
        }
        const kernel_scale_out _o9 = kernel_scale(x, y, z, vx, vy, vz, p_gravity);
        extent = _o9.extent;
        speed = _o9.speed;
        excess = _o9.excess;
        const kernel_opening_out _o10 = kernel_opening(excess, position_error, velocity_error);
        when = _o10.when;
        which = _o10.which;
        if (BOUNDS) {
            earliest_delay = _o10.earliest_delay;
            undecided_time = _o10.undecided_time;
        }
        const kernel_limited_out _o11 = kernel_limited(time_limit);
        limited = _o11.limited;
        const kernel_in_contact_out _o12 = kernel_in_contact(when, mode);
        in_contact = _o12.in_contact;
        when = _o12.when;
        rests = _o12.rests;
        rolling = _o12.rolling;
        began = _o12.began;
        const kernel_left_out _o13 = kernel_left(3.0, last);
        leaving = _o13.leaving;
        const kernel_end_arrival_out _o14 = kernel_end_arrival(leaving, z, vz, p_gravity, p_end_depth);
        time = _o14.time;
        rate = _o14.rate;
        bend = _o14.bend;
        apex = _o14.apex;
        if (BOUNDS)
            height = _o14.height;
        const kernel_plane_root_out _o15 = kernel_plane_root(rate, bend, apex, time);
        arrives = _o15.arrives;
        if (BOUNDS) {
            ceiling = _o15.ceiling;
            nearest = _o15.nearest;
        }
        if (BOUNDS) {
            const kernel_end_margin_out _o16 = kernel_end_margin(nearest, extent, speed, position_error, velocity_error, p_gravity, p_end_depth);
            margin = _o16.margin;
            const kernel_crossing_out _o17 = kernel_crossing(margin, 0.0, rate, ceiling);
            clearance = _o17.clearance;
            delay = _o17.delay;
        }
        const kernel_within_time_out _o18 = kernel_within_time(time, when, delay, earliest_delay, arrives);
        possible = _o18.possible;
        if (BOUNDS) {
            const kernel_apex_undecided_out _o19 = kernel_apex_undecided(margin, apex, height, undecided_time);
            undecided_time = _o19.undecided_time;
        }
        if (possible) {
            if (BOUNDS) {
                const kernel_crossing_undecided_out _o20 = kernel_crossing_undecided(clearance, time, undecided_time, arrives);
                undecided_time = _o20.undecided_time;
                const kernel_tie_undecided_out _o21 = kernel_tie_undecided(time, when, delay, earliest_delay, undecided_time, arrives);
                undecided_time = _o21.undecided_time;
                earliest_delay = _o21.earliest_delay;
            }
            const kernel_earliest_out _o22 = kernel_earliest(3.0, time, when, which, arrives);
            when = _o22.when;
            which = _o22.which;
        }
        if (BOUNDS) {
            const kernel_plane_start_out _o23 = kernel_plane_start(p_gravity, undecided_time, position_error, velocity_error);
            undecided_time = _o23.undecided_time;
        }
        const kernel_horizon_out _o24 = kernel_horizon(when, speed, p_gravity);
        until = _o24.horizon;
        if (BOUNDS)
            pad = _o24.pad;
        if (BOUNDS) {
            const kernel_overdue_out _o25 = kernel_overdue(pad, earliest_delay, undecided_time);
            undecided_time = _o25.undecided_time;
        }
        const kernel_ring_clear_out _o26 = kernel_ring_clear(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
        clear = _o26.clear;
        const kernel_opens_in_flight_out _o27 = kernel_opens_in_flight(clear, in_contact);
        open = _o27.open;
        if (open) {
            const kernel_beginning_out _o28 = kernel_beginning();
            share = _o28.share;
            arrival = _o28.arrival;
            certain = _o28.certain;
            const kernel_left_out _o29 = kernel_left(0.0, last);
            leaving = _o29.leaving;
            const kernel_ring_opened_out _o30 = kernel_ring_opened(until, x, y, z, vx, vy, vz, extent, speed, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            onset = _o30.t;
            wide_end = _o30.end;
            searching = _o30.searching;
            wide_low1 = _o30.low1;
            wide_high1 = _o30.high1;
            wide_low2 = _o30.low2;
            wide_high2 = _o30.high2;
            lapsed = _o30.latest;
            representable = _o30.representable;
            const kernel_opened_out _o31 = kernel_opened(lapsed, onset);
            since = _o31.time;
            if (BOUNDS)
                latest = _o31.latest;
            const kernel_ring_started_out _o32 = kernel_ring_started(x, y, z, vx, vy, vz, p_ring_radius);
            rho_start = _o32.rho_start;
            start_rate = _o32.start_rate;
            rho_rate = _o32.rho_rate;
            const kernel_flight_out _o33 = kernel_flight(since, x, y, z, vx, vy, vz, p_gravity);
            near_x = _o33.x;
            near_y = _o33.y;
            near_z = _o33.z;
            near_vz = _o33.vz;
            const kernel_ring_resolution_out _o34 = kernel_ring_resolution(onset, wide_end, leaving, lapsed, near_x, near_y, near_z, vx, vy, near_vz, extent, speed, start_rate, rho_rate, wide_low1, wide_high1, wide_low2, wide_high2, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            short_share = _o34.share;
            short_t = _o34.t;
            short_end = _o34.end;
            short_x = _o34.x;
            short_y = _o34.y;
            short_z = _o34.z;
            short_vx = _o34.vx;
            short_vy = _o34.vy;
            short_vz = _o34.vz;
            short_energy2 = _o34.energy2;
            short_moment2 = _o34.moment2;
            short_rho_start = _o34.rho_start;
            short_ceiling = _o34.ceiling;
            short_flat = _o34.flat;
            short_tilt = _o34.tilt;
            short_jerk = _o34.jerk;
            short_quotient_margin = _o34.quotient_margin;
            short_start_rate = _o34.start_rate;
            short_rho_rate = _o34.rho_rate;
            short_rate_margin = _o34.rate_margin;
            short_low1 = _o34.low1;
            short_high1 = _o34.high1;
            short_low2 = _o34.low2;
            short_high2 = _o34.high2;
            fits = _o34.fits;
            const kernel_coarse_out _o35 = kernel_coarse(short_rate_margin, short_flat, short_ceiling, short_share, searching, representable, fits);
            stepping = _o35.stepping;
            searching = _o35.searching;
            single_precision = _o35.single_precision;
            ceiling = _o35.ceiling;
            flat = _o35.flat;
            tilt = _o35.tilt;
            if (BOUNDS)
                allowing = _o35.allowing;
            if (BOUNDS) {
                const kernel_ring_coarse_excess_out _o36 = kernel_ring_coarse_excess(allowing, latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                excess = _o36.excess;
                const kernel_ring_budget_exceeded_out _o37 = kernel_ring_budget_exceeded(until, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                budget_exceeded = _o37.budget_exceeded;
                const kernel_out_of_budget_out _o38 = kernel_out_of_budget(pad, budget_exceeded, earliest_delay, undecided_time, excess);
                undecided_time = _o38.undecided_time;
            }
            if (stepping) {
                const kernel_ring_step_out _o39 = kernel_ring_step(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_energy2, short_moment2, short_rho_start, short_flat, short_tilt, short_quotient_margin, short_jerk, short_start_rate, short_rho_rate, short_low1, short_high1, short_low2, short_high2, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                short_t = _o39.t;
                short_end = _o39.end;
                certain = _o39.certain;
                stepping = _o39.stepping;
            }
            for (size_t _turn = 0; _turn < 24; _turn++) {
                if (!stepping)
                    break;
                const kernel_ring_step_out _o40 = kernel_ring_step(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_energy2, short_moment2, short_rho_start, short_flat, short_tilt, short_quotient_margin, short_jerk, short_start_rate, short_rho_rate, short_low1, short_high1, short_low2, short_high2, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                short_t = _o40.t;
                short_end = _o40.end;
                certain = _o40.certain;
                stepping = _o40.stepping;
            }
            const kernel_stepped_out _o41 = kernel_stepped(arrival, short_t, searching, since, single_precision, certain);
            arrival = _o41.arrival;
            t = _o41.t;
            searching = _o41.searching;
            if (searching) {
                const kernel_ring_prepare_out _o42 = kernel_ring_prepare(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                energy2 = _o42.energy2;
                moment2 = _o42.moment2;
                rho_start = _o42.rho_start;
                low0 = _o42.low0;
                high0 = _o42.high0;
                low1 = _o42.low1;
                high1 = _o42.high1;
                low2 = _o42.low2;
                high2 = _o42.high2;
                ceiling = _o42.ceiling;
                latest = _o42.latest;
                if (BOUNDS) {
                    const kernel_ring_excess_out _o43 = kernel_ring_excess(share, latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    excess = _o43.excess;
                }
                const kernel_allowance_out _o44 = kernel_allowance(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                position_level = _o44.position_level;
                velocity_level = _o44.velocity_level;
                const kernel_ring_margins_out _o45 = kernel_ring_margins(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                flat = _o45.margin;
                tilt = _o45.leaving_margin;
                rate_slack = _o45.rate_margin;
                if (BOUNDS) {
                    const kernel_budget_undecided_out _o46 = kernel_budget_undecided(t, undecided_time, excess);
                    undecided_time = _o46.undecided_time;
                }
                const kernel_ring_enter_out _o47 = kernel_ring_enter(t, 0.0, t, low0, low1, low2, high0, high1, high2);
                t = _o47.t;
                end = _o47.end;
                searching = _o47.searching;
                for (size_t _turn = 0; _turn < 201; _turn++) {
                    if (!searching)
                        break;
                    const kernel_nearby_out _o48 = kernel_nearby(t, flat, tilt, 0.0, last);
                    leaving = _o48.leaving;
                    margin = _o48.margin;
                    const kernel_ring_advance_out _o49 = kernel_ring_advance(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, energy2, moment2, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    gap = _o49.gap;
                    rate = _o49.rate;
                    bend = _o49.bend;
                    step = _o49.step;
                    next = _o49.next;
                    clearance = _o49.clearance;
                    const kernel_gap_closes_out _o50 = kernel_gap_closes(gap, rate, bend, margin, rate_slack, clearance, share);
                    hit = _o50.hit;
                    sure = _o50.sure;
                    needs_refinement = _o50.needs_refinement;
                    if (needs_refinement) {
                        const kernel_smaller_budget_out _o51 = kernel_smaller_budget(share);
                        share = _o51.share;
                        if (BOUNDS) {
                            const kernel_ring_excess_out _o52 = kernel_ring_excess(share, latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                            excess = _o52.excess;
                        }
                        const kernel_allowance_out _o53 = kernel_allowance(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                        position_level = _o53.position_level;
                        velocity_level = _o53.velocity_level;
                        const kernel_ring_margins_out _o54 = kernel_ring_margins(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                        flat = _o54.margin;
                        tilt = _o54.leaving_margin;
                        rate_slack = _o54.rate_margin;
                        if (BOUNDS) {
                            const kernel_budget_undecided_out _o55 = kernel_budget_undecided(t, undecided_time, excess);
                            undecided_time = _o55.undecided_time;
                        }
                    }
                    const kernel_advanced_out _o56 = kernel_advanced(t, end, step, next, arrival, hit, sure, needs_refinement, certain);
                    arrival = _o56.arrival;
                    certain = _o56.certain;
                    exhausted = _o56.exhausted;
                    searching = _o56.searching;
                    t = _o56.t;
                    if (exhausted) {
                        const kernel_ring_enter_out _o57 = kernel_ring_enter(t, end, end, low0, low1, low2, high0, high1, high2);
                        t = _o57.t;
                        end = _o57.end;
                        searching = _o57.searching;
                    }
                }
                if (BOUNDS) {
                    const kernel_predicate_undecided_out _o58 = kernel_predicate_undecided(t, undecided_time, searching);
                    undecided_time = _o58.undecided_time;
                }
            }
            const kernel_found_out _o59 = kernel_found(arrival);
            arrives = _o59.arrives;
            refining = _o59.refining;
            if (BOUNDS)
                rate = _o59.rate;
            const kernel_nearby_out _o60 = kernel_nearby(arrival, flat, tilt, 0.0, last);
            leaving = _o60.leaving;
            if (refining) {
                const kernel_ring_refine_out _o61 = kernel_ring_refine(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                refined = _o61.time;
                gap = _o61.gap;
                rate = _o61.rate;
                const kernel_refined_return_out _o62 = kernel_refined_return(leaving, gap, rate, ceiling, arrival, refined, certain);
                arrival = _o62.arrival;
                refining = _o62.refining;
            }
            if (refining) {
                const kernel_ring_refine_out _o63 = kernel_ring_refine(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                refined = _o63.time;
                gap = _o63.gap;
                rate = _o63.rate;
                const kernel_refined_return_out _o64 = kernel_refined_return(leaving, gap, rate, ceiling, arrival, refined, certain);
                arrival = _o64.arrival;
                refining = _o64.refining;
            }
            for (size_t _turn = 0; _turn < 8; _turn++) {
                if (!refining)
                    break;
                const kernel_ring_refine_out _o65 = kernel_ring_refine(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                refined = _o65.time;
                gap = _o65.gap;
                rate = _o65.rate;
                const kernel_refined_return_out _o66 = kernel_refined_return(leaving, gap, rate, ceiling, arrival, refined, certain);
                arrival = _o66.arrival;
                refining = _o66.refining;
            }
            if (BOUNDS) {
                const kernel_ring_margins_out _o67 = kernel_ring_margins(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                flat = _o67.margin;
                tilt = _o67.leaving_margin;
                rate_margin = _o67.rate_margin;
                const kernel_own_margin_out _o68 = kernel_own_margin(leaving, flat, tilt, arrival);
                margin = _o68.margin;
                const kernel_crossing_out _o69 = kernel_crossing(margin, rate_margin, rate, ceiling);
                clearance = _o69.clearance;
                delay = _o69.delay;
            }
            const kernel_arrival_time_out _o70 = kernel_arrival_time(arrival);
            time = _o70.time;
            if (BOUNDS) {
                const kernel_return_certainty_out _o71 = kernel_return_certainty(t, clearance, time, delay, undecided_time, arrives, certain);
                delay = _o71.delay;
                undecided_time = _o71.undecided_time;
                const kernel_tie_undecided_out _o72 = kernel_tie_undecided(time, when, delay, earliest_delay, undecided_time, arrives);
                undecided_time = _o72.undecided_time;
                earliest_delay = _o72.earliest_delay;
            }
            const kernel_earliest_out _o73 = kernel_earliest(0.0, time, when, which, arrives);
            when = _o73.when;
            which = _o73.which;
        }
        const kernel_horizon_out _o74 = kernel_horizon(when, speed, p_gravity);
        until = _o74.horizon;
        pad = _o74.pad;
        const kernel_backboard_near_out _o75 = kernel_backboard_near(until, x, vx, extent, speed, position_error, velocity_error, earliest_delay, pad, p_ball_radius, p_board_distance, p_board_thickness, p_gravity);
        reachable = _o75.near;
        if (reachable) {
            const kernel_left_out _o76 = kernel_left(1.0, last);
            leaving = _o76.leaving;
            const kernel_backboard_approaches_out _o77 = kernel_backboard_approaches(leaving, until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, earliest_delay, pad, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            reachable = _o77.near;
        }
        const kernel_reachable_in_flight_out _o78 = kernel_reachable_in_flight(reachable, in_contact);
        reachable = _o78.reachable;
        if (reachable) {
            const kernel_horizon_out _o79 = kernel_horizon(when, speed, p_gravity);
            until = _o79.horizon;
            pad = _o79.pad;
            const kernel_backboard_prepare_out _o80 = kernel_backboard_prepare(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, earliest_delay, pad, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            low0 = _o80.low0;
            high0 = _o80.high0;
            low1 = _o80.low1;
            high1 = _o80.high1;
            ceiling = _o80.ceiling;
            latest = _o80.latest;
            if (BOUNDS)
                budget_exceeded = _o80.budget_exceeded;
            const kernel_beginning_out _o81 = kernel_beginning();
            share = _o81.share;
            arrival = _o81.arrival;
            certain = _o81.certain;
            const kernel_allowance_out _o82 = kernel_allowance(share, latest, extent, speed, position_error, velocity_error, p_gravity);
            position_level = _o82.position_level;
            velocity_level = _o82.velocity_level;
            if (BOUNDS)
                excess = _o82.excess;
            const kernel_backboard_margins_out _o83 = kernel_backboard_margins(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
            flat = _o83.margin;
            tilt = _o83.leaving_margin;
            rate_slack = _o83.rate_margin;
            const kernel_backboard_enter_out _o84 = kernel_backboard_enter(0.0, 0.0, 0.0, low0, low1, high0, high1);
            t = _o84.t;
            end = _o84.end;
            searching = _o84.searching;
            if (BOUNDS) {
                const kernel_out_of_budget_in_windows_out _o85 = kernel_out_of_budget_in_windows(pad, budget_exceeded, earliest_delay, undecided_time, excess, searching);
                undecided_time = _o85.undecided_time;
            }
            if (searching) {
                const kernel_nearby_out _o86 = kernel_nearby(t, flat, tilt, 1.0, last);
                leaving = _o86.leaving;
                margin = _o86.margin;
                const kernel_backboard_advance_out _o87 = kernel_backboard_advance(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                gap = _o87.gap;
                rate = _o87.rate;
                bend = _o87.bend;
                step = _o87.step;
                next = _o87.next;
                clearance = _o87.clearance;
                const kernel_gap_closes_or_stalls_out _o88 = kernel_gap_closes_or_stalls(t, end, gap, rate, bend, margin, rate_slack, next, clearance, share);
                hit = _o88.hit;
                sure = _o88.sure;
                needs_refinement = _o88.needs_refinement;
                if (needs_refinement) {
                    const kernel_smaller_budget_out _o89 = kernel_smaller_budget(share);
                    share = _o89.share;
                    const kernel_allowance_out _o90 = kernel_allowance(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    position_level = _o90.position_level;
                    velocity_level = _o90.velocity_level;
                    if (BOUNDS)
                        excess = _o90.excess;
                    const kernel_backboard_margins_out _o91 = kernel_backboard_margins(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                    flat = _o91.margin;
                    tilt = _o91.leaving_margin;
                    rate_slack = _o91.rate_margin;
                    if (BOUNDS) {
                        const kernel_budget_undecided_out _o92 = kernel_budget_undecided(t, undecided_time, excess);
                        undecided_time = _o92.undecided_time;
                    }
                }
                const kernel_advanced_out _o93 = kernel_advanced(t, end, step, next, arrival, hit, sure, needs_refinement, certain);
                arrival = _o93.arrival;
                certain = _o93.certain;
                exhausted = _o93.exhausted;
                searching = _o93.searching;
                t = _o93.t;
                if (exhausted) {
                    const kernel_backboard_enter_out _o94 = kernel_backboard_enter(t, end, end, low0, low1, high0, high1);
                    t = _o94.t;
                    end = _o94.end;
                    searching = _o94.searching;
                }
            }
            for (size_t _turn = 0; _turn < 201; _turn++) {
                if (!searching)
                    break;
                const kernel_nearby_out _o95 = kernel_nearby(t, flat, tilt, 1.0, last);
                leaving = _o95.leaving;
                margin = _o95.margin;
                const kernel_backboard_advance_out _o96 = kernel_backboard_advance(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                gap = _o96.gap;
                rate = _o96.rate;
                bend = _o96.bend;
                step = _o96.step;
                next = _o96.next;
                clearance = _o96.clearance;
                const kernel_gap_closes_or_stalls_out _o97 = kernel_gap_closes_or_stalls(t, end, gap, rate, bend, margin, rate_slack, next, clearance, share);
                hit = _o97.hit;
                sure = _o97.sure;
                needs_refinement = _o97.needs_refinement;
                if (needs_refinement) {
                    const kernel_smaller_budget_out _o98 = kernel_smaller_budget(share);
                    share = _o98.share;
                    const kernel_allowance_out _o99 = kernel_allowance(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    position_level = _o99.position_level;
                    velocity_level = _o99.velocity_level;
                    if (BOUNDS)
                        excess = _o99.excess;
                    const kernel_backboard_margins_out _o100 = kernel_backboard_margins(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                    flat = _o100.margin;
                    tilt = _o100.leaving_margin;
                    rate_slack = _o100.rate_margin;
                    if (BOUNDS) {
                        const kernel_budget_undecided_out _o101 = kernel_budget_undecided(t, undecided_time, excess);
                        undecided_time = _o101.undecided_time;
                    }
                }
                const kernel_advanced_out _o102 = kernel_advanced(t, end, step, next, arrival, hit, sure, needs_refinement, certain);
                arrival = _o102.arrival;
                certain = _o102.certain;
                exhausted = _o102.exhausted;
                searching = _o102.searching;
                t = _o102.t;
                if (exhausted) {
                    const kernel_backboard_enter_out _o103 = kernel_backboard_enter(t, end, end, low0, low1, high0, high1);
                    t = _o103.t;
                    end = _o103.end;
                    searching = _o103.searching;
                }
            }
            if (BOUNDS) {
                const kernel_predicate_undecided_out _o104 = kernel_predicate_undecided(t, undecided_time, searching);
                undecided_time = _o104.undecided_time;
            }
            const kernel_found_out _o105 = kernel_found(arrival);
            arrives = _o105.arrives;
            refining = _o105.refining;
            if (BOUNDS)
                rate = _o105.rate;
            const kernel_nearby_out _o106 = kernel_nearby(arrival, flat, tilt, 1.0, last);
            leaving = _o106.leaving;
            if (refining) {
                const kernel_backboard_refine_out _o107 = kernel_backboard_refine(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                refined = _o107.time;
                gap = _o107.gap;
                rate = _o107.rate;
                const kernel_refined_return_out _o108 = kernel_refined_return(leaving, gap, rate, ceiling, arrival, refined, certain);
                arrival = _o108.arrival;
                refining = _o108.refining;
            }
            if (refining) {
                const kernel_backboard_refine_out _o109 = kernel_backboard_refine(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                refined = _o109.time;
                gap = _o109.gap;
                rate = _o109.rate;
                const kernel_refined_return_out _o110 = kernel_refined_return(leaving, gap, rate, ceiling, arrival, refined, certain);
                arrival = _o110.arrival;
                refining = _o110.refining;
            }
            for (size_t _turn = 0; _turn < 8; _turn++) {
                if (!refining)
                    break;
                const kernel_backboard_refine_out _o111 = kernel_backboard_refine(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                refined = _o111.time;
                gap = _o111.gap;
                rate = _o111.rate;
                const kernel_refined_return_out _o112 = kernel_refined_return(leaving, gap, rate, ceiling, arrival, refined, certain);
                arrival = _o112.arrival;
                refining = _o112.refining;
            }
            if (BOUNDS) {
                const kernel_backboard_margins_out _o113 = kernel_backboard_margins(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                flat = _o113.margin;
                tilt = _o113.leaving_margin;
                rate_margin = _o113.rate_margin;
                const kernel_own_margin_out _o114 = kernel_own_margin(leaving, flat, tilt, arrival);
                margin = _o114.margin;
                const kernel_crossing_out _o115 = kernel_crossing(margin, rate_margin, rate, ceiling);
                clearance = _o115.clearance;
                delay = _o115.delay;
            }
            const kernel_arrival_time_out _o116 = kernel_arrival_time(arrival);
            time = _o116.time;
            if (BOUNDS) {
                const kernel_return_certainty_out _o117 = kernel_return_certainty(t, clearance, time, delay, undecided_time, arrives, certain);
                delay = _o117.delay;
                undecided_time = _o117.undecided_time;
                const kernel_tie_undecided_out _o118 = kernel_tie_undecided(time, when, delay, earliest_delay, undecided_time, arrives);
                undecided_time = _o118.undecided_time;
                earliest_delay = _o118.earliest_delay;
            }
            const kernel_earliest_out _o119 = kernel_earliest(1.0, time, when, which, arrives);
            when = _o119.when;
            which = _o119.which;
        }
        const kernel_horizon_out _o120 = kernel_horizon(when, speed, p_gravity);
        until = _o120.horizon;
        pad = _o120.pad;
        const kernel_half_flight_boxes_out _o121 = kernel_half_flight_boxes(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, earliest_delay, pad, p_gravity);
        middle_x = _o121.middle_x;
        reach_x = _o121.reach_x;
        later_middle_x = _o121.later_middle_x;
        later_reach_x = _o121.later_reach_x;
        middle_y = _o121.middle_y;
        reach_y = _o121.reach_y;
        later_middle_y = _o121.later_middle_y;
        later_reach_y = _o121.later_reach_y;
        middle_z = _o121.middle_z;
        reach_z = _o121.reach_z;
        later_middle_z = _o121.later_middle_z;
        later_reach_z = _o121.later_reach_z;
        const kernel_bridge_near_out _o122 = kernel_bridge_near(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, later_middle_x, later_middle_y, later_middle_z, later_reach_x, later_reach_y, later_reach_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
        reachable = _o122.near;
        first_near = _o122.first_near;
        later_near = _o122.later_near;
        if (reachable) {
            const kernel_left_out _o123 = kernel_left(2.0, last);
            leaving = _o123.leaving;
            const kernel_bridge_approaches_out _o124 = kernel_bridge_approaches(leaving, until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, earliest_delay, pad, first_near, later_near, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            reachable = _o124.near;
        }
        const kernel_reachable_in_flight_out _o125 = kernel_reachable_in_flight(reachable, in_contact);
        reachable = _o125.reachable;
        if (reachable) {
            const kernel_horizon_out _o126 = kernel_horizon(when, speed, p_gravity);
            until = _o126.horizon;
            pad = _o126.pad;
            const kernel_bridge_prepare_out _o127 = kernel_bridge_prepare(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, earliest_delay, pad, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            low0 = _o127.low0;
            high0 = _o127.high0;
            low1 = _o127.low1;
            high1 = _o127.high1;
            ceiling = _o127.ceiling;
            latest = _o127.latest;
            if (BOUNDS)
                budget_exceeded = _o127.budget_exceeded;
            const kernel_beginning_out _o128 = kernel_beginning();
            share = _o128.share;
            arrival = _o128.arrival;
            certain = _o128.certain;
            const kernel_allowance_out _o129 = kernel_allowance(share, latest, extent, speed, position_error, velocity_error, p_gravity);
            position_level = _o129.position_level;
            velocity_level = _o129.velocity_level;
            if (BOUNDS)
                excess = _o129.excess;
            const kernel_bridge_margins_out _o130 = kernel_bridge_margins(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
            flat = _o130.margin;
            tilt = _o130.leaving_margin;
            rate_slack = _o130.rate_margin;
            const kernel_bridge_enter_out _o131 = kernel_bridge_enter(0.0, 0.0, 0.0, low0, low1, high0, high1);
            t = _o131.t;
            end = _o131.end;
            searching = _o131.searching;
            if (BOUNDS) {
                const kernel_out_of_budget_in_windows_out _o132 = kernel_out_of_budget_in_windows(pad, budget_exceeded, earliest_delay, undecided_time, excess, searching);
                undecided_time = _o132.undecided_time;
            }
            if (searching) {
                const kernel_nearby_out _o133 = kernel_nearby(t, flat, tilt, 2.0, last);
                leaving = _o133.leaving;
                margin = _o133.margin;
                const kernel_bridge_advance_out _o134 = kernel_bridge_advance(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                gap = _o134.gap;
                rate = _o134.rate;
                bend = _o134.bend;
                step = _o134.step;
                next = _o134.next;
                clearance = _o134.clearance;
                const kernel_gap_closes_or_stalls_out _o135 = kernel_gap_closes_or_stalls(t, end, gap, rate, bend, margin, rate_slack, next, clearance, share);
                hit = _o135.hit;
                sure = _o135.sure;
                needs_refinement = _o135.needs_refinement;
                if (needs_refinement) {
                    const kernel_smaller_budget_out _o136 = kernel_smaller_budget(share);
                    share = _o136.share;
                    const kernel_allowance_out _o137 = kernel_allowance(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    position_level = _o137.position_level;
                    velocity_level = _o137.velocity_level;
                    if (BOUNDS)
                        excess = _o137.excess;
                    const kernel_bridge_margins_out _o138 = kernel_bridge_margins(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                    flat = _o138.margin;
                    tilt = _o138.leaving_margin;
                    rate_slack = _o138.rate_margin;
                    if (BOUNDS) {
                        const kernel_budget_undecided_out _o139 = kernel_budget_undecided(t, undecided_time, excess);
                        undecided_time = _o139.undecided_time;
                    }
                }
                const kernel_advanced_out _o140 = kernel_advanced(t, end, step, next, arrival, hit, sure, needs_refinement, certain);
                arrival = _o140.arrival;
                certain = _o140.certain;
                exhausted = _o140.exhausted;
                searching = _o140.searching;
                t = _o140.t;
                if (exhausted) {
                    const kernel_bridge_enter_out _o141 = kernel_bridge_enter(t, end, end, low0, low1, high0, high1);
                    t = _o141.t;
                    end = _o141.end;
                    searching = _o141.searching;
                }
            }
            for (size_t _turn = 0; _turn < 201; _turn++) {
                if (!searching)
                    break;
                const kernel_nearby_out _o142 = kernel_nearby(t, flat, tilt, 2.0, last);
                leaving = _o142.leaving;
                margin = _o142.margin;
                const kernel_bridge_advance_out _o143 = kernel_bridge_advance(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                gap = _o143.gap;
                rate = _o143.rate;
                bend = _o143.bend;
                step = _o143.step;
                next = _o143.next;
                clearance = _o143.clearance;
                const kernel_gap_closes_or_stalls_out _o144 = kernel_gap_closes_or_stalls(t, end, gap, rate, bend, margin, rate_slack, next, clearance, share);
                hit = _o144.hit;
                sure = _o144.sure;
                needs_refinement = _o144.needs_refinement;
                if (needs_refinement) {
                    const kernel_smaller_budget_out _o145 = kernel_smaller_budget(share);
                    share = _o145.share;
                    const kernel_allowance_out _o146 = kernel_allowance(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                    position_level = _o146.position_level;
                    velocity_level = _o146.velocity_level;
                    if (BOUNDS)
                        excess = _o146.excess;
                    const kernel_bridge_margins_out _o147 = kernel_bridge_margins(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                    flat = _o147.margin;
                    tilt = _o147.leaving_margin;
                    rate_slack = _o147.rate_margin;
                    if (BOUNDS) {
                        const kernel_budget_undecided_out _o148 = kernel_budget_undecided(t, undecided_time, excess);
                        undecided_time = _o148.undecided_time;
                    }
                }
                const kernel_advanced_out _o149 = kernel_advanced(t, end, step, next, arrival, hit, sure, needs_refinement, certain);
                arrival = _o149.arrival;
                certain = _o149.certain;
                exhausted = _o149.exhausted;
                searching = _o149.searching;
                t = _o149.t;
                if (exhausted) {
                    const kernel_bridge_enter_out _o150 = kernel_bridge_enter(t, end, end, low0, low1, high0, high1);
                    t = _o150.t;
                    end = _o150.end;
                    searching = _o150.searching;
                }
            }
            if (BOUNDS) {
                const kernel_predicate_undecided_out _o151 = kernel_predicate_undecided(t, undecided_time, searching);
                undecided_time = _o151.undecided_time;
            }
            const kernel_found_out _o152 = kernel_found(arrival);
            arrives = _o152.arrives;
            refining = _o152.refining;
            if (BOUNDS)
                rate = _o152.rate;
            const kernel_nearby_out _o153 = kernel_nearby(arrival, flat, tilt, 2.0, last);
            leaving = _o153.leaving;
            if (refining) {
                const kernel_bridge_refine_out _o154 = kernel_bridge_refine(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                refined = _o154.time;
                gap = _o154.gap;
                rate = _o154.rate;
                const kernel_refined_return_out _o155 = kernel_refined_return(leaving, gap, rate, ceiling, arrival, refined, certain);
                arrival = _o155.arrival;
                refining = _o155.refining;
            }
            if (refining) {
                const kernel_bridge_refine_out _o156 = kernel_bridge_refine(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                refined = _o156.time;
                gap = _o156.gap;
                rate = _o156.rate;
                const kernel_refined_return_out _o157 = kernel_refined_return(leaving, gap, rate, ceiling, arrival, refined, certain);
                arrival = _o157.arrival;
                refining = _o157.refining;
            }
            for (size_t _turn = 0; _turn < 8; _turn++) {
                if (!refining)
                    break;
                const kernel_bridge_refine_out _o158 = kernel_bridge_refine(arrival, leaving, x, y, z, vx, vy, vz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                refined = _o158.time;
                gap = _o158.gap;
                rate = _o158.rate;
                const kernel_refined_return_out _o159 = kernel_refined_return(leaving, gap, rate, ceiling, arrival, refined, certain);
                arrival = _o159.arrival;
                refining = _o159.refining;
            }
            if (BOUNDS) {
                const kernel_bridge_margins_out _o160 = kernel_bridge_margins(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                flat = _o160.margin;
                tilt = _o160.leaving_margin;
                rate_margin = _o160.rate_margin;
                const kernel_own_margin_out _o161 = kernel_own_margin(leaving, flat, tilt, arrival);
                margin = _o161.margin;
                const kernel_crossing_out _o162 = kernel_crossing(margin, rate_margin, rate, ceiling);
                clearance = _o162.clearance;
                delay = _o162.delay;
            }
            const kernel_arrival_time_out _o163 = kernel_arrival_time(arrival);
            time = _o163.time;
            if (BOUNDS) {
                const kernel_return_certainty_out _o164 = kernel_return_certainty(t, clearance, time, delay, undecided_time, arrives, certain);
                delay = _o164.delay;
                undecided_time = _o164.undecided_time;
                const kernel_tie_undecided_out _o165 = kernel_tie_undecided(time, when, delay, earliest_delay, undecided_time, arrives);
                undecided_time = _o165.undecided_time;
                earliest_delay = _o165.earliest_delay;
            }
            const kernel_earliest_out _o166 = kernel_earliest(2.0, time, when, which, arrives);
            when = _o166.when;
            which = _o166.which;
        }
        if (limited) {
            const kernel_expiry_out _o167 = kernel_expiry(when, which, earliest_delay, undecided_time, time_error, clock, time_limit);
            time = _o167.time;
            arrives = _o167.arrives;
            if (BOUNDS) {
                delay = _o167.delay;
                undecided_time = _o167.undecided_time;
            }
            if (BOUNDS) {
                const kernel_tie_undecided_out _o168 = kernel_tie_undecided(time, when, delay, earliest_delay, undecided_time, arrives);
                undecided_time = _o168.undecided_time;
                earliest_delay = _o168.earliest_delay;
            }
            const kernel_earliest_out _o169 = kernel_earliest(4.0, time, when, which, arrives);
            when = _o169.when;
            which = _o169.which;
        }
        if (in_contact) {
            const kernel_resumed_out _o170 = kernel_resumed(last, position_error, velocity_error, clock, mode);
            which = _o170.which;
            began = _o170.began;
            begins = _o170.begins;
            rolling = _o170.rolling;
            leaves = _o170.leaves;
            nx = _o170.nx;
            ny = _o170.ny;
            nz = _o170.nz;
            gap = _o170.gap;
            bent_x = _o170.bent_x;
            bent_y = _o170.bent_y;
            bent_z = _o170.bent_z;
            lift = _o170.lift;
            gap_jerk = _o170.gap_jerk;
            gap_snap = _o170.gap_snap;
            per_reach = _o170.per_reach;
            if (BOUNDS) {
                earliest_delay = _o170.earliest_delay;
                undecided_time = _o170.undecided_time;
            }
            if (begins) {
                const kernel_holding_out _o171 = kernel_holding(0.0, held);
                here = _o171.here;
                if (here) {
                    const kernel_ring_normal_out _o172 = kernel_ring_normal(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                    nx = _o172.nx;
                    ny = _o172.ny;
                    nz = _o172.nz;
                }
                const kernel_holding_out _o173 = kernel_holding(1.0, held);
                here = _o173.here;
                if (here) {
                    const kernel_backboard_normal_out _o174 = kernel_backboard_normal(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = _o174.nx;
                    ny = _o174.ny;
                    nz = _o174.nz;
                }
                const kernel_holding_out _o175 = kernel_holding(2.0, held);
                here = _o175.here;
                if (here) {
                    const kernel_bridge_normal_out _o176 = kernel_bridge_normal(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = _o176.nx;
                    ny = _o176.ny;
                    nz = _o176.nz;
                }
                const kernel_roll_turn_rate_out _o177 = kernel_roll_turn_rate(p_ball_radius, nx, ny, nz, wx, wy, wz);
                turn_rate = _o177.turn_rate;
                const kernel_gripped_out _o178 = kernel_gripped(p_ball_radius, p_inertia, nx, ny, nz, vx, vy, vz, wx, wy, wz);
                rolled_x = _o178.rolled_x;
                rolled_y = _o178.rolled_y;
                rolled_z = _o178.rolled_z;
                const kernel_holding_out _o179 = kernel_holding(0.0, held);
                here = _o179.here;
                if (here) {
                    const kernel_ring_distance_out _o180 = kernel_ring_distance(p_ball_radius, p_ring_radius, p_wire_radius, x, y, z);
                    gap = _o180.gap;
                }
                const kernel_holding_out _o181 = kernel_holding(1.0, held);
                here = _o181.here;
                if (here) {
                    const kernel_backboard_distance_out _o182 = kernel_backboard_distance(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z);
                    gap = _o182.gap;
                }
                const kernel_holding_out _o183 = kernel_holding(2.0, held);
                here = _o183.here;
                if (here) {
                    const kernel_bridge_distance_out _o184 = kernel_bridge_distance(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z);
                    gap = _o184.gap;
                }
                const kernel_roll_placed_out _o185 = kernel_roll_placed(p_ball_radius, x, y, z, nx, ny, nz, rolled_x, rolled_y, rolled_z, gap, turn_rate);
                x = _o185.x;
                y = _o185.y;
                z = _o185.z;
                vx = _o185.vx;
                vy = _o185.vy;
                vz = _o185.vz;
                wx = _o185.wx;
                wy = _o185.wy;
                wz = _o185.wz;
                if (BOUNDS) {
                    const kernel_jump_errors_out _o186 = kernel_jump_errors(p_ball_radius, vx, vy, vz, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
                    dx = _o186.dx;
                    dy = _o186.dy;
                    dz = _o186.dz;
                    dvx = _o186.dvx;
                    dvy = _o186.dvy;
                    dvz = _o186.dvz;
                    dwx = _o186.dwx;
                    dwy = _o186.dwy;
                    dwz = _o186.dwz;
                    const kernel_forget_grip_deficit_out _o187 = kernel_forget_grip_deficit();
                    last_grip_deficit = _o187.last_grip_deficit;
                }
                const kernel_beginning_contact_out _o188 = kernel_beginning_contact();
                which = _o188.which;
                circled = _o188.circled;
            }
            const kernel_circles_out _o189 = kernel_circles(0.0, held, rolling);
            circling = _o189.circling;
            rolling = _o189.rolling;
            for (size_t _turn = 0; _turn < 16; _turn++) {
                if (!rolling)
                    break;
                if (BOUNDS) {
                    const kernel_error_bounds_out _o190 = kernel_error_bounds(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, position_bound, velocity_bound, spin_bound, estimated, clock_bound);
                    position_error = _o190.position_error;
                    velocity_error = _o190.velocity_error;
                }
                const kernel_holding_out _o191 = kernel_holding(1.0, held);
                here = _o191.here;
                if (here) {
                    const kernel_backboard_normal_out _o192 = kernel_backboard_normal(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = _o192.nx;
                    ny = _o192.ny;
                    nz = _o192.nz;
                    const kernel_backboard_rolling_surface_out _o193 = kernel_backboard_rolling_surface(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z, vx, vy, vz);
                    bent_x = _o193.bent_x;
                    bent_y = _o193.bent_y;
                    bent_z = _o193.bent_z;
                    per_reach = _o193.per_reach;
                }
                const kernel_holding_out _o194 = kernel_holding(2.0, held);
                here = _o194.here;
                if (here) {
                    const kernel_bridge_normal_out _o195 = kernel_bridge_normal(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = _o195.nx;
                    ny = _o195.ny;
                    nz = _o195.nz;
                    const kernel_bridge_rolling_surface_out _o196 = kernel_bridge_rolling_surface(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z, vx, vy, vz);
                    bent_x = _o196.bent_x;
                    bent_y = _o196.bent_y;
                    bent_z = _o196.bent_z;
                    per_reach = _o196.per_reach;
                }
                const kernel_roll_start_out _o197 = kernel_roll_start(p_ball_radius, nx, ny, nz, vx, vy, vz, wx, wy, wz);
                vx_0 = _o197.vx_0;
                vy_0 = _o197.vy_0;
                vz_0 = _o197.vz_0;
                nx_0 = _o197.nx_0;
                ny_0 = _o197.ny_0;
                nz_0 = _o197.nz_0;
                turn_rate_0 = _o197.turn_rate_0;
                const kernel_roll_0_out _o198 = kernel_roll_0(p_gravity, p_inertia, nx_0, ny_0, nz_0, vx_0, vy_0, vz_0, bent_x, bent_y, bent_z, per_reach, turn_rate_0);
                lift_0 = _o198.lift_0;
                tx_0 = _o198.tx_0;
                ty_0 = _o198.ty_0;
                tz_0 = _o198.tz_0;
                vx_1 = _o198.vx_1;
                vy_1 = _o198.vy_1;
                vz_1 = _o198.vz_1;
                nx_1 = _o198.nx_1;
                ny_1 = _o198.ny_1;
                nz_1 = _o198.nz_1;
                turn_rate_1 = _o198.turn_rate_1;
                const kernel_roll_1_out _o199 = kernel_roll_1(p_gravity, p_inertia, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, lift_0, tx_0, ty_0, tz_0);
                lift_1 = _o199.lift_1;
                tx_1 = _o199.tx_1;
                ty_1 = _o199.ty_1;
                tz_1 = _o199.tz_1;
                vx_2 = _o199.vx_2;
                vy_2 = _o199.vy_2;
                vz_2 = _o199.vz_2;
                nx_2 = _o199.nx_2;
                ny_2 = _o199.ny_2;
                nz_2 = _o199.nz_2;
                turn_rate_2 = _o199.turn_rate_2;
                const kernel_roll_2_out _o200 = kernel_roll_2(p_gravity, p_inertia, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, lift_0, lift_1, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1);
                lift_2 = _o200.lift_2;
                tx_2 = _o200.tx_2;
                ty_2 = _o200.ty_2;
                tz_2 = _o200.tz_2;
                vx_3 = _o200.vx_3;
                vy_3 = _o200.vy_3;
                vz_3 = _o200.vz_3;
                nx_3 = _o200.nx_3;
                ny_3 = _o200.ny_3;
                nz_3 = _o200.nz_3;
                turn_rate_3 = _o200.turn_rate_3;
                const kernel_roll_3_out _o201 = kernel_roll_3(p_gravity, p_inertia, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, lift_0, lift_1, lift_2, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2);
                lift_3 = _o201.lift_3;
                tx_3 = _o201.tx_3;
                ty_3 = _o201.ty_3;
                tz_3 = _o201.tz_3;
                vx_4 = _o201.vx_4;
                vy_4 = _o201.vy_4;
                vz_4 = _o201.vz_4;
                nx_4 = _o201.nx_4;
                ny_4 = _o201.ny_4;
                nz_4 = _o201.nz_4;
                turn_rate_4 = _o201.turn_rate_4;
                const kernel_roll_4_out _o202 = kernel_roll_4(p_gravity, p_inertia, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, lift_0, lift_1, lift_2, lift_3, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3);
                lift_4 = _o202.lift_4;
                tx_4 = _o202.tx_4;
                ty_4 = _o202.ty_4;
                tz_4 = _o202.tz_4;
                vx_5 = _o202.vx_5;
                vy_5 = _o202.vy_5;
                vz_5 = _o202.vz_5;
                nx_5 = _o202.nx_5;
                ny_5 = _o202.ny_5;
                nz_5 = _o202.nz_5;
                turn_rate_5 = _o202.turn_rate_5;
                const kernel_roll_5_out _o203 = kernel_roll_5(p_gravity, p_inertia, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, lift_0, lift_1, lift_2, lift_3, lift_4, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4);
                lift_5 = _o203.lift_5;
                tx_5 = _o203.tx_5;
                ty_5 = _o203.ty_5;
                tz_5 = _o203.tz_5;
                vx_6 = _o203.vx_6;
                vy_6 = _o203.vy_6;
                vz_6 = _o203.vz_6;
                nx_6 = _o203.nx_6;
                ny_6 = _o203.ny_6;
                nz_6 = _o203.nz_6;
                turn_rate_6 = _o203.turn_rate_6;
                const kernel_roll_6_out _o204 = kernel_roll_6(p_gravity, p_inertia, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5);
                lift_6 = _o204.lift_6;
                tx_6 = _o204.tx_6;
                ty_6 = _o204.ty_6;
                tz_6 = _o204.tz_6;
                vx_7 = _o204.vx_7;
                vy_7 = _o204.vy_7;
                vz_7 = _o204.vz_7;
                nx_7 = _o204.nx_7;
                ny_7 = _o204.ny_7;
                nz_7 = _o204.nz_7;
                turn_rate_7 = _o204.turn_rate_7;
                const kernel_roll_7_out _o205 = kernel_roll_7(p_gravity, p_inertia, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6);
                lift_7 = _o205.lift_7;
                vx_8 = _o205.vx_8;
                vy_8 = _o205.vy_8;
                vz_8 = _o205.vz_8;
                nx_8 = _o205.nx_8;
                ny_8 = _o205.ny_8;
                nz_8 = _o205.nz_8;
                turn_rate_8 = _o205.turn_rate_8;
                const kernel_roll_step_out _o206 = kernel_roll_step(p_gravity, p_inertia, nx_8, ny_8, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, nz_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, lift_7);
                stride = _o206.stride;
                strongest = _o206.strongest;
                fastest = _o206.fastest;
                force = _o206.force;
                force_rate = _o206.force_rate;
                force_bend = _o206.force_bend;
                friction_force_rate = _o206.friction_force_rate;
                if (BOUNDS)
                    missed = _o206.missed;
                if (BOUNDS) {
                    const kernel_ring_friction_out _o207 = kernel_ring_friction(p_gravity, p_inertia, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, turn_rate_0, turn_rate_1, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1);
                    rolling_friction = _o207.rolling_friction;
                    rolling_friction_rate = _o207.rolling_friction_rate;
                    grip_deficit = _o207.grip_deficit;
                    grip_deficit_rate = _o207.grip_deficit_rate;
                    for (size_t _row = 0; _row < 2; _row++) {
                        const double own_1 = parameter(_given, table_0[_row][0]);
                        const double own_index = table_1[_row][0];
                        const kernel_holding_out _o208 = kernel_holding(own_index, held);
                        here = _o208.here;
                        if (here) {
                            const kernel_ring_impact_grip_deficit_out _o209 = kernel_ring_impact_grip_deficit(own_1, rolling_friction, rolling_friction_rate, force, force_rate);
                            grip_deficit = _o209.grip_deficit;
                            grip_deficit_rate = _o209.grip_deficit_rate;
                        }
                    }
                    const kernel_exceeds_grip_out _o210 = kernel_exceeds_grip(grip_deficit, grip_lost);
                    loses = _o210.loses;
                    if (loses) {
                        const kernel_grip_lost_time_out _o211 = kernel_grip_lost_time(clock, grip_deficit, grip_deficit_rate, last_grip_deficit, last_grip_deficit_rate, last_grip_clock);
                        grip_lost = _o211.grip_lost;
                    }
                    const kernel_remember_grip_deficit_out _o212 = kernel_remember_grip_deficit(clock, grip_deficit, grip_deficit_rate);
                    last_grip_deficit = _o212.last_grip_deficit;
                    last_grip_deficit_rate = _o212.last_grip_deficit_rate;
                    last_grip_clock = _o212.last_grip_clock;
                }
                const kernel_leaving_force_out _o213 = kernel_leaving_force(p_ball_radius, p_gravity, vx, vx_1, vy, vy_1, vz, vz_1, which, undecided_time, position_error, velocity_error, per_reach, force, force_rate, force_bend, friction_force_rate, stride, fastest);
                stride = _o213.stride;
                which = _o213.which;
                rests = _o213.rests;
                if (BOUNDS)
                    undecided_time = _o213.undecided_time;
                const kernel_beside_out _o214 = kernel_beside(0.0, held);
                beside = _o214.beside;
                if (beside) {
                    const kernel_ring_beside_out _o215 = kernel_ring_beside(p_ball_radius, p_ring_radius, p_wire_radius, x, y, z, vx, vy, vz);
                    gap = _o215.gap;
                    nearing = _o215.nearing;
                    gap_curvature = _o215.gap_curvature;
                    const kernel_beside_body_out _o216 = kernel_beside_body(p_ball_radius, x, y, z, gap, 0.0, which, earliest_delay, undecided_time, position_error, nearing, gap_curvature, stride, strongest, fastest);
                    stride = _o216.stride;
                    which = _o216.which;
                    if (BOUNDS) {
                        undecided_time = _o216.undecided_time;
                        earliest_delay = _o216.earliest_delay;
                    }
                }
                const kernel_beside_out _o217 = kernel_beside(1.0, held);
                beside = _o217.beside;
                if (beside) {
                    const kernel_backboard_beside_out _o218 = kernel_backboard_beside(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z, vx, vy, vz);
                    gap = _o218.gap;
                    nearing = _o218.nearing;
                    gap_curvature = _o218.gap_curvature;
                    const kernel_beside_body_out _o219 = kernel_beside_body(p_ball_radius, x, y, z, gap, 1.0, which, earliest_delay, undecided_time, position_error, nearing, gap_curvature, stride, strongest, fastest);
                    stride = _o219.stride;
                    which = _o219.which;
                    if (BOUNDS) {
                        undecided_time = _o219.undecided_time;
                        earliest_delay = _o219.earliest_delay;
                    }
                }
                const kernel_beside_out _o220 = kernel_beside(2.0, held);
                beside = _o220.beside;
                if (beside) {
                    const kernel_bridge_beside_out _o221 = kernel_bridge_beside(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z, vx, vy, vz);
                    gap = _o221.gap;
                    nearing = _o221.nearing;
                    gap_curvature = _o221.gap_curvature;
                    const kernel_beside_body_out _o222 = kernel_beside_body(p_ball_radius, x, y, z, gap, 2.0, which, earliest_delay, undecided_time, position_error, nearing, gap_curvature, stride, strongest, fastest);
                    stride = _o222.stride;
                    which = _o222.which;
                    if (BOUNDS) {
                        undecided_time = _o222.undecided_time;
                        earliest_delay = _o222.earliest_delay;
                    }
                }
                const kernel_end_beside_out _o223 = kernel_end_beside(p_end_depth, z, vz);
                gap = _o223.gap;
                nearing = _o223.nearing;
                gap_curvature = _o223.gap_curvature;
                const kernel_beside_end_plane_out _o224 = kernel_beside_end_plane(p_ball_radius, x, y, z, gap, 3.0, which, earliest_delay, undecided_time, position_error, nearing, gap_curvature, stride, strongest, fastest);
                stride = _o224.stride;
                which = _o224.which;
                if (BOUNDS) {
                    undecided_time = _o224.undecided_time;
                    earliest_delay = _o224.earliest_delay;
                }
                const kernel_holding_out _o225 = kernel_holding(1.0, held);
                here = _o225.here;
                if (here) {
                    const kernel_backboard_seam0_out _o226 = kernel_backboard_seam0(p_ball_radius, p_board_distance, p_board_thickness, x, vx);
                    gap = _o226.gap;
                    nearing = _o226.nearing;
                    near = _o226.near;
                    const kernel_beside_seam_out _o227 = kernel_beside_seam(gap, near, nearing, stride, strongest, fastest);
                    stride = _o227.stride;
                    const kernel_backboard_seam1_out _o228 = kernel_backboard_seam1(p_ball_radius, p_board_distance, p_board_thickness, x, vx);
                    gap = _o228.gap;
                    nearing = _o228.nearing;
                    near = _o228.near;
                    const kernel_beside_seam_out _o229 = kernel_beside_seam(gap, near, nearing, stride, strongest, fastest);
                    stride = _o229.stride;
                    const kernel_backboard_seam2_out _o230 = kernel_backboard_seam2(p_ball_radius, p_board_half_width, y, vy);
                    gap = _o230.gap;
                    nearing = _o230.nearing;
                    near = _o230.near;
                    const kernel_beside_seam_out _o231 = kernel_beside_seam(gap, near, nearing, stride, strongest, fastest);
                    stride = _o231.stride;
                    const kernel_backboard_seam3_out _o232 = kernel_backboard_seam3(p_ball_radius, p_board_half_width, y, vy);
                    gap = _o232.gap;
                    nearing = _o232.nearing;
                    near = _o232.near;
                    const kernel_beside_seam_out _o233 = kernel_beside_seam(gap, near, nearing, stride, strongest, fastest);
                    stride = _o233.stride;
                    const kernel_backboard_seam4_out _o234 = kernel_backboard_seam4(p_ball_radius, p_board_bottom, p_board_top, z, vz);
                    gap = _o234.gap;
                    nearing = _o234.nearing;
                    near = _o234.near;
                    const kernel_beside_seam_out _o235 = kernel_beside_seam(gap, near, nearing, stride, strongest, fastest);
                    stride = _o235.stride;
                    const kernel_backboard_seam5_out _o236 = kernel_backboard_seam5(p_ball_radius, p_board_bottom, p_board_top, z, vz);
                    gap = _o236.gap;
                    nearing = _o236.nearing;
                    near = _o236.near;
                    const kernel_beside_seam_out _o237 = kernel_beside_seam(gap, near, nearing, stride, strongest, fastest);
                    stride = _o237.stride;
                }
                const kernel_holding_out _o238 = kernel_holding(2.0, held);
                here = _o238.here;
                if (here) {
                    const kernel_bridge_seam0_out _o239 = kernel_bridge_seam0(p_ball_radius, p_board_distance, p_ring_radius, x, vx);
                    gap = _o239.gap;
                    nearing = _o239.nearing;
                    near = _o239.near;
                    const kernel_beside_seam_out _o240 = kernel_beside_seam(gap, near, nearing, stride, strongest, fastest);
                    stride = _o240.stride;
                    const kernel_bridge_seam1_out _o241 = kernel_bridge_seam1(p_ball_radius, p_board_distance, p_ring_radius, x, vx);
                    gap = _o241.gap;
                    nearing = _o241.nearing;
                    near = _o241.near;
                    const kernel_beside_seam_out _o242 = kernel_beside_seam(gap, near, nearing, stride, strongest, fastest);
                    stride = _o242.stride;
                    const kernel_bridge_seam2_out _o243 = kernel_bridge_seam2(p_ball_radius, p_bridge_half_width, y, vy);
                    gap = _o243.gap;
                    nearing = _o243.nearing;
                    near = _o243.near;
                    const kernel_beside_seam_out _o244 = kernel_beside_seam(gap, near, nearing, stride, strongest, fastest);
                    stride = _o244.stride;
                    const kernel_bridge_seam3_out _o245 = kernel_bridge_seam3(p_ball_radius, p_bridge_half_width, y, vy);
                    gap = _o245.gap;
                    nearing = _o245.nearing;
                    near = _o245.near;
                    const kernel_beside_seam_out _o246 = kernel_beside_seam(gap, near, nearing, stride, strongest, fastest);
                    stride = _o246.stride;
                    const kernel_bridge_seam4_out _o247 = kernel_bridge_seam4(p_ball_radius, p_bridge_depth, p_wire_radius, z, vz);
                    gap = _o247.gap;
                    nearing = _o247.nearing;
                    near = _o247.near;
                    const kernel_beside_seam_out _o248 = kernel_beside_seam(gap, near, nearing, stride, strongest, fastest);
                    stride = _o248.stride;
                    const kernel_bridge_seam5_out _o249 = kernel_bridge_seam5(p_ball_radius, p_bridge_depth, p_wire_radius, z, vz);
                    gap = _o249.gap;
                    nearing = _o249.nearing;
                    near = _o249.near;
                    const kernel_beside_seam_out _o250 = kernel_beside_seam(gap, near, nearing, stride, strongest, fastest);
                    stride = _o250.stride;
                }
                const kernel_beside_time_out _o251 = kernel_beside_time(which, clock, time_limit, stride);
                stride = _o251.stride;
                which = _o251.which;
                if (BOUNDS) {
                    const kernel_neighbour_scale_out _o252 = kernel_neighbour_scale(p_ball_radius, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
                    neighbour_scale = _o252.neighbour_scale;
                    const kernel_neighbour_out _o253 = kernel_neighbour(x, y, z, vx, vy, vz, wx, wy, wz, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, neighbour_scale);
                    far_x = _o253.far_x;
                    far_y = _o253.far_y;
                    far_z = _o253.far_z;
                    far_vx = _o253.far_vx;
                    far_vy = _o253.far_vy;
                    far_vz = _o253.far_vz;
                    far_wx = _o253.far_wx;
                    far_wy = _o253.far_wy;
                    far_wz = _o253.far_wz;
                    far_nx = _o253.far_nx;
                    far_ny = _o253.far_ny;
                    far_nz = _o253.far_nz;
                    far_gap = _o253.far_gap;
                }
                const kernel_passing_from_out _o254 = kernel_passing_from(z);
                over = _o254.over;
                const kernel_roll_moved_out _o255 = kernel_roll_moved(x, y, z, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8);
                x = _o255.x;
                vx = _o255.vx;
                y = _o255.y;
                vy = _o255.vy;
                z = _o255.z;
                vz = _o255.vz;
                turn_rate = _o255.turn_rate;
                const kernel_holding_out _o256 = kernel_holding(1.0, held);
                here = _o256.here;
                if (here) {
                    const kernel_backboard_normal_out _o257 = kernel_backboard_normal(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = _o257.nx;
                    ny = _o257.ny;
                    nz = _o257.nz;
                    const kernel_backboard_distance_out _o258 = kernel_backboard_distance(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z);
                    gap = _o258.gap;
                }
                const kernel_holding_out _o259 = kernel_holding(2.0, held);
                here = _o259.here;
                if (here) {
                    const kernel_bridge_normal_out _o260 = kernel_bridge_normal(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = _o260.nx;
                    ny = _o260.ny;
                    nz = _o260.nz;
                    const kernel_bridge_distance_out _o261 = kernel_bridge_distance(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z);
                    gap = _o261.gap;
                }
                const kernel_roll_placed_out _o262 = kernel_roll_placed(p_ball_radius, x, y, z, nx, ny, nz, vx, vy, vz, gap, turn_rate);
                x = _o262.x;
                y = _o262.y;
                z = _o262.z;
                vx = _o262.vx;
                vy = _o262.vy;
                vz = _o262.vz;
                wx = _o262.wx;
                wy = _o262.wy;
                wz = _o262.wz;
                const kernel_passing_in_contact_out _o263 = kernel_passing_in_contact(p_ring_radius, x, y, z, through, over);
                through = _o263.through;
                if (BOUNDS) {
                    const kernel_holding_out _o264 = kernel_holding(1.0, held);
                    here = _o264.here;
                    if (here) {
                        const kernel_backboard_normal_out _o265 = kernel_backboard_normal(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                        far_nx = _o265.nx;
                        far_ny = _o265.ny;
                        far_nz = _o265.nz;
                    }
                    const kernel_holding_out _o266 = kernel_holding(2.0, held);
                    here = _o266.here;
                    if (here) {
                        const kernel_bridge_normal_out _o267 = kernel_bridge_normal(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                        far_nx = _o267.nx;
                        far_ny = _o267.ny;
                        far_nz = _o267.nz;
                    }
                    const kernel_roll_turn_rate_out _o268 = kernel_roll_turn_rate(p_ball_radius, far_nx, far_ny, far_nz, far_wx, far_wy, far_wz);
                    turn_rate = _o268.turn_rate;
                    const kernel_holding_out _o269 = kernel_holding(1.0, held);
                    here = _o269.here;
                    if (here) {
                        const kernel_backboard_normal_out _o270 = kernel_backboard_normal(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                        far_nx = _o270.nx;
                        far_ny = _o270.ny;
                        far_nz = _o270.nz;
                        const kernel_backboard_distance_out _o271 = kernel_backboard_distance(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, far_x, far_y, far_z);
                        far_gap = _o271.gap;
                    }
                    const kernel_holding_out _o272 = kernel_holding(2.0, held);
                    here = _o272.here;
                    if (here) {
                        const kernel_bridge_normal_out _o273 = kernel_bridge_normal(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                        far_nx = _o273.nx;
                        far_ny = _o273.ny;
                        far_nz = _o273.nz;
                        const kernel_bridge_distance_out _o274 = kernel_bridge_distance(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, far_x, far_y, far_z);
                        far_gap = _o274.gap;
                    }
                    const kernel_roll_placed_out _o275 = kernel_roll_placed(p_ball_radius, far_x, far_y, far_z, far_nx, far_ny, far_nz, far_vx, far_vy, far_vz, far_gap, turn_rate);
                    far_x = _o275.x;
                    far_y = _o275.y;
                    far_z = _o275.z;
                    far_vx = _o275.vx;
                    far_vy = _o275.vy;
                    far_vz = _o275.vz;
                    far_wx = _o275.wx;
                    far_wy = _o275.wy;
                    far_wz = _o275.wz;
                    const kernel_roll_start_out _o276 = kernel_roll_start(p_ball_radius, far_nx, far_ny, far_nz, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz);
                    vx_0 = _o276.vx_0;
                    vy_0 = _o276.vy_0;
                    vz_0 = _o276.vz_0;
                    nx_0 = _o276.nx_0;
                    ny_0 = _o276.ny_0;
                    nz_0 = _o276.nz_0;
                    turn_rate_0 = _o276.turn_rate_0;
                    const kernel_roll_0_out _o277 = kernel_roll_0(p_gravity, p_inertia, nx_0, ny_0, nz_0, vx_0, vy_0, vz_0, bent_x, bent_y, bent_z, per_reach, turn_rate_0);
                    lift_0 = _o277.lift_0;
                    tx_0 = _o277.tx_0;
                    ty_0 = _o277.ty_0;
                    tz_0 = _o277.tz_0;
                    vx_1 = _o277.vx_1;
                    vy_1 = _o277.vy_1;
                    vz_1 = _o277.vz_1;
                    nx_1 = _o277.nx_1;
                    ny_1 = _o277.ny_1;
                    nz_1 = _o277.nz_1;
                    turn_rate_1 = _o277.turn_rate_1;
                    const kernel_roll_1_out _o278 = kernel_roll_1(p_gravity, p_inertia, nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, lift_0, tx_0, ty_0, tz_0);
                    lift_1 = _o278.lift_1;
                    tx_1 = _o278.tx_1;
                    ty_1 = _o278.ty_1;
                    tz_1 = _o278.tz_1;
                    vx_2 = _o278.vx_2;
                    vy_2 = _o278.vy_2;
                    vz_2 = _o278.vz_2;
                    nx_2 = _o278.nx_2;
                    ny_2 = _o278.ny_2;
                    nz_2 = _o278.nz_2;
                    turn_rate_2 = _o278.turn_rate_2;
                    const kernel_roll_2_out _o279 = kernel_roll_2(p_gravity, p_inertia, nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, lift_0, lift_1, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1);
                    lift_2 = _o279.lift_2;
                    tx_2 = _o279.tx_2;
                    ty_2 = _o279.ty_2;
                    tz_2 = _o279.tz_2;
                    vx_3 = _o279.vx_3;
                    vy_3 = _o279.vy_3;
                    vz_3 = _o279.vz_3;
                    nx_3 = _o279.nx_3;
                    ny_3 = _o279.ny_3;
                    nz_3 = _o279.nz_3;
                    turn_rate_3 = _o279.turn_rate_3;
                    const kernel_roll_3_out _o280 = kernel_roll_3(p_gravity, p_inertia, nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, lift_0, lift_1, lift_2, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2);
                    lift_3 = _o280.lift_3;
                    tx_3 = _o280.tx_3;
                    ty_3 = _o280.ty_3;
                    tz_3 = _o280.tz_3;
                    vx_4 = _o280.vx_4;
                    vy_4 = _o280.vy_4;
                    vz_4 = _o280.vz_4;
                    nx_4 = _o280.nx_4;
                    ny_4 = _o280.ny_4;
                    nz_4 = _o280.nz_4;
                    turn_rate_4 = _o280.turn_rate_4;
                    const kernel_roll_4_out _o281 = kernel_roll_4(p_gravity, p_inertia, nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, lift_0, lift_1, lift_2, lift_3, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3);
                    lift_4 = _o281.lift_4;
                    tx_4 = _o281.tx_4;
                    ty_4 = _o281.ty_4;
                    tz_4 = _o281.tz_4;
                    vx_5 = _o281.vx_5;
                    vy_5 = _o281.vy_5;
                    vz_5 = _o281.vz_5;
                    nx_5 = _o281.nx_5;
                    ny_5 = _o281.ny_5;
                    nz_5 = _o281.nz_5;
                    turn_rate_5 = _o281.turn_rate_5;
                    const kernel_roll_5_out _o282 = kernel_roll_5(p_gravity, p_inertia, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, lift_0, lift_1, lift_2, lift_3, lift_4, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4);
                    lift_5 = _o282.lift_5;
                    tx_5 = _o282.tx_5;
                    ty_5 = _o282.ty_5;
                    tz_5 = _o282.tz_5;
                    vx_6 = _o282.vx_6;
                    vy_6 = _o282.vy_6;
                    vz_6 = _o282.vz_6;
                    nx_6 = _o282.nx_6;
                    ny_6 = _o282.ny_6;
                    nz_6 = _o282.nz_6;
                    turn_rate_6 = _o282.turn_rate_6;
                    const kernel_roll_6_out _o283 = kernel_roll_6(p_gravity, p_inertia, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5);
                    lift_6 = _o283.lift_6;
                    tx_6 = _o283.tx_6;
                    ty_6 = _o283.ty_6;
                    tz_6 = _o283.tz_6;
                    vx_7 = _o283.vx_7;
                    vy_7 = _o283.vy_7;
                    vz_7 = _o283.vz_7;
                    nx_7 = _o283.nx_7;
                    ny_7 = _o283.ny_7;
                    nz_7 = _o283.nz_7;
                    turn_rate_7 = _o283.turn_rate_7;
                    const kernel_roll_7_out _o284 = kernel_roll_7(p_gravity, p_inertia, nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6);
                    vx_8 = _o284.vx_8;
                    vy_8 = _o284.vy_8;
                    vz_8 = _o284.vz_8;
                    turn_rate_8 = _o284.turn_rate_8;
                    const kernel_roll_moved_out _o285 = kernel_roll_moved(far_x, far_y, far_z, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8);
                    far_x = _o285.x;
                    far_vx = _o285.vx;
                    far_y = _o285.y;
                    far_vy = _o285.vy;
                    far_z = _o285.z;
                    far_vz = _o285.vz;
                    turn_rate = _o285.turn_rate;
                    const kernel_holding_out _o286 = kernel_holding(1.0, held);
                    here = _o286.here;
                    if (here) {
                        const kernel_backboard_normal_out _o287 = kernel_backboard_normal(far_x, far_y, far_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                        far_nx = _o287.nx;
                        far_ny = _o287.ny;
                        far_nz = _o287.nz;
                        const kernel_backboard_distance_out _o288 = kernel_backboard_distance(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, far_x, far_y, far_z);
                        far_gap = _o288.gap;
                    }
                    const kernel_holding_out _o289 = kernel_holding(2.0, held);
                    here = _o289.here;
                    if (here) {
                        const kernel_bridge_normal_out _o290 = kernel_bridge_normal(far_x, far_y, far_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                        far_nx = _o290.nx;
                        far_ny = _o290.ny;
                        far_nz = _o290.nz;
                        const kernel_bridge_distance_out _o291 = kernel_bridge_distance(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, far_x, far_y, far_z);
                        far_gap = _o291.gap;
                    }
                    const kernel_roll_placed_out _o292 = kernel_roll_placed(p_ball_radius, far_x, far_y, far_z, far_nx, far_ny, far_nz, far_vx, far_vy, far_vz, far_gap, turn_rate);
                    far_x = _o292.x;
                    far_y = _o292.y;
                    far_z = _o292.z;
                    far_vx = _o292.vx;
                    far_vy = _o292.vy;
                    far_vz = _o292.vz;
                    far_wx = _o292.wx;
                    far_wy = _o292.wy;
                    far_wz = _o292.wz;
                    const kernel_compared_out _o293 = kernel_compared(p_ball_radius, x, y, z, vx, vy, vz, wx, wy, wz, far_x, far_y, far_z, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, stride, missed, neighbour_scale);
                    dx = _o293.dx;
                    dy = _o293.dy;
                    dz = _o293.dz;
                    dvx = _o293.dvx;
                    dvy = _o293.dvy;
                    dvz = _o293.dvz;
                    dwx = _o293.dwx;
                    dwy = _o293.dwy;
                    dwz = _o293.dwz;
                }
                const kernel_rolled_on_out _o294 = kernel_rolled_on(which, clock, stride, rests);
                clock = _o294.clock;
                rolling = _o294.rolling;
            }
            for (size_t _turn = 0; _turn < 16; _turn++) {
                if (!circling)
                    break;
                if (BOUNDS) {
                    const kernel_error_bounds_out _o295 = kernel_error_bounds(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, position_bound, velocity_bound, spin_bound, estimated, clock_bound);
                    position_error = _o295.position_error;
                    velocity_error = _o295.velocity_error;
                }
                const kernel_ring_rolling_surface_out _o296 = kernel_ring_rolling_surface(p_ball_radius, p_wire_radius);
                per_reach = _o296.per_reach;
                const kernel_ring_round_start_out _o297 = kernel_ring_round_start(p_ball_radius, p_inertia, p_ring_radius, p_wire_radius, x, y, z, vx, vy, vz, wx, wy, wz, per_reach);
                cosine_0 = _o297.cosine_0;
                sine_0 = _o297.sine_0;
                climb_0 = _o297.climb_0;
                along_0 = _o297.along_0;
                turn_rate_0 = _o297.turn_rate_0;
                cos_0 = _o297.cos_0;
                sin_0 = _o297.sin_0;
                tilted_0 = _o297.tilted_0;
                near_0 = _o297.near_0;
                const kernel_ring_round_0_out _o298 = kernel_ring_round_0(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, near_0, climb_0, cosine_0, sine_0, along_0, tilted_0);
                omega_0 = _o298.omega_0;
                around_0 = _o298.around_0;
                cosine_1 = _o298.cosine_1;
                sine_1 = _o298.sine_1;
                climb_1 = _o298.climb_1;
                along_1 = _o298.along_1;
                turn_rate_1 = _o298.turn_rate_1;
                tilted_1 = _o298.tilted_1;
                const kernel_ring_round_1_out _o299 = kernel_ring_round_1(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, near_0, climb_0, climb_1, cosine_0, cosine_1, sine_0, sine_1, along_1, omega_0, around_0, tilted_0, tilted_1);
                omega_1 = _o299.omega_1;
                around_1 = _o299.around_1;
                cosine_2 = _o299.cosine_2;
                sine_2 = _o299.sine_2;
                climb_2 = _o299.climb_2;
                along_2 = _o299.along_2;
                turn_rate_2 = _o299.turn_rate_2;
                tilted_2 = _o299.tilted_2;
                const kernel_ring_round_2_out _o300 = kernel_ring_round_2(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, near_0, climb_0, climb_1, climb_2, cosine_0, cosine_1, cosine_2, sine_0, sine_1, sine_2, along_2, omega_0, omega_1, around_0, around_1, tilted_0, tilted_1, tilted_2);
                omega_2 = _o300.omega_2;
                around_2 = _o300.around_2;
                cosine_3 = _o300.cosine_3;
                sine_3 = _o300.sine_3;
                climb_3 = _o300.climb_3;
                along_3 = _o300.along_3;
                turn_rate_3 = _o300.turn_rate_3;
                tilted_3 = _o300.tilted_3;
                const kernel_ring_round_3_out _o301 = kernel_ring_round_3(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, near_0, climb_0, climb_1, climb_2, climb_3, cosine_0, cosine_1, cosine_2, cosine_3, sine_0, sine_1, sine_2, sine_3, along_3, omega_0, omega_1, omega_2, around_0, around_1, around_2, tilted_0, tilted_1, tilted_2, tilted_3);
                omega_3 = _o301.omega_3;
                around_3 = _o301.around_3;
                cosine_4 = _o301.cosine_4;
                sine_4 = _o301.sine_4;
                climb_4 = _o301.climb_4;
                along_4 = _o301.along_4;
                turn_rate_4 = _o301.turn_rate_4;
                tilted_4 = _o301.tilted_4;
                const kernel_ring_round_4_out _o302 = kernel_ring_round_4(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, sine_0, sine_1, sine_2, sine_3, sine_4, along_4, omega_0, omega_1, omega_2, omega_3, around_0, around_1, around_2, around_3, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4);
                omega_4 = _o302.omega_4;
                around_4 = _o302.around_4;
                cosine_5 = _o302.cosine_5;
                sine_5 = _o302.sine_5;
                climb_5 = _o302.climb_5;
                along_5 = _o302.along_5;
                turn_rate_5 = _o302.turn_rate_5;
                tilted_5 = _o302.tilted_5;
                const kernel_ring_round_5_out _o303 = kernel_ring_round_5(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, along_5, omega_0, omega_1, omega_2, omega_3, omega_4, around_0, around_1, around_2, around_3, around_4, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5);
                omega_5 = _o303.omega_5;
                around_5 = _o303.around_5;
                cosine_6 = _o303.cosine_6;
                sine_6 = _o303.sine_6;
                climb_6 = _o303.climb_6;
                along_6 = _o303.along_6;
                turn_rate_6 = _o303.turn_rate_6;
                tilted_6 = _o303.tilted_6;
                const kernel_ring_round_6_out _o304 = kernel_ring_round_6(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, along_6, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, around_0, around_1, around_2, around_3, around_4, around_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6);
                omega_6 = _o304.omega_6;
                around_6 = _o304.around_6;
                cosine_7 = _o304.cosine_7;
                sine_7 = _o304.sine_7;
                climb_7 = _o304.climb_7;
                along_7 = _o304.along_7;
                turn_rate_7 = _o304.turn_rate_7;
                tilted_7 = _o304.tilted_7;
                const kernel_ring_round_7_out _o305 = kernel_ring_round_7(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, along_7, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, around_0, around_1, around_2, around_3, around_4, around_5, around_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7);
                omega_7 = _o305.omega_7;
                around_7 = _o305.around_7;
                cosine_8 = _o305.cosine_8;
                sine_8 = _o305.sine_8;
                climb_8 = _o305.climb_8;
                along_8 = _o305.along_8;
                turn_rate_8 = _o305.turn_rate_8;
                tilted_8 = _o305.tilted_8;
                const kernel_ring_round_8_out _o306 = kernel_ring_round_8(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, along_8, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8);
                omega_8 = _o306.omega_8;
                around_8 = _o306.around_8;
                cosine_9 = _o306.cosine_9;
                sine_9 = _o306.sine_9;
                climb_9 = _o306.climb_9;
                along_9 = _o306.along_9;
                turn_rate_9 = _o306.turn_rate_9;
                tilted_9 = _o306.tilted_9;
                const kernel_ring_round_9_out _o307 = kernel_ring_round_9(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, along_9, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9);
                omega_9 = _o307.omega_9;
                around_9 = _o307.around_9;
                cosine_10 = _o307.cosine_10;
                sine_10 = _o307.sine_10;
                climb_10 = _o307.climb_10;
                along_10 = _o307.along_10;
                turn_rate_10 = _o307.turn_rate_10;
                tilted_10 = _o307.tilted_10;
                const kernel_ring_round_10_out _o308 = kernel_ring_round_10(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, turn_rate_10, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, climb_10, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, cosine_10, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, sine_10, along_10, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, tilted_10);
                omega_10 = _o308.omega_10;
                around_10 = _o308.around_10;
                cosine_11 = _o308.cosine_11;
                sine_11 = _o308.sine_11;
                climb_11 = _o308.climb_11;
                along_11 = _o308.along_11;
                turn_rate_11 = _o308.turn_rate_11;
                tilted_11 = _o308.tilted_11;
                const kernel_ring_round_11_out _o309 = kernel_ring_round_11(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, turn_rate_10, turn_rate_11, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, climb_10, climb_11, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, cosine_10, cosine_11, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, sine_10, sine_11, along_11, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, omega_10, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, around_10, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, tilted_10, tilted_11);
                omega_11 = _o309.omega_11;
                cosine_12 = _o309.cosine_12;
                sine_12 = _o309.sine_12;
                climb_12 = _o309.climb_12;
                along_12 = _o309.along_12;
                turn_rate_12 = _o309.turn_rate_12;
                const kernel_ring_round_step_out _o310 = kernel_ring_round_step(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_11, turn_rate_12, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, climb_10, climb_11, climb_12, cosine_0, cosine_12, sine_0, sine_12, along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, along_10, along_11, along_12, cos_0, sin_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, omega_10, omega_11);
                stride = _o310.stride;
                strongest = _o310.strongest;
                fastest = _o310.fastest;
                section_acceleration = _o310.section_acceleration;
                force = _o310.force;
                force_rate = _o310.force_rate;
                force_bend = _o310.force_bend;
                friction_force_rate = _o310.friction_force_rate;
                vx_1 = _o310.vx_1;
                vy_1 = _o310.vy_1;
                vz_1 = _o310.vz_1;
                if (BOUNDS)
                    missed = _o310.missed;
                if (BOUNDS) {
                    const kernel_ring_round_pulled_out _o311 = kernel_ring_round_pulled(p_gravity, p_inertia, turn_rate_0, turn_rate_1, climb_0, climb_1, cosine_0, cosine_1, omega_0, omega_1);
                    rolling_friction = _o311.rolling_friction;
                    rolling_friction_rate = _o311.rolling_friction_rate;
                    const kernel_ring_impact_grip_deficit_out _o312 = kernel_ring_impact_grip_deficit(p_ring_friction, rolling_friction, rolling_friction_rate, force, force_rate);
                    grip_deficit = _o312.grip_deficit;
                    grip_deficit_rate = _o312.grip_deficit_rate;
                    const kernel_exceeds_grip_out _o313 = kernel_exceeds_grip(grip_deficit, grip_lost);
                    loses = _o313.loses;
                    if (loses) {
                        const kernel_grip_lost_time_out _o314 = kernel_grip_lost_time(clock, grip_deficit, grip_deficit_rate, last_grip_deficit, last_grip_deficit_rate, last_grip_clock);
                        grip_lost = _o314.grip_lost;
                    }
                    const kernel_remember_grip_deficit_out _o315 = kernel_remember_grip_deficit(clock, grip_deficit, grip_deficit_rate);
                    last_grip_deficit = _o315.last_grip_deficit;
                    last_grip_deficit_rate = _o315.last_grip_deficit_rate;
                    last_grip_clock = _o315.last_grip_clock;
                }
                const kernel_leaving_force_out _o316 = kernel_leaving_force(p_ball_radius, p_gravity, vx, vx_1, vy, vy_1, vz, vz_1, which, undecided_time, position_error, velocity_error, per_reach, force, force_rate, force_bend, friction_force_rate, stride, fastest);
                stride = _o316.stride;
                which = _o316.which;
                rests = _o316.rests;
                if (BOUNDS)
                    undecided_time = _o316.undecided_time;
                const kernel_backboard_beside_out _o317 = kernel_backboard_beside(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z, vx, vy, vz);
                gap = _o317.gap;
                nearing = _o317.nearing;
                gap_curvature = _o317.gap_curvature;
                const kernel_beside_body_out _o318 = kernel_beside_body(p_ball_radius, x, y, z, gap, 1.0, which, earliest_delay, undecided_time, position_error, nearing, gap_curvature, stride, strongest, fastest);
                stride = _o318.stride;
                which = _o318.which;
                if (BOUNDS) {
                    undecided_time = _o318.undecided_time;
                    earliest_delay = _o318.earliest_delay;
                }
                const kernel_bridge_beside_out _o319 = kernel_bridge_beside(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z, vx, vy, vz);
                gap = _o319.gap;
                nearing = _o319.nearing;
                gap_curvature = _o319.gap_curvature;
                const kernel_beside_body_out _o320 = kernel_beside_body(p_ball_radius, x, y, z, gap, 2.0, which, earliest_delay, undecided_time, position_error, nearing, gap_curvature, stride, strongest, fastest);
                stride = _o320.stride;
                which = _o320.which;
                if (BOUNDS) {
                    undecided_time = _o320.undecided_time;
                    earliest_delay = _o320.earliest_delay;
                }
                const kernel_end_beside_out _o321 = kernel_end_beside(p_end_depth, z, vz);
                gap = _o321.gap;
                nearing = _o321.nearing;
                gap_curvature = _o321.gap_curvature;
                const kernel_beside_end_plane_out _o322 = kernel_beside_end_plane(p_ball_radius, x, y, z, gap, 3.0, which, earliest_delay, undecided_time, position_error, nearing, gap_curvature, stride, strongest, fastest);
                stride = _o322.stride;
                which = _o322.which;
                if (BOUNDS) {
                    undecided_time = _o322.undecided_time;
                    earliest_delay = _o322.earliest_delay;
                }
                const kernel_beside_time_out _o323 = kernel_beside_time(which, clock, time_limit, stride);
                stride = _o323.stride;
                which = _o323.which;
                if (BOUNDS) {
                    const kernel_neighbour_scale_out _o324 = kernel_neighbour_scale(p_ball_radius, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz);
                    neighbour_scale = _o324.neighbour_scale;
                    const kernel_neighbour_out _o325 = kernel_neighbour(x, y, z, vx, vy, vz, wx, wy, wz, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, neighbour_scale);
                    far_x = _o325.far_x;
                    far_y = _o325.far_y;
                    far_z = _o325.far_z;
                    far_vx = _o325.far_vx;
                    far_vy = _o325.far_vy;
                    far_vz = _o325.far_vz;
                    far_wx = _o325.far_wx;
                    far_wy = _o325.far_wy;
                    far_wz = _o325.far_wz;
                }
                const kernel_passing_from_out _o326 = kernel_passing_from(z);
                over = _o326.over;
                const kernel_isolated_out _o327 = kernel_isolated();
                azimuth_clearance = _o327.nearest;
                const kernel_half_steps_out _o328 = kernel_half_steps(stride);
                forth = _o328.forth;
                back = _o328.back;
                const kernel_backboard_around_out _o329 = kernel_backboard_around(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z, vx, vy, vz);
                gap = _o329.gap;
                nearing = _o329.nearing;
                const kernel_clearance_at_any_azimuth_out _o330 = kernel_clearance_at_any_azimuth(gap, nearing, forth, azimuth_clearance);
                azimuth_clearance = _o330.azimuth_clearance;
                const kernel_bridge_around_out _o331 = kernel_bridge_around(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z, vx, vy, vz);
                gap = _o331.gap;
                nearing = _o331.nearing;
                const kernel_clearance_at_any_azimuth_out _o332 = kernel_clearance_at_any_azimuth(gap, nearing, forth, azimuth_clearance);
                azimuth_clearance = _o332.azimuth_clearance;
                const kernel_end_around_out _o333 = kernel_end_around(p_end_depth, z, vz);
                gap = _o333.gap;
                nearing = _o333.nearing;
                const kernel_clearance_at_any_azimuth_out _o334 = kernel_clearance_at_any_azimuth(gap, nearing, forth, azimuth_clearance);
                azimuth_clearance = _o334.azimuth_clearance;
                const kernel_ring_round_moved_out _o335 = kernel_ring_round_moved(p_ball_radius, p_ring_radius, p_wire_radius, stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, turn_rate_10, turn_rate_11, turn_rate_12, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, climb_10, climb_11, climb_12, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, cosine_10, cosine_11, cosine_12, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, sine_10, sine_11, sine_12, along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, along_10, along_11, along_12, cos_0, sin_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, omega_10, omega_11);
                x = _o335.x;
                y = _o335.y;
                z = _o335.z;
                vx = _o335.vx;
                vy = _o335.vy;
                vz = _o335.vz;
                wx = _o335.wx;
                wy = _o335.wy;
                wz = _o335.wz;
                climb = _o335.climb;
                const kernel_passing_in_contact_out _o336 = kernel_passing_in_contact(p_ring_radius, x, y, z, through, over);
                through = _o336.through;
                const kernel_backboard_around_out _o337 = kernel_backboard_around(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z, vx, vy, vz);
                gap = _o337.gap;
                nearing = _o337.nearing;
                const kernel_clearance_at_any_azimuth_out _o338 = kernel_clearance_at_any_azimuth(gap, nearing, back, azimuth_clearance);
                azimuth_clearance = _o338.azimuth_clearance;
                const kernel_bridge_around_out _o339 = kernel_bridge_around(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z, vx, vy, vz);
                gap = _o339.gap;
                nearing = _o339.nearing;
                const kernel_clearance_at_any_azimuth_out _o340 = kernel_clearance_at_any_azimuth(gap, nearing, back, azimuth_clearance);
                azimuth_clearance = _o340.azimuth_clearance;
                const kernel_end_around_out _o341 = kernel_end_around(p_end_depth, z, vz);
                gap = _o341.gap;
                nearing = _o341.nearing;
                const kernel_clearance_at_any_azimuth_out _o342 = kernel_clearance_at_any_azimuth(gap, nearing, back, azimuth_clearance);
                azimuth_clearance = _o342.azimuth_clearance;
                const kernel_ring_swung_out _o343 = kernel_ring_swung(p_ball_radius, p_gravity, p_wire_radius, which, undecided_time, position_error, velocity_error, force, force_rate, force_bend, stride, fastest, circled, climb, climb_0, section_acceleration, azimuth_clearance);
                circled = _o343.circled;
                endless = _o343.endless;
                if (BOUNDS)
                    undecided_time = _o343.undecided_time;
                const kernel_rolls_for_ever_out _o344 = kernel_rolls_for_ever(which, endless);
                which = _o344.which;
                if (BOUNDS) {
                    const kernel_ring_round_start_out _o345 = kernel_ring_round_start(p_ball_radius, p_inertia, p_ring_radius, p_wire_radius, far_x, far_y, far_z, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, per_reach);
                    cosine_0 = _o345.cosine_0;
                    sine_0 = _o345.sine_0;
                    climb_0 = _o345.climb_0;
                    along_0 = _o345.along_0;
                    turn_rate_0 = _o345.turn_rate_0;
                    cos_0 = _o345.cos_0;
                    sin_0 = _o345.sin_0;
                    tilted_0 = _o345.tilted_0;
                    near_0 = _o345.near_0;
                    const kernel_ring_round_0_out _o346 = kernel_ring_round_0(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, near_0, climb_0, cosine_0, sine_0, along_0, tilted_0);
                    omega_0 = _o346.omega_0;
                    around_0 = _o346.around_0;
                    cosine_1 = _o346.cosine_1;
                    sine_1 = _o346.sine_1;
                    climb_1 = _o346.climb_1;
                    along_1 = _o346.along_1;
                    turn_rate_1 = _o346.turn_rate_1;
                    tilted_1 = _o346.tilted_1;
                    const kernel_ring_round_1_out _o347 = kernel_ring_round_1(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, near_0, climb_0, climb_1, cosine_0, cosine_1, sine_0, sine_1, along_1, omega_0, around_0, tilted_0, tilted_1);
                    omega_1 = _o347.omega_1;
                    around_1 = _o347.around_1;
                    cosine_2 = _o347.cosine_2;
                    sine_2 = _o347.sine_2;
                    climb_2 = _o347.climb_2;
                    along_2 = _o347.along_2;
                    turn_rate_2 = _o347.turn_rate_2;
                    tilted_2 = _o347.tilted_2;
                    const kernel_ring_round_2_out _o348 = kernel_ring_round_2(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, near_0, climb_0, climb_1, climb_2, cosine_0, cosine_1, cosine_2, sine_0, sine_1, sine_2, along_2, omega_0, omega_1, around_0, around_1, tilted_0, tilted_1, tilted_2);
                    omega_2 = _o348.omega_2;
                    around_2 = _o348.around_2;
                    cosine_3 = _o348.cosine_3;
                    sine_3 = _o348.sine_3;
                    climb_3 = _o348.climb_3;
                    along_3 = _o348.along_3;
                    turn_rate_3 = _o348.turn_rate_3;
                    tilted_3 = _o348.tilted_3;
                    const kernel_ring_round_3_out _o349 = kernel_ring_round_3(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, near_0, climb_0, climb_1, climb_2, climb_3, cosine_0, cosine_1, cosine_2, cosine_3, sine_0, sine_1, sine_2, sine_3, along_3, omega_0, omega_1, omega_2, around_0, around_1, around_2, tilted_0, tilted_1, tilted_2, tilted_3);
                    omega_3 = _o349.omega_3;
                    around_3 = _o349.around_3;
                    cosine_4 = _o349.cosine_4;
                    sine_4 = _o349.sine_4;
                    climb_4 = _o349.climb_4;
                    along_4 = _o349.along_4;
                    turn_rate_4 = _o349.turn_rate_4;
                    tilted_4 = _o349.tilted_4;
                    const kernel_ring_round_4_out _o350 = kernel_ring_round_4(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, sine_0, sine_1, sine_2, sine_3, sine_4, along_4, omega_0, omega_1, omega_2, omega_3, around_0, around_1, around_2, around_3, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4);
                    omega_4 = _o350.omega_4;
                    around_4 = _o350.around_4;
                    cosine_5 = _o350.cosine_5;
                    sine_5 = _o350.sine_5;
                    climb_5 = _o350.climb_5;
                    along_5 = _o350.along_5;
                    turn_rate_5 = _o350.turn_rate_5;
                    tilted_5 = _o350.tilted_5;
                    const kernel_ring_round_5_out _o351 = kernel_ring_round_5(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, along_5, omega_0, omega_1, omega_2, omega_3, omega_4, around_0, around_1, around_2, around_3, around_4, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5);
                    omega_5 = _o351.omega_5;
                    around_5 = _o351.around_5;
                    cosine_6 = _o351.cosine_6;
                    sine_6 = _o351.sine_6;
                    climb_6 = _o351.climb_6;
                    along_6 = _o351.along_6;
                    turn_rate_6 = _o351.turn_rate_6;
                    tilted_6 = _o351.tilted_6;
                    const kernel_ring_round_6_out _o352 = kernel_ring_round_6(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, along_6, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, around_0, around_1, around_2, around_3, around_4, around_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6);
                    omega_6 = _o352.omega_6;
                    around_6 = _o352.around_6;
                    cosine_7 = _o352.cosine_7;
                    sine_7 = _o352.sine_7;
                    climb_7 = _o352.climb_7;
                    along_7 = _o352.along_7;
                    turn_rate_7 = _o352.turn_rate_7;
                    tilted_7 = _o352.tilted_7;
                    const kernel_ring_round_7_out _o353 = kernel_ring_round_7(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, along_7, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, around_0, around_1, around_2, around_3, around_4, around_5, around_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7);
                    omega_7 = _o353.omega_7;
                    around_7 = _o353.around_7;
                    cosine_8 = _o353.cosine_8;
                    sine_8 = _o353.sine_8;
                    climb_8 = _o353.climb_8;
                    along_8 = _o353.along_8;
                    turn_rate_8 = _o353.turn_rate_8;
                    tilted_8 = _o353.tilted_8;
                    const kernel_ring_round_8_out _o354 = kernel_ring_round_8(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, along_8, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8);
                    omega_8 = _o354.omega_8;
                    around_8 = _o354.around_8;
                    cosine_9 = _o354.cosine_9;
                    sine_9 = _o354.sine_9;
                    climb_9 = _o354.climb_9;
                    along_9 = _o354.along_9;
                    turn_rate_9 = _o354.turn_rate_9;
                    tilted_9 = _o354.tilted_9;
                    const kernel_ring_round_9_out _o355 = kernel_ring_round_9(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, along_9, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9);
                    omega_9 = _o355.omega_9;
                    around_9 = _o355.around_9;
                    cosine_10 = _o355.cosine_10;
                    sine_10 = _o355.sine_10;
                    climb_10 = _o355.climb_10;
                    along_10 = _o355.along_10;
                    turn_rate_10 = _o355.turn_rate_10;
                    tilted_10 = _o355.tilted_10;
                    const kernel_ring_round_10_out _o356 = kernel_ring_round_10(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, turn_rate_10, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, climb_10, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, cosine_10, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, sine_10, along_10, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, tilted_10);
                    omega_10 = _o356.omega_10;
                    around_10 = _o356.around_10;
                    cosine_11 = _o356.cosine_11;
                    sine_11 = _o356.sine_11;
                    climb_11 = _o356.climb_11;
                    along_11 = _o356.along_11;
                    turn_rate_11 = _o356.turn_rate_11;
                    tilted_11 = _o356.tilted_11;
                    const kernel_ring_round_11_out _o357 = kernel_ring_round_11(p_ball_radius, p_gravity, p_inertia, p_ring_radius, p_wire_radius, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, turn_rate_10, turn_rate_11, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, climb_10, climb_11, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, cosine_10, cosine_11, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, sine_10, sine_11, along_11, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, omega_10, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, around_10, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, tilted_10, tilted_11);
                    omega_11 = _o357.omega_11;
                    cosine_12 = _o357.cosine_12;
                    sine_12 = _o357.sine_12;
                    climb_12 = _o357.climb_12;
                    along_12 = _o357.along_12;
                    turn_rate_12 = _o357.turn_rate_12;
                    const kernel_ring_round_moved_out _o358 = kernel_ring_round_moved(p_ball_radius, p_ring_radius, p_wire_radius, stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, turn_rate_10, turn_rate_11, turn_rate_12, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, climb_10, climb_11, climb_12, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, cosine_10, cosine_11, cosine_12, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, sine_10, sine_11, sine_12, along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, along_10, along_11, along_12, cos_0, sin_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, omega_10, omega_11);
                    far_x = _o358.x;
                    far_y = _o358.y;
                    far_z = _o358.z;
                    far_vx = _o358.vx;
                    far_vy = _o358.vy;
                    far_vz = _o358.vz;
                    far_wx = _o358.wx;
                    far_wy = _o358.wy;
                    far_wz = _o358.wz;
                    const kernel_compared_out _o359 = kernel_compared(p_ball_radius, x, y, z, vx, vy, vz, wx, wy, wz, far_x, far_y, far_z, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, stride, missed, neighbour_scale);
                    dx = _o359.dx;
                    dy = _o359.dy;
                    dz = _o359.dz;
                    dvx = _o359.dvx;
                    dvy = _o359.dvy;
                    dvz = _o359.dvz;
                    dwx = _o359.dwx;
                    dwy = _o359.dwy;
                    dwz = _o359.dwz;
                }
                const kernel_rolled_on_out _o360 = kernel_rolled_on(which, clock, stride, rests);
                clock = _o360.clock;
                circling = _o360.rolling;
            }
            const kernel_still_in_contact_out _o361 = kernel_still_in_contact(rolling, circling);
            rolling = _o361.rolling;
            if (leaves) {
                if (BOUNDS) {
                    const kernel_error_bounds_out _o362 = kernel_error_bounds(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, position_bound, velocity_bound, spin_bound, estimated, clock_bound);
                    position_error = _o362.position_error;
                    velocity_error = _o362.velocity_error;
                }
                const kernel_holding_out _o363 = kernel_holding(0.0, held);
                here = _o363.here;
                if (here) {
                    const kernel_ring_rolling_surface_out _o364 = kernel_ring_rolling_surface(p_ball_radius, p_wire_radius);
                    per_reach = _o364.per_reach;
                    const kernel_ring_separation_out _o365 = kernel_ring_separation(p_gravity, p_ring_radius, x, y, z, vx, vy, vz);
                    lift = _o365.lift;
                    gap_jerk = _o365.gap_jerk;
                    gap_snap = _o365.gap_snap;
                }
                const kernel_holding_out _o366 = kernel_holding(1.0, held);
                here = _o366.here;
                if (here) {
                    const kernel_backboard_rolling_surface_out _o367 = kernel_backboard_rolling_surface(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z, vx, vy, vz);
                    per_reach = _o367.per_reach;
                    const kernel_backboard_separation_out _o368 = kernel_backboard_separation(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, x, y, z, vx, vy, vz);
                    lift = _o368.lift;
                    gap_jerk = _o368.gap_jerk;
                    gap_snap = _o368.gap_snap;
                }
                const kernel_holding_out _o369 = kernel_holding(2.0, held);
                here = _o369.here;
                if (here) {
                    const kernel_bridge_rolling_surface_out _o370 = kernel_bridge_rolling_surface(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z, vx, vy, vz);
                    per_reach = _o370.per_reach;
                    const kernel_bridge_separation_out _o371 = kernel_bridge_separation(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, p_wire_radius, x, y, z, vx, vy, vz);
                    lift = _o371.lift;
                    gap_jerk = _o371.gap_jerk;
                    gap_snap = _o371.gap_snap;
                }
                const kernel_no_contact_out _o372 = kernel_no_contact();
                free_time = _o372.free_time;
                const kernel_beside_out _o373 = kernel_beside(0.0, held);
                beside = _o373.beside;
                if (beside) {
                    const kernel_ring_beside_out _o374 = kernel_ring_beside(p_ball_radius, p_ring_radius, p_wire_radius, x, y, z, vx, vy, vz);
                    gap = _o374.gap;
                    nearing = _o374.nearing;
                    gap_curvature = _o374.gap_curvature;
                    const kernel_neighbour_free_time_out _o375 = kernel_neighbour_free_time(p_gravity, vx, vy, vz, gap, free_time, nearing, gap_curvature);
                    free_time = _o375.free_time;
                }
                const kernel_beside_out _o376 = kernel_beside(1.0, held);
                beside = _o376.beside;
                if (beside) {
                    const kernel_backboard_beside_out _o377 = kernel_backboard_beside(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z, vx, vy, vz);
                    gap = _o377.gap;
                    nearing = _o377.nearing;
                    gap_curvature = _o377.gap_curvature;
                    const kernel_neighbour_free_time_out _o378 = kernel_neighbour_free_time(p_gravity, vx, vy, vz, gap, free_time, nearing, gap_curvature);
                    free_time = _o378.free_time;
                }
                const kernel_beside_out _o379 = kernel_beside(2.0, held);
                beside = _o379.beside;
                if (beside) {
                    const kernel_bridge_beside_out _o380 = kernel_bridge_beside(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z, vx, vy, vz);
                    gap = _o380.gap;
                    nearing = _o380.nearing;
                    gap_curvature = _o380.gap_curvature;
                    const kernel_neighbour_free_time_out _o381 = kernel_neighbour_free_time(p_gravity, vx, vy, vz, gap, free_time, nearing, gap_curvature);
                    free_time = _o381.free_time;
                }
                const kernel_end_beside_out _o382 = kernel_end_beside(p_end_depth, z, vz);
                gap = _o382.gap;
                nearing = _o382.nearing;
                gap_curvature = _o382.gap_curvature;
                const kernel_end_plane_free_time_out _o383 = kernel_end_plane_free_time(p_gravity, vx, vy, vz, gap, undecided_time, free_time, nearing, gap_curvature);
                free_time = _o383.free_time;
                if (BOUNDS)
                    undecided_time = _o383.undecided_time;
                const kernel_holding_out _o384 = kernel_holding(1.0, held);
                here = _o384.here;
                if (here) {
                    const kernel_backboard_seam0_out _o385 = kernel_backboard_seam0(p_ball_radius, p_board_distance, p_board_thickness, x, vx);
                    gap = _o385.gap;
                    nearing = _o385.nearing;
                    near = _o385.near;
                    const kernel_seam_free_time_out _o386 = kernel_seam_free_time(p_gravity, gap, free_time, near, nearing);
                    free_time = _o386.free_time;
                    const kernel_backboard_seam1_out _o387 = kernel_backboard_seam1(p_ball_radius, p_board_distance, p_board_thickness, x, vx);
                    gap = _o387.gap;
                    nearing = _o387.nearing;
                    near = _o387.near;
                    const kernel_seam_free_time_out _o388 = kernel_seam_free_time(p_gravity, gap, free_time, near, nearing);
                    free_time = _o388.free_time;
                    const kernel_backboard_seam2_out _o389 = kernel_backboard_seam2(p_ball_radius, p_board_half_width, y, vy);
                    gap = _o389.gap;
                    nearing = _o389.nearing;
                    near = _o389.near;
                    const kernel_seam_free_time_out _o390 = kernel_seam_free_time(p_gravity, gap, free_time, near, nearing);
                    free_time = _o390.free_time;
                    const kernel_backboard_seam3_out _o391 = kernel_backboard_seam3(p_ball_radius, p_board_half_width, y, vy);
                    gap = _o391.gap;
                    nearing = _o391.nearing;
                    near = _o391.near;
                    const kernel_seam_free_time_out _o392 = kernel_seam_free_time(p_gravity, gap, free_time, near, nearing);
                    free_time = _o392.free_time;
                    const kernel_backboard_seam4_out _o393 = kernel_backboard_seam4(p_ball_radius, p_board_bottom, p_board_top, z, vz);
                    gap = _o393.gap;
                    nearing = _o393.nearing;
                    near = _o393.near;
                    const kernel_seam_free_time_out _o394 = kernel_seam_free_time(p_gravity, gap, free_time, near, nearing);
                    free_time = _o394.free_time;
                    const kernel_backboard_seam5_out _o395 = kernel_backboard_seam5(p_ball_radius, p_board_bottom, p_board_top, z, vz);
                    gap = _o395.gap;
                    nearing = _o395.nearing;
                    near = _o395.near;
                    const kernel_seam_free_time_out _o396 = kernel_seam_free_time(p_gravity, gap, free_time, near, nearing);
                    free_time = _o396.free_time;
                }
                const kernel_holding_out _o397 = kernel_holding(2.0, held);
                here = _o397.here;
                if (here) {
                    const kernel_bridge_seam0_out _o398 = kernel_bridge_seam0(p_ball_radius, p_board_distance, p_ring_radius, x, vx);
                    gap = _o398.gap;
                    nearing = _o398.nearing;
                    near = _o398.near;
                    const kernel_seam_free_time_out _o399 = kernel_seam_free_time(p_gravity, gap, free_time, near, nearing);
                    free_time = _o399.free_time;
                    const kernel_bridge_seam1_out _o400 = kernel_bridge_seam1(p_ball_radius, p_board_distance, p_ring_radius, x, vx);
                    gap = _o400.gap;
                    nearing = _o400.nearing;
                    near = _o400.near;
                    const kernel_seam_free_time_out _o401 = kernel_seam_free_time(p_gravity, gap, free_time, near, nearing);
                    free_time = _o401.free_time;
                    const kernel_bridge_seam2_out _o402 = kernel_bridge_seam2(p_ball_radius, p_bridge_half_width, y, vy);
                    gap = _o402.gap;
                    nearing = _o402.nearing;
                    near = _o402.near;
                    const kernel_seam_free_time_out _o403 = kernel_seam_free_time(p_gravity, gap, free_time, near, nearing);
                    free_time = _o403.free_time;
                    const kernel_bridge_seam3_out _o404 = kernel_bridge_seam3(p_ball_radius, p_bridge_half_width, y, vy);
                    gap = _o404.gap;
                    nearing = _o404.nearing;
                    near = _o404.near;
                    const kernel_seam_free_time_out _o405 = kernel_seam_free_time(p_gravity, gap, free_time, near, nearing);
                    free_time = _o405.free_time;
                    const kernel_bridge_seam4_out _o406 = kernel_bridge_seam4(p_ball_radius, p_bridge_depth, p_wire_radius, z, vz);
                    gap = _o406.gap;
                    nearing = _o406.nearing;
                    near = _o406.near;
                    const kernel_seam_free_time_out _o407 = kernel_seam_free_time(p_gravity, gap, free_time, near, nearing);
                    free_time = _o407.free_time;
                    const kernel_bridge_seam5_out _o408 = kernel_bridge_seam5(p_ball_radius, p_bridge_depth, p_wire_radius, z, vz);
                    gap = _o408.gap;
                    nearing = _o408.nearing;
                    near = _o408.near;
                    const kernel_seam_free_time_out _o409 = kernel_seam_free_time(p_gravity, gap, free_time, near, nearing);
                    free_time = _o409.free_time;
                }
                const kernel_separated_out _o410 = kernel_separated(p_gravity, vx, vy, vz, undecided_time, position_error, velocity_error, clock, time_limit, per_reach, free_time, lift, gap_jerk, gap_snap);
                when = _o410.when;
                if (BOUNDS)
                    undecided_time = _o410.undecided_time;
                const kernel_detachment_out _o411 = kernel_detachment();
                which = _o411.which;
            }
        }
        const kernel_departed_out _o412 = kernel_departed(3.0, which);
        moves = _o412.moves;
        ends = _o412.ends;
        touches = _o412.touches;
        reached = _o412.reached;
        if (BOUNDS)
            edge = _o412.edge;
        const kernel_body_of_out _o413 = kernel_body_of(which);
        body = _o413.body;
        if (in_contact) {
            const kernel_nothing_happens_yet_out _o414 = kernel_nothing_happens_yet(body, touches, mode, moves);
            moves = _o414.moves;
            touches = _o414.touches;
            body = _o414.body;
        }
        if (moves) {
            if (BOUNDS) {
                const kernel_passing_undecided_out _o415 = kernel_passing_undecided(when, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ring_radius, p_gravity);
                undecided = _o415.undecided;
                const kernel_undecided_out _o416 = kernel_undecided(uncertain, undecided);
                uncertain = _o416.uncertain;
            }
            const kernel_passing_out _o417 = kernel_passing(through, when, x, y, z, vx, vy, vz, p_ring_radius, p_gravity);
            through = _o417.through;
            const kernel_flight_out _o418 = kernel_flight(when, x, y, z, vx, vy, vz, p_gravity);
            x = _o418.x;
            y = _o418.y;
            z = _o418.z;
            vx = _o418.vx;
            vy = _o418.vy;
            vz = _o418.vz;
            const kernel_event_clock_out _o419 = kernel_event_clock(when, clock);
            clock = _o419.clock;
        }
        if (limited) {
            const kernel_expired_out _o420 = kernel_expired(4.0, which, body, clock, reached, time_limit, ends);
            clock = _o420.clock;
            body = _o420.body;
            reached = _o420.reached;
            ends = _o420.ends;
        }
        if (BOUNDS) {
            const kernel_no_departure_out _o421 = kernel_no_departure();
            hopped = _o421.hopped;
        }
        if (in_contact) {
            const kernel_stay_in_contact_out _o422 = kernel_stay_in_contact(last, which, undecided_time, body, clock, reached, ends, held, mode, rolls, rolling, began, rests);
            body = _o422.body;
            reached = _o422.reached;
            ends = _o422.ends;
            last = _o422.last;
            mode = _o422.mode;
            held = _o422.held;
            rolls = _o422.rolls;
            if (BOUNDS) {
                undecided_time = _o422.undecided_time;
                hopped = _o422.hopped;
            }
        }
        if (BOUNDS) {
            const kernel_displacement_out _o423 = kernel_displacement(earliest_delay, when, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_bridge_half_width, p_bridge_depth, p_gravity, p_end_depth);
            slack = _o423.margin;
        }
        const kernel_here_out _o424 = kernel_here(3.0, which);
        here = _o424.here;
        if (here) {
            const kernel_end_bounds_out _o425 = kernel_end_bounds(x, y, p_ring_radius);
            g0 = _o425.g0;
            const kernel_end_reached_out _o426 = kernel_end_reached(through, g0);
            reached = _o426.reached;
            if (BOUNDS) {
                const kernel_end_edge_out _o427 = kernel_end_edge(slack, through, g0);
                edge = _o427.edge;
            }
        }
        if (BOUNDS) {
            const kernel_contact_undecided_out _o428 = kernel_contact_undecided(last, when, which, earliest_delay, undecided_time, position_error, velocity_error, uncertain, edge, assured);
            uncertain = _o428.uncertain;
        }
        const kernel_accounted_out _o429 = kernel_accounted(contacts, most_contacts, reached, touches);
        contacts = _o429.contacts;
        outcome = _o429.outcome;

        const double _before[] = {x, y, z, vx, vy, vz, wx, wy, wz};

        /* What it does to the ball. */
        const kernel_meeting_out _o430 = kernel_meeting(claims, ends, touches);
        meeting = _o430.meeting;
        const kernel_slow_at_start_out _o431 = kernel_slow_at_start(mode);
        slow = _o431.slow;
        if (meeting) {
            const kernel_end_normal_out _o432 = kernel_end_normal();
            nx = _o432.nx;
            ny = _o432.ny;
            nz = _o432.nz;
            const kernel_here_out _o433 = kernel_here(0.0, which);
            here = _o433.here;
            if (here) {
                const kernel_ring_normal_out _o434 = kernel_ring_normal(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                nx = _o434.nx;
                ny = _o434.ny;
                nz = _o434.nz;
                const kernel_counted_out _o435 = kernel_counted(count_0);
                count_0 = _o435.count;
            }
            const kernel_here_out _o436 = kernel_here(1.0, which);
            here = _o436.here;
            if (here) {
                const kernel_backboard_normal_out _o437 = kernel_backboard_normal(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = _o437.nx;
                ny = _o437.ny;
                nz = _o437.nz;
                const kernel_counted_out _o438 = kernel_counted(count_1);
                count_1 = _o438.count;
            }
            const kernel_here_out _o439 = kernel_here(2.0, which);
            here = _o439.here;
            if (here) {
                const kernel_bridge_normal_out _o440 = kernel_bridge_normal(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = _o440.nx;
                ny = _o440.ny;
                nz = _o440.nz;
                const kernel_counted_out _o441 = kernel_counted(count_2);
                count_2 = _o441.count;
            }
            if (BOUNDS) {
                const kernel_elsewhere_out _o442 = kernel_elsewhere();
                curving = _o442.curving;
                const kernel_other_start_surface_out _o443 = kernel_other_start_surface();
                left_nx = _o443.left_nx;
                left_ny = _o443.left_ny;
                left_nz = _o443.left_nz;
                const kernel_again_out _o444 = kernel_again(0.0, last, which);
                again = _o444.again;
                if (again) {
                    const kernel_ring_curvature_out _o445 = kernel_ring_curvature(p_ball_radius, p_ring_radius, p_wire_radius);
                    curving = _o445.curvature;
                    const kernel_started_out _o446 = kernel_started(p_gravity, x, y, z, vx, vy, vz, when);
                    from_x = _o446.from_x;
                    from_y = _o446.from_y;
                    from_z = _o446.from_z;
                    const kernel_ring_normal_out _o447 = kernel_ring_normal(from_x, from_y, from_z, p_ball_radius, p_ring_radius, p_wire_radius);
                    left_nx = _o447.nx;
                    left_ny = _o447.ny;
                    left_nz = _o447.nz;
                }
                const kernel_again_out _o448 = kernel_again(1.0, last, which);
                again = _o448.again;
                if (again) {
                    const kernel_backboard_curvature_out _o449 = kernel_backboard_curvature(when, x, y, z, vx, vy, vz, dx, dy, dz, dvx, dvy, dvz, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                    curving = _o449.curvature;
                    const kernel_started_out _o450 = kernel_started(p_gravity, x, y, z, vx, vy, vz, when);
                    from_x = _o450.from_x;
                    from_y = _o450.from_y;
                    from_z = _o450.from_z;
                    const kernel_backboard_normal_out _o451 = kernel_backboard_normal(from_x, from_y, from_z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    left_nx = _o451.nx;
                    left_ny = _o451.ny;
                    left_nz = _o451.nz;
                }
                const kernel_again_out _o452 = kernel_again(2.0, last, which);
                again = _o452.again;
                if (again) {
                    const kernel_bridge_curvature_out _o453 = kernel_bridge_curvature(when, x, y, z, vx, vy, vz, dx, dy, dz, dvx, dvy, dvz, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                    curving = _o453.curvature;
                    const kernel_started_out _o454 = kernel_started(p_gravity, x, y, z, vx, vy, vz, when);
                    from_x = _o454.from_x;
                    from_y = _o454.from_y;
                    from_z = _o454.from_z;
                    const kernel_bridge_normal_out _o455 = kernel_bridge_normal(from_x, from_y, from_z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    left_nx = _o455.nx;
                    left_ny = _o455.ny;
                    left_nz = _o455.nz;
                }
                const kernel_carry_flight_out _o456 = kernel_carry_flight(when, x, y, z, vx, vy, vz, nx, ny, nz, clock, contacts, earliest_delay, dx, dy, dz, dvx, dvy, dvz, left_nx, left_ny, left_nz, curving, p_gravity);
                dx = _o456.dx;
                dy = _o456.dy;
                dz = _o456.dz;
                lifting = _o456.lifting;
                dvx = _o456.dvx;
                dvy = _o456.dvy;
                dvz = _o456.dvz;
                belated = _o456.delay;
                shift = _o456.shift;
                const kernel_clock_error_sum_out _o457 = kernel_clock_error_sum(belated, clock_error);
                clock_error = _o457.clock_error;
                if (ends) {
                    const kernel_error_floor_out _o458 = kernel_error_floor(dx, dy, dz, shift);
                    dx = _o458.dx;
                    dy = _o458.dy;
                    dz = _o458.dz;
                }
                const kernel_no_normal_error_out _o459 = kernel_no_normal_error();
                dnx = _o459.dnx;
                dny = _o459.dny;
                dnz = _o459.dnz;
                turn = _o459.turn;
                const kernel_normal_velocity_out _o460 = kernel_normal_velocity(vx, vy, vz, nx, ny, nz);
                normal_velocity = _o460.normal_velocity;
                const kernel_came_back_out _o461 = kernel_came_back(last, which);
                back = _o461.back;
                const kernel_end_tangents_out _o462 = kernel_end_tangents(when, z, vz, p_gravity);
                tangent_x = _o462.tangent_x;
                tangent_y = _o462.tangent_y;
                bend_s = _o462.bend_s;
                bend_e = _o462.bend_e;
                sharpest_bend = _o462.sharpest_bend;
                root_offset = _o462.root_offset;
                root_level = _o462.root_level;
                normal_rounding = _o462.normal_rounding;
                const kernel_here_out _o463 = kernel_here(0.0, which);
                here = _o463.here;
                if (here) {
                    const kernel_ring_tangents_out _o464 = kernel_ring_tangents(when, x, y, z, vx, vy, vz, nx, ny, nz, place_n, normal_velocity, back, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    tangent_x = _o464.tangent_x;
                    tangent_y = _o464.tangent_y;
                    bend_s = _o464.bend_s;
                    bend_e = _o464.bend_e;
                    sharpest_bend = _o464.sharpest_bend;
                    root_offset = _o464.root_offset;
                    root_level = _o464.root_level;
                    normal_rounding = _o464.normal_rounding;
                }
                const kernel_here_out _o465 = kernel_here(1.0, which);
                here = _o465.here;
                if (here) {
                    const kernel_backboard_tangents_out _o466 = kernel_backboard_tangents(when, x, y, z, vx, vy, vz, nx, ny, nz, place_n, normal_velocity, back, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness, p_gravity);
                    tangent_x = _o466.tangent_x;
                    tangent_y = _o466.tangent_y;
                    bend_s = _o466.bend_s;
                    bend_e = _o466.bend_e;
                    sharpest_bend = _o466.sharpest_bend;
                    root_offset = _o466.root_offset;
                    root_level = _o466.root_level;
                    normal_rounding = _o466.normal_rounding;
                }
                const kernel_here_out _o467 = kernel_here(2.0, which);
                here = _o467.here;
                if (here) {
                    const kernel_bridge_tangents_out _o468 = kernel_bridge_tangents(when, x, y, z, vx, vy, vz, nx, ny, nz, place_n, normal_velocity, back, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth, p_gravity);
                    tangent_x = _o468.tangent_x;
                    tangent_y = _o468.tangent_y;
                    bend_s = _o468.bend_s;
                    bend_e = _o468.bend_e;
                    sharpest_bend = _o468.sharpest_bend;
                    root_offset = _o468.root_offset;
                    root_level = _o468.root_level;
                    normal_rounding = _o468.normal_rounding;
                }
                const kernel_proves_out _o469 = kernel_proves(ends, touches, estimated);
                proves_contact = _o469.proves_contact;
                proves_end = _o469.proves_end;
                if (proves_end) {
                    const kernel_bound_end_out _o470 = kernel_bound_end(when, x, y, z, vx, vy, vz, clock, position_bound, velocity_bound, spin_bound, root_offset, normal_velocity, p_gravity);
                    position_bound = _o470.position_bound;
                    velocity_bound = _o470.velocity_bound;
                    spin_bound = _o470.spin_bound;
                    proved_delay = _o470.delay;
                    const kernel_clock_bound_sum_out _o471 = kernel_clock_bound_sum(proved_delay, clock_bound);
                    clock_bound = _o471.clock_bound;
                }
                const kernel_here_out _o472 = kernel_here(0.0, which);
                here = _o472.here;
                if (here) {
                    const kernel_ring_carry_normal_out _o473 = kernel_ring_carry_normal(x, y, dx, dy, dz, shift, p_ball_radius, p_ring_radius, p_wire_radius);
                    dnx = _o473.dnx;
                    dny = _o473.dny;
                    dnz = _o473.dnz;
                    turn = _o473.turn;
                }
                const kernel_here_out _o474 = kernel_here(1.0, which);
                here = _o474.here;
                if (here) {
                    const kernel_backboard_carry_normal_out _o475 = kernel_backboard_carry_normal(x, y, z, dx, dy, dz, shift, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    dnx = _o475.dnx;
                    dny = _o475.dny;
                    dnz = _o475.dnz;
                    turn = _o475.turn;
                }
                const kernel_here_out _o476 = kernel_here(2.0, which);
                here = _o476.here;
                if (here) {
                    const kernel_bridge_carry_normal_out _o477 = kernel_bridge_carry_normal(x, y, z, dx, dy, dz, shift, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    dnx = _o477.dnx;
                    dny = _o477.dny;
                    dnz = _o477.dnz;
                    turn = _o477.turn;
                }
            }
            const kernel_other_kind_out _o478 = kernel_other_kind();
            struck_0 = _o478.of_this_kind;
            const kernel_ring_impact_taken_out _o479 = kernel_ring_impact_taken(p_ring_restitution, p_ring_friction);
            its_0_ring_impact = _o479.its_0;
            its_1_ring_impact = _o479.its_1;
            for (size_t _row = 0; _row < 3; _row++) {
                const double own_1 = parameter(_given, table_2[_row][0]);
                const double own_2 = parameter(_given, table_2[_row][1]);
                const double own_index = table_3[_row][0];
                const kernel_here_out _o480 = kernel_here(own_index, which);
                here = _o480.here;
                if (here) {
                    const kernel_ring_impact_taken_out _o481 = kernel_ring_impact_taken(own_2, own_1);
                    struck_0 = _o481.of_this_kind;
                    its_0_ring_impact = _o481.its_0;
                    its_1_ring_impact = _o481.its_1;
                }
            }
            if (struck_0) {
                if (BOUNDS) {
                    if (proves_contact) {
                        const kernel_ring_impact_slip_out _o482 = kernel_ring_impact_slip(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, its_0_ring_impact, its_1_ring_impact, p_inertia, p_tangential_restitution, p_restitution_speed);
                        slip_share = _o482.slip_share;
                        slip_margin = _o482.slip_margin;
                        slip_speed = _o482.slip_speed;
                        slip_x = _o482.slip_x;
                        slip_y = _o482.slip_y;
                        slip_z = _o482.slip_z;
                        const kernel_bound_ring_impact_out _o483 = kernel_bound_ring_impact(when, x, y, z, vx, vy, vz, wx, wy, wz, nx, ny, nz, clock, frame_nx, frame_ny, frame_nz, place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound, spin_bound, tangent_x, tangent_y, bend_s, bend_e, left_ex, left_ey, left_bend_s, left_bend_e, sharpest_bend, root_offset, root_level, normal_rounding, normal_velocity, back, slip_share, slip_margin, slip_speed, slip_x, slip_y, slip_z, p_ball_radius, p_gravity, its_0_ring_impact, its_1_ring_impact, p_inertia, p_tangential_restitution, p_restitution_speed);
                        place_n = _o483.place_n;
                        place_s = _o483.place_s;
                        place_e = _o483.place_e;
                        pace_n = _o483.pace_n;
                        pace_s = _o483.pace_s;
                        pace_e = _o483.pace_e;
                        turn_n = _o483.turn_n;
                        turn_z = _o483.turn_z;
                        position_bound = _o483.position_bound;
                        velocity_bound = _o483.velocity_bound;
                        spin_bound = _o483.spin_bound;
                        frame_nx = _o483.left_nx;
                        frame_ny = _o483.left_ny;
                        frame_nz = _o483.left_nz;
                        left_ex = _o483.left_ex;
                        left_ey = _o483.left_ey;
                        left_bend_s = _o483.left_bend_s;
                        left_bend_e = _o483.left_bend_e;
                        proved_delay = _o483.delay;
                        const kernel_clock_bound_sum_out _o484 = kernel_clock_bound_sum(proved_delay, clock_bound);
                        clock_bound = _o484.clock_bound;
                    }
                    const kernel_ring_impact_undecided_out _o485 = kernel_ring_impact_undecided(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, turn, p_ball_radius, its_0_ring_impact, its_1_ring_impact, p_inertia, p_tangential_restitution, p_restitution_speed);
                    undecided = _o485.undecided;
                    const kernel_undecided_out _o486 = kernel_undecided(uncertain, undecided);
                    uncertain = _o486.uncertain;
                    const kernel_carry_ring_impact_out _o487 = kernel_carry_ring_impact(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, dnx, dny, dnz, turn, lifting, p_ball_radius, its_0_ring_impact, its_1_ring_impact, p_inertia, p_tangential_restitution, p_restitution_speed);
                    dvx = _o487.dvx;
                    dvy = _o487.dvy;
                    dvz = _o487.dvz;
                    dwx = _o487.dwx;
                    dwy = _o487.dwy;
                    dwz = _o487.dwz;
                }
                const kernel_ring_impact_out _o488 = kernel_ring_impact(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, its_0_ring_impact, its_1_ring_impact, p_inertia, p_tangential_restitution, p_restitution_speed);
                vx = _o488.vx;
                vy = _o488.vy;
                vz = _o488.vz;
                wx = _o488.wx;
                wy = _o488.wy;
                wz = _o488.wz;
            }
            if (BOUNDS) {
                if (touches) {
                    const kernel_estimated_after_contact_out _o489 = kernel_estimated_after_contact(vx, vy, vz, nx, ny, nz, position_bound, velocity_bound, spin_bound, estimated, p_ball_radius, p_gravity);
                    estimated = _o489.estimated;
                }
            }
            if (touches) {
                const kernel_touched_out _o490 = kernel_touched(which, body, first);
                first = _o490.first;
                last = _o490.last;
                const kernel_leaves_slowly_out _o491 = kernel_leaves_slowly(p_ball_radius, p_gravity, nx, ny, nz, vx, vy, vz, position_error);
                slow = _o491.slow;
                if (BOUNDS)
                    assured = _o491.assured;
            }
        }
        if (slow) {
            if (BOUNDS) {
                const kernel_estimates_out _o492 = kernel_estimates();
                estimated = _o492.estimated;
            }
            const kernel_ring_normal_out _o493 = kernel_ring_normal(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
            nx = _o493.nx;
            ny = _o493.ny;
            nz = _o493.nz;
            const kernel_here_out _o494 = kernel_here(1.0, which);
            here = _o494.here;
            if (here) {
                const kernel_backboard_normal_out _o495 = kernel_backboard_normal(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                nx = _o495.nx;
                ny = _o495.ny;
                nz = _o495.nz;
            }
            const kernel_here_out _o496 = kernel_here(2.0, which);
            here = _o496.here;
            if (here) {
                const kernel_bridge_normal_out _o497 = kernel_bridge_normal(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                nx = _o497.nx;
                ny = _o497.ny;
                nz = _o497.nz;
            }
            const kernel_off_at_start_out _o498 = kernel_off_at_start(mode);
            put_on = _o498.put_on;
            if (put_on) {
                const kernel_ring_distance_out _o499 = kernel_ring_distance(p_ball_radius, p_ring_radius, p_wire_radius, x, y, z);
                gap = _o499.gap;
                const kernel_here_out _o500 = kernel_here(1.0, which);
                here = _o500.here;
                if (here) {
                    const kernel_backboard_distance_out _o501 = kernel_backboard_distance(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z);
                    gap = _o501.gap;
                }
                const kernel_here_out _o502 = kernel_here(2.0, which);
                here = _o502.here;
                if (here) {
                    const kernel_bridge_distance_out _o503 = kernel_bridge_distance(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z);
                    gap = _o503.gap;
                }
                const kernel_placed_at_start_out _o504 = kernel_placed_at_start(x, y, z, nx, ny, nz, gap);
                x = _o504.x;
                y = _o504.y;
                z = _o504.z;
                if (BOUNDS) {
                    const kernel_start_errors_out _o505 = kernel_start_errors(p_ball_radius, x, y, z, dx, dy, dz);
                    dx = _o505.dx;
                    dy = _o505.dy;
                    dz = _o505.dz;
                }
                const kernel_ring_normal_out _o506 = kernel_ring_normal(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                nx = _o506.nx;
                ny = _o506.ny;
                nz = _o506.nz;
                const kernel_here_out _o507 = kernel_here(1.0, which);
                here = _o507.here;
                if (here) {
                    const kernel_backboard_normal_out _o508 = kernel_backboard_normal(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness);
                    nx = _o508.nx;
                    ny = _o508.ny;
                    nz = _o508.nz;
                }
                const kernel_here_out _o509 = kernel_here(2.0, which);
                here = _o509.here;
                if (here) {
                    const kernel_bridge_normal_out _o510 = kernel_bridge_normal(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth);
                    nx = _o510.nx;
                    ny = _o510.ny;
                    nz = _o510.nz;
                }
                if (BOUNDS) {
                    const kernel_undecided_at_start_out _o511 = kernel_undecided_at_start(p_ball_radius, x, y, z, nx, ny, nz, vx, vy, vz, wx, wy, wz, uncertain);
                    uncertain = _o511.uncertain;
                    const kernel_start_velocity_errors_out _o512 = kernel_start_velocity_errors(p_ball_radius, x, y, z, vx, vy, vz, wx, wy, wz, dvx, dvy, dvz);
                    dvx = _o512.dvx;
                    dvy = _o512.dvy;
                    dvz = _o512.dvz;
                }
                const kernel_velocity_at_start_out _o513 = kernel_velocity_at_start(p_ball_radius, x, y, z, nx, ny, nz, vx, vy, vz, wx, wy, wz);
                vx = _o513.vx;
                vy = _o513.vy;
                vz = _o513.vz;
            }
            const kernel_nearly_out _o514 = kernel_nearly(p_ball_radius, p_gravity, nx, ny, nz, vx, vy, vz);
            nearly = _o514.nearly;
            const kernel_gripped_out _o515 = kernel_gripped(p_ball_radius, p_inertia, nx, ny, nz, vx, vy, vz, wx, wy, wz);
            rolled_x = _o515.rolled_x;
            rolled_y = _o515.rolled_y;
            rolled_z = _o515.rolled_z;
            slip = _o515.slip;
            bounce = _o515.bounce;
            if (BOUNDS) {
                const kernel_error_bounds_out _o516 = kernel_error_bounds(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, position_bound, velocity_bound, spin_bound, estimated, clock_bound);
                position_error = _o516.position_error;
                velocity_error = _o516.velocity_error;
            }
            const kernel_ring_rolling_surface_out _o517 = kernel_ring_rolling_surface(p_ball_radius, p_wire_radius);
            per_reach = _o517.per_reach;
            const kernel_ring_turning_out _o518 = kernel_ring_turning(p_ball_radius, p_ring_radius, p_wire_radius, x, y, rolled_x, rolled_y, rolled_z);
            turning_x = _o518.turning_x;
            turning_y = _o518.turning_y;
            turning_z = _o518.turning_z;
            const kernel_ring_separation_out _o519 = kernel_ring_separation(p_gravity, p_ring_radius, x, y, z, vx, vy, vz);
            lift = _o519.lift;
            gap_jerk = _o519.gap_jerk;
            const kernel_here_out _o520 = kernel_here(1.0, which);
            here = _o520.here;
            if (here) {
                const kernel_backboard_rolling_surface_out _o521 = kernel_backboard_rolling_surface(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z, vx, vy, vz);
                per_reach = _o521.per_reach;
                const kernel_backboard_turning_out _o522 = kernel_backboard_turning(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z, rolled_x, rolled_y, rolled_z);
                turning_x = _o522.turning_x;
                turning_y = _o522.turning_y;
                turning_z = _o522.turning_z;
                const kernel_backboard_separation_out _o523 = kernel_backboard_separation(p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, p_gravity, x, y, z, vx, vy, vz);
                lift = _o523.lift;
                gap_jerk = _o523.gap_jerk;
            }
            const kernel_here_out _o524 = kernel_here(2.0, which);
            here = _o524.here;
            if (here) {
                const kernel_bridge_rolling_surface_out _o525 = kernel_bridge_rolling_surface(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z, vx, vy, vz);
                per_reach = _o525.per_reach;
                const kernel_bridge_turning_out _o526 = kernel_bridge_turning(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z, rolled_x, rolled_y, rolled_z);
                turning_x = _o526.turning_x;
                turning_y = _o526.turning_y;
                turning_z = _o526.turning_z;
                const kernel_bridge_separation_out _o527 = kernel_bridge_separation(p_board_distance, p_bridge_depth, p_bridge_half_width, p_gravity, p_ring_radius, p_wire_radius, x, y, z, vx, vy, vz);
                lift = _o527.lift;
                gap_jerk = _o527.gap_jerk;
            }
            const kernel_pressed_on_out _o528 = kernel_pressed_on(p_ball_radius, p_gravity, p_inertia, nx, ny, nz, wx, wy, wz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z);
            press = _o528.press;
            weight = _o528.weight;
            rolling_friction = _o528.rolling_friction;
            rolling_acceleration_x = _o528.rolling_acceleration_x;
            rolling_acceleration_y = _o528.rolling_acceleration_y;
            rolling_acceleration_z = _o528.rolling_acceleration_z;
            const kernel_isolated_out _o529 = kernel_isolated();
            nearest = _o529.nearest;
            second_contact_gap = _o529.second_contact_gap;
            const kernel_other_surface_out _o530 = kernel_other_surface(0.0, which);
            beside = _o530.beside;
            if (beside) {
                const kernel_ring_closing_out _o531 = kernel_ring_closing(p_ball_radius, p_ring_radius, p_wire_radius, x, y, z, nx, ny, nz, rolled_x, rolled_y, rolled_z, rolling_acceleration_x, rolling_acceleration_y, rolling_acceleration_z);
                gap = _o531.gap;
                nearing = _o531.nearing;
                rolling_gap_acceleration = _o531.rolling_gap_acceleration;
                normal_cosine = _o531.normal_cosine;
                const kernel_near_body_out _o532 = kernel_near_body(gap, nearest, second_contact_gap, rolling_gap_acceleration, normal_cosine, press, nearing);
                nearest = _o532.nearest;
                second_contact_gap = _o532.second_contact_gap;
            }
            const kernel_other_surface_out _o533 = kernel_other_surface(1.0, which);
            beside = _o533.beside;
            if (beside) {
                const kernel_backboard_closing_out _o534 = kernel_backboard_closing(p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness, p_board_top, x, y, z, nx, ny, nz, rolled_x, rolled_y, rolled_z, rolling_acceleration_x, rolling_acceleration_y, rolling_acceleration_z);
                gap = _o534.gap;
                nearing = _o534.nearing;
                rolling_gap_acceleration = _o534.rolling_gap_acceleration;
                normal_cosine = _o534.normal_cosine;
                const kernel_near_body_out _o535 = kernel_near_body(gap, nearest, second_contact_gap, rolling_gap_acceleration, normal_cosine, press, nearing);
                nearest = _o535.nearest;
                second_contact_gap = _o535.second_contact_gap;
            }
            if (BOUNDS) {
                const kernel_here_out _o536 = kernel_here(1.0, which);
                here = _o536.here;
                if (here) {
                    const kernel_backboard_seam0_out _o537 = kernel_backboard_seam0(p_ball_radius, p_board_distance, p_board_thickness, x, vx);
                    gap = _o537.gap;
                    const kernel_seam_undecided_out _o538 = kernel_seam_undecided(p_ball_radius, x, y, z, gap, position_error, uncertain, nearly);
                    uncertain = _o538.uncertain;
                    const kernel_backboard_seam1_out _o539 = kernel_backboard_seam1(p_ball_radius, p_board_distance, p_board_thickness, x, vx);
                    gap = _o539.gap;
                    const kernel_seam_undecided_out _o540 = kernel_seam_undecided(p_ball_radius, x, y, z, gap, position_error, uncertain, nearly);
                    uncertain = _o540.uncertain;
                    const kernel_backboard_seam2_out _o541 = kernel_backboard_seam2(p_ball_radius, p_board_half_width, y, vy);
                    gap = _o541.gap;
                    const kernel_seam_undecided_out _o542 = kernel_seam_undecided(p_ball_radius, x, y, z, gap, position_error, uncertain, nearly);
                    uncertain = _o542.uncertain;
                    const kernel_backboard_seam3_out _o543 = kernel_backboard_seam3(p_ball_radius, p_board_half_width, y, vy);
                    gap = _o543.gap;
                    const kernel_seam_undecided_out _o544 = kernel_seam_undecided(p_ball_radius, x, y, z, gap, position_error, uncertain, nearly);
                    uncertain = _o544.uncertain;
                    const kernel_backboard_seam4_out _o545 = kernel_backboard_seam4(p_ball_radius, p_board_bottom, p_board_top, z, vz);
                    gap = _o545.gap;
                    const kernel_seam_undecided_out _o546 = kernel_seam_undecided(p_ball_radius, x, y, z, gap, position_error, uncertain, nearly);
                    uncertain = _o546.uncertain;
                    const kernel_backboard_seam5_out _o547 = kernel_backboard_seam5(p_ball_radius, p_board_bottom, p_board_top, z, vz);
                    gap = _o547.gap;
                    const kernel_seam_undecided_out _o548 = kernel_seam_undecided(p_ball_radius, x, y, z, gap, position_error, uncertain, nearly);
                    uncertain = _o548.uncertain;
                }
            }
            const kernel_other_surface_out _o549 = kernel_other_surface(2.0, which);
            beside = _o549.beside;
            if (beside) {
                const kernel_bridge_closing_out _o550 = kernel_bridge_closing(p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width, p_ring_radius, p_wire_radius, x, y, z, nx, ny, nz, rolled_x, rolled_y, rolled_z, rolling_acceleration_x, rolling_acceleration_y, rolling_acceleration_z);
                gap = _o550.gap;
                nearing = _o550.nearing;
                rolling_gap_acceleration = _o550.rolling_gap_acceleration;
                normal_cosine = _o550.normal_cosine;
                const kernel_near_body_out _o551 = kernel_near_body(gap, nearest, second_contact_gap, rolling_gap_acceleration, normal_cosine, press, nearing);
                nearest = _o551.nearest;
                second_contact_gap = _o551.second_contact_gap;
            }
            if (BOUNDS) {
                const kernel_here_out _o552 = kernel_here(2.0, which);
                here = _o552.here;
                if (here) {
                    const kernel_bridge_seam0_out _o553 = kernel_bridge_seam0(p_ball_radius, p_board_distance, p_ring_radius, x, vx);
                    gap = _o553.gap;
                    const kernel_seam_undecided_out _o554 = kernel_seam_undecided(p_ball_radius, x, y, z, gap, position_error, uncertain, nearly);
                    uncertain = _o554.uncertain;
                    const kernel_bridge_seam1_out _o555 = kernel_bridge_seam1(p_ball_radius, p_board_distance, p_ring_radius, x, vx);
                    gap = _o555.gap;
                    const kernel_seam_undecided_out _o556 = kernel_seam_undecided(p_ball_radius, x, y, z, gap, position_error, uncertain, nearly);
                    uncertain = _o556.uncertain;
                    const kernel_bridge_seam2_out _o557 = kernel_bridge_seam2(p_ball_radius, p_bridge_half_width, y, vy);
                    gap = _o557.gap;
                    const kernel_seam_undecided_out _o558 = kernel_seam_undecided(p_ball_radius, x, y, z, gap, position_error, uncertain, nearly);
                    uncertain = _o558.uncertain;
                    const kernel_bridge_seam3_out _o559 = kernel_bridge_seam3(p_ball_radius, p_bridge_half_width, y, vy);
                    gap = _o559.gap;
                    const kernel_seam_undecided_out _o560 = kernel_seam_undecided(p_ball_radius, x, y, z, gap, position_error, uncertain, nearly);
                    uncertain = _o560.uncertain;
                    const kernel_bridge_seam4_out _o561 = kernel_bridge_seam4(p_ball_radius, p_bridge_depth, p_wire_radius, z, vz);
                    gap = _o561.gap;
                    const kernel_seam_undecided_out _o562 = kernel_seam_undecided(p_ball_radius, x, y, z, gap, position_error, uncertain, nearly);
                    uncertain = _o562.uncertain;
                    const kernel_bridge_seam5_out _o563 = kernel_bridge_seam5(p_ball_radius, p_bridge_depth, p_wire_radius, z, vz);
                    gap = _o563.gap;
                    const kernel_seam_undecided_out _o564 = kernel_seam_undecided(p_ball_radius, x, y, z, gap, position_error, uncertain, nearly);
                    uncertain = _o564.uncertain;
                }
            }
            const kernel_end_beside_out _o565 = kernel_end_beside(p_end_depth, z, vz);
            gap = _o565.gap;
            const kernel_near_end_plane_out _o566 = kernel_near_end_plane(gap, nearest);
            nearest = _o566.nearest;
            const kernel_other_kind_out _o567 = kernel_other_kind();
            struck_0 = _o567.of_this_kind;
            const kernel_ring_impact_taken_out _o568 = kernel_ring_impact_taken(p_ring_restitution, p_ring_friction);
            its_0_ring_impact = _o568.its_0;
            its_1_ring_impact = _o568.its_1;
            for (size_t _row = 0; _row < 3; _row++) {
                const double own_1 = parameter(_given, table_2[_row][0]);
                const double own_2 = parameter(_given, table_2[_row][1]);
                const double own_index = table_3[_row][0];
                const kernel_here_out _o569 = kernel_here(own_index, which);
                here = _o569.here;
                if (here) {
                    const kernel_ring_impact_taken_out _o570 = kernel_ring_impact_taken(own_2, own_1);
                    struck_0 = _o570.of_this_kind;
                    its_0_ring_impact = _o570.its_0;
                    its_1_ring_impact = _o570.its_1;
                }
            }
            if (struck_0) {
                const kernel_ring_impact_settling_out _o571 = kernel_ring_impact_settling(p_ball_radius, p_gravity, p_inertia, its_1_ring_impact, its_0_ring_impact, x, y, z, nx, ny, nz, vx, vy, vz, wx, wy, wz, position_error, velocity_error, mode, per_reach, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, slip, bounce, nearest, second_contact_gap, press, weight, rolling_friction, lift, gap_jerk);
                settles = _o571.settles;
                lodges = _o571.lodges;
                slides = _o571.slides;
                unpressed = _o571.unpressed;
                undecided = _o571.undecided;
                if (BOUNDS)
                    assured = _o571.assured;
                const kernel_settled_out _o572 = kernel_settled(which, position_error, velocity_error, outcome, uncertain, undecided, mode, settles, nearly, lodges, slides, unpressed);
                mode = _o572.mode;
                held = _o572.held;
                outcome = _o572.outcome;
                slip_left = _o572.slip_left;
                if (BOUNDS)
                    uncertain = _o572.uncertain;
            }
        }
        if (BOUNDS) {
            if (limited) {
                const kernel_ends_by_time_limit_out _o573 = kernel_ends_by_time_limit(4.0, which, claims);
                ends_by_time_limit = _o573.ends_by_time_limit;
                if (ends_by_time_limit) {
                    const kernel_carry_time_out _o574 = kernel_carry_time(when, x, y, z, vx, vy, vz, clock, clock_error, dx, dy, dz, dvx, dvy, dvz, p_gravity);
                    dx = _o574.dx;
                    dy = _o574.dy;
                    dz = _o574.dz;
                    dvx = _o574.dvx;
                    dvy = _o574.dvy;
                    dvz = _o574.dvz;
                    clock_error = _o574.clock_error;
                    const kernel_bound_time_out _o575 = kernel_bound_time(when, x, y, z, vx, vy, vz, clock, position_bound, velocity_bound, spin_bound, clock_bound, p_gravity);
                    position_bound = _o575.position_bound;
                    velocity_bound = _o575.velocity_bound;
                    spin_bound = _o575.spin_bound;
                    clock_bound = _o575.clock_bound;
                }
            }
            if (hopped) {
                const kernel_carry_hop_out _o576 = kernel_carry_hop(x, y, z, vx, vy, vz, dx, dy, dz, dvx, dvy, dvz, when);
                dx = _o576.dx;
                dy = _o576.dy;
                dz = _o576.dz;
            }
            const kernel_closing_out _o577 = kernel_closing(outcome, claims);
            reports = _o577.reports;
            position_claim = _o577.position_claim;
            velocity_claim = _o577.velocity_claim;
            spin_claim = _o577.spin_claim;
            time_claim = _o577.time_claim;
            if (reports) {
                const kernel_claimed_errors_out _o578 = kernel_claimed_errors(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, position_bound, velocity_bound, spin_bound, estimated, clock_bound);
                position_claim = _o578.position_error;
                velocity_claim = _o578.velocity_error;
                spin_claim = _o578.spin_error;
                time_claim = _o578.time_error;
            }
        }

        if (_events && body >= 0.0) {
            if (_errors) {
                _errors[_used].time_error = time_claim;
                _errors[_used].state_error[0] = position_claim;
                _errors[_used].state_error[1] = velocity_claim;
                _errors[_used].state_error[2] = spin_claim;
            }
            court_event *const _event = _events + _used++;
            const long long _place = (long long)body, _staying = _place - 4;
            _event->shot = _first + _shot;
            _event->surface = _staying < 0 ? _place : _staying / 2;
            _event->kind = _staying < -1 ? COURT_EVENT_IMPACT : _staying < 0 ? COURT_EVENT_END : _staying % 2 ? COURT_EVENT_LEAVE : COURT_EVENT_ROLL;
            _event->time = clock;
            for (int _k = 0; _k < 9; _k++)
                _event->before[_k] = _before[_k];
            _event->after[0] = x;
            _event->after[1] = y;
            _event->after[2] = z;
            _event->after[3] = vx;
            _event->after[4] = vy;
            _event->after[5] = vz;
            _event->after[6] = wx;
            _event->after[7] = wy;
            _event->after[8] = wz;
        }
    }

    if (_events)
        ((int *)_results[14])[_shot] = _used;
    const bool _invalid = (int)outcome == COURT_OUTCOME_INVALID;
    (void)_invalid;
    if (_results[0]) {
        ((unsigned char *)_results[0])[_shot] = (unsigned char)(int)outcome;
    }
    if (_results[1]) {
        ((int *)_results[1])[_shot] = (int)contacts;
    }
    if (_results[2]) {
        ((int *)_results[2])[3 * _shot + 0] = (int)count_0;
        ((int *)_results[2])[3 * _shot + 1] = (int)count_1;
        ((int *)_results[2])[3 * _shot + 2] = (int)count_2;
    }
    if (_results[3]) {
        ((signed char *)_results[3])[_shot] = (signed char)(int)first;
    }
    if (_results[4]) {
        ((double *)_results[4])[_shot] = _invalid ? NOT_A_NUMBER : clock;
    }
    if (_results[5]) {
        ((double *)_results[5])[9 * _shot + 0] = _invalid ? NOT_A_NUMBER : x;
        ((double *)_results[5])[9 * _shot + 1] = _invalid ? NOT_A_NUMBER : y;
        ((double *)_results[5])[9 * _shot + 2] = _invalid ? NOT_A_NUMBER : z;
        ((double *)_results[5])[9 * _shot + 3] = _invalid ? NOT_A_NUMBER : vx;
        ((double *)_results[5])[9 * _shot + 4] = _invalid ? NOT_A_NUMBER : vy;
        ((double *)_results[5])[9 * _shot + 5] = _invalid ? NOT_A_NUMBER : vz;
        ((double *)_results[5])[9 * _shot + 6] = _invalid ? NOT_A_NUMBER : wx;
        ((double *)_results[5])[9 * _shot + 7] = _invalid ? NOT_A_NUMBER : wy;
        ((double *)_results[5])[9 * _shot + 8] = _invalid ? NOT_A_NUMBER : wz;
    }
    if (_results[6]) {
        ((int *)_results[6])[_shot] = (int)rolls;
    }
    if (_results[7]) {
        ((unsigned char *)_results[7])[_shot] = (unsigned char)(int)slip_left;
    }
    if (BOUNDS && _results[8]) {
        ((double *)_results[8])[_shot] = _invalid ? NOT_A_NUMBER : grip_lost;
    }
    if (BOUNDS && _results[9]) {
        ((double *)_results[9])[_shot] = _invalid ? NOT_A_NUMBER : time_claim;
    }
    if (BOUNDS && _results[10]) {
        ((double *)_results[10])[3 * _shot + 0] = _invalid ? NOT_A_NUMBER : position_claim;
        ((double *)_results[10])[3 * _shot + 1] = _invalid ? NOT_A_NUMBER : velocity_claim;
        ((double *)_results[10])[3 * _shot + 2] = _invalid ? NOT_A_NUMBER : spin_claim;
    }
    if (BOUNDS && _results[11]) {
        ((unsigned char *)_results[11])[_shot] = (unsigned char)(int)uncertain;
    }
    if (BOUNDS && _results[12]) {
        ((unsigned char *)_results[12])[_shot] = (unsigned char)(int)estimated;
    }
}

#if VARIANT != 1
/* The path alone. */
extern "C" __global__ void court_plain(
    long long _shots, long long _first, const double *_states, const double *const *_values,
    const long long *_strides, const signed char *_leaving, int _max_contacts, double time_limit,
    void *const *_results)
{
    court_loop<false>(
        _shots, _first, _states, _values, _strides, _leaving, _max_contacts, time_limit, _results);
}
#endif

#if VARIANT != 0
/* With bounds on errors. */
extern "C" __global__ void court_bounded(
    long long _shots, long long _first, const double *_states, const double *const *_values,
    const long long *_strides, const signed char *_leaving, int _max_contacts, double time_limit,
    void *const *_results)
{
    court_loop<true>(
        _shots, _first, _states, _values, _strides, _leaving, _max_contacts, time_limit, _results);
}
#endif
