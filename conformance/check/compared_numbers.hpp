// SPDX-License-Identifier: Apache-2.0
// For reports: computes both sides of a comparison of the model in the same way as the code on the robot.
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

/// Returns the value of an operand of the comparison, computed as the code computes it. Returns no value if the operand
/// reads a variable.
[[nodiscard]] std::optional<double> constant_on_robot(const ir::System& system, const ir::ModelComparison& comparison,
                                                      std::int64_t scale, const ir::Expr& operand);

}  // namespace robochart::conformance
