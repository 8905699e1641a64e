// SPDX-License-Identifier: Apache-2.0
// The claims of a project's claims files (docs/claims.md), from the texts to the script.
#pragma once

#include <memory>
#include <vector>

#include "claims/checks/checked.hpp"
#include "claims/decide/decision.hpp"
#include "claims/decide/letters.hpp"
#include "claims/syntax/syntax.hpp"

namespace robochart::driver {

/// A claim in the timed script.
struct ScriptedClaim {
    std::vector<claims::Letter> letters;
    claims::Decision decision;
};

struct ProjectClaims {
    bool ignored = false;                                         ///< only their time unit is used
    std::vector<std::shared_ptr<const claims::ClaimFile>> files;  ///< as read
    claims::CheckedClaims checked;                                ///< resolved in the project's system
    std::vector<ScriptedClaim> scripted;                          ///< by the numbers of the resolved claims
};

}  // namespace robochart::driver
