// SPDX-License-Identifier: Apache-2.0
// Turns a text into a syntax tree.
#pragma once

#include <memory>

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// Parses one text and always returns a tree. Text that cannot be parsed is reported and becomes error nodes.
/// `is_assertions` selects the grammar of `.assertions`.
[[nodiscard]] std::unique_ptr<File> parse(const diagnostics::SourceManager&, diagnostics::SourceId, bool is_assertions,
                                          diagnostics::Diagnostics&);

}  // namespace robochart::frontend
