// SPDX-License-Identifier: Apache-2.0
// Links names of rules to a component of a model. An event is linked to an event or to the call of an operation; a
// measure is linked to a typed event whose values the component reads or writes. Equal names are linked, unless `map`
// states otherwise. A measure that the component does not have may have any value. Values of events and states of
// machines are the same as for claims.
#pragma once

#include <string>
#include <vector>

#include "claims/decide/letters.hpp"
#include "claims/sleec/conformance/watch.hpp"
#include "csp_emit/base/emission.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::sleec {

/// The links between a file's names and a component, and the reasons for missing links.
struct ComponentLinking {
    Linking linking;
    std::vector<std::string> missing_events;    ///< for each event, why it is not linked; "" if it is
    std::vector<std::string> missing_measures;  ///< for each measure, why the component's element of this name does not
                                                ///< fit; "" otherwise
    claims::ShownFacts shown;                   ///< the states of the rules, which machines have to show
    bool exact = true;  ///< true if the component has one machine, which shows its states before each step
};

/// Links the names of a file to the channels of a component, which is given by its path in the script.
[[nodiscard]] ComponentLinking link_rules(const CheckedRules& rules, const csp_emit::Emission& emission,
                                          const std::string& component, const ir::System& system,
                                          const ir::Instantiation& instantiation);
/// Returns the reason why a rule cannot be checked for the component; "" if it can.
[[nodiscard]] std::string not_applicable(const CheckedRules& rules, std::size_t rule, const ComponentLinking& linking);

}  // namespace robochart::sleec
