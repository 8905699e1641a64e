// Searches that go by levels (levels/level_search.hpp) instead of the ordinary search: several ranks, or rows kept in
// files. Limits::by_levels names the strategy; what it is asked is data, so that it can be sent to other programs.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "checker/refine/levels/level_search.hpp"
#include "checker/refine/levels/row_keeping.hpp"
#include "checker/refine/verdict/findings.hpp"
#include "checker/refine/verdict/normal_table.hpp"
#include "diagnostics/cache/cache.hpp"

namespace robochart::refine {

/// What a search looks for, and where it keeps its rows.
struct LevelQuestion {
    enum class Kind : std::uint8_t { states, deadlock, choice, refinement };
    Kind kind = Kind::states;                          ///< states: nothing, every state is seen
    Model model = Model::traces;                       ///< of a refinement
    std::shared_ptr<const NormalTable> specification;  ///< of a refinement; else null
    bool divergence = false;                           ///< then, if nothing is found, a cycle of taus
    std::uint64_t events_until = std::numeric_limits<std::uint64_t>::max();  ///< LevelSearch::first_violation
    RowKeeping rows = {};

    /// Whether rows begin with a node.
    [[nodiscard]] bool has_nodes() const { return kind == Kind::choice || kind == Kind::refinement; }
    /// Words of a row, for a system of this width.
    [[nodiscard]] std::size_t row_width(std::size_t state_width) const { return state_width + (has_nodes() ? 1 : 0); }
};

[[nodiscard]] std::unique_ptr<Monitor> monitor_of(const LevelQuestion& question);

/// One rank's part of a search; collective. What is found is added to the statistics, also if a limit ends it. Where a
/// rank cannot make the store of its rows, all leave the search together (SharedWork). Rows that are kept in files: it
/// ends when no rank has one of them open any more, and the first rank has Limits::undisturbed while it waits.
std::optional<Violation> search_as_rank(lts::TransitionSystem& system, const LevelQuestion& question,
                                        Exchange& exchange, Budget& budget, Statistics& statistics);

/// How many threads of a program can search the system, of so many wanted: one where it serves one thread only.
[[nodiscard]] unsigned threads_for(const lts::TransitionSystem& system, unsigned wanted);

/// One program's part of a search, by so many threads as ranks, of which the first is the caller's (as_ranks);
/// collective of `programs`. Each thread has rows of its own. The budget and the statistics are the first thread's;
/// the others have the same limits, without progress.
std::optional<Violation> search_by_threads(Exchange& programs, unsigned threads, lts::TransitionSystem& system,
                                           const LevelQuestion& question, Budget& budget, Statistics& statistics);

/// How the searches of a check go by levels.
class LevelStrategy {
public:
    LevelStrategy() = default;
    LevelStrategy(const LevelStrategy&) = delete;
    LevelStrategy& operator=(const LevelStrategy&) = delete;
    virtual ~LevelStrategy() = default;
    /// This question is asked next. Nothing of it need be worked out yet.
    virtual void begin_question(const std::string& /*text*/) {}
    /// The searches that follow belong to the question begun. The digest is of all that its answer depends on; none:
    /// that is not known, or the states of its processes are not the same in every run.
    virtual void identify_question(const std::optional<diagnostics::Digest>& /*digest*/) {}
    /// `decided`: it has its answer.
    virtual void end_question(bool /*decided*/) {}
    /// No question follows, and none was left out.
    virtual void all_asked() {}
    /// Where answers of earlier searches of this kind are kept, which have other figures than others; null: nowhere.
    [[nodiscard]] virtual diagnostics::Cache* answers() { return nullptr; }
    /// What the question's search finds in the system. Throws LimitReached, also where the system cannot be searched in
    /// this way, and says why.
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
