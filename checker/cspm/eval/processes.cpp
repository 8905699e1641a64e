// SPDX-License-Identifier: Apache-2.0
// Converts process expressions to terms. In a timed section choice, interrupt and the parallel operators synchronise on
// tock, and STOP, SKIP and prefixes let time pass (semantics 3.10).
#include <algorithm>

#include "base/diagnostics/containers.hpp"
#include "checker/cspm/eval/process_evaluator.hpp"

namespace robochart::cspm {

using process::Op;
using process::TermId;

std::int64_t ProcessEvaluator::event_duration(TimedSection& timed, Value event, Span span) {
    if (timed.duration == nullptr) return 1;
    if (timed.duration_value == nullptr) {
        Frame frame(static_cast<std::size_t>(timed.unit->size), nullptr);
        timed.duration_value = values_.share_value(values_.eval(*timed.duration, frame));
    }
    const Value result = values_.call(timed.duration_value, {event}, span);
    if (result->kind != Kind::integer || result->number < 0) {
        work_.fail("the duration of " + text_(event) + " is " + text_(result) + ", not a number from 0", span);
    }
    return result->number;
}

process::SetId ProcessEvaluator::set_id(const Code& code, Frame& frame) {
    const Value set = values_.share_value(values_.eval(code, frame));
    if (!is_set(set)) work_.fail("expected a set of events, found " + text_(set), code.span);
    return terms_.intern_set(domains_.event_set(set, code.span));
}

// ---------------------------------------------------------------- calls

TermId ProcessEvaluator::process(const Code& code, Frame& frame) {
    work_.count_step(code.span);
    switch (code.kind) {
        case ExprKind::name:
            return process_name(code, frame);
        case ExprKind::apply:
            return process_apply(code, frame);
        case ExprKind::if_then_else:
            return process(*code.args[values_.eval_boolean(*code.args[0], frame) ? 1 : 2], frame);
        case ExprKind::let:
            values_.open_let(code, frame);
            return process(*code.args[0], frame);
        case ExprKind::prefix:
            return process_prefix(code, frame);
        case ExprKind::guard:
            return values_.eval_boolean(*code.args[0], frame) ? process(*code.args[1], frame)
                                                              : processes_.make_stop(code.timed);
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
    return processes_.term_of(values_.eval(code, frame), code.span);
}

// Evaluates a name. A constant that denotes a process becomes a term with only its name. If its definition were
// evaluated here, recursive processes would not end.
TermId ProcessEvaluator::process_name(const Code& code, Frame& frame) {
    if (code.reference == Reference::member) {
        const auto& group = static_cast<const GroupObject&>(*frame[static_cast<std::size_t>(code.slot)]);
        const Member& member = group.group->members[static_cast<std::size_t>(code.index)];
        if (member.function.groups.empty() && member.component_of < 0) {
            const Value environment = values_.share_value(&group);
            return processes_.make_call(store_.make(Kind::function, 0, {environment}, &member.function), {});
        }
    }
    if (code.reference == Reference::global) {
        const Global& global = program_.globals[static_cast<std::size_t>(code.slot)];
        if (global.kind == GlobalKind::function && global.function.groups.empty()) {
            return processes_.make_call(store_.make(Kind::function, 0, {}, &global.function), {});
        }
    }
    return processes_.term_of(values_.eval_name(code, frame), code.span);
}

TermId ProcessEvaluator::process_apply(const Code& code, Frame& frame) {
    const Value function = values_.share_value(values_.eval(*code.args[0], frame));
    if (function->kind != Kind::function) return processes_.term_of(values_.eval_apply(code, frame), code.span);
    const Function& definition = *function->function;
    Values arguments;
    try {
        for (std::size_t i = 1; i < code.args.size(); ++i)
            arguments.push_back(values_.share_value(values_.eval(*code.args[i], frame)));
    } catch (const EvaluationError&) {
        // A process call needs the values of all its arguments for its term. Another function may ignore the argument
        // that failed.
        if (shape_.makes_process(definition)) throw;
        return processes_.term_of(values_.eval_apply(code, frame), code.span);
    }
    std::size_t total = 0;
    for (const std::size_t group : definition.groups) total += group;
    const std::size_t given = function->items.size() - definition.environment;
    const bool last =
        !definition.groups.empty() && given + arguments.size() == total && definition.groups.back() == arguments.size();
    if (!last) return processes_.term_of(values_.call(function, std::move(arguments), code.span), code.span);
    return processes_.make_call(function, arguments);
}

// ---------------------------------------------------------------- operators

// Collects the operands of a chain P op Q op R, left to right.
void ProcessEvaluator::collect_operands(const Code& code, ExprKind kind, Frame& frame, std::vector<TermId>& out) {
    std::vector<const Code*> right;
    const Code* left = &code;
    while (left->kind == kind) {
        right.push_back(left->args[1]);
        left = left->args[0];
    }
    out.push_back(process(*left, frame));
    for (auto operand = right.rbegin(); operand != right.rend(); ++operand) out.push_back(process(**operand, frame));
}

TermId ProcessEvaluator::process_operator(const Code& code, Frame& frame) {
    const TimedSection* timed = code.timed;
    std::vector<TermId> operands;
    if (code.kind == ExprKind::external_choice || code.kind == ExprKind::internal_choice ||
        code.kind == ExprKind::interleave) {
        collect_operands(code, code.kind, frame, operands);
        if (code.kind == ExprKind::internal_choice)
            return processes_.make_operator(Op::internal_choice, std::move(operands));
        if (code.kind == ExprKind::interleave) {
            const process::SetId set = timed != nullptr ? processes_.tock_set(*timed) : terms_.intern_set({});
            return processes_.make_operator(Op::parallel, std::move(operands), payload(set));
        }
        if (timed == nullptr) return processes_.make_operator(Op::external_choice, std::move(operands));
        return processes_.make_operator(Op::sync_choice, std::move(operands), payload(processes_.tock_set(*timed)));
    }
    operands.push_back(process(*code.args[0], frame));
    if (code.kind == ExprKind::hide) {
        const process::SetId set = set_id(*code.args[1], frame);
        return terms_[set].empty() ? operands[0] : processes_.make_term(Op::hide, std::move(operands), payload(set));
    }
    if (code.kind == ExprKind::project) {
        const process::EventSet all = domains_.event_set(domains_.all_events(), code.span);
        const process::EventSet remaining = terms_[set_id(*code.args[1], frame)];
        process::EventSet hidden;
        std::ranges::set_difference(all, remaining, std::back_inserter(hidden));
        return processes_.make_term(Op::hide, std::move(operands), payload(terms_.intern_set(std::move(hidden))));
    }
    operands.push_back(process(*code.args[1], frame));
    // In a timed section, the event sets of synchronising operators also contain tock.
    const auto with_tock = [&](const Code& set) {
        process::EventSet events = terms_[set_id(set, frame)];
        if (timed != nullptr) events.push_back(processes_.tock_event(*timed));
        return terms_.intern_set(std::move(events));
    };
    switch (code.kind) {
        case ExprKind::sequential:
            return processes_.make_term(Op::sequential, std::move(operands));
        case ExprKind::sliding_choice:
            return processes_.make_term(Op::sliding, std::move(operands));
        case ExprKind::interrupt:
            if (timed == nullptr) return processes_.make_term(Op::interrupt, std::move(operands));
            return processes_.make_term(Op::sync_interrupt, std::move(operands), payload(processes_.tock_set(*timed)));
        case ExprKind::exception:
            return processes_.make_term(Op::exception, std::move(operands), payload(set_id(*code.args[2], frame)));
        case ExprKind::parallel:
            return processes_.make_term(Op::parallel, std::move(operands), payload(with_tock(*code.args[2])));
        case ExprKind::synchronising_choice:
            return processes_.make_term(Op::sync_choice, std::move(operands), payload(with_tock(*code.args[2])));
        case ExprKind::synchronising_interrupt:
            return processes_.make_term(Op::sync_interrupt, std::move(operands), payload(with_tock(*code.args[2])));
        case ExprKind::alphabetised: {
            process::Term result{Op::alphabetised, 0, std::move(operands), {}};
            result.sets = {with_tock(*code.args[2]), with_tock(*code.args[3])};
            return terms_.intern_term(result);
        }
        default:
            work_.not_supported("this process operator", code.span);
    }
}

TermId ProcessEvaluator::process_replicated(const Code& code, Frame& frame) {
    const TimedSection* timed = code.timed;
    std::vector<TermId> operands;
    std::vector<process::SetId> alphabets;
    const auto with_tock = [&](const Code& set, Frame& inside) {
        process::EventSet events = terms_[set_id(set, inside)];
        if (timed != nullptr) events.push_back(processes_.tock_event(*timed));
        return terms_.intern_set(std::move(events));
    };
    const bool interface =
        code.kind == ExprKind::replicated_parallel || code.kind == ExprKind::replicated_synchronising;
    const process::SetId set = interface ? with_tock(*code.args[1], frame) : process::SetId{};
    values_.for_each(code, code.clauses, 0, frame, [&](Frame& inside) {
        if (code.kind == ExprKind::replicated_alphabetised) alphabets.push_back(with_tock(*code.args[1], inside));
        operands.push_back(process(*code.args[0], inside));
    });
    const bool none = operands.empty();
    switch (code.kind) {
        case ExprKind::replicated_internal:
            if (none) work_.fail("|~| over an empty set", code.span);
            return processes_.make_operator(Op::internal_choice, std::move(operands));
        case ExprKind::replicated_external:
            if (none) return processes_.make_stop(timed);
            if (timed == nullptr) return processes_.make_operator(Op::external_choice, std::move(operands));
            return processes_.make_operator(Op::sync_choice, std::move(operands), payload(processes_.tock_set(*timed)));
        case ExprKind::replicated_synchronising:
            return none ? processes_.make_stop(timed)
                        : processes_.make_operator(Op::sync_choice, std::move(operands), payload(set));
        case ExprKind::replicated_sequential: {
            if (none) return processes_.make_skip(timed);
            TermId result = operands.back();
            for (std::size_t i = operands.size() - 1; i-- > 0;)
                result = processes_.make_term(Op::sequential, {operands[i], result});
            return result;
        }
        // With no operands, the result is SKIP, or STOP in a timed section, as in FDR (libcspm, Evaluator).
        case ExprKind::replicated_interleave:
            if (none) return timed != nullptr ? processes_.make_stop(timed) : processes_.make_term(Op::skip);
            return processes_.make_operator(
                Op::parallel, std::move(operands),
                payload(timed != nullptr ? processes_.tock_set(*timed) : terms_.intern_set({})));
        case ExprKind::replicated_parallel:
            if (none) return timed != nullptr ? processes_.make_stop(timed) : processes_.make_term(Op::skip);
            return processes_.make_operator(Op::parallel, std::move(operands), payload(set));
        default: {
            if (none) return timed != nullptr ? processes_.make_stop(timed) : processes_.make_term(Op::skip);
            process::Term result{Op::alphabetised, 0, std::move(operands), std::move(alphabets)};
            return terms_.intern_term(result);
        }
    }
}

// ---------------------------------------------------------------- renaming and links

// Returns pairs of linked events. A channel represents all its events. The two events of a pair have equal fields.
std::vector<process::EventPair> ProcessEvaluator::linked_events(const Code& code,
                                                                const std::vector<ClauseCode>& clauses, Frame& frame) {
    std::vector<process::EventPair> result;
    values_.for_each(code, clauses, 0, frame, [&](Frame& inside) {
        for (const auto& [from_code, to_code] : code.links) {
            const Value from = values_.share_value(values_.eval(*from_code, inside));
            const Value to = values_.share_value(values_.eval(*to_code, inside));
            for (const Value more : domains_.extensions(from)->items) {
                const process::Event left =
                    domains_.event_of(domains_.append_fields(from, more, from_code->span), from_code->span);
                result.emplace_back(left,
                                    domains_.event_of(domains_.append_fields(to, more, to_code->span), to_code->span));
            }
            if (result.size() > max_elements) work_.fail("more than 5000000 pairs of events", code.span);
        }
    });
    return result;
}

TermId ProcessEvaluator::process_rename(const Code& code, Frame& frame) {
    const TermId child = process(*code.args[0], frame);
    std::vector<process::EventPair> pairs = linked_events(code, code.clauses, frame);
    if (pairs.empty()) return child;
    diagnostics::sort_unique(pairs);
    return processes_.make_term(Op::rename, {child}, payload(terms_.intern_renaming(std::move(pairs))));
}

// Evaluates P [a <-> b] Q: both ends are renamed to one new event, on which P and Q synchronise and which is then
// hidden.
TermId ProcessEvaluator::process_linked(const Code& code, Frame& frame) {
    if (code.timed != nullptr) work_.fail("linked parallel is not allowed in a timed section", code.span);
    const TermId left = process(*code.args[0], frame);
    const TermId right = process(*code.args[1], frame);
    return processes_.make_linked(left, right, linked_events(code, code.clauses, frame), code.span);
}

TermId ProcessEvaluator::process_replicated_linked(const Code& code, Frame& frame) {
    if (code.timed != nullptr) work_.fail("linked parallel is not allowed in a timed section", code.span);
    std::vector<TermId> processes;
    std::vector<std::vector<process::EventPair>> links;
    values_.for_each(code, code.clauses, 0, frame, [&](Frame& inside) {
        links.push_back(linked_events(code, code.link_clauses, inside));
        processes.push_back(process(*code.args[0], inside));
    });
    if (processes.empty()) work_.fail("replicated linked parallel over an empty sequence", code.span);
    TermId result = processes.back();
    for (std::size_t i = processes.size() - 1; i-- > 0;)
        result = processes_.make_linked(processes[i], result, links[i], code.span);
    return result;
}

}  // namespace robochart::cspm
