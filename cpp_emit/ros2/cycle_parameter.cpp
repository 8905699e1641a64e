// SPDX-License-Identifier: Apache-2.0
// Computes the parameter `cycle` of a node: the length of its control cycle. It follows from the declared time unit.
// Without a declared unit, a cycle lasts a tenth of a second.
#include <fmt/format.h>

#include <algorithm>

#include "base/durations/time_unit.hpp"
#include "cpp_emit/ros2/node_files.hpp"

namespace robochart::cpp_emit::ros2 {

std::string cycle_seconds(const Options& options) {
    if (!options.unit) return "0.1";
    std::string text = durations::seconds_text(*options.unit * std::max(1U, options.cycle_length));
    return text.find('.') == std::string::npos ? text + ".0" : text;
}

std::string cycle_text(const Options& options) {
    const std::uint32_t units = std::max(1U, options.cycle_length);
    std::string text = fmt::format("{} time unit{} of the model", units, units == 1 ? "" : "s");
    if (options.unit) text += fmt::format(" ({})", durations::duration_text(*options.unit * units));
    return text;
}

}  // namespace robochart::cpp_emit::ros2
