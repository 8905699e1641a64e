// SPDX-License-Identifier: Apache-2.0
// Writes expressions over values with parts: binders (over the carriers of the instantiation, semantics 3.13),
// functions and relations as values, the toolkit libraries, vectors and matrices.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "cpp_emit/expressions/expression.hpp"
#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/plan/views.hpp"
#include "semantics/evaluate/toolkit.hpp"

namespace robochart::cpp_emit {

using ir::ExprKind;
using ir::TypeKind;

/// Writes calls of `visit` for the values of the bound variables from index `from` on, until it returns true:
/// any_Nat([&](Nat bound_x) { ... }). A variable with a generator ranges over the elements of its collection.
std::string ExpressionWriter::write_any(const ir::Expr& expr, std::size_t from, const std::string& visit) const {
    assert(from <= expr.bound_names.size() && expr.bound_types.size() >= expr.bound_names.size());
    if (from == expr.bound_names.size()) return visit;
    const ir::TypeId type = expr.bound_types.at(from);
    const std::string inner = write_any(expr, from + 1, visit);
    const std::string body = from + 1 == expr.bound_names.size() ? inner : fmt::format("return {};", inner);
    const ir::Expr* const collection = generators(generation_.system, expr)[from].collection;
    const std::string source =
        collection == nullptr ? generation_.component.find_carrier(type).method : write_view(*collection) + ".any";
    return fmt::format("{}([&]([[maybe_unused]] const {}& {}) {{ {} }})", source, type_text(type),
                       bound_identifier(expr.bound_names[from]), body);
}

/// Writes the test whether the body holds for all, for some, or for exactly one of the values that satisfy the
/// predicate.
CppExpr ExpressionWriter::write_quantifier(const ir::Expr& expr) const {
    assert(expr.args.size() >= 2);
    const std::string body = write_operand(*expr.args[1]);
    const CppExpr predicate = predicate_of(expr);
    const std::string premise = predicate.empty() ? "" : predicate.as_operand() + " && ";
    if (expr.kind == ExprKind::forall)
        return negation(CppExpr(write_any(expr, 0, fmt::format("return {}!{};", premise, body))));
    if (expr.kind == ExprKind::exists) return CppExpr(write_any(expr, 0, fmt::format("return {}{};", premise, body)));
    return CppExpr(fmt::format("[&] {{ std::size_t found = 0; (void){}; return found == 1; }}()",
                               write_any(expr, 0, fmt::format("if ({}{}) ++found; return false;", premise, body))));
}

/// Returns the bound variables as one value of the type: the variable itself, or a tuple.
std::string ExpressionWriter::bound_values(const ir::Expr& expr, ir::TypeId type) const {
    std::string names;
    for (const std::string& name : expr.bound_names) names += (names.empty() ? "" : ", ") + bound_identifier(name);
    return expr.bound_names.size() == 1 ? names : fmt::format("{}::make({})", type_text(type), names);
}

std::string ExpressionWriter::collected_item(const ir::Expr& expr) const {
    const ir::Type& whole = generation_.system.type(expr.type);
    if (expr.kind == ExprKind::lambda)
        return fmt::format("{}::make({}, {})", cpp_pair(generation_.system, whole),
                           bound_values(expr, whole.args.at(0)), write_as(*expr.args[1], whole.args.at(1)));
    const ir::TypeId item = expr.kind == ExprKind::the ? expr.type : whole.args.at(0);
    return expr.args.size() > 1 && expr.args[1] ? write_as(*expr.args[1], item) : bound_values(expr, item);
}

/// Collects the value of the body for each value that satisfies the predicate. Used for lambdas as sets of pairs, for
/// comprehensions, and for `the`.
std::string ExpressionWriter::write_collection(const ir::Expr& expr) const {
    const std::string item = collected_item(expr);
    const std::string take =
        expr.kind == ExprKind::the ? fmt::format("chosen = {};", item) : fmt::format("chosen.insert({});", item);
    const CppExpr predicate = predicate_of(expr);
    const std::string visit =
        fmt::format("if ({}) {{ {} }} return false;", predicate.empty() ? "true" : predicate.whole_text(), take);
    return fmt::format("[&] {{ {} chosen{{}}; (void){}; return chosen; }}()", type_text(expr.type),
                       write_any(expr, 0, visit));
}

std::string ExpressionWriter::write_application(const ir::Expr& expr) const {
    const ir::TypeId domain = generation_.system.type(expr.args[0]->type).args.at(0);
    const ir::Type& type = generation_.system.type(domain);
    assert(expr.args.size() >= 2);
    std::vector<std::string> arguments;
    const bool several = expr.args.size() > 2;
    for (std::size_t i = 1; i < expr.args.size(); ++i)
        arguments.push_back(write_as(*expr.args[i], several ? type.args.at(i - 1) : domain));
    return write_lookup(*expr.args[0], arguments, domain);
}

/// Looks up a value of a function. A function that is written as an expression is called directly, so that it need not
/// be finite on the robot.
std::string ExpressionWriter::write_lookup(const ir::Expr& function, const std::vector<std::string>& arguments,
                                           ir::TypeId domain) const {
    std::string listed;
    for (const std::string& argument : arguments) listed += (listed.empty() ? "" : ", ") + argument;
    const bool several = arguments.size() > 1;
    if (function.kind == ExprKind::lambda && function.bound_names.size() == arguments.size())
        return beta_reduced(function, arguments);
    const auto parameters = [&] { return generation_.system.functions[function.function.index].parameters.size(); };
    if (function.kind == ExprKind::function_value && parameters() == arguments.size())
        return platform_call(function.function, listed);
    if (function.kind == ExprKind::cast && type_text(function.args[0]->type) == type_text(function.type))
        return write_lookup(*function.args[0], arguments, domain);
    const std::string argument = several ? fmt::format("{}::make({})", type_text(domain), listed) : listed;
    const ir::TypeId result = generation_.system.type(function.type).args.at(1);
    if (function.kind == ExprKind::toolkit && function.text == "relation_toolkit_override" && !several)
        return fmt::format(
            "[&](const auto& argument, const auto& over) {{ "
            "return robochart::toolkit::in_domain(over, argument) ? robochart::apply<{}>(over, argument) : {}; }}({}, "
            "{})",
            type_text(result), write_lookup(*function.args[0], {"argument"}, domain), argument,
            write_as(*function.args[1], function.type));
    return fmt::format("robochart::apply<{}>({}, {})", type_text(result), write(function), argument);
}

/// Applies a lambda to arguments. Arguments that do not satisfy its predicate have no value in the model.
std::string ExpressionWriter::beta_reduced(const ir::Expr& lambda, const std::vector<std::string>& arguments) const {
    assert(lambda.bound_names.size() == arguments.size() && lambda.args.size() >= 2);
    std::string parameters, values;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const char* const comma = i == 0 ? "" : ", ";
        parameters += fmt::format("{}[[maybe_unused]] const {}& {}", comma, type_text(lambda.bound_types.at(i)),
                                  bound_identifier(lambda.bound_names[i]));
        values += comma + arguments[i];
    }
    const ir::TypeId result = generation_.system.type(lambda.type).args.at(1);
    return fmt::format("[&]({}) {{ return {}; }}({})", parameters, write_as(*lambda.args[1], result), values);
}

/// Returns a function of the model as the set of its pairs, restricted to its precondition.
std::string ExpressionWriter::function_value(const ir::Expr& expr) const {
    const ir::Type& whole = generation_.system.type(expr.type);
    const ir::TypeId domain = whole.args.at(0);
    const std::size_t parameters = generation_.system.functions[expr.function.index].parameters.size();
    std::string arguments = "argument";
    if (parameters > 1) {
        arguments.clear();
        for (const TypeMember& member : type_members(generation_.system.type(domain)))
            arguments += (arguments.empty() ? "argument." : ", argument.") + member.name;
    }
    const std::string& precondition = hook_of(expr.function).precondition;
    return fmt::format(
        "[&] {{ {0} pairs; (void){1}([&](const {2}& argument) {{ {5}pairs.insert({3}::make(argument, {4})); return "
        "false; }}); return pairs; }}()",
        type_text(expr.type), generation_.component.find_carrier(domain).method, type_text(domain),
        cpp_pair(generation_.system, whole), platform_call(expr.function, arguments),
        precondition.empty() ? "" : fmt::format("if ({}({})) ", precondition, arguments));
}

std::string ExpressionWriter::write_toolkit_call(const ir::Expr& expr) const {
    std::string name = expr.text.substr(expr.text.find("toolkit_") + std::string("toolkit_").size());
    if (name == "union") name += '_';
    std::string arguments;
    for (const ir::ExprPtr& argument : expr.args) arguments += (arguments.empty() ? "" : ", ") + write(*argument);
    for (const std::size_t place : ir::toolkit_carriers(expr.text))
        arguments += fmt::format("{}[&](auto visit) {{ return {}(visit); }}", arguments.empty() ? "" : ", ",
                                 generation_.component.find_carrier(expr.bound_types.at(place)).method);
    return fmt::format("robochart::toolkit::{}<{}>({})", name, type_text(expr.type), arguments);
}

/// Returns the whole numbers between the bounds, or the reals of the carrier between them.
std::string ExpressionWriter::write_range(const ir::Expr& expr) const {
    const ir::TypeId member = generation_.system.type(expr.type).args.at(0);
    const bool written = expr.kind == ExprKind::range;
    const bool open_low = written && (expr.number == 1 || expr.number == 3);
    const bool open_high = written && expr.number >= 2;
    const std::string low = write_as(*expr.args[0], member);
    const std::string high = write_as(*expr.args[1], member);
    if (generation_.system.type(member).kind != TypeKind::real)
        return fmt::format("robochart::whole_range<{}>({}, {}, {}, {})", type_text(expr.type), low, high,
                           open_low ? 1 : 0, open_high ? 1 : 0);
    return fmt::format(
        "[&] {{ const Real low = {}; const Real high = {}; {} chosen; (void){}([&](const Real& value) {{ "
        "if (low {} value && value {} high) chosen.insert(value); return false; }}); return chosen; }}()",
        low, high, type_text(expr.type), generation_.component.find_carrier(member).method,
        open_low ? "<" : "<=", open_high ? "<" : "<=");
}

/// Returns the test whether a number is a value of another numeric type.
std::string ExpressionWriter::is_type(const ir::Expr& expr) const {
    const ir::TypeId type = expr.bound_types.at(0);
    const bool natural = generation_.system.type(type).kind == TypeKind::nat;
    return fmt::format("robochart::is_value<{}, {}>({})", type_text(type), natural, write(*expr.args[0]));
}

bool ExpressionWriter::block_arithmetic(const ir::Expr& expr) const {
    return std::ranges::any_of(
        expr.args, [&](const ir::ExprPtr& arg) { return is_block_type(generation_.system.type(arg->type)); });
}

/// Returns a vector or matrix with entries of the type, or a number of that type.
std::string ExpressionWriter::block_operand(const ir::Expr& expr, ir::TypeId entry) const {
    const ir::Type& type = generation_.system.type(expr.type);
    if (!is_block_type(type)) return operand_as(expr, generation_.system.type(entry).kind);
    if (generation_.system.type(type.args.at(0)).kind == generation_.system.type(entry).kind)
        return write_operand(expr);
    std::string sizes;
    for (const std::int64_t size : type.sizes) sizes += fmt::format(", {}", size);
    return fmt::format("robochart::convert<robochart::{}<{}{}>>({})",
                       type.kind == TypeKind::vector ? "Vector" : "Matrix", type_text(entry), sizes, write(expr));
}

CppExpr ExpressionWriter::block_arithmetic_text(const ir::Expr& expr) const {
    const ir::Type& result = generation_.system.type(expr.type);
    assert(expr.args.size() == 2);
    const ir::TypeId entry = is_block_type(result) ? result.args.at(0) : expr.type;
    const std::string left = block_operand(*expr.args[0], entry);
    const std::string right = block_operand(*expr.args[1], entry);
    if (expr.kind != ExprKind::times)
        return {fmt::format("{} {} {}", left, expr.kind == ExprKind::plus ? "+" : "-", right), Binding::sum};
    const auto is_block = [&](std::size_t i) { return is_block_type(generation_.system.type(expr.args[i]->type)); };
    if (!is_block(0) || !is_block(1)) return {fmt::format("{} * {}", left, right), Binding::product};
    if (!is_block_type(result)) return CppExpr(fmt::format("robochart::dot({}, {})", left, right));
    return CppExpr(fmt::format("robochart::product<{}>({}, {})", type_text(expr.type), left, right));
}

}  // namespace robochart::cpp_emit
