// SPDX-License-Identifier: Apache-2.0
// Shows information about the name at the pointer: its declaration with the comment, and the rules that report the
// name. For a keyword, shows its meaning.
#include <fmt/format.h>

#include <optional>

#include "editors/server/features/csp_blocks.hpp"
#include "editors/server/features/keywords.hpp"
#include "editors/server/features/models.hpp"
#include "editors/server/workspace/describe.hpp"
#include "frontend/syntax/lexer.hpp"

namespace robochart::lsp {

namespace {

using frontend::NameKind;
using frontend::Occurrence;

/// Returns the file that contains a declaration; this file may be a toolkit.
const frontend::File* file_of(Project& project, SourceId source) {
    for (const auto& file : project.current_model().files)
        if (file->source == source) return file.get();
    return nullptr;
}

std::string code_block(const std::string& text, bool markdown) {
    return markdown ? fmt::format("```robochart\n{}\n```", text) : text;
}

std::string about_declaration(Project& project, const frontend::Declaration& declaration, bool markdown) {
    std::string out = code_block(signature_text(declaration), markdown);
    const std::string where = parent_text(declaration);
    if (!where.empty()) out += "\n" + where;
    const frontend::File* file = file_of(project, declaration.name_span.source);
    if (file == nullptr) return out;
    if (where.empty() && !file->package.empty()) out += fmt::format("\nin package `{}`", file->package.text());
    const std::string comment = comment_about(project.sources(), *file, declaration.name_span);
    return comment.empty() ? out : out + "\n\n" + comment;
}

std::string describe_name(Project& project, const Occurrence& name, bool markdown) {
    switch (name.kind) {
        case NameKind::declaration:
        case NameKind::core_type:
            return name.target != nullptr ? about_declaration(project, *name.target, markdown) : std::string();
        case NameKind::package:
            return code_block("package " + name.text, markdown);
        case NameKind::process:
            return code_block("csp " + name.text, markdown);
        case NameKind::definition:
            return code_block(name.text, markdown);
        case NameKind::assertion: {
            const frontend::File* file = file_of(project, name.span.source);
            return code_block("assertion " + name.text, markdown) + "\n\n" +
                   comment_about(project.sources(), *file, name.span);
        }
        case NameKind::type_variable:
        case NameKind::unknown:
            break;
    }
    return {};
}

/// A keyword with its meaning.
struct Word {
    Span span;
    std::string_view text;
};

/// Returns the whole word. Keywords of assertions may contain hyphens, which the lexer treats as separate tokens.
Span whole_word(std::string_view text, Span span) {
    const auto belongs = [&](std::uint32_t at) { return (text[at] >= 'a' && text[at] <= 'z') || text[at] == '-'; };
    while (span.begin > 0 && belongs(span.begin - 1)) --span.begin;
    while (span.end < text.size() && belongs(span.end)) ++span.end;
    return span;
}

std::optional<Word> reserved_word_at(const Target& target) {
    const SourceManager& sources = target.project.sources();
    const std::string_view text = sources.source_text(target.document.source);
    const bool is_assertions = target.document.is_assertions;
    diagnostics::Diagnostics ignored;
    const frontend::TokenStream stream = frontend::tokenize(sources, target.document.source, is_assertions, ignored);
    for (const frontend::Token& token : stream.tokens) {
        if (token.span.end < target.offset) continue;
        if (token.span.begin > target.offset) break;
        const bool plain = token.kind == frontend::TokenKind::identifier && !token.escaped;
        if (token.kind != frontend::TokenKind::keyword && !(is_assertions && plain)) continue;
        const Span span = is_assertions ? whole_word(text, token.span) : token.span;
        const std::string_view word = text.substr(span.begin, span.end - span.begin);
        const std::string_view meaning = is_assertions ? meaning_of_assertion_word(word) : meaning_of_word(word);
        if (!meaning.empty()) return Word{span, meaning};
    }
    return std::nullopt;
}

/// Describes the name or the keyword at a place outside of CSP blocks.
Hover hover_over_text(const Target& target, bool markdown) {
    if (const Occurrence* name = target.project.occurrence_at(target.document.source, target.offset))
        return {describe_name(target.project, *name, markdown), name->span};
    if (const std::optional<Word> word = reserved_word_at(target)) return {std::string(word->text), word->span};
    return {};
}

}  // namespace

Json Models::hover(const Request& request) {
    const Target target = target_of(request);
    std::optional<Hover> hover = hover_in_block(session_, target);
    if (!hover) hover = hover_over_text(target, session_.client.markdown);
    return hover_answer(request, std::move(*hover), findings_about(target));
}

}  // namespace robochart::lsp
