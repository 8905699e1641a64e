// Sets: explicit ones are sorted; Int, Proc, {n..}, Seq(S), Set(S) and Map(K,V) stay as they are until their
// elements are asked for.
#include <algorithm>

#include "checker/cspm/evaluator_internal.hpp"

namespace robochart::cspm {

bool Evaluator::is_set(Value value) {
    return value->kind == Kind::set || (value->kind >= Kind::integers && value->kind <= Kind::maps_over);
}

const Values& Evaluator::elements(Value set, Span span) {
    return explicit_set(set, span)->items;
}

Value Evaluator::explicit_set(Value set, Span span) {
    if (set->kind == Kind::set) return set;
    const auto known = explicit_.find(set);
    if (known != explicit_.end()) return known->second;
    Value result = nullptr;
    switch (set->kind) {
        case Kind::subsets_of:
            result = subsets(set->items[0], span);
            break;
        case Kind::datatype: {
            Global& global = program_.globals[static_cast<std::size_t>(set->number)];
            if (global.running)
                fail("the datatype '" + global.function.name + "' contains itself: it is infinite", span);
            const Running running(global.running);
            result = datatype_set(global);
            break;
        }
        case Kind::maps_over:
            result = maps(set->items[0], set->items[1], span);
            break;
        case Kind::sequences_over:
            if (!elements(set->items[0], span).empty()) fail("the set " + text(set) + " is infinite", span);
            result = store_.set({});
            break;
        case Kind::integers:
        case Kind::integers_from:
            fail("the set " + text(set) + " is infinite", span);
        case Kind::processes:
            fail("the elements of Proc cannot be listed", span);
        default:
            fail("expected a set, found " + text(set), span);
    }
    explicit_.emplace(set, result);
    return result;
}

Value Evaluator::subsets(Value set, Span span) {
    const Values& items = elements(set, span);
    if (items.size() > 22) fail("Set of a set with " + std::to_string(items.size()) + " elements is too large", span);
    Values result;
    for (std::size_t mask = 0; mask < (std::size_t{1} << items.size()); ++mask) {
        Values part;
        for (std::size_t i = 0; i < items.size(); ++i) {
            if ((mask >> i & 1U) != 0) part.push_back(items[i]);
        }
        result.push_back(store_.sorted_set(std::move(part)));
    }
    return store_.set(std::move(result));
}

// All maps from some of the keys to the values.
Value Evaluator::maps(Value keys, Value values, Span span) {
    std::vector<Values> partial{{}};
    for (const Value key : elements(keys, span)) {
        const std::size_t before = partial.size();
        for (const Value value : elements(values, span)) {
            for (std::size_t i = 0; i < before; ++i) {
                Values longer = partial[i];
                longer.push_back(key);
                longer.push_back(value);
                partial.push_back(std::move(longer));
            }
            if (partial.size() > max_elements) fail("more than 5000000 maps", span);
        }
    }
    Values result;
    for (Values& each : partial) result.push_back(store_.make(Kind::map, 0, std::move(each)));
    return store_.set(std::move(result));
}

bool Evaluator::member_of(Value value, Value set, Span span) {
    const auto all_in = [&](Value of) {
        return std::ranges::all_of(value->items, [&](Value item) { return member_of(item, of, span); });
    };
    switch (set->kind) {
        case Kind::integers:
            return value->kind == Kind::integer;
        case Kind::integers_from:
            return value->kind == Kind::integer && value->number >= set->number;
        case Kind::processes:
            return value->kind == Kind::process;
        case Kind::datatype: {  // constructors have checked their fields
            const bool named = value->kind == Kind::dot && !value->items.empty() && value->items[0]->kind == Kind::head;
            if (!named || !complete(value)) return false;
            return program_.heads[static_cast<std::size_t>(value->items[0]->number)].type == set->number;
        }
        case Kind::sequences_over:
            return value->kind == Kind::sequence && all_in(set->items[0]);
        case Kind::subsets_of:
            return value->kind == Kind::set && all_in(set->items[0]);
        case Kind::maps_over:
            for (std::size_t i = 0; i + 1 < value->items.size(); i += 2) {
                if (!member_of(value->items[i], set->items[0], span)) return false;
                if (!member_of(value->items[i + 1], set->items[1], span)) return false;
            }
            return value->kind == Kind::map;
        case Kind::set:
            return std::ranges::binary_search(set->items, value, [](Value a, Value b) { return compare(a, b) < 0; });
        default:
            fail("expected a set, found " + text(set), span);
    }
}

Value Evaluator::set_union(Value a, Value b, Span span) {
    if (a == b) return a;
    if (a->kind == Kind::processes || b->kind == Kind::processes) return a->kind == Kind::processes ? a : b;
    if (a->kind == Kind::integers || b->kind == Kind::integers) return a->kind == Kind::integers ? a : b;
    if (a->kind == Kind::integers_from && b->kind == Kind::integers_from) return a->number < b->number ? a : b;
    if (a->kind != Kind::set || b->kind != Kind::set) {
        if (subset(a, b, span)) return b;
        if (b->kind != Kind::set && subset(b, a, span)) return a;
    }
    Values result;
    std::ranges::set_union(elements(a, span), elements(b, span), std::back_inserter(result),
                           [](Value x, Value y) { return compare(x, y) < 0; });
    return store_.sorted_set(std::move(result));
}

Value Evaluator::set_inter(Value a, Value b, Span span) {
    if (a == b) return a;
    if (a->kind == Kind::integers_from && b->kind == Kind::integers_from) return a->number < b->number ? b : a;
    if (a->kind == Kind::integers && b->kind == Kind::integers_from) return b;
    if (b->kind == Kind::integers && a->kind == Kind::integers_from) return a;
    const bool first =
        a->kind == Kind::set || (b->kind != Kind::set && (a->kind == Kind::subsets_of || a->kind == Kind::datatype));
    Values result;
    for (const Value each : elements(first ? a : b, span)) {
        if (member_of(each, first ? b : a, span)) result.push_back(each);
    }
    return store_.sorted_set(std::move(result));
}

Value Evaluator::set_diff(Value a, Value b, Span span) {
    if (b->kind == Kind::integers && (a->kind == Kind::integers || a->kind == Kind::integers_from))
        return store_.set({});
    if (a->kind == Kind::integers_from && b->kind == Kind::integers_from) {
        Values items;
        for (std::int64_t i = a->number; i < b->number; ++i) {
            if (items.size() > max_elements) fail("more than 5000000 elements", span);
            items.push_back(store_.integer(i));
        }
        return store_.sorted_set(std::move(items));
    }
    Values result;
    for (const Value each : elements(a, span)) {
        if (!member_of(each, b, span)) result.push_back(each);
    }
    return store_.sorted_set(std::move(result));
}

bool Evaluator::subset(Value a, Value b, Span span) {
    if (a == b || b->kind == Kind::processes) return true;
    if (a->kind == Kind::integers_from && b->kind == Kind::integers) return true;
    if (a->kind == Kind::integers_from && b->kind == Kind::integers_from) return a->number >= b->number;
    if (a->kind == Kind::integers || a->kind == Kind::integers_from) return false;
    return std::ranges::all_of(elements(a, span), [&](Value each) { return member_of(each, b, span); });
}

// Equality of sets that are written differently: a set of all sequences never equals a finite one.
bool Evaluator::same(Value a, Value b, Span span) {
    if (a == b) return true;
    if (is_infinite(a) && is_infinite(b)) fail("two infinite sequences cannot be compared", span);
    if (!is_set(a) || !is_set(b) || a->kind == b->kind) return false;
    const auto finite = [](Value set) {
        return set->kind == Kind::set || set->kind == Kind::subsets_of || set->kind == Kind::maps_over ||
               set->kind == Kind::datatype;
    };
    if (!finite(a) || !finite(b)) return false;
    return explicit_set(a, span) == explicit_set(b, span);
}

// The orders of FDR: numbers and characters; prefix of sequences; subset; maps and tuples by parts.
bool Evaluator::less_equal(Value a, Value b, Span span) {
    if (is_set(a) && is_set(b)) return subset(a, b, span);
    if (is_infinite(a) || is_infinite(b)) fail("an infinite sequence has no place in the order", span);
    if (a->kind != b->kind) fail("cannot compare " + text(a) + " with " + text(b), span);
    switch (a->kind) {
        case Kind::integer:
        case Kind::character:
            return a->number <= b->number;
        case Kind::sequence:
            return a->items.size() <= b->items.size() && std::equal(a->items.begin(), a->items.end(), b->items.begin());
        case Kind::tuple:
            for (std::size_t i = 0; i < a->items.size() && i < b->items.size(); ++i) {
                if (!same(a->items[i], b->items[i], span)) return less_equal(a->items[i], b->items[i], span);
            }
            return true;
        case Kind::map:
            for (std::size_t i = 0; i + 1 < a->items.size(); i += 2) {
                const Values arguments{b, a->items[i]};
                if (map_builtin(Builtin::map_member, arguments, span)->number == 0) return false;
                const Value other = map_builtin(Builtin::map_lookup, arguments, span);
                if (!less_equal(a->items[i + 1], other, span)) return false;
            }
            return true;
        default:
            fail("values like " + text(a) + " have no order", span);
    }
}

}  // namespace robochart::cspm
