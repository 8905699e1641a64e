// SPDX-License-Identifier: Apache-2.0
// See format.hpp.
#include "claims/sleec/syntax/format.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "base/words/item_layout.hpp"
#include "claims/sleec/syntax/lexer.hpp"
#include "claims/sleec/syntax/reader.hpp"

namespace robochart::sleec {
namespace {

/// In a rule longer than this, each alternative and each defeater is on a separate line.
constexpr std::size_t longest_line = 120;

bool is_block_word(std::string_view word) {
    return word.ends_with("_start") || word.ends_with("_end");
}

/// True if no blank separates `left` and `right`. `before` is the token before `left`.
bool no_blank_between(const Token& before, const Token& left, const Token& right) {
    return words::is_one_of(left, {"(", "{", "[", "::"}) || words::is_one_of(right, {")", "}", "]", ",", "::"}) ||
           (left.text == "scale" && right.text == "(") ||
           (left.kind == Tok::word && right.text == "(" && !is_reserved(left.text) && left.text != "least") ||
           (left.text == "-" && words::is_one_of(before, {"(", ","}));
}

/// The layout of SLEEC files. An item is a definition, a rule, or a keyword that begins or ends a block.
class Layout final : public words::ItemLayout {
public:
    Layout(std::string_view text, const std::vector<Token>& tokens, const RuleFile& file) : ItemLayout(text, tokens) {
        for (const Rule& rule : file.rules) begins_.insert(rule.span.begin);
        for (const auto* properties : {&file.concerns, &file.purposes})
            for (const Property& property : *properties) begins_.insert(property.span.begin);
        for (const Mapping& mapping : file.mappings) mapped_.insert(mapping.name.span.begin);
    }

private:
    [[nodiscard]] bool word_begins_item(std::size_t at) const override {
        const Token& token = tokens_[at];
        if (token.kind != Tok::word) return false;
        if (is_reserved(token.text) && is_block_word(token.text)) return true;
        if (token.text == "event" || token.text == "measure" || token.text == "constant") return true;
        if (token.text == "map" && mapped_.contains(tokens_[at + 1].span.begin)) return true;
        return begins_.contains(token.span.begin);
    }

    [[nodiscard]] std::string item_text(std::size_t from, std::size_t to) override {
        const std::string_view word = tokens_[from].text;
        const bool block = tokens_[from].kind == Tok::word && is_reserved(word) && is_block_word(word);
        if (block && word.ends_with("_end")) inside_ = false;
        const std::string indent(inside_ ? 4 : 0, ' ');
        if (block && word.ends_with("_start")) inside_ = true;
        const auto is_comment = [](const Token& token) { return token.kind == Tok::comment; };
        const auto begin = tokens_.begin() + static_cast<std::ptrdiff_t>(from);
        const bool comments = std::any_of(begin, tokens_.begin() + static_cast<std::ptrdiff_t>(to) - 1, is_comment);
        std::string line = indent + join_tokens(from, to, " ");
        if (comments || line.size() > longest_line) line = indent + join_tokens(from, to, "\n" + indent + "    ");
        return line;
    }

    /// Joins tokens. `between` is written before alternatives and defeaters.
    [[nodiscard]] std::string join_tokens(std::size_t from, std::size_t to, const std::string& between) const {
        const std::string fresh = "\n" + std::string(inside_ ? 8 : 4, ' ');
        std::string result;
        int braces = 0;
        for (std::size_t i = from; i < to; ++i) {
            const Token& token = tokens_[i];
            if (token.text == "}" && token.kind == Tok::symbol) --braces;
            if (i > from) {
                const Token& before = tokens_[i - 1];
                const bool branch = token.text == "unless" || token.text == "otherwise" || token.text == "else";
                if (before.kind == Tok::comment && before.text.starts_with("//"))
                    result += fresh;
                else if (token.kind == Tok::comment)
                    result += own_line(i) ? fresh : " ";
                else if (branch && token.kind == Tok::word && braces == 0)
                    result += between;
                else if (!no_blank_between(tokens_[i - std::min<std::size_t>(i, 2)], before, token))
                    result += ' ';
            }
            result += words::shown_text(token);
            if (token.text == "{" && token.kind == Tok::symbol) ++braces;
        }
        return result;
    }

    std::set<std::uint32_t> begins_, mapped_;  ///< starts of rules and properties; names after `map`
    bool inside_ = false;                      ///< true inside a block
};

}  // namespace

std::optional<std::string> format(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                                  diagnostics::Diagnostics& diagnostics) {
    diagnostics::Diagnostics ignored;
    const std::string_view text = sources.source_text(source);
    return words::format_items(
        text, diagnostics, [&](diagnostics::Diagnostics& found) { return read(sources, source, found); },
        [&](std::string_view of) { return lex(of, source, ignored, true); },
        [&](const std::vector<Token>& tokens, const RuleFile& file) { return Layout(text, tokens, file).write(); });
}

}  // namespace robochart::sleec
