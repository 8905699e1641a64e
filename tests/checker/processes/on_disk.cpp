#include "tests/checker/processes/on_disk.hpp"

#include "checker/refine/levels/disk_row_store.hpp"
#include "diagnostics/files.hpp"

namespace robochart::refine {

std::optional<Violation> OnDisk::search(lts::TransitionSystem& system, const LevelQuestion& question, Budget& budget,
                                        Statistics& statistics) {
    if (question.row_width(system.width()) == 0) return OneRank().search(system, question, budget, statistics);
    std::string error;
    const diagnostics::TemporaryFolder folder("", error);
    const auto make = [&](const LevelQuestion& asked, const lts::TransitionSystem& searched, Exchange& exchange) {
        KeptWhere where;
        where.folder = folder.path();
        where.kind.width = asked.row_width(searched.width());
        where.place = {exchange.rank(), exchange.ranks()};
        DiskRowStore::Bounds bounds;
        bounds.most_bytes = 2048;
        bounds.filter_bits = 1;
        bounds.reads_a_step = 0;
        bounds.report = [this](const DiskRowStore::Figures& figures) { rolled_back_ += figures.rolled_back; };
        return std::make_unique<DiskRowStore>(std::move(where), bounds);
    };
    if (ranks_ == 1) return OneRank(make).search(system, question, budget, statistics);
    return ThreadRanks(ranks_, make).search(system, question, budget, statistics);
}

}  // namespace robochart::refine
