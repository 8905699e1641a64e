#include "conformance/cycle_log.hpp"

#include <cstdint>

namespace robochart::conformance {

bool same_writes(const rc_log& a, const rc_log& b) {
    if (a.count != b.count || a.overflow != b.overflow) return false;
    for (std::uint32_t r = 0; r < a.count && r < ROBOCHART_MAX_RECORDS; ++r) {
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
