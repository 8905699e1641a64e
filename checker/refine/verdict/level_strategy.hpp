// SPDX-License-Identifier: Apache-2.0
// Searches by levels (levels/level_search.hpp) instead of the ordinary search: with several ranks, or rows in files.
// Limits::by_levels names the strategy. Its input is data, so that it can be sent to other programs.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "checker/refine/levels/level_search.hpp"
#include "checker/refine/levels/row_keeping.hpp"
#include "checker/refine/verdict/findings.hpp"
#include "checker/refine/verdict/normal_table.hpp"
#include "base/cache/cache.hpp"

namespace robochart::refine {

/// The target of a search, and where it stores its rows.
struct LevelQuestion {
    enum class Kind : std::uint8_t { states, deadlock, choice, refinement };
    Kind kind = Kind::states;                          ///< states: there is no target, and every state is visited
    Model model = Model::traces;                       ///< for a refinement
    std::shared_ptr<const NormalTable> specification;  ///< for a refinement; otherwise null
    bool divergence = false;                           ///< then, if nothing is found, a cycle of taus
    std::uint64_t events_until = std::numeric_limits<std::uint64_t>::max();  ///< LevelSearch::first_violation
    RowKeeping rows = {};

    /// Whether rows begin with a node.
    [[nodiscard]] bool has_nodes() const { return kind == Kind::choice || kind == Kind::refinement; }
    /// Number of words in a row, for a system of this width.
    [[nodiscard]] std::size_t row_width(std::size_t state_width) const { return state_width + (has_nodes() ? 1 : 0); }
};

[[nodiscard]] std::unique_ptr<Monitor> monitor_of(const LevelQuestion& question);

/// One rank's part of a search; collective. Statistics are added also if a limit ends the search. If a rank cannot
/// create its row store, all leave the search together (SharedWork). If rows are stored in files, it returns when no
/// rank has one of them open any more, and the first rank has Limits::undisturbed while it waits.
std::optional<Violation> search_as_rank(lts::TransitionSystem& system, const LevelQuestion& question,
                                        Exchange& exchange, Budget& budget, Statistics& statistics);

/// The number of threads of a program that can search the system, at most `wanted`: one if it supports only one thread.
[[nodiscard]] unsigned threads_for(const lts::TransitionSystem& system, unsigned wanted);

/// One program's part of a search, with this many threads as ranks, the first of which is the caller's (as_ranks);
/// collective over `programs`. Each thread has its own rows. The budget and the statistics are the first thread's; the
/// others have the same limits, without progress.
std::optional<Violation> search_by_threads(Exchange& programs, unsigned threads, lts::TransitionSystem& system,
                                           const LevelQuestion& question, Budget& budget, Statistics& statistics);

/// The strategy by which a check's searches use levels.
class LevelStrategy {
public:
    LevelStrategy() = default;
    LevelStrategy(const LevelStrategy&) = delete;
    LevelStrategy& operator=(const LevelStrategy&) = delete;
    virtual ~LevelStrategy() = default;
    /// Announces the next assertion, before anything is computed for it.
    virtual void begin_question(const std::string& /*text*/) {}
    /// The following searches belong to the assertion begun. The digest covers everything on which its answer depends;
    /// no value: it is unknown, or the states of its processes differ between runs.
    virtual void identify_question(const std::optional<diagnostics::Digest>& /*digest*/) {}
    /// `decided`: it has an answer.
    virtual void end_question(bool /*decided*/) {}
    /// Called if no assertion follows, and none was left out.
    virtual void all_asked() {}
    /// Where answers of earlier searches of this kind are stored, whose statistics differ from others; null: nowhere.
    [[nodiscard]] virtual diagnostics::Cache* answers() { return nullptr; }
    /// The result of the search in the system. Throws LimitReached, also, with the reason, if the system cannot be
    /// searched in this way.
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
