// SPDX-License-Identifier: Apache-2.0
// Converts facts about machines to expressions of the script. Numbers are compared exactly. The script's values are
// whole numbers, and reals are multiples of 1 / scale. A fraction is represented by a whole number and its denominator.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "checker/cspm/syntax/build.hpp"
#include "claims/decide/letters.hpp"
#include "csp_emit/base/types.hpp"

namespace robochart::claims {
namespace {

namespace build = cspm::build;
using Kind = cspm::ExprKind;
using Tree = cspm::ExprPtr;

/// The number `above` / `below`.
struct Number {
    Tree above;
    std::int64_t below = 1;
};

std::int64_t product(std::int64_t one, std::int64_t other) {
    std::int64_t result = 0;
    if (__builtin_mul_overflow(one, other, &result)) throw NotDecided("a number of a condition is too large");
    return result;
}

Tree times(const Tree& number, std::int64_t factor) {
    return factor == 1 ? number : build::binary(Kind::times, number, build::number(factor));
}

class Translator {
public:
    Translator(const ir::System& system, std::int64_t scale, const csp_emit::MachineNames& names)
        : system_(system), scale_(scale), names_(names) {}

    [[nodiscard]] Tree truth(const Condition& condition) const {
        switch (condition.operand) {
            case Operand::none:
                return operator_of(condition);
            case Operand::constant:
                return value_of(condition);
            case Operand::variable:
            case Operand::of_model:
                return name_of(condition);
            case Operand::argument:
            case Operand::last:
            case Operand::fact:
                break;
        }
        throw NotDecided("a condition on variables reads the value of an event");
    }

private:
    [[nodiscard]] Tree name_of(const Condition& operand) const {
        const auto index = static_cast<std::uint32_t>(operand.index);
        return operand.operand == Operand::variable ? names_.variable(ir::VariableId{index})
                                                    : names_.constant(ir::ConstantId{index});
    }

    /// Returns a truth value or a literal as an expression.
    [[nodiscard]] Tree value_of(const Condition& constant) const {
        if (constant.type == ir::boolean_type) return build::boolean(constant.value != Fraction(0));
        return build::name(
            csp_emit::literal_name(system_.type(constant.type), static_cast<std::size_t>(constant.value.numerator())));
    }

    /// True if the condition is a number; false for truth values and literals.
    [[nodiscard]] bool is_number(const Condition& condition) const {
        if (condition.operand == Operand::none)
            return condition.op == Op::negate || condition.op == Op::add || condition.op == Op::subtract ||
                   condition.op == Op::multiply || condition.op == Op::modulus;
        if (!condition.type.is_valid()) return true;  // a number in the text
        const ir::TypeKind kind = system_.type(condition.type).kind;
        return kind == ir::TypeKind::nat || kind == ir::TypeKind::integer || kind == ir::TypeKind::real;
    }

    [[nodiscard]] Tree operator_of(const Condition& condition) const {
        const std::vector<Condition>& parts = condition.parts;
        const auto all = [&] {
            build::Exprs result;
            for (const Condition& part : parts) result.push_back(truth(part));
            return result;
        };
        switch (condition.op) {
            case Op::negation:
                return build::logical_not(truth(parts[0]));
            case Op::conjunction:
                return build::all_of(all());
            case Op::disjunction:
                return build::any_of(all());
            case Op::equal:
                return compare(Kind::equal, parts);
            case Op::unequal:
                return compare(Kind::not_equal, parts);
            case Op::less:
                return compare(Kind::less, parts);
            case Op::less_equal:
                return compare(Kind::less_equal, parts);
            case Op::greater:
                return compare(Kind::greater, parts);
            case Op::greater_equal:
                return compare(Kind::greater_equal, parts);
            case Op::number:
            case Op::truth:
            case Op::name:
            case Op::last:
            case Op::in_state:
            case Op::negate:
            case Op::add:
            case Op::subtract:
            case Op::multiply:
            case Op::modulus:
                break;
        }
        throw NotDecided("a part of a condition is no truth value");
    }

    [[nodiscard]] Tree compare(Kind kind, const std::vector<Condition>& parts) const {
        if (!is_number(parts[0])) return build::binary(kind, truth(parts[0]), truth(parts[1]));
        const Number left = number(parts[0]), right = number(parts[1]);
        const std::int64_t common = std::gcd(left.below, right.below);
        return build::binary(kind, times(left.above, right.below / common), times(right.above, left.below / common));
    }

    [[nodiscard]] Number number(const Condition& condition) const {
        switch (condition.operand) {
            case Operand::constant:
                return {build::number(condition.value.numerator()), condition.value.denominator()};
            case Operand::variable:
            case Operand::of_model: {
                const bool real = system_.type(condition.type).kind == ir::TypeKind::real;
                return {name_of(condition), real ? scale_ : 1};
            }
            case Operand::none:
                break;
            case Operand::argument:
            case Operand::last:
            case Operand::fact:
                throw NotDecided("a condition on variables reads the value of an event");
        }
        const Number left = number(condition.parts[0]);
        if (condition.op == Op::negate) return {build::binary(Kind::minus, build::number(0), left.above), left.below};
        const Number right = number(condition.parts[1]);
        if (condition.op == Op::multiply)
            return {build::binary(Kind::times, left.above, right.above), product(left.below, right.below)};
        if (condition.op == Op::modulus) return remainder(left, right, condition.parts[1]);
        const std::int64_t common = std::gcd(left.below, right.below);
        return {build::binary(condition.op == Op::add ? Kind::plus : Kind::minus,
                              times(left.above, right.below / common), times(right.above, left.below / common)),
                product(left.below, right.below / common)};
    }

    /// Returns the remainder, which is at least 0 even if the remainder in the script is negative.
    [[nodiscard]] static Number remainder(const Number& left, const Number& right, const Condition& divisor) {
        const bool positive = divisor.operand == Operand::constant && divisor.value > Fraction(0);
        if (left.below != 1 || right.below != 1 || !positive)
            throw NotDecided("`%` divides a whole number by a whole number above 0 that is written in the condition");
        const Tree once = build::binary(Kind::modulus, left.above, right.above);
        return {build::binary(Kind::modulus, build::binary(Kind::plus, once, right.above), right.above), 1};
    }

    const ir::System& system_;
    std::int64_t scale_;
    const csp_emit::MachineNames& names_;
};

}  // namespace

void add_facts(const CheckedClaim& claim, ShownFacts& shown) {
    for (const Fact& fact : claim.facts) {
        std::vector<Fact>& facts = shown[fact.machine];
        if (std::ranges::find(facts, fact) == facts.end()) facts.push_back(fact);
    }
}

void require_facts(const CheckedClaim& claim, const ir::System& system, const ir::Instantiation& instantiation) {
    const csp_emit::MachineNames names{[](ir::VariableId) { return build::name("v"); },
                                       [](ir::ConstantId) { return build::name("c"); }};
    for (const Fact& fact : claim.facts)
        if (!fact.state) (void)Translator(system, instantiation.scale, names).truth(fact.condition);
}

csp_emit::Shown emitted_facts(const ShownFacts& shown, const ir::System& system,
                              const ir::Instantiation& instantiation) {
    csp_emit::Shown result;
    for (const auto& [machine, facts] : shown)
        for (const Fact& fact : facts) {
            csp_emit::ShownFact& emitted = result[machine].emplace_back();
            emitted.state = fact.state;
            if (fact.state) continue;
            const std::int64_t scale = instantiation.scale;
            emitted.condition = [&system, scale, fact](const csp_emit::MachineNames& names) {
                return Translator(system, scale, names).truth(fact.condition);
            };
        }
    return result;
}

}  // namespace robochart::claims
