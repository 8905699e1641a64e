// SPDX-License-Identifier: Apache-2.0
// Compares syntax trees of rule files.
#pragma once

#include "claims/sleec/syntax/syntax.hpp"

namespace robochart::sleec::testing {

/// Returns true if the declarations, rules, concerns and purposes are equal, in the same order. Places and superfluous
/// parentheses are ignored.
[[nodiscard]] bool same_file(const RuleFile& a, const RuleFile& b);

}  // namespace robochart::sleec::testing
