// SPDX-License-Identifier: Apache-2.0
// Runs robochart-verify-mpi with a seeded fault: one rank fails or pauses.
//
//   faulty_ranks NUMBER CALL error|memory|sleep ARGUMENT...    before call CALL of its exchange (from 0), rank NUMBER
//                                                              throws, or sleeps for three seconds
#include <cstdlib>
#include <string>

#include "app/mpi/mpi_exchange.hpp"
#include "app/mpi/ranked_command.hpp"
#include "tests/checker/ranks/faulty_exchange.hpp"

namespace {

using robochart::ranks::FaultyExchange;

FaultyExchange::Fault fault_of(const std::string& name) {
    if (name == "memory") return FaultyExchange::Fault::memory;
    if (name == "sleep") return FaultyExchange::Fault::sleep;
    return FaultyExchange::Fault::error;
}

}  // namespace

int main(int argc, char** argv) {
    robochart::app::block_signals();
    const robochart::app::MpiProgram program(argc, argv);
    if (argc < 4) return EXIT_FAILURE;
    robochart::app::MpiExchange exchange;
    const bool faulty = exchange.rank() == std::stoul(argv[1]);
    const FaultyExchange::Fault fault = fault_of(argv[3]);
    argv[3] = argv[0];
    argc -= 3;
    argv += 3;
    if (!faulty) return robochart::app::ranked_command(argc, argv, exchange);
    FaultyExchange wrong(exchange, std::stoul(argv[-1]), fault);
    return robochart::app::ranked_command(argc, argv, wrong);
}
