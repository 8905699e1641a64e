// SPDX-License-Identifier: Apache-2.0
// Defines the exception for errors in a script. The evaluator throws no other type for them.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "base/diagnostics/source.hpp"

namespace robochart::cspm {

/// An error found during evaluation: `error(…)`, no matching clause, division by zero, infinite set, endless recursion…
/// It contains the place of the error and the CSPM call stack, innermost call first.
class EvaluationError : public std::runtime_error {
public:
    EvaluationError(const std::string& message, diagnostics::Span place, std::vector<std::string> calls)
        : std::runtime_error(message), span(place), stack(std::move(calls)) {}
    diagnostics::Span span;
    std::vector<std::string> stack;
};

}  // namespace robochart::cspm
