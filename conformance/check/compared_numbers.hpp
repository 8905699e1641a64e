// SPDX-License-Identifier: Apache-2.0
// Computes the two sides of a comparison of the model as the code on the robot computes them, for reports.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "conformance/check/numbers_to_try.hpp"
#include "semantics/data/value_model.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// The two numbers that the code compares.
struct ComparedNumbers {
    std::string left;
    std::string right;
    bool answer = false;
};

/// Computes the sides of the comparison for a value of its type. Returns no value if the comparison contains operations
/// other than sums, differences and multiples.
[[nodiscard]] std::optional<ComparedNumbers> compare_on_robot(const ir::System& system,
                                                              const ir::ModelComparison& comparison,
                                                              const NumberSpace& space, const TriedValue& value);

/// An operand of the comparison that reads no variable, computed as the code computes it. No value for other operands.
[[nodiscard]] std::optional<double> constant_on_robot(const ir::System& system, const ir::ModelComparison& comparison,
                                                      std::int64_t scale, const ir::Expr& operand);

}  // namespace robochart::conformance
