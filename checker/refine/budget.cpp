// Limits of time, memory and states. Memory is what the whole program has resident, because the states of the
// systems that are searched are kept by them, not by the search.
#include "checker/refine/budget.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <thread>

namespace robochart::refine {
namespace {

constexpr std::chrono::milliseconds between_memory_checks{20};
constexpr std::chrono::milliseconds between_reports{100};

}  // namespace

std::uint64_t resident_bytes() {
    // No streams: this is asked where memory may be short.
    std::FILE* statm = std::fopen("/proc/self/statm", "re");
    if (statm == nullptr) return 0;
    unsigned long long total = 0;
    unsigned long long resident = 0;
    const int read = std::fscanf(statm, "%llu %llu", &total, &resident);
    std::fclose(statm);
    return read == 2 ? resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

Budget::Budget(const Limits& limits, Progress::Phase phase)
    : limits_(limits),
      phase_(phase),
      start_(std::chrono::steady_clock::now()),
      memory_checked_(start_),
      told_(start_),
      resident_at_start_(resident_bytes()),
      resident_(resident_at_start_) {}

void Budget::states(std::uint64_t count) const {
    constexpr std::uint64_t most_numbers = 4'000'000'000;  // states have numbers of 32 bits, with room to spare
    const std::uint64_t most = std::min(limits_.max_states, most_numbers);
    if (count > most) throw LimitReached(fmt::format("the limit of {} states was reached{}", most, whilst()));
}

double Budget::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

unsigned Budget::threads() const {
    return limits_.threads != 0 ? limits_.threads : std::max(1U, std::thread::hardware_concurrency());
}

std::string Budget::whilst() const {
    return phase_ == Progress::Phase::compiling ? " while compiling" : "";
}

void Budget::check_memory(Time now) {
    memory_checked_ = now;
    resident_ = resident_bytes();
    if (resident_ > limits_.memory_bytes)
        throw LimitReached(
            fmt::format("the memory limit of {} MiB was reached{}", limits_.memory_bytes >> 20U, whilst()));
}

void Budget::tell(Time now) {
    told_ = now;
    Progress progress;
    progress.phase = phase_;
    progress.seconds = std::chrono::duration<double>(now - start_).count();
    progress.resident_bytes = resident_;
    progress.grown_bytes = resident_ > resident_at_start_ ? resident_ - resident_at_start_ : 0;
    if (source_) source_(progress);
    limits_.progress(progress);
}

void Budget::poll() {
    const Time now = std::chrono::steady_clock::now();
    if (limits_.interrupted && limits_.interrupted()) throw LimitReached("the check was interrupted" + whilst());
    if (limits_.deadline && now >= *limits_.deadline) throw LimitReached("the time limit was reached" + whilst());
    if (now - memory_checked_ >= between_memory_checks || work_ == 1) check_memory(now);
    if (limits_.progress && now - told_ >= between_reports) tell(now);
}

}  // namespace robochart::refine
