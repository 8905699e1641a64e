// SPDX-License-Identifier: Apache-2.0
// Writes the code that lets time pass in a machine: clocks, waits, deadlines.
#pragma once

#include "cpp_emit/machine/control_steps.hpp"

namespace robochart::cpp_emit {

/// Writes the functions that let time pass. The threads must have been written before.
class TimeCode : private MachineCodePart {
public:
    TimeCode(MachineContext& context, ControlSteps& steps) : MachineCodePart(context), steps_(steps) {}

    /// Returns whether something in the frame changes with time.
    [[nodiscard]] bool is_timed() const;
    /// Writes the function that advances clocks, waits and deadlines.
    void advance_function();
    /// Writes the function that restarts a deadline while its guard does not hold.
    void watch_function();

private:
    void advance_clock(const std::string& clock, std::int64_t saturation);
    void advance_thread(const Thread&);
    [[nodiscard]] std::string guard_text(const ir::Transition&) const;
    void advance_watch(const Watch&);

    ControlSteps& steps_;
};

}  // namespace robochart::cpp_emit
