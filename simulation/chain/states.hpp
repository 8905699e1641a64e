// SPDX-License-Identifier: Apache-2.0
// Computes the states of a chain over a swarm, and the permitted transitions. A state contains the class of each
// measure that the scenario distinguishes. Robots are treated as exchangeable: only the numbers of robots in each robot
// state are stored (counter abstraction: Lomuscio and Pirovano, AAMAS 2019).
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "base/statistics/chains.hpp"
#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

/// The changes that a robot's own state can make between two states of the chain. A class is a set of bits: bit i is
/// set if the robot is in the state of the i-th distinction by `in_state`.
struct RobotSteps {
    std::vector<std::uint32_t> classes;    ///< ascending
    std::vector<bool> first;               ///< by class: true if a robot can start in it
    std::vector<std::vector<bool>> after;  ///< [from][to]: true if a robot in `from` can be in `to` one state later
};

/// Thrown if there are too many states, or too many distributions of robots over classes.
class TooManyStates : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A class of a measure. It contains one fraction of the robots, or the values above `low` up to `high`.
struct MeasureClass {
    bool share = false;
    std::uint32_t least = 0, most = 0;
    double low = 0, high = 0;  ///< the bounds of the class; for a fraction of the robots, its least and greatest value

    friend bool operator==(const MeasureClass&, const MeasureClass&) = default;
};

class ChainStates {
public:
    static constexpr std::size_t most_states = 500;
    static constexpr std::size_t most_distributions = 1000;  ///< limit for the ways to distribute robots over classes
    /// Represents no state.
    static constexpr std::size_t none = ~std::size_t{0};

    /// Computes the states for a scenario with an abstraction. The indices of the states must have been set in the
    /// scenario's measures. If the steps of a robot are given, the result contains only states that the robot's classes
    /// permit. Throws TooManyStates.
    ChainStates(const Scenario&, std::optional<RobotSteps>);

    /// The state in which every trial begins. It comes before the first state of the swarm.
    static constexpr std::size_t start = 0;
    /// Returns the number of states, including the start state.
    [[nodiscard]] std::size_t size() const { return states_.size() + 1; }
    /// Returns the state for the values of a sample, or `none` if there is no such state.
    [[nodiscard]] std::size_t find_state(const std::vector<double>& sample) const;
    /// Returns a text such as "searching 3 of 10, way 50 to 100 cm".
    [[nodiscard]] std::string state_text(std::size_t state) const;
    /// Returns the class of a measure in a state. Returns no value for the start state, or if the scenario does not
    /// distinguish the measure.
    [[nodiscard]] std::optional<MeasureClass> class_of_measure(std::size_t state, std::size_t measure) const;
    /// Returns, for each state, whether the condition is true in it (false in the start state). Returns no value if
    /// some state does not determine whether the condition is true.
    [[nodiscard]] std::optional<std::vector<bool>> states_satisfying(const Formula& condition) const;
    /// Returns the permitted transitions. The robots' steps restrict changes of robot numbers; other measures may
    /// change without restriction. A robot's steps allow a change of the numbers if and only if every set of classes
    /// satisfies a condition: the number of robots in the set is at most the number of robots in its successors
    /// afterwards (Hall's theorem for transports). If the steps allow no successor of a state, all successors are
    /// permitted, because a proof that time stops does not apply to code that continues.
    [[nodiscard]] statistics::Permitted permitted_transitions(diagnostics::Budget* = nullptr) const;

private:
    /// For each distinction, the index of its class.
    using Tuple = std::vector<std::size_t>;
    /// The number of robots in each class of a robot.
    using Distribution = std::vector<std::uint32_t>;

    void find_classes(const Distinction&);
    void find_distributions(const std::vector<std::uint32_t>& classes);
    void add_distributions(Distribution& so_far, std::size_t at, std::uint32_t left);
    void find_states(std::size_t at, Tuple& so_far);
    /// Returns the classes of the distinctions by `in_state` for these robots, and 0 for all other distinctions.
    [[nodiscard]] Tuple project_distribution(const Distribution&, const std::vector<std::uint32_t>& classes) const;
    [[nodiscard]] bool is_admitted(const Tuple&) const;
    [[nodiscard]] Tuple robots_in(const Tuple&) const;
    [[nodiscard]] bool admits_step(const Distribution& before, const Distribution& behind) const;
    [[nodiscard]] std::optional<bool> holds_in(const Formula&, std::size_t state) const;
    [[nodiscard]] bool is_in_state(std::size_t distinction) const;

    const Scenario& scenario_;
    std::optional<RobotSteps> steps_;
    std::vector<std::vector<MeasureClass>> classes_;  ///< the classes of each distinction
    std::vector<Distribution> distributions_;
    std::vector<Tuple> distributed_;  ///< the projection of each distribution
    std::vector<Tuple> admitted_;     ///< the projections, ascending, without duplicates
    std::vector<Tuple> states_;       ///< ascending
};

/// Returns the classes of a robot whose steps are not known: those of all states of the machine, and of the time
/// between states.
[[nodiscard]] std::vector<std::uint32_t> robot_classes(const Scenario&);

}  // namespace robochart::simulation
