/* The C interface between a generated controller, compiled as a shared object over finite carriers,
 * and the explorer of conformance/. One cycle is one call of `step`. Delivered with the generated code.
 * Copyright: see LICENSE (Apache-2.0). */
#ifndef ROBOCHART_EXPLORE_ABI_H
#define ROBOCHART_EXPLORE_ABI_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define ROBOCHART_ABI_VERSION 9
#define ROBOCHART_MAX_ARGUMENTS 8
#define ROBOCHART_MAX_CHOICES 32
#define ROBOCHART_MAX_PARTS 8
#define ROBOCHART_MAX_PLACES 4096

/* An input register: a received event, or an externally written shared variable. */
typedef struct rc_input {
    const char* name;        /* CSP event prefix relative to the component: "seeRobot.in", "set_EXT_reached" */
    uint32_t values;         /* number of its values; 0: it carries no value */
    const int64_t* value;    /* its values: numbers, reals times the scale, enumeration indices, booleans 0/1 */
    const char* const* text; /* the same values as CSPM text ("-70", "true", "P_T_Red") */
} rc_input;

/* An output: a sent event, a called operation, a written shared variable. */
typedef struct rc_output {
    const char* name;        /* "out.out", "MoveCall", "set_linearSpeed" */
    uint32_t arguments;
} rc_output;

typedef struct rc_record {
    uint32_t output;         /* index into outputs */
    uint32_t count;
    int64_t argument[ROBOCHART_MAX_ARGUMENTS];
} rc_record;

/* Kinds of overflow: more records than the capacity, more choices than ROBOCHART_MAX_CHOICES. */
#define ROBOCHART_OVERFLOW_RECORDS 1U
#define ROBOCHART_OVERFLOW_CHOICES 2U

/* The log of a call. The caller owns the records, and calls again with more of them if there were too few. */
typedef struct rc_log {
    uint32_t count;
    uint32_t overflow;       /* kinds of overflow; 0: none */
    uint32_t capacity;
    rc_record* record;
    /* Probabilistic junctions: the k-th junction of the cycle takes alternative choice[k] if k < given, otherwise 0.
     * `step` sets `asked` to the number of junctions, and ways[k] to the number of alternatives. */
    uint32_t given;
    uint32_t asked;
    uint32_t choice[ROBOCHART_MAX_CHOICES];
    uint32_t ways[ROBOCHART_MAX_CHOICES];
} rc_log;

typedef enum rc_result {
    RC_QUIESCENT = 0,        /* nothing more can happen in this cycle */
    RC_TERMINATED = 1,
    RC_STEP_BOUND = 2,       /* a loop that takes no time: the model diverges, or the bound is too small */
    RC_PRECONDITION = 3,     /* an operation was called outside its precondition */
    RC_DEADLINE = 4          /* a deadline was missed */
} rc_result;

/* One register in one cycle: present 0/1 and the index of its value in rc_input.value. */
typedef struct rc_register {
    uint32_t present;
    uint32_t value;
} rc_register;

/* The functions that the code calls in a cycle whose registers are read on demand. Each gets the context. */
typedef struct rc_probe {
    void* context;
    /* Returns the reading of an input: 0 absent, otherwise 1 + the index of its value. It is the same throughout a
     * cycle. */
    uint32_t (*read)(void* context, uint32_t input);
    /* Returns only the index of the value; 0 if the register is absent. */
    uint32_t (*value)(void* context, uint32_t input);
    /* Called when the code consumes the input, or raises it itself. It then no longer asks whether it is present. */
    void (*assigned)(void* context, uint32_t input);
    /* Called at the beginning of a round of transitions. The rest of the cycle depends on the bytes of the state, on
     * `size` bytes at `step` (which contain what has been read and consumed), and on the values of the inputs. It
     * depends on steps_left only if the rest of the cycle takes that many steps. */
    void (*round)(void* context, const void* step, uint32_t size, const void* state, uint32_t steps_left);
} rc_probe;

/* A comparison of a linear form of the parts of one input value with zero. */
typedef struct rc_comparison {
    uint32_t type;           /* type of the value: an index into rc_tracking.parts */
    int64_t coefficient[ROBOCHART_MAX_PARTS];
    int64_t constant;        /* in the units of the parts: reals times the scale of tracked numbers */
} rc_comparison;

/* A part of the sequences of a type: the least or greatest number at some places. */
typedef struct rc_window {
    uint32_t type;
    uint32_t part;           /* an index into rc_comparison.coefficient; 0 is the size */
    uint32_t greatest;       /* 0: the least number */
    const uint64_t* places;  /* ROBOCHART_MAX_PLACES bits; the lowest bit of the first word is place 1. The last place
                              * represents all places after it too. */
} rc_window;

/* Uses of input values that are neither copies nor comparisons of a linear form. */
#define RC_TRACKED_RELATION 1U /* it compared two input values */
#define RC_TRACKED_OUTPUT 2U   /* an output was computed */
#define RC_TRACKED_NATIVE 4U   /* an index, a duration or a loop depended on a value */
#define RC_TRACKED_INEXACT 8U  /* a number was computed in another way, so the numbers are wrong from there on */

/* The same code over the types of deployment. An input of a tracked type is given as the index of a value among the
 * values that were set. An output of such a type is logged as the index of the first equal value; -1: there is none. */
typedef struct rc_deployed {
    uint32_t state_size;     /* in bytes; states are trivially copyable */
    const uint32_t* capacity; /* for each type: how many items its sequences can have; 0: its values are no sequences */
    /* Sets the values of a type, number by number: the bits of a double, or a 64-bit integer. They are not copied. The
     * length of a sequence comes before its items. */
    void (*set_values)(uint32_t type, uint32_t count, const int64_t* numbers);
    void (*initial)(void* state);
    rc_result (*step)(void* state, const rc_register* registers, rc_log* log);
    uint32_t (*equal)(const void* state, const void* other);
    void (*print)(const void* state, char* buffer, size_t size);
} rc_deployed;

/* The interface of code with tracked numbers (robochart/tracked.hpp). */
typedef struct rc_tracking {
    uint32_t types;          /* number of types at the boundary: of inputs, then of outputs, in order */
    const uint32_t* parts;   /* for each type: how many numbers a value has; 0: its values are sequences */
    const int32_t* input;    /* for each input: its type; -1: another type */
    /* Sets the explored values of a type, number by number; the length of a sequence comes before its items. Type 0
     * must be set first; this forgets everything. Returns 0 if there are too many values. */
    uint32_t (*set_values)(uint32_t type, uint32_t count, const int64_t* numbers);
    /* Return what the code has done since then: its comparisons, without duplicates, and a set of RC_TRACKED_ flags. */
    uint32_t (*comparisons)(const rc_comparison** list);
    uint32_t (*losses)(void);
    /* Returns the windows of sequences that the code has read. */
    uint32_t (*windows)(const rc_window** list);
    const rc_deployed* deployed;
} rc_tracking;

typedef struct rc_interface {
    uint32_t abi_version;
    const char* component;   /* "AggregationFSM" */
    uint32_t state_size;     /* in bytes; states are trivially copyable and canonical: equal states have equal bytes */
    uint32_t inputs;
    const rc_input* input;
    uint32_t outputs;
    const rc_output* output;
    int64_t scale;           /* reals are multiples of 1/scale */
    void (*initial)(void* state);
    rc_result (*step)(void* state, const rc_register* registers, rc_log* log);
    /* Writes "state=S1 T=3 reached=true" (at most size bytes, terminated). */
    void (*print)(const void* state, char* buffer, size_t size);
    /* The event API of the same state; null if no event is received. The first `events` inputs are events.
     * `dispatch` processes one event with the value in its register, ignoring the other registers. With `event` equal
     * to `events`, it starts the machine or takes transitions that need no event. `pass` is a cycle without inputs; it
     * appends to the log. */
    uint32_t events;
    rc_result (*dispatch)(void* state, uint32_t event, const rc_register* registers, rc_log* log);
    rc_result (*pass)(void* state, rc_log* log);
    /* Like `step`, with registers that are read on demand; null if this is not possible. */
    rc_result (*probe)(void* state, const rc_probe* probe, rc_log* log);
    /* Null if the code computes with finite carriers. Otherwise, an input of a tracked type has no values in its table,
     * and an output of such a type is logged as the index of its value; -1: not an explored value. */
    const rc_tracking* tracking;
} rc_interface;

/* The only exported symbol, also of objects compiled with -fvisibility=hidden. */
#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
const rc_interface* robochart_explore(void);

#ifdef __cplusplus
}
#endif

#endif
