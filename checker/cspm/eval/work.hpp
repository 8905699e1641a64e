// SPDX-License-Identifier: Apache-2.0
// Limits an evaluation: the depth of its calls, its steps, and its steps for values that may not be needed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/cspm/eval/code.hpp"
#include "checker/cspm/eval/evaluation_error.hpp"
#include "checker/cspm/eval/value_text.hpp"
#include "checker/cspm/types/deep_stack.hpp"

namespace robochart::cspm {

/// The maximal number of elements in an explicit set.
inline constexpr std::size_t max_elements = 5'000'000;

/// Thrown if an early evaluation exceeds its limit (Speculation).
struct GivenUp {};

/// Owns the call stack and the counters.
class Work {
public:
    /// The maximal number of steps for one query of the search.
    static constexpr std::uint64_t max_steps = 2'000'000'000;
    /// How many bytes of an ordinary thread's stack an evaluation may use.
    static constexpr std::size_t small_stack_bytes = std::size_t{1} << 17U;

    Work(const Program& program, ValueStore& store) : text_(program), store_(store) {}

    /// Sets the budget that evaluations poll. The budget must outlive them.
    void set_budget(diagnostics::Pollable& budget) { budget_ = &budget; }
    /// Counts one more step.
    void count_step(Span span);
    /// Sets the prefix whose events are being computed. Errors without a place are reported there.
    void at_prefix(Span span) { prefix_place_ = span; }
    [[noreturn]] void fail(const std::string& message, Span span) const;
    /// Returns the innermost call with a known place if a limit has ended a long evaluation since the last call.
    [[nodiscard]] std::optional<EvaluationError> take_stopped() { return std::exchange(stopped_, std::nullopt); }
    [[noreturn]] void not_supported(const std::string& what, Span span) const;

    /// Returns true if no steps are left.
    [[nodiscard]] bool used_up() const { return steps_ > max_steps; }
    /// Returns true if values may be evaluated before they are needed.
    [[nodiscard]] bool may_speculate() const { return steps_ < promised_until_; }
    /// Returns the number of the current query from outside.
    [[nodiscard]] std::uint64_t question() const { return question_; }

    class Question;
    class Calling;
    class Speculation;

private:
    struct Activation {
        const Function* function = nullptr;
        const Values* arguments = nullptr;
        Span called;  ///< place of the call, if known; in generated scripts, a place in the model
    };
    static constexpr std::uint64_t no_end = ~std::uint64_t{0};
    /// If a limit stops an evaluation after this many steps, the evaluation is reported as the cause.
    static constexpr std::uint64_t many_steps = 50'000;

    [[nodiscard]] EvaluationError error_at(const std::string& message, Span span) const;
    void poll_budget(Span span);

    ValueText text_;
    ValueStore& store_;
    std::vector<Activation> activations_;
    const char* stack_base_ = nullptr;
    std::size_t stack_bytes_ = 0;  // limit on the stack, counted from `stack_base_`
    std::uint64_t steps_ = 0;
    std::uint64_t promised_until_ = no_end;  // number of steps after which no value is evaluated early
    std::uint64_t given_up_at_ = no_end;     // number of steps after which early evaluations are abandoned
    std::uint64_t question_ = 0;
    diagnostics::Pollable* budget_ = &diagnostics::unlimited;
    Span prefix_place_;
    std::optional<EvaluationError> stopped_;
    unsigned open_ = 0;  // number of unanswered queries
};

/// A query from outside the evaluator. When the outermost query has been answered, temporary values are deleted.
class Work::Question {
public:
    /// `stack_bytes`: how many bytes of the stack the outermost query may use.
    explicit Question(Work& work, std::size_t stack_bytes = deep_stack_bytes / 4 * 3)
        : work_(work), base_(work.stack_base_), calls_(work.activations_.size()) {
        if (work_.open_++ == 0) {
            work_.steps_ = 0;
            ++work_.question_;
        }
        if (base_ != nullptr) return;
        work_.stack_base_ = static_cast<const char*>(__builtin_frame_address(0));
        work_.stack_bytes_ = stack_bytes;
    }
    ~Question() {
        work_.stack_base_ = base_;
        work_.activations_.resize(calls_);
        if (--work_.open_ == 0) work_.store_.delete_temporaries();
    }
    Question(const Question&) = delete;
    Question& operator=(const Question&) = delete;

private:
    Work& work_;
    const char* base_;
    std::size_t calls_;
};

/// Adds an entry to the CSPM call stack during the lifetime of the object.
class Work::Calling {
public:
    Calling(Work& work, const Function& function, const Values& arguments, Span span) : work_(work) {
        work_.activations_.push_back({&function, &arguments, span});
        work_.count_step(span);
    }
    ~Calling() { work_.activations_.pop_back(); }
    Calling(const Calling&) = delete;
    Calling& operator=(const Calling&) = delete;

private:
    Work& work_;
};

/// Limits the work on a value that may not be needed. The outermost object sets the limit, and nested objects share it.
class Work::Speculation {
public:
    explicit Speculation(Work& work) : work_(work), outermost_(work.given_up_at_ == no_end) {
        constexpr std::uint64_t worth = 2'000;
        if (!outermost_) return;
        work_.promised_until_ = work_.steps_ + worth;
        work_.given_up_at_ = work_.steps_ + 2 * worth;
    }
    ~Speculation() {
        if (outermost_) work_.promised_until_ = work_.given_up_at_ = no_end;
    }
    Speculation(const Speculation&) = delete;
    Speculation& operator=(const Speculation&) = delete;
    [[nodiscard]] bool is_outermost() const { return outermost_; }

private:
    Work& work_;
    bool outermost_;
};

/// Marks a value as being evaluated. The destructor removes the mark even if the evaluation fails. Otherwise a second
/// attempt would report that the value is defined by itself, and not the original error.
class Running {
public:
    explicit Running(bool& flag) : flag_(flag) { flag_ = true; }
    ~Running() { flag_ = false; }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

private:
    bool& flag_;
};

}  // namespace robochart::cspm
