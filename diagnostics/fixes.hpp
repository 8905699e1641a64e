// Applying fixes to texts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.hpp"

namespace robochart::diagnostics {

/// Title of a fix that is a guess; every other fix is certain.
inline constexpr std::string_view suggestion_title = "did you mean";

/// May it be applied without asking?
[[nodiscard]] bool is_certain(const FixIt&);

/// The certain fixes of one source in the order of the text, no two of them overlapping: the first fix of
/// each finding, earlier ones first.
[[nodiscard]] std::vector<FixIt> certain_fixes(const Diagnostics&, SourceId source);

/// The text with the fixes applied; they are sorted and do not overlap.
[[nodiscard]] std::string apply_fixes(std::string_view text, const std::vector<FixIt>& fixes);

/// Puts another version of a text in the place of the one that was read from there (files.hpp: replace_file): a byte
/// order mark in front of it stays. Returns the cause in words on failure, "" on success.
[[nodiscard]] std::string replace_text(const std::string& path, std::string text, Budget* budget = nullptr);

}  // namespace robochart::diagnostics
