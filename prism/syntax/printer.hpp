// SPDX-License-Identifier: Apache-2.0
// Prints trees as PRISM text. Parsing the text gives an equal tree.
#pragma once

#include <string>

#include "prism/syntax/syntax.hpp"

namespace robochart::prism {

[[nodiscard]] std::string print(const ExprPtr& expr);
[[nodiscard]] std::string print(const ModelFile& file);
[[nodiscard]] std::string print(const PropertyFile& file);

}  // namespace robochart::prism
