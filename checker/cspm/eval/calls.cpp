// SPDX-License-Identifier: Apache-2.0
// Evaluates functions, constants and the members of a let. Matches patterns.
#include <algorithm>

#include "checker/cspm/eval/evaluator.hpp"

namespace robochart::cspm {

Value Evaluator::call(Value function, Values arguments, Span span) {
    if (function->kind == Kind::builtin) return by_need_.call(function, std::move(arguments), span);
    if (function->kind != Kind::function) work_.fail("expected a function, found " + text_(function), span);
    const Function& definition = *function->function;
    const std::size_t environment = definition.environment;
    const std::size_t given = function->items.size() - environment;
    std::size_t before = 0;
    std::size_t group = 0;
    while (group < definition.groups.size() && before < given) before += definition.groups[group++];
    if (group == definition.groups.size()) work_.fail("'" + definition.name + "' takes no more arguments", span);
    if (definition.groups[group] != arguments.size()) {
        work_.fail("'" + definition.name + "' takes " + std::to_string(definition.groups[group]) + " arguments, not " +
                       std::to_string(arguments.size()),
                   span);
    }
    if (group + 1 == definition.groups.size() && shape_.makes_process(definition)) {
        for (Value& argument : arguments) argument = share_value(argument);
        const process::TermId made = processes_.make_call(share_value(function), arguments);
        return store_.make(Kind::process, static_cast<std::int64_t>(made), {});
    }
    Values all(function->items.begin() + static_cast<std::ptrdiff_t>(environment), function->items.end());
    all.insert(all.end(), arguments.begin(), arguments.end());
    if (group + 1 < definition.groups.size()) {
        all.insert(all.begin(), function->items.begin(),
                   function->items.begin() + static_cast<std::ptrdiff_t>(environment));
        return store_.closure(definition, std::move(all));
    }
    const Value result = run_function(definition, function->items, all, span);
    if (observer_.tell) report_call(definition, all, result, span);
    return result;
}

/// Reports a call to the observer. Of the arguments, only numbers that are already evaluated are included.
void Evaluator::report_call(const Function& function, const Values& arguments, Value result, Span span) {
    if (function.watched < 0) function.watched = observer_.functions.contains(function.name) ? 1 : 0;
    if (function.watched == 0) return;
    // The observer must not evaluate an argument: its evaluation could fail or never end.
    const auto number = [](Value value) -> std::optional<std::int64_t> {
        if (value->kind == Kind::thunk) value = static_cast<const Thunk&>(*value).result;
        if (value == nullptr || value->kind != Kind::integer) return std::nullopt;
        return value->number;
    };
    ObservedCall observed{function.name, span, {}, number(result)};
    for (const Value argument : arguments) observed.values.push_back(number(argument));
    observer_.tell(observed);
}

Value Evaluator::run_function(const Function& function, const Values& environment, Values& arguments, Span span) {
    const Work::Calling calling(work_, function, arguments, span);
    Frame frame;
    const FunctionClause& clause = choose_clause(function, environment, arguments, frame, span);
    return eval(*clause.body, frame);
}

void Evaluator::fill_frame(const Unit& unit, const Function& function, const Values& environment, Frame& frame) {
    frame.assign(static_cast<std::size_t>(unit.size), nullptr);
    const bool member = unit.member_of != nullptr;
    if (member && unit.self_slot >= 0) frame[static_cast<std::size_t>(unit.self_slot)] = environment.at(0);
    for (std::size_t i = 0; i < unit.captures.size(); ++i) {
        const auto [from, to] = unit.captures[i];
        const Value value = member ? environment.at(0)->items.at(static_cast<std::size_t>(from)) : environment.at(i);
        frame[static_cast<std::size_t>(to)] = value;
    }
    (void)function;
}

const FunctionClause& Evaluator::choose_clause(const Function& function, const Values& environment, Values& arguments,
                                               Frame& frame, Span span) {
    for (const FunctionClause& clause : function.clauses) {
        fill_frame(*clause.unit, function, environment, frame);
        if (function.groups.empty()) return clause;
        bool matches = true;
        for (std::size_t i = 0; matches && i < clause.patterns.size(); ++i) {
            matches = match_pattern(clause.patterns[i], arguments[i], frame);
        }
        if (matches) return clause;
    }
    std::string given;
    text_.items(arguments, "(", ", ", ")", given);
    work_.fail("no clause of '" + function.name + "' matches " + given, span);
}

// ---------------------------------------------------------------- constants

Value Evaluator::constant_body(const Function& function, const Values& environment, Span span) {
    Values none;
    const Work::Calling calling(work_, function, none, span);
    const FunctionClause& clause = function.clauses.at(0);
    Frame frame;
    fill_frame(*clause.unit, function, environment, frame);
    Value value = eval(*clause.body, frame);
    const MatchCode& pattern = clause.patterns.at(0);
    if (pattern.kind != PatternKind::name || pattern.head) {
        if (!match_pattern(pattern, value, frame))
            work_.fail("the pattern does not match " + text_(value), function.span);
    }
    return value;
}

Value Evaluator::component_value(const FunctionClause& whole, Value value, int slot, Span span) {
    Frame frame(static_cast<std::size_t>(whole.unit->size), nullptr);
    if (!match_pattern(whole.patterns.at(0), value, frame))
        work_.fail("the pattern does not match " + text_(value), span);
    return evaluate_in_place(frame.at(static_cast<std::size_t>(slot)));
}

Value Evaluator::member_value(const GroupObject& group, int index, Span span) {
    const auto at = static_cast<std::size_t>(index);
    const Member& member = group.group->members[at];
    if (!member.function.groups.empty()) {
        return group.shared ? store_.make(Kind::function, 0, {&group}, &member.function)
                            : store_.closure(member.function, {&group});
    }
    if (group.known[at] != nullptr) return group.known[at];
    if (member.component_of < 0 && shape_.makes_process(member.function)) {
        const Value name = store_.make(Kind::function, 0, {share_value(&group)}, &member.function);
        return store_.make(Kind::process, static_cast<std::int64_t>(processes_.make_call(name, {})), {});
    }
    if (group.running[at]) work_.fail("'" + member.function.name + "' is defined by itself", span);
    group.running[at] = true;
    Value value = nullptr;
    try {
        value = member_constant(group, member);
    } catch (...) {
        group.running[at] = false;
        throw;
    }
    group.running[at] = false;
    if (group.shared && !value->shared) {
        try {
            value = share_value(value);
        } catch (const EvaluationError&) {
            return value;  // some part failed; the member is evaluated again when it is needed
        }
    }
    group.known[at] = value;
    return value;
}

Value Evaluator::member_constant(const GroupObject& group, const Member& member) {
    if (member.component_of < 0) return constant_body(member.function, {&group}, member.function.span);
    const Value whole = this->member_value(group, member.component_of, member.function.span);
    const Member& source = group.group->members[static_cast<std::size_t>(member.component_of)];
    return component_value(source.function.clauses.at(0), whole, member.component_slot, member.function.span);
}

Value Evaluator::global_value(int index, Span span) {
    Global& global = program_.globals[static_cast<std::size_t>(index)];
    if (global.kind == GlobalKind::function && !global.function.groups.empty()) {
        return store_.make(Kind::function, 0, {}, &global.function);
    }
    if (global.kind == GlobalKind::datatype) return store_.make(Kind::datatype, index, {});
    if (global.known != nullptr) return global.known;
    if (global.kind == GlobalKind::function && shape_.makes_process(global.function)) {
        const Value name = store_.make(Kind::function, 0, {}, &global.function);
        return global.known = store_.make(Kind::process, static_cast<std::int64_t>(processes_.make_call(name, {})), {});
    }
    if (global.lazily != nullptr && global.lazily_entry == work_.question()) return global.lazily;
    if (global.running) work_.fail("'" + global.function.name + "' is defined by itself", span);
    const Running running(global.running);
    const Value value = global_constant(global);
    if (value->shared) return global.known = value;
    try {
        return global.known = share_value(value);
    } catch (const EvaluationError&) {  // some part failed, but the script may need only the others
    }
    global.lazily_entry = work_.question();
    return global.lazily = value;
}

Value Evaluator::global_constant(Global& global) {
    switch (global.kind) {
        case GlobalKind::function:
            return constant_body(global.function, {}, global.function.span);
        case GlobalKind::component: {
            const Value whole = this->global_value(global.component_of, global.function.span);
            const Global& source = program_.globals[static_cast<std::size_t>(global.component_of)];
            return component_value(source.function.clauses.at(0), whole, global.component_slot, global.function.span);
        }
        case GlobalKind::datatype:
            break;  // global_value handles datatypes
        case GlobalKind::subtype:
            return domains_.subtype_set(global);
        case GlobalKind::nametype: {
            const FunctionClause& clause = global.function.clauses.at(0);
            Frame frame(static_cast<std::size_t>(clause.unit->size), nullptr);
            return domains_.type_set(share_value(eval(*clause.body, frame)), global.function.span);
        }
    }
    work_.fail("a definition of no kind", global.function.span);
}

// ---------------------------------------------------------------- patterns

bool Evaluator::match_pattern(const MatchCode& pattern, Value& value, Frame& frame) {
    if (pattern.kind == PatternKind::wildcard) return true;
    if (pattern.kind == PatternKind::name && !pattern.head) {
        frame[static_cast<std::size_t>(pattern.number)] = value;
        return true;
    }
    const Value found = evaluate_in_place(value);
    switch (pattern.kind) {
        case PatternKind::name: {
            const bool bare = found->kind == Kind::dot && found->items.size() == 1;
            return bare && found->items[0]->kind == Kind::head && found->items[0]->number == pattern.number;
        }
        case PatternKind::integer:
            return found->kind == Kind::integer && found->number == pattern.number;
        case PatternKind::character:
            return found->kind == Kind::character && found->number == pattern.number;
        case PatternKind::boolean:
            return found->kind == Kind::boolean && found->number == pattern.number;
        case PatternKind::tuple: {
            if (found->kind != Kind::tuple || found->items.size() != pattern.args.size()) return false;
            bool matches = true;
            for (std::size_t i = 0; matches && i < pattern.args.size(); ++i) {
                Value item = found->items[i];
                matches = match_pattern(pattern.args[i], item, frame);
            }
            return matches;
        }
        case PatternKind::sequence:
        case PatternKind::concat:
            return match_sequence(pattern, found, frame);
        case PatternKind::set: {
            if (!is_set(found)) return false;
            if (!domains_.has_size(found, pattern.args.size())) return false;
            const Values& items = domains_.elements(found, {});
            Value item = items.empty() ? nullptr : items[0];
            return items.empty() || match_pattern(pattern.args[0], item, frame);
        }
        case PatternKind::dot:
            return match_dot(pattern, found, frame);
        case PatternKind::both: {
            Value again = found;
            return match_pattern(pattern.args[0], again, frame) && match_pattern(pattern.args[1], again, frame);
        }
        case PatternKind::wildcard:
        case PatternKind::string:
            break;
    }
    return false;
}

namespace {

// Collects the parts of p ^ q ^ r. At most one part has no fixed length; it matches the rest of the sequence. All other
// parts are patterns <x, y, ...>.
void concat_parts(const MatchCode& pattern, std::vector<const MatchCode*>& parts) {
    if (pattern.kind != PatternKind::concat) return parts.push_back(&pattern);
    for (const MatchCode& arg : pattern.args) concat_parts(arg, parts);
}

}  // namespace

// Matches a pattern such as <x, y> ^ rest: removes elements from the front of the sequence. If no part matches the
// rest, the sequence must end there, so an infinite sequence does not match.
bool Evaluator::match_stream(const std::vector<const MatchCode*>& parts, Value value, Frame& frame) {
    for (const MatchCode* part : parts) {
        if (part->kind != PatternKind::sequence) return match_pattern(*part, value, frame);
        for (const MatchCode& element : part->args) {
            std::optional<ByNeed::Cut> cut = by_need_.split_first(value, {});
            if (!cut || !match_pattern(element, cut->head, frame)) return false;
            value = cut->tail;
        }
    }
    return !by_need_.split_first(value, {});
}

bool Evaluator::match_sequence(const MatchCode& pattern, Value value, Frame& frame) {
    if (value->kind != Kind::sequence && !is_stream(value)) return false;
    std::vector<const MatchCode*> parts;
    concat_parts(pattern, parts);
    std::size_t fixed = 0;
    std::size_t open = 0;
    for (const MatchCode* part : parts) {
        if (part->kind == PatternKind::sequence)
            fixed += part->args.size();
        else
            ++open;
    }
    if (open > 1) work_.fail("a sequence pattern has one part of open length at most", {});
    if (is_stream(value)) {
        if (open == 0 || parts.back()->kind != PatternKind::sequence) return match_stream(parts, value, frame);
        if (is_infinite(value)) work_.fail("an infinite sequence has no end to match", {});
        value = by_need_.written_out(value, {});
    }
    const std::size_t size = value->items.size();
    if (open == 0 ? size != fixed : size < fixed) return false;
    std::size_t at = 0;
    for (const MatchCode* part : parts) {
        if (part->kind == PatternKind::sequence) {
            for (const MatchCode& element : part->args) {
                Value item = value->items[at++];
                if (!match_pattern(element, item, frame)) return false;
            }
        } else {
            const auto first = value->items.begin() + static_cast<std::ptrdiff_t>(at);
            Value rest = store_.compound(Kind::sequence, 0, {first, first + static_cast<std::ptrdiff_t>(size - fixed)});
            at += size - fixed;
            if (!match_pattern(*part, rest, frame)) return false;
        }
    }
    return true;
}

namespace {

// Returns the number of fields that a part of a dot pattern matches. Does not apply to the last part, which matches all
// remaining fields.
std::size_t fields_taken(const MatchCode& pattern) {
    if (pattern.kind == PatternKind::both)
        return std::max(fields_taken(pattern.args[0]), fields_taken(pattern.args[1]));
    if (pattern.kind != PatternKind::dot) return 1;
    std::size_t count = 0;
    for (const MatchCode& argument : pattern.args) count += fields_taken(argument);
    return count;
}

void dot_parts(const MatchCode& pattern, std::vector<const MatchCode*>& parts) {
    if (pattern.kind != PatternKind::dot) return parts.push_back(&pattern);
    for (const MatchCode& arg : pattern.args) dot_parts(arg, parts);
}

}  // namespace

bool Evaluator::match_dot(const MatchCode& pattern, Value value, Frame& frame) {
    if (value->kind != Kind::dot) return false;
    std::vector<const MatchCode*> parts;
    dot_parts(pattern, parts);
    Values fields = value->items;
    const auto joined = [this](Values taken) {
        return taken.size() == 1 && taken[0]->kind != Kind::head ? taken[0] : store_.dot(std::move(taken));
    };
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
        const std::size_t count = fields_taken(*parts[i]);
        if (fields.size() < count) return false;
        const auto end = fields.begin() + static_cast<std::ptrdiff_t>(count);
        if (count > 1) {
            Value several = joined({fields.begin(), end});
            fields.erase(fields.begin(), end);
            if (!match_pattern(*parts[i], several, frame)) return false;
            continue;
        }
        Value first = fields.front();
        fields.erase(fields.begin());
        if (parts[i]->kind == PatternKind::name && parts[i]->head) {
            if (first->kind == Kind::dot && !first->items.empty()) {
                const Values inner = first->items;
                fields.insert(fields.begin(), inner.begin() + 1, inner.end());
                first = inner.front();
            }
            if (first->kind != Kind::head || first->number != parts[i]->number) return false;
        } else if (!match_pattern(*parts[i], first, frame)) {
            return false;
        }
    }
    if (fields.empty()) return false;
    Value rest = joined(std::move(fields));
    return match_pattern(*parts.back(), rest, frame);
}

}  // namespace robochart::cspm
