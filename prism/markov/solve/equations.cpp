// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/solve/equations.hpp"

#include <algorithm>
#include <limits>

#include "checker/lts/strong_components.hpp"
#include "prism/markov/solve/arithmetic.hpp"
#include "prism/markov/solve/strategy.hpp"

namespace robochart::markov {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFF;

/// The classes of open states. The states of an end component form one class. A class is identified by its first state.
class Classes {
public:
    Classes(const std::vector<EndComponent>& collapsed, std::size_t states) {
        if (collapsed.empty()) return;
        component_.assign(states, none);
        for (std::uint32_t index = 0; index < collapsed.size(); ++index)
            for (const State state : collapsed[index].states) component_[state] = index;
        collapsed_ = &collapsed;
    }

    [[nodiscard]] State representative_of(State state) const {
        return component(state) == none ? state : (*collapsed_)[component_[state]].states.front();
    }
    template <class Visit>
    void for_each_member(State first, Visit visit) const {
        if (component(first) == none) return visit(first);
        for (const State member : (*collapsed_)[component_[first]].states) visit(member);
    }
    [[nodiscard]] const EndComponent* end_component(State state) const {
        return component(state) == none ? nullptr : &(*collapsed_)[component_[state]];
    }

private:
    [[nodiscard]] std::uint32_t component(State state) const { return component_.empty() ? none : component_[state]; }

    std::vector<std::uint32_t> component_;  // by state; empty if nothing is collapsed
    const std::vector<EndComponent>* collapsed_ = nullptr;
};

Interval limit_probability(Interval value, bool probability) {
    if (probability) value.high = std::min(value.high, 1.0);
    return value;
}

Rational limit_probability(Rational value, bool) {
    return value;
}

SystemSolution<Interval> optimum_of(const System<Interval>& system, const Optimum& goal, bool probabilities,
                                    std::string& shortfall) {
    return optimum(system, goal, probabilities ? 1.0 : infinity, shortfall);
}

SystemSolution<Rational> optimum_of(const System<Rational>& system, const Optimum& goal, bool, std::string&) {
    return optimum(system, goal);
}

template <class Value>
class Solver {
public:
    Solver(Equations<Value>& equations, std::vector<std::uint32_t>& strategy, std::string& shortfall)
        : equations_(equations),
          model_(equations.graph.model()),
          strategy_(strategy),
          shortfall_(shortfall),
          classes_(equations.collapsed, model_.states()),
          numbers_(convert_numbers(model_.numbers, model_.exact, Value{})),
          place_(model_.states(), none) {}

    void run() {
        std::vector<State> roots;
        for (State state = 0; state < model_.states(); ++state)
            if (equations_.open[state] && classes_.representative_of(state) == state) roots.push_back(state);
        const auto successors = [this](State first, std::vector<State>& to) {
            for_each_choice(first, [&](State, std::uint32_t choice) {
                for (const State target : targets(model_, choice))
                    if (equations_.open[target]) to.push_back(classes_.representative_of(target));
            });
        };
        lts::strong_components({model_.states(), successors}, roots, [this](std::span<const State> members, bool) {
            poll(equations_.goal.precision.budget);
            if (members.size() == 1)
                solve_alone(members.front());
            else
                solve_together(members);
        });
    }

private:
    /// Visits the choices of a class that may leave the class.
    template <class Visit>
    void for_each_choice(State first, Visit visit) const {
        classes_.for_each_member(first, [&](State member) {
            for (std::uint32_t choice = model_.first_choice[member]; choice < model_.first_choice[member + 1];
                 ++choice) {
                if (!equations_.admitted[choice]) continue;
                const auto stays = [&](State target) {
                    return equations_.open[target] && classes_.representative_of(target) == first;
                };
                if (!std::ranges::all_of(targets(model_, choice), stays)) visit(member, choice);
            }
        });
    }

    [[nodiscard]] Value earned_by(State state, std::uint32_t choice) const {
        const Earnings<Value>& earnings = equations_.earnings;
        Value sum{};
        if (!earnings.state.empty()) sum += earnings.state[state];
        if (!earnings.choice.empty()) sum += earnings.choice[choice];
        return sum;
    }

    void solve_alone(State first) {
        const Direction direction = equations_.goal.direction;
        Value value{};
        Value of_taken{};
        std::uint32_t taken = none;
        for_each_choice(first, [&](State member, std::uint32_t choice) {
            const Value offered = worth_alone(first, member, choice);
            value = taken == none ? offered : best_of(value, offered, direction);
            if (taken != none && !is_better(offered, of_taken, direction)) return;
            of_taken = offered;
            taken = choice;
        });
        set(first, limit_probability(std::move(value), equations_.probabilities), taken);
    }

    [[nodiscard]] Value worth_alone(State first, State member, std::uint32_t choice) const {
        Value sum = earned_by(member, choice);
        Value leaving{};
        bool returns = false;
        for (std::uint64_t branch = model_.first_branch[choice]; branch < model_.first_branch[choice + 1]; ++branch) {
            const State target = model_.target[branch];
            if (equations_.open[target] && classes_.representative_of(target) == first) {
                returns = true;
                continue;
            }
            const Value& probability = numbers_[model_.number[branch]];
            sum += probability * equations_.values[target];
            leaving += probability;
        }
        return returns ? Value(sum / leaving) : sum;
    }

    void solve_together(std::span<const State> members) {
        System<Value> system;
        system.numbers = numbers_;
        for (std::uint32_t unknown = 0; unknown < members.size(); ++unknown) place_[members[unknown]] = unknown;
        choices_.clear();
        for (const State first : members) {
            for_each_choice(first, [&](State member, std::uint32_t choice) { add_row(system, member, choice); });
            system.first_choice.push_back(static_cast<std::uint32_t>(system.choices()));
        }
        const SystemSolution<Value> solution =
            optimum_of(system, equations_.goal, equations_.probabilities, shortfall_);
        for (std::uint32_t unknown = 0; unknown < members.size(); ++unknown) {
            place_[members[unknown]] = none;
            set(members[unknown], solution.values[unknown], choices_[solution.policy[unknown]]);
        }
    }

    void add_row(System<Value>& system, State member, std::uint32_t choice) {
        Value constant = earned_by(member, choice);
        Value outside{};
        for (std::uint64_t branch = model_.first_branch[choice]; branch < model_.first_branch[choice + 1]; ++branch) {
            const State target = model_.target[branch];
            const std::uint32_t unknown = equations_.open[target] ? place_[classes_.representative_of(target)] : none;
            if (unknown != none) {
                system.unknown.push_back(unknown);
                system.number.push_back(model_.number[branch]);
            } else {
                const Value& probability = numbers_[model_.number[branch]];
                constant += probability * equations_.values[target];
                outside += probability;
            }
        }
        system.first_entry.push_back(system.unknown.size());
        system.constant.push_back(std::move(constant));
        system.outside.push_back(std::move(outside));
        choices_.push_back(choice);
    }

    /// Sets the value of all members of a class. In an end component, the strategy moves to the state whose choice
    /// leaves the component.
    void set(State first, const Value& value, std::uint32_t choice) {
        classes_.for_each_member(first, [&](State member) { equations_.values[member] = value; });
        if (!equations_.goal.precision.strategy || choice == none) return;
        if (const EndComponent* component = classes_.end_component(first))
            lead_to(equations_.graph, *component, choice, strategy_);
        else
            strategy_[first] = choice;
    }

    Equations<Value>& equations_;
    const Model& model_;
    std::vector<std::uint32_t>& strategy_;
    std::string& shortfall_;
    const Classes classes_;
    const std::vector<Value> numbers_;
    std::vector<std::uint32_t> place_;    // by class of one component: its index among the unknowns
    std::vector<std::uint32_t> choices_;  // the model's choices for that component's rows
};

}  // namespace

template <class Value>
void solve(Equations<Value>& equations, std::vector<std::uint32_t>& strategy, std::string& shortfall) {
    Solver<Value>(equations, strategy, shortfall).run();
}

template void solve(Equations<Interval>&, std::vector<std::uint32_t>&, std::string&);
template void solve(Equations<Rational>&, std::vector<std::uint32_t>&, std::string&);

}  // namespace robochart::markov
