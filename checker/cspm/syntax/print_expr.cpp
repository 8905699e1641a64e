// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "checker/cspm/syntax/levels.hpp"
#include "checker/cspm/syntax/printer.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "base/diagnostics/escape.hpp"

namespace robochart::cspm {

namespace {

struct Writing {
    int level;
    std::string_view op;
};

// Precedence and spelling of the operators; atoms and bracketed forms have the highest precedence.
Writing writing(ExprKind kind) {
    switch (kind) {
        case ExprKind::lambda:
        case ExprKind::let:
        case ExprKind::if_then_else:
        case ExprKind::replicated_external:
        case ExprKind::replicated_internal:
        case ExprKind::replicated_sequential:
        case ExprKind::replicated_interleave:
        case ExprKind::replicated_parallel:
        case ExprKind::replicated_alphabetised:
        case ExprKind::replicated_linked:
        case ExprKind::replicated_synchronising:
            return {lowest_level, ""};
        case ExprKind::hide:
            return {hiding_level, "\\"};
        case ExprKind::project:
            return {hiding_level, "|\\"};
        case ExprKind::interleave:
            return {interleave_level, "|||"};
        case ExprKind::parallel:
        case ExprKind::alphabetised:
        case ExprKind::linked:
        case ExprKind::exception:
            return {parallel_level, ""};
        case ExprKind::internal_choice:
            return {internal_level, "|~|"};
        case ExprKind::external_choice:
            return {external_level, "[]"};
        case ExprKind::synchronising_choice:
            return {external_level, ""};
        case ExprKind::interrupt:
            return {interrupt_level, "/\\"};
        case ExprKind::synchronising_interrupt:
            return {interrupt_level, ""};
        case ExprKind::sliding_choice:
            return {sliding_level, "[>"};
        case ExprKind::sequential:
            return {sequential_level, ";"};
        case ExprKind::guard:
            return {prefix_level, "&"};
        case ExprKind::prefix:
            return {prefix_level, "->"};
        case ExprKind::dot:
            return {dot_level_expr, "."};
        case ExprKind::logical_or:
            return {or_level, "or"};
        case ExprKind::logical_and:
            return {and_level, "and"};
        case ExprKind::logical_not:
            return {not_level, "not"};
        case ExprKind::equal:
            return {compare_level, "=="};
        case ExprKind::not_equal:
            return {compare_level, "!="};
        case ExprKind::less:
            return {compare_level, "<"};
        case ExprKind::less_equal:
            return {compare_level, "<="};
        case ExprKind::greater:
            return {compare_level, ">"};
        case ExprKind::greater_equal:
            return {compare_level, ">="};
        case ExprKind::plus:
            return {sum_level, "+"};
        case ExprKind::minus:
            return {sum_level, "-"};
        case ExprKind::negate:
            return {sum_level, "-"};
        case ExprKind::times:
            return {product_level, "*"};
        case ExprKind::divide:
            return {product_level, "/"};
        case ExprKind::modulus:
            return {product_level, "%"};
        case ExprKind::length:
            return {length_level, "#"};
        case ExprKind::concat:
            return {concat_level_expr, "^"};
        case ExprKind::apply:
        case ExprKind::rename:
            return {postfix_level, ""};
        default:
            return {atom_level, ""};
    }
}

}  // namespace

bool Printer::needs_parentheses(const Expr& expr, int minimum) const {
    if (expr.kind == ExprKind::integer && expr.number < 0) return true;
    if (inside_sequence_ && expr.kind == ExprKind::greater) return true;
    return writing(expr.kind).level < minimum;
}

const Expr& Printer::bare(const ExprPtr& given) {
    const Expr* expr = given.get();
    while (expr->kind == ExprKind::parenthesised) expr = expr->args[0].get();
    return *expr;
}

void Printer::expression(const ExprPtr& given, int minimum) {
    const Expr* expr = &bare(given);
    if (!needs_parentheses(*expr, minimum)) return body(*expr);
    const bool outside = std::exchange(inside_sequence_, false);
    out_.open();
    out_.text("(");
    body(*expr);
    out_.text(")");
    out_.close();
    inside_sequence_ = outside;
}

void Printer::body(const Expr& expr) {
    const auto [level, op] = writing(expr.kind);
    switch (expr.kind) {
        case ExprKind::integer:
        case ExprKind::character:
        case ExprKind::string:
        case ExprKind::boolean:
        case ExprKind::name:
            return literal(expr);
        case ExprKind::tuple:
            return list("(", expr.args, ")");
        case ExprKind::set:
        case ExprKind::set_comprehension:
            return list("{", expr.args, "}", &expr.clauses);
        case ExprKind::productions:
        case ExprKind::productions_comprehension:
            return list("{| ", expr.args, " |}", &expr.clauses);
        case ExprKind::set_range:
        case ExprKind::set_range_comprehension:
            return range("{", expr, "}");
        case ExprKind::sequence:
        case ExprKind::sequence_comprehension:
        case ExprKind::sequence_range:
        case ExprKind::sequence_range_comprehension:
            return in_sequence(expr);
        case ExprKind::map:
            return map(expr);
        case ExprKind::dot:
            return dot(expr);
        case ExprKind::apply:
            return apply(expr);
        case ExprKind::lambda:
            return lambda(expr);
        case ExprKind::let:
            return let(expr);
        case ExprKind::if_then_else:
            return conditional(expr);
        case ExprKind::negate:
        case ExprKind::length:
            out_.text(op);
            return expression(expr.args[0], postfix_level);
        case ExprKind::logical_not:
            out_.text("not ");
            return expression(expr.args[0], compare_level);
        case ExprKind::prefix:
            return prefix(expr);
        case ExprKind::guard:
            out_.open();
            expression(expr.args[0], or_level);
            out_.text(" &");
            out_.space_or_line();
            process_operand(expr.args[1]);
            return out_.close();
        case ExprKind::rename:
            return rename(expr);
        case ExprKind::linked:
            return linked(expr);
        default:
            break;
    }
    if (level == lowest_level) return replicated(expr);
    if (level >= or_level) return binary_value(expr, level, op);
    if (op.empty()) return process_infix(expr);
    process_chain(expr, op);
}

void Printer::literal(const Expr& expr) {
    switch (expr.kind) {
        case ExprKind::integer:
            return out_.text(std::to_string(expr.number));
        case ExprKind::character:
            return out_.text(diagnostics::cspm_character(static_cast<char>(expr.number)));
        case ExprKind::string:
            return out_.text(diagnostics::cspm_string(expr.text));
        case ExprKind::boolean:
            return out_.text(expr.number != 0 ? "true" : "false");
        default:
            return out_.text(expr.text);
    }
}

void Printer::binary_value(const Expr& expr, int level, std::string_view op) {
    const bool chains = level != compare_level;
    out_.open();
    expression(expr.args[0], chains ? level : level + 1);
    // A line may end after every operator except `>`, and before every one except `-` and `<`.
    const bool before = expr.kind == ExprKind::greater;
    if (before)
        out_.space_or_line();
    else
        out_.text(" ");
    out_.text(op);
    if (before)
        out_.text(" ");
    else
        out_.space_or_line();
    expression(expr.args[1], level + 1);
    out_.close();
}

// Names, calls, bracketed forms, prefixes and guards need no parentheses as operands of a process operator.
void Printer::process_operand(const ExprPtr& given) {
    const Expr* expr = &bare(given);
    const bool alone = expr->kind == ExprKind::prefix || expr->kind == ExprKind::guard;
    expression(given, alone ? prefix_level : postfix_level);
}

// P [] Q [] R: a chain of one left-associative operator in one group.
void Printer::process_chain(const Expr& expr, std::string_view op) {
    std::vector<const Expr*> links{&expr};
    for (;;) {
        const Expr* left = &bare(links.back()->args[0]);
        if (left->kind != expr.kind) break;
        links.push_back(left);
    }
    out_.open();
    process_operand(links.back()->args[0]);
    for (auto link = links.rbegin(); link != links.rend(); ++link) {
        out_.space_or_line();
        out_.text(op);
        out_.text(" ");
        const bool set = expr.kind == ExprKind::hide || expr.kind == ExprKind::project;
        if (set)
            expression((*link)->args[1], postfix_level);
        else
            process_operand((*link)->args[1]);
    }
    out_.close();
}

void Printer::enclosed(const ExprPtr& set) {
    expression(set, dot_level_expr);
}

void Printer::process_infix(const Expr& expr) {
    struct Brackets {
        std::string_view open, close;
    };
    Brackets brackets{"[| ", " |] "};
    if (expr.kind == ExprKind::exception) brackets = {"[| ", " |> "};
    if (expr.kind == ExprKind::synchronising_choice) brackets = {"[+ ", " +] "};
    if (expr.kind == ExprKind::synchronising_interrupt) brackets = {"/+ ", " +\\ "};
    if (expr.kind == ExprKind::alphabetised) brackets = {"[ ", " ] "};
    out_.open();
    process_operand(expr.args[0]);
    out_.space_or_line();
    out_.text(brackets.open);
    enclosed(expr.args[2]);
    if (expr.kind == ExprKind::alphabetised) {
        out_.text(" || ");
        enclosed(expr.args[3]);
    }
    out_.text(brackets.close);
    process_operand(expr.args[1]);
    out_.close();
}

void Printer::list(std::string_view open, const std::vector<ExprPtr>& items, std::string_view close,
                   const std::vector<Clause>* given_clauses, std::size_t from) {
    const bool outside = std::exchange(inside_sequence_, open == "<");
    out_.open();
    out_.indent();
    out_.text(open);
    for (std::size_t i = from; i < items.size(); ++i) {
        if (i > from) {
            out_.text(",");
            out_.space_or_line();
        }
        expression(items[i]);
    }
    if (given_clauses != nullptr && !given_clauses->empty()) {
        out_.text(" |");
        out_.space_or_line();
        clauses(*given_clauses, " <- ");
    }
    out_.text(close);
    out_.outdent();
    out_.close();
    inside_sequence_ = outside;
}

void Printer::range(std::string_view open, const Expr& expr, std::string_view close) {
    const bool outside = std::exchange(inside_sequence_, open == "<");
    out_.text(open);
    expression(expr.args[0], dot_level_expr);
    out_.text("..");
    if (expr.args[1]) expression(expr.args[1], dot_level_expr);
    if (!expr.clauses.empty()) {
        out_.text(" | ");
        clauses(expr.clauses, " <- ");
    }
    out_.text(close);
    inside_sequence_ = outside;
}

void Printer::in_sequence(const Expr& expr) {
    if (expr.kind == ExprKind::sequence && expr.args.empty()) return out_.text("<>");
    const bool ranged = expr.kind == ExprKind::sequence_range || expr.kind == ExprKind::sequence_range_comprehension;
    if (ranged) return range("<", expr, ">");
    list("<", expr.args, ">", &expr.clauses);
}

void Printer::apply(const Expr& expr) {
    expression(expr.args[0], postfix_level);
    list("(", expr.args, ")", nullptr, 1);
}

void Printer::dot(const Expr& expr) {
    for (std::size_t i = 0; i < expr.args.size(); ++i) {
        if (i > 0) out_.text(".");
        expression(expr.args[i], postfix_level);
    }
}

void Printer::map(const Expr& expr) {
    const bool outside = std::exchange(inside_sequence_, false);
    out_.open();
    out_.text("(| ");
    for (std::size_t i = 0; i + 1 < expr.args.size(); i += 2) {
        if (i > 0) {
            out_.text(",");
            out_.space_or_line();
        }
        expression(expr.args[i], dot_level_expr);
        out_.text(" => ");
        expression(expr.args[i + 1], dot_level_expr);
    }
    out_.text(" |)");
    out_.close();
    inside_sequence_ = outside;
}

void Printer::lambda(const Expr& expr) {
    out_.open();
    patterns("\\ ", expr.patterns, " @");
    out_.space_or_line();
    expression(expr.args[0]);
    out_.close();
}

void Printer::let(const Expr& expr) {
    out_.text("let");
    out_.indent();
    out_.line();
    declarations(expr.decls);
    out_.outdent();
    out_.line();
    out_.text("within");
    out_.indent();
    out_.line();
    expression(expr.args[0]);
    out_.outdent();
}

// if a then P else if b then Q else R: the chain in one group, without growing indentation.
void Printer::conditional(const Expr& given) {
    const Expr* expr = &given;
    out_.open();
    for (;;) {
        out_.text("if ");
        expression(expr->args[0]);
        out_.text(" then");
        out_.indent();
        out_.space_or_line();
        expression(expr->args[1]);
        out_.outdent();
        out_.space_or_line();
        out_.text("else ");
        const Expr* next = &bare(expr->args[2]);
        if (next->kind != ExprKind::if_then_else) break;
        expr = next;
    }
    expression(expr->args[2]);
    out_.close();
}

void Printer::prefix(const Expr& expr) {
    out_.open();
    expression(expr.args[0], dot_level_expr);
    for (const Field& each : expr.fields) field(each);
    out_.text(" ->");
    out_.space_or_line();
    process_operand(expr.args[1]);
    out_.close();
}

void Printer::field(const Field& field) {
    if (field.kind == FieldKind::dot || field.kind == FieldKind::output) {
        out_.text("!");
        const bool dotted = bare(field.value).kind == ExprKind::dot;
        return expression(field.value, dotted ? dot_level_expr : postfix_level);
    }
    out_.text(field.kind == FieldKind::input ? "?" : "$");
    pattern(*field.pattern, 1);
    if (!field.value) return;
    out_.text(":");
    expression(field.value, postfix_level);
}

void Printer::links(const std::vector<Link>& links, std::string_view arrow, const std::vector<Clause>& given_clauses) {
    for (std::size_t i = 0; i < links.size(); ++i) {
        if (i > 0) {
            out_.text(",");
            out_.space_or_line();
        }
        expression(links[i].from, dot_level_expr);
        out_.text(arrow);
        expression(links[i].to, dot_level_expr);
    }
    if (!given_clauses.empty()) {
        out_.text(" |");
        out_.space_or_line();
        clauses(given_clauses, " <- ");
    }
}

void Printer::rename(const Expr& expr) {
    out_.open();
    expression(expr.args[0], postfix_level);
    out_.text("[[ ");
    out_.indent();
    links(expr.links, " <- ", expr.clauses);
    out_.outdent();
    out_.text(" ]]");
    out_.close();
}

void Printer::linked(const Expr& expr) {
    out_.open();
    process_operand(expr.args[0]);
    out_.space_or_line();
    out_.text("[ ");
    links(expr.links, " <-> ", expr.clauses);
    out_.text(" ] ");
    process_operand(expr.args[1]);
    out_.close();
}

void Printer::replicated(const Expr& expr) {
    const bool alphabetised = expr.kind == ExprKind::replicated_alphabetised;
    out_.open();
    switch (expr.kind) {
        case ExprKind::replicated_external:
            out_.text("[] ");
            break;
        case ExprKind::replicated_internal:
            out_.text("|~| ");
            break;
        case ExprKind::replicated_sequential:
            out_.text("; ");
            break;
        case ExprKind::replicated_interleave:
            out_.text("||| ");
            break;
        case ExprKind::replicated_alphabetised:
            out_.text("|| ");
            break;
        case ExprKind::replicated_linked:
            out_.text("[ ");
            links(expr.links, " <-> ", expr.args.size() > 1 ? expr.args[1]->clauses : std::vector<Clause>{});
            out_.text(" ] ");
            break;
        default:
            out_.text(expr.kind == ExprKind::replicated_parallel ? "[| " : "[+ ");
            enclosed(expr.args[1]);
            out_.text(expr.kind == ExprKind::replicated_parallel ? " |] " : " +] ");
            break;
    }
    clauses(expr.clauses, ":");
    out_.text(" @");
    out_.space_or_line();
    if (alphabetised) {
        out_.text("[ ");
        enclosed(expr.args[1]);
        out_.text(" ] ");
        process_operand(expr.args[0]);
    } else {
        expression(expr.args[0]);
    }
    out_.close();
}

void Printer::clauses(const std::vector<Clause>& clauses, std::string_view arrow) {
    for (std::size_t i = 0; i < clauses.size(); ++i) {
        if (i > 0) out_.text(", ");
        if (clauses[i].pattern) {
            pattern(*clauses[i].pattern);
            out_.text(arrow);
            expression(clauses[i].value, dot_level_expr);
        } else {
            expression(clauses[i].value, or_level);
        }
    }
}

void Printer::patterns(std::string_view open, const std::vector<PatternPtr>& patterns, std::string_view close) {
    out_.text(open);
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        if (i > 0) out_.text(", ");
        pattern(*patterns[i]);
    }
    out_.text(close);
}

void Printer::pattern(const Pattern& given, int minimum) {
    const auto infix = [&](int level, std::string_view op) {
        const bool parentheses = level < minimum;
        if (parentheses) out_.text("(");
        for (std::size_t i = 0; i < given.args.size(); ++i) {
            if (i > 0) out_.text(op);
            pattern(*given.args[i], i == 0 && level != 1 ? level : level + 1);
        }
        if (parentheses) out_.text(")");
    };
    switch (given.kind) {
        case PatternKind::wildcard:
            return out_.text("_");
        case PatternKind::name:
            return out_.text(given.text);
        case PatternKind::integer:
            return out_.text(std::to_string(given.number));
        case PatternKind::character:
            return out_.text(diagnostics::cspm_character(static_cast<char>(given.number)));
        case PatternKind::string:
            return out_.text(diagnostics::cspm_string(given.text));
        case PatternKind::boolean:
            return out_.text(given.number != 0 ? "true" : "false");
        case PatternKind::tuple:
            return patterns("(", given.args, ")");
        case PatternKind::sequence:
            return given.args.empty() ? out_.text("<>") : patterns("<", given.args, ">");
        case PatternKind::set:
            return patterns("{", given.args, "}");
        case PatternKind::both:
            return infix(0, " @@ ");
        case PatternKind::dot:
            return infix(1, ".");
        case PatternKind::concat:
            return infix(2, "^");
    }
}

std::string print(const ExprPtr& expr) {
    Layout layout(110);
    Printer(layout).expression(expr);
    return layout.render();
}

}  // namespace robochart::cspm
