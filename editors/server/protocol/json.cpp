// SPDX-License-Identifier: Apache-2.0
// Parses through nlohmann's event interface. nlohmann's own parser does not limit nesting, and it searches for an equal
// key before it adds a member, which takes quadratic time.
#include "editors/server/protocol/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace robochart::lsp {

namespace {

constexpr std::size_t max_depth = 200;

const Json null_value;
const std::string no_text;

/// Receives the events of the parser and builds the value.
class Builder {
public:
    explicit Builder(std::string& error) : error_(error) {}
    [[nodiscard]] Json take_root() { return std::move(root_); }

    bool null() { return put_value(nullptr); }
    bool boolean(bool value) { return put_value(value); }
    bool number_integer(std::int64_t value) { return put_value(value); }
    bool number_unsigned(std::uint64_t value) {
        if (value > static_cast<std::uint64_t>(INT64_MAX)) return put_value(static_cast<double>(value));
        return put_value(static_cast<std::int64_t>(value));
    }
    bool number_float(double value, const std::string&) { return put_value(value); }
    bool string(std::string& value) { return put_value(std::move(value)); }
    bool binary(Json::binary_t&) { return false; }
    bool start_object(std::size_t) { return open_container(Json::object()); }
    bool start_array(std::size_t) { return open_container(Json::array()); }
    bool key(std::string& value) {
        keys_.back() = std::move(value);
        return true;
    }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    bool parse_error(std::size_t, const std::string&, const Json::exception& what) {
        error_ = what.what();
        return false;
    }

private:
    bool put_value(Json value) {
        if (open_.empty()) {
            root_ = std::move(value);
        } else if (open_.back().is_array()) {
            open_.back().push_back(std::move(value));
        } else {
            Json::object_t::Container& members = open_.back().get_ref<Json::object_t&>();
            members.emplace_back(std::move(keys_.back()), std::move(value));
        }
        return true;
    }
    bool open_container(Json value) {
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
        return put_value(std::move(value));
    }

    std::string& error_;
    Json root_;
    std::vector<Json> open_;
    std::vector<std::string> keys_;
};

}  // namespace

View View::operator[](std::string_view key) const {
    if (!json_->is_object()) return null_value;
    const auto member = json_->find(key);
    return member == json_->end() ? null_value : *member;
}

View View::operator[](std::size_t index) const {
    return json_->is_array() && index < json_->size() ? (*json_)[index] : null_value;
}

const std::string& View::text() const {
    return json_->is_string() ? json_->get_ref<const std::string&>() : no_text;
}

std::int64_t View::number_or(std::int64_t otherwise) const {
    return is_number() ? json_->get<std::int64_t>() : otherwise;
}

bool View::truth_or(bool otherwise) const {
    return json_->is_boolean() ? json_->get<bool>() : otherwise;
}

std::vector<View> View::items() const {
    return json_->is_array() ? std::vector<View>(json_->begin(), json_->end()) : std::vector<View>{};
}

bool View::has_key(std::string_view key) const {
    return json_->is_object() && json_->contains(key);
}

Json read_json(std::string_view text, std::string& error) {
    error.clear();
    Builder builder(error);
    const bool read = Json::sax_parse(text.begin(), text.end(), &builder);
    if (!read && error.empty()) error = "not JSON";
    return read ? builder.take_root() : Json();
}

}  // namespace robochart::lsp
