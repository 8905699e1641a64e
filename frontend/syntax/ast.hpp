// SPDX-License-Identifier: Apache-2.0
// Defines the syntax tree of RoboChart text (`.rct`) and assertion text (`.assertions`), after the public grammars
// RoboChart.xtext and Assertions.xtext. The tree also represents their RoboSim dialect (`.rst`, `.rsa`), after
// RoboSim.xtext. The parser fills the syntactic fields. Name resolution fills `target`s and typing fills `type`s
// ("filled by resolve" and "filled by typing" below).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/source.hpp"
#include "frontend/syntax/dialect.hpp"

namespace robochart::frontend {

using diagnostics::Span;

struct Type;
using TypePtr = std::shared_ptr<const Type>;  ///< semantic type, frontend/types/types.hpp
struct Declaration;

/// `A::B::C` with the place of each part.
struct QualifiedName {
    std::vector<std::string> parts;
    std::vector<Span> spans;
    Span span;

    [[nodiscard]] bool empty() const { return parts.empty(); }
    [[nodiscard]] std::string text() const;  ///< joined by "::"
};

// ---------------------------------------------------------------- types as written

/// The forms of types in the source text.
enum class TypeKind {
    name,      ///< qualified name; `target` is a TypeDeclaration or a built-in
    variable,  ///< ?X
    sequence,  ///< Seq(T)
    set,       ///< Set(T)
    product,   ///< A * B * C
    function,  ///< A -> B
    relation,  ///< A <-> B
    vector,    ///< vector(T, n)
    matrix,    ///< matrix(T, r, c)
};

struct Expr;
using ExprPtr = std::unique_ptr<Expr>;

/// A type in the source text.
struct TypeExpr {
    TypeKind kind = TypeKind::name;
    Span span;
    QualifiedName name;                           ///< the name, for the kinds `name` and `variable`
    std::vector<std::unique_ptr<TypeExpr>> args;  ///< operand types in order
    std::vector<ExprPtr> sizes;                   ///< vector: 1, matrix: 2
    const Declaration* target = nullptr;          ///< filled by resolve
    TypePtr type;                                 ///< filled by typing
};
using TypeExprPtr = std::unique_ptr<TypeExpr>;

// ---------------------------------------------------------------- expressions

/// The forms of expressions.
enum class ExprKind {
    integer,
    real,
    string,
    boolean,  ///< literal: `text` as written
    name,     ///< `name`; target: Variable, EnumLiteral, Parameter, Constant, bound variable
    result,
    to,
    from,          ///< `result`; `to` / `from` (broadcast ids)
    unary,         ///< op neg, not; args[0]
    binary,        ///< args[0] op args[1]
    if_then_else,  ///< args[0..2]
    let,           ///< bindings, args[0] body
    forall,
    exists,
    exists_unique,
    lambda,
    the,  ///< bindings (typed), args[0] optional predicate, args[1] body (may be null for `the` without @)
    cast,
    is_type,  ///< args[0], type_expr
    member,   ///< args[0] . text
    index,    ///< args[0] [ args[1..] ]
    call,     ///< name ( args )     target: Function, EnumLiteral; or args via callee expr in `callee`
    tuple,    ///< (| args |)
    record,   ///< R (| field = e ... |): name, bindings (name/value)
    sequence,
    set,                ///< < args >, { args }
    set_range,          ///< { args[0] to args[1] }; in assertions also `by step args[2]`
    set_comprehension,  ///< { bindings | args[0] @ args[1] } ; args[1] may be null
    range,              ///< [a,b] (a,b] ...: args[0], args[1], lower_closed, upper_closed
    matrix,             ///< [| a, b ; c, d |]: args row by row, columns
    inverse,
    transpose,
    since,          ///< since(name): Clock
    since_entry,    ///< sinceEntry(name): State
    parenthesised,  ///< ( args[0] ) kept for the printer
    register_,  ///< RoboSim: `$n`, or `$e?v : p`: name; args empty, or args[0] v (a name or `$x`), args[1] p or null
    cycle,      ///< RoboSim: `cycle`, the length of a cycle
    // The kinds up to `simulation` occur only in probabilistic assertions.
    path,  ///< path formula: `path`; args[0] optional bound on the steps with its relation `text`, otherwise operands
    probability,  ///< Prob `text` args[1] of [args[0]]; without args[1] a query (`=?`); args[2] optional simulation
    reward,       ///< Reward {name} `text` args[1] of [args[0]]; args[1] and args[2] as for Prob
    all_paths,
    some_path,   ///< Forall [args[0]], Exists [args[0]]
    in_state,    ///< name is in args[0]
    event,       ///< name.text: `in`, `out`; `in.val`, `out.val`
    marked,      ///< a name after the sign `text`: $formula, #label, &function, @variable of a module, $$parameter
    simulation,  ///< sim with `text` at bindings (name/value)
    error,       ///< made by error recovery; causes no further errors
};

/// The operators between two expressions.
enum class BinaryOp {
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
    in,
    plus,
    minus,
    times,
    divide,
    modulus,
    concat,
};
/// The operators before an expression.
enum class UnaryOp { negate, logical_not };

/// The operators of path formulas; the last four are operators of rewards.
enum class PathOp { eventually, globally, next, until, weak_until, release, reachable, linear_time, cumulative, total };

/// `v:T`, `v == e` or `f = e` in quantifiers, let, comprehensions and record literals.
struct Binding;

/// An expression in the source text. Resolution fills in the declarations of its names, and typing fills in its type.
struct Expr {
    ExprKind kind = ExprKind::error;
    Span span;
    std::string text;    ///< the source text of a literal, or the name of a member
    QualifiedName name;  ///< also the field that `text` names, for a member
    std::optional<BinaryOp> binary;
    std::optional<UnaryOp> unary;
    std::optional<PathOp> path;
    std::vector<ExprPtr> args;  ///< may contain nulls for optional parts
    ExprPtr callee;             ///< call of an expression that is not a plain name
    std::vector<Binding> bindings;
    TypeExprPtr type_expr;     ///< cast, is_type
    bool lower_closed = true;  ///< range
    bool upper_closed = true;
    std::size_t columns = 0;   ///< matrix
    std::uint32_t height = 1;  ///< the height of this tree; the parser limits it, so recursion is safe

    const Declaration* target = nullptr;  ///< filled by resolve
    TypePtr type;                         ///< filled by typing; null if it could not be computed
};

// ---------------------------------------------------------------- statements and communications

/// The forms of communication.
enum class CommKind { simple, input, output, sync };  ///< e, e?x, e!v, e.v

/// A communication of a trigger or a statement.
struct Communication {
    CommKind kind = CommKind::simple;
    Span span;
    bool through_register = false;  ///< RoboSim: written `$e`
    QualifiedName event;
    QualifiedName variable;                        ///< input: the variable that stores the value
    ExprPtr value;                                 ///< output, sync
    QualifiedName from_variable;                   ///< [| x = from ... |]
    ExprPtr predicate;                             ///< [| pred |]
    const Declaration* event_target = nullptr;     ///< filled by resolve: Event
    const Declaration* variable_target = nullptr;  ///< filled by resolve: Variable
    const Declaration* from_target = nullptr;      ///< filled by resolve: Variable of `from_variable`
};

/// The forms of statements.
enum class StmtKind {
    skip,
    sequence,
    if_then_else,
    assignment,
    communication,
    call,
    wait,
    wait_interval,
    clock_reset,
    deadline,
    parenthesised,
    exec,  ///< RoboSim: ends the cycle
    error
};

struct Stmt;
using StmtPtr = std::unique_ptr<Stmt>;

/// A statement in the source text.
struct Stmt {
    StmtKind kind = StmtKind::error;
    Span span;
    std::vector<StmtPtr> body;  ///< sequence: all; if: then [, else]; deadline, parenthesised: one
    ExprPtr condition;          ///< if
    ExprPtr target;             ///< assignment left side: name, member or index expression
    ExprPtr value;              ///< assignment right side; wait duration; deadline bound
    ExprPtr upper;              ///< wait([value, upper])
    std::unique_ptr<Communication> communication;
    bool send_keyword = false;
    bool through_register = false;             ///< RoboSim: a call written `$op(args)`
    QualifiedName name;                        ///< call: operation; clock_reset: clock
    std::vector<ExprPtr> args;                 ///< call
    const Declaration* declaration = nullptr;  ///< filled by resolve: OperationSignature or Clock
};

// ---------------------------------------------------------------- declarations

/// The kind of a declaration.
enum class DeclKind {
    package,
    primitive_type,  ///< `type X` and the built-ins of core
    record_type,
    field,
    enumeration,
    enum_literal,
    function,
    operation_signature,
    parameter,
    variable,
    constant,
    event,
    clock,
    interface,
    platform,
    operation,
    state_machine,
    controller,
    module,
    reference,  ///< rref, cref, sref, opref
    connection,
    state,
    initial,
    final,
    junction,
    probabilistic,
    transition,
    bound_variable,  ///< bound by a quantifier, let, lambda or comprehension
    input_context,   ///< RoboSim: the inputs of a machine, operation or simulation
    output_context,  ///< RoboSim: the outputs of a machine, operation or simulation
    simulation,      ///< RoboSim: a RoboChart component run in cycles
};

/// The common fields of everything that has a name and that other elements can refer to.
struct Declaration {
    explicit Declaration(DeclKind k) : kind(k) {}
    virtual ~Declaration() = default;
    Declaration(const Declaration&) = delete;
    Declaration& operator=(const Declaration&) = delete;

    DeclKind kind;
    std::string name;
    Span name_span;
    Span span;
    const Declaration* parent = nullptr;  ///< filled by resolve: enclosing declaration; null at package level
    bool broken = false;                  ///< contains a syntax error, so parts may be missing
};

/// A value with a type: field, parameter, variable, constant, bound variable.
struct Variable final : Declaration {
    explicit Variable(DeclKind k) : Declaration(k) {}
    TypeExprPtr type_expr;  ///< null: inferred (let)
    ExprPtr initial;        ///< null if none
    TypePtr type;           ///< filled by typing
};
using VariablePtr = std::unique_ptr<Variable>;

struct Binding {
    VariablePtr variable;  ///< the name and, if written, the type
    ExprPtr value;         ///< let, record literal
};

/// `event e : T`.
struct Event final : Declaration {
    Event() : Declaration(DeclKind::event) {}
    bool broadcast = false;
    TypeExprPtr type_expr;  ///< null: untyped
    TypePtr type;           ///< filled by typing; null if untyped
};

/// `clock C`.
struct Clock final : Declaration {
    Clock() : Declaration(DeclKind::clock) {}
};

/// An operation of an interface, without a body.
struct OperationSignature final : Declaration {
    OperationSignature() : Declaration(DeclKind::operation_signature) {}
    std::vector<VariablePtr> parameters;
    bool terminates = false;
};

/// A literal of an enumeration with the types of its arguments.
struct EnumLiteral final : Declaration {
    EnumLiteral() : Declaration(DeclKind::enum_literal) {}
    std::vector<TypeExprPtr> arguments;
};

/// `type X`, `datatype`/`record`, `enumeration`.
struct TypeDeclaration final : Declaration {
    explicit TypeDeclaration(DeclKind k) : Declaration(k) {}
    std::vector<VariablePtr> fields;                     ///< record_type
    std::vector<std::unique_ptr<EnumLiteral>> literals;  ///< enumeration
    bool record_keyword = false;                         ///< written `record`, not `datatype`
};

/// A function, specified by its contract.
struct Function final : Declaration {
    Function() : Declaration(DeclKind::function) {}
    std::vector<VariablePtr> parameters;
    TypeExprPtr result_expr;
    std::vector<ExprPtr> preconditions;
    std::vector<ExprPtr> postconditions;
    TypePtr result;  ///< filled by typing
};

/// `uses I`, `requires I, J`, `provides I`.
enum class InterfaceUse { uses, requires_, provides };
/// `uses`, `requires` or `provides` with the name of an interface.
struct InterfaceClause {
    InterfaceUse use = InterfaceUse::uses;
    QualifiedName name;
    const Declaration* target = nullptr;  ///< filled by resolve: Context of kind interface
};

struct State;
struct Transition;

/// An element that declares variables, constants, events, clocks or operations, or that uses interfaces: interface,
/// platform, operation, state machine, controller, module.
struct Context : Declaration {
    explicit Context(DeclKind k) : Declaration(k) {}
    Dialect dialect = Dialect::robochart;
    std::vector<InterfaceClause> interfaces;
    std::vector<VariablePtr> variables;  ///< `var` and `const` in textual order, distinguished by kind
    std::vector<std::unique_ptr<Event>> events;
    std::vector<std::unique_ptr<Clock>> clocks;
    std::vector<std::unique_ptr<OperationSignature>> signatures;

    // RoboSim
    ExprPtr cycle;                    ///< `cycleDef e` of a machine, controller, module or simulation; null if none
    std::unique_ptr<Context> input;   ///< machine, operation, simulation of a machine: the input context
    std::unique_ptr<Context> output;  ///< machine, operation, simulation of a machine: the output context
};

/// Nodes and transitions of a machine, operation or composite state.
struct NodeContainer {
    std::vector<std::unique_ptr<State>> nodes;
    std::vector<std::unique_ptr<Transition>> transitions;
};

/// The time at which a state runs an action.
enum class ActionKind { entry, during, exit };
/// An action of a state.
struct Action {
    ActionKind kind = ActionKind::entry;
    Span span;
    StmtPtr statement;
};

/// A state, initial junction, final state, junction or probabilistic junction, distinguished by kind.
struct State final : Declaration, NodeContainer {
    explicit State(DeclKind k) : Declaration(k) {}
    std::vector<Action> actions;  ///< states only
};

/// A transition. It names its source and its target.
struct Transition final : Declaration {
    Transition() : Declaration(DeclKind::transition) {}
    QualifiedName from, to;
    const State* source = nullptr;  ///< filled by resolve
    const State* target = nullptr;  ///< filled by resolve
    std::unique_ptr<Communication> trigger;
    bool exec = false;            ///< RoboSim: the transition ends the cycle
    bool legacy_trigger = false;  ///< `trigger` without event, or with a clock reset inside it
    ExprPtr probability;
    struct Reset {
        QualifiedName name;
        const Declaration* clock = nullptr;  ///< filled by resolve
    };
    std::vector<Reset> resets;
    ExprPtr deadline;  ///< <{ e }
    ExprPtr condition;
    bool otherwise = false;  ///< condition `else`
    StmtPtr action;
};

/// A state machine (`stm`), or an operation with a body. Interfaces and platforms are plain Contexts.
struct Machine final : Context, NodeContainer {
    explicit Machine(DeclKind k) : Context(k) {}
    std::vector<VariablePtr> parameters;  ///< operation
    bool has_body = true;                 ///< operation without nodes: false
    bool terminates = false;
    std::vector<ExprPtr> preconditions;
    std::vector<ExprPtr> postconditions;
};

/// `sref n = S`, `cref`, `rref`, `opref`.
struct Reference final : Declaration {
    Reference() : Declaration(DeclKind::reference) {}
    DeclKind refers_to = DeclKind::state_machine;  ///< platform, controller, state_machine, operation
    QualifiedName target_name;
    const Declaration* target = nullptr;  ///< filled by resolve
};

/// A connection between two components of a controller or module, or between a component and the container.
struct Connection final : Declaration {
    Connection() : Declaration(DeclKind::connection) {}
    struct End {
        QualifiedName node;  ///< name of a component of the container, or of the container itself
        QualifiedName event;
        const Declaration* node_target = nullptr;   ///< filled by resolve
        const Declaration* event_target = nullptr;  ///< filled by resolve
    };
    End from, to;
    bool async = false;
    bool multiple = false;  ///< [mult]
};

/// A controller or module.
struct Component final : Context {
    explicit Component(DeclKind k) : Context(k) {}
    std::vector<std::unique_ptr<Context>> platforms;      ///< module
    std::vector<std::unique_ptr<Component>> controllers;  ///< module
    std::vector<std::unique_ptr<Machine>> machines;       ///< controller (or, wrongly, module)
    std::vector<std::unique_ptr<Machine>> operations;     ///< controller
    std::vector<std::unique_ptr<Reference>> references;
    std::vector<std::unique_ptr<Connection>> connections;
    /// The members of the vectors above (without connections), in textual order.
    std::vector<const Declaration*> order;
};

/// `import p::*` or `import p::X`.
struct Import {
    QualifiedName name;
    bool wildcard = false;
    Span span;
};

// ---------------------------------------------------------------- assertions

/// The forms of assertions.
enum class AssertionKind {
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
    conforms,     ///< the component conforms to a SLEEC rule
    schedulable,  ///< RoboSim: the simulation never blocks an output of its component
};
/// The semantics in which an assertion is decided.
enum class AssertionTime { both, timed, untimed };
/// The semantic model of CSP that an assertion names.
enum class AssertionModel { failures_divergences, traces, failures, tick_tock };

struct CspBlock;

/// The component that a name denotes, as the path of declarations that leads to it. A path to a simulation contains
/// only the simulation. If a step is a reference, the path contains the Reference and not its definition, so that the
/// names of the steps form `M::ctrl_ref::stm_ref`. `Reference::target` leads to the definition.
struct ComponentPath {
    std::vector<const Declaration*> steps;  ///< outermost first; empty: not found, or a CSP process
    const CspBlock* process = nullptr;      ///< the csp block, if the name denotes one
};

/// The kind of element to which an assertion gives a value.
enum class ParameterKind {
    constant,   ///< `constant v of ctx`
    parameter,  ///< `parameter p of op`
    cycle,      ///< RoboSim: `cycleDef of ctx`
};

/// A value that an assertion gives to a constant, to a parameter of an operation or to the length of a cycle.
struct AssertionParameter {
    ParameterKind kind = ParameterKind::constant;
    QualifiedName name;  ///< for a cycle, the word `cycleDef`
    QualifiedName context;
    ExprPtr value;
    ComponentPath context_path;           ///< filled by resolve; a platform is represented by its module
    const Declaration* target = nullptr;  ///< filled by resolve: Variable
};

/// An assertion in the source text.
struct Assertion final {
    std::string name;
    Span name_span, span;
    AssertionTime time = AssertionTime::both;
    AssertionKind kind = AssertionKind::deadlock_free;
    bool negated = false;
    QualifiedName subject;  ///< X; for reachable: the component; clock_initialised, event_missed: empty
    QualifiedName other;    ///< Y of refines/equals; state of reachable; clock; machine or state of event_missed; rule
    QualifiedName event;    ///< event_missed
    std::optional<std::int64_t> time_units;  ///< event_missed: number of consecutive time units, if given
    Span time_units_span;
    std::optional<AssertionModel> model;
    std::vector<AssertionParameter> parameters;
    ComponentPath subject_path;  ///< filled by resolve; of the component X
    /// Filled by resolve. For refines and equals: the component Y. For reachable: the path through the subject to the
    /// machine with the state. For clock_initialised: the machine with the clock. For event_missed: the machine.
    ComponentPath other_path;
    const State* state = nullptr;   ///< filled by resolve: reachable, event_missed; null in event_missed: whole
                                    ///< machine
    const Clock* clock = nullptr;   ///< filled by resolve: clock_initialised
    const Event* missed = nullptr;  ///< filled by resolve: event_missed
};

/// RoboSim: `simulation N of M { cycleDef e input context {…} output context {…} }`, where N names the RoboChart
/// component M, run in cycles. The contexts are present if M is a machine.
struct Simulation final : Context {
    Simulation() : Context(DeclKind::simulation) {}
    QualifiedName subject;
    ComponentPath subject_path;  ///< filled by resolve
};

/// `csp NAME associated to X csp-begin … csp-end`.
struct CspBlock final {
    std::string name;
    Span name_span, span;
    AssertionTime time = AssertionTime::both;
    std::vector<QualifiedName> associated;
    std::vector<ComponentPath> associated_paths;  ///< filled by resolve: one for each name
    std::string text;                             ///< verbatim, between csp-begin and csp-end
    Span text_span;
};
/// True if a line of the block begins with the name, followed by a parameter or `=`, so that it defines the name.
[[nodiscard]] bool defines_name(const CspBlock&, std::string_view name);

// ---------------------------------------------------------------- probabilistic assertions

/// `q set to e` or `q from set {…}`.
struct ConstantValues {
    ExprPtr constant;
    bool from_set = false;
    ExprPtr value;
};

/// The reward of a state or of a step. The item of a step begins with `[event]` or `[]`.
struct RewardItem {
    bool of_step = false;
    ExprPtr event;  ///< null: reward of a state, or of a step without event
    ExprPtr guard;
    ExprPtr value;
};

/// `(p : @x = e)`.
struct Update {
    ExprPtr probability;  ///< null: 1
    ExprPtr variable;
    ExprPtr value;
};

/// `[event] guard -> update & update;`.
struct Command {
    ExprPtr event;  ///< null: none
    ExprPtr guard;
    std::vector<Update> updates;  ///< none: `skip`
};

/// `x : [low to high] init e;`.
struct ModuleVariable {
    VariablePtr variable;
    ExprPtr low, high;  ///< null: bool
};

/// `pmodule N { … }`: a PRISM module in addition to those of the model.
struct ProbabilisticModule {
    std::string name;
    Span name_span;
    std::vector<ModuleVariable> variables;
    std::vector<Command> commands;
};

/// `pfunction f(x) = { return e }` or `poperation o(x) = { update & update }`.
struct ProbabilisticFunction {
    std::string name;
    Span name_span;
    std::vector<VariablePtr> parameters;
    ExprPtr result;  ///< null: an operation
    std::vector<Update> updates;
};

/// The kind of a probabilistic definition.
enum class ProbabilisticKind { constant, constants, label, formula, rewards, definitions, modules };

/// A definition to which properties refer. The kind determines which members are used.
struct ProbabilisticDefinition {
    ProbabilisticKind kind = ProbabilisticKind::constant;
    std::string name;
    Span name_span, span;
    VariablePtr constant;  ///< the constant of `const t : T`
    ExprPtr value;         ///< the expression of a label or a formula
    std::vector<ConstantValues> constants;
    std::vector<RewardItem> rewards;
    std::vector<ProbabilisticFunction> functions;
    std::vector<ProbabilisticModule> modules;
    bool broken = false;  ///< contains a syntax error, so parts may be missing
};

/// `with constants C`, or an inline definition in the place of C.
struct ProbabilisticClause {
    QualifiedName name;                  ///< empty: defined inline
    ProbabilisticDefinition definition;  ///< its kind is that of the clause
};

/// `using simulation for n steps` or `for deadlock with k repeats`, `up to m steps`.
struct PathGeneration {
    ExprPtr steps;  ///< null: to a deadlock
    ExprPtr repeats;
    ExprPtr limit;
};

/// `prob property P : e …` or `prob generate path P : …`.
struct ProbabilisticAssertion {
    std::string name;
    Span name_span, span;
    ExprPtr property;  ///< null: a path is generated
    PathGeneration path;
    std::vector<ProbabilisticClause> clauses;
    std::string options;  ///< `with cmdoptions "…"`, including the quotes
    bool broken = false;  ///< contains a syntax error, so parts may be missing
};

// ---------------------------------------------------------------- files

/// A part of an assertion file that is stored as text and not evaluated.
struct KeptPart {
    std::string form;  ///< the words at the beginning of the part: `prob property`, `sleec assertion`, `defs`
    std::string name;
    Span span;            ///< the place of the form and the name
    bool claims = false;  ///< true: another tool checks a claim; false: a definition for probabilistic assertions
    std::string text;     ///< the whole text
    Span whole;
};

/// A parsed model or assertion file.
struct File {
    diagnostics::SourceId source = diagnostics::SourceId::none;
    Dialect dialect = Dialect::robochart;
    std::string folder;     ///< the folder of the file, from the root, with "/" at the end
    QualifiedName package;  ///< empty: unnamed package
    std::vector<Import> imports;
    std::vector<std::string> diagrams;
    std::vector<Span> comments;
    /// Types, functions, interfaces, platforms, operations, machines, controllers and modules in textual order.
    std::vector<std::unique_ptr<Declaration>> declarations;

    bool is_assertions = false;
    std::vector<Assertion> assertions;
    std::vector<CspBlock> csp_blocks;
    std::vector<std::unique_ptr<Simulation>> simulations;
    std::vector<ProbabilisticDefinition> probabilistic_definitions;
    std::vector<ProbabilisticAssertion> probabilistic_assertions;
    std::vector<KeptPart> kept;           ///< parts for other tools
    bool is_library = false;              ///< a toolkit, which is part of this program
    bool has_syntax_errors = false;       ///< parts may be missing, so rules about absent elements are not applied
    std::vector<std::string> lost_names;  ///< names that occur in text that could not be parsed
    bool lost_declarations = false;       ///< a declaration of unknown name could not be parsed
};

/// A project: all its files, and the libraries that they use. They are resolved together.
struct Model {
    std::vector<std::unique_ptr<File>> files;
};

}  // namespace robochart::frontend
