// SPDX-License-Identifier: Apache-2.0
// Tests that the world moves robots according to the kinematics, prevents overlaps, and is reproducible bit for bit.
#include "simulation/world/world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace robochart::simulation {
namespace {

WorldOptions open_field() {
    WorldOptions options;
    options.arena.walled = false;
    return options;
}

TEST(World, DrivesStraight) {
    World world(open_field(), 1);
    world.add_robot({{1, 2}, std::numbers::pi / 2});
    world.set_wheels(0, {10, 10});
    for (int i = 0; i < 20; ++i) world.advance();
    EXPECT_NEAR(world.position(0).x, 1, 1e-9);
    EXPECT_NEAR(world.position(0).y, 22, 1e-9);
    EXPECT_NEAR(world.time(), 2, 1e-12);
}

TEST(World, TurnsOnTheSpot) {
    World world(open_field(), 1);
    world.add_robot({{0, 0}, 0});
    world.set_wheels(0, {12.8, -12.8});
    world.advance();
    EXPECT_NEAR(world.heading(0), -25.6 / 5.1 * 0.1, 1e-12);
    EXPECT_EQ(world.position(0), (Vector{0, 0}));
}

/// The robot drives the circle of the first case study: -10.88 cm/s at -0.7529 rad/s, which gives a radius of 14.45 cm.
/// The midpoint rule stays on a circle whose radius is larger by the fraction (w h)^2 / 24.
TEST(World, ClosesACircle) {
    World world(open_field(), 1);
    world.add_robot({{0, 0}, 0});
    const Wheels wheels{-0.7 * 12.8, -1.0 * 12.8};
    world.set_wheels(0, wheels);
    const double angular = (wheels.right - wheels.left) / 5.1;
    const double linear = (wheels.left + wheels.right) / 2;
    const double radius = linear / angular;
    for (int i = 0; i < 200; ++i) {
        world.advance();
        const double angle = angular * world.time();
        EXPECT_NEAR(world.position(0).x, radius * std::sin(angle), 1e-3);
        EXPECT_NEAR(world.position(0).y, radius * (1 - std::cos(angle)), 1e-3);
    }
}

TEST(World, WheelsForSpeedsAndClamp) {
    // The paper's two pairs of speeds are (-0.75 rad/s, -10.88 cm/s), which is about (-0.7, -1.0), and -5.02 rad/s,
    // which is (1.0, -1.0), relative to 12.8.
    const Wheels circle = wheels_for(-10.88, -0.75, 5.1);
    EXPECT_NEAR(circle.left / 12.8, -0.7, 0.002);
    EXPECT_NEAR(circle.right / 12.8, -1.0, 0.002);
    const Wheels spot = wheels_for(0, -5.02, 5.1);
    EXPECT_NEAR(spot.left / 12.8, 1.0, 0.001);
    EXPECT_NEAR(spot.right / 12.8, -1.0, 0.001);
    World world(open_field(), 1);
    world.add_robot({{0, 0}, 0});
    world.set_wheels(0, {1000, 1000});
    world.advance();
    EXPECT_NEAR(world.position(0).x, 1.28, 1e-12);
}

TEST(World, StopsAtWalls) {
    WorldOptions options;
    options.arena.walls.push_back({{-20, 30}, {20, 30}});
    World world(options, 1);
    world.add_robot({{100, 0}, 0});
    world.add_robot({{0, 0}, std::numbers::pi / 2});
    for (std::size_t i = 0; i < 2; ++i) world.set_wheels(i, {12.8, 12.8});
    for (int i = 0; i < 100; ++i) world.advance();
    EXPECT_NEAR(world.position(0).x, 125 - 3.7, 1e-9);
    EXPECT_NEAR(world.position(1).y, 30 - 3.7, 1e-9);
}

TEST(World, PushesMeetInTheMiddle) {
    World world(open_field(), 1);
    world.add_robot({{-10, 0}, 0});
    world.add_robot({{10, 0}, std::numbers::pi});
    for (std::size_t i = 0; i < 2; ++i) world.set_wheels(i, {5, 5});
    for (int i = 0; i < 50; ++i) world.advance();
    EXPECT_NEAR(world.position(0).x, -3.7, 1e-9);
    EXPECT_NEAR(world.position(1).x, 3.7, 1e-9);
}

TEST(World, PartsRobotsAtOnePlace) {
    World world(open_field(), 1);
    world.add_robot({{0, 0}, 0});
    world.add_robot({{0, 0}, 0});
    world.advance();
    EXPECT_NEAR(world.position(1).x - world.position(0).x, 7.4, 1e-9);
}

World crowd(std::size_t robots, std::size_t cells_from, std::uint64_t seed) {
    WorldOptions options;
    options.arena.width = options.arena.height = 12 * std::sqrt(static_cast<double>(robots)) + 10;
    options.arena.walls.push_back({{-10, -5}, {10, 8}});
    options.body.noise = 0.05;
    options.cells_from = cells_from;
    World world(options, seed);
    const Vector corner{options.arena.width / 2, options.arena.height / 2};
    EXPECT_TRUE(world.place_at_random(robots, {Vector{} - corner, corner}));
    return world;
}

/// Gives robots new random speeds from time to time.
void drive(World& world, Random& random) {
    for (std::size_t i = 0; i < world.size(); ++i)
        if (random.draw_chance(0.2)) world.set_wheels(i, {random.uniform(-13, 13), random.uniform(-13, 13)});
    world.advance();
}

/// The neighbour list in cells finds the same pairs in the same order as a comparison of all pairs, so the results are
/// equal bit for bit.
TEST(WorldProperty, CellsAndPairsListsAgreeBitForBit) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const std::size_t robots = 5 + 11 * seed;
        World plain = crowd(robots, 1000000, seed);
        World celled = crowd(robots, 0, seed);
        Random one(seed), two(seed);
        for (int step = 0; step < 120; ++step) {
            drive(plain, one);
            drive(celled, two);
        }
        for (std::size_t i = 0; i < robots; ++i) {
            ASSERT_EQ(plain.position(i), celled.position(i)) << "seed " << seed << " robot " << i;
            ASSERT_EQ(plain.heading(i), celled.heading(i));
        }
    }
}

TEST(WorldProperty, OverlapStaysBelowAPhysicsStep) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        World world = crowd(60, 40, seed);
        Random random(seed);
        for (int step = 0; step < 200; ++step) {
            drive(world, random);
            // There is one projection pass per physics step, so the remaining overlap is at most the distance that
            // robots drive in a few steps.
            ASSERT_LT(world.largest_overlap(), 1.0) << "seed " << seed << " at " << world.time();
        }
    }
}

TEST(World, SameSeedSameBitsOtherSeedOthers) {
    const auto end = [](std::uint64_t seed) {
        World world = crowd(30, 40, seed);
        Random random(5);
        for (int step = 0; step < 300; ++step) drive(world, random);
        return world.position(17);
    };
    EXPECT_EQ(end(3), end(3));
    EXPECT_NE(end(3), end(4));
}

TEST(World, PlacesApartAndInside) {
    World world(WorldOptions{}, 9);
    ASSERT_TRUE(world.place_at_random(100, {{-60, -60}, {60, 60}}));
    EXPECT_EQ(world.largest_overlap(), 0);
    for (std::size_t i = 0; i < 100; ++i) EXPECT_LE(std::abs(world.position(i).x), 60 - 3.7);
}

TEST(World, PlacesManyQuickly) {
    WorldOptions options;
    options.arena.width = options.arena.height = 4000;
    World world(options, 4);
    ASSERT_TRUE(world.place_at_random(20000, {{-2000, -2000}, {2000, 2000}}));
    World crowded(options, 4);
    // The square has 640,000 cm2, but the disks cover 688,000 cm2.
    EXPECT_FALSE(crowded.place_at_random(16000, {{-400, -400}, {400, 400}})) << "denser than disks can be thrown";
}

TEST(World, TellsWhenRobotsDoNotFit) {
    World world(WorldOptions{}, 9);
    EXPECT_FALSE(world.place_at_random(100, {{-20, -20}, {20, 20}}));
    EXPECT_FALSE(world.place_at_random(1, {{0, 0}, {5, 50}})) << "narrower than a robot";
}

TEST(World, NoiseIsOfTheSpeedAsked) {
    WorldOptions options = open_field();
    options.body.noise = 0.05;
    World world(options, 2);
    world.add_robot({{0, 0}, 0});
    world.set_wheels(0, {10, 10});
    double last = 0;
    double low = 10, high = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vector before = world.position(0);
        world.advance();
        last = length(world.position(0) - before) / 0.1;
        low = std::min(low, last);
        high = std::max(high, last);
    }
    EXPECT_GE(low, 9.499);
    EXPECT_LE(high, 10.501);
    EXPECT_GT(high - low, 0.8) << "the noise is there";
}

}  // namespace
}  // namespace robochart::simulation
