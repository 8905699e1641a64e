// SPDX-License-Identifier: Apache-2.0
// Describes where the rows of a search are stored. Each rank receives this description and creates its store from it.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "base/cache/digest.hpp"
#include "base/diagnostics/pollable.hpp"
#include "checker/refine/levels/disk_row_store.hpp"
#include "checker/refine/levels/exchange.hpp"
#include "checker/refine/levels/row_store.hpp"
#include "checker/storage/checkpoint.hpp"

namespace robochart::refine {

/// Describes the row stores of a search; the description is the same at all ranks.
struct RowKeeping {
    /// A folder that the first rank has created and that only this search uses; "" if rows are stored only in memory.
    std::string folder;
    /// The contents of the file `run_name` in the folder. With this file, a rank recognises the folder of the first
    /// rank.
    std::string run;
    diagnostics::Digest search{};        ///< identifies the search
    storage::Newest from;                ///< the checkpoint to continue from
    std::chrono::milliseconds every{0};  ///< time between checkpoints
    bool disk = false;                   ///< whether rows that do not fit into memory are stored in files
    std::uint64_t most_bytes = 0;        ///< disk: memory limit for all ranks of a program together
    // disk: see DiskRowStore::Bounds
    unsigned filter_bits = DiskRowStore::Bounds{}.filter_bits;
    unsigned reads_a_step = DiskRowStore::Bounds{}.reads_a_step;
};

/// If a rank sees this file, it sees the folder of the first rank. While a rank uses the folder, the rank holds a
/// shared lock on this file (flock). So no other run can use the folder before this run has ended.
inline constexpr const char* const run_name = "run";

/// Creates the store for the rows of this rank, which have `width` words. The store polls the budget during long work.
/// `report`: see DiskRowStore::Bounds. Throws storage::BadFile if a file is damaged or if this rank does not see the
/// folder of the first rank. Also throws storage::CannotWrite.
[[nodiscard]] std::unique_ptr<RowStore> make_row_store(const RowKeeping& keeping, std::size_t width,
                                                       const Exchange& exchange, diagnostics::Pollable& budget,
                                                       std::function<void(const DiskRowStore::Figures&)> report);

}  // namespace robochart::refine
