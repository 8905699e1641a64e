// SPDX-License-Identifier: Apache-2.0
// Runs other programs within the budget of a run.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/budget.hpp"

namespace robochart::diagnostics {

/// Runs a program, which is found through PATH. Its output and errors are written to the file `log`. Returns its exit
/// status. If it cannot be run, returns -1 and sets `error`. Polls the budget 50 times a second. If a limit is reached,
/// kills the program and all its child processes, and throws LimitReached.
int run_program(const std::vector<std::string>& command, const std::string& log, std::string& error,
                Budget* budget = nullptr);

}  // namespace robochart::diagnostics
