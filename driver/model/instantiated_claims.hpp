// SPDX-License-Identifier: Apache-2.0
// Claims that set constants: `with constant patience of Patrol set to 3 s`. Claims that set the same values share a
// project: the same system with these values, in its own finite instantiation, as if `--const` had given them. So all
// limits that depend on constants (carriers, clocks) fit the values.
#pragma once

#include <string>
#include <vector>

#include "claims/checks/checked.hpp"
#include "driver/model/project.hpp"
#include "semantics/instantiate/instantiate.hpp"

namespace robochart::driver {

/// Makes the projects of the claims that set constants, from the resolved claims. A project that cannot be made finite
/// is reported at the claims.
void instantiate_claims(Project& project, ir::Carriers carriers);

/// The project in which the claim is decided: that of its constants, or the project itself.
[[nodiscard]] Project& project_of(Project& project, const claims::CheckedClaim& claim);
/// Returns true if another project decides the claim.
[[nodiscard]] bool has_own_project(const Project& project, const claims::CheckedClaim& claim);

/// The reason why a run or code of the project does not show whether the claim holds: the claim sets constants to other
/// values. "" if all values are equal. `weaker`: values for which the run was made, unless options override them:
/// "patience=3".
[[nodiscard]] std::string why_other_constants(const Project& project, const claims::CheckedClaim& claim,
                                              const std::vector<std::string>& weaker = {});

}  // namespace robochart::driver
