// One random path of a dtmc, state by state, without exploring anything else.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "checker/prism/explore/commands.hpp"
#include "checker/prism/explore/instance.hpp"
#include "checker/prism/sampling/draws.hpp"

namespace robochart::prism {

/// The values of the variables in the initial state of a dtmc that paths are sampled from. Throws Unsampled where it is
/// no dtmc, or there are several; EvaluationError, LimitReached.
[[nodiscard]] std::vector<std::int32_t> sampled_from(const Instance& instance, Code& code, diagnostics::Budget* budget);

/// A path: all combinations of enabled commands of a state are equally likely, as docs/probability.md, "Semantics", has
/// it. Probabilities are taken as doubles, so that a draw errs by at most 2^-52.
class Walk {
public:
    /// All of them outlive it. Warnings go to `diagnostics`. `initial`: the values of the variables.
    Walk(const Instance& instance, Code& code, std::vector<std::int32_t> initial,
         diagnostics::Diagnostics& diagnostics);

    // Throw EvaluationError.
    /// Back to the initial state, with other draws.
    void begin(const Draws& draws);
    /// Draws which commands act next: their action, as an index into `actions`; nothing in a deadlock.
    std::optional<std::uint32_t> choose();
    /// They act: on to the next state. A deadlock stays where it is.
    void step();

    /// The modules whose commands were drawn, by their names.
    [[nodiscard]] std::vector<std::string> movers() const;

    /// The values of the state, with those behind them that Instance::code has names for.
    [[nodiscard]] StateValues state() const { return values_.data(); }
    /// How many steps were made.
    [[nodiscard]] std::uint64_t length() const { return length_; }
    [[nodiscard]] const std::vector<std::string>& actions() const { return commands_.actions(); }
    /// Where the path is known to have no more choice, so that it repeats its last states for ever: how many.
    [[nodiscard]] std::optional<std::uint64_t> period() const { return period_; }

private:
    void arrive();
    [[nodiscard]] std::uint64_t combinations(const CommandTable::Act& act) const;
    const Effect& draw_effect(std::uint32_t command);
    double probability(NumberTable::Id id);
    void watch_for_repetition();

    const Instance& instance_;
    NumberTable numbers_;
    std::vector<double> doubles_;  ///< of `numbers_`
    CommandTable commands_;
    LeftOut left_out_;
    const std::vector<std::int32_t> initial_;
    std::size_t variables_;
    Draws draws_{0, 0};
    std::vector<std::int32_t> values_;
    std::uint64_t length_ = 0;
    std::uint64_t enabled_ = 0;               ///< combinations
    const CommandTable::Act* act_ = nullptr;  ///< what was drawn; null: nothing
    std::vector<std::uint32_t> chosen_;       ///< commands
    bool forced_ = true;                      ///< the last step was the only one possible
    // Brent, An improved Monte Carlo factorization algorithm, BIT 20, 1980: a state to compare with, renewed after
    // twice as many steps each time.
    std::vector<std::int32_t> anchor_;
    std::uint64_t anchored_at_ = 0, patience_ = 1;
    std::optional<std::uint64_t> period_;
};

}  // namespace robochart::prism
