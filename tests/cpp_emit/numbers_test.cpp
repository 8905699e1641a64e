// SPDX-License-Identifier: Apache-2.0
// Compares the arithmetic of runtime/finite.hpp with the evaluator of the semantics, for all pairs of numbers of small
// carriers. Division in deployed code must round like the model's.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cpp_emit/runtime/finite.hpp"
#include "cpp_emit/runtime/runtime.hpp"
#include "semantics/evaluate/evaluate.hpp"
#include "tests/semantics/sample_systems/sample_systems.hpp"

namespace robochart::cpp_emit::numbers_test {
namespace {

struct TenthsCarrier {
    static constexpr std::int64_t scale = 10;
    static constexpr bool contains(std::int64_t value) { return value >= -25 && value <= 25 && value % 5 == 0; }
};
struct WholeCarrier {
    static constexpr std::int64_t scale = 1;
    static constexpr bool contains(std::int64_t value) { return value >= -3 && value <= 4; }
};
using Tenths = Finite<TenthsCarrier>;
using Whole = Finite<WholeCarrier>;

constexpr ir::samples::CoreTypes core{};

ir::Instantiation instantiation() {
    ir::Instantiation inst;
    inst.scale = TenthsCarrier::scale;
    for (std::int64_t value = -25; value <= 25; value += 5) inst.real.push_back(value);
    for (std::int64_t value = -3; value <= 4; ++value) inst.integer.push_back(value);
    return inst;
}

/// Returns the value of `left kind right` according to the semantics. Variables 0 and 1 contain the operands.
std::int64_t evaluate_semantics(ir::ExprKind kind, ir::TypeId type, std::int64_t left, std::int64_t right) {
    static const ir::System system = ir::samples::aggregation();
    const auto operand = [&](std::uint32_t index) {
        ir::Expr expr;
        expr.kind = ir::ExprKind::variable;
        expr.type = type;
        expr.variable = ir::VariableId{index};
        return std::make_shared<const ir::Expr>(expr);
    };
    ir::Expr expr;
    expr.kind = kind;
    expr.type = type;
    expr.args = {operand(0)};
    if (kind != ir::ExprKind::negate) expr.args.push_back(operand(1));
    ir::Environment environment;
    environment.variables = {{left, {}}, {right, {}}};
    return ir::evaluate_expression(system, instantiation(), nullptr, environment, expr).number;
}

template <class Number>
std::int64_t compute_number(ir::ExprKind kind, std::int64_t left, std::int64_t right) {
    const Number a = Number::from_raw(left);
    const Number b = Number::from_raw(right);
    switch (kind) {
        case ir::ExprKind::plus:
            return (a + b).raw();
        case ir::ExprKind::minus:
            return (a - b).raw();
        case ir::ExprKind::times:
            return (a * b).raw();
        case ir::ExprKind::divide:
            return divide(a, b).raw();
        case ir::ExprKind::modulus:
            return modulus(a, b).raw();
        default:
            return (-a).raw();
    }
}

template <class Number, class Carrier>
void compare_all(std::int64_t low, std::int64_t high, ir::TypeId type, std::initializer_list<ir::ExprKind> kinds) {
    for (const ir::ExprKind kind : kinds) {
        const bool divides = kind == ir::ExprKind::divide || kind == ir::ExprKind::modulus;
        for (std::int64_t left = low; left <= high; ++left) {
            for (std::int64_t right = low; right <= high; ++right) {
                if (!Carrier::contains(left) || !Carrier::contains(right) || (divides && right == 0)) continue;
                EXPECT_EQ(compute_number<Number>(kind, left, right), evaluate_semantics(kind, type, left, right))
                    << static_cast<int>(kind) << ": " << left << ", " << right;
            }
        }
    }
}

TEST(Numbers, RealsAgreeWithTheSemantics) {
    using enum ir::ExprKind;
    compare_all<Tenths, TenthsCarrier>(-25, 25, core.real, {plus, minus, times, divide, negate});
}

TEST(Numbers, WholeNumbersAgreeWithTheSemantics) {
    using enum ir::ExprKind;
    compare_all<Whole, WholeCarrier>(-3, 4, core.integer, {plus, minus, times, divide, modulus, negate});
}

TEST(Numbers, LiteralsAreExact) {
    EXPECT_EQ(Tenths(-2.5).raw(), -25);
    EXPECT_EQ(Tenths(0.5).raw(), 5);
    EXPECT_EQ(Tenths(2).raw(), 20);
    EXPECT_EQ(Finite<WholeCarrier>(-3).raw(), -3);
}

TEST(Numbers, ConversionsChangeTheUnitAndRoundDown) {
    EXPECT_EQ(Tenths(Whole(2)).raw(), 20);
    EXPECT_EQ(Whole(Tenths(2.5)).raw(), 2);
    EXPECT_EQ(Whole(Tenths(-2.5)).raw(), -3);
}

TEST(Numbers, DurationsAreNotNegative) {
    EXPECT_EQ(duration(Whole(3)), 3U);
    EXPECT_EQ(duration(Whole(-3)), 0U);
    EXPECT_EQ(duration(std::int64_t{-1}), 0U);
    EXPECT_EQ(duration(INT64_MAX), static_cast<std::uint32_t>(INT32_MAX));
}

/// Computes with 8 bits, so that all pairs of operands can be tested.
std::int8_t fit_result(int exact, std::int8_t first) {
    return exact >= INT8_MIN && exact <= INT8_MAX ? static_cast<std::int8_t>(exact) : first;
}

TEST(Numbers, AResultThatTheTypeDoesNotHaveIsTheFirstOperand) {
    for (int left = INT8_MIN; left <= INT8_MAX; ++left) {
        const auto a = static_cast<std::int8_t>(left);
        ASSERT_EQ(negative(a), fit_result(-left, a)) << left;
        for (int right = INT8_MIN; right <= INT8_MAX; ++right) {
            const auto b = static_cast<std::int8_t>(right);
            ASSERT_EQ(plus(a, b), fit_result(left + right, a)) << left << ", " << right;
            ASSERT_EQ(minus(a, b), fit_result(left - right, a)) << left << ", " << right;
            ASSERT_EQ(times(a, b), fit_result(left * right, a)) << left << ", " << right;
            if (right == 0) continue;
            const int quotient = static_cast<int>(std::floor(static_cast<double>(left) / right));
            ASSERT_EQ(divide(a, b), fit_result(quotient, a)) << left << ", " << right;
            ASSERT_EQ(modulus(a, b), left - quotient * right) << left << ", " << right;
        }
    }
}

TEST(Numbers, DeploymentIsDefinedAtItsLimits) {
    EXPECT_EQ(plus(INT64_MAX, std::int64_t{1}), INT64_MAX);
    EXPECT_EQ(minus(INT64_MIN, std::int64_t{1}), INT64_MIN);
    EXPECT_EQ(times(std::int64_t{1} << 62, std::int64_t{2}), std::int64_t{1} << 62);
    EXPECT_EQ(times(std::int64_t{-1} << 62, std::int64_t{2}), INT64_MIN);
    EXPECT_EQ(times(INT64_MIN, std::int64_t{-1}), INT64_MIN);
    EXPECT_EQ(times(std::int64_t{-1}, INT64_MIN), -1);
    EXPECT_EQ(negative(INT64_MIN), INT64_MIN);
    EXPECT_EQ(divide(INT64_MIN, std::int64_t{-1}), INT64_MIN);
    EXPECT_EQ(modulus(INT64_MIN, std::int64_t{-1}), 0);
    EXPECT_EQ(rounded_down<std::int64_t>(1e300), INT64_MAX);
    EXPECT_EQ(rounded_down<std::int64_t>(-std::numeric_limits<double>::infinity()), INT64_MIN);
    EXPECT_EQ(rounded_down<std::int64_t>(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(Numbers, DeploymentDividesLikeTheModel) {
    EXPECT_EQ(divide(std::int64_t{-7}, std::int64_t{2}), -4);  // rounded down, like CSPM's `/`
    EXPECT_EQ(modulus(std::int64_t{-7}, std::int64_t{2}), 1);
    EXPECT_EQ(modulus(std::int64_t{7}, std::int64_t{-2}), -1);
    EXPECT_EQ(divide(std::int64_t{5}, std::int64_t{0}), 5);
    EXPECT_DOUBLE_EQ(divide(1.0, 4.0), 0.25);
}

TEST(Clocks, StopAtTheirSaturation) {
    std::uint32_t clock = 3;
    advance_clock(clock, 1, 4);
    EXPECT_EQ(clock, 4U);
    advance_clock(clock, 2, 4);
    EXPECT_EQ(clock, 4U);
    std::uint32_t left = 3;
    advance_wait(left, 2);
    EXPECT_EQ(left, 1U);
    advance_wait(left, 2);
    EXPECT_EQ(left, 0U);
}

}  // namespace
}  // namespace robochart::cpp_emit::numbers_test
