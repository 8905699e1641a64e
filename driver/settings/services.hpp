// SPDX-License-Identifier: Apache-2.0
// Defines the services that a run provides to all phases: the budget, the cache, the display of progress, and searches
// in files. The phases print nothing.
#pragma once

#include <functional>
#include <mutex>
#include <string>

#include "base/cache/cache.hpp"
#include "base/diagnostics/budget.hpp"
#include "checker/refine/search/limits.hpp"

namespace robochart::driver {

/// The services of one run. By default, the run has no cache and shows no progress.
class Services {
public:
    Services() = default;
    virtual ~Services() = default;
    Services(const Services&) = delete;
    Services& operator=(const Services&) = delete;

    /// Returns the limits of time and memory, with the interruption of the run.
    [[nodiscard]] virtual diagnostics::Budget& budget() = 0;
    /// Returns the cache of earlier results, or null if no cache is used.
    [[nodiscard]] virtual diagnostics::Cache* cache() { return nullptr; }
    /// Returns a function that receives the progress of a search about this subject. The function is empty if progress
    /// is not shown.
    [[nodiscard]] virtual std::function<void(const refine::Progress&)> progress(const std::string& /*subject*/) {
        return {};
    }
    /// Returns true if an interrupted search can continue from stored states, so that a claim needs only one turn.
    [[nodiscard]] virtual bool continues_searches() const { return false; }
    /// Returns the strategy for searches in files or by several programs. Returns null if searches are in memory. All
    /// calls return the same object.
    [[nodiscard]] virtual refine::LevelStrategy* level_searches() { return nullptr; }
    /// Locks results that another thread may print. A thread must hold the lock while it changes these results. A
    /// thread may take the lock several times.
    [[nodiscard]] std::unique_lock<std::recursive_mutex> edit() { return std::unique_lock(results_mutex_); }

protected:
    /// Tries to take the lock of edit(). The result owns the lock, unless another thread holds the lock.
    [[nodiscard]] std::unique_lock<std::recursive_mutex> try_edit() {
        return std::unique_lock(results_mutex_, std::try_to_lock);
    }

private:
    std::recursive_mutex results_mutex_;
};

}  // namespace robochart::driver
