// SPDX-License-Identifier: Apache-2.0
// Decision diagrams against the search of all states, on random rules: with small tables, with a collection before
// every node, and in random orders. A rule, a guard or an assignment that is left out must make a difference.
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
    std::vector<StageOptions> result(3);
    result[1].order = random_order(slots, numbers);
    result[1].space.most_results = 2;
    result[2].order = random_order(slots, numbers);
    result[2].space.always_collect = true;
    return result;
}

/// The answer of the stage, whose violations are replayed.
std::optional<refine::Findings> decide(SupercombinatorSystem& system, const refine::SymbolicQuestion& question,
                                       const StageOptions& options) {
    const refine::Limits limits;
    refine::Budget budget(limits);
    DiagramStage stage(options);
    std::optional<refine::Findings> findings = stage.decide(system, question, budget);
    if (findings && findings->violation) refine::confirm_property_violation(system, *findings->violation, budget);
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
                ASSERT_TRUE(dead->violation->shortest);
                ASSERT_EQ(dead->violation->run.steps.size(), expected.deadlock.counterexample->steps.size());
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

/// The numbers of reachable states and of deadlocks by these rules.
std::pair<long double, long double> counts_of(const Supercombinator& combined, const RegionRules& rules) {
    const Variables variables = make_variables(combined, rules);
    Diagrams diagrams(variables.domains, {}, diagnostics::unlimited);
    Relations relations(combined, rules, variables, diagrams);
    std::vector<Value> initial(variables.slot_at.size());
    for (Level level = 1; level < initial.size(); ++level) initial[level] = combined.initial[variables.slot_at[level]];
    const Node reached = diagrams.keep_always(Saturation(relations, diagrams).reachable(initial));
    const Node stuck = diagrams.keep_always(relations.none_possible(relations.steps()));
    return {diagrams.count_tuples(reached),
            diagrams.count_tuples(diagrams.intersect(diagrams.levels(), reached, stuck))};
}

/// Leaves out one thing in one rule: the rule, what can prevent it, or an assignment.
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

/// The comparison of counts notices each kind of fault in many processes.
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

/// Without a delay, the stage decides in place of the search. The verdicts and the lengths of runs are those of the
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
