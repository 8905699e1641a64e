// SPDX-License-Identifier: Apache-2.0
// Tests proofs of confluence. They do not depend on earlier queries, and are correct for every plan. A plan says which
// proofs a search skips.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "checker/lts/graph.hpp"
#include "checker/machine/reduced_system.hpp"
#include "tests/checker/lts/bisimilar.hpp"
#include "tests/checker/machine/random_rules.hpp"
#include "tests/checker/process/scripted.hpp"
#include "tests/checker/processes/random_cases.hpp"

namespace robochart::machine {
namespace {

using lts::Equivalence;
using process::Scripted;

/// Random compiled processes, with rules that refer to the whole process.
class Proofs : public testing::Test {
protected:
    Proofs() {
        for (Event i = 0; i < RandomRules::visible; ++i) s.event("e" + std::to_string(i));
    }
    void next() {
        combined = random.next(s.stop());
        rules = std::make_shared<const WholeRules>(*whole_rules(*combined, diagnostics::unlimited));
        whole = std::make_unique<SupercombinatorSystem>(combined, s.store);
    }
    [[nodiscard]] std::vector<std::vector<Local>> states() const {
        const lts::Exploration explored = lts::explore(*whole, [](std::size_t) {});
        std::vector<std::vector<Local>> result;
        for (lts::StateIndex i = 0; i < explored.states.size(); ++i) {
            std::vector<Local>& state = result.emplace_back();
            for (const Field& field : combined->fields) state.push_back(field.get(explored.states[i]));
        }
        return result;
    }
    /// Returns a random plan. For some rules it examines no components, for others it examines additional components.
    ProofPlan some_plan() {
        ProofPlan plan;
        for (std::uint32_t rule = 0; rule < rules->rules.size(); ++rule) {
            Slots slots;
            for (const Part& part : rules->rules[rule].parts) slots.push_back(part.slot);
            const auto chance = static_cast<std::uint32_t>(numbers() % 3);
            if (chance == 0) plan[{slots, slots}] = {};
            Slots more = slots;
            for (std::uint32_t slot = 0; slot < combined->components.size(); ++slot)
                if (!std::ranges::binary_search(slots, slot) && numbers() % 2 == 0) more.push_back(slot);
            std::ranges::sort(more);
            if (chance == 1 && more != slots) plan[{slots, slots}] = more;
        }
        return plan;
    }

    Scripted s;
    RandomRules random{2024};
    std::mt19937_64 numbers{2024};
    std::shared_ptr<const Supercombinator> combined;
    std::shared_ptr<const WholeRules> rules;
    std::unique_ptr<SupercombinatorSystem> whole;
};

TEST_F(Proofs, DoNotDependOnWhatWasAskedBefore) {
    int followed = 0;
    const int rounds = refine::wanted_checks(1'000) / 5;
    for (int round = 0; round < rounds; ++round) {
        next();
        const std::vector<std::vector<Local>> all = states();
        Confluence forwards(combined, rules, lts::Followed::taus, {}),
            backwards(combined, rules, lts::Followed::taus, {});
        std::vector<std::vector<Local>> ahead = all, back = all;
        for (auto& state : ahead) forwards.follow_step(state);
        for (auto state = back.rbegin(); state != back.rend(); ++state) backwards.follow_step(*state);
        ASSERT_EQ(ahead, back) << "round " << round;
        for (std::size_t i = 0; i < all.size(); ++i) {
            std::vector<Local> alone = all[i];
            if (Confluence(combined, rules, lts::Followed::taus, {}).follow_step(alone)) ++followed;
            ASSERT_EQ(ahead[i], alone) << "round " << round << ", state " << i;
        }
    }
    EXPECT_GT(followed, rounds / 10);
}

TEST_F(Proofs, AreRightWhateverThePlan) {
    int smaller = 0;
    const int rounds = refine::wanted_checks(1'000) / 5;
    for (int round = 0; round < rounds; ++round) {
        next();
        ReducedSystem reduced(whole->clone_for_thread(), combined, rules, lts::Followed::taus, some_plan());
        const lts::Graph all = lts::graph_of(*whole, 100'000);
        const lts::Graph reduced_graph = lts::graph_of(reduced, 100'000);
        ASSERT_TRUE(lts::are_bisimilar(all, reduced_graph, Equivalence::branching_with_divergence))
            << "round " << round;
        if (reduced_graph.size() < all.size()) ++smaller;
    }
    EXPECT_GT(smaller * 20, rounds);
}

TEST_F(Proofs, AreNotTriedWhereThePlanHasNothingInPlaceOfThem) {
    for (int round = 0; round < 20; ++round) {
        next();
        ProofPlan nothing;
        for (std::uint32_t rule = 0; rule < rules->rules.size(); ++rule) {
            Slots slots;
            for (const Part& part : rules->rules[rule].parts) slots.push_back(part.slot);
            nothing[{slots, slots}] = {};
        }
        Confluence proofs(combined, rules, lts::Followed::taus, nothing);
        for (std::vector<Local> state : states()) ASSERT_FALSE(proofs.follow_step(state)) << "round " << round;
    }
}

}  // namespace
}  // namespace robochart::machine
