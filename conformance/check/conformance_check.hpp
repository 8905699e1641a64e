// SPDX-License-Identifier: Apache-2.0
// Implements the two checks of docs/conformance.md: is NF_c(M) schedulable, and does L(G) refine it? The runs in the
// results are divided into control cycles.
#pragma once

#include "conformance/check/places_in_state.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/code_system.hpp"
#include "conformance/code/interface.hpp"
#include "conformance/model/model_graph.hpp"

namespace robochart::conformance {

/// Checks that M is schedulable: NF_c(M) reaches no timelock and no divergence. The outcome of a schedulable M is
/// `conforms`.
[[nodiscard]] Result check_schedulability(ModelGraph&, const Alphabet&, std::uint32_t cycle_length,
                                          const refine::Limits&);

/// Checks NF_c(M) [FD= L(code) for a schedulable M. Throws AlphabetError if the interfaces of model and code do not
/// match, and std::length_error if there are too many valuations.
[[nodiscard]] Result refined_by(ModelGraph&, const Alphabet&, const rc_interface& code, std::uint32_t cycle_length,
                                const refine::Limits&, Relation = Relation::failures_divergences,
                                const EventPlaces& = {});

/// Returns true if the inputs have so many valuations that reading on demand is faster than trying all of them.
[[nodiscard]] bool many_valuations(const Interface&);

/// Completes a result with a run of NF_c(M), `found`: M cannot be run in cycles. `model` is the graph of M.
void report_not_schedulable(Result&, const refine::Counterexample& found, ModelGraph& model, const Alphabet&,
                            std::uint32_t cycle_length, const refine::Limits&);
/// Describes why an additional property fails. The last event of the run of NF_c(M) only marks the violation.
[[nodiscard]] Aside found_aside(const diagnostics::Rule&, std::string reason, const refine::Counterexample& found,
                                const Alphabet&, std::uint32_t cycle_length);

/// Checks schedulability, then NF_c(M) [FD= L(code). `interface` describes the code. The caller must already have added
/// the carriers to it, and in `component` the CSP prefix of M's events. `events` is the event table of the model. With
/// many valuations of the inputs, the search reads on demand, except for tick-tock.
[[nodiscard]] Result judge_component(lts::TransitionSystem& model, process::EventTable& events,
                                     const Interface& interface, const rc_interface& code, std::uint32_t cycle_length,
                                     const refine::Limits&, Relation = Relation::failures_divergences,
                                     const EventPlaces& = {}, InputSearch = InputSearch::automatic);

}  // namespace robochart::conformance
