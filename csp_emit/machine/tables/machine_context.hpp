// A machine in the place where it runs: what its emission starts from.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "csp_emit/base/names.hpp"
#include "csp_emit/base/project.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// A machine in the place where it runs.
struct MachineContext {
    const Project* project = nullptr;
    const ir::Machine* machine = nullptr;
    std::string name;                                  ///< of the CSPM module
    std::string path;                                  ///< qualified CSPM name, "P::C::stm_ref0"
    std::map<std::string, ir::MachineId> definitions;  ///< operations defined in this context
    NameManager names;                                 ///< everything that parameters and functions must not be called
    /// A clock whose first reset matters: the machine remembers whether it has been, and offers `unset__` where a guard
    /// reads it before that, `reset__` wherever it has been.
    std::string watched = {};
    /// An event of which it matters when it is on offer: before the machine does anything else it performs `inside__`
    /// or `outside__`, as it is in `within` or not, so that priority can tell where the event is refused.
    std::string offered = {};
    std::optional<ir::NodeId> within = {};  ///< a state; none: everywhere but at the end

    /// Whether it is a copy for one assertion.
    [[nodiscard]] bool copied() const { return !offered.empty() || !watched.empty(); }
};

}  // namespace robochart::csp_emit
