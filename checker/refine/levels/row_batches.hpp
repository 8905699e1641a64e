// Rows on their way to the ranks that they belong to.
#pragma once

#include <algorithm>

#include "checker/refine/levels/exchange.hpp"
#include "checker/refine/levels/hashed_rows.hpp"

namespace robochart::refine {

/// For each rank a message: how many of its rows no tau has led to, these rows, the rows that a tau has led to.
class RowBatches {
public:
    RowBatches(unsigned ranks, std::size_t width) : width_(width), by_tau_(ranks), out_(ranks) {}

    void add(unsigned rank, lts::StateView row, bool by_tau) {
        Words& words = (by_tau ? by_tau_ : out_)[rank];
        if (!by_tau && words.empty()) words.push_back(0);
        for (const lts::Word word : row) words.push_back(word);  // few
        largest_ = std::max(largest_, words.size());
        ++waiting_;
    }
    /// Whether a message has reached 64 KiB, or all together this many bytes: time to send.
    [[nodiscard]] bool full(std::uint64_t bytes) const {
        return largest_ * sizeof(lts::Word) >= std::size_t{1} << 16U || waiting_ * width_ * sizeof(lts::Word) >= bytes;
    }
    /// How many rows there were, of all messages.
    [[nodiscard]] std::uint64_t rows() const { return rows_ + waiting_; }
    /// Sends all, and gets what the others have sent.
    void exchange(Exchange& with);
    /// Gives what has come, row by row, with its hash; several rows are asked for before the first is given.
    /// `prefetch(hash)`, `enter(row, hash, by_tau)`.
    template <class Prefetch, class Enter>
    void receive(const Prefetch& prefetch, const Enter& enter) const {
        for (const Words& message : in_) {
            if (message.empty()) continue;
            std::size_t row = 0;
            each_hashed(lts::StateView(message).subspan(1), width_, prefetch,
                        [&](lts::StateView words, auto hash) { enter(words, hash, row++ >= message[0]); });
        }
    }
    /// In memory.
    [[nodiscard]] std::uint64_t bytes() const;

private:
    std::size_t width_;
    std::size_t largest_ = 0;
    std::uint64_t waiting_ = 0;  // rows that have not been sent
    std::uint64_t rows_ = 0;     // that have
    std::vector<Words> by_tau_;  // by rank
    std::vector<Words> out_;     // by rank: the number, still 0, and the other rows
    std::vector<Words> in_;
};

}  // namespace robochart::refine
