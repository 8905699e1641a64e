// SPDX-License-Identifier: Apache-2.0
// Writes the syntax tree as one text with every part in brackets. Two texts are equal if and only if their trees are.
// The code shares nothing with the printer of RoboChart text, so each can test the other. Source places and resolved
// fields are omitted.
#pragma once

#include <string>

#include "frontend/syntax/ast.hpp"

namespace robochart::random_models {

/// Writes one top-level part (declaration, assertion, CSP block) per line.
[[nodiscard]] std::string structure_text(const frontend::File& file);

}  // namespace robochart::random_models
