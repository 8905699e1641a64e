// Applying mends to texts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.hpp"

namespace robochart::diagnostics {

/// Title of a mend that is a guess; every other mend is certain.
inline constexpr std::string_view suggestion_title = "did you mean";

/// May it be applied without asking?
[[nodiscard]] bool is_certain(const FixIt&);

/// The certain mends of one source in the order of the text, no two of them touching the same place: the first mend of
/// each finding, earlier ones first.
[[nodiscard]] std::vector<FixIt> certain_fixes(const Diagnostics&, SourceId source);

/// The text with the mends in it; they are sorted and do not overlap.
[[nodiscard]] std::string apply_fixes(std::string_view text, const std::vector<FixIt>& fixes);

}  // namespace robochart::diagnostics
