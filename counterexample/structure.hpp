// SPDX-License-Identifier: Apache-2.0
// The structure of a process in its current state: its operators as a tree, and the offers of each component. FDR's
// probe shows the same.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "checker/process/behaviour.hpp"

namespace robochart::runs {

/// The text of a node of the tree: the sign of an operator, or the state of a component.
[[nodiscard]] std::string part_text(const process::Behaviour&);
/// The offers of a component as text: "offers {a, b} and hidden steps"; events beyond the twelfth are only counted.
[[nodiscard]] std::string offers_text(const process::Behaviour&, const process::EventTable&);

/// An event that a component offers but the whole process does not.
struct Blocked {
    std::string component;
    process::Event event{};
    std::string reason;  ///< "`Q` has to take part, and does not offer it ([|{a}|])"
};
/// Finds blocked events by the rules of the operators (UCS 5.1, 5.6 for hiding, FDR manual for priorities). An event is
/// blocked by the first operator above its component that does not let it pass. An event that this operator hides
/// happens as a hidden step, and an event that it renames happens under another name; neither is blocked. At most
/// `most` events.
[[nodiscard]] std::vector<Blocked> blocked_events(const process::Behaviour& whole, std::size_t most);

}  // namespace robochart::runs
