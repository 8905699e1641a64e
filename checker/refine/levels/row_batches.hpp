// SPDX-License-Identifier: Apache-2.0
// Collects rows in order to send them to their owners.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <vector>

#include "checker/refine/levels/exchange.hpp"
#include "checker/refine/levels/hashed_rows.hpp"

namespace robochart::refine {

/// Builds one message for each rank. A message contains the number of rows that are not targets of taus, then these
/// rows, and then the targets of taus.
class RowBatches {
public:
    RowBatches(unsigned ranks, std::size_t width);

    void add(unsigned rank, lts::StateView row, bool by_tau) {
        Message& message = messages_[rank];
        assert(row.size() == width_);
        if (message.front + message.back + width_ > space_) make_space();
        assert(message.front + message.back + width_ <= space_);
        std::size_t at = begin_of(rank);
        if (by_tau) {
            message.back += width_;
            at += space_ - message.back;
        } else {
            at += message.front;
            message.front += width_;
        }
        for (std::size_t i = 0; i < width_; ++i) out_.words[at + i] = row[i];  // a loop is fast, because rows are short
        largest_ = std::max(largest_, message.front + message.back);
        ++waiting_;
    }
    /// Returns true if it is time to send the messages: one message has reached 64 KiB, or all messages together have
    /// this many bytes.
    [[nodiscard]] bool is_full(std::uint64_t bytes) const {
        return largest_ * sizeof(lts::Word) >= std::size_t{1} << 16U || waiting_ * width_ * sizeof(lts::Word) >= bytes;
    }
    /// Returns the number of rows in all messages so far.
    [[nodiscard]] std::uint64_t rows() const { return rows_ + waiting_; }
    /// Sends all messages, and receives the messages of the other ranks.
    void exchange(Exchange& with);
    /// Passes the received rows one by one with their hashes to `enter(row, hash, by_tau)`. Calls `prefetch(hash)` for
    /// several rows before it passes the first row.
    template <class Prefetch, class Enter>
    void receive(const Prefetch& prefetch, const Enter& enter) const {
        for (unsigned rank = 0; rank < messages_.size(); ++rank) {
            const lts::StateView message = in_.message_of(rank);
            if (message.empty()) continue;
            assert((message.size() - 1) % width_ == 0 && message[0] * width_ < message.size());
            std::size_t row = 0;
            each_hashed(message.subspan(1), width_, prefetch,
                        [&](lts::StateView words, auto hash) { enter(words, hash, row++ >= message[0]); });
        }
    }
    /// Returns the memory use in bytes.
    [[nodiscard]] std::uint64_t bytes() const {
        return (out_.words.capacity() + in_.words.capacity()) * sizeof(lts::Word);
    }

private:
    /// Describes the space for the message to one rank. The first word is the number of rows that are not targets of
    /// taus; it is written when the message is complete. These rows follow the first word. The targets of taus are at
    /// the end of the space.
    struct Message {
        std::size_t front = 1;
        std::size_t back = 0;
    };
    [[nodiscard]] std::size_t begin_of(unsigned rank) const { return rank * space_; }
    void make_space();

    std::size_t width_;
    std::size_t space_;  // number of words of each message
    std::size_t largest_ = 0;
    std::uint64_t waiting_ = 0;  // number of rows that have not been sent
    std::uint64_t rows_ = 0;     // number of rows that have been sent
    std::vector<Message> messages_;
    Messages out_, in_;
};

}  // namespace robochart::refine
