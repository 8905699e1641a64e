// SPDX-License-Identifier: Apache-2.0
// Defines the syntax tree of a claims file (docs/claims.md, "The language").
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/words/words.hpp"

namespace robochart::claims {

using diagnostics::Span;

using words::Name;

// ---------------------------------------------------------------- conditions

enum class Op : std::uint8_t {
    number,    ///< text: the number as written
    truth,     ///< text: "true" or "false"
    name,      ///< text: a variable of the pattern, or a literal ("Colour::red")
    last,      ///< text: an event; means the value that it carried last
    in_state,  ///< text: a state, possibly with its machine: `in Patrol::Held`
    negate,
    add,
    subtract,
    multiply,
    modulus,
    less,
    less_equal,
    greater,
    greater_equal,
    equal,
    unequal,
    negation,
    conjunction,
    disjunction,
};

struct Expr;
using ExprPtr = std::shared_ptr<const Expr>;

/// A condition on the values of an event or on the states and variables of a component, or a number in it.
struct Expr {
    Op op = Op::number;
    std::string text;
    std::vector<ExprPtr> parts;
    Span span;
};

// ---------------------------------------------------------------- events

/// The word in front of an event's name.
enum class Direction : std::uint8_t { none, input, output, call, raised };

enum class PatternKind : std::uint8_t {
    named,
    any_call,   ///< `any call [but E]`
    any_input,  ///< `any input [but E]`
    start,      ///< the beginning of the run
    terminate,  ///< the end of the component
    enter,      ///< enter NAME: the machine enters a state
    leave,      ///< leave NAME
};

struct Pattern;

/// Patterns that are joined with `or`.
struct EventSet {
    std::vector<Pattern> patterns;
    Span span;
};

/// One or several events of a component, restricted by a condition on their values.
struct Pattern {
    PatternKind kind = PatternKind::named;
    Direction direction = Direction::none;
    Name name;
    std::optional<std::vector<ExprPtr>> arguments;  ///< no value without parentheses; `_` and variables are names
    ExprPtr condition;                              ///< null if there is none
    std::vector<Pattern> but;                       ///< any_call, any_input: the exceptions
    Span span;
};

// ---------------------------------------------------------------- durations

enum class TimeUnit : std::uint8_t { none, units, milliseconds, seconds, minutes, hours };

/// A duration as written: `150 ms`, `30 units`.
struct Duration {
    bool negative = false;
    std::string number;
    TimeUnit unit = TimeUnit::none;
    Span span;
};

// ---------------------------------------------------------------- claims

enum class ScopeKind : std::uint8_t {
    whole,        ///< the whole run
    before,       ///< before FIRST
    after,        ///< after FIRST
    after_until,  ///< after FIRST until LAST
    after_each,   ///< after each FIRST
    for_after,    ///< for DURATION after FIRST
    during,       ///< while CONDITION
    cycle,        ///< in a cycle with FIRST
};

struct Scope {
    ScopeKind kind = ScopeKind::whole;
    EventSet first, last;
    ExprPtr condition;        ///< during
    bool only_first = false;  ///< `after first E`: a count begins once
    Duration duration;
    Span span;
};

enum class BodyKind : std::uint8_t {
    never,         ///< never EVENTS
    only_after,    ///< EVENTS only after OTHERS
    only_within,   ///< EVENTS only within DURATION after OTHERS
    leads_within,  ///< EVENTS leads to OTHERS within DURATION [unless EXCEPTIONS]
    leads,         ///< EVENTS leads to OTHERS [unless EXCEPTIONS]
    leads_before,  ///< EVENTS leads to OTHERS before EXCEPTIONS
    at_least,      ///< EVENTS at least DURATION after OTHERS [unless EXCEPTIONS]
    at_most,       ///< at most COUNT EVENTS [in any DURATION]
    every,         ///< EVENTS at least every DURATION
    possible,      ///< possible EVENTS, possible CONDITION
    always,        ///< always CONDITION
    for_at_least,  ///< CONDITION for at least DURATION
    for_at_most,   ///< CONDITION for at most DURATION
    can_take,      ///< can take EVENTS [within DURATION]
};

struct Body {
    BodyKind kind = BodyKind::never;
    EventSet events, others, exceptions;
    ExprPtr condition;  ///< always, for_at_least, for_at_most; possible: null if it is about events
    std::optional<Duration> duration;
    std::string count;  ///< at_most
    Span count_span;
    Span span;
};

/// with constant NAME of COMPONENT set to VALUE
struct SetConstant {
    Name name, component;
    std::string value;                 ///< a number, a truth value or a literal: "-3", "true", "Colour::red"
    std::optional<Duration> duration;  ///< the value, if it is a time
    Span value_span;
};

struct Claim {
    Name name;
    bool assumption = false;        ///< `assume`: runs that break it are not considered
    std::optional<Name> component;  ///< `of COMPONENT`
    Scope scope;
    Body body;
    std::vector<SetConstant> constants;
    Span span;
    std::string wording;  ///< scope, body and constants on one line
};

/// order COMPONENT : E first, E drops E
struct Order {
    struct Drop {
        Name event, dropped;
    };
    Name component;
    std::vector<Name> first;
    std::vector<Drop> drops;
    Span span;
};

struct Import {
    Name name;
    bool wildcard = false;
};

struct ClaimFile {
    std::optional<Name> package;
    std::vector<Import> imports;
    std::vector<Duration> units;  ///< all declared lengths of a time unit, including repeated declarations
    std::vector<Claim> claims;
    std::vector<Order> orders;
    diagnostics::SourceId source = diagnostics::SourceId::none;
};

}  // namespace robochart::claims
