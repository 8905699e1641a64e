// SPDX-License-Identifier: Apache-2.0
// Writes the module of `emit cpp --target python`: the controller's class for pybind11, with which test benches in
// Python drive the deployed core.
#pragma once

#include <string>
#include <string_view>

#include "cpp_emit/api/class_api.hpp"

namespace robochart::cpp_emit {

/// Returns the name of the module, "NAME_controller".
[[nodiscard]] std::string python_module_name(const ClassApi&);
/// Returns the source of the module. Its functions and types have the names of the C++ class. If a name is a keyword of
/// Python, an underscore is appended.
[[nodiscard]] std::string python_module(const Generation&, const Core&, const ClassApi&);
/// Returns a Python class that the user completes. It prints what the controller calls, and runs cycles.
[[nodiscard]] std::string python_robot(const Generation&, const ClassApi&);

}  // namespace robochart::cpp_emit
