// Parameters that nothing reads: of a definition they are handed on at most, to parameters that nothing reads either.
// Calls that differ in these alone are the same process (live-variable analysis; Aho, Lam, Sethi, Ullman, 9.2.5).
#pragma once

#include "checker/cspm/eval/code.hpp"

namespace robochart::cspm {

/// Fills Function::unread of all functions of the program that take their arguments in one group.
void find_unread_parameters(Program& program);

}  // namespace robochart::cspm
