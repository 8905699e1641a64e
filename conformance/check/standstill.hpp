// Why a model cannot be run in control cycles, in its own elements: which rule says so, which transitions and actions
// are part of it, and what would help (docs/conformance.md, "Why a model is not schedulable").
#pragma once

#include "checker/cspm/session.hpp"
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

/// The same rule and run for a result whose run was followed event by event (follower.hpp).
void take_standstill(Result&, const diagnostics::Rule*, const std::vector<process::Event>& trace);

/// What the words of a model are looked up in.
struct ModelWords {
    const csp_emit::Provenance& provenance;
    const ir::System& system;
    const ir::Instantiation& instantiation;
    const diagnostics::SourceManager& sources;
};

/// Completes the explanation of a result that is not schedulable: its run is found again in the terms of M. Where that
/// takes too long, the rule has to do.
void explain_standstill(Result&, cspm::Session&, const cspm::ExprPtr& process, const Alphabet&, const ModelWords&,
                        const Options&);

}  // namespace robochart::conformance
