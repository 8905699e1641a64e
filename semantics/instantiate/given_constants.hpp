// SPDX-License-Identifier: Apache-2.0
// Values of constants from several sources: those of the command line override those of a scenario, a swarm or a log.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Values of constants as in InstantiationOptions. The key is "NAME", a path "P::S::NAME" or the end of a path such as
/// "S::NAME"; the value is a RoboChart literal. A name refers to every constant whose path equals it or ends with it.
/// Two names of one source must not refer to the same constant (RC-S24).
using GivenConstants = std::map<std::string, std::string>;

/// The constants that `with constant` of an assertion or a claim sets, as in Property::constants.
using SetConstants = std::vector<std::pair<std::string, ExprPtr>>;

/// A RoboChart literal of a type: `3`, `-0.5`, `true`, `Colour::red`. Null if the text is not one.
[[nodiscard]] ExprPtr parse_literal(const System&, TypeId, const std::string& text);

/// The names of `weaker` that `stronger` does not override; different spellings of a name are recognised. If `stronger`
/// overrides only some constants of a name, the name is kept, so that both together are rejected (RC-S24). Otherwise it
/// would be unclear which value is meant, because a constant passes its value to those of its components. A name that
/// matches no constant of the system is kept, too.
[[nodiscard]] GivenConstants not_overridden(const System&, const GivenConstants& weaker,
                                            const GivenConstants& stronger);

}  // namespace robochart::ir
