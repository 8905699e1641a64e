// SPDX-License-Identifier: Apache-2.0
// Separate programs, or threads that act like programs, that share searches. The first one parses, evaluates and
// compiles, and for each search sends the others what they need (job.hpp); between searches they wait. Several threads
// search in each program.
#pragma once

#include <string>
#include <utility>

#include "checker/refine/verdict/level_strategy.hpp"

namespace robochart::ranks {

/// The first program's side. Meanwhile the other ranks of the exchange, which must outlive the object, are in `serve`
/// until the object is destroyed, unless they wait. The number of search threads in each program is Limits::threads, or
/// one if that is 0.
class ServedRanks final : public refine::LevelStrategy {
public:
    /// `program`: the identity of this program. The others reject searches of another program.
    ServedRanks(refine::Exchange& exchange, std::string program) : exchange_(exchange), program_(std::move(program)) {}
    ServedRanks(const ServedRanks&) = delete;
    ServedRanks& operator=(const ServedRanks&) = delete;
    ~ServedRanks() override;

    /// Ends the other ranks; no search follows. The destructor calls it if it has not been called, and then discards
    /// its exceptions.
    void end();
    /// A process that is not compiled, but stays a term, is searched by one thread of the first program only.
    std::optional<refine::Violation> search(lts::TransitionSystem& system, const refine::LevelQuestion& question,
                                            refine::Budget& budget, refine::Statistics& statistics) override;
    /// Whether an error has ended a search at this rank only. The others wait for it: no further search is possible,
    /// and they do not end by themselves.
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

/// Runs in every other program: takes part in each search until rank 0 ends. The first program reports what ends a
/// search. Throws errors that occur only in this program, since the others wait for it. `program`: its identity. If
/// another program has sent the search, rows and messages may differ, so all ranks leave it together
/// (storage::BadFile).
void serve(refine::Exchange& exchange, const std::string& program);

}  // namespace robochart::ranks
