// SPDX-License-Identifier: Apache-2.0
// Computes with sets. Explicit sets are sorted. Int, Proc, {n..}, Seq(S), Set(S) and Map(K,V) keep their form until
// their elements are needed. A union with a set that cannot be listed is stored as a list of parts. For sets of numbers
// this list is unique: {0..} united with {1} has only the part {0..}.
#include <algorithm>

#include "checker/cspm/eval/domains.hpp"

namespace robochart::cspm {

const Values& Domains::elements(Value set, Span span) {
    return explicit_set(set, span)->items;
}

Value Domains::explicit_set(Value set, Span span) {
    if (set->kind == Kind::set) return set;
    const auto known = explicit_.find(set);
    if (known != explicit_.end()) return known->second;
    Value result = nullptr;
    switch (set->kind) {
        case Kind::subsets_of:
            result = list_subsets(set->items[0], span);
            break;
        case Kind::datatype: {
            Global& global = program_.globals[static_cast<std::size_t>(set->number)];
            if (global.running)
                work_.fail("the datatype '" + global.function.name + "' contains itself: it is infinite", span);
            const Running running(global.running);
            result = datatype_set(global);
            break;
        }
        case Kind::maps_over:
            result = list_maps(set->items[0], set->items[1], span);
            break;
        case Kind::sequences_over:
            if (!elements(set->items[0], span).empty()) work_.fail("the set " + text_(set) + " is infinite", span);
            result = store_.set({});
            break;
        case Kind::united: {
            Values items;
            for (const Value part : set->items) {
                const Values& more = elements(part, span);
                items.insert(items.end(), more.begin(), more.end());
            }
            result = store_.set(std::move(items));
            break;
        }
        case Kind::integers:
        case Kind::integers_from:
            work_.fail("the set " + text_(set) + " is infinite", span);
        case Kind::processes:
            work_.fail("the elements of Proc cannot be listed", span);
        case Kind::integer:
        case Kind::boolean:
        case Kind::character:
        case Kind::tuple:
        case Kind::sequence:
        case Kind::set:
        case Kind::map:
        case Kind::head:
        case Kind::dot:
        case Kind::process:
        case Kind::function:
        case Kind::builtin:
        case Kind::sequence_from:
        case Kind::stream:
        case Kind::group:
        case Kind::thunk:
            work_.fail("expected a set, found " + text_(set), span);
    }
    explicit_.emplace(set, result);
    return result;
}

std::optional<std::uint64_t> Domains::size_of(Value set, Span span) {
    work_.count_step(span);
    const auto times = [](std::uint64_t a, std::uint64_t b) {
        std::uint64_t result = 0;
        const bool over = __builtin_mul_overflow(a, b, &result) || result > largest_size;
        return over ? largest_size : result;
    };
    const auto power = [&](std::uint64_t base, std::uint64_t exponent) {
        std::uint64_t result = 1;
        for (std::uint64_t i = 0; i < exponent && result > 0 && result < largest_size && base != 1; ++i)
            result = times(result, base);
        return result;
    };
    switch (set->kind) {
        case Kind::set:
            return set->items.size();
        case Kind::subsets_of: {
            const auto of = size_of(set->items[0], span);
            return of ? std::optional(power(2, *of)) : std::nullopt;
        }
        case Kind::maps_over: {
            const auto keys = size_of(set->items[0], span);
            const auto values = size_of(set->items[1], span);
            if (keys == 0) return 1;
            if (!keys) return values == 0 ? std::optional<std::uint64_t>(1) : std::nullopt;
            return values ? std::optional(power(*values + 1, *keys)) : std::nullopt;
        }
        case Kind::sequences_over:
            return size_of(set->items[0], span) == 0 ? std::optional<std::uint64_t>(0) : std::nullopt;
        case Kind::datatype: {
            Global& global = program_.globals[static_cast<std::size_t>(set->number)];
            if (global.running) return std::nullopt;  // the set is defined by itself
            const Running running(global.running);
            std::uint64_t sum = 0;
            for (const int head : global.heads) {
                // The constructor is not yet completely declared.
                if (program_.heads[static_cast<std::size_t>(head)].running) return std::nullopt;
                std::uint64_t product = 1;
                bool endless = false;
                for (const Value field : fields_of(head)) {
                    const auto size = size_of(field, span);
                    endless = endless || !size;
                    product = times(product, size.value_or(1));
                }
                if (endless && product > 0) return std::nullopt;
                sum = std::min(sum + product, largest_size);
            }
            return sum;
        }
        case Kind::united:
            for (const Value part : set->items)
                if (!size_of(part, span)) return std::nullopt;
            return elements(set, span).size();
        case Kind::integers:
        case Kind::integers_from:
        case Kind::processes:
            return std::nullopt;
        default:
            work_.fail("expected a set, found " + text_(set), span);
    }
}

bool Domains::has_size(Value set, std::size_t size) {
    const auto found = size_of(set, {});
    return found && *found == size;
}

bool Domains::can_be_listed(Value set, Span span) {
    if (set->kind == Kind::set) return true;
    if (set->kind == Kind::united) return false;
    const auto size = size_of(set, span);
    return size && *size <= max_elements;
}

// Returns a union of sets. At least one of these sets cannot be listed.
Value Domains::make_union(const Values& sets, Span span) {
    Values endless;
    Values listed;
    for (const Value set : sets) {
        for (const Value part : set->kind == Kind::united ? set->items : Values{set}) {
            if (can_be_listed(part, span)) {
                const Values& more = elements(part, span);
                listed.insert(listed.end(), more.begin(), more.end());
            } else {
                endless.push_back(part);
            }
        }
    }
    std::ranges::sort(endless, [](Value a, Value b) { return compare(a, b) < 0; });
    Values uncovered;
    for (std::size_t i = 0; i < endless.size(); ++i) {
        bool covered = false;
        for (std::size_t k = 0; k < endless.size() && !covered; ++k) {
            const bool earlier = k < i || endless[i] != endless[k];
            covered =
                k != i && earlier && endless[i]->kind == endless[k]->kind && is_subset(endless[i], endless[k], span);
        }
        if (!covered) uncovered.push_back(endless[i]);
    }
    Value rest = store_.set(std::move(listed));
    Values others;
    // In descending order, because each number may extend a set {n..} downwards by one.
    for (std::size_t at = rest->items.size(); at-- > 0;) {
        const Value item = rest->items[at];
        work_.count_step(span);
        bool inside = false;
        for (Value& part : uncovered) {
            if (part->kind == Kind::integers_from && item->kind == Kind::integer && item->number + 1 == part->number)
                part = store_.make(Kind::integers_from, item->number, {});
            inside = inside || member_of(item, part, span);
        }
        if (!inside) others.push_back(item);
    }
    if (uncovered.empty()) return store_.set(std::move(others));
    if (!others.empty()) uncovered.push_back(store_.set(std::move(others)));
    return uncovered.size() == 1 ? uncovered[0] : store_.make(Kind::united, 0, std::move(uncovered));
}

Value Domains::union_of_all(const Values& sets, Span span) {
    Values listed;
    Value result = nullptr;
    for (const Value set : sets) {
        work_.count_step(span);
        if (set->kind == Kind::set) {
            listed.insert(listed.end(), set->items.begin(), set->items.end());
            if (listed.size() > 2 * max_elements) work_.fail("more than 5000000 elements", span);
        } else {
            result = result == nullptr ? set : set_union(result, set, span);
        }
    }
    const Value rest = store_.set(std::move(listed));
    return result == nullptr ? rest : set_union(result, rest, span);
}

// Returns the numbers from `from` on that are not in `taken`: a union of the numbers between them and {n..} after them.
Value Domains::without_listed(std::int64_t from, const Values& taken, Span span) {
    std::int64_t next = from;
    Values between;
    for (const Value element : taken) {
        if (element->kind != Kind::integer || element->number < next) continue;
        if (static_cast<std::uint64_t>(element->number) - static_cast<std::uint64_t>(next) >
            max_elements - between.size())
            work_.fail("more than 5000000 elements", span);
        for (; next < element->number; ++next) between.push_back(store_.integer(next));
        if (__builtin_add_overflow(element->number, std::int64_t{1}, &next))
            work_.fail("the number does not fit in 64 bits", span);
    }
    return set_union(store_.make(Kind::integers_from, next, {}), store_.sorted_set(std::move(between)), span);
}

Value Domains::list_subsets(Value set, Span span) {
    const Values& items = elements(set, span);
    if (items.size() > 22)
        work_.fail("Set of a set with " + std::to_string(items.size()) + " elements is too large", span);
    Values result;
    for (std::size_t mask = 0; mask < (std::size_t{1} << items.size()); ++mask) {
        work_.count_step(span);
        Values part;
        for (std::size_t i = 0; i < items.size(); ++i) {
            if ((mask >> i & 1U) != 0) part.push_back(items[i]);
        }
        result.push_back(store_.sorted_set(std::move(part)));
    }
    return store_.set(std::move(result));
}

// Returns all maps from subsets of the keys to the values.
Value Domains::list_maps(Value keys, Value values, Span span) {
    std::vector<Values> partial{{}};
    for (const Value key : elements(keys, span)) {
        const std::size_t before = partial.size();
        for (const Value value : elements(values, span)) {
            for (std::size_t i = 0; i < before; ++i) {
                work_.count_step(span);
                Values longer = partial[i];
                longer.push_back(key);
                longer.push_back(value);
                partial.push_back(std::move(longer));
            }
            if (partial.size() > max_elements) work_.fail("more than 5000000 maps", span);
        }
    }
    Values result;
    for (Values& entries : partial) result.push_back(store_.make(Kind::map, 0, std::move(entries)));
    return store_.set(std::move(result));
}

bool Domains::member_of(Value value, Value set, Span span) {
    value = store_.form_as_part(value);
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
        case Kind::datatype: {  // the fields were checked when the value was constructed
            const bool named = value->kind == Kind::dot && !value->items.empty() && value->items[0]->kind == Kind::head;
            if (!named || !is_complete(value)) return false;
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
        case Kind::united:
            return std::ranges::any_of(set->items, [&](Value part) { return member_of(value, part, span); });
        case Kind::set:
            return std::ranges::binary_search(set->items, value, [](Value a, Value b) { return compare(a, b) < 0; });
        case Kind::integer:
        case Kind::boolean:
        case Kind::character:
        case Kind::tuple:
        case Kind::sequence:
        case Kind::map:
        case Kind::head:
        case Kind::dot:
        case Kind::process:
        case Kind::function:
        case Kind::builtin:
        case Kind::sequence_from:
        case Kind::stream:
        case Kind::group:
        case Kind::thunk:
            break;
    }
    work_.fail("expected a set, found " + text_(set), span);
}

Value Domains::set_union(Value a, Value b, Span span) {
    if (a == b) return a;
    if (!is_set(a) || !is_set(b)) work_.fail("expected a set, found " + text_(is_set(a) ? b : a), span);
    if (a->kind == Kind::processes || b->kind == Kind::processes) return a->kind == Kind::processes ? a : b;
    if (a->kind == Kind::integers || b->kind == Kind::integers) return a->kind == Kind::integers ? a : b;
    if (!can_be_listed(a, span) || !can_be_listed(b, span)) return make_union({a, b}, span);
    Values result;
    std::ranges::set_union(elements(a, span), elements(b, span), std::back_inserter(result),
                           [](Value x, Value y) { return compare(x, y) < 0; });
    return store_.sorted_set(std::move(result));
}

Value Domains::set_inter(Value a, Value b, Span span) {
    if (a == b) return a;
    if (a->kind == Kind::united || b->kind == Kind::united) {
        const Value parts = a->kind == Kind::united ? a : b;
        Values result;
        for (const Value part : parts->items) result.push_back(set_inter(part, parts == a ? b : a, span));
        return union_of_all(result, span);
    }
    if (a->kind == Kind::integers_from && b->kind == Kind::integers_from) return a->number < b->number ? b : a;
    if (a->kind == Kind::integers && b->kind == Kind::integers_from) return b;
    if (b->kind == Kind::integers && a->kind == Kind::integers_from) return a;
    const bool alike = a->kind == b->kind && (a->kind == Kind::sequences_over || a->kind == Kind::subsets_of);
    if (alike && !(can_be_listed(a, span) && can_be_listed(b, span)))
        return store_.make(a->kind, 0, {set_inter(a->items[0], b->items[0], span)});
    const bool first = a->kind == Kind::set || (b->kind != Kind::set && can_be_listed(a, span));
    Values result;
    for (const Value element : elements(first ? a : b, span)) {
        work_.count_step(span);
        if (member_of(element, first ? b : a, span)) result.push_back(element);
    }
    return store_.sorted_set(std::move(result));
}

Value Domains::set_diff(Value a, Value b, Span span) {
    if (b->kind == Kind::united) {
        for (const Value part : b->items) a = set_diff(a, part, span);
        return a;
    }
    if (a->kind == Kind::united) {
        Values result;
        for (const Value part : a->items) result.push_back(set_diff(part, b, span));
        return union_of_all(result, span);
    }
    if (b->kind == Kind::set && b->items.empty()) return a;
    if (!can_be_listed(a, span)) {
        if (is_subset(a, b, span)) return store_.set({});
        if (a->kind == Kind::integers_from && b->kind == Kind::set) return without_listed(a->number, b->items, span);
        if (a->kind != Kind::integers_from || b->kind != Kind::integers_from) {
            work_.fail("the elements of diff(" + text_(a) + ", " + text_(b) + ") cannot be listed", span);
        }
        Values items;
        for (std::int64_t i = a->number; i < b->number; ++i) {
            work_.count_step(span);
            if (items.size() > max_elements) work_.fail("more than 5000000 elements", span);
            items.push_back(store_.integer(i));
        }
        return store_.sorted_set(std::move(items));
    }
    Values result;
    for (const Value element : elements(a, span)) {
        work_.count_step(span);
        if (!member_of(element, b, span)) result.push_back(element);
    }
    return store_.sorted_set(std::move(result));
}

bool Domains::is_subset(Value a, Value b, Span span) {
    if (a == b || b->kind == Kind::processes) return true;
    if (a->kind == Kind::united)
        return std::ranges::all_of(a->items, [&](Value part) { return is_subset(part, b, span); });
    if (a->kind == Kind::integers_from && b->kind == Kind::integers) return true;
    if (a->kind == Kind::integers_from && b->kind == Kind::integers_from) return a->number >= b->number;
    if (b->kind == Kind::united && !can_be_listed(a, span)) {
        for (const Value part : b->items) {
            if (part->kind == a->kind && is_subset(a, part, span)) return true;
            if (a->kind != Kind::integers_from || part->kind != Kind::integers_from) continue;
            if (part->number - a->number > static_cast<std::int64_t>(max_elements)) return false;
            bool all = true;
            for (std::int64_t i = a->number; all && i < part->number; ++i) {
                work_.count_step(span);
                all = member_of(store_.integer(i), b, span);
            }
            if (all) return true;
        }
        return false;
    }
    const bool alike = a->kind == b->kind && (a->kind == Kind::sequences_over || a->kind == Kind::subsets_of);
    if (alike) return is_subset(a->items[0], b->items[0], span);
    if (a->kind == Kind::maps_over && b->kind == Kind::maps_over)
        return is_subset(a->items[0], b->items[0], span) && is_subset(a->items[1], b->items[1], span);
    const auto size = size_of(a, span);
    const auto space = size_of(b, span);
    if (space && (!size || *size > *space)) return false;
    if (!size && (a->kind == Kind::integers || a->kind == Kind::integers_from)) return false;
    return std::ranges::all_of(elements(a, span), [&](Value element) {
        work_.count_step(span);
        return member_of(element, b, span);
    });
}

// Compares sets with different representations. If both sets have the same form and cannot be listed, compares their
// components. A set of sequences is infinite, so it never equals a finite set.
bool Domains::are_equal_sets(Value a, Value b, Span span) {
    if (a == b) return true;
    if (!is_set(a) || !is_set(b)) return false;
    const auto size = size_of(a, span);
    if (size != size_of(b, span)) return false;
    if (can_be_listed(a, span) && can_be_listed(b, span)) return explicit_set(a, span) == explicit_set(b, span);
    if (a->kind == b->kind) {
        const bool composed =
            a->kind == Kind::subsets_of || a->kind == Kind::sequences_over || a->kind == Kind::maps_over;
        for (std::size_t i = 0; composed && i < a->items.size(); ++i)
            if (!are_equal_sets(a->items[i], b->items[i], span)) return false;
        return composed;
    }
    return size && explicit_set(a, span) == explicit_set(b, span);
}

}  // namespace robochart::cspm
