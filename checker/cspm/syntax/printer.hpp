// SPDX-License-Identifier: Apache-2.0
// Prints trees as text that FDR accepts. Operands of value operators get the parentheses that their precedence requires
// (levels.hpp); operands of process operators get them unless they are self-contained. Lines end only where FDR's lexer
// ignores line ends (lexer.cpp).
#pragma once

#include <string>

#include "checker/cspm/syntax/layout.hpp"
#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

class Printer {
public:
    explicit Printer(Layout& out) : out_(out) {}

    void script(const Script& script);
    void expression(const ExprPtr& expr, int minimum = 0);
    void declaration(const Decl& decl);

private:
    // expressions
    void body(const Expr& expr);
    void literal(const Expr& expr);
    void binary_value(const Expr& expr, int level, std::string_view op);
    void process_operand(const ExprPtr& expr);
    void process_chain(const Expr& expr, std::string_view op);
    void process_infix(const Expr& expr);
    void enclosed(const ExprPtr& set);
    void list(std::string_view open, const std::vector<ExprPtr>& items, std::string_view close,
              const std::vector<Clause>* clauses = nullptr, std::size_t from = 0);
    void range(std::string_view open, const Expr& expr, std::string_view close);
    void in_sequence(const Expr& expr);
    void apply(const Expr& expr);
    void dot(const Expr& expr);
    void map(const Expr& expr);
    void lambda(const Expr& expr);
    void let(const Expr& expr);
    void conditional(const Expr& expr);
    void prefix(const Expr& expr);
    void field(const Field& field);
    void rename(const Expr& expr);
    void linked(const Expr& expr);
    void links(const std::vector<Link>& links, std::string_view arrow, const std::vector<Clause>& clauses);
    void replicated(const Expr& expr);
    void clauses(const std::vector<Clause>& clauses, std::string_view arrow);
    [[nodiscard]] static const Expr& bare(const ExprPtr& expr);  // without parentheses
    [[nodiscard]] bool needs_parentheses(const Expr& expr, int minimum) const;

    // patterns
    void pattern(const Pattern& pattern, int minimum = 0);
    void patterns(std::string_view open, const std::vector<PatternPtr>& patterns, std::string_view close);

    // declarations
    void declarations(const std::vector<DeclPtr>& decls);
    void comment(const std::string& text);
    void definition(const Decl& decl);
    void datatype(const Decl& decl);
    void module(const Decl& decl);
    void block(const std::vector<DeclPtr>& decls);
    void names(const std::vector<std::string>& names);
    void assertion(const Assertion& assertion);

    Layout& out_;
    bool inside_sequence_ = false;  // an unbracketed `>` would close it
};

}  // namespace robochart::cspm
