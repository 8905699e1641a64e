// Runs as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runs/run.hpp"

namespace robochart::runs {

/// What happens: "input a with 3 (t1: S1 -> S2)".
/// Whether a run says the step: one inside where it changes something or shows what a machine decides to do.
[[nodiscard]] bool is_news(const Step&);
[[nodiscard]] std::string text(const Event&);
/// The same with what others do in the same step.
[[nodiscard]] std::string text(const Event&, const std::vector<Event>& with);
/// The values of a machine that may change: "x = 1, y = 2"; "" if it has none.
[[nodiscard]] std::string values_text(const Machine&);
/// Where a machine is, and its values: "in S1, x = 1".
[[nodiscard]] std::string text(const Machine&);

/// One line a step, internal steps without news left out; then where the run ends, and why that is wrong.
[[nodiscard]] std::string text(const Run&, std::string_view indent);

}  // namespace robochart::runs
