// See format.hpp: reading, the words, and the comparison of the result with the text.
#include "frontend/format.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "frontend/format_layout.hpp"
#include "frontend/project.hpp"

namespace robochart::frontend {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// A text in words, with what the words are views of.
struct Words {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    TokenStream stream;

    Words(const std::string& text, bool is_assertions) {
        const auto source = sources.add("", text);
        stream = tokenize(sources, source, is_assertions, findings);
    }
    [[nodiscard]] std::string_view text(diagnostics::Span span) const {
        return sources.text(span.source).substr(span.begin, span.end - span.begin);
    }
};

/// The next character of a comment, each run of blanks and line ends at a line's begin or end taken for one line end.
struct CommentReader {
    std::string_view text;
    std::size_t at = 0;

    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
    /// 0 at the end.
    char next() {
        if (at >= text.size()) return '\0';
        std::size_t end = at;
        while (end < text.size() && is_blank(text[end])) ++end;
        const std::string_view run = text.substr(at, end - at);
        const bool edge = end == text.size() || run.find_first_of("\r\n") != std::string_view::npos;
        if (run.empty() || !edge) return text[at++];
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

std::vector<std::size_t> sizes(const std::vector<std::string>& parts) {
    std::vector<std::size_t> result;
    for (const std::string& part : parts) result.push_back(part.size());
    return result;
}

}  // namespace

bool same_words(const std::string& a, const std::string& b, bool is_assertions) {
    const Words left(a, is_assertions);
    const Words right(b, is_assertions);
    const auto same_token = [&](const Token& x, const Token& y) {
        return x.kind == y.kind && x.escaped == y.escaped && left.text(x.span) == right.text(y.span);
    };
    const auto same_comments = [&](diagnostics::Span x, diagnostics::Span y) {
        return same_comment(left.text(x), right.text(y));
    };
    const auto& [tokens, comments] = left.stream;
    const auto& others = right.stream;
    return std::equal(tokens.begin(), tokens.end(), others.tokens.begin(), others.tokens.end(), same_token) &&
           std::equal(comments.begin(), comments.end(), others.comments.begin(), others.comments.end(), same_comments);
}

std::optional<std::string> format(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                                  bool is_assertions, diagnostics::Diagnostics& out) {
    const auto file = parse(sources, source, is_assertions, out);
    if (file->has_syntax_errors) return std::nullopt;
    diagnostics::Diagnostics reported;  // the parser's
    const TokenStream stream = tokenize(sources, source, is_assertions, reported);
    const std::string_view text = sources.text(source);
    std::string result = Layout(text, stream, is_assertions, sizes(file->verbatim)).run(line_end(text));
    if (text.starts_with(byte_order_mark)) result.insert(0, byte_order_mark);
    if (!same_words(std::string(text), result, is_assertions))
        throw std::logic_error("formatting " + sources.path(source) + " would change its words");
    return result;
}

// ---------------------------------------------------------------- words

Layout::Layout(std::string_view text, const TokenStream& stream, bool is_assertions, std::vector<std::size_t> verbatim)
    : text_(text), stream_(stream), is_assertions_(is_assertions), verbatim_(std::move(verbatim)) {
    if (text.starts_with(byte_order_mark)) previous_end_ = byte_order_mark.size();
}

const Token& Layout::peek(std::size_t ahead) const {
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
