// Why a question about a model has no answer: an error of evaluation in terms of the model. Every verb reports such
// errors by this.
#pragma once

#include <string>

#include "checker/cspm/session.hpp"
#include "diagnostics/source.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::runs {

/// What cannot be evaluated, with the element of the model that it is in: "division by zero, in P::S::t1".
[[nodiscard]] std::string failure(const cspm::EvaluationError&, const ir::System&);
/// The same behind its place: "m.rct:8:62: division by zero, in P::S::t1".
[[nodiscard]] std::string placed_failure(const cspm::EvaluationError&, const ir::System&,
                                         const diagnostics::SourceManager&);

}  // namespace robochart::runs
