// JSON of the protocol: messages are built as diagnostics::Json; what was received is read within bounds, and asked
// without care for its shape, as an editor may send anything.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/json.hpp"

namespace robochart::lsp {

using diagnostics::Json;
using diagnostics::json_text;

/// A value that was received; the value outlives the view. Each question is answered with what the value is, or with
/// the neutral one of its kind (null, "", 0, false, nothing) if it is something else.
class View {
public:
    View(const Json& json) : json_(&json) {}

    [[nodiscard]] View operator[](std::string_view key) const;
    [[nodiscard]] View operator[](std::size_t index) const;
    [[nodiscard]] const std::string& text() const;
    [[nodiscard]] std::int64_t number(std::int64_t otherwise = 0) const;
    [[nodiscard]] bool truth(bool otherwise = false) const;
    [[nodiscard]] std::vector<View> items() const;
    [[nodiscard]] const Json& json() const { return *json_; }

    [[nodiscard]] bool is_null() const { return json_->is_null(); }
    [[nodiscard]] bool is_text() const { return json_->is_string(); }
    /// An integer of 64 bits with sign; no other number is one.
    [[nodiscard]] bool is_number() const { return json_->is_number_integer(); }
    [[nodiscard]] bool is_array() const { return json_->is_array(); }
    [[nodiscard]] bool is_object() const { return json_->is_object(); }
    [[nodiscard]] bool has(std::string_view key) const;

private:
    const Json* json_;
};

/// Reads a text (RFC 8259). On failure returns null and sets `error` to the cause; depth is bounded, time and memory
/// are linear in the text. Integers beyond 64 bits with sign are read as floating-point numbers; of members with one
/// key all are kept, and the first is found.
[[nodiscard]] Json read_json(std::string_view text, std::string& error);

}  // namespace robochart::lsp
