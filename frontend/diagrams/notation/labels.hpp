// SPDX-License-Identifier: Apache-2.0
// Writes the text of diagrams, in RoboTool's order and spelling. Invisible characters are escaped.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::diagrams {

/// Returns a name for display. It may contain any characters.
[[nodiscard]] std::string shown_name(std::string_view name);

[[nodiscard]] std::string text_of(const frontend::Expr& expr);
/// Returns a statement without the keyword `send`, as RoboTool draws it.
[[nodiscard]] std::string text_of(const frontend::Stmt& statement);
/// Returns `v: T = e`.
[[nodiscard]] std::string text_of(const frontend::Variable& variable);
/// Returns `e: T`.
[[nodiscard]] std::string text_of(const frontend::Event& event);
/// Returns `op(p: T)`.
[[nodiscard]] std::string text_of(const frontend::OperationSignature& signature);
/// Returns `op(p: T) [terminates]`.
[[nodiscard]] std::string title_of(const frontend::Machine& operation);
/// Returns `f(x: T): U`.
[[nodiscard]] std::string text_of(const frontend::Function& function);
/// Returns `l(T)`.
[[nodiscard]] std::string text_of(const frontend::EnumLiteral& literal);
/// Returns `trigger #C <{d}p{e}[guard]/action` as pieces between which a line may be broken.
[[nodiscard]] std::vector<std::string> label_of(const frontend::Transition& transition);

}  // namespace robochart::diagrams
