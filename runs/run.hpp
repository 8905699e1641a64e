// A run of a component in the words of the model, as data: what a counterexample shows. Whoever renders it (text, JSON,
// a diagram, an editor) reads this and needs to know nothing of CSP. Types only; interpreter.hpp makes runs.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace robochart::runs {

/// Part of a text as people count it, from 1; columns count Unicode code points, the end is exclusive.
struct Place {
    std::string file;
    std::uint32_t line = 0, column = 0;
    std::uint32_t end_line = 0, end_column = 0;

    friend auto operator<=>(const Place&, const Place&) = default;
};

/// What happens in a step, in terms of the model.
enum class Kind {
    transition,      ///< a transition without trigger fires
    input,           ///< an event is received
    output,          ///< an event is sent
    call,            ///< an operation that no definition in the context answers is called
    assignment,      ///< a variable is written
    external_write,  ///< somebody else writes a shared variable
    entered,         ///< a state has been entered
    exited,          ///< a state has been left
    tock,            ///< time passes
    terminate,
    refusal,   ///< something is refused, where the model of refinement makes that an event (tick-tock)
    internal,  ///< a step that the model does not name
    event,     ///< an event of a process in a CSP block
};

/// A value that is communicated.
struct Value {
    std::string text;
    std::string type;  ///< as the model writes it; "" where it is not known

    friend auto operator<=>(const Value&, const Value&) = default;
};

/// Something that happens or could happen.
struct Event {
    Kind kind = Kind::internal;
    std::string text;       ///< "input a with 3", "t0: i -> S1"
    std::string component;  ///< the instance that does it, "P::M::ctrl_ref0::stm_ref0"; "" if no component does
    /// In the resolved model: of the transition or statement where that is known, otherwise of what is declared.
    std::string element;
    std::string via;  ///< the transition or action that makes it happen, in words: "t1: S1 -> S2"; "" if not known
    std::vector<Value> values;
    std::optional<Place> place;

    friend auto operator<=>(const Event&, const Event&) = default;
};

/// What a value shown beside a state is.
enum class VariableKind {
    variable,
    clock,      ///< time since its last reset
    constant,   ///< a constant that the component takes as a parameter
    countdown,  ///< time left of a wait or a deadline
    temporary,  ///< a value that has been read or received and is not used up yet
};

/// A value that belongs to a machine at one moment.
struct Variable {
    std::string name;
    VariableKind kind = VariableKind::variable;
    std::string type;                  ///< "" where there is none
    std::optional<std::string> value;  ///< none: nothing reads the value any more
    std::string deadline;              ///< countdown of a deadline: its element
    std::optional<Place> place;        ///< of that deadline

    friend auto operator<=>(const Variable&, const Variable&) = default;
};

/// A machine at one moment.
struct Machine {
    std::string component;            ///< the instance
    std::string machine;              ///< its definition, "P::S"
    std::string text;                 ///< "in S1", "entry action of S1, at x = 1"
    std::vector<std::string> active;  ///< the elements of its active states, outermost first
    std::vector<Variable> variables;
    std::optional<Place> place;  ///< of the innermost state, or of the statement that is next

    friend auto operator<=>(const Machine&, const Machine&) = default;
};

/// A variable that a step changes.
struct Change {
    std::string component;
    std::string name;
    std::optional<std::string> before;  ///< none: it had no value that anything would have read
    std::string after;
};

/// One step of a run: what happens, and the state behind it.
struct Step {
    std::size_t raw = 0;    ///< the first event of Run::raw that it stands for
    std::size_t count = 1;  ///< how many; 0: a step inside a compressed process, which the raw events do not show
    std::optional<std::int64_t> time;  ///< time units passed before it; only in timed runs
    std::int64_t units = 0;            ///< tock: how many pass
    bool hidden = false;               ///< the environment does not see it
    Event event;
    std::vector<Event> with;  ///< what other components do in the same step
    std::vector<Change> changes;
    std::vector<Machine> machines;  ///< all of them, behind the step
    std::vector<Event> offered;     ///< what else was possible in front of it
    std::size_t more_offered = 0;   ///< how many more than are listed
};

/// What is wrong where a run ends; or what it shows, if the claim is that there is no such run.
enum class EndKind {
    forbidden,              ///< the last step is none that the specification allows
    refusal,                ///< less is offered than the specification requires
    divergence,             ///< it goes on internally for ever
    deadlock,               ///< nothing is possible any more, in time: but that time passes
    nondeterminism,         ///< something may be accepted and may be refused
    reached,                ///< the state has been reached
    terminated,             ///< it has terminated
    timelock,               ///< time cannot pass
    clock_not_initialised,  ///< a clock is read before its first reset
    clock_initialised,      ///< it is reset, where the claim is that it is not
    missed,                 ///< an event is refused while time passes
    no_return,              ///< what is asked for can never happen again
    no_trace,               ///< the process has no such trace
};

/// Why time cannot pass.
struct Cause {
    std::string text;
    std::string component;
    std::optional<Place> place;
};

/// What is wrong where the run ends.
struct End {
    EndKind kind = EndKind::forbidden;
    std::string why;             ///< in a sentence
    std::optional<Event> event;  ///< forbidden: the offending one; nondeterminism: the one that may be refused
    std::vector<Event> offered;  ///< what is possible there
    std::vector<std::vector<Event>> required;  ///< refusal: the alternatives of what must be offered
    std::vector<Event> allowed;                ///< forbidden: what the specification allows instead
    std::vector<Event> refused;                ///< refusal: what would have to be offered and is not
    std::vector<Cause> causes;                 ///< timelock
};

/// A counterexample as a run of the model; text and JSON are made from this alone.
struct Run {
    bool timed = false;
    std::int64_t time = 0;         ///< when it ends; where it goes on for ever: where the loop begins
    std::vector<Machine> initial;  ///< in front of the first step
    std::vector<Step> steps;
    std::optional<std::size_t> loop_start;  ///< the first of the steps that are repeated for ever
    End end;
    std::vector<std::string> raw;  ///< the events of the script, those of the loop behind the others
    std::size_t raw_loop = 0;      ///< how many of these are the loop's
};

}  // namespace robochart::runs
