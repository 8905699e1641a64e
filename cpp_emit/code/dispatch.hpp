// The event API of a component: `Event` and `dispatch(state, event, platform)`, beside `step`.
#pragma once

#include <string>
#include <vector>

#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/expressions/generation.hpp"

namespace robochart::cpp_emit {

/// Events that the platform raises, in the order of Inputs.
[[nodiscard]] std::vector<const EventPort*> input_events(const Component&);
/// The enumeration of these: `Event`, unless the model has a type of that name.
[[nodiscard]] std::string event_type(const Generation&);
/// The enumeration itself.
void write_event_type(const Generation&, CodeWriter&);
/// Step::dispatch; `direct`: the text of it for a machine whose programs never wait, "" for others, which run as in a
/// cycle with one input.
void write_dispatch(const Generation&, const std::string& direct, CodeWriter&);
/// The functions of the namespace.
void write_dispatch_functions(const Generation&, CodeWriter&);

}  // namespace robochart::cpp_emit
