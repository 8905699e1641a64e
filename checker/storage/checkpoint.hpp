// SPDX-License-Identifier: Apache-2.0
// Writes and reads checkpoints. A checkpoint of a search consists of the files with the levels and the other data that
// the search needs to continue. Each rank writes a text file that ends with a checksum, after all its other files are
// on the disk. Checkpoints are numbered. A checkpoint number is complete when all ranks have written their checkpoints
// with this number. Until then, the previous checkpoint is preserved. So a search that is killed at any moment can
// continue from the newest complete checkpoint.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "checker/storage/row_file.hpp"

namespace robochart::storage {

/// A rank and the number of ranks.
struct Place {
    std::uint32_t rank = 0;
    std::uint32_t ranks = 1;
    bool operator==(const Place&) const = default;
};

/// A file that a checkpoint names.
struct SavedFile {
    std::string name;          ///< name in the folder; "" if no such file exists
    std::uint64_t blocks = 0;  ///< number of valid blocks
    RowFile::Check check{};    ///< the check at the end of the file (RowFile)
};

/// Statistics about the expansion of a level at one rank.
struct SavedFigures {
    std::uint64_t transitions = 0;
    std::uint64_t chased = 0;
};

struct Checkpoint {
    std::uint64_t number = 0;
    Place place;
    std::uint32_t levels = 0;      ///< number of closed levels
    std::vector<SavedFile> files;  ///< files with the rows of the levels, in the order of levels
    SavedFile marks;               ///< rows of level 0
    /// Rows followed by their levels. Each of them may be a duplicate of a row in an earlier level.
    SavedFile unsure;
    std::vector<SavedFigures> expanded;  ///< by level
};

/// Returns the name of the file for a checkpoint.
[[nodiscard]] std::string name_of(std::uint64_t number, const Place& place);
/// Writes a checkpoint into a folder atomically. Throws CannotWrite.
void write(const std::string& folder, const RowKind& kind, const Checkpoint& checkpoint);
/// Reads a checkpoint. Throws BadFile.
[[nodiscard]] Checkpoint read(const std::string& folder, const RowKind& kind, const std::string& name);

/// The checkpoints in a folder, found by the names of the files.
struct Newest {
    std::uint64_t number = 0;    ///< number of the newest complete checkpoint
    std::uint32_t ranks = 0;     ///< number of ranks that have written it; 0 if no checkpoint is complete
    std::uint64_t greatest = 0;  ///< greatest number, complete or not; 0 if there is none
};
[[nodiscard]] Newest newest_in(const std::string& folder);
/// Reads the newest complete checkpoint of every rank, in the order of ranks. Returns an empty list if no checkpoint is
/// complete. If ranks have closed different numbers of levels, only the levels that all of them have closed are valid.
/// Throws BadFile.
[[nodiscard]] std::vector<Checkpoint> read(const std::string& folder, const RowKind& kind, const Newest& newest);
/// Removes obsolete files of this rank from a folder: checkpoints older than the newest complete one with this number
/// of ranks, and files that no checkpoint names. Rank 0 also removes those of ranks that no longer exist.
void remove_old(const std::string& folder, const RowKind& kind, const Place& place);

}  // namespace robochart::storage
