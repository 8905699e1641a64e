// SPDX-License-Identifier: Apache-2.0
// Computes which states of a machine can follow each other after some time units, for any environment. The result is a
// proof about the timed semantics of its component, because the computation uses all states.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "prism/assertions/process/explored_process.hpp"

namespace robochart::probability {

/// Classes are bit sets: bit i is set if the i-th of the given states is active.
struct Following {
    std::vector<std::uint32_t> classes;    ///< classes in which time passes, ascending
    std::vector<bool> first;               ///< [class]: the component can start in it
    std::vector<std::vector<bool>> after;  ///< [from][to], after exactly this number of time units
};

/// Throws Wrong if a variable or event of the component's machines, or of an operation, has values that are not in the
/// finite instantiation.
void check_finite(const ir::System&, const ir::ComponentRef& subject);

/// `states` are the paths of at most 32 states in the component's first machine. For each step in which a time unit
/// passes, both the class of the state before the step and the class of the state after it are used. So the class at
/// the end of a control cycle is included, whether generated code is observed before or after the step. Throws Wrong if
/// the machine has no such state, or if generated code may do something that the process does not: values are missing,
/// the component may terminate, time may stop, or time may pass while a transition is taken.
[[nodiscard]] Following find_following(const ExploredProcess&, const ir::System&, const ir::ComponentRef& subject,
                                       const std::vector<std::string>& states, std::uint64_t units,
                                       diagnostics::Pollable& budget);

}  // namespace robochart::probability
