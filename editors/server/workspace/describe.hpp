// SPDX-License-Identifier: Apache-2.0
// Describes declarations, for hovers, completions and outlines.
#pragma once

#include <string>

#include "editors/server/workspace/workspace.hpp"

namespace robochart::lsp {

/// Returns the declaration as written, without its body: `var x : nat = 1`, `function f(a : real) : real`.
[[nodiscard]] std::string signature_text(const frontend::Declaration&);
/// Returns the text after the name in a list: a type, a target, or the contents. It may be empty.
[[nodiscard]] std::string detail_of(const frontend::Declaration&);
/// Names the element that contains the declaration: "in stm `S`"; "" at package level.
[[nodiscard]] std::string parent_text(const frontend::Declaration&);
/// Returns the comment directly above a place, or after it on the same line, without comment marks; "" if there is
/// none.
[[nodiscard]] std::string comment_about(const SourceManager&, const frontend::File&, Span name);

/// Return the SymbolKind and the CompletionItemKind (LSP 3.17).
[[nodiscard]] int symbol_kind(const frontend::Declaration&);
[[nodiscard]] int completion_kind(const frontend::Declaration&);

}  // namespace robochart::lsp
