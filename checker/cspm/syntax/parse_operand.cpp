// SPDX-License-Identifier: Apache-2.0
// Parses operands: literals, names, bracketed forms, and the forms that begin with a word or an operator.
#include "checker/cspm/syntax/levels.hpp"
#include "checker/cspm/syntax/parser.hpp"

namespace robochart::cspm {

ExprPtr Parser::parse_operand() {
    switch (peek().kind) {
        case Tok::integer:
        case Tok::character:
        case Tok::string:
        case Tok::kw_true:
        case Tok::kw_false:
            return parse_literal();
        case Tok::identifier:
            return parse_name();
        case Tok::l_paren:
            return parse_parenthesis();
        case Tok::l_brace:
            return parse_braces();
        case Tok::l_pipe_brace:
            return parse_pipe_braces();
        case Tok::l_map:
            return parse_map();
        case Tok::less:
        case Tok::empty_sequence:
            return parse_angle_brackets();
        case Tok::kw_let:
            return parse_let();
        case Tok::kw_if:
            return parse_conditional();
        case Tok::backslash:
            return parse_lambda();
        case Tok::minus:
            return parse_unary(ExprKind::negate, sum_level + 1);
        case Tok::kw_not:
            return parse_unary(ExprKind::logical_not, not_level + 1);
        case Tok::hash:
            return parse_unary(ExprKind::length, length_level + 1);
        case Tok::external_choice:
            return parse_replicated(ExprKind::replicated_external);
        case Tok::internal_choice:
            return parse_replicated(ExprKind::replicated_internal);
        case Tok::interleave:
            return parse_replicated(ExprKind::replicated_interleave);
        case Tok::semicolon:
            return parse_replicated(ExprKind::replicated_sequential);
        case Tok::parallel_bar:
            return parse_replicated_alphabetised();
        case Tok::l_pipe_square:
            return parse_replicated_bracketed(ExprKind::replicated_parallel, Tok::r_pipe_square);
        case Tok::l_sync_choice:
            return parse_replicated_bracketed(ExprKind::replicated_synchronising, Tok::r_sync_choice);
        case Tok::l_square:
            return parse_replicated_square();
        default:
            fail("an expression");
    }
}

ExprPtr Parser::parse_literal() {
    const Token& token = take_token();
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
    return finish_node(std::move(result), token.span);
}

std::string Parser::name_token() {
    return std::string(expect(Tok::identifier).text);
}

std::string Parser::parse_qualified_name() {
    std::string result = name_token();
    while (accept(Tok::scope)) result += "::" + name_token();
    return result;
}

ExprPtr Parser::parse_name() {
    const Span from = peek().span;
    ExprNode result;
    result.kind = ExprKind::name;
    result.text = parse_qualified_name();
    return finish_node(std::move(result), from);
}

std::vector<ExprPtr> Parser::parse_expressions(Tok close) {
    std::vector<ExprPtr> result;
    if (!at_token(close)) {
        do result.push_back(parse_expression());
        while (accept(Tok::comma));
    }
    expect(close);
    return result;
}

ExprPtr Parser::parse_parenthesis() {
    const Span from = take_token().span;
    const Bracket bracket(*this);
    std::vector<ExprPtr> parts = parse_expressions(Tok::r_paren);
    if (parts.empty()) fail("an expression");
    const ExprKind kind = parts.size() == 1 ? ExprKind::parenthesised : ExprKind::tuple;
    return make_node(kind, from, std::move(parts));
}

// Parses the contents of { } or < >. `kinds`: plain, range, comprehension, and range with clauses.
ExprPtr Parser::parse_collection(ExprNode result, Span from, Tok close, const ExprKind (&kinds)[4]) {
    result.kind = kinds[0];
    if (!at_token(close) && !at_token(Tok::pipe)) result.args.push_back(parse_expression());
    const bool range = result.args.size() == 1 && accept(Tok::dot_dot);
    if (range) {
        result.kind = kinds[1];
        result.args.push_back(at_token(close) || at_token(Tok::pipe) ? nullptr : parse_expression());
    }
    while (!range && accept(Tok::comma)) result.args.push_back(parse_expression());
    if (accept(Tok::pipe)) {
        result.kind = kinds[range ? 3 : 2];
        result.clauses = parse_clauses();
    }
    expect(close);
    return finish_node(std::move(result), from);
}

ExprPtr Parser::parse_braces() {
    const Span from = take_token().span;
    const Bracket bracket(*this);
    return parse_collection(
        {}, from, Tok::r_brace,
        {ExprKind::set, ExprKind::set_range, ExprKind::set_comprehension, ExprKind::set_range_comprehension});
}

ExprPtr Parser::parse_angle_brackets() {
    const Span from = peek().span;
    if (accept(Tok::empty_sequence)) return make_node(ExprKind::sequence, from);
    take_token();
    ++open_sequences_;
    ExprPtr result = parse_collection({}, from, Tok::greater,
                                      {ExprKind::sequence, ExprKind::sequence_range, ExprKind::sequence_comprehension,
                                       ExprKind::sequence_range_comprehension});
    --open_sequences_;
    return result;
}

ExprPtr Parser::parse_pipe_braces() {
    const Span from = take_token().span;
    const Bracket bracket(*this);
    ExprNode result;
    result.kind = ExprKind::productions;
    if (!at_token(Tok::r_pipe_brace) && !at_token(Tok::pipe)) {
        do result.args.push_back(parse_expression());
        while (accept(Tok::comma));
    }
    if (accept(Tok::pipe)) {
        result.kind = ExprKind::productions_comprehension;
        result.clauses = parse_clauses();
    }
    expect(Tok::r_pipe_brace);
    return finish_node(std::move(result), from);
}

ExprPtr Parser::parse_map() {
    const Span from = take_token().span;
    const Bracket bracket(*this);
    std::vector<ExprPtr> pairs;
    if (!at_token(Tok::r_map)) {
        do {
            pairs.push_back(parse_expression());
            expect(Tok::yield);
            pairs.push_back(parse_expression());
        } while (accept(Tok::comma));
    }
    expect(Tok::r_map);
    return make_node(ExprKind::map, from, std::move(pairs));
}

ExprPtr Parser::parse_let() {
    const Span from = take_token().span;
    ExprNode result;
    result.kind = ExprKind::let;
    result.decls = parse_declarations(Place::let, &Parser::at_within);
    if (result.decls.empty()) fail("a declaration");
    if (!at_token(Tok::kw_within)) fail("'within'", "this `let` has no `within`", from);
    take_token();
    result.args = {parse_expression()};
    return finish_node(std::move(result), from);
}

ExprPtr Parser::parse_conditional() {
    const Span from = take_token().span;
    ExprPtr condition = parse_expression();
    expect(Tok::kw_then);
    ExprPtr then = parse_expression();
    expect(Tok::kw_else);
    ExprPtr otherwise = parse_expression();
    return make_node(ExprKind::if_then_else, from, {std::move(condition), std::move(then), std::move(otherwise)});
}

ExprPtr Parser::parse_lambda() {
    const Span from = take_token().span;
    ExprNode result;
    result.kind = ExprKind::lambda;
    result.patterns = parse_patterns();
    expect(Tok::at);
    result.args = {parse_expression()};
    return finish_node(std::move(result), from);
}

ExprPtr Parser::parse_unary(ExprKind kind, int level) {
    const Span from = take_token().span;
    ExprPtr argument = parse_expression(level);
    return make_node(kind, from, {std::move(argument)});
}

ExprPtr Parser::parse_replicated(ExprKind kind) {
    const Span from = take_token().span;
    ExprNode result;
    result.kind = kind;
    result.clauses = parse_clauses();
    expect(Tok::at);
    result.args = {parse_expression()};
    return finish_node(std::move(result), from);
}

// Parses [|A|] x:S @ P and [+A+] x:S @ P.
ExprPtr Parser::parse_replicated_bracketed(ExprKind kind, Tok close) {
    const Span from = take_token().span;
    ExprNode result;
    result.kind = kind;
    ExprPtr set = parse_expression();
    expect(close);
    result.clauses = parse_clauses();
    expect(Tok::at);
    result.args = {parse_expression(), std::move(set)};
    return finish_node(std::move(result), from);
}

// Parses `|| x:S @ [A] P`. The body ends at the first operator that would end an operand of a parallel operator.
ExprPtr Parser::parse_replicated_alphabetised() {
    const Span from = take_token().span;
    ExprNode result;
    result.kind = ExprKind::replicated_alphabetised;
    result.clauses = parse_clauses();
    expect(Tok::at);
    expect(Tok::l_square);
    ExprPtr alphabet = parse_expression();
    expect(Tok::r_square);
    ExprPtr process = parse_expression(parallel_level + 1);
    result.args = {std::move(process), std::move(alphabet)};
    return finish_node(std::move(result), from);
}

// Parses [a <-> b | clauses] x:s @ P. The tree stores the clauses of the links first, as conditions of the
// links.
ExprPtr Parser::parse_replicated_square() {
    const Span from = take_token().span;
    ExprNode result;
    result.kind = ExprKind::replicated_linked;
    result.links = parse_links(Tok::tie);
    std::vector<Clause> of_links = parse_optional_clauses();
    expect(Tok::r_square);
    result.clauses = parse_clauses();
    expect(Tok::at);
    result.args = {parse_expression()};
    if (!of_links.empty()) {
        ExprNode holder;
        holder.kind = ExprKind::productions_comprehension;
        holder.clauses = std::move(of_links);
        result.args.push_back(finish_node(std::move(holder), from));
    }
    return finish_node(std::move(result), from);
}

}  // namespace robochart::cspm
