// SPDX-License-Identifier: Apache-2.0
// Compares strongly connected components with their definition, in which vertices of a component reach each other.
#include "checker/lts/strong_components.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "tests/rounds.hpp"

namespace robochart::lts {
namespace {

using Edges = std::vector<std::vector<StateIndex>>;

struct Component {
    std::vector<StateIndex> members;  // ascending
    bool cyclic;
    friend bool operator==(const Component&, const Component&) = default;
};

GraphView view_of(const Edges& edges) {
    return {edges.size(), [&edges](StateIndex vertex, std::vector<StateIndex>& targets) {
                targets.insert(targets.end(), edges[vertex].begin(), edges[vertex].end());
            }};
}

std::vector<StateIndex> all_vertices(const Edges& edges) {
    std::vector<StateIndex> vertices(edges.size());
    std::iota(vertices.begin(), vertices.end(), StateIndex{0});
    return vertices;
}

std::vector<Component> components(const Edges& edges, const std::vector<StateIndex>& roots) {
    std::vector<Component> result;
    strong_components(view_of(edges), roots, [&](std::span<const StateIndex> members, bool cyclic) {
        result.push_back({{members.begin(), members.end()}, cyclic});
        std::ranges::sort(result.back().members);
    });
    return result;
}

/// Returns which vertices are reachable from which by one edge or more.
std::vector<std::vector<bool>> reachability(const Edges& edges) {
    const std::size_t size = edges.size();
    std::vector<std::vector<bool>> reaches(size, std::vector<bool>(size, false));
    for (std::size_t from = 0; from < size; ++from)
        for (const StateIndex to : edges[from]) reaches[from][to] = true;
    for (std::size_t by = 0; by < size; ++by)
        for (std::size_t from = 0; from < size; ++from)
            for (std::size_t to = 0; to < size; ++to)
                if (reaches[from][by] && reaches[by][to]) reaches[from][to] = true;
    return reaches;
}

TEST(StrongComponents, ComeAfterThoseThatTheyLeadTo) {
    const Edges edges{{1}, {2, 3}, {1, 4}, {3}, {}};
    EXPECT_EQ(components(edges, all_vertices(edges)),
              (std::vector<Component>{{{4}, false}, {{3}, true}, {{1, 2}, true}, {{0}, false}}));
}

TEST(StrongComponents, AreThoseThatTheRootsLeadTo) {
    const Edges edges{{1}, {0}, {0, 3}, {3}, {4}};
    EXPECT_EQ(components(edges, {3, 1}), (std::vector<Component>{{{3}, true}, {{0, 1}, true}}));
    EXPECT_TRUE(components(edges, {}).empty());
}

TEST(StrongComponents, AreTheVerticesThatReachEachOther) {
    std::mt19937_64 random(20);
    for (int round = 0; round < 400; ++round) {
        const std::size_t size = 1 + random() % 14;
        Edges edges(size);
        for (std::size_t left = random() % (2 * size + 1); left > 0; --left)
            edges[random() % size].push_back(static_cast<StateIndex>(random() % size));
        const auto reaches = reachability(edges);
        std::vector<std::size_t> number(size, size);
        const std::vector<Component> found = components(edges, all_vertices(edges));
        for (std::size_t i = 0; i < found.size(); ++i)
            for (const StateIndex member : found[i].members) {
                EXPECT_EQ(number[member], size) << "in two components";
                number[member] = i;
                EXPECT_EQ(found[i].cyclic, reaches[member][member]);
            }
        for (std::size_t a = 0; a < size; ++a)
            for (std::size_t b = 0; b < size; ++b) {
                EXPECT_EQ(number[a] == number[b], a == b || (reaches[a][b] && reaches[b][a]));
                EXPECT_TRUE(!reaches[a][b] || number[b] <= number[a]);
            }
    }
}

/// On this path, a recursive algorithm would need a stack as deep as the path is long.
TEST(StrongComponents, OfLongPathsNeedNoDeepStack) {
    constexpr StateIndex size = tests::size_of_input(2'000'000);
    for (const bool closed : {false, true}) {
        const GraphView path{size, [&](StateIndex vertex, std::vector<StateIndex>& targets) {
                                 if (closed || vertex + 1 < size) targets.push_back((vertex + 1) % size);
                             }};
        std::size_t count = 0;
        const std::vector<StateIndex> root{0};
        strong_components(path, root, [&](std::span<const StateIndex>, bool cyclic) {
            ++count;
            EXPECT_EQ(cyclic, closed);
        });
        EXPECT_EQ(count, closed ? 1U : size);
    }
}

}  // namespace
}  // namespace robochart::lts
