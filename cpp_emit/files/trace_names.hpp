// SPDX-License-Identifier: Apache-2.0
// Names inputs and outputs in logs of runs (docs/traces.md). The names are those of the model if they are unique.
#pragma once

#include <string>
#include <vector>

namespace robochart::cpp_emit {

/// The version of the log format.
inline constexpr int trace_version = 1;

/// Converts names of the interfaces in runtime/, such as "seeRobot.in", "set_EXT_reached", "MoveCall" and
/// "set_linearSpeed", to "seeRobot", "reached", "Move" and "linearSpeed". If two names would become equal, they stay
/// unchanged. Inputs and outputs must be converted separately.
[[nodiscard]] std::vector<std::string> trace_names(const std::vector<std::string>& interface_names);
/// Applies `trace_names` to channels, which must have a member `name`.
template <class Channel>
[[nodiscard]] std::vector<std::string> trace_names_of(const std::vector<Channel>& channels) {
    std::vector<std::string> names;
    for (const Channel& channel : channels) names.push_back(channel.name);
    return trace_names(names);
}

}  // namespace robochart::cpp_emit
