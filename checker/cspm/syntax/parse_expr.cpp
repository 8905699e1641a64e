// SPDX-License-Identifier: Apache-2.0
// Parses expressions: operands, and operators by precedence climbing (levels.hpp).
#include <algorithm>
#include <array>

#include "checker/cspm/syntax/levels.hpp"
#include "checker/cspm/syntax/parser.hpp"
#include "checker/cspm/syntax/rules.hpp"

namespace robochart::cspm {

namespace {

enum class Side { left, right, none };

struct Operator {
    Tok token;
    ExprKind kind;
    Level level;
    Side side;
};

constexpr std::array operators{
    Operator{Tok::interleave, ExprKind::interleave, interleave_level, Side::left},
    Operator{Tok::internal_choice, ExprKind::internal_choice, internal_level, Side::left},
    Operator{Tok::external_choice, ExprKind::external_choice, external_level, Side::left},
    Operator{Tok::interrupt, ExprKind::interrupt, interrupt_level, Side::left},
    Operator{Tok::sliding, ExprKind::sliding_choice, sliding_level, Side::left},
    Operator{Tok::semicolon, ExprKind::sequential, sequential_level, Side::left},
    Operator{Tok::ampersand, ExprKind::guard, prefix_level, Side::right},
    Operator{Tok::kw_or, ExprKind::logical_or, or_level, Side::left},
    Operator{Tok::kw_and, ExprKind::logical_and, and_level, Side::left},
    Operator{Tok::equal_equal, ExprKind::equal, compare_level, Side::none},
    Operator{Tok::not_equal, ExprKind::not_equal, compare_level, Side::none},
    Operator{Tok::less, ExprKind::less, compare_level, Side::none},
    Operator{Tok::less_equal, ExprKind::less_equal, compare_level, Side::none},
    Operator{Tok::greater, ExprKind::greater, compare_level, Side::none},
    Operator{Tok::greater_equal, ExprKind::greater_equal, compare_level, Side::none},
    Operator{Tok::plus, ExprKind::plus, sum_level, Side::left},
    Operator{Tok::minus, ExprKind::minus, sum_level, Side::left},
    Operator{Tok::times, ExprKind::times, product_level, Side::left},
    Operator{Tok::divide, ExprKind::divide, product_level, Side::left},
    Operator{Tok::modulus, ExprKind::modulus, product_level, Side::left},
    Operator{Tok::concat, ExprKind::concat, concat_level_expr, Side::left},
};

const Operator* find_operator(Tok token) {
    const auto* found = std::ranges::find(operators, token, &Operator::token);
    return found == operators.end() ? nullptr : found;
}

bool is_field(Tok token) {
    return token == Tok::question || token == Tok::exclamation || token == Tok::dollar;
}

bool is_square(Tok token) {
    return token == Tok::l_square || token == Tok::l_pipe_square || token == Tok::l_sync_choice ||
           token == Tok::l_sync_interrupt;
}

Level square_level(Tok token) {
    if (token == Tok::l_sync_choice) return external_level;
    return token == Tok::l_sync_interrupt ? interrupt_level : parallel_level;
}

}  // namespace

ExprPtr Parser::parse_expression(int minimum) {
    const Depth guard(*this);
    return parse_operators(parse_operand(), minimum);
}

// Parses the operators after an operand. Hiding has the lowest precedence for its left operand, but its right operand
// is a single operand. So FDR parses `P \ A ||| Q` as `(P \ A) ||| Q`.
ExprPtr Parser::parse_operators(ExprPtr left, int minimum) {
    for (;;) {
        const Tok next = peek().kind;
        if (next == Tok::l_paren || next == Tok::l_double_square) {
            left = parse_postfix(std::move(left));
        } else if (next == Tok::dot && minimum <= dot_level_expr) {
            ExprNode dot;
            dot.kind = ExprKind::dot;
            const Span from = left->span;
            dot.args = {std::move(left)};
            while (accept(Tok::dot)) dot.args.push_back(parse_expression(dot_level_expr + 1));
            left = finish_node(std::move(dot), from);
        } else if ((next == Tok::arrow || is_field(next)) && minimum <= prefix_level) {
            left = parse_prefix(std::move(left));
        } else if ((next == Tok::backslash || next == Tok::project) && minimum <= hiding_level) {
            take_token();
            const Span from = left->span;
            const ExprKind kind = next == Tok::project ? ExprKind::project : ExprKind::hide;
            ExprPtr set = parse_expression(dot_level_expr);
            left = make_node(kind, from, {std::move(left), std::move(set)});
        } else if (is_square(next) && minimum <= square_level(next)) {
            left = parse_bracketed_infix(std::move(left));
        } else if (const Operator* found = find_operator(next);
                   found != nullptr && minimum <= found->level && !(next == Tok::greater && closes_sequence())) {
            left = parse_infix(std::move(left), found->kind, found->level, found->side == Side::right);
            const Operator* again = find_operator(peek().kind);
            if (found->side == Side::none && again != nullptr && again->level == found->level &&
                !(peek().kind == Tok::greater && closes_sequence())) {
                fail(rules::not_associative, peek().span, {std::string(spelling(peek().kind))});
            }
        } else {
            return left;
        }
    }
}

ExprPtr Parser::parse_infix(ExprPtr left, ExprKind kind, int level, bool right_associative) {
    take_token();
    const Span from = left->span;
    ExprPtr right = parse_expression(right_associative ? level : level + 1);
    return make_node(kind, from, {std::move(left), std::move(right)});
}

ExprPtr Parser::parse_prefix(ExprPtr event) {
    const Span from = event->span;
    ExprNode prefix;
    prefix.kind = ExprKind::prefix;
    while (is_field(peek().kind)) prefix.fields.push_back(parse_field());
    expect(Tok::arrow);
    ExprPtr process = parse_expression(prefix_level);
    prefix.args = {std::move(event), std::move(process)};
    return finish_node(std::move(prefix), from);
}

Field Parser::parse_field() {
    const Token& mark = take_token();
    Field result;
    if (mark.kind == Tok::exclamation) {
        result.kind = FieldKind::output;
        result.value = parse_expression(field_level);
    } else {
        result.kind = mark.kind == Tok::question ? FieldKind::input : FieldKind::nondeterministic;
        result.pattern = parse_pattern(1);
        if (accept(Tok::colon)) result.value = parse_expression(restriction_level);
    }
    result.span = span_since(mark.span);
    return result;
}

// Parses P [|A|] Q, P [|A|> Q, P [A||B] Q, P [a <-> b] Q, P [+A+] Q and P /+A+\ Q.
ExprPtr Parser::parse_bracketed_infix(ExprPtr left) {
    const Tok open = peek().kind;
    if (open == Tok::l_square) return parse_square_infix(std::move(left));
    const Span from = left->span;
    take_token();
    ExprPtr set;
    ExprKind kind = ExprKind::parallel;
    {
        const Bracket bracket(*this);
        set = parse_expression();
        if (open == Tok::l_sync_choice) {
            kind = ExprKind::synchronising_choice;
            expect(Tok::r_sync_choice);
        } else if (open == Tok::l_sync_interrupt) {
            kind = ExprKind::synchronising_interrupt;
            expect(Tok::r_sync_interrupt);
        } else if (accept(Tok::exception_end)) {
            kind = ExprKind::exception;
        } else {
            expect(Tok::r_pipe_square);
        }
    }
    ExprPtr right = parse_expression(square_level(open) + 1);
    if (square_level(open) == parallel_level && is_square(peek().kind) && square_level(peek().kind) == parallel_level) {
        fail(rules::not_associative, peek().span, {std::string(spelling(peek().kind))});
    }
    return make_node(kind, from, {std::move(left), std::move(right), std::move(set)});
}

ExprPtr Parser::parse_square_infix(ExprPtr left) {
    const Span from = left->span;
    take_token();
    ExprNode result;
    {
        const Bracket bracket(*this);
        ExprPtr first = parse_expression();
        if (accept(Tok::parallel_bar)) {
            result.kind = ExprKind::alphabetised;
            result.args = {left, nullptr, std::move(first), parse_expression()};
        } else {
            if (!at_token(Tok::tie)) half_refinement(*first, from);
            expect(Tok::tie);
            result.kind = ExprKind::linked;
            result.links.push_back({std::move(first), parse_expression()});
            if (accept(Tok::comma)) {
                std::vector<Link> more = parse_links(Tok::tie);
                result.links.insert(result.links.end(), more.begin(), more.end());
            }
            result.clauses = parse_optional_clauses();
            result.args = {left, nullptr};
        }
        expect(Tok::r_square);
    }
    result.args[1] = parse_expression(parallel_level + 1);
    if (is_square(peek().kind) && square_level(peek().kind) == parallel_level) {
        fail(rules::not_associative, peek().span, {std::string(spelling(peek().kind))});
    }
    return finish_node(std::move(result), from);
}

// Reports `P [T Q` and `P [FDR= Q`, where a part of the refinement symbol is missing.
void Parser::half_refinement(const Expr& model, Span process) {
    const bool named = model.kind == ExprKind::name && !model.text.empty() && model.text.size() <= 3 &&
                       std::ranges::all_of(model.text, [](char c) { return c >= 'A' && c <= 'Z'; });
    if (named && !at_token(Tok::r_square))
        fail("'<->' or '||'", "a refinement is written `[T=`, `[F=` or `[FD=`, without spaces, between two processes",
             process);
}

ExprPtr Parser::parse_postfix(ExprPtr left) {
    if (at_token(Tok::l_double_square)) return parse_renaming(std::move(left));
    const Span from = left->span;
    take_token();
    const Bracket bracket(*this);
    std::vector<ExprPtr> args = parse_expressions(Tok::r_paren);
    args.insert(args.begin(), std::move(left));
    return make_node(ExprKind::apply, from, std::move(args));
}

ExprPtr Parser::parse_renaming(ExprPtr process) {
    const Span from = process->span;
    take_token();
    const Bracket bracket(*this);
    ExprNode result;
    result.kind = ExprKind::rename;
    result.args = {std::move(process)};
    result.links = parse_links(Tok::drawn_from);
    result.clauses = parse_optional_clauses();
    expect(Tok::r_double_square);
    return finish_node(std::move(result), from);
}

std::vector<Link> Parser::parse_links(Tok arrow) {
    std::vector<Link> result;
    do {
        Link link;
        link.from = parse_expression();
        expect(arrow);
        link.to = parse_expression();
        result.push_back(std::move(link));
    } while (accept(Tok::comma));
    return result;
}

std::vector<Clause> Parser::parse_optional_clauses() {
    if (accept(Tok::pipe)) return parse_clauses();
    return {};
}

std::vector<Clause> Parser::parse_clauses() {
    std::vector<Clause> result{parse_clause()};
    while (accept(Tok::comma)) result.push_back(parse_clause());
    return result;
}

Clause Parser::parse_clause() {
    if (!generator_ahead()) {
        // Reports that a process is used as a condition.
        if (at_token(Tok::identifier) && peek(1).kind == Tok::arrow) {
            take_token();
            fail("'<-'");
        }
        return {nullptr, parse_expression()};
    }
    PatternPtr variable = parse_pattern();
    if (!accept(Tok::drawn_from)) expect(Tok::colon);
    return {std::move(variable), parse_expression()};
}

namespace {

bool opens_bracket(Tok kind) {
    return kind == Tok::l_paren || kind == Tok::l_brace || kind == Tok::l_pipe_brace || kind == Tok::l_map ||
           kind == Tok::l_double_square || kind == Tok::l_pipe_square || kind == Tok::l_square ||
           kind == Tok::l_sync_choice || kind == Tok::l_sync_interrupt;
}

bool closes_bracket(Tok kind) {
    return kind == Tok::r_paren || kind == Tok::r_brace || kind == Tok::r_pipe_brace || kind == Tok::r_map ||
           kind == Tok::r_double_square || kind == Tok::r_pipe_square || kind == Tok::r_square ||
           kind == Tok::exception_end || kind == Tok::r_sync_choice || kind == Tok::r_sync_interrupt;
}

bool ends_operand(Tok kind) {
    return kind == Tok::identifier || kind == Tok::integer || kind == Tok::character || kind == Tok::string ||
           kind == Tok::underscore || kind == Tok::kw_true || kind == Tok::kw_false || kind == Tok::empty_sequence ||
           kind == Tok::greater || closes_bracket(kind);
}

}  // namespace

// Returns true if the next clause is a generator: `<-` or `:` occurs before its end. A pattern looks like an
// expression, so the tokens must be scanned first.
bool Parser::generator_ahead() const {
    std::vector<bool> open;  // for each open bracket: true for a sequence, which alone ends with `>`
    Tok previous = Tok::comma;
    for (std::size_t ahead = 0;; ++ahead) {
        const Tok kind = peek(ahead).kind;
        if (kind == Tok::end || kind == Tok::newline) return false;
        if (open.empty() && (kind == Tok::drawn_from || kind == Tok::colon)) return true;
        if (open.empty() && (kind == Tok::comma || kind == Tok::pipe || kind == Tok::at)) return false;
        const bool angle = kind == Tok::greater && (open.empty() ? closes_sequence() : open.back());
        if (closes_bracket(kind) || angle) {
            if (open.empty()) return false;
            open.pop_back();
        } else if (opens_bracket(kind) || (kind == Tok::less && !ends_operand(previous))) {
            open.push_back(kind == Tok::less);
        }
        previous = kind;
    }
}

}  // namespace robochart::cspm
