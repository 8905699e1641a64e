// SPDX-License-Identifier: Apache-2.0
// Exports a state space and results as text for other tools.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "prism/explore/state_space.hpp"
#include "prism/session/counterexample.hpp"

namespace robochart::prism {

/// Receives a text in pieces.
using TextSink = std::function<void(std::string_view)>;

/// Writes the transitions. For a dtmc: "states transitions", then a line "from to probability" for each transition. For
/// an mdp: "states choices transitions", then lines "from choice to probability action". Probabilities are doubles with
/// all digits.
void export_transitions(const StateSpace& space, const TextSink& sink);
/// Writes "(x,y)", then a line such as "0:(1,false)" for each state.
void export_states(const StateSpace& space, const TextSink& sink);
/// Writes `0="init" 1="deadlock" 2="done"`, then a line such as "0: 0 2" for each state with labels.
void export_labels(const StateSpace& space, const TextSink& sink);
/// Writes the transitions as a graph for Graphviz.
void export_graph(const StateSpace& space, const TextSink& sink);
/// Writes a line for each state that has several choices and is reachable under the scheduler: "x=1, y=false: [go]
/// Robot (line 7)".
void export_strategy(const StateSpace& space, const std::vector<std::uint32_t>& choices,
                     const diagnostics::SourceManager& sources, const TextSink& sink);
/// Writes the stored paths as one graph for Graphviz. An edge of several paths occurs once.
void export_counterexample(const Counterexample& counterexample, const diagnostics::SourceManager& sources,
                           const TextSink& sink);

}  // namespace robochart::prism
