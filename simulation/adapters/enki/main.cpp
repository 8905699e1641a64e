// robochart-simulate-enki SCENARIO: the verb `simulate` in Enki. This program is linked with Enki and therefore GPL-2+.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <vector>

#include "app/simulate.hpp"
#include "simulation/adapters/enki/enki_stage.hpp"

int main(int argc, char** argv) {
    using robochart::app::Exit;
    std::vector<const char*> words{"robochart-simulate-enki", "simulate"};
    words.insert(words.end(), argv + 1, argv + argc);
    try {
        const auto parsed = robochart::app::parse_command_line(static_cast<int>(words.size()), words.data());
        if (!parsed.options) {
            fmt::print(parsed.exit == Exit::success ? stdout : stderr, "{}", parsed.message);
            return static_cast<int>(parsed.exit);
        }
        return static_cast<int>(
            robochart::app::run_simulate(*parsed.options, {"Enki", robochart::simulation::enki_stage, false}));
    } catch (const std::exception& error) {
        fmt::print(stderr, "robochart-simulate-enki: a fault of this program: {}\n", error.what());
        return static_cast<int>(Exit::internal);
    }
}
