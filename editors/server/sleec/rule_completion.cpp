// SPDX-License-Identifier: Apache-2.0
#include "editors/server/sleec/rule_completion.hpp"

#include <algorithm>
#include <initializer_list>
#include <set>

#include "sleec/syntax/lexer.hpp"

namespace robochart::lsp {

namespace {

using sleec::MeasureType;
using sleec::RuleFile;
using sleec::Tok;
using sleec::Token;

namespace kinds {  // CompletionItemKind (LSP 3.17)
constexpr int variable = 6;
constexpr int keyword = 14;
constexpr int literal = 20;
constexpr int constant = 21;
constexpr int event = 23;
}  // namespace kinds

/// Uses the tokens before the place, because the text usually has errors while it is written.
class RuleCompleter {
public:
    RuleCompleter(const RuleText& document, const RuleFile& file, std::uint32_t offset, Encoding encoding)
        : file_(file) {
        diagnostics::Diagnostics ignored;
        Span prefix{document.source, offset, offset};
        for (const Token& token : sleec::lex(document.texts.text(document.source), document.source, ignored, true)) {
            if (token.span.begin >= offset || token.kind == Tok::end) break;
            if (token.span.end < offset || (token.span.end == offset && token.kind == Tok::symbol)) {
                if (token.kind != Tok::comment) before_.push_back(token);
                continue;
            }
            // This token ends at the place or contains it.
            inside_ = token.kind == Tok::comment || token.kind == Tok::number;
            prefix.begin = token.span.begin;
        }
        range_ = range(document.texts, prefix, encoding);
    }

    Json run() {
        if (!inside_) list();
        return Json::object({{"isIncomplete", false}, {"items", std::move(items_)}});
    }

private:
    [[nodiscard]] std::string_view word(std::size_t back) const {
        return before_.size() < back ? std::string_view() : before_[before_.size() - back].text;
    }
    [[nodiscard]] bool is(std::size_t back, std::initializer_list<std::string_view> words) const {
        return std::ranges::find(words, word(back)) != words.end();
    }

    void add(std::string_view label, int kind) {
        if (!seen_.insert(std::string(label)).second) return;
        const std::string text(label);
        items_.push_back(Json::object(
            {{"label", text}, {"kind", kind}, {"textEdit", Json::object({{"range", range_}, {"newText", text}})}}));
    }
    void words(std::initializer_list<std::string_view> list) {
        for (const std::string_view each : list) add(each, kinds::keyword);
    }
    void events() {
        for (const sleec::Event& each : file_.events) add(each.name.text, kinds::event);
    }
    void measures() {
        for (const sleec::Measure& each : file_.measures) add(each.name.text, kinds::variable);
    }
    void constants() {
        for (const sleec::Constant& each : file_.constants) add(each.name.text, kinds::constant);
    }
    void condition() {
        measures();
        constants();
        words({"not", "true", "false"});
    }
    void units() { words({"seconds", "minutes", "hours", "days"}); }

    [[nodiscard]] const sleec::Measure* measure(std::string_view name) const {
        for (const sleec::Measure& each : file_.measures)
            if (each.name.text == name) return &each;
        return nullptr;
    }

    /// Adds what can be compared with a measure: the values of its scale, or numbers.
    void compared() {
        const sleec::Measure* left = measure(word(word(2) == "}" ? 3 : 2));
        if (left != nullptr && left->type == MeasureType::scale) {
            for (const sleec::Name& each : left->literals) add(each.text, kinds::literal);
            return;
        }
        measures();
        constants();
    }

    void list() {
        if (before_.empty()) return words({"def_start"});
        if (is(1, {"def_start", "rule_start", "concern_start", "purpose_start"})) return beginning();
        if (is(1, {"event", "measure", "constant"})) return;
        if (is(1, {":"})) return words({"boolean", "numeric", "scale"});
        if (is(1, {"when", "exists", "while", "after", "map"})) {
            events();
            if (is(1, {"map"})) measures();
            return;
        }
        if (is(1, {"then", "otherwise", "else"}) || (is(1, {"not"}) && is(2, {"then", "otherwise", "else", "{"}))) {
            events();
            return is(1, {"not"}) ? void() : words({"not"});
        }
        if (is(1, {"unless"})) events();
        if (is(1, {"and", "or", "unless", "not", "(", "+", "-", "*"})) return condition();
        if (is(1, {"{"})) return measures(), events();
        if (is(1, {"<", ">", "<=", ">=", "=", "<>"})) return compared();
        if (is(1, {"within", "least", "["})) return constants();
        if (is(1, {"]"}) || is(2, {"within", "least"})) return units();
        words({"and", "or", "then", "when", "within", "otherwise", "unless", "while"});
        beginning();
    }

    /// Adds the words that begin a definition or a block.
    void beginning() {
        const auto last = std::find_if(before_.rbegin(), before_.rend(), [](const Token& token) {
            return token.text.ends_with("_start") || token.text.ends_with("_end");
        });
        if (last == before_.rend()) return words({"def_start"});
        if (last->text == "def_start") return words({"event", "measure", "constant", "map", "def_end"});
        if (last->text == "def_end") return words({"rule_start"});
        if (last->text == "rule_start") return words({"assume", "rule_end"});
        if (last->text == "concern_start") return words({"concern_end"});
        if (last->text == "purpose_start") return words({"purpose_end"});
        words({"concern_start", "purpose_start"});
    }

    const RuleFile& file_;
    std::vector<Token> before_;  ///< the tokens before the place
    bool inside_ = false;        ///< inside a comment or a number
    Json range_;
    Json items_ = Json::array();
    std::set<std::string> seen_;
};

}  // namespace

Json rule_completion(const RuleText& document, const RuleFile& file, std::uint32_t offset, Encoding encoding) {
    return RuleCompleter(document, file, offset, encoding).run();
}

}  // namespace robochart::lsp
