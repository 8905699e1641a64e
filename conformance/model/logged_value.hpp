// Values in the words of logs (docs/traces.md): the notation of the CSP alphabet with decimal numbers, the names of
// literals and no blanks. Values outside the finite instantiation are distinguished from those inside.
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

/// A value as it was logged, part by part.
struct LoggedPart {
    std::int64_t number = 0;  ///< as in ir::Value
    std::string outside;      ///< of a number that its carrier does not have: in one spelling for one value
    ir::TypeKind kind = ir::TypeKind::unit;
    std::vector<LoggedPart> parts;
};

/// A value in a log.
struct LoggedValue {
    std::optional<std::int64_t> number;  ///< as in the carrier, values with parts by their place in it; none: outside
    std::string text;                    ///< outside: as it is reported
    bool passed_on = false;              ///< outside: the component only passes such values on
    LoggedPart whole;
};

/// Thrown where a text is no value of its type: what the type has, and which part of the text is none.
struct ValueFault {
    std::string wanted;
    std::size_t begin = 0;
    std::size_t length = 0;
};

/// The values of one type of a model.
class ValueReader {
public:
    ValueReader(const ir::System&, const ir::Instantiation&, ir::TypeId, const DataIndependence&);

    /// Throws ValueFault.
    [[nodiscard]] LoggedValue read(std::string_view text) const;
    /// The value of the carrier that stands for one outside of it: numbers that it does not have are replaced by others
    /// of their kind, the same for the same number, chosen by `salt`.
    [[nodiscard]] std::int64_t stand_in(const LoggedValue&, std::uint64_t salt) const;

private:
    /// In the carrier; numbers outside of theirs are replaced.
    [[nodiscard]] std::optional<std::int64_t> place(const LoggedPart&, std::uint64_t salt) const;

    const ir::System* system_;
    const ir::Instantiation* instantiation_;
    ir::TypeId type_;
    DataIndependence passed_on_;
    bool composed_;
    std::map<ir::Value, std::int64_t> places_;  ///< of values with parts
};

/// A value of the model as logs have it: "0.5", "Red", "(1,<2,3>)".
[[nodiscard]] std::string log_text(const ir::System&, const ir::Instantiation&, ir::TypeId, const ir::Value&);

}  // namespace robochart::conformance
