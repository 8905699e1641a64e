// SPDX-License-Identifier: Apache-2.0
// See printer.hpp. Parentheses are written if the tree needs them, and between `and` and `or`.
#include "sleec/syntax/printer.hpp"

#include <fmt/format.h>

namespace robochart::sleec {
namespace {

/// The precedence of an operator.
int precedence_of(Op op) {
    if (op == Op::disjunction || op == Op::conjunction) return 0;
    if (op == Op::negation) return 1;
    if (is_comparison(op)) return 2;
    if (op == Op::add || op == Op::subtract) return 3;
    return op == Op::multiply ? 4 : 5;
}

std::string operand_text(const ExprPtr& expr, bool bracketed) {
    return bracketed ? fmt::format("({})", print(expr)) : print(expr);
}

/// A left operand of the same level needs no parentheses. The printer adds them if one of the operators is `and` and
/// the other `or`, because people misread `c or a and b`.
bool left_bracketed(const Expr& outer, const Expr& left) {
    return precedence_of(left.op) < precedence_of(outer.op) ||
           (precedence_of(outer.op) == 0 && precedence_of(left.op) == 0 && left.op != outer.op) ||
           (is_comparison(outer.op) && is_comparison(left.op));
}

/// A number or a name; any other expression in parentheses.
std::string time_text(const ExprPtr& time) {
    return operand_text(time, !time->parts.empty() || time->braced);
}

std::string limit_text(const Limit& limit) {
    const std::string to = time_text(limit.to);
    if (limit.each_unit)
        return fmt::format("[{} {}, {} {}]", time_text(limit.from), unit_name(limit.from_unit), to,
                           unit_name(limit.unit));
    if (limit.from) return fmt::format("[{}, {}] {}", time_text(limit.from), to, unit_name(limit.unit));
    return fmt::format("{} {}", to, unit_name(limit.unit));
}

/// LEGOS requires parentheses around every operator.
std::string legos_text(const ExprPtr& expr) {
    if (expr->parts.empty()) return print(expr);
    if (expr->op == Op::negation) return fmt::format("(not {})", legos_text(expr->parts[0]));
    return fmt::format("({} {} {})", legos_text(expr->parts[0]), symbol_of(expr->op), legos_text(expr->parts[1]));
}

/// Prints in one dialect.
class Printer {
public:
    explicit Printer(Dialect dialect, std::string between = " ") : dialect_(dialect), between_(std::move(between)) {}

    [[nodiscard]] std::string condition_text(const ExprPtr& expr) const {
        return dialect_ == Dialect::legos ? legos_text(expr) : print(expr);
    }

    [[nodiscard]] std::string trigger_text(const Trigger& trigger) const {
        if (!trigger.condition) return trigger.event.text;
        return fmt::format("{} and {}", trigger.event.text, condition_text(trigger.condition));
    }

    [[nodiscard]] std::string response_text(const Response& response) const {
        std::string text = response.braced ? "{" : "";
        text += action_text(response);
        if (response.otherwise)
            text += fmt::format("{}{} {}", response.braced ? " " : between_,
                                response.written_else ? "else" : "otherwise", inner_text(*response.otherwise));
        for (const Defeater& defeater : response.defeaters) {
            text += fmt::format("{}unless {}", response.braced ? " " : between_, condition_text(defeater.condition));
            if (defeater.response) text += " then " + inner_text(*defeater.response);
        }
        return text + (response.braced ? "}" : "");
    }

    [[nodiscard]] std::string rule_text(const Rule& rule) const {
        if (rule.form == RuleForm::at_least)
            return fmt::format("{} at least {} after {}", rule.response->event.text, limit_text(*rule.response->limit),
                               trigger_text(rule.trigger));
        const bool after = rule.form == RuleForm::after;
        return fmt::format("{} {}{} {}", after ? "after" : "when", trigger_text(rule.trigger), after ? "," : " then",
                           response_text(*rule.response));
    }

    [[nodiscard]] std::string property_text(const Property& property) const {
        if (!property.exists)
            return fmt::format("when {} then {}", trigger_text(property.trigger), response_text(*property.response));
        std::string text = "exists " + trigger_text(property.trigger);
        if (property.during) text += " while " + trigger_text(*property.during);
        if (property.response) text += " while " + response_text(*property.response);
        return text;
    }

private:
    /// A response in braces is printed on one line.
    [[nodiscard]] std::string inner_text(const Response& inner) const {
        return inner.braced ? Printer(dialect_).response_text(inner) : response_text(inner);
    }

    [[nodiscard]] static std::string action_text(const Response& response) {
        std::string text = response.negated ? "not " : "";
        text += response.event.text;
        if (response.eventually) text += " eventually";
        if (response.limit) text += " within " + limit_text(*response.limit);
        return text;
    }

    Dialect dialect_;
    std::string between_;  ///< before `otherwise` and `unless`
};

std::string measure_text(const Measure& measure) {
    if (measure.type == MeasureType::boolean) return "boolean";
    if (measure.type == MeasureType::numeric) return "numeric";
    std::string literals;
    for (const Name& literal : measure.literals) literals += (literals.empty() ? "" : ", ") + literal.text;
    return fmt::format("scale({})", literals);
}

}  // namespace

std::string print(const ExprPtr& expr) {
    if (expr->op == Op::name && expr->braced) return fmt::format("{{{}}}", expr->text);
    if (expr->parts.empty()) return expr->text;
    const Expr& first = *expr->parts[0];
    if (expr->op == Op::negation)
        return "not " + operand_text(expr->parts[0], precedence_of(first.op) < precedence_of(expr->op));
    return fmt::format("{} {} {}", operand_text(expr->parts[0], left_bracketed(*expr, first)), symbol_of(expr->op),
                       operand_text(expr->parts[1], precedence_of(expr->parts[1]->op) <= precedence_of(expr->op)));
}

std::string print(const ResponsePtr& response) {
    return Printer(Dialect::sleec_tk).response_text(*response);
}

std::string print(const Rule& rule) {
    return Printer(Dialect::sleec_tk).rule_text(rule);
}

std::string print(const RuleFile& file) {
    std::string text = "def_start\n";
    for (const Event& event : file.events) text += fmt::format("    event {}\n", event.name.text);
    for (const Measure& measure : file.measures)
        text += fmt::format("    measure {} : {}\n", measure.name.text, measure_text(measure));
    for (const Constant& constant : file.constants)
        text += fmt::format("    constant {} = {}\n", constant.name.text, print(constant.value));
    for (const Mapping& mapping : file.mappings)
        text += fmt::format("    map {} to {}\n", mapping.name.text, mapping.element.text);
    text += "def_end\nrule_start\n";
    const Printer printer(file.dialect, "\n        ");
    for (const Rule& rule : file.rules)
        text += fmt::format("    {}{} {}\n", rule.assumed ? "assume " : "", rule.name.text, printer.rule_text(rule));
    text += "rule_end\n";
    const auto properties = [&](const std::vector<Property>& all, const char* word) {
        if (all.empty()) return;
        text += fmt::format("{}_start\n", word);
        for (const Property& property : all)
            text += fmt::format("    {} {}\n", property.name.text, printer.property_text(property));
        text += fmt::format("{}_end\n", word);
    };
    properties(file.concerns, "concern");
    properties(file.purposes, "purpose");
    return text;
}

}  // namespace robochart::sleec
