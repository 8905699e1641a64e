// Sequences and sets as values of fixed size. They use no heap, and equal values have equal bytes. Delivered with the
// generated code. Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_COMPOSED_HPP
#define ROBOCHART_COMPOSED_HPP

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace robochart {

/// A counter as wide as the items, so that there is no padding.
template <class T>
using Count = std::conditional_t<(alignof(T) > 1), std::uint64_t, std::uint8_t>;

/// Lexicographic order; a prefix comes first.
template <class T>
constexpr bool ordered_before(const T* a, std::size_t count_a, const T* b, std::size_t count_b) noexcept {
    for (std::size_t i = 0; i < count_a && i < count_b; ++i)
        if (!(a[i] == b[i])) return a[i] < b[i];
    return count_a < count_b;
}

/// A sequence of at most `capacity` items; further items are dropped.
template <class T, std::size_t capacity>
class Sequence {
public:
    using value_type = T;
    static constexpr std::size_t most = capacity;

    template <class... Items>
    [[nodiscard]] static constexpr Sequence of(Items... items) noexcept {
        Sequence result;
        (result.append(T(items)), ...);
        return result;
    }
    constexpr void append(T item) noexcept {
        if (count_ < capacity) item_[count_++] = item;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return static_cast<std::size_t>(count_); }
    [[nodiscard]] constexpr const T* begin() const noexcept { return item_; }
    [[nodiscard]] constexpr const T* end() const noexcept { return item_ + size(); }
    /// Counted from 1, as in the model; outside the sequence: a default-constructed value.
    [[nodiscard]] constexpr T at(std::int64_t place) const noexcept { return has(place) ? item_[place - 1] : T{}; }
    constexpr void put(std::int64_t place, T item) noexcept {
        if (has(place)) item_[place - 1] = item;
    }
    friend constexpr Sequence concat(const Sequence& a, const Sequence& b) noexcept {
        Sequence result = a;
        for (std::size_t i = 0; i < b.size(); ++i) result.append(b.item_[i]);
        return result;
    }
    friend constexpr bool operator==(const Sequence& a, const Sequence& b) noexcept {
        if (a.count_ != b.count_) return false;
        for (std::size_t i = 0; i < a.size(); ++i)
            if (!(a.item_[i] == b.item_[i])) return false;
        return true;
    }
    friend constexpr bool operator!=(const Sequence& a, const Sequence& b) noexcept { return !(a == b); }
    friend constexpr bool operator<(const Sequence& a, const Sequence& b) noexcept {
        return ordered_before(a.item_, a.size(), b.item_, b.size());
    }

private:
    [[nodiscard]] constexpr bool has(std::int64_t place) const noexcept {
        return place >= 1 && static_cast<std::uint64_t>(place) <= size();
    }

    T item_[capacity]{};
    Count<T> count_ = 0;
};

/// A set of at most `capacity` elements, sorted.
template <class T, std::size_t capacity>
class Set {
public:
    using value_type = T;
    static constexpr std::size_t most = capacity;

    template <class... Members>
    [[nodiscard]] static constexpr Set of(Members... members) noexcept {
        Set result;
        (result.insert(T(members)), ...);
        return result;
    }
    constexpr void insert(T member) noexcept {
        if (contains(member) || count_ == capacity) return;
        std::size_t place = static_cast<std::size_t>(count_++);
        for (; place > 0 && member < item_[place - 1]; --place) item_[place] = item_[place - 1];
        item_[place] = member;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return static_cast<std::size_t>(count_); }
    [[nodiscard]] constexpr const T* begin() const noexcept { return item_; }
    [[nodiscard]] constexpr const T* end() const noexcept { return item_ + size(); }
    [[nodiscard]] constexpr bool contains(T member) const noexcept {
        for (std::size_t i = 0; i < size(); ++i)
            if (item_[i] == member) return true;
        return false;
    }
    friend constexpr bool operator==(const Set& a, const Set& b) noexcept {
        if (a.count_ != b.count_) return false;
        for (std::size_t i = 0; i < a.size(); ++i)
            if (!(a.item_[i] == b.item_[i])) return false;
        return true;
    }
    friend constexpr bool operator!=(const Set& a, const Set& b) noexcept { return !(a == b); }
    friend constexpr bool operator<(const Set& a, const Set& b) noexcept {
        return ordered_before(a.item_, a.size(), b.item_, b.size());
    }

private:
    T item_[capacity]{};
    Count<T> count_ = 0;
};

}  // namespace robochart

#endif
