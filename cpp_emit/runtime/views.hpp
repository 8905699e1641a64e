// Declares views of sequences and sets. What `ran`, `extract`, `filter`, `union` and similar functions select is
// visited in place, and no collection is built. So the number of elements has no limit, and a fold over a window of a
// long sequence reads only the items of the window. The order of a visit is not specified. Delivered with the generated
// code. Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_VIEWS_HPP
#define ROBOCHART_VIEWS_HPP

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "robochart/toolkit.hpp"

namespace robochart {

namespace view {

// Every view has:
//   value_type     the type of its elements
//   distinct       whether no element is visited twice
//   any(visit)     calls `visit` for the elements until one is accepted, and returns whether one was accepted
//   tests_members  whether it has the following functions too
//   has(value)     whether the value is an element
//   any_place(first, last, visit)  visits the numbers between both bounds, for views of whole numbers

/// Returns whether the view has an element equal to `value`.
template <class View, class Value>
constexpr bool contains(const View& view, const Value& value) noexcept {
    if constexpr (View::tests_members) {
        return view.has(convert<typename View::value_type>(value));
    } else {
        const auto tested = convert<typename View::value_type>(value);
        return view.any([&](const auto& element) { return element == tested; });
    }
}

/// The items of a stored sequence, or the elements of a stored set. `Collection` is a reference to a collection that
/// outlives the view, or otherwise the collection itself.
template <class Collection>
class Items {
public:
    using Plain = std::decay_t<Collection>;
    using value_type = typename Plain::value_type;
    static constexpr bool distinct = detail::IsSet<Plain>::value;
    static constexpr bool tests_members = false;

    explicit constexpr Items(Collection&& collection) noexcept : collection_(static_cast<Collection&&>(collection)) {}
    template <class Visit>
    constexpr bool any(Visit visit) const noexcept {
        for (const value_type& item : collection_)
            if (visit(item)) return true;
        return false;
    }
    [[nodiscard]] constexpr const Plain& collection() const noexcept { return collection_; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return collection_.size(); }
    /// Returns the item at a place from 1 to size().
    [[nodiscard]] constexpr const value_type& at(std::int64_t place) const noexcept {
        return collection_.begin()[place - 1];
    }

private:
    Collection collection_;
};
template <class Collection>
constexpr Items<Collection> items(Collection&& collection) noexcept {
    return Items<Collection>(static_cast<Collection&&>(collection));
}

/// The whole numbers from `low + less_low` to `high - less_high`.
template <class Number>
class Interval {
public:
    using value_type = Number;
    static constexpr bool distinct = true;
    static constexpr bool tests_members = true;

    constexpr Interval(Number low, Number high, std::int64_t less_low = 0, std::int64_t less_high = 0) noexcept
        : low_(plus(place_of(low), less_low)), high_(minus(place_of(high), less_high)) {}
    template <class Visit>
    constexpr bool any(Visit visit) const noexcept {
        return any_place(INT64_MIN, INT64_MAX, [&](std::int64_t place) { return visit(Number(place)); });
    }
    /// Visits the numbers that also lie between `first` and `last`.
    template <class Visit>
    constexpr bool any_place(std::int64_t first, std::int64_t last, Visit visit) const noexcept {
        const std::int64_t end = last < high_ ? last : high_;
        std::int64_t place = first > low_ ? first : low_;
        if (place > end) return false;
        for (;; ++place) {
            if (visit(place)) return true;
            if (place == end) return false;
        }
    }
    [[nodiscard]] constexpr bool has(Number number) const noexcept {
        return low_ <= place_of(number) && place_of(number) <= high_;
    }

private:
    std::int64_t low_;
    std::int64_t high_;
};

/// The elements of a set literal.
template <class T, std::size_t count>
class Literal {
public:
    using value_type = T;
    static constexpr bool distinct = true;
    static constexpr bool tests_members = false;

    template <class... Elements>
    explicit constexpr Literal(Elements... elements) noexcept : element_{elements...} {}
    template <class Visit>
    constexpr bool any(Visit visit) const noexcept {
        for (std::size_t i = 0; i < count; ++i)
            if (!repeats(i) && visit(element_[i])) return true;
        return false;
    }

private:
    /// Returns whether an earlier element is equal.
    [[nodiscard]] constexpr bool repeats(std::size_t place) const noexcept {
        for (std::size_t i = 0; i < place; ++i)
            if (element_[i] == element_[place]) return true;
        return false;
    }

    T element_[count];
};
template <class T, class... Elements>
constexpr Literal<T, sizeof...(Elements)> literal(Elements... elements) noexcept {
    return Literal<T, sizeof...(Elements)>(T(elements)...);
}

/// Visits the numbers of a view that lie between `first` and `last`.
template <class View, class Visit>
constexpr bool any_place(const View& view, std::int64_t first, std::int64_t last, Visit visit) noexcept {
    if constexpr (View::tests_members) {
        return view.any_place(first, last, visit);
    } else {
        return view.any([&](const auto& number) {
            const std::int64_t place = place_of(number);
            return first <= place && place <= last && visit(place);
        });
    }
}

/// The elements of `a`, and those of `b` that `a` does not have.
template <class A, class B>
class Union {
public:
    using value_type = typename A::value_type;
    static constexpr bool distinct = A::distinct && B::distinct;
    static constexpr bool tests_members = true;

    constexpr Union(A a, B b) noexcept : a_(a), b_(b) {}
    template <class Visit>
    constexpr bool any(Visit visit) const noexcept {
        return a_.any(visit) ||
               b_.any([&](const value_type& element) { return !contains(a_, element) && visit(element); });
    }
    template <class Visit>
    constexpr bool any_place(std::int64_t first, std::int64_t last, Visit visit) const noexcept {
        return view::any_place(a_, first, last, visit) ||
               view::any_place(b_, first, last,
                               [&](std::int64_t place) { return !contains(a_, value_type(place)) && visit(place); });
    }
    [[nodiscard]] constexpr bool has(const value_type& element) const noexcept {
        return contains(a_, element) || contains(b_, element);
    }

private:
    A a_;
    B b_;
};
template <class A, class B>
constexpr Union<A, B> union_(A a, B b) noexcept {
    return Union<A, B>(a, b);
}

/// The items of one sequence, then those of another.
template <class A, class B>
class Concatenation {
public:
    using value_type = typename A::value_type;
    static constexpr bool distinct = false;
    static constexpr bool tests_members = false;

    constexpr Concatenation(A a, B b) noexcept : a_(static_cast<A&&>(a)), b_(static_cast<B&&>(b)) {}
    template <class Visit>
    constexpr bool any(Visit visit) const noexcept {
        return a_.any(visit) || b_.any(visit);
    }

private:
    A a_;
    B b_;
};
template <class A, class B>
constexpr Concatenation<A, B> concat(A a, B b) noexcept {
    return Concatenation<A, B>(static_cast<A&&>(a), static_cast<B&&>(b));
}

/// The elements of `whole` that satisfy a condition.
template <class Whole, class Condition>
class Selection {
public:
    using value_type = typename Whole::value_type;
    static constexpr bool distinct = Whole::distinct;
    static constexpr bool tests_members = false;

    constexpr Selection(Whole whole, Condition condition) noexcept : whole_(whole), condition_(condition) {}
    template <class Visit>
    constexpr bool any(Visit visit) const noexcept {
        return whole_.any([&](const value_type& element) { return condition_(element) && visit(element); });
    }

private:
    Whole whole_;
    Condition condition_;
};
template <class Whole, class Condition>
constexpr Selection<Whole, Condition> select(Whole whole, Condition condition) noexcept {
    return Selection<Whole, Condition>(whole, condition);
}
template <class A, class B>
constexpr auto inter(A a, B b) noexcept {
    return select(a, [b](const auto& element) { return contains(b, element); });
}
template <class A, class B>
constexpr auto diff(A a, B b) noexcept {
    return select(a, [b](const auto& element) { return !contains(b, element); });
}
/// Returns the items of a sequence that belong to a set.
template <class Sequence, class Set>
constexpr auto filter(Sequence sequence, Set set) noexcept {
    return inter(sequence, set);
}

/// The results of a function for the elements of `whole`.
template <class Result, class Whole, class Function>
class Image {
public:
    using value_type = Result;
    static constexpr bool distinct = false;
    static constexpr bool tests_members = false;

    constexpr Image(Whole whole, Function function) noexcept : whole_(whole), function_(function) {}
    template <class Visit>
    constexpr bool any(Visit visit) const noexcept {
        return whole_.any(
            [&](const typename Whole::value_type& element) { return visit(Result(function_(element))); });
    }

private:
    Whole whole_;
    Function function_;
};
template <class Result, class Whole, class Function>
constexpr Image<Result, Whole, Function> image(Whole whole, Function function) noexcept {
    return Image<Result, Whole, Function>(whole, function);
}

/// The items of a stored sequence at the places of a set.
template <class Places, class Sequence>
class Window {
public:
    using value_type = typename Sequence::value_type;
    static constexpr bool distinct = false;
    static constexpr bool tests_members = false;

    constexpr Window(Places places, Sequence sequence) noexcept
        : places_(places), sequence_(static_cast<Sequence&&>(sequence)) {}
    template <class Visit>
    constexpr bool any(Visit visit) const noexcept {
        const auto last = static_cast<std::int64_t>(sequence_.size());
        const auto visit_place = [&](std::int64_t place) { return visit(sequence_.at(place)); };
        if constexpr (Places::distinct) {
            return any_place(places_, 1, last, visit_place);
        } else {
            for (std::int64_t place = 1; place <= last; ++place)
                if (contains(places_, typename Places::value_type(place)) && visit_place(place)) return true;
            return false;
        }
    }
    [[nodiscard]] constexpr const Places& places() const noexcept { return places_; }
    [[nodiscard]] constexpr const Sequence& sequence() const noexcept { return sequence_; }

private:
    Places places_;
    Sequence sequence_;
};
template <class Places, class Sequence>
constexpr Window<Places, Sequence> extract(Places places, Sequence sequence) noexcept {
    return Window<Places, Sequence>(places, sequence);
}

// ---- folds

template <class View>
constexpr bool empty(const View& view) noexcept {
    if constexpr (OwnFolds<View>::value)
        return OwnFolds<View>::empty(view);
    else
        return !view.any([](const auto&) { return true; });
}
/// Returns an element that is not NaN, if there is one. Otherwise returns some element, or a default-constructed value.
template <class View>
constexpr typename View::value_type first_number(const View& view) noexcept {
    typename View::value_type result{};
    view.any([&](const auto& element) {
        result = element;
        return element == element;
    });
    return result;
}
/// Returns the least element, or a default-constructed value if there is none. NaN is ignored unless all elements are
/// NaN.
template <class R, class View>
constexpr R min(const View& view) noexcept {
    if constexpr (OwnFolds<View>::value) {
        return convert<R>(OwnFolds<View>::extremum(view, false));
    } else {
        auto result = first_number(view);
        view.any([&](const auto& element) {
            if (element < result) result = element;
            return false;
        });
        return convert<R>(result);
    }
}
/// Returns the greatest element, or a default-constructed value if there is none. NaN is ignored unless all elements
/// are NaN.
template <class R, class View>
constexpr R max(const View& view) noexcept {
    if constexpr (OwnFolds<View>::value) {
        return convert<R>(OwnFolds<View>::extremum(view, true));
    } else {
        auto result = first_number(view);
        view.any([&](const auto& element) {
            if (result < element) result = element;
            return false;
        });
        return convert<R>(result);
    }
}
/// Returns the number of items, including equal ones.
template <class R, class View>
constexpr R length(const View& view) noexcept {
    std::int64_t count = 0;
    view.any([&](const auto&) {
        ++count;
        return false;
    });
    return R(count);
}
/// Returns the number of different elements. If elements may repeat, the time grows with the square of their number.
template <class R, class View>
constexpr R size(const View& view) noexcept {
    if constexpr (View::distinct) {
        return length<R>(view);
    } else {
        std::int64_t count = 0;
        std::int64_t place = 0;
        view.any([&](const auto& element) {
            std::int64_t first_equal = 0;
            view.any([&](const auto& other) {
                if (other == element) return true;
                ++first_equal;
                return false;
            });
            if (first_equal >= place) ++count;
            ++place;
            return false;
        });
        return R(count);
    }
}
/// Returns whether all elements of `a` belong to `b`.
template <class A, class B>
constexpr bool subseteq(const A& a, const B& b) noexcept {
    return !a.any([&](const auto& element) { return !contains(b, element); });
}

}  // namespace view

}  // namespace robochart

#endif
