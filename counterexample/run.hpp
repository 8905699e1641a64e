// SPDX-License-Identifier: Apache-2.0
// A run of a component in terms of the model, as data: the contents of a counterexample. Renderers (text, JSON, a
// diagram, an editor) use only this and need no knowledge of CSP. This file contains only types; interpreter.hpp makes
// runs.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/durations/time_unit.hpp"

namespace robochart::runs {

/// A range in a text: lines and columns from 1, columns in Unicode code points, the end exclusive.
struct Place {
    std::string file;
    std::uint32_t line = 0, column = 0;
    std::uint32_t end_line = 0, end_column = 0;

    friend auto operator<=>(const Place&, const Place&) = default;
};

/// The kind of a step, in terms of the model.
enum class Kind {
    transition,      ///< a transition without trigger fires
    input,           ///< an event is received
    output,          ///< an event is sent
    call,            ///< an operation without a definition in the context is called
    assignment,      ///< a variable is written
    external_write,  ///< another component writes a shared variable
    entered,         ///< a state has been entered
    exited,          ///< a state has been left
    tock,            ///< time passes
    terminate,
    refusal,     ///< a refusal, in models of refinement in which it is an event (tick-tock)
    internal,    ///< a step without a name in the model
    event,       ///< an event of a process in a CSP block
    read,        ///< RoboSim: a register is read that contains a value
    empty_read,  ///< RoboSim: the empty register of an event is read
    cycle_end,   ///< RoboSim: the execution of a cycle ends
};

/// A value that is communicated.
struct Value {
    std::string text;
    std::string type;  ///< as the model writes it; "" if unknown

    friend auto operator<=>(const Value&, const Value&) = default;
};

/// An event that happens or could happen.
struct Event {
    Kind kind = Kind::internal;
    std::string text;       ///< "input a with 3", "t0: i -> S1"
    std::string component;  ///< the instance that performs it, "P::M::ctrl_ref0::stm_ref0"; "" if there is none
    /// The element of the resolved model: the transition or statement, if known; otherwise the declaration.
    std::string element;
    std::string via;  ///< the transition or action that causes it: "t1: S1 -> S2"; "" if unknown
    std::vector<Value> values;
    std::optional<Place> place;

    friend auto operator<=>(const Event&, const Event&) = default;
};

/// The kind of a value shown with a state.
enum class VariableKind {
    variable,
    clock,      ///< time since its last reset
    constant,   ///< a constant that the component takes as a parameter
    countdown,  ///< remaining time of a wait or a deadline
    temporary,  ///< a value that was read or received but not yet used
};

/// A value of a machine at one moment.
struct Variable {
    std::string name;
    VariableKind kind = VariableKind::variable;
    std::string type;                  ///< "" if it has none
    std::optional<std::string> value;  ///< no value: the variable is no longer read
    std::string deadline;              ///< countdown of a deadline: the element with the deadline
    std::optional<Place> place;        ///< the place of that deadline

    friend auto operator<=>(const Variable&, const Variable&) = default;
};

/// The state of a machine at one moment.
struct Machine {
    std::string component;            ///< the instance
    std::string machine;              ///< its definition, "P::S"
    std::string text;                 ///< "in S1", "entry action of S1, at x = 1"
    std::vector<std::string> active;  ///< the elements of its active states, outermost first
    std::vector<Variable> variables;
    std::optional<Place> place;  ///< the place of the innermost state or of the next statement

    friend auto operator<=>(const Machine&, const Machine&) = default;
};

/// A variable that a step changes.
struct Change {
    std::string component;
    std::string name;
    std::optional<std::string> before;  ///< no value: it had no value that could be read
    std::string after;
};

/// One step of a run: what happens, and the state after it.
struct Step {
    std::size_t raw = 0;    ///< the first event of Run::raw that it represents
    std::size_t count = 1;  ///< the number of these events; 0: a step inside a compressed process, which has no raw
                            ///< event
    std::optional<std::int64_t> time;  ///< time units before it; only in timed runs
    std::int64_t units = 0;            ///< tock: the number of time units
    bool hidden = false;               ///< invisible to the environment
    Event event;
    std::vector<Event> with;  ///< what other components do in the same step
    std::vector<Change> changes;
    std::vector<Machine> machines;  ///< all machines, after the step
    std::vector<Event> offered;     ///< the alternatives before it
    std::size_t more_offered = 0;   ///< the number of alternatives that are not listed
    bool in_scope = false;          ///< the run breaks a claim with a scope: the scope lasts after the step
    bool owed = false;              ///< the run breaks a claim: something is owed after the step
};

/// The violation at the end of a run. For a claim that no such run exists, the fact that the run shows.
enum class EndKind {
    forbidden,              ///< the specification does not allow the last step
    refusal,                ///< fewer events are offered than the specification requires
    divergence,             ///< infinitely many internal steps
    deadlock,               ///< no step is possible; in the timed semantics, no step except the passing of time
    nondeterminism,         ///< an event may be accepted and may be refused
    reached,                ///< the state has been reached
    terminated,             ///< the component has terminated
    timelock,               ///< time cannot pass
    clock_not_initialised,  ///< a clock is read before its first reset
    clock_initialised,      ///< the clock is reset, although the claim is that it is not
    missed,                 ///< an event is refused while time passes
    no_return,              ///< the required event can never happen again
    no_trace,               ///< the process has no such trace
    undefined,              ///< an expression of the model has no value, so the next step is not known
};

/// Why time cannot pass.
struct Cause {
    std::string text;
    std::string component;
    std::optional<Place> place;
};

/// The violation at the end of the run.
struct End {
    EndKind kind = EndKind::forbidden;
    std::string why;             ///< one sentence
    std::optional<Event> event;  ///< forbidden: the offending event; nondeterminism: the event that may be refused
    std::vector<Event> offered;  ///< the events that are possible there
    std::vector<std::vector<Event>> required;  ///< refusal: the alternatives of required offers
    std::vector<Event> allowed;                ///< forbidden: the events that the specification allows instead
    std::vector<Event> refused;                ///< refusal: the events that should be offered but are not
    std::vector<Cause> causes;                 ///< timelock
};

/// A counterexample as a run of the model; text and JSON are made only from this.
struct Run {
    bool timed = false;
    durations::Unit unit;          ///< the length of a time unit
    std::int64_t time = 0;         ///< time at the end of the run; if it is infinite, at the beginning of the loop
    std::vector<Machine> initial;  ///< before the first step
    std::vector<Step> steps;
    std::optional<std::size_t> loop_start;  ///< the first step of the infinite loop
    End end;
    std::vector<std::string> raw;  ///< the events of the script, followed by those of the loop
    std::size_t raw_loop = 0;      ///< number of events in the loop
};

}  // namespace robochart::runs
