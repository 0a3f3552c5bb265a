/* The event loop of the scene hoop, with or without bounds on errors.

   Generated from templates/c/loop.h.j2, scene hoop, derivation d045c64f80c6d78c,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Included by hoop_engine.h twice, BOUNDED being 1 where errors are bounded, else 0. The path is
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
    LANES(singles_column) left_nx; /* of the frame of the last contact */
    LANES(singles_column) left_ny; /* of the frame of the last contact */
    LANES(singles_column) left_nz; /* of the frame of the last contact */
    LANES(singles_column) left_ex; /* of the frame of the last contact */
    LANES(singles_column) left_ey; /* of the frame of the last contact */
    LANES(singles_column) left_bend_s; /* of the frame of the last contact */
    LANES(singles_column) left_bend_e; /* of the frame of the last contact */
    LANES(singles_column) origin_s; /* to tighten bounds on errors */
    LANES(singles_column) origin_e; /* to tighten bounds on errors */
    LANES(singles_column) origin_u; /* to tighten bounds on errors */
    LANES(singles_column) origin_v; /* to tighten bounds on errors */
    LANES(singles_column) origin_w; /* to tighten bounds on errors */
    LANES(singles_column) origin_t; /* to tighten bounds on errors */
    LANES(singles_column) product_11; /* to tighten bounds on errors */
    LANES(singles_column) product_12; /* to tighten bounds on errors */
    LANES(singles_column) product_13; /* to tighten bounds on errors */
    LANES(singles_column) product_14; /* to tighten bounds on errors */
    LANES(singles_column) product_15; /* to tighten bounds on errors */
    LANES(singles_column) product_16; /* to tighten bounds on errors */
    LANES(singles_column) product_21; /* to tighten bounds on errors */
    LANES(singles_column) product_22; /* to tighten bounds on errors */
    LANES(singles_column) product_23; /* to tighten bounds on errors */
    LANES(singles_column) product_24; /* to tighten bounds on errors */
    LANES(singles_column) product_25; /* to tighten bounds on errors */
    LANES(singles_column) product_26; /* to tighten bounds on errors */
    LANES(singles_column) product_31; /* to tighten bounds on errors */
    LANES(singles_column) product_32; /* to tighten bounds on errors */
    LANES(singles_column) product_33; /* to tighten bounds on errors */
    LANES(singles_column) product_34; /* to tighten bounds on errors */
    LANES(singles_column) product_35; /* to tighten bounds on errors */
    LANES(singles_column) product_36; /* to tighten bounds on errors */
    LANES(singles_column) product_41; /* to tighten bounds on errors */
    LANES(singles_column) product_42; /* to tighten bounds on errors */
    LANES(singles_column) product_43; /* to tighten bounds on errors */
    LANES(singles_column) product_44; /* to tighten bounds on errors */
    LANES(singles_column) product_45; /* to tighten bounds on errors */
    LANES(singles_column) product_46; /* to tighten bounds on errors */
    LANES(singles_column) product_51; /* to tighten bounds on errors */
    LANES(singles_column) product_52; /* to tighten bounds on errors */
    LANES(singles_column) product_53; /* to tighten bounds on errors */
    LANES(singles_column) product_54; /* to tighten bounds on errors */
    LANES(singles_column) product_55; /* to tighten bounds on errors */
    LANES(singles_column) product_56; /* to tighten bounds on errors */
    LANES(singles_column) product_61; /* to tighten bounds on errors */
    LANES(singles_column) product_62; /* to tighten bounds on errors */
    LANES(singles_column) product_63; /* to tighten bounds on errors */
    LANES(singles_column) product_64; /* to tighten bounds on errors */
    LANES(singles_column) product_65; /* to tighten bounds on errors */
    LANES(singles_column) product_66; /* to tighten bounds on errors */
    LANES(singles_column) recent_s; /* to tighten bounds on errors */
    LANES(singles_column) recent_e; /* to tighten bounds on errors */
    LANES(singles_column) recent_u; /* to tighten bounds on errors */
    LANES(singles_column) recent_v; /* to tighten bounds on errors */
    LANES(singles_column) recent_w; /* to tighten bounds on errors */
    LANES(singles_column) recent_t; /* to tighten bounds on errors */
    LANES(singles_column) continued; /* to tighten bounds on errors */
#endif
    LANES(column) clock; /* time of the last event, s since the release */
#if BOUNDED
    LANES(singles_column) clock_error; /* what the contacts' times were off by, summed */
#endif
    LANES(column) last; /* surface that was touched last, -1: none */
    LANES(column) first; /* body that was touched first, -1: none */
    LANES(column) contacts; /* how many contacts there were */
    LANES(column) count_0; /* contacts with ring */
    LANES(column) count_1; /* contacts with backboard */
    LANES(column) count_2; /* contacts with bridge */
#if BOUNDED
    LANES(column) uncertain; /* 1: a decision lies within its rounding-error bound */
    LANES(singles_column) position_claim; /* bound on the error at the last event */
    LANES(singles_column) velocity_claim; /* bound on the error at the last event */
    LANES(singles_column) spin_claim; /* bound on the error at the last event */
    LANES(singles_column) time_claim; /* bound on the error at the last event */
#endif
    LANES(column) outcome; /* how it ended, -1: in flight */
#if BOUNDED
    /* Shots that have ended, and whose bounds on errors may be tightened. */
    size_t loose_shots;
    double loose_shot[LANES_LOOSE + LANES_WIDTH];
    int tightening; /* whether those in flight are such shots: they are simulated again */
#endif
    LANES(hoop_parameters) parameters, stepping_parameters, searching_parameters, searching_searching_parameters, refining_parameters;
    LANES(column) x_before, y_before, z_before, vx_before, vy_before, vz_before, wx_before, wy_before, wz_before;
    LANES(column) arrival, arrives, body, ceiling, certain, extent, flat, limited, open, permitted,
        refining_arrival, refining_ceiling, refining_certain, refining_ended_arrival,
        refining_ended_row, refining_leaving, refining_refining, refining_rho_start, refining_row,
        refining_vx, refining_vy, refining_vz, refining_x, refining_y, refining_z, rho_start,
        searching, searching_arrival, searching_ceiling, searching_certain, searching_extent,
        searching_flat, searching_last, searching_rho_start, searching_row,
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
        since, single_precision, speed, stepping_ended_certain, stepping_ended_row, stepping_row,
        stepping_stepping, tilt, turning_p_ball_radius, turning_p_gravity, turning_p_ring_radius,
        turning_p_wire_radius, until, when, which;
    LANES(singles_column) short_t, stepping_ended_short_t, stepping_short_ceiling, stepping_short_end,
        stepping_short_energy2, stepping_short_flat, stepping_short_high1, stepping_short_high2,
        stepping_short_jerk, stepping_short_low1, stepping_short_low2, stepping_short_moment2,
        stepping_short_quotient_margin, stepping_short_rate_margin, stepping_short_rho_rate,
        stepping_short_rho_start, stepping_short_start_rate, stepping_short_t, stepping_short_tilt,
        stepping_short_vx, stepping_short_vy, stepping_short_vz, stepping_short_x, stepping_short_y,
        stepping_short_z, time_error;
#if BOUNDED
    LANES(column) earliest_delay, latest, leaving, pad, rate, refining_ended_rate, searching_latest,
        searching_searching, searching_searching_ended_searching, searching_searching_ended_t,
        searching_searching_ended_undecided_time, searching_searching_undecided_time,
        searching_undecided_time, undecided_time;
    LANES(singles_column) position_error, searching_position_error, searching_searching_position_error,
        searching_searching_velocity_error, searching_velocity_error, velocity_error;
#endif
    /* What kernels make of parameters alone. */
    _Alignas(64) double fixed[LANES_ROWS][LANES_WIDTH];
    _Alignas(64) float fixed_single[LANES_ROWS][LANES_WIDTH];
} LOOP(worklist);

/* Look at the parameters of a row of lanes. */
LANES_INLINE void LOOP(permitted)(LOOP(worklist) *worklist, size_t row)
{
    lanes_store(worklist->permitted + row, lanes_select(LANES(hoop_validate)(worklist->parameters.columns, row), K(1.0), K(0.0)));
}

/* Have zeros in the lanes behind the last row, which are computed with, too: not what memory held. */
LANES_INLINE void LOOP(fill)(LOOP(worklist) *worklist, size_t row, int varying)
{
    EACH(FILL, , x, y, z, vx, vy, vz, wx, wy, wz, clock, first, contacts, count_0, count_1, count_2)
    EACH(FILL, , outcome, last, shot)
#if BOUNDED
    EACH(FILL, , uncertain)
    EACH(FILL_SINGLE, , place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z)
    EACH(FILL_SINGLE, , position_bound, velocity_bound, spin_bound, left_nx, left_ny, left_nz)
    EACH(FILL_SINGLE, , left_ex, left_ey, left_bend_s, left_bend_e, clock_error, position_claim)
    EACH(FILL_SINGLE, , velocity_claim, spin_claim, time_claim)
    if (worklist->tightening) {
        EACH(FILL_SINGLE, , origin_s, origin_e, origin_u, origin_v, origin_w, origin_t, product_11)
        EACH(FILL_SINGLE, , product_12, product_13, product_14, product_15, product_16, product_21)
        EACH(FILL_SINGLE, , product_22, product_23, product_24, product_25, product_26, product_31)
        EACH(FILL_SINGLE, , product_32, product_33, product_34, product_35, product_36, product_41)
        EACH(FILL_SINGLE, , product_42, product_43, product_44, product_45, product_46, product_51)
        EACH(FILL_SINGLE, , product_52, product_53, product_54, product_55, product_56, product_61)
        EACH(FILL_SINGLE, , product_62, product_63, product_64, product_65, product_66, recent_s)
        EACH(FILL_SINGLE, , recent_e, recent_u, recent_v, recent_w, recent_t, continued)
    }
#endif
    if (varying) {
        for (int p = 0; p < HOOP_PARAMETERS; p++)
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
    lanes_columns(columns, states, HOOP_STATE, wanted);
}

/* Have counters of events at zero for the shots from one on. */
LANES_INLINE void LOOP(reset)(const hoop_job *job, size_t start, size_t shots)
{
    if (job->results->events)
        memset(job->results->event_counts + start, 0, shots * sizeof(int32_t));
}

/* Have the fields of the shots in rows from one on as at a release. */
LANES_INLINE void LOOP(begin_fields)(LOOP(worklist) *worklist, size_t row, size_t shots)
{
    for (size_t k = 0; k < shots; k += LANES_WIDTH) {
        BOUNDS(EACH(BEGIN_SINGLE, KS(0.0), place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n))
        BOUNDS(EACH(BEGIN_SINGLE, KS(0.0), turn_z, position_bound, velocity_bound, spin_bound, left_nx))
        BOUNDS(EACH(BEGIN_SINGLE, KS(0.0), left_ny, left_nz, left_ex, left_ey, left_bend_s, left_bend_e))
        EACH(BEGIN, K(0.0), clock)
        BOUNDS(EACH(BEGIN_SINGLE, KS(0.0), clock_error))
        EACH(BEGIN, K(-1.0), first)
        EACH(BEGIN, K(0.0), contacts, count_0, count_1, count_2)
        BOUNDS(EACH(BEGIN, K(0.0), uncertain))
        BOUNDS(EACH(BEGIN_SINGLE, KS(0.0), position_claim, velocity_claim, spin_claim, time_claim))
        EACH(BEGIN, K(-1.0), outcome, last)
#if BOUNDED
        if (worklist->tightening) {
            EACH(BEGIN_SINGLE, KS(0.0), origin_s, origin_e, origin_u, origin_v, origin_w, origin_t)
            EACH(BEGIN_SINGLE, KS(0.0), product_11, product_12, product_13, product_14, product_15)
            EACH(BEGIN_SINGLE, KS(0.0), product_16, product_21, product_22, product_23, product_24)
            EACH(BEGIN_SINGLE, KS(0.0), product_25, product_26, product_31, product_32, product_33)
            EACH(BEGIN_SINGLE, KS(0.0), product_34, product_35, product_36, product_41, product_42)
            EACH(BEGIN_SINGLE, KS(0.0), product_43, product_44, product_45, product_46, product_51)
            EACH(BEGIN_SINGLE, KS(0.0), product_52, product_53, product_54, product_55, product_56)
            EACH(BEGIN_SINGLE, KS(0.0), product_61, product_62, product_63, product_64, product_65)
            EACH(BEGIN_SINGLE, KS(0.0), product_66, recent_s, recent_e, recent_u, recent_v)
            EACH(BEGIN_SINGLE, KS(0.0), recent_w, recent_t, continued)
        }
#endif
    }
}

/* Put the next shots into rows, from one on. */
LANES_INLINE void LOOP(begin)(LOOP(worklist) *worklist, size_t row, size_t shots, const hoop_job *job, size_t start)
{
    const double *state = job->states + HOOP_STATE * start;
    size_t k = 0;
    LOOP(fill)(worklist, row + shots, job->varying);
    for (; k + LANES_WIDTH <= shots; k += LANES_WIDTH)
        LOOP(load)(worklist, row + k, state + HOOP_STATE * k, HOOP_STATE);
    for (; k < shots; k++) {
        worklist->x[row + k] = state[HOOP_STATE * k + 0];
        worklist->y[row + k] = state[HOOP_STATE * k + 1];
        worklist->z[row + k] = state[HOOP_STATE * k + 2];
        worklist->vx[row + k] = state[HOOP_STATE * k + 3];
        worklist->vy[row + k] = state[HOOP_STATE * k + 4];
        worklist->vz[row + k] = state[HOOP_STATE * k + 5];
        worklist->wx[row + k] = state[HOOP_STATE * k + 6];
        worklist->wy[row + k] = state[HOOP_STATE * k + 7];
        worklist->wz[row + k] = state[HOOP_STATE * k + 8];
    }
    if (job->varying)
        for (int p = 0; p < HOOP_PARAMETERS; p++)
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
#if BOUNDED
}

/* Put shots whose bounds may be tightened into rows, from one on; return how many. */
static size_t LOOP(begin_again)(LOOP(worklist) *worklist, size_t row, const hoop_job *job)
{
    const size_t room = LANES_SHOTS - row, left = worklist->loose_shots;
    const size_t shots = left < room ? left : room, from = left - shots;
    LOOP(fill)(worklist, row + shots, job->varying);
    for (size_t k = 0; k < shots; k++) {
        const size_t shot = (size_t)worklist->loose_shot[from + k];
        const double *state = job->states + HOOP_STATE * shot;
        worklist->shot[row + k] = (double)shot;
        if (job->results->event_errors)
            job->results->event_counts[shot] = 0;
        worklist->x[row + k] = state[0];
        worklist->y[row + k] = state[1];
        worklist->z[row + k] = state[2];
        worklist->vx[row + k] = state[3];
        worklist->vy[row + k] = state[4];
        worklist->vz[row + k] = state[5];
        worklist->wx[row + k] = state[6];
        worklist->wy[row + k] = state[7];
        worklist->wz[row + k] = state[8];
        if (job->varying)
            for (int p = 0; p < HOOP_PARAMETERS; p++)
                worklist->parameters.columns[p][row + k] = job->parameters[p][job->strides[p] * (int64_t)shot];
    }
    if (job->varying)
        for (size_t k = 0; k < shots; k += LANES_WIDTH)
            LOOP(permitted)(worklist, row + k);
    LOOP(begin_fields)(worklist, row, shots);
    if (job->leaving)
        for (size_t k = 0; k < shots; k++)
            worklist->last[row + k] = (double)job->leaving[(size_t)worklist->shot[row + k]];
    worklist->loose_shots = from;
    return shots;
#endif
}


/* Write the results of the shots in rows that follow one another, none of them invalid. */
LANES_INLINE void LOOP(finish_all)(const LOOP(worklist) *worklist, size_t shots, const hoop_job *job)
{
    const hoop_results *out = job->results;
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
        double rows[HOOP_STATE * LANES_WIDTH];
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
            double *const to = out->state + HOOP_STATE * (start + k);
            if (some < LANES_WIDTH || !lanes_stream(to, columns, HOOP_STATE)) {
                lanes_rows(rows, columns, HOOP_STATE);
                stream(to, rows, HOOP_STATE * some);
            }
        }
    }
#if BOUNDED
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
#endif
}

/* Write the results of the shot in a row. */
LANES_INLINE void LOOP(finish)(const LOOP(worklist) *worklist, size_t row, const hoop_job *job)
{
    const hoop_results *out = job->results;
    const size_t shot = (size_t)worklist->shot[row];
    const int invalid = (int)worklist->outcome[row] == HOOP_OUTCOME_INVALID;
    if (out->outcome && !TIGHTENING) {
        out->outcome[shot] = (uint8_t)worklist->outcome[row];
    }
    if (out->contacts && !TIGHTENING) {
        out->contacts[shot] = (int32_t)worklist->contacts[row];
    }
    if (out->counts && !TIGHTENING) {
        out->counts[3 * shot + 0] = (int32_t)worklist->count_0[row];
        out->counts[3 * shot + 1] = (int32_t)worklist->count_1[row];
        out->counts[3 * shot + 2] = (int32_t)worklist->count_2[row];
    }
    if (out->first && !TIGHTENING) {
        out->first[shot] = (int8_t)worklist->first[row];
    }
    if (out->time && !TIGHTENING) {
        out->time[shot] = invalid ? NAN : worklist->clock[row];
    }
    if (out->state && !TIGHTENING) {
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
#if BOUNDED
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
}

/* Remember those shots of a row of lanes that are over, and whose bounds may be tightened. */
LANES_INLINE void LOOP(review)(LOOP(worklist) *worklist, size_t i, M over)
{
    if (worklist->tightening)
        return;
    const V contacts = lanes_load(worklist->contacts + i);
    const V outcome = lanes_load(worklist->outcome + i);
    const V uncertain = lanes_load(worklist->uncertain + i);
    CALL(hoop_loose, _loose_1)(contacts, outcome, uncertain);
    EACH(GET_MASK, _loose_1, loose)
    const M twice = lanes_both(over, loose);
    if (lanes_any(twice)) {
        lanes_pack(worklist->loose_shot + worklist->loose_shots, twice, lanes_load(worklist->shot + i));
        worklist->loose_shots += popcount(twice);
    }
#endif
}

/* Write the results of the shots that have ended, from a row on; the others close up. */
LANES_INLINE size_t LOOP(leave)(LOOP(worklist) *worklist, size_t start, size_t shots, const hoop_job *job)
{
    size_t kept = start, ended = 0;
    /* How many of a row have ended is hardly predictable, so one loop is over those of all rows. */
    for (size_t i = start; i < shots; i += LANES_WIDTH) {
        const M going = lanes_less(lanes_load(worklist->outcome + i), K(0.0));
        const M over = lanes_both(mask_first_n(shots - i), lanes_not(going));
        lanes_pack(worklist->finished + ended, over, lanes_add(iota(), K((double)i)));
        ended += popcount(over);
#if BOUNDED
        LOOP(review)(worklist, i, over);
#endif
    }
    for (size_t k = 0; k < ended; k++)
        LOOP(finish)(worklist, (size_t)worklist->finished[k], job);
    for (size_t i = start; i < shots; i += LANES_WIDTH) {
        const M rows = mask_first_n(shots - i);
        M going = lanes_both(rows, lanes_less(lanes_load(worklist->outcome + i), K(0.0)));
        if (kept < i || lanes_bits(going) != lanes_bits(rows)) {
            lanes_pack(worklist->shot + kept, going, lanes_load(worklist->shot + i));
            EACH(KEEP, , x, y, z, vx, vy, vz, wx, wy, wz, clock, last, contacts)
            BOUNDS(EACH(KEEP, , uncertain))
            BOUNDS(EACH(KEEP_SINGLE, , place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z))
            BOUNDS(EACH(KEEP_SINGLE, , position_bound, velocity_bound, spin_bound, left_nx, left_ny))
            BOUNDS(EACH(KEEP_SINGLE, , left_nz, left_ex, left_ey, left_bend_s, left_bend_e, clock_error))
            if (job->results->first) {
                EACH(KEEP, , first)
            }
            if (job->results->counts) {
                EACH(KEEP, , count_0, count_1, count_2)
#if BOUNDED
            }
            if (worklist->tightening) {
                EACH(KEEP_SINGLE, , origin_s, origin_e, origin_u, origin_v, origin_w, origin_t)
                EACH(KEEP_SINGLE, , product_11, product_12, product_13, product_14, product_15)
                EACH(KEEP_SINGLE, , product_16, product_21, product_22, product_23, product_24)
                EACH(KEEP_SINGLE, , product_25, product_26, product_31, product_32, product_33)
                EACH(KEEP_SINGLE, , product_34, product_35, product_36, product_41, product_42)
                EACH(KEEP_SINGLE, , product_43, product_44, product_45, product_46, product_51)
                EACH(KEEP_SINGLE, , product_52, product_53, product_54, product_55, product_56)
                EACH(KEEP_SINGLE, , product_61, product_62, product_63, product_64, product_65)
                EACH(KEEP_SINGLE, , product_66, recent_s, recent_e, recent_u, recent_v, recent_w)
                EACH(KEEP_SINGLE, , recent_t, continued)
#endif
            }
            if (job->varying)
                for (int p = 0; p < HOOP_PARAMETERS; p++)
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
    const V p_board_top = lanes_load(worklist->parameters.p_board_top);
    const V p_bridge_half_width = lanes_load(worklist->parameters.p_bridge_half_width);
    const V p_end_depth = lanes_load(worklist->parameters.p_end_depth);
    const V p_gravity = lanes_load(worklist->parameters.p_gravity);
    const V p_restitution = lanes_load(worklist->parameters.p_restitution);
    const V p_ring_radius = lanes_load(worklist->parameters.p_ring_radius);
    const V p_wire_radius = lanes_load(worklist->parameters.p_wire_radius);
    {
        const V _s9 = lanes_abs(p_board_bottom);
        const V _s10 = lanes_abs(p_board_top);
        const V _s21 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s9, _s10), lanes_abs(p_ball_radius)), lanes_abs(p_ring_radius)), lanes_abs(p_wire_radius)), lanes_abs(p_board_distance)), lanes_abs(p_board_half_width));
        const V _s27 = lanes_add(lanes_add(p_ball_radius, p_ring_radius), p_wire_radius);
        const V _s28 = lanes_sub(p_ball_radius, p_board_distance);
        const V _s30 = lanes_mul(K(2.0), p_ball_radius);
        const V _s32 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s35 = lanes_mul(K(2.0), p_wire_radius);
        const V _s43 = lanes_div(K(1.0), p_gravity);
        const V _s46 = lanes_neg(p_gravity);
        const V _s47 = lanes_neg(_s43);
        const V _s54 = lanes_mul(K(6.667843360785852e-16), p_ball_radius);
        const V _s64 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(_s27, p_board_distance), p_board_half_width), p_bridge_half_width), p_end_depth), _s9), _s10);
        const V _s78 = lanes_mul(K(1.00006103515625), _s32);
        const V _s79 = lanes_add(p_ring_radius, _s78);
        const V _s84 = lanes_mul(_s79, _s79);
        const V _s85 = lanes_mul(K(9.313225746154785e-10), _s84);
        const V _s90 = lanes_sub(p_ring_radius, _s78);
        const V _s92 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s93 = lanes_max(_s90, _s92);
        const V _s94 = lanes_mul(_s93, _s93);
        const V _s100 = lanes_div(_s78, _s93);
        const V _s104 = lanes_div(K(1.0), _s93);
        FIX(0, p_board_distance);
        FIX(1, lanes_add(lanes_add(_s21, lanes_abs(p_bridge_half_width)), lanes_abs(p_end_depth)));
        FIX(2, _s27); FIX(3, _s28); FIX(4, lanes_sub(_s28, _s30)); FIX(5, p_ball_radius);
        FIX(6, p_ring_radius); FIX(7, p_wire_radius); FIX(8, p_board_half_width);
        FIX(9, p_board_bottom); FIX(10, p_board_top); FIX(11, p_bridge_half_width); FIX(12, _s32);
        FIX(13, lanes_mul(_s32, _s32)); FIX(14, lanes_sub(lanes_sub(_s32, _s30), _s35));
        FIX(15, lanes_add(lanes_mul(K(4.0), p_ball_radius), lanes_mul(K(4.0), p_wire_radius)));
        FIX(16, _s43); FIX(17, p_gravity); FIX(18, lanes_neg(p_end_depth));
        FIX(19, lanes_mul(K(2.0), p_gravity)); FIX(20, _s46); FIX(21, _s47);
        FIX(22, lanes_mul(K(0.5), _s47)); FIX(23, lanes_mul(K(6.667843360785852e-16), p_end_depth));
        FIX(24, lanes_mul(p_bridge_half_width, p_bridge_half_width));
        FIX(25, lanes_neg(p_board_distance));
        FIX(26, lanes_add(_s54, lanes_mul(K(8.890457814381136e-16), p_board_distance)));
        FIX(27, lanes_mul(K(0.5), p_gravity)); FIX(28, _s64);
        FIX(29, lanes_add(_s54, lanes_mul(K(6.667843360785852e-16), p_wire_radius)));
        FIX(30, lanes_mul(K(0.5), lanes_abs(_s46)));
        FIX(31, lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s32)));
        FIX(32, lanes_mul(K(1.52587890625e-05), p_ball_radius));
        FIX(33, lanes_mul(K(1.52587890625e-05), p_wire_radius)); FIX(34, _s78);
        FIX(35, lanes_mul(K(5.820766091346741e-11), _s79)); FIX(36, lanes_mul(K(65536.0), _s79));
        FIX(37, _s84); FIX(38, _s85); FIX(39, lanes_mul(K(4.0), p_gravity));
        FIX(40, lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s32)); FIX(41, _s94);
        FIX(42, lanes_mul(_s93, _s94)); FIX(43, lanes_mul(K(2.0), p_ring_radius));
        FIX(44, lanes_add(_s85, _s94)); FIX(45, lanes_mul(K(8.940696716308594e-08), _s79));
        FIX(46, lanes_max(K(1.0), _s100)); FIX(47, lanes_sqrt(K(2.0)));
        FIX(48, lanes_add(_s30, _s35)); FIX(49, lanes_mul(_s104, lanes_mul(_s104, _s104)));
        FIX(50, _s79); FIX(51, lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s32), _s79));
        FIX(52, lanes_mul(K(5.00030517578125), _s32)); FIX(53, lanes_mul(K(6.0), p_gravity));
        FIX(54, lanes_mul(K(9.094947017729282e-13), _s79)); FIX(55, _s93);
        FIX(56, lanes_div(K(1.0), _s32)); FIX(57, p_restitution);
        FIX(58, lanes_mul(K(0.4), p_ball_radius)); FIX(59, lanes_div(K(1.0), p_ball_radius));
    }
    {
        const S _p_ball_radius = lanes_narrow(p_ball_radius);
        const S _p_ring_radius = lanes_narrow(p_ring_radius);
        const S _p_wire_radius = lanes_narrow(p_wire_radius);
        const S _p_gravity = lanes_narrow(p_gravity);
        const S _p_restitution = lanes_narrow(p_restitution);
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
        const S _s81 = singles_add(KS(0.6), _p_restitution);
        const S _s85 = singles_div(KS(1.0), _p_ball_radius);
        const S _s88 = singles_mul(KS(1.00048828125), _s11);
        const S _s91 = singles_mul(KS(0.00048828125), _s11);
        const S _s97 = singles_sub(_s13, _s91);
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
        FIX_SINGLE(33, _p_ball_radius); FIX_SINGLE(34, _p_restitution);
        FIX_SINGLE(35, singles_abs(KS(0.0))); FIX_SINGLE(36, _s81);
        FIX_SINGLE(37, singles_mul(KS(0.4), _p_ball_radius));
        FIX_SINGLE(38, singles_mul(KS(2.0), _s81)); FIX_SINGLE(39, _s85);
        FIX_SINGLE(40, singles_mul(KS(0.6), _s85)); FIX_SINGLE(41, singles_mul(_s88, _s88));
        FIX_SINGLE(42, singles_add(_s7, _s91));
        FIX_SINGLE(43, singles_sub(singles_sub(_p_ring_radius, singles_mul(KS(1.4143014047294855), _s6)), _s91));
        FIX_SINGLE(44, _s97); FIX_SINGLE(45, singles_mul(_s97, _s97));
        FIX_SINGLE(46, singles_mul(KS(128.0), _s11));
        FIX_SINGLE(47, singles_mul(KS(1.52587890625e-05), _s11));
    }
}

/* What is rarely done: apart, so that it takes no registers from what is done often. */

LANES_APART void LOOP(fix_rows_1)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, , p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width)
    EACH(PARAMETER, , p_board_top, p_bridge_half_width, p_end_depth, p_ring_radius, p_wire_radius)
    {
        const V _s19 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_abs(p_board_bottom), lanes_abs(p_board_top)), lanes_abs(p_ball_radius)), lanes_abs(p_ring_radius)), lanes_abs(p_wire_radius)), lanes_abs(p_board_distance));
        const V _s28 = lanes_sub(p_ball_radius, p_board_distance);
        const V _s30 = lanes_mul(K(2.0), p_ball_radius);
        const V _s32 = lanes_add(p_ball_radius, p_wire_radius);
        FIX(0, p_board_distance);
        FIX(1, lanes_add(lanes_add(lanes_add(_s19, lanes_abs(p_board_half_width)), lanes_abs(p_bridge_half_width)), lanes_abs(p_end_depth)));
        FIX(2, lanes_add(lanes_add(p_ball_radius, p_ring_radius), p_wire_radius)); FIX(3, _s28);
        FIX(4, lanes_sub(_s28, _s30)); FIX(5, p_ball_radius); FIX(6, p_ring_radius);
        FIX(7, p_wire_radius); FIX(8, p_board_half_width); FIX(9, p_board_bottom);
        FIX(10, p_board_top); FIX(11, p_bridge_half_width); FIX(12, _s32);
        FIX(13, lanes_mul(_s32, _s32));
        FIX(14, lanes_sub(lanes_sub(_s32, _s30), lanes_mul(K(2.0), p_wire_radius)));
        FIX(15, lanes_add(lanes_mul(K(4.0), p_ball_radius), lanes_mul(K(4.0), p_wire_radius)));
    }
}

LANES_APART void LOOP(fix_rows_2)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, , p_ball_radius, p_board_bottom, p_board_distance, p_board_half_width)
    EACH(PARAMETER, , p_board_top, p_bridge_half_width, p_end_depth, p_gravity, p_ring_radius)
    EACH(PARAMETER, , p_wire_radius)
    {
        const V _s32 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s43 = lanes_div(K(1.0), p_gravity);
#if BOUNDED
        const V _s46 = lanes_neg(p_gravity);
#endif
        const V _s47 = lanes_neg(_s43);
#if BOUNDED
        const V _s54 = lanes_mul(K(6.667843360785852e-16), p_ball_radius);
        const V _s62 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(p_ball_radius, p_ring_radius), p_wire_radius), p_board_distance), p_board_half_width), p_bridge_half_width), p_end_depth);
#endif
        const V _s78 = lanes_mul(K(1.00006103515625), _s32);
        const V _s79 = lanes_add(p_ring_radius, _s78);
        const V _s84 = lanes_mul(_s79, _s79);
        const V _s85 = lanes_mul(K(9.313225746154785e-10), _s84);
        const V _s90 = lanes_sub(p_ring_radius, _s78);
        const V _s92 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s93 = lanes_max(_s90, _s92);
        const V _s94 = lanes_mul(_s93, _s93);
        FIX(0, p_board_distance); FIX(3, lanes_sub(p_ball_radius, p_board_distance));
        FIX(6, p_ring_radius); FIX(8, p_board_half_width); FIX(9, p_board_bottom);
        FIX(10, p_board_top); FIX(11, p_bridge_half_width); FIX(12, _s32);
        FIX(13, lanes_mul(_s32, _s32)); FIX(16, _s43); FIX(17, p_gravity);
        FIX(18, lanes_neg(p_end_depth)); FIX(19, lanes_mul(K(2.0), p_gravity));
#if BOUNDED
        FIX(20, _s46);
#else
        FIX(20, lanes_neg(p_gravity));
#endif
        FIX(21, _s47); FIX(22, lanes_mul(K(0.5), _s47));
#if BOUNDED
        FIX(23, lanes_mul(K(6.667843360785852e-16), p_end_depth));
#endif
        FIX(24, lanes_mul(p_bridge_half_width, p_bridge_half_width));
        FIX(25, lanes_neg(p_board_distance));
#if BOUNDED
        FIX(26, lanes_add(_s54, lanes_mul(K(8.890457814381136e-16), p_board_distance)));
#endif
        FIX(27, lanes_mul(K(0.5), p_gravity));
#if BOUNDED
        FIX(28, lanes_add(lanes_add(_s62, lanes_abs(p_board_bottom)), lanes_abs(p_board_top)));
        FIX(29, lanes_add(_s54, lanes_mul(K(6.667843360785852e-16), p_wire_radius)));
        FIX(30, lanes_mul(K(0.5), lanes_abs(_s46)));
#endif
        FIX(31, lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s32)));
        FIX(32, lanes_mul(K(1.52587890625e-05), p_ball_radius));
        FIX(33, lanes_mul(K(1.52587890625e-05), p_wire_radius)); FIX(34, _s78);
        FIX(35, lanes_mul(K(5.820766091346741e-11), _s79)); FIX(36, lanes_mul(K(65536.0), _s79));
        FIX(37, _s84); FIX(38, _s85); FIX(39, lanes_mul(K(4.0), p_gravity));
        FIX(40, lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s32)); FIX(41, _s94);
        FIX(42, lanes_mul(_s93, _s94)); FIX(43, lanes_mul(K(2.0), p_ring_radius));
        FIX(44, lanes_add(_s85, _s94));
    }
}

LANES_APART void LOOP(fix_rows_3)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, , p_ball_radius, p_gravity, p_ring_radius, p_wire_radius)
    {
#if BOUNDED
        const V _s32 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s78 = lanes_mul(K(1.00006103515625), _s32);
        const V _s90 = lanes_sub(p_ring_radius, _s78);
        const V _s92 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s100 = lanes_div(_s78, lanes_max(_s90, _s92));
#endif
        FIX(6, p_ring_radius);
#if BOUNDED
        FIX(16, lanes_div(K(1.0), p_gravity));
#endif
        FIX(17, p_gravity); FIX(27, lanes_mul(K(0.5), p_gravity));
#if BOUNDED
        FIX(31, lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s32)));
        FIX(32, lanes_mul(K(1.52587890625e-05), p_ball_radius));
        FIX(33, lanes_mul(K(1.52587890625e-05), p_wire_radius)); FIX(34, _s78);
        FIX(45, lanes_mul(K(8.940696716308594e-08), lanes_add(p_ring_radius, _s78)));
        FIX(46, lanes_max(K(1.0), _s100)); FIX(47, lanes_sqrt(K(2.0)));
        FIX(48, lanes_add(lanes_mul(K(2.0), p_ball_radius), lanes_mul(K(2.0), p_wire_radius)));
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
        const V _s32 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s78 = lanes_mul(K(1.00006103515625), _s32);
        const V _s79 = lanes_add(p_ring_radius, _s78);
        const V _s90 = lanes_sub(p_ring_radius, _s78);
        const V _s92 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s93 = lanes_max(_s90, _s92);
        const V _s100 = lanes_div(_s78, _s93);
        const V _s104 = lanes_div(K(1.0), _s93);
        FIX(16, lanes_div(K(1.0), p_gravity)); FIX(17, p_gravity);
        FIX(19, lanes_mul(K(2.0), p_gravity));
        FIX(31, lanes_sub(lanes_mul(K(0.000244140625), p_ring_radius), lanes_sub(p_ring_radius, _s32)));
        FIX(32, lanes_mul(K(1.52587890625e-05), p_ball_radius));
        FIX(33, lanes_mul(K(1.52587890625e-05), p_wire_radius)); FIX(34, _s78);
        FIX(37, lanes_mul(_s79, _s79)); FIX(39, lanes_mul(K(4.0), p_gravity));
        FIX(40, lanes_mul(lanes_mul(K(6.0003662109375), p_gravity), _s32));
        FIX(41, lanes_mul(_s93, _s93)); FIX(43, lanes_mul(K(2.0), p_ring_radius));
        FIX(46, lanes_max(K(1.0), _s100)); FIX(47, lanes_sqrt(K(2.0)));
        FIX(48, lanes_add(lanes_mul(K(2.0), p_ball_radius), lanes_mul(K(2.0), p_wire_radius)));
        FIX(49, lanes_mul(_s104, lanes_mul(_s104, _s104))); FIX(50, _s79);
        FIX(51, lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s32), _s79));
        FIX(52, lanes_mul(K(5.00030517578125), _s32));
    }
}

LANES_APART void LOOP(fix_searching_searching_rows_1)(LOOP(worklist) *worklist, size_t taken, M idle)
{
    EACH(PARAMETER_TAKEN, searching_searching_, p_ball_radius, p_gravity, p_ring_radius)
    EACH(PARAMETER_TAKEN, searching_searching_, p_wire_radius)
    EACH(TURNING, turning_, p_ball_radius, p_gravity, p_ring_radius, p_wire_radius)
    {
        const V _s32 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s78 = lanes_mul(K(1.00006103515625), _s32);
        const V _s79 = lanes_add(p_ring_radius, _s78);
        const V _s90 = lanes_sub(p_ring_radius, _s78);
        const V _s92 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s93 = lanes_max(_s90, _s92);
        const V _s100 = lanes_div(_s78, _s93);
        FIX(6, p_ring_radius); FIX(13, lanes_mul(_s32, _s32)); FIX(17, p_gravity);
        FIX(27, lanes_mul(K(0.5), p_gravity)); FIX(34, _s78); FIX(46, lanes_max(K(1.0), _s100));
        FIX(50, _s79); FIX(51, lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s32), _s79));
        FIX(52, lanes_mul(K(5.00030517578125), _s32)); FIX(53, lanes_mul(K(6.0), p_gravity));
        FIX(54, lanes_mul(K(9.094947017729282e-13), _s79)); FIX(55, _s93);
    }
}

LANES_APART void LOOP(fix_rows_4)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, , p_ball_radius, p_gravity, p_ring_radius, p_wire_radius)
    {
        const V _s32 = lanes_add(p_ball_radius, p_wire_radius);
        FIX(6, p_ring_radius); FIX(13, lanes_mul(_s32, _s32)); FIX(17, p_gravity);
        FIX(27, lanes_mul(K(0.5), p_gravity));
    }
}

LANES_APART void LOOP(fix_refining_rows_1)(LOOP(worklist) *worklist, size_t taken, M idle)
{
    EACH(PARAMETER_TAKEN, refining_, p_ball_radius, p_gravity, p_ring_radius, p_wire_radius)
    EACH(TURNING, turning_, p_ball_radius, p_gravity, p_ring_radius, p_wire_radius)
    {
        const V _s32 = lanes_add(p_ball_radius, p_wire_radius);
        FIX(6, p_ring_radius); FIX(13, lanes_mul(_s32, _s32)); FIX(17, p_gravity);
        FIX(27, lanes_mul(K(0.5), p_gravity));
    }
}

LANES_APART void LOOP(fix_rows_5)(LOOP(worklist) *worklist, size_t i)
{
    EACH(PARAMETER, , p_ball_radius)
#if BOUNDED
    EACH(PARAMETER, , p_gravity, p_ring_radius, p_wire_radius)
    {
        const V _s32 = lanes_add(p_ball_radius, p_wire_radius);
        const V _s78 = lanes_mul(K(1.00006103515625), _s32);
        const V _s79 = lanes_add(p_ring_radius, _s78);
        const V _s90 = lanes_sub(p_ring_radius, _s78);
        const V _s92 = lanes_mul(K(0.0001220703125), p_ring_radius);
        const V _s100 = lanes_div(_s78, lanes_max(_s90, _s92));
        FIX(17, p_gravity); FIX(34, _s78); FIX(46, lanes_max(K(1.0), _s100)); FIX(50, _s79);
        FIX(51, lanes_mul(lanes_mul(K(1.3323489447131243e-15), _s32), _s79));
        FIX(52, lanes_mul(K(5.00030517578125), _s32));
    }
}

LANES_APART void LOOP(fix_rows_6)(LOOP(worklist) *worklist, size_t i)
{
#endif
    EACH(PARAMETER, , p_board_distance, p_gravity, p_restitution, p_ring_radius, p_wire_radius)
    BOUNDS(EACH(PARAMETER, , p_ball_radius, p_board_bottom, p_board_half_width, p_board_top))
    BOUNDS(EACH(PARAMETER, , p_bridge_half_width, p_end_depth))
    {
        const V _s32 = lanes_add(p_ball_radius, p_wire_radius);
#if BOUNDED
        const V _s62 = lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(lanes_add(p_ball_radius, p_ring_radius), p_wire_radius), p_board_distance), p_board_half_width), p_bridge_half_width), p_end_depth);
#endif
        FIX(3, lanes_sub(p_ball_radius, p_board_distance)); FIX(6, p_ring_radius); FIX(12, _s32);
        FIX(17, p_gravity); FIX(27, lanes_mul(K(0.5), p_gravity));
#if BOUNDED
        FIX(28, lanes_add(lanes_add(_s62, lanes_abs(p_board_bottom)), lanes_abs(p_board_top)));
#endif
        FIX(56, lanes_div(K(1.0), _s32)); FIX(57, p_restitution);
        FIX(58, lanes_mul(K(0.4), p_ball_radius)); FIX(59, lanes_div(K(1.0), p_ball_radius));
#if BOUNDED
    }
    {
        const S _p_ball_radius = lanes_narrow(p_ball_radius);
        const S _p_ring_radius = lanes_narrow(p_ring_radius);
        const S _p_wire_radius = lanes_narrow(p_wire_radius);
        const S _p_gravity = lanes_narrow(p_gravity);
        const S _p_restitution = lanes_narrow(p_restitution);
        const S _s6 = singles_add(_p_ball_radius, _p_wire_radius);
        const S _s58 = singles_div(KS(1.0), _s6);
        const S _s60 = singles_sub(singles_sub(_p_ring_radius, _p_ball_radius), _p_wire_radius);
        const S _s61 = singles_min(_s60, _s6);
        const S _s69 = singles_mul(KS(2.0), singles_mul(_p_ring_radius, _s58));
        const S _s81 = singles_add(KS(0.6), _p_restitution);
        const S _s85 = singles_div(KS(1.0), _p_ball_radius);
        FIX_SINGLE(0, _p_gravity); FIX_SINGLE(10, _s6);
        FIX_SINGLE(20, singles_mul(KS(0.5), _p_gravity)); FIX_SINGLE(26, _s58);
        FIX_SINGLE(27, _s61); FIX_SINGLE(28, singles_div(KS(1.0), _s61));
        FIX_SINGLE(29, singles_mul(singles_sqrt(_p_gravity), singles_sqrt(_s6)));
        FIX_SINGLE(30, singles_mul(KS(1.1102230246251565e-16), singles_add(KS(16.0), _s69)));
        FIX_SINGLE(31, singles_mul(KS(3.5), _s6));
        FIX_SINGLE(32, singles_mul(KS(1.1102230246251565e-16), singles_add(KS(7.0), _s69)));
        FIX_SINGLE(33, _p_ball_radius); FIX_SINGLE(34, _p_restitution);
        FIX_SINGLE(35, singles_abs(KS(0.0))); FIX_SINGLE(36, _s81);
        FIX_SINGLE(37, singles_mul(KS(0.4), _p_ball_radius));
        FIX_SINGLE(38, singles_mul(KS(2.0), _s81)); FIX_SINGLE(39, _s85);
        FIX_SINGLE(40, singles_mul(KS(0.6), _s85));
#endif
    }
}

/* Take rows of lanes of shots that touch nothing from their release to their end, each row at once,
   without worklists. Return the first shot of the first row in which a shot may touch something. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
static size_t LOOP(launch)(LOOP(worklist) *worklist, const hoop_job *job, size_t start, size_t past)
{
    const V most_contacts = K((double)job->max_contacts);
    const V time_limit = K(job->time_limit);
#if BOUNDED
    const V claims = K(job->results->event_errors ? 2.0 : job->results->time_error || job->results->state_error ? 1.0 : 0.0);
#endif

#if BOUNDED
    const V tightening = K(0.0);
    (void)tightening;
    const S clock_error = KS(0.0);
#endif
    const V count_0 = K(0.0);
    EACH(TURNING, , count_0)
    const V count_1 = K(0.0);
    EACH(TURNING, , count_1)
    const V count_2 = K(0.0);
    EACH(TURNING, , count_2)
    const V first = K(-1.0);
    EACH(TURNING, , first)
    const V last = K(-1.0);
    const M permitted = lanes_less(K(0.0), lanes_load(worklist->permitted));
#if BOUNDED
    const S position_bound = KS(0.0);
    const S spin_bound = KS(0.0);
    const S velocity_bound = KS(0.0);
#endif
    for (; start + LANES_WIDTH <= past; start += LANES_WIDTH) {
        LANES(hoop_ahead)(job, start + LANES_SHOTS, 1);
        const double *states = job->states + HOOP_STATE * start;
        const V state_size = lanes_size(states, HOOP_STATE);
        if (job->results->state)
            LOOP(load)(worklist, 0, states, HOOP_STATE);
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
        CALL(hoop_state_in_range, _state_in_range_1)(state_size, state_size, state_size, state_size, state_size, state_size, state_size, state_size, state_size);
        EACH(GET_MASK, _state_in_range_1, in_range)
        CALL(hoop_aside, _aside_1)(x, y, z, FIXED(0), FIXED(1), FIXED(2), FIXED(3), FIXED(4));
        EACH(GET_MASK, _aside_1, close)
        EACH(GET, _aside_1, valid)
        BOUNDS(EACH(GET, _aside_1, undecided_time))
        const M _if_close_1 = close;
        if (lanes_any(_if_close_1)) {
            CALL(hoop_valid, _valid_1)(last, x, y, z, FIXED(5), FIXED(6), FIXED(7), FIXED(0), FIXED(8), FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(13), FIXED(3), FIXED(4), FIXED(14), FIXED(1), FIXED(15));
            EACH(SELECT, (_if_close_1, _valid_1), valid)
            BOUNDS(EACH(SELECT, (_if_close_1, _valid_1), undecided_time))
        }
#if BOUNDED
        CALL(hoop_admitted, _admitted_1)(undecided_time, valid, permitted, in_range);
#else
        CALL(hoop_admitted, _admitted_1)(K(INFINITY), valid, permitted, in_range);
#endif
        EACH(GET, _admitted_1, outcome)
        BOUNDS(EACH(GET, _admitted_1, uncertain))
        refused = lanes_either(refused, lanes_at_most(K(0.0), outcome));
#if BOUNDED
        CALL(hoop_error_bounds, _error_bounds_1)(clock_error, position_bound, velocity_bound, spin_bound);
#else
        CALL(hoop_error_bounds, _error_bounds_1)(KS(0.0), KS(0.0), KS(0.0), KS(0.0));
#endif
        EACH(GET_SINGLE, _error_bounds_1, time_error)
        BOUNDS(EACH(GET_SINGLE, _error_bounds_1, position_error, velocity_error))
        CALL(hoop_scale, _scale_1)(x, y, z, vx, vy, vz, FIXED(16));
        EACH(GET, _scale_1, extent, speed, excess)
#if BOUNDED
        CALL(hoop_opening, _opening_1)(excess, lanes_wide(position_error), lanes_wide(velocity_error));
#else
        CALL(hoop_opening, _opening_1)(excess, K(0.0), K(0.0));
#endif
        EACH(GET, _opening_1, when, which)
        BOUNDS(EACH(GET, _opening_1, earliest_delay))
        BOUNDS(EACH(SET, _opening_1, undecided_time))
        CALL(hoop_limited, _limited_1)(time_limit);
        EACH(GET_MASK, _limited_1, limited)
        CALL(hoop_left, _left_1)(K(3.0), last);
        EACH(GET, _left_1, leaving)
        CALL(hoop_end_arrival, _end_arrival_1)(leaving, z, vz, FIXED(17), FIXED(18), FIXED(19), FIXED(20), FIXED(21), FIXED(22));
        EACH(GET, _end_arrival_1, time, rate, bend, apex)
        BOUNDS(EACH(GET, _end_arrival_1, height))
        CALL(hoop_plane_root, _plane_root_1)(rate, bend, apex, time);
        EACH(GET_MASK, _plane_root_1, arrives)
#if BOUNDED
        EACH(GET, _plane_root_1, ceiling, nearest)
        CALL(hoop_end_margin, _end_margin_1)(nearest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(17), FIXED(23));
        EACH(GET, _end_margin_1, margin)
        CALL(hoop_crossing, _crossing_1)(margin, K(0.0), rate, ceiling);
        EACH(GET, _crossing_1, clearance, delay)
#endif
        CALL(hoop_within_time, _within_time_1)(time, when, OR_ZERO(delay), OR_ZERO(earliest_delay), arrives);
        EACH(GET_MASK, _within_time_1, possible)
#if BOUNDED
        CALL(hoop_apex_undecided, _apex_undecided_1)(margin, apex, height, undecided_time);
        EACH(SET, _apex_undecided_1, undecided_time)
#endif
        const M _if_possible_1 = possible;
        {
#if BOUNDED
            CALL(hoop_crossing_undecided, _crossing_undecided_1)(clearance, time, undecided_time, arrives);
            EACH(SELECT, (_if_possible_1, _crossing_undecided_1), undecided_time)
            CALL(hoop_tie_undecided, _tie_undecided_1)(time, when, delay, earliest_delay, undecided_time, arrives);
            EACH(SELECT, (_if_possible_1, _tie_undecided_1), undecided_time, earliest_delay)
#endif
            CALL(hoop_earliest, _earliest_1)(K(3.0), time, when, which, arrives);
            EACH(SELECT, (_if_possible_1, _earliest_1), when, which)
        }
        CALL(hoop_released, _released_1)(last);
        EACH(GET_MASK, _released_1, released, reachable)
        const M _if_released_1 = released;
        if (lanes_any(_if_released_1)) {
            CALL(hoop_horizon, _horizon_1)(when, speed, FIXED(16));
            V until = _horizon_1.horizon;
            EACH(GET, _horizon_1, pad)
#if BOUNDED
            CALL(hoop_reachable, _reachable_1)(x, vx, until, extent, speed, pad, earliest_delay, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(17), FIXED(6), FIXED(3), FIXED(24), FIXED(25));
#else
            CALL(hoop_reachable, _reachable_1)(x, vx, until, extent, speed, pad, K(0.0), K(0.0), K(0.0), FIXED(17), FIXED(6), FIXED(3), FIXED(24), FIXED(25));
#endif
            EACH(SELECT_MASK, (_if_released_1, _reachable_1), reachable)
        }
        refused = lanes_either(refused, reachable);
        CALL(hoop_horizon, _horizon_2)(when, speed, FIXED(16));
        V until = _horizon_2.horizon;
#if BOUNDED
        EACH(GET, _horizon_2, pad)
        CALL(hoop_overdue, _overdue_1)(pad, earliest_delay, undecided_time);
        EACH(SET, _overdue_1, undecided_time)
#endif
        CALL(hoop_missed, _missed_1)();
        EACH(GET, _missed_1, clear)
#if BOUNDED
        CALL(hoop_ring_drops_through, _ring_drops_through_1)(lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(until), lanes_narrow(extent), lanes_narrow(speed), position_error, velocity_error, FIXED_SINGLE(0), FIXED_SINGLE(41), FIXED_SINGLE(3), FIXED_SINGLE(42), FIXED_SINGLE(20), FIXED_SINGLE(43), FIXED_SINGLE(44), FIXED_SINGLE(45), FIXED_SINGLE(46), FIXED_SINGLE(47));
#else
        CALL(hoop_ring_drops_through, _ring_drops_through_1)(lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(until), lanes_narrow(extent), lanes_narrow(speed), KS(0.0), KS(0.0), FIXED_SINGLE(0), FIXED_SINGLE(41), FIXED_SINGLE(3), FIXED_SINGLE(42), FIXED_SINGLE(20), FIXED_SINGLE(43), FIXED_SINGLE(44), FIXED_SINGLE(45), FIXED_SINGLE(46), FIXED_SINGLE(47));
#endif
        EACH(GET_MASK, _ring_drops_through_1, unproved)
        const M _if_unproved_1 = unproved;
        if (lanes_any(_if_unproved_1)) {
#if BOUNDED
            CALL(hoop_ring_clear, _ring_clear_1)(until, x, y, z, vx, vy, vz, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(6), FIXED(17), FIXED(31), FIXED(32), FIXED(33), FIXED(34), FIXED(35), FIXED(36), FIXED(19), FIXED(16), FIXED(27), FIXED(13), FIXED(37), FIXED(38), FIXED(39), FIXED(40), FIXED(41), FIXED(42), FIXED(43), FIXED(44));
#else
            CALL(hoop_ring_clear, _ring_clear_1)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), FIXED(6), FIXED(17), FIXED(31), FIXED(32), FIXED(33), FIXED(34), FIXED(35), FIXED(36), FIXED(19), FIXED(16), FIXED(27), FIXED(13), FIXED(37), FIXED(38), FIXED(39), FIXED(40), FIXED(41), FIXED(42), FIXED(43), FIXED(44));
#endif
            EACH(SELECT, (_if_unproved_1, _ring_clear_1), clear)
        }
        CALL(hoop_opens, _opens_1)(clear);
        EACH(GET_MASK, _opens_1, open)
        refused = lanes_either(refused, open);
        const M _if_limited_1 = limited;
        if (lanes_any(_if_limited_1)) {
            CALL(hoop_expiry, _expiry_1)(when, which, OR_ZERO(earliest_delay), OR_INFINITE(undecided_time), lanes_wide(time_error), clock, time_limit);
            EACH(GET, _expiry_1, time)
            EACH(GET_MASK, _expiry_1, arrives)
#if BOUNDED
            EACH(GET, _expiry_1, delay)
            EACH(SELECT, (_if_limited_1, _expiry_1), undecided_time)
            CALL(hoop_tie_undecided, _tie_undecided_2)(time, when, delay, earliest_delay, undecided_time, arrives);
            EACH(SELECT, (_if_limited_1, _tie_undecided_2), undecided_time, earliest_delay)
#endif
            CALL(hoop_earliest, _earliest_2)(K(4.0), time, when, which, arrives);
            EACH(SELECT, (_if_limited_1, _earliest_2), when, which)
        }
        CALL(hoop_departed, _departed_1)(K(3.0), which);
        EACH(GET_MASK, _departed_1, moves, ends, touches)
        EACH(GET, _departed_1, reached)
        BOUNDS(EACH(GET_MASK, _departed_1, edge))
        CALL(hoop_body_of, _body_of_1)(which);
        EACH(GET, _body_of_1, body)
        const M _if_moves_1 = moves;
        {
            CALL(hoop_flight, _flight_1)(when, x, y, z, vx, vy, vz, FIXED(17), FIXED(27));
            EACH(SELECT, (_if_moves_1, _flight_1), x, y, z, vx, vy, vz)
            CALL(hoop_event_clock, _event_clock_1)(when, clock);
            EACH(SELECT, (_if_moves_1, _event_clock_1), clock)
        }
        const M _if_limited_2 = limited;
        if (lanes_any(_if_limited_2)) {
            CALL(hoop_expired, _expired_1)(K(4.0), which, body, clock, reached, time_limit, ends);
            EACH(SELECT, (_if_limited_2, _expired_1), clock, reached)
            EACH(SELECT_MASK, (_if_limited_2, _expired_1), ends)
        }
#if BOUNDED
        CALL(hoop_displacement, _displacement_1)(earliest_delay, when, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(17), FIXED(28));
        V slack = _displacement_1.margin;
#endif
        CALL(hoop_here, _here_1)(K(3.0), which);
        EACH(GET_MASK, _here_1, here)
        const M _if_here_1 = here;
        {
            CALL(hoop_end_bounds, _end_bounds_1)(x, y, FIXED(6));
            EACH(GET, _end_bounds_1, g0)
            CALL(hoop_end_reached, _end_reached_1)(g0);
            EACH(SELECT, (_if_here_1, _end_reached_1), reached)
#if BOUNDED
            CALL(hoop_end_edge, _end_edge_1)(slack, g0);
            EACH(SELECT_MASK, (_if_here_1, _end_edge_1), edge)
#endif
        }
#if BOUNDED
        CALL(hoop_flight_undecided, _flight_undecided_1)(when, earliest_delay, undecided_time, uncertain, edge);
        EACH(SET, _flight_undecided_1, uncertain)
#endif
        CALL(hoop_accounted, _accounted_1)(contacts, most_contacts, reached, touches);
        EACH(SET, _accounted_1, contacts, outcome)
#if BOUNDED
        CALL(hoop_meeting, _meeting_1)(claims, ends, touches);
#else
        CALL(hoop_meeting, _meeting_1)(K(0.0), ends, touches);
#endif
        EACH(GET_MASK, _meeting_1, meeting)
        refused = lanes_either(refused, meeting);
#if BOUNDED
        refused = lanes_either(refused, limited);
        CALL(hoop_closing, _closing_1)(lanes_narrow(outcome), lanes_narrow(claims));
        EACH(GET_MASK, _closing_1, reports)
        EACH(GET_SINGLE, _closing_1, position_claim, velocity_claim, spin_claim, time_claim)
        const M _if_reports_1 = reports;
        if (lanes_any(_if_reports_1)) {
            CALL(hoop_claimed_errors, _claimed_errors_1)(clock_error, position_bound, velocity_bound, spin_bound);
            position_claim = singles_select(singles_of(_if_reports_1), _claimed_errors_1.position_error, position_claim);
            velocity_claim = singles_select(singles_of(_if_reports_1), _claimed_errors_1.velocity_error, velocity_claim);
            spin_claim = singles_select(singles_of(_if_reports_1), _claimed_errors_1.spin_error, spin_claim);
            time_claim = singles_select(singles_of(_if_reports_1), _claimed_errors_1.time_error, time_claim);
        }
#endif
        refused = lanes_either(refused, lanes_less(outcome, K(0.0)));
        EACH(TURNING, , clock, contacts, outcome)
#if BOUNDED
        singles_store(worklist->position_claim, position_claim);
        singles_store(worklist->spin_claim, spin_claim);
        singles_store(worklist->time_claim, time_claim);
        EACH(TURNING, , uncertain)
        singles_store(worklist->velocity_claim, velocity_claim);
#endif
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
static void LOOP(run)(const hoop_job *job, LOOP(worklist) *const restrict worklist)
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
#if BOUNDED
    V tightening = K(0.0);
#endif
    int streams = 0; /* whether the shots before ended all at once: then those to come will, too */

#if BOUNDED
    worklist->loose_shots = 0;
    worklist->tightening = 0;
#endif
    if (job->shots == 0)
        return;
    for (int p = 0; p < HOOP_PARAMETERS; p++)
        lanes_store(worklist->parameters.columns[p], K(*job->parameters[p]));
    LOOP(permitted)(worklist, 0);
    LOOP(fix)(worklist);
    for (;;) {
        if (stopped(job))
            return;
        if (begun == end && end < job->shots)
            begun = hoop_take(job, &end);
        if (launching && shots == 0 && !HELD && begun < end && begun >= paused) {
            const size_t from = begun, past = end - from < LANES_LAUNCHED ? end : from + LANES_LAUNCHED;
            begun = LOOP(launch)(worklist, job, from, past);
            if (begun == past)
                continue;
            pause = begun > from || pause == 0 ? 2 * LANES_SHOTS : 2 * pause;
            paused = begun + pause;
        }
        int following = shots == 0 && !TIGHTENING;
        const size_t fresh = shots;
#if BOUNDED
        if (worklist->tightening && worklist->loose_shots > 0)
            shots += LOOP(begin_again)(worklist, shots, job);
#endif
        if (begun < end && !HELD) {
            const size_t room = LANES_SHOTS - shots, left = end - begun;
            shots += left < room ? left : room;
            LOOP(begin)(worklist, fresh, shots - fresh, job, begun);
            begun += shots - fresh;
#if BOUNDED
        }
        if (shots == 0 && (worklist->tightening || worklist->loose_shots > 0)) {
            /* The path of these is known: only bounds on errors, and what follows from them, are new. */
            worklist->tightening = !worklist->tightening;
            tightening = K(worklist->tightening ? 1.0 : 0.0);
            recording = job->results->events != NULL && (!worklist->tightening || job->results->event_errors != NULL);
            continue;
#endif
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
            CALL(hoop_state_in_range, _state_in_range_1)(x, y, z, vx, vy, vz, wx, wy, wz);
            EACH(GET_MASK, _state_in_range_1, in_range)
            CALL(hoop_aside, _aside_1)(x, y, z, FIXED(0), FIXED(1), FIXED(2), FIXED(3), FIXED(4));
            EACH(GET_MASK, _aside_1, close)
            EACH(GET, _aside_1, valid)
            BOUNDS(EACH(GET, _aside_1, undecided_time))
            const M _if_close_1 = lanes_both(rows, close);
            if (lanes_any(_if_close_1)) {
                CALL(hoop_valid, _valid_1)(last, x, y, z, FIXED(5), FIXED(6), FIXED(7), FIXED(0), FIXED(8), FIXED(9), FIXED(10), FIXED(11), FIXED(12), FIXED(13), FIXED(3), FIXED(4), FIXED(14), FIXED(1), FIXED(15));
                EACH(SELECT, (_if_close_1, _valid_1), valid)
                BOUNDS(EACH(SELECT, (_if_close_1, _valid_1), undecided_time))
            }
#if BOUNDED
            CALL(hoop_admitted, _admitted_1)(undecided_time, valid, permitted, in_range);
#else
            CALL(hoop_admitted, _admitted_1)(K(INFINITY), valid, permitted, in_range);
#endif
            EACH(GET, _admitted_1, outcome)
            BOUNDS(EACH(GET, _admitted_1, uncertain))
            EACH(STORE, , outcome)
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
            LANES(hoop_ahead)(job, begun + i, streams);
            if (LANES_SELDOM(varying))
                LOOP(fix_rows_2)(worklist, i);
            EACH(LOAD, , last, vx, vy, vz, x, y, z)
#if BOUNDED
            EACH(LOAD_SINGLE, , clock_error, position_bound, spin_bound, velocity_bound)
            CALL(hoop_error_bounds, _error_bounds_1)(clock_error, position_bound, velocity_bound, spin_bound);
#else
            CALL(hoop_error_bounds, _error_bounds_1)(KS(0.0), KS(0.0), KS(0.0), KS(0.0));
#endif
            EACH(GET_SINGLE, _error_bounds_1, time_error)
            BOUNDS(EACH(GET_SINGLE, _error_bounds_1, position_error, velocity_error))
            CALL(hoop_scale, _scale_1)(x, y, z, vx, vy, vz, FIXED(16));
            EACH(GET, _scale_1, extent, speed, excess)
#if BOUNDED
            CALL(hoop_opening, _opening_1)(excess, lanes_wide(position_error), lanes_wide(velocity_error));
#else
            CALL(hoop_opening, _opening_1)(excess, K(0.0), K(0.0));
#endif
            EACH(GET, _opening_1, when, which)
            BOUNDS(EACH(GET, _opening_1, earliest_delay, undecided_time))
            CALL(hoop_limited, _limited_1)(time_limit);
            EACH(GET_MASK, _limited_1, limited)
            CALL(hoop_left, _left_1)(K(3.0), last);
            EACH(GET, _left_1, leaving)
            CALL(hoop_end_arrival, _end_arrival_1)(leaving, z, vz, FIXED(17), FIXED(18), FIXED(19), FIXED(20), FIXED(21), FIXED(22));
            EACH(GET, _end_arrival_1, time, rate, bend, apex)
            BOUNDS(EACH(GET, _end_arrival_1, height))
            CALL(hoop_plane_root, _plane_root_1)(rate, bend, apex, time);
            EACH(GET_MASK, _plane_root_1, arrives)
#if BOUNDED
            EACH(GET, _plane_root_1, ceiling, nearest)
            CALL(hoop_end_margin, _end_margin_1)(nearest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(17), FIXED(23));
            EACH(GET, _end_margin_1, margin)
            CALL(hoop_crossing, _crossing_1)(margin, K(0.0), rate, ceiling);
            EACH(GET, _crossing_1, clearance, delay)
#endif
            CALL(hoop_within_time, _within_time_1)(time, when, OR_ZERO(delay), OR_ZERO(earliest_delay), arrives);
            EACH(GET_MASK, _within_time_1, possible)
#if BOUNDED
            CALL(hoop_apex_undecided, _apex_undecided_1)(margin, apex, height, undecided_time);
            EACH(SET, _apex_undecided_1, undecided_time)
#endif
            const M _if_possible_1 = lanes_both(rows, possible);
            {
#if BOUNDED
                CALL(hoop_crossing_undecided, _crossing_undecided_1)(clearance, time, undecided_time, arrives);
                EACH(SELECT, (_if_possible_1, _crossing_undecided_1), undecided_time)
                CALL(hoop_tie_undecided, _tie_undecided_1)(time, when, delay, earliest_delay, undecided_time, arrives);
                EACH(SELECT, (_if_possible_1, _tie_undecided_1), undecided_time, earliest_delay)
#endif
                CALL(hoop_earliest, _earliest_1)(K(3.0), time, when, which, arrives);
                EACH(SELECT, (_if_possible_1, _earliest_1), when, which)
            }
            CALL(hoop_released, _released_1)(last);
            EACH(GET_MASK, _released_1, released, reachable)
            const M _if_released_1 = lanes_both(rows, released);
            if (lanes_any(_if_released_1)) {
                CALL(hoop_horizon, _horizon_1)(when, speed, FIXED(16));
                V until = _horizon_1.horizon;
                EACH(GET, _horizon_1, pad)
#if BOUNDED
                CALL(hoop_reachable, _reachable_1)(x, vx, until, extent, speed, pad, earliest_delay, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(17), FIXED(6), FIXED(3), FIXED(24), FIXED(25));
#else
                CALL(hoop_reachable, _reachable_1)(x, vx, until, extent, speed, pad, K(0.0), K(0.0), K(0.0), FIXED(17), FIXED(6), FIXED(3), FIXED(24), FIXED(25));
#endif
                EACH(SELECT_MASK, (_if_released_1, _reachable_1), reachable)
            }
            const M _if_reachable_1 = lanes_both(rows, reachable);
            if (lanes_any(_if_reachable_1)) {
                CALL(hoop_left, _left_2)(K(1.0), last);
                EACH(GET, _left_2, leaving)
                CALL(hoop_backboard_arrival, _backboard_arrival_1)(leaving, x, vx, FIXED(3));
                EACH(GET, _backboard_arrival_1, time, rate, bend, height)
                CALL(hoop_level_root, _level_root_1)(rate, bend, height, time, when);
                EACH(GET_MASK, _level_root_1, arrives)
#if BOUNDED
                EACH(GET, _level_root_1, ceiling, nearest)
                CALL(hoop_backboard_margin, _backboard_margin_1)(nearest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(17), FIXED(26));
                EACH(GET, _backboard_margin_1, margin)
                CALL(hoop_crossing, _crossing_2)(margin, K(0.0), rate, ceiling);
                EACH(GET, _crossing_2, clearance, delay)
#endif
                CALL(hoop_within_time, _within_time_2)(time, when, OR_ZERO(delay), OR_ZERO(earliest_delay), arrives);
                EACH(GET_MASK, _within_time_2, possible)
#if BOUNDED
                CALL(hoop_side_undecided, _side_undecided_1)(rate, margin, height, undecided_time, lanes_wide(velocity_error));
                EACH(SELECT, (_if_reachable_1, _side_undecided_1), undecided_time)
#endif
                const M _if_possible_2 = lanes_both(_if_reachable_1, possible);
#if BOUNDED
                if (lanes_any(_if_possible_2)) {
#else
                {
#endif
                    CALL(hoop_flight, _flight_1)(time, x, y, z, vx, vy, vz, FIXED(17), FIXED(27));
                    V there_y = _flight_1.y;
                    V there_z = _flight_1.z;
                    CALL(hoop_backboard_bounds, _backboard_bounds_1)(there_y, there_z, FIXED(8), FIXED(9), FIXED(10));
                    EACH(GET, _backboard_bounds_1, g0, g1, g2, g3)
#if BOUNDED
                    CALL(hoop_displacement, _displacement_1)(delay, time, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(17), FIXED(28));
                    V slack = _displacement_1.margin;
                    CALL(hoop_backboard_edges, _backboard_edges_1)(clearance, slack, g0, g1, g2, g3);
                    EACH(GET_MASK, _backboard_edges_1, undecided)
                    CALL(hoop_bounds_undecided, _bounds_undecided_1)(time, undecided_time, undecided);
                    EACH(SELECT, (_if_possible_2, _bounds_undecided_1), undecided_time)
#endif
                    CALL(hoop_backboard_within, _backboard_within_1)(g0, g1, g2, g3);
                    EACH(GET_MASK, _backboard_within_1, arrives)
#if BOUNDED
                    CALL(hoop_tie_undecided, _tie_undecided_2)(time, when, delay, earliest_delay, undecided_time, arrives);
                    EACH(SELECT, (_if_possible_2, _tie_undecided_2), undecided_time, earliest_delay)
#endif
                    CALL(hoop_earliest, _earliest_2)(K(1.0), time, when, which, arrives);
                    EACH(SELECT, (_if_possible_2, _earliest_2), when, which)
                }
                CALL(hoop_left, _left_3)(K(2.0), last);
                EACH(SET, _left_3, leaving)
                CALL(hoop_bridge_arrival, _bridge_arrival_1)(leaving, z, vz, FIXED(17), FIXED(12), FIXED(19), FIXED(20), FIXED(21), FIXED(22));
                EACH(SET, _bridge_arrival_1, time, rate, bend)
                EACH(GET, _bridge_arrival_1, apex)
                BOUNDS(EACH(SET, _bridge_arrival_1, height))
                CALL(hoop_plane_root, _plane_root_2)(rate, bend, apex, time);
                EACH(SET, _plane_root_2, arrives)
#if BOUNDED
                EACH(SET, _plane_root_2, ceiling, nearest)
                CALL(hoop_bridge_margin, _bridge_margin_1)(nearest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(17), FIXED(29));
                EACH(SET, _bridge_margin_1, margin)
                CALL(hoop_crossing, _crossing_3)(margin, K(0.0), rate, ceiling);
                EACH(SET, _crossing_3, clearance, delay)
#endif
                CALL(hoop_within_time, _within_time_3)(time, when, OR_ZERO(delay), OR_ZERO(earliest_delay), arrives);
                EACH(SET, _within_time_3, possible)
#if BOUNDED
                CALL(hoop_apex_undecided, _apex_undecided_2)(margin, apex, height, undecided_time);
                EACH(SELECT, (_if_reachable_1, _apex_undecided_2), undecided_time)
#endif
                const M _if_possible_3 = lanes_both(_if_reachable_1, possible);
                if (lanes_any(_if_possible_3)) {
                    CALL(hoop_flight, _flight_2)(time, x, y, z, vx, vy, vz, FIXED(17), FIXED(27));
                    V there_x = _flight_2.x;
                    V there_y = _flight_2.y;
                    CALL(hoop_bridge_bounds, _bridge_bounds_1)(there_x, there_y, FIXED(6), FIXED(0), FIXED(11));
                    EACH(GET, _bridge_bounds_1, g0, g1, g2, g3, g4)
#if BOUNDED
                    CALL(hoop_displacement, _displacement_2)(delay, time, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(17), FIXED(28));
                    V slack = _displacement_2.margin;
                    CALL(hoop_bridge_edges, _bridge_edges_1)(clearance, slack, g0, g1, g2, g3, g4);
                    EACH(GET_MASK, _bridge_edges_1, undecided)
                    CALL(hoop_bounds_undecided, _bounds_undecided_2)(time, undecided_time, undecided);
                    EACH(SELECT, (_if_possible_3, _bounds_undecided_2), undecided_time)
#endif
                    CALL(hoop_bridge_within, _bridge_within_1)(g0, g1, g2, g3, g4);
                    EACH(GET_MASK, _bridge_within_1, arrives)
#if BOUNDED
                    CALL(hoop_tie_undecided, _tie_undecided_3)(time, when, delay, earliest_delay, undecided_time, arrives);
                    EACH(SELECT, (_if_possible_3, _tie_undecided_3), undecided_time, earliest_delay)
#endif
                    CALL(hoop_earliest, _earliest_3)(K(2.0), time, when, which, arrives);
                    EACH(SELECT, (_if_possible_3, _earliest_3), when, which)
                }
#if BOUNDED
                CALL(hoop_plane_start, _plane_start_1)(undecided_time, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(30));
                EACH(SELECT, (_if_reachable_1, _plane_start_1), undecided_time)
#endif
            }
            CALL(hoop_horizon, _horizon_2)(when, speed, FIXED(16));
            V until = _horizon_2.horizon;
#if BOUNDED
            EACH(GET, _horizon_2, pad)
            CALL(hoop_overdue, _overdue_1)(pad, earliest_delay, undecided_time);
            EACH(SET, _overdue_1, undecided_time)
            CALL(hoop_ring_clear, _ring_clear_1)(until, x, y, z, vx, vy, vz, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(6), FIXED(17), FIXED(31), FIXED(32), FIXED(33), FIXED(34), FIXED(35), FIXED(36), FIXED(19), FIXED(16), FIXED(27), FIXED(13), FIXED(37), FIXED(38), FIXED(39), FIXED(40), FIXED(41), FIXED(42), FIXED(43), FIXED(44));
#else
            CALL(hoop_ring_clear, _ring_clear_1)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), FIXED(6), FIXED(17), FIXED(31), FIXED(32), FIXED(33), FIXED(34), FIXED(35), FIXED(36), FIXED(19), FIXED(16), FIXED(27), FIXED(13), FIXED(37), FIXED(38), FIXED(39), FIXED(40), FIXED(41), FIXED(42), FIXED(43), FIXED(44));
#endif
            EACH(GET, _ring_clear_1, clear)
            CALL(hoop_opens, _opens_1)(clear);
            EACH(GET_MASK, _opens_1, open)
            EACH(STORE, , extent, speed, until, when, which)
            EACH(STORE_MASK, , limited, open)
            EACH(STORE_SINGLE, , time_error)
            BOUNDS(EACH(STORE, , earliest_delay, pad, undecided_time))
            BOUNDS(EACH(STORE_SINGLE, , position_error, velocity_error))
        }
        {
        size_t stepping_shots = 0;
        static const int stepping_taken[] = {0, 9, 1, 2};
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_both(mask_first_n(shots - i), lanes_less(K(0.0), lanes_load(worklist->open + i)));
            if (lanes_any(rows)) {
                if (LANES_SELDOM(varying))
                    LOOP(fix_rows_3)(worklist, i);
                EACH(LOAD, , extent, last, speed, until, vx, vy, vz, x, y, z)
                BOUNDS(EACH(LOAD, , earliest_delay, pad, undecided_time))
                BOUNDS(EACH(LOAD_SINGLE, , position_error, velocity_error))
                CALL(hoop_beginning, _beginning_1)();
                EACH(GET, _beginning_1, share, arrival)
                EACH(GET_MASK, _beginning_1, certain)
                CALL(hoop_left, _left_1)(K(0.0), last);
                EACH(GET, _left_1, leaving)
                CALL(hoop_ring_opened, _ring_opened_1)(lanes_narrow(until), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(extent), lanes_narrow(speed), FIXED_SINGLE(0), FIXED_SINGLE(1), FIXED_SINGLE(2), FIXED_SINGLE(3), FIXED_SINGLE(4), FIXED_SINGLE(5), FIXED_SINGLE(6), FIXED_SINGLE(7), FIXED_SINGLE(8), FIXED_SINGLE(9));
                S onset = _ring_opened_1.t;
                S wide_end = _ring_opened_1.end;
                EACH(GET_MASK, _ring_opened_1, searching)
                S wide_low1 = _ring_opened_1.low1;
                S wide_high1 = _ring_opened_1.high1;
                S wide_low2 = _ring_opened_1.low2;
                S wide_high2 = _ring_opened_1.high2;
                S lapsed = _ring_opened_1.latest;
                EACH(GET_MASK, _ring_opened_1, representable)
                CALL(hoop_opened, _opened_1)(lanes_wide(lapsed), lanes_wide(onset));
                V since = _opened_1.time;
                BOUNDS(EACH(GET, _opened_1, latest))
                CALL(hoop_ring_started, _ring_started_1)(x, y, z, vx, vy, vz, FIXED(6));
                EACH(GET, _ring_started_1, rho_start, start_rate, rho_rate)
                CALL(hoop_flight, _flight_1)(since, x, y, z, vx, vy, vz, FIXED(17), FIXED(27));
                V near_x = _flight_1.x;
                V near_y = _flight_1.y;
                V near_z = _flight_1.z;
                V near_vz = _flight_1.vz;
                CALL(hoop_ring_resolution, _ring_resolution_1)(onset, wide_end, lanes_narrow(leaving), lapsed, lanes_narrow(near_x), lanes_narrow(near_y), lanes_narrow(near_z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(near_vz), lanes_narrow(extent), lanes_narrow(speed), lanes_narrow(start_rate), lanes_narrow(rho_rate), wide_low1, wide_high1, wide_low2, wide_high2, FIXED_SINGLE(0), FIXED_SINGLE(10), FIXED_SINGLE(6), FIXED_SINGLE(11), FIXED_SINGLE(12), FIXED_SINGLE(13), FIXED_SINGLE(14), FIXED_SINGLE(15), FIXED_SINGLE(4), FIXED_SINGLE(16), FIXED_SINGLE(17), FIXED_SINGLE(18));
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
                CALL(hoop_coarse, _coarse_1)(lanes_wide(short_rate_margin), lanes_wide(short_flat), lanes_wide(short_ceiling), lanes_wide(short_share), searching, representable, fits);
                EACH(GET_MASK, _coarse_1, stepping, single_precision)
                EACH(SET, _coarse_1, searching)
                EACH(GET, _coarse_1, ceiling, flat, tilt)
#if BOUNDED
                EACH(GET, _coarse_1, allowing)
                CALL(hoop_ring_coarse_excess, _ring_coarse_excess_1)(allowing, latest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(17), FIXED(34), FIXED(45), FIXED(46));
                EACH(GET, _ring_coarse_excess_1, excess)
                CALL(hoop_ring_budget_exceeded, _ring_budget_exceeded_1)(until, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(31), FIXED(47), FIXED(16), FIXED(48), FIXED(32), FIXED(33));
                EACH(GET, _ring_budget_exceeded_1, budget_exceeded)
                CALL(hoop_out_of_budget, _out_of_budget_1)(pad, budget_exceeded, earliest_delay, undecided_time, excess);
                EACH(SELECT, (rows, _out_of_budget_1), undecided_time)
#endif
                const M _if_stepping_1 = lanes_both(rows, stepping);
                if (LANES_USUAL(_if_stepping_1)) {
                    CALL(hoop_ring_step, _ring_step_1)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_energy2, short_moment2, short_rho_start, short_flat, short_tilt, short_quotient_margin, short_jerk, short_start_rate, short_rho_rate, short_low1, short_high1, short_low2, short_high2, FIXED_SINGLE(19), FIXED_SINGLE(0), FIXED_SINGLE(20), FIXED_SINGLE(21), FIXED_SINGLE(22), FIXED_SINGLE(1), FIXED_SINGLE(23), FIXED_SINGLE(24), FIXED_SINGLE(6), FIXED_SINGLE(25));
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
                CALL(hoop_ring_step, _ring_step_1)(short_t, short_end, short_rate_margin, short_ceiling, short_x, short_y, short_z, short_vx, short_vy, short_vz, short_energy2, short_moment2, short_rho_start, short_flat, short_tilt, short_quotient_margin, short_jerk, short_start_rate, short_rho_rate, short_low1, short_high1, short_low2, short_high2, FIXED_SINGLE(19), FIXED_SINGLE(0), FIXED_SINGLE(20), FIXED_SINGLE(21), FIXED_SINGLE(22), FIXED_SINGLE(1), FIXED_SINGLE(23), FIXED_SINGLE(24), FIXED_SINGLE(6), FIXED_SINGLE(25));
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
        static const int searching_taken[] = {0, 9, 1, 2};
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_both(mask_first_n(shots - i), lanes_less(K(0.0), lanes_load(worklist->open + i)));
            if (lanes_any(rows)) {
                EACH(LOAD, , arrival, since)
                EACH(LOAD_MASK, , certain, searching, single_precision)
                EACH(LOAD_SINGLE, , short_t)
                CALL(hoop_stepped, _stepped_1)(arrival, lanes_wide(short_t), searching, since, single_precision, certain);
                EACH(SET, _stepped_1, arrival, searching)
                EACH(GET, _stepped_1, t)
                EACH(STORE, , arrival)
                const M packed = lanes_both(rows, searching);
                if (lanes_any(packed)) {
                    EACH(LOAD, , extent, last, share, speed, until, vx, vy, vz, x, y, z)
                    BOUNDS(EACH(LOAD, , undecided_time))
                    BOUNDS(EACH(LOAD_SINGLE, , position_error, velocity_error))
                    lanes_pack(worklist->searching_row + searching_shots, packed, lanes_add(iota(), K((double)i)));
                    EACH(PACK, searching_, arrival, extent, last, share, speed, t, until, vx, vy)
                    EACH(PACK, searching_, vz, x, y, z)
                    EACH(PACK_MASK, searching_, certain)
                    BOUNDS(EACH(PACK, searching_, undecided_time))
                    BOUNDS(EACH(PACK_SINGLE, searching_, position_error, velocity_error))
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
            BOUNDS(EACH(CLEAR, searching_, undecided_time))
            BOUNDS(EACH(CLEAR_SINGLE, searching_, position_error, velocity_error))
            if (LANES_SELDOM(varying)) {
                for (size_t _p = 0; _p < 4; _p++) {
                    lanes_store(worklist->searching_parameters.columns[searching_taken[_p]] + searching_shots, K(0.0));
                }
            }
        }
        {
        size_t searching_searching_shots = 0;
        static const int searching_searching_taken[] = {0, 9, 1, 2};
        for (size_t i = 0; i < searching_shots; i += LANES_WIDTH) {
            const M rows = mask_first_n(searching_shots - i);
            if (LANES_SELDOM(varying))
                LOOP(fix_searching_rows_1)(worklist, i);
            EACH(LOAD, searching_, extent, share, speed, t, until, vx, vy, vz, x, y, z)
#if BOUNDED
            EACH(LOAD, searching_, undecided_time)
            EACH(LOAD_SINGLE, searching_, position_error, velocity_error)
            CALL(hoop_ring_prepare, _ring_prepare_1)(until, x, y, z, vx, vy, vz, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(39), FIXED(43), FIXED(34), FIXED(19), FIXED(16), FIXED(37), FIXED(41), FIXED(40), FIXED(49), FIXED(31), FIXED(47), FIXED(48), FIXED(32), FIXED(33));
#else
            CALL(hoop_ring_prepare, _ring_prepare_1)(until, x, y, z, vx, vy, vz, extent, speed, K(0.0), K(0.0), FIXED(39), FIXED(43), FIXED(34), FIXED(19), FIXED(16), FIXED(37), FIXED(41), FIXED(40), FIXED(49), FIXED(31), FIXED(47), FIXED(48), FIXED(32), FIXED(33));
#endif
            EACH(GET, _ring_prepare_1, energy2, moment2, rho_start, low0, high0, low1, high1, low2)
            EACH(GET, _ring_prepare_1, high2, ceiling, latest)
#if BOUNDED
            CALL(hoop_ring_excess, _ring_excess_1)(share, latest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(17), FIXED(34), FIXED(46));
            EACH(GET, _ring_excess_1, excess)
            CALL(hoop_allowance, _allowance_1)(share, latest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(17));
#else
            CALL(hoop_allowance, _allowance_1)(share, latest, extent, speed, K(0.0), K(0.0), FIXED(17));
#endif
            EACH(GET, _allowance_1, position_level, velocity_level)
            CALL(hoop_ring_margins, _ring_margins_1)(latest, extent, speed, position_level, velocity_level, FIXED(17), FIXED(34), FIXED(50), FIXED(51), FIXED(52), FIXED(46));
            V flat = _ring_margins_1.margin;
            V tilt = _ring_margins_1.leaving_margin;
            V rate_slack = _ring_margins_1.rate_margin;
#if BOUNDED
            CALL(hoop_budget_undecided, _budget_undecided_1)(t, undecided_time, excess);
            EACH(SET, _budget_undecided_1, undecided_time)
#endif
            CALL(hoop_ring_enter, _ring_enter_1)(t, K(0.0), t, low0, low1, low2, high0, high1, high2);
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
                BOUNDS(EACH(PACK, searching_searching_, undecided_time))
                BOUNDS(EACH(PACK_SINGLE, searching_searching_, position_error, velocity_error))
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
            BOUNDS(EACH(CLEAR, searching_searching_, undecided_time))
            BOUNDS(EACH(CLEAR_SINGLE, searching_searching_, position_error, velocity_error))
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
            BOUNDS(EACH(START, , undecided_time))
            BOUNDS(EACH(START_SINGLE, , position_error, velocity_error))
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
                    BOUNDS(EACH(EXPAND, searching_searching_, undecided_time))
                    BOUNDS(EACH(EXPAND_SINGLE, searching_searching_, position_error, velocity_error))
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
                CALL(hoop_nearby, _nearby_1)(t, flat, tilt, K(0.0), last);
                EACH(GET, _nearby_1, leaving, margin)
                CALL(hoop_ring_advance, _ring_advance_1)(t, end, leaving, margin, rate_slack, ceiling, x, y, z, vx, vy, vz, energy2, moment2, rho_start, FIXED(6), FIXED(17), FIXED(27), FIXED(13), FIXED(53), FIXED(34), FIXED(54), FIXED(55));
                EACH(GET, _ring_advance_1, gap, rate, bend, step, next, clearance)
                CALL(hoop_gap_closes, _gap_closes_1)(gap, rate, bend, margin, rate_slack, clearance, share);
                EACH(GET_MASK, _gap_closes_1, hit, sure, needs_refinement)
                const M _if_needs_refinement_1 = lanes_both(active, needs_refinement);
                if (lanes_any(_if_needs_refinement_1)) {
                    CALL(hoop_smaller_budget, _smaller_budget_1)(share);
                    EACH(SELECT, (_if_needs_refinement_1, _smaller_budget_1), share)
#if BOUNDED
                    CALL(hoop_ring_excess, _ring_excess_1)(share, latest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(17), FIXED(34), FIXED(46));
                    EACH(GET, _ring_excess_1, excess)
                    CALL(hoop_allowance, _allowance_1)(share, latest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(17));
#else
                    CALL(hoop_allowance, _allowance_1)(share, latest, extent, speed, K(0.0), K(0.0), FIXED(17));
#endif
                    EACH(GET, _allowance_1, position_level, velocity_level)
                    CALL(hoop_ring_margins, _ring_margins_1)(latest, extent, speed, position_level, velocity_level, FIXED(17), FIXED(34), FIXED(50), FIXED(51), FIXED(52), FIXED(46));
                    flat = lanes_select(_if_needs_refinement_1, _ring_margins_1.margin, flat);
                    tilt = lanes_select(_if_needs_refinement_1, _ring_margins_1.leaving_margin, tilt);
                    rate_slack = lanes_select(_if_needs_refinement_1, _ring_margins_1.rate_margin, rate_slack);
#if BOUNDED
                    CALL(hoop_budget_undecided, _budget_undecided_1)(t, undecided_time, excess);
                    EACH(SELECT, (_if_needs_refinement_1, _budget_undecided_1), undecided_time)
#endif
                }
                CALL(hoop_advanced, _advanced_1)(t, end, step, next, arrival, hit, sure, needs_refinement, certain);
                EACH(SET, _advanced_1, arrival, certain, searching, t)
                EACH(GET_MASK, _advanced_1, exhausted)
                const M _if_exhausted_1 = lanes_both(active, exhausted);
                {
                    CALL(hoop_ring_enter, _ring_enter_1)(t, end, end, low0, low1, low2, high0, high1, high2);
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
            CALL(hoop_predicate_undecided, _predicate_undecided_1)(t, undecided_time, searching);
            EACH(SET, _predicate_undecided_1, undecided_time)
            EACH(STORE, searching_, undecided_time)
#endif
        }
        for (size_t k = 0; k < searching_shots; k++) {
            const size_t row = (size_t)worklist->searching_row[k];
            EACH(RETURN, (, searching_), arrival, ceiling, certain, flat, rho_start, tilt)
            BOUNDS(EACH(RETURN, (, searching_), latest, undecided_time))
        }
        }
        {
        size_t refining_shots = 0;
        static const int refining_taken[] = {0, 9, 1, 2};
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = lanes_both(mask_first_n(shots - i), lanes_less(K(0.0), lanes_load(worklist->open + i)));
            if (lanes_any(rows)) {
                if (LANES_SELDOM(varying))
                    LOOP(fix_rows_4)(worklist, i);
                EACH(LOAD, , arrival, ceiling, flat, last, rho_start, tilt, vx, vy, vz, x, y, z)
                EACH(LOAD_MASK, , certain)
                CALL(hoop_found, _found_1)(arrival);
                EACH(GET_MASK, _found_1, arrives, refining)
                BOUNDS(EACH(GET, _found_1, rate))
                CALL(hoop_nearby, _nearby_1)(arrival, flat, tilt, K(0.0), last);
                EACH(GET, _nearby_1, leaving)
                const M _if_refining_1 = lanes_both(rows, refining);
                if (LANES_USUAL(_if_refining_1)) {
                    CALL(hoop_ring_refine, _ring_refine_1)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, FIXED(6), FIXED(17), FIXED(27), FIXED(13));
                    V refined = _ring_refine_1.time;
                    EACH(GET, _ring_refine_1, gap)
#if BOUNDED
                    EACH(SELECT, (_if_refining_1, _ring_refine_1), rate)
#else
                    EACH(GET, _ring_refine_1, rate)
#endif
                    CALL(hoop_refined_root, _refined_root_1)(gap, rate, ceiling, arrival, refined, certain);
                    EACH(SELECT, (_if_refining_1, _refined_root_1), arrival)
                    EACH(SELECT_MASK, (_if_refining_1, _refined_root_1), refining)
                }
                const M _if_refining_2 = lanes_both(rows, refining);
                if (LANES_USUAL(_if_refining_2)) {
                    CALL(hoop_ring_refine, _ring_refine_2)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, FIXED(6), FIXED(17), FIXED(27), FIXED(13));
                    V refined = _ring_refine_2.time;
                    EACH(GET, _ring_refine_2, gap)
#if BOUNDED
                    EACH(SELECT, (_if_refining_2, _ring_refine_2), rate)
#else
                    EACH(GET, _ring_refine_2, rate)
#endif
                    CALL(hoop_refined_root, _refined_root_2)(gap, rate, ceiling, arrival, refined, certain);
                    EACH(SELECT, (_if_refining_2, _refined_root_2), arrival)
                    EACH(SELECT_MASK, (_if_refining_2, _refined_root_2), refining)
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
                CALL(hoop_ring_refine, _ring_refine_1)(arrival, leaving, x, y, z, vx, vy, vz, rho_start, FIXED(6), FIXED(17), FIXED(27), FIXED(13));
                V refined = _ring_refine_1.time;
                EACH(GET, _ring_refine_1, gap, rate)
                CALL(hoop_refined_root, _refined_root_1)(gap, rate, ceiling, arrival, refined, certain);
                EACH(SET, _refined_root_1, arrival, refining)
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
                EACH(LOAD, , ceiling, earliest_delay, extent, latest, leaving, rate, speed)
                EACH(LOAD, , undecided_time)
                EACH(LOAD_MASK, , certain)
                EACH(LOAD_SINGLE, , position_error, velocity_error)
                CALL(hoop_ring_margins, _ring_margins_1)(latest, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(17), FIXED(34), FIXED(50), FIXED(51), FIXED(52), FIXED(46));
                V flat = _ring_margins_1.margin;
                V tilt = _ring_margins_1.leaving_margin;
                EACH(GET, _ring_margins_1, rate_margin)
                CALL(hoop_own_margin, _own_margin_1)(leaving, flat, tilt, arrival);
                EACH(GET, _own_margin_1, margin)
                CALL(hoop_crossing, _crossing_1)(margin, rate_margin, rate, ceiling);
                EACH(GET, _crossing_1, clearance, delay)
#endif
                CALL(hoop_arrival_time, _arrival_time_1)(arrival);
                EACH(GET, _arrival_time_1, time)
#if BOUNDED
                CALL(hoop_arrival_certainty, _arrival_certainty_1)(clearance, time, delay, undecided_time, arrives, certain);
                EACH(SET, _arrival_certainty_1, delay)
                EACH(SELECT, (rows, _arrival_certainty_1), undecided_time)
                CALL(hoop_tie_undecided, _tie_undecided_1)(time, when, delay, earliest_delay, undecided_time, arrives);
                EACH(SELECT, (rows, _tie_undecided_1), undecided_time, earliest_delay)
#endif
                CALL(hoop_earliest, _earliest_1)(K(0.0), time, when, which, arrives);
                EACH(SELECT, (rows, _earliest_1), when, which)
                EACH(STORE, , when, which)
                BOUNDS(EACH(STORE, , earliest_delay, undecided_time))
            }
        }
        }
        for (size_t i = 0; i < shots; i += LANES_WIDTH) {
            const M rows = mask_first_n(shots - i);
            if (LANES_SELDOM(varying))
#if BOUNDED
                LOOP(fix_rows_6)(worklist, i);
#else
                LOOP(fix_rows_5)(worklist, i);
#endif
            EACH(LOAD, , clock, contacts, vx, vy, vz, when, which, wx, wy, wz, x, y, z)
            EACH(LOAD_MASK, , limited)
            BOUNDS(EACH(LOAD, , earliest_delay, extent, speed, uncertain, undecided_time))
            BOUNDS(EACH(LOAD_SINGLE, , clock_error, position_bound, position_error, spin_bound))
            BOUNDS(EACH(LOAD_SINGLE, , velocity_bound, velocity_error))
            const M _if_limited_1 = lanes_both(rows, limited);
            if (lanes_any(_if_limited_1)) {
                EACH(LOAD_SINGLE, , time_error)
                CALL(hoop_expiry, _expiry_1)(when, which, OR_ZERO(earliest_delay), OR_INFINITE(undecided_time), lanes_wide(time_error), clock, time_limit);
                EACH(GET, _expiry_1, time)
                EACH(GET_MASK, _expiry_1, arrives)
#if BOUNDED
                EACH(GET, _expiry_1, delay)
                EACH(SELECT, (_if_limited_1, _expiry_1), undecided_time)
                CALL(hoop_tie_undecided, _tie_undecided_1)(time, when, delay, earliest_delay, undecided_time, arrives);
                EACH(SELECT, (_if_limited_1, _tie_undecided_1), undecided_time, earliest_delay)
#endif
                CALL(hoop_earliest, _earliest_1)(K(4.0), time, when, which, arrives);
                EACH(SELECT, (_if_limited_1, _earliest_1), when, which)
            }
            CALL(hoop_departed, _departed_1)(K(3.0), which);
            EACH(GET_MASK, _departed_1, moves, ends, touches)
            EACH(GET, _departed_1, reached)
            BOUNDS(EACH(GET_MASK, _departed_1, edge))
            CALL(hoop_body_of, _body_of_1)(which);
            EACH(GET, _body_of_1, body)
            const M _if_moves_1 = lanes_both(rows, moves);
            {
                CALL(hoop_flight, _flight_1)(when, x, y, z, vx, vy, vz, FIXED(17), FIXED(27));
                EACH(SELECT, (_if_moves_1, _flight_1), x, y, z, vx, vy, vz)
                CALL(hoop_event_clock, _event_clock_1)(when, clock);
                EACH(SELECT, (_if_moves_1, _event_clock_1), clock)
            }
            const M _if_limited_2 = lanes_both(rows, limited);
            if (lanes_any(_if_limited_2)) {
                CALL(hoop_expired, _expired_1)(K(4.0), which, body, clock, reached, time_limit, ends);
                EACH(SELECT, (_if_limited_2, _expired_1), clock, body, reached)
                EACH(SELECT_MASK, (_if_limited_2, _expired_1), ends)
            }
#if BOUNDED
            CALL(hoop_displacement, _displacement_1)(earliest_delay, when, extent, speed, lanes_wide(position_error), lanes_wide(velocity_error), FIXED(17), FIXED(28));
            V slack = _displacement_1.margin;
#endif
            CALL(hoop_here, _here_1)(K(3.0), which);
            EACH(GET_MASK, _here_1, here)
            const M _if_here_1 = lanes_both(rows, here);
            {
                CALL(hoop_end_bounds, _end_bounds_1)(x, y, FIXED(6));
                EACH(GET, _end_bounds_1, g0)
                CALL(hoop_end_reached, _end_reached_1)(g0);
                EACH(SELECT, (_if_here_1, _end_reached_1), reached)
#if BOUNDED
                CALL(hoop_end_edge, _end_edge_1)(slack, g0);
                EACH(SELECT_MASK, (_if_here_1, _end_edge_1), edge)
#endif
            }
#if BOUNDED
            CALL(hoop_flight_undecided, _flight_undecided_1)(when, earliest_delay, undecided_time, uncertain, edge);
            EACH(SET, _flight_undecided_1, uncertain)
#endif
            CALL(hoop_accounted, _accounted_1)(contacts, most_contacts, reached, touches);
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
            CALL(hoop_meeting, _meeting_1)(claims, ends, touches);
#else
            CALL(hoop_meeting, _meeting_1)(K(0.0), ends, touches);
#endif
            EACH(GET_MASK, _meeting_1, meeting)
            const M _if_meeting_1 = lanes_both(rows, meeting);
            if (lanes_any(_if_meeting_1)) {
                EACH(LOAD, , count_0, count_1, count_2, first, last)
                BOUNDS(EACH(LOAD_SINGLE, , left_bend_e, left_bend_s, left_ex, left_ey, left_nx, left_ny))
                BOUNDS(EACH(LOAD_SINGLE, , left_nz, pace_e, pace_n, pace_s, place_e, place_n, place_s))
                BOUNDS(EACH(LOAD_SINGLE, , turn_n, turn_z))
                CALL(hoop_end_normal, _end_normal_1)();
                EACH(GET, _end_normal_1, nx, ny, nz)
                CALL(hoop_here, _here_2)(K(0.0), which);
                EACH(GET_MASK, _here_2, here)
                const M _if_here_2 = lanes_both(_if_meeting_1, here);
                {
                    CALL(hoop_ring_normal, _ring_normal_1)(x, y, z, FIXED(6), FIXED(56));
                    EACH(SELECT, (_if_here_2, _ring_normal_1), nx, ny, nz)
                    CALL(hoop_counted, _counted_1)(count_0);
                    count_0 = lanes_select(_if_here_2, _counted_1.count, count_0);
                }
                CALL(hoop_here, _here_3)(K(1.0), which);
                EACH(SET, _here_3, here)
                const M _if_here_3 = lanes_both(_if_meeting_1, here);
                {
                    CALL(hoop_backboard_normal, _backboard_normal_1)();
                    EACH(SELECT, (_if_here_3, _backboard_normal_1), nx, ny, nz)
                    CALL(hoop_counted, _counted_2)(count_1);
                    count_1 = lanes_select(_if_here_3, _counted_2.count, count_1);
                }
                CALL(hoop_here, _here_4)(K(2.0), which);
                EACH(SET, _here_4, here)
                const M _if_here_4 = lanes_both(_if_meeting_1, here);
                {
                    CALL(hoop_bridge_normal, _bridge_normal_1)();
                    EACH(SELECT, (_if_here_4, _bridge_normal_1), nx, ny, nz)
                    CALL(hoop_counted, _counted_3)(count_2);
                    count_2 = lanes_select(_if_here_4, _counted_3.count, count_2);
                }
#if BOUNDED
                CALL(hoop_normal_velocity, _normal_velocity_1)(vx, vy, vz, nx, ny, nz);
                EACH(GET, _normal_velocity_1, normal_velocity)
                CALL(hoop_came_back, _came_back_1)(last, which);
                EACH(GET, _came_back_1, back)
                CALL(hoop_end_tangents, _end_tangents_1)(lanes_narrow(when), lanes_narrow(z), lanes_narrow(vz), FIXED_SINGLE(20));
                EACH(GET_SINGLE, _end_tangents_1, tangent_x, tangent_y, bend_s, bend_e)
                EACH(GET_SINGLE, _end_tangents_1, sharpest_bend, root_offset, root_level)
                EACH(GET_SINGLE, _end_tangents_1, normal_rounding)
                CALL(hoop_here, _here_5)(K(0.0), which);
                EACH(SET, _here_5, here)
                const M _if_here_5 = lanes_both(_if_meeting_1, here);
                if (lanes_any(_if_here_5)) {
                    CALL(hoop_ring_tangents, _ring_tangents_1)(lanes_narrow(when), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(nx), lanes_narrow(ny), lanes_narrow(nz), place_n, lanes_narrow(normal_velocity), lanes_narrow(back), FIXED_SINGLE(0), FIXED_SINGLE(10), FIXED_SINGLE(26), FIXED_SINGLE(27), FIXED_SINGLE(28), FIXED_SINGLE(29), FIXED_SINGLE(20), FIXED_SINGLE(30), FIXED_SINGLE(31), FIXED_SINGLE(32));
                    EACH(SELECT_SINGLE, (_if_here_5, _ring_tangents_1), tangent_x, tangent_y)
                    EACH(SELECT_SINGLE, (_if_here_5, _ring_tangents_1), bend_s, bend_e)
                    EACH(SELECT_SINGLE, (_if_here_5, _ring_tangents_1), sharpest_bend, root_offset)
                    EACH(SELECT_SINGLE, (_if_here_5, _ring_tangents_1), root_level, normal_rounding)
                }
                CALL(hoop_here, _here_6)(K(1.0), which);
                EACH(SET, _here_6, here)
                const M _if_here_6 = lanes_both(_if_meeting_1, here);
                {
                    CALL(hoop_backboard_tangents, _backboard_tangents_1)(lanes_narrow(when), lanes_narrow(x), lanes_narrow(vx));
                    EACH(SELECT_SINGLE, (_if_here_6, _backboard_tangents_1), tangent_x, tangent_y)
                    EACH(SELECT_SINGLE, (_if_here_6, _backboard_tangents_1), bend_s, bend_e)
                    EACH(SELECT_SINGLE, (_if_here_6, _backboard_tangents_1), sharpest_bend)
                    EACH(SELECT_SINGLE, (_if_here_6, _backboard_tangents_1), root_offset)
                    EACH(SELECT_SINGLE, (_if_here_6, _backboard_tangents_1), root_level)
                    EACH(SELECT_SINGLE, (_if_here_6, _backboard_tangents_1), normal_rounding)
                }
                CALL(hoop_here, _here_7)(K(2.0), which);
                EACH(SET, _here_7, here)
                const M _if_here_7 = lanes_both(_if_meeting_1, here);
                {
                    CALL(hoop_bridge_tangents, _bridge_tangents_1)(lanes_narrow(when), lanes_narrow(z), lanes_narrow(vz), FIXED_SINGLE(20));
                    EACH(SELECT_SINGLE, (_if_here_7, _bridge_tangents_1), tangent_x, tangent_y)
                    EACH(SELECT_SINGLE, (_if_here_7, _bridge_tangents_1), bend_s, bend_e)
                    EACH(SELECT_SINGLE, (_if_here_7, _bridge_tangents_1), sharpest_bend)
                    EACH(SELECT_SINGLE, (_if_here_7, _bridge_tangents_1), root_offset, root_level)
                    EACH(SELECT_SINGLE, (_if_here_7, _bridge_tangents_1), normal_rounding)
                }
                const M _if_ends_1 = lanes_both(_if_meeting_1, ends);
                if (lanes_any(_if_ends_1)) {
                    CALL(hoop_carry_end, _carry_end_1)(lanes_narrow(when), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(clock), position_bound, velocity_bound, spin_bound, root_offset, lanes_narrow(normal_velocity), FIXED_SINGLE(0), FIXED_SINGLE(20));
                    EACH(SELECT_SINGLE, (_if_ends_1, _carry_end_1), position_bound, velocity_bound)
                    EACH(SELECT_SINGLE, (_if_ends_1, _carry_end_1), spin_bound)
                    S belated = _carry_end_1.delay;
                    CALL(hoop_clock_error_sum, _clock_error_sum_1)(belated, clock_error);
                    EACH(SELECT_SINGLE, (_if_ends_1, _clock_error_sum_1), clock_error)
                }
                CALL(hoop_tightens, _tightens_1)(tightening, touches);
                EACH(GET_MASK, _tightens_1, carries, tightens)
                const M _if_carries_1 = lanes_both(_if_meeting_1, carries);
                if (LANES_USUAL(_if_carries_1)) {
                    CALL(hoop_carry_impact, _carry_impact_1)(lanes_narrow(when), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(wx), lanes_narrow(wy), lanes_narrow(wz), lanes_narrow(nx), lanes_narrow(ny), lanes_narrow(nz), lanes_narrow(clock), left_nx, left_ny, left_nz, place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound, spin_bound, tangent_x, tangent_y, bend_s, bend_e, left_ex, left_ey, left_bend_s, left_bend_e, sharpest_bend, root_offset, root_level, normal_rounding, lanes_narrow(normal_velocity), lanes_narrow(back), FIXED_SINGLE(33), FIXED_SINGLE(34), FIXED_SINGLE(0), FIXED_SINGLE(20), FIXED_SINGLE(35), FIXED_SINGLE(36), FIXED_SINGLE(37), FIXED_SINGLE(38), FIXED_SINGLE(39), FIXED_SINGLE(40));
                    EACH(SELECT_SINGLE, (_if_carries_1, _carry_impact_1), place_n, place_s, place_e)
                    EACH(SELECT_SINGLE, (_if_carries_1, _carry_impact_1), pace_n, pace_s, pace_e)
                    EACH(SELECT_SINGLE, (_if_carries_1, _carry_impact_1), turn_n, turn_z)
                    EACH(SELECT_SINGLE, (_if_carries_1, _carry_impact_1), position_bound)
                    EACH(SELECT_SINGLE, (_if_carries_1, _carry_impact_1), velocity_bound)
                    EACH(SELECT_SINGLE, (_if_carries_1, _carry_impact_1), spin_bound, left_nx)
                    EACH(SELECT_SINGLE, (_if_carries_1, _carry_impact_1), left_ny, left_nz, left_ex)
                    EACH(SELECT_SINGLE, (_if_carries_1, _carry_impact_1), left_ey, left_bend_s)
                    EACH(SELECT_SINGLE, (_if_carries_1, _carry_impact_1), left_bend_e)
                    S belated = _carry_impact_1.delay;
                    CALL(hoop_clock_error_sum, _clock_error_sum_2)(belated, clock_error);
                    EACH(SELECT_SINGLE, (_if_carries_1, _clock_error_sum_2), clock_error)
                }
                const M _if_tightens_1 = lanes_both(_if_meeting_1, tightens);
                if (lanes_any(_if_tightens_1)) {
                    EACH(LOAD_SINGLE, , continued, origin_e, origin_s, origin_t, origin_u, origin_v)
                    EACH(LOAD_SINGLE, , origin_w, product_11, product_12, product_13, product_14)
                    EACH(LOAD_SINGLE, , product_15, product_16, product_21, product_22, product_23)
                    EACH(LOAD_SINGLE, , product_24, product_25, product_26, product_31, product_32)
                    EACH(LOAD_SINGLE, , product_33, product_34, product_35, product_36, product_41)
                    EACH(LOAD_SINGLE, , product_42, product_43, product_44, product_45, product_46)
                    EACH(LOAD_SINGLE, , product_51, product_52, product_53, product_54, product_55)
                    EACH(LOAD_SINGLE, , product_56, product_61, product_62, product_63, product_64)
                    EACH(LOAD_SINGLE, , product_65, product_66, recent_e, recent_s, recent_t)
                    EACH(LOAD_SINGLE, , recent_u, recent_v, recent_w)
                    CALL(hoop_tighten_impact, _tighten_impact_1)(lanes_narrow(when), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(wx), lanes_narrow(wy), lanes_narrow(wz), lanes_narrow(nx), lanes_narrow(ny), lanes_narrow(nz), lanes_narrow(clock), left_nx, left_ny, left_nz, place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound, spin_bound, tangent_x, tangent_y, bend_s, bend_e, left_ex, left_ey, left_bend_s, left_bend_e, sharpest_bend, root_offset, root_level, normal_rounding, lanes_narrow(normal_velocity), lanes_narrow(back), origin_s, origin_e, origin_u, origin_v, origin_w, origin_t, product_11, product_12, product_13, product_14, product_15, product_16, product_21, product_22, product_23, product_24, product_25, product_26, product_31, product_32, product_33, product_34, product_35, product_36, product_41, product_42, product_43, product_44, product_45, product_46, product_51, product_52, product_53, product_54, product_55, product_56, product_61, product_62, product_63, product_64, product_65, product_66, recent_s, recent_e, recent_u, recent_v, recent_w, recent_t, continued, FIXED_SINGLE(33), FIXED_SINGLE(34), FIXED_SINGLE(0), FIXED_SINGLE(20), FIXED_SINGLE(35), FIXED_SINGLE(36), FIXED_SINGLE(37), FIXED_SINGLE(38), FIXED_SINGLE(39), FIXED_SINGLE(40));
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), place_n, place_s)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), place_e, pace_n)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), pace_s, pace_e, turn_n)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), turn_z, position_bound)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), velocity_bound)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), spin_bound, left_nx)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), left_ny, left_nz)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), left_ex, left_ey)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), left_bend_s)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), left_bend_e)
                    S belated = _tighten_impact_1.delay;
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), origin_s, origin_e)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), origin_u, origin_v)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), origin_w, origin_t)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), recent_s, recent_e)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), recent_u, recent_v)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), recent_w, recent_t)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_11, product_12)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_13, product_14)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_15, product_16)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_21, product_22)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_23, product_24)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_25, product_26)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_31, product_32)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_33, product_34)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_35, product_36)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_41, product_42)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_43, product_44)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_45, product_46)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_51, product_52)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_53, product_54)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_55, product_56)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_61, product_62)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_63, product_64)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), product_65, product_66)
                    EACH(SELECT_SINGLE, (_if_tightens_1, _tighten_impact_1), continued)
                    CALL(hoop_clock_error_sum, _clock_error_sum_3)(belated, clock_error);
                    EACH(SELECT_SINGLE, (_if_tightens_1, _clock_error_sum_3), clock_error)
                    EACH(STORE_SINGLE, , continued, origin_e, origin_s, origin_t, origin_u)
                    EACH(STORE_SINGLE, , origin_v, origin_w, product_11, product_12, product_13)
                    EACH(STORE_SINGLE, , product_14, product_15, product_16, product_21, product_22)
                    EACH(STORE_SINGLE, , product_23, product_24, product_25, product_26, product_31)
                    EACH(STORE_SINGLE, , product_32, product_33, product_34, product_35, product_36)
                    EACH(STORE_SINGLE, , product_41, product_42, product_43, product_44, product_45)
                    EACH(STORE_SINGLE, , product_46, product_51, product_52, product_53, product_54)
                    EACH(STORE_SINGLE, , product_55, product_56, product_61, product_62, product_63)
                    EACH(STORE_SINGLE, , product_64, product_65, product_66, recent_e, recent_s)
                    EACH(STORE_SINGLE, , recent_t, recent_u, recent_v, recent_w)
                }
#endif
                const M _if_touches_1 = lanes_both(_if_meeting_1, touches);
                if (LANES_USUAL(_if_touches_1)) {
                    CALL(hoop_impact, _impact_1)(vx, vy, vz, wx, wy, wz, nx, ny, nz, FIXED(57), FIXED(58), FIXED(59));
                    EACH(SELECT, (_if_touches_1, _impact_1), vx, vy, vz, wx, wy, wz)
                }
#if BOUNDED
                CALL(hoop_here, _here_8)(K(1.0), which);
                EACH(SET, _here_8, here)
                const M _if_here_8 = lanes_both(_if_meeting_1, here);
#else
                CALL(hoop_here, _here_5)(K(1.0), which);
                EACH(SET, _here_5, here)
                const M _if_here_5 = lanes_both(_if_meeting_1, here);
#endif
                {
                    CALL(hoop_backboard_place, _backboard_place_1)(y, z, FIXED(3));
#if BOUNDED
                    EACH(SELECT, (_if_here_8, _backboard_place_1), x, y, z)
#else
                    EACH(SELECT, (_if_here_5, _backboard_place_1), x, y, z)
#endif
                }
#if BOUNDED
                CALL(hoop_here, _here_9)(K(2.0), which);
                EACH(SET, _here_9, here)
                const M _if_here_9 = lanes_both(_if_meeting_1, here);
#else
                CALL(hoop_here, _here_6)(K(2.0), which);
                EACH(SET, _here_6, here)
                const M _if_here_6 = lanes_both(_if_meeting_1, here);
#endif
                {
                    CALL(hoop_bridge_place, _bridge_place_1)(x, y, FIXED(12));
#if BOUNDED
                    EACH(SELECT, (_if_here_9, _bridge_place_1), x, y, z)
#else
                    EACH(SELECT, (_if_here_6, _bridge_place_1), x, y, z)
#endif
                }
                const M _if_touches_2 = lanes_both(_if_meeting_1, touches);
                {
#if BOUNDED
                    CALL(hoop_unbounded, _unbounded_1)(clock_error, position_bound, velocity_bound, spin_bound);
                    EACH(GET_MASK, _unbounded_1, unbounded)
                    CALL(hoop_without_bounds, _without_bounds_1)(unbounded, uncertain);
                    EACH(SELECT, (_if_touches_2, _without_bounds_1), uncertain)
#endif
                    CALL(hoop_touched, _touched_1)(which, body, first);
                    EACH(SELECT, (_if_touches_2, _touched_1), first, last)
                }
                EACH(STORE, , count_0, count_1, count_2, first, last, wx, wy, wz)
                BOUNDS(EACH(STORE_SINGLE, , left_bend_e, left_bend_s, left_ex, left_ey, left_nx, left_ny))
                BOUNDS(EACH(STORE_SINGLE, , left_nz, pace_e, pace_n, pace_s, place_e, place_n, place_s))
                BOUNDS(EACH(STORE_SINGLE, , turn_n, turn_z))
            }
#if BOUNDED
            const M _if_limited_3 = lanes_both(rows, limited);
            if (lanes_any(_if_limited_3)) {
                CALL(hoop_ends_by_time_limit, _ends_by_time_limit_1)(K(4.0), which, claims);
                EACH(GET_MASK, _ends_by_time_limit_1, ends_by_time_limit)
                const M _if_ends_by_time_limit_1 = lanes_both(_if_limited_3, ends_by_time_limit);
                if (lanes_any(_if_ends_by_time_limit_1)) {
                    CALL(hoop_carry_time, _carry_time_1)(lanes_narrow(when), lanes_narrow(x), lanes_narrow(y), lanes_narrow(z), lanes_narrow(vx), lanes_narrow(vy), lanes_narrow(vz), lanes_narrow(clock), clock_error, position_bound, velocity_bound, spin_bound, FIXED_SINGLE(0), FIXED_SINGLE(20));
                    EACH(SELECT_SINGLE, (_if_ends_by_time_limit_1, _carry_time_1), position_bound)
                    EACH(SELECT_SINGLE, (_if_ends_by_time_limit_1, _carry_time_1), velocity_bound)
                    EACH(SELECT_SINGLE, (_if_ends_by_time_limit_1, _carry_time_1), spin_bound)
                    EACH(SELECT_SINGLE, (_if_ends_by_time_limit_1, _carry_time_1), clock_error)
                }
            }
            CALL(hoop_closing, _closing_1)(lanes_narrow(outcome), lanes_narrow(claims));
            EACH(GET_MASK, _closing_1, reports)
            EACH(GET_SINGLE, _closing_1, position_claim, velocity_claim, spin_claim, time_claim)
            const M _if_reports_1 = lanes_both(rows, reports);
            if (lanes_any(_if_reports_1)) {
                CALL(hoop_claimed_errors, _claimed_errors_1)(clock_error, position_bound, velocity_bound, spin_bound);
                position_claim = singles_select(singles_of(_if_reports_1), _claimed_errors_1.position_error, position_claim);
                velocity_claim = singles_select(singles_of(_if_reports_1), _claimed_errors_1.velocity_error, velocity_claim);
                spin_claim = singles_select(singles_of(_if_reports_1), _claimed_errors_1.spin_error, spin_claim);
                time_claim = singles_select(singles_of(_if_reports_1), _claimed_errors_1.time_error, time_claim);
            }
#endif
            EACH(STORE, , clock, contacts, outcome, vx, vy, vz, x, y, z)
            BOUNDS(EACH(STORE, , uncertain))
            BOUNDS(EACH(STORE_SINGLE, , clock_error, position_bound, position_claim, spin_bound))
            BOUNDS(EACH(STORE_SINGLE, , spin_claim, time_claim, velocity_bound, velocity_claim))
        }
        if (recording)
            for (size_t k = 0; k < shots; k++) {
                if (worklist->body[k] < 0.0)
                    continue;
                const size_t shot = (size_t)worklist->shot[k], rows = HOOP_LOG_ROWS * (size_t)job->max_contacts + 1;
                const size_t place = shot * rows + (size_t)job->results->event_counts[shot]++;
                hoop_event *event = job->results->events + place;
                const int64_t body = (int64_t)worklist->body[k], staying = body - HOOP_SURFACES - 1;
                event->shot = (int64_t)shot;
                event->surface = staying < 0 ? body : staying / 2;
                event->kind = staying < -1 ? HOOP_EVENT_IMPACT : staying < 0 ? HOOP_EVENT_END : staying % 2 ? HOOP_EVENT_LEAVE : HOOP_EVENT_ROLL;
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
                    hoop_event_errors *errors = job->results->event_errors + place;
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
#if BOUNDED
            for (size_t i = 0; i < shots; i += LANES_WIDTH)
                LOOP(review)(worklist, i, mask_first_n(shots - i));
#endif
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
static int LOOP(run_allocated)(const hoop_job *job)
{
    /* Not on the stack: they may be megabytes, and threads have little of it. */
    void *const room = malloc(sizeof(LOOP(worklist)) + 63);
    if (room == NULL)
        return 0;
    LOOP(run)(job, (void *)(((uintptr_t)room + 63) / 64 * 64));
    free(room);
    return 1;
}

