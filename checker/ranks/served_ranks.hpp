// Programs of their own, or threads as such, that share searches: the first one reads, evaluates and compiles, and for
// each search sends the others what they need (job.hpp); in between they wait. In each program several threads search.
#pragma once

#include <string>
#include <utility>

#include "checker/refine/verdict/level_strategy.hpp"

namespace robochart::ranks {

/// The first program's side. The others of the exchange, which outlives it, are in `serve` meanwhile, until it is
/// destroyed; unless they wait. In each program so many threads search as Limits::threads says, or one where that is 0.
class ServedRanks final : public refine::LevelStrategy {
public:
    /// `program`: the identity of this program. The others refuse searches of another one.
    ServedRanks(refine::Exchange& exchange, std::string program) : exchange_(exchange), program_(std::move(program)) {}
    ServedRanks(const ServedRanks&) = delete;
    ServedRanks& operator=(const ServedRanks&) = delete;
    ~ServedRanks() override;

    /// No search follows: the others end. Called by the destructor if it has not been called, which keeps what it
    /// throws.
    void end();
    /// A process that is not compiled, but stays a term, is searched by one thread of the first program alone.
    std::optional<refine::Violation> search(lts::TransitionSystem& system, const refine::LevelQuestion& question,
                                            refine::Budget& budget, refine::Statistics& statistics) override;
    /// An error has ended a search at this rank alone. The others wait for it: no further search is possible, and they
    /// do not end by themselves.
    [[nodiscard]] bool others_wait() const { return others_wait_; }

private:
    std::optional<refine::Violation> search_together(lts::TransitionSystem& system,
                                                     const refine::LevelQuestion& question, const std::string& job,
                                                     unsigned threads, refine::Budget& budget,
                                                     refine::Statistics& statistics);

    refine::Exchange& exchange_;
    std::string program_;
    bool others_wait_ = false;
    bool ended_ = false;
};

/// What every other program does: takes its part in each search, until rank 0 has no more. What ends a search is the
/// first one's to report. Throws what has ended it in this program alone, since the others wait for it. `program`: its
/// identity. Where another program has sent the search, which may have other rows and exchange other things, all leave
/// it together (storage::BadFile).
void serve(refine::Exchange& exchange, const std::string& program);

}  // namespace robochart::ranks
