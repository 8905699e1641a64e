// SPDX-License-Identifier: Apache-2.0
// Stores cells by number, by name, and by the statement or trigger that uses them.
#include "csp_emit/machine/tables/parameters.hpp"

#include "checker/cspm/syntax/build.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

CellId ParameterTable::add_cell(Cell cell) {
    cell.name = names_.unique_name(cell.name);
    by_name_[cell.name] = static_cast<CellId>(cells_.size());
    cells_.push_back(std::move(cell));
    return static_cast<CellId>(cells_.size() - 1);
}

CellId ParameterTable::of_statement(std::uint32_t frame, const ir::Stmt& stmt, std::size_t number, CellKind kind,
                                    const std::string& name) {
    const auto key = std::make_tuple(frame, &stmt, number);
    if (const auto found = of_statements_.find(key); found != of_statements_.end()) return found->second;
    Cell cell;
    cell.kind = kind;
    cell.name = name;
    cell.meaning = kind == CellKind::waiting ? "wait left" : "value read";
    if (kind == CellKind::deadline) {
        cell.meaning = "deadline left";
        cell.deadline = stmt.origin;
    }
    return of_statements_[key] = add_cell(std::move(cell));
}

CellId ParameterTable::of_trigger(std::uint32_t frame, ir::TransitionId id) {
    const auto [found, added] = of_triggers_.try_emplace({frame, id.index});
    if (added) {
        Cell cell;
        cell.kind = CellKind::frozen;
        cell.name = "x__";
        cell.meaning = "value received";
        found->second = add_cell(std::move(cell));
    }
    return found->second;
}

std::optional<CellId> ParameterTable::find_cell(const std::string& parameter) const {
    const auto found = by_name_.find(parameter);
    if (found == by_name_.end()) return std::nullopt;
    return found->second;
}

ExprPtr ParameterTable::parameter_name(CellId cell) const {
    return b::name(cells_[cell].name);
}

ExprPtr ParameterTable::current_value(CellId cell, const Values& values) const {
    const auto found = values.find(cell);
    return found == values.end() ? parameter_name(cell) : found->second;
}

Arguments ParameterTable::to_arguments(const Values& values) const {
    Arguments result;
    for (const auto& [cell, value] : values) result.emplace_back(cells_[cell].name, value);
    return result;
}

}  // namespace robochart::csp_emit
