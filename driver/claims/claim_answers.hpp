// SPDX-License-Identifier: Apache-2.0
// Completes the answers to claims of claims files. It explains why a run breaks a claim, and decides whether time can
// stop while a response is pending, and whether the events that the claim is about ever occur.
#pragma once

#include "checker/cspm/session.hpp"
#include "counterexample/interpreter.hpp"
#include "driver/model/pipeline.hpp"
#include "driver/results/results.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::driver {

/// Completes the answer to a claim of the project, of which this is the obligation. Its assertion has been decided in
/// this session.
void complete_answer(const Project& project, const runs::Context& context, const SearchContext& search,
                     const csp_emit::Obligation& obligation, std::size_t claim, AssertionReport& report);

}  // namespace robochart::driver
