// SPDX-License-Identifier: Apache-2.0
// Computes the struct of a machine's state, and the enumerations of its members.
#pragma once

#include "cpp_emit/machine/time_code.hpp"

namespace robochart::cpp_emit {

/// Describes the struct and its enumerations. The threads must have been written before.
class FrameCode : private MachineCodePart {
public:
    FrameCode(MachineContext& context, const TimeCode& time) : MachineCodePart(context), time_(time) {}

    /// Returns the struct of the machine's state, including the members `more`.
    [[nodiscard]] FrameLayout make_layout(const std::vector<Field>& more);
    /// Returns the values of Frame::at: nodes in which control rests, and places of programs that may wait.
    [[nodiscard]] Enumeration control_points() const;
    /// Returns all enumerations of the frame. The first one contains the places.
    [[nodiscard]] std::vector<Enumeration> all_enumerations() const;

private:
    [[nodiscard]] ir::NodeId target_of(const std::string& label) const;
    [[nodiscard]] std::vector<Field> variable_fields() const;
    void thread_field(std::vector<Field>& fields, const Thread&, const std::string& wait) const;
    [[nodiscard]] std::vector<Field> thread_fields() const;

    const TimeCode& time_;
};

}  // namespace robochart::cpp_emit
