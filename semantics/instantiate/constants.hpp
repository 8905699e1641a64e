// SPDX-License-Identifier: Apache-2.0
// Determines the values of constants from options, defaults and constant expressions (private to this component).
#pragma once

#include <map>
#include <string>

#include "base/diagnostics/diagnostic.hpp"
#include "semantics/instantiate/given_constants.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/literals.hpp"

namespace robochart::ir {

/// Constants set by options and claims: qualified name -> the literal as an expression.
using ChosenConstants = std::map<std::string, ExprPtr>;

/// Reads the options, reports wrong ones (including two that name the same constant), and adds their numbers to the
/// literals.
[[nodiscard]] ChosenConstants chosen_constants(const System&, const GivenConstants& options, const SetConstants& set,
                                               Literals&, diagnostics::Diagnostics&);
/// Fills Instantiation::constants from the options and the defaults. Carriers and scale must be set before.
void set_constants(const System&, const ChosenConstants&, Instantiation&);
/// Reports RC-S19 if an operation requires a constant from several callers, and the callers have different values for
/// it.
void check_shared_constants(const System&, const Instantiation&, diagnostics::Diagnostics&);

}  // namespace robochart::ir
