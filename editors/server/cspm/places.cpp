// SPDX-License-Identifier: Apache-2.0
#include "editors/server/cspm/places.hpp"

#include <algorithm>
#include <tuple>

#include "checker/cspm/syntax/lexer.hpp"

namespace robochart::lsp {

namespace {

bool covers_offset(Span span, SourceId source, std::uint32_t offset) {
    return span.source == source && span.begin <= offset && offset <= span.end;
}

std::uint32_t span_length(Span span) {
    return span.end - span.begin;
}

/// Returns the shortest of the uses that contain a place.
std::optional<NameAt> use_at(const ScriptReading& reading, SourceId source, std::uint32_t offset) {
    std::optional<NameAt> best;
    const auto& uses = reading.names.uses;
    const auto behind = std::ranges::upper_bound(uses, std::tuple(source, offset), {}, [](const auto& use) {
        return std::tuple(use.span.source, use.span.begin);
    });
    // Spans of names overlap only if one is part of a qualified name, so few neighbours must be checked.
    constexpr std::ptrdiff_t looked_at = 4;
    for (auto use = behind; use != uses.begin() && behind - use < looked_at;) {
        --use;
        if (!covers_offset(use->span, source, offset) || (best && span_length(best->span) <= span_length(use->span)))
            continue;
        best = NameAt{&reading.names.names[use->name], use->span};
    }
    return best;
}

std::string_view word_at(std::string_view text, std::size_t offset) {
    std::size_t begin = std::min(offset, text.size());
    std::size_t end = begin;
    while (begin > 0 && cspm::continues_name(text[begin - 1])) --begin;
    while (end < text.size() && cspm::continues_name(text[end])) ++end;
    return text.substr(begin, end - begin);
}

std::optional<NameAt> declaration_at(const ScriptReading& reading, SourceId source, std::uint32_t offset) {
    const std::string_view word = word_at(reading.sources.source_text(source), offset);
    std::optional<NameAt> best;
    std::uint32_t shortest = 0;
    for (const cspm::KnownName& known_name : reading.names.names) {
        if (!covers_offset(known_name.span, source, offset) || short_name(known_name.name) != word) continue;
        if (best && shortest <= span_length(known_name.span)) continue;
        const Span place = name_place(reading.sources, known_name.span, known_name.name);
        if (!covers_offset(place, source, offset) || place.begin == place.end) continue;
        best = NameAt{&known_name, place};
        shortest = span_length(known_name.span);
    }
    return best;
}

}  // namespace

std::string_view short_name(std::string_view qualified) {
    const std::size_t colon = qualified.rfind(':');
    return colon == std::string_view::npos ? qualified : qualified.substr(colon + 1);
}

Span name_place(const SourceManager& sources, Span declaration, std::string_view name) {
    const std::string_view text =
        sources.source_text(declaration.source).substr(declaration.begin, span_length(declaration));
    const std::string_view word = short_name(name);
    diagnostics::Diagnostics ignored;
    for (const cspm::Token& token : cspm::lex(text, declaration.source, ignored))
        if (token.kind == cspm::Tok::identifier && token.text == word)
            return {declaration.source, declaration.begin + token.span.begin, declaration.begin + token.span.end};
    return {declaration.source, declaration.begin, declaration.begin};
}

std::optional<NameAt> name_at(const ScriptReading& reading, SourceId source, std::uint32_t offset) {
    const std::optional<NameAt> use = use_at(reading, source, offset);
    return use ? use : declaration_at(reading, source, offset);
}

}  // namespace robochart::lsp
