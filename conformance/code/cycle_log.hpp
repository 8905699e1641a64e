// What a call of generated code wrote and was asked: a log that grows, and how two are compared and gone through.
#pragma once

#include <cstdint>
#include <vector>

#include "cpp_emit/runtime/explore_abi.h"

namespace robochart::conformance {

/// A log with records of its own.
class CycleLog : public rc_log {
public:
    CycleLog();
    CycleLog(const CycleLog&);
    CycleLog& operator=(const CycleLog&);
    ~CycleLog() = default;

    /// Whether a call wrote more than there are records for; it has to be made again, behind `grow`.
    [[nodiscard]] bool cut() const { return (overflow & ROBOCHART_OVERFLOW_RECORDS) != 0; }
    /// Twice as many records, and cleared; false where there are `most_records` already.
    [[nodiscard]] bool grow();
    void reserve(std::uint32_t records);
    /// Nothing written, nothing asked; the answers given stay.
    void clear() { count = overflow = asked = 0; }

    /// More outputs in one cycle are not compared. Generated code reaches its bound of steps at about so many.
    static constexpr std::uint32_t most_records = 1U << 18U;

private:
    std::vector<rc_record> records_;
};

/// The same outputs with the same arguments in the same order.
[[nodiscard]] bool same_writes(const rc_log&, const rc_log&);

/// The next answers to what a call asked, counted from the last; false after the last ones.
[[nodiscard]] bool next_choices(rc_log&);

}  // namespace robochart::conformance
