// SPDX-License-Identifier: Apache-2.0
// Determines the order of the events in a cycle from the claims files of a project. Generated code, monitors and the
// comparison with logs use this order.
#pragma once

#include "cpp_emit/plan/options.hpp"
#include "driver/claims/followed_claim.hpp"
#include "driver/model/project.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::app {

/// Returns the orders of the component, of its parts, and of the machines and controllers that run in it. Reports an
/// order if it drops an event that the platform of the component does not raise.
[[nodiscard]] cpp_emit::EventOrder event_order(driver::Project& project, const ir::ComponentRef& component);

/// Returns the events that the declared orders of the component with this path drop. Claims are followed along its runs
/// with these drops.
[[nodiscard]] driver::FollowedClaim::Drops dropped_events(const driver::Project& project, const std::string& path);

/// Returns the order as text: "estop first; reset dropped where estop is raised"; "" if there is no order.
[[nodiscard]] std::string order_text(const ir::System& system, const cpp_emit::EventOrder& order);

}  // namespace robochart::app
