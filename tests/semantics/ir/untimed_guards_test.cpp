// SPDX-License-Identifier: Apache-2.0
// Tests that the untimed semantics weakens a condition: the result is true if the condition is true for some values of
// the clocks. So no run is lost. If each clock is read only once, the result is exact.
#include "semantics/ir/untimed_guards.hpp"

#include <gtest/gtest.h>

#include <array>

#include "base/diagnostics/splitmix64.hpp"

namespace robochart::ir {
namespace {

ExprPtr made(ExprKind kind, std::vector<ExprPtr> args) {
    Expr result;
    result.kind = kind;
    result.args = std::move(args);
    return std::make_shared<const Expr>(std::move(result));
}

ExprPtr variable(std::uint32_t number) {
    Expr result;
    result.kind = ExprKind::variable;
    result.variable = VariableId{number};
    return std::make_shared<const Expr>(std::move(result));
}

/// Returns since(C) >= 1 for the clock with this number.
ExprPtr late(std::uint32_t clock) {
    Expr since;
    since.kind = ExprKind::since;
    since.clock = ClockId{clock};
    Expr one;
    one.number = 1;
    return made(ExprKind::greater_equal,
                {std::make_shared<const Expr>(std::move(since)), std::make_shared<const Expr>(std::move(one))});
}

constexpr std::size_t variables = 2;
using Values = std::array<bool, variables>;

/// Returns the value of the expression. Bit n of `clocks` is the value of the comparison with clock n.
bool value(const ExprPtr& expr, const Values& values, std::uint32_t clocks) {
    const auto part = [&](std::size_t number) { return value(expr->args[number], values, clocks); };
    switch (expr->kind) {
        case ExprKind::boolean:
            return expr->number != 0;
        case ExprKind::variable:
            return values.at(expr->variable.index);
        case ExprKind::greater_equal:
            return ((clocks >> expr->args[0]->clock.index) & 1U) != 0;
        case ExprKind::logical_not:
            return !part(0);
        case ExprKind::conjunction:
            return part(0) && part(1);
        case ExprKind::disjunction:
            return part(0) || part(1);
        case ExprKind::implies:
            return !part(0) || part(1);
        case ExprKind::iff:
            return part(0) == part(1);
        case ExprKind::if_then_else:
            return part(0) ? part(1) : part(2);
        default:
            ADD_FAILURE() << static_cast<int>(expr->kind);
            return false;
    }
}

/// Draws random conditions in which each comparison reads a different clock.
class RandomConditions {
public:
    explicit RandomConditions(std::uint64_t seed) : random_(seed) {}

    ExprPtr condition(int depth) {
        if (depth == 0) return below(2) == 0 ? late(clocks_++) : variable(static_cast<std::uint32_t>(below(variables)));
        switch (below(6)) {
            case 0:
                return made(ExprKind::conjunction, {condition(depth - 1), condition(depth - 1)});
            case 1:
                return made(ExprKind::disjunction, {condition(depth - 1), condition(depth - 1)});
            case 2:
                return made(ExprKind::implies, {condition(depth - 1), condition(depth - 1)});
            case 3:
                return made(ExprKind::logical_not, {condition(depth - 1)});
            case 4:
                return made(ExprKind::if_then_else, {condition(0), condition(depth - 1), condition(depth - 1)});
            default:
                return made(ExprKind::iff, {condition(depth - 1), condition(depth - 1)});
        }
    }
    [[nodiscard]] std::uint32_t clocks() const { return clocks_; }

private:
    std::uint64_t below(std::uint64_t bound) { return diagnostics::splitmix64(random_) % bound; }
    std::uint64_t random_;
    std::uint32_t clocks_ = 0;
};

bool has(const ExprPtr& expr, ExprKind kind) {
    if (expr->kind == kind) return true;
    for (const ExprPtr& part : expr->args)
        if (has(part, kind)) return true;
    return false;
}

/// Returns true if the condition is true for some values of the clocks.
bool possible(const ExprPtr& condition, const Values& values, std::uint32_t clocks) {
    for (std::uint32_t clock_values = 0; clock_values < (1U << clocks); ++clock_values)
        if (value(condition, values, clock_values)) return true;
    return false;
}

TEST(UntimedGuards, KeepWhatIsTrueForSomeValuesOfTheClocks) {
    std::size_t exact = 0, open = 0;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        RandomConditions random(seed);
        const ExprPtr condition = random.condition(3);
        if (random.clocks() > 8) continue;
        const UntimedGuard guard = untimed_guard(condition);
        EXPECT_EQ(guard.left_open.empty(), random.clocks() == 0) << seed;
        for (const bool first : {false, true})
            for (const bool second : {false, true}) {
                const Values values{first, second};
                const bool untimed_value = !guard.kept || value(guard.kept, values, 0);
                const bool expected = possible(condition, values, random.clocks());
                EXPECT_TRUE(untimed_value || !expected) << "a run is lost: " << seed;
                if (has(condition, ExprKind::iff)) continue;
                EXPECT_EQ(untimed_value, expected) << seed;
                ++(untimed_value ? open : exact);
            }
    }
    EXPECT_GT(exact, 100U);
    EXPECT_GT(open, 100U);
}

TEST(UntimedGuards, DropOnlyTheComparisonsWithClocks) {
    const ExprPtr few = variable(0);
    const UntimedGuard both = untimed_guard(made(ExprKind::conjunction, {late(0), few}));
    EXPECT_EQ(both.kept, few);
    ASSERT_EQ(both.left_open.size(), 1U);
    EXPECT_EQ(both.left_open[0]->kind, ExprKind::greater_equal);
    EXPECT_EQ(untimed_guard(late(0)).kept, nullptr);
    EXPECT_EQ(untimed_guard(made(ExprKind::logical_not, {late(0)})).kept, nullptr);
    EXPECT_EQ(untimed_guard(made(ExprKind::disjunction, {late(0), few})).kept, nullptr);
    EXPECT_EQ(untimed_guard(few).kept, few);
    EXPECT_TRUE(untimed_guard(nullptr).left_open.empty());
}

/// `condition else` is next to `since(C) >= 1 /\ few`. Without time, either transition may be taken.
TEST(UntimedGuards, ANegatedConjunctionMayBeTrueWhateverIsKept) {
    const ExprPtr sibling = made(ExprKind::conjunction, {late(0), variable(0)});
    EXPECT_EQ(untimed_guard(made(ExprKind::logical_not, {sibling})).kept, nullptr);
    const ExprPtr either = made(ExprKind::disjunction, {late(0), variable(0)});
    const UntimedGuard otherwise = untimed_guard(made(ExprKind::logical_not, {either}));
    ASSERT_NE(otherwise.kept, nullptr);
    EXPECT_FALSE(value(otherwise.kept, {true, false}, 0));
    EXPECT_TRUE(value(otherwise.kept, {false, false}, 0));
}

}  // namespace
}  // namespace robochart::ir
