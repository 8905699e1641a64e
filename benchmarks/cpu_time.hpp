// SPDX-License-Identifier: Apache-2.0
// Declares the clock of benchmarks that compare two variants in one thread.
#pragma once

namespace robochart {

/// Returns the CPU time of the calling thread in seconds.
[[nodiscard]] double thread_cpu_seconds();

}  // namespace robochart
