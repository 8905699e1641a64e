// SPDX-License-Identifier: Apache-2.0
#include "driver/settings/instantiation_options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <string_view>
#include <system_error>

#include "base/diagnostics/escape.hpp"

namespace robochart::driver {
namespace {

bool parse_number(std::string_view text, std::int64_t& value) {
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    return code == std::errc() && end == text.data() + text.size();
}

}  // namespace

ir::GivenConstants given_constants(const std::vector<std::string>& texts, std::string& error) {
    ir::GivenConstants result;
    for (const std::string& text : texts) {
        const auto equals = text.find('=');
        if (equals == std::string::npos || equals == 0)
            error = fmt::format("--const {}: expected NAME=VALUE", diagnostics::escape_for_display(text));
        else if (!result.emplace(text.substr(0, equals), text.substr(equals + 1)).second)
            error = fmt::format("--const {} is given twice", diagnostics::escape_for_display(text.substr(0, equals)));
    }
    return result;
}

ir::InstantiationOptions instantiation_options(const InstantiationSettings& settings, std::string& error) {
    ir::InstantiationOptions result;
    result.constants = given_constants(settings.constants, error);
    for (const std::string& text : settings.ranges) {
        const auto equals = text.find('=');
        const auto dots = text.find("..");
        std::int64_t low = 0;
        std::int64_t high = 0;
        const std::string_view view(text);
        const bool good = equals != std::string::npos && dots != std::string::npos && dots > equals &&
                          parse_number(view.substr(equals + 1, dots - equals - 1), low) &&
                          parse_number(view.substr(dots + 2), high);
        if (!good)
            error = fmt::format("--range {}: expected TYPE=LOW..HIGH", diagnostics::escape_for_display(text));
        else if (low > high)
            error = fmt::format("--range {}: the range is empty", diagnostics::escape_for_display(text));
        else
            result.ranges[text.substr(0, equals)] = {low, high};
    }
    return result;
}

std::string range_text(const std::vector<std::int64_t>& carrier) {
    if (carrier.empty()) return "empty";
    const auto size = static_cast<std::uint64_t>(carrier.back()) - static_cast<std::uint64_t>(carrier.front()) + 1;
    const std::string range = fmt::format("{}..{}", carrier.front(), carrier.back());
    return size == carrier.size() ? range : fmt::format("{} values in {}", carrier.size(), range);
}

}  // namespace robochart::driver
