// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/levels/kept_levels.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/escape.hpp"
#include "checker/storage/sort_rows.hpp"

namespace robochart::refine {

using lts::StateView;
using lts::Word;
using Words = std::vector<Word>;

std::string path_of(const char* what, const KeptWhere& where) {
    return fmt::format("{}/{}-{}-of-{}", where.folder, what, where.place.rank, where.place.ranks);
}

KeptLevels::KeptLevels(KeptWhere where)
    : where_(std::move(where)), files_({where_.folder, where_.kind, where_.place}) {}

/// Ranks can have different numbers of levels if they were killed while some of them closed a level or rolled back. The
/// levels that all ranks have are complete except for unsure rows, because a rank starts a level only when all ranks
/// have closed the previous level. The last of these levels is expanded again. This finds the rows of later levels,
/// including rows that were unsure.
void KeptLevels::load_checkpoint(SearchRecord& record, const TakeUnsure& unsure) {
    const std::vector<storage::Checkpoint> found = storage::read(where_.folder, where_.kind, where_.from);
    // If only some ranks have written the checkpoint with a number, this number is not used again.
    const std::uint64_t greatest = where_.from.greatest;
    if (found.empty()) {
        files_.number_from(greatest);
        return;
    }
    for (const storage::Checkpoint& checkpoint : found) check(checkpoint);
    const Level levels = std::ranges::min_element(found, [](const auto& one, const auto& other) {
                             return one.levels < other.levels;
                         })->levels;
    const bool same = found.size() == where_.place.ranks;
    if (same) {
        files_.adopt(found[where_.place.rank], *where_.budget);
        files_.forget_from(levels);
    } else {
        redistribute_rows(found, levels);
    }
    files_.number_from(greatest);
    const std::size_t width = where_.kind.width;
    const auto mine = [&](StateView row) { return !where_.mine || where_.mine(row); };
    for (const storage::Checkpoint& each : found) {
        if (same && each.place != where_.place) continue;
        const storage::FolderOf from{where_.folder, where_.kind, each.place};
        storage::LevelFiles::read_beside(from, each.marks, false, *where_.budget, [&](std::span<const Word> rows) {
            for (std::size_t at = 0; at < rows.size(); at += width)
                if (const StateView row = rows.subspan(at, width); mine(row)) record.marks.insert(row);
        });
        storage::LevelFiles::read_beside(from, each.unsure, true, *where_.budget, [&](std::span<const Word> rows) {
            for (std::size_t at = 0; at < rows.size(); at += width + 1) {
                const StateView row = rows.subspan(at, width);
                const Level level = rows[at + width];
                if (level >= each.levels)
                    throw storage::BadFile(fmt::format("{}/{}: it has rows of level {}, which is not closed",
                                                       diagnostics::escape_for_display(where_.folder), each.unsure.name,
                                                       level));
                if (level < levels && mine(row)) unsure(level, row);
            }
        });
        // Only the sums over all ranks matter. So if the number of ranks has changed, the first rank stores the
        // statistics of all former ranks.
        record.expanded.resize(levels - 1);
        if (!same && where_.place.rank != 0) continue;
        for (std::size_t level = 0; level < record.expanded.size(); ++level) {
            record.expanded[level].transitions += each.expanded[level].transitions;
            record.expanded[level].chased += each.expanded[level].chased;
        }
    }
}

/// Rejects a checkpoint that does not fit. It contains statistics for every level except the last one, so the size of
/// its file limits the number of levels that must be stored in memory.
void KeptLevels::check(const storage::Checkpoint& found) const {
    if (found.levels > found.expanded.size() + 1)
        throw storage::BadFile(
            fmt::format("{}/{}: it has {} levels, and figures of {}", diagnostics::escape_for_display(where_.folder),
                        storage::name_of(found.number, found.place), found.levels, found.expanded.size()));
}

/// Collects the rows of this rank from the files of all former ranks. The rows from each former rank form one run; then
/// the runs are merged.
void KeptLevels::redistribute_rows(const std::vector<storage::Checkpoint>& found, Level levels) {
    std::vector<storage::LevelFiles> all;
    for (const storage::Checkpoint& each : found) {
        all.emplace_back(storage::FolderOf{where_.folder, where_.kind, each.place});
        all.back().adopt(each, *where_.budget);
        all.back().close_finished_files();
    }
    std::uint64_t before = 0;
    storage::SortedRuns runs(path_of("runs", where_), where_.kind);
    for (Level level = 0; level < levels; ++level) {
        std::uint64_t rows = 0;
        for (storage::LevelFiles& files : all) {
            before += files.rows(level);
            rows += add_mine(files, level, runs);
            files.close_finished_files();
        }
        files_.add_level([&](const storage::TakeRows& take) {
            runs.merge([&](std::span<const Word> piece) {
                poll();
                take(piece);
            });
        });
        runs.clear();
        if (files_.rows(level) != rows)
            throw storage::BadFile(fmt::format("{}/{}: a row of level {} is also in the part of another thread",
                                               diagnostics::escape_for_display(where_.folder),
                                               storage::name_of(found[0].number, found[0].place), level));
    }
    rows_before_ = before;
}

/// Adds a run with the rows of a level that belong to this rank. Returns the number of these rows.
std::uint64_t KeptLevels::add_mine(storage::LevelFiles& from, Level level, storage::SortedRuns& runs) {
    const std::size_t width = where_.kind.width;
    std::uint64_t rows = 0;
    Words mine;
    runs.add([&](const storage::TakeRows& take) {
        from.each_block(level, [&](std::span<const Word> block) {
            poll();
            mine.clear();
            for (std::size_t at = 0; at < block.size(); at += width)
                if (const StateView row = block.subspan(at, width); !where_.mine || where_.mine(row))
                    mine.insert(mine.end(), row.begin(), row.end());
            rows += mine.size() / width;
            take(mine);
        });
    });
    return rows;
}

bool KeptLevels::checkpoint_due() const {
    return where_.every && std::chrono::steady_clock::now() - last_ >= *where_.every;
}

void KeptLevels::checkpoint(const SearchRecord& record, const storage::LevelFiles::GivePieces& unsure) {
    storage::LevelFiles::Beside beside;
    beside.marks.reserve(record.marks.size() * record.marks.width());
    for (lts::StateIndex i = 0; i < record.marks.size(); ++i)
        beside.marks.insert(beside.marks.end(), record.marks[i].begin(), record.marks[i].end());
    storage::sort_rows(beside.marks, where_.kind.width);
    Words closed;
    beside.unsure = [&](const storage::TakeRows& take) {
        unsure([&](std::span<const Word> rows) {
            closed.clear();
            const std::size_t width = where_.kind.width + 1;
            for (std::size_t at = 0; at < rows.size(); at += width)
                if (const StateView row = rows.subspan(at, width); row.back() < files_.levels())
                    closed.insert(closed.end(), row.begin(), row.end());
            take(closed);
        });
    };
    for (std::size_t level = 0; level + 1 < files_.levels() && level < record.expanded.size(); ++level)
        beside.expanded.push_back({record.expanded[level].transitions, record.expanded[level].chased});
    files_.checkpoint(beside);
    last_ = std::chrono::steady_clock::now();
}

void KeptLevels::checkpoint_of_fewer(const SearchRecord& record, const storage::LevelFiles::GivePieces& unsure) {
    for (std::uint32_t next = 1;; next *= 2) try {
            return checkpoint(record, unsure);
        } catch (const storage::CannotWrite&) {
            if (files_.give_up(next) == 0 || files_.levels() == 0) throw;
        }
}

}  // namespace robochart::refine
