// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/code/reception.hpp"

#include <fmt/format.h>

#include "cpp_emit/code/assignment.hpp"
#include "cpp_emit/expressions/expression.hpp"
#include "cpp_emit/plan/types.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::cpp_emit {

namespace {

/// Returns the sender whose event the connection delivers. Fault::wrong_sender replaces it by another sender of the
/// same type.
const EventUse& choose_sender(const Generation& generation, const EventUse& sender) {
    for (const Part& part : generation.component.parts) {
        for (const EventUse& use : part.events) {
            if (&use == &sender || use.channel.empty() || use.type != sender.type || use.channel == sender.channel)
                continue;
            return generation.mutation.hits(Fault::wrong_sender) ? use : sender;
        }
    }
    return sender;
}

/// Assigns a value to the last field of `variable`. Its other fields do not change.
std::string last_field(const Generation& generation, const Unit& unit, ir::VariableId variable,
                       const std::string& value, const std::string& field) {
    const std::string place = ExpressionWriter(generation, unit).variable_member(variable);
    if (place.empty()) return {};
    return fmt::format("{{ auto partly = {}; partly.{} = {}.{}; {} }}", place, field, value, field,
                       store_statement(generation, unit, variable, "partly"));
}

class Reception {
public:
    Reception(const Generation& generation, const Unit& unit, const ir::Communication& communication, CodeWriter& out,
              const Condition& condition, const std::function<void()>& then)
        : generation_(generation),
          unit_(unit),
          communication_(communication),
          use_(generation.component.find_event(unit, communication.event)),
          out_(out),
          condition_(condition),
          then_(then) {}

    bool write() {
        for (const std::size_t port : use_.ports) from_port(generation_.component.events[port]);
        for (const std::size_t buffer : use_.emptied) from_buffer(generation_.component.buffers[buffer]);
        for (const Peer& peer : use_.peers) {
            const EventUse* const sender = generation_.component.find_event(peer);
            if (sender != nullptr && sender->sent) from_peer(*sender);
        }
        return use_.is_spontaneous() && take_spontaneous();
    }

private:
    [[nodiscard]] CppExpr full_condition(const std::string& incoming) const {
        const CppExpr free = may_write(generation_, unit_, communication_.variable);
        return conjunction(conjunction(free, value_predicate(generation_, unit_, communication_, incoming)),
                           condition_(incoming));
    }

    /// Returns a condition: the event is present, and its value satisfies the predicate.
    [[nodiscard]] std::string presence_condition(const std::string& there, const std::string& incoming) const {
        return conjunction(CppExpr(there), full_condition(incoming)).whole_text();
    }

    [[nodiscard]] std::string storing_code(const std::string& incoming) const {
        return store_received(generation_, unit_, communication_, incoming);
    }

    void write_taking(const std::string& consume, const std::string& stored) {
        if (!consume.empty()) out_.line(consume);
        if (!stored.empty()) out_.line(stored);
        then_();
    }

    void from_port(const EventPort& port) {
        const std::string input = "inputs_." + port.input;
        out_.open(fmt::format("if ({}) {{", presence_condition(input + ".present", input + ".get()")));
        write_taking(consume_statement(port), storing_code(input + ".get()"));
        out_.close();
    }

    /// Reads and empties the buffer (semantics 3.9).
    void from_buffer(const Buffer& buffer) {
        const std::string place = "state_." + buffer.field;
        out_.open(fmt::format("if ({}) {{", presence_condition(place + ".full()", place + ".value")));
        const std::string stored = storing_code("incoming");
        if (!stored.empty())
            out_.line(fmt::format("const {} incoming = {}.value;", cpp_type(generation_.system, *use_.type), place));
        write_taking(place + " = {};", stored);
        out_.close();
    }

    /// Receives by rendezvous. The sender waits at one of its sites; the receiver makes it continue.
    void from_peer(const EventUse& sender) {
        const std::string& channel = choose_sender(generation_, sender).channel;
        out_.open(fmt::format("for (std::uint32_t site = 0; site != sites_{}; ++site) {{", channel));
        if (use_.type) out_.line(fmt::format("{} incoming{{}};", cpp_type(generation_.system, *use_.type)));
        const CppExpr guard = full_condition("incoming");
        out_.line(fmt::format("if (!offers_{}(site{}){}) continue;", channel, use_.type ? ", incoming" : "",
                              guard.empty() ? "" : " || !(" + guard.whole_text() + ")"));
        write_taking(fmt::format("accept_{}(site);", channel), storing_code("incoming"));
        out_.close();
    }

    /// Takes an event that has no connection. Such an event happens as soon as it can, with an arbitrary value
    /// (semantics 3.9).
    bool take_spontaneous() {
        const CppExpr guard = full_condition("");
        const std::string value = use_.type ? default_text(generation_, *use_.type) : "";
        out_.write_if(guard, [&] { write_taking("", storing_code(value)); });
        return guard.empty();
    }

    const Generation& generation_;
    const Unit& unit_;
    const ir::Communication& communication_;
    const EventUse& use_;
    CodeWriter& out_;
    const Condition& condition_;
    const std::function<void()>& then_;
};

}  // namespace

std::string consume_statement(const EventPort& port) {
    return fmt::format("inputs_.{}.present = false;", port.input);
}

std::string store_received(const Generation& generation, const Unit& unit, const ir::Communication& communication,
                           const std::string& value) {
    if (!communication.variable.is_valid()) return {};
    const ir::Type& type = generation.system.type(unit.machine->variables[communication.variable.index].type);
    const bool fields = type.kind == ir::TypeKind::record || type.kind == ir::TypeKind::product;
    const std::string stored = as_variable(generation, unit, communication, value);
    if (fields && generation.mutation.hits(Fault::fields_lost))
        return last_field(generation, unit, communication.variable, stored, type_members(type).back().name);
    return store_statement(generation, unit, communication.variable, stored);
}

std::string as_variable(const Generation& generation, const Unit& unit, const ir::Communication& communication,
                        const std::string& value) {
    const std::optional<ir::TypeId> carried = unit.machine->events[communication.event.index].type;
    if (value.empty() || !carried || !communication.variable.is_valid()) return value;
    const ir::TypeId variable_type = unit.machine->variables[communication.variable.index].type;
    const std::string type = cpp_type(generation.system, variable_type);
    if (type == cpp_type(generation.system, *carried)) return value;
    if (is_numeric(generation.system.type(variable_type).kind)) return fmt::format("{}({})", type, value);
    const std::string converted = fmt::format("robochart::convert<{}>({})", type, value);
    return has_lists(generation.system, variable_type) ? fmt::format("fit<Types>({})", converted) : converted;
}

std::string default_text(const Generation& generation, ir::TypeId type) {
    return cpp_value(generation.system, generation.inst, type,
                     ir::default_value(generation.system, generation.inst, type));
}

bool write_reception(const Generation& generation, const Unit& unit, const ir::Communication& communication,
                     CodeWriter& out, const Condition& condition, const std::function<void()>& then) {
    return Reception(generation, unit, communication, out, condition, then).write();
}

CppExpr value_predicate(const Generation& generation, const Unit& unit, const ir::Communication& communication,
                        const std::string& incoming) {
    if (!communication.predicate) return {};
    ExpressionWriter expressions(generation, unit);
    expressions.set_incoming(as_variable(generation, unit, communication, incoming));
    return expressions.expression_asked(*communication.predicate).in_parentheses();
}

bool from_register(const EventUse& use) {
    return use.ports.size() == 1 && use.peers.empty() && use.emptied.empty();
}

}  // namespace robochart::cpp_emit
