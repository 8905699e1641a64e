// Rows that are decided about later, all at once ("delayed duplicate detection": Stern and Dill, Using magnetic disk
// instead of main memory in the Murphi verifier, CAV 1998). Each has the level to which it belongs if it is no earlier
// row. Where they are many they are sorted runs in a file.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "checker/refine/levels/row_store.hpp"
#include "checker/storage/sorted_runs.hpp"

namespace robochart::refine {

class RowsAside {
public:
    /// In memory are as many rows as `bytes` hold, a few at least. While it is made, their file is at this path.
    RowsAside(const std::string& path, const storage::RowKind& kind, std::uint64_t bytes);

    /// Adds a row that belongs to `level`, if it is no earlier one. A row that is added again has no lesser level than
    /// before. `hash`: lts::StateStore::hash(row). Throws storage::CannotWrite; the row is not added then, and all
    /// others are still there.
    void add(lts::StateView row, std::uint64_t hash, Level level);
    [[nodiscard]] bool empty() const { return rows() == 0; }
    /// How many there are; one may be counted several times.
    [[nodiscard]] std::uint64_t rows() const { return store_->size() + unwritten() + runs_.rows(); }
    [[nodiscard]] bool on_disk() const { return !runs_.empty(); }
    /// Gives all in pieces: ascending rows with their levels behind, a word more. No row is twice in a piece; where it
    /// is in several, the first has the least of its levels. `take` may change the piece. Writes nothing. Throws what
    /// `take` throws, and storage::BadFile.
    void each_piece(const std::function<void(std::vector<lts::Word>& rows)>& take) const;
    /// Forgets all.
    void clear();
    [[nodiscard]] std::uint64_t bytes() const;

private:
    [[nodiscard]] std::size_t width() const { return store_->width(); }
    [[nodiscard]] std::uint64_t unwritten() const { return unwritten_.size() / (width() + 1); }
    [[nodiscard]] std::vector<lts::Word> with_levels(lts::StateIndex first, lts::StateIndex end) const;
    void write();
    void each_of_runs(const std::function<void(std::vector<lts::Word>& rows)>& take) const;

    std::uint64_t most_;                                     ///< rows in memory
    std::unique_ptr<lts::StateStore> store_;                 ///< those added last
    std::vector<std::pair<Level, lts::StateIndex>> levels_;  ///< a level, and the first row of the store that has it
    std::vector<lts::Word> unwritten_;                       ///< others, with their levels, on their way into a run
    storage::SortedRuns runs_;                               ///< the rest
};

}  // namespace robochart::refine
