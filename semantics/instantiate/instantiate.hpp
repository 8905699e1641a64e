// Making a model finite: carriers of the basic types, values of constants, the scale of reals.
// Defaults follow RoboTool's generated instantiations.csp (semantics 3.13):
// * nat {0..2}, int {-2..2}, real {-2..2}, each widened to the least and greatest literal used with the type, and to
// hold
//   the type before it (nat in int in real). Choice of ours, where RoboTool counts every literal for every type: a
//   literal counts for the type its place asks for (`x < 5` with x:real widens real only), a negated literal is one
//   literal (-5), and literals that are only a wait duration, a deadline, compared with since() or an index do not
//   widen anything, because they are times and places and no variable's values; no more do values of constants that are
//   used as such times alone.
// * Literals in the values that assertions and options give to constants count, and those of postconditions, which
//   define functions; preconditions do not.
// * Strings are the empty one and those written in the model.
// * scale: the smallest power of ten that makes every decimal literal whole; 1 without decimal literals.
// * Constants without a value: 0, true, the first literal; undefined functions likewise.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// RoboTool's defaults, widened by the model's literals and constants, then the user's options.
/// Bad options (unknown constant, empty range) are reported.
[[nodiscard]] Instantiation instantiate(const System&, const InstantiationOptions&, diagnostics::Diagnostics&);

/// Whether an option's name for a constant, "NAME" or the end of "P::S::NAME", is one of the system.
[[nodiscard]] bool names_constant(const System&, const std::string& option);
/// Evaluates an expression without variables (literals, constants, arithmetic); reals in units of 1/scale.
/// The machine's constants are those of the machine on its own (`const_P_S_c`).
/// Returns nothing if it is not constant.
[[nodiscard]] std::optional<Value> evaluate_constant(const System&, const Instantiation&, const Machine*, const Expr&);
/// Values of a machine's constants by ConstantId, for the machine running as `part` of a controller of a module
/// (see constant_source in query.hpp; null: without that context). Constants of functions without definition get the
/// default of their type.
[[nodiscard]] std::vector<Value> constant_values(const System&, const Instantiation&, const Module*, const Controller*,
                                                 const std::string& part, const Machine&);
/// Largest whole number a clock is compared with in the machine, or in an operation it may call that shares the clock,
/// plus 1: where it may saturate without changing any comparison. What is compared with and not constant counts with
/// the greatest value of its type.
[[nodiscard]] std::int64_t clock_saturation(const System&, const Instantiation&, const Machine&, ClockId);

}  // namespace robochart::ir
