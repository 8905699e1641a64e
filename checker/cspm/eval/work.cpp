// SPDX-License-Identifier: Apache-2.0
// Counts steps, and adds the call stack to errors.
#include "checker/cspm/eval/work.hpp"

#include "base/diagnostics/budget.hpp"

namespace robochart::cspm {

EvaluationError Work::error_at(const std::string& message, Span span) const {
    constexpr std::size_t shown = 30;
    std::vector<std::string> stack;
    for (auto call = activations_.rbegin(); call != activations_.rend() && stack.size() < shown; ++call) {
        std::string line = call->function->name;
        if (call->arguments != nullptr && !call->arguments->empty()) {
            text_.items(*call->arguments, "(", ", ", ")", line);
        }
        stack.push_back(std::move(line));
    }
    if (!span.is_known()) span = activations_.empty() ? prefix_place_ : activations_.back().function->span;
    for (auto call = activations_.rbegin(); call != activations_.rend() && !span.is_known(); ++call)
        span = call->called.is_known() ? call->called : call->function->span;
    return {message, span, std::move(stack)};
}

void Work::fail(const std::string& message, Span span) const {
    if (given_up_at_ != no_end) throw EvaluationError(message, span, {});  // the error may never be reported
    throw error_at(message, span);
}

void Work::not_supported(const std::string& what, Span span) const {
    fail(what + " is not supported", span);
}

void Work::count_step(Span span) {
    if (++steps_ > max_steps) fail("evaluation takes too long (2000000000 steps): runaway recursion?", span);
    if ((steps_ & 255U) == 0) poll_budget(span);
    if (steps_ > given_up_at_) throw GivenUp{};
    const char* here = static_cast<const char*>(__builtin_frame_address(0));
    if (static_cast<std::size_t>(stack_base_ - here) > stack_bytes_) {
        fail("evaluation nests too deeply: runaway recursion?", span);
    }
}

void Work::poll_budget(Span span) {
    try {
        budget_->poll();
    } catch (const diagnostics::LimitReached&) {
        if (steps_ >= many_steps) stopped_ = error_at("the evaluation had not ended", span);
        throw;
    }
}

}  // namespace robochart::cspm
