// SPDX-License-Identifier: Apache-2.0
// Generates the code of one machine: enumerations of its places, the struct of its state, and its functions (control,
// during actions, transitions, time). cpp_emit/files/core_file.cpp assembles these texts.
#pragma once

#include <string>
#include <vector>

#include "cpp_emit/code/resumable_code.hpp"
#include "cpp_emit/machine/frame_layout.hpp"

namespace robochart::cpp_emit {

struct MachineCode {
    std::vector<Enumeration> enumerations;
    FrameLayout layout;
    std::string methods;           ///< members of Step
    bool leads = false;            ///< a declared order has first events: with several machines, `lead` takes them
    std::string dispatch;          ///< Step::dispatch for a machine whose programs never wait; "" for others
    std::vector<SendSite> sites;   ///< places where its threads wait to send
    std::vector<CallFrame> calls;  ///< operations that its threads run
    std::vector<ViolationPlace> violations;
};

/// Generates the code. `done` contains the layouts of the operations that the unit calls, `type_names` is the scope of
/// the core's namespace, and `more` contains further members of the state.
[[nodiscard]] MachineCode generate_machine(const Generation&, const Unit&, const Layouts& done, NameScope& type_names,
                                           const std::vector<Field>& more);

}  // namespace robochart::cpp_emit
