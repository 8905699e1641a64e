// SPDX-License-Identifier: Apache-2.0
// See weights.hpp.
#include "prism/assertions/process/weights.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "prism/assertions/experiments/encoding.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::probability {
namespace {

/// Limits the nesting of constants, which may be defined by each other.
constexpr unsigned most_constant_depth = 100;

Rational power_of_ten(std::uint32_t exponent) {
    return boost::multiprecision::pow(boost::multiprecision::cpp_int(10), exponent);
}

Rational floor_of(const Rational& value) {
    boost::multiprecision::cpp_int quotient;
    boost::multiprecision::cpp_int remainder;
    boost::multiprecision::divide_qr(boost::multiprecision::cpp_int(numerator(value)),
                                     boost::multiprecision::cpp_int(denominator(value)), quotient, remainder);
    if (remainder < 0) --quotient;
    return quotient;
}

Rational truth_number(bool value) {
    return value ? 1 : 0;
}

}  // namespace

std::vector<std::uint32_t> equivalent_branches(const ir::System& system, const csp_emit::Draw& draw) {
    const auto& transitions = system.machine(draw.machine).transitions;
    const ir::Transition& way = transitions[draw.transition.index];
    std::vector<std::uint32_t> result;
    for (std::uint32_t i = 0; i < transitions.size(); ++i) {
        const ir::Transition& other = transitions[i];
        const bool plain = !way.action && !other.action && way.resets.empty() && other.resets.empty();
        if (i == draw.transition.index || (plain && other.source == way.source && other.target == way.target))
            result.push_back(i);
    }
    return result;
}

Rational Weights::branch_probability(const csp_emit::Draw& draw, const Seat& seat, const ValueOf& value_of) const {
    const ir::Machine& machine = system_.machine(draw.machine);
    Rational result;
    for (const std::uint32_t branch : equivalent_branches(system_, draw)) {
        const ir::Transition& way = machine.transitions[branch];
        const Rational weight =
            way.probability ? expression_value({machine, seat, &draw, &value_of}, *way.probability) : Rational(1);
        if (weight < 0 || weight > 1)
            throw Wrong(fmt::format("the probability of {} is {}", ir::text_of(machine, way), weight.str()));
        result += weight;
    }
    return result;
}

Rational Weights::constant_value(const ir::Machine& machine, ir::ConstantId id, const Seat& seat) const {
    return constant_value({machine, seat, nullptr, nullptr}, id);
}

/// Returns the value of a constant. A value of the instantiation overrides the value in the model. It is in units of
/// the scale, which represents every decimal exactly.
Rational Weights::constant_value(const Scope& scope, ir::ConstantId id) const {
    const ir::Constant& declared = scope.machine.constants[id.index];
    std::string part = scope.seat.part;
    if (scope.seat.controller != nullptr && &scope.machine != scope.seat.machine)
        for (std::size_t i = 0; i < scope.seat.controller->definitions.size(); ++i)
            if (&system_.machine(scope.seat.controller->definitions[i]) == &scope.machine)
                part = scope.seat.controller->definition_names[i];
    const ir::ConstantSource source =
        ir::constant_source(system_, scope.seat.module, scope.seat.controller, part, scope.machine, id);
    const auto given = instantiation_.constants.find(source.name);
    if (given != instantiation_.constants.end()) {
        const bool real = system_.type(declared.type).kind == ir::TypeKind::real;
        return Rational(given->second.number) / (real ? instantiation_.scale : 1);
    }
    const ir::ExprPtr& defined = source.constant != nullptr ? source.constant->value : declared.value;
    if (!defined || scope.depth > most_constant_depth)
        throw Wrong(fmt::format("the constant {} has no value", declared.name));
    Scope inner = scope;
    ++inner.depth;
    return expression_value(inner, *defined);
}

Rational Weights::expression_value(const Scope& scope, const ir::Expr& expr) const {
    const auto arg = [&](std::size_t i) { return expression_value(scope, *expr.args[i]); };
    switch (expr.kind) {
        case ir::ExprKind::boolean:
        case ir::ExprKind::integer:
        case ir::ExprKind::enum_literal:
            return expr.number;
        case ir::ExprKind::real:
            return Rational(expr.decimal.unscaled) / power_of_ten(expr.decimal.decimals);
        case ir::ExprKind::constant:
            return constant_value(scope, expr.constant);
        case ir::ExprKind::variable: {
            if (scope.value_of == nullptr) break;
            const std::int64_t units = (*scope.value_of)(scope.draw->variables[expr.variable.index]);
            const bool real = system_.type(expr.type).kind == ir::TypeKind::real;
            return Rational(units) / (real ? instantiation_.scale : 1);
        }
        case ir::ExprKind::negate:
            return -arg(0);
        case ir::ExprKind::logical_not:
            return truth_number(arg(0) == 0);
        case ir::ExprKind::iff:
        case ir::ExprKind::equal:
            return truth_number(arg(0) == arg(1));
        case ir::ExprKind::not_equal:
            return truth_number(arg(0) != arg(1));
        case ir::ExprKind::implies:
            return truth_number(arg(0) == 0 || arg(1) != 0);
        case ir::ExprKind::disjunction:
            return truth_number(arg(0) != 0 || arg(1) != 0);
        case ir::ExprKind::conjunction:
            return truth_number(arg(0) != 0 && arg(1) != 0);
        case ir::ExprKind::greater:
            return truth_number(arg(0) > arg(1));
        case ir::ExprKind::greater_equal:
            return truth_number(arg(0) >= arg(1));
        case ir::ExprKind::less:
            return truth_number(arg(0) < arg(1));
        case ir::ExprKind::less_equal:
            return truth_number(arg(0) <= arg(1));
        case ir::ExprKind::plus:
            return arg(0) + arg(1);
        case ir::ExprKind::minus:
            return arg(0) - arg(1);
        case ir::ExprKind::times:
            return arg(0) * arg(1);
        case ir::ExprKind::divide: {
            const Rational divisor = arg(1);
            if (divisor == 0) throw Wrong("a probability divides by 0");
            // Numbers in probabilities are fractions: 1/3 is a third, even though 1 and 3 are whole numbers.
            return arg(0) / divisor;
        }
        case ir::ExprKind::if_then_else:
            return arg(0) != 0 ? arg(1) : arg(2);
        case ir::ExprKind::cast: {
            const bool rounds = system_.type(expr.type).kind != ir::TypeKind::real &&
                                system_.type(expr.args.front()->type).kind == ir::TypeKind::real;
            return rounds ? floor_of(arg(0)) : arg(0);
        }
        // clang-format off
        case ir::ExprKind::string: case ir::ExprKind::trigger_value: case ir::ExprKind::since: case ir::ExprKind::since_entry:
        case ir::ExprKind::modulus: case ir::ExprKind::call: case ir::ExprKind::function_value: case ir::ExprKind::apply:
        case ir::ExprKind::tuple: case ir::ExprKind::record: case ir::ExprKind::sequence: case ir::ExprKind::set:
        case ir::ExprKind::matrix: case ir::ExprKind::member: case ir::ExprKind::index: case ir::ExprKind::concat:
        case ir::ExprKind::is_in: case ir::ExprKind::set_range: case ir::ExprKind::bound: case ir::ExprKind::forall:
        case ir::ExprKind::exists: case ir::ExprKind::exists_unique: case ir::ExprKind::lambda: case ir::ExprKind::the:
        case ir::ExprKind::set_comprehension: case ir::ExprKind::let: case ir::ExprKind::toolkit: case ir::ExprKind::is_type:
        case ir::ExprKind::range: case ir::ExprKind::transpose:
            break;
    }
    // clang-format on
    throw Wrong(
        "a probability is an expression that is not computed exactly: numbers, variables, constants, "
        "arithmetic, comparisons and `if` are");
}

}  // namespace robochart::probability
