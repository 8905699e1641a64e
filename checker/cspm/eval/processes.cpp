// Process expressions to terms. In a timed section choice, interrupt and the parallel operators synchronise
// on tock, and STOP, SKIP and prefixes let time pass (semantics 3.10).
#include <algorithm>

#include "checker/cspm/eval/evaluator_internal.hpp"

namespace robochart::cspm {

using process::Op;
using process::TermId;

namespace {
template <typename Id>
std::uint32_t payload(Id id) {
    return static_cast<std::uint32_t>(id);
}
}  // namespace

TermId Evaluator::make(Op op, std::vector<TermId> children, std::uint32_t payload) {
    return terms_.make({op, payload, std::move(children), {}});
}

TermId Evaluator::term(Value value, Span span) {
    if (value->kind != Kind::process) fail("expected a process, found " + text(value), span);
    return static_cast<TermId>(value->number);
}

// op over the children; one child alone is itself.
TermId Evaluator::many(Op op, std::vector<TermId> children, std::uint32_t payload) {
    return children.size() == 1 ? children[0] : make(op, std::move(children), payload);
}

process::Event Evaluator::tock(const TimedSection& timed) {
    return event(head_value(timed.tock), {});
}
process::SetId Evaluator::tock_set(const TimedSection& timed) {
    return terms_.set({tock(timed)});
}

TermId Evaluator::stop(const TimedSection* timed) {
    if (timed == nullptr) return make(Op::stop);
    return prefix_term(PrefixKind::stopped, {store_.integer(tock(*timed))});
}

TermId Evaluator::skip(const TimedSection* timed) {
    if (timed == nullptr) return make(Op::skip);
    const TermId passing = prefix_term(PrefixKind::skipping, {store_.integer(tock(*timed))});
    return make(Op::external_choice, {passing, make(Op::skip)});
}

TermId Evaluator::waiting(process::Event tock, std::int64_t ticks, TermId then) {
    if (ticks <= 0) return then;
    const Value target = store_.make(Kind::process, static_cast<std::int64_t>(then), {});
    return prefix_term(PrefixKind::waiting, {store_.integer(tock), store_.integer(ticks), target});
}

std::int64_t Evaluator::duration(TimedSection& timed, Value event, Span span) {
    if (timed.duration == nullptr) return 1;
    if (timed.duration_value == nullptr) {
        Frame frame(static_cast<std::size_t>(timed.unit->size), nullptr);
        timed.duration_value = share(eval(*timed.duration, frame));
    }
    const Value result = call(timed.duration_value, {event}, span);
    if (result->kind != Kind::integer || result->number < 0) {
        fail("the duration of " + text(event) + " is " + text(result) + ", not a number from 0", span);
    }
    return result->number;
}

// Arguments that the definition does not read are all alike: calls that differ in them are one process.
TermId Evaluator::call_term(Value function, const Values& arguments) {
    Values key{function};
    key.insert(key.end(), arguments.begin(), arguments.end());
    if (const Function* definition = function->function; definition != nullptr)
        for (std::size_t i = 0; i < definition->unread.size(); ++i)
            if (definition->unread[i]) key[i + 1] = store_.character('_');
    const Value tuple = store_.make(Kind::tuple, 1, std::move(key));
    const auto [place, fresh] = call_index_.emplace(tuple, static_cast<std::uint32_t>(calls_.size()));
    if (fresh) calls_.push_back(tuple);
    return make(Op::call, {}, place->second);
}

process::SetId Evaluator::set_id(const Code& code, Frame& frame) {
    const Value set = share(eval(code, frame));
    if (!is_set(set)) fail("expected a set of events, found " + text(set), code.span);
    return terms_.set(event_set(set, code.span));
}

// ---------------------------------------------------------------- calls

TermId Evaluator::process(const Code& code, Frame& frame) {
    count_step(code.span);
    switch (code.kind) {
        case ExprKind::name:
            return process_name(code, frame);
        case ExprKind::apply:
            return process_apply(code, frame);
        case ExprKind::if_then_else:
            return process(*code.args[truth(*code.args[0], frame) ? 1 : 2], frame);
        case ExprKind::let:
            open_let(code, frame);
            return process(*code.args[0], frame);
        case ExprKind::prefix:
            return prefix(code, frame);
        case ExprKind::guard:
            return truth(*code.args[0], frame) ? process(*code.args[1], frame) : stop(code.timed);
        case ExprKind::rename:
            return process_rename(code, frame);
        case ExprKind::linked:
            return process_linked(code, frame);
        case ExprKind::replicated_linked:
            return process_replicated_linked(code, frame);
        default:
            break;
    }
    if (code.kind >= ExprKind::replicated_external && code.kind <= ExprKind::replicated_synchronising) {
        return process_replicated(code, frame);
    }
    if (code.kind >= ExprKind::external_choice && code.kind <= ExprKind::project) return process_operator(code, frame);
    return term(eval(code, frame), code.span);
}

// A constant in a process's place is named, not looked into: recursion stays finite.
TermId Evaluator::process_name(const Code& code, Frame& frame) {
    if (code.reference == Reference::member) {
        const auto& group = static_cast<const GroupObject&>(*frame[static_cast<std::size_t>(code.slot)]);
        const Member& member = group.group->members[static_cast<std::size_t>(code.index)];
        if (member.function.groups.empty() && member.component_of < 0) {
            const Value environment = share(&group);
            return call_term(store_.make(Kind::function, 0, {environment}, &member.function), {});
        }
    }
    if (code.reference == Reference::global) {
        const Global& global = program_.globals[static_cast<std::size_t>(code.slot)];
        if (global.kind == GlobalKind::function && global.function.groups.empty()) {
            return call_term(store_.make(Kind::function, 0, {}, &global.function), {});
        }
    }
    return term(eval_name(code, frame), code.span);
}

TermId Evaluator::process_apply(const Code& code, Frame& frame) {
    const Value function = share(eval(*code.args[0], frame));
    if (function->kind != Kind::function) return term(eval_apply(code, frame), code.span);
    const Function& definition = *function->function;
    Values arguments;
    try {
        for (std::size_t i = 1; i < code.args.size(); ++i) arguments.push_back(share(eval(*code.args[i], frame)));
    } catch (const EvaluationError&) {
        // A process is named by its arguments, so they have values; another function may not need all of them.
        if (makes_process(definition)) throw;
        return term(eval_apply(code, frame), code.span);
    }
    std::size_t total = 0;
    for (const std::size_t group : definition.groups) total += group;
    const std::size_t given = function->items.size() - definition.environment;
    const bool last =
        !definition.groups.empty() && given + arguments.size() == total && definition.groups.back() == arguments.size();
    if (!last) return term(call(function, std::move(arguments), code.span), code.span);
    return call_term(function, arguments);
}

// ---------------------------------------------------------------- operators

// Operands of a chain P op Q op R, left to right.
void Evaluator::collect(const Code& code, ExprKind kind, Frame& frame, std::vector<TermId>& out) {
    std::vector<const Code*> right;
    const Code* left = &code;
    while (left->kind == kind) {
        right.push_back(left->args[1]);
        left = left->args[0];
    }
    out.push_back(process(*left, frame));
    for (auto each = right.rbegin(); each != right.rend(); ++each) out.push_back(process(**each, frame));
}

TermId Evaluator::process_operator(const Code& code, Frame& frame) {
    const TimedSection* timed = code.timed;
    std::vector<TermId> operands;
    if (code.kind == ExprKind::external_choice || code.kind == ExprKind::internal_choice ||
        code.kind == ExprKind::interleave) {
        collect(code, code.kind, frame, operands);
        if (code.kind == ExprKind::internal_choice) return many(Op::internal_choice, std::move(operands));
        if (code.kind == ExprKind::interleave) {
            const process::SetId set = timed != nullptr ? tock_set(*timed) : terms_.set({});
            return many(Op::parallel, std::move(operands), payload(set));
        }
        if (timed == nullptr) return many(Op::external_choice, std::move(operands));
        return many(Op::sync_choice, std::move(operands), payload(tock_set(*timed)));
    }
    operands.push_back(process(*code.args[0], frame));
    if (code.kind == ExprKind::hide) {
        const process::SetId set = set_id(*code.args[1], frame);
        return terms_[set].empty() ? operands[0] : make(Op::hide, std::move(operands), payload(set));
    }
    if (code.kind == ExprKind::project) {
        const process::EventSet all = event_set(all_events(), code.span);
        const process::EventSet kept = terms_[set_id(*code.args[1], frame)];
        process::EventSet hidden;
        std::ranges::set_difference(all, kept, std::back_inserter(hidden));
        return make(Op::hide, std::move(operands), payload(terms_.set(std::move(hidden))));
    }
    operands.push_back(process(*code.args[1], frame));
    // The sets of synchronising operators of a timed section have tock in them.
    const auto with_tock = [&](const Code& set) {
        process::EventSet events = terms_[set_id(set, frame)];
        if (timed != nullptr) events.push_back(tock(*timed));
        return terms_.set(std::move(events));
    };
    switch (code.kind) {
        case ExprKind::sequential:
            return make(Op::sequential, std::move(operands));
        case ExprKind::sliding_choice:
            return make(Op::sliding, std::move(operands));
        case ExprKind::interrupt:
            if (timed == nullptr) return make(Op::interrupt, std::move(operands));
            return make(Op::sync_interrupt, std::move(operands), payload(tock_set(*timed)));
        case ExprKind::exception:
            return make(Op::exception, std::move(operands), payload(set_id(*code.args[2], frame)));
        case ExprKind::parallel:
            return make(Op::parallel, std::move(operands), payload(with_tock(*code.args[2])));
        case ExprKind::synchronising_choice:
            return make(Op::sync_choice, std::move(operands), payload(with_tock(*code.args[2])));
        case ExprKind::synchronising_interrupt:
            return make(Op::sync_interrupt, std::move(operands), payload(with_tock(*code.args[2])));
        case ExprKind::alphabetised: {
            process::Term result{Op::alphabetised, 0, std::move(operands), {}};
            result.sets = {with_tock(*code.args[2]), with_tock(*code.args[3])};
            return terms_.make(result);
        }
        default:
            not_supported("this process operator", code.span);
    }
}

TermId Evaluator::process_replicated(const Code& code, Frame& frame) {
    const TimedSection* timed = code.timed;
    std::vector<TermId> operands;
    std::vector<process::SetId> alphabets;
    const auto with_tock = [&](const Code& set, Frame& inside) {
        process::EventSet events = terms_[set_id(set, inside)];
        if (timed != nullptr) events.push_back(tock(*timed));
        return terms_.set(std::move(events));
    };
    const bool interface =
        code.kind == ExprKind::replicated_parallel || code.kind == ExprKind::replicated_synchronising;
    const process::SetId set = interface ? with_tock(*code.args[1], frame) : process::SetId{};
    for_each(code, code.clauses, 0, frame, [&](Frame& inside) {
        if (code.kind == ExprKind::replicated_alphabetised) alphabets.push_back(with_tock(*code.args[1], inside));
        operands.push_back(process(*code.args[0], inside));
    });
    const bool none = operands.empty();
    switch (code.kind) {
        case ExprKind::replicated_internal:
            if (none) fail("|~| over an empty set", code.span);
            return many(Op::internal_choice, std::move(operands));
        case ExprKind::replicated_external:
            if (none) return stop(timed);
            if (timed == nullptr) return many(Op::external_choice, std::move(operands));
            return many(Op::sync_choice, std::move(operands), payload(tock_set(*timed)));
        case ExprKind::replicated_synchronising:
            return none ? stop(timed) : many(Op::sync_choice, std::move(operands), payload(set));
        case ExprKind::replicated_sequential: {
            if (none) return skip(timed);
            TermId result = operands.back();
            for (std::size_t i = operands.size() - 1; i-- > 0;) result = make(Op::sequential, {operands[i], result});
            return result;
        }
        // An empty parallel terminates: SKIP. In a timed section FDR has STOP there (libcspm, Evaluator).
        case ExprKind::replicated_interleave:
            if (none) return timed != nullptr ? stop(timed) : make(Op::skip);
            return many(Op::parallel, std::move(operands),
                        payload(timed != nullptr ? tock_set(*timed) : terms_.set({})));
        case ExprKind::replicated_parallel:
            if (none) return timed != nullptr ? stop(timed) : make(Op::skip);
            return many(Op::parallel, std::move(operands), payload(set));
        default: {
            if (none) return timed != nullptr ? stop(timed) : make(Op::skip);
            process::Term result{Op::alphabetised, 0, std::move(operands), std::move(alphabets)};
            return terms_.make(result);
        }
    }
}

// ---------------------------------------------------------------- renaming and links

// Pairs of events; channels stand for all their events with equal fields.
std::vector<process::EventPair> Evaluator::ties(const Code& code, const std::vector<ClauseCode>& clauses,
                                                Frame& frame) {
    std::vector<process::EventPair> result;
    for_each(code, clauses, 0, frame, [&](Frame& inside) {
        for (const auto& [from_code, to_code] : code.links) {
            const Value from = share(eval(*from_code, inside));
            const Value to = share(eval(*to_code, inside));
            for (const Value more : extensions(from)->items) {
                const process::Event left = event(combine(from, more, from_code->span), from_code->span);
                result.emplace_back(left, event(combine(to, more, to_code->span), to_code->span));
            }
            if (result.size() > max_elements) fail("more than 5000000 pairs of events", code.span);
        }
    });
    return result;
}

TermId Evaluator::process_rename(const Code& code, Frame& frame) {
    const TermId child = process(*code.args[0], frame);
    std::vector<process::EventPair> pairs = ties(code, code.clauses, frame);
    if (pairs.empty()) return child;
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return make(Op::rename, {child}, payload(terms_.renaming(std::move(pairs))));
}

// P [a <-> b] Q: both ends are renamed to one event of their own, shared, and hidden.
TermId Evaluator::link(TermId left, TermId right, const std::vector<process::EventPair>& ties, Span span) {
    process::Renaming from_left;
    process::Renaming from_right;
    process::EventSet shared;
    for (const auto& [a, b] : ties) {
        const process::Event event = events_.intern(events_.name(a) + "<->" + events_.name(b));
        from_left.emplace_back(a, event);
        from_right.emplace_back(b, event);
        shared.push_back(event);
    }
    for (process::Renaming* side : {&from_left, &from_right}) {
        std::ranges::sort(*side);
        const auto twice = std::ranges::adjacent_find(*side, {}, &process::EventPair::first);
        if (twice != side->end()) fail("the event " + events_.name(twice->first) + " is linked twice", span);
    }
    const process::SetId set = terms_.set(std::move(shared));
    const TermId a = make(Op::rename, {left}, payload(terms_.renaming(std::move(from_left))));
    const TermId b = make(Op::rename, {right}, payload(terms_.renaming(std::move(from_right))));
    return make(Op::hide, {make(Op::parallel, {a, b}, payload(set))}, payload(set));
}

TermId Evaluator::process_linked(const Code& code, Frame& frame) {
    if (code.timed != nullptr) fail("linked parallel is not allowed in a timed section", code.span);
    const TermId left = process(*code.args[0], frame);
    const TermId right = process(*code.args[1], frame);
    return link(left, right, ties(code, code.clauses, frame), code.span);
}

TermId Evaluator::process_replicated_linked(const Code& code, Frame& frame) {
    if (code.timed != nullptr) fail("linked parallel is not allowed in a timed section", code.span);
    std::vector<TermId> processes;
    std::vector<std::vector<process::EventPair>> links;
    for_each(code, code.clauses, 0, frame, [&](Frame& inside) {
        links.push_back(ties(code, code.link_clauses, inside));
        processes.push_back(process(*code.args[0], inside));
    });
    if (processes.empty()) fail("replicated linked parallel over an empty sequence", code.span);
    TermId result = processes.back();
    for (std::size_t i = processes.size() - 1; i-- > 0;) result = link(processes[i], result, links[i], code.span);
    return result;
}

}  // namespace robochart::cspm
