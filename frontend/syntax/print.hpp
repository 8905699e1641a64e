// Tree parts back as RoboChart text: on one line for dumps, messages and reports; whole files for people and tools.
// Reading a printed file gives an equal tree (a property test over random trees, tests/random_models).
#pragma once

#include <string>
#include <string_view>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

[[nodiscard]] std::string to_text(const TypeExpr& type);
[[nodiscard]] std::string to_text(const Expr& expr);
[[nodiscard]] std::string to_text(const Communication& communication);
[[nodiscard]] std::string to_text(const Stmt& statement);
/// Of the forms that are found in probabilistic assertions alone.
[[nodiscard]] std::string probabilistic_text(const Expr& expr);
/// The operator as written, e.g. "Finally".
[[nodiscard]] std::string_view to_text(PathOp op);
/// The operator as written, e.g. "/\\".
[[nodiscard]] std::string_view to_text(BinaryOp op);
/// The keyword or words for a kind of declaration, e.g. "stm", "robotic platform".
[[nodiscard]] std::string_view to_text(DeclKind kind);

/// A name as it must be written: reserved words with their `^`.
[[nodiscard]] std::string written_name(std::string_view name);
[[nodiscard]] std::string written_name(const QualifiedName& name);

/// A top-level declaration or component, indented, with a line end.
[[nodiscard]] std::string to_text(const Declaration& declaration);
/// On one line, with a line end.
[[nodiscard]] std::string to_text(const Assertion& assertion);
/// On one line, with a line end.
[[nodiscard]] std::string to_text(const ProbabilisticDefinition& definition);
/// On one line, with a line end.
[[nodiscard]] std::string to_text(const ProbabilisticAssertion& assertion);
/// What a probabilistic assertion asks, on one line without its name: `Prob=? of [Finally x] with constants C`.
[[nodiscard]] std::string claim(const ProbabilisticAssertion& assertion);
/// The word that a definition begins with, e.g. "label".
[[nodiscard]] std::string_view to_text(ProbabilisticKind kind);
/// A whole file. Comments are no part of the tree and are not printed; members of a body come in the order of the tree.
[[nodiscard]] std::string to_text(const File& file);

}  // namespace robochart::frontend
