// SPDX-License-Identifier: Apache-2.0
// Evaluates sequences whose elements are not all stored: <n..>, comprehensions with unevaluated or infinitely many
// elements, and concatenations. Each element is computed when it is needed (FDR evaluates sequences lazily).
//
// A stream has two items: a sequence of known elements, and a sequence for the elements after them. Without a
// comprehension, the stream continues with the second sequence itself. With a comprehension, the second sequence is the
// source of a generator, and the values of the surrounding variables are further items. `number` shows which of the two
// cases applies.
#include <algorithm>

#include "checker/cspm/eval/by_need.hpp"
#include "checker/cspm/eval/evaluator.hpp"

namespace robochart::cspm {
namespace {

/// Limits how many elements are skipped in the search for one that satisfies the conditions.
constexpr std::size_t most_skipped = 200'000;
constexpr std::int64_t joined = -1;

}  // namespace

Value ByNeed::append(Value first, Value rest) {
    if (first->kind == Kind::sequence && first->items.empty()) return values_.evaluate_in_place(rest);
    if (rest->kind == Kind::thunk && static_cast<const Thunk&>(*rest).result != nullptr)
        rest = static_cast<const Thunk&>(*rest).result;
    if (first->kind == Kind::sequence && rest->kind == Kind::sequence) {
        Values items = first->items;
        if (items.size() + rest->items.size() > max_elements) work_.fail("the sequence is too long", {});
        items.insert(items.end(), rest->items.begin(), rest->items.end());
        return store_.compound(Kind::sequence, 0, std::move(items));
    }
    return store_.compound(Kind::stream, joined, {first, rest});
}

Value ByNeed::make_stream(Value first, Value source, Comprehension of, const Values& frame) {
    Values items{first, source};
    for (const Value value : frame) items.push_back(value == nullptr ? store_.tuple({}) : value);
    const auto same = [&](const Comprehension& other) { return other.code == of.code && other.clause == of.clause; };
    const auto known = std::ranges::find_if(streams_, same);
    const auto number = known - streams_.begin();
    if (known == streams_.end()) streams_.push_back(of);
    return store_.compound(Kind::stream, number, std::move(items));
}

std::optional<ByNeed::Cut> ByNeed::split_first(Value sequence, Span span) {
    for (std::size_t tried = 0;; ++tried) {
        work_.count_step(span);
        sequence = values_.evaluate_in_place(sequence);
        if (sequence->kind == Kind::sequence) {
            if (sequence->items.empty()) return std::nullopt;
            Values rest(sequence->items.begin() + 1, sequence->items.end());
            return Cut{sequence->items.front(), store_.compound(Kind::sequence, 0, std::move(rest))};
        }
        if (sequence->kind == Kind::sequence_from) {
            std::int64_t following = 0;
            if (__builtin_add_overflow(sequence->number, std::int64_t{1}, &following))
                work_.fail("the number does not fit in 64 bits", span);
            return Cut{store_.integer(sequence->number), store_.make(Kind::sequence_from, following, {})};
        }
        if (sequence->kind != Kind::stream) work_.fail("expected a sequence, found " + text_(sequence), span);
        const Values& items = sequence->items;
        if (const std::optional<Cut> first = split_first(items[0], span)) {
            const bool last = first->tail->kind == Kind::sequence && first->tail->items.empty();
            if (sequence->number == joined) return Cut{first->head, last ? items[1] : append(first->tail, items[1])};
            Values rest = items;
            rest[0] = first->tail;
            return Cut{first->head, store_.compound(Kind::stream, sequence->number, std::move(rest))};
        }
        if (sequence->number == joined) {
            sequence = items[1];
            continue;
        }
        if (tried >= most_skipped) work_.fail("none of 200000 elements makes another one of the sequence", span);
        const Comprehension of = streams_.at(static_cast<std::size_t>(sequence->number));
        const std::optional<Cut> drawn = split_first(items[1], span);
        if (!drawn) return std::nullopt;
        Values frame(items.begin() + 2, items.end());
        Values rest = items;
        rest[1] = drawn->tail;
        Value item = drawn->head;
        if (values_.match_pattern(of.code->clauses[of.clause].pattern, item, frame))
            rest[0] = values_.comprehension_from(*of.code, of.clause + 1, frame);
        sequence = store_.compound(Kind::stream, sequence->number, std::move(rest));
    }
}

Value ByNeed::written_out(Value sequence, Span span) {
    sequence = values_.evaluate_in_place(sequence);
    if (sequence->kind == Kind::sequence) return sequence;
    if (!is_stream(sequence)) work_.fail("expected a sequence, found " + text_(sequence), span);
    Values items;
    for (;;) {
        sequence = values_.evaluate_in_place(sequence);
        if (is_infinite(sequence)) work_.fail("the sequence " + text_(sequence) + " is infinite", span);
        if (sequence->kind == Kind::sequence) {
            items.insert(items.end(), sequence->items.begin(), sequence->items.end());
            break;
        }
        const Value first = sequence->kind == Kind::stream ? sequence->items[0] : nullptr;
        if (first != nullptr && sequence->number == joined && first->kind == Kind::sequence) {
            items.insert(items.end(), first->items.begin(), first->items.end());
            sequence = sequence->items[1];
        } else {
            const std::optional<Cut> cut = split_first(sequence, span);
            if (!cut) break;
            items.push_back(cut->head);
            sequence = cut->tail;
        }
        work_.count_step(span);
        if (items.size() > max_elements) work_.fail("the sequence is too long", span);
    }
    return store_.compound(Kind::sequence, 0, std::move(items));
}

/// Returns the sequence itself if it is finite. Otherwise returns a stream in which only elements may be unevaluated.
Value ByNeed::share_stream(Value value) {
    if (!is_infinite(value)) {
        Values items = value->items;
        items[1] = values_.evaluated_value(items[1]);
        value = store_.compound(Kind::stream, value->number, std::move(items));
    }
    if (!is_infinite(value)) return values_.share_value(written_out(value, {}));
    Values items;
    for (const Value item : value->items) items.push_back(values_.share_value(item));
    return store_.make(Kind::stream, value->number, std::move(items));
}

/// Returns true if the sequence contains the element. Evaluates `element` only for the first comparison, so never if
/// the sequence is empty.
bool ByNeed::contains_element(Value element, Value sequence, Span span) {
    for (std::size_t tried = 0; tried < most_skipped || !is_infinite(sequence); ++tried) {
        const std::optional<Cut> cut = split_first(sequence, span);
        if (!cut) return false;
        if (are_equal(values_.evaluated_value(cut->head), values_.evaluate_in_place(element), span)) return true;
        sequence = values_.evaluated_value(cut->tail);
    }
    work_.fail("not among the first 200000 elements of an infinite sequence", span);
}

/// Compares tuples, sequences and maps part by part, up to the first difference.
bool ByNeed::are_equal(Value a, Value b, Span span) {
    if (a == b) return true;
    work_.count_step(span);
    const bool sequences = (a->kind == Kind::sequence || is_stream(a)) && (b->kind == Kind::sequence || is_stream(b));
    if (a->shared && b->shared && !(sequences && (is_stream(a) || is_stream(b))))
        return domains_.are_equal_sets(a, b, span);
    if (a->kind == Kind::tuple && b->kind == Kind::tuple) {
        for (std::size_t i = 0; i < a->items.size() && i < b->items.size(); ++i)
            if (!are_equal(values_.evaluated_value(a->items[i]), values_.evaluated_value(b->items[i]), span))
                return false;
        return a->items.size() == b->items.size();
    }
    if (a->kind == Kind::map && b->kind == Kind::map) {
        if (a->items.size() != b->items.size()) return false;
        for (std::size_t i = 0; i < a->items.size(); ++i)
            if (!are_equal(values_.evaluated_value(a->items[i]), values_.evaluated_value(b->items[i]), span))
                return false;
        return true;
    }
    if (!sequences) return domains_.are_equal_sets(values_.share_value(a), values_.share_value(b), span);
    if (a->kind == Kind::sequence && b->kind == Kind::sequence)
        return is_prefix(a, b, span) && a->items.size() == b->items.size();
    for (std::size_t compared = 0; compared < most_skipped || !is_infinite(a) || !is_infinite(b); ++compared) {
        const std::optional<Cut> left = split_first(a, span);
        const std::optional<Cut> right = split_first(b, span);
        if (!left || !right) return !left && !right;
        if (!are_equal(values_.evaluated_value(left->head), values_.evaluated_value(right->head), span)) return false;
        a = values_.evaluated_value(left->tail);
        b = values_.evaluated_value(right->tail);
    }
    work_.fail("two infinite sequences agree in their first 200000 elements", span);
}

/// Returns true if `a` is a prefix of `b`. Reads both only up to the first difference.
bool ByNeed::is_prefix(Value a, Value b, Span span) {
    if (a->kind == Kind::sequence && b->kind == Kind::sequence) {
        for (std::size_t i = 0; i < a->items.size(); ++i)
            if (i == b->items.size() ||
                !are_equal(values_.evaluated_value(a->items[i]), values_.evaluated_value(b->items[i]), span))
                return false;
        return true;
    }
    for (std::size_t compared = 0; compared < most_skipped || !is_infinite(a) || !is_infinite(b); ++compared) {
        const std::optional<Cut> left = split_first(a, span);
        if (!left) return true;
        const std::optional<Cut> right = split_first(b, span);
        if (!right || !are_equal(values_.evaluated_value(left->head), values_.evaluated_value(right->head), span))
            return false;
        a = values_.evaluated_value(left->tail);
        b = values_.evaluated_value(right->tail);
    }
    work_.fail("two infinite sequences agree in their first 200000 elements", span);
}

// Compares by the orders of FDR: numbers and characters by value, sequences by prefix, sets by inclusion, maps and
// tuples by their parts. Parts after the first difference are not evaluated.
bool ByNeed::is_less_or_equal(Value a, Value b, Span span) {
    if (is_set(a) && is_set(b)) return domains_.is_subset(values_.share_value(a), values_.share_value(b), span);
    const auto is_sequence = [](Value value) { return value->kind == Kind::sequence || is_stream(value); };
    if (is_sequence(a) && is_sequence(b)) return is_prefix(a, b, span);
    if (a->kind != b->kind) work_.fail("cannot compare " + text_(a) + " with " + text_(b), span);
    switch (a->kind) {
        case Kind::integer:
        case Kind::character:
            return a->number <= b->number;
        case Kind::tuple:
            for (std::size_t i = 0; i < a->items.size() && i < b->items.size(); ++i) {
                const Value left = values_.evaluated_value(a->items[i]);
                const Value right = values_.evaluated_value(b->items[i]);
                if (!are_equal(left, right, span)) return is_less_or_equal(left, right, span);
            }
            return true;
        case Kind::map:
            for (std::size_t i = 0; i + 1 < a->items.size(); i += 2) {
                const Values arguments{b, a->items[i]};
                if (map_builtin(Builtin::map_member, arguments, span)->number == 0) return false;
                const Value other = map_builtin(Builtin::map_lookup, arguments, span);
                if (!is_less_or_equal(values_.evaluated_value(a->items[i + 1]), other, span)) return false;
            }
            return true;
        case Kind::boolean:
        case Kind::sequence:
        case Kind::set:
        case Kind::head:
        case Kind::dot:
        case Kind::process:
        case Kind::function:
        case Kind::builtin:
        case Kind::integers:
        case Kind::integers_from:
        case Kind::processes:
        case Kind::datatype:
        case Kind::sequences_over:
        case Kind::subsets_of:
        case Kind::maps_over:
        case Kind::united:
        case Kind::sequence_from:
        case Kind::stream:
        case Kind::group:
        case Kind::thunk:
            break;
    }
    work_.fail("values like " + text_(a) + " have no order", span);
}

bool ByNeed::is_less(Value a, Value b, Span span) {
    return is_less_or_equal(a, b, span) && !are_equal(a, b, span);
}

}  // namespace robochart::cspm
