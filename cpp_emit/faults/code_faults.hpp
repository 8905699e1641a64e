// Seeded faults in generated code: a line of the core that is lost, repeated or changed. For what the IR does not show
// and a line of code does: what is cleared, advanced, awaited or consumed.
#pragma once

#include <string>

#include "cpp_emit/faults/mutation.hpp"

namespace robochart::cpp_emit {

/// The text of NAME_core.hpp with the fault; unchanged where the kind of this run is none of lines.
[[nodiscard]] std::string faulty_code(std::string text, Mutation&);

}  // namespace robochart::cpp_emit
