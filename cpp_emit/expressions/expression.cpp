// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/expressions/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <stdexcept>

#include "cpp_emit/plan/list_capacities.hpp"
#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/plan/walk.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::cpp_emit {

using ir::ExprKind;
using ir::TypeKind;

namespace {

/// Returns the wider of two numeric types: nat, int, real in this order.
TypeKind wider_kind(TypeKind left, TypeKind right) {
    const auto rank = [](TypeKind kind) {
        if (kind == TypeKind::real) return 2;
        return kind == TypeKind::integer ? 1 : 0;
    };
    return rank(left) >= rank(right) ? left : right;
}

/// Returns true if the expression has the same value wherever the machine evaluates it.
bool is_fixed(const ir::Expr& expr) {
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
    if (kind == TypeKind::real) return "Real";
    return kind == TypeKind::integer ? "Int" : "Nat";
}

}  // namespace

std::string member_name(const ir::Type& type, std::int64_t number) {
    const std::vector<TypeMember> all = type_members(type);
    const std::int64_t first = type.kind == TypeKind::product ? 1 : 0;
    return all.at(static_cast<std::size_t>(number - first)).name;
}

std::string lent_frame(const Unit& owner) {
    return owner.frame + "_f";
}

std::string frame_parameters(const Component& component, const Unit& unit) {
    std::string text = fmt::format("[[maybe_unused]] {}<Types>& f", unit.frame);
    for (const std::size_t number : unit.lenders) {
        const Unit& lender = component.unit_at(number);
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
        text += number == caller.number ? ", f" : ", " + lent_frame(component.unit_at(number));
    return text;
}

TypeKind ExpressionWriter::kind_of(const ir::Expr& expr) const {
    return generation_.system.type(expr.type).kind;
}

std::string ExpressionWriter::operand_as(const ir::Expr& expr, TypeKind target) const {
    if (!is_numeric(target) || kind_of(expr) == target) return write_operand(expr);
    return fmt::format("{}({})", numeric_name(target), write(expr));
}

std::string ExpressionWriter::type_text(ir::TypeId id) const {
    return cpp_type(generation_.system, id);
}

CppExpr ExpressionWriter::expression_as(const ir::Expr& expr, ir::TypeId id) const {
    const ir::Type& type = generation_.system.type(id);
    if (is_numeric(type.kind) && is_numeric(kind_of(expr)) && kind_of(expr) != type.kind)
        return CppExpr(fmt::format("{}({})", numeric_name(type.kind), write(expr)));
    const bool converts =
        is_composed(type) && is_composed(generation_.system.type(expr.type)) && type_text(id) != type_text(expr.type);
    return converts ? CppExpr(fitting(id, fmt::format("robochart::convert<{}>({})", type_text(id), write(expr))))
                    : cpp_expression(expr);
}

std::string ExpressionWriter::fitting(ir::TypeId type, const std::string& value) const {
    return has_lists(generation_.system, type) ? fmt::format("fit<Types>({})", value) : value;
}

/// Returns the text of a RoboSim variable that represents the register of an event: whether the register is full, or
/// its value. If nothing fills a register, it is always empty.
std::string ExpressionWriter::register_text(const EventUse& use, ir::VariableId id) const {
    const Component& component = generation_.component;
    const ir::Variable& variable = unit_.machine->variables[id.index];
    const bool value = variable.name.ends_with('?');
    const ir::Value absent = ir::default_value(generation_.system, generation_.inst, variable.type);
    const std::string empty = value ? cpp_value(generation_.system, generation_.inst, variable.type, absent) : "false";
    if (!use.emptied.empty()) {
        const std::string latched = "latched_" + component.buffers[use.emptied.front()].field + "_";
        return value ? fmt::format("({0}.full() ? {0}.value : {1})", latched, empty) : latched + ".full()";
    }
    if (use.ports.empty()) return empty;
    const std::string& input = component.events[use.ports.front()].input;
    return value ? fmt::format("robochart::content(inputs_.{}, {})", input, empty)
                 : fmt::format("bool(inputs_.{}.present)", input);
}

std::string ExpressionWriter::variable_member(ir::VariableId id) const {
    const Component& component = generation_.component;
    if (const EventUse* use = component.find_register(unit_, id)) return register_text(*use, id);
    if (const StoredVariable* stored = component.stored_variable(unit_, id)) {
        const StoredVariable* const memory = component.memory_of(*stored);
        if (memory != nullptr && stored->local && generation_.mutation.hits(Fault::cycle_read_late))
            return "state_." + memory->path;
        if (stored->local) return stored->field + ".value";
        return stored->in_state() ? "state_." + stored->path : "";
    }
    assert(id.index < unit_.variable_owners.size());
    const Owner& place = unit_.variable_owners[id.index];
    const Unit& owner = component.unit_at(place.unit);
    return frame_of(owner) + "." + owner.variable_fields[place.place];
}

std::string ExpressionWriter::clock_member(ir::ClockId id) const {
    const auto [owner, own] = generation_.component.clock_owner(unit_, id);
    assert(own.index < owner->clock_fields.size());
    return frame_of(*owner) + "." + owner->clock_fields[own.index];
}

/// Returns the frame of the unit, of a unit that called it, or of the part's machine.
std::string ExpressionWriter::frame_of(const Unit& owner) const {
    if (&owner == &unit_) return frame_;
    if (owner.root) return generation_.component.part_of(unit_).frame_expression();
    return &owner == &caller_ ? "f" : lent_frame(owner);
}

CppExpr ExpressionWriter::write_arithmetic(const ir::Expr& expr, const char* symbol, const char* name,
                                           Binding binding) const {
    if (block_arithmetic(expr)) return block_arithmetic_text(expr);
    assert(expr.args.size() == 2);
    const TypeKind result = kind_of(expr);
    if (result != TypeKind::real) return CppExpr(write_function(expr, name));
    return {fmt::format("{} {} {}", operand_as(*expr.args[0], result), symbol, operand_as(*expr.args[1], result)),
            binding};
}

CppExpr ExpressionWriter::write_negation(const ir::Expr& expr) const {
    assert(expr.args.size() == 1);
    const ir::Expr& arg = *expr.args[0];
    if (!is_numeric(kind_of(expr))) return {"-" + write_operand(arg), Binding::prefix};
    const bool defined = kind_of(expr) == TypeKind::real || arg.kind == ExprKind::integer;  // a literal is not negative
    if (defined) return {"-" + operand_as(arg, kind_of(expr)), Binding::prefix};
    return CppExpr(fmt::format("negative({})", write_as(arg, expr.type)));
}

std::string ExpressionWriter::write_function(const ir::Expr& expr, const char* name) const {
    return fmt::format("{}({}, {})", name, write_as(*expr.args[0], expr.type), write_as(*expr.args[1], expr.type));
}

CppExpr ExpressionWriter::write_comparison(const ir::Expr& expr, const char* symbol, Binding binding) const {
    assert(expr.args.size() == 2);
    const TypeKind left = kind_of(*expr.args[0]);
    const TypeKind right = kind_of(*expr.args[1]);
    if (is_numeric(left) && is_numeric(right)) {
        const TypeKind common = wider_kind(left, right);
        return comparison_text(expr, symbol, operand_as(*expr.args[0], common), operand_as(*expr.args[1], common),
                               binding);
    }
    return comparison_text(expr, symbol, write_operand(*expr.args[0]),
                           expression_as(*expr.args[1], expr.args[0]->type).as_operand(), binding);
}

CppExpr ExpressionWriter::comparison_text(const ir::Expr& expr, const char* symbol, const std::string& left,
                                          const std::string& right, Binding binding) const {
    std::string text = fmt::format("{} {} {}", left, symbol, right);
    const bool left_fixed = is_fixed(*expr.args[0]);
    if (binding != Binding::equality || left_fixed == is_fixed(*expr.args[1])) return {std::move(text), binding};
    return CppExpr::equality_test(std::move(text), left_fixed ? right : left, expr.kind == ExprKind::not_equal);
}

std::string ExpressionWriter::constant_text(const ir::Expr& expr) const {
    assert(expr.constant.index < unit_.constants.size());
    const auto& value = unit_.constants[expr.constant.index];
    return cpp_value(generation_.system, generation_.inst, expr.type, value);
}

std::string ExpressionWriter::enum_literal(const ir::Expr& expr) const {
    const ir::Type& type = generation_.system.type(expr.type);
    assert(expr.number >= 0);
    const auto index = static_cast<std::size_t>(expr.number);
    const std::string name = cpp_type(generation_.system, expr.type) + "::" + literal_name(type, index);
    if (!is_struct(type)) return name;
    std::vector<ir::TypeId> types;
    if (index < type.literal_args.size()) types = type.literal_args[index];
    return fmt::format("{}({})", name, argument_list(expr, types));
}

std::string ExpressionWriter::argument_list(const ir::Expr& expr, const std::vector<ir::TypeId>& types) const {
    std::string text;
    for (std::size_t i = 0; i < expr.args.size(); ++i) {
        const ir::TypeId type = types.at(types.size() > 1 ? i : 0);
        text += (i == 0 ? "" : ", ") + write_as(*expr.args[i], type);
    }
    return text;
}

std::string ExpressionWriter::built_value(const ir::Expr& expr, const char* maker) const {
    const ir::Type& type = generation_.system.type(expr.type);
    if (!has_pairs(type)) return fmt::format("{}::{}({})", type_text(expr.type), maker, argument_list(expr, type.args));
    std::string pairs;
    for (const ir::ExprPtr& pair : expr.args) pairs += (pairs.empty() ? "" : ", ") + pair_text(type, *pair);
    return fmt::format("{}::{}({})", type_text(expr.type), maker, pairs);
}

/// Writes a conversion. Conversion to a coarser unit rounds down (semantics 3.13).
std::string ExpressionWriter::write_cast(const ir::Expr& expr) const {
    const ir::Expr& from = *expr.args[0];
    if (is_composed(generation_.system.type(expr.type))) return write_as(from, expr.type);
    if (kind_of(from) == kind_of(expr)) return write_operand(from);
    const bool down = kind_of(from) == TypeKind::real;
    const std::string type = cpp_type(generation_.system, expr.type);
    return down ? fmt::format("rounded_down<{}>({})", type, write(from)) : fmt::format("{}({})", type, write(from));
}

/// Returns the pair as an element of a function or relation.
std::string ExpressionWriter::pair_text(const ir::Type& whole, const ir::Expr& pair) const {
    return fitting(pair.type,
                   fmt::format("robochart::convert<{}>({})", cpp_pair(generation_.system, whole), write(pair)));
}

/// Writes a call of a function. If only a contract specifies the function, the platform computes it.
std::string ExpressionWriter::write_call(const ir::Expr& expr) const {
    return platform_call(expr.function, call_arguments(expr));
}

std::string ExpressionWriter::call_arguments(const ir::Expr& expr) const {
    const ir::Function& function = generation_.system.functions[expr.function.index];
    assert(expr.args.size() <= function.parameters.size());
    std::string arguments;
    for (std::size_t i = 0; i < expr.args.size(); ++i)
        arguments += (i == 0 ? "" : ", ") + write_as(*expr.args[i], function.parameters[i]);
    return arguments;
}

const FunctionHook& ExpressionWriter::hook_of(ir::FunctionId id) const {
    const auto& hooks = generation_.component.functions;
    return *std::ranges::find_if(hooks, [&](const FunctionHook& hook) { return hook.id == id; });
}

std::string ExpressionWriter::platform_call(ir::FunctionId id, const std::string& arguments) const {
    return fmt::format("platform_.{}({})", hook_of(id).method, arguments);
}

std::string ExpressionWriter::item_index(const ir::Expr& index) const {
    return fmt::format("place_of({})", write(index));
}

/// Writes an index of a sequence or vector. For a matrix, the first index is the row, and the second is the position in
/// the row.
std::string ExpressionWriter::write_index(const ir::Expr& expr) const {
    std::string text = write_operand(*expr.args[0]);
    for (std::size_t i = 1; i < expr.args.size(); ++i) text += fmt::format(".at({})", item_index(*expr.args[i]));
    return text;
}

/// Writes membership in a range as comparisons with its bounds, because a range may be large.
std::string ExpressionWriter::write_membership(const ir::Expr& expr) const {
    const ir::Expr& value = *expr.args[0];
    assert(expr.args.size() == 2);
    const ir::Expr& set = *expr.args[1];
    const ir::Type& whole = generation_.system.type(set.type);
    if (has_pairs(whole)) return fmt::format("{}.contains({})", write_operand(set), pair_text(whole, value));
    const ir::TypeId member = whole.args.at(0);
    const bool range = set.kind == ExprKind::set_range || set.kind == ExprKind::range;
    if (!range || generation_.system.type(member).kind == TypeKind::real)
        return fmt::format("{}.contains({})", write_operand(set), write_as(value, member));
    const bool open_low = set.kind == ExprKind::range && (set.number == 1 || set.number == 3);
    const bool open_high = set.kind == ExprKind::range && set.number >= 2;
    return fmt::format(
        "[&] {{ const auto tested = {}; return {} {} tested && tested {} {}; }}()", write_as(value, member),
        expression_as(*set.args[0], member).as_operand(Binding::sum),
        open_low ? "<" : "<=", open_high ? "<" : "<=", expression_as(*set.args[1], member).as_operand(Binding::sum));
}

std::string ExpressionWriter::write_let(const ir::Expr& expr) const {
    return bound_by_let(expr, expr.bound_names.size(), write_as(*expr.args.back(), expr.type));
}

/// Writes `let`. The bound names become parameters of a lambda that is called at once. So a value may still use an
/// outer variable with the same name.
std::string ExpressionWriter::bound_by_let(const ir::Expr& expr, std::size_t count, std::string text) const {
    assert(count <= expr.bound_names.size() && count < expr.args.size());
    for (std::size_t i = count; i-- > 0;)
        text = fmt::format("[&]([[maybe_unused]] const auto& {}) {{ return {}; }}({})",
                           bound_identifier(expr.bound_names[i]), text, write(*expr.args[i]));
    return text;
}

CppExpr ExpressionWriter::cpp_expression(const ir::Expr& expr) const {
    generation_.inst.poll();
    CppExpr text = write_fold(expr);
    if (text.empty()) text = of_kind(expr);
    if (text.empty()) throw std::logic_error("generated code reads a value without a place, in " + unit_.machine->name);
    return may_overflow(generation_.system, expr) ? CppExpr(fitting(expr.type, text.whole_text())) : text;
}

CppExpr ExpressionWriter::of_kind(const ir::Expr& expr) const {
    switch (expr.kind) {
        case ExprKind::boolean:
            return CppExpr(expr.number != 0 ? "true" : "false");
        case ExprKind::integer:
            return CppExpr(fmt::format("{}({})", numeric_name(kind_of(expr)), expr.number));
        case ExprKind::real:
            return CppExpr(fmt::format("Real({})", decimal_text(expr.decimal)));
        case ExprKind::enum_literal:
            return CppExpr(enum_literal(expr));
        case ExprKind::variable:
            return CppExpr(variable_member(expr.variable));
        case ExprKind::trigger_value:
            return CppExpr(incoming_);
        case ExprKind::constant:
            return CppExpr(constant_text(expr));
        case ExprKind::since:
        case ExprKind::since_entry:
            return CppExpr(fmt::format("Nat({})", clock_member(clock_of(*unit_.machine, expr))));
        case ExprKind::negate:
            return write_negation(expr);
        case ExprKind::logical_not:
            return negation(cpp_expression(*expr.args[0]));
        case ExprKind::iff:
            return {fmt::format("{} == {}", write_operand(*expr.args[0]), write_operand(*expr.args[1])),
                    Binding::equality};
        case ExprKind::implies:
            return disjunction(negation(cpp_expression(*expr.args[0])), cpp_expression(*expr.args[1]), Binding::prefix);
        case ExprKind::disjunction:
            return disjunction(cpp_expression(*expr.args[0]), cpp_expression(*expr.args[1]), Binding::primary);
        case ExprKind::conjunction:
            return conjunction(cpp_expression(*expr.args[0]), cpp_expression(*expr.args[1]), Binding::primary);
        case ExprKind::equal:
            return write_comparison(expr, "==", Binding::equality);
        case ExprKind::not_equal:
            return write_comparison(expr, "!=", Binding::equality);
        case ExprKind::greater:
            return write_comparison(expr, ">", Binding::order);
        case ExprKind::greater_equal:
            return write_comparison(expr, ">=", Binding::order);
        case ExprKind::less:
            return write_comparison(expr, "<", Binding::order);
        case ExprKind::less_equal:
            return write_comparison(expr, "<=", Binding::order);
        case ExprKind::plus:
            return write_arithmetic(expr, "+", "plus", Binding::sum);
        case ExprKind::minus:
            return write_arithmetic(expr, "-", "minus", Binding::sum);
        case ExprKind::times:
            return write_arithmetic(expr, "*", "times", Binding::product);
        case ExprKind::divide:
            return CppExpr(write_function(expr, "divide"));
        case ExprKind::modulus:
            return CppExpr(write_function(expr, "modulus"));
        case ExprKind::if_then_else:
            return {fmt::format("{} ? {} : {}", write_operand(*expr.args[0]), write_as(*expr.args[1], expr.type),
                                write_as(*expr.args[2], expr.type)),
                    Binding::conditional};
        case ExprKind::cast:
            return CppExpr(write_cast(expr));
        case ExprKind::tuple:
        case ExprKind::record:
            return CppExpr(built_value(expr, "make"));
        case ExprKind::sequence:
        case ExprKind::set:
        case ExprKind::matrix:
            return CppExpr(built_value(expr, "of"));
        case ExprKind::member:
            return CppExpr(write_operand(*expr.args[0]) + "." +
                           member_name(generation_.system.type(expr.args[0]->type), expr.number));
        case ExprKind::index:
            return CppExpr(write_index(expr));
        case ExprKind::concat:
            return CppExpr(
                fmt::format("concat({}, {})", write_as(*expr.args[0], expr.type), write_as(*expr.args[1], expr.type)));
        case ExprKind::is_in:
            return CppExpr(write_membership(expr));
        case ExprKind::string:
            return CppExpr(fmt::format("{}::of({})", type_text(expr.type), diagnostics::cpp_string(expr.characters)));
        case ExprKind::set_range:
        case ExprKind::range:
            return CppExpr(write_range(expr));
        case ExprKind::forall:
        case ExprKind::exists:
        case ExprKind::exists_unique:
            return write_quantifier(expr);
        case ExprKind::lambda:
        case ExprKind::the:
        case ExprKind::set_comprehension:
            return CppExpr(write_collection(expr));
        case ExprKind::apply:
            return CppExpr(write_application(expr));
        case ExprKind::function_value:
            return CppExpr(function_value(expr));
        case ExprKind::toolkit:
            return CppExpr(write_toolkit_call(expr));
        case ExprKind::is_type:
            return CppExpr(is_type(expr));
        case ExprKind::transpose:
            return CppExpr(fmt::format("robochart::transposed<{}>({})", type_text(expr.type), write(*expr.args[0])));
        case ExprKind::call:
            return CppExpr(write_call(expr));
        case ExprKind::bound:
            return CppExpr(bound_identifier(expr.text));
        case ExprKind::let:
            return CppExpr(write_let(expr));
    }
    return {};
}

}  // namespace robochart::cpp_emit
