// SPDX-License-Identifier: Apache-2.0
// Prints runs as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "counterexample/run.hpp"

namespace robochart::runs {

/// Returns true if a printed run contains the step. An internal step is printed only if it changes a value or shows a
/// decision of a machine.
[[nodiscard]] bool is_news(const Step&);
[[nodiscard]] std::string text_of(const Event&);
/// Returns the text of an event, with the events of other components in the same step.
[[nodiscard]] std::string text_of(const Event&, const std::vector<Event>& with);
/// Returns the values of a machine that may change: "x = 1, y = 2". Returns "" if it has none.
[[nodiscard]] std::string values_text(const Machine&);
/// Returns the state of a machine and its values: "in S1, x = 1".
[[nodiscard]] std::string text_of(const Machine&);

/// Returns the text of a run: one line per step, and then the end of the run and the violation.
[[nodiscard]] std::string text_of(const Run&, std::string_view indent);

/// The visible inputs, outputs, calls and assignments of a run, and in timed runs the times at which they happen:
/// "input e with false at time 0; ...".
[[nodiscard]] std::string short_text_of(const Run&);

}  // namespace robochart::runs
