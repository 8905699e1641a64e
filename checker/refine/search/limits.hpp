// The bounds of a check, and how far it has come.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "diagnostics/budget.hpp"

namespace robochart::refine {

class LevelStrategy;

/// How far a check has come, for those who wait.
struct Progress {
    enum class Phase { compiling, searching };
    Phase phase = Phase::searching;
    std::string part;                             ///< compiling: the component at work
    std::uint64_t component = 0, components = 0;  ///< compiling: its number, and of how many; 0 if not known
    std::uint64_t states = 0;                     ///< known so far
    std::uint64_t transitions = 0;
    std::uint64_t frontier = 0;  ///< searching: states that wait to be expanded
    std::uint64_t depth = 0;
    std::uint64_t resident_bytes = 0;  ///< of the whole program
    std::uint64_t grown_bytes = 0;     ///< of these, since the phase began
    double seconds = 0;                ///< since the phase began
};

/// Bounds of one check: those of the run, and its own. A bound reached gives Outcome::inconclusive, never a wrong
/// answer.
struct Limits : diagnostics::Limits {
    std::uint64_t max_states = 500'000'000;
    unsigned threads = 0;  ///< at most so many, where a space is wide; 0: one a core. Verdicts do not depend on it
    std::size_t wide_level =
        2048;  ///< levels of fewer states are done by one thread, as it is sooner done than others woken
    /// Whether states that confluent taus lead on from are left out (docs/search.md). Verdicts do not depend on it.
    bool reduction = false;
    /// Searches go by levels, as this says (verdict/level_strategy.hpp); null: they do not. Verdicts do not depend on
    /// it.
    LevelStrategy* by_levels = nullptr;
    /// While what it gives lives, a run that is to end is not ended by force; a thread may ask for it again meanwhile.
    /// May be empty.
    std::function<std::shared_ptr<void>()> undisturbed;
    /// Called a few times a second, by the thread that called the check.
    std::function<void(const Progress&)> progress;
};

/// How large a search was.
struct Statistics {
    std::uint64_t states = 0;  ///< pairs (specification node, implementation state) or states visited
    std::uint64_t transitions = 0;
    std::uint64_t depth = 0;  ///< breadth-first level of the last state
    /// Where a limit ended it: all runs of fewer steps were looked at, and none violates. 0: nothing of the kind is
    /// known.
    std::uint64_t searched_steps = 0;
    bool divergence_open = false;  ///< with searched_steps: these runs were not looked at for divergence
    std::uint64_t spec_nodes = 0;  ///< normalised specification nodes made
    double seconds = 0;
    std::uint64_t chased = 0;    ///< states left out: a step of a transition led to each, and a confluent tau led on
    std::uint64_t replicas = 0;  ///< the most equal components whose exchange gives no further state; 0: none
    std::uint64_t distinguished = 0;  ///< equal components that the question distinguishes, so that it does
    std::uint64_t ranks = 0;          ///< of a search by levels, in all programs; 0: it was another one
    // Of a search whose rows are on disk, the greatest of all ranks.
    std::uint64_t settled = 0;      ///< times that files were read through for rows put aside
    std::uint64_t rolled_back = 0;  ///< times that the search went back
};

}  // namespace robochart::refine
