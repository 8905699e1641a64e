// SPDX-License-Identifier: Apache-2.0
// Builds the machine's module: the functions of the points, with RoboTool's channels, event sets and process variants
// (semantics 3.2, 3.12).
#pragma once

#include <string>
#include <vector>

#include "csp_emit/machine/tables/machine_tables.hpp"
#include "csp_emit/passes/variable_memory.hpp"

namespace robochart::csp_emit {

/// Returns the parameters of a process: `id__`, the operation's parameters, then the given constants in order of
/// declaration (semantics 3.12).
[[nodiscard]] std::vector<std::string> parameters_with(const MachineTables&, const std::vector<std::string>& constants);

/// Builds the declarations of the module. It stores what several declarations need: the calls and clock events in the
/// alphabet.
class ModuleDeclarations {
public:
    /// `remembered` contains the variables that have memory processes.
    ModuleDeclarations(MachineTables& tables, const std::vector<Remembered>& remembered)
        : tables_(tables), remembered_(remembered) {}

    /// Returns the module with the definitions of the points. `initial` is the machine's process.
    [[nodiscard]] cspm::DeclPtr make_module(const std::vector<cspm::DeclPtr>& points, const cspm::ExprPtr& initial);
    /// Returns the channels of `sem__events`. Valid after the module has been made.
    [[nodiscard]] const std::vector<std::string>& visible_channels() const { return visible_; }

private:
    void declare_channels(std::vector<cspm::DeclPtr>& decls);
    void declare_cycle_channels(std::vector<cspm::DeclPtr>& decls);
    void add_cycle_events(std::vector<cspm::ExprPtr>& visible);
    cspm::ExprPtr in_cycles(const cspm::ExprPtr& machine, std::vector<cspm::DeclPtr>& decls) const;
    bool is_operation() const { return tables_.machine().kind == ir::MachineKind::operation; }
    void declare_mentioned(std::vector<cspm::DeclPtr>& decls) const;
    void declare_clocks(std::vector<cspm::DeclPtr>& decls);
    void declare_calls(std::vector<cspm::DeclPtr>& decls);
    void declare_states(std::vector<cspm::DeclPtr>& decls);
    void declare_sets(std::vector<cspm::DeclPtr>& decls);
    void declare_variants(std::vector<cspm::DeclPtr>& decls, const cspm::ExprPtr& initial) const;
    cspm::DeclPtr state_module(ir::NodeId);
    std::vector<ir::NodeId> entered_states() const;

    MachineTables& tables_;
    const std::vector<Remembered>& remembered_;
    std::vector<std::string> calls_;           ///< operations whose calls are events
    std::vector<std::string> visible_;         ///< channels of sem__events
    std::vector<cspm::ExprPtr> clock_events_;  ///< events of sem__events that read and reset the caller's clocks
    bool local_resets_ = false;                ///< resets of own clocks are events, because a CSP block mentions them
};

}  // namespace robochart::csp_emit
