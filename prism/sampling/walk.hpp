// SPDX-License-Identifier: Apache-2.0
// Follows one random path of a dtmc, state by state, without exploring other states.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "prism/explore/commands.hpp"
#include "prism/explore/instance.hpp"
#include "prism/sampling/draws.hpp"

namespace robochart::prism {

/// Returns the values of the variables in the initial state of a dtmc. Throws Unsampled if the model is not a dtmc or
/// has several initial states. Also throws EvaluationError, LimitReached.
[[nodiscard]] std::vector<std::int32_t> sampled_from(const Instance& instance, Code& code, diagnostics::Budget* budget);

/// A random path. All combinations of enabled commands of a state are equally likely, as in docs/probability.md,
/// "Semantics". Probabilities are rounded to doubles, so the probability of a draw has an error of at most 2^-52.
class Walk {
public:
    /// All arguments must outlive the object. Warnings are reported to `diagnostics`. `initial` contains the values of
    /// the variables in the initial state.
    Walk(const Instance& instance, Code& code, std::vector<std::int32_t> initial,
         diagnostics::Diagnostics& diagnostics);

    // Returns to the initial state, with new random numbers. This function and the next two throw EvaluationError.
    void begin(const Draws& draws);
    /// Draws the commands that act next. Returns their action as an index into `actions`, or no value in a deadlock.
    std::optional<std::uint32_t> choose();
    /// Executes the drawn commands. A deadlock state does not change.
    void step();

    /// Returns the names of the modules whose commands were drawn.
    [[nodiscard]] std::vector<std::string> moving_modules() const;

    /// Returns the values of the state, followed by the booleans that Instance::code names.
    [[nodiscard]] StateValues state() const { return values_.data(); }
    /// Returns the number of steps so far.
    [[nodiscard]] std::uint64_t length() const { return length_; }
    [[nodiscard]] const std::vector<std::string>& actions() const { return commands_.actions(); }
    /// If all further steps of the path are determined, returns the number of states that repeat forever. Otherwise, or
    /// if this is not known yet, returns no value.
    [[nodiscard]] std::optional<std::uint64_t> loop_period() const { return period_; }

private:
    void find_enabled_combinations();
    [[nodiscard]] std::uint64_t combinations(const CommandTable::Act& act) const;
    const Effect& draw_effect(std::uint32_t command);
    double probability(NumberTable::Id id);
    void watch_for_repetition();

    const Instance& instance_;
    NumberTable numbers_;
    std::vector<double> doubles_;  ///< rounded from `numbers_`
    CommandTable commands_;
    LeftOut left_out_;
    const std::vector<std::int32_t> initial_;
    std::size_t variables_;
    Draws draws_{0, 0};
    std::vector<std::int32_t> values_;
    std::uint64_t length_ = 0;
    std::uint64_t enabled_ = 0;               ///< number of enabled combinations
    const CommandTable::Act* act_ = nullptr;  ///< the drawn synchronisation; null: none
    std::vector<std::uint32_t> chosen_;       ///< the drawn commands
    bool forced_ = true;                      ///< true if the last step was the only possible one
    // An earlier state with which each new state is compared. It is replaced each time after twice as many steps
    // (Brent, An improved Monte Carlo factorization algorithm, BIT 20, 1980).
    std::vector<std::int32_t> anchor_;
    std::uint64_t anchored_at_ = 0, patience_ = 1;
    std::optional<std::uint64_t> period_;
};

}  // namespace robochart::prism
