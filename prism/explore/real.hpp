// SPDX-License-Identifier: Apache-2.0
// Computes with the real numbers of models. A number is an exact fraction as long as possible, and otherwise an
// enclosure. Decimal literals are fractions; logarithms and roots are usually not.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "prism/markov/model/model.hpp"
#include "prism/markov/solve/enclosure.hpp"

namespace robochart::prism {

using markov::Enclosure;
using markov::Rational;

/// Returns the doubles around a fraction; both are equal to the fraction if it is a double.
[[nodiscard]] Enclosure enclose(const Rational& value);
/// Reads a decimal literal, such as "1.5e-3".
[[nodiscard]] Rational decimal(std::string_view text);

/// Thrown if it is unknown whether an operation has a value, or if its numbers are too large to compute it.
class Unclear : public std::domain_error {
public:
    using std::domain_error::domain_error;
};

/// An exact fraction, an enclosure of another number, or infinity. x/0 is infinite and has the sign of x. Zeros have no
/// sign.
class Real {
public:
    Real() = default;
    Real(Rational value);  // NOLINT: every fraction is a real number
    explicit Real(std::int64_t value) : Real(Rational(value)) {}
    Real(Enclosure bounds);  // NOLINT

    [[nodiscard]] bool is_exact() const { return exact_; }
    [[nodiscard]] const Rational& value() const { return value_; }  ///< valid if exact
    [[nodiscard]] Enclosure bounds() const { return exact_ ? enclose(value_) : bounds_; }
    [[nodiscard]] bool is_infinite() const;  ///< known to be infinite
    [[nodiscard]] bool finite() const;       ///< known to be finite
    /// Returns -1, 0 or 1 for less than, equal to or greater than. Returns no value if the enclosures overlap.
    [[nodiscard]] std::optional<int> compare(const Real& other) const;
    /// Returns a text such as "1/3", "0.25" or "between 0.1 and 0.2".
    [[nodiscard]] std::string text() const;

    // The operators throw std::domain_error if there is no value, as in 0/0 and Infinity - Infinity, and Unclear.
    friend Real operator+(const Real& a, const Real& b);
    friend Real operator-(const Real& a, const Real& b);
    friend Real operator*(const Real& a, const Real& b);
    friend Real operator/(const Real& a, const Real& b);

private:
    bool exact_ = true;
    Rational value_;
    Enclosure bounds_;
};

// The following functions throw std::domain_error if there is no value, and Unclear.
[[nodiscard]] Real power(const Real& base, const Real& exponent);
[[nodiscard]] Real logarithm(const Real& value, const Real& base);
/// Returns the lesser or the greater of two numbers. If they cannot be compared, returns an enclosure of the result.
[[nodiscard]] Real extreme_of(const Real& a, const Real& b, bool least);
/// Returns the greatest integer that is not greater than the number, or no value if the enclosure does not determine
/// it. Throws std::domain_error for infinity.
[[nodiscard]] std::optional<Rational> floor_of(const Real& value);
/// Returns the text of a fraction: as a decimal if that is short, otherwise as a fraction.
[[nodiscard]] std::string fraction_text(const Rational& value);

}  // namespace robochart::prism
