// Ranks that are programs of their own, or threads as such: rank 0 reads, evaluates and compiles, and for each search
// sends the others what they need (job.hpp); in between they wait.
#pragma once

#include "checker/refine/verdict/level_strategy.hpp"

namespace robochart::ranks {

/// Rank 0's side. The other ranks of the exchange, which outlives it, are in `serve` meanwhile, until it is destroyed;
/// unless they wait.
class ServedRanks final : public refine::LevelStrategy {
public:
    explicit ServedRanks(refine::Exchange& exchange) : exchange_(exchange) {}
    ServedRanks(const ServedRanks&) = delete;
    ServedRanks& operator=(const ServedRanks&) = delete;
    ~ServedRanks() override;

    /// No search follows: the others end. Called by the destructor if it has not been called, which keeps what it
    /// throws.
    void end();
    /// A process that is not compiled, but stays a term, is searched by rank 0 alone.
    std::optional<refine::Violation> search(lts::TransitionSystem& system, const refine::LevelQuestion& question,
                                            refine::Budget& budget, refine::Statistics& statistics) override;
    /// An error has ended a search at this rank alone. The others wait for it: no further search is possible, and they
    /// do not end by themselves.
    [[nodiscard]] bool others_wait() const { return others_wait_; }

private:
    std::optional<refine::Violation> search_together(lts::TransitionSystem& system,
                                                     const refine::LevelQuestion& question, const std::string& job,
                                                     refine::Budget& budget, refine::Statistics& statistics);

    refine::Exchange& exchange_;
    bool others_wait_ = false;
    bool ended_ = false;
};

/// What every other rank does: takes its part in each search, until rank 0 has no more. What ends a search is rank 0's
/// to report. Throws what has ended it at this rank alone, since the others wait for it.
void serve(refine::Exchange& exchange);

}  // namespace robochart::ranks
