// Work that all ranks leave together if one of them cannot do its part.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <stdexcept>

#include "checker/refine/levels/exchange.hpp"

namespace robochart::refine {

/// Another rank has met an error, which is not this one's.
class RankFailed : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A rank that meets a limit or an error goes on taking part in what the ranks exchange, without doing more, until all
/// of them hear of it at their next sum.
class SharedWork {
public:
    explicit SharedWork(Exchange& exchange) : exchange_(exchange) {}

    /// Does this rank's part of something, unless it has failed already; keeps what it throws.
    void attempt(const std::function<void()>& part);
    [[nodiscard]] bool failed() const { return failure_ != nullptr; }
    /// Exchange::sum. Where a rank has failed, all throw: that one what it has kept, the others LimitReached with its
    /// words if that was a limit or memory that is not there, storage::BadFile with its words if it was that, and else
    /// RankFailed. Where several have failed, the worst counts: an error before a bad file before a limit.
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

/// Each rank does its part of something, which may be nothing, and goes on when all have. Where one cannot, all throw
/// (SharedWork::sum).
void together(Exchange& exchange, const std::function<void()>& part);

}  // namespace robochart::refine
