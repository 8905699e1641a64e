// The value of an expression over finite carriers: the reference for arithmetic. csp_emit's functions and cpp_emit's
// code must agree with it (their tests compare).
//
// Numbers (semantics 3.13):
// * nat and int are whole numbers; a real is the whole number scale * value (Instantiation::scale).
// * Literals, constants and variables have the value they have. `cast` changes the unit: nat or int to real multiplies
//   by the scale, real to nat or int divides by it and rounds down.
// * plus, minus, times, divide, modulus and negate are RoboTool's Plus .. Neg: the exact result if it is in the carrier
// of
//   the expression's type, else the *first operand*, unchanged.
// * Integer divide and modulus are CSPM's `/` and `%`: rounded down, remainder with the divisor's sign (the FDR manual
//   fixes this for positive divisors).
// * Reals: times is left*right/scale, divide is left*scale/right, each rounded down to a whole unit after the exact
//   product is formed; then clipped as above. With scale 1 this is RoboTool's reading of reals as integers, which is
//   why rounding goes down and not towards zero.
// * Dividing by zero has no value: RoboTool's Div stops FDR with an error, so it is a fault here.
// * A call of a function that the model specifies by contract only is the default of its result type (RoboTool's
// default).
// * Comparisons, equality and since() never clip.
//
// Composed values: tuples, records, sequences and vectors have one part per component, matrices one part per row (a
// vector each), sets their members ascending, functions and relations their pairs (two-part tuples) ascending.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "semantics/evaluate/environment.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// The value of an expression. `machine` finds the clock of sinceEntry and may be null if there is none.
/// Throws EvaluationFault; std::length_error from quantifiers over types without a small carrier.
[[nodiscard]] Value evaluate(const System&, const Instantiation&, const Machine* machine, const Environment&,
                             const Expr&);

/// A decimal in units of 1/scale, rounded down where the scale does not reach its last place; nothing beyond 64 bits.
[[nodiscard]] std::optional<std::int64_t> scaled(const Decimal&, std::int64_t scale);

}  // namespace robochart::ir
