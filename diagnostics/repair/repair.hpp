// Certain fixes, applied only where the texts read better with them: they are applied in memory, the texts are read
// again, and what is not better is left as it was.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "diagnostics/source.hpp"

namespace robochart::diagnostics {

/// Texts by the paths of their files.
using Texts = std::map<std::string, std::string>;

/// Texts that were read, with what was found in them.
struct TextReading {
    SourceManager sources;
    Diagnostics findings;
};
using ReadTexts = std::function<std::unique_ptr<TextReading>(const Texts&)>;

/// A fix that was not made.
struct RefusedFix {
    std::string place;  ///< `path:line` of the finding
    std::string code;
    std::string replacement;
};

struct Repaired {
    Texts texts;  ///< those that changed
    std::size_t made = 0;
    std::vector<RefusedFix> refused;
};

/// Applies the certain fixes of findings in these texts: first those of syntax, then those of other errors, then those
/// of warnings, since each of these may show only where the ones before it are gone. A group of fixes is made if it
/// removes a finding of its kind for each of its fixes and brings none of its kind or of one before it; otherwise each
/// half of the group is tried. `is_syntax` says which rules are those of syntax.
[[nodiscard]] Repaired repair(const Texts&, const ReadTexts&, const std::function<bool(const Rule&)>& is_syntax);

}  // namespace robochart::diagnostics
