// SPDX-License-Identifier: Apache-2.0
// Values that satisfy linear conditions in every possible combination. Private to this component.
//
// Conditions such as `x < 5` and `y - x > 1` divide the space of values into regions: the sets of points at which each
// linear form has the same sign. Statement: every nonempty region has a candidate. Reason: the regions within a box
// that contains all intersections are polytopes; the relative interior of a polytope of dimension d contains every
// weighted mean, with positive weights, of d + 1 vertices that are affinely independent; every vertex is an
// intersection of n hyperplanes of the conditions and of the box (Ziegler, Lectures on Polytopes, 1995, chapter 2). The
// candidates are the means of all choices of n + 1 vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// The value of an expression without variables, in units of the sampling scale; no value if it has none.
using ClosedValue = std::function<std::optional<Value>(const Expr&)>;

/// A number in a place: the place itself, or a part of its value.
struct Component {
    std::vector<std::size_t> path;  ///< positions of parts, from the outside
    TypeKind kind = TypeKind::real;
    friend auto operator<=>(const Component&, const Component&) = default;
};

/// Linear conditions about the value of one place.
class LinearConditions {
public:
    /// The instantiation has the scale, and the budget, which long searches for points poll.
    LinearConditions(const System& system, const Instantiation& instantiation)
        : system_(system), instantiation_(instantiation), scale_(instantiation.scale) {}

    /// Adds a condition that reads only one place. False if it is not a Boolean combination of linear comparisons.
    /// `closed` evaluates expressions without variables.
    [[nodiscard]] bool add(const Expr& condition, const ClosedValue& closed);
    /// The numbers that the conditions read.
    [[nodiscard]] const std::vector<Component>& components() const { return components_; }
    /// For every combination of signs that the linear forms can have, at least one point: the numbers of the components
    /// in units, whole numbers for nat and int. No value if there are too many, or if a point is no decimal.
    [[nodiscard]] std::optional<std::vector<std::vector<std::int64_t>>> points() const;

private:
    [[nodiscard]] bool add_condition(const Expr& condition);
    __extension__ using Wide = __int128;
    using Point = std::vector<std::int64_t>;
    /// The sum of coefficient times component, plus the constant, in units.
    struct Form {
        std::map<std::size_t, std::int64_t> coefficients;
        std::int64_t constant = 0;
        friend auto operator<=>(const Form&, const Form&) = default;
    };

    [[nodiscard]] bool add_comparison(const Expr& left, const Expr& right);
    [[nodiscard]] bool add_membership(const Expr& condition);
    [[nodiscard]] std::optional<Form> read_form(const Expr& expr);
    [[nodiscard]] std::optional<Form> read_closed(const Expr& expr) const;
    [[nodiscard]] std::optional<Form> read_component(const Expr& expr);
    [[nodiscard]] static std::optional<Form> combine(const Form& a, const Form& b, std::int64_t factor);
    [[nodiscard]] std::optional<std::vector<Point>> real_points() const;
    [[nodiscard]] std::optional<std::vector<Point>> whole_points() const;
    [[nodiscard]] std::optional<std::vector<Form>> with_box() const;
    [[nodiscard]] std::optional<std::vector<Point>> vertices(const std::vector<Form>& forms) const;
    [[nodiscard]] std::vector<int> signs(const Point& point) const;

    const System& system_;
    const Instantiation& instantiation_;
    std::int64_t scale_;  ///< units of one
    ClosedValue closed_;  ///< of the condition that is added
    std::vector<Component> components_;
    std::vector<Form> forms_;
};

}  // namespace robochart::ir
