// SPDX-License-Identifier: Apache-2.0
// Declares the data that the writers of one machine's code share: the plan, the threads, and the text written so far.
#pragma once

#include <string>
#include <vector>

#include "cpp_emit/code/machine_plan.hpp"
#include "cpp_emit/code/resumable_code.hpp"
#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/machine/frame_layout.hpp"

namespace robochart::cpp_emit {

/// A state's during action as a separate thread.
struct DuringThread {
    ir::NodeId state;
    std::string suffix;  ///< suffix of its members and functions: during_SUFFIX, cut_SUFFIX
    NameScope labels;
    Thread thread;
};

/// The deadline of a transition. After its source is entered, and while its guard holds, the source must be left in
/// time (semantics 3.10).
struct Watch {
    ir::TransitionId transition;
    ir::NodeId state;
    std::string field;  ///< member of the frame: remaining time plus one, 0 when the state is not active
};

struct MachineContext {
    /// All arguments must outlive the object. Reserves names for the enumerations of the machine.
    MachineContext(const Generation&, const Unit&, const Layouts& done, NameScope& type_names);
    MachineContext(const MachineContext&) = delete;
    MachineContext& operator=(const MachineContext&) = delete;

    /// Returns whether the during action is executed when the state is entered. This is possible if the state has no
    /// children, and the action never waits and runs alone. It then has the same effect as a separate thread.
    [[nodiscard]] bool runs_on_entry(ir::NodeId) const;
    /// Returns the head of a function of the unit: `name(frames) noexcept {`.
    [[nodiscard]] std::string function_head(const std::string& name) const;
    /// Returns the call `name(f)`, with the frames that the unit's functions take as arguments.
    [[nodiscard]] std::string function_call(const std::string& name) const;
    /// Returns the condition that the thread calls the operation: "f.at == At::S1_1 || f.at == At::S1_2".
    [[nodiscard]] static std::string in_call(const Thread&, const CallFrame&);
    /// Returns the call of the called operation's function: `name(f.turn, ...)`.
    [[nodiscard]] std::string call_inside(const CallFrame&, const std::string& name) const;

    const Generation& generation;
    const Unit& unit;
    const Layouts& done;  ///< layouts of the operations that the unit calls
    MachinePlan plan;
    NameScope fields;  ///< members of the frame
    Thread control;
    std::vector<DuringThread> during;
    std::vector<Watch> watches;
    std::string leaving;                ///< enumeration of transitions in progress; "" if there is none
    std::string next;                   ///< enumeration of transitions that ended the last cycle; "" if there is none
    std::vector<ir::NodeId> histories;  ///< Fault::composite_resumed: composite states that remember their inner state
    CodeWriter out{1};
};

/// The base class of the classes that write parts of the code. It gives them short names for the data of the context.
class MachineCodePart {
protected:
    explicit MachineCodePart(MachineContext& context)
        : context_(context),
          generation_(context.generation),
          unit_(context.unit),
          plan_(context.plan),
          control_(context.control),
          during_(context.during),
          watches_(context.watches),
          out_(context.out) {}

    [[nodiscard]] std::string function_head(const std::string& name) const { return context_.function_head(name); }
    [[nodiscard]] std::string function_call(const std::string& name) const { return context_.function_call(name); }
    [[nodiscard]] std::string frame_type() const { return unit_.frame + "<Types>"; }

    MachineContext& context_;
    const Generation& generation_;
    const Unit& unit_;
    const MachinePlan& plan_;
    Thread& control_;
    std::vector<DuringThread>& during_;
    std::vector<Watch>& watches_;
    CodeWriter& out_;
};

}  // namespace robochart::cpp_emit
