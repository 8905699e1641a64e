// SPDX-License-Identifier: Apache-2.0
// Implements the sensors; see sensing.hpp. Rays are cast exactly. If there are few disks, a ray is tested against every
// disk, otherwise against those along its cells of a grid. The results are the same.
#include "simulation/world/sensing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace robochart::simulation {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

}  // namespace

void Sensing::silence(std::size_t robot) {
    silent_.resize(world_.size());
    silent_.at(robot) = true;
}

void Sensing::update_positions() {
    indexed_ = world_.size() >= world_.options().cells_from;
    if (!indexed_) return;
    const double robots = static_cast<double>(world_.size());
    const Arena& arena = world_.options().arena;
    // With this size, there is about one robot per cell if robots are spread out. So a ray passes few cells and tests
    // few robots.
    const double size = std::sqrt(arena.width * arena.height / robots) / 2;
    cells_.sort_disks(world_.x(), world_.y(), std::max(2 * world_.options().body.radius, size));
}

/// Returns the distance along the ray to the first disk, or infinity if there is none. `self` and `other` are ignored.
double Sensing::first_disk(Vector origin, Vector direction, double range, std::uint32_t self,
                           std::uint32_t other) const {
    if (indexed_) return first_disk_in_cells(origin, direction, range, self, other);
    const double* const x = world_.x().data();
    const double* const y = world_.y().data();
    const double radius = world_.options().body.radius;
    const double square = radius * radius;
    double best = range;
    for (std::uint32_t j = 0; j < world_.size(); ++j) {
        const double dx = x[j] - origin.x;
        const double dy = y[j] - origin.y;
        const double aside = direction.x * dy - direction.y * dx;
        if (aside * aside > square || dx * direction.x + dy * direction.y + radius < 0) continue;
        if (j == self || j == other) continue;
        if (const auto hit = hit_disk(origin, direction, {x[j], y[j]}, radius)) best = std::min(best, *hit);
    }
    return best < range ? best : unlimited;
}

/// Follows the ray in steps of a cell's width. For each step, it tests every cell whose disks the ray can reach before
/// the next step. These cells are the adjacent ones, because a cell is at least two radii wide.
double Sensing::first_disk_in_cells(Vector origin, Vector direction, double range, std::uint32_t self,
                                    std::uint32_t other) const {
    const double radius = world_.options().body.radius;
    const double width = cells_.size();
    const Vector low = cells_.corner() - Vector{radius, radius};
    const Vector high = cells_.far_corner() + Vector{radius, radius};
    // The part of the ray in the bounding box of all disks (slab method).
    double enter = 0;
    double leave = range;
    const auto slab = [&](double at, double way, double from, double to) {
        if (way == 0) {
            if (at < from || at > to) leave = -1;
            return;
        }
        const double a = (from - at) / way;
        const double b = (to - at) / way;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    };
    slab(origin.x, direction.x, low.x, high.x);
    slab(origin.y, direction.y, low.y, high.y);
    double best = range;
    for (double at = enter; at <= leave && at < best; at += width) {
        const Vector a = origin + at * direction;
        const Vector b = origin + std::min(at + width, leave) * direction;
        const Cells::Cell first = cells_.cell_of({std::min(a.x, b.x) - radius, std::min(a.y, b.y) - radius});
        const Cells::Cell last = cells_.cell_of({std::max(a.x, b.x) + radius, std::max(a.y, b.y) + radius});
        for (std::int32_t row = first.row; row <= last.row; ++row)
            for (std::int32_t column = first.column; column <= last.column; ++column)
                for (const std::uint32_t j : cells_.disks_in({column, row})) {
                    if (j == self || j == other) continue;
                    if (const auto hit = hit_disk(origin, direction, world_.position(j), radius))
                        best = std::min(best, *hit);
                }
    }
    return best < range ? best : unlimited;
}

double Sensing::first_wall(Vector origin, Vector direction, double range) const {
    const Arena& arena = world_.options().arena;
    double best = unlimited;
    for (const Segment& wall : arena.walls)
        if (const auto hit = hit_segment(origin, direction, wall)) best = std::min(best, *hit);
    if (arena.walled) {
        if (direction.x != 0)
            best = std::min(best, (std::copysign(arena.width / 2, direction.x) - origin.x) / direction.x);
        if (direction.y != 0)
            best = std::min(best, (std::copysign(arena.height / 2, direction.y) - origin.y) / direction.y);
    }
    return best < range ? std::max(0.0, best) : unlimited;
}

Sight Sensing::cast_ray(Vector origin, Vector direction, double range, std::uint32_t self) const {
    const double wall = first_wall(origin, direction, range);
    const double disk = first_disk(origin, direction, std::min(range, wall), self, nobody);
    if (disk < unlimited) return {Seen::robot, disk};
    if (wall < unlimited) return {Seen::wall, wall};
    return {Seen::nothing, 0};
}

Sight Sensing::line_of_sight(std::size_t robot, double range) const {
    const Vector direction = world_.direction(robot);
    const Vector front = world_.position(robot) + world_.options().body.radius * direction;
    return cast_ray(front, direction, range > 0 ? range : unlimited, static_cast<std::uint32_t>(robot));
}

bool Sensing::is_hidden(Vector from, Vector to, std::uint32_t self, std::uint32_t other) const {
    const Vector way = to - from;
    const double distance = length(way);
    if (distance == 0) return false;
    const Vector direction = (1 / distance) * way;
    return first_disk(from, direction, distance, self, other) < unlimited ||
           first_wall(from, direction, distance) < unlimited;
}

void Sensing::find_neighbours(std::size_t robot, double reach) {
    near_.clear();
    if (is_silent(robot)) return;
    if (!indexed_) {
        for (std::uint32_t j = 0; j < world_.size(); ++j)
            if (j != robot && !is_silent(j)) near_.push_back(j);
        return;
    }
    const Vector at = world_.position(robot);
    const Cells::Cell first = cells_.cell_of(at - Vector{reach, reach});
    const Cells::Cell last = cells_.cell_of(at + Vector{reach, reach});
    for (std::int32_t row = first.row; row <= last.row; ++row)
        for (std::int32_t column = first.column; column <= last.column; ++column)
            for (const std::uint32_t j : cells_.disks_in({column, row}))
                if (j != robot && !is_silent(j)) near_.push_back(j);
    std::ranges::sort(near_);
}

/// Returns the bearing of a robot whose message arrives: a robot in range that is not hidden, unless the message is
/// lost. The distance is noisy.
std::optional<Bearing> Sensing::hear_robot(std::uint32_t robot, std::uint32_t other, const RangeAndBearing& sensor,
                                           double within) {
    const Vector way = world_.position(other) - world_.position(robot);
    const double square = dot(way, way);
    const double reach = std::min(sensor.range, within + 6 * sensor.noise);  // normal() is at most 6
    if (square > reach * reach) return std::nullopt;
    if (sensor.occlusion && is_hidden(world_.position(robot), world_.position(other), robot, other))
        return std::nullopt;
    if (world_.random().draw_chance(sensor.loss)) return std::nullopt;
    double distance = std::sqrt(square);
    if (sensor.noise > 0) distance = std::max(0.0, distance + sensor.noise * world_.random().normal());
    if (distance > within) return std::nullopt;
    return Bearing{other, distance, normal_angle(std::atan2(way.y, way.x) - world_.heading(robot))};
}

const std::vector<Bearing>& Sensing::range_and_bearing(std::size_t robot, const RangeAndBearing& sensor,
                                                       double within) {
    heard_.clear();
    find_neighbours(robot, std::min(sensor.range, within + 6 * sensor.noise));
    for (const std::uint32_t other : near_)
        if (const auto bearing = hear_robot(static_cast<std::uint32_t>(robot), other, sensor, within))
            heard_.push_back(*bearing);
    return heard_;
}

bool Sensing::somebody_within(std::size_t robot, const RangeAndBearing& sensor, double within) {
    find_neighbours(robot, std::min(sensor.range, within + 6 * sensor.noise));
    return std::ranges::any_of(near_, [&](std::uint32_t other) {
        return hear_robot(static_cast<std::uint32_t>(robot), other, sensor, within).has_value();
    });
}

std::uint32_t Sensing::lit_sensors(std::size_t robot, const LightRing& ring, Vector light) {
    const Vector centre = world_.position(robot);
    const double gap = 2 * std::numbers::pi / ring.sensors;
    std::uint32_t lit = 0;
    for (std::uint32_t k = 0; k < ring.sensors; ++k) {
        const double angle = world_.heading(robot) + (k + 0.5) * gap;
        const Vector outward{std::cos(angle), std::sin(angle)};
        const Vector at = centre + world_.options().body.radius * outward;
        const bool facing = dot(outward, light - at) > 0;
        if (!facing && !world_.random().draw_chance(ring.leak)) continue;
        if (!is_hidden(at, light, static_cast<std::uint32_t>(robot), nobody)) ++lit;
    }
    return lit;
}

std::optional<double> Sensing::nearest_distance(std::size_t robot, const ProximityRing& ring) const {
    const double gap = 2 * std::numbers::pi / ring.sensors;
    double best = unlimited;
    for (std::uint32_t k = 0; k < ring.sensors; ++k) {
        const double angle = world_.heading(robot) + (k + 0.5) * gap;
        const Vector outward{std::cos(angle), std::sin(angle)};
        const Vector at = world_.position(robot) + world_.options().body.radius * outward;
        const Sight sight = cast_ray(at, outward, ring.range, static_cast<std::uint32_t>(robot));
        if (sight.what != Seen::nothing) best = std::min(best, sight.distance);
    }
    if (best == unlimited) return std::nullopt;
    return best;
}

}  // namespace robochart::simulation
