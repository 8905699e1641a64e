// SPDX-License-Identifier: Apache-2.0
// Contains the code that the lexers of all languages share: a position in a text, and moves over words, digits and
// symbols. Everything is inline for speed, because scripts have many megabytes. Characters are treated as ASCII in
// every locale.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ranges>
#include <string_view>

#include "base/diagnostics/source.hpp"
#include "base/diagnostics/utf8.hpp"

namespace robochart::diagnostics {

[[nodiscard]] constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
/// Returns true for letters and `_`.
[[nodiscard]] constexpr bool begins_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
[[nodiscard]] constexpr bool continues_name(char c) {
    return begins_name(c) || is_digit(c);
}

/// The base class of lexers. When the position is beyond the end of the text, a lexer may only call `at_end` and
/// `peek`.
class Scanner {
protected:
    explicit Scanner(std::string_view text, SourceId source = SourceId::none) : text_(text), source_(source) {}

    [[nodiscard]] bool at_end() const { return at_ >= text_.size(); }
    /// Returns a character at or after the position, or NUL after the end of the text.
    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }
    [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }
    [[nodiscard]] bool looking_at(std::string_view what) const { return text_.substr(at_, what.size()) == what; }
    /// Returns the end of the current line, which is before its line feed.
    [[nodiscard]] std::size_t line_end() const { return std::min(text_.find('\n', at_), text_.size()); }
    [[nodiscard]] std::string_view text_from(std::size_t begin) const { return text_.substr(begin, at_ - begin); }
    [[nodiscard]] Span span_from(std::size_t begin) const {
        return {source_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)};
    }

    /// Moves past this text if the text is at the position.
    bool accept(std::string_view what) {
        const bool found = looking_at(what);
        if (found) at_ += what.size();
        return found;
    }
    /// Moves past the first entry of a table that is at the position, and returns the entry. Returns null if no entry
    /// is there. If the table lists longer spellings first, this is the longest match.
    template <class Table, class Spelling = std::identity>
    const std::ranges::range_value_t<Table>* accept_first(const Table& table, Spelling spelling = {}) {
        const char first = peek();
        for (const auto& entry : table) {
            const std::string_view text = std::invoke(spelling, entry);
            if (text.front() == first && accept(text)) return &entry;
        }
        return nullptr;
    }

    template <class Skipped>
    void skip_while(Skipped skipped) {
        while (!at_end() && skipped(text_[at_])) ++at_;
    }
    void skip_digits() { skip_while(is_digit); }
    void skip_name() { skip_while(continues_name); }
    /// Moves past one byte and the continuation bytes of UTF-8 after it.
    void skip_character() {
        ++at_;
        skip_while(is_continuation);
    }
    /// Moves to the next of these characters, or to the end of the text.
    void skip_to(std::string_view characters) { at_ = std::min(text_.find_first_of(characters, at_), text_.size()); }
    /// Moves past the next occurrence of `closing`. If there is none, moves to the end of the text and returns false.
    bool skip_past(std::string_view closing) {
        const std::size_t found = text_.find(closing, at_);
        at_ = found == std::string_view::npos ? text_.size() : found + closing.size();
        return found != std::string_view::npos;
    }

    std::string_view text_;
    SourceId source_;
    std::size_t at_ = 0;
};

}  // namespace robochart::diagnostics
