// SPDX-License-Identifier: Apache-2.0
// Stores terms, event sets, renamings and priority orders without duplicates (hash consing). Ids are assigned in the
// order of creation. So they depend only on the calls, never on addresses or on the order of a hash table.
#include "checker/process/term.hpp"

#include <cassert>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>

#include "base/diagnostics/containers.hpp"

namespace robochart::process {
namespace {

constexpr std::uint32_t empty_slot = std::numeric_limits<std::uint32_t>::max();

std::uint64_t mix_hash(std::uint64_t hash, std::uint64_t value) {
    hash = (hash ^ value) * 0x9E3779B97F4A7C15ULL;
    return hash ^ (hash >> 29U);
}

std::uint32_t hash_of(const Term& term) {
    std::uint64_t hash = mix_hash(0x51ED270B7F4A7C15ULL, (static_cast<std::uint64_t>(term.op) << 32U) | term.payload);
    for (TermId child : term.children) hash = mix_hash(hash, static_cast<std::uint32_t>(child));
    for (SetId set : term.sets) hash = mix_hash(hash, 0x100000000ULL | static_cast<std::uint32_t>(set));
    return static_cast<std::uint32_t>(hash ^ (hash >> 32U));
}

template <class T>
void sort_unique(std::vector<T>& items) {
    diagnostics::sort_unique(items);
}

/// Numbers values in the order of their first appearance.
template <class Value, class Id>
class Interner {
public:
    Id intern(Value value) {
        const auto [entry, fresh] = ids_.emplace(std::move(value), Id{static_cast<std::uint32_t>(values_.size())});
        if (fresh) values_.push_back(&entry->first);
        return entry->second;
    }
    [[nodiscard]] const Value& operator[](Id id) const { return *values_.at(static_cast<std::uint32_t>(id)); }
    [[nodiscard]] std::size_t size() const { return values_.size(); }

private:
    std::map<Value, Id> ids_;
    std::vector<const Value*> values_;
};

}  // namespace

struct TermStore::Impl {
    std::deque<Term> terms;  // references stay valid while terms are added
    std::vector<std::uint32_t> hashes;
    std::vector<std::uint32_t> slots = std::vector<std::uint32_t>(1024, empty_slot);
    Interner<EventSet, SetId> sets;
    std::vector<std::vector<bool>> members;  // by set: a bit for every event up to the largest event of the set
    Interner<Renaming, RenamingId> renamings;
    Interner<PriorityOrder, OrderId> orders;
    std::vector<std::optional<TermId>> unfoldings;
    std::deque<std::optional<std::vector<Branch>>> branches;

    /// Returns the slot that contains an equal term, or the free slot where the term belongs.
    [[nodiscard]] std::size_t find_slot(const Term& term, std::uint32_t hash) const {
        const std::size_t mask = slots.size() - 1;
        assert((slots.size() & mask) == 0 && terms.size() < slots.size());
        std::size_t slot = hash & mask;
        while (slots[slot] != empty_slot && (hashes[slots[slot]] != hash || terms[slots[slot]] != term))
            slot = (slot + 1) & mask;
        return slot;
    }

    void grow_slots() {
        std::vector<std::uint32_t> larger(slots.size() * 2, empty_slot);
        const std::size_t mask = larger.size() - 1;
        for (std::uint32_t id = 0; id < terms.size(); ++id) {
            std::size_t slot = hashes[id] & mask;
            while (larger[slot] != empty_slot) slot = (slot + 1) & mask;
            larger[slot] = id;
        }
        slots.swap(larger);
    }
};

TermStore::TermStore(EventTable& events) : events_(events), impl_(std::make_shared<Impl>()) {}

TermId TermStore::intern_term(const Term& term) {
    Impl& impl = *impl_;
    const std::uint32_t hash = hash_of(term);
    std::size_t slot = impl.find_slot(term, hash);
    if (impl.slots[slot] != empty_slot) return TermId{impl.slots[slot]};
    if (impl.terms.size() >= empty_slot) throw std::length_error("more than 2^32 process terms");
    if ((impl.terms.size() + 1) * 4 > impl.slots.size() * 3) {
        impl.grow_slots();
        slot = impl.find_slot(term, hash);
    }
    assert(impl.slots[slot] == empty_slot && impl.hashes.size() == impl.terms.size());
    const auto id = static_cast<std::uint32_t>(impl.terms.size());
    impl.terms.push_back(term);
    impl.hashes.push_back(hash);
    impl.slots[slot] = id;
    return TermId{id};
}

const Term& TermStore::operator[](TermId id) const {
    assert(static_cast<std::uint32_t>(id) < impl_->terms.size());
    return impl_->terms[static_cast<std::uint32_t>(id)];
}

std::size_t TermStore::size() const {
    return impl_->terms.size();
}

SetId TermStore::intern_set(EventSet events) {
    sort_unique(events);
    std::erase(events, tau);
    const SetId id = impl_->sets.intern(std::move(events));
    if (impl_->members.size() < impl_->sets.size()) {
        const EventSet& interned = impl_->sets[id];
        std::vector<bool> bits(interned.empty() ? 0 : interned.back() + 1U, false);
        for (Event event : interned) bits[event] = true;
        impl_->members.push_back(std::move(bits));
    }
    return id;
}

const EventSet& TermStore::operator[](SetId id) const {
    return impl_->sets[id];
}

bool TermStore::contains(SetId id, Event event) const {
    const std::vector<bool>& bits = impl_->members[static_cast<std::uint32_t>(id)];
    return event < bits.size() && bits[event];
}

RenamingId TermStore::intern_renaming(Renaming pairs) {
    sort_unique(pairs);
    return impl_->renamings.intern(std::move(pairs));
}

const Renaming& TermStore::operator[](RenamingId id) const {
    return impl_->renamings[id];
}

OrderId TermStore::intern_order(PriorityOrder order) {
    for (EventSet& level : order) sort_unique(level);
    return impl_->orders.intern(std::move(order));
}

const PriorityOrder& TermStore::operator[](OrderId id) const {
    return impl_->orders[id];
}

TermId TermStore::unfold(std::uint32_t call) {
    std::vector<std::optional<TermId>>& known = impl_->unfoldings;
    if (call >= known.size()) known.resize(call + 1U);
    if (!known[call]) {
        const TermId body = definitions_->unfold(call);  // may call this function recursively and grow `known`
        impl_->unfoldings[call] = body;
    }
    return *impl_->unfoldings[call];
}

TermId TermStore::unfold_calls(TermId term, int most) {
    for (; most > 0 && (*this)[term].op == Op::call; --most) term = unfold((*this)[term].payload);
    return term;
}

const std::vector<Branch>& TermStore::branches(std::uint32_t prefix) {
    if (prefix >= impl_->branches.size()) impl_->branches.resize(prefix + 1U);
    if (!impl_->branches[prefix]) {
        std::vector<Branch> made = definitions_->branches(prefix);
        impl_->branches[prefix] = std::move(made);
    }
    return *impl_->branches[prefix];
}

const std::vector<Branch>* TermStore::known_branches(std::uint32_t prefix) const {
    if (prefix >= impl_->branches.size() || !impl_->branches[prefix]) return nullptr;
    return &*impl_->branches[prefix];
}

}  // namespace robochart::process
