// SPDX-License-Identifier: Apache-2.0
#include "app/claims/script_basis.hpp"

#include <new>

namespace robochart::app {
namespace {

/// The search for divergence stops at this number of states.
constexpr std::uint64_t most_states = 50'000;

/// True if the process can diverge. The separate search decides no assertion of the run, so it writes no checkpoints
/// for `--checkpoint` and shows no progress.
bool can_go_on_internally(cspm::Session& session, const cspm::ExprPtr& process, const cspm::Decl& assertion,
                          const driver::SearchContext& search) {
    cspm::Decl question = assertion;
    question.assertion = {};
    question.assertion.kind = cspm::AssertionKind::divergence_free;
    question.assertion.specification = process;
    refine::Limits bounds = driver::limits_of_check(search);
    bounds.max_states = most_states;
    bounds.by_levels = nullptr;
    bounds.progress = {};
    return session.check(question, bounds).verdict.outcome == refine::Outcome::fails;
}

}  // namespace

driver::Basis basis_of(cspm::Session& session, const cspm::Decl& assertion, const cspm::AssertionResult& result,
                       const driver::SearchContext& search) {
    const cspm::Assertion& claim = assertion.assertion;
    const bool holds = result.verdict.outcome == refine::Outcome::holds && !claim.negated;
    const bool of_failures = claim.model == cspm::Model::failures && claim.kind != cspm::AssertionKind::has_trace;
    if (!holds || !of_failures || result.verdict.statistics.states > most_states) return {};
    const bool refinement = claim.kind == cspm::AssertionKind::refinement;
    try {
        // With tau priority the implementation is a different process, because priorities can prevent internal events.
        if (claim.tau_priority ||
            !can_go_on_internally(session, refinement ? claim.implementation : claim.specification, assertion, search))
            return {};
    } catch (const diagnostics::LimitReached&) {
        return {};
    } catch (const cspm::EvaluationError&) {
        return {};
    } catch (const std::bad_alloc&) {
        return {};
    }
    return {{driver::GroundKind::never_at_rest,
             "it can go on internally for ever: what it refuses meanwhile is not looked at in the failures model",
             {},
             {},
             {},
             "claim it in the failures divergences model"}};
}

}  // namespace robochart::app
