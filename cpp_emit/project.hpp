// SPDX-License-Identifier: Apache-2.0
// Writes the project for a target: the classes of one component with everything that is needed to build them. The
// constant parts are texts in cpp_emit/projects, in which names between @ signs are replaced. Private to this
// component.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cpp_emit/api/class_api.hpp"

namespace robochart::cpp_emit {

/// Returns a text of cpp_emit/projects by its name, such as "enki/main.cpp".
[[nodiscard]] std::string project_template(std::string_view path);

/// Returns the files of the project of Options::target. `controller` contains the files of the classes with their
/// CMakeLists.txt and main.cpp. Rejects by name constructs that the target does not support.
[[nodiscard]] std::vector<OutputFile> project_files(const Generation&, const Core&, const ClassApi&,
                                                    const std::vector<OutputFile>& controller,
                                                    diagnostics::Diagnostics&);

/// Returns the file with the class that the author of a robot completes. The class connects sensors to events, and
/// operations to actuators.
[[nodiscard]] OutputFile robot_file(const Generation&, const Core&, const ClassApi&, const std::string& act);

}  // namespace robochart::cpp_emit
