// Declares sequences and sets as values of fixed size. They use no heap, and equal values have equal bytes. If a list
// is given more items than its capacity, it keeps those that fit and records the overflow (`overflowed`). Delivered
// with the generated code. Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_COMPOSED_HPP
#define ROBOCHART_COMPOSED_HPP

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "robochart/runtime.hpp"

namespace robochart {

/// A counter of two bytes without alignment.
class ByteCount {
public:
    constexpr ByteCount(std::size_t count = 0) noexcept  // NOLINT: converts like a number
        : low_(static_cast<std::uint8_t>(count % 256)), high_(static_cast<std::uint8_t>(count / 256)) {}
    constexpr operator std::size_t() const noexcept { return std::size_t{256} * high_ + low_; }

private:
    std::uint8_t low_;
    std::uint8_t high_;
};

/// A counter up to `capacity + 1`. It is as wide as the items, so that there is no padding.
template <class T, std::size_t capacity>
using Count = std::conditional_t<(alignof(T) > 1), std::uint64_t,
                                 std::conditional_t<(capacity < 255), std::uint8_t, ByteCount>>;

/// Whether a collection or a view computes folds without a visit of its elements. True only for sequences whose items
/// are not known (tracked_sequences.hpp).
template <class Collection, class = void>
struct OwnFolds : std::false_type {};

/// Compares in lexicographic order; a prefix comes first.
template <class T>
constexpr bool ordered_before(const T* a, std::size_t count_a, const T* b, std::size_t count_b) noexcept {
    for (std::size_t i = 0; i < count_a && i < count_b; ++i)
        if (!(a[i] == b[i])) return a[i] < b[i];
    return count_a < count_b;
}

/// A sequence of at most `capacity` items.
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
    /// Adds the item. If the sequence is full, it overflows.
    constexpr void append(T item) noexcept {
        if (count_ >= capacity) return mark_overflow();
        item_[size()] = item;
        count_ = static_cast<Number>(count_ + 1);
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept {
        return count_ < capacity ? static_cast<std::size_t>(count_) : capacity;
    }
    constexpr void mark_overflow() noexcept { count_ = static_cast<Number>(capacity + 1); }
    [[nodiscard]] constexpr bool overflowed() const noexcept {
        if (count_ > capacity) return true;
        if constexpr (HoldsLists<T>::value)
            for (std::size_t i = 0; i < size(); ++i)
                if (robochart::overflowed(item_[i])) return true;
        return false;
    }
    constexpr bool drop_overflow() noexcept {
        bool dropped = count_ > capacity;
        count_ = static_cast<Number>(size());
        if constexpr (HoldsLists<T>::value)
            for (std::size_t i = 0; i < size(); ++i) dropped = robochart::drop_overflow(item_[i]) || dropped;
        return dropped;
    }
    [[nodiscard]] constexpr const T* begin() const noexcept { return item_; }
    [[nodiscard]] constexpr const T* end() const noexcept { return item_ + size(); }
    /// Returns the item at a place, counted from 1 as in the model. Outside the sequence, returns a default-constructed
    /// value.
    [[nodiscard]] constexpr T at(std::int64_t place) const noexcept { return has(place) ? item_[place - 1] : T{}; }
    constexpr void put(std::int64_t place, T item) noexcept {
        if (has(place)) item_[place - 1] = item;
    }
    friend constexpr Sequence concat(const Sequence& a, const Sequence& b) noexcept {
        Sequence result = a;
        for (std::size_t i = 0; i < b.size(); ++i) result.append(b.item_[i]);
        if (b.count_ > capacity) result.mark_overflow();
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
    using Number = Count<T, capacity>;

    [[nodiscard]] constexpr bool has(std::int64_t place) const noexcept {
        return place >= 1 && static_cast<std::uint64_t>(place) <= size();
    }

    T item_[capacity]{};
    Number count_ = 0;  ///< capacity + 1 after an overflow
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
        if (contains(member)) return;
        if (count_ >= capacity) return mark_overflow();
        std::size_t place = size();
        count_ = static_cast<Number>(count_ + 1);
        for (; place > 0 && member < item_[place - 1]; --place) item_[place] = item_[place - 1];
        item_[place] = member;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept {
        return count_ < capacity ? static_cast<std::size_t>(count_) : capacity;
    }
    constexpr void mark_overflow() noexcept { count_ = static_cast<Number>(capacity + 1); }
    [[nodiscard]] constexpr bool overflowed() const noexcept {
        if (count_ > capacity) return true;
        if constexpr (HoldsLists<T>::value)
            for (std::size_t i = 0; i < size(); ++i)
                if (robochart::overflowed(item_[i])) return true;
        return false;
    }
    constexpr bool drop_overflow() noexcept {
        const bool dropped = overflowed();
        count_ = static_cast<Number>(size());
        if constexpr (HoldsLists<T>::value) {
            const Set cut = *this;
            *this = Set{};
            for (T member : cut) {
                (void)robochart::drop_overflow(member);
                insert(member);  // elements may be equal now
            }
        }
        return dropped;
    }
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
    using Number = Count<T, capacity>;

    T item_[capacity]{};
    Number count_ = 0;  ///< capacity + 1 after an overflow
};

}  // namespace robochart

#endif
