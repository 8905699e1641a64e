// SPDX-License-Identifier: Apache-2.0
// Selects fixes that do not overlap and applies them in one pass. Of overlapping fixes, the one that begins first is
// selected.
#include "base/diagnostics/fixes.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/diagnostics/files.hpp"
#include "base/diagnostics/utf8.hpp"

namespace robochart::diagnostics {

bool is_certain(const FixIt& fix) {
    return fix.title != suggestion_title;
}

std::vector<FixIt> certain_fixes(const Diagnostics& diagnostics, SourceId source) {
    std::vector<FixIt> all;
    for (const Diagnostic& finding : diagnostics.sorted_findings())
        if (!finding.fixes.empty() && is_certain(finding.fixes.front()) && finding.fixes.front().span.source == source)
            all.push_back(finding.fixes.front());
    std::ranges::stable_sort(all, [](const FixIt& a, const FixIt& b) { return a.span.begin < b.span.begin; });
    std::vector<FixIt> chosen;
    for (FixIt& fix : all) {
        // Two insertions at the same place are not combined, because their order would be arbitrary.
        const bool free = chosen.empty() || fix.span.begin > chosen.back().span.end ||
                          (fix.span.begin == chosen.back().span.end && fix.span.end > fix.span.begin &&
                           chosen.back().span.end > chosen.back().span.begin);
        if (free) chosen.push_back(std::move(fix));
    }
    return chosen;
}

std::string apply_fixes(std::string_view text, const std::vector<FixIt>& fixes) {
    std::string out;
    std::size_t at = 0;
    for (const FixIt& fix : fixes) {
        out += text.substr(at, fix.span.begin - at);
        out += fix.replacement;
        at = fix.span.end;
    }
    return out.append(text.substr(at));
}

std::string replace_text(const std::string& path, std::string text, Budget* budget) {
    std::error_code code;
    std::string begin(byte_order_mark.size(), '\0');
    if (std::filesystem::is_regular_file(path, code))
        std::ifstream(path, std::ios::binary).read(begin.data(), std::ssize(begin));
    if (begin == byte_order_mark) text.insert(0, byte_order_mark);
    return replace_file(path, text, budget);
}

}  // namespace robochart::diagnostics
