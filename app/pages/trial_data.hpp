// The recorded trials as data for the script of a page: where each robot is and the state of each of its machines,
// frame by frame, in few letters.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "diagnostics/json.hpp"
#include "simulation/report/pictures.hpp"
#include "simulation/report/run.hpp"

namespace robochart::app {

/// What of a run a page shows, so that it stays small: trials with their numbers from 0, robots, and of the recorded
/// times one in `every`, and the last.
struct ShownTrials {
    std::vector<std::size_t> trials;
    std::size_t robots = 0;
    std::size_t every = 1;
};

/// Trials that stopped come first, then those outside of a band, then the first ones. `most_letters`: of all positions.
[[nodiscard]] ShownTrials shown_trials(const simulation::Scenario&, const simulation::RunResult&, std::size_t machines,
                                       std::size_t most_letters = 650'000);

/// A number from 0 to 4095 as two of the letters A-Z a-z 0-9 - _.
[[nodiscard]] std::string two_letters(std::size_t number);

/// A frame: for each robot x, y (from the left and the top, 4095 is the whole width and height), the heading (4096 is a
/// whole turn counter-clockwise), and the number of the state of each machine, each in two letters.
[[nodiscard]] std::string frame_letters(const simulation::View&, const simulation::Frame&, std::size_t robots,
                                        std::size_t machines);

/// `view`, `robots`, `machines` (how many) and `trials[]`: `number` (from 1), `times[]` and `frames[]`.
[[nodiscard]] diagnostics::Json trials_json(const simulation::View&, const simulation::RunResult&, const ShownTrials&,
                                            std::size_t machines);

}  // namespace robochart::app
