// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/graph/graph.hpp"

#include <algorithm>

#include "checker/lts/strong_components.hpp"

namespace robochart::markov {
namespace {

constexpr std::uint32_t no_component = 0xFFFFFFFF;

std::vector<State> members_of(const StateSet& set) {
    std::vector<State> members;
    for (State state = 0; state < set.size(); ++state)
        if (set[state]) members.push_back(state);
    return members;
}

/// Computes the greatest part of a sub-model in which every choice stays in one strongly connected component.
class EndComponents {
public:
    EndComponents(const Graph& graph, const SubModel& within)
        : graph_(graph),
          model_(graph.model()),
          left_{within},
          choices_left_(graph.states(), 0),
          component_(graph.states(), no_component) {}

    std::vector<EndComponent> find() {
        remove_what_leaves();
        do split_into_components();
        while (remove_between_components());
        return collect();
    }

private:
    /// Removes choices of states outside the sub-model and choices with targets outside; then removes states without
    /// choices.
    void remove_what_leaves() {
        for (State state = 0; state < graph_.states(); ++state)
            for (std::uint32_t choice = model_.first_choice[state]; choice < model_.first_choice[state + 1]; ++choice) {
                const auto stays = [&](State target) { return left_.states[target]; };
                left_.choices[choice] =
                    left_.choices[choice] && left_.states[state] && std::ranges::all_of(targets(model_, choice), stays);
                if (left_.choices[choice]) ++choices_left_[state];
            }
        for (State state = 0; state < graph_.states(); ++state)
            if (left_.states[state] && choices_left_[state] == 0) remove_state(state);
    }

    void remove_state(State state) {
        left_.states[state] = false;
        removed_.push_back(state);
        while (!removed_.empty()) {
            const State gone = removed_.back();
            removed_.pop_back();
            for (const std::uint32_t choice : graph_.choices_to(gone)) remove_choice(choice);
        }
    }

    void remove_choice(std::uint32_t choice) {
        if (!left_.choices[choice]) return;
        left_.choices[choice] = false;
        const State source = graph_.source(choice);
        if (--choices_left_[source] > 0 || !left_.states[source]) return;
        left_.states[source] = false;
        removed_.push_back(source);
    }

    void split_into_components() {
        std::uint32_t count = 0;
        const auto successors = [this](State state, std::vector<State>& to) {
            for (std::uint32_t choice = model_.first_choice[state]; choice < model_.first_choice[state + 1]; ++choice)
                if (left_.choices[choice])
                    to.insert(to.end(), targets(model_, choice).begin(), targets(model_, choice).end());
        };
        lts::strong_components({graph_.states(), successors}, members_of(left_.states),
                               [&](std::span<const State> members, bool) {
                                   for (const State member : members) component_[member] = count;
                                   ++count;
                               });
    }

    bool remove_between_components() {
        bool any = false;
        for (std::uint32_t choice = 0; choice < model_.choices(); ++choice) {
            if (!left_.choices[choice]) continue;
            const std::uint32_t home = component_[graph_.source(choice)];
            const auto inside = [&](State target) { return left_.states[target] && component_[target] == home; };
            if (std::ranges::all_of(targets(model_, choice), inside)) continue;
            any = true;
            const State source = graph_.source(choice);
            left_.choices[choice] = false;
            if (--choices_left_[source] == 0 && left_.states[source]) remove_state(source);
        }
        return any;
    }

    std::vector<EndComponent> collect() const {
        std::vector<EndComponent> found;
        std::vector<std::uint32_t> place(graph_.states(), no_component);  // by component in `found`
        for (State state = 0; state < graph_.states(); ++state) {
            if (!left_.states[state]) continue;
            std::uint32_t& at = place[component_[state]];
            if (at == no_component) {
                at = static_cast<std::uint32_t>(found.size());
                found.emplace_back();
            }
            found[at].states.push_back(state);
            for (std::uint32_t choice = model_.first_choice[state]; choice < model_.first_choice[state + 1]; ++choice)
                if (left_.choices[choice]) found[at].choices.push_back(choice);
        }
        return found;
    }

    const Graph& graph_;
    const Model& model_;
    SubModel left_;
    std::vector<std::uint32_t> choices_left_;  // by state
    std::vector<std::uint32_t> component_;
    std::vector<State> removed_;
};

}  // namespace

std::span<const State> targets(const Model& model, std::uint32_t choice) {
    return std::span(model.target)
        .subspan(model.first_branch[choice], model.first_branch[choice + 1] - model.first_branch[choice]);
}

Graph::Graph(const Model& model)
    : model_(model), source_(model.choices()), first_incoming_(model.states() + 1, 0), incoming_(model.target.size()) {
    for (const State target : model.target) ++first_incoming_[target + 1];
    for (State state = 0; state < states(); ++state) {
        first_incoming_[state + 1] += first_incoming_[state];
        for (std::uint32_t choice = model.first_choice[state]; choice < model.first_choice[state + 1]; ++choice)
            source_[choice] = state;
    }
    std::vector<std::uint64_t> next(first_incoming_.begin(), first_incoming_.end() - 1);
    for (std::uint32_t choice = 0; choice < model.choices(); ++choice)
        for (const State target : targets(model, choice)) incoming_[next[target]++] = choice;
}

std::span<const std::uint32_t> Graph::choices_to(State state) const {
    return std::span(incoming_).subspan(first_incoming_[state], first_incoming_[state + 1] - first_incoming_[state]);
}

std::vector<EndComponent> end_components(const Graph& graph, const SubModel& within) {
    return EndComponents(graph, within).find();
}

std::vector<EndComponent> end_components(const Graph& graph) {
    return end_components(graph, {StateSet(graph.states(), true), std::vector<bool>(graph.model().choices(), true)});
}

std::vector<std::vector<State>> bottom_components(const Model& model) {
    std::vector<std::uint32_t> component(model.states(), no_component);
    std::vector<std::vector<State>> found;
    const auto successors = [&](State state, std::vector<State>& to) {
        to.insert(to.end(), targets(model, state).begin(), targets(model, state).end());
    };
    std::uint32_t count = 0;
    const auto report = [&](std::span<const State> members, bool) {
        for (const State member : members) component[member] = count;
        const auto stays = [&](State member) {
            return std::ranges::all_of(targets(model, member), [&](State to) { return component[to] == count; });
        };
        if (std::ranges::all_of(members, stays)) {
            found.emplace_back(members.begin(), members.end());
            std::ranges::sort(found.back());
        }
        ++count;
    };
    lts::strong_components({model.states(), successors}, members_of(StateSet(model.states(), true)), report);
    std::ranges::sort(found);
    return found;
}

}  // namespace robochart::markov
