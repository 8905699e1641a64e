#include "checker/refine/wide_level.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <new>

namespace robochart::refine {

using lts::StateIndex;

namespace {

constexpr StateIndex pairs_at_once = 128;
/// Few enough that their rows stay near.
constexpr std::size_t most_parts = 48;

}  // namespace

std::unique_ptr<WideLevel> WideLevel::make(const lts::TransitionSystem& system, Monitor& monitor,
                                           lts::StateStore& pairs, unsigned threads) {
    std::vector<Member> members(threads);
    for (Member& member : members) {
        member.system = system.another();
        member.monitor = monitor.another();
        if (!member.system || !member.monitor) return nullptr;
        member.expander = std::make_unique<Expander>(*member.system, *member.monitor, pairs);
    }
    return std::unique_ptr<WideLevel>(new WideLevel(pairs, std::move(members)));
}

WideLevel::WideLevel(lts::StateStore& pairs, std::vector<Member> members)
    : pairs_(pairs), members_(std::move(members)), team_(static_cast<unsigned>(members_.size())), parts_(most_parts) {
    for (Part& part : parts_) {
        part.rows_of.resize(members_.size());
        part.fresh_of.resize(members_.size());
    }
}

/// The parts one by one to whoever has time.
void WideLevel::each_part(const std::function<void(unsigned, Part&, std::size_t)>& work) {
    next_ = 0;
    team_.run([&](unsigned member) {
        for (std::size_t i = next_++; i < size_; i = next_++) work(member, parts_[i], i);
    });
}

StateIndex WideLevel::expand(StateIndex first, StateIndex end) {
    end = std::min<StateIndex>(end - first, pairs_at_once * most_parts) + first;
    size_ = (end - first + pairs_at_once - 1) / pairs_at_once;
    each_part([&](unsigned member, Part& part, std::size_t number) {
        const auto from = static_cast<StateIndex>(first + number * pairs_at_once);
        const StateIndex to = std::min(end - from, pairs_at_once) + from;
        members_[member].expander->expand(from, to, std::numeric_limits<std::size_t>::max(), part.expansion);
    });
    return end;
}

bool WideLevel::eventful() const {
    return std::any_of(parts_.begin(), parts_.begin() + static_cast<std::ptrdiff_t>(size_),
                       [](const Part& part) { return part.expansion.eventful(); });
}

void WideLevel::enter() {
    std::size_t rows = 0;
    std::size_t most_rows = 1;
    for (std::size_t i = 0; i < size_; ++i) {
        rows += parts_[i].expansion.size();
        most_rows = std::max(most_rows, parts_[i].expansion.size());
    }
    known_ = pairs_.size();
    row_bits_ = static_cast<std::uint32_t>(std::bit_width(most_rows));
    if (known_ + (size_ << row_bits_) >= lts::no_state) throw std::bad_alloc();
    pairs_.reserve(known_ + rows);
    full_ = false;
    each_part([&](unsigned, Part& part, std::size_t) { divide(part); });
    team_.run([&](unsigned member) { claim(member); });
    if (full_) throw std::bad_alloc();
    std::size_t next = known_;
    for (std::size_t i = 0; i < size_; ++i) {
        parts_[i].first_fresh = static_cast<StateIndex>(next);
        for (const std::vector<Fresh>& fresh : parts_[i].fresh_of) next += fresh.size();
    }
    pairs_.make_room(next);
    each_part([&](unsigned, Part& part, std::size_t) { publish(part); });
}

/// Who enters which row.
void WideLevel::divide(Part& part) const {
    const Expansion& expansion = part.expansion;
    part.numbers.resize(expansion.size());
    part.finals.resize(expansion.size());
    std::array<std::vector<std::uint32_t>*, lts::IndexTable::most_segments> rows_of{};
    for (std::size_t segment = 0; segment < rows_of.size(); ++segment)
        rows_of[segment] = &part.rows_of[segment % members_.size()];
    for (std::size_t member = 0; member < members_.size(); ++member) {
        part.rows_of[member].clear();
        part.fresh_of[member].clear();
    }
    for (std::uint32_t row = 0; row < expansion.size(); ++row)
        rows_of[pairs_.segment(expansion.hash(row))]->push_back(row);
}

void WideLevel::claim(unsigned member) {
    for (std::size_t number = 0; number < size_; ++number) claim(member, number);
}

/// Of equal rows the first has the claim, as it would have with one thread.
void WideLevel::claim(unsigned member, std::size_t number) {
    constexpr std::size_t far = 24;
    constexpr std::size_t near = 12;
    Part& part = parts_[number];
    const Expansion& expansion = part.expansion;
    const std::vector<std::uint32_t>& rows = part.rows_of[member];
    const auto row_of = [this](StateIndex claimed) {
        const std::size_t place = claimed - known_;
        return parts_[place >> row_bits_].expansion.row(place & ((std::size_t{1} << row_bits_) - 1));
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i + far < rows.size()) pairs_.prefetch(expansion.hash(rows[i + far]));
        if (i + near < rows.size()) pairs_.prefetch_state(expansion.hash(rows[i + near]));
        const std::uint32_t row = rows[i];
        const auto own = static_cast<StateIndex>(known_ + (number << row_bits_) + row);
        const lts::StateStore::Claim claim = pairs_.claim(expansion.row(row), expansion.hash(row), own, row_of);
        part.numbers[row] = claim.index;
        if (claim.index == own) part.fresh_of[member].push_back({row, claim.slot});
        if (claim.index == lts::no_state) full_ = true;
    }
}

/// Merges what the members have found new, in the order of rows, and enters it for good.
void WideLevel::publish(Part& part) {
    std::vector<std::size_t> next(members_.size(), 0);
    part.found.assign(part.expansion.pairs.size(), 0);
    StateIndex number = part.first_fresh;
    std::size_t pair = 0;
    for (;;) {
        const Fresh* first = nullptr;
        std::size_t owner = 0;
        for (std::size_t member = 0; member < members_.size(); ++member) {
            const std::vector<Fresh>& fresh = part.fresh_of[member];
            if (next[member] == fresh.size() || (first != nullptr && first->row < fresh[next[member]].row)) continue;
            first = &fresh[next[member]];
            owner = member;
        }
        if (first == nullptr) return;
        ++next[owner];
        while (part.expansion.pairs[pair].end_row <= first->row) ++pair;
        ++part.found[pair];
        part.finals[first->row] = number;
        pairs_.publish(first->slot, number++, part.expansion.row(first->row));
    }
}

StateIndex WideLevel::target(std::size_t number, std::size_t row) const {
    const StateIndex claimed = parts_[number].numbers[row];
    if (claimed < known_) return claimed;
    const std::size_t place = claimed - known_;
    return parts_[place >> row_bits_].finals[place & ((std::size_t{1} << row_bits_) - 1)];
}

}  // namespace robochart::refine
