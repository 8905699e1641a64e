// SPDX-License-Identifier: Apache-2.0
// Explains why a model cannot be run in control cycles: the rule, the transitions and actions involved, and a remedy
// (docs/conformance.md, "Why a model is not schedulable").
#pragma once

#include "base/diagnostics/source.hpp"
#include "checker/cspm/session.hpp"
#include "conformance/check/model_run.hpp"
#include "conformance/check/result.hpp"
#include "conformance/model/normal_form_system.hpp"
#include "csp_emit/emit.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// Returns the rule for a state of NF_c(M) without possible events. Returns null if an event is possible, or if the
/// state waits for a late input.
[[nodiscard]] const diagnostics::Rule* rule_of(Standstill);
/// Returns the rule for a run of NF_c(M) that ends in a standstill or an endless loop. `graph` is the graph of M.
[[nodiscard]] const diagnostics::Rule& rule_of(const refine::Counterexample&, ModelGraph& graph, const Alphabet&,
                                               std::uint32_t cycle_length, const refine::Limits&);

/// Converts a sequence of events of NF_c(M), or of code and NF_c(M), to a run. Callers may use only the trace of this
/// run.
[[nodiscard]] refine::Counterexample trace_as_run(const std::vector<process::Event>& trace);
/// Sets the rule and the run of a result that was found event by event (follower.hpp). The rule is null for code that
/// differs. `trace` is the common trace of code and NF_c(M).
void set_model_run(Result&, const diagnostics::Rule*, const std::vector<process::Event>& trace);

/// Completes the explanation of a result that differs or is not schedulable, and the explanations of its additional
/// properties. To do this, the function finds the runs again in the semantics of M. If the search for a run takes too
/// long, the explanation contains only the rule or the cycles.
void explain_result(Result&, cspm::Session&, const cspm::ExprPtr& process, const Alphabet&, const ModelWords&,
                    const Options&);

}  // namespace robochart::conformance
