// SPDX-License-Identifier: Apache-2.0
// Stores rows in sorted runs in an unnamed file that is deleted when the program ends, and returns them in order,
// without duplicates. Sorts rows that do not fit into memory (external sorting: Knuth, TAOCP 3, 5.4.1).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "checker/storage/row_file.hpp"

namespace robochart::storage {

class SortedRuns {
public:
    /// The file is created at this path. Its name is removed as soon as it is open. `kind`: the kind of the rows.
    SortedRuns(std::string path, const RowKind& kind) : path_(std::move(path)), kind_(kind) {}

    /// Adds a run: ascending rows without duplicates. Runs may have rows in common. Throws CannotWrite and then leaves
    /// everything unchanged.
    void add(std::span<const Word> rows);
    /// Adds a run; `give` passes its rows piece by piece.
    void add(const std::function<void(const TakeRows&)>& give);
    [[nodiscard]] bool empty() const { return runs_.empty(); }
    /// The number of rows in all runs; rows in several runs count several times.
    [[nodiscard]] std::uint64_t rows() const;
    /// A lower bound on the number of different rows: the length of the longest run.
    [[nodiscard]] std::uint64_t longest_run() const;
    /// Passes all rows to `take`, ascending, without duplicates, in pieces of RowFile::rows_of_block rows except for
    /// the last. Throws BadFile, and the exceptions of `take`.
    void merge(const TakeRows& take) const;
    /// Removes all runs and frees their disk space.
    void clear();
    /// Memory use while nothing is merged.
    [[nodiscard]] std::uint64_t bytes() const;

private:
    struct Run {
        std::size_t first = 0;  ///< block
        std::size_t end = 0;
        std::uint64_t rows = 0;
    };
    class Reader;
    void merge_into_one();

    std::string path_;
    RowKind kind_;
    std::optional<RowFile> file_;  ///< the runs are its levels
    std::vector<Run> runs_;
};

}  // namespace robochart::storage
