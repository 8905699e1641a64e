// SPDX-License-Identifier: Apache-2.0
// Parses P, S, R, A and E with their brackets. See parser.hpp.
#include <algorithm>
#include <array>

#include "prism/syntax/parser.hpp"

namespace robochart::prism {
namespace {

constexpr std::array<std::string_view, 15> openers{"P",       "Pmin",    "Pmax",    "S",       "R",
                                                   "Rmin",    "Rmax",    "Pminmin", "Pminmax", "Pmaxmin",
                                                   "Pmaxmax", "Rminmin", "Rminmax", "Rmaxmin", "Rmaxmax"};

}  // namespace

bool Parser::at_query() const {
    return peek().kind == Tok::word && std::ranges::find(openers, peek().text) != openers.end();
}

ExprPtr Parser::parse_query() {
    const Depth depth(*this);
    const Token& opener = take_token();
    if (opener.text.size() > 4) fail_unsupported("several objectives or players", opener.span);
    Query query;
    Expr expr;
    expr.op = Op::reward;
    if (opener.text[0] == 'P') expr.op = Op::probability;
    if (opener.text[0] == 'S') expr.op = Op::steady;
    if (opener.text.ends_with("min")) query.optimum = Optimum::minimum;
    if (opener.text.ends_with("max")) query.optimum = Optimum::maximum;
    if (expr.op == Op::reward) parse_reward_index(query);
    if (query.optimum == Optimum::none) parse_optimum(query);
    parse_relation(query);
    expect("[");
    expr.query = std::make_shared<const Query>(std::move(query));
    const Within brackets(*this, in_brackets);
    expr.parts = {expr.op == Op::reward ? parse_reward_body() : parse_expression()};
    ExprPtr question = make_checked_node(std::move(expr), opener.span);
    question = parse_old_filter(std::move(question), opener.span);
    expect("]");
    return question;
}

void Parser::parse_reward_index(Query& query) {
    if (!accept("{")) return;
    const Within braces(*this, in_brackets);
    if (peek().kind == Tok::quoted)
        query.reward = parse_quoted("a name");
    else
        query.reward_index = parse_expression();
    expect("}");
}

void Parser::parse_optimum(Query& query) {
    if (accept("min")) query.optimum = Optimum::minimum;
    if (accept("max")) query.optimum = Optimum::maximum;
    if (at_text("minmax") || at_text("maxmin")) fail_unsupported("several players", peek().span);
}

void Parser::parse_relation(Query& query) {
    if (at_text("=") && at_text("?", 1)) {
        take_token();
        take_token();
        return;
    }
    constexpr std::array<std::pair<std::string_view, Op>, 4> relations{
        {{"<=", Op::less_equal}, {"<", Op::less}, {">=", Op::greater_equal}, {">", Op::greater}}};
    for (const auto& [symbol, op] : relations) {
        if (!accept(symbol)) continue;
        query.relation = op;
        const Within bound(*this, {});
        constexpr int sum = 5;
        query.bound = parse_binary(sum);
        return;
    }
    fail("'=?' or a bound such as '>=0.5'");
}

/// Parses `F φ`, `C<=k`, `C`, `I=k`, `S`, or a path.
ExprPtr Parser::parse_reward_body() {
    const Span from = peek().span;
    if (accept("C")) {
        if (accept("<=")) return make_node(Op::cumulative, from, {parse_expression()});
        return make_node(Op::total, from, {});
    }
    if (accept("I")) {
        expect("=");
        return make_node(Op::instantaneous, from, {parse_expression()});
    }
    if (at_text("S") && (at_text("]", 1) || at_text("{", 1))) {
        take_token();
        return make_node(Op::long_run, from, {});
    }
    return parse_expression();
}

/// Parses `P=? [ path {states}{min}{max} ]`, the form of filters in older versions of PRISM.
ExprPtr Parser::parse_old_filter(ExprPtr question, Span from) {
    const Within braces(*this, in_brackets);
    ExprPtr states;
    bool least = false;
    bool most = false;
    while (accept("{")) {
        if (accept("min"))
            least = true;
        else if (accept("max"))
            most = true;
        else
            states = parse_expression();
        expect("}");
    }
    if (!states) {
        if (least || most) fail("'{states}'");
        return question;
    }
    std::string kind = "state";
    if (least) kind = most ? "range" : "min";
    if (most && !least) kind = "max";
    return make_node(Op::filter, from, {std::move(question), std::move(states)}, std::move(kind));
}

ExprPtr Parser::parse_for_paths(Op op) {
    const Depth depth(*this);
    const Span from = expect("[");
    const Within brackets(*this, in_brackets);
    ExprPtr body = parse_expression();
    expect("]");
    return make_node(op, from, {std::move(body)});
}

}  // namespace robochart::prism
