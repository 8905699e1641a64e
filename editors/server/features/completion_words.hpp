// SPDX-License-Identifier: Apache-2.0
// Lists the keywords that are allowed at a place, for completion (RoboChart.xtext, Assertions.xtext).
#pragma once

#include <string_view>
#include <vector>

#include "editors/server/features/completion_context.hpp"

namespace robochart::lsp {

/// A template of a member, with placeholders of LSP snippets.
struct Snippet {
    std::string_view label;
    std::string_view text;
};

/// Returns the keywords that begin a member of a body. In a transition, returns only keywords that may follow its last
/// clause.
[[nodiscard]] std::vector<std::string_view> member_words(Block block, std::string_view last_clause);
/// Returns the keywords of RoboSim that begin a member of a body, or that follow the source and target of a transition.
[[nodiscard]] std::vector<std::string_view> robosim_member_words(Block block);
[[nodiscard]] const std::vector<std::string_view>& assertion_member_words();
/// Returns the keywords that may follow a complete operand.
[[nodiscard]] std::vector<std::string_view> infix_words(Block block, bool is_assertions);
[[nodiscard]] const std::vector<std::string_view>& type_words();
[[nodiscard]] const std::vector<std::string_view>& expression_words();
[[nodiscard]] const std::vector<std::string_view>& statement_words();
[[nodiscard]] const std::vector<std::string_view>& property_words();
[[nodiscard]] const std::vector<std::string_view>& toolkit_packages();
[[nodiscard]] const std::vector<Snippet>& snippets_for(Block block);

}  // namespace robochart::lsp
