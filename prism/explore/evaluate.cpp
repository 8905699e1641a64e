// SPDX-License-Identifier: Apache-2.0
// Evaluates compiled expressions. See code.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "prism/explore/code.hpp"
#include "prism/explore/rules.hpp"

namespace robochart::prism {

void Code::fail(Root root, std::string what) const {
    throw EvaluationError(rules::arithmetic, spans_[root], {std::move(what)});
}

void Code::too_close(Root root, const Real& a, const Real& b) const {
    throw EvaluationError(rules::too_close, spans_[root],
                          {fmt::format("{} and {} are too close to be compared", a.text(), b.text())});
}

std::int64_t Code::check_range(std::int64_t value, Root root) const {
    constexpr std::int64_t least = std::numeric_limits<std::int32_t>::min();
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
    if (value < least || value > most) fail(root, fmt::format("the integer {} does not fit 32 bits", value));
    return value;
}

Value Code::value(Root root, StateValues state) const {
    const Type of = type(root);
    if (of == Type::real) return {of, 0, real(root, state)};
    return {of, integer(root, state), {}};
}

std::int64_t Code::integer(Root root, StateValues state) const {
    const Node& node = nodes_[root];
    using enum Operation;
    switch (node.op) {
        case constant:
            return node.value;
        case variable:
            return state[node.a];
        case conditional:
            return integer(integer(node.a, state) != 0 ? node.b : node.c, state);
        case implies:
            return integer(node.a, state) == 0 || integer(node.b, state) != 0 ? 1 : 0;
        case iff:
            return integer(node.a, state) == integer(node.b, state) ? 1 : 0;
        case disjunction:
            return integer(node.a, state) != 0 || integer(node.b, state) != 0 ? 1 : 0;
        case conjunction:
            return integer(node.a, state) != 0 && integer(node.b, state) != 0 ? 1 : 0;
        case negation:
            return integer(node.a, state) == 0 ? 1 : 0;
        case equal:
            return integer(node.a, state) == integer(node.b, state) ? 1 : 0;
        case unequal:
            return integer(node.a, state) != integer(node.b, state) ? 1 : 0;
        case less:
            return integer(node.a, state) < integer(node.b, state) ? 1 : 0;
        case less_equal:
            return integer(node.a, state) <= integer(node.b, state) ? 1 : 0;
        case greater:
            return integer(node.a, state) > integer(node.b, state) ? 1 : 0;
        case greater_equal:
            return integer(node.a, state) >= integer(node.b, state) ? 1 : 0;
        case variable_equal:
            return state[node.a] == node.value ? 1 : 0;
        case variable_unequal:
            return state[node.a] != node.value ? 1 : 0;
        case variable_less:
            return state[node.a] < node.value ? 1 : 0;
        case variable_less_equal:
            return state[node.a] <= node.value ? 1 : 0;
        case variable_greater:
            return state[node.a] > node.value ? 1 : 0;
        case variable_greater_equal:
            return state[node.a] >= node.value ? 1 : 0;
        case real_equal:
        case real_unequal:
        case real_less:
        case real_less_equal:
        case real_greater:
        case real_greater_equal:
            return compare_reals(node, root, state) ? 1 : 0;
        case floor:
        case ceil:
        case round:
            return round_real(node, root, state);
        // clang-format off
        case add: case subtract: case multiply: case divide: case power: case minus: case minimum: case maximum:
        case mod: case log:
            break;
    }
    // clang-format on
    return arithmetic(node, root, state);
}

bool Code::compare_reals(const Node& node, Root root, StateValues state) const {
    const Real a = real(node.a, state);
    const Real b = real(node.b, state);
    const std::optional<int> order = a.compare(b);
    if (!order) too_close(root, a, b);
    using enum Operation;
    switch (node.op) {
        case real_equal:
            return *order == 0;
        case real_unequal:
            return *order != 0;
        case real_less:
            return *order < 0;
        case real_less_equal:
            return *order <= 0;
        case real_greater:
            return *order > 0;
        default:
            return *order >= 0;
    }
}

std::int64_t Code::arithmetic(const Node& node, Root root, StateValues state) const {
    using enum Operation;
    if (node.op == minimum || node.op == maximum) {
        std::int64_t best = integer(lists_[node.a], state);
        for (std::uint32_t i = node.a + 1; i < node.b; ++i) {
            const std::int64_t next = integer(lists_[i], state);
            best = node.op == minimum ? std::min(best, next) : std::max(best, next);
        }
        return best;
    }
    const std::int64_t a = integer(node.a, state);
    if (node.op == minus) return check_range(-a, root);
    const std::int64_t b = integer(node.b, state);
    switch (node.op) {
        case add:
            return check_range(a + b, root);
        case subtract:
            return check_range(a - b, root);
        case multiply:
            return check_range(a * b, root);
        case mod:
            if (b <= 0) fail(root, fmt::format("mod({},{}): the divisor must be above 0", a, b));
            return ((a % b) + b) % b;
        default:
            return integral_power(a, b, root);
    }
}

std::int64_t Code::integral_power(std::int64_t base, std::int64_t exponent, Root root) const {
    if (exponent < 0)
        fail(root, fmt::format("pow({},{}): a power of integers has no negative exponent", base, exponent));
    if (base == 0 || base == 1) return exponent == 0 ? 1 : base;
    if (base == -1) return exponent % 2 == 0 ? 1 : -1;
    std::int64_t result = 1;
    for (std::int64_t i = 0; i < exponent; ++i) result = check_range(result * base, root);
    return result;
}

/// Rounds a real. Ties are rounded up: round(-1.5) is -1.
std::int64_t Code::round_real(const Node& node, Root root, StateValues state) const {
    Real operand = real(node.a, state);
    if (node.op == Operation::round) operand = operand + Real(Rational(1, 2));
    if (node.op == Operation::ceil) operand = Real(std::int64_t{0}) - operand;
    if (operand.is_infinite()) fail(root, operand.text() + " is not an integer");
    const std::optional<Rational> whole = floor_of(operand);
    if (!whole) too_close(root, operand, operand);
    const Rational result = node.op == Operation::ceil ? Rational(-*whole) : *whole;
    if (abs(result) > Rational(std::numeric_limits<std::int32_t>::max()) + 1)
        fail(root, fmt::format("the integer {} does not fit 32 bits", Real(result).text().substr(0, 40)));
    return check_range(result.convert_to<std::int64_t>(), root);
}

Real Code::real(Root root, StateValues state) const {
    const Node& node = nodes_[root];
    if (node.type != Type::real) return Real(integer(root, state));
    try {
        return compute_real(node, root, state);
    } catch (const Unclear& error) {
        throw EvaluationError(rules::too_close, spans_[root], {error.what()});
    } catch (const std::domain_error& error) {
        fail(root, error.what());
    }
}

Real Code::compute_real(const Node& node, Root root, StateValues state) const {
    using enum Operation;
    switch (node.op) {
        case constant:
            return reals_[node.a];
        case conditional:
            return real(integer(node.a, state) != 0 ? node.b : node.c, state);
        case add:
            return real(node.a, state) + real(node.b, state);
        case subtract:
            return real(node.a, state) - real(node.b, state);
        case multiply:
            return real(node.a, state) * real(node.b, state);
        case divide:
            return real(node.a, state) / real(node.b, state);
        case power:
            return prism::power(real(node.a, state), real(node.b, state));
        case minus:
            return Real(std::int64_t{0}) - real(node.a, state);
        case log:
            return logarithm(real(node.a, state), real(node.b, state));
        default:
            return extreme_of_list(node, root, state);
    }
}

Real Code::extreme_of_list(const Node& node, Root root, StateValues state) const {
    Real best = real(lists_[node.a], state);
    for (std::uint32_t i = node.a + 1; i < node.b; ++i) {
        const Real next = real(lists_[i], state);
        const std::optional<int> order = next.compare(best);
        if (!order) too_close(root, next, best);
        if (node.op == Operation::minimum ? *order < 0 : *order > 0) best = next;
    }
    return best;
}

}  // namespace robochart::prism
