// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/ros2/node_constants.hpp"

#include <map>

#include "cpp_emit/ros2/mapping.hpp"

namespace robochart::cpp_emit::ros2 {

namespace {

/// Returns the name of the parameter: "SPEED" for "P::M::SPEED". If other constants have the same last part, returns
/// the whole path with dots.
std::string parameter_of(const std::string& path, const std::map<std::string, int>& ends) {
    const std::string last = path.substr(path.rfind(':') + 1);
    if (ends.at(last) == 1) return "constants." + last;
    std::string dotted = path;
    for (std::size_t at = dotted.find("::"); at != std::string::npos; at = dotted.find("::"))
        dotted.replace(at, 2, ".");
    return "constants." + dotted;
}

}  // namespace

bool names_constant(const std::string& name, const std::string& path) {
    return path == name || (path.ends_with(name) && path.ends_with("::" + name));
}

std::vector<NodeConstant> node_constants(const Generation& generation) {
    const std::vector<OpenConstant> open = open_constants(generation);
    std::map<std::string, int> ends;
    for (const OpenConstant& constant : open) ++ends[constant.path.substr(constant.path.rfind(':') + 1)];
    std::vector<NodeConstant> result;
    for (const OpenConstant& constant : open) result.push_back({constant, parameter_of(constant.path, ends)});
    const Mapping* const mapping = generation.options.mapping;
    if (mapping == nullptr) return result;
    for (const ParameterName& given : mapping->parameters)
        for (NodeConstant& constant : result)
            if (names_constant(given.constant.text, constant.path)) constant.parameter = given.parameter.text;
    return result;
}

}  // namespace robochart::cpp_emit::ros2
