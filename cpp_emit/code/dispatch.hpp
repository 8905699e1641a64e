// SPDX-License-Identifier: Apache-2.0
// Writes the event API of a component: `Event` and `dispatch(state, event, platform)`, in addition to `step`.
#pragma once

#include <string>
#include <vector>

#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/expressions/generation.hpp"

namespace robochart::cpp_emit {

/// Returns the events that the platform may raise one by one, in the order of Inputs. RoboSim has none.
[[nodiscard]] std::vector<const EventPort*> input_events(const Component&);
/// Returns the events that drop others in the declared order. After dispatch() of such an event, the state records this
/// until time passes.
[[nodiscard]] std::vector<const EventPort*> dropping_events(const Generation&);
/// Writes code that removes dropped events from the inputs.
void write_drops(const Generation&, CodeWriter&);
/// Writes code for the moment when time passes: events raised earlier no longer drop others.
void forget_raised(const Generation&, CodeWriter&);
/// Returns the name of the enumeration of these events: `Event`, unless a type of the model has that name.
[[nodiscard]] std::string event_type(const Generation&);
/// Writes the enumeration `Event`.
void write_event_type(const Generation&, CodeWriter&);
/// Writes Step::dispatch. `direct` is the text of the function if the programs of the machine never wait. Otherwise it
/// is "", and dispatch runs a cycle with one input.
void write_dispatch(const Generation&, const std::string& direct, CodeWriter&);
/// Returns the members of Inputs whose values contain lists. Such a list may exceed its capacity.
[[nodiscard]] std::vector<std::string> list_inputs(const Generation&);
/// Writes the functions of the event API in the core's namespace.
void write_dispatch_functions(const Generation&, CodeWriter&);

}  // namespace robochart::cpp_emit
