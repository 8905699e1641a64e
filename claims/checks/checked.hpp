// SPDX-License-Identifier: Apache-2.0
// Claims after name resolution: events are numbers of channels, durations are time units.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "claims/checks/components.hpp"
#include "claims/checks/fraction.hpp"
#include "claims/syntax/syntax.hpp"

namespace robochart::claims {

/// The operands of conditions in addition to those of Op.
enum class Operand : std::uint8_t {
    none,      ///< an operator of Op
    constant,  ///< `value`
    argument,  ///< the value with this index that the event carries
    last,      ///< the last value of remembered channel `index`; the condition is false if there was none
};

/// A resolved condition. Truth values are 0 and 1; literals are their indices.
struct Condition {
    Operand operand = Operand::none;
    Op op = Op::conjunction;
    Fraction value;
    std::size_t index = 0;
    std::vector<Condition> parts;
};

/// The events of some channels for which a condition holds.
struct EventMatch {
    std::vector<std::size_t> channels;   ///< ascending; of the claim's component
    std::optional<Condition> condition;  ///< only for a single channel
    std::string text;                    ///< as written
    Span span;
};

/// A union of matches.
struct Events {
    std::vector<EventMatch> any;
    bool start = false;      ///< the beginning of the run belongs to it
    bool terminate = false;  ///< the end of the component belongs to it
    std::string text;        ///< as written

    [[nodiscard]] bool empty() const { return any.empty() && !start && !terminate; }
};

struct CheckedScope {
    ScopeKind kind = ScopeKind::whole;
    Events first, last;
    std::int64_t units = 0;  ///< for_after
};

struct CheckedBody {
    BodyKind kind = BodyKind::never;
    Events events, others, exceptions;
    std::optional<std::int64_t> units;
    std::int64_t count = 0;
};

struct CheckedClaim {
    std::string name;
    std::string wording;
    Component component;
    CheckedScope scope;
    CheckedBody body;
    std::vector<std::size_t> remembered;  ///< channels whose last value is used
    bool raised = false;                  ///< it is about raised events, which only cycles have
    Span span;
};

/// All claims of a model.
struct CheckedClaims {
    std::optional<std::int64_t> unit;  ///< nanoseconds of a time unit, if declared
    std::vector<CheckedClaim> claims;
};

}  // namespace robochart::claims
