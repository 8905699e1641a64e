// SPDX-License-Identifier: Apache-2.0
// Computes the rewards of states. See state_space.hpp.
#include <fmt/format.h>

#include <algorithm>

#include "prism/explore/commands.hpp"
#include "prism/explore/rules.hpp"
#include "prism/explore/state_space.hpp"

namespace robochart::prism {

/// Adds up the rewards of matching items. In a dtmc, the single choice of a state represents all combinations of
/// commands, which are equally likely. So its reward is the mean of the rewards of the combinations.
class RewardTable {
public:
    RewardTable(const StateSpace& space, const RewardStructure& structure, bool exact)
        : space_(space),
          exact_(exact),
          code_(space.code({})),
          commands_(space.model(), space.layout(), code_, numbers_, unused_),
          values_(space.layout().fields().size()),
          by_action_(space.chain_.actions.size()) {
        result_.name = structure.name.text;
        for (const RewardItem& item : structure.items) {
            Item coded{&item, code_.compile(item.guard), code_.compile(item.value)};
            if (!item.transition) {
                of_states_.push_back(coded);
                continue;
            }
            const auto& actions = space.chain_.actions;
            const auto found = std::ranges::find(actions, item.action.text);
            if (found != actions.end()) by_action_[static_cast<std::size_t>(found - actions.begin())].push_back(coded);
            on_transitions_ = true;
        }
    }

    markov::Rewards operator()() {
        for (markov::State state = 0; state < space_.chain_.states(); ++state) {
            if (space_.options_.budget != nullptr) space_.options_.budget->poll();
            space_.unpack(state, values_.data());
            try {
                if (!of_states_.empty()) add(sum(of_states_), result_.state, result_.exact_state);
                if (on_transitions_) add_choice_rewards(state);
            } catch (EvaluationError& error) {
                error.state = space_.layout().state_text(values_.data());
                throw;
            }
        }
        return std::move(result_);
    }

private:
    struct Item {
        const RewardItem* source;
        Code::Root guard, value;
    };
    using Id = NumberTable::Id;

    Id sum(const std::vector<Item>& items) {
        Id result = NumberTable::zero;
        for (const Item& item : items) {
            if (!code_.holds(item.guard, values_.data())) continue;
            const Real value = code_.real(item.value, values_.data());
            if (value.compare(Real(std::int64_t{0})) == -1)
                throw EvaluationError(rules::negative_reward, item.source->value->span, {value.text()});
            if (!value.finite())
                throw EvaluationError(rules::arithmetic, item.source->value->span,
                                      {fmt::format("the reward is {}", value.text())});
            result = numbers_.sum(result, numbers_.id(value));
        }
        return result;
    }

    void add(Id id, std::vector<markov::Number>& numbers, std::vector<markov::Rational>& exact) {
        const Real& number = numbers_[id];
        const Enclosure bounds = number.bounds();
        numbers.push_back({std::max(0.0, bounds.low), bounds.high});
        if (!exact_) return;
        if (!number.is_exact())
            throw EvaluationError(rules::not_exact, {}, {fmt::format("the reward {}", number.text())});
        exact.push_back(number.value());
    }

    void add_choice_rewards(markov::State state) {
        const markov::Model& chain = space_.chain_;
        // A loop that was added at a deadlock earns no reward. Given states contain no such loops.
        const bool deadlock = space_.deadlocks_[state] && !space_.given_;
        if (chain.kind == markov::Kind::dtmc)
            return add(deadlock ? NumberTable::zero : mean_reward(), result_.choice, result_.exact_choice);
        for (std::size_t choice = chain.first_choice[state]; choice < chain.first_choice[state + 1]; ++choice)
            add(deadlock ? NumberTable::zero : sum(by_action_[chain.action[choice]]), result_.choice,
                result_.exact_choice);
    }

    Id mean_reward() {
        commands_.evaluate_guards(values_.data());
        std::vector<std::int64_t> combinations(by_action_.size());
        std::int64_t all = 0;
        for (const CommandTable::Act& act : commands_.acts()) {
            std::int64_t count = 1;
            for (const std::uint32_t group : act.groups)
                count *= static_cast<std::int64_t>(commands_.enabled_commands(group).size());
            combinations[act.action] += count;
            all += count;
        }
        Id result = NumberTable::zero;
        for (std::size_t action = 0; action < by_action_.size(); ++action)
            if (combinations[action] > 0 && !by_action_[action].empty())
                result = numbers_.sum(
                    result, numbers_.product(sum(by_action_[action]), numbers_.id(Real(combinations[action]))));
        return result == NumberTable::zero ? result : numbers_.quotient(result, numbers_.id(Real(all)));
    }

    const StateSpace& space_;
    bool exact_;
    Code code_;
    NumberTable numbers_;
    diagnostics::Diagnostics unused_;
    CommandTable commands_;
    std::vector<std::int32_t> values_;
    std::vector<Item> of_states_;
    std::vector<std::vector<Item>> by_action_;
    bool on_transitions_ = false;
    markov::Rewards result_;
};

markov::Rewards StateSpace::rewards(std::size_t structure, bool exact) const {
    return RewardTable(*this, model().rewards[structure], exact)();
}

}  // namespace robochart::prism
