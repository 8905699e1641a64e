// Rows on their way to the ranks that they belong to.
#pragma once

#include <functional>

#include "checker/refine/levels/exchange.hpp"

namespace robochart::refine {

/// For each rank a message: how many of its rows a tau has led to, these rows, the other rows.
class RowBatches {
public:
    RowBatches(unsigned ranks, std::size_t width) : width_(width), by_tau_(ranks), others_(ranks), out_(ranks) {}

    void add(unsigned rank, lts::StateView row, bool by_tau) {
        Words& words = (by_tau ? by_tau_ : others_)[rank];
        words.insert(words.end(), row.begin(), row.end());
        largest_ = std::max(largest_, words.size());
        ++rows_;
    }
    /// Whether a message has reached 64 KiB: time to send.
    [[nodiscard]] bool full() const { return largest_ * sizeof(lts::Word) >= std::size_t{1} << 16U; }
    /// How many rows there were, of all messages.
    [[nodiscard]] std::uint64_t rows() const { return rows_; }
    /// Sends all, and gets what the others have sent.
    void exchange(Exchange& with);
    /// Gives what has come, row by row, with its hash; several rows are asked for (`prefetch`) before the first is
    /// given.
    void receive(const std::function<void(std::uint64_t hash)>& prefetch,
                 const std::function<void(lts::StateView row, std::uint64_t hash, bool by_tau)>& enter);
    /// In memory.
    [[nodiscard]] std::uint64_t bytes() const;

private:
    std::size_t width_;
    std::size_t largest_ = 0;
    std::uint64_t rows_ = 0;
    std::vector<Words> by_tau_, others_;  // by rank
    std::vector<Words> out_, in_;
};

}  // namespace robochart::refine
