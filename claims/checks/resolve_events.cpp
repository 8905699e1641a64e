// SPDX-License-Identifier: Apache-2.0
// See resolve_events.hpp.
#include "claims/checks/resolve_events.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/spelling.hpp"
#include "claims/checks/rules.hpp"

namespace robochart::claims {
namespace {

bool has_direction(const Channel& channel, Direction direction) {
    switch (direction) {
        case Direction::none:
            return true;
        case Direction::input:
        case Direction::raised:
            return channel.kind == ChannelKind::input;
        case Direction::output:
            return channel.kind == ChannelKind::output;
        case Direction::call:
            return channel.kind == ChannelKind::call;
    }
    return false;
}

}  // namespace

std::string EventResolver::written(Span span) const {
    std::string result;
    for (const char c : sources_.source_text(span.source).substr(span.begin, span.end - span.begin)) {
        const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
        if (!blank)
            result += c;
        else if (!result.empty() && result.back() != ' ')
            result += ' ';
    }
    return result;
}

// ---------------------------------------------------------------- events

Events EventResolver::resolve(const EventSet& events) {
    Events result;
    for (const Pattern& pattern : events.patterns) {
        if (pattern.kind == PatternKind::start)
            result.start = true;
        else if (pattern.kind == PatternKind::terminate)
            result.terminate = true;
        else
            result.any.push_back(resolve_pattern(pattern));
    }
    if (!events.patterns.empty()) result.text = written(events.span);
    return result;
}

EventMatch EventResolver::resolve_change(const Pattern& pattern) {
    EventMatch result;
    result.span = pattern.span;
    result.text = written(pattern.span);
    result.change = pattern.kind == PatternKind::enter ? Change::begins : Change::ends;
    result.fact = facts_.fact_of_state(pattern.name);
    return result;
}

EventMatch EventResolver::resolve_pattern(const Pattern& pattern) {
    if (pattern.kind == PatternKind::enter || pattern.kind == PatternKind::leave) return resolve_change(pattern);
    if (pattern.kind != PatternKind::named) return resolve_any(pattern);
    EventMatch result;
    const std::size_t at = find_channel(pattern.name, pattern.direction);
    const Channel& channel = claim_.component.channels[at];
    result.channels = {at};
    result.span = pattern.span;
    result.text = written(pattern.span);
    if (pattern.direction == Direction::raised) claim_.raised = true;
    Variables variables;
    std::vector<Condition> conditions;
    if (pattern.arguments) add_arguments(pattern, channel, variables, conditions);
    if (pattern.condition) {
        conditions.push_back(conditions_.resolve_truth(*pattern.condition, leaf_of(channel, variables)));
    }
    if (!conditions.empty()) result.condition = operation(Op::conjunction, std::move(conditions));
    return result;
}

EventMatch EventResolver::resolve_any(const Pattern& pattern) {
    EventMatch result;
    result.span = pattern.span;
    result.text = written(pattern.span);
    const ChannelKind kind = pattern.kind == PatternKind::any_call ? ChannelKind::call : ChannelKind::input;
    const std::vector<Channel>& channels = claim_.component.channels;
    for (std::size_t i = 0; i < channels.size(); ++i)
        if (channels[i].kind == kind) result.channels.push_back(i);
    for (const Pattern& exception : pattern.but) {
        if (exception.kind != PatternKind::named || exception.condition || exception.arguments)
            conditions_.refuse(exception.span, "an exception is the name of an event or an operation");
        const std::size_t left_out = find_channel(exception.name, exception.direction);
        if (channels[left_out].kind != kind)
            conditions_.refuse(exception.span, fmt::format("`{}` is no {}", exception.name.text,
                                                           kind == ChannelKind::call ? "operation" : "input"));
        std::erase(result.channels, left_out);
    }
    return result;
}

void EventResolver::report_unknown(const Name& name) {
    const Component& component = claim_.component;
    if (facts_.has_state(name.text))
        conditions_.refuse(name.span,
                           fmt::format("`{}` is a state: write `always not in {}`, `enter {}`, or `while in {}, "
                                       "...`",
                                       name.text, name.text, name.text, name.text));
    if (std::ranges::find(component.defined, name.text) != component.defined.end()) {
        diagnostics_.report(rules::defined_operation, name.span, {name.text, component.path})
            .notes.push_back({{}, "claim something of the calls that the operation makes"});
        throw ClaimError{};
    }
    std::vector<std::string> names;
    for (const Channel& channel : component.channels) names.push_back(channel.name);
    const std::string meant = diagnostics::nearest_spelling(name.text, names);
    auto& finding = diagnostics_.report(
        rules::unknown_event, name.span,
        {name.text, component.path, meant.empty() ? "" : fmt::format("; did you mean `{}`?", meant)});
    if (!meant.empty()) finding.fixes.push_back({name.span, meant, fmt::format("write `{}`", meant)});
    throw ClaimError{};
}

std::size_t EventResolver::find_channel(const Name& name, Direction direction) {
    const std::vector<Channel>& channels = claim_.component.channels;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < channels.size(); ++i)
        if (channels[i].name == name.text && has_direction(channels[i], direction)) found.push_back(i);
    if (found.empty()) report_unknown(name);
    if (found.size() > 1) {
        auto& finding = diagnostics_.report(rules::open_direction, name.span,
                                            {claim_.component.path, name.text, name.text, name.text});
        finding.fixes.push_back({name.span, "in " + name.text, "what it receives"});
        finding.fixes.push_back({name.span, "out " + name.text, "what it sends"});
        throw ClaimError{};
    }
    return found.front();
}

void EventResolver::add_arguments(const Pattern& pattern, const Channel& channel, Variables& variables,
                                  std::vector<Condition>& conditions) {
    const auto& arguments = *pattern.arguments;
    const Variables no_variables;
    if (arguments.size() != channel.types.size())
        conditions_.refuse(pattern.span,
                           fmt::format("`{}` carries {} value{}, not {}", channel.name, channel.types.size(),
                                       channel.types.size() == 1 ? "" : "s", arguments.size()));
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const Expr& written_argument = *arguments[i];
        const bool name = written_argument.op == Op::name;
        if (name && written_argument.text == "_") continue;
        const bool literal = name && conditions_.find_literal(written_argument.text).has_value();
        if (name && !literal) {
            if (!variables.emplace(written_argument.text, i).second)
                conditions_.refuse(written_argument.span, fmt::format("`{}` names two values", written_argument.text));
            continue;
        }
        const Typed value = conditions_.resolve(written_argument, leaf_of(channel, no_variables));
        const Typed argument =
            conditions_.typed_operand(operand_of(Operand::argument, i), channel.types[i], written_argument.span);
        if (value.sort != argument.sort || (value.sort == Sort::literal && value.type != argument.type))
            conditions_.refuse(written_argument.span, fmt::format("this value of `{}` has the type {}", channel.name,
                                                                  system_.type(channel.types[i]).name));
        conditions.push_back(operation(Op::equal, {argument.condition, value.condition}));
    }
}

// ---------------------------------------------------------------- conditions

/// Returns the index of the remembered channel. A channel is remembered once, even if the claim reads its last value at
/// several places.
std::size_t EventResolver::remember(const Expr& expr) {
    const std::size_t channel = find_channel({expr.text, expr.span}, Direction::none);
    if (claim_.component.channels[channel].types.size() != 1)
        conditions_.refuse(expr.span, fmt::format("`last {}` is the value of an event with one value", expr.text));
    const auto known = std::ranges::find(claim_.remembered, channel);
    if (known != claim_.remembered.end()) return static_cast<std::size_t>(known - claim_.remembered.begin());
    claim_.remembered.push_back(channel);
    return claim_.remembered.size() - 1;
}

Typed EventResolver::resolve_name(const Expr& expr, const Channel& channel, const Variables& variables) {
    if (const auto found = variables.find(expr.text); found != variables.end())
        return conditions_.typed_operand(operand_of(Operand::argument, found->second), channel.types[found->second],
                                         expr.span);
    if (auto literal = conditions_.find_literal(expr.text)) return std::move(*literal);
    conditions_.refuse(
        expr.span, fmt::format("`{}` is no value here: name the values of the event, `{}(v)`, or write a literal as "
                               "`Type::Literal`",
                               expr.text, channel.name));
}

/// Resolves the names of the event's values, literals, and last values.
Typed EventResolver::resolve_leaf(const Expr& expr, const Channel& channel, const Variables& variables) {
    if (expr.op == Op::in_state)
        conditions_.refuse(expr.span,
                           "the condition of an event is about its values; `while in S, ...` is about a state");
    if (expr.op == Op::name) return resolve_name(expr, channel, variables);
    const std::size_t index = remember(expr);
    const Channel& of = claim_.component.channels[claim_.remembered[index]];
    return conditions_.typed_operand(operand_of(Operand::last, index), of.types.front(), expr.span);
}

ConditionResolver::Leaf EventResolver::leaf_of(const Channel& channel, const Variables& variables) {
    return [&](const Expr& expr) { return resolve_leaf(expr, channel, variables); };
}

}  // namespace robochart::claims
