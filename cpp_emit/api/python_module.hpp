// SPDX-License-Identifier: Apache-2.0
// Writes the module of `emit cpp --target python`: the controller's class for pybind11, so that test benches in Python
// drive the core that ships.
#pragma once

#include <string>
#include <string_view>

#include "cpp_emit/api/class_api.hpp"

namespace robochart::cpp_emit {

/// The name of the module, "NAME_controller".
[[nodiscard]] std::string python_module_name(const ClassApi&);
/// The source of the module. Its functions and types have the names of the C++ class; a keyword of Python gets an
/// underscore.
[[nodiscard]] std::string python_module(const Generation&, const Core&, const ClassApi&);
/// A class in Python that the user completes: it prints what the controller calls. It also runs cycles.
[[nodiscard]] std::string python_robot(const Generation&, const ClassApi&);

}  // namespace robochart::cpp_emit
