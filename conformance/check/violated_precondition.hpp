// SPDX-License-Identifier: Apache-2.0
// Names the precondition of an operation because of which generated code ends a cycle with StepResult::precondition.
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

/// The reason of a difference at which the code reports a false precondition.
inline constexpr std::string_view outside_precondition = "the code calls an operation outside its precondition";

/// The statements that M is about to run at the end of the run that follows the code, found again in its terms. A call
/// of an operation with a definition is among them only if M is blocked at it. Empty if the run is not found in time.
[[nodiscard]] std::vector<diagnostics::Span> blocked_calls(const Result&, cspm::Session&, const cspm::ExprPtr& process,
                                                           const Alphabet&, const csp_emit::Provenance&,
                                                           const Options&);

/// Completes a result with the reason `outside_precondition`. The precondition is that of the place at which the code
/// stays. The model causes the difference if it is blocked at the same call.
void name_precondition(Result&, const std::vector<cpp_emit::ViolationPlace>&,
                       const std::vector<diagnostics::Span>& blocked, const diagnostics::SourceManager&);

}  // namespace robochart::conformance
