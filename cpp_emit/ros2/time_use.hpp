// SPDX-License-Identifier: Apache-2.0
// Finds what makes the behaviour of a component depend on the number of its cycles. Without such an element, tock does
// not change the state of the model, so cycles may have any length (docs/ros2.md, "Immediate dispatch").
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics/source.hpp"
#include "cpp_emit/plan/component.hpp"

namespace robochart::cpp_emit::ros2 {

/// An element that counts time.
struct TimeUse {
    std::string text;  ///< "reads a clock"
    diagnostics::Span span;
};

/// The first element of the component that counts time; no value if there is none.
[[nodiscard]] std::optional<TimeUse> find_time_use(const Component&);

}  // namespace robochart::cpp_emit::ros2
