// SPDX-License-Identifier: Apache-2.0
// See layout.hpp.
#include "claims/syntax/layout.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "claims/syntax/reader.hpp"

namespace robochart::claims {
namespace {

bool is_one_of(const Token& token, std::initializer_list<std::string_view> texts) {
    return token.kind != Tok::comment && std::ranges::find(texts, token.text) != texts.end();
}

/// True if a `-` after this token is a sign.
bool comes_before_sign(const Token& token) {
    if (token.kind == Tok::number || is_one_of(token, {")"})) return false;
    return token.kind == Tok::symbol ||
           is_one_of(token, {"and", "or", "not", "with", "within", "least", "every", "any"});
}

bool no_blank_between(const Token* before, const Token& left, const Token& right) {
    if (is_one_of(left, {"(", "[", "::", "^"}) || is_one_of(right, {")", "]", ",", "::"})) return true;
    if (right.text == "(" && left.kind == Tok::word) return !is_one_of(left, {"and", "or", "not", "with", "but"});
    return left.text == "-" && left.kind == Tok::symbol && (before == nullptr || comes_before_sign(*before));
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

/// Lays out one text, item by item: an import, the unit, a claim, or a comment on a separate line.
class Layout {
public:
    Layout(std::string_view text, const std::vector<Token>& tokens, const ClaimFile& file)
        : text_(text), tokens_(tokens) {
        for (const Claim& claim : file.claims) begins_.insert(claim.span.begin);
        for (const Order& order : file.orders) begins_.insert(order.span.begin);
        for (const Duration& unit : file.units) begins_.insert(unit.span.begin);
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
        if (begins_.contains(token.span.begin)) return true;
        const bool in_head = begins_.empty() || token.span.begin < *begins_.begin();
        return in_head && (token.text == "import" || (token.text == "package" && at == 0));
    }
    [[nodiscard]] std::string_view text_before(std::size_t at) const {
        const std::size_t from = at == 0 ? 0 : tokens_[at - 1].span.end;
        return text_.substr(from, tokens_[at].span.begin - from);
    }
    [[nodiscard]] bool own_line(std::size_t at) const {
        return at == 0 || text_before(at).find('\n') != std::string_view::npos;
    }
    void write_item(std::size_t from, std::size_t to) {
        if (from > 0 && std::ranges::count(text_before(from), '\n') > 1) out_ += '\n';
        for (std::size_t i = from; i < to; ++i) {
            const Token& token = tokens_[i];
            if (i > from) out_ += between(i);
            out_ += shown_text(token);
        }
        out_ += '\n';
    }
    /// After a comment to the end of a line, the item continues on the next line.
    [[nodiscard]] std::string_view between(std::size_t at) const {
        const Token& left = tokens_[at - 1];
        if (left.kind == Tok::comment && left.text.starts_with("//")) return "\n    ";
        const Token* const before = at >= 2 ? &tokens_[at - 2] : nullptr;
        return no_blank_between(before, left, tokens_[at]) ? "" : " ";
    }

    std::string_view text_;
    const std::vector<Token>& tokens_;
    std::set<std::uint32_t> begins_;  ///< where claims and the unit begin
    std::vector<bool> begins_item_;   ///< for each token; the end counts
    std::string out_;
};

}  // namespace

std::string one_line(std::span<const Token> tokens) {
    std::string result;
    const Token* before = nullptr;
    const Token* left = nullptr;
    for (const Token& token : tokens) {
        if (token.kind == Tok::comment || token.kind == Tok::end) continue;
        if (left != nullptr && !no_blank_between(before, *left, token)) result += ' ';
        result += token.text;
        before = left;
        left = &token;
    }
    return result;
}

std::optional<std::string> format(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                                  diagnostics::Diagnostics& diagnostics) {
    diagnostics::Diagnostics found;
    found.set_budget(diagnostics.budget());
    const ClaimFile file = read(sources, source, found);
    if (!found.ok()) {
        diagnostics.add(found);
        return std::nullopt;
    }
    const std::string_view text = sources.source_text(source);
    diagnostics::Diagnostics ignored;
    const std::vector<Token> tokens = lex(text, source, ignored, true);
    std::string result = Layout(text, tokens, file).write();
    if (words_of(lex(result, source, ignored, true)) != words_of(tokens))
        throw std::logic_error("formatting a file of claims has lost a word");
    return result;
}

}  // namespace robochart::claims
