// SPDX-License-Identifier: Apache-2.0
// Defines how the ranks of a search communicate. Each rank owns a part of the rows. All calls are collective: all ranks
// make the same calls in the same order.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "checker/lts/transition_system.hpp"

namespace robochart::refine {

using Words = std::vector<lts::Word>;

/// Returns the rank that owns a row with this hash (lts::StateStore::hash). The result is less than `ranks` and the
/// same in every run. The function mixes the bits of the hash, because otherwise the rows of a rank would fill only a
/// part of its table.
[[nodiscard]] inline unsigned owner_of(std::uint64_t hash, unsigned ranks) {
    hash = (hash ^ hash >> 29U) * 0xBF58476D1CE4E5B9ULL;
    return static_cast<unsigned>((hash >> 32U) * ranks >> 32U);
}

/// The messages to all ranks, or the messages from all ranks, in one block of memory.
struct Messages {
    explicit Messages(unsigned ranks) : begins(ranks), sizes(ranks) {}
    [[nodiscard]] lts::StateView message_of(unsigned rank) const { return {words.data() + begins[rank], sizes[rank]}; }

    Words words;
    std::vector<std::size_t> begins, sizes;  ///< by rank: position and size of its message
};

class Exchange {
public:
    Exchange() = default;
    Exchange(const Exchange&) = delete;
    Exchange& operator=(const Exchange&) = delete;
    virtual ~Exchange() = default;

    /// Returns the number of this rank, counted from 0.
    [[nodiscard]] virtual unsigned rank() const = 0;
    [[nodiscard]] virtual unsigned ranks() const = 0;
    /// Returns the number of ranks that are threads of this program and share its memory.
    [[nodiscard]] virtual unsigned ranks_here() const { return 1; }

    /// Sends each message in `out` to its rank. Stores the messages from all ranks in `in`. All messages together must
    /// have fewer than 2^31 words.
    virtual void all_to_all(const Messages& out, Messages& in) = 0;
    /// Replaces each value by its sum over all ranks.
    virtual void sum(std::span<std::uint64_t> values) = 0;
    /// All-gather: returns the words `own` of all ranks, at every rank. The function is intended for few words.
    [[nodiscard]] virtual std::vector<Words> gather(const Words& own) = 0;
    /// Broadcast: replaces the bytes by those of rank 0. A rank may wait long, and uses no processor time while it
    /// waits.
    virtual void broadcast(std::string& bytes) = 0;

    /// Statistics about the messages that this rank has sent to others by all_to_all.
    struct Traffic {
        std::uint64_t bytes = 0;
        std::uint64_t messages = 0;  ///< number of nonempty messages
        std::uint64_t rounds = 0;
    };
    [[nodiscard]] const Traffic& traffic() const { return traffic_; }
    /// Returns the memory use of messages in transit.
    [[nodiscard]] virtual std::uint64_t bytes() const { return 0; }

    /// Records that all ranks stop their current work together (SharedWork). The next `begin_together` deletes this
    /// record.
    virtual void leave_together() { left_together_ = true; }
    virtual void begin_together() { left_together_ = false; }
    [[nodiscard]] virtual bool left_together() const { return left_together_; }

protected:
    void count_messages(const Messages& out);

private:
    Traffic traffic_;
    bool left_together_ = false;
};

/// The exchange of a search that has only one rank.
class LoneExchange final : public Exchange {
public:
    [[nodiscard]] unsigned rank() const override { return 0; }
    [[nodiscard]] unsigned ranks() const override { return 1; }
    void all_to_all(const Messages& out, Messages& in) override { in = out; }
    void sum(std::span<std::uint64_t> /*values*/) override {}
    [[nodiscard]] std::vector<Words> gather(const Words& own) override { return {own}; }
    void broadcast(std::string& /*bytes*/) override {}
};

}  // namespace robochart::refine
