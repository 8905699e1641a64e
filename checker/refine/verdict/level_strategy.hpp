// SPDX-License-Identifier: Apache-2.0
// Defines the strategy of searches by levels (levels/level_search.hpp), which replace the ordinary search if there are
// several ranks or if rows are stored in files. Limits::by_levels selects the strategy. A question consists only of
// data, so that one program can send it to another program.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "base/cache/cache.hpp"
#include "checker/refine/levels/level_search.hpp"
#include "checker/refine/levels/row_keeping.hpp"
#include "checker/refine/verdict/findings.hpp"
#include "checker/refine/verdict/normal_table.hpp"

namespace robochart::refine {

/// The violation that a search looks for, and the place of its rows, as data.
struct LevelQuestion {
    enum class Kind : std::uint8_t { states, deadlock, choice, refinement };
    /// `states`: the search looks for nothing and visits every state
    Kind kind = Kind::states;
    Model model = Model::traces;                       ///< for a refinement
    std::shared_ptr<const NormalTable> specification;  ///< for a refinement; otherwise null
    bool divergence = false;                           ///< whether the search then looks for a cycle of taus
    std::uint64_t events_until = std::numeric_limits<std::uint64_t>::max();  ///< see LevelSearch::first_violation
    RowKeeping rows = {};

    /// Returns true if rows begin with a node.
    [[nodiscard]] bool has_nodes() const { return kind == Kind::choice || kind == Kind::refinement; }
    /// Returns the number of words in a row, for a system of this width.
    [[nodiscard]] std::size_t row_width(std::size_t state_width) const { return state_width + (has_nodes() ? 1 : 0); }
};

[[nodiscard]] std::unique_ptr<Monitor> monitor_of(const LevelQuestion& question);

/// Takes part in a search as one rank. All ranks must call this function. The function adds the statistics even if a
/// limit ends the search. If a rank cannot create its row store, all ranks leave the search together (SharedWork). If
/// rows are stored in files, the function returns when no rank has such a file open. The first rank holds
/// Limits::undisturbed while it waits.
std::optional<Violation> search_as_rank(lts::TransitionSystem& system, const LevelQuestion& question,
                                        Exchange& exchange, Budget& budget, Statistics& statistics);

/// Returns how many threads of a program can search the system, at most `limit`. The result is one if the system
/// supports only one thread.
[[nodiscard]] unsigned threads_for(const lts::TransitionSystem& system, unsigned limit);

/// Takes part in a search as one program. All ranks of `programs` must call this function. The threads of the program
/// are ranks (as_ranks), and the caller's thread is the first of these ranks. Each thread stores its own rows. The
/// first thread uses `budget` and `statistics`. The other threads have the same limits and report no progress.
std::optional<Violation> search_by_threads(Exchange& programs, unsigned threads, lts::TransitionSystem& system,
                                           const LevelQuestion& question, Budget& budget, Statistics& statistics);

/// Determines how the searches by levels of a check are executed.
class LevelStrategy {
public:
    LevelStrategy() = default;
    LevelStrategy(const LevelStrategy&) = delete;
    LevelStrategy& operator=(const LevelStrategy&) = delete;
    virtual ~LevelStrategy() = default;
    /// Announces the next assertion before anything is computed for it.
    virtual void begin_question(const std::string& /*text*/) {}
    /// Identifies the assertion to which the following searches belong. The digest covers everything on which the
    /// answer depends. There is no digest if these data are unknown, or if the states of the processes differ between
    /// runs.
    virtual void identify_question(const std::optional<diagnostics::Digest>& /*digest*/) {}
    /// Ends the current assertion. `decided`: whether the assertion has an answer.
    virtual void end_question(bool /*decided*/) {}
    /// The command calls this function after the last assertion, unless it has omitted some assertion.
    virtual void all_asked() {}
    /// Returns the cache for the answers of searches by levels, or null if there is none. These answers have a separate
    /// cache, because their statistics differ from those of other searches.
    [[nodiscard]] virtual diagnostics::Cache* answers() { return nullptr; }
    /// Searches the system and returns the violation found. Throws LimitReached. If the system does not support
    /// searches by levels, the exception contains the reason.
    virtual std::optional<Violation> search(lts::TransitionSystem& system, const LevelQuestion& question,
                                            Budget& budget, Statistics& statistics) = 0;
};

/// Uses the threads of this program as ranks.
class ThreadRanks final : public LevelStrategy {
public:
    explicit ThreadRanks(unsigned ranks) : ranks_(ranks) {}
    std::optional<Violation> search(lts::TransitionSystem& system, const LevelQuestion& question, Budget& budget,
                                    Statistics& statistics) override;

private:
    unsigned ranks_;
};

}  // namespace robochart::refine
