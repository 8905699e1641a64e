// SPDX-License-Identifier: Apache-2.0
// Compares sensors with readings computed by hand, and the grid with a test of every robot.
#include "simulation/world/sensing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace robochart::simulation {
namespace {

constexpr double pi = std::numbers::pi;

struct Scene {
    explicit Scene(const std::vector<Pose>& poses, WorldOptions options = {}) : world(options, 1), sensing(world) {
        for (const Pose& pose : poses) world.add_robot(pose);
        sensing.update_positions();
    }
    World world;
    Sensing sensing;
};

TEST(LineOfSight, SeesTheRobotInFrontAtItsSurface) {
    Scene scene({{{0, 0}, 0}, {{50, 0}, 0}});
    const Sight sight = scene.sensing.line_of_sight(0, 0);
    EXPECT_EQ(sight.what, Seen::robot);
    EXPECT_NEAR(sight.distance, 50 - 3.7 - 3.7, 1e-9) << "from the front edge";
}

TEST(LineOfSight, IsAsThinAsARay) {
    // The second robot is offset by slightly less, and then by slightly more, than a radius.
    EXPECT_EQ(Scene({{{0, 0}, 0}, {{50, 3.69}, 0}}).sensing.line_of_sight(0, 0).what, Seen::robot);
    EXPECT_EQ(Scene({{{0, 0}, 0}, {{50, 3.71}, 0}}).sensing.line_of_sight(0, 0).what, Seen::wall);
    EXPECT_EQ(Scene({{{0, 0}, 0}, {{-50, 0}, 0}}).sensing.line_of_sight(0, 0).what, Seen::wall) << "behind";
}

TEST(LineOfSight, MeetsTheNearerThing) {
    WorldOptions options;
    options.arena.walls.push_back({{30, -5}, {30, 5}});
    Scene scene({{{0, 0}, 0}, {{50, 0}, 0}}, options);
    EXPECT_EQ(scene.sensing.line_of_sight(0, 0).what, Seen::wall);
    EXPECT_NEAR(scene.sensing.line_of_sight(0, 0).distance, 30 - 3.7, 1e-9);
    EXPECT_EQ(scene.sensing.line_of_sight(0, 20).what, Seen::nothing) << "out of range";
}

TEST(LineOfSight, SeesTheOuterWall) {
    Scene scene({{{0, 0}, pi / 2}});
    EXPECT_NEAR(scene.sensing.line_of_sight(0, 0).distance, 125 - 3.7, 1e-9);
    WorldOptions endless;
    endless.arena.walled = false;
    EXPECT_EQ(Scene({{{0, 0}, 0}}, endless).sensing.line_of_sight(0, 0).what, Seen::nothing);
}

TEST(RangeAndBearing, MeasuresFromCentreToCentre) {
    Scene scene({{{0, 0}, pi / 2}, {{30, 0}, 0}, {{0, 40}, 0}, {{0, -90}, 0}});
    const auto heard = scene.sensing.range_and_bearing(0, {}, 80);
    ASSERT_EQ(heard.size(), 2U) << "the fourth is out of range";
    EXPECT_NEAR(heard[0].distance, 30, 1e-9);
    EXPECT_NEAR(heard[0].angle, -pi / 2, 1e-9) << "to the right";
    EXPECT_NEAR(heard[1].angle, 0, 1e-9);
}

TEST(RangeAndBearing, HidesWhoStandsBehind) {
    Scene scene({{{0, 0}, 0}, {{30, 0}, 0}, {{60, 1}, 0}});
    EXPECT_EQ(scene.sensing.range_and_bearing(0, {}, 80).size(), 1U);
    RangeAndBearing open;
    open.occlusion = false;
    EXPECT_EQ(scene.sensing.range_and_bearing(0, open, 80).size(), 2U);
}

TEST(RangeAndBearing, LosesTheShareOfMessagesItIsGiven) {
    Scene scene({{{0, 0}, 0}, {{30, 0}, 0}});
    RangeAndBearing lossy;
    lossy.loss = 0.25;
    int heard = 0;
    for (int i = 0; i < 4000; ++i) heard += scene.sensing.somebody_within(0, lossy, 80) ? 1 : 0;
    EXPECT_NEAR(heard / 4000.0, 0.75, 5 * 0.433 / 63);
}

TEST(RangeAndBearing, NoiseHasItsDeviation) {
    Scene scene({{{0, 0}, 0}, {{30, 0}, 0}});
    RangeAndBearing noisy;
    noisy.noise = 2;
    double sum = 0, square = 0;
    for (int i = 0; i < 4000; ++i) {
        const double d = scene.sensing.range_and_bearing(0, noisy, 80).at(0).distance - 30;
        sum += d;
        square += d * d;
    }
    EXPECT_NEAR(sum / 4000, 0, 5 * 2.0 / 63);
    EXPECT_NEAR(std::sqrt(square / 4000), 2, 0.12);
}

TEST(LightRing, HalfOfItIsTurnedToAFarLight) {
    LightRing ring;
    ring.leak = 0;
    Scene scene({{{0, 0}, 0}});
    EXPECT_EQ(scene.sensing.lit_sensors(0, ring, {120, 0}), 4U);
    ring.leak = 1;
    EXPECT_EQ(scene.sensing.lit_sensors(0, ring, {120, 0}), 8U);
}

TEST(LightRing, LeaksAboutHalf) {
    Scene scene({{{0, 0}, 0}});
    double sum = 0;
    for (int i = 0; i < 2000; ++i) sum += scene.sensing.lit_sensors(0, {8, 0.5}, {120, 0});
    EXPECT_NEAR(sum / 2000, 6, 5 * 1.0 / 44) << "four turned to it, four at one half (deviation 1)";
}

TEST(LightRing, OthersThrowShadows) {
    LightRing ring;
    ring.leak = 0;
    // Three adjacent robots hide the light from the robot at the back.
    Scene scene({{{0, 0}, 0}, {{8, 0}, 0}, {{8, 7.4}, 0}, {{8, -7.4}, 0}});
    EXPECT_EQ(scene.sensing.lit_sensors(0, ring, {120, 0}), 0U);
    EXPECT_EQ(scene.sensing.lit_sensors(1, ring, {120, 0}), 4U);
}

TEST(Proximity, MeasuresFromTheBody) {
    Scene scene({{{0, 0}, -pi / 8}, {{12, 0}, 0}});  // the first sensor looks along the x axis
    EXPECT_NEAR(*scene.sensing.nearest_distance(0, {}), 12 - 2 * 3.7, 1e-9);
    EXPECT_FALSE(Scene({{{0, 0}, 0}}).sensing.nearest_distance(0, {}).has_value());
}

WorldOptions crowded(std::size_t cells_from) {
    WorldOptions options;
    options.arena.width = options.arena.height = 300;
    options.arena.walls.push_back({{-40, -60}, {70, 20}});
    options.cells_from = cells_from;
    return options;
}

/// The grid finds the same robots as a test of every robot.
TEST(SensingProperty, GridAndBruteForceAgree) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        World plain(crowded(1000000), seed), celled(crowded(0), seed);
        const std::size_t robots = 3 + 7 * seed;
        ASSERT_TRUE(plain.place_at_random(robots, {{-150, -150}, {150, 150}}));
        ASSERT_TRUE(celled.place_at_random(robots, {{-150, -150}, {150, 150}}));
        Sensing one(plain), two(celled);
        one.update_positions();
        two.update_positions();
        const LightRing no_leak{8, 0};
        for (std::size_t i = 0; i < robots; ++i) {
            ASSERT_EQ(one.line_of_sight(i, 0).what, two.line_of_sight(i, 0).what) << "seed " << seed << " robot " << i;
            ASSERT_EQ(one.line_of_sight(i, 0).distance, two.line_of_sight(i, 0).distance);
            ASSERT_EQ(one.nearest_distance(i, {}), two.nearest_distance(i, {}));
            ASSERT_EQ(one.lit_sensors(i, no_leak, {140, 100}), two.lit_sensors(i, no_leak, {140, 100}));
            const auto heard = one.range_and_bearing(i, {}, 80);
            const auto celled_heard = two.range_and_bearing(i, {}, 80);
            ASSERT_EQ(heard.size(), celled_heard.size());
            for (std::size_t k = 0; k < heard.size(); ++k) ASSERT_EQ(heard[k].robot, celled_heard[k].robot);
        }
    }
}

/// Compares the distance from a ray to a robot with samples of points along the ray.
TEST(SensingProperty, RayAgreesWithWalkingAlongIt) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        World world(crowded(40), seed);
        ASSERT_TRUE(world.place_at_random(30, {{-150, -150}, {150, 150}}));
        Sensing sensing(world);
        sensing.update_positions();
        for (std::size_t i = 0; i < world.size(); ++i) {
            const Sight sight = sensing.line_of_sight(i, 0);
            const double end = sight.what == Seen::robot ? sight.distance : 0;
            const Vector front = world.position(i) + 3.7 * world.direction(i);
            const auto inside = [&](double at) {
                const Vector point = front + at * world.direction(i);
                for (std::size_t j = 0; j < world.size(); ++j)
                    if (j != i && length(world.position(j) - point) < 3.7) return true;
                return false;
            };
            for (double at = 0; at < end - 1e-6; at += 0.25) ASSERT_FALSE(inside(at)) << seed << ' ' << i;
            if (sight.what == Seen::robot) {
                EXPECT_TRUE(inside(end + 1e-3) || sight.distance == 0) << "a graze is rarer than this";
            }
        }
    }
}

}  // namespace
}  // namespace robochart::simulation
