// JSON values of the protocol: read with bounds, built by handlers, written.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace robochart::lsp {

/// A JSON value (RFC 8259). Members of objects keep their order.
class Json {
public:
    using Array = std::vector<Json>;
    using Member = std::pair<std::string, Json>;
    using Object = std::vector<Member>;

    Json();
    ~Json();
    Json(const Json&);
    Json(Json&&) noexcept;
    Json& operator=(const Json&);
    Json& operator=(Json&&) noexcept;
    Json(std::nullptr_t) : Json() {}
    Json(bool value) : value_(value) {}
    template <std::integral Number>
    requires(!std::same_as<Number, bool>) Json(Number value) : value_(static_cast<std::int64_t>(value)) {}
    Json(double value) : value_(value) {}
    Json(std::string value) : value_(std::move(value)) {}
    Json(std::string_view value) : value_(std::string(value)) {}
    Json(const char* value) : value_(std::string(value)) {}
    Json(Array value) : value_(std::move(value)) {}
    Json(Object value) : value_(std::move(value)) {}
    /// An object of these members.
    static Json object(std::initializer_list<Member> members) { return Json(Object(members)); }
    static Json array(std::initializer_list<Json> items = {}) { return Json(Array(items)); }

    /// Each is a value of its kind, or the neutral one (null, "", 0, false, nothing) of anything else.
    [[nodiscard]] const Json& operator[](std::string_view key) const;
    [[nodiscard]] const Json& operator[](std::size_t index) const;
    [[nodiscard]] const std::string& text() const;
    [[nodiscard]] std::int64_t number(std::int64_t otherwise = 0) const;
    [[nodiscard]] bool truth(bool otherwise = false) const;
    [[nodiscard]] const Array& items() const;
    [[nodiscard]] const Object& members() const;

    [[nodiscard]] bool is_null() const { return std::holds_alternative<std::nullptr_t>(value_); }
    [[nodiscard]] bool is_text() const { return std::holds_alternative<std::string>(value_); }
    [[nodiscard]] bool is_number() const { return std::holds_alternative<std::int64_t>(value_); }
    [[nodiscard]] bool is_array() const { return std::holds_alternative<Array>(value_); }
    [[nodiscard]] bool is_object() const { return std::holds_alternative<Object>(value_); }
    [[nodiscard]] bool has(std::string_view key) const;

    /// Appends to an array, sets a member of an object; a null becomes one.
    void push(Json item);
    void set(std::string key, Json value);

    /// On one line.
    [[nodiscard]] std::string write() const;

    friend bool operator==(const Json&, const Json&) = default;

private:
    std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, Array, Object> value_ = nullptr;
};

/// Reads a text. On failure returns null and sets `error` to the cause; depth is bounded.
[[nodiscard]] Json read_json(std::string_view text, std::string& error);

}  // namespace robochart::lsp
