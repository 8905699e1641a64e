// SPDX-License-Identifier: Apache-2.0
// Writes expressions and types of a RoboChart model as text of RoboSim.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// Returns a name as it must be written in RoboSim, which reserves more words than RoboChart.
[[nodiscard]] std::string robosim_name(std::string_view name);
[[nodiscard]] std::string robosim_name(const QualifiedName& name);
/// Returns a type as it must be written in RoboSim.
[[nodiscard]] std::string robosim_text(const TypeExpr& type);

/// Returns the text that replaces a name, or the clock that replaces `sinceEntry(S)`. The result is "" if the
/// expression is not replaced.
using Renaming = std::function<std::string(const Expr& name)>;
/// Returns an expression as it must be written in RoboSim, with its names replaced by `renaming`.
[[nodiscard]] std::string robosim_text(const Expr& expr, const Renaming& renaming);

/// True if the expression needs no brackets as an operand, because it is a single word or has brackets already.
[[nodiscard]] bool is_closed(const Expr& expr);

}  // namespace robochart::frontend
