#include "prism_emit/preferences.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "diagnostics/spelling.hpp"

namespace robochart::prism_emit {
namespace {

constexpr const char* kind_key = "PRISM_MODELTYPE";

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
    return text;
}

/// A whole number of PRISM: of 32 bits.
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

std::string read_line(std::string_view line, Preferences& preferences) {
    if (line.empty() || line.front() == '#') return "";
    const auto equals = line.find('=');
    if (equals == std::string_view::npos) return "KEY=VALUE is expected";
    const std::string key(trimmed(line.substr(0, equals)));
    const std::string_view value = trimmed(line.substr(equals + 1));
    const std::map<std::string, std::int64_t*> bounds{
        {"NAT_MIN", &preferences.nat.low},     {"NAT_MAX", &preferences.nat.high},
        {"INT_MIN", &preferences.integer.low}, {"INT_MAX", &preferences.integer.high},
        {"REAL_MIN", &preferences.real.low},   {"REAL_MAX", &preferences.real.high},
    };
    const auto bound = bounds.find(key);
    if (bound != bounds.end()) return read_number(value, *bound->second) ? "" : key + ": a whole number is expected";
    if (key == kind_key) return read_kind(value, preferences.kind) ? "" : key + ": dtmc or mdp is expected";
    // RoboTool writes more keys, which mean nothing here; a misspelt one would leave a range what it was.
    std::vector<std::string> keys{kind_key};
    for (const auto& [name, number] : bounds) keys.push_back(name);
    const std::string meant = diagnostics::nearest(key, keys);
    return diagnostics::is_certain(key, meant, keys) ? fmt::format("{}: did you mean {}?", key, meant) : "";
}

}  // namespace

std::string read_preferences(std::string_view text, Preferences& preferences) {
    for (std::size_t number = 1; !text.empty(); ++number) {
        const auto end = text.find('\n');
        const std::string error = read_line(trimmed(text.substr(0, end)), preferences);
        if (!error.empty()) return fmt::format("line {}: {}", number, error);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    for (const auto& [name, range] : {std::pair("NAT", preferences.nat), std::pair("INT", preferences.integer),
                                      std::pair("REAL", preferences.real)})
        if (range.low > range.high) return fmt::format("{0}_MIN is greater than {0}_MAX", name);
    return "";
}

}  // namespace robochart::prism_emit
