// The syntax of a tree as one text, every part in brackets: equal texts, equal trees. Shares nothing with the printer
// of RoboChart text, so that the two can check each other. Places and resolved fields are left out.
#pragma once

#include <string>

#include "frontend/syntax/ast.hpp"

namespace robochart::random_models {

/// One top-level part (declaration, assertion, CSP block) a line.
[[nodiscard]] std::string structure(const frontend::File& file);

}  // namespace robochart::random_models
