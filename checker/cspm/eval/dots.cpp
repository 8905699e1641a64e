// SPDX-License-Identifier: Apache-2.0
// Computes with dotted values: channels and constructors with their fields, their extensions, and events. If a dot
// begins with a head (a channel or constructor), its other items are the fields of the head. Only the last field may be
// incomplete. Any other dot is a plain list of values. (FDR manual: dots, extensions, productions.)
#include <algorithm>

#include "checker/cspm/eval/domains.hpp"

namespace robochart::cspm {

namespace {

bool is_named(Value value) {
    return value->kind == Kind::dot && !value->items.empty() && value->items[0]->kind == Kind::head;
}

int head_of(Value value) {
    return static_cast<int>(value->items[0]->number);
}

}  // namespace

Value Domains::head_value(int head) {
    const auto at = static_cast<std::size_t>(head);
    if (at >= head_values_.size()) head_values_.resize(program_.heads.size(), nullptr);
    Value& known = head_values_[at];
    if (known == nullptr) known = store_.dot({store_.make(Kind::head, head, {})});
    return known;
}

// Returns the sets of a head's fields, which are evaluated on first use.
const Values& Domains::fields_of(int index) {
    Head& head = program_.heads[static_cast<std::size_t>(index)];
    if (head.evaluated) return head.fields;
    if (head.running) work_.fail("the type of '" + head.name + "' contains itself", head.span);
    if (head.fields_code != nullptr) {
        const Running running(head.running);
        head.fields = type_fields(evaluate_(*head.fields_code, *head.unit), head.span);
    }
    head.evaluated = true;
    return head.fields;
}

// Converts a type expression to one set for each field: two sets for A.B, but one set of pairs for (A,B).
Values Domains::type_fields(Value type, Span span) {
    if (type->kind == Kind::dot && !is_named(type)) {
        Values result;
        for (const Value item : type->items) {
            const Values more = type_fields(item, span);
            result.insert(result.end(), more.begin(), more.end());
        }
        return result;
    }
    if (type->kind == Kind::tuple) {
        Values parts;
        for (const Value item : type->items) parts.push_back(type_set(item, span));
        return {product_of(parts, Kind::tuple, span)};
    }
    if (!is_set(type)) work_.fail("expected a set as a type, found " + text_(type), span);
    return rectangle(type, span);
}

Value Domains::type_set(Value type, Span span) {
    if (is_set(type)) return type;
    const Values fields = type_fields(type, span);
    return fields.size() == 1 ? fields[0] : product_of(fields, Kind::dot, span);
}

// Splits a set of plain dots into one set for each field. The set must contain all combinations of the fields' values.
Values Domains::rectangle(Value set, Span span) {
    const auto plain = [](Value value) {
        return value->kind == Kind::dot && !is_named(value) && value->items.size() > 1;
    };
    if (set->kind != Kind::set || set->items.empty() || !plain(set->items[0])) return {set};
    const std::size_t width = set->items[0]->items.size();
    std::vector<Values> columns(width);
    for (const Value element : set->items) {
        if (!plain(element) || element->items.size() != width)
            work_.fail("the set " + text_(set) + " has fields of different shapes", span);
        for (std::size_t i = 0; i < width; ++i) columns[i].push_back(element->items[i]);
    }
    Values result;
    std::size_t size = 1;
    for (Values& column : columns) {
        result.push_back(store_.set(std::move(column)));
        size *= result.back()->items.size();
    }
    if (size != set->items.size()) work_.fail("the set " + text_(set) + " is not all combinations of its fields", span);
    return result;
}

bool Domains::is_complete(Value value) {
    if (!is_named(value)) return true;
    const std::size_t arity = fields_of(head_of(value)).size();
    return value->items.size() - 1 == arity && is_complete(value->items.back());
}

// Returns base.more: appends the fields of `more` to `base`, which lacks them.
Value Domains::append_fields(Value base, Value more, Span span) {
    if (more->kind != Kind::dot || is_named(more)) return add_field(base, more, span);
    for (const Value item : more->items) base = append_fields(base, item, span);
    return base;
}

void Domains::check_field(Value field, Value allowed, Value whole, Span span) {
    if (!is_complete(field)) return;
    if (!member_of(field, allowed, span)) {
        work_.fail(text_(field) + " is not a value of its field in " + text_(whole) + " (the field's type is " +
                       text_(allowed) + ")",
                   span);
    }
}

Value Domains::add_field(Value base, Value field, Span span) {
    if (is_named(base)) {
        const Values& fields = fields_of(head_of(base));
        const std::size_t count = base->items.size() - 1;
        Values items = base->items;
        if (count > 0 && !is_complete(base->items.back())) {
            items.back() = add_field(base->items.back(), field, span);
            const Value result = store_.dot(std::move(items));
            check_field(result->items.back(), fields[count - 1], result, span);
            return result;
        }
        if (count < fields.size()) {
            items.push_back(field);
            const Value result = store_.dot(std::move(items));
            check_field(field, fields[count], result, span);
            return result;
        }
        return store_.dot({base, field});
    }
    Values items = base->kind == Kind::dot ? base->items : Values{base};
    if (!items.empty() && is_named(items.back()) && !is_complete(items.back())) {
        items.back() = add_field(items.back(), field, span);
    } else {
        items.push_back(field);
    }
    return items.size() == 1 ? items[0] : store_.dot(std::move(items));
}

// ---------------------------------------------------------------- extensions

// Appends to `out` the fields that `whole` has after those of `part`; the rest of a nested field comes first. Returns
// false if `whole` does not begin with `part`.
bool Domains::append_fields_after(Value whole, Value part, Values& out) {
    if (whole == part) return true;
    if (!is_named(whole) || !is_named(part) || whole->items[0] != part->items[0]) return false;
    if (whole->items.size() < part->items.size()) return false;
    const std::size_t last = part->items.size() - 1;
    for (std::size_t i = 1; i < last; ++i) {
        if (whole->items[i] != part->items[i]) return false;
    }
    if (last > 0) {
        Values inner;
        if (!append_fields_after(whole->items[last], part->items[last], inner)) return false;
        if (inner.size() == 1) out.push_back(inner[0]);
        if (inner.size() > 1) out.push_back(store_.dot(std::move(inner)));
    }
    out.insert(out.end(), whole->items.begin() + static_cast<std::ptrdiff_t>(last) + 1, whole->items.end());
    return true;
}

// Returns one set for each field that the channel or constructor still needs. If the last present field is incomplete,
// the first set contains its completions.
Values Domains::missing_fields(Value value) {
    const Values& fields = fields_of(head_of(value));
    const std::size_t count = value->items.size() - 1;
    Values result;
    if (count > 0 && !is_complete(value->items.back())) {
        Values completions;
        for (const Value element : elements(fields[count - 1], {})) {
            Values rest;
            if (!append_fields_after(element, value->items.back(), rest)) continue;
            completions.push_back(rest.size() == 1 ? rest[0] : store_.dot(std::move(rest)));
        }
        result.push_back(store_.set(std::move(completions)));
    }
    result.insert(result.end(), fields.begin() + static_cast<std::ptrdiff_t>(count), fields.end());
    return result;
}

Value Domains::extensions(Value value) {
    if (!is_named(value)) return store_.set({});
    if (const auto known = extensions_.find(value); known != extensions_.end()) return known->second;
    Value result = nullptr;
    if (is_complete(value)) {
        result = store_.set({store_.dot({})});
    } else {
        const Values sets = missing_fields(value);
        const Span place = program_.heads[static_cast<std::size_t>(head_of(value))].span;
        result = sets.size() == 1 ? explicit_set(sets[0], place) : product_of(sets, Kind::dot, place);
    }
    extensions_.emplace(value, result);
    return result;
}

// Returns the values of ?x before other fields of a prefix: it matches one field of the innermost incomplete value.
Value Domains::one_field_extensions(Value value) {
    const Value nothing = store_.set({store_.dot({})});
    if (!is_named(value) || is_complete(value)) return nothing;
    if (const auto known = one_field_extensions_.find(value); known != one_field_extensions_.end())
        return known->second;
    const Values& fields = fields_of(head_of(value));
    const std::size_t count = value->items.size() - 1;
    Value result = nullptr;
    if (count == 0 || is_complete(value->items.back())) {
        result = explicit_set(fields[count], {});
    } else {
        Values next;
        for (const Value element : elements(fields[count - 1], {})) {
            Values rest;
            if (!append_fields_after(element, value->items.back(), rest) || rest.empty()) continue;
            Value first = rest.front();
            while (first->kind == Kind::dot && !is_named(first) && !first->items.empty()) first = first->items.front();
            next.push_back(first);
        }
        result = store_.set(std::move(next));
    }
    one_field_extensions_.emplace(value, result);
    return result;
}

Value Domains::productions(Value value) {
    if (const auto known = productions_.find(value); known != productions_.end()) return known->second;
    Value result = nullptr;
    if (!is_named(value)) {
        work_.fail("productions of " + text_(value) + ", which is neither an event nor of a datatype", {});
    } else if (is_complete(value)) {
        result = store_.set({value});
    } else {
        const Values& more = extensions(value)->items;
        Values items;
        items.reserve(more.size());
        for (const Value extension : more) items.push_back(append_fields(value, extension, {}));
        result = store_.set(std::move(items));
    }
    productions_.emplace(value, result);
    return result;
}

// Returns all tuples, or all dots, with one element from each set.
Value Domains::product_of(const Values& sets, Kind kind, Span span) {
    std::vector<Values> partial{{}};
    for (const Value set : sets) {
        const Values& items = elements(set, span);
        if (!items.empty() && partial.size() > max_elements / items.size()) {
            work_.fail("a type has more than 5000000 values", span);
        }
        std::vector<Values> longer;
        longer.reserve(partial.size() * items.size());
        for (const Values& prefix : partial) {
            for (const Value item : items) {
                longer.push_back(prefix);
                longer.back().push_back(item);
            }
        }
        partial = std::move(longer);
    }
    Values result;
    result.reserve(partial.size());
    for (Values& fields : partial) result.push_back(store_.make(kind, 0, std::move(fields)));
    return store_.set(std::move(result));
}

Value Domains::datatype_set(const Global& global) {
    Values items;
    for (const int head : global.heads) {
        const Value start = head_value(head);
        Values fields{store_.set({start->items[0]})};
        const Values& more = fields_of(head);
        fields.insert(fields.end(), more.begin(), more.end());
        const Values& all = product_of(fields, Kind::dot, program_.heads[static_cast<std::size_t>(head)].span)->items;
        items.insert(items.end(), all.begin(), all.end());
    }
    return store_.set(std::move(items));
}

Value Domains::subtype_set(const Global& global) {
    const Unit& unit = *global.function.clauses.at(0).unit;
    Values items;
    for (const auto& [head, fields_code] : global.subtype) {
        Value fields = store_.set({store_.dot({})});
        if (fields_code != nullptr) fields = type_set(evaluate_(*fields_code, unit), global.function.span);
        for (const Value element : elements(fields, global.function.span)) {
            const Values& all = productions(append_fields(head_value(head), element, global.function.span))->items;
            items.insert(items.end(), all.begin(), all.end());
        }
    }
    return store_.set(std::move(items));
}

// ---------------------------------------------------------------- events

std::uint64_t Domains::number_of_events() {
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < program_.heads.size(); ++i) {
        if (!program_.heads[i].channel) continue;
        std::uint64_t events = 1;
        for (const Value field : fields_of(static_cast<int>(i))) {
            const std::uint64_t size = size_of(field, program_.heads[i].span).value_or(largest_size);
            if (__builtin_mul_overflow(events, size, &events)) return largest_size;
        }
        if (__builtin_add_overflow(all, events, &all)) return largest_size;
    }
    return std::min(all, largest_size);
}

Value Domains::all_events() {
    if (all_events_ != nullptr) return all_events_;
    Values items;
    for (std::size_t i = 0; i < program_.heads.size(); ++i) {
        if (!program_.heads[i].channel) continue;
        const Values& more = productions(head_value(static_cast<int>(i)))->items;
        items.insert(items.end(), more.begin(), more.end());
    }
    all_events_ = store_.set(std::move(items));
    return all_events_;
}

process::Event Domains::event_of(Value value, Span span) {
    if (const auto known = event_index_.find(value); known != event_index_.end()) return known->second;
    const bool channel = is_named(value) && program_.heads[static_cast<std::size_t>(head_of(value))].channel;
    if (!channel) work_.fail(text_(value) + " is not an event", span);
    if (!is_complete(value)) work_.fail(text_(value) + " is not a complete event", span);
    const process::Event result = events_.intern(text_.full_text(value));
    const auto [named, fresh] = event_values_.emplace(result, value);
    if (!fresh) work_.fail("two events are both called " + text_(value), span);
    event_index_.emplace(value, result);
    return result;
}

const process::EventSet& Domains::event_set(Value set, Span span) {
    if (const auto known = event_sets_.find(set); known != event_sets_.end()) return known->second;
    process::EventSet result;
    for (const Value element : elements(set, span)) result.push_back(event_of(element, span));
    std::ranges::sort(result);
    return event_sets_.emplace(set, std::move(result)).first->second;
}

}  // namespace robochart::cspm
