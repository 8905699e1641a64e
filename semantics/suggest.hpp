// "did you mean": the nearest of some names (private to this room).
#pragma once

#include <string>
#include <vector>

namespace robochart::ir {

/// "; did you mean 'x'?" for the candidate with the fewest edits, at most a third of the name's length; else "".
[[nodiscard]] std::string did_you_mean(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace robochart::ir
