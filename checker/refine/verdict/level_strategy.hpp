// SPDX-License-Identifier: Apache-2.0
// Searches by levels (levels/level_search.hpp), which replace the ordinary search if there are several ranks or rows in
// files. Limits::by_levels names the strategy. The query is data, so that it can be sent to other programs.
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

/// The target of a search, and where it stores its rows.
struct LevelQuestion {
    enum class Kind : std::uint8_t { states, deadlock, choice, refinement };
    Kind kind = Kind::states;                          ///< `states`: the search has no target and visits every state
    Model model = Model::traces;                       ///< for a refinement
    std::shared_ptr<const NormalTable> specification;  ///< for a refinement; otherwise null
    bool divergence = false;  ///< if there is no such violation, the search looks for a cycle of taus
    std::uint64_t events_until = std::numeric_limits<std::uint64_t>::max();  ///< LevelSearch::first_violation
    RowKeeping rows = {};

    /// Whether rows begin with a node.
    [[nodiscard]] bool has_nodes() const { return kind == Kind::choice || kind == Kind::refinement; }
    /// Number of words in a row, for a system of this width.
    [[nodiscard]] std::size_t row_width(std::size_t state_width) const { return state_width + (has_nodes() ? 1 : 0); }
};

[[nodiscard]] std::unique_ptr<Monitor> monitor_of(const LevelQuestion& question);

/// Runs the part of one rank in a search; collective. The statistics are added even if a limit ends the search. If a
/// rank cannot create its row store, all ranks leave the search together (SharedWork). If rows are stored in files, the
/// function returns when no rank has one of them open. The first rank holds Limits::undisturbed while it waits.
std::optional<Violation> search_as_rank(lts::TransitionSystem& system, const LevelQuestion& question,
                                        Exchange& exchange, Budget& budget, Statistics& statistics);

/// Returns the number of threads of a program that can search the system, at most `limit`. It is one if the system
/// supports only one thread.
[[nodiscard]] unsigned threads_for(const lts::TransitionSystem& system, unsigned limit);

/// Runs the part of one program in a search; collective over `programs`. The program's threads are ranks (as_ranks);
/// the first is the caller's thread. Each thread has its own rows. The budget and the statistics are those of the first
/// thread. The others have the same limits, without progress.
std::optional<Violation> search_by_threads(Exchange& programs, unsigned threads, lts::TransitionSystem& system,
                                           const LevelQuestion& question, Budget& budget, Statistics& statistics);

/// The strategy of the searches by levels of a check.
class LevelStrategy {
public:
    LevelStrategy() = default;
    LevelStrategy(const LevelStrategy&) = delete;
    LevelStrategy& operator=(const LevelStrategy&) = delete;
    virtual ~LevelStrategy() = default;
    /// Announces the next assertion before anything is computed for it.
    virtual void begin_question(const std::string& /*text*/) {}
    /// Identifies the assertion to which the following searches belong. The digest covers everything on which its
    /// answer depends. No value if the digest is unknown, or if the states of the processes differ between runs.
    virtual void identify_question(const std::optional<diagnostics::Digest>& /*digest*/) {}
    /// `decided`: whether the assertion has an answer.
    virtual void end_question(bool /*decided*/) {}
    /// Called after the last assertion, unless some assertion was omitted.
    virtual void all_asked() {}
    /// The cache for answers of searches of this kind, whose statistics differ from those of other searches. Null if
    /// there is none.
    [[nodiscard]] virtual diagnostics::Cache* answers() { return nullptr; }
    /// Returns the result of the search in the system. Throws LimitReached. If the system cannot be searched in this
    /// way, LimitReached contains the reason.
    virtual std::optional<Violation> search(lts::TransitionSystem& system, const LevelQuestion& question,
                                            Budget& budget, Statistics& statistics) = 0;
};

/// Threads of this program as ranks.
class ThreadRanks final : public LevelStrategy {
public:
    explicit ThreadRanks(unsigned ranks) : ranks_(ranks) {}
    std::optional<Violation> search(lts::TransitionSystem& system, const LevelQuestion& question, Budget& budget,
                                    Statistics& statistics) override;

private:
    unsigned ranks_;
};

}  // namespace robochart::refine
