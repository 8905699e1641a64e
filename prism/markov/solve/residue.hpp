// SPDX-License-Identifier: Apache-2.0
// Implements integers modulo a prime: a field in which division is exact and numbers do not grow.
#pragma once

#include <cstdint>

namespace robochart::markov {

/// A residue class modulo `prime`, which must be a prime below 2^31.
template <std::uint32_t prime>
class Residue {
public:
    static_assert(prime < (1U << 31U));

    Residue() = default;
    /// `value` must be below the prime.
    explicit Residue(std::uint32_t value) : value_(value) {}

    /// Returns the member of the class from 0 to prime - 1.
    [[nodiscard]] std::uint32_t value() const { return value_; }

    Residue& operator+=(Residue other) {
        const std::uint32_t sum = value_ + other.value_;
        value_ = sum >= prime ? sum - prime : sum;
        return *this;
    }
    friend Residue operator*(Residue left, Residue right) {
        return Residue(static_cast<std::uint32_t>(std::uint64_t{left.value_} * right.value_ % prime));
    }
    /// Divides by `right`, which must not be 0.
    friend Residue operator/(Residue left, Residue right) { return left * right.inverse(); }
    friend bool operator==(Residue, Residue) = default;

private:
    /// Returns the inverse, which is the power prime - 2 (Fermat).
    [[nodiscard]] Residue inverse() const {
        Residue result(1);
        Residue square = *this;
        for (std::uint32_t exponent = prime - 2; exponent > 0; exponent /= 2) {
            if (exponent % 2 == 1) result = result * square;
            square = square * square;
        }
        return result;
    }

    std::uint32_t value_ = 0;
};

/// The greatest primes below 2^31.
inline constexpr std::uint32_t first_prime = 2'147'483'647;
inline constexpr std::uint32_t second_prime = 2'147'483'629;
inline constexpr std::uint32_t third_prime = 2'147'483'587;

/// Returns whether the residue is a valid divisor.
template <std::uint32_t prime>
[[nodiscard]] bool positive(Residue<prime> value) {
    return value.value() != 0;
}

}  // namespace robochart::markov
