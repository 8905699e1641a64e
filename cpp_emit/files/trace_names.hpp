// Names of inputs and outputs in logs of runs (docs/traces.md): those of the model where no two share one.
#pragma once

#include <string>
#include <vector>

namespace robochart::cpp_emit {

/// Version of the log format.
inline constexpr int trace_version = 1;

/// From names as in the interfaces of runtime/ ("seeRobot.in", "set_EXT_reached", "MoveCall", "set_linearSpeed") to
/// "seeRobot", "reached", "Move", "linearSpeed"; a name that two would share stays as it is. Inputs and outputs are
/// named apart.
[[nodiscard]] std::vector<std::string> trace_names(const std::vector<std::string>& interface_names);

}  // namespace robochart::cpp_emit
