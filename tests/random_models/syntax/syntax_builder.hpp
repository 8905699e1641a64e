// SPDX-License-Identifier: Apache-2.0
// Builds random syntax trees (private to the component). The trees have the form that the parser produces: operands
// with too low a precedence for their position are parenthesised.
#pragma once

#include <string>
#include <vector>

#include "frontend/syntax/ast.hpp"
#include "tests/random_models/models/random.hpp"

namespace robochart::random_models {

class SyntaxBuilder {
public:
    explicit SyntaxBuilder(Random& random) : random_(random) {}

    // Names and types (syntax_types.cpp).
    std::string name();
    frontend::QualifiedName simple();
    frontend::QualifiedName qualified();
    frontend::TypeExprPtr type(std::size_t depth);
    frontend::VariablePtr variable(frontend::DeclKind kind, std::size_t depth);

    // Expressions (syntax_expressions.cpp).
    frontend::ExprPtr expression(std::size_t depth);
    frontend::ExprPtr at(int level, std::size_t depth);

    // Statements (syntax_statements.cpp).
    frontend::StmtPtr statement(std::size_t depth);
    std::unique_ptr<frontend::Communication> communication(std::size_t depth, bool trigger);

    // Declarations (syntax_declarations.cpp).
    std::unique_ptr<frontend::Declaration> declaration();
    frontend::Import import();

    // Assertions (syntax_assertions.cpp).
    frontend::Assertion assertion();
    frontend::CspBlock csp_block();
    frontend::KeptPart kept();

    // Probabilistic assertions (syntax_probability.cpp).
    frontend::ProbabilisticAssertion probabilistic_assertion();
    frontend::ProbabilisticDefinition probabilistic_definition();

private:
    struct Leveled {
        frontend::ExprPtr expr;
        int level;
    };
    Leveled any(std::size_t depth);
    Leveled atom(std::size_t depth);
    Leveled operation(std::size_t depth);
    Leveled binder(std::size_t depth);
    Leveled bracketed(std::size_t depth);
    Leveled selection(std::size_t depth);
    Leveled probabilistic(std::size_t depth);
    frontend::ExprPtr path(std::size_t depth);
    frontend::ExprPtr step_bound(std::string& relation);
    frontend::ExprPtr quantitative(std::size_t depth);
    frontend::ExprPtr simulation();
    frontend::ExprPtr marked(const char* sign);
    frontend::ExprPtr named();
    frontend::Update update();
    frontend::ProbabilisticFunction function_of_properties();
    frontend::ProbabilisticModule module_of_properties();
    void define(frontend::ProbabilisticDefinition& definition);
    frontend::ExprPtr literal();
    frontend::ExprPtr call(std::size_t depth);
    frontend::ExprPtr matrix(std::size_t depth);
    frontend::ExprPtr target(std::size_t depth);
    void typed_bindings(frontend::Expr& expr, std::size_t depth);
    void add_list(std::vector<frontend::ExprPtr>& list, std::size_t least, std::size_t most, std::size_t depth);

    frontend::StmtPtr basic(std::size_t depth);
    frontend::StmtPtr timed(std::size_t depth);
    frontend::StmtPtr nested(frontend::StmtKind kind, std::size_t depth);

    void parameters(std::vector<frontend::VariablePtr>& list);
    void context(frontend::Context& context, bool clauses);
    void nodes(frontend::NodeContainer& container, std::size_t depth);
    std::unique_ptr<frontend::State> node(std::size_t depth);
    std::unique_ptr<frontend::Transition> transition();
    void trigger(frontend::Transition& transition);
    std::unique_ptr<frontend::Machine> machine(frontend::DeclKind kind);
    std::unique_ptr<frontend::Context> platform();
    std::unique_ptr<frontend::Component> controller();
    std::unique_ptr<frontend::Component> module();
    std::unique_ptr<frontend::Reference> reference(frontend::DeclKind to);
    std::unique_ptr<frontend::Connection> connection();
    std::unique_ptr<frontend::Declaration> type_declaration();
    std::unique_ptr<frontend::Declaration> function();
    frontend::AssertionParameter assertion_parameter();
    frontend::AssertionTime time();

    bool probabilistic_ = false;  ///< whether expressions may have the forms of probabilistic assertions
    Random& random_;
};

}  // namespace robochart::random_models
