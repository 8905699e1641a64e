// SPDX-License-Identifier: Apache-2.0
// Handles claims that set constants, as in `with constant patience of Patrol set to 3 s`. Claims that set the same
// values share a project. This project contains the same system with these values, in a separate finite instantiation,
// as if `--const` had set the values. So all limits that depend on constants (carriers, clocks) fit the values.
#pragma once

#include <string>
#include <vector>

#include "claims/checks/checked.hpp"
#include "driver/model/project.hpp"
#include "semantics/instantiate/instantiate.hpp"

namespace robochart::driver {

/// Makes the projects for the resolved claims that set constants. If a project cannot be made finite, reports this at
/// the places of its claims.
void instantiate_claims(Project& project, ir::Carriers carriers);

/// Returns the project in which the claim is decided: the project for the constants that the claim sets, or the given
/// project if the claim sets no constants.
[[nodiscard]] Project& project_of(Project& project, const claims::CheckedClaim& claim);
/// Returns true if the claim is decided in another project.
[[nodiscard]] bool has_own_project(const Project& project, const claims::CheckedClaim& claim);

/// Returns a reason if the claim sets constants to other values than the project has. In this case, a run or the code
/// of the project does not show whether the claim holds. Returns "" if all values are equal. `weaker`: the values with
/// which the run was made, such as "patience=3", unless options override them.
[[nodiscard]] std::string why_other_constants(const Project& project, const claims::CheckedClaim& claim,
                                              const std::vector<std::string>& weaker = {});

}  // namespace robochart::driver
