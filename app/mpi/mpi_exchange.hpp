// SPDX-License-Identifier: Apache-2.0
// Exchanges data between programs that MPI started as ranks. Only functions of MPI-3 are called, from one thread.
#pragma once

#include "checker/refine/levels/exchange.hpp"

namespace robochart::app {

/// Initialises MPI, and finalises it when destroyed. A program may create only one object. If an exception would end a
/// rank while others wait for it, `abort` must be called.
class MpiProgram {
public:
    MpiProgram(int& argc, char**& argv);
    MpiProgram(const MpiProgram&) = delete;
    MpiProgram& operator=(const MpiProgram&) = delete;
    /// Waits for the other ranks.
    ~MpiProgram();
    /// True if MPI allows several threads, but only the thread that initialised MPI may call it.
    [[nodiscard]] static bool serves_threads();
    /// Ends all ranks at once.
    [[noreturn]] static void abort(int code);
};

/// Exchange between all ranks. A rank that waits for a broadcast sleeps, because rank 0 may work for a long time.
class MpiExchange final : public refine::Exchange {
public:
    MpiExchange();
    [[nodiscard]] unsigned rank() const override { return rank_; }
    [[nodiscard]] unsigned ranks() const override { return ranks_; }
    void all_to_all(const refine::Messages& out, refine::Messages& in) override;
    void sum(std::span<std::uint64_t> values) override;
    [[nodiscard]] std::vector<refine::Words> gather(const refine::Words& own) override;
    void broadcast(std::string& bytes) override;

private:
    unsigned rank_ = 0;
    unsigned ranks_ = 1;
    refine::Words received_;  // the words of all ranks, stored consecutively
    std::vector<int> send_counts_, send_places_, counts_, places_;
};

}  // namespace robochart::app
