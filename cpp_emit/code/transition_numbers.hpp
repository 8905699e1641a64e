// SPDX-License-Identifier: Apache-2.0
// Numbers the transitions of all machines and operations of a component, in the order of Component::units. Units for
// the same operation of the model share numbers. The trace hook refers to transitions by these numbers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cpp_emit/expressions/generation.hpp"

namespace robochart::cpp_emit {

struct TransitionName {
    std::string element;             ///< "Door::t1"; with several machines "stm0: Door::t1"
    diagnostics::ForeignText place;  ///< "door.rct:18"; "" if unknown
};

[[nodiscard]] std::uint32_t transition_number(const Unit&, ir::TransitionId);
/// Returns the names of the transitions, in the order of their numbers.
[[nodiscard]] std::vector<TransitionName> transition_names(const Generation&);

}  // namespace robochart::cpp_emit
