// SPDX-License-Identifier: Apache-2.0
// Represents a message from the server. It has the accessors that the server uses for received messages
// (editors/server/protocol/json.hpp).
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "editors/server/protocol/json.hpp"

namespace robochart::lsp::testing {

/// Owns its value, so that tests can take answers apart in one expression.
class Answer {
public:
    Answer(Json json = nullptr) : json_(std::move(json)) {}

    Answer operator[](std::string_view key) const { return View(json_)[key].json(); }
    Answer operator[](std::size_t index) const { return View(json_)[index].json(); }
    [[nodiscard]] std::string text() const { return View(json_).text(); }
    [[nodiscard]] std::int64_t number(std::int64_t otherwise = 0) const { return View(json_).number_or(otherwise); }
    [[nodiscard]] bool truth(bool otherwise = false) const { return View(json_).truth_or(otherwise); }
    [[nodiscard]] std::vector<Answer> items() const {
        std::vector<Answer> result;
        for (const View item : View(json_).items()) result.emplace_back(item.json());
        return result;
    }
    [[nodiscard]] bool has(std::string_view key) const { return View(json_).has_key(key); }
    [[nodiscard]] bool is_null() const { return json_.is_null(); }
    [[nodiscard]] bool is_array() const { return json_.is_array(); }
    [[nodiscard]] bool is_object() const { return json_.is_object(); }
    [[nodiscard]] const Json& json() const { return json_; }
    [[nodiscard]] std::string write() const { return json_text(json_); }

    friend bool operator==(const Answer& a, const Answer& b) { return a.json_ == b.json_; }

private:
    Json json_;
};

}  // namespace robochart::lsp::testing
