// SPDX-License-Identifier: Apache-2.0
// Compares rays, disks and walls with results computed by hand.
#include "simulation/world/geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace robochart::simulation {
namespace {

TEST(Geometry, RayMeetsDiskAheadAtItsNearSide) {
    EXPECT_DOUBLE_EQ(*hit_disk({0, 0}, {1, 0}, {10, 0}, 3), 7);
    // The triangle has the sides 3, 4 and 5: the ray passes the centre at distance 3, and half the chord is 4.
    EXPECT_DOUBLE_EQ(*hit_disk({0, 0}, {1, 0}, {10, 3}, 5), 6);
}

TEST(Geometry, RayMissesWhatIsBehindOrAside) {
    EXPECT_FALSE(hit_disk({0, 0}, {1, 0}, {-10, 0}, 3));
    EXPECT_FALSE(hit_disk({0, 0}, {1, 0}, {10, 3.001}, 3));
}

TEST(Geometry, TangentTouches) {
    EXPECT_DOUBLE_EQ(*hit_disk({0, 0}, {1, 0}, {10, 3}, 3), 10);
}

TEST(Geometry, RayFromInsideHitsAtOnce) {
    EXPECT_DOUBLE_EQ(*hit_disk({1, 0}, {0, 1}, {0, 0}, 3), 0);
}

TEST(Geometry, RayMeetsWallBetweenItsEndsOnly) {
    const Segment wall{{5, -1}, {5, 1}};
    EXPECT_DOUBLE_EQ(*hit_segment({0, 0}, {1, 0}, wall), 5);
    EXPECT_FALSE(hit_segment({0, 2}, {1, 0}, wall));
    EXPECT_FALSE(hit_segment({0, 0}, {-1, 0}, wall));
    EXPECT_FALSE(hit_segment({0, 0}, {0, 1}, wall)) << "parallel";
}

TEST(Geometry, NearestPointIsAFootOrAnEnd) {
    const Segment wall{{0, 0}, {10, 0}};
    EXPECT_EQ(nearest_point(wall, {4, 3}), (Vector{4, 0}));
    EXPECT_EQ(nearest_point(wall, {-4, 3}), (Vector{0, 0}));
    EXPECT_EQ(nearest_point({{2, 2}, {2, 2}}, {9, 9}), (Vector{2, 2})) << "a wall of no length";
}

TEST(Geometry, AnglesAreHalfOpenAtMinusPi) {
    constexpr double pi = std::numbers::pi;
    EXPECT_DOUBLE_EQ(normal_angle(3 * pi), pi);
    EXPECT_DOUBLE_EQ(normal_angle(-pi), pi);
    EXPECT_NEAR(normal_angle(7.5 * pi), -0.5 * pi, 1e-12);
    EXPECT_DOUBLE_EQ(normal_angle(0.25), 0.25);
}

}  // namespace
}  // namespace robochart::simulation
