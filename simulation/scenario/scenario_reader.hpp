// SPDX-License-Identifier: Apache-2.0
// Declares the parser of scenarios (private to this component). It has one method for each item. Comments below name
// the files that contain the definitions.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/durations/time_unit.hpp"
#include "simulation/scenario/scenario.hpp"
#include "simulation/scenario/scenario_words.hpp"
#include "simulation/scenario/sensor_readings.hpp"

namespace robochart::simulation {

class ScenarioReader {
public:
    ScenarioReader(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                   diagnostics::Diagnostics& diagnostics, durations::Unit declared)
        : path_(sources.path(source)), in_(sources, source, diagnostics), whole_{source, 0, 0}, declared_(declared) {}

    Scenario read();

private:
    static constexpr std::uint64_t most_robots_ = 100'000;
    using Item = void (ScenarioReader::*)();
    struct ItemRow {
        std::string_view word;
        bool once;
        Item read;
    };
    /// A point that must be in the arena.
    struct Inside {
        Vector at;
        const char* what;
        diagnostics::Span span;
    };

    // scenario.cpp: times, the arena and its contents
    static const std::array<ItemRow, 28>& item_table();
    void parse_item();
    void parse_model();
    void parse_step();
    void parse_physics();
    void time_unit();
    void parse_duration();
    void parse_trials();
    void parse_seed();
    void parse_record();
    void parse_arena();
    /// Parses `with AREA per robot`.
    double area_per_robot();
    Region parse_region();
    void parse_wall();
    void parse_light();
    Name new_name(std::string_view what);
    void parse_placement();
    void parse_pictures();

    // scenario_kinds.cpp: kinds of robots and the environment
    void parse_robots();
    void robot_option();
    /// Parses `axle`, `wheel` or `noise`; returns false for other options.
    bool drive_option(OwnDrive&);
    void other_radius();
    /// Parses `for COMPONENT { ... }`, after the name of a further kind.
    void other_kind(RobotKind kind, diagnostics::Span begin);
    void parse_constant(Controlled& controlled);
    void ignore() { ignore_in(*kind_); }
    void ignore_in(Controlled& controlled);
    void parse_environment();
    void world_feed();
    void world_drive();
    void unknown_subject(const Name& name);
    void world_stimulus();
    void world_failure();
    /// Parses `on COMMAND` at the end of an effect of the environment, and adds the effect.
    void add_act(WorldAct act, diagnostics::Span begin);
    [[nodiscard]] std::size_t kind_of_measure(const Name& name);

    // scenario_ports.cpp: sensors, actuators, and their connections to the controller
    void parse_sensor();
    void parse_option(Sensor& sensor, bool known);
    void parse_actuator();
    void parse_feed();
    /// Skips the rest of the item after an unknown sensor or reading, because the form of the item is unknown.
    void skip_feed();
    void skip_word();
    const ReadingRow* find_reading(const Feed& feed, const Name& reading);
    /// True if the feed reads messages of a sensor that sends none.
    [[nodiscard]] bool in_sensor_without_message(const Feed& feed) const;
    [[nodiscard]] bool is_actuator_name(const std::string& name) const;
    void parse_argument(Feed& feed, const ReadingRow& row);
    void parse_drive();
    void unknown_part(const std::string& what, const Name& name, const std::vector<std::string>& known);
    void parse_speeds(Drive& drive);
    void parse_forward(Drive& drive);
    /// Parses `turn(12.8 cm/s, deg)`: the wheel speed, and the unit of the operation's argument.
    void parse_turn(Drive& drive);
    void parse_stimulus();
    /// Parses the event and its value, if it has one.
    Stimulus parse_raised_event();
    /// Parses `seek(NAME, SPEED)` or `wander(SPEED)`.
    void parse_seek(Drive& drive);

    // scenario_world.cpp: failures and obstacles
    void parse_failure();
    void parse_obstacle();
    /// Parses `obstacles "FILE.svg" with LENGTH per unit`.
    void parse_drawn_obstacles();
    void add_obstacle(std::vector<Vector> corners, diagnostics::Span span);
    [[nodiscard]] std::optional<FailureKind> failure_kind();

    // scenario_bands.cpp: measures and bands
    void parse_measure();
    std::size_t light_named(const Name& name);
    [[nodiscard]] Dimension dimension_of(std::size_t measure) const;
    /// True if the next tokens are `claim NAME`, which is a condition on the run of every robot.
    [[nodiscard]] bool at_claim() const;
    /// Parses `claim NAME`. Returns the index of a measure: the fraction of robots whose run satisfies the claim.
    std::size_t claim_measure();
    std::size_t measure_named();
    void accept();
    /// Parses `first(CONDITION)`, `average(M)`, `M at TIME` or `M`. Returns the statistic's dimension.
    Dimension parse_statistic(Statistic& statistic);
    /// Parses `<= Q`, `>= Q` or `in Q to Q`.
    void parse_range(Dimension dimension, double& low, double& high);

    // scenario_claims.cpp: claims and formulas
    void parse_claim(diagnostics::Span begin, bool estimate);
    double parse_confidence();
    /// Parses `estimate probability PROPERTY with confidence SHARE`.
    void parse_estimate();
    Formula parse_disjunction();
    Formula parse_conjunction();
    Formula parse_timed();
    Formula parse_simple();
    Formula parse_comparison();
    Formula join_formulas(Formula::Kind kind, std::string_view word, Formula left, Formula right);
    /// Makes a condition on a trial from a condition on an instant.
    Formula lift_to_trial(Formula::Kind kind, std::string_view word, Formula part, double time);
    [[nodiscard]] bool at_time_word() const;
    double time_limit(std::string_view what);

    // scenario_variations.cpp: what a sweep varies
    void parse_variation();
    std::string constant_named();
    void parse_values(Variation& variation);
    double value_of(Varied what);
    /// Parses `SENSOR.OPTION`.
    void sensor_option(Variation& variation);

    // scenario_abstraction.cpp: the states of a chain and the questions that only it answers
    void parse_abstraction();
    /// Parses a distinction. Returns true if another one follows.
    bool parse_distinction(Abstraction& abstraction);
    /// Parses `time until CONDITION` or `average MEASURE`, `with confidence SHARE`.
    void chain_question(diagnostics::Span begin);
    void check_abstraction();
    void check_failures();

    // scenario_checks.cpp: consistency
    void check_scenario();
    void set_unit();
    [[nodiscard]] diagnostics::Span span_of_item(std::string_view word) const;
    /// Returns the quotient of `whole` and `part`. Reports a finding if the quotient is not a whole number.
    std::uint64_t divide_evenly(double whole, const char* whole_name, double part, const char* part_name,
                                std::string_view word);
    void check_steps();
    void check_places();
    void check_lights();

    std::string path_;  ///< the path of the scenario
    Reader in_;
    Scenario scenario_;
    RobotKind* kind_ = &scenario_;  ///< the kind whose feeds, drives, places, stimuli and failures are being parsed
    diagnostics::Span whole_;
    diagnostics::Span robots_span_;
    durations::Unit declared_;  ///< the time unit of the project
    double physics_ = 0;
    std::map<std::string, diagnostics::Span, std::less<>> said_;
    std::map<std::string, diagnostics::Span> names_;
    std::vector<std::string> unknown_sensors_;
    std::vector<Inside> inside_;
    std::vector<std::pair<double, diagnostics::Span>> times_;  ///< times that must be before the end
    std::size_t depth_ = 0;                                    ///< the depth of the formula being parsed
};

}  // namespace robochart::simulation
