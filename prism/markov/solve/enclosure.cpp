// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/solve/enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace robochart::markov {
namespace {

double next_below(double value) {
    return std::nextafter(value, -infinity);
}

double next_above(double value) {
    return std::nextafter(value, infinity);
}

/// Returns an enclosure of the exact sum. In Knuth's two-sum, which this function uses, the error of the sum is a
/// double.
Enclosure sum(double left, double right) {
    const double rounded = left + right;
    if (std::isinf(left) || std::isinf(right)) return {rounded, rounded};
    const double part = rounded - left;
    const double error = (left - (rounded - part)) + (right - part);  // NaN near overflow
    return {error >= 0 ? rounded : next_below(rounded), error <= 0 ? rounded : next_above(rounded)};
}

/// Returns an enclosure of the product. 0 * infinity is 0, because an infinite bound is the limit of finite ones.
Enclosure product(double left, double right) {
    if (left == 0 || right == 0) return {0, 0};
    const double rounded = left * right;
    if (std::isinf(left) || std::isinf(right)) return {rounded, rounded};
    // The error of a product is a double only if the product is far from underflow.
    const bool error_is_exact = std::abs(rounded) > 1e-250 && !std::isinf(rounded);
    if (error_is_exact && std::fma(left, right, -rounded) == 0) return {rounded, rounded};
    return {next_below(rounded), next_above(rounded)};
}

Enclosure quotient(double left, double right) {
    if (left == 0) return {0, 0};
    const double rounded = left / right;
    if (std::isinf(left)) return {rounded, rounded};
    if (std::isinf(right)) return {0, 0};
    const bool error_is_exact = std::abs(rounded) > 1e-250 && std::abs(left) > 1e-250 && !std::isinf(rounded);
    if (error_is_exact && std::fma(rounded, right, -left) == 0) return {rounded, rounded};
    return {next_below(rounded), next_above(rounded)};
}

/// Returns the hull of an operation's results for all pairs of bounds of two enclosures.
template <class Operation>
Enclosure hull_of_corners(Enclosure left, Enclosure right, Operation operation) {
    const Enclosure corners[] = {operation(left.low, right.low), operation(left.low, right.high),
                                 operation(left.high, right.low), operation(left.high, right.high)};
    Enclosure result = corners[0];
    for (const Enclosure corner : corners)
        result = {std::min(result.low, corner.low), std::max(result.high, corner.high)};
    return result;
}

}  // namespace

double Enclosure::middle() const {
    if (low == high) return low;
    if (std::isinf(low) && std::isinf(high)) return 0;
    if (std::isinf(low)) return low;
    if (std::isinf(high)) return high;
    return std::clamp(low / 2 + high / 2, low, high);
}

double Enclosure::relative_width() const {
    if (is_exact()) return 0;
    const double greatest = std::max(std::abs(low), std::abs(high));
    if (std::isinf(greatest)) return infinity;
    return next_above(next_above(high - low) / greatest);
}

Enclosure operator+(Enclosure left, Enclosure right) {
    return {sum(left.low, right.low).low, sum(left.high, right.high).high};
}

Enclosure operator-(Enclosure left, Enclosure right) {
    return left + Enclosure{-right.high, -right.low};
}

Enclosure operator*(Enclosure left, Enclosure right) {
    return hull_of_corners(left, right, product);
}

Enclosure operator/(Enclosure left, Enclosure right) {
    if (right.low <= 0 && right.high >= 0) return {-infinity, infinity};
    return hull_of_corners(left, right, quotient);
}

Enclosure complement(Enclosure probability) {
    const Enclosure result = Enclosure{1, 1} - probability;
    return {std::clamp(result.low, 0.0, 1.0), std::clamp(result.high, 0.0, 1.0)};
}

}  // namespace robochart::markov
