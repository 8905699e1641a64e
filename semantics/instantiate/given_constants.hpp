// SPDX-License-Identifier: Apache-2.0
// Combines the values of constants from several sources. Those of the command line override those of a scenario, a
// swarm or a log.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Values of constants as in InstantiationOptions. The key is "NAME", a path "P::S::NAME" or the end of a path such as
/// "S::NAME"; the value is a RoboChart literal. A name refers to every constant whose path is equal to the name or ends
/// with it. Two names of one source must not refer to the same constant (RC-S24).
using GivenConstants = std::map<std::string, std::string>;

/// The constants that `with constant` of an assertion or a claim sets, as in Property::constants.
using SetConstants = std::vector<std::pair<std::string, ExprPtr>>;

/// A RoboChart literal of a type: `3`, `-0.5`, `true`, `Colour::red`. Null if the text is not one.
[[nodiscard]] ExprPtr parse_literal(const System&, TypeId, const std::string& text);

/// Returns the entries of `weaker` that `stronger` does not override. Different names of one constant are recognised.
/// If `stronger` overrides only some of the constants to which a name refers, the result contains the name, so that
/// both entries together are rejected (RC-S24). Otherwise the value would be ambiguous, because a constant passes its
/// value to the constants of its components. The result also contains names that match no constant of the system.
[[nodiscard]] GivenConstants not_overridden(const System&, const GivenConstants& weaker,
                                            const GivenConstants& stronger);

}  // namespace robochart::ir
