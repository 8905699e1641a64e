// SPDX-License-Identifier: Apache-2.0
// Copies expressions and types of a RoboChart model as text of RoboSim.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// A name as it must be written in RoboSim, which reserves more words than RoboChart.
[[nodiscard]] std::string robosim_name(std::string_view name);
[[nodiscard]] std::string robosim_name(const QualifiedName& name);
/// A type as it must be written in RoboSim.
[[nodiscard]] std::string robosim_text(const TypeExpr& type);

/// Returns the text that takes the place of an expression that is a name, or the clock that takes the place of
/// `sinceEntry(S)`; "" if the expression stays.
using Renaming = std::function<std::string(const Expr& name)>;
/// An expression as it must be written in RoboSim, after the renaming of its names.
[[nodiscard]] std::string robosim_text(const Expr& expr, const Renaming& renaming);

/// True if the expression needs no brackets as an operand, because it is a single word or has brackets already.
[[nodiscard]] bool is_closed(const Expr& expr);

}  // namespace robochart::frontend
