// SPDX-License-Identifier: Apache-2.0
// The order of the events in a cycle, as the claims files of a project declare it. Generated code, monitors and the
// comparison with logs use it.
#pragma once

#include "cpp_emit/plan/options.hpp"
#include "driver/claims/followed_claim.hpp"
#include "driver/model/project.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::app {

/// The orders of the component, of its parts, and of the machines and controllers that run in it. Reports orders that
/// drop events which the platform of the component does not raise.
[[nodiscard]] cpp_emit::EventOrder event_order(driver::Project& project, const ir::ComponentRef& component);

/// The events that the orders of the component with this path drop, for claims along its runs.
[[nodiscard]] driver::FollowedClaim::Drops dropped_events(const driver::Project& project, const std::string& path);

/// The order as text: "estop first; reset dropped where estop is raised"; "" if there is no order.
[[nodiscard]] std::string order_text(const ir::System& system, const cpp_emit::EventOrder& order);

}  // namespace robochart::app
