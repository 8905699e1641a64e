// SPDX-License-Identifier: Apache-2.0
// Prints trees as RoboChart text. Dumps, messages and reports need parts of a tree on one line. People and tools need
// whole files. Parsing a printed file gives an equal tree (a property test over random trees, tests/random_models).
#pragma once

#include <string>
#include <string_view>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

[[nodiscard]] std::string to_text(const TypeExpr& type);
[[nodiscard]] std::string to_text(const Expr& expr);
[[nodiscard]] std::string to_text(const Communication& communication);
[[nodiscard]] std::string to_text(const Stmt& statement);
/// Prints the forms of expressions that only probabilistic assertions allow.
[[nodiscard]] std::string probabilistic_text(const Expr& expr);
/// Returns the operator as written, e.g. "Finally".
[[nodiscard]] std::string_view to_text(PathOp op);
/// Returns the operator as written, e.g. "/\\".
[[nodiscard]] std::string_view to_text(BinaryOp op);
/// Returns the keyword or keywords of a kind of declaration, e.g. "stm", "robotic platform".
[[nodiscard]] std::string_view to_text(DeclKind kind);

/// Returns the keyword of an action of a state, e.g. "entry".
[[nodiscard]] std::string_view to_text(ActionKind kind);
/// Returns the keyword of an interface clause, e.g. "uses".
[[nodiscard]] std::string_view to_text(InterfaceUse use);
/// Returns the keyword of a reference to a component of this kind, e.g. "sref" for a state machine.
[[nodiscard]] std::string_view reference_word(DeclKind kind);

/// Returns a name as it must be written: a reserved word gets a `^`.
[[nodiscard]] std::string written_name(std::string_view name);
[[nodiscard]] std::string written_name(const QualifiedName& name);

/// Returns a top-level declaration or a component as indented text with a line end.
[[nodiscard]] std::string to_text(const Declaration& declaration);
/// Returns an assertion on one line, with a line end.
[[nodiscard]] std::string to_text(const Assertion& assertion);
/// Returns a definition of probabilistic assertions on one line, with a line end.
[[nodiscard]] std::string to_text(const ProbabilisticDefinition& definition);
/// Returns a probabilistic assertion on one line, with a line end.
[[nodiscard]] std::string to_text(const ProbabilisticAssertion& assertion);
/// Returns the claim of a probabilistic assertion on one line, without its name: `Prob=? of [Finally x] with constants
/// C`.
[[nodiscard]] std::string claim_text(const ProbabilisticAssertion& assertion);
/// Returns the word that a definition begins with, e.g. "label".
[[nodiscard]] std::string_view to_text(ProbabilisticKind kind);
/// Returns a whole file. Comments are not part of the tree, so they are not printed. The members of a body are printed
/// in the order of the tree.
[[nodiscard]] std::string to_text(const File& file);

}  // namespace robochart::frontend
