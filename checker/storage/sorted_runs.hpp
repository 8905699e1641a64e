// SPDX-License-Identifier: Apache-2.0
// Stores rows in sorted runs and returns them in order, without duplicates. So it sorts rows that do not fit into
// memory (external sorting: Knuth, TAOCP 3, 5.4.1). The runs are in an unnamed file, which the system deletes when the
// program ends.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "checker/storage/row_file.hpp"

namespace robochart::storage {

class SortedRuns {
public:
    /// Creates the file at this path when it is needed, and removes its name as soon as it is open. `kind`: the kind of
    /// the rows.
    SortedRuns(std::string path, const RowKind& kind) : path_(std::move(path)), kind_(kind) {}

    /// Adds a run. Its rows must be ascending and without duplicates. Runs may have rows in common. Throws CannotWrite
    /// and then leaves everything unchanged.
    void add(std::span<const Word> rows);
    /// Adds a run. `give` passes its rows piece by piece.
    void add(const std::function<void(const TakeRows&)>& give);
    [[nodiscard]] bool empty() const { return runs_.empty(); }
    /// Returns the number of rows in all runs. A row that occurs in several runs is counted several times.
    [[nodiscard]] std::uint64_t rows() const;
    /// Returns the length of the longest run. The number of different rows is at least as large.
    [[nodiscard]] std::uint64_t longest_run() const;
    /// Passes all rows to `take`, ascending and without duplicates. Each piece except the last has
    /// RowFile::rows_of_block rows. Throws BadFile, and the exceptions of `take`.
    void merge(const TakeRows& take) const;
    /// Removes all runs and frees their disk space.
    void clear();
    /// Returns the memory in bytes that is used while no runs are merged.
    [[nodiscard]] std::uint64_t bytes() const;

private:
    struct Run {
        std::size_t first = 0;  ///< first block
        std::size_t end = 0;
        std::uint64_t rows = 0;
    };
    class Reader;
    void merge_into_one();

    std::string path_;
    RowKind kind_;
    std::optional<RowFile> file_;  ///< each level of this file is a run
    std::vector<Run> runs_;
};

}  // namespace robochart::storage
