// SPDX-License-Identifier: Apache-2.0
// Finds the values that a component only passes on, and the numbers that it only compares.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// How a component uses numbers of a kind. The values are ordered by increasing dependence on the numbers.
enum class NumberUse {
    passed_on,  ///< it stores them, sends them and passes them to operations ("data independent": Lazić 1999; Roscoe
                ///< UCS 17.2)
    compared,   ///< it also compares them with literals and constants of the model, alone or as fields of records
    related,    ///< it also compares such numbers, and sums and differences of them, with each other
    computed,   ///< anything else: other operators, stored sums, indexes, waits
};

/// Values that the component only passes on or compares.
struct DataIndependence {
    NumberUse nat = NumberUse::passed_on;
    NumberUse integer = NumberUse::passed_on;
    NumberUse real = NumberUse::passed_on;
    bool inspects_lists = false;  ///< some operator depends on a list; otherwise lists are copied, sent and appended
    std::vector<ir::TypeId> looked_into;  ///< types with parts for which some operator depends on a value or its parts

    /// Returns how numbers of this kind are used; `computed` for types that are not numbers.
    [[nodiscard]] NumberUse use_of(ir::TypeKind) const;
    /// Returns whether the component only passes on numbers of this kind.
    [[nodiscard]] bool is_independent(ir::TypeKind kind) const { return use_of(kind) == NumberUse::passed_on; }
    /// Returns whether the component only passes on values of a composite type as a whole. Returns false for other
    /// types.
    [[nodiscard]] bool is_independent(const ir::System&, ir::TypeId) const;
};

/// A comparison of a number with a literal or constant. The number is the value of a variable or of a field of a
/// variable.
struct ConstantComparison {
    ir::TypeKind kind = ir::TypeKind::unit;  ///< type of the number
    const ir::Expr* constant = nullptr;      ///< a literal or constant, or its negation
    bool ordered = false;                    ///< the operator is neither == nor !=
};
/// Returns the expression as such a comparison, or no value if it is another expression.
[[nodiscard]] std::optional<ConstantComparison> constant_comparison(const ir::System&, const ir::Expr&);

/// A number that a sum adds or subtracts. It is the value of a variable or of a field of a variable, or it is a literal
/// or constant.
struct Summand {
    const ir::Expr* expr = nullptr;
    bool held = false;
    bool subtracted = false;
};
/// A comparison of two sums of numbers of one kind, added from left to right, such as `x < y` or `x - y > 0.5`.
struct SumComparison {
    ir::TypeKind kind = ir::TypeKind::unit;  ///< of the held numbers
    ir::ExprKind relation = ir::ExprKind::equal;
    std::vector<Summand> left, right;
};
/// Returns the expression as such a comparison. Returns no value if it is another expression, or a ConstantComparison.
/// A comparison that subtracts naturals is not such a comparison, because the result may not be a natural.
[[nodiscard]] std::optional<SumComparison> sum_comparison(const ir::System&, const ir::Expr&);

/// Analyses these machines and operations together. Ignores the comparisons in `decided`, whose answers do not depend
/// on numbers of the carriers.
[[nodiscard]] DataIndependence data_independence(const ir::System&, const std::vector<ir::MachineId>&,
                                                 const std::set<const ir::Expr*>& decided = {});

/// Returns whether the two types are the same. Declared types are compared by name, and other types by structure.
[[nodiscard]] bool same_type(const ir::System&, ir::TypeId, ir::TypeId);

}  // namespace robochart::conformance
