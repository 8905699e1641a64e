// SPDX-License-Identifier: Apache-2.0
// Finds parameters that are never read. A definition may pass such a parameter only to other parameters that are never
// read. Calls that differ only in such parameters are the same process. This is an analysis of live variables (Aho,
// Lam, Sethi, Ullman, 9.2.5).
#pragma once

#include "checker/cspm/eval/code.hpp"

namespace robochart::cspm {

/// Fills in Function::unread for all functions of the program that take their arguments in one group.
void find_unread_parameters(Program& program);

}  // namespace robochart::cspm
