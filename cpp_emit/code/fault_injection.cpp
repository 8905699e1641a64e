#include "cpp_emit/code/fault_injection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "cpp_emit/code/assignment.hpp"
#include "cpp_emit/expressions/expression.hpp"
#include "cpp_emit/plan/types.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::cpp_emit {

namespace {

/// The next one behind `own` that fits, in a circle; `own` if there is none or the fault is not here.
template <class Item, class Fits>
const Item& other(const Generation& generation, const std::vector<Item>& all, const Item& own, Fault fault,
                  const Fits& fits) {
    const auto place = static_cast<std::size_t>(&own - all.data());
    for (std::size_t step = 1; step < all.size(); ++step) {
        const Item& next = all[(place + step) % all.size()];
        if (fits(next)) return generation.mutation.hits(fault) ? next : own;
    }
    return own;
}

/// The last field of a value takes the place of that in `variable`; the others stay as they were.
std::string last_field(const Generation& generation, const Unit& unit, ir::VariableId variable,
                       const std::string& value, const std::string& field) {
    const std::string place = ExpressionWriter(generation, unit).variable(variable);
    if (place.empty()) return {};
    return fmt::format("{{ auto partly = {}; partly.{} = {}.{}; {} }}", place, field, value, field,
                       store(generation, unit, variable, "partly"));
}

}  // namespace

const EventPort& received_port(const Generation& generation, const EventPort& port) {
    return other(generation, generation.component.events, port, Fault::wrong_input,
                 [&](const EventPort& each) { return each.received && each.type == port.type; });
}

const EventPort& sent_port(const Generation& generation, const EventPort& port) {
    return other(generation, generation.component.events, port, Fault::wrong_output,
                 [&](const EventPort& each) { return each.sent && each.type == port.type; });
}

const PlatformCall& called(const Generation& generation, const PlatformCall& call) {
    return other(generation, generation.component.calls, call, Fault::wrong_output,
                 [&](const PlatformCall& each) { return each.signature->parameters == call.signature->parameters; });
}

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

std::string consume(const Generation& generation, const EventPort& port) {
    if (generation.mutation.hits(Fault::event_not_consumed)) return {};
    return fmt::format("inputs_.{}.present = false;", port.input);
}

std::string received(const Generation& generation, const Unit& unit, const ir::Communication& communication,
                     const std::string& value) {
    if (!communication.variable.valid() || generation.mutation.hits(Fault::value_not_stored)) return {};
    const ir::Type& type = generation.system.type(unit.machine->variables[communication.variable.index].type);
    const bool fields = type.kind == ir::TypeKind::record || type.kind == ir::TypeKind::product;
    if (fields && generation.mutation.hits(Fault::fields_lost))
        return last_field(generation, unit, communication.variable, value, members(type).back().name);
    return store(generation, unit, communication.variable, value);
}

std::string watch_from(const Generation& generation, const Unit& unit, const std::string& field, const ir::Expr& bound,
                       const void* part) {
    if (generation.mutation.hits(Fault::deadline_ignored, &unit, part)) return {};
    const int more = generation.mutation.hits(Fault::deadline_late, &unit, part)    ? 2
                     : generation.mutation.hits(Fault::deadline_early, &unit, part) ? 0
                                                                                    : 1;
    return fmt::format("f.{} = duration({}) + {};", field, ExpressionWriter(generation, unit).write(bound), more);
}

std::string bound_test(const Generation& generation) {
    return generation.mutation.seeded(Fault::loop_never_ends) ? "" : "!exhausted() && ";
}

ir::Value begins_with(const Generation& generation, const ir::Variable& variable, const ir::Value& initial) {
    const ir::Value value = ir::default_value(generation.system, generation.inst, variable.type);
    return value != initial && generation.mutation.hits(Fault::initial_lost) ? value : initial;
}

std::vector<std::size_t> order(const Generation& generation, std::size_t count, Fault reversed) {
    std::vector<std::size_t> places(count);
    std::iota(places.begin(), places.end(), std::size_t{0});
    if (count > 1 && generation.mutation.hits(reversed)) std::reverse(places.begin(), places.end());
    return places;
}

}  // namespace robochart::cpp_emit
