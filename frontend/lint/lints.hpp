// SPDX-License-Identifier: Apache-2.0
// Reports warnings about models that are well-formed but probably not intended (private to the front end). A warning is
// given only if an expert in the semantics would agree with it (see the pages of the rules RC-W…). The cost is linear
// in the size of the project, apart from bounded searches over the guards of one node.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/names/names.hpp"

namespace robochart::frontend {

using diagnostics::Diagnostics;

/// Reports all warnings about a resolved model. Files with errors are skipped. Warnings that consider several files are
/// reported only if the project has no errors.
void lint_model(const Model& model, const Names& names, Diagnostics& out);

// The two steps of `lint_model`: first the warnings about each file, then those about the project. `written_by` maps
// the name of an operation to the variables that it writes.
using WrittenBy = std::unordered_map<std::string, std::unordered_set<std::string>>;
[[nodiscard]] WrittenBy variables_written_by_operations(const Model& model);
[[nodiscard]] bool may_lint(const File& file, const Diagnostics& out);
[[nodiscard]] bool may_lint_project(const Model& model, const Diagnostics& out);
/// Reports warnings about single components and functions of a file.
void lint_file(const File& file, const Names& names, const WrittenBy& written_by, Diagnostics& out);
/// Reports warnings that consider several files.
void lint_project(const Model& model, Diagnostics& out);

/// The transitions of one container, indexed by source and target.
class Graph {
public:
    explicit Graph(const NodeContainer& container);
    [[nodiscard]] const std::vector<const Transition*>& transitions_from(const State& node) const {
        return transitions_at(out_, node);
    }
    [[nodiscard]] const std::vector<const Transition*>& transitions_into(const State& node) const {
        return transitions_at(in_, node);
    }

private:
    using Table = std::unordered_map<const State*, std::vector<const Transition*>>;
    static const std::vector<const Transition*>& transitions_at(const Table& table, const State& node);
    Table out_, in_;
};

/// The effects that an action may have.
struct Effects {
    std::unordered_set<const Declaration*> writes;  ///< variables that change, clocks that are reset
    bool calls = false;
    bool communicates = false;
    bool waits = false;
};
void add_effects(const Stmt& action, Effects& effects);
/// Adds the effects of the actions of a state and the states inside it. During actions are included if `during` is
/// true.
void add_effects(const State& state, bool during, Effects& effects);

/// Returns the variable at the root of `v`, `v.f` or `v[i]`, or null if there is none.
[[nodiscard]] const Declaration* assigned_root(const Expr& target);
/// True if the expression mentions one of these variables or clocks, or sinceEntry of one of these states.
[[nodiscard]] bool mentions_any(const Expr& expr, const std::unordered_set<const Declaration*>& declarations);
/// Returns the value of a literal number.
[[nodiscard]] std::optional<double> number_of(const Expr& expr);
/// Returns the shortest time that a statement can take, computed from its literals.
[[nodiscard]] double least_time(const Stmt& statement);
/// Returns the names as a list in a sentence: "`a`, `b` and `c`".
[[nodiscard]] std::string list_names(const std::vector<std::string>& names);

/// The transitions that can never be taken.
using Never = std::unordered_set<const Transition*>;

/// Reports junctions whose guards may all be false (RC-W02), transitions that can never fire (RC-W04) and guards that
/// are always true (RC-W05). Fills `never`.
void lint_guards(const Machine& machine, Never& never, Diagnostics& out);
/// Reports nodes that cannot be reached (RC-W03).
void lint_reachability(const Machine& machine, const Never& never, Diagnostics& out);
/// Reports variables that are read before they are set (RC-W06).
void lint_flow(const Machine& machine, const WrittenBy& written_by, Diagnostics& out);
/// Reports cycles of transitions that need no event and no time (RC-W09).
void lint_loops(const Machine& machine, const Never& never, Diagnostics& out);
/// Reports differences that may be negative when they are cast to nat (RC-W10), and divisors that may be 0 (RC-W11).
void lint_arithmetic(const Machine& machine, Diagnostics& out);
/// Reports stores under `not` (RC-Y13), and states of a RoboSim machine from which no cycle can end (RC-Y14).
void lint_cycles(const Machine& machine, Diagnostics& out);
/// Reports names that hide others (RC-W12).
void lint_shadowing(const File& file, const Context& context, const Names& names, Diagnostics& out);
/// Reports duplicate transitions (RC-W14), assignments of a variable to itself (RC-W15), and statements that wait
/// longer than their deadline (RC-W16).
void lint_statements(const Machine& machine, Diagnostics& out);
/// Reports variables that grow without bound (RC-W21).
void lint_growth(const Machine& machine, const WrittenBy& written_by, Diagnostics& out);
/// Reports events that are lost while an action waits (RC-W20).
void lint_missed(const Machine& machine, Diagnostics& out);
/// Reports unused declarations (RC-W07), variables that are never read (RC-W08) and clocks that are never reset
/// (RC-W18), over the whole project.
void lint_unused(const Model& model, Diagnostics& out);
/// Reports events without a connection beyond their component (RC-W01), and connected events that one end never uses
/// (RC-W17).
void lint_events(const Component& component, Diagnostics& out);
/// Reports an operation that is declared to terminate but cannot end (RC-W19).
void lint_termination(const Machine& operation, Diagnostics& out);
/// Reports calls that never return (RC-W13). A machine to which several controllers refer is checked in each of them.
/// `reported` contains the calls reported so far.
using ReportedCalls = std::unordered_set<const Stmt*>;
void lint_operations(const Component& controller, ReportedCalls& reported, Diagnostics& out);

}  // namespace robochart::frontend
