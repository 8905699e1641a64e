// SPDX-License-Identifier: Apache-2.0
// See commands.hpp.
#include "prism/explore/commands.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/splitmix64.hpp"
#include "prism/explore/rules.hpp"

namespace robochart::prism {

LeftOut::LeftOut(const CheckedModel& model, Code& code) : code_(code) {
    if (model.left_out) root_ = code.compile(model.left_out);
}

void LeftOut::refuse_left_out(StateValues state) const {
    if (root_ && code_.holds(*root_, state)) throw EvaluationError(rules::left_out, code_.span(*root_), {});
}

CommandTable::CommandTable(const CheckedModel& model, const Layout& layout, Code& code, NumberTable& numbers,
                           diagnostics::Diagnostics& diagnostics)
    : model_(model), layout_(layout), code_(code), numbers_(numbers), diagnostics_(diagnostics) {
    for (std::size_t i = 0; i < model.modules.size(); ++i)
        for (const Command& command : model.modules[i].commands) {
            groups_[group({i, command.action.text})].push_back(static_cast<std::uint32_t>(commands_.size()));
            add_command(command);
        }
    for (const Synchronisation& synchronisation : model.synchronisations) {
        Act act{action(synchronisation.action), {}};
        for (const ActionOfModule& part : synchronisation.parts) act.groups.push_back(group(part));
        acts_.push_back(std::move(act));
    }
    enabled_.resize(groups_.size());
}

std::uint32_t CommandTable::group(const ActionOfModule& part) {
    const auto found = std::ranges::find(group_names_, part);
    if (found == group_names_.end()) {
        group_names_.push_back(part);
        groups_.emplace_back();
        return static_cast<std::uint32_t>(groups_.size() - 1);
    }
    return static_cast<std::uint32_t>(found - group_names_.begin());
}

std::uint32_t CommandTable::action(const std::string& name) {
    const auto found = std::ranges::find(actions_, name);
    if (found == actions_.end()) actions_.push_back(name);
    return static_cast<std::uint32_t>(std::ranges::find(actions_, name) - actions_.begin());
}

void CommandTable::add_command(const Command& command) {
    CodedCommand coded;
    coded.source = &command;
    coded.guard = code_.compile(command.guard);
    for (const Branch& branch : command.branches) {
        CodedBranch made;
        if (branch.probability) made.probability = probability(branch.probability);
        coded.fixed = coded.fixed && made.probability.fixed;
        for (const Assignment& assignment : branch.assignments) {
            const auto variable = std::ranges::find_if(
                model_.variables, [&](const Variable& v) { return v.name.text == assignment.variable.text; });
            made.assignments.emplace_back(static_cast<std::uint32_t>(variable - model_.variables.begin()),
                                          code_.compile(assignment.value));
            made.spans.push_back(assignment.value->span);
        }
        coded.branches.push_back(std::move(made));
    }
    commands_.push_back(std::move(coded));
}

CommandTable::Probability CommandTable::probability(const ExprPtr& expr) {
    Probability result;
    result.root = code_.compile(expr);
    result.span = expr->span;
    result.variables = code_.variables(result.root);
    result.fixed = code_.is_constant(result.root);
    if (result.fixed) result.id = numbers_.id(code_.real(result.root, nullptr));
    return result;
}

void CommandTable::evaluate_guards(StateValues state) {
    writes_.clear();
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        enabled_[i].clear();
        for (const std::uint32_t command : groups_[i])
            if (code_.holds(commands_[command].guard, state)) enabled_[i].push_back(command);
    }
}

void CommandTable::evaluate(StateValues state) {
    evaluate_guards(state);
    acting_.assign(groups_.size(), false);
    for (const Act& act : acts_)
        if (std::ranges::none_of(act.groups, [&](std::uint32_t group) { return enabled_[group].empty(); }))
            for (const std::uint32_t group : act.groups) acting_[group] = true;
    for (std::size_t i = 0; i < groups_.size(); ++i)
        if (acting_[i])
            for (const std::uint32_t command : enabled_[i]) evaluate_effects(commands_[command], state);
}

NumberTable::Id CommandTable::evaluate_probability(Probability& probability, StateValues state) {
    if (probability.fixed) return probability.id;
    constexpr std::size_t most_known = 1U << 16U;
    std::vector<std::int32_t> values;
    std::uint64_t hash = 0;
    for (const std::uint32_t variable : probability.variables) {
        values.push_back(state[variable]);
        hash = diagnostics::splitmix64_mixed(hash + static_cast<std::uint32_t>(state[variable]));
    }
    auto& known = probability.known;
    if (const auto found = known.find(hash); found != known.end())
        for (const auto& [before, id] : found->second)
            if (before == values) return id;
    const NumberTable::Id id = numbers_.id(code_.real(probability.root, state));
    if (known.size() > most_known) known.clear();
    known[hash].emplace_back(std::move(values), id);
    return id;
}

void CommandTable::check_probability(const Probability& probability, NumberTable::Id id) {
    if (id < proper_.size() && proper_[id]) return;
    const Real& value = numbers_[id];
    const std::optional<int> low = value.compare(Real(std::int64_t{0}));
    const std::optional<int> high = value.compare(Real(std::int64_t{1}) + Real(Rational(1, 100'000)));
    if (!low)
        throw EvaluationError(rules::too_close, probability.span,
                              {fmt::format("it is unknown whether the probability, {}, is 0", value.text())});
    if (*low < 0 || high == 1) throw EvaluationError(rules::bad_probability, probability.span, {value.text()});
    if (id >= proper_.size()) proper_.resize(numbers_.size());
    proper_[id] = true;
}

void CommandTable::evaluate_effects(CodedCommand& command, StateValues state) {
    command.effects.clear();
    for (CodedBranch& branch : command.branches) {
        Effect effect;
        effect.probability = evaluate_probability(branch.probability, state);
        check_probability(branch.probability, effect.probability);
        if (effect.probability == NumberTable::zero) continue;
        write_values(branch, effect, state);
        command.effects.push_back(effect);
    }
    check_sum(command);
}

void CommandTable::write_values(const CodedBranch& branch, Effect& effect, StateValues state) {
    effect.first_write = static_cast<std::uint32_t>(writes_.size());
    for (std::size_t i = 0; i < branch.assignments.size(); ++i) {
        const auto& [variable, root] = branch.assignments[i];
        const std::int64_t value = code_.integer(root, state);
        const Layout::Field& field = layout_.fields()[variable];
        if (value < field.low || value > field.high)
            throw EvaluationError(
                rules::out_of_range, branch.spans[i],
                {field.name, fmt::format("{}", value), fmt::format("[{}..{}]", field.low, field.high)});
        writes_.push_back({variable, value});
    }
    effect.end_write = static_cast<std::uint32_t>(writes_.size());
}

void CommandTable::check_sum(CodedCommand& command) {
    NumberTable::Id sum = NumberTable::zero;
    for (const Effect& effect : command.effects) sum = numbers_.sum(sum, effect.probability);
    if (sum == NumberTable::one) return;
    const Real& total = numbers_[sum];
    const Enclosure bounds = total.bounds();
    if (!total.is_exact() && bounds.low <= 1 && bounds.high >= 1) return;
    constexpr double tolerance = 1e-5;
    if (sum == NumberTable::zero || bounds.low < 1 - tolerance || bounds.high > 1 + tolerance)
        throw EvaluationError(rules::wrong_sum, command.source->span, {total.text()});
    if (!command.warned) diagnostics_.report(rules::normalised, command.source->span, {total.text()});
    command.warned = true;
    for (Effect& effect : command.effects) effect.probability = numbers_.quotient(effect.probability, sum);
}

}  // namespace robochart::prism
