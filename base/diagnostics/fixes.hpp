// SPDX-License-Identifier: Apache-2.0
// Selects certain fixes and applies fixes to texts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::diagnostics {

/// The title of a fix that is a guess. Fixes with other titles are certain.
inline constexpr std::string_view suggestion_title = "did you mean";

/// Returns true if the fix may be applied without asking the user.
[[nodiscard]] bool is_certain(const FixIt&);

/// Returns the certain fixes of one source in textual order, without overlaps. Only the first fix of a finding is used.
/// Of overlapping fixes, the one that begins first is used.
[[nodiscard]] std::vector<FixIt> certain_fixes(const Diagnostics&, SourceId source);

/// Returns the text with the fixes applied. The fixes must be sorted and must not overlap.
[[nodiscard]] std::string apply_fixes(std::string_view text, const std::vector<FixIt>& fixes);

/// Replaces a text file by a new version of its text (files.hpp: replace_file). A byte order mark is preserved. Returns
/// "" on success, and the cause of the failure otherwise.
[[nodiscard]] std::string replace_text(const std::string& path, std::string text, Budget* budget = nullptr);

}  // namespace robochart::diagnostics
