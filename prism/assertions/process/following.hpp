// SPDX-License-Identifier: Apache-2.0
// Computes which states of a machine can follow each other after some time units, for any environment. The result is
// proved for the timed semantics of the component, because the computation uses all states.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "prism/assertions/process/explored_process.hpp"

namespace robochart::probability {

/// A class is the set of active states, as a bit set: bit i is set if the i-th of the given states is active.
struct Following {
    std::vector<std::uint32_t> classes;    ///< classes in which time passes, ascending
    std::vector<bool> first;               ///< by class: true if the component can start in it
    std::vector<std::vector<bool>> after;  ///< [from][to]: `to` can follow `from` after this number of time units
};

/// Throws Wrong if the finite instantiation lacks values of a variable or event of the component's machines or of an
/// operation.
void check_finite(const ir::System&, const ir::ComponentRef& subject);

/// Computes the classes of at most 32 states of the component's first machine; `states` are their paths. For each step
/// in which a time unit passes, both the class before the step and the class after the step are used. So the class at
/// the end of a control cycle is included, whether generated code is observed before or after the step. Throws Wrong if
/// the machine has no such state. Also throws Wrong if generated code may behave differently from the process: values
/// are missing, the component may terminate, time may stop, or time may pass while a transition is taken.
[[nodiscard]] Following find_following(const ExploredProcess&, const ir::System&, const ir::ComponentRef& subject,
                                       const std::vector<std::string>& states, std::uint64_t units,
                                       diagnostics::Pollable& budget);

}  // namespace robochart::probability
