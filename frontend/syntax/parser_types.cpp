// SPDX-License-Identifier: Apache-2.0
// Parses types (RoboChart.xtext: Type to TypeRef). The operators, from the weakest to the strongest, are `<->`
// (right-associative), `->` (right-associative) and `*` (n-ary). After the first `*`, only a name, a set, a sequence or
// parentheses may follow.
#include <fmt/format.h>

#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

TypeExprPtr Parser::wrap_type(TypeKind kind, TypeExprPtr first, Span begin) {
    auto type = std::make_unique<TypeExpr>();
    type->kind = kind;
    type->span = begin;
    if (first) type->args.push_back(std::move(first));
    return type;
}

TypeExprPtr Parser::parse_type() {
    const Nesting nesting(*this);
    const Span begin = peek().span;
    TypeExprPtr left = function_type();
    if (!accept_token("<->")) return left;
    TypeExprPtr relation = wrap_type(TypeKind::relation, std::move(left), begin);
    relation->args.push_back(parse_type());
    relation->span = span_since(begin);
    return relation;
}

TypeExprPtr Parser::function_type() {
    const Nesting nesting(*this);
    const Span begin = peek().span;
    TypeExprPtr left = product_type();
    if (!accept_token("->")) return left;
    TypeExprPtr function = wrap_type(TypeKind::function, std::move(left), begin);
    function->args.push_back(function_type());
    function->span = span_since(begin);
    return function;
}

TypeExprPtr Parser::product_type() {
    const Span begin = peek().span;
    TypeExprPtr left = vector_type();
    if (!at_token("*")) return left;
    TypeExprPtr product = wrap_type(TypeKind::product, std::move(left), begin);
    while (accept_token("*")) {
        const bool loose = at_token("vector") || at_token("matrix");
        product->args.push_back(vector_type());
        if (loose) needs_parentheses("a vector or matrix after `*`", product->args.back()->span);
    }
    product->span = span_since(begin);
    return product;
}

/// Parses `vector(T, n)` or `matrix(T, r, c)`.
TypeExprPtr Parser::vector_type() {
    if (!at_token("vector") && !at_token("matrix")) return atomic_type();
    const bool is_vector = at_token("vector");
    const Span begin = advance_token().span;
    TypeExprPtr result = wrap_type(is_vector ? TypeKind::vector : TypeKind::matrix, nullptr, begin);
    expect_token("(");
    result->args.push_back(parse_type());
    for (int i = 0; i < (is_vector ? 1 : 2); ++i) {
        expect_token(",");
        result->sizes.push_back(parse_atom());
    }
    expect_token(")");
    result->span = span_since(begin);
    return result;
}

/// Reports `Set (T)` and reads it as `Set(T)`.
TypeExprPtr Parser::spaced_set() {
    const Token word = peek();
    const Span both = diagnostics::join_spans(word.span, peek(1).span);
    const std::string text(word.text);
    if (diagnostics::Diagnostic* finding = report(syntax::blank_in_set, word.span, {text}))
        finding->fixes.push_back({both, text + "(", "write"});
    quiet_until_ = 0;
    advance_token();
    advance_token();
    TypeExprPtr result = wrap_type(text == "Set" ? TypeKind::set : TypeKind::sequence, nullptr, word.span);
    result->args.push_back(parse_type());
    expect_token(")");
    result->span = span_since(word.span);
    return result;
}

TypeExprPtr Parser::atomic_type() {
    const Span begin = peek().span;
    if (accept_token("(")) {
        TypeExprPtr inner = parse_type();
        expect_token(")");
        return inner;
    }
    if (at_token("Set(") || at_token("Seq(")) {
        TypeExprPtr result = wrap_type(at_token("Set(") ? TypeKind::set : TypeKind::sequence, nullptr, begin);
        advance_token();
        result->args.push_back(parse_type());
        expect_token(")");
        result->span = span_since(begin);
        return result;
    }
    const TypeKind kind = accept_token("?") ? TypeKind::variable : TypeKind::name;
    TypeExprPtr result = wrap_type(kind, nullptr, begin);
    const bool plain_set = peek(1).is_word("(") && (at_word("Set") || at_word("Seq")) && !peek(1).first_on_line;
    if (plain_set && result->kind == TypeKind::name) return spaced_set();
    result->name = result->kind == TypeKind::name ? qualified_name("a type") : simple_name("a type variable's name");
    result->span = span_since(begin);
    return result;
}

}  // namespace robochart::frontend
