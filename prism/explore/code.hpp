// SPDX-License-Identifier: Apache-2.0
// Compiles expressions over states to code: a tree in an array, with resolved names and folded constants. Integers and
// booleans are evaluated as machine integers with a check for 32 bits, and doubles as real numbers (real.hpp).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "prism/explore/evaluation.hpp"

namespace robochart::prism {

/// Values of the variables, in the order of the model.
using StateValues = const std::int32_t*;

/// The code of many expressions; each is identified by its root.
class Code {
public:
    using Root = std::uint32_t;

    /// `variables` maps names to indices in a state; constants have values.
    Code(std::map<std::string, std::uint32_t, std::less<>> variables, std::vector<Type> types, Values constants);

    /// Compiles an expression. It must have been checked (checks/types.hpp) and contain no query, and its labels must
    /// have been replaced.
    Root compile(const ExprPtr& expr);
    /// Defines a name as a value, for expressions that are compiled later.
    void define(const std::string& name, Value value);

    [[nodiscard]] Type type(Root root) const { return nodes_[root].type; }
    [[nodiscard]] Span span(Root root) const { return spans_[root]; }
    [[nodiscard]] bool is_constant(Root root) const { return nodes_[root].op == Operation::constant; }
    /// Returns the variables that the code reads, ascending.
    [[nodiscard]] std::vector<std::uint32_t> variables(Root root) const;

    // This function and the next throw EvaluationError.
    [[nodiscard]] bool holds(Root root, StateValues state) const { return integer(root, state) != 0; }
    [[nodiscard]] std::int64_t integer(Root root, StateValues state) const;
    [[nodiscard]] Real real(Root root, StateValues state) const;
    [[nodiscard]] Value value(Root root, StateValues state) const;

private:
    enum class Operation : std::uint8_t {
        // clang-format off
        constant, variable, conditional, implies, iff, disjunction, conjunction, negation,
        equal, unequal, less, less_equal, greater, greater_equal,
        variable_equal, variable_unequal, variable_less, variable_less_equal, variable_greater, variable_greater_equal,
        real_equal, real_unequal, real_less, real_less_equal, real_greater, real_greater_equal,
        add, subtract, multiply, divide, power, minus, minimum, maximum, floor, ceil, round, mod, log,
        // clang-format on
    };
    struct Node {
        Operation op = Operation::constant;
        Type type = Type::integer;
        std::uint32_t a = 0, b = 0, c = 0;  ///< operands; for min and max indices into `lists_`; for a constant an
                                            ///< index into `reals_`
        std::int64_t value = 0;             ///< value of a constant; right side of a comparison
    };

    Root add(const Node& node, Span span);
    Root constant_node(const Value& value, Span span);
    Root compiled(const ExprPtr& expr);
    Root name(const Expr& expr);
    Root operation(const Expr& expr);
    Root call(const Expr& expr);
    Root comparison(const Expr& expr);
    Root fold_constants(Root root);
    [[nodiscard]] std::vector<Root> operands(const Node& node) const;
    [[nodiscard]] std::int64_t check_range(std::int64_t value, Root root) const;
    [[nodiscard]] bool compare_reals(const Node& node, Root root, StateValues state) const;
    [[nodiscard]] std::int64_t arithmetic(const Node& node, Root root, StateValues state) const;
    [[nodiscard]] std::int64_t integral_power(std::int64_t base, std::int64_t exponent, Root root) const;
    [[nodiscard]] std::int64_t round_real(const Node& node, Root root, StateValues state) const;
    [[nodiscard]] Real compute_real(const Node& node, Root root, StateValues state) const;
    [[nodiscard]] Real extreme_of_list(const Node& node, Root root, StateValues state) const;
    [[noreturn]] void fail(Root root, std::string what) const;
    [[noreturn]] void too_close(Root root, const Real& a, const Real& b) const;

    std::map<std::string, std::uint32_t, std::less<>> variables_;
    std::vector<Type> types_;
    Values constants_;
    std::vector<Node> nodes_;
    std::vector<Span> spans_;
    std::vector<std::uint32_t> lists_;
    std::vector<Real> reals_;
    std::unordered_map<const Expr*, Root> known_;  ///< the nodes of the expression that is being compiled
};

}  // namespace robochart::prism
