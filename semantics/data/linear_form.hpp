// SPDX-License-Identifier: Apache-2.0
// Reads numeric expressions as linear forms. Private to this component.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Returns the value of an expression without variables, in units of the sampling scale. Returns no value if it is
/// undefined.
using ClosedValue = std::function<std::optional<Value>(const Expr&)>;

/// A sum of coefficients times components, plus a constant. Numbers are in units of the sampling scale. Constants are
/// below 2^56 and coefficients below 2^20. So sums of three products, and determinants of three rows (sums of six
/// products), fit into 128 bits.
struct LinearForm {
    std::map<std::size_t, std::int64_t> coefficients;  ///< by the index of the component; no coefficient is 0
    std::int64_t constant = 0;
    friend auto operator<=>(const LinearForm&, const LinearForm&) = default;
};

/// Limits for the absolute values of constants and coefficients.
inline constexpr std::int64_t greatest_coordinate = std::int64_t{1} << 56U;
inline constexpr std::int64_t greatest_coefficient = std::int64_t{1} << 20U;

/// Returns a + factor * b, or no value if it exceeds the limits.
[[nodiscard]] std::optional<LinearForm> add_multiple(const LinearForm& a, const LinearForm& b, std::int64_t factor);

/// Reads sums, differences and multiples as linear forms. Calls another function for the operands.
class LinearReader {
public:
    /// A set of forms. For any values of the components, one of the forms equals the expression. There is no value if
    /// the expression has no such set.
    using Forms = std::optional<std::set<LinearForm>>;
    using ReadPart = std::function<Forms(const Expr&)>;

    /// `closed` evaluates expressions without variables. `read_part` reads everything except sums, differences and
    /// multiples.
    LinearReader(const System& system, std::int64_t scale, ClosedValue closed, ReadPart read_part)
        : system_(system), scale_(scale), closed_(std::move(closed)), read_part_(std::move(read_part)) {}

    [[nodiscard]] Forms read(const Expr& expr) const;
    /// Returns the form of a numeric expression without variables.
    [[nodiscard]] std::optional<LinearForm> read_closed(const Expr& expr) const;

private:
    [[nodiscard]] Forms read_sum(const Expr& expr, std::int64_t factor) const;
    [[nodiscard]] Forms read_multiple(const Expr& expr) const;

    const System& system_;
    std::int64_t scale_;  ///< the number of units that represent 1
    ClosedValue closed_;
    ReadPart read_part_;
};

}  // namespace robochart::ir
