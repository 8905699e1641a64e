// SPDX-License-Identifier: Apache-2.0
// Simulates the built-in world: disks with differential drive in a plane with walls. The world is kinematic: a robot
// moves as its wheels turn. Overlapping disks are pushed apart by equal distances, and disks are pushed out of walls.
// The results depend only on the seed: the method that finds neighbours does not change a single bit of them. The data
// are stored as a structure of arrays.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "simulation/world/cells.hpp"
#include "simulation/world/geometry.hpp"
#include "simulation/world/random.hpp"

namespace robochart::simulation {

/// A rectangle around the origin, with or without outer walls, and the walls inside it.
struct Arena {
    double width = 250;
    double height = 250;
    bool walled = true;
    std::vector<Segment> walls;                  ///< including those of obstacles
    std::vector<std::vector<Vector>> obstacles;  ///< polygons as their corners, in order; no robot is placed in one
};

/// The robot's body. By default it is an e-puck as in Li et al. 2017, section 3 (with the radius that Enki uses).
struct Body {
    double radius = 3.7;      ///< cm
    double axle = 5.1;        ///< cm between the wheels
    double max_wheel = 12.8;  ///< cm/s, forward or backward
    double noise = 0;         ///< fraction of a wheel's speed; the noise is uniform and drawn for each control step
};

struct WorldOptions {
    Arena arena;
    Body body;
    double control_step = 0.1;         ///< s
    std::uint32_t physics_steps = 10;  ///< the number of physics steps in a control step
    /// With at least this number of robots, a grid of cells is used to find pairs. The results are the same.
    std::size_t cells_from = 40;
};

/// A rectangle in which robots are placed.
struct Region {
    Vector low, high;
};

/// The speeds of the wheels, cm/s.
struct Wheels {
    double left = 0;
    double right = 0;
};

/// Converts forward and turning speed (cm/s, rad/s, counter-clockwise positive) to wheel speeds.
[[nodiscard]] Wheels wheels_for(double linear, double angular, double axle);

class World {
public:
    World(WorldOptions options, std::uint64_t seed);

    /// Adds a polygon to the arena. `there` tells whether it is present. Polygons are numbered in the order in which
    /// they are added.
    void add_obstacle(std::vector<Vector> corners, bool there);
    /// Makes a polygon appear or vanish. Robots that touch its sides are pushed away; a robot deeper inside is trapped.
    void set_obstacle(std::size_t obstacle, bool there);

    /// Sets the axle, the wheels and their noise for robots that are placed from now on. The radius is the same for all
    /// robots.
    void set_body(const Body& body) { body_ = body; }
    /// Places a robot; overlaps are resolved over time.
    void add_robot(const Pose&);
    /// Places robots at random in a region, without overlap, with random headings. Returns false if no free place was
    /// found.
    [[nodiscard]] bool place_at_random(std::size_t count, const Region&);

    /// Places the first robot at this point with a random heading. Each further robot is placed relative to a random
    /// earlier one: in a random direction, at a uniformly random distance from a diameter up to `link` between centres.
    /// Robots do not overlap, and are in the arena if it has walls. Returns false if no free place was found, or if
    /// `link` is less than a diameter.
    [[nodiscard]] bool place_linked(std::size_t count, Vector first, double link);

    [[nodiscard]] std::size_t size() const { return x_.size(); }
    [[nodiscard]] Vector position(std::size_t robot) const { return {x_[robot], y_[robot]}; }
    [[nodiscard]] double heading(std::size_t robot) const { return heading_[robot]; }
    /// Returns the unit vector along the heading.
    [[nodiscard]] Vector direction(std::size_t robot) const { return {cosine_[robot], sine_[robot]}; }
    [[nodiscard]] std::span<const double> x() const { return x_; }
    [[nodiscard]] std::span<const double> y() const { return y_; }
    [[nodiscard]] const WorldOptions& options() const { return options_; }
    [[nodiscard]] Random& random() { return random_; }
    [[nodiscard]] double time() const { return static_cast<double>(steps_) * options_.control_step; }

    /// Sets the speeds from the next control step on, limited to the wheels' maximum.
    void set_wheels(std::size_t robot, Wheels);
    /// Simulates one control step.
    void advance();
    /// Returns the largest overlap of two robots, or of a robot and a wall. For tests.
    [[nodiscard]] double largest_overlap() const;

private:
    class Free;
    void begin_step();
    void move_robots();
    void push_apart();
    void push_out_of_walls();
    void end_step();
    void build_obstacles();
    [[nodiscard]] bool pairs_are_stale() const;
    void find_pairs();
    void find_pairs_in_cells(double reach);

    struct Pair {
        std::uint32_t first;
        std::uint32_t second;
    };

    /// A polygon that appears and vanishes.
    struct Changing {
        std::vector<Vector> corners;
        bool there = true;
    };

    WorldOptions options_;
    std::size_t fixed_walls_ = 0, fixed_obstacles_ = 0;  ///< numbers of permanent walls and obstacles, which come first
    std::vector<Changing> changing_;
    Random random_;
    std::uint64_t steps_ = 0;
    std::vector<double> x_, y_, heading_, cosine_, sine_;
    Body body_;                                       ///< the body of the next robot to be placed
    std::vector<double> axle_, max_wheel_, noise_;    ///< values of each robot
    std::vector<double> left_, right_;                ///< requested wheel speeds
    std::vector<double> step_x_, step_y_;             ///< displacement of the next physics step
    std::vector<double> turn_cos_, turn_sin_, turn_;  ///< rotation in a physics step; angle in a control step
    std::vector<double> listed_x_, listed_y_;         ///< positions when the pairs were listed
    std::vector<Pair> pairs_;                         ///< pairs that may touch before the next update, ascending
    Cells cells_;
};

}  // namespace robochart::simulation
