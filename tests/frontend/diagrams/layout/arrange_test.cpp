// SPDX-License-Identifier: Apache-2.0
// Tests that the layout of random levels satisfies the criteria of scene.hpp, is deterministic, and changes little
// after small edits.
#include "frontend/diagrams/layout/arrange.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <utility>

#include "tests/frontend/diagrams/layout/random_levels.hpp"
#include "tests/frontend/diagrams/scene.hpp"
#include "tests/rounds.hpp"

namespace robochart::diagrams {
namespace {

using layout::arrange_level;
using layout::Direction;
using layout::Level;
using layout::Placement;

TEST(Arrange, RandomMachinesMeetTheCriteria) {
    for (std::uint64_t seed = 0; seed < tests::rounds(600); ++seed)
        for (const Direction direction : {Direction::down, Direction::right}) {
            Level level = random_machine(seed, 12);
            level.direction = direction;
            EXPECT_THAT(faults_of(scene_of(level, arrange_level(level))), ::testing::IsEmpty()) << "seed " << seed;
        }
}

TEST(Arrange, RandomComponentsMeetTheCriteria) {
    for (std::uint64_t seed = 0; seed < tests::rounds(600); ++seed) {
        const Level level = random_components(seed, 6);
        EXPECT_THAT(faults_of(scene_of(level, arrange_level(level))), ::testing::IsEmpty()) << "seed " << seed;
    }
}

bool same(const Placement& a, const Placement& b) {
    bool result = a.size == b.size && a.boxes.size() == b.boxes.size() && a.edges.size() == b.edges.size();
    for (std::size_t i = 0; result && i < a.boxes.size(); ++i) result = a.boxes[i].place == b.boxes[i].place;
    for (std::size_t i = 0; result && i < a.edges.size(); ++i)
        result = a.edges[i].points == b.edges[i].points && a.edges[i].label == b.edges[i].label;
    return result;
}

TEST(Arrange, TheSameLevelIsPlacedTheSame) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        EXPECT_TRUE(same(arrange_level(random_machine(seed, 12)), arrange_level(random_machine(seed, 12)))) << seed;
        EXPECT_TRUE(same(arrange_level(random_components(seed, 6)), arrange_level(random_components(seed, 6)))) << seed;
    }
}

/// Returns the level with the previous placement.
Level remembering(Level level, const Placement& before) {
    for (std::size_t b = 0; b < before.boxes.size(); ++b) level.boxes[b].previous = before.boxes[b].rank;
    for (std::size_t e = 0; e < before.edges.size(); ++e) level.edges[e].previous = before.edges[e].ranks;
    level.previous = before.direction;
    return level;
}

/// Returns the flips over many random levels after a change, with or without the previous placement.
Flips flips_after(void (*change)(Level&, std::uint64_t), bool remembers) {
    Flips all;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        Level level = random_machine(seed, 12);
        const Placement before = arrange_level(level);
        const Scene drawn = scene_of(level, before);
        if (remembers) level = remembering(level, before);
        change(level, seed);
        const Flips flips = flips_between(drawn, scene_of(level, arrange_level(level)));
        all.pairs += flips.pairs;
        all.flipped += flips.flipped;
    }
    return all;
}

void lengthen_a_label(Level& level, std::uint64_t seed) {
    if (level.edges.empty()) return;
    layout::Size& label = level.edges[seed % level.edges.size()].label;
    label = {label.width + 14, std::max(label.height, 14.0)};
}

void add_a_state(Level& level, std::uint64_t seed) {
    const std::size_t from = seed % level.boxes.size();
    level.boxes.emplace_back().size = {80, 46};
    layout::Edge edge;
    edge.from = from;
    edge.to = level.boxes.size() - 1;
    edge.label = {60, 14};
    level.edges.push_back(edge);
}

void delete_an_edge(Level& level, std::uint64_t seed) {
    if (level.edges.empty()) return;
    level.edges.erase(level.edges.begin() + static_cast<std::ptrdiff_t>(seed % level.edges.size()));
}

double percent(const Flips& flips) {
    return 100.0 * static_cast<double>(flips.flipped) / static_cast<double>(flips.pairs);
}

/// The layout uses the previous order. Without it, more boxes move. Random levels have more edges than typical
/// diagrams.
TEST(Arrange, SmallEditsMoveLittle) {
    EXPECT_LT(percent(flips_after(lengthen_a_label, true)), 0.5);
    EXPECT_LT(percent(flips_after(add_a_state, true)), 4);
    EXPECT_LT(percent(flips_after(delete_an_edge, true)), 4);
    EXPECT_LT(percent(flips_after(lengthen_a_label, false)), 1);
}

TEST(Arrange, WhatIsUnchangedStaysWhereItWas) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const Level level = random_machine(seed, 12);
        const Placement before = arrange_level(level);
        EXPECT_TRUE(same(before, arrange_level(remembering(level, before)))) << seed;
    }
}

/// A chain leads from top to bottom without bends. A loop is at the right side with its label next to it.
TEST(Arrange, AChainIsStraight) {
    Level level;
    level.direction = Direction::down;
    level.boxes.resize(3);
    for (layout::Box& box : level.boxes) box.size = {100, 40};
    for (const auto& [from, to] : {std::pair{0, 1}, {1, 2}, {2, 2}}) {
        layout::Edge& edge = level.edges.emplace_back();
        edge.from = static_cast<std::size_t>(from);
        edge.to = static_cast<std::size_t>(to);
        edge.label = {50, 14};
    }
    const Placement placed = arrange_level(level);
    EXPECT_EQ(placed.edges[0].points.size(), 2U);
    EXPECT_EQ(placed.edges[1].points.size(), 2U);
    EXPECT_EQ(placed.edges[2].points.size(), 4U);
    EXPECT_LT(placed.boxes[0].place.bottom(), placed.boxes[1].place.y);
    EXPECT_LT(placed.boxes[1].place.bottom(), placed.boxes[2].place.y);
    EXPECT_GT(placed.edges[2].label.x, placed.boxes[2].place.right());
}

/// State 1 leads to junction 2, and the junction to three states that lead back to state 1. If state 1 is above the
/// junction, each of the three states has two lines from above, and some lines cross. If state 1 is below them, no
/// lines cross.
TEST(Arrange, TurnsOtherLinesRoundWhereThatSparesCrossings) {
    Level level;
    level.boxes.resize(6);
    for (layout::Box& box : level.boxes) box.size = {100, 40};
    level.boxes[0].entry = true;
    for (const auto& [from, to] : {std::pair{0, 1}, {1, 2}, {2, 3}, {2, 4}, {2, 5}, {3, 1}, {4, 1}, {5, 1}}) {
        layout::Edge& edge = level.edges.emplace_back();
        edge.from = static_cast<std::size_t>(from);
        edge.to = static_cast<std::size_t>(to);
    }
    for (const Direction direction : {Direction::down, Direction::right}) {
        level.direction = direction;
        const Placement placed = arrange_level(level);
        const Scene scene = scene_of(level, placed);
        EXPECT_THAT(faults_of(scene), ::testing::IsEmpty());
        EXPECT_EQ(crossings_of(scene), 0U);
        EXPECT_TRUE(same(placed, arrange_level(remembering(level, placed))));
    }
}

/// State 1 leads to two junctions: box 5 with three outcomes, and box 6 with two. All outcomes lead back to state 1. If
/// the new state 4 is added below the middle of all outcomes, the lines of two or three other states pass next to it,
/// and these states would change their order. Above the middle there is enough space.
TEST(Arrange, WhatIsAddedTurnsItsLineRoundWhereTheRestWouldChangeItsOrder) {
    Level level;
    level.boxes.resize(9);
    for (layout::Box& box : level.boxes) box.size = {100, 40};
    level.boxes[0].entry = true;
    for (const auto& [from, to] : {std::pair{1, 6},
                                   {6, 7},
                                   {6, 8},
                                   {7, 1},
                                   {8, 1},
                                   {0, 1},
                                   {1, 5},
                                   {5, 2},
                                   {5, 3},
                                   {5, 4},
                                   {2, 1},
                                   {3, 1},
                                   {4, 1}}) {
        layout::Edge& edge = level.edges.emplace_back();
        edge.from = static_cast<std::size_t>(from);
        edge.to = static_cast<std::size_t>(to);
        edge.label = {40, 14};
    }
    const Placement placed = arrange_level(level);
    const Scene before = scene_of(level, placed);
    EXPECT_EQ(crossings_of(before), 0U);
    Level edited = remembering(level, placed);
    add_a_state(edited, 4);
    const Scene after = scene_of(edited, arrange_level(edited));
    EXPECT_THAT(faults_of(after), ::testing::IsEmpty());
    EXPECT_EQ(crossings_of(after), 0U);
    EXPECT_EQ(flips_between(before, after).flipped, 0U);
}

TEST(Arrange, NoBoxesNeedNoSpace) {
    EXPECT_EQ(arrange_level(Level()).size, (layout::Size{0, 0}));
}

TEST(Arrange, WhatIsTooLargeIsRefused) {
    Level level;
    level.boxes.resize(2000);
    for (std::size_t b = 1; b < level.boxes.size(); ++b)
        for (const std::size_t from : {b - 1, std::size_t{0}}) {
            layout::Edge& edge = level.edges.emplace_back();
            edge.from = from;
            edge.to = b;
        }
    EXPECT_THROW((void)arrange_level(level), layout::TooLarge);
}

/// Tests random levels, including larger ones. ROBOCHART_LEVELS is their number. Run this test by hand.
TEST(Arrange, ManyRandomLevelsMeetTheCriteria) {
    const char* setting = std::getenv("ROBOCHART_LEVELS");
    const std::uint64_t count = setting == nullptr ? 50 : std::strtoull(setting, nullptr, 10);
    std::size_t crossings = 0;
    for (std::uint64_t seed = 1'000'000; seed < 1'000'000 + count; ++seed) {
        const Level machine = random_machine(seed, 30);
        const Scene drawn = scene_of(machine, arrange_level(machine));
        crossings += crossings_of(drawn);
        EXPECT_THAT(faults_of(drawn), ::testing::IsEmpty()) << "machine, seed " << seed;
        const Level components = random_components(seed, 20);
        EXPECT_THAT(faults_of(scene_of(components, arrange_level(components))), ::testing::IsEmpty())
            << "components, seed " << seed;
    }
    std::cout << crossings << " crossings in " << count << " machines\n";
}

}  // namespace
}  // namespace robochart::diagrams
