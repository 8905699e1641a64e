// SPDX-License-Identifier: Apache-2.0
// Suggests the known word that is nearest to a misspelt word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace robochart::diagnostics {

/// The candidate nearest to a misspelt name, if it is near enough; otherwise "".
[[nodiscard]] std::string nearest_spelling(std::string_view name, const std::vector<std::string>& candidates);
/// True if `meant` is certainly the intended word: it differs by at most two letters, and no other candidate is as
/// near.
[[nodiscard]] bool is_certain(std::string_view name, std::string_view meant,
                              const std::vector<std::string>& candidates);
/// The title of a fix that suggests another name.
[[nodiscard]] std::string suggestion_verb(bool certain);

}  // namespace robochart::diagnostics
