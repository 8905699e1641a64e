// SPDX-License-Identifier: Apache-2.0
// Stores the outputs and questions of one call of generated code. The log can grow, be compared with another log, and
// enumerate answers.
#pragma once

#include <cstdint>
#include <vector>

#include "cpp_emit/runtime/explore_abi.h"

namespace robochart::conformance {

/// A log with its own memory for records.
class CycleLog : public rc_log {
public:
    CycleLog();
    CycleLog(const CycleLog&);
    CycleLog& operator=(const CycleLog&);
    ~CycleLog() = default;

    /// Returns whether a call made more outputs than the log can hold. The call must be repeated after `grow`.
    [[nodiscard]] bool is_cut() const { return (overflow & ROBOCHART_OVERFLOW_RECORDS) != 0; }
    /// Doubles the capacity for records and clears the log. Returns false if the capacity is `most_records` already.
    [[nodiscard]] bool grow();
    void reserve(std::uint32_t records);
    /// Clears outputs and questions, but not the given answers.
    void clear() { count = overflow = asked = 0; }

    /// The maximal number of outputs of a cycle that are compared. Generated code reaches its bound on steps at about
    /// this number.
    static constexpr std::uint32_t most_records = 1U << 18U;

private:
    std::vector<rc_record> records_;
};

/// Returns whether both logs contain the same outputs with the same arguments in the same order.
[[nodiscard]] bool same_writes(const rc_log&, const rc_log&);

/// Advances to the next combination of answers, starting with the last answer. Returns false after the last
/// combination.
[[nodiscard]] bool next_choices(rc_log&);

}  // namespace robochart::conformance
