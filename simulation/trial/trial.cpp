// SPDX-License-Identifier: Apache-2.0
// Runs the cycles of a trial: sense, run the controllers, act, simulate one control step; see trial.hpp.
#include "simulation/trial/trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/diagnostics/splitmix64.hpp"
#include "simulation/world/random.hpp"

namespace robochart::simulation {

namespace {

/// A turn that a robot makes by dead reckoning, with the radians that remain.
struct Turn {
    double left = 0;
    double rate = 0;
};

/// The course that a robot follows step by step: it wanders, or seeks a light.
struct Course {
    const Drive* drive = nullptr;  ///< null: no course
    double rate = 0;               ///< wander: turning rate of the current second, rad/s
};

/// The greatest turning rate of a wandering robot, in rad/s, and the turning rate of a seeking robot for each radian of
/// deviation.
constexpr double wandering = 1.5;
constexpr double seeking = 4;

/// The failed parts of a robot.
struct Failed {
    bool whole = false;
    bool motors = false;
    bool sensors = false;
};

/// The time at which a part of a robot fails.
struct Failing {
    std::uint64_t step = 0;
    std::size_t robot = 0;
    FailureKind kind = FailureKind::whole;
};

const char* cause_of(rc_drive_result result) {
    switch (result) {
        case RC_DRIVE_STEP_BOUND:
            return "it did not end its cycle within its bound of steps";
        case RC_DRIVE_PRECONDITION:
            return "it called an operation outside its precondition";
        case RC_DRIVE_DEADLINE:
            return "it missed a deadline";
        default:
            return "it did more in one cycle than can be recorded";
    }
}

constexpr const char* no_finite_number = "it commanded a movement by a number that is not finite";

/// A light that a trial moves and switches: its position, and the time from which the position is valid.
struct MovingLight {
    Light light;
    double since = 0;  ///< the time of this position, in s
    bool on = true;

    [[nodiscard]] Vector position_at(double time) const { return light.position_at(time - since); }
};

/// Returns the seed of a controller array. The first kind uses the trial's own seed.
std::uint64_t seed_of(std::uint64_t seed, std::size_t number) {
    return number == 0 ? seed : diagnostics::splitmix64_mixed(seed ^ (std::uint64_t{number} << 48U));
}

}  // namespace

double Trace::kept_share(std::size_t /*measure*/) const {
    return std::numeric_limits<double>::quiet_NaN();
}

std::string Stop::owner_text() const {
    return environment ? "the environment" : "robot " + std::to_string(robot);
}

class Trial::Cycles {
public:
    Cycles(const Plan& plan, const Drives& drives, Stage& stage, const TrialOptions& options)
        : plan_(plan),
          scenario_(*plan.scenario),
          drives_(drives),
          states_(drives_),
          stage_(stage),
          options_(options),
          signals_(plan.inputs + 1),
          requests_(stage.size()),
          turns_(stage.size()),
          courses_(stage.size()),
          failed_(stage.size()),
          draws_(~options.seed),
          sights_(scenario_.sensors.size()),
          raised_(scenario_.kind_count()),
          statistics_(scenario_) {
        bool can_fail = scenario_.environment.has_value();
        for (std::size_t kind = 0; kind < scenario_.kind_count(); ++kind) {
            const RobotKind& robots = scenario_.kind_at(kind);
            const std::size_t first = kind_of_.size();
            controllers_.emplace_back(*drives_.kinds.at(kind), robots.robots, seed_of(options.seed, kind));
            first_robot_.push_back(first);
            axles_.push_back(scenario_.body_of(kind).axle);
            const Plan& bound = plan_.of_kind(kind);
            for (std::size_t robot = 0; robot < robots.robots; ++robot) {
                kind_of_.push_back(kind);
                first_variable_.push_back(variables_.size());
                variables_.insert(variables_.end(), bound.variables.begin(), bound.variables.end());
            }
            signals_.resize(std::max<std::size_t>(signals_.size(), bound.inputs + 1));
            for (const Failure& failure : robots.failures) plan_failure(failure, first, robots.robots);
            can_fail = can_fail || !robots.failures.empty();
        }
        if (can_fail) working_.assign(stage.size(), true);
        for (const Light& light : scenario_.lights) lights_.push_back({light, 0, true});
        for (const Obstacle& obstacle : scenario_.obstacles) obstacles_.push_back(obstacle.there);
        if (plan_.environment) begin_environment();
        for (const Claim& claim : scenario_.claims)
            properties_.emplace_back(claim.property, scenario_.world.control_step, scenario_.step_count());
    }

    bool run(std::uint64_t steps) {
        if (result_.steps == 0) begin();
        for (; steps > 0 && is_running(); --steps) run_step();
        return is_running();
    }

    TrialResult result() {
        result_.complete = !result_.stop && (result_.steps == scenario_.step_count() || all_answered());
        result_.statistics = statistics_.band_values();
        for (std::size_t c = 0; c < properties_.size(); ++c) {
            if (result_.stop) properties_[c].end(result_.steps, !scenario_.claims[c].at_least);
            result_.answers.push_back(properties_[c].answer());
        }
        return std::move(result_);
    }

private:
    [[nodiscard]] double time() const { return static_cast<double>(result_.steps) * scenario_.world.control_step; }
    [[nodiscard]] bool is_interrupted() const {
        return options_.interrupted != nullptr && options_.interrupted->load(std::memory_order_relaxed);
    }

    [[nodiscard]] bool is_running() const {
        return result_.steps < scenario_.step_count() && !result_.stop && !all_answered() && !is_interrupted();
    }
    /// True if all awaited answers are known.
    [[nodiscard]] bool all_answered() const {
        if (options_.awaited == nullptr) return false;
        for (std::size_t c = 0; c < properties_.size(); ++c)
            if ((*options_.awaited)[c] && !properties_[c].answer().holds) return false;
        return true;
    }

    void run_step() {
        stage_.set_lights(lights_now());
        stage_.sense();
        sent_ = variables_;
        const Frame sensed = plan_.environment ? frame_now(states_are_measured()) : Frame{};
        for (std::size_t robot = 0; robot < stage_.size() && !result_.stop; ++robot)
            if (!failed_[robot].whole) run_cycle(robot);
        for (auto& raised : raised_) raised.clear();
        if (!result_.stop && plan_.environment) environment_cycle(sensed);
        if (result_.stop) return;
        stage_.advance();
        ++result_.steps;
        if (options_.steps_done != nullptr) options_.steps_done->fetch_add(1, std::memory_order_relaxed);
        apply_failure();
        observe_world();
    }

    void begin() {
        apply_failure();
        observe_world();
    }

    /// Runs one cycle of a robot: reads its inputs, runs its controller, applies its effects.
    void run_cycle(std::size_t robot) {
        for (rc_signal& signal : signals_) signal.present = 0;
        for (auto& sight : sights_) sight.reset();
        const Plan& bound = plan_of(robot);
        for (const BoundFeed& feed : bound.feeds) fill_input(robot, feed);
        for (const BoundStimulus& stimulus : bound.stimuli) fill_input(stimulus);
        for (const BoundStimulus& stimulus : raised_[kind_of_[robot]]) raise_input(stimulus);
        requests_[robot] = 0;
        const rc_drive_result result = drive_of(robot).step(controller_of(robot), signals_.data(), &actions_);
        if (options_.trace != nullptr)
            options_.trace->observe_cycle(robot, result_.steps, signals_.data(), actions_, result);
        if (result > RC_DRIVE_TERMINATED || actions_.overflow != 0) return stop_trial(robot, cause_of(result));
        const Objection* const objection = options_.trace == nullptr ? nullptr : options_.trace->current_objection();
        if (objection != nullptr) {
            result_.stop = Stop{robot, time(), objection->cause, objection->place};
            return;
        }
        for (std::uint32_t a = 0; a < actions_.count && !result_.stop; ++a) apply_action(robot, actions_.action[a]);
        if (!result_.stop) continue_motion(robot);
    }

    void stop_trial(std::size_t robot, const char* cause) {
        result_.stop = Stop{robot, time(), cause, drive_of(robot).place_of(controller_of(robot))};
    }

    // ------------------------------------------------------------ kinds of robots

    [[nodiscard]] const Plan& plan_of(std::size_t robot) const { return plan_.of_kind(kind_of_[robot]); }
    [[nodiscard]] const rc_drive& drive_of(std::size_t robot) const { return *drives_.kinds[kind_of_[robot]]; }
    [[nodiscard]] double axle_of(std::size_t robot) const { return axles_[kind_of_[robot]]; }
    [[nodiscard]] void* controller_of(std::size_t robot) {
        const std::size_t kind = kind_of_[robot];
        return controllers_[kind][robot - first_robot_[kind]];
    }

    // ------------------------------------------------------------ the environment

    void begin_environment() {
        environment_.emplace(*drives_.environment, 1, seed_of(options_.seed, scenario_.kind_count()));
        signals_.resize(std::max<std::size_t>(signals_.size(), plan_.environment->inputs + 1));
        for (const WorldFeed& feed : scenario_.environment->feeds)
            conditions_.push_back(
                feed.condition ? std::optional<Condition>(std::in_place, *feed.condition, scenario_.world.control_step)
                               : std::nullopt);
    }

    /// Runs the environment's controller after those of all robots. It reads the world and the states at the time when
    /// the robots sensed. Its effects apply from the next cycle on.
    void environment_cycle(const Frame& sensed) {
        for (rc_signal& signal : signals_) signal.present = 0;
        const MeasureNow now = measures_now(scenario_, sensed);
        for (const BoundWorldFeed& feed : plan_.environment->feeds) fill_input(feed, now);
        void* const controller = (*environment_)[0];
        const rc_drive_result result = drives_.environment->step(controller, signals_.data(), &actions_);
        if (result > RC_DRIVE_TERMINATED || actions_.overflow != 0) return stop_environment(cause_of(result));
        for (std::uint32_t a = 0; a < actions_.count && !result_.stop; ++a)
            for (const BoundAct& act : plan_.environment->acts[actions_.action[a].output])
                change_world(act, actions_.action[a]);
    }

    void stop_environment(const char* cause) {
        result_.stop = Stop{stage_.size(), time(), cause, drives_.environment->place_of((*environment_)[0]), true};
    }

    void fill_input(const BoundWorldFeed& bound, const MeasureNow& now) {
        rc_signal& signal = signals_[bound.input];
        if (!bound.feed->condition) {
            signal.present = 1;
            signal.value.real = now(bound.feed->measure) / bound.feed->factor;
            return;
        }
        const bool holds = conditions_[bound.number]->holds_after(result_.steps, now);
        signal.present = bound.boolean || holds ? 1 : 0;
        signal.value.whole = holds ? 1 : 0;
    }

    void change_world(const BoundAct& bound, const rc_action& action) {
        const WorldAct& act = *bound.act;
        switch (act.kind) {
            case WorldAct::Kind::light_on:
            case WorldAct::Kind::light_off:
                lights_[act.what].on = act.kind == WorldAct::Kind::light_on;
                return;
            case WorldAct::Kind::light_move: {
                const Vector to =
                    act.to.value_or(act.factor * Vector{action.argument[0].real, action.argument[1].real});
                if (!std::isfinite(to.x) || !std::isfinite(to.y)) return stop_environment(no_finite_number);
                return move_light(lights_[act.what], act, to);
            }
            case WorldAct::Kind::obstacle_appear:
            case WorldAct::Kind::obstacle_vanish:
                obstacles_[act.what] = act.kind == WorldAct::Kind::obstacle_appear;
                return stage_.set_obstacle(act.what, obstacles_[act.what]);
            case WorldAct::Kind::failure:
                return fail_some(act.failure);
            case WorldAct::Kind::stimulus:
                for (std::size_t kind = 0; kind < bound.raised.size(); ++kind)
                    if (bound.raised[kind]) raise_in(kind, *bound.raised[kind], action);
        }
    }

    void move_light(MovingLight& moving, const WorldAct& act, Vector to) {
        moving.light.at = moving.position_at(time());
        moving.light.to = to;
        moving.light.speed = act.speed;
        moving.since = time();
    }

    void raise_in(std::size_t kind, BoundStimulus stimulus, const rc_action& action) {
        if (stimulus.argument)
            stimulus.value = stimulus.real ? action.argument[0].real : static_cast<double>(action.argument[0].whole);
        raised_[kind].push_back(stimulus);
    }

    /// Lets working robots fail. They are chosen at random with equal probability: the given number, or all of them if
    /// there are fewer.
    void fail_some(const Failure& failure) {
        std::vector<std::size_t> working;
        for (std::size_t robot = 0; robot < stage_.size(); ++robot)
            if (working_[robot]) working.push_back(robot);
        for (std::uint32_t n = 0; n < failure.robots && !working.empty(); ++n) {
            const auto which = static_cast<std::ptrdiff_t>(draws_.uniform() * static_cast<double>(working.size()));
            apply_failure(working[static_cast<std::size_t>(which)], failure.kind);
            working.erase(working.begin() + which);
        }
    }

    [[nodiscard]] std::vector<LightNow> lights_now() const {
        std::vector<LightNow> now;
        for (const MovingLight& light : lights_) now.push_back({light.position_at(time()), light.on});
        return now;
    }

    // ------------------------------------------------------------ failures

    /// Plans a failure, which occurs at the first instant at or after its time.
    void plan_failure(const Failure& failure, std::size_t first, std::size_t most) {
        const double step = scenario_.world.control_step;
        const std::size_t count = failure.mean_time > 0 ? most : std::min<std::size_t>(most, failure.robots);
        for (std::size_t robot = first; robot < first + count; ++robot) {
            const double at = failure.mean_time > 0 ? -failure.mean_time * std::log1p(-draws_.uniform()) : failure.at;
            if (at <= scenario_.duration)
                failing_.push_back({static_cast<std::uint64_t>(std::ceil(at / step - 1e-9)), robot, failure.kind});
        }
    }

    void apply_failure() {
        for (const Failing& failing : failing_)
            if (failing.step == result_.steps) apply_failure(failing.robot, failing.kind);
    }

    void apply_failure(std::size_t robot, FailureKind kind) {
        const bool whole = kind == FailureKind::whole;
        Failed& failed = failed_[robot];
        failed.whole = failed.whole || whole;
        failed.sensors = failed.sensors || whole || kind == FailureKind::sensors;
        if (whole || kind == FailureKind::radio) stage_.silence(robot);
        if (whole || kind == FailureKind::motors) {
            failed.motors = true;
            set_wheels(robot, {});
        }
        working_[robot] = false;
    }

    /// Sets the wheels. The wheels of a robot with failed motors stand still. A speed that is not finite stops the
    /// trial, because the world cannot compute with it.
    void set_wheels(std::size_t robot, Wheels wheels) {
        if (!std::isfinite(wheels.left) || !std::isfinite(wheels.right)) return stop_trial(robot, no_finite_number);
        stage_.set_wheels(robot, failed_[robot].motors ? Wheels{} : wheels);
    }

    // ------------------------------------------------------------ sensing

    /// True if a failed sensor prevents a reading: it reports no event, false or 0. A failed radio is handled
    /// separately.
    [[nodiscard]] bool is_blind(std::size_t robot, const BoundFeed& bound) const {
        return failed_[robot].sensors && bound.sensor != no_slot &&
               sensor_of_feed(bound).kind != SensorKind::range_and_bearing;
    }

    void fill_blind(const BoundFeed& bound) {
        rc_signal& signal = signals_[bound.input];
        signal.present = bound.feed->carries == Carries::boolean || bound.feed->carries == Carries::real ? 1 : 0;
        signal.value = {};
    }

    void fill_input(std::size_t robot, const BoundFeed& bound) {
        const bool requested = bound.request == no_slot || (requests_[robot] >> bound.request & 1U) != 0;
        if (!requested) return;
        if (is_blind(robot, bound)) return fill_blind(bound);
        rc_signal& signal = signals_[bound.input];
        switch (bound.feed->carries) {
            case Carries::signal:
                if (is_there(robot, bound)) signal.present = 1;
                break;
            case Carries::boolean:
                signal.present = 1;
                signal.value.whole = is_true(robot, bound) ? 1 : 0;
                break;
            case Carries::whole:
                if (const auto value = whole_reading(robot, bound)) {
                    signal.present = 1;
                    signal.value.whole = *value;
                }
                break;
            case Carries::real:
                signal.present = 1;
                signal.value.real = real_reading(robot, bound) / bound.feed->factor;
                break;
        }
    }

    void fill_input(const BoundStimulus& bound) {
        const Stimulus& stimulus = *bound.stimulus;
        const double step = scenario_.world.control_step;
        const auto due = static_cast<std::uint64_t>(std::llround(stimulus.at / step));
        const auto gap = static_cast<std::uint64_t>(std::llround(stimulus.every / step));
        const bool now = gap == 0 ? result_.steps == due : result_.steps > 0 && result_.steps % gap == 0;
        if (now) raise_input(bound);
    }

    void raise_input(const BoundStimulus& bound) {
        rc_signal& signal = signals_[bound.input];
        signal.present = 1;
        if (bound.real)
            signal.value.real = bound.value;
        else
            signal.value.whole = std::llround(bound.value);
    }

    [[nodiscard]] const Sensor& sensor_of_feed(const BoundFeed& bound) const { return scenario_.sensors[bound.sensor]; }

    /// Returns the argument of a reading in the internal unit.
    [[nodiscard]] double argument_value(std::size_t robot, const BoundFeed& bound) const {
        const Argument& argument = *bound.feed->argument;
        if (bound.variable == no_slot) return argument.literal.value;
        return variables_[first_variable_[robot] + bound.variable] * argument.factor;
    }

    [[nodiscard]] const Sight& sight_of(std::size_t robot, const BoundFeed& bound) {
        auto& seen = sights_[bound.sensor];
        if (!seen) seen = stage_.line_of_sight(robot, sensor_of_feed(bound));
        return *seen;
    }

    bool is_there(std::size_t robot, const BoundFeed& bound) {
        switch (bound.feed->reading) {
            case Reading::robot:
                return sight_of(robot, bound).what == Seen::robot;
            case Reading::clear:
                return sight_of(robot, bound).what != Seen::robot;
            case Reading::wall:
                return sight_of(robot, bound).what == Seen::wall;
            case Reading::turned:
                return turns_[robot].left == 0;
            case Reading::on:
                return draw_detection(sensor_of_feed(bound), is_at_light(robot, bound));
            case Reading::distance:
            case Reading::near:
            case Reading::away:
            case Reading::towards:
            case Reading::count:
            case Reading::message:
            case Reading::lit:
                break;
        }
        const double distance = argument_value(robot, bound);
        return sensor_of_feed(bound).kind == SensorKind::proximity
                   ? draw_detection(sensor_of_feed(bound), stage_.close_within(robot, sensor_of_feed(bound), distance))
                   : stage_.somebody_within(robot, sensor_of_feed(bound), distance);
    }

    /// Draws whether an unreliable sensor reports an object. Errors of a line of sight are simulated in the world.
    bool draw_detection(const Sensor& sensor, bool there) {
        return there ? !draws_.draw_chance(sensor.false_negative) : draws_.draw_chance(sensor.false_positive);
    }

    [[nodiscard]] bool is_at_light(std::size_t robot, const BoundFeed& bound) const {
        for (const MovingLight& light : lights_)
            if (light.light.name.text == sensor_of_feed(bound).source.text)
                return light.on &&
                       length(stage_.pose(robot).at - light.position_at(time())) <= argument_value(robot, bound);
        return false;
    }

    /// Returns the number of robots whose messages are received, or the message of one of them. Returns no value if no
    /// message is received.
    std::optional<std::int64_t> whole_reading(std::size_t robot, const BoundFeed& bound) {
        std::vector<std::uint32_t> heard =
            stage_.robots_within(robot, sensor_of_feed(bound), argument_value(robot, bound));
        if (bound.feed->reading == Reading::count) return static_cast<std::int64_t>(heard.size());
        const auto sent = [&](std::uint32_t other) {
            const std::uint32_t slot = plan_of(other).messages[bound.sensor];
            return slot == no_slot ? 0 : sent_[first_variable_[other] + slot];
        };
        std::erase_if(heard, [&](std::uint32_t other) { return sent(other) == 0; });
        if (heard.empty()) return std::nullopt;
        const auto which = static_cast<std::size_t>(draws_.uniform() * static_cast<double>(heard.size()));
        return std::llround(sent(heard[which]));
    }

    bool is_true(std::size_t robot, const BoundFeed& bound) {
        return stage_.lit_sensors(robot, sensor_of_feed(bound)) >= argument_value(robot, bound);
    }

    double real_reading(std::size_t robot, const BoundFeed& bound) {
        if (bound.feed->reading == Reading::distance) return sight_of(robot, bound).distance;
        const auto others = stage_.direction_of_others(robot, sensor_of_feed(bound), argument_value(robot, bound));
        // If no robot is heard, `away` is straight ahead and `towards` is backwards, so that a lone robot turns around.
        if (bound.feed->reading == Reading::away) return others ? normal_angle(*others + std::numbers::pi) : 0;
        return others.value_or(std::numbers::pi);
    }

    // ------------------------------------------------------------ acting

    void apply_action(std::size_t robot, const rc_action& action) {
        for (const Effect& effect : plan_of(robot).effects[action.output]) {
            switch (effect.kind) {
                case Effect::Kind::store:
                    store_variable(
                        robot, effect.slot,
                        effect.whole ? static_cast<double>(action.argument[0].whole) : action.argument[0].real);
                    break;
                case Effect::Kind::request:
                    requests_[robot] |= std::uint64_t{1} << effect.slot;
                    break;
                case Effect::Kind::drive:
                    start_motion(robot, scenario_.kind_at(kind_of_[robot]).drives[effect.slot], action);
                    break;
            }
        }
    }

    void store_variable(std::size_t robot, std::uint32_t slot, double value) {
        double* const variables = variables_.data() + first_variable_[robot];
        variables[slot] = value;
        const auto& speeds = plan_of(robot).speeds;
        if (!speeds || (slot != speeds->linear && slot != speeds->angular)) return;
        const Drive& drive = *speeds->drive;
        set_wheels(robot, wheels_for(variables[speeds->linear] * drive.linear_factor,
                                     variables[speeds->angular] * drive.angular_factor, axle_of(robot)));
    }

    void start_motion(std::size_t robot, const Drive& drive, const rc_action& action) {
        turns_[robot] = {};
        courses_[robot] = {};
        switch (drive.motion) {
            case Motion::forward:
                return set_wheels(robot, {drive.speed, drive.speed});
            case Motion::wander:
            case Motion::seek:
                courses_[robot] = {&drive, draws_.uniform(-wandering, wandering)};
                return;
            case Motion::turn:
                return begin_turn(robot, drive, action.argument[0].real * drive.angular_factor);
            case Motion::speeds:
            case Motion::stop:
                return set_wheels(robot, {});
        }
    }

    void begin_turn(std::size_t robot, const Drive& drive, double angle) {
        if (!std::isfinite(angle)) return stop_trial(robot, no_finite_number);
        set_wheels(robot, {});
        turns_[robot] = {normal_angle(angle), 2 * drive.speed / axle_of(robot)};
    }

    /// Continues a turn by dead reckoning: at the full rate while a whole step remains, and then through the rest of
    /// the angle.
    void continue_motion(std::size_t robot) {
        if (courses_[robot].drive != nullptr) return follow_course(robot, courses_[robot]);
        Turn& turn = turns_[robot];
        if (turn.left == 0) {
            if (turn.rate != 0) set_wheels(robot, {});
            turn.rate = 0;
            return;
        }
        const double step = scenario_.world.control_step;
        const double most = turn.rate * step;
        const double now = std::clamp(turn.left, -most, most);
        set_wheels(robot, wheels_for(0, now / step, axle_of(robot)));
        turn.left = std::abs(turn.left) <= most ? 0 : turn.left - now;
    }

    /// Follows a course. Wandering is a correlated random walk: the turning rate is drawn every second. A seeking robot
    /// turns faster the more it deviates, and moves forward in proportion to its alignment with the light.
    void follow_course(std::size_t robot, Course& course) {
        const double between = axle_of(robot);
        const double speed = course.drive->speed;
        if (course.drive->motion == Motion::wander) {
            const auto second = static_cast<std::uint64_t>(std::llround(1 / scenario_.world.control_step));
            if (result_.steps % std::max<std::uint64_t>(1, second) == 0)
                course.rate = draws_.uniform(-wandering, wandering);
            return set_wheels(robot, wheels_for(speed, course.rate, between));
        }
        const Pose pose = stage_.pose(robot);
        const MovingLight& light = lights_[course.drive->light];
        if (!light.on) return set_wheels(robot, {});
        const Vector way = light.position_at(time()) - pose.at;
        const double step = scenario_.world.control_step;
        const double off = normal_angle(std::atan2(way.y, way.x) - pose.heading);
        set_wheels(robot, wheels_for(speed * std::max(0.0, std::cos(off)), off * std::min(seeking, 1 / step), between));
    }

    // ------------------------------------------------------------ observing

    void observe_world() {
        const bool keep = options_.record && is_record_due();
        const bool due =
            std::ranges::any_of(properties_, [&](const Property& property) { return property.is_due(result_.steps); });
        const bool sampled = scenario_.abstraction && result_.steps % scenario_.steps_between_samples() == 0;
        if (!keep && !due && !sampled && !statistics_.is_due(result_.steps)) return;
        Frame frame = frame_now(keep || states_are_measured());
        const MeasureNow now = measures_now(scenario_, frame);
        statistics_.take_samples(result_.steps, now);
        for (Property& property : properties_) property.evaluate_at(result_.steps, now);
        if (sampled) add_sample(now);
        if (keep) result_.frames.push_back(std::move(frame));
    }

    void add_sample(const MeasureNow& now) {
        std::vector<double>& values = result_.samples.emplace_back();
        for (const Distinction& distinction : scenario_.abstraction->distinctions)
            values.push_back(now(distinction.measure));
    }

    [[nodiscard]] bool states_are_measured() const {
        return std::ranges::any_of(scenario_.measures,
                                   [](const Measure& measure) { return measure.kind == MeasureKind::in_state; });
    }

    [[nodiscard]] Frame frame_now(bool with_states) {
        Frame frame;
        frame.time = time();
        for (std::size_t robot = 0; robot < stage_.size(); ++robot) frame.poses.push_back(stage_.pose(robot));
        frame.working = working_;
        frame.lights = lights_now();
        frame.obstacles = obstacles_;
        add_kept_claims(frame);
        if (with_states) add_states(frame);
        return frame;
    }

    void add_kept_claims(Frame& frame) const {
        const auto is_kept = [](const Measure& measure) { return measure.kind == MeasureKind::kept; };
        if (options_.trace == nullptr || std::ranges::none_of(scenario_.measures, is_kept)) return;
        for (std::size_t m = 0; m < scenario_.measures.size(); ++m)
            frame.kept.push_back(is_kept(scenario_.measures[m]) ? options_.trace->kept_share(m) : 0);
    }

    void add_states(Frame& frame) {
        for (std::size_t robot = 0; robot < stage_.size(); ++robot)
            for (std::uint32_t machine = 0; machine < states_.machine_count(); ++machine)
                frame.states.push_back(states_.state_number(kind_of_[robot], machine, controller_of(robot)));
    }

    [[nodiscard]] bool is_record_due() const {
        const double step = scenario_.world.control_step;
        const auto gap = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(scenario_.record / step)));
        if (result_.steps % gap == 0 || result_.steps == scenario_.step_count()) return true;
        return std::ranges::any_of(scenario_.pictures, [&](double at) {
            return result_.steps == static_cast<std::uint64_t>(std::llround(at / step));
        });
    }

    const Plan& plan_;
    const Scenario& scenario_;
    const Drives drives_;
    StateNumbers states_;
    Stage& stage_;
    const TrialOptions& options_;
    std::vector<ControllerArray> controllers_;  ///< for each kind
    std::vector<std::size_t> first_robot_;      ///< for each kind
    std::vector<double> axles_;                 ///< for each kind
    std::vector<std::size_t> kind_of_;          ///< for each robot
    std::vector<std::size_t> first_variable_;   ///< for each robot, in `variables_`
    rc_actions actions_{};
    std::vector<rc_signal> signals_;
    std::vector<std::uint64_t> requests_;
    std::vector<double> variables_;  ///< by robot
    std::vector<double> sent_;       ///< values at the beginning of the cycle, which are sent as messages
    std::vector<Turn> turns_;
    std::vector<Course> courses_;
    std::vector<Failed> failed_;
    std::vector<Failing> failing_;
    std::vector<bool> working_;  ///< empty if no part can fail
    Random draws_;  ///< draws failures, messages and random walks; sensors and wheels use the world's generator
    std::vector<std::optional<Sight>> sights_;
    std::vector<MovingLight> lights_;
    std::vector<bool> obstacles_;  ///< true: the obstacle of Scenario::obstacles is present
    std::optional<ControllerArray> environment_;
    std::vector<std::optional<Condition>> conditions_;  ///< the conditions of the environment's feeds
    std::vector<std::vector<BoundStimulus>> raised_;  ///< events that the environment raised in its last cycle, by kind
    Statistics statistics_;
    std::vector<Property> properties_;
    TrialResult result_;
};

Trial::Trial(const Plan& plan, const Drives& drives, Stage& stage, const TrialOptions& options)
    : cycles_(std::make_unique<Cycles>(plan, drives, stage, options)) {}

Trial::~Trial() = default;

bool Trial::run(std::uint64_t steps) {
    return cycles_->run(steps);
}

TrialResult Trial::result() && {
    return cycles_->result();
}

TrialResult run_trial(const Plan& plan, const Drives& drives, Stage& stage, const TrialOptions& options) {
    Trial trial(plan, drives, stage, options);
    trial.run(std::numeric_limits<std::uint64_t>::max());
    return std::move(trial).result();
}

}  // namespace robochart::simulation
