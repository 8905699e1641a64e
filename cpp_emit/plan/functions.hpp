// SPDX-License-Identifier: Apache-2.0
// Computes tables of functions that the model specifies only by contracts, over the finite carriers. The explorer takes
// the functions' values from these tables.
#pragma once

#include <vector>

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// One row of a function's table.
struct FunctionValue {
    std::vector<ir::Value> arguments;
    ir::Value result;
};

/// Returns the arguments for which the function's value differs from the default of its type. semantics/evaluate
/// computes the value. Throws std::length_error if there are too many arguments to try, or too many rows.
[[nodiscard]] std::vector<FunctionValue> values_of(const ir::System&, const ir::Instantiation&, ir::FunctionId);

}  // namespace robochart::cpp_emit
