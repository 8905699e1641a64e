// SPDX-License-Identifier: Apache-2.0
// Defines the states of the server, the messages that are allowed in each state, and the functions that handle them
// (LSP 3.17, lifecycle messages; JSON-RPC 2.0).
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

#include "base/diagnostics/budget.hpp"
#include "editors/server/claims/claim_texts.hpp"
#include "editors/server/cspm/scripts.hpp"
#include "editors/server/features/models.hpp"
#include "editors/server/plain/plain_texts.hpp"
#include "editors/server/protocol/interruption.hpp"
#include "editors/server/sleec/rule_texts.hpp"

namespace robochart::lsp {

class Server {
public:
    /// `send` is called to send a message, as JSON text, to the editor.
    explicit Server(std::function<void(const std::string&)> send);

    /// The interruption that the reader thread uses to report messages while the server works.
    [[nodiscard]] Interruption& interruption() { return interruption_; }
    /// Adds a message to the queue.
    void receive_message(const std::string& text);
    /// Adds a message that is already parsed. If `fault` is not empty, there is no message, and the server answers with
    /// a parse error.
    void receive_message(Json message, std::string fault);
    /// Handles the first message of the queue. A request is not started if the queue contains its cancellation.
    void handle_next();
    [[nodiscard]] bool has_work() const { return !queue_.empty(); }
    /// Sends diagnostics that changed. Called when no message is queued.
    void use_idle_time();

    /// The exit code of the process; no value until the editor has sent `exit`.
    [[nodiscard]] std::optional<int> exit_code() const { return exit_code_; }

private:
    struct Message {
        Json json;
        std::string fault;
    };
    enum class Phase { fresh, running, shut_down };

    void handle_message(View message);
    void handle_request(View message);
    void handle_notification(const std::string& method, View params);
    [[nodiscard]] Json answer_request(const std::string& method, View params);
    [[nodiscard]] Json initialize(View params);
    /// Returns the language of `textDocument` or `item`.
    [[nodiscard]] Language& language_of(View params);
    void change_files(View changes);
    void change_folders(View event);
    [[nodiscard]] bool is_cancelled(const Json& id) const;
    void ended_early(const Json& id);
    void log_message(const std::string& where, const char* what);
    void send_response(const Json& id, Json result);
    void send_error(const Json& id, ErrorCode code, const std::string& why);

    Interruption interruption_;
    diagnostics::Budget budget_;  ///< interrupts work if `interruption_` has a reason
    Session session_;
    Scripts scripts_;
    RuleTexts rules_;
    ClaimTexts claims_;
    PlainTexts plain_;
    Models models_;
    std::array<Language*, 5> languages_ = {&scripts_, &rules_, &claims_, &plain_,
                                           &models_};  ///< models accept all documents
    std::deque<Message> queue_;
    Phase phase_ = Phase::fresh;
    std::optional<int> exit_code_;
};

/// Serves one editor over a pair of streams until it exits or the input ends. Returns the exit code of the process.
int serve(std::istream& in, std::ostream& out);

}  // namespace robochart::lsp
