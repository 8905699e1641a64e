// SPDX-License-Identifier: Apache-2.0
// Writes assignments. If others see the variable, a function writes it. Otherwise a plain assignment does.
#include "cpp_emit/code/assignment.hpp"

#include <fmt/format.h>

#include "cpp_emit/expressions/expression.hpp"

namespace robochart::cpp_emit {

std::string store_statement(const Generation& generation, const Unit& unit, ir::VariableId id,
                            const std::string& value) {
    const StoredVariable* stored = generation.component.stored_variable(unit, id);
    const std::string propagate =
        stored != nullptr && !stored->holders.empty() ? fmt::format(" {}();", stored->propagate) : std::string();
    if (stored != nullptr && stored->visible) return fmt::format("{}({});{}", stored->writer, value, propagate);
    const bool propagated = stored != nullptr && stored->shared && generation.component.is_composed();
    if (propagated && generation.mutation.hits(Fault::write_not_relayed)) return {};
    if (stored != nullptr && stored->local) return fmt::format("{}.write({});", stored->field, value);
    const std::string place = ExpressionWriter(generation, unit).variable_member(id);
    return place.empty() ? propagate : fmt::format("{} = {};{}", place, value, propagate);
}

bool may_be_held_up(const Generation& generation, const Unit& unit, ir::VariableId id) {
    const StoredVariable* const stored = id.is_valid() ? generation.component.stored_variable(unit, id) : nullptr;
    return stored != nullptr && !stored->holders.empty();
}

CppExpr may_write(const Generation& generation, const Unit& unit, ir::VariableId id) {
    if (!may_be_held_up(generation, unit, id)) return {};
    return negation(CppExpr(generation.component.stored_variable(unit, id)->held_up + "()"));
}

std::string clock_reset(const Generation& generation, const Unit& unit, ir::ClockId id) {
    const auto [owner, own] = generation.component.clock_owner(unit, id);
    if (!owner->clock_read[own.index]) return {};
    return fmt::format("{} = 0;", ExpressionWriter(generation, unit).clock_member(id));
}

void reset_clocks(const Generation& generation, const Unit& unit, const std::vector<ir::ClockId>& clocks,
                  CodeWriter& out) {
    for (const ir::ClockId clock : clocks) {
        const std::string line = clock_reset(generation, unit, clock);
        if (!line.empty()) out.line(line);
    }
}

std::string watch_from(const Generation& generation, const Unit& unit, const std::string& field,
                       const ir::Expr& bound) {
    return fmt::format("f.{} = duration({}) + 1;", field, ExpressionWriter(generation, unit).write(bound));
}

}  // namespace robochart::cpp_emit
