// SPDX-License-Identifier: Apache-2.0
// Defines the result of the emission: a script, the checks that need it, and what the names of the script mean in the
// model.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "checker/cspm/syntax/syntax.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// The two semantics. Each has its own script.
enum class Time { untimed, timed };

/// The kind of model element that a name of the script denotes.
enum class MeaningKind {
    transition,  ///< hidden event of a transition that fires without a trigger
    trigger,     ///< visible input event
    output,
    call,
    entered,
    exited,
    assignment,
    external_write,
    terminate,
    step,
    memory,  ///< a read or write of a memory process; it is part of the preceding step
    tock,
    refusal,        ///< tick-tock: its argument is the refused event
    event_read,     ///< RoboSim: the register of an event is read; its first argument is whether it is full
    variable_read,  ///< RoboSim: the register of a variable is read
    cycle_end,      ///< RoboSim: the execution of a cycle ends
};
/// The data that determine the probability of a transition that leaves a probabilistic junction.
struct Draw {
    std::string junction;   ///< the junction, qualified by its operation if it is in one: "Turn_p0"
    ir::MachineId machine;  ///< the machine that owns the transition
    ir::TransitionId transition;
    std::vector<std::string> variables;  ///< by VariableId: the parameter that holds each variable of that machine
};
/// The meaning of an event of the script in the model.
struct EventMeaning {
    MeaningKind kind = MeaningKind::step;
    std::string text;               ///< description for readers: "S1 -> S2 on seeRobot", "call MoveClockwise"
    std::vector<ir::TypeId> types;  ///< types of the event's arguments, in order; empty if it has no arguments
    ir::Origin origin;
    std::string component = {};             ///< the component that performs the event: "P::C::stm_ref0"; "" if it
                                            ///< belongs to no component
    std::shared_ptr<const Draw> draw = {};  ///< for a transition that leaves a probabilistic junction; otherwise null
};
/// The kind of value that a parameter of a definition holds.
enum class ParameterKind {
    variable,  ///< a variable of the machine, or of an operation that is being called
    clock,     ///< time since its reset
    constant,
    countdown,  ///< remaining time of a wait or a deadline
    temporary,  ///< a value that has been read or received and is still needed
};
/// An event that a configuration may offer, and the model element that causes it.
struct OfferMeaning {
    std::string event;        ///< relative to the component, without arguments: "a.in", "moveCall"
    std::string text;         ///< "t1: S1 -> S2", "entry action of S1"
    ir::Origin origin;        ///< place of the transition or the statement
    std::string name = {};    ///< for a transition: "t1"
    std::string target = {};  ///< for a transition: its target
};
/// The meaning of a process definition in the script, which represents a control state of a machine.
struct DefinitionMeaning {
    std::string text;                     ///< "in S1", "in the action of t2"
    std::vector<std::string> parameters;  ///< the variable or clock that each parameter holds, by its RoboChart name;
                                          ///< clocks as "since(T)"
    std::vector<ir::TypeId> types;        ///< type of each parameter; invalid for clocks and counters
    ir::Origin origin;
    std::vector<ir::Origin> deadlines = {};  ///< for each parameter: the deadline that it counts down; the place is
                                             ///< unknown if there is none
    std::vector<ParameterKind> kinds = {};   ///< kind of each parameter
    std::string component = {};              ///< the component that the definition belongs to: "P::C::stm_ref0"
    bool memory = false;                     ///< it holds a variable of a machine whose control state is in another
                                             ///< process
    /// Variables in memory processes whose current values may still be read. The memories of all other variables may
    /// contain old values, because a machine does not store a value that nobody will read.
    std::vector<std::string> remembered = {};
    std::string machine = {};  ///< the machine that runs in the component, qualified by its package: "P::S"
    /// The active states, outermost first. States of called operations follow those of their callers.
    std::vector<ir::Origin> active = {};
    /// The elements of the nodes that running transitions have yet to enter, and of junctions at which the machine is.
    std::vector<std::string> ahead = {};
    /// The inputs and statements that the configuration offers. Definitions share these objects.
    std::vector<std::shared_ptr<const OfferMeaning>> offers = {};
};
/// Describes copies of one component that run together, so that the copy that performs an event can be found.
struct CopiesMeaning {
    std::uint32_t count = 0;
    std::string word;  ///< name of a copy, to which its number is appended, counted from 0: "robot"
    /// Channels whose first field is the number of the copy that acts. The value describes the action; it is "" if the
    /// events of the component describe it already.
    std::map<std::string, std::string> channels;
};

/// The meaning of the script's names. Keys are names as the checker prints them: qualified event names without
/// arguments ("P::S::internal__.P::S::TID_t2", "P::S::seeRobot.in"), qualified definition names ("P::S::S1__").
struct Provenance {
    std::map<std::string, EventMeaning> events;
    std::map<std::string, DefinitionMeaning> definitions;
    std::optional<CopiesMeaning> copies = std::nullopt;  ///< no value: the script has no copies
};

/// A transition of a machine inside a component.
struct TransitionInside {
    std::string component;  ///< the instance of the machine, "P::M::c::s"
    std::string text;       ///< "c::s: t1: S1 -> S2"; "t1: S1 -> S2" if the component itself is the machine
    ir::Origin origin;
};

/// Which transitions of a component can fire? A search of all its states answers this. Assertions cannot, because they
/// would need an event for each transition.
struct FiringQuestion {
    cspm::ExprPtr process;
    std::vector<TransitionInside> transitions;
};

/// Can every reachable state of the process still reach an event of the goal? No refinement can express this, so a
/// backward search answers it (checker/refine/verdict/recurrence.hpp).
struct RecurrenceQuestion {
    cspm::ExprPtr process;
    cspm::ExprPtr goal;  ///< a set of events
};

/// A condition that is checked before a claim can hold. If the condition fails, the claim is undecided.
struct Premise {
    std::vector<cspm::DeclPtr> assertions;  ///< members of the script; all of them must hold
    RecurrenceQuestion recurrence;          ///< must hold as well
    std::string text;                       ///< "time can always pass"
    std::string otherwise;                  ///< the reason reported if the claim is not decided: "time can stop"
    std::string reason;                     ///< states what is true at the end of a run that violates it
};

/// One check: an assertion of the model in one semantics (as one or more CSPM assertions), an assert line of a CSP
/// block, or a core property.
struct Obligation {
    ir::PropertyKind kind = ir::PropertyKind::deadlock_free;
    bool negated = false;
    std::uint32_t property = ir::no_id;  ///< index into System::properties; ir::no_id for checks of other origins
    std::string component = {};          ///< core properties: "state machine P::S"; "" for others
    std::string property_text = {};      ///< core properties: "deadlock-free"
    bool information = false;            ///< core properties: a negative answer is information, not an error
    ir::Origin origin = {};              ///< core properties: the state or clock; assert lines of blocks: the place of
                                         ///< the line
    std::string title;                   ///< "A1 [timed] AggregationFSM is deadlock-free"
    std::string name = {};               ///< claims of a swarm: as written; others have the name of their property
    Time time = Time::untimed;
    std::vector<cspm::DeclPtr> preparation;        ///< declarations that only these assertions use; also part of the
                                                   ///< script
    std::vector<cspm::DeclPtr> assertions;         ///< members of the script below; empty if no check exists (see
                                                   ///< `reason`)
    std::optional<FiringQuestion> firing;          ///< decided without an assertion: can all of them fire?
    std::optional<RecurrenceQuestion> recurrence;  ///< decided in addition to the assertions: does the event stay
                                                   /// < reachable? RoboSim: a component that stops time is
                                                   /// deadlock-free in RoboTool's sense. If time can stop forever, the
                                                   /// report states this, but the claim still holds.
    std::optional<RecurrenceQuestion> time_goes_on;
    std::shared_ptr<const Premise> premise;  ///< premise of the answer "holds"; null if there is none. Several
                                             ///< claims may share one
    bool one_suffices = false;  ///< the claim holds if one of the assertions holds; otherwise all must hold
    std::string reason;  ///< the reason why there is no check; or the true statement if the check fails without a
                         ///< single run as evidence
};

/// The processes of a component, with the values of constants that an assertion does not set (semantics 3.12).
struct ComponentProcesses {
    std::string path;          ///< "P::C::stm_ref0"
    cspm::ExprPtr process;     ///< the process D__
    cspm::ExprPtr compressed;  ///< the process O__
};

/// The semantics of a system, untimed or timed: the scripts, the checks to make, and the meaning of names.
struct Emission {
    cspm::Script definitions;  ///< library, instantiations, components
    cspm::Script script;       ///< definitions, CSP blocks and assertions: the script that is checked
    std::vector<Obligation> obligations;
    Provenance provenance;
    std::vector<ComponentProcesses> components;  ///< every component by path, including nested ones
    std::set<std::string> bounded;   ///< functions whose results may be an artefact of the finite instantiation
                                     ///< (clipping.hpp)
    std::set<std::string> captured;  ///< names that are captured by mistake (name_clashes.hpp); nonempty only if the
                                     ///< script is wrong
};

/// Options for the form of the script and for additional assertions.
struct Options {
    bool core_properties = false;  ///< add core properties of each component (core_properties.hpp)
    /// A machine that may have more states than this, estimated from the sizes of its carriers, keeps its largest
    /// variables in separate memory processes.
    double states_of_a_process = 50'000;
    /// If true, each state of the process determines the values of all variables of a machine. So every definition
    /// has all variables as parameters, even those that are no longer read, and no variable is in a memory process.
    /// At a probabilistic junction, also inside operations, the state determines the values that the probabilities
    /// read.
    bool whole_states = false;
    bool share_modules = true;  ///< modules with equal text are written once (shared_modules.hpp)
    bool share_calls = true;    ///< all calls of an operation share one definition; otherwise each call is inlined
};

/// A file to be written: its path relative to the output folder, and its text.
struct OutputFile {
    std::string path;
    std::string text;
};

}  // namespace robochart::csp_emit
