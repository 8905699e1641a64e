// SPDX-License-Identifier: Apache-2.0
// The program robochart-simulate-argos SCENARIO, which runs the verb `simulate` in ARGoS.
#include "app/verbs/simulate.hpp"
#include "simulation/adapters/argos/argos_stage.hpp"

int main(int argc, char** argv) {
    return robochart::app::simulate_program("robochart-simulate-argos", argc, argv,
                                            {"ARGoS", robochart::simulation::argos_stage, false});
}
