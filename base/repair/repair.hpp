// SPDX-License-Identifier: Apache-2.0
// Applies certain fixes only if they improve the texts. Fixes are applied in memory, and then the texts are read again.
// A fix that does not help is undone.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/source.hpp"

namespace robochart::diagnostics {

/// Texts by the paths of their files.
using Texts = std::map<std::string, std::string>;

/// The texts after reading, and the findings in them.
struct TextReading {
    SourceManager sources;
    Diagnostics findings;
};
using ReadTexts = std::function<std::unique_ptr<TextReading>(const Texts&)>;

/// A fix that was not applied.
struct RefusedFix {
    std::string place;  ///< `path:line` of the finding
    std::string code;
    std::string replacement;
};

struct Repaired {
    Texts texts;  ///< the texts that were changed
    std::size_t made = 0;
    std::vector<RefusedFix> refused;
};

/// Applies the certain fixes of findings in these texts: first those of syntax errors, then those of other errors, then
/// those of warnings, because findings of one kind can hide those of the next. A group of fixes is applied if, for each
/// of its fixes, at least one finding of its kind disappears, and if no finding of this or an earlier kind is added.
/// Otherwise each half of the group is tried. `is_syntax` returns true for the rules of syntax.
[[nodiscard]] Repaired repair(const Texts&, const ReadTexts&, const std::function<bool(const Rule&)>& is_syntax);

}  // namespace robochart::diagnostics
