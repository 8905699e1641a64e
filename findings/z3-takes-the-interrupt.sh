#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Z3's library takes an interrupt that was meant for the program that uses it.
#
# Expected: a program that has its own handler of SIGINT and asks the library a question has its handler called when
#   somebody presses Ctrl-C, as during any other call.
# Observed: during `Z3_solver_check` the library has a handler of its own. The question ends with the answer `unknown`,
#   the program's handler is not called, and nothing says that there was an interrupt. With the parameter `ctrl_c` of
#   the solver set to false, the program's handler is called, and the question goes on.
# Why it matters: a planner or a checker on a robot stops its motors or writes a checkpoint in its handler. If it takes
#   `unknown` for "too hard", it goes on with the next question, and the operator has to interrupt again and again.
# usage: findings/z3-takes-the-interrupt.sh; needs g++ and Debian 12's apt to download two packages; exit code 0 if the
# behaviour is as described.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -q libz3-4=4.8.12-3.1 libz3-dev=4.8.12-3.1 >/dev/null 2>&1
for package in *.deb; do dpkg -x "$package" .; done
libraries=$(dirname "$(find . -name 'libz3.so.4')")

cat > ask.cpp <<'END'
#include <z3++.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <string>
#include <thread>

volatile std::sig_atomic_t interrupted = 0;

// Asks for a proof of the pigeonhole principle for 13 pigeons, which takes far longer than the three seconds allowed, and
// interrupts the program after one second.
int main(int, char** arguments) {
    const int holes = 12;
    std::signal(SIGINT, [](int) { interrupted = 1; });
    z3::context context;
    z3::solver solver(context, "QF_UF");
    for (int pigeon = 0; pigeon <= holes; ++pigeon) {
        z3::expr somewhere = context.bool_val(false);
        for (int hole = 0; hole < holes; ++hole) {
            const auto name = [&](int bird) { return std::to_string(bird) + "_" + std::to_string(hole); };
            const z3::expr here = context.bool_const(name(pigeon).c_str());
            somewhere = somewhere || here;
            for (int other = 0; other < pigeon; ++other) solver.add(!here || !context.bool_const(name(other).c_str()));
        }
        solver.add(somewhere);
    }
    z3::params parameters(context);
    parameters.set("timeout", 3000U);
    if (std::string(arguments[1]) == "no") parameters.set("ctrl_c", false);
    solver.set(parameters);
    std::thread operator_(+[] {
        std::this_thread::sleep_for(std::chrono::seconds(1));
        std::raise(SIGINT);
    });
    const auto start = std::chrono::steady_clock::now();
    const z3::check_result answer = solver.check();
    const auto seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    operator_.join();
    std::cout << (interrupted ? "handler called" : "handler not called") << ", "
              << (answer == z3::unknown ? "unknown" : "decided") << (seconds < 2.5 ? " early" : " at the limit") << '\n';
}
END
g++ -O1 -std=c++17 -Iusr/include ask.cpp -L"$libraries" -l:libz3.so.4 -o ask
export LD_LIBRARY_PATH="$folder/$libraries"
echo "Z3 4.8.12"
usual=$(./ask usual)
without=$(./ask no)
echo "as it is:         $usual"
echo "ctrl_c = false:   $without"
[ "$usual" = "handler not called, unknown early" ] && [ "$without" = "handler called, unknown at the limit" ]
