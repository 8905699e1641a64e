// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/statements.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace robochart::ir {

StmtPtr StatementMaker::make(Stmt stmt) {
    stmt.point = machine_.points++;
    return std::make_shared<const Stmt>(std::move(stmt));
}

StmtPtr StatementMaker::sequence_of(std::vector<StmtPtr> statements, const Origin& origin) {
    if (statements.size() == 1) return statements.front();
    Stmt result;
    result.kind = StmtKind::sequence;
    result.body = std::move(statements);
    result.origin = origin;
    return make(std::move(result));
}

StmtPtr StatementMaker::skip(const Origin& origin) {
    Stmt result;
    result.origin = origin;
    return make(std::move(result));
}

StmtPtr StatementMaker::assignment(VariableId variable, ExprPtr value, const Origin& origin) {
    Stmt result;
    result.kind = StmtKind::assign;
    result.variable = variable;
    result.value = std::move(value);
    result.origin = origin;
    return make(std::move(result));
}

StmtPtr StatementMaker::choice_of(std::vector<StmtPtr> alternatives, const Origin& origin) {
    Stmt result;
    result.kind = StmtKind::choose;
    result.body = std::move(alternatives);
    result.origin = origin;
    return make(std::move(result));
}

StmtPtr StatementMaker::choice_of_value(VariableId variable, const std::vector<ExprPtr>& values, const Origin& origin) {
    std::vector<StmtPtr> alternatives;
    alternatives.reserve(values.size());
    for (const ExprPtr& value : values) alternatives.push_back(assignment(variable, value, origin));
    return choice_of(std::move(alternatives), origin);
}

StmtPtr StatementMaker::if_then_else(ExprPtr condition, StmtPtr then, StmtPtr otherwise, const Origin& origin) {
    Stmt result;
    result.kind = StmtKind::if_then_else;
    result.condition = std::move(condition);
    result.body = {std::move(then), std::move(otherwise)};
    result.origin = origin;
    return make(std::move(result));
}

VariableId StatementMaker::add_variable(std::string name, TypeId type, const Origin& origin) {
    Variable variable;
    variable.name = std::move(name);
    const auto used = [&] {
        return std::ranges::find(machine_.variables, variable.name, &Variable::name) != machine_.variables.end();
    };
    while (used()) variable.name += "_";
    variable.type = type;
    variable.origin = origin;
    const VariableId result{static_cast<std::uint32_t>(machine_.variables.size())};
    machine_.variables.push_back(std::move(variable));
    return result;
}

ExprPtr StatementMaker::read(VariableId variable, diagnostics::Span span) const {
    Expr result;
    result.kind = ExprKind::variable;
    result.type = machine_.variables.at(variable.index).type;
    result.variable = variable;
    result.span = span;
    return std::make_shared<const Expr>(std::move(result));
}

}  // namespace robochart::ir
