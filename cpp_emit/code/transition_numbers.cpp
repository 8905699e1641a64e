// SPDX-License-Identifier: Apache-2.0
// Numbers transitions machine by machine in textual order, for the trace hook.
#include "cpp_emit/code/transition_numbers.hpp"

#include <cassert>

namespace robochart::cpp_emit {

std::uint32_t transition_number(const Unit& unit, ir::TransitionId id) {
    return static_cast<std::uint32_t>(unit.first_transition + id.index);
}

std::vector<TransitionName> transition_names(const Generation& generation) {
    std::vector<TransitionName> names;
    for (const Unit& unit : generation.component.units) {
        if (unit.first_transition < names.size()) continue;  // the numbers of an earlier unit for the same operation
        assert(unit.first_transition == names.size());
        const std::string& part = generation.component.part_of(unit).name;
        for (const ir::Transition& transition : unit.machine->transitions) {
            const ir::Origin& origin = transition.origin;
            names.push_back({(part.empty() ? "" : part + ": ") + origin.element, generation.line_text(origin.span)});
        }
    }
    return names;
}

}  // namespace robochart::cpp_emit
