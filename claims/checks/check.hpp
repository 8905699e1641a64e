// SPDX-License-Identifier: Apache-2.0
// Resolves names, values and durations of claims in a model.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "claims/checks/checked.hpp"
#include "claims/syntax/syntax.hpp"

namespace robochart::claims {

/// The model that claims are about.
struct ClaimedModel {
    const ir::System& system;
    std::vector<std::string> packages;  ///< packages of all files of the model
    std::vector<std::string> names;     ///< names of the model's assertions, which claims must not use
};

/// Resolves the claims of these files and reports findings. The result contains the claims without errors.
[[nodiscard]] CheckedClaims check_claims(const std::vector<std::shared_ptr<const ClaimFile>>& files,
                                         const ClaimedModel& model, const diagnostics::SourceManager& sources,
                                         diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::claims
