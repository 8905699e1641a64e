// SPDX-License-Identifier: Apache-2.0
// Describes what the model M does in a run of NF_c(M), with the names and places of the model. The check uses these
// descriptions if a model cannot be run in cycles, or if generated code differs from its model.
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

/// Returns the limits of the search for one explanation. They are lower than the limits of a check: few states, and at
/// most 10 s.
[[nodiscard]] refine::Limits limits_of_explanation(refine::Limits limits);

/// Searches the normal form with this frame for a run of NF_c(M). Returns no value if the search takes too long, or if
/// there is no such run. For a run of kind `no_trace`, only the trace must be equal.
[[nodiscard]] std::optional<refine::Violation> find_violation(NormalFormSystem& normal_form, const Frame& frame,
                                                              const refine::Counterexample& found,
                                                              const Alphabet& alphabet, const refine::Limits& limits);

/// Returns the behaviour of M in a run of NF_c(M) with this frame. To find this behaviour, the function repeats the run
/// in the semantics of `process`. Returns no value if the search takes too long, or if there is no such behaviour.
/// After a run of kind `no_trace`, M continues until it needs an event of the environment, so that its offers at the
/// end are the possible next events. Throws process::Interrupted and process::SemanticsError.
[[nodiscard]] std::optional<refine::Counterexample> run_of_model(cspm::Session& session, const cspm::ExprPtr& process,
                                                                 const Alphabet& alphabet, std::uint32_t cycle_length,
                                                                 const Frame& frame,
                                                                 const refine::Counterexample& found,
                                                                 const refine::Limits& limits);

/// Describes the run of M with the names and places of the model. `kind` is the kind of timed claim that the run would
/// refute.
[[nodiscard]] runs::Run interpret_run(const refine::Counterexample& run, ir::PropertyKind kind, cspm::Session& session,
                                      const ModelWords& words);

}  // namespace robochart::conformance
