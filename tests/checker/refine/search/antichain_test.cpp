// SPDX-License-Identifier: Apache-2.0
// Compares antichains with the search of all pairs, on random nondeterministic systems. Tests also a specification
// whose normal form is too large to build.
#include "checker/refine/search/antichain.hpp"

#include <gtest/gtest.h>

#include <random>

#include "checker/lts/graph.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/verdict/check.hpp"
#include "checker/refine/verdict/monitors.hpp"
#include "checker/refine/verdict/question.hpp"

namespace robochart::refine {
namespace {

using lts::Graph;
using process::Event;

Graph random_graph(std::mt19937& random, std::size_t states, unsigned taus) {
    Graph graph;
    for (std::size_t state = 0; state < states; ++state) {
        for (std::size_t i = 0, edges = 1 + random() % 4; i < edges; ++i)
            graph.add_edge({random() % 100 < taus ? process::tau : static_cast<Event>(process::tick + random() % 3),
                            static_cast<lts::StateIndex>(random() % states)});
        graph.finish_state();
    }
    return graph;
}

struct Answer {
    std::optional<std::size_t> steps;  ///< length of the violation, including a forbidden event
    std::size_t pairs = 0;
};

Answer answer(const Graph& specification, const Graph& implementation, Model model, Search::Pairs pairs) {
    const process::EventTable table;
    lts::GraphSystem first(specification, table);
    lts::GraphSystem second(implementation, table);
    const Limits limits;
    Budget budget(limits);
    NormalForm normal(first, budget);
    RefinementMonitor monitor(normal, model);
    const bool with_divergence = model == Model::failures_divergences;
    if (with_divergence && normal.diverges(normal.initial())) return {};
    Search search(second, monitor, budget, with_divergence, pairs);
    std::optional<Violation> violation;
    if (const auto finding = search.first_violation())
        violation = violation_of(search, second, *finding);
    else if (with_divergence)
        violation = first_divergence(search);
    if (!violation) return {{}, search.states()};
    confirm_refinement_violation(first, second, model, *violation, budget);
    return {violation->run.steps.size(), search.states()};
}

TEST(Antichains, GiveTheShortestViolationsOfAllPairs) {
    std::mt19937 random(3);
    int holds = 0;
    int fails = 0;
    int saved = 0;
    for (int round = 0; round < 3000; ++round) {
        const Graph specification = random_graph(random, 2 + random() % 6, round % 4 == 0 ? 0 : 20);
        const unsigned taus = round % 8 == 0 ? 25 : 0;
        const Graph implementation = round % 3 == 0 ? specification : random_graph(random, 1 + random() % 5, taus);
        for (const Model model : {Model::traces, Model::failures, Model::failures_divergences}) {
            const Answer all = answer(specification, implementation, model, Search::Pairs::all);
            const Answer some = answer(specification, implementation, model, Search::Pairs::antichain);
            ASSERT_EQ(some.steps, all.steps) << round;
            if (!all.steps) {
                ASSERT_LE(some.pairs, all.pairs);
            }
            ++(all.steps ? fails : holds);
            if (!all.steps && some.pairs < all.pairs) ++saved;
        }
    }
    EXPECT_GT(holds, 2000);
    EXPECT_GT(fails, 2000);
    EXPECT_GT(saved, 200);
}

/// Returns a graph that accepts words of a and b, guesses that the k-th last letter was a, and then ends.
Graph kth_last_letter(lts::StateIndex k) {
    constexpr Event a = process::first_visible;
    Graph graph;
    graph.add_edge({a, 0});
    graph.add_edge({a, 1});
    graph.add_edge({a + 1, 0});
    graph.finish_state();
    for (lts::StateIndex state = 1; state <= k; ++state) {
        if (state < k) graph.add_edge({a, state + 1});
        if (state < k) graph.add_edge({a + 1, state + 1});
        graph.finish_state();
    }
    return graph;
}

/// After the limit has refused a node, another thread may request the same node. It must be refused again, and must not
/// get a number without a node.
TEST(NormalForms, RefuseANodeBeyondTheLimitEachTime) {
    const process::EventTable table;
    const Graph graph = kth_last_letter(16);
    lts::GraphSystem system(graph, table);
    Limits limits;
    limits.max_states = 40;
    Budget budget(limits);
    NormalForm normal(system, budget);
    NormalForm::Node node = normal.initial();
    constexpr Event a = process::first_visible;
    const auto refused = [&](Event event) {
        try {
            node = normal.node_after(node, event).value();
        } catch (const LimitReached&) {
            return true;
        }
        return false;
    };
    std::mt19937 random(1);
    Event event = a;
    int steps = 0;
    for (; !refused(event) && steps < 10'000; ++steps) event = a + random() % 2;
    ASSERT_LT(steps, 10'000);
    EXPECT_TRUE(refused(event));
    EXPECT_TRUE(refused(event));
}

TEST(Antichains, DecideSpecificationsWithHugeNormalForms) {
    const process::EventTable table;
    for (const lts::StateIndex k : {16U, 20U, 24U}) {
        const Graph graph = kth_last_letter(k);
        lts::GraphSystem system(graph, table);
        lts::GraphSystem again(graph, table);
        Limits limits;
        limits.max_states = 10'000;
        for (const Model model : {Model::traces, Model::failures, Model::failures_divergences})
            EXPECT_EQ(refines(system, again, model, limits).outcome, Outcome::holds) << k;
        const Graph other = kth_last_letter(k + 1);
        lts::GraphSystem longer(other, table);
        EXPECT_EQ(refines(system, longer, Model::failures, limits).outcome, Outcome::fails)
            << "the end may come a letter later than it must";
    }
}

}  // namespace
}  // namespace robochart::refine
