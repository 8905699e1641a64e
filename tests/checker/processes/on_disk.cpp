// SPDX-License-Identifier: Apache-2.0
#include "tests/checker/processes/on_disk.hpp"

#include <fstream>

#include "base/diagnostics/files.hpp"

namespace robochart::refine {

std::optional<Violation> OnDisk::search(lts::TransitionSystem& system, const LevelQuestion& question, Budget& budget,
                                        Statistics& statistics) {
    if (question.row_width(system.width()) == 0) return ThreadRanks(1).search(system, question, budget, statistics);
    std::string error;
    const diagnostics::TemporaryFolder folder("", error);
    LevelQuestion on_disk = question;
    on_disk.rows.folder = folder.path();
    on_disk.rows.run = "one run";
    std::ofstream(folder.path() + "/" + run_name) << on_disk.rows.run;
    on_disk.rows.every = std::chrono::hours(1);
    on_disk.rows.disk = true;
    on_disk.rows.most_bytes = std::uint64_t{2048} * ranks_;
    on_disk.rows.filter_bits = 1;
    on_disk.rows.reads_a_step = 0;
    const std::uint64_t before = statistics.rolled_back;
    std::optional<Violation> found = ThreadRanks(ranks_).search(system, on_disk, budget, statistics);
    rolled_back_ += statistics.rolled_back - before;
    return found;
}

}  // namespace robochart::refine
