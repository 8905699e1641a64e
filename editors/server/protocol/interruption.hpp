// SPDX-License-Identifier: Apache-2.0
// Interrupts work that is no longer needed. The reader thread sees messages while the server still handles an earlier
// one. A cancelled request ends (LSP 3.17, $/cancelRequest), an analysis ends when its texts change, and everything
// ends soon after the editor requests to exit.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "editors/server/protocol/json.hpp"

namespace robochart::lsp {

class Interruption {
public:
    enum class Reason { none, cancelled, modified, leaving };

    // Called by the reader thread:
    /// Records that a message has arrived. The message may end the current work before it is handled.
    void note_arrival(View message);
    /// Records that the input has ended.
    void input_ended();

    // Called by the working thread:
    /// While the object exists, the server works on the request with this id, or without a request (null).
    class Work {
    public:
        Work(Interruption& interruption, const Json& id);
        ~Work();
        Work(const Work&) = delete;
        Work& operator=(const Work&) = delete;

    private:
        Interruption& interruption_;
    };
    /// Must be called before a message is handled.
    void note_handled(View message);
    /// Returns the reason why the current work should end.
    [[nodiscard]] Reason current_reason() const;
    /// True if a request with this id must not be started.
    [[nodiscard]] bool is_cancelled(const Json& id) const;

private:
    /// Work may continue for this time after the editor requests to exit, so that quick requests can still be answered.
    static constexpr std::chrono::milliseconds grace{500};

    [[nodiscard]] bool holds_cancelled(const Json& id) const;
    void begin_leaving();

    mutable std::mutex mutex_;
    bool working_ = false;
    Json id_;                      ///< id of the current request
    std::uint64_t known_ = 0;      ///< number of changes that do not end the current work
    std::uint64_t changes_ = 0;    ///< changes that have arrived
    std::uint64_t handled_ = 0;    ///< changes that were handled
    std::vector<Json> cancelled_;  ///< ids, until the cancellation itself is handled
    std::optional<std::chrono::steady_clock::time_point> leaving_;
};

}  // namespace robochart::lsp
