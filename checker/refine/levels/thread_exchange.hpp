// Threads of one program as ranks.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <vector>

#include "checker/refine/levels/exchange.hpp"

namespace robochart::refine {

/// Another rank has left a search in which it is needed.
class RankLost : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Where threads meet. Each has an exchange of its own; the meeting outlives them.
class Meeting {
public:
    explicit Meeting(unsigned ranks) : ranks_(ranks), out_(ranks), words_(ranks), sums_(ranks), texts_(ranks) {}
    /// The exchange of a thread, which is rank `rank`.
    [[nodiscard]] std::unique_ptr<Exchange> exchange(unsigned rank);
    /// All others that wait, or ever will, get RankLost.
    void leave();

private:
    class Member;
    void wait();

    const unsigned ranks_;
    std::mutex mutex_;
    std::condition_variable all_here_;
    unsigned here_ = 0;
    std::uint64_t turn_ = 0;
    bool left_ = false;
    // What each has brought; changed by its owner between two waits in which nobody reads it.
    std::vector<const Messages*> out_;
    std::vector<const Words*> words_;
    std::vector<std::vector<std::uint64_t>> sums_;
    std::vector<const std::string*> texts_;
};

/// Calls `work` in so many threads at once, the caller's among them as rank 0, and returns when all have ended. Throws
/// what the first rank has thrown that met an error itself, or else has heard of another's (RankFailed), or else has
/// lost another one. Throws std::system_error where a thread cannot be started.
void as_ranks(unsigned ranks, const std::function<void(Exchange&)>& work);

}  // namespace robochart::refine
