// SPDX-License-Identifier: Apache-2.0
// Names of elements ("Module::controller::machine") and of PRISM's variables.
#pragma once

#include <string>

#include "prism/syntax/syntax.hpp"

namespace robochart::probability {

/// The path without its last name; "" if it has only one.
[[nodiscard]] std::string owner_of(const std::string& path);
/// The last name of a path.
[[nodiscard]] std::string last_of(const std::string& path);
/// A variable, constant or label of this name as an expression without place.
[[nodiscard]] prism::ExprPtr name_expression(const std::string& name);

}  // namespace robochart::probability
