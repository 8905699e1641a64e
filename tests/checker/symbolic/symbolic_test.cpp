// SPDX-License-Identifier: Apache-2.0
// Compares decision diagrams with the search of all states, on random rules: with small tables, with a collection
// before every node, and in random orders. If a rule, a guard or an assignment is left out, the answers must change.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>
#include <random>

#include "checker/machine/supercombinator_system.hpp"
#include "checker/refine/verdict/check.hpp"
#include "checker/refine/verdict/replay.hpp"
#include "checker/symbolic/saturation.hpp"
#include "checker/symbolic/stage.hpp"
#include "tests/checker/lts/bisimilar.hpp"
#include "tests/checker/machine/random_rules.hpp"
#include "tests/checker/processes/random_cases.hpp"
#include "tests/checker/processes/translate.hpp"
#include "tests/rounds.hpp"

namespace robochart::symbolic {
namespace {

using machine::RandomRules;
using machine::Supercombinator;
using machine::SupercombinatorSystem;
using process::Scripted;
using refine::Outcome;

/// The answers of the search of all states.
struct Expected {
    refine::Verdict deadlock, divergence;
    std::size_t states = 0;
};

Expected expected_of(SupercombinatorSystem& system) {
    const refine::Limits limits;
    return {refine::deadlock_free(system, refine::Model::failures, limits), refine::divergence_free(system, limits),
            lts::graph_of(system, 1'000'000).size()};
}

std::vector<std::uint32_t> random_order(std::size_t size, std::mt19937_64& numbers) {
    std::vector<std::uint32_t> order(size);
    std::iota(order.begin(), order.end(), 0U);
    for (std::size_t i = size; i > 1; --i) std::swap(order[i - 1], order[numbers() % i]);
    return order;
}

std::vector<StageOptions> settings(std::size_t slots, std::mt19937_64& numbers) {
    std::vector<StageOptions> result(4);
    result[1].order = random_order(slots, numbers);
    result[1].space.most_results = 2;
    result[2].order = random_order(slots, numbers);
    result[2].space.always_collect = true;
    result[3].part_for_rings = 0;
    return result;
}

/// Returns the answer of the stage. Violations are replayed.
std::optional<refine::Findings> decide(SupercombinatorSystem& system, const refine::SymbolicQuestion& question,
                                       const StageOptions& options) {
    const refine::Limits limits;
    refine::Budget budget(limits);
    DiagramStage stage(options);
    std::optional<refine::Findings> findings = stage.decide(system, question, budget);
    if (!findings || !findings->violation) return findings;
    if (question.specification == nullptr)
        refine::confirm_property_violation(system, *findings->violation, budget);
    else
        refine::confirm_refinement_violation(*question.specification, system, question.model, *findings->violation,
                                             budget);
    return findings;
}

class Symbolic : public testing::Test {
protected:
    Symbolic() {
        for (process::Event i = 0; i < RandomRules::visible; ++i) s.event("e" + std::to_string(i));
    }
    Scripted s;
};

TEST_F(Symbolic, AgreesWithTheSearchOnRandomRules) {
    const int rounds = refine::wanted_checks(static_cast<int>(tests::rounds(600)));
    RandomRules rules(3701);
    std::mt19937_64 numbers(3702);
    int deadlocks = 0, divergences = 0, large = 0;
    for (int round = 0; round < rounds; ++round) {
        SupercombinatorSystem system(rules.next(s.stop()), s.store);
        const Expected expected = expected_of(system);
        deadlocks += expected.deadlock.outcome == Outcome::fails ? 1 : 0;
        divergences += expected.divergence.outcome == Outcome::fails ? 1 : 0;
        large += expected.states > 5 ? 1 : 0;
        for (const StageOptions& options : settings(system.combined().components.size(), numbers)) {
            const auto dead = decide(system, {true, false}, options);
            ASSERT_TRUE(dead) << "round " << round;
            ASSERT_EQ(std::llround(std::pow(10.0, dead->statistics.log10_states)), expected.states)
                << "round " << round;
            ASSERT_EQ(dead->violation.has_value(), expected.deadlock.outcome == Outcome::fails) << "round " << round;
            if (dead->violation) {
                const std::size_t length = expected.deadlock.counterexample->steps.size();
                ASSERT_EQ(dead->violation->shortest, options.part_for_rings > 0);
                if (dead->violation->shortest) {
                    ASSERT_EQ(dead->violation->run.steps.size(), length);
                }
                ASSERT_GE(dead->violation->run.steps.size(), length);
            }
            const auto divergent = decide(system, {false, true}, options);
            ASSERT_TRUE(divergent) << "round " << round;
            ASSERT_EQ(divergent->violation.has_value(), expected.divergence.outcome == Outcome::fails)
                << "round " << round;
        }
    }
    std::cout << deadlocks << " of " << rounds << " with a deadlock, " << divergences << " divergent, " << large
              << " with more than 5 states\n";
    EXPECT_GT(deadlocks * 10, rounds);
    EXPECT_LT(deadlocks * 10, 9 * rounds);
    EXPECT_GT(divergences * 20, rounds);
    EXPECT_GT(large * 10, rounds);
}

/// Returns the same process with termination as its first visible event.
std::shared_ptr<const Supercombinator> with_tick(const Supercombinator& combined) {
    Supercombinator result = combined;
    machine::Region& whole = result.regions.back();
    const auto first =
        std::ranges::find_if(whole.alphabet, [](process::Event e) { return e >= process::first_visible; });
    if (first == whole.alphabet.end()) return std::make_shared<const Supercombinator>(std::move(result));
    for (machine::Rule& rule : whole.rules)
        if (rule.event == *first) rule.event = rule.revealed = process::tick;
    *first = process::tick;
    return std::make_shared<const Supercombinator>(std::move(result));
}

/// Returns a specification that differs little from the process, or not at all. Some transitions of some states are
/// left out or added, or have another event or target.
lts::Graph similar_graph(const lts::Graph& graph, std::mt19937_64& numbers) {
    const std::uint64_t changes = numbers() % 3;
    const auto some_event = [&] { return static_cast<process::Event>(numbers() % (process::first_visible + 4)); };
    const auto some_state = [&] { return static_cast<lts::StateIndex>(numbers() % graph.size()); };
    lts::Graph result;
    std::vector<std::vector<lts::Edge>> edges;
    for (lts::StateIndex state = 0; state < graph.size(); ++state)
        edges.emplace_back(graph.edges(state).begin(), graph.edges(state).end());
    for (std::uint64_t change = 0; change < changes; ++change) {
        std::vector<lts::Edge>& row = edges[some_state()];
        const std::uint64_t kind = row.empty() ? 0 : numbers() % 4;
        if (kind == 0) row.push_back({some_event(), some_state()});
        if (kind == 1) row.erase(row.begin() + static_cast<std::ptrdiff_t>(numbers() % row.size()));
        if (kind == 2) row[numbers() % row.size()].event = some_event();
        if (kind == 3) row[numbers() % row.size()].target = some_state();
    }
    for (const std::vector<lts::Edge>& row : edges) {
        for (const lts::Edge& edge : row) result.add_edge(edge);
        result.finish_state();
    }
    return result;
}

/// Counts the answers of the comparisons with the search.
struct Answers {
    int holds = 0, forbidden = 0, refusals = 0, divergences = 0, with_tick = 0;
};

/// Compares the answer, the kind and the length of the run, and the number of pairs with those of the search.
void compare_refinement(SupercombinatorSystem& system, lts::TransitionSystem& specification, refine::Model model,
                        const StageOptions& options, Answers& answers) {
    const refine::Verdict expected = refine::refines(specification, system, model, {});
    const bool divergence = model == refine::Model::failures_divergences;
    const auto found = decide(system, {false, divergence, &specification, model}, options);
    if (!found) {  // the specification diverges immediately
        ASSERT_TRUE(divergence);
        ASSERT_EQ(expected.outcome, Outcome::holds);
        ASSERT_LE(expected.statistics.states, 1U);
        return;
    }
    ASSERT_EQ(found->violation.has_value(), expected.outcome == Outcome::fails);
    if (!found->violation) {
        ++answers.holds;
        constexpr std::uint64_t few_nodes = 256;  // with more nodes, the search may leave out pairs (antichains)
        if (found->statistics.spec_nodes <= few_nodes) {
            ASSERT_EQ(std::llround(std::pow(10.0, found->statistics.log10_states)), expected.statistics.states);
        }
        return;
    }
    const bool divergent = found->violation->kind == refine::ViolationKind::divergence;
    ASSERT_EQ(divergent, expected.counterexample->kind == refine::ViolationKind::divergence);
    ASSERT_EQ(found->violation->shortest, options.part_for_rings > 0 && !divergent);
    ASSERT_GE(found->violation->run.steps.size(), expected.counterexample->steps.size());
    if (options.part_for_rings > 0) {
        ASSERT_EQ(found->violation->kind, expected.counterexample->kind);
    }
    answers.forbidden += found->violation->kind == refine::ViolationKind::trace ? 1 : 0;
    answers.refusals += found->violation->kind == refine::ViolationKind::refusal ? 1 : 0;
    answers.divergences += found->violation->kind == refine::ViolationKind::divergence ? 1 : 0;
    if (found->violation->shortest) {
        ASSERT_EQ(found->violation->run.steps.size(), expected.counterexample->steps.size());
    }
}

TEST_F(Symbolic, RefinementAgreesWithTheSearchOnRandomRules) {
    using refine::Model;
    const int rounds = refine::wanted_checks(static_cast<int>(tests::rounds(600)));
    RandomRules rules(3706);
    std::mt19937_64 numbers(3707);
    Answers answers;
    for (int round = 0; round < rounds; ++round) {
        std::shared_ptr<const Supercombinator> combined = rules.next(s.stop());
        if (round % 3 == 0) combined = with_tick(*combined);
        SupercombinatorSystem system(combined, s.store);
        const lts::Graph graph = lts::graph_of(system, 1'000'000);
        if (graph.size() > 3'000) continue;
        const lts::Graph similar = similar_graph(graph, numbers);
        lts::GraphSystem specification(similar, s.store.events());
        std::vector<StageOptions> options = settings(combined->components.size(), numbers);
        for (const Model model : {Model::traces, Model::failures, Model::failures_divergences}) {
            SCOPED_TRACE("round " + std::to_string(round) + ", model " + std::to_string(static_cast<int>(model)));
            for (const StageOptions& setting : options) {
                compare_refinement(system, specification, model, setting, answers);
                if (HasFatalFailure()) return;
            }
        }
    }
    std::cout << answers.holds << " hold, " << answers.forbidden << " forbidden events, " << answers.refusals
              << " refusals, " << answers.divergences << " divergences\n";
    EXPECT_GT(answers.holds, rounds);
    EXPECT_GT(answers.forbidden, rounds / 4);
    EXPECT_GT(answers.refusals, rounds / 4);
    EXPECT_GT(answers.divergences, rounds / 50);
}

/// Returns the numbers of reachable states and of deadlocks according to these rules.
std::pair<long double, long double> counts_of(const Supercombinator& combined, const RegionRules& rules) {
    const Variables variables = make_variables(combined, rules, diagnostics::unlimited);
    Diagrams diagrams(variables.domains, {}, diagnostics::unlimited);
    Relations relations(combined, rules, variables, diagrams, diagnostics::unlimited);
    std::vector<Value> initial(variables.slot_at.size());
    for (Level level = 1; level < initial.size(); ++level) initial[level] = combined.initial[variables.slot_at[level]];
    Saturation saturation(relations, relations.steps(), diagrams, diagnostics::unlimited);
    const Node reached = diagrams.keep_always(saturation.reachable(initial));
    const Diagrams::Kept lowest(diagrams, relations.none_possible(relations.steps()));
    const Node stuck = diagrams.keep_always(diagrams.lift(lowest.get(), diagrams.levels()));
    return {diagrams.count_tuples(reached),
            diagrams.count_tuples(diagrams.intersect(diagrams.levels(), reached, stuck))};
}

/// What is left out in one rule: the rule itself, its guards, or an assignment.
enum class Fault { rule, guard, assignment };

bool plant(Fault fault, std::vector<machine::WholeRule>& rules, std::size_t number) {
    machine::WholeRule& rule = rules[number];
    switch (fault) {
        case Fault::rule:
            rules.erase(rules.begin() + static_cast<std::ptrdiff_t>(number));
            return true;
        case Fault::guard:
            if (rule.prevented.empty()) return false;
            rule.prevented.clear();
            return true;
        case Fault::assignment: {
            const auto part =
                std::ranges::find_if(rule.parts, [](const machine::Part& p) { return p.event && p.assigned; });
            if (part == rule.parts.end()) return false;
            part->assigned.reset();
            return true;
        }
    }
    return false;
}

/// For each kind of fault, the counts differ in many processes.
TEST_F(Symbolic, PlantedFaultsAreNoticed) {
    for (const Fault fault : {Fault::rule, Fault::guard, Fault::assignment}) {
        RandomRules random(3703);
        int planted = 0, noticed = 0;
        for (int round = 0; round < 600; ++round) {
            const std::shared_ptr<const Supercombinator> combined = random.next(s.stop());
            RegionRules rules = machine::rules_of_regions(*combined, diagnostics::unlimited).value();
            const auto right = counts_of(*combined, rules);
            for (std::size_t number = 0; number < rules.back().size(); ++number) {
                RegionRules faulty = rules;
                if (!plant(fault, faulty.back(), number)) continue;
                ++planted;
                noticed += counts_of(*combined, faulty) != right ? 1 : 0;
            }
        }
        EXPECT_GT(planted, 50) << static_cast<int>(fault);
        EXPECT_GT(noticed * 20, planted) << static_cast<int>(fault);
    }
}

TEST_F(Symbolic, GivesUpWithoutMemoryOrTime) {
    RandomRules rules(3704);
    SupercombinatorSystem system(rules.next(s.stop()), s.store);
    StageOptions small;
    small.space.bytes = 1;
    small.space.always_collect = true;
    EXPECT_FALSE(decide(system, {true, false}, small));
}

/// Without a delay, the stage decides before the search. The verdicts and the lengths of runs must be those of the
/// search.
TEST_F(Symbolic, DecidesInPlaceOfTheSearch) {
    RandomRules rules(3705);
    StageOptions at_once;
    at_once.delay = std::chrono::duration<double>(0);
    DiagramStage stage(at_once);
    refine::Limits limits;
    limits.reduction = true;
    limits.symbolic = &stage;
    int decided = 0, failed = 0;
    for (int round = 0; round < 100; ++round) {
        SupercombinatorSystem system(rules.next(s.stop()), s.store);
        const Expected expected = expected_of(system);
        const refine::Verdict dead = refine::deadlock_free(system, refine::Model::failures, limits);
        const refine::Verdict divergent = refine::divergence_free(system, limits);
        ASSERT_EQ(dead.outcome, expected.deadlock.outcome) << "round " << round;
        ASSERT_EQ(divergent.outcome, expected.divergence.outcome) << "round " << round;
        if (dead.statistics.decided_by == refine::DecidedBy::diagrams) ++decided;
        if (!dead.counterexample) continue;
        ++failed;
        ASSERT_EQ(dead.counterexample->steps.size(), expected.deadlock.counterexample->steps.size());
    }
    EXPECT_GT(decided, 80);
    EXPECT_GT(failed, 10);
}

}  // namespace
}  // namespace robochart::symbolic
