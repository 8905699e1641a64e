// What is emitted, and what it means: the script, what is to be checked of it, and what its names stand for in the
// model.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "diagnostics/diagnostic.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// Which of the two semantics: each has a script of its own.
enum class Time { untimed, timed };

/// What a name in the script means to the reader of the model.
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
    memory,  ///< a value is read from the process that holds its variable, or stored there: part of the step before
    tock,
    refusal,  ///< tick-tock: its argument is the event that is refused
};
/// What a transition that leaves a probabilistic junction is weighed by.
struct Draw {
    std::string junction;   ///< which of the machine's, with the operation that it is in: "Turn_p0"
    ir::MachineId machine;  ///< that has the transition
    ir::TransitionId transition;
    std::vector<std::string> variables;  ///< of that machine, by VariableId: what holds them among the parameters of
                                         ///< definitions
};
/// An event of the script in terms of the model.
struct EventMeaning {
    MeaningKind kind = MeaningKind::step;
    std::string text;               ///< for people: "S1 -> S2 on seeRobot", "call MoveClockwise"
    std::vector<ir::TypeId> types;  ///< of the event's arguments, in order; empty if it has none
    ir::Origin origin;
    std::string component = {};             ///< whose event it is: "P::C::stm_ref0"; "" if no component's
    std::shared_ptr<const Draw> draw = {};  ///< of a transition that leaves a probabilistic junction; else null
};
/// What a parameter of a definition holds.
enum class ParameterKind {
    variable,  ///< of the machine, or of an operation that is being called
    clock,     ///< time since its reset
    constant,
    countdown,  ///< time left of a wait or a deadline
    temporary,  ///< a value that has been read or received and is not used up yet
};
/// An event that a configuration may offer, and the element of the model that it comes from.
struct OfferMeaning {
    std::string event;        ///< relative to the component, without arguments: "a.in", "moveCall"
    std::string text;         ///< "t1: S1 -> S2", "entry action of S1"
    ir::Origin origin;        ///< of the transition or the statement
    std::string name = {};    ///< of a transition: "t1"
    std::string target = {};  ///< of a transition: the element that it leads to
};
/// A process definition of the script: the control state of a machine in it.
struct DefinitionMeaning {
    std::string text;  ///< "in S1", "in the action of t2"
    std::vector<std::string>
        parameters;                 ///< variable or clock of each parameter, RoboChart names; clocks as "since(T)"
    std::vector<ir::TypeId> types;  ///< type of each; invalid for clocks and counters
    ir::Origin origin;
    std::vector<ir::Origin> deadlines = {};  ///< of each: the deadline that it counts down; without a place: none
    std::vector<ParameterKind> kinds = {};   ///< of each parameter
    std::string component = {};              ///< whose definition it is: "P::C::stm_ref0"
    bool memory = false;                     ///< it holds a variable beside the process that says where the machine is
    /// Of the variables that processes beside it hold: those whose value there something still reads. Such a process
    /// may hold an old value of the others, since a value that nothing reads is not stored.
    std::vector<std::string> remembered = {};
    std::string machine = {};  ///< the machine that runs there, qualified by its package: "P::S"
    /// The active states, outermost first, those of operations that are being called behind those of their callers.
    std::vector<ir::Origin> active = {};
    /// Of its triggers and of the statements that are to be done next; definitions share them.
    std::vector<std::shared_ptr<const OfferMeaning>> offers = {};
};
/// Keys are names as the checker prints them: qualified event name without arguments
/// ("P::S::internal__.P::S::TID_t2", "P::S::seeRobot.in"), qualified definition name ("P::S::S1__").
/// Copies of one component that run together: which of them an event is of.
struct CopiesMeaning {
    std::uint32_t count = 0;
    std::string word;  ///< what each is called, with its number from 0 on behind it: "robot"
    /// Channels whose first field is the number of the copy that acts, with what it does in words where the events of
    /// the component do not say it; "": nothing worth saying.
    std::map<std::string, std::string> channels;
};

struct Provenance {
    std::map<std::string, EventMeaning> events;
    std::map<std::string, DefinitionMeaning> definitions;
    std::optional<CopiesMeaning> copies = std::nullopt;  ///< none: the script has no copies
};

/// A transition of a machine inside a component.
struct TransitionInside {
    std::string component;  ///< the instance of the machine, "P::M::c::s"
    std::string text;       ///< "c::s: t1: S1 -> S2", or "t1: S1 -> S2" of the component's own
    ir::Origin origin;
};

/// The question which transitions of a component fire: an assertion for each would need an event for each, so all
/// states of the process are visited instead.
struct FiringQuestion {
    cspm::ExprPtr process;
    std::vector<TransitionInside> transitions;
};

/// The question whether from each state that the process reaches it can come to an event of the goal: decided by a
/// search backwards (checker/refine/verdict/recurrence.hpp), as no refinement says it.
struct RecurrenceQuestion {
    cspm::ExprPtr process;
    cspm::ExprPtr goal;  ///< a set of events
};

/// What has to be so before a claim is answered with "holds". Where it is not, the claim is not decided.
struct Premise {
    std::vector<cspm::DeclPtr> assertions;  ///< members of the script; all have to hold
    RecurrenceQuestion recurrence;          ///< and this
    std::string text;                       ///< "time can always pass"
    std::string otherwise;                  ///< why the claim is not decided: "time can stop"
    std::string reason;                     ///< what is so where the run ends that shows it
};

/// One check to be made: an assertion of the model in one time as one or more CSPM assertions, an assert line of a CSP
/// block, or a core property.
struct Obligation {
    ir::PropertyKind kind = ir::PropertyKind::deadlock_free;
    bool negated = false;
    std::uint32_t property = ir::no_id;  ///< index into System::properties; none for others
    std::string component = {};          ///< core properties: "state machine P::S"; "" for others
    std::string property_text = {};      ///< core properties: "deadlock-free"
    bool information = false;            ///< core properties: nothing is wrong where it does not hold
    ir::Origin origin = {};              ///< core properties: the state or clock; of a block's assert line: its place
    std::string title;                   ///< "A1 [timed] AggregationFSM is deadlock-free"
    std::string name = {};               ///< claims of a swarm: as written; others have their property's
    Time time = Time::untimed;
    std::vector<cspm::DeclPtr> preparation;        ///< what the assertions mention and no other does; in the script too
    std::vector<cspm::DeclPtr> assertions;         ///< members of the script below; empty: no check exists (`reason`)
    std::optional<FiringQuestion> firing;          ///< decided without an assertion: whether all of these fire
    std::optional<RecurrenceQuestion> recurrence;  ///< decided beside the assertions: whether it can always come again
    std::shared_ptr<const Premise> premise;        ///< of "holds"; null: none. Several claims may share one
    bool one_suffices = false;  ///< the claim holds if one of the assertions does; else all must hold
    std::string reason;         ///< why there is no check; else what is so if it fails and no single run shows it
};

/// A component's processes with the values that an assertion without others takes (semantics 3.12).
struct ComponentProcesses {
    std::string path;          ///< "P::C::stm_ref0"
    cspm::ExprPtr process;     ///< its D__
    cspm::ExprPtr compressed;  ///< its O__
};

/// The semantics of a system in one time: scripts, what is to be checked, what names mean.
struct Emission {
    cspm::Script definitions;  ///< library, instantiations, components
    cspm::Script script;       ///< definitions, the CSP blocks, the assertions: what is checked
    std::vector<Obligation> obligations;
    Provenance provenance;
    std::vector<ComponentProcesses> components;  ///< every one, nested ones too, by path
    std::set<std::string> bounded;   ///< functions whose value the finite instantiation may choose (clipping.hpp)
    std::set<std::string> captured;  ///< always empty, or the script is wrong (name_clashes.hpp)
};

/// How the script is written, and whether assertions are added to those of the model.
struct Options {
    bool core_properties = false;  ///< add them for each component (core_properties.hpp)
    /// A machine that may have more states than this, by the sizes of its carriers, keeps its largest variables in
    /// memory processes of their own.
    double states_of_a_process = 50'000;
    /// A machine's variables are parameters wherever it is, also where nothing reads them any more, and none is in a
    /// memory: a state of the process tells all of them. At a probabilistic junction, also of an operation, it tells
    /// what the probabilities read.
    bool whole_states = false;
    bool share_modules = true;  ///< modules of equal text are written once (shared_modules.hpp)
    bool share_calls = true;    ///< one definition of an operation for its calls; otherwise each call is inlined
};

/// A file to be written: path relative to the output folder, and its text.
struct OutputFile {
    std::string path;
    std::string text;
};

}  // namespace robochart::csp_emit
