// SPDX-License-Identifier: Apache-2.0
// Prints the structure of a process in its current state: its operators as a tree, and the events that each component
// offers. FDR's probe shows the same.
#pragma once

#include <optional>
#include <string>

#include "checker/process/behaviour.hpp"

namespace robochart::app {

/// Returns one line per part, with the parts of an operator indented. If the structure is unknown, returns a sentence
/// that says so.
[[nodiscard]] std::string structure_text(const std::optional<process::Behaviour>&, const process::EventTable&);

}  // namespace robochart::app
