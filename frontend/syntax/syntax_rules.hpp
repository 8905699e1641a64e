// SPDX-License-Identifier: Apache-2.0
// Lists the rules of the parser: all errors in a text that are found before names are resolved.
#pragma once

#include <algorithm>
#include <iterator>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::frontend::syntax {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "frontend/syntax/syntax_rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* rule_list[] = {
#define RULE(name, code, severity, message) &name,
#include "frontend/syntax/syntax_rules.def"
#undef RULE
};

/// True if the rule is in the table of the parser.
[[nodiscard]] inline bool is_syntax(const Rule& rule) {
    return std::ranges::find(rule_list, &rule) != std::end(rule_list);
}

}  // namespace robochart::frontend::syntax
