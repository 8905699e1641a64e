// SPDX-License-Identifier: Apache-2.0
// Finds the collections that generated code visits in place instead of building them (runtime/views.hpp). A fold such
// as `min(ran(extract(W, s)))`, a membership test, or a quantifier over the elements of a sequence only needs the
// elements one by one. So these collections need no capacity. A bound variable that ranges over the elements of a
// collection needs no list of all values of its type.
#pragma once

#include <cstddef>
#include <vector>

#include "cpp_emit/plan/walk.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Returns whether the expression computes a sequence or set that code can visit without building it. False for stored
/// collections, because they need not be built.
[[nodiscard]] bool is_view(const ir::System&, const ir::Expr&);
/// Returns whether a view may contain the expression as a sequence or set with elements of this type. The expression
/// may be a view, or any other collection, which is built first.
[[nodiscard]] bool can_be_visited(const ir::System&, const ir::Expr&, ir::TypeId element);
/// Returns the sequence that the expression converts to the set of its pairs of place and item. Returns null for other
/// expressions.
[[nodiscard]] const ir::Expr* sequence_of_pairs(const ir::System&, const ir::Expr&);
/// Returns whether the operator is a fold and its operand with this index is a view, so that the code visits the
/// operand in place.
[[nodiscard]] bool folds(const ir::System&, const ir::Expr&, std::size_t operand);

/// The collection over whose elements a bound variable ranges, and the rest of the predicate.
struct Generator {
    const ir::Expr* collection = nullptr;  ///< null: the variable ranges over all values of its type
};
/// Returns the generators of the variables that the expression binds, by variable. A generator is a condition `x in
/// collection` that the predicate requires. The collection must have the same elements for all bound values, and its
/// elements must be values that the model stores. Every function in the predicate must be defined for all arguments,
/// because otherwise a precondition is tested for all values of the type. `exists unique` has no generators, because a
/// view may repeat elements.
[[nodiscard]] std::vector<Generator> generators(const ir::System&, const ir::Expr&);
/// Returns whether some variable that the expression binds has a generator.
[[nodiscard]] bool has_generator(const ir::System&, const ir::Expr&);
/// Returns whether code for this operator visits a collection in place.
[[nodiscard]] bool visits_in_place(const ir::System&, const ir::Expr&);
/// Returns the conditions of the predicate that are not generators, in order.
[[nodiscard]] std::vector<const ir::Expr*> conditions_besides_generators(const ir::System&, const ir::Expr&);

/// Visits the expression and its operands, except collections that are only visited in place.
void visit_values(const ir::System&, const ir::Expr&, const ExprVisitor&);

}  // namespace robochart::cpp_emit
