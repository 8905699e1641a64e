// What the predefined names do (FDR manual, chapter CSPM, Built-In Definitions).
#include <algorithm>
#include <map>
#include <set>

#include "checker/cspm/eval/evaluator_internal.hpp"
#include "checker/process/priority_order.hpp"

namespace robochart::cspm {

Values Evaluator::sequence(Value value, Span span) {
    return share(written_out(value, span))->items;
}

const Values& Evaluator::map_items(Value value, Span span) {
    if (value->kind != Kind::map) fail("expected a map, found " + text(value), span);
    return value->items;
}

Value Evaluator::builtin_value(Builtin which, const TimedSection* timed) {
    const auto process = [this](process::TermId term) {
        return store_.make(Kind::process, static_cast<std::int64_t>(term), {});
    };
    switch (which) {
        case Builtin::true_:
            return store_.boolean(true);
        case Builtin::false_:
            return store_.boolean(false);
        case Builtin::bool_:
            return store_.set({store_.boolean(false), store_.boolean(true)});
        case Builtin::int_:
            return store_.make(Kind::integers, 0, {});
        case Builtin::proc:
            return store_.make(Kind::processes, 0, {});
        case Builtin::char_: {
            Values items;
            for (std::int64_t code = 0; code < 256; ++code) items.push_back(store_.character(code));
            return store_.set(std::move(items));
        }
        case Builtin::events:
            return all_events();
        case Builtin::empty_map:
            return store_.make(Kind::map, 0, {});
        case Builtin::stop:
            return process(stop(timed));
        case Builtin::skip:
            return process(skip(timed));
        case Builtin::div:
            return process(make(process::Op::div));
        default:
            break;
    }
    // In a timed section WAIT and timed_priority know the section's tock.
    Values items;
    if (timed != nullptr && (which == Builtin::wait || which == Builtin::timed_priority)) {
        items.push_back(head_value(timed->tock));
    }
    return store_.make(Kind::builtin, static_cast<std::int64_t>(which), std::move(items));
}

Value Evaluator::call_builtin(Value builtin, Values arguments, Span span) {
    const auto which = static_cast<Builtin>(builtin->number);
    const BuiltinName& name = builtin_name(which);
    if (!takes_by_need(which))
        for (Value& argument : arguments) argument = share(force(argument));
    // relational_image(R)(x): the relation is kept in the built-in's items.
    if ((which == Builtin::relational_image || which == Builtin::relational_inverse_image) && !builtin->items.empty()) {
        arguments.insert(arguments.begin(), builtin->items[0]);
        return relation_builtin(which, arguments, span);
    }
    if (static_cast<int>(arguments.size()) != name.arguments) {
        fail("'" + std::string(name.name) + "' takes " + std::to_string(name.arguments) + " arguments, not " +
                 std::to_string(arguments.size()),
             span);
    }
    if (which >= Builtin::union_ && which <= Builtin::sequences) return set_builtin(which, arguments, span);
    if (which >= Builtin::seq && which <= Builtin::elem) return sequence_builtin(which, arguments, span);
    if (which >= Builtin::map_from_list && which <= Builtin::map_type) return map_builtin(which, arguments, span);
    switch (which) {
        case Builtin::extensions:
            return extensions(arguments[0]);
        case Builtin::productions:
            return productions(arguments[0]);
        case Builtin::error: {
            std::string message;
            for (const Value each : sequence(arguments[0], span)) message += static_cast<char>(each->number);
            fail("error: " + message, span);
        }
        case Builtin::show:
            return store_.text(text(arguments[0]));
        case Builtin::mtransclose:
            return representatives(arguments[0], arguments[1], span);
        case Builtin::relational_image:
        case Builtin::relational_inverse_image:
            return store_.make(Kind::builtin, static_cast<std::int64_t>(which), {arguments[0]});
        case Builtin::transpose:
            return relation_builtin(which, arguments, span);
        default:
            return process_builtin(which, builtin, arguments, span);
    }
}

Value Evaluator::set_builtin(Builtin which, const Values& arguments, Span span) {
    switch (which) {
        case Builtin::union_:
            return set_union(arguments[0], arguments[1], span);
        case Builtin::inter:
            return set_inter(arguments[0], arguments[1], span);
        case Builtin::diff:
            return set_diff(arguments[0], arguments[1], span);
        case Builtin::union_all:
            return union_of_all(elements(arguments[0], span), span);
        case Builtin::inter_all: {
            Value result = nullptr;
            for (const Value each : elements(arguments[0], span)) {
                result = result == nullptr ? each : set_inter(result, each, span);
            }
            return result == nullptr ? store_.set({}) : result;
        }
        case Builtin::member:
            return store_.boolean(member_of(arguments[0], arguments[1], span));
        case Builtin::card: {
            const auto size = size_of(arguments[0], span);
            if (!size) fail("the set " + text(arguments[0]) + " is infinite", span);
            if (*size >= largest_size) fail("the number does not fit in 64 bits", span);
            return store_.integer(static_cast<std::int64_t>(*size));
        }
        case Builtin::empty:
            return store_.boolean(size_of(arguments[0], span) == 0);
        case Builtin::set:
            return store_.set(sequence(arguments[0], span));
        case Builtin::powerset:
            if (!is_set(arguments[0])) fail("expected a set, found " + text(arguments[0]), span);
            return store_.make(Kind::subsets_of, 0, {arguments[0]});
        default:
            if (!is_set(arguments[0])) fail("expected a set, found " + text(arguments[0]), span);
            return store_.make(Kind::sequences_over, 0, {arguments[0]});
    }
}

Value Evaluator::sequence_builtin(Builtin which, const Values& arguments, Span span) {
    if (which == Builtin::seq) return store_.sequence(elements(arguments[0], span));
    if (which == Builtin::elem) return store_.boolean(element_by_need(forced(arguments[0]), forced(arguments[1]), span));
    const Value first = forced(arguments[0]);
    switch (which) {
        case Builtin::length:
            return store_.integer(static_cast<std::int64_t>(written_out(first, span)->items.size()));
        case Builtin::null:
            return store_.boolean(first->kind == Kind::sequence ? first->items.empty() : !next(first, span));
        case Builtin::head: {
            if (first->kind == Kind::sequence && !first->items.empty()) return forced(first->items[0]);
            const std::optional<Cut> cut = next(first, span);
            if (!cut) fail("head of an empty sequence", span);
            return forced(cut->head);
        }
        case Builtin::tail: {
            const std::optional<Cut> cut = next(first, span);
            if (!cut) fail("tail of an empty sequence", span);
            return forced(cut->tail);
        }
        default: {  // concat
            const Value parts = written_out(first, span);
            Values items;
            for (std::size_t i = 0; i < parts->items.size(); ++i) {
                Value part = parts->items[i];
                if (part->kind == Kind::thunk && static_cast<const Thunk&>(*part).result != nullptr) part = force(part);
                if (part->kind != Kind::sequence) {
                    // It waits or has no end: so does what comes after.
                    Value rest = store_.sequence({});
                    for (std::size_t k = parts->items.size(); k-- > i + 1;) rest = part_before(parts->items[k], rest);
                    return append(store_.compound(Kind::sequence, 0, std::move(items)), part_before(part, rest));
                }
                count_step(span);
                items.insert(items.end(), part->items.begin(), part->items.end());
                if (items.size() > max_elements) fail("the sequence is too long", span);
            }
            return store_.compound(Kind::sequence, 0, std::move(items));
        }
    }
}

// part ^ rest, where the part may wait.
Value Evaluator::part_before(Value part, Value rest) {
    if (part->kind == Kind::sequence && rest->kind == Kind::sequence) return append(part, rest);
    if (rest->kind == Kind::sequence && rest->items.empty()) return part;
    return store_.compound(Kind::stream, -1, {part, rest});
}

namespace {

// The position of a key in k1, v1, k2, v2..., or the position to insert it at.
std::size_t key_place(const Values& items, Value key) {
    std::size_t at = 0;
    while (at < items.size() && compare(items[at], key) < 0) at += 2;
    return at;
}

void put(Values& items, Value key, Value value) {
    const std::size_t at = key_place(items, key);
    if (at < items.size() && items[at] == key)
        items[at + 1] = value;
    else
        items.insert(items.begin() + static_cast<std::ptrdiff_t>(at), {key, value});
}

}  // namespace

// Keys have values, what they stand for may wait.
Value Evaluator::map_builtin(Builtin which, const Values& arguments, Span span) {
    const auto put_all = [&](Values items, const Values& pairs) {
        for (const Value each : pairs) {
            count_step(span);
            const Value pair = forced(each);
            if (pair->kind != Kind::tuple || pair->items.size() != 2) fail("expected pairs, found " + text(pair), span);
            put(items, share(pair->items[0]), pair->items[1]);
        }
        return store_.compound(Kind::map, 0, std::move(items));
    };
    if (which == Builtin::map_from_list) return put_all({}, written_out(arguments[0], span)->items);
    if (which == Builtin::map_type) return store_.make(Kind::maps_over, 0, {arguments[0], arguments[1]});
    Values items = map_items(forced(arguments[0]), span);
    if (which == Builtin::map_update_multiple) {
        // Of pairs with one key the first counts, where mapFromList takes the last (libcspm, Evaluator).
        Values pairs = written_out(arguments[1], span)->items;
        std::reverse(pairs.begin(), pairs.end());
        return put_all(std::move(items), pairs);
    }
    if (which == Builtin::map_to_list) {
        Values pairs;
        for (std::size_t i = 0; i + 1 < items.size(); i += 2)
            pairs.push_back(store_.compound(Kind::tuple, 0, {items[i], items[i + 1]}));
        return store_.compound(Kind::sequence, 0, std::move(pairs));
    }
    const Value key = share(arguments[1]);
    const std::size_t at = key_place(items, key);
    const bool found = at < items.size() && items[at] == key;
    switch (which) {
        case Builtin::map_lookup:
            if (!found) fail("the key " + text(key) + " is not in the map", span);
            return forced(items[at + 1]);
        case Builtin::map_member:
            return store_.boolean(found);
        case Builtin::map_update:
            put(items, key, arguments[2]);
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

// transpose(R), relational_image(R)(x), relational_inverse_image(R)(x).
Value Evaluator::relation_builtin(Builtin which, const Values& arguments, Span span) {
    Values result;
    const std::size_t from = which == Builtin::relational_inverse_image ? 1 : 0;
    for (const Value pair : elements(arguments[0], span)) {
        if (pair->kind != Kind::tuple || pair->items.size() != 2) fail("expected pairs, found " + text(pair), span);
        if (which == Builtin::transpose)
            result.push_back(store_.tuple({pair->items[1], pair->items[0]}));
        else if (pair->items[from] == arguments.at(1))
            result.push_back(pair->items[1 - from]);
    }
    return store_.set(std::move(result));
}

// mtransclose(R, S): the classes of R's symmetric and transitive closure, as pairs (representative, x) of members of S,
// without (x, x). The manual does not define the representative of a class: ours is the least one in S.
Value Evaluator::representatives(Value relation, Value set, Span span) {
    std::map<Value, Values> related;
    for (const Value pair : elements(relation, span)) {
        related[pair->items.at(0)].push_back(pair->items.at(1));
        related[pair->items.at(1)].push_back(pair->items.at(0));
    }
    std::set<Value> seen;
    Values result;
    for (const Value representative : elements(set, span)) {
        if (!related.contains(representative) || !seen.insert(representative).second) continue;
        Values work{representative};
        while (!work.empty()) {
            const Value next = work.back();
            work.pop_back();
            for (const Value each : related[next]) {
                if (!seen.insert(each).second) continue;
                work.push_back(each);
                if (member_of(each, set, span)) result.push_back(store_.tuple({representative, each}));
            }
        }
    }
    return store_.set(std::move(result));
}

namespace {

std::uint32_t compression(Builtin which) {
    using process::Compression;
    switch (which) {
        case Builtin::normal:
        case Builtin::lazynorm:
            return static_cast<std::uint32_t>(Compression::normal);
        case Builtin::sbisim:
            return static_cast<std::uint32_t>(Compression::sbisim);
        case Builtin::dbisim:
            return static_cast<std::uint32_t>(Compression::dbisim);
        case Builtin::wbisim:
            return static_cast<std::uint32_t>(Compression::wbisim);
        case Builtin::diamond:
            return static_cast<std::uint32_t>(Compression::diamond);
        case Builtin::tau_loop_factor:
            return static_cast<std::uint32_t>(Compression::tau_loop_factor);
        case Builtin::model_compress:
            return static_cast<std::uint32_t>(Compression::model_compress);
        case Builtin::deter:
            return static_cast<std::uint32_t>(Compression::deter);
        case Builtin::lazyenumerate:
            return static_cast<std::uint32_t>(Compression::lazyenumerate);
        case Builtin::failure_watchdog:
            return static_cast<std::uint32_t>(Compression::failure_watchdog);
        case Builtin::trace_watchdog:
            return static_cast<std::uint32_t>(Compression::trace_watchdog);
        default:
            return static_cast<std::uint32_t>(Compression::explicate);
    }
}

}  // namespace

/// BUFFER(capacity, {(input, output)}), empty.
process::TermId Evaluator::buffer(const Values& arguments, Span span) {
    const Value bound = arguments[0];
    if (bound->kind != Kind::integer || bound->number < 1)
        fail("a buffer's capacity is at least 1, not " + text(bound), span);
    std::set<process::Event> used;
    for (const Value pair : elements(arguments[1], span))
        for (const Value each : pair->items)
            if (!used.insert(event(each, span)).second)
                fail("the event " + text(each) + " is given to a buffer twice", span);
    return prefix_term(PrefixKind::buffer, {bound, explicit_set(arguments[1], span), store_.sequence({})});
}

/// The order of prioritisepo(P, prioritised, pairs, maximal).
process::RenamingId Evaluator::partial_order(const Values& arguments, Span span) {
    // One after the other: events are numbered in the order in which they are first met.
    const process::EventSet prioritised = event_set(arguments[1], span);
    std::vector<process::EventPair> pairs;
    for (const Value pair : elements(arguments[2], span)) {
        const process::Event higher = event(pair->items.at(0), span);
        pairs.emplace_back(higher, event(pair->items.at(1), span));
    }
    auto order = process::priority_order(prioritised, pairs, event_set(arguments[3], span));
    if (const auto* fault = std::get_if<process::OrderFault>(&order)) {
        const std::string name = events_.name(fault->event);
        switch (fault->kind) {
            case process::OrderFault::Kind::missing:
                fail("prioritisepo: " + name + " is not among the prioritised events", span);
            case process::OrderFault::Kind::cyclic:
                fail("prioritisepo: the order is cyclic, " + name + " lies above itself", span);
            case process::OrderFault::Kind::not_maximal:
                fail("prioritisepo: " + name + " is given as maximal, but lies below another event", span);
        }
    }
    return terms_.renaming(std::get<process::Renaming>(std::move(order)));
}

Value Evaluator::process_builtin(Builtin which, Value builtin, const Values& arguments, Span span) {
    using process::Op;
    const auto made = [this](process::TermId id) {
        return store_.make(Kind::process, static_cast<std::int64_t>(id), {});
    };
    const auto id = [](auto strong) { return static_cast<std::uint32_t>(strong); };
    switch (which) {
        case Builtin::chaos:
            return made(make(Op::chaos, {}, id(terms_.set(event_set(arguments[0], span)))));
        case Builtin::run:
            return made(make(Op::run, {}, id(terms_.set(event_set(arguments[0], span)))));
        case Builtin::wait: {
            if (arguments[0]->kind != Kind::integer) fail("WAIT takes a number, not " + text(arguments[0]), span);
            if (arguments[0]->number < 0) fail("WAIT(" + text(arguments[0]) + ") waits for less than no time", span);
            const process::Event tock = event(builtin->items.at(0), span);
            const process::TermId stopped = prefix_term(PrefixKind::skipping, {store_.integer(tock)});
            return made(waiting(tock, arguments[0]->number, make(Op::external_choice, {stopped, make(Op::skip)})));
        }
        case Builtin::timed_priority: {
            const process::Event tock = event(builtin->items.at(0), span);
            return made(make(Op::prioritise, {term(arguments[0], span)}, id(terms_.order({{}, {tock}}))));
        }
        case Builtin::prioritise:
        case Builtin::prioritise_nocache: {
            process::PriorityOrder order;
            for (const Value each : sequence(arguments[1], span)) order.push_back(event_set(each, span));
            if (order.empty()) fail("prioritise needs at least one set", span);
            return made(make(Op::prioritise, {term(arguments[0], span)}, id(terms_.order(std::move(order)))));
        }
        case Builtin::prioritisepo: {
            const process::RenamingId order = partial_order(arguments, span);
            return made(make(Op::prioritise_order, {term(arguments[0], span)}, id(order)));
        }
        case Builtin::chase:
        case Builtin::chase_nocache:
            return made(make(Op::chase, {term(arguments[0], span)}));
        case Builtin::loop:
            return made(call_term(builtin, arguments));
        case Builtin::buffer:
            return made(buffer(arguments, span));
        // Terms, so that they can be named and compared; what they do is refused when it is asked for.
        case Builtin::failure_watchdog:
        case Builtin::trace_watchdog: {
            process::Term result{Op::compress, compression(which), {term(arguments[0], span)}, {}};
            result.sets = {terms_.set(event_set(arguments[1], span)), terms_.set({event(arguments[2], span)})};
            return made(terms_.make(result));
        }
        case Builtin::weak_buffer:
        case Builtin::signal_buffer:
            not_supported("'" + std::string(builtin_name(which).name) + "'", span);
        default:
            return made(make(Op::compress, {term(arguments[0], span)}, compression(which)));
    }
}

}  // namespace robochart::cspm
