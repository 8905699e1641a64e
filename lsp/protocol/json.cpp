// Reading through nlohmann's event interface, which neither recurses nor builds a second tree.
#include "lsp/protocol/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "diagnostics/json.hpp"

namespace robochart::lsp {

namespace {

const Json null_value;

constexpr std::size_t max_depth = 200;

/// Receives the events of the reader and builds the value.
class Builder {
public:
    explicit Builder(std::string& error) : error_(error) {}
    [[nodiscard]] Json take() { return std::move(root_); }

    bool null() { return put(nullptr); }
    bool boolean(bool value) { return put(value); }
    bool number_integer(std::int64_t value) { return put(value); }
    bool number_unsigned(std::uint64_t value) {
        if (value > static_cast<std::uint64_t>(INT64_MAX)) return put(static_cast<double>(value));
        return put(static_cast<std::int64_t>(value));
    }
    bool number_float(double value, const std::string&) { return put(value); }
    bool string(std::string& value) { return put(std::move(value)); }
    bool binary(nlohmann::json::binary_t&) { return false; }
    bool start_object(std::size_t) { return open(Json(Json::Object())); }
    bool start_array(std::size_t) { return open(Json(Json::Array())); }
    bool key(std::string& value) {
        keys_.back() = std::move(value);
        return true;
    }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& what) {
        error_ = what.what();
        return false;
    }

private:
    bool put(Json value) {
        if (open_.empty()) {
            root_ = std::move(value);
        } else if (open_.back().is_array()) {
            open_.back().push(std::move(value));
        } else {
            open_.back().set(std::move(keys_.back()), std::move(value));
        }
        return true;
    }
    bool open(Json value) {
        if (open_.size() >= max_depth) {
            error_ = fmt::format("nested deeper than {} levels", max_depth);
            return false;
        }
        open_.push_back(std::move(value));
        keys_.emplace_back();
        return true;
    }
    bool close() {
        Json value = std::move(open_.back());
        open_.pop_back();
        keys_.pop_back();
        return put(std::move(value));
    }

    std::string& error_;
    Json root_;
    std::vector<Json> open_;
    std::vector<std::string> keys_;
};

struct Writer {
    std::string& out;

    void operator()(std::nullptr_t) const { out += "null"; }
    void operator()(bool value) const { out += value ? "true" : "false"; }
    void operator()(std::int64_t value) const { fmt::format_to(std::back_inserter(out), "{}", value); }
    void operator()(double value) const { fmt::format_to(std::back_inserter(out), "{}", value); }
    void operator()(const std::string& value) const { out += diagnostics::json_string(value); }
    void operator()(const Json::Array& items) const {
        out += '[';
        for (const Json& item : items) {
            if (&item != &items.front()) out += ',';
            out += item.write();
        }
        out += ']';
    }
    void operator()(const Json::Object& members) const {
        out += '{';
        for (const Json::Member& member : members) {
            if (&member != &members.front()) out += ',';
            out += diagnostics::json_string(member.first) + ':' + member.second.write();
        }
        out += '}';
    }
};

}  // namespace

// Here rather than in the header: the compiler need not write them out wherever a value is handed on.
Json::Json() = default;
Json::~Json() = default;
Json::Json(const Json&) = default;
Json::Json(Json&&) noexcept = default;
Json& Json::operator=(const Json&) = default;
Json& Json::operator=(Json&&) noexcept = default;

const Json& Json::operator[](std::string_view key) const {
    for (const Member& member : members())
        if (member.first == key) return member.second;
    return null_value;
}

const Json& Json::operator[](std::size_t index) const {
    return index < items().size() ? items()[index] : null_value;
}

const std::string& Json::text() const {
    static const std::string none;
    const auto* value = std::get_if<std::string>(&value_);
    return value != nullptr ? *value : none;
}

std::int64_t Json::number(std::int64_t otherwise) const {
    const auto* value = std::get_if<std::int64_t>(&value_);
    return value != nullptr ? *value : otherwise;
}

bool Json::truth(bool otherwise) const {
    const auto* value = std::get_if<bool>(&value_);
    return value != nullptr ? *value : otherwise;
}

const Json::Array& Json::items() const {
    static const Array none;
    const auto* value = std::get_if<Array>(&value_);
    return value != nullptr ? *value : none;
}

const Json::Object& Json::members() const {
    static const Object none;
    const auto* value = std::get_if<Object>(&value_);
    return value != nullptr ? *value : none;
}

bool Json::has(std::string_view key) const {
    return std::any_of(members().begin(), members().end(), [&](const Member& m) { return m.first == key; });
}

void Json::push(Json item) {
    if (!is_array()) value_ = Array();
    std::get<Array>(value_).push_back(std::move(item));
}

void Json::set(std::string key, Json value) {
    if (!is_object()) value_ = Object();
    std::get<Object>(value_).emplace_back(std::move(key), std::move(value));
}

std::string Json::write() const {
    std::string out;
    std::visit(Writer{out}, value_);
    return out;
}

Json read_json(std::string_view text, std::string& error) {
    error.clear();
    Builder builder(error);
    const bool read = nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
    if (!read && error.empty()) error = "not JSON";
    return read ? builder.take() : Json();
}

}  // namespace robochart::lsp
