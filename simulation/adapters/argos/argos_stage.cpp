// SPDX-License-Identifier: Apache-2.0
// Implements the adapter for ARGoS; see argos_stage.hpp. ARGoS executes a step in the order of stage.hpp (act, physics,
// media, sense, control). Its controllers are empty: the trial reads their sensors and sets their wheels between two
// steps.
#include "simulation/adapters/argos/argos_stage.hpp"

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/math/ray3.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_light_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "simulation/scenario/read_scenario.hpp"
#include "simulation/scenario/rules.hpp"

namespace robochart::simulation {

namespace {

// The size of ARGoS' e-puck (plugins/robots/e-puck), in cm.
constexpr double body_radius = 3.5;
constexpr double axle = 5.3;
constexpr double eye_height = 5;

/// The controller of each robot in the experiment. The controller only gives access to the robot's sensors and
/// actuators.
class Hands final : public argos::CCI_Controller {
public:
    void Init(argos::TConfigurationNode&) override {
        wheels = GetActuator<argos::CCI_DifferentialSteeringActuator>("differential_steering");
        if (HasSensor("light")) light = GetSensor<argos::CCI_LightSensor>("light");
        if (!HasSensor("range_and_bearing")) return;
        radio = GetSensor<argos::CCI_RangeAndBearingSensor>("range_and_bearing");
        sender_ = GetActuator<argos::CCI_RangeAndBearingActuator>("range_and_bearing");
        speak();
    }
    void Reset() override { speak(); }

    argos::CCI_DifferentialSteeringActuator* wheels = nullptr;
    argos::CCI_LightSensor* light = nullptr;
    argos::CCI_RangeAndBearingSensor* radio = nullptr;

private:
    /// Sends a message, because a robot that has not sent a message is not heard.
    void speak() {
        if (sender_ != nullptr) sender_->SetData(0, 1);
    }

    argos::CCI_RangeAndBearingActuator* sender_ = nullptr;
};

argos::CCI_Controller* make_hands() {
    return new Hands;
}

struct Robot {
    argos::CEmbodiedEntity* body = nullptr;
    argos::CControllableEntity* control = nullptr;
    Hands* hands = nullptr;
};

argos::CVector3 point(Vector at, double height) {
    return {at.x / 100, at.y / 100, height / 100};
}

/// The only experiment of this process.
class Session {
public:
    /// Loads the experiment and returns the random number generator of the wheels, seeded; null if another experiment
    /// was loaded before.
    static argos::CRandom::CRNG* open(const std::string& experiment, std::uint32_t seed) {
        argos::CSimulator& simulator = argos::CSimulator::GetInstance();
        static Session session;
        join_logs();
        if (session.loaded_.empty()) {
            // ARGoS must not write to the command's output.
            argos::LOG.GetStream().rdbuf(nullptr);
            argos::LOG.DisableColoredOutput();
            argos::LOGERR.DisableColoredOutput();
            simulator.SetRandomSeed(seed);
            session.loaded_ = experiment;
            ticpp::Document document;
            document.Parse(experiment);
            simulator.Load(document);
            session.random_ = argos::CRandom::CreateRNG("argos");
        }
        if (session.loaded_ != experiment) return nullptr;
        simulator.Reset(seed);
        return session.random_;
    }

    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

private:
    /// Creates, before ARGoS itself, the objects that ARGoS needs at its end. So they are destroyed after ARGoS.
    Session() {
        argos::CSimulator::GetInstance();
        argos::CFactory<argos::CCI_Controller>::Register(argos_controller, "", "", "", "", "", make_hands);
    }
    /// Registers the calling thread with ARGoS' logs, which keep a buffer for each thread.
    static void join_logs() {
        thread_local const bool joined = [] {
            argos::LOG.AddThreadSafeBuffer();
            argos::LOGERR.AddThreadSafeBuffer();
            return true;
        }();
        static_cast<void>(joined);
    }
    ~Session() {
        if (!loaded_.empty()) argos::CSimulator::GetInstance().Destroy();
    }

    std::string loaded_;
    argos::CRandom::CRNG* random_ = nullptr;
};

class ArgosStage final : public Stage {
public:
    ArgosStage(const Scenario& scenario, const World& start, argos::CRandom::CRNG* random)
        : scenario_(scenario), simulator_(argos::CSimulator::GetInstance()), commands_(start.size()), random_(random) {
        const Arena& arena = scenario.world.arena;
        far_ = std::hypot(arena.width, arena.height) + 2 * body_radius;
        if (!arena.walled) far_ += 4 * scenario.world.body.max_wheel * scenario.duration;
        for (std::size_t i = 0; i < start.size(); ++i) robots_.push_back(find(i));
        for (std::size_t i = 0; i < start.size(); ++i) place(robots_[i], start.position(i), start.heading(i));
        // Updates the sensors once at the start, before the robots move.
        for (argos::CMedium* medium : simulator_.GetMedia()) medium->Update();
        for (const Robot& robot : robots_) robot.control->Sense();
    }

    [[nodiscard]] std::size_t size() const override { return robots_.size(); }
    [[nodiscard]] Pose pose(std::size_t robot) const override {
        const argos::SAnchor& anchor = robots_[robot].body->GetOriginAnchor();
        argos::CRadians z, y, x;
        anchor.Orientation.ToEulerAngles(z, y, x);
        return {{100 * anchor.Position.GetX(), 100 * anchor.Position.GetY()}, normal_angle(z.GetValue())};
    }

    void sense() override {}
    [[nodiscard]] Sight line_of_sight(std::size_t robot, const Sensor& sensor) override {
        return look(robot, pose(robot).heading, sensor.sight_range > 0 ? sensor.sight_range : far_);
    }
    [[nodiscard]] bool somebody_within(std::size_t robot, const Sensor&, double distance) override {
        const auto& heard = robots_[robot].hands->radio->GetReadings();
        return std::ranges::any_of(heard, [&](const auto& packet) { return packet.Range <= distance; });
    }
    [[nodiscard]] std::optional<double> direction_of_others(std::size_t robot, const Sensor&,
                                                            double distance) override {
        Vector sum;
        bool any = false;
        for (const auto& packet : robots_[robot].hands->radio->GetReadings()) {
            if (packet.Range > distance) continue;
            const double angle = packet.HorizontalBearing.GetValue();
            sum = sum + packet.Range * Vector{std::cos(angle), std::sin(angle)};
            any = true;
        }
        if (!any) return std::nullopt;
        return std::atan2(sum.y, sum.x);
    }
    [[nodiscard]] std::uint32_t lit_sensors(std::size_t robot, const Sensor&) override {
        const auto& readings = robots_[robot].hands->light->GetReadings();
        return static_cast<std::uint32_t>(std::ranges::count_if(readings, [](double reading) { return reading > 0; }));
    }
    [[nodiscard]] bool close_within(std::size_t robot, const Sensor& sensor, double distance) override {
        const double gap = 2 * std::numbers::pi / sensor.proximity.sensors;
        const double range = std::min(distance, sensor.proximity.range);
        for (std::uint32_t k = 0; k < sensor.proximity.sensors; ++k)
            if (look(robot, pose(robot).heading + (k + 0.5) * gap, range).what != Seen::nothing) return true;
        return false;
    }

    void set_wheels(std::size_t robot, Wheels wheels) override { commands_[robot] = wheels; }
    void advance() override {
        for (std::size_t i = 0; i < commands_.size(); ++i) drive(robots_[i], commands_[i]);
        simulator_.UpdateSpace();
    }

private:
    Robot find(std::size_t number) {
        auto& entity =
            dynamic_cast<argos::CEPuckEntity&>(simulator_.GetSpace().GetEntity(argos_robot + std::to_string(number)));
        Robot robot;
        robot.body = &entity.GetEmbodiedEntity();
        robot.control = &entity.GetControllableEntity();
        robot.hands = &dynamic_cast<Hands&>(robot.control->GetController());
        return robot;
    }

    static void place(const Robot& robot, Vector position, double heading) {
        argos::CQuaternion turn;
        turn.FromEulerAngles(argos::CRadians(heading), argos::CRadians(0), argos::CRadians(0));
        // At this time, later robots are still at their old places, so overlaps are ignored until all robots are
        // placed.
        robot.body->MoveTo(point(position, 0), turn, false, true);
    }

    /// Casts a ray. The ray starts at the centre, because the front edge of a robot may touch another robot. Distances
    /// are measured from the edge.
    [[nodiscard]] Sight look(std::size_t robot, double direction, double range) const {
        const Vector from = pose(robot).at;
        const double reach = range + body_radius;
        const Vector to = from + reach * Vector{std::cos(direction), std::sin(direction)};
        argos::SEmbodiedEntityIntersectionItem met;
        const argos::CRay3 ray(point(from, eye_height), point(to, eye_height));
        if (!argos::GetClosestEmbodiedEntityIntersectedByRay(met, ray, *robots_[robot].body)) return {};
        const bool other = met.IntersectedEntity->GetParent().GetTypeDescription() == "e-puck";
        return {other ? Seen::robot : Seen::wall, std::max(0.0, met.TOnRay * reach - body_radius)};
    }

    /// Sets the wheels so that ARGoS' robot moves with the speeds of the scenario's robot, although the distance of its
    /// wheels differs.
    void drive(const Robot& robot, Wheels wheels) {
        const Body& body = scenario_.world.body;
        const auto real = [&](double wheel) {
            const double noise =
                body.noise > 0 ? random_->Uniform(argos::CRange<argos::Real>(-body.noise, body.noise)) : 0;
            return std::clamp(wheel, -body.max_wheel, body.max_wheel) * (1 + noise);
        };
        const double left = real(wheels.left);
        const double right = real(wheels.right);
        const Wheels own = wheels_for((left + right) / 2, (right - left) / body.axle, axle);
        robot.hands->wheels->SetLinearVelocity(own.left, own.right);
    }

    const Scenario& scenario_;
    argos::CSimulator& simulator_;
    double far_ = 0;
    std::vector<Robot> robots_;
    std::vector<Wheels> commands_;
    argos::CRandom::CRNG* random_;
};

std::size_t count(const Scenario& scenario, SensorKind kind) {
    return static_cast<std::size_t>(
        std::ranges::count_if(scenario.sensors, [&](const Sensor& sensor) { return sensor.kind == kind; }));
}

void refuse_sensors(const Scenario& scenario, diagnostics::Diagnostics& diagnostics) {
    for (const Sensor& sensor : scenario.sensors) {
        const bool twice = (sensor.kind == SensorKind::light || sensor.kind == SensorKind::range_and_bearing) &&
                           count(scenario, sensor.kind) > 1;
        if (twice)
            diagnostics.report(rules::not_there, sensor.name.span,
                               {"ARGoS", "second sensor of the same kind as '" + sensor.name.text + "' on a robot"});
        if (sensor.kind == SensorKind::light && sensor.light_ring.sensors != 8)
            diagnostics.report(rules::not_there, sensor.name.span,
                               {"ARGoS", "rings of other than eight light sensors"});
    }
    if (count(scenario, SensorKind::light) > 0 && scenario.lights.size() > 1)
        diagnostics.report(rules::not_there, scenario.lights[1].name.span,
                           {"ARGoS", "light sensors that distinguish lights"});
}

bool refuse(const Scenario& scenario, diagnostics::Diagnostics& diagnostics) {
    refuse_sensors(scenario, diagnostics);
    if (std::abs(scenario.world.body.radius - body_radius) > 0.5)
        diagnostics.report(rules::not_there, scenario.name.span,
                           {"ARGoS", "e-pucks with a radius other than about 3.5 cm"});
    const double rate = 1 / scenario.world.control_step;
    if (std::abs(rate - std::round(rate)) > 1e-9)
        diagnostics.report(rules::not_there, scenario.name.span,
                           {"ARGoS", "control steps that do not divide a second"});
    refuse_beyond(scenario, "ARGoS", diagnostics);
    return !diagnostics.ok();
}

}  // namespace

std::unique_ptr<Stage> argos_stage(const Scenario& scenario, std::uint32_t trial,
                                   diagnostics::Diagnostics& diagnostics) {
    if (refuse(scenario, diagnostics)) return nullptr;
    const auto first = start(scenario, 0, diagnostics);
    const auto world = start(scenario, trial, diagnostics);
    if (!first || !world) return nullptr;
    const auto seed = static_cast<std::uint32_t>(scenario.seed + trial);
    argos::CRandom::CRNG* const random = Session::open(argos_experiment(scenario, *first), std::max(1U, seed));
    if (random == nullptr) {
        diagnostics.report(rules::not_there, scenario.name.span, {"ARGoS", "a second experiment in a process"});
        return nullptr;
    }
    return std::make_unique<ArgosStage>(scenario, *world, random);
}

}  // namespace robochart::simulation
