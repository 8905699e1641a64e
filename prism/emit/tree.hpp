// SPDX-License-Identifier: Apache-2.0
// Constructs nodes of PRISM's syntax tree.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

#include "prism/syntax/syntax.hpp"

namespace robochart::prism_emit::tree {

using prism::ExprPtr;
using prism::Op;

[[nodiscard]] ExprPtr name(const std::string& text);
[[nodiscard]] ExprPtr number(std::int64_t value);
[[nodiscard]] ExprPtr truth(bool value);
[[nodiscard]] ExprPtr apply(Op op, std::vector<ExprPtr> operands);
[[nodiscard]] ExprPtr call(const std::string& function, std::vector<ExprPtr> operands);
/// Returns the comparison `variable = value`; both are names.
[[nodiscard]] ExprPtr is(const std::string& variable, const std::string& value);
[[nodiscard]] inline ExprPtr is(const std::string& variable, std::same_as<bool> auto value) {
    return apply(Op::equal, {name(variable), truth(value)});
}
/// Returns the conjunction. Operands that are `true` are omitted, and the empty conjunction is `true`.
[[nodiscard]] ExprPtr all_of(const std::vector<ExprPtr>& operands);
[[nodiscard]] bool is_true(const ExprPtr&);

[[nodiscard]] prism::Assignment set(const std::string& variable, ExprPtr value);
[[nodiscard]] prism::Assignment set(const std::string& variable, const std::string& value);
[[nodiscard]] inline prism::Assignment set(const std::string& variable, std::same_as<bool> auto value) {
    return set(variable, truth(value));
}

[[nodiscard]] prism::Constant constant(const std::string& name, std::int64_t value);
/// Declares a variable with the range low..high. If `initial` is null, PRISM's default applies.
[[nodiscard]] prism::Variable range(const std::string& name, std::int64_t low, std::int64_t high, ExprPtr initial);
[[nodiscard]] prism::Variable boolean(const std::string& name, ExprPtr initial);
/// Makes the command `[action] guard -> assignments`; "" means no action.
[[nodiscard]] prism::Command command(const std::string& action, ExprPtr guard,
                                     std::vector<prism::Assignment> assignments);

}  // namespace robochart::prism_emit::tree
