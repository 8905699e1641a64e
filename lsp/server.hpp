// The server's life: which messages are allowed when, and who answers them (LSP 3.17, lifecycle messages;
// JSON-RPC 2.0).
#pragma once

#include <deque>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

#include "diagnostics/budget.hpp"
#include "lsp/cspm/scripts.hpp"
#include "lsp/plain/plain_texts.hpp"
#include "lsp/protocol/interruption.hpp"
#include "lsp/sleec/rule_texts.hpp"
#include "lsp/workspace/session.hpp"

namespace robochart::lsp {

class Server {
public:
    /// `send` takes each message to the editor, as JSON text.
    explicit Server(std::function<void(const std::string&)> send);

    /// What the reading thread tells while the server works.
    [[nodiscard]] Interruption& interruption() { return interruption_; }
    /// Puts a message into the queue.
    void receive(const std::string& text);
    /// The same for one that was read already. With a fault, which is answered with a parse error, there is none.
    void receive(Json message, std::string fault);
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

    void handle(View message);
    void request(View message);
    void notification(const std::string& method, View params);
    [[nodiscard]] Json answer(const std::string& method, View params);
    [[nodiscard]] Json initialize(View params);
    [[nodiscard]] bool is_cancelled(const Json& id) const;
    void ended_early(const Json& id);
    void log(const std::string& where, const char* what);
    void respond(const Json& id, Json result);
    void fail(const Json& id, ErrorCode code, const std::string& why);

    Interruption interruption_;
    diagnostics::Budget budget_;  ///< ends what `interruption_` says should end
    Session session_;
    Scripts scripts_;
    RuleTexts rules_;
    PlainTexts plain_;
    std::deque<Message> queue_;
    Phase phase_ = Phase::fresh;
    std::optional<int> exit_code_;
};

/// Serves one editor over a pair of streams until it exits or the input ends; the process's exit code.
int serve(std::istream& in, std::ostream& out);

}  // namespace robochart::lsp
