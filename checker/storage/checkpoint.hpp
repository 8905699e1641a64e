// A checkpoint of a search: which files have the levels, and what else the search goes on with. Each rank writes one,
// as a text of its own with a check at its end, when all its files are on the disk. Checkpoints are numbered; that of a
// number is complete if all ranks have theirs. The one before is kept until then, so that a search that is ended at any
// moment can go on from the newest complete one.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "checker/storage/row_file.hpp"

namespace robochart::storage {

/// Which rank of how many.
struct Place {
    std::uint32_t rank = 0;
    std::uint32_t ranks = 1;
    bool operator==(const Place&) const = default;
};

/// A file of a checkpoint.
struct SavedFile {
    std::string name;          ///< in the folder; "": there is none
    std::uint64_t blocks = 0;  ///< of its blocks so many count
    RowFile::Check check{};    ///< its own
};

/// What expanding a level has given at one rank.
struct SavedFigures {
    std::uint64_t transitions = 0;
    std::uint64_t chased = 0;
};

struct Checkpoint {
    std::uint64_t number = 0;
    Place place;
    std::uint32_t levels = 0;            ///< closed
    std::vector<SavedFile> files;        ///< with the rows of the levels, in the order of levels
    SavedFile marks;                     ///< rows of level 0
    SavedFile unsure;                    ///< rows, their levels behind, that perhaps are none of levels before
    std::vector<SavedFigures> expanded;  ///< by level
};

/// The file that a checkpoint is in.
[[nodiscard]] std::string name_of(std::uint64_t number, const Place& place);
/// Writes a checkpoint into a folder, so that it is there as a whole or not at all. Throws CannotWrite.
void write(const std::string& folder, const RowKind& kind, const Checkpoint& checkpoint);
/// Reads one. Throws BadFile.
[[nodiscard]] Checkpoint read(const std::string& folder, const RowKind& kind, const std::string& name);

/// Which checkpoints a folder has, by their names.
struct Newest {
    std::uint64_t number = 0;    ///< of the newest complete one
    std::uint32_t ranks = 0;     ///< that have written it; 0: there is none
    std::uint64_t greatest = 0;  ///< number of one, complete or not; 0: there is none
};
[[nodiscard]] Newest newest_in(const std::string& folder);
/// The newest complete one, that of each rank in the order of ranks; none where there is none. A rank may have closed
/// more levels than another; those that all have closed count. Throws BadFile.
[[nodiscard]] std::vector<Checkpoint> read(const std::string& folder, const RowKind& kind, const Newest& newest);
/// Removes what is no longer needed in a folder: checkpoints older than the newest complete one of so many ranks, and
/// files that no checkpoint names. Each rank removes its own; the first one also those of ranks that there are no more.
void remove_old(const std::string& folder, const RowKind& kind, const Place& place);

}  // namespace robochart::storage
