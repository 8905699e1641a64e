// SPDX-License-Identifier: Apache-2.0
// See product.hpp.
#include "prism/automata/product.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "prism/markov/graph/graph.hpp"

namespace robochart::prism::automata {
namespace {

class Multiplier {
public:
    Multiplier(const markov::Model& model, const std::vector<Letter>& letters, Automaton& automaton,
               diagnostics::Budget* budget)
        : model_(model), letters_(letters), automaton_(automaton), budget_(budget) {}

    Product operator()() {
        markov::Model& made = result_.model;
        made.kind = model_.kind;
        made.numbers = model_.numbers;
        made.exact = model_.exact;
        made.actions = model_.actions;
        made.first_choice = {0};
        made.first_branch = {0};
        for (markov::State state = 0; state < model_.states(); ++state)
            result_.begin.push_back(state_after(state, automaton_.start()));
        for (const markov::State state : model_.initial) made.initial.push_back(result_.begin[state]);
        std::ranges::sort(made.initial);
        for (std::size_t state = 0; state < of_model_.size(); ++state) expand(state);
        return std::move(result_);
    }

private:
    /// Returns the product state for a state of the model that the automaton reads next, coming from `before`.
    markov::State state_after(markov::State state, Automaton::State before) {
        const Automaton::State now = automaton_.successor_of(before, letters_[state]);
        const auto [found, fresh] =
            known_.emplace(std::uint64_t{now} << 32U | state, static_cast<markov::State>(of_model_.size()));
        if (!fresh) return found->second;
        if (of_model_.size() >= most_states)
            throw NotDecided("the model with the automaton of the formula has more than 20 million states");
        of_model_.push_back(state);
        result_.automaton.push_back(now);
        return found->second;
    }

    void expand(std::size_t index) {
        markov::Model& made = result_.model;
        const markov::State state = of_model_[index];
        const Automaton::State now = result_.automaton[index];
        for (std::uint32_t choice = model_.first_choice[state]; choice < model_.first_choice[state + 1]; ++choice) {
            if (budget_ != nullptr) budget_->poll();
            branches_.clear();
            for (std::uint64_t i = model_.first_branch[choice]; i < model_.first_branch[choice + 1]; ++i)
                branches_.emplace_back(state_after(model_.target[i], now), model_.number[i]);
            std::ranges::sort(branches_);
            for (const auto& [target, number] : branches_) {
                made.target.push_back(target);
                made.number.push_back(number);
            }
            made.first_branch.push_back(made.target.size());
            if (!model_.action.empty()) made.action.push_back(model_.action[choice]);
        }
        made.first_choice.push_back(static_cast<std::uint32_t>(made.choices()));
    }

    static constexpr std::size_t most_states = 20'000'000;
    const markov::Model& model_;
    const std::vector<Letter>& letters_;
    Automaton& automaton_;
    diagnostics::Budget* budget_;
    Product result_;
    std::vector<markov::State> of_model_;
    std::unordered_map<std::uint64_t, markov::State> known_;
    std::vector<std::pair<markov::State, std::uint32_t>> branches_;
};

}  // namespace

Product product(const markov::Model& model, const std::vector<Letter>& letters, Automaton& automaton,
                diagnostics::Budget* budget) {
    return Multiplier(model, letters, automaton, budget)();
}

markov::StateSet done_states(const Product& product, const Automaton& automaton, std::size_t part) {
    markov::StateSet result(product.model.states());
    for (std::size_t state = 0; state < result.size(); ++state)
        result[state] = automaton.is_done(product.automaton[state], part);
    return result;
}

/// Finds end components that satisfy the condition. In an end component, a part without `always` is fulfilled in all
/// states or in none. The batches of an `always` part are fulfilled infinitely often, or never from some time on. A
/// scheduler can visit all states of a component infinitely often.
markov::StateSet winning_states(const Product& product, const Automaton& automaton, const Condition& condition,
                                diagnostics::Budget* budget) {
    const markov::Model& model = product.model;
    const markov::Graph graph(model);
    markov::StateSet result(model.states());
    for (const Conjunction& all : condition.any) {
        if (budget != nullptr) budget->poll();
        markov::SubModel allowed{markov::StateSet(model.states(), true), std::vector<bool>(model.choices(), true)};
        std::vector<std::size_t> again;
        for (const auto& [part, holds] : all) {
            const bool always = condition.parts[part].always;
            if (always && holds) {
                again.push_back(part);
                continue;
            }
            for (std::size_t state = 0; state < model.states(); ++state) {
                const Automaton::State read = product.automaton[state];
                const bool now = always ? automaton.is_marked(read, part) : automaton.is_done(read, part);
                if (now != holds) allowed.states[state] = false;
            }
        }
        for (const markov::EndComponent& component : end_components(graph, allowed)) {
            const bool wins = std::ranges::all_of(again, [&](std::size_t part) {
                return std::ranges::any_of(component.states, [&](markov::State state) {
                    return automaton.is_marked(product.automaton[state], part);
                });
            });
            for (const markov::State state : component.states)
                if (wins) result[state] = true;
        }
    }
    return result;
}

}  // namespace robochart::prism::automata
