// SPDX-License-Identifier: Apache-2.0
#include "checker/storage/level_files.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <stdexcept>

#include "base/diagnostics/escape.hpp"

namespace robochart::storage {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

std::string path_in(const FolderOf& where, const std::string& name) {
    return where.folder + "/" + name;
}

bool is_there(const std::string& path) {
    struct stat found {};
    return ::lstat(path.c_str(), &found) == 0;
}

RowFile open_saved(const std::string& path, const RowKind& kind, const SavedFile& saved,
                   diagnostics::Pollable& budget) {
    RowFile file = RowFile::open(path, kind, budget);
    if (file.check() != saved.check || saved.blocks > file.blocks().size())
        throw BadFile(fmt::format("{}: it is not the file that the checkpoint was written with",
                                  diagnostics::escape_for_display(file.path())));
    return file;
}

}  // namespace

void LevelFiles::adopt(const Checkpoint& checkpoint, diagnostics::Pollable& budget) {
    levels_.resize(checkpoint.levels);
    std::uint32_t level = 0;
    for (const SavedFile& saved : checkpoint.files) {
        const auto number = static_cast<std::uint32_t>(files_.size());
        files_.push_back(
            {std::make_unique<RowFile>(open_saved(path_in(where_, saved.name), where_.kind, saved, budget)), saved.name,
             saved.blocks, true});
        (void)to_read(number);
        const auto& blocks = files_.back().file->blocks();
        for (std::uint32_t i = 0; i < saved.blocks; ++i) {
            if (blocks[i].level < level || blocks[i].level >= checkpoint.levels)
                throw BadFile(fmt::format("{}: block {} is of a level that does not follow",
                                          diagnostics::escape_for_display(files_.back().file->path()), i));
            level = blocks[i].level;
            Level& entry = levels_[level];
            if (entry.count == 0) entry = {number, i, 0, 0};
            if (entry.file != number)
                throw BadFile(fmt::format("{}: level {} is in another file too",
                                          diagnostics::escape_for_display(files_.back().file->path()), level));
            // `read` computes the block of a row from its position in the level, so all blocks before the last must be
            // full.
            if (entry.count > 0 && blocks[i - 1].rows != RowFile::rows_of_block)
                throw BadFile(fmt::format("{}: block {} has too few rows for one that others of its level follow",
                                          diagnostics::escape_for_display(files_.back().file->path()), i - 1));
            ++entry.count;
            entry.rows += blocks[i].rows;
            rows_ += blocks[i].rows;
        }
    }
    number_ = checkpoint.number;
    saved_levels_ = checkpoint.levels;
}

void LevelFiles::close_finished_files() {
    if (open_file_ < files_.size()) files_[open_file_].file->close_until_read();
    open_file_ = none;
}

const RowFile& LevelFiles::to_read(std::uint32_t file) {
    assert(file < files_.size());
    if (file != open_file_) close_finished_files();
    open_file_ = file;
    return *files_[file].file;
}

LevelFiles::File LevelFiles::new_file(const RowKind& kind) {
    for (;;) {
        const std::string name = fmt::format("rows-{}-of-{}-{}", where_.place.rank, where_.place.ranks, next_name_++);
        if (is_there(path_in(where_, name))) continue;  // an earlier run has left this file
        return {std::make_unique<RowFile>(RowFile::create(path_in(where_, name), kind)), name, 0, false};
    }
}

RowFile& LevelFiles::growing_file() {
    if (files_.empty() || files_.back().file->finished()) files_.push_back(new_file(where_.kind));
    return *files_.back().file;
}

void LevelFiles::add_level(std::span<const Word> rows) {
    add_level([rows, this](const TakeRows& take) {
        if (!rows.empty() || where_.kind.width == 0) take(rows);
    });
}

void LevelFiles::add_level(const std::function<void(const TakeRows&)>& give) {
    Level entry;
    RowFile* file = nullptr;  // null for a level without rows
    const auto take = [&](std::span<const Word> rows) {
        if (file == nullptr) {
            file = &growing_file();
            entry = {static_cast<std::uint32_t>(files_.size() - 1), static_cast<std::uint32_t>(file->blocks().size())};
        } else if (file->blocks().back().rows != RowFile::rows_of_block) {
            throw std::logic_error("a piece of a level that others follow is no whole number of blocks");
        }
        const std::uint64_t before = file->rows();
        file->append(levels(), rows);
        entry.rows += file->rows() - before;
    };
    try {
        give(take);
    } catch (...) {
        if (file != nullptr) file->remove_blocks_from(entry.first);
        throw;
    }
    if (file != nullptr) {
        entry.count = static_cast<std::uint32_t>(file->blocks().size()) - entry.first;
        files_.back().used = file->blocks().size();
    }
    rows_ += entry.rows;
    levels_.push_back(entry);
}

std::uint32_t LevelFiles::give_up(std::uint32_t count) {
    const std::uint32_t given = std::min(count, levels() - std::min(levels(), saved_levels_));
    forget_from(levels() - given);
    return given;
}

/// The rows are also removed from the last file if no checkpoint names this file. More rows can then be appended to it,
/// even if it was finished before. A file that a checkpoint names does not change, but some of its blocks are no longer
/// valid.
void LevelFiles::forget_from(std::uint32_t level) {
    if (level >= levels_.size()) return;
    for (std::size_t i = level; i < levels_.size(); ++i) {
        const Level& entry = levels_[i];
        assert(rows_ >= entry.rows);
        rows_ -= entry.rows;
        if (entry.count > 0) files_[entry.file].used = std::min<std::uint64_t>(files_[entry.file].used, entry.first);
    }
    levels_.resize(level);
    assert(level > 0 || rows_ == 0);
    cached_file_ = none;
    for (; !files_.empty() && files_.back().used == 0; files_.pop_back())
        if (!files_.back().named) ::unlink(files_.back().file->path().c_str());
    if (files_.empty() || files_.back().named) return;
    File& last = files_.back();
    if (last.used < last.file->blocks().size()) last.file->remove_blocks_from(last.used);
}

std::size_t LevelFiles::read(std::uint32_t level, std::uint64_t first, std::size_t most, std::vector<Word>& rows) {
    assert(level < levels_.size());
    const Level& entry = levels_[level];
    const std::size_t width = where_.kind.width;
    std::size_t given = 0;
    std::uint64_t begin = 0;
    // All blocks of a level except the last have the same size.
    const std::uint64_t skipped = std::min<std::uint64_t>(first / RowFile::rows_of_block, entry.count);
    begin = skipped * RowFile::rows_of_block;
    for (auto i = static_cast<std::uint32_t>(skipped); i < entry.count && given < most; ++i) {
        const RowFile& file = to_read(entry.file);
        const std::uint32_t block = entry.first + i;
        const std::uint64_t count = file.blocks()[block].rows;
        if (cached_file_ != entry.file || cached_block_ != block) {
            cached_.clear();
            cached_file_ = none;
            file.read(block, cached_);
            cached_file_ = entry.file;
            cached_block_ = block;
        }
        const std::uint64_t from = std::max(first, begin) - begin;
        if (from < count) {
            const std::uint64_t taken = std::min<std::uint64_t>(count - from, most - given);
            const auto at = cached_.begin() + static_cast<std::ptrdiff_t>(from * width);
            rows.insert(rows.end(), at, at + static_cast<std::ptrdiff_t>(taken * width));
            given += taken;
        }
        begin += count;
    }
    assert(given <= most);
    return given;
}

void LevelFiles::each_block(std::uint32_t level, const TakeRows& visit) {
    each_block_if(
        level, [](const auto&, const auto&) { return true; }, visit);
}

void LevelFiles::each_block_if(std::uint32_t level, const WantsBlock& wants, const TakeRows& visit) {
    assert(level < levels_.size());
    const Level& entry = levels_[level];
    if (entry.count == 0) return;
    const RowFile& file = to_read(entry.file);
    std::vector<Word> rows;
    for (std::uint32_t block = entry.first, end = block + entry.count; block < end; ++block) {
        if (!wants(file.first_row(block), block + 1 < end ? file.first_row(block + 1) : std::span<const Word>()))
            continue;
        rows.clear();
        file.read(block, rows);
        visit(rows);
    }
}

void LevelFiles::finish_last() {
    if (files_.empty() || files_.back().file->finished()) return;
    files_.back().file->finish();
    (void)to_read(static_cast<std::uint32_t>(files_.size() - 1));
}

/// Saves rows to a file. Each piece of rows becomes a level of the file. If the file cannot be written, it is deleted,
/// because the disk may be full.
SavedFile LevelFiles::save(const RowKind& kind, const GivePieces& give) {
    File made;
    std::uint32_t pieces = 0;
    try {
        give([&](std::span<const Word> rows) {
            if (rows.empty()) return;
            if (!made.file) made = new_file(kind);
            made.file->append(pieces++, rows);
        });
        if (!made.file) return {};
        made.file->finish();
    } catch (...) {
        if (made.file) ::unlink(made.file->path().c_str());
        throw;
    }
    return {made.name, made.file->blocks().size(), made.file->check()};
}

void LevelFiles::note_written(const Checkpoint& made) {
    number_ = made.number;
    saved_levels_ = made.levels;
    for (File& level_file : files_)
        if (level_file.used > 0) level_file.named = true;
}

/// On failure, deletes the files that contain the data besides the levels, because the disk may be full. It does not
/// delete them if the checkpoint already has its name and only the synchronisation of the folder with the disk has
/// failed.
void LevelFiles::checkpoint(const Beside& beside) {
    Checkpoint made{number_ + 1, where_.place, levels(), {}, {}, {}, beside.expanded};
    try {
        made.marks = save(where_.kind, [&](const TakeRows& take) { take(beside.marks); });
        if (beside.unsure) made.unsure = save(with_level(where_.kind), beside.unsure);
        finish_last();
        for (const File& level_file : files_)
            if (level_file.used > 0) made.files.push_back({level_file.name, level_file.used, level_file.file->check()});
        write(where_.folder, where_.kind, made);
    } catch (...) {
        if (is_there(path_in(where_, name_of(made.number, made.place)))) {
            note_written(made);
        } else {
            for (const SavedFile* file : {&made.marks, &made.unsure})
                if (!file->name.empty()) ::unlink(path_in(where_, file->name).c_str());
        }
        throw;
    }
    note_written(made);
    remove_old(where_.folder, where_.kind, where_.place);
}

void LevelFiles::read_beside(const FolderOf& where, const SavedFile& saved, bool levels, diagnostics::Pollable& budget,
                             const TakeRows& visit) {
    if (saved.name.empty()) return;
    const RowFile file =
        open_saved(path_in(where, saved.name), levels ? with_level(where.kind) : where.kind, saved, budget);
    std::vector<Word> rows;
    for (std::size_t block = 0; block < saved.blocks; ++block) {
        rows.clear();
        file.read(block, rows);
        visit(rows);
    }
}

std::uint64_t LevelFiles::bytes() const {
    std::uint64_t bytes = levels_.capacity() * sizeof(Level) + cached_.capacity() * sizeof(Word);
    for (const File& level_file : files_) bytes += level_file.file->bytes();
    return bytes;
}

}  // namespace robochart::storage
