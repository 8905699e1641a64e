// SPDX-License-Identifier: Apache-2.0
// See path_question.hpp.
#include "prism/sampling/path_question.hpp"

#include <limits>

#include "prism/sampling/unsampled.hpp"

namespace robochart::prism {

PathQuestion::PathQuestion(const Expr& question, const Instance& instance, Code& code, Walk& walk)
    : instance_(instance), walk_(walk), kind_(question.op) {
    if (question.op != Op::probability && question.op != Op::reward)
        throw Unsampled("samples answer only P [ ... ] and R [ ... ], without an expression around them");
    const ExprPtr& body = question.parts[0];
    if (question.op == Op::probability) {
        formula_.emplace(body, code);
        return;
    }
    kind_ = body->op;
    if (kind_ == Op::cumulative || kind_ == Op::instantaneous)
        steps_ = step_number(body->parts[0], code);
    else if (kind_ == Op::eventually && !body->steps && !is_path(*body->parts[0]))
        formula_.emplace(body, code);
    else
        throw Unsampled("samples answer R of F of states, of C<=k and of I=k");
    const CheckedModel& model = instance.model();
    rewards_.emplace(model.rewards[reward_index(*question.query, model, code)], walk.actions(), code);
}

Sample PathQuestion::follow_path(const Draws& draws, std::uint64_t most_steps, diagnostics::Budget* budget) {
    walk_.begin(draws);
    if (formula_) formula_->start_path();
    earned_ = 0;
    try {
        while (true) {
            if (budget != nullptr) budget->poll();
            if (const std::optional<double> known = known_answer()) return {true, *known, walk_.length()};
            if (walk_.length() == most_steps) return {false, 0, walk_.length()};
            const std::optional<std::uint32_t> action = walk_.choose();
            if (rewards_) earned_ += rewards_->of_state(walk_.state());
            if (rewards_ && action) earned_ += rewards_->of_step(walk_.state(), *action);
            walk_.step();
        }
    } catch (EvaluationError& error) {
        if (error.state.empty()) error.state = instance_.layout().state_text(walk_.state());
        throw;
    }
}

/// Returns the answer of the path in its current state, if it is known.
std::optional<double> PathQuestion::known_answer() {
    if (kind_ == Op::cumulative) return walk_.length() == steps_ ? std::optional(earned_) : std::nullopt;
    if (kind_ == Op::instantaneous)
        return walk_.length() == steps_ ? std::optional(rewards_->of_state(walk_.state())) : std::nullopt;
    formula_->observe_state(walk_.state());
    if (walk_.loop_period()) formula_->end_in_loop(*walk_.loop_period());
    const std::optional<bool> holds = formula_->holds();
    if (!holds) return std::nullopt;
    if (kind_ == Op::probability) return *holds ? 1.0 : 0.0;
    return *holds ? earned_ : std::numeric_limits<double>::infinity();
}

}  // namespace robochart::prism
