// Programs that MPI has started as ranks. Calls of MPI-3 alone, by one thread.
#pragma once

#include "checker/refine/levels/exchange.hpp"

namespace robochart::app {

/// MPI while it lives; one in a program. An exception that would leave a rank while others wait for it is for `abort`.
class MpiProgram {
public:
    MpiProgram(int& argc, char**& argv);
    MpiProgram(const MpiProgram&) = delete;
    MpiProgram& operator=(const MpiProgram&) = delete;
    /// Waits for the other ranks.
    ~MpiProgram();
    /// Whether a program may have several threads, of which the one that has begun MPI calls it.
    [[nodiscard]] static bool serves_threads();
    /// Ends all ranks at once.
    [[noreturn]] static void abort(int code);
};

/// All programs, each as one rank. While they wait for a broadcast they sleep: rank 0 may be at work for long.
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
    refine::Words received_;  // of all ranks, side by side
    std::vector<int> send_counts_, send_places_, counts_, places_;
};

}  // namespace robochart::app
