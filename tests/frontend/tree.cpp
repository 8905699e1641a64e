// SPDX-License-Identifier: Apache-2.0
#include "tree.hpp"

#include <array>

namespace robochart::frontend::testing {

namespace {

template <class Pointer>
std::string part(const Pointer& node) {
    return node ? tree(*node) : "_";
}

template <class Items>
std::string parts(const Items& items) {
    std::string out;
    for (const auto& item : items) out += " " + part(item);
    return out;
}

std::string bindings(const Expr& expr) {
    std::string out;
    for (const Binding& b : expr.bindings) {
        out += " [" + b.variable->name;
        if (b.variable->type_expr) out += " : " + tree(*b.variable->type_expr);
        if (b.value) out += " = " + tree(*b.value);
        out += "]";
    }
    return out;
}

std::string operator_word(BinaryOp op) {
    constexpr std::array words = {"iff", "=>", "\\/", "/\\", "==", "!=", ">", ">=", "<",
                                  "<=",  "in", "+",   "-",   "*",  "/",  "%", "cat"};
    return words.at(static_cast<std::size_t>(op));
}

std::string kind_word(const Expr& expr) {
    switch (expr.kind) {
        case ExprKind::unary:
            return expr.unary == UnaryOp::negate ? "neg" : "not";
        case ExprKind::binary:
            return operator_word(*expr.binary);
        case ExprKind::if_then_else:
            return "if";
        case ExprKind::let:
            return "let";
        case ExprKind::forall:
            return "forall";
        case ExprKind::exists:
            return "exists";
        case ExprKind::exists_unique:
            return "exists1";
        case ExprKind::lambda:
            return "lambda";
        case ExprKind::the:
            return "the";
        case ExprKind::cast:
            return "as";
        case ExprKind::is_type:
            return "is";
        case ExprKind::member:
            return "." + expr.text;
        case ExprKind::index:
            return "index";
        case ExprKind::call:
            return "call";
        case ExprKind::tuple:
            return "tuple";
        case ExprKind::record:
            return "record";
        case ExprKind::sequence:
            return "seq";
        case ExprKind::set:
            return "set";
        case ExprKind::set_range:
            return "set-to";
        case ExprKind::set_comprehension:
            return "set-of";
        case ExprKind::range:
            return std::string("range") + (expr.lower_closed ? "[" : "(") + (expr.upper_closed ? "]" : ")");
        case ExprKind::matrix:
            return "rows-of-" + std::to_string(expr.columns);
        case ExprKind::inverse:
            return "inverse";
        case ExprKind::transpose:
            return "transpose";
        case ExprKind::since:
            return "since";
        case ExprKind::since_entry:
            return "sinceEntry";
        case ExprKind::parenthesised:
            return "paren";
        default:
            return "error";
    }
}

bool is_leaf(const Expr& expr) {
    return expr.kind <= ExprKind::from;
}

}  // namespace

std::string tree(const Expr& expr) {
    if (is_leaf(expr)) {
        if (expr.kind == ExprKind::result) return "RESULT";
        if (expr.kind == ExprKind::to) return "TO";
        if (expr.kind == ExprKind::from) return "FROM";
        return expr.kind == ExprKind::name ? expr.name.text() : expr.text;
    }
    std::string out = "(" + kind_word(expr);
    if (!expr.name.empty() && expr.kind != ExprKind::member) out += " " + expr.name.text();
    if (expr.callee) out += " " + tree(*expr.callee);
    out += bindings(expr) + parts(expr.args);
    if (expr.type_expr) out += " " + tree(*expr.type_expr);
    return out + ")";
}

std::string tree(const TypeExpr& type) {
    constexpr std::array words = {"", "?", "Seq", "Set", "*", "->", "<->", "vector", "matrix"};
    const std::string word = words.at(static_cast<std::size_t>(type.kind));
    if (type.kind == TypeKind::name || type.kind == TypeKind::variable) return word + type.name.text();
    return "(" + word + parts(type.args) + parts(type.sizes) + ")";
}

std::string tree(const Communication& c) {
    constexpr std::array signs = {"", "?", "!", "."};
    std::string out = "{" + c.event.text() + signs.at(static_cast<std::size_t>(c.kind));
    if (!c.variable.empty()) out += c.variable.text();
    if (c.value) out += tree(*c.value);
    if (!c.from_variable.empty()) out += " from-into " + c.from_variable.text();
    if (c.predicate) out += " such-that " + tree(*c.predicate);
    return out + "}";
}

std::string tree(const Stmt& s) {
    constexpr std::array words = {"skip", "seq",          "if", "=",      "",      "call",
                                  "wait", "wait-between", "#",  "within", "paren", "error"};
    std::string out = "(" + std::string(words.at(static_cast<std::size_t>(s.kind)));
    if (s.communication) return (s.send_keyword ? "(send " : "(") + tree(*s.communication) + ")";
    if (!s.name.empty()) out += " " + s.name.text();
    for (const auto* part : {&s.condition, &s.target, &s.value, &s.upper})
        if (*part) out += " " + tree(**part);
    return out + parts(s.args) + parts(s.body) + ")";
}

}  // namespace robochart::frontend::testing
