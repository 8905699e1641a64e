// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "base/diagnostics/escape.hpp"
#include "checker/cspm/syntax/levels.hpp"
#include "checker/cspm/syntax/printer.hpp"
#include "checker/cspm/syntax/reader.hpp"

namespace robochart::cspm {

namespace {

struct Writing {
    int level;
    std::string_view op;
};

// Returns how an operator is written, and its precedence. Atoms and bracketed forms have the highest precedence.
Writing notation_of(ExprKind kind) {
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
        case ExprKind::integer:
        case ExprKind::character:
        case ExprKind::string:
        case ExprKind::boolean:
        case ExprKind::name:
        case ExprKind::tuple:
        case ExprKind::sequence:
        case ExprKind::set:
        case ExprKind::map:
        case ExprKind::sequence_range:
        case ExprKind::set_range:
        case ExprKind::sequence_comprehension:
        case ExprKind::set_comprehension:
        case ExprKind::sequence_range_comprehension:
        case ExprKind::set_range_comprehension:
        case ExprKind::productions:
        case ExprKind::productions_comprehension:
        case ExprKind::parenthesised:
            break;
    }
    return {atom_level, ""};
}

}  // namespace

bool Printer::needs_parentheses(const Expr& expr, int minimum) const {
    if (expr.kind == ExprKind::integer && expr.number < 0) return true;
    if (inside_sequence_ && expr.kind == ExprKind::greater) return true;
    return notation_of(expr.kind).level < minimum;
}

const Expr& Printer::strip_parentheses(const ExprPtr& given) {
    const Expr* expr = given.get();
    while (expr->kind == ExprKind::parenthesised) expr = expr->args[0].get();
    return *expr;
}

void Printer::print_expression(const ExprPtr& given, int minimum) {
    const Expr* expr = &strip_parentheses(given);
    if (!needs_parentheses(*expr, minimum)) return print_body(*expr);
    const bool outside = std::exchange(inside_sequence_, false);
    out_.open_group();
    out_.add_text("(");
    print_body(*expr);
    out_.add_text(")");
    out_.close_group();
    inside_sequence_ = outside;
}

void Printer::print_body(const Expr& expr) {
    const auto [level, op] = notation_of(expr.kind);
    switch (expr.kind) {
        case ExprKind::integer:
        case ExprKind::character:
        case ExprKind::string:
        case ExprKind::boolean:
        case ExprKind::name:
            return print_literal(expr);
        case ExprKind::tuple:
            return print_list("(", expr.args, ")");
        case ExprKind::set:
        case ExprKind::set_comprehension:
            return print_list("{", expr.args, "}", &expr.clauses);
        case ExprKind::productions:
        case ExprKind::productions_comprehension:
            return print_list("{| ", expr.args, " |}", &expr.clauses);
        case ExprKind::set_range:
        case ExprKind::set_range_comprehension:
            return print_range("{", expr, "}");
        case ExprKind::sequence:
        case ExprKind::sequence_comprehension:
        case ExprKind::sequence_range:
        case ExprKind::sequence_range_comprehension:
            return print_in_sequence(expr);
        case ExprKind::map:
            return print_map(expr);
        case ExprKind::dot:
            return print_dot(expr);
        case ExprKind::apply:
            return print_application(expr);
        case ExprKind::lambda:
            return print_lambda(expr);
        case ExprKind::let:
            return print_let(expr);
        case ExprKind::if_then_else:
            return print_conditional(expr);
        case ExprKind::negate:
        case ExprKind::length:
            out_.add_text(op);
            return print_expression(expr.args[0], postfix_level);
        case ExprKind::logical_not:
            out_.add_text("not ");
            return print_expression(expr.args[0], compare_level);
        case ExprKind::prefix:
            return print_prefix(expr);
        case ExprKind::guard:
            out_.open_group();
            print_expression(expr.args[0], or_level);
            out_.add_text(" &");
            out_.space_or_line();
            print_process_operand(expr.args[1]);
            return out_.close_group();
        case ExprKind::rename:
            return print_renaming(expr);
        case ExprKind::linked:
            return print_linked(expr);
        default:
            break;
    }
    if (level == lowest_level) return print_replicated(expr);
    if (level >= or_level) return print_binary_value(expr, level, op);
    if (op.empty()) return print_process_infix(expr);
    print_process_chain(expr, op);
}

void Printer::print_literal(const Expr& expr) {
    switch (expr.kind) {
        case ExprKind::integer:
            return out_.add_text(std::to_string(expr.number));
        case ExprKind::character:
            return out_.add_text(diagnostics::cspm_character(static_cast<char>(expr.number)));
        case ExprKind::string:
            return out_.add_text(diagnostics::cspm_string(expr.text));
        case ExprKind::boolean:
            return out_.add_text(expr.number != 0 ? "true" : "false");
        default:
            return out_.add_text(expr.text);
    }
}

void Printer::print_binary_value(const Expr& expr, int level, std::string_view op) {
    const bool chains = level != compare_level;
    out_.open_group();
    print_expression(expr.args[0], chains ? level : level + 1);
    // A line may end after every operator except `>`, and before every operator except `-` and `<`.
    const bool before = expr.kind == ExprKind::greater;
    if (before)
        out_.space_or_line();
    else
        out_.add_text(" ");
    out_.add_text(op);
    if (before)
        out_.add_text(" ");
    else
        out_.space_or_line();
    print_expression(expr.args[1], level + 1);
    out_.close_group();
}

// Prints an operand of a process operator. Names, calls, bracketed forms, prefixes and guards get no parentheses.
void Printer::print_process_operand(const ExprPtr& given) {
    const Expr* expr = &strip_parentheses(given);
    const bool alone = expr->kind == ExprKind::prefix || expr->kind == ExprKind::guard;
    print_expression(given, alone ? prefix_level : postfix_level);
}

// Prints a chain of one left-associative operator, such as P [] Q [] R, as one group.
void Printer::print_process_chain(const Expr& expr, std::string_view op) {
    std::vector<const Expr*> links{&expr};
    for (;;) {
        const Expr* left = &strip_parentheses(links.back()->args[0]);
        if (left->kind != expr.kind) break;
        links.push_back(left);
    }
    out_.open_group();
    print_process_operand(links.back()->args[0]);
    for (auto link = links.rbegin(); link != links.rend(); ++link) {
        out_.space_or_line();
        out_.add_text(op);
        out_.add_text(" ");
        const bool set = expr.kind == ExprKind::hide || expr.kind == ExprKind::project;
        if (set)
            print_expression((*link)->args[1], postfix_level);
        else
            print_process_operand((*link)->args[1]);
    }
    out_.close_group();
}

void Printer::print_set_operand(const ExprPtr& set) {
    print_expression(set, dot_level_expr);
}

void Printer::print_process_infix(const Expr& expr) {
    struct Brackets {
        std::string_view open, close;
    };
    Brackets brackets{"[| ", " |] "};
    if (expr.kind == ExprKind::exception) brackets = {"[| ", " |> "};
    if (expr.kind == ExprKind::synchronising_choice) brackets = {"[+ ", " +] "};
    if (expr.kind == ExprKind::synchronising_interrupt) brackets = {"/+ ", " +\\ "};
    if (expr.kind == ExprKind::alphabetised) brackets = {"[ ", " ] "};
    out_.open_group();
    print_process_operand(expr.args[0]);
    out_.space_or_line();
    out_.add_text(brackets.open);
    print_set_operand(expr.args[2]);
    if (expr.kind == ExprKind::alphabetised) {
        out_.add_text(" || ");
        print_set_operand(expr.args[3]);
    }
    out_.add_text(brackets.close);
    print_process_operand(expr.args[1]);
    out_.close_group();
}

void Printer::print_list(std::string_view open, const std::vector<ExprPtr>& items, std::string_view close,
                         const std::vector<Clause>* given_clauses, std::size_t from) {
    const bool outside = std::exchange(inside_sequence_, open == "<");
    out_.open_group();
    out_.indent();
    out_.add_text(open);
    for (std::size_t i = from; i < items.size(); ++i) {
        if (i > from) {
            out_.add_text(",");
            out_.space_or_line();
        }
        print_expression(items[i]);
    }
    if (given_clauses != nullptr && !given_clauses->empty()) {
        out_.add_text(" |");
        out_.space_or_line();
        print_clauses(*given_clauses, " <- ");
    }
    out_.add_text(close);
    out_.outdent();
    out_.close_group();
    inside_sequence_ = outside;
}

void Printer::print_range(std::string_view open, const Expr& expr, std::string_view close) {
    const bool outside = std::exchange(inside_sequence_, open == "<");
    out_.add_text(open);
    print_expression(expr.args[0], dot_level_expr);
    out_.add_text("..");
    if (expr.args[1]) print_expression(expr.args[1], dot_level_expr);
    if (!expr.clauses.empty()) {
        out_.add_text(" | ");
        print_clauses(expr.clauses, " <- ");
    }
    out_.add_text(close);
    inside_sequence_ = outside;
}

void Printer::print_in_sequence(const Expr& expr) {
    if (expr.kind == ExprKind::sequence && expr.args.empty()) return out_.add_text("<>");
    const bool ranged = expr.kind == ExprKind::sequence_range || expr.kind == ExprKind::sequence_range_comprehension;
    if (ranged) return print_range("<", expr, ">");
    print_list("<", expr.args, ">", &expr.clauses);
}

void Printer::print_application(const Expr& expr) {
    print_expression(expr.args[0], postfix_level);
    print_list("(", expr.args, ")", nullptr, 1);
}

void Printer::print_dot(const Expr& expr) {
    for (std::size_t i = 0; i < expr.args.size(); ++i) {
        if (i > 0) out_.add_text(".");
        print_expression(expr.args[i], postfix_level);
    }
}

void Printer::print_map(const Expr& expr) {
    const bool outside = std::exchange(inside_sequence_, false);
    out_.open_group();
    out_.add_text("(| ");
    for (std::size_t i = 0; i + 1 < expr.args.size(); i += 2) {
        if (i > 0) {
            out_.add_text(",");
            out_.space_or_line();
        }
        print_expression(expr.args[i], dot_level_expr);
        out_.add_text(" => ");
        print_expression(expr.args[i + 1], dot_level_expr);
    }
    out_.add_text(" |)");
    out_.close_group();
    inside_sequence_ = outside;
}

void Printer::print_lambda(const Expr& expr) {
    out_.open_group();
    print_patterns("\\ ", expr.patterns, " @");
    out_.space_or_line();
    print_expression(expr.args[0]);
    out_.close_group();
}

void Printer::print_let(const Expr& expr) {
    out_.add_text("let");
    out_.indent();
    out_.break_line();
    print_declarations(expr.decls);
    out_.outdent();
    out_.break_line();
    out_.add_text("within");
    out_.indent();
    out_.break_line();
    print_expression(expr.args[0]);
    out_.outdent();
}

// Prints `if a then P else if b then Q else R` as one group, so that longer chains are not indented further.
void Printer::print_conditional(const Expr& given) {
    const Expr* expr = &given;
    out_.open_group();
    for (;;) {
        out_.add_text("if ");
        print_expression(expr->args[0]);
        out_.add_text(" then");
        out_.indent();
        out_.space_or_line();
        print_expression(expr->args[1]);
        out_.outdent();
        out_.space_or_line();
        out_.add_text("else ");
        const Expr* next = &strip_parentheses(expr->args[2]);
        if (next->kind != ExprKind::if_then_else) break;
        expr = next;
    }
    print_expression(expr->args[2]);
    out_.close_group();
}

void Printer::print_prefix(const Expr& expr) {
    out_.open_group();
    print_expression(expr.args[0], dot_level_expr);
    for (const Field& field : expr.fields) print_field(field);
    out_.add_text(" ->");
    out_.space_or_line();
    print_process_operand(expr.args[1]);
    out_.close_group();
}

void Printer::print_field(const Field& field) {
    if (field.kind == FieldKind::dot || field.kind == FieldKind::output) {
        out_.add_text("!");
        const bool dotted = strip_parentheses(field.value).kind == ExprKind::dot;
        return print_expression(field.value, dotted ? dot_level_expr : postfix_level);
    }
    out_.add_text(field.kind == FieldKind::input ? "?" : "$");
    print_pattern(*field.pattern, 1);
    if (!field.value) return;
    out_.add_text(":");
    print_expression(field.value, postfix_level);
}

void Printer::print_links(const std::vector<Link>& links, std::string_view arrow,
                          const std::vector<Clause>& given_clauses) {
    for (std::size_t i = 0; i < links.size(); ++i) {
        if (i > 0) {
            out_.add_text(",");
            out_.space_or_line();
        }
        print_expression(links[i].from, dot_level_expr);
        out_.add_text(arrow);
        print_expression(links[i].to, dot_level_expr);
    }
    if (!given_clauses.empty()) {
        out_.add_text(" |");
        out_.space_or_line();
        print_clauses(given_clauses, " <- ");
    }
}

void Printer::print_renaming(const Expr& expr) {
    out_.open_group();
    print_expression(expr.args[0], postfix_level);
    out_.add_text("[[ ");
    out_.indent();
    print_links(expr.links, " <- ", expr.clauses);
    out_.outdent();
    out_.add_text(" ]]");
    out_.close_group();
}

void Printer::print_linked(const Expr& expr) {
    out_.open_group();
    print_process_operand(expr.args[0]);
    out_.space_or_line();
    out_.add_text("[ ");
    print_links(expr.links, " <-> ", expr.clauses);
    out_.add_text(" ] ");
    print_process_operand(expr.args[1]);
    out_.close_group();
}

void Printer::print_replicated(const Expr& expr) {
    const bool alphabetised = expr.kind == ExprKind::replicated_alphabetised;
    out_.open_group();
    switch (expr.kind) {
        case ExprKind::replicated_external:
            out_.add_text("[] ");
            break;
        case ExprKind::replicated_internal:
            out_.add_text("|~| ");
            break;
        case ExprKind::replicated_sequential:
            out_.add_text("; ");
            break;
        case ExprKind::replicated_interleave:
            out_.add_text("||| ");
            break;
        case ExprKind::replicated_alphabetised:
            out_.add_text("|| ");
            break;
        case ExprKind::replicated_linked:
            out_.add_text("[ ");
            print_links(expr.links, " <-> ", expr.args.size() > 1 ? expr.args[1]->clauses : std::vector<Clause>{});
            out_.add_text(" ] ");
            break;
        default:
            out_.add_text(expr.kind == ExprKind::replicated_parallel ? "[| " : "[+ ");
            print_set_operand(expr.args[1]);
            out_.add_text(expr.kind == ExprKind::replicated_parallel ? " |] " : " +] ");
            break;
    }
    print_clauses(expr.clauses, ":");
    out_.add_text(" @");
    out_.space_or_line();
    if (alphabetised) {
        out_.add_text("[ ");
        print_set_operand(expr.args[1]);
        out_.add_text(" ] ");
        print_process_operand(expr.args[0]);
    } else {
        print_expression(expr.args[0]);
    }
    out_.close_group();
}

void Printer::print_clauses(const std::vector<Clause>& clauses, std::string_view arrow) {
    for (std::size_t i = 0; i < clauses.size(); ++i) {
        if (i > 0) out_.add_text(", ");
        if (clauses[i].pattern) {
            print_pattern(*clauses[i].pattern);
            out_.add_text(arrow);
            print_expression(clauses[i].value, dot_level_expr);
        } else {
            print_expression(clauses[i].value, or_level);
        }
    }
}

void Printer::print_patterns(std::string_view open, const std::vector<PatternPtr>& patterns, std::string_view close) {
    out_.add_text(open);
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        if (i > 0) out_.add_text(", ");
        print_pattern(*patterns[i]);
    }
    out_.add_text(close);
}

void Printer::print_pattern(const Pattern& given, int minimum) {
    const auto infix = [&](int level, std::string_view op) {
        const bool parentheses = level < minimum;
        if (parentheses) out_.add_text("(");
        for (std::size_t i = 0; i < given.args.size(); ++i) {
            if (i > 0) out_.add_text(op);
            print_pattern(*given.args[i], i == 0 && level != 1 ? level : level + 1);
        }
        if (parentheses) out_.add_text(")");
    };
    switch (given.kind) {
        case PatternKind::wildcard:
            return out_.add_text("_");
        case PatternKind::name:
            return out_.add_text(given.text);
        case PatternKind::integer:
            return out_.add_text(std::to_string(given.number));
        case PatternKind::character:
            return out_.add_text(diagnostics::cspm_character(static_cast<char>(given.number)));
        case PatternKind::string:
            return out_.add_text(diagnostics::cspm_string(given.text));
        case PatternKind::boolean:
            return out_.add_text(given.number != 0 ? "true" : "false");
        case PatternKind::tuple:
            return print_patterns("(", given.args, ")");
        case PatternKind::sequence:
            return given.args.empty() ? out_.add_text("<>") : print_patterns("<", given.args, ">");
        case PatternKind::set:
            return print_patterns("{", given.args, "}");
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
    Printer(layout).print_expression(expr);
    return layout.render();
}

}  // namespace robochart::cspm
