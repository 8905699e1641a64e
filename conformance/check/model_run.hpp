// SPDX-License-Identifier: Apache-2.0
// Describes the behaviour of the model M in a run of NF_c(M), in terms of the model. Used for models that cannot be run
// in cycles, and for models from which generated code differs.
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

/// The data for describing runs in terms of a model.
struct ModelWords {
    const csp_emit::Provenance& provenance;
    const ir::System& system;
    const ir::Instantiation& instantiation;
    const diagnostics::SourceManager& sources;
};

/// The limits of one explanation, a fraction of those of a search: few states, and at most 10 s.
[[nodiscard]] refine::Limits limits_of_explanation(refine::Limits limits);

/// Finds a run of NF_c(M) again in the normal form with this frame. No value if the search takes too long, or if there
/// is no such run. For a run of kind `no_trace` only the trace must be equal.
[[nodiscard]] std::optional<refine::Violation> find_violation(NormalFormSystem& normal_form, const Frame& frame,
                                                              const refine::Counterexample& found,
                                                              const Alphabet& alphabet, const refine::Limits& limits);

/// The behaviour of M in a run of NF_c(M) with this frame, found again in the terms of `process`. No value if the
/// search takes too long, or if there is no such behaviour. After a run of kind `no_trace`, M continues as long as it
/// needs no event of the environment, so that its offers at the end are the possible next events. Throws
/// process::Interrupted and process::SemanticsError.
[[nodiscard]] std::optional<refine::Counterexample> run_of_model(cspm::Session& session, const cspm::ExprPtr& process,
                                                                 const Alphabet& alphabet, std::uint32_t cycle_length,
                                                                 const Frame& frame,
                                                                 const refine::Counterexample& found,
                                                                 const refine::Limits& limits);

/// The run of M in terms of the model. `kind` is the kind of the timed claim that the run would refute.
[[nodiscard]] runs::Run interpret_run(const refine::Counterexample& run, ir::PropertyKind kind, cspm::Session& session,
                                      const ModelWords& words);

}  // namespace robochart::conformance
