// A variable that others see is written by a function, any other by a plain assignment.
#include "cpp_emit/code/assignment.hpp"

#include <fmt/format.h>

#include "cpp_emit/expressions/expression.hpp"

namespace robochart::cpp_emit {

std::string store(const Generation& generation, const Unit& unit, ir::VariableId id, const std::string& value) {
    const StoredVariable* stored = generation.component.stored(unit, id);
    if (stored != nullptr && stored->visible) return fmt::format("{}({});", stored->writer, value);
    const bool propagated = stored != nullptr && stored->shared && generation.component.composed();
    if (propagated && generation.mutation.hits(Fault::write_not_relayed)) return {};
    const std::string place = ExpressionWriter(generation, unit).variable(id);
    return place.empty() ? "" : fmt::format("{} = {};", place, value);
}

std::string clock_reset(const Generation& generation, const Unit& unit, ir::ClockId id) {
    const auto [owner, own] = generation.component.clock(unit, id);
    if (!owner->clock_read[own.index]) return {};
    return fmt::format("{} = 0;", ExpressionWriter(generation, unit).clock(id));
}

}  // namespace robochart::cpp_emit
