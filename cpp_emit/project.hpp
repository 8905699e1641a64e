// SPDX-License-Identifier: Apache-2.0
// Projects around the classes of one component, one for each target, with everything needed to build it. The constant
// parts are the texts in cpp_emit/projects, in which names between @ signs are replaced. Private to this component.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cpp_emit/api/class_api.hpp"

namespace robochart::cpp_emit {

/// A text of cpp_emit/projects, "enki/main.cpp".
[[nodiscard]] std::string project_template(std::string_view path);

/// Files of the project of Options::target. `controller` contains the files of the classes with their CMakeLists.txt
/// and main.cpp. Constructs that the target does not support are rejected by name.
[[nodiscard]] std::vector<OutputFile> project_files(const Generation&, const Core&, const ClassApi&,
                                                    const std::vector<OutputFile>& controller,
                                                    diagnostics::Diagnostics&);

/// The class that the author of a robot completes: events from its sensors, operations to its actuators.
[[nodiscard]] OutputFile robot_file(const Generation&, const Core&, const ClassApi&, const std::string& act);

}  // namespace robochart::cpp_emit
