// Where the rows of a search are kept, as data that each of its ranks gets, and makes its store from.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "checker/refine/levels/disk_row_store.hpp"
#include "checker/refine/levels/exchange.hpp"
#include "checker/refine/levels/row_store.hpp"
#include "checker/storage/checkpoint.hpp"
#include "diagnostics/cache/digest.hpp"

namespace robochart::refine {

/// The same at all ranks of a search.
struct RowKeeping {
    std::string folder;                  ///< of this search alone, made by the first rank; "": rows are in memory alone
    std::string run;                     ///< what the folder's file `run_name` has: every rank must see the same folder
    diagnostics::Digest search{};        ///< which search it is
    storage::Newest from;                ///< the checkpoint to go on from
    std::chrono::milliseconds every{0};  ///< between checkpoints
    bool disk = false;                   ///< rows that memory does not hold stay in files
    std::uint64_t most_bytes = 0;        ///< disk: in memory, of all ranks of a program together
    // disk: as in DiskRowStore::Bounds
    unsigned filter_bits = DiskRowStore::Bounds{}.filter_bits;
    unsigned reads_a_step = DiskRowStore::Bounds{}.reads_a_step;
};

/// The file by which a rank knows that it sees the folder of the first rank. While a rank uses the folder it has a
/// shared lock on it (flock), so that no other run begins while one of an earlier run is not yet at its end.
inline constexpr const char* const run_name = "run";

/// The store for the rows of this rank, of so many words. `poll` is called during long work, and may throw; `report`:
/// DiskRowStore::Bounds. Throws storage::BadFile, also where this rank does not see the folder that is meant, and
/// storage::CannotWrite.
[[nodiscard]] std::unique_ptr<RowStore> make_row_store(const RowKeeping& keeping, std::size_t width,
                                                       const Exchange& exchange, std::function<void()> poll,
                                                       std::function<void(const DiskRowStore::Figures&)> report);

}  // namespace robochart::refine
