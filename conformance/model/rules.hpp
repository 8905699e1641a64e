// What can be wrong with a log of a run before it is compared with the model (docs/traces.md).
#pragma once

#include <span>

#include "diagnostics/diagnostic.hpp"

namespace robochart::conformance::rules {

extern const diagnostics::Rule log_syntax;    ///< RC-L01
extern const diagnostics::Rule log_name;      ///< RC-L02
extern const diagnostics::Rule log_value;     ///< RC-L03
extern const diagnostics::Rule log_of_other;  ///< RC-L04

/// Every rule, for `explain` and for the tests.
[[nodiscard]] std::span<const diagnostics::Rule* const> all();

}  // namespace robochart::conformance::rules
