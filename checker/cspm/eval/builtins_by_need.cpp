// SPDX-License-Identifier: Apache-2.0
// Implements the built-ins on sequences and maps (FDR manual, chapter CSPM, Built-In Definitions). They evaluate their
// arguments only as far as they need them.
#include <algorithm>

#include "checker/cspm/eval/by_need.hpp"
#include "checker/cspm/eval/evaluator.hpp"
#include "checker/cspm/types/builtins.hpp"

namespace robochart::cspm {

Values ByNeed::sequence(Value value, Span span) {
    return values_.share_value(written_out(value, span))->items;
}

const Values& ByNeed::map_items(Value value, Span span) {
    if (value->kind != Kind::map) work_.fail("expected a map, found " + text_(value), span);
    return value->items;
}

Value ByNeed::call(Value builtin, Values arguments, Span span) {
    const auto which = static_cast<Builtin>(builtin->number);
    if (!takes_by_need(which)) {
        if ((which == Builtin::inter || which == Builtin::diff) && arguments.size() == 2) {
            const Value first = values_.share_value(values_.evaluated_value(arguments[0]));
            if (first->kind == Kind::set && first->items.empty()) return first;  // the result is {} for any second set
            arguments[0] = first;
        }
        for (Value& argument : arguments) argument = values_.share_value(values_.evaluate_in_place(argument));
        return builtins_.call(builtin, std::move(arguments), span);
    }
    builtins_.check_arity(which, arguments.size(), span);
    return which <= Builtin::elem ? sequence_builtin(which, arguments, span) : map_builtin(which, arguments, span);
}

Value ByNeed::sequence_builtin(Builtin which, const Values& arguments, Span span) {
    if (which == Builtin::elem)
        return store_.boolean(contains_element(arguments[0], values_.evaluated_value(arguments[1]), span));
    const Value first = values_.evaluated_value(arguments[0]);
    switch (which) {
        case Builtin::length:
            return store_.integer(static_cast<std::int64_t>(written_out(first, span)->items.size()));
        case Builtin::null:
            return store_.boolean(first->kind == Kind::sequence ? first->items.empty() : !split_first(first, span));
        case Builtin::head: {
            if (first->kind == Kind::sequence && !first->items.empty()) return values_.evaluated_value(first->items[0]);
            const std::optional<Cut> cut = split_first(first, span);
            if (!cut) work_.fail("head of an empty sequence", span);
            return values_.evaluated_value(cut->head);
        }
        case Builtin::tail: {
            const std::optional<Cut> cut = split_first(first, span);
            if (!cut) work_.fail("tail of an empty sequence", span);
            return values_.evaluated_value(cut->tail);
        }
        default: {  // concat
            const Value parts = written_out(first, span);
            Values items;
            for (std::size_t i = 0; i < parts->items.size(); ++i) {
                Value part = parts->items[i];
                if (part->kind == Kind::thunk && static_cast<const Thunk&>(*part).result != nullptr)
                    part = values_.evaluate_in_place(part);
                if (part->kind != Kind::sequence) {
                    // The rest of the sequence may be unevaluated or infinite.
                    Value rest = store_.sequence({});
                    for (std::size_t k = parts->items.size(); k-- > i + 1;) rest = part_before(parts->items[k], rest);
                    return append(store_.compound(Kind::sequence, 0, std::move(items)), part_before(part, rest));
                }
                work_.count_step(span);
                items.insert(items.end(), part->items.begin(), part->items.end());
                if (items.size() > max_elements) work_.fail("the sequence is too long", span);
            }
            return store_.compound(Kind::sequence, 0, std::move(items));
        }
    }
}

// Returns part ^ rest, where `part` may be unevaluated.
Value ByNeed::part_before(Value part, Value rest) {
    if (part->kind == Kind::sequence && rest->kind == Kind::sequence) return append(part, rest);
    if (rest->kind == Kind::sequence && rest->items.empty()) return part;
    return store_.compound(Kind::stream, -1, {part, rest});
}

namespace {

// Returns the position of a key in k1, v1, k2, v2..., or the position at which it would be inserted.
std::size_t key_place(const Values& items, Value key) {
    std::size_t at = 0;
    while (at < items.size() && compare(items[at], key) < 0) at += 2;
    return at;
}

void put_entry(Values& items, Value key, Value value) {
    const std::size_t at = key_place(items, key);
    if (at < items.size() && items[at] == key)
        items[at + 1] = value;
    else
        items.insert(items.begin() + static_cast<std::ptrdiff_t>(at), {key, value});
}

}  // namespace

// Calls a built-in for maps. The keys are evaluated; the values may be unevaluated.
Value ByNeed::map_builtin(Builtin which, const Values& arguments, Span span) {
    const auto put_all = [&](Values items, const Values& pairs) {
        for (const Value entry : pairs) {
            work_.count_step(span);
            const Value pair = values_.evaluated_value(entry);
            if (pair->kind != Kind::tuple || pair->items.size() != 2)
                work_.fail("expected pairs, found " + text_(pair), span);
            put_entry(items, store_.form_as_part(values_.share_value(pair->items[0])), pair->items[1]);
        }
        return store_.compound(Kind::map, 0, std::move(items));
    };
    if (which == Builtin::map_from_list) return put_all({}, written_out(arguments[0], span)->items);
    Values items = map_items(values_.evaluated_value(arguments[0]), span);
    if (which == Builtin::map_update_multiple) {
        // If several pairs have the same key, the first pair is used. (In contrast, mapFromList uses the last one;
        // libcspm, Evaluator.)
        Values pairs = written_out(arguments[1], span)->items;
        std::ranges::reverse(pairs);
        return put_all(std::move(items), pairs);
    }
    if (which == Builtin::map_to_list) {
        Values pairs;
        for (std::size_t i = 0; i + 1 < items.size(); i += 2)
            pairs.push_back(store_.compound(Kind::tuple, 0, {items[i], items[i + 1]}));
        return store_.compound(Kind::sequence, 0, std::move(pairs));
    }
    const Value key = store_.form_as_part(values_.share_value(arguments[1]));
    const std::size_t at = key_place(items, key);
    const bool found = at < items.size() && items[at] == key;
    switch (which) {
        case Builtin::map_lookup:
            if (!found) work_.fail("the key " + text_(key) + " is not in the map", span);
            return values_.evaluated_value(items[at + 1]);
        case Builtin::map_member:
            return store_.boolean(found);
        case Builtin::map_update:
            put_entry(items, key, arguments[2]);
            break;
        default:
            if (found) {
                items.erase(items.begin() + static_cast<std::ptrdiff_t>(at),
                            items.begin() + static_cast<std::ptrdiff_t>(at) + 2);
            }
            break;
    }
    return store_.compound(Kind::map, 0, std::move(items));
}

}  // namespace robochart::cspm
