// SPDX-License-Identifier: Apache-2.0
// Splits paths of elements ("Module::controller::machine"), and makes expressions from names of PRISM.
#pragma once

#include <string>

#include "prism/syntax/syntax.hpp"

namespace robochart::probability {

/// Returns the path without its last name, or "" if it has only one name.
[[nodiscard]] std::string owner_of(const std::string& path);
/// Returns the last name of a path.
[[nodiscard]] std::string last_of(const std::string& path);
/// Returns the variable, constant or label with this name as an expression; the expression has no place in a file.
[[nodiscard]] prism::ExprPtr name_expression(const std::string& name);

}  // namespace robochart::probability
