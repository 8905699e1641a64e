// Determinism after its definition (UCS 10.5): P is deterministic if it is divergence free [FD only] and there are no
// trace s and event a such that s^<a> is a trace of P and P can refuse {a} after s. On the normal form this reads:
// every acceptance of every node contains all that the node can perform. The normal form is explored breadth first, so
// the trace told is a shortest one; for a deterministic process all states of a node are alike and the nodes are few.
// In F a divergent state simply contributes no acceptance.
#include <algorithm>

#include "checker/refine/counterexample.hpp"
#include "checker/refine/monitors.hpp"
#include "checker/refine/question.hpp"
#include "checker/refine/reference.hpp"

namespace robochart::refine {
namespace {

using process::Event;
using process::EventSet;

struct Ambiguity {
    std::vector<Event> trace;
    Event event;
};

/// An event that is possible here, yet missing in some acceptance.
std::optional<Event> refusable(NormalForm& normal, NormalForm::Node node) {
    const EventSet initials = normal.initials(node);
    for (const EventSet& accepted : normal.acceptances(node))
        for (Event event : initials)
            if (!std::binary_search(accepted.begin(), accepted.end(), event)) return event;
    return std::nullopt;
}

std::optional<Ambiguity> first_ambiguity(NormalForm& normal) {
    struct Arrival {
        NormalForm::Node from;
        Event event;
    };
    std::vector<Arrival> arrivals{
        {0, process::tau}};  // per node, how it was first reached; nodes are numbered in that order
    normal.initial();
    for (NormalForm::Node node = 0; node < arrivals.size(); ++node) {
        if (const std::optional<Event> event = refusable(normal, node)) {
            Ambiguity ambiguity{{}, *event};
            for (NormalForm::Node at = node; at != 0; at = arrivals[at].from)
                ambiguity.trace.push_back(arrivals[at].event);
            std::reverse(ambiguity.trace.begin(), ambiguity.trace.end());
            return ambiguity;
        }
        for (Event event : normal.initials(node))
            if (normal.after(node, event).value() == arrivals.size()) arrivals.push_back({node, event});
    }
    return std::nullopt;
}

/// The shortest run of the trace to a state that can refuse the event.
Violation refusing_run(lts::TransitionSystem& system, const Ambiguity& ambiguity, Budget& budget) {
    TraceMonitor monitor(ambiguity.trace, ambiguity.trace.size(), ambiguity.event);
    Search search(system, monitor, budget);
    Violation violation = violation_of(search, system, search.first_violation().value());
    violation.event = ambiguity.event;
    return violation;
}

std::optional<Violation> divergence_of(lts::TransitionSystem& system, Budget& budget, Statistics& statistics) {
    StateMonitor monitor(false);
    Search search(system, monitor, budget, true);
    const Tally tally(search, statistics);
    search.first_violation();
    return first_divergence(search);
}

/// Nodes are counted, and told while they are made, also where a limit ends it.
class Normalising {
public:
    Normalising(const NormalForm& normal, Budget& budget, Statistics& statistics)
        : normal_(normal), budget_(budget), statistics_(statistics) {
        budget_.report_by([&normal](Progress& progress) { progress.states = normal.size(); });
    }
    Normalising(const Normalising&) = delete;
    Normalising& operator=(const Normalising&) = delete;
    ~Normalising() {
        budget_.report_by({});
        statistics_.spec_nodes = normal_.size();
        if (statistics_.states == 0) statistics_.states = normal_.size();
    }

private:
    const NormalForm& normal_;
    Budget& budget_;
    Statistics& statistics_;
};

void decide_determinism(lts::TransitionSystem& system, Model model, Budget& budget, Verdict& verdict) {
    std::optional<Violation> violation;
    if (model == Model::failures_divergences) violation = divergence_of(system, budget, verdict.statistics);
    if (!violation) {
        NormalForm normal(system, budget);
        const Normalising normalising(normal, budget, verdict.statistics);
        const std::optional<Ambiguity> ambiguity = first_ambiguity(normal);
        if (ambiguity) violation = refusing_run(system, *ambiguity, budget);
    }
    verdict.outcome = Outcome::holds;
    if (!violation) return;
    verdict.counterexample = tell(confirmed(system, *violation, budget, confirm_property_violation));
    verdict.outcome = Outcome::fails;
}

}  // namespace

Verdict deterministic(lts::TransitionSystem& system, Model model, const Limits& limits) {
    return decide({&system}, limits,
                  [&](Budget& budget, Verdict& verdict) { decide_determinism(system, model, budget, verdict); });
}

}  // namespace robochart::refine
