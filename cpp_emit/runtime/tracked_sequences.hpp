// Declares sequences of tracked numbers. The code may copy a sequence, and read its size and the least and greatest
// numbers of windows. Each of these is a part of the input value, like the numbers of a record (tracked.hpp). Code that
// reads a sequence in another way does not compile, or causes a loss. Delivered with the generated code. Copyright: see
// LICENSE (Apache-2.0).
#ifndef ROBOCHART_TRACKED_SEQUENCES_HPP
#define ROBOCHART_TRACKED_SEQUENCES_HPP

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "robochart/tracked.hpp"
#include "robochart/views.hpp"

namespace robochart {

namespace detail {
struct SizeCarrier {
    static constexpr std::int64_t scale = 1;
    static constexpr bool natural = true;
};
}  // namespace detail

/// The size of a sequence, for uses that need the number.
class TrackedSize {
public:
    explicit constexpr TrackedSize(Tracked<detail::SizeCarrier> size) noexcept : size_(size) {}
    constexpr operator std::size_t() const noexcept { return static_cast<std::size_t>(size_.native()); }

private:
    Tracked<detail::SizeCarrier> size_;
};

/// An input value, or the empty sequence. It has no capacity.
template <class Carrier, std::size_t capacity>
class Sequence<Tracked<Carrier>, capacity> {
public:
    using value_type = Tracked<Carrier>;
    static constexpr std::size_t most = capacity;

    constexpr Sequence() noexcept = default;
    [[nodiscard]] static constexpr Sequence of() noexcept { return {}; }
    /// Returns value `index` of type `type`.
    [[nodiscard]] static constexpr Sequence input(std::uint32_t type, std::uint32_t index) noexcept {
        Sequence result;
        result.type_ = type + 1;
        result.index_ = index;
        return result;
    }

    [[nodiscard]] constexpr bool known() const noexcept { return type_ == 0; }
    [[nodiscard]] constexpr std::uint32_t type() const noexcept { return type_ - 1; }
    [[nodiscard]] constexpr std::uint32_t index() const noexcept { return index_; }

    [[nodiscard]] Tracked<detail::SizeCarrier> tracked_size() const noexcept {
        if (known()) return {};
        return Tracked<detail::SizeCarrier>::part_of_sequence(type(), index(), Tracking::size_part);
    }
    [[nodiscard]] TrackedSize size() const noexcept { return TrackedSize(tracked_size()); }
    /// Returns whether the size is less than `least`, which must be positive. The form 2 * size - (2 * least - 1) is
    /// never 0.
    [[nodiscard]] bool is_shorter_than(std::int64_t least) const noexcept {
        if (known()) return true;
        LinearForm form;
        form.type = type();
        form.index = index();
        form.coefficient[Tracking::size_part] = 2;
        form.constant = -(2 * least - 1);
        tracking.record(form);
        return tracking.value(form) < 0;
    }
    /// Returns the least or greatest number at the places, or 0 if there is none.
    [[nodiscard]] value_type extremum(const PlaceSet& places, bool greatest) const noexcept {
        const std::int64_t first = places.first();
        std::uint32_t part = 0;
        if (first == 0 || is_shorter_than(first)) return {};
        if (!tracking.find_window(type(), places, greatest, part)) {
            tracking.lose(RC_TRACKED_INEXACT);
            return {};
        }
        return value_type::part_of_sequence(type(), index(), part);
    }

    friend bool operator==(const Sequence& a, const Sequence& b) noexcept {
        if (a.known() || b.known()) return a.is_shorter_than(1) && b.is_shorter_than(1);
        tracking.lose(RC_TRACKED_RELATION);
        return a.has_items_of(b);
    }
    friend bool operator!=(const Sequence& a, const Sequence& b) noexcept { return !(a == b); }

private:
    [[nodiscard]] bool has_items_of(const Sequence& other) const noexcept {
        const std::int64_t length = tracking.size_of(type(), index());
        if (length != tracking.size_of(other.type(), other.index())) return false;
        const std::int64_t* const mine = tracking.items_of(type(), index());
        const std::int64_t* const others = tracking.items_of(other.type(), other.index());
        for (std::int64_t i = 0; i < length; ++i)
            if (mine[i] != others[i]) return false;
        return true;
    }

    std::uint32_t type_ = 0;  ///< 0: the empty sequence; otherwise the type of the input plus 1
    std::uint32_t index_ = 0;
};

namespace detail {
template <class T>
struct IsTrackedSequence : std::false_type {};
template <class Carrier, std::size_t capacity>
struct IsTrackedSequence<Sequence<Tracked<Carrier>, capacity>> : std::true_type {};
}  // namespace detail

template <class Carrier, std::size_t capacity>
struct OwnFolds<Sequence<Tracked<Carrier>, capacity>> : std::true_type {
    template <class R>
    static R size(const Sequence<Tracked<Carrier>, capacity>& items) noexcept {
        return R(items.tracked_size());
    }
};

/// Windows of tracked sequences.
template <class Places, class Collection>
struct OwnFolds<view::Window<Places, view::Items<Collection>>,
                std::enable_if_t<detail::IsTrackedSequence<std::decay_t<Collection>>::value>> : std::true_type {
    using View = view::Window<Places, view::Items<Collection>>;

    static PlaceSet places_of(const View& view) noexcept {
        PlaceSet result;
        view::any_place(view.places(), 1, ROBOCHART_MAX_PLACES, [&](std::int64_t place) {
            if (place >= ROBOCHART_MAX_PLACES)
                tracking.lose(RC_TRACKED_INEXACT);
            else
                result.add(place);
            return false;
        });
        return result;
    }
    static bool empty(const View& view) noexcept {
        const std::int64_t first = places_of(view).first();
        return first == 0 || view.sequence().collection().is_shorter_than(first);
    }
    static typename View::value_type extremum(const View& view, bool greatest) noexcept {
        return view.sequence().collection().extremum(places_of(view), greatest);
    }
};

/// All items of a tracked sequence.
template <class Collection>
struct OwnFolds<view::Items<Collection>,
                std::enable_if_t<detail::IsTrackedSequence<std::decay_t<Collection>>::value>> : std::true_type {
    using View = view::Items<Collection>;

    static bool empty(const View& view) noexcept { return view.collection().is_shorter_than(1); }
    static typename View::value_type extremum(const View& view, bool greatest) noexcept {
        return view.collection().extremum(PlaceSet::all(), greatest);
    }
};

}  // namespace robochart

#endif
