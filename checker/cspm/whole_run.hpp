// Arguments that nothing reads are no part of a state, so that a run does not have their values. Here it is taken again
// in the same script with all arguments kept, for whoever reads it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "checker/process/behaviour.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::cspm {

/// Whether a description has the place of an argument without its value: `Done(_,1)`.
[[nodiscard]] bool leaves_values_out(std::string_view description);
/// Whether the description could be the other one's with some values left out.
[[nodiscard]] bool describes(std::string_view with_places, std::string_view with_values);

/// A run of terms.
struct WholeRun {
    process::TermId initial;
    std::vector<process::Transition> steps;
};

/// The run of `initial` with the same steps, by the names of their events, through states of which those of `run` are
/// the descriptions; none where there is none, or it is not found with little work.
[[nodiscard]] std::optional<WholeRun> whole_run(process::OperationalSemantics& semantics,
                                                const process::EventTable& events, process::TermId initial,
                                                const std::string& description, const std::vector<refine::Step>& run,
                                                const process::EventTable& events_of_run);

/// The same behaviour with each event as `other` says.
void translate(process::Behaviour& behaviour, const std::function<process::Event(process::Event)>& other);

}  // namespace robochart::cspm
