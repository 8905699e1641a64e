// Rows in ascending runs, in a file without a name, which goes when the program ends; given in order, each once. So
// rows that do not fit into memory are put in order (external sorting: Knuth, TAOCP 3, 5.4.1).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "checker/storage/row_file.hpp"

namespace robochart::storage {

class SortedRuns {
public:
    /// Until it is open the file is at this path. `kind`: of the rows.
    SortedRuns(std::string path, const RowKind& kind) : path_(std::move(path)), kind_(kind) {}

    /// Adds a run: rows in ascending order, none twice. Runs may have rows in common. Throws CannotWrite; all is then
    /// as before.
    void add(std::span<const Word> rows);
    /// Adds a run whose rows `give` gives piece by piece.
    void add(const std::function<void(const TakeRows&)>& give);
    [[nodiscard]] bool empty() const { return runs_.empty(); }
    /// How many rows the runs have, those in several of them several times.
    [[nodiscard]] std::uint64_t rows() const;
    /// So many rows there are at least: those of the longest run.
    [[nodiscard]] std::uint64_t longest() const;
    /// Gives all rows, ascending, each once, in pieces of RowFile::rows_of_block rows but for the last. Throws BadFile,
    /// and what `take` throws.
    void merge(const TakeRows& take) const;
    /// Removes all runs; what they take on the disk is free again.
    void clear();
    /// In memory, while nothing is merged.
    [[nodiscard]] std::uint64_t bytes() const;

private:
    struct Run {
        std::size_t first = 0;  ///< block
        std::size_t end = 0;
        std::uint64_t rows = 0;
    };
    class Reader;
    void unite();

    std::string path_;
    RowKind kind_;
    std::optional<RowFile> file_;  ///< the runs are its levels
    std::vector<Run> runs_;
};

}  // namespace robochart::storage
