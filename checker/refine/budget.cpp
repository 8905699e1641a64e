// Limits of time, memory and states. Memory is what the whole program has resident, because the states of the
// systems that are searched are kept by them, not by the search.
#include "checker/refine/budget.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

namespace robochart::refine {
namespace {

/// 0 where the system does not tell.
std::uint64_t resident_bytes() {
    std::ifstream statm("/proc/self/statm");
    std::uint64_t total = 0;
    std::uint64_t resident = 0;
    statm >> total >> resident;
    return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

Budget::Budget(const Limits& limits) : limits_(limits), start_(std::chrono::steady_clock::now()) {}

void Budget::states(std::uint64_t count) const {
    if (count > limits_.max_states)
        throw LimitReached(fmt::format("the limit of {} states was reached", limits_.max_states));
}

double Budget::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Budget::poll() {
    if (limits_.interrupted && limits_.interrupted()) throw LimitReached("the check was interrupted");
    if (limits_.deadline && std::chrono::steady_clock::now() >= *limits_.deadline)
        throw LimitReached("the time limit was reached");
    if ((work_ & 0x7FFFU) == 1 && resident_bytes() > limits_.memory_bytes)
        throw LimitReached(fmt::format("the memory limit of {} MiB was reached", limits_.memory_bytes >> 20U));
}

}  // namespace robochart::refine
