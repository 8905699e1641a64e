// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/scenario_words.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "simulation/scenario/rules.hpp"

namespace robochart::simulation {

using frontend::Token;
using frontend::TokenKind;

namespace {

constexpr double largest = 1e9;

using diagnostics::Advice;

constexpr std::string_view scenario_form = "a scenario has the form `scenario NAME for PACKAGE::MODULE { ... }`";
constexpr std::string_view value_form = "a value directly follows its keyword: `trials 10`";
constexpr std::string_view drive_form = "`drive motors by stop on halt` defines the effect of an operation";
constexpr std::string_view feed_form = "`feed EVENT with SENSOR.READING` feeds an event";
constexpr std::string_view stimulus_form = "`stimulus EVENT at 3 s` or `every 3 s` raises an event from outside";
constexpr std::string_view accept_form =
    "a criterion is `each M at 10 s <= 5 cm` (in each trial), `mean M ...` (over the trials), or `probability P >= 95 "
    "% with confidence 99 %`";
constexpr std::string_view accept_item = "a criterion is written after `accept`: `accept each M at 10 s <= 5 cm`";
constexpr std::string_view place_form =
    "`place at (0 cm, 0 cm) heading 0 deg` or `place random in (X, Y) to (X, Y)` sets the initial places of robots";
constexpr std::string_view any_item = "an item of a scenario or '}'";
constexpr std::string_view robot_item = "'radius', 'axle', 'wheel', 'noise', 'place', 'const' or '}'";

constexpr std::array advice{
    Advice{"'for'", "scenario NAME @", scenario_form},
    Advice{"'{'", "NAME @ .", "the name of a module in a package is `PACKAGE::MODULE`"},
    Advice{"'{'", ":: NAME @", scenario_form},
    Advice{"a number", "robots @", "the number of robots comes first: `robots 10 { ... }`"},
    Advice{"a number", "record @", "`record 0.2 s` sets the interval of the recorded positions"},
    Advice{"a number", "@ =", value_form},
    Advice{"a number", "@ :", value_form},
    Advice{"'by'", "drive NAME @", drive_form},
    Advice{"'by'", "@", "an arena is `arena 300 cm by 200 cm`"},
    Advice{"'with'", "feed NAME @", feed_form},
    Advice{"'at'", "stimulus NAME @", stimulus_form},
    Advice{"'('", "wall @", "a wall is `wall (0 cm, 0 cm) to (50 cm, 0 cm)`"},
    Advice{"'('", "obstacle @", "an obstacle has corners: `obstacle (0 cm, 0 cm), (20 cm, 0 cm), (0 cm, 20 cm)`"},
    Advice{"'in'", "place random @", place_form},
    Advice{"'each', 'mean' or 'probability'", "@", accept_form},
    Advice{robot_item, "@ position", place_form},
    Advice{robot_item, "@ pose", place_form},
    Advice{robot_item, "@ start", place_form},
    Advice{any_item, "@ ;", "items need no separator"},
    Advice{any_item, "@ ,", "items need no separator"},
    Advice{any_item, "@ #", "a comment begins with `//`"},
    Advice{any_item, "@ event", stimulus_form},
    Advice{any_item, "@ expect", accept_item},
    Advice{any_item, "@ assert", accept_item},
    Advice{any_item, "@ check", accept_item},
    Advice{any_item, "@ goal", "a place to go to is a light: `light NAME at (X, Y)`"},
    Advice{any_item, "@ target", "a place to go to is a light: `light NAME at (X, Y)`"},
    Advice{any_item, "@ time", "`duration 10 s` sets the length of a trial"},
    Advice{any_item, "@ length", "`duration 10 s` sets the length of a trial"},
};

}  // namespace

Reader::Reader(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
               diagnostics::Diagnostics& diagnostics)
    : frontend::WordReader(sources, source, rules::syntax, diagnostics, advice) {}

std::span<const diagnostics::Advice> scenario_advice() {
    return advice;
}

double Reader::read_number() {
    const bool negative = take_word("-");
    const Token next = current_token();
    if (next.kind != TokenKind::integer && next.kind != TokenKind::real) fail_expecting("a number");
    if (has_failed()) return 0;
    double value = 0;
    std::from_chars(next.text.data(), next.text.data() + next.text.size(), value);
    advance_token();
    if (std::abs(value) > largest) {
        report(rules::out_of_range, last_span(), {fmt::format("{} is beyond {}", next.text, largest)});
        return 0;
    }
    return negative ? -value : value;
}

/// Reads the unit directly after a number; "" if there is none. A word that is not a unit is not read: `5 s` has a
/// unit, `trials 10 seed 1` has none.
std::string Reader::unit_text() {
    if (take_word("%")) return "%";
    const Token next = current_token();
    if (next.kind != TokenKind::identifier || !unit_named(next.text)) return "";
    std::string text(next.text);
    advance_token();
    const Token slash = current_token();
    const Token below = token_behind();
    if (slash.is_word("/") && unit_named(text + "/" + std::string(below.text))) {
        advance_token();
        advance_token();
        text += "/" + std::string(below.text);
    }
    return text;
}

Quantity Reader::read_quantity(Dimension dimension, std::string_view what) {
    const diagnostics::Span begin = current_token().span;
    const double value = read_number();
    const std::string unit = has_failed() ? "" : unit_text();
    const Unit meant = unit_named(unit).value_or(Unit{});
    const diagnostics::Span span = diagnostics::join_spans(begin, last_span());
    if (meant.dimension != dimension)
        report(rules::wrong_unit, span, {std::string(what), std::string(describe_dimension(dimension))});
    return {value * meant.factor, meant.dimension, span};
}

double Reader::read_positive(Dimension dimension, std::string_view what) {
    const Quantity q = read_quantity(dimension, what);
    if (q.value <= 0) report(rules::out_of_range, q.span, {fmt::format("{} must be greater than 0", what)});
    return q.value;
}

double Reader::not_negative(Dimension dimension, std::string_view what) {
    const Quantity q = read_quantity(dimension, what);
    if (q.value < 0) report(rules::out_of_range, q.span, {fmt::format("{} must not be negative", what)});
    const bool beyond = dimension == Dimension::share && q.dimension == dimension && q.value > 1;
    if (beyond) report(rules::out_of_range, q.span, {fmt::format("{} is more than 100 %", what)});
    return q.value;
}

std::uint64_t Reader::read_count(std::uint64_t low, std::uint64_t high, std::string_view what) {
    const Quantity q = read_quantity(Dimension::number, what);
    if (q.dimension != Dimension::number) return low;
    const bool whole = q.value == std::floor(q.value);
    if (!whole || q.value < static_cast<double>(low) || q.value > static_cast<double>(high)) {
        report(rules::out_of_range, q.span, {fmt::format("{} is a whole number from {} to {}", what, low, high)});
        return low;
    }
    return static_cast<std::uint64_t>(q.value);
}

double Reader::read_unit(Dimension dimension, std::string_view what) {
    const diagnostics::Span begin = current_token().span;
    const std::string text = has_failed() ? "" : unit_text();
    if (text.empty()) {
        fail_expecting("a unit");
        return 1;
    }
    const Unit meant = *unit_named(text);
    if (meant.dimension != dimension)
        report(rules::wrong_unit, diagnostics::join_spans(begin, last_span()),
               {std::string(what), std::string(describe_dimension(dimension))});
    return meant.factor;
}

Vector Reader::read_point(std::string_view what) {
    expect_word("(");
    const double x = read_quantity(Dimension::length, what).value;
    expect_word(",");
    const double y = read_quantity(Dimension::length, what).value;
    expect_word(")");
    return {x, y};
}

}  // namespace robochart::simulation
