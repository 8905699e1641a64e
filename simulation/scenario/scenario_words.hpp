// The words of a scenario one after the other: private to this component. After the first syntax error nothing more is
// read.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "diagnostics/diagnostic.hpp"
#include "frontend/syntax/word_reader.hpp"
#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

/// What is said beside a syntax error about forms that people write: all rows, for the tests.
[[nodiscard]] std::span<const diagnostics::Advice> scenario_advice();

class Reader : public frontend::WordReader {
public:
    Reader(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&);

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

private:
    double number();
    /// The unit behind a number, "" if none is there.
    std::string unit_text();
};

}  // namespace robochart::simulation
