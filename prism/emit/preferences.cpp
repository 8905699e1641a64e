// SPDX-License-Identifier: Apache-2.0
#include "prism/emit/preferences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "base/diagnostics/spelling.hpp"

namespace robochart::prism_emit {
namespace {

constexpr const char* kind_key = "PRISM_MODELTYPE";

std::string_view trim_blanks(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
    return text;
}

/// Reads a whole number of PRISM, with 32 bits.
bool read_number(std::string_view text, std::int64_t& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() &&
           number >= std::numeric_limits<std::int32_t>::min() && number <= std::numeric_limits<std::int32_t>::max();
}

bool read_kind(std::string_view text, prism::ModelKind& kind) {
    if (text != "dtmc" && text != "mdp") return false;
    kind = text == "mdp" ? prism::ModelKind::mdp : prism::ModelKind::dtmc;
    return true;
}

/// Returns whether a setting of RoboTool does not affect the model. Such settings are empty, or about logs, or about
/// the order of modules.
bool means_nothing(std::string_view key, std::string_view value) {
    static constexpr std::string_view others[] = {"DBG_OPTION", "ERROR_LOG_FILE", "OUTPUT_LOG_FILE", "STM_GEN_ORDER"};
    return value.empty() || value == "false" || std::ranges::find(others, key) != std::end(others);
}

std::string read_line(std::string_view line, Preferences& preferences) {
    if (line.empty() || line.front() == '#') return "";
    const auto equals = line.find('=');
    if (equals == std::string_view::npos) return "KEY=VALUE is expected";
    const std::string key(trim_blanks(line.substr(0, equals)));
    const std::string_view value = trim_blanks(line.substr(equals + 1));
    struct Bound {
        Range* range;
        std::int64_t Range::*side;
    };
    const std::map<std::string, Bound> bounds{
        {"NAT_MIN", {&preferences.nat, &Range::low}},     {"NAT_MAX", {&preferences.nat, &Range::high}},
        {"INT_MIN", {&preferences.integer, &Range::low}}, {"INT_MAX", {&preferences.integer, &Range::high}},
        {"REAL_MIN", {&preferences.real, &Range::low}},   {"REAL_MAX", {&preferences.real, &Range::high}},
    };
    const auto bound = bounds.find(key);
    if (bound != bounds.end()) {
        Range& range = *bound->second.range;
        range.asked = true;
        return read_number(value, range.*(bound->second.side)) ? "" : key + ": a whole number is expected";
    }
    if (key == kind_key) return read_kind(value, preferences.kind) ? "" : key + ": dtmc or mdp is expected";
    // Unknown keys are reported, because a misspelt key would silently have no effect on a range.
    std::vector<std::string> keys{kind_key};
    for (const auto& [name, range] : bounds) keys.push_back(name);
    const std::string meant = diagnostics::nearest_spelling(key, keys);
    if (diagnostics::is_certain(key, meant, keys)) return fmt::format("{}: did you mean {}?", key, meant);
    if (!means_nothing(key, value)) preferences.ignored.push_back(key);
    return "";
}

}  // namespace

std::string read_preferences(std::string_view text, Preferences& preferences, std::size_t* wrong_line) {
    for (std::size_t number = 1; !text.empty(); ++number) {
        const auto end = text.find('\n');
        const std::string error = read_line(trim_blanks(text.substr(0, end)), preferences);
        if (!error.empty()) {
            if (wrong_line != nullptr) *wrong_line = number;
            return fmt::format("line {}: {}", number, error);
        }
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    for (const auto& [name, range] : {std::pair("NAT", preferences.nat), std::pair("INT", preferences.integer),
                                      std::pair("REAL", preferences.real)})
        if (range.low > range.high) return fmt::format("{0}_MIN is greater than {0}_MAX", name);
    return "";
}

}  // namespace robochart::prism_emit
