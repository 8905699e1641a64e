// Shared by the evaluator's own files.
#pragma once

#include "checker/cspm/evaluator.hpp"

namespace robochart::cspm {

/// One entry of the CSPM call stack, while it lasts.
class Evaluator::Calling {
public:
    Calling(Evaluator& evaluator, const Function& function, const Values& arguments, Span span)
        : evaluator_(evaluator) {
        evaluator_.activations_.push_back({&function, &arguments});
        evaluator_.count_step(span);
    }
    ~Calling() { evaluator_.activations_.pop_back(); }
    Calling(const Calling&) = delete;
    Calling& operator=(const Calling&) = delete;

private:
    Evaluator& evaluator_;
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
