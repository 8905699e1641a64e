// SPDX-License-Identifier: Apache-2.0
// Expands pairs. Computes the successors of several consecutive pairs before any successor is looked up. So several
// look-ups can access memory at the same time, and several threads can compute successors.
#pragma once

#include <array>
#include <cassert>
#include <exception>
#include <optional>
#include <vector>

#include "checker/lts/state_store.hpp"
#include "checker/refine/search/monitor.hpp"

namespace robochart::refine {

/// The results of expanding pairs of one level. A row is the target of a transition: the monitor's node, if the monitor
/// has nodes, and the state.
class Expansion {
public:
    struct Pair {
        std::uint32_t end_row;  ///< end of its rows, which follow those of the previous pair
        std::uint32_t transitions;
        std::uint64_t chased;  ///< number of left-out states (lts::TransitionSystem::chased)
        std::optional<ViolationKind> fault;
        std::optional<process::Event> forbidden;  ///< the first forbidden event; no rows follow it
    };

    void clear(std::size_t width);
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] lts::StateView row(std::size_t number) const {
        assert(number < size_);
        return {&words_[number * width_], width_};
    }
    [[nodiscard]] std::uint64_t hash(std::size_t number) const { return hashes_[number]; }
    [[nodiscard]] bool by_tau(std::size_t number) const { return by_tau_[number] != 0; }
    /// Appends a row, which the caller must fill in.
    std::span<lts::Word> add(bool by_tau);
    void set_hash(std::uint64_t hash) {
        assert(size_ > 0);
        hashes_[size_ - 1] = hash;
    }
    void shrink_to(std::size_t size) {
        assert(size <= size_);
        size_ = size;
    }

    /// Returns true if there are results other than rows.
    [[nodiscard]] bool has_findings() const;
    /// Returns true if there are results other than rows and forbidden events.
    [[nodiscard]] bool has_faults() const;

    std::vector<Pair> pairs;
    std::exception_ptr error;  ///< thrown by the pair after the last of `pairs`

private:
    std::size_t width_ = 0;
    std::size_t size_ = 0;
    std::vector<lts::Word> words_;
    std::vector<std::uint64_t> hashes_;
    std::vector<std::uint8_t> by_tau_;
};

/// The number of rows that are computed before any row is looked up. So many rows fit into the processor's cache.
inline constexpr std::size_t rows_at_once = 256;

/// Expands pairs and passes their events to the monitor.
class Expander final : private lts::SuccessorSink {
public:
    Expander(lts::TransitionSystem& system, Monitor& monitor, const lts::StateStore& pairs);

    /// Expands pairs from `first` on, until `end` is reached, there are enough rows, or a pair has failed with an
    /// error.
    void expand(lts::StateIndex first, lts::StateIndex end, std::size_t enough_rows, Expansion& out);
    /// Expands one more pair, whose words are given. Before the call, `out` must be cleared for rows of this width. If
    /// the system throws an exception, the function removes the rows of the pair and passes the exception on.
    void expand(lts::StateView words, Expansion& out);
    /// After this call, the expander follows only taus.
    void follow_taus_alone() { taus_alone_ = true; }

private:
    void add(process::Event event, lts::StateView target, process::Event revealed) override;
    void add_row(Monitor::Node node, lts::StateView target, bool by_tau);
    void expand_into(lts::StateView words);
    Monitor::Advance advance(process::Event event);
    void settle_offer();

    struct Remembered {
        Monitor::Node node = 0;
        process::Event event = process::tau;  // tau if the entry is empty
        Monitor::Advance advance{};
    };
    lts::TransitionSystem& system_;
    Monitor& monitor_;
    const lts::StateStore& pairs_;
    const bool nodes_;
    std::array<Remembered, 4096> memory_{};

    Expansion* out_ = nullptr;
    Expansion::Pair pair_{};
    Monitor::Node node_ = 0;
    Offer offer_;
    bool taus_alone_ = false;
};

}  // namespace robochart::refine
