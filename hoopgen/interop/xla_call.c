/* A call of a compiled scene from XLA, by its interface for foreign functions in C.

   The library is loaded once for each scene, and told the scene's function by hoopgen_bind. XLA's own
   threads share the shots, as those of hoopgen do; which thread simulates a shot changes no bit.

   arguments   states (..., 9), then each parameter: one value, or one for each entry of the leading
               dimensions of the states that its own shape begins with, which jax.vmap makes
   results     arrays by shot
   attributes  slots: by result its place among the pointers of the scene's results; places: their
               number; max_contacts, time_limit: of the scene's function; helpers: most threads
               beside the calling one; contacts: possible contacts for which one of them is worth it */

#include "xla/ffi/api/c_api.h"

#include <limits.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifndef _WIN32
#include <sched.h>
#endif

#ifdef _WIN32
#define EXPORTED __declspec(dllexport)
#else
#define EXPORTED
#endif

/* Threads begin with so small a part of the shots that are left, times their number. */
#define SHARE_DIVISOR 4

typedef int share_function(size_t shots, const double *states, const double *const *parameters,
                           const int64_t *strides, const int8_t *leaving, int32_t max_contacts,
                           double time_limit, int width, const volatile int32_t *stop,
                           void *const *results, size_t *next, size_t parts);

static share_function *share;

EXPORTED void hoopgen_bind(share_function *function) { share = function; }

/* What the threads of a call have in common. */
typedef struct {
    size_t shots;
    const double *states;
    const double **parameters;
    double **expanded; /* by parameter what was allocated, NULL if nothing was */
    int64_t *strides;
    int32_t max_contacts;
    double time_limit;
    void **results;
    size_t next, parts;
    atomic_int used;       /* the width, or the first error */
    atomic_int working;    /* tasks at work; CLOSED when none may begin any more */
    atomic_int references; /* who may still read this */
} batch;

enum {
    CLOSED = INT_MIN,
    ERROR_MEMORY = -3 /* of every scene, as in its header */
};

static void work(batch *own)
{
    const int used = share(own->shots, own->states, own->parameters, own->strides, NULL,
                           own->max_contacts, own->time_limit, 0, NULL, own->results, &own->next,
                           own->parts);
    if (used < 0)
        atomic_store(&own->used, used);
}

static void leave(batch *own)
{
    if (atomic_fetch_sub(&own->references, 1) == 1)
        free(own);
}

/* A task on another thread: it may begin when the call has ended, and then does nothing. */
static void task(void *data)
{
    batch *const own = data;
    int working = atomic_load(&own->working);
    while (working != CLOSED) {
        if (atomic_compare_exchange_weak(&own->working, &working, working + 1)) {
            work(own);
            atomic_fetch_sub(&own->working, 1);
            break;
        }
    }
    leave(own);
}

static void destroy(const XLA_FFI_Api *api, XLA_FFI_Error *error)
{
    XLA_FFI_Error_Destroy_Args given = {XLA_FFI_Error_Destroy_Args_STRUCT_SIZE, NULL, error};
    api->XLA_FFI_Error_Destroy(&given);
}

/* Return how many of XLA's threads may help, 0 if it has none. */
static int64_t threads_of(const XLA_FFI_CallFrame *frame)
{
    int64_t threads = 0;
    XLA_FFI_ThreadPool_NumThreads_Args given = {XLA_FFI_ThreadPool_NumThreads_Args_STRUCT_SIZE, NULL,
                                                frame->ctx, &threads};
    XLA_FFI_Error *const error = frame->api->XLA_FFI_ThreadPool_NumThreads(&given);
    if (error) {
        destroy(frame->api, error);
        return 0;
    }
    return threads;
}

/* Run the batch here and on the threads that help. */
static void run(const XLA_FFI_CallFrame *frame, batch *own, int64_t helpers)
{
    own->parts = SHARE_DIVISOR * (size_t)(helpers + 1);
    for (int64_t k = 0; k < helpers; k++) {
        XLA_FFI_ThreadPool_Schedule_Args given = {XLA_FFI_ThreadPool_Schedule_Args_STRUCT_SIZE, NULL,
                                                  frame->ctx, task, own};
        atomic_fetch_add(&own->references, 1);
        XLA_FFI_Error *const error = frame->api->XLA_FFI_ThreadPool_Schedule(&given);
        if (error) {
            destroy(frame->api, error);
            leave(own);
            break;
        }
    }
    work(own);
    /* All shots have begun; those of other threads end soon. */
    for (int none = 0; !atomic_compare_exchange_weak(&own->working, &none, CLOSED); none = 0) {
#ifndef _WIN32
        sched_yield();
#endif
    }
}

static XLA_FFI_Error *failure(const XLA_FFI_CallFrame *frame, XLA_FFI_Error_Code code,
                              const char *message)
{
    XLA_FFI_Error_Create_Args given = {XLA_FFI_Error_Create_Args_STRUCT_SIZE, NULL, message, code};
    return frame->api->XLA_FFI_Error_Create(&given);
}

/* Return the value of an attribute, NULL if there is none of that name and kind. */
static const void *attribute(const XLA_FFI_Attrs *attrs, const char *name, XLA_FFI_AttrType kind,
                             XLA_FFI_DataType dtype)
{
    for (int64_t k = 0; k < attrs->size; k++) {
        const XLA_FFI_ByteSpan *const own = attrs->names[k];
        if (own->len != strlen(name) || memcmp(own->ptr, name, own->len) || attrs->types[k] != kind)
            continue;
        if (kind == XLA_FFI_AttrType_ARRAY) {
            const XLA_FFI_Array *const array = attrs->attrs[k];
            return array->dtype == dtype ? array : NULL;
        }
        const XLA_FFI_Scalar *const scalar = attrs->attrs[k];
        return scalar->dtype == dtype ? scalar->value : NULL;
    }
    return NULL;
}

static size_t product(const int64_t *dims, int64_t rank)
{
    size_t entries = 1;
    for (int64_t k = 0; k < rank; k++)
        entries *= (size_t)dims[k];
    return entries;
}

/* Let a batch read a parameter: directly, or repeated for the dimensions that it does not have. */
static int read_parameter(batch *own, int64_t k, const XLA_FFI_Buffer *given)
{
    const size_t entries = product(given->dims, given->rank);
    own->parameters[k] = given->data;
    own->strides[k] = entries != 1;
    if (entries == 1 || entries == own->shots)
        return 1;
    const size_t each = own->shots / entries;
    const double *const values = given->data;
    double *const all = malloc(own->shots * sizeof *all);
    if (all == NULL)
        return 0;
    for (size_t shot = 0; shot < own->shots; shot++)
        all[shot] = values[shot / each];
    own->parameters[k] = own->expanded[k] = all;
    return 1;
}

static XLA_FFI_Error *execute(const XLA_FFI_CallFrame *frame)
{
    const XLA_FFI_DataType whole = XLA_FFI_DataType_S64;
    const XLA_FFI_AttrType scalar = XLA_FFI_AttrType_SCALAR;
    const XLA_FFI_Array *const slots = attribute(&frame->attrs, "slots", XLA_FFI_AttrType_ARRAY, whole);
    const int64_t *const places = attribute(&frame->attrs, "places", scalar, whole);
    const int64_t *const most = attribute(&frame->attrs, "max_contacts", scalar, whole);
    const int64_t *const most_helpers = attribute(&frame->attrs, "helpers", scalar, whole);
    const int64_t *const contacts = attribute(&frame->attrs, "contacts", scalar, whole);
    const double *const limit = attribute(&frame->attrs, "time_limit", scalar, XLA_FFI_DataType_F64);
    const int64_t count = frame->args.size - 1;
    if (!slots || !places || !most || !most_helpers || !contacts || !limit || count < 0 ||
        slots->size != (size_t)frame->rets.size || share == NULL)
        return failure(frame, XLA_FFI_Error_Code_INTERNAL, "hoopgen: its attributes do not arrive");
    const XLA_FFI_Buffer *const states = frame->args.args[0];
    for (int64_t k = 0; k <= count; k++) {
        const XLA_FFI_Buffer *const given = frame->args.args[k];
        if (given->dtype != XLA_FFI_DataType_F64)
            return failure(frame, XLA_FFI_Error_Code_INVALID_ARGUMENT, "hoopgen: expected float64");
    }
    const size_t shots = product(states->dims, states->rank - 1);
    if (shots == 0)
        return NULL;

    batch *const own = malloc(sizeof *own);
    const double **const parameters = malloc((size_t)(count + 1) * sizeof *parameters);
    double **const expanded = calloc((size_t)(count + 1), sizeof *expanded);
    int64_t *const strides = malloc((size_t)(count + 1) * sizeof *strides);
    void **const results = calloc((size_t)*places, sizeof *results);
    int there = own && parameters && expanded && strides && results, used = 0;
    if (there) {
        *own = (batch){.shots = shots, .states = states->data, .parameters = parameters,
                       .expanded = expanded, .strides = strides, .max_contacts = (int32_t)*most,
                       .time_limit = *limit, .results = results};
        atomic_init(&own->used, 0);
        atomic_init(&own->working, 0);
        atomic_init(&own->references, 1);
        for (int64_t k = 0; k < count && there; k++)
            there = read_parameter(own, k, frame->args.args[k + 1]);
        for (int64_t k = 0; k < frame->rets.size; k++) {
            const XLA_FFI_Buffer *const result = frame->rets.rets[k];
            results[((const int64_t *)slots->data)[k]] = result->data;
        }
    }
    if (there) {
        const double worth = (double)shots * (double)*most / (double)*contacts;
        int64_t helpers = worth < (double)*most_helpers ? (int64_t)worth : *most_helpers;
        if (helpers > 0) {
            const int64_t threads = threads_of(frame);
            helpers = helpers < threads ? helpers : threads;
        }
        run(frame, own, helpers);
        used = atomic_load(&own->used);
    }
    for (int64_t k = 0; expanded && k < count; k++)
        free(expanded[k]);
    free(results);
    free(strides);
    free(expanded);
    free(parameters);
    if (own)
        leave(own);
    if (!there || used == ERROR_MEMORY)
        return failure(frame, XLA_FFI_Error_Code_RESOURCE_EXHAUSTED,
                       "hoopgen: there is no memory for the shots in flight");
    if (used < 0) {
        char message[80];
        snprintf(message, sizeof message, "hoopgen: the C engine refuses its arguments, code %d", used);
        return failure(frame, XLA_FFI_Error_Code_INTERNAL, message);
    }
    return NULL;
}

EXPORTED XLA_FFI_Error *hoopgen_simulate(XLA_FFI_CallFrame *frame)
{
    XLA_FFI_Extension_Base *const asked = frame->extension_start;
    if (asked != NULL && asked->type == XLA_FFI_Extension_Metadata) {
        XLA_FFI_Metadata *const metadata = ((XLA_FFI_Metadata_Extension *)asked)->metadata;
        metadata->api_version.major_version = XLA_FFI_API_MAJOR;
        metadata->api_version.minor_version = XLA_FFI_API_MINOR;
        return NULL;
    }
    return execute(frame);
}
