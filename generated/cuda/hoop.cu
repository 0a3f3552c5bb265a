/* The event loop of the scene hoop in CUDA: a thread takes one shot from its release to its end.

   Generated from templates/cuda/scene.cu.j2, scene hoop, derivation d045c64f80c6d78c,
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
    HOOP_OUTCOME_MADE = 0, /* Crossed the end plane downwards inside the target. */
    HOOP_OUTCOME_MISSED = 1, /* Crossed it outside. */
    HOOP_OUTCOME_CAPPED = 2, /* Had max_contacts contacts before it ended. */
    HOOP_OUTCOME_SHORT = 3, /* Can never reach an end. */
    HOOP_OUTCOME_INVALID = 4, /* Not finite, not allowed, a size out of range, or a start inside a surface. */
    HOOP_OUTCOME_LODGED = 5, /* At rest, or wedged between bodies. */
    HOOP_OUTCOME_ENDLESS = 6 /* Still moving at the time limit. */
};

/* What a row of the event log is. */
enum {
    HOOP_EVENT_IMPACT = 0, /* The ball meets a body. */
    HOOP_EVENT_ROLL = 1, /* Its bounces have accumulated: it stays in contact with the body. */
    HOOP_EVENT_LEAVE = 2, /* That contact ends. */
    HOOP_EVENT_END = 3 /* The shot ends. */
};

/* A row of the event log. */
struct hoop_event {
    long long shot, surface;
    double time, before[9], after[9];
    long long kind;
};

/* Bounds on the errors of such a row. */
struct hoop_event_errors {
    double time_error;
    double state_error[3];
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
   running error analysis. 25 operations: 15 additions, 8 multiplications, 2 absolute values. */
struct kernel_displacement_out {
    double margin;
};

static __device__ __forceinline__ kernel_displacement_out kernel_displacement(double delay, double horizon, double extent, double speed, double position_error, double velocity_error, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_board_distance, double p_board_half_width, double p_board_bottom, double p_board_top, double p_bridge_half_width, double p_gravity, double p_end_depth)
{
    const double _s0 = speed + (p_gravity * horizon);
    const double _s1 = extent + (horizon * _s0);
    const double _s2 = (((((p_ball_radius + p_ring_radius) + p_wire_radius) + p_board_distance) + p_board_half_width) + p_bridge_half_width) + p_end_depth;
    const double _s3 = ((1.0009765625 * delay) * _s0) + (4.445228907190568e-16 * (_s1 + ((_s2 + fabs(p_board_bottom)) + fabs(p_board_top))));
    return {_s3 + (3.0029296875 * ((position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * _s1)))};
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
struct kernel_carry_end_out {
    float position_bound, velocity_bound, spin_bound, delay;
};

static __device__ __forceinline__ kernel_carry_end_out kernel_carry_end(float t, float x, float y, float z, float vx, float vy, float vz, float clock, float position_bound, float velocity_bound, float spin_bound, float root_offset, float normal_velocity, float p_gravity)
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

/* Whether a bound on an error is not finite.
   comparison. 8 operations: 4 comparisons, 3 conjunctions, 1 complement. */
struct kernel_unbounded_out {
    bool unbounded;
};

static __device__ __forceinline__ kernel_unbounded_out kernel_unbounded(float clock_error, float position_bound, float velocity_bound, float spin_bound)
{
    return {!((((position_bound < ((float)INFINITE)) && (velocity_bound < ((float)INFINITE))) && (spin_bound < ((float)INFINITE))) && (clock_error < ((float)INFINITE)))};
}

/* Bounds on the errors at the time limit.
   Eq. 3, with roundings. 51 operations: 24 additions, 20 multiplications, 7 absolute values. */
struct kernel_carry_time_out {
    float position_bound, velocity_bound, spin_bound, clock_error;
};

static __device__ __forceinline__ kernel_carry_time_out kernel_carry_time(float t, float x, float y, float z, float vx, float vy, float vz, float clock, float clock_error, float position_bound, float velocity_bound, float spin_bound, float p_gravity)
{
    const float _s0 = clock_error + (((float)4.440892098500626e-16) * (t + clock));
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

/* Bounds on the errors of state and time that decisions use.
   the carried bounds. No operations. */
struct kernel_error_bounds_out {
    float position_error, velocity_error, spin_error, time_error;
};

static __device__ __forceinline__ kernel_error_bounds_out kernel_error_bounds(float clock_error, float position_bound, float velocity_bound, float spin_bound)
{
    return {position_bound, velocity_bound, spin_bound, clock_error};
}

/* Bounds on the errors of state and time that are reported.
   the carried bounds. No operations. */
struct kernel_claimed_errors_out {
    float position_error, velocity_error, spin_error, time_error;
};

static __device__ __forceinline__ kernel_claimed_errors_out kernel_claimed_errors(float clock_error, float position_bound, float velocity_bound, float spin_bound)
{
    return {position_bound, velocity_bound, spin_bound, clock_error};
}

/* 1 if finite parameters are allowed.
   the scene's requirements. 24 operations: 2 subtractions, 11 comparisons, 11 selections. */
struct kernel_allowed_out {
    double allowed;
};

static __device__ __forceinline__ kernel_allowed_out kernel_allowed(const shot_parameters &_given)
{
    double _v0 = choose((0.0 < ((parameter(_given, 1) - parameter(_given, 0)) - parameter(_given, 2))), 1.0, 0.0);
    static const int _t0[][1] = {
        {0},
        {1},
        {2},
        {3},
        {4},
        {7},
    };
    for (size_t _k0 = 0; _k0 < 6; _k0++) {
        _v0 = choose((0.0 < parameter(_given, _t0[_k0][0])), _v0, 0.0);
    }
    const double _s3 = choose((0.0 <= parameter(_given, 8)), _v0, 0.0);
    return {choose((0.0 < parameter(_given, 10)), choose((0.0 < parameter(_given, 9)), choose((parameter(_given, 8) <= 1.0), _s3, 0.0), 0.0), 0.0)};
}

/* Whether the parameters are allowed, and no arithmetic with them over- or underflows.
   the range of numbers. 38 operations: 11 absolute values, 14 comparisons, 13 conjunctions. */
struct kernel_parameters_in_range_out {
    bool permitted;
};

static __device__ __forceinline__ kernel_parameters_in_range_out kernel_parameters_in_range(const shot_parameters &_given, double allowed)
{
    const double _s0 = fabs(parameter(_given, 0));
    bool _v1 = ((0.0 < allowed) && (_s0 <= 1073741824.0)) && (9.313225746154785e-10 <= _s0);
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
        _v1 = _v1 && (fabs(parameter(_given, _t1[_k1][0])) <= 1073741824.0);
    }
    const double _s4 = fabs(parameter(_given, 9));
    const bool _s5 = (((_v1 && (fabs(parameter(_given, 8)) <= 1.2676506002282294e+30)) && (_s4 <= 1073741824.0)) && (9.313225746154785e-10 <= _s4)) && (fabs(parameter(_given, 10)) <= 1073741824.0);
    return {_s5};
}

/* 1 if the ball overlaps no surface; 1 if that is undecided.
   Table 2. 129 operations: 18 additions, 19 subtractions, 11 multiplications, 2 square roots, 3 negations, 21 absolute values, 26 comparisons, 29 selections. */
struct kernel_valid_out {
    double valid, undecided_time;
};

static __device__ __forceinline__ kernel_valid_out kernel_valid(double last, double x, double y, double z, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_board_distance, double p_board_half_width, double p_board_bottom, double p_board_top, double p_bridge_half_width, double p_end_depth)
{
    const double _s0 = sqrt(((x * x) + (y * y)));
    const double _s1 = _s0 - p_ring_radius;
    const double _s2 = (z * z) + (_s1 * _s1);
    const double _s3 = p_ball_radius + p_wire_radius;
    const double _s4 = _s2 - (_s3 * _s3);
    const bool _s5 = fabs(last) < 0.5;
    const double _s6 = choose(_s5, 1.0, choose((0.0 <= _s4), 1.0, 0.0));
    const double _s7 = p_ball_radius - p_board_distance;
    const double _s8 = x - _s7;
    const double _s9 = 2.0 * p_ball_radius;
    const double _s10 = (_s7 - _s9) - x;
    const double _s11 = larger(_s8, _s10);
    const double _s12 = -(p_board_half_width + y);
    const double _s13 = larger(_s11, _s12);
    const double _s14 = y - p_board_half_width;
    const double _s15 = larger(_s13, _s14);
    const double _s16 = p_board_bottom - z;
    const double _s17 = larger(_s15, _s16);
    const double _s18 = z - p_board_top;
    const double _s19 = larger(_s17, _s18);
    const bool _s20 = fabs((last - 1.0)) < 0.5;
    const double _s21 = choose(_s20, _s6, choose((0.0 <= _s19), _s6, 0.0));
    const double _s22 = z - _s3;
    const double _s23 = ((_s3 - _s9) - (2.0 * p_wire_radius)) - z;
    const double _s24 = larger(_s22, _s23);
    const double _s25 = -(p_bridge_half_width + y);
    const double _s26 = larger(_s24, _s25);
    const double _s27 = y - p_bridge_half_width;
    const double _s28 = larger(_s26, _s27);
    const double _s29 = p_ring_radius - _s0;
    const double _s30 = larger(_s28, _s29);
    const double _s31 = larger(_s30, x);
    const double _s32 = -(p_board_distance + x);
    const double _s33 = larger(_s31, _s32);
    const bool _s34 = fabs((last - 2.0)) < 0.5;
    const double _s35 = ((((fabs(p_board_bottom) + fabs(p_board_top)) + fabs(p_ball_radius)) + fabs(p_ring_radius)) + fabs(p_wire_radius)) + fabs(p_board_distance);
    const double _s36 = ((((_s35 + fabs(p_board_half_width)) + fabs(p_bridge_half_width)) + fabs(p_end_depth)) + fabs(x)) + fabs(y);
    const double _s37 = 1.7763568394002505e-15 * (_s36 + fabs(z));
    const double _s38 = ((4.0 * p_ball_radius) + (4.0 * p_wire_radius)) * _s37;
    const double _s39 = choose((fabs(((sqrt(_s2) - p_ball_radius) - p_wire_radius)) <= _s37), choose((_s4 <= _s38), 0.0, 1.0), 1.0);
    const double _s40 = choose(_s5, _s39, choose((fabs(_s4) <= _s38), 1.0, 0.0));
    const double _s41 = choose(_s20, choose((fabs(_s8) <= _s37), choose((_s19 <= _s37), _s40, 1.0), 1.0), choose((fabs(_s19) <= _s37), 1.0, _s40));
    return {choose(_s34, _s21, choose((0.0 <= _s33), _s21, 0.0)), choose(_s34, choose((fabs(_s22) <= _s37), choose((_s33 <= _s37), _s41, 1.0), 1.0), choose((fabs(_s33) <= _s37), 1.0, _s41))};
}

/* Whether the ball starts near a surface; otherwise its start is valid and decided.
   Table 2. 45 operations: 14 additions, 5 subtractions, 3 multiplications, 1 negation, 12 absolute values, 5 comparisons, 2 conjunctions, 2 disjunctions, 1 complement. */
struct kernel_aside_out {
    bool close;
    double valid, undecided_time;
};

static __device__ __forceinline__ kernel_aside_out kernel_aside(double x, double y, double z, double p_ball_radius, double p_ring_radius, double p_wire_radius, double p_board_distance, double p_board_half_width, double p_board_bottom, double p_board_top, double p_bridge_half_width, double p_end_depth)
{
    const double _s0 = ((((fabs(p_board_bottom) + fabs(p_board_top)) + fabs(p_ball_radius)) + fabs(p_ring_radius)) + fabs(p_wire_radius)) + fabs(p_board_distance);
    const double _s1 = fabs(x);
    const double _s2 = ((((_s0 + fabs(p_board_half_width)) + fabs(p_bridge_half_width)) + fabs(p_end_depth)) + _s1) + fabs(y);
    const double _s3 = 8.0 * (1.7763568394002505e-15 * (_s2 + fabs(z)));
    const double _s4 = p_ball_radius - p_board_distance;
    const bool _s5 = (_s3 < (_s1 - ((p_ball_radius + p_ring_radius) + p_wire_radius))) && ((_s3 < (x - _s4)) || (_s3 < ((_s4 - (2.0 * p_ball_radius)) - x)));
    const bool _s6 = !(_s5 && ((_s3 < x) || (_s3 < (-(p_board_distance + x)))));
    return {_s6, 1.0, 0.0};
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

/* Whether the ball has touched nothing yet.
   Table 1. 2 operations: 1 comparison, 1 complement. */
struct kernel_released_out {
    bool released, reachable;
};

static __device__ __forceinline__ kernel_released_out kernel_released(double last)
{
    const bool _s0 = last < 0.0;
    return {_s0, !_s0};
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

/* Whether a plane's only root is an arrival, the size of F'', and the nearest time.
   Table 1. 17 operations: 1 absolute value, 8 comparisons, 4 conjunctions, 1 disjunction, 3 selections. */
struct kernel_level_root_out {
    bool arrives;
    double ceiling, nearest;
};

static __device__ __forceinline__ kernel_level_root_out kernel_level_root(double rate, double bend, double height, double time, double when)
{
    const bool _s0 = (((rate < 0.0) || (((rate <= 0.0) && (bend < 0.0)) && (time == 0.0))) && (0.0 <= time)) && (time < (INFINITE));
    const double _s1 = choose(_s0, time, choose((height < 0.0), 0.0, (INFINITE)));
    return {_s0, fabs(bend), smaller(when, _s1)};
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

/* Undecided time 0 if the gap of a plane is zero within its error, and falls.
   Table 1. 7 operations: 2 multiplications, 1 absolute value, 2 comparisons, 1 conjunction, 1 selection. */
struct kernel_side_undecided_out {
    double undecided_time;
};

static __device__ __forceinline__ kernel_side_undecided_out kernel_side_undecided(double rate, double margin, double height, double undecided_time, double velocity_error)
{
    return {choose(((rate < (2.0 * velocity_error)) && (fabs(height) <= (2.0 * margin))), 0.0, undecided_time)};
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

/* Earliest undecided time, with that from which on a contact near an edge may be.
   Table 1. 4 operations: 1 multiplication, 1 comparison, 1 conjunction, 1 selection. */
struct kernel_bounds_undecided_out {
    double undecided_time;
};

static __device__ __forceinline__ kernel_bounds_undecided_out kernel_bounds_undecided(double time, double undecided_time, bool undecided)
{
    const double _s0 = 0.5 * time;
    return {choose((undecided && (_s0 < undecided_time)), _s0, undecided_time)};
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

/* Whether the flight may hit a surface.
   Table 1. 2 operations: 1 comparison, 1 complement. */
struct kernel_opens_out {
    bool open;
};

static __device__ __forceinline__ kernel_opens_out kernel_opens(double clear)
{
    return {!(0.0 < clear)};
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

/* A certain root, refined, and whether h is above 2^-24, so that it is refined again.
   Table 1. 7 operations: 3 multiplications, 1 absolute value, 1 comparison, 1 conjunction, 1 selection. */
struct kernel_refined_root_out {
    double arrival;
    bool refining;
};

static __device__ __forceinline__ kernel_refined_root_out kernel_refined_root(double gap, double rate, double ceiling, double arrival, double refined, bool certain)
{
    return {choose(certain, refined, arrival), certain && ((5.960464477539063e-08 * (rate * rate)) < (ceiling * fabs(gap)))};
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

/* Delay of a certain arrival; the earliest undecided time, with that of any other one.
   Table 1. 10 operations: 1 subtraction, 2 comparisons, 3 conjunctions, 1 complement, 3 selections. */
struct kernel_arrival_certainty_out {
    double delay, undecided_time;
};

static __device__ __forceinline__ kernel_arrival_certainty_out kernel_arrival_certainty(double clearance, double time, double delay, double undecided_time, bool arrives, bool certain)
{
    const bool _s0 = certain && (0.0 < clearance);
    const double _s1 = choose(certain, (time - delay), time);
    return {choose(_s0, delay, 0.0), choose(((arrives && (!_s0)) && (_s1 < undecided_time)), _s1, undecided_time)};
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

/* 1 if a decision up to this event, or the choice of the end, lies within its error.
   Table 1. 7 operations: 1 addition, 2 comparisons, 1 conjunction, 1 disjunction, 1 complement, 1 selection. */
struct kernel_flight_undecided_out {
    double uncertain;
};

static __device__ __forceinline__ kernel_flight_undecided_out kernel_flight_undecided(double when, double earliest_delay, double undecided_time, double uncertain, bool edge)
{
    const double _s0 = choose((((!((when + earliest_delay) < undecided_time)) && (undecided_time < (INFINITE))) || edge), 1.0, uncertain);
    return {_s0};
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

/* 1 if a bound on an error is not finite.
   Table 1. 1 operation: 1 selection. */
struct kernel_without_bounds_out {
    double uncertain;
};

static __device__ __forceinline__ kernel_without_bounds_out kernel_without_bounds(bool unbounded, double uncertain)
{
    return {choose(unbounded, 1.0, uncertain)};
}

/* How the bounds on errors are carried over a contact.
   Table 1. 4 operations: 2 comparisons, 2 conjunctions. */
struct kernel_tightens_out {
    bool carries, tightens;
};

static __device__ __forceinline__ kernel_tightens_out kernel_tightens(double tightening, bool touches)
{
    return {touches && (tightening <= 0.0), touches && (0.0 < tightening)};
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

/* Whether a shot that has ended may be certain with tighter bounds: it is not capped.
   Table 1. 6 operations: 3 comparisons, 2 conjunctions, 1 complement. */
struct kernel_loose_out {
    bool loose;
};

static __device__ __forceinline__ kernel_loose_out kernel_loose(double contacts, double outcome, double uncertain)
{
    return {((0.0 < uncertain) && (0.0 < contacts)) && (!(outcome == 2.0))};
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
    float clock_error;
};

static __device__ __forceinline__ kernel_clock_error_sum_out kernel_clock_error_sum(float delay, float clock_error)
{
    return {delay + clock_error};
}

/* Whether bounds on errors are wanted here, and their start values.
   Table 1. 5 operations: 3 comparisons, 1 conjunction, 1 disjunction. */
struct kernel_closing_out {
    bool reports;
    float position_claim, velocity_claim, spin_claim, time_claim;
};

static __device__ __forceinline__ kernel_closing_out kernel_closing(float outcome, float claims)
{
    return {((((float)0.0) < claims) && (((float)0.0) <= outcome)) || (((float)1.0) < claims), (float)0.0, (float)0.0, (float)0.0, (float)0.0};
}

/* Whether a flight with these ends may come to a plate.
   Table 1. 34 operations: 6 additions, 3 subtractions, 10 multiplications, 1 negation, 7 comparisons, 2 conjunctions, 1 complement, 4 selections. */
struct kernel_reachable_out {
    bool reachable;
};

static __device__ __forceinline__ kernel_reachable_out kernel_reachable(double p_ball_radius, double p_board_distance, double p_bridge_half_width, double p_gravity, double p_ring_radius, double x, double vx, double horizon, double extent, double speed, double pad, double earliest_delay, double position_error, double velocity_error)
{
    const double _s0 = (position_error + (horizon * velocity_error)) + (9.313225746154785e-10 * (extent + (horizon * (speed + (p_gravity * horizon)))));
    const double _s1 = choose((pad < earliest_delay), (INFINITE), _s0);
    const double _s2 = x + (vx * horizon);
    const double _s3 = smaller(_s2, x);
    const double _s4 = p_ring_radius - (2.0 * _s1);
    const double _s5 = -p_board_distance;
    const double _s6 = larger(_s3, _s5);
    const double _s7 = smaller(0.0, _s6);
    const bool _s8 = (_s1 < (_s3 - (p_ball_radius - p_board_distance))) && ((0.0 < _s4) && ((1.0000000000009095 * ((p_bridge_half_width * p_bridge_half_width) + (_s7 * _s7))) < (_s4 * _s4)));
    return {!_s8};
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

/* The same, through the product of derivatives since an earlier contact.
   derivative of the frame-free Eq. 17, with roundings. 1515 operations: 469 additions, 68 subtractions, 712 multiplications, 7 divisions, 40 negations, 129 absolute values, 16 comparisons, 74 selections. */
struct kernel_tighten_impact_out {
    float place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound, spin_bound, left_nx, left_ny, left_nz, left_ex, left_ey, left_bend_s, left_bend_e, delay, origin_s, origin_e, origin_u, origin_v, origin_w, origin_t, recent_s, recent_e, recent_u, recent_v, recent_w, recent_t, product_11, product_12, product_13, product_14, product_15, product_16, product_21, product_22, product_23, product_24, product_25, product_26, product_31, product_32, product_33, product_34, product_35, product_36, product_41, product_42, product_43, product_44, product_45, product_46, product_51, product_52, product_53, product_54, product_55, product_56, product_61, product_62, product_63, product_64, product_65, product_66, continued;
};

static __device__ __forceinline__ kernel_tighten_impact_out kernel_tighten_impact(float t, float x, float y, float z, float vx, float vy, float vz, float wx, float wy, float wz, float nx, float ny, float nz, float clock, float left_nx, float left_ny, float left_nz, float place_n, float place_s, float place_e, float pace_n, float pace_s, float pace_e, float turn_n, float turn_z, float position_bound, float velocity_bound, float spin_bound, float tangent_x, float tangent_y, float bend_s, float bend_e, float left_ex, float left_ey, float left_bend_s, float left_bend_e, float sharpest_bend, float root_offset, float root_level, float normal_rounding, float normal_velocity, float back, float origin_s, float origin_e, float origin_u, float origin_v, float origin_w, float origin_t, float product_11, float product_12, float product_13, float product_14, float product_15, float product_16, float product_21, float product_22, float product_23, float product_24, float product_25, float product_26, float product_31, float product_32, float product_33, float product_34, float product_35, float product_36, float product_41, float product_42, float product_43, float product_44, float product_45, float product_46, float product_51, float product_52, float product_53, float product_54, float product_55, float product_56, float product_61, float product_62, float product_63, float product_64, float product_65, float product_66, float recent_s, float recent_e, float recent_u, float recent_v, float recent_w, float recent_t, float continued, float p_ball_radius, float p_restitution, float p_gravity)
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
    const float _s62 = ((float)1.0009765625) * _s59;
    const bool _s63 = larger(_s55, _s61) <= ((float)0.0);
    const float _s64 = ((float)1.0) / normal_velocity;
    const float _s65 = -(_s64 * _s36);
    const float _s66 = (_s65 * _s20) + (t * _s14);
    const bool _s67 = ((float)0.0) < continued;
    const float _s68 = choose(_s67, product_51, ((float)0.0));
    const float _s69 = -(_s64 * _s33);
    const float _s70 = ((left_nx * _s12) + (left_ny * _s13)) + (left_nz * _s19);
    const float _s71 = (_s69 * _s20) + (t * _s70);
    const float _s72 = choose(_s67, product_31, ((float)0.0));
    const float _s73 = -(_s64 * _s34);
    const float _s74 = ((_s13 * _s25) + (_s12 * _s24)) + (_s19 * _s26);
    const float _s75 = (_s73 * _s20) + (t * _s74);
    const float _s76 = choose(_s67, product_41, ((float)0.0));
    const float _s77 = -(_s64 * _s32);
    const float _s78 = nz * left_bend_e;
    const float _s79 = -(_s78 * _s16);
    const float _s80 = (_s77 * _s20) + ((t * _s79) + _s14);
    const float _s81 = choose(_s67, product_21, ((float)0.0));
    const float _s82 = -(_s64 * _s28);
    const float _s83 = normal_velocity - (t * _s0);
    const float _s84 = left_bend_s * _s31;
    const float _s85 = (_s18 * _s83) - (_s84 * _s16);
    const float _s86 = (_s82 * _s20) + ((t * _s85) + _s74);
    const float _s87 = choose(_s67, product_11, ((float)1.0));
    const float _s88 = ((((_s66 * _s68) + (_s71 * _s72)) + (_s75 * _s76)) + (_s80 * _s81)) + (_s86 * _s87);
    const float _s89 = choose(_s67, origin_s, place_s);
    const float _s90 = choose(_s67, product_52, ((float)0.0));
    const float _s91 = choose(_s67, product_32, ((float)0.0));
    const float _s92 = choose(_s67, product_42, ((float)0.0));
    const float _s93 = choose(_s67, product_22, ((float)1.0));
    const float _s94 = choose(_s67, product_12, ((float)0.0));
    const float _s95 = ((((_s66 * _s90) + (_s71 * _s91)) + (_s75 * _s92)) + (_s80 * _s93)) + (_s86 * _s94);
    const float _s96 = choose(_s67, origin_e, place_e);
    const float _s97 = choose(_s67, product_53, ((float)0.0));
    const float _s98 = choose(_s67, product_33, ((float)1.0));
    const float _s99 = choose(_s67, product_43, ((float)0.0));
    const float _s100 = choose(_s67, product_23, ((float)0.0));
    const float _s101 = choose(_s67, product_13, ((float)0.0));
    const float _s102 = ((((_s66 * _s97) + (_s71 * _s98)) + (_s75 * _s99)) + (_s80 * _s100)) + (_s86 * _s101);
    const float _s103 = choose(_s67, origin_u, pace_n);
    const float _s104 = choose(_s67, product_54, ((float)0.0));
    const float _s105 = choose(_s67, product_34, ((float)0.0));
    const float _s106 = choose(_s67, product_44, ((float)1.0));
    const float _s107 = choose(_s67, product_24, ((float)0.0));
    const float _s108 = choose(_s67, product_14, ((float)0.0));
    const float _s109 = ((((_s66 * _s104) + (_s71 * _s105)) + (_s75 * _s106)) + (_s80 * _s107)) + (_s86 * _s108);
    const float _s110 = choose(_s67, origin_v, pace_s);
    const float _s111 = choose(_s67, product_55, ((float)1.0));
    const float _s112 = choose(_s67, product_35, ((float)0.0));
    const float _s113 = choose(_s67, product_45, ((float)0.0));
    const float _s114 = choose(_s67, product_25, ((float)0.0));
    const float _s115 = choose(_s67, product_15, ((float)0.0));
    const float _s116 = ((((_s66 * _s111) + (_s71 * _s112)) + (_s75 * _s113)) + (_s80 * _s114)) + (_s86 * _s115);
    const float _s117 = choose(_s67, origin_w, pace_e);
    const float _s118 = ((((fabsf(_s88) * _s89) + (fabsf(_s95) * _s96)) + (fabsf(_s102) * _s103)) + (fabsf(_s109) * _s110)) + (fabsf(_s116) * _s117);
    const float _s119 = choose(_s67, product_56, ((float)0.0));
    const float _s120 = choose(_s67, product_36, ((float)0.0));
    const float _s121 = choose(_s67, product_46, ((float)0.0));
    const float _s122 = choose(_s67, product_26, ((float)0.0));
    const float _s123 = choose(_s67, product_16, ((float)0.0));
    const float _s124 = ((((_s66 * _s119) + (_s71 * _s120)) + (_s75 * _s121)) + (_s80 * _s122)) + (_s86 * _s123);
    const float _s125 = choose(_s67, origin_t, turn_n);
    const float _s126 = _s118 + (fabsf(_s124) * _s125);
    const float _s127 = fabsf(_s20);
    const float _s128 = (root_offset + _s42) / _s44;
    const float _s129 = (_s127 * _s128) + (((fabsf(_s13) * _s5) + (fabsf(_s12) * _s3)) + (fabsf(_s19) * _s8));
    const float _s130 = (_s58 + (((float)7.62939453125e-06) * _s50)) + _s42;
    const float _s131 = -(_s64 * _s11);
    const float _s132 = (_s131 * _s20) + _s70;
    const float _s133 = (((float)9.5367431640625e-07) * pace_e) + choose(_s67, recent_w, ((float)0.0));
    const float _s134 = (((float)9.5367431640625e-07) * pace_n) + choose(_s67, recent_u, ((float)0.0));
    const float _s135 = (((float)9.5367431640625e-07) * pace_s) + choose(_s67, recent_v, ((float)0.0));
    const float _s136 = (((float)9.5367431640625e-07) * place_e) + choose(_s67, recent_e, ((float)0.0));
    const float _s137 = ((((place_n * fabsf(_s132)) + (fabsf(_s66) * _s133)) + (fabsf(_s71) * _s134)) + (fabsf(_s75) * _s135)) + (fabsf(_s80) * _s136);
    const float _s138 = (((float)9.5367431640625e-07) * place_s) + choose(_s67, recent_s, ((float)0.0));
    const float _s139 = ((float)1.0009765625) * ((_s129 + _s130) + (_s137 + (fabsf(_s86) * _s138)));
    const float _s140 = ((float)1.0009765625) * (_s126 + _s139);
    const float _s141 = (_s65 * _s16) + (t * _s17);
    const float _s142 = (left_nx * tangent_x) + (left_ny * tangent_y);
    const float _s143 = (_s69 * _s16) + (t * _s142);
    const float _s144 = (tangent_x * _s24) + (tangent_y * _s25);
    const float _s145 = (_s73 * _s16) + (t * _s144);
    const float _s146 = (_s78 * _s22) - (_s29 * _s83);
    const float _s147 = (_s77 * _s16) + ((t * _s146) + _s17);
    const float _s148 = (_s84 * _s22) - (_s15 * _s83);
    const float _s149 = (_s82 * _s16) + ((t * _s148) + _s144);
    const float _s150 = ((((_s141 * _s68) + (_s143 * _s72)) + (_s145 * _s76)) + (_s147 * _s81)) + (_s149 * _s87);
    const float _s151 = ((((_s141 * _s90) + (_s143 * _s91)) + (_s145 * _s92)) + (_s147 * _s93)) + (_s149 * _s94);
    const float _s152 = ((((_s141 * _s97) + (_s143 * _s98)) + (_s145 * _s99)) + (_s147 * _s100)) + (_s149 * _s101);
    const float _s153 = ((((_s141 * _s104) + (_s143 * _s105)) + (_s145 * _s106)) + (_s147 * _s107)) + (_s149 * _s108);
    const float _s154 = ((((_s141 * _s111) + (_s143 * _s112)) + (_s145 * _s113)) + (_s147 * _s114)) + (_s149 * _s115);
    const float _s155 = ((((fabsf(_s150) * _s89) + (fabsf(_s151) * _s96)) + (fabsf(_s152) * _s103)) + (fabsf(_s153) * _s110)) + (fabsf(_s154) * _s117);
    const float _s156 = ((((_s141 * _s119) + (_s143 * _s120)) + (_s145 * _s121)) + (_s147 * _s122)) + (_s149 * _s123);
    const float _s157 = _s155 + (fabsf(_s156) * _s125);
    const float _s158 = fabsf(_s16);
    const float _s159 = fabsf(((float)0.0));
    const float _s160 = (_s158 * _s128) + (((_s159 * _s8) + (fabsf(tangent_x) * _s3)) + (fabsf(tangent_y) * _s5));
    const float _s161 = (_s131 * _s16) + _s142;
    const float _s162 = ((((place_n * fabsf(_s161)) + (fabsf(_s141) * _s133)) + (fabsf(_s143) * _s134)) + (fabsf(_s145) * _s135)) + (fabsf(_s147) * _s136);
    const float _s163 = ((float)1.0009765625) * ((_s160 + _s130) + (_s162 + (fabsf(_s149) * _s138)));
    const float _s164 = ((float)1.0009765625) * (_s157 + _s163);
    const float _s165 = -(p_restitution * _s0);
    const float _s166 = -(bend_s * _s20);
    const float _s167 = -(p_restitution * _s166);
    const float _s168 = bend_e * _s19;
    const float _s169 = _s168 * _s16;
    const float _s170 = -(p_restitution * _s169);
    const float _s171 = (((_s165 * _s65) + (-(p_restitution * _s31))) - (_s167 * _s66)) - (_s170 * _s141);
    const float _s172 = (((_s165 * _s69) + (-(p_restitution * _s10))) - (_s167 * _s71)) - (_s170 * _s143);
    const float _s173 = (((_s165 * _s73) + (-(p_restitution * _s27))) - (_s167 * _s75)) - (_s170 * _s145);
    const float _s174 = (((_s165 * _s77) + (-(p_restitution * _s30))) - (_s167 * _s80)) - (_s170 * _s147);
    const float _s175 = (((_s165 * _s82) + (-(p_restitution * _s23))) - (_s167 * _s86)) - (_s170 * _s149);
    const float _s176 = ((((_s171 * _s68) + (_s172 * _s72)) + (_s173 * _s76)) + (_s174 * _s81)) + (_s175 * _s87);
    const float _s177 = ((((_s171 * _s90) + (_s172 * _s91)) + (_s173 * _s92)) + (_s174 * _s93)) + (_s175 * _s94);
    const float _s178 = ((((_s171 * _s97) + (_s172 * _s98)) + (_s173 * _s99)) + (_s174 * _s100)) + (_s175 * _s101);
    const float _s179 = ((((_s171 * _s104) + (_s172 * _s105)) + (_s173 * _s106)) + (_s174 * _s107)) + (_s175 * _s108);
    const float _s180 = ((((_s171 * _s111) + (_s172 * _s112)) + (_s173 * _s113)) + (_s174 * _s114)) + (_s175 * _s115);
    const float _s181 = ((((fabsf(_s176) * _s89) + (fabsf(_s177) * _s96)) + (fabsf(_s178) * _s103)) + (fabsf(_s179) * _s110)) + (fabsf(_s180) * _s117);
    const float _s182 = ((((_s171 * _s119) + (_s172 * _s120)) + (_s173 * _s121)) + (_s174 * _s122)) + (_s175 * _s123);
    const float _s183 = _s181 + (fabsf(_s182) * _s125);
    const float _s184 = (p_gravity * _s128) + _s46;
    const float _s185 = _s184 + ((fabsf(_s166) * _s129) + (fabsf(_s169) * _s160));
    const float _s186 = ((float)0.6) + p_restitution;
    const float _s187 = ((float)0.4) * p_ball_radius;
    const float _s188 = normal_rounding + _s60;
    const float _s189 = (fabsf(wx) + fabsf(wy)) + fabsf(wz);
    const float _s190 = (_s187 * _s188) * _s189;
    const float _s191 = p_ball_radius * _s189;
    const float _s192 = _s191 + _s39;
    const float _s193 = ((float)7.888609052210118e-31) + (((float)1.5543122344752192e-15) * _s192);
    const float _s194 = p_gravity * _s57;
    const float _s195 = ((float)2.0) * _s186;
    const float _s196 = (bend_s + bend_e) * _s130;
    const float _s197 = _s52 * _s52;
    const float _s198 = (_s51 * _s58) + (((float)2.0) * _s197);
    const float _s199 = ((_s194 + (_s52 * ((spin_bound * _s187) + (_s195 * _s48)))) + (_s196 * _s192)) + (_s198 * ((_s187 * _s189) + (_s195 * _s39)));
    const float _s200 = spin_bound + (_s40 * _s189);
    const float _s201 = ((float)7.62939453125e-06) * (((p_ball_radius * _s200) + (_s52 * (_s191 + (((float)4.0) * _s39)))) + (((float)2.0) * (_s41 + _s48)));
    const float _s202 = (_s199 + ((_s197 * _s186) * _s49)) + _s201;
    const float _s203 = ((p_restitution * _s185) + (_s186 * ((normal_rounding * (_s39 + _s44)) + ((((float)2.0) * _s60) * _s44)))) + ((_s190 + _s193) + _s202);
    const float _s204 = (place_n * fabsf((((_s165 * _s131) - (_s167 * _s132)) - (_s170 * _s161)))) + (fabsf(_s171) * _s133);
    const float _s205 = (((_s204 + (fabsf(_s172) * _s134)) + (fabsf(_s173) * _s135)) + (fabsf(_s174) * _s136)) + (fabsf(_s175) * _s138);
    const float _s206 = ((float)1.0009765625) * (_s203 + _s205);
    const float _s207 = ((float)1.0009765625) * (_s183 + _s206);
    const float _s208 = _s187 * _s142;
    const float _s209 = choose(_s67, product_61, ((float)0.0));
    const float _s210 = ((float)0.6) * _s21;
    const float _s211 = ((float)1.0) / p_ball_radius;
    const float _s212 = ((wx * _s12) + (wy * _s13)) + (wz * _s19);
    const float _s213 = ((nx * wx) + (ny * wy)) + (nz * wz);
    const float _s214 = _s19 * _s213;
    const float _s215 = bend_e * ((nz * _s212) - _s214);
    const float _s216 = nz * bend_e;
    const float _s217 = -(_s216 * _s16);
    const float _s218 = (_s187 * _s215) + (((float)0.6) * _s217);
    const float _s219 = ((_s65 * _s210) + ((_s187 * (-(_s211 * _s144))) + (((float)0.6) * _s14))) - (_s218 * _s141);
    const float _s220 = bend_s * normal_velocity;
    const float _s221 = ((float)0.6) * _s220;
    const float _s222 = _s219 - (_s66 * _s221);
    const float _s223 = (((_s69 * _s210) + (((float)0.6) * _s70)) - (_s218 * _s143)) - (_s71 * _s221);
    const float _s224 = (((_s73 * _s210) + ((_s187 * (_s211 * _s17)) + (((float)0.6) * _s74))) - (_s218 * _s145)) - (_s75 * _s221);
    const float _s225 = ((_s77 * _s210) + ((_s187 * ((_s78 * _s212) - (_s29 * _s213))) + (((float)0.6) * _s79))) - (_s218 * _s147);
    const float _s226 = _s225 - (_s80 * _s221);
    const float _s227 = ((_s82 * _s210) + ((_s187 * ((_s84 * _s212) - (_s15 * _s213))) + (((float)0.6) * _s85))) - (_s218 * _s149);
    const float _s228 = _s227 - (_s86 * _s221);
    const float _s229 = (((((_s208 * _s209) + (_s222 * _s68)) + (_s223 * _s72)) + (_s224 * _s76)) + (_s226 * _s81)) + (_s228 * _s87);
    const float _s230 = choose(_s67, product_62, ((float)0.0));
    const float _s231 = (((((_s208 * _s230) + (_s222 * _s90)) + (_s223 * _s91)) + (_s224 * _s92)) + (_s226 * _s93)) + (_s228 * _s94);
    const float _s232 = choose(_s67, product_63, ((float)0.0));
    const float _s233 = (((((_s208 * _s232) + (_s222 * _s97)) + (_s223 * _s98)) + (_s224 * _s99)) + (_s226 * _s100)) + (_s228 * _s101);
    const float _s234 = choose(_s67, product_64, ((float)0.0));
    const float _s235 = (((((_s208 * _s234) + (_s222 * _s104)) + (_s223 * _s105)) + (_s224 * _s106)) + (_s226 * _s107)) + (_s228 * _s108);
    const float _s236 = choose(_s67, product_65, ((float)0.0));
    const float _s237 = (((((_s208 * _s236) + (_s222 * _s111)) + (_s223 * _s112)) + (_s224 * _s113)) + (_s226 * _s114)) + (_s228 * _s115);
    const float _s238 = ((((fabsf(_s229) * _s89) + (fabsf(_s231) * _s96)) + (fabsf(_s233) * _s103)) + (fabsf(_s235) * _s110)) + (fabsf(_s237) * _s117);
    const float _s239 = choose(_s67, product_66, ((float)1.0));
    const float _s240 = (((((_s208 * _s239) + (_s222 * _s119)) + (_s223 * _s120)) + (_s224 * _s121)) + (_s226 * _s122)) + (_s228 * _s123);
    const float _s241 = _s238 + (fabsf(_s240) * _s125);
    const float _s242 = _s159 * _s129;
    const float _s243 = _s242 + (fabsf(_s215) * _s160);
    const float _s244 = _s184 + ((fabsf(_s220) * _s129) + (fabsf(_s217) * _s160));
    const float _s245 = ((((normal_rounding * _s186) * _s44) + _s190) + _s193) + _s202;
    const float _s246 = (place_n * fabsf((((_s131 * _s210) - (_s218 * _s161)) - (_s132 * _s221)))) + (turn_z * fabsf((_s187 * _s17)));
    const float _s247 = (((float)9.5367431640625e-07) * turn_n) + choose(_s67, recent_t, ((float)0.0));
    const float _s248 = ((_s246 + (turn_z * fabsf((_s187 * _s144)))) + (fabsf(_s208) * _s247)) + (fabsf(_s222) * _s133);
    const float _s249 = (((_s248 + (fabsf(_s223) * _s134)) + (fabsf(_s224) * _s135)) + (fabsf(_s226) * _s136)) + (fabsf(_s228) * _s138);
    const float _s250 = ((float)1.0009765625) * ((((_s187 * _s243) + (((float)0.6) * _s244)) + _s245) + _s249);
    const float _s251 = ((float)1.0009765625) * (_s241 + _s250);
    const float _s252 = -(_s187 * _s70);
    const float _s253 = bend_s * _s213;
    const float _s254 = -(_s187 * _s253);
    const float _s255 = bend_e * ((nz * _s20) - (normal_velocity * _s19));
    const float _s256 = (wx * tangent_x) + (wy * tangent_y);
    const float _s257 = -(_s216 * _s256);
    const float _s258 = (((float)0.6) * _s255) - (_s187 * _s257);
    const float _s259 = (((((float)0.6) * _s17) - (_s187 * (-(_s211 * _s74)))) - (_s254 * _s66)) - (_s258 * _s141);
    const float _s260 = ((((float)0.6) * _s142) - (_s254 * _s71)) - (_s258 * _s143);
    const float _s261 = (((((float)0.6) * _s144) - (_s187 * (_s211 * _s14))) - (_s254 * _s75)) - (_s258 * _s145);
    const float _s262 = (((((float)0.6) * _s146) - (_s187 * (-(_s78 * _s256)))) - (_s254 * _s80)) - (_s258 * _s147);
    const float _s263 = (((((float)0.6) * _s148) - (_s187 * ((_s18 * _s213) - (_s84 * _s256)))) - (_s254 * _s86)) - (_s258 * _s149);
    const float _s264 = (((((_s252 * _s209) + (_s259 * _s68)) + (_s260 * _s72)) + (_s261 * _s76)) + (_s262 * _s81)) + (_s263 * _s87);
    const float _s265 = (((((_s252 * _s230) + (_s259 * _s90)) + (_s260 * _s91)) + (_s261 * _s92)) + (_s262 * _s93)) + (_s263 * _s94);
    const float _s266 = (((((_s252 * _s232) + (_s259 * _s97)) + (_s260 * _s98)) + (_s261 * _s99)) + (_s262 * _s100)) + (_s263 * _s101);
    const float _s267 = (((((_s252 * _s234) + (_s259 * _s104)) + (_s260 * _s105)) + (_s261 * _s106)) + (_s262 * _s107)) + (_s263 * _s108);
    const float _s268 = (((((_s252 * _s236) + (_s259 * _s111)) + (_s260 * _s112)) + (_s261 * _s113)) + (_s262 * _s114)) + (_s263 * _s115);
    const float _s269 = ((((fabsf(_s264) * _s89) + (fabsf(_s265) * _s96)) + (fabsf(_s266) * _s103)) + (fabsf(_s267) * _s110)) + (fabsf(_s268) * _s117);
    const float _s270 = (((((_s252 * _s239) + (_s259 * _s119)) + (_s260 * _s120)) + (_s261 * _s121)) + (_s262 * _s122)) + (_s263 * _s123);
    const float _s271 = _s269 + (fabsf(_s270) * _s125);
    const float _s272 = fabsf(_s253);
    const float _s273 = (_s272 * _s129) + (fabsf(_s257) * _s160);
    const float _s274 = _s184 + (_s242 + (fabsf(_s255) * _s160));
    const float _s275 = (place_n * fabsf((-((_s254 * _s132) + (_s258 * _s161))))) + (turn_z * fabsf((-(_s187 * _s14))));
    const float _s276 = (_s275 + (turn_z * fabsf((-(_s187 * _s74))))) + (fabsf(_s252) * _s247);
    const float _s277 = (((_s276 + (fabsf(_s259) * _s133)) + (fabsf(_s260) * _s134)) + (fabsf(_s261) * _s135)) + (fabsf(_s262) * _s136);
    const float _s278 = ((float)1.0009765625) * ((((_s187 * _s273) + (((float)0.6) * _s274)) + _s245) + (_s277 + (fabsf(_s263) * _s138)));
    const float _s279 = ((float)1.0009765625) * (_s271 + _s278);
    const float _s280 = -(bend_s * _s212);
    const float _s281 = _s168 * _s256;
    const float _s282 = -((_s280 * _s71) + (_s281 * _s143));
    const float _s283 = ((-(_s211 * _s27)) - (_s280 * _s66)) - (_s281 * _s141);
    const float _s284 = ((_s211 * _s31) - (_s280 * _s75)) - (_s281 * _s145);
    const float _s285 = ((_s29 * _s256) - (_s280 * _s80)) - (_s281 * _s147);
    const float _s286 = (((_s15 * _s256) - (_s18 * _s212)) - (_s280 * _s86)) - (_s281 * _s149);
    const float _s287 = (((((_s282 * _s72) + (_s10 * _s209)) + (_s283 * _s68)) + (_s284 * _s76)) + (_s285 * _s81)) + (_s286 * _s87);
    const float _s288 = (((((_s282 * _s91) + (_s10 * _s230)) + (_s283 * _s90)) + (_s284 * _s92)) + (_s285 * _s93)) + (_s286 * _s94);
    const float _s289 = (((((_s282 * _s98) + (_s10 * _s232)) + (_s283 * _s97)) + (_s284 * _s99)) + (_s285 * _s100)) + (_s286 * _s101);
    const float _s290 = (((((_s282 * _s105) + (_s10 * _s234)) + (_s283 * _s104)) + (_s284 * _s106)) + (_s285 * _s107)) + (_s286 * _s108);
    const float _s291 = (((((_s282 * _s112) + (_s10 * _s236)) + (_s283 * _s111)) + (_s284 * _s113)) + (_s285 * _s114)) + (_s286 * _s115);
    const float _s292 = ((((fabsf(_s287) * _s89) + (fabsf(_s288) * _s96)) + (fabsf(_s289) * _s103)) + (fabsf(_s290) * _s110)) + (fabsf(_s291) * _s117);
    const float _s293 = (((((_s282 * _s120) + (_s10 * _s239)) + (_s283 * _s119)) + (_s284 * _s121)) + (_s285 * _s122)) + (_s286 * _s123);
    const float _s294 = _s292 + (fabsf(_s293) * _s125);
    const float _s295 = (fabsf(_s280) * _s129) + (fabsf(_s281) * _s160);
    const float _s296 = ((float)0.6) * _s211;
    const float _s297 = (_s211 * _s39) + _s189;
    const float _s298 = (((_s211 * (_s194 + _s201)) + (_s52 * ((((float)2.0) * spin_bound) + (_s296 * _s48)))) + (_s197 * (spin_bound + _s189))) + (_s196 * _s297);
    const float _s299 = (_s298 + (_s198 * ((_s296 * _s39) + (((float)2.0) * _s189)))) + (((float)7.62939453125e-06) * ((_s52 * _s189) + _s200));
    const float _s300 = ((((_s211 * _s193) + (((float)2.0) * (_s188 * _s189))) + (((float)0.6) * ((normal_rounding * _s211) * _s39))) + _s295) + _s299;
    const float _s301 = (place_n * fabsf((-((_s280 * _s132) + (_s281 * _s161))))) + (turn_z * fabsf(_s31));
    const float _s302 = (((_s301 + (turn_z * fabsf(_s27))) + (fabsf(_s282) * _s134)) + (fabsf(_s10) * _s247)) + (fabsf(_s283) * _s133);
    const float _s303 = _s300 + (((_s302 + (fabsf(_s284) * _s135)) + (fabsf(_s285) * _s136)) + (fabsf(_s286) * _s138));
    const float _s304 = ((float)1.0009765625) * _s303;
    const float _s305 = ((float)1.0009765625) * (_s294 + _s304);
    const float _s306 = (_s211 * (_s193 + _s245)) + (((float)2.0) * (_s188 * ((_s296 * (_s158 + _s127)) + _s189)));
    const float _s307 = larger(_s185, _s244);
    const float _s308 = larger(_s295, _s273);
    const float _s309 = ((float)1.0009765625) * ((_s306 + ((_s211 * larger(_s307, _s274)) + larger(_s308, _s243))) + _s299);
    const float _s310 = larger(_s62, _s140);
    const float _s311 = choose(_s63, (((float)1.0009765625) * ((((float)0.421875) * ((_s164 + _s140) + _s62)) + (((float)0.578125) * larger(_s310, _s164)))), ((float)INFINITE));
    const float _s312 = _s159 * _s140;
    const float _s313 = (_s187 * _s256) + (((float)0.6) * _s20);
    const float _s314 = -(p_restitution * normal_velocity);
    const float _s315 = _s312 + (fabsf((bend_e * ((nz * _s313) - (_s314 * _s19)))) * _s164);
    const float _s316 = ((float)7.62939453125e-06) * ((bend_s * _s140) + (bend_e * _s164));
    const float _s317 = _s192 * _s316;
    const float _s318 = (_s315 + _s317) + _s279;
    const float _s319 = (((float)0.6) * _s16) - (_s187 * _s212);
    const float _s320 = ((fabsf((bend_s * _s314)) * _s140) + (fabsf((-(_s216 * _s319))) * _s164)) + _s317;
    const float _s321 = _s320 + _s251;
    const float _s322 = ((fabsf((-(bend_s * _s313))) * _s140) + (fabsf((_s168 * _s319)) * _s164)) + _s317;
    const float _s323 = _s322 + _s207;
    const float _s324 = larger(_s323, _s321);
    const float _s325 = choose(_s63, (((float)1.0009765625) * ((((float)0.421875) * ((_s318 + _s321) + _s323)) + (((float)0.578125) * larger(_s324, _s318)))), ((float)INFINITE));
    const float _s326 = -(_s211 * _s319);
    const float _s327 = _s211 * _s313;
    const float _s328 = _s297 * _s316;
    const float _s329 = ((fabsf((-(bend_s * _s326))) * _s140) + (fabsf(((bend_e * _s327) * _s19)) * _s164)) + _s328;
    const float _s330 = _s329 + _s305;
    const float _s331 = ((_s251 / p_ball_radius) + _s312) + (fabsf((bend_e * ((nz * _s326) - _s214))) * _s164);
    const float _s332 = (_s331 + _s328) + _s309;
    const float _s333 = (((_s279 / p_ball_radius) + (_s272 * _s140)) + (fabsf((-(_s216 * _s327))) * _s164)) + _s328;
    const float _s334 = _s333 + _s309;
    const float _s335 = larger(_s330, _s334);
    const float _s336 = choose(_s63, (((float)1.0009765625) * ((((float)0.421875) * ((_s330 + _s332) + _s334)) + (((float)0.578125) * larger(_s335, _s332)))), ((float)INFINITE));
    const float _s337 = ((float)0.25) * (((((_s157 + _s126) + (((float)0.125) * _s183)) + (((float)0.125) * _s241)) + (((float)0.125) * _s271)) + (((float)0.015625) * _s294));
    const bool _s338 = (((((_s163 + _s139) + (((float)0.125) * _s206)) + (((float)0.125) * _s250)) + (((float)0.125) * _s278)) + (((float)0.015625) * _s304)) <= _s337;
    return {choose(_s63, _s62, ((float)INFINITE)), choose(_s63, _s140, ((float)INFINITE)), choose(_s63, _s164, ((float)INFINITE)), choose(_s63, _s207, ((float)INFINITE)), choose(_s63, _s251, ((float)INFINITE)), choose(_s63, _s279, ((float)INFINITE)), choose(_s63, _s305, ((float)INFINITE)), choose(_s63, _s309, ((float)INFINITE)), _s311, _s325, _s336, nx, ny, nz, tangent_x, tangent_y, bend_s, bend_e, (((float)4.440892098500626e-16) * (t + clock)) + choose(_s63, (((float)1.0009765625) * _s45), ((float)INFINITE)), _s89, _s96, _s103, _s110, _s117, _s125, _s139, _s163, _s206, _s250, _s278, _s304, _s88, _s95, _s102, _s109, _s116, _s124, _s150, _s151, _s152, _s153, _s154, _s156, _s176, _s177, _s178, _s179, _s180, _s182, _s229, _s231, _s233, _s235, _s237, _s240, _s264, _s265, _s266, _s267, _s268, _s270, _s287, _s288, _s289, _s290, _s291, _s293, choose(_s338, ((float)1.0), ((float)0.0))};
}

/* Velocity and spin after a contact, frame-free.
   Eqs. 11-17, the frame eliminated. 63 operations: 10 additions, 12 subtractions, 40 multiplications, 1 division. */
struct kernel_impact_out {
    double vx, vy, vz, wx, wy, wz;
};

static __device__ __forceinline__ kernel_impact_out kernel_impact(double vx, double vy, double vz, double wx, double wy, double wz, double nx, double ny, double nz, double p_ball_radius, double p_restitution)
{
    const double _s0 = 0.4 * p_ball_radius;
    const double _s1 = ((nx * vx) + (ny * vy)) + (nz * vz);
    const double _s2 = (_s0 * ((nz * wy) - (ny * wz))) + (0.6 * (vx - (nx * _s1)));
    const double _s3 = (_s0 * ((nx * wz) - (nz * wx))) + (0.6 * (vy - (ny * _s1)));
    const double _s4 = (_s0 * ((ny * wx) - (nx * wy))) + (0.6 * (vz - (nz * _s1)));
    const double _s5 = ((nx * wx) + (ny * wy)) + (nz * wz);
    const double _s6 = 1.0 / p_ball_radius;
    return {_s2 - ((p_restitution * nx) * _s1), _s3 - ((p_restitution * ny) * _s1), _s4 - ((p_restitution * nz) * _s1), (nx * _s5) + (_s6 * ((ny * _s4) - (nz * _s3))), (ny * _s5) + (_s6 * ((nz * _s2) - (nx * _s4))), (nz * _s5) + (_s6 * ((nx * _s3) - (ny * _s2)))};
}

/* Bounds on errors after a contact, from those at the departure before it.
   derivative of the frame-free Eq. 17, with roundings. 959 operations: 255 additions, 68 subtractions, 457 multiplications, 7 divisions, 40 negations, 93 absolute values, 14 comparisons, 25 selections. */
struct kernel_carry_impact_out {
    float place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound, spin_bound, left_nx, left_ny, left_nz, left_ex, left_ey, left_bend_s, left_bend_e, delay;
};

static __device__ __forceinline__ kernel_carry_impact_out kernel_carry_impact(float t, float x, float y, float z, float vx, float vy, float vz, float wx, float wy, float wz, float nx, float ny, float nz, float clock, float left_nx, float left_ny, float left_nz, float place_n, float place_s, float place_e, float pace_n, float pace_s, float pace_e, float turn_n, float turn_z, float position_bound, float velocity_bound, float spin_bound, float tangent_x, float tangent_y, float bend_s, float bend_e, float left_ex, float left_ey, float left_bend_s, float left_bend_e, float sharpest_bend, float root_offset, float root_level, float normal_rounding, float normal_velocity, float back, float p_ball_radius, float p_restitution, float p_gravity)
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
    const float _s62 = ((float)1.0009765625) * _s59;
    const bool _s63 = larger(_s55, _s61) <= ((float)0.0);
    const float _s64 = fabsf(_s20);
    const float _s65 = (root_offset + _s42) / _s44;
    const float _s66 = (_s64 * _s65) + (((fabsf(_s13) * _s5) + (fabsf(_s12) * _s3)) + (fabsf(_s19) * _s8));
    const float _s67 = (_s58 + (((float)7.62939453125e-06) * _s50)) + _s42;
    const float _s68 = ((float)1.0) / normal_velocity;
    const float _s69 = -(_s68 * _s11);
    const float _s70 = ((left_nx * _s12) + (left_ny * _s13)) + (left_nz * _s19);
    const float _s71 = (_s69 * _s20) + _s70;
    const float _s72 = -(_s68 * _s28);
    const float _s73 = normal_velocity - (t * _s0);
    const float _s74 = left_bend_s * _s31;
    const float _s75 = (_s18 * _s73) - (_s74 * _s16);
    const float _s76 = ((_s13 * _s25) + (_s12 * _s24)) + (_s19 * _s26);
    const float _s77 = (_s72 * _s20) + ((t * _s75) + _s76);
    const float _s78 = -(_s68 * _s32);
    const float _s79 = nz * left_bend_e;
    const float _s80 = -(_s79 * _s16);
    const float _s81 = (_s78 * _s20) + ((t * _s80) + _s14);
    const float _s82 = -(_s68 * _s33);
    const float _s83 = (_s82 * _s20) + (t * _s70);
    const float _s84 = -(_s68 * _s34);
    const float _s85 = (_s84 * _s20) + (t * _s76);
    const float _s86 = ((((place_n * fabsf(_s71)) + (place_s * fabsf(_s77))) + (place_e * fabsf(_s81))) + (pace_n * fabsf(_s83))) + (pace_s * fabsf(_s85));
    const float _s87 = -(_s68 * _s36);
    const float _s88 = (_s87 * _s20) + (t * _s14);
    const float _s89 = ((float)1.0009765625) * ((_s66 + _s67) + (_s86 + (pace_e * fabsf(_s88))));
    const float _s90 = fabsf(_s16);
    const float _s91 = fabsf(((float)0.0));
    const float _s92 = (_s90 * _s65) + (((_s91 * _s8) + (fabsf(tangent_x) * _s3)) + (fabsf(tangent_y) * _s5));
    const float _s93 = (left_nx * tangent_x) + (left_ny * tangent_y);
    const float _s94 = (_s69 * _s16) + _s93;
    const float _s95 = (_s74 * _s22) - (_s15 * _s73);
    const float _s96 = (tangent_x * _s24) + (tangent_y * _s25);
    const float _s97 = (_s72 * _s16) + ((t * _s95) + _s96);
    const float _s98 = (_s79 * _s22) - (_s29 * _s73);
    const float _s99 = (_s78 * _s16) + ((t * _s98) + _s17);
    const float _s100 = (_s82 * _s16) + (t * _s93);
    const float _s101 = (_s84 * _s16) + (t * _s96);
    const float _s102 = ((((place_n * fabsf(_s94)) + (place_s * fabsf(_s97))) + (place_e * fabsf(_s99))) + (pace_n * fabsf(_s100))) + (pace_s * fabsf(_s101));
    const float _s103 = (_s87 * _s16) + (t * _s17);
    const float _s104 = ((float)1.0009765625) * ((_s92 + _s67) + (_s102 + (pace_e * fabsf(_s103))));
    const float _s105 = (p_gravity * _s65) + _s46;
    const float _s106 = -(bend_s * _s20);
    const float _s107 = bend_e * _s19;
    const float _s108 = _s107 * _s16;
    const float _s109 = _s105 + ((fabsf(_s106) * _s66) + (fabsf(_s108) * _s92));
    const float _s110 = ((float)0.6) + p_restitution;
    const float _s111 = ((float)0.4) * p_ball_radius;
    const float _s112 = normal_rounding + _s60;
    const float _s113 = (fabsf(wx) + fabsf(wy)) + fabsf(wz);
    const float _s114 = (_s111 * _s112) * _s113;
    const float _s115 = p_ball_radius * _s113;
    const float _s116 = _s115 + _s39;
    const float _s117 = ((float)7.888609052210118e-31) + (((float)1.5543122344752192e-15) * _s116);
    const float _s118 = p_gravity * _s57;
    const float _s119 = ((float)2.0) * _s110;
    const float _s120 = (bend_s + bend_e) * _s67;
    const float _s121 = _s52 * _s52;
    const float _s122 = (_s51 * _s58) + (((float)2.0) * _s121);
    const float _s123 = ((_s118 + (_s52 * ((spin_bound * _s111) + (_s119 * _s48)))) + (_s120 * _s116)) + (_s122 * ((_s111 * _s113) + (_s119 * _s39)));
    const float _s124 = spin_bound + (_s40 * _s113);
    const float _s125 = ((float)7.62939453125e-06) * (((p_ball_radius * _s124) + (_s52 * (_s115 + (((float)4.0) * _s39)))) + (((float)2.0) * (_s41 + _s48)));
    const float _s126 = (_s123 + ((_s121 * _s110) * _s49)) + _s125;
    const float _s127 = ((p_restitution * _s109) + (_s110 * ((normal_rounding * (_s39 + _s44)) + ((((float)2.0) * _s60) * _s44)))) + ((_s114 + _s117) + _s126);
    const float _s128 = -(p_restitution * _s0);
    const float _s129 = -(p_restitution * _s106);
    const float _s130 = -(p_restitution * _s108);
    const float _s131 = fabsf(((((_s128 * _s72) + (-(p_restitution * _s23))) - (_s129 * _s77)) - (_s130 * _s97)));
    const float _s132 = (place_n * fabsf((((_s128 * _s69) - (_s129 * _s71)) - (_s130 * _s94)))) + (place_s * _s131);
    const float _s133 = fabsf(((((_s128 * _s78) + (-(p_restitution * _s30))) - (_s129 * _s81)) - (_s130 * _s99)));
    const float _s134 = fabsf(((((_s128 * _s82) + (-(p_restitution * _s10))) - (_s129 * _s83)) - (_s130 * _s100)));
    const float _s135 = fabsf(((((_s128 * _s84) + (-(p_restitution * _s27))) - (_s129 * _s85)) - (_s130 * _s101)));
    const float _s136 = fabsf(((((_s128 * _s87) + (-(p_restitution * _s31))) - (_s129 * _s88)) - (_s130 * _s103)));
    const float _s137 = _s127 + ((((_s132 + (place_e * _s133)) + (pace_n * _s134)) + (pace_s * _s135)) + (pace_e * _s136));
    const float _s138 = ((float)1.0009765625) * _s137;
    const float _s139 = _s91 * _s66;
    const float _s140 = ((wx * _s12) + (wy * _s13)) + (wz * _s19);
    const float _s141 = ((nx * wx) + (ny * wy)) + (nz * wz);
    const float _s142 = _s19 * _s141;
    const float _s143 = bend_e * ((nz * _s140) - _s142);
    const float _s144 = _s139 + (fabsf(_s143) * _s92);
    const float _s145 = bend_s * normal_velocity;
    const float _s146 = nz * bend_e;
    const float _s147 = -(_s146 * _s16);
    const float _s148 = _s105 + ((fabsf(_s145) * _s66) + (fabsf(_s147) * _s92));
    const float _s149 = ((((normal_rounding * _s110) * _s44) + _s114) + _s117) + _s126;
    const float _s150 = ((float)0.6) * _s21;
    const float _s151 = (_s111 * _s143) + (((float)0.6) * _s147);
    const float _s152 = ((float)0.6) * _s145;
    const float _s153 = ((_s72 * _s150) + ((_s111 * ((_s74 * _s140) - (_s15 * _s141))) + (((float)0.6) * _s75))) - (_s151 * _s97);
    const float _s154 = (place_n * fabsf((((_s69 * _s150) - (_s151 * _s94)) - (_s71 * _s152)))) + (place_s * fabsf((_s153 - (_s77 * _s152))));
    const float _s155 = ((_s78 * _s150) + ((_s111 * ((_s79 * _s140) - (_s29 * _s141))) + (((float)0.6) * _s80))) - (_s151 * _s99);
    const float _s156 = pace_n * fabsf(((((_s82 * _s150) + (((float)0.6) * _s70)) - (_s151 * _s100)) - (_s83 * _s152)));
    const float _s157 = (_s154 + (place_e * fabsf((_s155 - (_s81 * _s152))))) + _s156;
    const float _s158 = ((float)1.0) / p_ball_radius;
    const float _s159 = (((_s84 * _s150) + ((_s111 * (_s158 * _s17)) + (((float)0.6) * _s76))) - (_s151 * _s101)) - (_s85 * _s152);
    const float _s160 = ((_s87 * _s150) + ((_s111 * (-(_s158 * _s96))) + (((float)0.6) * _s14))) - (_s151 * _s103);
    const float _s161 = ((_s157 + (pace_s * fabsf(_s159))) + (pace_e * fabsf((_s160 - (_s88 * _s152))))) + (turn_n * fabsf((_s111 * _s93)));
    const float _s162 = (((_s111 * _s144) + (((float)0.6) * _s148)) + _s149) + ((_s161 + (turn_z * fabsf((_s111 * _s17)))) + (turn_z * fabsf((_s111 * _s96))));
    const float _s163 = ((float)1.0009765625) * _s162;
    const float _s164 = bend_s * _s141;
    const float _s165 = fabsf(_s164);
    const float _s166 = (wx * tangent_x) + (wy * tangent_y);
    const float _s167 = -(_s146 * _s166);
    const float _s168 = (_s165 * _s66) + (fabsf(_s167) * _s92);
    const float _s169 = bend_e * ((nz * _s20) - (normal_velocity * _s19));
    const float _s170 = _s105 + (_s139 + (fabsf(_s169) * _s92));
    const float _s171 = -(_s111 * _s164);
    const float _s172 = (((float)0.6) * _s169) - (_s111 * _s167);
    const float _s173 = (((((float)0.6) * _s95) - (_s111 * ((_s18 * _s141) - (_s74 * _s166)))) - (_s171 * _s77)) - (_s172 * _s97);
    const float _s174 = (place_n * fabsf((-((_s171 * _s71) + (_s172 * _s94))))) + (place_s * fabsf(_s173));
    const float _s175 = (((((float)0.6) * _s98) - (_s111 * (-(_s79 * _s166)))) - (_s171 * _s81)) - (_s172 * _s99);
    const float _s176 = (_s174 + (place_e * fabsf(_s175))) + (pace_n * fabsf((((((float)0.6) * _s93) - (_s171 * _s83)) - (_s172 * _s100))));
    const float _s177 = fabsf(((((((float)0.6) * _s96) - (_s111 * (_s158 * _s14))) - (_s171 * _s85)) - (_s172 * _s101)));
    const float _s178 = (((((float)0.6) * _s17) - (_s111 * (-(_s158 * _s76)))) - (_s171 * _s88)) - (_s172 * _s103);
    const float _s179 = (((_s176 + (pace_s * _s177)) + (pace_e * fabsf(_s178))) + (turn_n * fabsf((-(_s111 * _s70))))) + (turn_z * fabsf((-(_s111 * _s14))));
    const float _s180 = (((_s111 * _s168) + (((float)0.6) * _s170)) + _s149) + (_s179 + (turn_z * fabsf((-(_s111 * _s76)))));
    const float _s181 = ((float)1.0009765625) * _s180;
    const float _s182 = -(bend_s * _s140);
    const float _s183 = _s107 * _s166;
    const float _s184 = (fabsf(_s182) * _s66) + (fabsf(_s183) * _s92);
    const float _s185 = ((float)0.6) * _s158;
    const float _s186 = (_s158 * _s39) + _s113;
    const float _s187 = (((_s158 * (_s118 + _s125)) + (_s52 * ((((float)2.0) * spin_bound) + (_s185 * _s48)))) + (_s121 * (spin_bound + _s113))) + (_s120 * _s186);
    const float _s188 = (_s187 + (_s122 * ((_s185 * _s39) + (((float)2.0) * _s113)))) + (((float)7.62939453125e-06) * ((_s52 * _s113) + _s124));
    const float _s189 = ((((_s158 * _s117) + (((float)2.0) * (_s112 * _s113))) + (((float)0.6) * ((normal_rounding * _s158) * _s39))) + _s184) + _s188;
    const float _s190 = place_s * fabsf(((((_s15 * _s166) - (_s18 * _s140)) - (_s182 * _s77)) - (_s183 * _s97)));
    const float _s191 = (place_n * fabsf((-((_s182 * _s71) + (_s183 * _s94))))) + _s190;
    const float _s192 = _s191 + (place_e * fabsf((((_s29 * _s166) - (_s182 * _s81)) - (_s183 * _s99))));
    const float _s193 = _s192 + (pace_n * fabsf((-((_s182 * _s83) + (_s183 * _s100)))));
    const float _s194 = _s193 + (pace_s * fabsf((((_s158 * _s31) - (_s182 * _s85)) - (_s183 * _s101))));
    const float _s195 = pace_e * fabsf((((-(_s158 * _s27)) - (_s182 * _s88)) - (_s183 * _s103)));
    const float _s196 = _s189 + ((((_s194 + _s195) + (turn_n * fabsf(_s10))) + (turn_z * fabsf(_s31))) + (turn_z * fabsf(_s27)));
    const float _s197 = ((float)1.0009765625) * _s196;
    const float _s198 = (_s158 * (_s117 + _s149)) + (((float)2.0) * (_s112 * ((_s185 * (_s90 + _s64)) + _s113)));
    const float _s199 = larger(_s109, _s148);
    const float _s200 = larger(_s184, _s168);
    const float _s201 = ((float)1.0009765625) * ((_s198 + ((_s158 * larger(_s199, _s170)) + larger(_s200, _s144))) + _s188);
    const float _s202 = larger(_s62, _s89);
    const float _s203 = choose(_s63, (((float)1.0009765625) * ((((float)0.421875) * ((_s62 + _s104) + _s89)) + (((float)0.578125) * larger(_s202, _s104)))), ((float)INFINITE));
    const float _s204 = _s91 * _s89;
    const float _s205 = (_s111 * _s166) + (((float)0.6) * _s20);
    const float _s206 = -(p_restitution * normal_velocity);
    const float _s207 = _s204 + (fabsf((bend_e * ((nz * _s205) - (_s206 * _s19)))) * _s104);
    const float _s208 = ((float)7.62939453125e-06) * ((bend_s * _s89) + (bend_e * _s104));
    const float _s209 = _s116 * _s208;
    const float _s210 = (_s207 + _s209) + _s181;
    const float _s211 = (((float)0.6) * _s16) - (_s111 * _s140);
    const float _s212 = ((fabsf((bend_s * _s206)) * _s89) + (fabsf((-(_s146 * _s211))) * _s104)) + _s209;
    const float _s213 = _s212 + _s163;
    const float _s214 = ((fabsf((-(bend_s * _s205))) * _s89) + (fabsf((_s107 * _s211)) * _s104)) + _s209;
    const float _s215 = _s214 + _s138;
    const float _s216 = larger(_s215, _s213);
    const float _s217 = choose(_s63, (((float)1.0009765625) * ((((float)0.421875) * ((_s210 + _s213) + _s215)) + (((float)0.578125) * larger(_s216, _s210)))), ((float)INFINITE));
    const float _s218 = -(_s158 * _s211);
    const float _s219 = _s158 * _s205;
    const float _s220 = _s186 * _s208;
    const float _s221 = ((fabsf((-(bend_s * _s218))) * _s89) + (fabsf(((bend_e * _s219) * _s19)) * _s104)) + _s220;
    const float _s222 = _s221 + _s197;
    const float _s223 = ((_s163 / p_ball_radius) + _s204) + (fabsf((bend_e * ((nz * _s218) - _s142))) * _s104);
    const float _s224 = (_s223 + _s220) + _s201;
    const float _s225 = (((_s181 / p_ball_radius) + (_s165 * _s89)) + (fabsf((-(_s146 * _s219))) * _s104)) + _s220;
    const float _s226 = _s225 + _s201;
    const float _s227 = larger(_s222, _s226);
    const float _s228 = choose(_s63, (((float)1.0009765625) * ((((float)0.421875) * ((_s222 + _s224) + _s226)) + (((float)0.578125) * larger(_s227, _s224)))), ((float)INFINITE));
    return {choose(_s63, _s62, ((float)INFINITE)), choose(_s63, _s89, ((float)INFINITE)), choose(_s63, _s104, ((float)INFINITE)), choose(_s63, _s138, ((float)INFINITE)), choose(_s63, _s163, ((float)INFINITE)), choose(_s63, _s181, ((float)INFINITE)), choose(_s63, _s197, ((float)INFINITE)), choose(_s63, _s201, ((float)INFINITE)), _s203, _s217, _s228, nx, ny, nz, tangent_x, tangent_y, bend_s, bend_e, (((float)4.440892098500626e-16) * (t + clock)) + choose(_s63, (((float)1.0009765625) * _s45), ((float)INFINITE))};
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
   Table 2. No operations. */
struct kernel_backboard_normal_out {
    double nx, ny, nz;
};

static __device__ __forceinline__ kernel_backboard_normal_out kernel_backboard_normal()
{
    return {1.0, 0.0, 0.0};
}

/* Tangent and curvatures at a contact, and bounds on the roundings there.
   Table 2, running error analysis. 8 operations: 2 additions, 4 multiplications, 2 absolute values. */
struct kernel_backboard_tangents_out {
    float tangent_x, tangent_y, bend_s, bend_e, sharpest_bend, root_offset, root_level, normal_rounding;
};

static __device__ __forceinline__ kernel_backboard_tangents_out kernel_backboard_tangents(float t, float x, float vx)
{
    const float _s0 = ((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * (((((float)4.0) * t) * (((float)2.0) * fabsf(vx))) + fabsf(x)));
    return {(float)0.0, (float)1.0, (float)0.0, (float)0.0, (float)0.0, _s0, _s0, (float)0.0};
}

/* The g of Eq. 2: a contact counts if none is positive.
   Eq. 2, Table 2. 5 operations: 1 addition, 3 subtractions, 1 negation. */
struct kernel_backboard_bounds_out {
    double g0, g1, g2, g3;
};

static __device__ __forceinline__ kernel_backboard_bounds_out kernel_backboard_bounds(double y, double z, double p_board_half_width, double p_board_bottom, double p_board_top)
{
    return {-(p_board_half_width + y), y - p_board_half_width, p_board_bottom - z, z - p_board_top};
}

/* Time of the only arrival, the gap's first two derivatives there, and its apex.
   Eq. 3 in Table 2, solved. 9 operations: 2 subtractions, 1 division, 1 negation, 2 comparisons, 3 selections. */
struct kernel_backboard_arrival_out {
    double time, rate, bend, apex, height;
};

static __device__ __forceinline__ kernel_backboard_arrival_out kernel_backboard_arrival(double leaving, double x, double vx, double p_ball_radius, double p_board_distance)
{
    const bool _s0 = 0.0 < leaving;
    const double _s1 = choose(_s0, 0.0, (x - (p_ball_radius - p_board_distance)));
    return {-(_s1 / vx), vx, 0.0, 0.0, choose(_s0, choose((vx < 0.0), 0.0, (INFINITE)), _s1)};
}

/* Rounding-error bound of the gap up to the horizon.
   running error analysis. 15 operations: 7 additions, 8 multiplications. */
struct kernel_backboard_margin_out {
    double margin;
};

static __device__ __forceinline__ kernel_backboard_margin_out kernel_backboard_margin(double horizon, double extent, double speed, double position_error, double velocity_error, double p_ball_radius, double p_board_distance, double p_gravity)
{
    const double _s0 = extent + (horizon * (speed + (p_gravity * horizon)));
    return {(((6.667843360785852e-16 * p_ball_radius) + (8.890457814381136e-16 * p_board_distance)) + (2.222614453595284e-16 * _s0)) + (2.001953125 * ((position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * _s0)))};
}

/* Point of the contact plane nearest to a position.
   Table 2. 1 operation: 1 subtraction. */
struct kernel_backboard_place_out {
    double x, y, z;
};

static __device__ __forceinline__ kernel_backboard_place_out kernel_backboard_place(double y, double z, double p_ball_radius, double p_board_distance)
{
    return {p_ball_radius - p_board_distance, y, z};
}

/* Whether a contact counts (Eq. 2).
   Table 1. 7 operations: 4 comparisons, 3 conjunctions. */
struct kernel_backboard_within_out {
    bool arrives;
};

static __device__ __forceinline__ kernel_backboard_within_out kernel_backboard_within(double g0, double g1, double g2, double g3)
{
    return {(((g0 <= 0.0) && (g1 <= 0.0)) && (g2 <= 0.0)) && (g3 <= 0.0)};
}

/* Whether the bounds or the crossing lie within their errors.
   Table 1. 19 operations: 1 negation, 9 comparisons, 8 conjunctions, 1 complement. */
struct kernel_backboard_edges_out {
    bool undecided;
};

static __device__ __forceinline__ kernel_backboard_edges_out kernel_backboard_edges(double clearance, double slack, double g0, double g1, double g2, double g3)
{
    const double _s0 = -slack;
    const bool _s1 = !(((((g0 < _s0) && (g1 < _s0)) && (g2 < _s0)) && (g3 < _s0)) && (0.0 < clearance));
    return {((((g0 <= slack) && (g1 <= slack)) && (g2 <= slack)) && (g3 <= slack)) && _s1};
}

/* Outward unit normal n3 at a contact.
   Table 2. No operations. */
struct kernel_bridge_normal_out {
    double nx, ny, nz;
};

static __device__ __forceinline__ kernel_bridge_normal_out kernel_bridge_normal()
{
    return {0.0, 0.0, 1.0};
}

/* Tangent and curvatures at a contact, and bounds on the roundings there.
   Table 2, running error analysis. 12 operations: 4 additions, 5 multiplications, 3 absolute values. */
struct kernel_bridge_tangents_out {
    float tangent_x, tangent_y, bend_s, bend_e, sharpest_bend, root_offset, root_level, normal_rounding;
};

static __device__ __forceinline__ kernel_bridge_tangents_out kernel_bridge_tangents(float t, float z, float vz, float p_gravity)
{
    const float _s0 = (((float)4.0) * t) * (fabsf(vz) + fabsf((vz + ((((float)0.5) * p_gravity) * t))));
    const float _s1 = ((float)7.888609052210118e-31) + (((float)1.1102230246251565e-16) * (_s0 + fabsf(z)));
    return {(float)0.0, (float)1.0, (float)0.0, (float)0.0, (float)0.0, _s1, _s1, (float)0.0};
}

/* The g of Eq. 2: a contact counts if none is positive.
   Eq. 2, Table 2. 10 operations: 3 additions, 2 subtractions, 2 multiplications, 1 square root, 2 negations. */
struct kernel_bridge_bounds_out {
    double g0, g1, g2, g3, g4;
};

static __device__ __forceinline__ kernel_bridge_bounds_out kernel_bridge_bounds(double x, double y, double p_ring_radius, double p_board_distance, double p_bridge_half_width)
{
    return {-(p_bridge_half_width + y), y - p_bridge_half_width, p_ring_radius - sqrt(((x * x) + (y * y))), x, -(p_board_distance + x)};
}

/* Time of the only arrival, the gap's first two derivatives there, and its apex.
   Eq. 3 in Table 2, solved. 29 operations: 3 additions, 2 subtractions, 7 multiplications, 2 divisions, 1 square root, 5 negations, 1 absolute value, 2 comparisons, 6 selections. */
struct kernel_bridge_arrival_out {
    double time, rate, bend, apex, height;
};

static __device__ __forceinline__ kernel_bridge_arrival_out kernel_bridge_arrival(double leaving, double z, double vz, double p_ball_radius, double p_wire_radius, double p_gravity)
{
    const bool _s0 = 0.0 < leaving;
    const double _s1 = choose(_s0, 0.0, (z - (p_ball_radius + p_wire_radius)));
    const double _s2 = (vz * vz) + ((2.0 * p_gravity) * _s1);
    const double _s3 = choose(_s0, fabs(vz), sqrt(_s2));
    const bool _s4 = vz < 0.0;
    const double _s5 = -(1.0 / p_gravity);
    return {choose(_s4, (2.0 * _s1), (vz + _s3)) / choose(_s4, (_s3 - vz), p_gravity), -_s3, -p_gravity, choose(_s4, 0.0, (-(vz * _s5))), choose(_s4, _s1, (-((0.5 * _s5) * _s2)))};
}

/* Rounding-error bound of the gap up to the horizon.
   running error analysis. 15 operations: 7 additions, 8 multiplications. */
struct kernel_bridge_margin_out {
    double margin;
};

static __device__ __forceinline__ kernel_bridge_margin_out kernel_bridge_margin(double horizon, double extent, double speed, double position_error, double velocity_error, double p_ball_radius, double p_wire_radius, double p_gravity)
{
    const double _s0 = extent + (horizon * (speed + (p_gravity * horizon)));
    return {(((6.667843360785852e-16 * p_ball_radius) + (6.667843360785852e-16 * p_wire_radius)) + (2.222614453595284e-16 * _s0)) + (2.001953125 * ((position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * _s0)))};
}

/* Point of the contact plane nearest to a position.
   Table 2. 1 operation: 1 addition. */
struct kernel_bridge_place_out {
    double x, y, z;
};

static __device__ __forceinline__ kernel_bridge_place_out kernel_bridge_place(double x, double y, double p_ball_radius, double p_wire_radius)
{
    return {x, y, p_ball_radius + p_wire_radius};
}

/* Whether a contact counts (Eq. 2).
   Table 1. 9 operations: 5 comparisons, 4 conjunctions. */
struct kernel_bridge_within_out {
    bool arrives;
};

static __device__ __forceinline__ kernel_bridge_within_out kernel_bridge_within(double g0, double g1, double g2, double g3, double g4)
{
    return {((((g0 <= 0.0) && (g1 <= 0.0)) && (g2 <= 0.0)) && (g3 <= 0.0)) && (g4 <= 0.0)};
}

/* Whether the bounds or the crossing lie within their errors.
   Table 1. 23 operations: 1 negation, 11 comparisons, 10 conjunctions, 1 complement. */
struct kernel_bridge_edges_out {
    bool undecided;
};

static __device__ __forceinline__ kernel_bridge_edges_out kernel_bridge_edges(double clearance, double slack, double g0, double g1, double g2, double g3, double g4)
{
    const double _s0 = -slack;
    const bool _s1 = (((((g0 < _s0) && (g1 < _s0)) && (g2 < _s0)) && (g3 < _s0)) && (g4 < _s0)) && (0.0 < clearance);
    const bool _s2 = (((((g0 <= slack) && (g1 <= slack)) && (g2 <= slack)) && (g3 <= slack)) && (g4 <= slack)) && (!_s1);
    return {_s2};
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

/* End that a crossing reaches.
   Table 1. 2 operations: 1 comparison, 1 selection. */
struct kernel_end_reached_out {
    double reached;
};

static __device__ __forceinline__ kernel_end_reached_out kernel_end_reached(double g0)
{
    return {choose((g0 <= 0.0), 0.0, 1.0)};
}

/* Whether the choice of the end lies within its error.
   Table 1. 5 operations: 1 negation, 2 comparisons, 1 conjunction, 1 complement. */
struct kernel_end_edge_out {
    bool edge;
};

static __device__ __forceinline__ kernel_end_edge_out kernel_end_edge(double slack, double g0)
{
    return {(g0 <= slack) && (!(g0 < (-slack)))};
}

/* The event loop is given
   _shots             how many there are; the log counts them from `_first` on
   _states            x y z vx vy vz wx wy wz of each
   _values, _strides  where each parameter's values are, and the step from one shot's to the next one's
   _leaving           the surface that each shot touches at the start and leaves, -1 for none; or null
   _results           the arrays of results, null for what is not wanted:
                      outcome, contacts, counts, first, time, state, time_error, state_error, uncertain;
                      and of the event log, which has _max_contacts + 1 rows
                      for each shot, of their number, and of bounds on their errors: events,
                      event_counts, event_errors */

/* The event loop. Without BOUNDS, what it guards is never compiled, and what it would assign stays as it starts.
   With `tightening` 1 bounds on errors are tightened, and only what needs them is written. Return whether
   that may make a shot certain that is not yet. */
template <bool BOUNDS>
static __device__ __forceinline__ bool hoop_loop(
    long long _shots, long long _first, const double *_states, const double *const *_values,
    const long long *_strides, const signed char *_leaving, int _max_contacts, double time_limit,
    void *const *_results, double tightening)
{
    const long long _shot = blockIdx.x * (long long)blockDim.x + threadIdx.x;
    if (_shot >= _shots)
        return false;
    const bool _tightens = BOUNDS && tightening > 0.0;
    const shot_parameters _given = {_values, _strides, _shot};
    const double most_contacts = (double)_max_contacts;
    const double claims = !BOUNDS ? 0.0 : _results[11] ? 2.0 : _results[6] || _results[7] ? 1.0 : 0.0;
    const double p_ball_radius = parameter(_given, 0);
    const double p_ring_radius = parameter(_given, 1);
    const double p_wire_radius = parameter(_given, 2);
    const double p_board_distance = parameter(_given, 3);
    const double p_board_half_width = parameter(_given, 4);
    const double p_board_bottom = parameter(_given, 5);
    const double p_board_top = parameter(_given, 6);
    const double p_bridge_half_width = parameter(_given, 7);
    const double p_restitution = parameter(_given, 8);
    const double p_gravity = parameter(_given, 9);
    const double p_end_depth = parameter(_given, 10);

    double x = 0.0, y = 0.0, z = 0.0, vx = 0.0, vy = 0.0, vz = 0.0, wx = 0.0, wy = 0.0, wz = 0.0,
        clock = 0.0, last = 0.0, first = -1.0, contacts = 0.0, count_0 = 0.0, count_1 = 0.0,
        count_2 = 0.0, uncertain = 0.0, outcome = -1.0, allowed = 0.0, valid = 0.0,
        undecided_time = INFINITE, extent = 0.0, speed = 0.0, excess = 0.0, when = 0.0,
        which = 0.0, earliest_delay = 0.0, leaving = 0.0, time = 0.0, rate = 0.0, bend = 0.0,
        apex = 0.0, height = 0.0, ceiling = 0.0, nearest = 0.0, margin = 0.0, clearance = 0.0,
        delay = 0.0, until = 0.0, pad = 0.0, there_y = 0.0, there_z = 0.0, g0 = 0.0, g1 = 0.0,
        g2 = 0.0, g3 = 0.0, slack = 0.0, there_x = 0.0, g4 = 0.0, clear = 0.0, share = 0.0,
        arrival = 0.0, since = 0.0, latest = 0.0, rho_start = 0.0, start_rate = 0.0,
        rho_rate = 0.0, near_x = 0.0, near_y = 0.0, near_z = 0.0, near_vz = 0.0, flat = 0.0,
        tilt = 0.0, allowing = 0.0, budget_exceeded = 0.0, t = 0.0, energy2 = 0.0, moment2 = 0.0,
        low0 = 0.0, high0 = 0.0, low1 = 0.0, high1 = 0.0, low2 = 0.0, high2 = 0.0,
        position_level = 0.0, velocity_level = 0.0, rate_slack = 0.0, end = 0.0, gap = 0.0,
        step = 0.0, next = 0.0, refined = 0.0, rate_margin = 0.0, reached = 0.0, body = 0.0,
        nx = 0.0, ny = 0.0, nz = 0.0, normal_velocity = 0.0, back = 0.0;
    float place_n = (float)0.0, place_s = (float)0.0, place_e = (float)0.0, pace_n = (float)0.0,
        pace_s = (float)0.0, pace_e = (float)0.0, turn_n = (float)0.0, turn_z = (float)0.0,
        position_bound = (float)0.0, velocity_bound = (float)0.0, spin_bound = (float)0.0,
        left_nx = (float)0.0, left_ny = (float)0.0, left_nz = (float)0.0, left_ex = (float)0.0,
        left_ey = (float)0.0, left_bend_s = (float)0.0, left_bend_e = (float)0.0,
        origin_s = (float)0.0, origin_e = (float)0.0, origin_u = (float)0.0, origin_v = (float)0.0,
        origin_w = (float)0.0, origin_t = (float)0.0, product_11 = (float)0.0,
        product_12 = (float)0.0, product_13 = (float)0.0, product_14 = (float)0.0,
        product_15 = (float)0.0, product_16 = (float)0.0, product_21 = (float)0.0,
        product_22 = (float)0.0, product_23 = (float)0.0, product_24 = (float)0.0,
        product_25 = (float)0.0, product_26 = (float)0.0, product_31 = (float)0.0,
        product_32 = (float)0.0, product_33 = (float)0.0, product_34 = (float)0.0,
        product_35 = (float)0.0, product_36 = (float)0.0, product_41 = (float)0.0,
        product_42 = (float)0.0, product_43 = (float)0.0, product_44 = (float)0.0,
        product_45 = (float)0.0, product_46 = (float)0.0, product_51 = (float)0.0,
        product_52 = (float)0.0, product_53 = (float)0.0, product_54 = (float)0.0,
        product_55 = (float)0.0, product_56 = (float)0.0, product_61 = (float)0.0,
        product_62 = (float)0.0, product_63 = (float)0.0, product_64 = (float)0.0,
        product_65 = (float)0.0, product_66 = (float)0.0, recent_s = (float)0.0,
        recent_e = (float)0.0, recent_u = (float)0.0, recent_v = (float)0.0, recent_w = (float)0.0,
        recent_t = (float)0.0, continued = (float)0.0, clock_error = (float)0.0,
        position_claim = (float)0.0, velocity_claim = (float)0.0, spin_claim = (float)0.0,
        time_claim = (float)0.0, position_error = (float)0.0, velocity_error = (float)0.0,
        time_error = (float)0.0, onset = (float)0.0, wide_end = (float)0.0, wide_low1 = (float)0.0,
        wide_high1 = (float)0.0, wide_low2 = (float)0.0, wide_high2 = (float)0.0,
        lapsed = (float)0.0, short_share = (float)0.0, short_t = (float)0.0,
        short_end = (float)0.0, short_x = (float)0.0, short_y = (float)0.0, short_z = (float)0.0,
        short_vx = (float)0.0, short_vy = (float)0.0, short_vz = (float)0.0,
        short_energy2 = (float)0.0, short_moment2 = (float)0.0, short_rho_start = (float)0.0,
        short_ceiling = (float)0.0, short_flat = (float)0.0, short_tilt = (float)0.0,
        short_jerk = (float)0.0, short_quotient_margin = (float)0.0, short_start_rate = (float)0.0,
        short_rho_rate = (float)0.0, short_rate_margin = (float)0.0, short_low1 = (float)0.0,
        short_high1 = (float)0.0, short_low2 = (float)0.0, short_high2 = (float)0.0,
        tangent_x = (float)0.0, tangent_y = (float)0.0, bend_s = (float)0.0, bend_e = (float)0.0,
        sharpest_bend = (float)0.0, root_offset = (float)0.0, root_level = (float)0.0,
        normal_rounding = (float)0.0, belated = (float)0.0;
    bool permitted = false, in_range = false, close = false, limited = false, arrives = false,
        possible = false, released = false, reachable = false, undecided = false, open = false,
        certain = false, searching = false, representable = false, fits = false, stepping = false,
        single_precision = false, hit = false, sure = false, needs_refinement = false,
        exhausted = false, refining = false, moves = false, ends = false, touches = false,
        edge = false, here = false, meeting = false, carries = false, tightens = false,
        unbounded = false, ends_by_time_limit = false, reports = false, loose = false;
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

    hoop_event *_events = (hoop_event *)_results[9];
    hoop_event_errors *_errors = BOUNDS ? (hoop_event_errors *)_results[11] : 0;
    if (_tightens && !_errors)
        _events = 0;
    int _used = 0;
    const long long _rows = _shot * (1 * (long long)_max_contacts + 1);
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
    const kernel_aside_out _o3 = kernel_aside(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_end_depth);
    close = _o3.close;
    valid = _o3.valid;
    if (BOUNDS)
        undecided_time = _o3.undecided_time;
    if (close) {
        const kernel_valid_out _o4 = kernel_valid(last, x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_end_depth);
        valid = _o4.valid;
        if (BOUNDS)
            undecided_time = _o4.undecided_time;
    }
    const kernel_admitted_out _o5 = kernel_admitted(undecided_time, valid, permitted, in_range);
    outcome = _o5.outcome;
    if (BOUNDS)
        uncertain = _o5.uncertain;

    while (outcome < 0.0) {
        /* To the next event. */
        const kernel_error_bounds_out _o6 = kernel_error_bounds(clock_error, position_bound, velocity_bound, spin_bound);
        time_error = _o6.time_error;
        if (BOUNDS) {
            position_error = _o6.position_error;
            velocity_error = _o6.velocity_error;
        }
        const kernel_scale_out _o7 = kernel_scale(x, y, z, vx, vy, vz, p_gravity);
        extent = _o7.extent;
        speed = _o7.speed;
        excess = _o7.excess;
        const kernel_opening_out _o8 = kernel_opening(excess, position_error, velocity_error);
        when = _o8.when;
        which = _o8.which;
        if (BOUNDS) {
            earliest_delay = _o8.earliest_delay;
            undecided_time = _o8.undecided_time;
        }
        const kernel_limited_out _o9 = kernel_limited(time_limit);
        limited = _o9.limited;
        const kernel_left_out _o10 = kernel_left(3.0, last);
        leaving = _o10.leaving;
        const kernel_end_arrival_out _o11 = kernel_end_arrival(leaving, z, vz, p_gravity, p_end_depth);
        time = _o11.time;
        rate = _o11.rate;
        bend = _o11.bend;
        apex = _o11.apex;
        if (BOUNDS)
            height = _o11.height;
        const kernel_plane_root_out _o12 = kernel_plane_root(rate, bend, apex, time);
        arrives = _o12.arrives;
        if (BOUNDS) {
            ceiling = _o12.ceiling;
            nearest = _o12.nearest;
        }
        if (BOUNDS) {
            const kernel_end_margin_out _o13 = kernel_end_margin(nearest, extent, speed, position_error, velocity_error, p_gravity, p_end_depth);
            margin = _o13.margin;
            const kernel_crossing_out _o14 = kernel_crossing(margin, 0.0, rate, ceiling);
            clearance = _o14.clearance;
            delay = _o14.delay;
        }
        const kernel_within_time_out _o15 = kernel_within_time(time, when, delay, earliest_delay, arrives);
        possible = _o15.possible;
        if (BOUNDS) {
            const kernel_apex_undecided_out _o16 = kernel_apex_undecided(margin, apex, height, undecided_time);
            undecided_time = _o16.undecided_time;
        }
        if (possible) {
            if (BOUNDS) {
                const kernel_crossing_undecided_out _o17 = kernel_crossing_undecided(clearance, time, undecided_time, arrives);
                undecided_time = _o17.undecided_time;
                const kernel_tie_undecided_out _o18 = kernel_tie_undecided(time, when, delay, earliest_delay, undecided_time, arrives);
                undecided_time = _o18.undecided_time;
                earliest_delay = _o18.earliest_delay;
            }
            const kernel_earliest_out _o19 = kernel_earliest(3.0, time, when, which, arrives);
            when = _o19.when;
            which = _o19.which;
        }
        const kernel_released_out _o20 = kernel_released(last);
        released = _o20.released;
        reachable = _o20.reachable;
        if (released) {
            const kernel_horizon_out _o21 = kernel_horizon(when, speed, p_gravity);
            until = _o21.horizon;
            pad = _o21.pad;
            const kernel_reachable_out _o22 = kernel_reachable(p_ball_radius, p_board_distance, p_bridge_half_width, p_gravity, p_ring_radius, x, vx, until, extent, speed, pad, earliest_delay, position_error, velocity_error);
            reachable = _o22.reachable;
        }
        if (reachable) {
            const kernel_left_out _o23 = kernel_left(1.0, last);
            leaving = _o23.leaving;
            const kernel_backboard_arrival_out _o24 = kernel_backboard_arrival(leaving, x, vx, p_ball_radius, p_board_distance);
            time = _o24.time;
            rate = _o24.rate;
            bend = _o24.bend;
            height = _o24.height;
            const kernel_level_root_out _o25 = kernel_level_root(rate, bend, height, time, when);
            arrives = _o25.arrives;
            if (BOUNDS) {
                ceiling = _o25.ceiling;
                nearest = _o25.nearest;
            }
            if (BOUNDS) {
                const kernel_backboard_margin_out _o26 = kernel_backboard_margin(nearest, extent, speed, position_error, velocity_error, p_ball_radius, p_board_distance, p_gravity);
                margin = _o26.margin;
                const kernel_crossing_out _o27 = kernel_crossing(margin, 0.0, rate, ceiling);
                clearance = _o27.clearance;
                delay = _o27.delay;
            }
            const kernel_within_time_out _o28 = kernel_within_time(time, when, delay, earliest_delay, arrives);
            possible = _o28.possible;
            if (BOUNDS) {
                const kernel_side_undecided_out _o29 = kernel_side_undecided(rate, margin, height, undecided_time, velocity_error);
                undecided_time = _o29.undecided_time;
            }
            if (possible) {
                const kernel_flight_out _o30 = kernel_flight(time, x, y, z, vx, vy, vz, p_gravity);
                there_y = _o30.y;
                there_z = _o30.z;
                const kernel_backboard_bounds_out _o31 = kernel_backboard_bounds(there_y, there_z, p_board_half_width, p_board_bottom, p_board_top);
                g0 = _o31.g0;
                g1 = _o31.g1;
                g2 = _o31.g2;
                g3 = _o31.g3;
                if (BOUNDS) {
                    const kernel_displacement_out _o32 = kernel_displacement(delay, time, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_gravity, p_end_depth);
                    slack = _o32.margin;
                    const kernel_backboard_edges_out _o33 = kernel_backboard_edges(clearance, slack, g0, g1, g2, g3);
                    undecided = _o33.undecided;
                    const kernel_bounds_undecided_out _o34 = kernel_bounds_undecided(time, undecided_time, undecided);
                    undecided_time = _o34.undecided_time;
                }
                const kernel_backboard_within_out _o35 = kernel_backboard_within(g0, g1, g2, g3);
                arrives = _o35.arrives;
                if (BOUNDS) {
                    const kernel_tie_undecided_out _o36 = kernel_tie_undecided(time, when, delay, earliest_delay, undecided_time, arrives);
                    undecided_time = _o36.undecided_time;
                    earliest_delay = _o36.earliest_delay;
                }
                const kernel_earliest_out _o37 = kernel_earliest(1.0, time, when, which, arrives);
                when = _o37.when;
                which = _o37.which;
            }
            const kernel_left_out _o38 = kernel_left(2.0, last);
            leaving = _o38.leaving;
            const kernel_bridge_arrival_out _o39 = kernel_bridge_arrival(leaving, z, vz, p_ball_radius, p_wire_radius, p_gravity);
            time = _o39.time;
            rate = _o39.rate;
            bend = _o39.bend;
            apex = _o39.apex;
            if (BOUNDS)
                height = _o39.height;
            const kernel_plane_root_out _o40 = kernel_plane_root(rate, bend, apex, time);
            arrives = _o40.arrives;
            if (BOUNDS) {
                ceiling = _o40.ceiling;
                nearest = _o40.nearest;
            }
            if (BOUNDS) {
                const kernel_bridge_margin_out _o41 = kernel_bridge_margin(nearest, extent, speed, position_error, velocity_error, p_ball_radius, p_wire_radius, p_gravity);
                margin = _o41.margin;
                const kernel_crossing_out _o42 = kernel_crossing(margin, 0.0, rate, ceiling);
                clearance = _o42.clearance;
                delay = _o42.delay;
            }
            const kernel_within_time_out _o43 = kernel_within_time(time, when, delay, earliest_delay, arrives);
            possible = _o43.possible;
            if (BOUNDS) {
                const kernel_apex_undecided_out _o44 = kernel_apex_undecided(margin, apex, height, undecided_time);
                undecided_time = _o44.undecided_time;
            }
            if (possible) {
                const kernel_flight_out _o45 = kernel_flight(time, x, y, z, vx, vy, vz, p_gravity);
                there_x = _o45.x;
                there_y = _o45.y;
                const kernel_bridge_bounds_out _o46 = kernel_bridge_bounds(there_x, there_y, p_ring_radius, p_board_distance, p_bridge_half_width);
                g0 = _o46.g0;
                g1 = _o46.g1;
                g2 = _o46.g2;
                g3 = _o46.g3;
                g4 = _o46.g4;
                if (BOUNDS) {
                    const kernel_displacement_out _o47 = kernel_displacement(delay, time, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_gravity, p_end_depth);
                    slack = _o47.margin;
                    const kernel_bridge_edges_out _o48 = kernel_bridge_edges(clearance, slack, g0, g1, g2, g3, g4);
                    undecided = _o48.undecided;
                    const kernel_bounds_undecided_out _o49 = kernel_bounds_undecided(time, undecided_time, undecided);
                    undecided_time = _o49.undecided_time;
                }
                const kernel_bridge_within_out _o50 = kernel_bridge_within(g0, g1, g2, g3, g4);
                arrives = _o50.arrives;
                if (BOUNDS) {
                    const kernel_tie_undecided_out _o51 = kernel_tie_undecided(time, when, delay, earliest_delay, undecided_time, arrives);
                    undecided_time = _o51.undecided_time;
                    earliest_delay = _o51.earliest_delay;
                }
                const kernel_earliest_out _o52 = kernel_earliest(2.0, time, when, which, arrives);
                when = _o52.when;
                which = _o52.which;
            }
            if (BOUNDS) {
                const kernel_plane_start_out _o53 = kernel_plane_start(p_gravity, undecided_time, position_error, velocity_error);
                undecided_time = _o53.undecided_time;
            }
        }
        const kernel_horizon_out _o54 = kernel_horizon(when, speed, p_gravity);
        until = _o54.horizon;
        if (BOUNDS)
            pad = _o54.pad;
        if (BOUNDS) {
            const kernel_overdue_out _o55 = kernel_overdue(pad, earliest_delay, undecided_time);
            undecided_time = _o55.undecided_time;
        }
        const kernel_ring_clear_out _o56 = kernel_ring_clear(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
        clear = _o56.clear;
        const kernel_opens_out _o57 = kernel_opens(clear);
        open = _o57.open;
        if (open) {
            const kernel_beginning_out _o58 = kernel_beginning();
            share = _o58.share;
            arrival = _o58.arrival;
            certain = _o58.certain;
            const kernel_left_out _o59 = kernel_left(0.0, last);
            leaving = _o59.leaving;
            const kernel_ring_opened_out _o60 = kernel_ring_opened(until, x, y, z, vx, vy, vz, extent, speed, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            onset = _o60.t;
            wide_end = _o60.end;
            searching = _o60.searching;
            wide_low1 = _o60.low1;
            wide_high1 = _o60.high1;
            wide_low2 = _o60.low2;
            wide_high2 = _o60.high2;
            lapsed = _o60.latest;
            representable = _o60.representable;
            const kernel_opened_out _o61 = kernel_opened(lapsed, onset);
            since = _o61.time;
            if (BOUNDS)
                latest = _o61.latest;
            const kernel_ring_started_out _o62 = kernel_ring_started(x, y, z, vx, vy, vz, p_ring_radius);
            rho_start = _o62.rho_start;
            start_rate = _o62.start_rate;
            rho_rate = _o62.rho_rate;
            const kernel_flight_out _o63 = kernel_flight(since, x, y, z, vx, vy, vz, p_gravity);
            near_x = _o63.x;
            near_y = _o63.y;
            near_z = _o63.z;
            near_vz = _o63.vz;
            const kernel_ring_resolution_out _o64 = kernel_ring_resolution(onset, wide_end, leaving, lapsed, near_x, near_y, near_z, vx, vy, near_vz, extent, speed, start_rate, rho_rate, wide_low1, wide_high1, wide_low2, wide_high2, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
            short_share = _o64.share;
            short_t = _o64.t;
            short_end = _o64.end;
            short_x = _o64.x;
            short_y = _o64.y;
            short_z = _o64.z;
            short_vx = _o64.vx;
            short_vy = _o64.vy;
            short_vz = _o64.vz;
            short_energy2 = _o64.energy2;
            short_moment2 = _o64.moment2;
            short_rho_start = _o64.rho_start;
            short_ceiling = _o64.ceiling;
            short_flat = _o64.flat;
            short_tilt = _o64.tilt;
            short_jerk = _o64.jerk;
            short_quotient_margin = _o64.quotient_margin;
            short_start_rate = _o64.start_rate;
            short_rho_rate = _o64.rho_rate;
            short_rate_margin = _o64.rate_margin;
            short_low1 = _o64.low1;
            short_high1 = _o64.high1;
            short_low2 = _o64.low2;
            short_high2 = _o64.high2;
            fits = _o64.fits;
            const kernel_coarse_out _o65 = kernel_coarse(short_rate_margin, short_flat, short_ceiling, short_share, searching, representable, fits);
            stepping = _o65.stepping;
            searching = _o65.searching;
            single_precision = _o65.single_precision;
            ceiling = _o65.ceiling;
            flat = _o65.flat;
            tilt = _o65.tilt;
            if (BOUNDS)
                allowing = _o65.allowing;
            if (BOUNDS) {
                const kernel_ring_coarse_excess_out _o66 = kernel_ring_coarse_excess(allowing, latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                excess = _o66.excess;
                const kernel_ring_budget_exceeded_out _o67 = kernel_ring_budget_exceeded(until, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                budget_exceeded = _o67.budget_exceeded;
                const kernel_out_of_budget_out _o68 = kernel_out_of_budget(pad, budget_exceeded, earliest_delay, undecided_time, excess);
                undecided_time = _o68.undecided_time;
            }
            if (stepping) {
                const kernel_ring_step_out _o69 = kernel_ring_step(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_energy2, short_moment2, short_rho_start, short_flat, short_tilt, short_quotient_margin, short_jerk, short_start_rate, short_rho_rate, short_low1, short_high1, short_low2, short_high2, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                short_t = _o69.t;
                short_end = _o69.end;
                certain = _o69.certain;
                stepping = _o69.stepping;
            }
            for (size_t _turn = 0; _turn < 24; _turn++) {
                if (!stepping)
                    break;
                const kernel_ring_step_out _o70 = kernel_ring_step(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_energy2, short_moment2, short_rho_start, short_flat, short_tilt, short_quotient_margin, short_jerk, short_start_rate, short_rho_rate, short_low1, short_high1, short_low2, short_high2, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                short_t = _o70.t;
                short_end = _o70.end;
                certain = _o70.certain;
                stepping = _o70.stepping;
            }
            const kernel_stepped_out _o71 = kernel_stepped(arrival, short_t, searching, since, single_precision, certain);
            arrival = _o71.arrival;
            t = _o71.t;
            searching = _o71.searching;
            if (searching) {
                const kernel_ring_prepare_out _o72 = kernel_ring_prepare(until, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                energy2 = _o72.energy2;
                moment2 = _o72.moment2;
                rho_start = _o72.rho_start;
                low0 = _o72.low0;
                high0 = _o72.high0;
                low1 = _o72.low1;
                high1 = _o72.high1;
                low2 = _o72.low2;
                high2 = _o72.high2;
                ceiling = _o72.ceiling;
                latest = _o72.latest;
                if (BOUNDS) {
                    const kernel_ring_excess_out _o73 = kernel_ring_excess(share, latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    excess = _o73.excess;
                }
                const kernel_allowance_out _o74 = kernel_allowance(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                position_level = _o74.position_level;
                velocity_level = _o74.velocity_level;
                const kernel_ring_margins_out _o75 = kernel_ring_margins(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                flat = _o75.margin;
                tilt = _o75.leaving_margin;
                rate_slack = _o75.rate_margin;
                if (BOUNDS) {
                    const kernel_budget_undecided_out _o76 = kernel_budget_undecided(t, undecided_time, excess);
                    undecided_time = _o76.undecided_time;
                }
                const kernel_ring_enter_out _o77 = kernel_ring_enter(t, 0.0, t, low0, low1, low2, high0, high1, high2);
                t = _o77.t;
                end = _o77.end;
                searching = _o77.searching;
                for (size_t _turn = 0; _turn < 201; _turn++) {
                    if (!searching)
                        break;
                    const kernel_nearby_out _o78 = kernel_nearby(t, flat, tilt, 0.0, last);
                    leaving = _o78.leaving;
                    margin = _o78.margin;
                    const kernel_ring_advance_out _o79 = kernel_ring_advance(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, energy2, moment2, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    gap = _o79.gap;
                    rate = _o79.rate;
                    bend = _o79.bend;
                    step = _o79.step;
                    next = _o79.next;
                    clearance = _o79.clearance;
                    const kernel_gap_closes_out _o80 = kernel_gap_closes(gap, rate, bend, margin, rate_slack, clearance, share);
                    hit = _o80.hit;
                    sure = _o80.sure;
                    needs_refinement = _o80.needs_refinement;
                    if (needs_refinement) {
                        const kernel_smaller_budget_out _o81 = kernel_smaller_budget(share);
                        share = _o81.share;
                        if (BOUNDS) {
                            const kernel_ring_excess_out _o82 = kernel_ring_excess(share, latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                            excess = _o82.excess;
                        }
                        const kernel_allowance_out _o83 = kernel_allowance(share, latest, extent, speed, position_error, velocity_error, p_gravity);
                        position_level = _o83.position_level;
                        velocity_level = _o83.velocity_level;
                        const kernel_ring_margins_out _o84 = kernel_ring_margins(latest, extent, speed, position_level, velocity_level, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                        flat = _o84.margin;
                        tilt = _o84.leaving_margin;
                        rate_slack = _o84.rate_margin;
                        if (BOUNDS) {
                            const kernel_budget_undecided_out _o85 = kernel_budget_undecided(t, undecided_time, excess);
                            undecided_time = _o85.undecided_time;
                        }
                    }
                    const kernel_advanced_out _o86 = kernel_advanced(t, end, step, next, arrival, hit, sure, needs_refinement, certain);
                    arrival = _o86.arrival;
                    certain = _o86.certain;
                    exhausted = _o86.exhausted;
                    searching = _o86.searching;
                    t = _o86.t;
                    if (exhausted) {
                        const kernel_ring_enter_out _o87 = kernel_ring_enter(t, end, end, low0, low1, low2, high0, high1, high2);
                        t = _o87.t;
                        end = _o87.end;
                        searching = _o87.searching;
                    }
                }
                if (BOUNDS) {
                    const kernel_predicate_undecided_out _o88 = kernel_predicate_undecided(t, undecided_time, searching);
                    undecided_time = _o88.undecided_time;
                }
            }
            const kernel_found_out _o89 = kernel_found(arrival);
            arrives = _o89.arrives;
            refining = _o89.refining;
            if (BOUNDS)
                rate = _o89.rate;
            const kernel_nearby_out _o90 = kernel_nearby(arrival, flat, tilt, 0.0, last);
            leaving = _o90.leaving;
            if (refining) {
                const kernel_ring_refine_out _o91 = kernel_ring_refine(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                refined = _o91.time;
                gap = _o91.gap;
                rate = _o91.rate;
                const kernel_refined_root_out _o92 = kernel_refined_root(gap, rate, ceiling, arrival, refined, certain);
                arrival = _o92.arrival;
                refining = _o92.refining;
            }
            if (refining) {
                const kernel_ring_refine_out _o93 = kernel_ring_refine(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                refined = _o93.time;
                gap = _o93.gap;
                rate = _o93.rate;
                const kernel_refined_root_out _o94 = kernel_refined_root(gap, rate, ceiling, arrival, refined, certain);
                arrival = _o94.arrival;
                refining = _o94.refining;
            }
            for (size_t _turn = 0; _turn < 8; _turn++) {
                if (!refining)
                    break;
                const kernel_ring_refine_out _o95 = kernel_ring_refine(arrival, leaving, x, y, z, vx, vy, vz, rho_start, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                refined = _o95.time;
                gap = _o95.gap;
                rate = _o95.rate;
                const kernel_refined_root_out _o96 = kernel_refined_root(gap, rate, ceiling, arrival, refined, certain);
                arrival = _o96.arrival;
                refining = _o96.refining;
            }
            if (BOUNDS) {
                const kernel_ring_margins_out _o97 = kernel_ring_margins(latest, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                flat = _o97.margin;
                tilt = _o97.leaving_margin;
                rate_margin = _o97.rate_margin;
                const kernel_own_margin_out _o98 = kernel_own_margin(leaving, flat, tilt, arrival);
                margin = _o98.margin;
                const kernel_crossing_out _o99 = kernel_crossing(margin, rate_margin, rate, ceiling);
                clearance = _o99.clearance;
                delay = _o99.delay;
            }
            const kernel_arrival_time_out _o100 = kernel_arrival_time(arrival);
            time = _o100.time;
            if (BOUNDS) {
                const kernel_arrival_certainty_out _o101 = kernel_arrival_certainty(clearance, time, delay, undecided_time, arrives, certain);
                delay = _o101.delay;
                undecided_time = _o101.undecided_time;
                const kernel_tie_undecided_out _o102 = kernel_tie_undecided(time, when, delay, earliest_delay, undecided_time, arrives);
                undecided_time = _o102.undecided_time;
                earliest_delay = _o102.earliest_delay;
            }
            const kernel_earliest_out _o103 = kernel_earliest(0.0, time, when, which, arrives);
            when = _o103.when;
            which = _o103.which;
        }
        if (limited) {
            const kernel_expiry_out _o104 = kernel_expiry(when, which, earliest_delay, undecided_time, time_error, clock, time_limit);
            time = _o104.time;
            arrives = _o104.arrives;
            if (BOUNDS) {
                delay = _o104.delay;
                undecided_time = _o104.undecided_time;
            }
            if (BOUNDS) {
                const kernel_tie_undecided_out _o105 = kernel_tie_undecided(time, when, delay, earliest_delay, undecided_time, arrives);
                undecided_time = _o105.undecided_time;
                earliest_delay = _o105.earliest_delay;
            }
            const kernel_earliest_out _o106 = kernel_earliest(4.0, time, when, which, arrives);
            when = _o106.when;
            which = _o106.which;
        }
        const kernel_departed_out _o107 = kernel_departed(3.0, which);
        moves = _o107.moves;
        ends = _o107.ends;
        touches = _o107.touches;
        reached = _o107.reached;
        if (BOUNDS)
            edge = _o107.edge;
        const kernel_body_of_out _o108 = kernel_body_of(which);
        body = _o108.body;
        if (moves) {
            const kernel_flight_out _o109 = kernel_flight(when, x, y, z, vx, vy, vz, p_gravity);
            x = _o109.x;
            y = _o109.y;
            z = _o109.z;
            vx = _o109.vx;
            vy = _o109.vy;
            vz = _o109.vz;
            const kernel_event_clock_out _o110 = kernel_event_clock(when, clock);
            clock = _o110.clock;
        }
        if (limited) {
            const kernel_expired_out _o111 = kernel_expired(4.0, which, body, clock, reached, time_limit, ends);
            clock = _o111.clock;
            body = _o111.body;
            reached = _o111.reached;
            ends = _o111.ends;
        }
        if (BOUNDS) {
            const kernel_displacement_out _o112 = kernel_displacement(earliest_delay, when, extent, speed, position_error, velocity_error, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_bridge_half_width, p_gravity, p_end_depth);
            slack = _o112.margin;
        }
        const kernel_here_out _o113 = kernel_here(3.0, which);
        here = _o113.here;
        if (here) {
            const kernel_end_bounds_out _o114 = kernel_end_bounds(x, y, p_ring_radius);
            g0 = _o114.g0;
            const kernel_end_reached_out _o115 = kernel_end_reached(g0);
            reached = _o115.reached;
            if (BOUNDS) {
                const kernel_end_edge_out _o116 = kernel_end_edge(slack, g0);
                edge = _o116.edge;
            }
        }
        if (BOUNDS) {
            const kernel_flight_undecided_out _o117 = kernel_flight_undecided(when, earliest_delay, undecided_time, uncertain, edge);
            uncertain = _o117.uncertain;
        }
        const kernel_accounted_out _o118 = kernel_accounted(contacts, most_contacts, reached, touches);
        contacts = _o118.contacts;
        outcome = _o118.outcome;

        const double _before[] = {x, y, z, vx, vy, vz, wx, wy, wz};

        /* What it does to the ball. */
        const kernel_meeting_out _o119 = kernel_meeting(claims, ends, touches);
        meeting = _o119.meeting;
        if (meeting) {
            const kernel_end_normal_out _o120 = kernel_end_normal();
            nx = _o120.nx;
            ny = _o120.ny;
            nz = _o120.nz;
            const kernel_here_out _o121 = kernel_here(0.0, which);
            here = _o121.here;
            if (here) {
                const kernel_ring_normal_out _o122 = kernel_ring_normal(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius);
                nx = _o122.nx;
                ny = _o122.ny;
                nz = _o122.nz;
                const kernel_counted_out _o123 = kernel_counted(count_0);
                count_0 = _o123.count;
            }
            const kernel_here_out _o124 = kernel_here(1.0, which);
            here = _o124.here;
            if (here) {
                const kernel_backboard_normal_out _o125 = kernel_backboard_normal();
                nx = _o125.nx;
                ny = _o125.ny;
                nz = _o125.nz;
                const kernel_counted_out _o126 = kernel_counted(count_1);
                count_1 = _o126.count;
            }
            const kernel_here_out _o127 = kernel_here(2.0, which);
            here = _o127.here;
            if (here) {
                const kernel_bridge_normal_out _o128 = kernel_bridge_normal();
                nx = _o128.nx;
                ny = _o128.ny;
                nz = _o128.nz;
                const kernel_counted_out _o129 = kernel_counted(count_2);
                count_2 = _o129.count;
            }
            if (BOUNDS) {
                const kernel_normal_velocity_out _o130 = kernel_normal_velocity(vx, vy, vz, nx, ny, nz);
                normal_velocity = _o130.normal_velocity;
                const kernel_came_back_out _o131 = kernel_came_back(last, which);
                back = _o131.back;
                const kernel_end_tangents_out _o132 = kernel_end_tangents(when, z, vz, p_gravity);
                tangent_x = _o132.tangent_x;
                tangent_y = _o132.tangent_y;
                bend_s = _o132.bend_s;
                bend_e = _o132.bend_e;
                sharpest_bend = _o132.sharpest_bend;
                root_offset = _o132.root_offset;
                root_level = _o132.root_level;
                normal_rounding = _o132.normal_rounding;
                const kernel_here_out _o133 = kernel_here(0.0, which);
                here = _o133.here;
                if (here) {
                    const kernel_ring_tangents_out _o134 = kernel_ring_tangents(when, x, y, z, vx, vy, vz, nx, ny, nz, place_n, normal_velocity, back, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity);
                    tangent_x = _o134.tangent_x;
                    tangent_y = _o134.tangent_y;
                    bend_s = _o134.bend_s;
                    bend_e = _o134.bend_e;
                    sharpest_bend = _o134.sharpest_bend;
                    root_offset = _o134.root_offset;
                    root_level = _o134.root_level;
                    normal_rounding = _o134.normal_rounding;
                }
                const kernel_here_out _o135 = kernel_here(1.0, which);
                here = _o135.here;
                if (here) {
                    const kernel_backboard_tangents_out _o136 = kernel_backboard_tangents(when, x, vx);
                    tangent_x = _o136.tangent_x;
                    tangent_y = _o136.tangent_y;
                    bend_s = _o136.bend_s;
                    bend_e = _o136.bend_e;
                    sharpest_bend = _o136.sharpest_bend;
                    root_offset = _o136.root_offset;
                    root_level = _o136.root_level;
                    normal_rounding = _o136.normal_rounding;
                }
                const kernel_here_out _o137 = kernel_here(2.0, which);
                here = _o137.here;
                if (here) {
                    const kernel_bridge_tangents_out _o138 = kernel_bridge_tangents(when, z, vz, p_gravity);
                    tangent_x = _o138.tangent_x;
                    tangent_y = _o138.tangent_y;
                    bend_s = _o138.bend_s;
                    bend_e = _o138.bend_e;
                    sharpest_bend = _o138.sharpest_bend;
                    root_offset = _o138.root_offset;
                    root_level = _o138.root_level;
                    normal_rounding = _o138.normal_rounding;
                }
                if (ends) {
                    const kernel_carry_end_out _o139 = kernel_carry_end(when, x, y, z, vx, vy, vz, clock, position_bound, velocity_bound, spin_bound, root_offset, normal_velocity, p_gravity);
                    position_bound = _o139.position_bound;
                    velocity_bound = _o139.velocity_bound;
                    spin_bound = _o139.spin_bound;
                    belated = _o139.delay;
                    const kernel_clock_error_sum_out _o140 = kernel_clock_error_sum(belated, clock_error);
                    clock_error = _o140.clock_error;
                }
                const kernel_tightens_out _o141 = kernel_tightens(tightening, touches);
                carries = _o141.carries;
                tightens = _o141.tightens;
                if (carries) {
                    const kernel_carry_impact_out _o142 = kernel_carry_impact(when, x, y, z, vx, vy, vz, wx, wy, wz, nx, ny, nz, clock, left_nx, left_ny, left_nz, place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound, spin_bound, tangent_x, tangent_y, bend_s, bend_e, left_ex, left_ey, left_bend_s, left_bend_e, sharpest_bend, root_offset, root_level, normal_rounding, normal_velocity, back, p_ball_radius, p_restitution, p_gravity);
                    place_n = _o142.place_n;
                    place_s = _o142.place_s;
                    place_e = _o142.place_e;
                    pace_n = _o142.pace_n;
                    pace_s = _o142.pace_s;
                    pace_e = _o142.pace_e;
                    turn_n = _o142.turn_n;
                    turn_z = _o142.turn_z;
                    position_bound = _o142.position_bound;
                    velocity_bound = _o142.velocity_bound;
                    spin_bound = _o142.spin_bound;
                    left_nx = _o142.left_nx;
                    left_ny = _o142.left_ny;
                    left_nz = _o142.left_nz;
                    left_ex = _o142.left_ex;
                    left_ey = _o142.left_ey;
                    left_bend_s = _o142.left_bend_s;
                    left_bend_e = _o142.left_bend_e;
                    belated = _o142.delay;
                    const kernel_clock_error_sum_out _o143 = kernel_clock_error_sum(belated, clock_error);
                    clock_error = _o143.clock_error;
                }
                if (tightens) {
                    const kernel_tighten_impact_out _o144 = kernel_tighten_impact(when, x, y, z, vx, vy, vz, wx, wy, wz, nx, ny, nz, clock, left_nx, left_ny, left_nz, place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound, spin_bound, tangent_x, tangent_y, bend_s, bend_e, left_ex, left_ey, left_bend_s, left_bend_e, sharpest_bend, root_offset, root_level, normal_rounding, normal_velocity, back, origin_s, origin_e, origin_u, origin_v, origin_w, origin_t, product_11, product_12, product_13, product_14, product_15, product_16, product_21, product_22, product_23, product_24, product_25, product_26, product_31, product_32, product_33, product_34, product_35, product_36, product_41, product_42, product_43, product_44, product_45, product_46, product_51, product_52, product_53, product_54, product_55, product_56, product_61, product_62, product_63, product_64, product_65, product_66, recent_s, recent_e, recent_u, recent_v, recent_w, recent_t, continued, p_ball_radius, p_restitution, p_gravity);
                    place_n = _o144.place_n;
                    place_s = _o144.place_s;
                    place_e = _o144.place_e;
                    pace_n = _o144.pace_n;
                    pace_s = _o144.pace_s;
                    pace_e = _o144.pace_e;
                    turn_n = _o144.turn_n;
                    turn_z = _o144.turn_z;
                    position_bound = _o144.position_bound;
                    velocity_bound = _o144.velocity_bound;
                    spin_bound = _o144.spin_bound;
                    left_nx = _o144.left_nx;
                    left_ny = _o144.left_ny;
                    left_nz = _o144.left_nz;
                    left_ex = _o144.left_ex;
                    left_ey = _o144.left_ey;
                    left_bend_s = _o144.left_bend_s;
                    left_bend_e = _o144.left_bend_e;
                    belated = _o144.delay;
                    origin_s = _o144.origin_s;
                    origin_e = _o144.origin_e;
                    origin_u = _o144.origin_u;
                    origin_v = _o144.origin_v;
                    origin_w = _o144.origin_w;
                    origin_t = _o144.origin_t;
                    recent_s = _o144.recent_s;
                    recent_e = _o144.recent_e;
                    recent_u = _o144.recent_u;
                    recent_v = _o144.recent_v;
                    recent_w = _o144.recent_w;
                    recent_t = _o144.recent_t;
                    product_11 = _o144.product_11;
                    product_12 = _o144.product_12;
                    product_13 = _o144.product_13;
                    product_14 = _o144.product_14;
                    product_15 = _o144.product_15;
                    product_16 = _o144.product_16;
                    product_21 = _o144.product_21;
                    product_22 = _o144.product_22;
                    product_23 = _o144.product_23;
                    product_24 = _o144.product_24;
                    product_25 = _o144.product_25;
                    product_26 = _o144.product_26;
                    product_31 = _o144.product_31;
                    product_32 = _o144.product_32;
                    product_33 = _o144.product_33;
                    product_34 = _o144.product_34;
                    product_35 = _o144.product_35;
                    product_36 = _o144.product_36;
                    product_41 = _o144.product_41;
                    product_42 = _o144.product_42;
                    product_43 = _o144.product_43;
                    product_44 = _o144.product_44;
                    product_45 = _o144.product_45;
                    product_46 = _o144.product_46;
                    product_51 = _o144.product_51;
                    product_52 = _o144.product_52;
                    product_53 = _o144.product_53;
                    product_54 = _o144.product_54;
                    product_55 = _o144.product_55;
                    product_56 = _o144.product_56;
                    product_61 = _o144.product_61;
                    product_62 = _o144.product_62;
                    product_63 = _o144.product_63;
                    product_64 = _o144.product_64;
                    product_65 = _o144.product_65;
                    product_66 = _o144.product_66;
                    continued = _o144.continued;
                    const kernel_clock_error_sum_out _o145 = kernel_clock_error_sum(belated, clock_error);
                    clock_error = _o145.clock_error;
                }
            }
            if (touches) {
                const kernel_impact_out _o146 = kernel_impact(vx, vy, vz, wx, wy, wz, nx, ny, nz, p_ball_radius, p_restitution);
                vx = _o146.vx;
                vy = _o146.vy;
                vz = _o146.vz;
                wx = _o146.wx;
                wy = _o146.wy;
                wz = _o146.wz;
            }
            const kernel_here_out _o147 = kernel_here(1.0, which);
            here = _o147.here;
            if (here) {
                const kernel_backboard_place_out _o148 = kernel_backboard_place(y, z, p_ball_radius, p_board_distance);
                x = _o148.x;
                y = _o148.y;
                z = _o148.z;
            }
            const kernel_here_out _o149 = kernel_here(2.0, which);
            here = _o149.here;
            if (here) {
                const kernel_bridge_place_out _o150 = kernel_bridge_place(x, y, p_ball_radius, p_wire_radius);
                x = _o150.x;
                y = _o150.y;
                z = _o150.z;
            }
            if (touches) {
                if (BOUNDS) {
                    const kernel_unbounded_out _o151 = kernel_unbounded(clock_error, position_bound, velocity_bound, spin_bound);
                    unbounded = _o151.unbounded;
                    const kernel_without_bounds_out _o152 = kernel_without_bounds(unbounded, uncertain);
                    uncertain = _o152.uncertain;
                }
                const kernel_touched_out _o153 = kernel_touched(which, body, first);
                first = _o153.first;
                last = _o153.last;
            }
        }
        if (BOUNDS) {
            if (limited) {
                const kernel_ends_by_time_limit_out _o154 = kernel_ends_by_time_limit(4.0, which, claims);
                ends_by_time_limit = _o154.ends_by_time_limit;
                if (ends_by_time_limit) {
                    const kernel_carry_time_out _o155 = kernel_carry_time(when, x, y, z, vx, vy, vz, clock, clock_error, position_bound, velocity_bound, spin_bound, p_gravity);
                    position_bound = _o155.position_bound;
                    velocity_bound = _o155.velocity_bound;
                    spin_bound = _o155.spin_bound;
                    clock_error = _o155.clock_error;
                }
            }
            const kernel_closing_out _o156 = kernel_closing(outcome, claims);
            reports = _o156.reports;
            position_claim = _o156.position_claim;
            velocity_claim = _o156.velocity_claim;
            spin_claim = _o156.spin_claim;
            time_claim = _o156.time_claim;
            if (reports) {
                const kernel_claimed_errors_out _o157 = kernel_claimed_errors(clock_error, position_bound, velocity_bound, spin_bound);
                position_claim = _o157.position_error;
                velocity_claim = _o157.velocity_error;
                spin_claim = _o157.spin_error;
                time_claim = _o157.time_error;
            }
        }

        if (_events && body >= 0.0) {
            if (_errors) {
                _errors[_used].time_error = time_claim;
                _errors[_used].state_error[0] = position_claim;
                _errors[_used].state_error[1] = velocity_claim;
                _errors[_used].state_error[2] = spin_claim;
            }
            hoop_event *const _event = _events + _used++;
            const long long _place = (long long)body, _staying = _place - 4;
            _event->shot = _first + _shot;
            _event->surface = _staying < 0 ? _place : _staying / 2;
            _event->kind = _staying < -1 ? HOOP_EVENT_IMPACT : _staying < 0 ? HOOP_EVENT_END : _staying % 2 ? HOOP_EVENT_LEAVE : HOOP_EVENT_ROLL;
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
        ((int *)_results[10])[_shot] = _used;
    const bool _invalid = (int)outcome == HOOP_OUTCOME_INVALID;
    (void)_invalid;
    if (_results[0] && !_tightens) {
        ((unsigned char *)_results[0])[_shot] = (unsigned char)(int)outcome;
    }
    if (_results[1] && !_tightens) {
        ((int *)_results[1])[_shot] = (int)contacts;
    }
    if (_results[2] && !_tightens) {
        ((int *)_results[2])[3 * _shot + 0] = (int)count_0;
        ((int *)_results[2])[3 * _shot + 1] = (int)count_1;
        ((int *)_results[2])[3 * _shot + 2] = (int)count_2;
    }
    if (_results[3] && !_tightens) {
        ((signed char *)_results[3])[_shot] = (signed char)(int)first;
    }
    if (_results[4] && !_tightens) {
        ((double *)_results[4])[_shot] = _invalid ? NOT_A_NUMBER : clock;
    }
    if (_results[5] && !_tightens) {
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
    if (BOUNDS && _results[6]) {
        ((double *)_results[6])[_shot] = _invalid ? NOT_A_NUMBER : time_claim;
    }
    if (BOUNDS && _results[7]) {
        ((double *)_results[7])[3 * _shot + 0] = _invalid ? NOT_A_NUMBER : position_claim;
        ((double *)_results[7])[3 * _shot + 1] = _invalid ? NOT_A_NUMBER : velocity_claim;
        ((double *)_results[7])[3 * _shot + 2] = _invalid ? NOT_A_NUMBER : spin_claim;
    }
    if (BOUNDS && _results[8]) {
        ((unsigned char *)_results[8])[_shot] = (unsigned char)(int)uncertain;
    }

    if (BOUNDS) {
        const kernel_loose_out _o158 = kernel_loose(contacts, outcome, uncertain);
        loose = _o158.loose;
    }
    return loose && !_tightens;
}

#if VARIANT != 1
/* The path alone. */
extern "C" __global__ void hoop_plain(
    long long _shots, long long _first, const double *_states, const double *const *_values,
    const long long *_strides, const signed char *_leaving, int _max_contacts, double time_limit,
    void *const *_results)
{
    hoop_loop<false>(
        _shots, _first, _states, _values, _strides, _leaving, _max_contacts, time_limit, _results, 0.0);
}
#endif

#if VARIANT != 0
/* With bounds on errors. */
extern "C" __global__ void hoop_bounded(
    long long _shots, long long _first, const double *_states, const double *const *_values,
    const long long *_strides, const signed char *_leaving, int _max_contacts, double time_limit,
    void *const *_results)
{
    double tightening = 0.0;
    while (hoop_loop<true>(
        _shots, _first, _states, _values, _strides, _leaving, _max_contacts, time_limit, _results, tightening))
        tightening = 1.0;
}
#endif
