// SPDX-License-Identifier: Apache-2.0
// Decides questions in a second way, which follows the definitions: firing rules on trees, an explicit graph, subset
// construction by traces, and enumeration of refusal sets. This checker shares no code with the engine. It is for small
// processes over few letters.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "process_tree.hpp"

namespace robochart::refine::naive {

struct Graph {
    struct Edge {
        Letter letter;
        int target;
    };
    std::vector<std::vector<Edge>> edges;  ///< state 0 is the initial one
};

/// Returns nullopt if the process has too many states, or states that are too large, for a test.
std::optional<Graph> explore(const Script& script, const Process& process, std::size_t limit);

enum class Semantics { T, F, FD };

/// The behaviours of one graph, over an alphabet 0 .. letters-1.
class Behaviour {
public:
    Behaviour(const Graph& graph, int letters) : graph_(graph), letters_(letters) {}

    using States = std::set<int>;
    [[nodiscard]] States initially() const { return closed({0}); }
    [[nodiscard]] States after(const States& states, Letter letter) const;
    /// Returns whether some of the states can refuse every letter of the set. Bit 0 of the set is tick, and bit 1+l is
    /// the letter l.
    [[nodiscard]] bool can_refuse(const States& states, unsigned set) const;
    [[nodiscard]] bool diverges(const States& states) const;
    [[nodiscard]] unsigned refusal_sets() const { return 1U << (letters_ + 1); }
    [[nodiscard]] std::vector<Letter> alphabet() const;

    [[nodiscard]] bool state_refuses(int state, unsigned set) const;
    [[nodiscard]] const Graph& graph() const { return graph_; }

private:
    [[nodiscard]] States closed(States states) const;

    const Graph& graph_;
    int letters_;
};

bool refines(const Behaviour& specification, const Behaviour& implementation, Semantics semantics);
bool deadlock_free(const Behaviour& process, Semantics semantics);
bool divergence_free(const Behaviour& process);
bool deterministic(const Behaviour& process, Semantics semantics);
bool has_trace(const Behaviour& process, const std::vector<Letter>& trace);
/// Returns the minimal number of steps, taus included, of a run that violates refinement in T or F.
std::optional<std::size_t> shortest_violation(const Behaviour& specification, const Behaviour& implementation,
                                              Semantics semantics);

}  // namespace robochart::refine::naive
