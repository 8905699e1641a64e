// SPDX-License-Identifier: Apache-2.0
// Sequences that satisfy conditions about windows in every possible combination. Private to this component.
//
// A window is a set of places of a sequence, as in `min(ran(extract([31, 90], scan))) < near`. The windows divide the
// places into cells: two places are in one cell if they are in the same windows. Statement: for every sequence there is
// a candidate for which each condition has the same value. Reason: the least number in a window is the least of the
// least numbers in its cells, so a sequence may be replaced by one that has in each cell only the cell's least number
// (for `max`, the greatest); which cells have places depends on the length alone, and changes only at the first place
// of a cell; and a comparison with a constant changes only at this constant. Therefore all windows use `min`, or all
// use `max`.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "semantics/data/linear.hpp"
#include "semantics/data/window.hpp"

namespace robochart::ir {

/// Conditions about a sequence of numbers in one place.
class SequenceConditions {
public:
    /// `scale`: units of one.
    SequenceConditions(const System& system, std::int64_t scale) : system_(system), scale_(scale) {}

    /// Adds a condition that reads only the sequence. False if it is not a Boolean combination of comparisons of
    /// windows and of the size with constants.
    /// `closed` evaluates expressions without variables.
    [[nodiscard]] bool add(const Expr& condition, const ClosedValue& closed);
    /// Candidates; no value if there are too many. `element`: the type of the elements; `other`: the element at places
    /// in no window.
    [[nodiscard]] std::optional<std::vector<Value>> values(TypeId element, const Value& other) const;

    /// Whether some windows use `min` and some `max`; there are no candidates then.
    [[nodiscard]] bool has_both_extremes() const;

    /// Adds a comparison of the number in a window, or of the size, with a threshold. False if it is too large.
    [[nodiscard]] bool add_threshold(const SequenceWindow& window, std::int64_t threshold);
    [[nodiscard]] bool add_size(std::int64_t size);
    /// A comparison of the number in a window, or of the size (no window), with a threshold.
    struct Comparison {
        std::optional<SequenceWindow> window;
        std::int64_t threshold = 0;
    };
    [[nodiscard]] std::vector<Comparison> comparisons() const;
    /// For each comparison, the sign of the number less the threshold; 2 if the sequence has no place in the window.
    [[nodiscard]] std::vector<int> signs_at(const Value& sequence) const;

    /// The greatest size that the conditions compare the size with; no value if they read elements.
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
    ClosedValue closed_;  ///< of the condition that is added
    std::vector<SequenceWindow> windows_;
    std::vector<std::set<std::int64_t>> thresholds_;  ///< of each window, in the unit of its numbers
    std::set<std::int64_t> sizes_;                    ///< numbers that the size is compared with
};

}  // namespace robochart::ir
