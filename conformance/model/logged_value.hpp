// SPDX-License-Identifier: Apache-2.0
// Reads and writes values in logs (docs/traces.md). The notation is the notation of the CSP alphabet, but with decimal
// numbers, with the names of literals and without blanks. The reader distinguishes values inside and outside the finite
// instantiation.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "conformance/model/data_independence.hpp"
#include "conformance/model/tested_sequences.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// A value in a log as a tree of parts.
struct LoggedPart {
    std::int64_t number = 0;  ///< the number as in ir::Value
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
    /// For a value outside the carrier: true if the value can be replaced by a value of the carrier. This is so if the
    /// component only passes on such numbers, or if it only compares them with constants, and the carrier contains
    /// numbers for which these comparisons have the same answers.
    bool replaceable = false;
    LoggedPart whole;
};

/// Thrown if a text is not a value of its type. Contains the expected form, and the part of the text that does not
/// match.
struct ValueFault {
    std::string expected;
    std::size_t begin = 0;
    std::size_t length = 0;
};

/// States when a logged number counts as a number of the carrier.
enum class NumberReading {
    exact,    ///< if it is equal; for numbers that the component compares with constants
    rounded,  ///< if the difference is a rounding error of double, or the logged number is the nearest float
};

/// The constants of the model with which the component compares numbers of a kind, ascending.
struct ComparedConstants {
    std::vector<double> ordered;  ///< constants compared by <, <=, > or >=
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

/// How the component uses numbers.
struct TestedNumbers {
    DataIndependence uses;
    std::map<ir::TypeKind, ComparedConstants> constants;
    std::vector<double> literals;  ///< the literals and constants of the component, ascending
    std::vector<ComparedSums> sums;
    TestedSequences sequences;
    NumberCodes codes;  ///< of a log whose numbers are in the carriers (conformance/traces/logged_numbers.hpp)
};

/// Reads the values of one type of a model.
class ValueReader {
public:
    ValueReader(const ir::System&, const ir::Instantiation&, ir::TypeId, const TestedNumbers&, NumberReading);

    /// Reads a value. Throws ValueFault.
    [[nodiscard]] LoggedValue read_value(std::string_view text) const;
    /// Returns the index of the value in the carrier that represents a value outside the carrier. Each number outside
    /// its carrier is replaced by a number of the same kind. `salt` selects the replacement. If the component only
    /// passes on the numbers, any number of the carrier may be a replacement. Otherwise, a replacement must have the
    /// same answers in all comparisons with constants. Equal numbers get equal replacements. A literal of the component
    /// is a replacement only if there is no other number.
    [[nodiscard]] std::int64_t replacement_index(const LoggedValue&, std::uint64_t salt) const;

private:
    /// Represents the answers of all comparisons of a number with constants. The first member is how many ordered
    /// constants are less than the number. The second member is the index of the constant that equals the number (-1:
    /// no constant).
    using Answers = std::pair<std::size_t, std::ptrdiff_t>;
    [[nodiscard]] Answers answers_for(ir::TypeKind, double) const;
    /// Returns the index of the value in the carrier. Numbers outside their carriers are replaced.
    [[nodiscard]] std::optional<std::int64_t> carrier_index(const LoggedPart&, std::uint64_t salt) const;
    /// Returns the index of the sequence that represents a tested sequence.
    [[nodiscard]] std::optional<std::int64_t> sequence_index(const SequenceTests&, const LoggedPart&) const;
    [[nodiscard]] const SequenceTests* sequence_tests() const;

    [[nodiscard]] std::optional<std::int64_t> replacement_number(const LoggedPart&, std::uint64_t salt) const;
    [[nodiscard]] std::optional<ir::Value> replacement_value(const LoggedPart&, std::uint64_t salt) const;
    [[nodiscard]] bool is_replaceable(const LoggedPart&) const;
    /// Returns the numbers of the carrier that can replace the number.
    [[nodiscard]] const std::vector<std::int64_t>& candidates(const LoggedPart&) const;

    const ir::System* system_;
    const ir::Instantiation* instantiation_;
    ir::TypeId type_;
    TestedNumbers numbers_;
    NumberReading reading_;
    bool composed_;
    std::map<ir::Value, std::int64_t> places_;  ///< for values with parts
    /// The possible replacements, by kind and by the answers of the comparisons. They are computed on demand.
    mutable std::map<std::pair<ir::TypeKind, Answers>, std::vector<std::int64_t>> candidates_;
};

/// Returns the text of a model's value in a log: "0.5", "Red", "(1,<2,3>)".
[[nodiscard]] std::string log_text(const ir::System&, const ir::Instantiation&, ir::TypeId, const ir::Value&);

}  // namespace robochart::conformance
