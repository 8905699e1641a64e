// SPDX-License-Identifier: Apache-2.0
#include "checker/symbolic/stage.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>

#include "checker/machine/static_proofs.hpp"
#include "checker/machine/supercombinator_system.hpp"
#include "checker/refine/search/steps.hpp"
#include "checker/symbolic/saturation.hpp"

namespace robochart::symbolic {
namespace {

using machine::Supercombinator;
using refine::Findings;
using refine::Run;
using refine::RunStep;
using refine::Violation;
using refine::ViolationKind;

/// Operations recurse once or twice for each level, and the stack of a thread bounds the recursion.
constexpr std::size_t most_levels = 4'000;

/// Thrown if the stage has used its time.
class OutOfTime : public std::runtime_error {
public:
    OutOfTime() : std::runtime_error("decision diagrams have no more time") {}
};

/// The budget of the check, with a bound on the CPU time of this thread.
class StageBudget final : public diagnostics::Pollable {
public:
    StageBudget(refine::Budget& budget, std::chrono::duration<double> share)
        : budget_(budget), end_(now() + share.count()) {}
    void poll() override {
        constexpr std::uint32_t between_checks = 4096;
        if (++polls_ % between_checks != 0) return;
        budget_.check();
        if (now() > end_) throw OutOfTime();
    }

private:
    static double now() {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
    }

    refine::Budget& budget_;
    double end_;
    std::uint32_t polls_ = 0;
};

/// The exploration of one process.
class Exploration {
public:
    Exploration(lts::TransitionSystem& system, const Supercombinator& combined, const RegionRules& rules,
                Variables variables, const Space& space, StageBudget& own, refine::Budget& budget)
        : system_(system),
          combined_(combined),
          rules_(rules),
          variables_(std::move(variables)),
          own_(own),
          budget_(budget),
          diagrams_(variables_.domains, space, own),
          relations_(combined, rules, variables_, diagrams_) {}

    std::optional<Findings> decide(const refine::SymbolicQuestion& question) {
        Findings findings;
        {
            Saturation saturation(relations_, diagrams_);
            reached_ = diagrams_.keep_always(saturation.reachable(values_of(refine::initial_of(system_))));
        }
        findings.statistics.decided_by = refine::DecidedBy::diagrams;
        findings.statistics.diagram_nodes = diagrams_.count_nodes(reached_);
        findings.statistics.log10_states = static_cast<double>(std::log10(diagrams_.count_tuples(reached_)));
        if (question.deadlock) findings.violation = find_deadlock();
        if (question.divergence && !findings.violation) findings.violation = find_divergence();
        return findings;
    }

private:
    /// The values of a state by level; the first element is unused.
    std::vector<Value> values_of(lts::StateView state) const {
        std::vector<Value> values(variables_.slot_at.size());
        for (Level level = 1; level < values.size(); ++level) {
            const std::uint32_t slot = variables_.slot_at[level];
            values[level] = relations_.value_of(slot, combined_.fields[slot].get(state));
        }
        return values;
    }

    /// States of which some of these steps lead into the set. The caller keeps the set and the result.
    Node before(Node states, const std::vector<Step>& steps) {
        Diagrams::Kept sum(diagrams_, nothing);
        for (const Step& step : steps) {
            const Diagrams::Kept more(diagrams_, relations_.before(states, step));
            sum.set(diagrams_.unite(diagrams_.levels(), sum.get(), more.get()));
        }
        return sum.get();
    }

    std::optional<Violation> find_deadlock() {
        const Diagrams::Kept stuck(diagrams_, relations_.none_possible(relations_.steps()));
        const Node bad = diagrams_.keep_always(diagrams_.intersect(diagrams_.levels(), reached_, stuck.get()));
        if (bad == nothing) return std::nullopt;
        return Violation{ViolationKind::deadlock, shortest_run_to(bad), {}, {}};
    }

    /// A state diverges iff it is in the greatest set of reachable states each of which has a tau into the set. Only
    /// the rules that may lie on a cycle of taus matter for whether the set is empty.
    std::optional<Violation> find_divergence() {
        const std::vector<Step> taus = list_cycle_taus();
        const Level top = diagrams_.levels();
        Diagrams::Kept diverging(diagrams_, reached_);
        for (;;) {
            const Diagrams::Kept earlier(diagrams_, before(diverging.get(), taus));
            const Node fewer = diagrams_.intersect(top, diverging.get(), earlier.get());
            if (fewer == diverging.get()) break;
            diverging.set(fewer);
        }
        const Node bad = diagrams_.keep_always(diverging.get());
        if (bad == nothing) return std::nullopt;
        Violation violation{ViolationKind::divergence, shortest_run_to(bad), {}, {}};
        walk_to_cycle(violation, bad);
        return violation;
    }

    std::vector<Step> list_cycle_taus() {
        const std::optional<machine::WholeRules> whole = machine::whole_rules(combined_, own_);
        if (!whole) throw OutOfSpace();
        const std::vector<bool> on_cycles = machine::rules_on_tau_cycles(combined_, *whole, own_);
        std::vector<Step> taus;
        for (std::size_t rule = 0; rule < on_cycles.size(); ++rule)
            if (on_cycles[rule] && rules_.back()[rule].event == process::tau) taus.push_back(relations_.steps()[rule]);
        std::ranges::sort(taus);
        taus.erase(std::unique(taus.begin(), taus.end()), taus.end());
        return taus;
    }

    /// Backward from the bad states: the ring of number n contains the states that reach a bad one in at most n steps.
    /// Then forward by the transitions of the process, each time into the next ring.
    Run shortest_run_to(Node bad) {
        std::vector<Step> steps = relations_.steps();
        std::ranges::sort(steps);
        steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
        const Level top = diagrams_.levels();
        const std::vector<Value> initial = values_of(refine::initial_of(system_));
        std::vector<Node> rings{bad};
        while (!diagrams_.contains(rings.back(), initial)) {
            const Diagrams::Kept earlier(diagrams_, before(rings.back(), steps));
            const Diagrams::Kept inside(diagrams_, diagrams_.intersect(top, earlier.get(), reached_));
            const Node next = diagrams_.keep_always(diagrams_.unite(top, rings.back(), inside.get()));
            if (next == rings.back()) throw std::logic_error("decision diagrams: a reachable state has no run");
            rings.push_back(next);
        }
        Run run{refine::initial_of(system_), {}};
        for (std::size_t ring = rings.size() - 1; ring-- > 0;)
            run.steps.push_back(step_into(rings[ring], run.last_state()));
        return run;
    }

    /// The first transition of the process from the state into the set.
    RunStep step_into(Node set, const std::vector<lts::Word>& state, bool by_tau = false) {
        for (const RunStep& step : refine::steps_from(system_, state, budget_))
            if ((!by_tau || step.event == process::tau) && diagrams_.contains(set, values_of(step.state))) return step;
        throw std::logic_error("decision diagrams: a state has no transition that its rules give it");
    }

    /// Follows taus inside the set until a state repeats. The run then ends in this state.
    void walk_to_cycle(Violation& violation, Node diverging) {
        std::vector<std::vector<lts::Word>> states{violation.run.last_state()};
        std::vector<RunStep> taus;
        for (;;) {
            own_.poll();
            taus.push_back(step_into(diverging, states.back(), true));
            const auto repeated = std::ranges::find(states, taus.back().state);
            if (repeated == states.end()) {
                states.push_back(taus.back().state);
                continue;
            }
            const auto entrance = taus.begin() + (repeated - states.begin());
            violation.run.steps.insert(violation.run.steps.end(), taus.begin(), entrance);
            violation.loop.initial = *repeated;
            violation.loop.steps.assign(entrance, taus.end());
            violation.shortest = false;
            return;
        }
    }

    lts::TransitionSystem& system_;
    const Supercombinator& combined_;
    const RegionRules& rules_;
    const Variables variables_;
    StageBudget& own_;
    refine::Budget& budget_;
    Diagrams diagrams_;
    Relations relations_;
    Node reached_ = nothing;
};

}  // namespace

std::optional<Findings> DiagramStage::decide(lts::TransitionSystem& system, const refine::SymbolicQuestion& question,
                                             refine::Budget& budget) {
    const auto* const compiled = dynamic_cast<const machine::SupercombinatorSystem*>(&system);
    if (compiled == nullptr || compiled->combined().components.size() > most_levels) return std::nullopt;
    const Supercombinator& combined = compiled->combined();
    const std::unique_ptr<lts::TransitionSystem> copy = system.clone_for_thread();
    StageBudget own(budget, options_.share);
    Space space = options_.space;
    space.bytes = std::min<std::uint64_t>(space.bytes, budget.limits().memory_bytes / 8);
    try {
        const std::optional<RegionRules> rules = machine::rules_of_regions(combined, own);
        if (!rules) return std::nullopt;
        Variables variables =
            options_.order.empty() ? make_variables(combined, *rules) : make_variables(combined, options_.order);
        return Exploration(*copy, combined, *rules, std::move(variables), space, own, budget).decide(question);
    } catch (const OutOfTime&) {
        return std::nullopt;
    } catch (const OutOfSpace&) {
        return std::nullopt;
    }
}

}  // namespace robochart::symbolic
