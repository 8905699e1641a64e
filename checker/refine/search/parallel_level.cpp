// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/search/parallel_level.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <new>

namespace robochart::refine {

using lts::StateIndex;

namespace {

constexpr std::size_t most_parts = 128;
static_assert(most_parts * ProvisionalStates::most == lts::StateStore::most_claims);
/// If there is space for fewer new states than this, a parallel call does not pay off.
constexpr std::uint64_t min_space = 4096;
/// The maximal time between checks of the limits.
constexpr std::chrono::milliseconds longest{20};

}  // namespace

/// Stores the claims of one part, with the API that lts::StateStore needs.
class ParallelLevel::Claiming {
public:
    Claiming(std::vector<Part>& parts, std::size_t number) : parts_(parts), own_(parts[number]), number_(number) {}
    [[nodiscard]] StateIndex next_claim() const {
        return lts::StateStore::first_claim + static_cast<StateIndex>(number_ * ProvisionalStates::most) +
               own_.claims.size();
    }
    [[nodiscard]] const lts::Word* row(StateIndex claim) const {
        return part_of_claim(claim).claims.row(place_in_part(claim));
    }
    void keep_state(lts::StateView state) { own_.claims.store_state(state); }
    void lose_claim(StateIndex claim) {
        part_of_claim(claim).claims.mark_lost(place_in_part(claim));
        part_of_claim(claim).lost.fetch_add(1, std::memory_order_relaxed);
    }

private:
    static std::uint32_t place_in_part(StateIndex claim) {
        return (claim - lts::StateStore::first_claim) % ProvisionalStates::most;
    }
    [[nodiscard]] Part& part_of_claim(StateIndex claim) const {
        assert(claim >= lts::StateStore::first_claim && claim != lts::no_state);
        return parts_[(claim - lts::StateStore::first_claim) / ProvisionalStates::most];
    }
    std::vector<Part>& parts_;
    Part& own_;
    std::size_t number_;
};

std::unique_ptr<ParallelLevel> ParallelLevel::create_if_supported(const lts::TransitionSystem& system, Monitor& monitor,
                                                                  lts::StateStore& pairs, unsigned threads) {
    std::vector<Member> members(threads);
    for (Member& member : members) {
        member.system = system.clone_for_thread();
        member.monitor = monitor.clone_for_thread();
        if (!member.system || !member.monitor) return nullptr;
        member.expander = std::make_unique<Expander>(*member.system, *member.monitor, pairs);
    }
    return std::unique_ptr<ParallelLevel>(new ParallelLevel(pairs, std::move(members)));
}

ParallelLevel::ParallelLevel(lts::StateStore& pairs, std::vector<Member> members)
    : pairs_(pairs), members_(std::move(members)), team_(static_cast<unsigned>(members_.size())), parts_(most_parts) {}

void ParallelLevel::follow_taus_alone() {
    for (Member& member : members_) member.expander->follow_taus_alone();
}

/// Gives the numbers from 0 on to idle threads, until there has been enough work for one call.
void ParallelLevel::share(std::size_t count, const std::function<void(unsigned, std::size_t)>& work) {
    next_ = 0;
    enough_ = false;
    team_.run([&](unsigned member) {
        while (!enough_) {
            const std::size_t number = next_++;
            if (number >= count) return;
            work(member, number);
        }
    });
}

void ParallelLevel::make_space() {
    pairs_.reserve(pairs_.size() + min_space, [this](std::size_t count, const std::function<void(std::size_t)>& piece) {
        share(count, [&piece](unsigned, std::size_t number) { piece(number); });
    });
}

StateIndex ParallelLevel::run(StateIndex first, StateIndex end, Work work) {
    assert(first <= end && end <= pairs_.size());
    work_ = work;
    make_space();
    claimed_ = 0;
    const std::uint64_t space = pairs_.free_state_count();
    const auto begun = std::chrono::steady_clock::now();
    const std::size_t count = std::min<std::size_t>(most_parts, (end - first + pairs_at_once - 1) / pairs_at_once);
    share(count, [&](unsigned member, std::size_t number) {
        const auto from = static_cast<StateIndex>(first + number * pairs_at_once);
        begin(parts_[number], from);
        fill_part(members_[member], parts_[number], number, std::min(end - from, pairs_at_once) + from);
        claimed_ += parts_[number].claims.size();
        if (parts_[number].stopped || claimed_ >= space || std::chrono::steady_clock::now() - begun > longest)
            enough_ = true;
    });
    const std::size_t done = std::min<std::size_t>(next_, count);
    const auto stop = std::find_if(parts_.begin(), parts_.begin() + static_cast<std::ptrdiff_t>(done),
                                   [](const Part& part) { return part.stopped; });
    size_ = static_cast<std::size_t>(stop - parts_.begin());
    stopped_ = size_ != done;
    for (std::size_t i = size_; i < done; ++i) give_up(parts_[i]);
    std::uint64_t next = pairs_.size();
    for (std::size_t i = 0; i < size_; ++i) {
        assert(!parts_[i].stopped && parts_[i].lost <= parts_[i].claims.size());
        parts_[i].first_number = static_cast<StateIndex>(next);
        next += parts_[i].claims.size() - parts_[i].lost;
    }
    pairs_.make_space(next);
    if (work_ != Work::examine) share(size_, [&](unsigned, std::size_t number) { publish_states(parts_[number]); });
    return size_ == 0 ? first : parts_[size_ - 1].first + parts_[size_ - 1].pairs;
}

void ParallelLevel::begin(Part& part, StateIndex first) {
    part.first = first;
    part.pairs = 0;
    part.transitions = 0;
    part.chased = 0;
    part.back_targets.clear();
    part.claims.clear(pairs_.width());
    part.stopped = false;
}

void ParallelLevel::fill_part(Member& member, Part& part, std::size_t number, StateIndex end) {
    Expansion& expansion = member.expansion;
    while (!part.stopped && part.first + part.pairs != end) {
        member.expander->expand(part.first + part.pairs, end, rows_at_once, expansion);
        if (work_ == Work::examine)
            part.stopped = expansion.has_faults();
        else
            part.stopped =
                expansion.has_findings() || !has_space(part, expansion) || !enter_rows(expansion, part, number);
        for (const Expansion::Pair& pair : expansion.pairs) {
            part.transitions += pair.transitions;
            part.chased += pair.chased;
        }
        part.pairs += static_cast<StateIndex>(expansion.pairs.size());
    }
}

bool ParallelLevel::has_space(Part& part, const Expansion& expansion) {
    try {
        part.back_targets.reserve(part.back_targets.size() + expansion.size());
        return part.claims.make_space(expansion.size());
    } catch (const std::bad_alloc&) {
        return false;
    }
}

/// Claims the rows of the part's pairs. Returns false if the table is full.
bool ParallelLevel::enter_rows(const Expansion& expansion, Part& part, std::size_t number) {
    Claiming claiming(parts_, number);
    std::uint32_t pair = 0;
    for (std::size_t row = 0; row < expansion.size(); ++row) {
        while (expansion.pairs[pair].end_row <= row) ++pair;
        const StateIndex own = claiming.next_claim();
        const lts::StateStore::Claim claim = pairs_.claim(expansion.row(row), expansion.hash(row), own, claiming);
        if (claim.index == lts::no_state) return false;
        if (claim.index == own)
            part.claims.add(claim.slot, part.pairs + pair);
        else if (work_ == Work::enter_note_taus && expansion.by_tau(row) &&
                 claim.index <= part.first + part.pairs + pair)
            part.back_targets.push_back(claim.index);
    }
    return true;
}

/// Gives the new states of the part's claims their final numbers.
void ParallelLevel::publish_states(Part& part) {
    constexpr std::uint32_t ahead = 8;
    StateIndex number = part.first_number;
    std::uint32_t next = 0;
    part.found.clear();
    for (std::uint32_t pair = 0; pair < part.pairs; ++pair) {
        const StateIndex before = number;
        for (; next < part.claims.size() && part.claims[next].pair == pair; ++next) {
            if (next + ahead < part.claims.size()) part.claims[next + ahead].slot.prefetch();
            if (!part.claims[next].lost)
                pairs_.publish_state(part.claims[next].slot, number++, {part.claims.row(next), pairs_.width()});
        }
        part.found.add_expanded_state(number - before);
    }
    part.lost = 0;
}

void ParallelLevel::give_up(Part& part) {
    for (std::uint32_t i = 0; i < part.claims.size(); ++i)
        if (!part.claims[i].lost) lts::StateStore::give_up(part.claims[i].slot);
    part.lost = 0;
}

}  // namespace robochart::refine
