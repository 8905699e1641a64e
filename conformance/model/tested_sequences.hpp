// SPDX-License-Identifier: Apache-2.0
// Represents logged sequences of numbers by sequences of the model. The component must only store received sequences,
// and test their sizes and the numbers of windows (docs/data.md, "Flow classes"). Then two sequences with the same
// answers to these tests have the same effect, so a sequence of each class represents the class.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "cpp_emit/plan/component.hpp"
#include "semantics/data/value_model.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// A comparison of the number of a window, or of the size (no window), with a threshold.
struct SequenceTest {
    std::optional<ir::SequenceWindow> window;
    double threshold = 0;
};

/// The tests of a component on sequences of one type.
struct SequenceTests {
    std::vector<SequenceTest> tests;
    /// By the signs of the tests: a sequence of the carrier.
    std::map<std::vector<int>, ir::Value> sequences;

    /// Returns, for each test, the sign of the number minus the threshold, or 2 if the window contains no place of the
    /// sequence.
    [[nodiscard]] std::vector<int> signs_at(std::span<const double> items) const;
};

/// The tests on sequences, by the index of the sequence's type, and the comparisons that make these tests.
struct TestedSequences {
    std::map<std::uint32_t, SequenceTests> types;
    std::set<const ir::Expr*> comparisons;
};

/// Returns the value model of a component that receives sequences of numbers, sends none, and only stores and tests
/// them. Returns no value for other components.
[[nodiscard]] std::optional<ir::ValueModel> model_of_sequences(const ir::System&, const ir::Instantiation&,
                                                               const cpp_emit::Component&);

/// Returns the tests on sequences for which the instantiation has representatives, one sequence of each class
/// (conformance/traces/more_numbers.hpp). The result is empty if it has none.
[[nodiscard]] TestedSequences tested_sequences(const ir::System&, const ir::Instantiation&, const cpp_emit::Component&);

}  // namespace robochart::conformance
