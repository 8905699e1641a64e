// SPDX-License-Identifier: Apache-2.0
// Finds a value for each combination of truth values that linear conditions can have. Private to this component.
//
// Conditions such as `x < 5` and `y - x > 1` divide the space of values into regions. All points of a region give the
// same sign to each linear form. The candidates are weighted means of n + 1 vertices, for all choices of vertices.
// Statement: every nonempty region contains a candidate. Reason: in a box that contains all intersections, the regions
// are polytopes. A mean of d + 1 affinely independent vertices of a polytope of dimension d, with positive weights, is
// in its relative interior. Each vertex is an intersection of n hyperplanes of the conditions and of the box (Ziegler,
// Lectures on Polytopes, 1995, chapter 2).
//
// `if c then a else b` has one of two forms, and the condition c divides the space, too. `a % c` with a constant c > 0
// is equal to a - q*c for some whole number q. Suppose that the conditions read only one number, and read it only
// inside remainders by one constant c. Then they are periodic in this number, with period c, because coefficients are
// whole numbers. So candidates with 0 <= x < c are sufficient, and only finitely many q occur for them. The thresholds
// are those of all forms, and the numbers at which a remainder becomes 0 again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "semantics/data/linear_form.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"
#include "semantics/ir/number_parts.hpp"

namespace robochart::ir {

/// Piecewise linear conditions on the value of one place.
class LinearConditions {
public:
    /// The instantiation contains the scale and the budget. Long searches for points poll this budget.
    LinearConditions(const System& system, const Instantiation& instantiation)
        : system_(system), instantiation_(instantiation), scale_(instantiation.scale) {}

    /// Adds a condition that reads only one place. Returns false unless it is a Boolean combination of comparisons
    /// whose operands are linear terms, choices between linear terms, or remainders of these. `closed` evaluates
    /// expressions without variables.
    [[nodiscard]] bool add(const Expr& condition, const ClosedValue& closed);
    /// Adds a form: the sum of coefficients times numbers, plus the constant in units. Returns false if the constant or
    /// a coefficient is too large.
    [[nodiscard]] bool add_form(const std::map<NumberPart, std::int64_t>& coefficients, std::int64_t constant);
    /// Returns the form of each comparison: the coefficients that are not 0, by number, and the constant in
    /// units.
    [[nodiscard]] std::vector<std::pair<std::map<NumberPart, std::int64_t>, std::int64_t>> forms() const;
    /// Returns the sign of each form at a point.
    [[nodiscard]] std::vector<int> signs_at(const std::vector<std::int64_t>& point) const;
    [[nodiscard]] bool has_remainders() const { return period_.has_value(); }
    /// Returns the numbers that the conditions read.
    [[nodiscard]] const std::vector<NumberPart>& components() const { return components_; }
    /// Returns at least one point for each combination of signs that the linear forms can have. A point contains the
    /// numbers of the components: units, or whole numbers for nat and int. Returns no value if there are too many
    /// points, or if a coordinate is not a decimal number.
    [[nodiscard]] std::optional<std::vector<std::vector<std::int64_t>>> points() const;
    /// Returns `count` points for each combination of signs that the linear forms can have, or all points if there are
    /// fewer. Returns no value if the search finds too few, or if the conditions contain remainders.
    [[nodiscard]] std::optional<std::vector<std::vector<std::int64_t>>> points_in_regions(std::size_t count) const;

private:
    __extension__ using Wide = __int128;
    using Point = std::vector<std::int64_t>;

    [[nodiscard]] bool add_condition(const Expr& condition);
    [[nodiscard]] bool add_comparison(const Expr& left, const Expr& right);
    [[nodiscard]] bool add_membership(const Expr& condition);
    void insert_form(const LinearForm& form);
    [[nodiscard]] LinearReader::Forms read_part(const Expr& expr);
    [[nodiscard]] LinearReader::Forms read_component(const Expr& expr);
    [[nodiscard]] LinearReader::Forms read_choice(const Expr& expr);
    [[nodiscard]] LinearReader::Forms read_remainder(const Expr& expr);
    [[nodiscard]] LinearReader::Forms remainders(const LinearForm& dividend);
    [[nodiscard]] std::optional<std::vector<Point>> all_points() const;
    [[nodiscard]] std::optional<std::vector<Point>> real_points() const;
    [[nodiscard]] std::optional<std::vector<Point>> whole_points(std::int64_t beside, std::size_t count) const;
    [[nodiscard]] bool is_only_point(const std::vector<int>& signs) const;
    [[nodiscard]] std::optional<std::vector<Point>> fill_region(Point first, const std::vector<Point>& corners,
                                                                std::size_t count) const;
    [[nodiscard]] std::size_t index_of(const NumberPart& component);
    [[nodiscard]] std::optional<std::vector<LinearForm>> with_box() const;
    [[nodiscard]] std::optional<std::vector<Point>> vertices(const std::vector<LinearForm>& forms) const;
    [[nodiscard]] std::vector<int> signs(const Point& point) const;

    const System& system_;
    const Instantiation& instantiation_;
    std::int64_t scale_;                  ///< the number of units that represent 1
    std::optional<LinearReader> reader_;  ///< reads the condition that is being added
    std::vector<NumberPart> components_;
    std::vector<LinearForm> forms_;
    std::optional<std::int64_t> period_;  ///< the divisor of all remainders, in units
    int remainders_open_ = 0;             ///< how many remainders contain the part that is being read
    bool is_periodic_ = true;             ///< every number read so far is inside a remainder
};

}  // namespace robochart::ir
