// SPDX-License-Identifier: Apache-2.0
// Evaluates expressions that change or test the type of a value: casts, conversions, type tests.
#include <algorithm>

#include "semantics/evaluate/evaluate.hpp"
#include "semantics/evaluate/evaluate_composed.hpp"
#include "semantics/evaluate/evaluator.hpp"
#include "semantics/ir/arithmetic.hpp"

namespace robochart::ir {

namespace {

/// Returns the types of the parts of a value, one per part.
std::vector<TypeId> part_types(const System& system, const Type& type, std::size_t parts) {
    if (type.kind == TypeKind::product || type.kind == TypeKind::record) return type.args;
    if (type.kind != TypeKind::matrix) return std::vector<TypeId>(parts, type.args.at(0));
    for (std::uint32_t i = 0; i < system.types.size(); ++i)
        if (system.types[i].kind == TypeKind::vector && system.types[i].args == type.args &&
            system.types[i].sizes.at(0) == type.sizes.at(1))
            return std::vector<TypeId>(parts, TypeId{i});
    return {};
}

}  // namespace

/// Converts the value to another type: numbers to its unit, sequences to sets of pairs if the type consists of pairs.
Value Evaluator::convert_value(const Expr& expr, const Value& value, TypeId from, TypeId to) {
    if (from == to || !from.is_valid() || !to.is_valid()) return value;
    const Type& source = system_.type(from);
    const Type& target = system_.type(to);
    if (source.kind == TypeKind::sequence && is_set_like(target.kind))
        return converted_pairs(expr, pairs_of(value), {TypeId{}, source.args.at(0)}, target);
    if (is_set_like(source.kind) && is_set_like(target.kind)) return converted_set(expr, value, source, target);
    if (!value.parts.empty() && !target.args.empty()) return converted_parts(expr, value, source, target);
    const bool from_real = source.kind == TypeKind::real;
    const bool to_real = target.kind == TypeKind::real;
    if (from_real == to_real) return value;
    const auto result = to_real ? checked_multiply(value.number, instantiation_.scale)
                                : floor_divide(value.number, instantiation_.scale);
    if (!result) throw_fault(expr, "the number does not fit into 64 bits at this scale");
    return {*result, {}};
}

/// Returns the types of the two components of the pairs in a set, or an empty result if the elements are not pairs.
std::vector<TypeId> Evaluator::pair_types(const Type& type) {
    if (type.args.size() == 2) return type.args;
    const Type& element = system_.type(type.args.at(0));
    return element.kind == TypeKind::product && element.args.size() == 2 ? element.args : std::vector<TypeId>{};
}

Value Evaluator::converted_pairs(const Expr& expr, const Value& pairs, const std::vector<TypeId>& from,
                                 const Type& target) {
    const std::vector<TypeId> to = pair_types(target);
    if (to.size() != 2) throw_fault(expr, "no conversion to " + target.name);
    std::vector<Value> result;
    for (const Value& pair : pairs.parts)
        result.push_back({0,
                          {convert_value(expr, pair.parts.at(0), from[0].is_valid() ? from[0] : to[0], to[0]),
                           convert_value(expr, pair.parts.at(1), from[1], to[1])}});
    return set_of(std::move(result));
}

Value Evaluator::converted_set(const Expr& expr, const Value& value, const Type& source, const Type& target) {
    const std::vector<TypeId> from = pair_types(source);
    if (!from.empty() && !pair_types(target).empty()) return converted_pairs(expr, value, from, target);
    if (source.kind != TypeKind::set || target.kind != TypeKind::set) return value;
    std::vector<Value> result;
    for (const Value& part : value.parts)
        result.push_back(convert_value(expr, part, source.args.at(0), target.args.at(0)));
    return set_of(std::move(result));
}

Value Evaluator::converted_parts(const Expr& expr, const Value& value, const Type& source, const Type& target) {
    const auto from = part_types(system_, source, value.parts.size());
    const auto to = part_types(system_, target, value.parts.size());
    if (from.size() != value.parts.size() || to.size() != value.parts.size())
        throw_fault(expr, "no conversion from " + source.name + " to " + target.name);
    Value result = value;
    for (std::size_t i = 0; i < result.parts.size(); ++i)
        result.parts[i] = convert_value(expr, value.parts[i], from[i], to[i]);
    return result;
}

Value Evaluator::evaluate_cast(const Expr& expr) {
    return convert_value(expr, evaluate_operand(expr, 0), argument_at(expr, 0).type, expr.type);
}

bool Evaluator::has_type(const Value& value, TypeId from, TypeId to) {
    if (kind(from) == TypeKind::real && kind(to) != TypeKind::real) {
        const auto rest = floor_modulus(value.number, instantiation_.scale);
        const auto whole = floor_divide(value.number, instantiation_.scale);
        return rest == 0 && in_carrier(system_, instantiation_, to, {*whole, {}});
    }
    Expr nowhere;
    return in_carrier(system_, instantiation_, to, convert_value(nowhere, value, from, to));
}

}  // namespace robochart::ir
