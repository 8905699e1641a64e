// SPDX-License-Identifier: Apache-2.0
// Computes the normal form that RoboTool gives a state machine before the encoding (R7, R11).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "prism/emit/context.hpp"

namespace robochart::prism_emit {

/// A node of the model, or one that the normal form adds.
struct Place {
    ir::NodeKind kind = ir::NodeKind::state;
    std::string name;
    std::string path;  ///< names from the top, joined by "::"
    std::optional<std::size_t> parent, initial;
    std::vector<ir::StmtPtr> entry;
    bool composite = false;
    bool dropped = false;  ///< whether the node has become unreachable
};

/// A transition of the model, or one that the normal form adds.
struct Step {
    std::string name;
    std::size_t source = 0, target = 0;
    const ir::Communication* trigger = nullptr;
    std::vector<ir::ExprPtr> guards;
    ir::ExprPtr probability;
    std::vector<ir::StmtPtr> action;
    diagnostics::Span span;
};

/// The nodes and transitions of the normal form. The first places are the nodes of the machine, in the order of their
/// ids.
struct Chart {
    std::vector<Place> places;
    std::vector<Step> steps;
};

/// Returns the normal form of a machine or an operation; findings name it as `element`.
[[nodiscard]] Chart normal_form(Context&, const ir::Machine&, const std::string& element);

}  // namespace robochart::prism_emit
