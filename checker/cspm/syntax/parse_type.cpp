// SPDX-License-Identifier: Apache-2.0
// Parses types in annotations (`f :: (Int) -> {Event}`). Checks their syntax and stores them as text in a canonical
// form.
#include "checker/cspm/syntax/parser.hpp"
#include "checker/cspm/syntax/rules.hpp"

namespace robochart::cspm {

namespace {
bool is_constraint(std::string_view name) {
    return name == "Eq" || name == "Ord" || name == "Complete" || name == "Set" || name == "Yieldable";
}
}  // namespace

// Parses a type with optional constraints: T, C a => T, or (C a, D b) => T.
std::string Parser::parse_type_scheme() {
    const bool group = at_token(Tok::l_paren) && peek(1).kind == Tok::identifier && peek(2).kind == Tok::identifier;
    const bool single = at_token(Tok::identifier) && peek(1).kind == Tok::identifier;
    if (!group && !single) return parse_type();
    std::string result;
    if (group) take_token();
    do {
        const Token& name = expect(Tok::identifier);
        if (!is_constraint(name.text)) {
            fail(rules::unexpected_token, name.span,
                 {"a constraint (Eq, Ord, Complete, Set, Yieldable)", "'" + std::string(name.text) + "'"});
        }
        result += (result.empty() ? "" : ", ") + std::string(name.text) + " " + name_token();
    } while (group && accept(Tok::comma));
    if (group) {
        expect(Tok::r_paren);
        result = "(" + result + ")";
    }
    expect(Tok::yield);
    return result + " => " + parse_type();
}

std::string Parser::parse_type() {
    const Depth guard(*this);
    bool grouped = false;
    const Span from = peek().span;
    std::string result = parse_type_operand(grouped);
    if (at_token(Tok::arrow)) {
        if (!grouped) fail(rules::bad_annotation, span_since(from));
        take_token();
        return result + " -> " + parse_type();
    }
    if (accept(Tok::yield_star)) return result + " =>* " + parse_type();
    if (accept(Tok::yield)) return result + " => " + parse_type();
    if (accept(Tok::dot)) return result + "." + parse_type();
    return result;
}

std::string Parser::parse_type_operand(bool& grouped) {
    if (at_token(Tok::identifier)) return parse_qualified_name();
    if (accept(Tok::l_brace)) {
        std::string inner = "{" + parse_type() + "}";
        expect(Tok::r_brace);
        return inner;
    }
    if (accept(Tok::less)) {
        std::string inner = "<" + parse_type() + ">";
        expect(Tok::greater);
        return inner;
    }
    if (accept(Tok::l_map)) {
        std::string key = parse_type_operand(grouped);
        expect(Tok::yield);
        std::string value = parse_type();
        expect(Tok::r_map);
        grouped = false;
        return "(| " + key + " => " + value + " |)";
    }
    if (!at_token(Tok::l_paren)) fail("a type");
    take_token();
    grouped = true;
    std::string inner = "(";
    if (!at_token(Tok::r_paren)) inner += parse_type();
    while (accept(Tok::comma)) inner += ", " + parse_type();
    expect(Tok::r_paren);
    return inner + ")";
}

}  // namespace robochart::cspm
