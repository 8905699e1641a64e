// SPDX-License-Identifier: Apache-2.0
// The single exception type of the evaluator: an error in the script, found during evaluation.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "base/diagnostics/source.hpp"

namespace robochart::cspm {

/// An error found during evaluation: `error(…)`, no matching clause, division by zero, infinite set, endless recursion…
/// Contains the place and the CSPM call stack, innermost first.
class EvaluationError : public std::runtime_error {
public:
    EvaluationError(const std::string& message, diagnostics::Span place, std::vector<std::string> calls)
        : std::runtime_error(message), span(place), stack(std::move(calls)) {}
    diagnostics::Span span;
    std::vector<std::string> stack;
};

}  // namespace robochart::cspm
