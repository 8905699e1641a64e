// The work of an evaluation: its call stack, the steps taken, the bounds of speculation.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "checker/cspm/eval/code.hpp"
#include "checker/cspm/eval/evaluation_error.hpp"
#include "checker/cspm/eval/value_text.hpp"

namespace robochart::cspm {

/// Elements of one set made explicit, at most.
inline constexpr std::size_t max_elements = 5'000'000;

/// The work that speculation is worth is used up.
struct GivenUp {};

/// Owns the call stack and the counters.
class Work {
public:
    /// Steps between two questions of the search, at most.
    static constexpr std::uint64_t max_steps = 2'000'000'000;

    Work(const Program& program, ValueStore& store) : text_(program), store_(store) {}

    /// Called now and then; may throw to stop the evaluation. Empty: none.
    void watch(std::function<void()> poll) { poll_ = std::move(poll); }
    /// One step more.
    void count(Span span);
    /// Where errors without a place of their own are reported: the prefix whose events are computed.
    void at_prefix(Span span) { prefix_place_ = span; }
    [[noreturn]] void fail(const std::string& message, Span span) const;
    [[noreturn]] void not_supported(const std::string& what, Span span) const;

    /// Whether no more steps are left.
    [[nodiscard]] bool used_up() const { return steps_ > max_steps; }
    /// Whether values may be evaluated before they are needed.
    [[nodiscard]] bool may_speculate() const { return steps_ < promised_until_; }
    /// The number of the present question from outside.
    [[nodiscard]] std::uint64_t question() const { return question_; }

    class Question;
    class Calling;
    class Speculation;

private:
    struct Activation {
        const Function* function = nullptr;
        const Values* arguments = nullptr;
        Span called;  ///< where, if known: in generated scripts a place of the model
    };
    static constexpr std::uint64_t no_end = ~std::uint64_t{0};

    ValueText text_;
    ValueStore& store_;
    std::vector<Activation> activations_;
    const char* stack_base_ = nullptr;
    std::uint64_t steps_ = 0;
    std::uint64_t promised_until_ = no_end;  // steps at which no more values are asked for early...
    std::uint64_t given_up_at_ = no_end;     // ...and at which those under way are given up
    std::uint64_t question_ = 0;
    std::function<void()> poll_;
    Span prefix_place_;
    unsigned open_ = 0;  // questions
};

/// A question from outside. Temporary values are dropped when the outermost one is answered.
class Work::Question {
public:
    explicit Question(Work& work) : work_(work), base_(work.stack_base_), calls_(work.activations_.size()) {
        if (work_.open_++ == 0) {
            work_.steps_ = 0;
            ++work_.question_;
        }
        if (base_ == nullptr) work_.stack_base_ = static_cast<const char*>(__builtin_frame_address(0));
    }
    ~Question() {
        work_.stack_base_ = base_;
        work_.activations_.resize(calls_);
        if (--work_.open_ == 0) work_.store_.release();
    }
    Question(const Question&) = delete;
    Question& operator=(const Question&) = delete;

private:
    Work& work_;
    const char* base_;
    std::size_t calls_;
};

/// One entry of the CSPM call stack, while it lasts.
class Work::Calling {
public:
    Calling(Work& work, const Function& function, const Values& arguments, Span span) : work_(work) {
        work_.activations_.push_back({&function, &arguments, span});
        work_.count(span);
    }
    ~Calling() { work_.activations_.pop_back(); }
    Calling(const Calling&) = delete;
    Calling& operator=(const Calling&) = delete;

private:
    Work& work_;
};

/// The work that a value is worth before it is known to be needed. Those inside share the outermost one's bound.
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
    [[nodiscard]] bool outermost() const { return outermost_; }

private:
    Work& work_;
    bool outermost_;
};

/// Set while something is being evaluated, and no longer when an error ends that: what is asked for again fails
/// again for its own reason, not as if it were defined by itself.
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
