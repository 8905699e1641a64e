// Declares conversions between types, pairs, functions and relations as sets of pairs, and the functions of the toolkit
// libraries. All work on values of fixed size. A result outside a function's precondition is a default-constructed
// value. Delivered with the generated code. Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_TOOLKIT_HPP
#define ROBOCHART_TOOLKIT_HPP

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "robochart/composed.hpp"
#include "robochart/matrix.hpp"
#include "robochart/runtime.hpp"

namespace robochart {

/// Returns the capacity of a set: the number of possible elements, up to a bound.
constexpr std::size_t places(std::size_t values) noexcept {
    return values < 1024 ? values : 1024;
}
constexpr std::size_t power(std::size_t base, std::size_t exponent) noexcept {
    std::size_t result = 1;
    for (std::size_t i = 0; i < exponent && result < 1024; ++i) result *= base;
    return places(result);
}
/// Returns the number of sequences with at most `longest` items.
constexpr std::size_t sequences(std::size_t items, std::size_t longest) noexcept {
    std::size_t result = 1;
    for (std::size_t i = 0; i < longest && result < 1024; ++i) result = 1 + items * result;
    return places(result);
}

/// Returns the capacity of a set: all `values` over finite carriers, and `deployed` elements on the robot.
template <class Types>
constexpr std::size_t set_places(std::size_t values, std::size_t deployed) noexcept {
    return HasCarriers<Types>::value ? places(values) : deployed;
}

/// Where a pair has padding: 0 for no padding, 1 at the end, 2 between the parts.
template <class A, class B>
inline constexpr int pair_shape = alignof(A) == alignof(B)  ? 0
                                  : alignof(A) > alignof(B) ? 1
                                                            : 2;

template <class A, class B, int shape = pair_shape<A, B>>
struct Pair {
    A item_1{};
    B item_2{};
    [[nodiscard]] static constexpr Pair make(A a, B b) noexcept {
        Pair result{};
        result.item_1 = a;
        result.item_2 = b;
        return result;
    }
};
template <class A, class B>
struct Pair<A, B, 1> {
    A item_1{};
    B item_2{};
    std::uint8_t filler[alignof(A) - sizeof(B) % alignof(A)]{};
    [[nodiscard]] static constexpr Pair make(A a, B b) noexcept {
        Pair result{};
        result.item_1 = a;
        result.item_2 = b;
        return result;
    }
};
template <class A, class B>
struct Pair<A, B, 2> {
    A item_1{};
    std::uint8_t filler[alignof(B) - sizeof(A) % alignof(B)]{};
    B item_2{};
    [[nodiscard]] static constexpr Pair make(A a, B b) noexcept {
        Pair result{};
        result.item_1 = a;
        result.item_2 = b;
        return result;
    }
};
template <class A, class B, int shape>
constexpr bool operator==(const Pair<A, B, shape>& a, const Pair<A, B, shape>& b) noexcept {
    return a.item_1 == b.item_1 && a.item_2 == b.item_2;
}
template <class A, class B, int shape>
constexpr bool operator!=(const Pair<A, B, shape>& a, const Pair<A, B, shape>& b) noexcept {
    return !(a == b);
}
template <class A, class B, int shape>
constexpr bool operator<(const Pair<A, B, shape>& a, const Pair<A, B, shape>& b) noexcept {
    return a.item_1 == b.item_1 ? a.item_2 < b.item_2 : a.item_1 < b.item_1;
}

template <class A, class B, int shape>
struct HoldsLists<Pair<A, B, shape>> : std::bool_constant<HoldsLists<A>::value || HoldsLists<B>::value> {
    static constexpr bool overflowed(const Pair<A, B, shape>& pair) noexcept {
        return robochart::overflowed(pair.item_1) || robochart::overflowed(pair.item_2);
    }
    static constexpr bool drop(Pair<A, B, shape>& pair) noexcept {
        const bool dropped = robochart::drop_overflow(pair.item_1);
        return robochart::drop_overflow(pair.item_2) || dropped;
    }
};

namespace detail {

template <class T>
struct IsSequence : std::false_type {};
template <class T, std::size_t n>
struct IsSequence<Sequence<T, n>> : std::true_type {};
template <class T>
struct IsSet : std::false_type {};
template <class T, std::size_t n>
struct IsSet<Set<T, n>> : std::true_type {};
template <class T, class = void>
struct IsPair : std::false_type {};
template <class T>
struct IsPair<T, std::void_t<decltype(T{}.item_1), decltype(T{}.item_2)>> : std::true_type {};

}  // namespace detail

/// Passes an overflow on: a list that is computed from one that has overflowed has overflowed, too. Generated code
/// gives functions only lists that fit, so this is for lists between two functions of this header.
template <class Result, class From>
constexpr void inherit_overflow(Result& result, const From& from) noexcept {
    if (overflowed(from)) result.mark_overflow();
}

/// Returns the value converted to another type: numbers to its unit, sequences to functions from 1.
template <class To, class From>
constexpr To convert(const From& from) noexcept {
    if constexpr (std::is_same_v<To, From>) {
        return from;
    } else if constexpr (detail::IsSequence<From>::value && detail::IsSet<To>::value) {
        To result;
        std::int64_t place = 0;
        using Member = typename To::value_type;
        using Place = decltype(Member{}.item_1);
        using Item = decltype(Member{}.item_2);
        for (const auto& item : from) result.insert(Member::make(Place(++place), convert<Item>(item)));
        inherit_overflow(result, from);
        return result;
    } else if constexpr (detail::IsSequence<From>::value) {
        To result;
        for (const auto& item : from) result.append(convert<typename To::value_type>(item));
        inherit_overflow(result, from);
        return result;
    } else if constexpr (detail::IsSet<From>::value) {
        To result;
        for (const auto& item : from) result.insert(convert<typename To::value_type>(item));
        inherit_overflow(result, from);
        return result;
    } else if constexpr (is_block<From>) {
        To result;
        for (std::size_t i = 0; i < From::rows * From::columns; ++i)
            result.entry_[i] = convert<typename To::value_type>(from.entry_[i]);
        return result;
    } else if constexpr (detail::IsPair<From>::value) {
        return To::make(convert<decltype(To{}.item_1)>(from.item_1), convert<decltype(To{}.item_2)>(from.item_2));
    } else if constexpr (std::is_floating_point_v<From> && !std::is_floating_point_v<To>) {
        return rounded_down<To>(from);
    } else {
        return To(from);
    }
}

/// Returns whether a number belongs to another numeric type.
template <class To, bool natural, class From>
constexpr bool is_value(From value) noexcept {
    if constexpr (std::is_arithmetic_v<From>) {
        return (!natural || value >= From{}) && static_cast<From>(convert<To>(value)) == value;
    } else {
        const To converted(value);
        return From(converted) == value && converted.carried();
    }
}

/// Applies a function. Outside its domain, returns a default-constructed value.
template <class Result, class Function, class Argument>
constexpr Result apply(const Function& function, const Argument& argument) noexcept {
    for (const auto& pair : function)
        if (pair.item_1 == argument) return pair.item_2;
    return Result{};
}

/// Returns the whole numbers from `low` to `high`, as a set or a sequence.
template <class Numbers, class Number>
constexpr Numbers whole_range(Number low, Number high, std::int64_t less_low, std::int64_t less_high) noexcept {
    Numbers result;
    const std::int64_t last = minus(place_of(high), less_high);
    std::int64_t i = plus(place_of(low), less_low);
    for (bool more = i <= last; more && !result.overflowed(); more = i < last, i = plus(i, std::int64_t{1})) {
        if constexpr (detail::IsSequence<Numbers>::value) {
            result.append(typename Numbers::value_type(i));
        } else {
            result.insert(typename Numbers::value_type(i));
        }
    }
    return result;
}

namespace toolkit {

// ---- helpers

template <class R, class Items>
constexpr void take_all(R& result, const Items& items) noexcept {
    for (const auto& item : items) result.insert(convert<typename R::value_type>(item));
    inherit_overflow(result, items);
}
template <class R, class Items, class Keep>
constexpr R kept(const Items& items, Keep keep) noexcept {
    R result;
    for (const auto& item : items)
        if (keep(item)) result.insert(convert<typename R::value_type>(item));
    inherit_overflow(result, items);
    return result;
}
template <class Set, class Value>
constexpr bool has(const Set& set, const Value& value) noexcept {
    return set.contains(convert<typename Set::value_type>(value));
}
template <class Part, class Whole>
constexpr bool within(const Part& part, const Whole& whole) noexcept {
    for (const auto& item : part)
        if (!has(whole, item)) return false;
    return true;
}
/// Returns whether some pair of the relation begins with the value.
template <class Relation, class Value>
constexpr bool in_domain(const Relation& relation, const Value& value) noexcept {
    for (const auto& pair : relation)
        if (pair.item_1 == convert<decltype(pair.item_1)>(value)) return true;
    return false;
}
template <class Relation, class Value>
constexpr bool in_range(const Relation& relation, const Value& value) noexcept {
    for (const auto& pair : relation)
        if (pair.item_2 == convert<decltype(pair.item_2)>(value)) return true;
    return false;
}
/// `any(visit)` visits the values of a type until one is accepted.
template <class Relation, class Any>
constexpr bool total(const Relation& relation, Any any) noexcept {
    return !any([&](const auto& value) { return !in_domain(relation, value); });
}
template <class Relation, class Any>
constexpr bool onto(const Relation& relation, Any any) noexcept {
    return !any([&](const auto& value) { return !in_range(relation, value); });
}

// ---- sets

template <class R, class T, class S>
constexpr R notin(const T& value, const S& set) noexcept {
    return !has(set, value);
}
template <class R, class A, class B>
constexpr R subseteq(const A& a, const B& b) noexcept {
    return within(a, b);
}
template <class R, class A, class B>
constexpr R subset(const A& a, const B& b) noexcept {
    return within(a, b) && a.size() != b.size();
}
template <class R, class A, class B>
constexpr R union_(const A& a, const B& b) noexcept {
    R result;
    take_all(result, a);
    take_all(result, b);
    return result;
}
template <class R, class A, class B>
constexpr R inter(const A& a, const B& b) noexcept {
    return kept<R>(a, [&](const auto& item) { return has(b, item); });
}
template <class R, class A, class B>
constexpr R diff(const A& a, const B& b) noexcept {
    return kept<R>(a, [&](const auto& item) { return !has(b, item); });
}
template <class R, class A, class B>
constexpr R symetric_diff(const A& a, const B& b) noexcept {
    return union_<R>(diff<R>(a, b), diff<R>(b, a));
}
template <class R, class A>
constexpr R Union(const A& sets) noexcept {
    R result;
    for (const auto& set : sets) take_all(result, set);
    return result;
}
template <class R, class A>
constexpr R Inter(const A& sets) noexcept {
    if (sets.size() == 0) return R{};
    return kept<R>(*sets.begin(), [&](const auto& item) {
        for (const auto& set : sets)
            if (!set.contains(item)) return false;
        return true;
    });
}

// ---- relations

template <class R, class P>
constexpr R first(const P& pair) noexcept {
    return convert<R>(pair.item_1);
}
template <class R, class P>
constexpr R second(const P& pair) noexcept {
    return convert<R>(pair.item_2);
}
template <class R, class A, class B>
constexpr R maplet(const A& a, const B& b) noexcept {
    return R::make(convert<decltype(R{}.item_1)>(a), convert<decltype(R{}.item_2)>(b));
}
template <class R, class A>
constexpr R dom(const A& relation) noexcept {
    R result;
    for (const auto& pair : relation) result.insert(convert<typename R::value_type>(pair.item_1));
    inherit_overflow(result, relation);
    return result;
}
template <class R, class A>
constexpr R ran(const A& relation) noexcept {
    R result;
    for (const auto& pair : relation) result.insert(convert<typename R::value_type>(pair.item_2));
    inherit_overflow(result, relation);
    return result;
}
template <class R, class Any>
constexpr R id(Any any) noexcept {
    R result;
    any([&](const auto& value) {
        result.insert(maplet<typename R::value_type>(value, value));
        return false;
    });
    return result;
}
template <class R, class A, class B>
constexpr R relcomp(const A& a, const B& b) noexcept {
    R result;
    for (const auto& left : a)
        for (const auto& right : b)
            if (left.item_2 == convert<decltype(left.item_2)>(right.item_1))
                result.insert(maplet<typename R::value_type>(left.item_1, right.item_2));
    inherit_overflow(result, a);
    inherit_overflow(result, b);
    return result;
}
template <class R, class A, class B>
constexpr R funcomp(const A& a, const B& b) noexcept {
    return relcomp<R>(b, a);
}
template <class R, class S, class A>
constexpr R dres(const S& set, const A& relation) noexcept {
    return kept<R>(relation, [&](const auto& pair) { return has(set, pair.item_1); });
}
template <class R, class A, class S>
constexpr R rres(const A& relation, const S& set) noexcept {
    return kept<R>(relation, [&](const auto& pair) { return has(set, pair.item_2); });
}
template <class R, class S, class A>
constexpr R dsub(const S& set, const A& relation) noexcept {
    return kept<R>(relation, [&](const auto& pair) { return !has(set, pair.item_1); });
}
template <class R, class A, class S>
constexpr R rsub(const A& relation, const S& set) noexcept {
    return kept<R>(relation, [&](const auto& pair) { return !has(set, pair.item_2); });
}
template <class R, class A>
constexpr R rinv(const A& relation) noexcept {
    R result;
    for (const auto& pair : relation) result.insert(maplet<typename R::value_type>(pair.item_2, pair.item_1));
    inherit_overflow(result, relation);
    return result;
}
template <class R, class A, class S>
constexpr R rimage(const A& relation, const S& set) noexcept {
    R result;
    for (const auto& pair : relation)
        if (has(set, pair.item_1)) result.insert(convert<typename R::value_type>(pair.item_2));
    inherit_overflow(result, relation);
    return result;
}
template <class R, class A, class B>
constexpr R override(const A& a, const B& b) noexcept {
    R result = kept<R>(a, [&](const auto& pair) { return !in_domain(b, pair.item_1); });
    take_all(result, b);
    return result;
}
template <class R, class A>
constexpr R tr_closure(const A& relation) noexcept {
    R result = convert<R>(relation);
    for (;;) {
        const R more = union_<R>(result, relcomp<R>(result, relation));
        if (more == result) return result;
        result = more;
    }
}
template <class R, class A>
constexpr R refl_tr_closure(const A& relation) noexcept {
    R result = tr_closure<R>(relation);
    for (const auto& pair : relation) {
        result.insert(maplet<typename R::value_type>(pair.item_1, pair.item_1));
        result.insert(maplet<typename R::value_type>(pair.item_2, pair.item_2));
    }
    return result;
}

// ---- functions

template <class R, class A, class Any>
constexpr R isTotal(const A& function, Any any) noexcept {
    return total(function, any);
}
template <class R, class A>
constexpr R isInjection(const A& function) noexcept {
    for (const auto& a : function)
        for (const auto& b : function)
            if (a.item_2 == b.item_2 && !(a.item_1 == b.item_1)) return false;
    return true;
}
template <class R, class A, class Any>
constexpr R isTotalInjection(const A& function, Any any) noexcept {
    return total(function, any) && isInjection<R>(function);
}
template <class R, class A, class Any>
constexpr R isSurjection(const A& function, Any any) noexcept {
    return onto(function, any);
}
template <class R, class A, class AnyArgument, class AnyValue>
constexpr R isTotalSurjection(const A& function, AnyArgument argument, AnyValue value) noexcept {
    return total(function, argument) && onto(function, value);
}
template <class R, class A, class AnyArgument, class AnyValue>
constexpr R isBijection(const A& function, AnyArgument argument, AnyValue value) noexcept {
    return total(function, argument) && onto(function, value) && isInjection<R>(function);
}
template <class R, class A>
constexpr R isFinite(const A&) noexcept {
    return true;
}
template <class R, class A>
constexpr R isFiniteFunction(const A&) noexcept {
    return true;
}
template <class R, class A>
constexpr R isFiniteInjection(const A& function) noexcept {
    return isInjection<R>(function);
}
template <class R, class A>
constexpr R disjoint(const A& family) noexcept {
    for (const auto& a : family)
        for (const auto& b : family)
            for (const auto& item : a.item_2)
                if (!(a.item_1 == b.item_1) && b.item_2.contains(item)) return false;
    return true;
}
template <class R, class A, class S>
constexpr R partitions(const A& family, const S& set) noexcept {
    S all;
    for (const auto& part : family) take_all(all, part.item_2);
    return disjoint<R>(family) && all == set;
}

// ---- numbers

template <class R, class N>
constexpr R range(N low, N high) noexcept {
    return whole_range<R>(low, high, 0, 0);
}
template <class R, class N, class A, class Any>
constexpr R iter(N times, const A& relation, Any any) noexcept {
    const std::int64_t count = place_of(times);
    const R step = count < 0 ? rinv<R>(relation) : convert<R>(relation);
    R result = id<R>(any);
    for (std::int64_t i = 0; i < (count < 0 ? -count : count); ++i) result = relcomp<R>(result, step);
    return result;
}
template <class R, class A>
constexpr R size(const A& items) noexcept {
    if constexpr (OwnFolds<A>::value)
        return OwnFolds<A>::template size<R>(items);
    else
        return R(static_cast<std::int64_t>(items.size()));
}
template <class R, class A>
constexpr R hasMin(const A& items) noexcept {
    return items.size() > 0;
}
template <class R, class A>
constexpr R hasMax(const A& items) noexcept {
    return items.size() > 0;
}
template <class R, class A>
constexpr R min(const A& items) noexcept {
    return items.size() > 0 ? convert<R>(*items.begin()) : R{};
}
template <class R, class A>
constexpr R max(const A& items) noexcept {
    return items.size() > 0 ? convert<R>(*(items.end() - 1)) : R{};
}

// ---- sequences

template <class R, class Items>
constexpr R part_of(const Items& items, std::size_t from, std::size_t to) noexcept {
    R result;
    for (std::size_t i = from; i < to; ++i) result.append(convert<typename R::value_type>(items.begin()[i]));
    inherit_overflow(result, items);
    return result;
}
template <class R, class A>
constexpr R isNonEmpty(const A& items) noexcept {
    return items.size() > 0;
}
template <class R, class A>
constexpr R isInjectiveSequence(const A& items) noexcept {
    for (const auto& a : items)
        for (const auto& b : items)
            if (&a != &b && a == b) return false;
    return true;
}
template <class R, class A, class B>
constexpr R concat(const A& a, const B& b) noexcept {
    R result = convert<R>(a);
    for (const auto& item : b) result.append(convert<typename R::value_type>(item));
    inherit_overflow(result, b);
    return result;
}
template <class R, class A>
constexpr R reverse(const A& items) noexcept {
    R result;
    for (std::size_t i = items.size(); i > 0; --i) result.append(convert<typename R::value_type>(items.begin()[i - 1]));
    inherit_overflow(result, items);
    return result;
}
template <class R, class A>
constexpr R head(const A& items) noexcept {
    return items.size() > 0 ? convert<R>(*items.begin()) : R{};
}
template <class R, class A>
constexpr R last(const A& items) noexcept {
    return items.size() > 0 ? convert<R>(*(items.end() - 1)) : R{};
}
template <class R, class A>
constexpr R tail(const A& items) noexcept {
    return part_of<R>(items, 1, items.size());
}
template <class R, class A>
constexpr R front(const A& items) noexcept {
    return items.size() > 0 ? part_of<R>(items, 0, items.size() - 1) : R{};
}
template <class R, class A>
constexpr R squash(const A& function) noexcept {
    R result;
    for (const auto& pair : function) result.append(convert<typename R::value_type>(pair.item_2));
    inherit_overflow(result, function);
    return result;
}
template <class R, class S, class A>
constexpr R extract(const S& places, const A& items) noexcept {
    R result;
    for (std::size_t i = 0; i < items.size(); ++i)
        if (places.contains(typename S::value_type(static_cast<std::int64_t>(i) + 1)))
            result.append(convert<typename R::value_type>(items.begin()[i]));
    inherit_overflow(result, items);
    return result;
}
template <class R, class A, class S>
constexpr R filter(const A& items, const S& set) noexcept {
    R result;
    for (const auto& item : items)
        if (has(set, item)) result.append(convert<typename R::value_type>(item));
    inherit_overflow(result, items);
    return result;
}
template <class A, class B>
constexpr bool occurs(const A& part, const B& whole, std::size_t at) noexcept {
    for (std::size_t i = 0; i < part.size(); ++i)
        if (!(part.begin()[i] == whole.begin()[at + i])) return false;
    return true;
}
template <class R, class A, class B>
constexpr R prefix(const A& part, const B& whole) noexcept {
    return part.size() <= whole.size() && occurs(part, whole, 0);
}
template <class R, class A, class B>
constexpr R suffix(const A& part, const B& whole) noexcept {
    return part.size() <= whole.size() && occurs(part, whole, whole.size() - part.size());
}
template <class R, class A, class B>
constexpr R infix(const A& part, const B& whole) noexcept {
    for (std::size_t at = 0; at + part.size() <= whole.size(); ++at)
        if (occurs(part, whole, at)) return true;
    return false;
}
template <class R, class A>
constexpr R dconcat(const A& sequences) noexcept {
    R result;
    for (const auto& items : sequences)
        for (const auto& item : items) result.append(convert<typename R::value_type>(item));
    inherit_overflow(result, sequences);
    return result;
}

}  // namespace toolkit

}  // namespace robochart

#endif
