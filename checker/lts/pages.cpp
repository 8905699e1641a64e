// SPDX-License-Identifier: Apache-2.0
#include "checker/lts/pages.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cassert>
#include <cstdint>
#include <cstring>
#include <new>

namespace robochart::lts {
namespace {

constexpr std::size_t huge_page = std::size_t{1} << 21U;
constexpr std::size_t cache_line = 64;
/// Larger blocks are mapped directly, so they return to the system as soon as they are freed. In the heap, a freed
/// block may stay allocated because of the blocks around it.
constexpr std::size_t large = std::size_t{1} << 17U;

/// Rounds up to whole pages of this machine.
std::size_t round_to_pages(std::size_t bytes) {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    assert(page > 0 && (page & (page - 1)) == 0 && huge_page % page == 0);
    return (bytes + page - 1) & ~(page - 1);
}

/// Maps one huge page more than necessary, and unmaps the excess at both ends. Huge pages are used only for ranges that
/// they fill completely, so that no memory is wasted.
void* map(std::size_t bytes) {
    const std::size_t length = round_to_pages(bytes);
    void* const mapped =
        mmap(nullptr, length + huge_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (mapped == MAP_FAILED) throw std::bad_alloc();
    char* const begin = static_cast<char*>(mapped);
    const std::size_t before = (huge_page - reinterpret_cast<std::uintptr_t>(begin) % huge_page) % huge_page;
    assert(before < huge_page && reinterpret_cast<std::uintptr_t>(begin + before) % huge_page == 0);
    if (before != 0) munmap(begin, before);
    munmap(begin + before + length, huge_page - before);
#ifdef MADV_HUGEPAGE
    const std::size_t whole = length & ~(huge_page - 1);
    if (whole > 0) madvise(begin + before, whole, MADV_HUGEPAGE);  // only advice: without it, the program is slower
#endif
    return begin + before;
}

}  // namespace

void FreePages::operator()(void* memory) const {
    if (bytes >= large)
        munmap(memory, round_to_pages(bytes));
    else
        ::operator delete (memory, std::align_val_t{cache_line});
}

Pages zeroed_pages(std::size_t bytes) {
    if (bytes >= large) return {map(bytes), FreePages{bytes}};
    void* const memory = ::operator new (bytes, std::align_val_t{cache_line});
    return {std::memset(memory, 0, bytes), FreePages{bytes}};
}

}  // namespace robochart::lts
