/* court: a ball among ring, backboard, bridge, simulated from contact to contact.

   Generated from templates/c/scene.h.j2, scene court, derivation 6850e5812fbcfc63,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Plain C11, no dependencies but sqrt. Compile court.c, next to which this and the other files
   stand, with contraction of a*b + c off (-ffp-contract=off) and without fast-math: results are
   then the same bits for every width, compiler and target, whatever floating-point environment the
   caller's thread has: a call sets the default one, and puts back what was there. Where flags stand
   against that, it does not compile, or nothing runs. SI units, radians. */

#ifndef HOOPGEN_COURT_H
#define HOOPGEN_COURT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifndef HOOPGEN_API
#ifdef _WIN32
#define HOOPGEN_API __declspec(dllexport)
#else
#define HOOPGEN_API
#endif
#endif

/* A state: x y z (m), vx vy vz (m/s), wx wy wz (rad/s). */
#define COURT_STATE 9

/* The bodies, as they are numbered in results; what ends a shot comes after them. */
enum {
    COURT_BODY_RING = 0,
    COURT_BODY_BACKBOARD = 1,
    COURT_BODY_BRIDGE = 2,
    COURT_BODY_END = 3,
    COURT_SURFACES = 3
};

/* What a row of the event log is; a contact in which the ball stays has a row where it begins and one
   where the ball leaves. A shot has COURT_LOG_ROWS rows for each contact at most, and its end. */
enum {
    COURT_EVENT_IMPACT = 0, /* The ball meets a body. */
    COURT_EVENT_ROLL = 1, /* Its bounces have accumulated: it stays in contact with the body. */
    COURT_EVENT_LEAVE = 2, /* That contact ends. */
    COURT_EVENT_END = 3, /* The shot ends. */
    COURT_LOG_ROWS = 3
};

/* The parameters, in the order of `parameters` below. */
enum {
    COURT_P_BALL_RADIUS = 0, /* m: R_B, radius of the ball */
    COURT_P_RING_RADIUS = 1, /* m: R_H, radius of the wire's centre circle */
    COURT_P_WIRE_RADIUS = 2, /* m: radius of the ring's wire */
    COURT_P_BOARD_DISTANCE = 3, /* m: a_0, from the ring's centre to the backboard */
    COURT_P_BOARD_HALF_WIDTH = 4, /* m: y_B, half the backboard's width */
    COURT_P_BOARD_BOTTOM = 5, /* m: z_B1, height of its lower edge */
    COURT_P_BOARD_TOP = 6, /* m: z_B2, height of its upper edge */
    COURT_P_BOARD_THICKNESS = 7, /* m: d, from the board's front to its back */
    COURT_P_BRIDGE_HALF_WIDTH = 8, /* m: y_BR, half the bridge's width */
    COURT_P_BRIDGE_DEPTH = 9, /* m: h, from the bridge's top to its underside */
    COURT_P_GRAVITY = 10, /* m/s²: g */
    COURT_P_END_DEPTH = 11, /* m: H, of the end plane below the ring */
    COURT_P_RING_RESTITUTION = 12, /* 1: e0 of the ring */
    COURT_P_BACKBOARD_RESTITUTION = 13, /* 1: e0 of the backboard */
    COURT_P_BRIDGE_RESTITUTION = 14, /* 1: e0 of the bridge */
    COURT_P_RING_FRICTION = 15, /* 1: mu of the ring; infinite: every contact grips */
    COURT_P_BACKBOARD_FRICTION = 16, /* 1: mu of the backboard; infinite: every contact grips */
    COURT_P_BRIDGE_FRICTION = 17, /* 1: mu of the bridge; infinite: every contact grips */
    COURT_P_INERTIA = 18, /* 1: kappa, the ball's moment of inertia over m R_B²: 2/3 of a thin shell, 2/5 of a solid ball */
    COURT_P_TANGENTIAL_RESTITUTION = 19, /* 1: e_t, of every contact that grips */
    COURT_P_RESTITUTION_SPEED = 20, /* m/s: v0, at which e is half of e0; infinite: it does not fall */
    COURT_PARAMETERS = 21
};

enum {
    COURT_OUTCOME_MADE = 0, /* Fell through the ring, and crossed the end plane inside the target. */
    COURT_OUTCOME_MISSED = 1, /* Crossed the end plane otherwise. */
    COURT_OUTCOME_CAPPED = 2, /* Had max_contacts contacts before it ended. */
    COURT_OUTCOME_SHORT = 3, /* Can never reach an end. */
    COURT_OUTCOME_INVALID = 4, /* Not finite, not allowed, a size out of range, or a start inside a surface. */
    COURT_OUTCOME_LODGED = 5, /* At rest, or wedged between bodies. */
    COURT_OUTCOME_ENDLESS = 6 /* Still moving at the time limit. */
};

/* One row of the event log; the end of a shot is a row. */
typedef struct {
    int64_t shot;    /* index of the shot */
    int64_t surface; /* as numbered above */
    double time;     /* s since the release */
    double before[COURT_STATE];
    double after[COURT_STATE];
    int64_t kind;    /* as numbered above */
} court_event;

/* Bounds on the errors of a row of the event log: of its time, and of the state after it. */
typedef struct {
    double time_error; /* bound on the error of time */
    double state_error[3]; /* bounds on the errors of each component of position, velocity and spin */
} court_event_errors;

/* Where the results go, by shot; what is NULL is not written. `events` and `event_counts` go
   together: without the counts nobody could tell which rows of the log are used. */
typedef struct {
    uint8_t *outcome; /* how it ended */
    int32_t *contacts; /* contacts before the end */
    int32_t *counts; /* [shot][3], contacts with each body */
    int8_t *first; /* first body touched, -1: none */
    double *time; /* s, at the end; capped or short: at the last contact */
    double *state; /* [shot][9], then */
    int32_t *rolls; /* how many times it began to roll */
    uint8_t *slip_left; /* its bounces ended with slip left, and so it is capped */
    double *grip_lost; /* s, when friction first was too little for the ball to roll as it did; infinite: never */
    double *time_error; /* bound on the error of time */
    double *state_error; /* [shot][3], bounds on the errors of each component of position, velocity and spin */
    uint8_t *uncertain; /* a decision lies within its rounding-error bound */
    uint8_t *estimated; /* its flag and the bounds on its errors are estimated, not proved */
    court_event *events;   /* [shot][COURT_LOG_ROWS * max_contacts + 1] */
    int32_t *event_counts;   /* rows of `events` used, by shot */
    court_event_errors *event_errors; /* NULL, or with `events`: as many rows */
} court_results;

/* Why nothing was run: what a call returns instead of the width. */
enum {
    COURT_ERROR_WIDTH = -1,         /* this processor or build has not that width */
    COURT_ERROR_ARITHMETIC = -2,    /* doubles are not computed as IEEE 754 says: by flags of the
                                   compiler (-ffp-contract=fast, parts of fast-math) */
    COURT_ERROR_MEMORY = -3,        /* there is no memory for the shots in flight */
    COURT_ERROR_SHOTS = -4,         /* more shots than an array can hold: a negative number, say */
    COURT_ERROR_STATES = -5,        /* NULL, with shots */
    COURT_ERROR_PARAMETERS = -6,    /* NULL, or one of the pointers is */
    COURT_ERROR_STRIDES = -7,       /* NULL, or one of them is neither 0 nor 1 */
    COURT_ERROR_LEAVING = -8,       /* less than -1, or no surface */
    COURT_ERROR_MAX_CONTACTS = -9,  /* less than 1 */
    COURT_ERROR_TIME_LIMIT = -10,   /* NaN, or not more than 0 */
    COURT_ERROR_RESULTS = -11,      /* NULL, or with bounds on errors that the build leaves out */
    COURT_ERROR_EVENTS = -12,       /* `events` without `event_counts`, or these without those;
                                   `event_errors` without either; or a log that no array can hold,
                                   or no count */
    COURT_ERROR_NEXT = -13,         /* NULL */
    COURT_ERROR_PARTS = -14         /* less than 1 */
};

/* Simulate `shots` shots.

   states       [shot][COURT_STATE]; may be NULL where there are no shots
   parameters   one pointer each, to one value or to one value per shot
   strides      by parameter: 0 for one value, 1 for one per shot
   leaving      NULL, or by shot the surface that the ball touches at the start and leaves, -1: none
   max_contacts at least 1
   time_limit   s since the release at which a shot ends, more than 0; INFINITY: none
   width        vector lanes: 1, 4, 8 or 16; 0 for the widest that this processor has, or for one
                lane if there is one shot
   stop         NULL, or a flag: when it becomes nonzero, the run ends, its results unfinished,
                event_counts too. Another thread that sets it does so by an atomic store
   results      where they go; itself it must not be NULL

   Returns the width that was used; or, with nothing run and nothing written, a COURT_ERROR:
   -1 if that width is not there, and so on. Of several faults any may be returned. The shots in
   flight are in memory from malloc: of the stack a call takes some tens of kilobytes. */
HOOPGEN_API int court_simulate(size_t shots, const double *states,
                              const double *const *parameters, const int64_t *strides,
                              const int8_t *leaving, int32_t max_contacts, double time_limit,
                              int width, const volatile int32_t *stop,
                              const court_results *results);

/* The same, by several threads that call it with the same arguments: each shot is simulated by one.

   next   the first shot that none has begun, in common; 0 before each batch. From `shots` on
          there is nothing left to run
   parts  which part of the shots that are left a thread takes at a time: some times as many as
          there are threads, at least 1 */
HOOPGEN_API int court_share(size_t shots, const double *states,
                           const double *const *parameters, const int64_t *strides,
                           const int8_t *leaving, int32_t max_contacts, double time_limit,
                           int width, const volatile int32_t *stop,
                           const court_results *results, size_t *next, size_t parts);

/* What a thread has of the processor's floating-point environment: its modes and its flags. */
typedef struct {
    uint64_t words[8];
} court_environment;

/* Set the default environment of this thread, and put back the one that it had before. Calls of
   court_simulate and court_share do so themselves. */
HOOPGEN_API void court_enter(court_environment *before);
HOOPGEN_API void court_leave(const court_environment *before);

/* The width that the build is for, if this processor has not that one and one lane serves; else 0. */
HOOPGEN_API int court_missing_width(void);

/* The word for its sources that the build gave as COURT_SOURCES, else "unknown". */
HOOPGEN_API const char *court_sources(void);

#ifdef __cplusplus
}
#endif

#endif
