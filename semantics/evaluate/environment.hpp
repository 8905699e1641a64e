// SPDX-License-Identifier: Apache-2.0
// Stores the values of the names in an expression. Defines the error for an expression without a value.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Thrown by an expression without a value: division by zero, an index out of range, or a result beyond 64 bits.
class EvaluationFault : public std::runtime_error {
public:
    EvaluationFault(const std::string& cause, diagnostics::Span where) : std::runtime_error(cause), span(where) {}
    diagnostics::Span span;
};

/// The values of the names in the expressions of a machine. A vector may end early if the expression does not use the
/// names after it. The use of a missing value is a fault.
struct Environment {
    std::vector<Value> variables;      ///< indexed by VariableId
    std::vector<Value> constants;      ///< indexed by ConstantId
    std::vector<std::int64_t> clocks;  ///< indexed by ClockId, in time units; includes the clocks of sinceEntry
    std::optional<Value> trigger;      ///< the value received by a trigger
};

}  // namespace robochart::ir
