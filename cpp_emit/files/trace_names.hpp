// SPDX-License-Identifier: Apache-2.0
// Names of inputs and outputs in logs of runs (docs/traces.md): the names of the model if they are unique.
#pragma once

#include <string>
#include <vector>

namespace robochart::cpp_emit {

/// Version of the log format.
inline constexpr int trace_version = 1;

/// Converts names of the interfaces in runtime/ ("seeRobot.in", "set_EXT_reached", "MoveCall", "set_linearSpeed") to
/// "seeRobot", "reached", "Move", "linearSpeed". A name stays unchanged if two would become equal. Inputs and outputs
/// are converted separately.
[[nodiscard]] std::vector<std::string> trace_names(const std::vector<std::string>& interface_names);
/// `trace_names` of channels, which have a member `name`.
template <class Channel>
[[nodiscard]] std::vector<std::string> trace_names_of(const std::vector<Channel>& channels) {
    std::vector<std::string> names;
    for (const Channel& channel : channels) names.push_back(channel.name);
    return trace_names(names);
}

}  // namespace robochart::cpp_emit
