// SPDX-License-Identifier: Apache-2.0
#include "checker/symbolic/stage.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <memory>

#include "base/diagnostics/containers.hpp"
#include "checker/machine/static_proofs.hpp"
#include "checker/machine/supercombinator_system.hpp"
#include "checker/refine/search/steps.hpp"
#include "checker/refine/verdict/normal_table.hpp"
#include "checker/symbolic/product.hpp"
#include "checker/symbolic/saturation.hpp"

namespace robochart::symbolic {
namespace {

using machine::Supercombinator;
using refine::Findings;
using refine::Monitor;
using refine::NormalTable;
using refine::Run;
using refine::RunStep;
using refine::Violation;
using refine::ViolationKind;

/// The maximal number of levels. The operations on diagrams recurse once or twice for each level, so the stack of a
/// thread limits this number.
constexpr std::size_t most_levels = 4'000;

/// Thrown if the stage has used up its time.
class OutOfTime : public std::runtime_error {
public:
    OutOfTime() : std::runtime_error("decision diagrams have no more time") {}
};

/// The budget of the check, with an additional limit on the CPU time of this thread.
class StageBudget final : public diagnostics::Pollable {
public:
    StageBudget(refine::Budget& budget, std::chrono::duration<double> share)
        : budget_(budget), end_(now() + share.count()) {}
    void poll() override {
        constexpr std::uint32_t between_checks = 4096;
        if (++polls_ % between_checks == 0) check();
    }
    /// Checks the limits. The stage gives up before the memory limit of the check is reached, because the search may
    /// need less memory.
    void check() {
        const std::uint64_t most = budget_.limits().memory_bytes;
        if (diagnostics::resident_bytes() > most - most / 16) throw OutOfSpace();
        budget_.check();
        if (now() > end_) throw OutOfTime();
    }

    /// Limits the work during its lifetime to this part of the remaining time.
    class Part {
    public:
        Part(StageBudget& budget, double part) : budget_(budget), end_(budget.end_) {
            budget.end_ -= (1 - part) * std::max(0.0, end_ - now());
        }
        Part(const Part&) = delete;
        Part& operator=(const Part&) = delete;
        ~Part() { budget_.end_ = end_; }

    private:
        StageBudget& budget_;
        double end_;
    };

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

/// Explores one process, or the pairs of its states with the nodes of a specification.
class Exploration {
public:
    /// `table`: the normal form of the specification, or null for a question without a specification.
    Exploration(lts::TransitionSystem& system, const Supercombinator& combined, const RegionRules& rules,
                Variables variables, const std::shared_ptr<const NormalTable>& table, const StageOptions& options,
                const Space& space, StageBudget& own, refine::Budget& budget)
        : system_(system),
          combined_(combined),
          rules_(rules),
          variables_(std::move(variables)),
          table_(table),
          part_for_rings_(options.part_for_rings),
          own_(own),
          budget_(budget),
          diagrams_(domains_of(variables_, table.get()), space, own),
          relations_(combined, rules, variables_, diagrams_, own) {}

    std::optional<Findings> decide(const refine::SymbolicQuestion& question) {
        if (table_) {
            product_.emplace(*table_, rules_.back(), relations_, diagrams_, own_);
            monitor_.emplace(table_, question.model);
        }
        steps_ = product_ ? product_->steps() : relations_.steps();
        diagnostics::sort_unique(steps_);
        {
            Saturation saturation(relations_, steps_, diagrams_, own_);
            reached_ = diagrams_.keep_always(saturation.reachable(values_of(initial())));
        }
        Findings findings;
        findings.statistics.decided_by = refine::DecidedBy::diagrams;
        findings.statistics.diagram_nodes = diagrams_.count_nodes(reached_);
        findings.statistics.log10_states = static_cast<double>(std::log10(diagrams_.count_tuples(reached_)));
        if (product_) {
            findings.statistics.spec_nodes = table_->nodes.size();
            findings.violation = find_fault(question.model);
        }
        if (question.deadlock && !findings.violation) findings.violation = find_deadlock();
        if (question.divergence && !findings.violation) findings.violation = find_divergence();
        return findings;
    }

private:
    /// A state, and the node of the specification after the same events. The node is 0 if there is no specification.
    struct Place {
        Value node = 0;
        std::vector<lts::Word> state;
    };
    struct Path {
        Run run;
        Value node = 0;         ///< the specification's node at the end of the run
        bool shortest = false;  ///< whether the run is known to be a shortest one
        [[nodiscard]] Place end() const { return {node, run.last_state()}; }
    };

    static std::vector<Value> domains_of(const Variables& variables, const NormalTable* table) {
        std::vector<Value> domains = variables.domains;
        if (table != nullptr) domains.push_back(static_cast<Value>(table->nodes.size()));
        return domains;
    }

    [[nodiscard]] Place initial() const { return {0, refine::initial_of(system_)}; }

    /// Returns the values of a place by level; the first element is unused.
    [[nodiscard]] std::vector<Value> values_of(const Place& place) const {
        std::vector<Value> values(variables_.slot_at.size());
        for (Level level = 1; level < values.size(); ++level) {
            const std::uint32_t slot = variables_.slot_at[level];
            values[level] = relations_.value_of(slot, combined_.fields[slot].get(place.state));
        }
        if (table_) values.push_back(place.node);
        return values;
    }

    /// Returns the states from which at least one of these steps leads into the set. The caller must keep the set and
    /// the result.
    Node before(Node states, const std::vector<Step>& steps) {
        Diagrams::Kept sum(diagrams_, nothing);
        for (const Step& step : steps) {
            const Diagrams::Kept more(diagrams_, relations_.before(states, step));
            sum.set(diagrams_.unite(diagrams_.levels(), sum.get(), more.get()));
        }
        return sum.get();
    }

    /// Returns the fault with the shortest run. If a refusal and a forbidden event have runs of equal length, returns
    /// the refusal, as the explicit search does.
    std::optional<Violation> find_fault(refine::Model model) {
        const bool with_refusals = model != refine::Model::traces;
        const Node refusing = diagrams_.keep_always(with_refusals ? product_->refusing(reached_) : nothing);
        const Node forbidden = diagrams_.keep_always(product_->forbidden(reached_));
        std::optional<Path> to_forbidden;
        if (forbidden != nothing) to_forbidden = path_to(forbidden);
        if (refusing != nothing)
            if (auto path = path_to(refusing, to_forbidden ? to_forbidden->run.steps.size() : no_bound))
                return Violation{ViolationKind::refusal, std::move(path->run), {}, {}, path->shortest};
        if (!to_forbidden) return std::nullopt;
        to_forbidden->run.steps.push_back(forbidden_step(to_forbidden->end()));
        return Violation{ViolationKind::trace, std::move(to_forbidden->run), {}, {}, to_forbidden->shortest};
    }

    RunStep forbidden_step(const Place& place) {
        for (const RunStep& step : refine::steps_from(system_, place.state, budget_))
            if (advance(place.node, step.event).effect == Monitor::Effect::violation) return step;
        throw std::logic_error("decision diagrams: a state has no forbidden event");
    }

    std::optional<Violation> find_deadlock() {
        const Level top = diagrams_.levels();
        const Diagrams::Kept lowest(diagrams_, relations_.none_possible(relations_.steps()));
        const Diagrams::Kept stuck(diagrams_, diagrams_.lift(lowest.get(), top));
        const Node bad = diagrams_.keep_always(diagrams_.intersect(top, reached_, stuck.get()));
        if (bad == nothing) return std::nullopt;
        const Path path = path_to(bad).value();
        return Violation{ViolationKind::deadlock, path.run, {}, {}, path.shortest};
    }

    /// Finds a divergence. A state diverges iff it belongs to the greatest set of reachable states in which each state
    /// has a tau to a state of the set. To decide whether this set is empty, it suffices to follow the taus that may
    /// lie on a cycle.
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
        const Path path = path_to(bad).value();
        Violation violation{ViolationKind::divergence, path.run, {}, {}};
        walk_to_cycle(violation, path.end(), bad);
        return violation;
    }

    std::vector<Step> list_cycle_taus() {
        const std::optional<machine::WholeRules> whole = machine::whole_rules(combined_, own_);
        if (!whole) throw OutOfSpace();
        const std::vector<bool> on_cycles = machine::rules_on_tau_cycles(combined_, *whole, own_);
        std::vector<Step> taus;
        for (std::size_t rule = 0; rule < on_cycles.size(); ++rule)
            if (on_cycles[rule] && rules_.back()[rule].event == process::tau) taus.push_back(relations_.steps()[rule]);
        diagnostics::sort_unique(taus);
        return taus;
    }

    /// Returns a shortest path if there is enough time to find it, and some path otherwise. Returns no value if a
    /// shortest path has more than `most` steps.
    std::optional<Path> path_to(Node bad, std::size_t most = no_bound) {
        try {
            const StageBudget::Part part(own_, part_for_rings_);
            own_.check();
            return shortest_path_to(bad, most);
        } catch (const OutOfTime&) {
            return some_path_to(bad);
        }
    }

    /// Searches backward from the bad states. Ring n contains the states from which at most n steps lead to a bad
    /// state.
    std::optional<Path> shortest_path_to(Node bad, std::size_t most) {
        const Level top = diagrams_.levels();
        const std::vector<Value> first = values_of(initial());
        std::vector<Node> rings{bad};
        while (!diagrams_.contains(rings.back(), first)) {
            if (rings.size() > most) return std::nullopt;
            const Diagrams::Kept earlier(diagrams_, before(rings.back(), steps_));
            const Diagrams::Kept inside(diagrams_, diagrams_.intersect(top, earlier.get(), reached_));
            const Node next = diagrams_.keep_always(diagrams_.unite(top, rings.back(), inside.get()));
            if (next == rings.back()) throw std::logic_error("decision diagrams: a reachable state has no run");
            rings.push_back(next);
        }
        Path path = walk_down(rings);
        path.shortest = true;
        return path;
    }

    /// Searches backward from one of the bad states. It applies the steps one after the other, each to the result of
    /// the step before it. So each set contains the previous set and the states from which one step leads into it. This
    /// needs far fewer rounds than shortest_path_to, which applies all steps to the same set.
    Path some_path_to(Node bad) {
        const Level top = diagrams_.levels();
        const std::vector<Value> first = values_of(initial());
        std::vector<Node> sets{diagrams_.keep_always(diagrams_.least_tuple(bad))};
        // The order of the steps is reversed in every round, because the steps of the run may occur in this order or in
        // the opposite order.
        for (bool forward = true; !diagrams_.contains(sets.back(), first); forward = !forward) {
            const Node before_all = sets.back();
            for (std::size_t i = 0; i < steps_.size(); ++i) {
                const Step& step = steps_[forward ? i : steps_.size() - 1 - i];
                const Diagrams::Kept earlier(diagrams_, relations_.before(sets.back(), step));
                const Diagrams::Kept inside(diagrams_, diagrams_.intersect(top, earlier.get(), reached_));
                const Node next = diagrams_.unite(top, sets.back(), inside.get());
                if (next != sets.back()) sets.push_back(diagrams_.keep_always(next));
            }
            if (sets.back() == before_all) throw std::logic_error("decision diagrams: a reachable state has no run");
        }
        return walk_down(sets);
    }

    /// Follows transitions of the process forward from the initial state. Each set contains all previous sets. A state
    /// that is in a set but not in the previous set has a transition into the previous set.
    Path walk_down(const std::vector<Node>& sets) {
        Path path{{initial().state, {}}, 0};
        for (;;) {
            const std::vector<Value> values = values_of(path.end());
            const auto found =
                std::ranges::partition_point(sets, [&](Node set) { return !diagrams_.contains(set, values); });
            if (found == sets.begin()) return path;
            RunStep step = step_into(*std::prev(found), path.end());
            path.node = advance(path.node, step.event).node;
            path.run.steps.push_back(std::move(step));
        }
    }

    /// Returns the node after the event. If the node does not allow the event, the result says so.
    Monitor::Advance advance(Value node, process::Event event) {
        if (!monitor_ || event == process::tau) return {Monitor::Effect::follow, node};
        return monitor_->advance(node, event);
    }

    /// Returns the first transition of the process that leads from the place into the set.
    RunStep step_into(Node set, const Place& place, bool by_tau = false) {
        for (const RunStep& step : refine::steps_from(system_, place.state, budget_)) {
            if (by_tau && step.event != process::tau) continue;
            const auto [effect, node] = advance(place.node, step.event);
            if (effect != Monitor::Effect::follow) continue;
            if (diagrams_.contains(set, values_of({node, step.state}))) return step;
        }
        throw std::logic_error("decision diagrams: a state has no transition that its rules give it");
    }

    /// Follows taus inside the set until a state is reached again. The run then ends in this state.
    void walk_to_cycle(Violation& violation, const Place& start, Node diverging) {
        std::vector<std::vector<lts::Word>> states{start.state};
        std::vector<RunStep> taus;
        for (;;) {
            own_.poll();
            taus.push_back(step_into(diverging, {start.node, states.back()}, true));
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

    static constexpr std::size_t no_bound = std::numeric_limits<std::size_t>::max();

    lts::TransitionSystem& system_;
    const Supercombinator& combined_;
    const RegionRules& rules_;
    const Variables variables_;
    const std::shared_ptr<const NormalTable> table_;
    const double part_for_rings_;
    StageBudget& own_;
    refine::Budget& budget_;
    Diagrams diagrams_;
    Relations relations_;
    std::optional<Product> product_;
    std::optional<refine::TableMonitor> monitor_;
    std::vector<Step> steps_;  // ascending
    Node reached_ = nothing;
};

/// Returns the whole normal form of the specification. Returns no value if it has too many nodes, if there is not
/// enough time, or if a part of it that a search may never reach cannot be evaluated.
std::optional<NormalTable> specification_table(const refine::SymbolicQuestion& question,
                                               std::chrono::duration<double> share, refine::Budget& budget) {
    constexpr std::size_t most_nodes = 100'000;
    refine::Limits limits = budget.limits();
    limits.max_states = 1'000'000;
    limits.progress = {};
    refine::Budget own(limits);
    own.call_after(share, refine::CallMoment::any_poll, [] { throw OutOfTime(); });
    try {
        refine::NormalForm normal(*question.specification, own);
        return refine::table_of(normal, question.model, most_nodes);
    } catch (const process::Interrupted&) {
        budget.check();  // throws, unless only the smaller limit of states was reached
        return std::nullopt;
    } catch (const std::logic_error&) {
        throw;
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

}  // namespace

std::optional<Findings> DiagramStage::decide(lts::TransitionSystem& system, const refine::SymbolicQuestion& question,
                                             refine::Budget& budget) {
    const auto* const compiled = dynamic_cast<const machine::SupercombinatorSystem*>(&system);
    if (compiled == nullptr || compiled->combined().components.size() >= most_levels) return std::nullopt;
    const GivenUp attempt{compiled->share_combined(), question};
    if (given_up_ == attempt) return std::nullopt;
    std::optional<Findings> findings = explore(system, compiled->combined(), question, budget);
    if (!findings) given_up_ = attempt;
    return findings;
}

std::optional<Findings> DiagramStage::explore(const lts::TransitionSystem& system, const Supercombinator& combined,
                                              const refine::SymbolicQuestion& question, refine::Budget& budget) const {
    const std::unique_ptr<lts::TransitionSystem> copy = system.clone_for_thread();
    StageBudget own(budget, options_.share);
    Space space = options_.space;
    space.bytes = std::min<std::uint64_t>(space.bytes, budget.limits().memory_bytes / 8);
    try {
        own.check();
        std::shared_ptr<const NormalTable> table;
        if (question.specification != nullptr) {
            std::optional<NormalTable> made = specification_table(question, options_.share, budget);
            if (!made || made->nodes.front().diverges) return std::nullopt;
            table = std::make_shared<const NormalTable>(std::move(*made));
        }
        const std::optional<RegionRules> rules = machine::rules_of_regions(combined, own);
        if (!rules) return std::nullopt;
        Variables variables =
            options_.order.empty() ? make_variables(combined, *rules, own) : make_variables(combined, options_.order);
        return Exploration(*copy, combined, *rules, std::move(variables), table, options_, space, own, budget)
            .decide(question);
    } catch (const OutOfTime&) {
        return std::nullopt;
    } catch (const OutOfSpace&) {
        return std::nullopt;
    }
}

}  // namespace robochart::symbolic
