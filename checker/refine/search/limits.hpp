// SPDX-License-Identifier: Apache-2.0
// Defines the limits of a check, its progress, and its statistics.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "base/diagnostics/budget.hpp"

namespace robochart::refine {

class LevelStrategy;
class SymbolicStage;

/// The progress of a check, for display.
struct Progress {
    enum class Phase { compiling, searching };
    Phase phase = Phase::searching;
    std::string part;                             ///< compiling: the current component
    std::uint64_t component = 0, components = 0;  ///< compiling: number of the component, and the total; 0: unknown
    std::uint64_t states = 0;                     ///< number of states found so far
    std::uint64_t transitions = 0;
    std::uint64_t frontier = 0;  ///< searching: number of states that wait to be expanded
    std::uint64_t depth = 0;
    std::uint64_t resident_bytes = 0;  ///< resident memory of the whole program
    std::uint64_t grown_bytes = 0;     ///< increase of resident memory since the phase began
    double seconds = 0;                ///< since the phase began
};

/// The limits of one check: the limits of the run, and additional limits. If a limit is reached, the result is
/// Outcome::inconclusive, never a wrong answer.
struct Limits : diagnostics::Limits {
    std::uint64_t max_states = 500'000'000;
    unsigned threads = 0;  ///< maximal number; 0: one for each core. Verdicts do not depend on it
    std::size_t wide_level =
        2048;  ///< levels with fewer states are processed by one thread, because waking others takes longer
    /// Whether static proofs may replace searches, and searches may skip states by confluence and symmetry
    /// (docs/search.md). Verdicts do not depend on it.
    bool reduction = false;
    /// Whether another search follows if a limit ends this search, so that partial answers are useless.
    bool first_of_two = false;
    /// The strategy of searches by levels (verdict/level_strategy.hpp). If it is null, other searches are used.
    /// Verdicts do not depend on it.
    LevelStrategy* by_levels = nullptr;
    /// With `reduction`: decides questions that a search has not decided after some time (verdict/symbolic_stage.hpp).
    /// If the pointer is null, the search decides alone. Verdicts do not depend on this stage.
    SymbolicStage* symbolic = nullptr;
    /// Returns an object that keeps the program running during its lifetime, even at a limit or an interrupt. Several
    /// threads may call this function. The function may be empty.
    std::function<std::shared_ptr<void>()> undisturbed;
    /// Receives progress a few times a second, in the thread that called the check.
    std::function<void(const Progress&)> progress;
};

/// The method that found an answer (docs/search.md, "Static proofs", "Decision diagrams").
enum class DecidedBy : std::uint8_t {
    search,            ///< states were searched
    tau_acyclic,       ///< the rules of the process exclude cycles of taus
    choice_free,       ///< the rules of the process exclude taus and choices between transitions with the same event
    compressed_parts,  ///< states were searched after the parts of the processes were compressed
    diagrams,          ///< decision diagrams represent the set of all reachable states
};

/// Statistics of a search.
struct Statistics {
    DecidedBy decided_by = DecidedBy::search;
    std::uint64_t states = 0;  ///< number of visited pairs (specification node, implementation state), or states
    std::uint64_t transitions = 0;
    std::uint64_t depth = 0;  ///< breadth-first level of the last state found
    /// If a limit ended the search: no run with fewer steps than this number is a violation. 0 if no such number is
    /// known.
    std::uint64_t searched_steps = 0;
    bool divergence_open = false;  ///< with searched_steps: divergence was not excluded for these runs
    std::uint64_t spec_nodes = 0;  ///< number of normalised specification nodes
    double seconds = 0;
    std::uint64_t chased = 0;  ///< number of states that were omitted by following confluent steps
    /// Size of the largest set of interchangeable components (replicas). The search stores only one of the states that
    /// permutations of replicas map to each other. 0 if there is no such set.
    std::uint64_t replicas = 0;
    /// Number of equal components that the assertion distinguishes, which prevents the reduction by symmetry.
    std::uint64_t distinguished = 0;
    std::uint64_t diagram_nodes = 0;  ///< decision diagrams: number of nodes of the set of reachable states
    double log10_states = 0;          ///< decision diagrams: decimal logarithm of the number of reachable states
    std::uint64_t ranks = 0;          ///< number of ranks in all programs, for a search by levels; 0: another search
    // For a search with rows on disk, the maximum over all ranks.
    std::uint64_t settled = 0;      ///< number of passes through the files to settle rows put aside
    std::uint64_t rolled_back = 0;  ///< number of times that the search rolled back
};

}  // namespace robochart::refine
