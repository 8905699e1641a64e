// What a mistake in a script probably means: by what was expected and what was found (parser.hpp).
#pragma once

#include <span>

#include "diagnostics/advice/advice.hpp"

namespace robochart::cspm {

/// All rows; what is expected is as the messages say it: "'else'".
[[nodiscard]] std::span<const diagnostics::Advice> all_advice();

}  // namespace robochart::cspm
