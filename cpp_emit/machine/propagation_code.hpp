// SPDX-License-Identifier: Apache-2.0
// Propagation of writes to a machine waits for its threads (semantics 3.7): calls of the platform are made before
// others write, and communications with deadlines hold up writes of others.
#pragma once

#include "cpp_emit/machine/machine_context.hpp"

namespace robochart::cpp_emit {

/// Writes the functions for this; the threads must have been written before.
class PropagationCode : private MachineCodePart {
public:
    explicit PropagationCode(MachineContext& context) : MachineCodePart(context) {}

    /// Whether threads may continue with a step that holds up writes of others, here or in called operations.
    [[nodiscard]] bool prompt() const;
    /// `void prompt(f)`: the threads make their calls, and begin to wait.
    void prompt_function();
    /// Whether threads wait for communications with deadlines, here or in called operations.
    [[nodiscard]] bool holds() const;
    /// `bool holds_up(f)`: whether some thread does.
    void holds_up_function();

private:
    void prompt_steps(const Thread&);
    void holding(const Thread&);
    template <class Test>
    [[nodiscard]] bool any_thread(const Test&) const;
};

}  // namespace robochart::cpp_emit
