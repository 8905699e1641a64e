// SPDX-License-Identifier: Apache-2.0
// See walk.hpp.
#include "prism/sampling/walk.hpp"

#include <algorithm>

#include "prism/sampling/unsampled.hpp"

namespace robochart::prism {
namespace {

constexpr std::uint64_t most_combinations = std::uint64_t{1} << 32U;

}  // namespace

std::vector<std::int32_t> sampled_from(const Instance& instance, Code& code, diagnostics::Budget* budget) {
    if (instance.model().kind != ModelKind::dtmc)
        throw Unsampled("samples of an mdp need a scheduler, such as --scheduler uniform");
    std::vector<std::int32_t> result;
    std::size_t found = 0;
    list_initial_states(instance, code, budget, [&](const std::int32_t* values) {
        if (++found > 1) throw Unsampled("paths are sampled from one initial state, but the model has several");
        result.assign(values, values + instance.layout().fields().size());
    });
    return result;
}

Walk::Walk(const Instance& instance, Code& code, std::vector<std::int32_t> initial,
           diagnostics::Diagnostics& diagnostics)
    : instance_(instance),
      commands_(instance.model(), instance.layout(), code, numbers_, diagnostics),
      left_out_(instance.model(), code),
      initial_(std::move(initial)),
      variables_(initial_.size()),
      values_(variables_ + 2) {}

void Walk::begin(const Draws& draws) {
    draws_ = draws;
    std::ranges::copy(initial_, values_.begin());
    length_ = 0;
    period_.reset();
    anchor_ = initial_;
    anchored_at_ = 0;
    patience_ = 1;
    find_enabled_combinations();
}

/// Finds the combinations of commands that are possible next. This also decides the label "deadlock".
void Walk::find_enabled_combinations() {
    try {
        left_out_.refuse_left_out(values_.data());
        commands_.evaluate_guards(values_.data());
    } catch (EvaluationError& error) {
        error.state = instance_.layout().state_text(values_.data());
        throw;
    }
    enabled_ = 0;
    for (const CommandTable::Act& act : commands_.acts()) enabled_ += combinations(act);
    values_[variables_] = enabled_ == 0 ? 1 : 0;
    values_[variables_ + 1] = std::equal(initial_.begin(), initial_.end(), values_.begin()) ? 1 : 0;
}

std::uint64_t Walk::combinations(const CommandTable::Act& act) const {
    std::uint64_t count = 1;
    for (const std::uint32_t group : act.groups) {
        count *= commands_.enabled_commands(group).size();
        if (count > most_combinations)
            throw diagnostics::LimitReached("a state of a path has more than 2^32 combinations of commands");
    }
    return count;
}

/// Draws one of the combinations.
std::optional<std::uint32_t> Walk::choose() {
    forced_ = enabled_ <= 1;
    chosen_.clear();
    act_ = nullptr;
    std::uint64_t number = forced_ ? 0 : draws_.draw_below(enabled_);
    for (const CommandTable::Act& act : commands_.acts()) {
        const std::uint64_t count = combinations(act);
        if (number >= count) {
            number -= count;
            continue;
        }
        for (const std::uint32_t group : act.groups) {
            const std::vector<std::uint32_t>& enabled = commands_.enabled_commands(group);
            chosen_.push_back(enabled[number % enabled.size()]);
            number /= enabled.size();
        }
        act_ = &act;
        return act.action;
    }
    return std::nullopt;
}

std::vector<std::string> Walk::moving_modules() const {
    std::vector<std::string> result;
    if (act_ != nullptr)
        for (const std::uint32_t group : act_->groups) result.push_back(commands_.module(group));
    return result;
}

/// Executes the drawn commands. Right-hand sides read the old state, so all are evaluated before the first write.
void Walk::step() {
    try {
        for (const std::uint32_t command : chosen_) commands_.evaluate_effects(command, values_.data());
    } catch (EvaluationError& error) {
        error.state = instance_.layout().state_text(values_.data());
        throw;
    }
    for (const std::uint32_t command : chosen_) {
        const Effect& effect = draw_effect(command);
        for (std::uint32_t i = effect.first_write; i < effect.end_write; ++i) {
            const Write& write = *commands_.write(i);
            values_[write.variable] = static_cast<std::int32_t>(write.value);
        }
    }
    ++length_;
    watch_for_repetition();
    find_enabled_combinations();
}

const Effect& Walk::draw_effect(std::uint32_t command) {
    const std::vector<Effect>& effects = commands_.effects_of(command);
    if (effects.size() == 1) return effects.front();
    forced_ = false;
    double left = draws_.draw_unit();
    for (std::size_t i = 0; i + 1 < effects.size(); ++i) {
        left -= probability(effects[i].probability);
        if (left < 0) return effects[i];
    }
    return effects.back();
}

double Walk::probability(NumberTable::Id id) {
    for (std::size_t next = doubles_.size(); next <= id; ++next)
        doubles_.push_back(numbers_[static_cast<NumberTable::Id>(next)].bounds().middle());
    return doubles_[id];
}

void Walk::watch_for_repetition() {
    const auto same = [&] { return std::equal(anchor_.begin(), anchor_.end(), values_.begin()); };
    if (period_) return;
    if (forced_ && same()) period_ = length_ - anchored_at_;
    if (forced_ && length_ - anchored_at_ < patience_) return;
    patience_ = forced_ ? 2 * patience_ : 1;
    std::copy_n(values_.begin(), variables_, anchor_.begin());
    anchored_at_ = length_;
}

}  // namespace robochart::prism
