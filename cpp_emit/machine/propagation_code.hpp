// What is propagated to a machine waits for its threads (semantics 3.7): calls of the platform are made before others
// write, and communications with deadlines hold up what others write.
#pragma once

#include "cpp_emit/machine/machine_context.hpp"

namespace robochart::cpp_emit {

/// Writes the functions about it, once the threads are written.
class PropagationCode : private MachineCodePart {
public:
    explicit PropagationCode(MachineContext& context) : MachineCodePart(context) {}

    /// Whether threads may go on with what holds up writes of others, here or in operations called.
    [[nodiscard]] bool prompt() const;
    /// `void prompt(f)`: they make their calls, and begin to wait.
    void prompt_function();
    /// Whether threads wait for communications with deadlines, here or in operations called.
    [[nodiscard]] bool holds() const;
    /// `bool holds_up(f)`: some thread does.
    void holds_up_function();

private:
    void prompt_steps(const Thread&);
    void holding(const Thread&);
    template <class Test>
    [[nodiscard]] bool any_thread(const Test&) const;
};

}  // namespace robochart::cpp_emit
