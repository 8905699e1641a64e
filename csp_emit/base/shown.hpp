// SPDX-License-Identifier: Apache-2.0
// Defines the facts about states and variables that machines show (csp_emit/showing.hpp).
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// The expressions of a machine's variables and constants in its process.
struct MachineNames {
    std::function<cspm::ExprPtr(ir::VariableId)> variable;
    std::function<cspm::ExprPtr(ir::ConstantId)> constant;
};

/// A fact about a machine: it is in a state, or a condition over its variables and constants holds.
struct ShownFact {
    std::optional<ir::NodeId> state;
    std::function<cspm::ExprPtr(const MachineNames&)> condition;  ///< if there is no state
};

/// The facts that machines show, by the paths of the machines.
using Shown = std::map<std::string, std::vector<ShownFact>>;

}  // namespace robochart::csp_emit
