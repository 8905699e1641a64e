// SPDX-License-Identifier: Apache-2.0
// Defines claims after name resolution: events are numbers of channels, durations are time units.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "claims/checks/components.hpp"
#include "claims/checks/fraction.hpp"
#include "claims/syntax/syntax.hpp"
#include "semantics/instantiate/given_constants.hpp"

namespace robochart::claims {

/// The operands of conditions in addition to those of Op.
enum class Operand : std::uint8_t {
    none,      ///< an operator of Op
    constant,  ///< `value`
    argument,  ///< the value with this index that the event carries
    last,      ///< the last value of remembered channel `index`; the condition is false if there was none
    fact,      ///< the truth of the claim's fact `index`
    variable,  ///< the variable `index` of a machine; only in the condition of a fact
    of_model,  ///< the constant `index` of a machine; only in the condition of a fact
};

/// A resolved condition. Truth values are 0 and 1; literals are their indices.
struct Condition {
    Operand operand = Operand::none;
    Op op = Op::conjunction;
    Fraction value;
    std::size_t index = 0;
    ir::TypeId type = {};  ///< type of a constant or variable of an enumeration, of a truth value or of a variable
    std::vector<Condition> parts;

    friend bool operator==(const Condition&, const Condition&) = default;
};

/// A fact about a machine that a claim reads in addition to events: the machine is in a state, or its variables satisfy
/// a condition.
struct Fact {
    std::string machine;  ///< path of the machine in the script: "warehouse::Warehouse::brain::patrol"
    ir::MachineId of;
    std::optional<ir::NodeId> state;
    Condition condition;  ///< the condition on variables, if the fact is not about a state
    std::string text;     ///< as written

    friend bool operator==(const Fact& one, const Fact& other) {
        return one.machine == other.machine && one.state == other.state && one.condition == other.condition;
    }
};

enum class Change : std::uint8_t { none, begins, ends };

/// The events of some channels for which a condition holds.
struct EventMatch {
    std::vector<std::size_t> channels;   ///< channels of the claim's component, ascending
    std::optional<Condition> condition;  ///< only for a single channel
    Change change = Change::none;        ///< set for `enter S` and `leave S`, which have no channels
    std::size_t fact = 0;                ///< the fact that changes
    std::string text;                    ///< as written
    Span span;
};

/// A union of matches.
struct Events {
    std::vector<EventMatch> any;
    bool start = false;      ///< true if the set contains the beginning of the run
    bool terminate = false;  ///< true if the set contains the end of the component
    std::string text;        ///< as written

    [[nodiscard]] bool empty() const { return any.empty() && !start && !terminate; }
};

struct CheckedScope {
    ScopeKind kind = ScopeKind::whole;
    Events first, last;
    std::int64_t units = 0;              ///< for_after
    std::optional<Condition> condition;  ///< during
};

struct CheckedBody {
    BodyKind kind = BodyKind::never;
    Events events, others, exceptions;
    std::optional<Condition> condition;  ///< condition on facts; `possible`: no value if it is about events
    std::string condition_text;          ///< as written
    std::optional<std::int64_t> units;
    std::int64_t count = 0;
};

struct CheckedClaim {
    std::string name;
    bool assumption = false;
    std::string wording;
    Component component;
    CheckedScope scope;
    CheckedBody body;
    std::vector<std::size_t> remembered;  ///< channels whose last value is used
    std::vector<Fact> facts;              ///< the facts about states and variables that the claim reads
    bool raised = false;         ///< true if the claim is about raised events, which exist only in control cycles
    ir::SetConstants constants;  ///< those of `with constant`
    std::vector<std::string> settings;  ///< the same as options, sorted: "p::Patrol::patience=30"
    Span span;
};

/// The order of events in a cycle.
struct CheckedOrder {
    struct Drop {
        std::string event, dropped;
    };
    Component component;
    std::vector<std::string> first;  ///< empty unless the component is a machine
    std::vector<Drop> drops;
    Span span;
};

/// All claims of a model.
struct CheckedClaims {
    std::optional<std::int64_t> unit;  ///< nanoseconds of a time unit, if declared
    std::vector<CheckedClaim> claims;
    std::vector<CheckedOrder> orders;
};

}  // namespace robochart::claims
