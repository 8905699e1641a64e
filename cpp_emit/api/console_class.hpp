// SPDX-License-Identifier: Apache-2.0
// The class of a console program: a controller that prints its outputs and whose inputs are raised by name.
#pragma once

#include <string>
#include <vector>

#include "cpp_emit/api/class_api.hpp"

namespace robochart::cpp_emit {

/// Whether its controller leaves choices open; it then has a member robochart::ConsoleChoices, `console_choices`.
[[nodiscard]] bool console_asks(const Generation&);
/// The command for a choice: "pick", or another word if an input has this name.
[[nodiscard]] std::string pick_word(const ClassApi&);
/// Writes how values of the model's own types are read (robochart/console_values.hpp), in the core's namespace.
void console_reading(const Generation&, const Core&, CodeWriter&);
/// The inputs, one line each, with a description of their values: "heading=VALUE  a real".
[[nodiscard]] std::vector<std::string> console_inputs(const Generation&, const ClassApi&);
/// The class `Console`.
void console_class(const Generation&, const Core&, const ClassApi&, CodeWriter&);

}  // namespace robochart::cpp_emit
