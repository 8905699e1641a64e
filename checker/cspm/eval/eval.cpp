// SPDX-License-Identifier: Apache-2.0
// Evaluates expressions to values by need: arguments and let-bound constants are evaluated when they are needed.
#include <algorithm>
#include <limits>
#include <optional>

#include "checker/cspm/eval/evaluator.hpp"
#include "checker/cspm/eval/process_evaluator.hpp"
#include "checker/cspm/types/builtins.hpp"

namespace robochart::cspm {

namespace {

bool is_process_operator(ExprKind kind) {
    return (kind >= ExprKind::prefix && kind <= ExprKind::rename) ||
           (kind >= ExprKind::replicated_external && kind <= ExprKind::replicated_synchronising);
}

}  // namespace

Value Evaluator::eval(const Code& code, Frame& frame) {
    work_.count_step(code.span);
    if (code.constant != nullptr) return code.constant;
    switch (code.kind) {
        case ExprKind::name:
            return eval_name(code, frame);
        case ExprKind::tuple:
            return store_.compound(Kind::tuple, 0, promise_all(code, frame));
        case ExprKind::sequence:
            return store_.compound(Kind::sequence, 0, promise_all(code, frame));
        case ExprKind::set:
            return store_.set(eval_all(code, frame));
        case ExprKind::map:
            return eval_map(code, frame);
        case ExprKind::sequence_range:
        case ExprKind::set_range:
            return eval_range(code, frame);
        case ExprKind::sequence_comprehension:
            return eval_sequence_comprehension(code, frame);
        case ExprKind::set_comprehension:
        case ExprKind::sequence_range_comprehension:
        case ExprKind::set_range_comprehension:
            return eval_collection(code, frame);
        case ExprKind::productions:
        case ExprKind::productions_comprehension:
            return eval_productions(code, frame);
        case ExprKind::dot: {
            Value result = share_value(eval(*code.args[0], frame));
            for (std::size_t i = 1; i < code.args.size(); ++i) {
                result = domains_.append_fields(result, share_value(eval(*code.args[i], frame)), code.span);
            }
            return result;
        }
        case ExprKind::apply:
            return eval_apply(code, frame);
        case ExprKind::lambda:
            return eval_lambda(code, frame);
        case ExprKind::let:
            return eval_let(code, frame);
        case ExprKind::if_then_else:
            return eval(*code.args[eval_boolean(*code.args[0], frame) ? 1 : 2], frame);
        default:
            break;
    }
    if (code.kind == ExprKind::guard && eval_boolean(*code.args[0], frame)) return eval(*code.args[1], frame);
    if (is_process_operator(code.kind)) {
        const process::TermId made = process_evaluator_->process(code, frame);
        return store_.make(Kind::process, static_cast<std::int64_t>(made), {});
    }
    return eval_operator(code, frame);
}

Values Evaluator::eval_all(const Code& code, Frame& frame) {
    Values result;
    result.reserve(code.args.size());
    for (const Code* arg : code.args) result.push_back(share_value(eval(*arg, frame)));
    return result;
}

Values Evaluator::promise_all(const Code& code, Frame& frame) {
    Values result;
    result.reserve(code.args.size());
    for (const Code* arg : code.args) result.push_back(promise_part(*arg, frame));
    return result;
}

Value Evaluator::eval_name(const Code& code, Frame& frame) {
    const auto slot = static_cast<std::size_t>(code.slot);
    switch (code.reference) {
        case Reference::local:
            return evaluate_in_place(frame[slot]);
        case Reference::member:
            return member_value(static_cast<const GroupObject&>(*frame[slot]), code.index, code.span);
        case Reference::global:
            return global_value(code.slot, code.span);
        case Reference::head:
            return domains_.head_value(code.slot);
        case Reference::builtin:
            return builtins_.value(static_cast<Builtin>(code.slot), code.timed);
        case Reference::none:
            break;
    }
    work_.fail("a name without a meaning", code.span);
}

Value Evaluator::evaluate_in_place(Value& value) {
    if (value->kind != Kind::thunk) return value;
    const auto& thunk = static_cast<const Thunk&>(*value);
    if (thunk.result == nullptr) {
        if (thunk.running) work_.fail("a value is defined by itself", thunk.code->span);
        const Running running(thunk.running);
        thunk.result = eval(*thunk.code, thunk.frame);
        thunk.frame.clear();
    }
    value = thunk.result;
    return value;
}

// Returns the argument's value if it is a constant, a variable or a lambda. Otherwise returns a thunk.
Value Evaluator::delay_argument(const Code& code, Frame& frame) {
    if (code.constant != nullptr) return code.constant;
    if (code.kind == ExprKind::name && code.reference == Reference::local)
        return frame[static_cast<std::size_t>(code.slot)];
    if (code.kind == ExprKind::lambda) return eval_lambda(code, frame);
    return store_.thunk(code, frame);
}

// Evaluates a part of a value early. The part may never be needed, so the work is limited. After the first limit,
// nothing further is evaluated early, but the current evaluations continue. After twice as much work, the whole part
// stays unevaluated.
Value Evaluator::promise_part(const Code& code, Frame& frame) {
    constexpr std::uint8_t often = 3;
    if (code.constant != nullptr) return code.constant;
    if (code.kind == ExprKind::name && code.reference == Reference::local)
        return frame[static_cast<std::size_t>(code.slot)];
    if (code.kind == ExprKind::lambda) return eval_lambda(code, frame);
    if (!work_.may_speculate() || code.too_long >= often) return store_.thunk(code, frame);
    const Work::Speculation speculation(work_);
    try {
        return eval(code, frame);
    } catch (const EvaluationError&) {  // the error occurs again when the value is needed
    } catch (const GivenUp&) {
        if (!speculation.is_outermost()) throw;
        ++code.too_long;
    }
    return store_.thunk(code, frame);
}

// Returns the shared object that is equal to a value. Evaluates the values that it captures.
Value Evaluator::share_value(Value value) {
    if (value->shared) return value;
    if (value->kind == Kind::thunk) return share_value(evaluate_in_place(value));
    work_.count_step({});
    if (value->kind == Kind::stream) return by_need_.share_stream(value);
    Values items;
    items.reserve(value->items.size());
    for (const Value item : value->items) items.push_back(share_value(item));
    if (value->kind == Kind::group) {
        const std::size_t members = static_cast<const GroupObject&>(*value).known.size();
        return store_.shared_group(*value->group, std::move(items), members);
    }
    return store_.make(value->kind, value->number, std::move(items), value->function, value->group);
}

bool Evaluator::eval_boolean(const Code& code, Frame& frame) {
    const Value value = eval(code, frame);
    if (value->kind != Kind::boolean) work_.fail("expected a truth value, found " + text_(value), code.span);
    return value->number != 0;
}

std::int64_t Evaluator::eval_number(const Code& code, Frame& frame) {
    const Value value = eval(code, frame);
    if (value->kind != Kind::integer) work_.fail("expected a number, found " + text_(value), code.span);
    return value->number;
}

const GroupObject* Evaluator::open_let(const Code& code, Frame& frame) {
    Values items;
    for (const auto& [from, to] : code.group->unit->captures) items.push_back(frame[static_cast<std::size_t>(from)]);
    const GroupObject* group = store_.group(*code.group, std::move(items), code.group->members.size());
    frame[static_cast<std::size_t>(code.slot)] = group;
    return group;
}

Value Evaluator::eval_let(const Code& code, Frame& frame) {
    open_let(code, frame);
    return eval(*code.args[0], frame);
}

Value Evaluator::eval_lambda(const Code& code, Frame& frame) {
    Values items;
    for (const auto& [from, to] : code.function->clauses[0].unit->captures) {
        items.push_back(frame[static_cast<std::size_t>(from)]);
    }
    return store_.closure(*code.function, std::move(items));
}

Value Evaluator::eval_apply(const Code& code, Frame& frame) {
    const Value function = eval(*code.args[0], frame);
    Values arguments;
    arguments.reserve(code.args.size() - 1);
    const bool builtin = function->kind == Kind::builtin;
    const auto which = builtin ? static_cast<Builtin>(function->number) : Builtin::true_;
    const bool by_need = builtin && takes_by_need(which);
    for (std::size_t i = 1; i < code.args.size(); ++i) {
        const bool second_set = (which == Builtin::inter || which == Builtin::diff) && i == 2;  // see ByNeed
        if (by_need)
            arguments.push_back(promise_part(*code.args[i], frame));
        else if (builtin && !second_set)
            arguments.push_back(share_value(eval(*code.args[i], frame)));
        else
            arguments.push_back(delay_argument(*code.args[i], frame));
    }
    return call(function, std::move(arguments), code.span);
}

// ---------------------------------------------------------------- operators

Value Evaluator::eval_operator(const Code& code, Frame& frame) {
    switch (code.kind) {
        case ExprKind::negate:
        case ExprKind::plus:
        case ExprKind::minus:
        case ExprKind::times:
        case ExprKind::divide:
        case ExprKind::modulus:
            return eval_arithmetic(code, frame);
        case ExprKind::logical_not:
            return store_.boolean(!eval_boolean(*code.args[0], frame));
        case ExprKind::logical_and:
            return store_.boolean(eval_boolean(*code.args[0], frame) && eval_boolean(*code.args[1], frame));
        case ExprKind::logical_or:
            return store_.boolean(eval_boolean(*code.args[0], frame) || eval_boolean(*code.args[1], frame));
        case ExprKind::concat:
            return eval_concat(code, frame);
        case ExprKind::length: {
            const Value items = by_need_.written_out(eval(*code.args[0], frame), code.span);
            return store_.integer(static_cast<std::int64_t>(items->items.size()));
        }
        default:
            return eval_comparison(code, frame);
    }
}

// Evaluates a concatenation. The right operand may stay unevaluated, even if it is finite.
Value Evaluator::eval_concat(const Code& code, Frame& frame) {
    const Value left = eval(*code.args[0], frame);
    if (left->kind != Kind::sequence && !is_stream(left))
        work_.fail("expected a sequence, found " + text_(left), code.span);
    if (is_infinite(left)) return left;
    if (left->kind == Kind::sequence && left->items.empty()) return eval(*code.args[1], frame);
    return by_need_.append(left, promise_part(*code.args[1], frame));
}

namespace {

// Divides as FDR does: the quotient is rounded towards minus infinity, and the remainder has the divisor's sign.
std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
    const std::int64_t quotient = a / b;
    return quotient - static_cast<std::int64_t>(a % b != 0 && (a < 0) != (b < 0));
}

std::int64_t floor_modulus(std::int64_t a, std::int64_t b) {
    const std::int64_t rest = a % b;
    return rest + (rest != 0 && (rest < 0) != (b < 0) ? b : 0);
}

}  // namespace

Value Evaluator::eval_arithmetic(const Code& code, Frame& frame) {
    const std::int64_t a = eval_number(*code.args[0], frame);
    const std::int64_t b = code.args.size() > 1 ? eval_number(*code.args[1], frame) : 0;
    std::int64_t result = 0;
    bool overflow = false;
    switch (code.kind) {
        case ExprKind::negate:
            overflow = __builtin_sub_overflow(std::int64_t{0}, a, &result);
            break;
        case ExprKind::plus:
            overflow = __builtin_add_overflow(a, b, &result);
            break;
        case ExprKind::minus:
            overflow = __builtin_sub_overflow(a, b, &result);
            break;
        case ExprKind::times:
            overflow = __builtin_mul_overflow(a, b, &result);
            break;
        default:
            if (b == 0) work_.fail("division by zero", code.span);
            overflow = a == std::numeric_limits<std::int64_t>::min() && b == -1;
            if (!overflow) result = code.kind == ExprKind::divide ? floor_divide(a, b) : floor_modulus(a, b);
            break;
    }
    if (overflow) work_.fail("the number does not fit in 64 bits", code.span);
    return store_.integer(result);
}

Value Evaluator::eval_comparison(const Code& code, Frame& frame) {
    const Value a = eval(*code.args[0], frame);
    const Value b = eval(*code.args[1], frame);
    switch (code.kind) {
        case ExprKind::equal:
            return store_.boolean(by_need_.are_equal(a, b, code.span));
        case ExprKind::not_equal:
            return store_.boolean(!by_need_.are_equal(a, b, code.span));
        case ExprKind::less_equal:
            return store_.boolean(by_need_.is_less_or_equal(a, b, code.span));
        case ExprKind::greater_equal:
            return store_.boolean(by_need_.is_less_or_equal(b, a, code.span));
        case ExprKind::less:
            return store_.boolean(by_need_.is_less(a, b, code.span));
        case ExprKind::greater:
            return store_.boolean(by_need_.is_less(b, a, code.span));
        default:
            work_.not_supported("this expression", code.span);
    }
}

// ---------------------------------------------------------------- collections

Value Evaluator::eval_map(const Code& code, Frame& frame) {
    Values result = by_need_.map_items(builtins_.value(Builtin::empty_map, nullptr), code.span);
    Value map = store_.make(Kind::map, 0, std::move(result));
    for (std::size_t i = 0; i + 1 < code.args.size(); i += 2) {
        Values arguments{map, share_value(eval(*code.args[i], frame)), promise_part(*code.args[i + 1], frame)};
        map = by_need_.map_builtin(Builtin::map_update, arguments, code.span);
    }
    return map;
}

Value Evaluator::eval_range(const Code& code, Frame& frame) {
    const bool set = code.kind == ExprKind::set_range || code.kind == ExprKind::set_range_comprehension;
    const std::int64_t first = eval_number(*code.args[0], frame);
    if (code.args[1] == nullptr) return store_.make(set ? Kind::integers_from : Kind::sequence_from, first, {});
    const std::int64_t last = eval_number(*code.args[1], frame);
    Values items;
    if (last >= first) {
        const auto count = static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(first);
        if (count >= max_elements) work_.fail("the range has more than 5000000 elements", code.span);
        items.reserve(count + 1);
        for (std::uint64_t i = 0; i <= count; ++i) {
            items.push_back(store_.integer(first + static_cast<std::int64_t>(i)));
        }
    }
    return set ? store_.sorted_set(std::move(items)) : store_.sequence(std::move(items));
}

// Calls `use` for every way to satisfy the clauses, in order.
void Evaluator::for_each(const Code& code, const std::vector<ClauseCode>& clauses, std::size_t from, Frame& frame,
                         const Use& use) {
    if (from == clauses.size()) return use(frame);
    const ClauseCode& clause = clauses[from];
    if (!clause.generator) {
        if (eval_boolean(*clause.value, frame)) for_each(code, clauses, from + 1, frame, use);
        return;
    }
    generate(code, clauses, from, eval(*clause.value, frame), frame, use);
}

void Evaluator::generate(const Code& code, const std::vector<ClauseCode>& clauses, std::size_t from, Value source,
                         Frame& frame, const Use& use) {
    const ClauseCode& clause = clauses[from];
    if (is_infinite(source))
        work_.not_supported("a generator over an infinite sequence, other than the first of a sequence comprehension,",
                            clause.value->span);
    if (is_stream(source)) source = by_need_.written_out(source, clause.value->span);
    if (source->kind != Kind::sequence) source = domains_.explicit_set(share_value(source), clause.value->span);
    const Values items = source->items;
    for (Value item : items) {
        work_.count_step(code.span);
        if (match_pattern(clause.pattern, item, frame)) for_each(code, clauses, from + 1, frame, use);
    }
}

Value Evaluator::eval_collection(const Code& code, Frame& frame) {
    const bool ranges =
        code.kind == ExprKind::sequence_range_comprehension || code.kind == ExprKind::set_range_comprehension;
    const bool set = code.kind == ExprKind::set_comprehension || code.kind == ExprKind::set_range_comprehension;
    Values items;
    Value united = store_.set({});
    const Use collect_elements = [&](Frame& inside) {
        if (ranges && set) {
            const Value range = eval_range(code, inside);
            if (range->kind == Kind::set)
                items.insert(items.end(), range->items.begin(), range->items.end());
            else
                united = domains_.set_union(united, range, code.span);
        } else if (ranges) {
            const Values more = by_need_.sequence(eval_range(code, inside), code.span);
            items.insert(items.end(), more.begin(), more.end());
        } else {
            for (const Code* arg : code.args) items.push_back(share_value(eval(*arg, inside)));
        }
        if (items.size() > max_elements) work_.fail("more than 5000000 elements", code.span);
    };
    for_each(code, code.clauses, 0, frame, collect_elements);
    if (ranges && set) return domains_.set_union(united, store_.set(std::move(items)), code.span);
    return set ? store_.set(std::move(items)) : store_.sequence(std::move(items));
}

// Evaluates a comprehension. Evaluates its elements early until an evaluation fails, and leaves the rest unevaluated.
// Leaves all elements unevaluated if the sequence is infinite.
Value Evaluator::eval_sequence_comprehension(const Code& code, Frame& frame) {
    std::size_t first = 0;
    for (; first < code.clauses.size() && !code.clauses[first].generator; ++first)
        if (!eval_boolean(*code.clauses[first].value, frame)) return store_.sequence({});
    if (first == code.clauses.size()) return store_.compound(Kind::sequence, 0, promise_all(code, frame));
    const ClauseCode& clause = code.clauses[first];
    Value source = eval(*clause.value, frame);
    if (is_stream(source)) return by_need_.make_stream(store_.sequence({}), source, {&code, first}, frame);
    if (source->kind != Kind::sequence) source = domains_.explicit_set(share_value(source), clause.value->span);
    const Values all = source->items;
    Values items;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::size_t before = items.size();
        try {
            work_.count_step(code.span);
            Value item = all[i];
            if (!match_pattern(clause.pattern, item, frame)) continue;
            for_each(code, code.clauses, first + 1, frame, [&](Frame& inside) {
                for (const Code* arg : code.args) items.push_back(promise_part(*arg, inside));
            });
        } catch (const EvaluationError&) {
            if (work_.used_up()) throw;
            items.resize(before);
            const auto rest = all.begin() + static_cast<std::ptrdiff_t>(i);
            return by_need_.make_stream(store_.compound(Kind::sequence, 0, std::move(items)),
                                        store_.compound(Kind::sequence, 0, {rest, all.end()}), {&code, first}, frame);
        }
        if (items.size() > max_elements) work_.fail("more than 5000000 elements", code.span);
    }
    return store_.compound(Kind::sequence, 0, std::move(items));
}

// Returns the elements that the clauses from index `clause` on generate.
Value Evaluator::comprehension_from(const Code& code, std::size_t clause, Frame& frame) {
    if (clause == code.clauses.size()) return store_.compound(Kind::sequence, 0, promise_all(code, frame));
    const ClauseCode& next = code.clauses[clause];
    if (!next.generator)
        return eval_boolean(*next.value, frame) ? comprehension_from(code, clause + 1, frame) : store_.sequence({});
    Value source = eval(*next.value, frame);
    if (source->kind != Kind::sequence && !is_stream(source))
        source = store_.sequence(domains_.elements(share_value(source), next.value->span));
    return by_need_.make_stream(store_.sequence({}), source, {&code, clause}, frame);
}

Value Evaluator::eval_productions(const Code& code, Frame& frame) {
    Values items;
    for_each(code, code.clauses, 0, frame, [&](Frame& inside) {
        for (const Code* arg : code.args) {
            const Values& more = domains_.productions(share_value(eval(*arg, inside)))->items;
            if (items.empty())
                items = more;
            else
                items.insert(items.end(), more.begin(), more.end());
        }
    });
    return store_.set(std::move(items));
}

}  // namespace robochart::cspm
