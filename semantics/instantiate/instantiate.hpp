// SPDX-License-Identifier: Apache-2.0
// Makes a model finite: carriers of the basic types, values of constants, the scale of reals. Defaults follow
// RoboTool's generated instantiations.csp (semantics 3.13):
// * nat {0..2}, int {-2..2}, real {-2..2}, each widened to the least and greatest literal used with the type, and to
//   contain the type before it (nat in int, int in real). RoboTool uses every literal for every type. Here, by our
//   choice, a literal is used only for the type that its place requires (`x < 5` with x:real widens only real), and a
//   negated literal is one literal (-5). A literal widens no carrier if it is only a wait duration, a deadline, an
//   index, or compared with since(), because it is then a time or a position and not the value of a variable. Values of
//   constants that are used only as such times widen no carrier either.
// * Literals in values that assertions and options give to constants are included. Literals in postconditions, which
//   define functions, are included; literals in preconditions are not.
// * The strings are the empty string and the strings in the model.
// * scale: the smallest power of ten that makes every decimal literal a whole number; 1 without decimal literals.
// * Constants without a value, and undefined functions: 0, true, the first literal.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "semantics/instantiate/given_constants.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Determines the numbers in those carriers that are given neither by an option nor by a CSP block named
/// Instantiations.
enum class Carriers {
    robotool,  ///< up to the least and the greatest literal
    beyond,    ///< also numbers on both sides of the numbers with which values are compared (compared.hpp)
};

/// Applies RoboTool's defaults, widens them by the model's literals and constants, and then applies the user's options.
/// Invalid options (unknown constant, empty range) are reported. The values of `set` take precedence over the options.
[[nodiscard]] Instantiation instantiate_system(const System&, const InstantiationOptions&, diagnostics::Diagnostics&,
                                               Carriers = Carriers::beyond, const SetConstants& set = {});

/// True if an option's name for a constant, "NAME" or the end of "P::S::NAME", refers to a constant of the system.
[[nodiscard]] bool names_constant(const System&, const std::string& option);
/// Evaluates an expression without variables (literals, constants, arithmetic); reals are in units of 1/scale.
/// Constants have the values of the machine on its own (`const_P_S_c`). Returns no value if the expression is not
/// constant.
[[nodiscard]] std::optional<Value> evaluate_constant(const System&, const Instantiation&, const Machine*, const Expr&);
/// RoboSim: the length of the cycles of a machine, controller or module, in time units.
[[nodiscard]] std::int64_t cycle_of(const System&, const Instantiation&, const ComponentRef&);
/// The values of a machine's constants by ConstantId. `part` names the machine in a controller of a module (see
/// constant_source in query.hpp); if it is null, the machine is not in a controller. Constants of functions without
/// definition have the default of their type.
[[nodiscard]] std::vector<Value> constant_values(const System&, const Instantiation&, const Module*, const Controller*,
                                                 const std::string& part, const Machine&);
/// The largest whole number with which a clock is compared, plus 1. This includes comparisons of operations that the
/// machine may call and that share the clock. The clock may saturate at this value without changing any comparison. For
/// an expression that is not constant, the greatest value of its type is used.
[[nodiscard]] std::int64_t clock_saturation(const System&, const Instantiation&, const Machine&, ClockId);

}  // namespace robochart::ir
