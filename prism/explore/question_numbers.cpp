// SPDX-License-Identifier: Apache-2.0
// See question_numbers.hpp.
#include "prism/explore/question_numbers.hpp"

#include <fmt/format.h>

#include "prism/explore/rules.hpp"

namespace robochart::prism {

std::uint64_t step_number(const ExprPtr& expr, Code& code) {
    const std::int64_t value = code.integer(code.compile(expr), nullptr);
    if (value < 0)
        throw EvaluationError(rules::bad_steps, expr->span, {fmt::format("{} is not a number of steps", value)});
    return static_cast<std::uint64_t>(value);
}

StepRange step_range(const StepBound& steps, Code& code) {
    std::uint64_t low = steps.low ? step_number(steps.low, code) : 0;
    if (steps.low_strict) ++low;
    if (!steps.high) return {low, std::nullopt};
    std::uint64_t high = step_number(steps.high, code);
    if (steps.high_strict) {
        if (high == 0) throw EvaluationError(rules::bad_steps, steps.high->span, {"no number of steps is below 0"});
        --high;
    }
    if (low > high)
        throw EvaluationError(rules::bad_steps, steps.high->span,
                              {fmt::format("the interval of steps from {} to {} is empty", low, high)});
    return {low, high};
}

Real bound_of(const Expr& question, Code& code) {
    const ExprPtr& expr = question.query->bound;
    Real bound = code.real(code.compile(expr), nullptr);
    const bool above_one = question.op != Op::reward && bound.compare(Real(std::int64_t{1})) == 1;
    if (bound.compare(Real(std::int64_t{0})) == -1 || above_one)
        throw EvaluationError(rules::bad_bound, expr->span, {bound.text()});
    return bound;
}

std::size_t reward_index(const Query& query, const CheckedModel& model, Code& code) {
    const auto& structures = model.rewards;
    if (query.reward_index) {
        const std::int64_t index = code.integer(code.compile(query.reward_index), nullptr);
        if (index < 1 || static_cast<std::size_t>(index) > structures.size())
            throw EvaluationError(
                rules::bad_steps, query.reward_index->span,
                {fmt::format("there is no reward structure {}: the model has {}", index, structures.size())});
        return static_cast<std::size_t>(index - 1);
    }
    std::size_t index = 0;
    if (!query.reward.text.empty())
        while (structures[index].name.text != query.reward.text) ++index;
    return index;
}

}  // namespace robochart::prism
