// See format.hpp: reading, the words, and the comparison of the result with the text.
#include "frontend/format/format.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "frontend/format/format_layout.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"

namespace robochart::frontend {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// A text in words.
struct Words {
    std::string_view text;
    const TokenStream& stream;

    [[nodiscard]] std::string_view at(diagnostics::Span span) const {
        return text.substr(span.begin, span.end - span.begin);
    }
};

/// The words of a text that is known to be free of mistakes, or that nobody asks about them.
TokenStream words_of(const diagnostics::SourceManager& sources, diagnostics::SourceId source, bool is_assertions) {
    diagnostics::Diagnostics ignored;
    return tokenize(sources, source, is_assertions, ignored);
}

/// The characters of a comment, each run of blanks and line ends at a line's begin or end taken for one line end.
struct CommentReader {
    std::string_view text;
    std::size_t at = 0;
    std::size_t plain_until = 0;  ///< blanks before this offset stand inside a line

    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
    /// 0 at the end.
    char next() {
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
        const char c = left.next();
        if (c != right.next()) return false;
        if (c == '\0') return true;
    }
}

/// The line end to write: a text that has CRLF everywhere keeps it.
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

bool same(const Words& a, const Words& b) {
    const auto same_token = [&](const Token& x, const Token& y) {
        return x.kind == y.kind && x.escaped == y.escaped && a.at(x.span) == b.at(y.span);
    };
    const auto same_comments = [&](diagnostics::Span x, diagnostics::Span y) { return same_comment(a.at(x), b.at(y)); };
    const auto& [tokens, comments] = a.stream;
    const auto& [other_tokens, other_comments] = b.stream;
    return std::equal(tokens.begin(), tokens.end(), other_tokens.begin(), other_tokens.end(), same_token) &&
           std::equal(comments.begin(), comments.end(), other_comments.begin(), other_comments.end(), same_comments);
}

/// Does the text have the same words as the other, which is not read yet?
bool same(const Words& words, const std::string& other, bool is_assertions) {
    diagnostics::SourceManager sources;
    const auto source = sources.add("", other);
    const TokenStream stream = words_of(sources, source, is_assertions);
    return same(words, {sources.text(source), stream});
}

/// Lengths of the parts of an assertion file that are kept as text; nothing if there are syntax errors.
std::optional<std::vector<std::size_t>> verbatim_parts(const diagnostics::SourceManager& sources,
                                                       diagnostics::SourceId source, bool is_assertions,
                                                       diagnostics::Diagnostics& out) {
    const auto file = parse(sources, source, is_assertions, out);
    if (file->has_syntax_errors) return std::nullopt;
    std::vector<std::size_t> lengths;
    for (const std::string& part : file->verbatim) lengths.push_back(part.size());
    return lengths;
}

}  // namespace

bool same_words(const std::string& a, const std::string& b, bool is_assertions) {
    diagnostics::SourceManager sources;
    const auto source = sources.add("", a);
    const TokenStream stream = words_of(sources, source, is_assertions);
    return same({sources.text(source), stream}, b, is_assertions);
}

std::optional<std::string> format(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                                  bool is_assertions, diagnostics::Diagnostics& out) {
    auto verbatim = verbatim_parts(sources, source, is_assertions, out);
    if (!verbatim) return std::nullopt;
    const std::string_view text = sources.text(source);
    const TokenStream stream = words_of(sources, source, is_assertions);
    std::string result = Layout(text, stream, is_assertions, std::move(*verbatim)).run(line_end(text));
    if (text.starts_with(byte_order_mark)) result.insert(0, byte_order_mark);
    if (!same({text, stream}, result, is_assertions))
        throw std::logic_error("formatting " + sources.path(source) + " would change its words");
    return result;
}

// ---------------------------------------------------------------- words

Layout::Layout(std::string_view text, const TokenStream& stream, bool is_assertions, std::vector<std::size_t> verbatim)
    : text_(text), stream_(stream), is_assertions_(is_assertions), verbatim_(std::move(verbatim)) {
    if (text.starts_with(byte_order_mark)) previous_end_ = byte_order_mark.size();
}

Token Layout::peek(std::size_t ahead) const {
    return stream_.tokens[std::min(at_ + ahead, stream_.tokens.size() - 1)];
}

bool Layout::at_word(std::string_view word, std::size_t ahead) const {
    const Token& token = peek(ahead);
    const bool word_like = token.kind == TokenKind::identifier || token.kind == TokenKind::keyword;
    return word_like && !token.escaped && token.text == word;
}

bool Layout::at_closing() const {
    constexpr std::array<std::string_view, 6> closing = {")", "]", "}", "|)", "|]", ">"};
    return at_end() || std::any_of(closing.begin(), closing.end(), [&](std::string_view word) { return at(word); });
}

std::string_view Layout::source(diagnostics::Span span) const {
    return text_.substr(span.begin, span.end - span.begin);
}

/// The word here as it is written, without a gap.
Doc Layout::advance() {
    const Token& token = peek();
    const Doc result = doc_.text(source(token.span));
    previous_end_ = token.span.end;
    if (!at_end()) ++at_;
    return result;
}

Doc Layout::token(Gap gap) {
    const Doc before = this->gap(gap);
    return doc_.cat(before, advance());
}

/// Words with blanks between.
Doc Layout::words(Gap gap, std::size_t count) {
    Doc result = token(gap);
    while (--count > 0) result = doc_.cat(result, token(Gap::blank));
    return result;
}

/// `A::B::C`
Doc Layout::names(Gap gap) {
    Doc result = token(gap);
    while (at("::") && !peek(1).is("*")) result = cat({result, token(Gap::none), token(Gap::none)});
    return result;
}

std::string Layout::run(std::string_view line_end) {
    Printer printer(doc_, line_end);
    Gap gap = Gap::start;
    while (!at_end()) {
        printer.print(is_assertions_ ? assertion_member(gap) : member(gap));
        doc_.clear();
        gap = Gap::member;
    }
    printer.print(cat({closing_comments(), at_ > 0 || comment_ > 0 ? doc_.hard() : 0}));
    return printer.take();
}

}  // namespace robochart::frontend
