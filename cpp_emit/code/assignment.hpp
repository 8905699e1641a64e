// Assignments to variables, clocks and deadlines, wherever they live.
#pragma once

#include <string>
#include <vector>

#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/expressions/cpp_expr.hpp"
#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// `write_x(value);` or a plain assignment, wherever the variable lives; "" if it has no place and is not seen.
[[nodiscard]] std::string store(const Generation&, const Unit&, ir::VariableId, const std::string& value);
/// Whether a write of the variable may have to wait until earlier ones are propagated (semantics 3.7).
[[nodiscard]] bool may_be_held_up(const Generation&, const Unit&, ir::VariableId);
/// `!held_up_x()`: a write has not to wait. Empty where it never has to.
[[nodiscard]] CppExpr may_write(const Generation&, const Unit&, ir::VariableId);
/// `f.T = 0;`; "" for clocks that nothing reads.
[[nodiscard]] std::string clock_reset(const Generation&, const Unit&, ir::ClockId);
/// A line for each of the clocks that something reads.
void reset_clocks(const Generation&, const Unit&, const std::vector<ir::ClockId>&, CodeWriter&);
/// A deadline that runs from here: `f.d = duration(3) + 1;`.
[[nodiscard]] std::string watch_from(const Generation&, const Unit&, const std::string& field, const ir::Expr& bound);

}  // namespace robochart::cpp_emit
