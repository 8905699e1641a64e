// SPDX-License-Identifier: Apache-2.0
// Adds omitted values to runs. Arguments that are never read are not part of a state, so a run does not contain their
// values. For display, the run is repeated in a session of the same script in which states contain all arguments.
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
/// Returns true if omitting some values of the second description can give the first description.
[[nodiscard]] bool matches_description(std::string_view with_places, std::string_view with_values);

/// A run of terms.
struct WholeRun {
    process::TermId initial;
    std::vector<process::Transition> steps;
};

/// Returns the run of `initial` whose steps have the event names of `run` and whose states match the descriptions in
/// `run`. Returns no value if no such run exists, or if finding it takes too much work.
[[nodiscard]] std::optional<WholeRun> whole_run(process::OperationalSemantics& semantics,
                                                const process::EventTable& events, process::TermId initial,
                                                const std::string& description, const std::vector<refine::Step>& run,
                                                const process::EventTable& events_of_run);

/// Replaces each event of the behaviour by its image under `other`.
void translate(process::Behaviour& behaviour, const std::function<process::Event(process::Event)>& other);

}  // namespace robochart::cspm
