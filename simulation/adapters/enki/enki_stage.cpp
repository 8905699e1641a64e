// SPDX-License-Identifier: Apache-2.0
// Implements the adapter for Enki; see enki_stage.hpp. The robots are stored in one array, because Enki iterates over
// them in the order of their addresses. So Enki draws its random numbers in the same order in every run.
#include "simulation/adapters/enki/enki_stage.hpp"

#include <enki/PhysicalEngine.h>
#include <enki/robots/e-puck/EPuck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "simulation/scenario/read_scenario.hpp"
#include "simulation/scenario/rules.hpp"

namespace robochart::simulation {

namespace {

constexpr double far_away = 1e6;

/// Finds the first object on a ray from the robot's front edge, among the objects and walls that Enki passes to it.
class EnkiRay final : public Enki::LocalInteraction {
public:
    EnkiRay(double range, Enki::Robot* robot) : Enki::LocalInteraction(range, robot) {}

    void init(double, Enki::World*) override { nearest_ = std::numeric_limits<double>::infinity(); }

    void objectStep(double, Enki::World*, Enki::PhysicalObject* object) override {
        const auto hit = hit_disk(origin(), direction(), {object->pos.x, object->pos.y}, object->getRadius());
        if (hit) nearest_ = std::min(nearest_, *hit);
    }

    [[nodiscard]] Sight nearest_sight(double range, double width, double height) const {
        const double wall = wall_distance(width, height);
        if (nearest_ < wall && nearest_ < range) return {Seen::robot, nearest_};
        return wall < range ? Sight{Seen::wall, wall} : Sight{Seen::nothing, 0};
    }

private:
    [[nodiscard]] Vector direction() const { return {std::cos(owner->angle), std::sin(owner->angle)}; }
    [[nodiscard]] Vector origin() const {
        return Vector{owner->pos.x, owner->pos.y} + owner->getRadius() * direction();
    }
    /// Returns the distance to a wall; infinite without walls (width 0).
    [[nodiscard]] double wall_distance(double width, double height) const {
        const Vector at = origin();
        const Vector way = direction();
        double best = std::numeric_limits<double>::infinity();
        if (width <= 0) return best;
        if (way.x != 0) best = std::min(best, ((way.x > 0 ? width : 0) - at.x) / way.x);
        if (way.y != 0) best = std::min(best, ((way.y > 0 ? height : 0) - at.y) / way.y);
        return std::max(0.0, best);
    }

    double nearest_ = std::numeric_limits<double>::infinity();
};

/// An e-puck whose wheels are set between Enki's steps.
class Puck final : public Enki::EPuck {
public:
    explicit Puck(const Scenario& scenario) : Enki::EPuck(CAPABILITY_NONE), ray(sensor_range(scenario), this) {
        const Body& body = scenario.world.body;
        distBetweenWheels = body.axle;
        maxSpeed = body.max_wheel;
        noiseAmount = body.noise;
        setCylindric(body.radius, 4.7, 152);
        addLocalInteraction(&ray);
    }

    /// Enki calls this after the sensors, but our controllers run outside of Enki.
    void controlStep(double) override {}
    void apply_speeds(double step) { Enki::EPuck::controlStep(step); }

    EnkiRay ray;

private:
    static double sensor_range(const Scenario& scenario) {
        for (const Sensor& sensor : scenario.sensors)
            if (sensor.sight_range > 0) return sensor.sight_range + 2 * scenario.world.body.radius;
        return far_away;
    }
};

/// Stores the robots in one array. The sensors contain pointers to their robots, so robots are constructed in place and
/// never moved.
class Pucks {
public:
    Pucks(std::size_t count, const Scenario& scenario) : pucks_(std::allocator<Puck>().allocate(count)), count_(count) {
        for (std::size_t i = 0; i < count; ++i) ::new (static_cast<void*>(pucks_ + i)) Puck(scenario);
    }
    ~Pucks() {
        std::destroy_n(pucks_, count_);
        std::allocator<Puck>().deallocate(pucks_, count_);
    }
    Pucks(const Pucks&) = delete;
    Pucks& operator=(const Pucks&) = delete;

    [[nodiscard]] Puck& operator[](std::size_t i) { return pucks_[i]; }
    [[nodiscard]] const Puck& operator[](std::size_t i) const { return pucks_[i]; }
    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] Puck* begin() { return pucks_; }
    [[nodiscard]] Puck* end() { return pucks_ + count_; }

private:
    Puck* pucks_;
    std::size_t count_;
};

class EnkiStage final : public Stage {
public:
    EnkiStage(const Scenario& scenario, const World& start, std::uint32_t trial)
        : scenario_(scenario),
          origin_{scenario.world.arena.width / 2, scenario.world.arena.height / 2},
          pucks_(start.size(), scenario),
          world_(scenario.world.arena.width, scenario.world.arena.height) {
        world_.takeObjectOwnership = false;
        world_.setRandomSeed(static_cast<unsigned long>(scenario.seed + trial));
        for (std::size_t i = 0; i < start.size(); ++i) {
            Puck& puck = pucks_[i];
            puck.pos = Enki::Point(start.position(i).x + origin_.x, start.position(i).y + origin_.y);
            puck.angle = start.heading(i);
            world_.addObject(&puck);
        }
        // Enki reads sensors at the end of a step. One step with the wheels stopped reads them at the start.
        world_.step(scenario.world.control_step, 1);
    }

    [[nodiscard]] std::size_t size() const override { return pucks_.size(); }
    [[nodiscard]] Pose pose(std::size_t robot) const override {
        const Puck& puck = pucks_[robot];
        return {{puck.pos.x - origin_.x, puck.pos.y - origin_.y}, normal_angle(puck.angle)};
    }

    void sense() override {}
    [[nodiscard]] Sight line_of_sight(std::size_t robot, const Sensor& sensor) override {
        const double range = sensor.sight_range > 0 ? sensor.sight_range : std::numeric_limits<double>::infinity();
        return pucks_[robot].ray.nearest_sight(range, world_.w, world_.h);
    }
    // Always false, because enki_stage rejects scenarios that need it.
    [[nodiscard]] bool somebody_within(std::size_t, const Sensor&, double) override { return false; }
    [[nodiscard]] std::optional<double> direction_of_others(std::size_t, const Sensor&, double) override {
        return std::nullopt;
    }
    [[nodiscard]] std::uint32_t lit_sensors(std::size_t, const Sensor&) override { return 0; }
    [[nodiscard]] bool close_within(std::size_t, const Sensor&, double) override { return false; }

    void set_wheels(std::size_t robot, Wheels wheels) override {
        pucks_[robot].leftSpeed = wheels.left;
        pucks_[robot].rightSpeed = wheels.right;
    }
    void advance() override {
        for (Puck& puck : pucks_) puck.apply_speeds(scenario_.world.control_step);
        world_.step(scenario_.world.control_step, scenario_.world.physics_steps);
    }

private:
    const Scenario& scenario_;
    Vector origin_;
    Pucks pucks_;
    Enki::World world_;  ///< last member: it is destroyed before its robots
};

bool refuse(const Scenario& scenario, diagnostics::Diagnostics& diagnostics) {
    for (const Sensor& sensor : scenario.sensors)
        if (sensor.kind != SensorKind::line_of_sight)
            diagnostics.report(rules::not_there, sensor.name.span,
                               {"Enki", "sensors of the kind of '" + sensor.name.text + "'"});
    const Arena& arena = scenario.world.arena;
    if (!arena.walls.empty() || !arena.walled)
        diagnostics.report(rules::not_there, scenario.name.span, {"Enki", "arenas other than a rectangle with walls"});
    refuse_beyond(scenario, "Enki", diagnostics);
    return !diagnostics.ok();
}

}  // namespace

std::unique_ptr<Stage> enki_stage(const Scenario& scenario, std::uint32_t trial,
                                  diagnostics::Diagnostics& diagnostics) {
    if (refuse(scenario, diagnostics)) return nullptr;
    const auto world = start(scenario, trial, diagnostics);
    if (!world) return nullptr;
    return std::make_unique<EnkiStage>(scenario, *world, trial);
}

}  // namespace robochart::simulation
