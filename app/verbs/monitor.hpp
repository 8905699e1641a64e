// SPDX-License-Identifier: Apache-2.0
// Monitors for the controllers of a simulation (`simulate --monitor`).
#pragma once

#include <memory>

#include "app/command/options.hpp"
#include "app/verbs/simulate.hpp"

namespace robochart::app {

/// This message is printed before the results of the trials if a guard could not follow all events that it checks.
inline constexpr const char* not_all_watched = "--monitor could not follow all that it asks for: not decided\n";

/// The guard that `--monitor` selects: the model's monitors, those of a rule file, or the claims of a file; and the
/// claims that the scenario accepts. Null if there is nothing to follow. If the guard cannot be built, reports a
/// diagnostic and returns null.
[[nodiscard]] std::unique_ptr<simulation::Guard> make_guard(Simulation&, const Options&);

}  // namespace robochart::app
