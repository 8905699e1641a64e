// SPDX-License-Identifier: Apache-2.0
// Values in logs (docs/traces.md): the notation of the CSP alphabet, with decimal numbers, the names of literals and no
// blanks. The reader distinguishes values inside and outside the finite instantiation.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/model/data_independence.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// A logged value, part by part.
struct LoggedPart {
    std::int64_t number = 0;  ///< as in ir::Value
    std::string outside;      ///< for a number outside its carrier: a canonical text
    ir::TypeKind kind = ir::TypeKind::unit;
    std::vector<LoggedPart> parts;
};

/// A value in a log.
struct LoggedValue {
    std::optional<std::int64_t> number;  ///< as in the carrier; for values with parts the index in it; no value:
                                         ///< outside
    std::string text;                    ///< outside: as reported
    bool passed_on = false;              ///< for a value outside: the component only passes such values on
    LoggedPart whole;
};

/// Thrown if a text is not a value of its type. Contains the expected form and the part of the text that does not
/// match.
struct ValueFault {
    std::string expected;
    std::size_t begin = 0;
    std::size_t length = 0;
};

/// Reads the values of one type of a model.
class ValueReader {
public:
    ValueReader(const ir::System&, const ir::Instantiation&, ir::TypeId, const DataIndependence&);

    /// Reads a value. Throws ValueFault.
    [[nodiscard]] LoggedValue read_value(std::string_view text) const;
    /// The index of the carrier's value that represents a value outside the carrier. Numbers outside their carriers are
    /// replaced by numbers of their kind, which `salt` selects. Equal numbers get equal replacements.
    [[nodiscard]] std::int64_t replacement_index(const LoggedValue&, std::uint64_t salt) const;

private:
    /// The index of the value in the carrier. Numbers outside their carriers are replaced.
    [[nodiscard]] std::optional<std::int64_t> carrier_index(const LoggedPart&, std::uint64_t salt) const;

    const ir::System* system_;
    const ir::Instantiation* instantiation_;
    ir::TypeId type_;
    DataIndependence passed_on_;
    bool composed_;
    std::map<ir::Value, std::int64_t> places_;  ///< for values with parts
};

/// The text of a model's value in a log: "0.5", "Red", "(1,<2,3>)".
[[nodiscard]] std::string log_text(const ir::System&, const ir::Instantiation&, ir::TypeId, const ir::Value&);

}  // namespace robochart::conformance
