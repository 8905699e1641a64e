// A scenario: everything about a simulation but the controller. The text (docs/scenarios.md) is read with RoboChart's
// own words; the founding paper's future work asks for "an extended notation from which the simulation configurations
// can also be specified" (Li et al. 2017, section 4).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "frontend/syntax/word_reader.hpp"
#include "simulation/scenario/quantity.hpp"
#include "simulation/world/sensing.hpp"
#include "simulation/world/world.hpp"

namespace robochart::simulation {

using Name = frontend::Word;

enum class SensorKind { line_of_sight, range_and_bearing, light, proximity, ground };

/// What a sensor or actuator reports.
enum class Reading { robot, clear, wall, distance, near, away, towards, count, message, lit, on, turned };

/// How a reading reaches the controller.
enum class Carries { signal, boolean, whole, real };

struct Sensor {
    Name name;
    SensorKind kind = SensorKind::line_of_sight;
    double sight_range = 0;     ///< 0: unlimited
    double false_negative = 0;  ///< can_err: how often what is there is not seen
    double false_positive = 0;  ///< and how often it is seen where there is none
    RangeAndBearing range_and_bearing;
    LightRing light_ring;
    Name source;   ///< light, ground: which light
    Name message;  ///< range and bearing: the shared variable that every robot sends; 0: it sends nothing
    ProximityRing proximity;
};

/// What it detects may be missed, or seen where there is none.
[[nodiscard]] bool can_err(SensorKind);

/// The shares of a sensor that an option of this name sets; none where it has no such option.
[[nodiscard]] std::vector<double*> shares_of(Sensor&, std::string_view option);

struct Actuator {
    Name name;
};

/// A bound on a reading: a quantity, or a shared variable of the controller and its unit.
struct Argument {
    Quantity literal;
    Name variable;  ///< "": the literal
    double factor = 1;
};

/// `feed EVENT with PART.READING(ARGUMENT) in UNIT on OPERATION`.
struct Feed {
    Name target;
    Name part;
    Reading reading = Reading::robot;
    Carries carries = Carries::signal;
    std::optional<Argument> argument;
    double factor = 1;       ///< real readings are divided by it
    std::optional<Name> on;  ///< only in the cycle after this operation was called
    diagnostics::Span span;
};

enum class Motion { speeds, forward, turn, stop, wander, seek };

/// `drive ACTUATOR by MOTION(...) on OPERATION`.
struct Drive {
    Name actuator;
    Motion motion = Motion::stop;
    double speed = 0;       ///< forward, turn, wander, seek: of the wheels, cm/s
    std::size_t light = 0;  ///< seek: towards it
    Name linear, angular;   ///< speeds: the variables
    double linear_factor = 1;
    double angular_factor = 1;  ///< turn: of the operation's argument
    std::optional<Name> on;
    diagnostics::Span span;
};

/// `stimulus EVENT at TIME` or `stimulus EVENT every TIME`: raised for every robot of a kind.
struct Stimulus {
    Name event;
    double at = 0;
    double every = 0;  ///< 0: once
    std::optional<Quantity> value;
    std::optional<bool> truth;
    std::optional<Name> named;  ///< a literal or constant of the model
};

/// `light NAME at (X, Y) moving to (X, Y) at SPEED`: it stays where it has come to.
struct Light {
    Name name;
    Vector at;
    Vector to;
    double speed = 0;  ///< cm/s; 0: it does not move

    /// `time`: since it was at `at`.
    [[nodiscard]] Vector position(double time) const;
    diagnostics::Span span;
};

/// A light at one time.
struct LightNow {
    Vector at;
    bool on = true;
};

/// `obstacle NAME CORNER, ... absent`: a polygon that can come and go. Those without a name are part of the arena.
struct Obstacle {
    Name name;
    std::vector<Vector> corners;  ///< at least three, in order
    bool there = true;            ///< at the start
};

struct Placement {
    enum class Kind { pose, region, square, arena, linked };
    Kind kind = Kind::pose;
    Pose pose;        ///< of one robot; square: its centre; linked: where the first one is
    Region region;    ///< at random in it
    double area = 0;  ///< square: of each robot
    double link = 0;  ///< linked: each is at most this far, centre to centre, from one that was placed before
    diagnostics::Span span;
};

enum class MeasureKind { cluster, spread, second_moment, distance, reached, inside, in_state, working, time };

[[nodiscard]] Dimension dimension_of(MeasureKind);

/// `measure NAME is KIND(ARGUMENT) of ROBOTS`.
struct Measure {
    Name name;
    MeasureKind kind = MeasureKind::spread;
    double link = 0;        ///< cluster: centres at most this far apart belong together; reached: from the light
    std::size_t light = 0;  ///< distance: from the swarm's centroid to this light; reached: the light
    Name state;             ///< in_state: of the first machine
    std::vector<std::uint16_t> states;   ///< its number, and those of the states in it; known with the controller
    Region region = {};                  ///< inside
    std::optional<std::size_t> of = {};  ///< the robots of this kind alone (Scenario::kind_at)
};

/// What a robot loses: `whole` its controller and all of the others.
enum class FailureKind { whole, motors, radio, sensors };

/// `failure of KIND at TIME in N robots`, or `failure of KIND with mean time TIME`.
struct Failure {
    FailureKind kind = FailureKind::whole;
    double at = 0;             ///< s
    std::uint32_t robots = 0;  ///< the first so many, in the order of placements
    double mean_time = 0;      ///< s; not 0: of every robot, after a time of its own, exponentially distributed
    diagnostics::Span span;
};

/// What holds or not at an instant, or over a trial. Instants are the ends of control steps, and the start.
struct Formula {
    enum class Kind {
        compare,   ///< of an instant: a measure lies between `low` and `high`
        stays,     ///< of an instant: the part has held without a break for `time`
        at,        ///< of a trial, from here on: the part, of an instant, holds at `time`
        within,    ///< at some instant up to `time`
        until,     ///< the second part holds at some instant up to `time`, the first at every one before
        always,    ///< at every instant
        negation,  ///< of what its parts are of, from here on
        both,
        either,
    };
    Kind kind = Kind::compare;
    std::size_t measure = 0;
    double low = 0;
    double high = 0;
    double time = 0;
    std::vector<Formula> parts;

    /// Else of an instant.
    [[nodiscard]] bool of_trial() const;
};

enum class StatisticKind { at_time, first_time, average, final };

struct Statistic {
    StatisticKind kind = StatisticKind::final;
    std::size_t measure = 0;
    double time = 0;    ///< at_time
    Formula condition;  ///< first_time: of an instant
};

/// `accept each|mean STATISTIC in LOW to HIGH`.
struct Band {
    Statistic statistic;
    bool each = true;  ///< every trial by itself, else the mean of all
    double low = 0;
    double high = 0;
    std::string text;  ///< as written
    diagnostics::Span span;
};

/// `accept probability PROPERTY >= SHARE with confidence SHARE`, or `estimate probability PROPERTY with ...`.
struct Claim {
    Formula property;       ///< of a trial
    bool estimate = false;  ///< nothing is claimed: an interval after the trials of the scenario
    bool at_least = true;   ///< else at most
    double probability = 0;
    double confidence = 0;
    double indifference = 0;        ///< 0: by intervals; else by a test that does not tell probabilities so close apart
    std::uint32_t trials = 10'000;  ///< at most; of an estimate exactly
    bool limited = false;           ///< `at most N trials` is said
    std::string text;               ///< as written
    diagnostics::Span span;
};

enum class Varied { robots, noise, constant, sensor, failed, mean_time };

/// `vary robots in 1 to 30`.
struct Variation {
    Varied what = Varied::robots;
    std::string constant;        ///< of the model, its name; sensor: the name of one
    std::string option;          ///< sensor: "error", "loss"
    std::vector<double> values;  ///< ascending, without repetition
    bool until_proved = false;   ///< the first variation: up to the first value at which the claims are proved
    diagnostics::Span span;
};

/// What a chain tells apart of a measure: a share by each number of robots that it can be of, or by levels, up to and
/// with each of which, and above the last, is one class.
struct Distinction {
    std::size_t measure = 0;
    std::vector<double> levels;  ///< ascending; none: each number of robots
};

/// What only a chain answers: the mean time until a condition holds first, or what a measure is on average in the long
/// run.
struct ChainQuestion {
    bool time = true;   ///< else the average of `measure`
    Formula condition;  ///< of an instant
    std::size_t measure = 0;
    double confidence = 0;
    std::string text;  ///< as written
    diagnostics::Span span;
};

/// `abstract by MEASURE in LEVELS, ... every TIME`: a Markov chain over what is distinguished of the swarm.
struct Abstraction {
    std::vector<Distinction> distinctions;
    double every = 0;  ///< s between two states, a whole number of control steps
    diagnostics::Span span;
};

/// `feed EVENT with MEASURE in UNIT` or `feed EVENT with CONDITION`, of an environment.
struct WorldFeed {
    Name target;
    std::size_t measure = 0;
    double factor = 1;                 ///< the measure is divided by it
    std::optional<Formula> condition;  ///< of an instant; in place of the measure
    std::string text;                  ///< "when close >= 51 %", "with close in %"
    diagnostics::Span span;
};

/// What a command of an environment does to the world.
struct WorldAct {
    enum class Kind { light_on, light_off, light_move, obstacle_appear, obstacle_vanish, failure, stimulus };
    Kind kind = Kind::light_on;
    std::size_t what = 0;      ///< light, obstacle: which
    std::optional<Vector> to;  ///< light_move: there; none: to the two arguments of the command
    double factor = 1;         ///< the arguments are multiplied by it
    double speed = 0;          ///< light_move, cm/s
    Failure failure;           ///< of so many robots that still work, drawn at random
    Stimulus stimulus;
    Name on;  ///< an operation or an output event of the environment's component
    diagnostics::Span span;
};

/// What a generated controller is made of, and its constants.
struct Controlled {
    Name component;
    std::string
        model;  ///< path of the model, relative to the scenario's folder; "": that of the scenario, or its folder
    std::vector<std::string> constants;  ///< NAME=VALUE
    std::vector<Name> ignored;           ///< events and operations with which the scenario does nothing, on purpose
};

/// Where robots of another kind drive otherwise than those of the first; none: the same. All disks are of one size.
struct OwnDrive {
    std::optional<double> axle, max_wheel, noise;
};

/// Robots with one controller: how many, where they begin, and what their platform consists of.
struct RobotKind : Controlled {
    Name kind;  ///< "" where there is no other
    std::uint32_t robots = 0;
    OwnDrive own;  ///< of the first kind: nothing, its body is that of the world's options
    std::vector<Placement> placements;
    std::vector<Feed> feeds;
    std::vector<Drive> drives;
    std::vector<Stimulus> stimuli;
    std::vector<Failure> failures;
};

/// `environment COMPONENT { ... }`: a controller without a body, whose inputs are what measures say of the world and
/// whose commands act on it.
struct Environment : Controlled {
    std::vector<WorldFeed> feeds;
    std::vector<WorldAct> acts;
};

/// The scenario is its first kind of robots too; most scenarios have no other.
struct Scenario : RobotKind {
    Name name;
    std::vector<RobotKind> others;  ///< their robots come behind those of the first kind, in this order
    std::optional<Environment> environment;
    WorldOptions world;
    double arena_area = 0;  ///< of each robot, in a square arena; 0: its sides are given
    double time_unit = 0;   ///< seconds of one time unit of the model
    std::uint32_t units_per_step = 1;
    double duration = 0;
    std::uint32_t trials = 1;
    std::uint64_t seed = 1;
    std::vector<Light> lights;
    std::vector<Obstacle> obstacles;  ///< those with a name
    std::vector<Sensor> sensors;
    std::vector<Actuator> actuators;
    std::vector<Measure> measures;
    std::vector<Band> bands;
    std::vector<Claim> claims;
    std::vector<Variation> variations;  ///< at most two
    std::optional<Abstraction> abstraction;
    std::vector<ChainQuestion> chain_questions;
    std::vector<std::string> drawings;  ///< texts of the files that obstacles come from
    std::vector<double> pictures;       ///< times, s
    double record = 0.5;                ///< s between recorded positions

    [[nodiscard]] std::uint64_t steps() const;
    /// Control steps between two states of the chain.
    [[nodiscard]] std::uint64_t steps_apart() const;
    /// Another number of trials, for bands and estimates.
    void set_trials(std::uint32_t count);
    /// Another number of robots of the first kind, with an arena for all.
    void set_robots(std::uint32_t count);

    /// How many kinds of robots there are, and each of them: the first is the scenario itself.
    [[nodiscard]] std::size_t kinds() const { return 1 + others.size(); }
    [[nodiscard]] const RobotKind& kind_at(std::size_t number) const {
        return number == 0 ? static_cast<const RobotKind&>(*this) : others[number - 1];
    }
    /// The body of robots of a kind.
    [[nodiscard]] Body body_of(std::size_t number) const;
    /// How many controllers there are: one for each kind of robots, and behind them that of the environment.
    [[nodiscard]] std::size_t controllers() const { return kinds() + (environment ? 1 : 0); }
    [[nodiscard]] const Controlled& controller_at(std::size_t number) const {
        return number < kinds() ? static_cast<const Controlled&>(kind_at(number)) : *environment;
    }
    /// "leaders" of the kind that is called so, "environment"; "" of a first kind without a name.
    [[nodiscard]] std::string controller_name(std::size_t number) const;
    /// Robots of all kinds.
    [[nodiscard]] std::uint32_t all_robots() const;
    /// The number of the first robot of a kind.
    [[nodiscard]] std::uint32_t first_robot(std::size_t number) const;
    /// Has it several kinds of robots, or an environment?
    [[nodiscard]] bool has_others() const { return !others.empty() || environment.has_value(); }
};

/// The number of a kind by its name.
[[nodiscard]] std::optional<std::size_t> kind_named(const Scenario&, std::string_view name);
/// The number of a controller: by the name of its kind, or "environment".
[[nodiscard]] std::optional<std::size_t> controller_named(const Scenario&, std::string_view name);
/// The names of all controllers that have one.
[[nodiscard]] std::vector<std::string> controller_names(const Scenario&);

/// A constant of one of a scenario's models, as `--const` and `vary const` name it: "pace" of the first kind of robots,
/// "leaders.pace" of those that are called leaders, "environment.pace".
struct AddressedConstant {
    std::size_t controller = 0;
    std::string constant;  ///< "pace", "Keep::pace"
};
/// None where there is no controller of the name in front of the point.
[[nodiscard]] std::optional<AddressedConstant> addressed(const Scenario&, const std::string& name);

}  // namespace robochart::simulation
