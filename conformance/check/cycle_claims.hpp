// SPDX-License-Identifier: Apache-2.0
// Decides claims about control cycles (docs/claims.md, "Claims about one cycle") for the model run in cycles,
// NF_c(M), and for the code, L(G). A monitor of the claim follows all runs of both. A claim about cycles is a safety
// property: if it fails, a finite run shows this. So a breadth-first search of the product with the monitor decides
// the claim.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "checker/refine/search/limits.hpp"
#include "claims/checks/checked.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/code_system.hpp"
#include "conformance/model/model_graph.hpp"
#include "csp_emit/base/emission.hpp"

namespace robochart::conformance {

/// The claims to decide, and the data that they need.
struct CycleClaims {
    std::vector<claims::CheckedClaim> claims;
    std::optional<std::int64_t> unit;  ///< nanoseconds of a time unit, if declared
    bool carriers = true;  ///< events have all values of the carriers; false: a few that represent all of them
    std::map<std::string, std::string> refused = {};  ///< by the name of a claim: why it is not decided for this code
};

/// The model that the claims are about.
struct ClaimedModel {
    const ir::System& system;
    const csp_emit::Provenance& provenance;
};

/// Returns true if a condition of the claim reads values of events. Such a claim is decided only for the values of the
/// carriers.
[[nodiscard]] bool reads_values(const claims::CheckedClaim& claim);

/// Decides the claims for the model in cycles and for the code. An inconclusive answer contains the reason.
[[nodiscard]] std::vector<CycleAnswers> decide_cycle_claims(const CycleClaims& claims, const ClaimedModel& claimed,
                                                            ModelGraph& model, const Alphabet& alphabet,
                                                            const rc_interface& code, std::uint32_t cycle_length,
                                                            const refine::Limits& limits);

}  // namespace robochart::conformance
