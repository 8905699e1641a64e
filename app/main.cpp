// SPDX-License-Identifier: Apache-2.0
// The entry point of the command robochart-verify.
#include "app/command/run.hpp"
#include "app/verbs/verbs.hpp"

int main(int argc, char** argv) {
    return robochart::app::run_command("robochart-verify", argc, argv, robochart::app::run_verb);
}
