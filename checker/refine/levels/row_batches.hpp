// Rows on their way to the ranks that they belong to.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "checker/refine/levels/exchange.hpp"
#include "checker/refine/levels/hashed_rows.hpp"

namespace robochart::refine {

/// For each rank a message: how many of its rows no tau has led to, these rows, the rows that a tau has led to.
class RowBatches {
public:
    RowBatches(unsigned ranks, std::size_t width);

    void add(unsigned rank, lts::StateView row, bool by_tau) {
        Message& message = messages_[rank];
        if (message.front + message.back + width_ > space_) make_space();
        std::size_t at = begin_of(rank);
        if (by_tau) {
            message.back += width_;
            at += space_ - message.back;
        } else {
            at += message.front;
            message.front += width_;
        }
        for (std::size_t i = 0; i < width_; ++i) out_.words[at + i] = row[i];  // few
        largest_ = std::max(largest_, message.front + message.back);
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
        for (unsigned rank = 0; rank < messages_.size(); ++rank) {
            const lts::StateView message = in_.of(rank);
            if (message.empty()) continue;
            std::size_t row = 0;
            each_hashed(message.subspan(1), width_, prefetch,
                        [&](lts::StateView words, auto hash) { enter(words, hash, row++ >= message[0]); });
        }
    }
    /// In memory.
    [[nodiscard]] std::uint64_t bytes() const {
        return (out_.words.capacity() + in_.words.capacity()) * sizeof(lts::Word);
    }

private:
    /// Words used of a rank's space: from its front on the number, still unknown, and the rows that no tau has led to;
    /// up to its end the others.
    struct Message {
        std::size_t front = 1;
        std::size_t back = 0;
    };
    [[nodiscard]] std::size_t begin_of(unsigned rank) const { return rank * space_; }
    void make_space();

    std::size_t width_;
    std::size_t space_;  // words of each message
    std::size_t largest_ = 0;
    std::uint64_t waiting_ = 0;  // rows that have not been sent
    std::uint64_t rows_ = 0;     // that have
    std::vector<Message> messages_;
    Messages out_, in_;
};

}  // namespace robochart::refine
