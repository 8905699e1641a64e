// The structure of a process where it stands: its operators as a tree, and what each component offers, as the probe of
// FDR shows it.
#pragma once

#include <optional>
#include <string>

#include "checker/process/behaviour.hpp"

namespace robochart::app {

/// A line for each part, parts of an operator further in; a sentence where there is no structure.
[[nodiscard]] std::string structure_text(const std::optional<process::Behaviour>&, const process::EventTable&);

}  // namespace robochart::app
