// SPDX-License-Identifier: Apache-2.0
// Makes monitors for the controllers of a simulation (`simulate --monitor`).
#pragma once

#include <memory>

#include "app/command/options.hpp"
#include "app/verbs/simulate.hpp"

namespace robochart::app {

/// This message is printed before the results of the trials if a guard could not follow all events that it checks.
inline constexpr const char* not_all_watched = "--monitor could not follow all that it asks for: not decided\n";

/// Makes the guard that `--monitor` selects: the model's monitors, the monitors of a rule file, or the claims of a
/// file. It also follows the claims that the scenario accepts. Returns null if there is nothing to follow. If the guard
/// cannot be built, reports a diagnostic and returns null.
[[nodiscard]] std::unique_ptr<simulation::Guard> make_guard(Simulation&, const Options&);

}  // namespace robochart::app
