// SPDX-License-Identifier: Apache-2.0
// Data about the claims of a project's claims files (docs/claims.md), from the texts to the script.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "claims/checks/checked.hpp"
#include "claims/decide/decision.hpp"
#include "claims/decide/letters.hpp"
#include "claims/syntax/syntax.hpp"
#include "csp_emit/base/emission.hpp"

namespace robochart::driver {

/// A claim in the timed script.
struct ScriptedClaim {
    std::vector<claims::Letter> letters;
    claims::Decision decision;
    /// True if every run of the script is a run of the model that shows the facts at the right moments. If this is
    /// false, the script has additional runs. In both cases, a claim holds for the model if it holds for all runs of
    /// the script.
    bool exact = true;
};

/// A timed script whose machines show the states and variables that some claims read (csp_emit/showing.hpp).
struct ShowingScript {
    std::set<std::string> claims;  ///< names of the claims
    claims::ShownFacts shown;
    std::unique_ptr<csp_emit::Emission> emission;
};

struct Project;

/// The claims that set the same constants, with the project in which they are decided (instantiated_claims.hpp).
struct InstantiatedClaims {
    std::vector<std::string> settings;  ///< as in CheckedClaim::settings
    std::shared_ptr<Project> project;
};

struct ProjectClaims {
    bool ignored = false;                                         ///< true if only the time unit of the files is used
    std::vector<std::shared_ptr<const claims::ClaimFile>> files;  ///< the files as read
    claims::CheckedClaims checked;                                ///< resolved in the project's system
    std::vector<ScriptedClaim> scripted;                          ///< indexed by the numbers of the resolved claims
    std::vector<ShowingScript> showing;                           ///< made by showing_scripts
    std::vector<std::string> settings;                            ///< the constants that claims set in this project
    std::vector<InstantiatedClaims> instantiated;                 ///< for the claims that set other constants
};

}  // namespace robochart::driver
