// SPDX-License-Identifier: Apache-2.0
// Reads and writes number literals.
#include "semantics/ir/numbers.hpp"

#include <fmt/format.h>

#include <charconv>

namespace robochart::ir {
namespace {
constexpr std::size_t most_decimals = 18;  // 10^18 is the greatest power of ten that fits into 64 bits
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<Decimal> parse_decimal(std::string_view text) {
    const std::size_t dot = text.find('.');
    std::string digits(text.substr(0, dot));
    std::string fraction(dot == std::string_view::npos ? std::string_view{} : text.substr(dot + 1));
    if (fraction.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
    while (!fraction.empty() && fraction.back() == '0') fraction.pop_back();
    if (fraction.size() > most_decimals) return std::nullopt;
    if (!parse_integer(digits)) return std::nullopt;
    digits += fraction;
    const auto unscaled = parse_integer(digits);
    if (!unscaled) return std::nullopt;
    return Decimal{*unscaled, static_cast<std::uint32_t>(fraction.size())};
}

std::string to_string(const Decimal& decimal) {
    std::string digits = std::to_string(decimal.unscaled);
    if (decimal.decimals == 0) return digits;
    const std::string sign = decimal.unscaled < 0 ? "-" : "";
    digits.erase(0, sign.size());
    if (digits.size() <= decimal.decimals) digits.insert(0, decimal.decimals + 1 - digits.size(), '0');
    digits.insert(digits.size() - decimal.decimals, ".");
    return sign + digits;
}

std::string decimal_text(std::int64_t number, std::int64_t scale) {
    if (number % scale == 0) return fmt::format("{}", number / scale);
    const std::uint64_t magnitude =
        number < 0 ? 0U - static_cast<std::uint64_t>(number) : static_cast<std::uint64_t>(number);
    const auto unit = static_cast<std::uint64_t>(scale);
    std::string digits = fmt::format("{:0{}}", magnitude % unit, fmt::formatted_size("{}", unit) - 1);
    while (digits.back() == '0') digits.pop_back();
    return fmt::format("{}{}.{}", number < 0 ? "-" : "", magnitude / unit, digits);
}

}  // namespace robochart::ir
