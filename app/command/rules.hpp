// SPDX-License-Identifier: Apache-2.0
// Rules of the command, and access to the rules of all components (for `explain` and the tests).
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

/// All rules of all components, by component, then in the order of their tables.
[[nodiscard]] std::vector<const diagnostics::Rule*> all_rules();
/// The codes that match a word, sorted and without duplicates. The comparison ignores case and hyphens, and the word
/// may omit the part of the code before the last hyphen. `w17` and `RCW17` mean RC-W17; `P01` means CSPM-P01,
/// PRISM-P01, RC-P01 and SLEEC-P01.
[[nodiscard]] std::vector<std::string> codes_meant(std::string_view word);
/// The rows of a code, ignoring case. A published rule may have several rows, for different circumstances.
[[nodiscard]] std::vector<const diagnostics::Rule*> find_rules(std::string_view code);

}  // namespace robochart::app
