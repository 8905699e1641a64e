// SPDX-License-Identifier: Apache-2.0
// Seeds faults in expressions: rewrites an expression as a faulty generator would read it.
#pragma once

#include <map>

#include "cpp_emit/faults/mutation.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Returns a literal with the default value of a type, or null if no literal can express it.
[[nodiscard]] ir::ExprPtr default_literal(const ir::System&, const ir::Instantiation&, ir::TypeId);
/// Returns the number one as a literal of a numeric type.
[[nodiscard]] ir::ExprPtr one_literal(const ir::System&, ir::TypeId);
/// Returns the expression `expr` + 1. In a finite carrier the largest number stays unchanged (semantics 3.13), except
/// for a literal.
[[nodiscard]] ir::ExprPtr one_more(const ir::System&, const ir::ExprPtr& expr);
/// Returns the expression `expr` - 1, or 0 if that is negative. Returns null for the literal 0.
[[nodiscard]] ir::ExprPtr one_less(const ir::System&, const ir::ExprPtr& expr);
/// Returns the expression `not expr`.
[[nodiscard]] ir::ExprPtr negate_condition(const ir::ExprPtr& expr);

/// Rewrites the expressions of one machine. A subexpression that several expressions share is one place for a fault.
class ExpressionFaults {
public:
    ExpressionFaults(const ir::System& system, const ir::Instantiation& inst, Mutation& mutation)
        : system_(system), inst_(inst), mutation_(mutation) {}

    /// Returns the expression with the fault. Operands are rewritten before operators. Returns the same object if the
    /// fault is elsewhere, and null for null.
    [[nodiscard]] ir::ExprPtr rewrite(const ir::ExprPtr&);
    /// Rewrites the index of an item in the same way. The fault index_off_by_one can also change it.
    [[nodiscard]] ir::ExprPtr rewrite_place(const ir::ExprPtr&);

private:
    [[nodiscard]] std::vector<ir::ExprPtr> rewrite_operands(const ir::Expr&);
    [[nodiscard]] ir::ExprPtr rewrite_field(const ir::Expr& whole, std::size_t number, const ir::ExprPtr&);

    const ir::System& system_;
    const ir::Instantiation& inst_;
    Mutation& mutation_;
    std::map<const ir::Expr*, ir::ExprPtr> known_;  ///< never iterated
};

}  // namespace robochart::cpp_emit
