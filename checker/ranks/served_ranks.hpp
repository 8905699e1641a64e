// SPDX-License-Identifier: Apache-2.0
// Distributes searches to several programs, or to threads that act like programs. The first program parses, evaluates
// and compiles. For each search, it sends the data to the other programs (job.hpp), which wait between searches. Every
// program searches with several threads.
#pragma once

#include <string>
#include <utility>

#include "checker/refine/verdict/level_strategy.hpp"

namespace robochart::ranks {

/// Used by the first program. The other ranks of the exchange run serve_searches until this object is destroyed.
/// The exchange must outlive the object. Each program searches with Limits::threads threads, or with one if this is
/// 0.
class ServedRanks final : public refine::LevelStrategy {
public:
    /// `program` is the identity of this program. The other ranks reject searches of a program with another identity.
    ServedRanks(refine::Exchange& exchange, std::string program) : exchange_(exchange), program_(std::move(program)) {}
    ServedRanks(const ServedRanks&) = delete;
    ServedRanks& operator=(const ServedRanks&) = delete;
    ~ServedRanks() override;

    /// Ends the other ranks. Afterwards, no search is possible. If the caller has not called it, the destructor does so
    /// and ignores its exceptions.
    void end();
    /// Searches the system together with the other ranks. If the process was not compiled, only one thread of the first
    /// program searches it.
    std::optional<refine::Violation> search(lts::TransitionSystem& system, const refine::LevelQuestion& question,
                                            refine::Budget& budget, refine::Statistics& statistics) override;
    /// Returns true if a search has failed at this rank alone, so that the other ranks wait for it. No further search
    /// is possible then, and the other programs will not end by themselves.
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

/// Every program except the first one runs this function. It takes part in each search until rank 0 ends. The first
/// program reports why a search ended. This function throws only errors that occur in its own program while the other
/// ranks wait for this program. `program`: the identity of this program. If another version has sent the search, its
/// rows and messages may have another form, so all ranks leave the search together (storage::BadFile).
void serve_searches(refine::Exchange& exchange, const std::string& program);

}  // namespace robochart::ranks
