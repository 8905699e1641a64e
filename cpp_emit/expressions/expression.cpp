// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/expressions/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/plan/walk.hpp"

namespace robochart::cpp_emit {

using ir::ExprKind;
using ir::TypeKind;

namespace {

/// The wider of two numeric types: nat, int, real in this order.
TypeKind wider(TypeKind left, TypeKind right) {
    const auto rank = [](TypeKind kind) { return kind == TypeKind::real ? 2 : kind == TypeKind::integer ? 1 : 0; };
    return rank(left) >= rank(right) ? left : right;
}

/// Whether the expression has the same value everywhere in the machine.
bool fixed(const ir::Expr& expr) {
    bool result = true;
    ir::visit_operands(expr, [&](const ir::Expr& part) {
        result = result &&
                 (part.kind == ExprKind::boolean || part.kind == ExprKind::integer || part.kind == ExprKind::real ||
                  part.kind == ExprKind::enum_literal || part.kind == ExprKind::constant ||
                  part.kind == ExprKind::negate || part.kind == ExprKind::plus || part.kind == ExprKind::minus ||
                  part.kind == ExprKind::times || part.kind == ExprKind::cast);
    });
    return result;
}

const char* numeric_name(TypeKind kind) {
    return kind == TypeKind::real ? "Real" : kind == TypeKind::integer ? "Int" : "Nat";
}

}  // namespace

std::string member_name(const ir::Type& type, std::int64_t number) {
    const std::vector<TypeMember> all = members(type);
    const std::int64_t first = type.kind == TypeKind::product ? 1 : 0;
    return all.at(static_cast<std::size_t>(number - first)).name;
}

std::string lent_frame(const Unit& owner) {
    return owner.frame + "_f";
}

std::string frame_parameters(const Component& component, const Unit& unit) {
    std::string text = fmt::format("[[maybe_unused]] {}<Types>& f", unit.frame);
    for (const std::size_t number : unit.lenders) {
        const Unit& lender = component.unit(number);
        text += fmt::format(", [[maybe_unused]] {}<Types>& {}", lender.frame, lent_frame(lender));
    }
    return text;
}

std::string frame_arguments(const Component& component, const Unit& unit) {
    return frame_arguments(component, unit, unit, "f");
}

std::string frame_arguments(const Component& component, const Unit& unit, const Unit& caller,
                            const std::string& frame) {
    std::string text = frame;
    for (const std::size_t number : unit.lenders)
        text += number == caller.number ? ", f" : ", " + lent_frame(component.unit(number));
    return text;
}

TypeKind ExpressionWriter::kind(const ir::Expr& expr) const {
    return generation_.system.type(expr.type).kind;
}

std::string ExpressionWriter::operand_as(const ir::Expr& expr, TypeKind target) const {
    if (!numeric(target) || kind(expr) == target) return operand(expr);
    return fmt::format("{}({})", numeric_name(target), write(expr));
}

std::string ExpressionWriter::type_text(ir::TypeId id) const {
    return cpp_type(generation_.system, id);
}

CppExpr ExpressionWriter::expression_as(const ir::Expr& expr, ir::TypeId id) const {
    const ir::Type& type = generation_.system.type(id);
    if (numeric(type.kind) && numeric(kind(expr)) && kind(expr) != type.kind)
        return CppExpr(fmt::format("{}({})", numeric_name(type.kind), write(expr)));
    const bool converts =
        composed(type) && composed(generation_.system.type(expr.type)) && type_text(id) != type_text(expr.type);
    return converts ? CppExpr(fmt::format("robochart::convert<{}>({})", type_text(id), write(expr))) : expression(expr);
}

std::string ExpressionWriter::variable(ir::VariableId id) const {
    const Component& component = generation_.component;
    if (const StoredVariable* stored = component.stored(unit_, id))
        return stored->stored() ? "state_." + stored->path : "";
    const Owner& place = unit_.variable_owners[id.index];
    const Unit& owner = component.unit(place.unit);
    return frame_of(owner) + "." + owner.variable_fields[place.place];
}

std::string ExpressionWriter::clock(ir::ClockId id) const {
    const auto [owner, own] = generation_.component.clock(unit_, id);
    return frame_of(*owner) + "." + owner->clock_fields[own.index];
}

/// The frame of the unit, of a unit that called it, or of the part's machine.
std::string ExpressionWriter::frame_of(const Unit& owner) const {
    if (&owner == &unit_) return frame_;
    if (owner.root) return generation_.component.part(unit_).place();
    return &owner == &caller_ ? "f" : lent_frame(owner);
}

CppExpr ExpressionWriter::arithmetic(const ir::Expr& expr, const char* symbol, const char* name,
                                     Binding binding) const {
    if (block_arithmetic(expr)) return block_arithmetic_text(expr);
    const TypeKind result = kind(expr);
    if (result != TypeKind::real) return CppExpr(function(expr, name));
    return {fmt::format("{} {} {}", operand_as(*expr.args[0], result), symbol, operand_as(*expr.args[1], result)),
            binding};
}

CppExpr ExpressionWriter::negated(const ir::Expr& expr) const {
    const ir::Expr& arg = *expr.args[0];
    if (!numeric(kind(expr))) return {"-" + operand(arg), Binding::prefix};
    const bool defined = kind(expr) == TypeKind::real || arg.kind == ExprKind::integer;  // a literal is not negative
    if (defined) return {"-" + operand_as(arg, kind(expr)), Binding::prefix};
    return CppExpr(fmt::format("negative({})", write_as(arg, expr.type)));
}

std::string ExpressionWriter::function(const ir::Expr& expr, const char* name) const {
    return fmt::format("{}({}, {})", name, write_as(*expr.args[0], expr.type), write_as(*expr.args[1], expr.type));
}

CppExpr ExpressionWriter::comparison(const ir::Expr& expr, const char* symbol, Binding binding) const {
    const TypeKind left = kind(*expr.args[0]);
    const TypeKind right = kind(*expr.args[1]);
    if (numeric(left) && numeric(right)) {
        const TypeKind common = wider(left, right);
        return compared(expr, symbol, operand_as(*expr.args[0], common), operand_as(*expr.args[1], common), binding);
    }
    return compared(expr, symbol, operand(*expr.args[0]), expression_as(*expr.args[1], expr.args[0]->type).operand(),
                    binding);
}

CppExpr ExpressionWriter::compared(const ir::Expr& expr, const char* symbol, const std::string& left,
                                   const std::string& right, Binding binding) const {
    std::string text = fmt::format("{} {} {}", left, symbol, right);
    const bool left_fixed = fixed(*expr.args[0]);
    if (binding != Binding::equality || left_fixed == fixed(*expr.args[1])) return {std::move(text), binding};
    return CppExpr::test(std::move(text), left_fixed ? right : left, expr.kind == ExprKind::not_equal);
}

std::string ExpressionWriter::constant(const ir::Expr& expr) const {
    const auto& value = unit_.constants[expr.constant.index];
    return cpp_value(generation_.system, generation_.inst, expr.type, value);
}

std::string ExpressionWriter::enum_literal(const ir::Expr& expr) const {
    const ir::Type& type = generation_.system.type(expr.type);
    const auto index = static_cast<std::size_t>(expr.number);
    const std::string name = cpp_type(generation_.system, expr.type) + "::" + literal_name(type, index);
    if (!is_struct(type)) return name;
    std::vector<ir::TypeId> types;
    if (index < type.literal_args.size()) types = type.literal_args[index];
    return fmt::format("{}({})", name, list(expr, types));
}

std::string ExpressionWriter::list(const ir::Expr& expr, const std::vector<ir::TypeId>& types) const {
    std::string text;
    for (std::size_t i = 0; i < expr.args.size(); ++i) {
        const ir::TypeId type = types.at(types.size() > 1 ? i : 0);
        text += (i == 0 ? "" : ", ") + write_as(*expr.args[i], type);
    }
    return text;
}

std::string ExpressionWriter::built(const ir::Expr& expr, const char* maker) const {
    const ir::Type& type = generation_.system.type(expr.type);
    if (!of_pairs(type)) return fmt::format("{}::{}({})", type_text(expr.type), maker, list(expr, type.args));
    std::string pairs;
    for (const ir::ExprPtr& pair : expr.args)
        pairs += fmt::format("{}robochart::convert<{}>({})", pairs.empty() ? "" : ", ",
                             cpp_pair(generation_.system, type), write(*pair));
    return fmt::format("{}::{}({})", type_text(expr.type), maker, pairs);
}

/// Conversion to a coarser unit rounds down (semantics 3.13).
std::string ExpressionWriter::cast(const ir::Expr& expr) const {
    const ir::Expr& from = *expr.args[0];
    if (composed(generation_.system.type(expr.type))) return write_as(from, expr.type);
    if (kind(from) == kind(expr)) return operand(from);
    const bool down = kind(from) == TypeKind::real;
    const std::string type = cpp_type(generation_.system, expr.type);
    return down ? fmt::format("rounded_down<{}>({})", type, write(from)) : fmt::format("{}({})", type, write(from));
}

/// Functions are specified only by contracts: the platform computes them.
std::string ExpressionWriter::call(const ir::Expr& expr) const {
    return platform_call(expr.function, call_arguments(expr));
}

std::string ExpressionWriter::call_arguments(const ir::Expr& expr) const {
    const ir::Function& function = generation_.system.functions[expr.function.index];
    std::string arguments;
    for (std::size_t i = 0; i < expr.args.size(); ++i)
        arguments += (i == 0 ? "" : ", ") + write_as(*expr.args[i], function.parameters[i]);
    return arguments;
}

const FunctionHook& ExpressionWriter::hook(ir::FunctionId id) const {
    const auto& hooks = generation_.component.functions;
    return *std::ranges::find_if(hooks, [&](const FunctionHook& each) { return each.id == id; });
}

std::string ExpressionWriter::platform_call(ir::FunctionId id, const std::string& arguments) const {
    return fmt::format("platform_.{}({})", hook(id).method, arguments);
}

std::string ExpressionWriter::place(const ir::Expr& index) const {
    return fmt::format("place_of({})", write(index));
}

/// Indices of sequences and vectors. For a matrix, the first index is the row, the second the position in the row.
std::string ExpressionWriter::index(const ir::Expr& expr) const {
    std::string text = operand(*expr.args[0]);
    for (std::size_t i = 1; i < expr.args.size(); ++i) text += fmt::format(".at({})", place(*expr.args[i]));
    return text;
}

/// Tests membership in a range by its bounds, because ranges may be large.
std::string ExpressionWriter::membership(const ir::Expr& expr) const {
    const ir::Expr& value = *expr.args[0];
    const ir::Expr& set = *expr.args[1];
    const ir::Type& whole = generation_.system.type(set.type);
    if (of_pairs(whole))
        return fmt::format("{}.contains(robochart::convert<{}>({}))", operand(set), cpp_pair(generation_.system, whole),
                           write(value));
    const ir::TypeId member = whole.args.at(0);
    const bool range = set.kind == ExprKind::set_range || set.kind == ExprKind::range;
    if (!range || generation_.system.type(member).kind == TypeKind::real)
        return fmt::format("{}.contains({})", operand(set), write_as(value, member));
    const bool open_low = set.kind == ExprKind::range && (set.number == 1 || set.number == 3);
    const bool open_high = set.kind == ExprKind::range && set.number >= 2;
    return fmt::format(
        "[&] {{ const auto tested = {}; return {} {} tested && tested {} {}; }}()", write_as(value, member),
        expression_as(*set.args[0], member).operand(Binding::sum),
        open_low ? "<" : "<=", open_high ? "<" : "<=", expression_as(*set.args[1], member).operand(Binding::sum));
}

std::string ExpressionWriter::let(const ir::Expr& expr) const {
    return bound_by_let(expr, expr.bound_names.size(), write_as(*expr.args.back(), expr.type));
}

/// Each name becomes the parameter of a lambda that is called at once, because the value may use another variable with
/// that name.
std::string ExpressionWriter::bound_by_let(const ir::Expr& expr, std::size_t count, std::string text) const {
    for (std::size_t i = count; i-- > 0;)
        text = fmt::format("[&]([[maybe_unused]] const auto& {}) {{ return {}; }}({})",
                           bound_identifier(expr.bound_names[i]), text, write(*expr.args[i]));
    return text;
}

CppExpr ExpressionWriter::expression(const ir::Expr& expr) const {
    generation_.inst.poll();
    CppExpr text = of_kind(expr);
    if (text.empty())
        throw std::logic_error("generated code reads what it has no place for, in " + unit_.machine->name);
    return text;
}

CppExpr ExpressionWriter::of_kind(const ir::Expr& expr) const {
    switch (expr.kind) {
        case ExprKind::boolean:
            return CppExpr(expr.number != 0 ? "true" : "false");
        case ExprKind::integer:
            return CppExpr(fmt::format("{}({})", numeric_name(kind(expr)), expr.number));
        case ExprKind::real:
            return CppExpr(fmt::format("Real({})", decimal_text(expr.decimal)));
        case ExprKind::enum_literal:
            return CppExpr(enum_literal(expr));
        case ExprKind::variable:
            return CppExpr(variable(expr.variable));
        case ExprKind::trigger_value:
            return CppExpr(incoming_);
        case ExprKind::constant:
            return CppExpr(constant(expr));
        case ExprKind::since:
        case ExprKind::since_entry:
            return CppExpr(fmt::format("Nat({})", clock(clock_of(*unit_.machine, expr))));
        case ExprKind::negate:
            return negated(expr);
        case ExprKind::logical_not:
            return negation(expression(*expr.args[0]));
        case ExprKind::iff:
            return {fmt::format("{} == {}", operand(*expr.args[0]), operand(*expr.args[1])), Binding::equality};
        case ExprKind::implies:
            return disjunction(negation(expression(*expr.args[0])), expression(*expr.args[1]), Binding::prefix);
        case ExprKind::disjunction:
            return disjunction(expression(*expr.args[0]), expression(*expr.args[1]), Binding::primary);
        case ExprKind::conjunction:
            return conjunction(expression(*expr.args[0]), expression(*expr.args[1]), Binding::primary);
        case ExprKind::equal:
            return comparison(expr, "==", Binding::equality);
        case ExprKind::not_equal:
            return comparison(expr, "!=", Binding::equality);
        case ExprKind::greater:
            return comparison(expr, ">", Binding::order);
        case ExprKind::greater_equal:
            return comparison(expr, ">=", Binding::order);
        case ExprKind::less:
            return comparison(expr, "<", Binding::order);
        case ExprKind::less_equal:
            return comparison(expr, "<=", Binding::order);
        case ExprKind::plus:
            return arithmetic(expr, "+", "plus", Binding::sum);
        case ExprKind::minus:
            return arithmetic(expr, "-", "minus", Binding::sum);
        case ExprKind::times:
            return arithmetic(expr, "*", "times", Binding::product);
        case ExprKind::divide:
            return CppExpr(function(expr, "divide"));
        case ExprKind::modulus:
            return CppExpr(function(expr, "modulus"));
        case ExprKind::if_then_else:
            return {fmt::format("{} ? {} : {}", operand(*expr.args[0]), write_as(*expr.args[1], expr.type),
                                write_as(*expr.args[2], expr.type)),
                    Binding::conditional};
        case ExprKind::cast:
            return CppExpr(cast(expr));
        case ExprKind::tuple:
        case ExprKind::record:
            return CppExpr(built(expr, "make"));
        case ExprKind::sequence:
        case ExprKind::set:
        case ExprKind::matrix:
            return CppExpr(built(expr, "of"));
        case ExprKind::member:
            return CppExpr(operand(*expr.args[0]) + "." +
                           member_name(generation_.system.type(expr.args[0]->type), expr.number));
        case ExprKind::index:
            return CppExpr(index(expr));
        case ExprKind::concat:
            return CppExpr(
                fmt::format("concat({}, {})", write_as(*expr.args[0], expr.type), write_as(*expr.args[1], expr.type)));
        case ExprKind::is_in:
            return CppExpr(membership(expr));
        case ExprKind::string:
            return CppExpr(fmt::format("{}::of({})", type_text(expr.type), diagnostics::cpp_string(expr.characters)));
        case ExprKind::set_range:
        case ExprKind::range:
            return CppExpr(range(expr));
        case ExprKind::forall:
        case ExprKind::exists:
        case ExprKind::exists_unique:
            return quantified(expr);
        case ExprKind::lambda:
        case ExprKind::the:
        case ExprKind::set_comprehension:
            return CppExpr(collected(expr));
        case ExprKind::apply:
            return CppExpr(apply(expr));
        case ExprKind::function_value:
            return CppExpr(function_value(expr));
        case ExprKind::toolkit:
            return CppExpr(toolkit(expr));
        case ExprKind::is_type:
            return CppExpr(is_type(expr));
        case ExprKind::transpose:
            return CppExpr(fmt::format("robochart::transposed<{}>({})", type_text(expr.type), write(*expr.args[0])));
        case ExprKind::call:
            return CppExpr(call(expr));
        case ExprKind::bound:
            return CppExpr(bound_identifier(expr.text));
        case ExprKind::let:
            return CppExpr(let(expr));
    }
    return {};
}

}  // namespace robochart::cpp_emit
