// SPDX-License-Identifier: Apache-2.0
// Writes small RoboSim models. The test chooses some of their parts.
#pragma once

#include <string>

namespace robochart::csp_emit::robosim_test {

/// Returns a machine in cycles of one time unit with these contexts and this body.
[[nodiscard]] std::string machine(const std::string& inputs, const std::string& outputs, const std::string& body,
                                  const std::string& cycle = "1");
/// Returns two machines. One sends `sig` in its first cycle, and the other reads it in the cycle `late`.
[[nodiscard]] std::string sender_and_reader(int late);
/// Returns a controller with this cycle and two machines. In its first cycle, each machine calls `go` with its number.
[[nodiscard]] std::string two_callers(const std::string& first, const std::string& second,
                                      const std::string& cycle = "1");

}  // namespace robochart::csp_emit::robosim_test
