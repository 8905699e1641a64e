// SPDX-License-Identifier: Apache-2.0
// Replays every counterexample of a report from its JSON alone, step by step in the operational semantics of the
// script, and compares times, values, active states, variables and offers.
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

/// Checks the model in both times (`core`: also the generated assertions), and replays the counterexamples. Adds to
/// `sum`.
void replay(const std::vector<std::string>& inputs, bool core, Replayed& sum);

}  // namespace robochart::app::testing
