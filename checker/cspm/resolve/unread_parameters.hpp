// SPDX-License-Identifier: Apache-2.0
// Finds parameters that are never read. Passing a parameter to another parameter that is never read does not count as
// reading it. Calls that differ only in such parameters are the same process. This is an analysis of live variables
// (Aho, Lam, Sethi, Ullman, 9.2.5).
#pragma once

#include "checker/cspm/eval/code.hpp"

namespace robochart::cspm {

/// Sets Function::unread for each function of the program with a single group of arguments.
void find_unread_parameters(Program& program);

}  // namespace robochart::cspm
