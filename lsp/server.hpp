// The server's life: which messages are allowed when, and who answers them (LSP 3.17, lifecycle messages;
// JSON-RPC 2.0).
#pragma once

#include <deque>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

#include "lsp/session.hpp"

namespace robochart::lsp {

class Server {
public:
    /// `send` takes each message to the editor, as JSON text.
    explicit Server(std::function<void(const std::string&)> send);

    /// Puts a message into the queue.
    void receive(std::string text);
    /// Puts a fault of the stream into the queue: it is answered with a parse error.
    void receive_fault(const std::string& what);
    /// Handles the first message of the queue. A request that the queue also cancels is not begun.
    void step();
    [[nodiscard]] bool has_work() const { return !queue_.empty(); }
    /// For when nothing is queued: sends what changed in the diagnostics.
    void idle();

    /// The process's exit code, once the editor asked to exit.
    [[nodiscard]] std::optional<int> exit_code() const { return exit_code_; }

private:
    struct Message {
        Json json;
        std::string fault;
    };
    enum class Phase { fresh, running, shut_down };

    void handle(const Json& message);
    void request(const Json& message);
    void notification(const std::string& method, const Json& params);
    [[nodiscard]] Json answer(const std::string& method, const Json& params);
    [[nodiscard]] Json initialize(const Json& params);
    [[nodiscard]] bool is_cancelled(const Json& id) const;
    void log(const std::string& where, const char* what);
    void respond(const Json& id, Json result);
    void fail(const Json& id, ErrorCode code, const std::string& why);

    Session session_;
    std::deque<Message> queue_;
    Phase phase_ = Phase::fresh;
    std::optional<int> exit_code_;
};

/// Serves one editor over a pair of streams until it exits or the input ends; the process's exit code.
int serve(std::istream& in, std::ostream& out);

}  // namespace robochart::lsp
