// SPDX-License-Identifier: Apache-2.0
// Decides refinement by a subset construction on explicit graphs, directly from the definitions of the models.
#include "naive.hpp"

#include <deque>
#include <functional>

namespace robochart::refine::naive {

Behaviour::States Behaviour::closed(States states) const {
    for (bool grew = true; grew;) {
        grew = false;
        for (int state : States(states))
            for (const Graph::Edge& edge : graph_.edges[static_cast<std::size_t>(state)])
                if (edge.letter == tau) grew = states.insert(edge.target).second || grew;
    }
    return states;
}

Behaviour::States Behaviour::after(const States& states, Letter letter) const {
    States next;
    for (int state : states)
        for (const Graph::Edge& edge : graph_.edges[static_cast<std::size_t>(state)])
            if (edge.letter == letter) next.insert(edge.target);
    return closed(next);
}

std::vector<Letter> Behaviour::alphabet() const {
    std::vector<Letter> all{tick};
    for (Letter l = 0; l < letters_; ++l) all.push_back(l);
    return all;
}

namespace {

unsigned bit_of(Letter letter) {
    return letter == tick ? 1U : 1U << (letter + 1);
}

}  // namespace

bool Behaviour::state_refuses(int state, unsigned set) const {
    unsigned offered = 0;
    bool has_tau = false;
    for (const Graph::Edge& edge : graph_.edges[static_cast<std::size_t>(state)]) {
        if (edge.letter == tau)
            has_tau = true;
        else
            offered |= bit_of(edge.letter);
    }
    if ((offered & bit_of(tick)) != 0)
        return (set & bit_of(tick)) == 0;  // a state that may terminate can refuse all but tick
    return !has_tau && (set & offered) == 0;
}

bool Behaviour::can_refuse(const States& states, unsigned set) const {
    for (int state : states)
        if (state_refuses(state, set)) return true;
    return false;
}

bool Behaviour::diverges(const States& states) const {
    // The greatest set of states in which every state has a tau to a state of the set.
    States endless = closed(states);
    for (bool shrank = true; shrank;) {
        shrank = false;
        for (int state : States(endless)) {
            bool stays = false;
            for (const Graph::Edge& edge : graph_.edges[static_cast<std::size_t>(state)])
                stays = stays || (edge.letter == tau && endless.contains(edge.target));
            if (!stays) shrank = endless.erase(state) > 0 || shrank;
        }
    }
    return !endless.empty();
}

namespace {

/// Calls `visit` with the set of states after every trace, once for each set. If `visit` returns false, longer traces
/// are skipped.
void for_all_traces(const Behaviour& process, const std::function<bool(const Behaviour::States&)>& visit) {
    std::set<Behaviour::States> seen;
    std::deque<Behaviour::States> work{process.initially()};
    while (!work.empty()) {
        const Behaviour::States states = work.front();
        work.pop_front();
        if (states.empty() || !seen.insert(states).second || !visit(states)) continue;
        for (Letter letter : process.alphabet()) work.push_back(process.after(states, letter));
    }
}

}  // namespace

bool refines(const Behaviour& specification, const Behaviour& implementation, Semantics semantics) {
    using Pair = std::pair<Behaviour::States, Behaviour::States>;
    std::set<Pair> seen;
    std::deque<Pair> work{{specification.initially(), implementation.initially()}};
    while (!work.empty()) {
        const auto [allowed, actual] = work.front();
        work.pop_front();
        if (actual.empty() || !seen.insert({allowed, actual}).second) continue;
        if (allowed.empty()) return false;
        if (semantics == Semantics::FD && specification.diverges(allowed)) continue;
        if (semantics == Semantics::FD && implementation.diverges(actual)) return false;
        if (semantics != Semantics::T)
            for (unsigned set = 0; set < implementation.refusal_sets(); ++set)
                if (implementation.can_refuse(actual, set) && !specification.can_refuse(allowed, set)) return false;
        for (Letter letter : implementation.alphabet())
            work.emplace_back(specification.after(allowed, letter), implementation.after(actual, letter));
    }
    return true;
}

bool deadlock_free(const Behaviour& process, Semantics semantics) {
    bool free = true;
    for_all_traces(process, [&](const Behaviour::States& states) {
        if (process.can_refuse(states, process.refusal_sets() - 1)) free = false;
        if (semantics == Semantics::FD && process.diverges(states)) free = false;
        return free;
    });
    return free;
}

bool divergence_free(const Behaviour& process) {
    bool free = true;
    for_all_traces(process, [&](const Behaviour::States& states) {
        if (process.diverges(states)) free = false;
        return free;
    });
    return free;
}

bool deterministic(const Behaviour& process, Semantics semantics) {
    bool holds = semantics != Semantics::FD || divergence_free(process);
    for_all_traces(process, [&](const Behaviour::States& states) {
        for (Letter letter : process.alphabet())
            if (!process.after(states, letter).empty() && process.can_refuse(states, bit_of(letter))) holds = false;
        return holds;
    });
    return holds;
}

bool has_trace(const Behaviour& process, const std::vector<Letter>& trace) {
    Behaviour::States states = process.initially();
    for (Letter letter : trace) states = process.after(states, letter);
    return !states.empty();
}

std::optional<std::size_t> shortest_violation(const Behaviour& specification, const Behaviour& implementation,
                                              Semantics semantics) {
    using Place = std::pair<Behaviour::States, int>;
    std::set<Place> level{{specification.initially(), 0}};
    std::set<Place> seen = level;
    for (std::size_t steps = 0; !level.empty(); ++steps) {
        std::set<Place> next;
        bool forbidden = false;
        for (const auto& [allowed, state] : level) {
            if (semantics != Semantics::T)
                for (unsigned set = 0; set < implementation.refusal_sets(); ++set)
                    if (implementation.state_refuses(state, set) && !specification.can_refuse(allowed, set))
                        return steps;
            for (const Graph::Edge& edge : implementation.graph().edges[static_cast<std::size_t>(state)]) {
                const auto then = edge.letter == tau ? allowed : specification.after(allowed, edge.letter);
                if (then.empty())
                    forbidden = true;
                else if (seen.insert({then, edge.target}).second)
                    next.insert({then, edge.target});
            }
        }
        if (forbidden) {
            // A refusal in the next level would not be shorter, because it has the same number of steps.
            return steps + 1;
        }
        level.swap(next);
    }
    return std::nullopt;
}

}  // namespace robochart::refine::naive
