// Values of constants from several sources: the command line before a scenario, a swarm or a log.
#pragma once

#include <map>
#include <string>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Values of constants as InstantiationOptions has them: "NAME", "P::S::NAME" or its end, "S::NAME", -> RoboChart
/// literal. A name means every constant whose path it is or ends; no two names of one source mean one constant
/// (RC-S24).
using GivenConstants = std::map<std::string, std::string>;

/// Of `weaker` the names that `stronger` does not override, however they are spelled. One that it overrides in part
/// stays, so that both together are refused (RC-S24): values flow from a constant to those of its parts, and nobody
/// would know which was meant. Names that the system does not have stay.
[[nodiscard]] GivenConstants not_overridden(const System&, const GivenConstants& weaker,
                                            const GivenConstants& stronger);

}  // namespace robochart::ir
