// SPDX-License-Identifier: Apache-2.0
// Encodes recorded trials as compact data for the script of a page. The data contain the position of each robot and the
// state of each of its machines, frame by frame.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/diagnostics/json.hpp"
#include "simulation/report/pictures.hpp"
#include "simulation/report/run.hpp"

namespace robochart::app {

/// The data that a page shows, limited so that the page stays small. They contain some of the trials (numbered from 0)
/// and some of the robots. They contain every `every`-th of the recorded points in time, and the last.
struct ShownTrials {
    std::vector<std::size_t> trials;
    std::size_t robots = 0;
    std::size_t every = 1;
};

/// Selects trials so that the data of all selected trials have at most `most_letters` characters. Trials that stopped
/// are selected first, then trials with a measure outside its band, then the others by number.
[[nodiscard]] ShownTrials shown_trials(const simulation::Scenario&, const simulation::RunResult&, std::size_t machines,
                                       std::size_t most_letters = 650'000);

/// Encodes a number from 0 to 4095 as two of the characters A-Z a-z 0-9 - _.
[[nodiscard]] std::string two_letters(std::size_t number);

/// Encodes a frame. Each number has two characters. For each robot, the numbers are x, y (from the left and the top;
/// 4095 is the whole width and height), the heading (4096 is a full turn counter-clockwise), and the state of each
/// machine.
[[nodiscard]] std::string frame_letters(const simulation::View&, const simulation::Frame&, std::size_t robots,
                                        std::size_t machines);

/// Returns an object with `view`, `robots`, `machines` (their number) and `trials[]`. Each trial has `number` (from 1),
/// `times[]` and `frames[]`.
[[nodiscard]] diagnostics::Json trials_json(const simulation::View&, const simulation::RunResult&, const ShownTrials&,
                                            std::size_t machines);

}  // namespace robochart::app
