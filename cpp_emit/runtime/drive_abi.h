/* The C interface between a generated controller, compiled as a shared object with its deployed types (double, 64-bit
 * integers), and simulators, which run many instances of it. One cycle is one call of `step`. A controller is one
 * value of `state_size` bytes, so thousands of them form an array. Delivered with the generated code.
 * Copyright: see LICENSE (Apache-2.0). */
#ifndef ROBOCHART_DRIVE_ABI_H
#define ROBOCHART_DRIVE_ABI_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define ROBOCHART_DRIVE_ABI_VERSION 4
#define ROBOCHART_DRIVE_MAX_ARGUMENTS 8
#define ROBOCHART_DRIVE_MAX_ACTIONS 1024

/* A value of type real is `real`; booleans (0, 1), nat, int and indices of enumeration literals are `whole`. */
typedef union rc_value {
    double real;
    int64_t whole;
} rc_value;

/* One input in one cycle. */
typedef struct rc_signal {
    uint32_t present;
    uint32_t filler;
    rc_value value;
} rc_signal;

/* One output of the controller: a sent event, a called operation, a written shared variable. */
typedef struct rc_action {
    uint32_t output;
    uint32_t count;
    rc_value argument[ROBOCHART_DRIVE_MAX_ARGUMENTS];
} rc_action;

typedef struct rc_actions {
    uint32_t count;
    uint32_t overflow; /* set if a cycle has more than ROBOCHART_DRIVE_MAX_ACTIONS outputs */
    rc_action action[ROBOCHART_DRIVE_MAX_ACTIONS];
} rc_actions;

typedef enum rc_drive_result {
    RC_DRIVE_QUIESCENT = 0,
    RC_DRIVE_TERMINATED = 1,
    RC_DRIVE_STEP_BOUND = 2,   /* a loop that takes no time: the model diverges, or the bound is too small */
    RC_DRIVE_PRECONDITION = 3, /* an operation was called outside its precondition */
    RC_DRIVE_DEADLINE = 4      /* a deadline was missed */
} rc_drive_result;

/* A state machine of the component. */
typedef struct rc_machine {
    const char* name; /* its path in the component: "ctrl0::stm0"; "" if it is the only one */
    uint32_t states;
    const char* const* state; /* "Forward", "Forward::Fast" */
} rc_machine;

typedef struct rc_drive {
    uint32_t abi_version;
    const char* component;
    uint32_t state_size; /* size of a controller in bytes */
    uint32_t state_alignment;
    uint32_t inputs;
    const char* const* input; /* "seeRobot.in", "set_EXT_reached" */
    uint32_t outputs;
    const char* const* output; /* "out.out", "MoveCall", "set_linearSpeed" */
    uint32_t machines;
    const rc_machine* machine;
    void (*initial)(void* controller, uint64_t seed); /* seed: for the choices at probabilistic junctions */
    rc_drive_result (*step)(void* controller, const rc_signal* signals, rc_actions* actions);
    /* The innermost active state of a machine as an index into its states; the number of states if none is active. */
    uint32_t (*state_of)(const void* controller, uint32_t machine);
    const char* (*place_of)(const void* controller); /* the current element of the first machine, with file and line */
} rc_drive;

/* The only exported symbol, also of objects compiled with -fvisibility=hidden. */
#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
const rc_drive*
robochart_drive(void);

#ifdef __cplusplus
}
#endif

#endif
