// RoboTool's preferences of the translation to PRISM, rc2prism.prefs: lines KEY=VALUE, comments with #.
#pragma once

#include <string>
#include <string_view>

#include "prism_emit/emission.hpp"

namespace robochart::prism_emit {

/// Takes over what the text says of ranges (NAT_MIN, NAT_MAX, INT_*, REAL_*) and of the kind of model
/// (PRISM_MODELTYPE); its other keys are about RoboTool alone. Returns what is wrong with it, with the line; "":
/// nothing. The line, counted from 1, is put into `wrong_line` too.
[[nodiscard]] std::string read_preferences(std::string_view text, Preferences& preferences,
                                           std::size_t* wrong_line = nullptr);

}  // namespace robochart::prism_emit
