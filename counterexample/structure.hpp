// SPDX-License-Identifier: Apache-2.0
// Shows the structure of a process in its current state: its operators as a tree, and the offers of each component. The
// probe of FDR shows the same.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "checker/process/behaviour.hpp"

namespace robochart::runs {

/// Returns the text of a node of the tree: the sign of an operator, or the state of a component.
[[nodiscard]] std::string part_text(const process::Behaviour&);
/// Returns the offers of a component as text: "offers {a, b} and hidden steps". Events after the twelfth are only
/// counted.
[[nodiscard]] std::string offers_text(const process::Behaviour&, const process::EventTable&);

/// An event that a component offers but the whole process does not.
struct Blocked {
    std::string component;
    process::Event event{};
    std::string reason;  ///< "`Q` has to take part, and does not offer it ([|{a}|])"
};
/// Finds at most `most` blocked events by the rules of the operators (UCS 5.1, 5.6 for hiding, FDR manual for
/// priorities). An event of a component is blocked by the first operator above the component that does not let the
/// event pass. If this operator hides the event, it happens as a hidden step; if the operator renames it, it happens
/// under another name. In both cases it is not blocked.
[[nodiscard]] std::vector<Blocked> blocked_events(const process::Behaviour& whole, std::size_t most);

}  // namespace robochart::runs
