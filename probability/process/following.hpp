// Which states of a machine may follow which some time units later, whatever its environment does: a proof about the
// timed semantics of its component, by all of its states.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "probability/process/explored_process.hpp"

namespace robochart::probability {

/// Classes are sets of bits: bit i, whether the i-th state that was asked for is active.
struct Following {
    std::vector<std::uint32_t> classes;    ///< in which time passes, ascending
    std::vector<bool> first;               ///< of each class: the component begins in it
    std::vector<std::vector<bool>> after;  ///< [from][to], exactly so many time units later
};

/// Throws Wrong where a variable or event of the component's machines, or of an operation, has values that the finite
/// instantiation leaves out.
void check_finite(const ir::System&, const ir::ComponentRef& subject);

/// `states`: of the component's first machine, by their paths in it, at most 32. A class is that of a state in which a
/// time unit passes, taken both in front of that step and behind it, so it is that of the end of a control cycle
/// whichever of them is meant. Throws Wrong where the machine has no such state, and where generated code may do what
/// the process does not: values are left out, it may terminate, time may stop, or pass while a transition is taken.
[[nodiscard]] Following following(const ExploredProcess&, const ir::System&, const ir::ComponentRef& subject,
                                  const std::vector<std::string>& states, std::uint64_t units,
                                  const std::function<void()>& poll);

}  // namespace robochart::probability
