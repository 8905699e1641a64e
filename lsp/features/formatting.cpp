// Formatting in the standard layout (docs/format.md).
#include <algorithm>

#include "diagnostics/utf8.hpp"
#include "frontend/format/format.hpp"
#include "lsp/features/features.hpp"

namespace robochart::lsp {

namespace {

/// What lies between the common beginning and end of two texts, on bounds of characters, so that the editor keeps its
/// place.
struct Difference {
    Span span;
    std::string text;
};

Difference difference(SourceId source, std::string_view before, std::string_view after) {
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

/// A text with syntax errors is left as it is; its diagnostics say why.
Json formatting(Session& session, View params) {
    const Target target = target_of(session, params);
    const SourceManager& sources = target.project.sources();
    const SourceId source = target.document.source;
    diagnostics::Diagnostics ignored;
    const auto formatted = frontend::format(sources, source, target.document.is_assertions, ignored);
    if (!formatted) throw Refusal(ErrorCode::request_failed, "not formatted: the text has syntax errors");
    if (*formatted == sources.text(source)) return Json::array();
    const Difference change = difference(source, sources.text(source), *formatted);
    return Json::array(
        {Json::object({{"range", range(sources, change.span, session.client.encoding)}, {"newText", change.text}})});
}

}  // namespace robochart::lsp
