// SPDX-License-Identifier: Apache-2.0
// Declares the language of PRISM as a tree. Models and properties share one expression language. The parser builds the
// tree (reader.hpp), and the printer writes it (printer.hpp).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics/source.hpp"

namespace robochart::prism {

using diagnostics::Span;

/// A word of the text with its place.
struct Name {
    std::string text;
    Span span;
};

enum class Type : std::uint8_t { boolean, integer, real };
/// Returns "int", "double" or "bool".
[[nodiscard]] const char* type_name(Type type);

/// The kind of an expression. `Expr::parts` are its operands in the order of the text, unless documented otherwise.
enum class Op : std::uint8_t {
    // clang-format off
    boolean,      ///< text: "true" or "false"
    integer,      ///< text: as written
    real,         ///< text: as written
    name,         ///< text
    label,        ///< text: a label, or another property
    conditional, implies, iff, disjunction, conjunction, negation,
    equal, unequal, less, less_equal, greater, greater_equal,
    add, subtract, multiply, divide, power, minus,
    call,         ///< text: the function
    probability, steady, reward,  ///< P, S, R: parts[0] is the body, `query` contains the rest
    forall_paths, exists_path,    ///< A, E
    filter,       ///< text: the operator; parts: the expression, then the states if given
    next, eventually, globally, until, weak_until, release,  ///< X F G U W R
    cumulative,   ///< C<=parts[0]
    total,        ///< C
    instantaneous,  ///< I=parts[0]
    long_run,     ///< S in a reward query
    // clang-format on
};

struct Expr;
using ExprPtr = std::shared_ptr<const Expr>;

enum class Optimum : std::uint8_t { none, minimum, maximum };

/// The part of P, S and R queries before the brackets.
struct Query {
    Op relation = Op::equal;  ///< relation to the bound; `equal` without a bound is `=?`
    ExprPtr bound;            ///< null: the query asks for the value
    Optimum optimum = Optimum::none;
    Name reward;           ///< R{"name"}
    ExprPtr reward_index;  ///< R{2}
};

/// The bound on the steps of a path operator: `<=t`, `[a,b]`. A side that is null is unbounded.
struct StepBound {
    ExprPtr low, high;
    bool low_strict = false, high_strict = false;
    bool single = false;  ///< `=t`: low and high are equal
};

/// An expression in a model or a property.
struct Expr {
    Op op = Op::boolean;
    Span span;
    std::string text;
    std::vector<ExprPtr> parts;
    std::shared_ptr<const Query> query;
    std::shared_ptr<const StepBound> steps;
    std::uint32_t height = 1;  ///< height of the tree
    std::uint64_t size = 1;    ///< number of nodes; shared nodes count each time
};

/// Maximal height of a tree, also after the expansion of formulas.
inline constexpr std::uint32_t max_height = 4000;
/// Maximal size of a tree, also after the expansion of formulas.
inline constexpr std::uint64_t max_size = 5'000'000;

/// Makes a node and computes its height and size from its parts.
[[nodiscard]] ExprPtr make_expr(Expr expr);
/// Makes an operation on operands; `span` is its place.
[[nodiscard]] ExprPtr make_expr(Op op, Span span, std::vector<ExprPtr> parts, std::string text = {});
/// Returns whether both have the same operators, names and literals. Places may differ.
[[nodiscard]] bool same_expr(const ExprPtr& a, const ExprPtr& b);

/// Returns whether the operator is one of X F G U W R.
[[nodiscard]] bool is_temporal(Op op);
/// Returns whether the expression contains path operators outside inner queries.
[[nodiscard]] bool is_path(const Expr& expr);

struct Constant {
    Type type = Type::integer;
    Name name;
    ExprPtr value;  ///< null: no definition
};

/// The definition of a formula or a label.
struct Definition {
    Name name;
    ExprPtr body;
};

struct Variable {
    Name name;
    Type type = Type::integer;
    ExprPtr low, high;  ///< null: bool, or an unbounded int
    ExprPtr initial;    ///< null: the default
};

struct Assignment {
    Name variable;
    ExprPtr value;
};

/// A branch of a command: `p : (x'=e) & ...`
struct Branch {
    ExprPtr probability;  ///< null: 1
    std::vector<Assignment> assignments;
    Span span;
};

struct Command {
    Name action;  ///< text "": none
    ExprPtr guard;
    std::vector<Branch> branches;
    Span span;
};

struct Renaming {
    Name from, to;
};

struct Module {
    Name name;
    std::vector<Variable> variables;
    std::vector<Command> commands;
    Name base;  ///< `module M = base [renamings]`; text "": none
    std::vector<Renaming> renamings;
};

struct RewardItem {
    bool transition = false;  ///< has brackets, even if they are empty
    Name action;
    ExprPtr guard, value;
    Span span;
};

struct RewardStructure {
    Name name;  ///< text "": none
    std::vector<RewardItem> items;
};

/// `system ... endsystem`.
struct Composition {
    enum class Kind : std::uint8_t { module, common, interleaved, on_actions, hide, rename };
    Kind kind = Kind::module;
    Name module;
    std::vector<std::shared_ptr<const Composition>> parts;
    std::vector<Name> actions;  ///< on_actions, hide
    std::vector<Renaming> renamings;
    std::uint32_t height = 1;
};
using CompositionPtr = std::shared_ptr<const Composition>;

enum class ModelKind : std::uint8_t { dtmc, mdp };

struct ModelFile {
    ModelKind kind = ModelKind::mdp;
    bool kind_given = false;
    std::vector<Constant> constants;
    std::vector<Definition> formulas;
    std::vector<Definition> labels;
    std::vector<Variable> globals;
    std::vector<Module> modules;
    std::vector<RewardStructure> rewards;
    ExprPtr initial;        ///< init ... endinit; null: none
    CompositionPtr system;  ///< null: all modules synchronise on their common actions
    Span end;               ///< end of the text
};

struct Property {
    Name name;  ///< text "": none
    ExprPtr expression;
};

struct PropertyFile {
    std::vector<Constant> constants;
    std::vector<Definition> labels;
    std::vector<Property> properties;
};

}  // namespace robochart::prism
