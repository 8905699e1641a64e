// Why a model cannot be run in control cycles, in its own elements: which rule says so, which transitions and actions
// are part of it, and what would help (docs/conformance.md, "Why a model is not schedulable").
#pragma once

#include "checker/cspm/session.hpp"
#include "conformance/check/model_run.hpp"
#include "conformance/check/result.hpp"
#include "conformance/model/normal_form_system.hpp"
#include "csp_emit/emit.hpp"
#include "diagnostics/source.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// The rule of a state of NF_c(M) in which nothing is possible; null where something is, or an input may come late.
[[nodiscard]] const diagnostics::Rule* rule_of(Standstill);
/// The rule of a run of NF_c(M) that ends in a standstill or an endless loop; `graph` is M's.
[[nodiscard]] const diagnostics::Rule& rule_of(const refine::Counterexample&, ModelGraph& graph, const Alphabet&,
                                               std::uint32_t cycle_length, const refine::Limits&);

/// Events that code and NF_c(M), or NF_c(M) alone, do one after the other, as a run whose trace alone counts.
[[nodiscard]] refine::Counterexample traced(const std::vector<process::Event>& trace);
/// The rule and the run behind a result that was found event by event (follower.hpp): of a standstill its rule, null of
/// code that differs. `trace`: what code and NF_c(M) both do.
void take_run(Result&, const diagnostics::Rule*, const std::vector<process::Event>& trace);

/// Completes the explanation of a result that differs or is not schedulable, and those of its asides: their runs are
/// found again in the terms of M. Where that takes too long, the rule or the cycles have to do.
void explain(Result&, cspm::Session&, const cspm::ExprPtr& process, const Alphabet&, const ModelWords&, const Options&);

}  // namespace robochart::conformance
