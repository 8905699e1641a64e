// SPDX-License-Identifier: Apache-2.0
// Tests positions by isotonic regression. Compares them with the definition, and with all positions of a grid.
#include "frontend/diagrams/layout/isotonic.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/diagnostics/splitmix64.hpp"

namespace robochart::diagrams::layout {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

TEST(Isotonic, WhatIsInOrderStays) {
    EXPECT_THAT(nearest_places(std::vector<Wish>{{1, 1, 0}, {5, 1, 2}, {9, 1, 2}}), ElementsAre(1, 5, 9));
}

/// Two boxes with the same desired position move apart in proportion to their weights. The weighted mean is the desired
/// position.
TEST(Isotonic, NeighboursGiveWayByTheirWeights) {
    EXPECT_THAT(nearest_places(std::vector<Wish>{{10, 1, 0}, {10, 1, 4}}), ElementsAre(8, 12));
    EXPECT_THAT(nearest_places(std::vector<Wish>{{10, 3, 0}, {10, 1, 4}}), ElementsAre(9, 13));
}

TEST(Isotonic, BoundsHold) {
    EXPECT_THAT(nearest_places(std::vector<Wish>{{-5, 1, 0}, {50, 1, 4}}, 0, 20), ElementsAre(0, 20));
    EXPECT_THAT(nearest_places(std::vector<Wish>{{50, 1, 0}, {50, 1, 4}}, 0, 20), ElementsAre(16, 20));
    EXPECT_THAT(nearest_places(std::vector<Wish>{{0, 1, 0}, {0, 1, 40}}, 0, 20), ElementsAre(0, 20));
}

double cost(const std::vector<Wish>& wishes, const std::vector<double>& places) {
    double sum = 0;
    for (std::size_t i = 0; i < wishes.size(); ++i)
        sum += wishes[i].weight * (places[i] - wishes[i].wanted) * (places[i] - wishes[i].wanted);
    return sum;
}

/// No positions on a grid of integers have a lower cost than the computed ones.
TEST(Isotonic, IsTheCheapest) {
    std::uint64_t state = 1;
    for (int round = 0; round < 200; ++round) {
        std::vector<Wish> wishes(3);
        for (Wish& wish : wishes)
            wish = {static_cast<double>(diagnostics::splitmix64(state) % 10),
                    static_cast<double>(1 + diagnostics::splitmix64(state) % 3),
                    static_cast<double>(diagnostics::splitmix64(state) % 4)};
        const double found = cost(wishes, nearest_places(wishes));
        for (double a = -8; a < 18; ++a)
            for (double b = a + wishes[1].gap; b < 18; ++b)
                for (double c = b + wishes[2].gap; c < 26; ++c) ASSERT_LE(found, cost(wishes, {a, b, c}) + 1e-9);
    }
}

}  // namespace
}  // namespace robochart::diagrams::layout
