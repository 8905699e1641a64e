// SPDX-License-Identifier: Apache-2.0
// See printer.hpp. Parentheses are written if the tree needs them, and between `and` and `or`.
#include "claims/sleec/syntax/printer.hpp"

#include <fmt/format.h>

namespace robochart::sleec {
namespace {

/// Returns the precedence of an operator.
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

/// True if a left operand needs parentheses. An operand of the same level needs none, but the printer adds them if one
/// of the operators is `and` and the other `or`, because people misread `c or a and b`.
bool left_bracketed(const Expr& outer, const Expr& left) {
    return precedence_of(left.op) < precedence_of(outer.op) ||
           (precedence_of(outer.op) == 0 && precedence_of(left.op) == 0 && left.op != outer.op) ||
           (is_comparison(outer.op) && is_comparison(left.op));
}

/// Prints a number or a name; any other expression in parentheses.
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

std::string trigger_text(const Trigger& trigger) {
    if (!trigger.condition) return print(trigger.event);
    return fmt::format("{} and {}", print(trigger.event), print(trigger.condition));
}

std::string action_text(const Response& response) {
    std::string text = response.negated ? "not " : "";
    text += print(response.event);
    if (response.eventually) text += " eventually";
    if (response.limit) text += " within " + limit_text(*response.limit);
    return text;
}

}  // namespace

std::string print(const EventName& event) {
    if (!event.arguments) return event.text;
    std::string arguments;
    for (const ExprPtr& argument : *event.arguments) arguments += (arguments.empty() ? "" : ", ") + argument->text;
    return fmt::format("{}({})", event.text, arguments);
}

std::string print(const ExprPtr& expr) {
    if (expr->op == Op::in_state) return "in " + expr->text;
    if (expr->op == Op::name && expr->braced) return fmt::format("{{{}}}", expr->text);
    if (expr->parts.empty()) return expr->text;
    const Expr& first = *expr->parts[0];
    if (expr->op == Op::negation)
        return "not " + operand_text(expr->parts[0], precedence_of(first.op) < precedence_of(expr->op));
    return fmt::format("{} {} {}", operand_text(expr->parts[0], left_bracketed(*expr, first)), symbol_of(expr->op),
                       operand_text(expr->parts[1], precedence_of(expr->parts[1]->op) <= precedence_of(expr->op)));
}

std::string print(const ResponsePtr& response) {
    std::string text = response->braced ? "{" : "";
    text += action_text(*response);
    if (response->otherwise)
        text += fmt::format(" {} {}", response->written_else ? "else" : "otherwise", print(response->otherwise));
    for (const Defeater& defeater : response->defeaters) {
        text += " unless " + (defeater.event ? print(*defeater.event) : print(defeater.condition));
        if (defeater.response) text += " then " + print(defeater.response);
    }
    return text + (response->braced ? "}" : "");
}

std::string print(const Rule& rule) {
    if (rule.form == RuleForm::at_least)
        return fmt::format("{} at least {} after {}", print(rule.response->event), limit_text(*rule.response->limit),
                           trigger_text(rule.trigger));
    const bool after = rule.form == RuleForm::after;
    return fmt::format("{} {}{} {}", after ? "after" : "when", trigger_text(rule.trigger), after ? "," : " then",
                       print(rule.response));
}

}  // namespace robochart::sleec
