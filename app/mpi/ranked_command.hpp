// What each program of robochart-verify-mpi does between the beginning and the end of MPI.
#pragma once

#include "checker/refine/levels/exchange.hpp"

namespace robochart::app {

/// Blocks the signals that end a run, for this thread and those that it starts. To be called before MPI starts threads:
/// one of them would take a signal, and the system would end the program.
void block_signals();

/// The first program is the command; the others serve its searches, and leave signals to it. In each as many threads
/// search as `--threads` of the command says, one without it. Returns the exit code. Where an error has met one program
/// alone, so that others wait for it, it ends all, with the code of this error. Called by the thread that has begun
/// MPI.
int ranked_command(int argc, char** argv, refine::Exchange& exchange);

}  // namespace robochart::app
