// SPDX-License-Identifier: Apache-2.0
// Unifies dotted types. Applies heads to their arguments and makes two lists of parts equal: [A => B, A, C] is the same
// type as [B, C]. FDR's rules of the longest and the shortest match decide how many parts a head takes.
#include <utility>

#include "checker/cspm/types/unify.hpp"

namespace robochart::cspm::types {

// Returns the result type of a dotable that has received all its arguments.
TypeId Unifier::result_type(TypeId type) {
    Parts ignored;
    return store_.split(type, ignored);
}

// Converts (A.B) => C to A => (B => C).
TypeId Unifier::one_by_one(TypeId dotable) {
    const TypeId given = store_.argument(dotable, 0);
    return has_kind(given, TypeKind::dot) ? store_.dotable_type(store_.dot_parts(given), 0, store_.argument(dotable, 1))
                                          : dotable;
}

TypeId Unifier::evaluate_dots(TypeId type) {
    const TypeStore::Depth guard(store_);
    type = store_.head(type);
    if (store_.node(type).plain) return type;
    const TypeKind kind = store_.node(type).kind;
    if (kind == TypeKind::dot) return store_.dot_type(evaluate(store_.dot_parts(type), Match::longest));
    const bool inside = kind == TypeKind::set || kind == TypeKind::sequence || kind == TypeKind::map ||
                        kind == TypeKind::tuple || kind == TypeKind::function;
    if (!inside) return type;
    const Parts before = store_.arguments(type);
    Parts after;
    for (const TypeId argument : before) after.push_back(evaluate_dots(argument));
    return before == after ? type : store_.make_type(kind, after);
}

namespace {

// Replaces the first two parts by one type.
std::vector<TypeId> replace_first_two(TypeId first, const std::vector<TypeId>& parts) {
    std::vector<TypeId> result{first};
    result.insert(result.end(), parts.begin() + 2, parts.end());
    return result;
}

std::vector<TypeId> without_first(const std::vector<TypeId>& parts) {
    return {parts.begin() + 1, parts.end()};
}

void append(std::vector<TypeId>& to, const std::vector<TypeId>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

Unifier::Parts Unifier::evaluate(Parts parts, Match match) {
    const TypeStore::Depth guard(store_);
    if (parts.size() <= 1) return parts;
    TypeId first = store_.head(parts[0]);
    const TypeKind kind = store_.node(first).kind;
    if (kind == TypeKind::dotable) first = one_by_one(first);
    if (kind == TypeKind::dot) {
        Parts spread = store_.dot_parts(first);
        append(spread, without_first(parts));
        return evaluate(std::move(spread), match);
    }
    if (kind == TypeKind::dotable) {
        const TypeId argument = store_.argument(first, 0);
        const TypeId yielded = store_.argument(first, 1);
        const TypeId next = store_.head(parts[1]);
        const TypeKind given = store_.node(next).kind;
        if (given == TypeKind::variable && parts.size() == 2) {
            Parts all;
            const TypeId end = store_.split(first, all);
            if (match == Match::longest) {
                (void)unify(next, store_.dot_type(all));
                return {end};
            }
            (void)unify(all.front(), next);
            return {store_.dotable_type(all, 1, end)};
        }
        if (given == TypeKind::extendable) {
            (void)unify(argument, store_.argument(next, 0));
            return evaluate(replace_first_two(store_.extendable_type(yielded, store_.argument(next, 1)), parts), match);
        }
        if (given == TypeKind::dotable && !has_kind(argument, TypeKind::dotable)) {
            Parts needed;
            (void)unify(argument, store_.split(next, needed));
            return evaluate(replace_first_two(store_.dotable_type(needed, 0, yielded), parts), match);
        }
        (void)unify(argument, next);
        return evaluate(replace_first_two(yielded, parts), match);
    }
    if (kind == TypeKind::extendable) {
        const TypeId end = store_.argument(first, 0);
        const TypeId variable = store_.argument(first, 1);
        if (match == Match::longest) {
            const Parts rest = evaluate(without_first(parts), match);
            set_arguments(variable, store_.dotable_type(rest, 0, store_.atom(TypeKind::complete)));
            return {end};
        }
        set_arguments(variable, store_.dotable_type(parts[1], store_.atom(TypeKind::complete)));
        return evaluate(replace_first_two(end, parts), match);
    }
    Parts result{first};
    append(result, evaluate(without_first(parts), match));
    return result;
}

// Makes both lists equal and returns the common parts. `a` is the expected list, `b` the actual list.
Unifier::Parts Unifier::combine(Parts a, Parts b) {
    const TypeStore::Depth guard(store_);
    if (a.empty() && b.empty()) return {};
    if (a.empty() || b.empty()) mismatch();
    for (Parts* side : {&a, &b}) {
        if (!has_kind(side->front(), TypeKind::dot)) continue;
        Parts spread = store_.dot_parts(side->front());
        append(spread, without_first(*side));
        *side = std::move(spread);
    }
    if (a.size() == 1 || b.size() == 1) return {unify(store_.dot_type(a), store_.dot_type(b))};
    if (has_kind(a.front(), TypeKind::dotable)) return take_left(std::move(a), b);
    if (has_kind(b.front(), TypeKind::dotable)) return take_right(a, std::move(b));
    Parts result{unify(a.front(), b.front())};
    append(result, combine(without_first(a), without_first(b)));
    return result;
}

// Lets the head of `a` take the parts after it as arguments.
Unifier::Parts Unifier::take_left(Parts a, const Parts& b) {
    const TypeId first = one_by_one(store_.head(a[0]));
    const TypeId next = store_.head(a[1]);
    const TypeId argument = store_.argument(first, 0);
    const TypeId yielded = store_.argument(first, 1);
    const TypeKind given = store_.node(next).kind;
    if (given == TypeKind::variable && a.size() == 2 && !has_kind(argument, TypeKind::dotable)) {
        // The variable represents the arguments that the head of `a` needs, and the parts of `b` after the result.
        Parts all;
        const TypeId end = store_.split(first, all);
        Parts rest = evaluate(b, Match::longest);
        rest.front() = unify(end, rest.front());
        append(all, without_first(rest));
        (void)combine(all, {next});
        return rest;
    }
    if (given == TypeKind::dotable && !has_kind(argument, TypeKind::dotable)) {
        Parts needed;
        (void)unify(argument, store_.split(next, needed));
        return combine(replace_first_two(store_.dotable_type(needed, 0, yielded), a), b);
    }
    (void)unify(argument, next);
    return combine(replace_first_two(yielded, a), b);
}

// Lets the head of `b` take the parts after it as arguments.
Unifier::Parts Unifier::take_right(const Parts& a, Parts b) {
    const TypeId first = one_by_one(store_.head(b[0]));
    const TypeId next = store_.head(b[1]);
    const TypeId argument = store_.argument(first, 0);
    const TypeId yielded = store_.argument(first, 1);
    const TypeKind given = store_.node(next).kind;
    if (given == TypeKind::variable && b.size() == 2 && !has_kind(argument, TypeKind::dotable)) {
        Parts all;
        const TypeId end = store_.split(first, all);
        Parts rest = evaluate(a, Match::longest);
        rest.front() = unify(rest.front(), end);
        append(all, without_first(rest));
        (void)combine({next}, all);
        return rest;
    }
    if (given == TypeKind::dotable && !has_kind(argument, TypeKind::dotable)) {
        Parts needed;
        (void)unify(store_.split(next, needed), argument);
        return combine(a, replace_first_two(store_.dotable_type(needed, 0, yielded), b));
    }
    (void)unify(next, argument);
    return combine(a, replace_first_two(yielded, b));
}

}  // namespace robochart::cspm::types
