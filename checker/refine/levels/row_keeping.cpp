// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/levels/row_keeping.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/diagnostics/escape.hpp"
#include "checker/refine/levels/memory_row_store.hpp"
#include "checker/refine/levels/saved_row_store.hpp"
#include "checker/storage/file_lock.hpp"

namespace robochart::refine {
namespace {

/// Opens and locks the file `run_name` of the folder, and checks its contents. A folder with the same name on another
/// machine would contain files for other rows. storage::lock checks after locking that the file still has this name, so
/// no other run has begun meanwhile.
std::shared_ptr<const diagnostics::Descriptor> use_folder(const RowKeeping& keeping, unsigned rank) {
    const std::string path = keeping.folder + "/" + run_name;
    const auto refuse = [&](const std::string& why) {
        throw storage::BadFile(fmt::format("{}: rank {}: {}: all ranks must see the folder that rank 0 sees",
                                           diagnostics::escape_for_display(path), rank, why));
    };
    auto file = std::make_shared<diagnostics::Descriptor>(storage::open_to_lock(path, false));
    if (!file->is_open() && (errno == EMFILE || errno == ENFILE)) storage::cannot_open(path, errno);
    if (!file->is_open()) refuse(std::strerror(errno));
    if (const std::string why =
            storage::lock(*file, path, storage::Lock::shared, "another run has begun to use this folder");
        !why.empty())
        refuse(why);
    std::string found(keeping.run.size() + 1, '\0');
    const ssize_t size = ::read(file->get(), found.data(), found.size());
    if (size < 0) refuse(std::strerror(errno));
    found.resize(static_cast<std::size_t>(size));
    if (found != keeping.run) refuse("it is of another run");
    return file;
}

}  // namespace

std::unique_ptr<RowStore> make_row_store(const RowKeeping& keeping, std::size_t width, const Exchange& exchange,
                                         diagnostics::Pollable& budget,
                                         std::function<void(const DiskRowStore::Figures&)> report) {
    if (keeping.folder.empty()) return std::make_unique<MemoryRowStore>(width);
    const unsigned rank = exchange.rank();
    const unsigned ranks = exchange.ranks();
    auto lock = use_folder(keeping, rank);
    KeptWhere where{keeping.folder, {width, keeping.search}, {rank, ranks}, keeping.from, keeping.every, {},
                    &budget,        std::move(lock)};
    if (ranks > 1)
        where.mine = [rank, ranks](lts::StateView row) { return owner_of(lts::StateStore::hash(row), ranks) == rank; };
    if (!keeping.disk) return std::make_unique<SavedRowStore>(std::move(where));
    DiskRowStore::Bounds bounds;
    bounds.most_bytes = keeping.most_bytes / exchange.ranks_here();
    bounds.filter_bits = keeping.filter_bits;
    bounds.reads_a_step = keeping.reads_a_step;
    bounds.report = std::move(report);
    return std::make_unique<DiskRowStore>(std::move(where), std::move(bounds));
}

}  // namespace robochart::refine
