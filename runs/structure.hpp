// The structure of a process where it stands: its operators as a tree, and what each component offers, as the probe of
// FDR shows it.
#pragma once

#include <string>

#include "checker/process/behaviour.hpp"

namespace robochart::runs {

/// What stands for a part of the tree: of an operator its sign, of a component where it is.
[[nodiscard]] std::string part_text(const process::Behaviour&);
/// Of a component: "offers {a, b} and hidden steps"; more than 12 events are counted.
[[nodiscard]] std::string offers_text(const process::Behaviour&, const process::EventTable&);

}  // namespace robochart::runs
