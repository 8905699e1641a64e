// SPDX-License-Identifier: Apache-2.0
// Finds sequences for each combination of answers that conditions on windows can have. Private to this component.
//
// A window is a set of places of a sequence, as in `min(ran(extract([31, 90], scan))) < near`. The windows divide the
// places into cells: two places are in one cell if they are in the same windows. Statement: for every sequence there is
// a candidate for which all conditions have the same answers. Reason: (1) The least number in a window is the least of
// the least numbers in its cells. So a sequence may be replaced by one that contains in each cell only the cell's least
// number (for `max`, the greatest). (2) Only the length of the sequence determines which cells contain elements, and
// this changes only at the first place of a cell. (3) The answer of a comparison with a constant changes only at this
// constant. Step 1 requires that all windows use `min`, or all use `max`. `min(ran(scan))` reads the window of all
// places. The places after the last place of the other windows are one cell, so its first place represents all of them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "semantics/data/linear.hpp"
#include "semantics/data/window.hpp"

namespace robochart::ir {

/// Conditions on a sequence of numbers in one place.
class SequenceConditions {
public:
    /// `scale` is the number of units that represent 1.
    SequenceConditions(const System& system, std::int64_t scale) : system_(system), scale_(scale) {}

    /// Adds a condition that reads only the sequence. Returns false unless it is a Boolean combination of comparisons
    /// of window numbers, or of the size, with constants. `closed` evaluates expressions without variables.
    [[nodiscard]] bool add(const Expr& condition, const ClosedValue& closed);
    /// Returns the candidates, or no value if there are too many. Elements have the type `element`. At places that are
    /// in no window, candidates have the element `other`.
    [[nodiscard]] std::optional<std::vector<Value>> values(TypeId element, const Value& other) const;

    /// True if some windows use `min` and others use `max`. In that case there are no candidates.
    [[nodiscard]] bool has_both_extremes() const;

    /// Adds a comparison of the number in a window, or of the size, with a threshold. Returns false if the threshold or
    /// the size is too large.
    [[nodiscard]] bool add_threshold(const SequenceWindow& window, std::int64_t threshold);
    [[nodiscard]] bool add_size(std::int64_t size);
    /// A comparison of the number in a window, or of the size (no window), with a threshold.
    struct Comparison {
        std::optional<SequenceWindow> window;
        std::int64_t threshold = 0;
    };
    [[nodiscard]] std::vector<Comparison> comparisons() const;
    /// Returns, for each comparison, the sign of the number minus the threshold. Returns 2 for a window without any
    /// item of the sequence.
    [[nodiscard]] std::vector<int> signs_at(const Value& sequence) const;

    /// Returns the greatest number with which the conditions compare the size, or no value if a condition reads
    /// elements.
    [[nodiscard]] std::optional<std::int64_t> greatest_size() const {
        if (!windows_.empty()) return std::nullopt;
        return sizes_.empty() ? 0 : *sizes_.rbegin();
    }

private:
    [[nodiscard]] bool add_condition(const Expr& condition);
    [[nodiscard]] bool add_comparison(const Expr& subject, const Expr& with);
    [[nodiscard]] bool add_window(const Expr& extremum, std::int64_t threshold);
    [[nodiscard]] std::map<std::vector<std::size_t>, std::vector<std::int64_t>> cells() const;
    [[nodiscard]] std::vector<std::int64_t> lengths() const;
    [[nodiscard]] std::vector<std::int64_t> numbers_beside(const std::vector<std::size_t>& windows, TypeKind) const;
    [[nodiscard]] std::int64_t unit_of(TypeKind) const;

    const System& system_;
    std::int64_t scale_;
    ClosedValue closed_;  ///< evaluates the parts of the current condition that have no variables
    std::vector<SequenceWindow> windows_;
    std::vector<std::set<std::int64_t>> thresholds_;  ///< the thresholds of each window, in the unit of its numbers
    std::set<std::int64_t> sizes_;                    ///< numbers with which the size is compared
};

}  // namespace robochart::ir
