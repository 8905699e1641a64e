// SPDX-License-Identifier: Apache-2.0
#include "driver/settings/run_limits.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>

namespace robochart::driver {

std::uint64_t default_memory() {
    std::uint64_t bytes =
        static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    std::uint64_t group = 0;
    // This file of control groups (version 2) contains "max" if there is no limit.
    if (std::ifstream("/sys/fs/cgroup/memory.max") >> group && group > 0) bytes = std::min(bytes, group);
    return std::min(std::uint64_t{16} << 30U, bytes / 4 * 3);
}

diagnostics::Limits run_limits(const LimitSettings& settings) {
    diagnostics::Limits limits;
    limits.memory_bytes = settings.memory_bytes > 0 ? settings.memory_bytes : default_memory();
    // A limit of more than a year is ignored, because it would overflow the clock.
    if (constexpr double year = 366.0 * 24 * 3600; settings.timeout_seconds > 0 && settings.timeout_seconds < year)
        limits.deadline =
            std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                                   std::chrono::duration<double>(settings.timeout_seconds));
    return limits;
}

}  // namespace robochart::driver
