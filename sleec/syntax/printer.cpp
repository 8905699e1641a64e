// SPDX-License-Identifier: Apache-2.0
// See printer.hpp. Parentheses are written if the tree needs them, and between `and` and `or`.
#include "sleec/syntax/printer.hpp"

#include <fmt/format.h>

namespace robochart::sleec {
namespace {

/// The precedence of an operator.
int level(Op op) {
    if (op == Op::disjunction || op == Op::conjunction) return 0;
    if (op == Op::negation) return 1;
    if (is_comparison(op)) return 2;
    if (op == Op::add || op == Op::subtract) return 3;
    return op == Op::multiply ? 4 : 5;
}

std::string operand(const ExprPtr& expr, bool bracketed) {
    return bracketed ? fmt::format("({})", print(expr)) : print(expr);
}

/// A left operand of the same level needs no parentheses. The printer adds them if one of the operators is `and` and
/// the other `or`, because people misread `c or a and b`.
bool left_bracketed(const Expr& outer, const Expr& left) {
    return level(left.op) < level(outer.op) || (level(outer.op) == 0 && level(left.op) == 0 && left.op != outer.op) ||
           (is_comparison(outer.op) && is_comparison(left.op));
}

/// A number or a name; any other expression in parentheses.
std::string time_text(const ExprPtr& time) {
    return operand(time, !time->parts.empty() || time->braced);
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
std::string legos(const ExprPtr& expr) {
    if (expr->parts.empty()) return print(expr);
    if (expr->op == Op::negation) return fmt::format("(not {})", legos(expr->parts[0]));
    return fmt::format("({} {} {})", legos(expr->parts[0]), symbol_of(expr->op), legos(expr->parts[1]));
}

/// Prints in one dialect.
class Printer {
public:
    explicit Printer(Dialect dialect, std::string between = " ") : dialect_(dialect), between_(std::move(between)) {}

    [[nodiscard]] std::string condition(const ExprPtr& expr) const {
        return dialect_ == Dialect::legos ? legos(expr) : print(expr);
    }

    [[nodiscard]] std::string trigger(const Trigger& trigger) const {
        if (!trigger.condition) return trigger.event.text;
        return fmt::format("{} and {}", trigger.event.text, condition(trigger.condition));
    }

    [[nodiscard]] std::string response(const Response& response) const {
        std::string text = response.braced ? "{" : "";
        text += action(response);
        if (response.otherwise)
            text += fmt::format("{}{} {}", response.braced ? " " : between_,
                                response.written_else ? "else" : "otherwise", inner(*response.otherwise));
        for (const Defeater& defeater : response.defeaters) {
            text += fmt::format("{}unless {}", response.braced ? " " : between_, condition(defeater.condition));
            if (defeater.response) text += " then " + inner(*defeater.response);
        }
        return text + (response.braced ? "}" : "");
    }

    [[nodiscard]] std::string rule(const Rule& rule) const {
        if (rule.form == RuleForm::at_least)
            return fmt::format("{} at least {} after {}", rule.response->event.text, limit_text(*rule.response->limit),
                               trigger(rule.trigger));
        const bool after = rule.form == RuleForm::after;
        return fmt::format("{} {}{} {}", after ? "after" : "when", trigger(rule.trigger), after ? "," : " then",
                           response(*rule.response));
    }

    [[nodiscard]] std::string property(const Property& property) const {
        if (!property.exists)
            return fmt::format("when {} then {}", trigger(property.trigger), response(*property.response));
        std::string text = "exists " + trigger(property.trigger);
        if (property.during) text += " while " + trigger(*property.during);
        if (property.response) text += " while " + response(*property.response);
        return text;
    }

private:
    /// A response in braces is printed on one line.
    [[nodiscard]] std::string inner(const Response& inner) const {
        return inner.braced ? Printer(dialect_).response(inner) : response(inner);
    }

    [[nodiscard]] static std::string action(const Response& response) {
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
    if (expr->op == Op::negation) return "not " + operand(expr->parts[0], level(first.op) < level(expr->op));
    return fmt::format("{} {} {}", operand(expr->parts[0], left_bracketed(*expr, first)), symbol_of(expr->op),
                       operand(expr->parts[1], level(expr->parts[1]->op) <= level(expr->op)));
}

std::string print(const ResponsePtr& response) {
    return Printer(Dialect::sleec_tk).response(*response);
}

std::string print(const Rule& rule) {
    return Printer(Dialect::sleec_tk).rule(rule);
}

std::string print(const RuleFile& file) {
    std::string text = "def_start\n";
    for (const Event& each : file.events) text += fmt::format("    event {}\n", each.name.text);
    for (const Measure& each : file.measures)
        text += fmt::format("    measure {} : {}\n", each.name.text, measure_text(each));
    for (const Constant& each : file.constants)
        text += fmt::format("    constant {} = {}\n", each.name.text, print(each.value));
    for (const Mapping& each : file.mappings)
        text += fmt::format("    map {} to {}\n", each.name.text, each.element.text);
    text += "def_end\nrule_start\n";
    const Printer printer(file.dialect, "\n        ");
    for (const Rule& each : file.rules)
        text += fmt::format("    {}{} {}\n", each.assumed ? "assume " : "", each.name.text, printer.rule(each));
    text += "rule_end\n";
    const auto properties = [&](const std::vector<Property>& all, const char* word) {
        if (all.empty()) return;
        text += fmt::format("{}_start\n", word);
        for (const Property& each : all) text += fmt::format("    {} {}\n", each.name.text, printer.property(each));
        text += fmt::format("{}_end\n", word);
    };
    properties(file.concerns, "concern");
    properties(file.purposes, "purpose");
    return text;
}

}  // namespace robochart::sleec
