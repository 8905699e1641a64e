// SPDX-License-Identifier: Apache-2.0
// See format.hpp. Reads the text, lays out its tokens, and compares the result with the text.
#include "frontend/format/format.hpp"

#include <algorithm>
#include <stdexcept>

#include "frontend/format/format_assertions.hpp"
#include "frontend/format/format_model.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"

namespace robochart::frontend {

namespace {

/// A text and its tokens.
struct Words {
    std::string_view text;
    const TokenStream& stream;

    [[nodiscard]] std::string_view text_at(diagnostics::Span span) const {
        return text.substr(span.begin, span.end - span.begin);
    }
};

/// Returns the tokens of a text. Syntax errors are ignored: either the text has been parsed before, or errors do not
/// change the result.
TokenStream words_of(const diagnostics::SourceManager& sources, diagnostics::SourceId source, bool is_assertions) {
    diagnostics::Diagnostics ignored;
    return tokenize(sources, source, is_assertions, ignored);
}

/// Reads a comment character by character. Blanks and line ends at the beginning or end of a line are read as one line
/// end.
struct CommentReader {
    std::string_view text;
    std::size_t at = 0;
    std::size_t plain_until = 0;  ///< blanks before this offset are inside a line

    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
    /// Returns the next character, or 0 at the end.
    char next_character() {
        if (at >= text.size()) return '\0';
        if (at < plain_until || !is_blank(text[at])) return text[at++];
        const std::size_t end = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
        const bool edge =
            end == text.size() || text.substr(at, end - at).find_first_of("\r\n") != std::string_view::npos;
        if (!edge) {
            plain_until = end;
            return text[at++];
        }
        at = end;
        return end == text.size() ? '\0' : '\n';
    }
};

bool same_comment(std::string_view a, std::string_view b) {
    CommentReader left{a};
    CommentReader right{b};
    for (;;) {
        const char c = left.next_character();
        if (c != right.next_character()) return false;
        if (c == '\0') return true;
    }
}

/// Returns the line end to write: CRLF if the whole text uses CRLF, otherwise LF.
std::string_view line_end(std::string_view text) {
    std::size_t crlf = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] != '\n' && text[at] != '\r') continue;
        if (text.substr(at, 2) != "\r\n") return "\n";
        ++at;
        ++crlf;
    }
    return crlf > 0 ? "\r\n" : "\n";
}

bool same_tokens(const Words& a, const Words& b) {
    const auto same_token = [&](const Token& x, const Token& y) {
        return x.kind == y.kind && x.escaped == y.escaped && a.text_at(x.span) == b.text_at(y.span);
    };
    const auto same_comments = [&](diagnostics::Span x, diagnostics::Span y) {
        return same_comment(a.text_at(x), b.text_at(y));
    };
    const auto& [tokens, comments] = a.stream;
    const auto& [other_tokens, other_comments] = b.stream;
    return std::equal(tokens.begin(), tokens.end(), other_tokens.begin(), other_tokens.end(), same_token) &&
           std::ranges::equal(comments, other_comments, same_comments);
}

/// Tokenizes `other` in the dialect of `path`. True if it has the same tokens and comments as `words`.
bool same_tokens(const Words& words, const std::string& other, const std::string& path, bool is_assertions) {
    diagnostics::SourceManager sources;
    const auto source = sources.add(path, other);
    const TokenStream stream = words_of(sources, source, is_assertions);
    return same_tokens(words, {sources.source_text(source), stream});
}

/// Returns the spans of the parts of an assertion file that are copied as text, or no value if there are syntax errors.
std::optional<std::vector<diagnostics::Span>> kept_parts(const diagnostics::SourceManager& sources,
                                                         diagnostics::SourceId source, bool is_assertions,
                                                         diagnostics::Diagnostics& out) {
    const auto file = parse(sources, source, is_assertions, out);
    if (file->has_syntax_errors) return std::nullopt;
    std::vector<diagnostics::Span> places;
    for (const KeptPart& part : file->kept) places.push_back(part.whole);
    return places;
}

}  // namespace

bool same_words(const std::string& a, const std::string& b, bool is_assertions, const std::string& path) {
    diagnostics::SourceManager sources;
    const auto source = sources.add(path, a);
    const TokenStream stream = words_of(sources, source, is_assertions);
    return same_tokens({sources.source_text(source), stream}, b, path, is_assertions);
}

std::optional<std::string> format(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                                  bool is_assertions, diagnostics::Diagnostics& out) {
    auto foreign_spans = kept_parts(sources, source, is_assertions, out);
    if (!foreign_spans) return std::nullopt;
    const std::string_view text = sources.source_text(source);
    const TokenStream stream = words_of(sources, source, is_assertions);
    std::string result = is_assertions ? AssertionLayout(text, stream, std::move(*foreign_spans)).run(line_end(text))
                                       : ModelLayout(text, stream).run(line_end(text));
    if (!same_tokens({text, stream}, result, sources.path(source), is_assertions))
        throw std::logic_error("formatting " + sources.path(source) + " would change its words");
    return result;
}

}  // namespace robochart::frontend
