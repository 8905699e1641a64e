// The words of a scenario one after the other: private to this component. After the first syntax error nothing more is
// read.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "diagnostics/diagnostic.hpp"
#include "frontend/syntax/lexer.hpp"
#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

class Reader {
public:
    Reader(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&);

    [[nodiscard]] bool failed() const { return failed_; }
    [[nodiscard]] bool at(std::string_view word) const;
    [[nodiscard]] bool at_end() const { return token().kind == frontend::TokenKind::end; }
    [[nodiscard]] bool at_number() const;
    [[nodiscard]] frontend::Token token() const { return stream_.tokens.at(next_); }
    [[nodiscard]] diagnostics::Span last_span() const { return last_; }
    /// The text from a place to the last word read, on one line.
    [[nodiscard]] std::string text_since(diagnostics::Span from) const;

    /// Takes the word if it is the next one.
    bool take(std::string_view word);
    void expect(std::string_view word);
    /// Any name; `what` for the message.
    Name name(std::string_view what);
    /// `a::b::c`.
    Name qualified_name(std::string_view what);
    /// A string without its quotes.
    std::string quoted(std::string_view what);
    /// A quantity of one dimension; `what` is what takes it.
    Quantity quantity(Dimension, std::string_view what);
    /// Of one that must be positive, or at least zero.
    double positive(Dimension, std::string_view what);
    double not_negative(Dimension, std::string_view what);
    /// A whole number in a range.
    std::uint64_t count(std::uint64_t low, std::uint64_t high, std::string_view what);
    /// A unit alone, of the dimension; its factor.
    double unit(Dimension, std::string_view what);
    /// `(x, y)`, lengths.
    Vector point(std::string_view what);

    void fail(std::string_view expected);
    void report(const diagnostics::Rule&, diagnostics::Span, std::vector<std::string> arguments);

private:
    void advance();
    double number();
    /// The unit behind a number, "" if none is there.
    std::string unit_text();

    const diagnostics::SourceManager& sources_;
    diagnostics::Diagnostics& diagnostics_;
    frontend::TokenStream stream_;
    std::size_t next_ = 0;
    diagnostics::Span last_;
    bool failed_ = false;
};

}  // namespace robochart::simulation
