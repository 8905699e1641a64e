// SPDX-License-Identifier: Apache-2.0
// See method.hpp.
#include "prism/sampling/method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

namespace robochart::prism {
namespace {

constexpr std::array names = {"ci", "aci", "apmc", "sprt"};

template <class Number>
std::optional<Number> number(const std::string& text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// Parses a number strictly between 0 and 1.
double share(const std::string& part, const std::string& text) {
    const std::optional<double> value = number<double>(text);
    if (!value || !(*value > 0 && *value < 1)) throw BadMethod(part + ": expected a number between 0 and 1");
    return *value;
}

double above_zero(const std::string& part, const std::string& text) {
    const std::optional<double> value = number<double>(text);
    if (!value || !std::isfinite(*value) || !(*value > 0)) throw BadMethod(part + ": expected a number above 0");
    return *value;
}

std::uint64_t parse_count(const std::string& part, const std::string& text) {
    const std::optional<std::uint64_t> value = number<std::uint64_t>(text);
    if (!value || *value == 0) throw BadMethod(part + ": expected a number from 1 on");
    return *value;
}

void set(Method& method, const std::string& part) {
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string key = part.substr(0, equals);
    const std::string value = part.substr(std::min(part.size(), equals + 1));
    const bool sprt = method.kind == Method::Kind::sprt;
    if (key == "samples" && !sprt)
        method.samples = parse_count(part, value);
    else if (key == "width")
        method.width = above_zero(part, value);
    else if (key == "confidence")
        method.confidence = share(part, value);
    else if (key == "path")
        method.path = parse_count(part, value);
    else
        throw BadMethod(fmt::format("{}: {} takes {}width, confidence and path", part, method_name(method.kind),
                                    sprt ? "" : "samples, "));
}

}  // namespace

const char* method_name(Method::Kind kind) {
    return names.at(static_cast<std::size_t>(kind));
}

Method read_method(const std::string& text) {
    std::istringstream parts(text);
    std::string part;
    std::getline(parts, part, ',');
    const auto name = std::ranges::find(names, part);
    if (name == names.end()) throw BadMethod(fmt::format("'{}' is no method: ci, aci, apmc or sprt", part));
    Method method;
    method.kind = static_cast<Method::Kind>(name - names.begin());
    while (!parts.eof()) {
        std::getline(parts, part, ',');
        set(method, part);
    }
    if (method.samples && method.width && method.confidence)
        throw BadMethod("give two of samples, width and confidence; the third follows from them");
    return method;
}

}  // namespace robochart::prism
