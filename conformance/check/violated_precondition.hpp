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

/// The reason text for a difference at which the code reports a false precondition.
inline constexpr std::string_view outside_precondition = "the code calls an operation outside its precondition";

/// Returns the next statements of M at the end of the run that follows the code. To do this, the function finds the run
/// again in the semantics of M. If an operation has a definition, the result contains a call of the operation only if M
/// is blocked at this call. The result is empty if the function does not find the run in time.
[[nodiscard]] std::vector<diagnostics::Span> blocked_calls(const Result&, cspm::Session&, const cspm::ExprPtr& process,
                                                           const Alphabet&, const csp_emit::Provenance&,
                                                           const Options&);

/// Completes a result with the reason `outside_precondition`. The place at which the code stops determines the
/// precondition. If the model is blocked at the same call, the error is in the model and not in the code.
void name_precondition(Result&, const std::vector<cpp_emit::ViolationPlace>&,
                       const std::vector<diagnostics::Span>& blocked, const diagnostics::SourceManager&);

}  // namespace robochart::conformance
