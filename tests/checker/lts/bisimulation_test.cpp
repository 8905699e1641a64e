// SPDX-License-Identifier: Apache-2.0
// Tests minimisation: known quotients, strong bisimulation compared with the greatest bisimulation (computed by
// eliminating pairs), and preservation of the models on random processes.
#include "checker/lts/bisimulation.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "checker/process/term_system.hpp"
#include "checker/refine/verdict/check.hpp"
#include "tests/checker/processes/random_process.hpp"
#include "tests/checker/processes/translate.hpp"

namespace robochart::lts {
namespace {

Graph graph_of(const std::vector<std::vector<Edge>>& rows) {
    Graph graph;
    for (const auto& row : rows) {
        for (const Edge& edge : row) graph.add_edge(edge);
        graph.finish_state();
    }
    return graph;
}

constexpr Event a = 2;
constexpr Event b = 3;
constexpr Event tau = process::tau;
constexpr Equivalence strong = Equivalence::strong;
constexpr Equivalence branching = Equivalence::branching_with_divergence;

TEST(Bisimulation, MergesEqualStatesAndUnrolledLoops) {
    const Graph loop = graph_of({{{a, 1}}, {{a, 2}}, {{a, 0}}});
    EXPECT_EQ(minimise(loop, strong).graph, graph_of({{{a, 0}}}));
    const Graph fan = graph_of({{{a, 1}, {a, 2}}, {{b, 3}}, {{b, 3}}, {}});
    const Quotient quotient = minimise(fan, strong);
    EXPECT_EQ(quotient.graph, graph_of({{{a, 1}}, {{b, 2}}, {}}));
    EXPECT_EQ(quotient.representative, (std::vector<StateIndex>{0, 1, 3}));
    EXPECT_EQ(quotient.state_of, (std::vector<StateIndex>{0, 1, 1, 2}));
}

TEST(Bisimulation, KeepsTheMomentOfChoice) {
    // Compares a.(b + c) with a.b + a.c, the textbook pair.
    const Graph late = graph_of({{{a, 1}}, {{a, 2}, {b, 2}}, {}});
    EXPECT_EQ(minimise(late, strong).graph.size(), 3U);
    const Graph early = graph_of({{{a, 1}, {a, 2}}, {{a, 3}}, {{b, 3}}, {}});
    EXPECT_EQ(minimise(early, strong).graph.size(), 4U);
    EXPECT_EQ(minimise(early, branching).graph.size(), 4U);
}

TEST(Bisimulation, BranchingRemovesInertTausOnly) {
    EXPECT_EQ(minimise(graph_of({{{tau, 1}}, {{tau, 2}}, {{a, 3}}, {}}), branching).graph, graph_of({{{a, 1}}, {}}));
    // In tau.a + b, the tau discards b.
    const Graph choosing = graph_of({{{tau, 1}, {b, 2}}, {{a, 2}}, {}});
    EXPECT_EQ(minimise(choosing, branching).graph.size(), 3U);
    // The process is a + tau.(a + b), where both a's lead to the same state. The tau is inert for branching
    // bisimulation, because everything is offered after it.
    const Graph inert = graph_of({{{tau, 1}, {a, 2}}, {{a, 2}, {b, 2}}, {}});
    EXPECT_EQ(minimise(inert, branching).graph, graph_of({{{a, 1}, {b, 1}}, {}}));
}

TEST(Bisimulation, BranchingKeepsDivergence) {
    const Graph diverging = graph_of({{{tau, 1}, {a, 2}}, {{tau, 0}}, {}});
    EXPECT_EQ(minimise(diverging, branching).graph, graph_of({{{tau, 0}, {a, 1}}, {}}));
    // A state that diverges and a state that does not are different, although both can perform only a.
    const Graph mixed = graph_of({{{b, 1}, {b, 2}}, {{tau, 1}, {a, 3}}, {{a, 3}}, {}});
    EXPECT_EQ(minimise(mixed, branching).graph.size(), 4U);
}

TEST(Bisimulation, LeavesOutWhatIsNotReached) {
    const Graph graph = graph_of({{{a, 0}}, {{b, 1}}});
    const Quotient quotient = minimise(graph, strong);
    EXPECT_EQ(quotient.graph, graph_of({{{a, 0}}}));
    EXPECT_EQ(quotient.state_of, (std::vector<StateIndex>{0, no_state}));
}

/// Returns the number of classes of the greatest bisimulation, computed by removing distinguishable pairs.
std::size_t classes_by_elimination(const Graph& graph) {
    const auto n = static_cast<StateIndex>(graph.size());
    std::set<std::pair<StateIndex, StateIndex>> related;
    for (StateIndex p = 0; p < n; ++p)
        for (StateIndex q = 0; q < n; ++q) related.emplace(p, q);
    const auto simulated = [&](StateIndex p, StateIndex q) {
        for (const Edge& step : graph.edges(p)) {
            bool answered = false;
            for (const Edge& reply : graph.edges(q))
                answered = answered || (reply.event == step.event && related.contains({step.target, reply.target}));
            if (!answered) return false;
        }
        return true;
    };
    for (bool removed = true; removed;)
        removed = std::erase_if(related, [&](const auto& pair) {
                      return !simulated(pair.first, pair.second) || !related.contains({pair.second, pair.first});
                  }) > 0;
    std::set<std::set<StateIndex>> classes;
    for (StateIndex p = 0; p < n; ++p) {
        std::set<StateIndex> equals;
        for (StateIndex q = 0; q < n; ++q)
            if (related.contains({p, q})) equals.insert(q);
        classes.insert(equals);
    }
    return classes.size();
}

/// Returns whether the minimal graphs have the same size. Minimal graphs of equivalent processes differ only in their
/// numbering.
bool same_size(const Graph& x, const Graph& y) {
    return x.size() == y.size() && x.edge_count() == y.edge_count();
}

RC_GTEST_PROP(Bisimulation, OfRandomGraphsIsTheGreatest, ()) {
    const auto size = *rc::gen::inRange<StateIndex>(1, 14);
    std::vector<std::vector<Edge>> rows;
    for (StateIndex state = 0; state < size; ++state) {
        rows.emplace_back();
        // Each state leads to the next one, so all states are reachable.
        if (state + 1 < size) rows.back().push_back({*rc::gen::inRange<Event>(0, 3), state + 1});
        const int more = *rc::gen::inRange(0, 3);
        for (int i = 0; i < more; ++i)
            rows.back().push_back({*rc::gen::inRange<Event>(0, 3), *rc::gen::inRange<StateIndex>(0, size)});
    }
    const Graph graph = graph_of(rows);
    const Quotient quotient = minimise(graph, strong);
    RC_ASSERT(quotient.graph.size() == classes_by_elimination(graph));
    RC_ASSERT(same_size(minimise(quotient.graph, strong).graph, quotient.graph));
    const Quotient coarser = minimise(graph, branching);
    RC_ASSERT(coarser.graph.size() <= quotient.graph.size());
    RC_ASSERT(same_size(minimise(coarser.graph, branching).graph, coarser.graph));
    RC_ASSERT(same_size(minimise(quotient.graph, branching).graph, coarser.graph));
}

RC_GTEST_PROP(Bisimulation, KeepsTheModels, ()) {
    const auto numbers = *rc::gen::container<std::vector<unsigned>>(rc::gen::inRange<unsigned>(0, 2520));
    const refine::naive::Script script = refine::naive::Decoder(numbers).script(1);
    refine::Translation translation(script);
    process::TermSystem system = translation.system(script.mains[0]);
    const auto small = [](std::size_t states) {
        if (states > 500) throw std::length_error("too many states for a test");
    };
    std::optional<Exploration> explored;
    try {
        explored = explore(system, small);
    } catch (const std::length_error&) {
        RC_DISCARD("too large");
    }
    const auto models = {refine::Model::traces, refine::Model::failures, refine::Model::failures_divergences};
    for (const Equivalence equivalence : {strong, branching}) {
        const Quotient quotient = minimise(explored->graph, equivalence);
        GraphSystem reduced(quotient.graph, system.events());
        for (const refine::Model model : models) {
            RC_ASSERT(refine::refines(system, reduced, model, {}).outcome == refine::Outcome::holds);
            RC_ASSERT(refine::refines(reduced, system, model, {}).outcome == refine::Outcome::holds);
        }
    }
}

TEST(Bisimulation, OfALongChainIsFast) {
    constexpr StateIndex length = 20000;
    Graph chain;
    for (StateIndex state = 0; state < length; ++state) {
        chain.add_edge({state % 2 == 0 ? a : tau, state + 1});
        chain.finish_state();
    }
    chain.finish_state();
    EXPECT_EQ(minimise(chain, strong).graph.size(), length + 1U);
    EXPECT_EQ(minimise(chain, branching).graph.size(), length / 2U + 1U);
}

}  // namespace
}  // namespace robochart::lts
