// SPDX-License-Identifier: Apache-2.0
// Defines the shared intermediate representation: a RoboChart model in normal form. References are resolved, names are
// indices, expressions are typed, and actions are small structured programs. The back ends csp_emit and cpp_emit read
// only this representation. It contains no CSP and no C++.
//
// Conventions: every *Id is an index into the vector that its comment names. If this is a vector of Machine, it belongs
// to the enclosing machine, unless stated otherwise. An Origin gives the place in the model text, for reports.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/source.hpp"

namespace robochart::ir {

inline constexpr std::uint32_t no_id = 0xffffffffU;

/// An index. Each kind of element has a separate type of index. `is_valid()` is false for a default-constructed index.
template <class Tag>
struct Id {
    std::uint32_t index = no_id;
    [[nodiscard]] bool is_valid() const { return index != no_id; }
    friend auto operator<=>(const Id&, const Id&) = default;
};
using TypeId = Id<struct TypeTag>;              ///< System::types
using FunctionId = Id<struct FunctionTag>;      ///< System::functions
using MachineId = Id<struct MachineTag>;        ///< System::machines
using ControllerId = Id<struct ControllerTag>;  ///< System::controllers
using VariableId = Id<struct VariableTag>;      ///< Machine::variables (parameters included)
using ConstantId = Id<struct ConstantTag>;      ///< Machine::constants
using EventId = Id<struct EventTag>;            ///< Machine::events
using ClockId = Id<struct ClockTag>;            ///< Machine::clocks
using OperationId = Id<struct OperationTag>;    ///< Machine::operations
using NodeId = Id<struct NodeTag>;              ///< Machine::nodes
using TransitionId = Id<struct TransitionTag>;  ///< Machine::transitions

/// The ids of the core types, which every System interns first.
inline constexpr TypeId boolean_type{0};
inline constexpr TypeId nat_type{1};
inline constexpr TypeId integer_type{2};
inline constexpr TypeId real_type{3};
inline constexpr TypeId string_type{4};

/// The element of the model from which a part of the IR was made: its qualified RoboChart name and its place.
struct Origin {
    std::string element;  ///< e.g. "AggregationFSM::S1", "AggregationFSM::t2"
    diagnostics::Span span;
};

// ---------------------------------------------------------------- types and values

/// The forms of types.
enum class TypeKind {
    boolean,
    nat,
    integer,
    real,
    string,
    enumeration,
    given,
    sequence,
    set,
    product,
    record,
    function,
    relation,
    vector,
    matrix,
    unit
};

/// Returns true for sets, and for relations and functions, which are sets of pairs.
[[nodiscard]] constexpr bool is_set_like(TypeKind kind) {
    return kind == TypeKind::set || kind == TypeKind::relation || kind == TypeKind::function;
}

/// A type. Equal types have the same TypeId.
struct Type {
    TypeKind kind = TypeKind::unit;
    std::string name;                               ///< RoboChart name ("nat", "Light"); composed types: as written
    std::string package;                            ///< declared types: package, "" if unnamed
    std::vector<TypeId> args;                       ///< operand types; record: field types
    std::vector<std::string> labels;                ///< enumeration: literals; record: field names
    std::vector<std::vector<TypeId>> literal_args;  ///< enumeration: argument types of each literal
    std::vector<std::int64_t> sizes;                ///< vector {n}, matrix {rows, columns}
    std::string values_of;           ///< classes of values (semantics/data): the type of the values; otherwise empty
    std::vector<std::string> shown;  ///< classes of values: a value of each class; otherwise empty
    Origin origin;
};

/// An exact decimal: unscaled * 10^-decimals. Reals of the model are never converted to binary floating point.
struct Decimal {
    std::int64_t unscaled = 0;
    std::uint32_t decimals = 0;
};

// ---------------------------------------------------------------- expressions

/// The forms of expressions, with the fields of Expr that each uses.
enum class ExprKind {
    boolean,        ///< number: 0/1
    integer,        ///< number
    real,           ///< decimal
    string,         ///< characters
    enum_literal,   ///< type, number: literal index, args: its arguments
    variable,       ///< variable
    trigger_value,  ///< the value just received by the transition's trigger (replaces the trigger's variable in its
                    ///< guard)
    constant,       ///< constant
    since,          ///< clock: time since its reset
    since_entry,    ///< node: time since it was entered (Machine::clocks has a clock for it)
    negate,
    logical_not,
    iff,
    implies,
    disjunction,
    conjunction,
    equal,
    not_equal,
    greater,
    greater_equal,
    less,
    less_equal,
    plus,
    minus,
    times,
    divide,
    modulus,
    if_then_else,
    call,            ///< function(args)
    function_value,  ///< function: a function of the model used as a value
    apply,           ///< args[0] applied to args[1..]: a value of function type
    tuple,
    record,
    sequence,
    set,     ///< args (record: one per field, in the order of the type)
    matrix,  ///< args row by row, number: columns (one column: a vector)
    member,  ///< args[0], number: field index (records) or 1-based position (tuples)
    index,   ///< args[0][args[1]..], 1-based
    concat,
    is_in,
    set_range,
    cast,   ///< args[0] as `type`: nat or int to real multiplies by the scale, real to nat or int rounds down
    bound,  ///< variable bound by an enclosing quantifier/let/lambda/comprehension: text
    forall,
    exists,
    exists_unique,
    lambda,
    the,
    set_comprehension,  ///< bound_names, bound_types; args: predicate, body
    let,                ///< bound_names[i] is args[i]; the last of args is the body
    toolkit,  ///< a function of the toolkit libraries, text: its name as "set_toolkit_union"; bound_types: the types of
              ///< the type variables of its signature, in order of first occurrence
    is_type,  ///< true if args[0] is a value of bound_types[0]
    range,    ///< the numbers from args[0] to args[1]; number: 1 without the lower bound, 2 without the upper, 3 both
    transpose,  ///< the transpose of the matrix or vector args[0]
};

struct Expr;
using ExprPtr = std::shared_ptr<const Expr>;

/// A typed expression.
struct Expr {
    ExprKind kind = ExprKind::integer;
    TypeId type;
    std::int64_t number = 0;
    Decimal decimal;
    std::string text;
    diagnostics::ForeignText characters;
    VariableId variable;
    ConstantId constant;
    ClockId clock;
    NodeId node;
    FunctionId function;
    std::vector<ExprPtr> args;
    std::vector<std::string> bound_names;
    std::vector<TypeId> bound_types;
    diagnostics::Span span;
};

// ---------------------------------------------------------------- programs

/// The forms of communication.
enum class CommKind { simple, input, output, sync };  ///< e, e?x, e!v, e.v

/// In a trigger, `e` and `e?x` receive (CSP direction `.in`). In a statement, `e`, `e!v` and `e.v` send (`.out`), and
/// `e?x` receives.
struct Communication {
    CommKind kind = CommKind::simple;
    EventId event;
    VariableId variable;  ///< input: where the value is stored
    ExprPtr value;        ///< output, sync
    ExprPtr predicate;    ///< optional condition on the value
};

/// The forms of statements.
enum class StmtKind {
    skip,
    sequence,
    if_then_else,
    assign,
    communicate,
    call,
    wait,
    wait_interval,
    clock_reset,
    deadline,
    exec,   ///< RoboSim: ends the cycle
    choose  ///< only in models that semantics/data makes; no code is generated from these models
};

struct Stmt;
using StmtPtr = std::shared_ptr<const Stmt>;

/// A statement of a structured program. `point` is its number among the statements of the machine, which are numbered
/// from 0 without gaps.
struct Stmt {
    StmtKind kind = StmtKind::skip;
    std::uint32_t point = 0;
    /// sequence: all statements; if: then, else (else may be skip); deadline: one statement; choose: the alternatives
    /// of an internal choice. A choice without alternatives blocks the thread forever.
    std::vector<StmtPtr> body;
    ExprPtr condition;          ///< if
    VariableId variable;        ///< assign: the variable
    std::vector<ExprPtr> path;  ///< assign: member/index steps below it (literal field index, or index expression)
    ExprPtr value;              ///< assign right side; wait duration; deadline bound; interval lower bound
    ExprPtr upper;              ///< wait_interval upper bound
    Communication communication;
    OperationId operation;      ///< call
    std::vector<ExprPtr> args;  ///< call
    ClockId clock;              ///< clock_reset
    Origin origin;
};

// ---------------------------------------------------------------- machines

/// The scope of a variable: which component declares it and which may write it.
enum class VariableScope {
    local,      ///< declared by the machine, private to it
    required,   ///< declared by a required interface and shared; the machine has a copy (semantics 3.7)
    parameter,  ///< a parameter of an operation; read-only
    reg,        ///< RoboSim: a register of the input or output context; its name begins with `$`
};

/// A variable of a machine, a controller or a platform. Parameters of operations are variables, too.
struct Variable {
    std::string name;
    TypeId type;
    VariableScope scope = VariableScope::local;
    ExprPtr initial;        ///< null: the type's default (booleans default to true)
    std::string interface;  ///< name of the interface that declares it; "" if the machine declares it
    Origin origin;
    bool output = false;  ///< RoboSim: a variable of the output context, which assignments write
};

/// A constant of a machine, a controller or a platform.
struct Constant {
    std::string name;
    TypeId type;
    ExprPtr value;  ///< null: taken from the instantiation
    /// True if a required interface declares the constant. The constant then has the value of its provider
    /// (semantics/ir/query.hpp).
    bool required = false;
    std::string interface;
    Origin origin;
};

/// A named input or output of a component.
struct Event {
    std::string name;
    std::optional<TypeId> type;  ///< no value: the event carries no value
    bool input =
        false;  ///< used in a trigger or an input statement; controllers, platforms: connected into the software
    bool output = false;  ///< used in an output statement; controllers, platforms: connected out of the software
    bool broadcast = false;
    std::string interface;
    Origin origin;
};

/// A clock of a machine. It counts the time units since its last reset, or since a state was entered.
struct Clock {
    std::string name;       ///< the name; for the clock of sinceEntry(S), the path of S joined by '_'
    NodeId entry_of;        ///< valid: the clock of sinceEntry(node)
    bool required = false;  ///< only in operations: declared by a required interface; it is the caller's clock
    std::string interface;
    Origin origin;
};

/// An operation that a machine calls. The definition of the operation depends on the context of the machine (a
/// controller, a module, or no context). MachineInstance::definitions contains the definition.
struct OperationSignature {
    std::string name;
    std::vector<std::string> parameter_names;
    std::vector<TypeId> parameters;
    bool terminates = false;
    std::string interface;
    Origin origin;
    bool output = false;  ///< RoboSim: an operation of the output context, which the platform performs
};

/// RoboSim: an input of a machine or operation. Each cycle reads it at the beginning.
struct Input {
    std::string name;    ///< the name of the event or variable
    VariableId full;     ///< the Boolean that is true if the register of an event is full; invalid for a variable
    VariableId content;  ///< the value of the register; invalid for an event without a type
    Origin origin;
};

/// The name of the constant that holds the length of the cycles of a RoboSim component. No element of a model can have
/// this name.
inline constexpr const char* cycle_length = "cycle length";

/// The kinds of nodes of a machine.
enum class NodeKind { state, initial, junction, probabilistic, final };

/// A state, junction or final state of a machine.
struct Node {
    NodeKind kind = NodeKind::state;
    std::string name;
    std::string path;                    ///< names from the machine's top, joined by "::"
    NodeId parent;                       ///< the enclosing composite state; invalid at top level
    std::vector<NodeId> children;        ///< composite: all inner nodes in textual order
    NodeId initial;                      ///< composite: its initial node
    StmtPtr entry, during, exit;         ///< null if absent
    std::vector<TransitionId> outgoing;  ///< in textual order
    Origin origin;

    [[nodiscard]] bool is_composite() const { return !children.empty(); }
};

/// A transition between two nodes of one machine.
struct Transition {
    std::string name;
    NodeId source, target;
    std::optional<Communication> trigger;
    std::vector<ClockId> resets;
    ExprPtr guard;  ///< null: true. `condition else` is already the negation of the other conditions
    /// True if the guard contains since or sinceEntry. The untimed semantics then uses a weaker guard
    /// (untimed_guards.hpp).
    bool guard_timed = false;
    ExprPtr deadline;
    ExprPtr probability;
    StmtPtr action;  ///< null if none
    Origin origin;
    bool exec = false;            ///< RoboSim: the transition ends the cycle
    std::vector<StmtPtr> stores;  ///< RoboSim: the assignments of `$e?v` in the condition, in textual order
};

/// A defined operation is a machine, too.
enum class MachineKind { state_machine, operation };

/// A state machine or a defined operation, independent of the controllers that contain it and of the machines that call
/// it.
struct Machine {
    MachineKind kind = MachineKind::state_machine;
    std::string name;
    std::string package;  ///< "" if unnamed
    std::string path;     ///< path from the outside: "S"; if it is declared inside a controller, "C::S" or "M::C::S"
    std::vector<Variable> variables;  ///< operations: parameters first
    std::vector<Constant> constants;
    std::vector<Event> events;
    std::vector<Clock> clocks;
    /// Operations that the machine requires and may call, in textual order.
    std::vector<OperationSignature> operations;
    std::vector<Node> nodes;
    std::vector<NodeId> top;  ///< top-level nodes in textual order
    NodeId initial;           ///< invalid: no body
    std::vector<Transition> transitions;
    std::vector<ExprPtr> preconditions, postconditions;  ///< operations
    bool terminates = false;                             ///< operation declared `terminates`
    std::vector<std::string> interfaces;                 ///< interfaces used and required, in textual order
    std::uint32_t points = 0;                            ///< number of Stmt::point values
    Origin origin;
    bool robosim = false;       ///< it runs in cycles; its constants include cycle_length
    std::vector<Input> inputs;  ///< RoboSim: the input context
};

// ---------------------------------------------------------------- composition

/// A machine in the context in which it runs.
struct MachineInstance {
    std::string name;  ///< the name of the reference (`sref stm0 = S`) or of the inline machine
    MachineId machine;
    /// For each entry of Machine::operations: the definition in this context. An invalid id means a call of the
    /// platform.
    std::vector<MachineId> definitions;
    Origin origin;
};

enum class EndKind { self, part };  ///< `self`: the controller, or the module's platform

/// One end of a connection: an event of the container or of one of its components.
struct ConnectionEnd {
    EndKind kind = EndKind::self;
    std::uint32_t part = no_id;  ///< controller: index of machines; module: index of controllers
    std::string event;
};

/// A connection of a controller or a module.
struct Connection {
    ConnectionEnd from, to;
    bool async = false;
    bool multiple = false;
    Origin origin;
};

/// Machines in parallel, with their connections and the operations that they call.
struct Controller {
    std::string name;
    std::string package;
    std::string path;                 ///< path from the outside: "C"; if it is declared inside a module, "M::C"
    std::vector<Variable> variables;  ///< own variables (scope local) and required ones
    std::vector<Constant> constants;
    std::vector<Event> events;
    std::vector<OperationSignature> operations;  ///< required but not defined here: calls of them leave the controller
    std::vector<MachineId> definitions;          ///< operations defined here (inline or by opref)
    std::vector<std::string>
        definition_names;  ///< names of the references (`opref move_ref = Move`), or names of inline definitions
    std::vector<MachineInstance> machines;
    std::vector<Connection> connections;
    std::vector<std::string> interfaces;
    Origin origin;
    bool robosim = false;  ///< it runs in cycles; its constants include cycle_length
};

/// A controller in the module in which it runs.
struct ControllerInstance {
    std::string name;
    ControllerId controller;
    Origin origin;
};

/// The robotic platform of a module, with the members that it provides.
struct Platform {
    std::string name;
    std::vector<Variable>
        variables;  ///< provided, local and used; scope `required` if provided (visible), `local` otherwise
    std::vector<Constant> constants;
    std::vector<Event> events;
    std::vector<OperationSignature> operations;
    std::vector<std::string> interfaces;
    Origin origin;
};

/// A platform with controllers in parallel.
struct Module {
    std::string name;
    std::string package;
    Platform platform;
    std::vector<ControllerInstance> controllers;
    std::vector<Connection> connections;
    Origin origin;
    bool robosim = false;  ///< it runs in cycles; the constants of its platform include cycle_length
};

/// A function that the model uses. Only its contract specifies the function. `parameter_names` are bound in the
/// conditions, and `result` is bound in the postconditions. The postconditions define the result: it is the default
/// value of the result type if this value satisfies them. Otherwise it is the least value of the carrier that satisfies
/// them (rule RC-S20).
struct Function {
    std::string name;
    std::string package;
    std::vector<std::string> parameter_names;
    std::vector<TypeId> parameters;
    TypeId result;
    std::vector<ExprPtr> preconditions;
    std::vector<ExprPtr> postconditions;
    Origin origin;
};

// ---------------------------------------------------------------- properties (from .assertions)

/// The kind of component that an assertion names. A CSP block defines a `process`, and RoboSim has the kind
/// `simulation`.
enum class ComponentKind { module, controller, machine, operation, simulation, process };

/// A component named in an assertion, with references resolved.
struct ComponentRef {
    ComponentKind kind = ComponentKind::process;
    /// The path of the CSP module without the package ("M::ctrl_ref0::stm_ref0", "S", "OP_move"). For a process, the
    /// name in the assertion.
    std::string path;
    std::string package;               ///< "" if unnamed
    std::uint32_t definition = no_id;  ///< index into System::modules, controllers, machines, simulations or csp_blocks
};

/// The forms of assertions.
enum class PropertyKind {
    deadlock_free,
    divergence_free,
    deterministic,
    timelock_free,
    terminates,
    refines,
    equals,
    reachable,
    clock_initialised,
    event_missed,
    conforms,     ///< the component conforms to a SLEEC rule in another file
    schedulable,  ///< RoboSim: the assumptions of a simulation never block an output of its component
};
/// The semantic model of CSP in which a property is decided.
enum class PropertyModel { failures_divergences, traces, failures, tick_tock };

/// An assertion of the model, with its components resolved.
struct Property {
    std::string name;
    PropertyKind kind = PropertyKind::deadlock_free;
    bool negated = false;
    bool timed = true;    ///< decided in the timed semantics
    bool untimed = true;  ///< decided in the untimed semantics
    PropertyModel model = PropertyModel::failures_divergences;
    ComponentRef subject;
    ComponentRef other;  ///< refines, equals
    /// For `reachable`: the CSP path of the state below the subject ("S1", "C::Inner"). For `clock_initialised`: the
    /// clock. For `event_missed`: the state of the subject, or "" for the whole machine.
    std::string state;
    std::string event;            ///< event_missed
    std::string rule;             ///< conforms: the name of the rule
    std::int64_t time_units = 1;  ///< event_missed: the number of consecutive time units
    /// For `with constant c of X set to e`: the name of the constant as in query.hpp, and its value. For a required
    /// constant, this is the name of the provider's constant, because the provider determines the value. For `with
    /// parameter p of O`, the name begins with "param_" instead of "const_".
    std::vector<std::pair<std::string, ExprPtr>> constants;
    std::string file;     ///< path of the .assertions file
    std::string wording;  ///< the source text of the assertion, on one line
    Origin origin;
};

/// RoboSim: a RoboChart component that runs in cycles (docs/robosim.md).
struct Simulation {
    std::string name;
    ComponentRef subject;
    Constant cycle;                            ///< cycle_length
    std::vector<std::string> inputs, outputs;  ///< the names in the contexts of a machine
    Origin origin;
};

/// A block of CSPM text in an .assertions file.
struct CspBlock {
    std::string name;
    bool timed = true, untimed = true;
    std::vector<ComponentRef> associated;
    std::string text;
    diagnostics::Span text_span;  ///< the place of `text`, so that CSPM diagnostics point into the .assertions file
    std::string file;
};

/// The whole project.
struct System {
    std::vector<Type> types;
    std::vector<Function> functions;
    std::vector<Machine> machines;  ///< state machines and operations, in textual order of files sorted by path
    std::vector<Controller> controllers;
    std::vector<Module> modules;
    std::vector<Property> properties;  ///< in the order of the paths of their files, then in textual order
    std::vector<CspBlock> csp_blocks;
    std::vector<Simulation> simulations;  ///< RoboSim, by the paths of their files, then in textual order

    [[nodiscard]] const Type& type(TypeId id) const { return types[id.index]; }
    [[nodiscard]] const Machine& machine(MachineId id) const { return machines[id.index]; }
    [[nodiscard]] const Controller& controller(ControllerId id) const { return controllers[id.index]; }
};

}  // namespace robochart::ir
