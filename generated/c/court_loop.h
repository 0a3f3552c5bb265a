/* The event loop of the scene court, with or without bounds on errors.

   Generated from templates/c/loop.h.j2, scene court, derivation 6850e5812fbcfc63,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Included by court_engine.h twice, BOUNDED being 1 where errors are bounded, else 0. The path is
   the same, and without bounds there is less work. */

/* Shots in flight, a column for each quantity, and the lists of those that need a longer look. */
typedef struct {
    _Alignas(64) LANES(column) shot, finished; /* whole numbers: no memory holds 2^53 shots */
    LANES(column) x; /* of the state */
    LANES(column) y; /* of the state */
    LANES(column) z; /* of the state */
    LANES(column) vx; /* of the state */
    LANES(column) vy; /* of the state */
    LANES(column) vz; /* of the state */
    LANES(column) wx; /* of the state */
    LANES(column) wy; /* of the state */
    LANES(column) wz; /* of the state */
#if BOUNDED
    LANES(column) dx; /* carried error of x */
    LANES(column) dy; /* carried error of y */
    LANES(column) dz; /* carried error of z */
    LANES(column) dvx; /* carried error of vx */
    LANES(column) dvy; /* carried error of vy */
    LANES(column) dvz; /* carried error of vz */
    LANES(column) dwx; /* carried error of wx */
    LANES(column) dwy; /* carried error of wy */
    LANES(column) dwz; /* carried error of wz */
    LANES(singles_column) place_n; /* bound on an error in the frame of the last contact */
    LANES(singles_column) place_s; /* bound on an error in the frame of the last contact */
    LANES(singles_column) place_e; /* bound on an error in the frame of the last contact */
    LANES(singles_column) pace_n; /* bound on an error in the frame of the last contact */
    LANES(singles_column) pace_s; /* bound on an error in the frame of the last contact */
    LANES(singles_column) pace_e; /* bound on an error in the frame of the last contact */
    LANES(singles_column) turn_n; /* bound on an error in the frame of the last contact */
    LANES(singles_column) turn_z; /* bound on an error in the frame of the last contact */
    LANES(singles_column) position_bound; /* bound on the error of the position */
    LANES(singles_column) velocity_bound; /* bound on the error of the velocity */
    LANES(singles_column) spin_bound; /* bound on the error of the spin */
    LANES(singles_column) left_ex; /* of the frame of the last contact */
    LANES(singles_column) left_ey; /* of the frame of the last contact */
    LANES(singles_column) left_bend_s; /* of the frame of the last contact */
    LANES(singles_column) left_bend_e; /* of the frame of the last contact */
    LANES(singles_column) frame_nx; /* of the frame of the last contact */
    LANES(singles_column) frame_ny; /* of the frame of the last contact */
    LANES(singles_column) frame_nz; /* of the frame of the last contact */
    LANES(column) estimated; /* 1: bounds on its errors are estimated from here on */
    LANES(singles_column) clock_bound; /* bound on what the contacts' times were off by, summed */
#endif
    LANES(column) clock; /* time of the last event, s since the release */
#if BOUNDED
    LANES(column) clock_error; /* what the contacts' times were off by, summed */
#endif
    LANES(column) last; /* surface that was touched last, -1: none */
    LANES(column) first; /* body that was touched first, -1: none */
    LANES(column) contacts; /* how many contacts there were */
    LANES(column) count_0; /* contacts with ring */
    LANES(column) count_1; /* contacts with backboard */
    LANES(column) count_2; /* contacts with bridge */
    LANES(column) held; /* surface that it stays in contact with, -1: none */
    LANES(column) mode; /* 0: in flight; 1 to 5: begins, goes on, ends, ends at an edge, starts */
    LANES(column) circled; /* 1: it rolls on a ring, and does not leave since a turning point */
#if BOUNDED
    LANES(column) assured; /* 1: its bounces on the surface it touched last end there */
#endif
    LANES(column) rolls; /* how many times it began to roll */
    LANES(column) slip_left; /* 1: its bounces ended with slip left, which friction cannot stop */
#if BOUNDED
    LANES(column) grip_lost; /* when friction first was too little for it to roll */
    LANES(column) last_grip_deficit; /* by how much friction is too little, F² - mu² N², a step ago; inf: not known */
    LANES(column) last_grip_deficit_rate; /* its rate then */
    LANES(column) last_grip_clock; /* when that was */
#endif
    LANES(column) through; /* 1: it has fallen through the ring, -1: it came up through it */
#if BOUNDED
    LANES(column) uncertain; /* 1: a decision lies within its rounding-error bound */
    LANES(column) position_claim; /* bound on the error at the last event */
    LANES(column) velocity_claim; /* bound on the error at the last event */
    LANES(column) spin_claim; /* bound on the error at the last event */
    LANES(column) time_claim; /* bound on the error at the last event */
#endif
    LANES(column) outcome; /* how it ended, -1: in flight */
#if BOUNDED
    LANES(court_parameters) parameters, stepping_parameters, searching_parameters, searching_searching_parameters, refining_parameters, reachable_parameters, reachable_searching_parameters, reachable_refining_parameters, in_contact_parameters, in_contact_rolling_parameters, turning_parameters, in_contact_circling_parameters, in_contact_leaves_parameters, slow_parameters;
#else
    LANES(court_parameters) parameters, stepping_parameters, searching_parameters, searching_searching_parameters, refining_parameters, reachable_parameters, reachable_searching_parameters, reachable_refining_parameters, in_contact_parameters, in_contact_rolling_parameters, in_contact_circling_parameters, in_contact_leaves_parameters, slow_parameters;
#endif
    /* Shots whose balls stay in contact: they wait for one another, and then have rows of their
       own behind those of the others, so that all lanes work. */
    size_t waiting;
    LANES(column) waiting_shot;
    LANES(column) waiting_x;
    LANES(column) waiting_y;
    LANES(column) waiting_z;
    LANES(column) waiting_vx;
    LANES(column) waiting_vy;
    LANES(column) waiting_vz;
    LANES(column) waiting_wx;
    LANES(column) waiting_wy;
    LANES(column) waiting_wz;
#if BOUNDED
    LANES(column) waiting_dx;
    LANES(column) waiting_dy;
    LANES(column) waiting_dz;
    LANES(column) waiting_dvx;
    LANES(column) waiting_dvy;
    LANES(column) waiting_dvz;
    LANES(column) waiting_dwx;
    LANES(column) waiting_dwy;
    LANES(column) waiting_dwz;
    LANES(singles_column) waiting_place_n;
    LANES(singles_column) waiting_place_s;
    LANES(singles_column) waiting_place_e;
    LANES(singles_column) waiting_pace_n;
    LANES(singles_column) waiting_pace_s;
    LANES(singles_column) waiting_pace_e;
    LANES(singles_column) waiting_turn_n;
    LANES(singles_column) waiting_turn_z;
    LANES(singles_column) waiting_position_bound;
    LANES(singles_column) waiting_velocity_bound;
    LANES(singles_column) waiting_spin_bound;
    LANES(singles_column) waiting_left_ex;
    LANES(singles_column) waiting_left_ey;
    LANES(singles_column) waiting_left_bend_s;
    LANES(singles_column) waiting_left_bend_e;
    LANES(singles_column) waiting_frame_nx;
    LANES(singles_column) waiting_frame_ny;
    LANES(singles_column) waiting_frame_nz;
    LANES(column) waiting_estimated;
    LANES(singles_column) waiting_clock_bound;
#endif
    LANES(column) waiting_clock;
#if BOUNDED
    LANES(column) waiting_clock_error;
#endif
    LANES(column) waiting_last;
    LANES(column) waiting_first;
    LANES(column) waiting_contacts;
    LANES(column) waiting_count_0;
    LANES(column) waiting_count_1;
    LANES(column) waiting_count_2;
    LANES(column) waiting_held;
    LANES(column) waiting_mode;
    LANES(column) waiting_circled;
#if BOUNDED
    LANES(column) waiting_assured;
#endif
    LANES(column) waiting_rolls;
    LANES(column) waiting_slip_left;
#if BOUNDED
    LANES(column) waiting_grip_lost;
    LANES(column) waiting_last_grip_deficit;
    LANES(column) waiting_last_grip_deficit_rate;
    LANES(column) waiting_last_grip_clock;
#endif
    LANES(column) waiting_through;
#if BOUNDED
    LANES(column) waiting_uncertain;
#endif
    LANES(court_parameters) waiting_parameters;
    LANES(column) x_before, y_before, z_before, vx_before, vy_before, vz_before, wx_before, wy_before, wz_before;
    LANES(column) arrival, arrives, began, body, ceiling, certain, extent, flat, in_contact, in_contact_began,
        in_contact_circled, in_contact_circling, in_contact_circling_circled,
        in_contact_circling_circling, in_contact_circling_clock, in_contact_circling_ended_circled,
        in_contact_circling_ended_circling, in_contact_circling_ended_clock,
        in_contact_circling_ended_per_reach, in_contact_circling_ended_rests,
        in_contact_circling_ended_row, in_contact_circling_ended_through,
        in_contact_circling_ended_vx, in_contact_circling_ended_vy, in_contact_circling_ended_vz,
        in_contact_circling_ended_which, in_contact_circling_ended_wx, in_contact_circling_ended_wy,
        in_contact_circling_ended_wz, in_contact_circling_ended_x, in_contact_circling_ended_y,
        in_contact_circling_ended_z, in_contact_circling_row, in_contact_circling_through,
        in_contact_circling_vx, in_contact_circling_vy, in_contact_circling_vz,
        in_contact_circling_which, in_contact_circling_wx, in_contact_circling_wy,
        in_contact_circling_wz, in_contact_circling_x, in_contact_circling_y, in_contact_circling_z,
        in_contact_clock, in_contact_gap_jerk, in_contact_gap_snap, in_contact_held,
        in_contact_last, in_contact_leaves, in_contact_leaves_clock, in_contact_leaves_gap_jerk,
        in_contact_leaves_gap_snap, in_contact_leaves_held, in_contact_leaves_lift,
        in_contact_leaves_per_reach, in_contact_leaves_row, in_contact_leaves_vx,
        in_contact_leaves_vy, in_contact_leaves_vz, in_contact_leaves_when, in_contact_leaves_which,
        in_contact_leaves_x, in_contact_leaves_y, in_contact_leaves_z, in_contact_lift,
        in_contact_mode, in_contact_per_reach, in_contact_rests, in_contact_rolling,
        in_contact_rolling_bent_x, in_contact_rolling_bent_y, in_contact_rolling_bent_z,
        in_contact_rolling_clock, in_contact_rolling_ended_clock,
        in_contact_rolling_ended_per_reach, in_contact_rolling_ended_rests,
        in_contact_rolling_ended_rolling, in_contact_rolling_ended_row,
        in_contact_rolling_ended_through, in_contact_rolling_ended_vx, in_contact_rolling_ended_vy,
        in_contact_rolling_ended_vz, in_contact_rolling_ended_which, in_contact_rolling_ended_wx,
        in_contact_rolling_ended_wy, in_contact_rolling_ended_wz, in_contact_rolling_ended_x,
        in_contact_rolling_ended_y, in_contact_rolling_ended_z, in_contact_rolling_held,
        in_contact_rolling_nx, in_contact_rolling_ny, in_contact_rolling_nz,
        in_contact_rolling_per_reach, in_contact_rolling_rolling, in_contact_rolling_row,
        in_contact_rolling_through, in_contact_rolling_vx, in_contact_rolling_vy,
        in_contact_rolling_vz, in_contact_rolling_which, in_contact_rolling_wx,
        in_contact_rolling_wy, in_contact_rolling_wz, in_contact_rolling_x, in_contact_rolling_y,
        in_contact_rolling_z, in_contact_row, in_contact_through, in_contact_vx, in_contact_vy,
        in_contact_vz, in_contact_when, in_contact_which, in_contact_wx, in_contact_wy,
        in_contact_wz, in_contact_x, in_contact_y, in_contact_z, limited, open, permitted,
        reachable_arrival, reachable_arrives, reachable_ceiling, reachable_certain,
        reachable_extent, reachable_flat, reachable_last, reachable_refining_arrival,
        reachable_refining_ceiling, reachable_refining_certain, reachable_refining_ended_arrival,
        reachable_refining_ended_row, reachable_refining_leaving, reachable_refining_refining,
        reachable_refining_row, reachable_refining_vx, reachable_refining_vy, reachable_refining_vz,
        reachable_refining_x, reachable_refining_y, reachable_refining_z, reachable_row,
        reachable_searching_arrival, reachable_searching_ceiling, reachable_searching_certain,
        reachable_searching_end, reachable_searching_ended_arrival,
        reachable_searching_ended_certain, reachable_searching_ended_flat,
        reachable_searching_ended_row, reachable_searching_ended_tilt, reachable_searching_extent,
        reachable_searching_flat, reachable_searching_high0, reachable_searching_high1,
        reachable_searching_last, reachable_searching_latest, reachable_searching_low0,
        reachable_searching_low1, reachable_searching_rate_slack, reachable_searching_row,
        reachable_searching_searching, reachable_searching_share, reachable_searching_speed,
        reachable_searching_t, reachable_searching_tilt, reachable_searching_vx,
        reachable_searching_vy, reachable_searching_vz, reachable_searching_x,
        reachable_searching_y, reachable_searching_z, reachable_speed, reachable_tilt, reachable_vx,
        reachable_vy, reachable_vz, reachable_when, reachable_which, reachable_x, reachable_y,
        reachable_z, refining_arrival, refining_ceiling, refining_certain, refining_ended_arrival,
        refining_ended_row, refining_leaving, refining_refining, refining_rho_start, refining_row,
        refining_vx, refining_vy, refining_vz, refining_x, refining_y, refining_z, rests, rho_start,
        rolling, searching, searching_arrival, searching_ceiling, searching_certain,
        searching_extent, searching_flat, searching_last, searching_rho_start, searching_row,
        searching_searching_arrival, searching_searching_ceiling, searching_searching_certain,
        searching_searching_end, searching_searching_ended_arrival,
        searching_searching_ended_certain, searching_searching_ended_flat,
        searching_searching_ended_row, searching_searching_ended_tilt, searching_searching_energy2,
        searching_searching_extent, searching_searching_flat, searching_searching_high0,
        searching_searching_high1, searching_searching_high2, searching_searching_last,
        searching_searching_latest, searching_searching_low0, searching_searching_low1,
        searching_searching_low2, searching_searching_moment2, searching_searching_rate_slack,
        searching_searching_rho_start, searching_searching_row, searching_searching_searching,
        searching_searching_share, searching_searching_speed, searching_searching_t,
        searching_searching_tilt, searching_searching_vx, searching_searching_vy,
        searching_searching_vz, searching_searching_x, searching_searching_y, searching_searching_z,
        searching_share, searching_speed, searching_t, searching_tilt, searching_until,
        searching_vx, searching_vy, searching_vz, searching_x, searching_y, searching_z, share,
        since, single_precision, slow_held, slow_mode, slow_outcome, slow_row, slow_slip_left,
        slow_vx, slow_vy, slow_vz, slow_which, slow_wx, slow_wy, slow_wz, slow_x, slow_y, slow_z,
        speed, stepping_ended_certain, stepping_ended_row, stepping_row, stepping_stepping, tilt,
        time_error, turning_p_ball_radius, turning_p_board_bottom, turning_p_board_distance,
        turning_p_board_half_width, turning_p_board_thickness, turning_p_board_top,
        turning_p_bridge_depth, turning_p_bridge_half_width, turning_p_end_depth, turning_p_gravity,
        turning_p_inertia, turning_p_ring_radius, turning_p_wire_radius, until, when, which;
    LANES(singles_column) short_t, stepping_ended_short_t, stepping_short_ceiling, stepping_short_end,
        stepping_short_energy2, stepping_short_flat, stepping_short_high1, stepping_short_high2,
        stepping_short_jerk, stepping_short_low1, stepping_short_low2, stepping_short_moment2,
        stepping_short_quotient_margin, stepping_short_rate_margin, stepping_short_rho_rate,
        stepping_short_rho_start, stepping_short_start_rate, stepping_short_t, stepping_short_tilt,
        stepping_short_vx, stepping_short_vy, stepping_short_vz, stepping_short_x, stepping_short_y,
        stepping_short_z;
#if BOUNDED
    LANES(column) earliest_delay, hopped, in_contact_circling_clock_error, in_contact_circling_dvx,
        in_contact_circling_dvy, in_contact_circling_dvz, in_contact_circling_dwx,
        in_contact_circling_dwy, in_contact_circling_dwz, in_contact_circling_dx,
        in_contact_circling_dy, in_contact_circling_dz, in_contact_circling_earliest_delay,
        in_contact_circling_ended_dvx, in_contact_circling_ended_dvy, in_contact_circling_ended_dvz,
        in_contact_circling_ended_dwx, in_contact_circling_ended_dwy, in_contact_circling_ended_dwz,
        in_contact_circling_ended_dx, in_contact_circling_ended_dy, in_contact_circling_ended_dz,
        in_contact_circling_ended_earliest_delay, in_contact_circling_ended_grip_lost,
        in_contact_circling_ended_last_grip_clock, in_contact_circling_ended_last_grip_deficit,
        in_contact_circling_ended_last_grip_deficit_rate, in_contact_circling_ended_position_error,
        in_contact_circling_ended_undecided_time, in_contact_circling_ended_velocity_error,
        in_contact_circling_estimated, in_contact_circling_grip_lost,
        in_contact_circling_last_grip_clock, in_contact_circling_last_grip_deficit,
        in_contact_circling_last_grip_deficit_rate, in_contact_circling_undecided_time,
        in_contact_clock_error, in_contact_dvx, in_contact_dvy, in_contact_dvz, in_contact_dwx,
        in_contact_dwy, in_contact_dwz, in_contact_dx, in_contact_dy, in_contact_dz,
        in_contact_earliest_delay, in_contact_estimated, in_contact_grip_lost,
        in_contact_last_grip_clock, in_contact_last_grip_deficit, in_contact_last_grip_deficit_rate,
        in_contact_leaves_clock_error, in_contact_leaves_dvx, in_contact_leaves_dvy,
        in_contact_leaves_dvz, in_contact_leaves_dwx, in_contact_leaves_dwy, in_contact_leaves_dwz,
        in_contact_leaves_dx, in_contact_leaves_dy, in_contact_leaves_dz,
        in_contact_leaves_estimated, in_contact_leaves_position_error,
        in_contact_leaves_undecided_time, in_contact_leaves_velocity_error,
        in_contact_position_error, in_contact_rolling_clock_error, in_contact_rolling_dvx,
        in_contact_rolling_dvy, in_contact_rolling_dvz, in_contact_rolling_dwx,
        in_contact_rolling_dwy, in_contact_rolling_dwz, in_contact_rolling_dx,
        in_contact_rolling_dy, in_contact_rolling_dz, in_contact_rolling_earliest_delay,
        in_contact_rolling_ended_dvx, in_contact_rolling_ended_dvy, in_contact_rolling_ended_dvz,
        in_contact_rolling_ended_dwx, in_contact_rolling_ended_dwy, in_contact_rolling_ended_dwz,
        in_contact_rolling_ended_dx, in_contact_rolling_ended_dy, in_contact_rolling_ended_dz,
        in_contact_rolling_ended_earliest_delay, in_contact_rolling_ended_grip_lost,
        in_contact_rolling_ended_last_grip_clock, in_contact_rolling_ended_last_grip_deficit,
        in_contact_rolling_ended_last_grip_deficit_rate, in_contact_rolling_ended_position_error,
        in_contact_rolling_ended_undecided_time, in_contact_rolling_ended_velocity_error,
        in_contact_rolling_estimated, in_contact_rolling_grip_lost,
        in_contact_rolling_last_grip_clock, in_contact_rolling_last_grip_deficit,
        in_contact_rolling_last_grip_deficit_rate, in_contact_rolling_undecided_time,
        in_contact_undecided_time, in_contact_velocity_error, latest, leaving, pad, position_error,
        rate, reachable_earliest_delay, reachable_latest, reachable_leaving,
        reachable_position_error, reachable_rate, reachable_refining_ended_rate,
        reachable_searching, reachable_searching_ended_searching, reachable_searching_ended_t,
        reachable_searching_ended_undecided_time, reachable_searching_position_error,
        reachable_searching_undecided_time, reachable_searching_velocity_error, reachable_t,
        reachable_undecided_time, reachable_velocity_error, refining_ended_rate, searching_latest,
        searching_position_error, searching_searching, searching_searching_ended_searching,
        searching_searching_ended_t, searching_searching_ended_undecided_time,
        searching_searching_position_error, searching_searching_undecided_time,
        searching_searching_velocity_error, searching_undecided_time, searching_velocity_error,
        slow_assured, slow_clock_error, slow_dvx, slow_dvy, slow_dvz, slow_dwx, slow_dwy, slow_dwz,
        slow_dx, slow_dy, slow_dz, slow_estimated, slow_uncertain, t, undecided_time, velocity_error;
    LANES(singles_column) in_contact_circling_clock_bound, in_contact_circling_position_bound,
        in_contact_circling_spin_bound, in_contact_circling_velocity_bound, in_contact_clock_bound,
        in_contact_leaves_clock_bound, in_contact_leaves_position_bound,
        in_contact_leaves_spin_bound, in_contact_leaves_velocity_bound, in_contact_position_bound,
        in_contact_rolling_clock_bound, in_contact_rolling_position_bound,
        in_contact_rolling_spin_bound, in_contact_rolling_velocity_bound, in_contact_spin_bound,
        in_contact_velocity_bound, slow_clock_bound, slow_position_bound, slow_spin_bound,
        slow_velocity_bound;
#endif
    /* What kernels make of parameters alone. */
    _Alignas(64) double fixed[LANES_ROWS][LANES_WIDTH];
    _Alignas(64) float fixed_single[LANES_ROWS][LANES_WIDTH];
} LOOP(worklist);

/* Look at the parameters of a row of lanes. */
LANES_INLINE void LOOP(permitted)(LOOP(worklist) *worklist, size_t row)
{
    lanes_store(worklist->permitted + row, lanes_select(LANES(court_validate)(worklist->parameters.columns, row), K(1.0), K(0.0)));
}

/* Have zeros in the lanes behind the last row, which are computed with, too: not what memory held. */
LANES_INLINE void LOOP(fill)(LOOP(worklist) *worklist, size_t row, int varying)
{
    EACH(FILL, , x, y, z, vx, vy, vz, wx, wy, wz, clock, first, contacts, count_0, count_1, count_2)
    EACH(FILL, , held, mode, circled, rolls, slip_left, through, outcome, last, shot)
    BOUNDS(EACH(FILL, , dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, estimated, clock_error, assured))
    BOUNDS(EACH(FILL, , grip_lost, last_grip_deficit, last_grip_deficit_rate, last_grip_clock, uncertain))
    BOUNDS(EACH(FILL, , position_claim, velocity_claim, spin_claim, time_claim))
    BOUNDS(EACH(FILL_SINGLE, , place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z))
    BOUNDS(EACH(FILL_SINGLE, , position_bound, velocity_bound, spin_bound, left_ex, left_ey, left_bend_s))
    BOUNDS(EACH(FILL_SINGLE, , left_bend_e, frame_nx, frame_ny, frame_nz, clock_bound))
    if (varying) {
        for (int p = 0; p < COURT_PARAMETERS; p++)
            lanes_store(worklist->parameters.columns[p] + row, K(0.0));
        lanes_store(worklist->permitted + row, K(0.0));
    }
}

/* Put states into the columns of a row of lanes, the first components of them at least. */
LANES_INLINE void LOOP(load)(LOOP(worklist) *worklist, size_t row, const double *states, int wanted)
{
    double *const columns[] = {
        worklist->x + row,
        worklist->y + row,
        worklist->z + row,
        worklist->vx + row,
        worklist->vy + row,
        worklist->vz + row,
        worklist->wx + row,
        worklist->wy + row,
        worklist->wz + row,
    };
    lanes_columns(columns, states, COURT_STATE, wanted);
}

/* Have counters of events at zero for the shots from one on. */
LANES_INLINE void LOOP(reset)(const court_job *job, size_t start, size_t shots)
{
    if (job->results->events)
        memset(job->results->event_counts + start, 0, shots * sizeof(int32_t));
}

/* Have the fields of the shots in rows from one on as at a release. */
LANES_INLINE void LOOP(begin_fields)(LOOP(worklist) *worklist, size_t row, size_t shots)
{
    for (size_t k = 0; k < shots; k += LANES_WIDTH) {
        BOUNDS(EACH(BEGIN, K(0.0), dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz))
        BOUNDS(EACH(BEGIN_SINGLE, KS(0.0), place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n))
        BOUNDS(EACH(BEGIN_SINGLE, KS(0.0), turn_z, position_bound, velocity_bound, spin_bound, left_ex))
        BOUNDS(EACH(BEGIN_SINGLE, KS(0.0), left_ey, left_bend_s, left_bend_e, frame_nx, frame_ny, frame_nz))
        BOUNDS(EACH(BEGIN, K(0.0), estimated))
        BOUNDS(EACH(BEGIN_SINGLE, KS(0.0), clock_bound))
        EACH(BEGIN, K(0.0), clock)
        BOUNDS(EACH(BEGIN, K(0.0), clock_error))
        EACH(BEGIN, K(-1.0), first)
        EACH(BEGIN, K(0.0), contacts, count_0, count_1, count_2)
        EACH(BEGIN, K(-1.0), held)
        EACH(BEGIN, K(0.0), mode, circled, rolls, slip_left)
        BOUNDS(EACH(BEGIN, K(0.0), assured))
        BOUNDS(EACH(BEGIN, K(INFINITY), grip_lost, last_grip_deficit))
        EACH(BEGIN, K(0.0), through)
        BOUNDS(EACH(BEGIN, K(0.0), last_grip_deficit_rate, last_grip_clock, uncertain, position_claim))
        BOUNDS(EACH(BEGIN, K(0.0), velocity_claim, spin_claim, time_claim))
        EACH(BEGIN, K(-1.0), outcome, last)
    }
}

/* Put the next shots into rows, from one on. */
LANES_INLINE void LOOP(begin)(LOOP(worklist) *worklist, size_t row, size_t shots, const court_job *job, size_t start)
{
    const double *state = job->states + COURT_STATE * start;
    size_t k = 0;
    LOOP(fill)(worklist, row + shots, job->varying);
    for (; k + LANES_WIDTH <= shots; k += LANES_WIDTH)
        LOOP(load)(worklist, row + k, state + COURT_STATE * k, COURT_STATE);
    for (; k < shots; k++) {
        worklist->x[row + k] = state[COURT_STATE * k + 0];
        worklist->y[row + k] = state[COURT_STATE * k + 1];
        worklist->z[row + k] = state[COURT_STATE * k + 2];
        worklist->vx[row + k] = state[COURT_STATE * k + 3];
        worklist->vy[row + k] = state[COURT_STATE * k + 4];
        worklist->vz[row + k] = state[COURT_STATE * k + 5];
        worklist->wx[row + k] = state[COURT_STATE * k + 6];
        worklist->wy[row + k] = state[COURT_STATE * k + 7];
        worklist->wz[row + k] = state[COURT_STATE * k + 8];
    }
    if (job->varying)
        for (int p = 0; p < COURT_PARAMETERS; p++)
            for (k = 0; k < shots; k++)
                worklist->parameters.columns[p][row + k] = job->parameters[p][job->strides[p] * (int64_t)(start + k)];
    if (job->varying)
        for (k = 0; k < shots; k += LANES_WIDTH)
            LOOP(permitted)(worklist, row + k);
    for (k = 0; k < shots; k++)
        worklist->shot[row + k] = (double)(start + k);
    LOOP(begin_fields)(worklist, row, shots);
    if (job->leaving)
        for (k = 0; k < shots; k++)
            worklist->last[row + k] = (double)job->leaving[start + k];
    LOOP(reset)(job, start, shots);
}


/* Write the results of the shots in rows that follow one another, none of them invalid. */
LANES_INLINE void LOOP(finish_all)(const LOOP(worklist) *worklist, size_t shots, const court_job *job)
{
    const court_results *out = job->results;
    const size_t start = (size_t)worklist->shot[0];
    if (out->outcome) {
        uint8_t *const restrict to = out->outcome + start;
        for (size_t k = 0; k < shots; k += LANES_WIDTH) {
            /* By way of whole numbers of four bytes a compiler finds vectors for it. */
            const size_t some = shots - k < LANES_WIDTH ? shots - k : LANES_WIDTH;
            int32_t numbers[LANES_WIDTH];
            for (size_t lane = 0; lane < LANES_WIDTH; lane++)
                numbers[lane] = (int32_t)worklist->outcome[k + lane];
            for (size_t lane = 0; lane < some; lane++)
                to[k + lane] = (uint8_t)numbers[lane];
        }
    }
    if (out->contacts) {
        int32_t *const restrict to = out->contacts + start;
        for (size_t k = 0; k < shots; k += LANES_WIDTH) {
            /* By way of whole numbers of four bytes a compiler finds vectors for it. */
            const size_t some = shots - k < LANES_WIDTH ? shots - k : LANES_WIDTH;
            int32_t numbers[LANES_WIDTH];
            for (size_t lane = 0; lane < LANES_WIDTH; lane++)
                numbers[lane] = (int32_t)worklist->contacts[k + lane];
            for (size_t lane = 0; lane < some; lane++)
                to[k + lane] = (int32_t)numbers[lane];
        }
    }
    if (out->counts) {
        int32_t *const restrict to = out->counts + 3 * start;
        for (size_t k = 0; k < shots; k++) {
            to[3 * k + 0] = (int32_t)(int32_t)worklist->count_0[k];
            to[3 * k + 1] = (int32_t)(int32_t)worklist->count_1[k];
            to[3 * k + 2] = (int32_t)(int32_t)worklist->count_2[k];
        }
    }
    if (out->first) {
        int8_t *const restrict to = out->first + start;
        for (size_t k = 0; k < shots; k += LANES_WIDTH) {
            /* By way of whole numbers of four bytes a compiler finds vectors for it. */
            const size_t some = shots - k < LANES_WIDTH ? shots - k : LANES_WIDTH;
            int32_t numbers[LANES_WIDTH];
            for (size_t lane = 0; lane < LANES_WIDTH; lane++)
                numbers[lane] = (int32_t)worklist->first[k + lane];
            for (size_t lane = 0; lane < some; lane++)
                to[k + lane] = (int8_t)numbers[lane];
        }
    }
    if (out->time) {
        double *const restrict to = out->time + start;
        for (size_t k = 0; k < shots; k++) {
            to[k] = (double)worklist->clock[k];
        }
    }
    if (out->state) {
        /* As many rows as there are lanes fill whole lines: they go past the caches. */
        double rows[COURT_STATE * LANES_WIDTH];
        for (size_t k = 0; k < shots; k += LANES_WIDTH) {
            const double *const columns[] = {
                worklist->x + k,
                worklist->y + k,
                worklist->z + k,
                worklist->vx + k,
                worklist->vy + k,
                worklist->vz + k,
                worklist->wx + k,
                worklist->wy + k,
                worklist->wz + k,
            };
            const size_t some = shots - k < LANES_WIDTH ? shots - k : LANES_WIDTH;
            double *const to = out->state + COURT_STATE * (start + k);
            if (some < LANES_WIDTH || !lanes_stream(to, columns, COURT_STATE)) {
                lanes_rows(rows, columns, COURT_STATE);
                stream(to, rows, COURT_STATE * some);
            }
        }
    }
    if (out->rolls) {
        int32_t *const restrict to = out->rolls + start;
        for (size_t k = 0; k < shots; k += LANES_WIDTH) {
            /* By way of whole numbers of four bytes a compiler finds vectors for it. */
            const size_t some = shots - k < LANES_WIDTH ? shots - k : LANES_WIDTH;
            int32_t numbers[LANES_WIDTH];
            for (size_t lane = 0; lane < LANES_WIDTH; lane++)
                numbers[lane] = (int32_t)worklist->rolls[k + lane];
            for (size_t lane = 0; lane < some; lane++)
                to[k + lane] = (int32_t)numbers[lane];
        }
    }
    if (out->slip_left) {
        uint8_t *const restrict to = out->slip_left + start;
        for (size_t k = 0; k < shots; k += LANES_WIDTH) {
            /* By way of whole numbers of four bytes a compiler finds vectors for it. */
            const size_t some = shots - k < LANES_WIDTH ? shots - k : LANES_WIDTH;
            int32_t numbers[LANES_WIDTH];
            for (size_t lane = 0; lane < LANES_WIDTH; lane++)
                numbers[lane] = (int32_t)worklist->slip_left[k + lane];
            for (size_t lane = 0; lane < some; lane++)
                to[k + lane] = (uint8_t)numbers[lane];
        }
    }
#if BOUNDED
    if (out->grip_lost) {
        double *const restrict to = out->grip_lost + start;
        for (size_t k = 0; k < shots; k++) {
            to[k] = (double)worklist->grip_lost[k];
        }
    }
    if (out->time_error) {
        double *const restrict to = out->time_error + start;
        for (size_t k = 0; k < shots; k++) {
            to[k] = (double)worklist->time_claim[k];
        }
    }
    if (out->state_error) {
        double *const restrict to = out->state_error + 3 * start;
        for (size_t k = 0; k < shots; k++) {
            to[3 * k + 0] = (double)worklist->position_claim[k];
            to[3 * k + 1] = (double)worklist->velocity_claim[k];
            to[3 * k + 2] = (double)worklist->spin_claim[k];
        }
    }
    if (out->uncertain) {
        uint8_t *const restrict to = out->uncertain + start;
        for (size_t k = 0; k < shots; k += LANES_WIDTH) {
            /* By way of whole numbers of four bytes a compiler finds vectors for it. */
            const size_t some = shots - k < LANES_WIDTH ? shots - k : LANES_WIDTH;
            int32_t numbers[LANES_WIDTH];
            for (size_t lane = 0; lane < LANES_WIDTH; lane++)
                numbers[lane] = (int32_t)worklist->uncertain[k + lane];
            for (size_t lane = 0; lane < some; lane++)
                to[k + lane] = (uint8_t)numbers[lane];
        }
    }
    if (out->estimated) {
        uint8_t *const restrict to = out->estimated + start;
        for (size_t k = 0; k < shots; k += LANES_WIDTH) {
            /* By way of whole numbers of four bytes a compiler finds vectors for it. */
            const size_t some = shots - k < LANES_WIDTH ? shots - k : LANES_WIDTH;
            int32_t numbers[LANES_WIDTH];
            for (size_t lane = 0; lane < LANES_WIDTH; lane++)
                numbers[lane] = (int32_t)worklist->estimated[k + lane];
            for (size_t lane = 0; lane < some; lane++)
                to[k + lane] = (uint8_t)numbers[lane];
        }
    }
#endif
}

/* Write the results of the shot in a row. */
LANES_INLINE void LOOP(finish)(const LOOP(worklist) *worklist, size_t row, const court_job *job)
{
    const court_results *out = job->results;
    const size_t shot = (size_t)worklist->shot[row];
    const int invalid = (int)worklist->outcome[row] == COURT_OUTCOME_INVALID;
    if (out->outcome) {
        out->outcome[shot] = (uint8_t)worklist->outcome[row];
    }
    if (out->contacts) {
        out->contacts[shot] = (int32_t)worklist->contacts[row];
    }
    if (out->counts) {
        out->counts[3 * shot + 0] = (int32_t)worklist->count_0[row];
        out->counts[3 * shot + 1] = (int32_t)worklist->count_1[row];
        out->counts[3 * shot + 2] = (int32_t)worklist->count_2[row];
    }
    if (out->first) {
        out->first[shot] = (int8_t)worklist->first[row];
    }
    if (out->time) {
        out->time[shot] = invalid ? NAN : worklist->clock[row];
    }
    if (out->state) {
        out->state[9 * shot + 0] = invalid ? NAN : worklist->x[row];
        out->state[9 * shot + 1] = invalid ? NAN : worklist->y[row];
        out->state[9 * shot + 2] = invalid ? NAN : worklist->z[row];
        out->state[9 * shot + 3] = invalid ? NAN : worklist->vx[row];
        out->state[9 * shot + 4] = invalid ? NAN : worklist->vy[row];
        out->state[9 * shot + 5] = invalid ? NAN : worklist->vz[row];
        out->state[9 * shot + 6] = invalid ? NAN : worklist->wx[row];
        out->state[9 * shot + 7] = invalid ? NAN : worklist->wy[row];
        out->state[9 * shot + 8] = invalid ? NAN : worklist->wz[row];
    }
    if (out->rolls) {
        out->rolls[shot] = (int32_t)worklist->rolls[row];
    }
    if (out->slip_left) {
        out->slip_left[shot] = (uint8_t)worklist->slip_left[row];
    }
#if BOUNDED
    if (out->grip_lost) {
        out->grip_lost[shot] = invalid ? NAN : worklist->grip_lost[row];
    }
    if (out->time_error) {
        out->time_error[shot] = invalid ? NAN : worklist->time_claim[row];
    }
    if (out->state_error) {
        out->state_error[3 * shot + 0] = invalid ? NAN : worklist->position_claim[row];
        out->state_error[3 * shot + 1] = invalid ? NAN : worklist->velocity_claim[row];
        out->state_error[3 * shot + 2] = invalid ? NAN : worklist->spin_claim[row];
    }
    if (out->uncertain) {
        out->uncertain[shot] = (uint8_t)worklist->uncertain[row];
    }
    if (out->estimated) {
        out->estimated[shot] = (uint8_t)worklist->estimated[row];
    }
#endif
}

/* Have the shots of some lanes wait: their rows are free. */
LANES_INLINE void LOOP(wait)(LOOP(worklist) *worklist, size_t row, M who, const court_job *job)
{
    lanes_pack(worklist->waiting_shot + worklist->waiting, who, lanes_load(worklist->shot + row));
    EACH(WAIT, waiting_, x, y, z, vx, vy, vz, wx, wy, wz, clock, last, first, contacts, count_0)
    EACH(WAIT, waiting_, count_1, count_2, held, mode, circled, rolls, slip_left, through)
    BOUNDS(EACH(WAIT, waiting_, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, estimated, clock_error, assured))
    BOUNDS(EACH(WAIT, waiting_, grip_lost, last_grip_deficit, last_grip_deficit_rate, last_grip_clock))
    BOUNDS(EACH(WAIT, waiting_, uncertain))
    BOUNDS(EACH(WAIT_SINGLE, waiting_, place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z))
    BOUNDS(EACH(WAIT_SINGLE, waiting_, position_bound, velocity_bound, spin_bound, left_ex, left_ey))
    BOUNDS(EACH(WAIT_SINGLE, waiting_, left_bend_s, left_bend_e, frame_nx, frame_ny, frame_nz, clock_bound))
    if (job->varying)
        for (int p = 0; p < COURT_PARAMETERS; p++)
            lanes_pack(worklist->waiting_parameters.columns[p] + worklist->waiting, who, lanes_load(worklist->parameters.columns[p] + row));
    worklist->waiting += popcount(who);
}

/* Put shots that have waited into rows from one on; return how many. */
LANES_INLINE size_t LOOP(resume)(LOOP(worklist) *worklist, size_t row, const court_job *job)
{
    const size_t room = LANES_ROWS - row, shots = worklist->waiting < room ? worklist->waiting : room;
    const size_t from = worklist->waiting - shots;
    LOOP(fill)(worklist, row + shots, job->varying);
    memcpy(worklist->shot + row, worklist->waiting_shot + from, shots * sizeof *worklist->shot);
    EACH(RESUME, waiting_, x, y, z, vx, vy, vz, wx, wy, wz, clock, last, first, contacts, count_0)
    EACH(RESUME, waiting_, count_1, count_2, held, mode, circled, rolls, slip_left, through)
    BOUNDS(EACH(RESUME, waiting_, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, place_n, place_s, place_e))
    BOUNDS(EACH(RESUME, waiting_, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound))
    BOUNDS(EACH(RESUME, waiting_, spin_bound, left_ex, left_ey, left_bend_s, left_bend_e, frame_nx))
    BOUNDS(EACH(RESUME, waiting_, frame_ny, frame_nz, estimated, clock_bound, clock_error, assured))
    BOUNDS(EACH(RESUME, waiting_, grip_lost, last_grip_deficit, last_grip_deficit_rate, last_grip_clock))
    BOUNDS(EACH(RESUME, waiting_, uncertain))
    if (job->varying)
        for (int p = 0; p < COURT_PARAMETERS; p++)
            memcpy(worklist->parameters.columns[p] + row, worklist->waiting_parameters.columns[p] + from, shots * sizeof(double));
    worklist->waiting = from;
    return shots;
}

/* Write the results of the shots that have ended, from a row on; the others close up. */
LANES_INLINE size_t LOOP(leave)(LOOP(worklist) *worklist, size_t start, size_t shots, const court_job *job)
{
    size_t kept = start, ended = 0;
    /* How many of a row have ended is hardly predictable, so one loop is over those of all rows. */
    for (size_t i = start; i < shots; i += LANES_WIDTH) {
        const M going = lanes_less(lanes_load(worklist->outcome + i), K(0.0));
        const M over = lanes_both(mask_first_n(shots - i), lanes_not(going));
        lanes_pack(worklist->finished + ended, over, lanes_add(iota(), K((double)i)));
        ended += popcount(over);
    }
    for (size_t k = 0; k < ended; k++)
        LOOP(finish)(worklist, (size_t)worklist->finished[k], job);
    for (size_t i = start; i < shots; i += LANES_WIDTH) {
        const M rows = mask_first_n(shots - i);
        M going = lanes_both(rows, lanes_less(lanes_load(worklist->outcome + i), K(0.0)));
        const M staying = lanes_both(going, lanes_less(K(0.0), lanes_load(worklist->mode + i)));
        if (lanes_any(staying) && worklist->waiting + LANES_WIDTH <= LANES_SHOTS) {
            LOOP(wait)(worklist, i, staying, job);
            going = lanes_both(going, lanes_not(staying));
        }
        if (kept < i || lanes_bits(going) != lanes_bits(rows)) {
            lanes_pack(worklist->shot + kept, going, lanes_load(worklist->shot + i));
            EACH(KEEP, , x, y, z, vx, vy, vz, wx, wy, wz, clock, last, contacts, held, mode)
            EACH(KEEP, , circled, through)
            BOUNDS(EACH(KEEP, , dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, estimated, clock_error, assured))
            BOUNDS(EACH(KEEP, , grip_lost, last_grip_deficit, last_grip_deficit_rate, last_grip_clock))
            BOUNDS(EACH(KEEP_SINGLE, , place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z))
            BOUNDS(EACH(KEEP_SINGLE, , position_bound, velocity_bound, spin_bound, left_ex, left_ey))
            BOUNDS(EACH(KEEP_SINGLE, , left_bend_s, left_bend_e, frame_nx, frame_ny, frame_nz, clock_bound))
            if (job->results->first) {
                EACH(KEEP, , first)
            }
            if (job->results->counts) {
                EACH(KEEP, , count_0, count_1, count_2)
            }
            if (job->results->rolls) {
                EACH(KEEP, , rolls)
            }
            if (job->results->slip_left) {
                EACH(KEEP, , slip_left)
#if BOUNDED
            }
            if (job->results->uncertain) {
                EACH(KEEP, , uncertain)
#endif
            }
            if (job->varying)
                for (int p = 0; p < COURT_PARAMETERS; p++)
                    lanes_pack(worklist->parameters.columns[p] + kept, going, lanes_load(worklist->parameters.columns[p] + i));
        }
        kept += popcount(going);
    }
    return kept;
}

/* Make what kernels are given ready made, of the parameters of the first row. */
static void LOOP(fix)(LOOP(worklist) *worklist)
{
    (void)worklist;
    const V p_ball_radius = lanes_load(worklist->parameters.p_ball_radius);
    const V p_board_bottom = lanes_load(worklist->parameters.p_board_bottom);
    const V p_board_distance = lanes_load(worklist->parameters.p_board_distance);
    const V p_board_half_width = lanes_load(worklist->parameters.p_board_half_width);
    const V p_board_thickness = lanes_load(worklist->parameters.p_board_thickness);
    const V p_board_top = lanes_load(worklist->parameters.p_board_top);
    const V p_bridge_depth = lanes_load(worklist->parameters.p_bridge_depth);
    const V p_bridge_half_width = lanes_load(worklist->parameters.p_bridge_half_width);
    const V p_end_depth = lanes_load(worklist->parameters.p_end_depth);
    const V p_gravity = lanes_load(worklist->parameters.p_gravity);
    const V p_inertia = lanes_load(worklist->parameters.p_inertia);
    const V p_restitution_speed = lanes_load(worklist->parameters.p_restitution_speed);
    const V p_ring_radius = lanes_load(worklist->parameters.p_ring_radius);
    const V p_tangential_restitution = lanes_load(worklist->parameters.p_tangential_restitution);
    const V p_wire_radius = lanes_load(worklist->parameters.p_wire_radius);
    {
        const V _s11 = lanes_abs(p_board_bottom);
        const V _s12 = lanes_abs(p_board_top);
        const V _s23 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s11, _s12), lanes_abs(p_ball_radius)), lanes_abs(p_ring_radius)), lanes_abs(p_wire_radius)), lanes_abs(p_board_distance)), lanes_abs(p_board_half_width));
        const V _s33 = lanes_add(lanes_add(p_ball_radius, p_ring_radius), p_wire_radius);
        const V _s35 = lanes_mul(K(0.5), p_board_thickness);
        const V _s36 = lanes_add(p_board_distance, _s35);
        const V _s38 = lanes_add(p_ball_radius, _s35);
        const V _s39 = lanes_mul(K(0.5), p_ring_radius);
        const V _s40 = lanes_mul(K(0.5), p_board_distance);
        const V _s41 = lanes_add(_s39, _s40);
        const V _s43 = lanes_add(p_ball_radius, _s40);
        const V _s44 = lanes_sub(_s43, _s39);
        const V _s45 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s47 = lanes_add(p_board_distance, p_board_thickness);
        const V _s57 = lanes_div(K(1.0), p_gravity);
        const V _s59 = lanes_mul(K(2.0), p_gravity);
        const V _s60 = lanes_neg(p_gravity);
        const V _s61 = lanes_neg(_s57);
        const V _s65 = lanes_abs(_s60);
        const V _s76 = lanes_mul(K(1.00006103515625), _s45);
        const V _s77 = lanes_add(p_ring_radius, _s76);
        const V _s83 = lanes_mul(_s77, _s77);
        const V _s84 = lanes_mul(K(9.313225746154785e-10), _s83);
        const V _s89 = lanes_sub(p_ring_radius, _s76);
        const V _s91 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s92 = lanes_max(_s89, _s91);
        const V _s93 = lanes_mul(_s92, _s92);
        const V _s99 = lanes_div(_s76, _s92);
        const V _s105 = lanes_div(K(1.0), _s92);
        const V _s121 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s123 = lanes_mul(K(0.5), p_board_top);
        const V _s124 = lanes_add(p_ball_radius, _s123);
        const V _s125 = lanes_mul(K(0.5), p_board_bottom);
        const V _s126 = lanes_sub(_s124, _s125);
        const V _s127 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s128 = lanes_min(_s127, _s38);
        const V _s129 = lanes_min(_s126, _s128);
        const V _s130 = lanes_mul(K(6.103515625e-05), _s129);
        const V _s137 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s129));
        const V _s138 = lanes_mul(K(1.25), _s65);
        const V _s142 = lanes_max(_s38, _s127);
        const V _s178 = lanes_mul(K(0.5), p_bridge_depth);
        const V _s181 = lanes_add(p_ball_radius, _s178);
        const V _s182 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s183 = lanes_min(_s182, _s44);
        const V _s184 = lanes_min(_s181, _s183);
        const V _s185 = lanes_mul(K(6.103515625e-05), _s184);
        const V _s191 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s184));
        const V _s195 = lanes_max(_s44, _s182);
        const V _s217 = lanes_add(K(1.0), p_inertia);
        const V _s218 = lanes_div(K(1.0), _s217);
        const V _s219 = lanes_mul(p_inertia, _s218);
        const V _s222 = lanes_mul(K(3.637978807091713e-12), p_ball_radius);
        const V _s227 = lanes_mul(K(1.4210854715202004e-14), p_ball_radius);
        const V _s232 = lanes_add(lanes_add(_s227, lanes_mul(K(2.842170943040401e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_board_thickness));
        const V _s235 = lanes_add(_s227, lanes_mul(K(2.842170943040401e-14), p_board_half_width));
        const V _s240 = lanes_add(lanes_add(_s227, lanes_mul(K(1.4210854715202004e-14), _s11)), lanes_mul(K(1.4210854715202004e-14), _s12));
        const V _s245 = lanes_add(lanes_add(_s227, lanes_mul(K(1.4210854715202004e-14), p_ring_radius)), lanes_mul(K(1.4210854715202004e-14), p_board_distance));
        const V _s248 = lanes_add(_s227, lanes_mul(K(2.842170943040401e-14), p_bridge_half_width));
        const V _s255 = lanes_add(lanes_add(_s227, lanes_mul(K(1.4210854715202004e-14), p_wire_radius)), lanes_mul(K(1.4210854715202004e-14), lanes_abs(lanes_sub(p_bridge_depth, p_wire_radius))));
        const V _s261 = lanes_mul(p_ball_radius, p_gravity);
        const V _s296 = lanes_neg(p_board_half_width);
        const V _s297 = lanes_max(K(0.0), _s296);
        const V _s298 = lanes_max(_s297, _s296);
        const V _s300 = lanes_neg(_s47);
        const V _s301 = lanes_max(K(0.0), _s300);
        const V _s302 = lanes_max(_s301, p_board_distance);
        const V _s306 = lanes_neg(p_board_distance);
        const V _s307 = lanes_max(K(0.0), _s306);
        const V _s308 = lanes_max(_s307, p_ring_radius);
        const V _s310 = lanes_neg(p_bridge_half_width);
        const V _s311 = lanes_max(K(0.0), _s310);
        const V _s312 = lanes_max(_s311, _s310);
        const V _s319 = lanes_mul(p_gravity, p_gravity);
        const V _s335 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s33, p_board_distance), p_board_half_width), p_board_thickness), p_bridge_half_width), p_bridge_depth), p_end_depth);
        const V _s339 = lanes_sub(lanes_sub(p_ring_radius, p_ball_radius), p_wire_radius);
        const V _s346 = lanes_div(lanes_mul(p_inertia, lanes_add(K(1.0), p_tangential_restitution)), _s217);
        FIX(0, lanes_add(lanes_add(lanes_add(lanes_add(_s23, lanes_abs(p_board_thickness)), lanes_abs(p_bridge_half_width)), lanes_abs(p_bridge_depth)), lanes_abs(p_end_depth)));
        FIX(1, _s33); FIX(2, lanes_neg(_s36)); FIX(3, _s38); FIX(4, lanes_neg(_s41)); FIX(5, _s44);
        FIX(6, p_ball_radius); FIX(7, p_ring_radius); FIX(8, p_wire_radius);
        FIX(9, p_board_distance); FIX(10, p_board_half_width); FIX(11, p_board_bottom);
        FIX(12, p_board_top); FIX(13, p_bridge_half_width); FIX(14, lanes_mul(_s45, _s45));
        FIX(15, _s47); FIX(16, lanes_sub(p_wire_radius, p_bridge_depth));
        FIX(17, lanes_add(lanes_mul(K(4.0), p_ball_radius), lanes_mul(K(4.0), p_wire_radius)));
        FIX(18, lanes_neg(p_end_depth)); FIX(19, lanes_mul(p_ring_radius, p_ring_radius));
        FIX(20, _s57); FIX(21, p_gravity); FIX(22, _s59); FIX(23, _s60); FIX(24, _s61);
        FIX(25, lanes_mul(K(0.5), _s61)); FIX(26, lanes_mul(K(6.667843360785852e-16), p_end_depth));
        FIX(27, lanes_mul(K(0.5), _s65));
        FIX(28, lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s45)));
        FIX(29, lanes_mul(K(1.52587890625e-05), p_ball_radius));
        FIX(30, lanes_mul(K(1.52587890625e-05), p_wire_radius)); FIX(31, _s76);
        FIX(32, lanes_mul(K(5.820766091346741e-11), _s77)); FIX(33, lanes_mul(K(65536.0), _s77));
        FIX(34, lanes_mul(K(0.5), p_gravity)); FIX(35, _s83); FIX(36, _s84);
        FIX(37, lanes_mul(K(4.0), p_gravity));
        FIX(38, lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s45)); FIX(39, _s93);
        FIX(40, lanes_mul(_s92, _s93)); FIX(41, lanes_mul(K(2.0), p_ring_radius));
        FIX(42, lanes_add(_s84, _s93)); FIX(43, lanes_mul(K(8.940696716308594e-08), _s77));
        FIX(44, lanes_max(K(1.0), _s99)); FIX(45, lanes_sqrt(K(2.0)));
        FIX(46, lanes_add(lanes_mul(K(2.0), p_ball_radius), lanes_mul(K(2.0), p_wire_radius)));
        FIX(47, lanes_mul(_s105, lanes_mul(_s105, _s105))); FIX(48, _s77);
        FIX(49, lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s45), _s77));
        FIX(50, lanes_mul(K(5.00030517578125), _s45)); FIX(51, lanes_mul(K(6.0), p_gravity));
        FIX(52, lanes_mul(K(9.094947017729282e-13), _s77)); FIX(53, _s92);
        FIX(54, lanes_sub(p_ball_radius, p_board_distance));
        FIX(55, lanes_neg(lanes_add(lanes_add(p_ball_radius, p_board_distance), p_board_thickness)));
        FIX(56, _s121); FIX(57, _s123); FIX(58, _s125); FIX(59, _s129);
        FIX(60, lanes_add(_s38, _s130)); FIX(61, _s36); FIX(62, lanes_add(_s127, _s130));
        FIX(63, lanes_sub(lanes_add(_s124, _s130), _s125)); FIX(64, lanes_mul(_s138, _s137));
        FIX(65, lanes_abs(lanes_add(_s125, _s123))); FIX(66, lanes_max(_s142, _s126));
        FIX(67, lanes_mul(K(1.52587890625e-05), _s129));
        FIX(68, lanes_mul(K(5.55653613398821e-16), _s121)); FIX(69, _s137);
        FIX(70, lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        FIX(71, lanes_mul(K(2.001953125), _s137));
        FIX(72, lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        FIX(73, lanes_add(lanes_mul(K(2.220446049250313e-16), _s11), lanes_mul(K(2.220446049250313e-16), _s12)));
        FIX(74, lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s137, _s137)));
        FIX(75, lanes_mul(K(6.667843360785852e-15), _s137));
        FIX(76, lanes_mul(K(12.01171875), _s137));
        FIX(77, lanes_mul(K(2.667137344314341e-15), _s137));
        FIX(78, lanes_mul(K(6.005859375), _s137)); FIX(79, _s65); FIX(80, lanes_abs(K(0.0)));
        FIX(81, lanes_mul(K(0.0625), p_gravity)); FIX(82, lanes_mul(K(1.0000000009313226), _s121));
        FIX(83, lanes_mul(K(1.0000000009313226), lanes_sub(_s40, _s39)));
        FIX(84, lanes_mul(K(1.0000000009313226), p_bridge_half_width));
        FIX(85, lanes_sub(p_wire_radius, _s178)); FIX(86, lanes_mul(K(1.0000000009313226), _s178));
        FIX(87, _s178); FIX(88, _s184); FIX(89, lanes_sub(lanes_add(_s43, _s185), _s39));
        FIX(90, _s41); FIX(91, lanes_add(_s182, _s185)); FIX(92, lanes_add(_s181, _s185));
        FIX(93, lanes_mul(_s138, _s191)); FIX(94, lanes_abs(lanes_sub(_s178, p_wire_radius)));
        FIX(95, lanes_max(_s195, _s181)); FIX(96, lanes_mul(K(1.52587890625e-05), _s184));
        FIX(97, _s191); FIX(98, lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        FIX(99, lanes_mul(K(2.001953125), _s191));
        FIX(100, lanes_add(lanes_mul(K(1.1102230246251565e-16), p_ring_radius), lanes_mul(K(1.1102230246251565e-16), p_board_distance)));
        FIX(101, lanes_add(lanes_mul(K(5.551115123125783e-16), p_wire_radius), lanes_mul(K(2.220446049250313e-16), p_bridge_depth)));
        FIX(102, lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s191, _s191)));
        FIX(103, lanes_mul(K(6.667843360785852e-15), _s191));
        FIX(104, lanes_mul(K(12.01171875), _s191));
        FIX(105, lanes_mul(K(2.667137344314341e-15), _s191));
        FIX(106, lanes_mul(K(6.005859375), _s191)); FIX(107, lanes_div(K(1.0), _s45));
        FIX(108, lanes_mul(K(0.5), p_ball_radius)); FIX(109, _s219);
        FIX(110, lanes_div(K(1.0), p_ball_radius)); FIX(111, _s222); FIX(112, lanes_neg(_s222));
        FIX(113, lanes_mul(K(1.4551915228366852e-11), p_ball_radius)); FIX(114, _s232);
        FIX(115, lanes_neg(_s232)); FIX(116, _s235); FIX(117, lanes_neg(_s235)); FIX(118, _s240);
        FIX(119, lanes_neg(_s240)); FIX(120, _s245); FIX(121, lanes_neg(_s245)); FIX(122, _s248);
        FIX(123, lanes_neg(_s248)); FIX(124, _s255); FIX(125, lanes_neg(_s255)); FIX(126, _s218);
        FIX(127, lanes_mul(p_gravity, _s218)); FIX(128, lanes_mul(K(0.015625), p_gravity));
        FIX(129, lanes_mul(K(5.684341886080802e-14), lanes_sqrt(_s261)));
        FIX(130, lanes_mul(K(5.684341886080802e-14), p_gravity)); FIX(131, _s45);
        FIX(132, p_bridge_depth); FIX(133, lanes_mul(K(1.1102230246251565e-16), p_ball_radius));
        FIX(134, lanes_mul(K(2.384185791015625e-07), p_ball_radius));
        FIX(135, lanes_mul(p_ring_radius, _s218)); FIX(136, _s39);
        FIX(137, lanes_mul(K(0.3333333333333333), p_ring_radius));
        FIX(138, lanes_mul(K(0.25), p_ring_radius)); FIX(139, lanes_mul(K(0.2), p_ring_radius));
        FIX(140, lanes_mul(K(0.16666666666666666), p_ring_radius));
        FIX(141, lanes_mul(K(0.14285714285714285), p_ring_radius));
        FIX(142, lanes_mul(K(0.125), p_ring_radius));
        FIX(143, lanes_mul(K(0.1111111111111111), p_ring_radius));
        FIX(144, lanes_mul(K(0.1), p_ring_radius));
        FIX(145, lanes_mul(K(0.09090909090909091), p_ring_radius));
        FIX(146, lanes_mul(K(0.08333333333333333), p_ring_radius));
        FIX(147, lanes_mul(p_gravity, lanes_sub(K(3.0), lanes_mul(K(2.0), _s219))));
        FIX(148, lanes_mul(K(3.0), p_ring_radius)); FIX(149, lanes_mul(K(6.0), p_ring_radius));
        FIX(150, lanes_mul(_s59, _s219));
        FIX(151, lanes_sqrt(lanes_add(lanes_mul(_s298, _s298), lanes_mul(_s302, _s302))));
        FIX(152, lanes_sqrt(lanes_add(lanes_mul(_s308, _s308), lanes_mul(_s312, _s312))));
        FIX(153, lanes_mul(K(0.000244140625), _s45)); FIX(154, lanes_mul(K(0.00390625), p_gravity));
        FIX(155, lanes_mul(lanes_mul(K(0.000244140625), _s319), _s45));
        FIX(156, lanes_mul(K(3.0), p_gravity));
        FIX(157, lanes_mul(K(2.0), lanes_mul(K(3.0), _s319)));
        FIX(158, lanes_mul(K(0.0078125), p_gravity)); FIX(159, lanes_max(K(0.0), p_gravity));
        FIX(160, lanes_mul(K(8.0), _s57)); FIX(161, lanes_add(lanes_add(_s335, _s11), _s12));
        FIX(162, lanes_div(K(1.0), lanes_min(_s339, _s45))); FIX(163, p_restitution_speed);
        FIX(164, _s346); FIX(165, lanes_mul(_s346, _s346));
        FIX(166, lanes_mul(p_ball_radius, p_inertia));
        FIX(167, lanes_mul(K(1.52587890625e-05), _s261));
        FIX(168, lanes_mul(K(7.275957614183426e-12), p_ball_radius));
        FIX(169, lanes_mul(K(1.1920928955078125e-07), p_ball_radius));
        FIX(170, lanes_mul(K(3.725290298461914e-09), p_ball_radius));
    }
    {
        const S _p_ball_radius = lanes_narrow(p_ball_radius);
        const S _p_ring_radius = lanes_narrow(p_ring_radius);
        const S _p_wire_radius = lanes_narrow(p_wire_radius);
        const S _p_gravity = lanes_narrow(p_gravity);
        const S _p_board_distance = lanes_narrow(p_board_distance);
        const S _p_board_half_width = lanes_narrow(p_board_half_width);
        const S _p_board_bottom = lanes_narrow(p_board_bottom);
        const S _p_board_top = lanes_narrow(p_board_top);
        const S _p_board_thickness = lanes_narrow(p_board_thickness);
        const S _p_bridge_half_width = lanes_narrow(p_bridge_half_width);
        const S _p_bridge_depth = lanes_narrow(p_bridge_depth);
        const S _p_inertia = lanes_narrow(p_inertia);
        const S _p_tangential_restitution = lanes_narrow(p_tangential_restitution);
        const S _p_restitution_speed = lanes_narrow(p_restitution_speed);
        const S _s6 = singles_add(_p_ball_radius, _p_wire_radius);
        const S _s7 = singles_mul(KS(1.00006103515625), _s6);
        const S _s11 = singles_add(_p_ring_radius, _s7);
        const S _s13 = singles_sub(_p_ring_radius, _s7);
        const S _s15 = singles_mul(KS(0.0001220703125), _p_ring_radius);
        const S _s16 = singles_max(_s13, _s15);
        const S _s23 = singles_div(_s6, _s16);
        const S _s24 = singles_max(KS(1.0), _s23);
        const S _s31 = singles_div(KS(1.0), _s16);
        const S _s58 = singles_div(KS(1.0), _s6);
        const S _s60 = singles_sub(singles_sub(_p_ring_radius, _p_ball_radius), _p_wire_radius);
        const S _s61 = singles_min(_s60, _s6);
        const S _s69 = singles_mul(KS(2.0), singles_mul(_p_ring_radius, _s58));
        const S _s82 = singles_div(KS(1.0), _p_ball_radius);
        const S _s83 = singles_add(_p_board_distance, _p_board_thickness);
        const S _s95 = singles_mul(KS(9.5367431640625e-07), singles_add(singles_add(singles_add(singles_add(singles_mul(KS(2.0), _p_board_distance), singles_mul(KS(2.0), _p_board_half_width)), _p_board_thickness), singles_abs(_p_board_bottom)), singles_abs(_p_board_top)));
        const S _s114 = singles_mul(KS(9.5367431640625e-07), singles_add(singles_add(singles_add(singles_add(_p_ring_radius, singles_mul(KS(2.0), _p_wire_radius)), _p_board_distance), singles_mul(KS(2.0), _p_bridge_half_width)), _p_bridge_depth));
        const S _s124 = singles_div(singles_mul(_p_inertia, singles_add(KS(1.0), _p_tangential_restitution)), singles_add(KS(1.0), _p_inertia));
        const S _s135 = singles_mul(KS(1.00048828125), _s11);
        const S _s138 = singles_mul(KS(0.00048828125), _s11);
        const S _s144 = singles_sub(_s13, _s138);
        FIX_SINGLE(0, _p_gravity); FIX_SINGLE(1, _s7);
        FIX_SINGLE(2, singles_mul(KS(2.0), _p_gravity));
        FIX_SINGLE(3, singles_div(KS(1.0), _p_gravity)); FIX_SINGLE(4, _s11);
        FIX_SINGLE(5, singles_mul(_s11, _s11)); FIX_SINGLE(6, _s16);
        FIX_SINGLE(7, singles_mul(_s16, _s16)); FIX_SINGLE(8, singles_mul(KS(32.0), _s16));
        FIX_SINGLE(9, singles_add(singles_mul(KS(32.0), _p_ball_radius), singles_mul(KS(32.0), _p_wire_radius)));
        FIX_SINGLE(10, _s6); FIX_SINGLE(11, _s24); FIX_SINGLE(12, singles_mul(KS(4.0), _p_gravity));
        FIX_SINGLE(13, singles_mul(KS(2.0), _p_ring_radius));
        FIX_SINGLE(14, singles_mul(singles_mul(KS(6.0003662109375), _p_gravity), _s6));
        FIX_SINGLE(15, singles_mul(_s31, singles_mul(_s31, _s31)));
        FIX_SINGLE(16, singles_mul(KS(5.0048828125), _s6));
        FIX_SINGLE(17, singles_mul(KS(7.62939453125e-06), singles_mul(singles_div(_s11, _s16), _s24)));
        FIX_SINGLE(18, singles_add(singles_mul(KS(128.0), _p_ball_radius), singles_mul(KS(128.0), _p_wire_radius)));
        FIX_SINGLE(19, _p_ring_radius); FIX_SINGLE(20, singles_mul(KS(0.5), _p_gravity));
        FIX_SINGLE(21, singles_mul(_s6, _s6)); FIX_SINGLE(22, singles_mul(KS(6.0), _p_gravity));
        FIX_SINGLE(23, singles_add(singles_mul(KS(0.0001220703125), _p_ball_radius), singles_mul(KS(0.0001220703125), _p_wire_radius)));
        FIX_SINGLE(24, singles_mul(KS(9.5367431640625e-07), _s11));
        FIX_SINGLE(25, singles_add(singles_mul(KS(0.000244140625), _p_ball_radius), singles_mul(KS(0.000244140625), _p_wire_radius)));
        FIX_SINGLE(26, _s58); FIX_SINGLE(27, _s61); FIX_SINGLE(28, singles_div(KS(1.0), _s61));
        FIX_SINGLE(29, singles_mul(singles_sqrt(_p_gravity), singles_sqrt(_s6)));
        FIX_SINGLE(30, singles_mul(KS(1.1102230246251565e-16), singles_add(KS(16.0), _s69)));
        FIX_SINGLE(31, singles_mul(KS(3.5), _s6));
        FIX_SINGLE(32, singles_mul(KS(1.1102230246251565e-16), singles_add(KS(7.0), _s69)));
        FIX_SINGLE(33, _p_ball_radius); FIX_SINGLE(34, _p_board_distance);
        FIX_SINGLE(35, _p_board_half_width); FIX_SINGLE(36, _p_board_bottom);
        FIX_SINGLE(37, _p_board_top); FIX_SINGLE(38, _s82); FIX_SINGLE(39, _s83);
        FIX_SINGLE(40, singles_neg(_p_board_half_width));
        FIX_SINGLE(41, singles_neg(_p_board_distance)); FIX_SINGLE(42, singles_neg(_s83));
        FIX_SINGLE(43, _s95);
        FIX_SINGLE(44, singles_add(singles_mul(KS(2.220446049250313e-16), _p_board_distance), singles_mul(KS(2.220446049250313e-16), _p_board_thickness)));
        FIX_SINGLE(45, singles_mul(KS(8.881784197001252e-16), _p_ball_radius));
        FIX_SINGLE(46, singles_mul(KS(2.0), _s82)); FIX_SINGLE(47, _p_wire_radius);
        FIX_SINGLE(48, _p_bridge_half_width);
        FIX_SINGLE(49, singles_sub(_p_wire_radius, _p_bridge_depth));
        FIX_SINGLE(50, singles_neg(_p_bridge_half_width));
        FIX_SINGLE(51, singles_neg(_p_ring_radius)); FIX_SINGLE(52, _s114);
        FIX_SINGLE(53, singles_add(singles_mul(KS(1.1102230246251565e-16), _p_wire_radius), singles_mul(KS(2.220446049250313e-16), _p_bridge_depth)));
        FIX_SINGLE(54, _p_restitution_speed); FIX_SINGLE(55, _s124);
        FIX_SINGLE(56, singles_abs(KS(0.0)));
        FIX_SINGLE(57, singles_div(KS(1.0), _p_restitution_speed));
        FIX_SINGLE(58, singles_mul(KS(32.0), _s124)); FIX_SINGLE(59, singles_neg(_p_ball_radius));
        FIX_SINGLE(60, singles_div(KS(1.0), singles_mul(_p_ball_radius, _p_inertia)));
        FIX_SINGLE(61, singles_add(KS(1.0), singles_div(KS(1.0), _p_inertia)));
        FIX_SINGLE(62, singles_mul(_s135, _s135)); FIX_SINGLE(63, singles_add(_s7, _s138));
        FIX_SINGLE(64, singles_sub(singles_sub(_p_ring_radius, singles_mul(KS(1.4143014047294855), _s6)), _s138));
        FIX_SINGLE(65, _s144); FIX_SINGLE(66, singles_mul(_s144, _s144));
        FIX_SINGLE(67, singles_mul(KS(128.0), _s11));
        FIX_SINGLE(68, singles_mul(KS(1.52587890625e-05), _s11));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */

LANES_APART void LOOP(fix_rows_1)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, , p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width)
    EACH(PARAMETER, , p_board_thickness, p_board_top, p_bridge_depth, p_bridge_half_width)
    EACH(PARAMETER, , p_end_depth, p_ring_radius, p_wire_radius)
    {
        const V _s21 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_abs(p_board_bottom), lanes_abs(p_board_top)), lanes_abs(p_ball_radius)), lanes_abs(p_ring_radius)), lanes_abs(p_wire_radius)), lanes_abs(p_board_distance));
        const V _s31 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s21, lanes_abs(p_board_half_width)), lanes_abs(p_board_thickness)), lanes_abs(p_bridge_half_width)), lanes_abs(p_bridge_depth)), lanes_abs(p_end_depth));
        const V _s35 = lanes_mul(K(0.5), p_board_thickness);
        const V _s39 = lanes_mul(K(0.5), p_ring_radius);
        const V _s40 = lanes_mul(K(0.5), p_board_distance);
        const V _s45 = lanes_add(p_ball_radius, p_wire_radius);
        FIX(0, _s31); FIX(1, lanes_add(lanes_add(p_ball_radius, p_ring_radius), p_wire_radius));
        FIX(2, lanes_neg(lanes_add(p_board_distance, _s35)));
        FIX(3, lanes_add(p_ball_radius, _s35)); FIX(4, lanes_neg(lanes_add(_s39, _s40)));
        FIX(5, lanes_sub(lanes_add(p_ball_radius, _s40), _s39)); FIX(6, p_ball_radius);
        FIX(7, p_ring_radius); FIX(8, p_wire_radius); FIX(9, p_board_distance);
        FIX(10, p_board_half_width); FIX(11, p_board_bottom); FIX(12, p_board_top);
        FIX(13, p_bridge_half_width); FIX(14, lanes_mul(_s45, _s45));
        FIX(15, lanes_add(p_board_distance, p_board_thickness));
        FIX(16, lanes_sub(p_wire_radius, p_bridge_depth));
        FIX(17, lanes_add(lanes_mul(K(4.0), p_ball_radius), lanes_mul(K(4.0), p_wire_radius)));
        FIX(18, lanes_neg(p_end_depth)); FIX(19, lanes_mul(p_ring_radius, p_ring_radius));
    }
}

LANES_APART void LOOP(fix_rows_2)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, , p_ball_radius, p_end_depth, p_gravity, p_ring_radius, p_wire_radius)
    {
        const V _s45 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s57 = lanes_div(K(1.0), p_gravity);
#if BOUNDED
        const V _s60 = lanes_neg(p_gravity);
#endif
        const V _s61 = lanes_neg(_s57);
        const V _s76 = lanes_mul(K(1.00006103515625), _s45);
        const V _s77 = lanes_add(p_ring_radius, _s76);
        const V _s83 = lanes_mul(_s77, _s77);
        const V _s84 = lanes_mul(K(9.313225746154785e-10), _s83);
        const V _s89 = lanes_sub(p_ring_radius, _s76);
        const V _s91 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s92 = lanes_max(_s89, _s91);
        const V _s93 = lanes_mul(_s92, _s92);
        FIX(7, p_ring_radius); FIX(14, lanes_mul(_s45, _s45)); FIX(18, lanes_neg(p_end_depth));
        FIX(20, _s57); FIX(21, p_gravity); FIX(22, lanes_mul(K(2.0), p_gravity));
#if BOUNDED
        FIX(23, _s60);
#else
        FIX(23, lanes_neg(p_gravity));
#endif
        FIX(24, _s61); FIX(25, lanes_mul(K(0.5), _s61));
#if BOUNDED
        FIX(26, lanes_mul(K(6.667843360785852e-16), p_end_depth));
        FIX(27, lanes_mul(K(0.5), lanes_abs(_s60)));
#endif
        FIX(28, lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s45)));
        FIX(29, lanes_mul(K(1.52587890625e-05), p_ball_radius));
        FIX(30, lanes_mul(K(1.52587890625e-05), p_wire_radius)); FIX(31, _s76);
        FIX(32, lanes_mul(K(5.820766091346741e-11), _s77)); FIX(33, lanes_mul(K(65536.0), _s77));
        FIX(34, lanes_mul(K(0.5), p_gravity)); FIX(35, _s83); FIX(36, _s84);
        FIX(37, lanes_mul(K(4.0), p_gravity));
        FIX(38, lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s45)); FIX(39, _s93);
        FIX(40, lanes_mul(_s92, _s93)); FIX(41, lanes_mul(K(2.0), p_ring_radius));
        FIX(42, lanes_add(_s84, _s93));
    }
}

LANES_APART void LOOP(fix_rows_3)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, , p_ball_radius, p_gravity, p_ring_radius, p_wire_radius)
    {
#if BOUNDED
        const V _s45 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s76 = lanes_mul(K(1.00006103515625), _s45);
        const V _s89 = lanes_sub(p_ring_radius, _s76);
        const V _s91 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s99 = lanes_div(_s76, lanes_max(_s89, _s91));
#endif
        FIX(7, p_ring_radius);
#if BOUNDED
        FIX(20, lanes_div(K(1.0), p_gravity));
#endif
        FIX(21, p_gravity);
#if BOUNDED
        FIX(28, lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s45)));
        FIX(29, lanes_mul(K(1.52587890625e-05), p_ball_radius));
        FIX(30, lanes_mul(K(1.52587890625e-05), p_wire_radius)); FIX(31, _s76);
#endif
        FIX(34, lanes_mul(K(0.5), p_gravity));
#if BOUNDED
        FIX(43, lanes_mul(K(8.940696716308594e-08), lanes_add(p_ring_radius, _s76)));
        FIX(44, lanes_max(K(1.0), _s99)); FIX(45, lanes_sqrt(K(2.0)));
        FIX(46, lanes_add(lanes_mul(K(2.0), p_ball_radius), lanes_mul(K(2.0), p_wire_radius)));
#endif
    }
    {
        const S _p_ball_radius = lanes_narrow(p_ball_radius);
        const S _p_ring_radius = lanes_narrow(p_ring_radius);
        const S _p_wire_radius = lanes_narrow(p_wire_radius);
        const S _p_gravity = lanes_narrow(p_gravity);
        const S _s6 = singles_add(_p_ball_radius, _p_wire_radius);
        const S _s7 = singles_mul(KS(1.00006103515625), _s6);
        const S _s11 = singles_add(_p_ring_radius, _s7);
        const S _s13 = singles_sub(_p_ring_radius, _s7);
        const S _s15 = singles_mul(KS(0.0001220703125), _p_ring_radius);
        const S _s16 = singles_max(_s13, _s15);
        const S _s23 = singles_div(_s6, _s16);
        const S _s24 = singles_max(KS(1.0), _s23);
        const S _s31 = singles_div(KS(1.0), _s16);
        FIX_SINGLE(0, _p_gravity); FIX_SINGLE(1, _s7);
        FIX_SINGLE(2, singles_mul(KS(2.0), _p_gravity));
        FIX_SINGLE(3, singles_div(KS(1.0), _p_gravity)); FIX_SINGLE(4, _s11);
        FIX_SINGLE(5, singles_mul(_s11, _s11)); FIX_SINGLE(6, _s16);
        FIX_SINGLE(7, singles_mul(_s16, _s16)); FIX_SINGLE(8, singles_mul(KS(32.0), _s16));
        FIX_SINGLE(9, singles_add(singles_mul(KS(32.0), _p_ball_radius), singles_mul(KS(32.0), _p_wire_radius)));
        FIX_SINGLE(10, _s6); FIX_SINGLE(11, _s24); FIX_SINGLE(12, singles_mul(KS(4.0), _p_gravity));
        FIX_SINGLE(13, singles_mul(KS(2.0), _p_ring_radius));
        FIX_SINGLE(14, singles_mul(singles_mul(KS(6.0003662109375), _p_gravity), _s6));
        FIX_SINGLE(15, singles_mul(_s31, singles_mul(_s31, _s31)));
        FIX_SINGLE(16, singles_mul(KS(5.0048828125), _s6));
        FIX_SINGLE(17, singles_mul(KS(7.62939453125e-06), singles_mul(singles_div(_s11, _s16), _s24)));
        FIX_SINGLE(18, singles_add(singles_mul(KS(128.0), _p_ball_radius), singles_mul(KS(128.0), _p_wire_radius)));
        FIX_SINGLE(19, _p_ring_radius); FIX_SINGLE(20, singles_mul(KS(0.5), _p_gravity));
        FIX_SINGLE(21, singles_mul(_s6, _s6)); FIX_SINGLE(22, singles_mul(KS(6.0), _p_gravity));
        FIX_SINGLE(23, singles_add(singles_mul(KS(0.0001220703125), _p_ball_radius), singles_mul(KS(0.0001220703125), _p_wire_radius)));
        FIX_SINGLE(24, singles_mul(KS(9.5367431640625e-07), _s11));
        FIX_SINGLE(25, singles_add(singles_mul(KS(0.000244140625), _p_ball_radius), singles_mul(KS(0.000244140625), _p_wire_radius)));
    }
}

LANES_APART void LOOP(fix_stepping_rows_1)(LOOP(worklist) *worklist, size_t taken, M idle)
{
    EACH(PARAMETER_TAKEN, stepping_, p_ball_radius, p_gravity, p_ring_radius, p_wire_radius)
    EACH(TURNING, turning_, p_ball_radius, p_gravity, p_ring_radius, p_wire_radius)
    {
        const S _p_ball_radius = lanes_narrow(p_ball_radius);
        const S _p_ring_radius = lanes_narrow(p_ring_radius);
        const S _p_wire_radius = lanes_narrow(p_wire_radius);
        const S _p_gravity = lanes_narrow(p_gravity);
        const S _s6 = singles_add(_p_ball_radius, _p_wire_radius);
        const S _s7 = singles_mul(KS(1.00006103515625), _s6);
        const S _s13 = singles_sub(_p_ring_radius, _s7);
        const S _s15 = singles_mul(KS(0.0001220703125), _p_ring_radius);
        FIX_SINGLE(0, _p_gravity); FIX_SINGLE(1, _s7); FIX_SINGLE(6, singles_max(_s13, _s15));
        FIX_SINGLE(19, _p_ring_radius); FIX_SINGLE(20, singles_mul(KS(0.5), _p_gravity));
        FIX_SINGLE(21, singles_mul(_s6, _s6)); FIX_SINGLE(22, singles_mul(KS(6.0), _p_gravity));
        FIX_SINGLE(23, singles_add(singles_mul(KS(0.0001220703125), _p_ball_radius), singles_mul(KS(0.0001220703125), _p_wire_radius)));
        FIX_SINGLE(24, singles_mul(KS(9.5367431640625e-07), singles_add(_p_ring_radius, _s7)));
        FIX_SINGLE(25, singles_add(singles_mul(KS(0.000244140625), _p_ball_radius), singles_mul(KS(0.000244140625), _p_wire_radius)));
    }
}

LANES_APART void LOOP(fix_searching_rows_1)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, searching_, p_ball_radius, p_gravity, p_ring_radius, p_wire_radius)
    {
        const V _s45 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s76 = lanes_mul(K(1.00006103515625), _s45);
        const V _s77 = lanes_add(p_ring_radius, _s76);
        const V _s89 = lanes_sub(p_ring_radius, _s76);
        const V _s91 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s92 = lanes_max(_s89, _s91);
        const V _s99 = lanes_div(_s76, _s92);
        const V _s105 = lanes_div(K(1.0), _s92);
        FIX(20, lanes_div(K(1.0), p_gravity)); FIX(21, p_gravity);
        FIX(22, lanes_mul(K(2.0), p_gravity));
        FIX(28, lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s45)));
        FIX(29, lanes_mul(K(1.52587890625e-05), p_ball_radius));
        FIX(30, lanes_mul(K(1.52587890625e-05), p_wire_radius)); FIX(31, _s76);
        FIX(35, lanes_mul(_s77, _s77)); FIX(37, lanes_mul(K(4.0), p_gravity));
        FIX(38, lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s45));
        FIX(39, lanes_mul(_s92, _s92)); FIX(41, lanes_mul(K(2.0), p_ring_radius));
        FIX(44, lanes_max(K(1.0), _s99)); FIX(45, lanes_sqrt(K(2.0)));
        FIX(46, lanes_add(lanes_mul(K(2.0), p_ball_radius), lanes_mul(K(2.0), p_wire_radius)));
        FIX(47, lanes_mul(_s105, lanes_mul(_s105, _s105))); FIX(48, _s77);
        FIX(49, lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s45), _s77));
        FIX(50, lanes_mul(K(5.00030517578125), _s45));
    }
}

LANES_APART void LOOP(fix_searching_searching_rows_1)(LOOP(worklist) *worklist, size_t taken, M idle)
{
    EACH(PARAMETER_TAKEN, searching_searching_, p_ball_radius, p_gravity, p_ring_radius)
    EACH(PARAMETER_TAKEN, searching_searching_, p_wire_radius)
    EACH(TURNING, turning_, p_ball_radius, p_gravity, p_ring_radius, p_wire_radius)
    {
        const V _s45 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s76 = lanes_mul(K(1.00006103515625), _s45);
        const V _s77 = lanes_add(p_ring_radius, _s76);
        const V _s89 = lanes_sub(p_ring_radius, _s76);
        const V _s91 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s92 = lanes_max(_s89, _s91);
        const V _s99 = lanes_div(_s76, _s92);
        FIX(7, p_ring_radius); FIX(14, lanes_mul(_s45, _s45)); FIX(21, p_gravity); FIX(31, _s76);
        FIX(34, lanes_mul(K(0.5), p_gravity)); FIX(44, lanes_max(K(1.0), _s99)); FIX(48, _s77);
        FIX(49, lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s45), _s77));
        FIX(50, lanes_mul(K(5.00030517578125), _s45)); FIX(51, lanes_mul(K(6.0), p_gravity));
        FIX(52, lanes_mul(K(9.094947017729282e-13), _s77)); FIX(53, _s92);
    }
}

LANES_APART void LOOP(fix_rows_4)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, , p_ball_radius, p_gravity, p_ring_radius, p_wire_radius)
    {
        const V _s45 = lanes_add(p_ball_radius, p_wire_radius);
        FIX(7, p_ring_radius); FIX(14, lanes_mul(_s45, _s45)); FIX(21, p_gravity);
        FIX(34, lanes_mul(K(0.5), p_gravity));
    }
}

LANES_APART void LOOP(fix_refining_rows_1)(LOOP(worklist) *worklist, size_t taken, M idle)
{
    EACH(PARAMETER_TAKEN, refining_, p_ball_radius, p_gravity, p_ring_radius, p_wire_radius)
    EACH(TURNING, turning_, p_ball_radius, p_gravity, p_ring_radius, p_wire_radius)
    {
        const V _s45 = lanes_add(p_ball_radius, p_wire_radius);
        FIX(7, p_ring_radius); FIX(14, lanes_mul(_s45, _s45)); FIX(21, p_gravity);
        FIX(34, lanes_mul(K(0.5), p_gravity));
    }
}

LANES_APART void LOOP(fix_rows_5)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, , p_ball_radius)
#if BOUNDED
    EACH(PARAMETER, , p_gravity, p_ring_radius, p_wire_radius)
    {
        const V _s45 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s76 = lanes_mul(K(1.00006103515625), _s45);
        const V _s77 = lanes_add(p_ring_radius, _s76);
        const V _s89 = lanes_sub(p_ring_radius, _s76);
        const V _s91 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s99 = lanes_div(_s76, lanes_max(_s89, _s91));
        FIX(21, p_gravity); FIX(31, _s76); FIX(44, lanes_max(K(1.0), _s99)); FIX(48, _s77);
        FIX(49, lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s45), _s77));
        FIX(50, lanes_mul(K(5.00030517578125), _s45));
    }
}

LANES_APART void LOOP(fix_rows_6)(LOOP(worklist) *worklist, size_t i)
{
#endif
    EACH(PARAMETER, , p_board_bottom, p_board_distance, p_board_half_width, p_board_thickness)
    EACH(PARAMETER, , p_board_top, p_gravity)
    BOUNDS(EACH(PARAMETER, , p_ball_radius))
    {
        FIX(9, p_board_distance); FIX(10, p_board_half_width); FIX(11, p_board_bottom);
        FIX(12, p_board_top); FIX(15, lanes_add(p_board_distance, p_board_thickness));
        FIX(20, lanes_div(K(1.0), p_gravity)); FIX(21, p_gravity);
        FIX(54, lanes_sub(p_ball_radius, p_board_distance));
        FIX(55, lanes_neg(lanes_add(lanes_add(p_ball_radius, p_board_distance), p_board_thickness)));
        FIX(56, lanes_mul(p_ball_radius, p_ball_radius));
    }
}

LANES_APART void LOOP(fix_reachable_rows_1)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, reachable_, p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width)
    EACH(PARAMETER, reachable_, p_board_thickness, p_board_top, p_gravity)
    {
        const V _s35 = lanes_mul(K(0.5), p_board_thickness);
        const V _s38 = lanes_add(p_ball_radius, _s35);
        const V _s65 = lanes_abs(lanes_neg(p_gravity));
        const V _s121 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s123 = lanes_mul(K(0.5), p_board_top);
        const V _s124 = lanes_add(p_ball_radius, _s123);
        const V _s125 = lanes_mul(K(0.5), p_board_bottom);
        const V _s126 = lanes_sub(_s124, _s125);
        const V _s127 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s128 = lanes_min(_s127, _s38);
        const V _s129 = lanes_min(_s126, _s128);
        const V _s130 = lanes_mul(K(6.103515625e-05), _s129);
        const V _s137 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s129));
        const V _s142 = lanes_max(_s38, _s127);
        FIX(9, p_board_distance); FIX(10, p_board_half_width); FIX(11, p_board_bottom);
        FIX(12, p_board_top); FIX(15, lanes_add(p_board_distance, p_board_thickness));
        FIX(20, lanes_div(K(1.0), p_gravity)); FIX(21, p_gravity);
        FIX(22, lanes_mul(K(2.0), p_gravity)); FIX(27, lanes_mul(K(0.5), _s65));
        FIX(34, lanes_mul(K(0.5), p_gravity)); FIX(45, lanes_sqrt(K(2.0))); FIX(56, _s121);
        FIX(57, _s123); FIX(58, _s125); FIX(59, _s129); FIX(60, lanes_add(_s38, _s130));
        FIX(61, lanes_add(p_board_distance, _s35)); FIX(62, lanes_add(_s127, _s130));
        FIX(63, lanes_sub(lanes_add(_s124, _s130), _s125));
        FIX(64, lanes_mul(lanes_mul(K(1.25), _s65), _s137));
        FIX(65, lanes_abs(lanes_add(_s125, _s123))); FIX(66, lanes_max(_s142, _s126));
        FIX(67, lanes_mul(K(1.52587890625e-05), _s129));
        FIX(68, lanes_mul(K(5.55653613398821e-16), _s121)); FIX(69, _s137);
        FIX(70, lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        FIX(71, lanes_mul(K(2.001953125), _s137));
        FIX(72, lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        FIX(73, lanes_add(lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_bottom)), lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_top))));
        FIX(74, lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s137, _s137)));
        FIX(75, lanes_mul(K(6.667843360785852e-15), _s137));
        FIX(76, lanes_mul(K(12.01171875), _s137));
        FIX(77, lanes_mul(K(2.667137344314341e-15), _s137));
        FIX(78, lanes_mul(K(6.005859375), _s137)); FIX(79, _s65);
    }
}

LANES_APART void LOOP(fix_reachable_searching_rows_1)(LOOP(worklist) *worklist, size_t taken, M idle)
{
    EACH(PARAMETER_TAKEN, reachable_searching_, p_ball_radius, p_board_bottom, p_board_distance)
    EACH(PARAMETER_TAKEN, reachable_searching_, p_board_half_width, p_board_thickness, p_board_top)
    EACH(PARAMETER_TAKEN, reachable_searching_, p_gravity)
    EACH(TURNING, turning_, p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width)
    EACH(TURNING, turning_, p_board_thickness, p_board_top, p_gravity)
    {
        const V _s38 = lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_thickness));
        const V _s65 = lanes_abs(lanes_neg(p_gravity));
        const V _s121 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s126 = lanes_sub(lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_top)), lanes_mul(K(0.5), p_board_bottom));
        const V _s127 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s128 = lanes_min(_s127, _s38);
        const V _s137 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), lanes_min(_s126, _s128)));
        FIX(9, p_board_distance); FIX(10, p_board_half_width); FIX(11, p_board_bottom);
        FIX(12, p_board_top); FIX(15, lanes_add(p_board_distance, p_board_thickness));
        FIX(21, p_gravity); FIX(27, lanes_mul(K(0.5), _s65)); FIX(34, lanes_mul(K(0.5), p_gravity));
        FIX(56, _s121); FIX(68, lanes_mul(K(5.55653613398821e-16), _s121)); FIX(69, _s137);
        FIX(70, lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        FIX(71, lanes_mul(K(2.001953125), _s137));
        FIX(72, lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        FIX(73, lanes_add(lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_bottom)), lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_top))));
        FIX(74, lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s137, _s137)));
        FIX(75, lanes_mul(K(6.667843360785852e-15), _s137));
        FIX(76, lanes_mul(K(12.01171875), _s137));
        FIX(77, lanes_mul(K(2.667137344314341e-15), _s137));
        FIX(78, lanes_mul(K(6.005859375), _s137)); FIX(79, _s65);
    }
}

LANES_APART void LOOP(fix_reachable_rows_2)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, reachable_, p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width)
    EACH(PARAMETER, reachable_, p_board_thickness, p_board_top, p_gravity)
    {
        FIX(9, p_board_distance); FIX(10, p_board_half_width); FIX(11, p_board_bottom);
        FIX(12, p_board_top); FIX(15, lanes_add(p_board_distance, p_board_thickness));
        FIX(21, p_gravity); FIX(34, lanes_mul(K(0.5), p_gravity));
        FIX(56, lanes_mul(p_ball_radius, p_ball_radius));
    }
}

LANES_APART void LOOP(fix_reachable_refining_rows_1)(LOOP(worklist) *worklist, size_t taken, M idle)
{
    EACH(PARAMETER_TAKEN, reachable_refining_, p_ball_radius, p_board_bottom, p_board_distance)
    EACH(PARAMETER_TAKEN, reachable_refining_, p_board_half_width, p_board_thickness, p_board_top)
    EACH(PARAMETER_TAKEN, reachable_refining_, p_gravity)
    EACH(TURNING, turning_, p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width)
    EACH(TURNING, turning_, p_board_thickness, p_board_top, p_gravity)
    {
        FIX(9, p_board_distance); FIX(10, p_board_half_width); FIX(11, p_board_bottom);
        FIX(12, p_board_top); FIX(15, lanes_add(p_board_distance, p_board_thickness));
        FIX(21, p_gravity); FIX(34, lanes_mul(K(0.5), p_gravity));
        FIX(56, lanes_mul(p_ball_radius, p_ball_radius));
    }
}

#if BOUNDED
LANES_APART void LOOP(fix_reachable_rows_3)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, reachable_, p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width)
    EACH(PARAMETER, reachable_, p_board_thickness, p_board_top, p_gravity)
    {
        const V _s38 = lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_thickness));
        const V _s126 = lanes_sub(lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_top)), lanes_mul(K(0.5), p_board_bottom));
        const V _s127 = lanes_add(p_ball_radius, p_board_half_width);
        const V _s128 = lanes_min(_s127, _s38);
        const V _s137 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), lanes_min(_s126, _s128)));
        FIX(21, p_gravity);
        FIX(68, lanes_mul(K(5.55653613398821e-16), lanes_mul(p_ball_radius, p_ball_radius)));
        FIX(69, _s137); FIX(70, lanes_mul(K(3.3306690738754696e-16), p_board_half_width));
        FIX(71, lanes_mul(K(2.001953125), _s137));
        FIX(72, lanes_add(lanes_mul(K(3.3306690738754696e-16), p_board_distance), lanes_mul(K(2.220446049250313e-16), p_board_thickness)));
        FIX(73, lanes_add(lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_bottom)), lanes_mul(K(2.220446049250313e-16), lanes_abs(p_board_top))));
        FIX(74, lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s137, _s137)));
        FIX(75, lanes_mul(K(6.667843360785852e-15), _s137));
        FIX(76, lanes_mul(K(12.01171875), _s137));
        FIX(77, lanes_mul(K(2.667137344314341e-15), _s137));
        FIX(78, lanes_mul(K(6.005859375), _s137));
    }
}

LANES_APART void LOOP(fix_rows_7)(LOOP(worklist) *worklist, size_t i)
#else
LANES_APART void LOOP(fix_rows_6)(LOOP(worklist) *worklist, size_t i)
#endif
{
    EACH(PARAMETER, , p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width)
    EACH(PARAMETER, , p_gravity, p_ring_radius, p_wire_radius)
    {
        const V _s39 = lanes_mul(K(0.5), p_ring_radius);
        const V _s40 = lanes_mul(K(0.5), p_board_distance);
        const V _s121 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s178 = lanes_mul(K(0.5), p_bridge_depth);
        FIX(4, lanes_neg(lanes_add(_s39, _s40))); FIX(7, p_ring_radius); FIX(8, p_wire_radius);
        FIX(9, p_board_distance); FIX(13, p_bridge_half_width);
        FIX(16, lanes_sub(p_wire_radius, p_bridge_depth)); FIX(20, lanes_div(K(1.0), p_gravity));
        FIX(21, p_gravity); FIX(34, lanes_mul(K(0.5), p_gravity)); FIX(56, _s121);
        FIX(80, lanes_abs(K(0.0))); FIX(81, lanes_mul(K(0.0625), p_gravity));
        FIX(82, lanes_mul(K(1.0000000009313226), _s121));
        FIX(83, lanes_mul(K(1.0000000009313226), lanes_sub(_s40, _s39)));
        FIX(84, lanes_mul(K(1.0000000009313226), p_bridge_half_width));
        FIX(85, lanes_sub(p_wire_radius, _s178)); FIX(86, lanes_mul(K(1.0000000009313226), _s178));
    }
}

#if BOUNDED
LANES_APART void LOOP(fix_reachable_rows_4)(LOOP(worklist) *worklist, size_t i)
#else
LANES_APART void LOOP(fix_reachable_rows_3)(LOOP(worklist) *worklist, size_t i)
#endif
{
    EACH(PARAMETER, reachable_, p_ball_radius, p_board_distance, p_bridge_depth)
    EACH(PARAMETER, reachable_, p_bridge_half_width, p_gravity, p_ring_radius, p_wire_radius)
    {
        const V _s39 = lanes_mul(K(0.5), p_ring_radius);
        const V _s40 = lanes_mul(K(0.5), p_board_distance);
        const V _s43 = lanes_add(p_ball_radius, _s40);
        const V _s44 = lanes_sub(_s43, _s39);
        const V _s65 = lanes_abs(lanes_neg(p_gravity));
        const V _s121 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s178 = lanes_mul(K(0.5), p_bridge_depth);
        const V _s181 = lanes_add(p_ball_radius, _s178);
        const V _s182 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s183 = lanes_min(_s182, _s44);
        const V _s184 = lanes_min(_s181, _s183);
        const V _s185 = lanes_mul(K(6.103515625e-05), _s184);
        const V _s191 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), _s184));
        const V _s195 = lanes_max(_s44, _s182);
        FIX(7, p_ring_radius); FIX(8, p_wire_radius); FIX(9, p_board_distance);
        FIX(13, p_bridge_half_width); FIX(16, lanes_sub(p_wire_radius, p_bridge_depth));
        FIX(20, lanes_div(K(1.0), p_gravity)); FIX(21, p_gravity);
        FIX(22, lanes_mul(K(2.0), p_gravity)); FIX(27, lanes_mul(K(0.5), _s65));
        FIX(34, lanes_mul(K(0.5), p_gravity)); FIX(45, lanes_sqrt(K(2.0))); FIX(56, _s121);
        FIX(68, lanes_mul(K(5.55653613398821e-16), _s121)); FIX(79, _s65); FIX(87, _s178);
        FIX(88, _s184); FIX(89, lanes_sub(lanes_add(_s43, _s185), _s39));
        FIX(90, lanes_add(_s39, _s40)); FIX(91, lanes_add(_s182, _s185));
        FIX(92, lanes_add(_s181, _s185)); FIX(93, lanes_mul(lanes_mul(K(1.25), _s65), _s191));
        FIX(94, lanes_abs(lanes_sub(_s178, p_wire_radius))); FIX(95, lanes_max(_s195, _s181));
        FIX(96, lanes_mul(K(1.52587890625e-05), _s184)); FIX(97, _s191);
        FIX(98, lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        FIX(99, lanes_mul(K(2.001953125), _s191));
        FIX(100, lanes_add(lanes_mul(K(1.1102230246251565e-16), p_ring_radius), lanes_mul(K(1.1102230246251565e-16), p_board_distance)));
        FIX(101, lanes_add(lanes_mul(K(5.551115123125783e-16), p_wire_radius), lanes_mul(K(2.220446049250313e-16), p_bridge_depth)));
        FIX(102, lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s191, _s191)));
        FIX(103, lanes_mul(K(6.667843360785852e-15), _s191));
        FIX(104, lanes_mul(K(12.01171875), _s191));
        FIX(105, lanes_mul(K(2.667137344314341e-15), _s191));
        FIX(106, lanes_mul(K(6.005859375), _s191));
    }
}

LANES_APART void LOOP(fix_reachable_searching_rows_2)(LOOP(worklist) *worklist, size_t taken, M idle)
{
    EACH(PARAMETER_TAKEN, reachable_searching_, p_ball_radius, p_board_distance, p_bridge_depth)
    EACH(PARAMETER_TAKEN, reachable_searching_, p_bridge_half_width, p_gravity, p_ring_radius)
    EACH(PARAMETER_TAKEN, reachable_searching_, p_wire_radius)
    EACH(TURNING, turning_, p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width)
    EACH(TURNING, turning_, p_gravity, p_ring_radius, p_wire_radius)
    {
        const V _s44 = lanes_sub(lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_distance)), lanes_mul(K(0.5), p_ring_radius));
        const V _s65 = lanes_abs(lanes_neg(p_gravity));
        const V _s121 = lanes_mul(p_ball_radius, p_ball_radius);
        const V _s181 = lanes_add(p_ball_radius, lanes_mul(K(0.5), p_bridge_depth));
        const V _s182 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s183 = lanes_min(_s182, _s44);
        const V _s191 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), lanes_min(_s181, _s183)));
        FIX(7, p_ring_radius); FIX(8, p_wire_radius); FIX(9, p_board_distance);
        FIX(13, p_bridge_half_width); FIX(16, lanes_sub(p_wire_radius, p_bridge_depth));
        FIX(21, p_gravity); FIX(27, lanes_mul(K(0.5), _s65)); FIX(34, lanes_mul(K(0.5), p_gravity));
        FIX(56, _s121); FIX(68, lanes_mul(K(5.55653613398821e-16), _s121)); FIX(79, _s65);
        FIX(97, _s191); FIX(98, lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        FIX(99, lanes_mul(K(2.001953125), _s191));
        FIX(100, lanes_add(lanes_mul(K(1.1102230246251565e-16), p_ring_radius), lanes_mul(K(1.1102230246251565e-16), p_board_distance)));
        FIX(101, lanes_add(lanes_mul(K(5.551115123125783e-16), p_wire_radius), lanes_mul(K(2.220446049250313e-16), p_bridge_depth)));
        FIX(102, lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s191, _s191)));
        FIX(103, lanes_mul(K(6.667843360785852e-15), _s191));
        FIX(104, lanes_mul(K(12.01171875), _s191));
        FIX(105, lanes_mul(K(2.667137344314341e-15), _s191));
        FIX(106, lanes_mul(K(6.005859375), _s191));
    }
}

#if BOUNDED
LANES_APART void LOOP(fix_reachable_rows_5)(LOOP(worklist) *worklist, size_t i)
#else
LANES_APART void LOOP(fix_reachable_rows_4)(LOOP(worklist) *worklist, size_t i)
#endif
{
    EACH(PARAMETER, reachable_, p_ball_radius, p_board_distance, p_bridge_depth)
    EACH(PARAMETER, reachable_, p_bridge_half_width, p_gravity, p_ring_radius, p_wire_radius)
    {
        FIX(7, p_ring_radius); FIX(8, p_wire_radius); FIX(9, p_board_distance);
        FIX(13, p_bridge_half_width); FIX(16, lanes_sub(p_wire_radius, p_bridge_depth));
        FIX(21, p_gravity); FIX(34, lanes_mul(K(0.5), p_gravity));
        FIX(56, lanes_mul(p_ball_radius, p_ball_radius));
    }
}

LANES_APART void LOOP(fix_reachable_refining_rows_2)(LOOP(worklist) *worklist, size_t taken, M idle)
{
    EACH(PARAMETER_TAKEN, reachable_refining_, p_ball_radius, p_board_distance, p_bridge_depth)
    EACH(PARAMETER_TAKEN, reachable_refining_, p_bridge_half_width, p_gravity, p_ring_radius)
    EACH(PARAMETER_TAKEN, reachable_refining_, p_wire_radius)
    EACH(TURNING, turning_, p_ball_radius, p_board_distance, p_bridge_depth, p_bridge_half_width)
    EACH(TURNING, turning_, p_gravity, p_ring_radius, p_wire_radius)
    {
        FIX(7, p_ring_radius); FIX(8, p_wire_radius); FIX(9, p_board_distance);
        FIX(13, p_bridge_half_width); FIX(16, lanes_sub(p_wire_radius, p_bridge_depth));
        FIX(21, p_gravity); FIX(34, lanes_mul(K(0.5), p_gravity));
        FIX(56, lanes_mul(p_ball_radius, p_ball_radius));
    }
}

#if BOUNDED
LANES_APART void LOOP(fix_reachable_rows_6)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, reachable_, p_ball_radius, p_board_distance, p_bridge_depth)
    EACH(PARAMETER, reachable_, p_bridge_half_width, p_gravity, p_ring_radius, p_wire_radius)
    {
        const V _s44 = lanes_sub(lanes_add(p_ball_radius, lanes_mul(K(0.5), p_board_distance)), lanes_mul(K(0.5), p_ring_radius));
        const V _s181 = lanes_add(p_ball_radius, lanes_mul(K(0.5), p_bridge_depth));
        const V _s182 = lanes_add(p_ball_radius, p_bridge_half_width);
        const V _s183 = lanes_min(_s182, _s44);
        const V _s191 = lanes_add(p_ball_radius, lanes_mul(K(0.0001220703125), lanes_min(_s181, _s183)));
        FIX(21, p_gravity);
        FIX(68, lanes_mul(K(5.55653613398821e-16), lanes_mul(p_ball_radius, p_ball_radius)));
        FIX(97, _s191); FIX(98, lanes_mul(K(3.3306690738754696e-16), p_bridge_half_width));
        FIX(99, lanes_mul(K(2.001953125), _s191));
        FIX(100, lanes_add(lanes_mul(K(1.1102230246251565e-16), p_ring_radius), lanes_mul(K(1.1102230246251565e-16), p_board_distance)));
        FIX(101, lanes_add(lanes_mul(K(5.551115123125783e-16), p_wire_radius), lanes_mul(K(2.220446049250313e-16), p_bridge_depth)));
        FIX(102, lanes_mul(K(1.3335686721571705e-15), lanes_mul(_s191, _s191)));
        FIX(103, lanes_mul(K(6.667843360785852e-15), _s191));
        FIX(104, lanes_mul(K(12.01171875), _s191));
        FIX(105, lanes_mul(K(2.667137344314341e-15), _s191));
        FIX(106, lanes_mul(K(6.005859375), _s191));
    }
}

#endif
LANES_APART void LOOP(fix_in_contact_rows_1)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, in_contact_, p_ball_radius, p_board_bottom, p_board_distance)
    EACH(PARAMETER, in_contact_, p_board_half_width, p_board_thickness, p_board_top, p_bridge_depth)
    EACH(PARAMETER, in_contact_, p_bridge_half_width, p_inertia, p_ring_radius, p_wire_radius)
    {
#if BOUNDED
        const V _s222 = lanes_mul(K(3.637978807091713e-12), p_ball_radius);
#endif
        FIX(6, p_ball_radius); FIX(7, p_ring_radius); FIX(8, p_wire_radius);
        FIX(9, p_board_distance); FIX(10, p_board_half_width); FIX(11, p_board_bottom);
        FIX(12, p_board_top); FIX(13, p_bridge_half_width);
        FIX(15, lanes_add(p_board_distance, p_board_thickness));
        FIX(16, lanes_sub(p_wire_radius, p_bridge_depth));
        FIX(107, lanes_div(K(1.0), lanes_add(p_ball_radius, p_wire_radius)));
        FIX(108, lanes_mul(K(0.5), p_ball_radius));
        FIX(109, lanes_mul(p_inertia, lanes_div(K(1.0), lanes_add(K(1.0), p_inertia))));
        FIX(110, lanes_div(K(1.0), p_ball_radius));
#if BOUNDED
        FIX(111, _s222); FIX(112, lanes_neg(_s222));
        FIX(113, lanes_mul(K(1.4551915228366852e-11), p_ball_radius));
#endif
    }
}

LANES_APART void LOOP(fix_in_contact_rolling_rows_1)(LOOP(worklist) *worklist, size_t taken, M idle)
{
    EACH(PARAMETER_TAKEN, in_contact_rolling_, p_ball_radius, p_board_bottom, p_board_distance)
    EACH(PARAMETER_TAKEN, in_contact_rolling_, p_board_half_width, p_board_thickness, p_board_top)
    EACH(PARAMETER_TAKEN, in_contact_rolling_, p_bridge_depth, p_bridge_half_width, p_end_depth)
    EACH(PARAMETER_TAKEN, in_contact_rolling_, p_gravity, p_inertia, p_ring_radius, p_wire_radius)
    EACH(TURNING, turning_, p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width)
    EACH(TURNING, turning_, p_board_thickness, p_board_top, p_bridge_depth, p_bridge_half_width)
    EACH(TURNING, turning_, p_end_depth, p_gravity, p_inertia, p_ring_radius, p_wire_radius)
    {
        const V _s218 = lanes_div(K(1.0), lanes_add(K(1.0), p_inertia));
        const V _s227 = lanes_mul(K(1.4210854715202004e-14), p_ball_radius);
        const V _s232 = lanes_add(lanes_add(_s227, lanes_mul(K(2.842170943040401e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_board_thickness));
        const V _s235 = lanes_add(_s227, lanes_mul(K(2.842170943040401e-14), p_board_half_width));
        const V _s240 = lanes_add(lanes_add(_s227, lanes_mul(K(1.4210854715202004e-14), lanes_abs(p_board_bottom))), lanes_mul(K(1.4210854715202004e-14), lanes_abs(p_board_top)));
        const V _s245 = lanes_add(lanes_add(_s227, lanes_mul(K(1.4210854715202004e-14), p_ring_radius)), lanes_mul(K(1.4210854715202004e-14), p_board_distance));
        const V _s248 = lanes_add(_s227, lanes_mul(K(2.842170943040401e-14), p_bridge_half_width));
        const V _s255 = lanes_add(lanes_add(_s227, lanes_mul(K(1.4210854715202004e-14), p_wire_radius)), lanes_mul(K(1.4210854715202004e-14), lanes_abs(lanes_sub(p_bridge_depth, p_wire_radius))));
        FIX(6, p_ball_radius); FIX(7, p_ring_radius); FIX(8, p_wire_radius);
        FIX(9, p_board_distance); FIX(10, p_board_half_width); FIX(11, p_board_bottom);
        FIX(12, p_board_top); FIX(13, p_bridge_half_width);
        FIX(15, lanes_add(p_board_distance, p_board_thickness));
        FIX(16, lanes_sub(p_wire_radius, p_bridge_depth)); FIX(18, lanes_neg(p_end_depth));
        FIX(19, lanes_mul(p_ring_radius, p_ring_radius)); FIX(21, p_gravity);
        FIX(41, lanes_mul(K(2.0), p_ring_radius)); FIX(108, lanes_mul(K(0.5), p_ball_radius));
        FIX(109, lanes_mul(p_inertia, _s218)); FIX(110, lanes_div(K(1.0), p_ball_radius));
        FIX(111, lanes_mul(K(3.637978807091713e-12), p_ball_radius)); FIX(114, _s232);
        FIX(115, lanes_neg(_s232)); FIX(116, _s235); FIX(117, lanes_neg(_s235)); FIX(118, _s240);
        FIX(119, lanes_neg(_s240)); FIX(120, _s245); FIX(121, lanes_neg(_s245)); FIX(122, _s248);
        FIX(123, lanes_neg(_s248)); FIX(124, _s255); FIX(125, lanes_neg(_s255)); FIX(126, _s218);
        FIX(127, lanes_mul(p_gravity, _s218)); FIX(128, lanes_mul(K(0.015625), p_gravity));
        FIX(129, lanes_mul(K(5.684341886080802e-14), lanes_sqrt(lanes_mul(p_ball_radius, p_gravity))));
        FIX(130, lanes_mul(K(5.684341886080802e-14), p_gravity));
        FIX(131, lanes_add(p_ball_radius, p_wire_radius)); FIX(132, p_bridge_depth);
#if BOUNDED
        FIX(133, lanes_mul(K(1.1102230246251565e-16), p_ball_radius));
        FIX(134, lanes_mul(K(2.384185791015625e-07), p_ball_radius));
#endif
    }
}

LANES_APART void LOOP(fix_in_contact_circling_rows_1)(LOOP(worklist) *worklist, size_t taken, M idle)
{
    EACH(PARAMETER_TAKEN, in_contact_circling_, p_ball_radius, p_board_bottom, p_board_distance)
    EACH(PARAMETER_TAKEN, in_contact_circling_, p_board_half_width, p_board_thickness, p_board_top)
    EACH(PARAMETER_TAKEN, in_contact_circling_, p_bridge_depth, p_bridge_half_width, p_end_depth)
    EACH(PARAMETER_TAKEN, in_contact_circling_, p_gravity, p_inertia, p_ring_radius, p_wire_radius)
    EACH(TURNING, turning_, p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width)
    EACH(TURNING, turning_, p_board_thickness, p_board_top, p_bridge_depth, p_bridge_half_width)
    EACH(TURNING, turning_, p_end_depth, p_gravity, p_inertia, p_ring_radius, p_wire_radius)
    {
        const V _s45 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s47 = lanes_add(p_board_distance, p_board_thickness);
        const V _s218 = lanes_div(K(1.0), lanes_add(K(1.0), p_inertia));
        const V _s219 = lanes_mul(p_inertia, _s218);
        const V _s296 = lanes_neg(p_board_half_width);
        const V _s297 = lanes_max(K(0.0), _s296);
        const V _s298 = lanes_max(_s297, _s296);
        const V _s300 = lanes_neg(_s47);
        const V _s301 = lanes_max(K(0.0), _s300);
        const V _s302 = lanes_max(_s301, p_board_distance);
        const V _s306 = lanes_neg(p_board_distance);
        const V _s307 = lanes_max(K(0.0), _s306);
        const V _s308 = lanes_max(_s307, p_ring_radius);
        const V _s310 = lanes_neg(p_bridge_half_width);
        const V _s311 = lanes_max(K(0.0), _s310);
        const V _s312 = lanes_max(_s311, _s310);
        FIX(6, p_ball_radius); FIX(7, p_ring_radius); FIX(8, p_wire_radius);
        FIX(9, p_board_distance); FIX(10, p_board_half_width); FIX(11, p_board_bottom);
        FIX(12, p_board_top); FIX(13, p_bridge_half_width); FIX(15, _s47);
        FIX(16, lanes_sub(p_wire_radius, p_bridge_depth)); FIX(18, lanes_neg(p_end_depth));
        FIX(19, lanes_mul(p_ring_radius, p_ring_radius)); FIX(21, p_gravity);
        FIX(107, lanes_div(K(1.0), _s45)); FIX(109, _s219);
        FIX(110, lanes_div(K(1.0), p_ball_radius));
        FIX(111, lanes_mul(K(3.637978807091713e-12), p_ball_radius)); FIX(126, _s218);
        FIX(128, lanes_mul(K(0.015625), p_gravity));
        FIX(129, lanes_mul(K(5.684341886080802e-14), lanes_sqrt(lanes_mul(p_ball_radius, p_gravity))));
        FIX(130, lanes_mul(K(5.684341886080802e-14), p_gravity)); FIX(131, _s45);
#if BOUNDED
        FIX(133, lanes_mul(K(1.1102230246251565e-16), p_ball_radius));
        FIX(134, lanes_mul(K(2.384185791015625e-07), p_ball_radius));
#endif
        FIX(135, lanes_mul(p_ring_radius, _s218)); FIX(136, lanes_mul(K(0.5), p_ring_radius));
        FIX(137, lanes_mul(K(0.3333333333333333), p_ring_radius));
        FIX(138, lanes_mul(K(0.25), p_ring_radius)); FIX(139, lanes_mul(K(0.2), p_ring_radius));
        FIX(140, lanes_mul(K(0.16666666666666666), p_ring_radius));
        FIX(141, lanes_mul(K(0.14285714285714285), p_ring_radius));
        FIX(142, lanes_mul(K(0.125), p_ring_radius));
        FIX(143, lanes_mul(K(0.1111111111111111), p_ring_radius));
        FIX(144, lanes_mul(K(0.1), p_ring_radius));
        FIX(145, lanes_mul(K(0.09090909090909091), p_ring_radius));
        FIX(146, lanes_mul(K(0.08333333333333333), p_ring_radius));
        FIX(147, lanes_mul(p_gravity, lanes_sub(K(3.0), lanes_mul(K(2.0), _s219))));
        FIX(148, lanes_mul(K(3.0), p_ring_radius)); FIX(149, lanes_mul(K(6.0), p_ring_radius));
        FIX(150, lanes_mul(lanes_mul(K(2.0), p_gravity), _s219));
        FIX(151, lanes_sqrt(lanes_add(lanes_mul(_s298, _s298), lanes_mul(_s302, _s302))));
        FIX(152, lanes_sqrt(lanes_add(lanes_mul(_s308, _s308), lanes_mul(_s312, _s312))));
        FIX(153, lanes_mul(K(0.000244140625), _s45)); FIX(154, lanes_mul(K(0.00390625), p_gravity));
        FIX(155, lanes_mul(lanes_mul(K(0.000244140625), lanes_mul(p_gravity, p_gravity)), _s45));
    }
}

LANES_APART void LOOP(fix_in_contact_leaves_rows_1)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, in_contact_leaves_, p_ball_radius, p_board_bottom, p_board_distance)
    EACH(PARAMETER, in_contact_leaves_, p_board_half_width, p_board_thickness, p_board_top)
    EACH(PARAMETER, in_contact_leaves_, p_bridge_depth, p_bridge_half_width, p_end_depth, p_gravity)
    EACH(PARAMETER, in_contact_leaves_, p_ring_radius, p_wire_radius)
    {
        const V _s45 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s227 = lanes_mul(K(1.4210854715202004e-14), p_ball_radius);
        const V _s232 = lanes_add(lanes_add(_s227, lanes_mul(K(2.842170943040401e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_board_thickness));
        const V _s235 = lanes_add(_s227, lanes_mul(K(2.842170943040401e-14), p_board_half_width));
        const V _s240 = lanes_add(lanes_add(_s227, lanes_mul(K(1.4210854715202004e-14), lanes_abs(p_board_bottom))), lanes_mul(K(1.4210854715202004e-14), lanes_abs(p_board_top)));
        const V _s245 = lanes_add(lanes_add(_s227, lanes_mul(K(1.4210854715202004e-14), p_ring_radius)), lanes_mul(K(1.4210854715202004e-14), p_board_distance));
        const V _s248 = lanes_add(_s227, lanes_mul(K(2.842170943040401e-14), p_bridge_half_width));
        const V _s255 = lanes_add(lanes_add(_s227, lanes_mul(K(1.4210854715202004e-14), p_wire_radius)), lanes_mul(K(1.4210854715202004e-14), lanes_abs(lanes_sub(p_bridge_depth, p_wire_radius))));
        FIX(6, p_ball_radius); FIX(7, p_ring_radius); FIX(8, p_wire_radius);
        FIX(9, p_board_distance); FIX(10, p_board_half_width); FIX(11, p_board_bottom);
        FIX(12, p_board_top); FIX(13, p_bridge_half_width);
        FIX(15, lanes_add(p_board_distance, p_board_thickness));
        FIX(16, lanes_sub(p_wire_radius, p_bridge_depth)); FIX(18, lanes_neg(p_end_depth));
        FIX(21, p_gravity); FIX(22, lanes_mul(K(2.0), p_gravity)); FIX(23, lanes_neg(p_gravity));
        FIX(41, lanes_mul(K(2.0), p_ring_radius)); FIX(107, lanes_div(K(1.0), _s45));
        FIX(110, lanes_div(K(1.0), p_ball_radius)); FIX(114, _s232); FIX(115, lanes_neg(_s232));
        FIX(116, _s235); FIX(117, lanes_neg(_s235)); FIX(118, _s240); FIX(119, lanes_neg(_s240));
        FIX(120, _s245); FIX(121, lanes_neg(_s245)); FIX(122, _s248); FIX(123, lanes_neg(_s248));
        FIX(124, _s255); FIX(125, lanes_neg(_s255));
        FIX(130, lanes_mul(K(5.684341886080802e-14), p_gravity)); FIX(131, _s45);
        FIX(132, p_bridge_depth); FIX(156, lanes_mul(K(3.0), p_gravity));
        FIX(157, lanes_mul(K(2.0), lanes_mul(K(3.0), lanes_mul(p_gravity, p_gravity))));
        FIX(158, lanes_mul(K(0.0078125), p_gravity)); FIX(159, lanes_max(K(0.0), p_gravity));
    }
}

LANES_APART void LOOP(leaves)(LOOP(worklist) *worklist, size_t in_contact_leaves_shots, size_t varying, V time_limit)
{
    for (size_t i = 0; i < in_contact_leaves_shots; i += LANES_WIDTH) {
        const M rows = mask_first_n(in_contact_leaves_shots - i);
        if (LANES_SELDOM(varying))
            LOOP(fix_in_contact_leaves_rows_1)(worklist, i);
        EACH(LOAD, in_contact_leaves_, clock, gap_jerk, gap_snap, held, lift, per_reach, vx, vy, vz)
        EACH(LOAD, in_contact_leaves_, x, y, z)
#if BOUNDED
        EACH(LOAD, in_contact_leaves_, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz)
        EACH(LOAD, in_contact_leaves_, estimated, undecided_time)
        EACH(LOAD_SINGLE, in_contact_leaves_, clock_bound, position_bound, spin_bound)
        EACH(LOAD_SINGLE, in_contact_leaves_, velocity_bound)
        CALL(court_error_bounds, _error_bounds_1)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, lanes_wide(position_bound), lanes_wide(velocity_bound), lanes_wide(spin_bound), estimated, lanes_wide(clock_bound));
        EACH(GET, _error_bounds_1, position_error, velocity_error)
#endif
        CALL(court_holding, _holding_1)(K(0.0), held);
        EACH(GET_MASK, _holding_1, here)
        const M _if_here_1 = lanes_both(rows, here);
        if (lanes_any(_if_here_1)) {
            CALL(court_ring_rolling_surface, _ring_rolling_surface_1)(FIXED(107));
            EACH(SELECT, (_if_here_1, _ring_rolling_surface_1), per_reach)
            CALL(court_ring_separation, _ring_separation_1)(x, y, z, vx, vy, vz, FIXED(21), FIXED(7), FIXED(156), FIXED(157));
            EACH(SELECT, (_if_here_1, _ring_separation_1), lift, gap_jerk, gap_snap)
        }
        CALL(court_holding, _holding_2)(K(1.0), held);
        EACH(SET, _holding_2, here)
        const M _if_here_2 = lanes_both(rows, here);
        if (lanes_any(_if_here_2)) {
            CALL(court_backboard_rolling_surface, _backboard_rolling_surface_1)(x, y, z, vx, vy, vz, FIXED(11), FIXED(9), FIXED(10), FIXED(12), FIXED(114), FIXED(115), FIXED(15), FIXED(116), FIXED(117), FIXED(118), FIXED(119), FIXED(110));
            EACH(SELECT, (_if_here_2, _backboard_rolling_surface_1), per_reach)
            CALL(court_backboard_separation, _backboard_separation_1)(x, y, z, vx, vy, vz, FIXED(11), FIXED(9), FIXED(10), FIXED(12), FIXED(21), FIXED(15), FIXED(23));
            EACH(SELECT, (_if_here_2, _backboard_separation_1), lift, gap_jerk, gap_snap)
        }
        CALL(court_holding, _holding_3)(K(2.0), held);
        EACH(SET, _holding_3, here)
        const M _if_here_3 = lanes_both(rows, here);
        if (lanes_any(_if_here_3)) {
            CALL(court_bridge_rolling_surface, _bridge_rolling_surface_1)(x, y, z, vx, vy, vz, FIXED(9), FIXED(13), FIXED(7), FIXED(8), FIXED(120), FIXED(121), FIXED(122), FIXED(123), FIXED(124), FIXED(125), FIXED(16), FIXED(110));
            EACH(SELECT, (_if_here_3, _bridge_rolling_surface_1), per_reach)
            CALL(court_bridge_separation, _bridge_separation_1)(x, y, z, vx, vy, vz, FIXED(9), FIXED(13), FIXED(21), FIXED(7), FIXED(8), FIXED(16), FIXED(23));
            EACH(SELECT, (_if_here_3, _bridge_separation_1), lift, gap_jerk, gap_snap)
        }
        CALL(court_no_contact, _no_contact_1)();
        EACH(GET, _no_contact_1, free_time)
        CALL(court_beside, _beside_1)(K(0.0), held);
        EACH(GET_MASK, _beside_1, beside)
        const M _if_beside_1 = lanes_both(rows, beside);
        if (lanes_any(_if_beside_1)) {
            CALL(court_ring_beside, _ring_beside_1)(x, y, z, vx, vy, vz, FIXED(6), FIXED(7), FIXED(8), FIXED(41), FIXED(131));
            EACH(GET, _ring_beside_1, gap, nearing, gap_curvature)
            CALL(court_neighbour_free_time, _neighbour_free_time_1)(vx, vy, vz, gap, free_time, nearing, gap_curvature, FIXED(21), FIXED(158));
            EACH(SELECT, (_if_beside_1, _neighbour_free_time_1), free_time)
        }
        CALL(court_beside, _beside_2)(K(1.0), held);
        EACH(SET, _beside_2, beside)
        const M _if_beside_2 = lanes_both(rows, beside);
        if (lanes_any(_if_beside_2)) {
            CALL(court_backboard_beside, _backboard_beside_1)(x, y, z, vx, vy, vz, FIXED(6), FIXED(11), FIXED(9), FIXED(10), FIXED(12), FIXED(15));
            EACH(GET, _backboard_beside_1, gap, nearing, gap_curvature)
            CALL(court_neighbour_free_time, _neighbour_free_time_2)(vx, vy, vz, gap, free_time, nearing, gap_curvature, FIXED(21), FIXED(158));
            EACH(SELECT, (_if_beside_2, _neighbour_free_time_2), free_time)
        }
        CALL(court_beside, _beside_3)(K(2.0), held);
        EACH(SET, _beside_3, beside)
        const M _if_beside_3 = lanes_both(rows, beside);
        if (lanes_any(_if_beside_3)) {
            CALL(court_bridge_beside, _bridge_beside_1)(x, y, z, vx, vy, vz, FIXED(6), FIXED(9), FIXED(13), FIXED(7), FIXED(8), FIXED(16));
            EACH(GET, _bridge_beside_1, gap, nearing, gap_curvature)
            CALL(court_neighbour_free_time, _neighbour_free_time_3)(vx, vy, vz, gap, free_time, nearing, gap_curvature, FIXED(21), FIXED(158));
            EACH(SELECT, (_if_beside_3, _neighbour_free_time_3), free_time)
        }
        CALL(court_end_beside, _end_beside_1)(z, vz, FIXED(18));
        EACH(GET, _end_beside_1, gap, nearing, gap_curvature)
        CALL(court_end_plane_free_time, _end_plane_free_time_1)(vx, vy, vz, gap, OR_INFINITE(undecided_time), free_time, nearing, gap_curvature, FIXED(21), FIXED(158));
        EACH(SET, _end_plane_free_time_1, free_time)
        BOUNDS(EACH(SET, _end_plane_free_time_1, undecided_time))
        CALL(court_holding, _holding_4)(K(1.0), held);
        EACH(SET, _holding_4, here)
        const M _if_here_4 = lanes_both(rows, here);
        if (lanes_any(_if_here_4)) {
            CALL(court_backboard_seam0, _backboard_seam0_1)(x, vx, FIXED(15), FIXED(114));
            EACH(GET, _backboard_seam0_1, gap, nearing, near)
            CALL(court_seam_free_time, _seam_free_time_1)(gap, free_time, near, nearing, FIXED(22), FIXED(159));
            EACH(SELECT, (_if_here_4, _seam_free_time_1), free_time)
            CALL(court_backboard_seam1, _backboard_seam1_1)(x, vx, FIXED(9), FIXED(114));
            EACH(SET, _backboard_seam1_1, gap, nearing, near)
            CALL(court_seam_free_time, _seam_free_time_2)(gap, free_time, near, nearing, FIXED(22), FIXED(159));
            EACH(SELECT, (_if_here_4, _seam_free_time_2), free_time)
            CALL(court_backboard_seam2, _backboard_seam2_1)(y, vy, FIXED(10), FIXED(116));
            EACH(SET, _backboard_seam2_1, gap, nearing, near)
            CALL(court_seam_free_time, _seam_free_time_3)(gap, free_time, near, nearing, FIXED(22), FIXED(159));
            EACH(SELECT, (_if_here_4, _seam_free_time_3), free_time)
            CALL(court_backboard_seam3, _backboard_seam3_1)(y, vy, FIXED(10), FIXED(116));
            EACH(SET, _backboard_seam3_1, gap, nearing, near)
            CALL(court_seam_free_time, _seam_free_time_4)(gap, free_time, near, nearing, FIXED(22), FIXED(159));
            EACH(SELECT, (_if_here_4, _seam_free_time_4), free_time)
            CALL(court_backboard_seam4, _backboard_seam4_1)(z, vz, FIXED(11), FIXED(118));
            EACH(SET, _backboard_seam4_1, gap, nearing, near)
            CALL(court_seam_free_time, _seam_free_time_5)(gap, free_time, near, nearing, FIXED(22), FIXED(159));
            EACH(SELECT, (_if_here_4, _seam_free_time_5), free_time)
            CALL(court_backboard_seam5, _backboard_seam5_1)(z, vz, FIXED(12), FIXED(118));
            EACH(SET, _backboard_seam5_1, gap, nearing, near)
            CALL(court_seam_free_time, _seam_free_time_6)(gap, free_time, near, nearing, FIXED(22), FIXED(159));
            EACH(SELECT, (_if_here_4, _seam_free_time_6), free_time)
        }
        CALL(court_holding, _holding_5)(K(2.0), held);
        EACH(SET, _holding_5, here)
        const M _if_here_5 = lanes_both(rows, here);
        if (lanes_any(_if_here_5)) {
            CALL(court_bridge_seam0, _bridge_seam0_1)(x, vx, FIXED(9), FIXED(120));
            EACH(GET, _bridge_seam0_1, gap, nearing, near)
            CALL(court_seam_free_time, _seam_free_time_7)(gap, free_time, near, nearing, FIXED(22), FIXED(159));
            EACH(SELECT, (_if_here_5, _seam_free_time_7), free_time)
            CALL(court_bridge_seam1, _bridge_seam1_1)(x, vx, FIXED(7), FIXED(120));
            EACH(SET, _bridge_seam1_1, gap, nearing, near)
            CALL(court_seam_free_time, _seam_free_time_8)(gap, free_time, near, nearing, FIXED(22), FIXED(159));
            EACH(SELECT, (_if_here_5, _seam_free_time_8), free_time)
            CALL(court_bridge_seam2, _bridge_seam2_1)(y, vy, FIXED(13), FIXED(122));
            EACH(SET, _bridge_seam2_1, gap, nearing, near)
            CALL(court_seam_free_time, _seam_free_time_9)(gap, free_time, near, nearing, FIXED(22), FIXED(159));
            EACH(SELECT, (_if_here_5, _seam_free_time_9), free_time)
            CALL(court_bridge_seam3, _bridge_seam3_1)(y, vy, FIXED(13), FIXED(122));
            EACH(SET, _bridge_seam3_1, gap, nearing, near)
            CALL(court_seam_free_time, _seam_free_time_10)(gap, free_time, near, nearing, FIXED(22), FIXED(159));
            EACH(SELECT, (_if_here_5, _seam_free_time_10), free_time)
            CALL(court_bridge_seam4, _bridge_seam4_1)(z, vz, FIXED(132), FIXED(8), FIXED(124));
            EACH(SET, _bridge_seam4_1, gap, nearing, near)
            CALL(court_seam_free_time, _seam_free_time_11)(gap, free_time, near, nearing, FIXED(22), FIXED(159));
            EACH(SELECT, (_if_here_5, _seam_free_time_11), free_time)
            CALL(court_bridge_seam5, _bridge_seam5_1)(z, vz, FIXED(8), FIXED(124));
            EACH(SET, _bridge_seam5_1, gap, nearing, near)
            CALL(court_seam_free_time, _seam_free_time_12)(gap, free_time, near, nearing, FIXED(22), FIXED(159));
            EACH(SELECT, (_if_here_5, _seam_free_time_12), free_time)
        }
        CALL(court_separated, _separated_1)(vx, vy, vz, OR_INFINITE(undecided_time), OR_ZERO(position_error), OR_ZERO(velocity_error), clock, time_limit, per_reach, free_time, lift, gap_jerk, gap_snap, FIXED(21), FIXED(158), FIXED(130));
        EACH(GET, _separated_1, when)
        BOUNDS(EACH(SET, _separated_1, undecided_time))
        CALL(court_detachment, _detachment_1)();
        EACH(GET, _detachment_1, which)
        EACH(STORE, in_contact_leaves_, when, which)
        BOUNDS(EACH(STORE, in_contact_leaves_, position_error, undecided_time, velocity_error))
    }
}

LANES_APART void LOOP(in_contact)(LOOP(worklist) *worklist, size_t in_contact_shots, size_t varying, V time_limit)
{
    {
    size_t in_contact_rolling_shots = 0;
#if BOUNDED
    static const int in_contact_rolling_taken[] = {16, 0, 5, 3, 4, 7, 6, 9, 17, 8, 11, 10, 18, 1, 2};
#else
    static const int in_contact_rolling_taken[] = {0, 5, 3, 4, 7, 6, 9, 8, 11, 10, 18, 1, 2};
#endif
    for (size_t i = 0; i < in_contact_shots; i += LANES_WIDTH) {
        const M rows = mask_first_n(in_contact_shots - i);
        if (LANES_SELDOM(varying))
            LOOP(fix_in_contact_rows_1)(worklist, i);
        EACH(LOAD, in_contact_, clock, held, last, mode)
        BOUNDS(EACH(LOAD, in_contact_, position_error, velocity_error))
        CALL(court_resumed, _resumed_1)(last, OR_ZERO(position_error), OR_ZERO(velocity_error), clock, mode);
        EACH(GET, _resumed_1, which, began, nx, ny, nz, gap, bent_x, bent_y, bent_z, lift, gap_jerk)
        EACH(GET, _resumed_1, gap_snap, per_reach)
        EACH(GET_MASK, _resumed_1, begins, rolling, leaves)
        BOUNDS(EACH(GET, _resumed_1, earliest_delay, undecided_time))
        const M _if_begins_1 = lanes_both(rows, begins);
        if (lanes_any(_if_begins_1)) {
            EACH(LOAD, in_contact_, circled, vx, vy, vz, wx, wy, wz, x, y, z)
            BOUNDS(EACH(LOAD, in_contact_, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, last_grip_deficit))
            CALL(court_holding, _holding_1)(K(0.0), held);
            EACH(GET_MASK, _holding_1, here)
            const M _if_here_1 = lanes_both(_if_begins_1, here);
            {
                CALL(court_ring_normal, _ring_normal_1)(x, y, z, FIXED(7), FIXED(107));
                EACH(SELECT, (_if_here_1, _ring_normal_1), nx, ny, nz)
            }
            CALL(court_holding, _holding_2)(K(1.0), held);
            EACH(SET, _holding_2, here)
            const M _if_here_2 = lanes_both(_if_begins_1, here);
            if (lanes_any(_if_here_2)) {
                CALL(court_backboard_normal, _backboard_normal_1)(x, y, z, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(15), FIXED(108));
                EACH(SELECT, (_if_here_2, _backboard_normal_1), nx, ny, nz)
            }
            CALL(court_holding, _holding_3)(K(2.0), held);
            EACH(SET, _holding_3, here)
            const M _if_here_3 = lanes_both(_if_begins_1, here);
            if (lanes_any(_if_here_3)) {
                CALL(court_bridge_normal, _bridge_normal_1)(x, y, z, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(16), FIXED(108));
                EACH(SELECT, (_if_here_3, _bridge_normal_1), nx, ny, nz)
            }
            CALL(court_roll_turn_rate, _roll_turn_rate_1)(nx, ny, nz, wx, wy, wz, FIXED(6));
            EACH(GET, _roll_turn_rate_1, turn_rate)
            CALL(court_gripped, _gripped_1)(nx, ny, nz, vx, vy, vz, wx, wy, wz, FIXED(6), FIXED(109));
            EACH(GET, _gripped_1, rolled_x, rolled_y, rolled_z)
            CALL(court_holding, _holding_4)(K(0.0), held);
            EACH(SET, _holding_4, here)
            const M _if_here_4 = lanes_both(_if_begins_1, here);
            {
                CALL(court_ring_distance, _ring_distance_1)(x, y, z, FIXED(6), FIXED(7), FIXED(8));
                EACH(SELECT, (_if_here_4, _ring_distance_1), gap)
            }
            CALL(court_holding, _holding_5)(K(1.0), held);
            EACH(SET, _holding_5, here)
            const M _if_here_5 = lanes_both(_if_begins_1, here);
            {
                CALL(court_backboard_distance, _backboard_distance_1)(x, y, z, FIXED(6), FIXED(11), FIXED(9), FIXED(10), FIXED(12), FIXED(15));
                EACH(SELECT, (_if_here_5, _backboard_distance_1), gap)
            }
            CALL(court_holding, _holding_6)(K(2.0), held);
            EACH(SET, _holding_6, here)
            const M _if_here_6 = lanes_both(_if_begins_1, here);
            {
                CALL(court_bridge_distance, _bridge_distance_1)(x, y, z, FIXED(6), FIXED(9), FIXED(13), FIXED(7), FIXED(8), FIXED(16));
                EACH(SELECT, (_if_here_6, _bridge_distance_1), gap)
            }
            CALL(court_roll_placed, _roll_placed_1)(x, y, z, nx, ny, nz, rolled_x, rolled_y, rolled_z, gap, turn_rate, FIXED(110));
            EACH(SELECT, (_if_begins_1, _roll_placed_1), x, y, z, vx, vy, vz, wx, wy, wz)
#if BOUNDED
            CALL(court_jump_errors, _jump_errors_1)(vx, vy, vz, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, FIXED(6), FIXED(111), FIXED(112), FIXED(113));
            EACH(SELECT, (_if_begins_1, _jump_errors_1), dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz)
            CALL(court_forget_grip_deficit, _forget_grip_deficit_1)();
            EACH(SELECT, (_if_begins_1, _forget_grip_deficit_1), last_grip_deficit)
#endif
            CALL(court_beginning_contact, _beginning_contact_1)();
            EACH(SELECT, (_if_begins_1, _beginning_contact_1), which, circled)
            EACH(STORE, in_contact_, circled, vx, vy, vz, wx, wy, wz, x, y, z)
            BOUNDS(EACH(STORE, in_contact_, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, last_grip_deficit))
        }
        CALL(court_circles, _circles_1)(K(0.0), held, rolling);
        EACH(GET_MASK, _circles_1, circling)
        EACH(SET, _circles_1, rolling)
        EACH(STORE, in_contact_, began, gap_jerk, gap_snap, lift, per_reach, which)
        EACH(STORE_MASK, in_contact_, circling, leaves, rolling)
        BOUNDS(EACH(STORE, in_contact_, earliest_delay, undecided_time))
        const M packed = lanes_both(rows, rolling);
        if (lanes_any(packed)) {
            EACH(LOAD, in_contact_, through, vx, vy, vz, wx, wy, wz, x, y, z)
            BOUNDS(EACH(LOAD_SINGLE, in_contact_, clock_bound, position_bound, spin_bound, velocity_bound))
            BOUNDS(EACH(LOAD, in_contact_, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz))
            BOUNDS(EACH(LOAD, in_contact_, estimated, grip_lost, last_grip_clock, last_grip_deficit))
            BOUNDS(EACH(LOAD, in_contact_, last_grip_deficit_rate))
            lanes_pack(worklist->in_contact_rolling_row + in_contact_rolling_shots, packed, lanes_add(iota(), K((double)i)));
            EACH(PACK, in_contact_rolling_, bent_x, bent_y, bent_z, clock, held, nx, ny, nz)
            EACH(PACK, in_contact_rolling_, per_reach, through, vx, vy, vz, which, wx, wy, wz, x, y)
            EACH(PACK, in_contact_rolling_, z)
            BOUNDS(EACH(PACK, in_contact_rolling_, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz))
            BOUNDS(EACH(PACK, in_contact_rolling_, earliest_delay, estimated, grip_lost, last_grip_clock))
            BOUNDS(EACH(PACK, in_contact_rolling_, last_grip_deficit, last_grip_deficit_rate))
            BOUNDS(EACH(PACK, in_contact_rolling_, undecided_time))
            BOUNDS(EACH(PACK_SINGLE, in_contact_rolling_, clock_bound, position_bound, spin_bound))
            BOUNDS(EACH(PACK_SINGLE, in_contact_rolling_, velocity_bound))
            if (LANES_SELDOM(varying)) {
#if BOUNDED
                for (size_t _p = 0; _p < 15; _p++) {
#else
                for (size_t _p = 0; _p < 13; _p++) {
#endif
                    lanes_pack(worklist->in_contact_rolling_parameters.columns[in_contact_rolling_taken[_p]] + in_contact_rolling_shots, packed, lanes_load(worklist->in_contact_parameters.columns[in_contact_rolling_taken[_p]] + i));
                }
            }
            in_contact_rolling_shots += popcount(packed);
        }
    }
    if (in_contact_rolling_shots) {
        EACH(CLEAR, in_contact_rolling_, row, bent_x, bent_y, bent_z, clock, held, nx, ny, nz)
        EACH(CLEAR, in_contact_rolling_, per_reach, through, vx, vy, vz, which, wx, wy, wz, x, y, z)
        BOUNDS(EACH(CLEAR, in_contact_rolling_, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz))
        BOUNDS(EACH(CLEAR, in_contact_rolling_, earliest_delay, estimated, grip_lost, last_grip_clock))
        BOUNDS(EACH(CLEAR, in_contact_rolling_, last_grip_deficit, last_grip_deficit_rate, undecided_time))
        BOUNDS(EACH(CLEAR_SINGLE, in_contact_rolling_, clock_bound, position_bound, spin_bound))
        BOUNDS(EACH(CLEAR_SINGLE, in_contact_rolling_, velocity_bound))
        if (LANES_SELDOM(varying)) {
#if BOUNDED
            for (size_t _p = 0; _p < 15; _p++) {
#else
            for (size_t _p = 0; _p < 13; _p++) {
#endif
                lanes_store(worklist->in_contact_rolling_parameters.columns[in_contact_rolling_taken[_p]] + in_contact_rolling_shots, K(0.0));
            }
        }
    }
    {
        size_t taken = 0;
        size_t done = 0;
        size_t busy = 0;
        EACH(START_MASK, , active)
        EACH(START, , row, turns, bent_x, bent_y, bent_z, clock, held, nx, ny, nz, per_reach)
        EACH(START, , through, vx, vy, vz, which, wx, wy, wz, x, y, z)
        BOUNDS(EACH(START, , clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, earliest_delay))
        BOUNDS(EACH(START, , estimated, grip_lost, last_grip_clock, last_grip_deficit))
        BOUNDS(EACH(START, , last_grip_deficit_rate, undecided_time))
        BOUNDS(EACH(START_SINGLE, , clock_bound, position_bound, spin_bound, velocity_bound))
        for (;;) {
            if ((taken < in_contact_rolling_shots) && ((busy + LANES_SPARE) <= LANES_WIDTH)) {
                const M idle = lanes_not(active);
                turns = lanes_select(idle, K(0.0), turns);
                EACH(EXPAND, in_contact_rolling_, row, bent_x, bent_y, bent_z, clock, held, nx, ny)
                EACH(EXPAND, in_contact_rolling_, nz, per_reach, through, vx, vy, vz, which, wx, wy)
                EACH(EXPAND, in_contact_rolling_, wz, x, y, z)
#if BOUNDED
                EACH(EXPAND, in_contact_rolling_, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy)
                EACH(EXPAND, in_contact_rolling_, dz, earliest_delay, estimated, grip_lost)
                EACH(EXPAND, in_contact_rolling_, last_grip_clock, last_grip_deficit)
                EACH(EXPAND, in_contact_rolling_, last_grip_deficit_rate, undecided_time)
                EACH(EXPAND_SINGLE, in_contact_rolling_, clock_bound, position_bound, spin_bound)
                EACH(EXPAND_SINGLE, in_contact_rolling_, velocity_bound)
                if (varying) {
                    for (size_t _p = 0; _p < 15; _p++) {
                        lanes_store(worklist->turning_parameters.columns[in_contact_rolling_taken[_p]], lanes_expand(worklist->in_contact_rolling_parameters.columns[in_contact_rolling_taken[_p]] + taken, idle, lanes_load(worklist->turning_parameters.columns[in_contact_rolling_taken[_p]])));
                    }
                }
#endif
                if (LANES_SELDOM(varying))
                    LOOP(fix_in_contact_rolling_rows_1)(worklist, taken, idle);
                const size_t room = LANES_WIDTH - busy;
                const size_t _left = in_contact_rolling_shots - taken;
                active = lanes_leading(idle, _left, active);
                taken += _left < room ? _left : room;
                busy += _left < room ? _left : room;
            }
            if (busy == 0)
                break;
            M rolling = active;
#if BOUNDED
            CALL(court_error_bounds, _error_bounds_1)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, lanes_wide(position_bound), lanes_wide(velocity_bound), lanes_wide(spin_bound), estimated, lanes_wide(clock_bound));
            EACH(GET, _error_bounds_1, position_error, velocity_error)
#endif
            CALL(court_holding, _holding_1)(K(1.0), held);
            EACH(GET_MASK, _holding_1, here)
            const M _if_here_1 = lanes_both(active, here);
            if (lanes_any(_if_here_1)) {
                CALL(court_backboard_normal, _backboard_normal_1)(x, y, z, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(15), FIXED(108));
                EACH(SELECT, (_if_here_1, _backboard_normal_1), nx, ny, nz)
                CALL(court_backboard_rolling_surface, _backboard_rolling_surface_1)(x, y, z, vx, vy, vz, FIXED(11), FIXED(9), FIXED(10), FIXED(12), FIXED(114), FIXED(115), FIXED(15), FIXED(116), FIXED(117), FIXED(118), FIXED(119), FIXED(110));
                EACH(SELECT, (_if_here_1, _backboard_rolling_surface_1), bent_x, bent_y, bent_z)
                EACH(SELECT, (_if_here_1, _backboard_rolling_surface_1), per_reach)
            }
            CALL(court_holding, _holding_2)(K(2.0), held);
            EACH(SET, _holding_2, here)
            const M _if_here_2 = lanes_both(active, here);
            if (lanes_any(_if_here_2)) {
                CALL(court_bridge_normal, _bridge_normal_1)(x, y, z, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(16), FIXED(108));
                EACH(SELECT, (_if_here_2, _bridge_normal_1), nx, ny, nz)
                CALL(court_bridge_rolling_surface, _bridge_rolling_surface_1)(x, y, z, vx, vy, vz, FIXED(9), FIXED(13), FIXED(7), FIXED(8), FIXED(120), FIXED(121), FIXED(122), FIXED(123), FIXED(124), FIXED(125), FIXED(16), FIXED(110));
                EACH(SELECT, (_if_here_2, _bridge_rolling_surface_1), bent_x, bent_y, bent_z)
                EACH(SELECT, (_if_here_2, _bridge_rolling_surface_1), per_reach)
            }
            CALL(court_roll_start, _roll_start_1)(nx, ny, nz, vx, vy, vz, wx, wy, wz, FIXED(6));
            EACH(GET, _roll_start_1, vx_0, vy_0, vz_0, nx_0, ny_0, nz_0, turn_rate_0)
            CALL(court_roll_0, _roll_0_1)(nx_0, ny_0, nz_0, vx_0, vy_0, vz_0, bent_x, bent_y, bent_z, per_reach, turn_rate_0, FIXED(21), FIXED(126), FIXED(109), FIXED(127));
            EACH(GET, _roll_0_1, lift_0, tx_0, ty_0, tz_0, vx_1, vy_1, vz_1, nx_1, ny_1, nz_1)
            EACH(GET, _roll_0_1, turn_rate_1)
            CALL(court_roll_1, _roll_1_1)(nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, lift_0, tx_0, ty_0, tz_0, FIXED(21), FIXED(126), FIXED(109));
            EACH(GET, _roll_1_1, lift_1, tx_1, ty_1, tz_1, vx_2, vy_2, vz_2, nx_2, ny_2, nz_2)
            EACH(GET, _roll_1_1, turn_rate_2)
            CALL(court_roll_2, _roll_2_1)(nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, lift_0, lift_1, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, FIXED(21), FIXED(126), FIXED(109));
            EACH(GET, _roll_2_1, lift_2, tx_2, ty_2, tz_2, vx_3, vy_3, vz_3, nx_3, ny_3, nz_3)
            EACH(GET, _roll_2_1, turn_rate_3)
            CALL(court_roll_3, _roll_3_1)(nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, lift_0, lift_1, lift_2, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, FIXED(21), FIXED(126), FIXED(109));
            EACH(GET, _roll_3_1, lift_3, tx_3, ty_3, tz_3, vx_4, vy_4, vz_4, nx_4, ny_4, nz_4)
            EACH(GET, _roll_3_1, turn_rate_4)
            CALL(court_roll_4, _roll_4_1)(nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, lift_0, lift_1, lift_2, lift_3, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, FIXED(21), FIXED(126), FIXED(109));
            EACH(GET, _roll_4_1, lift_4, tx_4, ty_4, tz_4, vx_5, vy_5, vz_5, nx_5, ny_5, nz_5)
            EACH(GET, _roll_4_1, turn_rate_5)
            CALL(court_roll_5, _roll_5_1)(nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, lift_0, lift_1, lift_2, lift_3, lift_4, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, FIXED(21), FIXED(126), FIXED(109));
            EACH(GET, _roll_5_1, lift_5, tx_5, ty_5, tz_5, vx_6, vy_6, vz_6, nx_6, ny_6, nz_6)
            EACH(GET, _roll_5_1, turn_rate_6)
            CALL(court_roll_6, _roll_6_1)(nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, FIXED(21), FIXED(126), FIXED(109));
            EACH(GET, _roll_6_1, lift_6, tx_6, ty_6, tz_6, vx_7, vy_7, vz_7, nx_7, ny_7, nz_7)
            EACH(GET, _roll_6_1, turn_rate_7)
            CALL(court_roll_7, _roll_7_1)(nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, FIXED(21), FIXED(126), FIXED(109));
            EACH(GET, _roll_7_1, lift_7, vx_8, vy_8, vz_8, nx_8, ny_8, nz_8, turn_rate_8)
            CALL(court_roll_step, _roll_step_1)(nx_8, ny_8, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, nz_8, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, lift_7, FIXED(21), FIXED(128), FIXED(109));
            EACH(GET, _roll_step_1, stride, strongest, fastest, force, force_rate, force_bend)
            EACH(GET, _roll_step_1, friction_force_rate)
#if BOUNDED
            EACH(GET, _roll_step_1, missed)
            CALL(court_ring_friction, _ring_friction_1)(nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, turn_rate_0, turn_rate_1, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, FIXED(21), FIXED(109));
            EACH(GET, _ring_friction_1, rolling_friction, rolling_friction_rate, grip_deficit)
            EACH(GET, _ring_friction_1, grip_deficit_rate)
            {
                static const int _t1[][1] = {
                    {16},
                    {17},
                };
                static const double _t2[][1] = {
                    {1.0},
                    {2.0},
                };
                for (size_t _k1 = 0; _k1 < 2; _k1++) {
                    const V own_1 = lanes_load(varying ? worklist->turning_parameters.columns[_t1[_k1][0]] : worklist->parameters.columns[_t1[_k1][0]]);
                    const V own_index = K(_t2[_k1][0]);
                    CALL(court_holding, _holding_3)(own_index, held);
                    EACH(GET_MASK, _holding_3, here)
                    const M _if_here_3 = lanes_both(active, here);
                    {
                        CALL(court_ring_impact_grip_deficit, _ring_impact_grip_deficit_1)(own_1, rolling_friction, rolling_friction_rate, force, force_rate);
                        EACH(SELECT, (_if_here_3, _ring_impact_grip_deficit_1), grip_deficit)
                        EACH(SELECT, (_if_here_3, _ring_impact_grip_deficit_1), grip_deficit_rate)
                    }
                }
            }
            CALL(court_exceeds_grip, _exceeds_grip_1)(grip_deficit, grip_lost);
            EACH(GET_MASK, _exceeds_grip_1, loses)
            const M _if_loses_1 = lanes_both(active, loses);
            if (lanes_any(_if_loses_1)) {
                CALL(court_grip_lost_time, _grip_lost_time_1)(clock, grip_deficit, grip_deficit_rate, last_grip_deficit, last_grip_deficit_rate, last_grip_clock);
                EACH(SELECT, (_if_loses_1, _grip_lost_time_1), grip_lost)
            }
            CALL(court_remember_grip_deficit, _remember_grip_deficit_1)(clock, grip_deficit, grip_deficit_rate);
            EACH(SET, _remember_grip_deficit_1, last_grip_deficit, last_grip_deficit_rate)
            EACH(SET, _remember_grip_deficit_1, last_grip_clock)
#endif
            CALL(court_leaving_force, _leaving_force_1)(vx, vx_1, vy, vy_1, vz, vz_1, which, OR_INFINITE(undecided_time), OR_ZERO(position_error), OR_ZERO(velocity_error), per_reach, force, force_rate, force_bend, friction_force_rate, stride, fastest, FIXED(21), FIXED(129), FIXED(130));
            EACH(SET, _leaving_force_1, stride, which)
            EACH(GET_MASK, _leaving_force_1, rests)
            BOUNDS(EACH(SET, _leaving_force_1, undecided_time))
            CALL(court_beside, _beside_1)(K(0.0), held);
            EACH(GET_MASK, _beside_1, beside)
            const M _if_beside_1 = lanes_both(active, beside);
            if (lanes_any(_if_beside_1)) {
                CALL(court_ring_beside, _ring_beside_1)(x, y, z, vx, vy, vz, FIXED(6), FIXED(7), FIXED(8), FIXED(41), FIXED(131));
                EACH(GET, _ring_beside_1, gap, nearing, gap_curvature)
                CALL(court_beside_body, _beside_body_1)(x, y, z, gap, K(0.0), which, OR_ZERO(earliest_delay), OR_INFINITE(undecided_time), OR_ZERO(position_error), nearing, gap_curvature, stride, strongest, fastest, FIXED(6), FIXED(111));
                EACH(SELECT, (_if_beside_1, _beside_body_1), stride, which)
                BOUNDS(EACH(SELECT, (_if_beside_1, _beside_body_1), undecided_time, earliest_delay))
            }
            CALL(court_beside, _beside_2)(K(1.0), held);
            EACH(SET, _beside_2, beside)
            const M _if_beside_2 = lanes_both(active, beside);
            if (lanes_any(_if_beside_2)) {
                CALL(court_backboard_beside, _backboard_beside_1)(x, y, z, vx, vy, vz, FIXED(6), FIXED(11), FIXED(9), FIXED(10), FIXED(12), FIXED(15));
                EACH(GET, _backboard_beside_1, gap, nearing, gap_curvature)
                CALL(court_beside_body, _beside_body_2)(x, y, z, gap, K(1.0), which, OR_ZERO(earliest_delay), OR_INFINITE(undecided_time), OR_ZERO(position_error), nearing, gap_curvature, stride, strongest, fastest, FIXED(6), FIXED(111));
                EACH(SELECT, (_if_beside_2, _beside_body_2), stride, which)
                BOUNDS(EACH(SELECT, (_if_beside_2, _beside_body_2), undecided_time, earliest_delay))
            }
            CALL(court_beside, _beside_3)(K(2.0), held);
            EACH(SET, _beside_3, beside)
            const M _if_beside_3 = lanes_both(active, beside);
            if (lanes_any(_if_beside_3)) {
                CALL(court_bridge_beside, _bridge_beside_1)(x, y, z, vx, vy, vz, FIXED(6), FIXED(9), FIXED(13), FIXED(7), FIXED(8), FIXED(16));
                EACH(GET, _bridge_beside_1, gap, nearing, gap_curvature)
                CALL(court_beside_body, _beside_body_3)(x, y, z, gap, K(2.0), which, OR_ZERO(earliest_delay), OR_INFINITE(undecided_time), OR_ZERO(position_error), nearing, gap_curvature, stride, strongest, fastest, FIXED(6), FIXED(111));
                EACH(SELECT, (_if_beside_3, _beside_body_3), stride, which)
                BOUNDS(EACH(SELECT, (_if_beside_3, _beside_body_3), undecided_time, earliest_delay))
            }
            CALL(court_end_beside, _end_beside_1)(z, vz, FIXED(18));
            EACH(GET, _end_beside_1, gap, nearing, gap_curvature)
            CALL(court_beside_end_plane, _beside_end_plane_1)(x, y, z, gap, K(3.0), which, OR_ZERO(earliest_delay), OR_INFINITE(undecided_time), OR_ZERO(position_error), nearing, gap_curvature, stride, strongest, fastest, FIXED(6));
            EACH(SET, _beside_end_plane_1, stride, which)
#if BOUNDED
            EACH(SET, _beside_end_plane_1, undecided_time, earliest_delay)
#else
            CALL(court_holding, _holding_3)(K(1.0), held);
            EACH(SET, _holding_3, here)
            const M _if_here_3 = lanes_both(active, here);
            if (lanes_any(_if_here_3)) {
                CALL(court_backboard_seam0, _backboard_seam0_1)(x, vx, FIXED(15), FIXED(114));
                EACH(SELECT, (_if_here_3, _backboard_seam0_1), gap)
                EACH(GET, _backboard_seam0_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_1)(gap, near, nearing, stride, strongest, fastest);
                EACH(SELECT, (_if_here_3, _beside_seam_1), stride)
                CALL(court_backboard_seam1, _backboard_seam1_1)(x, vx, FIXED(9), FIXED(114));
                EACH(SELECT, (_if_here_3, _backboard_seam1_1), gap)
                EACH(SET, _backboard_seam1_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_2)(gap, near, nearing, stride, strongest, fastest);
                EACH(SELECT, (_if_here_3, _beside_seam_2), stride)
                CALL(court_backboard_seam2, _backboard_seam2_1)(y, vy, FIXED(10), FIXED(116));
                EACH(SELECT, (_if_here_3, _backboard_seam2_1), gap)
                EACH(SET, _backboard_seam2_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_3)(gap, near, nearing, stride, strongest, fastest);
                EACH(SELECT, (_if_here_3, _beside_seam_3), stride)
                CALL(court_backboard_seam3, _backboard_seam3_1)(y, vy, FIXED(10), FIXED(116));
                EACH(SELECT, (_if_here_3, _backboard_seam3_1), gap)
                EACH(SET, _backboard_seam3_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_4)(gap, near, nearing, stride, strongest, fastest);
                EACH(SELECT, (_if_here_3, _beside_seam_4), stride)
                CALL(court_backboard_seam4, _backboard_seam4_1)(z, vz, FIXED(11), FIXED(118));
                EACH(SELECT, (_if_here_3, _backboard_seam4_1), gap)
                EACH(SET, _backboard_seam4_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_5)(gap, near, nearing, stride, strongest, fastest);
                EACH(SELECT, (_if_here_3, _beside_seam_5), stride)
                CALL(court_backboard_seam5, _backboard_seam5_1)(z, vz, FIXED(12), FIXED(118));
                EACH(SELECT, (_if_here_3, _backboard_seam5_1), gap)
                EACH(SET, _backboard_seam5_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_6)(gap, near, nearing, stride, strongest, fastest);
                EACH(SELECT, (_if_here_3, _beside_seam_6), stride)
            }
#endif
#if BOUNDED
            CALL(court_holding, _holding_4)(K(1.0), held);
#else
            CALL(court_holding, _holding_4)(K(2.0), held);
#endif
            EACH(SET, _holding_4, here)
            const M _if_here_4 = lanes_both(active, here);
            if (lanes_any(_if_here_4)) {
#if BOUNDED
                CALL(court_backboard_seam0, _backboard_seam0_1)(x, vx, FIXED(15), FIXED(114));
                EACH(SELECT, (_if_here_4, _backboard_seam0_1), gap)
                EACH(GET, _backboard_seam0_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_1)(gap, near, nearing, stride, strongest, fastest);
                EACH(SELECT, (_if_here_4, _beside_seam_1), stride)
                CALL(court_backboard_seam1, _backboard_seam1_1)(x, vx, FIXED(9), FIXED(114));
                EACH(SELECT, (_if_here_4, _backboard_seam1_1), gap)
                EACH(SET, _backboard_seam1_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_2)(gap, near, nearing, stride, strongest, fastest);
                EACH(SELECT, (_if_here_4, _beside_seam_2), stride)
                CALL(court_backboard_seam2, _backboard_seam2_1)(y, vy, FIXED(10), FIXED(116));
                EACH(SELECT, (_if_here_4, _backboard_seam2_1), gap)
                EACH(SET, _backboard_seam2_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_3)(gap, near, nearing, stride, strongest, fastest);
                EACH(SELECT, (_if_here_4, _beside_seam_3), stride)
                CALL(court_backboard_seam3, _backboard_seam3_1)(y, vy, FIXED(10), FIXED(116));
                EACH(SELECT, (_if_here_4, _backboard_seam3_1), gap)
                EACH(SET, _backboard_seam3_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_4)(gap, near, nearing, stride, strongest, fastest);
                EACH(SELECT, (_if_here_4, _beside_seam_4), stride)
                CALL(court_backboard_seam4, _backboard_seam4_1)(z, vz, FIXED(11), FIXED(118));
                EACH(SELECT, (_if_here_4, _backboard_seam4_1), gap)
                EACH(SET, _backboard_seam4_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_5)(gap, near, nearing, stride, strongest, fastest);
                EACH(SELECT, (_if_here_4, _beside_seam_5), stride)
                CALL(court_backboard_seam5, _backboard_seam5_1)(z, vz, FIXED(12), FIXED(118));
                EACH(SELECT, (_if_here_4, _backboard_seam5_1), gap)
                EACH(SET, _backboard_seam5_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_6)(gap, near, nearing, stride, strongest, fastest);
                EACH(SELECT, (_if_here_4, _beside_seam_6), stride)
            }
            CALL(court_holding, _holding_5)(K(2.0), held);
            EACH(SET, _holding_5, here)
            const M _if_here_5 = lanes_both(active, here);
            if (lanes_any(_if_here_5)) {
#endif
                CALL(court_bridge_seam0, _bridge_seam0_1)(x, vx, FIXED(9), FIXED(120));
#if BOUNDED
                EACH(SELECT, (_if_here_5, _bridge_seam0_1), gap)
#else
                EACH(SELECT, (_if_here_4, _bridge_seam0_1), gap)
#endif
                EACH(GET, _bridge_seam0_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_7)(gap, near, nearing, stride, strongest, fastest);
#if BOUNDED
                EACH(SELECT, (_if_here_5, _beside_seam_7), stride)
#else
                EACH(SELECT, (_if_here_4, _beside_seam_7), stride)
#endif
                CALL(court_bridge_seam1, _bridge_seam1_1)(x, vx, FIXED(7), FIXED(120));
#if BOUNDED
                EACH(SELECT, (_if_here_5, _bridge_seam1_1), gap)
#else
                EACH(SELECT, (_if_here_4, _bridge_seam1_1), gap)
#endif
                EACH(SET, _bridge_seam1_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_8)(gap, near, nearing, stride, strongest, fastest);
#if BOUNDED
                EACH(SELECT, (_if_here_5, _beside_seam_8), stride)
#else
                EACH(SELECT, (_if_here_4, _beside_seam_8), stride)
#endif
                CALL(court_bridge_seam2, _bridge_seam2_1)(y, vy, FIXED(13), FIXED(122));
#if BOUNDED
                EACH(SELECT, (_if_here_5, _bridge_seam2_1), gap)
#else
                EACH(SELECT, (_if_here_4, _bridge_seam2_1), gap)
#endif
                EACH(SET, _bridge_seam2_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_9)(gap, near, nearing, stride, strongest, fastest);
#if BOUNDED
                EACH(SELECT, (_if_here_5, _beside_seam_9), stride)
#else
                EACH(SELECT, (_if_here_4, _beside_seam_9), stride)
#endif
                CALL(court_bridge_seam3, _bridge_seam3_1)(y, vy, FIXED(13), FIXED(122));
#if BOUNDED
                EACH(SELECT, (_if_here_5, _bridge_seam3_1), gap)
#else
                EACH(SELECT, (_if_here_4, _bridge_seam3_1), gap)
#endif
                EACH(SET, _bridge_seam3_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_10)(gap, near, nearing, stride, strongest, fastest);
#if BOUNDED
                EACH(SELECT, (_if_here_5, _beside_seam_10), stride)
#else
                EACH(SELECT, (_if_here_4, _beside_seam_10), stride)
#endif
                CALL(court_bridge_seam4, _bridge_seam4_1)(z, vz, FIXED(132), FIXED(8), FIXED(124));
#if BOUNDED
                EACH(SELECT, (_if_here_5, _bridge_seam4_1), gap)
#else
                EACH(SELECT, (_if_here_4, _bridge_seam4_1), gap)
#endif
                EACH(SET, _bridge_seam4_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_11)(gap, near, nearing, stride, strongest, fastest);
#if BOUNDED
                EACH(SELECT, (_if_here_5, _beside_seam_11), stride)
#else
                EACH(SELECT, (_if_here_4, _beside_seam_11), stride)
#endif
                CALL(court_bridge_seam5, _bridge_seam5_1)(z, vz, FIXED(8), FIXED(124));
#if BOUNDED
                EACH(SELECT, (_if_here_5, _bridge_seam5_1), gap)
#else
                EACH(SELECT, (_if_here_4, _bridge_seam5_1), gap)
#endif
                EACH(SET, _bridge_seam5_1, nearing, near)
                CALL(court_beside_seam, _beside_seam_12)(gap, near, nearing, stride, strongest, fastest);
#if BOUNDED
                EACH(SELECT, (_if_here_5, _beside_seam_12), stride)
#else
                EACH(SELECT, (_if_here_4, _beside_seam_12), stride)
#endif
            }
            CALL(court_beside_time, _beside_time_1)(which, clock, time_limit, stride);
            EACH(SET, _beside_time_1, stride, which)
#if BOUNDED
            CALL(court_neighbour_scale, _neighbour_scale_1)(dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, FIXED(6), FIXED(133), FIXED(134));
            EACH(GET, _neighbour_scale_1, neighbour_scale)
            CALL(court_neighbour, _neighbour_1)(x, y, z, vx, vy, vz, wx, wy, wz, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, neighbour_scale);
            EACH(GET, _neighbour_1, far_x, far_y, far_z, far_vx, far_vy, far_vz, far_wx, far_wy)
            EACH(GET, _neighbour_1, far_wz, far_nx, far_ny, far_nz, far_gap)
#endif
            CALL(court_passing_from, _passing_from_1)(z);
            EACH(GET_MASK, _passing_from_1, over)
            CALL(court_roll_moved, _roll_moved_1)(x, y, z, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8);
            EACH(SET, _roll_moved_1, x, vx, y, vy, z, vz)
            EACH(GET, _roll_moved_1, turn_rate)
#if !BOUNDED
            CALL(court_holding, _holding_5)(K(1.0), held);
            EACH(SET, _holding_5, here)
            const M _if_here_5 = lanes_both(active, here);
            if (lanes_any(_if_here_5)) {
                CALL(court_backboard_normal, _backboard_normal_2)(x, y, z, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(15), FIXED(108));
                EACH(SELECT, (_if_here_5, _backboard_normal_2), nx, ny, nz)
                CALL(court_backboard_distance, _backboard_distance_1)(x, y, z, FIXED(6), FIXED(11), FIXED(9), FIXED(10), FIXED(12), FIXED(15));
                EACH(SELECT, (_if_here_5, _backboard_distance_1), gap)
            }
#endif
#if BOUNDED
            CALL(court_holding, _holding_6)(K(1.0), held);
#else
            CALL(court_holding, _holding_6)(K(2.0), held);
#endif
            EACH(SET, _holding_6, here)
            const M _if_here_6 = lanes_both(active, here);
            if (lanes_any(_if_here_6)) {
#if BOUNDED
                CALL(court_backboard_normal, _backboard_normal_2)(x, y, z, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(15), FIXED(108));
                EACH(SELECT, (_if_here_6, _backboard_normal_2), nx, ny, nz)
                CALL(court_backboard_distance, _backboard_distance_1)(x, y, z, FIXED(6), FIXED(11), FIXED(9), FIXED(10), FIXED(12), FIXED(15));
                EACH(SELECT, (_if_here_6, _backboard_distance_1), gap)
            }
            CALL(court_holding, _holding_7)(K(2.0), held);
            EACH(SET, _holding_7, here)
            const M _if_here_7 = lanes_both(active, here);
            if (lanes_any(_if_here_7)) {
#endif
                CALL(court_bridge_normal, _bridge_normal_2)(x, y, z, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(16), FIXED(108));
#if BOUNDED
                EACH(SELECT, (_if_here_7, _bridge_normal_2), nx, ny, nz)
#else
                EACH(SELECT, (_if_here_6, _bridge_normal_2), nx, ny, nz)
#endif
                CALL(court_bridge_distance, _bridge_distance_1)(x, y, z, FIXED(6), FIXED(9), FIXED(13), FIXED(7), FIXED(8), FIXED(16));
#if BOUNDED
                EACH(SELECT, (_if_here_7, _bridge_distance_1), gap)
#else
                EACH(SELECT, (_if_here_6, _bridge_distance_1), gap)
#endif
            }
            CALL(court_roll_placed, _roll_placed_1)(x, y, z, nx, ny, nz, vx, vy, vz, gap, turn_rate, FIXED(110));
            EACH(SET, _roll_placed_1, x, y, z, vx, vy, vz, wx, wy, wz)
            CALL(court_passing_in_contact, _passing_in_contact_1)(x, y, z, through, over, FIXED(19));
            EACH(SET, _passing_in_contact_1, through)
#if BOUNDED
            CALL(court_holding, _holding_8)(K(1.0), held);
            EACH(SET, _holding_8, here)
            const M _if_here_8 = lanes_both(active, here);
            if (lanes_any(_if_here_8)) {
                CALL(court_backboard_normal, _backboard_normal_3)(far_x, far_y, far_z, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(15), FIXED(108));
                far_nx = lanes_select(_if_here_8, _backboard_normal_3.nx, far_nx);
                far_ny = lanes_select(_if_here_8, _backboard_normal_3.ny, far_ny);
                far_nz = lanes_select(_if_here_8, _backboard_normal_3.nz, far_nz);
            }
            CALL(court_holding, _holding_9)(K(2.0), held);
            EACH(SET, _holding_9, here)
            const M _if_here_9 = lanes_both(active, here);
            if (lanes_any(_if_here_9)) {
                CALL(court_bridge_normal, _bridge_normal_3)(far_x, far_y, far_z, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(16), FIXED(108));
                far_nx = lanes_select(_if_here_9, _bridge_normal_3.nx, far_nx);
                far_ny = lanes_select(_if_here_9, _bridge_normal_3.ny, far_ny);
                far_nz = lanes_select(_if_here_9, _bridge_normal_3.nz, far_nz);
            }
            CALL(court_roll_turn_rate, _roll_turn_rate_1)(far_nx, far_ny, far_nz, far_wx, far_wy, far_wz, FIXED(6));
            EACH(SET, _roll_turn_rate_1, turn_rate)
            CALL(court_holding, _holding_10)(K(1.0), held);
            EACH(SET, _holding_10, here)
            const M _if_here_10 = lanes_both(active, here);
            if (lanes_any(_if_here_10)) {
                CALL(court_backboard_normal, _backboard_normal_4)(far_x, far_y, far_z, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(15), FIXED(108));
                far_nx = lanes_select(_if_here_10, _backboard_normal_4.nx, far_nx);
                far_ny = lanes_select(_if_here_10, _backboard_normal_4.ny, far_ny);
                far_nz = lanes_select(_if_here_10, _backboard_normal_4.nz, far_nz);
                CALL(court_backboard_distance, _backboard_distance_2)(far_x, far_y, far_z, FIXED(6), FIXED(11), FIXED(9), FIXED(10), FIXED(12), FIXED(15));
                far_gap = lanes_select(_if_here_10, _backboard_distance_2.gap, far_gap);
            }
            CALL(court_holding, _holding_11)(K(2.0), held);
            EACH(SET, _holding_11, here)
            const M _if_here_11 = lanes_both(active, here);
            if (lanes_any(_if_here_11)) {
                CALL(court_bridge_normal, _bridge_normal_4)(far_x, far_y, far_z, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(16), FIXED(108));
                far_nx = lanes_select(_if_here_11, _bridge_normal_4.nx, far_nx);
                far_ny = lanes_select(_if_here_11, _bridge_normal_4.ny, far_ny);
                far_nz = lanes_select(_if_here_11, _bridge_normal_4.nz, far_nz);
                CALL(court_bridge_distance, _bridge_distance_2)(far_x, far_y, far_z, FIXED(6), FIXED(9), FIXED(13), FIXED(7), FIXED(8), FIXED(16));
                far_gap = lanes_select(_if_here_11, _bridge_distance_2.gap, far_gap);
            }
            CALL(court_roll_placed, _roll_placed_2)(far_x, far_y, far_z, far_nx, far_ny, far_nz, far_vx, far_vy, far_vz, far_gap, turn_rate, FIXED(110));
            far_x = _roll_placed_2.x;
            far_y = _roll_placed_2.y;
            far_z = _roll_placed_2.z;
            far_vx = _roll_placed_2.vx;
            far_vy = _roll_placed_2.vy;
            far_vz = _roll_placed_2.vz;
            far_wx = _roll_placed_2.wx;
            far_wy = _roll_placed_2.wy;
            far_wz = _roll_placed_2.wz;
            CALL(court_roll_start, _roll_start_2)(far_nx, far_ny, far_nz, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, FIXED(6));
            EACH(SET, _roll_start_2, vx_0, vy_0, vz_0, nx_0, ny_0, nz_0, turn_rate_0)
            CALL(court_roll_0, _roll_0_2)(nx_0, ny_0, nz_0, vx_0, vy_0, vz_0, bent_x, bent_y, bent_z, per_reach, turn_rate_0, FIXED(21), FIXED(126), FIXED(109), FIXED(127));
            EACH(SET, _roll_0_2, lift_0, tx_0, ty_0, tz_0, vx_1, vy_1, vz_1, nx_1, ny_1, nz_1)
            EACH(SET, _roll_0_2, turn_rate_1)
            CALL(court_roll_1, _roll_1_2)(nx_0, nx_1, ny_0, ny_1, nz_0, nz_1, vx_0, vx_1, vy_0, vy_1, vz_0, vz_1, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, lift_0, tx_0, ty_0, tz_0, FIXED(21), FIXED(126), FIXED(109));
            EACH(SET, _roll_1_2, lift_1, tx_1, ty_1, tz_1, vx_2, vy_2, vz_2, nx_2, ny_2, nz_2)
            EACH(SET, _roll_1_2, turn_rate_2)
            CALL(court_roll_2, _roll_2_2)(nx_0, nx_1, nx_2, ny_0, ny_1, ny_2, nz_0, nz_1, nz_2, vx_0, vx_1, vx_2, vy_0, vy_1, vy_2, vz_0, vz_1, vz_2, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, lift_0, lift_1, tx_0, tx_1, ty_0, ty_1, tz_0, tz_1, FIXED(21), FIXED(126), FIXED(109));
            EACH(SET, _roll_2_2, lift_2, tx_2, ty_2, tz_2, vx_3, vy_3, vz_3, nx_3, ny_3, nz_3)
            EACH(SET, _roll_2_2, turn_rate_3)
            CALL(court_roll_3, _roll_3_2)(nx_0, nx_1, nx_2, nx_3, ny_0, ny_1, ny_2, ny_3, nz_0, nz_1, nz_2, nz_3, vx_0, vx_1, vx_2, vx_3, vy_0, vy_1, vy_2, vy_3, vz_0, vz_1, vz_2, vz_3, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, lift_0, lift_1, lift_2, tx_0, tx_1, tx_2, ty_0, ty_1, ty_2, tz_0, tz_1, tz_2, FIXED(21), FIXED(126), FIXED(109));
            EACH(SET, _roll_3_2, lift_3, tx_3, ty_3, tz_3, vx_4, vy_4, vz_4, nx_4, ny_4, nz_4)
            EACH(SET, _roll_3_2, turn_rate_4)
            CALL(court_roll_4, _roll_4_2)(nx_0, nx_1, nx_2, nx_3, nx_4, ny_0, ny_1, ny_2, ny_3, ny_4, nz_0, nz_1, nz_2, nz_3, nz_4, vx_0, vx_1, vx_2, vx_3, vx_4, vy_0, vy_1, vy_2, vy_3, vy_4, vz_0, vz_1, vz_2, vz_3, vz_4, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, lift_0, lift_1, lift_2, lift_3, tx_0, tx_1, tx_2, tx_3, ty_0, ty_1, ty_2, ty_3, tz_0, tz_1, tz_2, tz_3, FIXED(21), FIXED(126), FIXED(109));
            EACH(SET, _roll_4_2, lift_4, tx_4, ty_4, tz_4, vx_5, vy_5, vz_5, nx_5, ny_5, nz_5)
            EACH(SET, _roll_4_2, turn_rate_5)
            CALL(court_roll_5, _roll_5_2)(nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, lift_0, lift_1, lift_2, lift_3, lift_4, tx_0, tx_1, tx_2, tx_3, tx_4, ty_0, ty_1, ty_2, ty_3, ty_4, tz_0, tz_1, tz_2, tz_3, tz_4, FIXED(21), FIXED(126), FIXED(109));
            EACH(SET, _roll_5_2, lift_5, tx_5, ty_5, tz_5, vx_6, vy_6, vz_6, nx_6, ny_6, nz_6)
            EACH(SET, _roll_5_2, turn_rate_6)
            CALL(court_roll_6, _roll_6_2)(nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, FIXED(21), FIXED(126), FIXED(109));
            EACH(SET, _roll_6_2, lift_6, tx_6, ty_6, tz_6, vx_7, vy_7, vz_7, nx_7, ny_7, nz_7)
            EACH(SET, _roll_6_2, turn_rate_7)
            CALL(court_roll_7, _roll_7_2)(nx_0, nx_1, nx_2, nx_3, nx_4, nx_5, nx_6, nx_7, ny_0, ny_1, ny_2, ny_3, ny_4, ny_5, ny_6, ny_7, nz_0, nz_1, nz_2, nz_3, nz_4, nz_5, nz_6, nz_7, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, bent_x, bent_y, bent_z, per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, lift_0, lift_1, lift_2, lift_3, lift_4, lift_5, lift_6, tx_0, tx_1, tx_2, tx_3, tx_4, tx_5, tx_6, ty_0, ty_1, ty_2, ty_3, ty_4, ty_5, ty_6, tz_0, tz_1, tz_2, tz_3, tz_4, tz_5, tz_6, FIXED(21), FIXED(126), FIXED(109));
            EACH(SET, _roll_7_2, vx_8, vy_8, vz_8, turn_rate_8)
            CALL(court_roll_moved, _roll_moved_2)(far_x, far_y, far_z, vx_0, vx_1, vx_2, vx_3, vx_4, vx_5, vx_6, vx_7, vx_8, vy_0, vy_1, vy_2, vy_3, vy_4, vy_5, vy_6, vy_7, vy_8, vz_0, vz_1, vz_2, vz_3, vz_4, vz_5, vz_6, vz_7, vz_8, stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8);
            far_x = _roll_moved_2.x;
            far_vx = _roll_moved_2.vx;
            far_y = _roll_moved_2.y;
            far_vy = _roll_moved_2.vy;
            far_z = _roll_moved_2.z;
            far_vz = _roll_moved_2.vz;
            EACH(SET, _roll_moved_2, turn_rate)
            CALL(court_holding, _holding_12)(K(1.0), held);
            EACH(SET, _holding_12, here)
            const M _if_here_12 = lanes_both(active, here);
            if (lanes_any(_if_here_12)) {
                CALL(court_backboard_normal, _backboard_normal_5)(far_x, far_y, far_z, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(15), FIXED(108));
                far_nx = lanes_select(_if_here_12, _backboard_normal_5.nx, far_nx);
                far_ny = lanes_select(_if_here_12, _backboard_normal_5.ny, far_ny);
                far_nz = lanes_select(_if_here_12, _backboard_normal_5.nz, far_nz);
                CALL(court_backboard_distance, _backboard_distance_3)(far_x, far_y, far_z, FIXED(6), FIXED(11), FIXED(9), FIXED(10), FIXED(12), FIXED(15));
                far_gap = lanes_select(_if_here_12, _backboard_distance_3.gap, far_gap);
            }
            CALL(court_holding, _holding_13)(K(2.0), held);
            EACH(SET, _holding_13, here)
            const M _if_here_13 = lanes_both(active, here);
            if (lanes_any(_if_here_13)) {
                CALL(court_bridge_normal, _bridge_normal_5)(far_x, far_y, far_z, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(16), FIXED(108));
                far_nx = lanes_select(_if_here_13, _bridge_normal_5.nx, far_nx);
                far_ny = lanes_select(_if_here_13, _bridge_normal_5.ny, far_ny);
                far_nz = lanes_select(_if_here_13, _bridge_normal_5.nz, far_nz);
                CALL(court_bridge_distance, _bridge_distance_3)(far_x, far_y, far_z, FIXED(6), FIXED(9), FIXED(13), FIXED(7), FIXED(8), FIXED(16));
                far_gap = lanes_select(_if_here_13, _bridge_distance_3.gap, far_gap);
            }
            CALL(court_roll_placed, _roll_placed_3)(far_x, far_y, far_z, far_nx, far_ny, far_nz, far_vx, far_vy, far_vz, far_gap, turn_rate, FIXED(110));
            far_x = _roll_placed_3.x;
            far_y = _roll_placed_3.y;
            far_z = _roll_placed_3.z;
            far_vx = _roll_placed_3.vx;
            far_vy = _roll_placed_3.vy;
            far_vz = _roll_placed_3.vz;
            far_wx = _roll_placed_3.wx;
            far_wy = _roll_placed_3.wy;
            far_wz = _roll_placed_3.wz;
            CALL(court_compared, _compared_1)(x, y, z, vx, vy, vz, wx, wy, wz, far_x, far_y, far_z, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, stride, missed, neighbour_scale, FIXED(6));
            EACH(SET, _compared_1, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz)
#endif
            CALL(court_rolled_on, _rolled_on_1)(which, clock, stride, rests);
            EACH(SET, _rolled_on_1, clock, rolling)
            turns = lanes_add(turns, K(1.0));
            const M ended = lanes_both(active, lanes_not(lanes_both(rolling, lanes_less(turns, K(16.0)))));
            lanes_pack(worklist->in_contact_rolling_ended_row + done, ended, row);
            lanes_pack(worklist->in_contact_rolling_ended_clock + done, ended, clock);
#if BOUNDED
            lanes_pack(worklist->in_contact_rolling_ended_dvx + done, ended, dvx);
            lanes_pack(worklist->in_contact_rolling_ended_dvy + done, ended, dvy);
            lanes_pack(worklist->in_contact_rolling_ended_dvz + done, ended, dvz);
            lanes_pack(worklist->in_contact_rolling_ended_dwx + done, ended, dwx);
            lanes_pack(worklist->in_contact_rolling_ended_dwy + done, ended, dwy);
            lanes_pack(worklist->in_contact_rolling_ended_dwz + done, ended, dwz);
            lanes_pack(worklist->in_contact_rolling_ended_dx + done, ended, dx);
            lanes_pack(worklist->in_contact_rolling_ended_dy + done, ended, dy);
            lanes_pack(worklist->in_contact_rolling_ended_dz + done, ended, dz);
            lanes_pack(worklist->in_contact_rolling_ended_earliest_delay + done, ended, earliest_delay);
            lanes_pack(worklist->in_contact_rolling_ended_grip_lost + done, ended, grip_lost);
            lanes_pack(worklist->in_contact_rolling_ended_last_grip_clock + done, ended, last_grip_clock);
            lanes_pack(worklist->in_contact_rolling_ended_last_grip_deficit + done, ended, last_grip_deficit);
            lanes_pack(worklist->in_contact_rolling_ended_last_grip_deficit_rate + done, ended, last_grip_deficit_rate);
#endif
            lanes_pack(worklist->in_contact_rolling_ended_per_reach + done, ended, per_reach);
#if BOUNDED
            lanes_pack(worklist->in_contact_rolling_ended_position_error + done, ended, position_error);
#endif
            lanes_pack(worklist->in_contact_rolling_ended_rests + done, ended, lanes_select(rests, K(1.0), K(0.0)));
            lanes_pack(worklist->in_contact_rolling_ended_rolling + done, ended, lanes_select(rolling, K(1.0), K(0.0)));
            lanes_pack(worklist->in_contact_rolling_ended_through + done, ended, through);
#if BOUNDED
            lanes_pack(worklist->in_contact_rolling_ended_undecided_time + done, ended, undecided_time);
            lanes_pack(worklist->in_contact_rolling_ended_velocity_error + done, ended, velocity_error);
#endif
            lanes_pack(worklist->in_contact_rolling_ended_vx + done, ended, vx);
            lanes_pack(worklist->in_contact_rolling_ended_vy + done, ended, vy);
            lanes_pack(worklist->in_contact_rolling_ended_vz + done, ended, vz);
            lanes_pack(worklist->in_contact_rolling_ended_which + done, ended, which);
            lanes_pack(worklist->in_contact_rolling_ended_wx + done, ended, wx);
            lanes_pack(worklist->in_contact_rolling_ended_wy + done, ended, wy);
            lanes_pack(worklist->in_contact_rolling_ended_wz + done, ended, wz);
            lanes_pack(worklist->in_contact_rolling_ended_x + done, ended, x);
            lanes_pack(worklist->in_contact_rolling_ended_y + done, ended, y);
            lanes_pack(worklist->in_contact_rolling_ended_z + done, ended, z);
            done += popcount(ended);
            busy -= popcount(ended);
            active = lanes_both(active, lanes_not(ended));
        }
        for (size_t k = 0; k < done; k++) {
            const size_t row = (size_t)worklist->in_contact_rolling_ended_row[k];
            EACH(RETURN, (in_contact_, in_contact_rolling_ended_), clock, per_reach, rests, rolling)
            EACH(RETURN, (in_contact_, in_contact_rolling_ended_), through, vx, vy, vz, which, wx)
            EACH(RETURN, (in_contact_, in_contact_rolling_ended_), wy, wz, x, y, z)
            BOUNDS(EACH(RETURN, (in_contact_, in_contact_rolling_ended_), dvx, dvy, dvz, dwx, dwy, dwz, dx))
            BOUNDS(EACH(RETURN, (in_contact_, in_contact_rolling_ended_), dy, dz, earliest_delay))
            BOUNDS(EACH(RETURN, (in_contact_, in_contact_rolling_ended_), grip_lost, last_grip_clock))
            BOUNDS(EACH(RETURN, (in_contact_, in_contact_rolling_ended_), last_grip_deficit))
            BOUNDS(EACH(RETURN, (in_contact_, in_contact_rolling_ended_), last_grip_deficit_rate))
            BOUNDS(EACH(RETURN, (in_contact_, in_contact_rolling_ended_), position_error, undecided_time))
            BOUNDS(EACH(RETURN, (in_contact_, in_contact_rolling_ended_), velocity_error))
        }
    }
    }
    {
    size_t in_contact_circling_shots = 0;
#if BOUNDED
    static const int in_contact_circling_taken[] = {0, 5, 3, 4, 7, 6, 9, 8, 11, 10, 18, 15, 1, 2};
#else
    static const int in_contact_circling_taken[] = {0, 5, 3, 4, 7, 6, 9, 8, 11, 10, 18, 1, 2};
#endif
    for (size_t i = 0; i < in_contact_shots; i += LANES_WIDTH) {
        const M rows = mask_first_n(in_contact_shots - i);
        EACH(LOAD_MASK, in_contact_, circling)
        const M packed = lanes_both(rows, circling);
        if (lanes_any(packed)) {
            EACH(LOAD, in_contact_, circled, clock, through, vx, vy, vz, which, wx, wy, wz, x, y, z)
            BOUNDS(EACH(LOAD, in_contact_, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz))
            BOUNDS(EACH(LOAD, in_contact_, earliest_delay, estimated, grip_lost, last_grip_clock))
            BOUNDS(EACH(LOAD, in_contact_, last_grip_deficit, last_grip_deficit_rate, undecided_time))
            BOUNDS(EACH(LOAD_SINGLE, in_contact_, clock_bound, position_bound, spin_bound, velocity_bound))
            lanes_pack(worklist->in_contact_circling_row + in_contact_circling_shots, packed, lanes_add(iota(), K((double)i)));
            EACH(PACK, in_contact_circling_, circled, clock, through, vx, vy, vz, which, wx, wy, wz)
            EACH(PACK, in_contact_circling_, x, y, z)
            BOUNDS(EACH(PACK, in_contact_circling_, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz))
            BOUNDS(EACH(PACK, in_contact_circling_, earliest_delay, estimated, grip_lost, last_grip_clock))
            BOUNDS(EACH(PACK, in_contact_circling_, last_grip_deficit, last_grip_deficit_rate))
            BOUNDS(EACH(PACK, in_contact_circling_, undecided_time))
            BOUNDS(EACH(PACK_SINGLE, in_contact_circling_, clock_bound, position_bound, spin_bound))
            BOUNDS(EACH(PACK_SINGLE, in_contact_circling_, velocity_bound))
            if (LANES_SELDOM(varying)) {
#if BOUNDED
                for (size_t _p = 0; _p < 14; _p++) {
#else
                for (size_t _p = 0; _p < 13; _p++) {
#endif
                    lanes_pack(worklist->in_contact_circling_parameters.columns[in_contact_circling_taken[_p]] + in_contact_circling_shots, packed, lanes_load(worklist->in_contact_parameters.columns[in_contact_circling_taken[_p]] + i));
                }
            }
            in_contact_circling_shots += popcount(packed);
        }
    }
    if (in_contact_circling_shots) {
        EACH(CLEAR, in_contact_circling_, row, circled, clock, through, vx, vy, vz, which, wx, wy)
        EACH(CLEAR, in_contact_circling_, wz, x, y, z)
        BOUNDS(EACH(CLEAR, in_contact_circling_, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz))
        BOUNDS(EACH(CLEAR, in_contact_circling_, earliest_delay, estimated, grip_lost, last_grip_clock))
        BOUNDS(EACH(CLEAR, in_contact_circling_, last_grip_deficit, last_grip_deficit_rate, undecided_time))
        BOUNDS(EACH(CLEAR_SINGLE, in_contact_circling_, clock_bound, position_bound, spin_bound))
        BOUNDS(EACH(CLEAR_SINGLE, in_contact_circling_, velocity_bound))
        if (LANES_SELDOM(varying)) {
#if BOUNDED
            for (size_t _p = 0; _p < 14; _p++) {
#else
            for (size_t _p = 0; _p < 13; _p++) {
#endif
                lanes_store(worklist->in_contact_circling_parameters.columns[in_contact_circling_taken[_p]] + in_contact_circling_shots, K(0.0));
            }
        }
    }
    {
        size_t taken = 0;
        size_t done = 0;
        size_t busy = 0;
        EACH(START_MASK, , active)
        EACH(START, , row, turns)
#if BOUNDED
        V p_ring_friction = lanes_load(worklist->parameters.p_ring_friction);
#endif
        EACH(START, , circled, clock, through, vx, vy, vz, which, wx, wy, wz, x, y, z)
        BOUNDS(EACH(START, , clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, earliest_delay))
        BOUNDS(EACH(START, , estimated, grip_lost, last_grip_clock, last_grip_deficit))
        BOUNDS(EACH(START, , last_grip_deficit_rate, undecided_time))
        BOUNDS(EACH(START_SINGLE, , clock_bound, position_bound, spin_bound, velocity_bound))
        for (;;) {
            if ((taken < in_contact_circling_shots) && ((busy + LANES_SPARE) <= LANES_WIDTH)) {
                const M idle = lanes_not(active);
                turns = lanes_select(idle, K(0.0), turns);
                EACH(EXPAND, in_contact_circling_, row, circled, clock, through, vx, vy, vz, which)
                EACH(EXPAND, in_contact_circling_, wx, wy, wz, x, y, z)
#if BOUNDED
                EACH(EXPAND, in_contact_circling_, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx)
                EACH(EXPAND, in_contact_circling_, dy, dz, earliest_delay, estimated, grip_lost)
                EACH(EXPAND, in_contact_circling_, last_grip_clock, last_grip_deficit)
                EACH(EXPAND, in_contact_circling_, last_grip_deficit_rate, undecided_time)
                EACH(EXPAND_SINGLE, in_contact_circling_, clock_bound, position_bound, spin_bound)
                EACH(EXPAND_SINGLE, in_contact_circling_, velocity_bound)
                if (varying)
                    p_ring_friction = lanes_expand(worklist->in_contact_circling_parameters.p_ring_friction + taken, idle, p_ring_friction);
#endif
                if (LANES_SELDOM(varying))
                    LOOP(fix_in_contact_circling_rows_1)(worklist, taken, idle);
                const size_t room = LANES_WIDTH - busy;
                const size_t _left = in_contact_circling_shots - taken;
                active = lanes_leading(idle, _left, active);
                taken += _left < room ? _left : room;
                busy += _left < room ? _left : room;
            }
            if (busy == 0)
                break;
            M circling = active;
#if BOUNDED
            CALL(court_error_bounds, _error_bounds_1)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, lanes_wide(position_bound), lanes_wide(velocity_bound), lanes_wide(spin_bound), estimated, lanes_wide(clock_bound));
            EACH(GET, _error_bounds_1, position_error, velocity_error)
#endif
            CALL(court_ring_rolling_surface, _ring_rolling_surface_1)(FIXED(107));
            EACH(GET, _ring_rolling_surface_1, per_reach)
            CALL(court_ring_round_start, _ring_round_start_1)(x, y, z, vx, vy, vz, wx, wy, wz, per_reach, FIXED(6), FIXED(7), FIXED(109), FIXED(131));
            EACH(GET, _ring_round_start_1, cosine_0, sine_0, climb_0, along_0, turn_rate_0, cos_0)
            EACH(GET, _ring_round_start_1, sin_0, tilted_0, near_0)
            CALL(court_ring_round_0, _ring_round_0_1)(per_reach, turn_rate_0, near_0, climb_0, cosine_0, sine_0, along_0, tilted_0, FIXED(21), FIXED(7), FIXED(126), FIXED(131), FIXED(109), FIXED(135));
            EACH(GET, _ring_round_0_1, omega_0, around_0, cosine_1, sine_1, climb_1, along_1)
            EACH(GET, _ring_round_0_1, turn_rate_1, tilted_1)
            CALL(court_ring_round_1, _ring_round_1_1)(per_reach, turn_rate_0, turn_rate_1, near_0, climb_0, climb_1, cosine_0, cosine_1, sine_0, sine_1, along_1, omega_0, around_0, tilted_0, tilted_1, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(136), FIXED(135));
            EACH(GET, _ring_round_1_1, omega_1, around_1, cosine_2, sine_2, climb_2, along_2)
            EACH(GET, _ring_round_1_1, turn_rate_2, tilted_2)
            CALL(court_ring_round_2, _ring_round_2_1)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, near_0, climb_0, climb_1, climb_2, cosine_0, cosine_1, cosine_2, sine_0, sine_1, sine_2, along_2, omega_0, omega_1, around_0, around_1, tilted_0, tilted_1, tilted_2, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(137), FIXED(135));
            EACH(GET, _ring_round_2_1, omega_2, around_2, cosine_3, sine_3, climb_3, along_3)
            EACH(GET, _ring_round_2_1, turn_rate_3, tilted_3)
            CALL(court_ring_round_3, _ring_round_3_1)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, near_0, climb_0, climb_1, climb_2, climb_3, cosine_0, cosine_1, cosine_2, cosine_3, sine_0, sine_1, sine_2, sine_3, along_3, omega_0, omega_1, omega_2, around_0, around_1, around_2, tilted_0, tilted_1, tilted_2, tilted_3, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(138), FIXED(135));
            EACH(GET, _ring_round_3_1, omega_3, around_3, cosine_4, sine_4, climb_4, along_4)
            EACH(GET, _ring_round_3_1, turn_rate_4, tilted_4)
            CALL(court_ring_round_4, _ring_round_4_1)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, sine_0, sine_1, sine_2, sine_3, sine_4, along_4, omega_0, omega_1, omega_2, omega_3, around_0, around_1, around_2, around_3, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(139), FIXED(135));
            EACH(GET, _ring_round_4_1, omega_4, around_4, cosine_5, sine_5, climb_5, along_5)
            EACH(GET, _ring_round_4_1, turn_rate_5, tilted_5)
            CALL(court_ring_round_5, _ring_round_5_1)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, along_5, omega_0, omega_1, omega_2, omega_3, omega_4, around_0, around_1, around_2, around_3, around_4, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(140), FIXED(135));
            EACH(GET, _ring_round_5_1, omega_5, around_5, cosine_6, sine_6, climb_6, along_6)
            EACH(GET, _ring_round_5_1, turn_rate_6, tilted_6)
            CALL(court_ring_round_6, _ring_round_6_1)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, along_6, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, around_0, around_1, around_2, around_3, around_4, around_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(141), FIXED(135));
            EACH(GET, _ring_round_6_1, omega_6, around_6, cosine_7, sine_7, climb_7, along_7)
            EACH(GET, _ring_round_6_1, turn_rate_7, tilted_7)
            CALL(court_ring_round_7, _ring_round_7_1)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, along_7, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, around_0, around_1, around_2, around_3, around_4, around_5, around_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(142), FIXED(135));
            EACH(GET, _ring_round_7_1, omega_7, around_7, cosine_8, sine_8, climb_8, along_8)
            EACH(GET, _ring_round_7_1, turn_rate_8, tilted_8)
            CALL(court_ring_round_8, _ring_round_8_1)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, along_8, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(143), FIXED(135));
            EACH(GET, _ring_round_8_1, omega_8, around_8, cosine_9, sine_9, climb_9, along_9)
            EACH(GET, _ring_round_8_1, turn_rate_9, tilted_9)
            CALL(court_ring_round_9, _ring_round_9_1)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, along_9, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(144), FIXED(135));
            EACH(GET, _ring_round_9_1, omega_9, around_9, cosine_10, sine_10, climb_10, along_10)
            EACH(GET, _ring_round_9_1, turn_rate_10, tilted_10)
            CALL(court_ring_round_10, _ring_round_10_1)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, turn_rate_10, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, climb_10, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, cosine_10, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, sine_10, along_10, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, tilted_10, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(145), FIXED(135));
            EACH(GET, _ring_round_10_1, omega_10, around_10, cosine_11, sine_11, climb_11, along_11)
            EACH(GET, _ring_round_10_1, turn_rate_11, tilted_11)
            CALL(court_ring_round_11, _ring_round_11_1)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, turn_rate_10, turn_rate_11, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, climb_10, climb_11, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, cosine_10, cosine_11, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, sine_10, sine_11, along_11, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, omega_10, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, around_10, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, tilted_10, tilted_11, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(146), FIXED(135));
            EACH(GET, _ring_round_11_1, omega_11, cosine_12, sine_12, climb_12, along_12)
            EACH(GET, _ring_round_11_1, turn_rate_12)
            CALL(court_ring_round_step, _ring_round_step_1)(per_reach, turn_rate_0, turn_rate_11, turn_rate_12, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, climb_10, climb_11, climb_12, cosine_0, cosine_12, sine_0, sine_12, along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, along_10, along_11, along_12, cos_0, sin_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, omega_10, omega_11, FIXED(21), FIXED(128), FIXED(131), FIXED(147), FIXED(148), FIXED(149), FIXED(150));
            EACH(GET, _ring_round_step_1, stride, strongest, fastest, section_acceleration, force)
            EACH(GET, _ring_round_step_1, force_rate, force_bend, friction_force_rate, vx_1, vy_1)
            EACH(GET, _ring_round_step_1, vz_1)
#if BOUNDED
            EACH(GET, _ring_round_step_1, missed)
            CALL(court_ring_round_pulled, _ring_round_pulled_1)(turn_rate_0, turn_rate_1, climb_0, climb_1, cosine_0, cosine_1, omega_0, omega_1, FIXED(21), FIXED(109));
            EACH(GET, _ring_round_pulled_1, rolling_friction, rolling_friction_rate)
            CALL(court_ring_impact_grip_deficit, _ring_impact_grip_deficit_1)(p_ring_friction, rolling_friction, rolling_friction_rate, force, force_rate);
            EACH(GET, _ring_impact_grip_deficit_1, grip_deficit, grip_deficit_rate)
            CALL(court_exceeds_grip, _exceeds_grip_1)(grip_deficit, grip_lost);
            EACH(GET_MASK, _exceeds_grip_1, loses)
            const M _if_loses_1 = lanes_both(active, loses);
            if (lanes_any(_if_loses_1)) {
                CALL(court_grip_lost_time, _grip_lost_time_1)(clock, grip_deficit, grip_deficit_rate, last_grip_deficit, last_grip_deficit_rate, last_grip_clock);
                EACH(SELECT, (_if_loses_1, _grip_lost_time_1), grip_lost)
            }
            CALL(court_remember_grip_deficit, _remember_grip_deficit_1)(clock, grip_deficit, grip_deficit_rate);
            EACH(SET, _remember_grip_deficit_1, last_grip_deficit, last_grip_deficit_rate)
            EACH(SET, _remember_grip_deficit_1, last_grip_clock)
#endif
            CALL(court_leaving_force, _leaving_force_1)(vx, vx_1, vy, vy_1, vz, vz_1, which, OR_INFINITE(undecided_time), OR_ZERO(position_error), OR_ZERO(velocity_error), per_reach, force, force_rate, force_bend, friction_force_rate, stride, fastest, FIXED(21), FIXED(129), FIXED(130));
            EACH(SET, _leaving_force_1, stride, which)
            EACH(GET_MASK, _leaving_force_1, rests)
            BOUNDS(EACH(SET, _leaving_force_1, undecided_time))
            CALL(court_backboard_beside, _backboard_beside_1)(x, y, z, vx, vy, vz, FIXED(6), FIXED(11), FIXED(9), FIXED(10), FIXED(12), FIXED(15));
            EACH(GET, _backboard_beside_1, gap, nearing, gap_curvature)
            CALL(court_beside_body, _beside_body_1)(x, y, z, gap, K(1.0), which, OR_ZERO(earliest_delay), OR_INFINITE(undecided_time), OR_ZERO(position_error), nearing, gap_curvature, stride, strongest, fastest, FIXED(6), FIXED(111));
            EACH(SET, _beside_body_1, stride, which)
            BOUNDS(EACH(SET, _beside_body_1, undecided_time, earliest_delay))
            CALL(court_bridge_beside, _bridge_beside_1)(x, y, z, vx, vy, vz, FIXED(6), FIXED(9), FIXED(13), FIXED(7), FIXED(8), FIXED(16));
            EACH(SET, _bridge_beside_1, gap, nearing, gap_curvature)
            CALL(court_beside_body, _beside_body_2)(x, y, z, gap, K(2.0), which, OR_ZERO(earliest_delay), OR_INFINITE(undecided_time), OR_ZERO(position_error), nearing, gap_curvature, stride, strongest, fastest, FIXED(6), FIXED(111));
            EACH(SET, _beside_body_2, stride, which)
            BOUNDS(EACH(SET, _beside_body_2, undecided_time, earliest_delay))
            CALL(court_end_beside, _end_beside_1)(z, vz, FIXED(18));
            EACH(SET, _end_beside_1, gap, nearing, gap_curvature)
            CALL(court_beside_end_plane, _beside_end_plane_1)(x, y, z, gap, K(3.0), which, OR_ZERO(earliest_delay), OR_INFINITE(undecided_time), OR_ZERO(position_error), nearing, gap_curvature, stride, strongest, fastest, FIXED(6));
            EACH(SET, _beside_end_plane_1, stride, which)
            BOUNDS(EACH(SET, _beside_end_plane_1, undecided_time, earliest_delay))
            CALL(court_beside_time, _beside_time_1)(which, clock, time_limit, stride);
            EACH(SET, _beside_time_1, stride, which)
#if BOUNDED
            CALL(court_neighbour_scale, _neighbour_scale_1)(dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, FIXED(6), FIXED(133), FIXED(134));
            EACH(GET, _neighbour_scale_1, neighbour_scale)
            CALL(court_neighbour, _neighbour_1)(x, y, z, vx, vy, vz, wx, wy, wz, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, neighbour_scale);
            EACH(GET, _neighbour_1, far_x, far_y, far_z, far_vx, far_vy, far_vz, far_wx, far_wy)
            EACH(GET, _neighbour_1, far_wz)
#endif
            CALL(court_passing_from, _passing_from_1)(z);
            EACH(GET_MASK, _passing_from_1, over)
            CALL(court_isolated, _isolated_1)();
            V azimuth_clearance = _isolated_1.nearest;
            CALL(court_half_steps, _half_steps_1)(stride);
            EACH(GET, _half_steps_1, forth, back)
            CALL(court_backboard_around, _backboard_around_1)(x, y, z, vx, vy, vz, FIXED(6), FIXED(11), FIXED(12), FIXED(151));
            EACH(SET, _backboard_around_1, gap, nearing)
            CALL(court_clearance_at_any_azimuth, _clearance_at_any_azimuth_1)(gap, nearing, forth, azimuth_clearance);
            EACH(SET, _clearance_at_any_azimuth_1, azimuth_clearance)
            CALL(court_bridge_around, _bridge_around_1)(x, y, z, vx, vy, vz, FIXED(6), FIXED(8), FIXED(16), FIXED(152));
            EACH(SET, _bridge_around_1, gap, nearing)
            CALL(court_clearance_at_any_azimuth, _clearance_at_any_azimuth_2)(gap, nearing, forth, azimuth_clearance);
            EACH(SET, _clearance_at_any_azimuth_2, azimuth_clearance)
            CALL(court_end_around, _end_around_1)(z, vz, FIXED(18));
            EACH(SET, _end_around_1, gap, nearing)
            CALL(court_clearance_at_any_azimuth, _clearance_at_any_azimuth_3)(gap, nearing, forth, azimuth_clearance);
            EACH(SET, _clearance_at_any_azimuth_3, azimuth_clearance)
            CALL(court_ring_round_moved, _ring_round_moved_1)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, turn_rate_10, turn_rate_11, turn_rate_12, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, climb_10, climb_11, climb_12, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, cosine_10, cosine_11, cosine_12, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, sine_10, sine_11, sine_12, along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, along_10, along_11, along_12, cos_0, sin_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, omega_10, omega_11, FIXED(7), FIXED(131), FIXED(110));
            EACH(SET, _ring_round_moved_1, x, y, z, vx, vy, vz, wx, wy, wz)
            EACH(GET, _ring_round_moved_1, climb)
            CALL(court_passing_in_contact, _passing_in_contact_1)(x, y, z, through, over, FIXED(19));
            EACH(SET, _passing_in_contact_1, through)
            CALL(court_backboard_around, _backboard_around_2)(x, y, z, vx, vy, vz, FIXED(6), FIXED(11), FIXED(12), FIXED(151));
            EACH(SET, _backboard_around_2, gap, nearing)
            CALL(court_clearance_at_any_azimuth, _clearance_at_any_azimuth_4)(gap, nearing, back, azimuth_clearance);
            EACH(SET, _clearance_at_any_azimuth_4, azimuth_clearance)
            CALL(court_bridge_around, _bridge_around_2)(x, y, z, vx, vy, vz, FIXED(6), FIXED(8), FIXED(16), FIXED(152));
            EACH(SET, _bridge_around_2, gap, nearing)
            CALL(court_clearance_at_any_azimuth, _clearance_at_any_azimuth_5)(gap, nearing, back, azimuth_clearance);
            EACH(SET, _clearance_at_any_azimuth_5, azimuth_clearance)
            CALL(court_end_around, _end_around_2)(z, vz, FIXED(18));
            EACH(SET, _end_around_2, gap, nearing)
            CALL(court_clearance_at_any_azimuth, _clearance_at_any_azimuth_6)(gap, nearing, back, azimuth_clearance);
            EACH(SET, _clearance_at_any_azimuth_6, azimuth_clearance)
            CALL(court_ring_swung, _ring_swung_1)(which, OR_INFINITE(undecided_time), OR_ZERO(position_error), OR_ZERO(velocity_error), force, force_rate, force_bend, stride, fastest, circled, climb, climb_0, section_acceleration, azimuth_clearance, FIXED(21), FIXED(131), FIXED(153), FIXED(154), FIXED(128), FIXED(107), FIXED(155));
            EACH(SET, _ring_swung_1, circled)
            EACH(GET_MASK, _ring_swung_1, endless)
            BOUNDS(EACH(SET, _ring_swung_1, undecided_time))
            CALL(court_rolls_for_ever, _rolls_for_ever_1)(which, endless);
            EACH(SET, _rolls_for_ever_1, which)
#if BOUNDED
            CALL(court_ring_round_start, _ring_round_start_2)(far_x, far_y, far_z, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, per_reach, FIXED(6), FIXED(7), FIXED(109), FIXED(131));
            EACH(SET, _ring_round_start_2, cosine_0, sine_0, climb_0, along_0, turn_rate_0, cos_0)
            EACH(SET, _ring_round_start_2, sin_0, tilted_0, near_0)
            CALL(court_ring_round_0, _ring_round_0_2)(per_reach, turn_rate_0, near_0, climb_0, cosine_0, sine_0, along_0, tilted_0, FIXED(21), FIXED(7), FIXED(126), FIXED(131), FIXED(109), FIXED(135));
            EACH(SET, _ring_round_0_2, omega_0, around_0, cosine_1, sine_1, climb_1, along_1)
            EACH(SET, _ring_round_0_2, turn_rate_1, tilted_1)
            CALL(court_ring_round_1, _ring_round_1_2)(per_reach, turn_rate_0, turn_rate_1, near_0, climb_0, climb_1, cosine_0, cosine_1, sine_0, sine_1, along_1, omega_0, around_0, tilted_0, tilted_1, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(136), FIXED(135));
            EACH(SET, _ring_round_1_2, omega_1, around_1, cosine_2, sine_2, climb_2, along_2)
            EACH(SET, _ring_round_1_2, turn_rate_2, tilted_2)
            CALL(court_ring_round_2, _ring_round_2_2)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, near_0, climb_0, climb_1, climb_2, cosine_0, cosine_1, cosine_2, sine_0, sine_1, sine_2, along_2, omega_0, omega_1, around_0, around_1, tilted_0, tilted_1, tilted_2, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(137), FIXED(135));
            EACH(SET, _ring_round_2_2, omega_2, around_2, cosine_3, sine_3, climb_3, along_3)
            EACH(SET, _ring_round_2_2, turn_rate_3, tilted_3)
            CALL(court_ring_round_3, _ring_round_3_2)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, near_0, climb_0, climb_1, climb_2, climb_3, cosine_0, cosine_1, cosine_2, cosine_3, sine_0, sine_1, sine_2, sine_3, along_3, omega_0, omega_1, omega_2, around_0, around_1, around_2, tilted_0, tilted_1, tilted_2, tilted_3, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(138), FIXED(135));
            EACH(SET, _ring_round_3_2, omega_3, around_3, cosine_4, sine_4, climb_4, along_4)
            EACH(SET, _ring_round_3_2, turn_rate_4, tilted_4)
            CALL(court_ring_round_4, _ring_round_4_2)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, sine_0, sine_1, sine_2, sine_3, sine_4, along_4, omega_0, omega_1, omega_2, omega_3, around_0, around_1, around_2, around_3, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(139), FIXED(135));
            EACH(SET, _ring_round_4_2, omega_4, around_4, cosine_5, sine_5, climb_5, along_5)
            EACH(SET, _ring_round_4_2, turn_rate_5, tilted_5)
            CALL(court_ring_round_5, _ring_round_5_2)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, along_5, omega_0, omega_1, omega_2, omega_3, omega_4, around_0, around_1, around_2, around_3, around_4, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(140), FIXED(135));
            EACH(SET, _ring_round_5_2, omega_5, around_5, cosine_6, sine_6, climb_6, along_6)
            EACH(SET, _ring_round_5_2, turn_rate_6, tilted_6)
            CALL(court_ring_round_6, _ring_round_6_2)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, along_6, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, around_0, around_1, around_2, around_3, around_4, around_5, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(141), FIXED(135));
            EACH(SET, _ring_round_6_2, omega_6, around_6, cosine_7, sine_7, climb_7, along_7)
            EACH(SET, _ring_round_6_2, turn_rate_7, tilted_7)
            CALL(court_ring_round_7, _ring_round_7_2)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, along_7, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, around_0, around_1, around_2, around_3, around_4, around_5, around_6, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(142), FIXED(135));
            EACH(SET, _ring_round_7_2, omega_7, around_7, cosine_8, sine_8, climb_8, along_8)
            EACH(SET, _ring_round_7_2, turn_rate_8, tilted_8)
            CALL(court_ring_round_8, _ring_round_8_2)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, along_8, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(143), FIXED(135));
            EACH(SET, _ring_round_8_2, omega_8, around_8, cosine_9, sine_9, climb_9, along_9)
            EACH(SET, _ring_round_8_2, turn_rate_9, tilted_9)
            CALL(court_ring_round_9, _ring_round_9_2)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, along_9, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(144), FIXED(135));
            EACH(SET, _ring_round_9_2, omega_9, around_9, cosine_10, sine_10, climb_10, along_10)
            EACH(SET, _ring_round_9_2, turn_rate_10, tilted_10)
            CALL(court_ring_round_10, _ring_round_10_2)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, turn_rate_10, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, climb_10, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, cosine_10, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, sine_10, along_10, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, tilted_10, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(145), FIXED(135));
            EACH(SET, _ring_round_10_2, omega_10, around_10, cosine_11, sine_11, climb_11, along_11)
            EACH(SET, _ring_round_10_2, turn_rate_11, tilted_11)
            CALL(court_ring_round_11, _ring_round_11_2)(per_reach, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, turn_rate_10, turn_rate_11, near_0, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, climb_10, climb_11, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, cosine_10, cosine_11, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, sine_10, sine_11, along_11, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, omega_10, around_0, around_1, around_2, around_3, around_4, around_5, around_6, around_7, around_8, around_9, around_10, tilted_0, tilted_1, tilted_2, tilted_3, tilted_4, tilted_5, tilted_6, tilted_7, tilted_8, tilted_9, tilted_10, tilted_11, FIXED(21), FIXED(131), FIXED(126), FIXED(109), FIXED(146), FIXED(135));
            EACH(SET, _ring_round_11_2, omega_11, cosine_12, sine_12, climb_12, along_12)
            EACH(SET, _ring_round_11_2, turn_rate_12)
            CALL(court_ring_round_moved, _ring_round_moved_2)(stride, turn_rate_0, turn_rate_1, turn_rate_2, turn_rate_3, turn_rate_4, turn_rate_5, turn_rate_6, turn_rate_7, turn_rate_8, turn_rate_9, turn_rate_10, turn_rate_11, turn_rate_12, climb_0, climb_1, climb_2, climb_3, climb_4, climb_5, climb_6, climb_7, climb_8, climb_9, climb_10, climb_11, climb_12, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9, cosine_10, cosine_11, cosine_12, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9, sine_10, sine_11, sine_12, along_0, along_1, along_2, along_3, along_4, along_5, along_6, along_7, along_8, along_9, along_10, along_11, along_12, cos_0, sin_0, omega_0, omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7, omega_8, omega_9, omega_10, omega_11, FIXED(7), FIXED(131), FIXED(110));
            far_x = _ring_round_moved_2.x;
            far_y = _ring_round_moved_2.y;
            far_z = _ring_round_moved_2.z;
            far_vx = _ring_round_moved_2.vx;
            far_vy = _ring_round_moved_2.vy;
            far_vz = _ring_round_moved_2.vz;
            far_wx = _ring_round_moved_2.wx;
            far_wy = _ring_round_moved_2.wy;
            far_wz = _ring_round_moved_2.wz;
            CALL(court_compared, _compared_1)(x, y, z, vx, vy, vz, wx, wy, wz, far_x, far_y, far_z, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, stride, missed, neighbour_scale, FIXED(6));
            EACH(SET, _compared_1, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz)
#endif
            CALL(court_rolled_on, _rolled_on_1)(which, clock, stride, rests);
            EACH(SET, _rolled_on_1, clock)
            circling = _rolled_on_1.rolling;
            turns = lanes_add(turns, K(1.0));
            const M ended = lanes_both(active, lanes_not(lanes_both(circling, lanes_less(turns, K(16.0)))));
            lanes_pack(worklist->in_contact_circling_ended_row + done, ended, row);
            lanes_pack(worklist->in_contact_circling_ended_circled + done, ended, circled);
            lanes_pack(worklist->in_contact_circling_ended_circling + done, ended, lanes_select(circling, K(1.0), K(0.0)));
            lanes_pack(worklist->in_contact_circling_ended_clock + done, ended, clock);
#if BOUNDED
            lanes_pack(worklist->in_contact_circling_ended_dvx + done, ended, dvx);
            lanes_pack(worklist->in_contact_circling_ended_dvy + done, ended, dvy);
            lanes_pack(worklist->in_contact_circling_ended_dvz + done, ended, dvz);
            lanes_pack(worklist->in_contact_circling_ended_dwx + done, ended, dwx);
            lanes_pack(worklist->in_contact_circling_ended_dwy + done, ended, dwy);
            lanes_pack(worklist->in_contact_circling_ended_dwz + done, ended, dwz);
            lanes_pack(worklist->in_contact_circling_ended_dx + done, ended, dx);
            lanes_pack(worklist->in_contact_circling_ended_dy + done, ended, dy);
            lanes_pack(worklist->in_contact_circling_ended_dz + done, ended, dz);
            lanes_pack(worklist->in_contact_circling_ended_earliest_delay + done, ended, earliest_delay);
            lanes_pack(worklist->in_contact_circling_ended_grip_lost + done, ended, grip_lost);
            lanes_pack(worklist->in_contact_circling_ended_last_grip_clock + done, ended, last_grip_clock);
            lanes_pack(worklist->in_contact_circling_ended_last_grip_deficit + done, ended, last_grip_deficit);
            lanes_pack(worklist->in_contact_circling_ended_last_grip_deficit_rate + done, ended, last_grip_deficit_rate);
#endif
            lanes_pack(worklist->in_contact_circling_ended_per_reach + done, ended, per_reach);
#if BOUNDED
            lanes_pack(worklist->in_contact_circling_ended_position_error + done, ended, position_error);
#endif
            lanes_pack(worklist->in_contact_circling_ended_rests + done, ended, lanes_select(rests, K(1.0), K(0.0)));
            lanes_pack(worklist->in_contact_circling_ended_through + done, ended, through);
#if BOUNDED
            lanes_pack(worklist->in_contact_circling_ended_undecided_time + done, ended, undecided_time);
            lanes_pack(worklist->in_contact_circling_ended_velocity_error + done, ended, velocity_error);
#endif
            lanes_pack(worklist->in_contact_circling_ended_vx + done, ended, vx);
            lanes_pack(worklist->in_contact_circling_ended_vy + done, ended, vy);
            lanes_pack(worklist->in_contact_circling_ended_vz + done, ended, vz);
            lanes_pack(worklist->in_contact_circling_ended_which + done, ended, which);
            lanes_pack(worklist->in_contact_circling_ended_wx + done, ended, wx);
            lanes_pack(worklist->in_contact_circling_ended_wy + done, ended, wy);
            lanes_pack(worklist->in_contact_circling_ended_wz + done, ended, wz);
            lanes_pack(worklist->in_contact_circling_ended_x + done, ended, x);
            lanes_pack(worklist->in_contact_circling_ended_y + done, ended, y);
            lanes_pack(worklist->in_contact_circling_ended_z + done, ended, z);
            done += popcount(ended);
            busy -= popcount(ended);
            active = lanes_both(active, lanes_not(ended));
        }
        for (size_t k = 0; k < done; k++) {
            const size_t row = (size_t)worklist->in_contact_circling_ended_row[k];
            EACH(RETURN, (in_contact_, in_contact_circling_ended_), circled, circling, clock)
            EACH(RETURN, (in_contact_, in_contact_circling_ended_), per_reach, rests, through, vx)
            EACH(RETURN, (in_contact_, in_contact_circling_ended_), vy, vz, which, wx, wy, wz, x, y)
            EACH(RETURN, (in_contact_, in_contact_circling_ended_), z)
            BOUNDS(EACH(RETURN, (in_contact_, in_contact_circling_ended_), dvx, dvy, dvz, dwx, dwy, dwz))
            BOUNDS(EACH(RETURN, (in_contact_, in_contact_circling_ended_), dx, dy, dz, earliest_delay))
            BOUNDS(EACH(RETURN, (in_contact_, in_contact_circling_ended_), grip_lost, last_grip_clock))
            BOUNDS(EACH(RETURN, (in_contact_, in_contact_circling_ended_), last_grip_deficit))
            BOUNDS(EACH(RETURN, (in_contact_, in_contact_circling_ended_), last_grip_deficit_rate))
            BOUNDS(EACH(RETURN, (in_contact_, in_contact_circling_ended_), position_error, undecided_time))
            BOUNDS(EACH(RETURN, (in_contact_, in_contact_circling_ended_), velocity_error))
        }
    }
    }
    {
    size_t in_contact_leaves_shots = 0;
    static const int in_contact_leaves_taken[] = {0, 5, 3, 4, 7, 6, 9, 8, 11, 10, 1, 2};
    for (size_t i = 0; i < in_contact_shots; i += LANES_WIDTH) {
        const M rows = mask_first_n(in_contact_shots - i);
        EACH(LOAD_MASK, in_contact_, circling, leaves, rolling)
        CALL(court_still_in_contact, _still_in_contact_1)(rolling, circling);
        EACH(SET, _still_in_contact_1, rolling)
        EACH(STORE_MASK, in_contact_, rolling)
        const M packed = lanes_both(rows, leaves);
        if (lanes_any(packed)) {
            EACH(LOAD, in_contact_, clock, gap_jerk, gap_snap, held, lift, per_reach, vx, vy, vz, x)
            EACH(LOAD, in_contact_, y, z)
            BOUNDS(EACH(LOAD, in_contact_, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz))
            BOUNDS(EACH(LOAD, in_contact_, estimated, undecided_time))
            BOUNDS(EACH(LOAD_SINGLE, in_contact_, clock_bound, position_bound, spin_bound, velocity_bound))
            lanes_pack(worklist->in_contact_leaves_row + in_contact_leaves_shots, packed, lanes_add(iota(), K((double)i)));
            EACH(PACK, in_contact_leaves_, clock, gap_jerk, gap_snap, held, lift, per_reach, vx, vy)
            EACH(PACK, in_contact_leaves_, vz, x, y, z)
            BOUNDS(EACH(PACK, in_contact_leaves_, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz))
            BOUNDS(EACH(PACK, in_contact_leaves_, estimated, undecided_time))
            BOUNDS(EACH(PACK_SINGLE, in_contact_leaves_, clock_bound, position_bound, spin_bound))
            BOUNDS(EACH(PACK_SINGLE, in_contact_leaves_, velocity_bound))
            if (LANES_SELDOM(varying)) {
                for (size_t _p = 0; _p < 12; _p++) {
                    lanes_pack(worklist->in_contact_leaves_parameters.columns[in_contact_leaves_taken[_p]] + in_contact_leaves_shots, packed, lanes_load(worklist->in_contact_parameters.columns[in_contact_leaves_taken[_p]] + i));
                }
            }
            in_contact_leaves_shots += popcount(packed);
        }
    }
    if (in_contact_leaves_shots) {
        EACH(CLEAR, in_contact_leaves_, row, clock, gap_jerk, gap_snap, held, lift, per_reach, vx)
        EACH(CLEAR, in_contact_leaves_, vy, vz, x, y, z)
        BOUNDS(EACH(CLEAR, in_contact_leaves_, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz))
        BOUNDS(EACH(CLEAR, in_contact_leaves_, estimated, undecided_time))
        BOUNDS(EACH(CLEAR_SINGLE, in_contact_leaves_, clock_bound, position_bound, spin_bound))
        BOUNDS(EACH(CLEAR_SINGLE, in_contact_leaves_, velocity_bound))
        if (LANES_SELDOM(varying)) {
            for (size_t _p = 0; _p < 12; _p++) {
                lanes_store(worklist->in_contact_leaves_parameters.columns[in_contact_leaves_taken[_p]] + in_contact_leaves_shots, K(0.0));
            }
        }
    }
    if (in_contact_leaves_shots)
        LOOP(leaves)(worklist, in_contact_leaves_shots, varying, time_limit);
    for (size_t k = 0; k < in_contact_leaves_shots; k++) {
        const size_t row = (size_t)worklist->in_contact_leaves_row[k];
        EACH(RETURN, (in_contact_, in_contact_leaves_), when, which)
        BOUNDS(EACH(RETURN, (in_contact_, in_contact_leaves_), position_error, undecided_time))
        BOUNDS(EACH(RETURN, (in_contact_, in_contact_leaves_), velocity_error))
    }
    }
}

#if BOUNDED
LANES_APART void LOOP(fix_rows_8)(LOOP(worklist) *worklist, size_t i)
#else
LANES_APART void LOOP(fix_rows_7)(LOOP(worklist) *worklist, size_t i)
#endif
{
    EACH(PARAMETER, , p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width)
    EACH(PARAMETER, , p_board_thickness, p_board_top, p_bridge_depth, p_bridge_half_width)
    EACH(PARAMETER, , p_gravity, p_inertia, p_restitution_speed, p_ring_radius)
    EACH(PARAMETER, , p_tangential_restitution, p_wire_radius)
    BOUNDS(EACH(PARAMETER, , p_end_depth))
    {
#if BOUNDED
        const V _s45 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s57 = lanes_div(K(1.0), p_gravity);
        const V _s333 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(p_ball_radius, p_ring_radius), p_wire_radius), p_board_distance), p_board_half_width), p_board_thickness), p_bridge_half_width);
        const V _s339 = lanes_sub(lanes_sub(p_ring_radius, p_ball_radius), p_wire_radius);
#endif
        const V _s346 = lanes_div(lanes_mul(p_inertia, lanes_add(K(1.0), p_tangential_restitution)), lanes_add(K(1.0), p_inertia));
        FIX(6, p_ball_radius); FIX(7, p_ring_radius); FIX(8, p_wire_radius);
        FIX(9, p_board_distance); FIX(10, p_board_half_width); FIX(11, p_board_bottom);
        FIX(12, p_board_top); FIX(13, p_bridge_half_width);
        FIX(15, lanes_add(p_board_distance, p_board_thickness));
        FIX(16, lanes_sub(p_wire_radius, p_bridge_depth));
        FIX(19, lanes_mul(p_ring_radius, p_ring_radius));
#if BOUNDED
        FIX(20, _s57);
#else
        FIX(20, lanes_div(K(1.0), p_gravity));
#endif
        FIX(21, p_gravity); FIX(22, lanes_mul(K(2.0), p_gravity));
        FIX(34, lanes_mul(K(0.5), p_gravity));
#if BOUNDED
        FIX(37, lanes_mul(K(4.0), p_gravity)); FIX(107, lanes_div(K(1.0), _s45));
#else
        FIX(107, lanes_div(K(1.0), lanes_add(p_ball_radius, p_wire_radius)));
#endif
        FIX(108, lanes_mul(K(0.5), p_ball_radius));
#if BOUNDED
        FIX(110, lanes_div(K(1.0), p_ball_radius)); FIX(160, lanes_mul(K(8.0), _s57));
        FIX(161, lanes_add(lanes_add(lanes_add(lanes_add(_s333, p_bridge_depth), p_end_depth), lanes_abs(p_board_bottom)), lanes_abs(p_board_top)));
        FIX(162, lanes_div(K(1.0), lanes_min(_s339, _s45)));
#endif
        FIX(163, p_restitution_speed); FIX(164, _s346); FIX(165, lanes_mul(_s346, _s346));
        FIX(166, lanes_mul(p_ball_radius, p_inertia));
#if BOUNDED
        FIX(167, lanes_mul(K(1.52587890625e-05), lanes_mul(p_ball_radius, p_gravity)));
#endif
        FIX(168, lanes_mul(K(7.275957614183426e-12), p_ball_radius));
        FIX(169, lanes_mul(K(1.1920928955078125e-07), p_ball_radius));
#if BOUNDED
    }
    {
        const S _p_ball_radius = lanes_narrow(p_ball_radius);
        const S _p_ring_radius = lanes_narrow(p_ring_radius);
        const S _p_wire_radius = lanes_narrow(p_wire_radius);
        const S _p_gravity = lanes_narrow(p_gravity);
        const S _p_board_distance = lanes_narrow(p_board_distance);
        const S _p_board_half_width = lanes_narrow(p_board_half_width);
        const S _p_board_bottom = lanes_narrow(p_board_bottom);
        const S _p_board_top = lanes_narrow(p_board_top);
        const S _p_board_thickness = lanes_narrow(p_board_thickness);
        const S _p_bridge_half_width = lanes_narrow(p_bridge_half_width);
        const S _p_bridge_depth = lanes_narrow(p_bridge_depth);
        const S _p_inertia = lanes_narrow(p_inertia);
        const S _p_tangential_restitution = lanes_narrow(p_tangential_restitution);
        const S _p_restitution_speed = lanes_narrow(p_restitution_speed);
        const S _s6 = singles_add(_p_ball_radius, _p_wire_radius);
        const S _s58 = singles_div(KS(1.0), _s6);
        const S _s60 = singles_sub(singles_sub(_p_ring_radius, _p_ball_radius), _p_wire_radius);
        const S _s61 = singles_min(_s60, _s6);
        const S _s69 = singles_mul(KS(2.0), singles_mul(_p_ring_radius, _s58));
        const S _s82 = singles_div(KS(1.0), _p_ball_radius);
        const S _s83 = singles_add(_p_board_distance, _p_board_thickness);
        const S _s95 = singles_mul(KS(9.5367431640625e-07), singles_add(singles_add(singles_add(singles_add(singles_mul(KS(2.0), _p_board_distance), singles_mul(KS(2.0), _p_board_half_width)), _p_board_thickness), singles_abs(_p_board_bottom)), singles_abs(_p_board_top)));
        const S _s114 = singles_mul(KS(9.5367431640625e-07), singles_add(singles_add(singles_add(singles_add(_p_ring_radius, singles_mul(KS(2.0), _p_wire_radius)), _p_board_distance), singles_mul(KS(2.0), _p_bridge_half_width)), _p_bridge_depth));
        const S _s124 = singles_div(singles_mul(_p_inertia, singles_add(KS(1.0), _p_tangential_restitution)), singles_add(KS(1.0), _p_inertia));
        FIX_SINGLE(0, _p_gravity); FIX_SINGLE(10, _s6); FIX_SINGLE(19, _p_ring_radius);
        FIX_SINGLE(20, singles_mul(KS(0.5), _p_gravity)); FIX_SINGLE(26, _s58);
        FIX_SINGLE(27, _s61); FIX_SINGLE(28, singles_div(KS(1.0), _s61));
        FIX_SINGLE(29, singles_mul(singles_sqrt(_p_gravity), singles_sqrt(_s6)));
        FIX_SINGLE(30, singles_mul(KS(1.1102230246251565e-16), singles_add(KS(16.0), _s69)));
        FIX_SINGLE(31, singles_mul(KS(3.5), _s6));
        FIX_SINGLE(32, singles_mul(KS(1.1102230246251565e-16), singles_add(KS(7.0), _s69)));
        FIX_SINGLE(33, _p_ball_radius); FIX_SINGLE(34, _p_board_distance);
        FIX_SINGLE(35, _p_board_half_width); FIX_SINGLE(36, _p_board_bottom);
        FIX_SINGLE(37, _p_board_top); FIX_SINGLE(38, _s82); FIX_SINGLE(39, _s83);
        FIX_SINGLE(40, singles_neg(_p_board_half_width));
        FIX_SINGLE(41, singles_neg(_p_board_distance)); FIX_SINGLE(42, singles_neg(_s83));
        FIX_SINGLE(43, _s95);
        FIX_SINGLE(44, singles_add(singles_mul(KS(2.220446049250313e-16), _p_board_distance), singles_mul(KS(2.220446049250313e-16), _p_board_thickness)));
        FIX_SINGLE(45, singles_mul(KS(8.881784197001252e-16), _p_ball_radius));
        FIX_SINGLE(46, singles_mul(KS(2.0), _s82)); FIX_SINGLE(47, _p_wire_radius);
        FIX_SINGLE(48, _p_bridge_half_width);
        FIX_SINGLE(49, singles_sub(_p_wire_radius, _p_bridge_depth));
        FIX_SINGLE(50, singles_neg(_p_bridge_half_width));
        FIX_SINGLE(51, singles_neg(_p_ring_radius)); FIX_SINGLE(52, _s114);
        FIX_SINGLE(53, singles_add(singles_mul(KS(1.1102230246251565e-16), _p_wire_radius), singles_mul(KS(2.220446049250313e-16), _p_bridge_depth)));
        FIX_SINGLE(54, _p_restitution_speed); FIX_SINGLE(55, _s124);
        FIX_SINGLE(56, singles_abs(KS(0.0)));
        FIX_SINGLE(57, singles_div(KS(1.0), _p_restitution_speed));
        FIX_SINGLE(58, singles_mul(KS(32.0), _s124)); FIX_SINGLE(59, singles_neg(_p_ball_radius));
        FIX_SINGLE(60, singles_div(KS(1.0), singles_mul(_p_ball_radius, _p_inertia)));
        FIX_SINGLE(61, singles_add(KS(1.0), singles_div(KS(1.0), _p_inertia)));
#endif
    }
}

LANES_APART void LOOP(fix_slow_rows_1)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, slow_, p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width)
    EACH(PARAMETER, slow_, p_board_thickness, p_board_top, p_bridge_depth, p_bridge_half_width)
    EACH(PARAMETER, slow_, p_end_depth, p_gravity, p_inertia, p_ring_radius, p_wire_radius)
    {
        const V _s227 = lanes_mul(K(1.4210854715202004e-14), p_ball_radius);
        const V _s232 = lanes_add(lanes_add(_s227, lanes_mul(K(2.842170943040401e-14), p_board_distance)), lanes_mul(K(1.4210854715202004e-14), p_board_thickness));
        const V _s235 = lanes_add(_s227, lanes_mul(K(2.842170943040401e-14), p_board_half_width));
        const V _s240 = lanes_add(lanes_add(_s227, lanes_mul(K(1.4210854715202004e-14), lanes_abs(p_board_bottom))), lanes_mul(K(1.4210854715202004e-14), lanes_abs(p_board_top)));
        const V _s245 = lanes_add(lanes_add(_s227, lanes_mul(K(1.4210854715202004e-14), p_ring_radius)), lanes_mul(K(1.4210854715202004e-14), p_board_distance));
        const V _s248 = lanes_add(_s227, lanes_mul(K(2.842170943040401e-14), p_bridge_half_width));
        const V _s255 = lanes_add(lanes_add(_s227, lanes_mul(K(1.4210854715202004e-14), p_wire_radius)), lanes_mul(K(1.4210854715202004e-14), lanes_abs(lanes_sub(p_bridge_depth, p_wire_radius))));
        FIX(6, p_ball_radius); FIX(7, p_ring_radius); FIX(8, p_wire_radius);
        FIX(9, p_board_distance); FIX(10, p_board_half_width); FIX(11, p_board_bottom);
        FIX(12, p_board_top); FIX(13, p_bridge_half_width);
        FIX(15, lanes_add(p_board_distance, p_board_thickness));
        FIX(16, lanes_sub(p_wire_radius, p_bridge_depth)); FIX(18, lanes_neg(p_end_depth));
        FIX(21, p_gravity); FIX(23, lanes_neg(p_gravity));
        FIX(107, lanes_div(K(1.0), lanes_add(p_ball_radius, p_wire_radius)));
        FIX(108, lanes_mul(K(0.5), p_ball_radius));
        FIX(109, lanes_mul(p_inertia, lanes_div(K(1.0), lanes_add(K(1.0), p_inertia))));
        FIX(110, lanes_div(K(1.0), p_ball_radius));
        FIX(111, lanes_mul(K(3.637978807091713e-12), p_ball_radius)); FIX(114, _s232);
        FIX(115, lanes_neg(_s232)); FIX(116, _s235); FIX(117, lanes_neg(_s235)); FIX(118, _s240);
        FIX(119, lanes_neg(_s240)); FIX(120, _s245); FIX(121, lanes_neg(_s245)); FIX(122, _s248);
        FIX(123, lanes_neg(_s248)); FIX(124, _s255); FIX(125, lanes_neg(_s255));
#if BOUNDED
        FIX(132, p_bridge_depth);
#endif
        FIX(156, lanes_mul(K(3.0), p_gravity));
        FIX(157, lanes_mul(K(2.0), lanes_mul(K(3.0), lanes_mul(p_gravity, p_gravity))));
        FIX(168, lanes_mul(K(7.275957614183426e-12), p_ball_radius));
        FIX(170, lanes_mul(K(3.725290298461914e-09), p_ball_radius));
    }
}

LANES_APART void LOOP(slow)(LOOP(worklist) *worklist, size_t slow_shots, size_t varying)
{
    for (size_t i = 0; i < slow_shots; i += LANES_WIDTH) {
        const M rows = mask_first_n(slow_shots - i);
        if (LANES_SELDOM(varying))
            LOOP(fix_slow_rows_1)(worklist, i);
        const V p_ring_friction = lanes_load(varying ? worklist->slow_parameters.p_ring_friction + i : worklist->parameters.p_ring_friction);
        const V p_ring_restitution = lanes_load(varying ? worklist->slow_parameters.p_ring_restitution + i : worklist->parameters.p_ring_restitution);
        EACH(LOAD, slow_, mode, vx, vy, vz, which, wx, wy, wz, x, y, z)
#if BOUNDED
        EACH(LOAD_SINGLE, slow_, clock_bound, position_bound, spin_bound, velocity_bound)
        EACH(LOAD, slow_, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, uncertain)
        CALL(court_estimates, _estimates_1)();
        EACH(GET, _estimates_1, estimated)
#endif
        CALL(court_ring_normal, _ring_normal_1)(x, y, z, FIXED(7), FIXED(107));
        EACH(GET, _ring_normal_1, nx, ny, nz)
        CALL(court_here, _here_1)(K(1.0), which);
        EACH(GET_MASK, _here_1, here)
        const M _if_here_1 = lanes_both(rows, here);
        if (lanes_any(_if_here_1)) {
            CALL(court_backboard_normal, _backboard_normal_1)(x, y, z, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(15), FIXED(108));
            EACH(SELECT, (_if_here_1, _backboard_normal_1), nx, ny, nz)
        }
        CALL(court_here, _here_2)(K(2.0), which);
        EACH(SET, _here_2, here)
        const M _if_here_2 = lanes_both(rows, here);
        if (lanes_any(_if_here_2)) {
            CALL(court_bridge_normal, _bridge_normal_1)(x, y, z, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(16), FIXED(108));
            EACH(SELECT, (_if_here_2, _bridge_normal_1), nx, ny, nz)
        }
        CALL(court_off_at_start, _off_at_start_1)(mode);
        EACH(GET_MASK, _off_at_start_1, put_on)
        const M _if_put_on_1 = lanes_both(rows, put_on);
        if (lanes_any(_if_put_on_1)) {
            CALL(court_ring_distance, _ring_distance_1)(x, y, z, FIXED(6), FIXED(7), FIXED(8));
            EACH(GET, _ring_distance_1, gap)
            CALL(court_here, _here_3)(K(1.0), which);
            EACH(GET_MASK, _here_3, here)
            const M _if_here_3 = lanes_both(_if_put_on_1, here);
            {
                CALL(court_backboard_distance, _backboard_distance_1)(x, y, z, FIXED(6), FIXED(11), FIXED(9), FIXED(10), FIXED(12), FIXED(15));
                EACH(SELECT, (_if_here_3, _backboard_distance_1), gap)
            }
            CALL(court_here, _here_4)(K(2.0), which);
            EACH(SET, _here_4, here)
            const M _if_here_4 = lanes_both(_if_put_on_1, here);
            {
                CALL(court_bridge_distance, _bridge_distance_1)(x, y, z, FIXED(6), FIXED(9), FIXED(13), FIXED(7), FIXED(8), FIXED(16));
                EACH(SELECT, (_if_here_4, _bridge_distance_1), gap)
            }
            CALL(court_placed_at_start, _placed_at_start_1)(x, y, z, nx, ny, nz, gap);
            EACH(SELECT, (_if_put_on_1, _placed_at_start_1), x, y, z)
#if BOUNDED
            CALL(court_start_errors, _start_errors_1)(x, y, z, dx, dy, dz, FIXED(6));
            EACH(SELECT, (_if_put_on_1, _start_errors_1), dx, dy, dz)
#endif
            CALL(court_ring_normal, _ring_normal_2)(x, y, z, FIXED(7), FIXED(107));
            EACH(SELECT, (_if_put_on_1, _ring_normal_2), nx, ny, nz)
            CALL(court_here, _here_5)(K(1.0), which);
            EACH(SET, _here_5, here)
            const M _if_here_5 = lanes_both(_if_put_on_1, here);
            if (lanes_any(_if_here_5)) {
                CALL(court_backboard_normal, _backboard_normal_2)(x, y, z, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(15), FIXED(108));
                EACH(SELECT, (_if_here_5, _backboard_normal_2), nx, ny, nz)
            }
            CALL(court_here, _here_6)(K(2.0), which);
            EACH(SET, _here_6, here)
            const M _if_here_6 = lanes_both(_if_put_on_1, here);
            if (lanes_any(_if_here_6)) {
                CALL(court_bridge_normal, _bridge_normal_2)(x, y, z, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(16), FIXED(108));
                EACH(SELECT, (_if_here_6, _bridge_normal_2), nx, ny, nz)
            }
#if BOUNDED
            CALL(court_undecided_at_start, _undecided_at_start_1)(x, y, z, nx, ny, nz, vx, vy, vz, wx, wy, wz, uncertain, FIXED(6));
            EACH(SELECT, (_if_put_on_1, _undecided_at_start_1), uncertain)
            CALL(court_start_velocity_errors, _start_velocity_errors_1)(x, y, z, vx, vy, vz, wx, wy, wz, dvx, dvy, dvz, FIXED(6));
            EACH(SELECT, (_if_put_on_1, _start_velocity_errors_1), dvx, dvy, dvz)
#endif
            CALL(court_velocity_at_start, _velocity_at_start_1)(x, y, z, nx, ny, nz, vx, vy, vz, wx, wy, wz, FIXED(6));
            EACH(SELECT, (_if_put_on_1, _velocity_at_start_1), vx, vy, vz)
            EACH(STORE, slow_, vx, vy, vz, x, y, z)
            BOUNDS(EACH(STORE, slow_, dvx, dvy, dvz, dx, dy, dz))
        }
        CALL(court_nearly, _nearly_1)(nx, ny, nz, vx, vy, vz, FIXED(6), FIXED(21), FIXED(168));
        EACH(GET_MASK, _nearly_1, nearly)
        CALL(court_gripped, _gripped_1)(nx, ny, nz, vx, vy, vz, wx, wy, wz, FIXED(6), FIXED(109));
        EACH(GET, _gripped_1, rolled_x, rolled_y, rolled_z, slip, bounce)
#if BOUNDED
        CALL(court_error_bounds, _error_bounds_1)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, lanes_wide(position_bound), lanes_wide(velocity_bound), lanes_wide(spin_bound), estimated, lanes_wide(clock_bound));
        EACH(GET, _error_bounds_1, position_error, velocity_error)
#endif
        CALL(court_ring_rolling_surface, _ring_rolling_surface_1)(FIXED(107));
        EACH(GET, _ring_rolling_surface_1, per_reach)
        CALL(court_ring_turning, _ring_turning_1)(x, y, rolled_x, rolled_y, rolled_z, FIXED(7), FIXED(107));
        EACH(GET, _ring_turning_1, turning_x, turning_y, turning_z)
        CALL(court_ring_separation, _ring_separation_1)(x, y, z, vx, vy, vz, FIXED(21), FIXED(7), FIXED(156), FIXED(157));
        EACH(GET, _ring_separation_1, lift, gap_jerk)
        CALL(court_here, _here_7)(K(1.0), which);
        EACH(SET, _here_7, here)
        const M _if_here_7 = lanes_both(rows, here);
        if (lanes_any(_if_here_7)) {
            CALL(court_backboard_rolling_surface, _backboard_rolling_surface_1)(x, y, z, vx, vy, vz, FIXED(11), FIXED(9), FIXED(10), FIXED(12), FIXED(114), FIXED(115), FIXED(15), FIXED(116), FIXED(117), FIXED(118), FIXED(119), FIXED(110));
            EACH(SELECT, (_if_here_7, _backboard_rolling_surface_1), per_reach)
            CALL(court_backboard_turning, _backboard_turning_1)(x, y, z, rolled_x, rolled_y, rolled_z, FIXED(11), FIXED(9), FIXED(10), FIXED(12), FIXED(15), FIXED(108));
            EACH(SELECT, (_if_here_7, _backboard_turning_1), turning_x, turning_y, turning_z)
            CALL(court_backboard_separation, _backboard_separation_1)(x, y, z, vx, vy, vz, FIXED(11), FIXED(9), FIXED(10), FIXED(12), FIXED(21), FIXED(15), FIXED(23));
            EACH(SELECT, (_if_here_7, _backboard_separation_1), lift, gap_jerk)
        }
        CALL(court_here, _here_8)(K(2.0), which);
        EACH(SET, _here_8, here)
        const M _if_here_8 = lanes_both(rows, here);
        if (lanes_any(_if_here_8)) {
            CALL(court_bridge_rolling_surface, _bridge_rolling_surface_1)(x, y, z, vx, vy, vz, FIXED(9), FIXED(13), FIXED(7), FIXED(8), FIXED(120), FIXED(121), FIXED(122), FIXED(123), FIXED(124), FIXED(125), FIXED(16), FIXED(110));
            EACH(SELECT, (_if_here_8, _bridge_rolling_surface_1), per_reach)
            CALL(court_bridge_turning, _bridge_turning_1)(x, y, z, rolled_x, rolled_y, rolled_z, FIXED(9), FIXED(13), FIXED(7), FIXED(8), FIXED(16), FIXED(108));
            EACH(SELECT, (_if_here_8, _bridge_turning_1), turning_x, turning_y, turning_z)
            CALL(court_bridge_separation, _bridge_separation_1)(x, y, z, vx, vy, vz, FIXED(9), FIXED(13), FIXED(21), FIXED(7), FIXED(8), FIXED(16), FIXED(23));
            EACH(SELECT, (_if_here_8, _bridge_separation_1), lift, gap_jerk)
        }
        CALL(court_pressed_on, _pressed_on_1)(nx, ny, nz, wx, wy, wz, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, FIXED(6), FIXED(21), FIXED(109));
        EACH(GET, _pressed_on_1, press, weight, rolling_friction, rolling_acceleration_x)
        EACH(GET, _pressed_on_1, rolling_acceleration_y, rolling_acceleration_z)
        CALL(court_isolated, _isolated_1)();
        EACH(GET, _isolated_1, nearest, second_contact_gap)
        CALL(court_other_surface, _other_surface_1)(K(0.0), which);
        EACH(GET_MASK, _other_surface_1, beside)
        const M _if_beside_1 = lanes_both(rows, beside);
        if (lanes_any(_if_beside_1)) {
            CALL(court_ring_closing, _ring_closing_1)(x, y, z, nx, ny, nz, rolled_x, rolled_y, rolled_z, rolling_acceleration_x, rolling_acceleration_y, rolling_acceleration_z, FIXED(6), FIXED(7), FIXED(8));
            EACH(GET, _ring_closing_1, gap, nearing, rolling_gap_acceleration, normal_cosine)
            CALL(court_near_body, _near_body_1)(gap, nearest, second_contact_gap, rolling_gap_acceleration, normal_cosine, press, nearing);
            EACH(SELECT, (_if_beside_1, _near_body_1), nearest, second_contact_gap)
        }
        CALL(court_other_surface, _other_surface_2)(K(1.0), which);
        EACH(SET, _other_surface_2, beside)
        const M _if_beside_2 = lanes_both(rows, beside);
        if (lanes_any(_if_beside_2)) {
            CALL(court_backboard_closing, _backboard_closing_1)(x, y, z, nx, ny, nz, rolled_x, rolled_y, rolled_z, rolling_acceleration_x, rolling_acceleration_y, rolling_acceleration_z, FIXED(6), FIXED(11), FIXED(9), FIXED(10), FIXED(12), FIXED(15));
            EACH(GET, _backboard_closing_1, gap, nearing, rolling_gap_acceleration, normal_cosine)
            CALL(court_near_body, _near_body_2)(gap, nearest, second_contact_gap, rolling_gap_acceleration, normal_cosine, press, nearing);
            EACH(SELECT, (_if_beside_2, _near_body_2), nearest, second_contact_gap)
        }
#if BOUNDED
        CALL(court_here, _here_9)(K(1.0), which);
        EACH(SET, _here_9, here)
        const M _if_here_9 = lanes_both(rows, here);
        if (lanes_any(_if_here_9)) {
            CALL(court_backboard_seam0, _backboard_seam0_1)(x, vx, FIXED(15), FIXED(114));
            EACH(GET, _backboard_seam0_1, gap)
            CALL(court_seam_undecided, _seam_undecided_1)(x, y, z, gap, position_error, uncertain, nearly, FIXED(6));
            EACH(SELECT, (_if_here_9, _seam_undecided_1), uncertain)
            CALL(court_backboard_seam1, _backboard_seam1_1)(x, vx, FIXED(9), FIXED(114));
            EACH(SET, _backboard_seam1_1, gap)
            CALL(court_seam_undecided, _seam_undecided_2)(x, y, z, gap, position_error, uncertain, nearly, FIXED(6));
            EACH(SELECT, (_if_here_9, _seam_undecided_2), uncertain)
            CALL(court_backboard_seam2, _backboard_seam2_1)(y, vy, FIXED(10), FIXED(116));
            EACH(SET, _backboard_seam2_1, gap)
            CALL(court_seam_undecided, _seam_undecided_3)(x, y, z, gap, position_error, uncertain, nearly, FIXED(6));
            EACH(SELECT, (_if_here_9, _seam_undecided_3), uncertain)
            CALL(court_backboard_seam3, _backboard_seam3_1)(y, vy, FIXED(10), FIXED(116));
            EACH(SET, _backboard_seam3_1, gap)
            CALL(court_seam_undecided, _seam_undecided_4)(x, y, z, gap, position_error, uncertain, nearly, FIXED(6));
            EACH(SELECT, (_if_here_9, _seam_undecided_4), uncertain)
            CALL(court_backboard_seam4, _backboard_seam4_1)(z, vz, FIXED(11), FIXED(118));
            EACH(SET, _backboard_seam4_1, gap)
            CALL(court_seam_undecided, _seam_undecided_5)(x, y, z, gap, position_error, uncertain, nearly, FIXED(6));
            EACH(SELECT, (_if_here_9, _seam_undecided_5), uncertain)
            CALL(court_backboard_seam5, _backboard_seam5_1)(z, vz, FIXED(12), FIXED(118));
            EACH(SET, _backboard_seam5_1, gap)
            CALL(court_seam_undecided, _seam_undecided_6)(x, y, z, gap, position_error, uncertain, nearly, FIXED(6));
            EACH(SELECT, (_if_here_9, _seam_undecided_6), uncertain)
        }
#endif
        CALL(court_other_surface, _other_surface_3)(K(2.0), which);
        EACH(SET, _other_surface_3, beside)
        const M _if_beside_3 = lanes_both(rows, beside);
        if (lanes_any(_if_beside_3)) {
            CALL(court_bridge_closing, _bridge_closing_1)(x, y, z, nx, ny, nz, rolled_x, rolled_y, rolled_z, rolling_acceleration_x, rolling_acceleration_y, rolling_acceleration_z, FIXED(6), FIXED(9), FIXED(13), FIXED(7), FIXED(8), FIXED(16));
            EACH(GET, _bridge_closing_1, gap, nearing, rolling_gap_acceleration, normal_cosine)
            CALL(court_near_body, _near_body_3)(gap, nearest, second_contact_gap, rolling_gap_acceleration, normal_cosine, press, nearing);
            EACH(SELECT, (_if_beside_3, _near_body_3), nearest, second_contact_gap)
        }
#if BOUNDED
        CALL(court_here, _here_10)(K(2.0), which);
        EACH(SET, _here_10, here)
        const M _if_here_10 = lanes_both(rows, here);
        if (lanes_any(_if_here_10)) {
            CALL(court_bridge_seam0, _bridge_seam0_1)(x, vx, FIXED(9), FIXED(120));
            EACH(GET, _bridge_seam0_1, gap)
            CALL(court_seam_undecided, _seam_undecided_7)(x, y, z, gap, position_error, uncertain, nearly, FIXED(6));
            EACH(SELECT, (_if_here_10, _seam_undecided_7), uncertain)
            CALL(court_bridge_seam1, _bridge_seam1_1)(x, vx, FIXED(7), FIXED(120));
            EACH(SET, _bridge_seam1_1, gap)
            CALL(court_seam_undecided, _seam_undecided_8)(x, y, z, gap, position_error, uncertain, nearly, FIXED(6));
            EACH(SELECT, (_if_here_10, _seam_undecided_8), uncertain)
            CALL(court_bridge_seam2, _bridge_seam2_1)(y, vy, FIXED(13), FIXED(122));
            EACH(SET, _bridge_seam2_1, gap)
            CALL(court_seam_undecided, _seam_undecided_9)(x, y, z, gap, position_error, uncertain, nearly, FIXED(6));
            EACH(SELECT, (_if_here_10, _seam_undecided_9), uncertain)
            CALL(court_bridge_seam3, _bridge_seam3_1)(y, vy, FIXED(13), FIXED(122));
            EACH(SET, _bridge_seam3_1, gap)
            CALL(court_seam_undecided, _seam_undecided_10)(x, y, z, gap, position_error, uncertain, nearly, FIXED(6));
            EACH(SELECT, (_if_here_10, _seam_undecided_10), uncertain)
            CALL(court_bridge_seam4, _bridge_seam4_1)(z, vz, FIXED(132), FIXED(8), FIXED(124));
            EACH(SET, _bridge_seam4_1, gap)
            CALL(court_seam_undecided, _seam_undecided_11)(x, y, z, gap, position_error, uncertain, nearly, FIXED(6));
            EACH(SELECT, (_if_here_10, _seam_undecided_11), uncertain)
            CALL(court_bridge_seam5, _bridge_seam5_1)(z, vz, FIXED(8), FIXED(124));
            EACH(SET, _bridge_seam5_1, gap)
            CALL(court_seam_undecided, _seam_undecided_12)(x, y, z, gap, position_error, uncertain, nearly, FIXED(6));
            EACH(SELECT, (_if_here_10, _seam_undecided_12), uncertain)
        }
#endif
        CALL(court_end_beside, _end_beside_1)(z, vz, FIXED(18));
        EACH(GET, _end_beside_1, gap)
        CALL(court_near_end_plane, _near_end_plane_1)(gap, nearest);
        EACH(SET, _near_end_plane_1, nearest)
        CALL(court_other_kind, _other_kind_1)();
        M struck_0 = _other_kind_1.of_this_kind;
        CALL(court_ring_impact_taken, _ring_impact_taken_1)(p_ring_restitution, p_ring_friction);
        V its_0_ring_impact = _ring_impact_taken_1.its_0;
        V its_1_ring_impact = _ring_impact_taken_1.its_1;
        {
#if BOUNDED
            static const int _t5[][2] = {
#else
            static const int _t3[][2] = {
#endif
                {15, 12},
                {16, 13},
                {17, 14},
            };
#if BOUNDED
            static const double _t6[][1] = {
#else
            static const double _t4[][1] = {
#endif
                {0.0},
                {1.0},
                {2.0},
            };
#if BOUNDED
            for (size_t _k3 = 0; _k3 < 3; _k3++) {
                const V own_1 = lanes_load((varying ? worklist->slow_parameters.columns[_t5[_k3][0]] : worklist->parameters.columns[_t5[_k3][0]]) + (i & varying));
                const V own_2 = lanes_load((varying ? worklist->slow_parameters.columns[_t5[_k3][1]] : worklist->parameters.columns[_t5[_k3][1]]) + (i & varying));
                const V own_index = K(_t6[_k3][0]);
                CALL(court_here, _here_11)(own_index, which);
                EACH(GET_MASK, _here_11, here)
                const M _if_here_11 = lanes_both(rows, here);
                if (lanes_any(_if_here_11)) {
#else
            for (size_t _k2 = 0; _k2 < 3; _k2++) {
                const V own_1 = lanes_load((varying ? worklist->slow_parameters.columns[_t3[_k2][0]] : worklist->parameters.columns[_t3[_k2][0]]) + (i & varying));
                const V own_2 = lanes_load((varying ? worklist->slow_parameters.columns[_t3[_k2][1]] : worklist->parameters.columns[_t3[_k2][1]]) + (i & varying));
                const V own_index = K(_t4[_k2][0]);
                CALL(court_here, _here_9)(own_index, which);
                EACH(GET_MASK, _here_9, here)
                const M _if_here_9 = lanes_both(rows, here);
                if (lanes_any(_if_here_9)) {
#endif
                    CALL(court_ring_impact_taken, _ring_impact_taken_2)(own_2, own_1);
#if BOUNDED
                    struck_0 = lanes_choose(_if_here_11, _ring_impact_taken_2.of_this_kind, struck_0);
                    its_0_ring_impact = lanes_select(_if_here_11, _ring_impact_taken_2.its_0, its_0_ring_impact);
                    its_1_ring_impact = lanes_select(_if_here_11, _ring_impact_taken_2.its_1, its_1_ring_impact);
#else
                    struck_0 = lanes_choose(_if_here_9, _ring_impact_taken_2.of_this_kind, struck_0);
                    its_0_ring_impact = lanes_select(_if_here_9, _ring_impact_taken_2.its_0, its_0_ring_impact);
                    its_1_ring_impact = lanes_select(_if_here_9, _ring_impact_taken_2.its_1, its_1_ring_impact);
#endif
                }
            }
        }
        const M _if_struck_0_1 = lanes_both(rows, struck_0);
        if (lanes_any(_if_struck_0_1)) {
            EACH(LOAD, slow_, held, outcome, slip_left)
            BOUNDS(EACH(LOAD, slow_, assured))
            CALL(court_ring_impact_settling, _ring_impact_settling_1)(its_1_ring_impact, its_0_ring_impact, x, y, z, nx, ny, nz, vx, vy, vz, wx, wy, wz, OR_ZERO(position_error), OR_ZERO(velocity_error), mode, per_reach, rolled_x, rolled_y, rolled_z, turning_x, turning_y, turning_z, slip, bounce, nearest, second_contact_gap, press, weight, rolling_friction, lift, gap_jerk, FIXED(6), FIXED(21), FIXED(109), FIXED(111), FIXED(170));
            EACH(GET_MASK, _ring_impact_settling_1, settles, lodges, slides, unpressed)
            BOUNDS(EACH(SELECT, (_if_struck_0_1, _ring_impact_settling_1), assured))
            EACH(GET_MASK, _ring_impact_settling_1, undecided)
            CALL(court_settled, _settled_1)(which, OR_ZERO(position_error), OR_ZERO(velocity_error), outcome, OR_ZERO(uncertain), undecided, mode, settles, nearly, lodges, slides, unpressed);
            EACH(SELECT, (_if_struck_0_1, _settled_1), mode, held, outcome, slip_left)
            BOUNDS(EACH(SELECT, (_if_struck_0_1, _settled_1), uncertain))
            EACH(STORE, slow_, held, mode, outcome, slip_left)
            BOUNDS(EACH(STORE, slow_, assured))
        }
#if BOUNDED
        EACH(STORE, slow_, estimated, uncertain)
    }
}

LANES_APART void LOOP(fix_rows_9)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, , p_gravity)
    {
        FIX(21, p_gravity); FIX(80, lanes_abs(K(0.0)));
    }
    {
        const S _p_gravity = lanes_narrow(p_gravity);
        FIX_SINGLE(0, _p_gravity); FIX_SINGLE(20, singles_mul(KS(0.5), _p_gravity));
#endif
    }
}

/* Take rows of lanes of shots that touch nothing from their release to their end, each row at once,
   without worklists. Return the first shot of the first row in which a shot may touch something. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static size_t LOOP(launch)(LOOP(worklist) *worklist, const court_job *job, size_t start, size_t past)
{
    const V most_contacts = K((double)job->max_contacts);
    const V time_limit = K(job->time_limit);
#if BOUNDED
    const V claims = K(job->results->event_errors ? 2.0 : job->results->time_error || job->results->state_error ? 1.0 : 0.0);
#endif

#if BOUNDED
    const V assured = K(0.0);
    const S clock_bound = KS(0.0);
    const V clock_error = K(0.0);
#endif
    const V count_0 = K(0.0);
    EACH(TURNING, , count_0)
    const V count_1 = K(0.0);
    EACH(TURNING, , count_1)
    const V count_2 = K(0.0);
    EACH(TURNING, , count_2)
#if BOUNDED
    const V dvx = K(0.0);
    const V dvy = K(0.0);
    const V dvz = K(0.0);
    const V dwx = K(0.0);
    const V dwy = K(0.0);
    const V dwz = K(0.0);
    const V dx = K(0.0);
    const V dy = K(0.0);
    const V dz = K(0.0);
    const V estimated = K(0.0);
    EACH(TURNING, , estimated)
#endif
    const V first = K(-1.0);
    EACH(TURNING, , first)
#if BOUNDED
    const V grip_lost = K(INFINITY);
    EACH(TURNING, , grip_lost)
#endif
    const V last = K(-1.0);
    const M permitted = lanes_less(K(0.0), lanes_load(worklist->permitted));
#if BOUNDED
    const S position_bound = KS(0.0);
#endif
    const V rolls = K(0.0);
    EACH(TURNING, , rolls)
    const V slip_left = K(0.0);
    EACH(TURNING, , slip_left)
#if BOUNDED
    const S spin_bound = KS(0.0);
    const S velocity_bound = KS(0.0);
#endif
    for (; start + LANES_WIDTH <= past; start += LANES_WIDTH) {
        LANES(court_ahead)(job, start + LANES_SHOTS, 1);
        const double *states = job->states + COURT_STATE * start;
        const V state_size = lanes_size(states, COURT_STATE);
        if (job->results->state)
            LOOP(load)(worklist, 0, states, COURT_STATE);
        else
            LOOP(load)(worklist, 0, states, 6);
        EACH(START_MASK, , refused)
        EACH(START, , clock, contacts)
        V vx = lanes_load(worklist->vx);
        V vy = lanes_load(worklist->vy);
        V vz = lanes_load(worklist->vz);
        V x = lanes_load(worklist->x);
        V y = lanes_load(worklist->y);
        V z = lanes_load(worklist->z);
        CALL(court_state_in_range, _state_in_range_1)(state_size, state_size, state_size, state_size, state_size, state_size, state_size, state_size, state_size);
        EACH(GET_MASK, _state_in_range_1, in_range)
        CALL(court_aside, _aside_1)(x, y, z, FIXED(0), FIXED(1), FIXED(2), FIXED(3), FIXED(4), FIXED(5));
        EACH(GET_MASK, _aside_1, close)
        EACH(GET, _aside_1, valid)
        BOUNDS(EACH(GET, _aside_1, undecided_time))
        const M _if_close_1 = close;
        if (lanes_any(_if_close_1)) {
            CALL(court_valid, _valid_1)(last, x, y, z, FIXED(6), FIXED(7), FIXED(8), FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(13), FIXED(14), FIXED(15), FIXED(16), FIXED(17), FIXED(0));
            EACH(SELECT, (_if_close_1, _valid_1), valid)
            BOUNDS(EACH(SELECT, (_if_close_1, _valid_1), undecided_time))
        }
#if BOUNDED
        CALL(court_admitted, _admitted_1)(undecided_time, valid, permitted, in_range);
#else
        CALL(court_admitted, _admitted_1)(K(INFINITY), valid, permitted, in_range);
#endif
        EACH(GET, _admitted_1, outcome)
        BOUNDS(EACH(GET, _admitted_1, uncertain))
        CALL(court_started_on_surface, _started_on_surface_1)(last);
        EACH(GET, _started_on_surface_1, mode)
        CALL(court_passing_start, _passing_start_1)(last, outcome, OR_ZERO(uncertain), x, y, z, FIXED(18), FIXED(19));
        EACH(GET, _passing_start_1, through)
        BOUNDS(EACH(SET, _passing_start_1, uncertain))
        refused = lanes_either(refused, lanes_at_most(K(0.0), outcome));
#if BOUNDED
        CALL(court_error_bounds, _error_bounds_1)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, lanes_wide(position_bound), lanes_wide(velocity_bound), lanes_wide(spin_bound), estimated, lanes_wide(clock_bound));
#else
        CALL(court_error_bounds, _error_bounds_1)(K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0));
#endif
        EACH(GET, _error_bounds_1, time_error)
        BOUNDS(EACH(GET, _error_bounds_1, position_error, velocity_error))
        CALL(court_scale, _scale_1)(x, y, z, vx, vy, vz, FIXED(20));
        EACH(GET, _scale_1, extent, speed, excess)
        CALL(court_opening, _opening_1)(excess, OR_ZERO(position_error), OR_ZERO(velocity_error));
        EACH(GET, _opening_1, when, which)
        BOUNDS(EACH(GET, _opening_1, earliest_delay))
        BOUNDS(EACH(SET, _opening_1, undecided_time))
        CALL(court_limited, _limited_1)(time_limit);
        EACH(GET_MASK, _limited_1, limited)
        CALL(court_in_contact, _in_contact_1)(when, mode);
        EACH(GET_MASK, _in_contact_1, in_contact)
        EACH(SET, _in_contact_1, when)
        CALL(court_left, _left_1)(K(3.0), last);
        EACH(GET, _left_1, leaving)
        CALL(court_end_arrival, _end_arrival_1)(leaving, z, vz, FIXED(21), FIXED(18), FIXED(22), FIXED(23), FIXED(24), FIXED(25));
        EACH(GET, _end_arrival_1, time, rate, bend, apex)
        BOUNDS(EACH(GET, _end_arrival_1, height))
        CALL(court_plane_root, _plane_root_1)(rate, bend, apex, time);
        EACH(GET_MASK, _plane_root_1, arrives)
#if BOUNDED
        EACH(GET, _plane_root_1, ceiling, nearest)
        CALL(court_end_margin, _end_margin_1)(nearest, extent, speed, position_error, velocity_error, FIXED(21), FIXED(26));
        EACH(GET, _end_margin_1, margin)
        CALL(court_crossing, _crossing_1)(margin, K(0.0), rate, ceiling);
        EACH(GET, _crossing_1, clearance, delay)
#endif
        CALL(court_within_time, _within_time_1)(time, when, OR_ZERO(delay), OR_ZERO(earliest_delay), arrives);
        EACH(GET_MASK, _within_time_1, possible)
#if BOUNDED
        CALL(court_apex_undecided, _apex_undecided_1)(margin, apex, height, undecided_time);
        EACH(SET, _apex_undecided_1, undecided_time)
#endif
        const M _if_possible_1 = possible;
        {
#if BOUNDED
            CALL(court_crossing_undecided, _crossing_undecided_1)(clearance, time, undecided_time, arrives);
            EACH(SELECT, (_if_possible_1, _crossing_undecided_1), undecided_time)
            CALL(court_tie_undecided, _tie_undecided_1)(time, when, delay, earliest_delay, undecided_time, arrives);
            EACH(SELECT, (_if_possible_1, _tie_undecided_1), undecided_time, earliest_delay)
#endif
            CALL(court_earliest, _earliest_1)(K(3.0), time, when, which, arrives);
            EACH(SELECT, (_if_possible_1, _earliest_1), when, which)
        }
#if BOUNDED
        CALL(court_plane_start, _plane_start_1)(undecided_time, position_error, velocity_error, FIXED(27));
        EACH(SET, _plane_start_1, undecided_time)
#endif
        CALL(court_horizon, _horizon_1)(when, speed, FIXED(20));
        V until = _horizon_1.horizon;
#if BOUNDED
        EACH(GET, _horizon_1, pad)
        CALL(court_overdue, _overdue_1)(pad, earliest_delay, undecided_time);
        EACH(SET, _overdue_1, undecided_time)
#endif
        CALL(court_missed, _missed_1)();
        EACH(GET, _missed_1, clear)
#if BOUNDED
        CALL(court_ring_drops_through, _ring_drops_through_1)(lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(until), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(position_error), lanes_narrow(velocity_error), FIXED_SINGLE(0), FIXED_SINGLE(62), FIXED_SINGLE(3), FIXED_SINGLE(63), FIXED_SINGLE(20), FIXED_SINGLE(64), FIXED_SINGLE(65), FIXED_SINGLE(66), FIXED_SINGLE(67), FIXED_SINGLE(68));
#else
        CALL(court_ring_drops_through, _ring_drops_through_1)(lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(until), lanes_narrow(extent), lanes_narrow(speed), KS(0.0), KS(0.0), FIXED_SINGLE(0), FIXED_SINGLE(62), FIXED_SINGLE(3), FIXED_SINGLE(63), FIXED_SINGLE(20), FIXED_SINGLE(64), FIXED_SINGLE(65), FIXED_SINGLE(66), FIXED_SINGLE(67), FIXED_SINGLE(68));
#endif
        EACH(GET_MASK, _ring_drops_through_1, unproved)
        const M _if_unproved_1 = unproved;
        if (lanes_any(_if_unproved_1)) {
            CALL(court_ring_clear, _ring_clear_1)(until, x, y, z, vx, vy, vz, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), FIXED(7), FIXED(21), FIXED(28), FIXED(29), FIXED(30), FIXED(31), FIXED(32), FIXED(33), FIXED(22), FIXED(20), FIXED(34), FIXED(14), FIXED(35), FIXED(36), FIXED(37), FIXED(38), FIXED(39), FIXED(40), FIXED(41), FIXED(42));
            EACH(SELECT, (_if_unproved_1, _ring_clear_1), clear)
        }
        CALL(court_opens_in_flight, _opens_in_flight_1)(clear, in_contact);
        EACH(GET_MASK, _opens_in_flight_1, open)
        refused = lanes_either(refused, open);
        CALL(court_horizon, _horizon_2)(when, speed, FIXED(20));
        until = _horizon_2.horizon;
#if BOUNDED
        EACH(SET, _horizon_2, pad)
#else
        EACH(GET, _horizon_2, pad)
#endif
        CALL(court_backboard_near, _backboard_near_1)(until, x, vx, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), OR_ZERO(earliest_delay), pad, FIXED(21), FIXED(54), FIXED(55));
        M reachable = _backboard_near_1.near;
        const M _if_reachable_1 = reachable;
        if (lanes_any(_if_reachable_1)) {
            CALL(court_left, _left_2)(K(1.0), last);
            EACH(GET, _left_2, leaving)
            CALL(court_backboard_approaches, _backboard_approaches_1)(leaving, until, x, y, z, vx, vy, vz, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), OR_ZERO(earliest_delay), pad, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(21), FIXED(56), FIXED(15));
            reachable = lanes_choose(_if_reachable_1, _backboard_approaches_1.near, reachable);
        }
        CALL(court_reachable_in_flight, _reachable_in_flight_1)(reachable, in_contact);
        EACH(SET, _reachable_in_flight_1, reachable)
        refused = lanes_either(refused, reachable);
        CALL(court_horizon, _horizon_3)(when, speed, FIXED(20));
        until = _horizon_3.horizon;
        EACH(SET, _horizon_3, pad)
        CALL(court_half_flight_boxes, _half_flight_boxes_1)(until, x, y, z, vx, vy, vz, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), OR_ZERO(earliest_delay), pad, FIXED(21), FIXED(80), FIXED(34), FIXED(81));
        EACH(GET, _half_flight_boxes_1, middle_x, reach_x, later_middle_x, later_reach_x, middle_y)
        EACH(GET, _half_flight_boxes_1, reach_y, later_middle_y, later_reach_y, middle_z, reach_z)
        EACH(GET, _half_flight_boxes_1, later_middle_z, later_reach_z)
        CALL(court_bridge_near, _bridge_near_1)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, later_middle_x, later_middle_y, later_middle_z, later_reach_x, later_reach_y, later_reach_z, FIXED(82), FIXED(4), FIXED(83), FIXED(84), FIXED(85), FIXED(86));
        reachable = _bridge_near_1.near;
        EACH(GET_MASK, _bridge_near_1, first_near, later_near)
        const M _if_reachable_2 = reachable;
        if (lanes_any(_if_reachable_2)) {
            CALL(court_left, _left_3)(K(2.0), last);
            EACH(GET, _left_3, leaving)
            CALL(court_bridge_approaches, _bridge_approaches_1)(leaving, until, x, y, z, vx, vy, vz, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), OR_ZERO(earliest_delay), pad, first_near, later_near, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(21), FIXED(56), FIXED(16));
            reachable = lanes_choose(_if_reachable_2, _bridge_approaches_1.near, reachable);
        }
        CALL(court_reachable_in_flight, _reachable_in_flight_2)(reachable, in_contact);
        EACH(SET, _reachable_in_flight_2, reachable)
        refused = lanes_either(refused, reachable);
        const M _if_limited_1 = limited;
        if (lanes_any(_if_limited_1)) {
            CALL(court_expiry, _expiry_1)(when, which, OR_ZERO(earliest_delay), OR_INFINITE(undecided_time), time_error, clock, time_limit);
            EACH(GET, _expiry_1, time)
            EACH(GET_MASK, _expiry_1, arrives)
#if BOUNDED
            EACH(GET, _expiry_1, delay)
            EACH(SELECT, (_if_limited_1, _expiry_1), undecided_time)
            CALL(court_tie_undecided, _tie_undecided_2)(time, when, delay, earliest_delay, undecided_time, arrives);
            EACH(SELECT, (_if_limited_1, _tie_undecided_2), undecided_time, earliest_delay)
#endif
            CALL(court_earliest, _earliest_2)(K(4.0), time, when, which, arrives);
            EACH(SELECT, (_if_limited_1, _earliest_2), when, which)
        }
        refused = lanes_either(refused, in_contact);
        CALL(court_departed, _departed_1)(K(3.0), which);
        EACH(GET_MASK, _departed_1, moves, ends, touches)
        EACH(GET, _departed_1, reached)
        BOUNDS(EACH(GET_MASK, _departed_1, edge))
        CALL(court_body_of, _body_of_1)(which);
        EACH(GET, _body_of_1, body)
        refused = lanes_either(refused, in_contact);
        const M _if_moves_1 = moves;
        if (lanes_any(_if_moves_1)) {
#if BOUNDED
            CALL(court_passing_undecided, _passing_undecided_1)(when, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, FIXED(7), FIXED(21), FIXED(34), FIXED(20), FIXED(22), FIXED(37), FIXED(160));
            EACH(GET_MASK, _passing_undecided_1, undecided)
            CALL(court_undecided, _undecided_1)(uncertain, undecided);
            EACH(SELECT, (_if_moves_1, _undecided_1), uncertain)
#endif
            CALL(court_passing, _passing_1)(through, when, x, y, z, vx, vy, vz, FIXED(21), FIXED(34), FIXED(22), FIXED(20), FIXED(19));
            EACH(SELECT, (_if_moves_1, _passing_1), through)
            CALL(court_flight, _flight_1)(when, x, y, z, vx, vy, vz, FIXED(21), FIXED(34));
            EACH(SELECT, (_if_moves_1, _flight_1), x, y, z, vx, vy, vz)
            CALL(court_event_clock, _event_clock_1)(when, clock);
            EACH(SELECT, (_if_moves_1, _event_clock_1), clock)
        }
        const M _if_limited_2 = limited;
        if (lanes_any(_if_limited_2)) {
            CALL(court_expired, _expired_1)(K(4.0), which, body, clock, reached, time_limit, ends);
            EACH(SELECT, (_if_limited_2, _expired_1), clock, reached)
            EACH(SELECT_MASK, (_if_limited_2, _expired_1), ends)
        }
#if BOUNDED
        CALL(court_no_departure, _no_departure_1)();
        EACH(GET_MASK, _no_departure_1, hopped)
#endif
        refused = lanes_either(refused, in_contact);
#if BOUNDED
        CALL(court_displacement, _displacement_1)(earliest_delay, when, extent, speed, position_error, velocity_error, FIXED(21), FIXED(161));
        V slack = _displacement_1.margin;
#endif
        CALL(court_here, _here_1)(K(3.0), which);
        EACH(GET_MASK, _here_1, here)
        const M _if_here_1 = here;
        {
            CALL(court_end_bounds, _end_bounds_1)(x, y, FIXED(7));
            EACH(GET, _end_bounds_1, g0)
            CALL(court_end_reached, _end_reached_1)(through, g0);
            EACH(SELECT, (_if_here_1, _end_reached_1), reached)
#if BOUNDED
            CALL(court_end_edge, _end_edge_1)(slack, through, g0);
            EACH(SELECT_MASK, (_if_here_1, _end_edge_1), edge)
#endif
        }
#if BOUNDED
        CALL(court_contact_undecided, _contact_undecided_1)(last, when, which, earliest_delay, undecided_time, position_error, velocity_error, uncertain, edge, assured);
        EACH(SET, _contact_undecided_1, uncertain)
#endif
        CALL(court_accounted, _accounted_1)(contacts, most_contacts, reached, touches);
        EACH(SET, _accounted_1, contacts, outcome)
#if BOUNDED
        CALL(court_meeting, _meeting_1)(claims, ends, touches);
#else
        CALL(court_meeting, _meeting_1)(K(0.0), ends, touches);
#endif
        EACH(GET_MASK, _meeting_1, meeting)
        CALL(court_slow_at_start, _slow_at_start_1)(mode);
        EACH(GET_MASK, _slow_at_start_1, slow)
        refused = lanes_either(refused, meeting);
        refused = lanes_either(refused, slow);
#if BOUNDED
        refused = lanes_either(refused, limited);
        refused = lanes_either(refused, hopped);
        CALL(court_closing, _closing_1)(outcome, claims);
        EACH(GET_MASK, _closing_1, reports)
        EACH(GET, _closing_1, position_claim, velocity_claim, spin_claim, time_claim)
        const M _if_reports_1 = reports;
        if (lanes_any(_if_reports_1)) {
            CALL(court_claimed_errors, _claimed_errors_1)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, lanes_wide(position_bound), lanes_wide(velocity_bound), lanes_wide(spin_bound), estimated, lanes_wide(clock_bound));
            position_claim = lanes_select(_if_reports_1, _claimed_errors_1.position_error, position_claim);
            velocity_claim = lanes_select(_if_reports_1, _claimed_errors_1.velocity_error, velocity_claim);
            spin_claim = lanes_select(_if_reports_1, _claimed_errors_1.spin_error, spin_claim);
            time_claim = lanes_select(_if_reports_1, _claimed_errors_1.time_error, time_claim);
        }
#endif
        refused = lanes_either(refused, lanes_less(outcome, K(0.0)));
        EACH(TURNING, , clock, contacts, outcome)
        BOUNDS(EACH(TURNING, , position_claim, spin_claim, time_claim, uncertain, velocity_claim))
        if (job->results->state) {
            EACH(TURNING, , vx, vy, vz, x, y, z)
        }
        if (lanes_any(refused))
            break;
        worklist->shot[0] = (double)start;
        LOOP(reset)(job, start, LANES_WIDTH);
        LOOP(finish_all)(worklist, LANES_WIDTH, job);
    }
    return start;
}

/* Run the job: fill the rows, take every shot to its next event, make room of those that ended. */
static void LOOP(run)(const court_job *job, LOOP(worklist) *const restrict worklist)
{
    const V most_contacts = K((double)job->max_contacts);
    const V time_limit = K(job->time_limit);
#if BOUNDED
    const V claims = K(job->results->event_errors ? 2.0 : job->results->time_error || job->results->state_error ? 1.0 : 0.0);
#endif

    const size_t varying = job->varying ? ~(size_t)0 : 0;
    int recording = job->results->events != NULL;
    size_t begun = 0, end = 0, shots = 0;
    const int launching = !job->varying && !job->leaving && !recording;
    size_t paused = 0, pause = 0; /* no shot before this one is launched, after one that was refused */
    int streams = 0; /* whether the shots before ended all at once: then those to come will, too */

    worklist->waiting = 0;
    if (job->shots == 0)
        return;
    for (int p = 0; p < COURT_PARAMETERS; p++)
        lanes_store(worklist->parameters.columns[p], K(*job->parameters[p]));
    LOOP(permitted)(worklist, 0);
    LOOP(fix)(worklist);
    for (;;) {
        if (stopped(job))
            return;
        if (begun == end && end < job->shots)
            begun = court_take(job, &end);
        if (launching && shots == 0 && begun < end && begun >= paused) {
            const size_t from = begun, past = end - from < LANES_LAUNCHED ? end : from + LANES_LAUNCHED;
            begun = LOOP(launch)(worklist, job, from, past);
            if (begun == past)
                continue;
            pause = begun > from || pause == 0 ? 2 * LANES_SHOTS : 2 * pause;
            paused = begun + pause;
        }
        int following = shots == 0;
        if (worklist->waiting + LANES_WIDTH > LANES_SHOTS || (shots == 0 && begun == end)) {
            shots += LOOP(resume)(worklist, shots, job);
            following = 0;
        }
        const size_t fresh = shots;
        if (begun < end && shots < LANES_SHOTS) {
            const size_t room = LANES_SHOTS - shots, left = end - begun;
            shots += left < room ? left : room;
            LOOP(begin)(worklist, fresh, shots - fresh, job, begun);
            begun += shots - fresh;
        }
        if (shots == 0)
            return;

        /* A new shot is looked at once. */
        for (size_t i = fresh; i < shots; i += LANES_WIDTH) {
            const M rows = mask_first_n(shots - i);
            if (LANES_SELDOM(varying))
                LOOP(fix_rows_1)(worklist, i);
            EACH(LOAD, , last, vx, vy, vz, wx, wy, wz, x, y, z)
            M permitted = lanes_less(K(0.0), lanes_load(worklist->permitted + (i & varying)));
            CALL(court_state_in_range, _state_in_range_1)(x, y, z, vx, vy, vz, wx, wy, wz);
            EACH(GET_MASK, _state_in_range_1, in_range)
            CALL(court_aside, _aside_1)(x, y, z, FIXED(0), FIXED(1), FIXED(2), FIXED(3), FIXED(4), FIXED(5));
            EACH(GET_MASK, _aside_1, close)
            EACH(GET, _aside_1, valid)
            BOUNDS(EACH(GET, _aside_1, undecided_time))
            const M _if_close_1 = lanes_both(rows, close);
            if (lanes_any(_if_close_1)) {
                CALL(court_valid, _valid_1)(last, x, y, z, FIXED(6), FIXED(7), FIXED(8), FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(13), FIXED(14), FIXED(15), FIXED(16), FIXED(17), FIXED(0));
                EACH(SELECT, (_if_close_1, _valid_1), valid)
                BOUNDS(EACH(SELECT, (_if_close_1, _valid_1), undecided_time))
            }
#if BOUNDED
            CALL(court_admitted, _admitted_1)(undecided_time, valid, permitted, in_range);
#else
            CALL(court_admitted, _admitted_1)(K(INFINITY), valid, permitted, in_range);
#endif
            EACH(GET, _admitted_1, outcome)
            BOUNDS(EACH(GET, _admitted_1, uncertain))
            CALL(court_started_on_surface, _started_on_surface_1)(last);
            EACH(GET, _started_on_surface_1, mode)
            CALL(court_passing_start, _passing_start_1)(last, outcome, OR_ZERO(uncertain), x, y, z, FIXED(18), FIXED(19));
            EACH(GET, _passing_start_1, through)
            BOUNDS(EACH(SET, _passing_start_1, uncertain))
            EACH(STORE, , mode, outcome, through)
            BOUNDS(EACH(STORE, , uncertain))
        }

        M refused = mask_none();
        for (size_t i = fresh; i < shots; i += LANES_WIDTH)
            refused = lanes_either(refused, lanes_both(mask_first_n(shots - i), lanes_at_most(K(0.0), lanes_load(worklist->outcome + i))));
        if (lanes_any(refused)) {
            shots = LOOP(leave)(worklist, fresh, shots, job);
            following = 0;
        }

        /* To the next event, and what it does to the ball. */
        {
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = mask_first_n(shots - i);
            LANES(court_ahead)(job, begun + i, streams);
            if (LANES_SELDOM(varying))
                LOOP(fix_rows_2)(worklist, i);
            EACH(LOAD, , last, mode, vx, vy, vz, x, y, z)
#if BOUNDED
            EACH(LOAD_SINGLE, , clock_bound, position_bound, spin_bound, velocity_bound)
            EACH(LOAD, , clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, estimated)
            CALL(court_error_bounds, _error_bounds_1)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, lanes_wide(position_bound), lanes_wide(velocity_bound), lanes_wide(spin_bound), estimated, lanes_wide(clock_bound));
#else
            CALL(court_error_bounds, _error_bounds_1)(K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0), K(0.0));
#endif
            EACH(GET, _error_bounds_1, time_error)
            BOUNDS(EACH(GET, _error_bounds_1, position_error, velocity_error))
            CALL(court_scale, _scale_1)(x, y, z, vx, vy, vz, FIXED(20));
            EACH(GET, _scale_1, extent, speed, excess)
            CALL(court_opening, _opening_1)(excess, OR_ZERO(position_error), OR_ZERO(velocity_error));
            EACH(GET, _opening_1, when, which)
            BOUNDS(EACH(GET, _opening_1, earliest_delay, undecided_time))
            CALL(court_limited, _limited_1)(time_limit);
            EACH(GET_MASK, _limited_1, limited)
            CALL(court_in_contact, _in_contact_1)(when, mode);
            EACH(GET_MASK, _in_contact_1, in_contact, rests, rolling)
            EACH(SET, _in_contact_1, when)
            EACH(GET, _in_contact_1, began)
            CALL(court_left, _left_1)(K(3.0), last);
            EACH(GET, _left_1, leaving)
            CALL(court_end_arrival, _end_arrival_1)(leaving, z, vz, FIXED(21), FIXED(18), FIXED(22), FIXED(23), FIXED(24), FIXED(25));
            EACH(GET, _end_arrival_1, time, rate, bend, apex)
            BOUNDS(EACH(GET, _end_arrival_1, height))
            CALL(court_plane_root, _plane_root_1)(rate, bend, apex, time);
            EACH(GET_MASK, _plane_root_1, arrives)
#if BOUNDED
            EACH(GET, _plane_root_1, ceiling, nearest)
            CALL(court_end_margin, _end_margin_1)(nearest, extent, speed, position_error, velocity_error, FIXED(21), FIXED(26));
            EACH(GET, _end_margin_1, margin)
            CALL(court_crossing, _crossing_1)(margin, K(0.0), rate, ceiling);
            EACH(GET, _crossing_1, clearance, delay)
#endif
            CALL(court_within_time, _within_time_1)(time, when, OR_ZERO(delay), OR_ZERO(earliest_delay), arrives);
            EACH(GET_MASK, _within_time_1, possible)
#if BOUNDED
            CALL(court_apex_undecided, _apex_undecided_1)(margin, apex, height, undecided_time);
            EACH(SET, _apex_undecided_1, undecided_time)
#endif
            const M _if_possible_1 = lanes_both(rows, possible);
            {
#if BOUNDED
                CALL(court_crossing_undecided, _crossing_undecided_1)(clearance, time, undecided_time, arrives);
                EACH(SELECT, (_if_possible_1, _crossing_undecided_1), undecided_time)
                CALL(court_tie_undecided, _tie_undecided_1)(time, when, delay, earliest_delay, undecided_time, arrives);
                EACH(SELECT, (_if_possible_1, _tie_undecided_1), undecided_time, earliest_delay)
#endif
                CALL(court_earliest, _earliest_1)(K(3.0), time, when, which, arrives);
                EACH(SELECT, (_if_possible_1, _earliest_1), when, which)
            }
#if BOUNDED
            CALL(court_plane_start, _plane_start_1)(undecided_time, position_error, velocity_error, FIXED(27));
            EACH(SET, _plane_start_1, undecided_time)
#endif
            CALL(court_horizon, _horizon_1)(when, speed, FIXED(20));
            V until = _horizon_1.horizon;
#if BOUNDED
            EACH(GET, _horizon_1, pad)
            CALL(court_overdue, _overdue_1)(pad, earliest_delay, undecided_time);
            EACH(SET, _overdue_1, undecided_time)
#endif
            CALL(court_ring_clear, _ring_clear_1)(until, x, y, z, vx, vy, vz, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), FIXED(7), FIXED(21), FIXED(28), FIXED(29), FIXED(30), FIXED(31), FIXED(32), FIXED(33), FIXED(22), FIXED(20), FIXED(34), FIXED(14), FIXED(35), FIXED(36), FIXED(37), FIXED(38), FIXED(39), FIXED(40), FIXED(41), FIXED(42));
            EACH(GET, _ring_clear_1, clear)
            CALL(court_opens_in_flight, _opens_in_flight_1)(clear, in_contact);
            EACH(GET_MASK, _opens_in_flight_1, open)
            EACH(STORE, , began, extent, speed, time_error, until, when, which)
            EACH(STORE_MASK, , in_contact, limited, open, rests, rolling)
            BOUNDS(EACH(STORE, , earliest_delay, pad, position_error, undecided_time, velocity_error))
        }
        {
        size_t stepping_shots = 0;
        static const int stepping_taken[] = {0, 10, 1, 2};
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_both(mask_first_n(shots - i), lanes_less(K(0.0), lanes_load(worklist->open + i)));
            if (lanes_any(rows)) {
                if (LANES_SELDOM(varying))
                    LOOP(fix_rows_3)(worklist, i);
                EACH(LOAD, , extent, last, speed, until, vx, vy, vz, x, y, z)
                BOUNDS(EACH(LOAD, , earliest_delay, pad, position_error, undecided_time, velocity_error))
                CALL(court_beginning, _beginning_1)();
                EACH(GET, _beginning_1, share, arrival)
                EACH(GET_MASK, _beginning_1, certain)
                CALL(court_left, _left_1)(K(0.0), last);
                EACH(GET, _left_1, leaving)
                CALL(court_ring_opened, _ring_opened_1)(lanes_narrow(until), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(extent), lanes_narrow(speed), FIXED_SINGLE(0), FIXED_SINGLE(1), FIXED_SINGLE(2), FIXED_SINGLE(3), FIXED_SINGLE(4), FIXED_SINGLE(5), FIXED_SINGLE(6), FIXED_SINGLE(7), FIXED_SINGLE(8), FIXED_SINGLE(9));
                S onset = _ring_opened_1.t;
                S wide_end = _ring_opened_1.end;
                EACH(GET_MASK, _ring_opened_1, searching)
                S wide_low1 = _ring_opened_1.low1;
                S wide_high1 = _ring_opened_1.high1;
                S wide_low2 = _ring_opened_1.low2;
                S wide_high2 = _ring_opened_1.high2;
                S lapsed = _ring_opened_1.latest;
                EACH(GET_MASK, _ring_opened_1, representable)
                CALL(court_opened, _opened_1)(lanes_wide(lapsed), lanes_wide(onset));
                V since = _opened_1.time;
                BOUNDS(EACH(GET, _opened_1, latest))
                CALL(court_ring_started, _ring_started_1)(x, y, z, vx, vy, vz, FIXED(7));
                EACH(GET, _ring_started_1, rho_start, start_rate, rho_rate)
                CALL(court_flight, _flight_1)(since, x, y, z, vx, vy, vz, FIXED(21), FIXED(34));
                V near_x = _flight_1.x;
                V near_y = _flight_1.y;
                V near_z = _flight_1.z;
                V near_vz = _flight_1.vz;
                CALL(court_ring_resolution, _ring_resolution_1)(onset, wide_end, lanes_narrow(leaving), lapsed, lanes_narrow(near_x), lanes_narrow(near_y), lanes_narrow(near_z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(near_vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(start_rate), lanes_narrow(rho_rate), wide_low1, wide_high1, wide_low2, wide_high2, FIXED_SINGLE(0), FIXED_SINGLE(10), FIXED_SINGLE(6), FIXED_SINGLE(11), FIXED_SINGLE(12), FIXED_SINGLE(13), FIXED_SINGLE(14), FIXED_SINGLE(15), FIXED_SINGLE(4), FIXED_SINGLE(16), FIXED_SINGLE(17), FIXED_SINGLE(18));
                S short_share = _ring_resolution_1.share;
                S short_t = _ring_resolution_1.t;
                S short_end = _ring_resolution_1.end;
                S short_x = _ring_resolution_1.x;
                S short_y = _ring_resolution_1.y;
                S short_z = _ring_resolution_1.z;
                S short_vx = _ring_resolution_1.vx;
                S short_vy = _ring_resolution_1.vy;
                S short_vz = _ring_resolution_1.vz;
                S short_energy2 = _ring_resolution_1.energy2;
                S short_moment2 = _ring_resolution_1.moment2;
                S short_rho_start = _ring_resolution_1.rho_start;
                S short_ceiling = _ring_resolution_1.ceiling;
                S short_flat = _ring_resolution_1.flat;
                S short_tilt = _ring_resolution_1.tilt;
                S short_jerk = _ring_resolution_1.jerk;
                S short_quotient_margin = _ring_resolution_1.quotient_margin;
                S short_start_rate = _ring_resolution_1.start_rate;
                S short_rho_rate = _ring_resolution_1.rho_rate;
                S short_rate_margin = _ring_resolution_1.rate_margin;
                S short_low1 = _ring_resolution_1.low1;
                S short_high1 = _ring_resolution_1.high1;
                S short_low2 = _ring_resolution_1.low2;
                S short_high2 = _ring_resolution_1.high2;
                EACH(GET_MASK, _ring_resolution_1, fits)
                CALL(court_coarse, _coarse_1)(lanes_wide(short_rate_margin), lanes_wide(short_flat), lanes_wide(short_ceiling), lanes_wide(short_share), searching, representable, fits);
                EACH(GET_MASK, _coarse_1, stepping, single_precision)
                EACH(SET, _coarse_1, searching)
                EACH(GET, _coarse_1, ceiling, flat, tilt)
#if BOUNDED
                EACH(GET, _coarse_1, allowing)
                CALL(court_ring_coarse_excess, _ring_coarse_excess_1)(allowing, latest, extent, speed, position_error, velocity_error, FIXED(21), FIXED(31), FIXED(43), FIXED(44));
                EACH(GET, _ring_coarse_excess_1, excess)
                CALL(court_ring_budget_exceeded, _ring_budget_exceeded_1)(until, extent, speed, position_error, velocity_error, FIXED(28), FIXED(45), FIXED(20), FIXED(46), FIXED(29), FIXED(30));
                EACH(GET, _ring_budget_exceeded_1, budget_exceeded)
                CALL(court_out_of_budget, _out_of_budget_1)(pad, budget_exceeded, earliest_delay, undecided_time, excess);
                EACH(SELECT, (rows, _out_of_budget_1), undecided_time)
#endif
                const M _if_stepping_1 = lanes_both(rows, stepping);
                if (LANES_USUAL(_if_stepping_1)) {
                    CALL(court_ring_step, _ring_step_1)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_energy2, short_moment2, short_rho_start, short_flat, short_tilt, short_quotient_margin, short_jerk, short_start_rate, short_rho_rate, short_low1, short_high1, short_low2, short_high2, FIXED_SINGLE(19), FIXED_SINGLE(0), FIXED_SINGLE(20), FIXED_SINGLE(21), FIXED_SINGLE(22), FIXED_SINGLE(1), FIXED_SINGLE(23), FIXED_SINGLE(24), FIXED_SINGLE(6), FIXED_SINGLE(25));
                    short_t = singles_select(singles_of(_if_stepping_1), _ring_step_1.t, short_t);
                    short_end = singles_select(singles_of(_if_stepping_1), _ring_step_1.end, short_end);
                    EACH(SELECT_MASK, (_if_stepping_1, _ring_step_1), certain, stepping)
                }
                EACH(STORE, , arrival, ceiling, flat, rho_start, share, since, tilt)
                EACH(STORE_MASK, , certain, searching, single_precision)
                EACH(STORE_SINGLE, , short_t)
                BOUNDS(EACH(STORE, , latest, undecided_time))
                const M packed = lanes_both(rows, stepping);
                if (lanes_any(packed)) {
                    lanes_pack(worklist->stepping_row + stepping_shots, packed, lanes_add(iota(), K((double)i)));
                    EACH(PACK_SINGLE, stepping_, short_ceiling, short_end, short_energy2)
                    EACH(PACK_SINGLE, stepping_, short_flat, short_high1, short_high2, short_jerk)
                    EACH(PACK_SINGLE, stepping_, short_low1, short_low2, short_moment2)
                    EACH(PACK_SINGLE, stepping_, short_quotient_margin, short_rate_margin)
                    EACH(PACK_SINGLE, stepping_, short_rho_rate, short_rho_start, short_start_rate)
                    EACH(PACK_SINGLE, stepping_, short_t, short_tilt, short_vx, short_vy, short_vz)
                    EACH(PACK_SINGLE, stepping_, short_x, short_y, short_z)
                    if (LANES_SELDOM(varying)) {
                        for (size_t _p = 0; _p < 4; _p++) {
                            lanes_pack(worklist->stepping_parameters.columns[stepping_taken[_p]] + stepping_shots, packed, lanes_load(worklist->parameters.columns[stepping_taken[_p]] + i));
                        }
                    }
                    stepping_shots += popcount(packed);
                }
            }
        }
        if (stepping_shots) {
            EACH(CLEAR, stepping_, row)
            EACH(CLEAR_SINGLE, stepping_, short_ceiling, short_end, short_energy2, short_flat)
            EACH(CLEAR_SINGLE, stepping_, short_high1, short_high2, short_jerk, short_low1)
            EACH(CLEAR_SINGLE, stepping_, short_low2, short_moment2, short_quotient_margin)
            EACH(CLEAR_SINGLE, stepping_, short_rate_margin, short_rho_rate, short_rho_start)
            EACH(CLEAR_SINGLE, stepping_, short_start_rate, short_t, short_tilt, short_vx, short_vy)
            EACH(CLEAR_SINGLE, stepping_, short_vz, short_x, short_y, short_z)
            if (LANES_SELDOM(varying)) {
                for (size_t _p = 0; _p < 4; _p++) {
                    lanes_store(worklist->stepping_parameters.columns[stepping_taken[_p]] + stepping_shots, K(0.0));
                }
            }
        }
        {
            size_t taken = 0;
            size_t done = 0;
            size_t busy = 0;
            EACH(START_MASK, , active)
            EACH(START, , row, turns)
            EACH(START_SINGLE, , short_ceiling, short_end, short_energy2, short_flat, short_high1)
            EACH(START_SINGLE, , short_high2, short_jerk, short_low1, short_low2, short_moment2)
            EACH(START_SINGLE, , short_quotient_margin, short_rate_margin, short_rho_rate)
            EACH(START_SINGLE, , short_rho_start, short_start_rate, short_t, short_tilt, short_vx)
            EACH(START_SINGLE, , short_vy, short_vz, short_x, short_y, short_z)
            for (;;) {
                if ((taken < stepping_shots) && ((busy + LANES_SPARE) <= LANES_WIDTH)) {
                    const M idle = lanes_not(active);
                    turns = lanes_select(idle, K(0.0), turns);
                    EACH(EXPAND, stepping_, row)
                    EACH(EXPAND_SINGLE, stepping_, short_ceiling, short_end, short_energy2)
                    EACH(EXPAND_SINGLE, stepping_, short_flat, short_high1, short_high2, short_jerk)
                    EACH(EXPAND_SINGLE, stepping_, short_low1, short_low2, short_moment2)
                    EACH(EXPAND_SINGLE, stepping_, short_quotient_margin, short_rate_margin)
                    EACH(EXPAND_SINGLE, stepping_, short_rho_rate, short_rho_start)
                    EACH(EXPAND_SINGLE, stepping_, short_start_rate, short_t, short_tilt, short_vx)
                    EACH(EXPAND_SINGLE, stepping_, short_vy, short_vz, short_x, short_y, short_z)
                    if (LANES_SELDOM(varying))
                        LOOP(fix_stepping_rows_1)(worklist, taken, idle);
                    const size_t room = LANES_WIDTH - busy;
                    const size_t _left = stepping_shots - taken;
                    active = lanes_leading(idle, _left, active);
                    taken += _left < room ? _left : room;
                    busy += _left < room ? _left : room;
                }
                if (busy == 0)
                    break;
                M stepping = active;
                CALL(court_ring_step, _ring_step_1)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_energy2, short_moment2, short_rho_start, short_flat, short_tilt, short_quotient_margin, short_jerk, short_start_rate, short_rho_rate, short_low1, short_high1, short_low2, short_high2, FIXED_SINGLE(19), FIXED_SINGLE(0), FIXED_SINGLE(20), FIXED_SINGLE(21), FIXED_SINGLE(22), FIXED_SINGLE(1), FIXED_SINGLE(23), FIXED_SINGLE(24), FIXED_SINGLE(6), FIXED_SINGLE(25));
                short_t = _ring_step_1.t;
                short_end = _ring_step_1.end;
                EACH(GET_MASK, _ring_step_1, certain)
                EACH(SET, _ring_step_1, stepping)
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(stepping, lanes_less(turns, K(24.0)))));
                lanes_pack(worklist->stepping_ended_row + done, ended, row);
                lanes_pack(worklist->stepping_ended_certain + done, ended, lanes_select(certain, K(1.0), K(0.0)));
                singles_pack(worklist->stepping_ended_short_t + done, ended, short_t);
                done += popcount(ended);
                busy -= popcount(ended);
                active = lanes_both(active, lanes_not(ended));
            }
            for (size_t k = 0; k < done; k++) {
                const size_t row = (size_t)worklist->stepping_ended_row[k];
                EACH(RETURN, (, stepping_ended_), certain, short_t)
            }
        }
        }
        {
        size_t searching_shots = 0;
        static const int searching_taken[] = {0, 10, 1, 2};
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_both(mask_first_n(shots - i), lanes_less(K(0.0), lanes_load(worklist->open + i)));
            if (lanes_any(rows)) {
                EACH(LOAD, , arrival, since)
                EACH(LOAD_MASK, , certain, searching, single_precision)
                EACH(LOAD_SINGLE, , short_t)
                CALL(court_stepped, _stepped_1)(arrival, lanes_wide(short_t), searching, since, single_precision, certain);
                EACH(SET, _stepped_1, arrival, searching)
                EACH(GET, _stepped_1, t)
                EACH(STORE, , arrival)
                BOUNDS(EACH(STORE, , t))
                const M packed = lanes_both(rows, searching);
                if (lanes_any(packed)) {
                    EACH(LOAD, , extent, last, share, speed, until, vx, vy, vz, x, y, z)
                    BOUNDS(EACH(LOAD, , position_error, undecided_time, velocity_error))
                    lanes_pack(worklist->searching_row + searching_shots, packed, lanes_add(iota(), K((double)i)));
                    EACH(PACK, searching_, arrival, extent, last, share, speed, t, until, vx, vy)
                    EACH(PACK, searching_, vz, x, y, z)
                    EACH(PACK_MASK, searching_, certain)
                    BOUNDS(EACH(PACK, searching_, position_error, undecided_time, velocity_error))
                    if (LANES_SELDOM(varying)) {
                        for (size_t _p = 0; _p < 4; _p++) {
                            lanes_pack(worklist->searching_parameters.columns[searching_taken[_p]] + searching_shots, packed, lanes_load(worklist->parameters.columns[searching_taken[_p]] + i));
                        }
                    }
                    searching_shots += popcount(packed);
                }
            }
        }
        if (searching_shots) {
            EACH(CLEAR, searching_, row, arrival, certain, extent, last, share, speed, t, until, vx)
            EACH(CLEAR, searching_, vy, vz, x, y, z)
            BOUNDS(EACH(CLEAR, searching_, position_error, undecided_time, velocity_error))
            if (LANES_SELDOM(varying)) {
                for (size_t _p = 0; _p < 4; _p++) {
                    lanes_store(worklist->searching_parameters.columns[searching_taken[_p]] + searching_shots, K(0.0));
                }
            }
        }
        {
        size_t searching_searching_shots = 0;
        static const int searching_searching_taken[] = {0, 10, 1, 2};
        for (size_t i = 0; i < searching_shots; i += LANES_WIDTH) {
            const M rows = mask_first_n(searching_shots - i);
            if (LANES_SELDOM(varying))
                LOOP(fix_searching_rows_1)(worklist, i);
            EACH(LOAD, searching_, extent, share, speed, t, until, vx, vy, vz, x, y, z)
            BOUNDS(EACH(LOAD, searching_, position_error, undecided_time, velocity_error))
            CALL(court_ring_prepare, _ring_prepare_1)(until, x, y, z, vx, vy, vz, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), FIXED(37), FIXED(41), FIXED(31), FIXED(22), FIXED(20), FIXED(35), FIXED(39), FIXED(38), FIXED(47), FIXED(28), FIXED(45), FIXED(46), FIXED(29), FIXED(30));
            EACH(GET, _ring_prepare_1, energy2, moment2, rho_start, low0, high0, low1, high1, low2)
            EACH(GET, _ring_prepare_1, high2, ceiling, latest)
#if BOUNDED
            CALL(court_ring_excess, _ring_excess_1)(share, latest, extent, speed, position_error, velocity_error, FIXED(21), FIXED(31), FIXED(44));
            EACH(GET, _ring_excess_1, excess)
#endif
            CALL(court_allowance, _allowance_1)(share, latest, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), FIXED(21));
            EACH(GET, _allowance_1, position_level, velocity_level)
            CALL(court_ring_margins, _ring_margins_1)(latest, extent, speed, position_level, velocity_level, FIXED(21), FIXED(31), FIXED(48), FIXED(49), FIXED(50), FIXED(44));
            V flat = _ring_margins_1.margin;
            V tilt = _ring_margins_1.leaving_margin;
            V rate_slack = _ring_margins_1.rate_margin;
#if BOUNDED
            CALL(court_budget_undecided, _budget_undecided_1)(t, undecided_time, excess);
            EACH(SET, _budget_undecided_1, undecided_time)
#endif
            CALL(court_ring_enter, _ring_enter_1)(t, K(0.0), t, low0, low1, low2, high0, high1, high2);
            EACH(SET, _ring_enter_1, t)
            EACH(GET, _ring_enter_1, end)
            EACH(GET_MASK, _ring_enter_1, searching)
            EACH(STORE, searching_, ceiling, flat, rho_start, tilt)
            BOUNDS(EACH(STORE, searching_, latest, t, undecided_time))
            BOUNDS(EACH(STORE_MASK, searching_, searching))
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                EACH(LOAD, searching_, arrival, last)
                EACH(LOAD_MASK, searching_, certain)
                lanes_pack(worklist->searching_searching_row + searching_searching_shots, packed, lanes_add(iota(), K((double)i)));
                EACH(PACK, searching_searching_, arrival, ceiling, end, energy2, extent, flat)
                EACH(PACK, searching_searching_, high0, high1, high2, last, latest, low0, low1)
                EACH(PACK, searching_searching_, low2, moment2, rate_slack, rho_start, share, speed)
                EACH(PACK, searching_searching_, t, tilt, vx, vy, vz, x, y, z)
                EACH(PACK_MASK, searching_searching_, certain)
                BOUNDS(EACH(PACK, searching_searching_, position_error, undecided_time, velocity_error))
                if (LANES_SELDOM(varying)) {
                    for (size_t _p = 0; _p < 4; _p++) {
                        lanes_pack(worklist->searching_searching_parameters.columns[searching_searching_taken[_p]] + searching_searching_shots, packed, lanes_load(worklist->searching_parameters.columns[searching_searching_taken[_p]] + i));
                    }
                }
                searching_searching_shots += popcount(packed);
            }
        }
        if (searching_searching_shots) {
            EACH(CLEAR, searching_searching_, row, arrival, ceiling, certain, end, energy2, extent)
            EACH(CLEAR, searching_searching_, flat, high0, high1, high2, last, latest, low0, low1)
            EACH(CLEAR, searching_searching_, low2, moment2, rate_slack, rho_start, share, speed, t)
            EACH(CLEAR, searching_searching_, tilt, vx, vy, vz, x, y, z)
            BOUNDS(EACH(CLEAR, searching_searching_, position_error, undecided_time, velocity_error))
            if (LANES_SELDOM(varying)) {
                for (size_t _p = 0; _p < 4; _p++) {
                    lanes_store(worklist->searching_searching_parameters.columns[searching_searching_taken[_p]] + searching_searching_shots, K(0.0));
                }
            }
        }
        {
            size_t taken = 0;
            size_t done = 0;
            size_t busy = 0;
            EACH(START_MASK, , active, certain)
            EACH(START, , row, turns, arrival, ceiling, end, energy2, extent, flat, high0, high1)
            EACH(START, , high2, last, latest, low0, low1, low2, moment2, rate_slack, rho_start)
            EACH(START, , share, speed, t, tilt, vx, vy, vz, x, y, z)
            BOUNDS(EACH(START, , position_error, undecided_time, velocity_error))
            for (;;) {
                if ((taken < searching_searching_shots) && ((busy + LANES_SPARE) <= LANES_WIDTH)) {
                    const M idle = lanes_not(active);
                    turns = lanes_select(idle, K(0.0), turns);
                    EACH(EXPAND, searching_searching_, row, arrival, ceiling, end, energy2, extent)
                    EACH(EXPAND, searching_searching_, flat, high0, high1, high2, last, latest)
                    EACH(EXPAND, searching_searching_, low0, low1, low2, moment2, rate_slack)
                    EACH(EXPAND, searching_searching_, rho_start, share, speed, t, tilt, vx, vy, vz)
                    EACH(EXPAND, searching_searching_, x, y, z)
                    EACH(EXPAND_MASK, searching_searching_, certain)
                    BOUNDS(EACH(EXPAND, searching_searching_, position_error, undecided_time))
                    BOUNDS(EACH(EXPAND, searching_searching_, velocity_error))
                    if (LANES_SELDOM(varying))
                        LOOP(fix_searching_searching_rows_1)(worklist, taken, idle);
                    const size_t room = LANES_WIDTH - busy;
                    const size_t _left = searching_searching_shots - taken;
                    active = lanes_leading(idle, _left, active);
                    taken += _left < room ? _left : room;
                    busy += _left < room ? _left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                CALL(court_nearby, _nearby_1)(t, flat, tilt, K(0.0), last);
                EACH(GET, _nearby_1, leaving, margin)
                CALL(court_ring_advance, _ring_advance_1)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, energy2, moment2, rho_start, FIXED(7), FIXED(21), FIXED(34), FIXED(14), FIXED(51), FIXED(31), FIXED(52), FIXED(53));
                EACH(GET, _ring_advance_1, gap, rate, bend, step, next, clearance)
                CALL(court_gap_closes, _gap_closes_1)(gap, rate, bend, margin, rate_slack, clearance, share);
                EACH(GET_MASK, _gap_closes_1, hit, sure, needs_refinement)
                const M _if_needs_refinement_1 = lanes_both(active, needs_refinement);
                if (lanes_any(_if_needs_refinement_1)) {
                    CALL(court_smaller_budget, _smaller_budget_1)(share);
                    EACH(SELECT, (_if_needs_refinement_1, _smaller_budget_1), share)
#if BOUNDED
                    CALL(court_ring_excess, _ring_excess_1)(share, latest, extent, speed, position_error, velocity_error, FIXED(21), FIXED(31), FIXED(44));
                    EACH(GET, _ring_excess_1, excess)
#endif
                    CALL(court_allowance, _allowance_1)(share, latest, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), FIXED(21));
                    EACH(GET, _allowance_1, position_level, velocity_level)
                    CALL(court_ring_margins, _ring_margins_1)(latest, extent, speed, position_level, velocity_level, FIXED(21), FIXED(31), FIXED(48), FIXED(49), FIXED(50), FIXED(44));
                    flat = lanes_select(_if_needs_refinement_1, _ring_margins_1.margin, flat);
                    tilt = lanes_select(_if_needs_refinement_1, _ring_margins_1.leaving_margin, tilt);
                    rate_slack = lanes_select(_if_needs_refinement_1, _ring_margins_1.rate_margin, rate_slack);
#if BOUNDED
                    CALL(court_budget_undecided, _budget_undecided_1)(t, undecided_time, excess);
                    EACH(SELECT, (_if_needs_refinement_1, _budget_undecided_1), undecided_time)
#endif
                }
                CALL(court_advanced, _advanced_1)(t, end, step, next, arrival, hit, sure, needs_refinement, certain);
                EACH(SET, _advanced_1, arrival, certain, searching, t)
                EACH(GET_MASK, _advanced_1, exhausted)
                const M _if_exhausted_1 = lanes_both(active, exhausted);
                {
                    CALL(court_ring_enter, _ring_enter_1)(t, end, end, low0, low1, low2, high0, high1, high2);
                    EACH(SELECT, (_if_exhausted_1, _ring_enter_1), t, end)
                    EACH(SELECT_MASK, (_if_exhausted_1, _ring_enter_1), searching)
                }
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(searching, lanes_less(turns, K(201.0)))));
                lanes_pack(worklist->searching_searching_ended_row + done, ended, row);
                lanes_pack(worklist->searching_searching_ended_arrival + done, ended, arrival);
                lanes_pack(worklist->searching_searching_ended_certain + done, ended, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(worklist->searching_searching_ended_flat + done, ended, flat);
#if BOUNDED
                lanes_pack(worklist->searching_searching_ended_searching + done, ended, lanes_select(searching, K(1.0), K(0.0)));
                lanes_pack(worklist->searching_searching_ended_t + done, ended, t);
#endif
                lanes_pack(worklist->searching_searching_ended_tilt + done, ended, tilt);
#if BOUNDED
                lanes_pack(worklist->searching_searching_ended_undecided_time + done, ended, undecided_time);
#endif
                done += popcount(ended);
                busy -= popcount(ended);
                active = lanes_both(active, lanes_not(ended));
            }
            for (size_t k = 0; k < done; k++) {
                const size_t row = (size_t)worklist->searching_searching_ended_row[k];
                EACH(RETURN, (searching_, searching_searching_ended_), arrival, certain, flat, tilt)
                BOUNDS(EACH(RETURN, (searching_, searching_searching_ended_), searching, t, undecided_time))
            }
        }
#if BOUNDED
        }
        for (size_t i = 0; i < searching_shots; i += LANES_WIDTH) {
            EACH(LOAD_MASK, searching_, searching)
            EACH(LOAD, searching_, t, undecided_time)
            CALL(court_predicate_undecided, _predicate_undecided_1)(t, undecided_time, searching);
            EACH(SET, _predicate_undecided_1, undecided_time)
            EACH(STORE, searching_, undecided_time)
#endif
        }
        for (size_t k = 0; k < searching_shots; k++) {
            const size_t row = (size_t)worklist->searching_row[k];
            EACH(RETURN, (, searching_), arrival, ceiling, certain, flat, rho_start, tilt)
            BOUNDS(EACH(RETURN, (, searching_), latest, t, undecided_time))
        }
        }
        {
        size_t refining_shots = 0;
        static const int refining_taken[] = {0, 10, 1, 2};
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_both(mask_first_n(shots - i), lanes_less(K(0.0), lanes_load(worklist->open + i)));
            if (lanes_any(rows)) {
                if (LANES_SELDOM(varying))
                    LOOP(fix_rows_4)(worklist, i);
                EACH(LOAD, , arrival, ceiling, flat, last, rho_start, tilt, vx, vy, vz, x, y, z)
                EACH(LOAD_MASK, , certain)
                CALL(court_found, _found_1)(arrival);
                EACH(GET_MASK, _found_1, arrives, refining)
                BOUNDS(EACH(GET, _found_1, rate))
                CALL(court_nearby, _nearby_1)(arrival, flat, tilt, K(0.0), last);
                EACH(GET, _nearby_1, leaving)
                const M _if_refining_1 = lanes_both(rows, refining);
                if (LANES_USUAL(_if_refining_1)) {
                    CALL(court_ring_refine, _ring_refine_1)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, FIXED(7), FIXED(21), FIXED(34), FIXED(14));
                    V refined = _ring_refine_1.time;
                    EACH(GET, _ring_refine_1, gap)
#if BOUNDED
                    EACH(SELECT, (_if_refining_1, _ring_refine_1), rate)
#else
                    EACH(GET, _ring_refine_1, rate)
#endif
                    CALL(court_refined_return, _refined_return_1)(leaving, gap, rate, ceiling, arrival, refined, certain);
                    EACH(SELECT, (_if_refining_1, _refined_return_1), arrival)
                    EACH(SELECT_MASK, (_if_refining_1, _refined_return_1), refining)
                }
                const M _if_refining_2 = lanes_both(rows, refining);
                if (LANES_USUAL(_if_refining_2)) {
                    CALL(court_ring_refine, _ring_refine_2)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, FIXED(7), FIXED(21), FIXED(34), FIXED(14));
                    V refined = _ring_refine_2.time;
                    EACH(GET, _ring_refine_2, gap)
#if BOUNDED
                    EACH(SELECT, (_if_refining_2, _ring_refine_2), rate)
#else
                    EACH(GET, _ring_refine_2, rate)
#endif
                    CALL(court_refined_return, _refined_return_2)(leaving, gap, rate, ceiling, arrival, refined, certain);
                    EACH(SELECT, (_if_refining_2, _refined_return_2), arrival)
                    EACH(SELECT_MASK, (_if_refining_2, _refined_return_2), refining)
                }
                EACH(STORE, , arrival)
                EACH(STORE_MASK, , arrives)
                BOUNDS(EACH(STORE, , leaving, rate))
                const M packed = lanes_both(rows, refining);
                if (lanes_any(packed)) {
                    lanes_pack(worklist->refining_row + refining_shots, packed, lanes_add(iota(), K((double)i)));
                    EACH(PACK, refining_, arrival, ceiling, leaving, rho_start, vx, vy, vz, x, y, z)
                    EACH(PACK_MASK, refining_, certain)
                    if (LANES_SELDOM(varying)) {
                        for (size_t _p = 0; _p < 4; _p++) {
                            lanes_pack(worklist->refining_parameters.columns[refining_taken[_p]] + refining_shots, packed, lanes_load(worklist->parameters.columns[refining_taken[_p]] + i));
                        }
                    }
                    refining_shots += popcount(packed);
                }
            }
        }
        if (refining_shots) {
            EACH(CLEAR, refining_, row, arrival, ceiling, certain, leaving, rho_start, vx, vy, vz)
            EACH(CLEAR, refining_, x, y, z)
            if (LANES_SELDOM(varying)) {
                for (size_t _p = 0; _p < 4; _p++) {
                    lanes_store(worklist->refining_parameters.columns[refining_taken[_p]] + refining_shots, K(0.0));
                }
            }
        }
        {
            size_t taken = 0;
            size_t done = 0;
            size_t busy = 0;
            EACH(START_MASK, , active, certain)
            EACH(START, , row, turns, arrival, ceiling, leaving, rho_start, vx, vy, vz, x, y, z)
            for (;;) {
                if ((taken < refining_shots) && ((busy + LANES_SPARE) <= LANES_WIDTH)) {
                    const M idle = lanes_not(active);
                    turns = lanes_select(idle, K(0.0), turns);
                    EACH(EXPAND, refining_, row, arrival, ceiling, leaving, rho_start, vx, vy, vz)
                    EACH(EXPAND, refining_, x, y, z)
                    EACH(EXPAND_MASK, refining_, certain)
                    if (LANES_SELDOM(varying))
                        LOOP(fix_refining_rows_1)(worklist, taken, idle);
                    const size_t room = LANES_WIDTH - busy;
                    const size_t _left = refining_shots - taken;
                    active = lanes_leading(idle, _left, active);
                    taken += _left < room ? _left : room;
                    busy += _left < room ? _left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                CALL(court_ring_refine, _ring_refine_1)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, FIXED(7), FIXED(21), FIXED(34), FIXED(14));
                V refined = _ring_refine_1.time;
                EACH(GET, _ring_refine_1, gap, rate)
                CALL(court_refined_return, _refined_return_1)(leaving, gap, rate, ceiling, arrival, refined, certain);
                EACH(SET, _refined_return_1, arrival, refining)
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(refining, lanes_less(turns, K(8.0)))));
                lanes_pack(worklist->refining_ended_row + done, ended, row);
                lanes_pack(worklist->refining_ended_arrival + done, ended, arrival);
#if BOUNDED
                lanes_pack(worklist->refining_ended_rate + done, ended, rate);
#endif
                done += popcount(ended);
                busy -= popcount(ended);
                active = lanes_both(active, lanes_not(ended));
            }
            for (size_t k = 0; k < done; k++) {
                const size_t row = (size_t)worklist->refining_ended_row[k];
                EACH(RETURN, (, refining_ended_), arrival)
                BOUNDS(EACH(RETURN, (, refining_ended_), rate))
            }
        }
        }
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_both(mask_first_n(shots - i), lanes_less(K(0.0), lanes_load(worklist->open + i)));
            if (lanes_any(rows)) {
#if BOUNDED
                if (LANES_SELDOM(varying))
                    LOOP(fix_rows_5)(worklist, i);
#endif
                EACH(LOAD, , arrival, when, which)
                EACH(LOAD_MASK, , arrives)
#if BOUNDED
                EACH(LOAD, , ceiling, earliest_delay, extent, latest, leaving, position_error, rate)
                EACH(LOAD, , speed, t, undecided_time, velocity_error)
                EACH(LOAD_MASK, , certain)
                CALL(court_ring_margins, _ring_margins_1)(latest, extent, speed, position_error, velocity_error, FIXED(21), FIXED(31), FIXED(48), FIXED(49), FIXED(50), FIXED(44));
                V flat = _ring_margins_1.margin;
                V tilt = _ring_margins_1.leaving_margin;
                EACH(GET, _ring_margins_1, rate_margin)
                CALL(court_own_margin, _own_margin_1)(leaving, flat, tilt, arrival);
                EACH(GET, _own_margin_1, margin)
                CALL(court_crossing, _crossing_1)(margin, rate_margin, rate, ceiling);
                EACH(GET, _crossing_1, clearance, delay)
#endif
                CALL(court_arrival_time, _arrival_time_1)(arrival);
                EACH(GET, _arrival_time_1, time)
#if BOUNDED
                CALL(court_return_certainty, _return_certainty_1)(t, clearance, time, delay, undecided_time, arrives, certain);
                EACH(SET, _return_certainty_1, delay)
                EACH(SELECT, (rows, _return_certainty_1), undecided_time)
                CALL(court_tie_undecided, _tie_undecided_1)(time, when, delay, earliest_delay, undecided_time, arrives);
                EACH(SELECT, (rows, _tie_undecided_1), undecided_time, earliest_delay)
#endif
                CALL(court_earliest, _earliest_1)(K(0.0), time, when, which, arrives);
                EACH(SELECT, (rows, _earliest_1), when, which)
                EACH(STORE, , when, which)
                BOUNDS(EACH(STORE, , earliest_delay, undecided_time))
            }
        }
        }
        {
        size_t reachable_shots = 0;
        static const int reachable_taken[] = {0, 5, 3, 4, 7, 6, 10};
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = mask_first_n(shots - i);
            if (LANES_SELDOM(varying))
#if BOUNDED
                LOOP(fix_rows_6)(worklist, i);
            EACH(LOAD, , earliest_delay)
#else
                LOOP(fix_rows_5)(worklist, i);
#endif
            EACH(LOAD, , extent, last, speed, vx, vy, vz, when, x, y, z)
            EACH(LOAD_MASK, , in_contact)
            BOUNDS(EACH(LOAD, , position_error, velocity_error))
            CALL(court_horizon, _horizon_1)(when, speed, FIXED(20));
            V until = _horizon_1.horizon;
            EACH(GET, _horizon_1, pad)
            CALL(court_backboard_near, _backboard_near_1)(until, x, vx, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), OR_ZERO(earliest_delay), pad, FIXED(21), FIXED(54), FIXED(55));
            M reachable = _backboard_near_1.near;
            const M _if_reachable_1 = lanes_both(rows, reachable);
            if (lanes_any(_if_reachable_1)) {
                CALL(court_left, _left_1)(K(1.0), last);
                EACH(GET, _left_1, leaving)
                CALL(court_backboard_approaches, _backboard_approaches_1)(leaving, until, x, y, z, vx, vy, vz, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), OR_ZERO(earliest_delay), pad, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(21), FIXED(56), FIXED(15));
                reachable = lanes_choose(_if_reachable_1, _backboard_approaches_1.near, reachable);
            }
            CALL(court_reachable_in_flight, _reachable_in_flight_1)(reachable, in_contact);
            EACH(SET, _reachable_in_flight_1, reachable)
            const M packed = lanes_both(rows, reachable);
            if (lanes_any(packed)) {
                EACH(LOAD, , which)
                BOUNDS(EACH(LOAD, , undecided_time))
                lanes_pack(worklist->reachable_row + reachable_shots, packed, lanes_add(iota(), K((double)i)));
                EACH(PACK, reachable_, extent, last, speed, vx, vy, vz, when, which, x, y, z)
                BOUNDS(EACH(PACK, reachable_, earliest_delay, position_error, undecided_time))
                BOUNDS(EACH(PACK, reachable_, velocity_error))
                if (LANES_SELDOM(varying)) {
                    for (size_t _p = 0; _p < 7; _p++) {
                        lanes_pack(worklist->reachable_parameters.columns[reachable_taken[_p]] + reachable_shots, packed, lanes_load(worklist->parameters.columns[reachable_taken[_p]] + i));
                    }
                }
                reachable_shots += popcount(packed);
            }
        }
        if (reachable_shots) {
            EACH(CLEAR, reachable_, row, extent, last, speed, vx, vy, vz, when, which, x, y, z)
            BOUNDS(EACH(CLEAR, reachable_, earliest_delay, position_error, undecided_time, velocity_error))
            if (LANES_SELDOM(varying)) {
                for (size_t _p = 0; _p < 7; _p++) {
                    lanes_store(worklist->reachable_parameters.columns[reachable_taken[_p]] + reachable_shots, K(0.0));
                }
            }
        }
        {
        size_t reachable_searching_shots = 0;
        static const int reachable_searching_taken[] = {0, 5, 3, 4, 7, 6, 10};
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            const M rows = mask_first_n(reachable_shots - i);
            if (LANES_SELDOM(varying))
                LOOP(fix_reachable_rows_1)(worklist, i);
            EACH(LOAD, reachable_, extent, last, speed, vx, vy, vz, when, x, y, z)
            BOUNDS(EACH(LOAD, reachable_, earliest_delay, position_error, undecided_time, velocity_error))
            CALL(court_horizon, _horizon_1)(when, speed, FIXED(20));
            V until = _horizon_1.horizon;
            EACH(GET, _horizon_1, pad)
            CALL(court_backboard_prepare, _backboard_prepare_1)(until, x, y, z, vx, vy, vz, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), OR_ZERO(earliest_delay), pad, FIXED(21), FIXED(57), FIXED(58), FIXED(59), FIXED(60), FIXED(61), FIXED(62), FIXED(63), FIXED(22), FIXED(20), FIXED(64), FIXED(45), FIXED(65), FIXED(66), FIXED(67));
            EACH(GET, _backboard_prepare_1, low0, high0, low1, high1, ceiling, latest)
            BOUNDS(EACH(GET, _backboard_prepare_1, budget_exceeded))
            CALL(court_beginning, _beginning_1)();
            EACH(GET, _beginning_1, share, arrival)
            EACH(GET_MASK, _beginning_1, certain)
            CALL(court_allowance, _allowance_1)(share, latest, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), FIXED(21));
            EACH(GET, _allowance_1, position_level, velocity_level)
            BOUNDS(EACH(GET, _allowance_1, excess))
            CALL(court_backboard_margins, _backboard_margins_1)(latest, extent, speed, position_level, velocity_level, FIXED(21), FIXED(68), FIXED(69), FIXED(70), FIXED(71), FIXED(72), FIXED(73), FIXED(74), FIXED(75), FIXED(76), FIXED(77), FIXED(78));
            V flat = _backboard_margins_1.margin;
            V tilt = _backboard_margins_1.leaving_margin;
            V rate_slack = _backboard_margins_1.rate_margin;
            CALL(court_backboard_enter, _backboard_enter_1)(K(0.0), K(0.0), K(0.0), low0, low1, high0, high1);
            EACH(GET, _backboard_enter_1, t, end)
            EACH(GET_MASK, _backboard_enter_1, searching)
#if BOUNDED
            CALL(court_out_of_budget_in_windows, _out_of_budget_in_windows_1)(pad, budget_exceeded, earliest_delay, undecided_time, excess, searching);
            EACH(SET, _out_of_budget_in_windows_1, undecided_time)
#endif
            const M _if_searching_1 = lanes_both(rows, searching);
            if (lanes_any(_if_searching_1)) {
                CALL(court_nearby, _nearby_1)(t, flat, tilt, K(1.0), last);
                EACH(GET, _nearby_1, leaving, margin)
                CALL(court_backboard_advance, _backboard_advance_1)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(21), FIXED(15), FIXED(34), FIXED(56), FIXED(79), FIXED(69), FIXED(27));
                EACH(GET, _backboard_advance_1, gap, rate, bend, step, next, clearance)
                CALL(court_gap_closes_or_stalls, _gap_closes_or_stalls_1)(t, end, gap, rate, bend, margin, rate_slack, next, clearance, share);
                EACH(GET_MASK, _gap_closes_or_stalls_1, hit, sure, needs_refinement)
                const M _if_needs_refinement_1 = lanes_both(_if_searching_1, needs_refinement);
                if (lanes_any(_if_needs_refinement_1)) {
                    CALL(court_smaller_budget, _smaller_budget_1)(share);
                    EACH(SELECT, (_if_needs_refinement_1, _smaller_budget_1), share)
                    CALL(court_allowance, _allowance_2)(share, latest, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), FIXED(21));
                    EACH(GET, _allowance_2, position_level, velocity_level)
                    BOUNDS(EACH(GET, _allowance_2, excess))
                    CALL(court_backboard_margins, _backboard_margins_2)(latest, extent, speed, position_level, velocity_level, FIXED(21), FIXED(68), FIXED(69), FIXED(70), FIXED(71), FIXED(72), FIXED(73), FIXED(74), FIXED(75), FIXED(76), FIXED(77), FIXED(78));
                    flat = lanes_select(_if_needs_refinement_1, _backboard_margins_2.margin, flat);
                    tilt = lanes_select(_if_needs_refinement_1, _backboard_margins_2.leaving_margin, tilt);
                    rate_slack = lanes_select(_if_needs_refinement_1, _backboard_margins_2.rate_margin, rate_slack);
#if BOUNDED
                    CALL(court_budget_undecided, _budget_undecided_1)(t, undecided_time, excess);
                    EACH(SELECT, (_if_needs_refinement_1, _budget_undecided_1), undecided_time)
#endif
                }
                CALL(court_advanced, _advanced_1)(t, end, step, next, arrival, hit, sure, needs_refinement, certain);
                EACH(SELECT, (_if_searching_1, _advanced_1), arrival)
                EACH(SELECT_MASK, (_if_searching_1, _advanced_1), certain)
                EACH(GET_MASK, _advanced_1, exhausted)
                EACH(SELECT_MASK, (_if_searching_1, _advanced_1), searching)
                EACH(SELECT, (_if_searching_1, _advanced_1), t)
                const M _if_exhausted_1 = lanes_both(_if_searching_1, exhausted);
                {
                    CALL(court_backboard_enter, _backboard_enter_2)(t, end, end, low0, low1, high0, high1);
                    EACH(SELECT, (_if_exhausted_1, _backboard_enter_2), t, end)
                    EACH(SELECT_MASK, (_if_exhausted_1, _backboard_enter_2), searching)
                }
            }
            EACH(STORE, reachable_, arrival, ceiling, flat, tilt)
            EACH(STORE_MASK, reachable_, certain)
            BOUNDS(EACH(STORE, reachable_, latest, t, undecided_time))
            BOUNDS(EACH(STORE_MASK, reachable_, searching))
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(worklist->reachable_searching_row + reachable_searching_shots, packed, lanes_add(iota(), K((double)i)));
                EACH(PACK, reachable_searching_, arrival, ceiling, end, extent, flat, high0, high1)
                EACH(PACK, reachable_searching_, last, latest, low0, low1, rate_slack, share, speed)
                EACH(PACK, reachable_searching_, t, tilt, vx, vy, vz, x, y, z)
                EACH(PACK_MASK, reachable_searching_, certain)
                BOUNDS(EACH(PACK, reachable_searching_, position_error, undecided_time, velocity_error))
                if (LANES_SELDOM(varying)) {
                    for (size_t _p = 0; _p < 7; _p++) {
                        lanes_pack(worklist->reachable_searching_parameters.columns[reachable_searching_taken[_p]] + reachable_searching_shots, packed, lanes_load(worklist->reachable_parameters.columns[reachable_searching_taken[_p]] + i));
                    }
                }
                reachable_searching_shots += popcount(packed);
            }
        }
        if (reachable_searching_shots) {
            EACH(CLEAR, reachable_searching_, row, arrival, ceiling, certain, end, extent, flat)
            EACH(CLEAR, reachable_searching_, high0, high1, last, latest, low0, low1, rate_slack)
            EACH(CLEAR, reachable_searching_, share, speed, t, tilt, vx, vy, vz, x, y, z)
            BOUNDS(EACH(CLEAR, reachable_searching_, position_error, undecided_time, velocity_error))
            if (LANES_SELDOM(varying)) {
                for (size_t _p = 0; _p < 7; _p++) {
                    lanes_store(worklist->reachable_searching_parameters.columns[reachable_searching_taken[_p]] + reachable_searching_shots, K(0.0));
                }
            }
        }
        {
            size_t taken = 0;
            size_t done = 0;
            size_t busy = 0;
            EACH(START_MASK, , active, certain)
            EACH(START, , row, turns, arrival, ceiling, end, extent, flat, high0, high1, last)
            EACH(START, , latest, low0, low1, rate_slack, share, speed, t, tilt, vx, vy, vz, x, y)
            EACH(START, , z)
            BOUNDS(EACH(START, , position_error, undecided_time, velocity_error))
            for (;;) {
                if ((taken < reachable_searching_shots) && ((busy + LANES_SPARE) <= LANES_WIDTH)) {
                    const M idle = lanes_not(active);
                    turns = lanes_select(idle, K(0.0), turns);
                    EACH(EXPAND, reachable_searching_, row, arrival, ceiling, end, extent, flat)
                    EACH(EXPAND, reachable_searching_, high0, high1, last, latest, low0, low1)
                    EACH(EXPAND, reachable_searching_, rate_slack, share, speed, t, tilt, vx, vy)
                    EACH(EXPAND, reachable_searching_, vz, x, y, z)
                    EACH(EXPAND_MASK, reachable_searching_, certain)
                    BOUNDS(EACH(EXPAND, reachable_searching_, position_error, undecided_time))
                    BOUNDS(EACH(EXPAND, reachable_searching_, velocity_error))
                    if (LANES_SELDOM(varying))
                        LOOP(fix_reachable_searching_rows_1)(worklist, taken, idle);
                    const size_t room = LANES_WIDTH - busy;
                    const size_t _left = reachable_searching_shots - taken;
                    active = lanes_leading(idle, _left, active);
                    taken += _left < room ? _left : room;
                    busy += _left < room ? _left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                CALL(court_nearby, _nearby_1)(t, flat, tilt, K(1.0), last);
                EACH(GET, _nearby_1, leaving, margin)
                CALL(court_backboard_advance, _backboard_advance_1)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(21), FIXED(15), FIXED(34), FIXED(56), FIXED(79), FIXED(69), FIXED(27));
                EACH(GET, _backboard_advance_1, gap, rate, bend, step, next, clearance)
                CALL(court_gap_closes_or_stalls, _gap_closes_or_stalls_1)(t, end, gap, rate, bend, margin, rate_slack, next, clearance, share);
                EACH(GET_MASK, _gap_closes_or_stalls_1, hit, sure, needs_refinement)
                const M _if_needs_refinement_1 = lanes_both(active, needs_refinement);
                if (lanes_any(_if_needs_refinement_1)) {
                    CALL(court_smaller_budget, _smaller_budget_1)(share);
                    EACH(SELECT, (_if_needs_refinement_1, _smaller_budget_1), share)
                    CALL(court_allowance, _allowance_1)(share, latest, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), FIXED(21));
                    EACH(GET, _allowance_1, position_level, velocity_level)
                    BOUNDS(EACH(GET, _allowance_1, excess))
                    CALL(court_backboard_margins, _backboard_margins_1)(latest, extent, speed, position_level, velocity_level, FIXED(21), FIXED(68), FIXED(69), FIXED(70), FIXED(71), FIXED(72), FIXED(73), FIXED(74), FIXED(75), FIXED(76), FIXED(77), FIXED(78));
                    flat = lanes_select(_if_needs_refinement_1, _backboard_margins_1.margin, flat);
                    tilt = lanes_select(_if_needs_refinement_1, _backboard_margins_1.leaving_margin, tilt);
                    rate_slack = lanes_select(_if_needs_refinement_1, _backboard_margins_1.rate_margin, rate_slack);
#if BOUNDED
                    CALL(court_budget_undecided, _budget_undecided_1)(t, undecided_time, excess);
                    EACH(SELECT, (_if_needs_refinement_1, _budget_undecided_1), undecided_time)
#endif
                }
                CALL(court_advanced, _advanced_1)(t, end, step, next, arrival, hit, sure, needs_refinement, certain);
                EACH(SET, _advanced_1, arrival, certain, searching, t)
                EACH(GET_MASK, _advanced_1, exhausted)
                const M _if_exhausted_1 = lanes_both(active, exhausted);
                {
                    CALL(court_backboard_enter, _backboard_enter_1)(t, end, end, low0, low1, high0, high1);
                    EACH(SELECT, (_if_exhausted_1, _backboard_enter_1), t, end)
                    EACH(SELECT_MASK, (_if_exhausted_1, _backboard_enter_1), searching)
                }
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(searching, lanes_less(turns, K(201.0)))));
                lanes_pack(worklist->reachable_searching_ended_row + done, ended, row);
                lanes_pack(worklist->reachable_searching_ended_arrival + done, ended, arrival);
                lanes_pack(worklist->reachable_searching_ended_certain + done, ended, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(worklist->reachable_searching_ended_flat + done, ended, flat);
#if BOUNDED
                lanes_pack(worklist->reachable_searching_ended_searching + done, ended, lanes_select(searching, K(1.0), K(0.0)));
                lanes_pack(worklist->reachable_searching_ended_t + done, ended, t);
#endif
                lanes_pack(worklist->reachable_searching_ended_tilt + done, ended, tilt);
#if BOUNDED
                lanes_pack(worklist->reachable_searching_ended_undecided_time + done, ended, undecided_time);
#endif
                done += popcount(ended);
                busy -= popcount(ended);
                active = lanes_both(active, lanes_not(ended));
            }
            for (size_t k = 0; k < done; k++) {
                const size_t row = (size_t)worklist->reachable_searching_ended_row[k];
                EACH(RETURN, (reachable_, reachable_searching_ended_), arrival, certain, flat, tilt)
                BOUNDS(EACH(RETURN, (reachable_, reachable_searching_ended_), searching, t, undecided_time))
            }
        }
        }
        {
        size_t reachable_refining_shots = 0;
        static const int reachable_refining_taken[] = {0, 5, 3, 4, 7, 6, 10};
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            const M rows = mask_first_n(reachable_shots - i);
            if (LANES_SELDOM(varying))
                LOOP(fix_reachable_rows_2)(worklist, i);
            EACH(LOAD, reachable_, arrival, ceiling, flat, last, tilt, vx, vy, vz, x, y, z)
            EACH(LOAD_MASK, reachable_, certain)
#if BOUNDED
            EACH(LOAD, reachable_, t, undecided_time)
            EACH(LOAD_MASK, reachable_, searching)
            CALL(court_predicate_undecided, _predicate_undecided_1)(t, undecided_time, searching);
            EACH(SET, _predicate_undecided_1, undecided_time)
#endif
            CALL(court_found, _found_1)(arrival);
            EACH(GET_MASK, _found_1, arrives, refining)
            BOUNDS(EACH(GET, _found_1, rate))
            CALL(court_nearby, _nearby_1)(arrival, flat, tilt, K(1.0), last);
            EACH(GET, _nearby_1, leaving)
            const M _if_refining_1 = lanes_both(rows, refining);
            if (lanes_any(_if_refining_1)) {
                CALL(court_backboard_refine, _backboard_refine_1)(arrival, leaving, x, y, z, vx, vy, vz, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(21), FIXED(15), FIXED(34), FIXED(56));
                V refined = _backboard_refine_1.time;
                EACH(GET, _backboard_refine_1, gap)
#if BOUNDED
                EACH(SELECT, (_if_refining_1, _backboard_refine_1), rate)
#else
                EACH(GET, _backboard_refine_1, rate)
#endif
                CALL(court_refined_return, _refined_return_1)(leaving, gap, rate, ceiling, arrival, refined, certain);
                EACH(SELECT, (_if_refining_1, _refined_return_1), arrival)
                EACH(SELECT_MASK, (_if_refining_1, _refined_return_1), refining)
            }
            const M _if_refining_2 = lanes_both(rows, refining);
            if (lanes_any(_if_refining_2)) {
                CALL(court_backboard_refine, _backboard_refine_2)(arrival, leaving, x, y, z, vx, vy, vz, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(21), FIXED(15), FIXED(34), FIXED(56));
                V refined = _backboard_refine_2.time;
                EACH(GET, _backboard_refine_2, gap)
#if BOUNDED
                EACH(SELECT, (_if_refining_2, _backboard_refine_2), rate)
#else
                EACH(GET, _backboard_refine_2, rate)
#endif
                CALL(court_refined_return, _refined_return_2)(leaving, gap, rate, ceiling, arrival, refined, certain);
                EACH(SELECT, (_if_refining_2, _refined_return_2), arrival)
                EACH(SELECT_MASK, (_if_refining_2, _refined_return_2), refining)
            }
            EACH(STORE, reachable_, arrival)
            EACH(STORE_MASK, reachable_, arrives)
            BOUNDS(EACH(STORE, reachable_, leaving, rate, undecided_time))
            const M packed = lanes_both(rows, refining);
            if (lanes_any(packed)) {
                lanes_pack(worklist->reachable_refining_row + reachable_refining_shots, packed, lanes_add(iota(), K((double)i)));
                EACH(PACK, reachable_refining_, arrival, ceiling, leaving, vx, vy, vz, x, y, z)
                EACH(PACK_MASK, reachable_refining_, certain)
                if (LANES_SELDOM(varying)) {
                    for (size_t _p = 0; _p < 7; _p++) {
                        lanes_pack(worklist->reachable_refining_parameters.columns[reachable_refining_taken[_p]] + reachable_refining_shots, packed, lanes_load(worklist->reachable_parameters.columns[reachable_refining_taken[_p]] + i));
                    }
                }
                reachable_refining_shots += popcount(packed);
            }
        }
        if (reachable_refining_shots) {
            EACH(CLEAR, reachable_refining_, row, arrival, ceiling, certain, leaving, vx, vy, vz, x)
            EACH(CLEAR, reachable_refining_, y, z)
            if (LANES_SELDOM(varying)) {
                for (size_t _p = 0; _p < 7; _p++) {
                    lanes_store(worklist->reachable_refining_parameters.columns[reachable_refining_taken[_p]] + reachable_refining_shots, K(0.0));
                }
            }
        }
        {
            size_t taken = 0;
            size_t done = 0;
            size_t busy = 0;
            EACH(START_MASK, , active, certain)
            EACH(START, , row, turns, arrival, ceiling, leaving, vx, vy, vz, x, y, z)
            for (;;) {
                if ((taken < reachable_refining_shots) && ((busy + LANES_SPARE) <= LANES_WIDTH)) {
                    const M idle = lanes_not(active);
                    turns = lanes_select(idle, K(0.0), turns);
                    EACH(EXPAND, reachable_refining_, row, arrival, ceiling, leaving, vx, vy, vz, x)
                    EACH(EXPAND, reachable_refining_, y, z)
                    EACH(EXPAND_MASK, reachable_refining_, certain)
                    if (LANES_SELDOM(varying))
                        LOOP(fix_reachable_refining_rows_1)(worklist, taken, idle);
                    const size_t room = LANES_WIDTH - busy;
                    const size_t _left = reachable_refining_shots - taken;
                    active = lanes_leading(idle, _left, active);
                    taken += _left < room ? _left : room;
                    busy += _left < room ? _left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                CALL(court_backboard_refine, _backboard_refine_1)(arrival, leaving, x, y, z, vx, vy, vz, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(21), FIXED(15), FIXED(34), FIXED(56));
                V refined = _backboard_refine_1.time;
                EACH(GET, _backboard_refine_1, gap, rate)
                CALL(court_refined_return, _refined_return_1)(leaving, gap, rate, ceiling, arrival, refined, certain);
                EACH(SET, _refined_return_1, arrival, refining)
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(refining, lanes_less(turns, K(8.0)))));
                lanes_pack(worklist->reachable_refining_ended_row + done, ended, row);
                lanes_pack(worklist->reachable_refining_ended_arrival + done, ended, arrival);
#if BOUNDED
                lanes_pack(worklist->reachable_refining_ended_rate + done, ended, rate);
#endif
                done += popcount(ended);
                busy -= popcount(ended);
                active = lanes_both(active, lanes_not(ended));
            }
            for (size_t k = 0; k < done; k++) {
                const size_t row = (size_t)worklist->reachable_refining_ended_row[k];
                EACH(RETURN, (reachable_, reachable_refining_ended_), arrival)
                BOUNDS(EACH(RETURN, (reachable_, reachable_refining_ended_), rate))
            }
        }
        }
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
#if BOUNDED
            if (LANES_SELDOM(varying))
                LOOP(fix_reachable_rows_3)(worklist, i);
#endif
            EACH(LOAD, reachable_, arrival, when, which)
            EACH(LOAD_MASK, reachable_, arrives)
#if BOUNDED
            EACH(LOAD, reachable_, ceiling, earliest_delay, extent, latest, leaving, position_error)
            EACH(LOAD, reachable_, rate, speed, t, undecided_time, velocity_error)
            EACH(LOAD_MASK, reachable_, certain)
            CALL(court_backboard_margins, _backboard_margins_1)(latest, extent, speed, position_error, velocity_error, FIXED(21), FIXED(68), FIXED(69), FIXED(70), FIXED(71), FIXED(72), FIXED(73), FIXED(74), FIXED(75), FIXED(76), FIXED(77), FIXED(78));
            V flat = _backboard_margins_1.margin;
            V tilt = _backboard_margins_1.leaving_margin;
            EACH(GET, _backboard_margins_1, rate_margin)
            CALL(court_own_margin, _own_margin_1)(leaving, flat, tilt, arrival);
            EACH(GET, _own_margin_1, margin)
            CALL(court_crossing, _crossing_1)(margin, rate_margin, rate, ceiling);
            EACH(GET, _crossing_1, clearance, delay)
#endif
            CALL(court_arrival_time, _arrival_time_1)(arrival);
            EACH(GET, _arrival_time_1, time)
#if BOUNDED
            CALL(court_return_certainty, _return_certainty_1)(t, clearance, time, delay, undecided_time, arrives, certain);
            EACH(SET, _return_certainty_1, delay, undecided_time)
            CALL(court_tie_undecided, _tie_undecided_1)(time, when, delay, earliest_delay, undecided_time, arrives);
            EACH(SET, _tie_undecided_1, undecided_time, earliest_delay)
#endif
            CALL(court_earliest, _earliest_1)(K(1.0), time, when, which, arrives);
            EACH(SET, _earliest_1, when, which)
            EACH(STORE, reachable_, when, which)
            BOUNDS(EACH(STORE, reachable_, earliest_delay, undecided_time))
        }
        for (size_t k = 0; k < reachable_shots; k++) {
            const size_t row = (size_t)worklist->reachable_row[k];
            EACH(RETURN, (, reachable_), when, which)
            BOUNDS(EACH(RETURN, (, reachable_), earliest_delay, undecided_time))
        }
        }
        {
        size_t reachable_shots = 0;
        static const int reachable_taken[] = {0, 3, 9, 8, 10, 1, 2};
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = mask_first_n(shots - i);
            if (LANES_SELDOM(varying))
#if BOUNDED
                LOOP(fix_rows_7)(worklist, i);
            EACH(LOAD, , earliest_delay)
#else
                LOOP(fix_rows_6)(worklist, i);
#endif
            EACH(LOAD, , extent, last, speed, vx, vy, vz, when, x, y, z)
            EACH(LOAD_MASK, , in_contact)
            BOUNDS(EACH(LOAD, , position_error, velocity_error))
            CALL(court_horizon, _horizon_1)(when, speed, FIXED(20));
            V until = _horizon_1.horizon;
            EACH(GET, _horizon_1, pad)
            CALL(court_half_flight_boxes, _half_flight_boxes_1)(until, x, y, z, vx, vy, vz, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), OR_ZERO(earliest_delay), pad, FIXED(21), FIXED(80), FIXED(34), FIXED(81));
            EACH(GET, _half_flight_boxes_1, middle_x, reach_x, later_middle_x, later_reach_x)
            EACH(GET, _half_flight_boxes_1, middle_y, reach_y, later_middle_y, later_reach_y)
            EACH(GET, _half_flight_boxes_1, middle_z, reach_z, later_middle_z, later_reach_z)
            CALL(court_bridge_near, _bridge_near_1)(middle_x, middle_y, middle_z, reach_x, reach_y, reach_z, later_middle_x, later_middle_y, later_middle_z, later_reach_x, later_reach_y, later_reach_z, FIXED(82), FIXED(4), FIXED(83), FIXED(84), FIXED(85), FIXED(86));
            M reachable = _bridge_near_1.near;
            EACH(GET_MASK, _bridge_near_1, first_near, later_near)
            const M _if_reachable_1 = lanes_both(rows, reachable);
            if (lanes_any(_if_reachable_1)) {
                CALL(court_left, _left_1)(K(2.0), last);
                EACH(GET, _left_1, leaving)
                CALL(court_bridge_approaches, _bridge_approaches_1)(leaving, until, x, y, z, vx, vy, vz, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), OR_ZERO(earliest_delay), pad, first_near, later_near, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(21), FIXED(56), FIXED(16));
                reachable = lanes_choose(_if_reachable_1, _bridge_approaches_1.near, reachable);
            }
            CALL(court_reachable_in_flight, _reachable_in_flight_1)(reachable, in_contact);
            EACH(SET, _reachable_in_flight_1, reachable)
            const M packed = lanes_both(rows, reachable);
            if (lanes_any(packed)) {
                EACH(LOAD, , which)
                BOUNDS(EACH(LOAD, , undecided_time))
                lanes_pack(worklist->reachable_row + reachable_shots, packed, lanes_add(iota(), K((double)i)));
                EACH(PACK, reachable_, extent, last, speed, vx, vy, vz, when, which, x, y, z)
                BOUNDS(EACH(PACK, reachable_, earliest_delay, position_error, undecided_time))
                BOUNDS(EACH(PACK, reachable_, velocity_error))
                if (LANES_SELDOM(varying)) {
                    for (size_t _p = 0; _p < 7; _p++) {
                        lanes_pack(worklist->reachable_parameters.columns[reachable_taken[_p]] + reachable_shots, packed, lanes_load(worklist->parameters.columns[reachable_taken[_p]] + i));
                    }
                }
                reachable_shots += popcount(packed);
            }
        }
        if (reachable_shots) {
            EACH(CLEAR, reachable_, row, extent, last, speed, vx, vy, vz, when, which, x, y, z)
            BOUNDS(EACH(CLEAR, reachable_, earliest_delay, position_error, undecided_time, velocity_error))
            if (LANES_SELDOM(varying)) {
                for (size_t _p = 0; _p < 7; _p++) {
                    lanes_store(worklist->reachable_parameters.columns[reachable_taken[_p]] + reachable_shots, K(0.0));
                }
            }
        }
        {
        size_t reachable_searching_shots = 0;
        static const int reachable_searching_taken[] = {0, 3, 9, 8, 10, 1, 2};
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            const M rows = mask_first_n(reachable_shots - i);
            if (LANES_SELDOM(varying))
#if BOUNDED
                LOOP(fix_reachable_rows_4)(worklist, i);
            EACH(LOAD, reachable_, earliest_delay)
#else
                LOOP(fix_reachable_rows_3)(worklist, i);
#endif
            EACH(LOAD, reachable_, extent, last, speed, vx, vy, vz, when, x, y, z)
            BOUNDS(EACH(LOAD, reachable_, position_error, undecided_time, velocity_error))
            CALL(court_horizon, _horizon_1)(when, speed, FIXED(20));
            V until = _horizon_1.horizon;
            EACH(GET, _horizon_1, pad)
            CALL(court_bridge_prepare, _bridge_prepare_1)(until, x, y, z, vx, vy, vz, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), OR_ZERO(earliest_delay), pad, FIXED(8), FIXED(21), FIXED(87), FIXED(88), FIXED(89), FIXED(90), FIXED(91), FIXED(92), FIXED(22), FIXED(20), FIXED(93), FIXED(45), FIXED(94), FIXED(95), FIXED(96));
            EACH(GET, _bridge_prepare_1, low0, high0, low1, high1, ceiling, latest)
            BOUNDS(EACH(GET, _bridge_prepare_1, budget_exceeded))
            CALL(court_beginning, _beginning_1)();
            EACH(GET, _beginning_1, share, arrival)
            EACH(GET_MASK, _beginning_1, certain)
            CALL(court_allowance, _allowance_1)(share, latest, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), FIXED(21));
            EACH(GET, _allowance_1, position_level, velocity_level)
            BOUNDS(EACH(GET, _allowance_1, excess))
            CALL(court_bridge_margins, _bridge_margins_1)(latest, extent, speed, position_level, velocity_level, FIXED(21), FIXED(68), FIXED(97), FIXED(98), FIXED(99), FIXED(100), FIXED(101), FIXED(102), FIXED(103), FIXED(104), FIXED(105), FIXED(106));
            V flat = _bridge_margins_1.margin;
            V tilt = _bridge_margins_1.leaving_margin;
            V rate_slack = _bridge_margins_1.rate_margin;
            CALL(court_bridge_enter, _bridge_enter_1)(K(0.0), K(0.0), K(0.0), low0, low1, high0, high1);
            EACH(GET, _bridge_enter_1, t, end)
            EACH(GET_MASK, _bridge_enter_1, searching)
#if BOUNDED
            CALL(court_out_of_budget_in_windows, _out_of_budget_in_windows_1)(pad, budget_exceeded, earliest_delay, undecided_time, excess, searching);
            EACH(SET, _out_of_budget_in_windows_1, undecided_time)
#endif
            const M _if_searching_1 = lanes_both(rows, searching);
            if (lanes_any(_if_searching_1)) {
                CALL(court_nearby, _nearby_1)(t, flat, tilt, K(2.0), last);
                EACH(GET, _nearby_1, leaving, margin)
                CALL(court_bridge_advance, _bridge_advance_1)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(21), FIXED(16), FIXED(34), FIXED(56), FIXED(79), FIXED(97), FIXED(27));
                EACH(GET, _bridge_advance_1, gap, rate, bend, step, next, clearance)
                CALL(court_gap_closes_or_stalls, _gap_closes_or_stalls_1)(t, end, gap, rate, bend, margin, rate_slack, next, clearance, share);
                EACH(GET_MASK, _gap_closes_or_stalls_1, hit, sure, needs_refinement)
                const M _if_needs_refinement_1 = lanes_both(_if_searching_1, needs_refinement);
                if (lanes_any(_if_needs_refinement_1)) {
                    CALL(court_smaller_budget, _smaller_budget_1)(share);
                    EACH(SELECT, (_if_needs_refinement_1, _smaller_budget_1), share)
                    CALL(court_allowance, _allowance_2)(share, latest, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), FIXED(21));
                    EACH(GET, _allowance_2, position_level, velocity_level)
                    BOUNDS(EACH(GET, _allowance_2, excess))
                    CALL(court_bridge_margins, _bridge_margins_2)(latest, extent, speed, position_level, velocity_level, FIXED(21), FIXED(68), FIXED(97), FIXED(98), FIXED(99), FIXED(100), FIXED(101), FIXED(102), FIXED(103), FIXED(104), FIXED(105), FIXED(106));
                    flat = lanes_select(_if_needs_refinement_1, _bridge_margins_2.margin, flat);
                    tilt = lanes_select(_if_needs_refinement_1, _bridge_margins_2.leaving_margin, tilt);
                    rate_slack = lanes_select(_if_needs_refinement_1, _bridge_margins_2.rate_margin, rate_slack);
#if BOUNDED
                    CALL(court_budget_undecided, _budget_undecided_1)(t, undecided_time, excess);
                    EACH(SELECT, (_if_needs_refinement_1, _budget_undecided_1), undecided_time)
#endif
                }
                CALL(court_advanced, _advanced_1)(t, end, step, next, arrival, hit, sure, needs_refinement, certain);
                EACH(SELECT, (_if_searching_1, _advanced_1), arrival)
                EACH(SELECT_MASK, (_if_searching_1, _advanced_1), certain)
                EACH(GET_MASK, _advanced_1, exhausted)
                EACH(SELECT_MASK, (_if_searching_1, _advanced_1), searching)
                EACH(SELECT, (_if_searching_1, _advanced_1), t)
                const M _if_exhausted_1 = lanes_both(_if_searching_1, exhausted);
                {
                    CALL(court_bridge_enter, _bridge_enter_2)(t, end, end, low0, low1, high0, high1);
                    EACH(SELECT, (_if_exhausted_1, _bridge_enter_2), t, end)
                    EACH(SELECT_MASK, (_if_exhausted_1, _bridge_enter_2), searching)
                }
            }
            EACH(STORE, reachable_, arrival, ceiling, flat, tilt)
            EACH(STORE_MASK, reachable_, certain)
            BOUNDS(EACH(STORE, reachable_, latest, t, undecided_time))
            BOUNDS(EACH(STORE_MASK, reachable_, searching))
            const M packed = lanes_both(rows, searching);
            if (lanes_any(packed)) {
                lanes_pack(worklist->reachable_searching_row + reachable_searching_shots, packed, lanes_add(iota(), K((double)i)));
                EACH(PACK, reachable_searching_, arrival, ceiling, end, extent, flat, high0, high1)
                EACH(PACK, reachable_searching_, last, latest, low0, low1, rate_slack, share, speed)
                EACH(PACK, reachable_searching_, t, tilt, vx, vy, vz, x, y, z)
                EACH(PACK_MASK, reachable_searching_, certain)
                BOUNDS(EACH(PACK, reachable_searching_, position_error, undecided_time, velocity_error))
                if (LANES_SELDOM(varying)) {
                    for (size_t _p = 0; _p < 7; _p++) {
                        lanes_pack(worklist->reachable_searching_parameters.columns[reachable_searching_taken[_p]] + reachable_searching_shots, packed, lanes_load(worklist->reachable_parameters.columns[reachable_searching_taken[_p]] + i));
                    }
                }
                reachable_searching_shots += popcount(packed);
            }
        }
        if (reachable_searching_shots) {
            EACH(CLEAR, reachable_searching_, row, arrival, ceiling, certain, end, extent, flat)
            EACH(CLEAR, reachable_searching_, high0, high1, last, latest, low0, low1, rate_slack)
            EACH(CLEAR, reachable_searching_, share, speed, t, tilt, vx, vy, vz, x, y, z)
            BOUNDS(EACH(CLEAR, reachable_searching_, position_error, undecided_time, velocity_error))
            if (LANES_SELDOM(varying)) {
                for (size_t _p = 0; _p < 7; _p++) {
                    lanes_store(worklist->reachable_searching_parameters.columns[reachable_searching_taken[_p]] + reachable_searching_shots, K(0.0));
                }
            }
        }
        {
            size_t taken = 0;
            size_t done = 0;
            size_t busy = 0;
            EACH(START_MASK, , active, certain)
            EACH(START, , row, turns, arrival, ceiling, end, extent, flat, high0, high1, last)
            EACH(START, , latest, low0, low1, rate_slack, share, speed, t, tilt, vx, vy, vz, x, y)
            EACH(START, , z)
            BOUNDS(EACH(START, , position_error, undecided_time, velocity_error))
            for (;;) {
                if ((taken < reachable_searching_shots) && ((busy + LANES_SPARE) <= LANES_WIDTH)) {
                    const M idle = lanes_not(active);
                    turns = lanes_select(idle, K(0.0), turns);
                    EACH(EXPAND, reachable_searching_, row, arrival, ceiling, end, extent, flat)
                    EACH(EXPAND, reachable_searching_, high0, high1, last, latest, low0, low1)
                    EACH(EXPAND, reachable_searching_, rate_slack, share, speed, t, tilt, vx, vy)
                    EACH(EXPAND, reachable_searching_, vz, x, y, z)
                    EACH(EXPAND_MASK, reachable_searching_, certain)
                    BOUNDS(EACH(EXPAND, reachable_searching_, position_error, undecided_time))
                    BOUNDS(EACH(EXPAND, reachable_searching_, velocity_error))
                    if (LANES_SELDOM(varying))
                        LOOP(fix_reachable_searching_rows_2)(worklist, taken, idle);
                    const size_t room = LANES_WIDTH - busy;
                    const size_t _left = reachable_searching_shots - taken;
                    active = lanes_leading(idle, _left, active);
                    taken += _left < room ? _left : room;
                    busy += _left < room ? _left : room;
                }
                if (busy == 0)
                    break;
                M searching = active;
                CALL(court_nearby, _nearby_1)(t, flat, tilt, K(2.0), last);
                EACH(GET, _nearby_1, leaving, margin)
                CALL(court_bridge_advance, _bridge_advance_1)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(21), FIXED(16), FIXED(34), FIXED(56), FIXED(79), FIXED(97), FIXED(27));
                EACH(GET, _bridge_advance_1, gap, rate, bend, step, next, clearance)
                CALL(court_gap_closes_or_stalls, _gap_closes_or_stalls_1)(t, end, gap, rate, bend, margin, rate_slack, next, clearance, share);
                EACH(GET_MASK, _gap_closes_or_stalls_1, hit, sure, needs_refinement)
                const M _if_needs_refinement_1 = lanes_both(active, needs_refinement);
                if (lanes_any(_if_needs_refinement_1)) {
                    CALL(court_smaller_budget, _smaller_budget_1)(share);
                    EACH(SELECT, (_if_needs_refinement_1, _smaller_budget_1), share)
                    CALL(court_allowance, _allowance_1)(share, latest, extent, speed, OR_ZERO(position_error), OR_ZERO(velocity_error), FIXED(21));
                    EACH(GET, _allowance_1, position_level, velocity_level)
                    BOUNDS(EACH(GET, _allowance_1, excess))
                    CALL(court_bridge_margins, _bridge_margins_1)(latest, extent, speed, position_level, velocity_level, FIXED(21), FIXED(68), FIXED(97), FIXED(98), FIXED(99), FIXED(100), FIXED(101), FIXED(102), FIXED(103), FIXED(104), FIXED(105), FIXED(106));
                    flat = lanes_select(_if_needs_refinement_1, _bridge_margins_1.margin, flat);
                    tilt = lanes_select(_if_needs_refinement_1, _bridge_margins_1.leaving_margin, tilt);
                    rate_slack = lanes_select(_if_needs_refinement_1, _bridge_margins_1.rate_margin, rate_slack);
#if BOUNDED
                    CALL(court_budget_undecided, _budget_undecided_1)(t, undecided_time, excess);
                    EACH(SELECT, (_if_needs_refinement_1, _budget_undecided_1), undecided_time)
#endif
                }
                CALL(court_advanced, _advanced_1)(t, end, step, next, arrival, hit, sure, needs_refinement, certain);
                EACH(SET, _advanced_1, arrival, certain, searching, t)
                EACH(GET_MASK, _advanced_1, exhausted)
                const M _if_exhausted_1 = lanes_both(active, exhausted);
                {
                    CALL(court_bridge_enter, _bridge_enter_1)(t, end, end, low0, low1, high0, high1);
                    EACH(SELECT, (_if_exhausted_1, _bridge_enter_1), t, end)
                    EACH(SELECT_MASK, (_if_exhausted_1, _bridge_enter_1), searching)
                }
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(searching, lanes_less(turns, K(201.0)))));
                lanes_pack(worklist->reachable_searching_ended_row + done, ended, row);
                lanes_pack(worklist->reachable_searching_ended_arrival + done, ended, arrival);
                lanes_pack(worklist->reachable_searching_ended_certain + done, ended, lanes_select(certain, K(1.0), K(0.0)));
                lanes_pack(worklist->reachable_searching_ended_flat + done, ended, flat);
#if BOUNDED
                lanes_pack(worklist->reachable_searching_ended_searching + done, ended, lanes_select(searching, K(1.0), K(0.0)));
                lanes_pack(worklist->reachable_searching_ended_t + done, ended, t);
#endif
                lanes_pack(worklist->reachable_searching_ended_tilt + done, ended, tilt);
#if BOUNDED
                lanes_pack(worklist->reachable_searching_ended_undecided_time + done, ended, undecided_time);
#endif
                done += popcount(ended);
                busy -= popcount(ended);
                active = lanes_both(active, lanes_not(ended));
            }
            for (size_t k = 0; k < done; k++) {
                const size_t row = (size_t)worklist->reachable_searching_ended_row[k];
                EACH(RETURN, (reachable_, reachable_searching_ended_), arrival, certain, flat, tilt)
                BOUNDS(EACH(RETURN, (reachable_, reachable_searching_ended_), searching, t, undecided_time))
            }
        }
        }
        {
        size_t reachable_refining_shots = 0;
        static const int reachable_refining_taken[] = {0, 3, 9, 8, 10, 1, 2};
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
            const M rows = mask_first_n(reachable_shots - i);
            if (LANES_SELDOM(varying))
#if BOUNDED
                LOOP(fix_reachable_rows_5)(worklist, i);
#else
                LOOP(fix_reachable_rows_4)(worklist, i);
#endif
            EACH(LOAD, reachable_, arrival, ceiling, flat, last, tilt, vx, vy, vz, x, y, z)
            EACH(LOAD_MASK, reachable_, certain)
#if BOUNDED
            EACH(LOAD, reachable_, t, undecided_time)
            EACH(LOAD_MASK, reachable_, searching)
            CALL(court_predicate_undecided, _predicate_undecided_1)(t, undecided_time, searching);
            EACH(SET, _predicate_undecided_1, undecided_time)
#endif
            CALL(court_found, _found_1)(arrival);
            EACH(GET_MASK, _found_1, arrives, refining)
            BOUNDS(EACH(GET, _found_1, rate))
            CALL(court_nearby, _nearby_1)(arrival, flat, tilt, K(2.0), last);
            EACH(GET, _nearby_1, leaving)
            const M _if_refining_1 = lanes_both(rows, refining);
            if (lanes_any(_if_refining_1)) {
                CALL(court_bridge_refine, _bridge_refine_1)(arrival, leaving, x, y, z, vx, vy, vz, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(21), FIXED(34), FIXED(16), FIXED(56));
                V refined = _bridge_refine_1.time;
                EACH(GET, _bridge_refine_1, gap)
#if BOUNDED
                EACH(SELECT, (_if_refining_1, _bridge_refine_1), rate)
#else
                EACH(GET, _bridge_refine_1, rate)
#endif
                CALL(court_refined_return, _refined_return_1)(leaving, gap, rate, ceiling, arrival, refined, certain);
                EACH(SELECT, (_if_refining_1, _refined_return_1), arrival)
                EACH(SELECT_MASK, (_if_refining_1, _refined_return_1), refining)
            }
            const M _if_refining_2 = lanes_both(rows, refining);
            if (lanes_any(_if_refining_2)) {
                CALL(court_bridge_refine, _bridge_refine_2)(arrival, leaving, x, y, z, vx, vy, vz, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(21), FIXED(34), FIXED(16), FIXED(56));
                V refined = _bridge_refine_2.time;
                EACH(GET, _bridge_refine_2, gap)
#if BOUNDED
                EACH(SELECT, (_if_refining_2, _bridge_refine_2), rate)
#else
                EACH(GET, _bridge_refine_2, rate)
#endif
                CALL(court_refined_return, _refined_return_2)(leaving, gap, rate, ceiling, arrival, refined, certain);
                EACH(SELECT, (_if_refining_2, _refined_return_2), arrival)
                EACH(SELECT_MASK, (_if_refining_2, _refined_return_2), refining)
            }
            EACH(STORE, reachable_, arrival)
            EACH(STORE_MASK, reachable_, arrives)
            BOUNDS(EACH(STORE, reachable_, leaving, rate, undecided_time))
            const M packed = lanes_both(rows, refining);
            if (lanes_any(packed)) {
                lanes_pack(worklist->reachable_refining_row + reachable_refining_shots, packed, lanes_add(iota(), K((double)i)));
                EACH(PACK, reachable_refining_, arrival, ceiling, leaving, vx, vy, vz, x, y, z)
                EACH(PACK_MASK, reachable_refining_, certain)
                if (LANES_SELDOM(varying)) {
                    for (size_t _p = 0; _p < 7; _p++) {
                        lanes_pack(worklist->reachable_refining_parameters.columns[reachable_refining_taken[_p]] + reachable_refining_shots, packed, lanes_load(worklist->reachable_parameters.columns[reachable_refining_taken[_p]] + i));
                    }
                }
                reachable_refining_shots += popcount(packed);
            }
        }
        if (reachable_refining_shots) {
            EACH(CLEAR, reachable_refining_, row, arrival, ceiling, certain, leaving, vx, vy, vz, x)
            EACH(CLEAR, reachable_refining_, y, z)
            if (LANES_SELDOM(varying)) {
                for (size_t _p = 0; _p < 7; _p++) {
                    lanes_store(worklist->reachable_refining_parameters.columns[reachable_refining_taken[_p]] + reachable_refining_shots, K(0.0));
                }
            }
        }
        {
            size_t taken = 0;
            size_t done = 0;
            size_t busy = 0;
            EACH(START_MASK, , active, certain)
            EACH(START, , row, turns, arrival, ceiling, leaving, vx, vy, vz, x, y, z)
            for (;;) {
                if ((taken < reachable_refining_shots) && ((busy + LANES_SPARE) <= LANES_WIDTH)) {
                    const M idle = lanes_not(active);
                    turns = lanes_select(idle, K(0.0), turns);
                    EACH(EXPAND, reachable_refining_, row, arrival, ceiling, leaving, vx, vy, vz, x)
                    EACH(EXPAND, reachable_refining_, y, z)
                    EACH(EXPAND_MASK, reachable_refining_, certain)
                    if (LANES_SELDOM(varying))
                        LOOP(fix_reachable_refining_rows_2)(worklist, taken, idle);
                    const size_t room = LANES_WIDTH - busy;
                    const size_t _left = reachable_refining_shots - taken;
                    active = lanes_leading(idle, _left, active);
                    taken += _left < room ? _left : room;
                    busy += _left < room ? _left : room;
                }
                if (busy == 0)
                    break;
                M refining = active;
                CALL(court_bridge_refine, _bridge_refine_1)(arrival, leaving, x, y, z, vx, vy, vz, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(21), FIXED(34), FIXED(16), FIXED(56));
                V refined = _bridge_refine_1.time;
                EACH(GET, _bridge_refine_1, gap, rate)
                CALL(court_refined_return, _refined_return_1)(leaving, gap, rate, ceiling, arrival, refined, certain);
                EACH(SET, _refined_return_1, arrival, refining)
                turns = lanes_add(turns, K(1.0));
                const M ended = lanes_both(active, lanes_not(lanes_both(refining, lanes_less(turns, K(8.0)))));
                lanes_pack(worklist->reachable_refining_ended_row + done, ended, row);
                lanes_pack(worklist->reachable_refining_ended_arrival + done, ended, arrival);
#if BOUNDED
                lanes_pack(worklist->reachable_refining_ended_rate + done, ended, rate);
#endif
                done += popcount(ended);
                busy -= popcount(ended);
                active = lanes_both(active, lanes_not(ended));
            }
            for (size_t k = 0; k < done; k++) {
                const size_t row = (size_t)worklist->reachable_refining_ended_row[k];
                EACH(RETURN, (reachable_, reachable_refining_ended_), arrival)
                BOUNDS(EACH(RETURN, (reachable_, reachable_refining_ended_), rate))
            }
        }
        }
        for (size_t i = 0; i < reachable_shots; i += LANES_WIDTH) {
#if BOUNDED
            if (LANES_SELDOM(varying))
                LOOP(fix_reachable_rows_6)(worklist, i);
#endif
            EACH(LOAD, reachable_, arrival, when, which)
            EACH(LOAD_MASK, reachable_, arrives)
#if BOUNDED
            EACH(LOAD, reachable_, ceiling, earliest_delay, extent, latest, leaving, position_error)
            EACH(LOAD, reachable_, rate, speed, t, undecided_time, velocity_error)
            EACH(LOAD_MASK, reachable_, certain)
            CALL(court_bridge_margins, _bridge_margins_1)(latest, extent, speed, position_error, velocity_error, FIXED(21), FIXED(68), FIXED(97), FIXED(98), FIXED(99), FIXED(100), FIXED(101), FIXED(102), FIXED(103), FIXED(104), FIXED(105), FIXED(106));
            V flat = _bridge_margins_1.margin;
            V tilt = _bridge_margins_1.leaving_margin;
            EACH(GET, _bridge_margins_1, rate_margin)
            CALL(court_own_margin, _own_margin_1)(leaving, flat, tilt, arrival);
            EACH(GET, _own_margin_1, margin)
            CALL(court_crossing, _crossing_1)(margin, rate_margin, rate, ceiling);
            EACH(GET, _crossing_1, clearance, delay)
#endif
            CALL(court_arrival_time, _arrival_time_1)(arrival);
            EACH(GET, _arrival_time_1, time)
#if BOUNDED
            CALL(court_return_certainty, _return_certainty_1)(t, clearance, time, delay, undecided_time, arrives, certain);
            EACH(SET, _return_certainty_1, delay, undecided_time)
            CALL(court_tie_undecided, _tie_undecided_1)(time, when, delay, earliest_delay, undecided_time, arrives);
            EACH(SET, _tie_undecided_1, undecided_time, earliest_delay)
#endif
            CALL(court_earliest, _earliest_1)(K(2.0), time, when, which, arrives);
            EACH(SET, _earliest_1, when, which)
            EACH(STORE, reachable_, when, which)
            BOUNDS(EACH(STORE, reachable_, earliest_delay, undecided_time))
        }
        for (size_t k = 0; k < reachable_shots; k++) {
            const size_t row = (size_t)worklist->reachable_row[k];
            EACH(RETURN, (, reachable_), when, which)
            BOUNDS(EACH(RETURN, (, reachable_), earliest_delay, undecided_time))
        }
        }
        {
        size_t in_contact_shots = 0;
#if BOUNDED
        static const int in_contact_taken[] = {16, 0, 5, 3, 4, 7, 6, 9, 17, 8, 11, 10, 18, 15, 1, 2};
#else
        static const int in_contact_taken[] = {0, 5, 3, 4, 7, 6, 9, 8, 11, 10, 18, 1, 2};
#endif
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = mask_first_n(shots - i);
            EACH(LOAD_MASK, , in_contact, limited)
            const M _if_limited_1 = lanes_both(rows, limited);
            if (lanes_any(_if_limited_1)) {
                EACH(LOAD, , clock, time_error, when, which)
                BOUNDS(EACH(LOAD, , earliest_delay, undecided_time))
                CALL(court_expiry, _expiry_1)(when, which, OR_ZERO(earliest_delay), OR_INFINITE(undecided_time), time_error, clock, time_limit);
                EACH(GET, _expiry_1, time)
                EACH(GET_MASK, _expiry_1, arrives)
#if BOUNDED
                EACH(GET, _expiry_1, delay)
                EACH(SELECT, (_if_limited_1, _expiry_1), undecided_time)
                CALL(court_tie_undecided, _tie_undecided_1)(time, when, delay, earliest_delay, undecided_time, arrives);
                EACH(SELECT, (_if_limited_1, _tie_undecided_1), undecided_time, earliest_delay)
#endif
                CALL(court_earliest, _earliest_1)(K(4.0), time, when, which, arrives);
                EACH(SELECT, (_if_limited_1, _earliest_1), when, which)
                EACH(STORE, , when, which)
                BOUNDS(EACH(STORE, , earliest_delay, undecided_time))
            }
            const M packed = lanes_both(rows, in_contact);
            if (lanes_any(packed)) {
#if !BOUNDED
                EACH(LOAD, , circled, clock, held, last, mode, through, vx, vy, vz, when, wx, wy)
                EACH(LOAD, , wz, x, y, z)
                EACH(LOAD_MASK, , rests)
#endif
                lanes_pack(worklist->in_contact_row + in_contact_shots, packed, lanes_add(iota(), K((double)i)));
#if !BOUNDED
                EACH(PACK, in_contact_, circled, clock, held, last, mode, through, vx, vy, vz, when)
                EACH(PACK, in_contact_, wx, wy, wz, x, y, z)
                EACH(PACK_MASK, in_contact_, rests)
#endif
                if (LANES_SELDOM(varying)) {
#if BOUNDED
                    for (size_t _p = 0; _p < 16; _p++) {
#else
                    for (size_t _p = 0; _p < 13; _p++) {
#endif
                        lanes_pack(worklist->in_contact_parameters.columns[in_contact_taken[_p]] + in_contact_shots, packed, lanes_load(worklist->parameters.columns[in_contact_taken[_p]] + i));
                    }
                }
                in_contact_shots += popcount(packed);
            }
        }
        if (in_contact_shots) {
            EACH(CLEAR, in_contact_, row, circled, clock, held, last, mode, rests, through, vx, vy)
            EACH(CLEAR, in_contact_, vz, when, wx, wy, wz, x, y, z)
            BOUNDS(EACH(CLEAR, in_contact_, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz))
            BOUNDS(EACH(CLEAR, in_contact_, estimated, grip_lost, last_grip_clock, last_grip_deficit))
            BOUNDS(EACH(CLEAR, in_contact_, last_grip_deficit_rate, position_error, velocity_error))
            BOUNDS(EACH(CLEAR_SINGLE, in_contact_, clock_bound, position_bound, spin_bound, velocity_bound))
            if (LANES_SELDOM(varying)) {
#if BOUNDED
                for (size_t _p = 0; _p < 16; _p++) {
#else
                for (size_t _p = 0; _p < 13; _p++) {
#endif
                    lanes_store(worklist->in_contact_parameters.columns[in_contact_taken[_p]] + in_contact_shots, K(0.0));
                }
            }
#if BOUNDED
        }
        for (size_t row = 0; row < in_contact_shots; row++) {
            const size_t k = (size_t)worklist->in_contact_row[row];
            EACH(RETURN, (in_contact_, ), circled, clock, clock_bound, clock_error, dvx, dvy, dvz)
            EACH(RETURN, (in_contact_, ), dwx, dwy, dwz, dx, dy, dz, estimated, grip_lost, held)
            EACH(RETURN, (in_contact_, ), last, last_grip_clock, last_grip_deficit)
            EACH(RETURN, (in_contact_, ), last_grip_deficit_rate, mode, position_bound)
            EACH(RETURN, (in_contact_, ), position_error, rests, spin_bound, through)
            EACH(RETURN, (in_contact_, ), velocity_bound, velocity_error, vx, vy, vz, when, wx, wy)
            EACH(RETURN, (in_contact_, ), wz, x, y, z)
#endif
        }
        if (in_contact_shots)
            LOOP(in_contact)(worklist, in_contact_shots, varying, time_limit);
        for (size_t k = 0; k < in_contact_shots; k++) {
            const size_t row = (size_t)worklist->in_contact_row[k];
            EACH(RETURN, (, in_contact_), began, circled, clock, rests, rolling, through, vx, vy)
            EACH(RETURN, (, in_contact_), vz, when, which, wx, wy, wz, x, y, z)
            BOUNDS(EACH(RETURN, (, in_contact_), dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, earliest_delay))
            BOUNDS(EACH(RETURN, (, in_contact_), grip_lost, last_grip_clock, last_grip_deficit))
            BOUNDS(EACH(RETURN, (, in_contact_), last_grip_deficit_rate, position_error, undecided_time))
            BOUNDS(EACH(RETURN, (, in_contact_), velocity_error))
        }
        }
        {
        size_t slow_shots = 0;
        static const int slow_taken[] = {16, 13, 0, 5, 3, 4, 7, 6, 9, 17, 8, 14, 11, 10, 18, 15, 1, 12, 2};
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = mask_first_n(shots - i);
            if (LANES_SELDOM(varying))
#if BOUNDED
                LOOP(fix_rows_8)(worklist, i);
#else
                LOOP(fix_rows_7)(worklist, i);
#endif
            const V p_ring_friction = lanes_load(worklist->parameters.p_ring_friction + (i & varying));
            const V p_ring_restitution = lanes_load(worklist->parameters.p_ring_restitution + (i & varying));
            EACH(LOAD, , clock, contacts, last, mode, through, vx, vy, vz, when, which, wx, wy, wz)
            EACH(LOAD, , x, y, z)
            EACH(LOAD_MASK, , in_contact, limited)
            BOUNDS(EACH(LOAD, , assured, earliest_delay, extent, position_error, speed, uncertain))
            BOUNDS(EACH(LOAD, , undecided_time, velocity_error))
            CALL(court_departed, _departed_1)(K(3.0), which);
            EACH(GET_MASK, _departed_1, moves, ends, touches)
            EACH(GET, _departed_1, reached)
            BOUNDS(EACH(GET_MASK, _departed_1, edge))
            CALL(court_body_of, _body_of_1)(which);
            EACH(GET, _body_of_1, body)
            const M _if_in_contact_1 = lanes_both(rows, in_contact);
            if (lanes_any(_if_in_contact_1)) {
                CALL(court_nothing_happens_yet, _nothing_happens_yet_1)(body, touches, mode, moves);
                EACH(SELECT_MASK, (_if_in_contact_1, _nothing_happens_yet_1), moves, touches)
                EACH(SELECT, (_if_in_contact_1, _nothing_happens_yet_1), body)
            }
            const M _if_moves_1 = lanes_both(rows, moves);
            if (lanes_any(_if_moves_1)) {
#if BOUNDED
                CALL(court_passing_undecided, _passing_undecided_1)(when, x, y, z, vx, vy, vz, extent, speed, position_error, velocity_error, FIXED(7), FIXED(21), FIXED(34), FIXED(20), FIXED(22), FIXED(37), FIXED(160));
                EACH(GET_MASK, _passing_undecided_1, undecided)
                CALL(court_undecided, _undecided_1)(uncertain, undecided);
                EACH(SELECT, (_if_moves_1, _undecided_1), uncertain)
#endif
                CALL(court_passing, _passing_1)(through, when, x, y, z, vx, vy, vz, FIXED(21), FIXED(34), FIXED(22), FIXED(20), FIXED(19));
                EACH(SELECT, (_if_moves_1, _passing_1), through)
                CALL(court_flight, _flight_1)(when, x, y, z, vx, vy, vz, FIXED(21), FIXED(34));
                EACH(SELECT, (_if_moves_1, _flight_1), x, y, z, vx, vy, vz)
                CALL(court_event_clock, _event_clock_1)(when, clock);
                EACH(SELECT, (_if_moves_1, _event_clock_1), clock)
                EACH(STORE, , through, x, y, z)
            }
            const M _if_limited_1 = lanes_both(rows, limited);
            if (lanes_any(_if_limited_1)) {
                CALL(court_expired, _expired_1)(K(4.0), which, body, clock, reached, time_limit, ends);
                EACH(SELECT, (_if_limited_1, _expired_1), clock, body, reached)
                EACH(SELECT_MASK, (_if_limited_1, _expired_1), ends)
            }
#if BOUNDED
            CALL(court_no_departure, _no_departure_1)();
            EACH(GET_MASK, _no_departure_1, hopped)
#endif
            const M _if_in_contact_2 = lanes_both(rows, in_contact);
            if (lanes_any(_if_in_contact_2)) {
                EACH(LOAD, , began, held, rolls)
                EACH(LOAD_MASK, , rests, rolling)
                CALL(court_stay_in_contact, _stay_in_contact_1)(last, which, OR_INFINITE(undecided_time), body, clock, reached, ends, held, mode, rolls, rolling, began, rests);
                EACH(SELECT, (_if_in_contact_2, _stay_in_contact_1), body, reached, last, mode)
                EACH(SELECT, (_if_in_contact_2, _stay_in_contact_1), held, rolls)
                EACH(SELECT_MASK, (_if_in_contact_2, _stay_in_contact_1), ends)
                BOUNDS(EACH(SELECT, (_if_in_contact_2, _stay_in_contact_1), undecided_time))
                BOUNDS(EACH(SELECT_MASK, (_if_in_contact_2, _stay_in_contact_1), hopped))
                EACH(STORE, , held, mode, rolls)
            }
#if BOUNDED
            CALL(court_displacement, _displacement_1)(earliest_delay, when, extent, speed, position_error, velocity_error, FIXED(21), FIXED(161));
            V slack = _displacement_1.margin;
#endif
            CALL(court_here, _here_1)(K(3.0), which);
            EACH(GET_MASK, _here_1, here)
            const M _if_here_1 = lanes_both(rows, here);
            {
                CALL(court_end_bounds, _end_bounds_1)(x, y, FIXED(7));
                EACH(GET, _end_bounds_1, g0)
                CALL(court_end_reached, _end_reached_1)(through, g0);
                EACH(SELECT, (_if_here_1, _end_reached_1), reached)
#if BOUNDED
                CALL(court_end_edge, _end_edge_1)(slack, through, g0);
                EACH(SELECT_MASK, (_if_here_1, _end_edge_1), edge)
#endif
            }
#if BOUNDED
            CALL(court_contact_undecided, _contact_undecided_1)(last, when, which, earliest_delay, undecided_time, position_error, velocity_error, uncertain, edge, assured);
            EACH(SET, _contact_undecided_1, uncertain)
#endif
            CALL(court_accounted, _accounted_1)(contacts, most_contacts, reached, touches);
            EACH(SET, _accounted_1, contacts)
            EACH(GET, _accounted_1, outcome)
            if (recording) {
                EACH(STORE, , body)
                lanes_store(worklist->x_before + i, x);
                lanes_store(worklist->y_before + i, y);
                lanes_store(worklist->z_before + i, z);
                lanes_store(worklist->vx_before + i, vx);
                lanes_store(worklist->vy_before + i, vy);
                lanes_store(worklist->vz_before + i, vz);
                lanes_store(worklist->wx_before + i, wx);
                lanes_store(worklist->wy_before + i, wy);
                lanes_store(worklist->wz_before + i, wz);
            }
#if BOUNDED
            CALL(court_meeting, _meeting_1)(claims, ends, touches);
#else
            CALL(court_meeting, _meeting_1)(K(0.0), ends, touches);
#endif
            EACH(GET_MASK, _meeting_1, meeting)
            CALL(court_slow_at_start, _slow_at_start_1)(mode);
            EACH(GET_MASK, _slow_at_start_1, slow)
            const M _if_meeting_1 = lanes_both(rows, meeting);
            if (lanes_any(_if_meeting_1)) {
                EACH(LOAD, , count_0, count_1, count_2, first)
                BOUNDS(EACH(LOAD_SINGLE, , clock_bound, frame_nx, frame_ny, frame_nz, left_bend_e))
                BOUNDS(EACH(LOAD_SINGLE, , left_bend_s, left_ex, left_ey, pace_e, pace_n, pace_s, place_e))
                BOUNDS(EACH(LOAD_SINGLE, , place_n, place_s, position_bound, spin_bound, turn_n, turn_z))
                BOUNDS(EACH(LOAD_SINGLE, , velocity_bound))
                BOUNDS(EACH(LOAD, , clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz, estimated))
                CALL(court_end_normal, _end_normal_1)();
                EACH(GET, _end_normal_1, nx, ny, nz)
                CALL(court_here, _here_2)(K(0.0), which);
                EACH(GET_MASK, _here_2, here)
                const M _if_here_2 = lanes_both(_if_meeting_1, here);
                {
                    CALL(court_ring_normal, _ring_normal_1)(x, y, z, FIXED(7), FIXED(107));
                    EACH(SELECT, (_if_here_2, _ring_normal_1), nx, ny, nz)
                    CALL(court_counted, _counted_1)(count_0);
                    count_0 = lanes_select(_if_here_2, _counted_1.count, count_0);
                }
                CALL(court_here, _here_3)(K(1.0), which);
                EACH(SET, _here_3, here)
                const M _if_here_3 = lanes_both(_if_meeting_1, here);
                if (lanes_any(_if_here_3)) {
                    CALL(court_backboard_normal, _backboard_normal_1)(x, y, z, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(15), FIXED(108));
                    EACH(SELECT, (_if_here_3, _backboard_normal_1), nx, ny, nz)
                    CALL(court_counted, _counted_2)(count_1);
                    count_1 = lanes_select(_if_here_3, _counted_2.count, count_1);
                }
                CALL(court_here, _here_4)(K(2.0), which);
                EACH(SET, _here_4, here)
                const M _if_here_4 = lanes_both(_if_meeting_1, here);
                if (lanes_any(_if_here_4)) {
                    CALL(court_bridge_normal, _bridge_normal_1)(x, y, z, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(16), FIXED(108));
                    EACH(SELECT, (_if_here_4, _bridge_normal_1), nx, ny, nz)
                    CALL(court_counted, _counted_3)(count_2);
                    count_2 = lanes_select(_if_here_4, _counted_3.count, count_2);
                }
#if BOUNDED
                CALL(court_elsewhere, _elsewhere_1)();
                EACH(GET, _elsewhere_1, curving)
                CALL(court_other_start_surface, _other_start_surface_1)();
                EACH(GET, _other_start_surface_1, left_nx, left_ny, left_nz)
                CALL(court_again, _again_1)(K(0.0), last, which);
                EACH(GET_MASK, _again_1, again)
                const M _if_again_1 = lanes_both(_if_meeting_1, again);
                if (lanes_any(_if_again_1)) {
                    CALL(court_ring_curvature, _ring_curvature_1)(FIXED(162));
                    curving = lanes_select(_if_again_1, _ring_curvature_1.curvature, curving);
                    CALL(court_started, _started_1)(x, y, z, vx, vy, vz, when, FIXED(34));
                    EACH(GET, _started_1, from_x, from_y, from_z)
                    CALL(court_ring_normal, _ring_normal_2)(from_x, from_y, from_z, FIXED(7), FIXED(107));
                    left_nx = lanes_select(_if_again_1, _ring_normal_2.nx, left_nx);
                    left_ny = lanes_select(_if_again_1, _ring_normal_2.ny, left_ny);
                    left_nz = lanes_select(_if_again_1, _ring_normal_2.nz, left_nz);
                }
                CALL(court_again, _again_2)(K(1.0), last, which);
                EACH(SET, _again_2, again)
                const M _if_again_2 = lanes_both(_if_meeting_1, again);
                if (lanes_any(_if_again_2)) {
                    CALL(court_backboard_curvature, _backboard_curvature_1)(when, x, y, z, vx, vy, vz, dx, dy, dz, dvx, dvy, dvz, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(21), FIXED(15), FIXED(110));
                    curving = lanes_select(_if_again_2, _backboard_curvature_1.curvature, curving);
                    CALL(court_started, _started_2)(x, y, z, vx, vy, vz, when, FIXED(34));
                    EACH(GET, _started_2, from_x, from_y, from_z)
                    CALL(court_backboard_normal, _backboard_normal_2)(from_x, from_y, from_z, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(15), FIXED(108));
                    left_nx = lanes_select(_if_again_2, _backboard_normal_2.nx, left_nx);
                    left_ny = lanes_select(_if_again_2, _backboard_normal_2.ny, left_ny);
                    left_nz = lanes_select(_if_again_2, _backboard_normal_2.nz, left_nz);
                }
                CALL(court_again, _again_3)(K(2.0), last, which);
                EACH(SET, _again_3, again)
                const M _if_again_3 = lanes_both(_if_meeting_1, again);
                if (lanes_any(_if_again_3)) {
                    CALL(court_bridge_curvature, _bridge_curvature_1)(when, x, y, z, vx, vy, vz, dx, dy, dz, dvx, dvy, dvz, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(21), FIXED(16), FIXED(110));
                    curving = lanes_select(_if_again_3, _bridge_curvature_1.curvature, curving);
                    CALL(court_started, _started_3)(x, y, z, vx, vy, vz, when, FIXED(34));
                    EACH(GET, _started_3, from_x, from_y, from_z)
                    CALL(court_bridge_normal, _bridge_normal_2)(from_x, from_y, from_z, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(16), FIXED(108));
                    left_nx = lanes_select(_if_again_3, _bridge_normal_2.nx, left_nx);
                    left_ny = lanes_select(_if_again_3, _bridge_normal_2.ny, left_ny);
                    left_nz = lanes_select(_if_again_3, _bridge_normal_2.nz, left_nz);
                }
                CALL(court_carry_flight, _carry_flight_1)(when, x, y, z, vx, vy, vz, nx, ny, nz, clock, contacts, earliest_delay, dx, dy, dz, dvx, dvy, dvz, left_nx, left_ny, left_nz, curving, FIXED(21));
                EACH(SELECT, (_if_meeting_1, _carry_flight_1), dx, dy, dz)
                EACH(GET, _carry_flight_1, lifting)
                EACH(SELECT, (_if_meeting_1, _carry_flight_1), dvx, dvy, dvz)
                V belated = _carry_flight_1.delay;
                EACH(GET, _carry_flight_1, shift)
                CALL(court_clock_error_sum, _clock_error_sum_1)(belated, clock_error);
                EACH(SELECT, (_if_meeting_1, _clock_error_sum_1), clock_error)
                const M _if_ends_1 = lanes_both(_if_meeting_1, ends);
                {
                    CALL(court_error_floor, _error_floor_1)(dx, dy, dz, shift);
                    EACH(SELECT, (_if_ends_1, _error_floor_1), dx, dy, dz)
                }
                CALL(court_no_normal_error, _no_normal_error_1)();
                EACH(GET, _no_normal_error_1, dnx, dny, dnz, turn)
                CALL(court_normal_velocity, _normal_velocity_1)(vx, vy, vz, nx, ny, nz);
                EACH(GET, _normal_velocity_1, normal_velocity)
                CALL(court_came_back, _came_back_1)(last, which);
                EACH(GET, _came_back_1, back)
                CALL(court_end_tangents, _end_tangents_1)(lanes_narrow(when), lanes_narrow(z), lanes_narrow(vz), FIXED_SINGLE(20));
                EACH(GET_SINGLE, _end_tangents_1, tangent_x, tangent_y, bend_s, bend_e)
                EACH(GET_SINGLE, _end_tangents_1, sharpest_bend, root_offset, root_level)
                EACH(GET_SINGLE, _end_tangents_1, normal_rounding)
                CALL(court_here, _here_5)(K(0.0), which);
                EACH(SET, _here_5, here)
                const M _if_here_5 = lanes_both(_if_meeting_1, here);
                if (lanes_any(_if_here_5)) {
                    CALL(court_ring_tangents, _ring_tangents_1)(lanes_narrow(when), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(nx), lanes_narrow(ny), lanes_narrow(nz), place_n, lanes_narrow(normal_velocity), lanes_narrow(back), FIXED_SINGLE(0), FIXED_SINGLE(10), FIXED_SINGLE(26), FIXED_SINGLE(27), FIXED_SINGLE(28), FIXED_SINGLE(29), FIXED_SINGLE(20), FIXED_SINGLE(30), FIXED_SINGLE(31), FIXED_SINGLE(32));
                    EACH(SELECT_SINGLE, (_if_here_5, _ring_tangents_1), tangent_x, tangent_y)
                    EACH(SELECT_SINGLE, (_if_here_5, _ring_tangents_1), bend_s, bend_e)
                    EACH(SELECT_SINGLE, (_if_here_5, _ring_tangents_1), sharpest_bend, root_offset)
                    EACH(SELECT_SINGLE, (_if_here_5, _ring_tangents_1), root_level, normal_rounding)
                }
                CALL(court_here, _here_6)(K(1.0), which);
                EACH(SET, _here_6, here)
                const M _if_here_6 = lanes_both(_if_meeting_1, here);
                if (lanes_any(_if_here_6)) {
                    CALL(court_backboard_tangents, _backboard_tangents_1)(lanes_narrow(when), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(nx), lanes_narrow(ny), lanes_narrow(nz), place_n, lanes_narrow(normal_velocity), lanes_narrow(back), FIXED_SINGLE(33), FIXED_SINGLE(34), FIXED_SINGLE(35), FIXED_SINGLE(36), FIXED_SINGLE(37), FIXED_SINGLE(0), FIXED_SINGLE(38), FIXED_SINGLE(39), FIXED_SINGLE(40), FIXED_SINGLE(41), FIXED_SINGLE(42), FIXED_SINGLE(43), FIXED_SINGLE(44), FIXED_SINGLE(20), FIXED_SINGLE(45), FIXED_SINGLE(46));
                    EACH(SELECT_SINGLE, (_if_here_6, _backboard_tangents_1), tangent_x, tangent_y)
                    EACH(SELECT_SINGLE, (_if_here_6, _backboard_tangents_1), bend_s, bend_e)
                    EACH(SELECT_SINGLE, (_if_here_6, _backboard_tangents_1), sharpest_bend)
                    EACH(SELECT_SINGLE, (_if_here_6, _backboard_tangents_1), root_offset)
                    EACH(SELECT_SINGLE, (_if_here_6, _backboard_tangents_1), root_level)
                    EACH(SELECT_SINGLE, (_if_here_6, _backboard_tangents_1), normal_rounding)
                }
                CALL(court_here, _here_7)(K(2.0), which);
                EACH(SET, _here_7, here)
                const M _if_here_7 = lanes_both(_if_meeting_1, here);
                if (lanes_any(_if_here_7)) {
                    CALL(court_bridge_tangents, _bridge_tangents_1)(lanes_narrow(when), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(nx), lanes_narrow(ny), lanes_narrow(nz), place_n, lanes_narrow(normal_velocity), lanes_narrow(back), FIXED_SINGLE(33), FIXED_SINGLE(19), FIXED_SINGLE(47), FIXED_SINGLE(34), FIXED_SINGLE(48), FIXED_SINGLE(0), FIXED_SINGLE(49), FIXED_SINGLE(38), FIXED_SINGLE(50), FIXED_SINGLE(51), FIXED_SINGLE(41), FIXED_SINGLE(52), FIXED_SINGLE(20), FIXED_SINGLE(53), FIXED_SINGLE(45), FIXED_SINGLE(46));
                    EACH(SELECT_SINGLE, (_if_here_7, _bridge_tangents_1), tangent_x, tangent_y)
                    EACH(SELECT_SINGLE, (_if_here_7, _bridge_tangents_1), bend_s, bend_e)
                    EACH(SELECT_SINGLE, (_if_here_7, _bridge_tangents_1), sharpest_bend)
                    EACH(SELECT_SINGLE, (_if_here_7, _bridge_tangents_1), root_offset, root_level)
                    EACH(SELECT_SINGLE, (_if_here_7, _bridge_tangents_1), normal_rounding)
                }
                CALL(court_proves, _proves_1)(ends, touches, estimated);
                EACH(GET_MASK, _proves_1, proves_contact, proves_end)
                const M _if_proves_end_1 = lanes_both(_if_meeting_1, proves_end);
                if (lanes_any(_if_proves_end_1)) {
                    CALL(court_bound_end, _bound_end_1)(lanes_narrow(when), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(clock), position_bound, velocity_bound, spin_bound, root_offset, lanes_narrow(normal_velocity), FIXED_SINGLE(0), FIXED_SINGLE(20));
                    EACH(SELECT_SINGLE, (_if_proves_end_1, _bound_end_1), position_bound)
                    EACH(SELECT_SINGLE, (_if_proves_end_1, _bound_end_1), velocity_bound)
                    EACH(SELECT_SINGLE, (_if_proves_end_1, _bound_end_1), spin_bound)
                    S proved_delay = _bound_end_1.delay;
                    CALL(court_clock_bound_sum, _clock_bound_sum_1)(proved_delay, clock_bound);
                    EACH(SELECT_SINGLE, (_if_proves_end_1, _clock_bound_sum_1), clock_bound)
                }
                CALL(court_here, _here_8)(K(0.0), which);
                EACH(SET, _here_8, here)
                const M _if_here_8 = lanes_both(_if_meeting_1, here);
                if (lanes_any(_if_here_8)) {
                    CALL(court_ring_carry_normal, _ring_carry_normal_1)(x, y, dx, dy, dz, shift, FIXED(7), FIXED(107), FIXED(162));
                    EACH(SELECT, (_if_here_8, _ring_carry_normal_1), dnx, dny, dnz, turn)
                }
                CALL(court_here, _here_9)(K(1.0), which);
                EACH(SET, _here_9, here)
                const M _if_here_9 = lanes_both(_if_meeting_1, here);
                if (lanes_any(_if_here_9)) {
                    CALL(court_backboard_carry_normal, _backboard_carry_normal_1)(x, y, z, dx, dy, dz, shift, FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(15), FIXED(108), FIXED(110));
                    EACH(SELECT, (_if_here_9, _backboard_carry_normal_1), dnx, dny, dnz, turn)
                }
                CALL(court_here, _here_10)(K(2.0), which);
                EACH(SET, _here_10, here)
                const M _if_here_10 = lanes_both(_if_meeting_1, here);
                if (lanes_any(_if_here_10)) {
                    CALL(court_bridge_carry_normal, _bridge_carry_normal_1)(x, y, z, dx, dy, dz, shift, FIXED(7), FIXED(8), FIXED(9), FIXED(13), FIXED(16), FIXED(108), FIXED(110));
                    EACH(SELECT, (_if_here_10, _bridge_carry_normal_1), dnx, dny, dnz, turn)
                }
#endif
                CALL(court_other_kind, _other_kind_1)();
                M struck_0 = _other_kind_1.of_this_kind;
                CALL(court_ring_impact_taken, _ring_impact_taken_1)(p_ring_restitution, p_ring_friction);
                V its_0_ring_impact = _ring_impact_taken_1.its_0;
                V its_1_ring_impact = _ring_impact_taken_1.its_1;
                {
#if BOUNDED
                    static const int _t3[][2] = {
#else
                    static const int _t1[][2] = {
#endif
                        {15, 12},
                        {16, 13},
                        {17, 14},
                    };
#if BOUNDED
                    static const double _t4[][1] = {
#else
                    static const double _t2[][1] = {
#endif
                        {0.0},
                        {1.0},
                        {2.0},
                    };
#if BOUNDED
                    for (size_t _k2 = 0; _k2 < 3; _k2++) {
                        const V own_1 = lanes_load(worklist->parameters.columns[_t3[_k2][0]] + (i & varying));
                        const V own_2 = lanes_load(worklist->parameters.columns[_t3[_k2][1]] + (i & varying));
                        const V own_index = K(_t4[_k2][0]);
                        CALL(court_here, _here_11)(own_index, which);
                        EACH(GET_MASK, _here_11, here)
                        const M _if_here_11 = lanes_both(_if_meeting_1, here);
                        if (lanes_any(_if_here_11)) {
#else
                    for (size_t _k1 = 0; _k1 < 3; _k1++) {
                        const V own_1 = lanes_load(worklist->parameters.columns[_t1[_k1][0]] + (i & varying));
                        const V own_2 = lanes_load(worklist->parameters.columns[_t1[_k1][1]] + (i & varying));
                        const V own_index = K(_t2[_k1][0]);
                        CALL(court_here, _here_5)(own_index, which);
                        EACH(GET_MASK, _here_5, here)
                        const M _if_here_5 = lanes_both(_if_meeting_1, here);
                        if (lanes_any(_if_here_5)) {
#endif
                            CALL(court_ring_impact_taken, _ring_impact_taken_2)(own_2, own_1);
#if BOUNDED
                            struck_0 = lanes_choose(_if_here_11, _ring_impact_taken_2.of_this_kind, struck_0);
                            its_0_ring_impact = lanes_select(_if_here_11, _ring_impact_taken_2.its_0, its_0_ring_impact);
                            its_1_ring_impact = lanes_select(_if_here_11, _ring_impact_taken_2.its_1, its_1_ring_impact);
#else
                            struck_0 = lanes_choose(_if_here_5, _ring_impact_taken_2.of_this_kind, struck_0);
                            its_0_ring_impact = lanes_select(_if_here_5, _ring_impact_taken_2.its_0, its_0_ring_impact);
                            its_1_ring_impact = lanes_select(_if_here_5, _ring_impact_taken_2.its_1, its_1_ring_impact);
#endif
                        }
                    }
                }
                const M _if_struck_0_1 = lanes_both(_if_meeting_1, struck_0);
                if (lanes_any(_if_struck_0_1)) {
#if BOUNDED
                    const M _if_proves_contact_1 = lanes_both(_if_struck_0_1, proves_contact);
                    if (LANES_USUAL(_if_proves_contact_1)) {
                        CALL(court_ring_impact_slip, _ring_impact_slip_1)(vx, vy, vz, wx, wy, wz, nx, ny, nz, its_0_ring_impact, its_1_ring_impact, FIXED(6), FIXED(163), FIXED(164), FIXED(165));
                        EACH(GET, _ring_impact_slip_1, slip_share, slip_margin, slip_speed, slip_x)
                        EACH(GET, _ring_impact_slip_1, slip_y, slip_z)
                        CALL(court_bound_ring_impact, _bound_ring_impact_1)(lanes_narrow(when), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(wx), lanes_narrow(wy), lanes_narrow(wz), lanes_narrow(nx), lanes_narrow(ny), lanes_narrow(nz), lanes_narrow(clock), frame_nx, frame_ny, frame_nz, place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound, spin_bound, tangent_x, tangent_y, bend_s, bend_e, left_ex, left_ey, left_bend_s, left_bend_e, sharpest_bend, root_offset, root_level, normal_rounding, lanes_narrow(normal_velocity), lanes_narrow(back), lanes_narrow(slip_share), lanes_narrow(slip_margin), lanes_narrow(slip_speed), lanes_narrow(slip_x), lanes_narrow(slip_y), lanes_narrow(slip_z), lanes_narrow(its_0_ring_impact), lanes_narrow(its_1_ring_impact), FIXED_SINGLE(33), FIXED_SINGLE(0), FIXED_SINGLE(54), FIXED_SINGLE(20), FIXED_SINGLE(55), FIXED_SINGLE(56), FIXED_SINGLE(57), FIXED_SINGLE(58), FIXED_SINGLE(59), FIXED_SINGLE(38), FIXED_SINGLE(60), FIXED_SINGLE(61));
                        EACH(SELECT_SINGLE, (_if_proves_contact_1, _bound_ring_impact_1), place_n)
                        EACH(SELECT_SINGLE, (_if_proves_contact_1, _bound_ring_impact_1), place_s)
                        EACH(SELECT_SINGLE, (_if_proves_contact_1, _bound_ring_impact_1), place_e)
                        EACH(SELECT_SINGLE, (_if_proves_contact_1, _bound_ring_impact_1), pace_n)
                        EACH(SELECT_SINGLE, (_if_proves_contact_1, _bound_ring_impact_1), pace_s)
                        EACH(SELECT_SINGLE, (_if_proves_contact_1, _bound_ring_impact_1), pace_e)
                        EACH(SELECT_SINGLE, (_if_proves_contact_1, _bound_ring_impact_1), turn_n)
                        EACH(SELECT_SINGLE, (_if_proves_contact_1, _bound_ring_impact_1), turn_z)
                        EACH(SELECT_SINGLE, (_if_proves_contact_1, _bound_ring_impact_1), position_bound)
                        EACH(SELECT_SINGLE, (_if_proves_contact_1, _bound_ring_impact_1), velocity_bound)
                        EACH(SELECT_SINGLE, (_if_proves_contact_1, _bound_ring_impact_1), spin_bound)
                        frame_nx = singles_select(singles_of(_if_proves_contact_1), _bound_ring_impact_1.left_nx, frame_nx);
                        frame_ny = singles_select(singles_of(_if_proves_contact_1), _bound_ring_impact_1.left_ny, frame_ny);
                        frame_nz = singles_select(singles_of(_if_proves_contact_1), _bound_ring_impact_1.left_nz, frame_nz);
                        EACH(SELECT_SINGLE, (_if_proves_contact_1, _bound_ring_impact_1), left_ex)
                        EACH(SELECT_SINGLE, (_if_proves_contact_1, _bound_ring_impact_1), left_ey)
                        EACH(SELECT_SINGLE, (_if_proves_contact_1, _bound_ring_impact_1), left_bend_s)
                        EACH(SELECT_SINGLE, (_if_proves_contact_1, _bound_ring_impact_1), left_bend_e)
                        S proved_delay = _bound_ring_impact_1.delay;
                        CALL(court_clock_bound_sum, _clock_bound_sum_2)(proved_delay, clock_bound);
                        EACH(SELECT_SINGLE, (_if_proves_contact_1, _clock_bound_sum_2), clock_bound)
                    }
                    CALL(court_ring_impact_undecided, _ring_impact_undecided_1)(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, turn, its_0_ring_impact, its_1_ring_impact, FIXED(6), FIXED(163), FIXED(164));
                    EACH(GET_MASK, _ring_impact_undecided_1, undecided)
                    CALL(court_undecided, _undecided_2)(uncertain, undecided);
                    EACH(SELECT, (_if_struck_0_1, _undecided_2), uncertain)
                    CALL(court_carry_ring_impact, _carry_ring_impact_1)(vx, vy, vz, wx, wy, wz, nx, ny, nz, dvx, dvy, dvz, dwx, dwy, dwz, dnx, dny, dnz, turn, lifting, its_0_ring_impact, its_1_ring_impact, FIXED(6), FIXED(163), FIXED(164), FIXED(165), FIXED(166), FIXED(110));
                    EACH(SELECT, (_if_struck_0_1, _carry_ring_impact_1), dvx, dvy, dvz, dwx, dwy)
                    EACH(SELECT, (_if_struck_0_1, _carry_ring_impact_1), dwz)
#endif
                    CALL(court_ring_impact, _ring_impact_1)(vx, vy, vz, wx, wy, wz, nx, ny, nz, its_0_ring_impact, its_1_ring_impact, FIXED(6), FIXED(163), FIXED(164), FIXED(165), FIXED(166));
                    EACH(SELECT, (_if_struck_0_1, _ring_impact_1), vx, vy, vz, wx, wy, wz)
                }
                const M _if_touches_1 = lanes_both(_if_meeting_1, touches);
                {
#if BOUNDED
                    CALL(court_estimated_after_contact, _estimated_after_contact_1)(vx, vy, vz, nx, ny, nz, lanes_wide(position_bound), lanes_wide(velocity_bound), lanes_wide(spin_bound), estimated, FIXED(167));
                    EACH(SELECT, (_if_touches_1, _estimated_after_contact_1), estimated)
                }
                const M _if_touches_2 = lanes_both(_if_meeting_1, touches);
                {
#endif
                    CALL(court_touched, _touched_1)(which, body, first);
#if BOUNDED
                    EACH(SELECT, (_if_touches_2, _touched_1), first, last)
#else
                    EACH(SELECT, (_if_touches_1, _touched_1), first, last)
#endif
                    CALL(court_leaves_slowly, _leaves_slowly_1)(nx, ny, nz, vx, vy, vz, OR_ZERO(position_error), FIXED(6), FIXED(21), FIXED(168), FIXED(169));
#if BOUNDED
                    EACH(SELECT_MASK, (_if_touches_2, _leaves_slowly_1), slow)
                    EACH(SELECT, (_if_touches_2, _leaves_slowly_1), assured)
#else
                    EACH(SELECT_MASK, (_if_touches_1, _leaves_slowly_1), slow)
#endif
                }
                EACH(STORE, , count_0, count_1, count_2, first, wx, wy, wz)
                BOUNDS(EACH(STORE, , assured, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz))
                BOUNDS(EACH(STORE, , estimated))
                BOUNDS(EACH(STORE_SINGLE, , clock_bound, frame_nx, frame_ny, frame_nz, left_bend_e))
                BOUNDS(EACH(STORE_SINGLE, , left_bend_s, left_ex, left_ey, pace_e, pace_n, pace_s, place_e))
                BOUNDS(EACH(STORE_SINGLE, , place_n, place_s, position_bound, spin_bound, turn_n, turn_z))
                BOUNDS(EACH(STORE_SINGLE, , velocity_bound))
            }
            EACH(STORE, , clock, contacts, last, outcome, vx, vy, vz)
            BOUNDS(EACH(STORE, , uncertain))
            BOUNDS(EACH(STORE_MASK, , hopped))
            const M packed = lanes_both(rows, slow);
            if (lanes_any(packed)) {
                EACH(LOAD, , held, slip_left)
                BOUNDS(EACH(LOAD_SINGLE, , clock_bound, position_bound, spin_bound, velocity_bound))
                BOUNDS(EACH(LOAD, , clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz))
                lanes_pack(worklist->slow_row + slow_shots, packed, lanes_add(iota(), K((double)i)));
                EACH(PACK, slow_, held, mode, outcome, slip_left, vx, vy, vz, which, wx, wy, wz, x)
                EACH(PACK, slow_, y, z)
                BOUNDS(EACH(PACK, slow_, assured, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz))
                BOUNDS(EACH(PACK, slow_, uncertain))
                BOUNDS(EACH(PACK_SINGLE, slow_, clock_bound, position_bound, spin_bound, velocity_bound))
                if (LANES_SELDOM(varying)) {
                    for (size_t _p = 0; _p < 19; _p++) {
                        lanes_pack(worklist->slow_parameters.columns[slow_taken[_p]] + slow_shots, packed, lanes_load(worklist->parameters.columns[slow_taken[_p]] + i));
                    }
                }
                slow_shots += popcount(packed);
            }
        }
        if (slow_shots) {
            EACH(CLEAR, slow_, row, held, mode, outcome, slip_left, vx, vy, vz, which, wx, wy, wz)
            EACH(CLEAR, slow_, x, y, z)
            BOUNDS(EACH(CLEAR, slow_, assured, clock_error, dvx, dvy, dvz, dwx, dwy, dwz, dx, dy, dz))
            BOUNDS(EACH(CLEAR, slow_, uncertain))
            BOUNDS(EACH(CLEAR_SINGLE, slow_, clock_bound, position_bound, spin_bound, velocity_bound))
            if (LANES_SELDOM(varying)) {
                for (size_t _p = 0; _p < 19; _p++) {
                    lanes_store(worklist->slow_parameters.columns[slow_taken[_p]] + slow_shots, K(0.0));
                }
            }
        }
        if (slow_shots)
            LOOP(slow)(worklist, slow_shots, varying);
        for (size_t k = 0; k < slow_shots; k++) {
            const size_t row = (size_t)worklist->slow_row[k];
            EACH(RETURN, (, slow_), held, mode, outcome, slip_left, vx, vy, vz, x, y, z)
            BOUNDS(EACH(RETURN, (, slow_), assured, dvx, dvy, dvz, dx, dy, dz, estimated, uncertain))
        }
#if BOUNDED
        }
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = mask_first_n(shots - i);
            if (LANES_SELDOM(varying))
                LOOP(fix_rows_9)(worklist, i);
            EACH(LOAD_SINGLE, , clock_bound, position_bound, spin_bound, velocity_bound)
            EACH(LOAD, , clock_error, dvx, dvy, dvz, dx, dy, dz, outcome)
            EACH(LOAD_MASK, , hopped, limited)
            const M _if_limited_1 = lanes_both(rows, limited);
            if (lanes_any(_if_limited_1)) {
                EACH(LOAD, , clock, vx, vy, vz, when, which, x, y, z)
                CALL(court_ends_by_time_limit, _ends_by_time_limit_1)(K(4.0), which, claims);
                EACH(GET_MASK, _ends_by_time_limit_1, ends_by_time_limit)
                const M _if_ends_by_time_limit_1 = lanes_both(_if_limited_1, ends_by_time_limit);
                if (lanes_any(_if_ends_by_time_limit_1)) {
                    CALL(court_carry_time, _carry_time_1)(when, x, y, z, vx, vy, vz, clock, clock_error, dx, dy, dz, dvx, dvy, dvz, FIXED(21), FIXED(80));
                    EACH(SELECT, (_if_ends_by_time_limit_1, _carry_time_1), dx, dy, dz, dvx, dvy)
                    EACH(SELECT, (_if_ends_by_time_limit_1, _carry_time_1), dvz, clock_error)
                    CALL(court_bound_time, _bound_time_1)(lanes_narrow(when), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(clock), position_bound, velocity_bound, spin_bound, clock_bound, FIXED_SINGLE(0), FIXED_SINGLE(20));
                    EACH(SELECT_SINGLE, (_if_ends_by_time_limit_1, _bound_time_1), position_bound)
                    EACH(SELECT_SINGLE, (_if_ends_by_time_limit_1, _bound_time_1), velocity_bound)
                    EACH(SELECT_SINGLE, (_if_ends_by_time_limit_1, _bound_time_1), spin_bound)
                    EACH(SELECT_SINGLE, (_if_ends_by_time_limit_1, _bound_time_1), clock_bound)
                }
                EACH(STORE_SINGLE, , clock_bound, position_bound, spin_bound, velocity_bound)
                EACH(STORE, , clock_error, dvx, dvy, dvz)
            }
            const M _if_hopped_1 = lanes_both(rows, hopped);
            if (lanes_any(_if_hopped_1)) {
                EACH(LOAD, , vx, vy, vz, when, x, y, z)
                CALL(court_carry_hop, _carry_hop_1)(x, y, z, vx, vy, vz, dx, dy, dz, dvx, dvy, dvz, when);
                EACH(SELECT, (_if_hopped_1, _carry_hop_1), dx, dy, dz)
            }
            CALL(court_closing, _closing_1)(outcome, claims);
            EACH(GET_MASK, _closing_1, reports)
            EACH(GET, _closing_1, position_claim, velocity_claim, spin_claim, time_claim)
            const M _if_reports_1 = lanes_both(rows, reports);
            if (lanes_any(_if_reports_1)) {
                EACH(LOAD, , dwx, dwy, dwz, estimated)
                CALL(court_claimed_errors, _claimed_errors_1)(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz, lanes_wide(position_bound), lanes_wide(velocity_bound), lanes_wide(spin_bound), estimated, lanes_wide(clock_bound));
                position_claim = lanes_select(_if_reports_1, _claimed_errors_1.position_error, position_claim);
                velocity_claim = lanes_select(_if_reports_1, _claimed_errors_1.velocity_error, velocity_claim);
                spin_claim = lanes_select(_if_reports_1, _claimed_errors_1.spin_error, spin_claim);
                time_claim = lanes_select(_if_reports_1, _claimed_errors_1.time_error, time_claim);
            }
            EACH(STORE, , dx, dy, dz, position_claim, spin_claim, time_claim, velocity_claim)
#endif
        }
        if (recording)
            for (size_t k = 0; k < shots; k++) {
                if (worklist->body[k] < 0.0)
                    continue;
                const size_t shot = (size_t)worklist->shot[k], rows = COURT_LOG_ROWS * (size_t)job->max_contacts + 1;
                const size_t place = shot * rows + (size_t)job->results->event_counts[shot]++;
                court_event *event = job->results->events + place;
                const int64_t body = (int64_t)worklist->body[k], staying = body - COURT_SURFACES - 1;
                event->shot = (int64_t)shot;
                event->surface = staying < 0 ? body : staying / 2;
                event->kind = staying < -1 ? COURT_EVENT_IMPACT : staying < 0 ? COURT_EVENT_END : staying % 2 ? COURT_EVENT_LEAVE : COURT_EVENT_ROLL;
                event->time = worklist->clock[k];
                event->before[0] = worklist->x_before[k];
                event->after[0] = worklist->x[k];
                event->before[1] = worklist->y_before[k];
                event->after[1] = worklist->y[k];
                event->before[2] = worklist->z_before[k];
                event->after[2] = worklist->z[k];
                event->before[3] = worklist->vx_before[k];
                event->after[3] = worklist->vx[k];
                event->before[4] = worklist->vy_before[k];
                event->after[4] = worklist->vy[k];
                event->before[5] = worklist->vz_before[k];
                event->after[5] = worklist->vz[k];
                event->before[6] = worklist->wx_before[k];
                event->after[6] = worklist->wx[k];
                event->before[7] = worklist->wy_before[k];
                event->after[7] = worklist->wy[k];
                event->before[8] = worklist->wz_before[k];
                event->after[8] = worklist->wz[k];
#if BOUNDED
                if (job->results->event_errors) {
                    court_event_errors *errors = job->results->event_errors + place;
                    errors->time_error = worklist->time_claim[k];
                    errors->state_error[0] = worklist->position_claim[k];
                    errors->state_error[1] = worklist->velocity_claim[k];
                    errors->state_error[2] = worklist->spin_claim[k];
                }
#endif
            }

        M going = mask_none();
        for (size_t i = 0; i < shots; i += LANES_WIDTH)
            going = lanes_either(going, lanes_both(mask_first_n(shots - i), lanes_less(lanes_load(worklist->outcome + i), K(0.0))));
        if (following && !lanes_any(going)) {
            LOOP(finish_all)(worklist, shots, job);
            shots = 0;
            streams = 1;
            continue;
        }
        streams = 0;
        shots = LOOP(leave)(worklist, 0, shots, job);
    }
}

/* Run the job with shots in flight in memory of their own; return 0 if there is none. */
static int LOOP(run_allocated)(const court_job *job)
{
    /* Not on the stack: they may be megabytes, and threads have little of it. */
    void *const room = malloc(sizeof(LOOP(worklist)) + 63);
    if (room == NULL)
        return 0;
    LOOP(run)(job, (void *)(((uintptr_t)room + 63) / 64 * 64));
    free(room);
    return 1;
}

