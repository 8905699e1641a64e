// SPDX-License-Identifier: Apache-2.0
// Implements the limits of a run. Memory is the resident memory of this program and of the processes that it has
// started, as the system reports it. So the memory of a compiler of generated code is included.
#include "base/diagnostics/budget.hpp"

#include <dirent.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

namespace robochart::diagnostics {

namespace {

constexpr std::chrono::milliseconds between_memory_checks{10};

using OpenFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

OpenFile open_for_reading(const char* path) {
    return {std::fopen(path, "re"), std::fclose};
}

/// Returns the second number of a `statm` file. It is read without streams, because memory may be short here.
std::uint64_t resident_in(const char* statm) {
    const OpenFile file = open_for_reading(statm);
    unsigned long long total = 0;
    unsigned long long resident = 0;
    if (!file || std::fscanf(file.get(), "%llu %llu", &total, &resident) != 2) return 0;
    return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// Returns the size in MiB, KiB or bytes, in the largest unit that gives at least 1. The number is rounded down.
std::string size_text(std::uint64_t bytes) {
    constexpr std::uint64_t kibibyte = 1U << 10U;
    constexpr std::uint64_t mebibyte = 1U << 20U;
    if (bytes >= mebibyte) return fmt::format("{} MiB", bytes / mebibyte);
    if (bytes >= kibibyte) return fmt::format("{} KiB", bytes / kibibyte);
    return fmt::format("{} bytes", bytes);
}

std::vector<pid_t> children_of(pid_t process) {
    std::vector<pid_t> children;
    const std::string tasks = fmt::format("/proc/{}/task", process);
    const std::unique_ptr<DIR, int (*)(DIR*)> folder(opendir(tasks.c_str()), closedir);
    if (!folder) return children;
    while (const dirent* task = readdir(folder.get())) {
        if (task->d_name[0] == '.') continue;
        const OpenFile file = open_for_reading(fmt::format("{}/{}/children", tasks, task->d_name).c_str());
        long child = 0;
        while (file && std::fscanf(file.get(), "%ld", &child) == 1) children.push_back(static_cast<pid_t>(child));
    }
    return children;
}

}  // namespace

std::uint64_t resident_bytes() {
    return resident_in("/proc/self/statm");
}

std::uint64_t resident_bytes_of_tree(pid_t process) {
    std::uint64_t bytes = 0;
    std::vector<pid_t> open{process};
    // The limit on the number of processes ends the loop even if the process tree changes during it.
    for (std::size_t i = 0; i < open.size() && i < 10'000; ++i) {
        bytes += resident_in(fmt::format("/proc/{}/statm", open[i]).c_str());
        for (const pid_t child : children_of(open[i])) open.push_back(child);
    }
    return bytes;
}

Budget::Budget(Limits limits, std::string phase)
    : limits_(std::move(limits)), memory_checked_(0), phase_(std::move(phase)) {}

void Budget::check() {
    if (const std::string why = reached_limit(); !why.empty()) throw LimitReached(why);
}

std::string Budget::reached_limit() {
    const Time now = std::chrono::steady_clock::now();
    std::string why;
    if (interrupted_.load() || (limits_.interrupted && limits_.interrupted()))
        why = "the run was interrupted";
    else if (limits_.deadline && now >= *limits_.deadline)
        why = "the time limit was reached";
    else if (memory_exceeded(now))
        why = fmt::format("the memory limit of {} was reached", size_text(limits_.memory_bytes));
    if (why.empty()) {
        stopped_ = false;  // the interruption may have been withdrawn
        return why;
    }
    stopped_ = true;
    return why + while_what();
}

void Budget::interrupt() {
    interrupted_ = true;
    stopped_ = true;
}

/// Measures memory at most a hundred times a second. Between two measurements, the last value is used.
bool Budget::memory_exceeded(Time now) {
    const std::int64_t ticks = now.time_since_epoch().count();
    const std::chrono::steady_clock::duration since(ticks - memory_checked_.load(std::memory_order_relaxed));
    if (since >= between_memory_checks) {
        memory_checked_.store(ticks, std::memory_order_relaxed);
        std::uint64_t bytes = resident_bytes();
        std::vector<pid_t> groups;
        {
            const std::lock_guard lock(mutex_);
            groups.assign(groups_.begin(), groups_.end());
        }
        for (const pid_t group : groups) bytes += resident_bytes_of_tree(group);
        resident_.store(bytes, std::memory_order_relaxed);
    }
    return resident_.load(std::memory_order_relaxed) > limits_.memory_bytes;
}

std::string Budget::while_what() const {
    const std::lock_guard lock(mutex_);
    return phase_.empty() ? "" : " while " + phase_;
}

Budget::Phase::Phase(Budget& budget, std::string what) : budget_(budget) {
    budget.check();
    const std::lock_guard lock(budget.mutex_);
    before_ = std::exchange(budget.phase_, std::move(what));
}

Budget::Phase::~Phase() {
    const std::lock_guard lock(budget_.mutex_);
    budget_.phase_ = std::move(before_);
}

Budget::Held::Held(Budget* budget, std::string path) : budget_(budget), path_(std::move(path)) {
    if (budget_ == nullptr) return;
    const std::lock_guard lock(budget_->mutex_);
    budget_->paths_.insert(path_);
}

Budget::Held::Held(Budget* budget, pid_t group) : budget_(budget), group_(group) {
    if (budget_ == nullptr) return;
    const std::lock_guard lock(budget_->mutex_);
    budget_->groups_.insert(group_);
}

Budget::Held::~Held() {
    if (budget_ == nullptr) return;
    const std::lock_guard lock(budget_->mutex_);
    if (group_ != 0)
        budget_->groups_.erase(budget_->groups_.find(group_));
    else
        budget_->paths_.erase(budget_->paths_.find(path_));
}

void Budget::release_resources() {
    const std::lock_guard lock(mutex_);
    for (const pid_t group : groups_) kill(-group, SIGKILL);
    std::error_code ignored;
    for (const std::string& path : paths_) std::filesystem::remove_all(path, ignored);
}

}  // namespace robochart::diagnostics
