// SPDX-License-Identifier: Apache-2.0
#include "editors/server/sleec/rule_completion.hpp"

#include <algorithm>
#include <initializer_list>
#include <set>

#include "claims/sleec/syntax/lexer.hpp"

namespace robochart::lsp {

namespace {

using sleec::MeasureType;
using sleec::RuleFile;
using sleec::Tok;
using sleec::Token;

namespace completion_kinds {  // CompletionItemKind (LSP 3.17)
constexpr int variable = 6;
constexpr int keyword = 14;
constexpr int literal = 20;
constexpr int constant = 21;
constexpr int event = 23;
}  // namespace completion_kinds

/// Completes a text from the tokens before the place, because a text that is being written usually has errors.
class RuleCompleter {
public:
    RuleCompleter(const TextDocument& document, const RuleFile& file, const ClaimedModels* models, std::uint32_t offset,
                  Encoding encoding)
        : file_(file), models_(models) {
        diagnostics::Diagnostics ignored;
        Span prefix{document.source, offset, offset};
        for (const Token& token :
             sleec::lex(document.sources.source_text(document.source), document.source, ignored, true)) {
            if (token.span.begin >= offset || token.kind == Tok::end) break;
            if (token.span.end < offset || (token.span.end == offset && token.kind == Tok::symbol)) {
                if (token.kind != Tok::comment) before_.push_back(token);
                continue;
            }
            // This token ends at the place or contains it.
            inside_ = token.kind == Tok::comment || token.kind == Tok::number;
            prefix.begin = token.span.begin;
        }
        place_ = name_place(document.sources.source_text(document.source).substr(0, prefix.begin));
        range_ = lsp_range(document.sources, prefix, encoding);
    }

    Json run() {
        if (!inside_) add_candidates();
        return Json::object({{"isIncomplete", false}, {"items", std::move(items_)}});
    }

private:
    [[nodiscard]] std::string_view word_before(std::size_t back) const {
        return before_.size() < back ? std::string_view() : before_[before_.size() - back].text;
    }
    [[nodiscard]] bool is_one_of(std::size_t back, std::initializer_list<std::string_view> words) const {
        return std::ranges::find(words, word_before(back)) != words.end();
    }

    void add(std::string_view label, int kind) {
        if (!seen_.insert(std::string(label)).second) return;
        const std::string text(label);
        items_.push_back(Json::object(
            {{"label", text}, {"kind", kind}, {"textEdit", Json::object({{"range", range_}, {"newText", text}})}}));
    }
    void add_words(std::initializer_list<std::string_view> list) {
        for (const std::string_view word : list) add(word, completion_kinds::keyword);
    }
    void add_events() {
        for (const sleec::Event& event : file_.events) add(event.name.text, completion_kinds::event);
    }
    void add_measures() {
        for (const sleec::Measure& measure : file_.measures) add(measure.name.text, completion_kinds::variable);
    }
    void add_constants() {
        for (const sleec::Constant& constant : file_.constants) add(constant.name.text, completion_kinds::constant);
    }
    void add_condition_words() {
        add_measures();
        add_constants();
        add_words({"not", "true", "false", "in"});
    }
    void add_units() { add_words({"seconds", "minutes", "hours", "days"}); }

    [[nodiscard]] const sleec::Measure* find_measure(std::string_view name) const {
        for (const sleec::Measure& measure : file_.measures)
            if (measure.name.text == name) return &measure;
        return nullptr;
    }

    /// Adds the values that can be compared with a measure: the values of its scale, or numbers.
    void add_compared_values() {
        const sleec::Measure* left = find_measure(word_before(word_before(2) == "}" ? 3 : 2));
        if (left != nullptr && left->type == MeasureType::scale) {
            for (const sleec::Name& literal : left->literals) add(literal.text, completion_kinds::literal);
            return;
        }
        add_measures();
        add_constants();
    }

    void add_states() {
        if (models_ == nullptr) return;
        for (const std::string& path : states_after(place_.qualifier, *models_)) add(path, completion_kinds::literal);
    }

    void add_candidates() {
        if (place_.word == "in") return add_states();
        if (before_.empty()) return add_words({"def_start"});
        if (is_one_of(1, {"def_start", "rule_start", "concern_start", "purpose_start"})) return add_block_words();
        if (is_one_of(1, {"event", "measure", "constant"})) return;
        if (is_one_of(1, {":"})) return add_words({"boolean", "numeric", "scale"});
        if (is_one_of(1, {"when", "exists", "while", "after", "map"})) {
            add_events();
            if (is_one_of(1, {"map"})) add_measures();
            return;
        }
        if (is_one_of(1, {"then", "otherwise", "else"}) ||
            (is_one_of(1, {"not"}) && is_one_of(2, {"then", "otherwise", "else", "{"}))) {
            add_events();
            return is_one_of(1, {"not"}) ? void() : add_words({"not"});
        }
        if (is_one_of(1, {"unless"})) add_events();
        if (is_one_of(1, {"and", "or", "unless", "not", "(", "+", "-", "*"})) return add_condition_words();
        if (is_one_of(1, {"{"})) {
            add_measures();
            return add_events();
        }
        if (is_one_of(1, {"<", ">", "<=", ">=", "=", "<>"})) return add_compared_values();
        if (is_one_of(1, {"within", "least", "["})) return add_constants();
        if (is_one_of(1, {"]"}) || is_one_of(2, {"within", "least"})) return add_units();
        add_words({"and", "or", "then", "when", "within", "otherwise", "unless", "while"});
        add_block_words();
    }

    /// Adds the words that begin a definition or a block.
    void add_block_words() {
        const auto last = std::find_if(before_.rbegin(), before_.rend(), [](const Token& token) {
            return token.text.ends_with("_start") || token.text.ends_with("_end");
        });
        if (last == before_.rend()) return add_words({"def_start"});
        if (last->text == "def_start") return add_words({"event", "measure", "constant", "map", "def_end"});
        if (last->text == "def_end") return add_words({"rule_start"});
        if (last->text == "rule_start") return add_words({"assume", "rule_end"});
        if (last->text == "concern_start") return add_words({"concern_end"});
        if (last->text == "purpose_start") return add_words({"purpose_end"});
        add_words({"concern_start", "purpose_start"});
    }

    const RuleFile& file_;
    const ClaimedModels* models_;
    NamePlace place_;
    std::vector<Token> before_;  ///< the tokens before the place
    bool inside_ = false;        ///< true inside a comment or a number
    Json range_;
    Json items_ = Json::array();
    std::set<std::string> seen_;
};

}  // namespace

Json rule_completion(const TextDocument& document, const RuleFile& file, const ClaimedModels* models,
                     std::uint32_t offset, Encoding encoding) {
    return RuleCompleter(document, file, models, offset, encoding).run();
}

}  // namespace robochart::lsp
