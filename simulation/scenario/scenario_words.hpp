// SPDX-License-Identifier: Apache-2.0
// The tokens of a scenario one after another (private to this component). Reading stops at the first syntax error.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/syntax/word_reader.hpp"
#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

/// The advice for syntax errors about common wrong forms: all rows, for tests.
[[nodiscard]] std::span<const diagnostics::Advice> scenario_advice();

class Reader : public frontend::WordReader {
public:
    Reader(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&);

    /// A quantity of one dimension; `what` names the item in messages.
    Quantity read_quantity(Dimension, std::string_view what);
    /// A quantity that must be positive, or at least zero.
    double read_positive(Dimension, std::string_view what);
    double not_negative(Dimension, std::string_view what);
    /// A whole number in a range.
    std::uint64_t read_count(std::uint64_t low, std::uint64_t high, std::string_view what);
    /// A unit without a number, of this dimension; returns its factor.
    double read_unit(Dimension, std::string_view what);
    /// `(x, y)`, lengths.
    Vector read_point(std::string_view what);

private:
    double read_number();
    /// The unit after a number; "" if there is none.
    std::string unit_text();
};

}  // namespace robochart::simulation
