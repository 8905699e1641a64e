// SPDX-License-Identifier: Apache-2.0
// Applies fixes to texts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::diagnostics {

/// The title of a fix that is a guess; all other fixes are certain.
inline constexpr std::string_view suggestion_title = "did you mean";

/// True if the fix may be applied without asking.
[[nodiscard]] bool is_certain(const FixIt&);

/// The certain fixes of one source in textual order, without overlaps. Only the first fix of a finding is used, and
/// earlier fixes are preferred.
[[nodiscard]] std::vector<FixIt> certain_fixes(const Diagnostics&, SourceId source);

/// The text with the fixes applied. They must be sorted and must not overlap.
[[nodiscard]] std::string apply_fixes(std::string_view text, const std::vector<FixIt>& fixes);

/// Replaces a text file by a new version of its text (files.hpp: replace_file); a byte order mark is kept. Returns the
/// cause in words on failure, "" on success.
[[nodiscard]] std::string replace_text(const std::string& path, std::string text, Budget* budget = nullptr);

}  // namespace robochart::diagnostics
