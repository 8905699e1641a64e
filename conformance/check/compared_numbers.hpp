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
/// other than sums, differences, multiples, and the number of one window of a sequence of reals.
[[nodiscard]] std::optional<ComparedNumbers> compare_on_robot(const ir::System& system,
                                                              const ir::ModelComparison& comparison,
                                                              const NumberSpace& space, const TriedValue& value);

/// The answer of the comparison in the model, for explored value `place` or for a value of the same region.
[[nodiscard]] bool answer_in_model(const ir::ModelComparison& comparison, const NumberSpace& space,
                                   const TriedValue& value, std::size_t place);

}  // namespace robochart::conformance
