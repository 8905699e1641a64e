// Assignments to variables and clocks, wherever they live.
#pragma once

#include <string>

#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// `write_x(value);` or a plain assignment, wherever the variable lives; "" if it has no place and is not seen.
[[nodiscard]] std::string store(const Generation&, const Unit&, ir::VariableId, const std::string& value);
/// `f.T = 0;`; "" for clocks that nothing reads.
[[nodiscard]] std::string clock_reset(const Generation&, const Unit&, ir::ClockId);

}  // namespace robochart::cpp_emit
