// robochart-simulate-argos SCENARIO: the verb `simulate` in ARGoS.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <vector>

#include "app/simulate.hpp"
#include "simulation/adapters/argos/argos_stage.hpp"

int main(int argc, char** argv) {
    using robochart::app::Exit;
    std::vector<const char*> words{"robochart-simulate-argos", "simulate"};
    words.insert(words.end(), argv + 1, argv + argc);
    try {
        const auto parsed = robochart::app::parse_command_line(static_cast<int>(words.size()), words.data());
        if (!parsed.options) {
            fmt::print(parsed.exit == Exit::success ? stdout : stderr, "{}", parsed.message);
            return static_cast<int>(parsed.exit);
        }
        return static_cast<int>(
            robochart::app::run_simulate(*parsed.options, {"ARGoS", robochart::simulation::argos_stage, false}));
    } catch (const std::exception& error) {
        fmt::print(stderr, "robochart-simulate-argos: a fault of this program: {}\n", error.what());
        return static_cast<int>(Exit::internal);
    }
}
