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

Condition operand_of(Operand operand, std::size_t index) {
    Condition result;
    result.operand = operand;
    result.index = index;
    return result;
}

Condition constant_of(Fraction value) {
    Condition result;
    result.operand = Operand::constant;
    result.value = value;
    return result;
}

Condition operation(Op op, std::vector<Condition> parts) {
    Condition result;
    result.op = op;
    result.parts = std::move(parts);
    return result;
}

bool is_comparison(Op op) {
    return op == Op::less || op == Op::less_equal || op == Op::greater || op == Op::greater_equal;
}

}  // namespace

void EventResolver::refuse(Span span, std::string text) {
    diagnostics_.report(rules::wrong_value, span, {std::move(text)});
    throw ClaimError{};
}

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

EventMatch EventResolver::resolve_pattern(const Pattern& pattern) {
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
        Typed condition = resolve_expr(*pattern.condition, channel, variables);
        if (condition.sort != Sort::truth) refuse(pattern.condition->span, "this is no condition");
        conditions.push_back(std::move(condition.condition));
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
            refuse(exception.span, "an exception is the name of an event or an operation");
        const std::size_t left_out = find_channel(exception.name, exception.direction);
        if (channels[left_out].kind != kind)
            refuse(exception.span, fmt::format("`{}` is no {}", exception.name.text,
                                               kind == ChannelKind::call ? "operation" : "input"));
        std::erase(result.channels, left_out);
    }
    return result;
}

void EventResolver::report_unknown(const Name& name) {
    const Component& component = claim_.component;
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
    if (arguments.size() != channel.types.size())
        refuse(pattern.span, fmt::format("`{}` carries {} value{}, not {}", channel.name, channel.types.size(),
                                         channel.types.size() == 1 ? "" : "s", arguments.size()));
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const Expr& written_argument = *arguments[i];
        const bool name = written_argument.op == Op::name;
        if (name && written_argument.text == "_") continue;
        const bool literal = name && find_literal(written_argument.text).has_value();
        if (name && !literal) {
            if (!variables.emplace(written_argument.text, i).second)
                refuse(written_argument.span, fmt::format("`{}` names two values", written_argument.text));
            continue;
        }
        const Typed value = resolve_expr(written_argument, channel, {});
        const Typed argument = typed_operand(operand_of(Operand::argument, i), channel.types[i], written_argument.span);
        if (value.sort != argument.sort || (value.sort == Sort::literal && value.type != argument.type))
            refuse(written_argument.span, fmt::format("this value of `{}` has the type {}", channel.name,
                                                      system_.type(channel.types[i]).name));
        conditions.push_back(operation(Op::equal, {argument.condition, value.condition}));
    }
}

// ---------------------------------------------------------------- conditions

EventResolver::Typed EventResolver::typed_operand(Condition condition, ir::TypeId type, Span span) {
    const ir::Type& of = system_.type(type);
    switch (of.kind) {
        case ir::TypeKind::nat:
        case ir::TypeKind::integer:
        case ir::TypeKind::real:
            return {std::move(condition), Sort::number, {}};
        case ir::TypeKind::boolean:
            return {std::move(condition), Sort::truth, {}};
        case ir::TypeKind::enumeration:
            if (std::ranges::all_of(of.literal_args, [](const auto& arguments) { return arguments.empty(); }))
                return {std::move(condition), Sort::literal, type};
            break;
        case ir::TypeKind::string:
        case ir::TypeKind::given:
        case ir::TypeKind::sequence:
        case ir::TypeKind::set:
        case ir::TypeKind::product:
        case ir::TypeKind::record:
        case ir::TypeKind::function:
        case ir::TypeKind::relation:
        case ir::TypeKind::vector:
        case ir::TypeKind::matrix:
        case ir::TypeKind::unit:
            break;
    }
    refuse(span, fmt::format("conditions are about numbers, truth values and literals, not about values of the type {}",
                             of.name));
}

/// Two remembered values of one channel are one.
std::size_t EventResolver::remember(const Expr& expr) {
    const std::size_t channel = find_channel({expr.text, expr.span}, Direction::none);
    if (claim_.component.channels[channel].types.size() != 1)
        refuse(expr.span, fmt::format("`last {}` is the value of an event with one value", expr.text));
    const auto known = std::ranges::find(claim_.remembered, channel);
    if (known != claim_.remembered.end()) return static_cast<std::size_t>(known - claim_.remembered.begin());
    claim_.remembered.push_back(channel);
    return claim_.remembered.size() - 1;
}

std::optional<EventResolver::Typed> EventResolver::find_literal(const std::string& text) const {
    std::optional<Typed> found;
    for (std::uint32_t i = 0; i < system_.types.size(); ++i) {
        const ir::Type& type = system_.types[i];
        if (type.kind != ir::TypeKind::enumeration) continue;
        for (std::size_t label = 0; label < type.labels.size(); ++label) {
            const std::string name = type.name + "::" + type.labels[label];
            if (text != type.labels[label] && text != name && text != type.package + "::" + name) continue;
            if (found) return std::nullopt;
            found = Typed{constant_of(Fraction(static_cast<std::int64_t>(label))), Sort::literal, ir::TypeId{i}};
        }
    }
    return found;
}

EventResolver::Typed EventResolver::resolve_name(const Expr& expr, const Channel& channel, const Variables& variables) {
    if (const auto found = variables.find(expr.text); found != variables.end())
        return typed_operand(operand_of(Operand::argument, found->second), channel.types[found->second], expr.span);
    if (auto literal = find_literal(expr.text)) return std::move(*literal);
    refuse(expr.span, fmt::format("`{}` is no value here: name the values of the event, `{}(v)`, or write a literal as "
                                  "`Type::Literal`",
                                  expr.text, channel.name));
}

EventResolver::Typed EventResolver::resolve_expr(const Expr& expr, const Channel& channel, const Variables& variables) {
    try {
        if (expr.op == Op::number) return {constant_of(Fraction::of_decimal(expr.text)), Sort::number, {}};
    } catch (const NotComputable& error) {
        refuse(expr.span, error.what());
    }
    if (expr.op == Op::truth) return {constant_of(Fraction(expr.text == "true" ? 1 : 0)), Sort::truth, {}};
    if (expr.op == Op::name) return resolve_name(expr, channel, variables);
    if (expr.op == Op::last) {
        const std::size_t index = remember(expr);
        const Channel& of = claim_.component.channels[claim_.remembered[index]];
        return typed_operand(operand_of(Operand::last, index), of.types.front(), expr.span);
    }
    return resolve_operator(expr, channel, variables);
}

EventResolver::Typed EventResolver::resolve_operator(const Expr& expr, const Channel& channel,
                                                     const Variables& variables) {
    std::vector<Typed> parts;
    for (const ExprPtr& part : expr.parts) parts.push_back(resolve_expr(*part, channel, variables));
    const auto require = [&](Sort sort, const char* what) {
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (parts[i].sort != sort) refuse(expr.parts[i]->span, fmt::format("this is no {}", what));
    };
    Sort sort = Sort::truth;
    if (expr.op == Op::negation || expr.op == Op::conjunction || expr.op == Op::disjunction) {
        require(Sort::truth, "condition");
    } else if (expr.op == Op::equal || expr.op == Op::unequal) {
        if (parts[0].sort != parts[1].sort || parts[0].type != parts[1].type)
            refuse(expr.span, "values of different types are compared");
    } else {
        require(Sort::number, "number");
        if (!is_comparison(expr.op)) sort = Sort::number;
    }
    std::vector<Condition> conditions;
    for (Typed& part : parts) conditions.push_back(std::move(part.condition));
    return {operation(expr.op, std::move(conditions)), sort, {}};
}

}  // namespace robochart::claims
