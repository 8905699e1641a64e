// Runs as text.
#pragma once

#include <string>
#include <string_view>

#include "runs/run.hpp"

namespace robochart::runs {

/// One line a step, internal steps without news left out; then where the run ends, and why that is wrong.
[[nodiscard]] std::string text(const Run&, std::string_view indent);

}  // namespace robochart::runs
