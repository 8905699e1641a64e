// SPDX-License-Identifier: Apache-2.0
// Finds the violated precondition of an operation when generated code ends a cycle with StepResult::precondition.
#pragma once

#include <string_view>
#include <vector>

#include "base/diagnostics/source.hpp"
#include "checker/cspm/session.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/interface.hpp"
#include "cpp_emit/plan/violation_place.hpp"
#include "csp_emit/base/emission.hpp"

namespace robochart::conformance {

/// The reason of a difference if the code reports a false precondition.
inline constexpr std::string_view outside_precondition = "the code calls an operation outside its precondition";

/// Returns the next statements of M at the end of the run that follows the code. The run is found again in the
/// semantics of M. A call of an operation with a definition is included only if M is blocked at it. The result is empty
/// if the run is not found in time.
[[nodiscard]] std::vector<diagnostics::Span> blocked_calls(const Result&, cspm::Session&, const cspm::ExprPtr& process,
                                                           const Alphabet&, const csp_emit::Provenance&,
                                                           const Options&);

/// Completes a result with the reason `outside_precondition`. The place at which the code stops determines the
/// precondition. If the model is blocked at the same call, the model causes the difference.
void name_precondition(Result&, const std::vector<cpp_emit::ViolationPlace>&,
                       const std::vector<diagnostics::Span>& blocked, const diagnostics::SourceManager&);

}  // namespace robochart::conformance
