// SPDX-License-Identifier: Apache-2.0
// Makes random syntax trees that use every construct of RoboChart's grammar (language reference 1.1) and of assertion
// files. Their names and types are arbitrary, so the trees have no meaning. They are input for parsers, printers and
// formatters.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "frontend/syntax/ast.hpp"

namespace robochart::random_models {

/// Returns a `.rct` file with about `size` declarations, without source places. The same seed gives the same tree on
/// every platform.
[[nodiscard]] std::unique_ptr<frontend::File> any_syntax(std::uint64_t seed, std::size_t size = 4);
/// Returns an `.assertions` file with about `size` members.
[[nodiscard]] std::unique_ptr<frontend::File> any_assertions(std::uint64_t seed, std::size_t size = 4);
/// Returns an expression without context.
[[nodiscard]] frontend::ExprPtr any_expression(std::uint64_t seed, std::size_t depth = 4);

}  // namespace robochart::random_models
