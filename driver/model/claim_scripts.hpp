// SPDX-License-Identifier: Apache-2.0
// Adds the claims of a project to its timed script.
#pragma once

#include <optional>
#include <vector>

#include "csp_emit/base/emission.hpp"

namespace robochart::driver {

struct Project;
struct ShowingScript;

/// Adds processes, assertions and an obligation for each claim; fills `ProjectClaims::scripted`. A claim that cannot be
/// decided gets an obligation without assertions that contains the reason.
void add_claims(Project& project, csp_emit::Emission& emission);

/// Returns the number of the claim to which an obligation of add_claims belongs; no value for other obligations. The
/// claim is found by its name, which is unique. Obligations of swarms also have names, but add_claims is not called for
/// projects with swarms.
[[nodiscard]] std::optional<std::size_t> claim_of(const Project& project, const csp_emit::Obligation& obligation);

/// Returns true if the obligation is a claim that another script decides: it reads states or variables
/// (showing_scripts), or it sets constants (instantiated_claims.hpp).
[[nodiscard]] bool is_in_other_script(const Project& project, const csp_emit::Obligation& obligation);

/// Returns the scripts for the claims that read states or variables. They are made on the first call.
[[nodiscard]] const std::vector<ShowingScript>& showing_scripts(Project& project);

}  // namespace robochart::driver
