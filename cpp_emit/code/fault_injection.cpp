#include "cpp_emit/code/fault_injection.hpp"

#include <fmt/format.h>

#include "cpp_emit/code/assignment.hpp"
#include "cpp_emit/expressions/expression.hpp"
#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit {

namespace {

/// The last field of a value takes the place of that in `variable`; the others stay as they were.
std::string last_field(const Generation& generation, const Unit& unit, ir::VariableId variable,
                       const std::string& value, const std::string& field) {
    const std::string place = ExpressionWriter(generation, unit).variable(variable);
    if (place.empty()) return {};
    return fmt::format("{{ auto partly = {}; partly.{} = {}.{}; {} }}", place, field, value, field,
                       store(generation, unit, variable, "partly"));
}

}  // namespace

const EventUse& heard(const Generation& generation, const EventUse& sender) {
    for (const Part& part : generation.component.parts) {
        for (const EventUse& use : part.events) {
            if (&use == &sender || use.channel.empty() || use.type != sender.type || use.channel == sender.channel)
                continue;
            return generation.mutation.hits(Fault::wrong_sender) ? use : sender;
        }
    }
    return sender;
}

std::string consume(const EventPort& port) {
    return fmt::format("inputs_.{}.present = false;", port.input);
}

std::string received(const Generation& generation, const Unit& unit, const ir::Communication& communication,
                     const std::string& value) {
    if (!communication.variable.valid()) return {};
    const ir::Type& type = generation.system.type(unit.machine->variables[communication.variable.index].type);
    const bool fields = type.kind == ir::TypeKind::record || type.kind == ir::TypeKind::product;
    if (fields && generation.mutation.hits(Fault::fields_lost))
        return last_field(generation, unit, communication.variable, value, members(type).back().name);
    return store(generation, unit, communication.variable, value);
}

std::string watch_from(const Generation& generation, const Unit& unit, const std::string& field,
                       const ir::Expr& bound) {
    return fmt::format("f.{} = duration({}) + 1;", field, ExpressionWriter(generation, unit).write(bound));
}

std::string bound_test(const Generation& generation) {
    return generation.mutation.seeded(Fault::loop_never_ends) ? "" : "!exhausted() && ";
}

}  // namespace robochart::cpp_emit
