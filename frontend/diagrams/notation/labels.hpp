// SPDX-License-Identifier: Apache-2.0
// The text of diagrams, in RoboTool's order and spelling. Invisible characters are escaped.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::diagrams {

/// A name for display; any characters are allowed in it.
[[nodiscard]] std::string shown_name(std::string_view name);

[[nodiscard]] std::string text_of(const frontend::Expr& expr);
/// A statement without the keyword `send`, as RoboTool draws it.
[[nodiscard]] std::string text_of(const frontend::Stmt& statement);
/// `v: T = e`
[[nodiscard]] std::string text_of(const frontend::Variable& variable);
/// `e: T`
[[nodiscard]] std::string text_of(const frontend::Event& event);
/// `op(p: T)`
[[nodiscard]] std::string text_of(const frontend::OperationSignature& signature);
/// `op(p: T) [terminates]`
[[nodiscard]] std::string title_of(const frontend::Machine& operation);
/// `f(x: T): U`
[[nodiscard]] std::string text_of(const frontend::Function& function);
/// `l(T)`
[[nodiscard]] std::string text_of(const frontend::EnumLiteral& literal);
/// `trigger #C <{d}p{e}[guard]/action`, as pieces between which a line may be broken.
[[nodiscard]] std::vector<std::string> label_of(const frontend::Transition& transition);

}  // namespace robochart::diagrams
