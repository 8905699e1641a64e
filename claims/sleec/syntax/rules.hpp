// SPDX-License-Identifier: Apache-2.0
// Declares the findings of the SLEEC parser.
#pragma once

#include "base/words/words.hpp"

namespace robochart::sleec::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "claims/sleec/syntax/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* syntax[] = {
#define RULE(name, code, severity, message) &name,
#include "claims/sleec/syntax/rules.def"
#undef RULE
};

/// The findings that all languages made of words share.
inline constexpr words::Findings findings{unexpected_token, bad_character, open_comment, too_deep};

}  // namespace robochart::sleec::rules
