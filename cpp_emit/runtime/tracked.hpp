// Declares tracked numbers. They record how they were computed, so that an exploration can give an answer for all
// values. A tracked number is either known, or a linear form of the parts of one input value. Every comparison of a
// form is recorded, because the explorer has to try values with each answer. Every use other than a comparison or a
// copy is recorded as a loss. Arithmetic is ideal: numbers have no carriers (docs/conformance.md, "All values"). The
// parts of a sequence are its size and the least and greatest numbers of windows (tracked_sequences.hpp). Delivered
// with the generated code. Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_TRACKED_HPP
#define ROBOCHART_TRACKED_HPP

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "robochart/explore_abi.h"
#include "robochart/finite.hpp"

namespace robochart {

/// The greatest absolute value of a number, in its units.
inline constexpr std::int64_t greatest_tracked = std::int64_t{1} << 58U;

/// The sum of coefficients times the parts of input value `index` of a type, plus a constant. If all coefficients are
/// 0, the number is known.
struct LinearForm {
    std::uint32_t type = 0;
    std::uint32_t index = 0;
    std::int64_t coefficient[ROBOCHART_MAX_PARTS] = {};
    std::int64_t constant = 0;

    [[nodiscard]] bool known() const noexcept {
        for (const std::int64_t factor : coefficient)
            if (factor != 0) return false;
        return true;
    }
    friend bool operator==(const LinearForm& a, const LinearForm& b) noexcept {
        for (std::size_t i = 0; i < ROBOCHART_MAX_PARTS; ++i)
            if (a.coefficient[i] != b.coefficient[i]) return false;
        return a.type == b.type && a.index == b.index && a.constant == b.constant;
    }
};

/// A set of places of a sequence.
struct PlaceSet {
    static constexpr std::uint32_t words = ROBOCHART_MAX_PLACES / 64;

    std::uint64_t word[words] = {};

    /// Adds `place`, which is from 1 to ROBOCHART_MAX_PLACES.
    void add(std::int64_t place) noexcept {
        word[(place - 1) / 64] |= std::uint64_t{1} << (static_cast<std::uint64_t>(place - 1) % 64);
    }
    /// Returns the places of a whole sequence. The last place stands for all places after it too.
    [[nodiscard]] static PlaceSet all() noexcept {
        PlaceSet result;
        for (std::uint64_t& bits : result.word) bits = ~std::uint64_t{0};
        return result;
    }
    [[nodiscard]] bool has(std::int64_t place) const noexcept {
        return (word[(place - 1) / 64] >> (static_cast<std::uint64_t>(place - 1) % 64) & 1U) != 0;
    }
    /// Returns the first place, or 0 if the set is empty.
    [[nodiscard]] std::int64_t first() const noexcept {
        for (std::int64_t place = 1; place <= ROBOCHART_MAX_PLACES; ++place)
            if (has(place)) return place;
        return 0;
    }
    friend bool operator==(const PlaceSet& a, const PlaceSet& b) noexcept {
        for (std::uint32_t i = 0; i < words; ++i)
            if (a.word[i] != b.word[i]) return false;
        return true;
    }
};

/// Stores the explored values of each type, the forms of all numbers, and the recorded comparisons and losses. Does not
/// allocate memory, because a call of generated code may be stopped anywhere.
class Tracking {
public:
    static constexpr std::uint32_t most_types = 16;
    static constexpr std::uint32_t most_numbers = 16384;
    static constexpr std::uint32_t most_sequences = 2048;
    static constexpr std::uint32_t most_items = 1U << 18U;
    static constexpr std::uint32_t most_windows = 64;
    /// The part of a sequence that is its size.
    static constexpr std::uint32_t size_part = 0;
    static constexpr std::uint32_t most_forms = 16384;
    static constexpr std::uint32_t most_comparisons = 256;

    /// Sets the values of a type. A call for type 0 forgets everything first. Returns false if the values do not fit.
    bool set_values(std::uint32_t type, std::uint32_t parts, std::uint32_t count, const std::int64_t* numbers) noexcept {
        if (type == 0) forget();
        const std::uint32_t size = parts * count;
        if (type >= most_types || parts > ROBOCHART_MAX_PARTS || size > most_numbers - numbers_) return false;
        table_[type] = {numbers_, parts, count, false};
        for (std::uint32_t i = 0; i < size; ++i) {
            LinearForm form;
            form.type = type;
            form.index = i / parts;
            form.coefficient[i % parts] = 1;
            form_[forms_++] = form;
            number_[numbers_++] = numbers[i];
        }
        return true;
    }

    /// Like set_values, for a type of sequences: the length of each value comes before its items.
    bool set_sequences(std::uint32_t type, std::uint32_t count, const std::int64_t* numbers) noexcept {
        if (type == 0) forget();
        if (type >= most_types || count > most_sequences - sequences_) return false;
        table_[type] = {sequences_, 0, count, true};
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::int64_t length = *numbers++;
            if (length > ROBOCHART_MAX_PLACES || length > most_items - items_) return false;
            sequence_[sequences_++] = {items_, length};
            for (std::int64_t place = 0; place < length; ++place) item_[items_++] = *numbers++;
        }
        return true;
    }
    /// Finds or adds a window of sequences, which is a set of places that is not empty. Returns its part in `part`.
    /// Returns false if there are too many windows.
    bool find_window(std::uint32_t type, const PlaceSet& places, bool greatest, std::uint32_t& part) noexcept {
        part = size_part + 1;
        for (std::uint32_t i = 0; i < windows_; ++i) {
            if (window_[i].type != type) continue;
            if (places_[i] == places && (window_[i].greatest != 0) == greatest) return true;
            ++part;
        }
        if (windows_ == most_windows || part >= ROBOCHART_MAX_PARTS) return false;
        places_[windows_] = places;
        window_[windows_] = {type, part, greatest ? 1U : 0U, places_[windows_].word};
        ++windows_;
        return true;
    }
    std::uint32_t windows(const rc_window** list) const noexcept {
        *list = window_;
        return windows_;
    }
    [[nodiscard]] std::int64_t size_of(std::uint32_t type, std::uint32_t index) const noexcept {
        return sequence_[table_[type].first + index].length;
    }
    [[nodiscard]] const std::int64_t* items_of(std::uint32_t type, std::uint32_t index) const noexcept {
        return item_ + sequence_[table_[type].first + index].first;
    }

    /// Returns the handle of a part of a value.
    [[nodiscard]] std::uint32_t part(std::uint32_t type, std::uint32_t index, std::uint32_t part) const noexcept {
        return table_[type].first + index * table_[type].parts + part;
    }
    [[nodiscard]] const LinearForm& form(std::uint32_t handle) const noexcept { return form_[handle]; }
    /// Returns the value of a form, in units.
    [[nodiscard]] WideInteger value(const LinearForm& form) const noexcept {
        const Table& table = table_[form.type];
        WideInteger sum = form.constant;
        if (table.sequences) {
            for (std::uint32_t i = 0; i < ROBOCHART_MAX_PARTS; ++i)
                if (form.coefficient[i] != 0)
                    sum += WideInteger{form.coefficient[i]} * part_of_sequence(form.type, form.index, i);
            return sum;
        }
        for (std::uint32_t i = 0; i < table.parts; ++i)
            sum += WideInteger{form.coefficient[i]} * number_[table.first + form.index * table.parts + i];
        return sum;
    }
    /// Finds or adds a form and returns its handle in `handle`. Returns false if there are too many forms, or if the
    /// value of the form is too large.
    bool find(const LinearForm& form, std::uint32_t& handle) noexcept {
        const WideInteger number = value(form);
        if (number > greatest_tracked || number < -greatest_tracked) return false;
        for (handle = 0; handle < forms_; ++handle)
            if (form_[handle] == form) return true;
        if (forms_ == most_forms) return false;
        form_[forms_] = form;
        ++forms_;
        return true;
    }

    /// Records the comparison of a form with zero.
    void record(const LinearForm& difference) noexcept {
        if (paused) return;
        rc_comparison found{};
        found.type = difference.type;
        for (std::size_t i = 0; i < ROBOCHART_MAX_PARTS; ++i) found.coefficient[i] = difference.coefficient[i];
        found.constant = difference.constant;
        for (std::uint32_t i = 0; i < comparisons_; ++i)
            if (equal(comparison_[i], found)) return;
        if (comparisons_ == most_comparisons) return lose(RC_TRACKED_INEXACT);
        comparison_[comparisons_] = found;
        ++comparisons_;
    }
    /// Records a loss (an RC_TRACKED_ flag): after this use, the explored values may no longer represent all values.
    void lose(std::uint32_t loss) noexcept {
        if (!paused) losses_ |= loss;
    }
    /// Records a loss that remains when other values are explored. An example is an inexact literal, which may be
    /// constructed only once.
    void lose_for_good(std::uint32_t loss) noexcept { lasting_losses_ |= loss; }
    [[nodiscard]] std::uint32_t losses() const noexcept { return losses_ | lasting_losses_; }
    std::uint32_t comparisons(const rc_comparison** list) const noexcept {
        *list = comparison_;
        return comparisons_;
    }
    /// Returns the index of the explored value of a type that consists of these numbers, or -1 if there is none.
    [[nodiscard]] std::int64_t place(std::uint32_t type, const std::int64_t* numbers) const noexcept {
        const Table& table = table_[type];
        for (std::uint32_t v = 0; v < table.count; ++v) {
            std::uint32_t equal_parts = 0;
            while (equal_parts < table.parts &&
                   number_[table.first + v * table.parts + equal_parts] == numbers[equal_parts])
                ++equal_parts;
            if (equal_parts == table.parts) return v;
        }
        return -1;
    }

    bool paused = false;  ///< true while a state is printed: then nothing is recorded

private:
    struct Table {
        std::uint32_t first = 0, parts = 0, count = 0;
        bool sequences = false;
    };
    struct Sequence {
        std::uint32_t first = 0;
        std::int64_t length = 0;
    };

    /// Returns a part of a sequence. The extremum of a window in which the sequence has no place is 0.
    [[nodiscard]] std::int64_t part_of_sequence(std::uint32_t type, std::uint32_t index,
                                                std::uint32_t part) const noexcept {
        const std::int64_t length = size_of(type, index);
        if (part == size_part) return length;
        std::uint32_t found = 0;
        while (found < windows_ && (window_[found].type != type || window_[found].part != part)) ++found;
        if (found == windows_) return 0;
        const std::int64_t* const items = items_of(type, index);
        const bool greatest = window_[found].greatest != 0;
        bool empty = true;
        std::int64_t result = 0;
        for (std::int64_t place = 1; place <= length; ++place) {
            if (!places_[found].has(place)) continue;
            const std::int64_t item = items[place - 1];
            if (empty || (greatest ? item > result : item < result)) result = item;
            empty = false;
        }
        return result;
    }
    static bool equal(const rc_comparison& a, const rc_comparison& b) noexcept {
        for (std::size_t i = 0; i < ROBOCHART_MAX_PARTS; ++i)
            if (a.coefficient[i] != b.coefficient[i]) return false;
        return a.type == b.type && a.constant == b.constant;
    }
    void forget() noexcept { numbers_ = sequences_ = items_ = windows_ = forms_ = comparisons_ = losses_ = 0; }

    Table table_[most_types] = {};
    std::int64_t number_[most_numbers] = {};
    Sequence sequence_[most_sequences] = {};
    std::int64_t item_[most_items] = {};
    rc_window window_[most_windows] = {};
    PlaceSet places_[most_windows] = {};
    LinearForm form_[most_forms] = {};
    rc_comparison comparison_[most_comparisons] = {};
    std::uint32_t sequences_ = 0, items_ = 0, windows_ = 0;
    std::uint32_t numbers_ = 0, forms_ = 0, comparisons_ = 0, losses_ = 0, lasting_losses_ = 0;
};

namespace {
[[maybe_unused]] Tracking tracking;
}  // namespace

/// A tracked number: a known number of units, or the handle of a form in `tracking`. `Carrier` must have `static
/// constexpr std::int64_t scale` (units of one) and `static constexpr bool natural` (no negative numbers).
template <class Carrier>
class Tracked {
public:
    constexpr Tracked() noexcept = default;
    template <class T, std::enable_if_t<std::is_integral_v<T>, int> = 0>
    explicit constexpr Tracked(T value) noexcept : Tracked(Known{}, WideInteger{value} * Carrier::scale) {}
    /// Makes the decimal that the literal denotes. A literal is exact only if it is a whole number of units with an
    /// absolute value below 2^53.
    explicit constexpr Tracked(double value) noexcept : Tracked(Known{}, units_near(value)) {
        const double units = static_cast<double>(units_near(value));
        constexpr double largest = 9007199254740992.0;
        const bool exact = units < largest && units > -largest && units / static_cast<double>(Carrier::scale) == value;
        if (!exact) tracking.lose_for_good(RC_TRACKED_INEXACT);
    }
    /// Converts the number to this type's unit; rounds down if this unit is coarser.
    template <class Other>
    explicit constexpr Tracked(Tracked<Other> other) noexcept
        : Tracked(Known{}, floor_quotient(WideInteger{other.raw()} * Carrier::scale, Other::scale)) {
        if (other.known()) return;
        LinearForm scaled;
        const bool exact = Carrier::scale % Other::scale == 0;
        if (exact && add(scaled, other.form(), Carrier::scale / Other::scale))
            *this = made(scaled, *this);
        else
            tracking.lose(RC_TRACKED_INEXACT);
    }
    /// Returns a part of an input value.
    [[nodiscard]] static Tracked part(std::uint32_t type, std::uint32_t index, std::uint32_t part) noexcept {
        Tracked result;
        result.bits_ = std::int64_t{tracking.part(type, index, part)} * 2 + 1;
        return result;
    }

    /// Returns a part of a sequence, which has its own form.
    [[nodiscard]] static Tracked part_of_sequence(std::uint32_t type, std::uint32_t index,
                                                  std::uint32_t part) noexcept {
        LinearForm form;
        form.type = type;
        form.index = index;
        form.coefficient[part] = 1;
        return made(form, Tracked());
    }

    [[nodiscard]] constexpr bool known() const noexcept { return (bits_ & 1) == 0; }
    [[nodiscard]] constexpr std::int64_t raw() const noexcept {
        return known() ? bits_ / 2 : static_cast<std::int64_t>(tracking.value(tracking.form(handle())));
    }
    [[nodiscard]] LinearForm form() const noexcept {
        if (!known()) return tracking.form(handle());
        LinearForm result;
        result.constant = bits_ / 2;
        return result;
    }
    explicit constexpr operator double() const noexcept {
        return static_cast<double>(native()) / static_cast<double>(Carrier::scale);
    }
    /// Returns whether the type contains the value.
    [[nodiscard]] constexpr bool carried() const noexcept { return !Carrier::natural || native() >= 0; }
    /// Returns the number, for a use that is neither a comparison nor a copy.
    [[nodiscard]] constexpr std::int64_t native() const noexcept {
        if (!known()) tracking.lose(RC_TRACKED_NATIVE);
        return raw();
    }

    friend constexpr bool operator==(Tracked a, Tracked b) noexcept { return difference(a, b) == 0; }
    friend constexpr bool operator!=(Tracked a, Tracked b) noexcept { return difference(a, b) != 0; }
    friend constexpr bool operator<(Tracked a, Tracked b) noexcept { return difference(a, b) < 0; }
    friend constexpr bool operator<=(Tracked a, Tracked b) noexcept { return difference(a, b) <= 0; }
    friend constexpr bool operator>(Tracked a, Tracked b) noexcept { return difference(a, b) > 0; }
    friend constexpr bool operator>=(Tracked a, Tracked b) noexcept { return difference(a, b) >= 0; }

    friend constexpr Tracked operator+(Tracked a, Tracked b) noexcept { return sum(a, b, 1); }
    friend constexpr Tracked operator-(Tracked a, Tracked b) noexcept { return sum(a, b, -1); }
    friend constexpr Tracked operator-(Tracked a) noexcept {
        const Tracked result = sum(Tracked(), a, -1);
        return Carrier::natural ? a : result;
    }
    friend constexpr Tracked operator*(Tracked a, Tracked b) noexcept {
        if (a.known() && b.known())
            return a.clipped(floor_quotient(WideInteger{a.raw()} * b.raw(), Carrier::scale));
        return a.known() ? multiple(b, a, a) : multiple(a, b, a);
    }
    friend constexpr Tracked plus(Tracked a, Tracked b) noexcept { return a + b; }
    friend constexpr Tracked minus(Tracked a, Tracked b) noexcept { return a - b; }
    friend constexpr Tracked times(Tracked a, Tracked b) noexcept { return a * b; }
    friend constexpr Tracked negative(Tracked a) noexcept { return -a; }
    friend constexpr Tracked divide(Tracked a, Tracked b) noexcept {
        if (!a.known() || !b.known()) return a.inexact();
        return b.raw() == 0 ? a : a.clipped(floor_quotient(WideInteger{a.raw()} * Carrier::scale, b.raw()));
    }
    friend constexpr Tracked modulus(Tracked a, Tracked b) noexcept {
        if (!a.known() || !b.known()) return a.inexact();
        return b.raw() == 0 ? a : a.clipped(a.raw() - floor_quotient(a.raw(), b.raw()) * b.raw());
    }

private:
    struct Known {};
    [[nodiscard]] static constexpr WideInteger units_near(double value) noexcept {
        const double units = value * static_cast<double>(Carrier::scale);
        constexpr double beyond = 4e18;
        if (!(units < beyond && units > -beyond)) return greatest_tracked + WideInteger{1};
        return static_cast<WideInteger>(units + (units < 0.0 ? -0.5 : 0.5));
    }
    constexpr Tracked(Known, WideInteger value) noexcept {
        if (value > greatest_tracked || value < -greatest_tracked)
            tracking.lose(RC_TRACKED_INEXACT);
        else
            bits_ = static_cast<std::int64_t>(value) * 2;
    }
    [[nodiscard]] constexpr std::uint32_t handle() const noexcept { return static_cast<std::uint32_t>(bits_ / 2); }
    [[nodiscard]] constexpr Tracked inexact() const noexcept {
        tracking.lose(RC_TRACKED_INEXACT);
        return *this;
    }
    /// Returns a known result. The model replaces a negative natural number by the first operand.
    [[nodiscard]] constexpr Tracked clipped(WideInteger exact) const noexcept {
        return Carrier::natural && exact < 0 ? *this : Tracked(Known{}, exact);
    }
    [[nodiscard]] static constexpr Tracked made(const LinearForm& form, Tracked first) noexcept {
        if (form.known()) return first.clipped(form.constant);
        std::uint32_t handle = 0;
        if (!tracking.find(form, handle)) return first.inexact();
        Tracked result;
        result.bits_ = std::int64_t{handle} * 2 + 1;
        return result;
    }
    /// Adds factor * number. Returns false if the sum is too large.
    static bool add(std::int64_t& to, std::int64_t number, std::int64_t factor) noexcept {
        const WideInteger exact = to + WideInteger{number} * factor;
        if (exact > greatest_tracked || exact < -greatest_tracked) return false;
        to = static_cast<std::int64_t>(exact);
        return true;
    }
    /// Adds a multiple of another form. Returns false if the forms belong to two values or the sum is too large.
    static bool add(LinearForm& to, const LinearForm& other, std::int64_t factor) noexcept {
        if (!to.known() && !other.known() && (to.type != other.type || to.index != other.index)) return false;
        if (to.known()) {
            to.type = other.type;
            to.index = other.index;
        }
        bool fits = add(to.constant, other.constant, factor);
        for (std::size_t i = 0; i < ROBOCHART_MAX_PARTS; ++i)
            fits = fits && add(to.coefficient[i], other.coefficient[i], factor);
        return fits;
    }
    /// Adds a multiple of b to a. Natural numbers are subtracted only where they are known, because the model clips a
    /// negative result.
    static constexpr Tracked sum(Tracked a, Tracked b, std::int64_t factor) noexcept {
        if (a.known() && b.known()) return a.clipped(WideInteger{a.raw()} + WideInteger{b.raw()} * factor);
        LinearForm form = a.form();
        if ((Carrier::natural && factor < 0) || !add(form, b.form(), factor)) return a.inexact();
        return made(form, a);
    }
    /// Returns a form times a known whole number. `first` is the first operand of the product.
    static Tracked multiple(Tracked form, Tracked factor, Tracked first) noexcept {
        const bool whole = factor.known() && factor.raw() % Carrier::scale == 0;
        if (!whole || (Carrier::natural && factor.raw() < 0)) return first.inexact();
        LinearForm result;
        if (!add(result, form.form(), factor.raw() / Carrier::scale)) return first.inexact();
        return made(result, first);
    }
    /// Returns the sign of a - b. Records the comparison unless both numbers are known.
    static constexpr int difference(Tracked a, Tracked b) noexcept {
        if (!a.known() || !b.known()) record(a, b);
        const std::int64_t one = a.raw(), other = b.raw();
        if (one == other) return 0;
        return one < other ? -1 : 1;
    }
    static void record(Tracked a, Tracked b) noexcept {
        LinearForm form = a.form();
        if (!add(form, b.form(), -1)) return tracking.lose(RC_TRACKED_RELATION);
        if (!form.known()) tracking.record(form);
    }

    std::int64_t bits_ = 0;  ///< twice a known number, or twice the handle of a form plus one
};

/// Returns the index of an output among the explored values of its type, or -1 if it is none of them. Records a loss if
/// the output is neither known nor a copy of an input value.
template <class... Parts>
std::int64_t place_of_value(std::uint32_t type, Parts... parts) noexcept {
    const std::int64_t numbers[] = {parts.raw()...};
    const LinearForm forms[] = {parts.form()...};
    bool known = true, copied = true;
    for (std::uint32_t i = 0; i < sizeof...(Parts); ++i) {
        LinearForm copy;
        copy.type = type;
        copy.index = forms[0].index;
        copy.coefficient[i] = 1;
        known = known && forms[i].known();
        copied = copied && forms[i] == copy;
    }
    if (!known && !copied) tracking.lose(RC_TRACKED_OUTPUT);
    return tracking.place(type, numbers);
}

template <class Carrier>
constexpr std::uint32_t duration(Tracked<Carrier> units) noexcept {
    return time_units(units.native(), Carrier::scale);
}

/// Returns a real as a whole number, rounded down.
template <class Whole, class Carrier>
constexpr Whole rounded_down(Tracked<Carrier> value) noexcept {
    return Whole(value);
}
template <class Carrier>
constexpr std::int64_t place_of(Tracked<Carrier> index) noexcept {
    return index.native();
}

}  // namespace robochart

#endif
