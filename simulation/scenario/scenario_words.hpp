// SPDX-License-Identifier: Apache-2.0
// Reads the tokens of a scenario one after another (private to this component). Reading stops at the first syntax
// error.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/syntax/word_reader.hpp"
#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

/// Returns the table of advice for syntax errors that are common. Tests read it.
[[nodiscard]] std::span<const diagnostics::Advice> scenario_advice();

class Reader : public frontend::WordReader {
public:
    Reader(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&);

    /// Reads a quantity of one dimension. Messages call the item `what`.
    Quantity read_quantity(Dimension, std::string_view what);
    /// Read a quantity that must be positive, or at least zero.
    double read_positive(Dimension, std::string_view what);
    double not_negative(Dimension, std::string_view what);
    /// Reads a whole number in a range.
    std::uint64_t read_count(std::uint64_t low, std::uint64_t high, std::string_view what);
    /// Reads a unit of this dimension without a number, and returns its factor.
    double read_unit(Dimension, std::string_view what);
    /// Reads a point `(x, y)`; both are lengths.
    Vector read_point(std::string_view what);

private:
    double read_number();
    /// Reads the unit after a number; returns "" if there is none.
    std::string unit_text();
};

}  // namespace robochart::simulation
