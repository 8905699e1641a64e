// SPDX-License-Identifier: Apache-2.0
// Defines the syntax tree of SLEEC: the dialects of SLEEC-TK and of LEGOS, and the extensions of this tool. The parser
// (reader.hpp) makes the tree, and the printer (printer.hpp) writes it. docs/rules-language.md contains the grammar.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/words/words.hpp"

namespace robochart::sleec {

using diagnostics::Span;

using words::Name;

struct Expr;
using ExprPtr = std::shared_ptr<const Expr>;

/// An event in a rule. As an extension, it may have arguments, as in `goTo(1)`; `_` is any value.
struct EventName : Name {
    std::optional<std::vector<ExprPtr>> arguments;  ///< numbers and names; no value if there are no parentheses
};

/// The tool that defines a dialect: SLEEC-TK (with a tock-CSP semantics), or LEGOS.
enum class Dialect : std::uint8_t { sleec_tk, legos };
/// Returns "SLEEC-TK" or "LEGOS".
[[nodiscard]] const char* dialect_name(Dialect dialect);

/// The kind of an expression. `Expr::parts` contains its operands in textual order.
enum class Op : std::uint8_t {
    truth,     ///< text: "true" or "false"
    number,    ///< text: digits
    name,      ///< text: a measure, a constant, a literal of a scale, or, alone after `unless`, an event
    in_state,  ///< extension: `in STATE`; text: the path of the state, possibly with its machine
    disjunction,
    conjunction,
    negation,
    less,
    less_equal,
    greater,
    greater_equal,
    equal,
    unequal,
    add,
    subtract,
    multiply,
};
/// Returns "or", "<=", ...; "" for kinds without an operator.
[[nodiscard]] const char* symbol_of(Op op);
/// True for <, <=, >, >=, =, <>.
[[nodiscard]] bool is_comparison(Op op);

/// A condition or a value.
struct Expr {
    Op op = Op::truth;
    Span span;
    std::string text;
    std::vector<ExprPtr> parts;
    bool braced = false;     ///< a name in braces, as LEGOS writes measures
    bool bracketed = false;  ///< the expression is in parentheses
};
enum class Unit : std::uint8_t { seconds, minutes, hours, days };
/// Returns "seconds", ...
[[nodiscard]] const char* unit_name(Unit unit);
/// Returns the number of seconds of a unit.
[[nodiscard]] std::int64_t seconds_of(Unit unit);

/// A limit: `within N unit`, in LEGOS also `within [A, B] unit`, `within [A unit, B unit]` and `within (EXPRESSION)
/// unit`.
struct Limit {
    ExprPtr from;  ///< null: 0
    ExprPtr to;
    Unit unit = Unit::seconds;
    Unit from_unit = Unit::seconds;  ///< the unit of `to`, unless each end has its own
    bool each_unit = false;          ///< the units are inside the brackets
    Span span;
};

struct Response;
using ResponsePtr = std::shared_ptr<const Response>;

/// `unless condition [then response]`. Extension: `unless EVENT`.
struct Defeater {
    ExprPtr condition;               ///< null if `event` has a value
    std::optional<EventName> event;  ///< an event with arguments; a single name is a condition until it is resolved
    ResponsePtr response;            ///< null if no duty is left
    Span span;
};

/// `[not] EVENT [eventually | within ...] [otherwise response] {unless ...}`.
struct Response {
    bool negated = false;
    EventName event;
    std::shared_ptr<const Limit> limit;  ///< null if there is none
    bool eventually = false;             ///< the keyword is written (LEGOS)
    ResponsePtr otherwise;               ///< null if there is none
    bool written_else = false;           ///< `else` instead of `otherwise` (LEGOS)
    std::vector<Defeater> defeaters;
    bool braced = false;  ///< the response is in braces
    Span span;
};

/// `EVENT [and condition]`.
struct Trigger {
    EventName event;
    ExprPtr condition;  ///< null if there is none
};

struct Event {
    Name name;
};

enum class MeasureType : std::uint8_t { boolean, numeric, scale };

struct Measure {
    Name name;
    MeasureType type = MeasureType::boolean;
    std::vector<Name> literals;  ///< scale: least first
};

struct Constant {
    Name name;
    ExprPtr value;  ///< a number or another constant
};

/// Extension: `map EVENT to Module::event` gives the model's name of an event or a measure.
struct Mapping {
    Name name;
    Name element;
};

/// The syntactic form of a rule.
enum class RuleForm : std::uint8_t {
    when,      ///< `when E and c then ...`
    after,     ///< extension: `after E and c, ...`, which is `when E and c then ...`
    at_least,  ///< extension: `F at least N unit after E and c`; F must not occur sooner
};

struct Rule {
    Name name;
    RuleForm form = RuleForm::when;
    bool assumed = false;  ///< extension: `assume`, a rule that the environment obeys
    Trigger trigger;
    ResponsePtr response;
    Span span;
};

/// LEGOS: a situation that must be impossible (concern) or possible (purpose). `when E then R`: E occurs and R is
/// obeyed. `exists E while R`, where R has `eventually` or a limit, means the same. `exists E [while F]`: E occurs, at
/// the instant of F if F is given.
struct Property {
    Name name;
    bool exists = false;
    Trigger trigger;
    ResponsePtr response;                   ///< for `when`, `while R`; otherwise null
    std::shared_ptr<const Trigger> during;  ///< for `while`; null: none
    Span span;
};

/// A file of rules.
struct RuleFile {
    Dialect dialect = Dialect::sleec_tk;
    Span decided_by;  ///< a construct of only this dialect; unknown if there is none
    std::vector<Event> events;
    std::vector<Measure> measures;
    std::vector<Constant> constants;
    std::vector<Mapping> mappings;
    std::vector<Rule> rules;
    std::vector<Property> concerns;
    std::vector<Property> purposes;
};

}  // namespace robochart::sleec
