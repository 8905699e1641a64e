// SPDX-License-Identifier: Apache-2.0
// Adds the claims of a project to its timed script.
#pragma once

#include <optional>
#include <vector>

#include "csp_emit/base/emission.hpp"

namespace robochart::driver {

struct Project;
struct ShowingScript;

/// Adds processes, assertions and an obligation for each claim, and fills `ProjectClaims::scripted`. If a claim cannot
/// be decided, its obligation has no assertions and contains the reason.
void add_claims(Project& project, csp_emit::Emission& emission);

/// If add_claims has added the obligation, returns the number of the claim that it belongs to. Returns no value for
/// other obligations. The function finds the claim by its name, because this name is unique. Obligations of swarms also
/// have names, but add_claims is not called for projects with swarms.
[[nodiscard]] std::optional<std::size_t> claim_of(const Project& project, const csp_emit::Obligation& obligation);

/// Returns true if the obligation is a claim that another script decides: it reads states or variables
/// (showing_scripts), or it sets constants (instantiated_claims.hpp).
[[nodiscard]] bool is_in_other_script(const Project& project, const csp_emit::Obligation& obligation);

/// Returns the scripts for the claims that read states or variables. The first call makes these scripts.
[[nodiscard]] const std::vector<ShowingScript>& showing_scripts(Project& project);

}  // namespace robochart::driver
