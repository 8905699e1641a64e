// SPDX-License-Identifier: Apache-2.0
// Writes the module of `emit cpp --target python`. It exports the controller's class with pybind11, so that test
// benches in Python can run the deployed core.
#pragma once

#include <string>
#include <string_view>

#include "cpp_emit/api/class_api.hpp"

namespace robochart::cpp_emit {

/// Returns the name of the module, "NAME_controller".
[[nodiscard]] std::string python_module_name(const ClassApi&);
/// Returns the source of the module. Functions and types have the names of the C++ class. An underscore is added to
/// names that are keywords of Python.
[[nodiscard]] std::string python_module(const Generation&, const Core&, const ClassApi&);
/// Returns a Python class for users to complete. It prints what the controller calls, and runs cycles.
[[nodiscard]] std::string python_robot(const Generation&, const ClassApi&);

}  // namespace robochart::cpp_emit
