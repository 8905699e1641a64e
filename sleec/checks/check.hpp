// Names and types of SLEEC files.
#pragma once

#include <optional>

#include "diagnostics/diagnostic.hpp"
#include "sleec/checks/checked.hpp"

namespace robochart::sleec {

/// Follows names, checks types. Nothing, with findings, where there are errors.
[[nodiscard]] std::optional<CheckedRules> check(const RuleFile& file, diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::sleec
