// See parallel.hpp.
#include "checker/prism/sampling/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace robochart::prism {

unsigned threads_wanted(unsigned asked) {
    return asked > 0 ? asked : std::max(1U, std::thread::hardware_concurrency());
}

void in_parallel(std::size_t count, unsigned threads,
                 const std::function<void(std::size_t number, unsigned thread)>& work) {
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> failed = false;
    std::mutex mutex;
    std::size_t worst = count;
    std::exception_ptr exception;
    const auto take = [&](unsigned thread) {
        while (!failed) {
            const std::size_t number = next++;
            if (number >= count) return;
            try {
                work(number, thread);
            } catch (...) {
                const std::lock_guard lock(mutex);
                failed = true;
                if (number >= worst) continue;
                worst = number;
                exception = std::current_exception();
            }
        }
    };
    std::vector<std::jthread> helpers;  // joined also where one cannot be started
    const std::size_t team = std::min<std::size_t>(std::max(1U, threads), count);
    for (unsigned i = 1; i < team; ++i) helpers.emplace_back(take, i);
    take(0);
    helpers.clear();
    if (exception) std::rethrow_exception(exception);
}

}  // namespace robochart::prism
