// SPDX-License-Identifier: Apache-2.0
// Reads RoboTool's preferences for the translation to PRISM from rc2prism.prefs. The file has lines KEY=VALUE, and
// comments that begin with #.
#pragma once

#include <string>
#include <string_view>

#include "prism/emit/emission.hpp"

namespace robochart::prism_emit {

/// Reads the ranges (NAT_MIN, NAT_MAX, INT_*, REAL_*) and the kind of model (PRISM_MODELTYPE). Other keys matter only
/// for RoboTool. Returns the error with its line, or "". Also stores the line number, from 1, in `wrong_line`.
[[nodiscard]] std::string read_preferences(std::string_view text, Preferences& preferences,
                                           std::size_t* wrong_line = nullptr);

}  // namespace robochart::prism_emit
