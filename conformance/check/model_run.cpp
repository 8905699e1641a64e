// SPDX-License-Identifier: Apache-2.0
// See model_run.hpp.
#include "conformance/check/model_run.hpp"

#include <algorithm>
#include <chrono>
#include <set>
#include <stdexcept>

#include "base/diagnostics/containers.hpp"
#include "checker/process/operational_semantics.hpp"
#include "checker/process/term_system.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/search/steps.hpp"
#include "checker/refine/verdict/reference.hpp"
#include "counterexample/interpreter.hpp"

namespace robochart::conformance {

namespace {

constexpr std::chrono::seconds longest_explanation{10};

/// Returns the actions of a run as the frame shows them. The frame decides whether reports of writes are visible.
refine::Run run_of_frame(const Frame& frame, const std::vector<refine::Step>& steps, const Alphabet& alphabet) {
    refine::Run run;
    for (const refine::Step& step : steps) {
        const process::Event event = step.event == process::tau ? step.revealed : step.event;
        const bool write = alphabet.cycle_role(event).kind == CycleRole::Kind::write;
        process::Event shown = step.event;
        if (write) shown = frame.writes_hidden ? process::tau : event;
        run.steps.push_back({shown, step.revealed == process::tau ? event : step.revealed, {}});
    }
    return run;
}

/// Follows the first hidden step of M that is no output, again and again. Stops if there is none, or if a state occurs
/// for the second time.
void follow_hidden_steps(NormalFormSystem& system, const Alphabet& alphabet, refine::Run& run, refine::Budget& budget) {
    const auto silent = [&](const refine::RunStep& step) {
        return step.event == process::tau && alphabet.model_role(step.revealed).kind != ModelRole::Kind::output;
    };
    std::set<std::vector<lts::Word>> met{run.last_state()};
    for (;;) {
        const std::vector<refine::RunStep> steps = refine::steps_from(system, run.last_state(), budget);
        const auto next = std::ranges::find_if(steps, silent);
        if (next == steps.end() || !met.insert(next->state).second) return;
        run.steps.push_back(*next);
    }
}

/// Converts a run of NF_c(M) to a counterexample of M: what M does in this run.
class RunOfModel {
public:
    RunOfModel(ModelGraph& graph, const NormalFormSystem& normal_form, const Alphabet& alphabet)
        : graph_(graph), normal_form_(normal_form), alphabet_(alphabet) {}

    refine::Counterexample read_violation(const refine::Violation& violation) {
        refine::Counterexample result;
        const bool diverges = violation.kind == refine::ViolationKind::divergence;
        const bool no_trace = violation.kind == refine::ViolationKind::no_trace;
        result.kind = diverges || no_trace ? violation.kind : refine::ViolationKind::refusal;
        result.initial = graph_.describe(graph_.initial());
        result.terms.push_back(term_of(graph_.initial()));
        ModelState at = follow_run(violation.run, result.steps, result.terms);
        if (diverges) {
            result.loop_terms.push_back(term_of(at));
            at = follow_run(violation.loop, result.loop, result.loop_terms);
        }
        for (const ModelEdge& edge : graph_.edges(at))
            if (edge.event != process::tau) result.offered.push_back(edge.event);
        diagnostics::sort_unique(result.offered);
        return result;
    }

private:
    [[nodiscard]] process::TermId term_of(ModelState state) const {
        return process::TermId{graph_.packed_state(state).front()};
    }

    /// Follows the run. Returns the last state of M before it terminates.
    ModelState follow_run(const refine::Run& run, std::vector<refine::Step>& steps,
                          std::vector<process::TermId>& terms) {
        ModelState at = normal_form_.model_state_of(run.initial).value_or(graph_.initial());
        for (const refine::RunStep& step : run.steps) {
            const auto next = normal_form_.model_state_of(step.state);
            if (!next) break;
            const process::Event event = step.event == process::tau ? step.revealed : step.event;
            const auto role = alphabet_.cycle_role(event).kind;
            if (role == CycleRole::Kind::read || role == CycleRole::Kind::write) continue;
            const std::vector<ModelEdge>& edges = graph_.edges(at);
            const auto edge = std::ranges::find_if(edges, [&](const ModelEdge& candidate) {
                return candidate.target == *next && (candidate.event == event || candidate.revealed == event);
            });
            if (edge == edges.end()) continue;
            steps.push_back({edge->event, edge->revealed, graph_.describe(*next)});
            terms.push_back(term_of(*next));
            at = *next;
        }
        return at;
    }

    ModelGraph& graph_;
    const NormalFormSystem& normal_form_;
    const Alphabet& alphabet_;
};

}  // namespace

refine::Limits limits_of_explanation(refine::Limits limits) {
    limits.max_states = refine::Limits().max_states;
    const auto end = std::chrono::steady_clock::now() + longest_explanation;
    limits.deadline = limits.deadline ? std::min(*limits.deadline, end) : end;
    return limits;
}

std::optional<refine::Violation> find_violation(NormalFormSystem& normal_form, const Frame& frame,
                                                const refine::Counterexample& found, const Alphabet& alphabet,
                                                const refine::Limits& limits) {
    refine::Budget budget(limits);
    normal_form.set_budget(budget);
    std::optional<refine::Violation> result;
    try {
        const refine::Violation violation{found.kind, run_of_frame(frame, found.steps, alphabet),
                                          run_of_frame(frame, found.loop, alphabet), std::nullopt};
        result = refine::found_again(normal_form, normal_form, violation, budget);
        if (result->kind == refine::ViolationKind::no_trace)
            follow_hidden_steps(normal_form, alphabet, result->run, budget);
    } catch (const process::Interrupted&) {
    } catch (const std::logic_error&) {
        // If the normal form does not reproduce the run, no run is displayed. The verdict does not depend on this.
    }
    normal_form.set_budget(diagnostics::unlimited);
    return result;
}

std::optional<refine::Counterexample> run_of_model(cspm::Session& session, const cspm::ExprPtr& process,
                                                   const Alphabet& alphabet, std::uint32_t cycle_length,
                                                   const Frame& frame, const refine::Counterexample& found,
                                                   const refine::Limits& limits) {
    process::OperationalSemantics semantics(session.terms());
    process::TermSystem terms(semantics, session.process(process));
    ModelGraph graph(terms, alphabet);
    NormalFormSystem normal_form(graph, alphabet, cycle_length, frame);
    const auto again = find_violation(normal_form, frame, found, alphabet, limits);
    if (!again) return std::nullopt;
    return RunOfModel(graph, normal_form, alphabet).read_violation(*again);
}

runs::Run interpret_run(const refine::Counterexample& run, ir::PropertyKind kind, cspm::Session& session,
                        const ModelWords& words) {
    csp_emit::Obligation obligation;
    obligation.time = csp_emit::Time::timed;
    obligation.kind = kind;
    const runs::Context context{words.provenance, words.system, words.instantiation, words.sources, session};
    return runs::interpret_counterexample(context, obligation, run);
}

}  // namespace robochart::conformance
