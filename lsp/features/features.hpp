// What the server does for an editor, one file each. Every request takes the session and the request's parameters and
// gives the result (LSP 3.17, language features).
#pragma once

#include "lsp/workspace/session.hpp"

namespace robochart::lsp {

// diagnostics.cpp
/// Sends diagnostics of every document where they changed.
void publish(Session&);

// code_actions.cpp
[[nodiscard]] Json code_actions(Session&, const Json& params);

// navigation.cpp
[[nodiscard]] Json definition(Session&, const Json& params);
[[nodiscard]] Json references(Session&, const Json& params);
[[nodiscard]] Json highlights(Session&, const Json& params);

// rename.cpp
[[nodiscard]] Json prepare_rename(Session&, const Json& params);
[[nodiscard]] Json rename(Session&, const Json& params);

// hover.cpp
[[nodiscard]] Json hover(Session&, const Json& params);

// symbols.cpp
[[nodiscard]] Json document_symbols(Session&, const Json& params);
[[nodiscard]] Json workspace_symbols(Session&, const Json& params);

// completion.cpp
[[nodiscard]] Json completion(Session&, const Json& params);

// signature_help.cpp
[[nodiscard]] Json signature_help(Session&, const Json& params);

// formatting.cpp
[[nodiscard]] Json formatting(Session&, const Json& params);

// folding.cpp
[[nodiscard]] Json folding_ranges(Session&, const Json& params);

// semantic_tokens.cpp
[[nodiscard]] Json semantic_tokens(Session&, const Json& params);
/// The names of token types and modifiers, in the order of their numbers.
[[nodiscard]] Json semantic_legend();

}  // namespace robochart::lsp
