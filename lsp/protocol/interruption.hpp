// What ends work before it is done: the reading thread sees messages while the server is still busy with an earlier
// one. A cancelled request ends (LSP 3.17, $/cancelRequest), an analysis ends when its texts change, and everything
// ends soon after the editor wants to leave.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "lsp/protocol/json.hpp"

namespace robochart::lsp {

class Interruption {
public:
    enum class Reason { none, cancelled, modified, leaving };

    // By the thread that reads:
    /// A message has come. It may not be handled yet when work is asked whether it should end.
    void arrived(View message);
    /// Nothing more will come.
    void input_ended();

    // By the thread that works:
    /// While it lives, the server works: on the request of this id, or for its own sake (null).
    class Work {
    public:
        Work(Interruption& interruption, const Json& id);
        ~Work();
        Work(const Work&) = delete;
        Work& operator=(const Work&) = delete;

    private:
        Interruption& interruption_;
    };
    /// A message is about to be handled.
    void handled(View message);
    /// Why the work that is going on should end.
    [[nodiscard]] Reason reason() const;
    /// Is a request of this id not to be begun?
    [[nodiscard]] bool is_cancelled(const Json& id) const;

private:
    /// How long work may go on once the editor wants to leave: what was asked before is answered if that is quick.
    static constexpr std::chrono::milliseconds grace{500};

    [[nodiscard]] bool holds_cancelled(const Json& id) const;
    void leave();

    mutable std::mutex mutex_;
    bool working_ = false;
    Json id_;                      ///< of the request worked on
    std::uint64_t known_ = 0;      ///< changes that had come when the work began or are handled: older than its texts
    std::uint64_t changes_ = 0;    ///< that have come
    std::uint64_t handled_ = 0;    ///< and were handled
    std::vector<Json> cancelled_;  ///< ids, until the cancellation itself is handled
    std::optional<std::chrono::steady_clock::time_point> leaving_;
};

}  // namespace robochart::lsp
