// Names of rules found in a component of a model: an event in an event or in the call of an operation, a measure in a
// typed event, whose values the component reads or writes. Equal names are linked, unless `map` says otherwise. A
// measure that the component does not have may have any value.
#pragma once

#include <string>
#include <vector>

#include "csp_emit/base/emission.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"
#include "sleec/conformance/watch.hpp"

namespace robochart::sleec {

/// What a component has of a file's names, and why it does not have the others.
struct ComponentLinking {
    Linking linking;
    std::vector<std::string> missing_events;    ///< of each event: why it is not linked; "" if it is
    std::vector<std::string> missing_measures;  ///< of each measure that the component has, but as something else
};

/// Links the names of a file with the channels of a component, by its path in the script.
[[nodiscard]] ComponentLinking link(const CheckedRules& rules, const csp_emit::Emission& emission,
                                    const std::string& component, const ir::System& system,
                                    const ir::Instantiation& instantiation);
/// Why a rule cannot be asked of the component; "" if it can.
[[nodiscard]] std::string not_applicable(const CheckedRules& rules, std::size_t rule, const ComponentLinking& linking);

}  // namespace robochart::sleec
