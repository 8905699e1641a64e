// The structure of a process where it stands: its operators as a tree, and what each component offers, as the probe of
// FDR shows it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "checker/process/behaviour.hpp"

namespace robochart::runs {

/// What stands for a part of the tree: of an operator its sign, of a component where it is.
[[nodiscard]] std::string part_text(const process::Behaviour&);
/// Of a component: "offers {a, b} and hidden steps"; more than 12 events are counted.
[[nodiscard]] std::string offers_text(const process::Behaviour&, const process::EventTable&);

/// An event that a component offers and the whole process does not.
struct Blocked {
    std::string component;
    process::Event event{};
    std::string reason;  ///< "`Q` has to take part, and does not offer it ([|{a}|])"
};
/// Where the whole stands, by the rules of its operators (UCS 5.1, 5.6 for hiding, FDR manual for priorities): an event
/// ends at the first operator above its component that does not let it pass. What is hidden there happens as a hidden
/// step, and what is renamed there by another name: neither is blocked. `most` at most.
[[nodiscard]] std::vector<Blocked> blocked_events(const process::Behaviour& whole, std::size_t most);

}  // namespace robochart::runs
