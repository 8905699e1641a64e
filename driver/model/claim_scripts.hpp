// SPDX-License-Identifier: Apache-2.0
// Adds the claims of a project to its timed script.
#pragma once

#include <optional>
#include <vector>

#include "csp_emit/base/emission.hpp"

namespace robochart::driver {

struct Project;
struct ShowingScript;

/// Adds processes, assertions and an obligation for each claim; fills `ProjectClaims::scripted`. A claim that cannot
/// be decided has an obligation without assertions, with the reason.
void add_claims(Project& project, csp_emit::Emission& emission);

/// The number of the claim that an obligation of add_claims is about; no value for other obligations. Names of claims
/// are unique, and obligations of swarms, which have names too, are in projects whose claims are not added.
[[nodiscard]] std::optional<std::size_t> claim_of(const Project& project, const csp_emit::Obligation& obligation);

/// True if the obligation is a claim that another script decides: it reads states or variables (showing_scripts), or it
/// sets constants (instantiated_claims.hpp).
[[nodiscard]] bool is_in_other_script(const Project& project, const csp_emit::Obligation& obligation);

/// The scripts for the claims that read states or variables; made on the first request.
[[nodiscard]] const std::vector<ShowingScript>& showing_scripts(Project& project);

}  // namespace robochart::driver
