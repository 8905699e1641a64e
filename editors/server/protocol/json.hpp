// SPDX-License-Identifier: Apache-2.0
// Reads JSON of the protocol. Messages are built as diagnostics::Json. Received messages are parsed within bounds and
// accessed without assumptions about their structure, because an editor may send anything.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/json.hpp"

namespace robochart::lsp {

using diagnostics::Json;
using diagnostics::json_text;

/// A view of a received value, which must outlive it. Each accessor returns the value if it has the requested type,
/// otherwise the neutral value of that type (null, "", 0, false, or no value).
class View {
public:
    View(const Json& json) : json_(&json) {}

    [[nodiscard]] View operator[](std::string_view key) const;
    [[nodiscard]] View operator[](std::size_t index) const;
    [[nodiscard]] const std::string& text() const;
    [[nodiscard]] std::int64_t number_or(std::int64_t otherwise = 0) const;
    [[nodiscard]] bool truth_or(bool otherwise = false) const;
    [[nodiscard]] std::vector<View> items() const;
    [[nodiscard]] const Json& json() const { return *json_; }

    [[nodiscard]] bool is_null() const { return json_->is_null(); }
    [[nodiscard]] bool is_text() const { return json_->is_string(); }
    /// True for a signed 64-bit integer; false for any other number.
    [[nodiscard]] bool is_number() const { return json_->is_number_integer(); }
    [[nodiscard]] bool is_array() const { return json_->is_array(); }
    [[nodiscard]] bool is_object() const { return json_->is_object(); }
    [[nodiscard]] bool has_key(std::string_view key) const;

private:
    const Json* json_;
};

/// Parses a text (RFC 8259). On failure returns null and sets `error` to the cause. Nesting is limited; time and memory
/// are linear in the text. Integers beyond 64 bits are read as floating-point numbers. All members with equal keys are
/// stored, and lookup finds the first.
[[nodiscard]] Json read_json(std::string_view text, std::string& error);

}  // namespace robochart::lsp
