// SPDX-License-Identifier: Apache-2.0
#include "app/mpi/ranked_command.hpp"

#include <sched.h>
#include <signal.h>

#include <array>
#include <cstdio>
#include <exception>
#include <new>

#include "app/command/command_line.hpp"
#include "app/command/output.hpp"
#include "app/command/run.hpp"
#include "app/mpi/command_identity.hpp"
#include "app/mpi/mpi_exchange.hpp"
#include "app/verbs/verbs.hpp"
#include "checker/ranks/served_ranks.hpp"

namespace robochart::app {
namespace {

constexpr std::array ending{SIGINT, SIGTERM, SIGHUP, SIGXCPU};

/// Warns if the program has fewer cores than threads. mpirun binds a program to one core unless more are requested.
void warn_of_few_cores(unsigned threads) {
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
    if (const unsigned cores = static_cast<unsigned>(CPU_COUNT(&allowed)); threads > cores)
        print_error("robochart-verify-mpi: {} threads share {} core{}: mpirun --bind-to none gives a program all\n",
                    threads, cores, cores == 1 ? "" : "s");
}

/// Runs the command of robochart-verify with distributed searches.
int run_ranked(int argc, char** argv, refine::Exchange& exchange) {
    ranks::ServedRanks served(exchange, command_identity());
    const int code = run_command("robochart-verify-mpi", argc, argv, [&served](const Options& given) {
        if (given.limits.threads > 1 && !MpiProgram::serves_threads())
            throw UsageError("--threads above 1 needs an MPI that serves a program with threads (MPI_THREAD_FUNNELED)");
        warn_of_few_cores(given.limits.threads);
        Options options = given;
        if (options.run != nullptr) options.run->search_by(served, command_identity());
        // mpirun connects its programs to its own terminals, even if the output of mpirun is redirected.
        if (options.output.color == Color::automatic) options.output.color = Color::never;
        return run_verb(options);
    });
    if (served.others_wait()) MpiProgram::abort(code);
    served.end();
    return code;
}

[[noreturn]] void end_all(unsigned program, Exit code, const char* why) {
    std::fprintf(stderr, "robochart-verify-mpi: program %u: %s; all programs end\n", program, why);
    MpiProgram::abort(static_cast<int>(code));
}

}  // namespace

void block_signals() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal_number : ending) sigaddset(&signals, signal_number);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

int ranked_command(int argc, char** argv, refine::Exchange& exchange) {
    try {
        if (exchange.rank() == 0) return run_ranked(argc, argv, exchange);
        allow_many_files();  // rank 0 calls it in run_command
        for (const int signal_number : ending) signal(signal_number, SIG_IGN);
        ranks::serve_searches(exchange, command_identity());
        return 0;
    } catch (const std::bad_alloc&) {
        end_all(exchange.rank(), Exit::inconclusive, "there is no more memory");
    } catch (const std::exception& error) {
        end_all(exchange.rank(), Exit::internal, error.what());
    }
}

}  // namespace robochart::app
