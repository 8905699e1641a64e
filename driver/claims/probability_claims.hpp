// SPDX-License-Identifier: Apache-2.0
// The probabilistic claims of a model.
#pragma once

#include <memory>
#include <vector>

#include "driver/claims/turns.hpp"
#include "driver/model/pipeline.hpp"
#include "driver/results/results.hpp"

namespace robochart::driver {

/// The probabilistic claims of a model, decided on the Markov models that the settings select.
class ProbabilityClaims {
public:
    /// Lists the claims in the results. Refers to its arguments.
    ProbabilityClaims(Project&, const SearchContext&, ClaimResults&);
    ~ProbabilityClaims();
    ProbabilityClaims(const ProbabilityClaims&) = delete;
    ProbabilityClaims& operator=(const ProbabilityClaims&) = delete;

    void add_to(std::vector<WaitingClaim>& claims);
    /// Frees what claims share.
    void give_back();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
    ClaimResults& results_;
};

}  // namespace robochart::driver
