// SPDX-License-Identifier: Apache-2.0
// Replays every counterexample of a report step by step in the operational semantics of the script, and compares times,
// values, active states, variables and offers. The JSON of the report is the only input.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace robochart::app::testing {

struct Replayed {
    std::size_t assertions = 0;                  ///< decided assertions
    std::size_t counterexamples = 0;             ///< assertions with a counterexample
    std::size_t steps = 0;                       ///< steps of all counterexamples
    std::size_t machines = 0;                    ///< states of machines that were compared
    std::map<std::string, std::size_t> endings;  ///< counterexamples by the kind of their end
    std::map<std::string, std::size_t> kinds;    ///< steps by kind
    std::vector<std::string> faults;             ///< mismatches between the JSON and the script
};

/// Checks the model in the untimed and the timed semantics, and replays the counterexamples. With `core`, checks the
/// generated assertions too. Adds the counts to `sum`.
void replay(const std::vector<std::string>& inputs, bool core, Replayed& sum);

}  // namespace robochart::app::testing
