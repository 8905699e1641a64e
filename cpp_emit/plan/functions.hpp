// Functions that the model specifies by contract, over the finite carriers: what the explorer computes them by.
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

/// Where the function's value is another than the default of its type, by semantics/evaluate. Throws std::length_error
/// if there are too many arguments to try, or too many rows.
[[nodiscard]] std::vector<FunctionValue> values_of(const ir::System&, const ir::Instantiation&, ir::FunctionId);

}  // namespace robochart::cpp_emit
