// SPDX-License-Identifier: Apache-2.0
// See format.hpp.
#include "claims/sleec/syntax/format.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "claims/sleec/syntax/lexer.hpp"
#include "claims/sleec/syntax/reader.hpp"

namespace robochart::sleec {
namespace {

/// In a longer rule, each alternative and each defeater is on a separate line.
constexpr std::size_t longest_line = 120;

bool is_block_word(std::string_view word) {
    return word.ends_with("_start") || word.ends_with("_end");
}

/// `before`: the token before `left`.
bool no_blank_between(const Token& before, const Token& left, const Token& right) {
    const auto is_any = [](const Token& token, std::initializer_list<std::string_view> texts) {
        return token.kind == Tok::symbol && std::ranges::find(texts, token.text) != texts.end();
    };
    return is_any(left, {"(", "{", "[", "::"}) || is_any(right, {")", "}", "]", ",", "::"}) ||
           (left.text == "scale" && right.text == "(") ||
           (left.kind == Tok::word && right.text == "(" && !is_reserved(left.text) && left.text != "least") ||
           (left.text == "-" && is_any(before, {"(", ","}));
}

/// A comment without trailing blanks.
std::string_view shown_text(const Token& token) {
    std::string_view text = token.text;
    if (token.kind == Tok::comment)
        while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
            text.remove_suffix(1);
    return text;
}

std::vector<std::string_view> words_of(const std::vector<Token>& tokens) {
    std::vector<std::string_view> result;
    for (const Token& token : tokens) result.push_back(shown_text(token));
    return result;
}

/// Lays out one text, item by item: a definition, a rule, or a keyword that begins or ends a block.
class Layout {
public:
    Layout(std::string_view text, const std::vector<Token>& tokens, const RuleFile& file)
        : text_(text), tokens_(tokens) {
        for (const Rule& rule : file.rules) begins_.insert(rule.span.begin);
        for (const auto* properties : {&file.concerns, &file.purposes})
            for (const Property& property : *properties) begins_.insert(property.span.begin);
        for (const Mapping& mapping : file.mappings) mapped_.insert(mapping.name.span.begin);
        // A comment on a separate line before an item, or before another such comment, is laid out as an item.
        begins_item_.assign(tokens.size(), true);
        for (std::size_t i = tokens.size() - 1; i-- > 0;)
            begins_item_[i] = tokens[i].kind == Tok::comment ? own_line(i) && begins_item_[i + 1] : word_begins_item(i);
    }

    std::string write() {
        std::size_t at = 0;
        while (tokens_[at].kind != Tok::end) {
            std::size_t end = at + 1;
            while (!begins_item_[end]) ++end;
            write_item(at, end);
            at = end;
        }
        return std::move(out_);
    }

private:
    [[nodiscard]] bool word_begins_item(std::size_t at) const {
        const Token& token = tokens_[at];
        if (token.kind != Tok::word) return false;
        if (is_reserved(token.text) && is_block_word(token.text)) return true;
        if (token.text == "event" || token.text == "measure" || token.text == "constant") return true;
        if (token.text == "map" && mapped_.contains(tokens_[at + 1].span.begin)) return true;
        return begins_.contains(token.span.begin);
    }

    [[nodiscard]] std::string_view text_before(std::size_t at) const {
        const std::size_t from = at == 0 ? 0 : tokens_[at - 1].span.end;
        return text_.substr(from, tokens_[at].span.begin - from);
    }
    [[nodiscard]] bool own_line(std::size_t at) const {
        return at == 0 || text_before(at).find('\n') != std::string_view::npos;
    }
    [[nodiscard]] bool blank_line_before(std::size_t at) const {
        const std::string_view space = text_before(at);
        return at > 0 && std::ranges::count(space, '\n') > 1;
    }

    void write_item(std::size_t from, std::size_t to) {
        if (blank_line_before(from)) out_ += '\n';
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
        out_ += line + "\n";
    }

    /// `between`: written before alternatives and defeaters.
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
            result += shown_text(token);
            if (token.text == "{" && token.kind == Tok::symbol) ++braces;
        }
        return result;
    }

    std::string_view text_;
    const std::vector<Token>& tokens_;
    std::set<std::uint32_t> begins_, mapped_;  ///< where rules and properties begin; names after `map`
    std::vector<bool> begins_item_;            ///< for each token; the end counts
    bool inside_ = false;                      ///< inside a block
    std::string out_;
};

}  // namespace

std::optional<std::string> format(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                                  diagnostics::Diagnostics& diagnostics) {
    diagnostics::Diagnostics found;
    found.set_budget(diagnostics.budget());
    const RuleFile file = read(sources, source, found);
    if (!found.ok()) {
        diagnostics.add(found);
        return std::nullopt;
    }
    const std::string_view text = sources.source_text(source);
    diagnostics::Diagnostics ignored;
    const std::vector<Token> tokens = lex(text, source, ignored, true);
    std::string result = Layout(text, tokens, file).write();
    if (words_of(lex(result, source, ignored, true)) != words_of(tokens))
        throw std::logic_error("formatting a file of rules has lost a word");
    return result;
}

}  // namespace robochart::sleec
