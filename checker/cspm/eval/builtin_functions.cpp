// SPDX-License-Identifier: Apache-2.0
// Implements the predefined functions (FDR manual, chapter CSPM, Built-In Definitions).
#include "checker/cspm/eval/builtin_functions.hpp"

#include <map>
#include <set>

#include "checker/cspm/types/builtins.hpp"
#include "checker/process/priority_order.hpp"

namespace robochart::cspm {

Value BuiltinFunctions::value(Builtin which, const TimedSection* timed) {
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
            return domains_.all_events();
        case Builtin::empty_map:
            return store_.make(Kind::map, 0, {});
        case Builtin::stop:
            return process(processes_.make_stop(timed));
        case Builtin::skip:
            return process(processes_.make_skip(timed));
        case Builtin::div:
            return process(processes_.make_term(process::Op::div));
        default:
            break;
    }
    // In a timed section, WAIT and timed_priority use the tock event of this section, so it is stored with them.
    Values items;
    if (timed != nullptr && (which == Builtin::wait || which == Builtin::timed_priority)) {
        items.push_back(domains_.head_value(timed->tock));
    }
    return store_.make(Kind::builtin, static_cast<std::int64_t>(which), std::move(items));
}

void BuiltinFunctions::check_arity(Builtin which, std::size_t arguments, Span span) const {
    const BuiltinName& name = builtin_name(which);
    if (static_cast<int>(arguments) != name.arguments)
        work_.fail("'" + std::string(name.name) + "' takes " + std::to_string(name.arguments) + " arguments, not " +
                       std::to_string(arguments),
                   span);
}

const Values& BuiltinFunctions::items(Value sequence, Span span) const {
    if (is_stream(sequence)) work_.fail("the sequence " + text_(sequence) + " is infinite", span);
    if (sequence->kind != Kind::sequence) work_.fail("expected a sequence, found " + text_(sequence), span);
    return sequence->items;
}

Value BuiltinFunctions::call(Value builtin, Values arguments, Span span) {
    const auto which = static_cast<Builtin>(builtin->number);
    // relational_image(R)(x): the items of the built-in contain R.
    if ((which == Builtin::relational_image || which == Builtin::relational_inverse_image) && !builtin->items.empty()) {
        arguments.insert(arguments.begin(), builtin->items[0]);
        return relation_builtin(which, arguments, span);
    }
    check_arity(which, arguments.size(), span);
    if (which >= Builtin::union_ && which <= Builtin::sequences) return set_builtin(which, arguments, span);
    switch (which) {
        case Builtin::seq:
            return store_.sequence(domains_.elements(arguments[0], span));
        case Builtin::map_type:
            return store_.make(Kind::maps_over, 0, {arguments[0], arguments[1]});
        case Builtin::extensions:
            return domains_.extensions(arguments[0]);
        case Builtin::productions:
            return domains_.productions(arguments[0]);
        case Builtin::error: {
            std::string message;
            for (const Value character : items(arguments[0], span)) message += static_cast<char>(character->number);
            work_.fail("error: " + message, span);
        }
        case Builtin::show:
            return store_.make_string(text_.full_text(with_text(arguments[0], span)));
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

// Converts a value to a form with a unique text: equal values must have equal texts. Lists the elements of sets if
// possible. Rejects infinite values and values without a text, such as processes.
Value BuiltinFunctions::with_text(Value value, Span span) {
    switch (value->kind) {
        case Kind::process:
            work_.fail("'show' of a process: only data have a text", span);
        case Kind::function:
        case Kind::builtin:
            work_.fail("'show' of a function: only data have a text", span);
        case Kind::stream:
        case Kind::sequence_from:
            work_.fail("'show' of an infinite sequence: " + text_(value), span);
        case Kind::integer:
        case Kind::boolean:
        case Kind::character:
        case Kind::tuple:
        case Kind::sequence:
        case Kind::set:
        case Kind::map:
        case Kind::head:
        case Kind::dot:
        case Kind::integers:
        case Kind::integers_from:
        case Kind::processes:
        case Kind::datatype:
        case Kind::sequences_over:
        case Kind::subsets_of:
        case Kind::maps_over:
        case Kind::united:
        case Kind::group:
        case Kind::thunk:
            break;
    }
    value = store_.form_as_part(value);
    Values items;
    for (const Value item : value->items) items.push_back(with_text(item, span));
    if (value->kind == Kind::set) return store_.set(std::move(items));
    return store_.make(value->kind, value->number, std::move(items));
}

Value BuiltinFunctions::set_builtin(Builtin which, const Values& arguments, Span span) {
    switch (which) {
        case Builtin::union_:
            return domains_.set_union(arguments[0], arguments[1], span);
        case Builtin::inter:
            return domains_.set_inter(arguments[0], arguments[1], span);
        case Builtin::diff:
            return domains_.set_diff(arguments[0], arguments[1], span);
        case Builtin::union_all:
            return domains_.union_of_all(domains_.elements(arguments[0], span), span);
        case Builtin::inter_all: {
            Value result = nullptr;
            for (const Value set : domains_.elements(arguments[0], span)) {
                result = result == nullptr ? set : domains_.set_inter(result, set, span);
            }
            return result == nullptr ? store_.set({}) : result;
        }
        case Builtin::member:
            return store_.boolean(domains_.member_of(arguments[0], arguments[1], span));
        case Builtin::card: {
            const auto size = domains_.size_of(arguments[0], span);
            if (!size) work_.fail("the set " + text_(arguments[0]) + " is infinite", span);
            if (*size >= Domains::largest_size) work_.fail("the number does not fit in 64 bits", span);
            return store_.integer(static_cast<std::int64_t>(*size));
        }
        case Builtin::empty:
            return store_.boolean(domains_.size_of(arguments[0], span) == 0);
        case Builtin::set:
            return store_.set(items(arguments[0], span));
        case Builtin::powerset:
            if (!is_set(arguments[0])) work_.fail("expected a set, found " + text_(arguments[0]), span);
            return store_.make(Kind::subsets_of, 0, {arguments[0]});
        default:
            if (!is_set(arguments[0])) work_.fail("expected a set, found " + text_(arguments[0]), span);
            return store_.make(Kind::sequences_over, 0, {arguments[0]});
    }
}

// Computes transpose(R), relational_image(R)(x) and relational_inverse_image(R)(x).
Value BuiltinFunctions::relation_builtin(Builtin which, const Values& arguments, Span span) {
    Values result;
    const std::size_t from = which == Builtin::relational_inverse_image ? 1 : 0;
    for (const Value pair : domains_.elements(arguments[0], span)) {
        if (pair->kind != Kind::tuple || pair->items.size() != 2)
            work_.fail("expected pairs, found " + text_(pair), span);
        if (which == Builtin::transpose)
            result.push_back(store_.tuple({pair->items[1], pair->items[0]}));
        else if (pair->items[from] == arguments.at(1))
            result.push_back(pair->items[1 - from]);
    }
    return store_.set(std::move(result));
}

// Computes mtransclose(R, S). The symmetric and transitive closure of R divides S into classes. The result contains (r,
// x) for each class, where r represents the class and x is another member. FDR's manual does not define r; here r is
// the least member.
Value BuiltinFunctions::representatives(Value relation, Value set, Span span) {
    std::map<Value, Values> related;
    for (const Value pair : domains_.elements(relation, span)) {
        related[pair->items.at(0)].push_back(pair->items.at(1));
        related[pair->items.at(1)].push_back(pair->items.at(0));
    }
    std::set<Value> seen;
    Values result;
    for (const Value representative : domains_.elements(set, span)) {
        if (!related.contains(representative) || !seen.insert(representative).second) continue;
        Values work{representative};
        while (!work.empty()) {
            const Value next = work.back();
            work.pop_back();
            for (const Value neighbour : related[next]) {
                if (!seen.insert(neighbour).second) continue;
                work.push_back(neighbour);
                if (domains_.member_of(neighbour, set, span))
                    result.push_back(store_.tuple({representative, neighbour}));
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

/// Returns an empty BUFFER(capacity, {(input, output)}).
process::TermId BuiltinFunctions::buffer(const Values& arguments, Span span) {
    const Value bound = arguments[0];
    if (bound->kind != Kind::integer || bound->number < 1)
        work_.fail("a buffer's capacity is at least 1, not " + text_(bound), span);
    std::set<process::Event> used;
    for (const Value pair : domains_.elements(arguments[1], span))
        for (const Value event : pair->items)
            if (!used.insert(domains_.event_of(event, span)).second)
                work_.fail("the event " + text_(event) + " is given to a buffer twice", span);
    return processes_.make_prefix(PrefixKind::buffer,
                                  {bound, domains_.explicit_set(arguments[1], span), store_.sequence({})});
}

/// Returns the order of prioritisepo(P, prioritised, pairs, maximal).
process::RenamingId BuiltinFunctions::partial_order(const Values& arguments, Span span) {
    // Evaluates the arguments in order, because events get their numbers when they are first used.
    const process::EventSet prioritised = domains_.event_set(arguments[1], span);
    std::vector<process::EventPair> pairs;
    for (const Value pair : domains_.elements(arguments[2], span)) {
        const process::Event higher = domains_.event_of(pair->items.at(0), span);
        pairs.emplace_back(higher, domains_.event_of(pair->items.at(1), span));
    }
    auto order = process::priority_order(prioritised, pairs, domains_.event_set(arguments[3], span));
    if (const auto* fault = std::get_if<process::OrderFault>(&order)) {
        const std::string name = events_.name(fault->event);
        switch (fault->kind) {
            case process::OrderFault::Kind::missing:
                work_.fail("prioritisepo: " + name + " is not among the prioritised events", span);
            case process::OrderFault::Kind::cyclic:
                work_.fail("prioritisepo: the order is cyclic, " + name + " lies above itself", span);
            case process::OrderFault::Kind::not_maximal:
                work_.fail("prioritisepo: " + name + " is given as maximal, but lies below another event", span);
        }
    }
    return terms_.intern_renaming(std::get<process::Renaming>(std::move(order)));
}

Value BuiltinFunctions::process_builtin(Builtin which, Value builtin, const Values& arguments, Span span) {
    using process::Op;
    const auto made = [this](process::TermId id) {
        return store_.make(Kind::process, static_cast<std::int64_t>(id), {});
    };
    const auto id = [](auto strong) { return static_cast<std::uint32_t>(strong); };
    switch (which) {
        case Builtin::chaos:
            return made(
                processes_.make_term(Op::chaos, {}, id(terms_.intern_set(domains_.event_set(arguments[0], span)))));
        case Builtin::run:
            return made(
                processes_.make_term(Op::run, {}, id(terms_.intern_set(domains_.event_set(arguments[0], span)))));
        case Builtin::wait: {
            if (arguments[0]->kind != Kind::integer)
                work_.fail("WAIT takes a number, not " + text_(arguments[0]), span);
            if (arguments[0]->number < 0)
                work_.fail("WAIT(" + text_(arguments[0]) + ") waits for less than no time", span);
            const process::Event tock = domains_.event_of(builtin->items.at(0), span);
            const process::TermId stopped = processes_.make_prefix(PrefixKind::skipping, {store_.integer(tock)});
            return made(processes_.make_wait(
                tock, arguments[0]->number,
                processes_.make_term(Op::external_choice, {stopped, processes_.make_term(Op::skip)})));
        }
        case Builtin::timed_priority: {
            const process::Event tock = domains_.event_of(builtin->items.at(0), span);
            return made(processes_.make_term(Op::prioritise, {processes_.term_of(arguments[0], span)},
                                             id(terms_.intern_order({{}, {tock}}))));
        }
        case Builtin::prioritise:
        case Builtin::prioritise_nocache: {
            process::PriorityOrder order;
            for (const Value set : items(arguments[1], span)) order.push_back(domains_.event_set(set, span));
            if (order.empty()) work_.fail("prioritise needs at least one set", span);
            return made(processes_.make_term(Op::prioritise, {processes_.term_of(arguments[0], span)},
                                             id(terms_.intern_order(std::move(order)))));
        }
        case Builtin::prioritisepo: {
            const process::RenamingId order = partial_order(arguments, span);
            return made(
                processes_.make_term(Op::prioritise_order, {processes_.term_of(arguments[0], span)}, id(order)));
        }
        case Builtin::chase:
        case Builtin::chase_nocache:
            return made(processes_.make_term(Op::chase, {processes_.term_of(arguments[0], span)}));
        case Builtin::loop:
            return made(processes_.make_call(builtin, arguments));
        case Builtin::buffer:
            return made(buffer(arguments, span));
        // Watchdogs are terms, so scripts can name and compare them. But the checker cannot compute their transitions.
        case Builtin::failure_watchdog:
        case Builtin::trace_watchdog: {
            process::Term result{Op::compress, compression(which), {processes_.term_of(arguments[0], span)}, {}};
            result.sets = {terms_.intern_set(domains_.event_set(arguments[1], span)),
                           terms_.intern_set({domains_.event_of(arguments[2], span)})};
            return made(terms_.intern_term(result));
        }
        case Builtin::weak_buffer:
        case Builtin::signal_buffer:
            work_.not_supported("'" + std::string(builtin_name(which).name) + "'", span);
        default:
            return made(
                processes_.make_term(Op::compress, {processes_.term_of(arguments[0], span)}, compression(which)));
    }
}

}  // namespace robochart::cspm
