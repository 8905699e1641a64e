// SPDX-License-Identifier: Apache-2.0
// Adds omitted values to runs. A state omits arguments that are never read, so a run does not contain their values. To
// display them, the run is repeated in another session of the script, whose states contain all arguments.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "checker/process/behaviour.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::cspm {

/// Returns true if a description contains an omitted value, as `Done(_,1)` does.
[[nodiscard]] bool leaves_values_out(std::string_view description);
/// Returns true if the first description is the second one with some values omitted.
[[nodiscard]] bool matches_description(std::string_view with_places, std::string_view with_values);

/// A run of terms.
struct WholeRun {
    process::TermId initial;
    std::vector<process::Transition> steps;
};

/// Searches a run from `initial` whose steps have the same event names as `run` and whose states match the descriptions
/// in `run`. Returns no value if there is none, or if the search takes too much work.
[[nodiscard]] std::optional<WholeRun> whole_run(process::OperationalSemantics& semantics,
                                                const process::EventTable& events, process::TermId initial,
                                                const std::string& description, const std::vector<refine::Step>& run,
                                                const process::EventTable& events_of_run);

/// Replaces each event of the behaviour by its image under `other`.
void translate(process::Behaviour& behaviour, const std::function<process::Event(process::Event)>& other);

}  // namespace robochart::cspm
