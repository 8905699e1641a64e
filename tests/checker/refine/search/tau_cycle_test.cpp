// SPDX-License-Identifier: Apache-2.0
// Compares tau cycles with reachability, which is computed edge by edge.
#include "checker/refine/search/tau_cycle.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace robochart::refine {
namespace {

using lts::StateIndex;
using Edges = std::vector<std::vector<StateIndex>>;

GraphView view_of(const Edges& edges) {
    return {edges.size(), [&edges](StateIndex vertex, std::vector<StateIndex>& targets) {
                targets.insert(targets.end(), edges[vertex].begin(), edges[vertex].end());
            }};
}

std::vector<StateIndex> back_targets(const Edges& edges) {
    BackTargets back;
    for (StateIndex vertex = 0; vertex < edges.size(); ++vertex)
        for (const StateIndex target : edges[vertex]) back.note_tau(vertex, target);
    return back.list();
}

std::vector<StateIndex> all_vertices(const Edges& edges) {
    std::vector<StateIndex> vertices(edges.size());
    std::iota(vertices.begin(), vertices.end(), 0);
    return vertices;
}

/// Returns the length of the shortest path from a vertex to itself, or 0 if there is none.
std::size_t way_back(const Edges& edges, StateIndex vertex) {
    std::vector<bool> reached(edges.size(), false);
    std::vector<StateIndex> level{vertex};
    for (std::size_t length = 1; !level.empty(); ++length) {
        std::vector<StateIndex> next;
        for (const StateIndex from : level)
            for (const StateIndex to : edges[from]) {
                if (to == vertex) return length;
                if (!reached[to]) next.push_back(to);
                reached[to] = true;
            }
        level = std::move(next);
    }
    return 0;
}

TEST(TauCycle, FindsTheLeastVertexOnACycle) {
    const Edges edges{{1, 2}, {3}, {4}, {}, {5, 3}, {6}, {4}, {7}};
    EXPECT_EQ(back_targets(edges), (std::vector<StateIndex>{3, 4, 7}));
    EXPECT_EQ(least_on_cycle(view_of(edges), back_targets(edges)), 4U);
    EXPECT_EQ(shortest_cycle(view_of(edges), 4), (std::vector<StateIndex>{5, 6, 4}));
    EXPECT_EQ(shortest_cycle(view_of(edges), 7), (std::vector<StateIndex>{7}));
    EXPECT_TRUE(shortest_cycle(view_of(edges), 0).empty());
    EXPECT_EQ(least_on_cycle(view_of(Edges(2)), {}), std::nullopt);
}

TEST(TauCycle, AgreesWithReachability) {
    std::mt19937 random(3);
    int with = 0;
    int without = 0;
    for (int round = 0; round < 2000; ++round) {
        Edges edges(1 + random() % 30);
        for (StateIndex vertex = 0; vertex < edges.size(); ++vertex)
            for (unsigned i = 0; i < random() % 3; ++i)
                edges[vertex].push_back(static_cast<StateIndex>(
                    random() % 8 == 0 || vertex + 1 == edges.size()
                        ? random() % edges.size()
                        : vertex + 1 + random() % std::min<std::size_t>(4, edges.size() - vertex - 1)));
        std::optional<StateIndex> expected;
        for (StateIndex vertex = 0; vertex < edges.size() && !expected; ++vertex)
            if (way_back(edges, vertex) != 0) expected = vertex;
        ASSERT_EQ(least_on_cycle(view_of(edges), back_targets(edges)), expected);
        ASSERT_EQ(least_on_cycle(view_of(edges), all_vertices(edges)), expected);
        if (expected) {
            ASSERT_EQ(shortest_cycle(view_of(edges), *expected).size(), way_back(edges, *expected));
        }
        ++(expected ? with : without);
    }
    EXPECT_GT(with, 200);
    EXPECT_GT(without, 200);
}

/// The path is too long for recursion. The search follows only edges that lead to an entry of a possible cycle.
TEST(TauCycle, LooksOnlyWhereABackwardEdgeLeads) {
    constexpr StateIndex size = 1'000'000;
    std::size_t calls = 0;
    const GraphView graph{size, [&calls](StateIndex vertex, std::vector<StateIndex>& targets) {
                              ++calls;
                              if (vertex + 1 < size) targets.push_back(vertex + 1);
                              if (vertex == size - 1) targets.push_back(size - 3);
                          }};
    EXPECT_EQ(least_on_cycle(graph, {size - 3}), size - 3);
    EXPECT_LE(calls, 6U);
    EXPECT_EQ(least_on_cycle(graph, {0, size - 3}), size - 3);
}

}  // namespace
}  // namespace robochart::refine
