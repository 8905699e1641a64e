// The states of a chain over a swarm, and which of them may follow each other. A state says of each measure that the
// scenario tells apart in which of its classes it is. Robots are taken for exchangeable: of their own states only
// numbers are kept (counter abstraction: Lomuscio and Pirovano, AAMAS 2019).
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "diagnostics/budget.hpp"
#include "simulation/scenario/scenario.hpp"
#include "statistics/chains.hpp"

namespace robochart::simulation {

/// Which states of a robot may follow which between two states of the chain. A class is a set of bits: bit i, whether
/// the robot is in the state of the i-th distinction by `in_state`.
struct RobotSteps {
    std::vector<std::uint32_t> classes;    ///< ascending
    std::vector<bool> first;               ///< of each class: a robot may begin in it
    std::vector<std::vector<bool>> after;  ///< [from][to]
};

/// More states, or ways to distribute the robots, than a chain is made of.
class TooManyStates : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A class of a measure: a share of so many robots, or values above `low` up to `high`.
struct MeasureClass {
    bool share = false;
    std::uint32_t least = 0, most = 0;
    double low = 0, high = 0;  ///< of a share, its least and its greatest value

    friend bool operator==(const MeasureClass&, const MeasureClass&) = default;
};

class ChainStates {
public:
    static constexpr std::size_t most_states = 500;
    static constexpr std::size_t most_distributions = 1000;  ///< of robots over their classes
    /// Not a state.
    static constexpr std::size_t none = ~std::size_t{0};

    /// Of a scenario with an abstraction, whose measures know the numbers of their states. With the steps of a robot
    /// only those that its classes admit. Throws TooManyStates.
    ChainStates(const Scenario&, std::optional<RobotSteps>);

    /// The state in which every trial begins, before the first one of the swarm.
    static constexpr std::size_t start = 0;
    /// With the start.
    [[nodiscard]] std::size_t size() const { return states_.size() + 1; }
    /// Of the values of a sample; `none`: of no state.
    [[nodiscard]] std::size_t of(const std::vector<double>& sample) const;
    /// "searching 3 of 10, way 50 to 100 cm".
    [[nodiscard]] std::string text(std::size_t state) const;
    /// The class of a measure in a state; nothing where it is not distinguished, or at the start.
    [[nodiscard]] std::optional<MeasureClass> measure(std::size_t state, std::size_t measure) const;
    /// Of each state, whether the condition holds in it, false at the start; nothing where a state does not tell.
    [[nodiscard]] std::optional<std::vector<bool>> holding(const Formula& condition) const;
    /// The transitions that may be: those of robots as their steps say, everything else of measures. A robot's steps
    /// admit a change of the numbers exactly if for every set of classes no more robots are in it than in its
    /// successors afterwards (Hall's theorem for transports). Where they admit nothing behind a state, everything may
    /// be: a proof that time stops says nothing of code that goes on.
    [[nodiscard]] statistics::Permitted permitted(diagnostics::Budget* = nullptr) const;

private:
    /// A class of each distinction.
    using Tuple = std::vector<std::size_t>;
    /// Robots in each class of a robot.
    using Distribution = std::vector<std::uint32_t>;

    void find_classes(const Distinction&);
    void find_distributions(const std::vector<std::uint32_t>& classes);
    void distribute(Distribution& so_far, std::size_t at, std::uint32_t left);
    void find_states(std::size_t at, Tuple& so_far);
    /// The classes of the distinctions by `in_state` with these robots; of the others 0.
    [[nodiscard]] Tuple projected(const Distribution&, const std::vector<std::uint32_t>& classes) const;
    [[nodiscard]] bool fits(const Tuple&) const;
    [[nodiscard]] Tuple robots_in(const Tuple&) const;
    [[nodiscard]] bool admits(const Distribution& before, const Distribution& behind) const;
    [[nodiscard]] std::optional<bool> holds(const Formula&, std::size_t state) const;
    [[nodiscard]] bool is_in_state(std::size_t distinction) const;

    const Scenario& scenario_;
    std::optional<RobotSteps> steps_;
    std::vector<std::vector<MeasureClass>> classes_;  ///< of each distinction
    std::vector<Distribution> distributions_;
    std::vector<Tuple> distributed_;  ///< of each distribution, its projection
    std::vector<Tuple> admitted_;     ///< these, each once, ascending
    std::vector<Tuple> states_;       ///< ascending
};

/// The classes of a robot whose states the scenario tells apart, where nothing is known of the model: of every state of
/// the machine, and between states.
[[nodiscard]] std::vector<std::uint32_t> robot_classes(const Scenario&);

}  // namespace robochart::simulation
