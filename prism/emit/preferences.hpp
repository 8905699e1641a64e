// SPDX-License-Identifier: Apache-2.0
// Reads RoboTool's preferences of the translation to PRISM, rc2prism.prefs: lines KEY=VALUE, comments with #.
#pragma once

#include <string>
#include <string_view>

#include "prism/emit/emission.hpp"

namespace robochart::prism_emit {

/// Reads the ranges (NAT_MIN, NAT_MAX, INT_*, REAL_*) and the kind of model (PRISM_MODELTYPE); other keys concern only
/// RoboTool. Returns the error with its line, or "". The line number, from 1, is also stored in `wrong_line`.
[[nodiscard]] std::string read_preferences(std::string_view text, Preferences& preferences,
                                           std::size_t* wrong_line = nullptr);

}  // namespace robochart::prism_emit
