// SPDX-License-Identifier: Apache-2.0
// Runs work in which all ranks take part. If one rank cannot do its part, all ranks end the work together.
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

/// Executes work in parts, one for each rank. A rank that reaches a limit or fails does no more work, but it takes part
/// in the communication until all ranks learn of the failure at their next sum.
class SharedWork {
public:
    explicit SharedWork(Exchange& exchange) : exchange_(exchange) {}

    /// Executes this rank's part of the work, unless the rank has failed already. Stores the exception if the part
    /// throws one.
    void execute_part(const std::function<void()>& part);
    [[nodiscard]] bool has_failed() const { return failure_ != nullptr; }
    /// Adds values as Exchange::sum does. If a rank has failed, all ranks throw. The rank that failed throws its stored
    /// exception. The others throw an exception with its message: LimitReached for a limit or a lack of memory,
    /// storage::BadFile for a bad file, and RankFailed otherwise. If several ranks have failed, the worst failure is
    /// reported: an error is worse than a bad file, and a bad file is worse than a limit.
    void sum(std::span<std::uint64_t> values);

private:
    enum class Kind : std::uint8_t { error, bad_file, limit, none };  // the worst kind first

    void record_failure(Kind kind);
    [[noreturn]] void leave_with_failure(Kind worst);

    Exchange& exchange_;
    std::exception_ptr failure_;
    Kind kind_ = Kind::none;
    std::vector<std::uint64_t> values_;
};

/// Executes this rank's part, which may be empty, and returns when all ranks have finished their parts. If one part
/// fails, all ranks throw (SharedWork::sum).
void run_together(Exchange& exchange, const std::function<void()>& part);

}  // namespace robochart::refine
