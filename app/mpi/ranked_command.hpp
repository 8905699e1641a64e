// SPDX-License-Identifier: Apache-2.0
// Runs the command of robochart-verify-mpi after the initialisation of MPI and before its finalisation.
#pragma once

#include "checker/refine/levels/exchange.hpp"

namespace robochart::app {

/// Blocks the signals that end a run, in this thread and in threads that it starts. Must be called before MPI starts
/// threads. Otherwise, one of these threads could receive a signal, and the system would end the program.
void block_signals();

/// Runs the command in rank 0. The other ranks serve its searches and ignore signals. Each rank searches with the
/// number of threads given by `--threads`, or one by default. Returns the exit code. If an error occurs in one rank
/// while others wait for it, all ranks are ended with the code of this error. Must be called by the thread that
/// initialised MPI.
int ranked_command(int argc, char** argv, refine::Exchange& exchange);

}  // namespace robochart::app
