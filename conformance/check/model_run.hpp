// SPDX-License-Identifier: Apache-2.0
// Describes what the model M does in a run of NF_c(M), with the names and places of the model. Used if a model cannot
// be run in cycles, and if generated code differs from its model.
#pragma once

#include <cstdint>
#include <optional>

#include "base/diagnostics/source.hpp"
#include "checker/cspm/session.hpp"
#include "checker/refine/verdict/findings.hpp"
#include "checker/refine/verdict/verdict.hpp"
#include "conformance/model/normal_form_system.hpp"
#include "counterexample/run.hpp"
#include "csp_emit/emit.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// What is needed to describe runs with the names and places of a model.
struct ModelWords {
    const csp_emit::Provenance& provenance;
    const ir::System& system;
    const ir::Instantiation& instantiation;
    const diagnostics::SourceManager& sources;
};

/// Returns the limits of the search for one explanation. They are lower than those of a check: fewer states, and at
/// most 10 seconds.
[[nodiscard]] refine::Limits limits_of_explanation(refine::Limits limits);

/// Searches the normal form with this frame for the same run of NF_c(M). If the kind of the run is `no_trace`, only the
/// trace must be the same. Returns no value if there is no such run, or if the search takes too long.
[[nodiscard]] std::optional<refine::Violation> find_violation(NormalFormSystem& normal_form, const Frame& frame,
                                                              const refine::Counterexample& found,
                                                              const Alphabet& alphabet, const refine::Limits& limits);

/// Returns what M does in a run of NF_c(M) with this frame. Repeats the run in the semantics of `process` to find this.
/// After a run of kind `no_trace`, M continues until it needs an event of the environment; so its offers at the end are
/// the events that may come next. Returns no value if there is no such behaviour, or if the search takes too long.
/// Throws process::Interrupted and process::SemanticsError.
[[nodiscard]] std::optional<refine::Counterexample> run_of_model(cspm::Session& session, const cspm::ExprPtr& process,
                                                                 const Alphabet& alphabet, std::uint32_t cycle_length,
                                                                 const Frame& frame,
                                                                 const refine::Counterexample& found,
                                                                 const refine::Limits& limits);

/// Describes the run of M with the names and places of the model, as a counterexample to a timed claim of kind `kind`
/// is described.
[[nodiscard]] runs::Run interpret_run(const refine::Counterexample& run, ir::PropertyKind kind, cspm::Session& session,
                                      const ModelWords& words);

}  // namespace robochart::conformance
