// SPDX-License-Identifier: Apache-2.0
// Evaluates numbers in queries: bounds on the steps of paths, and the index of a reward structure.
#pragma once

#include <cstdint>
#include <optional>

#include "prism/checks/checked.hpp"
#include "prism/explore/code.hpp"

namespace robochart::prism {

/// An inclusive range of steps. Without `to` there is no upper bound.
struct StepRange {
    std::uint64_t from = 0;
    std::optional<std::uint64_t> to;
};

/// Evaluates a step bound. `F<k` is read as `F<=k-1`, and `F>k` as `F>=k+1`. Throws EvaluationError for a negative
/// number or an empty interval.
[[nodiscard]] StepRange step_range(const StepBound& steps, Code& code);
/// Evaluates a number of steps, which must not be negative.
[[nodiscard]] std::uint64_t step_number(const ExprPtr& expr, Code& code);
/// Evaluates the bound of P, S or R. Throws EvaluationError if the bound is negative, or if a probability exceeds 1.
[[nodiscard]] Real bound_of(const Expr& question, Code& code);
/// Returns the reward structure of an R query: by name, by number counted from 1, or the first one by default. Throws
/// EvaluationError.
[[nodiscard]] std::size_t reward_index(const Query& query, const CheckedModel& model, Code& code);

}  // namespace robochart::prism
