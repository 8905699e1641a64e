// A part of a wide level, expanded and entered by several threads, with the outcome of one. First all expand; then each
// enters the rows that fall into its own segments of the table, in the order in which one thread would have met them,
// under numbers for the time being; the final numbers are counted out in that order. So states have the same numbers
// and the same parents whatever the number of threads, and no two threads ever write to one place.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "checker/lts/state_store.hpp"
#include "checker/refine/expansion.hpp"
#include "checker/refine/team.hpp"

namespace robochart::refine {

class WideLevel {
public:
    /// Null where system or monitor serve one thread only.
    static std::unique_ptr<WideLevel> make(const lts::TransitionSystem& system, Monitor& monitor,
                                           lts::StateStore& pairs, unsigned threads);

    /// Expands pairs from `first` on and returns where it has stopped.
    lts::StateIndex expand(lts::StateIndex first, lts::StateIndex end);
    /// The expansions made, of pairs in a row.
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] const Expansion& operator[](std::size_t number) const { return parts_[number].expansion; }
    [[nodiscard]] bool eventful() const;

    /// Enters all rows into the store.
    void enter();
    /// After that: how many states a pair has found, and the number of a row's state.
    [[nodiscard]] std::uint32_t found(std::size_t number, std::size_t pair) const { return parts_[number].found[pair]; }
    [[nodiscard]] lts::StateIndex target(std::size_t number, std::size_t row) const;

private:
    struct Member {
        std::unique_ptr<lts::TransitionSystem> system;
        std::unique_ptr<Monitor> monitor;
        std::unique_ptr<Expander> expander;
    };
    struct Fresh {
        std::uint32_t row;
        lts::IndexTable::Slot slot;
    };
    struct Part {
        Expansion expansion;
        std::vector<std::vector<std::uint32_t>> rows_of;  // each member, ascending
        std::vector<std::vector<Fresh>> fresh_of;
        std::vector<lts::StateIndex> numbers;  // of each row, as claimed
        std::vector<lts::StateIndex> finals;   // of fresh rows
        std::vector<std::uint32_t> found;      // by each pair
        lts::StateIndex first_fresh = 0;
    };
    WideLevel(lts::StateStore& pairs, std::vector<Member> members);
    void each_part(const std::function<void(unsigned member, Part& part, std::size_t number)>& work);
    void divide(Part& part) const;
    void claim(unsigned member);
    void claim(unsigned member, std::size_t number);
    void publish(Part& part);

    lts::StateStore& pairs_;
    std::vector<Member> members_;
    Team team_;
    std::vector<Part> parts_;
    std::size_t size_ = 0;
    std::size_t known_ = 0;       // states before `enter`; claims have numbers from here on:
    std::uint32_t row_bits_ = 0;  // the part's number, then so many bits for the row's
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> full_ = false;
};

}  // namespace robochart::refine
