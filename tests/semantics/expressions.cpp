// SPDX-License-Identifier: Apache-2.0
// Builds expressions for tests.
#include "tests/semantics/expressions.hpp"

#include <utility>

namespace robochart::ir::samples {
namespace {

ExprPtr number(std::int64_t value, TypeId type) {
    Expr expr;
    expr.type = type;
    expr.number = value;
    return std::make_shared<const Expr>(expr);
}

}  // namespace

ExprPtr nat(std::int64_t value) {
    return number(value, types.nat);
}
ExprPtr integer(std::int64_t value) {
    return number(value, types.integer);
}

ExprPtr decimal(std::int64_t unscaled, std::uint32_t decimals) {
    Expr expr;
    expr.kind = ExprKind::real;
    expr.type = types.real;
    expr.decimal = {unscaled, decimals};
    return std::make_shared<const Expr>(expr);
}

ExprPtr truth(bool value) {
    Expr expr;
    expr.kind = ExprKind::boolean;
    expr.type = types.boolean;
    expr.number = value ? 1 : 0;
    return std::make_shared<const Expr>(expr);
}

ExprPtr variable(std::uint32_t index, TypeId type) {
    Expr expr;
    expr.kind = ExprKind::variable;
    expr.type = type;
    expr.variable = VariableId{index};
    return std::make_shared<const Expr>(expr);
}

ExprPtr constant(std::uint32_t index, TypeId type) {
    Expr expr;
    expr.kind = ExprKind::constant;
    expr.type = type;
    expr.constant = ConstantId{index};
    return std::make_shared<const Expr>(expr);
}

ExprPtr since(std::uint32_t clock) {
    Expr expr;
    expr.kind = ExprKind::since;
    expr.type = types.nat;
    expr.clock = ClockId{clock};
    return std::make_shared<const Expr>(expr);
}

ExprPtr make(ExprKind kind, TypeId type, std::vector<ExprPtr> args) {
    Expr expr;
    expr.kind = kind;
    expr.type = type;
    expr.args = std::move(args);
    return std::make_shared<const Expr>(expr);
}

System core_system() {
    System system = aggregation();
    system.machines.clear();
    system.controllers.clear();
    system.modules.clear();
    return system;
}

}  // namespace robochart::ir::samples
