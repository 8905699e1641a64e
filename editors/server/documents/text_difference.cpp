// SPDX-License-Identifier: Apache-2.0
#include "editors/server/documents/text_difference.hpp"

#include <algorithm>
#include <string>

#include "base/diagnostics/utf8.hpp"
#include "editors/server/documents/session.hpp"

namespace robochart::lsp {

namespace {

struct Difference {
    Span span;
    std::string text;
};

Difference find_difference(SourceId source, std::string_view before, std::string_view after) {
    std::size_t begin = 0;
    const std::size_t shorter = std::min(before.size(), after.size());
    while (begin < shorter && before[begin] == after[begin]) ++begin;
    while (begin > 0 && begin < before.size() && (diagnostics::is_continuation(before[begin]) || before[begin] == '\n'))
        --begin;
    std::size_t end = 0;
    while (end < shorter - begin && before[before.size() - 1 - end] == after[after.size() - 1 - end]) ++end;
    while (end > 0 && diagnostics::is_continuation(before[before.size() - end])) --end;
    return {{source, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(before.size() - end)},
            std::string(after.substr(begin, after.size() - end - begin))};
}

}  // namespace

Json text_edits(const SourceManager& sources, SourceId source, std::string_view after, Encoding encoding) {
    if (after == sources.source_text(source)) return Json::array();
    const Difference change = find_difference(source, sources.source_text(source), after);
    return Json::array(
        {Json::object({{"range", lsp_range(sources, change.span, encoding)}, {"newText", change.text}})});
}

Json formatting_edits(const SourceManager& sources, SourceId source, const std::optional<std::string>& formatted,
                      Encoding encoding) {
    if (!formatted) throw Refusal(ErrorCode::request_failed, "not formatted: the text has syntax errors");
    return text_edits(sources, source, *formatted, encoding);
}

}  // namespace robochart::lsp
