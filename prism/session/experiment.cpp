// SPDX-License-Identifier: Apache-2.0
// See experiment.hpp.
#include "prism/session/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/spelling.hpp"
#include "prism/checks/types.hpp"
#include "prism/explore/code.hpp"
#include "prism/syntax/reader.hpp"

namespace robochart::prism {
namespace {

constexpr std::size_t most_values = 100'000;

/// Splits at separators outside parentheses.
std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    int depth = 0;
    for (const char c : text) {
        if (c == '(') ++depth;
        if (c == ')') --depth;
        if (c == separator && depth == 0)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

Value value_of(const std::string& text, const Constant& constant) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const ExprPtr expr = read_expression(sources, sources.add("--const", text), diagnostics);
    const Scope scope;
    TypeChecker types(scope, diagnostics);
    if (expr) types.expect_type(expr, constant.type);
    if (!diagnostics.ok())
        throw BadValue(
            fmt::format("{}={}: {}", constant.name.text, text, diagnostics.sorted_findings().front().message()));
    try {
        Code code({}, {}, {});
        Value value = code.value(code.compile(expr), nullptr);
        if (constant.type == Type::real) value = {Type::real, 0, value.number()};
        if (!value.number().finite()) throw BadValue(fmt::format("{}={}: not a number", constant.name.text, text));
        return value;
    } catch (const EvaluationError& error) {
        error.report(diagnostics);
        throw BadValue(
            fmt::format("{}={}: {}", constant.name.text, text, diagnostics.sorted_findings().front().message()));
    }
}

std::vector<Value> range(const Value& low, const Real& step, const Value& high, const std::string& text) {
    if (low.type == Type::boolean) throw BadValue(text + ": a bool has no range");
    if (step.compare(Real(std::int64_t{0})) != 1) throw BadValue(text + ": the step must be above 0");
    std::vector<Value> values;
    for (Real at = low.number(); at.compare(high.number()).value_or(1) <= 0; at = at + step) {
        if (values.size() >= most_values) throw BadValue(fmt::format("{}: more than {} values", text, most_values));
        Value value{low.type, 0, at};
        if (low.type == Type::integer) value.integer = at.value().convert_to<std::int64_t>();
        values.push_back(std::move(value));
    }
    if (values.empty()) throw BadValue(text + ": the range is empty");
    return values;
}

Series read_one(const std::string& text, const std::vector<Constant>& open) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) throw BadValue(fmt::format("{}: expected NAME=VALUE", text));
    const std::string name = text.substr(0, equals);
    const auto constant =
        std::ranges::find_if(open, [&](const Constant& candidate) { return candidate.name.text == name; });
    if (constant == open.end()) {
        std::vector<std::string> known;
        for (const Constant& candidate : open) known.push_back(candidate.name.text);
        const std::string meant = diagnostics::nearest_spelling(name, known);
        throw BadValue(fmt::format("there is no open constant '{}'{}", name,
                                   meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant)));
    }
    const std::vector<std::string> sides = split(text.substr(equals + 1), ':');
    if (sides.size() > 3) throw BadValue(fmt::format("{}: expected LOW:HIGH or LOW:STEP:HIGH", text));
    const Value low = value_of(sides.front(), *constant);
    if (sides.size() == 1) return {name, {low}};
    const Value high = value_of(sides.back(), *constant);
    const Real step = sides.size() == 2 ? Real(std::int64_t{1}) : value_of(sides[1], *constant).number();
    return {name, range(low, step, high, text)};
}

}  // namespace

std::vector<Series> read_series(const std::string& text, const std::vector<Constant>& open) {
    std::vector<Series> result;
    for (const std::string& part : split(text, ',')) result.push_back(read_one(part, open));
    return result;
}

std::vector<Constant> open_constants(const std::vector<Constant>& constants) {
    std::vector<Constant> result;
    std::ranges::copy_if(constants, std::back_inserter(result),
                         [](const Constant& constant) { return constant.value == nullptr; });
    return result;
}

std::vector<Values> combinations(const std::vector<Series>& series) {
    std::vector<Values> result{{}};
    for (const Series& constant : series) {
        if (result.size() * constant.values.size() > most_values)
            throw BadValue(fmt::format("more than {} combinations of values", most_values));
        std::vector<Values> longer;
        for (const Values& before : result)
            for (const Value& value : constant.values) {
                longer.push_back(before);
                longer.back()[constant.name] = value;
            }
        result = std::move(longer);
    }
    return result;
}

}  // namespace robochart::prism
