// SPDX-License-Identifier: Apache-2.0
// For reports: computes the two sides of a comparison in the model as the code on the robot computes them.
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

/// Computes both sides of the comparison for a value of its type. Supports sums, differences, multiples, and the number
/// of one window in a sequence of reals. Returns no value if the comparison contains anything else.
[[nodiscard]] std::optional<ComparedNumbers> compare_on_robot(const ir::System& system,
                                                              const ir::ModelComparison& comparison,
                                                              const NumberSpace& space, const TriedValue& value);

/// Returns the answer of the model for the explored value `place`, and so for all values of the same region.
[[nodiscard]] bool answer_in_model(const ir::ModelComparison& comparison, const NumberSpace& space,
                                   const TriedValue& value, std::size_t place);

}  // namespace robochart::conformance
