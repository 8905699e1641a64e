// SPDX-License-Identifier: Apache-2.0
// Small RoboSim models, with parts that a test chooses.
#pragma once

#include <string>

namespace robochart::csp_emit::robosim_test {

/// A machine in cycles of one time unit with these contexts and body.
[[nodiscard]] std::string machine(const std::string& inputs, const std::string& outputs, const std::string& body,
                                  const std::string& cycle = "1");
/// Two machines: one sends `sig` in its first cycle, the other looks at it in the cycle `late`.
[[nodiscard]] std::string sender_and_reader(int late);
/// Two machines that each call `go` with their number in their first cycle, in a controller with this cycle.
[[nodiscard]] std::string two_callers(const std::string& first, const std::string& second,
                                      const std::string& cycle = "1");

}  // namespace robochart::csp_emit::robosim_test
