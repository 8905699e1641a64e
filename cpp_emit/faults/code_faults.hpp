// SPDX-License-Identifier: Apache-2.0
// Seeds faults in generated code: a line of the core is deleted, repeated or changed. The IR cannot express these
// faults. An example is a value that is not cleared, advanced, awaited or consumed.
#pragma once

#include <string>

#include "cpp_emit/faults/mutation.hpp"

namespace robochart::cpp_emit {

/// Returns the text of NAME_core.hpp with the fault. The text is unchanged if the fault of this run does not change
/// lines.
[[nodiscard]] std::string faulty_code(std::string text, Mutation&);

}  // namespace robochart::cpp_emit
