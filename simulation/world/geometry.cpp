// SPDX-License-Identifier: Apache-2.0
#include "simulation/world/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace robochart::simulation {

double length(Vector a) {
    return std::sqrt(dot(a, a));
}

std::optional<double> hit_disk(Vector origin, Vector direction, Vector centre, double radius) {
    const Vector to = centre - origin;
    const double along = dot(to, direction);
    const double aside = cross(direction, to);
    const double rest = radius * radius - aside * aside;
    if (rest < 0) return std::nullopt;
    const double half = std::sqrt(rest);
    if (along + half < 0) return std::nullopt;
    return std::max(0.0, along - half);
}

std::optional<double> hit_segment(Vector origin, Vector direction, const Segment& wall) {
    const Vector run = wall.to - wall.from;
    const Vector to = wall.from - origin;
    const double slope = cross(direction, run);
    if (slope == 0) return std::nullopt;  // parallel: a wall has no thickness
    const double distance = cross(to, run) / slope;
    const double place = cross(to, direction) / slope;
    if (distance < 0 || place < 0 || place > 1) return std::nullopt;
    return distance;
}

Vector nearest_point(const Segment& wall, Vector point) {
    const Vector run = wall.to - wall.from;
    const double square = dot(run, run);
    if (square == 0) return wall.from;
    return wall.from + std::clamp(dot(point - wall.from, run) / square, 0.0, 1.0) * run;
}

double normal_angle(double angle) {
    constexpr double turn = 2 * std::numbers::pi;
    angle = std::fmod(angle, turn);
    if (angle > std::numbers::pi) return angle - turn;
    return angle <= -std::numbers::pi ? angle + turn : angle;
}

bool is_inside(const std::vector<Vector>& polygon, Vector at) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector a = polygon[i];
        const Vector b = polygon[(i + 1) % polygon.size()];
        if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

}  // namespace robochart::simulation
