// SPDX-License-Identifier: Apache-2.0
// The features of the server, one file each. Every request handler gets the session and the parameters and returns the
// result (LSP 3.17, language features).
#pragma once

#include "editors/server/workspace/session.hpp"

namespace robochart::lsp {

// diagnostics.cpp
/// Sends the diagnostics of every document for which they changed.
void publish_diagnostics(Session&);
/// The findings of one document, for editors that request them.
[[nodiscard]] Json document_diagnostic(Session&, View params);

// code_actions.cpp
[[nodiscard]] Json code_actions(Session&, View params);

// navigation.cpp
[[nodiscard]] Json definition_locations(Session&, View params);
[[nodiscard]] Json reference_locations(Session&, View params);
[[nodiscard]] Json name_highlights(Session&, View params);

// call_hierarchy.cpp
[[nodiscard]] Json prepare_call_hierarchy(Session&, View params);
[[nodiscard]] Json incoming_calls(Session&, View params);
[[nodiscard]] Json outgoing_calls(Session&, View params);

// rename.cpp
[[nodiscard]] Json prepare_rename(Session&, View params);
[[nodiscard]] Json rename_edits(Session&, View params);

// hover.cpp
[[nodiscard]] Json hover_text(Session&, View params);

// symbols.cpp
[[nodiscard]] Json document_symbols(Session&, View params);
[[nodiscard]] Json workspace_symbols(Session&, View params);

// completion.cpp
[[nodiscard]] Json completion_items(Session&, View params);

// signature_help.cpp
[[nodiscard]] Json signature_help(Session&, View params);

// formatting.cpp
[[nodiscard]] Json formatting_edits(Session&, View params);

// inlay_hints.cpp
[[nodiscard]] Json inlay_hints(Session&, View params);

// code_lens.cpp
[[nodiscard]] Json code_lenses(Session&, View params);

// diagram.cpp
/// `{version, component, svg, elements, stale}`, or null if there is no component to draw.
[[nodiscard]] Json component_diagram(Session&, View params);

// folding.cpp
[[nodiscard]] Json folding_ranges(Session&, View params);

// selection_ranges.cpp
[[nodiscard]] Json selection_ranges(Session&, View params);

// semantic_tokens.cpp
[[nodiscard]] Json semantic_tokens(Session&, View params);
/// The names of token types and modifiers, in the order of their numbers.
[[nodiscard]] Json semantic_legend();

}  // namespace robochart::lsp
