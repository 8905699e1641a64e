// SPDX-License-Identifier: Apache-2.0
// See move_claims.hpp.
#include "frontend/project/move_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace robochart::frontend {
namespace {

/// Returns the span of the part, including the rest of its last line if that is blank.
diagnostics::Span whole_lines(diagnostics::Span part, std::string_view text) {
    std::size_t end = part.end;
    while (end < text.size() && (text[end] == ' ' || text[end] == '\t' || text[end] == '\r')) ++end;
    if (end < text.size() && text[end] == '\n') part.end = static_cast<std::uint32_t>(end + 1);
    return part;
}

}  // namespace

bool is_claim(const KeptPart& part) {
    constexpr std::array forms{"claim", "assume", "order", "unit"};
    return std::ranges::find(forms, part.form) != forms.end();
}

std::optional<MovedClaims> move_claims(const File& file, const diagnostics::SourceManager& sources) {
    MovedClaims result;
    std::string claims;
    for (const KeptPart& part : file.kept) {
        if (!is_claim(part)) continue;
        claims += part.text + "\n";
        result.removals.push_back(whole_lines(part.whole, sources.source_text(file.source)));
    }
    if (result.removals.empty()) return std::nullopt;
    std::ranges::sort(result.removals, {}, &diagnostics::Span::begin);
    const std::string path(sources.path(file.source));
    result.path = path.substr(0, path.rfind('.')) + ".claims";
    if (!file.package.text().empty()) result.text += fmt::format("import {}::*\n", file.package.text());
    for (const Import& import : file.imports)
        result.text += fmt::format("import {}{}\n", import.name.text(), import.wildcard ? "::*" : "");
    if (!result.text.empty()) result.text += "\n";
    result.text += claims;
    return result;
}

}  // namespace robochart::frontend
