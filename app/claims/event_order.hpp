// SPDX-License-Identifier: Apache-2.0
// The order of events in a cycle that a project's claims files declare, for the generated code of a component.
#pragma once

#include "cpp_emit/plan/options.hpp"
#include "driver/model/project.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::app {

/// The orders of the component, of its parts, and of the machines that run in it.
[[nodiscard]] cpp_emit::EventOrder event_order(const driver::Project& project, const ir::ComponentRef& component);

/// Why the model does not do what the component's code does, so that monitors of the model and logs would report right
/// code; "" if it does.
[[nodiscard]] std::string why_unlike_model(const driver::Project& project, const ir::ComponentRef& component);

/// "estop first; reset dropped where estop is raised"; "" without an order.
[[nodiscard]] std::string order_text(const ir::System& system, const cpp_emit::EventOrder& order);

}  // namespace robochart::app
