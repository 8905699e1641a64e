// SPDX-License-Identifier: Apache-2.0
// Describes states and events by the corresponding elements of the model, with their places.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/source.hpp"
#include "conformance/code/interface.hpp"
#include "csp_emit/emit.hpp"

namespace robochart::conformance {

/// The names of the definitions in a state as printed by ModelGraph::describe.
[[nodiscard]] std::vector<std::string> definitions_in(const std::string& description);

/// "in S1 (aggregation.rct:83)" for each machine in a state as printed by ModelGraph::describe; without duplicates.
[[nodiscard]] std::vector<std::string> elements_of_state(const std::string& description, const csp_emit::Provenance&,
                                                         const diagnostics::SourceManager&);

/// "MoveForward()" or "MoveForward() (swarm_taxis.rct:24)": an event of NF_c(M) with the place of its element.
[[nodiscard]] std::string describe_with_place(process::Event, const Alphabet&, const csp_emit::Provenance&,
                                              const diagnostics::SourceManager&);

}  // namespace robochart::conformance
