// SPDX-License-Identifier: Apache-2.0
// Describes states and events by the corresponding elements of the model and their places.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/source.hpp"
#include "conformance/code/interface.hpp"
#include "csp_emit/emit.hpp"

namespace robochart::conformance {

/// Returns the names of the definitions in a state as printed by ModelGraph::describe.
[[nodiscard]] std::vector<std::string> definitions_in(const std::string& description);

/// Returns, for each machine in a state as printed by ModelGraph::describe, a text such as "in S1
/// (aggregation.rct:83)". There are no duplicates.
[[nodiscard]] std::vector<std::string> elements_of_state(const std::string& description, const csp_emit::Provenance&,
                                                         const diagnostics::SourceManager&);

/// Returns an event of NF_c(M) with the place of its element: "MoveForward() (swarm_taxis.rct:24)". If the element has
/// no place, the result is "MoveForward()".
[[nodiscard]] std::string describe_with_place(process::Event, const Alphabet&, const csp_emit::Provenance&,
                                              const diagnostics::SourceManager&);

}  // namespace robochart::conformance
