// SPDX-License-Identifier: Apache-2.0
// Completes the answers to claims of claims files. Explains why a run breaks a claim. Decides whether time can stop
// while a response is pending, and whether the claim's events ever occur.
#pragma once

#include "checker/cspm/session.hpp"
#include "counterexample/interpreter.hpp"
#include "driver/model/pipeline.hpp"
#include "driver/results/results.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::driver {

/// Completes the answer to a claim of the project. `obligation` belongs to this claim, and its assertion has been
/// decided in the given session.
void complete_answer(const Project& project, const runs::Context& context, const SearchContext& search,
                     const csp_emit::Obligation& obligation, std::size_t claim, AssertionReport& report);

}  // namespace robochart::driver
