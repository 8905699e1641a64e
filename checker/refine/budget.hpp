// The bounds of one check, counted and polled while it runs.
#pragma once

#include <chrono>

#include <string>

#include "checker/process/operational_semantics.hpp"
#include "checker/refine/check.hpp"

namespace robochart::refine {

/// A bound was reached; the message says which.
class LimitReached : public process::Interrupted {
public:
    using Interrupted::Interrupted;
};

class Budget {
public:
    explicit Budget(const Limits& limits);

    /// One more piece of work about as large as expanding a state. Throws LimitReached.
    void charge() {
        if ((work_++ & 1023U) == 0) poll();
    }
    /// So many states are kept now. Throws LimitReached.
    void states(std::uint64_t count) const;
    [[nodiscard]] double seconds() const;

private:
    void poll();

    const Limits& limits_;
    std::chrono::steady_clock::time_point start_;
    std::uint64_t work_ = 0;
};

}  // namespace robochart::refine
