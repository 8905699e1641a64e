// SPDX-License-Identifier: Apache-2.0
// Evaluates prefixes. The place in the script and the values of the used variables identify the term of a prefix. The
// events of a prefix are computed on demand.
#include <algorithm>

#include "checker/cspm/eval/process_evaluator.hpp"

namespace robochart::cspm {

using process::Branch;
using process::Op;
using process::TermId;

TermId ProcessEvaluator::process_prefix(const Code& code, Frame& frame) {
    Values key{store_.integer(code.number)};
    for (const auto& [from, to] : code.unit->captures) {
        Value value = frame[static_cast<std::size_t>(from)];
        key.push_back(value == nullptr ? store_.tuple({}) : values_.share_value(value));
    }
    const auto chooses = [](const FieldCode& field) { return field.kind == FieldKind::nondeterministic; };
    const auto last = std::ranges::find_if_not(code.fields, chooses);
    if (std::any_of(last, code.fields.end(), chooses)) {
        work_.fail("a $ field stands before all ? and ! fields", code.span);
    }
    if (last == code.fields.begin()) return processes_.make_prefix(PrefixKind::script, std::move(key));
    // c$x -> P means |~| x @ c.x -> P
    Frame inside(static_cast<std::size_t>(code.unit->size), nullptr);
    for (std::size_t i = 0; i < code.unit->captures.size(); ++i) {
        inside[static_cast<std::size_t>(code.unit->captures[i].second)] = key[i + 1];
    }
    std::vector<TermId> choices;
    choose_fields(code, 0, values_.share_value(values_.eval(*code.args[0], inside)), inside, choices);
    if (choices.empty()) work_.fail("$ over an empty set", code.span);
    return processes_.make_operator(Op::internal_choice, std::move(choices));
}

// Chooses values for the $ fields before any other field. Each choice gives a separate prefix.
void ProcessEvaluator::choose_fields(const Code& code, std::size_t field, Value base, Frame& frame,
                                     std::vector<TermId>& out) {
    if (field < code.fields.size() && code.fields[field].kind == FieldKind::nondeterministic) {
        return input_field(code, field, base, frame,
                           [&](Value longer) { choose_fields(code, field + 1, longer, frame, out); });
    }
    Values key{store_.integer(code.number), store_.integer(static_cast<std::int64_t>(field)), base};
    for (const Value value : frame) key.push_back(value == nullptr ? store_.tuple({}) : values_.share_value(value));
    out.push_back(processes_.make_prefix(PrefixKind::chosen, std::move(key)));
}

// Evaluates an input field. ?p:S and $p:S range over S. Without S they range over the values that the type allows, one
// field for each part of the pattern.
void ProcessEvaluator::input_field(const Code& code, std::size_t field, Value base, Frame& frame, const Reach& reach) {
    const FieldCode& input = code.fields[field];
    if (input.value == nullptr) return input_parts(code, field, 0, base, frame, reach);
    const Value set = values_.share_value(values_.eval(*input.value, frame));
    for (Value value : domains_.elements(set, input.span)) {
        Value bound = value;
        if (values_.match_pattern(input.patterns[0], bound, frame))
            reach(domains_.append_fields(base, value, input.span));
    }
}

void ProcessEvaluator::input_parts(const Code& code, std::size_t field, std::size_t part, Value base, Frame& frame,
                                   const Reach& reach) {
    const FieldCode& input = code.fields[field];
    if (part == input.patterns.size()) return reach(base);
    const MatchCode& pattern = input.patterns[part];
    if (pattern.kind == PatternKind::name && pattern.head) {
        const Value longer =
            domains_.append_fields(base, domains_.head_value(static_cast<int>(pattern.number)), input.span);
        return input_parts(code, field, part + 1, longer, frame, reach);
    }
    const bool last = field + 1 == code.fields.size() && part + 1 == input.patterns.size();
    const Value set = last ? domains_.extensions(base) : domains_.one_field_extensions(base);
    for (const Value value : set->items) {
        Value bound = value;
        if (!values_.match_pattern(pattern, bound, frame)) continue;
        input_parts(code, field, part + 1, domains_.append_fields(base, value, input.span), frame, reach);
    }
}

void ProcessEvaluator::perform_fields(const Code& code, std::size_t field, Value base, Frame& frame,
                                      std::vector<Branch>& out) {
    if (field == code.fields.size()) {
        const process::Event happens = domains_.event_of(base, code.args[0]->span);
        TermId target = process(*code.args[1], frame);
        if (code.timed != nullptr) {
            target = processes_.make_wait(processes_.tock_event(*code.timed),
                                          event_duration(*code.timed, base, code.span), target);
        }
        out.push_back({happens, target});
        return;
    }
    const FieldCode& field_code = code.fields[field];
    if (field_code.kind == FieldKind::output || field_code.kind == FieldKind::dot) {
        const Value value = values_.share_value(values_.eval(*field_code.value, frame));
        return perform_fields(code, field + 1, domains_.append_fields(base, value, field_code.span), frame, out);
    }
    input_field(code, field, base, frame, [&](Value longer) { perform_fields(code, field + 1, longer, frame, out); });
}

std::vector<Branch> ProcessEvaluator::script_branches(Value key) {
    const Code& code = *program_.prefixes[static_cast<std::size_t>(key->items[0]->number)];
    work_.at_prefix(code.span);
    Frame frame(static_cast<std::size_t>(code.unit->size), nullptr);
    for (std::size_t i = 0; i < code.unit->captures.size(); ++i) {
        frame[static_cast<std::size_t>(code.unit->captures[i].second)] = key->items[i + 1];
    }
    std::vector<Branch> result;
    values_.for_each(code, code.clauses, 0, frame, [&](Frame& inside) {
        perform_fields(code, 0, values_.share_value(values_.eval(*code.args[0], inside)), inside, result);
    });
    return result;
}

std::vector<Branch> ProcessEvaluator::chosen_branches(Value key) {
    const Code& code = *program_.prefixes[static_cast<std::size_t>(key->items[0]->number)];
    work_.at_prefix(code.span);
    Frame frame(key->items.begin() + 3, key->items.end());
    std::vector<Branch> result;
    perform_fields(code, static_cast<std::size_t>(key->items[1]->number), key->items[2], frame, result);
    return result;
}

// Returns the branches of BUFFER(n, pairs) in its current state. The buffer accepts any input while it contains fewer
// than n elements. It offers the output of the oldest element unless it is empty (FDR manual, BUFFER).
std::vector<Branch> ProcessEvaluator::buffer_branches(Value key) {
    const Value bound = key->items[0];
    const Value pairs = key->items[1];
    const Values contents = key->items[2]->items;
    const auto holding = [&](Values items) {
        return processes_.make_prefix(PrefixKind::buffer, {bound, pairs, store_.sequence(std::move(items))});
    };
    std::vector<Branch> result;
    if (static_cast<std::int64_t>(contents.size()) < bound->number)
        for (const Value pair : pairs->items) {
            Values more = contents;
            more.push_back(pair->items[1]);
            result.push_back({domains_.event_of(pair->items[0], {}), holding(std::move(more))});
        }
    if (!contents.empty())
        result.push_back({domains_.event_of(contents.front(), {}), holding({contents.begin() + 1, contents.end()})});
    return result;
}

}  // namespace robochart::cspm
