// SPDX-License-Identifier: Apache-2.0
// Work that all ranks leave together if one of them cannot do its part.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <stdexcept>

#include "checker/refine/levels/exchange.hpp"

namespace robochart::refine {

/// Thrown if another rank has failed with an error.
class RankFailed : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A rank that reaches a limit or fails continues to take part in the communication, without doing more work, until all
/// ranks learn of it at their next sum.
class SharedWork {
public:
    explicit SharedWork(Exchange& exchange) : exchange_(exchange) {}

    /// Executes this rank's part of the work, unless it has failed already; stores its exception.
    void attempt(const std::function<void()>& part);
    [[nodiscard]] bool failed() const { return failure_ != nullptr; }
    /// Exchange::sum. If a rank has failed, all throw: that rank its stored exception; the others LimitReached with its
    /// message if that was a limit or a lack of memory, storage::BadFile with its message if it was that, and otherwise
    /// RankFailed. If several have failed, the worst counts: an error before a bad file before a limit.
    void sum(std::span<std::uint64_t> values);

private:
    enum class Kind : std::uint8_t { error, bad_file, limit, none };  // the worst first

    void fail(Kind kind);
    [[noreturn]] void leave(Kind worst);

    Exchange& exchange_;
    std::exception_ptr failure_;
    Kind kind_ = Kind::none;
    std::vector<std::uint64_t> values_;
};

/// Each rank executes its part, which may be empty, and continues when all have finished. If one fails, all throw
/// (SharedWork::sum).
void together(Exchange& exchange, const std::function<void()>& part);

}  // namespace robochart::refine
