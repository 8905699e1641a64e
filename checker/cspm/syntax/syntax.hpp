// SPDX-License-Identifier: Apache-2.0
// Defines the syntax tree of machine-readable CSP (CSPM) as FDR4 reads it (FDR manual, chapter CSPM). The reader builds
// trees from text and csp_emit builds them from RoboChart; one printer and one evaluator use them. Trees are compared
// by structure, without spans and comments: if the printed text is parsed, the result equals the tree. Nodes never
// change after construction, so trees may share them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics/source.hpp"

namespace robochart::cspm {

using diagnostics::Span;

struct Expr;
struct Pattern;
struct Decl;
using ExprPtr = std::shared_ptr<const Expr>;
using PatternPtr = std::shared_ptr<const Pattern>;
using DeclPtr = std::shared_ptr<const Decl>;

// ---------------------------------------------------------------- patterns

enum class PatternKind {
    wildcard,  ///< _
    name,      ///< a variable, or a constructor/channel if `text` names one (decided at evaluation)
    integer,
    character,
    string,
    boolean,   ///< literals
    tuple,     ///< (p, q)
    sequence,  ///< <p, q>
    set,       ///< {} or {p}
    concat,    ///< p ^ q
    dot,       ///< p . q
    both,      ///< p @@ q
};

struct Pattern {
    PatternKind kind = PatternKind::wildcard;
    Span span;
    std::string text;         ///< name (qualified by "::"), string
    std::int64_t number = 0;  ///< integer, character code, boolean 0/1
    std::vector<PatternPtr> args;
};

// ---------------------------------------------------------------- expressions

enum class ExprKind {
    // values
    integer,
    character,
    string,
    boolean,
    name,  ///< name: `text`, qualified by "::"
    tuple,
    sequence,
    set,
    map,  ///< map: (| k => v, ... |): args k1,v1,k2,v2,...
    sequence_range,
    set_range,  ///< <a..b>, {a..b}; args[1] null: infinite <a..>
    sequence_comprehension,
    set_comprehension,  ///< args: heads; clauses
    sequence_range_comprehension,
    set_range_comprehension,  ///< <a..b | clauses>
    productions,
    productions_comprehension,  ///< {| args |}, {| args | clauses |}
    dot,                        ///< a.b.c: args (n-ary, flattened left to right)
    apply,                      ///< args[0](args[1..])
    lambda,                     ///< \ patterns @ args[0]
    let,                        ///< let decls within args[0]
    if_then_else,               ///< args[0..2]
    parenthesised,              ///< (args[0]); ignored by equality
    // operators on values: args[0] op args[1]
    negate,
    plus,
    minus,
    times,
    divide,
    modulus,
    equal,
    not_equal,
    less,
    less_equal,
    greater,
    greater_equal,
    logical_not,
    logical_and,
    logical_or,
    concat,
    length,  ///< ^, #
    // processes
    prefix,                   ///< args[0] fields -> args[1]
    guard,                    ///< args[0] & args[1]
    external_choice,          ///< P [] Q
    internal_choice,          ///< P |~| Q
    sequential,               ///< P ; Q
    interrupt,                ///< P /\ Q
    sliding_choice,           ///< P [> Q
    interleave,               ///< P ||| Q
    parallel,                 ///< P [| args[2] |] Q
    alphabetised,             ///< P [ args[2] || args[3] ] Q
    linked,                   ///< P [ links ] Q
    exception,                ///< P [| args[2] |> Q
    synchronising_choice,     ///< P [+ args[2] +] Q
    synchronising_interrupt,  ///< P /+ args[2] +\ Q
    hide,                     ///< P \ args[1]
    project,                  ///< P |\ args[1]
    rename,                   ///< P [[ links | clauses ]]
    // replicated forms: op clauses @ args[0]; set arguments follow in args
    replicated_external,
    replicated_internal,
    replicated_sequential,
    replicated_interleave,
    replicated_parallel,       ///< [| args[1] |] x:S @ P
    replicated_alphabetised,   ///< || x:S @ [ args[1] ] P
    replicated_linked,         ///< [ links ] x:s @ P
    replicated_synchronising,  ///< [+ args[1] +] x:S @ P
};

/// A field of a prefix: `.e`, `!e`, `?p`, `?p:S`, `$p` or `$p:S`.
enum class FieldKind { dot, output, input, nondeterministic };
struct Field {
    FieldKind kind = FieldKind::output;
    Span span;
    ExprPtr value;       ///< dot, output: the value; input: the optional restriction set
    PatternPtr pattern;  ///< input, nondeterministic
};

/// A clause of a comprehension or replication: a generator `p <- e` / `p : e`, or a condition.
struct Clause {
    PatternPtr pattern;  ///< null if the clause is a condition
    ExprPtr value;
};

/// `from <- to` in renamings, or `from <-> to` in linked parallel. Their optional clauses are in Expr::clauses.
struct Link {
    ExprPtr from, to;
};

struct Expr {
    ExprKind kind = ExprKind::integer;
    Span span;
    std::string text;
    std::int64_t number = 0;
    std::vector<ExprPtr> args;
    std::vector<Field> fields;
    std::vector<Clause> clauses;
    std::vector<Link> links;
    std::vector<PatternPtr> patterns;
    std::vector<DeclPtr> decls;
};

// ---------------------------------------------------------------- types as written

/// Types in declarations of channels, datatypes and nametypes are expressions that denote sets (FDR: `channel c :
/// {0..2}.Bool`). Several fields form an ExprKind::dot, and a tuple type is an ExprKind::tuple.
struct Constructor {
    std::string name;
    ExprPtr fields;  ///< null if there are none
    Span span;
};

// ---------------------------------------------------------------- declarations

enum class DeclKind {
    /// One clause, `name(patterns)...(patterns) = body`. Consecutive clauses with the same name belong together.
    function,
    value,  ///< pattern = body
    channel,
    datatype,
    subtype,
    nametype,
    module,
    instance,
    timed,
    transparent,
    external,
    annotation,  ///< names :: text (stored verbatim)
    print,
    assertion,
    include,
};

enum class AssertionKind { refinement, deadlock_free, divergence_free, deterministic, has_trace };
enum class Model {
    traces,
    failures,
    failures_divergences,
    refusals,
    refusals_divergences,
    revivals,
    revivals_divergences,
    none
};

struct Assertion {
    AssertionKind kind = AssertionKind::refinement;
    bool negated = false;
    Model model = Model::none;  ///< none: the property's default (failures-divergences)
    ExprPtr specification;      ///< refinement: left side; properties: the process
    ExprPtr implementation;     ///< refinement: right side; has_trace: the trace (a sequence)
    ExprPtr tau_priority;       ///< :[tau priority]: {…}; null if absent
    bool partial_order = false;
};

struct Decl {
    DeclKind kind = DeclKind::value;
    Span span;
    std::string comment;             ///< printed before the declaration as `-- ` lines; ignored by equality
    std::vector<std::string> names;  ///< function, channel, datatype, module…: declared names; include: path
    std::vector<std::vector<PatternPtr>> patterns;  ///< function: one list per curried argument group; value: {{p}}
    ExprPtr body;  ///< function, value, nametype, print; channel: field type (null: none); timed: the duration function
    std::vector<Constructor> constructors;  ///< datatype, subtype
    std::vector<std::string> parameters;    ///< module
    std::vector<DeclPtr> decls;             ///< module: private part; timed: contents
    std::vector<DeclPtr> exports;           ///< module: exported part
    std::vector<ExprPtr> arguments;         ///< instance: arguments of the module named by `text`
    std::string text;                       ///< instance: module name; annotation: the type as written
    Assertion assertion;
};

/// The declarations of one file, or of several joined files.
struct Script {
    std::vector<DeclPtr> decls;
};

/// Compares trees by structure. Ignores spans, comments and parentheses.
[[nodiscard]] bool equal(const ExprPtr&, const ExprPtr&);
[[nodiscard]] bool equal(const Decl&, const Decl&);
[[nodiscard]] bool equal(const Script&, const Script&);

}  // namespace robochart::cspm
