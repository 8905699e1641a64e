// SPDX-License-Identifier: Apache-2.0
// Describes calls of observed functions: the arguments and results that the exploration of processes evaluated.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/diagnostics/source.hpp"

namespace robochart::cspm {

/// One evaluation of a call of an observed function.
struct ObservedCall {
    std::string function;
    diagnostics::Span span;                           ///< place of the call
    std::vector<std::optional<std::int64_t>> values;  ///< for each argument: the value, if it is a number
    std::optional<std::int64_t> result;               ///< the result if it is a number
};

/// The top-level functions to observe, and the function that receives their calls.
struct CallObserver {
    std::set<std::string> functions;
    std::function<void(const ObservedCall&)> tell;
};

}  // namespace robochart::cspm
