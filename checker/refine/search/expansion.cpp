// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/search/expansion.hpp"

#include <algorithm>
#include <cassert>

namespace robochart::refine {

using process::Event;

void Expansion::clear(std::size_t width) {
    width_ = width;
    size_ = 0;
    pairs.clear();
    error = nullptr;
}

bool Expansion::has_findings() const {
    return has_faults() || std::ranges::any_of(pairs, [](const Pair& pair) { return pair.forbidden.has_value(); });
}

bool Expansion::has_faults() const {
    return error || std::ranges::any_of(pairs, [](const Pair& pair) { return pair.fault.has_value(); });
}

std::span<lts::Word> Expansion::add(bool by_tau) {
    if (size_ == hashes_.size()) {
        const std::size_t larger = std::max<std::size_t>(64, 2 * size_);
        words_.resize(larger * width_);
        hashes_.resize(larger);
        by_tau_.resize(larger);
    }
    assert(size_ < hashes_.size() && words_.size() >= (size_ + 1) * width_);
    by_tau_[size_] = by_tau ? 1 : 0;
    ++size_;
    return std::span(words_).subspan((size_ - 1) * width_, width_);
}

Expander::Expander(lts::TransitionSystem& system, Monitor& monitor, const lts::StateStore& pairs)
    : system_(system), monitor_(monitor), pairs_(pairs), nodes_(!monitor.watches_states_only()) {}

void Expander::expand(lts::StateIndex first, lts::StateIndex end, std::size_t enough_rows, Expansion& out) {
    out.clear(pairs_.width());
    for (lts::StateIndex pair = first; pair != end && out.size() < enough_rows; ++pair) {
        try {
            expand(pairs_[pair], out);
        } catch (...) {
            out.error = std::current_exception();
            return;
        }
    }
}

void Expander::expand(lts::StateView words, Expansion& out) {
    out_ = &out;
    const std::size_t before = out.size();
    try {
        expand_into(words);
    } catch (...) {
        out.shrink_to(before);
        throw;
    }
}

void Expander::expand_into(lts::StateView words) {
    node_ = nodes_ ? words[0] : 0;
    offer_.tau = false;
    offer_.events.clear();
    offer_.branches = false;
    pair_ = {};
    const std::uint64_t chased_before = system_.chased_state_count();
    system_.successors(nodes_ ? words.subspan(1) : words, *this);
    pair_.chased = system_.chased_state_count() - chased_before;
    settle_offer();
    pair_.fault = monitor_.examine(node_, offer_);
    pair_.end_row = static_cast<std::uint32_t>(out_->size());
    out_->pairs.push_back(pair_);
}

/// Sorts the events of the offer and removes duplicates. Skips unstable states, because their events are not used.
void Expander::settle_offer() {
    process::EventSet& events = offer_.events;
    const bool unstable = offer_.tau && std::ranges::find(events, process::tick) == events.end();
    if (!nodes_ || unstable) return;
    std::ranges::sort(events);
    const auto end = std::unique(events.begin(), events.end());
    offer_.branches = end != events.end();
    events.erase(end, events.end());
}

/// Returns the answer of the monitor, or the cached answer if it is valid.
Monitor::Advance Expander::advance(Event event) {
    const std::size_t place = (node_ * 0x9E3779B1U ^ event * 0x85EBCA77U) >> 20U;
    Remembered& remembered = memory_[place];
    if (remembered.event != event || remembered.node != node_)
        remembered = {node_, event, monitor_.advance(node_, event)};
    return remembered.advance;
}

void Expander::add(Event event, lts::StateView target, Event /*revealed*/) {
    ++pair_.transitions;
    if (event == process::tau) {
        offer_.tau = true;
        return add_row(node_, target, true);
    }
    if (!nodes_) {  // only whether an event is possible is used, not which one
        if (offer_.events.empty()) offer_.events.push_back(event);
        if (!taus_alone_) add_row(node_, target, false);
        return;
    }
    offer_.events.push_back(event);
    if (pair_.forbidden || taus_alone_) return;
    const Monitor::Advance next = advance(event);
    if (next.effect == Monitor::Effect::violation) pair_.forbidden = event;
    if (next.effect == Monitor::Effect::follow) add_row(next.node, target, false);
}

void Expander::add_row(Monitor::Node node, lts::StateView target, bool by_tau) {
    if (pair_.forbidden) return;
    const std::span<lts::Word> row = out_->add(by_tau);
    assert(row.size() == target.size() + (nodes_ ? 1 : 0));
    if (nodes_) row[0] = node;
    std::ranges::copy(target, row.begin() + (nodes_ ? 1 : 0));
    const std::uint64_t hash = lts::StateStore::hash(row);
    out_->set_hash(hash);
    pairs_.prefetch(hash);
}

}  // namespace robochart::refine
