// What the names of an expression stand for, and what is wrong where it has no value.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// An expression has no value: division by zero, index out of range, beyond 64 bits.
class EvaluationFault : public std::runtime_error {
public:
    EvaluationFault(const std::string& cause, diagnostics::Span where) : std::runtime_error(cause), span(where) {}
    diagnostics::Span span;
};

/// What the names of a machine's expressions stand for. Vectors may be shorter than the machine's where an expression
/// does not use the rest; using a missing one is a fault.
struct Environment {
    std::vector<Value> variables;      ///< by VariableId
    std::vector<Value> constants;      ///< by ConstantId
    std::vector<std::int64_t> clocks;  ///< by ClockId, in time units; sinceEntry clocks included
    std::optional<Value> trigger;      ///< the value a trigger brings
};

}  // namespace robochart::ir
