// SPDX-License-Identifier: Apache-2.0
// Computes the value of an expression over finite carriers. This is the reference for arithmetic: the functions that
// csp_emit writes and the code that cpp_emit writes must give the same results. Their tests check this.
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
// * The value of a function that the model does not define is the default value of the result type (as in RoboTool).
// * Comparisons, equality and since() never clip.
//
// Composed values: a tuple, record, sequence or vector has one part per component. A matrix has one part per row, which
// is a vector. The parts of a set are its members, and the parts of a function or relation are its pairs (two-part
// tuples), in ascending order.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "semantics/evaluate/environment.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Returns the value of an expression. `machine` has the clocks of sinceEntry; it may be null if the expression reads
/// none. Throws EvaluationFault, and std::length_error for a quantifier over a type with a large carrier.
[[nodiscard]] Value evaluate_expression(const System&, const Instantiation&, const Machine* machine, const Environment&,
                                        const Expr&);

/// Returns a decimal in units of 1/scale. Rounds down if the scale has too few digits. Returns no value if the result
/// exceeds 64 bits.
[[nodiscard]] std::optional<std::int64_t> scale_decimal(const Decimal&, std::int64_t scale);

}  // namespace robochart::ir
