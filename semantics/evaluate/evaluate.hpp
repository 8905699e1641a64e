// SPDX-License-Identifier: Apache-2.0
// The value of an expression over finite carriers. This is the reference for arithmetic: csp_emit's functions and
// cpp_emit's code must agree with it (their tests compare).
//
// Numbers (semantics 3.13):
// * nat and int are whole numbers. A real is stored as the whole number scale * value (Instantiation::scale).
// * Literals, constants and variables keep their values. `cast` changes the unit: nat or int to real multiplies by the
//   scale; real to nat or int divides by it and rounds down.
// * plus, minus, times, divide, modulus and negate are RoboTool's Plus .. Neg: the exact result if it is in the carrier
//   of the expression's type, otherwise the unchanged *first operand* (clipping).
// * Integer divide and modulus are CSPM's `/` and `%`: the quotient is rounded down, and the remainder has the
//   divisor's sign (the FDR manual fixes this for positive divisors).
// * Reals: times is left*right/scale, divide is left*scale/right. The exact product is formed first; the result is then
//   rounded down to a whole unit and clipped as above. With scale 1 this is RoboTool's treatment of reals as integers;
//   for this reason, rounding is downwards and not towards zero.
// * Division by zero has no value: RoboTool's Div stops FDR with an error, so it is a fault here.
// * A call of a function that the model specifies only by contract is the default of its result type (RoboTool's
//   default).
// * Comparisons, equality and since() never clip.
//
// Composed values: tuples, records, sequences and vectors have one part per component. Matrices have one part per row,
// which is a vector. Sets have their members in ascending order; functions and relations have their pairs (two-part
// tuples) in ascending order.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "semantics/evaluate/environment.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// The value of an expression. `machine` finds the clock of sinceEntry; it may be null if the expression has none.
/// Throws EvaluationFault; quantifiers over types without a small carrier throw std::length_error.
[[nodiscard]] Value evaluate_expression(const System&, const Instantiation&, const Machine* machine, const Environment&,
                                        const Expr&);

/// A decimal in units of 1/scale, rounded down if the scale has too few digits; no value if it does not fit into 64
/// bits.
[[nodiscard]] std::optional<std::int64_t> scale_decimal(const Decimal&, std::int64_t scale);

}  // namespace robochart::ir
