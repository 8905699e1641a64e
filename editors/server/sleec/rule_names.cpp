// SPDX-License-Identifier: Apache-2.0
#include "editors/server/sleec/rule_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "claims/sleec/syntax/lexer.hpp"
#include "claims/sleec/syntax/printer.hpp"

namespace robochart::lsp {

namespace {

using sleec::Expr;
using sleec::ExprPtr;
using sleec::MeasureType;
using sleec::ResponsePtr;
using sleec::RuleFile;

namespace rule_symbols {  // SymbolKind (LSP 3.17)
constexpr int function = 12;
constexpr int variable = 13;
constexpr int constant = 14;
constexpr int event = 24;
}  // namespace rule_symbols

/// A declaration of the file.
struct Declared {
    const sleec::Name* name;
    int kind;
    std::string text;  ///< the text of the declaration
    Span whole;
};

std::string measure_type(const sleec::Measure& measure) {
    if (measure.type == MeasureType::boolean) return "boolean";
    if (measure.type == MeasureType::numeric) return "numeric";
    std::string literals;
    for (const sleec::Name& literal : measure.literals) literals += (literals.empty() ? "" : ", ") + literal.text;
    return fmt::format("scale({})", literals);
}

std::vector<Declared> declared_in(const RuleFile& file) {
    std::vector<Declared> result;
    for (const sleec::Event& event : file.events)
        result.push_back({&event.name, rule_symbols::event, "event " + event.name.text, event.name.span});
    for (const sleec::Measure& measure : file.measures)
        result.push_back({&measure.name, rule_symbols::variable,
                          fmt::format("measure {} : {}", measure.name.text, measure_type(measure)), measure.name.span});
    for (const sleec::Constant& constant : file.constants)
        result.push_back({&constant.name, rule_symbols::constant,
                          fmt::format("constant {} = {}", constant.name.text, sleec::print(constant.value)),
                          constant.name.span});
    for (const sleec::Rule& rule : file.rules)
        result.push_back(
            {&rule.name, rule_symbols::function, fmt::format("{} {}", rule.name.text, sleec::print(rule)), rule.span});
    for (const auto& [properties, what] : {std::pair(&file.concerns, "concern"), std::pair(&file.purposes, "purpose")})
        for (const sleec::Property& property : *properties)
            result.push_back({&property.name, rule_symbols::function, fmt::format("{} {}", what, property.name.text),
                              property.span});
    return result;
}

/// Finds out whether a rule, a concern or a purpose mentions a name.
class Mentions {
public:
    explicit Mentions(std::string_view name) : name_(name) {}

    bool mentioned_in(const sleec::Trigger& trigger) {
        return trigger.event.text == name_ || mentioned_in(trigger.condition);
    }
    bool mentioned_in(const ExprPtr& expr) {
        if (!expr) return false;
        return (expr->op == sleec::Op::name && expr->text == name_) ||
               std::ranges::any_of(expr->parts, [&](const ExprPtr& part) { return mentioned_in(part); });
    }
    bool mentioned_in(const ResponsePtr& response) {
        if (!response) return false;
        if (response->event.text == name_ || mentioned_in(response->otherwise)) return true;
        if (response->limit && (mentioned_in(response->limit->from) || mentioned_in(response->limit->to))) return true;
        return std::ranges::any_of(response->defeaters, [&](const sleec::Defeater& defeater) {
            return (defeater.event && defeater.event->text == name_) || mentioned_in(defeater.condition) ||
                   mentioned_in(defeater.response);
        });
    }

private:
    std::string_view name_;
};

std::string rules_with(const RuleFile& file, const std::string& name) {
    std::string text;
    Mentions mentions(name);
    for (const sleec::Rule& rule : file.rules)
        if (mentions.mentioned_in(rule.trigger) || mentions.mentioned_in(rule.response))
            text += (text.empty() ? "in " : ", ") + rule.name.text;
    return text;
}

struct WordMeaning {
    std::string_view word, meaning;
};

constexpr std::array meanings = {
    WordMeaning{"when",
                "`NAME when EVENT [and condition] then response`: each occurrence of the event is a trigger; the "
                "condition is asked with the values of that moment."},
    WordMeaning{"within",
                "`E within N unit`: E comes by then at the latest, the limit included. `not E within N unit`: E "
                "does not come up to then."},
    WordMeaning{"otherwise", "`E within N unit otherwise R`: if E has not come by then, R holds from then on."},
    WordMeaning{"unless",
                "`R unless condition [then S]`: if the condition is true at the trigger, S is asked for instead "
                "of R, or nothing. Of several that are true the last decides."},
    WordMeaning{"assume",
                "A rule that the environment keeps: histories that break it are not considered. Ours; neither "
                "SLEEC-TK nor LEGOS reads it."},
    WordMeaning{"scale", "`measure m : scale(low, mid, high)`: values in order, least first."},
    WordMeaning{"numeric", "A measure that is a whole number."},
    WordMeaning{
        "in", "`in STATE`: the model is in this state when the rule begins, as in claims. An extension of this tool."},
    WordMeaning{"boolean", "A measure that is true or false."},
};

std::optional<Span> declaration_of(const RuleFile& file, const std::string& text) {
    for (const Declared& declared : declared_in(file))
        if (declared.name->text == text) return declared.name->span;
    for (const sleec::Measure& measure : file.measures)
        for (const sleec::Name& literal : measure.literals)
            if (literal.text == text) return literal.span;
    return std::nullopt;
}

}  // namespace

std::optional<RuleName> rule_name_at(const TextDocument& document, const RuleFile& file, std::uint32_t offset) {
    diagnostics::Diagnostics ignored;
    for (const sleec::Token& token :
         sleec::lex(document.sources.source_text(document.source), document.source, ignored)) {
        if (token.span.begin > offset) break;
        if (token.kind != sleec::Tok::word || token.span.end < offset) continue;
        const std::string text(token.text);
        return RuleName{text, token.span, declaration_of(file, text).value_or(Span())};
    }
    return std::nullopt;
}

std::string about_rule_name(const RuleFile& file, const RuleName& name, bool markdown) {
    for (const Declared& declared : declared_in(file)) {
        if (declared.name->text != name.text) continue;
        std::string text = markdown ? fmt::format("```sleec\n{}\n```", declared.text) : declared.text;
        const std::string where = declared.kind == rule_symbols::function ? "" : rules_with(file, name.text);
        return where.empty() ? text : text + "\n" + where;
    }
    for (const sleec::Measure& measure : file.measures)
        for (const sleec::Name& literal : measure.literals)
            if (literal.text == name.text)
                return fmt::format("a value of {} : {}", measure.name.text, measure_type(measure));
    for (const WordMeaning& entry : meanings)
        if (entry.word == name.text) return std::string(entry.meaning);
    return "";
}

Json rule_outline(const TextDocument& document, const RuleFile& file, const Client& client) {
    Json result = Json::array();
    const PositionTable positions(document.sources, document.source, client.encoding);
    for (const Declared& declared : declared_in(file)) {
        const Json whole = positions.lsp_range(declared.whole);
        Json symbol = Json::object({{"name", declared.name->text}, {"kind", declared.kind}});
        if (client.hierarchical_symbols) {
            symbol["detail"] = declared.text;
            symbol["range"] = whole;
            symbol["selectionRange"] = positions.lsp_range(declared.name->span);
        } else {
            symbol["location"] = Json::object({{"uri", document.uri}, {"range", whole}});
        }
        result.push_back(std::move(symbol));
    }
    return result;
}

}  // namespace robochart::lsp
