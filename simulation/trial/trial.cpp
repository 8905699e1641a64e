// The cycle of a trial: sense, controllers, act, one control step; see trial.hpp.
#include "simulation/trial/trial.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace robochart::simulation {

namespace {

/// The state of a turn by dead reckoning: radians still to go.
struct Turn {
    double left = 0;
    double rate = 0;
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
          sights_(scenario_.sensors.size()),
          statistics_(scenario_) {
        for (std::size_t i = 0; i < variables_.size(); ++i) variables_[i] = plan.variables[i % plan.variables.size()];
        for (const Claim& claim : scenario_.claims)
            properties_.emplace_back(claim.property, scenario_.world.control_step, scenario_.steps());
    }

    bool run(std::uint64_t steps) {
        if (result_.steps == 0) observe();
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
        for (std::size_t robot = 0; robot < stage_.size() && !result_.stop; ++robot) cycle(robot);
        if (result_.stop) return;
        stage_.advance();
        ++result_.steps;
        if (options_.steps_done != nullptr) options_.steps_done->fetch_add(1, std::memory_order_relaxed);
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

    // ------------------------------------------------------------ sensing

    void fill(std::size_t robot, const BoundFeed& bound) {
        const bool asked = bound.request == no_slot || (requests_[robot] >> bound.request & 1U) != 0;
        if (!asked) return;
        rc_signal& signal = signals_[bound.input];
        switch (bound.feed->carries) {
            case Carries::signal:
                if (is_there(robot, bound)) signal.present = 1;
                break;
            case Carries::boolean:
                signal.present = 1;
                signal.value.whole = is_true(robot, bound) ? 1 : 0;
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
            default:
                break;
        }
        const double distance = argument(robot, bound);
        return sensor(bound).kind == SensorKind::proximity ? stage_.close_within(robot, sensor(bound), distance)
                                                           : stage_.somebody_within(robot, sensor(bound), distance);
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
                    store(robot, effect.slot, action.argument[0].real);
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
        stage_.set_wheels(
            robot, wheels_for(variables[plan_.speeds->linear] * drive.linear_factor,
                              variables[plan_.speeds->angular] * drive.angular_factor, scenario_.world.body.axle));
    }

    void steer(std::size_t robot, const Drive& drive, const rc_action& action) {
        turns_[robot] = {};
        switch (drive.motion) {
            case Motion::forward:
                return stage_.set_wheels(robot, {drive.speed, drive.speed});
            case Motion::turn:
                return begin_turn(robot, drive, action.argument[0].real * drive.angular_factor);
            default:
                return stage_.set_wheels(robot, {});
        }
    }

    void begin_turn(std::size_t robot, const Drive& drive, double angle) {
        stage_.set_wheels(robot, {});
        turns_[robot] = {normal_angle(angle), 2 * drive.speed / scenario_.world.body.axle};
    }

    /// A turn by dead reckoning: full rate while a whole step is to go, then what is left.
    void move(std::size_t robot) {
        Turn& turn = turns_[robot];
        if (turn.left == 0) {
            if (turn.rate != 0) stage_.set_wheels(robot, {});
            turn.rate = 0;
            return;
        }
        const double step = scenario_.world.control_step;
        const double most = turn.rate * step;
        const double now = std::clamp(turn.left, -most, most);
        stage_.set_wheels(robot, wheels_for(0, now / step, scenario_.world.body.axle));
        turn.left = std::abs(turn.left) <= most ? 0 : turn.left - now;
    }

    // ------------------------------------------------------------ observing

    void observe() {
        const bool keep = options_.record && due();
        const bool asked = std::any_of(properties_.begin(), properties_.end(),
                                       [&](const Property& property) { return property.due(result_.steps); });
        if (!keep && !asked && !statistics_.due(result_.steps)) return;
        Frame frame;
        frame.time = time();
        for (std::size_t robot = 0; robot < stage_.size(); ++robot) frame.poses.push_back(stage_.pose(robot));
        const MeasureNow now = measures_now(scenario_, frame.poses);
        statistics_.look(result_.steps, now);
        for (Property& property : properties_) property.look(result_.steps, now);
        if (!keep) return;
        for (std::size_t robot = 0; robot < stage_.size(); ++robot)
            for (std::uint32_t machine = 0; machine < drive_.machines; ++machine)
                frame.states.push_back(static_cast<std::uint16_t>(drive_.state_of(controllers_[robot], machine)));
        result_.frames.push_back(std::move(frame));
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
    std::vector<Turn> turns_;
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
