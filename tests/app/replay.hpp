// Replays every counterexample of a report from its JSON alone: step by step in the operational semantics of the
// script, with times, values, active states, variables and offers compared on the way.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace robochart::app::testing {

struct Replayed {
    std::size_t assertions = 0;                  ///< decided
    std::size_t counterexamples = 0;             ///< with a run
    std::size_t steps = 0;                       ///< of all runs
    std::size_t machines = 0;                    ///< states of machines that were compared
    std::map<std::string, std::size_t> endings;  ///< counterexamples by the kind of their end
    std::map<std::string, std::size_t> kinds;    ///< steps by kind
    std::vector<std::string> faults;             ///< what is not as the script has it
};

/// Checks the model (`core`: the generated assertions too), in both times, and replays what fails. Adds to `sum`.
void replay(const std::vector<std::string>& inputs, bool core, Replayed& sum);

}  // namespace robochart::app::testing
