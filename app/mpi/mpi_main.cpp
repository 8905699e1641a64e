// SPDX-License-Identifier: Apache-2.0
// The program robochart-verify-mpi: robochart-verify with searches that are distributed over all ranks that mpirun
// starts (docs/scale.md).
#include "app/mpi/ranked_command.hpp"

#include "app/mpi/mpi_exchange.hpp"

int main(int argc, char** argv) {
    robochart::app::block_signals();
    const robochart::app::MpiProgram program(argc, argv);
    robochart::app::MpiExchange exchange;
    return robochart::app::ranked_command(argc, argv, exchange);
}
