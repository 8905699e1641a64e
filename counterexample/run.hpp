// SPDX-License-Identifier: Apache-2.0
// Represents a run of a component in terms of the model, which is the content of a counterexample. Renderers (text,
// JSON, a diagram, an editor) use only these data and need no knowledge of CSP. This file contains only types;
// interpreter.hpp creates runs.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/durations/time_unit.hpp"

namespace robochart::runs {

/// A range in a text. Lines and columns are counted from 1, columns in Unicode code points. The end is exclusive.
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
    std::string type;  ///< in the notation of the model; "" if unknown

    friend auto operator<=>(const Value&, const Value&) = default;
};

/// An event that happens or could happen.
struct Event {
    Kind kind = Kind::internal;
    std::string text;       ///< such as "input a with 3" or "t0: i -> S1"
    std::string component;  ///< instance that performs it, "P::M::ctrl_ref0::stm_ref0"; or ""
    /// The element of the resolved model: the transition or statement if it is known, otherwise the declaration.
    std::string element;
    std::string via;  ///< the transition or action that causes the event: "t1: S1 -> S2"; "" if unknown
    std::vector<Value> values;
    std::optional<Place> place;

    friend auto operator<=>(const Event&, const Event&) = default;
};

/// The kind of a value that is shown with a state.
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
    std::string type;                  ///< "" if the variable has no type
    std::optional<std::string> value;  ///< no value if the variable is no longer read
    std::string deadline;              ///< for the countdown of a deadline: the element with the deadline
    std::optional<Place> place;        ///< the place of that deadline

    friend auto operator<=>(const Variable&, const Variable&) = default;
};

/// The state of a machine at one moment.
struct Machine {
    std::string component;            ///< name of the instance
    std::string machine;              ///< name of the definition, "P::S"
    std::string text;                 ///< such as "in S1" or "entry action of S1, at x = 1"
    std::vector<std::string> active;  ///< elements of the active states, outermost first
    std::vector<Variable> variables;
    std::optional<Place> place;  ///< the place of the innermost state or of the next statement

    friend auto operator<=>(const Machine&, const Machine&) = default;
};

/// A variable that a step changes.
struct Change {
    std::string component;
    std::string name;
    std::optional<std::string> before;  ///< no value if no value could be read before the step
    std::string after;
};

/// One step of a run: what happens, and the state after it.
struct Step {
    std::size_t raw = 0;  ///< index in Run::raw of the first event that the step represents
    /// How many of these events there are. 0 for a step inside a compressed process, which has no raw event.
    std::size_t count = 1;
    std::optional<std::int64_t> time;  ///< time units before the step; only in timed runs
    std::int64_t units = 0;            ///< tock: the number of time units
    bool hidden = false;               ///< whether the environment cannot see the step
    Event event;
    std::vector<Event> with;  ///< what other components do in the same step
    std::vector<Change> changes;
    std::vector<Machine> machines;  ///< all machines after the step
    std::vector<Event> offered;     ///< alternatives before the step
    std::size_t more_offered = 0;   ///< number of alternatives that are not listed
    /// For a run that breaks a claim with a scope: whether the scope lasts after the step.
    bool in_scope = false;
    /// For a run that breaks a claim: whether the claim still waits for something after the step.
    bool owed = false;
};

/// The violation at the end of a run. If the claim was that no such run exists, it is the fact that the run shows.
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
    no_trace,               ///< the process cannot perform the trace
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
    std::string why;                           ///< one sentence
    std::optional<Event> event;                ///< forbidden: this event; nondeterminism: the event that may be refused
    std::vector<Event> offered;                ///< events that are possible at the end of the run
    std::vector<std::vector<Event>> required;  ///< refusal: offers; the specification requires one of them
    std::vector<Event> allowed;                ///< forbidden: the events that the specification allows instead
    std::vector<Event> refused;                ///< refusal: the events that should be offered but are not
    std::vector<Cause> causes;                 ///< timelock
};

/// A counterexample as a run of the model. Text and JSON are created only from these data.
struct Run {
    bool timed = false;
    durations::Unit unit;          ///< the length of a time unit
    std::int64_t time = 0;         ///< time at the end of the run; for an infinite run, at the beginning of the loop
    std::vector<Machine> initial;  ///< machines before the first step
    std::vector<Step> steps;
    std::optional<std::size_t> loop_start;  ///< the first step of the infinite loop
    End end;
    std::vector<std::string> raw;  ///< events of the script, followed by those of the loop
    std::size_t raw_loop = 0;      ///< number of events in the loop
};

}  // namespace robochart::runs
