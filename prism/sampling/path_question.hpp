// SPDX-License-Identifier: Apache-2.0
// Evaluates P and R queries on one path.
#pragma once

#include <cstdint>
#include <optional>

#include "prism/sampling/path_formula.hpp"
#include "prism/sampling/path_rewards.hpp"
#include "prism/sampling/walk.hpp"

namespace robochart::prism {

/// The result of one path.
struct Sample {
    bool decided = false;     ///< decided within the maximal number of steps
    double value = 0;         ///< for a formula 1 or 0; otherwise the reward, which may be infinite
    std::uint64_t steps = 0;  ///< number of steps after which the value was known
};

class PathQuestion {
public:
    /// `question` is P [ path ], or R [ F state ], [ C<=k ], [ I=k ]. Labels must have been replaced, except for
    /// "deadlock" and "init". `walk` must use the model of `code`. Throws Unsampled, EvaluationError.
    PathQuestion(const Expr& question, const Instance& instance, Code& code, Walk& walk);

    /// Follows a path for at most `most_steps` steps. Throws EvaluationError, LimitReached.
    [[nodiscard]] Sample follow_path(const Draws& draws, std::uint64_t most_steps, diagnostics::Budget* budget);

private:
    [[nodiscard]] std::optional<double> known_answer();

    const Instance& instance_;
    Walk& walk_;
    Op kind_;                             ///< probability, eventually, cumulative, instantaneous
    std::optional<PathFormula> formula_;  ///< for the first two kinds
    std::optional<PathRewards> rewards_;  ///< for the last three kinds
    std::uint64_t steps_ = 0;             ///< for the last two kinds
    double earned_ = 0;
};

}  // namespace robochart::prism
