// Calls of functions that somebody wants to know of: which values were really asked for while processes were explored.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "diagnostics/source.hpp"

namespace robochart::cspm {

/// One evaluation of a call of a watched function.
struct ObservedCall {
    std::string function;
    diagnostics::Span span;                           ///< of the call
    std::vector<std::optional<std::int64_t>> values;  ///< the arguments that are numbers, in their places
    std::optional<std::int64_t> result;               ///< if it is a number
};

/// Top-level functions to be observed, and the callback.
struct CallObserver {
    std::set<std::string> functions;
    std::function<void(const ObservedCall&)> tell;
};

}  // namespace robochart::cspm
