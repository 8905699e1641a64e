// SPDX-License-Identifier: Apache-2.0
// Suggests the known word that is nearest to a misspelt word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace robochart::diagnostics {

/// Returns the candidate nearest to a misspelt name, or "" if no candidate is near enough.
[[nodiscard]] std::string nearest_spelling(std::string_view name, const std::vector<std::string>& candidates);
/// Returns true if `meant` is certainly the intended word: it differs by at most two letters, and no other candidate is
/// as near.
[[nodiscard]] bool is_certain(std::string_view name, std::string_view meant,
                              const std::vector<std::string>& candidates);
/// Returns the title of a fix that suggests another name.
[[nodiscard]] std::string suggestion_verb(bool certain);

}  // namespace robochart::diagnostics
