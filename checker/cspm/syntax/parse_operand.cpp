// SPDX-License-Identifier: Apache-2.0
// Operands: literals, names, bracketed forms, and the forms that begin with a word or an operator.
#include "checker/cspm/syntax/levels.hpp"
#include "checker/cspm/syntax/parser.hpp"

namespace robochart::cspm {

ExprPtr Parser::operand() {
    switch (peek().kind) {
        case Tok::integer:
        case Tok::character:
        case Tok::string:
        case Tok::kw_true:
        case Tok::kw_false:
            return literal();
        case Tok::identifier:
            return name();
        case Tok::l_paren:
            return parenthesis();
        case Tok::l_brace:
            return braces();
        case Tok::l_pipe_brace:
            return pipe_braces();
        case Tok::l_map:
            return map();
        case Tok::less:
        case Tok::empty_sequence:
            return angles();
        case Tok::kw_let:
            return let();
        case Tok::kw_if:
            return conditional();
        case Tok::backslash:
            return lambda();
        case Tok::minus:
            return unary(ExprKind::negate, sum_level + 1);
        case Tok::kw_not:
            return unary(ExprKind::logical_not, not_level + 1);
        case Tok::hash:
            return unary(ExprKind::length, length_level + 1);
        case Tok::external_choice:
            return replicated(ExprKind::replicated_external);
        case Tok::internal_choice:
            return replicated(ExprKind::replicated_internal);
        case Tok::interleave:
            return replicated(ExprKind::replicated_interleave);
        case Tok::semicolon:
            return replicated(ExprKind::replicated_sequential);
        case Tok::parallel_bar:
            return alphabetised_replication();
        case Tok::l_pipe_square:
            return replicated_bracketed(ExprKind::replicated_parallel, Tok::r_pipe_square);
        case Tok::l_sync_choice:
            return replicated_bracketed(ExprKind::replicated_synchronising, Tok::r_sync_choice);
        case Tok::l_square:
            return replicated_square();
        default:
            fail("an expression");
    }
}

ExprPtr Parser::literal() {
    const Token& token = take();
    ExprNode result;
    switch (token.kind) {
        case Tok::integer:
            result.kind = ExprKind::integer;
            break;
        case Tok::character:
            result.kind = ExprKind::character;
            break;
        case Tok::string:
            result.kind = ExprKind::string;
            result.text = decode_string(token.text);
            break;
        default:
            result.kind = ExprKind::boolean;
            break;
    }
    result.number = token.kind == Tok::kw_true ? 1 : token.number;
    return finish(std::move(result), token.span);
}

std::string Parser::name_token() {
    return std::string(expect(Tok::identifier).text);
}

std::string Parser::qualified() {
    std::string result = name_token();
    while (accept(Tok::scope)) result += "::" + name_token();
    return result;
}

ExprPtr Parser::name() {
    const Span from = peek().span;
    ExprNode result;
    result.kind = ExprKind::name;
    result.text = qualified();
    return finish(std::move(result), from);
}

std::vector<ExprPtr> Parser::expressions(Tok close) {
    std::vector<ExprPtr> result;
    if (!at(close)) {
        do result.push_back(expression());
        while (accept(Tok::comma));
    }
    expect(close);
    return result;
}

ExprPtr Parser::parenthesis() {
    const Span from = take().span;
    const Bracket bracket(*this);
    std::vector<ExprPtr> parts = expressions(Tok::r_paren);
    if (parts.empty()) fail("an expression");
    const ExprKind kind = parts.size() == 1 ? ExprKind::parenthesised : ExprKind::tuple;
    return node(kind, from, std::move(parts));
}

// The contents of { } or < >: kinds are plain, range, comprehension, range comprehension.
ExprPtr Parser::collection(ExprNode result, Span from, Tok close, const ExprKind (&kinds)[4]) {
    result.kind = kinds[0];
    if (!at(close) && !at(Tok::pipe)) result.args.push_back(expression());
    const bool range = result.args.size() == 1 && accept(Tok::dot_dot);
    if (range) {
        result.kind = kinds[1];
        result.args.push_back(at(close) || at(Tok::pipe) ? nullptr : expression());
    }
    while (!range && accept(Tok::comma)) result.args.push_back(expression());
    if (accept(Tok::pipe)) {
        result.kind = kinds[range ? 3 : 2];
        result.clauses = clauses();
    }
    expect(close);
    return finish(std::move(result), from);
}

ExprPtr Parser::braces() {
    const Span from = take().span;
    const Bracket bracket(*this);
    return collection(
        {}, from, Tok::r_brace,
        {ExprKind::set, ExprKind::set_range, ExprKind::set_comprehension, ExprKind::set_range_comprehension});
}

ExprPtr Parser::angles() {
    const Span from = peek().span;
    if (accept(Tok::empty_sequence)) return node(ExprKind::sequence, from);
    take();
    ++open_sequences_;
    ExprPtr result = collection({}, from, Tok::greater,
                                {ExprKind::sequence, ExprKind::sequence_range, ExprKind::sequence_comprehension,
                                 ExprKind::sequence_range_comprehension});
    --open_sequences_;
    return result;
}

ExprPtr Parser::pipe_braces() {
    const Span from = take().span;
    const Bracket bracket(*this);
    ExprNode result;
    result.kind = ExprKind::productions;
    if (!at(Tok::r_pipe_brace) && !at(Tok::pipe)) {
        do result.args.push_back(expression());
        while (accept(Tok::comma));
    }
    if (accept(Tok::pipe)) {
        result.kind = ExprKind::productions_comprehension;
        result.clauses = clauses();
    }
    expect(Tok::r_pipe_brace);
    return finish(std::move(result), from);
}

ExprPtr Parser::map() {
    const Span from = take().span;
    const Bracket bracket(*this);
    std::vector<ExprPtr> pairs;
    if (!at(Tok::r_map)) {
        do {
            pairs.push_back(expression());
            expect(Tok::yield);
            pairs.push_back(expression());
        } while (accept(Tok::comma));
    }
    expect(Tok::r_map);
    return node(ExprKind::map, from, std::move(pairs));
}

ExprPtr Parser::let() {
    const Span from = take().span;
    ExprNode result;
    result.kind = ExprKind::let;
    result.decls = declarations(Place::let, &Parser::at_within);
    if (result.decls.empty()) fail("a declaration");
    if (!at(Tok::kw_within)) fail("'within'", "this `let` has no `within`", from);
    take();
    result.args = {expression()};
    return finish(std::move(result), from);
}

ExprPtr Parser::conditional() {
    const Span from = take().span;
    ExprPtr condition = expression();
    expect(Tok::kw_then);
    ExprPtr then = expression();
    expect(Tok::kw_else);
    ExprPtr otherwise = expression();
    return node(ExprKind::if_then_else, from, {std::move(condition), std::move(then), std::move(otherwise)});
}

ExprPtr Parser::lambda() {
    const Span from = take().span;
    ExprNode result;
    result.kind = ExprKind::lambda;
    result.patterns = patterns();
    expect(Tok::at);
    result.args = {expression()};
    return finish(std::move(result), from);
}

ExprPtr Parser::unary(ExprKind kind, int level) {
    const Span from = take().span;
    ExprPtr argument = expression(level);
    return node(kind, from, {std::move(argument)});
}

ExprPtr Parser::replicated(ExprKind kind) {
    const Span from = take().span;
    ExprNode result;
    result.kind = kind;
    result.clauses = clauses();
    expect(Tok::at);
    result.args = {expression()};
    return finish(std::move(result), from);
}

// [|A|] x:S @ P and [+A+] x:S @ P.
ExprPtr Parser::replicated_bracketed(ExprKind kind, Tok close) {
    const Span from = take().span;
    ExprNode result;
    result.kind = kind;
    ExprPtr set = expression();
    expect(close);
    result.clauses = clauses();
    expect(Tok::at);
    result.args = {expression(), std::move(set)};
    return finish(std::move(result), from);
}

// `|| x:S @ [A] P`: the body ends where an operand of a parallel operator would end.
ExprPtr Parser::alphabetised_replication() {
    const Span from = take().span;
    ExprNode result;
    result.kind = ExprKind::replicated_alphabetised;
    result.clauses = clauses();
    expect(Tok::at);
    expect(Tok::l_square);
    ExprPtr alphabet = expression();
    expect(Tok::r_square);
    ExprPtr process = expression(parallel_level + 1);
    result.args = {std::move(process), std::move(alphabet)};
    return finish(std::move(result), from);
}

// [a <-> b | clauses] x:s @ P: the links' own clauses are first in the tree, as conditions of the links.
ExprPtr Parser::replicated_square() {
    const Span from = take().span;
    ExprNode result;
    result.kind = ExprKind::replicated_linked;
    result.links = links(Tok::tie);
    std::vector<Clause> of_links = optional_clauses();
    expect(Tok::r_square);
    result.clauses = clauses();
    expect(Tok::at);
    result.args = {expression()};
    if (!of_links.empty()) {
        ExprNode holder;
        holder.kind = ExprKind::productions_comprehension;
        holder.clauses = std::move(of_links);
        result.args.push_back(finish(std::move(holder), from));
    }
    return finish(std::move(result), from);
}

}  // namespace robochart::cspm
