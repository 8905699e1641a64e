// Real numbers of models: exact fractions as long as they are that, else enclosures. Decimal literals are fractions;
// logarithms and roots are not.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "checker/markov/model/model.hpp"
#include "checker/markov/solve/enclosure.hpp"

namespace robochart::prism {

using markov::Enclosure;
using markov::Rational;

/// Doubles around a fraction; both the fraction itself where it is a double.
[[nodiscard]] Enclosure enclose(const Rational& value);
/// A decimal literal as it is written: "1.5e-3".
[[nodiscard]] Rational decimal(std::string_view text);

/// An exact fraction, or an enclosure of a number that is none, or infinite.
class Real {
public:
    Real() = default;
    Real(Rational value);  // NOLINT: every fraction is a real number
    explicit Real(std::int64_t value) : Real(Rational(value)) {}
    Real(Enclosure bounds);  // NOLINT

    [[nodiscard]] bool exact() const { return exact_; }
    [[nodiscard]] const Rational& value() const { return value_; }  ///< where exact
    [[nodiscard]] Enclosure bounds() const { return exact_ ? enclose(value_) : bounds_; }
    /// Less than, equal to, greater than 0 as -1, 0, 1; nothing where the enclosures overlap.
    [[nodiscard]] std::optional<int> compare(const Real& other) const;
    /// "1/3", "0.25", "between 0.1 and 0.2".
    [[nodiscard]] std::string text() const;

    friend Real operator+(const Real& a, const Real& b);
    friend Real operator-(const Real& a, const Real& b);
    friend Real operator*(const Real& a, const Real& b);
    /// Throws std::domain_error for a divisor that is, or may be, 0.
    friend Real operator/(const Real& a, const Real& b);

private:
    bool exact_ = true;
    Rational value_;
    Enclosure bounds_;
};

/// Throws std::domain_error where there is none.
[[nodiscard]] Real power(const Real& base, const Real& exponent);
[[nodiscard]] Real logarithm(const Real& value, const Real& base);
/// The greatest whole number that is not greater; nothing where the enclosure does not say.
[[nodiscard]] std::optional<Rational> floor_of(const Real& value);
/// A fraction for people: as a decimal where it is short, else as a fraction.
[[nodiscard]] std::string fraction_text(const Rational& value);

}  // namespace robochart::prism
