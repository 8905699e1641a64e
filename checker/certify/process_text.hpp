// SPDX-License-Identifier: Apache-2.0
// Writes a compiled process as text for a certificate: events, components, rules (docs/certificates.md, "Processes").
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/lts/graph.hpp"
#include "checker/lts/transition_system.hpp"
#include "checker/process/term.hpp"

namespace robochart::certify {

/// The maximal number of states of a process that is not compiled. Such a process is written as one component, and
/// cannot be written if it has more states.
inline constexpr std::size_t most_explicit_states = 200'000;

/// Returns the text in one line: a space replaces each group of control characters and the spaces after it.
[[nodiscard]] std::string one_line(const std::string& text);

/// Returns the text of a list of events.
[[nodiscard]] std::string event_list_text(const lts::EventTable& table, const std::vector<lts::Event>& events);

/// Explores a process. Returns no value if it has more than `most_explicit_states` states. Polls the budget.
[[nodiscard]] std::optional<lts::Graph> explored_graph(lts::TransitionSystem& process, diagnostics::Pollable& budget);

/// Returns the text of the process. Components are named by their terms. Returns no value for a process that is not
/// compiled and has too many states. Polls the budget. Throws the exceptions of the process.
[[nodiscard]] std::optional<std::string> process_text(lts::TransitionSystem& process, const process::TermStore& terms,
                                                      diagnostics::Pollable& budget);

/// Returns the text of a process that is stored as a graph. It has one component; the states keep their numbers.
[[nodiscard]] std::string graph_text(const lts::Graph& graph, const lts::EventTable& events,
                                     diagnostics::Pollable& budget);

}  // namespace robochart::certify
