// The cycle of a trial: sense, controllers, act, one control step; see trial.hpp.
#include "simulation/trial/trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "simulation/world/random.hpp"

namespace robochart::simulation {

namespace {

/// The state of a turn by dead reckoning: radians still to go.
struct Turn {
    double left = 0;
    double rate = 0;
};

/// What a robot follows step by step: it wanders, or seeks a light.
struct Course {
    const Drive* drive = nullptr;  ///< null: neither
    double rate = 0;               ///< wander: of turning, rad/s, for the second that runs
};

/// How fast a robot that wanders turns at most, rad/s, and that seeks, for each radian that it is off.
constexpr double wandering = 1.5;
constexpr double seeking = 4;

/// What has failed of a robot.
struct Failed {
    bool whole = false;
    bool motors = false;
    bool sensors = false;
};

/// When something fails of a robot.
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

}  // namespace

class Trial::Cycles {
public:
    Cycles(const Plan& plan, const rc_drive& drive, Stage& stage, const TrialOptions& options)
        : plan_(plan),
          scenario_(*plan.scenario),
          drive_(drive),
          stage_(stage),
          options_(options),
          controllers_(drive, stage.size(), options.seed),
          signals_(plan.inputs + 1),
          requests_(stage.size()),
          variables_(stage.size() * plan.variables.size()),
          turns_(stage.size()),
          courses_(stage.size()),
          failed_(stage.size()),
          working_(scenario_.failures.empty() ? 0 : stage.size(), true),
          draws_(~options.seed),
          sights_(scenario_.sensors.size()),
          statistics_(scenario_) {
        for (std::size_t i = 0; i < variables_.size(); ++i) variables_[i] = plan.variables[i % plan.variables.size()];
        for (const Failure& failure : scenario_.failures) plan_failure(failure);
        for (const Claim& claim : scenario_.claims)
            properties_.emplace_back(claim.property, scenario_.world.control_step, scenario_.steps());
    }

    bool run(std::uint64_t steps) {
        if (result_.steps == 0) begin();
        for (; steps > 0 && goes_on(); --steps) step();
        return goes_on();
    }

    TrialResult result() {
        result_.complete = !result_.stop && (result_.steps == scenario_.steps() || answered());
        result_.statistics = statistics_.values();
        for (std::size_t c = 0; c < properties_.size(); ++c) {
            if (result_.stop) properties_[c].end(result_.steps, !scenario_.claims[c].at_least);
            result_.answers.push_back(properties_[c].answer());
        }
        return std::move(result_);
    }

private:
    [[nodiscard]] double time() const { return static_cast<double>(result_.steps) * scenario_.world.control_step; }
    [[nodiscard]] bool interrupted() const {
        return options_.interrupted != nullptr && options_.interrupted->load(std::memory_order_relaxed);
    }

    [[nodiscard]] bool goes_on() const {
        return result_.steps < scenario_.steps() && !result_.stop && !answered() && !interrupted();
    }
    /// All that is awaited is known.
    [[nodiscard]] bool answered() const {
        if (options_.awaited == nullptr) return false;
        for (std::size_t c = 0; c < properties_.size(); ++c)
            if ((*options_.awaited)[c] && !properties_[c].answer().holds) return false;
        return true;
    }

    void step() {
        stage_.sense();
        sent_ = variables_;
        for (std::size_t robot = 0; robot < stage_.size() && !result_.stop; ++robot)
            if (!failed_[robot].whole) cycle(robot);
        if (result_.stop) return;
        stage_.advance();
        ++result_.steps;
        if (options_.steps_done != nullptr) options_.steps_done->fetch_add(1, std::memory_order_relaxed);
        fail();
        observe();
    }

    void begin() {
        fail();
        observe();
    }

    /// What robots perceive, what their controllers make of it, what they do.
    void cycle(std::size_t robot) {
        for (rc_signal& signal : signals_) signal.present = 0;
        for (auto& sight : sights_) sight.reset();
        for (const BoundFeed& feed : plan_.feeds) fill(robot, feed);
        for (const BoundStimulus& stimulus : plan_.stimuli) fill(stimulus);
        requests_[robot] = 0;
        const rc_drive_result result = drive_.step(controllers_[robot], signals_.data(), &actions_);
        if (options_.trace != nullptr) options_.trace->cycle(robot, result_.steps, signals_.data(), actions_, result);
        if (result > RC_DRIVE_TERMINATED || actions_.overflow != 0) return stop(robot, result);
        const Objection* const objection = options_.trace == nullptr ? nullptr : options_.trace->objection();
        if (objection != nullptr) {
            result_.stop = Stop{robot, time(), objection->cause, objection->place};
            return;
        }
        for (std::uint32_t a = 0; a < actions_.count; ++a) act(robot, actions_.action[a]);
        move(robot);
    }

    void stop(std::size_t robot, rc_drive_result result) {
        result_.stop = Stop{robot, time(), cause_of(result), drive_.place_of(controllers_[robot])};
    }

    // ------------------------------------------------------------ failures

    /// Something fails at the first instant from its time on.
    void plan_failure(const Failure& failure) {
        const double step = scenario_.world.control_step;
        const std::size_t most = stage_.size();
        const std::size_t count = failure.mean_time > 0 ? most : std::min<std::size_t>(most, failure.robots);
        for (std::size_t robot = 0; robot < count; ++robot) {
            const double at = failure.mean_time > 0 ? -failure.mean_time * std::log1p(-draws_.uniform()) : failure.at;
            if (at <= scenario_.duration)
                failing_.push_back({static_cast<std::uint64_t>(std::ceil(at / step - 1e-9)), robot, failure.kind});
        }
    }

    void fail() {
        for (const Failing& failing : failing_)
            if (failing.step == result_.steps) fail(failing.robot, failing.kind);
    }

    void fail(std::size_t robot, FailureKind kind) {
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

    /// Every command to the wheels: those of a robot whose motors have failed stand.
    void set_wheels(std::size_t robot, Wheels wheels) {
        stage_.set_wheels(robot, failed_[robot].motors ? Wheels{} : wheels);
    }

    // ------------------------------------------------------------ sensing

    /// A sensor that has failed reports nothing: no event, false, 0. The radio is none of them.
    [[nodiscard]] bool is_blind(std::size_t robot, const BoundFeed& bound) const {
        return failed_[robot].sensors && bound.sensor != no_slot && sensor(bound).kind != SensorKind::range_and_bearing;
    }

    void fill_blind(const BoundFeed& bound) {
        rc_signal& signal = signals_[bound.input];
        signal.present = bound.feed->carries == Carries::boolean || bound.feed->carries == Carries::real ? 1 : 0;
        signal.value = {};
    }

    void fill(std::size_t robot, const BoundFeed& bound) {
        const bool asked = bound.request == no_slot || (requests_[robot] >> bound.request & 1U) != 0;
        if (!asked) return;
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
                if (const auto value = counted(robot, bound)) {
                    signal.present = 1;
                    signal.value.whole = *value;
                }
                break;
            case Carries::real:
                signal.present = 1;
                signal.value.real = measured(robot, bound) / bound.feed->factor;
                break;
        }
    }

    void fill(const BoundStimulus& bound) {
        const Stimulus& stimulus = *bound.stimulus;
        const double step = scenario_.world.control_step;
        const auto due = static_cast<std::uint64_t>(std::llround(stimulus.at / step));
        const auto gap = static_cast<std::uint64_t>(std::llround(stimulus.every / step));
        const bool now = gap == 0 ? result_.steps == due : result_.steps > 0 && result_.steps % gap == 0;
        if (!now) return;
        rc_signal& signal = signals_[bound.input];
        signal.present = 1;
        if (bound.real)
            signal.value.real = bound.value;
        else
            signal.value.whole = std::llround(bound.value);
    }

    [[nodiscard]] const Sensor& sensor(const BoundFeed& bound) const { return scenario_.sensors[bound.sensor]; }

    /// In the unit used inside.
    [[nodiscard]] double argument(std::size_t robot, const BoundFeed& bound) const {
        const Argument& argument = *bound.feed->argument;
        if (bound.variable == no_slot) return argument.literal.value;
        return variables_[robot * plan_.variables.size() + bound.variable] * argument.factor;
    }

    [[nodiscard]] const Sight& sight(std::size_t robot, const BoundFeed& bound) {
        auto& seen = sights_[bound.sensor];
        if (!seen) seen = stage_.line_of_sight(robot, sensor(bound));
        return *seen;
    }

    bool is_there(std::size_t robot, const BoundFeed& bound) {
        switch (bound.feed->reading) {
            case Reading::robot:
                return sight(robot, bound).what == Seen::robot;
            case Reading::clear:
                return sight(robot, bound).what != Seen::robot;
            case Reading::wall:
                return sight(robot, bound).what == Seen::wall;
            case Reading::turned:
                return turns_[robot].left == 0;
            case Reading::on:
                return length(stage_.pose(robot).at - light_of(sensor(bound))) <= argument(robot, bound);
            default:
                break;
        }
        const double distance = argument(robot, bound);
        return sensor(bound).kind == SensorKind::proximity ? stage_.close_within(robot, sensor(bound), distance)
                                                           : stage_.somebody_within(robot, sensor(bound), distance);
    }

    [[nodiscard]] Vector light_of(const Sensor& sensor) const {
        for (const Light& light : scenario_.lights)
            if (light.name.text == sensor.source.text) return light.position(time());
        return {};
    }

    /// How many robots are heard, or what one of those heard sends; nothing where none sends anything.
    std::optional<std::int64_t> counted(std::size_t robot, const BoundFeed& bound) {
        std::vector<std::uint32_t> heard = stage_.robots_within(robot, sensor(bound), argument(robot, bound));
        if (bound.feed->reading == Reading::count) return static_cast<std::int64_t>(heard.size());
        const std::uint32_t slot = plan_.messages[bound.sensor];
        const auto sent = [&](std::uint32_t other) { return sent_[other * plan_.variables.size() + slot]; };
        std::erase_if(heard, [&](std::uint32_t other) { return sent(other) == 0; });
        if (heard.empty()) return std::nullopt;
        const auto which = static_cast<std::size_t>(draws_.uniform() * static_cast<double>(heard.size()));
        return std::llround(sent(heard[which]));
    }

    bool is_true(std::size_t robot, const BoundFeed& bound) {
        return stage_.lit_sensors(robot, sensor(bound)) >= argument(robot, bound);
    }

    double measured(std::size_t robot, const BoundFeed& bound) {
        if (bound.feed->reading == Reading::distance) return sight(robot, bound).distance;
        const auto others = stage_.direction_of_others(robot, sensor(bound), argument(robot, bound));
        // Nobody there: nothing to turn away from; whoever is alone turns round to where it came from.
        if (bound.feed->reading == Reading::away) return others ? normal_angle(*others + std::numbers::pi) : 0;
        return others.value_or(std::numbers::pi);
    }

    // ------------------------------------------------------------ acting

    void act(std::size_t robot, const rc_action& action) {
        for (const Effect& effect : plan_.effects[action.output]) {
            switch (effect.kind) {
                case Effect::Kind::store:
                    store(robot, effect.slot,
                          effect.whole ? static_cast<double>(action.argument[0].whole) : action.argument[0].real);
                    break;
                case Effect::Kind::request:
                    requests_[robot] |= std::uint64_t{1} << effect.slot;
                    break;
                case Effect::Kind::drive:
                    steer(robot, scenario_.drives[effect.slot], action);
                    break;
            }
        }
    }

    void store(std::size_t robot, std::uint32_t slot, double value) {
        double* const variables = variables_.data() + robot * plan_.variables.size();
        variables[slot] = value;
        if (!plan_.speeds || (slot != plan_.speeds->linear && slot != plan_.speeds->angular)) return;
        const Drive& drive = *plan_.speeds->drive;
        set_wheels(robot,
                   wheels_for(variables[plan_.speeds->linear] * drive.linear_factor,
                              variables[plan_.speeds->angular] * drive.angular_factor, scenario_.world.body.axle));
    }

    void steer(std::size_t robot, const Drive& drive, const rc_action& action) {
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
            default:
                return set_wheels(robot, {});
        }
    }

    void begin_turn(std::size_t robot, const Drive& drive, double angle) {
        set_wheels(robot, {});
        turns_[robot] = {normal_angle(angle), 2 * drive.speed / scenario_.world.body.axle};
    }

    /// A turn by dead reckoning: full rate while a whole step is to go, then what is left.
    void move(std::size_t robot) {
        if (courses_[robot].drive != nullptr) return follow(robot, courses_[robot]);
        Turn& turn = turns_[robot];
        if (turn.left == 0) {
            if (turn.rate != 0) set_wheels(robot, {});
            turn.rate = 0;
            return;
        }
        const double step = scenario_.world.control_step;
        const double most = turn.rate * step;
        const double now = std::clamp(turn.left, -most, most);
        set_wheels(robot, wheels_for(0, now / step, scenario_.world.body.axle));
        turn.left = std::abs(turn.left) <= most ? 0 : turn.left - now;
    }

    /// A correlated random walk: a rate of turning for each second. Seeking: the faster round the more it is off, and
    /// forward by as much as it is directed at the light.
    void follow(std::size_t robot, Course& course) {
        const double axle = scenario_.world.body.axle;
        const double speed = course.drive->speed;
        if (course.drive->motion == Motion::wander) {
            const auto second = static_cast<std::uint64_t>(std::llround(1 / scenario_.world.control_step));
            if (result_.steps % std::max<std::uint64_t>(1, second) == 0)
                course.rate = draws_.uniform(-wandering, wandering);
            return set_wheels(robot, wheels_for(speed, course.rate, axle));
        }
        const Pose pose = stage_.pose(robot);
        const Vector way = scenario_.lights[course.drive->light].position(time()) - pose.at;
        const double step = scenario_.world.control_step;
        const double off = normal_angle(std::atan2(way.y, way.x) - pose.heading);
        set_wheels(robot, wheels_for(speed * std::max(0.0, std::cos(off)), off * std::min(seeking, 1 / step), axle));
    }

    // ------------------------------------------------------------ observing

    void observe() {
        const bool keep = options_.record && due();
        const bool asked = std::any_of(properties_.begin(), properties_.end(),
                                       [&](const Property& property) { return property.due(result_.steps); });
        const bool sampled = scenario_.abstraction && result_.steps % scenario_.steps_apart() == 0;
        if (!keep && !asked && !sampled && !statistics_.due(result_.steps)) return;
        Frame frame;
        frame.time = time();
        for (std::size_t robot = 0; robot < stage_.size(); ++robot) frame.poses.push_back(stage_.pose(robot));
        frame.working = working_;
        if (keep || states_are_measured()) add_states(frame);
        const MeasureNow now = measures_now(scenario_, frame);
        statistics_.look(result_.steps, now);
        for (Property& property : properties_) property.look(result_.steps, now);
        if (sampled) sample(now);
        if (keep) result_.frames.push_back(std::move(frame));
    }

    void sample(const MeasureNow& now) {
        std::vector<double>& values = result_.samples.emplace_back();
        for (const Distinction& each : scenario_.abstraction->distinctions) values.push_back(now(each.measure));
    }

    [[nodiscard]] bool states_are_measured() const {
        return std::any_of(scenario_.measures.begin(), scenario_.measures.end(),
                           [](const Measure& measure) { return measure.kind == MeasureKind::in_state; });
    }

    void add_states(Frame& frame) {
        for (std::size_t robot = 0; robot < stage_.size(); ++robot)
            for (std::uint32_t machine = 0; machine < drive_.machines; ++machine)
                frame.states.push_back(static_cast<std::uint16_t>(drive_.state_of(controllers_[robot], machine)));
    }

    [[nodiscard]] bool due() const {
        const double step = scenario_.world.control_step;
        const auto gap = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(scenario_.record / step)));
        if (result_.steps % gap == 0 || result_.steps == scenario_.steps()) return true;
        return std::any_of(scenario_.pictures.begin(), scenario_.pictures.end(), [&](double at) {
            return result_.steps == static_cast<std::uint64_t>(std::llround(at / step));
        });
    }

    const Plan& plan_;
    const Scenario& scenario_;
    const rc_drive& drive_;
    Stage& stage_;
    const TrialOptions& options_;
    ControllerArray controllers_;
    rc_actions actions_{};
    std::vector<rc_signal> signals_;
    std::vector<std::uint64_t> requests_;
    std::vector<double> variables_;  ///< robot by robot
    std::vector<double> sent_;       ///< those at the beginning of the cycle: what messages carry
    std::vector<Turn> turns_;
    std::vector<Course> courses_;
    std::vector<Failed> failed_;
    std::vector<Failing> failing_;
    std::vector<bool> working_;  ///< empty where nothing can fail
    Random draws_;               ///< of failures, messages and random walks; sensors and wheels draw from the world's
    std::vector<std::optional<Sight>> sights_;
    Statistics statistics_;
    std::vector<Property> properties_;
    TrialResult result_;
};

Trial::Trial(const Plan& plan, const rc_drive& drive, Stage& stage, const TrialOptions& options)
    : cycles_(std::make_unique<Cycles>(plan, drive, stage, options)) {}

Trial::~Trial() = default;

bool Trial::run(std::uint64_t steps) {
    return cycles_->run(steps);
}

TrialResult Trial::result() && {
    return cycles_->result();
}

TrialResult run_trial(const Plan& plan, const rc_drive& drive, Stage& stage, const TrialOptions& options) {
    Trial trial(plan, drive, stage, options);
    trial.run(std::numeric_limits<std::uint64_t>::max());
    return std::move(trial).result();
}

}  // namespace robochart::simulation
