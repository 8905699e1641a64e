// SPDX-License-Identifier: Apache-2.0
// Writes the code with which the propagation of writes to a machine waits for the machine's threads (semantics 3.7). A
// thread makes its calls of the platform before other machines write. A communication with a deadline holds up writes
// of other machines.
#pragma once

#include "cpp_emit/machine/machine_context.hpp"

namespace robochart::cpp_emit {

/// Writes the functions prompt and holds_up. The threads must have been written before.
class PropagationCode : private MachineCodePart {
public:
    explicit PropagationCode(MachineContext& context) : MachineCodePart(context) {}

    /// Returns whether threads of the unit or of called operations may resume with a step that holds up writes of other
    /// machines.
    [[nodiscard]] bool has_prompt_steps() const;
    /// Writes `void prompt(f)`, in which the threads execute their prompt steps: they make their calls, or begin to
    /// wait.
    void prompt_function();
    /// Returns whether threads of the unit or of called operations may wait for communications with deadlines.
    [[nodiscard]] bool holds_writes() const;
    /// Writes `bool holds_up(f)`, which returns whether a thread waits for a communication with a deadline.
    void holds_up_function();

private:
    void prompt_steps(const Thread&);
    void write_holding(const Thread&);
    template <class Test>
    [[nodiscard]] bool any_thread(const Test&) const;
};

}  // namespace robochart::cpp_emit
