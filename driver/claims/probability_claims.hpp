// SPDX-License-Identifier: Apache-2.0
// Decides the probabilistic claims of a model.
#pragma once

#include <memory>
#include <vector>

#include "driver/claims/turns.hpp"
#include "driver/model/pipeline.hpp"
#include "driver/results/results.hpp"
#include "prism/emit/emission.hpp"

namespace robochart::driver {

/// Decides the probabilistic claims of a model on the Markov models that the settings select.
class ProbabilityClaims {
public:
    /// Lists the claims in the results. Stores references to the project and the results. `preferences`: the ranges of
    /// RoboTool's encoding.
    ProbabilityClaims(Project&, const SearchContext&, prism_emit::Preferences preferences, ClaimResults&);
    ~ProbabilityClaims();
    ProbabilityClaims(const ProbabilityClaims&) = delete;
    ProbabilityClaims& operator=(const ProbabilityClaims&) = delete;

    void add_to(std::vector<WaitingClaim>& claims);
    /// Frees the encoding that claims share.
    void give_back();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
    ClaimResults& results_;
};

}  // namespace robochart::driver
