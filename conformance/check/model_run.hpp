// What the model M does in a run of NF_c(M), as a run in the words of the model: of a model that cannot be run in
// cycles, and of one that generated code differs from.
#pragma once

#include <cstdint>
#include <optional>

#include "checker/cspm/session.hpp"
#include "checker/refine/verdict/findings.hpp"
#include "checker/refine/verdict/verdict.hpp"
#include "conformance/model/normal_form_system.hpp"
#include "csp_emit/emit.hpp"
#include "diagnostics/source.hpp"
#include "runs/run.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// What the words of a model are looked up in.
struct ModelWords {
    const csp_emit::Provenance& provenance;
    const ir::System& system;
    const ir::Instantiation& instantiation;
    const diagnostics::SourceManager& sources;
};

/// The share of one explanation of what a search was given: few states, and 10 s at most.
[[nodiscard]] refine::Limits limits_of_explanation(refine::Limits limits);

/// A run of NF_c(M), found again in its normal form with this frame; nothing where that takes too long, or where there
/// is none. Of a run of kind `no_trace` the trace alone counts.
[[nodiscard]] std::optional<refine::Violation> found_in(NormalFormSystem& normal_form, const Frame& frame,
                                                        const refine::Counterexample& found, const Alphabet& alphabet,
                                                        const refine::Limits& limits);

/// What M does in a run of NF_c(M) with this frame, found again in the terms of `process`; nothing where that takes too
/// long, or where there is none. Behind a run of kind `no_trace` M goes on as far as it decides alone, so that what it
/// offers at the end is what may come next. Throws process::Interrupted and process::SemanticsError.
[[nodiscard]] std::optional<refine::Counterexample> run_of_model(cspm::Session& session, const cspm::ExprPtr& process,
                                                                 const Alphabet& alphabet, std::uint32_t cycle_length,
                                                                 const Frame& frame,
                                                                 const refine::Counterexample& found,
                                                                 const refine::Limits& limits);

/// A run of M in the words of the model; `kind`: of the claim, in time, that it is a counterexample to.
[[nodiscard]] runs::Run in_words(const refine::Counterexample& run, ir::PropertyKind kind, cspm::Session& session,
                                 const ModelWords& words);

}  // namespace robochart::conformance
