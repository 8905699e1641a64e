// SPDX-License-Identifier: Apache-2.0
// Implements the world's physics; see world.hpp.
#include "simulation/world/world.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace robochart::simulation {

namespace {

/// Lists of pairs contain robots up to this distance from contact, in cm. Two robots that approach at full speed need
/// about two control steps for it.
constexpr double margin = 6;
/// The largest displacement by pushes in one physics step that the pair list tolerates, in cm.
constexpr double slack = 1;

/// The positions of the robots placed so far, in squares as wide as a robot. The squares are only looked up by number.
class Places {
public:
    explicit Places(double radius) : reach_(2 * radius) {}

    void add_place(Vector at) { squares_[square_index(at.x, 0)][square_index(at.y, 0)].push_back(at); }

    [[nodiscard]] bool is_free(Vector at) const {
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j)
                if (touches(at, i, j)) return false;
        return true;
    }

private:
    [[nodiscard]] std::int64_t square_index(double along, int offset) const {
        return static_cast<std::int64_t>(std::floor(along / reach_)) + offset;
    }
    [[nodiscard]] bool touches(Vector at, int column, int row) const {
        const auto in_column = squares_.find(square_index(at.x, column));
        if (in_column == squares_.end()) return false;
        const auto in_row = in_column->second.find(square_index(at.y, row));
        if (in_row == in_column->second.end()) return false;
        return std::ranges::any_of(in_row->second,
                                   [&](Vector other) { return dot(other - at, other - at) < reach_ * reach_; });
    }

    double reach_;
    std::unordered_map<std::int64_t, std::unordered_map<std::int64_t, std::vector<Vector>>> squares_;
};

}  // namespace

Wheels wheels_for(double linear, double angular, double axle) {
    return {linear - angular * axle / 2, linear + angular * axle / 2};
}

World::World(WorldOptions options, std::uint64_t seed)
    : options_(std::move(options)),
      fixed_walls_(options_.arena.walls.size()),
      fixed_obstacles_(options_.arena.obstacles.size()),
      random_(seed),
      body_(options_.body) {}

void World::add_obstacle(std::vector<Vector> corners, bool there) {
    changing_.push_back({std::move(corners), there});
    build_obstacles();
}

void World::set_obstacle(std::size_t obstacle, bool there) {
    if (changing_.at(obstacle).there == there) return;
    changing_[obstacle].there = there;
    build_obstacles();
}

void World::build_obstacles() {
    Arena& arena = options_.arena;
    arena.walls.resize(fixed_walls_);
    arena.obstacles.resize(fixed_obstacles_);
    for (const Changing& obstacle : changing_) {
        if (!obstacle.there) continue;
        for (std::size_t i = 0; i < obstacle.corners.size(); ++i)
            arena.walls.push_back({obstacle.corners[i], obstacle.corners[(i + 1) % obstacle.corners.size()]});
        arena.obstacles.push_back(obstacle.corners);
    }
}

void World::add_robot(const Pose& pose) {
    x_.push_back(pose.at.x);
    y_.push_back(pose.at.y);
    heading_.push_back(normal_angle(pose.heading));
    cosine_.push_back(std::cos(pose.heading));
    sine_.push_back(std::sin(pose.heading));
    axle_.push_back(body_.axle);
    max_wheel_.push_back(body_.max_wheel);
    noise_.push_back(body_.noise);
    for (auto* zero : {&left_, &right_, &step_x_, &step_y_, &turn_cos_, &turn_sin_, &turn_}) zero->push_back(0);
    listed_x_.clear();
}

/// Finds positions for a robot that overlap no other robot, wall or obstacle.
class World::Free {
public:
    explicit Free(const World& world)
        : arena_(world.options_.arena), radius_(world.options_.body.radius), places_(radius_) {
        for (std::size_t i = 0; i < world.size(); ++i) places_.add_place(world.position(i));
    }
    void add_place(Vector at) { places_.add_place(at); }
    [[nodiscard]] bool is_free(Vector at) const {
        return places_.is_free(at) &&
               std::ranges::all_of(
                   arena_.walls,
                   [&](const Segment& wall) { return length(nearest_point(wall, at) - at) >= radius_; }) &&
               std::ranges::none_of(arena_.obstacles,
                                    [&](const std::vector<Vector>& obstacle) { return is_inside(obstacle, at); });
    }
    [[nodiscard]] bool in_arena(Vector at) const {
        return !arena_.walled ||
               (std::abs(at.x) <= arena_.width / 2 - radius_ && std::abs(at.y) <= arena_.height / 2 - radius_);
    }

private:
    const Arena& arena_;
    double radius_;
    Places places_;
};

namespace {

/// The number of consecutive random placements that may fail before the search ends.
constexpr int most_tries = 2000;

}  // namespace

bool World::place_at_random(std::size_t count, const Region& region) {
    const double radius = options_.body.radius;
    const Vector low = region.low + Vector{radius, radius};
    const Vector high = region.high - Vector{radius, radius};
    if (low.x > high.x || low.y > high.y) return count == 0;
    Free free(*this);
    int tries = 0;
    for (std::size_t placed = 0; placed < count;) {
        if (++tries > most_tries) return false;
        const double x = random_.uniform(low.x, high.x);
        const double y = random_.uniform(low.y, high.y);
        if (!free.is_free({x, y})) continue;
        free.add_place({x, y});
        add_robot({{x, y}, random_.uniform(-std::numbers::pi, std::numbers::pi)});
        ++placed;
        tries = 0;
    }
    return true;
}

bool World::place_linked(std::size_t count, Vector first, double link) {
    const double nearest = 2 * options_.body.radius;
    if (link < nearest) return false;
    Free free(*this);
    const std::size_t begin = size();
    int tries = 0;
    while (size() < begin + count) {
        if (++tries > most_tries) return false;
        Vector at = first;
        if (size() > begin) {
            const double ticket = random_.uniform() * static_cast<double>(size() - begin);
            const double angle = random_.uniform(-std::numbers::pi, std::numbers::pi);
            const double distance = random_.uniform(nearest, link);
            at = position(begin + static_cast<std::size_t>(ticket)) +
                 distance * Vector{std::cos(angle), std::sin(angle)};
        }
        if (!free.in_arena(at) || !free.is_free(at)) continue;
        free.add_place(at);
        add_robot({at, random_.uniform(-std::numbers::pi, std::numbers::pi)});
        tries = 0;
    }
    return true;
}

void World::set_wheels(std::size_t robot, Wheels wheels) {
    const double most = max_wheel_[robot];
    left_[robot] = std::clamp(wheels.left, -most, most);
    right_[robot] = std::clamp(wheels.right, -most, most);
}

void World::advance() {
    begin_step();
    for (std::uint32_t k = 0; k < options_.physics_steps; ++k) {
        move_robots();
        if (pairs_are_stale()) find_pairs();
        push_apart();
        push_out_of_walls();
    }
    end_step();
}

/// Computes the first displacement of a control step by the midpoint rule for unicycles: in a physics step of length h,
/// the robot moves v*h along the heading that it has after half of the step. The speeds are constant during a control
/// step, so each displacement is the previous one, rotated.
void World::begin_step() {
    const double h = options_.control_step / options_.physics_steps;
    for (std::size_t i = 0; i < size(); ++i) {
        const double noise = noise_[i];
        double left = left_[i];
        double right = right_[i];
        if (noise > 0) {
            left *= random_.uniform(1 - noise, 1 + noise);
            right *= random_.uniform(1 - noise, 1 + noise);
        }
        const double way = (left + right) / 2 * h;
        const double turn = (right - left) / axle_[i] * h;
        const double half_cos = std::cos(turn / 2);
        const double half_sin = std::sin(turn / 2);
        turn_[i] = turn * options_.physics_steps;
        turn_cos_[i] = half_cos * half_cos - half_sin * half_sin;
        turn_sin_[i] = 2 * half_cos * half_sin;
        step_x_[i] = way * (cosine_[i] * half_cos - sine_[i] * half_sin);
        step_y_[i] = way * (sine_[i] * half_cos + cosine_[i] * half_sin);
    }
}

void World::move_robots() {
    const std::size_t n = size();
    double* const x = x_.data();
    double* const y = y_.data();
    double* const step_x = step_x_.data();
    double* const step_y = step_y_.data();
    const double* const c = turn_cos_.data();
    const double* const s = turn_sin_.data();
    for (std::size_t i = 0; i < n; ++i) {
        const double way_x = step_x[i];
        const double way_y = step_y[i];
        x[i] += way_x;
        y[i] += way_y;
        step_x[i] = way_x * c[i] - way_y * s[i];
        step_y[i] = way_x * s[i] + way_y * c[i];
    }
}

/// True if the list of pairs must be renewed. It is valid (a Verlet list) while every robot is within half the margin
/// of its position when the pairs were listed.
bool World::pairs_are_stale() const {
    if (listed_x_.size() != size()) return true;
    double worst = 0;
    for (std::size_t i = 0; i < size(); ++i) {
        const double dx = x_[i] - listed_x_[i];
        const double dy = y_[i] - listed_y_[i];
        worst = std::max(worst, dx * dx + dy * dy);
    }
    constexpr double far = margin / 2 - slack;
    return worst > far * far;
}

void World::find_pairs() {
    listed_x_ = x_;
    listed_y_ = y_;
    pairs_.clear();
    const double reach = 2 * options_.body.radius + margin;
    if (size() >= options_.cells_from) return find_pairs_in_cells(reach);
    for (std::uint32_t i = 0; i < size(); ++i)
        for (std::uint32_t j = i + 1; j < size(); ++j) {
            const double dx = x_[i] - x_[j];
            const double dy = y_[i] - y_[j];
            if (dx * dx + dy * dy < reach * reach) pairs_.push_back({i, j});
        }
}

void World::find_pairs_in_cells(double reach) {
    cells_.sort_disks(x_, y_, reach);
    for (std::uint32_t i = 0; i < size(); ++i) {
        const Cells::Cell at = cells_.cell_of(position(i));
        const auto begin = static_cast<std::ptrdiff_t>(pairs_.size());
        for (std::int32_t row = at.row - 1; row <= at.row + 1; ++row)
            for (std::int32_t column = at.column - 1; column <= at.column + 1; ++column)
                for (const std::uint32_t j : cells_.disks_in({column, row})) {
                    const double dx = x_[i] - x_[j];
                    const double dy = y_[i] - y_[j];
                    if (j > i && dx * dx + dy * dy < reach * reach) pairs_.push_back({i, j});
                }
        std::sort(pairs_.begin() + begin, pairs_.end(), [](Pair a, Pair b) { return a.second < b.second; });
    }
}

void World::push_apart() {
    const double contact = 2 * options_.body.radius;
    for (const Pair pair : pairs_) {
        const double dx = x_[pair.second] - x_[pair.first];
        const double dy = y_[pair.second] - y_[pair.first];
        const double square = dx * dx + dy * dy;
        if (square >= contact * contact) continue;
        const double distance = std::sqrt(square);
        // Two robots at the same place move apart along the x axis.
        const double push_x = distance > 0 ? (contact / distance - 1) / 2 * dx : contact / 2;
        const double push_y = distance > 0 ? (contact / distance - 1) / 2 * dy : 0;
        x_[pair.first] -= push_x;
        y_[pair.first] -= push_y;
        x_[pair.second] += push_x;
        y_[pair.second] += push_y;
    }
}

void World::push_out_of_walls() {
    const Arena& arena = options_.arena;
    const double radius = options_.body.radius;
    for (const Segment& wall : arena.walls)
        for (std::size_t i = 0; i < size(); ++i) {
            const Vector away = position(i) - nearest_point(wall, position(i));
            const double distance = length(away);
            if (distance >= radius || distance == 0) continue;
            x_[i] += away.x / distance * (radius - distance);
            y_[i] += away.y / distance * (radius - distance);
        }
    if (!arena.walled) return;
    const double across = arena.width / 2 - radius;
    const double along = arena.height / 2 - radius;
    for (double& x : x_) x = std::min(std::max(x, -across), across);
    for (double& y : y_) y = std::min(std::max(y, -along), along);
}

void World::end_step() {
    ++steps_;
    for (std::size_t i = 0; i < size(); ++i) {
        heading_[i] += turn_[i];
        if (heading_[i] > std::numbers::pi || heading_[i] <= -std::numbers::pi) heading_[i] = normal_angle(heading_[i]);
        cosine_[i] = std::cos(heading_[i]);
        sine_[i] = std::sin(heading_[i]);
    }
}

double World::largest_overlap() const {
    const double radius = options_.body.radius;
    double worst = 0;
    for (std::size_t i = 0; i < size(); ++i) {
        for (std::size_t j = i + 1; j < size(); ++j)
            worst = std::max(worst, 2 * radius - length(position(i) - position(j)));
        for (const Segment& wall : options_.arena.walls)
            worst = std::max(worst, radius - length(position(i) - nearest_point(wall, position(i))));
        if (!options_.arena.walled) continue;
        worst = std::max(worst, std::abs(x_[i]) + radius - options_.arena.width / 2);
        worst = std::max(worst, std::abs(y_[i]) + radius - options_.arena.height / 2);
    }
    return worst;
}

}  // namespace robochart::simulation
