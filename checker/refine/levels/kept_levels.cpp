#include "checker/refine/levels/kept_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "checker/storage/sort_rows.hpp"
#include "diagnostics/escape.hpp"

namespace robochart::refine {

using lts::StateView;
using lts::Word;
using Words = std::vector<Word>;

KeptLevels::KeptLevels(KeptWhere where)
    : where_(std::move(where)), files_({where_.folder, where_.kind, where_.place}) {}

/// A rank that was ended while it closed a level or went back has fewer or more levels than others. Those that all have
/// are complete, but for rows that are unsure: a rank goes on to the next level when all have closed the one before.
/// The last of them is expanded again, which finds what the later ones had, their rows that were unsure too.
KeptLevels::Unsure KeptLevels::load(SearchRecord& record) {
    const std::vector<storage::Checkpoint> found = storage::read(where_.folder, where_.kind, where_.from);
    Unsure unsure;
    // Numbers that some ranks have used and others not are not used again.
    const std::uint64_t greatest = where_.from.greatest;
    if (found.empty()) {
        files_.number_from(greatest);
        return unsure;
    }
    for (const storage::Checkpoint& each : found) check(each);
    const Level levels = std::min_element(found.begin(), found.end(), [](const auto& one, const auto& other) {
                             return one.levels < other.levels;
                         })->levels;
    const bool same = found.size() == where_.place.ranks;
    if (same) {
        files_.adopt(found[where_.place.rank], where_.poll);
        files_.forget_from(levels);
    } else {
        redistribute(found, levels);
    }
    files_.number_from(greatest);
    const std::size_t width = where_.kind.width;
    const auto each_own = [&](std::span<const Word> rows, const auto& take) {
        for (std::size_t at = 0; at < rows.size(); at += width)
            if (const StateView row = rows.subspan(at, width); !where_.mine || where_.mine(row)) take(row);
    };
    for (const storage::Checkpoint& each : found) {
        if (same && each.place != where_.place) continue;
        const storage::FolderOf from{where_.folder, where_.kind, each.place};
        storage::LevelFiles::read_beside(from, each.marks, where_.poll, [&](Level, std::span<const Word> rows) {
            each_own(rows, [&](StateView row) { record.marks.insert(row); });
        });
        storage::LevelFiles::read_beside(from, each.unsure, where_.poll, [&](Level level, std::span<const Word> rows) {
            if (level >= each.levels)
                throw storage::BadFile(fmt::format("{}/{}: it has rows of level {}, which is not closed",
                                                   diagnostics::shown(where_.folder), each.unsure.name, level));
            if (level >= levels) return;
            each_own(rows, [&](StateView row) { unsure.emplace_back(level, Words(row.begin(), row.end())); });
        });
        // Figures are summed up over ranks, so the first rank may have those of all.
        record.expanded.resize(levels - 1);
        if (!same && where_.place.rank != 0) continue;
        for (std::size_t level = 0; level < record.expanded.size(); ++level) {
            record.expanded[level].transitions += each.expanded[level].transitions;
            record.expanded[level].chased += each.expanded[level].chased;
        }
    }
    std::stable_sort(unsure.begin(), unsure.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return unsure;
}

/// Of each level but the last one there are figures, so that a number of levels takes no more memory than its text.
void KeptLevels::check(const storage::Checkpoint& found) const {
    if (found.levels > found.expanded.size() + 1)
        throw storage::BadFile(
            fmt::format("{}/{}: it has {} levels, and figures of {}", diagnostics::shown(where_.folder),
                        storage::name_of(found.number, found.place), found.levels, found.expanded.size()));
}

/// The rows of this rank out of the files of all that there were.
void KeptLevels::redistribute(const std::vector<storage::Checkpoint>& found, Level levels) {
    std::vector<storage::LevelFiles> all;
    for (const storage::Checkpoint& each : found) {
        all.emplace_back(storage::FolderOf{where_.folder, where_.kind, each.place});
        all.back().adopt(each, where_.poll);
    }
    const std::size_t width = where_.kind.width;
    Words rows;
    for (Level level = 0; level < levels; ++level) {
        rows.clear();
        for (storage::LevelFiles& files : all)
            files.each_block(level, [&](std::span<const Word> block) {
                poll();
                for (std::size_t at = 0; at < block.size(); at += width)
                    if (const StateView row = block.subspan(at, width); !where_.mine || where_.mine(row))
                        rows.insert(rows.end(), row.begin(), row.end());
            });
        storage::sort_rows(rows, width);
        files_.add_level(rows);
    }
}

bool KeptLevels::checkpoint_due() const {
    return where_.every && std::chrono::steady_clock::now() - last_ >= *where_.every;
}

void KeptLevels::checkpoint(const SearchRecord& record, const Unsure& unsure) {
    storage::LevelFiles::Beside beside;
    beside.marks.reserve(record.marks.size() * record.marks.width());
    for (lts::StateIndex i = 0; i < record.marks.size(); ++i)
        beside.marks.insert(beside.marks.end(), record.marks[i].begin(), record.marks[i].end());
    storage::sort_rows(beside.marks, where_.kind.width);
    std::map<Level, Words> by_level;
    for (const auto& [level, row] : unsure)
        if (level < files_.levels()) by_level[level].insert(by_level[level].end(), row.begin(), row.end());
    for (auto& [level, rows] : by_level) {
        storage::sort_rows(rows, where_.kind.width);
        beside.unsure.emplace_back(level, std::move(rows));
    }
    for (std::size_t level = 0; level + 1 < files_.levels() && level < record.expanded.size(); ++level)
        beside.expanded.push_back({record.expanded[level].transitions, record.expanded[level].chased});
    files_.checkpoint(beside);
    last_ = std::chrono::steady_clock::now();
}

}  // namespace robochart::refine
