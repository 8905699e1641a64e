// SPDX-License-Identifier: Apache-2.0
// The program robochart-simulate-enki SCENARIO, which runs the verb `simulate` in Enki. It is linked with Enki and is
// therefore GPL-2+.
#include "app/verbs/simulate.hpp"
#include "simulation/adapters/enki/enki_stage.hpp"

int main(int argc, char** argv) {
    return robochart::app::simulate_program("robochart-simulate-enki", argc, argv,
                                            {"Enki", robochart::simulation::enki_stage, false});
}
