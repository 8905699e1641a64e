// The class of a console program: a controller that prints what it does and whose inputs are raised by name.
#pragma once

#include <string>
#include <vector>

#include "cpp_emit/api/class_api.hpp"

namespace robochart::cpp_emit {

/// Whether its controller leaves choices: then it has a robochart::ConsoleChoices, `console_choices`.
[[nodiscard]] bool console_asks(const Generation&);
/// The word of a choice: "pick", or another where an input is called so.
[[nodiscard]] std::string pick_word(const ClassApi&);
/// How values of the model's own types are read (robochart/console_values.hpp), in the core's namespace.
void console_reading(const Generation&, const Core&, CodeWriter&);
/// The inputs, a line each, with what their values are: "heading=VALUE  a real".
[[nodiscard]] std::vector<std::string> console_inputs(const Generation&, const ClassApi&);
/// The class `Console`.
void console_class(const Generation&, const Core&, const ClassApi&, CodeWriter&);

}  // namespace robochart::cpp_emit
