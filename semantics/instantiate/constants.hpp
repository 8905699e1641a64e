// Values of constants: options, defaults, and expressions that are constant (private to this component).
#pragma once

#include <map>
#include <string>

#include "diagnostics/diagnostic.hpp"
#include "semantics/instantiate/given_constants.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/literals.hpp"

namespace robochart::ir {

/// Constants set by options: qualified name -> the literal as an expression.
using ChosenConstants = std::map<std::string, ExprPtr>;

/// Reads the options, reports wrong ones, among them two that name one constant, and adds the numbers they bring to the
/// literals.
[[nodiscard]] ChosenConstants chosen_constants(const System&, const GivenConstants& options, Literals&,
                                               diagnostics::Diagnostics&);
/// Fills Instantiation::constants from the options and the defaults; carriers and scale must be there.
void set_constants(const System&, const ChosenConstants&, Instantiation&);

}  // namespace robochart::ir
