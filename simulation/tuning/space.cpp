// SPDX-License-Identifier: Apache-2.0
// See space.hpp.
#include "simulation/tuning/space.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace robochart::simulation {

namespace {

constexpr std::uint64_t most_values = 1'000'000;
constexpr std::size_t most_digits = 12;
constexpr int most_decimals = 6;
constexpr std::size_t most_listed = 1000;

constexpr std::int64_t power_of_ten(int exponent) {
    std::int64_t result = 1;
    for (; exponent > 0; --exponent) result *= 10;
    return result;
}

/// A decimal number with its decimals as written: 12.50 is 1250 with two decimals.
struct Decimal {
    std::int64_t digits = 0;
    int decimals = 0;
};

std::optional<Decimal> read_decimal(std::string_view text) {
    const bool negative = text.starts_with('-');
    if (negative) text.remove_prefix(1);
    std::string digits;
    int decimals = -1;
    for (const char c : text) {
        if (c == '.' && decimals < 0 && !digits.empty()) {
            decimals = 0;
            continue;
        }
        if (c < '0' || c > '9') return std::nullopt;
        digits += c;
        if (decimals >= 0) ++decimals;
    }
    if (digits.empty() || digits.size() > most_digits || decimals == 0 || decimals > most_decimals) return std::nullopt;
    Decimal found{0, std::max(decimals, 0)};
    std::from_chars(digits.data(), digits.data() + digits.size(), found.digits);
    if (negative) found.digits = -found.digits;
    return found;
}

std::int64_t in_steps(const Decimal& number, int decimals) {
    return number.digits * power_of_ten(decimals - number.decimals);
}

std::optional<Parameter> read_range(Parameter parameter, std::string_view low_text, std::string_view high_text,
                                    ParameterKind kind, std::string& error) {
    const auto low = read_decimal(low_text);
    const auto high = read_decimal(high_text);
    error.clear();
    if (!low || !high)
        error = "a range is LOW..HIGH, two numbers of at most 12 digits, 6 of them decimals";
    else if (kind == ParameterKind::other)
        error = "a range is of numbers; values of this constant are listed: A,B,C";
    else if (kind == ParameterKind::whole && low->decimals + high->decimals > 0)
        error = "the constant takes whole numbers";
    if (!error.empty()) return std::nullopt;
    int decimals = std::max(low->decimals, high->decimals);
    // The range gets at least a hundred steps, if the number of digits allows it.
    while (kind == ParameterKind::real && decimals < most_decimals &&
           in_steps(*high, decimals) - in_steps(*low, decimals) < 100)
        ++decimals;
    parameter.decimals = decimals;
    parameter.low = in_steps(*low, decimals);
    const std::int64_t width = in_steps(*high, decimals) - parameter.low;
    if (width <= 0)
        error = "the lower bound of a range is below the upper one";
    else if (static_cast<std::uint64_t>(width) >= most_values)
        error = fmt::format("a range has at most {} values", most_values);
    parameter.count = static_cast<std::uint64_t>(width) + 1;
    return error.empty() ? std::optional(std::move(parameter)) : std::nullopt;
}

/// Draws from a truncated distribution by rejection. At least half of the distribution is accepted.
std::uint64_t drawn_around(const Parameter& parameter, std::uint64_t middle, double deviation, Random& random) {
    const auto most = static_cast<double>(parameter.count) - 0.5;
    for (int tries = 0; tries < 1000; ++tries) {
        const double value = static_cast<double>(middle) + deviation * random.normal();
        if (value >= -0.5 && value < most)
            return std::min<std::uint64_t>(static_cast<std::uint64_t>(std::max(0.0, std::round(value))),
                                           parameter.count - 1);
    }
    return middle;
}

std::uint64_t drawn_of(const std::vector<double>& probabilities, Random& random) {
    double left = random.uniform();
    for (std::uint64_t v = 0; v + 1 < probabilities.size(); ++v) {
        left -= probabilities[v];
        if (left < 0) return v;
    }
    return probabilities.size() - 1;
}

double start_deviation(const Parameter& parameter) {
    return static_cast<double>(parameter.count - 1) / 2;
}

}  // namespace

std::string Parameter::value_text(std::uint64_t number) const {
    if (!is_ordered()) return listed.at(number);
    const std::int64_t steps = low + static_cast<std::int64_t>(number);
    if (decimals == 0) return fmt::format("{}", steps);
    const std::int64_t unit = power_of_ten(decimals);
    const std::int64_t size = steps < 0 ? -steps : steps;
    std::string digits = fmt::format("{}{}.{:0{}}", steps < 0 ? "-" : "", size / unit, size % unit, decimals);
    // Trailing zeros are omitted: 0.2 instead of 0.200.
    while (digits.ends_with('0') && digits[digits.size() - 2] != '.') digits.pop_back();
    return digits;
}

bool is_varied(std::string_view value) {
    return value.find("..") != std::string_view::npos || value.find(',') != std::string_view::npos;
}

std::optional<Parameter> read_parameter(const std::string& name, const std::string& text, ParameterKind kind,
                                        std::string& error) {
    Parameter parameter;
    parameter.name = name;
    parameter.text = text;
    error.clear();
    const std::size_t dots = text.find("..");
    if (dots != std::string::npos && text.find(',') == std::string::npos)
        return read_range(std::move(parameter), std::string_view(text).substr(0, dots),
                          std::string_view(text).substr(dots + 2), kind, error);
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        parameter.listed.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    std::vector<std::string> sorted = parameter.listed;
    std::ranges::sort(sorted);
    if (std::ranges::any_of(sorted, [](const std::string& value) { return value.empty(); }))
        error = "a value of the list is empty";
    else if (std::ranges::adjacent_find(sorted) != sorted.end())
        error = "a value is listed twice";
    else if (sorted.size() > most_listed)
        error = fmt::format("a list has at most {} values", most_listed);
    return error.empty() ? std::optional(std::move(parameter)) : std::nullopt;
}

std::vector<std::string> constants_of(const std::vector<Parameter>& parameters, const Candidate& candidate) {
    std::vector<std::string> result;
    for (std::size_t p = 0; p < parameters.size(); ++p)
        result.push_back(fmt::format("{}={}", parameters[p].name, parameters[p].value_text(candidate.at(p))));
    return result;
}

std::string candidate_text(const std::vector<Parameter>& parameters, const Candidate& candidate) {
    return fmt::format("{}", fmt::join(constants_of(parameters, candidate), " "));
}

Neighbourhood whole_space(const std::vector<Parameter>& parameters) {
    Neighbourhood result;
    for (const Parameter& parameter : parameters) {
        result.deviations.push_back(parameter.is_ordered() ? start_deviation(parameter) : 0);
        result.probabilities.emplace_back(parameter.listed.size(), 1 / static_cast<double>(parameter.listed.size()));
    }
    return result;
}

void narrow_neighbourhood(Neighbourhood& near, const std::vector<Parameter>& parameters, const Candidate& candidate,
                          std::uint64_t fresh, double progress) {
    const double factor = std::pow(1 / static_cast<double>(std::max<std::uint64_t>(1, fresh)),
                                   1 / static_cast<double>(parameters.size()));
    for (std::size_t p = 0; p < parameters.size(); ++p) {
        near.deviations[p] *= factor;
        for (std::size_t v = 0; v < near.probabilities[p].size(); ++v)
            near.probabilities[p][v] = near.probabilities[p][v] * (1 - progress) + (v == candidate[p] ? progress : 0);
    }
}

void widen_neighbourhood(Neighbourhood& near, const std::vector<Parameter>& parameters) {
    for (std::size_t p = 0; p < parameters.size(); ++p) {
        if (parameters[p].is_ordered())
            near.deviations[p] = std::min(start_deviation(parameters[p]), std::max(0.5, 2 * near.deviations[p]));
        for (double& probability : near.probabilities[p])
            probability = (probability + 1 / static_cast<double>(near.probabilities[p].size())) / 2;
    }
}

Candidate draw_candidate(const std::vector<Parameter>& parameters, Random& random) {
    Candidate result;
    for (const Parameter& parameter : parameters) {
        const double size = static_cast<double>(parameter.size());
        result.push_back(std::min(static_cast<std::uint64_t>(random.uniform() * size), parameter.size() - 1));
    }
    return result;
}

Candidate drawn_near(const std::vector<Parameter>& parameters, const Candidate& middle, const Neighbourhood& near,
                     Random& random) {
    Candidate result;
    for (std::size_t p = 0; p < parameters.size(); ++p)
        result.push_back(parameters[p].is_ordered() ? drawn_around(parameters[p], middle[p], near.deviations[p], random)
                                                    : drawn_of(near.probabilities[p], random));
    return result;
}

}  // namespace robochart::simulation
