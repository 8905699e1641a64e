// SPDX-License-Identifier: Apache-2.0
// Makes a model finite: carriers of the basic types, values of constants, the scale of reals. Defaults follow
// RoboTool's generated instantiations.csp (semantics 3.13):
// * nat {0..2}, int {-2..2}, real {-2..2}, each widened to the least and greatest literal used with the type, and so
//   that int contains nat and real contains int. RoboTool uses every literal for every type. Here, by our
//   choice, a literal is used only for the type that its place requires (`x < 5` with x:real widens only real), and a
//   negated literal is one literal (-5). A literal widens no carrier if it is only used as a wait duration, a deadline
//   or an index, or in a comparison with since(). It is then a time or a position and not the value of a variable.
//   Values of constants that are used only as such times widen no carrier either.
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

/// The numbers in a carrier that neither an option nor a CSP block named Instantiations gives.
enum class Carriers {
    robotool,  ///< up to the least and the greatest literal
    beyond,    ///< also numbers on both sides of the numbers with which values are compared (compared.hpp)
};

/// Returns the instantiation. It starts with RoboTool's defaults, widens them by the model's literals and constants,
/// and then applies the user's options. Invalid options (unknown constant, empty range) are reported. The values of
/// `set` take precedence over the options.
[[nodiscard]] Instantiation instantiate_system(const System&, const InstantiationOptions&, diagnostics::Diagnostics&,
                                               Carriers = Carriers::beyond, const SetConstants& set = {});

/// True if an option's name for a constant, "NAME" or the end of "P::S::NAME", refers to a constant of the system.
[[nodiscard]] bool names_constant(const System&, const std::string& option);
/// Evaluates an expression without variables (literals, constants, arithmetic). Reals are in units of 1/scale.
/// Constants have the values of the machine outside of a controller (`const_P_S_c`). Returns no value if the expression
/// is not constant.
[[nodiscard]] std::optional<Value> evaluate_constant(const System&, const Instantiation&, const Machine*, const Expr&);
/// RoboSim: returns the length of the cycles of a machine, controller or module, in time units.
[[nodiscard]] std::int64_t cycle_of(const System&, const Instantiation&, const ComponentRef&);
/// Returns the values of a machine's constants by ConstantId. If the controller is null, the machine is not in a
/// controller. Otherwise `part` is its name in the controller (see constant_source in query.hpp). A constant without a
/// value has the default value of its type.
[[nodiscard]] std::vector<Value> constant_values(const System&, const Instantiation&, const Module*, const Controller*,
                                                 const std::string& part, const Machine&);
/// Returns the largest whole number with which a clock is compared, plus 1. This includes comparisons in operations
/// that the machine may call and that share the clock. The clock may saturate at this value without changing any
/// comparison. For an expression that is not constant, the greatest value of its type is used.
[[nodiscard]] std::int64_t clock_saturation(const System&, const Instantiation&, const Machine&, ClockId);

}  // namespace robochart::ir
