// SLEEC files read into trees.
#pragma once

#include "diagnostics/diagnostic.hpp"
#include "sleec/syntax/syntax.hpp"

namespace robochart::sleec {

/// The rules of a text. Where findings are errors, what could be read is there.
[[nodiscard]] RuleFile read(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&);

}  // namespace robochart::sleec
