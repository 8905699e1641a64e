// SPDX-License-Identifier: Apache-2.0
// Tests arithmetic and expressions (semantics 3.13; FDR2 manual A.1.2 for `/` and `%`).
#include "semantics/evaluate/evaluate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/semantics/expressions.hpp"

namespace robochart::ir {
namespace {

using namespace samples;

class Evaluate : public ::testing::Test {
protected:
    Evaluate() {
        inst_.nat = {0, 1, 2};
        inst_.integer = {-2, -1, 0, 1, 2};
        inst_.real = {-20, -10, -7, 0, 1, 2, 10, 20};  // scale 10: whole -2..2 and -0.7, 0.1, 0.2
        inst_.scale = 10;
    }
    Value value(const ExprPtr& expr) { return evaluate_expression(system_, inst_, nullptr, environment_, *expr); }
    std::int64_t number(const ExprPtr& expr) { return value(expr).number; }
    std::int64_t number(ExprKind kind, TypeId type, ExprPtr a, ExprPtr b) {
        return number(make(kind, type, {std::move(a), std::move(b)}));
    }

    System system_ = core_system();
    Instantiation inst_;
    Environment environment_;
};

TEST_F(Evaluate, PlusInsideTheCarrierAddsAndOutsideLeavesTheFirstOperand) {
    EXPECT_EQ(number(ExprKind::plus, types.nat, nat(1), nat(1)), 2);
    EXPECT_EQ(number(ExprKind::plus, types.nat, nat(2), nat(1)), 2);
    EXPECT_EQ(number(ExprKind::plus, types.nat, nat(1), nat(2)), 1);
    EXPECT_EQ(number(ExprKind::minus, types.integer, integer(-2), integer(1)), -2);
    EXPECT_EQ(number(ExprKind::times, types.integer, integer(2), integer(2)), 2);
}

TEST_F(Evaluate, NegateIsClippedToo) {
    EXPECT_EQ(number(make(ExprKind::negate, types.integer, {nat(2)})), -2);
    inst_.integer = {-2, -1, 0, 1, 2, 3, 4, 5};
    EXPECT_EQ(number(make(ExprKind::negate, types.integer, {nat(5)})), 5);
}

TEST_F(Evaluate, ResultsBeyond64BitsLeaveTheFirstOperand) {
    const auto big = std::numeric_limits<std::int64_t>::max();
    EXPECT_EQ(number(ExprKind::plus, types.integer, integer(big), integer(1)), big);
    EXPECT_EQ(number(ExprKind::times, types.integer, integer(big), integer(big)), big);
    EXPECT_EQ(number(make(ExprKind::negate, types.integer, {integer(std::numeric_limits<std::int64_t>::min())})),
              std::numeric_limits<std::int64_t>::min());
}

TEST_F(Evaluate, IntegerDivisionRoundsDownAndTheRemainderHasTheDivisorsSign) {
    inst_.integer = {-4, -3, -2, -1, 0, 1, 2, 3, 4, 7};
    const auto div = [&](std::int64_t a, std::int64_t b) {
        return number(ExprKind::divide, types.integer, integer(a), integer(b));
    };
    const auto mod = [&](std::int64_t a, std::int64_t b) {
        return number(ExprKind::modulus, types.integer, integer(a), integer(b));
    };
    EXPECT_EQ(div(7, 2), 3);
    EXPECT_EQ(div(-7, 2), -4);
    EXPECT_EQ(div(7, -2), -4);
    EXPECT_EQ(div(-7, -2), 3);
    EXPECT_EQ(mod(7, 2), 1);
    EXPECT_EQ(mod(-7, 2), 1);
    EXPECT_EQ(mod(7, -2), -1);
    for (const std::int64_t m : {-4, -3, 3, 4})
        for (const std::int64_t n : {1, 2, 3}) EXPECT_EQ(m, n * div(m, n) + mod(m, n)) << m << " " << n;
}

TEST_F(Evaluate, DivisionByZeroIsAFault) {
    EXPECT_THROW(number(ExprKind::divide, types.integer, integer(1), integer(0)), EvaluationFault);
    EXPECT_THROW(number(ExprKind::modulus, types.integer, integer(1), integer(0)), EvaluationFault);
    EXPECT_THROW(number(ExprKind::divide, types.real, decimal(1, 0), decimal(0, 0)), EvaluationFault);
}

TEST_F(Evaluate, RealsAreUnitsOfTheScale) {
    EXPECT_EQ(number(decimal(-7, 1)), -7);
    EXPECT_EQ(number(decimal(2, 0)), 20);
    EXPECT_EQ(number(ExprKind::plus, types.real, decimal(1, 1), decimal(1, 1)), 2);     // 0.1 + 0.1 = 0.2
    EXPECT_EQ(number(ExprKind::plus, types.real, decimal(2, 1), decimal(1, 1)), 2);     // not 0.3, so 0.2
    EXPECT_EQ(number(ExprKind::times, types.real, decimal(2, 0), decimal(1, 1)), 2);    // 2 * 0.1
    EXPECT_EQ(number(ExprKind::divide, types.real, decimal(2, 1), decimal(2, 0)), 1);   // 0.2 / 2
    EXPECT_EQ(number(ExprKind::divide, types.real, decimal(2, 0), decimal(1, 0)), 20);  // 2 / 1
}

TEST_F(Evaluate, RealResultsRoundDownToAUnit) {
    // 0.1 * 0.2 = 0.02 is rounded down to 0. -0.7 * 0.1 = -0.07 is rounded down to -0.1, which is not in the carrier,
    // so the result is -0.7.
    EXPECT_EQ(number(ExprKind::times, types.real, decimal(1, 1), decimal(2, 1)), 0);
    EXPECT_EQ(number(ExprKind::times, types.real, decimal(-7, 1), decimal(1, 1)), -7);
    inst_.real.insert(inst_.real.begin() + 3, -1);
    EXPECT_EQ(number(ExprKind::times, types.real, decimal(-7, 1), decimal(1, 1)), -1);
}

/// Returns the greatest q with q * divisor <= dividend (divisor > 0), found by search. This oracle shares no code with
/// the implementation.
std::int64_t greatest_below(std::int64_t dividend, std::int64_t divisor) {
    std::int64_t q = 0;
    while (q * divisor > dividend) --q;
    while ((q + 1) * divisor <= dividend) ++q;
    return q;
}

TEST_F(Evaluate, EveryProductAndQuotientOfTheCarrierIsRoundedDownThenClipped) {
    const auto clipped = [&](std::int64_t result, std::int64_t first) {
        return std::ranges::count(inst_.real, result) > 0 ? result : first;
    };
    for (const auto a : inst_.real)
        for (const auto b : inst_.real) {
            const auto left = decimal(a, 1);
            const auto right = decimal(b, 1);
            EXPECT_EQ(number(ExprKind::times, types.real, left, right), clipped(greatest_below(a * b, 10), a))
                << a << b;
            if (b == 0) continue;
            const std::int64_t sign = b < 0 ? -1 : 1;
            EXPECT_EQ(number(ExprKind::divide, types.real, left, right),
                      clipped(greatest_below(a * 10 * sign, b * sign), a))
                << a << " " << b;
        }
}

TEST_F(Evaluate, WithScaleOneRealsDivideAsRoboToolsIntegers) {
    inst_.scale = 1;
    inst_.real = {-2, -1, 0, 1, 2};
    EXPECT_EQ(number(ExprKind::divide, types.real, decimal(-1, 0), decimal(2, 0)), -1);
    EXPECT_EQ(number(ExprKind::divide, types.real, decimal(1, 0), decimal(2, 0)), 0);
}

TEST_F(Evaluate, CastsChangeTheUnit) {
    EXPECT_EQ(number(make(ExprKind::cast, types.real, {nat(2)})), 20);
    EXPECT_EQ(number(make(ExprKind::cast, types.integer, {decimal(-7, 1)})), -1);
    EXPECT_EQ(number(make(ExprKind::cast, types.integer, {nat(2)})), 2);
    EXPECT_THROW(number(make(ExprKind::cast, types.real, {integer(std::numeric_limits<std::int64_t>::max())})),
                 EvaluationFault);
}

TEST_F(Evaluate, NamesComeFromTheEnvironment) {
    environment_.variables = {{2, {}}};
    environment_.constants = {{1, {}}};
    environment_.clocks = {7};
    EXPECT_EQ(number(samples::variable(0, types.nat)), 2);
    EXPECT_EQ(number(samples::constant(0, types.nat)), 1);
    EXPECT_EQ(number(since(0)), 7);
    EXPECT_THROW(number(samples::variable(1, types.nat)), EvaluationFault);
    const auto trigger = make(ExprKind::trigger_value, types.nat, {});
    EXPECT_THROW(number(trigger), EvaluationFault);
    environment_.trigger = Value{1, {}};
    EXPECT_EQ(number(trigger), 1);
}

TEST_F(Evaluate, LogicIsLazy) {
    const auto fault = make(ExprKind::equal, types.boolean,
                            {make(ExprKind::divide, types.integer, {integer(1), integer(0)}), integer(1)});
    EXPECT_EQ(number(ExprKind::conjunction, types.boolean, truth(false), fault), 0);
    EXPECT_EQ(number(ExprKind::disjunction, types.boolean, truth(true), fault), 1);
    EXPECT_EQ(number(ExprKind::implies, types.boolean, truth(false), fault), 1);
    EXPECT_THROW(number(ExprKind::conjunction, types.boolean, truth(true), fault), EvaluationFault);
    EXPECT_EQ(number(ExprKind::iff, types.boolean, truth(false), truth(false)), 1);
    EXPECT_EQ(number(make(ExprKind::logical_not, types.boolean, {truth(false)})), 1);
}

TEST_F(Evaluate, Comparisons) {
    EXPECT_EQ(number(ExprKind::less, types.boolean, integer(-1), integer(1)), 1);
    EXPECT_EQ(number(ExprKind::greater_equal, types.boolean, nat(1), nat(1)), 1);
    EXPECT_EQ(number(ExprKind::not_equal, types.boolean, nat(1), nat(1)), 0);
    EXPECT_EQ(number(make(ExprKind::if_then_else, types.nat, {truth(false), nat(1), nat(2)})), 2);
}

TEST_F(Evaluate, SequencesSetsAndTuples) {
    const auto sequence = make(ExprKind::sequence, {}, {nat(2), nat(1)});
    EXPECT_EQ(number(make(ExprKind::index, types.nat, {sequence, nat(1)})), 2);
    EXPECT_THROW(number(make(ExprKind::index, types.nat, {sequence, nat(3)})), EvaluationFault);
    EXPECT_THROW(number(make(ExprKind::index, types.nat, {sequence, nat(0)})), EvaluationFault);
    const auto set = make(ExprKind::set, {}, {nat(2), nat(1), nat(2)});
    EXPECT_EQ(value(set), (Value{0, {{1, {}}, {2, {}}}}));
    EXPECT_EQ(number(ExprKind::is_in, types.boolean, nat(2), set), 1);
    EXPECT_EQ(number(ExprKind::is_in, types.boolean, nat(0), set), 0);
    EXPECT_EQ(value(make(ExprKind::concat, {}, {sequence, sequence})).parts.size(), 4U);
    EXPECT_EQ(value(make(ExprKind::set_range, {}, {integer(-1), integer(1)})).parts.size(), 3U);
    EXPECT_THROW(value(make(ExprKind::set_range, {}, {integer(0), integer(std::numeric_limits<std::int64_t>::max())})),
                 EvaluationFault);
}

ExprPtr bound(const std::string& name, TypeId type) {
    Expr expr;
    expr.kind = ExprKind::bound;
    expr.type = type;
    expr.text = name;
    return std::make_shared<const Expr>(expr);
}

ExprPtr binder(ExprKind kind, TypeId type, std::vector<ExprPtr> args) {
    Expr expr;
    expr.kind = kind;
    expr.type = type;
    expr.args = std::move(args);
    expr.bound_names = {"x"};
    expr.bound_types = {types.nat};
    return std::make_shared<const Expr>(expr);
}

TEST_F(Evaluate, QuantifiersRangeOverTheCarrier) {
    const auto x = bound("x", types.nat);
    const auto below = [&](std::int64_t limit) { return make(ExprKind::less, types.boolean, {x, nat(limit)}); };
    EXPECT_EQ(number(binder(ExprKind::forall, types.boolean, {truth(true), below(3)})), 1);
    EXPECT_EQ(number(binder(ExprKind::forall, types.boolean, {truth(true), below(2)})), 0);
    EXPECT_EQ(number(binder(ExprKind::exists, types.boolean, {truth(true), below(1)})), 1);
    EXPECT_EQ(number(binder(ExprKind::exists_unique, types.boolean, {truth(true), below(2)})), 0);
    EXPECT_EQ(number(binder(ExprKind::the, types.nat, {below(1), x})), 0);
    EXPECT_THROW(number(binder(ExprKind::the, types.nat, {below(2), x})), EvaluationFault);
    EXPECT_EQ(value(binder(ExprKind::set_comprehension, {}, {below(2), x})), (Value{0, {{0, {}}, {1, {}}}}));
}

TEST_F(Evaluate, LetAndLambda) {
    const auto x = bound("x", types.nat);
    const auto next = make(ExprKind::plus, types.nat, {x, nat(1)});
    EXPECT_EQ(number(binder(ExprKind::let, types.nat, {nat(1), next})), 2);
    const auto function = binder(ExprKind::lambda, {}, {truth(true), next});
    EXPECT_EQ(number(make(ExprKind::apply, types.nat, {function, nat(1)})), 2);
    EXPECT_THROW(number(make(ExprKind::apply, types.nat, {function, nat(9)})), EvaluationFault);
}

}  // namespace
}  // namespace robochart::ir
