// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/cpu_time.hpp"

#include <ctime>

namespace robochart {

double thread_cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace robochart
