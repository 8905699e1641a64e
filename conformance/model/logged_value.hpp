// SPDX-License-Identifier: Apache-2.0
// Values in logs (docs/traces.md): the notation of the CSP alphabet, with decimal numbers, the names of literals and no
// blanks. The reader distinguishes values inside and outside the finite instantiation.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "conformance/model/data_independence.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// A logged value, part by part.
struct LoggedPart {
    std::int64_t number = 0;  ///< as in ir::Value
    std::string outside;      ///< for a number outside its carrier: a canonical text
    double value = 0;         ///< for a number outside its carrier
    ir::TypeKind kind = ir::TypeKind::unit;
    std::vector<LoggedPart> parts;
};

/// A value in a log.
struct LoggedValue {
    std::optional<std::int64_t> number;  ///< as in the carrier; for a value with parts, its index in the carrier; no
                                         ///< value if the value is outside
    std::string text;                    ///< for a value outside the carrier: the text for reports
    /// For a value outside the carrier: the component only passes on such numbers or compares them with constants, and
    /// the carrier has numbers for which these comparisons have the same answers.
    bool replaceable = false;
    LoggedPart whole;
};

/// Thrown if a text is not a value of its type. Contains the expected form and the part of the text that does not
/// match.
struct ValueFault {
    std::string expected;
    std::size_t begin = 0;
    std::size_t length = 0;
};

/// When a logged number counts as a number of the carrier.
enum class NumberReading {
    exact,    ///< if it is equal; for numbers that the component compares with constants
    rounded,  ///< if the difference is a rounding error of double, or the logged number is the float nearest to it
};

/// The numbers of the model with which the component compares numbers of a kind, ascending.
struct ComparedConstants {
    std::vector<double> ordered;  ///< by <, <=, > or >=
    std::vector<double> all;
};

/// A summand of ComparedSums.
struct TestedSummand {
    std::optional<double> constant;  ///< no value for a number that a variable holds
    bool subtracted = false;
};
/// A comparison of sums of numbers that the component makes (SumComparison).
struct ComparedSums {
    ir::TypeKind kind = ir::TypeKind::unit;
    ir::ExprKind relation = ir::ExprKind::equal;
    std::vector<TestedSummand> left, right;
};

/// The numbers of the carriers that logged numbers have, by kind and logged number.
using NumberCodes = std::map<std::pair<ir::TypeKind, double>, std::int64_t>;

/// What the component does with numbers.
struct TestedNumbers {
    DataIndependence uses;
    std::map<ir::TypeKind, ComparedConstants> constants;
    std::vector<double> literals;  ///< the literals and constants of the component, ascending
    std::vector<ComparedSums> sums;
    NumberCodes codes;  ///< of a log whose numbers are in the carriers (conformance/traces/logged_numbers.hpp)
};

/// Reads the values of one type of a model.
class ValueReader {
public:
    ValueReader(const ir::System&, const ir::Instantiation&, ir::TypeId, const TestedNumbers&, NumberReading);

    /// Reads a value. Throws ValueFault.
    [[nodiscard]] LoggedValue read_value(std::string_view text) const;
    /// The index of the carrier's value that represents a value outside the carrier. Numbers outside their carriers are
    /// replaced by numbers of their kind, which `salt` selects: any number if the component only passes them on;
    /// otherwise a number for which the comparisons with constants give the same answers. Equal numbers get equal
    /// replacements. The component's own literals are not used as replacements if there are others.
    [[nodiscard]] std::int64_t replacement_index(const LoggedValue&, std::uint64_t salt) const;

private:
    /// The answers of all comparisons of a number with constants: how many ordered constants are less than it, and
    /// which constant it is (-1: none).
    using Answers = std::pair<std::size_t, std::ptrdiff_t>;
    [[nodiscard]] Answers answers_for(ir::TypeKind, double) const;
    /// The index of the value in the carrier. Numbers outside their carriers are replaced.
    [[nodiscard]] std::optional<std::int64_t> carrier_index(const LoggedPart&, std::uint64_t salt) const;

    [[nodiscard]] std::optional<std::int64_t> replacement_number(const LoggedPart&, std::uint64_t salt) const;
    [[nodiscard]] std::optional<ir::Value> replacement_value(const LoggedPart&, std::uint64_t salt) const;
    [[nodiscard]] bool is_replaceable(const LoggedPart&) const;
    /// The numbers of the carrier that can replace the number.
    [[nodiscard]] const std::vector<std::int64_t>& candidates(const LoggedPart&) const;

    const ir::System* system_;
    const ir::Instantiation* instantiation_;
    ir::TypeId type_;
    TestedNumbers numbers_;
    NumberReading reading_;
    bool composed_;
    std::map<ir::Value, std::int64_t> places_;  ///< for values with parts
    /// The replacements by kind and answers of the comparisons, made when they are needed.
    mutable std::map<std::pair<ir::TypeKind, Answers>, std::vector<std::int64_t>> candidates_;
};

/// The text of a model's value in a log: "0.5", "Red", "(1,<2,3>)".
[[nodiscard]] std::string log_text(const ir::System&, const ir::Instantiation&, ir::TypeId, const ir::Value&);

}  // namespace robochart::conformance
