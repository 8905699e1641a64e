// Declares numbers over finite carriers: the types with which the generated code is explored and checked. Arithmetic is
// that of the model's semantics. Reals are integers in units of 1/scale. A result outside the carrier is replaced by
// the first operand. Quotients and products of reals are rounded down. Delivered with the generated code. Copyright:
// see LICENSE (Apache-2.0).
#ifndef ROBOCHART_FINITE_HPP
#define ROBOCHART_FINITE_HPP

#include <cstdint>
#include <type_traits>

namespace robochart {

__extension__ typedef __int128 WideInteger;

constexpr WideInteger floor_quotient(WideInteger a, WideInteger b) noexcept {
    const WideInteger quotient = a / b;
    return a % b != 0 && (a < 0) != (b < 0) ? quotient - 1 : quotient;
}

/// `Carrier` must have `static constexpr std::int64_t scale` and `static constexpr bool contains(std::int64_t)`.
template <class Carrier>
class Finite {
public:
    constexpr Finite() noexcept = default;
    template <class T, std::enable_if_t<std::is_integral_v<T>, int> = 0>
    explicit constexpr Finite(T value) noexcept : raw_(static_cast<std::int64_t>(value) * Carrier::scale) {}
    explicit constexpr Finite(double value) noexcept
        : raw_(static_cast<std::int64_t>(value * static_cast<double>(Carrier::scale) + (value < 0.0 ? -0.5 : 0.5))) {}
    /// Converts the number to this type's unit; rounds down if this unit is coarser.
    template <class Other>
    explicit constexpr Finite(Finite<Other> other) noexcept
        : raw_(static_cast<std::int64_t>(
              floor_quotient(static_cast<WideInteger>(other.raw()) * Carrier::scale, Other::scale))) {}

    [[nodiscard]] static constexpr Finite from_raw(std::int64_t raw) noexcept {
        Finite result;
        result.raw_ = raw;
        return result;
    }
    [[nodiscard]] constexpr std::int64_t raw() const noexcept { return raw_; }
    explicit constexpr operator double() const noexcept {
        return static_cast<double>(raw_) / static_cast<double>(Carrier::scale);
    }
    /// Returns whether the carrier contains the value.
    [[nodiscard]] constexpr bool carried() const noexcept { return Carrier::contains(raw_); }

    friend constexpr bool operator==(Finite a, Finite b) noexcept { return a.raw_ == b.raw_; }
    friend constexpr bool operator!=(Finite a, Finite b) noexcept { return a.raw_ != b.raw_; }
    friend constexpr bool operator<(Finite a, Finite b) noexcept { return a.raw_ < b.raw_; }
    friend constexpr bool operator<=(Finite a, Finite b) noexcept { return a.raw_ <= b.raw_; }
    friend constexpr bool operator>(Finite a, Finite b) noexcept { return a.raw_ > b.raw_; }
    friend constexpr bool operator>=(Finite a, Finite b) noexcept { return a.raw_ >= b.raw_; }

    friend constexpr Finite operator+(Finite a, Finite b) noexcept { return a.clipped(WideInteger{a.raw_} + b.raw_); }
    friend constexpr Finite operator-(Finite a, Finite b) noexcept { return a.clipped(WideInteger{a.raw_} - b.raw_); }
    friend constexpr Finite operator*(Finite a, Finite b) noexcept {
        return a.clipped(floor_quotient(WideInteger{a.raw_} * b.raw_, Carrier::scale));
    }
    friend constexpr Finite operator-(Finite a) noexcept { return a.clipped(-WideInteger{a.raw_}); }
    /// Generated code uses the following names to compute with whole numbers (runtime.hpp).
    friend constexpr Finite plus(Finite a, Finite b) noexcept { return a + b; }
    friend constexpr Finite minus(Finite a, Finite b) noexcept { return a - b; }
    friend constexpr Finite times(Finite a, Finite b) noexcept { return a * b; }
    friend constexpr Finite negative(Finite a) noexcept { return -a; }
    friend constexpr Finite divide(Finite a, Finite b) noexcept {
        if (b.raw_ == 0) return a;
        return a.clipped(floor_quotient(WideInteger{a.raw_} * Carrier::scale, b.raw_));
    }
    friend constexpr Finite modulus(Finite a, Finite b) noexcept {
        if (b.raw_ == 0) return a;
        return a.clipped(a.raw_ - floor_quotient(a.raw_, b.raw_) * b.raw_);
    }

private:
    /// Returns the exact result if the carrier contains it, and otherwise this value.
    [[nodiscard]] constexpr Finite clipped(WideInteger exact) const noexcept {
        const bool fits = exact >= INT64_MIN && exact <= INT64_MAX;
        return fits && Carrier::contains(static_cast<std::int64_t>(exact)) ? from_raw(static_cast<std::int64_t>(exact))
                                                                           : *this;
    }

    std::int64_t raw_ = 0;
};

/// Returns a number of units as a duration in time units. Negative numbers give zero.
constexpr std::uint32_t time_units(std::int64_t units, std::int64_t scale) noexcept {
    const WideInteger whole = floor_quotient(units, scale);
    if (whole < 0) return 0;
    return whole > INT32_MAX ? static_cast<std::uint32_t>(INT32_MAX) : static_cast<std::uint32_t>(whole);
}
template <class Carrier>
constexpr std::uint32_t duration(Finite<Carrier> units) noexcept {
    return time_units(units.raw(), Carrier::scale);
}

/// Returns a real as a whole number, rounded down.
template <class Whole, class Carrier>
constexpr Whole rounded_down(Finite<Carrier> value) noexcept {
    return Whole(value);
}
template <class Carrier>
constexpr std::int64_t place_of(Finite<Carrier> index) noexcept {
    return index.raw();
}

}  // namespace robochart

#endif
