// SPDX-License-Identifier: Apache-2.0
#include "app/claims/script_basis.hpp"

#include <algorithm>
#include <chrono>
#include <new>

#include "app/command/run.hpp"
#include "checker/lts/graph.hpp"
#include "checker/lts/tau_components.hpp"

namespace robochart::app {
namespace {

/// More states are not looked at.
constexpr std::size_t most_states = 50'000;

/// There are more.
struct TooMany {};

bool can_go_on_internally(cspm::Session& session, const cspm::ExprPtr& process, const driver::SearchContext& search) {
    const refine::Limits bounds = driver::limits_of_check(search);
    const auto system = session.system(process, bounds);
    const lts::Exploration all = lts::explore(*system, [&](std::size_t states) {
        if (states > most_states) throw TooMany{};
        search.services.budget().poll();
        if (bounds.deadline && std::chrono::steady_clock::now() >= *bounds.deadline) throw TooMany{};
    });
    const lts::TauComponents taus = lts::tau_components(all.graph);
    return std::ranges::find(taus.cyclic, true) != taus.cyclic.end();
}

}  // namespace

driver::Basis basis_of(cspm::Session& session, const cspm::Decl& assertion, const cspm::AssertionResult& result,
                       const driver::SearchContext& search) {
    const cspm::Assertion& asked = assertion.assertion;
    const bool holds = result.verdict.outcome == refine::Outcome::holds && !asked.negated;
    const bool of_failures = asked.model == cspm::Model::failures && asked.kind != cspm::AssertionKind::has_trace;
    if (!holds || !of_failures || result.verdict.statistics.states > most_states) return {};
    const bool refinement = asked.kind == cspm::AssertionKind::refinement;
    try {
        // With priorities internal events may be kept from happening: that process is another one.
        if (asked.tau_priority ||
            !can_go_on_internally(session, refinement ? asked.implementation : asked.specification, search))
            return {};
    } catch (const TooMany&) {
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
