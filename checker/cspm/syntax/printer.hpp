// SPDX-License-Identifier: Apache-2.0
// Prints trees as text that FDR accepts. Operands of value operators get parentheses if precedence requires them
// (levels.hpp). Operands of process operators get parentheses unless their end is obvious. Lines end only where FDR's
// lexer ignores line ends (lexer.cpp).
#pragma once

#include <string>

#include "checker/cspm/syntax/layout.hpp"
#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

class Printer {
public:
    explicit Printer(Layout& out) : out_(out) {}

    void print_script(const Script& script);
    void print_expression(const ExprPtr& expr, int minimum = 0);
    void print_declaration(const Decl& decl);

private:
    // expressions
    void print_body(const Expr& expr);
    void print_literal(const Expr& expr);
    void print_binary_value(const Expr& expr, int level, std::string_view op);
    void print_process_operand(const ExprPtr& expr);
    void print_process_chain(const Expr& expr, std::string_view op);
    void print_process_infix(const Expr& expr);
    void print_set_operand(const ExprPtr& set);
    void print_list(std::string_view open, const std::vector<ExprPtr>& items, std::string_view close,
                    const std::vector<Clause>* clauses = nullptr, std::size_t from = 0);
    void print_range(std::string_view open, const Expr& expr, std::string_view close);
    void print_in_sequence(const Expr& expr);
    void print_application(const Expr& expr);
    void print_dot(const Expr& expr);
    void print_map(const Expr& expr);
    void print_lambda(const Expr& expr);
    void print_let(const Expr& expr);
    void print_conditional(const Expr& expr);
    void print_prefix(const Expr& expr);
    void print_field(const Field& field);
    void print_renaming(const Expr& expr);
    void print_linked(const Expr& expr);
    void print_links(const std::vector<Link>& links, std::string_view arrow, const std::vector<Clause>& clauses);
    void print_replicated(const Expr& expr);
    void print_clauses(const std::vector<Clause>& clauses, std::string_view arrow);
    [[nodiscard]] static const Expr& strip_parentheses(const ExprPtr& expr);  // without parentheses
    [[nodiscard]] bool needs_parentheses(const Expr& expr, int minimum) const;

    // patterns
    void print_pattern(const Pattern& pattern, int minimum = 0);
    void print_patterns(std::string_view open, const std::vector<PatternPtr>& patterns, std::string_view close);

    // declarations
    void print_declarations(const std::vector<DeclPtr>& decls);
    void print_comment(const std::string& text);
    void print_definition(const Decl& decl);
    void print_datatype(const Decl& decl);
    void print_module(const Decl& decl);
    void print_block(const std::vector<DeclPtr>& decls);
    void print_names(const std::vector<std::string>& names);
    void print_assertion(const Assertion& assertion);

    Layout& out_;
    bool inside_sequence_ = false;  // whether an unbracketed `>` would end the sequence
};

}  // namespace robochart::cspm
