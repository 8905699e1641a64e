// SPDX-License-Identifier: Apache-2.0
// Arguments that are never read are not part of a state, so a run does not contain their values. For display, this file
// repeats the run in a session of the same script in which states contain all arguments.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "checker/process/behaviour.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::cspm {

/// Whether a description contains an omitted value: `Done(_,1)`.
[[nodiscard]] bool leaves_values_out(std::string_view description);
/// Whether the first description can result from the second one by omission of some values.
[[nodiscard]] bool matches_description(std::string_view with_places, std::string_view with_values);

/// A run of terms.
struct WholeRun {
    process::TermId initial;
    std::vector<process::Transition> steps;
};

/// Returns the run of `initial` whose steps have the event names of `run` and whose states match the descriptions in
/// `run`. No value if there is no such run, or if finding it takes too much work.
[[nodiscard]] std::optional<WholeRun> whole_run(process::OperationalSemantics& semantics,
                                                const process::EventTable& events, process::TermId initial,
                                                const std::string& description, const std::vector<refine::Step>& run,
                                                const process::EventTable& events_of_run);

/// The same behaviour with each event replaced by `other`.
void translate(process::Behaviour& behaviour, const std::function<process::Event(process::Event)>& other);

}  // namespace robochart::cspm
