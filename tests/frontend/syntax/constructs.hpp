// SPDX-License-Identifier: Apache-2.0
// Lists one row for each construct of the grammar (language reference 1.1, assertion reference 4): its text, and the
// expected tree or the rule that rejects it. A construct without a row is a construct without a test.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace robochart::frontend::testing {

struct Row {
    const char* text;
    const char* expected;
};
std::ostream& operator<<(std::ostream& out, const Row& row);

/// Returns the rows for expressions with the highest precedence.
[[nodiscard]] const std::vector<Row>& atoms();
/// Returns the rows for operators, from the lowest to the highest precedence. Each level is combined with its
/// neighbours.
[[nodiscard]] const std::vector<Row>& operators();
/// Returns the rows for types.
[[nodiscard]] const std::vector<Row>& types();
/// Returns the rows for statements.
[[nodiscard]] const std::vector<Row>& statements();
/// Returns the rows for clauses of a transition, after `from a to b`.
[[nodiscard]] const std::vector<Row>& clauses();
/// Returns the rows for whole files of declarations.
[[nodiscard]] const std::vector<Row>& declarations();
/// Returns the rows for whole files of assertions.
[[nodiscard]] const std::vector<Row>& assertions();
/// Returns whole files that the grammar forbids, each with its finding.
[[nodiscard]] const std::vector<Row>& refused();

/// The file in which the text of a row is embedded.
struct Frame {
    const char* before;
    const char* after;
    [[nodiscard]] std::string operator()(const std::string& text) const { return before + text + after; }
};
inline constexpr Frame as_guard{"stm S { transition t { from a to b condition ", " } }"};
inline constexpr Frame as_type{"interface I { var v:", " }"};
inline constexpr Frame as_entry{"stm S { state s { entry ", " } }"};
inline constexpr Frame as_clauses{"stm S { transition t { from a to b ", " } }"};
inline constexpr Frame as_file{"", ""};

}  // namespace robochart::frontend::testing
