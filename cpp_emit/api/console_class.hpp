// SPDX-License-Identifier: Apache-2.0
// Writes the class of a console program. Its controller prints its outputs, and the user raises its inputs by
// name.
#pragma once

#include <string>
#include <vector>

#include "cpp_emit/api/class_api.hpp"

namespace robochart::cpp_emit {

/// Returns true if the controller asks the user to decide choices. The class then has a member `console_choices` of
/// type robochart::ConsoleChoices.
[[nodiscard]] bool console_asks(const Generation&);
/// Returns the command that answers a choice: "pick", or another word if an input is called `pick`.
[[nodiscard]] std::string pick_word(const ClassApi&);
/// Writes functions that read values of the model's own types (robochart/console_values.hpp), in the core's namespace.
void console_reading(const Generation&, const Core&, CodeWriter&);
/// Returns one text per input that describes its values: "heading=VALUE  a real".
[[nodiscard]] std::vector<std::string> console_inputs(const Generation&, const ClassApi&);
/// Writes the class `Console`.
void console_class(const Generation&, const Core&, const ClassApi&, CodeWriter&);

}  // namespace robochart::cpp_emit
