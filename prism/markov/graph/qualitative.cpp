// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/graph/qualitative.hpp"

#include <algorithm>

namespace robochart::markov {
namespace {

StateSet complement(StateSet set) {
    set.flip();
    return set;
}

StateSet all_states(const Graph& graph) {
    return StateSet(graph.states(), true);
}

/// A set that grows backwards along edges. Each added state is processed once.
class BackwardSearch {
public:
    BackwardSearch(const Graph& graph, const StateSet& from) : graph_(graph), found_(from) {
        for (State state = 0; state < from.size(); ++state)
            if (from[state]) ahead_.push_back(state);
    }

    /// `admits(choice)` decides whether the source of the choice is added, given that the set contains a target of the
    /// choice. It is called once for each branch into the set.
    template <class Admits>
    StateSet run(Admits admits) {
        while (!ahead_.empty()) {
            const State target = ahead_.back();
            ahead_.pop_back();
            for (const std::uint32_t choice : graph_.choices_to(target)) {
                const State source = graph_.source(choice);
                if (found_[source] || !admits(choice)) continue;
                found_[source] = true;
                ahead_.push_back(source);
            }
        }
        return std::move(found_);
    }

private:
    const Graph& graph_;
    StateSet found_;
    std::vector<State> ahead_;
};

/// Returns the least set that contains `right` and every state of `left` whose choices all have a branch into the set.
StateSet every_choice_may(const Graph& graph, const StateSet& left, const StateSet& right) {
    const Model& model = graph.model();
    std::vector<std::uint32_t> missing(graph.states());
    for (State state = 0; state < graph.states(); ++state)
        missing[state] = model.first_choice[state + 1] - model.first_choice[state];
    std::vector<bool> counted(model.choices(), false);
    return BackwardSearch(graph, right).run([&](std::uint32_t choice) {
        const State source = graph.source(choice);
        if (!left[source] || counted[choice]) return false;
        counted[choice] = true;
        return --missing[source] == 0;
    });
}

/// Keeps the choices whose branches all lead into a set that shrinks.
class Inside {
public:
    Inside(const Graph& graph, const std::vector<bool>& choices)
        : graph_(graph), set_(all_states(graph)), choices_(choices) {}

    [[nodiscard]] bool holds(std::uint32_t choice) const { return choices_[choice]; }
    /// Removes choices that leave `set`; returns whether any was removed.
    bool shrink_to(const StateSet& set) {
        bool any = false;
        for (State state = 0; state < set.size(); ++state) {
            if (set[state] || !set_[state]) continue;
            any = true;
            for (const std::uint32_t choice : graph_.choices_to(state)) choices_[choice] = false;
        }
        set_ = set;
        return any;
    }

private:
    const Graph& graph_;
    StateSet set_;
    std::vector<bool> choices_;
};

}  // namespace

StateSet prob0a(const Graph& graph, const StateSet& left, const StateSet& right) {
    return complement(exists_until(graph, left, right));
}

StateSet prob0e(const Graph& graph, const StateSet& left, const StateSet& right) {
    return complement(every_choice_may(graph, left, right));
}

StateSet prob1e(const Graph& graph, const StateSet& left, const StateSet& right) {
    if (graph.model().kind == Kind::dtmc) return prob1a(graph, left, right);
    return prob1e(graph, left, right, std::vector<bool>(graph.model().choices(), true));
}

/// Computes the greatest Z, with the least Y in it: Y contains `right`, and the states of `left` with a choice that
/// stays in Z and may lead into Y.
StateSet prob1e(const Graph& graph, const StateSet& left, const StateSet& right, const std::vector<bool>& choices) {
    Inside inside(graph, choices);
    while (true) {
        StateSet reached = BackwardSearch(graph, right).run([&](std::uint32_t choice) {
            return left[graph.source(choice)] && inside.holds(choice);
        });
        if (!inside.shrink_to(reached)) return reached;
    }
}

StateSet prob1a(const Graph& graph, const StateSet& left, const StateSet& right) {
    StateSet on_the_way(graph.states());
    for (State state = 0; state < graph.states(); ++state) on_the_way[state] = left[state] && !right[state];
    return complement(exists_until(graph, on_the_way, prob0e(graph, left, right)));
}

StateSet exists_next(const Graph& graph, const StateSet& set) {
    StateSet found(graph.states(), false);
    for (State state = 0; state < graph.states(); ++state)
        if (set[state])
            for (const std::uint32_t choice : graph.choices_to(state)) found[graph.source(choice)] = true;
    return found;
}

StateSet always_next(const Graph& graph, const StateSet& set) {
    return complement(exists_next(graph, complement(set)));
}

StateSet exists_until(const Graph& graph, const StateSet& left, const StateSet& right) {
    return BackwardSearch(graph, right).run([&](std::uint32_t choice) { return left[graph.source(choice)]; });
}

StateSet always_until(const Graph& graph, const StateSet& left, const StateSet& right) {
    const Model& model = graph.model();
    std::vector<std::uint64_t> missing(graph.states());
    for (State state = 0; state < graph.states(); ++state)
        missing[state] =
            model.first_branch[model.first_choice[state + 1]] - model.first_branch[model.first_choice[state]];
    return BackwardSearch(graph, right).run([&](std::uint32_t choice) {
        return left[graph.source(choice)] && --missing[graph.source(choice)] == 0;
    });
}

StateSet exists_finally(const Graph& graph, const StateSet& set) {
    return exists_until(graph, all_states(graph), set);
}

StateSet always_finally(const Graph& graph, const StateSet& set) {
    return always_until(graph, all_states(graph), set);
}

StateSet exists_globally(const Graph& graph, const StateSet& set) {
    return complement(always_finally(graph, complement(set)));
}

StateSet always_globally(const Graph& graph, const StateSet& set) {
    return complement(exists_finally(graph, complement(set)));
}

}  // namespace robochart::markov
