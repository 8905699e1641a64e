// SPDX-License-Identifier: Apache-2.0
// Declares the rules of the command, and gives access to the rules of all components (for `explain` and the tests).
#pragma once

#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::app {

namespace rules {
using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "app/command/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* all[] = {
#define RULE(name, code, severity, message) &name,
#include "app/command/rules.def"
#undef RULE
};
}  // namespace rules

/// Returns the rules of all components, sorted by component and then in the order of their tables.
[[nodiscard]] std::vector<const diagnostics::Rule*> all_rules();
/// Returns the codes that match a word, sorted and without duplicates. The comparison ignores case and hyphens, and the
/// word may omit the part of the code before the last hyphen. `w17` and `RCW17` mean RC-W17; `P01` means CSPM-P01,
/// PRISM-P01, RC-P01 and SLEEC-P01.
[[nodiscard]] std::vector<std::string> codes_meant(std::string_view word);
/// Returns the rows of a code, ignoring case. A published rule may have several rows, for different circumstances.
[[nodiscard]] std::vector<const diagnostics::Rule*> find_rules(std::string_view code);

}  // namespace robochart::app
