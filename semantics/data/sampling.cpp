// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/sampling.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "semantics/data/inlining.hpp"
#include "semantics/evaluate/carrier.hpp"
#include "semantics/evaluate/evaluator.hpp"
#include "semantics/evaluate/preconditions.hpp"
#include "semantics/evaluate/toolkit.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/arithmetic.hpp"
#include "semantics/ir/query.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

/// How much finer the unit is than that of the model. Four more decimals are enough, because the means of corners have
/// divisors of at most 16 (linear.hpp).
constexpr std::int64_t finer = 10'000;

/// Returns the values of a machine's constants in every context in which it runs.
std::vector<std::vector<Value>> values_in_contexts(const System& system, const Instantiation& instantiation,
                                                   MachineId id) {
    const Machine& machine = system.machine(id);
    std::set<std::vector<Value>> found{constant_values(system, instantiation, nullptr, nullptr, "", machine)};
    const auto add_part = [&](const Module* module, const Controller& controller) {
        for (const MachineInstance& instance : controller.machines)
            if (instance.machine == id)
                found.insert(constant_values(system, instantiation, module, &controller, instance.name, machine));
        for (std::size_t i = 0; i < controller.definitions.size(); ++i)
            if (controller.definitions[i] == id)
                found.insert(constant_values(system, instantiation, module, &controller,
                                             controller.definition_names.at(i), machine));
    };
    for (const Controller& controller : system.controllers) add_part(nullptr, controller);
    for (const Module& module : system.modules)
        for (const ControllerInstance& instance : module.controllers)
            add_part(&module, system.controller(instance.controller));
    return {found.begin(), found.end()};
}

/// Returns true if the value depends on finite carriers. This can happen with quantifiers, functions of the model, and
/// some functions of the toolkits.
bool depends_on_carriers(const Expr& root) {
    bool result = false;
    visit_operands(root, [&](const Expr& expr) {
        result = result || binds_names(expr.kind) || expr.kind == ExprKind::call ||
                 expr.kind == ExprKind::function_value || expr.kind == ExprKind::apply ||
                 expr.kind == ExprKind::is_type ||
                 (expr.kind == ExprKind::toolkit && !toolkit_carriers(expr.text).empty());
    });
    return result;
}

}  // namespace

Sampling::Sampling(const System& system, const Instantiation& instantiation)
    : system_(system), finite_(instantiation), ideal_(instantiation) {
    ideal_.unbounded = true;
    if (const auto scale = checked_multiply(instantiation.scale, finer)) {
        ideal_.scale = *scale;
        factor_ = finer;
    }
    for (const NamedConstant& constant : named_constants(system)) {
        const auto found = ideal_.constants.find(constant.name);
        if (found != ideal_.constants.end()) found->second = rescaled(constant.type, found->second);
    }
    for (const Property& property : system.properties)
        for (const auto& [name, value] : property.constants) set_by_properties_.insert(name);
    for (std::uint32_t m = 0; m < system.machines.size(); ++m)
        constants_.push_back(values_in_contexts(system, ideal_, MachineId{m}));
}

/// Returns the value with reals in the finer unit. The recursion is as deep as the type.
Value Sampling::rescaled(TypeId id, const Value& value) const {
    const Type& type = system_.type(id);
    Value result = value;
    if (type.kind == TypeKind::real) result.number = checked_multiply(value.number, factor_).value_or(value.number);
    const bool literal = type.kind == TypeKind::enumeration;
    const bool nested =
        type.kind == TypeKind::matrix || type.kind == TypeKind::function || type.kind == TypeKind::relation;
    const std::vector<TypeId>& types =
        literal ? type.literal_args.at(static_cast<std::size_t>(value.number)) : type.args;
    const auto rescale_parts = [&](std::vector<Value>& parts) {
        for (std::size_t i = 0; i < parts.size(); ++i)
            parts[i] = rescaled(types.at(std::min(i, types.size() - 1)), parts[i]);
    };
    if (!nested)
        rescale_parts(result.parts);
    else
        for (Value& row : result.parts) rescale_parts(row.parts);
    return result;
}

bool Sampling::has_finite_constants(MachineId machine) const {
    const std::vector<Constant>& constants = system_.machine(machine).constants;
    std::vector<std::vector<Value>> finite = values_in_contexts(system_, finite_, machine);
    for (std::vector<Value>& values : finite)
        for (std::size_t c = 0; c < values.size(); ++c) values[c] = rescaled(constants.at(c).type, values[c]);
    std::ranges::sort(finite);
    std::vector<std::vector<Value>> ideal = constants_[machine.index];
    std::ranges::sort(ideal);
    return finite == ideal;
}

/// Returns true if a property may set a constant of this name to another value.
bool Sampling::is_set_by_property(MachineId machine, const Expr& root) const {
    bool result = false;
    visit_operands(root, [&](const Expr& expr) {
        if (expr.kind != ExprKind::constant) return;
        const std::string name = "_" + system_.machine(machine).constants.at(expr.constant.index).name;
        result = result ||
                 std::ranges::any_of(set_by_properties_, [&](const std::string& set) { return set.ends_with(name); });
    });
    return result;
}

std::optional<Value> Sampling::closed_value(MachineId machine, const Expr& expr) const {
    if (depends_on_state(expr) || depends_on_carriers(expr) || is_set_by_property(machine, expr)) return std::nullopt;
    std::optional<Value> result;
    for (const std::vector<Value>& constants : constants_[machine.index]) {
        const Environment environment{{}, constants, {}, {}};
        try {
            Evaluator evaluator(system_, ideal_, &system_.machine(machine), environment);
            if (!evaluator.is_defined(expr)) return std::nullopt;
            const Value value = evaluator.evaluate_value(expr);
            if (result && *result != value) return std::nullopt;
            result = value;
        } catch (const EvaluationFault&) {
            return std::nullopt;
        } catch (const std::length_error&) {
            return std::nullopt;
        }
    }
    return result;
}

Value value_at(const System& system, const Instantiation& instantiation, TypeId type,
               const std::vector<NumberPart>& components, const std::vector<std::int64_t>& numbers) {
    Value result = default_value(system, instantiation, type);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        Value* at = &result;
        for (const std::size_t part : components[i].path) at = &at->parts.at(part);
        at->number = numbers[i];
    }
    return result;
}

bool may_have_no_value(const Function& function) {
    return !function.preconditions.empty() || !function.postconditions.empty();
}

bool Sampling::may_be_undefined(MachineId machine, const ExprPtr& root) const {
    const auto is_natural = [this](const Expr& expr) { return system_.type(expr.type).kind == TypeKind::nat; };
    bool result = false;
    visit_operands(*inline_calls(system_, root), [&](const Expr& expr) {
        result = result || (expr.kind == ExprKind::cast && is_natural(expr) && !is_natural(*expr.args.at(0))) ||
                 (expr.kind == ExprKind::toolkit && toolkit_precondition(expr.text)) || expr.kind == ExprKind::apply ||
                 expr.kind == ExprKind::index || expr.kind == ExprKind::the ||
                 (expr.kind == ExprKind::call && expr.function.is_valid() &&
                  may_have_no_value(system_.functions.at(expr.function.index)));
        if (result || (expr.kind != ExprKind::divide && expr.kind != ExprKind::modulus)) return;
        const auto divisor = closed_value(machine, *expr.args.at(1));
        result = !divisor || divisor->number == 0;
    });
    return result;
}

std::optional<int> Sampling::truth(MachineId machine, const Expr& condition, const Value& value) const {
    if (is_set_by_property(machine, condition) || depends_on_carriers(condition)) return std::nullopt;
    std::optional<int> result;
    for (const std::vector<Value>& constants : constants_[machine.index]) {
        Environment environment{{}, constants, {}, value};
        environment.variables.assign(system_.machine(machine).variables.size(), value);
        int answer = -1;
        try {
            Evaluator evaluator(system_, ideal_, &system_.machine(machine), environment);
            if (evaluator.is_defined(condition)) answer = evaluator.evaluate_value(condition).number != 0 ? 1 : 0;
        } catch (const EvaluationFault&) {
            return std::nullopt;  // the checker will report this error
        }
        if (result && *result != answer) return std::nullopt;
        result = answer;
    }
    return result;
}

}  // namespace robochart::ir
