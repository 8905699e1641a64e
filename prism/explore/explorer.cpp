// SPDX-License-Identifier: Apache-2.0
// See explorer.hpp.
#include "prism/explore/explorer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "prism/explore/rules.hpp"

namespace robochart::prism {

Explorer::Explorer(StateSpace& space, Code& code)
    : space_(space),
      code_(code),
      commands_(space.model(), space.layout(), code, numbers_, space.diagnostics_),
      values_(space.layout().fields().size()),
      left_out_(space.model(), code) {
    std::size_t parts = 0;
    for (const CommandTable::Act& act : commands_.acts()) parts = std::max(parts, act.groups.size());
    partial_.assign(parts + 1, std::vector<lts::Word>(space.layout().words()));
    chosen_.resize(parts);
}

void Explorer::operator()() {
    markov::Model& chain = space_.chain_;
    chain.kind = space_.model().kind == ModelKind::dtmc ? markov::Kind::dtmc : markov::Kind::mdp;
    chain.actions = commands_.actions();
    chain.first_choice.push_back(0);
    chain.first_branch.push_back(0);
    initial_states();
    for (std::size_t state = 0; state < space_.store_.size(); ++state) {
        if (space_.options_.budget != nullptr) space_.options_.budget->poll();
        try {
            expand(static_cast<markov::State>(state));
        } catch (EvaluationError& error) {
            error.state = space_.layout().state_text(values_.data());
            throw;
        }
    }
    finish_model();
}

void Explorer::initial_states() {
    std::vector<lts::Word> words(space_.layout().words());
    list_initial_states(space_.instance_, code_, space_.options_.budget, [&](const std::int32_t* values) {
        space_.layout().pack(values, words.data());
        const markov::State state = insert(words.data());
        if (space_.chain_.initial.empty() || space_.chain_.initial.back() < state)
            space_.chain_.initial.push_back(state);
    });
}

markov::State Explorer::insert(const lts::Word* words) {
    const auto [index, fresh] = space_.store_.insert({words, space_.layout().words()});
    if (fresh && space_.store_.size() > space_.options_.max_states)
        throw diagnostics::LimitReached(
            fmt::format("the model has more than {} states (--max-states)", space_.options_.max_states));
    return index;
}

void Explorer::expand(markov::State state) {
    const lts::StateView packed = space_.store_[state];
    space_.layout().unpack(packed, values_.data());
    left_out_.refuse_left_out(values_.data());
    commands_.evaluate(values_.data());
    partial_[0].assign(packed.begin(), packed.end());
    all_.clear();
    combinations_ = 0;
    for (const CommandTable::Act& act : commands_.acts()) explore_act(act);
    finish_state(state);
}

/// Adds the choices of a synchronisation: every combination of one enabled command of each part is a choice.
void Explorer::explore_act(const CommandTable::Act& act) {
    for (const std::uint32_t group : act.groups)
        if (commands_.enabled_commands(group).empty()) return;
    Distribution choice;
    combine(act, 0, choice);
}

void Explorer::combine(const CommandTable::Act& act, std::size_t part, Distribution& distribution) {
    if (part < act.groups.size()) {
        for (const std::uint32_t command : commands_.enabled_commands(act.groups[part])) {
            chosen_[part] = command;
            combine(act, part + 1, distribution);
        }
        return;
    }
    if (space_.options_.budget != nullptr) space_.options_.budget->poll();
    ++combinations_;
    const bool chain = space_.chain_.kind == markov::Kind::dtmc;
    if (chain) return branch(act, 0, NumberTable::one, all_);
    distribution.clear();
    branch(act, 0, NumberTable::one, distribution);
    merge_branches(distribution);
    push_choice(act.action, distribution);
}

/// Multiplies probabilities and combines updates.
void Explorer::branch(const CommandTable::Act& act, std::size_t part, NumberTable::Id probability,
                      Distribution& distribution) {
    if (part == act.groups.size()) {
        distribution.emplace_back(insert(partial_[part].data()), probability);
        return;
    }
    for (const Effect& effect : commands_.effects_of(chosen_[part])) {
        std::vector<lts::Word>& next = partial_[part + 1];
        next = partial_[part];
        const Write* const end = commands_.write(effect.end_write);
        for (const Write* write = commands_.write(effect.first_write); write != end; ++write)
            space_.layout().set(next.data(), write->variable, write->value);
        branch(act, part + 1, numbers_.product(probability, effect.probability), distribution);
    }
}

/// Combines branches with the same target.
void Explorer::merge_branches(Distribution& distribution) {
    std::ranges::stable_sort(distribution, [](const auto& a, const auto& b) { return a.first < b.first; });
    std::size_t last = 0;
    for (std::size_t i = 1; i < distribution.size(); ++i) {
        if (distribution[i].first == distribution[last].first)
            distribution[last].second = numbers_.sum(distribution[last].second, distribution[i].second);
        else
            distribution[++last] = distribution[i];
    }
    distribution.resize(distribution.empty() ? 0 : last + 1);
}

void Explorer::push_choice(std::uint32_t action, const Distribution& distribution) {
    markov::Model& chain = space_.chain_;
    for (const auto& [target, number] : distribution) {
        chain.target.push_back(target);
        chain.number.push_back(number);
    }
    chain.first_branch.push_back(chain.target.size());
    if (chain.kind == markov::Kind::mdp) chain.action.push_back(action);
    constexpr std::size_t most = 0xfffffff0U;
    if (chain.choices() > most)
        throw diagnostics::LimitReached("the model has more than four thousand million choices");
}

NumberTable::Id Explorer::number_of(std::uint64_t count) {
    constexpr std::uint64_t few = 256;
    if (count >= few) return numbers_.id(Real(static_cast<std::int64_t>(count)));
    while (counts_.size() <= count) counts_.push_back(numbers_.id(Real(static_cast<std::int64_t>(counts_.size()))));
    return counts_[count];
}

/// Stores the choices of a state. In a dtmc all combinations are equally likely. A state without combinations gets a
/// loop.
void Explorer::finish_state(markov::State state) {
    markov::Model& chain = space_.chain_;
    const bool deadlock = combinations_ == 0;
    space_.deadlocks_.push_back(deadlock);
    if (deadlock) {
        ++space_.deadlock_count_;
        push_choice(0, {{state, NumberTable::one}});
    } else if (chain.kind == markov::Kind::dtmc) {
        merge_branches(all_);
        const NumberTable::Id count = number_of(combinations_);
        for (auto& [target, number] : all_) number = numbers_.quotient(number, count);
        push_choice(0, all_);
    }
    chain.first_choice.push_back(static_cast<std::uint32_t>(chain.choices()));
}

void Explorer::finish_model() {
    markov::Model& chain = space_.chain_;
    bool exact = true;
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        const Real& number = numbers_[static_cast<NumberTable::Id>(i)];
        const Enclosure bounds = number.bounds();
        chain.numbers.push_back({std::max(0.0, bounds.low), bounds.high});
        if (number.is_exact()) chain.exact.push_back(number.value());
        if (!number.is_exact() && space_.options_.exact)
            throw EvaluationError(rules::not_exact, {}, {fmt::format("the probability {}", number.text())});
        exact = exact && number.is_exact();
    }
    if (!exact) chain.exact.clear();
    const std::uint64_t count = space_.deadlock_count_;
    if (count == 0) return;
    const auto first = std::ranges::find(space_.deadlocks_, true) - space_.deadlocks_.begin();
    auto& finding =
        space_.diagnostics_.report(rules::deadlocks, {}, {count == 1 ? "one state" : fmt::format("{} states", count)});
    finding.notes.push_back(
        {{},
         fmt::format("{}{}", count == 1 ? "" : "the first: ", space_.state_text(static_cast<markov::State>(first)))});
}

}  // namespace robochart::prism
