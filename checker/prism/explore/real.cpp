// See real.hpp.
#include "checker/prism/explore/real.hpp"

#include <fmt/format.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace robochart::prism {
namespace {

using Integer = boost::multiprecision::cpp_int;
constexpr double infinity = std::numeric_limits<double>::infinity();
/// Beyond that many bits a fraction is no longer kept.
constexpr unsigned most_bits = 1U << 15U;

unsigned bits(const Integer& value) {
    return value.is_zero() ? 0 : static_cast<unsigned>(msb(abs(value))) + 1;
}

/// Widened by a few units in the last place: what the mathematical library may be wrong by.
Enclosure around(double value) {
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
    exact_ = bounds.exact() && std::isfinite(bounds.low);
    if (exact_) value_ = Rational(bounds.low);
}

std::optional<int> Real::compare(const Real& other) const {
    if (exact_ && other.exact_) return value_ < other.value_ ? -1 : value_ == other.value_ ? 0 : 1;
    const Enclosure a = bounds();
    const Enclosure b = other.bounds();
    if (a.high < b.low) return -1;
    if (a.low > b.high) return 1;
    if (std::isinf(a.low) && a == b) return a.exact() ? std::optional(0) : std::nullopt;
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
    if (bounds_.exact()) return bounds_.low > 0 ? "Infinity" : "-Infinity";  // finite ones are fractions
    return fmt::format("between {} and {}", bounds_.low, bounds_.high);
}

Real operator+(const Real& a, const Real& b) {
    if (a.exact_ && b.exact_) return Rational(a.value_ + b.value_);
    return a.bounds() + b.bounds();
}

Real operator-(const Real& a, const Real& b) {
    if (a.exact_ && b.exact_) return Rational(a.value_ - b.value_);
    return a.bounds() - b.bounds();
}

Real operator*(const Real& a, const Real& b) {
    if (a.exact_ && b.exact_) return Rational(a.value_ * b.value_);
    return a.bounds() * b.bounds();
}

Real operator/(const Real& a, const Real& b) {
    const Enclosure divisor = b.bounds();
    if (b.exact_ ? b.value_ == 0 : divisor.low <= 0 && divisor.high >= 0) throw std::domain_error("division by zero");
    if (a.exact_ && b.exact_) return Rational(a.value_ / b.value_);
    return a.bounds() / divisor;
}

Real power(const Real& base, const Real& exponent) {
    if (exponent.exact() && denominator(exponent.value()) == 1) {
        const Rational& whole = exponent.value();
        const bool negative = whole < 0;
        if (base.exact()) {
            if (negative && base.value() == 0) throw std::domain_error("zero to a negative power");
            const unsigned size = std::max(bits(numerator(base.value())), bits(denominator(base.value())));
            if (abs(whole) * size <= most_bits) {
                const Rational result = integral_power(base.value(), abs(whole).convert_to<std::uint64_t>());
                return negative ? Rational(1 / result) : result;
            }
        }
    }
    const Enclosure b = base.bounds();
    const Enclosure e = exponent.bounds();
    if (b.low < 0)
        throw std::domain_error("power of a negative number with an exponent that is not whole or too large");
    if (b.low == 0 && e.low <= 0) throw std::domain_error("power of zero with an exponent that is not positive");
    Enclosure result{infinity, -infinity};
    for (const double x : {b.low, b.high})
        for (const double y : {e.low, e.high}) {
            const Enclosure corner = around(std::pow(x, y));
            result.low = std::min(result.low, std::max(corner.low, 0.0));
            result.high = std::max(result.high, corner.high);
        }
    return result;
}

Real logarithm(const Real& value, const Real& base) {
    const Enclosure v = value.bounds();
    const Enclosure b = base.bounds();
    if (v.low <= 0 || b.low <= 0) throw std::domain_error("logarithm of a number that is not positive");
    // Whole powers of the base, as log(8,2), are exact.
    if (value.exact() && base.exact() && base.value() > 1) {
        const double near = std::round(std::log(v.low) / std::log(b.low));
        if (std::abs(near) <= 4096 && power(base, Real(static_cast<std::int64_t>(near))).compare(value) == 0)
            return Real(static_cast<std::int64_t>(near));
    }
    const auto log = [](Enclosure x) { return Enclosure{around(std::log(x.low)).low, around(std::log(x.high)).high}; };
    return Real(log(v)) / Real(log(b));
}

std::optional<Rational> floor_of(const Real& value) {
    if (value.exact()) {
        const Integer whole = floor_of(value.value());
        return Rational(whole);
    }
    const Enclosure bounds = value.bounds();
    const double low = std::floor(bounds.low);
    if (!std::isfinite(low) || low != std::floor(bounds.high)) return std::nullopt;
    return Rational(low);
}

}  // namespace robochart::prism
