// What the ranks of a search, each with a part of the rows, tell each other. All calls are collective: every rank makes
// the same ones in the same order.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "checker/lts/transition_system.hpp"

namespace robochart::refine {

using Words = std::vector<lts::Word>;

/// The rank, below `ranks`, that a row belongs to, by its hash (lts::StateStore::hash): the same in every run. The hash
/// is mixed once more, so that the rows of a rank are spread over its table.
[[nodiscard]] inline unsigned owner_of(std::uint64_t hash, unsigned ranks) {
    hash = (hash ^ hash >> 29U) * 0xBF58476D1CE4E5B9ULL;
    return static_cast<unsigned>((hash >> 32U) * ranks >> 32U);
}

/// A message for, or from, each rank, all in one piece of memory.
struct Messages {
    explicit Messages(unsigned ranks) : begins(ranks), sizes(ranks) {}
    [[nodiscard]] lts::StateView of(unsigned rank) const { return {words.data() + begins[rank], sizes[rank]}; }

    Words words;
    std::vector<std::size_t> begins, sizes;  ///< by rank: where its message lies
};

class Exchange {
public:
    Exchange() = default;
    Exchange(const Exchange&) = delete;
    Exchange& operator=(const Exchange&) = delete;
    virtual ~Exchange() = default;

    /// This rank, from 0 on.
    [[nodiscard]] virtual unsigned rank() const = 0;
    [[nodiscard]] virtual unsigned ranks() const = 0;
    /// How many of the ranks are threads of this program: they share its memory.
    [[nodiscard]] virtual unsigned ranks_here() const { return 1; }

    /// Sends `out.of(r)` to each rank r, and gives in `in.of(r)` what r has sent here. Fewer than 2^31 words all
    /// together.
    virtual void all_to_all(const Messages& out, Messages& in) = 0;
    /// Replaces each value by the sum of all ranks' values in its place.
    virtual void sum(std::span<std::uint64_t> values) = 0;
    /// What each rank has given, at every rank. For few words.
    [[nodiscard]] virtual std::vector<Words> gather(const Words& own) = 0;
    /// Replaces the bytes by those of rank 0. A rank may wait for long without using its processor.
    virtual void broadcast(std::string& bytes) = 0;

    /// What this rank has sent to others by all_to_all.
    struct Traffic {
        std::uint64_t bytes = 0;
        std::uint64_t messages = 0;  ///< that were not empty
        std::uint64_t rounds = 0;
    };
    [[nodiscard]] const Traffic& traffic() const { return traffic_; }
    /// In memory, for messages on their way.
    [[nodiscard]] virtual std::uint64_t bytes() const { return 0; }

    /// All ranks know that all leave what they do together (SharedWork), until `begin_together`.
    virtual void leave_together() { left_together_ = true; }
    virtual void begin_together() { left_together_ = false; }
    [[nodiscard]] virtual bool left_together() const { return left_together_; }

protected:
    void count(const Messages& out);

private:
    Traffic traffic_;
    bool left_together_ = false;
};

/// One rank alone.
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
