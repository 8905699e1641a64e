#include "simulation/scenario/scenario_words.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "diagnostics/one_line.hpp"
#include "simulation/scenario/rules.hpp"

namespace robochart::simulation {

using frontend::Token;
using frontend::TokenKind;

namespace {

constexpr double largest = 1e9;

std::string shown(const Token& token) {
    return token.kind == TokenKind::end ? "the end of the file" : fmt::format("'{}'", frontend::shorten(token.text));
}

}  // namespace

Reader::Reader(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
               diagnostics::Diagnostics& diagnostics)
    : sources_(sources), diagnostics_(diagnostics) {
    const std::size_t before = diagnostics.errors();
    stream_ = frontend::tokenize(sources, source, false, diagnostics);
    failed_ = diagnostics.errors() > before || stream_.tokens.empty();
    last_ = {source, 0, 0};
}

bool Reader::at(std::string_view word) const {
    const Token next = token();
    return next.kind != TokenKind::end && next.kind != TokenKind::string && next.text == word;
}

bool Reader::at_number() const {
    const TokenKind kind = token().kind;
    return kind == TokenKind::integer || kind == TokenKind::real || at("-");
}

std::string Reader::text_since(diagnostics::Span from) const {
    return diagnostics::on_one_line(sources_.text(from.source).substr(from.begin, last_.end - from.begin));
}

void Reader::advance() {
    last_ = token().span;
    if (!at_end()) ++next_;
}

bool Reader::take(std::string_view word) {
    if (failed_ || !at(word)) return false;
    advance();
    return true;
}

void Reader::expect(std::string_view word) {
    if (!failed_ && !take(word)) fail(fmt::format("'{}'", word));
}

void Reader::fail(std::string_view expected) {
    if (failed_) return;
    failed_ = true;
    diagnostics_.report(rules::syntax, token().span, {std::string(expected), shown(token())});
}

void Reader::report(const diagnostics::Rule& rule, diagnostics::Span span, std::vector<std::string> arguments) {
    if (!failed_) diagnostics_.report(rule, span, std::move(arguments));
}

Name Reader::name(std::string_view what) {
    const Token next = token();
    if (next.kind != TokenKind::identifier && next.kind != TokenKind::keyword) fail(what);
    if (failed_) return {};
    advance();
    return {std::string(next.text), next.span};
}

Name Reader::qualified_name(std::string_view what) {
    Name result = name(what);
    while (take("::")) {
        const Name part = name(what);
        result.text += "::" + part.text;
        result.span = diagnostics::join(result.span, part.span);
    }
    return result;
}

std::string Reader::quoted(std::string_view what) {
    const Token next = token();
    if (next.kind != TokenKind::string) fail(what);
    if (failed_) return "";
    advance();
    return std::string(next.text.substr(1, next.text.size() - 2));
}

double Reader::number() {
    const bool negative = take("-");
    const Token next = token();
    if (next.kind != TokenKind::integer && next.kind != TokenKind::real) fail("a number");
    if (failed_) return 0;
    double value = 0;
    std::from_chars(next.text.data(), next.text.data() + next.text.size(), value);
    advance();
    if (std::abs(value) > largest) {
        report(rules::out_of_range, last_, {fmt::format("{} is beyond {}", next.text, largest)});
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
    const Token below = stream_.tokens.at(next_ + 1);
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
    const std::string unit = failed_ ? "" : unit_text();
    const Unit meant = unit_named(unit).value_or(Unit{});
    const diagnostics::Span span = diagnostics::join(begin, last_);
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
    const std::string text = failed_ ? "" : unit_text();
    if (text.empty()) {
        fail("a unit");
        return 1;
    }
    const Unit meant = *unit_named(text);
    if (meant.dimension != dimension)
        report(rules::wrong_unit, diagnostics::join(begin, last_),
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
