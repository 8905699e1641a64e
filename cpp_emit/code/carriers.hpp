// SPDX-License-Identifier: Apache-2.0
// Writes functions of generated code that visit the values of a type.
#pragma once

#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/expressions/generation.hpp"

namespace robochart::cpp_emit {

/// Writes `any_Nat` and similar functions of Step, which visit the values of a type.
void write_carriers(const Generation&, CodeWriter&);

}  // namespace robochart::cpp_emit
