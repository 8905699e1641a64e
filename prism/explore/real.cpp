// SPDX-License-Identifier: Apache-2.0
// See real.hpp.
#include "prism/explore/real.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace robochart::prism {
namespace {

using Integer = boost::multiprecision::cpp_int;
constexpr double infinity = std::numeric_limits<double>::infinity();
/// The largest size of a fraction in bits. Larger fractions are replaced by enclosures.
constexpr unsigned most_bits = 1U << 15U;

unsigned bits(const Integer& value) {
    return value.is_zero() ? 0 : static_cast<unsigned>(msb(abs(value))) + 1;
}

/// Widens a value by a few units in the last place, to cover the error of the mathematical library.
Enclosure widen_by_rounding(double value) {
    double low = value;
    double high = value;
    for (int i = 0; i < 4; ++i) {
        low = std::nextafter(low, -infinity);
        high = std::nextafter(high, infinity);
    }
    return {low, high};
}

Rational integral_power(const Rational& base, std::uint64_t exponent) {
    Rational result = 1;
    Rational square = base;
    for (; exponent > 0; exponent >>= 1U) {
        if ((exponent & 1U) != 0) result *= square;
        if (exponent > 1) square *= square;
    }
    return result;
}

Integer floor_of(const Rational& value) {
    const Integer above = numerator(value);
    const Integer below = denominator(value);
    Integer quotient = above / below;
    if (above < 0 && quotient * below != above) --quotient;
    return quotient;
}

}  // namespace

Enclosure enclose(const Rational& value) {
    const auto near = value.convert_to<double>();
    if (!std::isfinite(near)) {
        const double most = std::numeric_limits<double>::max();
        return value > 0 ? Enclosure{most, infinity} : Enclosure{-infinity, -most};
    }
    Enclosure result{near, near};
    while (std::isfinite(result.low) && Rational(result.low) > value)
        result.low = std::nextafter(result.low, -infinity);
    while (std::isfinite(result.high) && Rational(result.high) < value)
        result.high = std::nextafter(result.high, infinity);
    return result;
}

Rational decimal(std::string_view text) {
    Integer digits = 0;
    long scale = 0;
    bool behind_point = false;
    std::size_t i = 0;
    for (; i < text.size() && text[i] != 'e' && text[i] != 'E'; ++i) {
        if (text[i] == '.') {
            behind_point = true;
            continue;
        }
        digits = digits * 10 + (text[i] - '0');
        if (behind_point) ++scale;
    }
    const long exponent = i < text.size() ? std::stol(std::string(text.substr(i + 1))) : 0;
    const long shift = exponent - scale;
    const Integer factor = boost::multiprecision::pow(Integer(10), static_cast<unsigned>(std::abs(shift)));
    return shift >= 0 ? Rational(digits * factor) : Rational(digits, factor);
}

Real::Real(Rational value) : value_(std::move(value)) {
    if (bits(numerator(value_)) <= most_bits && bits(denominator(value_)) <= most_bits) return;
    bounds_ = enclose(value_);
    exact_ = false;
    value_ = 0;
}

Real::Real(Enclosure bounds) : bounds_(bounds) {
    exact_ = bounds.is_exact() && std::isfinite(bounds.low);
    if (exact_) value_ = Rational(bounds.low);
}

std::optional<int> Real::compare(const Real& other) const {
    if (exact_ && other.exact_) {
        if (value_ < other.value_) return -1;
        return value_ == other.value_ ? 0 : 1;
    }
    const Enclosure a = bounds();
    const Enclosure b = other.bounds();
    if (a.high < b.low) return -1;
    if (a.low > b.high) return 1;
    if (std::isinf(a.low) && a == b) return a.is_exact() ? std::optional(0) : std::nullopt;
    return std::nullopt;
}

std::string fraction_text(const Rational& value) {
    if (denominator(value) == 1) return numerator(value).str();
    const double near = value.convert_to<double>();
    std::string text = fmt::format("{}", near);
    if (text.find('e') == std::string::npos && text.size() < 12 &&
        decimal(text[0] == '-' ? text.substr(1) : text) == abs(value))
        return text;
    return value.str();
}

std::string Real::text() const {
    if (exact_) return fraction_text(value_);
    if (bounds_.is_exact()) return bounds_.low > 0 ? "Infinity" : "-Infinity";  // finite exact values are fractions
    const auto side = [](double bound) {
        if (!std::isinf(bound)) return fmt::format("{}", bound);
        return std::string(bound > 0 ? "Infinity" : "-Infinity");
    };
    return fmt::format("between {} and {}", side(bounds_.low), side(bounds_.high));
}

bool Real::is_infinite() const {
    return !exact_ && std::isinf(bounds_.low) && bounds_.low == bounds_.high;
}

bool Real::finite() const {
    return exact_ || (std::isfinite(bounds_.low) && std::isfinite(bounds_.high));
}

namespace {

bool is_zero(const Real& a) {
    return a.is_exact() && a.value() == 0;
}

bool may_be_zero(const Real& a) {
    if (a.is_exact()) return a.value() == 0;
    return a.bounds().low <= 0 && a.bounds().high >= 0;
}

Real infinite(bool positive) {
    return positive ? Enclosure{infinity, infinity} : Enclosure{-infinity, -infinity};
}

/// Throws the error of an operation without a value. If `certain` is true, the operation has no value for any number of
/// the enclosure; otherwise it has no value for some of its numbers.
[[noreturn]] void no_value(bool certain, const std::string& what) {
    if (certain) throw std::domain_error(what + " has no value");
    throw Unclear("whether it is " + what + " is not known");
}

Real negate_real(const Real& a) {
    if (a.is_exact()) return Rational(-a.value());
    return Enclosure{-a.bounds().high, -a.bounds().low};
}

}  // namespace

Real operator+(const Real& a, const Real& b) {
    if (a.exact_ && b.exact_) return Rational(a.value_ + b.value_);
    const Enclosure left = a.bounds();
    const Enclosure right = b.bounds();
    const auto opposed = [](double most, double least) { return most == infinity && least == -infinity; };
    if (opposed(left.high, right.low) || opposed(right.high, left.low))
        no_value(a.is_infinite() && b.is_infinite(), "Infinity - Infinity");
    return left + right;
}

Real operator-(const Real& a, const Real& b) {
    if (a.exact_ && b.exact_) return Rational(a.value_ - b.value_);
    return a + negate_real(b);
}

Real operator*(const Real& a, const Real& b) {
    if (a.exact_ && b.exact_) return Rational(a.value_ * b.value_);
    if ((may_be_zero(a) && !b.finite()) || (may_be_zero(b) && !a.finite()))
        no_value((is_zero(a) && b.is_infinite()) || (is_zero(b) && a.is_infinite()), "0 * Infinity");
    return a.bounds() * b.bounds();
}

Real operator/(const Real& a, const Real& b) {
    const Enclosure dividend = a.bounds();
    const Enclosure divisor = b.bounds();
    if (may_be_zero(b)) {
        if (may_be_zero(a)) no_value(is_zero(a) && is_zero(b), "0/0");
        if (is_zero(b)) return infinite(a.exact_ ? a.value_ > 0 : dividend.low > 0);
        if (dividend.low < 0 || divisor.low < 0) return Enclosure{-infinity, infinity};
        return Enclosure{(Enclosure{dividend.low, dividend.low} / Enclosure{divisor.high, divisor.high}).low, infinity};
    }
    if (a.exact_ && b.exact_) return Rational(a.value_ / b.value_);
    if (!a.finite() && !b.finite()) no_value(a.is_infinite() && b.is_infinite(), "Infinity/Infinity");
    return dividend / divisor;
}

namespace {

/// Returns a power whose base or exponent is known to be infinite.
Real infinite_power(const Real& base, const Real& exponent) {
    const auto compared = [](const Real& a, std::int64_t b) { return a.compare(Real(b)); };
    if (base.is_infinite()) {
        const std::optional<int> sign = compared(exponent, 0);
        if (!sign || base.bounds().low < 0) throw Unclear("a power of infinity is not known");
        if (*sign > 0) return base;
        return Real(std::int64_t{*sign == 0 ? 1 : 0});
    }
    const std::optional<int> order = compared(base, 1);
    if (!order || compared(base, 0) == -1) throw Unclear("a power to infinity is not known");
    if (*order == 0) no_value(true, "1 to the power of Infinity");
    const bool grows = (*order > 0) == (exponent.bounds().low > 0);
    return grows ? infinite(true) : Real(std::int64_t{0});
}

}  // namespace

Real power(const Real& base, const Real& exponent) {
    const bool whole = exponent.is_exact() && denominator(exponent.value()) == 1;
    if (is_zero(exponent)) return Real(std::int64_t{1});
    if (base.is_infinite() || exponent.is_infinite()) return infinite_power(base, exponent);
    if (whole && base.is_exact()) {
        const bool negative = exponent.value() < 0;
        if (base.value() == 0) return negative ? infinite(true) : base;
        const unsigned size = std::max(bits(numerator(base.value())), bits(denominator(base.value())));
        if (abs(exponent.value()) * size <= most_bits) {
            const Rational result = integral_power(base.value(), abs(exponent.value()).convert_to<std::uint64_t>());
            return negative ? Rational(1 / result) : result;
        }
    }
    const Enclosure b = base.bounds();
    const Enclosure e = exponent.bounds();
    if (!base.finite() || !exponent.finite()) throw Unclear("a power of numbers that may be infinite is not known");
    if (b.low < 0) {
        if (exponent.is_exact() && !whole && b.high < 0)
            no_value(true, "a power of a negative number with an exponent that is not whole");
        throw Unclear("a power of a number that may be negative is not known");
    }
    Enclosure result{infinity, -infinity};
    for (const double x : {b.low, b.high})
        for (const double y : {e.low, e.high}) {
            const Enclosure corner = widen_by_rounding(std::pow(x, y));
            result.low = std::min(result.low, std::max(corner.low, 0.0));
            result.high = std::max(result.high, corner.high);
        }
    return result;
}

namespace {

Enclosure enclosed_logarithm(double value) {
    if (value == 0) return {-infinity, -infinity};
    if (std::isinf(value)) return {infinity, infinity};
    return widen_by_rounding(std::log(value));
}

Real natural_logarithm(const Real& value) {
    const Enclosure v = value.bounds();
    if (value.is_exact() && value.value() == 1) return Real(std::int64_t{0});
    if (v.low < 0) no_value(v.high < 0, "the logarithm of a negative number");
    return Enclosure{enclosed_logarithm(v.low).low, enclosed_logarithm(v.high).high};
}

}  // namespace

Real logarithm(const Real& value, const Real& base) {
    // The logarithm of a whole power of the base, such as log(8,2), is exact.
    if (value.is_exact() && value.value() > 0 && base.is_exact() && base.value() > 1) {
        const double near = std::round(std::log(value.bounds().low) / std::log(base.bounds().low));
        if (std::abs(near) <= 4096 && power(base, Real(static_cast<std::int64_t>(near))).compare(value) == 0)
            return Real(static_cast<std::int64_t>(near));
    }
    return natural_logarithm(value) / natural_logarithm(base);
}

Real extreme_of(const Real& a, const Real& b, bool least) {
    if (const std::optional<int> order = b.compare(a)) {
        const bool better = least ? *order < 0 : *order > 0;
        return better ? b : a;
    }
    const Enclosure left = a.bounds();
    const Enclosure right = b.bounds();
    if (least) return Enclosure{std::min(left.low, right.low), std::min(left.high, right.high)};
    return Enclosure{std::max(left.low, right.low), std::max(left.high, right.high)};
}

std::optional<Rational> floor_of(const Real& value) {
    if (value.is_exact()) {
        const Integer whole = floor_of(value.value());
        return Rational(whole);
    }
    if (value.is_infinite()) throw std::domain_error("Infinity is not an integer");
    const Enclosure bounds = value.bounds();
    const double low = std::floor(bounds.low);
    if (!std::isfinite(low) || low != std::floor(bounds.high)) return std::nullopt;
    return Rational(low);
}

}  // namespace robochart::prism
