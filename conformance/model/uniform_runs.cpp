// SPDX-License-Identifier: Apache-2.0
// See uniform_runs.hpp. As in NormalFormSystem, rules of docs/conformance.md are cited: A1 registers, A2 outputs and
// time, A3 the cycle, P priority. An output and its report are one step here: the report (A2) follows its output before
// any other output, and M's silent steps commute with it.
#include "conformance/model/uniform_runs.hpp"

#include <algorithm>
#include <set>

#include "base/diagnostics/containers.hpp"

namespace robochart::conformance {

namespace {

/// The state of the model after its ✓.
constexpr ModelState ended = 0xffffffffU;

using Kind = ModelRole::Kind;

bool silent(const ModelEdge& edge) {
    return edge.role.kind == Kind::tau || edge.role.kind == Kind::terminate;
}

/// The hash of a list with one more pair of numbers. The factor is that of Fibonacci hashing (Knuth, TAOCP 3, 6.4).
std::size_t with_pair(std::size_t hash, std::uint32_t first, std::uint32_t second) {
    const std::uint64_t mixed = (hash ^ (std::uint64_t{first} << 32U | second)) * 0x9E3779B97F4A7C15U;
    return static_cast<std::size_t>(mixed ^ (mixed >> 32U));
}

}  // namespace

std::size_t UniformRuns::Hash::operator()(const States& states) const {
    std::size_t hash = states.size();
    for (const HeldState& state : states) hash = with_pair(hash, state.model, state.held);
    return hash;
}

std::size_t UniformRuns::Hash::operator()(const std::vector<Reading>& readings) const {
    std::size_t hash = readings.size();
    for (const auto& [input, reading] : readings) hash = with_pair(hash, input, reading);
    return hash;
}

UniformRuns::UniformRuns(ModelGraph& model, const Alphabet& alphabet, std::uint32_t cycle_length)
    : model_(&model), alphabet_(&alphabet), cycle_length_(std::max(1U, cycle_length)) {
    (void)intern_held({});
}

UniformRuns::Set UniformRuns::start() {
    return intern({{model_->initial(), 0}});
}

UniformRuns::Set UniformRuns::intern(States states) {
    diagnostics::sort_unique(states);
    const auto [place, fresh] = set_ids_.try_emplace(std::move(states), static_cast<Set>(sets_.size()));
    if (fresh) {
        sets_.push_back(&place->first);
        closures_.emplace_back();
    }
    return place->second;
}

std::uint32_t UniformRuns::intern_held(std::vector<Reading> readings) {
    const auto [place, fresh] = held_ids_.try_emplace(std::move(readings), static_cast<std::uint32_t>(held_.size()));
    if (fresh) held_.push_back(&place->first);
    return place->second;
}

/// Removes readings that M cannot receive any more before the next tock (ModelGraph::hears).
HeldState UniformRuns::narrowed(ModelState model, std::uint32_t held) {
    if (held == 0 || model == ended) return {model, 0};
    const std::vector<bool>& hears = model_->heard_inputs(model);
    const std::vector<Reading>& readings = *held_[held];
    if (std::ranges::all_of(readings, [&](const Reading& reading) { return hears[reading.first]; }))
        return {model, held};
    std::vector<Reading> left;
    for (const Reading& reading : readings)
        if (hears[reading.first]) left.push_back(reading);
    return {model, intern_held(std::move(left))};
}

UniformRuns::Set UniformRuns::with(Set states, std::uint32_t input, std::uint32_t reading) {
    const std::uint64_t key = (std::uint64_t{states} << 32U) | (std::uint64_t{alphabet_->read_event(input, reading)});
    const auto known = with_.find(key);
    if (known != with_.end()) return known->second;
    States result;
    for (const HeldState& state : *sets_[states]) {
        std::vector<Reading> held = *held_[state.held];
        held.insert(std::ranges::upper_bound(held, Reading{input, reading}), Reading{input, reading});
        result.push_back(narrowed(state.model, intern_held(std::move(held))));
    }
    return with_.emplace(key, intern(std::move(result))).first->second;
}

bool UniformRuns::holds(std::uint32_t held, std::uint32_t input, std::uint32_t reading) const {
    return std::ranges::binary_search(*held_[held], Reading{input, reading});
}

const UniformRuns::Closure& UniformRuns::closure(Set number) {
    if (closures_[number].known) return closures_[number];
    Closure made;
    made.known = true;
    made.all = *sets_[number];  // sorted
    States open = made.all;
    std::map<process::Event, States> writes;
    const auto add = [&](const HeldState& state) {
        const auto place = std::ranges::lower_bound(made.all, state);
        if (place != made.all.end() && *place == state) return;
        made.all.insert(place, state);
        open.push_back(state);
    };
    while (!open.empty()) {
        const HeldState state = open.back();
        open.pop_back();
        if (state.model == ended) continue;
        for (const ModelEdge& edge : model_->edges(state.model)) {
            const ModelRole& role = edge.role;
            if (silent(edge)) {
                add(narrowed(edge.target, state.held));
            } else if (role.kind == Kind::tick) {
                made.terminated = true;
                add({ended, 0});
            } else if (role.kind == Kind::output) {
                writes[role.write].push_back(narrowed(edge.target, state.held));
            } else if (role.kind == Kind::input && holds(state.held, role.index, role.reading)) {  // A1: once
                std::vector<Reading> left = *held_[state.held];
                std::erase(left, Reading{role.index, role.reading});
                add(narrowed(edge.target, intern_held(std::move(left))));
            }
        }
    }
    made.terminated = made.terminated || std::ranges::binary_search(made.all, HeldState{ended, 0});
    for (auto& [event, states] : writes) made.writes.emplace(event, intern(std::move(states)));
    closures_[number] = std::move(made);
    return closures_[number];
}

std::optional<UniformRuns::Set> UniformRuns::after(Set states, process::Event write) {
    const Closure& possible = closure(states);
    const auto found = possible.writes.find(write);
    return found == possible.writes.end() ? std::nullopt : std::optional(found->second);
}

bool UniformRuns::stable(const HeldState& state) {
    if (state.model == ended) return false;  // its ✓ comes first (P)
    return std::ranges::none_of(model_->edges(state.model), [&](const ModelEdge& edge) {
        const ModelRole& role = edge.role;
        const bool received = role.kind == Kind::input && holds(state.held, role.index, role.reading);
        return silent(edge) || role.kind == Kind::tick || role.kind == Kind::output || received;
    });
}

bool UniformRuns::lets_time_pass(ModelState state) {
    return std::ranges::any_of(model_->edges(state),
                               [](const ModelEdge& edge) { return edge.role.kind == Kind::tock; });
}

std::optional<std::uint32_t> UniformRuns::awaits(ModelState state, const std::vector<bool>& unread) {
    for (const ModelEdge& edge : model_->edges(state))
        if (edge.role.kind == Kind::input && unread[edge.role.index]) return edge.role.index;
    return std::nullopt;
}

/// Returns the states of M after a cycle's tocks, or no value if time stops in all of them.
std::optional<UniformRuns::Set> UniformRuns::after_time(const States& stable) {
    States now = stable;
    for (std::uint32_t t = 0; t < cycle_length_; ++t) {
        if (t > 0) now = settled_between_tocks(std::move(now));
        States later;
        for (const HeldState& state : now)
            for (const ModelEdge& edge : model_->edges(state.model))
                if (edge.role.kind == Kind::tock) later.push_back({edge.target, 0});
        now = std::move(later);
    }
    if (now.empty()) return std::nullopt;
    return intern(std::move(now));
}

/// Follows M between the tocks of a cycle. M performs no event of E there (A3), and its own steps come before time (P).
UniformRuns::States UniformRuns::settled_between_tocks(States states) {
    std::set<HeldState> seen(states.begin(), states.end());
    std::vector<HeldState> open(seen.begin(), seen.end());
    States settled;
    while (!open.empty()) {
        const HeldState state = open.back();
        open.pop_back();
        bool urgent = false;
        for (const ModelEdge& edge : model_->edges(state.model)) {
            urgent = urgent || silent(edge) || edge.role.kind == Kind::tick;
            if (silent(edge) && seen.insert({edge.target, 0}).second) open.push_back({edge.target, 0});
        }
        if (!urgent) settled.push_back(state);
    }
    return settled;
}

/// Ends the cycle. Recursion depth: the number of unread registers for which M waits.
bool UniformRuns::finish(Set states, const std::vector<bool>& unread, rc_result outcome,
                         std::vector<Completion>& completions, Completion& refused) {
    if (outcome == RC_TERMINATED && closure(states).terminated) {
        completions.push_back(refused);
        return true;
    }
    if (outcome != RC_QUIESCENT && outcome != RC_DEADLINE) return false;
    const bool passes = outcome == RC_QUIESCENT;
    States fitting;  // for all readings of the unread registers
    std::optional<std::uint32_t> awaited;
    for (const HeldState& state : closure(states).all) {
        if (!stable(state) || lets_time_pass(state.model) != passes) continue;
        const auto input = awaits(state.model, unread);
        if (!input)
            fitting.push_back(state);
        else if (!awaited)
            awaited = input;
    }
    if (!fitting.empty()) {
        const auto next = passes ? after_time(fitting) : std::optional<Set>(0);
        if (!next) return false;
        completions.push_back(refused);
        completions.back().states = *next;
        return true;
    }
    if (!awaited) return false;
    std::vector<bool> left = unread;
    left[*awaited] = false;
    for (std::uint32_t reading = 0; reading < alphabet_->interface().inputs[*awaited].reading_count(); ++reading) {
        refused.readings.emplace_back(*awaited, reading);
        const Set completed = reading == 0 ? states : with(states, *awaited, reading);
        if (!finish(completed, left, outcome, completions, refused)) return false;
        refused.readings.pop_back();
    }
    return true;
}

}  // namespace robochart::conformance
