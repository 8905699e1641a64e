// SPDX-License-Identifier: Apache-2.0
// Parses patterns. FDR parses a pattern as an expression and then converts it, so patterns have the precedences of
// expressions. From loosest to tightest: @@, `.`, ^.
#include <algorithm>
#include <string>

#include "checker/cspm/syntax/parser.hpp"
#include "checker/cspm/syntax/rules.hpp"

namespace robochart::cspm {

namespace {
enum PatternLevel { both_level = 0, dot_level = 1, concat_level = 2 };
}  // namespace

// Completes a node and checks its height. A chain such as `x^y^z…` is left-associative: it makes the tree higher
// although the parser does not recurse.
PatternPtr Parser::finish_node(PatternNode pattern, Span from) {
    pattern.span = span_since(from);
    for (const PatternPtr& arg : pattern.args)
        pattern.height = std::max(pattern.height, static_cast<const PatternNode&>(*arg).height);
    if (++pattern.height > max_depth) fail(rules::too_deep, pattern.span, {std::to_string(max_depth)});
    return std::make_shared<const PatternNode>(std::move(pattern));
}

std::vector<PatternPtr> Parser::parse_patterns() {
    std::vector<PatternPtr> result{parse_pattern()};
    while (accept(Tok::comma)) result.push_back(parse_pattern());
    return result;
}

PatternPtr Parser::parse_pattern(int minimum) {
    const Depth guard(*this);
    const Span from = peek().span;
    PatternPtr left = parse_pattern_operand();
    for (;;) {
        PatternNode combined;
        if (at_token(Tok::concat)) {
            combined.kind = PatternKind::concat;
            take_token();
            combined.args = {left, parse_pattern_operand()};
        } else if (at_token(Tok::dot) && minimum <= dot_level) {
            combined.kind = PatternKind::dot;
            combined.args = {left};
            while (accept(Tok::dot)) combined.args.push_back(parse_pattern(concat_level));
        } else if (at_token(Tok::double_at) && minimum <= both_level) {
            combined.kind = PatternKind::both;
            take_token();
            combined.args = {left, parse_pattern(dot_level)};
        } else {
            return left;
        }
        left = finish_node(std::move(combined), from);
    }
}

PatternPtr Parser::parse_pattern_group(PatternKind kind, Tok close) {
    const Span from = take_token().span;
    PatternNode result;
    result.kind = kind;
    if (!at_token(close)) result.args = parse_patterns();
    expect(close);
    if (kind == PatternKind::tuple && result.args.empty()) fail("a pattern");
    if (kind == PatternKind::tuple && result.args.size() == 1) return result.args.front();
    return finish_node(std::move(result), from);
}

PatternPtr Parser::parse_pattern_operand() {
    const Span from = peek().span;
    PatternNode result;
    switch (peek().kind) {
        case Tok::underscore:
            take_token();
            break;
        case Tok::identifier:
            result.kind = PatternKind::name;
            result.text = parse_qualified_name();
            break;
        case Tok::minus:
            take_token();
            result.kind = PatternKind::integer;
            result.number = -expect(Tok::integer).number;
            break;
        case Tok::integer:
            result.kind = PatternKind::integer;
            result.number = take_token().number;
            break;
        case Tok::character:
            result.kind = PatternKind::character;
            result.number = take_token().number;
            break;
        case Tok::string:
            result.kind = PatternKind::string;
            result.text = decode_string(take_token().text);
            break;
        case Tok::kw_true:
        case Tok::kw_false:
            result.kind = PatternKind::boolean;
            result.number = take_token().kind == Tok::kw_true ? 1 : 0;
            break;
        case Tok::empty_sequence:
            take_token();
            result.kind = PatternKind::sequence;
            break;
        case Tok::l_paren:
            return parse_pattern_group(PatternKind::tuple, Tok::r_paren);
        case Tok::l_brace:
            return parse_pattern_group(PatternKind::set, Tok::r_brace);
        case Tok::less:
            return parse_pattern_group(PatternKind::sequence, Tok::greater);
        default:
            fail("a pattern");
    }
    return finish_node(std::move(result), from);
}

}  // namespace robochart::cspm
