// SPDX-License-Identifier: Apache-2.0
// Lists names and strings with a meaning in other languages (private to the component): in CSPM, in C++ and its
// headers, in generated code, in CMake, shells and XML.
#pragma once

#include <string_view>
#include <vector>

namespace robochart::random_models {

/// Returns names other than core types and reserved words of RoboChart. (Reserved words need a `^`.)
[[nodiscard]] const std::vector<std::string_view>& hostile_names();
/// Returns string literals in RoboChart's notation.
[[nodiscard]] const std::vector<std::string_view>& hostile_strings();

}  // namespace robochart::random_models
