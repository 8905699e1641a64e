#include "simulation/scenario/scenario_words.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "simulation/scenario/rules.hpp"

namespace robochart::simulation {

using frontend::Token;
using frontend::TokenKind;

namespace {

constexpr double largest = 1e9;

}  // namespace

Reader::Reader(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
               diagnostics::Diagnostics& diagnostics)
    : frontend::WordReader(sources, source, rules::syntax, diagnostics) {}

double Reader::number() {
    const bool negative = take("-");
    const Token next = token();
    if (next.kind != TokenKind::integer && next.kind != TokenKind::real) fail("a number");
    if (failed()) return 0;
    double value = 0;
    std::from_chars(next.text.data(), next.text.data() + next.text.size(), value);
    advance();
    if (std::abs(value) > largest) {
        report(rules::out_of_range, last_span(), {fmt::format("{} is beyond {}", next.text, largest)});
        return 0;
    }
    return negative ? -value : value;
}

/// A word is a unit only directly behind its number, so that `5 s` is one and `trials 10 seed 1` is not.
std::string Reader::unit_text() {
    if (take("%")) return "%";
    const Token next = token();
    if (next.kind != TokenKind::identifier || !unit_named(next.text)) return "";
    std::string text(next.text);
    advance();
    const Token slash = token();
    const Token below = token_behind();
    if (slash.is("/") && unit_named(text + "/" + std::string(below.text))) {
        advance();
        advance();
        text += "/" + std::string(below.text);
    }
    return text;
}

Quantity Reader::quantity(Dimension dimension, std::string_view what) {
    const diagnostics::Span begin = token().span;
    const double value = number();
    const std::string unit = failed() ? "" : unit_text();
    const Unit meant = unit_named(unit).value_or(Unit{});
    const diagnostics::Span span = diagnostics::join(begin, last_span());
    if (meant.dimension != dimension)
        report(rules::wrong_unit, span, {std::string(what), std::string(described(dimension))});
    return {value * meant.factor, meant.dimension, span};
}

double Reader::positive(Dimension dimension, std::string_view what) {
    const Quantity q = quantity(dimension, what);
    if (q.value <= 0) report(rules::out_of_range, q.span, {fmt::format("{} must be greater than 0", what)});
    return q.value;
}

double Reader::not_negative(Dimension dimension, std::string_view what) {
    const Quantity q = quantity(dimension, what);
    if (q.value < 0) report(rules::out_of_range, q.span, {fmt::format("{} must not be negative", what)});
    const bool beyond = dimension == Dimension::share && q.dimension == dimension && q.value > 1;
    if (beyond) report(rules::out_of_range, q.span, {fmt::format("{} is more than 100 %", what)});
    return q.value;
}

std::uint64_t Reader::count(std::uint64_t low, std::uint64_t high, std::string_view what) {
    const Quantity q = quantity(Dimension::number, what);
    if (q.dimension != Dimension::number) return low;
    const bool whole = q.value == std::floor(q.value);
    if (!whole || q.value < static_cast<double>(low) || q.value > static_cast<double>(high)) {
        report(rules::out_of_range, q.span, {fmt::format("{} is a whole number from {} to {}", what, low, high)});
        return low;
    }
    return static_cast<std::uint64_t>(q.value);
}

double Reader::unit(Dimension dimension, std::string_view what) {
    const diagnostics::Span begin = token().span;
    const std::string text = failed() ? "" : unit_text();
    if (text.empty()) {
        fail("a unit");
        return 1;
    }
    const Unit meant = *unit_named(text);
    if (meant.dimension != dimension)
        report(rules::wrong_unit, diagnostics::join(begin, last_span()),
               {std::string(what), std::string(described(dimension))});
    return meant.factor;
}

Vector Reader::point(std::string_view what) {
    expect("(");
    const double x = quantity(Dimension::length, what).value;
    expect(",");
    const double y = quantity(Dimension::length, what).value;
    expect(")");
    return {x, y};
}

}  // namespace robochart::simulation
