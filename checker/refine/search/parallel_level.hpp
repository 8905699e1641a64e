// SPDX-License-Identifier: Apache-2.0
// Expands a part of a wide level with several threads, and enters the states found. The result is the same as with one
// thread.
//
// The pairs are divided into blocks. A thread expands pairs of a block, and looks up their targets in the shared table
// while the targets are in its processor cache. New states get provisional numbers in the order of blocks and rows. If
// several threads find the same state, the smallest provisional number wins. When all blocks are done, the new states
// of each block are counted. These counts determine the first final number of each block. Then the threads enter the
// states with their final numbers. So states have the same numbers and the same parents for any number of threads.
// (Laarman, van de Pol and Weber, FMCAD 2010, share a table between threads in this way, but do not number states.)
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "checker/lts/state_store.hpp"
#include "checker/refine/search/expansion.hpp"
#include "checker/refine/search/parent_index.hpp"
#include "checker/refine/search/provisional_states.hpp"
#include "checker/refine/search/thread_team.hpp"

namespace robochart::refine {

class ParallelLevel {
public:
    /// Returns null if the system or the monitor supports only one thread.
    static std::unique_ptr<ParallelLevel> create_if_supported(const lts::TransitionSystem& system, Monitor& monitor,
                                                              lts::StateStore& pairs, unsigned threads);

    enum class Work {
        enter,            ///< enters the targets of transitions
        enter_note_taus,  ///< also records targets of taus that do not lead forward
        examine           ///< looks only for faults of states, because the first forbidden event is known
    };
    /// Processes the pairs from `first` to `end` (exclusive), and returns the pair at which it has stopped. The
    /// function stops at or shortly before a pair with a fault, an error or a forbidden event. It also stops if there
    /// is no more space, or after enough work for one call.
    lts::StateIndex run(lts::StateIndex first, lts::StateIndex end, Work work);
    /// Returns true if the last call stopped at a pair that it cannot process. One thread must then process the next
    /// `pairs_at_once` pairs, or all remaining pairs if there are fewer.
    [[nodiscard]] bool has_stopped() const { return stopped_; }
    static constexpr lts::StateIndex pairs_at_once = 128;
    /// After this call, all threads follow only taus.
    void follow_taus_alone();

    /// The results of expanding one block of pairs.
    struct Block {
        lts::StateIndex first = 0;
        lts::StateIndex pairs = 0;
        std::uint64_t transitions = 0;
        std::uint64_t chased = 0;
        ParentIndex found;                          ///< empty if pairs are only examined
        std::vector<lts::StateIndex> back_targets;  ///< targets of taus that do not lead forward
    };
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] const Block& operator[](std::size_t number) const { return parts_[number]; }

private:
    struct Member {
        std::unique_ptr<lts::TransitionSystem> system;
        std::unique_ptr<Monitor> monitor;
        std::unique_ptr<Expander> expander;
        Expansion expansion;
    };
    struct Part : Block {
        ProvisionalStates claims;
        alignas(64) std::atomic<std::uint32_t> lost = 0;  // written by other threads, so it has its own cache line
        bool stopped = false;
        lts::StateIndex first_number = 0;
    };
    class Claiming;

    ParallelLevel(lts::StateStore& pairs, std::vector<Member> members);
    void share(std::size_t count, const std::function<void(unsigned member, std::size_t number)>& work);
    void make_space();
    void begin(Part& part, lts::StateIndex first);
    void fill_part(Member& member, Part& part, std::size_t number, lts::StateIndex end);
    static bool has_space(Part& part, const Expansion& expansion);
    bool enter_rows(const Expansion& expansion, Part& part, std::size_t number);
    void publish_states(Part& part);
    void give_up(Part& part);

    lts::StateStore& pairs_;
    std::vector<Member> members_;
    ThreadTeam team_;
    std::vector<Part> parts_;
    std::size_t size_ = 0;
    Work work_ = Work::enter;
    bool stopped_ = false;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<std::uint64_t> claimed_ = 0;
    std::atomic<bool> enough_ = false;
};

}  // namespace robochart::refine
