// SPDX-License-Identifier: Apache-2.0
// Writes assignments to variables, clocks and deadlines, for all places in which they are stored.
#pragma once

#include <string>
#include <vector>

#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/expressions/cpp_expr.hpp"
#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Returns `write_x(value);` or a plain assignment, as the place of the variable requires. Returns "" if the variable
/// is neither stored nor visible to others.
[[nodiscard]] std::string store_statement(const Generation&, const Unit&, ir::VariableId, const std::string& value);
/// Returns true if a write of the variable may have to wait until earlier writes are propagated (semantics 3.7).
[[nodiscard]] bool may_be_held_up(const Generation&, const Unit&, ir::VariableId);
/// Returns `!held_up_x()`, which is true if a write need not wait. Returns an empty condition if no write of the
/// variable ever waits.
[[nodiscard]] CppExpr may_write(const Generation&, const Unit&, ir::VariableId);
/// Returns the statement that resets a clock, `f.T = 0;`, or "" for a clock that is never read.
[[nodiscard]] std::string clock_reset(const Generation&, const Unit&, ir::ClockId);
/// Writes a reset for each of these clocks that is read somewhere.
void reset_clocks(const Generation&, const Unit&, const std::vector<ir::ClockId>&, CodeWriter&);
/// Returns the statement that starts a deadline here: `f.d = duration(3) + 1;`.
[[nodiscard]] std::string watch_from(const Generation&, const Unit&, const std::string& field, const ir::Expr& bound);

}  // namespace robochart::cpp_emit
