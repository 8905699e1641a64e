// SPDX-License-Identifier: Apache-2.0
#include "conformance/code/cycle_log.hpp"

namespace robochart::conformance {

CycleLog::CycleLog() : rc_log{} {
    reserve(64);
}

CycleLog::CycleLog(const CycleLog& other) : rc_log(other), records_(other.records_) {
    record = records_.data();
}

CycleLog& CycleLog::operator=(const CycleLog& other) {
    if (this == &other) return *this;
    rc_log::operator=(other);
    records_ = other.records_;
    record = records_.data();
    return *this;
}

bool CycleLog::grow() {
    if (capacity >= most_records) return false;
    reserve(2 * capacity);
    clear();
    return true;
}

void CycleLog::reserve(std::uint32_t records) {
    if (records <= capacity) return;
    records_.resize(records);
    record = records_.data();
    capacity = records;
}

bool same_writes(const rc_log& a, const rc_log& b) {
    if (a.count != b.count || a.overflow != b.overflow) return false;
    for (std::uint32_t r = 0; r < a.count; ++r) {
        const rc_record& x = a.record[r];
        const rc_record& y = b.record[r];
        if (x.output != y.output || x.count != y.count) return false;
        for (std::uint32_t k = 0; k < x.count && k < ROBOCHART_MAX_ARGUMENTS; ++k) {
            if (x.argument[k] != y.argument[k]) return false;
        }
    }
    return true;
}

bool next_choices(rc_log& log) {
    for (std::uint32_t k = log.asked; k > 0; --k) {
        const std::uint32_t taken = k - 1 < log.given ? log.choice[k - 1] : 0;
        if (taken + 1 >= log.ways[k - 1]) continue;
        for (std::uint32_t earlier = log.given; earlier < k - 1; ++earlier) log.choice[earlier] = 0;
        log.choice[k - 1] = taken + 1;
        log.given = k;
        return true;
    }
    return false;
}

}  // namespace robochart::conformance
