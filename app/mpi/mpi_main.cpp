// robochart-verify-mpi: the command, whose searches are shared by all ranks that mpirun starts (docs/scale.md).
#include <signal.h>

#include <cstdio>
#include <exception>

#include "app/command/run.hpp"
#include "app/mpi/mpi_exchange.hpp"
#include "app/verbs/verbs.hpp"
#include "checker/ranks/served_ranks.hpp"

namespace {

using robochart::app::Exit;
using robochart::app::MpiExchange;
using robochart::app::MpiProgram;
using robochart::app::Options;

/// Rank 0: the command as ever, with a strategy for its searches.
int command(int argc, char** argv, MpiExchange& exchange) {
    robochart::ranks::ServedRanks ranks(exchange);
    return robochart::app::run_command("robochart-verify-mpi", argc, argv, [&ranks](const Options& given) {
        Options options = given;
        options.by_levels = &ranks;
        return robochart::app::run_verb(options);
    });
}

/// Signals are for rank 0, which ends the searches of all.
int serve(MpiExchange& exchange) {
    for (const int each : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) signal(each, SIG_IGN);
    robochart::ranks::serve(exchange);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const MpiProgram program(argc, argv);
    try {
        MpiExchange exchange;
        return exchange.rank() == 0 ? command(argc, argv, exchange) : serve(exchange);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "robochart-verify-mpi: an internal error: %s\n", error.what());
        MpiProgram::abort(static_cast<int>(Exit::internal));
    }
}
