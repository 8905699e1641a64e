// Shared by the evaluator's own files.
#pragma once

#include "checker/cspm/types/builtins.hpp"
#include "checker/cspm/eval/evaluator.hpp"

namespace robochart::cspm {

/// One entry of the CSPM call stack, while it lasts.
class Evaluator::Calling {
public:
    Calling(Evaluator& evaluator, const Function& function, const Values& arguments, Span span)
        : evaluator_(evaluator) {
        evaluator_.activations_.push_back({&function, &arguments, span});
        evaluator_.count_step(span);
    }
    ~Calling() { evaluator_.activations_.pop_back(); }
    Calling(const Calling&) = delete;
    Calling& operator=(const Calling&) = delete;

private:
    Evaluator& evaluator_;
};

/// The work that a value is worth before it is known to be needed. Those inside share the outermost one's bound.
class Evaluator::Speculation {
public:
    explicit Speculation(Evaluator& evaluator) : evaluator_(evaluator), outermost_(evaluator.given_up_at_ == no_end) {
        constexpr std::uint64_t worth = 2'000;
        if (!outermost_) return;
        evaluator_.promised_until_ = evaluator_.steps_ + worth;
        evaluator_.given_up_at_ = evaluator_.steps_ + 2 * worth;
    }
    ~Speculation() {
        if (outermost_) evaluator_.promised_until_ = evaluator_.given_up_at_ = no_end;
    }
    Speculation(const Speculation&) = delete;
    Speculation& operator=(const Speculation&) = delete;
    [[nodiscard]] bool outermost() const { return outermost_; }

private:
    Evaluator& evaluator_;
    bool outermost_;
};

/// Built-ins that ask for their arguments as far as they need them.
inline bool takes_by_need(Builtin which) {
    return (which >= Builtin::length && which <= Builtin::elem) ||
           (which >= Builtin::map_from_list && which <= Builtin::map_delete);
}

/// The work that speculation is worth is used up.
struct GivenUp {};

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
