// SPDX-License-Identifier: Apache-2.0
// Describes an error of evaluation in terms of the model, as the reason why an assertion has no answer. All verbs
// report such errors with these functions.
#pragma once

#include <string>
#include <string_view>

#include "base/diagnostics/source.hpp"
#include "checker/cspm/session.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::runs {

/// Returns the error and the element of the model that contains it: "division by zero, in P::S::t1".
[[nodiscard]] std::string failure_text(const cspm::EvaluationError&, const ir::System&);
/// Returns the place, the error and the element: "m.rct:8:62: division by zero, in P::S::t1".
[[nodiscard]] std::string placed_failure(const cspm::EvaluationError&, const ir::System&,
                                         const diagnostics::SourceManager&);

/// Returns true if an error with this message is caused by the carriers and not by the model: a value does not belong
/// to the carrier of a channel, or a set of values is too large to be listed.
[[nodiscard]] bool leaves_carriers(std::string_view message);

}  // namespace robochart::runs
