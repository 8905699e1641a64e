// SPDX-License-Identifier: Apache-2.0
// Decides `has trace` by searches along one trace. The searches use the reduced form if there is one. `not P :[has
// trace [T]]: t` is equivalent to a refinement: P refines the process with all traces except t.
#include <algorithm>
#include <string>

#include "checker/refine/verdict/check.hpp"
#include "checker/refine/verdict/counterexample.hpp"
#include "checker/refine/verdict/monitors.hpp"
#include "checker/refine/verdict/question.hpp"
#include "checker/refine/verdict/reduction.hpp"
#include "checker/refine/verdict/reference.hpp"

namespace robochart::refine {
namespace {

using process::Event;

/// Returns true if the symmetry maps runs along the trace to runs along the trace.
bool fixes(const lts::EventPermutation& exchange, const std::vector<Event>& trace) {
    return std::ranges::none_of(exchange, [&](const auto& moved) {
        return moved.first != moved.second && std::ranges::find(trace, moved.first) != trace.end();
    });
}

/// Returns the result of `search` as a run of the system. `search` may get the reduced form instead of the system,
/// because both have the same traces, and the same refusals and divergences along them.
std::optional<Violation> search_along(
    lts::TransitionSystem& system, const std::vector<Event>& trace, Budget& budget, Statistics& statistics,
    bool shortest,
    const std::function<std::optional<Violation>(lts::TransitionSystem&, Budget&, Statistics&)>& search) {
    const SearchQuestion question{[&](lts::TransitionSystem& searched, Budget& own, Statistics& size,
                                      const Violation* /*known*/) { return search(searched, own, size); },
                                  [&](const lts::EventPermutation& exchange) { return fixes(exchange, trace); },
                                  shortest};
    return search_reduced(system, budget, statistics, question);
}

/// A run with the first events of the trace, and how many of its events a run can perform at most.
struct Reached {
    std::optional<Violation> violation;
    std::size_t furthest = 0;
};

Reached find_trace_end(lts::TransitionSystem& system, const std::vector<Event>& trace, std::size_t events,
                       Budget& budget, Statistics& statistics, bool shortest) {
    Reached reached;
    const auto search = [&](lts::TransitionSystem& searched, Budget& own, Statistics& size) {
        TraceMonitor monitor(trace, events);
        Search along(searched, monitor, own);
        const Tally tally(along, size);
        const std::optional<Finding> end = along.first_violation();
        reached.furthest = std::max(reached.furthest, monitor.furthest_node());
        return end ? std::optional(violation_of(along, searched, *end)) : std::nullopt;
    };
    reached.violation = search_along(system, trace, budget, statistics, shortest, search);
    return reached;
}

/// Follows every run along the trace. Records the first event of the trace that a state on the way can refuse.
class RefusalsAlong final : public Monitor {
public:
    explicit RefusalsAlong(const std::vector<Event>& trace) : trace_(trace) {}
    Node start() override { return 0; }
    Advance advance(Node node, Event event) override {
        if (node >= trace_.size() || trace_[node] != event) return {Effect::ignore};
        return {Effect::follow, node + 1};
    }
    std::optional<ViolationKind> examine(Node node, const Offer& offer) override {
        if (node >= trace_.size() || (refused_ && *refused_ <= node)) return std::nullopt;
        const std::optional<process::EventSet> accepted = acceptance(offer);
        if (accepted && !std::ranges::binary_search(*accepted, trace_[node])) refused_ = node;
        return std::nullopt;
    }
    [[nodiscard]] std::optional<std::size_t> refused_position() const { return refused_; }

private:
    const std::vector<Event>& trace_;
    std::optional<std::size_t> refused_;
};

struct Doubts {
    bool diverges = false;
    std::optional<std::size_t> refused;  ///< index in the trace
};

Doubts doubts_along(lts::TransitionSystem& system, const std::vector<Event>& trace, bool divergence, Budget& budget) {
    Doubts doubts;
    Statistics ignored;
    const auto search = [&](lts::TransitionSystem& searched, Budget& own,
                            Statistics& /*size*/) -> std::optional<Violation> {
        RefusalsAlong monitor(trace);
        Search along(searched, monitor, own, divergence);
        along.first_violation();
        doubts.refused = monitor.refused_position();
        doubts.diverges = divergence && along.first_tau_cycle();
        return std::nullopt;
    };
    search_along(system, trace, budget, ignored, false, search);
    return doubts;
}

/// Makes the verdict inconclusive if the answer is undefined. FDR's manual does not define `has trace` in the failures
/// models. If the system cannot perform the trace, or if it neither refuses nor diverges along the trace, the answer is
/// that of the traces model. Otherwise the answer is undefined.
void doubt_trace(lts::TransitionSystem& system, const std::vector<Event>& trace, Model model, Budget& budget,
                 Verdict& verdict) {
    const std::string open = "; what that means for 'has trace' outside the traces model is not defined: use [T]";
    const Doubts doubts = doubts_along(system, trace, model == Model::failures_divergences, budget);
    if (doubts.diverges)
        verdict.reason = "the process can diverge along the trace" + open;
    else if (verdict.outcome == Outcome::fails)
        return;
    else if (doubts.refused)
        verdict.reason = "the process can perform the trace, but can refuse its event " +
                         std::to_string(*doubts.refused + 1) + ", " + system.events().name(trace[*doubts.refused]) +
                         open;
    if (verdict.reason.empty()) return;
    verdict.outcome = Outcome::inconclusive;
    verdict.counterexample.reset();
}

void decide_trace(lts::TransitionSystem& system, const std::vector<Event>& trace, Budget& budget, Verdict& verdict) {
    const Reached whole = find_trace_end(system, trace, trace.size(), budget, verdict.statistics, false);
    if (whole.violation) {
        confirm_trace(system, trace, whole.violation->run, budget);
        verdict.outcome = Outcome::holds;
        return;
    }
    Statistics ignored;
    const Reached prefix = find_trace_end(system, trace, whole.furthest, budget, ignored, true);
    const auto judge = [&](lts::TransitionSystem& judged, const Violation& shown, Budget& own) {
        confirm_missing_trace(judged, trace, shown.run, own);
    };
    Counterexample counterexample =
        make_counterexample(confirm_violation(system, prefix.violation.value(), budget, judge));
    counterexample.event = trace[whole.furthest];
    verdict.outcome = Outcome::fails;
    verdict.counterexample = std::move(counterexample);
}

}  // namespace

Verdict has_trace(lts::TransitionSystem& system, const std::vector<Event>& trace, Model model, const Limits& limits) {
    return decide({&system}, limits, [&](Budget& budget, Verdict& verdict) {
        decide_trace(system, trace, budget, verdict);
        if (model != Model::traces) doubt_trace(system, trace, model, budget, verdict);
    });
}

}  // namespace robochart::refine
