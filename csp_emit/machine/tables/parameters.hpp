// SPDX-License-Identifier: Apache-2.0
// Stores the parameters of a machine's functions: the data that its process passes from one configuration to the next.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "csp_emit/base/names.hpp"
#include "csp_emit/machine/tables/control_state.hpp"
#include "csp_emit/passes/liveness.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

enum class CellKind { variable, clock, deadline, waiting, frozen, monitor };

/// A parameter and its content.
struct Cell {
    std::string name;  ///< the CSPM parameter
    CellKind kind = CellKind::variable;
    std::string meaning;  ///< RoboChart name, "since(T)"
    ir::TypeId type;
    bool shared = false;     ///< a required variable: other components may write it; its writes are events set_x
    bool parameter = false;  ///< an operation's parameter: read-only
    std::string channel;     ///< variable: its name in set_x
    std::string output;      ///< RoboSim: the constructor of registerWrite that writes the variable; "" if none does
    cspm::ExprPtr limit;     ///< clock: its maximal value
    ir::Origin deadline;     ///< deadline, monitor: the element whose deadline the cell counts down
    /// For a clock of the caller, if the operation is checked separately: the channel that reads it.
    std::string reading;
};

/// The values of cells. A cell without an entry still has the value of its parameter.
using Values = std::map<CellId, cspm::ExprPtr>;

/// Owns the cells of a machine and of the operations that it calls.
class ParameterTable {
public:
    explicit ParameterTable(NameManager& names) : names_(names) {}

    /// Adds a cell with a unique name.
    CellId add_cell(Cell cell);
    /// Returns the cell for a value that a statement stores during its execution. `number` distinguishes the
    /// statement's values.
    CellId of_statement(std::uint32_t frame, const ir::Stmt& stmt, std::size_t number, CellKind kind,
                        const std::string& name);
    /// Returns the cell that holds the value of a trigger until it is stored.
    CellId of_trigger(std::uint32_t frame, ir::TransitionId);

    [[nodiscard]] const Cell& operator[](CellId cell) const { return cells_[cell]; }
    /// Returns all cells in order of creation.
    [[nodiscard]] const std::vector<Cell>& all() const { return cells_; }
    [[nodiscard]] std::optional<CellId> find_cell(const std::string& parameter) const;
    /// Returns the parameter as an expression.
    [[nodiscard]] cspm::ExprPtr parameter_name(CellId) const;
    /// Returns the current value of the cell.
    [[nodiscard]] cspm::ExprPtr current_value(CellId, const Values&) const;
    /// Converts the values to arguments, with the names of their parameters.
    [[nodiscard]] Arguments to_arguments(const Values&) const;

private:
    NameManager& names_;
    std::vector<Cell> cells_;
    std::map<std::string, CellId> by_name_;
    std::map<std::tuple<std::uint32_t, const ir::Stmt*, std::size_t>, CellId> of_statements_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, CellId> of_triggers_;  ///< by frame and transition
};

}  // namespace robochart::csp_emit
