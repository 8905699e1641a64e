// SPDX-License-Identifier: Apache-2.0
// Keeps the state that the reader thread and the server share: pending messages, cancelled requests, the end of input.
#include "editors/server/protocol/interruption.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace robochart::lsp {

namespace {

/// True for notifications that change texts, so that earlier findings are outdated.
bool changes_texts(const std::string& method) {
    constexpr std::array<std::string_view, 5> methods = {"textDocument/didOpen", "textDocument/didChange",
                                                         "textDocument/didClose", "workspace/didChangeWatchedFiles",
                                                         "workspace/didChangeWorkspaceFolders"};
    return std::ranges::find(methods, method) != methods.end();
}

}  // namespace

void Interruption::note_arrival(View message) {
    const std::lock_guard lock(mutex_);
    const std::string& method = message["method"].text();
    if (method == "$/cancelRequest") cancelled_.push_back(message["params"]["id"].json());
    if (changes_texts(method)) ++changes_;
    if (method == "exit" || method == "shutdown") begin_leaving();
}

void Interruption::input_ended() {
    const std::lock_guard lock(mutex_);
    begin_leaving();
}

void Interruption::begin_leaving() {
    if (!leaving_) leaving_ = std::chrono::steady_clock::now() + grace;
}

void Interruption::note_handled(View message) {
    const std::lock_guard lock(mutex_);
    const std::string& method = message["method"].text();
    if (method == "$/cancelRequest") {
        const auto found = std::ranges::find(cancelled_, message["params"]["id"].json());
        if (found != cancelled_.end()) cancelled_.erase(found);
    }
    if (changes_texts(method)) ++handled_;
    changes_ = std::max(changes_, handled_);  // needed if no thread reads ahead
}

/// Begins work. A request is answered from the texts at the time of the request, even if a change is already waiting.
/// Work without a request computes findings, which are useless if a change is waiting.
Interruption::Work::Work(Interruption& interruption, const Json& id) : interruption_(interruption) {
    const std::lock_guard lock(interruption_.mutex_);
    interruption_.working_ = true;
    interruption_.id_ = id;
    interruption_.known_ = id.is_null() ? interruption_.handled_ : interruption_.changes_;
}

Interruption::Work::~Work() {
    const std::lock_guard lock(interruption_.mutex_);
    interruption_.working_ = false;
    interruption_.id_ = nullptr;
}

Interruption::Reason Interruption::current_reason() const {
    const std::lock_guard lock(mutex_);
    if (!working_) return Reason::none;
    if (!id_.is_null() && holds_cancelled(id_)) return Reason::cancelled;
    if (changes_ > known_) return Reason::modified;
    return leaving_ && std::chrono::steady_clock::now() >= *leaving_ ? Reason::leaving : Reason::none;
}

bool Interruption::is_cancelled(const Json& id) const {
    const std::lock_guard lock(mutex_);
    return holds_cancelled(id) || (leaving_ && std::chrono::steady_clock::now() >= *leaving_);
}

bool Interruption::holds_cancelled(const Json& id) const {
    return std::ranges::find(cancelled_, id) != cancelled_.end();
}

}  // namespace robochart::lsp
