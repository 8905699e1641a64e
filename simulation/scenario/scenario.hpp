// SPDX-License-Identifier: Apache-2.0
// Declares a scenario: everything about a simulation except the controller. The text of a scenario (docs/scenarios.md)
// uses RoboChart's tokens. The founding paper's future work asks for "an extended notation from which the simulation
// configurations can also be specified" (Li et al. 2017, section 4).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/syntax/word_reader.hpp"
#include "simulation/scenario/quantity.hpp"
#include "simulation/world/sensing.hpp"
#include "simulation/world/world.hpp"

namespace robochart::simulation {

using Name = frontend::Word;

enum class SensorKind { line_of_sight, range_and_bearing, light, proximity, ground };

/// What a sensor or actuator reports.
enum class Reading { robot, clear, wall, distance, near, away, towards, count, message, lit, on, turned };

/// The form in which a reading reaches the controller.
enum class Carries { signal, boolean, whole, real };

struct Sensor {
    Name name;
    SensorKind kind = SensorKind::line_of_sight;
    double sight_range = 0;     ///< 0: unlimited
    double false_negative = 0;  ///< for can_err: probability that an existing object is not seen
    double false_positive = 0;  ///< for can_err: probability that a missing object is seen
    RangeAndBearing range_and_bearing;
    LightRing light_ring;
    Name source;   ///< light, ground: the light's name
    Name message;  ///< range and bearing: the shared variable that every robot sends; "" if none
    ProximityRing proximity;
};

/// True for sensors that may miss an existing object, or see an object that does not exist.
[[nodiscard]] bool can_err(SensorKind);

/// Returns the fractions of a sensor that an option of this name sets; empty if there is no such option.
[[nodiscard]] std::vector<double*> shares_of(Sensor&, std::string_view option);

struct Actuator {
    Name name;
};

/// A bound on a reading: a quantity, or a shared variable of the controller with its unit.
struct Argument {
    Quantity literal;
    Name variable;  ///< "": the literal is used
    double factor = 1;
};

/// The item `feed EVENT with PART.READING(ARGUMENT) in UNIT on OPERATION`.
struct Feed {
    Name target;
    Name part;
    Reading reading = Reading::robot;
    Carries carries = Carries::signal;
    std::optional<Argument> argument;
    double factor = 1;       ///< real readings are divided by this
    std::optional<Name> on;  ///< the event is fed only in the cycle after a call of this operation
    diagnostics::Span span;
};

enum class Motion { speeds, forward, turn, stop, wander, seek };

/// The item `drive ACTUATOR by MOTION(...) on OPERATION`.
struct Drive {
    Name actuator;
    Motion motion = Motion::stop;
    double speed = 0;       ///< forward, turn, wander, seek: speed of the wheels, cm/s
    std::size_t light = 0;  ///< seek: the light to move towards
    Name linear, angular;   ///< speeds: the variables
    double linear_factor = 1;
    double angular_factor = 1;  ///< turn: factor for the operation's argument
    std::optional<Name> on;
    diagnostics::Span span;
};

/// The item `stimulus EVENT at TIME` or `stimulus EVENT every TIME`. The event is raised for every robot of a kind.
struct Stimulus {
    Name event;
    double at = 0;
    double every = 0;  ///< 0: the event is raised once
    std::optional<Quantity> value;
    std::optional<bool> truth;
    std::optional<Name> named;  ///< a literal or constant of the model
};

/// The item `light NAME at (X, Y) moving to (X, Y) at SPEED`. The light stops at the target.
struct Light {
    Name name;
    Vector at;
    Vector to;
    double speed = 0;  ///< cm/s; 0: it does not move

    /// Returns the position `time` seconds after the light was at `at`.
    [[nodiscard]] Vector position_at(double time) const;
    diagnostics::Span span;
};

/// The state of a light at one time.
struct LightNow {
    Vector at;
    bool on = true;
};

/// The item `obstacle NAME CORNER, ... absent`: a polygon that can appear and vanish. Obstacles without a name are part
/// of the arena.
struct Obstacle {
    Name name;
    std::vector<Vector> corners;  ///< at least three, in order
    bool there = true;            ///< whether the obstacle is present at the start
};

struct Placement {
    enum class Kind { pose, region, square, arena, linked };
    Kind kind = Kind::pose;
    Pose pose;        ///< pose: of the robot; square: its centre; linked: of the first robot
    Region region;    ///< random: the region of the positions
    double area = 0;  ///< square: area per robot
    double link = 0;  ///< linked: greatest distance (between centres) to a robot placed before
    diagnostics::Span span;
};

enum class MeasureKind { cluster, spread, second_moment, distance, reached, inside, in_state, working, time, kept };

[[nodiscard]] Dimension dimension_of(MeasureKind);

/// The item `measure NAME is KIND(ARGUMENT) of ROBOTS`.
struct Measure {
    Name name;
    MeasureKind kind = MeasureKind::spread;
    double link = 0;        ///< cluster: greatest distance of linked centres; reached: distance from the light
    std::size_t light = 0;  ///< distance: from the swarm's centroid to this light; reached: this light
    Name state;             ///< in_state: a state of the first machine; kept: the claim of the model
    std::vector<std::uint16_t> states;   ///< indices of it and of its inner states; set when the controller is known
    Region region = {};                  ///< inside: the rectangle
    std::optional<std::size_t> of = {};  ///< only robots of this kind (Scenario::kind_at)
};

/// The parts of a robot that fail. `whole` means its controller and all other parts.
enum class FailureKind { whole, motors, radio, sensors };

/// The item `failure of KIND at TIME in N robots`, or `failure of KIND with mean time TIME`.
struct Failure {
    FailureKind kind = FailureKind::whole;
    double at = 0;             ///< s
    std::uint32_t robots = 0;  ///< number of robots; the first ones fail, in the order of placements
    double mean_time = 0;      ///< s; if not 0: each robot fails after an independent, exponentially distributed time
    diagnostics::Span span;
};

/// A condition on an instant or on a trial. The instants are the start and the ends of control steps.
struct Formula {
    enum class Kind {
        compare,  ///< condition on an instant: a measure is between `low` and `high`
        stays,    ///< condition on an instant: the part has been true continuously for `time`
        at,  ///< condition on a trial, like the following ones: the part, a condition on an instant, is true at `time`
        within,    ///< true at some instant up to `time`
        until,     ///< the second part is true at some instant up to `time`, and the first at every earlier one
        always,    ///< true at every instant
        negation,  ///< condition on an instant or a trial, like its parts; so are those below
        both,
        either,
    };
    Kind kind = Kind::compare;
    std::size_t measure = 0;
    double low = 0;
    double high = 0;
    double time = 0;
    std::vector<Formula> parts;

    /// True for a condition on a trial, false for a condition on an instant.
    [[nodiscard]] bool of_trial() const;
};

enum class StatisticKind { at_time, first_time, average, final };

struct Statistic {
    StatisticKind kind = StatisticKind::final;
    std::size_t measure = 0;
    double time = 0;    ///< at_time
    Formula condition;  ///< first_time: a condition on an instant
};

/// The item `accept each|mean STATISTIC in LOW to HIGH`.
struct Band {
    Statistic statistic;
    bool each = true;  ///< true: every trial must be in the band; false: the mean of all trials
    double low = 0;
    double high = 0;
    std::string text;  ///< as written
    diagnostics::Span span;
};

/// The item `accept probability PROPERTY >= SHARE with confidence SHARE`, or `estimate probability PROPERTY with ...`.
struct Claim {
    Formula property;       ///< a condition on a trial
    bool estimate = false;  ///< true: no claim, but an interval after the trials of the scenario
    bool at_least = true;   ///< false: at most
    double probability = 0;
    double confidence = 0;
    double indifference = 0;        ///< 0: by intervals; otherwise by a test with an indifference region of this width
    std::uint32_t trials = 10'000;  ///< the maximum; for an estimate, the exact number
    bool limited = false;           ///< true if the text contains `at most N trials`
    std::string text;               ///< as written
    diagnostics::Span span;
};

enum class Varied { robots, noise, constant, sensor, failed, mean_time };

/// The item `vary`, such as `vary robots in 1 to 30`.
struct Variation {
    Varied what = Varied::robots;
    std::string constant;        ///< name of a constant of the model; for a sensor, its name
    std::string option;          ///< for a sensor: "error", "loss"
    std::vector<double> values;  ///< ascending, without duplicates
    bool until_proved = false;   ///< only the first variation: stop at the first value at which the claims are proved
    diagnostics::Span span;
};

/// The classes of a measure in a chain. A fraction of the robots has a class for each number of robots. Any measure can
/// be divided by levels: there is a class for the values up to and including each level, and a class for the values
/// above the last level.
struct Distinction {
    std::size_t measure = 0;
    std::vector<double> levels;  ///< ascending; empty: a class for each number of robots
};

/// A question that only a chain answers. It asks for the mean time until a condition is first true, or for the long-run
/// average of a measure.
struct ChainQuestion {
    bool time = true;   ///< false: asks for the average of `measure`
    Formula condition;  ///< a condition on an instant
    std::size_t measure = 0;
    double confidence = 0;
    std::string text;  ///< as written
    diagnostics::Span span;
};

/// The item `abstract by MEASURE in LEVELS, ... every TIME`: a Markov chain over the distinguished measures of the
/// swarm.
struct Abstraction {
    std::vector<Distinction> distinctions;
    double every = 0;  ///< time between two states, in s; a multiple of the control step
    diagnostics::Span span;
};

/// The item `feed EVENT with MEASURE in UNIT` or `feed EVENT with CONDITION` of an environment.
struct WorldFeed {
    Name target;
    std::size_t measure = 0;
    double factor = 1;                 ///< the measure is divided by this
    std::optional<Formula> condition;  ///< a condition on an instant, instead of the measure
    std::string text;                  ///< "when close >= 51 %", "with close in %"
    diagnostics::Span span;
};

/// The effect of a command of an environment on the world.
struct WorldAct {
    enum class Kind { light_on, light_off, light_move, obstacle_appear, obstacle_vanish, failure, stimulus };
    Kind kind = Kind::light_on;
    std::size_t what = 0;      ///< for a light or an obstacle: its index
    std::optional<Vector> to;  ///< light_move: the target; no value: the target is the two arguments of the command
    double factor = 1;         ///< the arguments are multiplied by this
    double speed = 0;          ///< light_move, cm/s
    Failure failure;           ///< a failure of working robots, which are chosen at random
    Stimulus stimulus;
    Name on;  ///< an operation or output event of the environment's component
    diagnostics::Span span;
};

/// The model from which a controller is generated, and its constants.
struct Controlled {
    Name component;
    std::string
        model;  ///< path of the model, relative to the scenario's folder; "": that of the scenario, or its folder
    std::vector<std::string> constants;  ///< NAME=VALUE
    std::vector<Name> ignored;           ///< events and operations that the scenario intentionally does not use
};

/// The options in which the drive of a kind differs from that of the first kind. No value means no difference. All
/// robots have the same radius.
struct OwnDrive {
    std::optional<double> axle, max_wheel, noise;
};

/// Robots with the same controller: their number, their start positions, and their platform.
struct RobotKind : Controlled {
    Name kind;  ///< "" if it has no name
    std::uint32_t robots = 0;
    OwnDrive own;  ///< not used for the first kind, whose body is set by the world's options
    std::vector<Placement> placements;
    std::vector<Feed> feeds;
    std::vector<Drive> drives;
    std::vector<Stimulus> stimuli;
    std::vector<Failure> failures;
};

/// The item `environment COMPONENT { ... }`: a controller without a body. It reads measures of the world, and its
/// commands act on the world.
struct Environment : Controlled {
    std::vector<WorldFeed> feeds;
    std::vector<WorldAct> acts;
};

/// A scenario. It is also its first kind of robots, because most scenarios have no other kind.
struct Scenario : RobotKind {
    Name name;
    std::vector<RobotKind> others;  ///< their robots are numbered after those of the first kind, in this order
    std::optional<Environment> environment;
    WorldOptions world;
    double arena_area = 0;        ///< area per robot in a square arena; 0: the sides are given
    double time_unit = 0;         ///< seconds per time unit of the model
    diagnostics::Span unit_span;  ///< the place of the item `unit`; unknown if it is left out
    std::uint32_t units_per_step = 1;
    double duration = 0;
    std::uint32_t trials = 1;
    std::uint64_t seed = 1;
    std::vector<Light> lights;
    std::vector<Obstacle> obstacles;  ///< the obstacles that have a name
    std::vector<Sensor> sensors;
    std::vector<Actuator> actuators;
    std::vector<Measure> measures;
    std::vector<Band> bands;
    std::vector<Claim> claims;
    std::vector<Variation> variations;  ///< at most two
    std::optional<Abstraction> abstraction;
    std::vector<ChainQuestion> chain_questions;
    std::vector<std::string> drawings;       ///< texts of the drawings that contain obstacles
    std::vector<std::string> drawing_files;  ///< paths of these drawings, in the same order
    std::vector<double> pictures;            ///< times, s
    double record = 0.5;                     ///< s between recorded positions

    [[nodiscard]] std::uint64_t step_count() const;
    /// Returns the number of control steps between two states of the chain.
    [[nodiscard]] std::uint64_t steps_between_samples() const;
    /// Sets the number of trials, for bands and estimates.
    void set_trials(std::uint32_t count);
    /// Sets the number of robots of the first kind, and adapts the arena.
    void set_robots(std::uint32_t count);

    /// Returns the number of kinds of robots; the first kind is the scenario itself.
    [[nodiscard]] std::size_t kind_count() const { return 1 + others.size(); }
    [[nodiscard]] const RobotKind& kind_at(std::size_t number) const {
        return number == 0 ? static_cast<const RobotKind&>(*this) : others[number - 1];
    }
    /// Returns the body of the robots of a kind.
    [[nodiscard]] Body body_of(std::size_t number) const;
    /// Returns the number of controllers: one for each kind of robots, and one for the environment if there is one.
    [[nodiscard]] std::size_t controller_count() const { return kind_count() + (environment ? 1 : 0); }
    [[nodiscard]] const Controlled& controller_at(std::size_t number) const {
        return number < kind_count() ? static_cast<const Controlled&>(kind_at(number)) : *environment;
    }
    /// Returns the name of a controller: that of its kind, such as "leaders", or "environment". The name of a first
    /// kind without a name is "".
    [[nodiscard]] std::string controller_name(std::size_t number) const;
    /// Returns the number of robots of all kinds.
    [[nodiscard]] std::uint32_t all_robots() const;
    /// Returns the index of the first robot of a kind.
    [[nodiscard]] std::uint32_t first_robot(std::size_t number) const;
    /// True if there are several kinds of robots, or an environment.
    [[nodiscard]] bool has_others() const { return !others.empty() || environment.has_value(); }
};

/// Returns the index of a kind, by name.
[[nodiscard]] std::optional<std::size_t> kind_named(const Scenario&, std::string_view name);
/// Returns the index of the controller that belongs to the kind with this name, or to the "environment".
[[nodiscard]] std::optional<std::size_t> controller_named(const Scenario&, std::string_view name);
/// Returns the names of all controllers that have a name.
[[nodiscard]] std::vector<std::string> controller_names(const Scenario&);

/// A constant of one of a scenario's models, as in `--const` and `vary const`: "pace" for the first kind of robots,
/// "leaders.pace" for the kind named leaders, "environment.pace".
struct AddressedConstant {
    std::size_t controller = 0;
    std::string constant;  ///< "pace", "Keep::pace"
};
/// Finds the controller and the constant of a name. Returns no value if no controller has the name before the dot.
[[nodiscard]] std::optional<AddressedConstant> find_constant_address(const Scenario&, const std::string& name);

}  // namespace robochart::simulation
