// SPDX-License-Identifier: Apache-2.0
// Defines the input of a machine's emission: the machine and its context.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "csp_emit/base/names.hpp"
#include "csp_emit/base/project.hpp"
#include "csp_emit/base/shown.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// A machine and the context in which it runs.
struct MachineContext {
    const Project* project = nullptr;
    const ir::Machine* machine = nullptr;
    std::string name;                                  ///< name of the CSPM module
    std::string path;                                  ///< qualified CSPM name, "P::C::stm_ref0"
    std::map<std::string, ir::MachineId> definitions;  ///< operations defined in this context
    NameManager names;                                 ///< names that are in use, not available for parameters and
                                                       /// < functions A clock whose first reset is observed. The
                                                       /// machine records whether the clock has been reset. Before the
                                                       /// reset, it offers `unset__` when a guard reads the clock.
                                                       /// After the reset, it always offers `reset__`.
    std::string watched = {};
    /// An event whose offers are observed. Before any other step, the machine performs `inside__` if it is in the state
    /// `within`, and `outside__` otherwise. With these events, priority can detect the states that refuse the event.
    std::string offered = {};
    std::optional<ir::NodeId> within = {};  ///< a state; no value: everywhere except at the end
    /// Facts that the machine shows before any other step (shown.hpp).
    std::vector<ShownFact> shown = {};

    /// True if the machine differs from others of its kind: a copy for one assertion, or a machine that shows facts.
    [[nodiscard]] bool is_special() const { return !offered.empty() || !watched.empty() || !shown.empty(); }
    /// True if the machine shows in which states it is.
    [[nodiscard]] bool shows_states() const {
        return within || std::ranges::any_of(shown, [](const ShownFact& fact) { return fact.state.has_value(); });
    }
};

}  // namespace robochart::csp_emit
