#include "cpp_emit/expression.hpp"

#include <fmt/format.h>

#include "cpp_emit/types.hpp"
#include "cpp_emit/walk.hpp"

namespace robochart::cpp_emit {

using ir::ExprKind;
using ir::TypeKind;

namespace {

/// The wider of two numeric types: nat, int, real in this order.
TypeKind wider(TypeKind left, TypeKind right) {
    const auto rank = [](TypeKind kind) { return kind == TypeKind::real ? 2 : kind == TypeKind::integer ? 1 : 0; };
    return rank(left) >= rank(right) ? left : right;
}

const char* numeric_name(TypeKind kind) {
    return kind == TypeKind::real ? "Real" : kind == TypeKind::integer ? "Int" : "Nat";
}

bool atom(ExprKind kind) {
    switch (kind) {
        case ExprKind::boolean:
        case ExprKind::integer:
        case ExprKind::real:
        case ExprKind::enum_literal:
        case ExprKind::variable:
        case ExprKind::trigger_value:
        case ExprKind::constant:
        case ExprKind::since:
        case ExprKind::since_entry:
        case ExprKind::divide:
        case ExprKind::modulus:
            return true;
        default:
            return false;
    }
}

}  // namespace

TypeKind ExpressionWriter::kind(const ir::Expr& expr) const {
    return generation_.system.type(expr.type).kind;
}

std::string ExpressionWriter::operand(const ir::Expr& expr) const {
    return atom(expr.kind) ? write(expr) : "(" + write(expr) + ")";
}

std::string ExpressionWriter::operand_as(const ir::Expr& expr, TypeKind target) const {
    if (!numeric(target) || kind(expr) == target) return operand(expr);
    return fmt::format("{}({})", numeric_name(target), write(expr));
}

std::string ExpressionWriter::write_as(const ir::Expr& expr, ir::TypeId id) const {
    const TypeKind target = generation_.system.type(id).kind;
    if (!numeric(target) || kind(expr) == target) return write(expr);
    return fmt::format("{}({})", numeric_name(target), write(expr));
}

std::string ExpressionWriter::variable(ir::VariableId id) const {
    const StoredVariable* stored = generation_.component.stored(unit_, id);
    if (stored == nullptr) return frame_ + "." + unit_.variable_fields[id.index];
    return stored->stored() ? "state_." + stored->field : "";
}

std::string ExpressionWriter::clock(ir::ClockId id) const {
    const auto [owner, own] = generation_.component.clock(unit_, id);
    return (owner == &unit_ ? frame_ : "state_") + "." + owner->clock_fields[own.index];
}

std::string ExpressionWriter::arithmetic(const ir::Expr& expr, const char* symbol) const {
    const TypeKind result = kind(expr);
    return fmt::format("{} {} {}", operand_as(*expr.args[0], result), symbol, operand_as(*expr.args[1], result));
}

std::string ExpressionWriter::function(const ir::Expr& expr, const char* name) const {
    return fmt::format("{}({}, {})", name, write_as(*expr.args[0], expr.type), write_as(*expr.args[1], expr.type));
}

std::string ExpressionWriter::comparison(const ir::Expr& expr, const char* symbol) const {
    const TypeKind left = kind(*expr.args[0]);
    const TypeKind right = kind(*expr.args[1]);
    const TypeKind common = numeric(left) && numeric(right) ? wider(left, right) : left;
    return fmt::format("{} {} {}", operand_as(*expr.args[0], common), symbol, operand_as(*expr.args[1], common));
}

std::string ExpressionWriter::logical(const ir::Expr& expr, const char* symbol) const {
    return fmt::format("{} {} {}", operand(*expr.args[0]), symbol, operand(*expr.args[1]));
}

std::string ExpressionWriter::constant(const ir::Expr& expr) const {
    const auto& value = unit_.constants[expr.constant.index];
    return cpp_value(generation_.system, generation_.inst, expr.type, value);
}

std::string ExpressionWriter::write(const ir::Expr& expr) const {
    switch (expr.kind) {
        case ExprKind::boolean:
            return expr.number != 0 ? "true" : "false";
        case ExprKind::integer:
            return fmt::format("{}({})", numeric_name(kind(expr)), expr.number);
        case ExprKind::real:
            return fmt::format("Real({})", decimal_text(expr.decimal));
        case ExprKind::enum_literal: {
            ir::Value value;
            value.number = expr.number;
            return cpp_value(generation_.system, generation_.inst, expr.type, value);
        }
        case ExprKind::variable:
            return variable(expr.variable);
        case ExprKind::trigger_value:
            return incoming_;
        case ExprKind::constant:
            return constant(expr);
        case ExprKind::since:
        case ExprKind::since_entry:
            return fmt::format("Nat({})", clock(clock_of(*unit_.machine, expr)));
        case ExprKind::negate:
            return "-" + operand(*expr.args[0]);
        case ExprKind::logical_not:
            return "!" + operand(*expr.args[0]);
        case ExprKind::iff:
            return logical(expr, "==");
        case ExprKind::implies:
            return fmt::format("!{} || {}", operand(*expr.args[0]), operand(*expr.args[1]));
        case ExprKind::disjunction:
            return logical(expr, "||");
        case ExprKind::conjunction:
            return logical(expr, "&&");
        case ExprKind::equal:
            return comparison(expr, "==");
        case ExprKind::not_equal:
            return comparison(expr, "!=");
        case ExprKind::greater:
            return comparison(expr, ">");
        case ExprKind::greater_equal:
            return comparison(expr, ">=");
        case ExprKind::less:
            return comparison(expr, "<");
        case ExprKind::less_equal:
            return comparison(expr, "<=");
        case ExprKind::plus:
            return arithmetic(expr, "+");
        case ExprKind::minus:
            return arithmetic(expr, "-");
        case ExprKind::times:
            return arithmetic(expr, "*");
        case ExprKind::divide:
            return function(expr, "divide");
        case ExprKind::modulus:
            return function(expr, "modulus");
        case ExprKind::if_then_else:
            return fmt::format("{} ? {} : {}", operand(*expr.args[0]), write_as(*expr.args[1], expr.type),
                               write_as(*expr.args[2], expr.type));
        default:
            return {};  // refused before (support.cpp)
    }
}

}  // namespace robochart::cpp_emit
