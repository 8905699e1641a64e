// SPDX-License-Identifier: Apache-2.0
// Finds comments. Text between tokens that is not blank is a comment. Text inside a string literal is never a comment.
#include "csp_emit/base/block_comments.hpp"

#include <algorithm>
#include <string>

#include "base/diagnostics/escape.hpp"
#include "checker/cspm/syntax/lexer.hpp"

namespace robochart::csp_emit {
namespace {

using cspm::Decl;
using cspm::DeclPtr;

struct Comment {
    std::size_t at = 0;
    std::string text;  ///< its lines, each terminated by a line end
};

std::string_view trim_blanks(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n\f\v";
    const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
    return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

void add_comment(std::vector<Comment>& result, std::size_t at, std::string_view inside) {
    Comment comment{at, ""};
    for (inside = trim_blanks(inside); !inside.empty();) {
        const std::size_t end = std::min(inside.find('\n'), inside.size());
        comment.text += diagnostics::escape_for_display(trim_blanks(inside.substr(0, end))) + "\n";
        inside.remove_prefix(std::min(end + 1, inside.size()));
    }
    if (!comment.text.empty()) result.push_back(std::move(comment));
}

/// Returns the end of the comment that begins at `at`. Block comments may be nested.
std::size_t end_of(std::string_view text, std::size_t at) {
    if (text.substr(at, 2) == "--") return std::min(text.find('\n', at), text.size());
    std::size_t depth = 1;
    for (at += 2; at < text.size() && depth > 0; ++at) {
        const std::string_view next = text.substr(at, 2);
        if (next == "{-") ++depth;
        if (next == "-}") --depth;
        if (next == "{-" || next == "-}") ++at;
    }
    return std::min(at, text.size());
}

/// Collects the comments between two tokens.
void collect_comments(std::string_view text, std::size_t from, std::size_t to, std::vector<Comment>& result) {
    for (std::size_t at = from; at + 1 < to;) {
        const std::string_view next = text.substr(at, 2);
        if (next != "--" && next != "{-") {
            ++at;
            continue;
        }
        const std::size_t end = end_of(text, at);
        const std::size_t closing = next == "{-" && text.substr(0, end).ends_with("-}") ? 2 : 0;
        add_comment(result, at, text.substr(at + 2, std::max(end - closing, at + 2) - at - 2));
        at = end;
    }
}

std::vector<Comment> comments_of(std::string_view text) {
    diagnostics::Diagnostics unread;  // `text` has already been checked, so new findings are dropped
    std::vector<Comment> result;
    std::size_t at = 0;
    for (const cspm::Token& token : cspm::lex(text, diagnostics::SourceId::none, unread)) {
        collect_comments(text, at, token.span.begin, result);
        at = std::max<std::size_t>(at, token.span.end);
    }
    collect_comments(text, at, text.size(), result);
    return result;
}

class Attaching {
public:
    explicit Attaching(std::string_view text) : text_(text), comments_(comments_of(text)) {}

    std::vector<DeclPtr> attach_all(const std::vector<DeclPtr>& decls, std::size_t end) {
        std::vector<DeclPtr> result;
        for (std::size_t i = 0; i < decls.size(); ++i) {
            const bool last = i + 1 == decls.size();
            result.push_back(attach_to(*decls[i], last ? end : line_end(decls[i]->span.end)));
        }
        return result;
    }

private:
    [[nodiscard]] std::size_t line_end(std::size_t at) const { return std::min(text_.find('\n', at), text_.size()); }
    /// Returns the comments that begin before `end` and are not yet attached to a declaration.
    std::string take_comments_before(std::size_t end) {
        std::string result;
        for (; next_ < comments_.size() && comments_[next_].at < end; ++next_) result += comments_[next_].text;
        return result;
    }
    DeclPtr attach_to(const Decl& decl, std::size_t end) {
        auto result = std::make_shared<Decl>(decl);
        result->comment = take_comments_before(decl.span.begin);
        const std::size_t own =
            decl.exports.empty() || decl.decls.empty() ? decl.span.end : line_end(decl.decls.back()->span.end);
        result->decls = attach_all(decl.decls, own);
        result->exports = attach_all(decl.exports, decl.span.end);
        result->comment += take_comments_before(end);
        return result;
    }

    std::string_view text_;
    std::vector<Comment> comments_;
    std::size_t next_ = 0;
};

}  // namespace

std::vector<DeclPtr> with_comments(const std::vector<DeclPtr>& decls, std::string_view text) {
    return Attaching(text).attach_all(decls, text.size());
}

}  // namespace robochart::csp_emit
