// SPDX-License-Identifier: Apache-2.0
// Builds CSPM syntax trees, for example for csp_emit. The comment of a function shows the text that its tree
// represents. Trees contain no spans and no parentheses; the printer adds the necessary parentheses. Operators with
// many operands fold to the left, as the reader does for `P [] Q [] R`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm::build {

using Exprs = std::vector<ExprPtr>;
using Patterns = std::vector<PatternPtr>;
using Decls = std::vector<DeclPtr>;

// ---------------------------------------------------------------- patterns

[[nodiscard]] PatternPtr wildcard();
/// Returns the pattern for a variable, or for a constructor or channel with that name.
[[nodiscard]] PatternPtr variable(std::string name);
[[nodiscard]] PatternPtr integer_pattern(std::int64_t value);
[[nodiscard]] PatternPtr boolean_pattern(bool value);
[[nodiscard]] PatternPtr tuple_pattern(Patterns parts);
[[nodiscard]] PatternPtr dot_pattern(Patterns parts);
[[nodiscard]] PatternPtr sequence_pattern(Patterns parts);
/// `variables({"x", "y"})`: a parameter list of plain variables.
[[nodiscard]] Patterns variables(const std::vector<std::string>& names);

// ---------------------------------------------------------------- values

/// Returns the tree of a number. Like the reader, represents a negative number as `negate` of its absolute value.
[[nodiscard]] ExprPtr number(std::int64_t value);
[[nodiscard]] ExprPtr boolean(bool value);
[[nodiscard]] ExprPtr string(std::string value);
/// A name, qualified by "::" if necessary: `name("P::S::e")`.
[[nodiscard]] ExprPtr name(std::string text);
[[nodiscard]] ExprPtr tuple(Exprs parts);
[[nodiscard]] ExprPtr sequence(Exprs items);
[[nodiscard]] ExprPtr set(Exprs items);
/// `{first..last}`.
[[nodiscard]] ExprPtr set_range(ExprPtr first, ExprPtr last);
/// `{heads | clauses}`.
[[nodiscard]] ExprPtr set_comprehension(Exprs heads, std::vector<Clause> clauses);
/// `<heads | clauses>`.
[[nodiscard]] ExprPtr sequence_comprehension(Exprs heads, std::vector<Clause> clauses);
/// `{| items |}`.
[[nodiscard]] ExprPtr productions(Exprs items);
/// `{| heads | clauses |}`.
[[nodiscard]] ExprPtr productions_comprehension(Exprs heads, std::vector<Clause> clauses);
/// `a.b.c`. Parts that are dots themselves are flattened. A single part is returned unchanged.
[[nodiscard]] ExprPtr dot(Exprs parts);
[[nodiscard]] ExprPtr apply(ExprPtr function, Exprs arguments);
/// `function(arguments)`, or only the name if there are no arguments.
[[nodiscard]] ExprPtr call(std::string function, Exprs arguments = {});
[[nodiscard]] ExprPtr lambda(Patterns parameters, ExprPtr body);
/// `let decls within body`, or only the body if there are no declarations.
[[nodiscard]] ExprPtr let_(Decls decls, ExprPtr body);
[[nodiscard]] ExprPtr if_(ExprPtr condition, ExprPtr then, ExprPtr otherwise);
/// Builds an expression with any binary operator on values, or with one on processes that has no set argument.
[[nodiscard]] ExprPtr binary(ExprKind op, ExprPtr left, ExprPtr right);
[[nodiscard]] ExprPtr negate(ExprPtr operand);
[[nodiscard]] ExprPtr logical_not(ExprPtr operand);
/// Joins the operands by `and`. Without operands, the result is true.
[[nodiscard]] ExprPtr all_of(Exprs operands);
/// Joins the operands by `or`. Without operands, the result is false.
[[nodiscard]] ExprPtr any_of(Exprs operands);
/// `union(a, union(...))`, folded to the left. Without sets, the result is `{}`.
[[nodiscard]] ExprPtr union_of(Exprs sets);

// ---------------------------------------------------------------- clauses

/// `pattern : set` or `pattern <- set`, which have the same tree.
[[nodiscard]] Clause generator(PatternPtr pattern, ExprPtr from);
[[nodiscard]] Clause generator(std::string variable, ExprPtr from);
[[nodiscard]] Clause condition(ExprPtr value);

// ---------------------------------------------------------------- processes

[[nodiscard]] ExprPtr stop();
[[nodiscard]] ExprPtr skip();

[[nodiscard]] Field output(ExprPtr value);                              ///< `!value`
[[nodiscard]] Field input(PatternPtr pattern, ExprPtr from = nullptr);  ///< `?pattern` or `?pattern:from`
[[nodiscard]] Field input(std::string variable, ExprPtr from = nullptr);
[[nodiscard]] Field nondeterministic(PatternPtr pattern, ExprPtr from = nullptr);  ///< `$pattern:from`

/// `event -> process`.
[[nodiscard]] ExprPtr prefix(ExprPtr event, ExprPtr process);
/// `event fields -> process`.
[[nodiscard]] ExprPtr prefix(ExprPtr event, std::vector<Field> fields, ExprPtr process);
/// `condition & process`.
[[nodiscard]] ExprPtr guard(ExprPtr condition, ExprPtr process);
/// `P [] Q [] ...`. Without processes, the result is STOP.
[[nodiscard]] ExprPtr choice(Exprs processes);
/// `P |~| Q |~| ...`. There must be at least one process.
[[nodiscard]] ExprPtr internal_choice(Exprs processes);
/// `P ; Q ; ...`. Without processes, the result is SKIP.
[[nodiscard]] ExprPtr sequential(Exprs processes);
/// `P ||| Q ||| ...`. Without processes, the result is SKIP.
[[nodiscard]] ExprPtr interleave(Exprs processes);
[[nodiscard]] ExprPtr interrupt(ExprPtr process, ExprPtr handler);
[[nodiscard]] ExprPtr sliding_choice(ExprPtr process, ExprPtr other);
/// `P [| events |] Q`.
[[nodiscard]] ExprPtr parallel(ExprPtr left, ExprPtr events, ExprPtr right);
/// `P [ left_alphabet || right_alphabet ] Q`.
[[nodiscard]] ExprPtr alphabetised(ExprPtr left, ExprPtr left_alphabet, ExprPtr right_alphabet, ExprPtr right);
/// `P [| events |> Q`.
[[nodiscard]] ExprPtr exception(ExprPtr process, ExprPtr events, ExprPtr handler);
/// `P [+ events +] Q`.
[[nodiscard]] ExprPtr synchronising_choice(ExprPtr left, ExprPtr events, ExprPtr right);
/// `P /+ events +\ Q`.
[[nodiscard]] ExprPtr synchronising_interrupt(ExprPtr left, ExprPtr events, ExprPtr right);
/// `P \ events`.
[[nodiscard]] ExprPtr hide(ExprPtr process, ExprPtr events);
/// `P |\ events`.
[[nodiscard]] ExprPtr project(ExprPtr process, ExprPtr events);
/// `P [[ from <- to, ... | clauses ]]`.
[[nodiscard]] ExprPtr rename(ExprPtr process, std::vector<Link> links, std::vector<Clause> clauses = {});
/// `P [ from <-> to, ... ] Q`.
[[nodiscard]] ExprPtr linked(ExprPtr left, std::vector<Link> links, ExprPtr right);
/// Builds a replicated form `op clauses @ body`. `set` is the interface or alphabet; it is only used by the kinds that
/// have one.
[[nodiscard]] ExprPtr replicated(ExprKind op, std::vector<Clause> clauses, ExprPtr body, ExprPtr set = nullptr);

// ---------------------------------------------------------------- declarations

/// `name = body`.
[[nodiscard]] DeclPtr value(std::string name, ExprPtr body, std::string comment = "");
/// `name(parameters) = body` as one clause, or `name = body` if there are no parameters.
[[nodiscard]] DeclPtr function_decl(std::string name, Patterns parameters, ExprPtr body, std::string comment = "");
/// `channel names : fields`. If `fields` is null, the channels carry no data.
[[nodiscard]] DeclPtr channel(std::vector<std::string> names, ExprPtr fields = nullptr, std::string comment = "");
/// `datatype name = constructors`.
[[nodiscard]] DeclPtr datatype(std::string name, std::vector<Constructor> constructors, std::string comment = "");
[[nodiscard]] Constructor constructor(std::string name, ExprPtr fields = nullptr);
/// `nametype name = set`.
[[nodiscard]] DeclPtr nametype(std::string name, ExprPtr set, std::string comment = "");
/// `module name(parameters) private exports exported endmodule`.
[[nodiscard]] DeclPtr module_(std::string name, std::vector<std::string> parameters, Decls private_part, Decls exported,
                              std::string comment = "");
/// `instance name = module(arguments)`.
[[nodiscard]] DeclPtr instance(std::string name, std::string module, Exprs arguments = {});
/// `Timed(duration) { decls }`. If `duration` is null, every event takes one time unit.
[[nodiscard]] DeclPtr timed(ExprPtr duration, Decls decls);
[[nodiscard]] DeclPtr transparent(std::vector<std::string> names);
[[nodiscard]] DeclPtr external(std::vector<std::string> names);
[[nodiscard]] DeclPtr include(std::string path);

/// `assert specification [M= implementation`.
[[nodiscard]] DeclPtr assert_refines(ExprPtr specification, Model, ExprPtr implementation, bool negated = false);
/// `assert process :[property [M]]`. Model::none selects the property's default model.
[[nodiscard]] DeclPtr assert_property(ExprPtr process, AssertionKind, Model = Model::none, bool negated = false);
/// `assert process :[has trace [M]]: trace`. `trace` must be a sequence.
[[nodiscard]] DeclPtr assert_has_trace(ExprPtr process, ExprPtr trace, Model = Model::none, bool negated = false);

}  // namespace robochart::cspm::build
