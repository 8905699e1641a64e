// Functions of generated code that visit the values of a type.
#pragma once

#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/expressions/generation.hpp"

namespace robochart::cpp_emit {

/// `any_Nat` and the like: functions of Step that visit the values of a type.
void write_carriers(const Generation&, CodeWriter&);

}  // namespace robochart::cpp_emit
