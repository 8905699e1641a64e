// SPDX-License-Identifier: Apache-2.0
// Implements a controller by hand for the API in explore_abi.h. It tests the explorer and the conformance check. The
// robot drives until it sees a robot, and turns until it sees a wall. Each operation takes one cycle. FAULT selects a
// defect.
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "explore_abi.h"

#ifndef FAULT
#define FAULT 0
#endif

namespace {

enum At : unsigned char { start, driving, turning };

struct State {
    unsigned char at;
    unsigned char extra;  // used by some faults, otherwise 0
};

const std::int64_t speeds[] = {-2, 2};
const char* const speed_texts[] = {"-2", "2"};
const std::array<rc_input, 3> inputs{{
    {"seeRobot.in", 0, nullptr, nullptr},
    {"seeWall.in", 0, nullptr, nullptr},
    {"speed.in", 2, speeds, speed_texts},
}};
const std::array<rc_output, 2> outputs{{{"DriveCall", 1}, {"TurnCall", 0}}};

void write(rc_log* log, unsigned output, std::int64_t argument) {
    rc_record& record = log->record[log->count++];
    record.output = output;
    record.count = outputs[output].arguments;
    record.argument[0] = argument;
}

void initial(void* state) {
    State fresh{};
#if FAULT == 10  // leaves a byte unwritten
    static_cast<State*>(state)->at = start;
#else
    std::memcpy(state, &fresh, sizeof fresh);
#endif
}

std::int64_t speed(const rc_register* registers) {
#if FAULT == 1  // wrong argument
    return registers[2].present != 0 ? -speeds[registers[2].value] : 2;
#else
    return registers[2].present != 0 ? speeds[registers[2].value] : 2;
#endif
}

#if FAULT == 8
unsigned steps_of_all = 0;  // memory outside the state
#endif

rc_result step(void* memory, const rc_register* registers, rc_log* log) {
    State& state = *static_cast<State*>(memory);
    bool robot = registers[0].present != 0;
    const bool wall = registers[1].present != 0;
#if FAULT == 2  // an input survives its cycle
    if (robot) state.extra = 1;
    if (state.at == driving && state.extra != 0) robot = true;
#elif FAULT == 8
    if (++steps_of_all % 7 == 0) robot = false;
#elif FAULT == 9  // an infinite number of states
    ++state.extra;
#endif
    if (state.at == start) {
        write(log, 0, 2);
        state.at = driving;
#if FAULT == 3  // does not wait for the next cycle
        if (robot) {
            write(log, 1, 0);
            state.at = turning;
        }
#elif FAULT == 11
        return RC_TERMINATED;
#endif
#if FAULT == 13  // waits for seeRobot in every cycle, with a deadline of 0
    } else if (state.at == driving) {
        return robot ? RC_QUIESCENT : RC_DEADLINE;
#endif
    } else if (state.at == driving && robot) {
#if FAULT == 2
        state.extra = 0;
#endif
#if FAULT == 4    // lost output
#elif FAULT == 5  // an additional output
        write(log, 1, 0);
        write(log, 0, 2);
#elif FAULT == 6
        return RC_PRECONDITION;
#elif FAULT == 7
        return RC_STEP_BOUND;
#else
        write(log, 1, 0);
#endif
        state.at = turning;
    } else if (state.at == turning && wall) {
        write(log, 0, speed(registers));
        state.at = driving;
    }
    return RC_QUIESCENT;
}

void print(const void* memory, char* buffer, std::size_t size) {
    static const char* const names[] = {"start", "driving", "turning"};
    const State& state = *static_cast<const State*>(memory);
    std::snprintf(buffer, size, "state=%s", state.at < 3 ? names[state.at] : "?");
}

#if FAULT == 12
constexpr std::uint32_t version = ROBOCHART_ABI_VERSION + 1;
#else
constexpr std::uint32_t version = ROBOCHART_ABI_VERSION;
#endif

const rc_interface interface {
    version, "Turner", sizeof(State), inputs.size(), inputs.data(), outputs.size(), outputs.data(),
        1, initial, step, print
};

}  // namespace

extern "C" const rc_interface* robochart_explore(void) {
    return &interface;
}
